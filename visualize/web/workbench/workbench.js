'use strict';
// The inputs round a player: what is typed, dragged, painted or dropped is answered by the module, and shown.

const LONGEST_ADDRESS = 24_000;  // letters as they are escaped; what is longer is saved as a file
const LONG = 1_000_000;  // letters of an answer: between reading and showing it the page takes a breath
const PART = 4000;  // steps of a run that are here at a time, as of a page that plays one

class Workbench {
  /** data: {topics, notations, recorded}. asker: what answers. */
  constructor(root, player, asker, data) {
    Object.assign(this, {root, player, asker, topics: data.topics, notations: data.notations, recorded: data.recorded});
    this.parts = {};
    for (const node of root.querySelectorAll('[data-bench]')) this.parts[node.dataset.bench] = node;
    this.form = new Form(this.parts.fields, this);
    this.handles = new HandleLayer(player, this);
    this.painter = new Painter(player, {
      maze: () => this.maze(),
      change: (rows) => this.change({maze: rows}),
      commit: () => this.commit(),
    });
    this.predictor = new Predictor(player, {predicted: (record) => this.predicted(record)});
    const place = player.onDrawn;
    player.onDrawn = () => {
      place();
      this.painter.place();
    };
    player.elsewhere = (number) => this.goToPart(number);
    player.sayRecorded = (values) => (this.state.beside ? undefined : say('some_steps', values));
    player.putAddress = (put, parts) => this.putAddress(put, parts);
    player.commandFor = (step) => commandOf(this.asked, this.topic, {step});
    player.stepJson = () => this.asker.ask({...requestOf(this.asked, this.topic, 'run'), step: player.run.steps[player.index].number});
    // The strip wears the player's colours
    player.onTheme = () => document.documentElement.style.cssText = player.root.style.cssText;
    player.onTheme();
    this.fillChoices();
    this.bind();
  }

  // -- What there is to choose

  get topic() { return this.topics.find(({name}) => name === this.state.topic); }
  get method() { return this.topic.methods.find(({name}) => name === this.state.method); }
  /** Those that the method takes notice of. */
  get parameters() { return parametersOf(this.topic, this.state.method); }
  textOf(parameter, given = this.state.given) {
    const {name, default: usual} = parameter;
    if (name in given) return given[name];
    return this.inItsPlace(parameter).some((other) => other.name in given) ? '' : usual;
  }
  /** Parameters that stand in another's place, and are never given with it. */
  inItsPlace({name, instead_of: other}) {
    return this.topic.parameters.filter((p) => p.instead_of === name || (other && p.name === other));
  }
  parameter(name) { return this.topic.parameters.find((parameter) => parameter.name === name); }
  maze() {
    const maze = this.parameters.find(({type}) => type === 'maze'), text = maze ? this.textOf(maze) : '';
    return text.includes('/') && !text.startsWith('@') ? text : '';
  }
  /** The same, but what is not given as the run has it that is seen: it may follow from other inputs, or come with its method. */
  textSeen(parameter) {
    const {name} = parameter, isGiven = name in this.state.given || (this.asked && name in this.asked.given);
    const seen = isGiven ? undefined : this.player.run?.trace.arguments.find(([known]) => known === name);
    return seen?.[1] ?? this.textOf(parameter);
  }
  /** What is given for it and in its place: change() of that brings it back. */
  givenFor(parameter) {
    const {given} = this.state, others = this.inItsPlace(parameter).filter(({name}) => name in given);
    return Object.fromEntries([[parameter.name, given[parameter.name] ?? ''], ...others.map(({name}) => [name, given[name]])]);
  }
  numbers() { return numbersOfInput(this.parameters, (parameter) => this.textSeen(parameter)); }

  fillChoices() {
    const {topic, language, notation} = this.parts, chapters = new Map();
    for (const {name, title, chapter} of this.topics) {
      if (!chapters.has(chapter)) chapters.set(chapter, html('optgroup', {label: heading(chapter)}));
      chapters.get(chapter).append(html('option', {value: name}, title));
    }
    topic.replaceChildren(...chapters.values());
    language.value = document.documentElement.lang;
    notation.replaceChildren(
        html('option', {value: ''}, say('notation_own')), ...this.notations.map((name) => html('option', {value: name}, name)));
  }
  showState() {
    const {parts, state} = this, {methods} = this.topic;
    parts.topic.value = state.topic;
    parts.method.replaceChildren(...methods.map(({name, title, standing}) => html(
        'option', {value: name}, `${standing === 'faulty' ? '\u26a0\ufe0e ' : ''}${title}`)));
    parts.method.value = state.method;
    parts.method.title = this.method?.note ?? '';
    const others = methods.filter(({name}) => name !== state.method);
    parts.beside.replaceChildren(
        html('option', {value: ''}, say('nothing')), ...others.map(({name, title}) => html('option', {value: name}, title)));
    parts.beside.value = state.beside;
    parts.beside.parentElement.hidden = others.length === 0;
    parts.numbers.value = state.numbers;
    parts.notation.value = state.notation;
    parts.predict.setAttribute('aria-pressed', state.predict !== null);
    parts.predict.hidden = state.beside !== '';
    this.form.show(state.topic, this.parameters);
    this.form.fill((parameter) => this.textOf(parameter));
    this.showHistory();
  }
  showHistory() {
    this.parts.undo.setAttribute('aria-disabled', !this.history?.canUndo);
    this.parts.redo.setAttribute('aria-disabled', !this.history?.canRedo);
  }

