#!/usr/bin/env python3
"""Completion in bash, zsh and fish, as installed: topics, methods, flags and values. And the pages of the manual.

    tests/golden/completion_test.py [GRADUS]

The shells are asked themselves: bash and zsh are typed to at a terminal, fish says what it would offer.
"""
import json
import os
import pathlib
import pty
import re
import select
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, PLAIN, check, equal, gradus

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "visualize/cli/completion"
ENV = {**PLAIN, "PATH": f"{os.path.dirname(GRADUS)}:{os.environ['PATH']}", "TERM": "dumb", "LC_ALL": "C.UTF-8"}


def following(*words):
    """What may come next, the last word being typed: {word: help}, and the lines about files."""
    result = gradus("completion", "--next", "--", *words)
    equal((result.code, result.err), (0, ""), f"{words}")
    lines = result.out.splitlines()
    return dict(line.split("\t", 1) for line in lines if line[0] != "\t"), [line[1:] for line in lines if line[0] == "\t"]


def words_after(*words):
    return set(following(*words)[0])


# --- What the program answers ------------------------------------------------------------------------------------------


def test_everything_of_the_catalogue_is_offered():
    topics = json.loads(gradus("list", "--json").out)["topics"]
    check(len(topics) >= 16, f"{len(topics)} topics")
    for name in ("run", "figure"):
        equal(words_after(name, ""), {topic["name"] for topic in topics}, f"topics of {name}")
    for topic in topics:
        name = topic["name"]
        equal(words_after("run", name, "--method", ""), {method["name"] for method in topic["methods"]}, f"methods of {name}")
        flags = words_after("figure", name, "--")
        wanted = {"--" + parameter["name"].replace("_", "-") for parameter in topic["parameters"]}
        check(wanted | {"--method", "--theme", "--output", "--quiet"} <= flags, f"{name}: {wanted - flags} are missing")
        for parameter in topic["parameters"]:
            flag = "--" + parameter["name"].replace("_", "-")
            offered, files = following("run", name, flag, "")
            if parameter["type"] == "choice":
                equal(set(offered), set(parameter["choices"]), f"{name} {flag}")
            elif parameter["type"] == "flag":
                pass
            else:
                check(offered or files, f"{name} {flag}: something is offered")
    commands = words_after("")
    for name in commands:
        check({"--help", "--quiet"} <= words_after(name, "--"), f"flags of {name}")
    check({"list", "help", "run", "figure", "source", "cases", "check", "figures", "worksheet", "render", "demo", "inspect", "bench", "stress", "again", "open", "completion", "man"} <= commands,
          f"{commands}")


def test_what_is_offered_is_taken():
    """Each value of each flag that has names for values draws a figure."""
    count = 0
    for flag in ("--theme", "--language", "--layout", "--y", "--svg-text", "--background", "--slots", "--steps", "--panels",
                 "--compare", "--size", "--method"):
        values = words_after("figure", "bresenham_line", flag, "")
        check(len(values) >= 1, f"{flag}: {values}")
        for value in values:
            if flag == "--background" and value in ("gray", "red", "teal", "purple", "green", "blue", "fuchsia", "olive"):
                continue  # no ground on which letters can be read
            kind = "pdf" if flag == "--steps" else "svg"
            done = gradus("figure", "bresenham_line", flag, value, "-o", "-", "--format", kind)
            readable = "expected a ground on which" in done.err
            check(done.code == 0 or readable, f"{flag} {value}: {done.err}")
            count += 1
    for value in words_after("figure", "bresenham_line", "--format", ""):
        topic = "ear_clipping" if value in ("obj", "ply", "stl") else "bresenham_line"  # whose run makes a surface
        equal(gradus("figure", topic, "-o", "f", "--format", value).code, 0, f"--format {value}")
        count += 1
    for value in words_after("figure", "bresenham_line", "-o", "f.pdf", "--snippet", ""):
        ending = "pdf" if value == "beamer" else "svg"
        equal(gradus("figure", "bresenham_line", "-o", f"f.{ending}", "--snippet", value).code, 0, f"--snippet {value}")
        count += 1
    for value in words_after("run", "bresenham_line", "--from", ""):
        equal(gradus("run", "bresenham_line", "--from", value).code, 0, f"--from {value}")
        count += 1
    check(count > 40, f"{count} values tried")


