"""The `gradus` command from end to end: what it prints, its exit codes, and what it leaves behind.

Usage: cli_test.py [path of gradus]        (default: $GRADUS_COMMAND)
"""
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
import project
from command import GRADUS, PLAIN, check, equal, files, gradus, on_terminal, png, read, wait_for, write

MODELS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples/models")
INT32 = "-2147483648 to 2147483647"


# --- What is right ---------------------------------------------------------------------------------------------------


def test_help_and_version():
    for words in ([], ["help"], ["--help"], ["-h"]):
        result = gradus(*words)
        equal((result.code, result.err), (0, ""), f"gradus {words} gives help")
        check(result.out.index("Examples") < result.out.index("Commands"), "examples come first")
    for command in ("list", "run", "figure", "figures", "render", "bench", "stress", "again"):
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


def test_help_is_quick():
    times = []
    for _ in range(15):
        start = time.perf_counter()
        gradus("--help")
        times.append(1000 * (time.perf_counter() - start))
    print(f"gradus --help: {min(times):.1f} ms (best of {len(times)}, process start included)")
    check(min(times) < 30, "gradus --help under 30 ms")


def test_list():
    result = gradus("list")
    check(re.search(r"^scan_conversion\n  bresenham_circle  .*\n  bresenham_line  .*\n  flood_fill ", result.out, re.M), result.out)
    equal(result.code, 0, "list")
    check("flood_fill" not in gradus("list", "LINE").out, "WORD chooses")
    check("flood_fill" in gradus("list", "bucket").out, "WORD searches aliases")
    everything = json.loads(gradus("list", "--json").out)
    check("bresenham_line" in json.dumps(everything) and "methods" in json.dumps(everything), "list --json")
    for word in ("zzz", "gouraud"):
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
    equal(len(re.findall(rb"/Type /Page\b", read("line.pdf"))), 8, "one page a step")
    equal(json.loads(read("line.json"))["result"]["count"], 8, "JSON of the table")
    equal(gradus("-q", *line, "-o", "q.svg").err, "", "-q says nothing")
    equal(files(), sorted([f"line.{e}" for e in starts] + [f"LINE.{e.upper()}" for e in starts] + ["q.svg"]), "no more files")


def test_series():
    line = ["figure", "bresenham_line", "--from", "0,0", "--to", "7,3"]
    result = gradus(*line, "-o", "line-{step}.png")
    equal(result.err.splitlines(), [f"line-{n}.png" for n in range(8)], "one line a file")
    equal(files(), [f"line-{n}.png" for n in range(8)], "one file a step")
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


# --- What is wrong ---------------------------------------------------------------------------------------------------


