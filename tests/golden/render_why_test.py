#!/usr/bin/env python3
"""`gradus render --why` as a figure, and the page of a rendered picture, which tells of each pixel what --why tells.

    tests/golden/render_why_test.py [GRADUS]
"""
import base64
import json
import pathlib
import random
import re
import sys
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal
from renders import LETTER, Picture, gradus, picture, read, write

SMALL = ["--size", "120x90"]
SEED = 20261125


# --- The page's data, read as text_pack.hpp says -----------------------------------------------------------------


class Bytes:
    def __init__(self, data, at=0):
        self.data, self.at = data, at

    def byte(self):
        self.at += 1
        return self.data[self.at - 1]

    def whole(self):
        value = shift = 0
        while True:
            byte = self.byte()
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def signed(self):
        value = self.whole()
        return -(value + 1) // 2 if value & 1 else value // 2


def number_text(value, decimals):
    digits = str(abs(value)).rjust(decimals + 1, "0")
    point = len(digits) - decimals
    return ("-" if value < 0 else "") + digits[:point] + ("." + digits[point:] if decimals else "")


class Page:
    def __init__(self, path):
        self.html = pathlib.Path(path).read_text(encoding="utf-8")
        self.data = json.loads(re.search(r'<script type="application/json" id="gradus-picture">(.*?)</script>', self.html, re.S)[1])
        self.png = base64.b64decode(re.search(r'src="data:image/png;base64,([^"]*)"', self.html)[1])
        self.known = {}

    def block(self, packed):
        """The lines of each text."""
        if packed not in self.known:
            self.known[packed] = list(self.read(zlib.decompress(base64.b64decode(packed))))
        return self.known[packed]

    def read(self, data):
        forms = Bytes(data)
        end = forms.whole() + forms.at
        places = Bytes(data, end)
        digits = Bytes(data, places.whole() + places.at)
        last = {}
        while forms.at < end:
            lines = []
            for _ in range(forms.whole()):
                form, place, line = forms.whole(), 0, ""
                for character in self.data["forms"][form]:
                    if character not in "\1\2":
                        line += character
                        continue
                    decimals = places.byte() if character == "\1" else 0
                    key = form, place, decimals
                    last[key] = last.get(key, 0) + digits.signed()
                    line += number_text(last[key], decimals) if character == "\1" else f"#{last[key]:06x}"
                    place += 1
                lines.append(line)
            yield lines

    def told(self, column, row):
        """What the page tells of a pixel."""
        text = ""
        for line in self.block(self.data["rows"][row])[column]:
            if line.startswith("\3"):
                block, place = divmod(int(line[1:]), self.data["sharedInBlock"])
                text += "".join(f"{part}\n" for part in self.block(self.data["shared"][block])[place])
            else:
                text += f"{line}\n"
        return text


def page_of(*words):
    equal(gradus("render", *words, "-o", "page.html", "-q", "-f").code, 0, f"{words}")
    return Page("page.html")


def same_stories(page, count, *words):
    """Some pixels of the page are told as `gradus render --why` tells them."""
    numbers = random.Random(f"{SEED} {words}")
    for _ in range(count):
        column, row = numbers.randrange(page.data["width"]), numbers.randrange(page.data["height"])
        equal(page.told(column, row), gradus("render", *words, "--why", f"{column},{row}").out, f"{words}: {column},{row}")


# --- The page ----------------------------------------------------------------------------------------------------


def test_page_tells_what_why_tells():
    for count, words in ((8, ["spot.json", "--size", "64x36"]), (2, ["town.json", "--hidden-surfaces", "farthest_vertex", "--size", "48x27"]),
                         (4, ["cornell_box.json", "--shading", "gouraud", "--aa", "none", "--size", "20x20"]),
                         (4, [LETTER, "--shading", "wireframe", "--size", "48x36"]), (1, [LETTER, "--size", "1x1"])):
        page = page_of(*words)
        width, height = page.data["width"], page.data["height"]
        equal((len(page.data["rows"]), {len(page.block(row)) for row in page.data["rows"]}), (height, {width}), f"{words}: a text per pixel")
        equal(Picture(page.png).pixels, picture(*words, "--engine", "textbook").pixels, f"{words}: the picture")
        same_stories(page, count, *words)


def test_odd_names_stay_what_they_are():
    """Digits, signs and colours in names, and what ends a script, are told as they are."""
    names = ["F-16 #0a80ff -0 007 -0.50 1e-05 12345678901234567890.25", "</script><script>alert(1)</script><!--", "#12345 #1234567 .5 5. \u00e9\u4e2d\u202e\x1b"]
    write("square.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n")
    write("odd.json", json.dumps({"camera": {"eye": [0, 0, 9], "target": [0, 0, 0]},
                                  "objects": [{"name": name, "model": "square.obj", "place": [{"translate": [0, 0, z]}]} for z, name in enumerate(names)]}))
    page = page_of("odd.json", "--size", "24x18")
    equal(page.html.count("<script"), 2, "no script of others")
    for pixel in (12, 9), (0, 0), (13, 8):
        told = gradus("render", "odd.json", "--size", "24x18", "--why", f"{pixel[0]},{pixel[1]}").out
        equal(page.told(*pixel), told, f"{pixel}")
    check("12345678901234567890.25" in told and "</script>" in told, f"the names are told: {told}")


