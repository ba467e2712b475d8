#!/usr/bin/env python3
"""Turns of phrase that catalogues, documents and comments do without: English that is translated German, joints that end a
sentence and go on, two German words for one thing, a listing spoken of to listeners who see none, two kinds of apostrophe.

Only what is always wrong here is listed: a form that is right somewhere gets a pattern that lets it pass there."""
import json
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project

# "so did the other" is no joint
JOINT = r"; so (?!did\b|do\b|does\b|has\b|have\b|had\b|is\b|are\b|was\b|were\b|can\b|must\b|with\b)"
# "100 a pixel", "a byte a cell", "once a frame"; not "how many samples a pixel has", "times a vertex", "0 a pixel away"
MEASURE = (r"(?<!many )(?:\b(?:samples?|rays?|texels?|lights|plots?|bytes?|bits?|ns|us|(?:nano|micro|milli)seconds?|ulp|u|"
           r"roundings?|divisions?|multiplications?|additions?|products?|comparisons?|operations?|questions?|tests?|once|one|"
           r"row|page|cycles?|revolutions?|colours?|numbers?|sentences?|times(?! an? (?:vertex|factor)))|"
           r"(?<![\d.,])[1-9](?:[\d.,]*\d)?|\{\})")
OF_EACH = (r"(?:pixel|sample|face|vertex|polygon|fragment|place|cycle|column|row|cell|frame|step|topic|method|corner|edge|"
           r"triangle|piece|student|side|line|factor|component|entry|coordinate|item|call|run|texel|lamp|revolution|page|inch)")
ENGLISH = {
    rf"{MEASURE} an? (?:covered |visible )?{OF_EACH}\b(?!'s| on\b)": "per pixel",
    JOINT: "a comma, a colon or two sentences",
    r"\b[Ww]hoever\b": "say who it is, or what it is for",
    r"\bthat there (?:is|are)\b": "that exists, or nothing at all",
    r"\bha(?:s|ve) none\b(?! but\b)": "lacks it, or is without it",
    r"\bnone of (?:this|that|its) (?:name|key)\b": "lacks it",
    r"\boutside of\b": "outside",
    r"(?<![Tt]he )\binside of\b": "inside",
    r"\bnot, too\b": "say what is so then",
    r"\b[Oo]bserver nobody is\b": "the default observer",
    r"\bwhatever (?:it|they|that|this) (?:is|are|was|were|holds?|says?|begins?)\b": "any, or regardless of",
}
ENGLISH_TEXTS = {
    **ENGLISH,
    r"\blistings?\b": "listeners see none: the method, the code",
    r", for (?:it|they|its|their|this|none)\b": "because",
    r"(?<=[A-Za-z\]}])'": "’",
    r'"': "“ and ”",
}
GERMAN_TEXTS = {
    r"[,;:] also\b|\balso (?:ist|sind|wird|werden|liegt|bleibt)\b": "ein Doppelpunkt, „und“ oder „daher“",
    r"\bProben?\b": "Abtastpunkt (der Ort) oder Abtastwert (der Wert)",
    r"\bListings?\b": "das Verfahren, der Code",
    r"\b(?:einen|jede[rn]|denselben|derselbe|diese[rn]) (?:fertigen? )?Pixel\b": "das Pixel",
    r"\bAugenraum|\bClip-Raum|\bSichtlinie|\bBildzeile|\bwaagrecht": "Sichtraum, Clipraum, Sehstrahl, Rasterzeile, waagerecht",
    r"\b(?:du|dir|dich|dein\w*)\b|\w+en Sie\b": "unpersönlich",
    r"(?:^|[:.;] )(?:Addiere|Beginne|Berechne|Bringe|Dividiere|Färbe|Finde|Fülle|Gehe|Gewichte|Gib|Glätte|Lass|Male|Merke|Nimm|"
    r"Ordne|Setze|Sieh|Teile|Zeichne)\b": "unpersönlich: ein Infinitiv, „Beginn bei“",
    r"(?<=\w)'(?=\w)": "’",
    r'"': "„ und “",
    r"\bso dass\b": "sodass",
    r"\{bytes\} Byte\b": "Bytes",
    r"\büberdeck(?:t|en)\b": "bedeckt",
    r"\b(?:der|einen|jeder|nächster|neuer) Texel\b(?! (?:um|jeder|der|liegen)\b)": "das Texel",
}
# Texts of releases that are out; the words themselves
NOT_OURS = re.compile(r"CHANGELOG\.md|tests/architecture/wording_test\.py")