  // -- Changing

  /** Begins with a state, or goes to one from elsewhere: the address, a file, the history. */
  async open(state) {
    this.state = state;
    this.part = undefined;
    if (state.beside === state.method) state.beside = '';
    this.history ??= new History(state);
    this.showState();
    await this.refresh(false);
  }
  /** texts: {name: text} that are written, dragged or painted just now. */
  change(texts) {
    const {given} = this.state;
    for (const [name, text] of Object.entries(texts)) {
      const parameter = this.parameter(name);
      for (const other of this.inItsPlace(parameter)) delete given[other.name];
      if (text === '' || text === parameter.default)
        delete given[name];
      else
        given[name] = text;
    }
    this.form.fill((parameter) => this.textOf(parameter));
    return this.refresh(true);
  }
  changed(name, text) { return this.change({[name]: text}); }
  get dragging() { return this.handles.dragging || Boolean(this.painter.paint); }
  /** What has been changed stays: it can be taken back in one. */
  commit() {
    this.history.note(this.state);
    this.showHistory();
    this.forgetAnswers();
    return this.refresh(false);
  }
  committed() {
    this.form.fill((parameter) => this.textOf(parameter));
    return this.commit();
  }
  /** Another run has other questions. */
  forgetAnswers() {
    if (this.state.predict !== null) this.state.predict = '';
  }
  choose(changes) {
    Object.assign(this.state, changes);
    if ('topic' in changes) Object.assign(this.state, {method: this.topic.default_method, given: {}, beside: ''});
    if (this.state.beside === this.state.method) this.state.beside = '';
    this.forgetAnswers();
    this.history.note(this.state);
    return this.open(this.state);
  }
  undo(by = -1) {
    const state = this.history.go(by);
    if (!state) return this.player.notice(say('nothing_to_undo'));
    const before = this.state;
    const what = Object.keys({...before.given, ...state.given}).filter((name) => before.given[name] !== state.given[name]);
    this.open(state).then(() => this.player.notice(say(by < 0 ? 'undone' : 'redone', {what: what.join(', ') || this.topic.title})));
  }

  // -- Asking and showing

