#!/usr/bin/env python3
"""`gradus render SCENE --frames`: every frame of a camera's path, alone and together, taken up after a kill, in parts.

    tests/golden/render_frames_test.py [GRADUS]
    tests/golden/render_frames_test.py GRADUS --write    makes the page's picture anew: look at it before committing
"""
import json
import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
import figure_files
from command import GRADUS, PLAIN, check, equal, files, wait_for
from renders import MODELS, ROOT, SHARE, Picture, differing, gradus, picture, read, write

FLIGHT, SMALL = "town_flight.json", ["--size", "64x36"]
FRAMES = ["-o", "f/f-{frame}.png"]


def scene(name="s.json", **camera):
    """The letter F and a camera that goes round it in 12 frames, with a rest from 4 to 7."""
    keys = [{"frame": 0, "eye": [0, 1, 5]}, {"frame": 4, "eye": [3, 1, 4]}, {"frame": 7, "eye": [3, 1, 4]}, {"frame": 11, "eye": [5, 2, 0]}]
    write(name, json.dumps({"camera": {"target": [0, 0, 0], "path": keys, **camera}, "objects": [{"model": str(MODELS / "letter_f.obj")}]}))
    return name


def contents(folder="f"):
    return {name: read(pathlib.Path(folder) / name) for name in files(folder)}


def rendered(*words):
    result = gradus("render", *words)
    equal(result.code, 0, f"{words}: {result.err}")
    return result


def test_frames_are_the_pictures_of_their_numbers():
    result = rendered(FLIGHT, *SMALL, *FRAMES, "--frames", "60-66")
    equal((result.out, result.err), ("", "f/f-{frame}.png: 7 frames\n"), "what was made")
    equal(files("f"), [f"f-{i:03}.png" for i in range(60, 67)], "files")
    for i in (60, 64, 66):
        rendered(FLIGHT, *SMALL, "-o", "one.png", "--frames", str(i))
        equal(read("one.png"), read(f"f/f-{i:03}.png"), f"frame {i} alone")
    shown = Picture(read("f/f-060.png"))
    equal(shown.texts["gradus-command"], "gradus render town_flight.json --size 64x36 --frames 60", "its command")
    equal(shown.texts["Title"], "town_flight.json, frame 60", "its title")
    equal((gradus("again", "f/f-060.png", "-o", "again.png").code, read("again.png")), (0, read("f/f-060.png")), "again")
    equal(picture(FLIGHT, *SMALL).pixels, picture(FLIGHT, *SMALL, "--frames", "0").pixels, "without a frame the first")
    pictures = [Picture(read(f"f/f-{i:03}.png")).pixels for i in range(60, 67)]
    check(all(a != b for a, b in zip(pictures[:4], pictures[1:5])) and pictures[4] == pictures[5] == pictures[6], "it comes to rest")


def test_a_frame_is_the_picture_of_a_camera_that_stands_there():
    name = scene()
    moving = picture(name, *SMALL, "--frames", "2")
    keys = {"target": [0, 0, 0], "eye": [1.5, 1, 4.5]}
    lights = {"lights": [{"kind": "directional", "direction": [-1, -1, -2]}]}
    for file, camera in (("moving.json", json.loads(read(name))["camera"]), ("still.json", keys)):
        write(file, json.dumps({"camera": camera, **lights, "objects": [{"model": str(MODELS / "letter_f.obj")}]}))
    equal(picture("moving.json", *SMALL, "--frames", "2").pixels, picture("still.json", *SMALL).pixels, "the camera half way to its key")
    check(moving.pixels != picture(name, *SMALL, "--frames", "3").pixels, "it moves")
    held = [picture(name, *SMALL, "--eye", "0,2,5", "--frames", str(i)).pixels for i in (0, 9)]
    check(held[0] == held[1], "a flag holds it still")


def test_whatever_the_number_of_threads():
    name = scene()
    rendered(name, *SMALL, "-o", "a/{frame}.png", "-j", "1")
    rendered(name, *SMALL, "-o", "b/{frame}.png", "--jobs", "5", "--without", "unchanged")
    equal(files("a"), [f"{i:03}.png" for i in range(12)], "all frames where none are named")
    equal(contents("b"), contents("a"), "the same bytes, also where unchanged frames are rendered")
    rendered(name, *SMALL, "-o", "c/{frame}.png", "--frames", "1-11/4")
    equal(files("c"), ["001.png", "005.png", "009.png"], "every fourth")


