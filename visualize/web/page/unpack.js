'use strict';

// Unpacks the texts of pixels: text_pack.hpp says what a block holds.
class Texts {
  constructor({forms, shared, sharedInBlock, rows}) {
    Object.assign(this, {forms, shared, sharedInBlock, rows});
    this.known = new Map();
  }

  // What is told of the pixel in this column and row.
  async of(column, row) {
    const lines = (await this.block(this.rows, row))[column];
    const whole = await Promise.all(lines.map((line) => (typeof line === 'number' ? this.part(line) : `${line}\n`)));
    return whole.join('');
  }

  async part(number) {
    const texts = await this.block(this.shared, Math.floor(number / this.sharedInBlock));
    return texts[number % this.sharedInBlock].map((line) => `${line}\n`).join('');
  }

  // The texts of a block, as lists of lines; in place of a shared part stands its number.
  async block(blocks, number) {
    const packed = blocks[number];
    if (!this.known.has(packed)) {
      if (this.known.size > 32) this.known.clear();
      this.known.set(packed, inflated(packed).then((bytes) => this.textsIn(bytes)));
    }
    return this.known.get(packed);
  }

  textsIn(bytes) {
    const forms = new Stream(bytes, 0), placesAt = forms.whole() + forms.at;
    const places = new Stream(bytes, placesAt), digits = new Stream(bytes, places.whole() + places.at);
    const last = new Map(), texts = [];
    const token = (mark, form, place) => {
      const decimals = mark === '\u0001' ? places.byte() : 0, key = `${form} ${place} ${decimals}`;
      const value = (last.get(key) ?? 0) + digits.signed();
      last.set(key, value);
      return mark === '\u0001' ? numberText(value, decimals) : `#${value.toString(16).padStart(6, '0')}`;
    };
    while (forms.at < placesAt) {
      const text = [];
      for (let left = forms.whole(); left > 0; --left) {
        const form = forms.whole();
        let place = 0;
        const line = this.forms[form].replace(/[\u0001\u0002]/g, (mark) => token(mark, form, place++));
        text.push(line.startsWith('\u0003') ? Number(line.slice(1)) : line);
      }
      texts.push(text);
    }
    return texts;
  }
}

// Reads bytes one after the other.
class Stream {
  constructor(bytes, at) {
    Object.assign(this, {bytes, at});
  }
  byte() {
    return this.bytes[this.at++];
  }
  whole() {
    let value = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = this.byte();
      value += (byte % 128) * scale;
      if (byte < 128) return value;
    }
  }
  signed() {
    const value = this.whole();
    return value % 2 ? -(value + 1) / 2 : value / 2;
  }
}

function numberText(value, decimals) {
  const digits = String(Math.abs(value)).padStart(decimals + 1, '0'), point = digits.length - decimals;
  return (value < 0 ? '-' : '') + digits.slice(0, point) + (decimals ? `.${digits.slice(point)}` : '');
}

async function inflated(base64) {
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
