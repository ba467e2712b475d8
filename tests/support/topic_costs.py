"""What each topic costs: seconds to compile it, and seconds to test it.

    python3 tests/support/topic_costs.py build/release build/asan-ubsan

The seconds to compile are those of Ninja's logs; where a file was compiled again, the last time counts. The seconds to test are
those of tests.xml, which ./bootstrap test writes, and, of a program whose tests run in parts, those of the reports beside
it. A file or test belongs to the topic whose name it bears; to no topic belongs what serves them all. A topic that takes more
than continuous integration has for one is named on standard error.
"""
import pathlib
import re
import sys
from collections import Counter
from dataclasses import dataclass, field
from xml.etree import ElementTree

import project

# The part of a path, or of a program's name, that tells the kind
PARTS = {"algorithms": "algorithms", "stories": "stories", "example": "examples", "examples": "examples", "unit": "unit",
         "property": "property", "stress": "stress", "promises": "stress", "benchmark": "benchmark"}
KINDS = (*dict.fromkeys(PARTS.values()), "scripts", "others")
NO_TOPIC = "no topic's own"
MOST, CORES = 15, 2  # seconds that a topic may add to continuous integration, and what shares its work


class Refusal(Exception):
    """What was given can't be read: one line that says why."""


@dataclass
class Cost:
    compile: Counter = field(default_factory=Counter)  # kind -> seconds
    test: Counter = field(default_factory=Counter)

    def seconds(self):
        return self.compile.total() + self.test.total()


# --- What belongs where ----------------------------------------------------------------------------------------------


def topic_of(path, topics):
    """The topic whose name a path, program or test bears at the start of a part, or behind its family's; of two names the longer one."""
    found = [topic.name for topic in topics
             if re.search(rf"(?:^|/|example_|libgradus_|{topic.path.split('/')[0]}_){topic.name}(?![a-zA-Z0-9])", path)]
    return max(found, key=len, default=NO_TOPIC)


def kind_of_output(path, topic):
    """Objects are known by the source behind their target's folder, other outputs by the words of their names."""
    source = re.search(r"\.dir/(.+)\.o$", path)
    words = source[1].split("/") if source else re.split(r"[/_]", path)
    kind = next((PARTS[word] for word in words if word in PARTS), "others")
    return "algorithms" if kind == "others" and topic != NO_TOPIC else kind  # its headers alone, its library


def kind_of_test(name):
    if not re.search(r"/[A-Z]\w*\.\w", name) and name.split("/")[0] in ("architecture", "golden", "unit"):
        return "scripts"
    return PARTS.get(name.split("/")[0], "others")


# --- The two reports -------------------------------------------------------------------------------------------------


def compiled(log):
    """Output -> seconds. What one command makes together counts once."""
    if not log.startswith("# ninja log v"):
        raise Refusal("it does not begin as Ninja's log")
    last = {}
    for number, line in enumerate(log.splitlines()[1:], 2):
        fields = line.split("\t")
        if len(fields) != 5 or not (fields[0].isdigit() and fields[1].isdigit()):
            raise Refusal(f"line {number}: expected start, end, time, output and hash")
        start, end, _, output, command = fields
        last[output] = (int(start), int(end), command)
    first = {run: output for output, run in reversed(last.items())}
    return {output: (end - start) / 1000 for (start, end, _), output in first.items()}


def tested(report):
    """Test -> seconds."""
    try:
        cases = ElementTree.fromstring(report).iter("testcase")
        return {case.attrib["name"]: float(case.attrib["time"]) for case in cases}
    except (ElementTree.ParseError, KeyError, ValueError) as error:
        raise Refusal(f"expected a report as `ctest --output-junit` writes it ({error})") from error


