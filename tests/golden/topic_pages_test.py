#!/usr/bin/env python3
"""The topic pages: one form for all, commands that run, figures that `gradus again` makes to the byte, and their HTML.

GRADUS_UPDATE_GOLDEN=1 makes the figures of docs/topics/*/figures/ anew; look at them before committing.
"""
import csv
import html.parser
import io
import os
import pathlib
import re
import shlex
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project
from share import in_share

HEADINGS = ["Symbols", "By hand", "Derivation", "Edge cases", "Common mistakes", "Accuracy and cost", "Methods compared",
            "Charts", "Try it", "Check yourself", "Sources"]
WITH_PICTURE = ("By hand", "Common mistakes", "Charts")
MOST_WORDS = 1750
QUESTIONS = 5
VOID = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"}


def page_of(topic, root=project.ROOT):
    return root / f"docs/topics/{topic.path}.md"


def sections(text):
    """Heading -> what stands below it; "" is the part before the first."""
    parts = re.split(r"^## +(.+?) *$", re.sub(r"^# .*\n", "", text), flags=re.MULTILINE)
    return {"": parts[0], **dict(zip(parts[1::2], parts[2::2]))}


def table_rows(text):
    lines = [line for line in text.split("\n") if line.startswith("|")]
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip("|"))] for line in lines[2:]]


def pictures(text):
    return re.findall(r"!\[([^\]]+)\]\(([^)\s]+)\)", text)


