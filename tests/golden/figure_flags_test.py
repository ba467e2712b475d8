#!/usr/bin/env python3
"""A lecturer's own figures from outside: every flag of `gradus figure`, judged by what other programs make of the files.

    tests/golden/figure_flags_test.py [GRADUS] [TEST…]

Exit 77 when one of those programs is missing.
"""
import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, check, equal

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = ("rsvg-convert", "pdftoppm", "pdftotext", "pdfinfo", "qpdf", "ffmpeg", "ffprobe")
LINE = ["bresenham_line", "--from", "0,0", "--to", "7,3"]  # steps 0 to 7; p = 2·3 − 7 = −1 at first
LONG = ["bresenham_line", "--from", "-600,0", "--to", "600,301"]
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


# --- Any slide -------------------------------------------------------------------------------------------------------


def test_sizes():
    cm = 96 / 2.54
    for words, (width, height) in {
            (): (1280, 720), ("--size", "1280x720"): (1280, 720), ("--size", "16:9"): (1280, 720),
            ("--size", "4:3"): (960, 720), ("--size", "1:1"): (720, 720), ("--size", "9:16"): (720, 1280),
            ("--size", "12cmx8cm"): (12 * cm, 8 * cm), ("--size", "120mm x 80mm"): (12 * cm, 8 * cm),
            ("--size", "5inx4in"): (480, 384), ("--size", "640x360"): (640, 360)}.items():
        root = svg(figure(*words, to="a.svg"))
        box = [float(n) for n in root.get("viewBox").split()]
        check(max(abs(a - b) for a, b in zip(box, [0, 0, width, height])) < 0.01, f"{words}: viewBox {box}")
        check(all(abs(float(root.get(side).removesuffix("px")) - length) < 0.01
                  for side, length in (("width", width), ("height", height))), f"{words}: {root.get('width')}")
        found = png_size(figure(*words, to="a.png"))
        check(all(abs(a - b) < 1 for a, b in zip(found, (width, height))), f"{words}: PNG {found}")
        found = page_size(figure(*words, "--step", "4", to="a.pdf"))
        check(all(abs(a - 0.75 * b) < 0.01 for a, b in zip(found, (width, height))), f"{words}: PDF {found}")


def test_aspects_are_arranged_anew():
    """The slots fill each slide: a letterbox would leave bars at two sides."""
    for size in ("1280x720", "960x720", "720x720", "720x1280"):
        root = svg(figure("--size", size, to="a.svg"))
        width, height = (int(n) for n in size.split("x"))
        right, bottom = 0, 0
        for shapes in by_id(root).values():
            for tag, shape, _ in shapes:
                if tag == SVG + "rect":
                    right = max(right, float(shape["x"]) + float(shape["width"]))
                    bottom = max(bottom, float(shape["y"]) + float(shape["height"]))
        check(right > 0.95 * width and bottom > 0.9 * height, f"{size}: used to {right}, {bottom}")
        for about in (LINE, ["flood_fill"], ["bresenham_circle"]):
            shapes = by_id(svg(figure("--size", size, "--svg-text", "text", to="a.svg", about=about)))
            margin = float(shapes[("sentence", "bar")][0][1]["x"])
            check(float(shapes[("drawing", "y axis")][0][1]["x"]) >= margin - 0.01, f"{about[0]} {size}: the axis' name keeps out of the margin")


def test_scale():
    figure("--size", "640x360", "--step", "4", to="one.png")
    figure("--size", "640x360", "--step", "4", "--scale", "2", to="two.png")
    figure("--size", "640x360", "--step", "4", "--scale", "0.5", to="half.png")
    equal((png_size("two.png"), png_size("half.png")), ((1280, 720), (320, 180)), "pixels")
    share = difference(pixels("one.png"), pixels("two.png", "scale=640:360:flags=area"))
    check(share < 0.01, f"twice the pixels, the same picture: {share}")
    coarser = difference(pixels("one.png"), pixels("half.png", "scale=640:360:flags=neighbor"))
    check(coarser > 2 * share, f"half is coarser: {coarser}, twice {share}")
    refused("--scale: expected at most 16384 pixels a side, found 65536 x 65536", "--size", "8192x8192", "--scale", "8", to="a.png")
    refused("--scale: expected at most 16384 pixels a side, found 32768 x 1280", "--size", "4096x160", "--scale", "8", to="a.gif")


def test_background():
    figure("--background", "none", "--step", "4", to="none.png")
    samples = pixels("none.png")
    equal(samples[:4][3], 0, "the corner is transparent")
    opaque = sum(a == 255 for a in samples[3::4]) / (len(samples) / 4)
    check(0.02 < opaque < 0.9, f"texts and panels are not: {opaque}")
    check(svg(figure("--background", "none", to="none.svg")).find(SVG + "rect") is None, "no ground in the SVG")
    check(svg(figure(to="with.svg")).find(SVG + "rect").get("id") == "paper", "else there is one")
    figure("--background", "none", "--step", "4", to="none.pdf")
    run("pdftocairo", "-png", "-transp", "-singlefile", "none.pdf", "none-pdf")
    equal(pixels("none-pdf.png")[3], 0, "no ground in the PDF")
    figure("--step", "4", to="with.pdf")
    run("pdftocairo", "-png", "-transp", "-singlefile", "with.pdf", "with-pdf")
    equal(pixels("with-pdf.png")[3], 255, "else there is one")
    for color, theme in (("#fff0d0", "light"), ("#102030", "dark"), ("#f0f0f0", "greyscale"), ("#000000", "dark")):
        figure("--background", color, "--theme", theme, to="ground.png")
        equal("#" + pixels("ground.png")[:3].hex(), color, f"the corner of {theme}")
        figure("--background", color, "--theme", theme, to="ground.svg")
        equal(svg("ground.svg").find(SVG + "rect").get("fill"), color, "ground of the SVG")
    for color, theme in (("#777777", "light"), ("#ffffff", "dark"), ("black", "high-contrast")):
        refused(re.compile(r"gradus: --background: expected a ground on which the .* of theme \w+ keep [\d.]+:1, "
                           r"found '#[0-9a-f]{6}' with [\d.]+:1\n"), "--background", color, "--theme", theme)
    refused(re.compile(r"gradus: --background: expected a colour .*, found '#12345'\n"), "--background", "#12345")
    refused("--background: expected a ground for mp4, which has no transparency (gif, webp), found none",
            "--background", "none", to="a.mp4")


