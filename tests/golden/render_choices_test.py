#!/usr/bin/env python3
"""The choices of `gradus render`: projection, hidden surfaces, culling and wireframe, as flags and in scenes.

    tests/golden/render_choices_test.py [GRADUS]
    tests/golden/render_choices_test.py GRADUS --write    makes docs/rendering/choices.png anew: look at it
"""
import json
import pathlib
import re
import shutil
import struct
import sys
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal
from renders import LETTER, LEVELS, MODELS, Picture, ROOT, SHARE, SPOT, differing, gradus, picture, read, write

OBLIQUE = ["--projection", "oblique"]
WHITE = (255, 255, 255)
# The page's picture: three rows of three
PAGE = ROOT / "docs/rendering/choices.png"
BESIDE = ["--eye=-2,3,1", "--fov", "26"]
NINE = ([], ["--projection", "orthographic"], OBLIQUE,
        BESIDE, [*BESIDE, "--hidden-surfaces", "farthest_vertex"], [*BESIDE, "--hidden-surfaces", "bsp_tree"],
        ["--shading", "flat"], ["--shading", "wireframe"], ["--shading", "wireframe", "--culling", "none"])


def nine():
    """The rows of pixels of the page's picture."""
    parts = [picture(LETTER, "--size", "260x240", *words).pixels for words in NINE]
    return [[p for part in parts[at:at + 3] for p in part[y]] for at in (0, 3, 6) for y in range(240)]


def write_page():
    rows = nine()
    chunk = lambda kind, body: struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    raw = b"".join(b"\0" + bytes(channel for p in row for channel in p) for row in rows)
    PAGE.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def test_the_page_shows_these_choices():
    shown, rows = Picture(read(PAGE)), nine()
    apart = sum(max(abs(a - b) for a, b in zip(p, q)) > LEVELS for mine, its in zip(rows, shown.pixels) for p, q in zip(mine, its))
    check((shown.width, shown.height) == (780, 720) and apart <= SHARE * 780 * 720, f"{apart} pixels differ")


def boxed(shown):
    """The picture without its white margins, row by row."""
    places = [(x, y) for y, row in enumerate(shown.pixels) for x, p in enumerate(row) if p != WHITE]
    (left, top), (right, bottom) = (tuple(f(place[axis] for place in places) for axis in (0, 1)) for f in (min, max))
    return [row[left:right + 1] for row in shown.pixels[top:bottom + 1]]


