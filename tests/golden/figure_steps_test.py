#!/usr/bin/env python3
"""A run shown step by step: series, handouts, snippets, tables and films, judged by what other programs make of the files.

    tests/golden/figure_steps_test.py [GRADUS] [TEST…]

Exit 77 when one of those programs is missing.
"""
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from command import GRADUS, check, equal
from figure_files import (
    LINE, difference, figure, gradus, main, page_count, page_size, pdf_text, pixels, probed, read, refused, run)


# --- Reveal ----------------------------------------------------------------------------------------------------------


def test_steps():
    gradus("figure", *LINE, "--steps", "auto", "-o", "auto-{step}.svg")
    equal(sorted(os.listdir()), ["auto-0.svg", "auto-3.svg", "auto-4.svg", "auto-7.svg"],
          "the first, an E, an NE, the last")
    figure("--steps", "auto", to="auto.pdf")
    equal(page_count("auto.pdf"), 4, "as pages")
    check("step 4 / 7" in pdf_text("auto.pdf", 3) and "step 7 / 7" in pdf_text("auto.pdf", 4), "these")
    figure("--steps", "1,4,6-7", to="some.pdf")
    equal([re.search(r"step (\d+) / 7", pdf_text("some.pdf", page + 1))[1] for page in range(page_count("some.pdf"))],
          ["1", "4", "6", "7"], "--steps 1,4,6-7")
    figure(to="all.pdf")
    equal(page_count("all.pdf"), 8, "a page per step")


def test_handout():
    sizes = {"a4": (595.28, 841.89), "letter": (612, 792)}
    for paper, (width, height) in sizes.items():
        for grid, a_page in (("2x3", 6), ("1x2", 2), ("4x6", 24)):
            figure("--handout", grid, "--paper", paper, to="h.pdf")
            found = page_size("h.pdf")
            check(abs(found[0] - width) < 0.1 and abs(found[1] - height) < 0.1, f"{paper}: {found}")
            equal(page_count("h.pdf"), math.ceil(8 / a_page), f"pages of {grid}")
            shown = [n for page in range(page_count("h.pdf")) for n in re.findall(r"step (\d) / 7", pdf_text("h.pdf", page + 1))]
            equal(shown, list("01234567"), f"{grid}: every step once, in order")
    check("p = 3 + 2·(3 − 7) = −5." in pdf_text(figure("--handout", "2x3", to="h.pdf"), 1), "with its sentence")
    refused("--handout: expected pdf, found svg", "--handout", "2x3")
    for word in ("0x3", "5x1", "2x7", "2", "x", "axb", "-1x2"):
        refused(f"--handout: expected columns and rows of a page like 2x3, at most 4x6, found '{word}'", f"--handout={word}", to="a.pdf")
    refused("--paper: expected one of a4, letter, found 'a5', did you mean 'a4'?", "--paper", "a5", to="a.pdf")


def shown_files(text):
    """Files that a snippet names, each with its page or nothing."""
    found = re.findall(r"\\includegraphics(?:<\d+>)?\[(?:page=(\d+),)?[^]]*\]\{([^}]*)\}", text)
    found += [("", name) for name in re.findall(r'(?:src)="([^"#]*)', text)]
    found += [(page, name) for name, page in re.findall(r"\(<([^>#]*)(?:#page=(\d+))?>\)", text)]
    return [(name, int(page) if page else None) for page, name in found]


