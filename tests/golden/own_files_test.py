"""Whose files are replaced, followed and removed: what Gradus did not make stays, what it left half-made goes.

Usage: own_files_test.py [path of gradus]        (default: $GRADUS_COMMAND)
"""
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, PLAIN, check, equal, files, gradus, png, read, wait_for, write

MODELS = pathlib.Path(__file__).resolve().parents[2] / "examples/models"
LINE = ["figure", "bresenham_line", "--to", "3,1"]
MINE = b"<!DOCTYPE html><title>mine</title>"


def refusal(path, what="-o"):
    return f"gradus: {what}: expected a new file or one that gradus made, found '{path}' (--force replaces it)\n"


def lecture(path, *figures, **keys):
    figure = {"topic": "bresenham_line", "name": "line", "outputs": ["svg", "csv"], "input": {"to": "3,1"}}
    write(path, json.dumps({"figures": [{**figure, **other} for other in figures or ({},)], **keys}))


def contents(folder="."):
    return {name: read(os.path.join(folder, name)) for name in files(folder)}


# --- Whose file is it ------------------------------------------------------------------------------------------------


def test_figures_leave_somebodys_page():
    lecture("own.json")
    os.mkdir("own")
    write("own/index.html", MINE)
    for folder, page in (("own", "own/index.html"), ("own/", "own/index.html"), (".", "./index.html")):
        if folder == ".":
            write("index.html", MINE)
        before = contents()
        result = gradus("figures", "own.json", "-o", folder)
        equal((result.code, result.out, result.err), (2, "", refusal(page)), f"-o {folder}")
        equal(contents(), before, "before anything is drawn")
    result = gradus("figures", "own.json", "-o", "own", "--force")
    equal((result.code, result.out), (0, "own/index.html\n"), "--force")
    check(read("own/index.html") != MINE and os.path.exists("own/line/line.svg"), "replaced")
    write("own/index.html", MINE)
    equal(gradus("figures", "own.json", "-o", "own").err, refusal("own/index.html"), "a page that came later")
    equal(read("own/index.html"), MINE, "and stays")


def test_figures_leave_the_other_pages():
    lecture("own.json")
    page = "topics/scan_conversion/bresenham_line.html"
    os.makedirs("own/topics/scan_conversion")
    write(f"own/{page}", MINE)
    equal(gradus("figures", "own.json", "-o", "own").err, refusal(f"own/{page}"), "a topic's page")
    os.mkdir("out")
    write("out/errata.html", MINE)
    equal(gradus("figures", "--only", "bresenham_line").err, refusal("out/errata.html"), "the page of errata")
    equal([read("out/errata.html"), read(f"own/{page}")], [MINE, MINE], "both stay")


def test_figures_leave_somebodys_zip():
    lecture("own.json")
    write("own.zip", b"PK\5\6" + bytes(18))
    before = contents()
    result = gradus("figures", "own.json", "-o", "own", "--zip")
    equal((result.code, result.out, result.err), (2, "", refusal(os.path.abspath("own.zip"), "--zip")), "--zip")
    equal(contents(), before, "not even a folder is made")
    equal(gradus("figures", "own.json", "-o", "own", "--zip", "--force").code, 0, "--force")
    with zipfile.ZipFile("own.zip") as packed:
        check(packed.comment.startswith(b"Made by Gradus ") and packed.testzip() is None, f"a mark: {packed.comment}")
        check("index.html" in packed.namelist(), "a whole zip")
    equal(gradus("figures", "own.json", "-o", "own", "--zip").code, 0, "its own zip is replaced")


def test_figures_leave_somebodys_figure():
    lecture("own.json", {}, {"name": "other"})
    os.makedirs("own/line")
    write("own/line/line.csv", "x,y\n1,2\n")
    write("own/line/notes.txt", "kept")
    result = gradus("figures", "own.json", "-o", "own")
    equal((result.code, result.out), (2, ""), "a figure's folder")
    check("gradus: own.json:1: figures[0]: -o: expected a new file or one that gradus made, found 'own/line/line.csv' "
          "(--force replaces it)\n" in result.err, result.err)
    check(result.err.endswith("1 drawn, 0 unchanged, 0 removed\n") and os.path.exists("own/other/other.svg"),
          "the others are drawn")
    equal(files("own/line"), ["line.csv", "notes.txt"], "and nothing beside it")
    equal(gradus("figures", "own.json", "-o", "own", "--force").code, 0, "--force")
    equal(files("own/line"), ["line-drawing.svg", "line.csv", "line.svg", "notes.txt"], "all of it")


