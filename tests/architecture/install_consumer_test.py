#!/usr/bin/env python3
"""`cmake --install` into an empty folder; another project finds the package there and uses topics, a short program each."""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

CONSUMER = pathlib.Path(__file__).resolve().parent / "consumer"
PROGRAMS = sorted(CONSUMER.glob("*.cpp"))


def path_under(root):
    """A pattern of this folder or what lies in it: not of a longer name, as /gradus is in ${DIR}/gradusTargets.cmake."""
    return rf"(?:(?<![\w.}}/])|(?<=-[IL])){re.escape(str(root))}(?![\w.-])"


def installing_line():
    """What the page says to install the library alone."""
    page = (project.ROOT / "docs/source.md").read_text(encoding="utf-8")
    return re.search(r"^cmake --build .* && cmake --install .*$", page, re.MULTILINE)[0]


def files_in(prefix):
    return {file.relative_to(prefix): file.read_bytes() for file in prefix.rglob("*") if file.is_file()}


def built_by_bootstrap():
    """The names of the files that `./bootstrap figures` builds."""
    bootstrap = (project.ROOT / "bootstrap").read_text(encoding="utf-8")
    targets = re.search(r"build release --target ([\w ]+?) *(#|$)", bootstrap, re.MULTILINE)[1].split()
    # Ninja names the libraries' objects, and leaves out a library that only a phony target asks for
    inputs = project.run("ninja", "-C", project.BUILD, "-t", "inputs", *targets)
    return set(targets) | {f"lib{name}.a" for name in re.findall(r"^CMakeFiles/(\w+)\.dir/.*\.o$", inputs, re.MULTILINE)}


class InstallConsumer(unittest.TestCase):
    def test_a_consumer_finds_builds_and_runs(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            build, install = (shlex.split(words) for words in installing_line().split(" && "))
            place = {"build/release": project.BUILD, "P": folder / "prefix"}
            for words in (build, install):
                project.run(*(place.get(word, word) for word in words))
            # A topic needs GLM and fmt; nothing else may even be looked for
            project.run("cmake", "-S", CONSUMER, "-B", folder / "build", "-G", "Ninja",
                        f"-DCMAKE_PREFIX_PATH={folder / 'prefix'}", f"-DCMAKE_CXX_COMPILER={project.COMPILER}",
                        "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror",
                        *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in ("PNG", "Boost", "CLI11")))
            project.run("cmake", "--build", folder / "build")
            for program in PROGRAMS:
                with self.subTest(program.name):
                    expected = program.read_text(encoding="utf-8").splitlines()[-1].removeprefix("// prints: ")
                    self.assertEqual(project.run(folder / "build" / program.stem).rstrip(), expected)
            # Nothing of this machine's folders is in what was installed
            for file in (folder / "prefix").rglob("*.cmake"):
                self.assertIsNone(re.search(path_under(project.ROOT), file.read_text(encoding="utf-8")), file.name)
            self.assertTrue(list((folder / "prefix").rglob("LICENSE")))
            # Without a component, the same files are there beside the command, and nothing that bootstrap doesn't build
            project.run("cmake", "--install", project.BUILD, "--prefix", folder / "plain")
            plain = files_in(folder / "plain")
            self.assertEqual(set(files_in(folder / "prefix").items()) - set(plain.items()), set())
            compiled = {name for name in plain if re.match(r"bin/|lib.*\.(a|so)$", str(name))}
            self.assertIn(pathlib.Path("bin/gradus"), compiled)
            self.assertEqual({file.name for file in compiled} - built_by_bootstrap(), set())

    def test_nothing_is_installed_before_all_of_it_is_built(self):
        script = (project.BUILD / "before_installing.cmake").read_text(encoding="utf-8")
        rules = (project.BUILD / "cmake_install.cmake").read_text(encoding="utf-8")
        self.assertLess(rules.index("before_installing.cmake"), rules.index("file(INSTALL"))
        for component, missing in (("command", "gradus"), ("library", "libgradus_core.a"), ("", "gradus"),
                                   ("", "libgradus_area_sampling.a")):
            with self.subTest(component=component, missing=missing), tempfile.TemporaryDirectory() as name:
                copy = pathlib.Path(name) / "before.cmake"
                copy.write_text(script.replace(f"{project.BUILD}/{missing}", f"{name}/{missing}"), encoding="utf-8")
                done = subprocess.run(["cmake", f"-DCMAKE_INSTALL_COMPONENT={component}", "-P", copy],
                                      capture_output=True, text=True)
                self.assertNotEqual(done.returncode, 0)
                target = "gradus" if missing == "gradus" else "library"
                self.assertRegex(done.stderr, rf"{name}/{missing} is not built.*: cmake --build .* --target {target}\n")

    def test_a_root_is_told_from_longer_names(self):
        for text in ("/gradus", '"/gradus/algorithms"', "-I/gradus/a", "a;/gradus;b"):
            self.assertIsNotNone(re.search(path_under("/gradus"), text), text)
        for text in ('"${CMAKE_CURRENT_LIST_DIR}/gradusTargets.cmake"', "${_PREFIX}/gradus", "lib/cmake/gradus"):
            self.assertIsNone(re.search(path_under("/gradus"), text), text)

    def test_hidden_surfaces_and_shading_have_a_program_each(self):
        build = (project.ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        topics = re.findall(r"^gradus_add_topic\((?:visibility|shading)/(\w+)", build, re.MULTILINE)
        self.assertGreaterEqual(len(topics), 6)
        self.assertEqual(set(topics) - {program.stem for program in PROGRAMS}, set())
        for program in PROGRAMS:
            lines = program.read_text(encoding="utf-8").splitlines()
            self.assertLessEqual(len(lines) - 1, 20, f"{program.name}: short programs were promised")
            self.assertTrue(lines[-1].startswith("// prints: "), program.name)


if __name__ == "__main__":
    unittest.main()