def test_snippets():
    cases = {"beamer": ["pdf", "png", "handout"], "reveal": ["svg", "png", "html", "gif", "mp4", "webp"],
             "markdown": ["svg", "png", "gif", "pdf", "handout"]}
    for kind, endings in cases.items():
        for ending in endings:
            for series in ((False, True) if ending in ("svg", "png", "pdf") else (False,)):
                words = {"handout": ["--handout", "2x3"], "html": []}.get(ending, ["--size", "640x360"])
                name = f"{kind}-{ending}{'-{step}' if series else ''}.{'pdf' if ending == 'handout' else ending}"
                some = [] if ending == "handout" else ["--steps", "auto" if ending != "html" else "0-7"]
                if ending in ("svg", "png") and not series:
                    some = ["--step", "4"]
                result = gradus("figure", *LINE, *words, *some, "-o", name, "--snippet", kind)
                if not equal(result.returncode, 0, f"{kind} of {name}: {result.stderr}"):
                    continue
                shown = shown_files(result.stdout)
                made = [file for file in os.listdir() if re.fullmatch(re.escape(name).replace(r"\{step\}", r"\d+"), file)]
                equal(sorted({file for file, _ in shown}), sorted(made), f"{kind} names the files of {name}")
                if name.endswith(".pdf"):
                    for file in made:
                        equal([page for other, page in shown if other == file], list(range(1, page_count(file) + 1)),
                              f"{kind}: the pages of {file}")
    snippet = gradus("figure", *LINE, "--snippet", "beamer", "-o", "b.pdf").stdout
    equal(len(re.findall(r"includegraphics<\d>", snippet)), 8, "an overlay per step")
    bare = gradus("figure", *LINE, "--snippet", "beamer", "--no-title", "-o", "b.pdf").stdout
    check("\\begin{frame}{Bresenham line" in bare and "\\begin{frame}[plain]" in snippet, "the slide's title where the figure has none")


def test_tables():
    """md, tex and csv hold the cells of the table that `run` prints, and the numbers of its JSON."""
    for about in (LINE, ["bresenham_circle", "--radius", "6"], ["flood_fill", "--method", "depth_first"]):
        markdown = [[cell.strip().replace("\\", "") for cell in line.strip("|").split(" | ")]
                    for line in read(figure(to="t.md", about=about)).decode().splitlines() if line.startswith("|")]
        tex = [[re.sub(r"\$([^$]*)\$", r"\1", cell).strip() for cell in line.removesuffix(" \\\\").split("&")]
               for line in read(figure(to="t.tex", about=about)).decode().splitlines() if "&" in line]
        plain = lambda cell: cell.replace("\u00a0", " ").replace("~", " ").replace("\\", "").replace("−", "-").strip()
        equal([[plain(c) for c in row] for row in tex[1:]], [[plain(c) for c in row] for row in markdown[2:]], f"{about[0]}: tex and md")
        import csv
        import io
        rows = list(csv.reader(io.StringIO(read(figure(to="t.csv", about=about)).decode(), newline="")))
        columns = len(markdown[0])
        equal([[plain(c) for c in row[3:3 + columns]] for row in rows[1:]],
              [[plain(c) for c in row] for row in markdown[2:]], f"{about[0]}: csv and md")
        equal(rows[0][:3] + rows[0][-1:], ["number", "type", "line", "sentence"], "what csv says beside")
        data = json.loads(gradus("run", *about, "--json").stdout)
        steps = {str(step["number"]): (step["type"], str(step["line"])) for step in data["steps"] if "fine" not in step}
        equal({row[0]: (row[1], row[2]) for row in rows[1:]},
              {number: step for number, step in steps.items() if step[0] != "Started" or about[0] != "flood_fill"},
              f"{about[0]}: csv and JSON")
        printed = gradus("run", *about).stdout
        for row in rows[1:]:
            check(row[-1] in printed, f"the table has {row[-1]}")


# --- Moving pictures -------------------------------------------------------------------------------------------------


def webp_frames(path):
    """Loop count, and of each frame its delay in milliseconds; read from the file's chunks."""
    data, at, loop, delays = read(path), 12, None, []
    equal(int.from_bytes(data[4:8], "little") + 8, len(data), f"{path}: whole")
    while at < len(data):
        kind, length = data[at:at + 4], int.from_bytes(data[at + 4:at + 8], "little")
        body = data[at + 8:at + 8 + length]
        if kind == b"VP8X":
            size = (int.from_bytes(body[4:7], "little") + 1, int.from_bytes(body[7:10], "little") + 1)
        if kind == b"ANIM":
            loop = int.from_bytes(body[4:6], "little")
        if kind == b"ANMF":
            delays.append(int.from_bytes(body[12:15], "little"))
        at += 8 + length + length % 2
    return size, loop, delays


