#!/usr/bin/env python3
"""Lectures from end to end: what `gradus figures my_lecture.json` makes.

    tests/golden/lecture_test.py [GRADUS]

Needs qpdf.
"""
import html
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal
from lectures import ROOT, figures, gradus, made, write


def png_size(path):
    """Width and height as the file's head states them."""
    head = pathlib.Path(path).read_bytes()[:24]
    check(head[:8] == b"\x89PNG\r\n\x1a\n" and head[12:16] == b"IHDR", f"{path} is a PNG")
    return struct.unpack(">II", head[16:])


def test_a_lecture_becomes_figures():
    write("a.json", figures(
        {},
        {"steps": "1,4-5", "outputs": ["pdf", "png", "html", "csv"], "caption": "<script>alert(1)</script> & more"},
        {"name": "One", "step": 2, "outputs": "svg"},
        {"topic": "flood_fill", "input": {"maze": ["#####", "#...#", "#####"], "at": [2, 1]}, "outputs": ["json", "txt"]},
        title="Lecture <3>", theme="dark"))
    code, out, err = gradus("figures", "a.json", "-o", "out/", "-j1")
    equal((code, out), (0, "out/index.html\n"), "a lecture")
    equal(err, "bresenham_line\nbresenham_line_2\nOne\nflood_fill\n4 drawn, 0 unchanged, 0 removed\n", "what was done")
    first = made("out")
    equal(sorted(first), sorted(
        [f"bresenham_line/bresenham_line{end}" for end in ("-drawing.svg", ".svg", ".png", ".pdf", ".html", ".csv", ".json", "-steps.zip")]
        + [f"bresenham_line_2/bresenham_line_2{end}"
           for end in ("-drawing.svg", "-1.png", "-4.png", "-5.png", ".pdf", ".html", ".csv")]
        + ["One/One-drawing.svg", "One/One.svg", "index.html"]
        + [f"flood_fill/flood_fill{end}" for end in ("-drawing.svg", ".json", ".txt")]
        + [f"topics/scan_conversion/{topic}.html" for topic in ("bresenham_line", "flood_fill")]), "the files")
    pages = [subprocess.run(["qpdf", "--show-npages", f"out/{name}/{name}.pdf"], capture_output=True, check=True).stdout
             for name in ("bresenham_line", "bresenham_line_2")]
    equal(pages, [b"10\n", b"3\n"], "a page per step")
    page = pathlib.Path("out/index.html").read_text(encoding="utf-8")
    check("<title>Lecture &lt;3&gt;: " in page and "<h1>Lecture &lt;3&gt;</h1>" in page, "the title, escaped")
    check("&lt;script&gt;alert(1)&lt;/script&gt; &amp; more" in page and "<script>alert" not in page, "the caption, escaped")
    for link in re.findall(r'(?:href|src)="([^"#:]+)"', page):
        check(os.path.exists(os.path.join("out", link)), f"the link {link} leads somewhere")
    plain = re.sub(r"<[^>]+>", "", page)
    check("--theme dark" in plain and "--steps 1,4-5" in plain, "commands say what the lecture says")

    equal(gradus("figures", "a.json", "-o", "out"), (0, "out/index.html\n", "0 drawn, 4 unchanged, 0 removed\n"),
          "nothing changed")
    equal(made("out"), first, "nothing touched")
    gradus("figures", "a.json", "-o", "other", "--jobs", "2")
    equal(made("other"), first, "the same lecture elsewhere, with two jobs: the same bytes")
    for name in ("bresenham_line/bresenham_line.svg", "bresenham_line_2/bresenham_line_2-4.png",
                 "bresenham_line_2/bresenham_line_2.pdf", "bresenham_line_2/bresenham_line_2.html", "One/One.svg",
                 "bresenham_line/bresenham_line.pdf", "One/One-drawing.svg"):
        again = "again" + os.path.splitext(name)[1]
        gradus("again", "out/" + name, "-o", again)
        # Only here a player lies beside the page about its topic, and has a link to it
        drawn = re.sub(rb'<a class="topic".*?</a>', b"", pathlib.Path("out", name).read_bytes())
        check(os.path.exists(again) and pathlib.Path(again).read_bytes() == drawn,
              f"{name} made again by the command in it")


