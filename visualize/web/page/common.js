'use strict';

// Light or dark: the system's choice until another is made, which pages opened from here remember if they may.
const theme = {
  key: 'gradus-theme',
  names: ['system', 'light', 'dark'],
  load() {
    try {
      return localStorage.getItem(this.key) ?? 'system';
    } catch {
      return 'system';
    }
  },
  save(name) {
    try {
      localStorage.setItem(this.key, name);
    } catch {
      // Kept for this page only
    }
  },
  show(name) {
    if (!this.names.includes(name)) name = 'system';
    if (name === 'system') {
      delete document.documentElement.dataset.theme;
    } else {
      document.documentElement.dataset.theme = name;
    }
    for (const button of document.querySelectorAll('button.theme')) button.textContent = `colours: ${name}`;
    this.name = name;
  },
  next() {
    this.show(this.names[(this.names.indexOf(this.name) + 1) % this.names.length]);
    this.save(this.name);
    announce(`Colours: ${this.name}.`);
  },
};
theme.show(theme.load());

function announce(text) {
  document.querySelector('.notice').textContent = text;
}

// Where the browser gives no leave to write the clipboard (a page in a frame), the old command often does;
// where that fails too, the text is selected, to be copied by hand.
async function copy(element) {
  try {
    await navigator.clipboard.writeText(element.textContent);
    return true;
  } catch {
    getSelection().selectAllChildren(element);
    return document.execCommand('copy');
  }
}

document.addEventListener('click', async ({target}) => {
  const button = target.closest('button');
  if (button?.matches('.theme')) theme.next();
  if (!button?.matches('.copy')) return;
  const done = await copy(button.parentElement.querySelector('code'));
  const word = button.firstChild;
  word.data = done ? 'copied' : 'selected';
  announce(done ? 'Copied.' : 'Selected: copy it with your browser.');
  setTimeout(() => {
    word.data = 'copy';
    announce('');
  }, 1500);
});

// Buttons do nothing without this script, and so appear with it.
for (const button of document.querySelectorAll('button.copy, button.theme')) button.hidden = false;
