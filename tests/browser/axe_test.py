#!/usr/bin/env python3
"""Reads pages with axe-core, the accessibility checker, in headless Chromium: nothing may be found.

    axe_test.py [--axe axe.min.js] [--made FOLDER] [PAGE.html or FOLDER ...]

Every PAGE is read at 1280 x 720 and at 360 x 740, light and dark, folded in every other of these ways and unfolded in the
rest, with every dialog open in turn; of a gallery's hundreds of cards one of each kind but in the first of these ways; a
topic's page, which is one among many of its kind, in one of these ways. Players are all one page: of each topic one is read,
in one way, at three of its steps, and their dialogs are read in the first ways alone. The first of the pages of FOLDER,
which make_pages wrote, is read in every theme. GRADUS_STRESS reads everything in all ways.
axe-core comes from the npm registry (get_axe_core.py in this folder): `--axe` or the environment's GRADUS_AXE says where
its axe.min.js is. Of players and topics' pages an ordinary run reads a share (support/share.py). Prints `N passed, N failed`,
exits 1 when something was found, and without Chromium or axe-core 77, or 1 where CI is set.
"""

import argparse
import os
import pathlib
import shutil
import sys

from player_page import one_a_topic
from webdriver import EVERYTHING, Browser, WebDriverError

THEMES = ('light', 'dark', 'greyscale', 'high_contrast')
SIZES = ((1280, 720), (360, 740))
WAYS = ((SIZES[0], 'light'), (SIZES[1], 'dark'), (SIZES[1], 'light'), (SIZES[0], 'dark'))
FOLDED = (True, False, False, True)  # in these ways: both in every size and scheme

# All of axe-core's rules, its best practices too, and the least size of a target that WCAG 2.2 asks for.
READ = '''return axe.run(arguments[0] || document, {resultTypes: ['violations'], rules: {'target-size': {enabled: true}}}).then(
    (found) => found.violations.flatMap((rule) => rule.nodes.map((node) =>
      `${rule.id}: ${node.target.join(' ')}: ${node.failureSummary.replace(/\\s+/g, ' ')}`)))'''

# Leaves one card of each kind, which is told by its elements and their classes.
THIN = '''const kinds = new Set();
          for (const card of [...document.querySelectorAll('.card')]) {
            const kind = [card, ...card.querySelectorAll('*')].map((node) => `${node.localName}.${node.getAttribute('class')}`).join(' ');
            if (kinds.has(kind)) card.remove();
            kinds.add(kind);
          }
          return kinds.size'''

DIALOGS = 'return [...document.querySelectorAll("dialog")].map((d) => d.dataset.part || d.id)'
OPEN = '''const dialog = document.querySelectorAll("dialog")[arguments[0]];
          const player = dialog.closest(".gradus") || document;  // of two runs beside each other each has its own
          const button = player.querySelector(`[data-do="${dialog.dataset.part}"]`);
          if (button) button.click(); else dialog.showModal();
          return dialog.open'''
CLOSE = 'document.querySelectorAll("dialog")[arguments[0]].close()'