  /** Asks for what the state is now; of several changes in a row only the last one is answered. */
  async refresh(light) {
    this.wanted = {light: light && (this.wanted?.light ?? true)};
    if (this.asking) return this.asking;
    this.asking = this.askAll();
    try {
      await this.asking;
    } finally {
      this.asking = undefined;
    }
  }
  async askAll() {
    while (this.wanted) {
      const {light} = this.wanted;
      this.wanted = undefined;
      await this.ask(JSON.parse(JSON.stringify(this.state)), light);
    }
  }
  async ask(state, light) {
    const working = setTimeout(() => this.root.classList.add('working'), 400);
    try {
      const answer = await this.answerTo(this.requestFor(state));
      this.asked = state;
      this.show(state.beside ? answer : {trace: answer}, light);
      this.refuse('');
    } catch (error) {
      if (!(error instanceof Unanswered)) throw error;
      if (this.part && error.refused) {  // perhaps this run is shorter: from its start
        this.part = undefined;
        return this.ask(state, light);
      }
      if (!this.player.run) await this.showUsual(error.refused);
      this.refuse(error.message, error.parameter);
      if (!light) this.player.resize();  // what was dragged is let go, where nothing came of it
    } finally {
      clearTimeout(working);
      this.root.classList.remove('working');
    }
  }
  requestFor(state) {
    const request = requestOf(state, this.topic);
    if (state.beside)
      request.beside = state.beside;
    else if (this.part)
      request.steps = this.part;
    return request;
  }
  /** Whether the run has a step of this number that is not here; then that part of it is asked for. */
  goToPart(number) {
    const {run} = this.player, whole = Math.floor(Number(number)), first = Math.floor(whole / PART) * PART;
    const isOther = /^\d+(\.\d+)?$/.test(number) && whole <= run.trace.last && !run.byNumber.has(String(whole));
    if (!isOther || this.state.beside) return false;
    this.part = `${first}-${Math.min(first + PART - 1, run.trace.last)}`;
    this.refresh(false).then(() => {
      const {player} = this;
      if (player.run.byNumber.has(number)) player.goTo(number);
      else player.notice(player.noStep(number));
    });
    return true;
  }
  /** The last answer serves again: what was dragged is asked for once more when it is let go. */
  async answerTo(request) {
    const key = JSON.stringify(request);
    if (this.last?.key !== key) {
      const text = await this.asker.ask(request), answer = JSON.parse(text);
      if (text.length > LONG) await new Promise((goOn) => setTimeout(goOn));
      this.last = {key, answer};
    }
    return this.last.answer;
  }
  /** What can be seen when the first input there is can't: the usual one's run, recorded where nothing answers. */
  async showUsual(answers) {
    const usual = {...this.state, given: {}, method: this.topic.default_method, beside: '', numbers: '', notation: ''};
    if (!answers) return this.showRecorded(true);
    this.asked = usual;
    this.show({trace: JSON.parse(await this.asker.ask(requestOf(usual, this.topic)))}, false);
  }
  show({trace, beside, alignment}, light) {
    const {player} = this, first = !player.run, same = player.run?.trace.topic === trace.topic;
    if (!beside) this.endComparing();
    this.predictor.close();  // what was asked was about another run
    player.silent = true;
    if (same)
      player.update(trace, {command: 'gradus', light});
    else
      player.load(trace, {command: 'gradus'});
    player.silent = false;
    if (first) followAddress(player);
    if (beside) this.compare(beside, alignment, light);
    if (!light) this.predictAnew();
    if (!light) player.changed();
    this.count = (this.count ?? 0) + 1;
  }
  compare(trace, alignment, light) {
    this.together ??= new Together(this.player);
    const command = commandOf({...this.asked, method: this.asked.beside, beside: ''}, this.topic, {});
    this.together.load({trace, command, alignment}, light);
    if (!light) this.together.markParting();
  }
  endComparing() {
    this.together?.end();
    this.together = undefined;
  }
  /** Without the module, or before it is there: the usual input's run; `foreign`: rather in English than not at all. */
  showRecorded(foreign = false) {
    const trace = (this.recorded[document.documentElement.lang] ?? (foreign ? this.recorded.en : undefined))?.[this.state.topic];
    if (!trace) return;
    this.asked = {...this.state, given: {}, method: this.topic.default_method, beside: ''};
    this.show({trace}, false);
  }
  /** The line of a refusal, below the fields; '': all is well. */
  refuse(line, parameter = '') {
    this.parts.refusal.textContent = line;
    this.parts.refusal.hidden = line === '';
    this.form.blame(parameter, line);
  }

  // -- Predicting

  predictAnew() {
    const {predict} = this.state;
    if (predict === null || this.state.beside) return this.predictor.end();
    this.predictor.begin(predict);
    this.state.predict = this.predictor.record;
  }
  togglePredict() {
    this.state.predict = this.state.predict === null ? '' : null;
    this.parts.predict.setAttribute('aria-pressed', this.state.predict !== null);
    if (this.state.predict !== null) this.player.first();
    this.predictAnew();
    this.player.changed();
  }
  predicted(record) {
    this.state.predict = record;
    this.player.changed();
  }

  // -- The address, files