def test_films():
    timing = ["--seconds-per-step", "0.5", "--hold-last", "2", "--transition", "none"]
    small = ["--size", "640x360", *timing]
    figure(*small, "--loop", "3", to="a.gif")
    film = probed("a.gif")
    equal((film["streams"][0]["codec_name"], film["streams"][0]["width"], film["streams"][0]["height"]), ("gif", 640, 360), "GIF")
    equal([float(frame["pkt_duration_time"]) for frame in film["frames"]], 7 * [0.5] + [2.0], "a frame per step, the last longer")
    data = read("a.gif")
    at = data.index(b"NETSCAPE2.0")
    equal(int.from_bytes(data[at + 13:at + 15], "little"), 2, "three times: two repetitions")
    forever = read(figure(*small, to="b.gif"))
    equal(forever[forever.index(b"NETSCAPE2.0") + 13:][:2], b"\0\0", "for ever")
    check(b"NETSCAPE2.0" not in read(figure(*small, "--loop", "1", to="c.gif")), "once")
    last = figure("--size", "640x360", "--step", "last", to="last.png")
    run("ffmpeg", "-v", "error", "-i", "a.gif", "-vf", "select=eq(n\\,7)", "-frames:v", "1", "gif-last.png")
    check(difference(pixels(last), pixels("gif-last.png")) < 0.001, "its last frame is the last step")

    figure(*small, "--fps", "30", to="a.mp4")
    film = probed("a.mp4")
    stream = film["streams"][0]
    equal((stream["codec_name"], stream["pix_fmt"], stream["width"], stream["height"], stream["r_frame_rate"]),
          ("h264", "yuv420p", 640, 360, "30/1"), "MP4")
    equal(int(stream["nb_read_frames"]), 7 * 15 + 60, "frames")
    check(abs(float(film["format"]["duration"]) - 5.5) < 0.02, "duration")
    for step in (0, 4, 7):
        seconds = 0.5 * step + 0.25
        run("ffmpeg", "-v", "error", "-y", "-ss", str(seconds), "-i", "a.mp4", "-frames:v", "1", "frame.png")
        figure("--size", "640x360", "--step", str(step), to="step.png")
        share = difference(pixels("step.png"), pixels("frame.png"))
        check(share < 0.01, f"at {seconds} s stands step {step}: {share}")
    figure("--size", "321x241", "--steps", "1-2", *timing, to="odd.mp4")
    stream = probed("odd.mp4")["streams"][0]
    equal((stream["width"], stream["height"]), (322, 242), "even sizes")

    figure(*small, "--loop", "4", "--steps", "1,4-6", to="a.webp")
    equal(webp_frames("a.webp"), ((640, 360), 4, [500, 500, 500, 2000]), "WebP")

    # What moves takes its time from the step before; stills and the whole film last as they would without
    moving = ["--size", "640x360", "--seconds-per-step", "0.5", "--hold-last", "2", "--steps", "0-3"]
    figure(*moving, "--transition", "0.1", to="moving.webp")
    equal(webp_frames("moving.webp")[2], 3 * [400, 50, 50] + [2000], "WebP that moves")
    figure(*moving, "--transition", "0.1", to="moving.gif")
    run("ffmpeg", "-v", "error", "-i", "moving.gif", "-vf", "select=eq(n\\,4)", "-frames:v", "1", "between.png")
    for step in (1, 2):
        figure("--size", "640x360", "--step", str(step), to="step.png")
        check(difference(pixels("step.png"), pixels("between.png")) > 0.001, f"between 1 and 2 stands not {step}")
    figure(*moving, to="moving.mp4")
    for step in (0, 1, 3):
        run("ffmpeg", "-v", "error", "-y", "-ss", str(0.5 * step + 0.1), "-i", "moving.mp4", "-frames:v", "1", "frame.png")
        figure("--size", "640x360", "--step", str(step), to="step.png")
        check(difference(pixels("step.png"), pixels("frame.png")) < 0.01, f"step {step} stands still in a film that moves")
    equal(int(probed("moving.mp4")["streams"][0]["nb_read_frames"]), 3 * 13 + 50, "frames of a film that moves")

    for ending in ("gif", "mp4", "webp"):
        figure(*small, "--steps", "0-3", to=f"one.{ending}")
        figure(*small, "--steps", "0-3", to=f"two.{ending}")
        equal(read(f"one.{ending}"), read(f"two.{ending}"), f"{ending}: the same bytes twice")
    figure(*small, "--steps", "0-1", "--background", "none", to="none.gif")
    equal(pixels("none.gif")[3], 0, "a transparent GIF")


