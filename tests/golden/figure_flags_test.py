#!/usr/bin/env python3
"""A lecturer's own figures from outside: every flag of `gradus figure`, judged by what other programs make of the files.

    tests/golden/figure_flags_test.py [GRADUS] [TEST…]

Exit 77 when one of those programs is missing.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from command import GRADUS, check, equal
from figure_files import (
    LINE, SVG, by_id, described, difference, figure, gradus, main, page_count, page_size, pdf_info, pdf_text, pixels,
    png_size, read, refused, run, slot_text, svg, texts)
from renders import fewer_frames

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LONG = ["bresenham_line", "--from", "-600,0", "--to", "600,301"]


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
    refused("--scale: expected at most 16384 pixels per side, found 65536 x 65536", "--size", "8192x8192", "--scale", "8", to="a.png")
    refused("--scale: expected at most 16384 pixels per side, found 32768 x 1280", "--size", "4096x160", "--scale", "8", to="a.gif")


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
        equal(sorted(slot.get("id") for slot in slots), ["drawing", "footer", "listing", "sentence", "table", "title"], "a group per slot")
        for slot in slots:
            equal(slot.get("class"), "slot-" + slot.get("id"), "its class")
            for group in slot:
                kind = group.get("class", "").removeprefix("role-").removeprefix("tone-")
                check(group.tag == SVG + "g" and re.fullmatch(rf"{slot.get('id')}-{kind}(-\d+)?", group.get("id", "")) and kind,
                      f"a group per role: {group.get('id')} {group.get('class')}")
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
    for topic in ("painter", "back_face_culling", "bsp_tree"):
        done = gradus("run", topic, "--label", "foo=A")
        equal(done.stderr, f"gradus: --label: expected no symbol: {topic} uses none, found 'foo'\n", topic)
        check("Symbols\n  none that --label" in gradus("help", topic).stdout, topic)
    check("Symbols\n  E, M, N, NE," in gradus("help", "bresenham_line").stdout, "help lists them")
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
    # A comment behind a line is left out, and a line is broken, where a language's table leaves too little room for it
    def code(texts):
        rows = lambda slot, name: [texts.get((slot, name)), *(texts.get((slot, f"{name} row {n}")) for n in range(2, 9))]
        return [re.sub(r"//.*|\s", "", "".join(row for row in rows(*key) if row)) for key in listed if " row " not in key[1]]
    equal(code(own), code(english), "source")
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
    """The same, where its work is what takes the time: gallery_test looks at the whole gallery, bench_test and stress_test measure."""
    if command.startswith("gradus bench") and "--from" not in command:
        return f"{command} --seconds 0.001 --repetitions 1"
    if command.startswith("gradus stress"):
        return re.sub(r" --seconds \d+|$", " --seconds 1", command, count=1)
    if command.startswith("gradus figures -o ") and "--only" not in command:
        return f"{command} --only 'flood_fill*'"
    return fewer_frames(command) if command.startswith("gradus render ") else command


def commands_run(commands):
    for command in map(shorter, commands):
        result = subprocess.run(["sh", "-c", command], capture_output=True, text=True, timeout=120,
                                env={**os.environ, "PATH": f"{os.path.dirname(GRADUS)}:{os.environ['PATH']}"})
        equal((result.returncode, "gradus: " in result.stderr), (0, False), f"{command}: {result.stderr[-200:]}")
    check(len(commands) > 2, "there are commands")


def put_a_lecture():
    with open("my_lecture.json", "w") as file:
        json.dump({"figures": [{"topic": "bresenham_line", "input": {"from": "0,0", "to": "9,4"}}]}, file)


def put_answers():
    """Files that a teacher and a student have."""
    with open("names.txt", "w") as file:
        file.write("Ada\nGrace\n")
    with open("results.json", "w") as file:
        json.dump({"topic": "bresenham_line", "answers": [{"case": "typical-1", "result": {"count": 8}}]}, file)
    with open("mine.csv", "w") as file:
        file.write("0,0\n1,0\n2,1\n3,1\n4,2\n5,2\n6,3\n7,3\n")


def test_commands_of_the_readme_and_of_its_page():
    put_a_lecture()
    put_answers()
    shutil.copytree(SOURCE / "examples/models", "examples/models")
    pages = "".join((SOURCE / page).read_text() for page in ("README.md", "docs/commands.md"))
    blocks = re.findall(r"^```\n(.*?)^```", pages, re.M | re.S)
    commands = [re.split(r"\s{2,}#", line)[0].strip() for block in blocks for line in block.splitlines() if line.startswith("gradus ")]
    commands_run(commands)


if __name__ == "__main__":
    sys.exit(main(globals()))
