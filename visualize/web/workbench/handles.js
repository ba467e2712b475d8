'use strict';
// The handles over a drawing: each can be dragged with a mouse, a pen or a thumb, and moved by the arrow keys.

const DRAG_PIXELS = 4;  // what a number's steps are at least, while it is dragged

/** How much to add to each number so that a handle goes by (dx, dy): the least change that does, or comes nearest. */
function changesFor(along, dx, dy) {
  let xx = 0, xy = 0, yy = 0;
  for (const [x, y] of along) {
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const determinant = xx * yy - xy * xy, size = xx + yy;
  if (determinant > 1e-6 * size * size) {
    const a = (yy * dx - xy * dy) / determinant, b = (xx * dy - xy * dx) / determinant;
    return along.map(([x, y]) => a * x + b * y);
  }
  return along.map(([x, y]) => (size > 0 ? (x * dx + y * dy) / size : 0));  // all along one direction
}

/** Where marks stand: all their points, as texts. */
function placesOf(marks) {
  const places = new Set();
  const add = (numbers) => {
    for (let i = 0; i + 1 < numbers.length; i += 2) places.add(placeText(numbers[i], numbers[i + 1]));
  };
  for (const [, , kind, ...rest] of marks) {
    if (kind === 'area')
      rest.filter(Array.isArray).forEach(add);
    else
      add(['dot', 'ring', 'label', 'text'].includes(kind) ? rest.slice(0, 2) : numbersOf(kind, rest));
  }
  return places;
}
const placeText = (x, y) => `${x.toFixed(6)} ${y.toFixed(6)}`;

class HandleLayer {
  /** host: {parameter(name), textOf(parameter), numbers(), shownNumbers(), change(texts), commit()}, which hears of
      what is dragged. */
  constructor(player, host) {
    this.player = player;
    this.host = host;
    this.handles = [];
    this.element = html('div', {class: 'handles'});
    player.parts.drawing.append(this.element);
    player.onDrawn = () => this.place();
  }
  get dragging() { return Boolean(this.drag); }

  /** Those of the run that is seen: their buttons stay while they are the same ones. */
  follow() {
    const {handles = []} = this.player.run.trace;
    const next = handles.map(([name, numbers, [x, y], along]) => (
        {key: `${name} ${numbers}`, name, numbers, at: {x, y}, along: numbers.map((_, i) => along.slice(2 * i, 2 * i + 2))}));
    if (next.length === this.handles.length && next.every(({key}, i) => key === this.handles[i].key)) {
      next.forEach((handle, i) => Object.assign(this.handles[i], handle));
      return;
    }
    if (this.drag) return;
    this.handles = next.map((handle) => ({...handle, button: this.button(handle)}));
    this.element.replaceChildren(...this.handles.map(({button}) => button));
  }
  button(handle) {
    const button = html('button', {type: 'button', class: 'handle'});
    button.addEventListener('pointerdown', (event) => this.begin(event, button));
    button.addEventListener('pointermove', (event) => this.move(event));
    for (const ends of ['pointerup', 'pointercancel', 'lostpointercapture'])
      button.addEventListener(ends, (event) => this.finish(event));
    button.addEventListener('keydown', (event) => this.key(event, button));
    button.addEventListener('click', (event) => event.stopPropagation());
    return button;
  }
  of(button) { return this.handles.find((handle) => handle.button === button); }
  /** "from: 0,0": the numbers that it moves. */
  labelOf({name, numbers}) {
    const own = this.seen.filter((number) => number.name === name);
    const value = numbers.map((index) => written10(own[index]?.value ?? NaN)).join(', ');
    return say('handle', {name: name.replaceAll('_', ' '), value});
  }
  numbers(name) { return this.host.numbers().filter((number) => number.name === name); }

  /** Where they stand now; those that the view or another plane leaves out are hidden. */
  place() {
    const {drawing, run} = this.player, {at} = drawing;
    if (!at || !run || !run.shows('drawing')) return;
    this.follow();
    this.seen = this.host.numbers();
    // On paper a later step may show the input elsewhere, or not at all
    const places = run.trace.grid.axes === false && this.player.index > 0 ? placesOf([...run.trace.backdrop, ...drawing.canvas.sortedMarks()]) : null;
    for (const handle of this.handles) {
      const [x, y] = toPixels(at, handle.at.x, handle.at.y), {button} = handle;
      const inView = x >= 0 && y >= 0 && x <= at.width && y <= at.height;
      button.hidden = this.drag?.handle !== handle && (!inView || !(places?.has(placeText(handle.at.x, handle.at.y)) ?? true));
      button.style.left = `${x}px`;
      button.style.top = `${y}px`;
      const label = this.labelOf(handle);
      button.setAttribute('aria-label', label);
      button.title = label;
    }
  }

  /** A place of the window in the drawing's coordinates. */
  toGrid(clientX, clientY) {
    const box = this.player.parts.drawing.getBoundingClientRect(), {at} = this.player.drawing;
    const px = clientX - box.left, py = clientY - box.top;
    const fromLower = at.yUp ? at.box.y + at.box.height - py : py - at.box.y;
    return {x: at.origin[0] + (px - at.box.x) / at.cell, y: at.origin[1] + fromLower / at.cell};
  }

  // -- Dragging

  begin(event, button) {
    if (event.button !== 0 || this.drag) return;
    event.preventDefault();
    event.stopPropagation();
    button.focus({preventScroll: true});
    button.setPointerCapture(event.pointerId);
    this.player.pause();
    this.player.drawing.hold();
    const handle = this.of(button), from = this.toGrid(event.clientX, event.clientY);
    // Where the hand has it, seen from its middle
    this.drag = {handle, pointer: event.pointerId, grip: {x: from.x - handle.at.x, y: from.y - handle.at.y}, moved: false};
    button.classList.add('dragged');
  }
  move(event) {
    const {drag} = this;
    if (!drag || event.pointerId !== drag.pointer) return;
    event.preventDefault();
    const {handle, grip} = drag, to = this.toGrid(event.clientX, event.clientY);
    this.moveBy(handle, to.x - grip.x - handle.at.x, to.y - grip.y - handle.at.y);
  }
  /** Counted from what is seen: a panel that is fitted anew while its input is dragged comes under the hand again. */
  moveBy({name, numbers, along}, dx, dy) {
    const by = changesFor(along, dx, dy), shown = this.host.shownNumbers().filter((number) => number.name === name);
    this.apply(name, numbers.flatMap((index, i) => {
      if (by[i] === 0) return [];  // a depth that the drawing does not show stays as it is
      const {value, whole} = shown[index];
      return [[index, roundedTo(value + by[i], whole ? 1 : this.stepOf(along[i], DRAG_PIXELS))]];
    }));
  }
  /** What a number's steps are so that they go that far in the drawing. */
  stepOf([x, y], pixels) { return roundStep(pixels / (this.player.drawing.at.cell * Math.max(Math.hypot(x, y), 1e-9))); }
  /** changes: [[number of the argument, value]] */
  apply(name, changes) {
    const text = this.host.textOf(this.host.parameter(name)), now = this.numbers(name);
    const changed = withNumbers(text, changes.map(([index, value]) => [now[index], value]));
    if (changed === text) return;
    if (this.drag) this.drag.moved = true;
    this.host.change({[name]: changed});
  }
  finish(event) {
    const {drag} = this;
    if (!drag || event.pointerId !== drag.pointer) return;
    this.drag = null;
    drag.handle.button.classList.remove('dragged');
    this.player.drawing.letGo();
    if (drag.moved)
      this.host.commit();
    else
      this.place();
  }

  // -- Keys

  key(event, button) {
    const direction = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    if (!direction || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const {name, numbers, along} = this.of(button);
    const by = changesFor(along, direction[0], direction[1] * (this.player.drawing.at.yUp ? 1 : -1));
    const most = Math.max(...by.map(Math.abs)), now = this.numbers(name), factor = event.shiftKey ? 10 : 1;
    const changes = numbers.flatMap((index, i) => {
      if (Math.abs(by[i]) < 0.25 * most || most === 0) return [];  // it hardly matters in this direction
      const {value, whole} = now[index], step = whole ? 1 : this.stepOf(along[i], 2 * DRAG_PIXELS);
      return [[index, roundedTo(value + Math.sign(by[i]) * step * factor, step)]];
    });
    if (changes.length === 0) return;
    this.apply(name, changes);
    this.host.commit();
  }
}
