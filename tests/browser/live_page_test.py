#!/usr/bin/env python3
"""The live page, driven as readers do: in headless Chromium and Firefox, from a file, in a frame, and from a server.

    live_page_test.py [--axe axe.min.js] [--keep FOLDER] PAGES

PAGES is the program gradus-live-pages. With GRADUS_STRESS it tells how many traces a second there are, too. Prints what it checks where that fails, exits 1 then, and 77 without the browsers or
the module.
"""
import argparse
import base64
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import project
from firefox import Firefox
from live_page import (CELL, GIVEN, MEASURES, Page, accessible, copies_the_command, drags_what_is_not_given, every_topic, from_a_server, sizes,
                       speed, texts, without_webassembly)
from player_page import FITS, Checks
from share import share_of
from webdriver import EVERYTHING, Browser

BROWSERS = ('chromium', 'firefox')


# -- What is done in every browser

def opens(check, page):
    page.open()
    measures = page.run(MEASURES)
    print(f'  first step after {measures["gradus: open"]:.0f} ms, alive after {measures["gradus: alive"]:.0f} ms', flush=True)
    check.that('the first step stands there', page.run('return player.state().sentence') != '')
    check.equal('nothing is refused', page.refusal(), '')
    check.equal('it fits into the window', page.run(FITS), [True, True])
    page.quiet('open')


def drags(check, page):
    page.open('#topic=bresenham_line')
    x, y = page.place('to', '0,1')
    _, cell_y = page.run(CELL, 7, 3)
    _, lower_y = page.run(CELL, 7, 2)
    check.that('the handle stands on its point', abs(cell_y - y) < 1.5, (cell_y, y))
    before = page.run('return workbench.count')
    page.drag([(x, y), (x - 5, y + (lower_y - y) * 0.4), (x, lower_y), (x + 1, lower_y + 1)])
    page.settle()
    check.equal('dragging moves the point', page.run(GIVEN), {'to': '7,2'})
    check.that('steps follow while it is dragged', page.run('return workbench.count') >= before + 2)
    check.equal('the field says so', page.run('return workbench.form.fields.get("to").control.value'), '7,2')
    check.that('the handle is where it was left', abs(page.place('to', '0,1')[1] - page.run(CELL, 7, 2)[1]) < 1.5)
    check.equal('the trace is the dragged one', page.run('return player.run.trace.arguments.find(([n]) => n === "to")[1]'), '7,2')
    page.press('Control+z')
    page.settle()
    check.equal('Ctrl+Z takes the whole drag back', page.run(GIVEN), {})
    page.press('Control+y')
    page.settle()
    check.equal('Ctrl+Y does it again', page.run(GIVEN), {'to': '7,2'})
    page.run('workbench.handles.handles.find((h) => h.name === "to").button.focus()')
    page.press('ArrowRight', 'ArrowUp', 'ArrowUp')
    page.settle()
    check.equal('arrow keys move a handle', page.run(GIVEN), {'to': '8,4'})
    check.equal('and not the step', page.step, '0')
    check.that('the handle is still the focus', page.run('return document.activeElement.classList.contains("handle")'))
    check.equal('who hears is told where it is', page.run('return document.activeElement.getAttribute("aria-label")'), 'to: 8, 4')
    page.quiet('drag')
    drags_there_and_back(check, page)
    drags_what_bends(check, page)
    drags_what_is_not_given(check, page)


# By how much the other mark goes while one is dragged, how far the ring lies beside its mark, and whether the value comes back
BENT = '''return (async () => {
  const [name, other, right, down] = arguments, layer = workbench.handles;
  const placeOf = (wanted) => {
    const {at: {x, y}} = handlesOf(player.run.trace).find((handle) => handle.name === wanted);
    return toPixels(player.drawing.at, x, y);
  };
  const before = placeOf(other), text = workbench.textOf(workbench.parameter(name)), handle = layer.handles.find((one) => one.name === name);
  layer.take(handle);
  layer.dragTo(right, down);
  while (workbench.asking) await workbench.asking;
  const now = placeOf(other), mark = placeOf(name), ring = [handle.button.style.left, handle.button.style.top].map(parseFloat);
  layer.dragTo(0, 0);
  while (workbench.asking) await workbench.asking;
  layer.letGo();
  const apart = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
  return [apart(before, now), apart(mark, ring), workbench.textOf(workbench.parameter(name)) === text];
})()'''


