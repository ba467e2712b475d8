'use strict';
// The drawing of a step: grid, cells, marks and labels as SVG, the overview on a canvas. Text from a trace
// only ever becomes text nodes and attribute values.

const SVG = 'http://www.w3.org/2000/svg';
const SANS = '"Gradus Sans", Inter, "DejaVu Sans", Verdana, "Segoe UI", system-ui, sans-serif';
const MONO = '"Gradus Mono", "JetBrains Mono", "DejaVu Sans Mono", Consolas, Menlo, monospace';

function filled(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}
const html = (name, attributes = {}, ...children) =>
    filled(document.createElement(name), attributes, children);
const svg = (name, attributes = {}, ...children) =>
    filled(document.createElementNS(SVG, name), attributes, children);

/** A whole number as it is written in formulas, with a minus sign. */
const written = (number) => String(number).replace('-', '−');

const pen = document.createElement('canvas').getContext('2d');
function textWidth(text, size, style = '', family = SANS) {
  pen.font = `${style} ${size}px ${family}`;
  return pen.measureText(text).width;
}

// ---- Where things go in the drawing ----------------------------------------------------------------------

const TEXT = 20;  // all sizes are those of the C++ layout, in units of which a slide's height has 720
const LARGEST_CELL = 96, LEAST_CELL = 16, LEAST_WHOLE_CELL = 6, FOLLOWED_CELL = 30, ROOMY_CELL = 44;
const LEAST_DOTTED = 14, LEAST_RULED = 6;  // smaller cells have no dot in the middle, or no lines between them
const AXIS_BELOW = 31, AXIS_ABOVE = 27, AXIS_RIM = 4, PAPER_RIM = 4;
const INSET = 104, INSET_GAP = 8, INSET_WIDTH = 190, INSET_COLUMN_GAP = 16;  // of an overview above, or beside

/** What there is to show: a grid's cells, or of a paper what its steps draw. Sizes in units. */
class Stage {
  constructor(trace) {
    const {grid} = trace, {lower: [x0, y0], upper: [x1, y1]} = grid;
    this.grid = grid;
    this.axes = grid.axes !== false;
    this.cells = {x0, y0, x1, y1};
    this.lower = [x0 - 0.5, y0 - 0.5];
    this.upper = [x1 + 0.5, y1 + 0.5];
    this.texts = new Map();
    if (!this.axes) this.cutToContent(trace);
  }
  get size() { return [this.upper[0] - this.lower[0], this.upper[1] - this.lower[1]]; }
  /** Whether a view that follows the step may show a part. */
  get mayFollow() { return this.axes && !this.grid.whole; }

  cutToContent(trace) {
    const lower = [Infinity, Infinity], upper = [-Infinity, -Infinity];
    const add = (x, y) => [x, y].forEach((value, i) => {
      const seen = clamp(value, this.lower[i], this.upper[i]);  // marks are cut there
      lower[i] = Math.min(lower[i], seen);
      upper[i] = Math.max(upper[i], seen);
    });
    const chain = (numbers) => {
      for (let i = 0; i + 1 < numbers.length; i += 2) add(numbers[i], numbers[i + 1]);
    };
    for (const {set = [], cells = []} of [{set: trace.backdrop}, trace.before ?? {}, ...trace.steps]) {
      for (const [x, y, count, role] of cells) {
        if (role >= 0) chain([x - 0.5, y - 0.5, x + count - 0.5, y + 0.5]);
      }
      for (const [, , kind, ...rest] of set) {
        if (kind === 'text' || kind === 'label')
          this.noteText(kind, rest, add);
        else if (kind === 'area')
          rest.filter(Array.isArray).forEach(chain);
        else
          chain(kind === 'dot' || kind === 'ring' ? rest.slice(0, 2) : numbersOf(kind, rest));
      }
    }
    if (lower[0] > upper[0]) return;
    this.lower = lower;
    this.upper = upper.map((value, i) => Math.max(value, lower[i] + 1));
    const {cells} = this, first = (i) => Math.floor(this.lower[i] + 0.5), last = (i) => Math.floor(this.upper[i] + 0.5);
    this.cells = {
      x0: Math.max(cells.x0, first(0)),
      y0: Math.max(cells.y0, first(1)),
      x1: Math.min(cells.x1, last(0)),
      y1: Math.min(cells.y1, last(1))
    };
  }
  /** A label stands somewhere beside its point: half its width and one line are enough. */
  noteText(kind, [x, y, text, aligned], add) {
    const align = kind === 'text' ? aligned : 'centre';
    if (x < this.lower[0] || x > this.upper[0] || y < this.lower[1] || y > this.upper[1]) return;
    add(x, y);
    this.texts.set(`${x} ${y} ${text}`, {x, y, text, align, half: (kind === 'text' ? 0.65 : 1.5) * TEXT});
  }

  // Room beside what is shown

  /** With the name of the rows above their numbers, or among them, where it takes the place of the last one. */
  axisMargins(cell, nameAbove) {
    const {grid, cells} = this, name = (text) => Math.ceil(textWidth(text, TEXT, 'italic'));
    const numbers = [cells.y0, cells.y1].map((y) => Math.ceil(textWidth(written(y), TEXT)));
    return {
      left: Math.max(...numbers, 14, nameAbove ? 0 : name(`${grid.y_name} ↑`)) + 10,
      right: cell < ROOMY_CELL ? Math.max(24, name(grid.x_name) + 12) : 8,
      above: nameAbove ? AXIS_ABOVE : AXIS_RIM,
      below: AXIS_BELOW
    };
  }
  /** What texts need beyond the shown part of a paper when a unit of it is this large. */
  textMargins(cell) {
    const margins = {left: PAPER_RIM, right: PAPER_RIM, above: PAPER_RIM, below: PAPER_RIM};
    const most = (side, asked) => { margins[side] = Math.max(margins[side], asked); };
    const up = this.grid.y_up;
    for (const {x, y, text, align, half} of this.texts.values()) {
      const width = textWidth(text, TEXT), left = {left: 0, centre: 0.5, right: 1}[align] * width;
      most('left', left - (x - this.lower[0]) * cell);
      most('right', width - left - (this.upper[0] - x) * cell);
      most(up ? 'below' : 'above', half - (y - this.lower[1]) * cell);
      most(up ? 'above' : 'below', half - (this.upper[1] - y) * cell);
    }
    return margins;
  }
  cellBetween({left, right, above, below}, width, height) {
    const [across, up] = this.size;
    return Math.max(Math.min((width - left - right) / across, (height - above - below) / up, LARGEST_CELL), 0);
  }

