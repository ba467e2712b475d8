'use strict';
// Two runs, step beside step: the controls of the first move both, and what is done in the second moves the first.

class Together {
  /** Makes a second player behind the first. */
  constructor(first) {
    const root = html('section');
    first.root.after(root);
    root.parentElement.classList.add('together');
    this.first = first;
    this.second = new GradusPlayer(root);
    this.following = false;  // what is done to the other one comes back
    root.classList.add('follows');
    first.onChange = () => this.lead(first, this.second, this.partners[0]);
    this.second.onChange = () => this.lead(this.second, first, this.partners[1]);
  }
  /** The run that the first one's stands beside. `pairs`: numbers of steps that stand side by side. */
  load({trace, command, alignment: {pairs, parting}}, light) {
    const {first, second} = this;
    this.parting = parting;
    // Of several partners the first; both runs end together
    this.partners = [0, 1].map(
        (of) => new Map([...pairs.slice(0, -1).reverse(), pairs.at(-1)].map((pair) => [pair[of], pair[1 - of]])));
    this.following = true;
    if (second.run)
      second.update(trace, {command, light});
    else
      second.load(trace, {command});
    this.following = false;
    if (light) return first.onChange();
    // Two of each region: the players' names tell them apart
    for (const player of [first, second]) {
      const {trace} = player.run, name = `${player.name}, ${trace.method_title || trace.method}`;
      player.root.setAttribute('aria-label', name);
      for (const region of player.root.querySelectorAll('section[aria-label]')) {
        region.dataset.label ??= region.getAttribute('aria-label');
        region.setAttribute('aria-label', `${region.dataset.label}: ${name}`);
      }
    }
    first.onChange();
  }
  /** A bookmark where the runs part. */
  markParting() {
    const {first, parting} = this;
    if (parting !== null) first.setBookmarks([...first.bookmarks, first.run.byNumber.get(parting)]);
  }
  lead(leader, follower, partner) {
    if (this.following || !follower.run) return;
    this.following = true;
    const stepOf = (player) => player.run.steps[player.index].number;
    if (follower.theme !== leader.theme) follower.setTheme(leader.theme.name);
    // A finer event stands beside the step that it follows
    const number = partner.get(stepOf(leader).split('.')[0]);
    if (number !== undefined && number !== stepOf(follower)) follower.goTo(number);
    for (const player of [this.first, this.second]) player.root.classList.toggle('parts', stepOf(this.first) === this.parting);
    this.following = false;
  }
  /** The second player is gone, and the first as it was. */
  end() {
    this.first.onChange = undefined;
    this.first.root.classList.remove('parts');
    this.first.root.parentElement.classList.remove('together');
    all.splice(all.indexOf(this.second), 1);
    this.second.root.remove();
    for (const region of this.first.root.querySelectorAll('section[data-label]'))
      region.setAttribute('aria-label', region.dataset.label);
    this.first.resize();
  }
}
