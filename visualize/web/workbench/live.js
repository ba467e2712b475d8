'use strict';
// The live page begins: its language, the player, what the module is, and the first run.

/** A language that the page has: the address's, the browser's, English. */
function pageLanguage(there) {
  const wanted = [addressParts().get('language'), ...navigator.languages.map((code) => code.slice(0, 2))];
  return wanted.find((code) => there.includes(code)) ?? 'en';
}

/** {language: {topic: trace}}: the runs of the usual inputs, packed in the page. */
async function recordedRuns(packed) {
  try {
    return JSON.parse(new TextDecoder().decode(await unpacked(packed)));
  } catch {
    return {};  // a browser without DecompressionStream waits for the module
  }
}

/** Beside what is told already, what an address has that the page has not. */
function tellOfAddress(player, [told, unknown]) {
  player.notice([told, unknown && say('unknown', {what: unknown})].filter(Boolean).join('; '));
}

async function openLive() {
  const started = performance.now();
  const content = (id) => document.getElementById(id).textContent;
  const data = JSON.parse(content('gradus-live')), language = pageLanguage(Object.keys(data.words));
  document.documentElement.lang = language;
  setUp({words: data.words[language], themes: data.themes, theme: ''});
  document.getElementById(`gradus-player-${language}`).id = 'gradus-player';
  const root = document.getElementById('workbench');
  root.replaceChildren(document.getElementById(`gradus-workbench-${language}`).content.cloneNode(true));
  document.body.classList.toggle('framed', addressParts().has('embed'));
  const player = window.player = new GradusPlayer(document.getElementById('player'));
  const module = compiledModule(content('gradus-module').trim());
  module.catch(() => {});  // said when it is asked for
  const asker = new Asker(content('gradus-worker'), module);
  const bench = window.workbench = new Workbench(root, player, asker, {topics: data.list.topics, notations: data.notations, recorded: await recordedRuns(content('gradus-recorded').trim())});
  const languages = Object.keys(data.words), unknown = unknownIn(addressParts(), bench.topics, languages);
  bench.state = stateOf(addressParts(), bench.topics, language);
  const usual = Object.keys(bench.state.given).length === 0 && !bench.state.beside && bench.method?.name === bench.topic.default_method;
  if (usual) bench.showRecorded();
  performance.measure('gradus: open', {start: started, end: performance.now()});
  const told = player.parts.notice.textContent;  // of the address
  await bench.open(bench.state);
  tellOfAddress(player, [player.parts.notice.textContent || told, unknown]);
  performance.measure('gradus: alive', {start: started, end: performance.now()});
  addEventListener('hashchange', async (event) => {
    // By now the page may have written its own address over that one
    const hash = readable(new URL(event.newURL).hash), parts = addressParts(hash), wanted = parts.get('language');
    if (languages.includes(wanted) && wanted !== language) return location.reload();
    await bench.open(stateOf(parts, bench.topics, language));
    followAddress(player, hash);
    tellOfAddress(player, [player.parts.notice.textContent, unknownIn(parts, bench.topics, languages)]);
    if (location.hash !== hash) noteAddress(player);
  });
}
window.opened = openLive();