  /** The largest cell, with the room that is asked beside it. */
  largestIn(width, height) {
    return this.axes ? this.largestOfGrid(width, height) : this.largestOfPaper(width, height);
  }
  largestOfGrid(width, height) {
    let best = {cell: 0, margins: this.axisMargins(0, true)};
    for (const nameAbove of [true, false]) {
      for (const from of [ROOMY_CELL, 0]) {
        const margins = this.axisMargins(from, nameAbove), cell = this.cellBetween(margins, width, height);
        // Among the numbers the name stands over the last one, or in place of one of many
        const fits = nameAbove || cell >= 60 || this.size[1] >= 10;
        if (cell >= from && cell > best.cell * 1.001 && fits) best = {cell, margins};
      }
    }
    return best;
  }
  /** The smaller the unit, the more room is asked beside it. */
  largestOfPaper(width, height) {
    const none = {left: 0, right: 0, above: 0, below: 0};
    let low = 0, high = this.cellBetween(none, width, height);
    for (let i = 0; i < 20; ++i) {
      const middle = (low + high) / 2;
      if (middle <= this.cellBetween(this.textMargins(middle), width, height))
        low = middle;
      else
        high = middle;
    }
    return {cell: Math.max(low, 1e-3), margins: this.textMargins(low)};
  }

  /** How a drawing of this size shows it. */
  fit(width, height) {
    const {x0, y0, x1, y1} = this.cells, all = {columns: x1 - x0 + 1, rows: y1 - y0 + 1};
    const sized = this.largestIn(width, height);
    if (!this.mayFollow || sized.cell >= LEAST_CELL) return {...sized, ...all};
    const margins = this.axisMargins(FOLLOWED_CELL, true);
    const across = width - margins.left - margins.right, up = height - margins.above - margins.below;
    const count = (room, most) => clamp(Math.floor(room / FOLLOWED_CELL), 1, most);
    const followed = (side, room) => ({
      cell: FOLLOWED_CELL, margins, follows: side,
      columns: count(room.x, all.columns),
      rows: count(room.y, all.rows)
    });
    const above = followed('above', {x: across, y: up - INSET - INSET_GAP});
    const beside = followed('beside', {x: across - INSET_WIDTH - INSET_COLUMN_GAP, y: up});
    return beside.columns * beside.rows > 1.25 * above.columns * above.rows ? beside : above;
  }
}

/** Cells shown along one axis, following `focus` by jumps of half a view: the first one. */
function followed(lower, upper, count, focus) {
  if (upper - lower + 1 <= count) return lower;
  const half = Math.max(Math.floor(count / 2), 1);
  const page = Math.floor((focus - lower) / half);
  return clamp(lower + page * half - Math.floor(half / 2), lower, upper - count + 1);
}

/** Where the parts of the drawing lie, in pixels. Depends on the room and the focus only, never on the way here. */
function arrange(stage, width, height, s, focus) {
  const shown = stage.fit(width / s, height / s), {margins, follows} = shown, cell = shown.cell * s;
  const room = {x: 0, y: 0, width, height};
  let inset = null, view = stage.cells, origin = stage.lower, size = stage.size;
  if (follows === 'beside') {
    room.width -= (INSET_WIDTH + INSET_COLUMN_GAP) * s;
    inset = {
      x: width - INSET_WIDTH * s,
      y: margins.above * s,
      width: INSET_WIDTH * s,
      height: height - (margins.above + margins.below) * s
    };
  } else if (follows) {
    inset = {x: 0, y: 4 * s, width, height: INSET * s};
    room.y = (INSET + INSET_GAP) * s;
    room.height -= room.y;
  }
  if (follows) {
    const x0 = followed(view.x0, view.x1, shown.columns, focus[0]);
    const y0 = followed(view.y0, view.y1, shown.rows, focus[1]);
    view = {x0, y0, x1: x0 + shown.columns - 1, y1: y0 + shown.rows - 1};
    origin = [x0 - 0.5, y0 - 0.5];
    size = [shown.columns, shown.rows];
  }
  // With its axes in the middle of what is left
  const needs = {
    width: size[0] * cell + (margins.left + margins.right) * s,
    height: size[1] * cell + (margins.above + margins.below) * s
  };
  const left = room.x + (room.width - needs.width) / 2, top = room.y + (room.height - needs.height) / 2;
  const box = {
    x: left + margins.left * s,
    y: top + margins.above * s,
    width: size[0] * cell,
    height: size[1] * cell
  };
  return {view, origin, cell, box, follows, inset, left, top, s, yUp: stage.grid.y_up, width, height, needs, labels: room};
}

/** From the grid's coordinates to pixels. */
function toPixels(at, x, y) {
  const fromLower = (y - at.origin[1]) * at.cell;
  return [
    at.box.x + (x - at.origin[0]) * at.cell,
    at.yUp ? at.box.y + at.box.height - fromLower : at.box.y + fromLower
  ];
}
function toCell(at, px, py) {
  const fromLower = at.yUp ? at.box.y + at.box.height - py : py - at.box.y;
  const x = Math.floor(at.origin[0] + (px - at.box.x) / at.cell + 0.5);
  const y = Math.floor(at.origin[1] + fromLower / at.cell + 0.5);
  return x < at.view.x0 || x > at.view.x1 || y < at.view.y0 || y > at.view.y1 ? null : [x, y];
}

/** The part of a stroke inside a box, or null. (Liang and Barsky's parameters.) */
function clipped([ax, ay], [bx, by], box) {
  let enter = 0, leave = 1;
  const dx = bx - ax, dy = by - ay;
  for (const [along, room] of [
           [-dx, ax - box.x], [dx, box.x + box.width - ax], [-dy, ay - box.y],
           [dy, box.y + box.height - ay]]) {
    if (along === 0 && room < 0) return null;
    if (along < 0) enter = Math.max(enter, room / along);
    if (along > 0) leave = Math.min(leave, room / along);
  }
  if (enter > leave) return null;
  return [[ax + enter * dx, ay + enter * dy], [ax + leave * dx, ay + leave * dy]];
}

const grown = (b, by) => ({x: b.x - by, y: b.y - by, width: b.width + 2 * by, height: b.height + 2 * by});
const inside = (a, b) =>
    a.x >= b.x && a.y >= b.y && a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height;
function overlap(a, b) {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}

/** Distance between labelled integers: 1, 2, 5, 10 … cells, so that the labels keep apart. */
function tickStep(cell, needed) {
  for (let power = 1;; power *= 10) {
    for (const step of [power, 2 * power, 5 * power])
      if (step * cell >= needed) return step;
  }
}
function ticks(lower, upper, step) {
  const out = [];
  for (let v = Math.ceil(lower / step) * step; v <= upper; v += step) out.push(v + 0);
  return out;
}

/** Whether two strokes have a point in common. */
function cross([a, b], [c, d]) {
  const side = ([px, py], [qx, qy], [rx, ry]) => Math.sign((qx - px) * (ry - py) - (qy - py) * (rx - px));
  return side(a, b, c) !== side(a, b, d) && side(c, d, a) !== side(c, d, b);
}

/** Finds places for labels: near their points, on nothing that matters, never on each other; a leader only where
 *  that is impossible, and none that leads over a mark or a text. */
