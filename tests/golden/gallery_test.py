"""`gradus figures` without a lecture: the gallery, what is drawn anew, and a part of it.

Usage: gallery_test.py [path of gradus]        (default: $GRADUS_COMMAND)
"""
import json
import os
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
import project
from command import check, equal, files, gradus, read, write


def test_figures():
    # The gallery that this build has drawn, with as many jobs as there are cores
    shutil.copytree(project.gallery(), "out")
    made = {name: read(os.path.join("out", name)) for name in files("out")}
    slugs = sorted({name.split("/")[0] for name in made if "/" in name} - {"topics"})
    check(len(slugs) >= 2 and "bresenham_line" in slugs, f"figures: {slugs}")
    # A figure may bring its model along, too, but only figures have steps
    rendered = [slug for slug in slugs if any(name.startswith(f"{slug}/") and name.endswith(".obj") for name in made)
                and f"{slug}/{slug}-steps.zip" not in made]
    equal(len(rendered), 7, f"renders: {rendered}")
    drawn = [slug for slug in slugs if slug not in rendered]
    for slug in drawn:
        for ending in (".pdf", ".svg", ".png", "-drawing.svg", ".html", ".csv", ".json", "-steps.zip"):
            check(f"{slug}/{slug}{ending}" in made, f"{slug}{ending} is there")
    for slug in rendered:
        check(f"{slug}/{slug}.png" in made and f'src="./{slug}/{slug}.png"' in made["index.html"].decode(), f"{slug}.png is there and shown")
    check("topics/scan_conversion/bresenham_line.html" in made, "the pages of the topics")
    check("errata.html" in made and 'href="./errata.html"' in made["index.html"].decode(), "the page of errata")
    page = made["index.html"].decode()
    for link in re.findall(r'(?:href|src)="([^"#:]+)"', page):
        check(os.path.exists(os.path.join("out", link)), f"the link {link} leads somewhere")
    check(all(f"{slug}/{slug}.pdf" in page for slug in drawn) and "//" not in re.sub(r"https?://www\.w3\.org|https?://creativecommons\.org", "", "".join(
        re.findall(r'(?:href|src)="([^"]*)"', page))), "relative links only")
    again = gradus("figures", "-o", "out")
    equal((again.out, again.err), ("out/index.html\n", f"0 drawn, {len(slugs)} unchanged, 0 removed\n"), "unchanged")

    without = {name: data for name, data in made.items() if not name.startswith(".")}
    few = ["figures", "--only", "bresenham*", "-o"]
    one, two = gradus(*few, "one/", "--jobs", "1"), gradus(*few, "two", "--jobs", "2")
    equal((one.code, one.out), (0, "one/index.html\n"), "figures")
    check(re.fullmatch(r"\d\d drawn, 0 unchanged, 0 removed", one.err.splitlines()[-1]), "what was done: " + one.err)
    equal(two.err, one.err, "the order of the output does not depend on the number of jobs")
    alone = {name: read(os.path.join("one", name)) for name in files("one") if name.startswith("bresenham")}
    equal(alone, {name: data for name, data in without.items() if name.startswith("bresenham")},
          "the same bytes with several jobs, and in a folder of their own")

    # One changed, one lost
    write("out/bresenham_line/bresenham_line.svg", "edited")
    os.remove(f"out/{drawn[-1]}/{drawn[-1]}.pdf")
    os.remove(f"out/{rendered[-1]}/{rendered[-1]}.png")
    changed = sorted({"bresenham_line", drawn[-1], rendered[-1]})
    result = gradus("figures", "-o", "out")
    equal(sorted(result.err.splitlines()[:-1]), changed, "what was changed is drawn again")
    equal({name: read(os.path.join("out", name)) for name in files("out") if not name.startswith(".")}, without, "as before")

    # A job that no longer exists
    manifest = json.loads(read("out/.gradus-manifest.json"))
    text = read("out/.gradus-manifest.json").decode()
    check("bresenham_line" in json.dumps(manifest), "the manifest")
    os.mkdir("out/gone_slug")
    for name in files("out/bresenham_line"):
        shutil.copy2(f"out/bresenham_line/{name}", f"out/gone_slug/{name.replace('bresenham_line', 'gone_slug')}")
    write("out/gone_slug/mine.txt", "kept")
    write("out/.gradus-manifest.json", re.sub("bresenham_line(?!_)", "gone_slug", text))
    result = gradus("figures", "-o", "out")
    check(result.err.endswith("1 removed\n"), result.err)
    equal(files("out/gone_slug"), ["mine.txt"], "only files named in the manifest are removed")
    os.remove("out/topics/scan_conversion/flood_fill.html")
    gradus("figures", "-o", "out")
    equal(read("out/topics/scan_conversion/flood_fill.html"), made["topics/scan_conversion/flood_fill.html"],
          "a lost topic page is made again")


def test_figures_all_anew():
    circles = ["figures", "-o", "out", "--only", "bresenham_circle*"]
    drawn = gradus(*circles).err.splitlines()[-1]
    check(re.fullmatch("[2-9] drawn, 0 unchanged, 0 removed", drawn), drawn)
    equal(gradus(*circles).err.splitlines()[-1], f"0 drawn, {drawn[0]} unchanged, 0 removed", "unchanged")
    equal(gradus(*circles, "--force").err.splitlines()[-1], drawn, "--force")
    write("out/.gradus-manifest.json", "{ broken")
    equal(gradus(*circles).err.splitlines()[-1], drawn, "a broken manifest: all anew")


def test_figures_only():
    result = gradus("figures", "-o", "out", "--only", "Bresenham-*")
    check(all(name.startswith("bresenham") for name in result.err.splitlines()[:-1]), result.err)
    page = read("out/index.html").decode()
    check("bresenham_line" in page and "flood_fill" not in page, "the page shows what is there")
    equal([name for name in files("out") if name.startswith("topics/")],
          [f"topics/scan_conversion/bresenham_{name}.html" for name in ("circle", "line")], "and the topics' pages are")
    gradus("figures", "-o", "out", "--only", "flood_fill_span")
    page = read("out/index.html").decode()
    check("bresenham_line" in page and "flood_fill_span" in page, "figures made earlier stay on the page")
    result = gradus("figures", "-o", "none", "--only", "x*")
    equal((result.code, result.out, result.err, os.path.exists("none")),
          (1, "", "gradus: --only: expected a pattern that matches a figure or a topic, found 'x*'\n", False), "no match")
    svg = "out/bresenham_line/bresenham_line.svg"
    if os.path.exists(svg):
        gradus("again", svg, "-o", "a.svg")
        equal(read("a.svg"), read(svg), "a figure of the gallery made again")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
