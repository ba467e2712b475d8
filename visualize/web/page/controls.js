'use strict';
// The player. `new GradusPlayer(root).load(trace)` shows a trace of schema 1 (see trace_json) in any element; every picture
// is drawn from the trace's marks at the moment it is looked at. Here is what is done to it: by its buttons, in its
// drawing and its table, and by keys.

class GradusPlayer extends Playing {
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
    return say('no_step', {number: quotable(number), first: steps[0].number, last: steps[steps.length - 1].number});
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
