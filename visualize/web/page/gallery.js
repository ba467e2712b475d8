'use strict';

// A card's command, copied; where the browser gives no leave, selected to be copied by hand.
document.addEventListener('click', async ({target}) => {
  if (!target.matches('.copy')) return;
  const code = target.parentElement.querySelector('code');
  try {
    await navigator.clipboard.writeText(code.textContent);
    target.textContent = 'copied';
    setTimeout(() => {
      target.textContent = 'copy';
    }, 1500);
  } catch {
    getSelection().selectAllChildren(code);
  }
});