def test_film_values():
    for word in ("0", "0.03", "61", "x", "-1", "1e1", "nan"):
        refused(f"--seconds-per-step: expected seconds from 0.04 to 60, found '{word}'", f"--seconds-per-step={word}", to="a.gif")
    for word in ("0", "601", "inf"):
        refused(f"--hold-last: expected seconds from 0.04 to 600, found '{word}'", f"--hold-last={word}", to="a.gif")
    for word in ("0.03", "11", "soft"):
        refused(f"--transition: expected none, or seconds from 0.04 to 10, found '{word}'", f"--transition={word}", to="a.gif")
    refused("--transition: expected gif, mp4 or webp, found svg", "--transition", "none", to="a.svg")
    for word in ("0", "61", "2.5", ""):
        refused(f"--fps: expected a whole number from 1 to 60, found '{word}'" if word else "--fps: expected N, found none",
                f"--fps={word}", to="a.mp4")
    for word in ("-1", "65536", "x"):
        refused(f"--loop: expected a whole number from 0 to 65535, found '{word}'", f"--loop={word}", to="a.gif")
    refused("--fps: expected mp4, found gif", "--fps", "30", to="a.gif")
    refused("--loop: expected gif or webp, found mp4", "--loop", "2", to="a.mp4")
    refused("--seconds-per-step: expected gif, mp4 or webp, found png", "--seconds-per-step", "2", to="a.png")
    refused(re.compile(r"gradus: --seconds-per-step: expected at least one frame, 1/5 s at --fps 5, found 0.1\n"),
            "--seconds-per-step", "0.1", "--fps", "5", to="a.mp4")


def test_films_without_ffmpeg():
    os.mkdir("bin")
    for ending in ("gif", "mp4", "webp"):
        result = gradus("figure", *LINE, "-o", f"a.{ending}", env={**os.environ, "PATH": os.path.abspath("bin")})
        equal((result.returncode, result.stderr),
              (1, "gradus: film: expected the program ffmpeg on the PATH (Debian: apt install ffmpeg), found none\n"), ending)
    # One that stops early and calls it success; one that fails
    for script, words in (("exec head -c 1000 > /dev/null", "expected"), ("echo broken codec >&2; exit 3", "broken codec")):
        with open("bin/ffmpeg", "w") as file:
            file.write(f"#!/bin/sh\nPATH={os.environ['PATH']}\n{script}\n")
        os.chmod("bin/ffmpeg", 0o755)
        result = gradus("figure", *LINE, "-o", "a.mp4", env={**os.environ, "PATH": os.path.abspath("bin")})
        check(result.returncode == 1 and result.stderr.startswith("gradus: film: ") and words in result.stderr
              and result.stderr.count("\n") == 1, f"{script}: {result.returncode} {result.stderr!r}")
    equal(sorted(os.listdir()), ["bin"], "no half-written film")


def test_films_interrupted():
    for ending in ("gif", "mp4", "webp"):
        process = subprocess.Popen([GRADUS, "figure", "bresenham_line", "--to", "3000,7", "--steps", "0-3000", "-o", f"i.{ending}"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(0.7)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=30)
        equal(process.returncode, 130, f"Ctrl-C in a {ending}")
        equal(os.listdir(), [], "nothing is left")


if __name__ == "__main__":
    sys.exit(main(globals()))
