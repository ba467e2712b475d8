'use strict';
// A recorded run, step by step: what the drawing, the table and the listing show after any step.

const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

/** A line of braces or of a comment alone is no line of code. */
/** Of several functions in a listing each has one: "divide(point, view):". */
const isHeading = (line) => /^\S.*\):$/.test(line);
const isCode = (line) => !isHeading(line) && /^[ {}();,]*(?!\/\/)[^ {}();,]/.test(line);

/** The first index in a sorted list whose value is above `wanted`. */
function upperBound(list, wanted, valueOf = (v) => v) {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (valueOf(list[middle]) > wanted)
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

/** What the drawing shows after some step: rows of cells, each [role, text, colour], and marks by id. */
class Canvas {
  rows = new Map();
  marks = new Map();
  cells = 0;
  plane = false;  // without cells

  copy() {
    const other = new Canvas();
    for (const [y, row] of this.rows) other.rows.set(y, new Map(row));
    other.marks = new Map(this.marks);
    other.cells = this.cells;
    other.plane = this.plane;
    return other;
  }
  get size() { return this.cells + this.marks.size; }
  look(x, y) { return this.rows.get(y)?.get(x); }

  /** Marks go, cells change (later runs win), marks come. */
  apply(delta) {
    this.plane = delta.plane ?? this.plane;
    for (const id of delta.removed ?? []) this.marks.delete(id);
    for (const [x, y, count, role, text = '', color] of delta.cells ?? []) {
      const look = role < 0 ? null : [role, text, color];
      for (let i = 0; i < count; ++i) this.put(x + i, y, look);
    }
    for (const mark of delta.set ?? []) this.marks.set(mark[0], mark);
  }
  put(x, y, look) {
    let row = this.rows.get(y);
    if (!row) {
      if (!look) return;
      this.rows.set(y, row = new Map());
    }
    const before = row.size;
    if (look)
      row.set(x, look);
    else
      row.delete(x);
    this.cells += row.size - before;
    if (row.size === 0) this.rows.delete(y);
  }
  /** In the order of their ids, so that it is no matter in which order they came. */
  sortedMarks() { return [...this.marks.values()].sort((a, b) => (a[0] < b[0] ? -1 : a[0] > b[0] ? 1 : 0)); }
}

/** How much a delta changes. */
function weight(delta) {
  const cells = (delta.cells ?? []).reduce((sum, run) => sum + run[2], 0);
  return cells + (delta.set?.length ?? 0) + (delta.removed?.length ?? 0);
}

/**
 * The drawing after any step. Keyframes are left behind on the first way forward: opening a trace costs
 * nothing.
 */
class Playhead {
  constructor(trace) {
    this.steps = trace.steps;
    this.canvas = new Canvas();
    this.canvas.apply(trace.before ?? {});
    this.keyframes = [{done: 0, canvas: this.canvas.copy()}];
    this.done = this.furthest = this.changed = 0;
  }
  at(index) {
    const wanted = index + 1;
    const nearest = this.keyframes[upperBound(this.keyframes, wanted, (k) => k.done) - 1];
    if (wanted < this.done || nearest.done > this.done) {
      this.canvas = nearest.canvas.copy();
      this.done = nearest.done;
    }
    while (this.done < wanted) this.forward();
    return this.canvas;
  }
  forward() {
    const step = this.steps[this.done++];
    this.canvas.apply(step);
    if (this.done <= this.furthest) return;
    this.furthest = this.done;
    this.changed += weight(step);
    if (this.changed < Math.max(this.canvas.size, 256)) return;
    this.keyframes.push({done: this.done, canvas: this.canvas.copy()});
    this.changed = 0;
  }
}

/** The decision table after any step: `read` completes the last row, `row` comes below it. */
class Table {
  constructor(steps) {
    this.rows = [];  // a list of versions each: {step, cells}
    this.made = [];  // the step that made each row
    this.readRow = new Map();
    this.madeRow = new Map();
    steps.forEach((step, index) => this.note(step, index));
  }
  note(step, index) {
    if (step.read && this.rows.length > 0) {
      this.readRow.set(index, this.rows.length - 1);
      this.rows[this.rows.length - 1].push({step: index, cells: step.read});
    }
    if (step.row) {
      this.madeRow.set(index, this.rows.length);
      this.rows.push([{step: index, cells: step.row}]);
      this.made.push(index);
    }
  }
  count(index) { return upperBound(this.made, index); }
  cells(row, index) {
    const versions = this.rows[row];
    return versions[upperBound(versions, index, (v) => v.step) - 1].cells;
  }
  row(row, index) {
    const cells = this.cells(row, index);
    const strong = this.madeRow.get(index) === row;
    const weak = this.readRow.get(index) === row;
    const before = strong && row > 0 ? this.cells(row - 1, index) : null;
    return {
      cells,
      emphasis: (strong && 'strong') || (weak && 'weak') || 'none',
      changed: cells.map((text, c) => before !== null && c > 0 && text !== '' && text !== before[c]),
    };
  }
}

// ---- The listing -------------------------------------------------------------------------------------------

const indentOf = (line) => line.search(/\S|$/);
const isLoop = (line) => /^ *(for|while|do|repeat)(?=[ (]|$)/.test(line);
const isBrace = (line) => /^[ })]*$/.test(line);

