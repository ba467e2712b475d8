#!/usr/bin/env python3
"""`gradus stress` from end to end: its report, its figures, its replays, what it refuses.

    tests/golden/stress_test.py [GRADUS]
"""
import functools
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
import project
from command import check, equal

gradus = functools.partial(command.gradus, timeout=240)


def test_every_promise_holds():
    result = gradus("stress", "--seconds", "5", "-o", "made/worst")
    equal(result.code, 0, "gradus stress")
    promises = re.findall(r"^([ X]) (\w+) +(\d+) cases  worst +(\S+) (.+)  \((.+)\)$", result.out, re.MULTILINE)
    check(len(promises) >= 42, "all promises are reported")
    for mark, name, cases, worst, _, bound in promises:
        check(mark == " " and worst != "wrong", f"{name} is kept")
        check(int(cases) >= 16, f"{name}: traps and kinds were tried")
        if bound != "measured":
            check(float(worst) <= float(bound.removeprefix("at most ")), f"{name}: worst is within its bound")
    check(re.search(r"^\d+ cases, 0 of \d+ promises broken \(--random-seed 1\)$", result.out, re.MULTILINE), "the sum")
    for file in pathlib.Path("made/worst").iterdir():
        check("</svg>" in file.read_text(), f"{file.name} is a figure")


def test_a_report_replays():
    result = gradus("stress", "bresenham_line", "--seconds", "1")
    equal(result.code, 0, "gradus stress bresenham_line")
    worst = re.search(r"worst +(\S+) pixels", result.out).group(1)
    case = re.search(r"--replay (\S+)", result.out).group(1)
    again = gradus("stress", "bresenham_line", "--replay", case)
    equal((again.code, again.out), (0, f"pixel_at: {worst} pixels (at most 0.5)\n"), "the worst case again")


def shown_traps():
    """What the table of traps names: (topic, property, trap), and tests."""
    page = (project.ROOT / "docs/stress.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (?!\*\*|trap |---)(.+?) \| (.+) \|$", page.split("## Traps")[1], re.MULTILINE)
    traps, tests = [], []
    for what, shown in rows:
        names = re.findall(r"`([^`]+)`", shown)
        equal(", ".join(f"`{name}`" for name in names), shown, f"{what}: names only")
        for name in names:
            trap = re.fullmatch(r"(\w+)/(\w+): (.+)", name)
            traps.append(trap.groups()) if trap else tests.append(name)
    return traps, tests


def test_every_trap_of_the_table_exists_and_holds():
    traps, tests = shown_traps()
    check(len(traps) > 50 and len(tests) > 20, "the table is read")
    for topic, name, trap in traps:
        result = gradus("stress", topic, "--replay", f"{name}:{trap}")
        equal((result.code, result.err), (0, ""), f"{topic}/{name}: {trap}")
    sources = [f.read_text(encoding="utf-8") for f in project.sources(project.ROOT, "tests/unit")]
    existing = {".".join(names) for text in sources
                for names in re.findall(r"^TEST\((\w+), (\w+)\)", text, re.MULTILINE)}
    equal(sorted(set(tests) - existing), [], "tests that do not exist")


def test_the_page_lists_every_promise():
    page = (project.ROOT / "docs/stress.md").read_text(encoding="utf-8")
    attacked = page.split("## What is attacked")[1].split("\n## ")[0]
    rows = re.findall(r"^\| `(\w+)` \| (.+) \|$", attacked, re.MULTILINE)
    listed = {topic: re.findall(r"`(\w+)`", row) for topic, row in rows}
    found, topic = {}, ""
    for line in gradus("stress", "--seconds", "1").out.splitlines():
        if re.fullmatch(r"\w+", line):
            topic = line
        promise = re.match(r"[ X] (\w+) +\d+ cases", line)
        if promise:
            found.setdefault(topic, []).append(promise.group(1))
    check(f"{sum(map(len, found.values()))} promises of {len(found)} topics" in attacked, "the page's numbers")
    equal({t: sorted(p) for t, p in listed.items()}, {t: sorted(p) for t, p in found.items()}, "the page's table")


def test_the_seed_decides():
    runs = [gradus("stress", "affine_3d", "--seconds", "1", "--random-seed", seed).out for seed in ("5", "6")]
    for run, seed in zip(runs, ("5", "6")):
        check(f"(--random-seed {seed})" in run, "the seed is printed")
    case = re.compile(r"(case \d+): gradus stress affine_3d --replay (\S+)")
    check(case.search(runs[0]).groups() != case.search(runs[1]).groups(), "other seeds, other inputs")


def test_bad_input_is_one_line():
    open("file", "w").close()
    whole = "expected a whole number from {} to {}, found '{}'"
    table = [
        (["nosuch_topic"], "TOPIC: expected the name of a topic (`gradus list` shows all), found 'nosuch_topic'"),
        (["textbook chain"], "TOPIC: pipeline has no stress test"),
        (["--seconds", "0"], "--seconds: " + whole.format(1, 1000000, 0)),
        (["--seconds", "2.5"], "--seconds: " + whole.format(1, 1000000, 2.5)),
        (["--random-seed", "-1"], "--random-seed: " + whole.format(0, 2**63 - 1, -1)),
        (["--replay", "x"], "--replay: expected PROPERTY:NUMBERS as a report prints it, or PROPERTY:TRAP, found 'x'"),
        (["affine_3d", "--replay", "rotation:1,x,0,0"],
         "--replay: expected PROPERTY:NUMBERS as a report prints it, or PROPERTY:TRAP, found 'rotation:1,x,0,0'"),
        (["affine_3d", "--replay", "rotation:1,2"], "--replay: rotation takes 4 numbers, found 2"),
        (["-o", "file"], "--output: expected a folder, found 'file'"),
    ]
    for words, message in table:
        result = gradus("stress", *words)
        equal((result.code, result.out, result.err), (2, "", f"gradus stress: {message}\n"), " ".join(words))
    equal(os.listdir("."), ["file"], "nothing else is written")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
