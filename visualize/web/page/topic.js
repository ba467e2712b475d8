// Stays whole where a line ends
function flag(text) {
  const span = document.createElement('span');
  span.className = 'flag';
  span.textContent = text;
  return span;
}

// Every command of a block gets a button that copies it.
for (const block of document.querySelectorAll('section > pre')) {
  const commands = block.textContent.trim().split('\n');
  const rows = commands.map((command) => {
    const row = document.createElement('div');
    row.className = 'copied';
    const box = document.createElement('pre');
    box.append(document.createElement('code'));
    box.firstChild.append(...command.split(/(?<= )(-\S*)/).map((part, i) => (i % 2 ? flag(part) : part)));
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'copy';
    const which = document.createElement('span');
    which.className = 'unseen';
    which.textContent = ` ${command}`;
    button.append('copy', which);
    row.append(box, button);
    return row;
  });
  block.replaceWith(...rows);
}

// A link to a source opens it.
function openTarget() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  target?.closest('details')?.setAttribute('open', '');
  target?.scrollIntoView();
}
addEventListener('hashchange', openTarget);
if (location.hash) openTarget();