def commands(text):
    """The lines of code blocks that are our commands."""
    blocks = re.findall(r"^```[a-z]*\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    return [line for block in blocks for line in block.split("\n") if line.startswith("gradus ")]


def questions(text):
    return re.findall(r"<details><summary>(\d+)\. (.+?\?)</summary>\n(.+?)</details>", text, re.DOTALL)


def form_violations(text, names):
    """What a page lacks of the form that all pages share. `names`: what code and tables call things."""
    found = []
    parts = sections(text)
    headings = [heading for heading in parts if heading]
    if headings != HEADINGS:
        found.append(f"headings {headings}, expected {HEADINGS}")
    idea = re.match(r"\s*\*\*Idea\.\*\* (.+?)\n\n", parts[""], re.DOTALL)
    if not idea or len(re.findall(r"[.!?](?:\s|$)", idea.group(1))) != 1:
        found.append("the idea is not one sentence: **Idea.** …")
    words = len(text.split())
    if words > MOST_WORDS:
        found.append(f"{words} words, at most {MOST_WORDS}")
    for heading in WITH_PICTURE:
        if not pictures(parts.get(heading, "")):
            found.append(f"no picture under {heading}")
    symbols = table_rows(parts.get("Symbols", ""))
    if not symbols:
        found.append("no table under Symbols")
    for row in symbols:
        if len(row) != 3:
            found.append(f"Symbols: {row[0]}: expected symbol, name in code and table, meaning")
            continue
        mentioned = re.findall(r"`([^`]+)`", row[1])
        if not mentioned:
            found.append(f"Symbols: {row[0]} has no name in code or table")
        found += [f"Symbols: {name} is neither in the source nor a column" for name in mentioned if name not in names]
    for row in table_rows(parts.get("Edge cases", "")):
        if len(row) != 3 or not all(row):
            found.append(f"Edge cases: {row[0]}: expected input, what comes out, why")
    numbers = [number for number, _, _ in questions(parts.get("Check yourself", ""))]
    if numbers != [str(n + 1) for n in range(QUESTIONS)]:
        found.append(f"questions {numbers}, expected 1 to {QUESTIONS}, each with a folded answer")
    if not commands(parts.get("Try it", "")):
        found.append("no command under Try it")
    if not re.search(r"^- ", parts.get("Sources", ""), re.MULTILINE):
        found.append("no list under Sources")
    return found


class Html(html.parser.HTMLParser):
    """Every element closed in its place; collects links, ids and what the page would load."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.open, self.faults, self.ids, self.links, self.loads = [], [], set(), [], []
        self.feed(text)
        self.close()
        self.faults += [f"<{tag}> is never closed" for tag in self.open]

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if "id" in values:
            if values["id"] in self.ids:
                self.faults.append(f"id {values['id']} twice")
            self.ids.add(values["id"])
        if tag == "a":
            self.links.append(values.get("href", ""))
        self.loads += [values[name] for name in ("src", "srcset", "data", "poster") if name in values]
        if tag == "link":
            self.loads.append(values.get("href", ""))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag in VOID:
            return
        if not self.open or self.open[-1] != tag:
            self.faults.append(f"</{tag}> at {self.getpos()}, open: {self.open[-3:]}")
        if tag in self.open:
            while self.open.pop() != tag:
                pass


def html_faults(path):
    """What is not well-formed, leads nowhere or would be loaded from elsewhere."""
    page = Html(path.read_text(encoding="utf-8"))
    faults = page.faults + [f"loads {load[:40]}" for load in page.loads if not load.startswith("data:image/")]
    for link in page.links:
        if link.startswith("https://"):
            continue
        target, _, anchor = link.partition("#")
        file = path.parent / target if target else path
        if not file.is_file():
            faults.append(f"{link} leads nowhere")
        elif anchor and file.suffix == ".html" and anchor not in Html(file.read_text(encoding="utf-8")).ids:
            faults.append(f"{link}: no such place")
    return faults


def with_page(test):
    """Runs a test once for each topic that has a page."""
    def run(self):
        count = 0
        for topic in project.topics():
            if topic.partial and not page_of(topic).is_file():
                continue
            with self.subTest(topic=topic.name):
                test(self, topic, page_of(topic).read_text(encoding="utf-8"))
            count += 1
        self.assertGreater(count, 1)
    return run


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        (cls.folder / "examples").symlink_to(project.ROOT / "examples")
        (cls.folder / "out").symlink_to(project.gallery())

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def names(self, topic):
        """Words and members of the sources, and the columns of every method's table."""
        text = "\n".join(header.read_text(encoding="utf-8") for header in project.topic_headers(topic))
        names = set(re.findall(r"[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)?", text)) | set(re.findall(r"\w+", text))
        for table in self.folder.glob(f"out/{topic.name}*/*.csv"):
            names |= set(next(csv.reader(io.StringIO(table.read_text(encoding="utf-8")))))
        return names

    @with_page
    def test_one_form(self, topic, text):
        found = form_violations(text, self.names(topic))
        self.assertEqual(found, [], "\n" + "\n".join(found))

    @with_page
    def test_every_command_runs(self, topic, text):
        self.assertGreater(len(commands(text)), 2)
        if not in_share([t.name for t in project.topics()].index(topic.name), 3):
            return
        for command in commands(text):
            with self.subTest(command), tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "examples").symlink_to(project.ROOT / "examples")
                words = shlex.split(command)
                project.run(project.COMMAND, *words[1:], cwd=folder)
                if "-o" in words:
                    output = pathlib.Path(folder) / words[words.index("-o") + 1]
                    self.assertTrue(output.stat().st_size if output.is_file() else any(output.iterdir()), output)

    @with_page
    def test_the_rendered_page(self, topic, text):
        path = self.folder / f"out/topics/{topic.path}.html"
        faults = html_faults(path)
        self.assertEqual(faults, [], "\n" + "\n".join(faults))
        page = path.read_text(encoding="utf-8")
        parsed = Html(page)
        self.assertEqual(len(pictures(text)), sum(load.startswith("data:image/svg") for load in parsed.loads))
        for heading in HEADINGS:
            self.assertIn(heading.lower().replace(" ", "-"), parsed.ids)
        players = [link for link in parsed.links if f"/{topic.name}" in link and link.endswith(".html")]
        self.assertTrue(players, "a link to a player")
        index = (self.folder / "out/index.html").read_text(encoding="utf-8")
        self.assertIn(f'"./topics/{topic.path}.html"', index)
        for header in project.topic_headers(topic):
            if f"/{header.name})" in text:
                self.assertIn(f"source-{header.name}", parsed.ids, "the source is folded in")

    def test_the_gallery_page(self):
        page = Html((self.folder / "out/index.html").read_text(encoding="utf-8"))
        self.assertEqual(page.faults, [])
        for link in page.links + page.loads:
            self.assertTrue((self.folder / "out" / link).is_file(), link)


