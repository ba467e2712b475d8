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

/** How many times as far a handle went as it goes now, of which each pair has both: one number for all of them, else NaN. */
function timesOf(pairs) {
  const [most, now] = pairs.reduce((a, b) => (Math.abs(b[0]) > Math.abs(a[0]) ? b : a)), times = most / now;
  const one = pairs.every(([value, other]) => Math.abs(value - times * other) <= 1e-6 * Math.abs(most));
  return times > 0 && Number.isFinite(times) && one ? times : NaN;
}
/** The same for all numbers of a handle; 1 where its panel is fitted otherwise across than down. NaN: its way bends. */
function timesAsFar(went, goes) {
  const both = [0, 1].map((k) => went.map((way, i) => [way[k], goes[i][k]])), times = timesOf(both.flat());
  if (times > 0) return times;
  const least = 1e-6 * Math.max(...went.flat().map(Math.abs));
  const isStraight = (pairs) => pairs.flat().every((value) => Math.abs(value) <= least) || timesOf(pairs) > 0;
  return both.every(isStraight) ? 1 : NaN;
}

/** Of each number how far it goes as a part of what stays in the plane across the normal. */
function keptWithin(along, normal) {
  const out = [0, 1].map((k) => product(along.map((way) => way[k]), normal));
  return along.map((way, i) => way.map((value, k) => value - normal[i] * out[k]));
}
/** After a change to a step of its own: what hardly changes stays as it was. */
const changedBy = (value, change, step) => (Math.abs(change) < step / 2 ? value : roundedTo(value + change, step));
/** The numbers now, in the plane in which they were: the one that it tells best follows the others. */
function inPlane(before, now, normal) {
  const sizes = normal.map(Math.abs), told = sizes.indexOf(Math.max(...sizes));
  const others = now.reduce((sum, value, i) => (i === told ? sum : sum + normal[i] * (value - before[i])), 0);
  const follows = others === 0 ? before[told] : String(Number((before[told] - others / normal[told]).toPrecision(13)));
  return now.map((value, i) => (i === told ? follows : value));
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

/** {key, name, numbers, at, along}: where each stands, and how far it goes for 1 more of each of its numbers. */
function handlesOf({handles = []}) {
  return handles.map(([name, numbers, [x, y], along]) => (
      {key: `${name} ${numbers}`, name, numbers, at: {x, y}, along: numbers.map((_, i) => along.slice(2 * i, 2 * i + 2))}));
}

class HandleLayer {
  /** host: {parameter(name), textSeen(parameter), givenFor(parameter), numbers(), change(texts), commit()}, which hears of what is dragged. */
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
    const next = handlesOf(this.player.run.trace);
    if (next.length === this.handles.length && next.every(({key}, i) => key === this.handles[i].key)) {
      next.forEach((handle, i) => Object.assign(this.handles[i], handle));
      return;
    }
    if (this.drag) return this.followMeanwhile(next);
    this.handles = next.map((handle) => ({...handle, button: this.button(handle)}));
    this.element.replaceChildren(...this.handles.map(({button}) => button));
  }
  /** While one is dragged no button is made: those that are there follow, and what is no more is out of sight. */
  followMeanwhile(next) {
    for (const handle of this.handles)
      Object.assign(handle, next.find(({key}) => key === handle.key) ?? {at: {x: NaN, y: NaN}});
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
      const {button} = handle, dragged = this.drag?.handle === handle;
      const underHand = dragged && !this.drag.bends && this.drag.seen, [x, y] = underHand || toPixels(at, handle.at.x, handle.at.y);
      const inView = x >= 0 && y >= 0 && x <= at.width && y <= at.height;
      button.hidden = !dragged && (!inView || !(places?.has(placeText(handle.at.x, handle.at.y)) ?? true));
      button.style.left = `${x}px`;
      button.style.top = `${y}px`;
      const label = this.labelOf(handle);
      button.setAttribute('aria-label', label);
      button.title = label;
    }
  }

  // -- Dragging

  begin(event, button) {
    if (event.button !== 0 || this.drag) return;
    event.preventDefault();
    event.stopPropagation();
    button.focus({preventScroll: true});
    button.setPointerCapture(event.pointerId);
    this.player.pause();
    this.take(this.of(button));
    Object.assign(this.drag, {pointer: event.pointerId, from: [event.clientX, event.clientY]});
    button.classList.add('dragged');
  }
  /** From here all of a drag is counted: what is seen meanwhile may be fitted anew to what is dragged. */
  take(handle) {
    const {drawing} = this.player;
    drawing.hold((at, run) => this.underHand(at, run));
    const placeOf = ({at: {x, y}}) => toPixels(drawing.at, x, y);
    const others = this.handles.filter((other) => other.name !== handle.name || !other.numbers.some((number) => handle.numbers.includes(number)));
    this.drag = {
      ...this.standing(handle), handle, went: handle.along, at: drawing.at, place: placeOf(handle), moved: false,
      others: others.map((other) => ({key: other.key, went: other.along, place: placeOf(other)}))
    };
  }
  /** A story may fit its panel anew to what is dragged in it: then the paper lies so that the mark is under the hand all the same, and
      as large as it was. Where the mark's way bends, as that of a lamp does of which the direction alone is drawn, it is what is not
      dragged that stays where it was. */
  underHand(at, {trace}) {
    const {drag} = this;
    if (!drag?.seen) return at;
    const all = handlesOf(trace), now = all.find(({key}) => key === drag.handle.key);
    const times = now ? timesAsFar(drag.went, now.along) : 1;
    drag.bends = Number.isNaN(times);
    if (drag.bends) return this.asOthersLay(at, all);
    return now ? moved(at, toPixels(at, now.at.x, now.at.y), drag.seen, times) : at;
  }
  /** The paper so that another mark lies where it lay and goes as far; as it is, where one goes as far as it did, or none is straight. */
  asOthersLay(at, all) {
    const laid = this.drag.others.flatMap(({key, went, place}) => {
      const now = all.find((other) => other.key === key), times = now ? timesAsFar(went, now.along) : NaN;
      return times > 0 ? [{times, paper: moved(at, toPixels(at, now.at.x, now.at.y), place, times)}] : [];
    });
    return laid.length === 0 || laid.some(({times}) => Math.abs(times - 1) < 1e-6) ? at : laid[0].paper;
  }
  move(event) {
    const {drag} = this;
    if (!drag || event.pointerId !== drag.pointer) return;
    event.preventDefault();
    this.dragTo(event.clientX - drag.from[0], event.clientY - drag.from[1]);
  }
  /** So many pixels to the right and down of where it was taken. */
  dragTo(right, down) {
    const {drag} = this, {at} = drag, by = changesFor(drag.along, right / at.cell, (at.yUp ? -down : down) / at.cell);
    const step = (i) => (drag.whole ? 1 : this.stepOf(drag.along[i], DRAG_PIXELS, at));
    this.apply(drag, drag.values.map((value, i) => changedBy(value, by[i], step(i))));
  }
  letGo() {
    this.drag = null;
    this.player.drawing.letGo();
  }
  finish(event) {
    const {drag} = this;
    if (!drag || event.pointerId !== drag.pointer) return;
    drag.handle.button.classList.remove('dragged');
    this.letGo();
    if (drag.moved)
      this.host.commit();
    else
      this.place();
  }

  /** What a handle moves, as it is now: {name, text, given, numbers, values, whole, along, normal}. given: what the text comes from. */
  standing({name, numbers: indices, along}) {
    const parameter = this.host.parameter(name), text = this.host.textSeen(parameter), all = this.numbers(name);
    const numbers = indices.map((index) => all[index]), isCorner = parameter.type === 'faces' && indices.length === 3;
    const normal = isCorner ? normalAt(text, all, indices[0]) : undefined;
    return {
      name, text, numbers, normal, given: this.host.givenFor(parameter), values: numbers.map(({value}) => value), whole: numbers[0].whole,
      along: normal ? keptWithin(along, normal) : along
    };
  }
  /** What a number's steps are so that they go that far in the drawing. */
  stepOf([x, y], pixels, {cell} = this.player.drawing.at) {
    return roundStep(pixels / (cell * Math.max(Math.hypot(x, y), 1e-9)));
  }
  /** The text as it stood, with these values; those that are what they were keep their spelling, and where all are, what was given is. */
  apply({name, text, given, numbers, values, normal}, now) {
    const written = normal ? inPlane(values, now, normal) : now;
    const changes = written.flatMap((value, i) => (value === values[i] ? [] : [[numbers[i], value]])), changed = withNumbers(text, changes);
    if (this.drag) {
      const {at, place, along} = this.drag, by = written.map((value, i) => Number(value) - values[i]);
      const go = (k) => along.reduce((sum, way, i) => sum + way[k] * by[i], 0) * at.cell;
      this.drag.seen = [place[0] + go(0), place[1] + (at.yUp ? -go(1) : go(1))];
    }
    const isBack = changes.length === 0;
    if (isBack ? !this.drag?.moved : changed === this.host.textSeen(this.host.parameter(name))) return;
    if (this.drag) this.drag.moved = true;
    this.host.change(isBack ? given : {[name]: changed});
  }

  // -- Keys

  key(event, button) {
    const direction = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    if (!direction || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const now = this.standing(this.of(button)), {along, values, whole} = now;
    const by = changesFor(along, direction[0], direction[1] * (this.player.drawing.at.yUp ? 1 : -1));
    const most = Math.max(...by.map(Math.abs)), factor = event.shiftKey ? 10 : 1;
    if (most === 0) return;
    this.apply(now, values.map((value, i) => {
      if (Math.abs(by[i]) < 0.25 * most) return value;  // it hardly matters in this direction
      const step = whole ? 1 : this.stepOf(along[i], 2 * DRAG_PIXELS);
      return roundedTo(value + Math.sign(by[i]) * step * factor, step);
    }));
    this.host.commit();
  }
}
