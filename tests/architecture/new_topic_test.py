#!/usr/bin/env python3
"""`./bootstrap new family/topic` in a copy of the project: a skeleton that is whole, formatted, in its layers, in the lists
and compiles; and what it refuses, without having written anything."""
import functools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import coverage_test
import docs_test
import layers_test
import lists
import new_topic
import project
import topics_test

# Words that the command, the pipeline and the tests use in a sense of their own, and that may name topics all the same
WORDS = ("window", "light", "keyframes", "mesh", "colour")
# In a family that is there and in a new one; the shortest names and the longest ones, which lines must have room for
IN_A_FAMILY, SHORTEST = "clipping/window", "f/zz"
LONGEST = "f" * new_topic.LONGEST_FAMILY + "/" + "t" * new_topic.LONGEST_TOPIC
COPIED = ("CMakeLists.txt", "README.md", "CHANGELOG.md", "LICENSE", ".clang-format", "bootstrap", "algorithms", "cmake", "docs",
          "examples", "pipeline", "tests", "visualize")
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Wshadow", "-Werror",
            "-Wno-missing-field-initializers")
PLACEHOLDERS = re.compile(r"new_family|new_topic\b(?!/)|NewTopic|New topic")


def copy_project(folder):
    for path in map(pathlib.Path, COPIED):
        if (project.ROOT / path).is_dir():
            shutil.copytree(project.ROOT / path, folder / path, ignore=shutil.ignore_patterns("corpus", "__pycache__"))
        elif (project.ROOT / path).exists():
            shutil.copy(project.ROOT / path, folder / path)


def state(root):
    """Path -> whether it is a folder, size and time of everything there is."""
    found = {}
    for path in root.rglob("*"):
        facts = path.stat()
        found[path.relative_to(root).as_posix()] = (path.is_dir(), *((facts.st_size, facts.st_mtime_ns) if path.is_file() else ()))
    return found


def copied(case):
    """A copy of the project for all tests of a class."""
    root = pathlib.Path(case.enterClassContext(tempfile.TemporaryDirectory()))
    copy_project(root)
    return root


