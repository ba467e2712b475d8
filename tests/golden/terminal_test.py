"""The `gradus` command at a terminal: widths, colours, progress, and Ctrl-C.

Usage: terminal_test.py [path of gradus]        (default: $GRADUS_COMMAND)
"""
import pathlib
import re
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, PLAIN, check, equal, files, gradus, on_terminal, wait_for


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


def test_long_renders_have_a_bar():
    def shares(text):
        # As long as no share is known, a block of six moves to and fro
        bars = [len(bar) for bar, _ in re.findall(r"\[(#*)(\.*)\] render, \d+ s", text)]
        return [bar for bar in bars if bar != 6]
    # Longer than any machine draws at once; watched only until the bar has grown
    words = ("render", "letter_f.obj", "-o", "long.png", "--size", "3000x2000", "--aa", "supersampling", "--samples", "256")
    text, code = on_terminal(*words, enough=lambda text: len(set(shares(text))) > 1)
    seen = shares(text)
    check(code == 130 and len(set(seen)) > 1 and seen == sorted(seen), f"a bar that grows: {code}, {seen}")
    equal(files(), [], "an interrupted render leaves no file")
    equal(on_terminal("-q", "render", "letter_f.obj", "-o", "short.png", "--size", "16x16")[0], "", "none where all is done at once")


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


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