def test_crop():
    for size in ("1280x720", "1:1"):
        for slots in ("drawing", "drawing,sentence", "table", "title,drawing,listing,table,sentence,footer"):
            gradus("figure", *LINE, "--size", size, "--slots", slots, "--crop", "-o", "crop-{step}.svg")
            boxes = {svg(f"crop-{n}.svg").get("viewBox") for n in range(8)}
            equal(len(boxes), 1, f"{size} {slots}: one size for all steps")
            width, height = (float(n) for n in boxes.pop().split()[2:])
            full = [float(n) for n in svg(figure("--size", size, "--slots", slots, to="full.svg")).get("viewBox").split()[2:]]
            check(width <= full[0] and height <= full[1], f"{size} {slots}: {width} x {height} of {full}")
            if slots != "title,drawing,listing,table,sentence,footer":
                check(width * height < 0.95 * full[0] * full[1], f"{size} {slots} is smaller: {width} x {height}")


def test_slots_and_layout():
    root = svg(figure("--no-title", to="a.svg"))
    slots = [g.get("id") for g in root.iter(SVG + "g") if g.get("class", "").startswith("slot-")]
    equal(sorted(slots), ["drawing", "footer", "listing", "sentence", "table"], "--no-title")
    for name in ("drawing", "table", "sentence"):
        root = svg(figure("--slots", name, to="a.svg"))
        equal([g.get("id") for g in root.iter(SVG + "g") if g.get("class", "").startswith("slot-")], [name], f"--slots {name}")
    lines, letters = {}, {}
    for layout in ("slide", "handout"):
        root = svg(figure("--layout", layout, "--svg-text", "text", "--step", "4", to="a.svg"))
        lines[layout] = sum(key.startswith("line ") for _, key in texts(root))
        letters[layout] = min(float(text.get("font-size")) for text in root.iter(SVG + "text"))
    check(lines["handout"] > lines["slide"], f"a handout has more source: {lines}")
    check(letters["handout"] < letters["slide"] and letters["slide"] >= 18, f"in smaller letters: {letters}")


def test_themes():
    pictures = {name: pixels(figure("--theme", name, "--size", "640x360", "--step", "4", to=f"{name}.png"))
                for name in ("light", "dark", "greyscale", "high_contrast", "print")}
    equal(len(set(pictures.values())), 5, "five themes")
    grey = pictures["greyscale"]
    check(grey[0::4] == grey[1::4] == grey[2::4], "greyscale has only greys")
    check(max(pictures["dark"][:3]) < 64 and min(pictures["light"][:3]) > 192, "dark and light")


def test_axes_and_slots_stay():
    cases = [(LINE, 7, ()), (LINE, 7, ("--size", "4:3", "--crop")), (LINE, 7, ("--language", "de", "--layout", "handout")),
             (["bresenham_circle", "--center", "0,0", "--radius", "4"], 3, ("--size", "1:1")),
             (["flood_fill", "--method", "breadth_first"], 8, ("--size", "720x1280")),
             (LONG, 7, ("--view", "-600,0,-585,9"))]
    for about, last, words in cases:
        gradus("figure", *about, *words, "--steps", f"0-{last}", "-o", "s{step}.svg")
        places = []
        for step in range(last + 1):
            shapes = by_id(svg(f"s{step}.svg"))
            fixed = {key: value for key, value in shapes.items()
                     if re.fullmatch(r"(x|y|row|column) (axis|[−\d]+)|grid|panel|heading .*|title|input|method|ideal.*(?<!name)", key[1])}
            places.append(fixed)
        names = {key[1].split()[0] for key in places[0]}
        check({"x", "y", "grid", "panel", "title", "heading"} <= names, f"{about[0]}: {names}")
        check(all(place == places[0] for place in places), f"{about[0]} {words}: axes and slots stay")


