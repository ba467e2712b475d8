#!/usr/bin/env python3
"""Hostile names in any input (markup, quotes, escapes of terminals, marks that turn the direction of text, line ends) come
out as text: outputs are parsed as what they are, and hold no element, attribute or control character that an innocent
name would not bring.

    tests/golden/hostile_names_test.py [GRADUS]
"""
import functools
import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unicodedata
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal, gradus
from share import EVERYTHING, in_share, share_of

SOURCE = pathlib.Path(__file__).resolve().parents[2]

# Names that can be drawn, and names that no font can show: those are refused where they would be drawn
MARKUP = ["<script>alert(1)</script>", "a\"b'c&d", "</title></script><img src=x onerror=alert(1)>", "]]>--><!--",
          "&lt;b&gt; &#10; {{title}} {} %s", "javascript:alert(1)", "${x} `id` $(id); rm *", "\\x1b[31m \\n"]
CONTROL = ["\x1b[31mred", "\x1b]0;title\x07", "a\nb", "a\rb", "\u202ereversed", "\u2066isolated", "\u061cmark", "\x9b31m", "\x7f",
           "a\u2028b"]
TURNING = set("\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")

# A run takes one in three names through each way
WAYS = 1 if EVERYTHING else 3

MAZE = "#####\n#...#\n#####\n"
OBJ = "{0}v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"


def is_harmless(text, what, ends="\n"):
    """No control character but ends of lines, and nothing that turns the direction of text."""
    bad = sorted({c for c in text if c not in ends and (unicodedata.category(c) in ("Cc", "Zl", "Zp") or c in TURNING)})
    return check(not bad, f"{what}: control characters {bad!r}")