def test_words_as_they_are_typed():
    equal(words_after("figure", "bresenham-c"), {"bresenham-circle"}, "with the hyphen that was typed")
    equal(words_after("fig", "line", "--th"), {"--theme"}, "behind shortened names")
    equal(words_after("run", "midpoint c"), {"midpoint circle"}, "aliases where no name begins so")
    equal(words_after("figure", "bresenham_line", "--theme=d"), {"--theme=dark"}, "a value glued to its flag")
    equal(words_after("figure", "bresenham_line", "--slots", "title,dra"), {"title,drawing"}, "a list goes on")
    equal(words_after("run", "--from", "0,0", "bresenham_line", "--t"), {"--to"}, "a topic's flag before the topic")
    check("--theme" not in words_after("figure", "bresenham_line", "--theme", "dark", "--"), "once is enough")
    check("--label" in words_after("figure", "bresenham_line", "--label", "p=d", "--"), "some may come again")
    equal(words_after("zzz", ""), set(), "nothing behind what can't be read")
    equal(words_after("run", "zzz", "--"), set(), "nor behind no topic")
    equal(following("render", "")[0].keys() >= {"letter_f.obj", "spot.obj", "town.json"}, True, "models and scenes that come with it")
    endings = following("render", "")[1][0].removeprefix("files\t").split()
    equal(endings[:2], [".obj", ".json"], "and those that lie here")
    check({".off", ".ply", ".stl"} <= set(endings), f"all that gradus reads: {endings}")
    check(len(endings) == 5 or {".gltf", ".glb", ".fbx"} <= set(endings), f"with Assimp all that it reads: {endings}")
    equal(words_after("render", "town_flight.json", "--frames", ""), {"0-124"}, "frames")
    equal(words_after("render", "town_flight.json", "--array", ""), {"1/4"}, "a part of them")
    check("unchanged" in words_after("render", "town_flight.json", "--without", ""), "rules")
    equal(words_after("demo", ""), {"forward", "target", "both"}, "demonstrations")
    check("folders" in following("demo", "forward", "--frames", "")[1], "a folder for frames")
    equal(following("inspect", "")[0].keys(), {"pyramid_demo.json"}, "the program's own data")
    equal(following("inspect", "")[1], ["files\t.json"], "and those that lie here")
    equal(following("again", "")[1], ["files\t.svg .png .pdf .pptx .html .gif .mp4 .webp"], "figures")
    equal(following("figures", "")[1], ["files\t.json"], "lectures")
    equal(following("open", "")[1], ["folders"], "folders")
    check({"liang_barsky", "z_buffer"} <= words_after("worksheet", "bresenham_line", ""), "a second topic of a worksheet")
    equal(words_after("worksheet", "bresenham_line", "--format", ""), {"pdf", "tex", "xml"}, "formats of worksheets")
    equal(words_after("worksheet", "bresenham_line", "--paper", ""), {"a4", "letter"}, "paper")
    equal(following("worksheet", "bresenham_line", "--lecture", "")[1], ["files\t.json"], "a lecture's words")
    check({"--points", "--input-points"} <= words_after("worksheet", "viewport", "--"), "an input called like a flag of the command")
    equal(words_after("completion", ""), {"bash", "zsh", "fish"}, "shells")
    for odd in ([], ["\x1b[31m"], ["--"], ["-"], ["run", "--", "-"], ["run", "-o"], ["figure", "line", "--=", ""], ["run", "line", "=", "="]):
        equal(gradus("completion", "--next", "--", *odd).code, 0, f"{odd}")
    for shell in ("bash", "zsh", "fish"):
        equal(gradus("completion", shell).out, (SCRIPTS / f"gradus.{shell}").read_text(), f"the script for {shell}")
    result = gradus("completion", "tcsh")
    equal((result.code, result.err), (2, "gradus: SHELL: expected one of bash, zsh, fish, found 'tcsh'\n"), "another shell")


# --- The shells --------------------------------------------------------------------------------------------------------


class Terminal:
    """An interactive shell."""

    def __init__(self, words, env):
        self.pid, self.fd = pty.fork()
        if self.pid == 0:
            os.execvpe(words[0], words, env)

    def read(self, until, seconds=30):
        """What comes until the text appears."""
        text, end = "", time.monotonic() + seconds
        while until not in text and time.monotonic() < end:
            if select.select([self.fd], [], [], 0.2)[0]:
                try:
                    text += os.read(self.fd, 1 << 16).decode("utf-8", "replace").replace("\a", "")  # beeps
                except OSError:
                    break
        return text

    def type(self, text):
        os.write(self.fd, text.encode())

    def close(self):
        os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)
        os.close(self.fd)


# What is typed before the tab key, and how the line goes on
TYPED = {
    "gradus figure bresenham_li": "gradus figure bresenham_line ",
    "gradus run flood_fill --meth": "gradus run flood_fill --method ",
    "gradus run flood_fill --method breadth": "gradus run flood_fill --method breadth_first ",
    "gradus figure bresenham_line --theme hi": "gradus figure bresenham_line --theme high_contrast ",
    "gradus figure bresenham_line --theme=hi": "gradus figure bresenham_line --theme=high_contrast ",
    "gradus figure bresenham_line --size 4": "gradus figure bresenham_line --size 4:3 ",
    "gradus render lett": "gradus render letter_f.obj ",
    "gradus figures my": "gradus figures my_lecture.json ",
    "gradus open gal": "gradus open gallery/",
    "gradus comp": "gradus completion ",
}


