"""The live page in a browser, and what holds for all of it: every topic, its drawing, its accessibility, its size."""

import functools
import http.server
import itertools
import pathlib
import re
import shlex
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree as xml
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import project
from axe_test import READ
from share import in_share, share_of
from webdriver import EVERYTHING, Browser

A_TOPIC = 59_000  # bytes of the page, packed, that each topic may take, with its share of what all use
MEASURES = 'return Object.fromEntries(performance.getEntriesByType("measure").map((m) => [m.name, m.duration]))'
# The middle of the handle that moves these numbers of this argument, in the window
PLACE = '''const handle = workbench.handles.handles.find((h) => h.name === arguments[0] && String(h.numbers) === arguments[1]);
           if (!handle || handle.button.hidden) return null;
           const box = handle.button.getBoundingClientRect();
           return [box.left + box.width / 2, box.top + box.height / 2];'''
CELL = '''const {at} = player.drawing, box = player.parts.drawing.getBoundingClientRect();
          const [x, y] = toPixels(at, arguments[0], arguments[1]);
          return [box.left + x, box.top + y];'''
GIVEN = 'return workbench.state.given'


class Page:
    """The live page in a browser, at a state."""

    def __init__(self, browser, url, check):
        self.browser, self.url, self.check = browser, url, check

    def __getattr__(self, name):
        return getattr(self.browser, name)

    def open(self, fragment=''):
        self.browser.open('about:blank')
        self.browser.open(self.url + fragment)
        self.run('return opened.then(() => null)')
        return self

    def choose(self, **changes):
        self.run('return workbench.choose(arguments[0]).then(() => null)', changes)

    def settle(self):
        """Waits until what was asked has been answered."""
        self.run('return (async () => { while (workbench.asking) await workbench.asking; })()')

    def wait_for(self, condition, seconds=20):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.run(f'return Boolean({condition})'):
                return True
            time.sleep(0.05)
        return False

    def place(self, name, numbers):
        found = self.run(PLACE, name, numbers)
        if found is None:
            raise AssertionError(f'there is no handle of {name} {numbers}')
        return found

    def refusal(self):
        return self.run('return workbench.parts.refusal.hidden ? "" : workbench.parts.refusal.textContent')

    @property
    def step(self):
        return self.run('return player.run.steps[player.index].number')

    def quiet(self, what):
        self.check.equal(f'{what}: nothing on the console', self.errors(), [])


# -- Its texts

def texts(check):
    """What the page's scripts say is there in every language, and nothing is there that nothing says."""
    folder = project.ROOT / 'visualize/web'
    scripts = ''.join(path.read_text(encoding='utf-8') for path in sorted((folder / 'workbench').glob('*.js')))
    asked = {key for call in re.findall(r'\bsay\(([^;{,)]*)', scripts) for key in re.findall(r"'(\w+)'", call)}
    places = set(re.findall(r'{{say ([\w.]+)}}', (folder / 'workbench/workbench.html').read_text(encoding='utf-8')))
    sources = (folder / 'live_page.cpp').read_text(encoding='utf-8')
    for code in ('en', 'de'):
        known = {'player': set(), 'player.said': set(), 'live': set(), 'live.said': set()}
        section = ''
        for line in (project.ROOT / f'visualize/figure/language/{code}.txt').read_text(encoding='utf-8').splitlines():
            if line.startswith('['):
                section = line.strip('[]')
            elif ' = ' in line and section in known:
                known[section].add(line.split(' = ')[0])
        check.equal(f'{code}: the scripts ask for existing texts', sorted(asked - known['live.said'] - known['player.said'] - {'step'}), [])
        check.equal(f'{code}: the strip, too', sorted(places - known['live'] - known['player'] - {f'said.{key}' for key in known['live.said']}), [])
        used = {key for key in known['live.said'] if key in asked or f'said.{key}' in places}
        check.equal(f'{code}: no text is for nothing', sorted(known['live.said'] - used)
                    + sorted(key for key in known['live'] if key not in places and f'live.{key}' not in sources), [])


# -- Its drawing is that of the figures

