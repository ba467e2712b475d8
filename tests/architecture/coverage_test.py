#!/usr/bin/env python3
"""docs/coverage.csv (id, statement, kind, name): every statement names a test, figure or benchmark that exists."""
import csv
import json
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

HEADER = ["id", "statement", "kind", "name"]
KINDS = ("test", "figure", "benchmark")


def existing_names():
    """What there is, by kind. A test is known by its ctest name and, without the folder, by its GoogleTest name; unit
    tests also by their sources, for a build may leave them to another one."""
    listed = json.loads(project.run("ctest", "--show-only=json-v1", "--test-dir", project.BUILD))
    tests = {re.sub(r"  # GetParam\(\) = .*", "", test["name"]) for test in listed["tests"]}
    tests |= {re.sub(r"^.*?/(?=[A-Z]\w*[./])", "", name) for name in tests}
    for source in project.sources(project.ROOT, "tests/unit"):
        text = project.without_comments(source.read_text(encoding="utf-8"))
        tests |= {".".join(names) for names in re.findall(r"^TEST(?:_F)?\((\w+),\s*(\w+)\)", text, re.MULTILINE)}
    gallery = json.loads((project.ROOT / "examples/gallery.json").read_text(encoding="utf-8"))
    benchmarks = "\n".join(f.read_text(encoding="utf-8") for f in project.sources(project.ROOT, "tests/benchmark"))
    return {
        "test": tests,
        "figure": {figure["name"] for figure in gallery["figures"]},
        "benchmark": set(re.findall(r"\bBENCHMARK(?:_CAPTURE|_TEMPLATE)?\((\w+)", benchmarks)),
    }


def violations(text, names):
    rows = list(csv.reader(text.splitlines()))
    if not rows or rows[0] != HEADER:
        return [f"the first line is {','.join(HEADER)}"]
    found = []
    seen = set()
    for number, row in enumerate(rows[1:], 2):
        if len(row) != len(HEADER):
            found.append(f"line {number}: {len(row)} fields, not {len(HEADER)}")
            continue
        identifier, statement, kind, name = row
        if not re.fullmatch(r"R\d{3}-\d{3}", identifier):
            found.append(f"line {number}: {identifier} is not of the form R001-012")
        if (identifier, kind, name) in seen:
            found.append(f"line {number}: {identifier} names {name} twice")
        seen.add((identifier, kind, name))
        if not statement.strip():
            found.append(f"line {number}: {identifier} states nothing")
        if kind not in KINDS:
            found.append(f"line {number}: {kind} is none of {', '.join(KINDS)}")
        elif name not in names[kind]:
            found.append(f"line {number}: there is no {kind} {name}")
    return found


class Coverage(unittest.TestCase):
    def test_every_statement_is_shown_by_something_that_exists(self):
        names = existing_names()
        for kind in ("test", "figure"):
            self.assertGreater(len(names[kind]), 0, kind)
        found = violations((project.ROOT / "docs/coverage.csv").read_text(encoding="utf-8"), names)
        self.assertEqual(found, [], "\n" + "\n".join(found))

    def test_planted_faults_are_caught(self):
        names = {"test": {"Line.Ends"}, "figure": {"line"}, "benchmark": set()}
        good = "id,statement,kind,name\nR001-012,\"It ends, surely.\",test,Line.Ends\nR001-012,It ends.,figure,line\n"
        self.assertEqual(violations(good, names), [])
        for line, expected in (("R1-2,It ends.,test,Line.Ends", "not of the form"),
                               ("R001-012,It ends.,test,Line.Ends", "twice"),
                               ("R001-013, ,test,Line.Ends", "states nothing"),
                               ("R001-013,It ends.,hope,Line.Ends", "none of test"),
                               ("R001-013,It ends.,test,Line.Starts", "no test Line.Starts"),
                               ("R001-013,It ends.,figure,circle", "no figure circle"),
                               ("R001-013,It ends, surely.,test,Line.Ends", "5 fields")):
            with self.subTest(line):
                found = violations(good + line + "\n", names)
                self.assertEqual(len(found), 1, found)
                self.assertIn(expected, found[0])
        self.assertEqual(len(violations("id,kind\n", names)), 1)


if __name__ == "__main__":
    unittest.main()
