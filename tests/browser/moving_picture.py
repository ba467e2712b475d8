#!/usr/bin/env python3
"""The README's moving picture: a line in the live page, played, then dragged by its end.

    moving_picture.py [--write] PAGES

PAGES is the program gradus-live-pages. Plays the scene in headless Chromium and compares each picture with that of
docs/first_screen/live.gif; --write makes that file anew: look at it. Exits 1 where they differ, and 77 without Chromium or the
module.
"""
import argparse
import base64
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import project
from live_page import CELL, Page
from player_page import Checks
from webdriver import Browser

FILM = project.ROOT / 'docs/first_screen/live.gif'
MOST_BYTES = 1_500_000
SIZE = (760, 560)
RATE = 5  # pictures a second
ENDS = [(7, 3), (7, 4), (6, 4), (5, 4), (4, 4), (3, 4), (3, 3), (4, 3), (5, 3), (5, 2), (6, 2), (7, 2), (7, 1), (6, 1), (6, 2), (7, 3)]
# Rounding may move a rim by a pixel, and a palette a shade by a few levels; what is wrong moves more
LEVELS, SHARE = 16, 0.002

POINTER = '''const hand = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    hand.setAttribute("viewBox", "0 0 16 24");
    hand.innerHTML = '<path d="M1 1 V19 L5.5 15 L8.5 22 L11.5 20.7 L8.6 14 H15 Z" fill="#14171c" stroke="#fff" stroke-width="1.4"/>';
    Object.assign(hand.style, {position: "fixed", width: "20px", height: "30px", zIndex: 99, pointerEvents: "none"});
    document.body.append(hand);
    window.showHand = (x, y) => Object.assign(hand.style, {left: `${x - 1}px`, top: `${y - 1}px`});
    showHand(arguments[0], arguments[1]);'''


def point(page, kind, place, down=False):
    """One thing that a mouse does at a place, its button held or not, and the hand where it is."""
    page.run('showHand(arguments[0], arguments[1])', *place)
    page.cdp('Input.dispatchMouseEvent', type=kind, x=place[0], y=place[1], buttons=int(down), clickCount=1,
             button='none' if kind == 'mouseMoved' and not down else 'left')


def scene(page):
    """Yields the pictures, each with how many ticks it stays."""
    def shown(ticks):
        page.settle()
        return base64.b64decode(page.call('GET', '/screenshot')), ticks

    page.size(*SIZE)
    page.open('#topic=bresenham_line')
    yield shown(4)
    while page.run('return player.index < player.run.steps.length - 1'):
        page.press('ArrowRight')
        yield shown(3)
    handle, start = page.place('to', '0,1'), page.run(CELL, 7, 0)
    page.run(POINTER, *start)
    for way in (0, 0.5, 1):
        point(page, 'mouseMoved', [a + way * (b - a) for a, b in zip(start, handle)])
        yield shown(1)
    point(page, 'mousePressed', handle, down=True)
    ends = [page.run(CELL, x, y) for x, y in ENDS]
    for place in ends:
        point(page, 'mouseMoved', place, down=True)
        yield shown(2)
    point(page, 'mouseReleased', ends[-1])
    yield shown(8)


def ffmpeg(*words, data=None):
    return subprocess.run(['ffmpeg', '-v', 'error', *map(str, words)], input=data, stdout=subprocess.PIPE, check=True).stdout


def raw(*source, data=None):
    """The pictures' bytes, red, green and blue of each pixel."""
    every = ffmpeg(*source, '-vf', f'fps={RATE}', '-f', 'rawvideo', '-pix_fmt', 'rgb24', '-', data=data)
    size = 3 * SIZE[0] * SIZE[1]
    return [every[at:at + size] for at in range(0, len(every), size)]


def differing(a, b):
    """The share of the pixels of which a channel is off by more than LEVELS."""
    if a == b:
        return 0
    off = {at // 3 for at, (c, d) in enumerate(zip(a, b)) if abs(c - d) > LEVELS}
    return len(off) / (SIZE[0] * SIZE[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--write', action='store_true')
    parser.add_argument('pages')
    options = parser.parse_args()
    built = project.live_build()
    if not built or not all(map(shutil.which, ('chromium', 'chromedriver', 'ffmpeg'))):
        print('skipped: the module is not built (./bootstrap live), or Chromium or ffmpeg is not here (./bootstrap packages)')
        return 77
    check = Checks()
    with tempfile.TemporaryDirectory() as name, Browser() as browser:
        subprocess.run([options.pages, built / 'gradus.wasm', name], check=True)
        pictures = list(scene(Page(browser, (pathlib.Path(name) / 'gradus.html').as_uri(), check)))
    source = ('-f', 'image2pipe', '-framerate', RATE, '-i', '-')
    data = b''.join(picture * ticks for picture, ticks in pictures)
    if options.write:
        ffmpeg(*source, '-vf', 'split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none:diff_mode=rectangle', '-y', FILM, data=data)
    made, kept = raw(*source, data=data), raw('-i', FILM)
    check.that('the film is small enough for a page', FILM.stat().st_size < MOST_BYTES, FILM.stat().st_size)
    check.equal('it is as long as the scene', len(kept), len(made))
    for number, (a, b) in enumerate(zip(made, kept)):
        check.that(f'picture {number} is that of the page', differing(a, b) <= SHARE, differing(a, b))
    print(f'{check.passed} passed, {len(check.failed)} failed: {len(kept)} pictures, {FILM.stat().st_size} bytes')
    return 1 if check.failed else 0


if __name__ == '__main__':
    sys.exit(main())
