'use strict';
// Files that the reader opens or drops: pictures are decoded here, by the browser; nothing leaves the page.

const MOST_PIXELS = 1 << 26;  // of a picture, as the command takes them; more would fill the module's memory
/** Whether a file holds the materials of a model. */
const isLibrary = ({name}) => /\.mtl$/i.test(name);

/** What a file holds, and of a picture what it shows; of one that is too large nothing. */
async function readFile(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const isPicture = /^image\/(png|jpeg)$/.test(file.type) || /\.(png|jpe?g)$/i.test(file.name);
  return {name: file.name, bytes, picture: isPicture ? await decoded(bytes).catch(() => null) : null};
}
async function decoded(bytes) {
  const bitmap = await createImageBitmap(new Blob([bytes]), {premultiplyAlpha: 'none', colorSpaceConversion: 'none'});
  if (bitmap.width * bitmap.height > MOST_PIXELS) return null;
  const canvas = html('canvas', {width: bitmap.width, height: bitmap.height}), context = canvas.getContext('2d');
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, bitmap.width, bitmap.height);
}

/** The kind of parameter that takes a file of this name, of those the topic has. */
function parameterFor({name}, parameters) {
  const ending = name.slice(name.lastIndexOf('.') + 1).toLowerCase();
  const types = {png: ['picture'], jpg: ['picture'], jpeg: ['picture'], obj: ['model', 'faces'], txt: ['maze'], json: ['faces']}[ending];
  return parameters.find(({type}) => types?.includes(type));
}
/** A saved input; nothing where a file is none. */
function savedState(bytes) {
  try {
    const state = JSON.parse(new TextDecoder().decode(bytes));
    return state?.gradus === 1 && typeof state.address === 'string' && areFiles(state.files ?? []) ? state : undefined;
  } catch {
    return undefined;
  }
}
function areFiles(files) {
  const isFile = (file) => typeof file?.name === 'string' && typeof file.bytes === 'string' && isBase64(file.bytes);
  return Array.isArray(files) && files.every(isFile);
}
function isBase64(text) {
  try {
    return typeof atob(text) === 'string';
  } catch {
    return false;
  }
}