class LabelPlacer {
  texts = [];    // boxes that nothing may touch
  ticks = [];    // the axes' numbers and some space round them
  taken = [];    // cells and dots that a label must not cover
  crowded = [];  // [cell, weight]: those it had better not cover
  strokes = [];
  leaders = [];  // drawn so far: nothing may cross them

  constructor(at) {
    this.s = at.s;
    this.room = at.labels;
  }
  /** {box, leader} or null where no place is free. `gap`: the nearest place, `clear`: how far from lines. */
  place([x, y], text, gap, clear) {
    const height = TEXT * this.s, width = textWidth(text, height);
    let best = null, least = Infinity;
    for (const more of LabelPlacer.further) {
      const distance = gap + more * this.s;
      if (distance >= least) break;
      for (const [dx, dy] of LabelPlacer.directions) {
        const left = x + dx * distance - (dx < 0 ? width : dx > 0 ? 0 : width / 2);
        const box = {x: left, y: y + dy * distance - height / 2, width, height};
        const leader = more > 0 ? [[clamp(x, box.x, box.x + width), clamp(y, box.y, box.y + height)], [x, y]] : null;
        if (leader && this.crossesSomething(leader)) continue;
        const cost = this.badness(box, clear) + this.ambiguity(box, [x, y]) + distance + 2 * more * this.s;
        if (cost < least) [best, least] = [{box, leader}, cost];
      }
    }
    if (!best) return null;
    this.texts.push(best.box);
    if (best.leader) this.leaders.push(best.leader);
    return best;
  }
  badness(box, clear) {
    const {s} = this, apart = grown(box, 3 * s), area = box.width * box.height, clearing = grown(box, clear);
    if (!inside(box, this.room) || this.texts.some((text) => overlap(apart, text)) ||
        this.leaders.some(([a, b]) => clipped(a, b, apart)))
      return Infinity;
    let cost = 0;
    // Beside a number of an axis, a label would seem to go on with it
    for (const tick of this.ticks) cost += overlap(box, tick) ? 90 * s : 0;
    for (const cell of this.taken) cost += (900 * s * overlap(box, cell)) / area;
    for (const [cell, weight] of this.crowded) cost += (weight * s * overlap(box, cell)) / area;
    for (const [a, b] of this.strokes) cost += clipped(a, b, clearing) ? 160 * s : 0;
    return cost;
  }
  /** A label that touches another marked cell than its own, or stands in its row, seems to name that one. */
  ambiguity(box, [x, y]) {
    const {s} = this, row = box.y + box.height / 2, anchor = {x, y, width: 0, height: 0};
    let cost = 0;
    for (const cell of this.taken) {
      if (inside(anchor, cell)) continue;
      if (cell.y < row && row < cell.y + cell.height && overlap(grown(box, 16 * s), cell))
        cost += 150 * s;
      else if (overlap(grown(box, 7 * s), cell))
        cost += 60 * s;
    }
    return cost;
  }
  /** What the anchor itself lies on is crossed there, and may be. */
  crossesSomething([start, anchor]) {
    const {s} = this, dx = start[0] - anchor[0], dy = start[1] - anchor[1], length = Math.hypot(dx, dy) || 1;
    const off = Math.min(9 * s, 0.9 * length) / length, end = [anchor[0] + dx * off, anchor[1] + dy * off];
    const hits = (box) => clipped(start, end, box), point = {x: anchor[0], y: anchor[1], width: 0, height: 0};
    return this.texts.some(hits) || this.taken.some((box) => !inside(point, box) && hits(grown(box, -2 * s))) ||
        [...this.leaders, ...this.strokes].some((other) => cross([start, end], other));
  }
  static further = [0, 22, 44, 70, 105, 150, 210];  // beyond the nearest place; from the second on with a leader
  static directions = [
    [-1, 0], [1, 0], [-1, -1], [1, -1], [-1, 1], [1, 1], [0, -1], [0, 1], [-1, -0.5], [1, -0.5], [-1, 0.5],
    [1, 0.5], [-0.5, -1], [0.5, -1], [-0.5, 1], [0.5, 1]
  ];
}

// ---- The drawing -----------------------------------------------------------------------------------------

/** The texels of a grid's picture as RGBA bytes. */
function decodePicture(picture) {
  const bytes = Uint8Array.from(atob(picture.indices ?? picture.rgba), (c) => c.charCodeAt(0));
  if (!picture.palette) return bytes;
  const out = new Uint8Array(4 * bytes.length);
  bytes.forEach((index, i) => out.set(picture.palette[index], 4 * i));
  return out;
}

/** Two strokes that cross in (x, y). */
const crossPath = (x, y, arm) =>
    `M${x - arm} ${y - arm}L${x + arm} ${y + arm}M${x - arm} ${y + arm}L${x + arm} ${y - arm}`;

const hexRgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));

/** x and y in turn, of a mark that is a chain of strokes. */
const numbersOf = (kind, rest) => (kind === 'path' || kind === 'polygon' ? rest[0] : rest.slice(0, 4));
const LINE_WIDTHS = {
  current: 6, result: 5, measure: 5, boundary: 4, accepted: 4, input: 3, candidate: 4, rejected: 3, past: 2.2, guide: 1.4
};
/** Whose value a mark shows, by its symbol. */
const quantityOf = (rest) => rest.find((part) => part?.quantity)?.quantity;
const THIN = 1.6;
const GAP = 3.5;  // on either side of a line that passes in front
const dashes = (width) => `${3 * width} ${2 * width}`;
const DASHED = ['candidate', 'rejected'];

/** Kinds of marks, as a legend's entry looks: the first that there is. */
const SAMPLES = ['cell', 'area', 'stroke', 'path', 'polygon', 'arrow', 'dot', 'ring'];
const LINES = ['stroke', 'path', 'polygon', 'arrow'];

/** The elements of marks, by what they are parts of. */
function marksIn(svg) {
  const marks = new Map();
  for (const element of svg.querySelectorAll('[data-mark]')) {
    const name = `${element.dataset.mark} ${element.tagName}`;
    for (let i = 0;; ++i) {
      if (marks.has(`${name} ${i}`)) continue;
      marks.set(`${name} ${i}`, element);
      break;
    }
  }
  return marks;
}
const MOVE = {duration: 260, easing: 'ease-in-out'};
/** Marks that stood elsewhere come from there; lines of as many points bend over. */
function moveMarks(stood, marks) {
  const number = (element, name) => Number(element.getAttribute(name));
  for (const [name, mark] of marks) {
    const before = stood.get(name);
    if (!before) continue;
    const [x, y] = mark.tagName === 'circle' ? ['cx', 'cy'] : ['x', 'y'];
    if (mark.tagName === 'path') {
      const [from, to] = [before.getAttribute('d'), mark.getAttribute('d')];
      if (from !== to && from.replace(/[^A-Za-z]/g, '') === to.replace(/[^A-Za-z]/g, ''))
        mark.animate({d: [`path("${from}")`, `path("${to}")`]}, MOVE);
      continue;
    }
    const dx = number(before, x) - number(mark, x), dy = number(before, y) - number(mark, y);
    if (dx !== 0 || dy !== 0) mark.animate({transform: [`translate(${dx}px, ${dy}px)`, 'none']}, MOVE);
  }
}

