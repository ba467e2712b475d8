#!/usr/bin/env python3
"""An algorithm without an observer is the machine code of a copy without observer lines.

The plain copy is made here by blanking the observer lines of the topic's headers (or, where that alone moves a closure's
variables about, by naming the observer there and no more); then both are compiled from the same driver, machine_code/<topic>.cpp, which makes a named function of each method, and their assembly is compared.
With GRADUS_STRESS by all compilers at every level of optimisation; with GRADUS_ALL at -O2 by all compilers; else a third of
the topics, others with each commit, by the compilers in turn. That one more instruction would be seen is seen in every fifth.
"""
import functools
import os
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project
import share
from share import in_share, share_of

DRIVERS = pathlib.Path(__file__).resolve().parent / "machine_code"
EVERYTHING = bool(os.environ.get("GRADUS_STRESS"))
LEVELS = ("-O1", "-O2", "-O3") if EVERYTHING else ("-O2",)
COMPILERS = project.compilers()
PRECOMPILED = tempfile.TemporaryDirectory()
LEAST_INSTRUCTIONS = 15  # of a function that is worth comparing


def compilers_of(number):
    """Those that compare the topic of this number."""
    return COMPILERS if share.EVERYTHING else [COMPILERS[number % len(COMPILERS)]]


def plain_copy(topic, folder, replacement=""):
    """Writes the topic's headers with every observer line replaced; returns how many lines were."""
    count = 0
    for header in project.topic_headers(topic):
        lines = header.read_text(encoding="utf-8").split("\n")
        for number, line in enumerate(lines):
            if project.OBSERVER_LINE.match(line):
                lines[number] = replacement
                count += 1
        copy = folder / topic.path / header.name
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text("\n".join(lines), encoding="utf-8")
    return count


@functools.lru_cache(maxsize=None)
def assembly_with_observer(compiler, level, driver):
    return assembly(compiler, level, driver)


def flags_of(level):
    return ["-std=c++20", level, "-DNDEBUG", "-ffp-contract=off", "-w"]


@functools.cache
def precompiled(compiler, level):
    return project.precompiled(PRECOMPILED.name, compiler, *flags_of(level))


def assembly(compiler, level, driver, *folders):
    includes = [f"-I{folder}" for folder in (*folders, project.ROOT / "algorithms", project.MADE_HEADERS)]
    text = project.run(compiler, *flags_of(level), *precompiled(compiler, level), *includes, "-S", "-o", "-", driver)
    # Local labels are numbered by what the compiler has read, not by what it generates: number them as they appear
    numbers = {}
    return re.sub(r"\.L([A-Z]*)\d+", lambda label: f".L{label[1]}{numbers.setdefault(label[0], len(numbers))}", text)


def instructions(text, function, seen=()):
    """The instructions of a function and of those of the catalogue that it calls (a recursion can't be inlined)."""
    body = re.search(rf"^{re.escape(function)}:(.*?)^\s*\.size\s+{re.escape(function)},", text,
                     re.MULTILINE | re.DOTALL)
    code = re.findall(r"^\t[a-z].*$", body.group(1), re.MULTILINE) if body else []
    seen = (*seen, function)
    for callee in dict.fromkeys(re.findall(r"\b(?:callq?|jmp)\s+(_ZN6gradus[\w.]+)", "\n".join(code))):
        if callee not in seen:
            code += instructions(text, callee, seen)
    return code


class MachineCode(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_every_method_has_a_driver(self):
        for topic in project.topics():
            methods = {f.name for header in project.topic_headers(topic)
                       for f in project.observed_functions(header.read_text(encoding="utf-8"))}
            if not methods:
                self.assertTrue(topic.partial, f"{topic.name} reports no step at all")
                continue
            driver = (DRIVERS / f"{topic.name}.cpp").read_text(encoding="utf-8")
            self.assertEqual(set(re.findall(r"\bmachine_code_(\w+)\(", driver)), methods, topic.name)

    def test_observer_lines_cost_nothing(self):
        self.assertGreaterEqual(len(COMPILERS), 1)
        compared = 0
        for number, driver in enumerate(sorted(DRIVERS.glob("*.cpp"))):
            if not in_share(number, 9):
                continue
            topic = next(t for t in project.topics() if t.name == driver.stem)
            blanked = plain_copy(topic, self.folder)
            self.assertGreater(blanked, 0, f"no observer line found in {topic.name}")
            self.assertEqual(blanked, sum(len(project.OBSERVER_CALL.findall(project.without_comments(h.read_text("utf-8"))))
                                          for h in project.topic_headers(topic)))
            functions = re.findall(r"\b(machine_code_\w+)\(", driver.read_text(encoding="utf-8"))
            for compiler in compilers_of(number):
                for level in LEVELS:
                    observed = assembly_with_observer(compiler, level, driver)
                    plain_copy(topic, self.folder)  # another compiler may have needed the second copy below
                    plain = assembly(compiler, level, driver, self.folder)
                    with self.subTest(topic=topic.name, compiler=compiler, level=level):
                        if observed != plain:
                            # A closure holds what its body names: with as many instructions, others may be spilled first
                            plain_copy(topic, self.folder, "static_cast<void>(observer);")
                            self.assertEqual(observed, assembly(compiler, level, driver, self.folder))
                        for function in functions:
                            code = instructions(observed, function)
                            self.assertEqual(len(code), len(instructions(plain, function)), function)
                            self.assertGreater(len(code), LEAST_INSTRUCTIONS, function)
                            # By a jump, or by what Clang makes of a choice between two values
                            self.assertTrue(any(re.match(r"\t(j|cmov|set)[a-z]+\t", i) for i in code),
                                            f"{function} decides nothing")
                            compared += 1
        self.assertGreater(compared, 0)

    def test_one_more_instruction_is_seen(self):
        drivers = list(enumerate(sorted(DRIVERS.glob("*.cpp"))))
        for number, driver in drivers if EVERYTHING else share_of(drivers[::5], 3):
            topic = next(t for t in project.topics() if t.name == driver.stem)
            compiler = compilers_of(number)[0]
            plain_copy(topic, self.folder, 'asm volatile("nop");')
            with_cost = assembly(compiler, "-O2", driver, self.folder)
            without = assembly_with_observer(compiler, "-O2", driver)
            for function in re.findall(r"\b(machine_code_\w+)\(", driver.read_text(encoding="utf-8")):
                with self.subTest(function):
                    self.assertNotEqual(instructions(with_cost, function), instructions(without, function))


if __name__ == "__main__":
    unittest.main()
