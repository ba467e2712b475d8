#!/usr/bin/env python3
"""The gallery and the topic pages in headless Chromium, from file://.

    pages_test.py GALLERY MADE PICTURE

GALLERY is a folder that `gradus figures` made, MADE the gallery page that make_pages made up, PICTURE the page of a rendered picture. Prints `N passed, N failed`, exits 1 when a check failed, 77 when there
is no Chromium.
"""

import base64
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from player_page import Checks, Page
from webdriver import Browser, share_of

# A topic page is at most three screens: of the usual 1920 x 1080, or of A4 paper
SCREEN, PAPER, MOST = (1920, 1080), (8.27, 11.69), 3

SHOWN = 'return [...document.querySelectorAll(".card")].filter((card) => card.checkVisibility()).map((card) => card.id)'
FOUND = 'return document.querySelector(".found").textContent'


def look(page, scheme):
    page.cdp('Emulation.setEmulatedMedia', features=[{'name': 'prefers-color-scheme', 'value': scheme}])


def colour(page):
    return page.run('return getComputedStyle(document.body).backgroundColor')


def no_errors(check, page, name):
    errors = [entry['message'] for entry in page.log('browser') if entry['level'] in ('SEVERE', 'WARNING')]
    check.equal(f'{name}: nothing to complain of', errors, [])


def fits(check, page, name):
    for width in (360, 768, 1280):
        page.size(width, 740)
        across, room = page.run('const d = document.documentElement; return [d.scrollWidth, d.clientWidth]')
        check.that(f'{name} at {width} px: no scrolling sideways', across <= room, (across, room))
    page.size(1280, 720)


def theme_switch(check, page, name):
    light, dark = 'rgb(255, 255, 255)', 'rgb(20, 24, 29)'
    look(page, 'dark')
    check.equal(f'{name}: dark where the system is', colour(page), dark)
    look(page, 'light')
    check.equal(f'{name}: light where the system is', colour(page), light)
    seen = []
    for _ in range(3):
        page.click_on('button.theme')
        seen.append((page.run('return document.querySelector("button.theme").textContent'), colour(page)))
    check.equal(f'{name}: the switch', seen, [('colours: light', light), ('colours: dark', dark), ('colours: system', light)])
    page.click_on('button.theme'), page.click_on('button.theme')
    page.run('location.reload()')
    check.equal(f'{name}: a choice is remembered', colour(page), dark)
    page.run('localStorage.clear()')


# Slide lines are folded in turn: a button that shows
OPEN_COPY = ':not(.snippets) > .copied > button.copy'


def copying(check, page, name):
    """Every button copies the text beside it; without leave to write the clipboard the text is selected at least."""
    page.cdp('Browser.grantPermissions', permissions=['clipboardReadWrite', 'clipboardSanitizedWrite'])
    count = page.run('return document.querySelectorAll("button.copy").length')
    check.that(f'{name}: buttons to copy', count > 2, count)
    wanted = page.run('return document.querySelector("button.copy").parentElement.querySelector("code").textContent')
    page.run('document.querySelectorAll(".take").forEach((part) => { part.open = true; })')
    page.click_on('button.copy')
    # Both at once: soon the page is silent again
    check.that(f'{name}: says so, and aloud', page.wait_for('''document.querySelector("button.copy").firstChild.data === "copied" &&
        document.querySelector(".notice").textContent === "Copied."'''))
    check.equal(f'{name}: on the clipboard', page.run('return navigator.clipboard.readText()'), wanted)
    check.that(f'{name}: one line', '\n' not in wanted and wanted.startswith('gradus '), wanted)
    page.run('''navigator.clipboard.writeText = () => Promise.reject(new Error("no leave"));
                document.execCommand = () => false;''')
    page.click_on(OPEN_COPY, 1)
    check.that(f'{name}: selected instead', page.wait_for('getSelection().toString().trim().startsWith("gradus ")'))