def test_what_gradus_made_is_known_without_its_manifest():
    for name in ("letter_f.obj", "letter_f.mtl"):
        shutil.copy(MODELS / name, name)
    write("photo.png", png(20, 20, lambda x, y: 7 * x))
    every = ["svg", "png", "pdf", "html", "csv", "md", "tex", "json", "txt", "gif"]
    lecture("own.json", {"outputs": every}, {"topic": "flood_fill", "name": "fill", "input": {"image": "photo.png"}},
            renders=[{"model": "letter_f.obj", "size": "64x48"}])
    equal(gradus("figures", "own.json", "-o", "own", "-q").code, 0, "the first time")
    before = contents("own")
    os.remove("own/.gradus-manifest.json")
    result = gradus("figures", "own.json", "-o", "own", "-q")
    equal((result.code, result.err), (0, ""), "without the manifest")
    after = contents("own")
    equal({n: b for n, b in after.items() if n[0] != "."}, {n: b for n, b in before.items() if n[0] != "."}, "the same bytes")
    lecture("own.json", {"outputs": every, "input": {"to": "4,1"}}, {"topic": "flood_fill", "name": "fill", "input": {"image": "photo.png"}})
    os.remove("own/.gradus-manifest.json")
    result = gradus("figures", "own.json", "-o", "own", "-q")
    equal((result.code, result.err), (0, ""), "other bytes, without the manifest")
    check(all(read(f"own/line/line.{e}") != before[f"line/line.{e}"] for e in every), "all of them new")


def test_a_named_file_is_replaced_when_gradus_made_it():
    for ending in ("svg", "png", "pdf", "html", "csv", "md", "tex", "json", "txt", "gif", "mp4", "webp", "pptx"):
        name = f"a.{ending}"
        small = ("--size", "320x180") if ending in ("gif", "mp4", "webp") else ()
        for to in ("3,1", "3,2"):
            equal(gradus("figure", "bresenham_line", *small, "--to", to, "-o", name).code, 0, f"{name} to {to}")
        equal(gradus(*LINE, *small, "-o", "-", "--format", ending).bytes == read(name), False, f"{name} is the second one")
        write(name, "mine")
        result = gradus(*LINE, *small, "-o", name)
        equal((result.code, result.out, result.err, read(name)), (2, "", refusal(name), b"mine"), f"somebody's {name}")
        equal(gradus(*LINE, *small, "-o", name, "--force").code, 0, "--force")
        equal(read(name), gradus(*LINE, *small, "-o", "-", "--format", ending).bytes, "replaced")
    for ending in ("obj", "ply", "stl"):
        cut = ("figure", "ear_clipping", "-o", f"cut.{ending}")
        equal([gradus(*cut).code, gradus(*cut, "--polygon", "0,0 4,0 4,3").code], [0, 0], f"a surface as {ending}")
        write(f"cut.{ending}", "mine")
        equal(gradus(*cut).err, refusal(f"cut.{ending}"), f"somebody's {ending}")
    write("empty.svg", "")
    equal(gradus(*LINE, "-o", "empty.svg").code, 0, "an empty file holds nobody's work")
    equal(gradus(*LINE, "-o", "/dev/null", "--format", "svg").code, 0, "a device")


def test_a_file_that_holds_a_figure_is_not_one():
    gradus(*LINE, "-o", "line.svg")
    gradus(*LINE, "-o", "line.html")
    gradus(*LINE, "-o", "line.md")
    figure = read("line.svg").decode().split("?>", 1)[1]
    page = read("line.html").decode()
    holders = {
        "deck.html": f"<!DOCTYPE html><html><head><title>My slides</title></head><body>{figure}</body></html>",
        "frame.html": f"<!DOCTYPE html><html><head><title>My slides</title></head><body><iframe srcdoc='{page}'></iframe></body></html>",
        "drawing.svg": f"<svg xmlns='http://www.w3.org/2000/svg'><g>{figure}</g></svg>",
        "edited.svg": read("line.svg").decode().replace("<title", "<g id='layer1'/><title", 1),
        "notes.md": "# My notes\n\n" + read("line.md").decode(),
        "thesis.tex": "\\documentclass{article}\n% gradus figure bresenham_line\n",
        "list.txt": "gradus figure bresenham_line -o a.svg\ngradus figure bresenham_line -o b.svg\n",
    }
    for name, text in holders.items():
        write(name, text)
        result = gradus(*LINE, "-o", name)
        equal((result.code, result.err, read(name)), (2, refusal(name), text.encode()), name)


