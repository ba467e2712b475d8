#!/usr/bin/env python3
"""What `gradus figures my_lecture.json` says of a wrong lecture, and whether the schema says the same.

    tests/golden/wrong_lecture_test.py [GRADUS]

Needs jsonschema (Debian: python3-jsonschema).
"""
import json
import os
import pathlib
import re
import shutil
import sys

import jsonschema

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal
from lectures import ROOT, figures, gradus, made, write


def test_problems_of_renders():
    for part in ("spot.obj", "spot.mtl", "spot_texture.png"):
        shutil.copy(ROOT / "examples/models" / part, part)
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
    flags = {flag.replace("-", "_") for flag in re.findall(r"^ +(?:-\w, )?--([\w-]+) ", gradus("render", "--help")[1], re.MULTILINE)}
    check(len(flags) > 9, sorted(flags))
    equal(set(render), flags - {"output", "report", "engine", "part", "without", "why", "frames", "array", "turntable", "jobs", "force", "color", "quiet", "help", "version"} | {"model", "name", "title", "caption"},
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
