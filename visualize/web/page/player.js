'use strict';
// The player of a recorded run. `new GradusPlayer(root).load(trace)` shows a trace of schema 1 (see
// trace_json) in any element; every picture is drawn from the trace's marks at the moment it is looked at.
// Needs all other scripts of this folder.

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16, 32];  // steps a second
const PLAIN_SPEED = SPEEDS.indexOf(1);
const FAST = 4;  // times as fast, backwards
const MOST_COLUMNS = 36;  // characters of a line of the listing, as figures have it at their widest
const all = [];

class GradusPlayer {
  /** The looks there are: {name, tones, roles}. The page sets them before it makes a player. */
  static themes = [];
  /** The name of the first one; empty: what the reader's system prefers. */
  static firstTheme = '';

  constructor(root) {
    this.root = root;
    this.prefix = `gradus-${all.length + 1}`;
    root.classList.add('gradus');
    root.replaceChildren(document.getElementById('gradus-player').content.cloneNode(true));
    this.parts = {};
    for (const node of root.querySelectorAll('[data-part]')) this.parts[node.dataset.part] = node;
    this.stage = root.querySelector('.stage');
    this.drawing = new Drawing(this.parts.drawing, this.prefix);
    this.parts.said.id = `${this.prefix}-sentence`;
    this.scrub = new ScrubBar(this.parts);
    this.speed = PLAIN_SPEED;
    this.bind();
    this.setTheme(preferredTheme());
    all.push(this);
    new ResizeObserver(() => this.resize()).observe(root);
    // The page's own letters come a moment after its first layout
    Promise.all([...document.fonts].map((font) => font.load())).then(() => {
      if (this.run) this.showColumns();
      this.resize();
    });
  }

  /** Shows a trace from its first step on, paused. `more.command`: what makes it again, to copy. */
  load(trace, more = {}) {
    const run = new Run(trace);
    this.pause();
    this.run = run;
    this.index = 0;
    this.loop = {on: false};  // {first, last, on}: the steps to repeat
    this.bookmarks = [];      // indices of steps, ascending
    this.command = more.command ?? '';
    this.letters = new Typesetter(trace.names);
    this.drawing.load(this.run, this.letters);
    this.showTrace();
    this.resize();
  }

  /** Whether there is a step of this number ("7", "7.2"); if so, goes there. */
  goTo(number) {
    const index = this.run.byNumber.get(String(number).trim());
    if (index === undefined) return false;
    this.show(index);
    return true;
  }
  next() { this.show(this.run.nextMilestone(this.index)); }
  previous() { this.show(this.run.previousMilestone(this.index)); }
  nextEvent() { this.show(this.index + 1); }
  previousEvent() { this.show(this.index - 1); }
  first() { this.show(0); }
  last() { this.show(this.run.steps.length - 1); }
  get atEnd() { return this.index === this.run.steps.length - 1; }

  // -- Playing

  /** The steps that playing goes through: the loop, or all. */
  get stretch() { return this.loop.on ? this.loop : {first: 0, last: this.run.steps.length - 1}; }
  get playing() { return Boolean(this.timer); }
  /** Whether steps go past faster than they can be read out. */
  get flying() { return this.playing && SPEEDS[this.speed] * Math.abs(this.pace) > 1; }

  /** Plays on. A negative pace plays backwards; beyond 1 or -1 it is so many times as fast. */
  play(pace = 1) {
    this.pause();
    const {first, last} = this.stretch, [begin, end] = pace > 0 ? [first, last] : [last, first];
    if (this.index < first || this.index > last || this.index === end) this.show(begin);
    this.pace = pace;
    this.waitForTick();
    this.showPlaying();
  }
  waitForTick() {
    this.timer = setTimeout(() => this.tick(), 1000 / (SPEEDS[this.speed] * Math.abs(this.pace)));
  }
  tick() {
    const {first, last} = this.stretch, [begin, end] = this.pace > 0 ? [first, last] : [last, first];
    this.show(this.index === end ? begin : clamp(this.following(first, last), first, last));
    if (this.index === end && !this.loop.on)
      this.pause();
    else
      this.waitForTick();
  }
  /** The milestone that playing comes to; in a loop between finer events, the event. */
  following(first, last) {
    const {run, index, pace} = this;
    if (this.loop.on && (isFine(run.steps[first]) || isFine(run.steps[last]))) return index + Math.sign(pace);
    return pace > 0 ? run.nextMilestone(index) : run.previousMilestone(index);
  }
  pause() {
    const unsaid = this.flying;
    clearTimeout(this.timer);
    this.timer = 0;
    this.pace = 0;
    this.showPlaying();
    if (unsaid) this.announce();
  }
  toggle() {
    if (this.playing)
      this.pause();
    else
      this.play();
  }
  toggleBackwards(pace) {
    if (this.pace === pace)
      this.pause();
    else
      this.play(pace);
  }
  replay() {
    this.pause();
    this.show(this.stretch.first);
    this.play();
  }
  showPlaying() {
    const {parts, pace} = this;
    this.root.classList.toggle('playing', this.playing);
    parts.play.setAttribute('aria-label', say(this.playing ? 'pause' : 'play'));
    parts.backwards.setAttribute('aria-pressed', pace === -1);
    parts.fast_backwards.setAttribute('aria-pressed', pace === -FAST);
  }

