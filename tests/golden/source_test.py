#!/usr/bin/env python3
"""`gradus source`: a topic's algorithm, and the header without observers that one's own program takes.

    tests/golden/source_test.py [GRADUS]

Of every topic that header compiles with GLM and the standard library alone, without a warning; of topics of all chapters it
gives the answers of the project's own headers on seeded inputs, bit for bit.
"""
import json
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
import project
from command import check, equal, gradus, read, write

ROOT = pathlib.Path(__file__).resolve().parents[2]
BINARY = pathlib.Path(os.environ.get("GRADUS_BINARY_DIR", ROOT / "build/dev"))
CHAINS = {"pipeline"}  # no algorithm of their own
COMPARED = ("bresenham_line", "antialiased_line", "bresenham_circle", "flood_fill", "affine_2d", "viewing",
            "cohen_sutherland_2d", "liang_barsky", "sutherland_hodgman", "polygon_circle", "bsp_tree", "illumination",
            "polygon_shading", "jittered", "poisson_disc", "sampling_theorem")
SEED = 20261127
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
STANDARD = ["-std=c++20", "-ffp-contract=off"]

PROGRAM = """
#include <cstdio>
#include <cstring>
%s
#include "support/plain_runs.hpp"
#define gradus plain
%s
#include "support/plain_runs.hpp"
#undef gradus

int main() {
  int wrong = 0;
  for (std::size_t i = 0; i < std::size(gradus::runs::all); ++i) {
    std::size_t numbers = 0;
    for (std::uint64_t seed = SEED; seed < SEED + 60; ++seed) {
      gradus::runs::Dice dice{gradus::Random(seed)};
      plain::runs::Dice same{plain::Random(seed)};
      gradus::runs::Answers expected, found;
      gradus::runs::all[i].call(dice, expected);
      plain::runs::all[i].call(same, found);
      numbers += expected.size();
      const bool equal = expected.size() == found.size() &&
                         std::memcmp(expected.data(), found.data(), expected.size() * sizeof(double)) == 0;
      if (!equal) ++wrong, std::printf("%%s differs, seed %%d\\n", gradus::runs::all[i].name, int(seed));
    }
    if (numbers == 0) ++wrong, std::printf("%%s: nothing compared\\n", gradus::runs::all[i].name);
  }
  if (gradus::runs::refusal() != 1 || plain::runs::refusal() != 1) ++wrong, std::puts("refused otherwise");
  std::printf("%%d wrong\\n", wrong);
  return wrong != 0;
}
"""


def topics():
    return [topic for topic in json.loads(gradus("list", "--json").out)["topics"] if topic["name"] not in CHAINS]


def includes(text):
    """What a header includes of GLM and the standard library."""
    return set(re.findall(r"^#include <[a-z0-9_/.]+>$", text, re.MULTILINE))


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


def run(*words):
    return project.run(*words)


def plain(name):
    """Writes a topic's plain header into the folder."""
    done = gradus("source", name, "--plain", "-o", f"{name}.hpp")
    equal((done.code, done.out, done.err), (0, "", ""), name)
    return read(f"{name}.hpp").decode()


def test_plain_headers():
    names = [topic["name"] for topic in topics()]
    check(len(names) >= 33, f"{len(names)} topics")
    headers = {name: plain(name) for name in names}
    for name in names:
        code = without_comments(headers[name])
        check("Permission is hereby granted" in headers[name], f"{name}: the licence")
        check(not re.search(r"observe[rd]", code, re.IGNORECASE), f"{name}: an observer is left")
        check("fmt" not in code and not re.search(r'#include "', code), f"{name}: includes")
        check(f"namespace gradus::{name} {{" in code, f"{name}: its namespace")
        check("_notes" not in code, f"{name}: an exhibit")
    compile_each(headers)


def compile_each(headers):
    """Each by itself, in one go: what they include first, then each under a name of its own, nothing of another known."""
    lines = sorted(set().union(*(includes(text) for text in headers.values())))
    for name, text in headers.items():
        lines += [f"#undef {guard}" for guard in re.findall(r"^#ifndef (GRADUS_PLAIN_\w+)", text, re.MULTILINE)]
        lines += [f"#define gradus gradus_{name}", f'#include "{name}.hpp"', "#undef gradus"]
    write("each.cpp", "\n".join(lines) + "\n")
    run(project.COMPILER, *STANDARD, *WARNINGS, "-fsyntax-only", "each.cpp")
    # What it includes is what its parts include; two by themselves all the same
    for name in ("bresenham_line", "polygon_circle"):
        write("alone.cpp", f'#include "{name}.hpp"\nint main() {{}}\n')
        run(project.COMPILER, *STANDARD, *WARNINGS, "-fsyntax-only", "alone.cpp")


def test_same_answers():
    headers = {name: plain(name) for name in COMPARED}
    paths = {topic["name"]: f'{topic["chapter"]}/{topic["name"]}/{topic["name"]}.hpp' for topic in topics()}
    ours = [f'#include "{paths[name]}"' for name in COMPARED]
    ours += ['#include "core/random.hpp"', '#include "scan_conversion/bresenham_line/bresenham_line_batch.hpp"',
             '#include "scan_conversion/bresenham_circle/bresenham_circle_window.hpp"',
             '#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"']
    everything = sorted(set().union(*(includes(headers[name]) for name in COMPARED)))
    write("same.cpp", PROGRAM % ("\n".join(everything + ours), "\n".join(f'#include "{name}.hpp"' for name in COMPARED)))
    print(f"seed {SEED}")
    run(project.COMPILER, *STANDARD, "-O1", f"-DSEED={SEED}", f"-I{ROOT / 'algorithms'}", f"-I{ROOT / 'tests'}", "-I.",
        "same.cpp", str(BINARY / "libgradus_exact_scalar.a"), str(BINARY / "libgradus_core.a"), "-lfmt", "-o", "same")
    equal(run("./same"), "0 wrong\n", "the same answers")


def test_source():
    ours = gradus("source", "bresenham_line")
    equal(ours.out, (ROOT / "algorithms/scan_conversion/bresenham_line/bresenham_line.hpp").read_text(encoding="utf-8"),
          "the header as it is")
    write("mine.hpp", "// mine\n")
    refused = gradus("source", "bresenham_line", "--plain", "-o", "mine.hpp")
    equal((refused.code, read("mine.hpp")), (2, b"// mine\n"), refused.err)
    equal(gradus("source", "bresenham_line", "--plain", "-o", "mine.hpp", "--force").code, 0, "with --force")
    equal(gradus("source", "bresenham_line", "--plain").out, read("mine.hpp").decode(), "the same on standard output")
    for name in CHAINS:
        refused = gradus("source", name, "--plain")
        equal((refused.code, refused.out, refused.err.count("\n")), (2, "", 1), f"{name}: {refused.err}")
        check("header of its own" in refused.err, refused.err)


sys.exit(command.run_all(globals()))
