"""The `gradus` command from end to end: what it prints, and what it leaves behind.

Usage: cli_test.py [path of gradus]        (default: $GRADUS_COMMAND)
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, INT32, check, equal, files, gradus, png, read, write
from share import in_share

MODELS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples/models")


# --- What is right ---------------------------------------------------------------------------------------------------


def test_help_and_version():
    for words in ([], ["help"], ["--help"], ["-h"]):
        result = gradus(*words)
        equal((result.code, result.err), (0, ""), f"gradus {words} gives help")
        check(result.out.index("Examples") < result.out.index("Commands"), "examples come first")
    for command in ("list", "run", "figure", "source", "cases", "check", "figures", "worksheet", "render", "demo", "inspect", "bench", "stress", "again"):
        result = gradus(command, "--help")
        equal((result.code, result.err), (0, ""), f"gradus {command} --help")
        check(result.out.startswith(f"gradus {command}: ") and "Examples\n  gradus" in result.out, result.out)
        equal(gradus("help", command).out, result.out, f"gradus help {command}") 
    result = gradus("help", "bresenham_line")
    check(all(word in result.out for word in ("--from", "--to", INT32, "--method dda", "taught")), result.out)
    equal(result.out.count("\n  gradus run bresenham_line "), 3, "three examples to paste")
    check("--from" in gradus("figure", "bresenham_line", "--help").out, "a topic's flags in a command's help")
    equal(gradus("-V").out, gradus("--version").out, "-V")
    equal(gradus("-x").err, "gradus: expected a known flag (`gradus --help` lists them), found '-x'\n", "the name once")
    result = gradus("--version")
    check(re.match(r"gradus \d+\.\d+\.\d+\n", result.out) and "cairo 1." in result.out and "unknown" not in result.out,
          result.out)


def test_examples_run():
    count = 0
    for topic in ("bresenham_circle", "bresenham_line", "flood_fill"):
        write("photo.png", png(60, 50, lambda x, y: 200 if x > 20 else 10))
        for line in gradus("help", topic).out.splitlines():
            if line.startswith("  gradus run"):
                result = subprocess.run(line.replace("gradus", f"'{GRADUS}'", 1), shell=True, capture_output=True)
                equal((result.returncode, result.stderr), (0, b""), line)
                count += 1
    check(count >= 6, f"examples tried: {count}")


def test_a_program_alone_names_what_builds_the_others():
    """`gradus bench` and `gradus stress` are programs of their own; the line that misses one names a command that exists."""
    shutil.copy(GRADUS, "gradus")
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../bootstrap")) as script:
        known = set(re.findall(r"^  (\w+)\)$", script.read(), re.M))
    for name in ("bench", "stress"):
        done = subprocess.run(["./gradus", name], capture_output=True, text=True)
        named = re.search(r"`\./bootstrap (\w+)`", done.stderr)
        check(done.returncode == 1 and done.stderr.count("\n") == 1 and named, f"gradus {name}: {done.stderr}")
        check(named and named[1] in known, f"./bootstrap {name} exists: {known}")


def test_list():
    result = gradus("list")
    check(re.search(r"^scan_conversion\n  bresenham_circle  .*\n  bresenham_line  .*\n  flood_fill ", result.out, re.M), result.out)
    equal(result.code, 0, "list")
    check("flood_fill" not in gradus("list", "LINE").out, "WORD chooses")
    check("flood_fill" in gradus("list", "bucket").out, "WORD searches aliases")
    everything = json.loads(gradus("list", "--json").out)
    check("bresenham_line" in json.dumps(everything) and "methods" in json.dumps(everything), "list --json")
    for word in ("zzz", "radiosity"):
        result = gradus("list", word)
        equal((result.code, result.out, result.err),
              (2, "", f"gradus: list: expected a word in the name, alias or title of a topic, found '{word}'\n"), "no match")
        equal(gradus("help", word).code, 2, "help and list agree on what there is not")


def test_run():
    line = ["run", "bresenham_line", "--from", "0,0", "--to", "7,3"]
    result = gradus(*line)
    equal((result.code, result.err), (0, ""), "run")
    check("\x1b" not in result.out and "go E to" in result.out, "a plain table")
    data = json.loads(gradus(*line, "--json").out)
    check({"topic", "method", "input", "steps", "result"} <= set(data), f"members of run --json: {list(data)}")
    equal(data["topic"], "bresenham_line", "topic")
    pixels = [[0, 0], [1, 0], [2, 1], [3, 1], [4, 2], [5, 2], [6, 3], [7, 3]]
    equal(data["result"]["pixels"], pixels, "result.pixels")
    check(all({"number", "type", "line"} <= set(step) for step in data["steps"]), "members of a step")
    for method in ("dda", "run_length"):
        equal(json.loads(gradus(*line, "--method", method, "--json").out)["method"], method, "method")
    part = json.loads(gradus(*line, "--json", "--steps", "3-5").out)
    equal(sorted({step["number"] for step in part["steps"]}), [3, 4, 5], "--steps in run")
    fill = json.loads(gradus("run", "flood_fill", "--maze", "..#/.#.", "--at", "0,0", "--json").out)
    equal(fill["result"]["painted"], 3, "a maze given in place")


def test_spellings_that_mean_the_same():
    expected = gradus("run", "bresenham_line", "--from", "-5,8", "--to", "3,4", "--method", "dda").out
    for words in (["run", "bresenham-line", "--from=-5,8", "--to=3,4", "--method=dda"],
                  ["ru", "BRESENHAM-L", "--fr", "(-5, 8)", "--t", "(3,4)", "--meth", "dd"],
                  ["run", "line drawing", "--from", "-5,8", "--to", " 3 , 4 ", "--method", "DDA"],
                  ["run", "--from", "-5,8", "bresenham_line", "--to", "3,4", "--method", "dda"],
                  ["-q", "run", "--quiet", "bresenham_line", "--to", "3,4", "--from", "-5,8", "--method", "dda"],
                  ["--color", "never", "run", "bresenham_line", "--to", "3,4", "--from", "-5,8", "--method", "dda"]):
        result = gradus(*words)
        equal((result.code, result.err, result.out), (0, "", expected), f"{words}")
    check(gradus("fig", "line", "-o", "-").out.startswith("<?xml"), "fig means figure, not figures")
    depth = gradus("run", "flood-fill", "--method", "depth-first").out
    equal(gradus("run", "flood_fill", "--method", "depth").out, depth, "a method's name")


def test_rings_and_numbered_orders():
    square = ["figure", "sutherland_hodgman", "--method", "separate_pieces", "--polygon", "-5,1 15,1 15,9 -5,9",
              "--step", "last", "-o"]
    gradus(*square, "holes.svg", "--hole", "2,2 3,2 3,3;(4, 4) 5,4 5,5 ;")
    gradus(*square, "same.svg", "--hole=2,2 3,2 3,3; 4,4 5,4 5,5")
    equal(read("holes.svg"), read("same.svg"), "two spellings of two holes")
    check(b"1 piece is left, with an area of 79." in read("holes.svg"), "both holes are cut out of 80")
    gradus(*square, "one.svg", "--hole", "2,2 3,2 3,3")
    check(read("one.svg") != read("holes.svg"), "one hole is not two")
    equal((gradus("again", "holes.svg", "-o", "again.svg").code, read("again.svg")), (0, read("holes.svg")), "again, with holes")
    oblique = ["run", "sutherland_hodgman", "--window-polygon", "5,-3 12,3 8,10 -2,7"]
    plain, turned = gradus(*oblique), gradus(*oblique, "--order", " 3, 1,2 ,4")
    equal((plain.code, turned.code), (0, 0), "orders by number")
    borders = [list(dict.fromkeys(re.findall(r"side border (\d)", done.out))) for done in (plain, turned)]
    equal(borders, [list("1234"), list("3124")], "the borders as they are cut at")
    equal(plain.out, gradus(*oblique, "--order", "1,2,3,4").out, "the order that they have")


def test_formats():
    line = ["figure", "bresenham_line", "--from", "0,0", "--to", "7,3"]
    starts = {"svg": b"<?xml", "png": b"\x89PNG", "pdf": b"%PDF", "html": b"<!DOCTYPE html", "csv": b"number,type,line",
              "json": b"{", "txt": b"Bresenham line", "md": b"| k | x | y |", "tex": b"% \\usepackage{booktabs}\n\\begin{tabular}{rrrrll}"}
    for ending, start in starts.items():
        name = f"line.{ending}"
        result = gradus(*line, "-o", name)
        equal((result.code, result.out, result.err), (0, "", name + "\n"), f"-o {name}")
        data = read(name)
        equal(data[:len(start)].lower(), start.lower(), f"start of {name}")
        equal(gradus(*line, "-o", "-", "--format", ending).bytes, data, f"-o - --format {ending}")
        equal(gradus(*line, "-o", name.upper(), "--format", ending.upper()).code, 0, "upper case")
        equal(read(name.upper()), data, "the same bytes again")
    equal(gradus(*line, "-o", "-").bytes, read("line.svg"), "SVG is what stdout gets")
    equal(len(re.findall(rb"/Type /Page\b", read("line.pdf"))), 8, "one page per step")
    equal(json.loads(read("line.json"))["result"]["count"], 8, "JSON of the table")
    equal(gradus("-q", *line, "-o", "q.svg").err, "", "-q says nothing")
    equal(files(), sorted([f"line.{e}" for e in starts] + [f"LINE.{e.upper()}" for e in starts] + ["q.svg"]), "no more files")


def test_series():
    line = ["figure", "bresenham_line", "--from", "0,0", "--to", "7,3"]
    result = gradus(*line, "-o", "line-{step}.png")
    equal(result.err.splitlines(), [f"line-{n}.png" for n in range(8)], "one line per file")
    equal(files(), [f"line-{n}.png" for n in range(8)], "one file per step")
    gradus(*line, "--step", "4", "-o", "four.png")
    equal(read("line-4.png"), read("four.png"), "a step of a series is that step")
    gradus(*line, "-o", "s/{step}.svg")
    check(not os.path.exists("s"), "no folder is made")
    os.mkdir("s")
    gradus(*line, "-o", "s/{step}.svg", "--steps", "1,4.1,5-7/2")
    equal(files("s"), ["1.svg", "4.1.svg", "5.svg", "7.svg"], "--steps in a series")
    gradus(*line, "-o", "s.pdf", "--steps", "2-4")
    equal(len(re.findall(rb"/Type /Page\b", read("s.pdf"))), 3, "--steps in a PDF")
    gradus(*line, "-o", "one-{step}.pdf", "--step", "3")
    equal(len(re.findall(rb"/Type /Page\b", read("one-3.pdf"))), 1, "one page of a PDF series")


def test_looks():
    line = ["figure", "bresenham_line"]
    seen = set()
    for words in ([], ["--theme", "dark"], ["--theme", "grey"], ["--theme", "high-contrast"], ["--slots", "drawing"],
                  ["--slots", "dra,tab"], ["--size", "640x360"], ["--step", "2"], ["--step", "2.1"]):
        result = gradus(*line, *words, "-o", "-")
        equal(result.code, 0, f"{words}")
        seen.add(result.bytes)
    equal(len(seen), 9, "every look is another picture")
    for words in (["--size", "16:9"], ["--layout", "slide"], ["--label", "p=p"], ["--language", "en"]):
        equal(gradus(*line, *words, "-o", "-").bytes.split(b"<metadata>")[1].split(b"</metadata>")[0],
              gradus(*line, "-o", "-").bytes.split(b"<metadata>")[1].split(b"</metadata>")[0], f"{words} changes nothing")
    equal(gradus(*line, "--theme", "light", "--size", "1280X720", "-o", "-").bytes, gradus(*line, "-o", "-").bytes,
          "what is the default is not told in the metadata")
    data = gradus(*line, "--size", "640x360", "-o", "-", "--format", "png").bytes
    equal((data[16:20], data[20:24]), ((640).to_bytes(4, "big"), (360).to_bytes(4, "big")), "size of a PNG")


# --- Metadata and again ----------------------------------------------------------------------------------------------


def test_again_is_byte_identical():
    write("photo.png", png(24, 18, lambda x, y: 250 if (x // 6 + y // 6) % 2 else 20))
    write("m.txt", "#####\r\n#...#\r\n#####\r\n")
    write("it's a maze.txt", ("." * 40 + "\n") * 40)
    os.mkdir("sub")
    inputs = {
        "plain": ["bresenham_line"],
        "step": ["bresenham_line", "--from", "-5,8", "--to", "3,4", "--step", "4", "--theme", "dark"],
        "look": ["bresenham_line", "--method", "dda", "--step", "2.1", "--slots", "sentence,drawing", "--size", "800x600"],
        "maze": ["flood_fill", "--maze", "m.txt", "--at", "2,1", "--method", "depth_first", "--step", "3"],
        "long": ["flood_fill", "--maze", "it's a maze.txt", "--at", "2,1", "--step", "30"],
        "image": ["flood_fill", "--image", "photo.png", "--at", "1,1", "--paint", "teal", "--tolerance", "9"],
    }
    for name, words in inputs.items():
        for ending in ("svg", "png", "pdf", "html"):
            if ending == "html":
                words = [w for i, w in enumerate(words) if not (w.startswith(("--step", "--slots", "--size", "--theme")) or
                         words[i - 1] in ("--step", "--slots", "--size", "--theme"))]
            made = f"{name}.{ending}"
            if not equal(gradus("figure", *words, "-o", made).code, 0, f"{made}"):
                continue
            result = gradus("again", made)
            equal((result.code, result.out, result.err), (0, "", f"{name}-again.{ending}\n"), f"again {made}")
            check(os.path.exists(f"{name}-again.{ending}") and read(made) == read(f"{name}-again.{ending}"),
                  f"again {made} gives the same bytes")
            shutil.copy(made, f"sub/{made}")
            equal(gradus("again", f"sub/{made}", "-o", f"sub/{name}-2.{ending}").code, 0, "inputs in the current folder")
            check(os.path.exists(f"sub/{name}-2.{ending}") and read(f"sub/{name}-2.{ending}") == read(made), "the same bytes")
    text = read("step.svg").decode()
    check("gradus figure bresenham_line --from -5,8 --to 3,4 --step 4 --theme dark" in text, "the canonical command")
    check(os.getcwd().encode() not in read("image.svg"), "no folders in the metadata")
    check("#####/#...#/#####" in read("maze.svg").decode(), "a short maze stands in the command")


def test_again_changes():
    gradus("figure", "bresenham_line", "--from", "1,1", "--to", "9,4", "-o", "a.svg")
    for words, same in (([], ["-o", "-"]), (["--theme", "dark"], ["--theme", "dark", "-o", "-"]),
                        (["--step", "2"], ["--step", "2", "-o", "-"]), (["--slots", "drawing"], ["--slots", "drawing", "-o", "-"])):
        expected = gradus("figure", "bresenham_line", "--from", "1,1", "--to", "9,4", *same).bytes
        equal(gradus("again", "a.svg", *words, "-o", "-").bytes, expected, f"again {words}")
    equal(gradus("again", "-", stdin=read("a.svg")).bytes, read("a.svg"), "again from stdin to stdout")
    gradus("again", "a.svg", "-o", "b.pdf")
    equal(len(re.findall(rb"/Type /Page\b", read("b.pdf"))), 9, "to another format")
    gradus("again", "a.svg", "-o", "c.html")
    check(read("c.html").lower().startswith(b"<!doctype html"), "to a player")


def test_again_with_files_gone():
    write("photo.png", png(20, 20, lambda x, y: x))
    gradus("figure", "flood_fill", "--image", "photo.png", "-o", "a.svg")
    made = read("a.svg")
    os.mkdir("elsewhere")
    os.rename("a.svg", "elsewhere/a.svg")
    equal(gradus("again", "elsewhere/a.svg").code, 0, "the input lies in the current folder")
    os.rename("photo.png", "elsewhere/photo.png")
    equal(gradus("again", "elsewhere/a.svg").code, 0, "the input lies beside the figure")
    equal(read("elsewhere/a-again.svg"), made, "the same bytes")
    write("photo.png", png(20, 20, lambda x, y: 7))
    equal(gradus("again", "elsewhere/a.svg").code, 0, "a wrong one in the current folder does not matter")
    shutil.copy("photo.png", "elsewhere/photo.png")
    before = files()
    result = gradus("again", "elsewhere/a.svg", "-o", "x.svg")
    check(result.code == 2 and "--image: expected the file with which the figure was made (fnv1a:" in result.err, result.err)
    os.remove("photo.png")
    os.remove("elsewhere/photo.png")
    result = gradus("again", "elsewhere/a.svg", "-o", "x.svg")
    equal((result.code, result.err),
          (2, "gradus: --image: expected the file 'photo.png' beside the figure or in the current folder, found none\n"),
          "a missing input")
    check("x.svg" not in files() and "x.svg" not in before, "nothing is written")


def test_again_reads_no_file_that_a_figure_names():
    line = ["bresenham_line", "--to", "3,1"]
    write("own.json", json.dumps({"symbols": {"bresenham_line": {"p": "d"}}}))
    gradus("figure", *line, "--notation", "own.json", "-o", "own.svg")
    equal((gradus("again", "own.svg", "-o", "same.svg").code, read("same.svg")), (0, read("own.svg")), "it holds its notation itself")
    gradus("figure", *line, "--notation", "foley", "-o", "a.svg")
    os.mkdir("sub")
    write("secret.json", '{"password": "hunter2"}')
    for name in ("secret.json", "../secret.json", "none.json"):
        write("sub/a.svg", read("a.svg").replace(b"--notation foley", b"--notation " + name.encode()))
        result = gradus("again", "sub/a.svg", "-o", "x.svg")
        equal((result.code, result.err),
              (2, f"gradus: again: expected a figure that holds its notation, found one that names the file {name}\n"), name)
        check("x.svg" not in files(), "nothing is written")


def test_long_texts():
    """Lines are broken and widths tried for what figures show: it is short, on the command line and in a figure's own command."""
    line, most, long = ["figure", "bresenham_line", "--to", "3,1"], "a" * 1000, "a" * 20_000
    for flag, text in (("title", ""), ("caption", ""), ("label", "p=")):
        equal(gradus(*line, f"--{flag}", text + most, "-o", "a.svg", "-f").code, 0, f"--{flag} of 1000 letters")
        equal(gradus(*line, f"--{flag}", text + "ü" * 1000, "-o", "u.svg", "-f").code, 0, f"--{flag} of 1000 letters of two bytes")
        write("long.svg", read("a.svg").replace(most.encode(), long.encode()))
        said = f"gradus: --{flag}: expected a text of up to 1000 letters, found one of 20000\n"
        result = gradus(*line, f"--{flag}", text + long, "-o", "b.svg")
        equal((result.code, result.err), (2, said), f"--{flag}")
        result = gradus("again", "long.svg", "-o", "b.svg")
        equal((result.code, result.err), (2, said), f"again, --{flag}")
    result = gradus(*line, "--notation", json.dumps({"symbols": {"bresenham_line": {"p": long}}}), "-o", "b.svg")
    check(result.code == 2 and "expected a text of up to 1000 letters, found one of 20000" in result.err, result.err)
    check("b.svg" not in files(), "nothing is written")


