#!/usr/bin/env python3
"""What will run in a browser builds without exceptions: figures, themes, stories, JSON, topics with Exact, the pipeline
over bytes in memory. Clang compiles all of it for WebAssembly, where there are no threads and no files either; where
WebAssembly is not there, the build's compiler does.

A program of two topics is linked, natively and for WebAssembly. It says what the gradus command says, and what it
refuses reaches its host.
"""
import functools
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

PROGRAM = pathlib.Path(__file__).resolve().parent / "no_exceptions/main.cpp"
TOPICS = ("scan_conversion/bresenham_line", "clipping/liang_barsky")  # those of the program
ALONE = "visualize/stories/clipping/polygon_circle_story.cpp"
OUTER = {"algorithms/core/image.cpp", "pipeline/scene/files.cpp"}  # PNG, files
THREADED = "pipeline/engine/"  # a page has one thread, and draws by the textbook chain
ROOTS = ("visualize", "algorithms", "pipeline")
PACKAGES = ("fmt/core.h", "glm/glm.hpp", "nlohmann/json.hpp", "boost/version.hpp")

FLAGS = ["-std=c++20", "-fno-exceptions", "-ffp-contract=off", "-w", f"-I{project.ROOT}",
         *(f"-I{project.ROOT / root}" for root in ROOTS)]
WASM = ["--target=wasm32-wasi", "-DFMT_HEADER_ONLY", "-DFMT_STATIC_THOUSANDS_SEPARATOR=','",
        "-DBOOST_NO_CXX98_FUNCTION_BASE"]
# Debian's runtime for WebAssembly is built with a stack protector that its C library lacks. The one thread ends with the
# program: what it has to itself needs no end of its own.
RUNTIME = """extern "C" {
unsigned long __stack_chk_guard = 1;
void __stack_chk_fail() { __builtin_trap(); }
int __cxa_thread_atexit(void (*)(void*), void*, void*) { return 0; }
}
"""


def matching(*patterns):
    found = {path.relative_to(project.ROOT).as_posix() for pattern in patterns for path in project.ROOT.glob(pattern)}
    return sorted(path for path in found - OUTER if not path.startswith(THREADED))


def of_the_program():
    """What a page of some topics needs, in units: files that are compiled together."""
    stories = [f"visualize/stories/{topic}_story.cpp" for topic in TOPICS]
    return [matching("algorithms/core/**/*.cpp"), matching("visualize/figure/*.cpp"), matching("visualize/stories/*.cpp"),
            [*matching("visualize/json/*.cpp"), *stories]]


def of_all_else():
    """What else a page may need, in units. The last one's algorithm takes over another topic's entry()."""
    headers = matching("visualize/theme/*.cpp", *(f"algorithms/{topic.path}/*.hpp" for topic in project.topics()))
    stories = [path for path in matching("visualize/stories/*/*.cpp") if path not in of_the_program()[-1]]
    return [[path for path in headers if not path.endswith("_batch.hpp")], matching("visualize/request/*.cpp"),
            matching("pipeline/*/*.cpp", "pipeline/*.hpp", "pipeline/stages/*.hpp"),
            [path for path in stories if path != ALONE], [ALONE]]


def catalogue():
    names = [topic.split("/")[1] for topic in TOPICS]
    declared = "".join(f"namespace {name} {{\nconst TopicEntry& entry();\n}}\n" for name in names)
    return f"""#include "stories/topic.hpp"
namespace gradus {{
{declared}std::span<const TopicEntry* const> catalogue() {{
  static const TopicEntry* const entries[] = {{{", ".join(f"&{name}::entry()" for name in names)}}};
  return entries;
}}
}}  // namespace gradus
"""


@functools.cache
def wasm_works():
    if not shutil.which("clang++-19"):
        return False
    done = subprocess.run(["clang++-19", "--target=wasm32-wasi", "-x", "c++", "-include", "vector", "-", "-o", "/dev/null"],
                          input="int main() {}", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, encoding="utf-8")
    return done.returncode == 0


def packages_folder(folder):
    """Links to the packages' headers alone: the C library's beside them are another system's."""
    includes = [word for header in PACKAGES for word in ("-include", header)]
    read = project.run(project.COMPILER, "-std=c++20", "-M", "-x", "c++", *includes, "/dev/null")
    for header in PACKAGES:
        found = re.search(rf"\s(/\S*)/{header}", read)
        name = header.split("/")[0]
        (folder / name).symlink_to(pathlib.Path(found[1]) / name)
    return folder