/** A line each: the position of the head of the loop that it stands in; itself where it is one, or in none. */
function loopHeads(lines) {
  return lines.map((line, position) => {
    if (isLoop(line)) return position;
    // A brace that closes a loop belongs to it
    let indent = indentOf(line) + (line.trimStart().startsWith('}') ? 1 : 0);
    for (let i = position - 1; i >= 0 && !isHeading(lines[i]); --i) {
      if (indentOf(lines[i]) >= indent || /^ *($|\/\/)/.test(lines[i])) continue;
      indent = indentOf(lines[i]);
      if (isLoop(lines[i])) return i;
    }
    return position;
  });
}

/** Whether a line may go on below before this character. */
function mayBreakBefore(line, at) {
  if (line[at - 1] === '(') return line[at] !== ')';
  if (line[at - 1] !== ' ') return false;
  const rest = line.slice(at);
  return /[,;] $| = $/.test(line.slice(0, at)) || /^(&&|\|\||[-+*\/%<>?:&|]|[=!<>]=|<<|>>) /.test(rest);
}
/** Where its first row ends: as late as can be, but rather outside brackets; -1: nowhere. */
function bestBreak(line, columns) {
  let best = -1, least = Infinity, depth = 0;
  for (let at = 1; at < line.length; ++at) {
    if ('(['.includes(line[at - 1])) ++depth;
    if (')]'.includes(line[at - 1]) && depth > 0) --depth;
    if (at < indentOf(line) + 4 || !mayBreakBefore(line, at)) continue;
    const {length} = line.slice(0, at).trimEnd();
    if (length > columns) break;
    const cost = columns - length + 9 * depth;
    if (cost <= least) [best, least] = [at, cost];
  }
  return best;
}
/** A line as rows of at most so many characters, as figures have them; one that cannot be broken stays longer. */
function sourceRows(line, columns) {
  if (line.length <= columns) return [line];
  const lead = ' '.repeat(indentOf(line)), rows = [];
  let rest = line;
  const goOn = (at, start) => {
    rows.push(rest.slice(0, at).trimEnd());
    rest = start + rest.slice(at).trimStart();
  };
  if (line.startsWith('//', lead.length)) {
    while (rest.length > columns && rest.lastIndexOf(' ', columns) > lead.length + 3)
      goOn(rest.lastIndexOf(' ', columns), `${lead}// `);
    return [...rows, rest];
  }
  const comment = line.indexOf('//');
  if (comment > 0) rest = line.slice(0, comment).trimEnd();
  for (let at; rest.length > columns && (at = bestBreak(rest, columns)) > 0;) goOn(at, `${lead}    `);
  return [...rows, rest];
}

/**
 * Which lines of a listing are seen in `room` rows, as figures show them: those from `first` to before `last`, and
 * above them, apart, the head of a loop.
 */
class Excerpts {
  constructor(run, heights, room) {
    Object.assign(this, {run, heights, room, count: heights.length});
    this.still = this.stillest();
  }
  /** The one that keeps still, as long as it shows the current line with its loop; else one round that. */
  with(current) { return current < 0 || this.holds(this.still, current) ? this.still : this.round(current); }