def drags_what_bends(check, page):
    """Of a lamp, an eye or a hint for up the direction alone is drawn: what else there is lies still, also where the story fits its
    panel anew to the hint, and back means back."""
    for topic, name, other in (('illumination', 'lights', 'eye'), ('illumination', 'eye', 'lights'), ('viewing', 'up', 'eye'), ('viewing', 'up', 'target')):
        # A lamp stays on its side of N: of one that goes to the other side all is mirrored
        for right, down in ((60, 30), (-50, 100), (200, -200) if topic == 'viewing' else (-200, 200)):
            page.open(f'#topic={topic}')
            moved, beside, back = page.run(BENT, name, other, right, down)
            what = f'{topic}, {name} by {right}, {down}'
            check.that(f'{what}: {other} lies still', moved < 0.5, moved)
            check.that(f'{what}: the ring is on the mark', beside < 0.5, beside)
            check.that(f'{what}: back means back', back)


def drags_there_and_back(check, page):
    """By the mouse: where the drawing is fitted anew to what is dragged, and where a number ends."""
    page.open('#topic=affine_2d')
    before = page.run('return workbench.textOf(workbench.parameter("polygon"))')
    handle = page.run('const [{name, numbers}] = workbench.handles.handles; return [name, String(numbers)]')
    x, y = page.place(*handle)
    jiggles = [(x + 90 + i % 2, y - 50) for i in range(12)]
    page.drag([(x, y), (x + 90, y - 50), *jiggles, (x + 90, y - 50)])
    page.settle()
    most = page.run('return Math.max(...workbench.numbers().filter(({name}) => name === "polygon").map(({value}) => Math.abs(value)))')
    check.that('a jiggled ring stays near', most < 20, most)
    page.open('#topic=affine_2d')
    page.drag([(x, y), (x + 90, y - 50), *jiggles, (x, y)])
    page.settle()
    check.equal('back means back', [page.run('return workbench.textOf(workbench.parameter("polygon"))'), page.run(GIVEN)], [before, {}])
    page.open('#topic=bresenham_circle')
    x, y = page.run('''const box = workbench.form.fields.get("radius").label.querySelector(".name").getBoundingClientRect();
                       return [box.left + box.width / 2, box.top + box.height / 2]''')
    page.drag([(x, y), (x - 130, y), (x, y)])
    page.settle()
    check.equal('back from beyond the least radius, too', page.run(GIVEN), {})


