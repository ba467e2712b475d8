'use strict';
// The page round its players: the theme it opens with, its keys, and the run that it was made for.

function preferredTheme() {
  const asked = addressParts().get('theme') || GradusPlayer.firstTheme;
  if (asked) return asked;
  if (matchMedia('(prefers-contrast: more)').matches) return 'high_contrast';
  return matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
}

/** Letters in small, whatever the caps lock says: "b", "shift b". */
function nameOfKey({key, shiftKey}) {
  if (!/^[a-z]$/i.test(key)) return key;
  return (shiftKey ? 'shift ' : '') + key.toLowerCase();
}
const isTyping = (target) =>
    target.isContentEditable || (target.matches?.('input, textarea, select') && target.type !== 'range');
/** Control and its like are the browser's; but brackets are typed with them where they are no keys. */
const isOurs = ({key, ctrlKey, metaKey, altKey}) => '[]'.includes(key) || !(ctrlKey || metaKey || altKey);

addEventListener('keydown', (event) => {
  if (!isOurs(event) || event.defaultPrevented) return;
  if (isTyping(event.target)) {
    if (event.key === 'Escape') event.target.blur();
    return;
  }
  const player = all.find((p) => p.root.contains(event.target)) ?? GradusPlayer.active ?? all[0];
  if (!player?.run) return;
  if (player.root.querySelector('dialog[open]')) {
    if (event.key === '?') player.parts.keys.close();
    return;
  }
  if (player.key(event)) event.preventDefault();
});

window.GradusPlayer = GradusPlayer;

/** What a page's players need before there is one. */
function setUp({words: said, themes, theme}) {
  for (const [key, text] of Object.entries(said)) words.set(key, text);
  GradusPlayer.themes = themes;
  GradusPlayer.firstTheme = theme;
}

const page = document.getElementById('gradus-page');
if (page) {
  const started = performance.now();
  const data = JSON.parse(page.textContent);
  setUp(data);
  window.player = new GradusPlayer(document.getElementById('player'));
  window.player.load(data.trace, {command: data.command});
  followAddress(window.player);
  if (data.beside) {
    const together = new Together(window.player);
    together.load(data.beside);
    together.markParting();
    window.player.onChange();
  }
  addEventListener('hashchange', (event) => followAddress(window.player, new URL(event.newURL).hash));
  performance.measure('gradus: open', {start: started, end: performance.now()});
}