  shows({first, last, head}, line) { return (first <= line && line < last) || head === line; }
  holds(excerpt, line) { return this.shows(excerpt, line) && this.shows(excerpt, this.run.loops[line]); }
  /** As many lines as fit from this one on, below the head. */
  from(first, head = -1) {
    let room = this.room - (head < 0 ? 0 : this.heights[head] + 1), last = first;
    while (last < this.count && this.heights[last] <= room) room -= this.heights[last++];
    return {first, last, head};
  }
  /** The one that shows most of the lines that report steps, and their loops. */
  stillest() {
    const {run, count} = this, heads = [...new Set(run.reporting.map((line) => run.loops[line]))];
    let best = this.from(0), most = this.worth(best);
    for (const head of [-1, ...heads.filter((head) => run.reporting.some((l) => l !== head && run.loops[l] === head))]) {
      for (let first = head < 0 ? 1 : head + 2; first < count; ++first) {
        const excerpt = this.from(first, head), worth = this.worth(excerpt);
        if (worth > most) [best, most] = [excerpt, worth];
        if (excerpt.last === count) break;
      }
    }
    return best;
  }
  /** What a loop does counts twice; a brace alone tells nothing. */
  worth(excerpt) {
    const {reporting, loops, trace} = this.run;
    let worth = 0;
    for (const line of reporting)
      if (this.holds(excerpt, line)) worth += loops[line] !== line && !isBrace(trace.listing[line][1]) ? 2 : 1;
    // What a fault changes is what a listing with one is shown for
    return worth + 3 * trace.listing.filter(([, , sign], line) => sign && this.shows(excerpt, line)).length;
  }
  /** With the line about in the middle, its loop's head above where that is too far. */
  round(line) {
    const head = this.run.loops[line];
    let excerpt = this.centred(line, -1);
    if (!this.shows(excerpt, head)) excerpt = this.centred(line, head);
    if (excerpt.head >= 0 && excerpt.first === excerpt.head + 1) excerpt = this.from(head);
    // At the end there may be room for more before
    while (excerpt.last === this.count && excerpt.first > 0) {
      const earlier = this.from(excerpt.first - 1, excerpt.head);
      if (earlier.last < this.count || (excerpt.head >= 0 && earlier.first <= excerpt.head + 1)) break;
      excerpt = earlier;
    }
    return this.shows(excerpt, line) ? excerpt : {first: line, last: line + 1, head: -1};
  }
  centred(line, head) {
    const {heights} = this, taken = heights[line] + (head < 0 ? 0 : heights[head] + 1);
    let before = Math.floor((this.room - Math.min(this.room, taken)) / 2), first = line;
    while (first > head + 1 && heights[first - 1] <= before) before -= heights[--first];
    return this.from(first, head);
  }
}

/** The listing with what a fault strikes out of it: a number, a text and a sign each, '-', '+' or none. */
function shownListing({listing = [], difference: {struck = [], added = []} = {}}) {
  const ran = listing.map(([number, text]) => [number, text, added.includes(number) ? '+' : '']);
  return [...ran, ...struck.map(([number, text]) => [number, text, '-'])].sort(([a], [b]) => a - b);
}

/** A loaded trace and what can be asked of it. */
class Run {
  /** What a trace has nothing of when its slot was dropped. */
  static bare = {title: '', subtitle: '', goal: '', listing: [], columns: [], legend: [], roles: []};

