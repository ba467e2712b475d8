#!/usr/bin/env python3
"""`cmake --install` into an empty folder; another project finds the package there and uses a topic."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

CONSUMER = pathlib.Path(__file__).resolve().parent / "consumer"


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
            self.assertEqual(project.run(folder / "build/consumer"),
                             "(0,0)(1,0)(2,1)(3,1)(4,2)(5,2)(6,3)(7,3) 3\n")
            # Nothing of this machine's folders is in what was installed
            for file in (folder / "prefix").rglob("*.cmake"):
                self.assertNotIn(str(project.ROOT), file.read_text(encoding="utf-8"), file.name)
            self.assertTrue(list((folder / "prefix").rglob("LICENSE")))


if __name__ == "__main__":
    unittest.main()