  changeSpeed(by) {
    this.setSpeed(clamp(this.speed + by, 0, SPEEDS.length - 1));
    this.changed();
  }
  setSpeed(index) {
    this.speed = index;
    this.parts.speed.textContent = say('speed', {n: SPEEDS[index]});
    this.parts.speed.setAttribute('aria-label', say('speed_label', {n: SPEEDS[index]}));
  }

  // -- The loop and the bookmarks

  /** This step is where the loop starts, or ends; a missing other end is the run's. */
  markLoop(end) {
    const {index, loop} = this, whole = {first: 0, last: this.run.steps.length - 1};
    const marked = {...whole, ...loop, [end]: index};
    if (marked.first >= marked.last) Object.assign(marked, whole, {[end]: index});
    if (marked.first >= marked.last) return this.notice(say('loop_short'));
    this.setLoop({...marked, on: true});
    this.tellLoop();
    this.changed();
  }
  toggleLoop() {
    const whole = {first: 0, last: this.run.steps.length - 1};
    if (whole.last === 0) return this.notice(say('loop_short'));
    this.setLoop({...whole, ...this.loop, on: !this.loop.on});
    this.tellLoop();
    this.changed();
  }
  setLoop(loop = {on: false}) {
    this.loop = loop;
    this.scrub.showLoop(loop);
    this.parts.loop.setAttribute('aria-pressed', loop.on);
  }
  tellLoop() {
    const {steps} = this.run, {first, last, on} = this.loop;
    const range = () => ({first: steps[first].number, last: steps[last].number});
    this.notice(on ? say('loop_on', range()) : say('loop_off'));
  }

  toggleBookmark() {
    const {index, bookmarks} = this, has = bookmarks.includes(index), {number} = this.run.steps[index];
    this.setBookmarks(has ? bookmarks.filter((mark) => mark !== index) : [...bookmarks, index]);
    this.notice(say(has ? 'bookmark_removed' : 'bookmark_set', {number}));
    this.changed();
  }
  /** The next bookmark after this step; after the last one the first. */
  nextBookmark() {
    const {bookmarks} = this;
    if (bookmarks.length === 0) return this.notice(say('no_bookmark'));
    this.goToBookmark(bookmarks.find((mark) => mark > this.index) ?? bookmarks[0]);
  }
  goToBookmark(index) {
    this.pause();
    this.show(index);
    this.notice(say('bookmark_here', {number: this.run.steps[index].number}));
  }
  setBookmarks(bookmarks) {
    this.bookmarks = [...new Set(bookmarks)].sort((a, b) => a - b);
    this.scrub.showBookmarks(this.bookmarks);
    this.redrawBookmark();
  }
  redrawBookmark() {
    this.parts.bookmark.setAttribute('aria-pressed', this.bookmarks.includes(this.index));
    this.parts.next_bookmark.setAttribute('aria-disabled', this.bookmarks.length === 0);
  }
  /** The address follows the page's own player, and so may others. */
  changed() {
    if (window.player === this) noteAddress(this);
    this.onChange?.();
  }

  setTheme(name) {
    const {themes} = GradusPlayer;
    this.theme = themes.find((theme) => theme.name === name) ?? themes[0];
    for (const [tone, color] of Object.entries(this.theme.tones))
      this.root.style.setProperty(`--${tone}`, color);
    this.theme.quantities.forEach((color, number) => this.root.style.setProperty(`--quantity-${number}`, color));
    this.root.classList.toggle('underlined', this.theme.underlined);
    this.root.style.setProperty('--measure-text', this.look('measure').text);
    this.root.style.setProperty('--measure-mark', this.look('measure').mark);
    this.root.style.colorScheme = this.theme.name === 'dark' ? 'dark' : 'light';
    this.root.dataset.theme = this.theme.name;
    this.parts.theme.textContent = say(`theme_${this.theme.name}`);
    if (!this.run) return;
    this.showPhases();
    this.redraw();
  }
  /** As the reader wishes: that goes into the address. */
  chooseTheme(name) {
    this.themeChosen = true;
    this.setTheme(name);
    this.changed();
  }
  nextTheme() {
    const {themes} = GradusPlayer;
    this.chooseTheme(themes[(themes.indexOf(this.theme) + 1) % themes.length].name);
  }
  look(role) { return this.theme.roles.find((look) => look.role === role); }

