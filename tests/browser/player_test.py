#!/usr/bin/env python3
"""Drives player pages in headless Chromium, from file://.

    player_test.py [--made FOLDER] [PAGE.html ...]

Every PAGE gets the checks that hold for any player page. FOLDER holds what make_pages wrote: pages made up to reach
the player's corners. Prints `N passed, N failed`, exits 1 when a check failed, 77 when there is no Chromium.
"""

import argparse
import json
import os
import pathlib
import random
import re
import shutil
import sys
import time

from webdriver import Browser, WebDriverError

SEED = 20261121
EVERYTHING = bool(os.environ.get('GRADUS_STRESS'))
MADE = ('line', 'fine', 'long', 'many', 'huge', 'hostile', 'late')
ROOT = pathlib.Path(__file__).resolve().parents[2]

STATE = '''const everything = () => JSON.stringify([player.state(), player.parts.drawing.querySelector('svg').innerHTML,
               player.parts.rows.innerText, player.parts.table.scrollTop, player.parts.lines.scrollTop]);
           const go = (number) => { if (!player.goTo(number)) throw new Error("no step " + number); };'''

# A walk: what each step that was reached looked like when it was last seen.
WALK = STATE + '''const seen = {}, look = () => { seen[player.run.steps[player.index].number] = everything(); };
           player.first();
           for (const [move, number] of arguments[0]) { if (move === "jump") go(number); else player[move](); look(); }
           player.last(); player.first(); look();
           return seen;'''

# The steps that look otherwise in a new player, which knows nothing of the steps before, with where they differ.
FRESH = STATE + '''const [numbers, seen] = arguments, wrong = [];
           const data = JSON.parse(document.getElementById("gradus-page").textContent);
           for (const number of numbers) {
             player.load(data.trace, {command: data.command});
             go(number);
             const found = everything(), walked = seen[number];
             let at = 0;
             while (at < found.length && found[at] === walked[at]) ++at;
             if (found !== walked) wrong.push([number, ...[found, walked].map((s) => s.slice(Math.max(at - 40, 0), at + 60))]);
           }
           return wrong;'''


# Whether the page fits into the window, across and down.
FITS_NOW = '''(() => { const d = document.documentElement;
                      return [d.scrollWidth <= d.clientWidth, d.scrollHeight <= d.clientHeight]; })()'''
FITS = f'return {FITS_NOW}'


class Checks:
    def __init__(self):
        self.passed, self.failed = 0, []

    def that(self, what, good, found=''):
        if good:
            self.passed += 1
            return
        self.failed.append(f'{what}{f": {found}" if found != "" else ""}')
        print(f'FAILED {self.failed[-1]}', flush=True)

    def equal(self, what, found, expected):
        self.that(what, found == expected, f'found {found!r}, expected {expected!r}')


class Page:
    """One page open in the browser."""

    def __init__(self, browser, path, fragment='', size=(1280, 720)):
        self.browser, self.path = browser, path
        browser.size(*size)
        browser.open('about:blank')
        browser.log('browser'), browser.log('performance')
        browser.open(path.resolve().as_uri() + fragment)

    def __getattr__(self, name):
        return getattr(self.browser, name)

    def state(self):
        return self.run('return player.state()')

    def everything(self):
        return self.run(f'{STATE} return everything();')

    @property
    def step(self):
        return self.run('return player.run.steps[player.index].number')

    def go(self, number):
        self.run('if (!player.goTo(arguments[0])) throw new Error("no step " + arguments[0])', number)

    def wait_for(self, script, seconds=10):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.run(f'return {script}'):
                return True
            time.sleep(0.05)
        return False


def no_noise(check, page, name, allowed=()):
    """No message on the console, nothing asked of the network."""
    errors = [entry['message'] for entry in page.log('browser')]
    check.equal(f'{name}: nothing on the console', errors, [])
    asked = []
    for entry in page.log('performance'):
        message = json.loads(entry['message'])['message']
        if message['method'] == 'Network.requestWillBeSent':
            asked.append(message['params']['request']['url'])
    outside = [url for url in asked if not url.startswith(('file:', 'data:', 'about:', 'chrome:'))]
    check.equal(f'{name}: nothing asked of the network', outside, [])
    files = [url.split('#')[0] for url in asked if url.startswith('file:')]
    check.that(f'{name}: only the page itself is read', all(f == page.path.resolve().as_uri() for f in files), files)


def any_page(check, browser, path):
    """What holds for every player page."""
    name = path.name
    page = Page(browser, path)
    milestones = page.run('return player.run.milestones.map((i) => player.run.steps[i].number)')
    opened = page.run('return performance.getEntriesByName("gradus: open")[0].duration')
    print(f'{name}: {page.run("return player.run.steps.length")} steps open in {opened:.0f} ms', flush=True)
    many = page.run('return player.run.steps.length') / 10_000
    check.that(f'{name}: 10,000 steps open in less than a second', opened < 1000 * max(many, 1), opened)
    check.equal(f'{name}: opens at its first step', page.step, milestones[0])
    check.equal(f'{name}: opens paused', page.run('return player.playing'), False)
    check.that(f'{name}: the first step says something', page.run('return player.state().sentence') != '')
    if len(milestones) > 1:
        page.press('ArrowRight')
        check.equal(f'{name}: → steps', page.step, milestones[1])
        page.press('ArrowLeft')
        check.equal(f'{name}: ← steps back', page.step, milestones[0])
    page.press('End')
    check.equal(f'{name}: End', page.step, page.run('return player.run.steps.at(-1).number'))
    page.press('ArrowRight', '.')
    check.that(f'{name}: nothing comes after it', page.run('return player.atEnd'))
    page.press('Home')
    check.equal(f'{name}: Home', page.step, milestones[0])
    check.equal(f'{name}: the drawing has a name, and the sentence as its description', page.run('''
        const {svg} = player.drawing, about = document.getElementById(svg.getAttribute("aria-describedby"));
        return [svg.getAttribute("aria-label").includes(player.name), about === player.parts.said]'''), [True, True])
    for width, height in ((1280, 720), (1920, 1080)):
        page.size(width, height)
        check.that(f'{name}: no scroll bars at {width} x {height}', page.wait_for(f'({FITS_NOW}).every(Boolean)', 2))
    page.size(1280, 720)
    # The player hears of its new size in a frame to come
    page.run('return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))')
    no_noise(check, page, name)
    same_however_reached(check, page, name)
    narrow(check, browser, path)


def in_its_letters(page):
    """Waits for the page's own fonts: what is measured before has other letters."""
    page.wait_for('document.fonts.status === "loaded"')