def test_wrong_input():
    write("in.txt", "#.#\n#x\n")
    write("bad.txt", "#.#\n#!#\n")
    write("empty.txt", "")
    write("no.png", "GIF89a")
    write("cut.png", png(20, 20, lambda x, y: x)[:60])
    write("ok.png", png(4, 4, lambda x, y: x))
    write("plain.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>")
    write("evil.svg", '<svg><metadata gradus-command="gradus figures -o /tmp/evil"/></svg>')
    write("evil2.svg", '<svg><metadata gradus-command="gradus figure bresenham_line -o /tmp/evil.svg"/></svg>')
    os.mkdir("folder")
    gradus("figure", "bresenham_line", "--to", "2,1", "-o", "x.svg")
    line, fill = ["figure", "bresenham_line"], ["figure", "flood_fill"]
    out = ["-o", "x.svg"]
    poly = ["run", "sutherland_hodgman"]
    pieces, oblique = [*poly, "--method", "separate_pieces"], [*poly, "--window-polygon", "5,-3 12,3 8,10 -2,7"]
    space, axes = [*poly, "--method", "homogeneous", "--homogeneous"], ["run", "viewing", "--method", "inverse_of_any_frame", "--axes"]
    numbers = "--order: expected the numbers 1 to 4 of the window's borders, each once in any order, found "
    topics = "TOPIC: expected the name of a topic (`gradus list` shows all), found "
    cell = f"expected two whole numbers from {INT32} like 3,4, found "
    size = "--size: expected a width and a height like 1280x720 or 12cmx8cm (160 to 8192 pixels, 96 an inch), or a ratio like 4:3, found "
    steps = "--steps: expected steps like 3-9 or 1,4,9-12, found "
    table = [
        # command, topic, flags
        (["lits"], "COMMAND: expected one of list, help, run, figure, figures, render, bench, stress, again, open, completion, man, found 'lits', did you mean 'list'?"),
        (["zzz"], "COMMAND: expected one of list, help, run, figure, figures, render, bench, stress, again, open, completion, man, found 'zzz'"),
        (["run"], "run: expected a TOPIC, found none (`gradus run --help` shows examples)"),
        (["run", "bresenhm_line"], topics + "'bresenhm_line', did you mean 'bresenham_line'?"),
        (["run", "radiosity"], topics + "'radiosity'"),
        (["run", "\x1b[31m\n"], topics + r"'\x1b[31m\n'"),
        (["help", "bresenhm_lin"], topics + "'bresenhm_lin', did you mean 'bresenham_line'?"),
        (["run", "flood_fill", "--paint", "red"], "--paint: expected a letter for a maze, found a colour"),
        (["run", "flood_fill", "--color", "red"], "--color: expected one of auto, always, never, found 'red'"),
        (["run", "bresenham_line", "--window", "5,0,3,1"], "--window: expected xmin <= xmax, not 5 > 3, found '5,0,3,1'"),
        (["run", "bresenham_line", "--window", "0,0,3,1", "--method", "dda"],
         "--window: method dda has none: it walks to every pixel"),
        (["run", "bresenham_line", "x"], "run: expected only a TOPIC, found 'x'"),
        (["list", "a", "b"], "list: expected at most one WORD, found 'b'"),
        (["figures", "x"], "LECTURE: expected a readable file, found 'x' (No such file or directory)"),
        (["figures", "x", "y"], "figures: expected at most one LECTURE, found 'y'"),
        (["again"], "again: expected a FILE, found none (`gradus again --help` shows examples)"),
        ([*line, *out, "--form=x"], "--format: expected one of svg, png, pdf, html, csv, md, tex, json, txt, gif, mp4, webp, pptx, found 'x'"),
        ([*line, *out, "--frm", "1,1"], re.compile(r"figure bresenham_line: unknown flag '--frm', did you mean '--from'\? Expected one of --from, .*")),
        ([*line, *out, "--s", "1"], "expected one of --step, --steps, --snippet, --slots, --size, --scale, --svg-text, --seconds-per-step, found '--s'"),
        ([*line, *out, "-z"], "figure: expected a known flag (`gradus figure --help` lists them), found '-z'"),
        (["list", "--json=1"], "--json: expected no value, found '1'"),
        (["list", "--only", "x"], re.compile(r"list: unknown flag '--only': expected one of --json, .*")),
        (["run", "bresenham_line", "--color", "sometimes"], "--color: expected one of auto, always, never, found 'sometimes'"),
        # values
        ([*line, *out, "--from"], "--from: expected a value like 0,0, found none"),
        ([*line, *out, "--from="], "--from: expected a value like 0,0, found none"),
        ([*line, *out, "--from", "--to", "1,1"], "--from: expected a value like 0,0, found none"),
        ([*line, *out, "--from", "1,1", "--from", "2,2"], "--from: expected one value, found '1,1' and '2,2'"),
        ([*line, *out, "--from", "1/3,2"], "--from: " + cell + "'1/3,2'"),
        ([*line, *out, "--to", "3"], "--to: " + cell + "'3'"),
        ([*line, *out, "--to", "3,2147483648"], "--to: " + cell + "'3,2147483648'"),
        ([*line, *out, "--to", "a\x07,b"], "--to: " + cell + r"'a\x07,b'"),
        ([*line, *out, "--method", "ddb"], re.compile(r"--method: expected one of decision_parameter, .*, found 'ddb', did you mean 'dda'\?")),
        ([*fill, *out, "--tolerance", "256"], "--tolerance: expected a whole number from 0 to 255, found '256'"),
        ([*fill, *out, "--connectivity", "6"], "--connectivity: expected one of 4, 8, found '6'"),
        ([*fill, *out, "--paint", "pink"], re.compile(r"--paint: expected a colour #rrggbb or one of black, .*, found 'pink'")),
        ([*fill, *out, "--at", "99,0"], re.compile(r"--at: expected .*, found '?99,0'?")),
        # lists of rings, orders by number, points in clip space
        ([*poly, "--hole", "4,4 6,4 6,6"], "--hole: holes are cut by --method separate_pieces alone"),
        ([*pieces, "--hole", "4,4 6,4 6,6; 7,1 8,1"], "--hole: ring 2: expected at least 3 points, with ; between rings alone, found 2"),
        ([*pieces, "--hole", "4,4; 6,4; 6,6"], "--hole: ring 1: expected at least 3 points, with ; between rings alone, found 1"),
        ([*pieces, "--hole", "4,4 6,4 6,6; 7,1 8,1 8,x"], "--hole: ring 2: point 3: expected a number like 3, -5, 1/3 or 0.25, found 'x'"),
        ([*pieces, "--hole", ";"], "--hole: expected rings of points x,y, with ; between rings, found ';'"),
        ([*poly, "--order", "3,1,2,4"], "--order: expected left,right,bottom,top, each once in any order, found '3,1,2,4': "
         "numbers are for the borders of --window-polygon"),
        ([*oblique, "--order", "3,1,2"], numbers + "'3,1,2'"),
        ([*oblique, "--order", "5,3,1,2,4"], numbers + "'5,3,1,2,4'"),
        ([*oblique, "--order", "top,left,right,bottom"], numbers + "'top,left,right,bottom'"),
        ([*oblique, "--order", "1,1,2,3"], "--order: expected left,right,bottom,top or the numbers 1, 2, … to the last, "
         "each once in any order, found '1,1,2,3'"),
        ([*space, "0,0,1,1 1,0,1,1"], "--homogeneous: expected at least 3 points, found 2"),
        ([*space, "0,0,1,1 1,0,1,1 1,1,1"], "--homogeneous: point 3: expected 4 numbers x,y,z,w, found '1,1,1'"),
        ([*space, "0,0,1,1 0,0,0,0 1,1,1,1"], "--homogeneous: point 2: 0,0,0,0 is no point"),
        ([*space, "0,0,1,1 1,0,1,1 1,1,1,1e7"], "--homogeneous: point 3: expected numbers that are 0 or from 0.000001 to "
         "1000000 in size, found '1,1,1,10000000'"),
        ([*space[:-1], "--window-polygon", "0,0 1,0 1,1"],
         "--window-polygon: method homogeneous clips at the planes of clip space alone"),
        ([*axes, "1,0,0 0,1,0"], "--axes: expected at least 3 points, found 2"),
        ([*axes, "1,0,0 0,1,0 1,1,0"], "--axes: three axes that don't lie in one plane expected, found 1,0,0 0,1,0 1,1,0"),
        ([*axes, "1,0,0 0,1,0 0,0,0"], "--axes: axes of lengths from 0.001 to 1000 expected, found 1,0,0 0,1,0 0,0,0"),
        # steps
        ([*line, *out, "--step", "9"], "--step 9: bresenham_line has steps 0..7 for this input"),
        ([*line, *out, "--step", "x"], "--step: expected a step like 4 or 4.1, or last, found 'x'"),
        ([*line, *out, "--step", "4.9"], "--step 4.9: bresenham_line has 4.1..4.1 after step 4 for this input"),
        ([*line, *out, "--panels", "7"], "--panels: expected phases, or 2 to 6 steps like 1,4,9, found '7'"),
        ([*line, *out, "--panels", "0-6"], "--panels: expected phases, or 2 to 6 steps like 1,4,9, found '0-6'"),
        ([*line, *out, "--panels", "1,9"], "--panels 1,9: bresenham_line has steps 0..7 for this input"),
        ([*line, *out, "--panels", "1,2", "--step", "3"], "--panels: expected either this or --step, found both"),
        ([*line, *out, "--panels", "1,2", "--compare", "dda"], "--panels: expected either this or --compare, found both"),
        ([*line, "-o", "x-{step}.svg", "--panels", "1,2"], "--panels: expected a name without {step} for one sheet, found 'x-{step}.svg'"),
        ([*line, "-o", "x.html", "--panels", "1,2"], "--panels: expected svg, png, pdf or pptx, found html"),
        ([*line, *out, "--compare", "flood_fill"],
         "--compare: expected a topic that takes --from as bresenham_line does, found 'flood_fill'"),
        ([*line, *out, "--compare", "--theme dark"], "--compare: expected inputs of bresenham_line, found '--theme'"),
        ([*line, *out, "--compare", "--to x"], "--to: expected two whole numbers from -2147483648 to 2147483647 like 3,4, found 'x'"),
        ([*line, *out, "--steps", "2-4"], "--steps: expected one step for one picture ({step} in the name of -o makes one file a step), found '2-4'"),
        ([*line, "-o", "x.pdf", "--steps", "2-9"], "--steps 2-9: bresenham_line has steps 0..7 for this input"),
        ([*line, "-o", "x.pdf", "--steps", "4-2"], steps + "'4-2'"),
        ([*line, "-o", "x.pdf", "--step", "1", "--steps", "2"], "--step: expected either this or --steps, found both"),
        ([*line, "-o", "x.html", "--steps", "1,4"], "--steps: expected one range like 3-9 for a player, found '1,4'"),
        ([*line, "--to", "900000,1", "-o", "x.pdf", "--steps", "0-9000"], re.compile(r"--steps: expected at most \d+ steps for one PDF \(.*\), found 9001")),
        # looks
        ([*line, *out, "--theme", "drak"], "--theme: expected one of light, dark, greyscale, high_contrast, print, found 'drak', did you mean 'dark'?"),
        ([*line, *out, "--slots", "drawing,tables"], "--slots: expected one of title, drawing, listing, table, sentence, footer, found 'tables', did you mean 'table'?"),
        ([*line, *out, "--size", "12x9"], size + "'12x9'"),
        *[([*line, *out, "--size", word], size + f"'{word}'") for word in ("foo", "12cm", "4:0", "1:99", "12cmx", "0x0", "9999x9", "1e3x1e3")],
        ([*line, "-o", "x.html", "--size", "4:3"], "--size: expected svg, png, pdf, pptx or a film to draw, found html"),
        ([*line, "-o", "x.csv", "--theme", "dark"], "--theme: expected svg, png, pdf, pptx, html or a film, found csv"),
        ([*line, *out, "--scale", "2"], "--scale: expected png, gif, mp4 or webp, found svg"),
        ([*line, "-o", "x.png", "--svg-text", "text"], "--svg-text: expected svg, found png"),
        ([*line, "-o", "x.png", "--scale", "9"], "--scale: expected a number from 0.1 to 8, found '9'"),
        ([*line, "-o", "x.png", "--scale", "nan"], "--scale: expected a number from 0.1 to 8, found 'nan'"),
        ([*line, "-o", "x.pdf", "--paper", "letter"], "--paper: expected --handout with it, found letter alone"),
        ([*line, *out, "--layout", "poster"], "--layout: expected one of slide, handout, found 'poster'"),
        ([*line, *out, "--y", "left"], "--y: expected one of up, down, found 'left'"),
        ([*line, *out, "--view", "5,0,3,1"], "--view: expected xmin <= xmax, not 5 > 3, found '5,0,3,1'"),
        ([*line, *out, "--background", "pinkish"], re.compile(r"--background: expected a colour #rrggbb or one of .*, found 'pinkish'")),
        ([*line, *out, "--slots", "title", "--no-title"], "--no-title: expected another slot beside the title, found 'none'"),
        # words
        ([*line, *out, "--label", "p"], "--label: expected a symbol and a name for it like p=d, found 'p'"),
        ([*line, *out, "--label", "p="], "--label: expected a text, found ''"),
        ([*line, *out, "--label", "p=\u2603"], "--label: expected letters that can be drawn (the figures' fonts have no glyph for U+2603), found '\u2603'"),
        ([*line, *out, "--title", "a\nb"], "--title: expected a text on one line, found 'a\\nb'"),
        ([*line, *out, "--language", "xx"], "--language: expected one of en, de, found 'xx'"),
        # snippets
        ([*line, *out, "--snippet", "beamer"], "--snippet: expected pdf, png to show in beamer, found svg"),
        ([*line, "-o", "x.pdf", "--snippet", "reveal"], "--snippet: expected svg, png, html, gif, webp, mp4 to show in reveal, found pdf"),
        ([*line, "-o", "-", "--snippet", "markdown"], "--snippet: expected a file after -o, found -"),
        ([*line, *out, "--snippet", "word"], "--snippet: expected one of beamer, reveal, markdown, found 'word'"),
        # files
        (line, "-o: expected a file like line.svg, or - for standard output, found none"),
        ([*line, "-o", "x.bmp"], "-o: expected a name that ends in .svg, .png, .pdf, .html, .csv, .md, .tex, .json, .txt, .gif, .mp4, .webp, .pptx (or --format), found 'x.bmp'"),
        ([*line, "-o", "x.csv/"], re.compile(r"-o: expected a name that ends in .*, found 'x.csv/'")),
        ([*line, "-o", "no/x.svg"], "-o: expected a folder that exists, found 'no'"),
        ([*line, "-o", "folder", "--format", "svg"], "-o: expected a file's name, found 'folder'"),
        ([*line, "-o", "{step}.csv"], "-o: expected {step} for svg, png or pdf only, found '{step}.csv'"),
        ([*fill, *out, "--image", "gone.png"], "--image: expected a readable file, found 'gone.png' (No such file or directory)"),
        ([*fill, *out, "--image", "folder"], "--image: expected a regular file, found the folder 'folder'"),
        ([*fill, *out, "--image", "no.png"], "--image: 'no.png': expected a PNG file, found something else"),
        ([*fill, *out, "--image", "cut.png"], re.compile(r"--image: 'cut.png': expected a whole PNG file, found .*")),
        ([*fill, *out, "--image", "-"], "--image: standard input: expected a PNG file, found an empty one"),
        ([*fill, *out, "--maze", "gone.txt"], "--maze: expected a readable file, found 'gone.txt' (No such file or directory)"),
        ([*fill, *out, "--maze", "in.txt"], re.compile(r"in\.txt:2: found 2 cells, expected 3 .*")),
        ([*fill, *out, "--maze", "bad.txt"], re.compile(r"bad\.txt:2: found '!' in column \d, expected .*")),
        ([*fill, *out, "--maze", "empty.txt"], re.compile(r"empty\.txt:1: found nothing, expected .*")),
        ([*fill, "--image", "ok.png", "--at", "1,1", "-o", "ok.png"], "-o: expected another file than the input, found 'ok.png'"),
        ([*fill, "--image", "ok.png", "--at", "1,1", "-o", "./ok.png"], "-o: expected another file than the input, found './ok.png'"),
        (["again", "gone.svg"], "again: expected a readable file, found 'gone.svg' (No such file or directory)"),
        (["again", "plain.svg"], "again: expected a figure made by gradus (SVG, PNG, PDF, player or film), found 'plain.svg'"),
        (["again", "in.txt"], "again: expected a figure made by gradus (SVG, PNG, PDF, player or film), found 'in.txt'"),
        (["again", "evil.svg"], "again: expected a figure with a `gradus figure` or `gradus render` command in it, found 'evil.svg'"),
        (["again", "evil2.svg"], "again: expected a figure with a `gradus figure` or `gradus render` command in it, found 'evil2.svg'"),
        (["figures", "-o", "in.txt"], "-o: expected a folder, found 'in.txt'"),
        (["figures", "-o", "new", "--jobs", "0"], "--jobs: expected a whole number from 1 to 1024, found '0'"),
    ]
    before = {name: read(name) for name in files()}
    for words, expected in table:
        result = gradus(*words)
        text = result.err[len("gradus: "):].rstrip("\n")
        right = expected.fullmatch(text) if hasattr(expected, "fullmatch") else text == expected
        check(result.err.startswith("gradus: ") and result.err.count("\n") == 1 and right,
              f"{words}\n    expected: {getattr(expected, 'pattern', expected)}\n    found:    {result.err!r}")
        equal((result.code, result.out), (2, ""), f"exit code and stdout of {words}")
    equal({name: read(name) for name in files()}, before, "wrong input writes nothing")
    check(not os.path.exists("new") and not os.path.exists("/tmp/evil") and not os.path.exists("/tmp/evil.svg"),
          "no folder is left behind")
    gradus("figure", "bresenham_line", "-o", "f.svg")
    equal((gradus("again", "f.svg", "-o", "f.svg").code, gradus("again", "f.svg", "-o", "f.svg").err),
          (2, "gradus: -o: expected another file than the input, found 'f.svg'\n"), "again onto itself")