class Drawing {
  constructor(element, prefix) {
    this.element = element;
    this.prefix = prefix;
    this.svg = svg('svg', {role: 'img'});
    this.overview = html('canvas', {'aria-hidden': 'true'});
    element.replaceChildren(this.svg, this.overview);
  }
  load(run, letters) {
    this.letters = letters;
    this.run = run;
    if (!run.shows('drawing')) return;
    const {picture, lower} = run.trace.grid;
    this.stage = new Stage(run.trace);
    this.texels = picture ? {...picture, lower, rgba: decodePicture(picture)} : null;
    this.stillKey = null;
  }
  texel(x, y) {
    const t = this.texels, column = x - t.lower[0], row = y - t.lower[1];
    if (column < 0 || row < 0 || column >= t.width || row >= t.height) return null;
    const i = 4 * (row * t.width + column);
    return t.rgba.subarray(i, i + 4);
  }

  /**
   * Draws one step. Everything that can be seen depends on the arguments only, but for the moment in which marks
   * move from where they stood, if they are to.
   */
  draw(index, theme, s, moving = false) {
    const {trace, playhead, steps} = this.run;
    const width = this.element.clientWidth, height = this.element.clientHeight;
    this.theme = theme;
    this.canvas = playhead.at(index);
    this.at = arrange(this.stage, width, height, s, steps[index].focus);
    this.labels = new LabelPlacer(this.at);
    const stood = moving ? marksIn(this.svg) : new Map(), {stillKey} = this;
    this.keepStill(`${width} ${height} ${s} ${theme.name} ${JSON.stringify(this.at.view)} ${JSON.stringify(this.at.box)}`);
    const {plane} = this.canvas;
    if (!plane) {
      this.labels.texts.push(...this.stillTexts);
      this.labels.ticks.push(...this.stillTicks);
    }
    const cells = this.shownCells = this.visibleCells();
    this.drawMarks(cells);
    const {areas, guides, leaders, lines, dots} = this.layers, [besideLines, onLines, letters] = this.drawLetters();
    this.svg.replaceChildren(
        this.patterns, this.picture, this.grounds(cells), this.colors(cells), plane ? '' : this.still,
        plane ? '' : this.centres(), this.outlines(cells), this.cellTexts(cells), areas, besideLines, guides, leaders,
        lines, onLines, dots, letters);
    this.svg.setAttribute('width', width);
    this.svg.setAttribute('height', height);
    this.overview.hidden = !this.at.follows;
    if (this.at.follows) this.drawOverview();
    if (stillKey === this.stillKey) moveMarks(stood, marksIn(this.svg));
  }

  visibleCells(canvas = this.canvas) {
    const {x0, y0, x1, y1} = this.at.view, out = [];
    for (let y = y0; y <= y1; ++y) {
      const row = canvas.rows.get(y);
      if (!row) continue;
      for (let x = x0; x <= x1; ++x) {
        const look = row.get(x);
        if (look) out.push([x, y, ...look]);
      }
    }
    return out;
  }

  // What stays while the view does: picture, grid lines, axes
  keepStill(key) {
    if (key === this.stillKey) return;
    this.stillKey = key;
    this.stillTexts = [];
    this.stillTicks = [];
    this.patterns = this.makePatterns();
    this.picture = this.texels ? this.drawPicture() : svg('g');
    this.still = svg('g', {}, this.drawGrid(), ...this.drawAxes());
    if (this.at.follows) this.still.append(...this.captionOverview());
  }
  makePatterns() {
    const size = 10 * this.at.s;
    const defs = svg('defs', {}, svg('clipPath', {id: `${this.prefix}-frame`}, svg('rect', this.at.box)));
    this.theme.roles.forEach((look, role) => {
      const d = {
        rising: `M0 ${size}L${size} 0M${-size / 4} ${size / 4}L${size / 4} ${-size / 4}` +
            `M${size * 0.75} ${size * 1.25}L${size * 1.25} ${size * 0.75}`,
        falling: `M0 0L${size} ${size}`,
        cross: `M0 0L${size} ${size}M0 ${size}L${size} 0`,
      }[look.areaHatch];
      if (!d) return;
      defs.append(svg(
          'pattern', {id: this.patternId(role), width: size, height: size, patternUnits: 'userSpaceOnUse'},
          svg('path', {d, stroke: look.mark, 'stroke-width': 0.9 * this.at.s})));
    });
    return defs;
  }
  patternId(role) { return `${this.prefix}-hatch-${role}`; }