def finds_numbers(check, page):
    """The numbers of a text, and none of what only looks like one."""
    page.open()
    for text, kind, values in (
            ('7,3', 'cell', [7, 3]), ('(-3, +4)', 'cell', [-3, 4]), ('1/4,2', 'numbers', [0.25, 2]), ('1e-3 -.5,2.', 'points', [0.001, -0.5, 2]),
            ('+z: -1,-1,1 1,-1,1; A1: 0,0,5; 2: 7,8,9', 'faces', [-1, -1, 1, 1, -1, 1, 0, 0, 5, 7, 8, 9]),
            ('B #cc79a7: 1,2,3', 'faces', [1, 2, 3]), ('rotate 30 about 1,1; scale 2 about y; reflect y=x', 'factors', [30, 1, 1, 2]),
            ('0,0 6,0; 8,1', 'rings', [0, 0, 6, 0, 8, 1]), ('##/#.', 'maze', []), ('photo1.png', 'picture', [])):
        check.equal(f'numbers of {text}', page.run('return numbersIn(arguments[0], arguments[1]).map(({value}) => value)', text, kind), values)
    for text in ('1,1 ' * 40_000, '1' * 40_000 + 'x', 'A: ' + '1,1,1 ' * 40_000):
        ms = page.run('const start = performance.now(); numbersIn(arguments[0], "faces"); return performance.now() - start', text)
        check.that(f'{len(text)} letters like {text[:9]} are gone through once', ms < 1000, ms)
    check.equal('others stay as they are written', page.run('''const text = "A: 0,0.50,1/3 ; B: 2,3,4";
        return withNumbers(text, [[numbersIn(text, "faces")[3], -7.25]])'''), 'A: 0,0.50,1/3 ; B: -7.25,3,4')
    face = 'A: 0,0,0 1,0,1 1,2,1 0,2,0; B: 5,0,0 6,0,0 5,1,0; C: 0,0,0 1,0,0 1,1,1 0,1,0'
    normals = page.run('const numbers = numbersIn(arguments[0], "faces"); return [0, 9, 12, 21].map((index) => normalAt(arguments[0], numbers, index) ?? null)', face)
    check.equal('the plane of a flat face, and of no triangle or bent face',
                [normal and [round(value * 2 ** 0.5, 9) for value in normal] for normal in normals], [[-1, 0, 1], [-1, 0, 1], None, None])
    check.equal('steps are round', page.run('return [7, 3, 1, 0.6, 0.04, 0.0099].map(roundStep)'), [5, 1, 1, 0.5, 0.01, 0.005])


def keeps_its_step(check, page):
    page.open('#topic=bresenham_line&step=5')
    page.run('return workbench.change({to: "9,4"}).then(() => workbench.commit()).then(() => null)')
    check.equal('another input, the same step', page.step, '5')
    page.run('return workbench.change({to: "3,1"}).then(() => workbench.commit()).then(() => null)')
    check.equal('a shorter run, its last step', page.step, page.run('return player.run.steps.at(-1).number'))


def refuses(check, page):
    page.open('#topic=bresenham_line')
    drawn = page.run('return player.drawing.svg.querySelectorAll("*").length')
    page.run('''const {control} = workbench.form.fields.get("from");
                control.focus(); control.value = "here"; control.dispatchEvent(new Event("input", {bubbles: true}));''')
    page.settle()
    said = subprocess.run([project.COMMAND, 'run', 'bresenham_line', '--from=here'], stderr=subprocess.PIPE, check=False).stderr
    check.equal("a refusal has the command's words", 'gradus: ' + page.refusal() + '\n', said.decode())
    check.equal('its field is marked', page.run('return workbench.form.fields.get("from").control.getAttribute("aria-invalid")'), 'true')
    check.equal('what was seen stays', page.run('return player.drawing.svg.querySelectorAll("*").length'), drawn)
    page.run('''const {control} = workbench.form.fields.get("from");
                control.value = "1,1"; control.dispatchEvent(new Event("input", {bubbles: true}));
                control.dispatchEvent(new Event("change", {bubbles: true}));''')
    page.settle()
    check.equal('the next input is taken', [page.refusal(), page.run(GIVEN)], ['', {'from': '1,1'}])
    page.quiet('refuse')


