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
TEXTURED = "mtllib t.mtl\nusemtl t\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"
# Eight grey pixels by eight: a table for quantizing, the frame, a code of one bit for each kind of coefficients, the scan
ONE_CODE = bytes([1] + [0] * 15) + b"\0"
JPEG = (b"\xff\xd8" b"\xff\xdb\0\x43\0" + bytes([1] * 64) + b"\xff\xc0\0\x0b\x08\0\x08\0\x08\x01\x01\x11\0"
        b"\xff\xc4\0\x14\0" + ONE_CODE + b"\xff\xc4\0\x14\x10" + ONE_CODE +
        b"\xff\xda\0\x08\x01\x01\0\0\x3f\0\x3f" b"\xff\xd9")
# Each with a command that needs it, and what can't be done without
USES = {"libcairo.": (["figure", "bresenham_line", "-o", "out.png"], "pictures"),
        "libpangocairo": (["worksheet", "bresenham_line", "-o", "out.pdf", "--students", "names.txt"], "names in PDF worksheets"),
        "libarchive": (["figure", "bresenham_line", "-o", "out.pptx"], "zips"),
        "libhwy": (["render", "m.obj", "--size", "16x12", "-o", "out.png"], "pictures"),
        "libjpeg": (["render", "t.obj", "--size", "16x12", "-o", "out.png"], "JPEG pictures"),
        "libcmark-gfm-extensions": (["figures", "f.json", "--quiet", "-o", "out"], "pages of topics")}


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
    write("t.obj", TEXTURED)
    write("t.mtl", "newmtl t\nmap_Kd t.jpg\n")
    write("t.jpg", JPEG)
    write("f.json", '{"figures": [{"name": "a", "topic": "bresenham_line", "input": {}}]}')
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