  /** All that can be seen of this step, as plain data. */
  state() {
    const {run, index} = this, rows = [...Array(run.table.count(index)).keys()];
    return {
      step: run.steps[index].number,
      loop: this.loop.on ? [this.loop.first, this.loop.last].map((i) => run.steps[i].number) : null,
      bookmarks: this.bookmarks.map((i) => run.steps[i].number),
      speed: SPEEDS[this.speed],
      pace: this.pace,
      position: this.parts.position.textContent,
      sentence: this.said(run.steps[index]),
      view: this.drawing.at.view,
      cells: this.drawing.visibleCells().map(([x, y, role, text]) => [x, y, run.trace.roles[role], text]),
      marks: this.drawing.canvas.sortedMarks(),
      table: rows.map((row) => run.table.row(row, index)),
      listing: run.listing(index).map((emphasis, i) => [run.lines[i], emphasis]),
      legend: this.drawing.legend.entries().map(([role]) => run.trace.roles[role]),
    };
  }

  said(step) { return (this.statesGoal(step) ? `${this.run.trace.goal} ` : '') + (step.sentence ?? ''); }

  // -- What is shown

  /** All that stays through the steps of a trace. */
  showTrace() {
    const {parts, run} = this, {trace} = run;
    parts.title.textContent = trace.title || document.title;
    parts.subtitle.textContent = parts.subtitle.title = trace.subtitle;
    parts.method.textContent = run.shows('title') ? trace.method_title || trace.method : '';
    parts.faulty.textContent = trace.faulty ? `\u26a0\ufe0e ${say('faulty', {what: trace.faulty})}` : '';
    parts.faulty.hidden = !trace.faulty;
    this.root.setAttribute('aria-label', this.name);
    this.showSlots();
    this.showListing();
    this.showColumns();
    parts.slider.max = run.steps.length - 1;
    parts.total.textContent = `/ ${trace.last}`;
    parts.total.title = this.recorded();
    this.notice(this.recorded());
    parts.goal.replaceChildren(...this.letters.sentence(trace.goal));
    parts.command.hidden = !this.command;
    parts['command-text'].textContent = this.command;
    parts['table-copy'].hidden = parts.table.hidden;
    const phases = [...new Set(run.phases().map((phase) => phase.name))].slice(0, 100);
    const number = run.steps[run.lastMilestone].number;
    const longest = Math.max(...phases.map((phase) => textWidth(this.positionOf({number, phase}), 1)));
    this.root.style.setProperty('--position-width', `${Math.min(longest, 30)}em`);
    this.longest = this.columns = undefined;
    this.scrub.load(run);
    this.setSpeed(this.speed);
    this.setLoop();
    this.setBookmarks([]);
  }
  get name() { return `${this.run.trace.title} ${this.run.trace.subtitle}`.trim(); }
  /** What is said of a recording that is not the whole run. */
  recorded() {
    const {run} = this, {trace} = run, first = run.steps[0].number;
    if (first === '0' && run.milestones.length === trace.last + 1) return '';
    return say('recorded', {first, last: run.steps[run.lastMilestone].number, end: trace.last});
  }
  /** A slot that is not in the trace leaves its room to the others. */
  showSlots() {
    const {parts, run, root} = this, {trace} = run;
    parts.listing.hidden = trace.listing.length === 0;
    parts.table.hidden = trace.columns.length === 0;
    parts.side.hidden = parts.listing.hidden && parts.table.hidden;
    parts.drawing.hidden = !run.shows('drawing');
    parts.said.hidden = !run.shows('sentence');
    parts.footer.hidden = !run.shows('footer');
    // A page without a heading is hard to find one's way in by ear
    parts.title.classList.toggle('unseen', !run.shows('title'));
    parts.subtitle.hidden = parts.method.hidden = !run.shows('title');
    for (const part of ['drawing', 'side', 'listing', 'table'])
      root.classList.toggle(`no-${part}`, parts[part].hidden);
  }
  showListing() {
    const {trace} = this.run;
    this.longestLine = Math.max(0, ...trace.listing.map(([, text]) => sourceRows(text, Infinity)[0].length));
    const digits = String(trace.listing.length).length;
    this.parts.listing.style.setProperty('--digits', digits);
    this.parts.lines.replaceChildren(...trace.listing.map(
        ([, text], position) => html(
            'li', {'data-position': position},
            html(
                'button',
                {type: 'button', tabindex: -1, 'aria-label': say('line', {number: position + 1})},
                String(position + 1)),
            html('code', {}, ...this.letters.html(text, true)))));
  }
  /** Long lines go on below, where code is broken; `columns`: characters that fit. */
  breakLines(columns) {
    const {trace} = this.run;
    if (columns === this.columns) return;
    this.columns = columns;
    this.heights = trace.listing.map(([, text], position) => {
      const rows = sourceRows(text, columns), item = this.parts.lines.children[position];
      item.lastChild.replaceChildren(...this.letters.html(rows.join('\n'), true));
      item.style.setProperty('--rows', rows.length);
      return rows.length;
    });
  }
  showColumns() {
    const {trace} = this.run;
    // As wide as the widest text asks for, the rest shared evenly: the table keeps still from the first step on
    const wanted = trace.columns.map(({name, widest}) => {
      const text = Math.max(textWidth(name, 1, 'bold'), textWidth(widest, 1, 'bold', MONO));
      return Math.min(text + 0.9, 24);
    });
    const sum = wanted.reduce((a, b) => a + b, 0), spare = Math.max(24 - sum, 0) / wanted.length;
    this.tableWidth = sum;
    this.parts.grid.style.setProperty('--wanted', sum);
    this.parts.columns.replaceChildren(...trace.columns.map(
        ({id, name, quantity}, c) => html(
            'th',
            {scope: 'col', class: this.letters.className(quantity ?? id), style: `width: ${(100 * (wanted[c] + spare)) / (sum + spare * wanted.length)}%`},
            ...this.letters.html(name))));
  }
  showPhases() { this.scrub.showPhases((role) => this.look(role)); }

