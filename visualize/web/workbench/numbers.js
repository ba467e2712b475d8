'use strict';
// The numbers in the text of an argument, whatever it is the text of: each can be replaced, the rest stays as it was
// written. Numbers between commas belong together: they are the coordinates of a point.

/** Kinds of parameters whose texts hold numbers that can be moved. */
const MOVABLE = new Set(['cell', 'window', 'integer', 'number', 'numbers', 'bounds', 'points', 'rings', 'factors', 'faces']);
const WHOLE = new Set(['cell', 'window', 'integer']);
/** Not a part of a name or of a colour, nor of a face's name: "2: 0,0,1 …", "front 2 left: 0,0,1 …". */
const NUMBER = /(?<![\w#.])[-+]?(?:\d+\/\d+|(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)(?![\w.]|[^;]*:)/gi;

/** {at, length, value, tuple, whole}: tuple counts those that belong together. */
function numbersIn(text, type) {
  if (!MOVABLE.has(type)) return [];
  let end = 0, tuple = -1;
  return [...text.matchAll(NUMBER)].map(({0: written, index: at}) => {
    if (tuple < 0 || !/^\s*,\s*$/.test(text.slice(end, at))) ++tuple;
    end = at + written.length;
    const [numerator, denominator = 1] = written.split('/').map(Number);
    return {at, length: written.length, value: numerator / denominator, tuple, whole: WHOLE.has(type)};
  });
}

/** The text with some of its numbers changed. changes: [[number of numbersIn, value]]. */
function withNumbers(text, changes) {
  let out = '', end = 0;
  for (const [{at, length}, value] of [...changes].sort(([a], [b]) => a.at - b.at)) {
    out += text.slice(end, at) + written10(value);
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
const roundedTo = (value, step) => Number((Math.round(value / step) * step).toPrecision(12));

/** The numbers of an input: {name, index, …of numbersIn}. */
function numbersOfInput(parameters, textOf) {
  return parameters.flatMap((parameter) => numbersIn(textOf(parameter), parameter.type)
                                               .map((number, index) => ({...number, name: parameter.name, index})));
}
