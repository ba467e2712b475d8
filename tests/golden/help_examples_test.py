#!/usr/bin/env python3
"""Every example of every help page, pasted as it stands into bash: from the build, and from an installed prefix.

    tests/golden/help_examples_test.py [GRADUS]

Pages with a topic of their own (`gradus run TOPIC --help`) are tried from the build alone.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, PLAIN, check, equal
from renders import fewer_frames
from share import EVERYTHING, share_of

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("GRADUS_BINARY_DIR", pathlib.Path(GRADUS).parent))
LECTURE = """{"title": "Mine", "figures": [{"topic": "bresenham_line", "input": {"to": "5,2"}, "outputs": ["svg"]},
 {"topic": "bresenham_circle", "input": {"radius": "4"}, "outputs": ["svg"]}]}"""
# What would take long is asked for less: the words stay those of the page
SHORTER = {"bench": " --seconds 0.0005 --repetitions 1", "stress": " --seconds 1", "figures": " --only bresenham_line",
           "demo": " --data short.json"}
SMALLER = re.compile(r"\.gif|\.mp4|\.webp|\{step\}\.png")  # many pictures


def png(width, height):
    def chunk(kind, data):
        return len(data).to_bytes(4, "big") + kind + data + zlib.crc32(kind + data).to_bytes(4, "big")
    rows = b"".join(b"\0" + bytes(200 if x > 20 else 10 for x in range(width)) for _ in range(height))
    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([8, 0, 0, 0, 0])
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


class Place:
    """A folder with what the examples name as the reader's own, and programs that stand for browsers."""

    def __init__(self, gradus):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="gradus_examples_"))
        (self.folder / "photo.png").write_bytes(png(60, 50))
        (self.folder / "my_lecture.json").write_text(LECTURE)
        (self.folder / "names.txt").write_text("Ada Lovelace\nZoë\n")
        data = json.loads((ROOT / "examples/demos/pyramid_demo.json").read_text())
        (self.folder / "short.json").write_text(json.dumps({**data, "k_duration": 1, "k_fps": 3}))
        bin = self.folder / ".bin"
        bin.mkdir()
        for name in ("xdg-open", "firefox"):
            (bin / name).write_text(f'#!/bin/sh\necho "$1" > "{self.folder}/.opened"\n')
            (bin / name).chmod(0o755)
        self.env = {**PLAIN, "PATH": f"{gradus.parent}:{bin}:{os.environ['PATH']}", "HOME": str(self.folder)}
        self.env.pop("BROWSER", None)

    def run(self, line, timeout=600):
        return subprocess.run(["bash", "-c", line], cwd=self.folder, env=self.env, capture_output=True, text=True, timeout=timeout)

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)


def shorter(line):
    name = re.search(r"\bgradus (\w+)", line)
    if name and name[1] == "render":
        return fewer_frames(line)
    extra = SHORTER.get(name[1] if name else "")
    if name and name[1] == "figure" and SMALLER.search(line) and "--size" not in line:
        extra = " --size 320x180"
    if not extra or "--only" in line or "lecture.json" in line or "--from" in line:
        return line
    line = re.sub(r" --seconds \S+", "", line)
    if re.fullmatch(r"gradus bench( -.*)?", line):
        line = line.replace("gradus bench", "gradus bench bresenham_circle")
    return re.sub(r"(\s+[>#].*)?$", lambda m: extra + (m[0] or ""), line, count=1)


def examples_in(page):
    part = page.split("\nExamples\n", 1)[1].split("\n\n", 1)[0]
    return [line.strip() for line in part.splitlines()]


def try_page(gradus, words):
    """(how many examples, what is wrong with them)"""
    place = Place(gradus)
    wrong = []
    try:
        page = place.run(f"gradus {words}").stdout
        lines = examples_in(page)
        if "again" in words:
            place.run("gradus figure bresenham_line -o line.svg")
        if "open" in words:
            place.run("gradus figures -o out --only bresenham_line; gradus figures my_lecture.json -o my_lecture")
        for line in lines:
            rival = re.search(r"\bgradus (bench|stress)\b", line)
            if rival and not (gradus.parent / f"gradus-{rival[1]}").exists():
                done = place.run(line)
                if done.returncode != 1 or f"`./bootstrap {rival[1]}` builds" not in done.stderr:
                    wrong.append(f"{line}: without gradus-{rival[1]}: {done.returncode} {done.stderr!r}")
                continue
            done = place.run(shorter(line))
            if done.returncode != 0 or "gradus:" in done.stderr:
                wrong.append(f"gradus {words}: {line}\n    {done.returncode} {done.stderr.strip()}")
            written = re.search(r" (?:-o|>) ?'?([\w./{}-]+)", line)
            if written and written[1] != "-":
                if not list(place.folder.glob(re.sub(r"\{(step|frame)\}", "*", written[1]))):
                    wrong.append(f"gradus {words}: {line}\n    nothing was written as {written[1]}")
            if "gradus open" in line:
                opened = place.folder / ".opened"
                page = opened.read_text().strip() if opened.exists() else "none"
                expected = "my_lecture" if "my_lecture" in line else "out"
                if page != f"file://{place.folder}/{expected}/index.html":
                    wrong.append(f"{line}: {page} was opened")
                opened.unlink(missing_ok=True)
        return len(lines), wrong
    except Exception as error:  # one broken page must not hide the others
        return 0, [f"gradus {words}: {type(error).__name__}: {error}"]
    finally:
        place.close()


def commands_and_topics(gradus):
    page = subprocess.run([gradus, "help"], capture_output=True, text=True).stdout
    part = page.split("\nCommands\n", 1)[1].split("\n\n", 1)[0]
    names = re.findall(r"^  (\w+)  ", part, re.M)
    topics = re.findall(r"^  (\w+)  ", subprocess.run([gradus, "list"], capture_output=True, text=True).stdout, re.M)
    return names, topics


def try_pages(gradus, pages, least):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda words: try_page(gradus, words), pages))
    for count, wrong in results:
        for problem in wrong:
            check(False, problem)
    count = sum(count for count, _ in results)
    print(f"{len(pages)} pages, {count} examples run by {gradus}")
    check(count >= least, f"examples tried: {count}")


def main_pages(gradus):
    names, topics = commands_and_topics(gradus)
    check(len(names) >= 12 and len(topics) >= 16, f"{names} {topics}")
    return ["--help"] + [f"{name} --help" for name in names] + [f"help {topic}" for topic in topics], topics


def test_from_the_build():
    gradus = pathlib.Path(GRADUS)
    pages, topics = main_pages(gradus)
    pages += [f"{name} {topic} --help" for name in ("run", "figure") for topic in topics]
    try_pages(gradus, share_of(pages, 3), 280 if EVERYTHING else 70)


def test_from_an_installed_prefix():
    prefix = pathlib.Path(os.getcwd()) / "prefix with blank"
    # Without gradus-bench and gradus-stress: what the command then says is looked at
    done = subprocess.run(["cmake", "--install", str(BUILD), "--component", "command", "--prefix", str(prefix)],
                          capture_output=True, text=True)
    equal(done.returncode, 0, f"installing: {done.stderr}")
    gradus = prefix / "bin" / "gradus"
    check(bool(gradus.stat().st_mode & stat.S_IXUSR), "the program is installed")
    pages, _ = main_pages(gradus)
    try_pages(gradus, share_of(pages, 8), 110 if EVERYTHING else 10)


sys.exit(command.run_all(globals()))