def test_svg_groups():
    for about, words in ((LINE, ()), (["bresenham_circle"], ("--theme", "dark", "--svg-text", "text")), (["flood_fill"], ("--crop",))):
        root = svg(figure(*words, "--step", "3", to="a.svg", about=about))
        ids = [element.get("id") for element in root.iter() if element.get("id")]
        equal(len(ids), len(set(ids)), "ids are unique")
        slots = [child for child in root if child.tag == SVG + "g"]
        equal(sorted(slot.get("id") for slot in slots), ["drawing", "footer", "listing", "sentence", "table", "title"], "a group a slot")
        for slot in slots:
            equal(slot.get("class"), "slot-" + slot.get("id"), "its class")
            for group in slot:
                kind = group.get("class", "").removeprefix("role-").removeprefix("tone-")
                check(group.tag == SVG + "g" and re.fullmatch(rf"{slot.get('id')}-{kind}(-\d+)?", group.get("id", "")) and kind,
                      f"a group a role: {group.get('id')} {group.get('class')}")
        title, desc = described(root)
        check(title.endswith(re.search(r"step 3 of \d+", desc)[0]), f"title: {title}")
        printed = gradus("run", *about, "--steps", "3").stdout.replace("\u00a0", " ").splitlines()
        sentence = [line.split("  ")[-1] for line in printed if line.endswith(".")][-1]
        check(sentence in desc, f"{sentence} in {desc}")
        equal(root.get("role"), "img", "for screen readers")
        for word in root.get("aria-labelledby").split():
            check(word in ids, f"{word} is there")


def test_svg_text():
    figure("--step", "4", "--svg-text", "text", to="text.svg")
    figure("--step", "4", to="outlines.svg")
    check(not list(svg("outlines.svg").iter(SVG + "text")), "outlines are no text")
    sentence = slot_text(svg("text.svg"), "sentence")
    equal(sentence, "p = 3 > 0: the line passes above the midpoint M, so go NE to (4, 2); p = 3 + 2·(3 − 7) = −5.",
          "the sentence can be searched")
    check(sentence in described(svg("text.svg"))[1] and sentence in described(svg("outlines.svg"))[1], "and describes both")
    for name in ("text", "outlines"):
        run("rsvg-convert", "--width", "640", f"{name}.svg", "-o", f"{name}.png")
    share = difference(pixels("text.png"), pixels("outlines.png"))
    check(share < 0.01, f"both look alike: {share}")


# --- Her notation ----------------------------------------------------------------------------------------------------

LABELS = ["--label", "p=d", "--label", "NE=T"]
NAMES = "T = NE, d = p in the code"


def test_labels():
    plain = texts(svg(figure("--step", "4", "--svg-text", "text", to="plain.svg")))
    own = texts(svg(figure(*LABELS, "--step", "4", "--svg-text", "text", to="own.svg")))
    listed = [key for key in own if key[0] == "listing" and key in plain]  # a longer title may leave it fewer lines
    check(len(listed) > 10, f"lines of the listing: {listed}")
    equal([own[key] for key in listed], [plain[key] for key in listed], "the source stays as it is")
    check(any("p +=" in text for text in own.values()), "with its own p")
    equal(own[("table", "heading p")], "d", "the table's heading")
    check("d > 0" in own.values() and "T" in own.values(), f"its cells: {own}")
    equal(own[("drawing", "chosen name")], "T chosen", "the drawing")
    sentence = "d = 3 > 0: the line passes above the midpoint M, so go T to (4, 2); d = 3 + 2·(3 − 7) = −5."
    equal(" ".join(text for key, text in own.items() if key[0] == "sentence"), sentence, "the sentence")
    check(sentence in described(svg("own.svg"))[1], "its description")
    rest = " ".join(text for key, text in own.items() if key[0] != "listing")
    check(NAMES in rest, "what the code calls them")
    rest = rest.replace(NAMES, "")
    check(not re.search(r"\b(p|NE)\b", rest), f"none is left: {rest}")
    figure(*LABELS, to="own.pdf")
    check(sentence in pdf_text("own.pdf", 5) and "T chosen" in pdf_text("own.pdf", 5), pdf_text("own.pdf", 5))
    page = read(figure(*LABELS, to="own.html")).decode().replace("\u00a0", " ")
    check(sentence in page and "NE's side" not in page, "the player's data")
    for ending, cells in {"md": "| 3 | 3 | 1 | 3 | d \\> 0 | T |", "tex": "$3$ & $3$ & $1$ & $3$ & $d > 0$ & T \\\\",
                          "csv": '3,1,3,d > 0,T,"d = −3'}.items():
        check(cells in read(figure(*LABELS, to=f"own.{ending}")).decode(), f"{ending}: {cells}")
    table = gradus("run", *LINE, *LABELS).stdout.replace("\u00a0", " ")
    check(sentence in table and re.search(r"\bk +x +y +d +test +step\b", table) and " NE" not in table.replace(NAMES, ""), table)
    refused(re.compile(r"gradus: --label: expected one of the symbols E, .*, found 'q'.*\n"), "--label", "q=d")
    refused(re.compile(r"gradus: --label: expected letters that can be drawn \(.*U\+2603.*\), found '☃'\n"), "--label", "p=☃")
    refused(re.compile(r"gradus: --title: expected letters .*U\+1F600.*\n"), "--title", "😀")
    refused(re.compile(r"gradus: --caption: expected letters .*\n"), "--caption", "漢字")


def test_language():
    own = texts(svg(figure("--language", "de", *LABELS, "--step", "4", "--svg-text", "text", to="a.svg")))
    everything = " ".join(text for key, text in own.items() if key[0] != "listing")
    for word in ("Bresenham-Linie", "Schritt 4 / 7", "verworfen", "gewählt", "Mittelpunkt", "Entscheidungsvariable"):
        check(word in everything, f"{word} in {everything}")
    check(not re.search(r"\b(the|chosen|rejected|step|error)\b", everything), f"no English in {everything}")
    check("d = 3 + 2·(3 − 7) = −5" in everything, "the same numbers, under the same labels")
    english = texts(svg(figure("--step", "4", "--svg-text", "text", to="b.svg")))
    listed = [key for key in own if key[0] == "listing" and key in english]
    equal([own[key] for key in listed], [english[key] for key in listed], "source")
    check(len(listed) > 10, f"lines of the listing: {listed}")
    check("Schritt 4 von 7" in described(svg("a.svg"))[0], described(svg("a.svg"))[0])
    check("Schritt" in gradus("run", *LINE, "--language", "de").stdout, "gradus run")


