#!/usr/bin/env python3
"""What `gradus render` draws: models as they should look, and as they are committed.

    tests/golden/render_pictures_test.py [GRADUS]          compares with the pictures in tests/golden/renders
    tests/golden/render_pictures_test.py GRADUS --write    makes those pictures anew: look at each before committing
"""
import math
import os
import pathlib
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal
from renders import LETTER, LEVELS, OTHERS, Picture, ROOT, SHARE, SPOT, differing, gradus, picture, read, write

RENDERS = ROOT / "tests/golden/renders"
BOX, SHELF = str(OTHERS / "tinyobj/cornell_box.obj"), str(OTHERS / "geometry_central/platonic_shelf.obj")
TORUS = os.path.join(tempfile.mkdtemp(prefix="gradus_render_"), "torus.obj")

# The committed pictures, all 160 x 120. Those of centres alone; render_test.cpp makes those of SHARED
SHARED = ("letter_f", "spot", "cornell_box")
CENTRES = {
    "letter_f": [LETTER],
    "letter_f_from_behind": [LETTER, "--eye", "-1,1,-4"],
    "spot": [SPOT],
    "spot_face": [SPOT, "--eye", "-1.5,1.2,-2.7", "--light", "2,2,-2", "--background", "#202830"],
    "spot_from_above": [SPOT, "--eye", "0,4,0", "--fov", "36", "--up", "0,0,-1"],
    "spot_lying": [SPOT, "--up", "0,0,1"],
    "torus": [TORUS],
    "cornell_box": [BOX],
    "platonic_shelf": [SHELF],
}
# Antialiased ones
METHODS = ("supersampling", "accumulation_buffer", "jittered", "poisson_disc", "area_sampling", "a_buffer", "adaptive", "adaptive+contrast")
REFERENCES = {name: [*words, "--aa", "none"] for name, words in CENTRES.items()}
REFERENCES |= {f"letter_f_{method.replace('+', '_')}": [LETTER, "--aa", method] for method in METHODS}
REFERENCES |= {f"{name}_adaptive": CENTRES[name] for name in ("spot_face", "cornell_box", "platonic_shelf")}


def write_torus():
    """Lying, 48 by 24 quads, a quarter as thick as it is wide."""
    lines = []
    for i in range(48):
        for j in range(24):
            a, b = 2 * math.pi * i / 48, 2 * math.pi * j / 24
            r = 1.5 + 0.5 * math.cos(b)
            lines.append(f"v {r * math.cos(a):.6f} {0.5 * math.sin(b):.6f} {-r * math.sin(a):.6f}")
    for i in range(48):
        for j in range(24):
            corners = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
            lines.append("f " + " ".join(str(1 + i % 48 * 24 + j % 24) for i, j in corners))
    write(TORUS, "\n".join(lines) + "\n")


def test_references():
    for name, words in REFERENCES.items():
        reference = Picture(read(RENDERS / f"{name}.png"))
        share = differing(picture(*words, "--size", "160x120"), reference)
        print(f"{name}: {share:.4f} of the pixels differ from the reference")
        check(share <= SHARE, f"{name}: {share} of the pixels differ by more than {LEVELS} levels")
    check(differing(Picture(read(RENDERS / "spot.png")), Picture(read(RENDERS / "torus.png"))) > 0.1,
          "two models differ")


def test_antialiasing():
    """Edges have shades between; the default is adaptive; equal places give equal bytes."""
    centres = picture(LETTER, "--size", "160x120", "--aa", "none")
    colours = {p for row in centres.pixels for p in row}
    plain = picture(LETTER, "--size", "160x120")
    equal(plain.pixels, picture(LETTER, "--size", "160x120", "--aa", "Adaptive", "--samples", "16").pixels, "the default")
    once, passes = (picture(LETTER, "--size", "160x120", "--aa", method).pixels for method in ("supersampling", "accumulation_buffer"))
    equal(once, passes, "passes give the picture of all samples at once")
    for method in METHODS:
        shown = picture(LETTER, "--size", "160x120", "--aa", method)
        between = sum(p not in colours for row in shown.pixels for p in row)
        check(between > 200, f"{method}: {between} pixels have shades that no centre has")
        check(0.01 < differing(shown, centres) < 0.06, f"{method}: edges alone differ: {differing(shown, centres)}")


def test_transparent_edges():
    """Partly covered pixels have the colour of what covers them, not of a ground."""
    shown = picture(LETTER, "--size", "160x120", "--background", "none")
    white = picture(LETTER, "--size", "160x120")
    alphas = {p[3] for row in shown.pixels for p in row}
    check({0, 255} < alphas and len(alphas) > 8, f"alpha has shares: {sorted(alphas)}")
    for row, solid in zip(shown.pixels, white.pixels):
        for p, q in zip(row, solid):
            if p[3] == 255:
                equal(p[:3], q, "covered pixels are the same")
            elif p[3] == 0:
                equal((p, q), ((0, 0, 0, 0), (255, 255, 255)), "and so are bare ones")
            else:
                check(all(a <= b + 1 for a, b in zip(p[:3], q)), f"{p} before white is {q}")
    orange_edges = [p for row in shown.pixels for p in row if 0 < p[3] < 128 and orange(p)]
    check(len(orange_edges) > 20, f"the front's edges are orange however little is covered: {len(orange_edges)}")