def copies_the_command(check, page, folder):
    """What `gradus figure` draws and what the page shows are the same drawing, but for its size."""
    for fragment in ('#topic=bresenham_line&in.to=9,4&step=4', '#topic=sutherland_hodgman&step=6',
                     '#topic=cohen_sutherland_2d&step=2', '#topic=perspective&step=3', '#topic=z_buffer&step=20', '#topic=bresenham_circle&in.radius=6&step=3&language=de'):
        page.open(fragment)
        command = page.run('return player.commandNow()')
        words = shlex.split(command)
        check.that(f'{command}: names its step', f'--step={page.step}' in words)
        figure = folder / words[-1]
        subprocess.run([project.COMMAND, *words[1:-1], figure, '-q'], check=True)
        same_geometry(check, command, figure, page)
        figure.unlink()


SHOWN = '''const out = [], {at} = player.drawing;
    for (const node of player.drawing.svg.querySelectorAll("[data-id]")) {
      const {id} = node.dataset;
      if (out.some(([other]) => other === id)) continue;  // an arrow's head is as large in every drawing
      if (node.tagName === "circle") out.push([id, [[Number(node.getAttribute("cx")), Number(node.getAttribute("cy"))]]]);
      if (node.tagName === "path") out.push([id, [...node.getAttribute("d").matchAll(/[ML]([-\\d.e]+) ([-\\d.e]+)/g)].map(([, x, y]) => [Number(x), Number(y)])]);
    }
    for (const [x, y, , , color] of player.drawing.visibleCells()) {
      if (color) continue;
      const [px, py] = toPixels(at, x, y);
      out.push([`cell ${x},${y}`, [[px - at.cell / 2, py - at.cell / 2]]]);
    }
    return out;'''


def same_geometry(check, what, figure, page):
    """Marks and cells of both lie at the same places, but for one scale and one shift."""
    drawn = drawn_in(figure)
    pairs = [(p, q) for name, places in page.run(SHOWN) for p, q in zip(places, drawn.get(name, ())) if len(places) == len(drawn[name])]
    check.that(f'{what}: there is something to compare', len(pairs) > 8, len(pairs))
    # Two places that are far apart tell scale and shift
    (first, there), (last, at_last) = (end(pairs, key=lambda pair: sum(pair[0])) for end in (min, max))
    scale = (sum(at_last) - sum(there)) / (sum(last) - sum(first))
    off = [max(abs(there[i] + scale * (p[i] - first[i]) - q[i]) for i in (0, 1)) for p, q in pairs]
    check.that(f'{what}: the page draws what the figure does ({len(pairs)} places)', max(off) < 0.05, max(off))


def drawn_in(figure):
    """The places of a figure's discs, lines and cells, by their names."""
    found = {}
    for node in xml.parse(figure).iter():
        name, kind = node.get('data-id'), node.tag.rsplit('}', 1)[-1]
        if kind == 'circle':
            found[name] = [(float(node.get('cx')), float(node.get('cy')))]
        elif kind == 'path' and name:
            found.setdefault(name, [(float(x), float(y)) for x, y in re.findall(r'[ML](-?[\d.]+) (-?[\d.]+)', node.get('d'))])
        elif kind == 'rect' and name and name.startswith('cell '):
            found[name] = [(float(node.get('x')), float(node.get('y')))]
    return found


# -- Every topic

def drags_what_is_not_given(check, page):
    """Knots that follow from other inputs can be dragged, too, and are given then."""
    page.open('#topic=b_spline')
    x, y = page.place('knots', '4')
    page.drag([(x, y), (x + 30, y)])
    page.settle()
    given = page.run(GIVEN)
    knots = [float(knot) for knot in given.get('knots', '').split()]
    check.equal('all knots are given', (list(given), knots[:4], knots[5:]), (['knots'], [0, 0, 0, 0], [2, 3, 3, 3, 3]))
    check.that('the dragged one has moved', len(knots) > 4 and 1 < knots[4] < 2, knots)


def every_topic(check, page):
    """All of them open, have their fields, and something to drag, to paint or to type; each drag leads to another run."""
    page.open()
    bent = {}
    for topic in share_of(page.run('return workbench.topics.map(({name}) => name)'), 7):
        page.choose(topic=topic)
        check.equal(f'{topic}: nothing is refused', page.refusal(), '')
        fields, questions = page.run('return [workbench.form.fields.size, questionsOf(player.run).size]')
        check.that(f'{topic}: there are fields', fields > 0)
        check.that(f'{topic}: it asks what comes next', questions > 0)
        check.equal(f'{topic}: where one points is read, and moves nothing', page.run(POINT), [True, True])
        check.equal(f'{topic}: handles lead where they are dragged', page.run(NUDGE, EVERYTHING), [])
        wrong, bent[topic] = page.run(THERE_AND_BACK, EVERYTHING)
        check.equal(f'{topic}: a drag is counted from where it began', wrong, [])
    bending = {'viewing', 'illumination', 'back_face_culling'} & set(bent)
    check.that('their ways bend', bending <= {topic for topic in bent if bent[topic]}, bent)
    page.quiet('topics')


