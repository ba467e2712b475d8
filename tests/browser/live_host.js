'use strict';
// The worker that hosts the module of live pages, as live_test.py loads it into a page; docs/live.md quotes the class.

// [docs/live.md
const LEFT = Symbol('an attempt was left');

class Refused extends Error {
  constructor(line, parameter) {
    super(line);
    this.parameter = parameter;  // '' for none
  }
}

class Live {
  /** module: a compiled WebAssembly.Module. files: [{name, bytes, picture}], what arguments may name. */
  static async start(module, files = []) {
    const live = new Live();
    const gradus = {
      refused: (...places) => { throw new Refused(...live.texts(places)); },
      attempt: (work, data) => {
        try {
          live.exports.run(work, data);
          return 1;
        } catch (error) {
          if (error !== LEFT) throw error;
          return 0;
        }
      },
      leave: () => { throw LEFT; },
    };
    live.exports = (await WebAssembly.instantiate(module, {gradus})).exports;
    live.exports._initialize();
    for (const file of files) live.keep(file);
    return live;
  }

  /** The text of an answer. After an error, whatever it is, this instance is spent. */
  ask(request) {
    this.put(new TextEncoder().encode(JSON.stringify(request)));
    const address = this.exports.answer();
    return this.texts([address, this.exports.answer_size()])[0];
  }

  keep({name, bytes, picture}) {
    const called = new TextEncoder().encode(name);
    this.put(called, bytes);
    this.exports.keep_file(called.length);
    if (!picture) return;
    this.put(called, picture.data);  // an ImageData: red, green, blue, alpha
    this.exports.keep_picture(called.length, picture.width, picture.height);
  }

  put(...parts) {
    const address = this.exports.room(parts.reduce((size, part) => size + part.length, 0));
    const memory = new Uint8Array(this.exports.memory.buffer);
    parts.reduce((at, part) => (memory.set(part, at), at + part.length), address);
  }

  /** Texts by address and size in turn. */
  texts(places) {
    const texts = [];
    for (let i = 0; i < places.length; i += 2) {
      texts.push(new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer, places[i], places[i + 1])));
    }
    return texts;
  }
}
// docs/live.md]

const hex = (buffer) => Array.from(new Uint8Array(buffer), (byte) => byte.toString(16).padStart(2, '0')).join('');
const digest = async (text) => hex(await crypto.subtle.digest('SHA-256', new TextEncoder().encode(text)));

/** What a file shows, as the page's own decoder has it. */
async function decoded(bytes) {
  const bitmap = await createImageBitmap(new Blob([bytes]), {premultiplyAlpha: 'none', colorSpaceConversion: 'none'});
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, bitmap.width, bitmap.height);
}

let module, live, files = [];

/** What became of a request: how it ended, and its text or that text's digest. */
async function told(request, whole) {
  const start = performance.now();
  try {
    live ??= await Live.start(module, files);
    const text = live.ask(request);
    const time = performance.now() - start;
    return ['answer', whole ? text : await digest(text), time];
  } catch (error) {
    live = null;
    if (!(error instanceof Refused)) return ['trapped', String(error), 0];
    return ['refused', whole ? error.message : await digest(error.message), performance.now() - start];
  }
}

const commands = {
  async load(base64) {
    const start = performance.now();
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    module = await WebAssembly.compile(bytes);
    return [performance.now() - start, WebAssembly.Module.imports(module).map(({name}) => name),
      WebAssembly.Module.exports(module).map(({name}) => name)];
  },
  async open(name, base64, isPicture) {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    files.push({name, bytes, picture: isPicture ? await decoded(bytes) : null});
    live = null;
  },
  async ask(requests, whole) {
    const all = [];
    for (const request of requests) all.push(await told(request, whole));
    return all;
  },
};

self.onmessage = async ({data: [id, command, ...values]}) => {
  try {
    self.postMessage([id, await commands[command](...values), null]);
  } catch (error) {
    self.postMessage([id, null, String(error)]);
  }
};
