'use strict';
// The player of a recorded run. `new GradusPlayer(root).load(trace)` shows a trace of schema 1 (see
// trace_json) in any element; every picture is drawn from the trace's marks at the moment it is looked at.
// Needs run.js and drawing.js.

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16, 32];  // steps a second
const all = [];

class GradusPlayer {
  /** The looks there are: {name, tones, roles}. The page sets them before it makes a player. */
  static themes = [];

  constructor(root) {
    this.root = root;
    this.prefix = `gradus-${all.length + 1}`;
    root.classList.add('gradus');
    root.replaceChildren(document.getElementById('gradus-player').content.cloneNode(true));
    this.parts = {};
    for (const node of root.querySelectorAll('[data-part]')) this.parts[node.dataset.part] = node;
    this.drawing = new Drawing(this.parts.drawing, this.prefix);
    this.speed = SPEEDS.indexOf(1);
    this.bind();
    this.setTheme(preferredTheme());
    all.push(this);
    new ResizeObserver(() => this.resize()).observe(root);
  }

  /** Shows a trace from its first step on, paused. `more.command`: what makes it again, to copy. */
  load(trace, more = {}) {
    const run = new Run(trace);
    this.pause();
    this.run = run;
    this.index = 0;
    this.command = more.command ?? '';
    this.drawing.load(this.run);
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

  play() {
    if (this.timer) return;
    if (this.atEnd) this.first();
    this.root.classList.add('playing');
    this.parts.play.setAttribute('aria-label', 'Pause');
    this.parts.live.setAttribute('aria-live', 'off');  // a reader could not follow
    const tick = () => {
      this.next();
      if (this.atEnd)
        this.pause();
      else
        this.timer = setTimeout(tick, 1000 / SPEEDS[this.speed]);
    };
    this.timer = setTimeout(tick, 1000 / SPEEDS[this.speed]);
  }
  pause() {
    clearTimeout(this.timer);
    this.timer = 0;
    this.root.classList.remove('playing');
    this.parts.play.setAttribute('aria-label', 'Play');
    this.parts.live.setAttribute('aria-live', 'polite');
  }
  toggle() {
    if (this.timer)
      this.pause();
    else
      this.play();
  }
  get playing() { return Boolean(this.timer); }

  changeSpeed(by) {
    this.speed = clamp(this.speed + by, 0, SPEEDS.length - 1);
    this.parts.speed.textContent = `${SPEEDS[this.speed]}/s`;
    this.parts.speed.setAttribute('aria-label', `${SPEEDS[this.speed]} steps a second`);
  }

  setTheme(name) {
    const {themes} = GradusPlayer;
    this.theme = themes.find((theme) => theme.name === name) ?? themes[0];
    for (const [tone, color] of Object.entries(this.theme.tones))
      this.root.style.setProperty(`--${tone}`, color);
    this.root.style.setProperty('--measure-text', this.look('measure').text);
    this.root.style.setProperty('--measure-mark', this.look('measure').mark);
    this.root.style.colorScheme = this.theme.name === 'dark' ? 'dark' : 'light';
    this.root.dataset.theme = this.theme.name;
    this.parts.theme.textContent = this.theme.name.replace('_', ' ');
    if (!this.run) return;
    this.showPhases();
    this.redraw();
  }
  nextTheme() {
    const {themes} = GradusPlayer;
    this.setTheme(themes[(themes.indexOf(this.theme) + 1) % themes.length].name);
  }
  look(role) { return this.theme.roles.find((look) => look.role === role); }

  /** All that can be seen of this step, as plain data. */
  state() {
    const {run, index} = this, rows = [...Array(run.table.count(index)).keys()];
    return {
      step: run.steps[index].number,
      position: this.parts.position.textContent,
      sentence: this.said(run.steps[index]),
      view: this.drawing.at.view,
      cells: this.drawing.visibleCells().map(([x, y, role, text]) => [x, y, run.trace.roles[role], text]),
      marks: this.drawing.canvas.sortedMarks(),
      table: rows.map((row) => run.table.row(row, index)),
      listing: run.listing(index).map((emphasis, i) => [run.lines[i], emphasis]),
      legend: this.drawing.legendRoles().map(([role]) => run.trace.roles[role]),
    };
  }

  said(step) { return (this.statesGoal(step) ? `${this.run.trace.goal} ` : '') + (step.sentence ?? ''); }

  // -- What is shown

  /** All that stays through the steps of a trace. */
  showTrace() {
    const {parts, run} = this, {trace} = run;
    parts.title.textContent = trace.title;
    parts.subtitle.textContent = parts.subtitle.title = trace.subtitle;
    parts.faulty.textContent = trace.faulty ?? '';
    parts.faulty.hidden = !trace.faulty;
    this.root.setAttribute('aria-label', `${trace.title} ${trace.subtitle}`);
    this.showListing();
    this.showColumns();
    parts.slider.max = run.steps.length - 1;
    const first = run.steps[0].number, last = run.steps[run.lastMilestone].number;
    const whole = first === '0' && run.milestones.length === trace.last + 1;
    parts.total.textContent = `/ ${trace.last}`;
    parts.method.textContent = trace.method_title || trace.method;
    const recorded = whole ? '' : `recorded: steps ${first} to ${last} of 0 to ${trace.last}`;
    parts.total.title = recorded;
    this.notice(recorded);
    parts.goal.textContent = trace.goal;
    parts.command.hidden = !this.command;
    parts['command-text'].textContent = this.command;
    const phases = [...new Set(run.phases().map((phase) => phase.name))].slice(0, 100);
    const longest = Math.max(...phases.map((phase) => textWidth(this.positionOf({number: last, phase}), 1)));
    this.root.style.setProperty('--position-width', `${Math.min(longest, 30)}em`);
    this.longest = undefined;
    this.changeSpeed(0);
  }
  showListing() {
    const {trace} = this.run;
    this.parts.listing.hidden = trace.listing.length === 0;
    const characters = Math.max(44, ...trace.listing.map(([, text]) => text.length));
    this.parts.listing.style.setProperty('--characters', Math.min(characters, 60));
    this.parts.lines.replaceChildren(...trace.listing.map(
        ([number, text], position) => html(
            'li', {'data-position': position},
            html(
                'button',
                {type: 'button', tabindex: -1, 'aria-label': `line ${number}: go to its next execution`},
                String(number)),
            html('code', {}, text))));
  }
  showColumns() {
    const {trace} = this.run;
    this.parts.table.hidden = trace.columns.length === 0;
    this.parts.side.hidden = trace.columns.length === 0 && trace.listing.length === 0;
    // As wide as the widest text asks for, the rest shared evenly: the table keeps still from the first step on
    const wanted = trace.columns.map(({name, widest}) => {
      const text = Math.max(textWidth(name, 1, 'bold'), textWidth(widest, 1, 'bold', MONO));
      return Math.min(text + 0.9, 24);
    });
    const sum = wanted.reduce((a, b) => a + b, 0), spare = Math.max(29 - sum, 0) / wanted.length;
    this.parts.grid.style.setProperty('--wanted', sum);
    this.parts.columns.replaceChildren(...trace.columns.map(
        ({name}, c) => html(
            'th',
            {scope: 'col', style: `width: ${(100 * (wanted[c] + spare)) / (sum + spare * wanted.length)}%`},
            name)));
  }
  /** A coloured bar for each phase, and its name where there is room. */
  showPhases() {
    const {steps} = this.run, phases = this.run.phases().filter((p) => p.name);
    const colors = ['current', 'measure', 'accepted', 'candidate', 'rejected', 'past'];
    const names = [...new Set(phases.map((p) => p.name))], end = Math.max(steps.length - 1, 1);
    const strip = this.parts.phases, room = strip.clientWidth;
    const size = parseFloat(getComputedStyle(strip).fontSize);
    strip.replaceChildren();
    if (phases.length > 200) return;  // they could not be told apart
    const bars = phases.map(({name, from, to}) => {
      const look = this.look(colors[names.indexOf(name) % colors.length]), width = textWidth(name, size) + 8;
      const left = (Math.max(from - 0.5, 0) / end) * room, right = (Math.min(to + 0.5, end) / end) * room;
      return {name, look, width, left, right};
    });
    let free = 0;
    bars.forEach((bar, i) => {
      const {name, look, left, right, width} = bar, next = bars[i + 1];
      strip.append(html('i', {
        style: `left: ${left}px; width: ${Math.max(right - left - 1, 1)}px; border-color: ${look.mark}`,
        title: name
      }));
      const at = Math.max(next ? left : Math.min(left, room - width), free);
      const until = next ? Math.max(right, next.right - next.width) : room;
      if (at + width > until) return;
      strip.append(html('span', {style: `left: ${at}px; color: ${look.text}`}, name));
      free = at + width;
    });
  }

  show(index) {
    if (!this.run) return;
    this.index = clamp(index, 0, this.run.steps.length - 1);
    this.redraw();
    if (window.player === this) noteAddress(this);
  }
  redraw() {
    const {parts, run, index} = this, step = run.steps[index];
    parts.sentence.textContent = step.sentence ?? '';
    parts.goal.hidden = !this.statesGoal(step);
    this.drawing.draw(index, this.theme, this.unit / TEXT);
    this.drawing.svg.setAttribute('aria-label', this.said(step) || 'drawing');
    this.redrawListing();
    this.redrawTable(true);
    this.redrawFooter(step);
    this.redrawControls(step);
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
  /** Whole lines only; a dashed edge where there are more. */
  scrollListing(strong) {
    const {listing, lines} = this.parts, {run} = this, shown = this.room.lines, height = 1.5 * this.unit;
    const first = run.firstListed(shown, strong);
    listing.classList.toggle('above', first > 0);
    listing.classList.toggle('below', first + shown < run.lines.length);
    lines.scrollTop = first * height;
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
    rows.replaceChildren(
        this.gap(from * height), ...Array.from({length: to - from}, (_, i) => this.tableRow(from + i)),
        this.gap((count - to) * height));
    for (const column of rows.querySelectorAll('.gap td')) column.colSpan = trace.columns.length;
    this.parts.grid.setAttribute('aria-rowcount', count + 1);
    if (toEnd) table.scrollTop = count * height;
    this.rowsMadeAt = table.scrollTop;
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
      tabindex: emphasis === 'strong' ? 0 : -1,
      'aria-rowindex': row + 2,
      class: emphasis === 'none' ? undefined : emphasis,
      title: `made by step ${made}`,
      'aria-current': emphasis === 'strong' ? 'step' : undefined
    });
    trace.columns.forEach((column, c) => {
      const cell = html('td', {}, html('span', {}, cells[c] ?? ''));
      cell.classList.toggle('numeric', column.numeric);
      if (changed[c]) {
        cell.classList.add('changed');
        cell.append(html('i', {class: 'unseen'}, ' changed'));
      }
      out.append(cell);
    });
    return out;
  }
  positionOf({number, phase}) {
    const place = `step ${number} / ${this.run.trace.last}`;
    return phase ? `${place} · ${phase}` : place;
  }
  redrawFooter(step) {
    const {parts, run} = this, s = this.unit / TEXT;
    parts.position.textContent = this.positionOf(step);
    parts.legend.replaceChildren(...this.drawing.legendRoles().map(
        ([role, text]) =>
            html('li', {'data-role': run.trace.roles[role]}, this.drawing.swatch(role, s), text)));
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
  }
  notice(text) { this.parts.notice.textContent = text; }