class NoExceptions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)

    def compile(self, compiler, units, *how):
        """The objects of these units. Where the files of one can't be compiled together, its halves are."""
        objects = []
        for files in units:
            if len(files) == 1:
                objects += self.compile_one(compiler, files[0], *how, required=True)
                continue
            together = self.write("unit.cpp", "".join(f'#include "{file}"\n' for file in files))
            half = len(files) // 2
            objects += (self.compile_one(compiler, together, *how) or
                        self.compile(compiler, [files[:half], files[half:]], *how))
        return objects

    def compile_one(self, compiler, source, *how, required=False):
        target = self.folder / f"{len(list(self.folder.glob('*.o')))}.o"
        command = [*compiler, "-x", "c++", project.ROOT / source, *how, *(["-o", target] if "-c" in how else [])]
        if required:
            with self.subTest(source):
                project.run(*command)
        else:
            done = subprocess.run(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if done.returncode != 0:
                return []
        return [target]

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    def build(self, compiler, *link):
        """The program of a compiler."""
        generated = [project.BUILD / f"generated/{name}_text.cpp" for name in ("language", "source")]
        own = [PROGRAM, self.write("catalogue.cpp", catalogue()), *generated]
        objects = self.compile(compiler, of_the_program(), "-c")
        objects += [found for file in own for found in self.compile_one(compiler, file, "-c", required=True)]
        program = self.folder / "program"
        project.run(*compiler, *objects, *link, "-o", program)
        return program

    def test_the_lists_hold_what_they_promise(self):
        files = sum(of_the_program() + of_all_else(), [])
        self.assertEqual(len(files), len(set(files)))
        for path in ("algorithms/core/arithmetic/exact_scalar.cpp", "visualize/figure/layout.cpp", "visualize/theme/theme.cpp",
                     "visualize/stories/telling.cpp", "visualize/json/json.cpp", "pipeline/scene/obj.cpp", "pipeline/pipeline.hpp"):
            self.assertIn(path, files)
        for topic in project.topics():
            self.assertIn(f"algorithms/{topic.path}/{topic.name}.hpp", files)
            story = f"visualize/stories/{topic.path}_story.cpp"
            self.assertEqual(story in files, (project.ROOT / story).is_file())

    def test_a_throw_is_found(self):
        planted = self.write("planted.cpp", '#include "core/refusal.hpp"\nvoid fail() { throw gradus::InputError("no"); }\n')
        self.assertEqual(self.compile_one([project.COMPILER, *FLAGS], planted, "-fsyntax-only"), [])

    def test_the_program_says_what_the_command_says(self):
        # Clang is the quicker one, and the test below has seen that it is there
        program = self.build(["clang++-19" if wasm_works() else project.COMPILER, *FLAGS], "-lfmt")
        for topic in TOPICS:
            name = topic.split("/")[1]
            said = project.run(program, name)
            self.assertEqual(said, project.run(project.COMMAND, "run", name, "--json"))
            self.assertEqual(json.loads(said)["topic"], name)

        def refused(*words):
            done = subprocess.run([program, *words], stdout=subprocess.PIPE, encoding="utf-8")
            self.assertEqual(done.returncode, 3, done.stdout)
            return done.stdout
        self.assertRegex(refused("bresenham_line", "from=here"), r"^argument from: expected two whole numbers .*'here'\n$")
        self.assertRegex(refused("liang_barsky", "method=fast"), r"^argument method: liang_barsky has no method fast\n$")

    @unittest.skipIf(wasm_works(), "WebAssembly is here")
    def test_everything_compiles(self):
        self.compile([project.COMPILER, *FLAGS], of_all_else(), "-fsyntax-only")

    @unittest.skipUnless(wasm_works(), "WebAssembly is not here: lld-19, libc++-19-dev-wasm32, libclang-rt-19-dev-wasm32")
    def test_everything_compiles_for_webassembly(self):
        compiler = ["clang++-19", *FLAGS, *WASM, "-isystem", packages_folder(self.folder)]
        self.compile(compiler, of_all_else(), "-fsyntax-only")
        runtime = self.write("runtime.cpp", RUNTIME)
        program = self.build(compiler, *self.compile_one(compiler, runtime, "-c", required=True))
        self.assertEqual(program.read_bytes()[:4], b"\0asm")


if __name__ == "__main__":
    unittest.main()