class Markup(html.parser.HTMLParser):
    """The elements of a page with the names of their attributes, and the texts of its scripts."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.elements, self.scripts, self.links = set(), [], []
        self.count = {}
        self.inside = False
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src"):
                self.links.append(value or "")
            self.elements.add((tag, name))
        self.elements.add((tag, ""))
        self.count[tag] = self.count.get(tag, 0) + 1
        self.inside = tag == "script"
        if self.inside:
            self.scripts.append("")

    def handle_endtag(self, tag):
        self.inside = False

    def handle_data(self, data):
        if self.inside:
            self.scripts[-1] += data


def check_html(text, innocent, what):
    is_harmless(text, what, "\n\t")
    page, plain = Markup(text), Markup(innocent)
    equal(page.elements - plain.elements, set(), f"{what}: elements and attributes")
    for tag in ("script", "img", "a", "title", "style", "iframe"):
        equal(page.count.get(tag), plain.count.get(tag), f"{what}: number of <{tag}>")
    equal([script.startswith("{") for script in page.scripts], [script.startswith("{") for script in plain.scripts],
          f"{what}: scripts and data")
    for script in page.scripts:
        if script.startswith("{"):
            json.loads(script)
    for link in page.links:
        scheme = re.match(r"[\s\x00-\x1f]*([a-zA-Z][a-zA-Z0-9+.-]*):", link)
        check(not scheme or scheme.group(1).lower() in ("https", "data", "mailto"), f"{what}: a link to {link[:60]!r}")


def check_svg(text, what):
    is_harmless(text, what, "\n\t")
    root = ElementTree.fromstring(text)
    for element in root.iter():
        name = element.tag.rsplit("}", 1)[-1]
        check(name not in ("script", "foreignObject", "img", "a", "b", "iframe"), f"{what}: an element <{name}>")
        for attribute, value in element.attrib.items():
            short = attribute.rsplit("}", 1)[-1]
            check(not short.startswith("on"), f"{what}: an attribute {short}")
            check(short != "href" or value.startswith(("#", "data:image/png")), f"{what}: a link to {value[:60]!r}")


def one_line(result, what):
    """Refused in one safe line, or done."""
    check(result.code in (0, 2), f"{what}: exit {result.code}")
    if result.code == 2:
        check(result.err.startswith("gradus: ") and result.err.count("\n") == 1, f"{what}: one line, found {result.err!r}")
    is_harmless(result.err, what)
    return result.code == 0


def read(path):
    with open(path, "rb") as file:
        return file.read()


@functools.cache
def player_of(*words):
    gradus("figure", *words, "-o", "plain.html")
    return read("plain.html").decode("utf-8")


def in_formats(words, innocent, what, endings=("svg", "html", "json", "txt", "csv", "md", "tex")):
    """The command with an output of each format, parsed. True when it was drawn."""
    drawn = False
    for ending in endings:
        result = gradus("figure", *words, "-o", f"out.{ending}", "--format", ending)
        if not one_line(result, f"{what} as {ending}"):
            continue
        drawn = True
        is_harmless(result.out, f"{what} as {ending}: standard output")
        text = read(f"out.{ending}").decode("utf-8")
        if ending == "svg":
            check_svg(text, f"{what} as {ending}")
        elif ending == "html":
            check_html(text, player_of(*innocent), f"{what} as {ending}")
        elif ending == "json":
            is_harmless(text, f"{what} as {ending}", "\n")
            json.loads(text)
        else:
            is_harmless(text, f"{what} as {ending}", "\r\n" if ending == "csv" else "\n")
    return drawn


def test_titles_labels_and_captions():
    line = ["bresenham_line", "--from", "0,0", "--to", "3,1"]
    drawn = 0
    for name in share_of(MARKUP, 3) + share_of(CONTROL, 3):
        for flag in ("--title={}", "--label=p={}", "--caption={}"):
            drawn += in_formats([*line, flag.format(name)], line, f"{flag.format(name)!r}")
        result = gradus("figure", *line, f"--title={name}", "--svg-text", "text", "-o", "text.svg")
        if one_line(result, f"{name!r} as text"):
            check_svg(read("text.svg").decode("utf-8"), f"{name!r} as text")
        for kind, to in (("beamer", "pdf"), ("reveal", "svg"), ("markdown", "svg")):
            result = gradus("figure", *line, f"--title={name}", f"--caption={name}", "-o", f"s.{to}", "--snippet", kind)
            if one_line(result, f"{name!r} in a snippet for {kind}"):
                is_harmless(result.out, f"{name!r} in a snippet for {kind}")
                if kind == "reveal":
                    equal({tag for tag, _ in Markup(result.out).elements} - {"section", "h2", "img", "div", "p"}, set(),
                          f"{name!r} in a snippet for reveal")
        # The command in a figure's metadata is a single safe line, and makes the figure again
        if one_line(gradus("figure", *line, f"--caption={name}", "-o", "a.svg"), f"{name!r} as a caption"):
            again = gradus("again", "a.svg", "-o", "b.svg")
            if equal(again.code, 0, f"{name!r}: again {again.err}"):
                equal(read("b.svg"), read("a.svg"), f"{name!r}: the same again")
    check(drawn >= 3 * (len(MARKUP) // WAYS) - 4, f"{drawn} were drawn")


def test_values_of_every_flag():
    """What is wrong with a value is said in one safe line."""
    topics = json.loads(gradus("list", "--json").out)
    topics = topics["topics"] if isinstance(topics, dict) else topics
    cases = 0
    flags = [(topic["name"], "--" + parameter["name"].replace("_", "-")) for topic in topics for parameter in topic["parameters"]]
    for number, name in enumerate(CONTROL + MARKUP[:3]):
        if not in_share(number, 3):
            continue
        # Every flag meets every third of the names, which the commits take in turn
        for topic, flag in flags if EVERYTHING else flags[number // 3 % 3::3]:
            one_line(gradus("run", topic, f"{flag}={name}"), f"{topic} {flag}={name!r}")
            cases += 1
        for words in ([name], ["run", name], ["help", name], ["list", name], ["figure", "bresenham_line", "--" + name],
                      ["figure", "bresenham_line", "-o", name], ["figures", name], ["again", name], ["render", name, "-o", "a.png"],
                      ["figure", "bresenham_line", "-o", "a.svg", "--theme", name], ["run", "bresenham_line", "--steps", name],
                      ["figure", "bresenham_line", "-o", "a.svg", "--label", name], ["figure", "bresenham_line", "-o", "a." + name]):
            result = gradus(*words)
            is_harmless(result.err, f"{words!r}")
            is_harmless(result.out, f"{words!r}")
            check(result.code in (0, 1, 2), f"{words!r}: exit {result.code}")
            cases += 1
    check(cases > 500 // WAYS, f"{cases} cases")


def test_names_of_files():
    cases = 0
    gradus("render", str(SOURCE / "examples/models/letter_f.obj"), "-o", "small.png", "--size", "16x12")
    for name in share_of(CONTROL + [name for name in MARKUP if "/" not in name] + ["<b>bold<b>"], 3):
        # A maze
        with open(name + ".txt", "w") as file:
            file.write(MAZE)
        fill = ["flood_fill", "--maze", name + ".txt", "--at", "1,1"]
        in_formats(fill, ["flood_fill", "--maze", MAZE.strip().replace("\n", "/"), "--at", "1,1"], f"the maze {name!r}")
        for words in (["run", *fill], ["run", *fill, "--json"], ["run", *fill, "--color", "never"]):
            is_harmless(gradus(*words).out, f"the table of the maze {name!r}")
        # Results under such a name
        result = gradus("figure", *fill, "-o", name + ".svg", "--snippet", "markdown")
        is_harmless(result.out + result.err, f"the output {name!r}")
        check("](<javascript:" not in result.out, f"the output {name!r} is an address, not a program")
        check(os.path.exists(name + ".svg") == (result.code == 0), f"the output {name!r}")
        # A maze that cannot be read, an image that is none
        with open(name + ".txt", "w") as file:
            file.write("##\n#\n")
        check(not one_line(gradus("run", *fill), f"the uneven maze {name!r}"), "it is refused")
        check(not one_line(gradus("run", "flood_fill", "--image", name + ".txt", "--at", "1,1"), f"the image {name!r}"), "it is refused")
        # A real image
        shutil.copy("small.png", name + ".png")
        in_formats(["flood_fill", "--image", name + ".png", "--at", "1,1", "--steps", "0-2"],
                   ["flood_fill", "--image", "small.png", "--at", "1,1", "--steps", "0-2"],
                   f"the image {name!r}", ("svg", "html", "json", "txt"))
        # A model with a library that is not there, and a broken one
        with open(name + ".obj", "w", newline="") as file:
            file.write(OBJ.format("mtllib nothing.mtl\nusemtl red\n"))
        result = gradus("render", name + ".obj", "-o", name + ".png", "--size", "32x24")
        if one_line(result, f"the model {name!r}"):
            again = gradus("again", name + ".png", "-o", "again.png")
            is_harmless(again.err, f"the model {name!r} again")
            equal(again.code, 0, f"the model {name!r} again: {again.err}")
        with open(name + ".obj", "w", newline="") as file:
            file.write("v nan 0 0\n")
        check(not one_line(gradus("render", name + ".obj", "-o", "m.png"), f"the broken model {name!r}"), "it is refused")
        cases += 1
    check(cases > 10 // WAYS, f"{cases} names")


def test_names_in_models():
    for name in share_of(CONTROL + MARKUP, 3):
        head = f"o {name}\ng {name}\nmtllib {name}.mtl\nusemtl {name}\nnothing\n" if "\n" not in name else f"o {name}\n"
        with open("m.obj", "w", encoding="utf-8", newline="") as file:
            file.write(OBJ.format(head.replace("nothing\n", "")))
        if one_line(gradus("render", "m.obj", "-o", "m.png", "--size", "32x24"), f"{name!r} in a model"):
            in_formats(["pipeline", "m.obj", "--stage", "clipping"], ["pipeline", "--stage", "clipping"], f"{name!r} in a model",
                       ("svg", "html", "json", "txt"))
        with open("m.obj", "w", encoding="utf-8", newline="") as file:
            file.write(OBJ.format(head + name + "\n"))
        one_line(gradus("render", "m.obj", "-o", "m.png", "--size", "32x24"), f"{name!r} as a statement")
        with open("lib.mtl", "w", encoding="utf-8", newline="") as file:
            file.write(f"newmtl {name}\nKd 1 0 0\n{name}\nmap_Kd {name}\n")
        with open("m.obj", "w", encoding="utf-8", newline="") as file:
            file.write(OBJ.format(f"mtllib lib.mtl\nusemtl {name}\n"))
        one_line(gradus("render", "m.obj", "-o", "m.png", "--size", "32x24"), f"{name!r} in a library")


def test_lectures():
    def lecture(name, path="lecture.json"):
        figures = [{"topic": "bresenham_line", "input": {"from": "0,0", "to": "3,1"}, "caption": name, "outputs": ["svg", "html"]},
                   {"topic": "flood_fill", "input": {"maze": "#.#/...", "at": "1,1"}, "title": name, "label": {"seed": name}}]
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"title": name, "figures": figures[:1]}, file)
        with open("other.json", "w", encoding="utf-8") as file:
            json.dump({"title": name, name: name, "figures": [*figures, {"topic": name, "theme": name, "name": name, name: {}}]}, file)

    lecture("plain")
    plain = gradus("figures", "lecture.json", "-o", "plain")
    equal(plain.code, 0, f"the plain lecture: {plain.err}")
    made = 0
    for number, name in enumerate(share_of(MARKUP, 3) + share_of(CONTROL, 3)):
        lecture(name)
        result = gradus("figures", "lecture.json", "-o", f"out{number}")
        if one_line(result, f"a lecture called {name!r}"):
            is_harmless(result.out, f"a lecture called {name!r}")
            made += 1
            for page in pathlib.Path(f"out{number}").rglob("*.html"):
                twin = pathlib.Path("plain") / page.relative_to(f"out{number}")
                check_html(page.read_text(encoding="utf-8"), twin.read_text(encoding="utf-8"), f"{page.name} of {name!r}")
            for picture in pathlib.Path(f"out{number}").rglob("*.svg"):
                check_svg(picture.read_text(encoding="utf-8"), f"{picture.name} of {name!r}")
        # Full of mistakes: one line each
        check_result = gradus("figures", "other.json", "--check")
        equal(check_result.code, 2, f"{name!r} as a key, topic, theme and name")
        is_harmless(check_result.err + check_result.out, f"{name!r} as a key, topic, theme and name")
        # As the name of the lecture itself
        if "/" not in name:
            lecture(name, name + ".json")
            result = gradus("figures", name + ".json", "--check")
            is_harmless(result.err + result.out, f"a lecture in a file called {name!r}")
            with open(name + ".json", "w") as file:
                file.write("{")
            result = gradus("figures", name + ".json", "--check")
            check(not one_line(result, f"a broken lecture in a file called {name!r}"), "it is refused")
    check(made >= len(MARKUP) // WAYS - 1, f"{made} lectures were drawn")


def main():
    wanted = sys.argv[2:]
    return command.run_all({name: test for name, test in globals().items() if not wanted or name in wanted})


if __name__ == "__main__":
    sys.exit(main())
