#!/usr/bin/env python3
"""What other programs make of the figures: PDF by qpdf and poppler, SVG by librsvg, all against our own PNG.

    tests/golden/files_test.py [GRADUS]

Exit 77 when one of those programs is missing.
"""
import functools
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, check

PICTURE = str(pathlib.Path(__file__).resolve().parents[2] / "examples/images/camera.png")
CASES = {
    "line": ["bresenham_line", "--from", "0,0", "--to", "7,3"],
    "window": ["bresenham_line", "--from", "262,23", "--to", "91618510,-54756195", "--window", "270,0,299,19"],
    "fill": ["flood_fill", "--method", "breadth_first"],
    "dark": ["flood_fill", "--theme", "dark"],
    "picture": ["flood_fill", "--image", PICTURE, "--at", "300,60", "--tolerance", "20"],
}
def run(*words):
    return subprocess.run(words, check=True, capture_output=True).stdout


def pixels_of_ppm(data):
    """Width, height and RGB rows of a PPM as pdftoppm writes it."""
    _, size, _, raw = data.split(b"\n", 3)
    width, height = map(int, size.split())
    return width, height, [raw[at:at + 3 * width] for at in range(0, 3 * width * height, 3 * width)]


@functools.cache
def pixels(path):
    """Width, height and RGB rows of an 8-bit PNG without interlace, or of a PPM."""
    data = open(path, "rb").read()
    if data.startswith(b"P6"):
        return pixels_of_ppm(data)
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert depth == 8 and color in (2, 6), (depth, color)
        if kind == b"IDAT":
            packed += body
        at += length + 12
    channels = 3 if color == 2 else 4
    raw, stride = zlib.decompress(packed), width * channels
    rows, before = [], bytearray(stride)
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride) if kind else ():
            a = row[x - channels] if x >= channels else 0
            b, c = before[x], before[x - channels] if x >= channels else 0
            if kind == 1:
                row[x] = (row[x] + a) & 255
            elif kind == 2:
                row[x] = (row[x] + b) & 255
            elif kind == 3:
                row[x] = (row[x] + (a + b) // 2) & 255
            elif kind == 4:
                p = a + b - c
                near = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))
                row[x] = (row[x] + near[2]) & 255
        before = row
        if channels == 4:
            opaque = bytearray(3 * width)
            for at in range(3):
                opaque[at::3] = row[at::4]
            row = opaque
        rows.append(row)
    return width, height, rows


def differing(one, other):
    """The share of samples that differ by more than 3/8 of the range: rims of letters may, areas may not."""
    (w, h, a), (w2, h2, b) = pixels(one), pixels(other)
    if (w, h) != (w2, h2):
        return 1
    return sum(abs(p - q) > 96 for r, s in zip(a, b) if r != s for p, q in zip(r, s) if p != q) / (3 * w * h)


def main():
    missing = [name for name in ("qpdf", "pdftoppm", "pdftotext", "rsvg-convert") if not shutil.which(name)]
    if missing:
        print("missing:", ", ".join(missing))
        sys.exit(77)
    os.chdir(tempfile.mkdtemp())
    for name, words in CASES.items():
        for ending in ("svg", "png"):
            run(GRADUS, "figure", *words, "--step", "4", "-o", f"{name}.{ending}")
        run(GRADUS, "figure", *words, "--step", "4", "-o", f"{name}.pdf")
        run("rsvg-convert", f"{name}.svg", "-o", f"{name}-svg.png")
        run("pdftoppm", "-r", "96", "-singlefile", f"{name}.pdf", f"{name}-pdf")
        check("No syntax or stream encoding errors" in run("qpdf", "--check", f"{name}.pdf").decode(), f"{name}: qpdf")
        for other in ("svg.png", "pdf.ppm"):
            share = differing(f"{name}.png", f"{name}-{other}")
            print(f"{name}: {other} differs from png in {share:.4f} of the samples")
            check(share < (0.002 if other == "svg.png" else 0.01), f"{name}: {other}")
    check(differing("line.png", "fill.png") > 0.01, "two different figures differ")

    run(GRADUS, "figure", *CASES["line"], "-o", "deck.pdf")
    check(run("qpdf", "--show-npages", "deck.pdf").strip() == b"8", "a page per step")
    text = run("pdftotext", "-f", "5", "-l", "5", "deck.pdf", "-").decode()
    check("go NE to (4,\u00a02)" in text or "go NE to (4, 2)" in text, f"the sentence is text: {text}")
    sys.exit(command.summary())


main()
