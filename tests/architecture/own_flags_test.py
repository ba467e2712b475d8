#!/usr/bin/env python3
"""Topics copied into a program that has flags of its own: where its compiler fuses products with sums, results are as exact
as without; what takes exactness away is refused, in one sentence.

The programs of own_flags/ are built as a user would, for the machine at hand and for every x86 of the last ten years,
without -ffp-contract=off. They have a minute to end: a loop that rounding keeps alive fails.
"""
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project
from share import in_share, share_of

PROGRAMS = pathlib.Path(__file__).resolve().parent
ALGORITHMS = project.ROOT / "algorithms"
CORE = ("axis_cut", "contract", "refusal", "arithmetic/elementary", "arithmetic/exact", "arithmetic/exact_polynomial")
NEEDS_MORE = {"image.cpp", "exact_scalar.cpp"}  # libpng, Boost: no topic needs them
SECONDS = 60
# In the ordinary build; wherever it is computed, it has the same bits
ELEMENTARY = "elementary d6dfd6fcae6dac6e\n"

INTEGER_TOPICS = {"bresenham_circle", "bresenham_line", "flood_fill", "mesh_structures"}  # right whatever is done to fractions
FAST_MATH = "Gradus needs the arithmetic of IEEE 754"
NOT_EXACT = ("-ffast-math", "-Ofast", "-ffinite-math-only")
NOT_EXACT_GCC = ("-funsafe-math-optimizations", "-freciprocal-math", "-fno-signed-zeros")


def machines():
    """Flags for machines that this one can stand for."""
    found = ["-march=native"]
    if platform.machine() == "x86_64":
        info = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").split()
        if {"avx2", "fma", "bmi2", "f16c", "movbe"}.issubset(info):
            found.insert(0, "-march=x86-64-v3")
    return found


def is_clang(compiler):
    return "clang" in project.run(compiler, "--version")


def exact_headers():
    """The main headers of the topics that say they need exact arithmetic."""
    return [ALGORITHMS / topic.path / f"{topic.name}.hpp" for topic in project.topics()
            if topic.name not in INTEGER_TOPICS]