  /**
   * Text is 1/36 of the height, so that a full screen is a slide; one column where there is no room for two.
   */
  resize() {
    const {root} = this, width = root.clientWidth, narrow = width < 700;
    root.dataset.layout = narrow ? 'narrow' : 'wide';
    this.unit = narrow ? 15 : clamp(Math.min(root.clientHeight / 36, width / 64), 12, 80);
    root.style.setProperty('--u', `${this.unit}px`);
    if (!this.run) return;
    this.reserveSentence(width - (narrow ? 3.8 : 5.8) * this.unit);
    this.shareSide(narrow);
    this.parts.drawing.style.height = narrow ? `${this.heightOfDrawing()}px` : '';
    this.showPhases();
    this.redraw();
  }
  /** Room for the longest sentence there is, so that nothing below it jumps. */
  reserveSentence(room) {
    this.longest ??=
        this.run.steps.map((step) => this.said(step)).sort((a, b) => b.length - a.length).slice(0, 8);
    const lines = this.longest.map((text) => Math.ceil((1.04 * textWidth(text, 1.3 * this.unit)) / room));
    this.root.style.setProperty('--sentence-lines', clamp(Math.max(...lines), 1, 4));
  }
  /** Whole lines and whole rows only. */
  shareSide(narrow) {
    const {parts, run, unit} = this, count = run.lines.length, panel = 0.7 * unit + 3;
    const table = !parts.table.hidden, gap = 0.9 * unit, row = 1.7 * unit, line = 1.5 * unit;
    const room = narrow ? Infinity : parts.side.clientHeight;
    const forTable = table ? 1.9 * unit + 3 + 4 * row + (count ? gap : 0) : 0;
    const lines = Math.min(count, narrow ? 14 : Math.max(Math.floor((room - forTable - panel) / line), 3));
    parts.lines.style.height = `${lines * line}px`;
    const left = room - (count ? lines * line + panel + gap : 0) - 1.9 * unit - 3;
    this.room = {lines, rows: narrow ? 7 : Math.max(Math.floor(left / row), 2)};
  }
  heightOfDrawing() {
    const {grid} = this.run.trace, width = this.parts.drawing.clientWidth, s = this.unit / TEXT;
    const rows = grid.upper[1] - grid.lower[1] + 1, most = 0.6 * window.innerHeight;
    const {cell, follows} = arrange(grid, width, 1e6, s, grid.lower);
    return follows ? most : Math.min(rows * cell + (AXIS_BELOW + AXIS_ABOVE) * s, most);
  }

