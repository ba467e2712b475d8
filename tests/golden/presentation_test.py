#!/usr/bin/env python3
"""What is in a presentation: a package as ISO/IEC 29500 wants it, with the figures' own texts and numbers.

    tests/golden/presentation_test.py [GRADUS]
"""
import csv
import io
import pathlib
import posixpath
import sys
import xml.etree.ElementTree as xml
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal, gradus, read, write

A = "{http://schemas.openxmlformats.org/drawingml/2006/main}"
P = "{http://schemas.openxmlformats.org/presentationml/2006/main}"
SVG = "{http://schemas.microsoft.com/office/drawing/2016/SVG/main}"
REL = "{http://schemas.openxmlformats.org/package/2006/relationships}"
EMBED = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}embed"
TYPES = "{http://schemas.openxmlformats.org/package/2006/content-types}"
LINE = ["figure", "bresenham_line", "--from", "0,0", "--to", "7,3"]
EMU = 9525  # of a pixel


def deck(*flags, to="deck.pptx"):
    result = gradus(*LINE, *flags, "-o", to)
    equal((result.code, result.out), (0, ""), f"exit code of {flags}: {result.err}")
    return zipfile.ZipFile(to)


def texts(element):
    """The paragraphs below an element."""
    return ["".join(run.text or "" for run in p.iter(A + "t")) for p in element.iter(A + "p")]


def named(slide, name):
    """The shape of that name on a slide."""
    for shape in slide.iter():
        if shape.tag in (P + "sp", P + "pic", P + "graphicFrame"):
            if next(shape.iter(P + "cNvPr")).get("name") == name:
                return shape
    return None


def slide_of(package, number):
    return xml.fromstring(package.read(f"ppt/slides/slide{number}.xml"))


def relations(package, part):
    folder, name = posixpath.split(part)
    source = package.read(f"{folder}/_rels/{name}.rels".lstrip("/"))
    return {r.get("Id"): posixpath.normpath(posixpath.join(folder, r.get("Target")))
            for r in xml.fromstring(source).iter(REL + "Relationship")}


def test_every_part_is_declared_linked_and_well_formed():
    package = deck()
    names = package.namelist()
    equal(names[0], "[Content_Types].xml", "what the parts are comes first")
    equal(len(names), len(set(names)), "no part twice")
    for name in names:
        if name.endswith((".xml", ".rels", ".svg")):
            xml.fromstring(package.read(name))
    types = xml.fromstring(package.read("[Content_Types].xml"))
    endings = {d.get("Extension") for d in types.iter(TYPES + "Default")}
    declared = {o.get("PartName")[1:] for o in types.iter(TYPES + "Override")}
    check(declared <= set(names), f"declared, but not there: {declared - set(names)}")
    check(all(n.rsplit(".", 1)[1] in endings for n in names), "every ending has a type")
    reached, waiting = set(), list(relations(package, "").values())
    while waiting:
        part = waiting.pop()
        check(part in names, f"linked, but not there: {part}")
        if part in reached:
            continue
        reached.add(part)
        folder, name = posixpath.split(part)
        if f"{folder}/_rels/{name}.rels" in names:
            waiting += relations(package, part).values()
    parts = {n for n in names if not n.endswith(".rels") and n != "[Content_Types].xml"}
    equal(parts - reached, set(), "every part is reached from the root")


def test_a_slide_a_step_with_its_words_as_text():
    package = deck()
    run = list(csv.DictReader(io.StringIO(gradus(*LINE, "-o", "-", "--format", "csv").out)))
    slides = [n for n in package.namelist() if n.startswith("ppt/slides/slide")]
    equal(len(slides), 8, "steps 0 to 7")
    for step in range(8):
        slide, row = slide_of(package, step + 1), run[step]
        equal(texts(named(slide, "Title")), ["Bresenham line"], "the title")
        check(named(slide, "Title").find(f".//{P}ph").get("type") == "title", "is the slide's title, for its outline")
        equal(" ".join(texts(named(slide, "Sentence"))), row["sentence"], "the sentence")
        notes = xml.fromstring(package.read(f"ppt/notesSlides/notesSlide{step + 1}.xml"))
        equal(texts(named(notes, "Notes")), [row["sentence"]], "the speaker's notes")
        check(sum(bool(line) for line in texts(named(slide, "Code"))) >= 5, "the code")
        used = {f.get("typeface") for f in slide.iter(A + "latin")}
        check(used <= {"Arial", "Courier New"}, f"fonts that every Office has: {used}")