# In the middle of the drawing: whether its place is read where it is one of a cell, and whether the drawing is as large as before.
POINT = '''const {drawing, readout} = player.parts, {at} = player.drawing, {left, top, width, height} = drawing.getBoundingClientRect();
drawing.dispatchEvent(new PointerEvent("pointermove", {clientX: left + width / 2, clientY: top + height / 2, bubbles: true}));
return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
  const read = Boolean(readout.textContent) === Boolean(toCell(at, width / 2, height / 2)), stays = player.drawing.at.cell === at.cell;
  drawing.dispatchEvent(new PointerEvent("pointerleave"));
  done([read, stays]);
})));'''


# Whether no fit of a panel, across and down, takes one way to the other: the directions of what goes across, or down, differ.
BENDS = '''const bends = (went, goes) => [0, 1].some((k) => {
  const size = Math.hypot(...went.flat(), ...goes.flat());
  const directions = [went, goes].map((ways) => {
    const column = ways.map((way) => way[k]), length = Math.hypot(...column);
    return column.map((value) => (length > 1e-6 * size ? value / length : 0));
  });
  return Math.hypot(...directions[0].map((value, i) => value - directions[1][i])) > 1e-5;
});
'''


# Of each argument the last handle, or with GRADUS_STRESS each one, goes by 30 pixels or a cell along a diagonal, and stands there then, or nearer,
# which is all that can be where its way bends. From a corner of its window one of the four leads inwards.
NUDGE = BENDS + '''return (async () => {
  const wrong = [], layer = workbench.handles;
  const one = new Map(layer.handles.map((handle) => [handle.name, handle]));
  for (const {key} of arguments[0] ? [...layer.handles] : [...one.values()]) {
    const handle = () => layer.handles.find((h) => h.key === key);
    if (!handle() || handle().button.hidden) continue;
    const given = JSON.stringify(workbench.state.given);
    let tries = [];
    const wholly = layer.numbers(handle().name)[handle().numbers[0]].whole, {cell} = player.drawing.at;
    for (const [px, py] of wholly ? [[cell, cell], [-cell, -cell], [cell, -cell], [-cell, cell]] : [[30, 20], [-30, -20], [30, -20], [-30, 20]]) {
      const {at} = player.drawing, from = toPixels(at, handle().at.x, handle().at.y), text = workbench.textOf(workbench.parameter(handle().name));
      layer.take(handle());
      const {along, went} = layer.drag;
      layer.dragTo(px, py);
      while (workbench.asking) await workbench.asking;
      const found = handlesOf(player.run.trace).find((h) => h.key === key) ?? {at: {x: NaN, y: NaN}, along: went, name: key.split(" ")[0]};
      const now = toPixels(player.drawing.at, found.at.x, found.at.y);
      const refused = !workbench.parts.refusal.hidden;
      layer.letGo();
      const changed = workbench.textOf(workbench.parameter(found.name)) !== text;
      const line = along.every(([x, y]) => Math.abs(x * along[0][1] - y * along[0][0]) < 1e-9 * (Math.hypot(x, y) + 1e-30));
      const off = Math.hypot(now[0] - from[0] - px, now[1] - from[1] - py);
      const nearer = bends(went, found.along) && off < 0.9 * Math.hypot(px, py);
      tries.push([refused, changed, off, line || nearer || off < (wholly ? 0.6 * at.cell : 6)]);  // steps of up to 4 pixels for each number
      workbench.state.given = JSON.parse(given);
      await workbench.refresh(false);
      if (!refused && changed && tries.at(-1)[3]) break;
    }
    if (!tries.some(([refused, changed, , near]) => !refused && changed && near)) wrong.push([key, JSON.stringify(tries)]);
  }
  return wrong;
})()'''


