#!/usr/bin/env python3
"""`gradus explain`, and what of a plan shows in `gradus render`: --part, --without and --report.

    tests/golden/explain_command_test.py [GRADUS]
"""
import collections
import json
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, check, equal
from renders import LETTER, MODELS, Picture, gradus, picture, read

STAGES = range(1, 8)
SMALL = ["--size", "160x90"]


def plan(*words):
    return json.loads(gradus("explain", *words, "--json").out)


def ledger(*words):
    """The rows that --report prints: (stage, total, done, left out, {why: count})."""
    result = gradus("render", *words, "-o", "x.png", "--force", "--report")
    equal(result.code, 0, result.err)
    rows = re.findall(r"^(\d \D+?)  .*?  +(\d+)  +(\d+)  +(\d+)(?:  (\D.*))?$", result.out, re.M)
    whys = [dict((w, int(n)) for w, n in re.findall(r"(\D+?) (\d+)(?:, |$)", row[4])) for row in rows]
    return [(row[0], int(row[1]), int(row[2]), int(row[3]), why) for row, why in zip(rows, whys)], result.out


def test_examples_run():
    examples = re.findall(r"^  (gradus explain .*)$", gradus("explain", "--help").out, re.M)
    check(len(examples) >= 5, f"examples to paste: {examples}")
    for line in examples:
        result = subprocess.run(line.replace("gradus", f"'{GRADUS}'", 1), shell=True, capture_output=True)
        equal(result.returncode, 0, f"{line}: {result.stderr}")
    check(Picture(read("left_out.png")).where(lambda p: p[0] > p[2] + 40), "the heat map has warm colours")


def test_each_object_and_stage_has_a_decision():
    town = plan("town.json", *SMALL)
    equal((town["width"], town["height"], town["part"]), (160, 90, [0, 0, 160, 90]), "the size")
    equal(len(town["objects"]), 1391, "every instance")
    kinds = collections.Counter()
    for thing in town["objects"]:
        equal([s["stage"] for s in thing["stages"]], list(STAGES), thing["name"])
        check(all(s["work"] in ("run", "part", "skip") for s in thing["stages"]), thing)
        check(all(s["why"] for s in thing["stages"] if s["work"] != "run"), f"{thing}: a reason for what does not run")
        kinds[thing["stages"][0]["why"].split(":")[0].split(" behind")[0]] += 1
    check(kinds["outside"] > 800 and kinds["hidden"] > 100 and kinds[""] > 100, f"most of the town is left out: {kinds}")
    text = gradus("explain", "town.json", *SMALL).out
    check(text.startswith("town.json: 1391 objects, 34976 triangles, 160 x 90 of 160 x 90 pixels\n"), text)
    sums = [sum(map(int, re.findall(r"\d+", row))) for row in re.findall(r"^\d [a-z -]+((?: +\d+){3})$", text, re.M)]
    equal(sums, [1391] * 7, "each object is in one column of each stage")
    equal(sum(map(int, re.findall(r"^(\d+) objects?, \d+ triangle", text, re.M))), 1391, "and in one group")


def most_steps(picture, other):
    """The largest difference of two pictures of one size."""
    return max(abs(a - b) for row, other_row in zip(picture, other, strict=True)
               for pixel, other_pixel in zip(row, other_row, strict=True)
               for a, b in zip(pixel, other_pixel, strict=True))


def test_plan_changes_no_pixel():
    for scene in ("town.json", "closed_room.json", "spot.json"):
        whole = picture(scene, *SMALL)
        equal(picture(scene, *SMALL, "--without", "all").pixels, whole.pixels, f"{scene} without any rule")
        equal(picture(scene, *SMALL, "--without", "hidden, Outside").pixels, whole.pixels, f"{scene} without two rules")
        check(most_steps(picture(scene, *SMALL, "--engine", "textbook").pixels, whole.pixels) <= 1,
              f"{scene} by the textbook chain: at most a step of 255 apart")
        part = picture(scene, *SMALL, "--part", "40,20,70x50")
        equal(part.pixels, [row[40:110] for row in whole.pixels[20:70]], f"a part of {scene}")
        check(part.texts["gradus-command"].endswith(" --size 160x90 --part 40,20,70x50"), part.texts["gradus-command"])
        check(part.texts["Description"].endswith(", 70 x 50 pixels."), part.texts["Description"])
    equal(gradus("render", "spot.json", *SMALL, "--part", "40,20,70x50", "-o", "part.png").code, 0, "a part")
    equal(gradus("again", "part.png", "-o", "again.png").code, 0, "and again")
    equal(read("again.png"), read("part.png"), "the same")