def same_however_reached(check, page, name):
    """State after any walk == state of a fresh player that jumped there."""
    rng = random.Random(SEED)
    in_its_letters(page)
    numbers = page.run('return player.run.steps.map((s) => s.number)')
    moves = ['next', 'previous', 'nextEvent', 'previousEvent', 'next', 'jump']
    # Long walks where the page was made to reach the player's corners, shorter ones on the gallery's
    length = 60 if EVERYTHING or page.path.stem in MADE else 10
    seen = page.run(WALK, [(rng.choice(moves), rng.choice(numbers)) for _ in range(length)])
    check.that(f'{name}: a walk reaches its first step again', numbers[0] in seen)
    fresh = Page(page.browser, page.path)
    in_its_letters(fresh)
    wrong = fresh.run(FRESH, sorted(seen, key=lambda n: rng.random()), seen)
    check.equal(f'{name}: {len(seen)} steps look the same however reached (seed {SEED})', wrong, [])


# What reaches beyond the window's side, unless something round it scrolls.
STICKS_OUT = '''return [...player.root.querySelectorAll("*")].filter((node) =>
    node.checkVisibility() && !node.closest(".listing ol, .table, dialog, .unseen, svg svg *, svg") &&
    (node.getBoundingClientRect().right > innerWidth + 0.5 || node.getBoundingClientRect().left < -0.5))
    .map((node) => node.outerHTML.slice(0, 80))'''

# Controls of less than 24 x 24 CSS pixels.
SMALL = '''return [...player.root.querySelectorAll("button, input, a")].filter((node) => node.checkVisibility())
    .map((node) => [node.outerHTML.slice(0, 80), node.getBoundingClientRect()])
    .filter(([, box]) => box.width < 24 || box.height < 24).map(([text, box]) => [text, box.width, box.height])'''


def narrow(check, browser, path):
    name = f'{path.name} at 360 px'
    page = Page(browser, path, size=(360, 740))
    widths = '''const d = document.documentElement; return [d.scrollWidth, d.clientWidth];'''
    for where in ('first', 'last'):
        page.run(f'player.{where}()')
        across, room = page.run(widths)
        check.that(f'{name}: the page does not scroll sideways ({where} step)', across <= room, (across, room))
    check.equal(f'{name}: nothing sticks out', page.run(STICKS_OUT), [])
    check.equal(f'{name}: a finger hits every control', page.run(SMALL), [])
    for button in ('previous', 'play', 'next'):
        box = page.run('''const b = player.root.querySelector(`[data-do="${arguments[0]}"]`).getBoundingClientRect();
                          return [b.left, b.right, b.top, b.bottom, b.width, b.height];''', button)
        check.that(f'{name}: {button} can be seen and hit',
                   box[0] >= 0 and box[1] <= 360 and box[2] >= 0 and box[3] <= 740 and min(box[4:]) >= 24, box)


def keyboard_and_mouse(check, browser, made):
    page = Page(browser, made / 'line.html')
    check.equal('the goal stands at step 0', 'Choose, column by column' in page.state()['sentence'], True)
    check.equal('the footer counts', page.state()['position'], 'step 0 / 7 · set up')
    for _ in range(3):
        page.press('ArrowRight')
    state = page.state()
    check.equal('three times →', state['step'], '3')
    check.equal('the table grew a row a step', len(state['table']), 4)
    check.equal('the row that was read is weak', state['table'][2]['emphasis'], 'weak')
    check.equal('the row that was made is strong', state['table'][3]['emphasis'], 'strong')
    check.equal('the test completed the row', state['table'][2]['cells'], ['2', '2', '1', '-3', 'p < 0', 'E'])
    check.equal('what changed is marked', state['table'][3]['changed'], [False, True, False, True, False, False])
    check.that('… not by colour alone', page.run('''return getComputedStyle(
        player.parts.rows.querySelector(".strong .changed span")).borderBottomStyle''') == 'solid')
    lines = dict(state['listing'])
    check.equal('lines: current and previous', [n for n in lines if lines[n] != 'none'], [43, 47])
    check.equal('the current line', lines[43], 'strong')
    check.equal('the current cell', [c for c in state['cells'] if c[2] == 'current'], [[3, 1, 'current', '']])
    check.equal('the legend has the roles of this step', state['legend'], ['past', 'current', 'rejected', 'measure'])
    page.press('End')
    check.equal('at the end the legend is shorter', page.state()['legend'], ['past', 'current'])
    page.press('ArrowRight')
    check.equal('→ at the end stays', page.step, '7')

    page.press('g')
    page.press('2', 'Enter')
    check.equal('G 2 Enter', page.step, '2')
    page.press('g')
    page.press('9', '9')
    page.press('ArrowLeft')
    check.equal('arrows in the field do not step', page.step, '2')
    page.press('Enter')
    check.equal('a step that is not there', [page.step, 'no step 99' in page.run('return player.parts.notice.textContent')],
                ['2', True])
    page.press('Escape')

    page.run('''const s = player.parts.slider; s.value = 5; s.dispatchEvent(new Event("input"));''')
    check.equal('the slider', page.step, '5')
    check.equal('the slider says its step', page.run('return player.parts.slider.getAttribute("aria-valuetext")'),
                'step 5 / 7 · main loop')
    page.run('player.parts.slider.focus()')
    page.press('ArrowLeft')
    check.equal('← on the slider is one step', page.step, '4')
    page.run('document.activeElement.blur()')

    for selector, expected, what in (('[data-do="next"]', '5', 'next'), ('[data-do="previous"]', '4', 'previous'),
                                     ('[data-do="last"]', '7', 'last'), ('[data-do="first"]', '0', 'first')):
        page.click_on(f'#player {selector}')
        check.equal(f'the button {what}', page.step, expected)

    page.go('6')
    page.click_on('#player tr[data-row="4"]')
    check.equal('a row leads to the step that made it', page.step, '4')
    page.go('7')
    cell = page.run('''const a = player.drawing.at, box = player.parts.drawing.getBoundingClientRect();
        const rows = arguments[1] - a.view.y0 + 0.5;
        return [box.left + a.box.x + (arguments[0] - a.view.x0 + 0.2) * a.cell,
                box.top + a.box.y + a.box.height - rows * a.cell];''', 2, 1)
    page.click(*cell)
    check.equal('a cell leads to the step that made it', page.step, '2')
    page.go('5')
    page.click_on('#player [data-mark="chosen"]')
    check.equal('a mark leads to the step that set it', page.step, '5')
    page.go('1')
    page.click_on('#player li[data-position="8"]')  # line 47: step NE
    check.equal('a line leads to its next execution', page.step, '2')
    page.click_on('#player li[data-position="8"]')
    check.equal('… and on', page.step, '4')
    page.go('7')
    page.click_on('#player li[data-position="8"]')
    check.equal('… and round', page.step, '2')

    page.go('3')
    page.run('player.parts.rows.querySelector("tr.strong").focus()')
    page.press('ArrowUp', 'Enter')
    check.equal('a row by keyboard', page.step, '2')
    page.run('player.parts.lines.querySelector("[tabindex=\'0\']").focus()')
    page.press('ArrowDown')
    check.that('the lines by keyboard', page.run('return document.activeElement.closest("[data-position]") !== null'))
    page.run('document.activeElement.blur()')

    before = page.everything()
    page.press('?')
    check.equal('? shows the keys', page.run('return player.parts.keys.open'), True)
    check.equal('… from the first on', page.run('return player.parts.keys.scrollTop'), 0)
    page.press('ArrowRight')
    check.equal('no steps behind the keys', page.step, '2')
    page.press('Escape')
    check.equal('Escape closes them', page.run('return player.parts.keys.open'), False)
    page.click_on('#player [data-do="copying"]')
    check.equal('the command', page.run('return player.parts["command-text"].innerText'),
                'gradus figure bresenham_line --from 0,0 --to 7,3')
    page.press('Escape')
    themes = []
    for _ in range(4):
        page.press('t')
        themes.append(page.run('return [player.root.dataset.theme, getComputedStyle(player.root).backgroundColor]'))
    check.equal('T goes round the themes', [t[0] for t in themes], ['dark', 'greyscale', 'high_contrast', 'light'])
    check.that('dark is dark', themes[0][1] != themes[3][1], themes)
    check.equal('after all themes it looks as before', page.everything(), before)

    page.press('f')
    full = page.wait_for('document.fullscreenElement !== null', 3)
    check.that('F: full screen', full)
    if full:
        page.press('PageDown')
        check.equal('PageDown steps in full screen', page.step, '3')
        page.press('PageUp')
        check.equal('PageUp steps back there', page.step, '2')
        page.press('f')
        page.wait_for('document.fullscreenElement === null', 3)
    page.press('PageDown')
    check.equal('PageDown is not ours elsewhere', page.step, '2')
    no_noise(check, page, 'line.html by hand')


