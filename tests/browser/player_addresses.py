"""What goes in and out of a page: its address, what is copied, the frame it stands in."""
import random

from player_page import FITS, Page, SEED, no_noise


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