  putAddress(put, parts) {
    const {state} = this, long = encodeURIComponent(JSON.stringify(state.given)).length > LONGEST_ADDRESS;
    putState(long ? {...state, given: {}} : state, put, parts, this.topic);
  }
  async opened(name, files) {
    // A model is read with what lies beside it
    const inOrder = [...files].sort((a, b) => isLibrary(b) - isLibrary(a));
    for (const file of inOrder) await this.take(await readFile(file), name);
  }
  /** A file that was dropped or opened: for an argument, or a saved input. */
  async take(file, name) {
    const saved = name === undefined && /\.json$/i.test(file.name) && savedState(file.bytes);
    if (saved) return this.openSaved(saved);
    const parameter = name === undefined ? parameterFor(file, this.parameters) : this.parameter(name);
    if (!parameter && !isLibrary(file)) return this.player.notice(say('no_use', {name: file.name}));
    await this.asker.keep(file);
    this.last = undefined;  // another file may have had this name
    if (isLibrary(file)) return this.refresh(false);  // the model may be there already
    this.change({[parameter.name]: parameter.type === 'maze' || parameter.type === 'faces' ? `@${file.name}` : file.name});
    await this.committed();
    await this.remark(file.name);
  }
  /** What is said of a file that was read. */
  async remark(name) {
    try {
      const remarks = JSON.parse(await this.asker.ask(requestOf(this.state, this.topic, 'remarks')));
      this.player.notice([say('opened', {name}), ...remarks].join('; '));
    } catch (error) {
      if (!(error instanceof Unanswered)) throw error;
    }
  }
  saveState() {
    const parts = new Map();
    const put = (name, value) => value && parts.set(name, value);
    putState(this.state, put, parts, this.topic);
    put('step', this.player.run.steps[this.player.index].number);
    const files = this.asker.files.filter(({name}) => Object.values(this.state.given).some((text) => text.replace(/^@/, '') === name) || isLibrary({name}))
                      .map(({name, bytes}) => ({name, bytes: base64Of(bytes)}));
    save(`${JSON.stringify({gradus: 1, address: addressText(parts), files}, null, 1)}\n`, 'application/json', `${this.state.topic}_input.json`);
  }
  async openSaved({address, files}) {
    for (const {name, bytes} of files ?? []) {
      const file = new File([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], name);
      await this.asker.keep(await readFile(file));
    }
    const parts = addressParts(address);
    await this.open(stateOf(parts, this.topics, document.documentElement.lang));
    this.history.note(this.state);
    if (parts.get('step')) this.player.goTo(parts.get('step'));
  }

  // -- What is done

  bind() {
    const {parts, root} = this;
    parts.topic.addEventListener('change', () => this.choose({topic: parts.topic.value}));
    parts.method.addEventListener('change', () => this.choose({method: parts.method.value}));
    parts.beside.addEventListener('change', () => this.choose({beside: parts.beside.value}));
    for (const name of ['numbers', 'notation'])
      parts[name].addEventListener('change', () => this.choose({[name]: parts[name].value}));
    parts.language.addEventListener('change', () => this.reopen(parts.language.value));
    parts.fields.addEventListener('submit', (event) => event.preventDefault());
    parts.chooser.addEventListener('change', () => {
      this.opened(undefined, [...parts.chooser.files]);
      parts.chooser.value = '';
      parts.dialog.close();
    });
    root.addEventListener('click', (event) => {
      const does = event.target.closest('[data-act]');
      if (does) this.does(does.dataset.act);
    });
    addEventListener('keydown', (event) => this.key(event), true);
    for (const kind of ['dragover', 'drop'])
      addEventListener(kind, (event) => {
        if (!event.dataTransfer?.types.includes('Files')) return;
        event.preventDefault();
        document.body.classList.toggle('dropping', kind === 'dragover');
        if (kind === 'drop') this.opened(undefined, [...event.dataTransfer.files]);
      });
    addEventListener('dragleave', () => document.body.classList.remove('dropping'));
  }
  does(what) {
    const {parts} = this;
    const others = {
      undo: () => this.undo(),
      redo: () => this.undo(1),
      reset: () => this.choose({given: {}}),
      predict: () => this.togglePredict(),
      more: () => parts.dialog.showModal(),
      save: () => this.saveState(),
      open: () => parts.chooser.click(),
      stop: () => this.asker.end(say('stopped')),
    };
    others[what]?.();
  }
  /** The page's texts are in its language: it begins anew. */
  reopen(language) {
    this.state.language = language;
    const parts = addressParts();
    parts.set('language', language);
    location.hash = addressText(parts);
    location.reload();
  }
  key(event) {
    if (isTyping(event.target) || this.root.querySelector('dialog[open]')) return;
    const control = event.ctrlKey || event.metaKey, name = event.key.toLowerCase();
    const taken = control ? this.controlKey(name, event.shiftKey) : this.plainKey(event, name);
    if (!taken) return;
    event.preventDefault();
    event.stopPropagation();
  }
  controlKey(name, shift) {
    if (name === 'z') return this.undo(shift ? 1 : -1), true;
    if (name === 'y') return this.undo(1), true;
    return false;
  }
  plainKey(event, name) {
    if (event.altKey) return false;
    if (this.predictor.key(event)) return true;
    if (name !== 'p' || this.state.beside) return false;
    this.togglePredict();
    return true;
  }
}

/** Those parameters of a topic that a method takes notice of. */
function parametersOf(topic, methodName) {
  const ignores = topic.methods.find(({name}) => name === methodName)?.ignores ?? [];
  return topic.parameters.filter(({name}) => !ignores.includes(name));
}
/** "scan_conversion": "Scan conversion" */
const heading = (chapter) => chapter.charAt(0).toUpperCase() + chapter.slice(1).replaceAll('_', ' ');
