"""Figures as files for the tests of `gradus figure`: made, refused, and as other programs see them."""
import json
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import command
from command import GRADUS, check, equal

PROGRAMS = ("rsvg-convert", "pdftoppm", "pdftotext", "pdfinfo", "qpdf", "ffmpeg", "ffprobe")
LINE = ["bresenham_line", "--from", "0,0", "--to", "7,3"]  # steps 0 to 7; p = 2·3 − 7 = −1 at first
SVG = "{http://www.w3.org/2000/svg}"


def gradus(*words, **options):
    options.setdefault("timeout", 120)
    return subprocess.run([GRADUS, *words], capture_output=True, text=True, **options)


def figure(*words, to, about=LINE):
    """A figure that must come out; its path."""
    result = gradus("figure", *about, *words, "-o", to)
    if result.returncode != 0:
        raise RuntimeError(f"{words} -o {to}: {result.returncode} {result.stderr}")
    return to


def refused(expected, *words, about=LINE, to="refused.svg", code=2):
    """One line that says what was expected and found; nothing written."""
    before = sorted(os.listdir())
    result = gradus("figure", *about, *words, "-o", to)
    right = expected.fullmatch(result.stderr) if hasattr(expected, "fullmatch") else result.stderr == f"gradus: {expected}\n"
    check(right and result.returncode == code and result.stdout == "" and result.stderr.count("\n") == 1,
          f"{words} -o {to}\n    expected: {getattr(expected, 'pattern', expected)}\n    found:    {result.returncode} {result.stderr!r}")
    equal(sorted(os.listdir()), before, f"{words}: nothing is written")


def run(*words):
    return subprocess.run(words, check=True, capture_output=True).stdout


def read(path):
    with open(path, "rb") as file:
        return file.read()


# --- What other programs see -----------------------------------------------------------------------------------------


def pixels(path, *filters):
    """RGBA samples of a picture's first frame."""
    chosen = ["-vf", ",".join(filters)] if filters else []
    return run("ffmpeg", "-v", "error", "-i", path, *chosen, "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "rgba", "-")


def probed(path, *entries):
    """What ffprobe says of the film."""
    return json.loads(run("ffprobe", "-v", "error", "-count_frames", "-show_streams", "-show_format", "-show_frames",
                          "-print_format", "json", path))


def png_size(path):
    data = read(path)
    return int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big")


def pdf_info(path):
    return dict(line.split(":", 1) for line in run("pdfinfo", path).decode().splitlines() if ":" in line)


def page_size(path):
    """Points."""
    width, height = re.match(r"\s*([\d.]+) x ([\d.]+) pts", pdf_info(path)["Page size"]).groups()
    return float(width), float(height)


def page_count(path):
    run("qpdf", "--check", path)
    return int(run("qpdf", "--show-npages", path))


def pdf_text(path, page):
    text = run("pdftotext", "-f", str(page), "-l", str(page), "-raw", path, "-").decode()
    return " ".join(text.replace("\u00a0", " ").split())


def svg(path):
    return ElementTree.parse(path).getroot()


def by_id(root):
    """The drawn elements as (slot, data-id): their other attributes and texts, in order."""
    found = {}
    for slot in root.iter(SVG + "g"):
        if not slot.get("class", "").startswith("slot-"):
            continue
        for element in slot.iter():
            if element.get("data-id"):
                shape = {name: value for name, value in element.attrib.items() if name != "data-id"}
                found.setdefault((slot.get("id"), element.get("data-id")), []).append(
                    (element.tag, shape, "".join(element.itertext())))
    return found


def texts(root):
    """The texts by (slot, data-id), for a figure made with --svg-text text."""
    return {key: [text for tag, _, text in shapes if tag == SVG + "text"][-1].replace("\u00a0", " ")
            for key, shapes in by_id(root).items() if any(tag == SVG + "text" for tag, _, _ in shapes)}


def slot_text(root, slot):
    return " ".join(text for (owner, _), text in texts(root).items() if owner == slot)


def described(root):
    return tuple(root.find(SVG + name).text.replace("\u00a0", " ") for name in ("title", "desc"))


def difference(a, b):
    """The share of samples that differ by more than 3/8 of the range: rims of letters may, areas may not."""
    if len(a) != len(b):
        return 1
    return sum(abs(p - q) > 96 for p, q in zip(a, b)) / len(a)


def main(names):
    missing = [name for name in PROGRAMS if not shutil.which(name)]
    if missing:
        print("missing:", ", ".join(missing))
        return 77
    wanted = sys.argv[2:]
    return command.run_all({name: test for name, test in names.items() if not wanted or name in wanted})