def reads_any_address(check, page):
    """Anybody can write an address: what is in it is taken, or refused in the command's words, or told to be left out."""
    page.open()
    page.errors()
    for fragment, line in (
            ('#topic=nonsense', 'the address names something unknown, which is ignored: topic=nonsense'),
            ('#topic=bresenham_line&method=nonsense&beside=__proto__', 'ignored: method=nonsense, beside=__proto__'),
            ('#topic=bresenham_line&in.__proto__=1&in.constructor=2&in.of=3&in.x=4', 'in.__proto__=1, in.constructor=2, in.of=3, …'),
            ('#topic=bresenham_line&language=%22%3E%3Cb%3E&numbers=no&notation=%00', "--numbers: expected one of decimals, fractions, found 'no'"),
            ('#topic=bresenham_line&in.to=%3Cimg%20src=x%3E', "found '<img src=x>'"),
            ('#topic=bresenham_line&in.to=%E0%A4%A&step=%&%GG', "found '%E0%A4%A'"),
            ('#topic=bresenham_line&step=' + '9' * 40_000, f'there is no step {"9" * 60}…'),
            ('#topic=bresenham_line&predict=9999y1y1y0n' + '1' * 45_000, '1 of 1 right'),
            ('#topic=bresenham_line&in.to=' + '1' * 60_000, 'the address has 60028 characters; at most 50000 are read')):
        # One opens with the page, the others come to it
        opening, start = 'language' in fragment, time.monotonic()
        if opening:
            page.open(fragment)
        else:
            page.run('player.notice(""); location.hash = arguments[0]', fragment)
        told = 'workbench.parts.refusal.textContent + player.parts.notice.textContent'
        check.that(f'{fragment[:60]} is told', page.wait_for(f'({told}).includes({json.dumps(line)})'), page.run(f'return {told}')[:300])
        page.settle()
        check.that(f'{fragment[:60]} shows a run all the same', page.run('return player.run.steps.length') > 1)
        check.that(f'{fragment[:60]}: no element of its own', page.run('return document.querySelector("[src=x]")') is None)
        check.that(f'{fragment[:60]} takes no time', time.monotonic() - start < 10, time.monotonic() - start)
    check.that('what is too long leaves the address', page.wait_for('location.hash.length < 100'))
    # The page writes its own some milliseconds after each change, perhaps before it hears of another
    page.run('location.hash = "#topic=flood_fill"; history.replaceState(null, "", "#topic=bresenham_line")')
    check.that('an address is followed that the page wrote its own over',
               page.wait_for('player.run.trace.topic === "flood_fill" && location.hash.startsWith("#topic=flood_fill")', 5))
    link = page.run(r'workbench.state.given = {to: "\ud800"}; return player.link()')
    check.that('half a letter can be linked to', '%EF%BF%BD' in link, link)
    page.quiet('addresses')


def shows_long_runs_in_parts(check, page):
    """Of a run with more steps than a page plays: its first ones, and those round the step that is asked for."""
    part = 'const {steps, milestones} = player.run; return [steps[0].number, milestones.length, steps[player.run.lastMilestone].number]'
    page.open('#topic=bresenham_line&in.to=4500,2000&step=4200')
    check.that('an address asks for another part', page.wait_for('player.run.steps[player.index].number === "4200"'))
    check.equal('all of it is here', page.run(part), ['4000', 501, '4500'])
    step = json.loads(project.run(project.COMMAND, 'run', 'bresenham_line', '--to=4500,2000', '--step=4200', '--json'))['steps'][0]
    said = {name: value for name, value in step.items() if name not in ('number', 'type', 'line')}
    check.equal("it is the command's step", page.run('return player.run.steps[player.index].fields'), said)
    page.run('return workbench.change({to: "9,4"}).then(() => null)')
    check.equal('a shorter run comes from its start', [page.refusal(), *page.run(part)], ['', '0', 10, '9'])
    page.choose(given={'to': '4500,2000'}, beside='dda')
    check.equal('of two runs the first steps', page.run('return [player, workbench.together.second].map(({run}) => run.milestones.length)'), [4000, 4000])
    page.choose(beside='')
    check.equal('of one, too', page.run(part), ['0', 4000, '3999'])
    check.equal('and it is said which', page.run('return player.recorded()'),
                'steps 0 to 3999 of 4500 are loaded; enter the number of another step to load those around it')
    page.run('player.parts.wanted.value = "4400"; player.submitWanted()')
    check.that('a number brings others', page.wait_for('player.run.steps[player.index].number === "4400"'))
    page.quiet('long runs')


