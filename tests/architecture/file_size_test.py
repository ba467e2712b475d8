#!/usr/bin/env python3
"""No source file is longer than what one can read in one go, and no folder has more of them than one can look through: both are
parted by subject instead."""
import collections
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

MOST_LINES, MOST_FILES = 500, 50
KINDS = (".cpp", ".hpp", ".py", ".js")
FOLDERS = ("algorithms", "pipeline", "visualize", "examples", "docs", "tests")
NOT_WRITTEN_BY_HAND = ("tests/fuzz/corpus",)
MOST_PICKED, MOST_KIB = 60, 4  # of a fuzzer's corpus: inputs that it has picked, and the size of each input

# Yet to be parted, with the lines that they have: none of these may grow, and none come to them
STILL_LONG = {}


def lengths(root):
    """Path -> lines of every source file."""
    found = {}
    for top in FOLDERS:
        for folder, _, names in os.walk(root / top):
            for name in names:
                path = pathlib.Path(folder, name)
                shown = path.relative_to(root).as_posix()
                if name.endswith(KINDS) and not shown.startswith(NOT_WRITTEN_BY_HAND):
                    found[shown] = path.read_bytes().count(b"\n")
    return found


def complaints(root, still_long):
    return [f"{path} has {lines} lines, {max(MOST_LINES, still_long.get(path, 0))} are the most"
            for path, lines in sorted(lengths(root).items()) if lines > max(MOST_LINES, still_long.get(path, 0))]


def crowded(root):
    files = collections.Counter(path.rpartition("/")[0] for path in lengths(root))
    return [f"{folder} has {count} files of source, {MOST_FILES} are the most" for folder, count in sorted(files.items()) if count > MOST_FILES]


class FileSize(unittest.TestCase):
    def test_no_file_is_too_long(self):
        found = lengths(project.ROOT)
        self.assertGreater(len(found), 300)
        self.assertEqual(complaints(project.ROOT, STILL_LONG), [])

    def test_no_folder_is_crowded(self):
        self.assertEqual(crowded(project.ROOT), [])

    def test_a_crowded_folder_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "pipeline/parts").mkdir(parents=True)
            for number in range(MOST_FILES):
                (root / f"pipeline/parts/{number}.cpp").touch()
            self.assertEqual(crowded(root), [])
            (root / "pipeline/parts/one_more.hpp").touch()
            self.assertEqual(crowded(root), ["pipeline/parts has 51 files of source, 50 are the most"])

    def test_files_that_were_parted_leave_the_list(self):
        found = lengths(project.ROOT)
        self.assertEqual([path for path in STILL_LONG if found.get(path, 0) <= MOST_LINES], [])

    def test_corpora_stay_small(self):
        for corpus in sorted((project.ROOT / "tests/fuzz/corpus").iterdir()):
            picked = [path for path in corpus.iterdir() if len(path.name) == 40]  # by a hash; others have names
            self.assertLessEqual(len(picked), MOST_PICKED, corpus.name)
            self.assertLessEqual(max(path.stat().st_size for path in corpus.iterdir()), MOST_KIB * 1024, corpus.name)

    def test_a_long_file_is_named_with_its_lines(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "visualize").mkdir()
            (root / "visualize/long.cpp").write_text("\n" * 501)
            (root / "visualize/fits.cpp").write_text("\n" * 500)
            self.assertEqual(complaints(root, {}), ["visualize/long.cpp has 501 lines, 500 are the most"])
            self.assertEqual(complaints(root, {"visualize/long.cpp": 501}), [])


if __name__ == "__main__":
    unittest.main()
