'use strict';
// The drawing of a step: grid, cells, marks and labels as SVG, the overview on a canvas. Text from a trace
// only ever becomes text nodes and attribute values.

const SVG = 'http://www.w3.org/2000/svg';
const SANS = '"DejaVu Sans", Verdana, "Segoe UI", system-ui, sans-serif';
const MONO = '"DejaVu Sans Mono", Consolas, Menlo, monospace';

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

const TEXT = 20, LARGEST_CELL = 84, LEAST_CELL = 24, FOLLOWED_CELL = 30;
const AXIS_BELOW = 34, AXIS_ABOVE = 30, INSET = 104;  // pixels at 720 lines, as in the C++ layout

/** Cells shown along one axis, following `focus` by jumps of half a view: the first one. */
function followed(lower, upper, count, focus) {
  if (upper - lower + 1 <= count) return lower;
  const half = Math.max(Math.floor(count / 2), 1);
  const page = Math.floor((focus - lower) / half);
  return clamp(lower + page * half - Math.floor(half / 2), lower, upper - count + 1);
}

/** Which cells are seen and how large. Depends on the room and the focus only, never on the way here. */
function arrange(grid, width, height, s, focus) {
  const [x0, y0] = grid.lower, [x1, y1] = grid.upper;
  const ticks = Math.max(24 * s, ...[y0, y1].map((y) => textWidth(written(y), TEXT * s)));
  const axes = grid.axes !== false;  // a paper has none
  const left = axes ? ticks + 12 * s : 0;
  const right = axes ? Math.max(24 * s, textWidth(grid.x_name, TEXT * s) + 12 * s) : 0;
  const above = axes ? AXIS_ABOVE * s : 0, below = axes ? AXIS_BELOW * s : 0;
  const room = {x: Math.max(width - left - right, 1), y: Math.max(height - above - below, 1)};
  let cell = Math.min(room.x / (x1 - x0 + 1), room.y / (y1 - y0 + 1), LARGEST_CELL * s);
  let view = {x0, y0, x1, y1}, top = above;
  const follows = cell < LEAST_CELL * s && !grid.whole;
  if (follows) {
    cell = FOLLOWED_CELL * s;
    top += (INSET + 8) * s;
    room.y = Math.max(room.y - (INSET + 8) * s, cell);
    const columns = Math.max(Math.floor(room.x / cell), 1), rows = Math.max(Math.floor(room.y / cell), 1);
    view.x0 = followed(x0, x1, columns, focus[0]);
    view.y0 = followed(y0, y1, rows, focus[1]);
    view.x1 = Math.min(view.x0 + columns - 1, x1);
    view.y1 = Math.min(view.y0 + rows - 1, y1);
  }
  const across = view.x1 - view.x0 + 1, up = view.y1 - view.y0 + 1;
  const box = {
    x: left + Math.max(room.x - across * cell, 0) / 2,
    y: top + Math.max(room.y - up * cell, 0) / 2,
    width: across * cell,
    height: up * cell,
  };
  return {view, cell, box, follows, s, yUp: grid.y_up, width, height, margin: above + below};
}

/** From the grid's coordinates to pixels. */
function toPixels(at, x, y) {
  const rows = y - at.view.y0 + 0.5;
  return [
    at.box.x + (x - at.view.x0 + 0.5) * at.cell,
    at.yUp ? at.box.y + at.box.height - rows * at.cell : at.box.y + rows * at.cell
  ];
}
function toCell(at, px, py) {
  const column = Math.floor((px - at.box.x) / at.cell), row = Math.floor((py - at.box.y) / at.cell);
  const x = at.view.x0 + column, y = at.yUp ? at.view.y1 - row : at.view.y0 + row;
  return x < at.view.x0 || x > at.view.x1 || y < at.view.y0 || y > at.view.y1 ? null : [x, y];
}

