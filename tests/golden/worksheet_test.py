#!/usr/bin/env python3
"""`gradus worksheet` from end to end: files, keys, answers against `gradus run`, languages, names, refusals.

    tests/golden/worksheet_test.py [GRADUS]
"""
import base64
import csv
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import unicodedata
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal, files, gradus, read, write

LINE = ["worksheet", "bresenham_line"]
NAMES = "Ada Lovelace\nZoë & Łukasz_{50%}\n<b>]]></b> \"q\"\n"
FIELD = re.compile(r"\{([0-9]+):(NUMERICAL|SHORTANSWER):((?:\\.|[^}\\])*)\}")


def pages_text(path):
    done = subprocess.run(["pdftotext", "-layout", path, "-"], capture_output=True, check=True)
    return done.stdout.decode().split("\f")[:-1]


def made(*words, **options):
    result = gradus(*words, **options)
    equal(result.code, 0, f"{words}: {result.err}")
    return result


# --- Files -------------------------------------------------------------------------------------------------------------


def test_a_sheet_and_its_key():
    result = made(*LINE, "-o", "sheet.pdf")
    equal((result.out, result.err), ("", "sheet.pdf\nsheet-key.pdf\n"), "what was made")
    equal(files(), ["sheet-key.pdf", "sheet.pdf"], "files")
    before = {name: read(name) for name in files()}
    made(*LINE, "-o", "sheet.pdf", "-q")
    equal({name: read(name) for name in files()}, before, "the same bytes")
    made(*LINE, "-o", "sheet.pdf", "--seed", "2")
    check(all(read(name) != before[name] for name in before), "another seed")
    check(b"--seed" not in read("sheet.pdf"), "a sheet does not tell its seed")
    check(b"--seed 2" in read("sheet-key.pdf"), "a key does")
    for kind, count in (("tex", 4), ("xml", 1)):
        os.mkdir(kind)
        made(*LINE, "-o", f"{kind}/sheet.{kind}", "-q")
        equal(len(files(kind)), count, f"{files(kind)}")
        made(*LINE, "-o", f"{kind}/sheet.{kind}", "-q", "--seed", "3")  # its own files give way
    made(*LINE, "-o", "a.pdf", "--key", "b.pdf", "--no-drawing", "-q")
    equal(gradus("again", "sheet.pdf").code, 2, "a worksheet is no figure")
    one = made(*LINE, "-o", "-", "--format", "tex", "--no-drawing")
    check(one.out.startswith("\\documentclass[11pt,a4paper]{article}") and "\\end{document}" in one.out, one.out)


def test_pages_say_what_they_should():
    write("names.txt", "name\nAda Lovelace\n\n  Zoë \r\n")
    for language, name, points, key in (("en", "Name: Ada Lovelace", "____ of 10 points", "Answer key"),
                                        ("de", "Name: Ada Lovelace", "____ von 10 Punkten", "Lösung")):
        made(*LINE, "liang_barsky", "-o", "s.pdf", "--students", "names.txt", "--language", language, "--points", "20", "-q")
        sheets, keys = pages_text("s.pdf"), pages_text("s-key.pdf")
        equal((len(sheets), len(keys)), (4, 4), "a page per task and student")
        check(name in sheets[0] and "Zoë" in sheets[2], sheets[0])
        check(all(key in page for page in keys) and not any(key in page for page in sheets), "the key is apart")
        totals = [sum(float(number.replace(",", ".")) for number in re.findall(r"____ (?:of|von) ([\d.,]+) ", page))
                  for page in sheets]
        equal((totals[0] + totals[1], totals[2] + totals[3]), (20, 20), "points of each student")
    made(*LINE, "-o", "letter.pdf", "--paper", "letter", "-q")
    size = subprocess.run(["pdfinfo", "letter.pdf"], capture_output=True, text=True).stdout
    check("612 x 792" in size, size)
    noted = made(*LINE, "-o", "n.pdf", "--label", "p=d", "-q") and pages_text("n.pdf")[0]
    check(re.search(r"^ +k +x +y +d +", noted, re.M), noted)


