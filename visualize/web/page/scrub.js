'use strict';
// Round the slider: the run's phases below it, the loop behind it, the bookmarks above it.

// In turn, with a second channel for readers who see no colours
const PHASE_ROLES = ['current', 'measure', 'accepted', 'candidate', 'rejected', 'past'];
const PHASE_STYLES = ['solid', 'dashed', 'double'];

class ScrubBar {
  constructor({phases, band, flags}) { Object.assign(this, {phases, band, flags}); }

  load(run) {
    this.run = run;
    this.end = Math.max(run.steps.length - 1, 1);
  }
  place(index) { return `${(100 * index) / this.end}%`; }

  /** A coloured bar for each phase, and its name where there is room. */
  showPhases(look) {
    const strip = this.phases, phases = this.run.phases().filter((p) => p.name), room = strip.clientWidth;
    const size = parseFloat(getComputedStyle(strip).fontSize), names = [...new Set(phases.map((p) => p.name))];
    strip.replaceChildren();
    strip.hidden = phases.length === 0;
    if (phases.length > 200) return;  // they could not be told apart
    const bars = phases.map(({name, from, to}) => ({
                              name,
                              look: look(PHASE_ROLES[names.indexOf(name) % PHASE_ROLES.length]),
                              line: PHASE_STYLES[names.indexOf(name) % PHASE_STYLES.length],
                              width: textWidth(name, size) + 8,
                              left: (Math.max(from - 0.5, 0) / this.end) * room,
                              right: (Math.min(to + 0.5, this.end) / this.end) * room,
                            }));
    let free = 0;
    bars.forEach((bar, i) => {
      this.phases.append(html('i', {
        style: `left: ${bar.left}px; width: ${Math.max(bar.right - bar.left - 1, 1)}px; border-top: 4px ${
            bar.line} ${bar.look.mark}`,
        title: bar.name
      }));
      const next = bars[i + 1], at = Math.max(next ? bar.left : Math.min(bar.left, room - bar.width), free);
      const until = next ? Math.max(bar.right, next.right - next.width) : room;
      if (at + bar.width > until) return;
      strip.append(html('span', {style: `left: ${at}px; color: ${bar.look.text}`}, bar.name));
      free = at + bar.width;
    });
  }

  /** The marked range; a dashed one is not repeated at the moment. */
  showLoop(loop) {
    this.band.hidden = loop.first === undefined;
    this.band.classList.toggle('off', !loop.on);
    if (this.band.hidden) return;
    this.band.style.left = this.place(loop.first);
    this.band.style.width = this.place(loop.last - loop.first);
  }

  showBookmarks(bookmarks) {
    this.flags.replaceChildren(...bookmarks.map((index) => html('i', {
      'data-flag': index,
      style: `left: ${this.place(index)}`,
      title: say('bookmark_here', {number: this.run.steps[index].number})
    })));
  }
}