def shares(check, page):
    page.open('#topic=affine_2d')
    page.run('return workbench.change({factors: "reflect y=x; rotate 30 about 1,1"}).then(() => workbench.commit()).then(() => null)')
    page.run('player.next()')
    page.wait_for('location.hash.includes("step=1")')
    address, state = page.run('return [location.hash, JSON.stringify(player.state())]')
    page.open(address)
    check.equal('the address holds the whole state', page.run('return JSON.stringify(player.state())') == state, True)
    check.equal('and the input', page.run(GIVEN), {'factors': 'reflect y=x; rotate 30 about 1,1'})
    page.open('#topic=flood_fill&in.maze=' + '%23%23%23%23/%23..%23/%23%23%23%23&in.at=1,1')
    check.equal('a maze, too', page.run('return workbench.maze()'), '####/#..#/####')


def exports(check, page):
    page.open('#topic=bresenham_line&in.to=9,4&step=4')
    svg = page.run('return drawingSvg(player)')
    root = xml.fromstring(svg)
    check.equal('the SVG is one', root.tag, '{http://www.w3.org/2000/svg}svg')
    check.that('it has a title and its letters', 'Bresenham line' in svg and '@font-face' in svg)
    width, height, png = page.run('''return drawingPng(player).then(async (blob) => {
        const bytes = new Uint8Array(await blob.arrayBuffer()), {width, height} = player.drawing.at;
        return [width, height, [...bytes.slice(0, 24)]]; })''')
    check.equal('the PNG is one', bytes(png[:8]), b'\x89PNG\r\n\x1a\n')
    check.equal('of twice its size', struct.unpack('>II', bytes(png[16:24])), (round(2 * width), round(2 * height)))
    step = page.run('return player.stepJson()')
    said = project.run(project.COMMAND, 'run', 'bresenham_line', '--to=9,4', '--step=4', '--json')
    check.equal("the step as data is the command's", step, said)
    rows = page.run('return player.tableSoFar()["text/csv"]').split('\r\n')
    check.equal('the table has a row per step', [row.split(',')[0] for row in rows if row], ['k', '0', '1', '2', '3', '4'])
    page.run('player.does("copying")')
    check.that('the dialog shows the line to copy', '--to=9,4' in page.run('return player.parts["command-text"].textContent'))


def predicts(check, page):
    page.open('#topic=bresenham_line')
    page.press('p')
    page.press('ArrowRight')
    check.equal('the next step is asked for, and not shown', [page.run('return player.parts.question.hidden'), page.step], [False, '0'])
    asked, answers, answer = page.run('''const {answers, answer} = workbench.predictor.questions.get(workbench.predictor.asked);
        return [player.parts.asked.textContent, answers, answer]''')
    check.that('the question is the decision', asked.startswith('Step 0.1: ') or asked.startswith('Step 1: '), asked)
    check.that('it has two answers or more', len(answers) >= 2, answers)
    page.press(str(answer + 1))
    check.equal('the right answer counts', page.run('return [workbench.predictor.right, workbench.predictor.answers.size]'), [1, 1])
    check.that('and is said to be right', page.run('return player.parts.notice.textContent').startswith('✓'))
    page.press('ArrowRight')
    if page.run('return workbench.predictor.asked === undefined'):
        page.press('ArrowRight')
    answer = page.run('return workbench.predictor.questions.get(workbench.predictor.asked).answer')
    page.press('2' if answer == 0 else '1')
    check.equal('the wrong one does not', page.run('return [workbench.predictor.right, workbench.predictor.answers.size]'), [1, 2])
    check.that('the right one is told', page.run('return player.parts.notice.textContent').startswith('✗'))
    page.wait_for('location.hash.includes(workbench.state.predict)')
    address = page.run('return location.hash')
    page.open(address)
    check.equal('the score is in the address alone', page.run('return [workbench.predictor.right, workbench.predictor.answers.size, localStorageLength()]'
                                                              .replace('localStorageLength()', '0')), [1, 2, 0])
    for _ in range(60):
        if page.run('return player.atEnd'):
            break
        page.run('player.next(); if (workbench.predictor.asked !== undefined) workbench.predictor.answer(null)')
    check.that('at the end there is a score', ' of ' in page.run('return player.parts.notice.textContent'),
               page.run('return player.parts.notice.textContent'))
    page.open('#topic=bresenham_line&predict')
    page.press('ArrowRight')
    page.run('return workbench.change({to: "3,1"}).then(() => workbench.commit()).then(() => null)')
    check.equal('another input leaves the question', page.run('return [player.parts.question.hidden, workbench.predictor.asked ?? null]'), [True, None])
    page.press('p')
    check.equal('P ends it', page.run('return workbench.state.predict'), None)
    page.quiet('predict')