def offenders(text, words):
    """(line number, what was found, what to say instead) for each match in a text."""
    if not re.search("|".join(words), text, re.MULTILINE):
        return []
    return [(number, match.group(0), better) for number, line in enumerate(text.split("\n"), 1)
            for pattern, better in words.items() for match in re.finditer(pattern, line)]


def texts_of(catalogue):
    """A catalogue's texts in their lines, without keys and comments."""
    return "\n".join("" if line.startswith("#") else line.partition(" = ")[2] for line in catalogue.split("\n"))


def captions_of(lecture):
    return "\n".join(json.loads(match[1]) if (match := re.search(r'"caption": ("(?:[^"\\]|\\.)*")', line)) else ""
                     for line in lecture.split("\n"))


def comments_of(source, marks):
    """The comments of a source in their lines; what begins within a word is an address or a text."""
    comment = re.compile(rf"(?:^|\s)(?:{marks}).*")
    return "\n".join(found.group(0) if (found := comment.search(line)) else "" for line in source.split("\n"))


# The words of an entry of faults bear no mark, so all of it is read
MARKS = {".hpp": "//", ".cpp": "//", ".faults": r"\S", ".js": r"//|/\*|\*", ".py": '#|"""'}


def strings_of(source):
    """The texts in double quotes of a source in their lines, without its comments."""
    return "\n".join(" ".join(re.findall(r'"((?:[^"\\]|\\.)*)"', re.sub(r"(?:^|\s)//.*", "", line)))
                     for line in source.split("\n"))


def files(root, *ends):
    """The project's own files, in order."""
    found = [path for folder in ("algorithms", "pipeline", "visualize", "examples", "tests", "docs")
             for path in (root / folder).rglob("*") if path.name.endswith(ends)]
    found += [path for path in root.iterdir() if path.name.endswith(ends)]
    return [path for path in sorted(found) if not NOT_OURS.fullmatch(path.relative_to(root).as_posix())]


class Wording(unittest.TestCase):
    """What is written now. A test reports all that it finds."""

    def judge(self, paths, words, part=lambda path, text: text):
        said = []
        for path in paths:
            name = path.relative_to(project.ROOT).as_posix()
            said += [f"{name}:{number}: {found!r}; better: {better}"
                     for number, found, better in offenders(part(path, path.read_text(encoding="utf-8")), words)]
        self.assertEqual(said, [], "\n" + "\n".join(said))

    def catalogues(self, language):
        paths = files(project.ROOT, f".{language}.txt") + [project.ROOT / f"visualize/figure/language/{language}.txt"]
        self.assertGreater(len(paths), 30)
        return paths

    def test_english_catalogues(self):
        self.judge(self.catalogues("en"), ENGLISH_TEXTS, lambda _, text: texts_of(text))

    def test_german_catalogues(self):
        self.judge(self.catalogues("de"), GERMAN_TEXTS, lambda _, text: texts_of(text))

    def test_captions(self):
        paths = [project.ROOT / "examples/gallery.json", project.ROOT / "examples/lecture/scan_conversion.json"]
        self.judge(paths, ENGLISH_TEXTS, lambda _, text: captions_of(text))

    def test_documents(self):
        paths = files(project.ROOT, ".md")
        self.assertGreater(len(paths), 80)
        self.judge(paths, ENGLISH)

    def test_comments(self):
        paths = files(project.ROOT, *MARKS)
        self.assertGreater(len(paths), 1200)

        def comments(path, text):
            return comments_of(text, MARKS[path.suffix]) if re.search("|".join(ENGLISH), text) else ""
        self.judge(paths, ENGLISH, comments)

    def test_texts_of_the_command(self):
        """Help, refusals and names of benchmarks, which stand in the sources."""
        paths = [path for path in files(project.ROOT, ".hpp", ".cpp") if "tests/unit" not in path.as_posix()]
        self.assertGreater(len(paths), 600)
        self.judge(paths, ENGLISH, lambda _, text: strings_of(text) if re.search("|".join(ENGLISH), text) else "")