def test_only_what_changed_is_drawn():
    write("a.json", figures({"name": "a"}, {"name": "b", "input": {"to": "5,2"}}, outputs=["svg", "csv"]))
    gradus("figures", "a.json")
    write("a.json", figures({"name": "a", "caption": "New."}, {"name": "b", "input": {"to": "5,2"}}, outputs=["svg", "csv"]))
    equal(gradus("figures", "a.json")[2], "a\n1 drawn, 1 unchanged, 0 removed\n", "another caption")
    write("a.json", figures({"name": "a", "caption": "New."}, {"name": "c", "input": {"to": "5,2"}}, outputs=["csv"]))
    write("out/b/mine.txt", "kept")
    equal(gradus("figures", "a.json")[2], "a\nc\n2 drawn, 0 unchanged, 1 removed\n", "a new name, other outputs")
    equal(sorted(made("out")), ["a/a-drawing.svg", "a/a.csv", "b/mine.txt", "c/c-drawing.svg", "c/c.csv", "index.html",
                              "topics/scan_conversion/bresenham_line.html"],
          "files made earlier go, others stay")
    write("a.json", figures({"name": "a", "caption": "New."}, {"name": "c", "input": {"to": "5,3"}}, outputs=["csv"]))
    equal(gradus("figures", "a.json", "--only", "a")[2], "0 drawn, 1 unchanged, 0 removed\n", "--only")
    equal(gradus("figures", "a.json", "--force", "--quiet")[1:], ("out/index.html\n", ""), "--force --quiet")
    equal(gradus("figures", "a.json", "--only", "z*")[::2],
          (1, "gradus: --only: expected a pattern that matches a figure or a topic, found 'z*'\n"), "--only nothing")
    os.remove("out/c/c.csv")
    equal(gradus("figures", "a.json")[2], "c\n1 drawn, 1 unchanged, 0 removed\n", "a lost file")


def test_files_are_looked_for_beside_the_lecture():
    shutil.copy(ROOT / "examples/images/horse.png", "horse.png")
    os.makedirs("lectures/pictures")
    os.rename("horse.png", "lectures/pictures/horse.png")
    fill = {"topic": "flood_fill", "input": {"image": "pictures/horse.png", "at": [10, 10]}, "outputs": ["svg"]}
    write("lectures/a.json", {"figures": [fill]})
    code, _, err = gradus("figures", "lectures/a.json", "-o", "out")
    equal((code, err), (0, "flood_fill\n1 drawn, 0 unchanged, 0 removed\n"), "from another folder")
    check(os.path.exists("out/flood_fill/horse.png"), "the picture lies beside the figure")
    page = pathlib.Path("out/index.html").read_text(encoding="utf-8")
    plain = re.sub(r"<[^>]+>", "", page)
    check("--image horse.png" in plain and "lectures" not in plain, "no folders in commands")
    gradus("again", "out/flood_fill/flood_fill.svg", "-o", "again.svg")
    equal(pathlib.Path("again.svg").read_bytes(), pathlib.Path("out/flood_fill/flood_fill.svg").read_bytes(), "again")

    with open("lectures/pictures/horse.png", "ab") as file:
        file.write(b"more")
    equal(gradus("figures", "lectures/a.json", "-o", "out")[2].splitlines()[-1], "1 drawn, 0 unchanged, 0 removed",
          "another picture under the same name")
    fill["input"]["image"] = "nowhere.png"
    write("lectures/a.json", {"figures": [fill]})
    equal(gradus("figures", "lectures/a.json", "-o", "out")[::2],
          (2, "gradus: lectures/a.json:1: figures[0].input.image: expected a readable file, found 'lectures/nowhere.png' "
              "(No such file or directory)\n"), "a missing picture")

    # The output folder is the one with the inputs: they stay what they are
    shutil.copy(ROOT / "examples/images/horse.png", "lectures/pictures/horse.png")
    fill["input"]["image"], fill["name"] = "pictures/horse.png", "pictures"
    write("lectures/a.json", {"figures": [fill]})
    before = made("lectures")
    code, _, err = gradus("figures", "lectures/a.json", "-o", "lectures")
    equal((code, "expected an output folder apart from the inputs" in err), (2, True), err)
    after = made("lectures")
    after.pop("index.html")
    equal(after, before, "inputs are not overwritten")
    fill["name"] = "horse"
    write("lectures/a.json", {"figures": [fill]})
    equal(gradus("figures", "lectures/a.json", "-o", "out")[2],
          "gradus: lectures/a.json:1: figures[0].name: expected another name than that of the input file 'horse.png', "
          "found 'horse'\n", "a figure called like its input")