def gallery(check, browser, folder):
    page = Page(browser, folder / 'index.html')
    everything = page.run(SHOWN)
    check.that('cards', len(everything) > 3, everything)
    check.equal('the count', page.run(FOUND), f'{len(everything)} figures')
    check.equal('the count is said', page.run('return document.querySelector(".found").getAttribute("role")'), 'status')

    page.press('/')
    check.equal('/ goes to the search', page.run('return document.activeElement.type'), 'search')
    page.press(*'Flood-FILL breadth')
    some = page.run(SHOWN)
    check.that('a search by topic and method', 0 < len(some) < len(everything) and all('breadth' in s or 'eight' in s for s in some), some)
    check.equal('the count of the search', page.run(FOUND), f'{len(some)} of {len(everything)} figures')
    page.press('Escape')
    check.equal('Escape shows all again', page.run(SHOWN), everything)
    page.press(*'bfs')
    check.equal('a search by alias', page.run(SHOWN), some if page.run(SHOWN) else [])
    page.press('Escape')
    page.press(*'xyzzy')
    check.equal('nothing found', page.run(SHOWN), [])
    check.that('nothing found is said', 'None of' in page.run(FOUND), page.run(FOUND))
    check.equal('no heading without cards', page.run('return [...document.querySelectorAll("h2")].some((h) => h.checkVisibility())'), False)
    page.press('Escape')

    unnamed = page.run('''return [...document.querySelectorAll("a, button, input, select")].filter((node) =>
        node.checkVisibility() && node.tabIndex >= 0 && !(node.textContent.trim() || node.labels?.[0]?.textContent.trim())).length''')
    check.equal('everything in reach has a name', unnamed, 0)
    names = page.run('return [...document.querySelectorAll(".copied .unseen")].map((n) => n.textContent)')
    check.that('a copy button says of what', names and all('command for' in n or 'lines for' in n for n in names), names[:3])
    links = page.run('return [...document.querySelectorAll("a")].map((a) => a.getAttribute("href"))')
    check.that('every link leads to a file', all((folder / link).is_file() for link in links), links)
    fits(check, page, 'gallery')
    theme_switch(check, page, 'gallery')
    copying(check, page, 'gallery')
    no_errors(check, page, 'gallery')

    browser.cdp('Emulation.setScriptExecutionDisabled', value=True)
    page = Page(browser, folder / 'index.html')
    browser.cdp('Emulation.setScriptExecutionDisabled', value=False)
    check.equal('without scripts all cards are there', page.run(SHOWN), everything)
    idle = page.run('return [...document.querySelectorAll("form, button")].filter((node) => node.checkVisibility()).length')
    check.equal('without scripts no button that does nothing', idle, 0)


def lecture(check, browser, path):
    """Chapters and lines to paste: a page with two cards, one of them hostile."""
    page = Page(browser, path)
    everything = page.run(SHOWN)
    check.equal('two cards', len(everything), 2)
    page.run('document.querySelector("select").focus()')
    page.press('ArrowDown')
    check.equal('one chapter, by keyboard', page.run(SHOWN), ['line'])
    check.equal('one chapter is counted', page.run(FOUND), '1 of 2 figures')
    page.press('ArrowUp')
    check.equal('all chapters', page.run(SHOWN), everything)
    for fold in ('take', 'snippets'):
        for _ in range(12):
            page.press('Tab')
            if page.run('return document.activeElement.matches(`#line .${arguments[0]} > summary`)', fold):
                break
        page.press('Enter')
        check.that(f'{fold} opens by keyboard', page.run('return document.querySelector(`#line .${arguments[0]}`).open', fold))
    page.press('Tab', 'Enter')
    beamer = page.run('return document.querySelector("#line .snippets code").textContent')
    check.that('three kinds of lines', page.run('return document.querySelectorAll("#line .snippets h4").length') == 3)
    check.that('several lines', beamer.startswith('\\begin{frame}\n  '), beamer)
    check.that('copied by keyboard', page.wait_for('document.querySelector("#line .snippets .copy").firstChild.data === "copied"'))
    check.equal('lines on the clipboard', page.run('return navigator.clipboard.readText()'), beamer)
    page.run('document.querySelectorAll("details").forEach((d) => { d.open = true; })')
    check.equal('nothing hostile runs', page.run('return typeof window.hacked'), 'undefined')
    links = page.run('return [...document.querySelectorAll("a, img")].map((a) => a.getAttribute("href") ?? a.getAttribute("src"))')
    check.that('relative links only', all(link.startswith('./') for link in links), links)
    fits(check, page, 'lecture')


def topic_page(check, browser, path):
    name = path.stem
    page = Page(browser, path)
    page.size(*SCREEN)
    high = page.run('return document.documentElement.scrollHeight')
    print(f'{name}: {high / SCREEN[1]:.2f} screens of {SCREEN[0]} x {SCREEN[1]}', flush=True)
    check.that(f'{name}: at most {MOST} screens', high <= MOST * SCREEN[1], high)
    pdf = base64.b64decode(page.cdp('Page.printToPDF', paperWidth=PAPER[0], paperHeight=PAPER[1], preferCSSPageSize=True)['data'])
    sheets = len(re.findall(rb'/Type\s*/Page\b', pdf))
    print(f'{name}: {sheets} sheets of paper', flush=True)
    check.that(f'{name}: at most {MOST} sheets of paper', 0 < sheets <= MOST, sheets)

    check.equal(f'{name}: every picture is shown', page.run('''return [...document.images].filter((image) =>
        !image.naturalWidth || !image.alt).length'''), 0)
    measure = page.run('return Math.max(...[...document.querySelectorAll("main p")].map((p) => p.getBoundingClientRect().width)) / 16')
    check.that(f'{name}: lines are not too long', measure <= 46, measure)
    check.equal(f'{name}: answers are folded', page.run('return document.querySelectorAll("details[open]").length'), 0)
    source = page.run('''const link = document.querySelector('main a[href^="#source-"]'); link.click();
                         return link.getAttribute("href").slice(1)''')
    check.that(f'{name}: a link to the source opens it', page.wait_for(f'document.getElementById("{source}").parentElement.open'))
    fits(check, page, name)
    theme_switch(check, page, name)
    copying(check, page, name)
    no_errors(check, page, name)


