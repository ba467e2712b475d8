#!/usr/bin/env python3
"""Who may include and use what. The rules come first; each is then shown to catch a planted violation."""
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

# Layers of visualize/ and what each may include besides itself and algorithms/core
LAYERS = {
    "figure": set(),
    "theme": {"figure"},
    "stories": {"figure", "topics", "pipeline"},  # roles, not colours: no theme
    "cairo": {"figure", "theme"},
    "text": {"figure", "theme"},
    "plot": {"figure", "theme"},
    "office": {"figure", "theme"},
    "worksheet": {"figure", "stories", "text"},
    "json": {"figure", "stories"},  # no look: what a page in a browser is told, too
    "request": {"figure", "stories", "json", "pipeline"},
    "source": {"figure", "stories"},
    "check": {"figure", "stories", "json", "request", "pipeline"},
    "live": {"figure", "stories", "json", "request", "pipeline"},
    "web": {"figure", "theme", "stories", "json", "cairo"},  # the letters in a page
    "cli": {"figure", "theme", "stories", "json", "request", "check", "source", "cairo", "text", "worksheet", "plot", "web", "office",
            "pipeline"},
}

# Packages: include prefix -> the file or folder that may name it
PACKAGES = {
    "cairo": "visualize/cairo/",
    "fontconfig/": "visualize/cairo/",
    "pango/": "visualize/cairo/any_script.cpp",
    "zlib.h": "visualize/cairo/deflated.cpp",
    "CLI/": "visualize/cli/",
    "nlohmann/": "visualize/json/",
    "boost/": "algorithms/core/arithmetic/exact_scalar.cpp",
    "png.h": "algorithms/core/image.cpp",
    "hwy/": ("algorithms/", "pipeline/engine/"),
    "tbb/": "pipeline/engine/",
    "cmark-gfm": "visualize/web/topic_page.cpp",
    "archive": "visualize/cli/files/zip.cpp",
    "jpeglib.h": "visualize/cairo/jpeg.cpp",
    "jerror.h": "visualize/cairo/jpeg.cpp",
    "turbojpeg.h": "tests/",
    "assimp/": "visualize/cli/models/imported_",
    "tiny_obj_loader.h": "tests/",
}
ONE_FILE = ("zlib.h", "pango/", "CLI/", "boost/", "png.h", "cmark-gfm", "archive", "jpeglib.h")  # heavy or confined: a single .cpp
ORACLES = ("zlib.h", "boost/", "png.h", "nlohmann/", "hwy/", "cairo", "assimp/")  # tests and benchmarks use them too
BATCH_ONLY = ("hwy/",)  # SIMD: nothing that a reader of the algorithm sees

# Not in algorithms/: they don't exist everywhere the algorithms run
NOT_PORTABLE = {"iostream", "fstream", "sstream", "iomanip", "thread", "mutex", "shared_mutex", "condition_variable",
                "future", "filesystem", "locale", "regex", "source_location", "format"}
# Files that need more than the rest of core, targets of their own
OUTER = {"algorithms/core/image.cpp", "algorithms/core/arithmetic/exact_scalar.cpp"}

# Libraries differ in the last bit of these; core/elementary and our own matrices don't
NOT_THE_SAME_EVERYWHERE = re.compile(
    r"\bstd::(?:sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot)"
    r"[fl]?\b|\bglm::(?:rotate|perspective|lookAt|sin|cos|tan|asin|acos|atan|exp|log|pow)\w*")

# What a page in a browser runs too, with another library below
SAME_EVERYWHERE = ("algorithms", "pipeline", *(f"visualize/{layer}" for layer in ("figure", "stories", "json", "request", "live")))
OWN_ARITHMETIC = "pipeline/engine/"  # not in a page, and held to the chain by tests

LISTED_WIDTH = 34


def zone_of(path):
    """algorithms/core/… -> core; algorithms/F/T/… -> topic F/T; visualize/x/… -> x; else the top folder."""
    parts = path.split("/")
    if parts[0] == "algorithms":
        return "core" if parts[1] == "core" else "/".join(parts[1:3])
    return parts[1] if parts[0] == "visualize" else parts[0]


