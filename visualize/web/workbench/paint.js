'use strict';
// Walls of a maze are painted in its drawing: where one is it goes, where none is one comes.

class Painter {
  /** host: {maze(), change(rows), commit()}: the rows of the maze, joined by "/"; '' where none can be painted. */
  constructor(player, host) {
    this.player = player;
    this.host = host;
    this.at = [1, 1];
    const {drawing} = player.parts;
    drawing.addEventListener('pointerdown', (event) => this.begin(event));
    drawing.addEventListener('pointermove', (event) => this.move(event));
    for (const ends of ['pointerup', 'pointercancel']) drawing.addEventListener(ends, () => this.finish());
    // A stroke of paint is no click on a cell
    drawing.addEventListener('click', (event) => {
      if (this.painted) event.stopPropagation();
      this.painted = false;
    }, true);
    this.brush = html('button', {type: 'button', class: 'brush', hidden: ''});
    this.brush.addEventListener('keydown', (event) => this.key(event));
    drawing.append(this.brush);
  }
  rows() {
    const maze = this.host.maze();
    return maze ? maze.split('/') : null;
  }
  cellOf(event) {
    const cell = this.player.cellAt(event), rows = this.rows();
    return cell && rows?.[cell[1]]?.[cell[0]] !== undefined ? cell : null;
  }
  begin(event) {
    const cell = event.button === 0 && !event.target.closest('.handle, .brush') && this.cellOf(event);
    if (!cell) return;
    event.preventDefault();
    this.player.parts.drawing.setPointerCapture(event.pointerId);
    this.paint = this.rows()[cell[1]][cell[0]] === '#' ? '.' : '#';
    this.at = cell;
    this.set(cell);
  }
  move(event) {
    const cell = this.paint && this.cellOf(event);
    if (!cell) return;
    // A quick hand skips cells
    const [x0, y0] = this.at, count = Math.max(Math.abs(cell[0] - x0), Math.abs(cell[1] - y0), 1);
    for (let i = 1; i <= count; ++i)
      this.set([Math.round(x0 + ((cell[0] - x0) * i) / count), Math.round(y0 + ((cell[1] - y0) * i) / count)]);
    this.at = cell;
  }
  set([x, y]) {
    const rows = this.rows();
    if (rows[y][x] === this.paint) return;
    rows[y] = rows[y].slice(0, x) + this.paint + rows[y].slice(x + 1);
    this.painted = true;
    this.host.change(rows.join('/'));
  }
  finish() {
    if (this.paint && this.painted) this.host.commit();
    this.paint = null;
  }
  /** The brush stands on a cell: arrows move it, space paints. */
  place() {
    const rows = this.rows(), {at} = this.player.drawing;
    this.brush.hidden = !rows || !at;
    if (this.brush.hidden) return;
    const y = clamp(this.at[1], 0, rows.length - 1), x = clamp(this.at[0], 0, rows[y].length - 1);
    this.at = [x, y];
    const [px, py] = toPixels(at, x, y), label = say('paint', {x, y, what: say(rows[y][x] === '#' ? 'wall' : 'free')});
    const size = `${Math.max(at.cell, 24)}px`;
    Object.assign(this.brush.style, {left: `${px}px`, top: `${py}px`, width: size, height: size});
    this.brush.setAttribute('aria-label', label);
  }
  key(event) {
    const by = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
    if (!by && event.key !== ' ') return;
    event.preventDefault();
    event.stopPropagation();
    if (by) {
      this.at = [this.at[0] + by[0], this.at[1] + by[1]];
      return this.place();
    }
    const [x, y] = this.at;
    this.paint = this.rows()[y][x] === '#' ? '.' : '#';
    this.set(this.at);
    this.finish();
  }
}
