'use strict';
// Elements of HTML and SVG, and how wide texts are. Text from a trace only ever becomes text nodes and attribute
// values.

const SVG = 'http://www.w3.org/2000/svg';
const SANS = '"Gradus Sans", Inter, "DejaVu Sans", Verdana, "Segoe UI", system-ui, sans-serif';
const MONO = '"Gradus Mono", "JetBrains Mono", "DejaVu Sans Mono", Consolas, Menlo, monospace';

function filled(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}
const html = (name, attributes = {}, ...children) =>
    filled(document.createElement(name), attributes, children);
const svg = (name, attributes = {}, ...children) =>
    filled(document.createElementNS(SVG, name), attributes, children);

/** Two strokes that cross in (x, y). */
const crossPath = (x, y, arm) =>
    `M${x - arm} ${y - arm}L${x + arm} ${y + arm}M${x - arm} ${y + arm}L${x + arm} ${y - arm}`;

/** A whole number as it is written in formulas, with a minus sign. */
const written = (number) => String(number).replace('-', '−');

const pen = document.createElement('canvas').getContext('2d');
function textWidth(text, size, style = '', family = SANS) {
  pen.font = `${style} ${size}px ${family}`;
  return pen.measureText(text).width;
}
