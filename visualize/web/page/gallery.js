// Search: every word must occur in what a card is found by. "bresenham-line" is "bresenham_line" is "Bresenham line".
const plain = (text) => text.toLowerCase().replace(/[-_\s]+/g, ' ').trim();
const form = document.querySelector('.find');
const wanted = form.querySelector('input');
const chapter = form.querySelector('select');
const found = document.querySelector('.found');
const sections = [...document.querySelectorAll('main > section')].map((element) => ({
  element,
  chapter: element.dataset.chapter,
  topics: [...element.querySelectorAll('.topic')],
  cards: [...element.querySelectorAll('.card')].map((card) => ({element: card, text: plain(card.dataset.words)})),
}));
const all = document.querySelectorAll('.card').length;

function show() {
  const words = plain(wanted.value).split(' ');
  let count = 0;
  for (const section of sections) {
    const open = !chapter.value || chapter.value === section.chapter;
    let some = false;
    for (const {element, text} of section.cards) {
      const matches = open && words.every((word) => text.includes(word));
      element.hidden = !matches;
      some ||= matches;
      count += matches;
    }
    for (const topic of section.topics) topic.hidden = !topic.querySelector('.card:not([hidden])');
    section.element.hidden = !some;
  }
  found.textContent = count === all ? `${all} figure${all === 1 ? '' : 's'}`
    : count ? `${count} of ${all} figures` : `None of the ${all} figures fits. Try fewer words, or all chapters.`;
}

form.addEventListener('input', show);
form.addEventListener('submit', (event) => event.preventDefault());
wanted.addEventListener('keydown', ({key}) => {
  if (key !== 'Escape') return;
  wanted.value = '';
  show();
});
document.addEventListener('keydown', (event) => {
  if (event.key !== '/' || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.target.matches('input, select, textarea')) return;
  event.preventDefault();
  wanted.focus();
});

// One chapter is no choice
chapter.parentElement.hidden = sections.length < 2;
form.hidden = found.hidden = false;
show();  // a reloaded page keeps what was typed
