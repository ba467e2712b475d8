"""What the `gradus` command refuses: its complaint, its exit code, and that nothing is left behind.

Usage: refusals_test.py [path of gradus]        (default: $GRADUS_COMMAND)
"""
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, INT32, check, equal, files, gradus, png, read, write


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
    size = "--size: expected a width and a height like 1280x720 or 12cmx8cm (160 to 8192 pixels, 96 per inch), or a ratio like 4:3, found "
    steps = "--steps: expected steps like 3-9 or 1,4,9-12, found "
    outline = "0,0 10,0 10,10 0,10; "
    table = [
        (["run", "ear_clipping", "--method", "join_holes", "--rings", outline + "2,2 5,2 3,4; 5,2 8,2 7,4; 3,4 7,4 5,7"],
         "--rings: expected an inside in one piece, found rings that touch in a circle at 7,4"),
        (["run", "ear_clipping", "--method", "join_holes", "--rings", outline + "0,5 3,4 3,6; 3,6 5,7 2,10"],
         "--rings: expected an inside in one piece, found rings that touch in a circle at 2,10"),
        # command, topic, flags
        (["lits"], "COMMAND: expected one of list, help, run, figure, source, cases, check, figures, worksheet, render, explain, demo, inspect, bench, stress, again, open, completion, man, found 'lits', did you mean 'list'?"),
        (["zzz"], "COMMAND: expected one of list, help, run, figure, source, cases, check, figures, worksheet, render, explain, demo, inspect, bench, stress, again, open, completion, man, found 'zzz'"),
        (["run"], "run: expected a TOPIC, found none (`gradus run --help` shows examples)"),
        (["run", "bresenhm_line"], topics + "'bresenhm_line', did you mean 'bresenham_line'?"),
        (["run", "radiosity"], topics + "'radiosity'"),
        (["run", "\x1b[31m\n"], topics + r"'\x1b[31m\n'"),
        (["help", "bresenhm_lin"], topics + "'bresenhm_lin', did you mean 'bresenham_line'?"),
        (["run", "flood_fill", "--paint", "red"], "--paint: expected a letter for a maze, found a colour"),
        (["run", "flood_fill", "--color", "red"], "--color: expected one of auto, always, never, found 'red'"),
        (["run", "bresenham_line", "--window", "5,0,3,1"], "--window: expected xmin <= xmax, not 5 > 3, found '5,0,3,1'"),
        (["run", "bresenham_line", "--window", "0,0,3,1", "--method", "dda"],
         "--window: method dda takes none: it walks to every pixel"),
        (["run", "bresenham_line", "x"], "run: expected only a TOPIC, found 'x'"),
        (["list", "a", "b"], "list: expected at most one WORD, found 'b'"),
        (["figures", "x"], "LECTURE: expected a readable file, found 'x' (No such file or directory)"),
        (["figures", "x", "y"], "figures: expected at most one LECTURE, found 'y'"),
        (["again"], "again: expected a FILE, found none (`gradus again --help` shows examples)"),
        ([*line, *out, "--form=x"], "--format: expected one of svg, png, pdf, html, csv, md, tex, json, txt, gif, mp4, webp, pptx, obj, ply, stl, found 'x'"),
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
        ([*line, *out, "--panels", "7"], "--panels: expected phases, or 2 to 8 steps like 1,4,9, found '7'"),
        ([*line, *out, "--panels", "0-8"], "--panels: expected phases, or 2 to 8 steps like 1,4,9, found '0-8'"),
        ([*line, *out, "--panels", "1,9"], "--panels 1,9: bresenham_line has steps 0..7 for this input"),
        ([*line, *out, "--panels", "1,2", "--step", "3"], "--panels: expected either this or --step, found both"),
        ([*line, *out, "--panels", "1,2", "--compare", "dda"], "--panels: expected either this or --compare, found both"),
        ([*line, "-o", "x-{step}.svg", "--panels", "1,2"], "--panels: expected a name without {step} for one sheet, found 'x-{step}.svg'"),
        ([*line, "-o", "x.html", "--panels", "1,2"], "--panels: expected svg, png, pdf or pptx, found html"),
        ([*line, *out, "--compare", "flood_fill"],
         "--compare: expected a topic that takes --from as bresenham_line does, found 'flood_fill'"),
        ([*line, *out, "--compare", "--theme dark"], "--compare: expected inputs of bresenham_line, found '--theme'"),
        ([*line, *out, "--compare", "--to x"], "--to: expected two whole numbers from -2147483648 to 2147483647 like 3,4, found 'x'"),
        ([*line, *out, "--steps", "2-4"], "--steps: expected one step for one picture ({step} in the name of -o makes one file per step), found '2-4'"),
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
        ([*line, "-o", "x.obj"], "-o: expected a topic whose result is a surface for obj, found bresenham_line"),
        ([*line, "-o", "x.stl", "--step", "2"], "--step: expected a format that shows steps, found stl"),
        ([*line, "-o", "x.bmp"], "-o: expected a name that ends in .svg, .png, .pdf, .html, .csv, .md, .tex, .json, .txt, .gif, .mp4, .webp, .pptx, .obj, .ply, .stl (or --format), found 'x.bmp'"),
        ([*line, "-o", "x.csv/"], re.compile(r"-o: expected a name that ends in .*, found 'x.csv/'")),
        ([*line, "-o", "no/x.svg"], "-o: expected a folder that exists, found 'no'"),
        ([*line, "-o", "folder", "--format", "svg"], "-o: expected a file's name, found 'folder'"),
        ([*line, "-o", "{step}.csv"], "-o: expected {step} for svg, png or pdf only, found '{step}.csv'"),
        ([*fill, *out, "--image", "gone.png"], "--image: expected a readable file, found 'gone.png' (No such file or directory)"),
        ([*fill, *out, "--image", "folder"], "--image: expected a regular file, found the folder 'folder'"),
        ([*fill, *out, "--image", "no.png"], "--image: 'no.png': expected a PNG or JPEG file, found something else"),
        ([*fill, *out, "--image", "cut.png"], re.compile(r"--image: 'cut.png': expected a whole PNG file, found .*")),
        ([*fill, *out, "--image", "-"], "--image: standard input: expected a PNG or JPEG file, found an empty one"),
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


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
