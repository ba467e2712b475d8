#!/usr/bin/env python3
"""One topic and core/, copied into an empty folder, build and run there: no build system, no exceptions."""
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project
from share import share_of

TOPIC = "scan_conversion/bresenham_line"
OUTER = {"image.cpp", "exact_scalar.cpp"}  # targets of their own, with libraries of their own
PROGRAM = """
#include <cstdio>
#include "scan_conversion/bresenham_line/bresenham_line.hpp"

int main() {
  // What the reader would write first: the pixels, and how often the line stepped
  int stepped = 0;
  auto count = [&](const auto& step) { stepped += requires { step.p_before; }; };
  gradus::bresenham_line::decision_parameter(
      {0, 0}, {7, 3}, [](glm::ivec2 p) { std::printf("%d,%d ", p.x, p.y); }, count);
  std::printf("%d\\n", stepped);
}
"""
EXPECTED = "0,0 1,0 2,1 3,1 4,2 5,2 6,3 7,3 7\n"


class CopyOneTopic(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def copy(self, path):
        shutil.copytree(project.ROOT / "algorithms" / path, self.folder / path)

    def flags(self):
        return ["-std=c++20", "-ffp-contract=off", "-fno-exceptions", "-Wall", "-Wextra", "-Werror",
                "-Wno-restrict" if "clang" not in project.COMPILER else "-Wall", f"-I{self.folder}"]

    def compile(self, *arguments):
        return project.run(project.COMPILER, *self.flags(), *arguments, cwd=self.folder)

    def test_builds_and_runs_alone(self):
        self.copy("core")
        self.copy(TOPIC)
        (self.folder / "main.cpp").write_text(PROGRAM, encoding="utf-8")
        core = sorted(f for f in (self.folder / "core").rglob("*.cpp") if f.name not in OUTER)
        self.assertGreater(len(core), 0)
        self.compile("main.cpp", *core, "-o", "program", "-lfmt")
        self.assertEqual(project.run(self.folder / "program"), EXPECTED)

    def test_every_topic_compiles_with_its_dependencies_only(self):
        topics = {topic.name: topic for topic in project.topics()}
        self.copy("core")

        def needed(topic):
            return {topic.path}.union(*(needed(topics[name]) for name in topic.depends))

        # Each may include all of core, and each of its headers compiles alone
        core = [h.relative_to(self.folder) for h in sorted((self.folder / "core").rglob("*.hpp"))
                if not h.name.endswith("-inl.hpp")]
        precompiled = project.precompiled(self.folder, project.COMPILER, *self.flags(), headers=core)
        for topic in share_of(topics.values(), 5):
            with self.subTest(topic.name):
                for path in needed(topic):
                    self.copy(path)
                # Batches are made for the machine they run on
                headers = [header for header in sorted((self.folder / topic.path).glob("*.hpp"))
                           if not header.name.endswith("_batch.hpp")]
                self.assertGreater(len(headers), 0)
                included = [word for header in headers for word in ("-include", header)]
                self.compile("-fsyntax-only", *precompiled, "-x", "c++", *included, "/dev/null")
                for path in needed(topic):
                    shutil.rmtree(self.folder / path)


if __name__ == "__main__":
    unittest.main()
