'use strict';
// What of a drawing stays while the view does: the picture, the grid's lines, the axes.

class StillDrawing {
  /** Draws it anew next time, for texts are as wide as the letters there are. */
  forgetStill() { this.stillKey = null; }
  keepStill(key) {
    if (key === this.stillKey) return;
    this.stillKey = key;
    this.stillTexts = [];
    this.stillTicks = [];
    this.patterns = this.makePatterns();
    this.picture = this.texels ? this.drawPicture() : svg('g');
    this.still = svg('g', {}, this.drawGrid(), ...this.drawAxes());
    if (this.at.follows) this.still.append(...this.overview.caption());
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
  /** All cells of the view; more than what is shown where a paper is cut inside a cell. */
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
    const texts = this.marked.map(({box}) => grown(box, 8 * s));  // a dot beside one would be its punctuation
    let d = '';
    for (let y = this.firstRow(); y <= view.y1; ++y) {
      for (let x = view.x0; x <= view.x1; ++x) {
        const look = this.canvas.look(x, y);
        if (look && (look[0] === wall || look[1] !== '' || look[2])) continue;
        const [px, py] = toPixels(this.at, x, y), dot = {x: px, y: py, width: 1, height: 1};
        if (!texts.some((text) => overlap(text, dot))) d += `M${px} ${py}h0`;
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
    const onLines = grid.on_lines ? 1 : 0, off = onLines / 2;  // then one more than there are cells
    for (const x of ticks(view.x0, view.x1 + onLines, tickStep(cell, widest + 10 * s))) {
      const px = toPixels(this.at, x - off, 0)[0], half = textWidth(written(x), size) / 2;
      if (px + half > right - name - 8 * s) break;
      out.push(this.tick(written(x), px, bottom, 'middle'));
      end = px + half;
    }
    const columns = [...this.stillTexts];  // whose first number is near the corner
    out.push(this.nameRows());
    const {y, height} = this.stillTexts.at(-1);
    // On lines one of the columns' numbers stands below the corner
    const gap = Math.max(8 * s, onLines * (2 * s + widest / 2));
    for (const row of ticks(this.firstRow(), view.y1 + onLines, tickStep(cell, 24 * s))) {
      const baseline = toPixels(this.at, 0, row - off)[1] + 7 * s;
      if (!this.namesBeside() && !this.isAside() && baseline - 0.8 * size <= y + height) continue;
      const width = textWidth(written(row), size), edge = box.x - gap;
      const number = {x: edge - width, y: baseline - 0.8 * size, width, height: size};
      if (columns.some((other) => overlap(other, number))) continue;
      out.push(this.tick(written(row), edge, baseline, 'end'));
    }
    const x = Math.max(Math.min(box.x + box.width + 6 * s, right - name), end + 8 * s);
    out.push(this.stillText(grid.x_name, x, bottom, 'start', 'italic'));
    return out;
  }
  /** The arrow behind the name of the rows says where they grow; columns always grow to the right. */
  nameRows() {
    const {box, s, yUp, left} = this.at, {y_name: name} = this.run.trace.grid, size = TEXT * s;
    const text = `${name} ${yUp ? '↑' : '↓'}`, edge = box.x - 8 * s;
    const {cell, view} = this.at, shelf = yUp ? 0 : (this.firstRow() - view.y0) * cell;
    const rise = shelf + (this.run.trace.grid.on_lines ? 0 : cell / 2);
    if (this.isAside()) return this.stillText(text, left, box.y + rise + 7 * s, 'start', 'italic');
    if (this.namesBeside()) return this.stillText(text, box.x, box.y - 6 * s, 'start', 'italic');
    if (!this.hasRoomAbove()) return this.stillText(text, edge, box.y + 16 * s, 'end', 'italic');
    // A long name may stand over the grid's corner, but not in the margin
    const x = Math.max(edge - textWidth(name, size, 'italic'), left);
    return this.stillText(text, x, box.y - 7 * s, 'start', 'italic');
  }
  hasRoomAbove() { return this.at.box.y - this.at.top >= TEXT * this.at.s || this.at.follows; }
  /** Whether the name of the rows stands left of all numbers, beside the upper one. */
  isAside() {
    return !this.hasRoomAbove() && (this.run.trace.grid.on_lines || this.at.cell < HIGH_CELL * this.at.s);
  }
  /** Whether it stands right of the first number, not over it: on lines, and where that reaches up to it. */
  namesBeside() { return this.hasRoomAbove() && (this.run.trace.grid.on_lines || this.at.cell < 24 * this.at.s); }
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
}
