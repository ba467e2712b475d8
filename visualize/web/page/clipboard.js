'use strict';
// What can be copied, and how: with the browser's clipboard, or as a user's own Ctrl+C where that is missing
// or forbidden, as in frames.

/** Puts a text on the clipboard, in each of these forms: {'text/plain': …, 'text/html': …}. Tells whether it
 *  worked. `host` is where a field for it may stand: inside the open dialog. */
async function copyForms(forms, host) {
  try {
    if (forms['text/html'] && window.ClipboardItem) {
      const {'text/csv': csv, ...taken} = forms;  // browsers take no more kinds
      const blobs = Object.entries(taken).map(([type, text]) => [type, new Blob([text], {type})]);
      await navigator.clipboard.write([new ClipboardItem(Object.fromEntries(blobs))]);
    } else {
      await navigator.clipboard.writeText(forms['text/plain']);
    }
    return true;
  } catch {
    return copiedAsByHand(forms, host);
  }
}

/** Selects the text in a field and lets the browser copy it; the other forms come along. */
function copiedAsByHand(forms, host) {
  const before = document.activeElement, field = html('textarea', {class: 'unseen', readonly: ''});
  const fill = (event) => {
    for (const [type, text] of Object.entries(forms)) event.clipboardData.setData(type, text);
    event.preventDefault();
  };
  field.value = forms['text/plain'];
  host.append(field);
  field.select();
  document.addEventListener('copy', fill);
  try {
    return document.execCommand('copy');
  } catch {
    return false;
  } finally {
    document.removeEventListener('copy', fill);
    field.remove();
    before?.focus();
  }
}

/** A table as spreadsheets and slides take it: tabs and lines, and as HTML. */
function tableForms(columns, rows) {
  const flat = (text) => text.replace(/[\t\r\n]+/g, ' ');
  const lines = [columns.map(({name}) => name), ...rows];
  const cell = (c, text) =>
      html('td', {style: columns[c].numeric ? 'text-align: right' : 'text-align: center'}, text);
  const table = html(
      'table', {},
      html('thead', {}, html('tr', {}, ...columns.map(({name}) => html('th', {scope: 'col'}, name)))),
      html('tbody', {}, ...rows.map((row) => html('tr', {}, ...columns.map((_, c) => cell(c, row[c] ?? ''))))));
  const quoted = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  return {
    'text/csv': lines.map((line) => line.map(quoted).join(',') + '\r\n').join(''),
    'text/plain': lines.map((line) => line.map(flat).join('\t') + '\n').join(''),
    'text/html': table.outerHTML,
  };
}