# --- Long runs -------------------------------------------------------------------------------------------------------


def test_long_runs():
    """Of a line and of a fill an ordinary run takes one."""
    if in_share(0, 2):
        a_long_line()
    if in_share(1, 2):
        a_long_fill()


def a_long_line():
    line = ["bresenham_line", "--to", "60000,1"]
    result = gradus("run", *line)
    steps = 50000  # of 100000 events, two per step
    equal(result.err, f"recorded {steps} of 60001 steps; --steps A-B takes a range\n", "the beginning")
    equal(gradus("run", *line, "-q").err, "", "-q")
    data = json.loads(gradus("run", *line, "--json", "--steps", "55000-55002").out)
    equal(sorted({step["number"] for step in data["steps"]}), [55000, 55001, 55002], "a range far away")
    check("step 60000 of 60000" in gradus("figure", *line, "--step", "last", "-o", "-").out, "the last step of a long run")
    check("step 25000 of 120000" in gradus("figure", "bresenham_line", "--to", "120000,1", "-o", "-").out,
          "one that decides in the middle of what is recorded")
    gradus("figure", *line, "--step", "55000", "-o", "far.svg")
    gradus("figure", *line, "--steps", "54999-55001", "-o", "far-{step}.svg")
    equal(read("far-55000.svg"), read("far.svg"), "a far step alone and in a series")
    gradus("again", "far.svg")
    equal(read("far-again.svg"), read("far.svg"), "a far step again")


