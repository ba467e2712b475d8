'use strict';
// Marks that move from one step to the next.

/** The elements of marks, by what they are parts of. */
function marksIn(svg) {
  const marks = new Map();
  for (const element of svg.querySelectorAll('[data-mark]')) {
    const name = `${element.dataset.mark} ${element.tagName}`;
    for (let i = 0;; ++i) {
      if (marks.has(`${name} ${i}`)) continue;
      marks.set(`${name} ${i}`, element);
      break;
    }
  }
  return marks;
}
const MOVE = {duration: 260, easing: 'ease-in-out'};
/** Marks that stood elsewhere come from there; lines of as many points bend over. */
function moveMarks(stood, marks) {
  const number = (element, name) => Number(element.getAttribute(name));
  for (const [name, mark] of marks) {
    const before = stood.get(name);
    if (!before) continue;
    const [x, y] = mark.tagName === 'circle' ? ['cx', 'cy'] : ['x', 'y'];
    if (mark.tagName === 'path') {
      const [from, to] = [before.getAttribute('d'), mark.getAttribute('d')];
      if (from !== to && from.replace(/[^A-Za-z]/g, '') === to.replace(/[^A-Za-z]/g, ''))
        mark.animate({d: [`path("${from}")`, `path("${to}")`]}, MOVE);
      continue;
    }
    const dx = number(before, x) - number(mark, x), dy = number(before, y) - number(mark, y);
    if (dx !== 0 || dy !== 0) mark.animate({transform: [`translate(${dx}px, ${dy}px)`, 'none']}, MOVE);
  }
}