def allowed(zone, topics):
    """The zones a zone may include."""
    names = {topic.path for topic in topics}
    by_name = {topic.name: topic.path for topic in topics}
    if zone in ("tests", "examples"):
        return {"core", "pipeline", *names, *LAYERS, zone}
    if zone == "core":
        return {"core"}
    if zone == "pipeline":
        return {"core", "pipeline", *names}
    if zone in LAYERS:
        return {"core", zone, *LAYERS[zone], *(names if "topics" in LAYERS[zone] else ())}
    depends = next((topic.depends for topic in topics if topic.path == zone), ())
    return {"core", zone, *(by_name.get(name, name) for name in depends)}


def include_violations(root):
    topics = project.topics(root)
    found = []
    users = {}
    for file in project.sources(root, "algorithms", "pipeline", "visualize", "examples", "tests"):
        path = file.relative_to(root).as_posix()
        zone = zone_of(path)
        for number, line in enumerate(file.read_text(encoding="utf-8").split("\n"), 1):
            match = re.match(r"\s*#\s*include\s*([<\"])([^>\"]+)", line)
            if not match:
                continue
            kind, name = match.groups()
            place = f"{path}:{number}"
            if kind == "<":
                for prefix, home in PACKAGES.items():
                    if not name.startswith(prefix):
                        continue
                    if zone == "tests" and prefix in ORACLES:
                        continue
                    if not path.startswith(home):
                        found.append(f"{place}: <{name}> belongs into {home}")
                    elif prefix in BATCH_ONLY and not path.endswith(("_batch.cpp", "-inl.hpp")):
                        found.append(f"{place}: <{name}> belongs into a _batch.cpp or what they share, an -inl.hpp")
                    users.setdefault(prefix, set()).add(path)
                if path.startswith("algorithms/") and name in NOT_PORTABLE and path not in OUTER \
                        and not path.endswith("_batch.cpp"):
                    found.append(f"{place}: <{name}> is not portable, algorithms do without it")
                continue
            # A header that is made of a topic's faults has their place
            files = (name, name.replace("_notes.hpp", ".faults"))
            target = next((r for r in ("algorithms", "visualize", "pipeline", "tests")
                           if any((root / r / file).is_file() for file in files)), None)
            if target is None:
                found.append(f"{place}: \"{name}\" is in none of the include roots")
            elif zone_of(f"{target}/{name}") not in allowed(zone, topics):
                found.append(f"{place}: {zone} may not include {zone_of(f'{target}/{name}')}")
    for prefix in ONE_FILE:
        files = sorted(f for f in users.get(prefix, ()) if f.startswith(PACKAGES[prefix]))
        if len(files) > 1 or any(not f.endswith(".cpp") for f in files):
            found.append(f"<{prefix}…> is included by {', '.join(files)}: one .cpp only")
    return found


def arithmetic_violations(root):
    found = []
    for file in project.sources(root, *SAME_EVERYWHERE):
        if file.relative_to(root).as_posix().startswith(OWN_ARITHMETIC):
            continue
        for number, line in enumerate(project.without_comments(file.read_text(encoding="utf-8")).split("\n"), 1):
            match = NOT_THE_SAME_EVERYWHERE.search(line)
            if match:
                found.append(f"{file.relative_to(root).as_posix()}:{number}: {match.group(0)} differs between "
                             "libraries, use core/elementary")
    return found