def single_tests(tests, folder):
    """The tests, those of parts such as unit/visualize/part_2 by their own names where folder has the part's report."""
    found = {}
    for name, seconds in tests.items():
        part = re.fullmatch(r"(.+)/part_(\d+)", name)
        report = folder / f"{part[1].replace('/', '_')}_{part[2]}.xml" if part else None
        if not report or not report.is_file():
            found[name] = seconds
            continue
        own = {f"{part[1]}/{case.attrib['classname']}.{case.attrib['name']}": float(case.attrib["time"])
               for case in ElementTree.fromstring(report.read_text(encoding="utf-8")).iter("testcase")}
        found.update(own)
        found[name] = max(0, seconds - sum(own.values()))  # its start
    return found


def costs_of(outputs, tests, topics):
    """Topic -> its cost, of pairs of what was compiled and of what was tested, with their seconds."""
    costs = {name: Cost() for name in (*(topic.name for topic in topics), NO_TOPIC)}
    for output, seconds in outputs:
        topic = topic_of(re.sub(r"^.*\.dir/", "", output), topics)
        costs[topic].compile[kind_of_output(output, topic)] += seconds
    for name, seconds in tests:
        costs[topic_of(name, topics)].test[kind_of_test(name)] += seconds
    return costs


# --- The table -------------------------------------------------------------------------------------------------------


def table(costs):
    """A row per topic, the dearest first, what belongs to none of them below; then the totals of each kind."""
    columns = [kind for kind in KINDS if any(cost.compile[kind] for cost in costs.values())]
    rows = [["seconds", *columns, "compile", "test", "all"]]
    own = sorted((name for name in costs if name != NO_TOPIC), key=lambda name: -costs[name].seconds())
    for name in (*own, NO_TOPIC):
        cost = costs[name]
        rows.append([name, *(cost.compile[kind] for kind in columns), cost.compile.total(), cost.test.total(), cost.seconds()])
    totals = [["kind", "compile", "test", "all"]]
    for kind in KINDS:
        compile = sum(cost.compile[kind] for cost in costs.values())
        test = sum(cost.test[kind] for cost in costs.values())
        totals.append([kind, compile, test, compile + test])
    totals.append(["total", *(sum(column) for column in zip(*(row[1:] for row in totals[1:])))])
    return aligned(rows) + "\n" + aligned(totals)


def aligned(rows):
    texts = [[cell if isinstance(cell, str) else f"{cell:.1f}" for cell in row] for row in rows]
    widths = [max(map(len, column)) for column in zip(*texts)]
    return "".join("  ".join([row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(row[1:], widths[1:]))]) + "\n"
                   for row in texts)


def read_build(folder):
    """What was compiled and what was tested in this build."""
    parts = []
    for name, read, maker in ((".ninja_log", compiled, "a build with Ninja"), ("tests.xml", tested, "./bootstrap test")):
        path = folder / name
        try:
            parts.append(read(path.read_text(encoding="utf-8")))
        except OSError as error:
            raise Refusal(f"{path}: {error.strerror}; {maker} makes it") from error
        except Refusal as refusal:
            raise Refusal(f"{path}: {refusal}") from refusal
    return parts[0], single_tests(parts[1], folder / "tests")


def costs_of_builds(words, root):
    """The costs in all of the build folders that the words name."""
    if not words:
        raise Refusal("expected build folders, such as build/release build/asan-ubsan")
    builds = [read_build(pathlib.Path(word)) for word in words]
    return costs_of([pair for outputs, _ in builds for pair in outputs.items()],
                    [pair for _, tests in builds for pair in tests.items()], project.topics(root))


def warnings(costs):
    return [f"{name} makes continuous integration {cost.seconds() / CORES:.0f} s longer, more than {MOST}"
            for name, cost in costs.items() if name != NO_TOPIC and cost.seconds() / CORES > MOST]


if __name__ == "__main__":
    try:
        costs = costs_of_builds(sys.argv[1:], pathlib.Path(__file__).resolve().parents[2])
        print(table(costs), end="")
        for warning in warnings(costs):
            print(f"topic_costs: {warning}", file=sys.stderr)
    except Refusal as refusal:
        print(f"topic_costs: {refusal}", file=sys.stderr)
        sys.exit(2)