  show(index) {
    if (!this.run) return;
    this.index = clamp(index, 0, this.run.steps.length - 1);
    this.redraw(!this.flying && !matchMedia('(prefers-reduced-motion: reduce)').matches);
    this.announce();
    this.changed();
  }
  /** For readers by ear: once a step, and not while steps fly past. */
  announce() {
    const step = this.run.steps[this.index];
    if (this.flying) return;
    this.parts.live.textContent = `${this.positionOf(step)}: ${this.said(step)}`;
  }
  /** What the step read and what it made: the values in the table's last two rows. */
  valuesAt(index) {
    const {table, trace} = this.run, count = table.count(index), rows = [];
    for (let row = Math.max(0, count - 2); row < count; ++row) rows.push(table.cells(row, index));
    return this.letters.valuesIn(trace.columns, rows);
  }
  redraw(moving = false) {
    const {parts, run, index} = this, step = run.steps[index];
    parts.sentence.replaceChildren(...this.letters.sentence(step.sentence ?? '', this.valuesAt(index)));
    parts.goal.hidden = !this.statesGoal(step);
    if (run.shows('drawing')) this.redrawDrawing(moving);
    this.redrawListing();
    this.redrawTable(true);
    this.redrawFooter(step);
    this.redrawControls(step);
  }
  redrawDrawing(moving) {
    const {svg} = this.drawing, {parts} = this;
    this.drawing.draw(this.index, this.theme, this.unit / TEXT, moving);
    svg.setAttribute('aria-label', say('drawing', {title: this.name}));
    if (!parts.said.hidden) svg.setAttribute('aria-describedby', parts.said.id);
  }
  /** Step 0 says what it is all about, unless its own sentence does. */
  statesGoal(step) {
    const {goal} = this.run.trace;
    return step.number === '0' && goal !== '' && !(step.sentence ?? '').includes(goal);
  }
  redrawListing() {
    const emphasis = this.run.listing(this.index), items = [...this.parts.lines.children];
    const strong = emphasis.indexOf('strong'), reachable = Math.max(strong, 0);
    items.forEach((item, i) => {
      item.className = emphasis[i] === 'none' ? '' : emphasis[i];
      if (i === strong)
        item.setAttribute('aria-current', 'step');
      else
        item.removeAttribute('aria-current');
      item.firstChild.tabIndex = i === reachable ? 0 : -1;
    });
    this.scrollListing(strong);
  }
  /** Whole lines only; a dashed edge where there are more, and the head of the loop held above them. */
  scrollListing(strong) {
    const {listing, lines} = this.parts, items = [...lines.children];
    if (items.length === 0) return;
    const {first, last, head} = this.excerpts.with(strong);
    items.forEach((item, i) => item.classList.toggle('held', i === head));
    listing.classList.toggle('above', first > 0 && head !== 0);
    listing.classList.toggle('below', last < items.length);
    const sum = (from, to) => this.heights.slice(from, to).reduce((a, b) => a + b, 0);
    const above = head < 0 ? 0 : this.heights[head] + 1;
    // The held line takes the room of a row more, for the dots below it
    lines.scrollTop = (sum(0, first) + (head < 0 ? 0 : 1) - above) * this.line;
  }