def test_a_copy_of_the_gallery_works():
    shutil.copy(ROOT / "examples/gallery.json", "mine.json")
    equal(gradus("figures", "mine.json", "--check")[0], 0, "a copy of the gallery")
    # A dozen of its figures; cli_test draws them all
    for some in ("letter_f", "spot", "room", "bresenham_*", "affine_3d*"):
        equal(gradus("figures", "mine.json", "-o", "mine", "-q", "--only", some)[0], 0, f"{some} of the copy")
        equal(gradus("figures", "-o", "built_in", "-q", "--only", some)[0], 0, some)
    for name in ("letter_f", "spot", "room"):
        check(os.path.exists(f"mine/{name}/{name}.png"), f"the gallery shows {name}, rendered")
    # The page of errata comes with the gallery alone
    mine, built_in = made("mine"), made("built_in")
    check("errata.html" in built_in and "errata.html" not in mine, "the page of errata")
    for folder in (mine, built_in):
        folder.pop("errata.html", None), folder.pop("index.html")
    equal(mine, built_in, "the same figures, without a file and from a copy")


CUBE = """mtllib {library}
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
usemtl red
f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8
"""


def test_renders_of_a_lecture():
    write("lectures/models/cube.obj", CUBE.format(library="colours/red.mtl"))
    write("lectures/models/colours/red.mtl", "newmtl red\nKd 1 0 0\n")
    cube = {"model": "models/cube.obj"}
    deck = {**figures({"outputs": ["csv"]}), "theme": "dark", "size": "4:3", "renders": [
        cube,
        {**cube, "name": "large", "size": "2000x1000", "eye": [3, "2", 4.50], "target": "0.5,0.5,0.5", "up": [0, 0, 1],
         "fov": 30, "light": [0, 9, 0], "background": "none", "title": "A <cube>", "caption": "Red & lit."},
        {**cube, "name": "away", "eye": [5, 0, 0], "target": [9, 0, 0]}]}
    write("lectures/a.json", deck)
    equal(gradus("figures", "lectures/a.json", "--check"), (0, "", "lectures/a.json: 1 figure, 3 renders, no problems\n"),
          "--check")
    code, out, err = gradus("figures", "lectures/a.json", "-o", "out", "-j1", "--zip")
    equal((code, out), (0, "out/index.html\n"), err)
    equal(err.splitlines()[:4] + err.splitlines()[5:],
          ["bresenham_line", "cube", "large", "away",
           "away: render: the whole model lies behind the eye: the picture shows the background alone",
           "4 drawn, 0 unchanged, 0 removed"], "what was done, and what there is to say")
    first = made("out")
    equal(sorted(name for name in first if "line" not in name and "/" in name),
          sorted([f"{name}/{file}" for name in ("cube", "large", "away") for file in (f"{name}.png", "cube.obj", "red.mtl")]
                 + ["large/large-small.png"]), "the files")
    with zipfile.ZipFile("out.zip") as packed:
        equal(sorted(packed.namelist()), sorted(first), "all in the zip")

    # The same picture as the command's, which the card shows, and which `again` finds in the file
    page = pathlib.Path("out/index.html").read_text(encoding="utf-8")
    plain = html.unescape(re.sub(r"<[^>]+>", "", page))
    command = ("gradus render cube.obj --size 2000x1000 --eye 3,2,4.5 --target 0.5,0.5,0.5 --up 0,0,1 --fov 30 --light 0,9,0 "
               "--background none -o large.png")
    check(command in plain and "A <cube>" in plain and "Red & lit." in plain, "the card")
    check('<section data-chapter="pipeline">' in page and "<cube>" not in page, "the chapter; escaped")
    check("{large/large.png}" in page and r"![Red \&amp; lit\.](&lt;large/large.png&gt;)" in page, "lines for slides")
    for link in re.findall(r'(?:href|src)="([^"#:]+)"', page):
        check(os.path.exists(os.path.join("out", link)), f"the link {link} leads somewhere")
    check('href="./large/large.png" tabindex="-1" aria-hidden="true"><img src="./large/large-small.png"' in page,
          "a small picture leads to the large one")
    shutil.copytree("out/large", "copy")
    os.remove("copy/large.png")
    equal(gradus(*command.split()[1:], cwd="copy")[0], 0, "the card's command beside the copies")
    equal(pathlib.Path("copy/large.png").read_bytes(), pathlib.Path("out/large/large.png").read_bytes(), "makes the same picture")
    for name in ("cube", "large", "away"):
        code, _, err = gradus("again", f"out/{name}/{name}.png", "-o", "again.png", cwd=None)
        equal((code, pathlib.Path("again.png").read_bytes() == pathlib.Path(f"out/{name}/{name}.png").read_bytes()), (0, True),
              f"{name} again: {err}")
    gradus("render", "lectures/models/cube.obj", "-o", "cube.png")
    equal(pathlib.Path("cube.png").read_bytes(), pathlib.Path("out/cube/cube.png").read_bytes(), "as the command line does")
    equal([png_size(f"out/large/{name}.png") for name in ("large-small", "large")], [(640, 320), (2000, 1000)], "sizes")

    # Only what has changed
    equal(gradus("figures", "lectures/a.json", "-o", "out")[2], "0 drawn, 4 unchanged, 0 removed\n", "nothing changed")
    equal(gradus("figures", "lectures/a.json", "-o", "out", "--theme", "light", "--size", "1:1", "-q")[0], 0, "another look")
    check(all(made("out")[name] == hashed for name, hashed in first.items() if name.endswith(".png")), "is the figures' alone")
    write("lectures/models/colours/red.mtl", "newmtl red\nKd 0 1 0\n")
    equal(gradus("figures", "lectures/a.json", "-o", "out", "-j1", "-q", "--only", "render")[0], 0, "other materials")
    now = made("out")
    check(now["cube/cube.png"] != first["cube/cube.png"] and now["cube/red.mtl"] != first["cube/red.mtl"], "all anew")
    equal(gradus("figures", "lectures/a.json", "-o", "out", "--only", "lar*")[2], "0 drawn, 1 unchanged, 0 removed\n",
          "by its name")
    deck["renders"] = deck["renders"][1:2]
    del deck["figures"], deck["renders"][0]["size"]
    write("lectures/a.json", deck)
    equal(gradus("figures", "lectures/a.json", "-o", "out")[2], "large\n1 drawn, 0 unchanged, 3 removed\n", "renders alone")
    equal(sorted(made("out")), ["index.html", "large/cube.obj", "large/large.png", "large/red.mtl"], "the rest is gone")

    # The inputs' own folder is none to draw into
    write("lectures/b.json", {"renders": [{**cube, "name": "models"}]})
    before = made("lectures")
    code, _, err = gradus("figures", "lectures/b.json", "-o", "lectures")
    check(code == 2 and "renders[0].model: expected an output folder apart from the inputs" in err, err)
    equal({name: hashed for name, hashed in made("lectures").items() if name != "index.html"}, before, "nothing overwritten")