  constructor(trace) {
    if (trace.schema !== 1) throw new Error(`a trace of schema 1 is needed, not ${trace.schema}`);
    if (trace.steps.length === 0) throw new Error('a trace without a step cannot be shown');
    this.trace = {...Run.bare, ...trace, listing: shownListing(trace)};
    this.steps = trace.steps;
    this.playhead = new Playhead(trace);
    this.table = new Table(trace.steps);
    this.byNumber = new Map(trace.steps.map((step, index) => [step.number, index]));
    this.milestones = [];
    trace.steps.forEach((step, index) => {
      if (!isFine(step)) this.milestones.push(index);
    });
    this.lines = this.trace.listing.map(([number]) => number);
    // What is struck out heads no loop: it is read as a comment
    this.loops = loopHeads(this.trace.listing.map(([, text, sign]) => sign === '-' ? '//' : text));
    this.reporting =
        [...new Set(this.steps.map((step) => this.shownLine(step.line)))].filter((line) => line >= 0);
  }
  isStruck(position) { return this.trace.listing[position][2] === '-'; }
  isCounted(position) { return !this.isStruck(position) && !isHeading(this.trace.listing[position][1]); }
  /** What stands before a line: its number among those that run; none where it is struck out or a heading. */
  labelOf(position) {
    if (!this.isCounted(position)) return '';
    return String(1 + this.trace.listing.slice(0, position).filter((_, line) => this.isCounted(line)).length);
  }
  shows(slot) { return this.trace.slots?.includes(slot) ?? true; }
  /** Position in the listing of the nearest line of code at or above a source line; -1: none. */
  shownLine(line) {
    let at = line ? upperBound(this.lines, line) - 1 : -1;
    while (at >= 0 && (this.isStruck(at) || !isCode(this.trace.listing[at][1]))) --at;
    return at;
  }

  /** The step before at its own level: for a milestone the last milestone, for a finer event any. */
  previousOf(index) {
    const fine = isFine(this.steps[index]);
    for (let i = index - 1; i >= 0; --i)
      if (fine || !isFine(this.steps[i])) return this.steps[i];
    return null;
  }
  listing(index) {
    const emphasis = this.lines.map(() => 'none');
    const weak = this.shownLine(this.previousOf(index)?.line);
    const strong = this.shownLine(this.steps[index].line);
    if (weak >= 0) emphasis[weak] = 'weak';
    if (strong >= 0) emphasis[strong] = 'strong';
    return emphasis;
  }
  get lastMilestone() { return this.milestones[this.milestones.length - 1]; }
  /** After the last milestone comes the run's last event: what it says of its result. */
  nextMilestone(index) {
    return this.milestones[upperBound(this.milestones, index)] ?? this.steps.length - 1;
  }
  previousMilestone(index) {
    const after = upperBound(this.milestones, index - 1);
    return after > 0 ? this.milestones[after - 1] : 0;
  }
  /** The next step after `index` whose strong line is this one; from the start again when there is none. */
  nextExecution(position, index) {
    const executes = (step) => this.shownLine(step.line) === position;
    const after = this.steps.findIndex((step, i) => i > index && executes(step));
    return after >= 0 ? after : this.steps.findIndex(executes);
  }
  /** The step that made a cell what it is: where it was done rather than where it was first considered. */
  makerOfCell(x, y) {
    const done = new Set(['current', 'accepted', 'result'].map((name) => this.trace.roles.indexOf(name)));
    let best = -1, bestRank = 3;
    for (let i = 0; i < this.steps.length && bestRank > 0; ++i) {
      for (const [left, row, count, role] of this.steps[i].cells ?? []) {
        if (row !== y || x < left || x >= left + count || role < 0) continue;
        const rank = done.has(role) ? 0 : this.steps[i].key === `${x},${y}` ? 1 : 2;
        if (rank < bestRank) [best, bestRank] = [i, rank];
      }
    }
    return best;
  }
  /** The last step up to `index` that set this mark. */
  makerOfMark(id, index) {
    for (let i = index; i >= 0; --i)
      if (this.steps[i].set?.some((mark) => mark[0] === id)) return i;
    return -1;
  }
  /** Every cell that has a look after some step. */
  get touched() {
    if (this.everTouched) return this.everTouched;
    this.everTouched = new Canvas();
    for (const delta of [this.trace.before ?? {}, ...this.steps]) {
      this.everTouched.apply({cells: (delta.cells ?? []).filter((run) => run[3] >= 0)});
    }
    return this.everTouched;
  }
  /** Stretches of steps with one phase: {name, from, to}. */
  phases() {
    const out = [];
    this.steps.forEach((step, index) => {
      const name = step.phase ?? '';
      if (out.length === 0 || out[out.length - 1].name !== name)
        out.push({name, from: index, to: index});
      else
        out[out.length - 1].to = index;
    });
    return out;
  }
}
const isFine = (step) => step.number.includes('.');