def orange(p):
    return p[0] > 150 and p[0] > p[2] + 60


def blue(p):
    return p[2] > 120 and p[2] > p[0] + 60


def test_f_reads_as_f():
    letter = picture(LETTER, "--size", "160x120")
    reference = Picture(read(RENDERS / "letter_f.png"))
    check(differing(letter.mirrored(), reference) > 0.15, "its mirror image is far from the reference")
    # Straight from the front: a stem at the left from top to bottom, two bars to the right of it, the upper
    # one longer, and nothing at the lower right
    front = picture(LETTER, "--size", "200x200", "--eye", "0.4,0.625,4")
    left, top, right, bottom = front.where(orange)
    wide, high = right - left + 1, bottom - top + 1
    check(0.55 < wide / high < 0.73, f"as wide as the model: {wide} x {high}")

    def ink(x, y):
        return orange(front.pixels[top + round(y * (high - 1))][left + round(x * (wide - 1))])
    rows = {0.1: (True, True, True), 0.3: (True, False, False), 0.5: (True, True, False), 0.9: (True, False, False)}
    for y, expected in rows.items():
        equal(tuple(ink(x, y) for x in (0.15, 0.65, 0.95)), expected, f"the row {y} of the F")
    back = picture(LETTER, "--size", "200x200", "--eye", "0.4,0.625,-4")
    check(not back.where(orange), "no front from behind")
    left, top, right, bottom = back.where(blue)
    low = back.pixels[bottom - (bottom - top) // 10]
    check(not blue(low[left + 3]) and blue(low[right - 3]), "from behind the stem stands at the right")


def framing_of(words, size):
    """Share of the picture between each border and the model, and the larger share that the model takes."""
    shown = picture(*words, "--background", "none", "--size", "x".join(map(str, size)), "--aa", "none")
    equal(shown.kind, 6, "with alpha")
    check({p[3] for row in shown.pixels for p in row} <= {0, 255}, "alpha is all or nothing")
    left, top, right, bottom = shown.where(lambda p: p[3] == 255)
    w, h = size
    margins = left / w, (w - 1 - right) / w, top / h, (h - 1 - bottom) / h
    return margins, max((right - left + 1) / w, (bottom - top + 1) / h)


def test_framing():
    flags = [[], ["--fov", "5"], ["--fov", "90"], ["--up", "0,0,1"], ["--up", "0,-1,0"], ["--up", "1,2,-3"]]
    count = 0
    for model in (SPOT, LETTER, TORUS, BOX, SHELF):
        for size in ((200, 150), (90, 160), (240, 60)):
            for more in flags if size == (200, 150) else flags[:1]:
                margins, share = framing_of([model, *more], size)
                what = f"{os.path.basename(model)} {size} {more}: margins {margins}, {share}"
                check(min(margins) >= 0.03, what)
                check(0.85 <= share <= 0.93, what)
                count += 1
    equal(count, 5 * 8, "framings tried")
    margins, share = framing_of([SPOT, "--eye", "0,0.3,40"], (200, 150))
    check(share < 0.2 and max(margins) - min(margins) < 0.2, f"an eye far away sees it small, in the middle: {share}")


def test_lit():
    for model in (SPOT, TORUS):
        shown = picture(model, "--background", "none", "--size", "160x120")
        levels = sorted(p[0] for row in shown.pixels for p in row if p[3])
        check(levels[-1] - levels[0] > 60 and 120 < levels[len(levels) // 2] < 240, f"lit, with shades: {levels[::500]}")
    for light, brighter in (("-9,1,3", 0), ("9,1,3", 1)):
        shown = picture(TORUS, "--background", "none", "--size", "160x120", "--eye", "0,2,8", "--light", light)
        halves = [sum(p[0] for row in shown.pixels for p in row[at:at + 80] if p[3]) for at in (0, 80)]
        check(halves[brighter] > 1.2 * halves[1 - brighter], f"a lamp at {light} lights its side: {halves}")


def test_views():
    plain = picture(SPOT, "--size", "64x48")
    for same in (["--fov", "40"], ["--up", "0,7,0"], ["--background", "white"], ["--background", "#FFFFFF"]):
        check(differing(picture(SPOT, "--size", "64x48", *same), plain) == 0, f"{same} is what nobody needs to say")
    for other in (["--fov", "60", "--eye", "1,1,3"], ["--target", "1,0,0"], ["--eye", "3,1,0"], ["--background", "red"],
                  ["--light", "0,9,0"], ["--up", "1,0,0"]):
        check(differing(picture(SPOT, "--size", "64x48", *other), plain) > 0.05, f"{other} changes the picture")
    equal(picture(SPOT, "--size", "64x48", "--background", "#123456").pixels[0][0], (0x12, 0x34, 0x56), "the background")
    for size in ((1, 1), (1, 50), (2000, 1)):
        shown = picture(SPOT, "--size", "x".join(map(str, size)))
        equal((shown.width, shown.height), size, "any size")


def test_nothing_to_see():
    result = gradus("render", SPOT, "-o", "a.png", "--eye", "0,0,5", "--target", "0,0,9", "--size", "40x30")
    equal((result.code, result.err),
          (0, "render: the whole model lies behind the eye: the picture shows the background alone\na.png\n"), "behind the eye")
    equal({p for row in Picture(read("a.png")).pixels for p in row}, {(255, 255, 255)}, "the background alone")
    result = gradus("render", SPOT, "-o", "a.png", "--eye", "0,0,5", "--target", "9,0,5", "--size", "40x30")
    equal(result.err, "render: no pixel shows the model: the picture shows the background alone\na.png\n", "beside the picture")
    result = gradus("render", SPOT, "-o", "a.png", "--eye", "0,0,5", "--target", "0,0,9", "-q")
    equal((result.code, result.err), (0, ""), "-q says nothing")
    write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
    result = gradus("render", "line.obj", "-o", "a.png")
    check(result.code == 0 and "no pixel shows" in result.err, f"a face without area: {result.err}")


def test_extremes():
    for name, size in (("huge", "1e30"), ("tiny", "1e-30"), ("far", "1e9")):
        write(f"{name}.obj", f"v 0 0 0\nv {size} 0 0\nv 0 {size} 0\nv {size} {size} 0\nf 1 2 4 3\n")
        result = gradus("render", f"{name}.obj", "-o", f"{name}.png", "--size", "40x30")
        equal((result.code, result.err), (0, f"{name}.png\n"), name)
        check(differing(Picture(read(f"{name}.png")), Picture(read("huge.png"))) < 0.01, f"{name}: size makes no difference")
    # Once "--eye: expected another point than the target" for who had given none
    write("least.obj", "v 0 0 0\nv 1e-300 0 0\nv 0 1e-300 0\nv 1e-300 1e-300 0\nf 1 2 3\nf 2 4 3\n")
    result = gradus("render", "least.obj", "-o", "least.png", "--size", "40x30")
    equal((result.code, result.err), (0, "least.png\n"), "a model of size 1e-300")
    check(differing(Picture(read("least.png")), Picture(read("huge.png"))) < 0.01, "looks like one of size 1e30")
    write("dot.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n")
    write("far_dot.obj", "v 1e30 1e30 1e30\nv 1e30 1e30 1e30\nv 1e30 1e30 1e30\nf 1 2 3\n")
    for words in (["dot.obj"], ["far_dot.obj"], [SPOT, "--eye", "1e30,0,0"], [SPOT, "--eye", "0,0.3,0"], ["huge.obj", "--eye", "1,1,1"],
                  [SPOT, "--light", "0,0,0"], [SPOT, "--light", "1e30,0,-1e30"], [SPOT, "--fov", "0.001"],
                  [SPOT, "--fov", "179.999"], ["tiny.obj", "--eye", "1e-30,1e-30,1e-30"]):
        result = gradus("render", *words, "-o", "a.png", "--size", "40x30", "-q")
        equal((result.code, result.err), (0, ""), f"{words}")


def test_every_model():
    """Each model of the loaders' tests gives a picture, or a line with the file's name."""
    count = {0: 0, 2: 0}
    for model in sorted(OTHERS.rglob("*.obj")):
        result = gradus("render", str(model), "-o", "a.png", "--size", "32x24", "-q")
        check(result.code in count, f"{model.name}: exit code {result.code}: {result.err}")
        count[result.code] = count.get(result.code, 0) + 1
        equal(os.path.exists("a.png"), result.code == 0, f"{model.name}: a picture or none")
        if result.code == 0:
            os.remove("a.png")
        else:
            check(re.fullmatch(r"gradus: [^\n]*\.(obj|mtl):(\d+:)? [^\n]+\n", result.err), f"{model.name}: {result.err}")
    print(f"models: {count[0]} rendered, {count[2]} refused")
    check(count[0] >= 40 and count[2] >= 5, f"both happen: {count}")


def main():
    write_torus()
    if "--write" in sys.argv:
        for name in REFERENCES.keys() - SHARED:
            words = REFERENCES[name]
            gradus("render", *words, "--size", "160x120", "-o", str(RENDERS / f"{name}.png"))
        return 0
    return command.run_all(globals())


if __name__ == "__main__":
    sys.exit(main())
