'use strict';
// The numbers in the text of any argument: each can be replaced, the rest stays as it was
// written. Numbers between commas belong together: they are the coordinates of a point.

/** Kinds of parameters whose texts hold numbers that can be moved. */
const MOVABLE = new Set(['cell', 'window', 'integer', 'number', 'numbers', 'bounds', 'points', 'rings', 'factors', 'faces']);
const WHOLE = new Set(['cell', 'window', 'integer']);
/** Not a part of a name or of a colour. */
const NUMBER = /(?<![\w#.])[-+]?(?:\d+\/\d+|(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?)(?![\w.])/gi;
/** Spaces for the names of faces: "2: 0,0,1 …", "front 2 left: 0,0,1 …". */
function withoutNames(text) {
  return text.split(';').map((part) => ' '.repeat(part.lastIndexOf(':') + 1) + part.slice(part.lastIndexOf(':') + 1)).join(';');
}

/** {at, length, value, tuple, whole}: tuple counts those that belong together. */
function numbersIn(text, type) {
  if (!MOVABLE.has(type)) return [];
  let end = 0, tuple = -1;
  return [...withoutNames(text).matchAll(NUMBER)].map(({0: written, index: at}) => {
    if (tuple < 0 || text.slice(end, at).trim() !== ',') ++tuple;
    end = at + written.length;
    const [numerator, denominator = 1] = written.split('/').map(Number);
    return {at, length: written.length, value: numerator / denominator, tuple, whole: WHOLE.has(type)};
  });
}

/** The text with some of its numbers changed. changes: [[number of numbersIn, value, or as it is written]]. */
function withNumbers(text, changes) {
  let out = '', end = 0;
  for (const [{at, length}, value] of [...changes].sort(([a], [b]) => a.at - b.at)) {
    out += text.slice(end, at) + (typeof value === 'string' ? value : written10(value));
    end = at + length;
  }
  return out + text.slice(end);
}

/** A number in ten digits at most: 0.30000000000000004 is 0.3. */
const written10 = (value) => String(Number(value.toPrecision(10)) + 0);

/** The largest of 1, 0.5, 0.1, 0.05 … that is at most so much. */
function roundStep(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * (most >= 5 * power ? 5 : 1);
}
const roundedTo = (value, step) => Number((Math.round(value / step) * step).toPrecision(10));

/** The numbers of an input: {name, index, …of numbersIn}. */
function numbersOfInput(parameters, textOf) {
  return parameters.flatMap((parameter) => numbersIn(textOf(parameter), parameter.type)
                                               .map((number, index) => ({...number, name: parameter.name, index})));
}

/** The unit normal of the flat face with more than three corners that number `index` of a text is of: its corners stay in
    one plane while they are dragged. Nothing for what is no such face. numbers: those of the text. */
function normalAt(text, numbers, index) {
  const first = text.lastIndexOf(';', numbers[index].at) + 1, next = text.indexOf(';', first), last = next < 0 ? text.length : next;
  const own = numbers.filter(({at}) => first <= at && at < last).map(({value}) => value), corners = [];
  for (let i = 0; i + 2 < own.length; i += 3) corners.push([0, 1, 2].map((k) => own[i + k] - own[k]));
  if (corners.length <= 3) return undefined;
  const area = [0, 0, 0];
  corners.forEach((p, i) => crossed(p, corners[(i + 1) % corners.length]).forEach((value, k) => { area[k] += value; }));
  const length = Math.hypot(...area), size = Math.max(...corners.map((p) => Math.hypot(...p)));
  if (!(length > 1e-12 * size * size)) return undefined;
  const normal = area.map((value) => value / length);
  return corners.every((p) => Math.abs(product(normal, p)) <= FLAT * size) ? normal : undefined;
}
const FLAT = 1e-9;  // of a face's size: how far its corners may be out of its plane
const product = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
const crossed = ([ax, ay, az], [bx, by, bz]) => [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
