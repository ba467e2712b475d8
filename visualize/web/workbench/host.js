'use strict';
// The host of the module: what it imports, and a call for each thing that it can be asked. docs/live.md quotes it.

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

  /** The text of an answer. After any error this instance is spent. */
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
