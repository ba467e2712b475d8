"""Small inputs that ask for large work: refused before it begins, done in proportion, or shown while they last.

Usage: limits_test.py [path of gradus]        (default: $GRADUS_COMMAND)
"""
import json
import math
import os
import pathlib
import random
import re
import resource
import subprocess
import sys
import threading
import time
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, PLAIN, check, equal, files, gradus, on_terminal, read, write

MIB = 1 << 10  # in the units of ru_maxrss


def measured(*words):
    """Exit code, stderr, and what the process took: seconds of user time, the most memory in KiB."""
    with open("stderr", "wb") as err:
        process = subprocess.Popen([GRADUS, *words], stdout=subprocess.DEVNULL, stderr=err, env=PLAIN)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, read("stderr").decode(), used.ru_utime, used.ru_maxrss


def blank_png(side):
    """One colour, one bit per pixel: a 16384th of a byte each."""
    def chunk(kind, data):
        return len(data).to_bytes(4, "big") + kind + data + zlib.crc32(kind + data).to_bytes(4, "big")
    packer, row = zlib.compressobj(9), bytes(1 + (side + 7) // 8)
    rows = b"".join(packer.compress(row) for _ in range(side)) + packer.flush()
    header = side.to_bytes(4, "big") * 2 + bytes([1, 0, 0, 0, 0])
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


# --- Pictures --------------------------------------------------------------------------------------------------------


def test_a_picture_of_too_many_pixels():
    write("big.png", blank_png(16384))
    check(os.path.getsize("big.png") < 40_000, "a small file")
    for words in (["figure", "flood_fill", "--steps", "0", "-o", "a.svg"], ["run", "flood_fill"]):
        code, err, seconds, memory = measured(*words, "--image", "big.png")
        equal((code, err), (2, "gradus: --image: 'big.png': expected at most 67108864 pixels, found 16384 x 16384\n"), f"{words}")
        check(seconds < 10 and memory < 200 * MIB, f"before any work: {seconds} s, {memory} KiB")
    check(not os.path.exists("a.svg"), "no file")


def test_what_is_not_recorded_costs_little():
    write("large.png", blank_png(2048))
    fill = ["--image", "large.png", "--method", "depth_first", "-q"]
    code, err, counted, memory = measured("figure", "flood_fill", *fill, "--steps", "0", "-o", "a.svg")
    equal((code, err), (0, ""), "the input of a large fill")
    # The pixels by themselves: a byte of the recording's canvas each, and four for each copy of the picture
    check(memory < 300 * MIB, f"few copies of the picture: {memory} KiB")
    # In the same run as its rival: a fill of a twentieth as many pixels, nearly all of whose events are recorded
    write("small.png", blank_png(458))
    rival = [*fill]
    rival[1] = "small.png"
    _, _, told, _ = measured("figure", "flood_fill", *rival, "--steps", "0", "-o", "b.svg")
    print(f"flood_fill --steps 0 by depth first: {told:.2f} s for 458², {counted:.2f} s for 2048²")
    check(counted < 2.5 * told, f"events that nobody sees are only counted: {told:.2f} s, then {counted:.2f} s")


# --- Files and frames ------------------------------------------------------------------------------------------------


def test_a_series_of_too_many_files():
    line = ["figure", "bresenham_line", "--to", "2147483647,3", "-o", "a-{step}.png"]
    code, err, seconds, _ = measured(*line)
    equal((code, err), (2, "gradus: -o: expected at most 1000 files, found 2147483648 steps (--steps 0-2147483647/2147484 takes "
                        "some of them, --steps A-B up to 100000)\n"), "two thousand million")
    check(seconds < 10, f"soon: {seconds} s")
    equal(measured(*line, "--steps", "0-2147483647")[:2],
          (2, "gradus: --steps: expected at most 100000 files, found 2147483648\n"), "asked for")
    equal(measured(*line, "--steps", "0-2147483647/2147484", "--step", "1")[0], 2, "no two of them")
    equal(files(), ["stderr"], "no file is begun")
    equal(gradus("figure", "bresenham_line", "--to", "1000,3", "-o", "a-{step}.svg").code, 2, "1001")
    equal(gradus("figure", "bresenham_line", "--to", "1000,3", "-o", "a-{step}.svg", "--steps", "0-1000/500").code, 0, "some")
    equal(files(), ["a-0.svg", "a-1000.svg", "a-500.svg", "stderr"], "what was asked for")


def test_a_film_of_too_many_frames():
    circle = ["figure", "bresenham_circle", "--radius", "3000", "-o", "a.gif"]
    code, err, seconds, _ = measured(*circle)
    equal(code, 2, "a frame for each of 2000 steps")
    found = re.fullmatch(r"gradus: -o: expected at most 1000 frames, found (\d+) steps \(--steps 0-(\d+)/(\d+) takes some of "
                         r"them, --steps A-B up to 10000\)\n", err)
    if check(found, err):
        steps, last, stride = map(int, found.groups())
        check(steps == last + 1 > 1000 and last // stride + 1 <= 1000, f"what it offers is taken: {err}")
    check(seconds < 10, f"soon: {seconds} s")
    equal(measured("figure", "bresenham_line", "--to", "20000,3", "-o", "a.mp4", "--steps", "0-20000")[:2],
          (2, "gradus: --steps: expected at most 10000 frames, found 20001\n"), "asked for")
    equal(files(), ["stderr"], "no file")
    equal(gradus(*circle, "--steps", "0-2100/1050", "--size", "320x180").code, 0, "some of them")


def test_a_film_of_frames_too_large():
    for name in ("a.gif", "a.mp4", "a.webp"):
        equal(measured("figure", "bresenham_line", "-o", name, "--size", "8192x8192")[:2],
              (2, "gradus: -o: expected frames of at most 8294400 pixels, as 3840 x 2160 has, for a film (--size, --scale), "
                  "found 8192 x 8192\n"), name)
    equal(measured("figure", "bresenham_line", "-o", "a.gif", "--scale", "4")[0], 2, "by --scale")
    equal(files(), ["stderr"], "no file")


def test_a_page_of_too_many_steps():
    line = ["figure", "bresenham_line", "--to", "30000,5", "-o", "a.html"]
    equal(measured(*line)[:2],
          (2, "gradus: -o: expected at most 4000 steps for a page, found 30001 (--steps 0-3999 takes the first of them, "
              "--steps A-B up to 20000)\n"), "30,001 steps")
    equal(measured(*line, "--steps", "1-20001")[:2],
          (2, "gradus: --steps: expected at most 20000 for a page, found 20001\n"), "asked for")
    equal(files(), ["stderr"], "no file")
    equal(gradus(*line, "--steps", "0-3999").code, 0, "the first of them")
    check(os.path.getsize("a.html") < 10e6, f"{os.path.getsize('a.html')} bytes")


def test_lectures_have_the_same_limits():
    for output, keys, expected in (("gif", {"input": {}, "size": "8192x8192"}, "8294400 pixels"),
                                   ("html", {"input": {"to": "30000,5"}}, "at most 4000 steps for a page"),
                                   ("html", {"input": {"to": "30000,5"}, "steps": "0,25000"}, "at most 20000 for a page")):
        write("a.json", json.dumps({"outputs": [output], "figures": [{"topic": "bresenham_line", **keys}]}))
        for words in (["--check"], ["-o", "out"]):
            code, err, _, _ = measured("figures", "a.json", *words)
            check(code == 2 and expected in err and err.startswith("gradus: a.json"), f"{output} {words}: {code} {err}")


def test_few_files_may_be_open():
    few = lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (12, 12))
    ran = subprocess.run([GRADUS, "figure", "bresenham_line", "-o", "a.gif"], preexec_fn=few, env=PLAIN, capture_output=True)
    equal((ran.returncode, ran.stderr.decode()), (1, "gradus: film: can't open a file: Too many open files\n"), "of 12")
    equal(files(), [], "no file")


def test_help_states_the_limits():
    text = gradus("figure", "--help").out
    for limit in ("1000 pages", "1000 frames", "1000 files", "10000", "100000", "4000 steps", "8294400 pixels"):
        check(limit in text, f"{limit} in figure --help")
    check("67108864 pixels" in gradus("help", "flood_fill").out, "pixels in help flood_fill")


# --- Lectures of many figures ----------------------------------------------------------------------------------------


def lecture(count, **keys):
    return json.dumps({"outputs": ["csv"], "figures": [
        {"topic": "bresenham_line", "input": {"to": f"5,{i % 6}"}, **keys} for i in range(count)]})


def test_figures_take_time_in_proportion():
    times = {}
    for count in (250, 1000):
        write(f"{count}.json", lecture(count))
        code, err, times[count], _ = measured("figures", f"{count}.json", "-o", f"out{count}", "-q")
        equal((code, err), (0, ""), f"{count} figures")
    print(f"gradus figures: {times[250]:.2f} s of user time for 250 figures, {times[1000]:.2f} s for 1000")
    check(times[1000] < 8 * times[250], f"four times as many are no sixteen times the work: {times}")
    for count in (1250, 5000):
        write(f"{count}.json", lecture(count, steps="0"))
        code, err, times[count], _ = measured("figures", f"{count}.json", "--check")
        equal(code, 0, f"{count} figures without names: {err[:200]}")
    print(f"gradus figures --check: {times[1250]:.2f} s for 1250 figures without names, {times[5000]:.2f} s for 5000")
    check(times[5000] < 8 * times[1250], f"giving names, too: {times}")


def test_a_face_of_many_corners():
    """A walk round the ring for each of its ears would be sixteen times the work for four times the corners."""
    times = {}
    for corners in (25_000, 100_000):
        turns = [2 * math.pi * i / corners for i in range(corners)]
        ring = "".join(f"v {math.cos(a)} {math.sin(a)} 0\n" for a in turns)
        write("m.obj", ring + "f " + " ".join(map(str, range(1, corners + 1))) + "\n")
        code, err, times[corners], _ = measured("render", "m.obj", "--size", "32x24", "--aa", "none", "-o", "m.png")
        equal((code, err), (0, "m.png\n"), f"a face of {corners} corners")
    print(f"gradus render of a face: {times[25_000]:.2f} s of user time for 25,000 corners, {times[100_000]:.2f} s for 100,000")
    check(times[100_000] < 8 * times[25_000], f"in proportion: {times}")


def crossing(count, numbers):
    """Triangles anywhere in a cube."""
    corners = "".join("v %.6f %.6f %.6f\n" % tuple(numbers.uniform(-1, 1) for _ in range(3)) for _ in range(3 * count))
    return corners + "".join(f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}\n" for i in range(count))


def test_an_a_buffer_of_what_crosses_everywhere():
    """Where all of a pixel's fragments were put in order, those that are hidden, too, 2000 took 20 s."""
    times = {}
    for count in (500, 2000):
        write("m.obj", crossing(count, random.Random(7)))
        code, err, times[count], _ = measured("render", "m.obj", "--size", "64x64", "--culling", "none", "--aa", "a_buffer", "-o", "m.png")
        equal((code, err), (0, "m.png\n"), f"{count} triangles")
    print(f"a_buffer of crossing triangles: {times[500]:.2f} s of user time for 500, {times[2000]:.2f} s for 2000")
    check(times[2000] < 3, f"soon: {times}")


def test_orders_of_what_crosses_everywhere():
    """Where the painter sorted its list after each cut, and each cut took 30 us: 3 s for 250, and 6 s up to the refusals."""
    numbers = random.Random(7)
    for count in (250, 2000):
        write(f"{count}.obj", crossing(count, numbers))
    town = pathlib.Path(__file__).resolve().parents[2] / "examples/scenes/town.json"
    for method in ("painter", "bsp_tree"):
        for model in ("250.obj", "2000.obj", town):
            line = ["render", str(model), "--size", "64x64", "--culling", "none", "--hidden-surfaces", method, "-o", "m.png"]
            code, err, time, memory = measured(*line)
            print(f"{method} of {pathlib.Path(model).name}: exit {code}, {time:.2f} s of user time, {memory >> 10} MiB")
            if model == "250.obj":
                equal((code, err), (0, "m.png\n"), "drawn")
                check(time < 5, f"in {time} s")
            elif code == 2:
                check("z_buffer needs no order, and draws the same" in err, f"names the way out: {err}")
            check(time < 15 and memory < 500 * MIB, f"soon: {time} s, {memory} KiB")


def test_a_stopped_run_of_figures_is_not_done_again():
    write("many.json", lecture(1600))
    process = subprocess.Popen([GRADUS, "figures", "many.json", "-o", "out", "-q", "-j", "1"], env=PLAIN)
    command.wait_for(lambda: os.path.exists("out/bresenham_line_300/bresenham_line_300.csv"))
    time.sleep(0.5)
    process.kill()
    process.wait()
    drawn = int(re.search(r"(\d+) drawn", gradus("figures", "many.json", "-o", "out").err)[1])
    check(0 < drawn < 1600, f"{drawn} of 1600 were left to do")


# --- Bars ------------------------------------------------------------------------------------------------------------


def test_bars_of_pages_and_frames():
    between = 7 * 6  # 8 steps; GIF draws these twice, and films their first picture once more
    for name, count in (("a.pdf", 8), ("a.gif", 17 + between), ("a.webp", 9 + between), ("{step}.svg", 8)):
        text, code = on_terminal("figure", "bresenham_line", "-o", name, "--size", "320x180")
        check(code == 0 and f"[########################] {count}/{count}" in text, f"{name}: {text[-300:]!r}")
        shown = text.split("\r\x1b[K")
        check(all(part == "" or part[0] == "[" for part in shown[:-1]), f"{name}: nothing but the bar: {shown}")
        equal(on_terminal("-q", "figure", "bresenham_line", "-o", name)[0], "", f"{name}: -q")
    equal(gradus("figure", "bresenham_line", "-o", "b.pdf").err, "b.pdf\n", "no bar but on a terminal")


def late_maze(*words, **options):
    """A run on a terminal that gets its maze after two seconds."""
    end, begin = os.pipe()

    def send():
        time.sleep(2)
        os.write(begin, b"###\n#.#\n###\n")
        os.close(begin)
    threading.Thread(target=send).start()
    with os.fdopen(end, "rb") as maze:
        return on_terminal(*words, "flood_fill", "--maze", "-", stdin=maze, **options)


def left_on_screen(text):
    """The lines that a terminal shows in the end: a line can be erased while the cursor is in it."""
    return [line.rsplit("\r\x1b[K", 1)[-1] for line in text.replace("\r\n", "\n").split("\n")]


def test_long_work_is_shown():
    text, code = late_maze("figure", "-o", "a.svg")
    check(code == 0 and re.search(r"\[\.*######\.*\] figure flood_fill, 1 s", text), f"a second of work: {text!r}")
    equal(left_on_screen(text), ["a.svg", ""], "gone when it is done")
    text, code = late_maze("run", "--color", "never", "--width", "1000")
    check(re.search(r"\[\.*######\.*\] run flood_fill, 1 s", text), f"a table: {text!r}")
    equal(left_on_screen(text), gradus("run", "flood_fill", "--maze", "###/#.#/###", "--width", "1000").out.split("\n"), "and nothing else")
    equal(late_maze("figure", "-q", "-o", "b.svg")[0], "", "-q")
    check("\x1b" not in late_maze("figure", "-o", "c.svg", env={"TERM": "dumb"})[0], "a dumb terminal")
    begin = time.monotonic()
    text = on_terminal("figure", "bresenham_line", "-o", "d.svg")[0]
    check("\x1b" not in text or time.monotonic() - begin > 1, "nothing within a second")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
