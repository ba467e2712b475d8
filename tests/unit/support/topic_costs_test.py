#!/usr/bin/env python3
"""What topic_costs.py makes of logs that are made up here."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
import project
import topic_costs
from project import Topic
from topic_costs import NO_TOPIC, Refusal

TOPICS = [Topic("clipping/liang_barsky"), Topic("clipping/liang_barsky_circle"), Topic("projection/perspective")]
# start and end in milliseconds, time, output, hash of the command
LOG = "# ninja log v5\n" + "".join("\t".join(map(str, line)) + "\n" for line in [
    (0, 9000, 1, "CMakeFiles/a.dir/tests/unit/clipping/liang_barsky_test.cpp.o", "a"),
    (0, 4000, 2, "CMakeFiles/a.dir/tests/unit/clipping/liang_barsky_test.cpp.o", "a"),  # again, and that counts
    (100, 2100, 1, "CMakeFiles/gradus_stories.dir/visualize/stories/clipping/liang_barsky_circle_story.cpp.o", "b"),
    (5, 1005, 1, "generated/one.cpp", "c"),
    (5, 1005, 1, "generated/two.cpp", "c"),  # by the same command
    (0, 500, 1, "tests/unit_clipping_liang_barsky", "d")])
REPORT = """<testsuite><testcase name="unit/clipping/liang_barsky/LiangBarsky.Ends" time="0.25" status="run"/>
<testcase name="architecture/layers" time="1.5" status="run"/></testsuite>"""


class Belonging(unittest.TestCase):
    def test_topics(self):
        for path, topic in (("tests/unit/clipping/liang_barsky_test.cpp.o", "liang_barsky"),
                            ("unit/clipping/liang_barsky_box_test.cpp.o", "liang_barsky"),
                            ("tests/stress/clipping/liang_barsky_circle_stress.cpp.o", "liang_barsky_circle"),
                            ("headers_alone/clipping_liang_barsky_liang_barsky_box_hpp.cpp.o", "liang_barsky"),
                            ("headers_alone/stages_3_perspective_hpp.cpp.o", NO_TOPIC),
                            ("visualize/stories/clipping/window_drawing.cpp.o", NO_TOPIC),
                            ("tests/unit_clipping_liang_barsky_circle", "liang_barsky_circle"),
                            ("bin/example_perspective", "perspective"),
                            ("libgradus_liang_barsky_circle_batch.a", "liang_barsky_circle"),
                            ("property/stress/promises_property/Of/Promises.AreKept/liang_barsky_correctly_rounded", "liang_barsky"),
                            ("property/visualize/strain_property/Topics/Strain.GivesNoWay/perspective  # GetParam() = 0x5", "perspective"),
                            ("unit/projection/perspectives/Own.Name", NO_TOPIC),
                            ("example/liang_barsky_circle", "liang_barsky_circle"),
                            ("unit/core/record/Recorder.KeepsSteps", NO_TOPIC)):
            self.assertEqual(topic_costs.topic_of(path, TOPICS), topic, path)

    def test_kinds_of_outputs(self):
        for path, topic, kind in (
                ("CMakeFiles/a.dir/tests/unit/clipping/liang_barsky_test.cpp.o", "liang_barsky", "unit"),
                ("tests/CMakeFiles/a.dir/property/stress/promises_property_test.cpp.o", NO_TOPIC, "property"),
                ("CMakeFiles/a.dir/visualize/stories/clipping/a_story.cpp.o", NO_TOPIC, "stories"),
                ("CMakeFiles/a.dir/headers_alone/clipping_liang_barsky_hpp.cpp.o", "liang_barsky", "algorithms"),
                ("CMakeFiles/a.dir/headers_alone/theme_finish_hpp.cpp.o", NO_TOPIC, "others"),
                ("CMakeFiles/a.dir/tests/benchmark/main.cpp.o", NO_TOPIC, "benchmark"),
                ("tests/unit_clipping_liang_barsky", "liang_barsky", "unit"),
                ("bin/example_perspective", "perspective", "examples"),
                ("tests/promises_clipping_liang_barsky", "liang_barsky", "stress"),
                ("CMakeFiles/gradus_precompiled.dir/cmake_pch.hxx.gch", NO_TOPIC, "others")):
            self.assertEqual(topic_costs.kind_of_output(path, topic), kind, path)

    def test_kinds_of_tests(self):
        for name, kind in (("unit/clipping/liang_barsky/LiangBarsky.Ends", "unit"), ("unit/support/topic_costs", "scripts"),
                           ("property/stress/promises_property/Of/Promises.AreKept/liang_barsky_box", "property"),
                           ("golden/cli", "scripts"), ("golden/listing/Listing.Shows", "others"), ("architecture/layers", "scripts"),
                           ("example/perspective", "examples"), ("corpus/json", "others"), ("browser/player", "others")):
            self.assertEqual(topic_costs.kind_of_test(name), kind, name)


class Reports(unittest.TestCase):
    def costs(self, times=1):
        return topic_costs.costs_of([*topic_costs.compiled(LOG).items()] * times, [*topic_costs.tested(REPORT).items()] * times, TOPICS)

    def test_builds_are_summed_up(self):
        self.assertEqual(self.costs(2)["liang_barsky"].seconds(), 2 * 4.75)

    def test_what_is_too_dear_is_named(self):
        self.assertEqual(topic_costs.warnings(self.costs(6)), [])
        self.assertEqual(topic_costs.warnings(self.costs(7)), ["liang_barsky makes continuous integration 17 s longer, more than 15"])

    def test_tests_of_a_part_are_told_one_by_one(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (folder / "unit_visualize_2.xml").write_text(
            '<testsuites><testsuite name="Fill"><testcase name="Ends" classname="Fill" time="3"/></testsuite></testsuites>')
        found = topic_costs.single_tests({"unit/visualize/part_1": 2, "unit/visualize/part_2": 5, "golden/cli": 1}, folder)
        self.assertEqual(found, {"unit/visualize/part_1": 2, "unit/visualize/Fill.Ends": 3, "unit/visualize/part_2": 2, "golden/cli": 1})

    def test_the_last_run_of_each_command_counts_once(self):
        self.assertEqual(sorted(topic_costs.compiled(LOG).values()), [0.5, 1.0, 2.0, 4.0])

    def test_what_is_no_report_is_refused(self):
        for read, text, reason in ((topic_costs.compiled, "", "does not begin"),
                                   (topic_costs.compiled, "# ninja log v5\n1\t2\n", "line 2"),
                                   (topic_costs.compiled, LOG + "a\tb\t1\tx\tc\n", "line 8"),
                                   (topic_costs.tested, "<testsuite>", "ctest --output-junit"),
                                   (topic_costs.tested, '<t><testcase name="a"/></t>', "ctest --output-junit"),
                                   (topic_costs.tested, '<t><testcase name="a" time="x"/></t>', "ctest --output-junit")):
            with self.assertRaisesRegex(Refusal, reason):
                read(text)

    def test_nothing_is_lost(self):
        costs = self.costs()
        self.assertEqual(costs["liang_barsky"].compile, {"unit": 4.5})
        self.assertEqual(costs["liang_barsky"].test, {"unit": 0.25})
        self.assertEqual(costs["liang_barsky_circle"].compile, {"stories": 2})
        self.assertEqual(costs["perspective"].seconds(), 0)
        self.assertEqual(costs[NO_TOPIC].test, {"scripts": 1.5})
        self.assertEqual(sum(cost.seconds() for cost in costs.values()), 4.5 + 2 + 1 + 0.25 + 1.5)

    def test_the_dearest_comes_first_and_kinds_are_summed_up(self):
        costs = self.costs()
        first, second = topic_costs.table(costs).split("\n\n")
        self.assertEqual([line.split() for line in first.splitlines()], [
            ["seconds", "stories", "unit", "others", "compile", "test", "all"],
            ["liang_barsky", "0.0", "4.5", "0.0", "4.5", "0.2", "4.8"],
            ["liang_barsky_circle", "2.0", "0.0", "0.0", "2.0", "0.0", "2.0"],
            ["perspective", "0.0", "0.0", "0.0", "0.0", "0.0", "0.0"],
            [*NO_TOPIC.split(), "0.0", "0.0", "1.0", "1.0", "1.5", "2.5"]])
        totals = {line.split()[0]: line.split()[1:] for line in second.splitlines()}
        self.assertEqual(list(totals), ["kind", *topic_costs.KINDS, "total"])
        self.assertEqual(totals["unit"], ["4.5", "0.2", "4.8"])
        self.assertEqual(totals["scripts"], ["0.0", "1.5", "1.5"])
        self.assertEqual(totals["total"], ["7.5", "1.8", "9.2"])


class Command(unittest.TestCase):
    def run_on(self, *words):
        return subprocess.run([sys.executable, "-B", project.ROOT / "tests/support/topic_costs.py", *words],
                              stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8")

    def test_a_build_is_told(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (folder / ".ninja_log").write_text(LOG, encoding="utf-8")
        (folder / "tests.xml").write_text(REPORT, encoding="utf-8")
        done = self.run_on(folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\Aseconds .*\nliang_barsky  ")

    def test_bad_input_is_one_line(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for words, reason in (((), "expected build folders"),
                              ((folder,), r"\.ninja_log: No such file or directory; a build with Ninja makes it")):
            done = self.run_on(*words)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertRegex(done.stderr, rf"\Atopic_costs: .*{reason}.*\n\Z")
        (folder / ".ninja_log").write_text("# ninja log v5\n", encoding="utf-8")
        self.assertRegex(self.run_on(folder).stderr, r"tests\.xml: No such file or directory; \./bootstrap test makes it\n\Z")
        (folder / "tests.xml").write_text("{}", encoding="utf-8")
        self.assertRegex(self.run_on(folder).stderr, r"\Atopic_costs: .*tests\.xml: expected a report .*\n\Z")


if __name__ == "__main__":
    unittest.main()
