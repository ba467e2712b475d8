#!/usr/bin/env python3
"""docs/claims.csv (document, text, test, number): which test computes each number that a page's section on accuracy, its
comparison of methods or a contract's Accuracy line claims, that a page's mistakes have counted or measured, or that any part
of the pages in WHOLE claims. Without {} the text stands in the document as it is, and `number` is where its numbers stand in
the test's source; with {} the test reads them from the document, by a call of states() with the same text."""
import csv
import io
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import coverage_test
import project

HEADER = ["document", "text", "test", "number"]
# What no test computes. bench: times and what goes with them, printed again by `gradus bench`; a table's first line stands for
# all of it. given: how many cases, which input. run: what was taken down of one run: times of whole commands, parts of them by a
# profiler, sizes of what was built, coverage, how often a batch leaves its short cut. A bound of accuracy is none of these
KINDS = ("bench", "given", "run")
# Pages that are looked at from end to end, but for what is in code
WHOLE = tuple(f"docs/{page}.md" for page in ("demos", "engine", "exact", "fuzzing", "live", "rendering", "scenes"))
ACCURACY = re.compile(r"\b(?:ulp|u|roundings?|pixels? off|steps? of 255)\b|2(?:\^-|⁻)")
FOUND = re.compile(r"\b([Ww]ithin|worst|measured|found|at most|up to|off)\b")

SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
NUMBER = r"(?:\d[\d,]*\.\d+|\d[\d,]*\d|\d|(?<![\w.])\.\d+)(?:e[+-]?\d+)?"
POWER = r"(?:2|10)(?:\^-?\d+|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
VALUE = re.compile(rf"0x1p[-+]?\d+|{POWER}|{NUMBER}(?: ?/ ?{NUMBER}(?![\w.^]))?")
# A number claims something with a unit of accuracy, with decimals or as a small power; on a page also if it counts many
UNIT = r" ?(?:ulp\b|u\b|units? of|roundings?\b|eps\b|%|[*·] (?:2|10)(?:\^-|⁻)|pixels? off|pixels? of|square pixels)"
SMALL = r"(?<![*·] )(?:\d[\d.]*e-\d+|2\^-\d+|2⁻[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
CLAIM = rf"{NUMBER}/{NUMBER}(?={UNIT})|{NUMBER}(?={UNIT})|\d[\d,]*\.\d+(?![\d.e])|\.\d+|{SMALL}"
MANY = r"|\d{1,3}(?:,\d{3})+|\d{3,}|\d[\d.]*(?= [KMG]iB)"
# Units' definitions, code, addresses, sources, places and what is looked at are no claims
NOT_CLAIMED = re.compile(
    r"`[^`]*`|\]\([^)]*\)|\b[ue] = 2(?:\^-|⁻)\S+|\(2(?:\^-|⁻)\S+ for \w+(?:, 2\^-53 for double)?\)|2\^-24 in float"
    r"|[Aa]n? ulp is 2\S+|[Oo]ne ulp is 2\S+|in float 2⁻²³|floats, 2\^-24|(?<=times )2\^-\d+|(?<=units of )2\^-53"
    r"|\d+\(\d\), \d{4}, \d+-\d+|Access [\d., and]+|GCC [\d.]+|\(-?[\d.e+-]+(?:, ?-?[\d.e+-]+)+\)|±\d+|\d+[- ]bits?\b|\d+ x \d+"
    r"|\bseed \d+|\b[rcf] = [\d.e]+|\bat z = \d+|\^-\d\.\d+|2⁻⁶⁰ to 2⁶⁰|\d+ area|255ths|mod 256|below 256"
    r"|\d+ × \d+|\d+x\d+|(?:LLVM|Mesa|Node|OpenCV|Boost\.Geometry) [\d.]+")


def one_line(text):
    """Words with one blank between them, without the marks of comments."""
    return " ".join(word for line in text.splitlines() for word in re.sub(r"^\s*///?(?=\s|$)", "", line).split())


