'use strict';
// What is seen of a step: the drawing, the listing, the table, the sentence and the legend, and how they share the
// room. Nothing here moves on by itself.

const MOST_COLUMNS = 36;  // characters of a line of the listing, as figures have it at their widest

class PlayerView {
  constructor(root, prefix) {
    this.root = root;
    root.classList.add('gradus');
    root.replaceChildren(document.getElementById('gradus-player').content.cloneNode(true));
    this.parts = {};
    for (const node of root.querySelectorAll('[data-part]')) this.parts[node.dataset.part] = node;
    this.stage = root.querySelector('.stage');
    this.drawing = new Drawing(this.parts.drawing, prefix);
    this.parts.said.id = `${prefix}-sentence`;
    this.scrub = new ScrubBar(this.parts);
  }

  useTheme(theme) {
    this.theme = theme;
    for (const [tone, color] of Object.entries(this.theme.tones))
      this.root.style.setProperty(`--${tone}`, color);
    this.theme.quantities.forEach((color, number) => this.root.style.setProperty(`--quantity-${number}`, color));
    this.root.classList.toggle('underlined', this.theme.underlined);
    this.root.style.setProperty('--measure-text', this.look('measure').text);
    this.root.style.setProperty('--measure-mark', this.look('measure').mark);
    this.root.style.colorScheme = this.theme.name === 'dark' ? 'dark' : 'light';
    this.root.dataset.theme = this.theme.name;
    this.parts.theme.textContent = say(`theme_${this.theme.name}`);
    this.onTheme?.();
    if (!this.run) return;
    this.showPhases();
    this.redraw();
  }
  look(role) { return this.theme.roles.find((look) => look.role === role); }

  said(step) { return (this.statesGoal(step) ? `${this.run.trace.goal} ` : '') + (step.sentence ?? ''); }

  /** All that stays through the steps of a trace. `light`: listing and columns are those that are there. */
  showTrace(light = false) {
    const {parts, run} = this, {trace} = run;
    parts.title.textContent = trace.title || document.title;
    parts.subtitle.textContent = parts.subtitle.title = trace.subtitle;
    parts.method.textContent = run.shows('title') ? trace.method_title || trace.method : '';
    parts.faulty.textContent = trace.faulty ? `\u26a0\ufe0e ${say('faulty', {what: trace.faulty})}` : '';
    parts.faulty.hidden = !trace.faulty;
    this.root.setAttribute('aria-label', this.name);
    this.showSlots();
    if (light) {
      this.excerpts &&= Object.assign(this.excerpts, {run});
    } else {
      this.showListing();
      this.showColumns();
      this.longest = this.columns = undefined;
    }
    parts.slider.max = run.steps.length - 1;
    parts.total.textContent = `/ ${trace.last}`;
    parts.total.title = this.recorded();
    this.notice(this.recorded());
    parts.goal.replaceChildren(...this.letters.sentence(trace.goal));
    parts.command.hidden = !this.command;
    parts['command-text'].textContent = this.command;
    parts['table-copy'].hidden = parts.table.hidden;
    parts['drawing-copy'].hidden = parts.drawing.hidden;
    parts['step-copy'].hidden = !run.shows('table');
    const phases = [...new Set(run.phases().map((phase) => phase.name))].slice(0, 100);
    const number = run.steps[run.lastMilestone].number;
    const longest = Math.max(...phases.map((phase) => textWidth(this.positionOf({number, phase}), 1)));
    this.root.style.setProperty('--position-width', `${Math.min(longest, 30)}em`);
    this.scrub.load(run);
    if (light) this.showPhases();
  }
  get name() { return `${this.run.trace.title} ${this.run.trace.subtitle}`.trim(); }
  /** What is said of a recording that is not the whole run. */
  recorded() {
    const {run} = this, {trace} = run, first = run.steps[0].number;
    if (first === '0' && run.milestones.length === trace.last + 1) return '';
    const values = {first, last: run.steps[run.lastMilestone].number, end: trace.last};
    return this.sayRecorded?.(values) ?? say('recorded', values);
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
    const digits = String(trace.listing.length).length, changes = trace.listing.some(([, , sign]) => sign);
    this.parts.listing.style.setProperty('--digits', digits);
    this.parts.listing.classList.toggle('changes', changes);
    this.parts.lines.replaceChildren(...trace.listing.map(([, text, sign], position) => {
      if (isHeading(text))
        return html('li', {'data-position': position, 'data-heading': true}, html('span', {}), html('code', {}, text));
      const label = this.run.labelOf(position);
      const number = html(
          'button',
          {type: 'button', tabindex: -1, 'aria-label': label ? say('line', {number: label}) : say('struck')}, label);
      const role = sign === '-' ? 'deletion' : sign === '+' && 'insertion';
      return html(
          'li', {'data-position': position, 'data-change': sign || false}, number,
          html('code', {role}, ...this.letters.html(text, true)));
    }));
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
  }
  redrawDrawing(moving) {
    const {svg} = this.drawing, {parts} = this;
    this.drawing.draw(this.index, this.theme, this.unit / TEXT, moving);
    svg.setAttribute('aria-label', say('drawing', {title: this.name}));
    if (!parts.said.hidden) svg.setAttribute('aria-describedby', parts.said.id);
    this.onDrawn?.();
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
    const together = root.parentElement?.classList.contains('together');
    const narrow = width < (together || root.classList.contains('embedded') ? 560 : 700);
    root.dataset.layout = narrow ? 'narrow' : 'wide';
    this.unit = narrow ? 15 : clamp(Math.min(root.clientHeight / 36, width / (together ? 40 : 64)), 12, 80);
    this.line = (narrow ? 1.6 : 1.5) * this.unit;  // a finger needs 24 px
    root.style.setProperty('--u', `${this.unit}px`);
    root.style.setProperty('--line', `${this.line}px`);
    if (!this.run) return;
    const {held} = this.drawing;  // then nothing round it may push it
    this.shareWidth(narrow, held);
    if (!held) {
      this.reserveSentence();
      this.reserveFooter();
    }
    this.shareSide(narrow);
    const drawn = narrow && !this.parts.drawing.hidden;
    if (!held) this.parts.drawing.style.height = drawn ? `${this.heightOfDrawing()}px` : '';
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
  shareWidth(narrow, held) {
    const {parts, run, unit, root} = this, letter = textWidth('0', narrow ? Math.max(unit, 11) : unit, '', MONO);
    const signs = parts.listing.classList.contains('changes') ? 1.6 : 0;
    const gutter = (String(run.lines.length).length + signs) * letter + 2.1 * unit;
    const asked = run.lines.length ? Math.min(this.longestLine, MOST_COLUMNS) * letter + gutter + 4 : 0;
    const wanted = Math.max(asked, parts.table.hidden ? 0 : this.tableWidth * unit);
    if (!held) root.style.setProperty('--side', `${clamp(wanted / unit, 16, 30.2)}`);
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
}
