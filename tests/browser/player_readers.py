"""For every reader: by keyboard alone, by ear, in every language."""
import pathlib
import re

from player_page import Page
from webdriver import WebDriverError

ROOT = pathlib.Path(__file__).resolve().parents[2]


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
    check.equal('… that exist', sorted(asked - known), [])
    sources = scripts + ''.join(
        (ROOT / 'visualize/web' / name).read_text(encoding='utf-8')
        for name in ('page/player.html', 'page/player_template.html', 'workbench/workbench.html', 'player.cpp', 'player_parts.cpp'))
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
