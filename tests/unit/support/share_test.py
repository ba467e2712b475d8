#!/usr/bin/env python3
"""Shares of a run: together they are everything, and `./bootstrap test` says what it takes."""
import os
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/support"))
import programs

programs.use_nothing_else()
ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in ("GRADUS_SHARE", "GRADUS_ALL", "GRADUS_STRESS")}


def share_of(count, parts, **environment):
    """What a run with this environment takes of so many."""
    code = f"import share; print(*share.share_of(range({count}), {parts}))"
    done = subprocess.run([sys.executable, "-B", "-c", code], cwd=ROOT / "tests/support", env={**ENVIRONMENT, **environment},
                          check=True, stdout=subprocess.PIPE, encoding="utf-8")
    return [int(word) for word in done.stdout.split()]


class Shares(unittest.TestCase):
    def test_runs_one_after_the_other_take_everything_once(self):
        for parts in (2, 3, 5):
            taken = [share_of(17, parts, GRADUS_SHARE=str(2**24 - 3 + run)) for run in range(parts)]
            self.assertEqual(sorted(sum(taken, [])), list(range(17)))
            self.assertLessEqual(max(map(len, taken)) - min(map(len, taken)), 1)

    def test_something_is_always_taken(self):
        self.assertEqual(share_of(1, 3, GRADUS_SHARE="1"), [0])
        self.assertEqual(share_of(0, 3), [])

    def test_all_of_them(self):
        self.assertEqual(share_of(17, 5, GRADUS_ALL="1", GRADUS_SHARE="3"), list(range(17)))


class Bootstrap(unittest.TestCase):
    def test_unknown_parts_are_refused_before_anything_is_done(self):
        for word in ("--all=", "--all=everything", "all", "--al"):
            done = subprocess.run(["bash", ROOT / "bootstrap", "test", word], capture_output=True, encoding="utf-8",
                                  stdin=subprocess.DEVNULL, cwd="/")
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertEqual(done.stderr, "bootstrap: test: expected --all, or --all= and one of asan, clang, tsan, promises, "
                                          f"scripts, bench, found '{word}'\n")


if __name__ == "__main__":
    unittest.main()
