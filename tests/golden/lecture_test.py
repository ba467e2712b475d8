#!/usr/bin/env python3
"""Lectures from end to end: what `gradus figures my_lecture.json` makes, what it says of a wrong one, and its schema.

    tests/golden/lecture_test.py [GRADUS]

Needs jsonschema (Debian: python3-jsonschema) and qpdf.
"""
import hashlib
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

import jsonschema

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, check, equal

ROOT = pathlib.Path(os.environ.get("GRADUS_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
LINE = {"topic": "bresenham_line", "input": {"from": "0,0", "to": "9,4"}}
def gradus(*words, stdin=b"", cwd=None):
    """Exit code, stdout, stderr."""
    done = subprocess.run([GRADUS, *words], input=stdin, capture_output=True, timeout=300, cwd=cwd)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def write(path, content):
    pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    text = content if isinstance(content, str) else json.dumps(content)
    pathlib.Path(path).write_text(text, encoding="utf-8")


def png_size(path):
    """Width and height as the file's head states them."""
    head = pathlib.Path(path).read_bytes()[:24]
    check(head[:8] == b"\x89PNG\r\n\x1a\n" and head[12:16] == b"IHDR", f"{path} is a PNG")
    return struct.unpack(">II", head[16:])


def figures(*members, **deck):
    """A lecture; a figure is a line, unless it says otherwise."""
    return {**deck, "figures": [{**LINE, **member} for member in members]}


def made(folder):
    """Name -> hash of all files but the manifest, which holds times."""
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(pathlib.Path(folder).rglob("*"))
            if path.is_file() and path.name != ".gradus-manifest.json"}


# --- What is made ------------------------------------------------------------------------------------------------------


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
    equal(pages, [b"10\n", b"3\n"], "a page a step")
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


def test_problems_of_renders():
    shutil.copy(ROOT / "examples/models/spot.obj", "spot.obj")
    write("bad.obj", "v 0 0 0\n\nf 1 1 2\n")
    write("my.json", """{"renders": [
  {"model": "spot.obj", "eye": [1, 2], "fov": 400,
   "size": "0x3"},
  {"model": "spot.obj", "up": "0,0,0", "theme": "dark", "modle": 1},
  {"model": "nowhere.obj"}, {"eye": [1, 2, 3]},
  {"model": "-"}, 7, {"model": 7},
  {"model": "spot.obj", "eye": [0, 0, 0], "target": [0, 0, 0]},
  {"model": "spot.obj", "name": "../x"}, {"model": "spot.obj", "name": "same"},
  {"model": "spot.obj", "name": "Same", "eye": {}, "fov": true},
  {"model": "bad.obj", "caption": "a\\nb"},
  {"model": "spot.obj", "background": "grene", "light": [1, 2, "x"]}],
"model": "spot.obj", "eye": 1}
""")
    code, out, err = gradus("figures", "my.json", "--check")
    equal((code, out), (2, ""), "--check")
    lines = [line.removeprefix("gradus: my.json:") for line in err.splitlines()]
    beginnings = [
        "2: renders[0].eye: expected three numbers like 3,2,4",
        "2: renders[0].fov: expected the vertical angle of view, 0.001 to 179.999 degrees, found '400'",
        "3: renders[0].size: expected a width and a height like 800x600",
        "4: renders[1].theme: expected a known key, found 'theme' (it belongs into a figure, beside \"topic\")",
        "4: renders[1].modle: expected a known key, found 'modle', did you mean 'model'?",
        "4: renders[1].up: expected a direction like 0,1,0, found 0,0,0",
        "5: renders[2].model: expected a readable file, found 'nowhere.obj' (No such file or directory)",
        "5: renders[3]: expected the key \"model\", found none",
        "6: renders[4].model: expected a file's name, found '-'",
        "6: renders[5]: expected an object with the key \"model\", found 7",
        "6: renders[6].model: expected a file's name, found 7",
        "7: renders[7].target: expected another point than the eye 0,0,0, found 0,0,0",
        "8: renders[8].name: expected a name of at most 80 letters",
        "9: renders[10].fov: expected a number, found true",
        "9: renders[10].eye: expected three numbers like [3, 2, 4], or one text, found an object",
        "10: renders[11].caption: expected a text on one line, found 'a\\nb'",
        "10: renders[11].model: bad.obj:3: ",
        "11: renders[12].background: expected a colour #rrggbb or one of ",
        "11: renders[12].light: expected three numbers like 3,2,4",
        "12: model: expected a known key, found 'model' (it belongs into a render, beside \"model\")",
        "12: eye: expected a known key, found 'eye' (it belongs into a render, beside \"model\")"]
    for beginning in beginnings:
        equal(sum(line.startswith(beginning) for line in lines), 1, f"{beginning}\n{err}")
    equal(len(lines), len(beginnings), err)
    equal([int(line.split(":")[0]) for line in lines], sorted(int(line.split(":")[0]) for line in lines), "by line")
    code, out, err = gradus("figures", "my.json", "-o", "out")
    equal((code, out, len(err.splitlines()), os.path.exists("out")), (2, "", 1, False), "nothing is drawn")

    one = {"model": "spot.obj"}
    for lecture, problem in (
            ({"renders": []}, "renders: expected a list of at least one render, found an empty list"),
            ({"renders": {}}, "renders: expected a list of at least one render, found an object"),
            ({}, 'expected the key "figures" or "renders", found none'),
            ({**figures({"name": "a"}), "renders": [{**one, "name": "A"}]},
             "renders[0].name: expected another name than that of figures[0] (line 1), found 'A'"),
            ({"renders": [{**one, "name": "Topics"}]},
             "renders[0].name: expected another name, for the pages of the topics have this one, found 'Topics'")):
        write("my.json", lecture)
        equal(gradus("figures", "my.json", "--check")[::2], (2, f"gradus: my.json:1: {problem}\n"), problem)
    shutil.copy("spot.obj", "a b.obj")
    write("my.json", {**figures({"name": "spot", "outputs": ["csv"]}), "renders": [one, one, {"model": "a b.obj"}]})
    equal(gradus("figures", "my.json", "-j1")[::2],
          (0, "spot\nspot_2\nspot_3\nrender\n4 drawn, 0 unchanged, 0 removed\n"), "names where the lecture gives none")


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
    check("labels.p: expected a symbol of one of the topics, found 'p'" in err, err)


def test_from_standard_input():
    code, _, err = gradus("figures", "-", "-o", "out", stdin=json.dumps(figures({}, outputs=["csv"])).encode())
    equal((code, err), (0, "bresenham_line\n1 drawn, 0 unchanged, 0 removed\n"), "a lecture from standard input")
    equal(gradus("figures", "-", "--check", stdin=b"{")[2],
          "gradus: standard input:1: expected a key in double quotes or '}', found the end of the file\n", "a wrong one")


# --- What is wrong -------------------------------------------------------------------------------------------------------

BAD = """{
  "them": "dark",
  "size": "12",
  "figures": [
    {"topic": "bresenham_circel", "input": {}},
    {"topic": "bresenham_line", "input": {"from": [0, 0, 3], "too": "9,4"},
     "methd": "dda"},
    {"topic": "bresenham_line", "input": {"to": "9,4"}, "step": 99},
    {"topic": "flood_fill", "input": {"at": "99,99"}},
    {"topic": "bresenham_line", "input": {"to": "9,4"}, "name": "../../x"},
    {"input": {}}
  ]
}
"""


def test_rings_as_lists():
    def read(path):
        with open(path, encoding="utf-8") as file:
            return file.read()

    plate = {"topic": "sutherland_hodgman", "method": "separate_pieces", "outputs": ["svg"]}
    outline, one, two = "-5,1 15,1 15,9 -5,9", [[2, 2], [3, 2], [3, 3]], [[4, 4], [5, 4], [5, 5]]
    write("rings.json", figures({**plate, "name": "lists", "input": {"polygon": outline, "hole": [one, two]}},
                                {**plate, "name": "text", "input": {"polygon": outline, "hole": "2,2 3,2 3,3; 4,4 5,4 5,5"}},
                                {**plate, "name": "single", "input": {"polygon": outline, "hole": one}},
                                {**plate, "name": "alone", "input": {"polygon": outline, "hole": "2,2 3,2 3,3"}}))
    equal(gradus("figures", "rings.json", "-o", "rings", "-q")[::2], (0, ""), "rings")
    equal(read("rings/lists/lists.svg"), read("rings/text/text.svg"), "a list of rings and a text")
    equal(read("rings/single/single.svg"), read("rings/alone/alone.svg"), "a ring by itself")
    check(read("rings/lists/lists.svg") != read("rings/single/single.svg"), "two holes are not one")
    write("rings.json", figures({**plate, "input": {"hole": [one, [[1, 1], [2, 2]]]}}))
    equal(gradus("figures", "rings.json", "--check")[2], "gradus: rings.json:1: figures[0].input.hole: ring 2: expected at "
          "least 3 points, with ; between rings alone, found 2\n", "a ring of two points")


def test_every_problem_has_its_line():
    write("my.json", BAD)
    code, out, err = gradus("figures", "my.json", "--check", "-o", "out")
    lines = err.splitlines()
    equal((code, out, os.path.exists("out")), (2, "", False), "--check draws nothing")
    equal(lines[0], "gradus: my.json:2: them: expected a known key, found 'them', did you mean 'theme'?", "a key")
    check(lines[1].startswith("gradus: my.json:3: size: expected a width and a height"), lines[1])
    check(lines[2].startswith("gradus: my.json:5: figures[0].topic: expected one of ") and "bresenham_circel" in lines[2], lines[2])
    equal(lines[3:], [
        "gradus: my.json:6: figures[1].input.too: expected a known key, found 'too', did you mean 'to'?",
        "gradus: my.json:6: figures[1].input.from: expected two whole numbers from -2147483648 to 2147483647 like 3,4, "
        "found '0,0,3'",
        "gradus: my.json:7: figures[1].methd: expected a known key, found 'methd', did you mean 'method'?",
        "gradus: my.json:10: figures[4].name: expected a name of at most 80 letters a-z, digits, _ and -, "
        "not beginning with -, found '../../x'",
        "gradus: my.json:11: figures[5]: expected the key \"topic\", found none"], "the others")
    equal(gradus("figures", "my.json", "-o", "out"), (2, "", lines[0] + "\n"), "without --check the first one")
    check(not os.path.exists("out"), "and nothing is made")

    # Those that only the run itself can know
    write("my.json", """{"outputs": ["svg"], "steps": 1, "figures": [
        {"topic": "bresenham_line", "input": {"to": "9,4"},
         "step": 99},
        {"topic": "flood_fill", "input": {"at": "99,99"}},
        {"topic": "bresenham_line", "input": {"to": "9,4"}, "steps": "0-9999999"},
        {"topic": "bresenham_line", "input": {"to": "9,4"}, "name": "fine"}
    ]}""")
    expected = [
        "gradus: my.json:3: figures[0].step 99: bresenham_line has steps 0..9 for this input",
        "gradus: my.json:4: figures[1].input.at: expected a pixel inside the 10 × 7 picture (columns 0 to 9, rows 0 to 6), "
        "found 99,99",
        "gradus: my.json:5: figures[2].steps: expected at most 1000 steps, found 10000000"]
    code, _, err = gradus("figures", "my.json", "--check")
    equal((code, err.splitlines()), (2, expected), "--check runs the topics")
    code, out, err = gradus("figures", "my.json", "-o", "out")
    equal((code, out, err.splitlines()), (2, "", ["fine", *expected, "1 drawn, 0 unchanged, 0 removed"]), "the others are drawn")
    equal(sorted(made("out")), ["fine/fine-drawing.svg", "fine/fine.svg", "index.html", "topics/scan_conversion/bresenham_line.html"], "no trace of those that failed")

    write("my.json", '{"figures": [\n{"topic": "bresenham_line" "input": {}}]}')
    equal(gradus("figures", "my.json", "--check")[::2],
          (2, "gradus: my.json:2: expected ',' or '}' after the value of 'topic', found '\"input\"'\n"), "no JSON")
    write("my.json", figures({"name": "same"}, {"name": "Same"}))
    equal(gradus("figures", "my.json", "--check")[2],
          "gradus: my.json:1: figures[1].name: expected another name than that of figures[0] (line 1), found 'Same'\n", "a name twice")
    write("my.json", figures({}))
    equal(gradus("figures", "my.json", "--check"), (0, "", "my.json: 1 figure, no problems\n"), "a right one")


def test_hostile_lectures():
    texts = {
        "deep": "[" * 100000, "long": '{"figures": "' + "x" * 1000000 + '"}', "binary": "\0\1\2",
        "name": json.dumps(figures({"name": "x" * 5000})), "key": json.dumps({"\x1b[31m\n" * 50: 1}),
        "slash": json.dumps(figures({"name": "a/b"})), "topic": json.dumps(figures({"topic": "../bresenham_line"})),
        "steps": json.dumps(figures({"steps": "0-999999999999999"})), "null": "null", "empty": "",
    }
    for what, text in texts.items():
        write("h.json", text)
        for words in (["--check"], ["-o", "out"]):
            code, out, err = gradus("figures", "h.json", *words)
            check(code == 2 and out == "" or what == "steps", f"{what}: {code}")
            check(all(len(line) < 700 and line.isprintable() for line in err.splitlines()), f"{what}: {err[:800]!r}")
            check("gradus: h.json:1: " in err, f"{what}: {err[:300]!r}")
    equal(sorted(made(".")), ["h.json", "out/index.html"], "nothing is written beside")


# --- The schema ----------------------------------------------------------------------------------------------------------


def valid(schema, lecture):
    return jsonschema.Draft202012Validator(schema).is_valid(lecture)


def test_the_schema_says_what_the_program_does():
    printed = gradus("figures", "--schema")[1]
    shipped = (ROOT / "docs/lecture.schema.json").read_text(encoding="utf-8")
    check(printed == shipped, "docs/lecture.schema.json is what `gradus figures --schema` prints: print it anew")
    schema = json.loads(shipped)
    jsonschema.Draft202012Validator.check_schema(schema)

    figure = schema["$defs"]["figure"]
    topics = {topic["name"]: topic for topic in json.loads(gradus("list", "--json")[1])["topics"]}
    equal(set(figure["properties"]["topic"]["enum"]), set(topics), "topics")
    rules = {rule["if"]["properties"]["topic"]["const"]: rule["then"]["properties"] for rule in figure["allOf"]}
    equal(set(rules), set(topics), "a rule for each topic")
    for name, topic in topics.items():
        equal(rules[name]["method"]["enum"], [method["name"] for method in topic["methods"]], f"methods of {name}")
        equal(list(rules[name]["input"]["properties"]), [p["name"] for p in topic["parameters"]], f"inputs of {name}")
    render = schema["$defs"]["render"]["properties"]
    check(all(part.get("description") for part in (*schema["properties"].values(), *figure["properties"].values(), *render.values())),
          "every key has a description")
    flags = set(re.findall(r"^ +(?:-\w, )?--(\w+) ", gradus("render", "--help")[1], re.MULTILINE))
    check(len(flags) > 9, sorted(flags))
    equal(set(render), flags - {"output", "force", "color", "quiet", "help", "version"} | {"model", "name", "title", "caption"},
          "keys of a render")

    gallery = json.loads((ROOT / "examples/gallery.json").read_text(encoding="utf-8"))
    check(valid(schema, gallery), "the gallery is valid")
    spot = {"model": "models/spot.obj"}
    wrong = 0
    for lecture in (
            figures({}), figures({"step": 4.1}), figures({"steps": [1, "3-4"]}), figures({"slots": ["drawing"]}),
            figures({"input": {"from": [0, 0], "to": "3,4"}}), figures({"outputs": "pdf"}), figures({"outputs": ["csv", "txt"]}),
            figures({"topic": "flood_fill", "input": {"connectivity": 8, "tolerance": 0}}),
            figures({"topic": "flood_fill", "input": {"maze": ["##", "#."], "at": "1,1"}}), figures({"name": "A-1_b"}),
            {**figures({}), "$schema": "x", "title": "T", "theme": "dark", "outputs": ["svg"]},
            {"renders": [spot]}, {**figures({}), "renders": [spot, {**spot, "name": "a"}]},
            {"renders": [{**spot, "eye": [1, "2", 3.5], "target": "0,1,0", "up": [0, 1, 0], "fov": 20, "light": [3, 3, -3],
                          "background": "none", "size": "64x48", "title": "T", "caption": "C"}]},
            # and wrong ones
            [], {}, {"figures": []}, {"figures": {}}, {"figures": [{}]}, {"figures": [{"topic": "bresenham_line"}]},
            {"figures": [{"input": {}}]}, figures({"topic": "bresenham"}), figures({"methd": "dda"}), figures({"method": "breadth_first"}),
            figures({"input": {"start": "0,0"}}), figures({"input": {"from": [0, 0, 0]}}), figures({"input": {"from": 4}}),
            figures({"input": {"from": [0.5, 1]}}), figures({"input": "0,0"}), figures({"theme": 4}), figures({"theme": "drak"}),
            figures({"step": True}), figures({"step": [1]}), figures({"steps": []}), figures({"outputs": []}), figures({"outputs": ["pgn"]}),
            figures({"name": "../x"}), figures({"name": "-x"}), figures({"name": ""}), figures({"name": "x" * 81}), figures({"caption": 1}),
            figures({"topic": "flood_fill", "input": {"connectivity": 5}}), figures({"topic": "flood_fill", "input": {"tolerance": 256}}),
            {"renders": []}, {"renders": {}}, {"renders": [{}]}, {"renders": [7]}, {"renders": [{**spot, "eye": [1, 2]}]},
            {"renders": [{**spot, "eye": 1}]}, {"renders": [{**spot, "light": [1, 2, None]}]}, {"renders": [{**spot, "fov": True}]},
            {"renders": [{**spot, "name": "../x"}]}, {"renders": [{**spot, "theme": "dark"}]}, {"renders": [{**spot, "size": 3}]},
            {"renders": [{"model": 3}]}, {"figures": [], "renders": [spot]}, {"model": "models/spot.obj", "renders": [spot]},
            figures({"renders": [spot]}),
            figures({"figures": []}), {**figures({}), "topic": "flood_fill"}, {**figures({}), "method": "dda"}, {**figures({}), "them": "dark"}):
        write("s.json", lecture)
        code = gradus("figures", "s.json", "--check")[0]
        equal(code, 0 if valid(schema, lecture) else 2, f"--check and the schema agree on {json.dumps(lecture)[:200]}")
        wrong += code == 2
    check(wrong == 48, f"{wrong} of them are wrong")

    # Every name that the schema offers is taken; those that it does not are refused
    offered = 0
    for key, part in figure["properties"].items():
        for name in part.get("enum", []):
            if key == "topic":
                continue
            write("s.json", figures({key: name}))
            equal(gradus("figures", "s.json", "--check")[0], 0, f'"{key}": "{name}"')
            offered += 1
        if "enum" in part:
            write("s.json", figures({key: "no_such_name"}))
            equal(gradus("figures", "s.json", "--check")[0], 2, f'"{key}": "no_such_name"')
    check(offered >= 4, f"{offered} names offered")


def test_the_page_on_lectures_has_every_key():
    page = (ROOT / "docs/lecture.md").read_text(encoding="utf-8")
    schema = json.loads((ROOT / "docs/lecture.schema.json").read_text(encoding="utf-8"))
    of_figures, of_renders = re.split(r"^## Keys of a render$", page, flags=re.MULTILINE)
    keys = [set(re.findall(r"^\| `([\w$]+)` \|", part, re.MULTILINE)) for part in (of_figures, of_renders)]
    equal(keys[0], set(schema["properties"]) | set(schema["$defs"]["figure"]["properties"]), "keys in the tables of docs/lecture.md")
    equal(keys[1], set(schema["$defs"]["render"]["properties"]), "and those of a render")
    examples = re.findall(r"^```json\n(.*?)^```", page, re.DOTALL | re.MULTILINE)
    check(len(examples) >= 2, "examples")
    for number, example in enumerate(examples):
        write("example.json", example)
        (what, parts), = [(key, value) for key, value in json.loads(example).items() if key in ("figures", "renders")]
        equal(gradus("figures", "example.json", "--check"), (0, "", f"example.json: {len(parts)} {what}, no problems\n"),
              f"example {number} of the page")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