def test_output_that_fails():
    with open("/dev/full", "wb") as full:
        for words in (["list"], ["help"], ["--version"], ["run", "bresenham_line"], ["figure", "bresenham_line", "-o", "-"]):
            result = gradus(*words, stdout=full)
            equal((result.code, result.err),
                  (1, "gradus: can't write to standard output: No space left on device\n"), f"full disk: {words}")
    result = subprocess.run(f"'{GRADUS}' list >&-", shell=True, capture_output=True)
    equal((result.returncode, result.stderr),
          (1, b"gradus: can't write to standard output: Bad file descriptor\n"), "closed stdout")
    result = subprocess.run(f"'{GRADUS}' figure bresenham_line -o closed.svg >&- 2>&- <&-", shell=True)
    equal(result.returncode, 0, "all streams closed")
    gradus("figure", "bresenham_line", "-o", "open.svg")
    equal(read("closed.svg"), read("open.svg"), "all streams closed: the same file")
    result = subprocess.run(f"'{GRADUS}' run bresenham_line --to 90000,7 | head -1; exit ${{PIPESTATUS[0]}}", shell=True,
                            executable="/bin/bash", capture_output=True)
    equal((result.returncode, result.stderr), (1, b""), "a reader that goes away is no news")
    result = gradus("figure", "bresenham_line", "--format", "svg", "-o", "/dev/full")
    equal((result.code, result.err), (1, "gradus: can't write '/dev/full': No space left on device\n"), "-o /dev/full")
    check(os.path.exists("/dev/full") and not os.path.isfile("/dev/full"), "/dev/full is still there")

    # A disk that is full in the middle of a file, and of a series
    def limited():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000))
    before = files()
    for name in ("big.svg", "big-{step}.svg"):
        result = gradus("figure", "bresenham_line", "-o", name, preexec_fn=limited)
        check(result.code == 1 and "File too large" in result.err, f"{name}: {result.err}")
    equal(files(), before, "nothing half-written")