def mirror_violations(root):
    """One topic, five mirrored files; and no such file without its topic."""
    found = []
    topics = project.topics(root)
    for topic in topics:
        for path in (f"algorithms/{topic.path}/{topic.name}.hpp", f"visualize/stories/{topic.path}_story.cpp",
                     f"tests/unit/{topic.path}_test.cpp", f"examples/{topic.path}.cpp",
                     f"docs/topics/{topic.path}.md"):
            if not topic.partial and not (root / path).is_file():
                found.append(f"{path} is missing: it is one of the five files of {topic.name}")
    known = {topic.path for topic in topics}
    alone = project.stories(root)
    for path in alone:
        if not (root / f"visualize/stories/{path}_story.cpp").is_file():
            found.append(f"visualize/stories/{path}_story.cpp is missing: gradus_add_story names it")
    chapters = {path.split("/")[0] for path in alone}  # their folders hold what such a story needs beside it
    for pattern, name in (("algorithms/*/*/", r"algorithms/(.+)"), ("visualize/stories/*/*_story.cpp", r"visualize/stories/(.+)_story\.cpp"),
                          ("examples/*/*.cpp", r"examples/(.+)\.cpp"), ("docs/topics/*/*.md", r"docs/topics/(.+)\.md")):
        for file in sorted(root.glob(pattern)):
            path = file.relative_to(root).as_posix()
            if path.startswith("algorithms/core/"):
                continue
            story = pattern.startswith(("visualize/", "docs/")) and re.fullmatch(name, path).group(1).split("/")[0] in chapters
            if re.fullmatch(name, path).group(1) not in known and not story:
                found.append(f"{path}: no gradus_add_topic line in CMakeLists.txt names its topic")
    return found


def cli_violations(root):
    """The command knows topics only through the catalogue."""
    words = re.compile("|".join(f"({project.naming(topic.name)})" for topic in project.topics(root)))
    names = [topic.name for topic in project.topics(root)]
    found = []
    for file in project.sources(root, "visualize/cli"):
        for number, line in enumerate(file.read_text(encoding="utf-8").split("\n"), 1):
            match = words.search(line)
            if match:
                found.append(f"{file.relative_to(root).as_posix()}:{number}: names the topic {names[match.lastindex - 1]}")
    return found


def observer_violations(root):
    """Observers are called in one form only, and taken by O&&."""
    found = []
    topics = [file for topic in project.topics(root) for file in project.topic_headers(topic, root)]
    for file in topics + project.sources(root, "pipeline"):
        for number, line in enumerate(project.without_comments(file.read_text(encoding="utf-8")).split("\n"), 1):
            place = f"{file.relative_to(root).as_posix()}:{number}"
            if project.OBSERVER_CALL.search(line) and not project.OBSERVER_LINE.match(line.rstrip()):
                found.append(f"{place}: not of the form `if constexpr (observed<O>) observer(…);` on one line")
            if re.search(r"\bO\s+observer\b", line):
                found.append(f"{place}: the observer is taken by value, take O&&")
    return found


def width_violations(root):
    """What a figure can list (the methods a story names) fits beside two drawings: 34 columns without the function's
    indentation and trailing comments."""
    found = []
    for topic in project.topics(root):
        story = root / f"visualize/stories/{topic.path}_story.cpp"
        named = set(re.findall(r'"(\w+)"', story.read_text(encoding="utf-8"))) if story.is_file() else None
        for file in project.topic_headers(topic, root):
            text = project.without_signs(file.read_text(encoding="utf-8"))
            lines = text.split("\n")
            code = project.without_comments(text).split("\n")
            for function in project.observed_functions(text):
                if named is not None and function.name not in named:
                    continue
                body = range(function.first, function.last)
                indent = min(len(lines[n]) - len(lines[n].lstrip()) for n in body if lines[n].strip())
                plumbing = 0  # parentheses of an expects that goes on
                for n in body:
                    bare = code[n].strip()
                    if plumbing > 0 or bare.startswith(("expects(", "if constexpr (observed<", "Tally<O, ")):
                        plumbing += bare.count("(") - bare.count(")")
                        continue
                    # A comment on a line of its own is listed, a trailing one drops first, as does a hand-over
                    shown = (lines[n] if not bare else lines[n][:len(code[n].rstrip())])[indent:].rstrip()
                    shown = shown.replace(", observer)", ")").replace(", tally)", ")")
                    if len(shown) > LISTED_WIDTH:
                        found.append(f"{file.relative_to(root).as_posix()}:{n + 1}: {function.name} has a line of "
                                     f"{len(shown)} columns, {LISTED_WIDTH} fit")
    return found