  /** Only the rows that can be seen are made; gaps stand for the others. */
  redrawTable(toEnd) {
    const {table, rows} = this.parts, {trace} = this.run;
    if (table.hidden) return;
    const count = this.run.table.count(this.index), height = 1.7 * this.unit, visible = this.room.rows;
    table.style.height = `${1.9 * this.unit + Math.min(count, visible) * height + 3}px`;
    const first = toEnd ? Math.max(count - visible, 0) : Math.floor(table.scrollTop / height);
    table.classList.toggle('above', first > 0);
    table.classList.toggle('below', first + visible < count);
    const from = clamp(first - 4, 0, count), to = clamp(first + visible + 4, from, count);
    const focused = rows.contains(document.activeElement) && document.activeElement.dataset.row;
    rows.replaceChildren(
        this.gap(from * height), ...Array.from({length: to - from}, (_, i) => this.tableRow(from + i)),
        this.gap((count - to) * height));
    if (focused) this.focusRow(focused);
    for (const column of rows.querySelectorAll('.gap td')) column.colSpan = trace.columns.length;
    this.parts.grid.setAttribute('aria-rowcount', count + 1);
    table.tabIndex = count === 0 ? 0 : -1;  // without a row the keys still scroll it sideways
    if (toEnd) table.scrollTop = count * height;
    this.rowsMadeAt = table.scrollTop;
  }
  /** Rows are made anew; who stood on one stands there again, or on the current one. */
  focusRow(row) {
    const {rows} = this.parts, same = rows.querySelector(`[data-row="${row}"]`);
    (same ?? rows.querySelector('[tabindex="0"]') ?? this.stage).focus({preventScroll: true});
  }
  gap(height) {
    const row = html('tr', {class: 'gap', 'aria-hidden': 'true', style: `height: ${height}px`}, html('td'));
    row.hidden = height <= 0;
    return row;
  }
  tableRow(row) {
    const {trace, table} = this.run, {cells, emphasis, changed} = table.row(row, this.index);
    const made = this.run.steps[table.made[row]].number;
    const out = html('tr', {
      'data-row': row,
      tabindex: row === this.reachableRow() ? 0 : -1,
      'aria-rowindex': row + 2,
      class: emphasis === 'none' ? undefined : emphasis,
      title: say('made_by', {number: made}),
      'aria-current': emphasis === 'strong' ? 'step' : undefined
    });
    trace.columns.forEach((column, c) => {
      const cell = html('td', {}, html('span', {}, ...this.letters.html(cells[c] ?? '')));
      cell.classList.toggle('numeric', column.numeric);
      const quantity = this.letters.coded.get(column.quantity ?? column.id);
      if (quantity !== undefined) cell.classList.add(`quantity-${quantity}`);
      if (changed[c]) {
        cell.classList.add('changed');
        cell.append(html('i', {class: 'unseen'}, ` ${say('changed')}`));
      }
      out.append(cell);
    });
    return out;
  }
  /** The row that Tab leads to: this step's, or the last one. */
  reachableRow() { return this.run.table.madeRow.get(this.index) ?? this.run.table.count(this.index) - 1; }
  positionOf({number, phase}) {
    const place = say('step', {number, last: this.run.trace.last});
    return phase ? `${place} · ${phase}` : place;
  }
  redrawFooter(step) {
    const {parts, run} = this, s = this.unit / TEXT;
    parts.position.textContent = this.positionOf(step);
    parts.legend.hidden = run.trace.legend.length === 0 || parts.drawing.hidden;
    if (parts.legend.hidden) return;
    parts.legend.replaceChildren(...this.drawing.legend.entries().map(
        (entry) =>
            html('li', {'data-role': run.trace.roles[entry[0]]}, this.drawing.legend.swatch(entry, s), entry[1])));
  }
  redrawControls(step) {
    const {parts, run, index} = this;
    parts.slider.value = index;
    parts.slider.setAttribute('aria-valuetext', parts.position.textContent);
    if (document.activeElement !== parts.wanted) parts.wanted.value = step.number;
    for (const [does, off] of [
             ['first', index === 0], ['previous', index === 0], ['next', this.atEnd], ['last', this.atEnd]]) {
      this.root.querySelector(`[data-do="${does}"]`).setAttribute('aria-disabled', off);
    }
    this.redrawBookmark();
  }
  /** Beside the controls, or in the dialog that lies over them. */
  notice(text) {
    const {notice, copied, copying} = this.parts;
    notice.textContent = copying.open ? '' : text;
    copied.textContent = copying.open ? text : '';
  }