def test_names_that_gradus_makes_up():
    gradus(*LINE, "-o", "line.svg")
    write("line-again.svg", "mine")
    result = gradus("again", "line.svg")
    equal((result.code, result.err, read("line-again.svg")), (2, refusal("line-again.svg"), b"mine"), "again")
    equal(gradus("again", "line.svg", "-f").code, 0, "again -f")
    equal(read("line-again.svg"), read("line.svg"), "again -f replaces")
    write("2.png", png(4, 4, lambda x, y: 9))
    photo = read("2.png")
    result = gradus(*LINE, "-o", "{step}.png")
    equal((result.code, result.err, read("2.png")), (2, refusal("2.png"), photo), "a photo among the numbers of a series")
    equal([n for n in files() if n.endswith(".png")], ["2.png"], "before anything is drawn")
    shutil.copy("2.png", "view.png")
    render = ["render", str(MODELS / "letter_f.obj"), "--size", "64x48", "-o", "view.png"]
    equal((gradus(*render).err, read("view.png")), (refusal("view.png"), photo), "render")
    equal(gradus(*render, "--force").code, 0, "render --force")
    equal(gradus(*render).code, 0, "render over a render")


def test_links_are_followed_alike():
    os.mkdir("elsewhere")
    os.symlink("elsewhere/new.svg", "dangling.svg")
    equal(gradus(*LINE, "-o", "dangling.svg").code, 0, "a link to what is not there yet")
    check(os.path.islink("dangling.svg") and read("elsewhere/new.svg").startswith(b"<?xml"), "followed")
    equal(gradus(*LINE, "--theme", "dark", "-o", "dangling.svg").code, 0, "a link to a figure")
    check(os.path.islink("dangling.svg") and read("elsewhere/new.svg") == gradus(*LINE, "--theme", "dark", "-o", "-").bytes,
          "followed, too")
    write("elsewhere/mine.svg", "mine")
    os.symlink("elsewhere/mine.svg", "live.svg")
    equal((gradus(*LINE, "-o", "live.svg").err, read("elsewhere/mine.svg")), (refusal("live.svg"), b"mine"), "to somebody's file")
    os.symlink("one.svg", "two.svg")
    os.symlink("two.svg", "one.svg")
    result = gradus(*LINE, "-o", "one.svg")
    equal((result.code, result.err), (1, "gradus: can't write 'one.svg': Too many levels of symbolic links\n"), "round in a circle")
    os.symlink("gone/x.svg", "far.svg")
    result = gradus(*LINE, "-o", "far.svg")
    equal((result.code, result.err), (1, "gradus: can't write 'far.svg': No such file or directory\n"), "into a folder that is not there")

    lecture("own.json")
    os.mkdir("own")
    write("elsewhere/page.html", MINE)
    for target, code in (("../elsewhere/page.html", 2), ("../elsewhere/new.html", 0)):
        os.symlink(target, "own/index.html")
        equal(gradus("figures", "own.json", "-o", "own").code, code, f"a page that is a link to {target}")
        check(os.path.islink("own/index.html"), "stays one")
        os.remove("own/index.html")
    equal(read("elsewhere/page.html"), MINE, "somebody's page behind a link stays")
    check(b"Gradus" in read("elsewhere/new.html"), "a link to nothing yet is followed")


# --- What is left half-made ------------------------------------------------------------------------------------------


def leftovers(folder="."):
    return sorted(name for name in os.listdir(folder) if name.startswith(".gradus.") and name.endswith(".tmp"))


def series():
    """A series that takes a while, as a process that has begun its third file."""
    process = subprocess.Popen([GRADUS, "figure", "bresenham_line", "--to", "200,7", "-o", "s{step}.png"],
                               stderr=subprocess.DEVNULL, env=PLAIN)
    wait_for(lambda: len(leftovers()) > 2)
    return process