def test_read_only_folder():
    if os.geteuid() == 0 and not shutil.which("setpriv"):
        return check(True, "root may write everywhere")
    os.mkdir("closed")
    os.chmod("closed", 0o555)
    # Root stays root, so that it can still read the project wherever that lies, but obeys permissions
    prefix = ["setpriv", "--bounding-set=-dac_override"] if os.geteuid() == 0 else []
    for words in (["figure", "bresenham_line", "-o", "closed/x.svg"], ["figures", "-o", "closed/out"]):
        result = subprocess.run([*prefix, GRADUS, *words], capture_output=True, text=True)
        check(result.returncode == 1 and result.stderr.count("\n") == 1 and "Permission denied" in result.stderr,
              f"{words}: {result.returncode} {result.stderr!r}")
    equal(files("closed"), [], "nothing in a read-only folder")


# --- The terminal ----------------------------------------------------------------------------------------------------


SANITIZED = b"__asan_init" in read(GRADUS) if os.path.exists(GRADUS) else False


def limited():
    """A run that would take all memory or all time ends in an error instead."""
    if not SANITIZED:  # what a sanitizer reserves is far more
        resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))
    resource.setrlimit(resource.RLIMIT_CPU, (20, 20))


def test_what_no_scale_can_show():
    for flag, words in (
            ("--circle", ["liang_barsky_circle", "--circle", "1e17,0,5"]),
            ("--circle", ["liang_barsky_circle", "--circle", "1e18,0,5"]),
            ("--circle", ["polygon_circle", "--circle", "1e18,0,5"]),
            ("--window", ["cohen_sutherland_2d", "--window", "1e17,0,1e17,10"]),
            ("--window", ["liang_barsky", "--window", "1e17,0,1e17,10"]),
            ("--window", ["viewport", "--window", "1e17,0,100000000000000010,10"]),
            ("--polygon", ["affine_2d", "--polygon", "1e308,0 2,0 2,1 0,1"]),
            ("--polygon", ["affine_2d", "--factors", "translate 0,0", "--polygon", "1e17,0 100000000000000100,0 1e17,10"]),
            ("--polygon", ["sutherland_hodgman", "--polygon", "1e308,0 2,0 2,1"]),
            ("--points", ["viewport", "--points", "1e308,1e308"]),
            ("--eye", ["pipeline", "--eye", "1e308,1,3"])):
        result = gradus("run", *words, preexec_fn=limited)
        check(result.code == 2 and result.out == "" and result.err.startswith(f"gradus: {flag}: expected ") and
              result.err.count("\n") == 1, f"{words}: {result.code} {result.err!r}")
    for words in (["liang_barsky_circle", "--circle", "1e9,0,5"], ["cohen_sutherland_2d", "--window", "1e9,0,1000000010,10"]):
        result = gradus("run", *words, preexec_fn=limited)
        equal((result.code, result.err), (0, ""), f"{words}: far away is fine")