def playing(check, browser, made):
    page = Page(browser, made / 'line.html')
    speed = page.run('return player.parts.speed.textContent')
    page.press('+', '+', '+', '+', '+')
    check.equal('+ is faster', [speed, page.run('return player.parts.speed.textContent')], ['1/s', '32/s'])
    page.press('-')
    check.equal('- is slower', page.run('return player.parts.speed.textContent'), '16/s')
    page.press('Space')
    check.equal('space plays', page.run('return player.playing'), True)
    check.that('play stops at the end', page.wait_for('!player.playing'))
    check.equal('… which is the last step', page.step, '7')
    page.run('player.changeSpeed(-9)')
    page.press('Space')
    check.equal('playing again starts anew', [page.step, page.run('return player.playing')], ['0', True])
    page.press('Space')
    check.equal('space pauses', page.run('return player.playing'), False)


def fine_steps(check, browser, made):
    page = Page(browser, made / 'fine.html')
    seen = []
    for key in ('ArrowRight', '.', '.', '.', ',', 'ArrowRight', 'ArrowLeft', '.', 'ArrowLeft', ',', 'ArrowLeft'):
        page.press(key)
        seen.append(page.step)
    check.equal('milestones and finer events', seen, ['1', '1.1', '1.2', '2', '1.2', '2', '1', '1.1', '1', '0', '0'])
    page = Page(browser, made / 'fine.html', '#step=3.2')
    check.equal('#step=3.2', page.step, '3.2')
    check.equal('a finer event adds no row', [r['emphasis'] for r in page.state()['table']], ['none'] * 4)


def address(check, browser, made):
    page = Page(browser, made / 'line.html', '#step=5')
    check.equal('#step=5', page.step, '5')
    check.equal('… is paused', page.run('return player.playing'), False)
    page.press('ArrowRight')
    check.that('the address follows', page.wait_for('location.hash === "#step=6"', 3))
    page.run('location.hash = "#step=2"')
    check.that('the player follows', page.wait_for('player.state().step === "2"', 3))
    page.run('location.hash = "#step=77"')
    check.that('an unknown step is said', page.wait_for('player.parts.notice.textContent.includes("77")', 3))
    check.equal('… and the player stays', page.step, '2')
    page = Page(browser, made / 'line.html', '#embed&step=3', (640, 400))
    seen = page.run('''return [".title", ".speed", ".go", ".drawing", ".listing", ".table", ".sentence", ".transport"]
                           .map((s) => player.root.querySelector(s).checkVisibility())''')
    check.equal('#embed hides the chrome, nothing else', seen, [False] * 3 + [True] * 5)
    check.equal('#embed: all of it fits into the frame', page.run(FITS), [True, True])
    check.equal('#embed keeps the step', page.step, '3')
    page.press('ArrowRight')
    check.that('#embed stays in the address', page.wait_for('location.hash === "#embed&step=4"', 3))


def looping(check, browser, made):
    page = Page(browser, made / 'line.html')
    page.go('2')
    page.press('[')
    check.equal('[ starts a loop that runs to the end', page.state()['loop'], ['2', '7'])
    page.go('5')
    page.press(']')
    check.equal('] ends it', page.state()['loop'], ['2', '5'])
    check.equal('… which is said', page.run('return player.parts.notice.textContent'), 'loop: steps 2 to 5')
    check.that('… and stands in the address', page.wait_for('location.hash === "#step=5&loop=2-5"', 3))
    band = page.run("""const box = (part) => player.parts[part].getBoundingClientRect(), slider = box("slider");
        const at = (index) => slider.left + 9 + (slider.width - 18) * index / 7, band = box("band");
        return [band.left + 1.5 - at(2), band.right - 1.5 - at(5)].map(Math.abs)""")
    check.that('… and is shown on the slider', max(band) < 2, band)
    page.run('player.setSpeed(7); window.seen = []; const show = player.show; player.show = function (index) {'
             'show.call(this, index); window.seen.push(this.run.steps[this.index].number); }')
    page.go('0')
    page.press('Space')
    page.wait_for('seen.length > 12')
    check.that('a loop is played until it is stopped', page.run('return player.playing'))
    page.press('Space')
    check.equal('… round and round', page.run('return seen.slice(1, 11)'), list('2345234523'))
    page.run('seen = []')
    page.go('7')
    page.press('v')
    page.wait_for('seen.length > 8')
    page.press('Space')
    check.equal('… backwards too', page.run('return seen.slice(1, 8)'), list('5432543'))
    page.press('l')
    check.equal('L leaves the loop', page.state()['loop'], None)
    check.that('… the address too', page.wait_for('!location.hash.includes("loop")', 3))
    check.equal('… its ends stay in sight', page.run('return player.parts.band.checkVisibility()'), True)
    page.press('l')
    check.equal('L takes it up again', page.state()['loop'], ['2', '5'])
    check.equal('the button says so', page.run('return player.parts.loop.getAttribute("aria-pressed")'), 'true')
    page.go('6')
    page.press('[')
    check.equal('a start behind the end lets it run to the end', page.state()['loop'], ['6', '7'])
    page.go('7')
    page.press('[')
    check.equal('a loop of one step is none', [page.state()['loop'], page.run('return player.parts.notice.textContent')],
                [['6', '7'], 'a loop needs two steps: mark its other end first'])
    page.run('player.setLoop()')
    page.press('l')
    check.equal('L without marks repeats all', page.state()['loop'], ['0', '7'])
    for selector, expected in (('loop_from', ['3', '7']), ('loop_to', ['0', '3']), ('loop', None)):
        page.run('player.setLoop(); player.goTo("3")')
        if selector == 'loop':
            page.run('player.setLoop({first: 1, last: 2, on: true})')
        page.click_on(f'#player [data-do="{selector}"]')
        check.equal(f'the button {selector}', page.state()['loop'], expected)
    page.run('player.setLoop({first: 2, last: 4, on: true})')
    page.go('6')
    # The first step shown after the key: by the time of a look at it the player may have gone on
    page.run('window.shown = []; const show = player.show; player.show = function (index) {'
             'show.call(this, index); window.shown.push(this.run.steps[this.index].number); }')
    page.press('r')
    check.equal('R plays from the start of the loop', page.run('return [window.shown[0], player.playing]'), ['2', True])
    fine = Page(browser, made / 'fine.html', '#loop=2-2.2&speed=32')
    fine.run('window.seen = []; const show = player.show; player.show = function (index) {'
             'show.call(this, index); window.seen.push(this.run.steps[this.index].number); }; player.play()')
    fine.wait_for('seen.length > 7')
    fine.run('player.pause()')
    check.equal('finer events are looped through too', fine.run('return seen.slice(0, 7)'),
                ['2', '2.1', '2.2', '2', '2.1', '2.2', '2'])


