"""Documents have one sentence per line, so that a change shows which sentence it changed.

`python3 tests/support/sentences.py` writes them so; the test architecture/docs holds them to it. What is not prose stays as it
is: code, formulas, tables, headings, HTML, definitions of links and what stands between two lines of ---.
"""
import re
import sys

import project

SKIPPED = {".git", "build", "out"}
FENCE = re.compile(r"\s*(```|~~~)")
NO_PROSE = re.compile(r"\s*(?:\||#{1,6} |<|\[[^\]]+\]: |-{3,}$|={3,}$)")
# What a block of prose begins with: quotes and the marks of lists
MARK = re.compile(r"(?:\s*(?:>|[-*+]|\d+[.)])\s+)+")
# Where full stops end nothing: code and formulas, addresses, and a heading that its sentence goes on from
UNBROKEN = re.compile(r"\$`[^`]*`\$|``.+?``|`[^`]*`|\]\([^)]*\)|<[a-z]+:[^>]*>")
RUN_IN = re.compile(r"\*\*[^*]+[.!?]\S?\*\*")
# A full stop and the first letter behind it that end no sentence: abbreviations, numbers of things, initials
ABBREVIATION = re.compile(
    r"(?:\b(?:e\.g|i\.e|cf|vs|al|ca|eds?|Dr|St|J|Proc|Trans|Conf|Comput|Anal|Appl|Comm|Graph|Int|Math)\. .?"
    r"|\b(?:Figs?|Eqs?|Secs?|Chs?|Nos?|pp?|vol)\. \d|(?:^|[,;(] |\band |\b[A-Z]\.[ -])[A-Z]\. .)$")
# The next sentence begins with a capital, a number, code, a variable's letter, or a name such as glTF
END = re.compile(r"""[.!?…]["”’)\]*_]*(?= +["“‘(\[*_$-]*(?:[^\Wa-z_]|`|[a-z](?:\b|[_²])|[a-z]+[A-Z]))""")


def sentences(prose):
    """The sentences of a block of prose, which is on one line."""
    blank = UNBROKEN.sub(lambda found: "`" + "x" * (len(found[0]) - 2) + "`", prose)
    run_in = RUN_IN.match(blank)
    found, begin = [], 0
    for end in END.finditer(blank, run_in.end() if run_in else 0):
        if not ABBREVIATION.search(blank[begin:end.start() + 3]):
            found.append(prose[begin:end.end()].strip())
            begin = end.end()
    return found + [prose[begin:].strip()]


def blocks(text):
    """(whether it is prose, its lines) for each part of a document."""
    parts, fenced, front = [], False, text.startswith("---\n")
    for number, line in enumerate(text.split("\n")):
        if front:
            front = number == 0 or line != "---"
            parts.append((False, [line]))
        elif FENCE.match(line) or fenced:
            fenced ^= bool(FENCE.match(line))
            parts.append((False, [line]))
        elif not line.strip() or NO_PROSE.match(line):
            parts.append((False, [line]))
        elif parts and parts[-1][0] and not MARK.match(line):
            parts[-1][1].append(line)
        else:
            parts.append((True, [line]))
    return parts


def one_a_line(lines):
    """A block of prose with one sentence per line."""
    mark = MARK.match(lines[0])
    first = mark[0] if mark else re.match(r"\s*", lines[0])[0]
    rest = re.sub(r"[^>\s]", " ", first)
    prose = " ".join([lines[0][len(first):].strip(), *(line.strip() for line in lines[1:])])
    return [(rest if number else first) + sentence for number, sentence in enumerate(sentences(prose))]


def written_so(text):
    """A document with one sentence per line."""
    return "\n".join(line for prose, lines in blocks(text) for line in (one_a_line(lines) if prose else lines))


def pages(root):
    return sorted(f for f in root.rglob("*.md") if not SKIPPED & set(f.relative_to(root).parts))


if __name__ == "__main__":
    for page in pages(project.ROOT):
        text = page.read_text(encoding="utf-8")
        if text != written_so(text):
            page.write_text(written_so(text), encoding="utf-8")
            print(page.relative_to(project.ROOT), file=sys.stderr)
