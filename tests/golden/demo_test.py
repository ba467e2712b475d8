#!/usr/bin/env python3
"""`gradus demo` and `gradus inspect`: the films from a car on a circular road, and the data they are made of.

    tests/golden/demo_test.py [GRADUS]          compares with the pictures of docs/demos.md, too
    tests/golden/demo_test.py GRADUS --write    makes those pictures anew: look at each before committing
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
import figure_files
from command import check, equal, files
from renders import ROOT, SHARE, Picture, differing, gradus, png, read, write

DEMOS, PAGE = ROOT / "examples/demos", ROOT / "docs/demos"
DATA = json.loads((DEMOS / "pyramid_demo.json").read_text())
ALL = [f"{i:03}.png" for i in range(125)]


def data(**changes):
    """A file like the program's own, with other values or without some (None)."""
    write("data.json", json.dumps({k: v for k, v in {**DATA, **changes}.items() if v is not None}))
    return ["--data", "data.json"]


def short(**changes):
    return data(k_duration=1, k_fps=3, **changes)


def stone(p):
    """A colour of the pyramid: not that of the sky, the grass or the road."""
    r, g, b = p[:3]
    return (r > g + 12 and r > b + 30) or (g > 145 and b < 120)


def centre_of_pyramid(shown):
    left, top, right, bottom = shown.where(stone)
    return (left + right + 1) / 2, (top + bottom + 1) / 2


def test_a_film():
    """125 frames at 25 a second, in which the pyramid drifts, as the page shows it."""
    done = gradus("demo", "forward", "-o", "forward.mp4", "--frames", "forward")
    equal((done.code, done.err), (0, "forward: 125 frames\nforward.mp4\n"), "what was made")
    equal(files("forward"), ALL, "frames by number")
    told = figure_files.probed("forward.mp4")
    video = told["streams"][0]
    equal((video["nb_read_frames"], video["width"], video["height"], float(told["format"]["duration"])),
          ("125", 512, 512, 5.0), "five seconds")
    times = [float(frame["pts_time"]) for frame in told["frames"]]
    check(all(abs(time - i / 25) < 1e-6 for i, time in enumerate(times)), f"frame i at i / 25: {times[:3]} {times[-1]}")
    for name in ALL:
        equal(shape_of(read(f"forward/{name}")), (512, 512, 2), f"{name}: three channels")
    shown = {name: Picture(read(f"forward/{name}")) for name in (ALL[0], ALL[20], ALL[-1])}
    for name in (ALL[0], ALL[-1]):
        same_as_page(f"forward_{name}", shown[name], f"forward/{name}")
    (x, y), (then, _), (last, _) = (centre_of_pyramid(frame) for frame in shown.values())
    print(f"the pyramid is at {x}, then {then}, at last {last}")
    check(abs(x - 256) < 12 and abs(y - 256) < 12, f"in the middle of the first frame: {x}, {y}")
    check(x + 10 < then < last - 60, "it drifts")


def test_first_and_last_frame_of_the_target():
    """A car that is 4.96 times as fast is after a second where the film's is in its last frame."""
    fast = data(k_duration=2, k_fps=1, car_velocity=4.96 * DATA["car_velocity"])
    names = {ALL[0]: ALL[0], ALL[-1]: ALL[1]}
    if "--write" in sys.argv:
        fast, names = [], {name: name for name in (ALL[0], ALL[-1])}
    gradus("demo", "target", *fast, "--frames", "target")
    xs = []
    for name, here in names.items():
        shown = Picture(read(f"target/{here}"))
        same_as_page(f"target_{name}", shown, f"target/{here}")
        xs.append(centre_of_pyramid(shown)[0])
    check(abs(xs[1] - xs[0]) < 12, f"it stays: {xs}")
    first = Picture(read("target/000.png"))
    check(differing(first, Picture(read(PAGE / "forward_000.png"))) <= SHARE, "both begin alike")


def shape_of(png):
    """Width, height and colour type, which is 2 for RGB."""
    return int.from_bytes(png[16:20], "big"), int.from_bytes(png[20:24], "big"), png[25]


def same_as_page(name, shown, made):
    page = PAGE / name
    if "--write" in sys.argv:
        PAGE.mkdir(exist_ok=True)
        page.write_bytes(read(made))
    check(differing(shown, Picture(read(page))) <= SHARE, f"docs/demos/{name} is what its command makes")


