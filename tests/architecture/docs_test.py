#!/usr/bin/env python3
"""What the pages say of the project holds: links lead somewhere, versions and package lists agree."""
import json
import pathlib
import re
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import formulas
import house
import project
from sentences import pages, written_so


def without_code(text):
    return re.sub(r"^```.*?^```|`[^`\n]*`", "", text, flags=re.DOTALL | re.MULTILINE)


def anchors(text):
    """The anchors of a page's headings, as repository hosts make them."""
    headings = re.findall(r"^#+ +(.+?) *$", re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE),
                          re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in headings}


def broken_links(root):
    found = []
    for page in pages(root):
        text = page.read_text(encoding="utf-8")
        for link in re.findall(r"\]\(([^)\s]+)\)", without_code(text)):
            if re.match(r"[a-z]+:", link):
                continue
            path, _, anchor = link.partition("#")
            target = page.parent / path if path else page
            if not target.exists():
                found.append(f"{page.relative_to(root)}: {link} leads nowhere")
            elif anchor and target.suffix == ".md" and anchor not in anchors(target.read_text(encoding="utf-8")):
                found.append(f"{page.relative_to(root)}: {link} has no such heading")
    return found


def package_lists(bootstrap):
    """The packages that bootstrap installs: to build, to test, to measure."""
    return [set(re.sub(r"#.*", "", body).split())
            for body in re.findall(r"^\w+_packages=\((.*?)\) *(?:#[^\n]*)?$", bootstrap, re.DOTALL | re.MULTILINE)]


def golden_ids(text):
    return set(re.findall(r"\bG0\d\d-\d+\b", text))