class OwnFlags(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        # As docs/source.md says: topics and core, without what needs more than GLM and fmt
        shutil.copytree(ALGORITHMS / "core", cls.folder / "core", ignore=lambda *_: NEEDS_MORE)
        for topic in project.topics():
            shutil.copytree(ALGORITHMS / topic.path, cls.folder / topic.path)

    def compile(self, compiler, *arguments):
        project.run(compiler, "-std=c++20", "-O3", f"-I{self.folder}", f"-I{PROGRAMS.parent}", *arguments, cwd=self.folder)

    def errors(self, compiler, *arguments):
        """The lines with errors, of a compilation that fails."""
        done = subprocess.run([compiler, f"-I{self.folder}", "-x", "c++", *map(str, arguments), "/dev/null"],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8", errors="replace")
        self.assertNotEqual(done.returncode, 0, f"{compiler} {arguments}")
        return [line for line in done.stderr.splitlines() if "error: " in line]

    def test_exact_wherever_the_compiler_fuses(self):
        compilers = project.compilers()
        self.assertGreater(len(compilers), 0)
        for index, compiler in enumerate(compilers):
            # Clang fuses within an expression; told so, GCC's way
            fused = ("-ffp-contract=fast",) if is_clang(compiler) else ()
            core = []
            # Of two machines each compiler takes another one
            for number, machine in enumerate(share_of(machines()[index:] + machines()[:index], 2)):
                if not core:
                    for name in CORE:
                        core.append(self.folder / f"{pathlib.Path(name).name}.o")
                        self.compile(compiler, machine, *fused, "-c", f"core/{name}.cpp", "-o", core[-1])
                for program in ("hard_cases", *(("whole_topics",) if number == 0 and compiler == compilers[0] else ())):
                    with self.subTest(compiler=compiler, machine=machine, program=program):
                        self.compile(compiler, machine, *fused, PROGRAMS / "own_flags" / f"{program}.cpp", *core,
                                     "-lfmt", "-o", program)
                        said = project.run(self.folder / program, timeout=SECONDS)
                        self.assertEqual(said, ELEMENTARY if program == "hard_cases" else "")

    def test_needs_neither_boost_nor_libpng(self):
        headers = [word for header in exact_headers() for word in ("-include", header)]
        read = project.run(project.COMPILER, "-std=c++20", f"-I{self.folder}", "-M", "-x", "c++", *headers, "/dev/null")
        self.assertIn("/glm/", read)
        self.assertIn("/fmt/", read)
        for package in ("/boost/", "png.h", "/hwy/"):
            self.assertNotIn(package, read)

    def test_fast_math_is_refused(self):
        # Preprocessed only: that is where it is found
        for number, header in enumerate(share_of(exact_headers(), 3)):
            compiler = project.compilers()[number % len(project.compilers())]
            with self.subTest(header=header.name):
                found = self.errors(compiler, "-std=c++20", "-ffast-math", "-E", "-include", header)
                self.assertEqual(len(found), 1, found)
                self.assertIn(FAST_MATH, found[0])
        for compiler in project.compilers():
            for flag in (*NOT_EXACT, *(() if is_clang(compiler) else NOT_EXACT_GCC)):
                with self.subTest(compiler=compiler, flag=flag):
                    # Nothing else is wrong, either: seen once by compiling
                    how = "-fsyntax-only" if flag == NOT_EXACT[0] else "-E"
                    found = self.errors(compiler, "-std=c++20", flag, how, "-include", "core/arithmetic/exact.hpp")
                    self.assertEqual(len(found), 1, found)
                    self.assertIn(FAST_MATH, found[0])

    @unittest.skipUnless(platform.machine() == "x86_64", "x87 is a part of x86")
    def test_x87_is_refused(self):
        if not is_clang(project.COMPILER):
            found = self.errors(project.COMPILER, "-std=c++20", "-mfpmath=387", "-fsyntax-only", "-include",
                                "core/arithmetic/exact.hpp")
            self.assertEqual(len(found), 1, found)
            self.assertIn("not for x87", found[0])

    def test_integers_go_with_fast_math(self):
        for topic in project.topics():
            if topic.name in INTEGER_TOPICS:
                project.run(project.COMPILER, "-std=c++20", "-ffast-math", f"-I{self.folder}", "-fsyntax-only", "-x", "c++",
                            "-include", f"{topic.path}/{topic.name}.hpp", "/dev/null")

    def test_every_header_includes_what_refuses_an_older_language(self):
        """Of these the next test compiles a share."""
        includes = {path.relative_to(self.folder).as_posix(): re.findall(r'^#include "([^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE)
                    for path in self.folder.rglob("*.hpp") if not path.name.endswith("-inl.hpp")}
        saying = {"core/language.hpp"}
        while more := {name for name, others in includes.items() if name not in saying and saying.intersection(others)}:
            saying |= more
        self.assertEqual(sorted(set(includes) - saying), [])

    def test_an_older_language_is_refused_by_one_error(self):
        headers = sorted(h for h in self.folder.rglob("*.hpp") if not h.name.endswith("-inl.hpp"))
        self.assertGreater(len(headers), 50)
        for number, header in enumerate(headers):
            if not in_share(number, 4):
                continue
            compiler = project.compilers()[number % len(project.compilers())]
            # Most are preprocessed only, which is where they stop
            how = "-fsyntax-only" if number % 9 < 2 else "-E"
            with self.subTest(header=header.name, compiler=compiler):
                found = self.errors(compiler, "-std=c++17", how, "-include", header)
                self.assertEqual(len(found), 1, found)
                self.assertIn("Gradus needs C++20", found[0])


if __name__ == "__main__":
    unittest.main()