def test_lines_fit_the_terminal():
    def longest(text):
        lines = [re.sub("\x1b\\[[0-9;]*m", "", line) for line in text.splitlines()]
        # Commands to paste and single words stay whole
        return max(len(line) for line in lines if not line.startswith("  gradus ") and len(line.split()) > 1)
    for words in (["list"], ["run", "bresenham_line"], ["run", "liang_barsky"], ["run", "viewport"], ["help", "perspective"],
                  ["help", "figure"]):
        plain = gradus(*words).out
        check(longest(plain) > 80, f"{words}: as long as they are in a pipe")
        check(longest(on_terminal(*words)[0]) <= 80, f"{words}: fits a terminal of 80 columns")
        for width in (60, 100):
            fitted = gradus(*words, "--width", str(width)).out
            check(longest(fitted) <= width, f"{words}: --width {width}: {longest(fitted)}")
            equal(fitted.split(), plain.split(), f"{words}: no word is lost")
            equal(gradus(*words, env={"COLUMNS": str(width)}).out, fitted, f"{words}: COLUMNS={width}")
            equal(gradus(*words, "--width", str(width), env={"COLUMNS": "40"}).out, fitted, "the flag beats the environment")
    equal(gradus("run", "bresenham_line", "--json", "--width", "40").out, gradus("run", "bresenham_line", "--json").out,
          "JSON is for programs")
    equal(gradus("list", "--width", "3").err, "gradus: --width: expected a whole number from 20 to 10000, found '3'\n", "--width 3")