def test_title_and_caption():
    words = ["--title", "Unit 3: \"lines\" & <more>", "--caption", "See § 4 — 100 %."]
    root = svg(figure(*words, "--step", "4", "--svg-text", "text", to="a.svg"))
    title, desc = described(root)
    equal(texts(root)[("title", "title")], words[1], "the title that is drawn")
    check(title == words[1] + ", step 4 of 7" and desc.startswith(words[3] + " "), f"{title} | {desc}")
    info = pdf_info(figure(*words, to="a.pdf"))
    check(words[1] in info["Title"] and info.get("Subject", "").strip().startswith(words[3]), f"{info}")
    check(words[1] in pdf_text("a.pdf", 3), "the title on a page")
    page = read(figure(*words, to="a.html")).decode()
    check("Unit 3: &quot;lines&quot; &amp; &lt;more&gt;" in page and words[3] in page, "the player")
    tags = json.loads(run("ffprobe", "-v", "error", "-show_entries", "format_tags", "-print_format", "json",
                          figure(*words, "--steps", "1-2", "--size", "640x360", to="a.mp4")))["format"]["tags"]
    check(words[1] in tags["title"] and "See § 4" in tags["comment"], f"{tags}")
    for ending in ("svg", "png"):
        snippet = gradus("figure", *LINE, *words, "--step", "4", "-o", f"s.{ending}", "--snippet", "markdown").stdout
        check(snippet.startswith("![See § 4"), snippet)


def test_y_down_turns_only_the_drawing():
    up = texts(svg(figure("--step", "4", "--svg-text", "text", to="up.svg")))
    down = texts(svg(figure("--step", "4", "--svg-text", "text", "--y", "down", to="down.svg")))
    for slot in ("table", "sentence", "listing", "footer", "title"):
        equal({k: v for k, v in down.items() if k[0] == slot}, {k: v for k, v in up.items() if k[0] == slot}, slot)
    def row_at(name, row):
        return float(by_id(svg(name))[("drawing", f"y {row}")][0][1]["y"])
    check(row_at("up.svg", 0) > row_at("up.svg", 3) and row_at("down.svg", 0) < row_at("down.svg", 3), "the rows run down")
    cell = by_id(svg("down.svg"))[("drawing", "outline 4,2")][0][1]
    check(abs(float(cell["y"]) + float(cell["height"]) / 2 - row_at("down.svg", 2)) < 20, "cells stand in their rows")


# --- Reveal ----------------------------------------------------------------------------------------------------------


def test_steps():
    gradus("figure", *LINE, "--steps", "auto", "-o", "auto-{step}.svg")
    equal(sorted(os.listdir()), ["auto-0.svg", "auto-1.svg", "auto-2.svg", "auto-7.svg"],
          "the first, an E, an NE, the last")
    figure("--steps", "auto", to="auto.pdf")
    equal(page_count("auto.pdf"), 4, "as pages")
    check("step 2 / 7" in pdf_text("auto.pdf", 3) and "step 7 / 7" in pdf_text("auto.pdf", 4), "these")
    figure("--steps", "1,4,6-7", to="some.pdf")
    equal([re.search(r"step (\d+) / 7", pdf_text("some.pdf", page + 1))[1] for page in range(page_count("some.pdf"))],
          ["1", "4", "6", "7"], "--steps 1,4,6-7")
    figure(to="all.pdf")
    equal(page_count("all.pdf"), 8, "a page a step")


def test_handout():
    sizes = {"a4": (595.28, 841.89), "letter": (612, 792)}
    for paper, (width, height) in sizes.items():
        for grid, a_page in (("2x3", 6), ("1x2", 2), ("4x6", 24)):
            figure("--handout", grid, "--paper", paper, to="h.pdf")
            found = page_size("h.pdf")
            check(abs(found[0] - width) < 0.1 and abs(found[1] - height) < 0.1, f"{paper}: {found}")
            equal(page_count("h.pdf"), math.ceil(8 / a_page), f"pages of {grid}")
            shown = [n for page in range(page_count("h.pdf")) for n in re.findall(r"step (\d) / 7", pdf_text("h.pdf", page + 1))]
            equal(shown, list("01234567"), f"{grid}: every step once, in order")
    check("p = 3 + 2·(3 − 7) = −5." in pdf_text(figure("--handout", "2x3", to="h.pdf"), 1), "with its sentence")
    refused("--handout: expected pdf, found svg", "--handout", "2x3")
    for word in ("0x3", "5x1", "2x7", "2", "x", "axb", "-1x2"):
        refused(f"--handout: expected columns and rows of a page like 2x3, at most 4x6, found '{word}'", f"--handout={word}", to="a.pdf")
    refused("--paper: expected one of a4, letter, found 'a5', did you mean 'a4'?", "--paper", "a5", to="a.pdf")


def shown_files(text):
    """Files that a snippet names, each with its page or nothing."""
    found = re.findall(r"\\includegraphics(?:<\d+>)?\[(?:page=(\d+),)?[^]]*\]\{([^}]*)\}", text)
    found += [("", name) for name in re.findall(r'(?:src)="([^"#]*)', text)]
    found += [(page, name) for name, page in re.findall(r"\(<([^>#]*)(?:#page=(\d+))?>\)", text)]
    return [(name, int(page) if page else None) for page, name in found]