  drawPicture() {
    const {x0, y0, x1, y1} = this.at.view;
    const small = html('canvas', {width: x1 - x0 + 1, height: y1 - y0 + 1});
    const context = small.getContext('2d'), image = context.createImageData(small.width, small.height);
    for (let y = y0; y <= y1; ++y) {
      for (let x = x0; x <= x1; ++x) {
        const row = this.at.yUp ? y1 - y : y - y0, texel = this.texel(x, y);
        if (texel) image.data.set(texel, 4 * (row * small.width + x - x0));
      }
    }
    context.putImageData(image, 0, 0);
    return svg(
        'image',
        {...this.cellsBox(), href: small.toDataURL(), preserveAspectRatio: 'none', style: 'image-rendering: pixelated'});
  }
  /** All cells of the view; more than what is shown where a paper is cut inside of a cell. */
  cellsBox() {
    const {view, cell, yUp} = this.at, first = this.square([view.x0, yUp ? view.y1 : view.y0]);
    return {...first, width: (view.x1 - view.x0 + 1) * cell, height: (view.y1 - view.y0 + 1) * cell};
  }
  /** The least row in view that is the grid's own: those of a shelf are not. */
  firstRow() {
    const {lower, shelf = 0} = this.run.trace.grid;
    return Math.max(this.at.view.y0, lower[1] + shelf);
  }
  drawGrid() {
    const {box, cell, view, s, yUp} = this.at, rows = view.y1 - this.firstRow() + 1;
    const top = yUp ? box.y : box.y + box.height - rows * cell;
    if (cell < LEAST_RULED * s) return svg('g');  // the pixels of a picture
    let lines = '';
    for (let i = 0; i <= view.x1 - view.x0 + 1; ++i) lines += `M${box.x + i * cell} ${top}v${rows * cell}`;
    for (let i = 0; i <= rows; ++i) lines += `M${box.x} ${top + i * cell}h${box.width}`;
    return svg('path', {d: lines, fill: 'none', stroke: this.theme.tones.rule, 'stroke-width': 1.5 * s});
  }
  /** A dot in the middle of each cell, where nothing else stands. */
  centres() {
    if (this.texels || this.at.cell < LEAST_DOTTED * this.at.s) return svg('g');
    const {view, s} = this.at, wall = this.run.trace.roles.indexOf('boundary');
    let d = '';
    for (let y = this.firstRow(); y <= view.y1; ++y) {
      for (let x = view.x0; x <= view.x1; ++x) {
        const look = this.canvas.look(x, y);
        if (!look || (look[0] !== wall && look[1] === '' && !look[2])) d += `M${toPixels(this.at, x, y).join(' ')}h0`;
      }
    }
    return svg('path', {
      d,
      fill: 'none',
      stroke: this.look('past').mark,
      'stroke-width': 4.4 * s,
      'stroke-linecap': 'round'
    });
  }
  drawAxes() {
    const {box, cell, view, s} = this.at, {grid} = this.run.trace, bottom = box.y + box.height + 23 * s;
    const right = this.at.labels.x + this.at.labels.width, size = TEXT * s;
    const name = textWidth(grid.x_name, size, 'italic');
    const widest = Math.max(...[view.x0, view.x1].map((x) => textWidth(written(x), size))), out = [];
    let end = box.x;
    for (const x of ticks(view.x0, view.x1, tickStep(cell, widest + 10 * s))) {
      const px = toPixels(this.at, x, 0)[0], half = textWidth(written(x), size) / 2;
      if (px + half > right - name - 8 * s) break;
      out.push(this.tick(written(x), px, bottom, 'middle'));
      end = px + half;
    }
    out.push(this.nameRows());
    const {y, height} = this.stillTexts.at(-1);
    for (const row of ticks(this.firstRow(), view.y1, tickStep(cell, 24 * s))) {
      const baseline = toPixels(this.at, 0, row)[1] + 7 * s;
      if (baseline - 0.8 * size > y + height) out.push(this.tick(written(row), box.x - 8 * s, baseline, 'end'));
    }
    const x = Math.max(Math.min(box.x + box.width + 6 * s, right - name), end + 8 * s);
    out.push(this.stillText(grid.x_name, x, bottom, 'start', 'italic'));
    return out;
  }
  /** The arrow behind the name of the rows says where they grow; columns always grow to the right. */
  nameRows() {
    const {box, s, yUp, follows, left, top} = this.at, {y_name: name} = this.run.trace.grid, size = TEXT * s;
    const text = `${name} ${yUp ? '↑' : '↓'}`, edge = box.x - 8 * s;
    if (box.y - top < size && !follows) return this.stillText(text, edge, box.y + 16 * s, 'end', 'italic');
    // A long name may stand over the grid's corner, but not in the margin
    const x = Math.max(edge - textWidth(name, size, 'italic'), left);
    return this.stillText(text, x, box.y - 7 * s, 'start', 'italic');
  }
  /** A number of an axis: labels keep further away than from other texts. */
  tick(text, x, y, anchor) {
    const out = this.stillText(text, x, y, anchor);
    this.stillTicks.push(grown(this.stillTexts.at(-1), 8 * this.at.s));
    return out;
  }
  stillText(text, x, y, anchor, style) {
    const size = TEXT * this.at.s, width = textWidth(text, size, style);
    const left = anchor === 'middle' ? x - width / 2 : anchor === 'end' ? x - width : x;
    this.stillTexts.push({x: left, y: y - 0.8 * size, width, height: size});
    return svg(
        'text',
        {x, y, 'font-size': size, 'font-style': style, 'text-anchor': anchor, fill: this.theme.tones.muted},
        text);
  }

  // Cells: one path a role, however many there are
  look(name) { return this.theme.roles[this.run.trace.roles.indexOf(name)]; }
  squares(cells, role, inset) {
    const {cell} = this.at, side = cell - 2 * inset;
    const square = ([x, y]) => {
      const [px, py] = toPixels(this.at, x, y);
      return `M${px - side / 2} ${py - side / 2}h${side}v${side}h${-side}z`;
    };
    return cells.filter((cell) => cell[2] === role && !cell[4]).map(square).join('');
  }
  /** Cells with colours of their own: the pixels of a picture that comes out. */
  colors(cells) {
    const group = svg('g', {'data-layer': 'colors', 'shape-rendering': 'crispEdges'}), {cell} = this.at;
    for (const [x, y, , , color] of cells) {
      if (!color) continue;
      const [px, py] = toPixels(this.at, x, y);
      group.append(
          svg('rect', {x: px - cell / 2, y: py - cell / 2, width: cell, height: cell, fill: color}));
    }
    return group;
  }
  rolesOf(cells) { return [...new Set(cells.filter((c) => !c[4]).map((c) => c[2]))].sort((a, b) => a - b); }
  grounds(cells) {
    const group = svg('g', {'data-layer': 'grounds'});
    for (const role of this.rolesOf(cells)) {
      const d = this.squares(cells, role, 0), look = this.theme.roles[role];
      group.append(svg('path', {d, fill: look.fill, 'data-role': this.run.trace.roles[role]}));
      if (look.hatch !== 'none') group.append(svg('path', {d, fill: `url(#${this.patternId(role)})`}));
    }
    return group;
  }
  outlines(cells) {
    const {s, cell} = this.at, group = svg('g', {fill: 'none', 'data-layer': 'outlines'});
    const strong = (role) => this.theme.roles[role].outline;
    for (const role of this.rolesOf(cells).sort((a, b) => strong(a) - strong(b))) {
      const look = this.theme.roles[role], width = Math.min(look.outline * s, cell / 5);
      if (!look.outline) continue;
      group.append(svg('path', {
        d: this.squares(cells, role, width / 2),
        stroke: look.mark,
        'stroke-width': width,
        'stroke-dasharray': look.dashed && dashes(width)
      }));
      if (look.cross)
        group.append(svg('path', {d: this.crosses(cells, role), stroke: look.mark, 'stroke-width': 2 * s}));
    }
    return group;
  }
  crosses(cells, role) {
    const arm = 0.2 * this.at.cell;
    const ofRole = cells.filter((cell) => cell[2] === role && !cell[4]);
    return ofRole.map(([x, y]) => crossPath(...toPixels(this.at, x, y), arm)).join('');
  }
  cellTexts(cells) {
    const {s, cell} = this.at, group = svg('g'), size = TEXT * s;
    for (const [x, y, role, text] of cells) {
      if (!text || cell < 26 * s || textWidth(text, size) > cell - 2 * s) continue;
      const [px, py] = toPixels(this.at, x, y), look = this.theme.roles[role];
      group.append(this.text(text, px, py + 7 * s, look.on, look.fill, {'text-anchor': 'middle'}));
    }
    return group;
  }
  text(text, x, y, color, ground, more = {}) {
    const {s} = this.at;
    return svg(
        'text', {
          x,
          y,
          'font-size': TEXT * s,
          fill: color,
          stroke: ground,
          'stroke-width': 5 * s,
          'stroke-linejoin': 'round',
          'paint-order': 'stroke',
          ...more
        },
        ...this.letters.svg(text));
  }