RULES = (include_violations, arithmetic_violations, mirror_violations, cli_violations, observer_violations,
         width_violations)


class Project(unittest.TestCase):
    """The project itself keeps every rule."""


def make_test(rule):
    def test(self):
        found = rule(project.ROOT)
        self.assertEqual(found, [], "\n" + "\n".join(found))
    return test


for rule in RULES:
    setattr(Project, "test_" + rule.__name__, make_test(rule))


HEADER = """#pragma once
#include "core/observe.hpp"
namespace gradus::a_line {
/// Draws.
template <class Plot, Observer<int> O = Unobserved>
void draw(int from, Plot&& plot, O&& observer = {}) {
  plot(from);  // a trailing comment may be as long as it likes
  if constexpr (observed<O>) observer(Stepped{from, from, from, from});
}
}  // namespace gradus::a_line
"""


class Planted(unittest.TestCase):
    """A small project without fault, and one fault after the other."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for path, text in {
                "CMakeLists.txt": "gradus_add_topic(lines/a_line)\ngradus_add_topic(lines/b_line DEPENDS a_line PARTIAL)\n",
                "algorithms/core/observe.hpp": "#pragma once\n#include <concepts>\n",
                "algorithms/core/arithmetic/exact_scalar.cpp": "#include <boost/rational.hpp>\n",
                "algorithms/lines/a_line/a_line.hpp": HEADER,
                "algorithms/lines/b_line/b_line.hpp": '#pragma once\n#include "lines/a_line/a_line.hpp"\n',
                "visualize/figure/figure.hpp": '#include "core/observe.hpp"\n',
                "visualize/theme/theme.hpp": '#include "figure/figure.hpp"\n',
                "visualize/stories/topic.hpp": '#include "figure/figure.hpp"\n',
                "visualize/stories/lines/a_line_story.cpp": '#include "lines/a_line/a_line.hpp"\n#include "stories/topic.hpp"\nauto listed = "draw";\n',
                "visualize/cairo/out.cpp": '#include <cairo.h>\n#include "theme/theme.hpp"\n',
                "visualize/json/json.cpp": '#include <nlohmann/json.hpp>\n#include "stories/topic.hpp"\n',
                "visualize/cli/main.cpp": '#include <CLI/CLI.hpp>\n#include "stories/topic.hpp"\n',
                "tests/unit/lines/a_line_test.cpp": '#include "lines/a_line/a_line.hpp"\n#include <boost/rational.hpp>\n',
                "examples/lines/a_line.cpp": '#include "lines/a_line/a_line.hpp"\n',
                "docs/topics/lines/a_line.md": "",
        }.items():
            self.write(path, text)

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding="utf-8")

    def caught(self, *expected):
        """Exactly one violation, and it says all of these."""
        found = [violation for rule in RULES for violation in rule(self.root)]
        self.assertEqual(len(found), 1, found)
        for text in expected:
            self.assertIn(text, found[0])

    def append(self, path, text):
        self.write(path, (self.root / path).read_text(encoding="utf-8") + text)

    def test_the_small_project_is_without_fault(self):
        self.assertEqual([v for rule in RULES for v in rule(self.root)], [])

    def test_core_includes_a_topic(self):
        self.append("algorithms/core/observe.hpp", '#include "lines/a_line/a_line.hpp"\n')
        self.caught("observe.hpp:3", "core may not include lines/a_line")

    def test_a_topic_includes_one_it_does_not_name(self):
        self.append("algorithms/lines/a_line/a_line.hpp", '#include "lines/b_line/b_line.hpp"\n')
        self.caught("lines/a_line may not include lines/b_line")

    def test_a_topic_includes_the_visualizer(self):
        self.append("algorithms/lines/b_line/b_line.hpp", '#include "figure/figure.hpp"\n')
        self.caught("lines/b_line may not include figure")

    def test_figure_includes_a_theme(self):
        self.append("visualize/figure/figure.hpp", '#include "theme/theme.hpp"\n')
        self.caught("figure may not include theme")

    def test_a_story_includes_a_theme(self):
        self.append("visualize/stories/lines/a_line_story.cpp", '#include "theme/theme.hpp"\n')
        self.caught("stories may not include theme")

    def test_cairo_includes_stories(self):
        self.append("visualize/cairo/out.cpp", '#include "stories/topic.hpp"\n')
        self.caught("cairo may not include stories")

    def test_the_command_includes_a_topic(self):
        self.write("visualize/cli/commands/run.cpp", '#include "lines/b_line/b_line.hpp"\n')
        found = [v for rule in RULES for v in rule(self.root)]
        self.assertTrue(any("cli may not include lines/b_line" in v for v in found), found)

    def test_an_include_from_no_root(self):
        self.append("visualize/cairo/out.cpp", '#include "out.hpp"\n')
        self.write("visualize/cairo/out.hpp", "")
        self.caught("none of the include roots")

    def test_cairo_outside_its_folder(self):
        self.append("visualize/figure/figure.hpp", "#include <cairo.h>\n")
        self.caught("<cairo.h> belongs into visualize/cairo/")

    def test_boost_in_a_second_file(self):
        self.append("algorithms/lines/a_line/a_line.hpp", "#include <boost/rational.hpp>\n")
        self.caught("belongs into algorithms/core/arithmetic/exact_scalar.cpp")

    def test_a_heavy_header_in_two_files(self):
        self.write("visualize/cli/options.cpp", "#include <CLI/App.hpp>\n")
        self.caught("<CLI/…> is included by visualize/cli/main.cpp, visualize/cli/options.cpp")

    def test_a_heavy_header_in_a_header(self):
        (self.root / "visualize/cli/main.cpp").unlink()
        self.write("visualize/cli/options.hpp", "#include <CLI/App.hpp>\n")
        self.caught("one .cpp only")

    def test_json_library_in_a_story(self):
        self.append("visualize/stories/lines/a_line_story.cpp", "#include <nlohmann/json.hpp>\n")
        self.caught("belongs into visualize/json/")

    def test_markdown_library_in_the_command(self):
        self.append("visualize/cli/main.cpp", "#include <cmark-gfm-core-extensions.h>\n")
        self.caught("belongs into visualize/web/topic_page.cpp")

    def test_zip_library_in_a_page(self):
        self.append("visualize/stories/lines/a_line_story.cpp", "#include <archive_entry.h>\n")
        self.caught("belongs into visualize/cli/files/zip.cpp")

    def test_command_line_library_in_a_test(self):
        self.append("tests/unit/lines/a_line_test.cpp", "#include <CLI/CLI.hpp>\n")
        self.caught("belongs into visualize/cli/")

    def test_iostream_in_algorithms(self):
        self.append("algorithms/core/observe.hpp", "#include <iostream>\n")
        self.caught("<iostream> is not portable")

    def test_library_sine_in_algorithms(self):
        self.append("algorithms/core/observe.hpp", "inline double f(double x) { return std::sin(x); }\n")
        self.caught("std::sin differs")

    def test_a_story_takes_a_length_from_a_library(self):
        self.append("visualize/stories/topic.hpp", "inline double f(double x) { return std::hypot(x, x); }\n")
        self.caught("std::hypot differs")

    def test_library_sine_in_a_comment_is_none(self):
        self.append("algorithms/core/observe.hpp", "// std::sin(x) and \"glm::rotate\"\n")
        self.test_the_small_project_is_without_fault()

    def test_glm_look_at(self):
        self.append("algorithms/core/observe.hpp", "inline auto m = glm::lookAtLH(a, b, c);\n")
        self.caught("glm::lookAtLH differs")

    def test_one_of_the_five_is_missing(self):
        for path in ("visualize/stories/lines/a_line_story.cpp", "tests/unit/lines/a_line_test.cpp",
                     "examples/lines/a_line.cpp", "docs/topics/lines/a_line.md"):
            with self.subTest(path):
                text = (self.root / path).read_text(encoding="utf-8")
                (self.root / path).unlink()
                self.caught(path + " is missing")
                self.write(path, text)

    def test_a_story_without_a_topic(self):
        self.write("visualize/stories/lines/c_line_story.cpp", "")
        self.caught("lines/c_line_story.cpp: no gradus_add_topic line")

    def test_a_story_of_the_visualizer_alone(self):
        self.append("CMakeLists.txt", "gradus_add_story(chains/a_chain)\n")
        self.caught("visualize/stories/chains/a_chain_story.cpp is missing")
        self.write("visualize/stories/chains/a_chain_story.cpp", "")
        self.write("visualize/stories/chains/its_views.cpp", "")
        self.test_the_small_project_is_without_fault()

    def test_a_folder_without_a_topic(self):
        self.write("algorithms/lines/c_line/c_line.hpp", "")
        self.caught("algorithms/lines/c_line: no gradus_add_topic line")

    def test_the_command_names_a_topic(self):
        self.append("visualize/cli/main.cpp", '// e.g. "a-line"\n')
        self.caught("main.cpp:3: names the topic a_line")

    def test_the_command_names_a_topic_of_one_word(self):
        self.append("CMakeLists.txt", "gradus_add_topic(lines/light PARTIAL)\n")
        self.write("algorithms/lines/light/light.hpp", "")
        self.write("visualize/cli/wish.cpp", 'double light = 0;  // how much light there is\nconst char* flag = "light";\n')
        self.test_the_small_project_is_without_fault()
        for line in ('const TopicEntry& entry = *find_entry("light");', "light::shine();", '"gradus run light --method off"',
                     'if (topic.name == "light")', 'return "light" == entry.name;'):
            with self.subTest(line):
                self.write("visualize/cli/wish.cpp", line + "\n")
                self.caught("wish.cpp:1: names the topic light")

    def test_an_observer_line_of_another_form(self):
        self.write("algorithms/lines/a_line/a_line.hpp", HEADER.replace("if constexpr (observed<O>) observer(Stepped{from, from, from, from})", "observer(Stepped{from})"))
        self.caught("a_line.hpp:8: not of the form")

    def test_an_observer_line_on_two_lines(self):
        self.write("algorithms/lines/a_line/a_line.hpp", HEADER.replace("observer(Stepped{", "observer(\n    Stepped{"))
        self.caught("a_line.hpp:8: not of the form")

    def test_an_observer_line_of_another_form_in_the_pipeline(self):
        self.write("pipeline/stages/1_input.hpp", HEADER.replace("if constexpr (observed<O>) observer", "observer"))
        self.caught("1_input.hpp:8: not of the form")

    def test_the_oracle_of_models_outside_tests(self):
        self.write("pipeline/scene/models/obj.cpp", "#include <tiny_obj_loader.h>\n")
        self.caught("<tiny_obj_loader.h> belongs into tests/")

    def test_an_observer_by_value(self):
        self.write("algorithms/lines/a_line/a_line.hpp", HEADER.replace("O&& observer", "O observer"))
        self.caught("a_line.hpp:6: the observer is taken by value")

    def test_a_line_too_wide_for_a_slide(self):
        code = "  plot(" + "1 + " * 6 + "100);"  # 34 columns without the indentation
        self.assertEqual(len(code) - 2, 34)
        text = HEADER.replace("  plot(from);", code)
        self.write("algorithms/lines/a_line/a_line.hpp", text)
        self.test_the_small_project_is_without_fault()
        self.write("algorithms/lines/a_line/a_line.hpp", text.replace("100);", "1000);"))
        self.caught("a_line.hpp:7: draw has a line of 35 columns")


if __name__ == "__main__":
    unittest.main()
