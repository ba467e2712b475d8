#!/usr/bin/env python3
"""`cmake --install` into an empty folder; another project finds the package there and uses topics, a short program each."""
import pathlib
import re
import shlex
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
    """What the readme says to install the library alone."""
    readme = (project.ROOT / "README.md").read_text(encoding="utf-8")
    return re.search(r"^cmake --build .* && cmake --install .*$", readme, re.MULTILINE)[0]


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