def test_the_strip():
    equal(gradus("demo", "both", "-o", "both.png").err, "both.png\n", "a picture")
    strip = Picture(read("both.png"))
    equal((strip.width, strip.height), (5 * 256 + 4 * 8, 2 * 256 + 8), "five frames of both")
    same_as_page("both.png", strip, "both.png")
    equal(strip.texts["gradus-command"], "gradus demo both", "how it is made")
    for k in range(5):
        for row, moves in ((0, True), (264, False)):
            part = [line[264 * k:264 * k + 256] for line in strip.pixels[row:row + 256]]
            columns = [x for line in part for x, p in enumerate(line) if stone(p)]
            middle = (min(columns) + max(columns)) / 2
            check(abs(middle - 128) < 8 if not moves or k == 0 else middle > 128 + 12 * k, f"frame {k} of {row}: {middle}")


def test_same_bytes():
    equal(gradus("demo", "forward", *short(), "-o", "a.mp4", "-j1").code, 0, "one at a time")
    gradus("demo", "FORWARD", *short(), "-o", "b.mp4", "--frames", "b", "--jobs", "3")
    equal(read("a.mp4"), read("b.mp4"), "several at once, and with frames")
    equal(gradus("dem", "forw", *short(), "-o", "-", "-q").bytes, read("a.mp4"), "on standard output")
    equal(files("b"), ["000.png", "001.png", "002.png"], "frames")
    shown = Picture(read("b/001.png"))
    equal(shown.texts["gradus-command"], "gradus demo forward --data data.json", "how it is made")
    equal(gradus("demo", "both", *short(), "--frames", "c").err, "c: 3 frames\n", "frames alone")
    both = Picture(read("c/001.png"))
    equal((both.width, both.height), (2 * 512 + 8, 512), "side by side")
    equal([line[:512] for line in both.pixels], shown.pixels, "the left one is forward")
    equal(gradus("demo", "target", *short(k_sensor_width=48), "--frames", "d", "-q").err, "", "quiet")
    equal(Picture(read("d/000.png")).width, 1024, "a sensor twice as wide")
    fast = gradus("demo", "target", *data(k_duration=1, k_fps=60), "-o", "fast.mp4")
    equal(figure_files.probed("fast.mp4")["streams"][0]["nb_read_frames"], "60", f"60 a second {fast.err}")


def test_texture():
    write("red.png", png({}))
    gradus("demo", "target", *short(), "--texture", "red.png", "--frames", "a")
    middle = Picture(read("a/000.png")).pixels[256][256]
    equal(middle, (255, 255, 255), "one white texel")
    result = gradus("demo", "target", *short(), "--texture", "data.json", "--frames", "b")
    equal((result.code, result.err.count("\n")), (2, 1), f"no picture: {result.err}")


def test_refusals():
    write("own.png", "mine")
    pathlib.Path("mine").mkdir()
    write("mine/001.png", "mine")
    column = [[0], [0], [1]]
    cases = [
        ([], "demo: expected a DEMO: forward, target or both, found none (`gradus demo --help` shows examples)"),
        (["backward", "-o", "a.mp4"], "DEMO: expected one of forward, target, both, found 'backward'"),
        (["forward"], "-o: expected a film like forward.mp4, or --frames with a folder, found neither"),
        (["forward", "-o", "a.avi"],
         "-o: expected a name that ends in .mp4, the film, or .png, a strip of five frames, found 'a.avi'"),
        (["forward", "-o", "own.png"], "-o: expected a new file or one that gradus made, found 'own.png' (--force replaces it)"),
        (["forward", "-o", "none/a.mp4"], "-o: expected a folder that exists, found 'none'"),
        (["forward", "--frames", "own.png"], "--frames: expected a folder, found 'own.png'"),
        (["forward", "--frames", "mine"],
         "--frames: expected a new file or one that gradus made, found 'mine/001.png' (--force replaces it)"),
        (["forward", "-o", "a.mp4", "-j", "0"], "--jobs: expected a whole number from 1 to 1024, found '0'"),
        (["forward", "-o", "a.mp4", "--data", "none"],
         "--data: expected a readable file, found 'none' (No such file or directory)"),
        (["forward", "-o", "a.mp4", "--data", "own.png"], None),
        (["target", "-o", "a.mp4", *data(k_cam_target=[[49.5], [1.5], [9]])],
         "data.json: k_cam_target: expected a place beside the camera's and not straight above or below it, found "
         "(49.5, 1.5, 9), which it is in frame 0"),
    ]
    for words, message in cases:
        result = gradus("demo", *words)
        equal((result.code, result.err.count("\n")), (2, 1), f"{words}: {result.err}")
        if message:
            equal(result.err, f"gradus: {message}\n", f"{words}")
    equal(files(), ["data.json", "mine/001.png", "own.png"], "nothing was written")
    equal((read("mine/001.png"), read("own.png")), (b"mine", b"mine"), "nor touched")
    equal(gradus("demo", "forward", *short(), "--frames", "mine", "--force", "-q").code, 0, "--force")
    result = gradus("demo", "forward", *data(k_cam_up=column, k_fps=0), "-o", "a.mp4")
    equal(result.err, "gradus: data.json:1: k_fps: expected a whole number from 1 to 60, found 0\n", "a file's mistake")


