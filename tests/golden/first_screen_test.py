#!/usr/bin/env python3
"""The README's first screen: one sentence, then pictures, each of which the command below it makes to the byte.

    tests/golden/first_screen_test.py [GRADUS]

GRADUS_UPDATE_GOLDEN=1 makes docs/first_screen/ anew, but for the moving picture (tests/browser/moving_picture.py); look at the
pictures before committing.
"""
import html
import os
import pathlib
import re
import shlex
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal, gradus, read

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = "docs/first_screen/"
FIRST = (ROOT / "README.md").read_text(encoding="utf-8").split("\n## ")[0]
PICTURE = re.compile(rf'<img [^>]*src="{FOLDER}([^"]+)" alt="([^"]+)">')
MOST_BYTES = 250_000  # a picture, for who reads on a telephone


def with_what_follows():
    """File -> the small print below it."""
    parts = PICTURE.split(FIRST)
    return {name: html.unescape(re.search(r"<sub>(.*?)</sub>", below, re.S)[1]) for name, below in zip(parts[1::3], parts[3::3])}


def test_it_begins_with_a_sentence_and_pictures():
    heading, sentence, *rest = FIRST.split("\n\n")
    equal(heading, "# Gradus", "the name")
    check(sentence.count("\n") == 0 and len(re.findall(r"[.!?](?:\s|$)", sentence)) == 1 and len(sentence) < 200, f"one sentence: {sentence}")
    check(rest[0].startswith("<table>"), "then the pictures")
    equal(FIRST.count("<img "), len(PICTURE.findall(FIRST)), "each in the folder, with words for who can't see it")
    equal(set(with_what_follows()), set(os.listdir(ROOT / FOLDER)), "and no other in the folder")
    for link in re.findall(r'href="([^"]+)"', FIRST):
        check((ROOT / link).is_file(), f"{link} leads somewhere")


def test_each_picture_is_made_by_the_command_below_it():
    for name, below in with_what_follows().items():
        program, *words = shlex.split(below)
        if program != "gradus":
            check((ROOT / program).is_file(), f"{program}, which makes {name} and compares it, is there")
            continue
        equal(words[-2:], ["-o", name], "it names its picture")
        equal(gradus(*words).code, 0, below)
        if os.environ.get("GRADUS_UPDATE_GOLDEN"):
            (ROOT / FOLDER / name).write_bytes(read(name))
        check(read(name) == (ROOT / FOLDER / name).read_bytes(), f"{FOLDER}{name} is what `{below}` makes: look at it, then GRADUS_UPDATE_GOLDEN=1")
        check(len(read(name)) < MOST_BYTES, f"{name}: {len(read(name))} bytes")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