def errata(check, browser, path):
    page = Page(browser, path)
    check.equal('errata: every picture is shown', page.run('''return [...document.images].filter((image) =>
        !image.naturalWidth || !image.alt).length'''), 0)
    check.that('errata: pairs of pictures', page.run('return document.querySelectorAll(".pair").length') >= 40)
    readings = page.run('''return [...document.querySelectorAll(".reading")].map((table) =>
        [table.querySelectorAll("tbody td.wrong").length, table.querySelectorAll("thead th").length, !!table.caption])''')
    check.that('errata: what readers make of texts, in tables', len(readings) == 4 and
               all(wrong > 0 and heads == 3 and caption for wrong, heads, caption in readings), readings)
    check.equal('errata: links within the page lead somewhere', page.run('''return [...document.querySelectorAll('a[href^="#"]')]
        .filter((link) => !document.getElementById(link.getAttribute("href").slice(1))).length'''), 0)
    fits(check, page, 'errata')
    theme_switch(check, page, 'errata')
    no_errors(check, page, 'errata')


STORY = 'document.querySelector("[data-part=story]").textContent'


def picture(check, browser, path):
    """A click and a key press tell of a pixel what `gradus render --why` tells."""
    page = Page(browser, path)
    words = shlex.split(page.run('return document.querySelector(\'meta[name="gradus-command"]\').content'))[1:]
    gradus = os.environ.get('GRADUS_COMMAND', 'gradus')

    def told(pixel):
        return subprocess.run([gradus, *words, '--why', pixel], capture_output=True, encoding='utf-8', check=True).stdout

    def shows(what, pixel):
        check.that(f'{what}: pixel {pixel}', page.wait_for(f'{STORY}.startsWith("Pixel {pixel} ")'), page.run(f'return {STORY}'))
        check.equal(f'{what}: what is told of {pixel}', page.run(f'return {STORY}'), told(pixel))
        check.equal(f'{what}: the address', page.run('return location.hash'), f'#pixel={pixel}')
        check.equal(f'{what}: said aloud', page.run('return document.querySelector(".notice").textContent'), told(pixel).split('\n')[0])
        check.equal(f'{what}: the command', page.run('return document.querySelector("[data-part=command]").textContent'),
                    f'gradus {shlex.join(words)} --why {pixel}')

    left, top, width, high, columns, rows = page.run("""const image = document.images[0], box = image.getBoundingClientRect();
        return [box.left, box.top, box.width, box.height, image.naturalWidth, image.naturalHeight]""")
    column, row = columns // 2, rows * 11 // 20
    page.click(round(left + (column + 0.5) * width / columns), round(top + (row + 0.5) * high / rows))
    shows('a click', f'{column},{row}')
    page.press('ArrowRight', 'ArrowDown', 'Enter')
    shows('keys', f'{column + 1},{row + 1}')
    page.run('document.querySelector("[data-part=column]").focus(); document.activeElement.value = "3"')
    page.press('Enter')
    shows('numbers', f'3,{row + 1}')
    fits(check, page, 'picture')
    theme_switch(check, page, 'picture')
    no_errors(check, page, 'picture')
    page = Page(browser, path, f'#pixel={columns - 1},{rows - 1}')
    shows('an address', f'{columns - 1},{rows - 1}')


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    if not shutil.which('chromium') or not shutil.which('chromedriver'):
        print('chromium or chromedriver is missing')
        sys.exit(77)
    check = Checks()
    with Browser() as browser:
        gallery(check, browser, folder)
        lecture(check, browser, pathlib.Path(sys.argv[2]).resolve())
        pages = sorted(folder.glob('topics/*/*.html'))
        check.that('topic pages', len(pages) > 1, pages)
        for path in share_of(pages, 9):
            topic_page(check, browser, path)
        errata(check, browser, folder / 'errata.html')
        picture(check, browser, pathlib.Path(sys.argv[3]).resolve())
    print(f'{check.passed} passed, {len(check.failed)} failed')
    sys.exit(bool(check.failed))


if __name__ == '__main__':
    main()