class Skeleton(unittest.TestCase):
    """Three topics, one after the other, in one copy."""

    @classmethod
    def setUpClass(cls):
        cls.root = copied(cls)
        cls.made = {name: cls.make(name) for name in (IN_A_FAMILY, SHORTEST, LONGEST)}

    @classmethod
    def make(cls, name):
        """What was said, which files are new, and which are others than before."""
        before = state(cls.root)
        said = new_topic.write(cls.root, [name])
        after = state(cls.root)
        files = sorted(path for path, (is_folder, *_) in after.items() if path not in before and not is_folder)
        return said, files, {path for path in before if before[path] != after.get(path) and not before[path][0]}

    def text(self, path):
        return (self.root / path).read_text(encoding="utf-8")

    def sources(self, name):
        return [path for path in self.made[name][1] if path.endswith((".hpp", ".cpp"))]

    def test_every_file_is_there_and_filled(self):
        skeleton = [path.relative_to(project.ROOT / new_topic.SKELETON).as_posix()
                    for path in (project.ROOT / new_topic.SKELETON).rglob("*") if path.is_file()]
        for name, (said, files, changed) in self.made.items():
            family, topic = name.split("/")
            self.assertEqual(files, sorted(path.replace("new_family", family).replace("new_topic", topic) for path in skeleton))
            self.assertEqual(said[:-2], files)
            self.assertEqual(set(said[-2].removeprefix("named in ").split(", ")), changed)
            self.assertEqual(said[-1].startswith(f"{family} is a new family."), name != IN_A_FAMILY)
            for path in files:
                self.assertNotRegex(self.text(path), PLACEHOLDERS, path)
                self.assertIn(new_topic.MARKER, self.text(path), path)

    def test_the_page_goes_through_every_file_and_list(self):
        page = self.text(new_topic.PAGE)
        named = set(re.findall(r"`([^`]+)`", "".join(line for line in page.splitlines() if line.startswith("|"))))
        _, files, changed = self.made[IN_A_FAMILY]
        self.assertEqual({path.replace("clipping", "F").replace("window", "T") for path in files} - named, set())
        self.assertEqual((changed | {place for place in topics_test.PLACES if (self.root / place).exists()}) - named
                         - {"tests/stress", "tests/benchmark", "tests/architecture/machine_code"}, set())

    def test_its_unit_tests_fail_by_name(self):
        self.assertRegex(self.text("tests/unit/clipping/window_test.cpp"),
                         r"TEST\(Window, IsToBeFilledIn\) {\s+FAIL\(\)\s+<< \"[^;}]*; docs/adding_a_topic.md")

    def test_it_is_formatted_whatever_its_names(self):
        for name in self.made:
            with self.subTest(name):
                self.assertGreater(len(self.sources(name)), 6)
                project.run("clang-format-19", "--dry-run", "-Werror", *self.sources(name), cwd=self.root)

    def test_it_keeps_the_rules(self):
        self.assertEqual([violation for rule in layers_test.RULES for violation in rule(self.root)], [])
        self.assertEqual(docs_test.broken_links(self.root), [])
        self.assertEqual(topics_test.unknown(self.root), [])

    def test_it_is_missing_only_where_a_build_is_needed(self):
        topics = [name.split("/")[1] for name in self.made]
        places = ("docs/lecture.schema.json", "tests/golden/marks", "tests/golden/trace_hashes.txt")
        found = {tuple(line.split(" is missing;")[0].split(": ")) for line in topics_test.missing(self.root)}
        self.assertEqual({(place, topic) for place, topic in found if topic in topics},
                         {(place, topic) for place in places for topic in topics})

    def test_what_is_to_be_filled_in_is_named_line_by_line(self):
        files = {line.split(":")[0] for line in topics_test.left_to_fill_in(self.root)}
        own = {path for _, files, _ in self.made.values() for path in files}
        self.assertEqual((own | {"docs/coverage.csv", "examples/gallery.json"}) - files, set())
        names = {"test": {new_topic.suite_of(name.split("/")[1]) + ".IsToBeFilledIn" for name in self.made},
                 "figure": set(), "benchmark": set()}
        rows = self.text("docs/coverage.csv").splitlines()
        found = coverage_test.violations("\n".join([rows[0], *rows[-3:]]), names)
        self.assertEqual([re.sub(r"line \d+: ", "", violation) for violation in found],
                         [f"{new_topic.MARKER} an id is not of the form R001-012"] * 3)

    def test_lists_name_it_beside_its_family(self):
        topics, before = ([topic.path for topic in project.topics(root)] for root in (self.root, project.ROOT))
        self.assertEqual(topics[topics.index(IN_A_FAMILY) - 1], [path for path in before if path.startswith("clipping/")][-1])
        self.assertEqual([path for path in topics if path not in self.made], before)
        self.assertEqual(topics[-2:], [SHORTEST, LONGEST])
        for page, folder, end in (("README.md", "docs/topics/", ""), ("docs/README.md", "topics/", ""),
                                  ("docs/benchmarks.md", "topics/", "#charts")):
            link = rf"\]\({folder}clipping/\w+\.md{end}\),\s+\[Window\]\({folder}clipping/window\.md{end}\)\n"
            self.assertRegex(self.text(page), link)
            self.assertRegex(self.text(page), rf"\n *- f: \[Zz\]\({folder}f/zz\.md{end}\)\n")
        figures = list(topics_test.gallery(self.root).values())
        family = {path.split("/")[1] for path in before if path.startswith("clipping/")}
        self.assertIn(figures[figures.index("window") - 1], family)
        self.assertFalse(family & set(figures[figures.index("window"):]))
        self.assertEqual(lists.with_links(self.root, lists.titles(self.root)),
                         {path: self.text(path) for path, _ in lists.LINKS}, "as ./bootstrap lists writes them")

    def test_it_compiles_beside_topics_of_other_words(self):
        words = self.root / "words.hpp"
        words.write_text("".join(f"namespace gradus::{word} {{\nvoid entry();\n}}\n" for word in WORDS if word not in IN_A_FAMILY),
                         encoding="utf-8")
        self.addCleanup(words.unlink)
        includes = [word for folder in ("algorithms", "visualize", "pipeline", "tests") for word in ("-I", self.root / folder)]
        for path in self.sources(IN_A_FAMILY):
            with self.subTest(path):
                what = ["-include", self.root / path, "/dev/null"] if path.endswith(".hpp") else [self.root / path]
                project.run(project.COMPILER, "-std=c++20", "-fsyntax-only", "-x", "c++", *WARNINGS, *includes,
                            "-include", words, *what)


