'use strict';
// The reader says what comes next before it is shown: the questions are the decisions of the run's own steps, and the next
// row's numbers where a run decides nothing.

/** A cell's number, with any signs round it: "≈ 4.345", "−2/3", "4,5"; nothing for a cell without one. */
function numberOf(text) {
  const plain = text.replace('−', '-').replace(',', '.').replace('≈', '').trim();
  if (!/^-?(\d+\.?\d*|\.\d+)(\/\d+)?$/.test(plain)) return undefined;
  const [numerator, denominator = 1] = plain.split('/').map(Number);
  return numerator / denominator;
}
/** Whether a number is the one of a cell, as far as the cell tells it. */
function saysTheSame(given, cell) {
  const [said, right] = [numberOf(given), numberOf(cell)], decimals = /[.,](\d+)$/.exec(cell)?.[1].length ?? 0;
  return said !== undefined && Math.abs(said - right) <= 0.5001 * 10 ** -decimals * (cell.includes('/') ? 0.01 : decimals > 0 ? 1 : 1e-6);
}

/** The questions of a run, by the index of the step that answers: {text, answers, answer} or {text, value}. */
function questionsOf({steps, trace}) {
  const questions = new Map();
  steps.forEach(({number, decision}, i) => {
    if (!decision) return;
    questions.set(i, {text: say('question', {number, question: decision.question}), answers: decision.answers, answer: decision.answer});
  });
  if (questions.size > 0) return questions;
  steps.forEach(({number, row}, i) => {
    const asked = i === 0 || !row ? [] : trace.columns.flatMap(({name}, c) => (c > 0 && numberOf(row[c] ?? '') !== undefined ? [[name, row[c]]] : []));
    if (asked.length === 0) return;
    const [name, value] = asked[i % asked.length];
    questions.set(i, {text: say('question_number', {number, name}), value});
  });
  return questions;
}

class Predictor {
  /** host: {predicted(text)}, told what has been answered, as the address has it: "4y7n". */
  constructor(player, host) {
    this.player = player;
    this.host = host;
    this.answers = new Map();
    // Who goes elsewhere leaves the question
    player.onShow = (index) => {
      if (this.asked !== undefined && index !== this.asked - 1) this.close();
    };
    player.parts.answers.addEventListener('click', (event) => {
      const button = event.target.closest('button');
      if (!button) return;
      event.stopPropagation();
      this.answer(button.dataset.answer === undefined ? null : Number(button.dataset.answer));
    });
  }
  /** From now on it asks; `record` is what was answered before, and may be anybody's: what was no question here counts for nothing. */
  begin(record = '') {
    this.questions = questionsOf(this.player.run);
    const {byNumber, trace} = this.player.run, mayBeElsewhere = this.player.recorded() !== '';
    const isAsked = (number) => (byNumber.has(number) ? this.questions.has(byNumber.get(number)) : mayBeElsewhere && Number(number) <= trace.last);
    const said = [...record.matchAll(/(?<![\d.])(\d{1,15}(?:\.\d{1,9})?)([yn])/g)].filter(([, number]) => isAsked(number));
    this.answers = new Map(said.map(([, number, right]) => [number, right === 'y']));
    this.player.asks = (from, to) => this.asks(from, to);
    if (this.questions.size === 0) return this.player.notice(say('no_question'));
    this.show();
  }
  end() {
    this.player.asks = undefined;
    this.close();
  }
  get on() { return this.player.asks !== undefined; }
  get record() { return [...this.answers].map(([number, right]) => `${number}${right ? 'y' : 'n'}`).join(''); }
  get right() { return [...this.answers.values()].filter(Boolean).length; }
  get score() { return say('score', {right: this.right, asked: this.answers.size}); }

  /** Whether there is a question on the way; then it stands on the step before, and asks. */
  asks(from, to) {
    if (this.asked !== undefined) {  // going on leaves the question, and what it is about
      const index = this.asked;
      this.close();
      this.answers.set(this.player.run.steps[index].number, false);
      this.tell();
      this.player.show(index);
      return true;
    }
    const {steps} = this.player.run;
    for (let i = from + 1; i <= to; ++i) {
      if (!this.questions.has(i) || this.answers.has(steps[i].number)) continue;
      if (i - 1 !== from) this.player.show(i - 1);
      this.ask(i);
      return true;
    }
    return false;
  }
  ask(index) {
    const {parts, letters} = this.player, {text, answers = []} = this.questions.get(index);
    this.asked = index;
    parts.asked.replaceChildren(...letters.html(text));
    const choices = answers.map((answer, i) => html(
        'button', {type: 'button', class: 'word', 'data-answer': i},
        html('kbd', {'aria-hidden': 'true'}, String(i + 1)), html('span', {}, ...letters.html(answer))));
    parts.answers.replaceChildren(...(choices.length > 0 ? choices : [this.field(text)]), html('button', {type: 'button', class: 'word quiet'}, say('skip')));
    parts.question.hidden = false;
    this.player.root.classList.add('asking');
    parts.answers.querySelector('button, input').focus({preventScroll: true});
  }
  /** For a number: Enter answers. */
  field(text) {
    const field = html('input', {type: 'text', inputmode: 'decimal', autocomplete: 'off', size: 8, 'aria-label': text});
    field.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' && numberOf(field.value) !== undefined) this.answer(field.value);
    });
    return field;
  }
  /** The number of an answer, or what was written; null: shown without an answer, which counts as none. */
  answer(given) {
    const index = this.asked, {answers, answer, value} = this.questions.get(index);
    const right = answers ? given === answer : given !== null && saysTheSame(given, value);
    const text = answers ? answers[answer] : value;
    this.close();
    this.answers.set(this.player.run.steps[index].number, right);
    this.player.show(index);
    if (given === null)
      this.tell();
    else
      this.tell(right ? say('right', {text}) : say('wrong', {text, said: answers ? answers[given] : given}), right);
    this.player.stage.focus({preventScroll: true});
  }
  tell(said = '', right = true) {
    const {player} = this, {steps} = player.run;
    const last = ![...this.questions.keys()].some((i) => !this.answers.has(steps[i].number));
    const score = last ? say('final', {right: this.right, asked: this.answers.size}) : this.score;
    player.notice(said === '' ? score : `${right ? '✓' : '✗'} ${said} ${score}`);
    this.host.predicted(this.record);
  }
  close() {
    this.asked = undefined;
    this.player.parts.question.hidden = true;
    this.player.root.classList.remove('asking');
  }
  show() { this.player.notice(this.answers.size > 0 ? this.score : ''); }
  /** A key for the question: 1, 2 … */
  key(event) {
    if (this.asked === undefined || !/^[1-9]$/.test(event.key)) return false;
    if (Number(event.key) > (this.questions.get(this.asked).answers?.length ?? 0)) return false;
    this.answer(Number(event.key) - 1);
    return true;
  }
}
