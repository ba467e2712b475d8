'use strict';
// What the reader has chosen: plain data, in the address, in the history and in saved files.

const IN = 'in.';  // before the names of arguments in the address: a topic may have one called step, too
const WORDS = ['language', 'numbers', 'notation'];

/** {topic, method, given: {name: text}, language, numbers, notation, beside, predict} from the parts of an address. */
function stateOf(parts, topics, language) {
  const text = (name) => parts.get(name) ?? '';
  const topic = topicOf(parts, topics);
  const given = {};
  for (const {name} of topic.parameters)
    if (parts.has(IN + name)) given[name] = parts.get(IN + name);
  return {
    topic: topic.name,
    method: hasMethod(topic, text('method')) ? text('method') : topic.default_method,
    given,
    language,
    numbers: text('numbers'),
    notation: text('notation'),
    beside: hasMethod(topic, text('beside')) ? text('beside') : '',
    predict: parts.has('predict') ? text('predict') : null,
  };
}

const topicOf = (parts, topics) => topics.find(({name}) => name === parts.get('topic')) ?? topics[0];
const hasMethod = ({methods}, wanted) => methods.some(({name}) => name === wanted);

/** What an address names that is not in this page: "topic=lines, in.form=3"; '' for nothing. */
function unknownIn(parts, topics, languages) {
  const topic = topicOf(parts, topics), isMethod = (name) => hasMethod(topic, name);
  const known = {topic: (name) => name === topic.name, method: isMethod, beside: isMethod, language: (code) => languages.includes(code)};
  const is = (name, value) => (name.startsWith(IN) ? topic.parameters.some((p) => IN + p.name === name) : known[name]?.(value) ?? true);
  const unknown = [...parts].filter(([name, value]) => value !== '' && (Object.hasOwn(known, name) || name.startsWith(IN)) && !is(name, value));
  const told = unknown.slice(0, 3).map(([name, value]) => quotable(`${name}=${value}`));
  return [...told, ...(unknown.length > told.length ? ['…'] : [])].join(', ');
}

/** Puts a state into the parts of an address, by `put(name, value)`, and takes out what it has not. */
function putState(state, put, parts, topic) {
  for (const name of [...parts.keys()])
    if (name.startsWith(IN) && !(name.slice(IN.length) in state.given)) parts.delete(name);
  put('topic', state.topic);
  put('method', state.method !== topic.default_method && state.method);
  for (const [name, value] of Object.entries(state.given)) put(IN + name, value);
  for (const name of WORDS) put(name, state[name]);
  put('beside', state.beside);
  if (state.predict === null)
    parts.delete('predict');
  else
    parts.set('predict', state.predict);
}

/** Of what is given, in the order of the parameters, what the method takes. */
function argumentsFor(topic, method, given) {
  return Object.fromEntries(parametersOf(topic, method).filter(({name}) => name in given).map(({name}) => [name, given[name]]));
}

/** What is asked of the module for a state. */
function requestOf({method, given, language, numbers, notation}, topic, want = 'trace') {
  const request = {want, topic: topic.name, arguments: {method, ...argumentsFor(topic, method, given)}, language};
  if (numbers) request.numbers = numbers;
  if (notation) request.notation = notation;
  return request;
}

/** A word as a shell takes it. */
const shellWord = (text) => (/^[\w.,:/+=@%-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

/** The line that makes this very figure. */
function commandOf(state, topic, {step, ending = 'svg'}) {
  const words = ['gradus', 'figure', state.topic];
  const flag = (name, value) => words.push(`--${name.replaceAll('_', '-')}=${shellWord(value)}`);
  if (state.method !== topic.default_method) flag('method', state.method);
  for (const [name, value] of Object.entries(argumentsFor(topic, state.method, state.given))) {
    if (topic.parameters.find((parameter) => parameter.name === name)?.type === 'flag')
      words.push(`--${name.replaceAll('_', '-')}`);
    else
      flag(name, value);
  }
  if (state.language !== 'en') flag('language', state.language);
  if (state.numbers) flag('numbers', state.numbers);
  if (state.notation) flag('notation', state.notation);
  if (state.beside) flag('compare', state.beside);
  if (step !== undefined) flag('step', step);
  return [...words, '-o', `${state.topic}${step === undefined ? '' : `_step_${step}`}.${ending}`].join(' ');
}

/** States to go back to, and forth again. */
class History {
  constructor(state) {
    this.states = [JSON.stringify(state)];
    this.at = 0;
  }
  /** Notes what is now the state, unless it is what it was. */
  note(state) {
    const text = JSON.stringify(state);
    if (text === this.states[this.at]) return;
    this.states = [...this.states.slice(0, this.at + 1), text].slice(-200);
    this.at = this.states.length - 1;
  }
  get canUndo() { return this.at > 0; }
  get canRedo() { return this.at + 1 < this.states.length; }
  /** The state before, or after; nothing where there is none. */
  go(by) {
    if (this.at + by < 0 || this.at + by >= this.states.length) return undefined;
    this.at += by;
    return JSON.parse(this.states[this.at]);
  }
}