def test_page_is_whole_and_made_again():
    page = page_of("spot.json", "--size", "32x18")
    check("Content-Security-Policy" in page.html and not re.search(r'(?:src|href)="(?!data:)', page.html), "nothing from elsewhere")
    check("{{" not in re.sub(r"<script.*?</script>", "", page.html, flags=re.S), "no place is left empty")
    equal(page.data["command"], "gradus render spot.json --size 32x18", "what makes its picture")
    equal(gradus("again", "page.html").code, 0, "again")
    equal(read("page-again.html"), read("page.html"), "the same bytes")


# --- The figure --------------------------------------------------------------------------------------------------


def test_figure_says_what_the_text_says():
    """The same triangles, depths and colours."""
    for pixel, words in (("60,50", ["spot.json", *SMALL]), ("3,3", ["spot.json", *SMALL]), ("60,50", ["town.json", "--hidden-surfaces", "farthest_vertex", *SMALL])):
        told = gradus("render", *words, "--why", pixel).out
        made = gradus("render", *words, "--why", pixel, "-o", "why.svg", "-f")
        equal((made.code, made.out, made.err), (0, "", "why.svg\n"), f"{words}")
        svg = read("why.svg").decode()
        depths = re.findall(r"^  7 (?:depth|drawing order) +([\d.e-]+),", told, re.M)
        equal(len(set(re.findall(r'data-id="depth (\d+)"', svg))), len(depths), f"a dot per triangle\n{told}")
        description = re.search(r"<desc[^>]*>(.*?)</desc>", svg)[1]
        colour = re.search(r"is (#\w+) in sRGB", told)[1]
        check(colour in description, f"{colour} in {description}")
        if not depths:
            check("No triangle covers its centre" in description, description)
            continue
        seen = re.search(r"^(.*, face \d+ \(.*\), triangle \d of \d)$", told, re.M)
        check(any(name in description for name in re.findall(r"^(\S.*, triangle \d of \d)$", told, re.M)), f"{seen}: {description}")


def test_figure_in_every_format_and_again():
    words = [LETTER, "--size", "80x60", "--why", "40,30"]
    for ending, start in (("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF")):
        equal(gradus("render", *words, "-o", f"why.{ending}").code, 0, ending)
        check(read(f"why.{ending}").startswith(start), f"{ending}: {read(f'why.{ending}')[:8]}")
        equal(gradus("again", f"why.{ending}").code, 0, f"again {ending}")
        equal(read(f"why-again.{ending}"), read(f"why.{ending}"), f"{ending} again: the same bytes")
    made = Picture(read("why.png"))
    equal((made.width, made.height), (2560, 1440), "sharp on a projector")
    equal(made.texts["gradus-command"], "gradus render letter_f.obj --size 80x60 --why 40,30", "what makes it")
    shown = Picture(read("why.png")).where(lambda p: p[0] > p[2] + 40)
    check(shown, "the letter is in it")


# --- Refusals ----------------------------------------------------------------------------------------------------


def test_refusals():
    write("mine.html", "<p>mine")
    pages = "--size: expected at most 524288 pixels in a page that tells of 2 lamps, like 724x724, found 1000x1000"
    for words, complaint in (
            (["--why", "1,2", "-o", "x.jpg"], "-o: expected a name that ends in .svg, .png or .pdf, found 'x.jpg'"),
            (["--why", "1,2", "-o", "-"], "-o: expected a name that ends in .svg, .png or .pdf, found '-'"),
            (["--why", "1,2", "-o", "x.html"], "-o: expected a name that ends in .svg, .png or .pdf, found 'x.html'"),
            (["--why", "1,2", "-o", "none/x.svg"], "-o: expected a folder that exists, found 'none'"),
            (["--why", "99,2", "--size", "9x9", "-o", "x.svg"], "--why: expected column and row like 120,88 within the picture of 9x9, found '99,2'"),
            (["-o", "x.gif"], "-o: expected a name that ends in .png or .html, found 'x.gif'"),
            (["-o", "x.html", "--size", "1000x1000"], pages),
            (["-o", "x.html", "--report"], "--report: expected a .png, for a page shows all of the picture alone, found a .html"),
            (["-o", "x.html", "--part", "0,0,9x9"], "--part: expected a .png, for a page shows all of the picture alone, found a .html"),
            (["-o", "x.html", "--background", "None"], "--background: expected a colour, for a page tells it of pixels, found 'none'"),
            (["-o", "mine.html", "--size", "9x9"], "-o: expected a new file or one that gradus made, found 'mine.html' (--force replaces it)")):
        result = gradus("render", LETTER, *words)
        equal((result.code, result.err, result.out), (2, f"gradus: {complaint}\n", ""), words)
    check(not list(pathlib.Path(".").glob("x.*")), "nothing is written")
    area = gradus("render", "cornell_box.json", "-o", "x.html").err
    most = 2097152 // (16 + 2)
    equal(area, f"gradus: --size: expected at most {most} pixels in a page that tells of 16 lamps, like 341x341, found 600x600\n", "many lamps, fewer pixels")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