def test_what_killed_processes_left_is_removed():
    process = series()
    process.kill()
    process.wait()
    left = leftovers()
    check(len(left) > 2, f"kill -9 leaves files: {left}")
    write(".gradus.mine", "kept")
    write(".gradus-notes.tmp", "kept")
    equal(gradus("run", "bresenham_line").code, 0, "a command that writes no file")
    equal(leftovers(), left, "looks at none")
    equal(gradus(*LINE, "-o", "a.svg").code, 0, "the next one that writes")
    equal(files(), [".gradus-notes.tmp", ".gradus.mine", "a.svg"], "removes them, and nothing else")

    lecture("own.json", *({"name": f"n{i}", "outputs": ["pdf"], "input": {"to": "30,7"}} for i in range(12)))
    process = subprocess.Popen([GRADUS, "figures", "own.json", "-o", "own", "-q"], env=PLAIN)
    wait_for(lambda: os.path.exists("own/n3/n3.pdf"))
    process.kill()
    process.wait()
    result = gradus("figures", "own.json", "-o", "own", "-q")
    equal((result.code, result.err), (0, ""), "figures go on after kill -9")
    equal([name for name in files("own") if name.endswith(".tmp")], [], "and clean up")


def test_what_living_processes_write_is_left():
    process = series()
    equal(gradus(*LINE, "-o", "a.svg").code, 0, "another process in the same folder")
    check(len(leftovers()) > 2, "it leaves files that are being written")
    equal(process.wait(), 0, "which get their names")
    equal(len(files()), 202, "all of them")


def test_numbers_that_are_another_process_now():
    process = series()
    process.kill()
    process.wait()
    host, number, start, _ = leftovers()[0][len(".gradus."):-len(".tmp")].split("-")
    for name in leftovers():
        os.remove(name)
    equal(int(number), process.pid, "the process in the name")
    own_start = open(f"/proc/{os.getpid()}/stat").read().rsplit(")", 1)[1].split()[19]
    mine, now, old = os.getpid(), time.time(), time.time() - 8 * 24 * 3600
    cases = [  # name, age, stays
        (f"{host}-{mine}-{own_start}-0", now, True),
        (f"{host}-{mine}-{start}-1", now, False),
        (f"{host}-{mine}-{own_start}-2", old, True),
        (f"{host}-{number}-{start}-3", now, False),
        (f"{'0' * 16}-{number}-{start}-4", now, True),
        (f"{'0' * 16}-{mine}-{own_start}-5", old, False),
        ("4711-6", now, True),
        ("4711-7", old, False),
        (f"{host}--1-{start}-8", now, True),
        (f"{host}-99999999999999999999-{start}-9", now, True),
    ]
    for name, age, _ in cases:
        write(f".gradus.{name}.tmp", "x")
        os.utime(f".gradus.{name}.tmp", (age, age))
    os.mkdir(f".gradus.{host}-{number}-{start}-10.tmp")
    os.symlink("nowhere", f".gradus.{host}-{number}-{start}-11.tmp")
    equal(gradus(*LINE, "-o", "a.svg").code, 0, "a command that writes")
    stay = [f".gradus.{name}.tmp" for name, _, stays in cases if stays]
    equal(leftovers(), sorted([*stay, f".gradus.{host}-{number}-{start}-10.tmp", f".gradus.{host}-{number}-{start}-11.tmp"]),
          "only files of processes of this system that have ended, and forgotten ones")


def test_a_full_disk_lists_nothing_as_made():
    words = ["figure", "bresenham_line", "--to", "30,12", "-o", "c-{step}.png"]
    gradus(*words)
    sizes = [os.path.getsize(f"c-{i}.png") for i in range(31)]
    for name in files():
        os.remove(name)
    limit = sorted(sizes)[20]
    check(sizes[0] < limit < max(sizes), f"the first file fits, a later one does not: {sizes}")

    def limited():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
    result = gradus(*words, preexec_fn=limited)
    equal((result.code, result.out), (1, ""), "a disk that is full")
    check(result.err.startswith("gradus: can't write 'c-") and result.err.count("\n") == 1, f"one line: {result.err!r}")
    equal(files(), [], "and no file")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