def test_snippets():
    cases = {"beamer": ["pdf", "png", "handout"], "reveal": ["svg", "png", "html", "gif", "mp4", "webp"],
             "markdown": ["svg", "png", "gif", "pdf", "handout"]}
    for kind, endings in cases.items():
        for ending in endings:
            for series in ((False, True) if ending in ("svg", "png", "pdf") else (False,)):
                words = {"handout": ["--handout", "2x3"], "html": []}.get(ending, ["--size", "640x360"])
                name = f"{kind}-{ending}{'-{step}' if series else ''}.{'pdf' if ending == 'handout' else ending}"
                some = [] if ending == "handout" else ["--steps", "auto" if ending != "html" else "0-7"]
                if ending in ("svg", "png") and not series:
                    some = ["--step", "4"]
                result = gradus("figure", *LINE, *words, *some, "-o", name, "--snippet", kind)
                if not equal(result.returncode, 0, f"{kind} of {name}: {result.stderr}"):
                    continue
                shown = shown_files(result.stdout)
                made = [file for file in os.listdir() if re.fullmatch(re.escape(name).replace(r"\{step\}", r"\d+"), file)]
                equal(sorted({file for file, _ in shown}), sorted(made), f"{kind} names the files of {name}")
                if name.endswith(".pdf"):
                    for file in made:
                        equal([page for other, page in shown if other == file], list(range(1, page_count(file) + 1)),
                              f"{kind}: the pages of {file}")
    snippet = gradus("figure", *LINE, "--snippet", "beamer", "-o", "b.pdf").stdout
    equal(len(re.findall(r"includegraphics<\d>", snippet)), 8, "an overlay a step")
    bare = gradus("figure", *LINE, "--snippet", "beamer", "--no-title", "-o", "b.pdf").stdout
    check("\\begin{frame}{Bresenham line" in bare and "\\begin{frame}[plain]" in snippet, "the slide's title where the figure has none")


def test_tables():
    """md, tex and csv hold the cells of the table that `run` prints, and the numbers of its JSON."""
    for about in (LINE, ["bresenham_circle", "--radius", "6"], ["flood_fill", "--method", "depth_first"]):
        markdown = [[cell.strip().replace("\\", "") for cell in line.strip("|").split(" | ")]
                    for line in read(figure(to="t.md", about=about)).decode().splitlines() if line.startswith("|")]
        tex = [[re.sub(r"\$([^$]*)\$", r"\1", cell).strip() for cell in line.removesuffix(" \\\\").split("&")]
               for line in read(figure(to="t.tex", about=about)).decode().splitlines() if "&" in line]
        plain = lambda cell: cell.replace("\u00a0", " ").replace("~", " ").replace("\\", "").replace("−", "-").strip()
        equal([[plain(c) for c in row] for row in tex[1:]], [[plain(c) for c in row] for row in markdown[2:]], f"{about[0]}: tex and md")
        import csv
        import io
        rows = list(csv.reader(io.StringIO(read(figure(to="t.csv", about=about)).decode(), newline="")))
        columns = len(markdown[0])
        equal([[plain(c) for c in row[3:3 + columns]] for row in rows[1:]],
              [[plain(c) for c in row] for row in markdown[2:]], f"{about[0]}: csv and md")
        equal(rows[0][:3] + rows[0][-1:], ["number", "type", "line", "sentence"], "what csv says beside")
        data = json.loads(gradus("run", *about, "--json").stdout)
        steps = {str(step["number"]): (step["type"], str(step["line"])) for step in data["steps"] if "fine" not in step}
        equal({row[0]: (row[1], row[2]) for row in rows[1:]},
              {number: step for number, step in steps.items() if step[0] != "Started" or about[0] != "flood_fill"},
              f"{about[0]}: csv and JSON")
        printed = gradus("run", *about).stdout
        for row in rows[1:]:
            check(row[-1] in printed, f"the table has {row[-1]}")


# --- Moving pictures -------------------------------------------------------------------------------------------------


def webp_frames(path):
    """Loop count, and of each frame its delay in milliseconds; read from the file's chunks."""
    data, at, loop, delays = read(path), 12, None, []
    equal(int.from_bytes(data[4:8], "little") + 8, len(data), f"{path}: whole")
    while at < len(data):
        kind, length = data[at:at + 4], int.from_bytes(data[at + 4:at + 8], "little")
        body = data[at + 8:at + 8 + length]
        if kind == b"VP8X":
            size = (int.from_bytes(body[4:7], "little") + 1, int.from_bytes(body[7:10], "little") + 1)
        if kind == b"ANIM":
            loop = int.from_bytes(body[4:6], "little")
        if kind == b"ANMF":
            delays.append(int.from_bytes(body[12:15], "little"))
        at += 8 + length + length % 2
    return size, loop, delays


