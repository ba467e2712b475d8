'use strict';
// The playing of a recorded run: its steps, their speed, the loop and the bookmarks. What is seen of it is its view's, what
// is done to it its controls'; needs all scripts that come before.

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16, 32];  // steps a second
const PLAIN_SPEED = SPEEDS.indexOf(1);
const FAST = 4;  // times as fast, backwards
const all = [];

class Playing extends PlayerView {
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

  /** Whether there is a step of this number ("7", "7.2"); if so, goes there. `this.elsewhere(number)` may know of one that is not here. */
  goTo(number) {
    const index = this.run.byNumber.get(String(number).trim());
    if (index === undefined) return this.elsewhere?.(String(number).trim()) ?? false;
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
  /** For readers by ear: once per step, and not while steps fly past. */
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
}