class WhatIsSeen(unittest.TestCase):
    """The forms that stood here once."""

    def test_english(self):
        for text in ("Sample 3 lies outside of A; so it shows what it showed.", "what lies inside of it",
                     "all of them, for whoever chooses one", "a face with corners that have none", "Throws for steps that there are not",
                     "Whether a flag was given; not, too, where the topic has none of this name.",
                     "The observer nobody is: every algorithm's default.", "an error, whatever it is, ends it",
                     "{n} samples a pixel", "light once a face", "100 a pixel", "{} a vertex", "16 bytes a vertex, 60 a piece",
                     "about 0.3 us a corner", "within 9/4 ulp a component", "a colour a covered sample", "n times a revolution"):
            self.assertTrue(offenders(text, ENGLISH), text)
        for text in ("The first has passed, and so did the other; so did a third.", "It has none but plain locals.",
                     "whatever the order of the faces", "Each lies outside its box.", "the inside of a room",
                     "{n} samples per pixel", "half of a pixel", "how many samples a pixel has",
                     "M times a vertex", "0 a pixel away", "25 frames a second", "one a step on",
                     "light that a fragment gets", "a plane cuts an edge", "at 32 a line's start"):
            self.assertFalse(offenders(text, ENGLISH), text)

    def test_english_texts(self):
        for text in ("so the listing skips it", "the textbook's", "{name}'s side",
                     "all are the nearest ones, for this line is short enough", '"and" leaves them'):
            self.assertTrue(offenders(text, ENGLISH_TEXTS), text)
        for text in ("the textbook’s", "ready for this line"):
            self.assertFalse(offenders(text, ENGLISH_TEXTS), text)

    def test_german_texts(self):
        for text in ("außerhalb; also zeigt er", "ist 0, also liegt", "9 Proben wurden genommen", "das Listing hört auf",
                     "sieht denselben fertigen Pixel", "in jeden Pixel", "längs der Sichtlinien", "deine Antwort",
                     "Füllen Sie die Felder aus", "Zeichne die Pixel", "Glätte ein Polygon", "das Dreieck überdeckt", "nächster Texel", "so dass keines", "der Start's", "{bytes} Byte"):
            self.assertTrue(offenders(text, GERMAN_TEXTS), text)
        for text in ("das Pixel", "in jedem Pixel", "Sie liegt innen", "Die Zeichnung", "ein Abtastpunkt", "Startwert {seed}",
                     "von der Stelle"):
            self.assertFalse(offenders(text, GERMAN_TEXTS), text)

    def test_comments_and_captions(self):
        self.assertTrue(offenders(comments_of("int a;  ///< whoever reads it", MARKS[".hpp"]), ENGLISH))
        self.assertTrue(offenders(comments_of("x = 1  # whoever reads it", MARKS[".py"]), ENGLISH))
        self.assertFalse(offenders(comments_of('say("for whoever");', MARKS[".hpp"]), ENGLISH))
        self.assertTrue(offenders(comments_of("FAULTY: for\nwhoever looks", MARKS[".faults"]), ENGLISH))
        self.assertTrue(offenders(strings_of('refuse("a \\"pixel\\" has none");  // said'), ENGLISH))
        self.assertFalse(offenders(strings_of('refuse("it");  // for "whoever"'), ENGLISH))
        self.assertTrue(offenders(captions_of('"name": "a",\n"caption": "the notes\' \\"b\\" c"\n'), ENGLISH_TEXTS))
        self.assertTrue(offenders(texts_of("a = whoever\n# no text\nb = c"), ENGLISH))
        self.assertFalse(offenders(texts_of("whoever = a\n# whoever"), ENGLISH))


if __name__ == "__main__":
    unittest.main()
