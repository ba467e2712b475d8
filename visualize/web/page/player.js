'use strict';
// The player of a recorded run. `new GradusPlayer(root).load(trace)` shows a trace of schema 1 (see
// trace_json) in any element; every picture is drawn from the trace's marks at the moment it is looked at.
// What is seen of it is its view's; needs all scripts that come before.

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16, 32];  // steps a second
const PLAIN_SPEED = SPEEDS.indexOf(1);
const FAST = 4;  // times as fast, backwards
const all = [];

class GradusPlayer extends PlayerView {
  /** The looks there are: {name, tones, roles}. The page sets them before it makes a player. */
  static themes = [];
  /** The name of the first one; empty: what the reader's system prefers. */
  static firstTheme = '';

  constructor(root) {
    super(root, `gradus-${all.length + 1}`);
    this.speed = PLAIN_SPEED;
    this.bind();
    this.setTheme(preferredTheme());
    all.push(this);
    new ResizeObserver(() => this.resize()).observe(root);
    // The page's own letters come a moment after its first layout
    Promise.all([...document.fonts].map((font) => font.load())).then(() => {
      if (this.run) this.showColumns();
      this.drawing.forgetStill();
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
    this.setSpeed(this.speed);
    this.setLoop();
    this.setBookmarks([]);
    this.resize();
  }

  /**
   * Shows another run of the same algorithm, at the same step where there is one, else at the nearest: its input is
   * being changed. `light`: what takes long, the room that texts will need, stays as it is.
   */
  update(trace, {command = this.command, light = false} = {}) {
    const {run: before, index} = this, {number} = before.steps[index], atEnd = this.atEnd && index > 0;
    const same = this.sameSlots(trace, before.trace), old = {loop: this.loop, bookmarks: this.bookmarks};
    this.run = new Run(trace);
    this.command = command;
    this.index = atEnd ? this.run.steps.length - 1 : this.nearest(number);
    this.letters = new Typesetter(trace.names);
    this.drawing.load(this.run, this.letters);
    this.showTrace(light && same);
    this.keepPlaces(before, old);
    if (light && same)
      this.redraw();
    else
      this.resize();
    if (!light) this.announce();
  }
  /** Whether listing and columns are the same, so that all keep their room. */
  sameSlots(a, b) {
    const names = ({columns = []}) => columns.map(({id, widest}) => `${id} ${widest.length}`).join();
    return a.listing?.length === b.listing?.length && a.source_file === b.source_file && a.method === b.method &&
        a.listing?.[0]?.[0] === b.listing?.[0]?.[0] && names(a) === names(b);
  }
  /** The last step up to this number. */
  nearest(number) {
    const {byNumber, steps} = this.run, found = byNumber.get(number);
    if (found !== undefined) return found;
    const [whole, fine = 0] = number.split('.').map(Number);
    const order = ({number: other}) => other.split('.').map(Number);
    return Math.max(upperBound(steps, 0, (step) => {
      const [a, b = 0] = order(step);
      return a - whole || b - fine;
    }) - 1, 0);
  }
  /** Loop and bookmarks, where their steps are still there. */
  keepPlaces(before, {loop, bookmarks}) {
    const index = (i) => this.run.byNumber.get(before.steps[i]?.number);
    const first = index(loop.first), last = index(loop.last);
    this.setLoop(loop.on && first < last ? {first, last, on: true} : {on: false});
    this.setBookmarks(bookmarks.map(index).filter((i) => i !== undefined));
  }

  /** Whether there is a step of this number ("7", "7.2"); if so, goes there. */
  goTo(number) {
    const index = this.run.byNumber.get(String(number).trim());
    if (index === undefined) return false;
    this.show(index);
    return true;
  }
  next() { this.advance(this.run.nextMilestone(this.index)); }
  previous() { this.show(this.run.previousMilestone(this.index)); }
  nextEvent() { this.advance(Math.min(this.index + 1, this.run.steps.length - 1)); }
  previousEvent() { this.show(this.index - 1); }
  first() { this.show(0); }
  last() { this.show(this.run.steps.length - 1); }
  /** Forwards to a step, unless `this.asks(from, to)` has a question on the way, which stops it. */
  advance(index) {
    if (!this.asks?.(this.index, index)) this.show(index);
  }
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
    const next = this.index === end ? begin : clamp(this.following(first, last), first, last);
    if (next > this.index && this.asks?.(this.index, next)) return this.pause();
    this.show(next);
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
    if (window.player === this && !this.silent) noteAddress(this);
    this.onChange?.();
  }

  setTheme(name) {
    const {themes} = GradusPlayer;
    this.useTheme(themes.find((theme) => theme.name === name) ?? themes[0]);
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

  show(index) {
    if (!this.run) return;
    this.index = clamp(index, 0, this.run.steps.length - 1);
    this.onShow?.(this.index);
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
  redraw(moving = false) {
    super.redraw(moving);
    this.redrawControls(this.run.steps[this.index]);
  }
  redrawControls(step) {
    const {parts, index} = this;
    parts.slider.value = index;
    parts.slider.setAttribute('aria-valuetext', parts.position.textContent);
    if (document.activeElement !== parts.wanted) parts.wanted.value = step.number;
    for (const [does, off] of [
             ['first', index === 0], ['previous', index === 0], ['next', this.atEnd], ['last', this.atEnd]]) {
      this.root.querySelector(`[data-do="${does}"]`).setAttribute('aria-disabled', off);
    }
    this.redrawBookmark();
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
      copy_command: () => this.copy({'text/plain': this.commandNow()}, 'copied_command'),
      copy_table: () => this.copy(this.tableSoFar(), 'copied_table'),
      copy_svg: () => this.copy({'text/plain': drawingSvg(this)}, 'copied_drawing'),
      copy_png: () => this.copyPicture(),
      copy_json: async () => this.copy({'text/plain': await this.stepJson()}, 'copied_step'),
      save_svg: () => save(drawingSvg(this), 'image/svg+xml', this.fileName('svg')),
      save_png: async () => save(await drawingPng(this), 'image/png', this.fileName('png')),
      save_csv: () => save(this.tableSoFar()['text/csv'], 'text/csv', this.fileName('csv')),
      save_json: async () => save(await this.stepJson(), 'application/json', this.fileName('json')),
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
    parts['command-text'].textContent = this.commandNow();
    parts.copying.showModal();
  }
  /** What makes what is seen: where `commandFor` knows how, this very step. */
  commandNow() { return this.commandFor?.(this.run.steps[this.index].number) ?? this.command; }
  /** The address of this step, with all that the page keeps in it. */
  link() { return location.href.split('#')[0] + addressOf(this); }
  tableSoFar() {
    const {run, index} = this, rows = [...Array(run.table.count(index)).keys()];
    return tableForms(run.trace.columns, rows.map((row) => run.table.cells(row, index)));
  }
  /** "bresenham_line_step_4.svg" */
  fileName(ending) { return `${this.run.trace.topic}_step_${this.run.steps[this.index].number}.${ending}`; }
  /** This step as data: a promise of a text. */
  async stepJson() {
    const {topic, method, arguments: given} = this.run.trace, step = this.run.steps[this.index];
    return `${JSON.stringify({topic, method, input: Object.fromEntries(given), step}, null, 2)}\n`;
  }
  async copyPicture() {
    try {
      await navigator.clipboard.write([new ClipboardItem({'image/png': drawingPng(this)})]);
      this.notice(say('copied_drawing'));
    } catch {
      this.notice(say('no_picture_copy'));
    }
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