def fixtures():
    for name in ("my_lecture.json", "mine.txt", "gallery.txt"):
        pathlib.Path(name).write_text("{}")
    os.mkdir("gallery")


def type_lines(words, setup):
    fixtures()
    terminal = Terminal(words, {**ENV, "HOME": os.getcwd(), "HISTFILE": "/dev/null"})
    try:
        terminal.type(f"{setup}; PS1='ready> '; echo se''t\n")
        check("set" in terminal.read("set\r"), "the shell is there")
        terminal.read("ready> ", 5)
        for typed, expected in TYPED.items():
            terminal.type(typed + "\t")
            found = terminal.read(expected, 20)
            check(expected in found, f"{words[0]}: {typed}<TAB>\n    expected: {expected!r}\n    found:    {found[-200:]!r}")
            terminal.type("\x15")
            terminal.read("\x00", 0.3)
        terminal.type("gradus run bresenham_\t\t")
        found = terminal.read("bresenham_line", 20)
        check("bresenham_circle" in found and "bresenham_line" in found, f"{words[0]}: both are shown: {found!r}")
    finally:
        terminal.close()


def test_bash_at_a_terminal():
    type_lines(["bash", "--norc", "--noprofile", "-i"], "source <(gradus completion bash)")


def test_bash_function():
    """Bash's own way to ask: the function gets the words as bash takes them apart."""
    script = r"""source <(gradus completion bash)
        while IFS= read -r line; do
          IFS=$'\t' read -r -a COMP_WORDS <<<"${line#*|}"
          [[ $line != *$'\t' ]] || COMP_WORDS+=("")
          COMP_LINE=${line%%|*} COMP_POINT=${#COMP_LINE} COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) COMPREPLY=()
          COMP_POINT=${#COMP_LINE}
          _gradus gradus
          printf '%s\t' "${COMPREPLY[@]}"; echo
        done"""
    cases = {
        ("gradus run bresenham_", "gradus run bresenham_"): ["bresenham_circle", "bresenham_line"],
        ("gradus figure bresenham_line --theme=", "gradus figure bresenham_line --theme ="): ["light", "dark", "greyscale", "high_contrast", "print"],
        ("gradus figure bresenham_line --theme=d", "gradus figure bresenham_line --theme = d"): ["dark"],
        ("gradus figure bresenham_line --size 4:", "gradus figure bresenham_line --size 4 :"): ["3"],
        ("gradus figure affine_2d --factors ", "gradus figure affine_2d --factors "):
            [r"rotate\ 30\ about\ 1\,1\;\ scale\ 2\ about\ 1\,1"],
    }
    text = "".join(f"{line}|" + words.replace(" ", "\t") + "\n" for line, words in cases)
    done = subprocess.run(["bash", "--norc", "-c", script], input=text, env=ENV, capture_output=True, text=True)
    answers = [line.split("\t")[:-1] for line in done.stdout.splitlines()]
    equal(answers, list(cases.values()), f"bash: {done.stderr}")


def test_zsh():
    type_lines(["zsh", "-f", "-i"], "autoload -Uz compinit; compinit -u -D; source <(gradus completion zsh)")


def test_fish():
    fixtures()
    for typed, expected in TYPED.items():
        done = subprocess.run(["fish", "-c", "gradus completion fish | source; complete -C $argv[1]", typed],
                              env={**ENV, "HOME": os.getcwd()}, capture_output=True, text=True)
        offered = [line.split("\t")[0] for line in done.stdout.splitlines()]
        check(expected.rstrip().split(" ")[-1] in offered, f"fish: {typed}: {offered} {done.stderr}")
    done = subprocess.run(["fish", "-c", "gradus completion fish | source; complete -C 'gradus run bresenham_'"],
                          env={**ENV, "HOME": os.getcwd()}, capture_output=True, text=True)
    equal(done.stdout, "bresenham_circle\tBresenham circle\nbresenham_line\tBresenham line\n", "fish: with titles")


# --- The manual --------------------------------------------------------------------------------------------------------