def test_films():
    timing = ["--seconds-per-step", "0.5", "--hold-last", "2", "--transition", "none"]
    small = ["--size", "640x360", *timing]
    figure(*small, "--loop", "3", to="a.gif")
    film = probed("a.gif")
    equal((film["streams"][0]["codec_name"], film["streams"][0]["width"], film["streams"][0]["height"]), ("gif", 640, 360), "GIF")
    equal([float(frame["pkt_duration_time"]) for frame in film["frames"]], 7 * [0.5] + [2.0], "a frame a step, the last longer")
    data = read("a.gif")
    at = data.index(b"NETSCAPE2.0")
    equal(int.from_bytes(data[at + 13:at + 15], "little"), 2, "three times: two repetitions")
    forever = read(figure(*small, to="b.gif"))
    equal(forever[forever.index(b"NETSCAPE2.0") + 13:][:2], b"\0\0", "for ever")
    check(b"NETSCAPE2.0" not in read(figure(*small, "--loop", "1", to="c.gif")), "once")
    last = figure("--size", "640x360", "--step", "last", to="last.png")
    run("ffmpeg", "-v", "error", "-i", "a.gif", "-vf", "select=eq(n\\,7)", "-frames:v", "1", "gif-last.png")
    check(difference(pixels(last), pixels("gif-last.png")) < 0.001, "its last frame is the last step")

    figure(*small, "--fps", "30", to="a.mp4")
    film = probed("a.mp4")
    stream = film["streams"][0]
    equal((stream["codec_name"], stream["pix_fmt"], stream["width"], stream["height"], stream["r_frame_rate"]),
          ("h264", "yuv420p", 640, 360, "30/1"), "MP4")
    equal(int(stream["nb_read_frames"]), 7 * 15 + 60, "frames")
    check(abs(float(film["format"]["duration"]) - 5.5) < 0.02, "duration")
    for step in (0, 4, 7):
        seconds = 0.5 * step + 0.25
        run("ffmpeg", "-v", "error", "-y", "-ss", str(seconds), "-i", "a.mp4", "-frames:v", "1", "frame.png")
        figure("--size", "640x360", "--step", str(step), to="step.png")
        share = difference(pixels("step.png"), pixels("frame.png"))
        check(share < 0.01, f"at {seconds} s stands step {step}: {share}")
    figure("--size", "321x241", "--steps", "1-2", *timing, to="odd.mp4")
    stream = probed("odd.mp4")["streams"][0]
    equal((stream["width"], stream["height"]), (322, 242), "even sizes")

    figure(*small, "--loop", "4", "--steps", "1,4-6", to="a.webp")
    equal(webp_frames("a.webp"), ((640, 360), 4, [500, 500, 500, 2000]), "WebP")

    # What moves takes its time from the step before; stills and the whole film last as they would without
    moving = ["--size", "640x360", "--seconds-per-step", "0.5", "--hold-last", "2", "--steps", "0-3"]
    figure(*moving, "--transition", "0.1", to="moving.webp")
    equal(webp_frames("moving.webp")[2], 3 * [400, 50, 50] + [2000], "WebP that moves")
    figure(*moving, "--transition", "0.1", to="moving.gif")
    run("ffmpeg", "-v", "error", "-i", "moving.gif", "-vf", "select=eq(n\\,4)", "-frames:v", "1", "between.png")
    for step in (1, 2):
        figure("--size", "640x360", "--step", str(step), to="step.png")
        check(difference(pixels("step.png"), pixels("between.png")) > 0.001, f"between 1 and 2 stands not {step}")
    figure(*moving, to="moving.mp4")
    for step in (0, 1, 3):
        run("ffmpeg", "-v", "error", "-y", "-ss", str(0.5 * step + 0.1), "-i", "moving.mp4", "-frames:v", "1", "frame.png")
        figure("--size", "640x360", "--step", str(step), to="step.png")
        check(difference(pixels("step.png"), pixels("frame.png")) < 0.01, f"step {step} stands still in a film that moves")
    equal(int(probed("moving.mp4")["streams"][0]["nb_read_frames"]), 3 * 13 + 50, "frames of a film that moves")

    for ending in ("gif", "mp4", "webp"):
        figure(*small, "--steps", "0-3", to=f"one.{ending}")
        figure(*small, "--steps", "0-3", to=f"two.{ending}")
        equal(read(f"one.{ending}"), read(f"two.{ending}"), f"{ending}: the same bytes twice")
    figure(*small, "--steps", "0-1", "--background", "none", to="none.gif")
    equal(pixels("none.gif")[3], 0, "a transparent GIF")


def test_film_values():
    for word in ("0", "0.03", "61", "x", "-1", "1e1", "nan"):
        refused(f"--seconds-per-step: expected seconds from 0.04 to 60, found '{word}'", f"--seconds-per-step={word}", to="a.gif")
    for word in ("0", "601", "inf"):
        refused(f"--hold-last: expected seconds from 0.04 to 600, found '{word}'", f"--hold-last={word}", to="a.gif")
    for word in ("0.03", "11", "soft"):
        refused(f"--transition: expected none, or seconds from 0.04 to 10, found '{word}'", f"--transition={word}", to="a.gif")
    refused("--transition: expected gif, mp4 or webp, found svg", "--transition", "none", to="a.svg")
    for word in ("0", "61", "2.5", ""):
        refused(f"--fps: expected a whole number from 1 to 60, found '{word}'" if word else "--fps: expected N, found none",
                f"--fps={word}", to="a.mp4")
    for word in ("-1", "65536", "x"):
        refused(f"--loop: expected a whole number from 0 to 65535, found '{word}'", f"--loop={word}", to="a.gif")
    refused("--fps: expected mp4, found gif", "--fps", "30", to="a.gif")
    refused("--loop: expected gif or webp, found mp4", "--loop", "2", to="a.mp4")
    refused("--seconds-per-step: expected gif, mp4 or webp, found png", "--seconds-per-step", "2", to="a.png")
    refused(re.compile(r"gradus: --seconds-per-step: expected at least one frame, 1/5 s at --fps 5, found 0.1\n"),
            "--seconds-per-step", "0.1", "--fps", "5", to="a.mp4")