def backwards(check, browser, made):
    page = Page(browser, made / 'line.html', '#step=7&speed=8')
    page.run('window.delays = []; const wait = setTimeout; window.setTimeout = (does, after) => {'
             'if (String(does).includes("tick")) delays.push(after); return wait(does, after); }')
    pressed = 'return [player.parts.backwards, player.parts.fast_backwards].map((b) => b.getAttribute("aria-pressed"))'
    page.press('v')
    check.equal('V plays backwards', [page.state()['pace'], page.run('return delays')], [-1, [125]])
    check.equal('… as its button says', page.run(pressed), ['true', 'false'])
    page.press('v')
    check.equal('V again: fast', [page.state()['pace'], page.run('return delays.at(-1)')], [-4, 31.25])
    check.equal('… as its button says', page.run(pressed), ['false', 'true'])
    check.that('it stops at step 0', page.wait_for('!player.playing'))
    check.equal('… there', page.step, '0')
    check.equal('… and the buttons are up', page.run(pressed), ['false', 'false'])
    page.press('v')
    check.equal('from step 0 it starts at the end', [page.step, page.state()['pace']], ['7', -1])
    page.press('Space')
    check.equal('space pauses', page.run('return player.playing'), False)
    page.run('player.setSpeed(0); player.last()')
    page.press('Shift+v')
    check.equal('shift V is fast at once', page.state()['pace'], -4)
    page.press('v')
    check.equal('V then is the usual pace', page.state()['pace'], -1)
    page.press('ArrowLeft')
    check.equal('a step by hand ends it', page.run('return player.playing'), False)
    for name, pace in (('backwards', -1), ('fast_backwards', -4)):
        page.run('player.last()')
        page.click_on(f'#player [data-do="{name}"]')
        check.equal(f'the button {name}', page.state()['pace'], pace)
        page.click_on(f'#player [data-do="{name}"]')
        check.equal(f'the button {name} again pauses', page.state()['pace'], 0)
    page.press('+')
    check.that('the speed stands in the address', page.wait_for('location.hash.includes("speed=0.5")', 3))


def bookmarks(check, browser, made):
    page = Page(browser, made / 'line.html')
    notice = 'return player.parts.notice.textContent'
    page.run('player.nextBookmark()')
    check.equal('no bookmark yet', page.run(notice), 'there is no bookmark; B sets one')
    for number in ('5', '1', '3'):
        page.go(number)
        page.press('b')
    check.equal('B sets bookmarks', page.state()['bookmarks'], ['1', '3', '5'])
    check.equal('… says it', page.run(notice), 'bookmark at step 3')
    check.equal('… presses the button', page.run('return player.parts.bookmark.getAttribute("aria-pressed")'), 'true')
    check.that('… notes it in the address', page.wait_for('location.hash === "#step=3&marks=1,3,5"', 3))
    seen = []
    for _ in range(3):
        page.press('Shift+b')
        seen.append(page.step)
    check.equal('shift B goes round them', seen, ['5', '1', '3'])
    page.click_on('#player [data-do="next_bookmark"]')
    check.equal('so does the button', page.step, '5')
    apart = page.run("""const slider = player.parts.slider.getBoundingClientRect();
        return [...player.parts.flags.children].map((flag, i) =>
            Math.abs(flag.getBoundingClientRect().left - slider.left - 9 - (slider.width - 18) * [1, 3, 5][i] / 7))""")
    check.that('flags stand over their steps', len(apart) == 3 and max(apart) < 1, apart)
    page.click_on('#player [data-flag]')
    check.equal('a flag leads to its step', page.step, '1')
    page.press('b')
    check.equal('B removes one', page.state()['bookmarks'], ['3', '5'])
    page.click_on('#player [data-do="bookmark"]')
    check.equal('the button sets one', page.state()['bookmarks'], ['1', '3', '5'])


# Stand-ins for the clipboard: all of it, only the old way, none at all.
FULL_CLIPBOARD = """const texts = (item) => Promise.all(item.types.map(async (t) => [t, await (await item.getType(t)).text()]));
    Object.defineProperty(navigator, "clipboard", {value: {
      writeText: async (text) => { window.written = {"text/plain": text}; },
      write: async ([item]) => { window.written = Object.fromEntries(await texts(item)); }}})"""
OLD_CLIPBOARD = """Object.defineProperty(navigator, "clipboard", {value: undefined});
    addEventListener("copy", (event) => { window.written = Object.fromEntries(
        ["text/plain", "text/html"].map((t) => [t, event.clipboardData.getData(t)]).filter(([, text]) => text)); })"""
NO_CLIPBOARD = """Object.defineProperty(navigator, "clipboard", {value: {writeText: async () => { throw new Error("no"); },
                                                                    write: async () => { throw new Error("no"); }}});
    document.execCommand = () => false"""
TABLE = 'k\tx\ty\tp\ttest\tstep\n0\t0\t0\t-1\tp < 0\tE\n1\t1\t0\t5\tp ≥ 0\tNE\n2\t2\t1\t-3\t\t\n'


