#!/usr/bin/env python3
"""Shared libraries that most commands do without: who loads them, and what is said where they can't be loaded.

    tests/golden/on_demand_test.py [GRADUS]
"""
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal, files, gradus, write

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
# Each with a command that needs it, and what can't be done without
USES = {"libcairo.": (["figure", "bresenham_line", "-o", "out.png"], "pictures"),
        "libpangocairo": (["worksheet", "bresenham_line", "-o", "out.pdf", "--students", "names.txt"], "names in PDF worksheets"),
        "libarchive": (["figure", "bresenham_line", "-o", "out.pptx"], "zips"),
        "libhwy": (["render", "m.obj", "--size", "16x12", "-o", "out.png"], "pictures")}


def loaded(*words):
    """The libraries that a run has loaded, by the name under which each was looked for."""
    result = gradus(*words, env={"LD_DEBUG": "libs"})
    equal(result.code, 0, f"{words}: {result.err[-300:]}")
    return set(re.findall(r"find library=(\S+)", result.err))


def one(names, start):
    return [name for name in sorted(names) if name.startswith(start)]


def test_short_commands_load_none():
    for words, drawn in ((["list"], False), (["--version"], False), (["run", "bresenham_line"], False),
                         (["figure", "bresenham_line", "-o", "a.svg"], True), (["figure", "bresenham_line", "-o", "a.png"], True),
                         (["worksheet", "bresenham_line", "-o", "a.pdf"], True)):
        names = loaded(*words)
        check(one(names, "libpng"), f"{words}: what is loaded at all shows: {names}")
        for library in (*USES, "libassimp", "libX11", "libfontconfig"):
            if drawn and library in ("libcairo.", "libX11", "libfontconfig"):
                continue
            equal(one(names, library), [], f"{words} and {library}")


def test_each_is_loaded_by_what_needs_it_or_missed_in_one_line():
    write("names.txt", "محمد\n")
    write("m.obj", TRIANGLE)
    for library, (words, purpose) in USES.items():
        found = one(loaded(*words), library)
        if not check(len(found) == 1, f"{words} loads {library}: {found}"):
            continue
        for name in files():
            if name.startswith("out"):
                os.remove(name)
        os.mkdir(found[0])
        write(f"{found[0]}/{found[0]}", "")
        before = files()
        result = gradus(*words, env={"LD_LIBRARY_PATH": f"{os.getcwd()}/{found[0]}"})
        check(result.code == 1 and result.err.startswith(f"gradus: {purpose} need") and found[0] in result.err
              and "file too short" in result.err and result.err.count("\n") == 1, f"{words}: {result.code} {result.err}")
        equal(files(), before, f"{words}: nothing is written")


sys.exit(command.run_all(globals()))
