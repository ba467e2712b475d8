#!/usr/bin/env python3
"""`gradus bench` from end to end: its table, its files, what it refuses. Nothing to do where gradus-bench was not built.

    tests/golden/bench_test.py [GRADUS]
"""
import functools
import json
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, check, equal

gradus = functools.partial(command.gradus, timeout=120)
QUICK = ["--seconds", "0.001", "--repetitions", "3"]
BENCH = pathlib.Path(GRADUS).parent / "gradus-bench"


def test_table_charts_and_json():
    result = gradus("bench", "bresenham_line", *QUICK, "-o", "made/here")
    equal((result.code, result.err), (0, ""), "gradus bench bresenham_line")
    check(result.out.startswith("bresenham_line: "), "the table names its topic")
    check(re.search(r"^\* \S", result.out, re.MULTILINE), "the table marks the best")
    for name in ("decision_parameter", "dda<float>", "run_length", "draw", "first_octant"):
        check(f" {name} " in result.out, f"the table has {name}")
    equal(sorted(os.listdir("made/here")),
          ["bench.json", "bresenham_line-error.png", "bresenham_line-error.svg",
           "bresenham_line-size.png", "bresenham_line-size.svg"], "the files")
    check(pathlib.Path("made/here/bresenham_line-error.png").read_bytes().startswith(b"\x89PNG"), "a PNG")
    check("</svg>" in pathlib.Path("made/here/bresenham_line-size.svg").read_text(), "an SVG")
    runs = json.loads(pathlib.Path("made/here/bench.json").read_text())["benchmarks"]
    check(len(runs) >= 35, "a run for every method and workload")
    for run in runs:
        check(run["run_name"].startswith("bresenham_line/") and run["time_unit"] == "ns", "name and unit")
        check(run["real_time"] > 0 and run["cpu_time"] >= 0, f"times of {run['name']}")
        check(run["error_max"] >= run["error_rms"] >= 0, f"errors of {run['name']}")
    wrong = {run["run_name"].split("/")[-1]: run["error_wrong"] for run in runs if "/all directions/" in run["run_name"]}
    equal(wrong["decision_parameter"], 0, "wrong pixels of decision_parameter")
    equal(wrong["draw"], 0, "wrong pixels of draw")
    check(wrong["first_octant"] > 0, "first_octant draws wrong pixels in other octants")


def test_charts_again_without_measuring():
    first = gradus("bench", "viewing", "bresenham_line", *QUICK, "-o", "made")
    again = gradus("bench", "--from", "made/bench.json", "-o", "again")
    equal((again.code, again.err), (0, ""), "gradus bench --from")
    equal(again.out, first.out, "its tables")
    equal(set(os.listdir("again")), set(os.listdir("made")) - {"bench.json"}, "its charts")
    for name in os.listdir("again"):
        equal(pathlib.Path("again", name).read_bytes(), pathlib.Path("made", name).read_bytes(), name)
    check("Choose draw: " in pathlib.Path("again/bresenham_line-error.svg").read_text(), "the method to choose")
    one = gradus("bench", "viewing", "--from", "made/bench.json", "--theme", "dark", "-o", "dark")
    equal((one.code, sorted(os.listdir("dark"))),
          (0, ["viewing-error.png", "viewing-error.svg", "viewing-size.png", "viewing-size.svg"]), "one topic of it")
    check(pathlib.Path("dark/viewing-error.svg").read_bytes() != pathlib.Path("made/viewing-error.svg").read_bytes(), "in another theme")
    pathlib.Path("made/bench.json").write_text("{}")
    for words, message in (
            (["--json"], "--json: nothing is measured with --from"),
            (["--seconds", "1"], "--seconds: nothing is measured with --from"),
            ([], "--from: expected a bench.json of gradus bench, found 'made/bench.json' ("),
            (["--theme", "pink"], "--theme: expected one of light, dark, greyscale, high_contrast, print, found 'pink'")):
        result = gradus("bench", "--from", "made/bench.json", *words)
        equal((result.code, result.out), (2, ""), " ".join(words))
        check(result.err.startswith(f"gradus bench: {message}") and result.err.count("\n") == 1, result.err)
    equal(gradus("bench", "--from", "none.json").code, 2, "no file")