  // Marks: drawn at once; texts come later, when it is known what is in their way
  drawMarks(cells) {
    const clip = {'clip-path': `url(#${this.prefix}-frame)`}, {labels} = this;
    this.layers = {
      areas: svg('g', {'data-layer': 'areas', ...clip}),
      guides: svg('g'), leaders: svg('g'), lines: svg('g'), dots: svg('g')
    };
    this.marked = [];
    const pending = {fixed: [], free: [], texts: []};
    for (const mark of this.run.trace.backdrop) this.drawMark(mark, pending, 'fixed');
    const dots = labels.taken, fixed = {taken: dots.slice(), strokes: labels.strokes.slice()};
    for (const mark of this.canvas.sortedMarks()) this.drawMark(mark, pending, 'free');
    for (const text of pending.texts) this.placeText(text);
    this.placeLabels(pending, cells, fixed);
  }
  drawMark(mark, pending, standing) {
    const [id, role, kind, ...rest] = mark;
    const look = this.lookOf(role, quantityOf(rest));
    const attributes = {
      'data-role': this.run.trace.roles[role],
      ...(standing === 'free' ? {'data-mark': id} : {'pointer-events': 'none'})
    };
    if (kind === 'area')
      this.drawArea(rest, role, attributes);
    else if (kind === 'text')
      pending.texts.push(
          {at: toPixels(this.at, rest[0], rest[1]), text: rest[2], align: rest[3], look, attributes});
    else if (kind === 'label')
      pending[standing].push({at: toPixels(this.at, rest[0], rest[1]), text: rest[2], look, attributes});
    else if (kind === 'dot' || kind === 'ring')
      this.drawDot(rest, kind, look, attributes);
    else
      this.drawChain(rest, kind, look, attributes);
  }
  /** A role's look; dots and texts of a quantity have its colour. */
  lookOf(role, symbol) {
    const look = this.theme.roles[role], color = this.theme.quantities[this.letters.coded.get(symbol)];
    return color ? {...look, mark: color, text: color} : look;
  }
  drawArea(rest, role, attributes) {
    const rings = rest.filter(Array.isArray).map((ring) => {
      let d = '';
      for (let i = 0; i + 1 < ring.length; i += 2)
        d += `${i === 0 ? 'M' : 'L'}${toPixels(this.at, ring[i], ring[i + 1]).join(' ')}`;
      return d;
    });
    const d = rings.map((ring) => `${ring}z`).join('');
    this.layers.areas.append(...this.areaShapes(d, role, rest.find(Number.isFinite) ?? 0, attributes));
  }
  areaShapes(d, role, shade, attributes = {}, hatched = this.theme.roles[role].areaHatch) {
    const look = this.theme.roles[role], fill = shade ? look.tints[shade - 1] : look.fill;
    const area = svg('path', {d, fill, 'fill-rule': 'evenodd', ...attributes});
    if (hatched === 'none' || shade) return [area];
    const hatch = `url(#${this.patternId(role)})`;
    return [area, svg('path', {d, fill: hatch, 'fill-rule': 'evenodd', 'pointer-events': 'none'})];
  }
  drawDot([x, y], kind, look, attributes) {
    const [cx, cy] = toPixels(this.at, x, y);
    if (!inside({x: cx, y: cy, width: 0, height: 0}, grown(this.at.box, 1e-6))) return;
    const disc = this.disc(cx, cy, kind === 'ring', look, this.at.s, attributes), r = Number(disc.getAttribute('r'));
    this.labels.taken.push({x: cx - r, y: cy - r, width: 2 * r, height: 2 * r});
    this.layers.dots.append(disc);
  }
  disc(cx, cy, ring, look, s, attributes = {}) {
    const {paper} = this.theme.tones, r = (look.role === 'current' || look.role === 'result' ? 8 : 7) * s;
    const paint = ring ? {fill: paper, stroke: look.mark} : {fill: look.mark, stroke: paper};
    return svg('circle', {cx, cy, r, ...paint, 'stroke-width': (ring ? 3 : 2) * s, ...attributes});
  }
  drawChain(rest, kind, look, attributes) {
    const numbers = numbersOf(kind, rest), points = [], {labels} = this;
    for (let i = 0; i + 1 < numbers.length; i += 2)
      points.push(toPixels(this.at, numbers[i], numbers[i + 1]));
    if (kind === 'polygon' && points.length > 0) points.push(points[0]);
    let d = '', last = null, whole = kind === 'polygon';
    const same = (p, q) => p[0] === q[0] && p[1] === q[1];
    for (let i = 0; i + 1 < points.length; ++i) {
      const part = clipped(points[i], points[i + 1], this.at.box);
      whole &&= part && same(part[0], points[i]) && same(part[1], points[i + 1]);
      if (!part) continue;
      labels.strokes.push(part);
      d += `${last && same(last[1], part[0]) ? '' : `M${part[0].join(' ')}`}L${part[1].join(' ')}`;
      last = part;
    }
    if (!d) return;
    const style = {thin: rest.includes('thin'), dashed: rest.includes('dashed'), gap: rest.includes('gap')};
    const shapes = this.lineShapes(whole ? `${d}z` : d, look, style, this.at.s, attributes);
    if (kind === 'arrow') shapes.push(this.arrowHead(last, look, style, this.at.s, attributes));
    this.layers[look.role === 'guide' ? 'guides' : 'lines'].append(...shapes);
  }
  /** A line of a role, with the gap beside it where it passes in front. */
  lineShapes(d, look, {thin, dashed, gap}, s, attributes = {}) {
    const width = (thin ? THIN : LINE_WIDTHS[look.role]) * s;
    const line = svg('path', {
      d,
      fill: 'none',
      stroke: look.mark,
      'stroke-width': width,
      'stroke-miterlimit': 10,
      'stroke-dasharray': (dashed || DASHED.includes(look.role)) && dashes(width),
      ...attributes
    });
    if (!gap) return [line];
    const {paper} = this.theme.tones;
    return [svg('path', {d, fill: 'none', stroke: paper, 'stroke-width': width + 2 * GAP * s}), line];
  }
  arrowHead([[ax, ay], [bx, by]], look, {thin}, s, attributes = {}) {
    const size = 3 * (thin ? THIN : LINE_WIDTHS[look.role]) * s + 6 * s, length = Math.hypot(bx - ax, by - ay) || 1;
    const ux = ((bx - ax) / length) * size, uy = ((by - ay) / length) * size;
    const left = `${bx - ux - 0.4 * uy} ${by - uy + 0.4 * ux}`, right = `${bx - ux + 0.4 * uy} ${by - uy - 0.4 * ux}`;
    return svg('path', {d: `M${bx} ${by}L${left}L${right}z`, fill: look.mark, ...attributes});
  }