class Docs(unittest.TestCase):
    def test_goldens_are_listed_where_tests_name_them(self):
        rows = [line for line in (project.ROOT / "docs/goldens.md").read_text(encoding="utf-8").splitlines()
                if line.startswith("| G")]
        self.assertGreater(len(rows), 90)
        listed = {}
        for row in rows:
            files = re.findall(r"\]\(\.\./(tests/[^)]+)\)", row)
            self.assertTrue(files, row)
            for file in files:
                listed.setdefault(file, set()).update(golden_ids(row.split("|")[1]))
        tests = {file.relative_to(project.ROOT).as_posix(): golden_ids(file.read_text(encoding="utf-8"))
                 for kind in ("cpp", "hpp") for file in (project.ROOT / "tests").rglob("*." + kind)}
        self.assertEqual(listed, {file: ids for file, ids in tests.items() if ids})

    def test_relative_links_lead_somewhere(self):
        self.assertGreater(len(pages(project.ROOT)), 3)
        found = broken_links(project.ROOT)
        self.assertEqual(found, [], "\n" + "\n".join(found))

    def test_broken_links_are_caught(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            (root / "a.md").write_text("# A page\n[b](b.md) [here](#a-page) [web](https://example.org) `[x](no.md)`\n",
                                       encoding="utf-8")
            (root / "b.md").write_text("[a](a.md#a-page)\n", encoding="utf-8")
            self.assertEqual(broken_links(root), [])
            (root / "b.md").write_text("[a](a.md#another) [c](c.md)\n", encoding="utf-8")
            self.assertEqual(len(broken_links(root)), 2)

    def test_one_sentence_a_line(self):
        found = []
        for page in pages(project.ROOT):
            text = page.read_text(encoding="utf-8")
            is_so, so = text.split("\n"), written_so(text).split("\n")
            found += [f"{page.relative_to(project.ROOT)}:{number}: {line!r}; better: {better!r}"
                      for number, (line, better) in list(enumerate(zip(is_so, so), 1)) if line != better][:1]
        self.assertEqual(found, [], "python3 tests/support/sentences.py writes them so\n" + "\n".join(found))

    def test_where_sentences_end(self):
        whole = ("It is 2.5 px, e.g. Here, or cf. Fig. 3 of it.", "Of J. E. Bresenham, A. van Dam, in Comm. ACM 18 (6), 1975, pp. 3-4.",
                 "See `a. B` and [it](a. B) and $`a. B`$.", "**A heading.** It goes on.", "What is 1, 2, ... and so on?",
                 "- a list", "    1. a list in a list", "> a quote.", "| a. B | c |", "## A. B", "```\na. B\nc\n```", "<p>a. B</p>")
        for text in whole:
            self.assertEqual(written_so(text), text)
        for text, better in (("One. Two.", "One.\nTwo."), ("One\ntwo.", "One two."), ("Say no? Yes! So it is", "Say no?\nYes!\nSo it is"),
                             ("- One. Two\n  three.\n- Four", "- One.\n  Two three.\n- Four"), ("> One. Two.", "> One.\n> Two."),
                             ("1. One. `Two` is code.\n\nThree", "1. One.\n   `Two` is code.\n\nThree"),
                             ("(One.) \"Two.\" 3 is odd. glTF is a format.", "(One.)\n\"Two.\"\n3 is odd.\nglTF is a format."),
                             ("Press Ctrl-C. It ends. p is odd.", "Press Ctrl-C.\nIt ends.\np is odd."),
                             ("**A.** B. C.", "**A.** B.\nC."), ("No. In it", "No.\nIn it")):
            self.assertEqual(written_so(text), better)
            self.assertEqual(written_so(better), better)

    def test_every_formula_of_a_page_has_its_mathml(self):
        self.assertEqual(sorted(formulas.kept()), formulas.formulas(), "tests/support/formulas.py makes them anew")
        for tex, mathml in formulas.kept().items():
            xml.etree.ElementTree.fromstring(f"<math>{mathml}</math>")
        self.assertEqual({tex: formulas.mathml(tex) for tex in formulas.kept()}, formulas.kept())
        self.assertEqual(formulas.formulas_in("a $`x < 1`$ b `$`\n```math\ny = 2\n```\n```\n$`no`$\n```\n"), ["y = 2", "x < 1"])

    def test_the_picture_of_the_house_is_that_of_the_includes(self):
        rooms = set(house.includes())
        self.assertEqual(set(house.COLUMNS), rooms, "tests/support/house.py gives each room its column")
        drawn = (project.ROOT / "docs/house.svg").read_text(encoding="utf-8")
        self.assertEqual(drawn, house.picture(), "tests/support/house.py > docs/house.svg draws it anew")

    def test_rooms_that_include_each_other_are_named(self):
        with self.assertRaisesRegex(ValueError, "^a includes b includes a$"):
            house.floors({"a": {"b"}, "b": {"a"}})
        self.assertEqual(house.reduced({"a": {"b", "c"}, "b": {"c"}, "c": set()})["a"], {"b"})

    def test_files_of_the_walk_are_there(self):
        walk = (project.ROOT / "docs/README.md").read_text(encoding="utf-8").split("**One datum")[1].split("\n## ")[0]
        files = re.findall(r"`((?:algorithms|visualize)/[\w/.]+)`", walk)
        self.assertGreater(len(files), 8)
        self.assertEqual([f for f in files if not (project.ROOT / f).is_file()], [])

    def test_every_topic_has_its_picture_and_grade(self):
        rows = re.findall(r'^\| <img src="([^"]+)".*\]\(topics/([\w/]+)\.md\) \| (\S+) \|',
                          (project.ROOT / "docs/figures.md").read_text(encoding="utf-8"), re.M)
        self.assertEqual(sorted(page for _, page, _ in rows),
                         sorted(page.relative_to(project.ROOT / "docs/topics").with_suffix("").as_posix()
                                for page in (project.ROOT / "docs/topics").glob("*/*.md") if page.stem != "pipeline"))
        for picture, page, grade in rows:
            self.assertTrue((project.ROOT / "docs" / picture).is_file(), picture)
            self.assertIn(pathlib.Path(page).stem, picture)
            self.assertRegex(grade, "^[ABC][+−]?$")

    def test_one_version(self):
        cmake = (project.ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        version = re.search(r"project\(gradus VERSION ([\d.]+)", cmake).group(1)
        colophon = (project.ROOT / "visualize/figure/colophon.hpp").read_text(encoding="utf-8")
        self.assertIn(f'release_version = "{version}"', colophon)
        self.assertIn(f"## {version}", (project.ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))

    def test_a_page_gives_a_reason_for_every_package(self):
        lists = package_lists((project.ROOT / "bootstrap").read_text(encoding="utf-8"))
        self.assertEqual(len(lists), 5)
        self.assertGreater(min(map(len, lists)), 1)
        page = (project.ROOT / "docs/packages.md").read_text(encoding="utf-8")
        rows = re.findall(r"^\| (.+?) \| (.+?) \|$", page, re.MULTILINE)
        reasons = {package: reason for packages, reason in rows for package in re.findall(r"`([\w+.-]+)`", packages)}
        missing = set.union(*lists) - set(reasons)
        self.assertEqual(missing, set(), "docs/packages.md: no reason for these packages")

    def test_presets_named_in_the_docs_exist(self):
        presets = json.loads((project.ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
        names = {preset["name"] for preset in presets["configurePresets"]}
        text = "\n".join(page.read_text(encoding="utf-8") for page in pages(project.ROOT))
        named = set(re.findall(r"--preset[ =]([\w-]+)", text))
        self.assertTrue(named)
        self.assertEqual(named - names, set())


if __name__ == "__main__":
    unittest.main()