def test_films_without_ffmpeg():
    os.mkdir("bin")
    for ending in ("gif", "mp4", "webp"):
        result = gradus("figure", *LINE, "-o", f"a.{ending}", env={**os.environ, "PATH": os.path.abspath("bin")})
        equal((result.returncode, result.stderr),
              (1, "gradus: film: expected the program ffmpeg on the PATH (Debian: apt install ffmpeg), found none\n"), ending)
    # One that stops early and calls it success; one that fails
    for script, words in (("exec head -c 1000 > /dev/null", "expected"), ("echo broken codec >&2; exit 3", "broken codec")):
        with open("bin/ffmpeg", "w") as file:
            file.write(f"#!/bin/sh\nPATH={os.environ['PATH']}\n{script}\n")
        os.chmod("bin/ffmpeg", 0o755)
        result = gradus("figure", *LINE, "-o", "a.mp4", env={**os.environ, "PATH": os.path.abspath("bin")})
        check(result.returncode == 1 and result.stderr.startswith("gradus: film: ") and words in result.stderr
              and result.stderr.count("\n") == 1, f"{script}: {result.returncode} {result.stderr!r}")
    equal(sorted(os.listdir()), ["bin"], "no half-written film")


def test_films_interrupted():
    for ending in ("gif", "mp4", "webp"):
        process = subprocess.Popen([GRADUS, "figure", "bresenham_line", "--to", "3000,7", "--steps", "0-3000", "-o", f"i.{ending}"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(0.7)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=30)
        equal(process.returncode, 130, f"Ctrl-C in a {ending}")
        equal(os.listdir(), [], "nothing is left")


# --- Several drawings --------------------------------------------------------------------------------------------------


def test_several_drawings():
    for name, flags, frames in (("phases", ["--panels", "phases"], 6), ("steps", ["--panels", "1,4,7"], 3),
                                ("beside", ["--compare", "first_octant", "--to", "3,7"], 2)):
        for ending in ("svg", "png", "pdf"):
            made = f"{name}.{ending}"
            gradus("figure", "bresenham_line", *flags, "-o", made)
            gradus("again", made, "-o", f"again.{ending}")
            check(read(made) == read(f"again.{ending}"), f"again {made} gives the same bytes")
        shapes = by_id(svg(f"{name}.svg"))
        equal(sum(1 for slot, shape in shapes if slot.startswith("drawing") and shape.endswith(" frame")), frames, f"drawings of {name}")
        equal(page_count(f"{name}.pdf"), 8 if name == "beside" else 1, f"pages of {name}")
    gradus("again", "steps.svg", "--step", "4", "-o", "one.svg")
    gradus("figure", *LINE, "--step", "4", "-o", "alone.svg")
    equal(read("one.svg"), read("alone.svg"), "one step after all")
    gradus("figure", "bresenham_line", "--panels", "1,4", "-o", "page.pdf", "--handout", "1x2")
    equal(page_count("page.pdf"), 1, "on a page for print")


# --- Again -----------------------------------------------------------------------------------------------------------


def test_again():
    looks = ["--theme", "dark", "--size", "640x400", "--slots", "drawing,table,sentence", "--layout", "handout", "--y", "down",
             "--view", "0,0,7,3", "--background", "#0a0a12", *LABELS, "--language", "de", "--title", "It's \"mine\" $HOME",
             "--caption", "100 % & <more>"]
    film = ["--seconds-per-step", "0.25", "--hold-last", "1", "--transition", "0.08", "--steps", "0-3"]
    more = {"svg": ["--step", "4", "--svg-text", "text", "--crop"], "png": ["--step", "4", "--scale", "1.5"],
            "pdf": ["--steps", "auto", "--crop"], "html": None, "gif": [*film, "--loop", "2"], "mp4": [*film, "--fps", "12"],
            "webp": [*film, "--loop", "7", "--scale", "0.5"], "handout.pdf": ["--handout", "2x2", "--paper", "letter"]}
    played = ["--theme", "dark", "--y", "down", *LABELS, "--language", "de", "--title=--odd-title", "--slots", "drawing,table"]
    changes = {"svg": ["--label", "E=O"], "png": ["--scale", "2"], "pdf": ["--steps", "1-2"], "html": ["--theme", "light"],
               "gif": ["--loop", "5"], "mp4": ["--fps", "24"], "webp": ["--background", "none"], "handout.pdf": ["--paper", "a4"]}
    for name, flags in more.items():
        words = played if flags is None else [*looks, *flags]
        made, ending = f"a.{name}", name.split(".")[-1]
        figure(*words, to=made)
        result = gradus("again", made, "-o", f"again.{ending}")
        equal((result.returncode, result.stderr), (0, f"again.{ending}\n"), f"again {made}")
        check(os.path.exists(f"again.{ending}") and read(made) == read(f"again.{ending}"), f"again {made} gives the same bytes")
        change = changes[name]
        gradus("again", made, *change, "-o", f"changed.{ending}")
        changed = [word for word in words]
        if change[0] != "--label" and change[0] in changed:
            changed[changed.index(change[0]) + 1] = change[1]
        else:
            changed += change
        figure(*changed, to=f"expected.{ending}")
        check(read(f"changed.{ending}") == read(f"expected.{ending}"), f"again {made} {change} changes just that")
        check(read(f"changed.{ending}") != read(made), f"{change} changes something")


# --- Large inputs ----------------------------------------------------------------------------------------------------


def cells(root):
    """Columns, rows, and a cell's width and height, from the lines of the grid."""
    (_, shape, _), = by_id(root)[("drawing", "grid")]
    moves = re.findall(r"M(-?[\d.]+) (-?[\d.]+)([VH])(-?[\d.]+)", shape["d"])
    xs = sorted({float(x) for x, _, kind, _ in moves if kind == "V"})
    ys = sorted({float(y) for _, y, kind, _ in moves if kind == "H"})
    return len(xs) - 1, len(ys) - 1, (xs[-1] - xs[0]) / (len(xs) - 1), (ys[-1] - ys[0]) / (len(ys) - 1)


def test_large_inputs():
    picture = ["flood_fill", "--image", str(SOURCE / "examples/images/camera.png"), "--at", "300,60", "--tolerance", "20"]
    cases = [(LONG, ["0", "500", "1200"]), (["bresenham_circle", "--radius", "400"], ["0", "100", "283"]),
             (["bresenham_line", "--from", "0,0", "--to", "90000,3"], ["45000"]), (picture, ["0", "600"])]
    for about, steps in cases:
        for step in steps:
            root = svg(figure("--step", step, to="a.svg", about=about))
            columns, rows, width, height = cells(root)
            check(width >= 24 and abs(width - height) < 0.01, f"{about[0]} {step}: cells of {width} x {height}")
            shapes = by_id(root)
            for name in ("overview frame", "overview view"):
                check(("drawing", name) in shapes, f"{about[0]} {step}: {name}")
            current = [key for key in shapes if key[0] == "drawing" and key[1].startswith("outline")]
            check(current or step == "0", f"{about[0]} {step}: the current step is in view")
            for key in current:
                check(all(float(shape["width"]) > 15 for tag, shape, _ in shapes[key] if tag == SVG + "rect"), f"{key} is large")
    check(("drawing", "overview ideal circle") in by_id(svg(figure("--step", "100", to="c.svg", about=cases[1][0]))),
          "the overview of a circle shows the circle")
    check(("drawing", "overview frame") not in by_id(svg(figure(to="s.svg"))), "no overview where all is shown")


def test_view():
    for view in ((-110, 120, -90, 130), (0, 148, 7, 152), (-600, 0, -596, 3)):
        root = svg(figure("--view=" + ",".join(map(str, view)), "--step", "500", "--svg-text", "text", to="a.svg", about=LONG))
        columns, rows, width, height = cells(root)
        equal((columns, rows), (view[2] - view[0] + 1, view[3] - view[1] + 1), f"--view {view}: exactly these cells")
        check(width >= 24, f"cells of {width}")
        numbers = [int(key[1][2:].replace("−", "-")) for key in texts(root) if re.fullmatch("x [−\\d]+", key[1])]
        check(numbers and all(view[0] <= n <= view[2] for n in numbers), f"the axis: {numbers}")
    gradus("figure", *LONG, "--view=-110,120,-90,130", "--steps", "490-500", "-o", "v{step}.svg")
    equal({str(by_id(svg(f"v{n}.svg"))[("drawing", "grid")]) for n in range(490, 501)}.__len__(), 1, "it stays")
    refused(re.compile(r"gradus: --view: expected at most \d+ x \d+ cells for this size, found 901 x 31\n"), "--view", "-300,0,600,30", about=LONG)
    refused("--view: expected cells of the grid -600,0 to 600,302, found 2000,0 to 2010,5", "--view", "2000,0,2010,5", about=LONG)
    refused("--view: expected xmin <= xmax, not 5 > 3, found '5,0,3,1'", "--view", "5,0,3,1")


# --- What is written down --------------------------------------------------------------------------------------------


def shorter(command):
    """The same, where its work is what takes the time: cli_test draws the whole gallery, bench_test and stress_test measure."""
    if command.startswith("gradus bench"):
        return f"{command} --seconds 0.001 --repetitions 1"
    if command.startswith("gradus stress"):
        return re.sub(r" --seconds \d+|$", " --seconds 1", command, count=1)
    if command.startswith("gradus figures -o ") and "--only" not in command:
        return f"{command} --only 'flood_fill*'"
    return command


def commands_run(commands):
    for command in map(shorter, commands):
        result = subprocess.run(["sh", "-c", command], capture_output=True, text=True, timeout=120,
                                env={**os.environ, "PATH": f"{os.path.dirname(GRADUS)}:{os.environ['PATH']}"})
        equal((result.returncode, "gradus: " in result.stderr), (0, False), f"{command}: {result.stderr[-200:]}")
    check(len(commands) > 2, "there are commands")


def put_a_lecture():
    with open("my_lecture.json", "w") as file:
        json.dump({"figures": [{"topic": "bresenham_line", "input": {"from": "0,0", "to": "9,4"}}]}, file)


def test_commands_of_the_readme():
    put_a_lecture()
    shutil.copytree(SOURCE / "examples/models", "examples/models")
    blocks = re.findall(r"^```\n(.*?)^```", (SOURCE / "README.md").read_text(), re.M | re.S)
    commands = [re.split(r"\s{2,}#", line)[0].strip() for block in blocks for line in block.splitlines() if line.startswith("gradus ")]
    commands_run(commands)


def main():
    missing = [name for name in PROGRAMS if not shutil.which(name)]
    if missing:
        print("missing:", ", ".join(missing))
        return 77
    wanted = sys.argv[2:]
    return command.run_all({name: test for name, test in globals().items() if not wanted or name in wanted})


if __name__ == "__main__":
    sys.exit(main())
