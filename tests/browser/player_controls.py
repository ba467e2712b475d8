"""By hand: keys and mouse, playing both ways, loops and bookmarks."""

from player_page import Page, no_noise


def differences(check, browser, made):
    """A fault's listing: what is struck out has a line through it and a sign, no number, and no step."""
    page = Page(browser, made / 'faulty.html', '#step=1')
    rows = page.run('''return [...player.parts.lines.children].slice(4, 9).map((line) => [
        line.firstChild.textContent, getComputedStyle(line, "::before").content.replaceAll('"', ""),
        getComputedStyle(line.lastChild).textDecorationLine, line.lastChild.getAttribute("role"), line.className])''')
    check.equal('lines struck out and put in', rows, [
        ['5', 'none', 'none', None, ''], ['', '−', 'line-through', 'deletion', ''], ['', '−', 'line-through', 'deletion', ''],
        ['6', '+', 'none', 'insertion', 'strong'], ['7', 'none', 'none', None, '']])
    check.equal('the last one keeps its number', page.run('return player.parts.lines.lastChild.firstChild.textContent'), '12')
    page.click_on('#player li[data-position="5"]')
    check.equal('a line that is struck out leads nowhere', [page.step, page.run('return player.parts.notice.textContent')],
                ['1', 'no step executes this line'])
    page.click_on('#player li[data-position="7"]')
    check.that('one that is put in does', page.step != '1', page.step)
    no_noise(check, page, 'faulty.html')


def keyboard_and_mouse(check, browser, made):
    page = Page(browser, made / 'line.html')
    check.equal('the goal stands at step 0', 'Choose, column by column' in page.state()['sentence'], True)
    check.equal('the footer counts', page.state()['position'], 'step 0 / 7 · set up')
    for _ in range(3):
        page.press('ArrowRight')
    state = page.state()
    check.equal('three times →', state['step'], '3')
    check.equal('the table grew a row per step', len(state['table']), 4)
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
    # The first of what it shows: on a busy machine the next step comes before anyone looks
    page.run('const show = player.show; player.show = function (index) {'
             'show.call(this, index); window.first ??= this.run.steps[this.index].number; }')
    page.press('v')
    check.equal('from step 0 it starts at the end', [page.run('return first'), page.state()['pace']], ['7', -1])
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