  /**
   * Text is 1/36 of the height, so that a full screen is a slide; one column where there is no room for two.
   */
  resize() {
    const {root} = this, width = root.clientWidth;
    // Of two side by side each has a drawing alone
    const together = document.body.classList.contains('together');
    const narrow = width < (together || root.classList.contains('embedded') ? 560 : 700);
    root.dataset.layout = narrow ? 'narrow' : 'wide';
    this.unit = narrow ? 15 : clamp(Math.min(root.clientHeight / 36, width / (together ? 40 : 64)), 12, 80);
    this.line = (narrow ? 1.6 : 1.5) * this.unit;  // a finger needs 24 px
    root.style.setProperty('--u', `${this.unit}px`);
    root.style.setProperty('--line', `${this.line}px`);
    if (!this.run) return;
    this.shareWidth(narrow);
    this.reserveSentence();
    this.reserveFooter();
    this.shareSide(narrow);
    const drawn = narrow && !this.parts.drawing.hidden;
    this.parts.drawing.style.height = drawn ? `${this.heightOfDrawing()}px` : '';
    this.showPhases();
    this.redraw();
  }
  /** Room for the longest sentence there is, so that nothing below it jumps. */
  reserveSentence() {
    const {said, sentence, goal} = this.parts;
    this.longest ??=
        [...this.run.steps].sort((a, b) => this.said(b).length - this.said(a).length).slice(0, 8);
    said.style.minHeight = '';
    const heights = this.longest.map((step) => {
      goal.hidden = !this.statesGoal(step);
      sentence.replaceChildren(...this.letters.sentence(step.sentence ?? ''));
      return said.offsetHeight;
    });
    said.style.minHeight = `${Math.max(...heights)}px`;
  }
  /** Room for the longest position and the whole legend, so that nothing moves when a role appears. */
  reserveFooter() {
    const {parts, run} = this, s = this.unit / TEXT, footer = parts.legend.parentElement;
    const positions = run.steps.map((step) => this.positionOf(step));
    parts.position.textContent = positions.reduce((a, b) => (b.length > a.length ? b : a), '');
    parts.legend.hidden = run.trace.legend.length === 0 || parts.drawing.hidden;
    parts.legend.replaceChildren(...run.trace.legend.map(
        ([, text]) => html('li', {}, svg('svg', {width: 32 * s, height: 18 * s}), text)));
    footer.style.minHeight = '';
    footer.style.minHeight = `${footer.offsetHeight}px`;
  }
  /** The drawing gets what listing and table leave: as narrow as they can be read. */
  shareWidth(narrow) {
    const {parts, run, unit, root} = this, letter = textWidth('0', narrow ? Math.max(unit, 11) : unit, '', MONO);
    const gutter = String(run.lines.length).length * letter + 2.1 * unit;
    const asked = run.lines.length ? Math.min(this.longestLine, MOST_COLUMNS) * letter + gutter + 4 : 0;
    const wanted = Math.max(asked, parts.table.hidden ? 0 : this.tableWidth * unit);
    root.style.setProperty('--side', `${clamp(wanted / unit, 16, 30.2)}`);
    if (run.lines.length) this.breakLines(Math.max(Math.floor((parts.listing.clientWidth - gutter) / letter + 0.01), 8));
  }
  /** Whole lines and whole rows only. */
  shareSide(narrow) {
    const {parts, unit} = this, count = this.run.lines.length, panel = 0.7 * unit + 3;
    const table = !parts.table.hidden, gap = 0.9 * unit, row = 1.7 * unit, {line} = this;
    const room = narrow ? Infinity : parts.side.clientHeight;
    const forTable = table ? 1.9 * unit + 3 + 3 * row + (count ? gap : 0) : 0;
    const forLines = room - (parts.drawing.hidden ? 0 : forTable) - panel;
    const all = count ? this.heights.reduce((a, b) => a + b, 0) : 0;
    const lines = Math.min(all, narrow ? 14 : Math.max(Math.floor(forLines / line), 3));
    this.excerpts = count ? new Excerpts(this.run, this.heights, lines) : null;
    parts.lines.style.height = `${lines * line}px`;
    const beside = !narrow && parts.drawing.hidden;  // then the table stands beside the listing
    const left = room - (count && !beside ? lines * line + panel + gap : 0) - 1.9 * unit - 3;
    this.room = {rows: narrow ? 7 : Math.max(Math.floor(left / row), 2)};
  }
  heightOfDrawing() {
    const {stage} = this.drawing, width = this.parts.drawing.clientWidth, s = this.unit / TEXT;
    const most = 0.6 * window.innerHeight, {follows, needs} = arrange(stage, width, 1e6, s, stage.grid.lower);
    return follows ? most : Math.min(needs.height, most);
  }

  // -- What is done to it