def test_color():
    run = ["run", "bresenham_line"]
    check("\x1b[" in on_terminal(*run)[0], "a terminal has colours")
    check("\x1b[" not in on_terminal(*run, "--color", "never")[0], "--color never")
    check("\x1b[" not in on_terminal(*run, env={"NO_COLOR": "1"})[0], "NO_COLOR")
    check("\x1b[" in on_terminal(*run, env={"NO_COLOR": ""})[0], "an empty NO_COLOR is none")
    check("\x1b[" not in on_terminal(*run, env={"TERM": "dumb"})[0], "TERM=dumb")
    check("\x1b[" in on_terminal(*run, "--color", "always", env={"NO_COLOR": "1"})[0], "the flag beats the environment")
    check("\x1b[" not in gradus(*run).out, "a pipe has none")
    check("\x1b[" in gradus(*run, env={"CLICOLOR_FORCE": "1"}).out, "CLICOLOR_FORCE")
    check("\x1b[" in gradus(*run, "--color=always").out, "--color always")
    check("\x1b[" not in gradus(*run, "--json", "--color=always").out, "never in JSON")
    check("\x1b[" not in gradus("figure", "bresenham_line", "-o", "-", "--format", "txt", env={"CLICOLOR_FORCE": "1"}).out,
          "never in a file")
    fill = gradus("run", "flood_fill", "--color", "always", "--paint", "b").out
    check("\x1b[" in fill and "bbb" in fill, "--color is the terminal's, --paint the topic's")


def test_progress():
    words = ["figure", "bresenham_line", "-o", "p{step}.svg"]
    text, code = on_terminal(*words)
    check(code == 0 and "8/8" in text and "[########################]" in text and text.endswith("\x1b[K"), f"a bar: {text!r}")
    text, _ = on_terminal(*words, env={"TERM": "dumb"})
    check("\x1b" not in text and text.splitlines()[0] == "p0.svg", f"no bar on a dumb terminal: {text!r}")
    equal(on_terminal("-q", *words)[0], "", "-q")
    text, code = on_terminal("figure", "bresenham_line", "-o", "-", "--format", "png")
    check(code == 2 and "expected a file or a pipe for png, found a terminal" in text, "no picture into a terminal")


def test_interrupt():
    process = subprocess.Popen([GRADUS, "figure", "bresenham_line", "--to", "3000,7", "--steps", "0-3000", "-o", "i{step}.png"],
                               stderr=subprocess.PIPE, env=PLAIN)
    wait_for(lambda: len(files()) > 1)
    process.send_signal(signal.SIGINT)
    _, err = process.communicate()
    equal((process.returncode, err), (130, b""), "Ctrl-C")
    equal(files(), [], "no incomplete files are left")
    process = subprocess.Popen([GRADUS, "run", "flood_fill", "--maze", "-"], stdin=subprocess.PIPE, env=PLAIN)
    time.sleep(0.2)
    process.send_signal(signal.SIGINT)
    equal(process.wait(), 130, "Ctrl-C while it waits for input")


