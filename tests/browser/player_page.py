"""A player page in the browser for the tests beside it: what is run in it, and what holds for every such page."""
import json
import random
import re
import time

from webdriver import EVERYTHING, share_of

SEED = 20261121
MADE = ('line', 'fine', 'long', 'many', 'huge', 'hostile', 'late')
STATE = '''const everything = () => JSON.stringify([player.state(), player.parts.drawing.querySelector('svg').innerHTML,
               player.parts.rows.innerText, player.parts.table.scrollTop, player.parts.lines.scrollTop]);
           const go = (number) => { if (!player.goTo(number)) throw new Error("no step " + number); };'''

# A walk: what each step that was reached looked like when it was last seen.
WALK = STATE + '''const seen = {}, look = () => { seen[player.run.steps[player.index].number] = everything(); };
           player.setBookmarks([]);  // of two side by side the first marks where they part
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
    # A guard against hanging: how long it takes is printed, and the machine may be slow and busy
    many = page.run('return player.run.steps.length') / 10_000
    check.that(f'{name}: 10,000 steps open in less than ten seconds', opened < 10_000 * max(many, 1), opened)
    check.that(f'{name}: few rows are made, however many steps', page.run('return player.parts.rows.children.length') < 60)
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


def one_a_topic(pages):
    """Of players the first of each topic, of those and of topics' pages a share, and all others; unless GRADUS_STRESS asks
    for all: a page takes seconds."""
    if EVERYTHING:
        return pages
    players, about, others = {}, [], []
    for page in pages:
        topic = re.search(r'"topic": *"(\w+)"', page.read_text(encoding='utf-8'))
        if topic:
            players.setdefault(topic[1], page)
        else:
            (about if 'topics' in page.parts else others).append(page)
    return others + share_of(about, 9) + share_of(players.values(), 9)