def test_ledger_adds_up():
    totals = []
    for words, drawn_by in ((["--engine", "textbook"], "the textbook chain"), ([], "the engine, in single precision"),
                            (["--aa", "none"], "the engine, in single precision"),
                            (["--background", "none"], "the engine, in double precision")):
        rows, text = ledger("town.json", *SMALL, *words)
        equal([row[0][0] for row in rows], list("1234567778"), f"the stages\n{text}")
        for name, total, done, left_out, why in rows:
            equal(done + left_out, total, f"{name} of {text}")
            equal(sum(why.values()), left_out, f"{name}: each has a reason\n{text}")
        check(rows[0][4]["outside"] > 5000, text)
        equal(rows[0][4].get("hidden", 0) > 1000, drawn_by == "the textbook chain", text)
        check(f"\ndrawn by {drawn_by}\n" in text, text)
        totals.append(rows[0][1:2])
    equal(totals, totals[:1] * 4, "the same faces")
    check(re.search(r"^reading [\d.]+ ms, mip maps and buffers [\d.]+ ms, planning [\d.]+ ms, stages 1 to 5 [\d.]+ ms, 6 and 7 [\d.]+ ms, 8 [\d.]+ ms, the file [\d.]+ ms$", text, re.M), text)
    rows, text = ledger("town.json", *SMALL, "--without", "all")
    equal(rows[0][2:4], (rows[0][1], 0), f"without any rule all faces come in\n{text}")
    piped = gradus("render", LETTER, "--size", "16x16", "-o", "-", "--report")
    check(piped.bytes.startswith(b"\x89PNG") and "done and left out" in piped.err, "beside a picture on standard output")


def test_why_leads_from_the_file_to_the_colour():
    """Face, line and corners are those of the OBJ file, and the colour is the picture's."""
    for pixel in ("480,300", "520,260", "455,320"):
        told = gradus("render", "spot.json", "--why", pixel).out
        column, row = map(int, pixel.split(","))
        line = int(re.search(r"^Spot, face \d+ \(spot\.obj:(\d+)\), triangle", told, re.M)[1])
        lines = (MODELS / "spot.obj").read_text().splitlines()
        check(lines[line - 1].startswith("f "), f"{pixel}: line {line} is a face: {lines[line - 1]}")
        vertices = [tuple(map(float, l.split()[1:4])) for l in lines if l.startswith("v ")]
        there = [vertices[int(word.split("/")[0]) - 1] for word in lines[line - 1].split()[1:]]
        block = told[told.index("Spot, face"):]
        corners = re.findall(r"\(([^,]+), ([^,]+), ([^,)]+)\)$", block[:block.index("2 world")], re.M)
        equal(len(corners), 3, f"three corners\n{block}")
        for corner in corners:
            check(any(max(abs(float(a) - b) for a, b in zip(corner, v)) < 1e-6 for v in there), f"{pixel}: {corner} of {there}")
        whole = picture("spot.json").pixels[row][column]
        equal(re.search(r"the picture has #(\w+)$", told, re.M)[1], "%02x%02x%02x" % whole[:3], pixel)
        plain = picture("spot.json", "--aa", "none", "--engine", "textbook").pixels[row][column]
        equal(re.search(r"is #(\w+) in sRGB", told)[1], "%02x%02x%02x" % plain[:3], f"{pixel}, its centre")
        # ambient + diffuse + highlight = light, in three colours
        sums = re.search(r"ambient \((.*?)\) \+ diffuse \((.*?)\) \+ highlight \((.*?)\) = \((.*?)\)$", told, re.M).groups()
        a, d, h, light = ([float(n) for n in part.split(",")] for part in sums)
        check(all(abs(x + y + z - w) < 1e-5 for x, y, z, w in zip(a, d, h, light)), sums)
    empty = gradus("render", "spot.json", "--why", "0,0").out
    check("No triangle covers its centre: it shows the background." in empty, empty)