def test_parts_are_all_frames_once():
    name = scene()
    rendered(name, *SMALL, *FRAMES)
    whole = contents()
    for parts in (1, 3, 5, 14):
        made = []
        for k in range(1, parts + 1):
            folder = f"{parts}-{k}"
            result = rendered(name, *SMALL, "-o", f"{folder}/f-{{frame}}.png", "--array", f"{k}/{parts}")
            if k <= 12:
                made += files(folder)
                check(all(read(f"{folder}/{file}") == whole[file] for file in files(folder)), f"{folder}: the same files")
            else:
                equal(result.err, f"{folder}/f-{{frame}}.png: no frame in this part\n", "more parts than frames")
        equal(sorted(made), sorted(whole), f"{parts} parts")
    rendered(name, *SMALL, "-o", "p/f-{frame}.png", "--frames", "1-9/2", "--array", "2/2")
    equal(files("p"), ["f-003.png", "f-007.png"], "a part of every second frame")


def started(*words):
    return subprocess.Popen([GRADUS, "render", *words], env=PLAIN, stderr=subprocess.PIPE)


def killed(process):
    process.send_signal(signal.SIGKILL)
    process.communicate()
    return process.returncode


def test_a_killed_run_is_taken_up():
    """A pipe in the place of a frame holds the run where the test wants it: nobody reads from it."""
    words = [scene(), *SMALL]
    rendered(*words, "-o", "whole/f-{frame}.png")
    whole = contents("whole")
    os.mkdir("f")
    os.mkfifo("f/f-009.png")
    run = started(*words, *FRAMES, "-j", "1")
    wait_for(lambda: files("f") == list(whole)[:10])  # nine and the pipe, no file on its way
    equal(killed(run), -signal.SIGKILL, "it was in the middle")
    os.remove("f/f-009.png")
    there = contents()
    equal(there, {name: whole[name] for name in list(whole)[:9]}, "what is there is whole")
    times = {name: os.stat(f"f/{name}").st_mtime_ns for name in there}
    equal(rendered(*words, *FRAMES).err, "f/f-{frame}.png: 12 frames, 9 of them there already\n", "it says what was there")
    equal(contents(), whole, "the same bytes as in one go")
    equal({name: os.stat(f"f/{name}").st_mtime_ns for name in there}, times, "what was there is not touched")
    equal(rendered(*words, *FRAMES).err, "f/f-{frame}.png: 12 frames, 12 of them there already\n", "nothing is left to do")


def test_killed_at_any_moment():
    """Several times, wherever that is: each file that is there is whole, and nothing else is left in the end."""
    words = [FLIGHT, "--size", "48x27", "--frames", "0-29"]
    rendered(*words, "-o", "whole/f-{frame}.png")
    whole = contents("whole")
    for count in (1, 8, 15):
        run = started(*words, *FRAMES, "-j", "2")
        wait_for(lambda: run.poll() is not None or os.path.isdir("f") and len(files("f")) >= count)
        killed(run)
        there = {name: data for name, data in contents().items() if not name.startswith(".")}
        check(there.items() <= whole.items(), f"{len(there)} files, all whole")
    rendered(*words, *FRAMES)
    equal(contents(), whole, "all of them, and no trace of the kills")


def test_what_counts_as_made():
    words = [scene(), *SMALL, *FRAMES]
    rendered(*words)
    whole = contents()
    def made_again(what, count=1):
        match = re.fullmatch(r"f/f-\{frame\}\.png: 12 frames(?:, (\d+) of them there already)?\n", rendered(*words).err)
        equal(12 - int(match[1] or 0), count, what)
        equal(contents(), whole, what)
    made_again("all are there", 0)
    write("f/f-003.png", whole["f-003.png"][:-30])
    made_again("one that was cut off")
    write("f/f-003.png", b"")
    made_again("an empty one")
    write("f/f-003.png", whole["f-004.png"])
    made_again("another frame's")
    rendered(*words[:-2], "--eye", "0,0,9", *FRAMES)
    made_again("made with other flags", 12)
    write("f/f-003.png", whole["f-003.png"].replace(b"fnv1a:", b"fnv1b:"))
    made_again("made of other files")
    write("f/f-003.png", whole["f-003.png"].replace(b"gradus 0.1.0", b"gradus 0.0.9"))
    made_again("made by another release")
    equal(rendered(*words, "--force").err, "f/f-{frame}.png: 12 frames\n", "--force draws all")
    scene(target=[0, 0.1, 0])
    equal(rendered(*words).err, "f/f-{frame}.png: 12 frames\n", "another scene of that name")
    write("f/f-005.png", "mine")
    result = gradus("render", *words)
    equal((result.code, result.err), (2, "gradus: -o: expected a new file or one that gradus made, found 'f/f-005.png' "
                                         "(--force replaces it)\n"), "somebody's own file")
    equal(read("f/f-005.png"), b"mine", "is not touched")
    rendered(*words, "--force")
    check(read("f/f-005.png").startswith(b"\x89PNG"), "--force")


