#!/usr/bin/env python3
"""`gradus cases`, `gradus check` and `gradus figure --trace`: students' own programs, right, wrong and otherwise right.

    tests/golden/check_test.py [GRADUS]

The programs here and in examples/check/ are the oracle: what is wrong with each, and from which step on, is known.
"""
import json
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, PLAIN, check, equal, files, gradus, read, write

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples/check"


def cases(topic, *words):
    done = gradus("cases", topic, "--json", *words)
    equal(done.code, 0, f"cases {topic}: {done.err}")
    return json.loads(done.out)


def judged(topic, results, *words, code):
    """{case: verdict} of a file of answers, and the whole report."""
    write("results.json", json.dumps(results))
    done = gradus("check", topic, "results.json", "--json", *words)
    equal(done.code, code, f"check {topic}: {done.out} {done.err}")
    report = json.loads(done.out)
    return {answer["case"]: answer for answer in report["answers"]}


# --- Cases ---------------------------------------------------------------------------------------------------------

def test_cases():
    told = cases("bresenham_line")
    equal([case["case"] for case in told["cases"]],
          [f"{kind}-{i}" for kind in ("easy", "typical", "nasty", "ties") for i in (1, 2, 3, 4)], "four of each kind")
    equal(told["conventions"], {"y": "up", "ties": "any", "tolerance": 1e-6}, "what is taken for granted")
    equal(told["result"], {"pixels": "a list of [x, y]", "count": "a number"}, "what is asked for")
    equal(told["tie_rules"], ["any", "ours", "smaller", "larger", "straight", "diagonal", "even", "away_from_zero"], "rules")
    check({"x", "y", "p"} <= set(told["steps"]["Stepped"]), f"names of values: {told['steps']}")
    for case in told["cases"]:
        equal(set(case["arguments"]) - {"window"}, {"from", "to"}, f"{case}")
        check(case["command"].startswith("gradus run bresenham_line --from"), case["command"])
    equal(cases("bresenham_line"), told, "the same again")
    other = cases("bresenham_line", "--random-seed", "7", "--count", "2")
    equal((other["seed"], len(other["cases"])), (7, 8), "as many as asked for")
    check(other["cases"][0]["arguments"] != told["cases"][0]["arguments"], "others with another seed")
    table = gradus("cases", "bresenham_line", "--count", "1").out.splitlines()
    equal((table[0].split(), [line.split()[0] for line in table[1:] if line.strip()]),
          (["case", "command"], ["easy-1", "typical-1", "nasty-1", "ties-1"]), "a table")
    circle = gradus("cases", "bresenham_circle", "--count", "1")
    equal(circle.err, "ties: none of 1\n", "a topic without ties says so")


def test_refused_cases():
    for words, said in (
            (["--count", "0"], "--count: expected a whole number from 1 to 50, found '0'"),
            (["--count", "51"], "--count: expected a whole number from 1 to 50, found '51'"),
            (["--random-seed", "x"], f"--random-seed: expected a whole number from 0 to {2 ** 63 - 1}, found 'x'"),
            (["--from", "x"], "--from: expected")):
        done = gradus("cases", "bresenham_line", *words)
        check((done.code, done.out) == (2, "") and said in done.err, f"{words}: {done.code} {done.err}")


# --- Programs ------------------------------------------------------------------------------------------------------

def bresenham(start, end, mistake=""):
    """(pixels, steps) of the integer method, by one of these: p begins with 2 dy; p >= 0 decides; never aside."""
    (x, y), (x1, y1) = start, end
    steep = abs(y1 - y) > abs(x1 - x)
    if steep:
        x, y, x1, y1 = y, x, y1, x1
    dx, dy, sx, sy = abs(x1 - x), abs(y1 - y), (1 if x1 >= x else -1), (1 if y1 >= y else -1)
    p = 2 * dy if mistake == "start" else 2 * dy - dx
    pixels, steps = [], []
    for _ in range(dx + 1):
        pixels.append([y, x] if steep else [x, y])
        steps.append({"x": pixels[-1][0], "y": pixels[-1][1], "p": p})
        aside = p >= 0 and mistake != "never"
        x, y, p = x + sx, y + sy * aside, p + 2 * dy - 2 * dx * aside
    return pixels, steps


def answers_of_lines(told, mistake="", with_steps=True):
    found = []
    for case in told["cases"]:
        pixels, steps = bresenham(case["arguments"]["from"], case["arguments"]["to"], mistake)
        found.append({"case": case["case"], "result": {"pixels": pixels, "count": len(pixels)},
                      **({"steps": steps} if with_steps else {})})
    return {"topic": "bresenham_line", "seed": told["seed"], "answers": found}