  bind() {
    const {root, parts} = this;
    root.addEventListener('click', (event) => this.clicked(event));
    root.addEventListener('pointerdown', (event) => {
      GradusPlayer.active = this;
      // A mouse does not take the focus to a button: the keys stay with the player, or come to its frame
      const button = event.target.closest('.controls button');
      if (!button) return;
      event.preventDefault();
      this.stage.focus({preventScroll: true});
    });
    parts.slider.addEventListener('input', () => {
      this.pause();
      this.show(Number(parts.slider.value));
    });
    parts.go.addEventListener('submit', (event) => {
      event.preventDefault();
      this.submitWanted();
    });
    parts.wanted.addEventListener('focus', () => parts.wanted.select());
    parts.wanted.addEventListener('blur', () => this.endWanted());
    parts.table.addEventListener('scroll', () => {
      if (this.run && Math.abs(parts.table.scrollTop - this.rowsMadeAt) > 1) this.redrawTable(false);
    });
    // Who goes through the lines by keyboard leaves the excerpt, which comes back
    parts.lines.addEventListener('focusout', ({relatedTarget}) => {
      if (this.run && !parts.lines.contains(relatedTarget)) this.redrawListing();
    });
    parts.drawing.addEventListener('pointermove', (event) => this.readOut(event));
    parts.drawing.addEventListener('pointerleave', () => {
      parts.readout.textContent = '';
    });
  }
  clicked(event) {
    if (!this.run) return;
    const does = event.target.closest('[data-do]');
    if (does) return this.does(does.dataset.do);
    const line = event.target.closest('[data-position]');
    if (line)
      return this.goToMaker(
          this.run.nextExecution(Number(line.dataset.position), this.index), say('no_line'));
    const row = event.target.closest('[data-row]');
    if (row) return this.goToMaker(this.run.table.made[Number(row.dataset.row)]);
    const flag = event.target.closest('[data-flag]');
    if (flag) return this.goToBookmark(Number(flag.dataset.flag));
    if (this.parts.drawing.contains(event.target)) this.clickedDrawing(event);
  }
  clickedDrawing(event) {
    const mark = event.target.closest('[data-mark]');
    if (mark) return this.goToMaker(this.run.makerOfMark(mark.dataset.mark, this.index));
    const cell = this.cellAt(event);
    if (!cell) return;
    const [x, y] = cell;
    this.goToMaker(this.run.makerOfCell(x, y), say('no_cell', {x, y}));
  }
  cellAt(event) {
    const box = this.parts.drawing.getBoundingClientRect();
    return this.drawing.at && toCell(this.drawing.at, event.clientX - box.left, event.clientY - box.top);
  }
  readOut(event) {
    if (!this.run) return;
    const cell = this.cellAt(event), {grid} = this.run.trace;
    this.parts.readout.textContent = cell ? `${grid.x_name} = ${cell[0]}, ${grid.y_name} = ${cell[1]}` : '';
  }
  goToMaker(index, otherwise = '') {
    this.pause();
    if (index >= 0) this.show(index);
    this.notice(index >= 0 ? '' : otherwise);
  }
  does(what) {
    if (what === 'play') return this.toggle();
    if (['first', 'previous', 'next', 'last'].includes(what)) return this.move(what);
    const others = {
      slower: () => this.changeSpeed(-1),
      faster: () => this.changeSpeed(1),
      backwards: () => this.toggleBackwards(-1),
      fast_backwards: () => this.toggleBackwards(-FAST),
      replay: () => this.replay(),
      loop: () => this.toggleLoop(),
      loop_from: () => this.markLoop('first'),
      loop_to: () => this.markLoop('last'),
      bookmark: () => this.toggleBookmark(),
      next_bookmark: () => this.nextBookmark(),
      theme: () => this.nextTheme(),
      keys: () => this.openKeys(),
      copying: () => this.openCopying(),
      copy_link: () => this.copy({'text/plain': this.link()}, 'copied_link'),
      copy_command: () => this.copy({'text/plain': this.command}, 'copied_command'),
      copy_table: () => this.copy(this.tableSoFar(), 'copied_table'),
      full: () => this.toggleFull(),
    };
    others[what]?.();
  }
  /** A step by hand: it ends the playing. */
  move(how) {
    this.pause();
    this.notice('');
    this[how]();
  }
  openKeys() {
    const {keys} = this.parts;
    keys.showModal();
    keys.focus();  // not its button, which is out of sight where the list is long
    keys.scrollTop = 0;
  }
  openCopying() {
    const {parts} = this;
    this.pause();
    this.notice('');
    parts['by-hand'].hidden = true;
    parts['link-text'].textContent = this.link();
    parts.copying.showModal();
  }
  /** The address of this step, with all that the page keeps in it. */
  link() { return location.href.split('#')[0] + addressOf(this); }
  tableSoFar() {
    const {run, index} = this, rows = [...Array(run.table.count(index)).keys()];
    return tableForms(run.trace.columns, rows.map((row) => run.table.cells(row, index)));
  }
  async copy(forms, done) {
    const {copying, 'by-hand': byHand} = this.parts;
    const copied = await copyForms(forms, copying);
    byHand.hidden = copied;
    this.notice(say(copied ? done : 'copy_by_hand'));
    if (copied) return;
    byHand.value = forms['text/plain'];
    byHand.select();
  }
  toggleFull() {
    if (document.fullscreenElement)
      document.exitFullscreen();
    else
      this.root.requestFullscreen?.().catch(() => this.notice(say('no_full_screen')));
  }
  submitWanted() {
    const {wanted} = this.parts;
    this.pause();
    if (!this.goTo(wanted.value)) {
      wanted.setAttribute('aria-invalid', 'true');
      return this.notice(this.noStep(wanted.value));
    }
    wanted.blur();
  }
  noStep(number) {
    const {steps} = this.run;
    return say('no_step', {number, first: steps[0].number, last: steps[steps.length - 1].number});
  }
  endWanted() {
    const {wanted} = this.parts;
    if (wanted.getAttribute('aria-invalid')) this.notice('');
    wanted.removeAttribute('aria-invalid');
    if (this.run) wanted.value = this.run.steps[this.index].number;
  }

