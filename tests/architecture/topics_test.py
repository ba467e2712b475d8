#!/usr/bin/env python3
"""A topic stands wherever people and programs look for topics, and nothing is left of the skeleton it was made from.

Its own five files are a rule of layers_test.py; here are its other files, and the lists that name all topics.
"""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import lists
import new_topic
import project

# Names in the lists that are no topics
OTHERS = {"core", "elementary", "engine", "engine_antialiasing", "engine_colours", "engine_pixels", "engine_triangles", "exact", "exact_areas", "figures",
          "hidden_surfaces", "pipeline", "plan", "read_obj", "render_antialiasing", "shared", "single_edges", "start",
          "textbook_chain"}
WITH_TEXT = {".cpp", ".hpp", ".txt", ".md", ".json", ".csv"}


def read(root, path):
    return (root / path).read_text(encoding="utf-8")


def files(folder, end):
    """The topics that have a file in this folder, or in one of its families."""
    return lambda root: {file.name.removesuffix(end) for file in (root / folder).rglob("*" + end)}


def gallery(root):
    return {figure["name"]: figure["topic"] for figure in json.loads(read(root, "examples/gallery.json"))["figures"]}


def covered(root):
    """The topics whose tests or figures the rows of the coverage name."""
    rows = list(csv.reader(read(root, "docs/coverage.csv").splitlines()))[1:]
    suites = {new_topic.suite_of(topic.name): topic.name for topic in project.topics(root)}
    figures = gallery(root)
    found = {figures[name] for *_, kind, name in rows if kind == "figure" and name in figures}
    for *_, name in rows:
        suite = max((suite for suite in suites if name.startswith(suite)), key=len, default=None)
        found |= {suites[suite]} if suite else set()
    return found


def in_schema(root):
    figure = json.loads(read(root, "docs/lecture.schema.json"))["$defs"]["figure"]
    return set(figure["properties"]["topic"]["enum"])


# Place -> the names of topics there, and what is to be done about one that is missing
PLACES = {
    "docs/coverage.csv": (covered, "add rows for what it promises to show"),
    "docs/lecture.schema.json": (in_schema, "run ./bootstrap lists"),
    "examples/gallery.json": (lambda root: set(gallery(root).values()), "add a figure"),
    "visualize/stories (English)": (files("visualize/stories", ".en.txt"), "write visualize/stories/{path}.en.txt"),
    "visualize/stories (German)": (files("visualize/stories", ".de.txt"), "write visualize/stories/{path}.de.txt"),
    "tests/stress": (files("tests/stress", "_stress.cpp"), "write its promises, tests/stress/{path}_stress.cpp"),
    "tests/benchmark": (files("tests/benchmark", "_benchmark.cpp"), "write tests/benchmark/{path}_benchmark.cpp"),
    "tests/architecture/machine_code": (files("tests/architecture/machine_code", ".cpp"),
                                        "write tests/architecture/machine_code/{name}.cpp, a function for each method"),
    "tests/golden/marks": (files("tests/golden/marks", ".txt"),
                           "run ./bootstrap lists, and look at the difference"),
    "tests/golden/trace_hashes.txt": (lambda root: {line.split()[2] for line in
                                                    read(root, "tests/golden/trace_hashes.txt").splitlines()},
                                      "run ./bootstrap lists, and look at the difference"),
}


def missing(root):
    """Each topic that is not PARTIAL in each place."""
    return [f"{place}: {topic.name} is missing; {advice.format(name=topic.name, path=topic.path)}"
            for place, (names, advice) in PLACES.items() for topic in project.topics(root)
            if not topic.partial and topic.name not in names(root)]


def unknown(root):
    """No place names a topic that doesn't exist."""
    known = {topic.name for topic in project.topics(root)} | OTHERS
    return [f"{place}: {name} is no topic; CMakeLists.txt has no gradus_add_topic line for it"
            for place, (names, _) in PLACES.items() for name in sorted(names(root) - known)]


def exact_methods():
    """Topic -> its methods that run in three arithmetics side by side, as the command takes them."""
    found = {}
    for topic in json.loads(project.run(project.COMMAND, "list", "--json"))["topics"]:
        for method in topic["methods"] if any(p["name"] == "exact" for p in topic["parameters"]) else []:
            said = subprocess.run([project.COMMAND, "run", topic["name"], "--method", method["name"], "--exact", "-q"],
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True).stderr
            if "--exact: expected one of the methods" not in said:
                found.setdefault(topic["name"], []).append(method["name"])
    return found


def listed_exact_methods(root):
    table = read(root, "docs/exact.md").split("## Which methods have it")[1]
    rows = re.findall(r"^\| (\w+(?:, \w+)*) \| (\w+(?:, \w+)*) \|$", table, re.MULTILINE)
    return {topic: methods.split(", ") for topics, methods in rows for topic in topics.split(", ") if topic != "topic"}


