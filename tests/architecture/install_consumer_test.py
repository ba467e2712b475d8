#!/usr/bin/env python3
"""`cmake --install` into an empty folder; another project finds the package there and uses topics, a short program each."""
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

CONSUMER = pathlib.Path(__file__).resolve().parent / "consumer"
PROGRAMS = sorted(CONSUMER.glob("*.cpp"))


class InstallConsumer(unittest.TestCase):
    def test_a_consumer_finds_builds_and_runs(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            project.run("cmake", "--install", project.BUILD, "--prefix", folder / "prefix")
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
                self.assertNotIn(str(project.ROOT), file.read_text(encoding="utf-8"), file.name)
            self.assertTrue(list((folder / "prefix").rglob("LICENSE")))

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