def test_a_line_by_another_tie_rule():
    told = cases("bresenham_line", "--count", "3")
    verdicts = judged("bresenham_line", answers_of_lines(told), code=0)
    equal({answer["verdict"] for answer in verdicts.values()}, {"right", "other_tie"}, "p >= 0 goes aside")
    for name, answer in verdicts.items():
        if answer["verdict"] == "other_tie":
            check("diagonal" in answer["tie_rule"].split(" or "), f"{name}: {answer}")
    diagonal = {**answers_of_lines(told), "conventions": {"ties": "diagonal"}}
    judged("bresenham_line", diagonal, code=0)
    straight = {**answers_of_lines(told), "conventions": {"ties": "straight"}}
    wrong = [a for a in judged("bresenham_line", straight, code=1).values() if a["verdict"] == "wrong"]
    check(wrong and all(a["what"] == "a tie that does not go by the rule straight" for a in wrong), f"{wrong}")


def test_a_line_that_begins_wrongly():
    """Where its first pixel differs from all that are nearest, and that its later steps follow, is found by hand."""
    told = cases("bresenham_line")
    for name, answer in judged("bresenham_line", answers_of_lines(told, "start"), code=1).items():
        case = next(case for case in told["cases"] if case["case"] == name)
        (x0, y0), (x1, y1) = case["arguments"]["from"], case["arguments"]["to"]
        if (x0, y0) == (x1, y1):
            continue
        equal((answer["verdict"], answer["step"]), ("wrong", 0), f"{name}: the very first p")
        equal(answer["later_follow"], "yes" if max(abs(x1 - x0), abs(y1 - y0)) else "untold", f"{name}: {answer}")


def test_pixels_alone():
    """A line that never goes aside is wrong from the first diagonal step on."""
    told = cases("bresenham_line")
    verdicts = judged("bresenham_line", answers_of_lines(told, "never", with_steps=False), code=1)
    for case in told["cases"]:
        right, _ = bresenham(case["arguments"]["from"], case["arguments"]["to"])
        own, _ = bresenham(case["arguments"]["from"], case["arguments"]["to"], "never")
        answer = verdicts[case["case"]]
        if own == right:
            equal(answer["verdict"], "right", case["case"])
        elif answer["verdict"] == "wrong":
            first = next(i for i, (a, b) in enumerate(zip(own, right)) if a != b)
            check(answer["step"] >= first, f"{case['case']}: {answer}, first {first}")


def test_tables():
    """Pixels alone, a table of steps, and what may stand round them."""
    def told(text, *words):
        write("mine.csv", text)
        done = gradus("check", "bresenham_line", "mine.csv", *words)
        return done.code, done.out.splitlines()[0] if done.out else done.err.strip()
    line = "0,0\n1,0\n2,1\n3,1\n4,2\n5,2\n6,3\n7,3\n"
    equal(told(line), (0, "answer  right"), "a pixel per line")
    equal(told("# mine\nx;y\n" + line.replace(",", " ; ")), (0, "answer  right"), "with names, blanks, semicolons")
    equal(told(line.replace("4,2", "4,1")),
          (1, "answer  wrong from step 4 on: pixel 5 is (4, 1), ours (4, 2); all later pixels are right"), "one wrong")
    equal(told("0,0\n1,0\n2,0\n", "--to", "2,1"),
          (1, "answer  wrong from step 2 on: pixel 3 is (2, 0), ours (2, 1); whether later steps follow from there is not "
              "told for this answer; method misprinted_derivation answers the same (adds 2·dy − dx after E and 2·dy − 3·dx "
              "after NE: p falls behind by dx in every step)"), "flags say which")
    equal(told("0,0\n1,1\n2,1\n", "--to", "2,1"), (0, "answer  right by another tie rule (1 tie goes otherwise: larger or diagonal or "
                                                      "away_from_zero)"), "a tie")
    equal(told("k,x,y,p\n0,0,0,-1\n1,1,0,5\n2,2,1,-3\n3,3,1,3\n4,4,2,-5\n5,5,2,1\n6,6,3,-7\n7,7,3,-1\n"), (0, "answer  right"), "steps")
    equal(told("0,0\n1,0\n2\n"), (2, "gradus: mine.csv:3: expected 2 values: x,y, found 1"), "a value less")
    equal(told("0,0\n1,up\n"), (2, "gradus: mine.csv:2: expected two numbers x,y, found 'up'"), "no number")
    equal(told("0,0\n1,0.5\n"), (2, "gradus: mine.csv:2: pixels: expected two whole numbers, found a list"), "no pixel")
    equal(told(""), (2, "gradus: mine.csv:1: expected a line x,y for each pixel, found none"), "nothing")