def left_to_fill_in(root):
    """What ./bootstrap new has left to the author, line by line."""
    found = []
    for folder in ("algorithms", "docs", "examples", "pipeline", "tests", "visualize"):
        for file in sorted((root / folder).rglob("*")):
            path = file.relative_to(root).as_posix()
            if file.suffix not in WITH_TEXT or path.startswith(new_topic.SKELETON + "/") or path == new_topic.PAGE:
                continue
            found += [f"{path}:{number}: {line.strip()}" for number, line in
                      enumerate(file.read_text(encoding="utf-8").splitlines(), 1) if new_topic.MARKER in line]
    return found


class Topics(unittest.TestCase):
    def none(self, found):
        if found:
            self.fail("\n" + "\n".join(found))

    def test_every_topic_stands_in_every_place(self):
        self.assertGreater(sum(not topic.partial for topic in project.topics()), 10)
        self.none(missing(project.ROOT))

    def test_documents_list_the_topics_as_they_are(self):
        self.assertEqual(list(lists.out_of_date(project.ROOT)), [], "run ./bootstrap lists")

    def test_no_place_names_another(self):
        self.none(unknown(project.ROOT))

    def test_the_page_on_exact_runs_lists_their_methods(self):
        self.assertEqual(listed_exact_methods(project.ROOT), exact_methods(), "the table of docs/exact.md")

    def test_a_page_says_which_topics_are_copied_together(self):
        for topic in project.topics():
            others = " and ".join(f"`{name}`" for name in topic.depends)
            if others:
                self.assertIn(f"of `{topic.name}` also {others}", read(project.ROOT, "docs/source.md"))

    def test_nothing_is_left_to_be_filled_in(self):
        self.none(left_to_fill_in(project.ROOT))


class Planted(unittest.TestCase):
    """A small project with one topic in all places, and one fault after the other."""

    def setUp(self):
        self.root = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for path, text in {
                "CMakeLists.txt": "gradus_add_topic(lines/a_line)\ngradus_add_topic(lines/half_done PARTIAL)\n",
                "docs/coverage.csv": "id,statement,kind,name\nR001-001,It ends.,test,ALine.Ends\n",
                "docs/lecture.schema.json": json.dumps({"$defs": {"figure": {"properties": {"topic": {"enum": ["a_line"]}}}}}),
                "examples/gallery.json": json.dumps({"figures": [{"name": "line", "topic": "a_line"}]}),
                "visualize/stories/lines/a_line.en.txt": "[a_line]\n",
                "visualize/stories/lines/a_line.de.txt": "[a_line]\n",
                "tests/stress/lines/a_line_stress.cpp": "",
                "tests/benchmark/lines/a_line_benchmark.cpp": "",
                "tests/architecture/machine_code/a_line.cpp": "",
                "tests/golden/marks/a_line.txt": "",
                "tests/golden/trace_hashes.txt": "12 34 a_line walk, from here\n",
        }.items():
            self.write(path, text)

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding="utf-8")

    def test_the_small_project_is_without_fault(self):
        self.assertEqual(missing(self.root) + unknown(self.root) + left_to_fill_in(self.root), [])

    def test_a_topic_missing_in_any_place_is_named_with_what_to_do(self):
        cmake = read(self.root, "CMakeLists.txt")
        self.write("CMakeLists.txt", cmake + "gradus_add_topic(lines/b_line)\n")
        found = missing(self.root)
        self.assertEqual([line.split(": ")[0] for line in found], list(PLACES))
        for line in found:
            self.assertRegex(line, r"^\S+(?: \(\w+\))?: b_line is missing; (?:add|run|write) ")

    def test_a_coverage_row_may_name_a_figure(self):
        self.write("docs/coverage.csv", "id,statement,kind,name\nR001-001,It ends.,figure,line\n")
        self.assertEqual(missing(self.root), [])
        self.write("docs/coverage.csv", "id,statement,kind,name\nR001-001,It ends.,figure,circle\n")
        self.assertEqual(len(missing(self.root)), 1)

    def test_a_name_that_is_no_topic_is_found_in_every_place(self):
        self.write("CMakeLists.txt", "gradus_add_topic(lines/half_done PARTIAL)\n")
        # The coverage names tests, which other scripts know
        self.assertEqual([line.split(": ")[0] for line in unknown(self.root)],
                         [place for place in PLACES if place != "docs/coverage.csv"])

    def test_what_is_left_to_be_filled_in_is_found(self):
        self.write("docs/topics/lines/a_line.md", f"# A line\n\n- {new_topic.MARKER}: a source\n")
        self.write(new_topic.PAGE, f"Until no {new_topic.MARKER} is left.\n")
        self.assertEqual(left_to_fill_in(self.root), [f"docs/topics/lines/a_line.md:3: - {new_topic.MARKER}: a source"])


if __name__ == "__main__":
    unittest.main()
