#!/usr/bin/env python3
"""Drives player pages in headless Chromium, from file://.

    player_test.py [--made FOLDER] [PAGE.html ...]

Every PAGE gets the checks that hold for any player page. FOLDER holds what make_pages wrote: pages made up to reach
the player's corners. Prints `N passed, N failed`, exits 1 when a check failed, 77 when there is no Chromium.
"""

import argparse
import json
import pathlib
import random
import shutil
import sys
import time

from webdriver import Browser, WebDriverError

SEED = 20261121

STATE = '''const p = arguments[0] ? window[arguments[0]] : window.player;
           return JSON.stringify([p.state(), p.parts.drawing.querySelector('svg').innerHTML,
                                  p.parts.rows.innerText, p.parts.table.scrollTop, p.parts.lines.scrollTop]);'''


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
        return self.run(STATE)

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
    check.equal(f'{name}: the drawing is named by its sentence',
                page.run('return player.drawing.svg.getAttribute("aria-label") === player.state().sentence'), True)
    check.equal(f'{name}: no scroll bars at 1280 x 720',
                page.run('''const d = document.documentElement;
                            return [d.scrollWidth <= d.clientWidth, d.scrollHeight <= d.clientHeight]'''), [True, True])
    no_noise(check, page, name)
    same_however_reached(check, page, name)
    narrow(check, browser, path)


def same_however_reached(check, page, name):
    """State after any walk == state of a fresh player that jumped there."""
    rng = random.Random(SEED)
    numbers = page.run('return player.run.steps.map((s) => s.number)')
    moves = ['next', 'previous', 'nextEvent', 'previousEvent', 'next', 'jump']
    page.run('player.first()')
    seen = {}
    for _ in range(60):
        move = rng.choice(moves)
        if move == 'jump':
            page.go(rng.choice(numbers))
        else:
            page.run(f'player.{move}()')
        seen[page.step] = page.everything()
    page.run('player.last()')
    page.run('player.first()')
    seen[numbers[0]] = page.everything()
    fresh = Page(page.browser, page.path)
    wrong = []
    for number in sorted(seen, key=lambda n: rng.random()):
        # A new player in the same place knows nothing of the steps before
        fresh.run('''const data = JSON.parse(document.getElementById("gradus-page").textContent);
                     player.load(data.trace, {command: data.command});''')
        fresh.go(number)
        found = fresh.everything()
        if found != seen[number]:
            at = next((i for i, (a, b) in enumerate(zip(found, seen[number])) if a != b), -1)
            wrong.append((number, found[max(at - 40, 0):at + 60], seen[number][max(at - 40, 0):at + 60]))
    check.equal(f'{name}: {len(seen)} steps look the same however reached (seed {SEED})', wrong, [])


def narrow(check, browser, path):
    name = f'{path.name} at 360 px'
    page = Page(browser, path, size=(360, 740))
    widths = '''const d = document.documentElement; return [d.scrollWidth, d.clientWidth];'''
    for where in ('first', 'last'):
        page.run(f'player.{where}()')
        across, room = page.run(widths)
        check.that(f'{name}: the page does not scroll sideways ({where} step)', across <= room, (across, room))
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
    page.press('ArrowRight')
    check.equal('no steps behind the keys', page.step, '2')
    page.press('Escape')
    check.equal('Escape closes them', page.run('return player.parts.keys.open'), False)
    page.click_on('#player [data-do="command"]')
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
    hidden = page.run('''return [".title", ".tools", ".go"].map((s) =>
                           getComputedStyle(player.root.querySelector(s)).display)''')
    check.equal('#embed hides the chrome', hidden, ['none'] * 3)
    check.equal('#embed keeps the step', page.step, '3')
    page.press('ArrowRight')
    check.that('#embed stays in the address', page.wait_for('location.hash === "#embed&step=4"', 3))


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
    check.that('faulty is said', 'faulty' in page.run('return getComputedStyle(player.parts.faulty, "::before").content'))
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
    check.that('huge grid: an overview', page.run('return player.drawing.overview.checkVisibility()'))
    moved = []
    for number in range(101, 140):
        page.go(str(number))
        new = page.run('return player.drawing.at.view')
        if new != view:
            moved.append(new['x0'] - view['x0'])
            view = new
    check.that('huge grid: the view jumps by half a window', moved != [] and all(abs(m) in (0, 6) for m in moved), moved)
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
        pages = list(arguments.pages)
        if arguments.made:
            pages += [arguments.made / f'{name}.html' for name in ('line', 'fine', 'long', 'many', 'huge', 'hostile', 'late')]
            for test in (keyboard_and_mouse, playing, fine_steps, address, two_at_once, hostile, large, labels_keep_apart):
                guarded(test, arguments.made)
        for path in pages:
            guarded(any_page, path)
    print(f'{check.passed} passed, {len(check.failed)} failed')
    for failure in check.failed:
        print(f'  {failure}')
    return 1 if check.failed else 0


if __name__ == '__main__':
    sys.exit(main())