def copying(check, browser, made):
    for name, stub in (('with a clipboard', FULL_CLIPBOARD), ('the old way', OLD_CLIPBOARD)):
        page = Page(browser, made / 'line.html', '#step=2&loop=1-4&marks=3&speed=4')
        page.run(stub)
        page.click_on('#player [data-do="copying"]')
        for what, expected in (('link', (made / 'line.html').resolve().as_uri() + '#step=2&loop=1-4&marks=3&speed=4'),
                               ('command', 'gradus figure bresenham_line --from 0,0 --to 7,3'), ('table', TABLE)):
            page.run('window.written = null')
            page.click_on(f'#player [data-do="copy_{what}"]')
            page.wait_for('window.written !== null', 3)
            written = page.run('return window.written')
            if what == 'link':
                parts = lambda url: (url.split('#')[0], sorted(url.split('#')[1].split('&')))
                check.equal(f'{name}: the link', parts(written['text/plain']), parts(expected))
            else:
                check.equal(f'{name}: the {what}', written['text/plain'], expected)
            check.equal(f'{name}: the {what} is said', page.run('return player.parts.copied.textContent'), f'{what} copied')
        rows = page.run("""const table = new DOMParser().parseFromString(window.written["text/html"], "text/html").querySelector("table");
            return [...table.rows].map((row) => [...row.cells].map((cell) => cell.textContent).join("\\t") + "\\n").join("")""")
        check.equal(f'{name}: the table as HTML', rows, TABLE)
        check.equal(f'{name}: nothing is left behind', page.run('return player.root.querySelectorAll("textarea").length'), 1)
        check.equal(f'{name}: the focus stays', page.run('return document.activeElement.dataset.do ?? "dialog"') in
                    ('copy_table', 'dialog', 'copy_link'), True)
    page = Page(browser, made / 'line.html', '#step=2')
    page.run(NO_CLIPBOARD)
    page.click_on('#player [data-do="copying"]')
    page.click_on('#player [data-do="copy_table"]')
    page.wait_for('!player.parts["by-hand"].hidden', 3)
    selected = page.run("""const field = player.parts["by-hand"];
        return [field.checkVisibility(), field.value.slice(field.selectionStart, field.selectionEnd),
                document.activeElement === field, player.parts.copied.textContent]""")
    check.equal('without any: the text lies selected', selected,
                [True, TABLE, True, 'the browser does not allow copying here: press Ctrl+C'])
    check.equal('roles for readers', page.run('return [player.parts.copied, player.parts.notice].map((n) => n.role)'),
                ['status', 'status'])


def address_round_trip(check, browser, made):
    rng = random.Random(SEED)
    page = Page(browser, made / 'fine.html')
    numbers = page.run('return player.run.steps.map((s) => s.number)')
    what = ('step', 'loop', 'bookmarks', 'speed', 'cells', 'table')
    for _ in range(12):
        first, last = sorted(rng.sample(range(len(numbers)), 2))
        page.run('player.setLoop(arguments[0])', {'first': first, 'last': last, 'on': rng.random() < 0.7})
        page.run('player.setBookmarks(arguments[0])', rng.sample(range(len(numbers)), rng.randrange(4)))
        page.run('player.setSpeed(arguments[0])', rng.randrange(8))
        page.run('player.chooseTheme(arguments[0])', rng.choice(['light', 'dark', 'greyscale', 'high_contrast']))
        page.go(rng.choice(numbers))
        link, sent = page.run('return [player.link(), player.state()]')
        theme = page.run('return player.theme.name')
        page = Page(browser, made / 'fine.html', '#' + link.split('#')[1])
        got = page.state()
        check.equal(f'{link.split("#")[1]} shows what its sender saw', [got[w] for w in what] + [page.run('return player.theme.name')],
                    [sent[w] for w in what] + [theme])
    for bad, said in (('loop=5-2', '5-2'), ('loop=1-99', '1-99'), ('loop=1', 'found 1'), ('loop=1-2-3', '1-2-3'),
                      ('speed=3', 'found 3'), ('speed=x', 'found x'), ('marks=2,99', '2,99'), ('marks=,', 'found ,'),
                      ('step=99', 'no step 99'), ('%E0%A4%A=1', '')):
        page = Page(browser, made / 'line.html', f'#{bad}')
        check.that(f'#{bad} is said', said in page.run('return player.parts.notice.textContent'),
                   page.run('return player.parts.notice.textContent'))
        state = page.state()
        check.equal(f'#{bad} changes nothing', [state[w] for w in ('step', 'loop', 'bookmarks', 'speed')], ['0', None, [], 1])
        no_noise(check, page, f'#{bad}')
    page = Page(browser, made / 'line.html')
    check.equal('opening alone leaves the address alone', page.wait_for('location.hash !== ""', 0.4), False)


def in_a_frame(check, browser, made):
    """As a page of one's own would hold it."""
    host = made / 'host.html'
    host.write_text('<!DOCTYPE html><html lang="en"><title>host</title><body style="margin: 0">'
                    '<iframe src="line.html#embed&amp;step=3&amp;loop=2-4" width="640" height="400" style="border: 0" '
                    'title="player"></iframe>', encoding='utf-8')
    page = Page(browser, host)
    page.frame(0)
    check.equal('in a frame: the step', page.step, '3')
    check.equal('in a frame: all of it fits', page.run(FITS), [True, True])
    check.equal('in a frame: the frame is the window', page.run('return [innerWidth, innerHeight]'), [640, 400])
    sizes = page.run('''return [...player.drawing.svg.querySelectorAll("text"), player.parts.said, player.parts.grid]
        .map((n) => parseFloat(getComputedStyle(n).fontSize))''')
    check.that('in a frame: no text below 12 px', min(sizes) >= 12, sizes)
    check.that('in a frame: cells can be told apart', page.run('return player.drawing.at.cell') >= 24,
               page.run('return player.drawing.at.cell'))
    page.click_on('#player [data-do="next"]')
    check.equal('in a frame: a button', page.step, '4')
    page.press('ArrowRight')
    check.equal('in a frame: keys, after a click', page.step, '5')
    page.press('l')
    check.that('in a frame: notices are seen', page.run('return player.parts.notice.checkVisibility()'))
    page.frame(None)
    errors = [entry['message'] for entry in page.log('browser')]
    check.equal('in a frame: nothing on the console', errors, [])


def data_of(path):
    text = path.read_text(encoding='utf-8')
    start = text.index('id="gradus-page">') + len('id="gradus-page">')
    return json.loads(text[start:text.index('</script>', start)])


def names_in(value):
    """All member names in some JSON."""
    if isinstance(value, dict):
        return set(value) | set().union(*map(names_in, value.values()))
    if isinstance(value, list):
        return set().union(*map(names_in, value))
    return set()


