'use strict';
// The drawing of a step: grid, cells, marks and labels as SVG.

/** The texels of a grid's picture as RGBA bytes. */
function decodePicture(picture) {
  const bytes = Uint8Array.from(atob(picture.indices ?? picture.rgba), (c) => c.charCodeAt(0));
  if (!picture.palette) return bytes;
  const out = new Uint8Array(4 * bytes.length);
  bytes.forEach((index, i) => out.set(picture.palette[index], 4 * i));
  return out;
}

/** A picture as the address of an image. */
const addresses = new WeakMap();
function imageAddressOf(picture) {
  if (!addresses.has(picture)) {
    const canvas = html('canvas', {width: picture.width, height: picture.height});
    const context = canvas.getContext('2d'), image = context.createImageData(picture.width, picture.height);
    image.data.set(decodePicture(picture));
    context.putImageData(image, 0, 0);
    addresses.set(picture, canvas.toDataURL());
  }
  return addresses.get(picture);
}

/** x and y in turn, of a mark that is a chain of strokes. */
const numbersOf = (kind, rest) => (kind === 'path' || kind === 'polygon' ? rest[0] : rest.slice(0, 4));
const LINE_WIDTHS = {
  current: 6, result: 5, measure: 5, boundary: 4, accepted: 4, input: 3, candidate: 4, rejected: 3, past: 2.2, guide: 1.4
};
/** Whose value a mark shows, by its symbol. */
const quantityOf = (rest) => rest.find((part) => part?.quantity)?.quantity;
/** A text is wider than high. */
function distanceOfText([x, y], [[ax, ay], [bx, by]]) {
  const wx = 0.8 * (bx - ax), wy = by - ay, tx = 0.8 * (x - ax), ty = y - ay, length = wx * wx + wy * wy;
  const t = length > 0 ? clamp((tx * wx + ty * wy) / length, 0, 1) : 0;
  return Math.hypot(tx - t * wx, ty - t * wy);
}
/** Of a text in a paragraph: so many lines below its place. */
const lineOf = (rest) => (Number.isInteger(rest[4]) ? rest[4] : 0);
const THIN = 1.6;
const GAP = 3.5;  // on either side of a line that passes in front
const dashes = (width) => `${3 * width} ${2 * width}`;
const DASHED = ['candidate', 'rejected'];

class Drawing extends StillDrawing {
  constructor(element, prefix) {
    super();
    this.element = element;
    this.prefix = prefix;
    this.svg = svg('svg', {role: 'img'});
    this.overview = new Overview(this);
    this.legend = new Legend(this);
    element.replaceChildren(this.svg, this.overview.element);
  }
  load(run, letters) {
    this.letters = letters;
    this.run = run;
    if (!run.shows('drawing')) return;
    const {picture, lower} = run.trace.grid;
    const stage = new Stage(run.trace);
    const {held} = this;
    if (held?.stage.axes === stage.axes) Object.assign(stage, held.part);
    this.stage = stage;
    this.texels = picture ? {...picture, lower, rgba: decodePicture(picture)} : null;
    this.stillKey = null;
  }
  /** From now on all runs are shown on this part of the plane, and as large: what is dragged must not move the paper below it.
      placed(at, run): how the paper lies in that run, where its story fits what is dragged anew. */
  hold(placed = (at) => at) {
    const {stage, at} = this, {cells, lower, upper, texts} = stage;
    this.held = {stage, at, placed, part: {cells, lower, upper, texts}};
  }
  heldAt() {
    const {at, stage, placed} = this.held ?? {};
    return stage?.axes === this.stage.axes ? placed(at, this.run) : undefined;
  }
  /** Shows all of a run again. */
  letGo() {
    this.held = null;
    this.load(this.run, this.letters);
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
    this.at = this.heldAt() ?? arrange(this.stage, width, height, s, steps[index].focus);
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
        this.patterns, this.picture, this.grounds(cells), this.colors(cells), plane ? '' : areas,
        plane ? '' : this.still, plane ? '' : this.centres(), this.outlines(cells), this.cellTexts(cells),
        plane ? areas : '', besideLines, guides, leaders, lines, onLines, dots, letters);
    this.svg.setAttribute('width', width);
    this.svg.setAttribute('height', height);
    this.overview.element.hidden = !this.at.follows;
    if (this.at.follows) this.overview.draw();
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

