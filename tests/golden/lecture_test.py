#!/usr/bin/env python3
"""Lectures from end to end: what `gradus figures my_lecture.json` makes, what it says of a wrong one, and its schema.

    tests/golden/lecture_test.py [GRADUS]

Needs jsonschema (Debian: python3-jsonschema) and qpdf.
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

import jsonschema

GRADUS = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.environ["GRADUS_COMMAND"])
ROOT = pathlib.Path(os.environ.get("GRADUS_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
LINE = {"topic": "bresenham_line", "input": {"from": "0,0", "to": "9,4"}}
passed = failed = 0


def check(truth, what):
    global passed, failed
    if truth:
        passed += 1
    else:
        failed += 1
        print("FAILED:", what)


def equal(found, expected, what):
    check(found == expected, f"{what}\n    expected: {expected!r}\n    found:    {found!r}")


def gradus(*words, stdin=b"", cwd=None):
    """Exit code, stdout, stderr."""
    done = subprocess.run([GRADUS, *words], input=stdin, capture_output=True, timeout=300, cwd=cwd)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def write(path, content):
    pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    text = content if isinstance(content, str) else json.dumps(content)
    pathlib.Path(path).write_text(text, encoding="utf-8")


def figures(*members, **deck):
    """A lecture; a figure is a line, unless it says otherwise."""
    return {**deck, "figures": [{**LINE, **member} for member in members]}


def made(folder):
    """Name -> hash of all files but the manifest, which holds times."""
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(pathlib.Path(folder).rglob("*"))
            if path.is_file() and path.name != ".gradus-manifest.json"}


def in_new_folder(test):
    folder = tempfile.mkdtemp(prefix="gradus_lecture_")
    os.chdir(folder)
    try:
        test()
    except Exception as error:  # one broken test must not hide the others
        check(False, f"{test.__name__}: {type(error).__name__}: {error}")
    finally:
        os.chdir("/")
        shutil.rmtree(folder, ignore_errors=True)


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
    equal(gradus("figures", "mine.json", "-o", "mine", "-q")[0], 0, "a copy of the gallery")
    gradus("figures", "-o", "built_in", "-q")
    equal(made("mine"), made("built_in"), "the same figures, without a file and from a copy")


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
    equal((code, out, err), (2, "", "gradus: --theme: expected one of light, dark, greyscale, high_contrast, found 'drak', did "
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
    check(all(part.get("description") for part in (*schema["properties"].values(), *figure["properties"].values())),
          "every key has a description")

    gallery = json.loads((ROOT / "examples/gallery.json").read_text(encoding="utf-8"))
    check(valid(schema, gallery), "the gallery is valid")
    wrong = 0
    for lecture in (
            figures({}), figures({"step": 4.1}), figures({"steps": [1, "3-4"]}), figures({"slots": ["drawing"]}),
            figures({"input": {"from": [0, 0], "to": "3,4"}}), figures({"outputs": "pdf"}), figures({"outputs": ["csv", "txt"]}),
            figures({"topic": "flood_fill", "input": {"connectivity": 8, "tolerance": 0}}),
            figures({"topic": "flood_fill", "input": {"maze": ["##", "#."], "at": "1,1"}}), figures({"name": "A-1_b"}),
            {**figures({}), "$schema": "x", "title": "T", "theme": "dark", "outputs": ["svg"]},
            # and wrong ones
            [], {}, {"figures": []}, {"figures": {}}, {"figures": [{}]}, {"figures": [{"topic": "bresenham_line"}]},
            {"figures": [{"input": {}}]}, figures({"topic": "bresenham"}), figures({"methd": "dda"}), figures({"method": "breadth_first"}),
            figures({"input": {"start": "0,0"}}), figures({"input": {"from": [0, 0, 0]}}), figures({"input": {"from": 4}}),
            figures({"input": {"from": [0.5, 1]}}), figures({"input": "0,0"}), figures({"theme": 4}), figures({"theme": "drak"}),
            figures({"step": True}), figures({"step": [1]}), figures({"steps": []}), figures({"outputs": []}), figures({"outputs": ["pgn"]}),
            figures({"name": "../x"}), figures({"name": "-x"}), figures({"name": ""}), figures({"name": "x" * 81}), figures({"caption": 1}),
            figures({"topic": "flood_fill", "input": {"connectivity": 5}}), figures({"topic": "flood_fill", "input": {"tolerance": 256}}),
            figures({"figures": []}), {**figures({}), "topic": "flood_fill"}, {**figures({}), "method": "dda"}, {**figures({}), "them": "dark"}):
        write("s.json", lecture)
        code = gradus("figures", "s.json", "--check")[0]
        equal(code, 0 if valid(schema, lecture) else 2, f"--check and the schema agree on {json.dumps(lecture)[:200]}")
        wrong += code == 2
    check(wrong == 33, f"{wrong} of them are wrong")

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
    rows = set(re.findall(r"^\| `([\w$]+)` \|", page, re.MULTILINE))
    equal(rows, set(schema["properties"]) | set(schema["$defs"]["figure"]["properties"]), "keys in the tables of docs/lecture.md")
    examples = re.findall(r"^```json\n(.*?)^```", page, re.DOTALL | re.MULTILINE)
    check(len(examples) >= 2, "examples")
    for number, example in enumerate(examples):
        write("example.json", example)
        count = len(json.loads(example)["figures"])
        equal(gradus("figures", "example.json", "--check"), (0, "", f"example.json: {count} figures, no problems\n"),
              f"example {number} of the page")


def main():
    tests = [value for name, value in globals().items() if name.startswith("test_")]
    for test in tests:
        in_new_folder(test)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