def test_a_tour_has_its_materials_beside_it():
    write("models/cube.obj", CUBE.format(library="colours\\\\red.mtl"))
    write("models/colours/red.mtl", "newmtl red\nKd 1 0 0\n")
    write("a.json", {"figures": [{"topic": "pipeline", "input": {"model": "models/cube.obj"}, "name": "cube", "outputs": ["svg"]}]})
    code, _, err = gradus("figures", "a.json")
    equal((code, err), (0, "cube\n1 drawn, 0 unchanged, 0 removed\n"), "a figure called like its model")
    check(set(made("out")) >= {"cube/cube.svg", "cube/cube.obj", "cube/red.mtl"}, sorted(made("out")))
    equal(gradus("again", "out/cube/cube.svg", "-o", "again.svg")[0], 0, "again")
    equal(pathlib.Path("again.svg").read_bytes(), pathlib.Path("out/cube/cube.svg").read_bytes(), "to the byte")


def test_two_lectures_do_not_share_a_folder():
    write("a.json", figures({}, outputs=["svg"]))
    write("b.json", figures({"name": "b"}, outputs=["svg"]))
    write("c/a.json", figures({"name": "c"}, outputs=["svg"]))
    gradus("figures", "a.json")
    before = made("out")
    for other in (["b.json"], ["c/a.json"], []):
        code, out, err = gradus("figures", *other)
        equal((code, out, err), (2, "", "gradus: -o: expected a folder without the figures of another lecture, found 'out' "
                                        "with those of the lecture 'a.json' (--force removes them)\n"), f"then {other}")
    equal(made("out"), before, "nothing touched")
    equal(gradus("figures", "b.json", "--force")[2], "b\n1 drawn, 0 unchanged, 1 removed\n", "--force says what goes")
    equal(sorted(made("out")), ["b/b-drawing.svg", "b/b.svg", "index.html", "topics/scan_conversion/bresenham_line.html"],
          "only the new ones")
    equal(gradus("figures", "./b.json")[2], "0 drawn, 1 unchanged, 0 removed\n", "the same lecture by another path")
    gradus("figures", "-o", "gallery", "--only", "flood_fill_span")
    equal("with those of the built-in gallery" in gradus("figures", "b.json", "-o", "gallery")[2], True, "the gallery's folder")