def a_long_fill():
    write("big.png", png(250, 250, lambda x, y: 128))
    fill = ["flood_fill", "--image", "big.png", "--method", "depth_first"]
    result = gradus("run", *fill, "--steps", "55000-55001")
    check(result.code == 0 and "55001" in result.out, f"a fill's far steps: {result.err}")
    gradus("figure", *fill, "--step", "55000", "-o", "fill.png")
    gradus("again", "fill.png")
    equal(read("fill-again.png"), read("fill.png"), "a fill's far step again")



# --- Exact runs and models -------------------------------------------------------------------------------------------


def test_exact():
    drift = ["bresenham_line", "--to", "12,10", "--method", "dda", "--exact"]
    told = json.loads(gradus("run", *drift, "--json").out)
    equal((told["result"]["float_differs_at"], told["result"]["double_differs_at"]), ("9", ""), "where float leaves the line")
    slope = next(step for step in told["steps"] if step.get("number_") == "slope" or step["type"] == "Divided")
    equal(slope["exactly"], "5/6", "the slope as a fraction")
    equal(gradus("figure", *drift, "-o", "drift.svg").code, 0, "a figure")
    check("--exact" in gradus("again", "drift.svg", "-o", "again.svg").out + read("drift.svg").decode(), "the figure remembers it")
    equal(read("again.svg"), read("drift.svg"), "the same again")
    for words, message in (
            (["cohen_sutherland_2d", "--method", "correctly_rounded", "--exact"],
             "gradus: --exact: expected one of the methods cut_of_a_cut with it, found correctly_rounded\n"),
            (["liang_barsky", "--exact=1"], "gradus: --exact: expected no value, found '1'\n")):
        result = gradus("run", *words)
        equal((result.code, result.out, result.err), (2, "", message), " ".join(words))
    check("unknown flag '--exact'" in gradus("run", "flood_fill", "--exact").err, "a topic of whole numbers has none")
    write("deck.json", '{"figures": [{"topic": "liang_barsky", "input": {"exact": true}}, {"topic": "liang_barsky", "input": {"exact": 1}}]}')
    equal(gradus("figures", "deck.json", "--check").err,
          "gradus: deck.json:1: figures[1].input.exact: expected true or false, found 1\n", "in a lecture it is true or false")


