#!/usr/bin/env python3
"""Code that must not compile: each file of tests/compile_fail/ compiles as it stands and, with FORGET defined, fails
with every text that its `expected:` lines name."""
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

CASES = sorted((project.ROOT / "tests/compile_fail").glob("*.cpp"))


class CompileFail(unittest.TestCase):
    def test_there_are_cases(self):
        self.assertGreater(len(CASES), 0)

    def test_fails_for_the_expected_reason_only(self):
        for case in CASES:
            expected = re.findall(r"^// expected: (.+)$", case.read_text(encoding="utf-8"), re.MULTILINE)
            self.assertGreater(len(expected), 0, case.name)
            for compiler in project.compilers():
                command = [compiler, "-std=c++20", f"-I{project.ROOT / 'algorithms'}", "-fsyntax-only", case]
                with self.subTest(case=case.name, compiler=compiler):
                    project.run(*command)
                    done = subprocess.run([*command, "-DFORGET"], stderr=subprocess.PIPE, encoding="utf-8")
                    self.assertNotEqual(done.returncode, 0)
                    for text in expected:
                        self.assertIn(text, done.stderr)


if __name__ == "__main__":
    unittest.main()