def test_unchanged_frames_are_counted():
    def ledger(*words):
        text = rendered(scene(), *SMALL, "-f", *FRAMES, "--report", *words).out
        rows = re.findall(r"^(\d) \D+?  .*?  +(\d+)  +(\d+)  +(\d+)(?:  (\D.*))?$", text, re.M)
        equal([row[0] for row in rows], list("1234567778"), text)
        for row in rows:
            equal(int(row[2]) + int(row[3]), int(row[1]), text)
            equal(sum(map(int, re.findall(r"\d+", row[4]))), int(row[3]), text)
        return text, {row[0]: [int(n) for n in row[1:4]] for row in rows}
    text, rows = ledger()
    check(text.startswith("s.json, 12 frames of which 3 unchanged: done and left out\n"), text)
    equal(rows["8"], [12 * 64 * 36, 9 * 64 * 36, 3 * 64 * 36], text)
    check("unchanged 36" in text, f"3 frames of 12 faces\n{text}")
    text, rows = ledger("--without", "unchanged")
    check(text.startswith("s.json, 12 frames: done and left out\n") and "unchanged" not in text, text)
    equal(rows["8"], [12 * 64 * 36, 12 * 64 * 36, 0], text)
    text, _ = ledger("--array", "1/2")
    check("6 frames of which 1 unchanged" in text, f"of a part the frame before is its own\n{text}")


def test_explain_tells_of_the_path():
    text = gradus("explain", scene(), *SMALL).out
    equal(text.splitlines()[2], "frame 0 of 0 to 11; unchanged since the one before: 5 to 7", text)
    equal(gradus("explain", "s.json", "--without", "unchanged").out.splitlines()[2], "frame 0 of 0 to 11; every frame is rendered anew", "")
    plan = json.loads(gradus("explain", "s.json", "--frames", "9", "--json").out)
    equal(plan["frames"], {"first": 0, "last": 11, "shown": 9, "unchanged": [5, 6, 7]}, "as JSON")
    check("frames" not in json.loads(gradus("explain", "spot.json", "--json").out), "not where the camera stands still")
    equal(gradus("explain", "s.json", "--frames", "1-2").err, "gradus: --frames: expected one frame like 17 for one picture, found '1-2'\n", "one")
    check(gradus("render", "s.json", "--why", "400,300", "--frames", "9").out.startswith("Pixel 400,300 of s.json"), "why")


def test_a_film():
    name = scene()
    equal(rendered(name, *SMALL, "-o", "a.mp4", "-j1").err, "a.mp4: 12 frames\n", "what was made")
    rendered(name, *SMALL, "-o", "b.mp4", "--without", "unchanged", "-q")
    equal(read("a.mp4"), read("b.mp4"), "the same bytes")
    told = figure_files.probed("a.mp4")["streams"][0]
    equal((told["nb_read_frames"], told["width"], told["height"]), ("12", 64, 36), "its frames")
    equal(rendered(name, *SMALL, "-o", "c.mp4", "--frames", "3-8").err, "c.mp4: 6 frames\n", "a part")


def strip_of(pictures, gap=8):
    """The pictures in a row, as an uncompressed-looking PNG that Picture reads."""
    rows = []
    for y in range(pictures[0].height):
        row = [p for shown in pictures for p in [*shown.pixels[y], *[(255, 255, 255)] * gap]]
        rows.append(row[:-gap])
    raw = b"".join(b"\0" + bytes(c for p in row for c in p[:3]) for row in rows)
    chunk = lambda kind, body: struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def test_the_page_shows_the_flight():
    rendered(FLIGHT, "--size", "256x144", *FRAMES, "--frames", "0-124/31")
    strip = strip_of([Picture(data) for data in contents().values()])
    page = ROOT / "docs/rendering/town_flight.png"
    if "--write" in sys.argv:
        page.write_bytes(strip)
    check(differing(Picture(strip), Picture(read(page))) <= SHARE, "docs/rendering/town_flight.png shows what its command makes")


