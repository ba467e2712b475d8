#!/usr/bin/env python3
"""What the tests call is brought by ./bootstrap: every program, Python module and target that tests/support/programs.py
declares, and nothing else."""
import ast
import functools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import programs
import project

TESTS = project.ROOT / "tests"
STARTS = re.compile(r"\b(?:popen|system|posix_spawnp|exec[lv][ep]*)\(")  # posix_spawn asks no PATH


def scripts():
    """Module name -> file, of every Python file of the tests."""
    return {file.stem: file for file in sorted(TESTS.rglob("*.py"))}


@functools.cache
def imported(file):
    """The modules that a file imports, without their parts after the dot."""
    found = set()
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {name.name.split(".")[0] for name in node.names}
        elif isinstance(node, ast.ImportFrom):
            found.add(node.module.split(".")[0])
    return found


def reaches(file, module, known):
    return module in imported(file) or any(reaches(known[name], module, known) for name in imported(file) & known.keys())


def packages_of(kinds):
    """The packages in these lists of bootstrap."""
    text = (project.ROOT / "bootstrap").read_text(encoding="utf-8")
    return {package for kind in kinds
            for package in re.sub(r"#.*", "", re.search(rf"^{kind}_packages=\((.*?)\) *(?:#|$)", text,
                                                        re.DOTALL | re.MULTILINE)[1]).split()}


@functools.cache
def brought_by(package):
    """The installed packages that come with one."""
    text = project.run("apt-cache", "depends", "--recurse", "--installed", "--no-recommends", "--no-suggests",
                       "--no-conflicts", "--no-breaks", "--no-replaces", "--no-enhances", package)
    return {line.split(":")[0] for line in text.splitlines() if not line.startswith((" ", "|"))}


def owner(program):
    """The Debian package of a program, where it comes from one."""
    path = os.path.realpath(shutil.which(program) or "")
    for known in (path, path.removeprefix("/usr")):  # dpkg knows a file by the name it was packed with
        done = subprocess.run(["dpkg", "-S", known], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, encoding="utf-8")
        if done.returncode == 0:
            return done.stdout.split(":")[0]
    return None


class Programs(unittest.TestCase):
    def test_bootstrap_installs_them(self):
        brought = {*programs.PACKAGES, *programs.MODULES.values()} - packages_of(("build", "test"))
        self.assertEqual(brought, set(), "in no list of ./bootstrap")

    def test_each_comes_from_its_package(self):
        if not shutil.which("dpkg"):
            self.skipTest("not a Debian system")
        found = 0
        for package, names in {**programs.PACKAGES, **programs.BASE}.items():
            for program in names:
                with self.subTest(program):
                    self.assertIsNotNone(shutil.which(program), "missing here")
                    origin = owner(program)  # nothing for what was installed from elsewhere
                    if origin:
                        self.assertTrue(origin == package or origin in brought_by(package), origin)
                        found += 1
        self.assertGreater(found, 20)

    def test_the_smallest_debian_has_the_base(self):
        if not shutil.which("dpkg-query"):
            self.skipTest("not a Debian system")
        for package in programs.BASE:
            found = project.run("dpkg-query", "-W", "-f=${Essential} ${Priority}", package).split()
            self.assertTrue(found[0] == "yes" or package == "apt", f"{package}: {found}")

    def test_an_undeclared_program_is_not_found(self):
        self.assertIsNone(shutil.which("tar"))
        with self.assertRaises(FileNotFoundError):
            subprocess.run(["tar", "--version"])
        self.assertIsNotNone(shutil.which("sh"))

    def test_every_script_sees_these_alone(self):
        known = scripts()
        calling = [file for file in known.values() if {"subprocess", "os"} & imported(file) and file.stem != "programs"]
        self.assertGreater(len(calling), 10)
        for file in calling:
            self.assertTrue(reaches(file, "programs", known), f"{file.name} starts programs without programs.py")

    def test_modules_are_the_standard_librarys_or_declared(self):
        known = scripts()
        for file in known.values():
            others = imported(file) - known.keys() - sys.stdlib_module_names
            self.assertEqual(others - programs.MODULES.keys(), set(), file.name)

    def test_only_ctests_own_programs_start_others(self):
        found = [file.relative_to(TESTS) for file in TESTS.rglob("*.[ch]pp")
                 if STARTS.search(project.without_comments(file.read_text(encoding="utf-8")))]
        self.assertGreater(len(found), 0)
        for file in found:  # CMakeLists.txt sets the PATH of these
            self.assertIn(file.parts[0], ("unit", "property", "golden"), f"{file} starts a program")

    def test_the_build_makes_the_targets(self):
        if not (project.BUILD / "build.ninja").exists():
            self.skipTest("not a build with Ninja")
        text = (project.BUILD / "build.ninja").read_text(encoding="utf-8")
        everything = set(" ".join(re.findall(r"^build (?:tests/)?all: phony (.*)$", text, re.MULTILINE)).split())
        self.assertEqual(set(programs.TARGETS) - everything, set(), "not part of a whole build")


if __name__ == "__main__":
    unittest.main()
