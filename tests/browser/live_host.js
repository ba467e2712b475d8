// What live_test.py has the worker do; before it stands the page's own host (visualize/web/workbench/host.js).

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