def test_files_that_are_wrong():
    def refused(text, said, topic="bresenham_line"):
        write("results.json", text if isinstance(text, str) else json.dumps(text, indent=0))
        done = gradus("check", topic, "results.json")
        equal((done.code, done.out, done.err), (2, "", f"gradus: {said}\n"), f"{text}")
    answer = {"case": "easy-1", "result": {"pixels": []}}
    refused({"answers": []}, "results.json:1: expected answers, a list of at least one, found none")
    refused({"answers": 3}, "results.json:2: answers: expected a list, found 3")
    refused({"topic": "flood_fill", "answers": [answer]}, "results.json:1: topic: expected bresenham_line, found 'flood_fill'")
    refused({"answer": [answer]}, "results.json:2: expected one of topic, method, seed, conventions, answers, program, found 'answer', did you mean 'answers'?")
    refused({"answers": [{"case": "easy-1"}]}, "results.json:3: easy-1: expected a result or steps, found neither")
    refused({"answers": [answer, answer]}, "results.json:9: expected one answer per case, found another to easy-1")
    refused({"answers": [{**answer, "case": "easy-99"}]},
            "results.json:3: case: expected one that `gradus cases bresenham_line --random-seed 1` names, found 'easy-99'")
    refused({"answers": [{"arguments": {"form": [0, 0]}, "result": {"pixels": []}}]},
            "results.json:3: arguments: expected inputs of bresenham_line, found 'form'")
    refused({"answers": [{"arguments": {"from": "a"}, "result": {"pixels": []}}]},
            "results.json:3: answer 1: --from: expected two whole numbers from -2147483648 to 2147483647 like 3,4, found 'a'")
    refused({"answers": [{**answer, "result": {"pixel": []}}]}, "results.json:6: expected one of pixels, count, found 'pixel', did you mean 'pixels'?")
    refused({"answers": [{**answer, "result": {"count": "eight"}}]}, "results.json:6: count: expected a number, found 'eight'")
    refused({"answers": [{**answer, "steps": [{"q": 1}]}]},
            "results.json:10: expected one of from, to, dx, dy, p, pixel, x, y, p_before, straight, found 'q'")
    refused({"conventions": {"y": "left"}, "answers": [answer]}, "results.json:3: y: expected up or down, found 'left'")
    refused({"conventions": {"ties": "odd"}, "answers": [answer]},
            "results.json:3: ties: expected any or ours or smaller or larger or straight or diagonal or even or away_from_zero, found 'odd'")
    refused({"conventions": {"tolerance": 2}, "answers": [answer]}, "results.json:3: tolerance: expected a number from 0 to 1, found 2")
    refused({"conventions": {"vectors": "rows"}, "answers": [answer]},
            "--conventions.vectors: expected a topic with a matrix for vectors as rows, found 'bresenham_line'")
    refused("{", "results.json:1: expected a key in double quotes or '}', found the end of the file")
    done = gradus("check", "bresenham_line", "none.json")
    check(done.code == 2 and "none.json" in done.err, done.err)
    done = gradus("check", "bresenham_line")
    equal((done.code, done.err), (2, "gradus: check: expected a TOPIC and a FILE, found none (`gradus check --help` shows examples)\n"), "no file")


