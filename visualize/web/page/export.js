'use strict';
// The drawing of a step as a file of its own.

/** The page's letters, as rules of style. */
const letterRules = () => document.getElementById('gradus-fonts').textContent;

/** The drawing as it stands on the page: SVG that needs nothing else. */
function drawingSvg(player) {
  const {drawing, theme} = player, {width, height} = drawing.at, copy = drawing.svg.cloneNode(true);
  for (const [name, value] of Object.entries({xmlns: SVG, viewBox: `0 0 ${width} ${height}`, width, height, 'font-family': SANS}))
    copy.setAttribute(name, value);
  copy.removeAttribute('aria-describedby');
  for (const [number, color] of theme.quantities.entries()) copy.style.setProperty(`--quantity-${number}`, color);
  const step = player.run.steps[player.index];
  copy.prepend(
      svg('title', {}, `${player.name}, ${player.positionOf(step)}`), svg('desc', {}, player.said(step)),
      svg('style', {}, letterRules()), svg('rect', {width, height, fill: theme.tones.paper}));
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(copy)}\n`;
}

/** The same as a PNG of `scale` pixels for one of the page's. */
async function drawingPng(player, scale = 2) {
  const {width, height} = player.drawing.at, image = new Image();
  image.src = `data:image/svg+xml;base64,${base64Of(new TextEncoder().encode(drawingSvg(player)))}`;
  await image.decode();
  const canvas = html('canvas', {width: Math.round(scale * width), height: Math.round(scale * height)});
  canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
}
function base64Of(bytes) {
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text);
}

/** Hands a file to the reader's folder of downloads. */
function save(content, type, name) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], {type}));
  html('a', {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