def test_names_move_no_terminal():
    """Names of objects and materials come from files: what a terminal would act upon is spelled out."""
    hostile = "wall\x1b[31m\n\u202e"
    pathlib.Path("bad.mtl").write_text("newmtl red\x1b[5m\nKd 1 0 0\n")
    pathlib.Path("bad.obj").write_text("mtllib bad.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl red\x1b[5m\nf 1 2 3 4\n")
    pathlib.Path("bad.json").write_text(json.dumps({
        "camera": {"eye": [0, 0, 3], "target": [0, 0, 0]},
        "objects": [{"name": hostile, "model": "bad.obj"}, {"name": "far", "model": "bad.obj", "place": [{"scale": 0.2}, {"translate": [0, 0, -3]}]}]}))
    for words in (("explain", "bad.json", *SMALL), ("render", "bad.json", *SMALL, "--why", "80,45"),
                  ("render", "bad.json", *SMALL, "-o", "bad.png", "-f", "--report")):
        told = gradus(*words)
        equal(told.code, 0, f"{words}: {told.err}")
        check(not re.search("[\x00-\x09\x0b-\x1f\x7f\u202e]", told.out), f"{words}: {told.out!r}")
    check("hidden behind what is nearer, like wall\\x1b[31m\\n" in gradus("explain", "bad.json", *SMALL).out, "spelled out")


def test_refusals():
    part = "--part: expected column, row and size like 120,88,200x100 within the picture of 160x90, found "
    rules = ("--without: expected all, or some of outside, area_of_interest, hidden, inside, out_of_range, no_highlight, unchanged, "
             "found ")
    for words, complaint in (
            (["--part", "0,0,161x90"], part + "'0,0,161x90'"), (["--part", "160,0,1x1"], part + "'160,0,1x1'"),
            (["--part=-1,0,1x1"], part + "'-1,0,1x1'"), (["--part", "0,0,0x1"], part + "'0,0,0x1'"),
            (["--part", "0,0"], part + "'0,0'"), (["--part", "1,2,3"], part + "'1,2,3'"), (["--part", ""], "--part: expected C,R,WxH, found none"),
            (["--without", "outside,"], rules + "'outside,'"), (["--without", "luck"], rules + "'luck'")):
        for name, more in (("explain", []), ("render", ["-o", "y.png"])):
            result = gradus(name, LETTER, *SMALL, *words, *more)
            equal((result.code, result.err, result.out), (2, f"gradus: {complaint}\n", ""), f"{name} {words}")
    pixel = "--why: expected column and row like 120,88 within the picture of 160x90, found "
    for words, complaint in ((["--why", "160,0"], pixel + "'160,0'"), (["--why", "5"], pixel + "'5'"), (["--why=-1,2"], pixel + "'-1,2'"),
                             (["--why", "1,2", "--report"], "--why: expected alone, without --report: it tells of one pixel, found --report"),
                             (["--why", "1,2", "--part", "0,0,9x9"], "--why: expected alone, without --part: it tells of one pixel, found --part")):
        result = gradus("render", LETTER, *SMALL, *words)
        equal((result.code, result.err, result.out), (2, f"gradus: {complaint}\n", ""), words)
    for words, complaint in (
            (["-o", "x.pdf"], "-o: expected a name that ends in .png or .svg, found 'x.pdf'"),
            (["-o", "none/x.png"], "-o: expected a folder that exists, found 'none'"),
            (["-o", "x.png", "--json"], "--json: expected alone, without -o: it prints, found -o")):
        result = gradus("explain", LETTER, *SMALL, *words)
        equal((result.code, result.err), (2, f"gradus: {complaint}\n"), words)
    check(not pathlib.Path("y.png").exists(), "nothing is written")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
