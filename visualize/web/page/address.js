'use strict';
// What the address says of a player: #step=7&loop=7-12&speed=2&marks=3,7&theme=dark&embed. It is the whole
// state, so that a link that was copied shows what its sender saw.

const MOST_LETTERS = 50_000;  // of an address: anybody can write one, and what is in it is read more than once
let leftOut = 0;             // letters of one that was too long, until it is told
/** What is read of it. Too long a one goes at once: each url(#…) of a drawing would be resolved against it. */
function readable(hash) {
  if (hash.length <= MOST_LETTERS) return hash;
  leftOut = hash.length;
  try {
    history.replaceState(null, '', '#');
  } catch {
    // A frame without an address of its own
  }
  return '';
}
/** What is quoted of an address, or of a field. */
const quotable = (text) => (text.length > 60 ? `${text.slice(0, 60)}…` : text);

/** "#step=7&embed" as a map. */
function addressParts(hash = readable(location.hash)) {
  const decoded = (text) => {
    try {
      return decodeURIComponent(text);
    } catch {
      return text;
    }
  };
  return new Map(hash.slice(1).split('&').filter(Boolean).map((part) => {
    const [name, ...value] = part.split('=');
    return [decoded(name), decoded(value.join('='))];
  }));
}
/** The map as an address; what needs no escape stays legible. */
function addressText(parts) {
  const escaped = (text) => encodeURIComponent(text.replace(/\p{Surrogate}/gu, '\ufffd')).replace(/%(2C|2F|3A|3B)/g, (code) => decodeURIComponent(code));
  return '#' + [...parts].map(([name, value]) => (value ? `${escaped(name)}=${escaped(value)}` : escaped(name))).join('&');
}

/** The player's own address; parts that are no player's, as embed, stay. */
function addressOf(player) {
  const parts = addressParts(), {steps} = player.run, {loop} = player;
  const put = (name, value) => {
    if (value)
      parts.set(name, value);
    else
      parts.delete(name);
  };
  const number = (index) => steps[index].number;
  put('step', number(player.index));
  put('loop', loop.on && `${number(loop.first)}-${number(loop.last)}`);
  put('speed', player.speed !== PLAIN_SPEED && String(SPEEDS[player.speed]));
  put('marks', player.bookmarks.map(number).join(','));
  if (player.themeChosen) put('theme', player.theme.name);
  player.putAddress?.(put, parts);
  return addressText(parts);
}

function noteAddress(player) {
  clearTimeout(player.addressTimer);
  // Browsers allow only so many changes a second
  player.addressTimer = setTimeout(() => {
    try {
      history.replaceState(null, '', addressOf(player));
    } catch {
      // A frame without an address of its own
    }
  }, player.playing ? 300 : 30);
}

/** Makes the player what the address says; what it can't be is said, and left out. */
function followAddress(player, hash = location.hash) {
  const parts = addressParts(readable(hash)), {run} = player, wrong = [];
  if (leftOut > 0) wrong.push(say('long_address', {length: leftOut, most: MOST_LETTERS}));
  leftOut = 0;
  clearTimeout(player.addressTimer);
  if (player.root.classList.toggle('embedded', parts.has('embed'))) player.resize();
  const text = (name) => parts.get(name) ?? '';
  /** The part as `read` understands it; what it doesn't is noted as wrong. */
  const part = (name, read, complaint) => {
    if (text(name) === '') return undefined;
    const value = read(text(name));
    if (value === undefined) wrong.push(say(complaint, {text: quotable(text(name)), speeds: SPEEDS.join(' ')}));
    return value;
  };
  player.setLoop(part('loop', (loop) => readLoop(loop, run), 'no_loop'));
  player.setSpeed(part('speed', readSpeed, 'no_speed') ?? PLAIN_SPEED);
  player.setBookmarks(part('marks', (marks) => readMarks(marks, run), 'no_mark') ?? []);
  if (text('theme')) player.chooseTheme(text('theme'));
  const step = text('step');
  if (step !== '' && step !== run.steps[player.index].number) {
    player.pause();
    if (!player.goTo(step)) wrong.push(player.noStep(step));
  }
  if (wrong.length > 0) player.notice(wrong.join('; '));
}

/** "7-12" as indices of steps. */
function readLoop(text, run) {
  const [first, last] = text.split('-').map((number) => run.byNumber.get(number));
  return first < last && text.split('-').length === 2 ? {first, last, on: true} : undefined;
}
function readSpeed(text) {
  const index = SPEEDS.indexOf(Number(text));
  return index >= 0 ? index : undefined;
}
/** "3,7" as indices of steps. */
function readMarks(text, run) {
  const marks = text.split(',').map((number) => run.byNumber.get(number));
  return marks.includes(undefined) ? undefined : marks;
}