def test_files_of_others_stay():
    again = ["bench", "viewing", *QUICK, "-o", "made"]
    equal([gradus(*again).code, gradus(*again).code], [0, 0], "over its own files")
    for name in ("bench.json", "viewing-error.svg"):
        kept = pathlib.Path("made", name).read_bytes()
        mine = b'{\n  "context": {\n    "date": "today"\n  },\n  "benchmarks": [],\n  "gradus": ""\n}\n'
        pathlib.Path("made", name).write_bytes(mine)
        result = gradus(*again)
        equal((result.code, result.out, result.err),
              (2, "", f"gradus bench: --output: expected a new file or one that gradus made, found 'made/{name}' (--force replaces it)\n"),
              f"somebody's {name}")
        equal(pathlib.Path("made", name).read_bytes(), mine, "stays")
        pathlib.Path("made", name).write_bytes(kept)
    pathlib.Path("made/bench.json").write_text("mine")
    equal(gradus(*again, "--force").code, 0, "--force")


def test_json_alone():
    result = gradus("bench", "parallel", *QUICK, "--json")
    equal(result.code, 0, "gradus bench parallel --json")
    check(all(run["run_name"].startswith("parallel/") for run in json.loads(result.out)["benchmarks"]), "JSON alone")
    equal(os.listdir("."), [], "no file without -o")


def test_names():
    two = gradus("bench", "viewp", "viewing", *QUICK)
    equal(two.code, 0, "a beginning and a whole name")
    equal(re.findall(r"^(\w+): ", two.out, re.MULTILINE), ["viewport", "viewing"], "in the order given")


def test_bad_input_is_one_line():
    open("file", "w").close()
    number = "expected a number above 0, up to {}, found '{}'"
    table = [
        (["nosuch_topic"], "TOPIC: expected the name of a topic (`gradus list` shows all), found 'nosuch_topic'"),
        (["parallel", "--seconds", "0"], "--seconds: " + number.format(60, "0")),
        (["parallel", "--seconds", "-1"], "--seconds: " + number.format(60, "-1")),
        (["parallel", "--seconds", "nan"], "--seconds: " + number.format(60, "nan")),
        (["parallel", "--seconds", "61"], "--seconds: " + number.format(60, "61")),
        (["parallel", "--repetitions", "many"], "--repetitions: " + number.format(1000, "many")),
        (["parallel", "-o", "file"], "--output: expected a folder, found 'file'"),
        (["parallel", "-o", "file/below"],
         "--output: expected a folder that can be made, found 'file/below' (Not a directory)"),
    ]
    for words, message in table:
        result = gradus("bench", *words)
        equal((result.code, result.out, result.err), (2, "", f"gradus bench: {message}\n"), " ".join(words))
    equal(os.listdir("."), ["file"], "nothing else is written")


def test_no_comparison_without_the_peer():
    if b"libOSMesa" in BENCH.read_bytes():
        return  # it is built with Mesa: `gradus bench engine` compares
    result = gradus("bench", "engine", "--require-peers", "--json")
    equal((result.code, result.out, result.err), (2, "", "gradus bench: --require-peers: what engine is compared with is not there\n"), "no peer")


def main():
    if not BENCH.exists():
        result = gradus("bench", "parallel")
        equal((result.code, result.out, result.err.count("\n")), (1, "", 1), "without gradus-bench: one line")
        check("./bootstrap bench" in result.err, "it says how to build it")
        return command.summary()
    return command.run_all(globals())


if __name__ == "__main__":
    sys.exit(main())
