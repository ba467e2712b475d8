'use strict';
// The page's own words, in the language of its trace; the page fills them in before anything is shown.

const words = new Map();

/** The text of this key with its {values} put in. */
function say(key, values = {}) {
  return (words.get(key) ?? key).replace(/\{(\w+)\}/g, (place, name) => String(values[name] ?? place));
}