class Refusals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = copied(cls)

    def refused(self, *words):
        """The one line that says why; nothing is written."""
        before = state(self.root)
        with self.assertRaises(new_topic.Refusal) as refusal:
            new_topic.write(self.root, words)
        self.assertEqual(state(self.root), before, words)
        self.assertRegex(str(refusal.exception), r"\A[^\n]+\Z")
        return str(refusal.exception)

    def test_names(self):
        for words in ((), ("",), ("made_up",), ("clipping/",), ("/made_up",), ("clipping/made/up",),
                      ("Clipping/made_up",), ("clipping/MadeUp",), ("clipping/made-up",), ("clipping/2d",),
                      ("clipping/_area",), ("clipping/area_",), ("clipping/made__up",), ("../outside",), ("clipping/..",),
                      ("clipping/made_up", "clipping/another"), ("clipping/fläche",), ("clipping/made\nup",),
                      ("clipping/made_up\n",), ("--help",)):
            with self.subTest(words):
                self.assertIn("expected family/topic", self.refused(*words))
        for name in ("f" * (new_topic.LONGEST_FAMILY + 1) + "/t", "f/" + "t" * (new_topic.LONGEST_TOPIC + 1)):
            self.assertIn("at most", self.refused(name))

    def test_names_that_are_taken(self):
        for name, reason in (("clipping/liang_barsky", "there is a topic clipping/liang_barsky already"),
                             ("modeling/liang_barsky", "there is a topic clipping/liang_barsky already"),
                             ("modeling/textbook_chain", "there is a topic pipeline/textbook_chain already"),
                             ("clipping/figures", "'figures' can't be a topic: it is a command"), ("core/made_up", "'core' can't be a family"),
                             ("figure/made_up", "'figure' can't be a family"), ("class/made_up", "'class' can't be a family"),
                             ("clipping/template", "'template' can't be a topic"),
                             ("clipping/fmt", "'fmt' can't be a topic"), ("clipping/core", "'core' can't be a topic"),
                             ("clipping/exact_scalar", "'exact_scalar' can't be a topic"),
                             ("modeling/turn", "algorithms/core/arithmetic/turn.hpp uses that name"),
                             ("modeling/answers", "tests/benchmark/answers.hpp uses that name"),
                             ("modeling/ivec2", "algorithms/core/geometry.hpp uses that name"),
                             ("modeling/notation", "'notation' can't be a topic"),
                             ("modeling/fill", "visualize/cli/commands/commands.cpp uses that name"),
                             ("modeling/hidden_surfaces", "visualize/cli/commands/commands.cpp uses that name")):
            with self.subTest(name):
                self.assertIn(reason, self.refused(name))

    def test_words_of_others_are_no_names(self):
        topics = "".join(f"gradus_add_topic(shading/{word})\n" for word in WORDS)
        (self.root / "named/visualize").mkdir(parents=True)
        (self.root / "named/visualize/cli").symlink_to(self.root / "visualize/cli")
        (self.root / "named/CMakeLists.txt").write_text(topics, encoding="utf-8")
        self.addCleanup(shutil.rmtree, self.root / "named")
        self.assertEqual(layers_test.cli_violations(self.root / "named"), [])
        for word in WORDS:
            new_topic.check_names(self.root, "shading", word)

    def test_where_a_word_is_taken(self):
        for text, space, is_scope in (("namespace gradus {\nvoid light(int);\n}  // namespace gradus\n", "gradus", False),
                                      ("namespace gradus {\nnamespace {\nint light = 1;\n}  // namespace\n}  // namespace gradus\n",
                                       "gradus", False),
                                      ("namespace gradus::a::light {\n}  // namespace gradus::a::light\n", "gradus::a", True),
                                      ("namespace gradus::a {\n}  // namespace gradus::a\nnamespace gradus {\nusing light = int;\n",
                                       "gradus", True)):
            self.assertEqual(list(new_topic.declarations(text, "light")), [(space, is_scope)])
        self.assertEqual(list(new_topic.declarations("namespace gradus {\n// void light();\n  int light = 1;\n", "light")), [])

    def plant(self, path):
        """A file of the user's, until the test's end."""
        (self.root / path).write_text("Mine\n", encoding="utf-8")
        self.addCleanup((self.root / path).unlink)

    def test_a_file_that_is_there_is_kept(self):
        self.plant("docs/topics/clipping/window.md")
        self.assertEqual("docs/topics/clipping/window.md is there already; nothing was written", self.refused(IN_A_FAMILY))

    def test_what_goes_wrong_half_way_is_undone(self):
        self.plant("visualize/stories/f")  # no folder can be made there, and eight files come before
        self.assertRegex(self.refused(SHORTEST), "visualize/stories/f.*; nothing was written")

    def test_the_command_says_so_and_makes_topics(self):
        programs = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (programs / "python3").symlink_to(sys.executable)
        run = functools.partial(subprocess.run, stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8", cwd="/",
                                env={**os.environ, "PATH": f"{os.environ['PATH']}:{programs}"})
        done = run(["bash", self.root / "bootstrap", "new", "Clipping/area"])
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertRegex(done.stderr, r"\Abootstrap new: expected family/topic.*\n\Z")
        done = run(["bash", self.root / "bootstrap", "new", "clipping/made_by_command"])
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue((self.root / "algorithms/clipping/made_by_command/made_by_command.hpp").is_file())
        self.assertIn("./bootstrap new ", run(["bash", self.root / "bootstrap", "help"]).stderr)


if __name__ == "__main__":
    unittest.main()