def test_manual():
    equal(gradus("man", "-o", "man").code, 0, "all pages")
    pages = sorted(pathlib.Path("man").rglob("*.*"))
    topics = json.loads(gradus("list", "--json").out)["topics"]
    names = {page.name for page in pages}
    wanted = {"gradus.1"} | {f"gradus-{name}.1" for name in words_after("")} | {f"gradus-{topic['name']}.7" for topic in topics}
    equal(names, wanted, "a page for each command and topic")
    for page in pages:
        done = subprocess.run(["groff", "-man", "-Kutf8", "-Tutf8", "-ww", str(page)], capture_output=True, env={**ENV, "MANWIDTH": "80"})
        equal((done.returncode, done.stderr.decode()), (0, ""), f"{page.name}: no warning")
        text = re.sub(r"\x1b\[[\d;]*m|.\x08", "", done.stdout.decode())
        check(all(title in text for title in ("NAME", "SYNOPSIS", "EXAMPLES", "SEE ALSO")), f"{page.name}: {text[:300]}")
        check(not re.search(r"\\f[BIR]|\\\(|\.TP", text), f"{page.name}: roff is left in the text")
    shown = subprocess.run(["groff", "-man", "-Kutf8", "-Tascii", "-P-c", "man/man7/gradus-flood_fill.7"], capture_output=True, text=True).stdout
    shown = re.sub(r".\x08", "", shown)
    for word in ("--maze", "--method breadth_first", "gradus run flood_fill"):
        check(word in shown, f"{word} stands in the page, to be copied: {shown[:500]}")
    equal(gradus("man", "flood-fill").bytes, pathlib.Path("man/man7/gradus-flood_fill.7").read_bytes(), "one page")
    equal(gradus("man").bytes, pathlib.Path("man/man1/gradus.1").read_bytes(), "the first page")
    equal(gradus("man", "zzz").code, 2, "no such page")


def test_what_is_installed():
    build = os.environ.get("GRADUS_BINARY_DIR", os.path.dirname(GRADUS))
    done = subprocess.run(["cmake", "--install", build, "--component", "command", "--prefix", os.path.abspath("prefix")],
                          capture_output=True, text=True)
    equal(done.returncode, 0, f"installing: {done.stderr}")
    share = pathlib.Path("prefix/share")
    equal((share / "bash-completion/completions/gradus").read_text(), gradus("completion", "bash").out, "bash finds it there")
    equal((share / "zsh/site-functions/_gradus").read_text(), gradus("completion", "zsh").out, "zsh")
    equal((share / "fish/vendor_completions.d/gradus.fish").read_text(), gradus("completion", "fish").out, "fish")
    equal((share / "man/man1/gradus.1").read_bytes(), gradus("man").bytes, "man")
    check(len(list((share / "man/man7").iterdir())) >= 16, "the topics' pages")


# --- The browser -------------------------------------------------------------------------------------------------------


def test_open():
    gradus("figures", "-o", "out", "--only", "bresenham_line", "-q")
    os.mkdir("bin")
    for name in ("xdg-open", "mine"):
        pathlib.Path("bin", name).write_text('#!/bin/sh\nprintf "%s\\n" "${0##*/}" "$@" > asked\n')
        os.chmod(f"bin/{name}", 0o755)
    here = os.getcwd()
    def opened(*words, browser=None, path=f"{here}/bin"):
        if os.path.exists("asked"):
            os.remove("asked")
        env = {**PLAIN, "PATH": path + ":/usr/bin:/bin"} if path else {**PLAIN, "PATH": "/nowhere"}
        env.pop("BROWSER", None)
        if browser is not None:
            env["BROWSER"] = browser
        done = subprocess.run([GRADUS, "open", *words], env=env, capture_output=True, text=True, timeout=60)
        asked = pathlib.Path("asked").read_text().splitlines() if os.path.exists("asked") else None
        return done.returncode, done.stdout, done.stderr, asked
    page = f"file://{here}/out/index.html"
    equal(opened(), (0, "", "", ["xdg-open", page]), "without BROWSER")
    equal(opened(browser="mine"), (0, "", "", ["mine", page]), "BROWSER goes first")
    equal(opened(browser="gone:mine --new %s --quiet:xdg-open"), (0, "", "", ["mine", "--new", page, "--quiet"]), "a list of commands")
    os.rename("out", "a b&c")
    equal(opened("a b&c")[3], ["xdg-open", f"file://{here}/a%20b%26c/index.html"], "a folder's name")
    equal(opened("a b&c/index.html")[3], ["xdg-open", f"file://{here}/a%20b%26c/index.html"], "a page")
    equal(opened("a b&c", path="")[:3], (1, "", "gradus: open: expected a browser in BROWSER, or xdg-open, found none; "
                                          f"the page is file://{here}/a%20b%26c/index.html\n"), "no browser: one line")
    equal(opened()[:3], (2, "", "gradus: open: expected a folder that exists (`gradus figures -o out` makes it), found 'out'\n"), "no gallery")
    equal(opened("bin")[:3], (2, "", "gradus: open: expected a folder with figures (`gradus figures -o bin` draws them), found 'bin'\n"),
          "a folder without one")


sys.exit(command.run_all(globals()))