def dropped_slots(check, browser, made):
    """What was dropped is not in the page at all: neither its text nor its members."""
    whole = data_of(made / 'line.html')['trace']
    steps = whole['steps']
    texts = {
        'title': [],  # the browser's own title still says what the page is
        'drawing': ['E chosen', 'NE rejected', 'ideal line'],
        'listing': [text for _, text in whole['listing'] if len(text) > 10],
        'table': sorted({cell for step in steps for cell in [*step.get('read', []), *step.get('row', [])]
                         if ' ' in cell and not any(cell in line for _, line in whole['listing'])}),
        'sentence': [whole['goal']] + [step['sentence'] for step in steps],
        'footer': [text for _, text in whole['legend'] if ' ' in text] + ['main loop'],
    }
    members = {
        'title': {'title', 'subtitle', 'method_title'},
        'drawing': {'grid', 'backdrop', 'cells', 'set', 'removed', 'focus', 'key', 'legend', 'pixels', 'before', 'roles'},
        'listing': {'listing', 'line', 'source_file', 'type'},
        'table': {'columns', 'row', 'read', 'fields', 'result', 'widest'},
        'sentence': {'sentence', 'goal'},
        'footer': {'legend', 'phase'},
    }
    parts = {'title': 'title', 'drawing': 'drawing', 'listing': 'listing', 'table': 'table', 'sentence': 'said',
             'footer': 'footer'}
    full = (made / 'line.html').read_text(encoding='utf-8')
    for slot, wanted in texts.items():
        check.equal(f'{slot}: the whole page has its texts', [t for t in wanted if json.dumps(t, ensure_ascii=False)[1:-1] not in full], [])
    check.that('the whole trace has all members', set().union(*members.values()) - names_in(whole) <= {'before', 'removed'} | names_in(whole),
               set().union(*members.values()) - names_in(whole))
    for path in sorted([*made.glob('without_*.html'), *made.glob('only_*.html')]):
        kind, slot = path.stem.split('_')
        gone = [slot] if kind == 'without' else [s for s in texts if s != slot]
        text, trace = path.read_text(encoding='utf-8'), data_of(path)['trace']
        for s in gone:
            leaked = [t for t in texts[s] if t in text]
            check.equal(f'{path.name}: no text of the {s}', leaked, [])
            check.equal(f'{path.name}: no member of the {s}', sorted(members[s] & names_in(trace)), [])
        page = Page(browser, path, '#step=3')
        seen = [s for s, part in parts.items() if page.run(
            'const n = player.parts[arguments[0]]; return n.checkVisibility() && !n.classList.contains("unseen")', part)]
        check.equal(f'{path.name}: shows the others', seen, [s for s in texts if s not in gone])
        check.equal(f'{path.name}: fits', page.run(FITS), [True, True])
        page.press('ArrowRight', 'End', 'b', 'l', 'v', 'Space', 't', 'Home')
        check.equal(f'{path.name}: steps', page.step, '0')
        no_noise(check, page, path.name)
        narrow(check, browser, path)
    page = Page(browser, made / 'without_listing.html')
    check.that('the table takes the room of the listing', page.run('return player.room.rows') >= 8)
    page = Page(browser, made / 'only_drawing.html')
    check.that('a drawing alone is large', page.run('return player.drawing.at.cell') >= 80)


def words_of(code):
    """The player's texts of a language's catalogue, by key."""
    out, section = {}, ''
    for line in (ROOT / f'visualize/figure/language/{code}.txt').read_text(encoding='utf-8').splitlines():
        if line.startswith('['):
            section = line.strip('[]') + '.'
        elif '=' in line and not line.startswith('#'):
            key, text = line.split('=', 1)
            out[section + key.strip()] = text.strip()
    return {key: text for key, text in out.items() if key.startswith('player.')}


def languages(check, browser, made):
    english, german = words_of('en'), words_of('de')
    check.equal('English and German have the same texts', sorted(english), sorted(german))
    scripts = ''.join(path.read_text(encoding='utf-8') for path in sorted((ROOT / 'visualize/web/page').glob('*.js')))
    asked = {key for call in re.findall(r"\bsay\(([^;{]*)", scripts) for key in re.findall(r"'(\w+)'", call)}
    known = {key.removeprefix('player.said.') for key in english} | {'step', 'faulty'}
    check.that('the script asks for texts', len(asked) > 20, len(asked))
    check.equal('… that there are', sorted(asked - known), [])
    sources = scripts + (ROOT / 'visualize/web/page/player.html').read_text(encoding='utf-8') + (
        ROOT / 'visualize/web/player.cpp').read_text(encoding='utf-8')
    check.equal('no text is for nothing', [
        key for key in english for name in [key.split('.')[-1]]
        if not name.startswith('theme_') and not re.search(rf"'{name}'|say {name}}}}}|\"{key}\"", sources)], [])
    for path in sorted(made.glob('*.html')):
        check.that(f'{path.name}: no place is left empty', '{{say' not in path.read_text(encoding='utf-8', errors='replace'))
    page = Page(browser, made / 'german.html', '#step=3')
    check.equal('the page is in German', page.run('return document.documentElement.lang'), 'de')
    page.press('b', '[', 'b', 'Shift')
    texts = """const out = new Set(), walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
        while (walk.nextNode()) if (!walk.currentNode.parentNode.closest("script, template")) out.add(walk.currentNode.data.trim());
        for (const node of document.querySelectorAll("[title], [aria-label]"))
          for (const name of ["title", "aria-label"]) out.add((node.getAttribute(name) ?? "").replace(/ \\(.*\\)$/, ""));
        return [...out]"""
    shown = set(page.run(texts))
    static = {key: text for key, text in german.items() if not key.startswith('player.said.')}
    missing = [key for key, text in static.items()
               if text not in shown and key not in ('player.no_script', 'player.about', 'player.space', 'player.shift')]
    check.equal('all German texts are shown', missing, [])
    foreign = [text for key, text in english.items() if text in shown and text != german[key] and '{' not in text
               and text not in ('step',)  # a column of this table
               and text not in german.values()]
    check.equal('no English text is shown', foreign, [])
    check.equal('the footer is German', page.state()['position'], 'Schritt 3 / 7 · main loop')
    check.equal('the line buttons are German', page.run('return player.parts.lines.querySelector("button").getAttribute("aria-label")'),
                'Zeile 1: zu ihrer nächsten Ausführung')
    check.equal('notices are German', page.run('return player.parts.notice.textContent'), 'kein Lesezeichen mehr bei Schritt 3')
    page = Page(browser, made / 'topic.html')
    link = page.run('const a = player.root.querySelector("a"); return [a.getAttribute("href"), a.textContent, a.checkVisibility()]')
    check.equal('the page about the algorithm', link, ['./topics/a%20line.html', 'about this algorithm', True])
    check.equal('the first theme', page.run('return player.theme.name'), 'greyscale')
    page = Page(browser, made / 'topic.html', '#theme=dark')
    check.equal('… unless the address has one', page.run('return player.theme.name'), 'dark')
    page = Page(browser, made / 'line.html')
    check.equal('no link where there is no page', page.run('return player.root.querySelectorAll("a").length'), 0)


FOCUS = """const node = document.activeElement, style = getComputedStyle(node);
    const name = node.dataset.do ?? node.dataset.part ?? ((node.closest("[data-position]") && "line") ||
        (node.matches("[data-row]") && "row") || (node.matches("a") && "link") || node.tagName);
    return [name, style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2,
            Boolean(node.closest("dialog[open]"))]"""