# --- Long runs -------------------------------------------------------------------------------------------------------


def test_long_runs():
    line = ["bresenham_line", "--to", "16777216,1"]
    result = gradus("run", *line)
    check(re.fullmatch(r"recorded \d+ of 16777217 steps; --steps A-B takes a range\n", result.err), result.err)
    equal(gradus("run", *line, "-q").err, "", "-q")
    line = ["bresenham_line", "--to", "2097152,1"]
    data = json.loads(gradus("run", *line, "--json", "--steps", "1500000-1500002").out)
    equal(sorted({step["number"] for step in data["steps"]}), [1500000, 1500001, 1500002], "a range far away")
    check("step 2097152 of 2097152" in gradus("figure", *line, "--step", "last", "-o", "-").out, "the last step of a long run")
    check("step 25000 of 2097152" in gradus("figure", *line, "-o", "-").out, "one that decides in the middle of what is recorded")
    gradus("figure", *line, "--step", "1900000", "-o", "far.svg")
    gradus("figure", *line, "--steps", "1899999-1900001", "-o", "far-{step}.svg")
    equal(read("far-1900000.svg"), read("far.svg"), "a far step alone and in a series")
    gradus("again", "far.svg")
    equal(read("far-again.svg"), read("far.svg"), "a far step again")
    write("big.png", png(500, 500, lambda x, y: 128))
    fill = ["flood_fill", "--image", "big.png", "--method", "depth_first"]
    result = gradus("run", *fill, "--steps", "200000-200001")
    check(result.code == 0 and "200001" in result.out, f"a fill's far steps: {result.err}")
    gradus("figure", *fill, "--step", "200000", "-o", "fill.png")
    gradus("again", "fill.png")
    equal(read("fill-again.png"), read("fill.png"), "a fill's far step again")


# --- Figures ---------------------------------------------------------------------------------------------------------


def test_figures():
    # The gallery that this build has drawn, with as many jobs as there are cores
    shutil.copytree(project.gallery(), "out")
    made = {name: read(os.path.join("out", name)) for name in files("out")}
    slugs = sorted({name.split("/")[0] for name in made if "/" in name} - {"topics"})
    check(len(slugs) >= 2 and "bresenham_line" in slugs, f"figures: {slugs}")
    rendered = [slug for slug in slugs if any(name.startswith(f"{slug}/") and name.endswith(".obj") for name in made)]
    equal(len(rendered), 3, f"renders: {rendered}")
    drawn = [slug for slug in slugs if slug not in rendered]
    for slug in drawn:
        for ending in (".pdf", ".svg", ".png", "-drawing.svg", ".html", ".csv", ".json", "-steps.zip"):
            check(f"{slug}/{slug}{ending}" in made, f"{slug}{ending} is there")
    for slug in rendered:
        check(f"{slug}/{slug}.png" in made and f'src="./{slug}/{slug}.png"' in made["index.html"].decode(), f"{slug}.png is there and shown")
    check("topics/scan_conversion/bresenham_line.html" in made, "the pages of the topics")
    check("errata.html" in made and 'href="./errata.html"' in made["index.html"].decode(), "the page of errata")
    page = made["index.html"].decode()
    for link in re.findall(r'(?:href|src)="([^"#:]+)"', page):
        check(os.path.exists(os.path.join("out", link)), f"the link {link} leads somewhere")
    check(all(f"{slug}/{slug}.pdf" in page for slug in drawn) and "//" not in re.sub(r"https?://www\.w3\.org|https?://creativecommons\.org", "", "".join(
        re.findall(r'(?:href|src)="([^"]*)"', page))), "relative links only")
    start = time.perf_counter()
    again = gradus("figures", "-o", "out")
    spent = time.perf_counter() - start
    print(f"gradus figures with nothing changed: {1000 * spent:.0f} ms")
    check(spent < 1, "a second run under a second")
    equal((again.out, again.err), ("out/index.html\n", f"0 drawn, {len(slugs)} unchanged, 0 removed\n"), "unchanged")

    without = {name: data for name, data in made.items() if not name.startswith(".")}
    few = ["figures", "--only", "bresenham*", "-o"]
    one, two = gradus(*few, "one/", "--jobs", "1"), gradus(*few, "two", "--jobs", "2")
    equal((one.code, one.out), (0, "one/index.html\n"), "figures")
    check(re.fullmatch(r"\d\d drawn, 0 unchanged, 0 removed", one.err.splitlines()[-1]), "what was done: " + one.err)
    equal(two.err, one.err, "the order of the output does not depend on the number of jobs")
    alone = {name: read(os.path.join("one", name)) for name in files("one") if name.startswith("bresenham")}
    equal(alone, {name: data for name, data in without.items() if name.startswith("bresenham")},
          "the same bytes with several jobs, and in a folder of their own")

    # One changed, one lost
    write("out/bresenham_line/bresenham_line.svg", "edited")
    os.remove(f"out/{drawn[-1]}/{drawn[-1]}.pdf")
    os.remove(f"out/{rendered[-1]}/{rendered[-1]}.png")
    changed = sorted({"bresenham_line", drawn[-1], rendered[-1]})
    result = gradus("figures", "-o", "out")
    equal(sorted(result.err.splitlines()[:-1]), changed, "what was changed is drawn again")
    equal({name: read(os.path.join("out", name)) for name in files("out") if not name.startswith(".")}, without, "as before")

    # A job that no longer exists
    manifest = json.loads(read("out/.gradus-manifest.json"))
    text = read("out/.gradus-manifest.json").decode()
    check("bresenham_line" in json.dumps(manifest), "the manifest")
    os.mkdir("out/gone_slug")
    for name in files("out/bresenham_line"):
        shutil.copy2(f"out/bresenham_line/{name}", f"out/gone_slug/{name.replace('bresenham_line', 'gone_slug')}")
    write("out/gone_slug/mine.txt", "kept")
    write("out/.gradus-manifest.json", re.sub("bresenham_line(?!_)", "gone_slug", text))
    result = gradus("figures", "-o", "out")
    check(result.err.endswith("1 removed\n"), result.err)
    equal(files("out/gone_slug"), ["mine.txt"], "only files named in the manifest are removed")
    os.remove("out/topics/scan_conversion/flood_fill.html")
    gradus("figures", "-o", "out")
    equal(read("out/topics/scan_conversion/flood_fill.html"), made["topics/scan_conversion/flood_fill.html"],
          "a lost topic page is made again")


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


