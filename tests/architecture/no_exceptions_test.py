#!/usr/bin/env python3
"""What runs in a browser builds without exceptions, threads and files: figures, themes, stories, JSON, requests, topics with
Exact, the pipeline over bytes in memory.

The module of live pages (preset live) is that build: Clang compiles and links all of it for WebAssembly. Here it is seen
to hold what it should; browser/live sees that it says what the gradus command says. Where the module is not built, the
build's compiler reads all of it without exceptions.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

ALONE = "visualize/stories/clipping/polygon_circle_story.cpp"  # its algorithm takes over another topic's entry()
OUTER = {"algorithms/core/image.cpp", "pipeline/scene/files.cpp"}  # PNG, files
THREADED = "pipeline/engine/"  # a page has one thread, and draws by the textbook chain
MODULE = {"visualize/live/module.cpp", "visualize/live/runtime.cpp"}  # WebAssembly's alone
ROOTS = ("visualize", "algorithms", "pipeline")
FLAGS = ["-std=c++20", "-fno-exceptions", "-ffp-contract=off", "-w", f"-I{project.ROOT}",
         *(f"-I{project.ROOT / root}" for root in ROOTS), f"-I{project.MADE_HEADERS}"]
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def matching(*patterns):
    found = {path.relative_to(project.ROOT).as_posix() for pattern in patterns for path in project.ROOT.glob(pattern)}
    return sorted(path for path in found - OUTER - MODULE if not path.startswith(THREADED))


def units():
    """All that a page may need, in units: files that are compiled together."""
    layers = [matching(f"visualize/{layer}/**/*.cpp") for layer in ("figure", "theme", "json", "request", "live")]
    headers = matching(*(f"algorithms/{topic.path}/*.hpp" for topic in project.topics()))
    told = matching("visualize/stories/*.cpp")  # what stories share
    stories = [path for path in matching("visualize/stories/*/**/*.cpp") if path != ALONE]
    return [matching("algorithms/core/**/*.cpp"), *filter(None, layers), told,
            [path for path in headers if not path.endswith(("_batch.hpp", "-inl.hpp"))],
            matching("pipeline/*/**/*.cpp", "pipeline/*.hpp", "pipeline/stages/*.hpp"), stories, [ALONE]]


def built(folder):
    """The files that a build compiles without exceptions, and the headers among them that a made file includes."""
    found = set()
    for step in json.loads((folder / "compile_commands.json").read_text(encoding="utf-8")):
        if "-fno-exceptions" not in step["command"].split():
            continue
        file = pathlib.Path(step["file"])
        files = [file]
        if file.is_relative_to(folder):  # made by the build: several files at once, every header
            files = [project.ROOT / name for name in INCLUDE.findall(file.read_text(encoding="utf-8"))]
        found |= {path.resolve().relative_to(project.ROOT).as_posix() for path in files
                  if path.resolve().is_relative_to(project.ROOT)}
    return found


class NoExceptions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    def reads(self, source, required=False):
        """Whether the build's compiler can read a file without exceptions."""
        command = list(map(str, [project.COMPILER, *FLAGS, "-fsyntax-only", "-x", "c++", project.ROOT / source]))
        if required:
            with self.subTest(source):
                project.run(*command)
            return True
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode == 0

    def read_all(self, files):
        """Reads them together; where they can't be, their halves."""
        if len(files) == 1:
            self.reads(files[0], required=True)
        elif not self.reads(self.write("unit.cpp", "".join(f'#include "{file}"\n' for file in files))):
            half = len(files) // 2
            self.read_all(files[:half])
            self.read_all(files[half:])

    def test_the_lists_hold_what_they_promise(self):
        files = sum(units(), [])
        self.assertEqual(len(files), len(set(files)))
        for path in ("algorithms/core/arithmetic/exact_scalar.cpp", "visualize/figure/layout/layout.cpp",
                     "visualize/stories/telling.cpp", "visualize/json/json.cpp", "visualize/request/inputs.cpp",
                     "visualize/live/protocol.cpp", "pipeline/scene/models/obj.cpp", "pipeline/pipeline.hpp"):
            self.assertIn(path, files)
        for topic in project.topics():
            self.assertIn(f"algorithms/{topic.path}/{topic.name}.hpp", files)
            story = f"visualize/stories/{topic.path}_story.cpp"
            self.assertEqual(story in files, (project.ROOT / story).is_file())

    def test_a_throw_is_found(self):
        include = '#include "core/refusal.hpp"\n'
        self.assertTrue(self.reads(self.write("plain.cpp", include)))
        self.assertFalse(self.reads(self.write("planted.cpp", include + 'void fail() { throw gradus::InputError("no"); }\n')))

    def test_the_module_is_all_of_it(self):
        folder = project.live_build()
        if not folder:
            self.skipTest("the module is not built: ./bootstrap live")
        self.assertEqual((folder / "gradus.wasm").read_bytes()[:4], b"\0asm")
        missing = set(sum(units(), [])) - built(folder)
        self.assertEqual(missing, set(), "the build of the module leaves these out")
        self.assertLessEqual(MODULE, built(folder))

    def test_all_of_it_is_read_without_exceptions(self):
        if project.live_build():
            return  # Clang has compiled it
        for files in units():
            self.read_all(files)


if __name__ == "__main__":
    unittest.main()