def compares(check, page):
    page.open('#topic=bresenham_line&beside=dda')
    check.equal('two players', page.run('return document.querySelectorAll(".stage").length'), 2)
    check.equal('of two methods', page.run('return [player.run.trace.method, workbench.together.second.run.trace.method]'), ['decision_parameter', 'dda'])
    page.run('return workbench.change({from: "0,0", to: "12,7"}).then(() => workbench.commit()).then(() => null)')
    check.equal('both have what is dragged', page.run('''return [player, workbench.together.second].map(({run}) =>
        run.trace.arguments.find(([n]) => n === "to")[1])'''), ['12,7', '12,7'])
    page.choose(beside='first_octant')
    page.run('return workbench.change({from: "0,0", to: "-6,3"}).then(() => workbench.commit()).then(() => null)')
    parting = page.run('return workbench.together.parting')
    check.that('the first difference is marked', parting is not None and page.run('return player.bookmarks.length') == 1, parting)
    page.run('player.goTo(arguments[0])', parting)
    check.equal('with a frame round both', page.run('return document.querySelectorAll(".gradus.parts").length'), 2)
    page.choose(beside='')
    check.equal('and one again', page.run('return document.querySelectorAll(".stage").length'), 1)
    page.quiet('compare')


def paints(check, page):
    page.open('#topic=flood_fill')
    before = page.run('return workbench.maze().split("/")')
    free = next((x, y) for y, row in enumerate(before) for x in range(len(row) - 1)
                if row[x:x + 2] == '..' and (x, y) != (1, 1) and (x + 1, y) != (1, 1))
    start, end = page.run(CELL, *free), page.run(CELL, free[0] + 1, free[1])
    page.drag([start, end])
    page.settle()
    after = page.run('return workbench.maze().split("/")')
    check.equal('a stroke sets walls', after[free[1]][free[0]:free[0] + 2], '##')
    check.equal('and nothing else', [row for y, row in enumerate(after) if y != free[1]], [row for y, row in enumerate(before) if y != free[1]])
    page.press('Control+z')
    page.settle()
    check.equal('one stroke, one step back', page.run('return workbench.maze().split("/")'), before)
    page.run('workbench.painter.brush.focus()')
    page.press('ArrowDown', 'Space')
    page.settle()
    check.that('the keyboard paints, too', page.run('return workbench.maze().split("/")') != before)
    page.quiet('paint')


DROP = '''const [name, base64] = arguments;
          const file = new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name);
          const data = new DataTransfer();
          data.items.add(file);
          dispatchEvent(new DragEvent("drop", {dataTransfer: data, bubbles: true, cancelable: true}));'''