def test_a_lecture_says_how():
    write("mine.json", '{"language": "de", "figures": [{"topic": "bresenham_line", "input": {"to": "5,2"}, "labels": {"p": "d"}}]}')
    made(*LINE, "-o", "s.pdf", "--lecture", "mine.json", "-q")
    page = pages_text("s.pdf")[0]
    check("Die leeren Felder der Tabelle" in page and re.search(r"^ +k +x +y +d +", page, re.M), page)
    equal(len(re.findall(r"^ +[0-5] *$|^ +0 ", page, re.M)) >= 6, True, "six rows")
    result = gradus("worksheet", "liang_barsky", "-o", "t.pdf", "--lecture", "mine.json")
    equal((result.code, result.err), (2, "gradus: --lecture: expected a lecture with a figure of liang_barsky, found 'mine.json'\n"),
          "a lecture without the topic")


# --- Answers ---------------------------------------------------------------------------------------------------------


def questions_in(path):
    root = ElementTree.parse(path).getroot()
    equal(root.tag, "quiz", "Moodle's root")
    return [question for question in root if question.get("type") == "cloze"]


def cells_of(html):
    """Rows of a question's table: text, or (mark, type, answers)."""
    def plain(text):
        for entity, sign in (("&lt;", "<"), ("&gt;", ">"), ("&quot;", '"'), ("&#123;", "{"), ("&#125;", "}"), ("&amp;", "&")):
            text = text.replace(entity, sign)
        return text
    rows = []
    for row in re.findall(r"<tr>(<td.*?)</tr>", html):
        cells = []
        for cell in re.findall(r"<td[^>]*>(.*?)</td>", row):
            field = FIELD.fullmatch(cell)
            cells.append((int(field[1]), field[2], [re.sub(r"\\(.)", r"\1", plain(a.lstrip("="))) for a in field[3].split("~")])
                         if field else plain(cell))
        rows.append(cells)
    return rows


def table_of(topic, given):
    words = []
    for argument in given.split(" · "):
        name, _, value = argument.partition(" ")
        words.append(f"--{name}={value}")
    result = made("figure", topic, *words, "--numbers", "fractions", "-o", "-", "--format", "csv")
    rows = list(csv.reader(io.StringIO(result.out)))
    return [row[3:-1] for row in rows[1:]]


def test_the_input_says_the_digits_of_the_notation():
    """The letters that the input names decode the first row's codes, by where the ends of the segment lie."""
    for topic, key, bits, box in (("cohen_sutherland_2d", "bits", "LRBT", "window"), ("cohen_sutherland_2d", "bits", "BTRL", "window"),
                                  ("cohen_sutherland_3d", "bits_in_space", "TBRLFN", "box"), ("cohen_sutherland_2d", "bits", "", "window")):
        notation = ["--notation", json.dumps({key: bits})] if bits else []
        made("worksheet", topic, *notation, "-o", "codes.tex", "--force", "-q")
        text = read("codes.tex").decode()
        said = dict(re.findall(r"(line|window|box|code-bits) (\S+)", re.search(r"\\raggedright (line .*?)\\par", text)[1]))
        check(said["code-bits"] == (bits or "TBRL"), f"{topic}: {said}")
        ends, borders = ([float(number) for number in said[name].split(",")] for name in ("line", box))
        axes = len(ends) // 2
        first = re.findall(r"\$([01]{%d})\$" % (2 * axes), text)[:2]
        for code, end in zip(first, (ends[:axes], ends[axes:])):
            beyond = {letters[end[axis] > borders[axes + axis]] for axis, letters in enumerate(("LR", "BT", "NF")[:axes])
                      if not borders[axis] <= end[axis] <= borders[axes + axis]}
            equal({letter for letter, digit in zip(said["code-bits"], code) if digit == "1"}, beyond, f"{topic} {bits}: {code} of {end}")
        equal(len(first), 2, f"{topic}: codes of both ends")