def passages(document, text, section="Accuracy and cost"):
    """What of a document speaks of accuracy, each on one line."""
    if document in WHOLE:
        return [one_line(part) for part in re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL).split("\n\n")]
    if document.endswith(".md"):
        return [one_line(part) for part in re.findall(rf"^## {section}\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)]
    # The contracts in a file of faults are without the marks of comments
    text = re.sub(r"(?<=^\[)(\w+\] of \w+\n)(.*?)(?=^@@$)", lambda entry: entry[1] + re.sub(r"^", "/// ", entry[2], flags=re.MULTILINE), text,
                  flags=re.MULTILINE | re.DOTALL)
    comments = re.findall(r"(?:^[ \t]*///[^\n]*\n)+|///<?[^\n]*", text, re.MULTILINE)
    paragraphs = [part for comment in comments for part in re.split(r"\n[ \t]*///[ \t]*\n", comment)]
    return [found for part in paragraphs
            for found in re.findall(r"Accuracy: (.*?)(?= (?:Cost|Errors|Steps|Domain|Source|Returns)\b:?|$)", one_line(part))]


def value(text):
    """9/4, 2⁻⁵⁰, 0x1p-50 and 13,126 (in C++ 13'126) as numbers."""
    text = text.translate(SUPERSCRIPTS).replace(",", "").replace(" ", "")
    if text.startswith("0x1p"):
        return 2.0 ** int(text[4:])
    if power := re.fullmatch(r"(2|10)\^?(-\d+)|(2|10)\^(\d+)", text):
        return float(power[1] or power[3]) ** int(power[2] or power[4])
    above, _, below = text.partition("/")
    return float(above) / float(below or 1)


def values(text):
    found = set()
    for match in VALUE.finditer(re.sub(r"(?<=\d)'(?=\d)", "", text)):
        try:
            found.add(value(match[0]))
        except (OverflowError, ZeroDivisionError):
            pass  # a source's hostile inputs
    return found


def is_one_of(text, numbers, source):
    """Whether one of the numbers, rounded to its digits if it has decimals, is this one; half an ulp is the nearest number,
    and a power of two may be given by its exponent."""
    if text == "1/2" and "nearest" in source:
        return True
    if text.startswith("2^-"):
        numbers = numbers | {2.0 ** -n for n in numbers if n == int(n) and 0 < n < 1075}
    decimals = re.fullmatch(r"[\d,]*\.(\d+)(?:e(-?\d+))?", text)
    half = 0.5000001 * 10.0 ** (int(decimals[2] or 0) - len(decimals[1])) if decimals else 0
    return any(abs(number - value(text)) <= half for number in numbers)


def claims(passage, many=True):
    """Where numbers claim something: (begin, end)."""
    ours = NOT_CLAIMED.sub(lambda match: "_" * len(match[0]), passage)
    return [match.span() for match in re.finditer(rf"(?<![\w.^/,-])(?:{CLAIM}{MANY if many else ''})(?![\w(])", ours)]


def measured(passage):
    """Where examples have numbers that nobody gives: many, or of three decimals."""
    ours = NOT_CLAIMED.sub(lambda match: "_" * len(match[0]), passage)
    return [match.span() for match in re.finditer(r"(?<![\w.^/,-])(?:\d{1,3}(?:,\d{3})+|\d*\.\d{3,}|\d+\.\d+e-\d+|\d+(?= %))(?![\w(])", ours)]


def tables(text):
    """The tables of a page, each on one line, by their first lines."""
    found = {}
    for table in re.findall(r"(?:^\|[^\n]*\n)+", text, re.MULTILINE):
        found.setdefault(one_line(table.splitlines()[0]), []).append(one_line(table))
    return found


def as_pattern(text):
    return re.compile(re.escape(text).replace(re.escape("{}"), r"[\d.,]*\d(?:e-?\d+)?"))


def documents():
    found = {}
    for folder, ending in (("docs/topics", "md"), ("algorithms", "hpp"), ("algorithms", "faults"), ("pipeline", "hpp")):
        for path in sorted((project.ROOT / folder).rglob("*." + ending)):
            found[path.relative_to(project.ROOT).as_posix()] = path.read_text(encoding="utf-8")
    return found | {page: (project.ROOT / page).read_text(encoding="utf-8") for page in WHOLE}


def states(source):
    """(document, text) of each call of states(), where the document may be the constant of this name that comes before."""
    constants = [(m.start(), m[1], m[2]) for m in re.finditer(r'(\w+) = "((?:docs|algorithms|pipeline)/[^"]+)"', source)]
    strings = r'((?:"(?:[^"\\]|\\.)*"\s*)+)'
    found = set()
    # row(): a table's rows by a function of their own, on the page that was named last
    for call in re.finditer(rf'\bstates\(\s*("[^"]+"|\w+),\s*{strings}|\brow\(\s*{strings}', source):
        before = [document for at, name, document in constants if at < call.start() and call[1] in (name, None)]
        text = "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', call[2] or call[3]))
        if (call[1] or "").startswith('"'):
            found.add((call[1].strip('"'), text))
        elif before:
            found.add((before[-1], text))
    return found


def test_sources():
    """The source of each test: of GoogleTest's by their names, of promises by promises/TOPIC, with headers of their own."""
    found = {}
    for path in project.sources(project.ROOT, "tests/unit") + project.sources(project.ROOT, "tests/property"):
        text = path.read_text(encoding="utf-8")
        for names in re.findall(r"^TEST(?:_F)?\((\w+),\s*(\w+)\)", text, re.MULTILINE):
            found[".".join(names)] = text
    for path in sorted((project.ROOT / "tests/stress").rglob("*_stress.cpp")):
        text = path.read_text(encoding="utf-8")
        for header in re.findall(r'^#include "(stress/\w+/\w+\.hpp)"', text, re.MULTILINE):
            text += (project.ROOT / "tests" / header).read_text(encoding="utf-8")
        found["promises/" + path.name.removesuffix("_stress.cpp")] = text
    for folder in ("architecture", "golden", "browser"):
        for path in sorted((project.ROOT / "tests" / folder).glob("*_test.py")):
            found[f"{folder}/{path.name.removesuffix('_test.py')}"] = path.read_text(encoding="utf-8")
    return found


def source_of(test, sources):
    return sources.get(test) or sources.get("/".join(test.split("/")[:2]))


def violations(table, texts, tests, sources):
    rows = list(csv.reader(io.StringIO(table)))
    if not rows or rows[0] != HEADER:
        return [f"the first line is {','.join(HEADER)}"]
    found, spans = [], {}
    whole = {document: one_line(text) for document, text in texts.items()}
    for line, row in enumerate(rows[1:], 2):
        if len(row) != len(HEADER):
            found.append(f"line {line}: {len(row)} fields, not {len(HEADER)}")
            continue
        document, text, test, number = row
        if document not in texts:
            found.append(f"line {line}: there is no {document}, or it isn't looked at")
            continue
        if not as_pattern(text).search(whole[document]):
            found.append(f"line {line}: {document} doesn't say: {text}")
        told = tables(texts[document]).get(text, [text]) if test in ("bench", "run") else [text]
        spans.setdefault(document, []).extend(told)
        if test in KINDS:
            if test == "given" and FOUND.search(text):
                found.append(f"line {line}: this is found, not given: {text}")
            if test == "run" and ACCURACY.search(" ".join(told)):
                found.append(f"line {line}: a bound of accuracy has a test: {text}")
            continue
        if test not in tests:
            found.append(f"line {line}: there is no test {test}")
            continue
        source = source_of(test, sources)
        if source is None:
            found.append(f"line {line}: no source of {test}")
        elif "{}" in text:
            if (document, text) not in states(source):
                found.append(f"line {line}: {test} doesn't read from {document}: {text}")
        elif not number or number not in source:
            found.append(f"line {line}: the source of {test} doesn't have: {number}")
        elif not claims(text) or not all(is_one_of(text[a:b], values(number), number) for a, b in claims(text)):
            found.append(f"line {line}: {text} and {number} are not the same numbers")
    for document, text in texts.items():
        looked_at = [(passage, claims(passage, document.endswith(".md"))) for passage in passages(document, text)]
        if document.endswith(".md") and document not in WHOLE:
            looked_at += [(passage, claims(passage)) for passage in passages(document, text, "Methods compared")]
            looked_at += [(passage, measured(passage)) for passage in passages(document, text, "Common mistakes")]
        for passage, numbers in looked_at:
            covered = [match.span() for known in spans.get(document, []) for match in as_pattern(known).finditer(passage)]
            for begin, end in numbers:
                if not any(a <= begin and end <= b for a, b in covered):
                    found.append(f"{document}: no row for {passage[begin:end]} in: …{passage[max(0, begin - 60):end + 40]}…")
    return found


def violations_of_promises(page, sources):
    """The table of promises in docs/stress.md: | `topic` | `promise` with its bound; … |, each bound in the topic's source."""
    found = []
    for topic, promises in re.findall(r"^\| `(\w+)` \| (`.*) \|$", page, re.MULTILINE):
        # Where bounds stand: in lines about them and in what promises say
        lines = sources.get("promises/" + topic, "").splitlines()
        source = "\n".join(line for line in lines if re.search(r"bound|worst|measured\(|cases|\w \w+[^{]*\"", line))
        for begin, end in claims(promises, many=False):
            if not is_one_of(promises[begin:end], values(source), source):
                found.append(f"docs/stress.md: {topic}'s promises have no {promises[begin:end]}: …{promises[max(0, begin - 40):end + 20]}…")
    return found


class Claims(unittest.TestCase):
    def test_every_number_is_computed(self):
        table = (project.ROOT / "docs/claims.csv").read_text(encoding="utf-8")
        found = violations(table, documents(), coverage_test.existing_names()["test"], test_sources())
        self.assertEqual(found, [], "\n" + "\n".join(found))

    def test_the_table_of_promises_has_their_bounds(self):
        page = (project.ROOT / "docs/stress.md").read_text(encoding="utf-8")
        found = violations_of_promises(page, test_sources())
        self.assertEqual(found, [], "\n" + "\n".join(found))
        promises = {name.split("/", 1)[1] for name in coverage_test.existing_names()["test"] if name.startswith("promises/")}
        told = re.search(r"^(\d+) promises of (\d+) topics", page, re.MULTILINE)
        self.assertEqual((int(told[1]), int(told[2])), (len(promises), len({name.split("/")[0] for name in promises})))
        self.assertGreater(len(violations_of_promises(page.replace("0.63 ulp", "0.59 ulp"), test_sources())), 1)

    def test_planted_faults_are_caught(self):
        page = "# Line\n\n## Accuracy and cost\n\nWithin 2 ulp (measured\n1.37), of 20,000 lines 24 %.\n\n## Charts\n\n0.5 ulp\n"
        header = "/// A line.\n///\n/// Domain: all. Accuracy: within 4 u of\n///   it. Cost: 9 ulp.\nvoid line();\n"
        texts = {"docs/topics/a.md": page, "algorithms/a.hpp": header}
        sources = {"promises/a": "bound = 2.0, 4 * u", "Line.Off": 'constexpr const char* page = "docs/topics/a.md";\n'
                   'states(page, "(measured {}), of 20,000 "\n  "lines {} %.", {off})'}
        tests = {"promises/a/Of/Promises.AreKept/b", "Line.Off"}
        good = ("document,text,test,number\n"
                "docs/topics/a.md,Within 2 ulp,promises/a/Of/Promises.AreKept/b,bound = 2.0\n"
                'docs/topics/a.md,"(measured {}), of 20,000 lines {} %.",Line.Off,\n'
                "algorithms/a.hpp,within 4 u of it,promises/a/Of/Promises.AreKept/b,4 * u\n")
        self.assertEqual(violations(good, texts, tests, sources), [])
        for old, new, expected in (
                ("Within 2 ulp", "Within 3 ulp", "doesn't say"), ("bound = 2.0", "4 * u", "not the same numbers"),
                ("bound = 2.0", "bound = 2.5", "doesn't have"), ("Line.Off", "Line.On", "no test Line.On"),
                ("docs/topics/a.md,Within", "docs/topics/b.md,Within", "there is no docs/topics/b.md"),
                ("promises/a/Of/Promises.AreKept/b,bound = 2.0", "bench,", None),
                ("of it,promises/a/Of/Promises.AreKept/b,4 * u", "of it,given,", "is found, not given"),
                ("of 20,000 lines", "of {} lines", "doesn't read from"),
                ("docs/topics/a.md,Within 2 ulp,promises/a/Of/Promises.AreKept/b,bound = 2.0\n", "", "no row for 2 in"),
                ("algorithms/a.hpp,within 4 u of it,promises/a/Of/Promises.AreKept/b,4 * u\n", "", "no row for 4 in"),
                ("4 * u", "4 * u,5", "5 fields"), ("document,text", "text", "the first line")):
            with self.subTest(new):
                found = violations(good.replace(old, new, 1), texts, tests, sources)
                if expected is None:
                    self.assertEqual(found, [])
                else:
                    self.assertIn(expected, "\n".join(found))
        # Another number on the page is one that the test no longer has
        moved = {**texts, "algorithms/a.hpp": header.replace("4 u", "3 u")}
        self.assertEqual(len(violations(good, moved, tests, sources)), 2)
        mistake = {**texts, "docs/topics/a.md": page + "## Common mistakes\n\nOf 1 mm and 20 are 1,234 wrong.\n"}
        self.assertIn("no row for 1,234 in", "".join(violations(good, mistake, tests, sources)))
        self.assertEqual([passages("a.hpp", header)[0][a:b] for a, b in claims(passages("a.hpp", header)[0])], ["4"])

    def test_planted_faults_of_whole_pages_and_tables_are_caught(self):
        page = ("# Live\n\n4,000 steps.\n\n```\n9 ulp\n```\n\nOff by 0.5 ulp.\n\n"
                "| topic | ms |\n|---|---|\n| a | 1.25 |\n\n| topic | ms |\n|---|---|\n| b | 2.5 |\n")
        compared = "# A\n\n## Methods compared\n\n| method | time |\n|---|---|\n| a | 1.5 |\n\nOf 4096 lines.\n"
        texts = {"docs/live.md": page, "docs/topics/a.md": compared}
        tests, sources = {"browser/live_page"}, {"browser/live_page": "steps = 4000\nulps = 0.5\n"}
        good = ("document,text,test,number\ndocs/live.md,\"4,000 steps\",browser/live_page,steps = 4000\n"
                "docs/live.md,Off by 0.5 ulp,browser/live_page,ulps = 0.5\ndocs/live.md,| topic | ms |,run,\n"
                "docs/topics/a.md,| method | time |,bench,\ndocs/topics/a.md,Of 4096 lines,given,\n")
        self.assertEqual(violations(good, texts, tests, sources), [])
        for old, new, expected in (
                ("docs/live.md,| topic | ms |,run,\n", "", ("no row for 1.25 in", "no row for 2.5 in")),
                ("docs/topics/a.md,| method | time |,bench,\n", "", ("no row for 1.5 in",)),
                ("docs/topics/a.md,Of 4096 lines,given,\n", "", ("no row for 4096 in",)),
                ("ulp,browser/live_page,ulps = 0.5", "ulp,run,", ("a bound of accuracy has a test",)),
                ("| topic | ms |,run,", "| topic | ms |,counted,", ("no test counted",))):
            with self.subTest(new):
                found = violations(good.replace(old, new, 1), texts, tests, sources)
                self.assertEqual([fault for fault in expected if fault not in "\n".join(found)], [], found)


if __name__ == "__main__":
    unittest.main()
