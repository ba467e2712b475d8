#!/usr/bin/env python3
"""Drives player pages in headless Chromium, from file://.

    player_test.py [--made FOLDER] [PAGE.html ...]

Every PAGE gets the checks that hold for any player page. FOLDER holds what make_pages wrote: pages made up to reach
the player's corners. Prints `N passed, N failed`, exits 1 when a check failed, 77 when there is no Chromium.
"""
import argparse
import json
import pathlib
import shutil
import sys

from player_addresses import address, address_round_trip, copying, in_a_frame
from player_controls import backwards, bookmarks, differences, fine_steps, keyboard_and_mouse, looping, playing
from player_page import Checks, FITS, MADE, Page, any_page, narrow, no_noise, one_a_topic
from player_readers import keyboard_alone, languages, readers
from webdriver import Browser, WebDriverError, share_of


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
        'drawing': {'grid', 'backdrop', 'cells', 'set', 'removed', 'focus', 'key', 'legend', 'before', 'roles'},
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
    for path in share_of(sorted([*made.glob('without_*.html'), *made.glob('only_*.html')]), 2):
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
    check.that('no move in 10,000 steps hangs', max(took) < 5000, took)
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
            for test in (keyboard_and_mouse, differences, playing, fine_steps, address, looping, backwards, bookmarks, copying,
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