def test_the_letter_reads_as_f():
    """Straight from the front: a stem on the left, two arms to the right, the upper one longer."""
    for words in (["--projection", "orthographic", "--eye", "0.5,0.7,9"], [*OBLIQUE, "--foreshortening", "0"]):
        rows = boxed(picture(LETTER, "--size", "80x60", "--aa", "none", *words))
        lengths = [max(x for x, p in enumerate(row) if p != WHITE) + 1 for row in rows]
        check(all(row[0] != WHITE for row in rows), "the stem")
        check(lengths[0] > 1.15 * lengths[len(rows) // 2] > 1.3 * lengths[-1], f"{words}: {lengths}")


def test_depth_recedes_as_told():
    """Cavalier at 45 degrees draws depth to the right and up, at 135 to the left and up."""
    right, left = (picture(LETTER, "--size", "80x80", *OBLIQUE, "--foreshortening", "1", "--receding", angle) for angle in ("45", "135"))
    orange = lambda p: p[0] > 2 * p[2]
    columns = [[x for row in shown.pixels for x, p in enumerate(row) if orange(p)] for shown in (right, left)]
    check(min(columns[1]) > min(columns[0]), "the front stands to the right of what recedes to the left")


def test_commands():
    """The canonical command says what was chosen, and `again` makes the same picture."""
    for given, said in ((["--projection", "Orthographic", "--height", "2.50"], "--projection orthographic --height 2.5"),
                        ([*OBLIQUE, "--receding", "030", "--foreshortening", "1/2"], "--projection oblique --receding 30"),
                        ([*OBLIQUE, "--foreshortening", "1"], "--projection oblique --foreshortening 1"),
                        (["--hidden-surfaces", "BSP_tree"], "--hidden-surfaces bsp_tree"),
                        (["--culling", "none", "--shading", "wireframe"], "--culling none --shading wireframe"),
                        (["--projection", "perspective", "--culling", "auto", "--hidden-surfaces", "z_buffer"], "")):
        shown = picture(LETTER, "--size", "40x30", *given)
        equal(shown.texts["gradus-command"], f"gradus render letter_f.obj --size 40x30 {said}".rstrip(), "its command")
        shutil.copy(LETTER, ".")
        shutil.copy(MODELS / "letter_f.mtl", ".")
        gradus("render", "letter_f.obj", "-o", "f.png", "--force", "--size", "40x30", *given)
        result = gradus("again", "f.png", "-o", "g.png", "--force")
        equal((result.code, read("g.png")), (0, read("f.png")), f"made again: {given} {result.err}")


def test_refusals():
    out = ["-o", "x.png"]
    for words, expected in (
            (["--projection", "isometric"], "--projection: expected one of perspective, orthographic, oblique, found 'isometric'"),
            (["--hidden-surfaces", "none"], "--hidden-surfaces: expected one of z_buffer, painter, bsp_tree, farthest_vertex, found 'none'"),
            (["--culling", "front"], "--culling: expected one of auto, none, back, found 'front'"),
            (["--shading", "wire"], "--shading: expected one of flat, gouraud, phong, wireframe, found 'wire'"),
            (["--height", "2"], "--height: expected no value beside the projection perspective, found '2'"),
            ([*OBLIQUE, "--fov", "40"], "--fov: expected no value beside the projection oblique, found '40'"),
            (["--projection", "orthographic", "--receding", "30"],
             "--receding: expected no value beside the projection orthographic, found '30'"),
            ([*OBLIQUE, "--height", "0"],
             "--height: expected how much is seen from the lower to the upper edge, 1e-30 to 1e30, found '0'"),
            ([*OBLIQUE, "--foreshortening", "-1"], "--foreshortening: expected how long a unit of depth is drawn, 0 to 100, found '-1'")):
        result = gradus("render", LETTER, *out, *words)
        equal((result.code, result.err), (2, f"gradus: {expected}\n"), "one line")
        check(not pathlib.Path("x.png").exists(), "nothing is written")
    for camera, key in (({"height": 2}, "height"), ({"projection": "oblique", "fov": 30}, "fov"),
                        ({"projection": "orthographic", "receding": 30}, "receding")):
        write("s.json", json.dumps({"camera": camera, "objects": [{"model": LETTER}]}))
        result = gradus("render", "s.json", *out)
        check(result.code == 2 and f's.json:1: /camera/{key}: expected no key "{key}" beside the projection' in result.err, result.err)


def test_scenes_say_the_same_as_flags():
    write("s.json", json.dumps({"hidden_surfaces": "bsp_tree", "culling": "none", "shading": "flat",
                                "camera": {"projection": "oblique", "height": 3, "receding": 30, "foreshortening": 1},
                                "objects": [{"model": LETTER}]}))
    flags = ["--hidden-surfaces", "bsp_tree", "--culling", "none", "--shading", "flat", *OBLIQUE, "--height", "3",
             "--receding", "30", "--foreshortening", "1"]
    plain = picture(LETTER, "--size", "80x60", *flags)
    check(picture("s.json", "--size", "80x60").pixels == plain.pixels, "the same pixels")
    higher = picture("s.json", "--size", "80x60", "--height", "6")
    check(higher.pixels != plain.pixels, "a flag for the file's projection counts")
    equal(higher.texts["gradus-command"], "gradus render s.json --size 80x60 --height 6", "and is said")


def test_methods_for_hidden_surfaces():
    """On a cow the tree and the painter show what the z-buffer shows; a sort without tests does not."""
    words = ["--size", "160x120", "--shading", "flat", "--filter", "none"]
    z_buffer, tree, painter, sort = (picture(SPOT, *words, "--eye", "-1.5,1.2,-2.7", "--hidden-surfaces", method)
                               for method in ("z_buffer", "bsp_tree", "painter", "farthest_vertex"))
    print(f"of the pixels differ: tree {differing(z_buffer, tree):.5f}, painter {differing(z_buffer, painter):.5f}, sort {differing(z_buffer, sort):.5f}")
    check(differing(z_buffer, tree) <= SHARE, f"{differing(z_buffer, tree)}")
    check(differing(z_buffer, painter) <= SHARE, f"{differing(z_buffer, painter)}")
    check(differing(z_buffer, sort) > 0, "where a sort errs")


def test_wireframes():
    dark = picture(LETTER, "--size", "80x60", "--shading", "wireframe", "--background", "black")
    light = picture(LETTER, "--size", "80x60", "--shading", "wireframe")
    both = picture(LETTER, "--size", "80x60", "--shading", "wireframe", "--culling", "none")
    count = [sum(p != ground for row in shown.pixels for p in row) for shown, ground in ((dark, (0, 0, 0)), (light, WHITE), (both, WHITE))]
    check(max(max(row) for row in dark.pixels) == WHITE, "white on black")
    check(min(min(row) for row in light.pixels) < (60, 60, 60), "black on white")
    check(0.9 < count[0] / count[1] < 1.1 and count[2] > 1.2 * count[1], f"backs have edges, too: {count}")


def test_far_small_and_flat_models():
    """Where numbers are at their ends there is a picture all the same."""
    write("tiny.obj", "v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n")
    write("huge.obj", "v 0 0 0\nv 1e30 0 0\nv 0 1e30 0\nv 1e30 1e30 -1e30\nf 1 2 3\nf 2 4 3\n")
    for model in ("tiny.obj", "huge.obj", SPOT):
        for eye in ([], ["--eye", "1e30,0,1e30"], ["--eye", "0,5,0"]):
            for words in (["--hidden-surfaces", "painter"], ["--hidden-surfaces", "bsp_tree"], ["--shading", "wireframe"]):
                for projection in ("orthographic", "oblique"):
                    result = gradus("render", model, "-o", "x.png", "-q", "--force", "--size", "12x9", *eye, *words, "--projection", projection)
                    equal(result.code, 0, f"{model} {eye} {words} {projection}: {result.err}")


def test_completion_knows_the_names():
    for flag, names in (("--projection", "perspective orthographic oblique"), ("--hidden-surfaces", "z_buffer painter bsp_tree farthest_vertex"),
                        ("--culling", "auto none back"), ("--shading", "flat gouraud phong wireframe")):
        page = (ROOT / "docs/rendering.md").read_text()
        row = re.search(rf"^\| `{flag} .*$", page, re.M)[0]
        for name in names.split():
            check(f"`{name}`" in row, f"docs/rendering.md: {flag} {name}")


if __name__ == "__main__":
    if "--write" in sys.argv:
        sys.exit(write_page())
    sys.exit(command.run_all(globals()))