def keyboard_alone(check, browser, made):
    page = Page(browser, made / 'topic.html', '#step=4')
    page.run('player.setBookmarks([2])')
    reached, unseen = [], []
    for _ in range(40):
        page.press('Tab')
        name, outlined, _ = page.run(FOCUS)
        if name == 'BODY' or name in reached:
            break
        reached.append(name)
        if not outlined:
            unseen.append(name)
    wanted = page.run("""return [...player.root.querySelectorAll("[data-do]")].filter((n) => n.checkVisibility())
                            .map((n) => n.dataset.do)""") + ['line', 'row', 'slider', 'wanted', 'link']
    check.equal('Tab reaches every control', sorted(set(wanted) - set(reached)), [])
    check.equal('… and where it is can be seen', unseen, [])
    order = [name for name in reached if name in ('line', 'row', 'first', 'slider', 'backwards', 'full')]
    check.equal('… in the order of the page', order, ['line', 'row', 'first', 'slider', 'backwards', 'full'])

    def tab_to(name):
        page.run('document.activeElement.blur()')
        for _ in range(40):
            page.press('Tab')
            if page.run(FOCUS)[0] == name:
                return
        raise WebDriverError(f'Tab does not reach {name}')

    for name, key, script, expected in (
            ('next', 'Enter', 'player.state().step', '5'), ('previous', 'Space', 'player.state().step', '4'),
            ('loop_from', 'Enter', 'player.state().loop', ['4', '7']), ('loop', 'Space', 'player.state().loop', None),
            ('bookmark', 'Enter', 'player.state().bookmarks', ['2', '4']),
            ('next_bookmark', 'Enter', 'player.state().step', '2'), ('faster', 'Space', 'player.state().speed', 2),
            ('theme', 'Enter', 'player.theme.name', 'high_contrast'), ('play', 'Enter', 'player.playing', True),
            ('play', 'Space', 'player.playing', False), ('backwards', 'Enter', 'player.state().pace', -1),
            ('backwards', 'Enter', 'player.state().pace', 0), ('first', 'Enter', 'player.state().step', '0')):
        tab_to(name)
        page.press(key)
        check.equal(f'{key} on {name}', page.run(f'return {script}'), expected)
        check.equal(f'… keeps the focus on {name}', page.run(FOCUS)[0], name)
    for name in ('keys', 'copying'):
        tab_to(name)
        page.press('Enter')
        check.that(f'the dialog {name} opens', page.run('return player.parts[arguments[0]].open', name))
        outside = []
        for _ in range(8):
            page.press('Tab')
            at = page.run(FOCUS)
            if not at[2] and at[0] != 'BODY':
                outside.append(at[0])
        check.equal(f'the dialog {name} holds the focus', outside, [])
        page.press('Escape')
        check.equal(f'Escape closes {name} and gives the focus back',
                    [page.run('return player.parts[arguments[0]].open', name), page.run(FOCUS)[0]], [False, name])
    page.go('6')
    tab_to('row')
    page.press('ArrowUp', 'ArrowUp', 'Enter')
    check.equal('rows by keyboard', [page.step, page.run(FOCUS)[0]], ['4', 'row'])
    page.press('ArrowUp', 'Enter')
    check.equal('… and on from there', [page.step, page.run(FOCUS)[0]], ['3', 'row'])
    tab_to('wanted')
    page.press('6', 'Enter')
    check.equal('a number into the field', page.step, '6')

    many = Page(browser, made / 'many.html', '#step=500')
    many.run('player.parts.rows.querySelector("tr.strong").focus()')
    for _ in range(60):
        many.press('ArrowUp')
    many.press('Enter')
    check.equal('up through rows that were not there', [many.step, many.run(FOCUS)[0]], ['440', 'row'])


def readers(check, browser, made):
    """What a screen reader is told."""
    page = Page(browser, made / 'line.html')
    live = 'return player.parts.live.textContent'
    page.press('ArrowRight')
    check.that('step and sentence are said', page.run(live).startswith('step 1 / 7 · main loop: p = -1 < 0'), page.run(live))
    check.equal('the region is polite', page.run('return [player.parts.live.ariaLive, player.parts.live.ariaAtomic]'),
                ['polite', 'true'])
    page.run('''window.said = []; new MutationObserver(() => said.push(player.parts.live.textContent))
                  .observe(player.parts.live, {childList: true}); player.setSpeed(7); player.first()''')
    page.run('window.said.length = 0; player.play()')
    page.wait_for('!player.playing')
    page.wait_for('said.length > 0', 2)
    said = page.run('return said')
    check.equal('fast steps are not said, where they end is', [s.split(' · ')[0] for s in said], ['step 7 / 7'])
    page.run('player.first(); player.setSpeed(2); said.length = 0; player.play()')
    page.wait_for('player.index === 2', 5)
    page.run('player.pause()')
    spoken = [s.split(' · ')[0] for s in page.run('return said')]
    check.equal('slow steps are said, once each', spoken[-2:], ['step 1 / 7', 'step 2 / 7'])
    table = page.run("""const table = player.parts.grid;
        return [table.caption.textContent, [...table.tHead.rows[0].cells].map((c) => c.scope),
                [...table.querySelectorAll("[aria-current]")].map((r) => [r.dataset.row, r.ariaCurrent])]""")
    check.equal('a real table', table, ['Decision table', ['col'] * 6, [['2', 'step']]])
    check.equal('the current line', page.run("""return [...player.parts.lines.querySelectorAll("[aria-current]")]
        .map((li) => li.firstChild.textContent)"""), ['9'])


def two_at_once(check, browser, made):
    alone = {}
    for name in ('line', 'other'):
        page = Page(browser, made / f'{name}.html')
        page.go('3')
        alone[name] = page.run('return JSON.stringify(player.state().table)')
    trace = (made / 'other.html').read_text(encoding='utf-8')
    start = trace.index('id="gradus-page">') + len('id="gradus-page">')
    other = json.loads(trace[start:trace.index('</script>', start)])['trace']
    page = Page(browser, made / 'line.html')
    page.run('''player.root.style.height = "50vh";
                const root = document.body.appendChild(document.createElement("div"));
                root.style.height = "50vh";
                window.second = new GradusPlayer(root);
                window.second.load(arguments[0]);''', other)
    page.go('3')
    check.equal('the second stays at 0', page.run('return second.state().step'), '0')
    page.run('second.goTo("3"); second.next(); second.previous();')
    check.equal('both show their own', page.run('return [JSON.stringify(player.state().table), JSON.stringify(second.state().table)]'),
                [alone['line'], alone['other']])
    page.run('second.parts.wanted.focus(); second.parts.wanted.blur(); second.root.querySelector(".stage").focus();')
    page.press('ArrowRight')
    check.equal('keys go to the one in focus', page.run('return [player.state().step, second.state().step]'), ['3', '4'])
    check.equal('no id twice', page.run('''const ids = [...document.querySelectorAll("[id]")].map((n) => n.id);
                                          return ids.length - new Set(ids).size'''), 0)
    page.run('second.load(JSON.parse(document.getElementById("gradus-page").textContent).trace); second.goTo("3")')
    check.equal('a live trace takes the place of the last', page.run('return JSON.stringify(second.state().table)'), alone['line'])