def test_a_turntable_goes_once_round():
    turn = ["render", "spot.obj", "--size", "60x60", "--target", "0,0.5,0"]
    equal(gradus(*turn, "--eye", "3,1,0", "--turntable", "4", "-o", "t-{frame}.png").err, "t-{frame}.png: 4 frames\n", "a turn")
    # A quarter further each, with the lights of who stands there; from the last frame the next quarter is the first
    for number, eye in enumerate(("3,1,0", "0,1,-3", "-3,1,0", "0,1,3")):
        gradus(*turn, "--eye=" + eye, "-f", "-o", "stands.png")
        one, other = (Picture(pathlib.Path(name).read_bytes()).pixels for name in (f"t-{number:03}.png", "stands.png"))
        off = max(abs(a - b) for left, right in zip(one, other) for p, q in zip(left, right) for a, b in zip(p, q))
        check(off <= 1, f"frame {number} is seen from {eye}: {off} of 255 off")
        check(len({p for row in one for p in row}) > 50, f"frame {number} shows something")
    gradus(*turn, "--eye", "3,1,0", "--turntable", "4", "--frames", "2", "-o", "one.png")
    equal(gradus("again", "one.png", "-o", "again.png").code, 0, "one of them again")
    equal(pathlib.Path("again.png").read_bytes(), pathlib.Path("one.png").read_bytes(), "the same bytes")
    for text in ("0", "10001", "x", "1.5", "-4"):
        result = gradus("render", "spot.obj", f"--turntable={text}", "-o", "x-{frame}.png")
        equal((result.code, result.err), (2, f"gradus: --turntable: expected 1 to 10000 frames, found '{text}'\n"), text)


def test_names_have_as_many_digits_as_the_last_frame():
    write("long.json", json.dumps({"camera": {"target": [0, 0, 0], "path": [{"frame": 7, "eye": [0, 0, 5]}, {"frame": 12345, "eye": [1, 0, 5]}]},
                                   "objects": [{"model": str(MODELS / "letter_f.obj")}]}))
    rendered("long.json", "--size", "4x4", "-o", "{frame}-{frame}.png", "--frames", "7-12345/9999")
    equal(files(), ["00007-00007.png", "10006-10006.png", "long.json"], "five digits, wherever the mark stands")


def test_refusals():
    name = scene()
    beyond = "--frames: expected frames of the path, which has 0 to 11, found "
    spelling = "--frames: expected frames like 0-124, 17 or 0-124/5, found "
    part = "--array: expected one of so many parts like 1/4, counted from 1, found "
    file = "-o: expected a file per frame like f-{frame}.png, or a film like film.mp4, found "
    cases = [
        (["--frames", "0-12", *FRAMES], beyond + "'0-12'"), (["--frames", "12", "-o", "x.png"], beyond + "'12'"),
        *[(["--frames", text, *FRAMES], f"{spelling}'{text}'") for text in ("x", "3-1", "1-", "-3", "1-2-3", "1/0", "1.5", "1000000")],
        *[(["--array", text, *FRAMES], f"{part}'{text}'") for text in ("0/4", "5/4", "4", "1/0", "-1/3", "1/2/3", "a/b")],
        (["--frames", "0-3", "-o", "x.png"], file + "'x.png'"), (["--frames", "0-3", "-o", "-"], file + "'-'"),
        (["-o", "f-{frame}.jpg"], file + "'f-{frame}.jpg'"), (["-o", "{frame}/f.png"], file + "'{frame}/f.png'"),
        (["-o", "x-{frame}.mp4"], file + "'x-{frame}.mp4'"),
        (["-o", "x.mp4", "--array", "1/2"], "--array: expected a file per frame, of which a part can be made, found 'x.mp4'"),
        (["-o", "x.png", "--jobs", "2"], "--jobs: expected several frames, found one picture"),
        (["--jobs", "0", *FRAMES], "--jobs: expected a whole number from 1 to 1024, found '0'"),
        (["-o", "s.json/f-{frame}.png"], "-o: expected a folder, found 's.json'"),
    ]
    for words, message in cases:
        result = gradus("render", name, *SMALL, *words)
        equal((result.code, result.err, result.out), (2, f"gradus: {message}\n", ""), words)
    for other in ("spot.json", "letter_f.obj"):
        for words in (["--frames", "0-3", *FRAMES], ["--frames", "0", "-o", "x.png"], FRAMES, ["-o", "x.mp4"]):
            equal(gradus("render", other, *words).err, f"gradus: --frames: expected a scene whose camera has a path, found '{other}' without one\n", words)
    keys = [{"frame": 0, "eye": [0, 0, 5]}, {"frame": 10, "eye": [0, 0, -5]}]
    scene("through.json", path=keys)
    equal(gradus("render", "through.json", *FRAMES).err,
          "gradus: --frames: expected another point than the eye as the target of every frame, found 0,0,0 as both in frame 5\n", "through the target")
    scene("above.json", path=[{"frame": 0, "eye": [0, 5, 1]}, {"frame": 10, "eye": [0, 5, -1]}], up=[0, 1, 0])
    equal(gradus("render", "above.json", *FRAMES).err,
          "gradus: --frames: expected a direction that is not along the view as what is up in every frame, found 0,1,0 in frame 5, "
          "which looks from 0,5,0 to 0,0,0\n", "from straight above")
    equal(files(), ["above.json", "s.json", "through.json"], "nothing was written")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
