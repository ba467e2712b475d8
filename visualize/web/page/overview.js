'use strict';
// The whole grid, small, on a canvas, with the part that the drawing shows.

const hexRgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));

class Overview {
  constructor(drawing) {
    this.drawing = drawing;
    this.element = html('canvas', {'aria-hidden': 'true'});
  }
  box() {
    const {grid} = this.drawing.run.trace, {s, inset, follows} = this.drawing.at, beside = follows === 'beside';
    const ratio = (grid.upper[0] - grid.lower[0] + 1) / (grid.upper[1] - grid.lower[1] + 1);
    const below = !this.aside() && this.captioned() ? 90 * s : 0;
    const most = beside ? inset.width : Math.min(0.55 * inset.width, inset.width - this.captionWidth() - 24 * s);
    const high = grid.picture ? inset.height : 150 * s;
    const height = Math.min(inset.height - below, high, Math.max(most, 40 * s) / ratio);
    return {x: inset.x, y: inset.y, width: Math.max(height * ratio, 6 * s), height: Math.max(height, 6 * s)};
  }
  /** Whether words stand beside it, not below. */
  aside() {
    const {grid} = this.drawing.run.trace, {s, inset, follows} = this.drawing.at;
    const ratio = (grid.upper[0] - grid.lower[0] + 1) / (grid.upper[1] - grid.lower[1] + 1);
    return follows !== 'beside' || (!!grid.picture && inset.width - inset.height * ratio > 160 * s);
  }
  captionWidth() { return Math.max(...this.lines().map((text) => textWidth(text, TEXT * this.drawing.at.s))); }
  /** Whether there is room for words; the axes say it, too. */
  captioned() {
    const {s, inset, follows} = this.drawing.at;
    return follows !== 'beside' || (inset.height > 160 * s && this.captionWidth() <= inset.width);
  }
  lines() {
    const {grid} = this.drawing.run.trace, {x0, y0, x1, y1} = this.drawing.at.view;
    return [
      say('whole', {columns: grid.upper[0] - grid.lower[0] + 1, rows: grid.upper[1] - grid.lower[1] + 1}),
      `${grid.x_name} ${written(x0)} … ${written(x1)}`, `${grid.y_name} ${written(y0)} … ${written(y1)}`
    ];
  }
  caption() {
    if (!this.captioned()) return [];
    const {s, inset} = this.drawing.at, box = this.box(), aside = this.aside();
    const x = aside ? box.x + box.width + 14 * s : inset.x, y = aside ? box.y + 20 * s : box.y + box.height + 24 * s;
    return this.lines().map((text, i) => this.drawing.stillText(text, x, y + 28 * i * s, 'start'));
  }
  draw() {
    const box = this.box(), dpr = window.devicePixelRatio || 1, {s} = this.drawing.at;
    const {element} = this;
    Object.assign(
        element.style,
        {left: `${box.x}px`, top: `${box.y}px`, width: `${box.width}px`, height: `${box.height}px`});
    element.width = Math.max(Math.round(box.width * dpr), 1);
    element.height = Math.max(Math.round(box.height * dpr), 1);
    const context = element.getContext('2d');
    context.putImageData(this.image(context), 0, 0);
    const place = this.place();
    for (const mark of this.drawing.run.trace.backdrop) this.drawMark(context, mark, place, s * dpr);
    const {x0, y0, x1, y1} = this.drawing.at.view;
    const [ax, ay] = place(x0 - 0.5, y0 - 0.5), [bx, by] = place(x1 + 0.5, y1 + 0.5), least = 8 * s * dpr;
    const seen = {width: Math.max(Math.abs(bx - ax), least), height: Math.max(Math.abs(by - ay), least)};
    seen.x = clamp((ax + bx) / 2 - seen.width / 2, 2 * dpr, element.width - seen.width - 2 * dpr);
    seen.y = clamp((ay + by) / 2 - seen.height / 2, 2 * dpr, element.height - seen.height - 2 * dpr);
    context.lineWidth = 3 * s * dpr;
    context.strokeStyle = this.drawing.look('current').mark;
    context.strokeRect(seen.x, seen.y, seen.width, seen.height);
    context.lineWidth = 1.5 * dpr;
    context.strokeStyle = this.drawing.theme.tones.muted;
    context.strokeRect(0, 0, element.width, element.height);
  }
  place() {
    const {lower, upper, y_up: yUp} = this.drawing.run.trace.grid, {width, height} = this.element;
    return (x, y) => {
      const fx = (x - lower[0] + 0.5) / (upper[0] - lower[0] + 1);
      const fy = (y - lower[1] + 0.5) / (upper[1] - lower[1] + 1);
      return [fx * width, (yUp ? 1 - fy : fy) * height];
    };
  }
  drawMark(context, [, role, kind, ...rest], place, scale) {
    if (!['stroke', 'arrow', 'path', 'polygon'].includes(kind)) return;
    const numbers = numbersOf(kind, rest);
    context.beginPath();
    for (let i = 0; i + 1 < numbers.length; i += 2) context.lineTo(...place(numbers[i], numbers[i + 1]));
    if (kind === 'polygon') context.closePath();
    context.lineWidth = 2 * scale;
    context.strokeStyle = this.drawing.theme.roles[role].mark;
    context.stroke();
  }
  image(context) {
    const {width, height} = this.element, image = context.createImageData(width, height);
    const {lower, upper, y_up: yUp} = this.drawing.run.trace.grid;
    const across = upper[0] - lower[0] + 1, up = upper[1] - lower[1] + 1;
    const texels = new Uint32Array(image.data.buffer);
    const packed = ([r, g, b, a = 255]) => new Uint32Array(new Uint8Array([r, g, b, a]).buffer)[0];
    const paper = packed(hexRgb(this.drawing.theme.tones.panel));
    for (let row = 0; row < height; ++row) {
      for (let column = 0; column < width; ++column) {
        const y = Math.floor(((yUp ? height - 1 - row : row) * up) / height) + lower[1];
        const texel = this.drawing.texels && this.drawing.texel(Math.floor((column * across) / width) + lower[0], y);
        texels[row * width + column] = texel ? packed(texel) : paper;
      }
    }
    const colors = this.drawing.theme.roles.map((look) => packed(hexRgb(look.mark)));
    // First and one past the last pixel of a cell; at least one
    const span = (cell, pixels, cells) => {
      const from = Math.floor((cell * pixels) / cells);
      return [from, Math.max(Math.floor(((cell + 1) * pixels) / cells), from + 1)];
    };
    for (const [y, cells] of this.drawing.canvas.rows) {
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
}