# The same handles, by the events of a pointer: 90 pixels to the right and 50 up, jiggled by one pixel, and back. What a place of the
# pointer means is told by the map that was seen when the drag began, whatever is drawn meanwhile; and before it is let go, its mark is
# drawn where the change would have taken it in the drawing of the beginning, and its ring there. Where its way bends, so that it can't
# be, what is not dragged lies where it lay, and the ring is on the mark.
THERE_AND_BACK = BENDS + """return (async () => {
  const wrong = [], bent = [], layer = workbench.handles;
  // Where the handles lie that move none of its numbers
  const standing = (all, {name, numbers}) => new Map(all.filter((h) => h.name !== name || !h.numbers.some((n) => numbers.includes(n)))
      .map((h) => [h.key, toPixels(player.drawing.at, h.at.x, h.at.y)]));
  const one = new Map(layer.handles.map((handle) => [handle.name, handle]));
  for (const {key, name} of arguments[0] ? [...layer.handles] : [...one.values()]) {
    const handle = layer.handles.find((h) => h.key === key);
    if (!handle || handle.button.hidden) continue;
    const text = () => workbench.textOf(workbench.parameter(name)), given = () => JSON.stringify(workbench.state.given);
    const values = () => { const all = layer.numbers(name); return handle.numbers.map((i) => all[i].value); };
    const before = [text(), given()], start = values(), {button, along} = handle, {at} = player.drawing, {cell, yUp} = at;
    const place = toPixels(at, handle.at.x, handle.at.y), others = standing(layer.handles, handle), along0 = JSON.parse(JSON.stringify(along));
    const asked = [90 / cell, (yUp ? 50 : -50) / cell];
    const says = (type, x, y) => button.dispatchEvent(new PointerEvent(type, {pointerId: 1, button: 0, clientX: 300 + x, clientY: 300 + y, bubbles: true, cancelable: true}));
    const to = async (x, y) => {
      says("pointermove", x, y);
      while (workbench.asking) await workbench.asking;
    };
    button.setPointerCapture = () => {};
    says("pointerdown", 0, 0);
    await to(90, -50);
    const there = text(), gone = values().map((value, i) => value - start[i]);
    for (const [x, y] of [[91, -50], [90, -51], [89, -50]]) await to(x, y);
    await to(90, -50);
    if (text() !== there) wrong.push([key, "jiggled", there, text()]);
    // What the first map makes of the change: where all numbers can move it freely, the pointer's way
    const went = [0, 1].map((k) => gone.reduce((sum, by, i) => sum + by * along[i][k], 0)), [whole] = layer.numbers(name);
    const slack = (whole.whole ? 1.5 * Math.max(...along.map((way) => Math.hypot(...way))) : along.length * 5 / cell) + 1e-9;
    if (Math.hypot(...went) > Math.hypot(...asked) + slack) wrong.push([key, "ran away", asked, went]);
    const drawn = workbench.parts.refusal.hidden && handlesOf(player.run.trace).find((h) => h.key === key);  // not beyond its window
    if (drawn && bends(along0, drawn.along)) {
      bent.push(key);
      const now = standing(handlesOf(player.run.trace), handle), lie = [...others.keys()].filter((other) => now.has(other));
      const off = lie.map((other) => Math.hypot(...now.get(other).map((value, i) => value - others.get(other)[i])));
      const paper = [player.drawing.at, at].map(({cell: size, box}) => [size, box.x, box.y]), moved = paper[0].some((value, i) => Math.abs(value - paper[1][i]) > 1e-3);
      if (moved && !(Math.min(...off) < 0.5)) wrong.push([key, "the paper is moved, and nothing lies where it lay", paper, off]);
      const mark = toPixels(player.drawing.at, drawn.at.x, drawn.at.y), ring = [parseFloat(button.style.left), parseFloat(button.style.top)];
      if (!(Math.hypot(mark[0] - ring[0], mark[1] - ring[1]) <= 1.5)) wrong.push([key, "the ring lies beside the mark", mark, ring]);
    } else if (drawn) {
      const hand = [place[0] + went[0] * cell, place[1] + (yUp ? -1 : 1) * went[1] * cell], mark = toPixels(player.drawing.at, drawn.at.x, drawn.at.y);
      const ring = [parseFloat(button.style.left), parseFloat(button.style.top)];
      for (const [what, [x, y]] of [["mark", mark], ["ring", ring]])
        if (!(Math.hypot(x - hand[0], y - hand[1]) <= 1.5)) wrong.push([key, `the ${what} lies beside the hand`, hand, [x, y]]);
    }
    await to(0, 0);
    says("pointerup", 0, 0);
    while (workbench.asking) await workbench.asking;
    if (text() !== before[0] || given() !== before[1]) wrong.push([key, "came back otherwise", before, [text(), given()]]);
    delete button.setPointerCapture;
    workbench.state.given = JSON.parse(before[1]);
    await workbench.refresh(false);
  }
  return [wrong, bent];
})()"""


