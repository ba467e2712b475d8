'use strict';
// A field for each argument of a topic, by the kind of the parameter; what a field says is refused in the command's words.

class Form {
  /** host: {changed(name, text), committed(), opened(name, files)} */
  constructor(element, host) {
    this.element = element;
    this.host = host;
    this.fields = new Map();
  }
  /** Makes the fields of these parameters, or leaves those that are there. */
  show(topic, parameters) {
    const names = `${topic} ${parameters.map(({name}) => name).join(' ')}`;
    if (names === this.names) return;
    this.names = names;
    this.fields = new Map(parameters.map((parameter) => [parameter.name, this.field(parameter)]));
    this.element.replaceChildren(...[...this.fields.values()].map(({label}) => label));
  }
  field(parameter) {
    const {name, type} = parameter, label = html('label', {class: `field ${type}`, title: this.hint(parameter)});
    const control = this.control(parameter);
    const event = control.matches('select, [type="checkbox"]') ? 'change' : 'input';
    control.addEventListener(event, () => {
      this.host.changed(name, this.textIn(control));
      if (event === 'change') this.host.committed();
      this.grow(control);
    });
    if (event === 'input') control.addEventListener('change', () => this.host.committed());
    label.append(html('span', {class: 'name'}, name.replaceAll('_', ' ')), control);
    if (type === 'integer' || type === 'number') this.bindNumber(label, control, parameter);
    if (type === 'color') label.append(this.swatch(control, name));
    if (type === 'picture' || type === 'model' || type === 'maze' || type === 'faces') label.append(this.opener(parameter));
    return {label, control, parameter};
  }
  hint({help, default: usual, example}) {
    return [help, usual && say('usual', {value: usual}), example && say('example', {value: example})].filter(Boolean).join('\n');
  }
  control({type, choices, default: usual}) {
    if (type === 'flag') return html('input', {type: 'checkbox'});
    if (type === 'choice') return html('select', {}, ...choices.map((choice) => html('option', {value: choice}, choice)));
    const whole = type === 'integer' ? 'numeric' : undefined;
    const more = {spellcheck: 'false', autocomplete: 'off', autocapitalize: 'off', inputmode: whole};
    return html('input', {type: 'text', placeholder: usual, ...more});
  }
  textIn(control) { return control.type === 'checkbox' ? (control.checked ? 'yes' : '') : control.value; }
  /** A field is as wide as what it says, up to a limit. */
  grow(control) {
    const {length} = control.value || control.placeholder || '';
    if (control.type === 'text') control.style.width = `${Math.min(Math.max(length, 3), 26) + 1.5}ch`;
  }
  /** The name of a number can be dragged, and its arrows go up and down. */
  bindNumber(label, control, {name, least, most, type}) {
    const write = (text) => {
      control.value = text;
      this.grow(control);
      this.host.changed(name, text);
    };
    const step = (by, from = control.value) => {
      const value = Number(from || control.placeholder);
      if (!Number.isFinite(value)) return;
      const next = type === 'integer' ? Math.min(Math.max(Math.round(value + by), least), most) : Number((value + by).toPrecision(10));
      write(String(next));
    };
    const unit = () => (type === 'integer' ? 1 : roundStep(Math.max(Math.abs(Number(control.value)), 1e-3) / 8));
    control.addEventListener('keydown', (event) => {
      const by = {ArrowUp: 1, ArrowDown: -1}[event.key];
      if (!by) return;
      event.preventDefault();
      step(by * unit() * (event.shiftKey ? 10 : 1));
      this.host.committed();
    });
    const handle = label.querySelector('.name');
    handle.classList.add('scrubs');
    let start = null;  // a drag is counted from where it began
    handle.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      start = {x: event.clientX, text: control.value, size: unit(), steps: 0};
      handle.setPointerCapture(event.pointerId);
    });
    handle.addEventListener('pointermove', (event) => {
      if (start === null) return;
      const steps = Math.trunc((event.clientX - start.x) / 8);
      if (steps === start.steps) return;
      start.steps = steps;
      if (steps === 0)
        write(start.text);
      else
        step(steps * start.size, start.text);
    });
    for (const ends of ['pointerup', 'pointercancel'])
      handle.addEventListener(ends, () => {
        if (start !== null) this.host.committed();
        start = null;
      });
  }
  swatch(control, name) {
    const swatch = html('input', {type: 'color', 'aria-label': say('colour_of', {name})});
    swatch.addEventListener('input', () => {
      control.value = swatch.value;
      this.host.changed(name, swatch.value);
    });
    swatch.addEventListener('change', () => this.host.committed());
    return swatch;
  }
  opener({name, type}) {
    const accept = {picture: 'image/png,image/jpeg', model: '.obj,.mtl', maze: '.txt,text/plain', faces: '.obj,.mtl,.json'}[type];
    const chooser = html('input', {type: 'file', accept, hidden: '', multiple: type === 'model' || type === 'faces', tabindex: '-1'});
    const button = html('button', {type: 'button', class: 'word'}, say('open_file'));
    button.addEventListener('click', (event) => {
      event.preventDefault();
      chooser.click();
    });
    chooser.addEventListener('change', () => {
      this.host.opened(name, [...chooser.files]);
      chooser.value = '';
    });
    return html('span', {class: 'opener'}, button, chooser);
  }

  /** What the fields say; the one that is being written in keeps its own spelling. */
  fill(textOf) {
    for (const {control, parameter} of this.fields.values()) {
      const text = textOf(parameter);
      if (control.type === 'checkbox')
        control.checked = text === 'yes';
      else if (control !== document.activeElement || this.host.dragging)
        control.value = text;
      this.grow(control);
    }
  }
  /** The line of a refusal stands below the fields, and the one to blame is marked. */
  blame(parameter, line) {
    for (const [name, {control}] of this.fields) {
      if (line !== '' && name === parameter) {
        control.setAttribute('aria-invalid', 'true');
        control.setAttribute('aria-describedby', 'gradus-refusal');
      } else {
        control.removeAttribute('aria-invalid');
        control.removeAttribute('aria-describedby');
      }
    }
  }
}