class Figures(unittest.TestCase):
    def test_figures_are_made_again_to_the_byte(self):
        figures = sorted((project.ROOT / "docs/topics").glob("*/figures/*"))
        self.assertGreater(len(figures), 3)
        used = {(page_of(topic).parent / path).resolve() for topic in project.topics() if page_of(topic).is_file()
                for _, path in pictures(page_of(topic).read_text(encoding="utf-8"))}
        update = os.environ.get("GRADUS_UPDATE_GOLDEN")
        changed = []
        folder = self.enterContext(tempfile.TemporaryDirectory())
        for figure in figures:
            with self.subTest(figure.name):
                self.assertIn(figure.resolve(), used, "no page shows it")
                again = pathlib.Path(folder) / figure.name
                project.run(project.COMMAND, "again", figure, "-o", again)
                if figure.read_bytes() != again.read_bytes():
                    changed.append(figure)
                    if update:
                        figure.write_bytes(again.read_bytes())
        if changed and update:
            print("made anew:", ", ".join(figure.name for figure in changed), "- build again, they are in the pages")
        elif changed:
            self.fail(f"{', '.join(figure.name for figure in changed)}: `gradus again` makes other bytes. If the new "
                      "drawing is right: GRADUS_UPDATE_GOLDEN=1 python3 tests/golden/topic_pages_test.py")


PAGE = f"""# A line

**Idea.** Draw it.

""" + "\n".join(f"## {heading}\n\n" + {
    "Symbols": "| symbol | name | meaning |\n|---|---|---|\n| p | `p` | sign |\n",
    "By hand": "![Step 3](figures/a.svg)\n",
    "Edge cases": "| input | what comes out | why |\n|---|---|---|\n| a | b | c |\n",
    "Common mistakes": "![Wrong](figures/b.svg)\n",
    "Charts": "![Time](../../benchmarks/a-bench-size.svg)\n",
    "Try it": "```\ngradus list\n```\n",
    "Check yourself": "".join(f"<details><summary>{n}. Why?</summary>\nSo.</details>\n" for n in range(1, 6)),
    "Sources": "- A book\n",
}.get(heading, "Text.\n") for heading in HEADINGS)


class Planted(unittest.TestCase):
    """A page without fault, and one fault after the other."""

    def caught(self, words, old, new):
        self.assertIn(old, PAGE)
        found = form_violations(PAGE.replace(old, new, 1), {"p"})
        self.assertTrue(any(words in line for line in found), found)

    def test_the_page_is_without_fault(self):
        self.assertEqual(form_violations(PAGE, {"p"}), [])

    def test_faults_of_form(self):
        for words, old, new in (("headings", "## By hand", "## By heart"), ("headings", "## Sources", "### Sources"),
                                ("one sentence", "Draw it.", "Draw it. Well."), ("words", "Text.", "Text.\n" * MOST_WORDS),
                                ("no picture under Common", "![Wrong](figures/b.svg)", ""),
                                ("no picture under Charts", "![Time]", "[Time]"),
                                ("neither in the source", "`p`", "`q`"), ("no name", "`p`", "p"),
                                ("Edge cases", "| b |", "|  |"), ("questions", "2. Why?", "2. So."),
                                ("questions", "3. Why?", "4. Why?"), ("no command", "gradus list", "ls"),
                                ("no list", "- A book", "A book")):
            with self.subTest(words):
                self.caught(words, old, new)

    def test_faults_of_html(self):
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "a.html"
            for fault, text in (("never closed", "<p>a"), ("</b>", "<p><b>a</p></b>"), ("twice", '<p id="a"></p><p id="a"></p>'),
                                ("leads nowhere", '<a href="b.html">b</a>'), ("no such place", '<a href="#b">b</a>'),
                                ("loads", '<img src="https://example.org/a.png">')):
                with self.subTest(fault):
                    path.write_text(text, encoding="utf-8")
                    self.assertTrue(any(fault in line for line in html_faults(path)), html_faults(path))
            path.write_text('<p id="b"><a href="#b">b</a><br><img src="data:image/png;base64,"></p>', encoding="utf-8")
            self.assertEqual(html_faults(path), [])


if __name__ == "__main__":
    unittest.main()
