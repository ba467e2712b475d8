'use strict';
// Where things go in the drawing: how large a cell can be, which part of the grid is seen, and from the grid's
// coordinates to pixels.

const TEXT = 20, PARAGRAPH_LINE = 26;  // all sizes are those of the C++ layout, in units of which a slide's height has 720
const LARGEST_CELL = 96, LEAST_CELL = 16, LEAST_WHOLE_CELL = 6, FOLLOWED_CELL = 30, ROOMY_CELL = 44;
const HIGH_CELL = 64, NAME_GAP = 8;  // where the name of the rows stands
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
  noteText(kind, rest, add) {
    const [x, y, text, aligned] = rest, align = kind === 'text' ? aligned : 'centre';
    if (x < this.lower[0] || x > this.upper[0] || y < this.lower[1] || y > this.upper[1]) return;
    add(x, y);
    const half = (kind === 'text' ? 0.65 : 1.5) * TEXT, below = kind === 'text' ? lineOf(rest) * PARAGRAPH_LINE : 0;
    this.texts.set(`${x} ${y} ${text}`, {x, y, text, align, up: half - below, down: half + below});
  }

  // Room beside what is shown

  /** With the name of the rows above their numbers, over the last one of them (among), or left of all (aside). */
  axisMargins(cell, rowName) {
    const {grid, cells} = this, name = (text) => Math.ceil(textWidth(text, TEXT, 'italic'));
    const widths = (...ends) => ends.map((end) => Math.ceil(textWidth(written(end), TEXT)));
    const numbers = widths(cells.y0, cells.y1), columns = Math.max(...widths(cells.x0, cells.x1));
    const rows = name(`${grid.y_name} ↑`), widest = Math.max(...numbers, 14, rowName === 'among' ? rows : 0);
    const gap = grid.on_lines ? Math.max(8, 2 + columns / 2) : 8;
    return {
      left: widest + (rowName === 'aside' ? rows + NAME_GAP : 0) + 2 + gap,
      right: cell < ROOMY_CELL || grid.on_lines ? Math.max(24, name(grid.x_name) + 12) : 8,
      above: {above: AXIS_ABOVE, among: AXIS_RIM, aside: cell < ROOMY_CELL ? NAME_GAP : AXIS_RIM}[rowName],
      below: AXIS_BELOW
    };
  }
  /** What texts need beyond the shown part of a paper when a unit of it is this large. */
  textMargins(cell) {
    const margins = {left: PAPER_RIM, right: PAPER_RIM, above: PAPER_RIM, below: PAPER_RIM};
    const most = (side, asked) => { margins[side] = Math.max(margins[side], asked); };
    const {y_up: yUp} = this.grid;
    for (const {x, y, text, align, up, down} of this.texts.values()) {
      const width = textWidth(text, TEXT), left = {left: 0, centre: 0.5, right: 1}[align] * width;
      most('left', left - (x - this.lower[0]) * cell);
      most('right', width - left - (this.upper[0] - x) * cell);
      most(yUp ? 'below' : 'above', (yUp ? down : up) - (y - this.lower[1]) * cell);
      most(yUp ? 'above' : 'below', (yUp ? up : down) - (this.upper[1] - y) * cell);
    }
    return margins;
  }
  cellBetween({left, right, above, below}, width, height, [across, up] = this.size) {
    return Math.max(Math.min((width - left - right) / across, (height - above - below) / up, LARGEST_CELL), 0);
  }

  /** The largest cell, with the room that is asked beside it. */
  largestIn(width, height) {
    return this.axes ? this.largestOfGrid(width, height) : this.largestOfPaper(width, height);
  }
  largestOfGrid(width, height, size = this.size) {
    let best = {cell: 0, margins: this.axisMargins(0, 'above')};
    for (const rowName of ['above', 'among', 'aside']) {
      for (const from of [ROOMY_CELL, 0]) {
        const margins = this.axisMargins(from, rowName), cell = this.cellBetween(margins, width, height, size);
        // Among the numbers the name stands over the last one
        const among = rowName === 'among' && cell >= HIGH_CELL && !this.grid.on_lines;
        const fits = rowName === 'above' || (!this.grid.part && (rowName === 'aside' || among));
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

  /** Pixels for a unit of letters: in a small room those of a paper get smaller, so that no line of text lies on another,
      and that there is room for what the texts stand beside. */
  letters(width, height, s) {
    const {lines = 0} = this.grid, room = `${width} ${height} ${s}`;
    if (this.lettered?.room === room) return this.lettered.s;
    const least = 0.4 * s;
    const crowded = () => {
      const {cell} = this.fit(width / s, height / s), small = (i, room) => cell * s * this.size[i] < 0.4 * room;
      return cell < lines || (!this.axes && small(0, width) && small(1, height));
    };
    while (s > least && crowded()) s *= 0.95;
    this.lettered = {room, s};
    return s;
  }

  /** The grid's part with an overview above or beside it, or, where cells would be small, alone. */
  fitOfPart(width, height) {
    if (!this.grid.part) return null;
    const {lower: [x0, y0], upper: [x1, y1]} = this.grid.part, columns = x1 - x0 + 1, rows = y1 - y0 + 1;
    const part = {x0, y0, x1, y1}, size = [columns, rows];
    const fit = (across, up, follows) =>
        ({...this.largestOfGrid(width - across, height - up, size), columns, rows, part, follows});
    const above = fit(0, INSET + INSET_GAP, 'above'), beside = fit(INSET_WIDTH + INSET_COLUMN_GAP, 0, 'beside');
    const best = beside.cell > above.cell ? beside : above;
    const shown = best.cell < FOLLOWED_CELL ? fit(0, 0, null) : best;
    return shown.cell < LEAST_CELL ? null : shown;
  }
  /** How a drawing of this size shows it. */
  fit(width, height) {
    const {x0, y0, x1, y1} = this.cells, all = {columns: x1 - x0 + 1, rows: y1 - y0 + 1};
    const part = this.fitOfPart(width, height);
    if (part) return part;
    const sized = this.largestIn(width, height);
    if (!this.mayFollow || sized.cell >= LEAST_CELL) return {...sized, ...all};
    const margins = this.axisMargins(FOLLOWED_CELL, 'above');
    const across = width - margins.left - margins.right, up = height - margins.above - margins.below;
    const count = (room, most) => clamp(Math.floor(room / FOLLOWED_CELL), 1, most);
    const followed = (side, room) => ({
      cell: FOLLOWED_CELL, margins, follows: side,
      columns: count(room.x, all.columns),
      rows: count(room.y, all.rows)
    });
    const above = followed('above', {x: across, y: up - INSET - INSET_GAP});
    const beside = followed('beside', {x: across - this.insetWidth(width) - INSET_COLUMN_GAP, y: up});
    return beside.columns * beside.rows > (this.grid.picture ? 0.3 : 1.25) * above.columns * above.rows ? beside : above;
  }
  /** Of an overview beside the view: a picture is looked at itself. */
  insetWidth(width) {
    return this.grid.picture ? Math.max(INSET_WIDTH, (width - INSET_COLUMN_GAP) / 2) : INSET_WIDTH;
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
function arrange(stage, width, height, unit, focus) {
  const s = stage.letters(width, height, unit);
  const shown = stage.fit(width / s, height / s), {margins, follows} = shown, cell = shown.cell * s;
  const room = {x: 0, y: 0, width, height};
  let inset = null, view = stage.cells, origin = stage.lower, size = stage.size;
  if (follows === 'beside') {
    const across = stage.insetWidth(width / s) * s;
    room.width -= across + INSET_COLUMN_GAP * s;
    inset = {
      x: width - across,
      y: margins.above * s,
      width: across,
      height: height - (margins.above + margins.below) * s
    };
  } else if (follows) {
    inset = {x: 0, y: 4 * s, width, height: INSET * s};
    room.y = (INSET + INSET_GAP) * s;
    room.height -= room.y;
  }
  if (shown.part) {
    view = shown.part;
    origin = [view.x0 - 0.5, view.y0 - 0.5];
    size = [shown.columns, shown.rows];
  } else if (follows) {
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

/** The same drawing `times` as large, so that what lay at the first of these pixels lies at the other one. */
function moved(at, [x, y], [toX, toY], times) {
  const {box} = at;
  return {
    ...at,
    cell: at.cell * times,
    box: {x: toX + (box.x - x) * times, y: toY + (box.y - y) * times, width: box.width * times, height: box.height * times}
  };
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
