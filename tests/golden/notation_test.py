#!/usr/bin/env python3
"""Notations from end to end: on the command line, in a lecture, and in figures made again.

    tests/golden/notation_test.py [GRADUS]
"""
import json
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, check, equal

OWN = {"symbols": {"p": "q"}, "bits": "LRBT", "vectors": "rows", "depth": [-1, 1]}
LINE = {"topic": "bresenham_line", "input": {}, "outputs": ["csv"]}
CODES = {"topic": "cohen_sutherland_2d", "input": {}, "outputs": ["svg"]}


def gradus(*words):
    """Exit code, stdout, stderr."""
    done = subprocess.run([GRADUS, *words], capture_output=True, timeout=300)
    return done.returncode, done.stdout.decode().replace("\u00a0", " "), done.stderr.decode()


def write(path, content):
    text = content if isinstance(content, str) else json.dumps(content, indent=1)
    pathlib.Path(path).write_text(text, encoding="utf-8")


def told(topic, *words):
    code, out, err = gradus("run", topic, *words)
    equal((code, err), (0, ""), " ".join(words))
    return out


def refused(expected, *words):
    code, out, err = gradus("run", "bresenham_line", *words)
    equal((code, out), (2, ""), " ".join(words))
    check(re.fullmatch(r"gradus: " + expected + r"[^\n]*\n", err), f"{err} for {words}")


def test_named_ones():
    line = told("bresenham_line", "--notation", "foley")
    check("d = p in the code" in line and "so d = 2·3 − 7 = −1" in line, line)
    equal(told("bresenham_line", "--notation", "hearn"), told("bresenham_line"), "her book has the code's p")
    check("t" not in told("liang_barsky", "--notation", "hearn").splitlines()[2].split(), "u, not t")
    codes = told("cohen_sutherland_3d", "--notation", "foley")
    check("000100 (left), b the code 101010 (right, top, far)" in codes, codes)
    for book, third in {"foley": "n = −forward", "hearn": "n = −forward", "shirley": "w = −forward", "opengl": "f = forward"}.items():
        view = told("viewing", "--notation", book)
        check(third + " in the code" in view and "to (0, 0, −2.5)" in view, view)


def test_a_label_given_besides_wins():
    check("P = p in the code" in told("bresenham_line", "--notation", "foley", "--label", "p=P"), "her own")
    check("in the code" not in told("bresenham_line", "--notation", "foley", "--label", "p=p"), "the code's")


def test_own_ones():
    write("own.json", OWN)
    for given in ("own.json", json.dumps(OWN)):
        check("q = p in the code" in told("bresenham_line", "--notation", given), given)
        check("vectors are columns" in told("affine_2d", "--notation", given), given)
    code, _, err = gradus("figure", "cohen_sutherland_2d", "--notation", "own.json", "-q", "-o", "codes.svg")
    equal((code, err), (0, ""), "a figure")
    pathlib.Path("own.json").unlink()
    before = pathlib.Path("codes.svg").read_bytes()
    equal(gradus("again", "codes.svg", "-q", "-o", "again.svg"), (0, "", ""), "without the file")
    equal(pathlib.Path("again.svg").read_bytes(), before, "the same figure")
    # What programs read is as in the code
    json_of = [gradus("run", "viewing", "--json", *words)[1] for words in ([], ["--notation", "foley"])]
    equal(*(json.loads(text)["result"] for text in json_of), "the result")


def test_wrong_ones():
    refused(r"--notation: expected one of foley, hearn, shirley, opengl, or a file like own\.json, found 'foly', did you mean 'foley'\?",
            "--notation", "foly")
    refused(r"--notation: .*none\.json", "--notation", "none.json")
    write("broken.json", "{\n \"bits\": \n")
    refused(r"--notation: broken\.json:\d+: expected", "--notation", "broken.json")
    write("bits.json", '{\n "symbols": {},\n "bits": "TBRX"\n}')
    refused(r"--notation: bits\.json:3: bits: expected an order of the borders .*, found 'TBRX'", "--notation", "bits.json")
    write("key.json", '{"bit": "TBRL"}')
    refused(r"--notation: key\.json:1: bit: expected one of symbols, .*, found 'bit', did you mean 'bits'\?", "--notation", "key.json")


def test_in_a_lecture():
    write("own.json", OWN)
    write("a.json", {"notation": "foley", "figures": [{**LINE, "name": "of_book"}, {**LINE, "name": "own", "notation": OWN},
                                                      {**CODES, "name": "of_file", "notation": "own.json"}]})
    equal(gradus("figures", "a.json", "-o", "out", "-q")[0], 0, "drawn")
    heads = {name: pathlib.Path("out", name, f"{name}.csv").read_text(encoding="utf-8") for name in ("of_book", "own")}
    check("d = −1" in heads["of_book"], heads["of_book"])
    check("q = −1" in heads["own"], heads["own"])
    for name, value, line, expected in (
            ("name", "foly", 3, "notation: expected one of foley, hearn, shirley, opengl, or a file like own.json, found 'foly'"),
            ("kind", 3, 3, "notation: expected a text or an object, found 3"),
            ("key", {"vectors": "row"}, 4, "notation.vectors: expected columns or rows, found 'row'"),
            ("symbol", {"symbols": {"bresenham_line": {"pp": "d"}}}, 6, "notation.symbols.bresenham_line.pp: expected one of the symbols")):
        write(f"{name}.json", '{"figures": [' + json.dumps(LINE) + '],\n\n "notation": ' + json.dumps(value, indent=1) + "}")
        code, _, err = gradus("figures", f"{name}.json", "--check")
        equal(code, 2, name)
        check(err.startswith(f"gradus: {name}.json:{line}: {expected}"), err)


def test_help_and_completion_know_it():
    for words in (["run", "--help"], ["figure", "--help"], ["figures", "--help"]):
        check("--notation" in gradus(*words)[1], words)


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