class Reader:
    def __init__(self, browser, axe):
        self.browser, self.axe = browser, axe
        self.passed, self.failed = 0, []
        self.players = self.topics = 0  # pages of that kind read so far

    def open(self, path, size, fragment='', scheme='light'):
        self.browser.size(*size)
        self.browser.cdp('Emulation.setEmulatedMedia', features=[{'name': 'prefers-color-scheme', 'value': scheme},
                                                                 {'name': 'prefers-reduced-motion', 'value': 'reduce'}])
        self.browser.open('about:blank')
        self.browser.open(path.resolve().as_uri() + fragment)
        self.browser.run(self.axe)
        self.where = f'{path.name}{fragment} {scheme} {size[0]}x{size[1]}'

    def read(self, state, part=None):
        """The page, or the part of it with this selector."""
        found = self.browser.run(READ, part)
        if not found:
            self.passed += 1
            return
        self.failed.append(f'{self.where}, {state}:\n    ' + '\n    '.join(found))
        print(f'FAILED {self.failed[-1]}', flush=True)

    def read_dialogs(self):
        for number, name in enumerate(self.browser.run(DIALOGS)):
            if not self.browser.run(OPEN, number):
                self.failed.append(f'{self.where}: the dialog {name} does not open')
            self.read(f'dialog {name}', 'dialog[open]')
            self.browser.run(CLOSE, number)

    def read_page(self, path):
        is_player = 'id="gradus-page"' in path.read_text(encoding='utf-8')
        dialogs = EVERYTHING or not is_player or self.players < len(WAYS)
        ways = self.ways_of(path, is_player)
        # For pages of one kind, each way comes again after four, then folded the other way
        read = self.players if is_player else self.topics
        for (size, scheme), folded in zip(ways, FOLDED if len(ways) > 1 else [(read - 1) // len(WAYS) % 2 == 0]):
            self.open(path, size, '', scheme)
            if (size, scheme) != ways[0] and not EVERYTHING:
                self.browser.run(THIN)
            self.read_all(is_player, dialogs, folded=folded or EVERYTHING, unfolded=not folded or EVERYTHING)

    def ways_of(self, path, is_player):
        """Pages of a kind are read in different ways, one after the other."""
        if EVERYTHING:
            return WAYS
        if is_player:
            self.players += 1
            return [WAYS[(self.players - 1) % len(WAYS)]]
        if 'topics' in path.parts or path.name == 'errata.html':
            self.topics += 1
            return [WAYS[(self.topics - 1) % len(WAYS)]]
        return WAYS

    def read_themes(self, path, fragment, themes):
        for size in SIZES if EVERYTHING or path.name == 'line.html' else SIZES[len(path.name) % 2:][:1]:
            for theme in themes:
                self.open(path, size, f'{fragment}{"&" if fragment else "#"}theme={theme}')
                self.read_all(True, dialogs=EVERYTHING or path.name == 'line.html')

    def read_all(self, is_player, dialogs=True, folded=True, unfolded=True):
        folds = self.browser.run('return document.querySelectorAll("details").length')
        if folded or not folds:
            self.read('first look')
        if unfolded and folds:
            self.browser.run('for (const folded of document.querySelectorAll("details")) folded.open = true')
            self.read('unfolded')
        if dialogs:
            self.read_dialogs()
        if is_player:
            self.browser.run('player.show(Math.floor(player.run.steps.length / 2))')
            self.read('in the middle')
            self.browser.run('player.last()')
            self.read('at the end')


def missing(what):
    print(f'no {what}', file=sys.stderr)
    return 1 if os.environ.get('CI') else 77


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('--axe', type=pathlib.Path, default=os.environ.get('GRADUS_AXE'), help='axe.min.js')
    parser.add_argument('--made', type=pathlib.Path, help='folder that make_pages has filled')
    parser.add_argument('pages', nargs='*', type=pathlib.Path, help='pages, or folders with all pages below them')
    arguments = parser.parse_args()
    if not shutil.which('chromium') or not shutil.which('chromedriver'):
        return missing('chromium or chromedriver (Debian: chromium chromium-driver)')
    if not arguments.axe or not arguments.axe.is_file():
        return missing('axe-core (tests/browser/get_axe_core.py gets it)')
    made = [('line', '#step=0&loop=2-5&marks=1,4'), ('german', ''), ('topic', ''), ('hostile', ''), ('huge', ''),
            ('without_drawing', ''), ('without_title', ''), ('only_sentence', '')]
    with Browser() as browser:
        reader = Reader(browser, arguments.axe.read_text(encoding='utf-8'))
        # A check that can't fail is none
        browser.open('data:text/html,<html><title>t</title><img src="x.png"><p style="color:silver">faint')
        browser.run(reader.axe)
        found = ' '.join(browser.run(READ))
        for rule in ('image-alt', 'color-contrast', 'html-has-lang'):
            if rule not in found:
                reader.failed.append(f'axe-core does not find {rule} in a page that has it')
        for name, fragment in made if arguments.made else []:
            themes = THEMES if EVERYTHING or name == 'line' else THEMES[:1]
            try:
                reader.read_themes(arguments.made / f'{name}.html', fragment, themes)
            except WebDriverError as error:
                reader.failed.append(f'{name}: {error}')
        listed = [sorted(page.rglob('*.html')) if page.is_dir() else [page] for page in arguments.pages]
        for page in one_a_topic(sum(listed, [])):
            try:
                reader.read_page(page)
            except WebDriverError as error:
                reader.failed.append(f'{page}: {error}')
    print(f'{reader.passed} passed, {len(reader.failed)} failed')
    for failure in reader.failed:
        print(f'  {failure}')
    return 1 if reader.failed or not reader.passed else 0


if __name__ == '__main__':
    sys.exit(main())