def test_faces_of_sheets_are_flat():
    """By the triple products of each face's corners; and a sheet's faces are as many as are told of."""
    write("names.txt", "Ada\nBea\nCem\nDan\n")
    for topic in ("back_face_culling", "bsp_tree"):
        made("worksheet", topic, "--students", "names.txt", "-o", "faces.tex", "--force", "-q", "--no-drawing")
        text = read("faces.tex").decode()
        sheets = re.findall(r"raggedright faces (.*?)(?: \$\\cdot\$|\\par)", text)
        check(len(sheets) >= 4, f"{topic}: {len(sheets)} inputs")
        for faces in sheets:
            faces = faces.replace("{-}", "-").split(";")
            for face in faces:
                corners = [[float(number) for number in corner.split(",")] for corner in face.split(":")[1].split()]
                a, b, c = corners[:3]
                u, v = [[p[i] - a[i] for i in range(3)] for p in (b, c)]
                normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
                for d in corners[3:]:
                    off = sum(n * (d[i] - a[i]) for i, n in enumerate(normal))
                    check(abs(off) <= 1e-9 * max(1, max(map(abs, normal))), f"{topic}: {face} is bent by {off}")
        if topic == "bsp_tree":
            counts = set(re.findall(r"([0-9]+) polygons", text))
            equal(counts, {"3"}, f"{topic}: as many polygons as faces")


def test_answers_are_those_of_the_run():
    write("names.txt", NAMES)
    fields = 0
    for topic in ("bresenham_line", "bresenham_circle", "liang_barsky", "cohen_sutherland_2d", "viewport", "affine_2d"):
        made("worksheet", topic, "-o", "quiz.xml", "--students", "names.txt", "-q")
        questions = questions_in("quiz.xml")
        equal(len(questions), 3, f"{topic}: a question per student")
        tables = []
        for question in questions:
            html = question.find("questiontext/text").text
            given = re.search(r"<code>(.*?)</code>", html)[1].replace("&lt;", "<")
            rows, expected = cells_of(html), table_of(topic, given)
            tables.append(rows)
            check(2 <= len(rows) <= len(expected), f"{topic}: {len(rows)} of {len(expected)} rows")
            for found, right in zip(rows, expected):
                for cell, answer in zip(found, right):
                    if isinstance(cell, str):
                        equal("" if cell == "–" else cell.replace("−", "-"), answer, f"{topic}: a given cell")
                        continue
                    fields += 1
                    mark, kind, alternatives = cell
                    check(mark >= 1, f"{topic}: a mark")
                    if kind == "NUMERICAL":
                        equal(alternatives, [f"{int(answer)}:0"], f"{topic}: a number")
                    else:
                        check(answer in [a.replace("−", "-") for a in alternatives] or
                              answer.replace("\u00a0", " ") in [a.replace("−", "-") for a in alternatives],
                              f"{topic}: {answer} in {alternatives}")
            picture = question.find("questiontext/file")
            equal((picture.get("encoding"), picture.get("path")), ("base64", "/"), "the figure")
            check(base64.b64decode(picture.text).startswith(b"\x89PNG"), "a PNG")
            check(f"@@PLUGINFILE@@/{picture.get('name')}" in html, "shown in the text")
        equal(len({len(rows) for rows in tables}), 1, f"{topic}: all have as many rows")
        check(len({str(rows) for rows in tables}) == 3, f"{topic}: each student has another one")
    check(fields > 200, f"{fields} fields")
    names = [question.find("name/text").text for question in questions_in("quiz.xml")]
    check(names[1].endswith("Zoë & Łukasz_{50%}") and names[2].endswith("<b>]]></b> \"q\""), f"{names}")


def test_names_for_latex():
    write("names.csv", '"Łukasz ""Ł"" & Söhne_{50%}",12345\n\\input{x}#1;x@example.org\n')
    made(*LINE, "-o", "s.tex", "--students", "names.csv", "-q")
    text = read("s.tex").decode()
    check("Łukasz \\textquotedbl{}Ł\\textquotedbl{} \\& Söhne\\_\\{50\\%\\}" in text, "specials are escaped")
    check("\\textbackslash{}input\\{x\\}\\#1" in text and "12345" not in text and "example.org" not in text, "the name alone")
    equal(subprocess.run(["pdfinfo", "s-figures.pdf"], capture_output=True, text=True).stdout.count("Pages:           2"), 1,
          "a drawing per student")