def test_again_refuses():
    gradus("demo", "forward", *short(), "--frames", "f")
    result = gradus("again", "f/000.png")
    equal((result.code, result.err.count("\n")), (2, 1), result.err)


def test_inspect():
    shown = gradus("inspect", "pyramid_demo.json")
    lines = shown.out.splitlines()
    equal(lines[0], "pyramid_demo.json: 14 keys; 16 vertices, 6 triangles; 125 frames in 5 s", "the whole")
    equal([line.split()[0] for line in lines[3:]], list(DATA), "the keys of the file, in its order")
    equal(lines[13].split("  ")[0:1] + lines[13].split()[1:5], ["v_pos", "float", "3", "x", "16"], "type and shape")
    told = json.loads(gradus("inspect", "pyramid_demo.json", "--json").out)
    equal((told["file"], told["vertices"], told["triangles"], told["frames"]), ("pyramid_demo.json", 16, 6, 125), "as JSON")
    for entry in told["keys"]:
        value, shape = DATA[entry["key"]], []
        while isinstance(value, list):
            shape.append(len(value))
            value = value[0]
        equal((entry["shape"], entry["type"]), (shape, type(value).__name__), f"what Python reads: {entry['key']}")
    piped = gradus("inspect", "-", stdin=read(DEMOS / "pyramid_demo.json"))
    equal(piped.out.splitlines()[1:], lines[1:], "from standard input")


def test_inspect_refuses():
    cases = [
        (dict(k_f=None), "data.json: expected a key k_f, found none"),
        (dict(k_cam_target=[1, 2, 3]), "data.json:1: k_cam_target: expected 3 rows of one number, found 1"),
        (dict(k_road_center=[[1], [2], [3]]), "data.json:1: k_road_center: expected 3 numbers, found a list of 1"),
        (dict(v_uvs=DATA["v_uvs"][:3]), "data.json:1: v_uvs: expected 16 rows, one per vertex, found 3"),
        (dict(t_pos_idx=[[0, 1, 2.5]]), "data.json:1: t_pos_idx: expected whole numbers of vertices from 0 to 15, found 0"),
        (dict(k_sensor_width=1000), "data.json:1: k_sensor_width: expected 1/8 to 8 times the height, found 41.666666666666664 times"),
        (dict(car_velocity="fast"), "data.json:1: car_velocity: expected a number, found 'fast'"),
    ]
    for changes, message in cases:
        data(**changes)
        result = gradus("inspect", "data.json")
        equal((result.code, result.out, result.err), (2, "", f"gradus: {message}\n"), f"{changes}")
    for text in ("", "{", "[]", '{"k_f": 1, "k_f": 2}', "\x80\x05pickled"):
        write("bad.json", text)
        result = gradus("inspect", "bad.json")
        equal((result.code, result.out, result.err.count("\n")), (2, "", 1), f"{text!r}: {result.err}")
    equal(gradus("inspect", "town.json").code, 2, "a scene is none")
    equal(gradus("inspect", "none.json").err,
          "gradus: FILE: expected a readable file, found 'none.json' (No such file or directory)\n", "no file")


sys.exit(command.run_all(globals()))
