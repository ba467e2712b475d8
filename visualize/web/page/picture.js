'use strict';

// A pixel is chosen by a click, by keys or by its numbers; what is told of it stands in the page's data.
const data = JSON.parse(document.getElementById('gradus-picture').textContent);
const texts = new Texts(data);
const part = (name) => document.querySelector(`[data-part="${name}"]`);
const {frame, image, mark, go, column, row, loupe, story, command} = new Proxy({}, {get: (_, name) => part(name)});
const pixel = {column: Math.floor(data.width / 2), row: Math.floor(data.height / 2)};

const within = (value, count) => Math.min(Math.max(Math.trunc(value) || 0, 0), count - 1);

function choose(wantedColumn, wantedRow) {
  pixel.column = within(wantedColumn, data.width);
  pixel.row = within(wantedRow, data.height);
  column.value = pixel.column;
  row.value = pixel.row;
  mark.hidden = false;
  mark.style.left = `${(100 * pixel.column) / data.width}%`;
  mark.style.top = `${(100 * pixel.row) / data.height}%`;
  drawLoupe();
}

async function tell() {
  const {column, row} = pixel;
  let told;
  try {
    told = await texts.of(column, row);
  } catch {
    told = 'This browser cannot unpack what is told of pixels. The command below tells it.\n';
  }
  if (column !== pixel.column || row !== pixel.row) return;  // another one by now
  story.textContent = told;
  command.textContent = `${data.command} --why ${column},${row}`;
  command.closest('.copied').hidden = false;
  announce(told.slice(0, told.indexOf('\n')));
  history.replaceState(null, '', `#pixel=${column},${row}`);
}

function drawLoupe() {
  const side = 15, cell = loupe.width / side, pen = loupe.getContext('2d');
  const left = pixel.column - (side - 1) / 2, top = pixel.row - (side - 1) / 2;
  pen.imageSmoothingEnabled = false;
  pen.clearRect(0, 0, loupe.width, loupe.height);
  pen.drawImage(image, -left * cell, -top * cell, data.width * cell, data.height * cell);
  for (const [colour, width] of [['#ffffff', 5], ['#000000', 2]]) {
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.strokeRect(((side - 1) / 2) * cell, ((side - 1) / 2) * cell, cell, cell);
  }
}

frame.addEventListener('click', (event) => {
  const box = image.getBoundingClientRect();
  choose(((event.clientX - box.left) / box.width) * data.width, ((event.clientY - box.top) / box.height) * data.height);
  tell();
});

const ways = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
frame.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const way = ways[event.key], step = event.shiftKey ? 10 : 1;
  if (way) {
    choose(pixel.column + step * way[0], pixel.row + step * way[1]);
    announce(`Pixel ${pixel.column},${pixel.row}.`);
  } else if (event.key === 'Enter' || event.key === ' ') {
    tell();
  } else {
    return;
  }
  event.preventDefault();
});

go.addEventListener('submit', (event) => {
  event.preventDefault();
  choose(column.value, row.value);
  tell();
});

function follow() {
  const wanted = /^#pixel=(\d+),(\d+)$/.exec(location.hash);
  if (!wanted) return choose(pixel.column, pixel.row);
  choose(Number(wanted[1]), Number(wanted[2]));
  tell();
}
addEventListener('hashchange', follow);
go.hidden = false;
image.decode().then(follow);
