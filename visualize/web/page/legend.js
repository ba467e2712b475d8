'use strict';
// What the legend says below a drawing: the roles that can be seen in it, and how their marks look.

/** Kinds of marks, as a legend's entry looks: the first that occurs. */
const SAMPLES = ['cell', 'area', 'stroke', 'path', 'polygon', 'arrow', 'dot', 'ring'];
const LINES = ['stroke', 'path', 'polygon', 'arrow'];

class Legend {
  constructor(drawing) { this.drawing = drawing; }

  /** The kinds of marks that show a role now. */
  kindsOf(role) {
    const kinds = {cell: this.drawing.shownCells.some((cell) => cell[2] === role && !cell[4]), solid: false, shade: 0, quantities: []};
    for (const [, of, kind, ...rest] of [...this.drawing.run.trace.backdrop, ...this.drawing.canvas.marks.values()]) {
      if (of !== role) continue;
      kinds[kind] = true;
      if (kind === 'area') kinds.shade = Math.max(kinds.shade, Math.min(rest.find(Number.isFinite) ?? 0, 2));
      if (LINES.includes(kind)) kinds.solid ||= !rest.includes('dashed');
      if (kind === 'dot' || kind === 'ring') kinds.quantities.push(quantityOf(rest));
    }
    return kinds;
  }
  /** The mark that stands for a role in the legend: {as, dashed, outlined, shade, quantities, color}; null: it is not seen. */
  markOf([role, , color]) {
    if (color) {
      const seen = this.drawing.shownCells.some((cell) => cell[2] === role && cell[4] === color);
      return seen ? {as: 'cell', color} : null;
    }
    const kinds = this.kindsOf(role), as = SAMPLES.find((kind) => kinds[kind]), lines = LINES.some((kind) => kinds[kind]);
    if (!as) return null;
    const quantities = [...new Set(kinds.quantities)].sort();
    return {as, dashed: lines && !kinds.solid, outlined: Boolean(kinds.area) && lines, shade: kinds.shade, quantities};
  }
  /** What the legend has to name: roles that can be seen, and colours that cells have. */
  entries() { return this.drawing.run.trace.legend.filter((entry) => this.markOf(entry)); }

  /** A legend entry's mark as it looks in the drawing. */
  swatch(entry, s) {
    const mark = this.markOf(entry), [role] = entry, look = this.drawing.theme.roles[role];
    const dots = mark.as === 'dot' || mark.as === 'ring' ? mark.quantities.length : 0;
    const width = (dots === 1 ? 18 : 32) * s, height = 18 * s;
    const image = svg('svg', {width, height, 'aria-hidden': 'true'});
    image.append(...this.sample(mark, role, look, width, height, s));
    return image;
  }
  sample(mark, role, look, width, height, s) {
    const {as, dashed} = mark, rim = (by) => `M${by} ${by}h${width - 2 * by}v${height - 2 * by}h${2 * by - width}z`;
    const outline = () => this.drawing.lineShapes(rim((LINE_WIDTHS[look.role] * s) / 2), look, {dashed}, s);
    const line = () => this.drawing.lineShapes(`M0 ${height / 2}h${width}`, look, {dashed}, s);
    if (as === 'stroke' || as === 'path') return line();
    if (as === 'polygon') return outline();
    if (as === 'arrow') {
      const ends = [[0, height / 2], [width, height / 2]];
      return [...line(), this.drawing.arrowHead(ends, look, {}, s)];
    }
    if (as === 'dot' || as === 'ring')
      return mark.quantities.map((symbol, i) => this.drawing.disc(
          ((i + 0.5) * width) / mark.quantities.length, height / 2, as === 'ring', this.drawing.lookOf(role, symbol), s));
    if (as === 'area') {
      const d = rim(mark.outlined ? (LINE_WIDTHS[look.role] * s) / 2 : 0);
      return [...this.drawing.areaShapes(d, role, mark.shade), ...(mark.outlined ? outline() : [])];
    }
    if (mark.color) return [svg('path', {d: rim(0), fill: mark.color})];
    return [...this.drawing.areaShapes(rim(0), role, 0, {}, look.hatch), ...this.cellOutline(look, width, height, s)];
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
