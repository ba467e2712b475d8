'use strict';
// The page's side of the worker: what is asked is answered in turn, and a worker that takes too long is ended.

const LONGEST = 15_000;  // ms: a picture of 64 million pixels, a model of 100,000 faces

/** What the module refused, or what kept it from answering. `parameter`: the one to blame; '' for none. */
class Unanswered extends Error {
  constructor({line, parameter = '', refused = false}) {
    super(line);
    Object.assign(this, {parameter, refused});
  }
}

class Asker {
  /** script: the worker's. module: a promise of the compiled one; without it nothing can be asked. */
  constructor(script, module) {
    this.script = script;
    this.module = module;
    this.files = [];
    this.waiting = new Map();
    this.count = 0;
  }
  /** The text of the answer; fails by Unanswered. */
  async ask(request, longest = LONGEST) {
    await this.start();
    const timer = setTimeout(() => this.end(say('too_long', {seconds: longest / 1000})), longest);
    try {
      return await this.call('ask', request);
    } finally {
      clearTimeout(timer);
    }
  }
  /** A file that arguments may name from now on: {name, bytes, picture}. */
  async keep(file) {
    this.files = [...this.files.filter(({name}) => name !== file.name), file];
    if (this.worker) await this.call('keep', file);
  }

  async start() {
    const module = await this.module;
    if (this.worker) return;
    this.worker = new Worker(URL.createObjectURL(new Blob([this.script], {type: 'text/javascript'})));
    this.worker.onmessage = ({data: [number, text, error]}) => this.answered(number, text, error);
    this.worker.onerror = (event) => this.end(event.message || say('no_worker'));
    this.call('module', module);
    for (const file of this.files) this.call('keep', file);
  }
  call(command, value) {
    return new Promise((resolve, reject) => {
      this.waiting.set(++this.count, {resolve, reject});
      this.worker.postMessage([this.count, command, value]);
    });
  }
  answered(number, text, error) {
    const {resolve, reject} = this.waiting.get(number);
    this.waiting.delete(number);
    if (error)
      reject(new Unanswered(error));
    else
      resolve(text);
  }
  /** Ends the worker with all that it was asked; the next question gets a new one. */
  end(line) {
    this.worker?.terminate();
    this.worker = null;
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    for (const {reject} of waiting) reject(new Unanswered({line}));
  }
}

/** The module: compiled from what lies in the page, packed, or beside it. Without WebAssembly it fails. */
async function compiledModule(packed) {
  if (!window.WebAssembly) throw new Unanswered({line: say('no_wasm')});
  if (packed) return WebAssembly.compile(await unpacked(packed));
  const answer = await fetch('gradus.wasm');
  if (!answer.ok) throw new Unanswered({line: say('no_module', {status: answer.status})});
  return WebAssembly.compile(await answer.arrayBuffer());  // whatever type the server says that it has
}

/** The bytes behind base64 of what zlib has packed. */
async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream).arrayBuffer();
}