def test_the_shipped_lecture_and_its_slides():
    lecture = ROOT / "examples/lecture/scan_conversion.json"
    figures = json.loads(lecture.read_text(encoding="utf-8"))["figures"]
    equal(len(figures), 12, "figures of the shipped lecture")
    equal(gradus("figures", str(lecture), "-o", "out", "-q")[:2], (0, "out/index.html\n"), "the shipped lecture")
    shown = re.findall(r"\\includegraphics(?:<\d+>)?\[page=(\d+),.*?\]\{(.*?)\}",
                       (ROOT / "examples/lecture/slides.tex").read_text(encoding="utf-8"))
    pages = {}
    for page, path in shown:
        pages.setdefault(path, []).append(int(page))
    equal(list(pages), [f"{figure['name']}/{figure['name']}.pdf" for figure in figures], "slides of every figure, in order")
    for path, numbers in pages.items():
        count = int(subprocess.run(["qpdf", "--show-npages", f"out/{path}"], capture_output=True, check=True).stdout)
        equal(numbers, list(range(1, count + 1)), f"pages of {path}")


def test_looks_for_a_whole_lecture():
    write("a.json", figures({"labels": {"p": "d"}, "outputs": ["svg"]},
                            {"topic": "flood_fill", "input": {"maze": ["###", "#.#", "###"], "at": [1, 1]}, "theme": "light",
                             "outputs": ["svg"]}, size="16:9"))
    equal(gradus("figures", "a.json", "-o", "dark", "--theme", "dark", "--size", "4:3", "--zip", "-q")[0], 0, "for another room")
    for name in ("bresenham_line", "flood_fill"):
        text = pathlib.Path(f"dark/{name}/{name}.svg").read_text(encoding="utf-8")
        check("--theme dark --size 4:3" in text and 'viewBox="0 0 960 720"' in text, f"{name} in the other look")
    with zipfile.ZipFile("dark.zip") as packed:
        equal(packed.testzip(), None, "the zip is whole")
        equal(sorted(packed.namelist()), sorted(made("dark")), "all of the folder is in it")
        check(all(packed.read(name) == pathlib.Path("dark", name).read_bytes() for name in packed.namelist()), "as it is")
    err = gradus("figures", "a.json", "-o", "dark", "--theme", "dark", "--size", "4:3", "--zip")[2]
    equal(err, os.path.abspath("dark.zip") + "\n0 drawn, 2 unchanged, 0 removed\n", "says where the zip is")
    code, out, err = gradus("figures", "a.json", "-o", "new", "--theme", "drak")
    equal((code, out, err), (2, "", "gradus: --theme: expected one of light, dark, greyscale, high_contrast, print, found 'drak', did "
                             "you mean 'dark'?\n"), "a wrong look")
    check(not os.path.exists("new"), "nothing made")