def speed(check, page):
    """Traces a second, for the run alone and with its drawing."""
    page.open()
    slow = []
    for topic in page.run('return workbench.topics.map(({name}) => name)'):
        page.choose(topic=topic)
        ms, drawn = page.run('''return (async () => {
            const request = requestOf(workbench.state, workbench.topic), start = performance.now();
            for (let i = 0; i < 8; ++i) await workbench.asker.ask(request);
            const asked = (performance.now() - start) / 8, again = performance.now();
            for (let i = 0; i < 8; ++i) {
              workbench.last = undefined;
              await workbench.refresh(true);
            }
            return [asked, (performance.now() - again) / 8];
        })()''')
        slow.append((drawn, ms, topic))
    slow.sort(reverse=True)
    print('  ms a trace, and with its drawing:', '; '.join(f'{topic} {ms:.0f}, {drawn:.0f}' for drawn, ms, topic in slow), flush=True)


def accessible(check, page, axe):
    turn = itertools.count()
    for size in ((1280, 720), (360, 740)):
        page.size(*size)
        for fragment in ('#topic=bresenham_line', '#topic=flood_fill&theme=dark', '#topic=perspective', '#topic=bresenham_line&beside=dda',
                         '#topic=bresenham_line&predict', '#topic=bresenham_line&in.from=here'):
            if not in_share(next(turn), 3):
                continue
            page.open(fragment)
            if 'predict' in fragment:
                page.run('player.next()')
            page.run(axe)
            found = page.run(READ, None)
            check.equal(f'axe at {size}, {fragment}', found, [])
        page.run('workbench.parts.dialog.showModal()')
        check.equal(f'axe at {size}, the dialog', page.run(READ, 'dialog[open]'), [])
    page.size(1280, 720)


class Quiet(http.server.SimpleHTTPRequestHandler):
    asked = []

    def log_message(self, *_):
        pass

    def do_GET(self):
        Quiet.asked.append(self.path)
        super().do_GET()


def from_a_server(check, browser, folder):
    server = http.server.ThreadingHTTPServer(('127.0.0.1', 0), functools.partial(Quiet, directory=str(folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        page = Page(browser, f'http://127.0.0.1:{server.server_port}/index.html', check)
        page.open('#topic=bresenham_line&in.to=5,5')
        check.equal('as a site: it runs', page.run('return player.run.trace.arguments.find(([n]) => n === "to")[1]'), '5,5')
        check.equal('as a site: it asks for the page and the module', sorted(set(Quiet.asked) - {'/favicon.ico'}), ['/gradus.wasm', '/index.html'])
    finally:
        server.shutdown()
        server.server_close()


def without_webassembly(check, url):
    with Browser() as browser:
        browser.size(1280, 720)
        browser.cdp('Page.addScriptToEvaluateOnNewDocument', source='delete window.WebAssembly')
        page = Page(browser, url, check).open('#topic=sutherland_hodgman')
        check.equal('there is no WebAssembly', page.run('return typeof WebAssembly'), 'undefined')
        check.equal('the recorded run plays', [page.run('return player.run.trace.topic'), page.run('player.next(); return player.index > 0')],
                    ['sutherland_hodgman', True])
        check.that('and it is said why nothing can be changed', 'WebAssembly' in page.refusal(), page.refusal())


def sizes(check, folder):
    for name in ('gradus.html', 'index.html', 'gradus.wasm'):
        print(f'  {name}: {(folder / name).stat().st_size:,} bytes, {len(zlib.compress((folder / name).read_bytes(), 9)):,} packed', flush=True)
    packed = len(zlib.compress((folder / 'gradus.html').read_bytes(), 9))
    site = sum(len(zlib.compress((folder / name).read_bytes(), 9)) for name in ('index.html', 'gradus.wasm'))
    most = A_TOPIC * len([*project.stories(), *(topic for topic in project.topics() if not topic.partial)])
    check.that(f'all of it is less than {most:,} bytes packed', max(packed, site) < most, (packed, site))