def test_models():
    for name in ("letter_f.obj", "letter_f.mtl"):
        write(name, read(os.path.join(MODELS, name)))
    result = gradus("figure", "pipeline", "letter_f.obj", "--stage", "clipping", "-o", "a.svg")
    equal((result.code, result.out), (0, ""), "a stage of a model, given as a word")
    gradus("figure", "pipeline", "--model", "letter_f.obj", "--stage", "clipping", "-o", "b.svg")
    equal(read("b.svg"), read("a.svg"), "the same by its flag")
    check(b"--model letter_f.obj --stage clipping" in read("a.svg"), "the command that makes it again")
    gradus("again", "a.svg", "-o", "c.svg")
    equal(read("c.svg"), read("a.svg"), "made again")
    for name in ("house.obj", "house.mtl"):
        write(name, read(os.path.join(MODELS, name)))
    own = json.loads(gradus("run", "pipeline", "--json").out)
    given = json.loads(gradus("run", "pipeline", "house.obj", "--json").out)
    equal(given["result"], own["result"], "the house is what is shown when no model is given")
    equal(gradus("figure", "pipeline", "-o", "tour.html").code, 0, "the tour")
    write("bad.obj", "v 0 0 zero\n")
    for arguments, complaint in (
            (("letter_f.obj", "--model", "letter_f.obj"), "--model: expected one model, found 'letter_f.obj' and 'letter_f.obj'"),
            (("letter_f.obj", "more"), "figure: expected only a TOPIC, found 'more'"),
            (("none.obj",), "--model: expected a readable file, found 'none.obj' (No such file or directory)"),
            (("bad.obj",), "bad.obj:1: expected a number for the vertex, found 'zero'"),
            (("--eye", "1,2"), "--eye: expected 3 numbers x,y,z, found '1,2'"),
            (("--fov", "0"), "--fov: expected a number from 1 to 170, found '0'"),
            (("--face", "28"), "--face: expected a face from 0 to 27, found 28"),
            (("--pixel", "50,0"), "--pixel: expected a pixel inside the 50 × 35 picture, found 50,0")):
        result = gradus("figure", "pipeline", *arguments, "-o", "d.svg")
        equal((result.code, result.err, os.path.exists("d.svg")), (2, f"gradus: {complaint}\n", False), str(arguments))
    result = gradus("figure", "bresenham_line", "letter_f.obj", "-o", "d.svg")
    equal((result.code, result.err), (2, "gradus: figure: expected only a TOPIC, found 'letter_f.obj'\n"), "no model's topic")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