# --- Names in any script -----------------------------------------------------------------------------------------------


def name_inks(path, page):
    """The pieces of ink behind "Name:" on a page, from the left: the first and the last column of each that touches itself."""
    boxes = subprocess.run(["pdftotext", "-bbox", "-f", str(page), "-l", str(page), path, "-"], capture_output=True).stdout.decode()
    left, top, right, bottom = (float(number) for number in re.search(
        r'<word xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)">Name:', boxes).groups())
    scale = 4  # pixels per point
    shown = subprocess.run(["pdftoppm", "-r", str(72 * scale), "-gray", "-f", str(page), "-l", str(page), "-x", str(round(right * scale)),
                            "-y", str(round(top * scale)), "-W", str(300 * scale), "-H", str(round((bottom - top) * scale)), path],
                           capture_output=True).stdout
    _, size, _, pixels = shown.split(b"\n", 3)
    width, height = map(int, size.split())
    dark = {(k % width, k // width) for k, value in enumerate(pixels[:width * height]) if value < 160}
    inks = []
    while dark:
        todo = [dark.pop()]
        first = last = todo[0][0]
        while todo:
            x, y = todo.pop()
            first, last = min(first, x), max(last, x)
            near = {(x + i, y + j) for i in (-1, 0, 1) for j in (-1, 0, 1)} & dark
            dark -= near
            todo += near
        inks.append((first, last))
    return sorted(inks)


def test_names_in_any_script():
    fonts = "".join(f"<dir>/usr/share/fonts/{folder}</dir>" for folder in ("opentype/inter", "truetype/dejavu", "truetype/jetbrains-mono"))
    write("fonts.conf", f"<?xml version='1.0'?><fontconfig>{fonts}<cachedir>{os.getcwd()}/fonts</cachedir></fontconfig>")
    own = {"FONTCONFIG_FILE": f"{os.getcwd()}/fonts.conf"}
    write("names.csv", "Name;Nr\nمحمد;1\nدمم;2\n王小明;3\nAda;4\nمهدی\u200cزاده;5\n")
    result = made(*LINE, "-o", "s.pdf", "--students", "names.csv", env=own)
    equal(result.err.split("\n")[0], "names.csv:4: no installed font has U+738B of '王小明', so the name's line stays empty", "a remark")
    equal(result.err.count("\n"), 3, result.err)
    before = read("s.pdf"), read("s-key.pdf")
    for locale in ({}, {"LANG": "ja_JP.UTF-8", "LANGUAGE": "ja"}, {"LC_ALL": "ar"}):
        made(*LINE, "-o", "s.pdf", "--students", "names.csv", "-q", env=own | locale)
        check((read("s.pdf"), read("s-key.pdf")) == before, f"the same bytes under {locale}")
    sheets, keys = pages_text("s.pdf"), pages_text("s-key.pdf")
    equal((len(sheets), len(keys)), (5, 5), "a page per student")
    check("Name: Ada" in sheets[3] and "Name: Ada" in keys[3], sheets[3])
    for page, letters in ((0, "محمد"), (1, "دمم"), (4, "مهدیزاده")):
        for text in (sheets[page], keys[page]):
            found = "".join(c for c in unicodedata.normalize("NFKC", text) if "\u0600" <= c <= "\u06ff")
            check(sorted(found) in (sorted(letters), sorted(2 * letters)), f"{letters}: {found}")  # a sheet's foot has it again
    # Written by hand, the first name is one stroke; of the second the first letter, the narrow one, stands apart at the right
    equal(len(name_inks("s.pdf", 1)), 1, "letters are joined")
    apart = name_inks("s.pdf", 2)
    check(len(apart) == 2 and apart[0][1] - apart[0][0] > apart[1][1] - apart[1][0] and apart[0][1] < apart[1][1],
          f"from right to left: {apart}")
    # What is without a name has a line for it
    for path in ("s.pdf", "s-key.pdf"):
        rule = name_inks(path, 3)
        check(len(rule) == 1 and rule[0][1] - rule[0][0] > 800, f"{path}: a line to write on: {rule}")
    # All else is as if a font had the name
    write("names.csv", read("names.csv").decode().replace("王小明", "Eve"))
    made(*LINE, "-o", "e.pdf", "--students", "names.csv", "-q", env=own)
    for path, nameless in (("e.pdf", sheets), ("e-key.pdf", keys)):
        named = pages_text(path)[2]
        check("Name: Eve" in named and len(named) > 400, named)
        equal(named.replace("Eve", "").split(), nameless[2].split(), f"{path}: a whole page")
    long = "م" * 100
    write("long.txt", long + "\n")
    made(*LINE, "-o", "l.pdf", "--students", "long.txt", "-q", env=own)
    check(name_inks("l.pdf", 1)[-1][1] < 1200, "a long name stays on the page")
    write("names.txt", "王小明\n")
    made(*LINE, "-o", "s.tex", "--students", "names.txt", "-q", env=own)
    check("王小明" in read("s.tex").decode(), "LaTeX gets the name as it is")


# --- Refusals --------------------------------------------------------------------------------------------------------


def test_what_is_refused_in_one_line():
    write("empty.txt", "\n\n")
    write("names.txt", "Ada\n")
    write("turned.txt", "Ada \u202eecila\n")
    for words, said in (
            (["-o", "s.png"], "-o: expected a name that ends in .pdf, .tex, .xml (or --format), found 's.png'"),
            ([], "-o: expected a file like sheet.pdf, or - for standard output, found none"),
            (["-o", "s.xml", "--key", "k.xml"], "--key: expected pdf or tex, found xml, which has the answers in it"),
            (["-o", "s.pdf", "--key", "s.pdf"], "--key: expected another file than -o, found 's.pdf'"),
            (["-o", "s.pdf", "--points", "0.3"], "--points: expected whole or half points up to 1000, found '0.3'"),
            (["-o", "s.pdf", "--points", "1"], "--points: expected at least 2 for this sheet, found 1"),
            (["-o", "s.pdf", "--table-rows", "1"], "--table-rows: expected a whole number from 2 to 16, found '1'"),
            (["-o", "s.pdf", "--seed=-1"], "--seed: expected a whole number from 0 to 9223372036854775807, found '-1'"),
            (["-o", "s.pdf", "--students", "empty.txt"], "--students: expected a name per line, found none"),
            (["-o", "s.pdf", "--students", "none.txt"], "--students: "),
            (["-o", "s.pdf", "--students", "turned.txt"], "--students: expected names of up to 100 letters in UTF-8, found "),
            (["-o", "names.txt", "--format", "pdf", "--students", "names.txt"], "-o: "),
            (["liang_barsky", "--to", "5,2", "-o", "s.pdf"], "--to: expected one topic with inputs of its own, found 2"),
            (["worksheet", "illumination", "-o", "s.pdf"],
             "worksheet: expected an input of illumination like its own with numbers for the hand, found none in"),
            (["worksheet", "flood_fill", "--maze", "####/#..#/####", "-o", "s.pdf"],
             "worksheet: expected a topic and method with a table of at least two rows and numbers to vary, found flood_fill")):
        before = {name: len(read(name)) for name in files()}
        result = gradus(*(words if words[:1] == ["worksheet"] else [*LINE, *words]))
        check(result.code == 2 and result.out == "" and result.err.startswith("gradus: " + said) and result.err.count("\n") == 1,
              f"{words}\n    expected: {said}\n    found: {result.code} {result.err}")
        equal({name: len(read(name)) for name in files()}, before, f"{words}: nothing is made")


def test_too_few_inputs_are_said_and_shared():
    write("names.txt", "".join(f"Student {i}\n" for i in range(12)))
    result = made("worksheet", "flood_fill", "--maze", "####/#..#/#..#/####", "--at", "1,1", "-o", "s.xml", "--students", "names.txt")
    said = re.fullmatch(r"flood_fill: (\d+) different inputs found in \d+, so that some of 12 students share one\ns.xml\n",
                        result.err)
    check(said, result.err)
    tables = {question.find("questiontext/text").text.split("<table")[1] for question in questions_in("s.xml")}
    equal(len(tables), int(said[1]) if said else 0, "as many as were said")


sys.exit(command.run_all(globals()))