def test_labels_of_a_lecture_serve_its_topics():
    fill = {"topic": "flood_fill", "input": {"maze": ["#.#"], "at": [1, 0]}, "outputs": ["csv"]}
    write("a.json", figures({"outputs": ["svg"]}, fill, labels={"p": "d"}))
    equal(gradus("figures", "a.json", "-q")[0], 0, "a symbol that one of two topics has")
    write("b.json", figures(fill, labels={"p": "d"}))
    code, _, err = gradus("figures", "b.json", "--check")
    equal(code, 2, "a symbol that none has")
    check("labels.p: expected one of the symbols n, found 'p'" in err, err)
    write("c.json", figures(fill, {}, labels={"foo": "d"}))
    check("labels.foo: expected a symbol of one of the topics, found 'foo'" in gradus("figures", "c.json", "--check")[2], "nor two")


def test_symbols_of_topics_that_have_none():
    painter = {"topic": "painter", "input": {}}
    none = "expected no symbol: painter uses none, found 'p'"
    for lecture, where in ((figures({**painter, "notation": {"symbols": {"p": "d"}}}), "figures[0].notation.symbols.p"),
                           (figures(painter, notation={"symbols": {"p": "d"}}), "notation.symbols.p"),
                           (figures({**painter, "notation": {"symbols": {"painter": {"p": "d"}}}}), "figures[0].notation.symbols.painter.p"),
                           (figures({**painter, "labels": {"p": "d"}}), "figures[0].labels")):
        write("a.json", lecture)
        code, out, err = gradus("figures", "a.json", "--check")
        equal((code, out), (2, ""), where)
        check(err.endswith(f": {where}: {none}\n") and err.count("\n") == 1, err)
    write("a.json", figures(painter, {}, notation={"symbols": {"p": "d"}}))
    equal(gradus("figures", "a.json", "--check")[0], 0, "a symbol of one of the topics")


def test_from_standard_input():
    code, _, err = gradus("figures", "-", "-o", "out", stdin=json.dumps(figures({}, outputs=["csv"])).encode())
    equal((code, err), (0, "bresenham_line\n1 drawn, 0 unchanged, 0 removed\n"), "a lecture from standard input")
    equal(gradus("figures", "-", "--check", stdin=b"{")[2],
          "gradus: standard input:1: expected a key in double quotes or '}', found the end of the file\n", "a wrong one")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