  /** Whether the key was for the player. */
  key(event) {
    const {key, target} = event;
    const full = document.fullscreenElement !== null;
    const moves = {
      ArrowRight: 'next',
      ArrowLeft: 'previous',
      '.': 'nextEvent',
      ',': 'previousEvent',
      Home: 'first',
      End: 'last',
      ...(full ? {PageDown: 'next', PageUp: 'previous'} : {}),
    };
    if (moves[key]) return this.move(moves[key]), true;
    const other = {
      '+': 'faster',
      '=': 'faster',
      '-': 'slower',
      '?': 'keys',
      ' ': 'play',
      '[': 'loop_from',
      ']': 'loop_to',
      l: 'loop',
      b: 'bookmark',
      'shift b': 'next_bookmark',
      r: 'replay',
      g: 'go',
      f: 'full',
      t: 'theme',
    }[nameOfKey(event)];
    if (other === 'play' && target.closest?.('button')) return false;  // the button's own
    if (other === 'go') return this.parts.wanted.focus(), true;
    if (other) return this.does(other), true;
    if (key.toLowerCase() === 'v') return this.playBackwards(event.shiftKey), true;
    if (key === 'ArrowUp' || key === 'ArrowDown') return this.moveFocus(target, key === 'ArrowDown' ? 1 : -1);
    if (key === 'Enter' && target.matches?.('[data-row]')) return target.click(), true;
    return false;
  }
  /** First at the usual pace, then fast, then as usual again. */
  playBackwards(fast) { this.play(fast || this.pace === -1 ? -FAST : -1); }
  /**
   * Up and down in the listing and in the table: one of its lines is in the tab order, the arrows reach all.
   */
  moveFocus(target, by) {
    const line = target.closest?.('[data-position]');
    const row = target.closest?.('tr[data-row]');
    if (line) this.parts.lines.children[Number(line.dataset.position) + by]?.firstChild.focus();
    if (row) this.rowNode(Number(row.dataset.row) + by)?.focus();
    return Boolean(line || row);
  }
  /** A row's element, made if need be; none for a row that is not there. */
  rowNode(row) {
    const {table, rows} = this.parts, find = () => rows.querySelector(`[data-row="${row}"]`);
    if (find() || row < 0 || row >= this.run.table.count(this.index)) return find();
    table.scrollTop = row * 1.7 * this.unit;
    this.redrawTable(false);
    return find();
  }
}

// ---- The page --------------------------------------------------------------------------------------------

function preferredTheme() {
  const asked = addressParts().get('theme') || GradusPlayer.firstTheme;
  if (asked) return asked;
  if (matchMedia('(prefers-contrast: more)').matches) return 'high_contrast';
  return matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
}

/** Letters in small, whatever the caps lock says: "b", "shift b". */
function nameOfKey({key, shiftKey}) {
  if (!/^[a-z]$/i.test(key)) return key;
  return (shiftKey ? 'shift ' : '') + key.toLowerCase();
}
const isTyping = (target) =>
    target.isContentEditable || (target.matches?.('input, textarea, select') && target.type !== 'range');
/** Control and its like are the browser's; but brackets are typed with them where they are no keys. */
const isOurs = ({key, ctrlKey, metaKey, altKey}) => '[]'.includes(key) || !(ctrlKey || metaKey || altKey);

addEventListener('keydown', (event) => {
  if (!isOurs(event) || event.defaultPrevented) return;
  if (isTyping(event.target)) {
    if (event.key === 'Escape') event.target.blur();
    return;
  }
  const player = all.find((p) => p.root.contains(event.target)) ?? GradusPlayer.active ?? all[0];
  if (!player?.run) return;
  if (player.root.querySelector('dialog[open]')) {
    if (event.key === '?') player.parts.keys.close();
    return;
  }
  if (player.key(event)) event.preventDefault();
});

window.GradusPlayer = GradusPlayer;

const page = document.getElementById('gradus-page');
if (page) {
  const started = performance.now();
  const data = JSON.parse(page.textContent);
  for (const [key, text] of Object.entries(data.words)) words.set(key, text);
  GradusPlayer.themes = data.themes;
  GradusPlayer.firstTheme = data.theme;
  window.player = new GradusPlayer(document.getElementById('player'));
  window.player.load(data.trace, {command: data.command});
  followAddress(window.player);
  if (data.beside) playTogether(window.player, data.beside);
  addEventListener('hashchange', (event) => followAddress(window.player, new URL(event.newURL).hash));
  performance.measure('gradus: open', {start: started, end: performance.now()});
}
