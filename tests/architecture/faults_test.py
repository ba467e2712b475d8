#!/usr/bin/env python3
"""Faults are written as differences (algorithms/F/T/T.faults): what the build makes of them, and what it refuses."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

SCRIPT = project.ROOT / "algorithms/apply_faults.cmake"
FILES = sorted((project.ROOT / "algorithms").rglob("*.faults"))
ENTRY = re.compile(r"^\[(\w+)\] of (\w+)$", re.MULTILINE)

TAUGHT = r'''#pragma once

/// Walks.
/// Source: a book.
///
/// steps: how many.
///
/// Domain: everything.
/// Accuracy: exact.
/// Cost: none.
template <class Plot, Observer<Stepped> O = Unobserved>
void walk(int steps, Plot&& plot,
          O&& observer = {}) {
  const char separators[] = {';', '\\', ']'};
  // One step at a time
  for (int i = 0; i < steps; ++i) {
    plot(i);
    if constexpr (observed<O>) observer(Stepped{i});
  }
  done();
  plot(separators[0]);
}
'''
FAULTS = r'''// An exhibit.

#include "lines/walk.hpp"

namespace gradus::lines {

[one_too_far] of walk
FAULTY: a fence of n posts; "n" rails.

Accuracy: one
  too many.
Errors: none.
@@
-  for (int i = 0; i < steps; ++i) {
+  // Up to the end
+  for (int i = 0; i <= steps; ++i) {
@@
-    if constexpr (observed<O>) observer(Stepped{i});
+    if constexpr (observed<O>) observer(Stepped{i + 1});
@@
   done();
+  plot(separators[1], "[;\\");
'''
MADE = r'''#pragma once
// Made of walk.faults by the build.

// An exhibit.

#include "lines/walk.hpp"

namespace gradus::lines {

/// FAULTY: a fence of n posts; "n" rails.
///
/// steps: how many.
///
/// Domain: everything.
/// Accuracy: one
///   too many.
/// Cost: none.
/// Errors: none.
template <class Plot, Observer<Stepped> O = Unobserved>
void one_too_far(int steps, Plot&& plot,
                 O&& observer = {}) {
  const char separators[] = {';', '\\', ']'};
  // One step at a time
  //- for (int i = 0; i < steps; ++i) {
  // Up to the end  //+
  for (int i = 0; i <= steps; ++i) {  //+
    plot(i);
    if constexpr (observed<O>) observer(Stepped{i + 1});
  }
  done();
  plot(separators[1], "[;\\");  //+
  plot(separators[0]);
}

}  // namespace gradus::lines
'''


def made_of(faults, root, output):
    """Runs the script as the build does."""
    return subprocess.run(["cmake", "-D", f"FAULTS={faults}", "-D", f"ROOT={root}", "-D", f"OUTPUT={output}", "-D",
                           f"DEPENDENCIES={output}.d", "-P", SCRIPT], capture_output=True, text=True)


class Project(unittest.TestCase):
    """The project's own faults."""

    def test_what_the_build_has_is_made_of_them(self):
        self.assertGreater(len(FILES), 15)
        with tempfile.TemporaryDirectory() as folder:
            output = pathlib.Path(folder, "notes.hpp")
            for faults in FILES:
                with self.subTest(faults.stem):
                    done = made_of(faults, project.ROOT / "algorithms", output)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertEqual(output.read_text(), project.made_header(faults).read_text())
                    self.assertFalse(faults.with_name(f"{faults.stem}_notes.hpp").exists(), "made, and written by hand, too")

    def test_their_heads_are_formatted_as_headers_are(self):
        for faults in FILES:
            head = re.split(ENTRY, faults.read_text(encoding="utf-8"))[0].rstrip() + "\n"
            head += "\n}  // namespace" + re.findall(r"^namespace(.*) {$", head, re.MULTILINE)[-1] + "\n"
            if re.search(r"{\n\n}", head):
                continue  # includes alone
            formatted = subprocess.run(["clang-format-19", f"--assume-filename={faults.with_suffix('.hpp')}"], input=head,
                                       capture_output=True, text=True, check=True).stdout
            self.assertEqual(head, formatted, faults)


class Script(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name, "algorithms")
        (self.root / "lines").mkdir(parents=True)
        (self.root / "lines/walk.hpp").write_text(TAUGHT)
        self.output = self.root / "made.hpp"

    def made(self, text):
        faults = self.root / "lines/walk.faults"
        faults.write_text(text)
        return made_of(faults, self.root, self.output)

    def test_a_fault_is_the_taught_function_with_its_lines_changed(self):
        done = self.made(FAULTS)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.output.read_text(), MADE)
        self.assertEqual(pathlib.Path(f"{self.output}.d").read_text(),
                         f"{self.output}: {self.root}/lines/walk.faults {self.root}/lines/walk.hpp\n")

    def test_what_stays_as_it_is_is_not_written_again(self):
        self.made(FAULTS)
        before = self.output.stat().st_mtime_ns
        self.made(FAULTS)
        self.assertEqual(self.output.stat().st_mtime_ns, before)
        self.made(FAULTS.replace("posts", "pales"))
        self.assertGreater(self.output.stat().st_mtime_ns, before)

    def test_what_does_not_fit_is_refused_in_a_line(self):
        for what, old, new, line, message in (
                ("taught text that has changed", "i < steps;", "i != steps;", 13, "expected these lines in walk, together, and they aren't there"),
                ("lines that another hunk changes", "@@\n   done();", "@@\n-  for (int i = 0; i < steps; ++i) {\n@@\n   done();", 20,
                 "expected lines that no other hunk changes"),
                ("head and body", "   done();", " " * 11 + "O&& observer = {}) {\n   const char separators[] = {';', '\\\\', ']'};", 20,
                 "expected lines of the head of walk or of its body, not of both"),
                ("no function", "of walk", "of run", 7, "expected a function run with a contract"),
                ("no accuracy", "Accuracy: one\n  too many.\n", "", 7, "expected a line Accuracy: in one_too_far"),
                ("no text", "FAULTY: ", "", 7, "expected a text that begins with FAULTY"),
                ("no hunk", FAULTS[FAULTS.index("@@"):], "", 7, "expected a hunk, lines after @@, in one_too_far"),
                ("no sign", "+  // Up", "x  // Up", 15, "expected a line that begins with -, + or a space"),
                ("no namespace", "namespace gradus::lines {\n", "", 1, "expected a head that opens a namespace"),
                ("no fault", FAULTS[FAULTS.index("[one"):], "", 6, "expected a fault, [NAME] of FUNCTION")):
            with self.subTest(what):
                self.assertIn(old, FAULTS)
                done = self.made(FAULTS.replace(old, new, 1))
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(f" algorithms/lines/walk.faults:{line}: {message}", done.stderr)
                self.assertFalse(self.output.exists(), "half a header")

    def test_lines_that_stand_twice_need_one_beside_them(self):
        (self.root / "lines/walk.hpp").write_text(TAUGHT.replace("  done();\n", "  done();\n  done();\n"))
        self.assertIn("walk.faults:20: expected these lines once in walk, and they are there more often", self.made(FAULTS).stderr)


if __name__ == "__main__":
    unittest.main()