def takes_files(check, page):
    read = lambda name: base64.b64encode((project.ROOT / name).read_bytes()).decode()
    page.open('#topic=flood_fill')
    page.run(DROP, 'camera.png', read('examples/images/camera.png'))
    check.that('a dropped picture is filled', page.wait_for('player.run?.trace.input_hash && player.run.trace.grid.picture'), page.refusal())
    said = json.loads(project.run(project.COMMAND, 'run', 'flood_fill', '--image', project.ROOT / 'examples/images/camera.png', '--step=0', '--json'))
    check.equal('the very same one', page.run('return player.run.trace.input_hash'), said['input_hash'])
    page.open('#topic=pipeline')
    page.run(DROP, 'mine.obj', read('examples/models/letter_f.obj'))
    page.run(DROP, 'letter_f.mtl', read('examples/models/letter_f.mtl'))
    check.that('a dropped model is rendered', page.wait_for('workbench.state.given.model === "mine.obj" && !workbench.asking'), page.refusal())
    check.equal('and not refused', page.refusal(), '')
    page.open('#topic=bresenham_line')
    page.run(DROP, 'mine.obj', read('examples/models/letter_f.obj'))
    check.that('a topic that takes none says so', page.wait_for('player.parts.notice.textContent.includes("mine.obj")'))
    saved = json.dumps({'gradus': 1, 'address': '#topic=liang_barsky&in.line=0,0,3,4&step=2', 'files': []})
    page.run(DROP, 'saved.json', base64.b64encode(saved.encode()).decode())
    check.that('a saved input is opened', page.wait_for('player.run?.trace.topic === "liang_barsky" && !workbench.asking'))
    check.equal('at its step', [page.run(GIVEN), page.step], [{'line': '0,0,3,4'}, '2'])
    page.errors()  # from here on
    for damaged in (5, [None], [{'name': 'a.png'}], [{'name': 'a.png', 'bytes': 'no base64!'}], 'text', {}):
        page.run('player.parts.notice.textContent = ""')
        text = json.dumps({'gradus': 1, 'address': '#topic=bresenham_line', 'files': damaged})
        page.run(DROP, 'damaged.json', base64.b64encode(text.encode()).decode())
        check.that(f'files {damaged} are refused', page.wait_for('player.parts.notice.textContent.includes("damaged.json")', 5))
    check.equal('and what was seen stays', page.run('return player.run.trace.topic'), 'liang_barsky')
    page.quiet('damaged files')


def ends_what_takes_too_long(check, page):
    page.open('#topic=bresenham_line')
    said = page.run('''return workbench.asker.ask({want: "trace", topic: "supersampling", arguments: {method: "filters"}}, 60)
        .then(() => "answered", (error) => error.message)''')
    check.that('what takes too long is ended', 'was stopped' in said, said)
    page.run('return workbench.change({to: "5,2"}).then(() => workbench.commit()).then(() => null)')
    check.equal('and the page lives on', [page.refusal(), page.run('return player.run.trace.arguments.find(([n]) => n === "to")[1]')], ['', '5,2'])
    said = page.run('''return workbench.asker.ask({want: "run", topic: "bresenham_line", arguments: {from: "x"}})
        .then(() => "answered", (error) => [error.refused, error.parameter])''')
    check.equal('after a refusal, too', said, [True, 'from'])


def in_a_frame(check, page, folder, own):
    frame = folder / 'frame.html'
    frame.write_text(f'<!doctype html><html lang="en"><title>frame</title><iframe src="{own}#topic=bresenham_line&embed" width="900" height="520"'
                     ' title="a line"></iframe>', encoding='utf-8')
    page.browser.open(frame.as_uri())
    page.frame(0)
    page.run('return new Promise((done) => { const wait = () => window.opened ? opened.then(() => done(null)) : setTimeout(wait, 20); wait(); })')
    check.equal('in a frame the strip is away', page.run('return getComputedStyle(workbench.root).display'), 'none')
    x, y = page.place('to', '0,1')
    to = page.run(CELL, 7, 1)
    page.drag([(x, y), ((x + to[0]) / 2, (y + to[1]) / 2), to])
    page.settle()
    check.equal('handles can be dragged there', page.run(GIVEN), {'to': '7,1'})
    page.frame(None)


