#!/usr/bin/env python3
"""The formulas of the pages as MathML: docs/topics/formulas.txt, made from the TeX in docs/.

    tests/support/formulas.py > docs/topics/formulas.txt

Two lines a formula: TeX as a page has it, between $` and `$ or as a line of a block ```math, then the contents of a
<math> element. It is made by blahtexml (package blahtexml) and kept with the pages, so that only writing a formula needs
that program.
"""
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import project

KEPT = "docs/topics/formulas.txt"


def formulas_in(text):
    """The formulas of a page; those in code that is shown as code are none."""
    found = []
    for block in re.findall(r"^```math\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
        found += block.splitlines()
    without_blocks = re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)
    return found + [tex.replace("\n", " ") for tex in re.findall(r"\$`([^`]+)`\$", without_blocks)]


def formulas(root=project.ROOT):
    pages = [root / "docs/errata.md", *sorted((root / "docs/topics").glob("*/*.md"))]
    return sorted({tex for page in pages for tex in formulas_in(page.read_text(encoding="utf-8"))})


def mathml(tex):
    run = subprocess.run(["blahtexml", "--mathml"], input=tex.replace("\\|", "|"), capture_output=True, text=True, check=True)
    markup = re.search(r"<markup>(.*?)</markup>", run.stdout, re.DOTALL)
    if not markup:
        sys.exit(f"formulas.py: blahtexml does not take {tex}: {run.stdout}")
    return markup[1].replace("\n", "")


def kept(root=project.ROOT):
    """{TeX: MathML} of the file."""
    lines = (root / KEPT).read_text(encoding="utf-8").splitlines()
    return dict(zip(lines[::2], lines[1::2]))


if __name__ == "__main__":
    for formula in formulas():
        print(f"{formula}\n{mathml(formula)}")