def hostile(check, browser, made):
    for path in (made / 'hostile.html', made / 'gallery.html'):
        page = Page(browser, path)
        check.equal(f'{path.name}: no alert', page.alert(), None)
        check.equal(f'{path.name}: nothing of it runs', page.run('return typeof window.hacked'), 'undefined')
        scripts = page.run('return document.querySelectorAll("script").length')
        check.equal(f'{path.name}: no script more', scripts, 2 if path.name == 'hostile.html' else 1)
    page = Page(browser, made / 'hostile.html')
    for _ in range(4):
        page.press('ArrowRight')
    check.equal('no element out of text', page.run('''return player.root.querySelectorAll("img, b, script, [onerror]").length'''), 0)
    check.that('the text itself is shown', '<img src=x onerror=window.hacked=1>' in page.state()['sentence'])
    check.that('faulty is said', 'faulty' in page.run('return player.parts.faulty.textContent'))
    check.equal('faulty is seen', page.run('return player.parts.faulty.checkVisibility()'), True)
    page = Page(browser, made / 'gallery.html')
    links = page.run('return [...document.querySelectorAll("a, img")].map((a) => a.getAttribute("href") ?? a.getAttribute("src"))')
    check.that('gallery: relative links only', all(link.startswith('./') for link in links), links)
    page.size(360, 740)
    across, room = page.run('const d = document.documentElement; return [d.scrollWidth, d.clientWidth]')
    check.that('gallery at 360 px: no scrolling sideways', across <= room, (across, room))


def large(check, browser, made):
    page = Page(browser, made / 'many.html')
    whole = page.run('return performance.getEntriesByName("gradus: open")[0]')
    print(f'many.html: opened {whole["startTime"] + whole["duration"]:.0f} ms after navigation', flush=True)
    took = page.run('''const t = performance.now(); player.last(); const last = performance.now();
                       player.previous(); const back = performance.now(); player.goTo("5000");
                       const jump = performance.now(); player.next();
                       return [last - t, back - last, jump - back, performance.now() - jump].map(Math.round)''')
    print(f'many.html: to the end {took[0]} ms, back {took[1]} ms, a jump {took[2]} ms, on {took[3]} ms', flush=True)
    check.that('any move in 10,000 steps takes less than half a second', max(took) < 500, took)
    check.that('few rows are made', page.run('return player.parts.rows.children.length') < 60)
    page.go('10000')
    page.run('player.parts.table.scrollTop = 0')
    check.that('the table scrolls back to its first row', page.wait_for('player.parts.rows.querySelector("[data-row=\'0\']") !== null', 3))
    page.click_on('#player tr[data-row="1"]')
    check.equal('… which can be clicked', page.step, '1')

    page = Page(browser, made / 'huge.html')
    page.go('100')
    state = page.state()
    view = state['view']
    current = [c for c in state['cells'] if c[2] == 'current']
    check.equal('huge grid: the view follows', len(current), 1)
    check.that('huge grid: cells stay large', page.run('return player.drawing.at.cell / (player.unit / 20)') >= 24)
    check.that('huge grid: an overview', page.run('return player.drawing.overview.element.checkVisibility()'))
    moved, half = [], (view['x1'] - view['x0'] + 1) // 2
    for number in range(101, 140):
        page.go(str(number))
        new = page.run('return player.drawing.at.view')
        if new != view:
            moved.append(new['x0'] - view['x0'])
            view = new
    check.that('huge grid: the view jumps by half a window', moved != [] and all(abs(m) in (0, half) for m in moved), (half, moved))
    outside = page.run('''const a = player.drawing.at, box = {l: -1, t: -1, r: a.width + 1, b: a.height + 1};
        return [...player.drawing.svg.querySelectorAll("text")].map((t) => t.getBBox())
          .filter((b) => b.x < box.l || b.y < box.t || b.x + b.width > box.r || b.y + b.height > box.b).length''')
    check.equal('huge grid: no text is cut', outside, 0)

    page = Page(browser, made / 'late.html')
    check.equal('a late recording starts there', page.step, '4')
    check.equal('… with the cells made before', len(page.state()['cells']), 5)
    check.equal('… and says so', page.run('return [player.parts.notice.textContent, player.parts.total.title]'),
                ['recorded: steps 4 to 6 of 0 to 8'] * 2)


def labels_keep_apart(check, browser, made):
    for name in ('line', 'long', 'huge'):
        page = Page(browser, made / f'{name}.html')
        wrong = []
        for index in range(0, page.run('return player.run.steps.length'), 1 if name == 'line' else 7):
            page.run('player.show(arguments[0])', index)
            bad = page.run('''const boxes = player.drawing.labels.texts, out = [];
                boxes.forEach((a, i) => boxes.slice(i + 1).forEach((b) => {
                  const w = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
                  const h = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
                  if (w > 0 && h > 0) out.push([a, b]);
                }));
                return out.length;''')
            if bad:
                wrong.append(index)
        check.equal(f'{name}.html: no text on another', wrong, [])


def one_a_topic(pages):
    """The first page of each topic, unless GRADUS_STRESS asks for all: a page takes seconds."""
    if EVERYTHING:
        return pages
    first = {}
    for page in pages:
        topic = re.search(r'"topic": *"(\w+)"', page.read_text(encoding='utf-8'))
        first.setdefault(topic[1] if topic else page.name, page)
    return list(first.values())


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('--made', type=pathlib.Path, help='folder that make_pages has filled')
    parser.add_argument('pages', nargs='*', type=pathlib.Path)
    arguments = parser.parse_args()
    if not shutil.which('chromium') or not shutil.which('chromedriver'):
        print('no chromium or chromedriver: skipped (Debian: chromium chromium-driver)', file=sys.stderr)
        return 77
    check = Checks()
    with Browser() as browser:
        def guarded(test, *rest):
            try:
                test(check, browser, *rest)
            except WebDriverError as error:
                check.that(f'{test.__name__} {rest[-1].name}', False, str(error))
        pages = one_a_topic(arguments.pages)
        if arguments.made:
            pages += [arguments.made / f'{name}.html' for name in MADE]
            for test in (keyboard_and_mouse, playing, fine_steps, address, looping, backwards, bookmarks, copying,
                         address_round_trip, in_a_frame, dropped_slots, languages, keyboard_alone, readers, two_at_once, hostile, large,
                         labels_keep_apart):
                guarded(test, arguments.made)
        for path in pages:
            guarded(any_page, path)
    print(f'{check.passed} passed, {len(check.failed)} failed')
    for failure in check.failed:
        print(f'  {failure}')
    return 1 if check.failed else 0


if __name__ == '__main__':
    sys.exit(main())
