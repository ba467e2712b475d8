'use strict';
// The reader says what comes next before it is shown: the questions are the decisions of the run's own steps.

class Predictor {
  /** host: {predicted(text)}, told what has been answered, as the address has it: "4y7n". */
  constructor(player, host) {
    this.player = player;
    this.host = host;
    this.answers = new Map();
    player.parts.answers.addEventListener('click', (event) => {
      const button = event.target.closest('button');
      if (!button) return;
      event.stopPropagation();
      this.answer(button.dataset.answer === undefined ? null : Number(button.dataset.answer));
    });
  }
  /** From now on it asks; `record` is what was answered before. */
  begin(record = '') {
    this.answers = new Map([...record.matchAll(/([\d.]+)([yn])/g)].map(([, number, right]) => [number, right === 'y']));
    this.player.asks = (from, to) => this.asks(from, to);
    const {steps} = this.player.run;
    if (!steps.some(({decision}) => decision)) this.player.notice(say('no_question'));
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
    if (this.asked !== undefined) {  // whoever goes on leaves the question, and what it is about
      const index = this.asked;
      this.close();
      this.answers.set(this.player.run.steps[index].number, false);
      this.tell();
      this.player.show(index);
      return true;
    }
    const {steps} = this.player.run;
    for (let i = from + 1; i <= to; ++i) {
      if (!steps[i].decision || this.answers.has(steps[i].number)) continue;
      if (i - 1 !== from) this.player.show(i - 1);
      this.ask(i);
      return true;
    }
    return false;
  }
  ask(index) {
    const {parts, run} = this.player, {number, decision} = run.steps[index];
    this.asked = index;
    parts.asked.replaceChildren(...this.player.letters.html(say('question', {number, question: decision.question})));
    parts.answers.replaceChildren(
        ...decision.answers.map((text, i) => html(
            'button', {type: 'button', class: 'word', 'data-answer': i, 'aria-label': say('answer', {number: i + 1, text})},
            html('kbd', {'aria-hidden': 'true'}, String(i + 1)), html('span', {}, ...this.player.letters.html(text)))),
        html('button', {type: 'button', class: 'word quiet'}, say('skip')));
    parts.question.hidden = false;
    this.player.root.classList.add('asking');
    parts.answers.firstChild.focus({preventScroll: true});
  }
  /** null: shown without an answer, which counts as none. */
  answer(given) {
    const index = this.asked, {number, decision} = this.player.run.steps[index];
    const right = given === decision.answer, text = decision.answers[decision.answer];
    this.close();
    this.answers.set(number, right);
    this.player.show(index);
    if (given === null)
      this.tell();
    else
      this.tell(right ? say('right', {text}) : say('wrong', {text, said: decision.answers[given]}), right);
    this.player.stage.focus({preventScroll: true});
  }
  tell(said = '', right = true) {
    const {player} = this, last = !player.run.steps.some(({decision, number}) => decision && !this.answers.has(number));
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
    if (Number(event.key) > this.player.run.steps[this.asked].decision.answers.length) return false;
    this.answer(Number(event.key) - 1);
    return true;
  }
}
