'use strict';
// Places for labels among cells, strokes and each other.

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
  crowded = [];  // [box, weight]: cells and pictures it had better not cover
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
    for (const cell of this.taken) {
      // Half of a dot is as bad as half of the label, and a touch already covers it or seems to name it
      const covered = overlap(box, cell), own = Math.max(cell.width * cell.height, 1);
      cost += (900 * s * covered) / Math.min(own, Math.max(area, 1));
      if (covered > 0 && own < area) cost += 300 * s;
    }
    for (const [cell, weight] of this.crowded) cost += (weight * s * overlap(box, cell)) / area;
    // Beside a line whose cells are still to come, a label would soon be covered
    const nearness = (clear > 20 * s ? 320 : 160) * s;
    for (const [a, b] of this.strokes) cost += clipped(a, b, clearing) ? nearness : 0;
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