def test_figures_all_anew():
    circles = ["figures", "-o", "out", "--only", "bresenham_circle*"]
    drawn = gradus(*circles).err.splitlines()[-1]
    check(re.fullmatch("[2-9] drawn, 0 unchanged, 0 removed", drawn), drawn)
    equal(gradus(*circles).err.splitlines()[-1], f"0 drawn, {drawn[0]} unchanged, 0 removed", "unchanged")
    equal(gradus(*circles, "--force").err.splitlines()[-1], drawn, "--force")
    write("out/.gradus-manifest.json", "{ broken")
    equal(gradus(*circles).err.splitlines()[-1], drawn, "a broken manifest: all anew")


def test_figures_only():
    result = gradus("figures", "-o", "out", "--only", "Bresenham-*")
    check(all(name.startswith("bresenham") for name in result.err.splitlines()[:-1]), result.err)
    page = read("out/index.html").decode()
    check("bresenham_line" in page and "flood_fill" not in page, "the page shows what is there")
    equal([name for name in files("out") if name.startswith("topics/")],
          [f"topics/scan_conversion/bresenham_{name}.html" for name in ("circle", "line")], "and the topics' pages are")
    gradus("figures", "-o", "out", "--only", "flood_fill_span")
    page = read("out/index.html").decode()
    check("bresenham_line" in page and "flood_fill_span" in page, "figures made earlier stay on the page")
    result = gradus("figures", "-o", "none", "--only", "x*")
    equal((result.code, result.out, result.err, os.path.exists("none")),
          (1, "", "gradus: --only: expected a pattern that matches a figure or a topic, found 'x*'\n", False), "no match")
    svg = "out/bresenham_line/bresenham_line.svg"
    if os.path.exists(svg):
        gradus("again", svg, "-o", "a.svg")
        equal(read("a.svg"), read(svg), "a figure of the gallery made again")


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
    own = json.loads(gradus("run", "pipeline", "--json").out)
    given = json.loads(gradus("run", "pipeline", "letter_f.obj", "--json").out)
    equal(given["result"], own["result"], "the letter F is what is shown when no model is given")
    equal(gradus("figure", "pipeline", "-o", "tour.html").code, 0, "the tour")
    write("bad.obj", "v 0 0 zero\n")
    for arguments, complaint in (
            (("letter_f.obj", "--model", "letter_f.obj"), "--model: expected one model, found 'letter_f.obj' and 'letter_f.obj'"),
            (("letter_f.obj", "more"), "figure: expected only a TOPIC, found 'more'"),
            (("none.obj",), "--model: expected a readable file, found 'none.obj' (No such file or directory)"),
            (("bad.obj",), "bad.obj:1: expected a number for the vertex, found 'zero'"),
            (("--eye", "1,2"), "--eye: expected 3 numbers x,y,z, found '1,2'"),
            (("--fov", "0"), "--fov: expected a number from 1 to 170, found '0'"),
            (("--face", "12"), "--face: expected a face from 0 to 11, found 12"),
            (("--pixel", "40,0"), "--pixel: expected a pixel inside the 40 × 28 picture, found 40,0")):
        result = gradus("figure", "pipeline", *arguments, "-o", "d.svg")
        equal((result.code, result.err, os.path.exists("d.svg")), (2, f"gradus: {complaint}\n", False), str(arguments))
    result = gradus("figure", "bresenham_line", "letter_f.obj", "-o", "d.svg")
    equal((result.code, result.err), (2, "gradus: figure: expected only a TOPIC, found 'letter_f.obj'\n"), "no model's topic")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