  // Texts over the marks
  /** Just where it stands; left out where it would lie on another text. */
  placeText({at: [x, y], text, align, look, attributes}) {
    const {s} = this.at, {labels} = this, size = TEXT * s, width = textWidth(text, size);
    const left = x - {left: 0, centre: 0.5, right: 1}[align] * width;
    const box = {x: left, y: y - 0.43 * size, width, height: size};
    if (!inside({x, y, width: 0, height: 0}, grown(this.at.box, 1)) || !inside(box, grown(labels.room, s))) return;
    if (labels.texts.some((other) => overlap(grown(box, 2 * s), other))) return;
    labels.texts.push(box);
    this.marked.push({text, box, baseline: y + 0.35 * size, look, attributes});
  }
  /** Those that stand through all steps come first and look only at what stands too, so that they keep still. */
  placeLabels(pending, cells, fixed) {
    const {labels} = this, {strokes, taken} = labels, {cell, s} = this.at, {axes} = this.stage;
    const gap = axes ? cell / 2 + 10 * s : 13 * s;
    Object.assign(labels, fixed);
    for (const label of pending.fixed) this.placeLabel(label, gap, axes ? cell : 2 * s);
    Object.assign(labels, {strokes, taken});
    const quiet = {past: 60, boundary: 300, result: 60};
    for (const shown of cells) {
      if (shown[4]) continue;
      const weight = quiet[this.run.trace.roles[shown[2]]];
      if (weight)
        labels.crowded.push([this.square(shown), weight]);
      else
        labels.taken.push(this.square(shown));
    }
    // What was chosen and what was not have the first pick, a length the last
    const isLength = ({look}) => look.role === 'measure';
    for (const label of pending.free.filter((label) => !isLength(label))) this.placeLabel(label, gap, 2 * s);
    for (const label of pending.free.filter(isLength)) this.placeLabel(label, gap, 2 * s);
  }
  square([x, y]) {
    const {cell} = this.at, [px, py] = toPixels(this.at, x, y);
    return {x: px - cell / 2, y: py - cell / 2, width: cell, height: cell};
  }
  placeLabel({at: [x, y], text, look, attributes}, gap, clear) {
    if (!inside({x, y, width: 0, height: 0}, grown(this.at.box, 1))) return;
    const found = this.labels.place([x, y], text, gap, clear);
    if (!found) return;
    const {box, leader} = found;
    if (leader) {
      this.layers.leaders.append(svg('path', {
        d: `M${leader[0].join(' ')}L${leader[1].join(' ')}`,
        stroke: look.text,
        'stroke-width': 1.4 * this.at.s,
        'pointer-events': 'none'
      }));
    }
    this.marked.push({text, box, baseline: box.y + 0.78 * box.height, look, attributes});
  }
  /** A text's rim hides what lies below it: the grid and tints always, lines only where the letters lie on them,
   *  dots never. */
  drawLetters() {
    const besideLines = svg('g'), onLines = svg('g'), letters = svg('g'), {labels} = this, {paper} = this.theme.tones;
    for (const {text, box, baseline, look, attributes} of this.marked) {
      const onLine = labels.strokes.some(([a, b]) => clipped(a, b, box));
      const rim = this.text(text, box.x, baseline, paper, paper, {'pointer-events': 'none', 'aria-hidden': 'true'});
      (onLine ? onLines : besideLines).append(rim);
      letters.append(this.text(text, box.x, baseline, look.text, 'none', attributes));
    }
    return [besideLines, onLines, letters];
  }

  // The whole grid, small, with the part that is seen
  overviewBox() {
    const {grid} = this.run.trace, {s, inset, follows} = this.at, beside = follows === 'beside';
    const ratio = (grid.upper[0] - grid.lower[0] + 1) / (grid.upper[1] - grid.lower[1] + 1);
    const below = beside && this.overviewCaptioned() ? 90 * s : 0;
    const most = beside ? inset.width : Math.min(0.55 * inset.width, inset.width - this.captionWidth() - 24 * s);
    const height = Math.min(inset.height - below, 150 * s, Math.max(most, 40 * s) / ratio);
    return {x: inset.x, y: inset.y, width: Math.max(height * ratio, 6 * s), height: Math.max(height, 6 * s)};
  }
  captionWidth() { return Math.max(...this.overviewLines().map((text) => textWidth(text, TEXT * this.at.s))); }
  /** Whether there is room for words; the axes say it, too. */
  overviewCaptioned() {
    const {s, inset, follows} = this.at;
    return follows !== 'beside' || (inset.height > 160 * s && this.captionWidth() <= inset.width);
  }
  overviewLines() {
    const {grid} = this.run.trace, {x0, y0, x1, y1} = this.at.view;
    return [
      say('whole', {columns: grid.upper[0] - grid.lower[0] + 1, rows: grid.upper[1] - grid.lower[1] + 1}),
      `${grid.x_name} ${written(x0)} … ${written(x1)}`, `${grid.y_name} ${written(y0)} … ${written(y1)}`
    ];
  }
  captionOverview() {
    if (!this.overviewCaptioned()) return [];
    const {s, inset, follows} = this.at, box = this.overviewBox(), beside = follows === 'beside';
    const x = beside ? inset.x : box.x + box.width + 14 * s, y = beside ? box.y + box.height + 24 * s : box.y + 20 * s;
    return this.overviewLines().map((text, i) => this.stillText(text, x, y + 28 * i * s, 'start'));
  }
  drawOverview() {
    const box = this.overviewBox(), dpr = window.devicePixelRatio || 1, {s} = this.at;
    const {overview} = this;
    Object.assign(
        overview.style,
        {left: `${box.x}px`, top: `${box.y}px`, width: `${box.width}px`, height: `${box.height}px`});
    overview.width = Math.max(Math.round(box.width * dpr), 1);
    overview.height = Math.max(Math.round(box.height * dpr), 1);
    const context = overview.getContext('2d');
    context.putImageData(this.overviewImage(context), 0, 0);
    const place = this.overviewPlace();
    for (const mark of this.run.trace.backdrop) this.overviewMark(context, mark, place, s * dpr);
    const {x0, y0, x1, y1} = this.at.view;
    const [ax, ay] = place(x0 - 0.5, y0 - 0.5), [bx, by] = place(x1 + 0.5, y1 + 0.5), least = 8 * s * dpr;
    const seen = {width: Math.max(Math.abs(bx - ax), least), height: Math.max(Math.abs(by - ay), least)};
    seen.x = clamp((ax + bx) / 2 - seen.width / 2, 2 * dpr, overview.width - seen.width - 2 * dpr);
    seen.y = clamp((ay + by) / 2 - seen.height / 2, 2 * dpr, overview.height - seen.height - 2 * dpr);
    context.lineWidth = 3 * s * dpr;
    context.strokeStyle = this.look('current').mark;
    context.strokeRect(seen.x, seen.y, seen.width, seen.height);
    context.lineWidth = 1.5 * dpr;
    context.strokeStyle = this.theme.tones.muted;
    context.strokeRect(0, 0, overview.width, overview.height);
  }
  overviewPlace() {
    const {lower, upper, y_up: yUp} = this.run.trace.grid, {width, height} = this.overview;
    return (x, y) => {
      const fx = (x - lower[0] + 0.5) / (upper[0] - lower[0] + 1);
      const fy = (y - lower[1] + 0.5) / (upper[1] - lower[1] + 1);
      return [fx * width, (yUp ? 1 - fy : fy) * height];
    };
  }
  overviewMark(context, [, role, kind, ...rest], place, scale) {
    if (!['stroke', 'arrow', 'path', 'polygon'].includes(kind)) return;
    const numbers = numbersOf(kind, rest);
    context.beginPath();
    for (let i = 0; i + 1 < numbers.length; i += 2) context.lineTo(...place(numbers[i], numbers[i + 1]));
    if (kind === 'polygon') context.closePath();
    context.lineWidth = 2 * scale;
    context.strokeStyle = this.theme.roles[role].mark;
    context.stroke();
  }
  overviewImage(context) {
    const {width, height} = this.overview, image = context.createImageData(width, height);
    const {lower, upper, y_up: yUp} = this.run.trace.grid;
    const across = upper[0] - lower[0] + 1, up = upper[1] - lower[1] + 1;
    const texels = new Uint32Array(image.data.buffer);
    const packed = ([r, g, b, a = 255]) => new Uint32Array(new Uint8Array([r, g, b, a]).buffer)[0];
    const paper = packed(hexRgb(this.theme.tones.panel));
    for (let row = 0; row < height; ++row) {
      for (let column = 0; column < width; ++column) {
        const y = Math.floor(((yUp ? height - 1 - row : row) * up) / height) + lower[1];
        const texel = this.texels && this.texel(Math.floor((column * across) / width) + lower[0], y);
        texels[row * width + column] = texel ? packed(texel) : paper;
      }
    }
    const colors = this.theme.roles.map((look) => packed(hexRgb(look.mark)));
    // First and one past the last pixel of a cell; at least one
    const span = (cell, pixels, cells) => {
      const from = Math.floor((cell * pixels) / cells);
      return [from, Math.max(Math.floor(((cell + 1) * pixels) / cells), from + 1)];
    };
    for (const [y, cells] of this.canvas.rows) {
      const [low, high] = span(y - lower[1], height, up);
      for (const [x, [role, , color]] of cells) {
        const [left, right] = span(x - lower[0], width, across), ink = color ? packed(hexRgb(color)) : colors[role];
        for (let r = low; r < high; ++r) {
          const row = yUp ? height - 1 - r : r;
          if (row >= 0 && row < height)
            texels.fill(ink, row * width + Math.max(left, 0), row * width + Math.min(right, width));
        }
      }
    }
    return image;
  }

