// What the worker does for the page, one message after the other: [number, command, value] is answered by
// [number, text, error]. Needs host.js before it.

let module, live = null;
const files = new Map();

const commands = {
  /** The compiled module, before anything is asked. */
  module(compiled) { module = compiled; },
  /** A file that arguments may name: {name, bytes, picture}. */
  keep(file) {
    files.set(file.name, file);
    live?.keep(file);
  },
  async ask(request) {
    live ??= await Live.start(module, files.values());
    return live.ask(request);
  },
};

let last = Promise.resolve();
self.onmessage = ({data: [number, command, value]}) => {
  last = last.then(() => commands[command](value)).then(
      (text) => self.postMessage([number, text]),
      (error) => {
        live = null;  // spent by any error
        const refused = error instanceof Refused;
        self.postMessage([number, null, {line: refused ? error.message : String(error), parameter: error.parameter, refused}]);
      });
};