def test_figures():
    told = cases("bresenham_line", "--count", "1")
    verdicts = judged("bresenham_line", answers_of_lines(told, "never", with_steps=False), "-o", "wrong", code=1)
    wrong = sorted(f"{name}.svg" for name, answer in verdicts.items() if answer["verdict"] == "wrong")
    equal(files("wrong"), wrong, "a figure for each wrong answer")
    for name in wrong:
        text = read(f"wrong/{name}").decode()
        check("your answer" in text and "results.json" in text, f"{name} says what it shows: {text[:2000]}")
    write("mine.csv", "0,0\n1,0\n2,1\n3,1\n4,1\n5,2\n6,3\n7,3\n")
    done = gradus("figure", "bresenham_line", "--trace", "mine.csv", "-o", "beside.svg", "--svg-text", "text")
    equal((done.code, done.err), (0, "beside.svg\n"), "beside ours")
    svg = read("beside.svg").decode()
    check(all(words in svg for words in ("first difference", "your answer", "wrong from step 4 on", "step 4 / 7")), "step 4")
    check("--trace mine.csv" in svg, "its command")
    done = gradus("again", "beside.svg")
    check(done.code == 2 and "--trace mine.csv" in done.err, f"the file is the reader's: {done.err}")
    for name in ("beside.html", "beside.pdf", "beside.png"):
        done = gradus("figure", "bresenham_line", "--trace", "mine.csv", "-o", name)
        equal((done.code, done.err), (0, f"{name}\n"), name)
    german = gradus("figure", "bresenham_line", "--trace", "mine.csv", "-o", "-", "--svg-text", "text", "--language", "de")
    check("eigene Antwort" in german.out and "falsch ab Schritt 4" in german.out, "in German")
    case = f"results.json#{wrong[0][:-4]}"
    equal(gradus("figure", "bresenham_line", "--trace", case, "-o", "case.svg").code, 0, "one of several answers")
    for words, said in ((["--trace", "results.json"], "--trace: expected results.json#CASE, one of easy-1, typical-1, nasty-1, ties-1, found none"),
                        (["--trace", "mine.csv", "--compare", "dda"], "--compare: expected either this or --trace, found both"),
                        (["--trace", "mine.csv", "--panels", "phases"], "--panels: expected either this or --trace, found both")):
        done = gradus("figure", "bresenham_line", *words, "-o", "x.svg")
        equal((done.code, done.err), (2, f"gradus: {said}\n"), f"{words}")
    values = gradus("run", "liang_barsky", "--json").out.replace('"x0":1.0', '"x0":1.5')
    write("lb.json", re.sub(r'"result": .*', '"result": {"accepted":false}', values))
    done = gradus("figure", "liang_barsky", "--trace", "lb.json", "-o", "-", "--svg-text", "text")
    check("x0 = 1.5 ≠ 1" in done.out and "accepted = false ≠ true" in done.out, "values of a topic without pixels")


# --- Examples ------------------------------------------------------------------------------------------------------

def summary(topic, text, code):
    write("results.json", text)
    done = gradus("check", topic, "results.json")
    equal(done.code, code, f"{topic}: {done.out} {done.err}")
    return done.out


def test_example_in_python():
    told = gradus("cases", "bresenham_line", "--json", "--count", "6").out
    write("cases.json", told)
    done = subprocess.run([sys.executable, EXAMPLES / "line.py", "cases.json"], capture_output=True, text=True, env=PLAIN)
    equal((done.returncode, done.stderr), (0, ""), "line.py")
    report = summary("bresenham_line", done.stdout, 0)
    check("right by another tie rule" in report and "even" in report, report)


def test_example_in_c():
    told = gradus("cases", "bresenham_circle", "--json", "-q").bytes
    for mistake, code in (([], 0), (["-DMISTAKE"], 1)):
        built = subprocess.run(["c++", "-x", "c", "-std=c99", "-Wall", "-Wextra", "-Werror", *mistake, str(EXAMPLES / "circle.c"), "-o", "circle"],
                               capture_output=True, text=True)
        equal((built.returncode, built.stderr), (0, ""), "circle.c")
        done = subprocess.run(["./circle"], input=told, capture_output=True)
        equal(done.returncode, 0, "circle")
        report = summary("bresenham_circle", done.stdout.decode(), code)
        check(("wrong from step" in report) == (code == 1), report)


def test_notebook():
    """Its code cells, one after the other, as a notebook runs them, without one."""
    book = json.loads((EXAMPLES / "liang_barsky.ipynb").read_text(encoding="utf-8"))
    code = "\n".join("".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == "code")
    check(all(not cell.get("outputs") for cell in book["cells"]), "no outputs are kept")
    bin = pathlib.Path("bin")
    bin.mkdir()
    (bin / "gradus").symlink_to(GRADUS)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                          env={**PLAIN, "PATH": f"{bin.resolve()}:{PLAIN['PATH']}"})
    equal((done.returncode, done.stderr.replace("\n", " ")[:300]), (0, ""), "the notebook")
    right, wrong = (re.search(pattern, done.stdout) for pattern in (r"\d+ answers: \d+ right \(", r"wrong from step \d+ on: .*all later steps follow"))
    check(right and wrong, done.stdout)
    check(re.search(r"^wrong/[\w-]+\.svg$", done.stdout, re.M) or "SVG" in done.stdout, "a figure")


sys.exit(command.run_all(globals()))