def test_the_table_is_a_table():
    package = deck()
    run = list(csv.DictReader(io.StringIO(gradus(*LINE, "-o", "-", "--format", "csv").out)))
    table = named(slide_of(package, 3), "Table")
    rows = [[" ".join(texts(cell)) for cell in row.iter(A + "tc")] for row in table.iter(A + "tr")]
    equal(rows[0], ["k", "x", "y", "p", "test", "step"], "the columns")
    equal([cell.replace("−", "-") for cell in rows[2][:4]], [run[1][c] for c in "kxyp"], "numbers of step 1")
    width = sum(int(c.get("w")) for c in table.iter(A + "gridCol"))
    equal(width, int(next(table.iter(P + "xfrm")).find(A + "ext").get("cx")), "columns fill the table")
    widths = {len(list(row.iter(A + "tc"))) for row in table.iter(A + "tr")}
    equal(widths, {6}, "every row has a cell per column")


def test_the_drawing_is_a_vector_picture_with_pixels_beside_it():
    package = deck("--step", "4")
    links = relations(package, "ppt/slides/slide1.xml")
    for name in ("Drawing", "Legend"):
        picture = named(slide_of(package, 1), name)
        check(len(next(picture.iter(P + "cNvPr")).get("descr")) > 20, f"{name} has an alternative text")
        pixels, vectors = (package.read(links[next(picture.iter(tag)).get(EMBED)])
                           for tag in (A + "blip", SVG + "svgBlip"))
        check(pixels.startswith(b"\x89PNG") and b"<svg" in vectors, f"{name} as pixels and as vectors")
        size = next(picture.iter(A + "xfrm")).find(A + "ext")
        wide, high = int.from_bytes(pixels[16:20], "big"), int.from_bytes(pixels[20:24], "big")
        drawn = int(size.get("cx")) / EMU * 2, int(size.get("cy")) / EMU * 2
        check(abs(wide - drawn[0]) <= 2 and abs(high - drawn[1]) <= 2, f"{name} isn't stretched: {wide}x{high}, {drawn}")
        root = xml.fromstring(vectors)
        check(not list(root.iter("{http://www.w3.org/2000/svg}image")), "no pixels among the vectors")


def test_slides_have_the_figure_s_size_and_colours():
    package = deck("--size", "4:3", "--theme", "dark")
    size = xml.fromstring(package.read("ppt/presentation.xml")).find(P + "sldSz")
    equal((int(size.get("cx")), int(size.get("cy"))), (960 * EMU, 720 * EMU), "4:3")
    paper = next(slide_of(package, 1).iter(P + "bgPr")).find(f".//{A}srgbClr").get("val")
    check(int(paper, 16) < 0x404040, f"a dark ground: {paper}")
    for shape in slide_of(package, 1).iter(A + "xfrm"):
        at, extent = shape.find(A + "off"), shape.find(A + "ext")
        check(int(at.get("x")) >= 0 and int(at.get("y")) >= 0, "nothing begins off the slide")
        check(int(extent.get("cx")) >= 0 and int(extent.get("cy")) >= 0, "nothing has less than no size")


def test_it_is_made_again_and_its_own_is_replaced():
    deck("--step", "4")
    first = read("deck.pptx")
    equal(gradus("again", "deck.pptx", "-o", "twin.pptx").code, 0, "again")
    equal(read("twin.pptx") == first, True, "the same bytes")
    equal(gradus(*LINE, "-o", "deck.pptx").code, 0, "its own gives way")
    with zipfile.ZipFile("deck.pptx") as package, zipfile.ZipFile("mine.pptx", "w") as mine:
        for name in package.namelist():
            mine.writestr(name, package.read(name))
    result = gradus(*LINE, "-o", "mine.pptx")
    equal(result.code, 2, "what somebody saved again is theirs")


def test_words_of_any_kind_stay_words():
    package = deck("--title", "a <b> & \"c\" – ½", "--step", "1")
    equal(texts(named(slide_of(package, 1), "Title")), ["a <b> & \"c\" – ½"], "the title")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