  // Cells: one path per role, however many there are
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
    for (const [x, y, role, text, color] of cells) {
      if (!text || cell < 26 * s || textWidth(text, size) > cell - 2 * s) continue;
      const middle = toPixels(this.at, x, y), look = this.theme.roles[role];
      const [px, py] = color ? this.textPlace(middle, textWidth(text, size)) : middle;
      group.append(this.text(text, px, py + 7 * s, look.on, look.fill, {'text-anchor': 'middle'}));
    }
    return group;
  }
  /** On a colour of its own a text stands off the lines that stand through all steps. */
  textPlace(middle, width) {
    const {s, cell} = this.at, spare = [width, TEXT * s].map((side) => Math.max((cell - side) / 2 - 3 * s, 0));
    let best = middle, most = -1;
    for (let k = 0; k < 25; ++k) {
      const place = (k + 12) % 25, off = [(place % 5 - 2) / 2 * spare[0], (Math.floor(place / 5) - 2) / 2 * spare[1]];
      const at = [middle[0] + off[0], middle[1] + off[1]];
      const clear = Math.min(0.4 * cell, ...this.fixedStrokes.map((line) => distanceOfText(at, line)));
      if (clear - 0.1 * Math.hypot(...off) <= most + 1e-6) continue;
      [best, most] = [at, clear - 0.1 * Math.hypot(...off)];
    }
    return best;
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
    this.dotsAt = [];
    const pending = {fixed: [], free: [], texts: []};
    for (const mark of this.run.trace.backdrop) this.drawMark(mark, pending, 'fixed');
    const dots = labels.taken, fixed = {taken: dots.slice(), strokes: labels.strokes.slice()};
    this.fixedStrokes = fixed.strokes;
    for (const mark of this.canvas.sortedMarks()) this.drawMark(mark, pending, 'free');
    for (const text of pending.texts) this.placeText(text);
    this.placeLabels(pending, cells, fixed);
  }
  drawMark(mark, pending, standing) {
    const [id, role, kind, ...rest] = mark;
    const look = this.lookOf(role, quantityOf(rest));
    const attributes = {
      'data-role': this.run.trace.roles[role],
      'data-id': id,
      ...(standing === 'free' ? {'data-mark': id} : {'pointer-events': 'none'})
    };
    if (kind === 'area')
      this.drawArea(rest, role, attributes);
    else if (kind === 'picture')
      this.drawImage(rest, attributes);
    else if (kind === 'text')
      pending.texts.push({
        at: toPixels(this.at, rest[0], rest[1]),
        text: rest[2],
        align: rest[3],
        line: lineOf(rest),
        look,
        attributes
      });
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
  drawImage([ax, ay, bx, by, picture], attributes) {
    const a = toPixels(this.at, ax, ay), b = toPixels(this.at, bx, by), [x, y] = [0, 1].map((i) => Math.min(a[i], b[i]));
    const box = {x, y, width: Math.abs(b[0] - a[0]), height: Math.abs(b[1] - a[1])};
    this.labels.crowded.push([box, 300]);
    this.layers.areas.append(
        svg('image', {...box, href: imageAddressOf(picture), preserveAspectRatio: 'none', ...attributes}));
  }
  drawDot([x, y], kind, look, attributes) {
    const [cx, cy] = toPixels(this.at, x, y);
    if (!inside({x: cx, y: cy, width: 0, height: 0}, grown(this.at.box, 1e-6))) return;
    const disc = this.disc(cx, cy, kind === 'ring', look, this.at.s, attributes), r = Number(disc.getAttribute('r'));
    this.labels.taken.push({x: cx - r, y: cy - r, width: 2 * r, height: 2 * r});
    this.dotsAt.push([cx, cy, r]);
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
  placeText({at: [x, y], text, align, line, look, attributes}) {
    const {s} = this.at, {labels} = this, size = TEXT * s, width = textWidth(text, size);
    const middle = y + line * PARAGRAPH_LINE * s;
    const left = x - {left: 0, centre: 0.5, right: 1}[align] * width;
    const box = {x: left, y: middle - 0.43 * size, width, height: size};
    if (!inside({x, y, width: 0, height: 0}, grown(this.at.box, 1)) || !this.hasRoom(box)) return;
    if (line === 0) Object.assign(box, this.besideDots(box));
    labels.texts.push(box);
    this.marked.push({text, box, baseline: box.y + 0.78 * size, look, attributes});
  }
  hasRoom(box) {
    const {s} = this.at, {labels} = this;
    return inside(box, grown(labels.room, s)) && !labels.texts.some((other) => overlap(grown(box, 2 * s), other));
  }
  liesOnDot({x, y, width, height}) {
    const spare = 0.2 * height, between = (value, least, most) => Math.min(Math.max(value, least), most);
    return this.dotsAt.some(
        ([cx, cy, r]) => Math.hypot(cx - between(cx, x, x + width), cy - between(cy, y + spare, y + height - spare)) < r);
  }
  /** A text that a dot would cover stands a little aside, if there is room. */
  besideDots(box) {
    if (!this.liesOnDot(box)) return box;
    for (let far = 4; far <= 40; far += 4) {
      for (const [dx, dy] of [[0, -1], [0, 1], [-1, 0], [1, 0]]) {
        const aside = {...box, x: box.x + dx * far * this.at.s, y: box.y + dy * far * this.at.s};
        if (this.hasRoom(aside) && !this.liesOnDot(aside)) return aside;
      }
    }
    return box;
  }
  /** Those that stand through all steps come first and look only at what stands too, so that they keep still. */
  placeLabels(pending, cells, fixed) {
    const {labels} = this, {strokes, taken, crowded} = labels, {cell, s} = this.at, {axes} = this.stage;
    const gap = axes ? cell / 2 + 10 * s : 13 * s;
    Object.assign(labels, {...fixed, crowded: []});
    for (const label of pending.fixed) this.placeLabel(label, gap, axes ? cell : 2 * s);
    Object.assign(labels, {strokes, taken, crowded});
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
}