/** The part of a stroke inside a box, or null. (Liang and Barsky's parameters.) */
function clipped([ax, ay], [bx, by], box) {
  let enter = 0, leave = 1;
  const dx = bx - ax, dy = by - ay;
  for (const [p, q] of [
           [-dx, ax - box.x], [dx, box.x + box.width - ax], [-dy, ay - box.y],
           [dy, box.y + box.height - ay]]) {
    if (p === 0 && q < 0) return null;
    if (p < 0) enter = Math.max(enter, q / p);
    if (p > 0) leave = Math.min(leave, q / p);
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

/** Finds places for labels: near their points, on nothing that matters, never on each other. */
class LabelPlacer {
  texts = [];    // boxes that nothing may touch
  taken = [];    // cells and dots that a label must not cover
  crowded = [];  // cells it had better not cover
  strokes = [];

  constructor(at) {
    this.s = at.s;
    const top = at.follows ? at.box.y - 28 * at.s : 0;
    this.room = {x: 0, y: top, width: at.width, height: at.height - top};
    this.gap = at.cell / 2 + 10 * at.s;
  }
  cost(box, distance) {
    if (!inside(box, this.room) || this.texts.some((t) => overlap(grown(box, 3 * this.s), t)))
      return Infinity;
    const area = box.width * box.height, near = grown(box, 2 * this.s);
    let cost = distance;
    for (const b of this.taken) cost += (900 * this.s * overlap(box, b)) / area;
    for (const b of this.crowded) cost += (60 * this.s * overlap(box, b)) / area;
    for (const [a, b] of this.strokes)
      if (clipped(a, b, near)) cost += 160 * this.s;
    return cost;
  }
  /** {box, leader} or null where no place is free. */
  place([x, y], text) {
    const size = TEXT * this.s, width = textWidth(text, size);
    let best = null, least = Infinity;
    for (const [ring, extra] of [0, 26, 60, 100, 150, 210].entries()) {
      const distance = this.gap + extra * this.s;
      for (const [dx, dy] of LabelPlacer.directions) {
        const left = x + dx * distance - (dx < 0 ? width : dx > 0 ? 0 : width / 2);
        const box = {x: left, y: y + dy * distance - size / 2, width, height: size};
        const cost = this.cost(box, distance);
        if (cost < least) [best, least] = [{box, leader: ring > 0}, cost];
      }
    }
    if (best) this.texts.push(best.box);
    return best;
  }
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
const LINE_WIDTHS = {measure: 7, guide: 1.4};  // all others 2.6
const DASHED = ['candidate', 'rejected'];

class Drawing {
  constructor(element, prefix) {
    this.element = element;
    this.prefix = prefix;
    this.svg = svg('svg', {role: 'img'});
    this.overview = html('canvas', {'aria-hidden': 'true'});
    element.replaceChildren(this.svg, this.overview);
  }
  load(run) {
    this.run = run;
    if (!run.shows('drawing')) return;
    const {picture, lower} = run.trace.grid;
    this.texels = picture ? {...picture, lower, rgba: decodePicture(picture)} : null;
    this.stillKey = null;
  }
  texel(x, y) {
    const t = this.texels, column = x - t.lower[0], row = y - t.lower[1];
    if (column < 0 || row < 0 || column >= t.width || row >= t.height) return null;
    const i = 4 * (row * t.width + column);
    return t.rgba.subarray(i, i + 4);
  }

  /** Draws one step. Everything that can be seen depends on the arguments only. */
  draw(index, theme, s) {
    const {trace, playhead, steps} = this.run;
    const width = this.element.clientWidth, height = this.element.clientHeight;
    this.theme = theme;
    this.canvas = playhead.at(index);
    this.at = arrange(trace.grid, width, height, s, steps[index].focus);
    this.labels = new LabelPlacer(this.at);
    this.keepStill(`${width} ${height} ${s} ${theme.name} ${JSON.stringify(this.at.view)}`);
    const {plane} = this.canvas;
    if (!plane) this.labels.texts.push(...this.stillTexts);
    const cells = this.shownCells = this.visibleCells();
    const areas = svg('g', {'data-layer': 'areas'}), over = svg('g'), dots = svg('g'), texts = svg('g');
    const pending = this.drawMarks(areas, over, dots, texts);
    this.placeLabels(pending, cells, over, texts);
    this.svg.replaceChildren(
        this.patterns, this.picture, this.grounds(cells), this.colors(cells), plane ? '' : this.still,
        plane ? '' : this.centres(), this.outlines(cells),
        this.cellTexts(cells), areas, over, dots, texts);
    this.svg.setAttribute('width', width);
    this.svg.setAttribute('height', height);
    this.overview.hidden = !this.at.follows;
    if (this.at.follows) this.drawOverview();
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
    this.patterns = this.makePatterns();
    this.picture = this.texels ? this.drawPicture() : svg('g');
    this.still = svg('g', {}, this.drawGrid(), ...this.drawAxes());
    if (this.at.follows) this.still.append(...this.captionOverview());
  }
  makePatterns() {
    const size = 9 * this.at.s, defs = svg('defs');
    this.theme.roles.forEach((look, role) => {
      const d = {
        rising: `M0 ${size}L${size} 0M${-size / 4} ${size / 4}L${size / 4} ${-size / 4}` +
            `M${size * 0.75} ${size * 1.25}L${size * 1.25} ${size * 0.75}`,
        falling: `M0 0L${size} ${size}`,
        cross: `M0 0L${size} ${size}M0 ${size}L${size} 0`,
      }[look.hatch];
      if (!d) return;
      defs.append(svg(
          'pattern', {id: this.patternId(role), width: size, height: size, patternUnits: 'userSpaceOnUse'},
          svg('path', {d, stroke: look.mark, 'stroke-width': 1.1 * this.at.s, 'stroke-opacity': 0.75})));
    });
    return defs;
  }
  patternId(role) { return `${this.prefix}-hatch-${role}`; }

  drawPicture() {
    const {x0, y0, x1, y1} = this.at.view, {box} = this.at;
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
        {...box, href: small.toDataURL(), preserveAspectRatio: 'none', style: 'image-rendering: pixelated'});
  }
  drawGrid() {
    const {box, cell, view, s} = this.at;
    let lines = '';
    for (let i = 0; i <= view.x1 - view.x0 + 1; ++i) lines += `M${box.x + i * cell} ${box.y}v${box.height}`;
    for (let i = 0; i <= view.y1 - view.y0 + 1; ++i) lines += `M${box.x} ${box.y + i * cell}h${box.width}`;
    return svg('path', {d: lines, fill: 'none', stroke: this.theme.tones.rule, 'stroke-width': 1.5 * s});
  }
  /** A dot in the middle of each cell, where nothing else stands. */
  centres() {
    if (this.texels) return svg('g');
    const {view, s} = this.at, wall = this.run.trace.roles.indexOf('boundary');
    let d = '';
    for (let y = view.y0; y <= view.y1; ++y) {
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
      'stroke-linecap': 'round',
      'stroke-opacity': 0.7
    });
  }
  drawAxes() {
    const {box, cell, view, s, width} = this.at, {grid} = this.run.trace, below = box.y + box.height + 26 * s;
    const widest = Math.max(...[view.x0, view.x1].map((x) => textWidth(written(x), TEXT * s)));
    const out = [
      this.tick(
          grid.x_name, Math.min(box.x + box.width + 6 * s, width - textWidth(grid.x_name, TEXT * s) - 4 * s),
          below, 'start', 'italic'),
      this.tick(
          grid.y_name, Math.max(box.x - 10 * s, textWidth(grid.y_name, TEXT * s, 'italic')), box.y - 10 * s,
          'end', 'italic'),
    ];
    const name = grown(this.stillTexts[0], 6 * s);
    for (const x of ticks(view.x0, view.x1, tickStep(cell, widest + 10 * s))) {
      const px = toPixels(this.at, x, 0)[0], half = textWidth(written(x), TEXT * s) / 2;
      if (px - half < 0 || px + half > name.x) continue;
      out.push(this.tick(written(x), px, below, 'middle'));
    }
    for (const y of ticks(view.y0, view.y1, tickStep(cell, 24 * s))) {
      out.push(this.tick(written(y), box.x - 10 * s, toPixels(this.at, 0, y)[1] + 7 * s, 'end'));
    }
    return out;
  }
  tick(text, x, y, anchor, style) {
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
        'stroke-dasharray': look.dashed && `${9 * s} ${6 * s}`
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
        text);
  }

  // Marks: drawn at once; labels come later, when it is known what is in their way
  drawMarks(areas, strokes, dots, texts) {
    const pending = {fixed: [], free: [], texts: []};
    for (const mark of this.run.trace.backdrop) this.drawMark(mark, areas, strokes, dots, pending, 'fixed');
    this.fixedStrokes = this.labels.strokes.length;
    for (const mark of this.canvas.sortedMarks()) this.drawMark(mark, areas, strokes, dots, pending, 'free');
    for (const text of pending.texts) this.drawText(text, texts);
    return pending;
  }
  drawMark(mark, areas, strokes, dots, pending, standing) {
    const [id, role, kind, ...rest] = mark;
    const look = this.theme.roles[role];
    const attributes = {
      'data-role': this.run.trace.roles[role],
      ...(standing === 'free' ? {'data-mark': id} : {'pointer-events': 'none'})
    };
    if (kind === 'area')
      this.drawArea(rest, role, attributes, areas);
    else if (kind === 'text')
      pending.texts.push(
          {at: toPixels(this.at, rest[0], rest[1]), text: rest[2], align: rest[3], look, attributes});
    else if (kind === 'label')
      pending[standing].push({at: toPixels(this.at, rest[0], rest[1]), text: rest[2], look, attributes});
    else if (kind === 'dot' || kind === 'ring')
      this.drawDot(rest, kind, look, attributes, dots);
    else
      this.drawChain(rest, kind, look, attributes, strokes);
  }
  drawArea(rings, role, attributes, group) {
    let d = '';
    for (const ring of rings) {
      for (let i = 0; i + 1 < ring.length; i += 2)
        d += `${i === 0 ? 'M' : 'L'}${toPixels(this.at, ring[i], ring[i + 1]).join(' ')}`;
      d += 'z';
    }
    const look = this.theme.roles[role];
    group.append(svg('path', {d, fill: look.fill, 'fill-rule': 'evenodd', ...attributes}));
    if (look.hatch !== 'none')
      group.append(svg('path', {
        d,
        fill: `url(#${this.patternId(role)})`,
        'fill-rule': 'evenodd',
        'pointer-events': 'none'
      }));
  }
  /** Just where it stands; left out where it would lie on another text. */
  drawText({at: [x, y], text, align, look, attributes}, group) {
    const {s} = this.at, {labels} = this, size = TEXT * s, width = textWidth(text, size);
    const left = x - {left: 0, centre: 0.5, right: 1}[align] * width;
    const box = {x: left, y: y - 0.5 * size, width, height: size};
    if (!inside({x, y, width: 0, height: 0}, grown(this.at.box, 1)) || !inside(box, labels.room)) return;
    if (labels.texts.some((other) => overlap(grown(box, 2 * s), other))) return;
    labels.texts.push(box);
    group.append(this.text(text, left, y + 0.35 * size, look.text, this.theme.tones.paper, attributes));
  }
  drawDot([x, y], kind, look, attributes, group) {
    const {s, box} = this.at, [cx, cy] = toPixels(this.at, x, y);
    if (!inside({x: cx, y: cy, width: 0, height: 0}, box)) return;
    const r = (attributes['data-role'] === 'input' ? 7 : 6) * s;
    this.labels.taken.push({x: cx - r, y: cy - r, width: 2 * r, height: 2 * r});
    const ring = kind === 'ring';
    group.append(svg('circle', {
      cx,
      cy,
      r,
      fill: ring ? this.theme.tones.paper : look.mark,
      stroke: look.mark,
      'stroke-width': ring ? 3 * s : 0,
      ...attributes
    }));
  }
  drawChain(rest, kind, look, attributes, group) {
    const {s, box} = this.at;
    const numbers = numbersOf(kind, rest), points = [];
    for (let i = 0; i + 1 < numbers.length; i += 2)
      points.push(toPixels(this.at, numbers[i], numbers[i + 1]));
    if (kind === 'polygon' && points.length > 0) points.push(points[0]);
    let d = '', last = null;
    for (let i = 0; i + 1 < points.length; ++i) {
      const part = clipped(points[i], points[i + 1], box);
      if (!part) continue;
      this.labels.strokes.push(part);
      d += `M${part[0].join(' ')}L${part[1].join(' ')}`;
      last = part;
    }
    if (!d) return;
    const role = attributes['data-role'], width = (LINE_WIDTHS[role] ?? 2.6) * s;
    const dashed = DASHED.includes(role) || rest.at(-1) === 'dashed';
    group.append(svg('path', {
      d,
      fill: 'none',
      stroke: look.mark,
      'stroke-width': width,
      'stroke-linejoin': 'round',
      'stroke-linecap': dashed ? 'butt' : 'round',
      'stroke-dasharray': dashed && `${9 * s} ${6 * s}`,
      ...attributes
    }));
    if (kind === 'arrow') group.append(this.arrowHead(last, width, look, attributes));
  }
  arrowHead([[ax, ay], [bx, by]], width, look, attributes) {
    const length = Math.hypot(bx - ax, by - ay) || 1, size = 4 * width;
    const [ux, uy] = [((bx - ax) / length) * size, ((by - ay) / length) * size];
    const d = `M${bx} ${by}L${bx - ux - uy / 2} ${by - uy + ux / 2}L${bx - ux + uy / 2} ${by - uy - ux / 2}z`;
    return svg('path', {d, fill: look.mark, ...attributes});
  }

  /** Those that stand through all steps come first and keep still, off every cell that some step touches. */
  placeLabels(pending, cells, over, texts) {
    const {labels} = this, {strokes, taken} = labels;
    labels.strokes = strokes.slice(0, this.fixedStrokes);
    labels.taken =
        pending.fixed.length > 0 ? this.visibleCells(this.run.touched).map((cell) => this.square(cell)) : [];
    labels.crowded =
        labels.taken.map((square) => grown(square, square.width));  // the steps' own labels need room
    for (const label of pending.fixed) this.placeLabel(label, over, texts);
    Object.assign(labels, {strokes, taken, crowded: []});
    const quiet = new Set(['past', 'boundary', 'result']);
    for (const cell of cells) {
      (quiet.has(this.run.trace.roles[cell[2]]) ? labels.crowded : labels.taken).push(this.square(cell));
    }
    for (const label of pending.free) this.placeLabel(label, over, texts);
  }
  square([x, y]) {
    const {cell} = this.at, [px, py] = toPixels(this.at, x, y);
    return {x: px - cell / 2, y: py - cell / 2, width: cell, height: cell};
  }
  placeLabel({at: [x, y], text, look, attributes}, over, texts) {
    if (!inside({x, y, width: 0, height: 0}, grown(this.at.box, 1))) return;
    const found = this.labels.place([x, y], text);
    if (!found) return;
    const {box, leader} = found;
    if (leader) {
      const end = [clamp(x, box.x, box.x + box.width), clamp(y, box.y, box.y + box.height)];
      over.append(svg('path', {
        d: `M${end.join(' ')}L${x} ${y}`,
        stroke: look.text,
        'stroke-width': 1.4 * this.at.s,
        'pointer-events': 'none'
      }));
    }
    texts.append(
        this.text(text, box.x, box.y + 0.78 * box.height, look.text, this.theme.tones.paper, attributes));
  }

  // The whole grid, small, with the part that is seen
  overviewBox() {
    const {grid} = this.run.trace, {s, width} = this.at;
    const ratio = (grid.upper[0] - grid.lower[0] + 1) / (grid.upper[1] - grid.lower[1] + 1);
    const box = {x: 0, y: 4 * s, width: INSET * s * ratio, height: INSET * s};
    const caption = Math.max(...this.overviewLines().map((text) => textWidth(text, TEXT * s)));
    const most = Math.max(width - caption - 24 * s, 40 * s);
    if (box.width > most) [box.width, box.height] = [most, most / ratio];
    return {...box, width: Math.max(box.width, 6 * s), height: Math.max(box.height, 6 * s)};
  }
  overviewLines() {
    const {grid} = this.run.trace, {x0, y0, x1, y1} = this.at.view;
    return [
      say('whole', {columns: grid.upper[0] - grid.lower[0] + 1, rows: grid.upper[1] - grid.lower[1] + 1}),
      `${grid.x_name} ${written(x0)} … ${written(x1)}`, `${grid.y_name} ${written(y0)} … ${written(y1)}`
    ];
  }
  captionOverview() {
    const {s} = this.at, box = this.overviewBox(), x = box.x + box.width + 14 * s;
    return this.overviewLines().map((text, i) => this.tick(text, x, box.y + (20 + 28 * i) * s, 'start'));
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
      for (const [x, [role]] of cells) {
        const [left, right] = span(x - lower[0], width, across);
        for (let r = low; r < high; ++r) {
          const row = yUp ? height - 1 - r : r;
          if (row >= 0 && row < height)
            texels.fill(colors[role], row * width + Math.max(left, 0), row * width + Math.min(right, width));
        }
      }
    }
    return image;
  }

  /** How a role can be seen now: as a cell, as an area, as a mark; null: not at all. */
  seenAs(role) {
    if (this.shownCells.some((cell) => cell[2] === role)) return 'cell';
    let as = null;
    for (const [, of, kind] of [...this.run.trace.backdrop, ...this.canvas.marks.values()]) {
      if (of !== role || kind === 'text') continue;
      if (kind === 'area') return 'area';
      as = 'mark';
    }
    return as;
  }
  legendRoles() { return this.run.trace.legend.filter(([role]) => this.seenAs(role)); }
  /** A role as it looks in the drawing, for the legend. */
  swatch(role, s) {
    const look = this.theme.roles[role], name = this.run.trace.roles[role], width = 24 * s, height = 18 * s;
    const image = svg('svg', {width, height, 'aria-hidden': 'true'});
    const as = this.seenAs(role);
    if (as === 'mark') {
      image.append(svg('path', {
        d: `M0 ${height / 2}h${width}`,
        stroke: look.mark,
        'stroke-width': (name === 'measure' ? 6 : 3) * s,
        'stroke-dasharray': DASHED.includes(name) && `${7 * s} ${4 * s}`
      }));
      return image;
    }
    const line = Math.min(look.outline, 4) * s;
    const d = `M${line / 2} ${line / 2}h${width - line}v${height - line}h${line - width}z`;
    image.append(svg('path', {d, fill: look.fill}));
    if (look.hatch !== 'none') image.append(svg('path', {d, fill: `url(#${this.patternId(role)})`}));
    if (as === 'area') return image;
    if (line)
      image.append(svg('path', {
        d,
        fill: 'none',
        stroke: look.mark,
        'stroke-width': line,
        'stroke-dasharray': look.dashed && `${5 * s} ${3 * s}`
      }));
    if (look.cross) {
      const cross = crossPath(width / 2, height / 2, 0.25 * height);
      image.append(svg('path', {d: cross, stroke: look.mark, 'stroke-width': 1.5 * s}));
    }
    return image;
  }
}