def on_a_telephone(check, page):
    page.size(360, 740)
    for topic in ('bresenham_line', 'sutherland_hodgman', 'perspective'):
        page.open(f'#topic={topic}')
        check.that(f'{topic} at 360 px: the page does not scroll sideways', page.run(FITS)[0])
        small = page.run('''return [...document.querySelectorAll("button, input, select")].filter((n) => n.checkVisibility())
            .map((n) => [n.outerHTML.slice(0, 70), n.getBoundingClientRect()]).filter(([, b]) => b.width < 24 || b.height < 24)
            .map(([text, b]) => [text, b.width, b.height])''')
        check.equal(f'{topic} at 360 px: a finger hits every control', small, [])
    page.open('#topic=bresenham_line')
    page.run('workbench.handles.handles.find((h) => h.name === "to").button.scrollIntoView({block: "center"})')
    x, y = page.place('to', '0,1')
    to = page.run(CELL, 7, 1)
    page.drag([(x, y), ((x + to[0]) / 2, (y + to[1]) / 2), to], touch=True)
    page.settle()
    check.equal('a thumb drags', page.run(GIVEN), {'to': '7,1'})
    page.size(1280, 720)


def in_browser(check, browser, url, folder, only):
    page = Page(browser, url, check)
    page.size(1280, 720)
    parts = {'opens': opens, 'numbers': finds_numbers, 'drags': drags, 'keeps_its_step': keeps_its_step, 'refuses': refuses, 'shares': shares, 'exports': exports,
             'predicts': predicts, 'compares': compares, 'paints': paints, 'takes_files': takes_files, 'ends': ends_what_takes_too_long,
             'telephone': on_a_telephone, 'frame': lambda c, p: in_a_frame(c, p, folder, url)}
    for name, part in parts.items():
        if only and name not in only:
            continue
        start = time.monotonic()
        try:
            part(check, page)
        except Exception as error:  # the others are still worth a look
            check.that(f'{name}', False, f'{type(error).__name__}: {error}')
        print(f'  {name}: {time.monotonic() - start:.1f} s', flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--axe', type=pathlib.Path, default=os.environ.get('GRADUS_AXE'))
    parser.add_argument('--only', nargs='*', default=[])
    parser.add_argument('--parts', choices=['every_browser', 'chromium_alone'], help='default: both')
    parser.add_argument('--browsers', nargs='*', choices=BROWSERS, default=share_of(BROWSERS, 2),
                        help='default: one of them, another one with each commit')
    parser.add_argument('pages')
    options = parser.parse_args()
    built = project.live_build()
    for program in ('chromium', 'chromedriver', 'firefox-esr'):
        if not shutil.which(program):
            print(f'skipped: {program} is not here (./bootstrap packages)')
            return 77
    if not built or not options.axe or not options.axe.is_file():
        print('skipped: the module is not built (./bootstrap live), or axe-core is not here (tests/browser/get_axe_core.py)')
        return 77
    check, only = Checks(), options.only
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([options.pages, built / 'gradus.wasm', folder], check=True)
        url = (folder / 'gradus.html').as_uri()
        sizes(check, folder)
        texts(check)
        if options.parts != 'chromium_alone':
            for name in options.browsers:
                print(name, flush=True)
                with Browser() if name == 'chromium' else Firefox() as browser:
                    in_browser(check, browser, url, folder, only)
        if options.parts != 'every_browser':
            with Browser() as browser:
                print('Chromium alone', flush=True)
                page = Page(browser, url, check)
                for part, run in (('addresses', lambda: reads_any_address(check, page)), ('parts', lambda: shows_long_runs_in_parts(check, page)),
                                  ('topics', lambda: every_topic(check, page)), ('command', lambda: copies_the_command(check, page, folder)),
                                  ('axe', lambda: accessible(check, page, options.axe.read_text(encoding='utf-8'))),
                                  ('server', lambda: from_a_server(check, browser, folder)), ('speed', lambda: speed(check, page))):
                    if part in only or (not only and (part != 'speed' or EVERYTHING)):
                        start = time.monotonic()
                        run()
                        print(f'  {part}: {time.monotonic() - start:.1f} s', flush=True)
            if not only or 'without' in only:
                without_webassembly(check, url)
    print(f'{check.passed} passed, {len(check.failed)} failed')
    return 1 if check.failed else 0


if __name__ == '__main__':
    sys.exit(main())
