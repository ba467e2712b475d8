#!/usr/bin/env python3
"""A line of one's own, checked by gradus: the pixels nearest to it, column by column, with Python's own rounding.

    gradus cases bresenham_line --json > cases.json
    ./line.py cases.json > results.json
    gradus check bresenham_line results.json

Python rounds a half to the even number; gradus takes the smaller one. Both are right, and the report says so.
"""
import json
import sys
from fractions import Fraction


def line(start, end):
    """The pixels of a line, in order, each nearest to it along the axis that does not lead."""
    (x0, y0), (x1, y1) = start, end
    leads = 0 if abs(x1 - x0) >= abs(y1 - y0) else 1
    length = abs(end[leads] - start[leads])
    pixels = []
    for k in range(length + 1):
        share = Fraction(k, length) if length else Fraction(0)
        pixels.append([round(a + share * (b - a)) for a, b in ((x0, x1), (y0, y1))])
    return pixels


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        cases = json.load(file)
    answers = []
    for case in cases["cases"]:
        pixels = line(case["arguments"]["from"], case["arguments"]["to"])
        answers.append({"case": case["case"], "result": {"pixels": pixels, "count": len(pixels)}})
    results = {"topic": cases["topic"], "seed": cases["seed"], "program": "line.py", "conventions": {"ties": "even"},
               "answers": answers}
    json.dump(results, sys.stdout)


main()