  // -- What is done to it

  bind() {
    const {root, parts} = this;
    root.addEventListener('click', (event) => this.clicked(event));
    root.addEventListener('pointerdown', (event) => {
      GradusPlayer.active = this;
      // A mouse does not take the focus to a button: the keys stay with the player
      const button = event.target.closest('.controls button');
      if (!button) return;
      event.preventDefault();
      document.activeElement?.blur();
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
          this.run.nextExecution(Number(line.dataset.position), this.index), 'no step executes this line');
    const row = event.target.closest('[data-row]');
    if (row) return this.goToMaker(this.run.table.made[Number(row.dataset.row)]);
    if (this.parts.drawing.contains(event.target)) this.clickedDrawing(event);
  }
  clickedDrawing(event) {
    const mark = event.target.closest('[data-mark]');
    if (mark) return this.goToMaker(this.run.makerOfMark(mark.dataset.mark, this.index));
    const cell = this.cellAt(event);
    if (cell) this.goToMaker(this.run.makerOfCell(...cell), `no recorded step made (${cell.join(', ')})`);
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
      theme: () => this.nextTheme(),
      keys: () => this.parts.keys.showModal(),
      command: () => this.parts['command-box'].showModal(),
      copy: () => this.copyCommand(),
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
  async copyCommand() {
    try {
      await navigator.clipboard.writeText(this.command);
      this.notice('copied');
    } catch {
      // Without leave to write: at least select it
      getSelection().selectAllChildren(this.parts['command-text']);
    }
  }
  toggleFull() {
    if (document.fullscreenElement)
      document.exitFullscreen();
    else
      this.root.requestFullscreen?.().catch(() => this.notice('the browser does not allow full screen here'));
  }
  submitWanted() {
    const {wanted} = this.parts;
    this.pause();
    if (!this.goTo(wanted.value)) {
      wanted.setAttribute('aria-invalid', 'true');
      const {steps} = this.run;
      const [first, last] = [steps[0].number, steps[steps.length - 1].number];
      return this.notice(`there is no step ${wanted.value}; there are ${first} to ${last}`);
    }
    wanted.blur();
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
      g: 'go',
      f: 'full',
      t: 'theme',
      '?': 'keys',
      ' ': 'play',
    }[key.length === 1 ? key.toLowerCase() : key];
    if (other === 'play' && target.closest?.('button')) return false;  // the button's own
    if (other === 'go') return this.parts.wanted.focus(), true;
    if (other) return this.does(other), true;
    if (key === 'ArrowUp' || key === 'ArrowDown') return this.moveFocus(target, key === 'ArrowDown' ? 1 : -1);
    if (key === 'Enter' && target.matches?.('[data-row]')) return target.click(), true;
    return false;
  }
  /**
   * Up and down in the listing and in the table: one of its lines is in the tab order, the arrows reach all.
   */
  moveFocus(target, by) {
    const line = target.closest?.('[data-position]');
    const row = target.closest?.('tr[data-row]');
    const next = line ? this.parts.lines.children[Number(line.dataset.position) + by]?.firstChild :
                        row && this.parts.rows.querySelector(`[data-row="${Number(row.dataset.row) + by}"]`);
    next?.focus();
    return Boolean(line || row);
  }
}

// ---- The page --------------------------------------------------------------------------------------------

function preferredTheme() {
  const asked = addressParts().get('theme');
  if (asked) return asked;
  if (matchMedia('(prefers-contrast: more)').matches) return 'high_contrast';
  return matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
}

/** "#step=7&embed" as a map. */
function addressParts(hash = location.hash) {
  const parts = hash.slice(1).split('&').filter(Boolean).map((part) => part.split('='));
  return new Map(parts.map(([name, value = '']) => [name, value]));
}
function noteAddress(player) {
  clearTimeout(player.addressTimer);
  // Browsers allow only so many changes a second
  player.addressTimer = setTimeout(() => {
    const parts = addressParts();
    parts.set('step', player.run.steps[player.index].number);
    const hash = [...parts].map(([name, value]) => (value ? `${name}=${value}` : name)).join('&');
    try {
      history.replaceState(null, '', `#${hash}`);
    } catch {
      // A frame without an address of its own
    }
  }, player.playing ? 300 : 30);
}
function followAddress(hash = location.hash) {
  const {player} = window, parts = addressParts(hash), step = parts.get('step');
  clearTimeout(player.addressTimer);
  player.root.classList.toggle('embedded', parts.has('embed'));
  if (step === undefined || step === player.run.steps[player.index].number) return;
  player.pause();
  if (!player.goTo(step)) player.notice(`there is no step ${step} in this recording`);
}

const isTyping = (target) =>
    target.isContentEditable || (target.matches?.('input, textarea, select') && target.type !== 'range');

addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
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
  const {themes, command, trace} = JSON.parse(page.textContent);
  GradusPlayer.themes = themes;
  window.player = new GradusPlayer(document.getElementById('player'));
  window.player.load(trace, {command});
  followAddress();
  addEventListener('hashchange', (event) => followAddress(new URL(event.newURL).hash));
  performance.measure('gradus: open', {start: started, end: performance.now()});
}
