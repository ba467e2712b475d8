#!/usr/bin/env python3
"""A wide picture stretches what lies aside: balls of equal angle become ellipses, as the plane of the picture cuts them.

    tests/golden/wide_field_test.py [GRADUS]          compares with the pictures in docs/demos, too
    tests/golden/wide_field_test.py GRADUS --write    makes those pictures anew: look at each before committing
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal
from renders import ROOT, SHARE, Picture, differing, gradus, read

PAGE = ROOT / "docs/demos"
# Angle of view -> the balls farthest aside that it shows, in degrees
FIELDS = {40: 14, 80: 33, 120: 53}
# What docs/demos.md says of them
TOLD = {40: "| 40° | 14° aside | 1.03 | 89 : 86 pixels |", 80: "| 80° | 33° aside | 1.19 | 52 : 44 pixels |",
        120: "| 120° | 53° aside | 1.67 | 49 : 30 pixels |"}
HALF = math.asin(1 / 12)  # how large a ball is seen: radius 1 in a distance of 12


def shape(aside, focal):
    """Width and height of a ball's ellipse: its cone cut by the plane of the picture."""
    angle = math.radians(aside)
    wide = focal * (math.tan(angle + HALF) - math.tan(angle - HALF))
    high = 2 * focal * math.sin(HALF) / math.sqrt(math.cos(angle) ** 2 - math.sin(HALF) ** 2)
    return wide, high


def run(line, start):
    """How many pixels of a ball there are without a gap, from one of them on in both directions."""
    first = last = start
    while line[first - 1] != (255, 255, 255):
        first -= 1
    while line[last + 1] != (255, 255, 255):
        last += 1
    return last - first + 1


def found_shape(shown, aside, focal):
    """Of the ball on the right: along the row and the column through the middle of its ellipse."""
    angle = math.radians(aside)
    middle = int(180 + focal * (math.tan(angle + HALF) + math.tan(angle - HALF)) / 2)
    return run(shown.pixels[180], middle), run([row[middle] for row in shown.pixels], 180)


def test_stretching_grows_with_the_angle_of_view():
    before = 1
    for fov, aside in FIELDS.items():
        name = f"wide_{fov}.png"
        gradus("render", "wide_field.json", "--fov", str(fov), "-o", name)
        if "--write" in sys.argv:
            (PAGE / name).write_bytes(read(name))
        shown, focal = Picture(read(name)), 180 / math.tan(math.radians(fov / 2))
        check(differing(shown, Picture(read(PAGE / name))) <= SHARE, f"docs/demos/{name} is what its command makes")
        for angle in (0, aside):
            (wide, high), (found_wide, found_high) = shape(angle, focal), found_shape(shown, angle, focal)
            print(f"fov {fov}, {angle} degrees aside: {wide:.1f} x {high:.1f}, found {found_wide} x {found_high}")
            # Partly covered pixels count whole; 32 corners lie up to 1% inside a circle
            check(-0.01 * wide - 0.5 <= found_wide - wide <= 2 and -0.01 * high - 0.5 <= found_high - high <= 2, f"{name}: {angle}")
        found = f"| {fov}° | {aside}° aside | {wide / high:.2f} | {found_wide} : {found_high} pixels |"
        equal(found, TOLD[fov], "the table of the page")
        check(found in (ROOT / "docs/demos.md").read_text(encoding="utf-8"), found)
        stretching = found_wide / found_high
        check(stretching > before + 0.02, f"{name}: {stretching:.2f} times as wide as high, before {before:.2f}")
        before = stretching
    check(before > 1.6, f"at 53 degrees {before:.2f}")


sys.exit(command.run_all(globals()))