  /** The kinds of marks that show a role now. */
  kindsOf(role) {
    const kinds = {cell: this.shownCells.some((cell) => cell[2] === role && !cell[4]), solid: false, shade: 0, quantities: []};
    for (const [, of, kind, ...rest] of [...this.run.trace.backdrop, ...this.canvas.marks.values()]) {
      if (of !== role) continue;
      kinds[kind] = true;
      if (kind === 'area') kinds.shade = Math.max(kinds.shade, Math.min(rest.find(Number.isFinite) ?? 0, 2));
      if (LINES.includes(kind)) kinds.solid ||= !rest.includes('dashed');
      if (kind === 'dot' || kind === 'ring') kinds.quantities.push(quantityOf(rest));
    }
    return kinds;
  }
  /** The mark that stands for a role in the legend: {as, dashed, outlined, shade, quantities, color}; null: it is not seen. */
  legendMark([role, , color]) {
    if (color) {
      const seen = this.shownCells.some((cell) => cell[2] === role && cell[4] === color);
      return seen ? {as: 'cell', color} : null;
    }
    const kinds = this.kindsOf(role), as = SAMPLES.find((kind) => kinds[kind]), lines = LINES.some((kind) => kinds[kind]);
    if (!as) return null;
    const quantities = [...new Set(kinds.quantities)].sort();
    return {as, dashed: lines && !kinds.solid, outlined: Boolean(kinds.area) && lines, shade: kinds.shade, quantities};
  }
  /** What the legend has to name: roles that can be seen, and colours that cells have. */
  legendRoles() { return this.run.trace.legend.filter((entry) => this.legendMark(entry)); }

  /** A legend entry's mark as it looks in the drawing. */
  swatch(entry, s) {
    const mark = this.legendMark(entry), [role] = entry, look = this.theme.roles[role];
    const dots = mark.as === 'dot' || mark.as === 'ring' ? mark.quantities.length : 0;
    const width = (dots === 1 ? 18 : 32) * s, height = 18 * s;
    const image = svg('svg', {width, height, 'aria-hidden': 'true'});
    image.append(...this.sample(mark, role, look, width, height, s));
    return image;
  }
  sample(mark, role, look, width, height, s) {
    const {as, dashed} = mark, rim = (by) => `M${by} ${by}h${width - 2 * by}v${height - 2 * by}h${2 * by - width}z`;
    const outline = () => this.lineShapes(rim((LINE_WIDTHS[look.role] * s) / 2), look, {dashed}, s);
    const line = () => this.lineShapes(`M0 ${height / 2}h${width}`, look, {dashed}, s);
    if (as === 'stroke' || as === 'path') return line();
    if (as === 'polygon') return outline();
    if (as === 'arrow') {
      const ends = [[0, height / 2], [width, height / 2]];
      return [...line(), this.arrowHead(ends, look, {}, s)];
    }
    if (as === 'dot' || as === 'ring')
      return mark.quantities.map((symbol, i) => this.disc(
          ((i + 0.5) * width) / mark.quantities.length, height / 2, as === 'ring', this.lookOf(role, symbol), s));
    if (as === 'area') {
      const d = rim(mark.outlined ? (LINE_WIDTHS[look.role] * s) / 2 : 0);
      return [...this.areaShapes(d, role, mark.shade), ...(mark.outlined ? outline() : [])];
    }
    if (mark.color) return [svg('path', {d: rim(0), fill: mark.color})];
    return [...this.areaShapes(rim(0), role, 0, {}, look.hatch), ...this.cellOutline(look, width, height, s)];
  }
  cellOutline(look, width, height, s) {
    if (!look.outline) return [];
    const inset = (look.outline * s) / 2, stroke = Math.min(look.outline * s, 0.3 * height), arm = 0.3 * height;
    const out = [svg('rect', {
      x: inset,
      y: inset,
      width: width - 2 * inset,
      height: height - 2 * inset,
      fill: 'none',
      stroke: look.mark,
      'stroke-width': stroke,
      'stroke-dasharray': look.dashed && dashes(stroke)
    })];
    const [right, bottom] = [width - arm, height - arm];
    if (look.cross)
      out.push(svg('path', {
        d: `M${arm} ${arm}L${right} ${bottom}M${arm} ${bottom}L${right} ${arm}`,
        stroke: look.mark,
        'stroke-width': 2 * s
      }));
    return out;
  }
}
