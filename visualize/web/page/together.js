'use strict';
// Two runs, step beside step: the controls of the first move both, and what is done in the second moves the first.

/** Makes a second player behind the first. `pairs`: numbers of steps that stand side by side. */
function playTogether(first, {trace, command, pairs, parting}) {
  const root = html('section');
  first.root.after(root);
  document.body.classList.add('together');
  const second = new GradusPlayer(root);
  second.load(trace, {command});
  root.classList.add('follows');
  // Two of each region: the players' names tell them apart
  for (const player of [first, second])
    for (const region of player.root.querySelectorAll('section[aria-label]'))
      region.setAttribute('aria-label', `${region.getAttribute('aria-label')}: ${player.name}`);
  // Of several partners the first; both runs end together
  const partners = (of) => new Map([...pairs.slice(0, -1).reverse(), pairs.at(-1)].map((pair) => [pair[of], pair[1 - of]]));
  const stepOf = (player) => player.run.steps[player.index].number;
  let following = false;  // what is done to the other one comes back
  const lead = (leader, follower, partner) => () => {
    if (following) return;
    following = true;
    if (follower.theme !== leader.theme) follower.setTheme(leader.theme.name);
    // A finer event stands beside the step that it follows
    const number = partner.get(stepOf(leader).split('.')[0]);
    if (number !== undefined && number !== stepOf(follower)) follower.goTo(number);
    for (const player of [first, second]) player.root.classList.toggle('parts', stepOf(first) === parting);
    following = false;
  };
  first.onChange = lead(first, second, partners(0));
  second.onChange = lead(second, first, partners(1));
  if (parting !== null) first.setBookmarks([...first.bookmarks, first.run.byNumber.get(parting)]);
  first.onChange();
}
