#!/usr/bin/env python3
"""`gradus render` from end to end: its names and files, what it refuses, and `gradus again` on its pictures.

    tests/golden/render_command_test.py [GRADUS]
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import GRADUS, check, equal
from renders import LETTER, MODELS, Picture, ROOT, SHARE, SPOT, differing, fewer_frames, gradus, picture, png, read, write


# --- The command ------------------------------------------------------------------------------------------------


def test_examples_run():
    examples = re.findall(r"^  (gradus render .*)$", gradus("render", "--help").bytes.decode(), re.M)
    examples += re.findall(r"^(gradus render .*)$", (ROOT / "docs/rendering.md").read_text(), re.M)
    check(len(examples) >= 7, f"examples to paste: {examples}")
    for line in dict.fromkeys(map(fewer_frames, (re.sub("  +#.*", "", line) for line in examples))):
        result = subprocess.run(line.replace("gradus", f"'{GRADUS}'", 1), shell=True, capture_output=True)
        if "--array" in line or "{frame}" in line or ".mp4" in line:
            equal(result.returncode, 0, f"{line}: {result.stderr}")
            continue
        if "--why" in line and "-o" not in line:
            check(result.returncode == 0 and result.stdout.startswith(b"Pixel "), f"{line}: {result.stderr}")
            continue
        target = line.split("> ")[-1] if ">" in line else re.search(r"-o (\S+)", line)[1]
        equal(result.returncode, 0, f"{line}: {result.stderr}")
        if not target.endswith(".png"):
            check(read(target).startswith((b"<?xml", b"<!DOCTYPE html>")), f"{line} makes what its name says")
            continue
        check(Picture(read(target)).where(lambda p: p != (255, 255, 255)), f"{line} shows something")
    for name in ("f.png", "pasture.png", "koala.png", "why.png"):
        check(differing(Picture(read(name)), Picture(read(ROOT / "docs/rendering" / name))) <= SHARE,
              f"docs/rendering/{name} is what its command makes")
    overview = gradus("--help").bytes.decode()
    check("gradus render letter_f.obj" in overview and re.search(r"^  render +\S", overview, re.M), overview)
    check("gradus render" in gradus("list").bytes.decode(), "gradus list tells where models are")


def test_same_bytes():
    words = ["--size", "80x60", "--eye", "-2,1,-3", "--light", "1,2,-3"]
    shutil.copytree(MODELS, "folder")
    equal(gradus("render", LETTER, "-o", "a.png", *words).err, "a.png\n", "the name of what was made")
    gradus("render", "folder/letter_f.obj", "-o", "b.png", *words)
    equal(read("b.png"), read("a.png"), "the same bytes, wherever the model lies")
    equal(gradus("render", LETTER, "-o", "-", *words).bytes, read("a.png"), "and on standard output")
    spelled = ["--SIZE=080x60", "--ey", "(-2, 1.0, -3)", "--lig=+1,2,-3", "--fov", "40.0"]
    equal(gradus("ren", LETTER, *spelled, "-o-").bytes, read("a.png"), "however it is spelled")
    os.chdir("folder")
    piped = gradus("render", "-", "-o", "-", *words, stdin=read("letter_f.obj"))
    check(differing(Picture(piped.bytes), Picture(read("../a.png"))) == 0, "a model from standard input, materials from here")


def test_metadata():
    shown = picture(LETTER, "--size", "80x60", "--fov", "40", "--background", "None", "--target", "0.50,1/2,0", "--samples", "016")
    equal(shown.texts["gradus-command"], "gradus render letter_f.obj --size 80x60 --target 0.5,1/2,0 --background none", "command")
    other = picture(LETTER, "--size", "80x60", "--samples", "4", "--aa", "Jittered").texts["gradus-command"]
    equal(other, "gradus render letter_f.obj --size 80x60 --aa jittered --samples 4", "how it is antialiased")
    equal(shown.texts["Title"], "letter_f.obj, rendered", "title")
    check(re.fullmatch(r"letter_f.obj: 12 faces, 36 triangles, seen from \S+, 80 x 60 pixels\.", shown.texts["Description"]),
          shown.texts["Description"])
    check(re.fullmatch(r"fnv1a:\w{16} fnv1a:\w{16}", shown.texts["gradus-input-hash"]), "hashes of model and materials")
    check(shown.texts["Software"].startswith("gradus ") and shown.texts["Copyright"] == "CC0-1.0", "as in figures")


def test_bad_commands():
    size = "--size: expected a width and a height like 800x600, of 1 to 8192 pixels, found "
    three = "expected three numbers like 3,2,4, none larger than 1e30, found "
    fov = "--fov: expected the vertical angle of view, 0.001 to 179.999 degrees, found "
    out = ["-o", "x.png"]
    cases = [
        ([], "render: expected a MODEL.obj or a SCENE.json, found none (`gradus render --help` shows examples)"),
        ([SPOT], "-o: expected a file like model.png, or - for standard output, found none"),
        ([SPOT, LETTER, *out], re.compile("render: expected only a MODEL.obj or a SCENE.json, found '.*letter_f.obj'")),
        ([SPOT, "-o", "x.svg"], "-o: expected a name that ends in .png or .html, found 'x.svg'"),
        ([SPOT, "-o", "x"], "-o: expected a name that ends in .png or .html, found 'x'"),
        ([SPOT, "-o", "none/x.png"], "-o: expected a folder that exists, found 'none'"),
        ([SPOT, "-o", "."], "-o: expected a file's name, found '.'"),
        (["none.obj", *out], "MODEL: expected a readable file, found 'none.obj' (No such file or directory)"),
        ([".", *out], "MODEL: expected a regular file, found the folder '.'"),
        (["/dev/zero", *out], "MODEL: expected a regular file, found the device '/dev/zero'"),
        (["/dev/tty", *out], "MODEL: expected a regular file, found the device '/dev/tty'"),
        *[([SPOT, *out, "--size", text], size + f"'{text}'")
          for text in ("0x5", "5x0", "800", "800x", "x600", "8193x1", "1x8193", "-5x5", "8.5x5", "axb", "5x5x5", "4:3",
                       "99999999999999999999x1")],
        ([SPOT, *out, "--size", "8192x8192"], "--size: expected at most 33554432 pixels in all, found '8192x8192' with 67108864"),
        *[([SPOT, *out, "--" + flag, text], f"--{flag}: {three}'{text}'")
          for flag in ("eye", "target", "up", "light")
          for text in ("1,2", "1,2,3,4", "1,2,x", "nan,0,0", "0,inf,0", "1e31,0,0", "1 2 3", "(1,2,3", ",,", "1,,2", "0x1,2,3")],
        ([SPOT, *out, "--up", "0,-0,0"], "--up: expected a direction like 0,1,0, found 0,0,0"),
        ([SPOT, *out, "--eye", "1,2,3", "--target", "1,2,3"], "--target: expected another point than the eye 1,2,3, found 1,2,3"),
        ([SPOT, *out, "--eye", "1e20,0,0", "--target", "1e20,0,0.0"], "--target: expected another point than the eye 1e+20,0,0, found 1e+20,0,0"),
        ([SPOT, *out, "--eye", "0,0,5", "--target", "0,0,0", "--up", "0,0,-2"],
         "--up: expected a direction that is not along the view from 0,0,5 to 0,0,0, found 0,0,-2"),
        *[([SPOT, *out, "--fov", text], fov + f"'{text}'") for text in ("0", "180", "-40", "nan", "inf", "1e-9", "forty", "40,5")],
        ([SPOT, *out, "--background", "blurple"], re.compile("--background: expected .*#rrggbb.*, found 'blurple'.*")),
        ([SPOT, *out, "--background", "#12345"], re.compile("--background: expected .*#rrggbb.*, found '#12345'.*")),
        ([SPOT, *out, "--shading", "toon"], "--shading: expected one of flat, gouraud, phong, wireframe, found 'toon'"),
        ([SPOT, *out, "--aa", "msaa"],
         "--aa: expected one of none, supersampling, accumulation_buffer, jittered, poisson_disc, area_sampling, a_buffer, adaptive, adaptive+contrast, found 'msaa'"),
        *[([SPOT, *out, "--samples", text], f"--samples: expected 1 to 256 samples per pixel, found '{text}'") for text in ("0", "257", "-4", "4.5", "many")],
        ([SPOT, *out, "--samples", "8", "--aa", "supersampling"],
         "--samples: expected a square like 4, 9 or 16, for they stand in cells, found '8'"),
        *[([SPOT, *out, "--samples", "16", "--aa", method], f"--samples: expected no number beside --aa {method}, which has its own, found '16'")
          for method in ("none", "area_sampling", "a_buffer")],
        ([SPOT, *out, "--step", "3"], re.compile("render: unknown flag '--step': expected one of --output, --size, .*")),
        ([SPOT, *out, "--eye"], "--eye: expected X,Y,Z, found none"),
        ([SPOT, *out, "--eye", "1,2,3", "--eye", "1,2,3"], "--eye: expected one value, found '1,2,3' and '1,2,3'"),
    ]
    for words, message in cases:
        result = gradus("render", *words)
        equal((result.code, result.bytes), (2, b""), f"render {words}")
        text = result.err.removeprefix("gradus: ").removesuffix("\n")
        check(message.fullmatch(text) if isinstance(message, re.Pattern) else text == message, f"{words}\n    {message}\n    {text}")
        equal(os.listdir("."), [], f"render {words} leaves nothing")
    print(f"bad commands: {len(cases)}")
    shutil.copy(SPOT, "model.png")
    result = gradus("render", "model.png", "-o", "model.png")
    equal((result.code, result.err), (2, "gradus: -o: expected another file than the input, found 'model.png'\n"), "over the model")
    equal(read("model.png"), read(SPOT), "the model is whole")
    shutil.copy(LETTER, "letter_f.obj"), shutil.copy(MODELS / "letter_f.mtl", "letter_f.png")
    write("letter_f.obj", read("letter_f.obj").replace(b"letter_f.mtl", b"letter_f.png"))
    result = gradus("render", "letter_f.obj", "-o", "letter_f.png")
    equal((result.code, result.err), (2, "gradus: -o: expected another file than the input, found 'letter_f.png'\n"), "over the materials")
    if os.path.exists("/dev/full"):
        with open("/dev/full", "wb") as full:
            result = gradus("render", SPOT, "-o", "-", stdout=full)
        check(result.code == 1 and "No space left" in result.err, f"a full disk: {result.err}")


def test_broken_models():
    good = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
    cases = {  # text -> where the mistake is
        good + "f 1 2 4\n": "m.obj:4: ", good + "f 1 2\n": "m.obj:4: ", "v 0 nan 0\n": "m.obj:1: ", good: "m.obj: ", "": "m.obj: ",
        good + "\nf 1 2 0\n": "m.obj:5: ", good + "bogus\n": "m.obj: ", good + "cstype bezier\n": "m.obj:4: ", "v 0 0\n": "m.obj:1: ",
        good + "f 1 2 -4\n": "m.obj:4: ", "\x00\x01": "m.obj",
    }
    for text, place in cases.items():
        write("m.obj", text)
        result = gradus("render", "m.obj", "-o", "m.png")
        check(result.code == 2 and result.err.startswith(f"gradus: {place}") and result.err.count("\n") == 1, f"{text!r}: {result.err}")
        equal(os.listdir("."), ["m.obj"], f"{text!r} leaves nothing")
        result = gradus("render", "-", "-o", "-", stdin=text.encode())
        check(result.code == 2 and result.bytes == b"" and result.err.startswith("gradus: standard input"), result.err)
    write("m.obj", "mtllib m.mtl\nusemtl red\n" + good + "f 1 2 3\n")
    write("m.mtl", "newmtl red\nKd 1 0 x\n")
    result = gradus("render", "m.obj", "-o", "m.png")
    check(result.code == 2 and "m.mtl:2: " in result.err, f"a broken library: {result.err}")
    os.remove("m.mtl")
    result = gradus("render", "m.obj", "-o", "m.png")
    check(result.code == 0 and "m.obj:1: " in result.err and result.err.endswith("\nm.png\n"), f"a missing library is a remark: {result.err}")
    os.mkdir("m.mtl")
    equal(gradus("render", "m.obj", "-o", "m2.png").err.splitlines(),
          ["m.obj:1: no file 'm.mtl': its materials are the default",
           "m.obj:2: no material 'red' was read: it is drawn like the default", "m2.png"], "a folder as a library")
    os.rmdir("m.mtl")


def test_textures():
    """A picture that a material names: PNG beside the model, looked up by --filter, refused with its line."""
    write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl red\nf 1/1 2/2 3/3\n")
    write("m.mtl", "newmtl red\nKd 1 0 0\nmap_Kd wood.png\n")
    def refused(what, *words):
        result = gradus("render", "m.obj", "-o", "m.png", *words)
        equal((result.code, result.err, os.path.exists("m.png")), (2, f"gradus: m.mtl:3: map_Kd 'wood.png': {what}\n", False), what)
    refused("expected a PNG or JPEG file of that name beside the model, found none")
    write("wood.png", "no picture")
    refused("expected a PNG or JPEG file, found something else")
    whole = read(MODELS / "spot_texture.png")
    write("wood.png", whole[:5000])
    refused("expected a whole PNG file, found a damaged one (the file ends too early)")
    os.remove("wood.png")
    os.mkfifo("wood.png")
    refused("expected a regular file, found the pipe 'wood.png'")
    equal(gradus("render", "m.obj", "-o", "m.png", "--filter", "none").code, 0, "without textures nothing is read")
    os.remove("wood.png")
    os.remove("m.png")
    write("wood.png", whole)
    pictures = set()
    for filter in ("nearest", "bilinear", "mipmapped", "none"):
        result = gradus("render", "m.obj", "-o", "m.png", "--filter", filter, "--size", "80x60")
        equal((result.code, result.err), (0, "m.png\n"), filter)
        pictures.add(read("m.png"))
        words = "" if filter == "mipmapped" else f" --filter {filter}"
        equal(Picture(read("m.png")).texts["gradus-command"], f"gradus render m.obj --size 80x60{words}", "command")
    equal(len(pictures), 4, "each filter has its own picture")
    gradus("render", "m.obj", "-o", "m.png", "--size", "80x60")
    write("wood.png", read(MODELS / "spot_texture.png") + b"x")
    check("found fnv1a:" in gradus("again", "m.png", "-o", "n.png").err, "a texture that has changed is told")


def test_textures_as_their_material_lays_them_on():
    """-s and -o of map_Kd, in letters of any size: as texture coordinates that were scaled and moved by hand."""
    write("wood.png", read(MODELS / "spot_texture.png"))
    def drawn(statement, corners, remark=""):
        write("m.mtl", f"newmtl m\nKd 1 1 1\n{statement}\n")
        write("m.obj", "mtllib m.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" + "".join(f"vt {uv}\n" for uv in corners) + "f 1/1 2/2 3/3\n")
        result = gradus("render", "m.obj", "-o", "m.png", "--size", "80x60")
        equal((result.code, result.err), (0, remark + "m.png\n"), statement)
        return Picture(read("m.png")).pixels
    plain = drawn("map_Kd wood.png", ("0 0", "1 0", "0 1"))
    moved = drawn("map_Kd wood.png", ("0.25 -0.5", "2.25 -0.5", "0.25 2.5"))
    check(plain != moved, "the two can be told apart")
    check(drawn("map_kd -s 2 3 1 -o 0.25 -0.5 0 wood.png", ("0 0", "1 0", "0 1")) == moved, "-s and -o")
    check(drawn("MAP_KD -clamp on wood.png", ("0 0", "1 0", "0 1"), "m.mtl:3: -clamp of map_Kd is not drawn\n") == plain, "-clamp is told")


def test_forgiven_forms():
    """Forms of public models whose meaning is plain: remarks on stderr, and the picture of the tidy file."""
    good = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
    def shown(text):
        write("m.obj", text)
        result = gradus("render", "m.obj", "-o", "m.png", "--size", "40x30")
        equal(result.code, 0, f"{text!r}: {result.err}")
        return Picture(read("m.png")).pixels, result.err.splitlines()[:-1]
    tidy, nothing = shown(good + "f 1 2 3\n")
    equal(nothing, [], "no remark")
    for text, remarks in {
            "f 1// 2// 3//\n": [], "f 1/ 2/ 3/\n": [],
            "f 1/1/1 2/2/1 3/3/1\n": ["m.obj:4: there are no texture coordinates (vt) in the file: their indices are left out",
                                     "m.obj:4: there are no normals (vn) in the file: their indices are left out"],
            "t crease 2/1/0 1 2 4.7\nf 1 2 3\n": ["m.obj:4: 't' is no known statement of an OBJ file and is left out"],
            "vw 0 0 1\nvw 1 0 1\nf 1 2 3\n": ["m.obj:4: 'vw' is no known statement of an OBJ file and is left out (2 times)"],
            "v 1e-400 2e-324 -1e-999\nf 4 2 3\n": []}.items():
        equal(shown(good + text), (tidy, remarks), f"{text!r}")
    write("m.obj", good + "t 1\nf 1 2 3\n")
    for words in (["run", "pipeline", "m.obj"], ["figure", "pipeline", "m.obj", "-o", "m.svg"], ["again", "m.svg"]):
        check("m.obj:4: 't' is no known statement of an OBJ file and is left out\n" in gradus(*words).err, f"{words}: a remark")
        check("known" not in gradus(*words, "-q").err, f"{words} -q: none")


def test_files_that_files_name():
    """A model, a lecture and a figure may name any path: nothing waits, and nothing of a stranger's file is shown."""
    face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n"
    os.mkdir("here")
    os.chdir("here")
    os.mkfifo("pipe")
    write("../secret.txt", "topsecret:x:0:0:#.#\n")
    write("red one.mtl", "newmtl red\nKd 1 0 0\n")
    def rendered(library, code=0):
        write("m.obj", f"mtllib {library}\n{face}")
        result = gradus("render", "m.obj", "-o", "m.png", "--size", "40x30", timeout=20)
        equal(result.code, code, f"mtllib {library}: {result.err}")
        return result.err
    equal(rendered("red\\ one.mtl"), "m.png\n", "an escaped blank")
    check(Picture(read("m.png")).where(lambda p: p[0] > p[1] + 50), "and the material is red")
    equal(rendered("pipe", 2), "gradus: m.obj:1: expected a regular file, found the pipe 'pipe'\n", "a pipe as a library")
    for name in ("../secret.txt", os.path.abspath("../secret.txt")):
        equal(rendered(name, 2).count("topsecret"), 0, f"{name} is not quoted")
        check(rendered(name, 2).endswith("secret.txt:1: expected newmtl first, found something else\n"), rendered(name, 2))
    for words in (["render", "pipe", "-o", "x.png"], ["run", "pipeline", "pipe"], ["run", "flood_fill", "--maze", "pipe"],
                  ["run", "flood_fill", "--image", "pipe"], ["figures", "pipe"], ["again", "pipe"]):
        result = gradus(*words, timeout=20)
        check(result.code == 2 and re.fullmatch(r"gradus: [^\n]*expected a regular file, found the pipe 'pipe'\n", result.err),
              f"{words}: {result.code} {result.err}")
    # What a lecture names
    write("l.json", '{"figures": [{"topic": "flood_fill", "input": {"maze": "../secret.txt"}},\n'
                    '{"topic": "pipeline", "input": {"model": "../secret.txt"}},\n'
                    '{"topic": "flood_fill", "input": {"image": "../secret.txt"}}],\n'
                    '"renders": [{"model": "../secret.txt"},\n{"model": "pipe"}]}')
    for words in ([], ["--check"]):
        result = gradus("figures", "l.json", *words, timeout=20)
        check(result.code == 2 and "topsecret" not in result.err and "found ':'" not in result.err, f"{words}: {result.err}")
    check("renders[1].model: expected a regular file, found the pipe 'pipe'" in result.err, result.err)
    write("own.txt", "#.#\n#:#\n")
    write("l.json", '{"figures": [{"topic": "flood_fill", "input": {"maze": "own.txt", "at": "1,0"}}]}')
    check("own.txt:2: found ':'" in gradus("figures", "l.json", "--check").err, "a file beside the lecture is quoted")


def test_models_by_name():
    """The models that come with the program need no path, wherever one works; a file of that name goes before them."""
    for name, words in {"letter_f.obj": [], "letter_f": [], "spot.obj": ["--eye=-1.5,1.2,-2.7"], "koala.obj": [], "room": []}.items():
        equal(gradus("render", name, "-o", "a.png", "-q", "--size", "40x30", *words).code, 0, name)
        gradus("render", str(MODELS / (name.split(".")[0] + ".obj")), "-o", "b.png", "-q", "--size", "40x30", *words)
        equal(Picture(read("a.png")).pixels, Picture(read("b.png")).pixels, name)
    equal(gradus("run", "pipeline", "letter_f").code, 0, "for topics too")
    equal(gradus("figure", "flood_fill", "--image", "horse.png", "--at", "5,5", "--steps", "0", "-o", "a.svg").code, 0, "a picture")
    write("spot.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")
    equal(gradus("render", "spot.obj", "-o", "a.png").err[:16], "gradus: spot.obj", "a file here")
    equal(gradus("render", "models/spot.obj", "-o", "a.png").code, 2, "a path is a path")


# --- Again ------------------------------------------------------------------------------------------------------


def refused(message, *words):
    before = sorted(os.listdir("."))
    result = gradus("again", *words)
    equal((result.code, result.bytes), (2, b""), f"again {words}")
    check(re.fullmatch(f"gradus: {message}\n", result.err), f"again {words}: {result.err}")
    equal(sorted(os.listdir(".")), before, f"again {words} leaves nothing")


def test_again():
    for name in ("letter_f.obj", "letter_f.mtl"):
        shutil.copy(MODELS / name, name)
    gradus("render", "letter_f.obj", "-o", "f.png", "--size", "80x60", "--eye", "-1,1,-4", "--background", "navy")
    equal((gradus("again", "f.png").code, read("f-again.png")), (0, read("f.png")), "made again, byte by byte")
    equal(gradus("again", "-", stdin=read("f.png")).bytes, read("f.png"), "from standard input to standard output")
    os.mkdir("elsewhere")
    shutil.copy("f.png", "elsewhere/f.png")
    equal((gradus("again", "elsewhere/f.png", "-o", "g.png").code, read("g.png")), (0, read("f.png")), "with the model here")
    os.chdir("elsewhere")
    equal((gradus("again", "f.png", "-q").code, read("f-again.png")), (0, read("f.png")), "with the model that comes with the program")
    shutil.copy(MODELS / "letter_f.obj", "../own.obj")
    gradus("render", "../own.obj", "-o", "own.png", "-q")
    refused("MODEL: expected the file 'own.obj' beside the figure or in the current folder, found none", "own.png")
    equal(gradus("again", "../f.png", "-o", "g.png").code, 0, "with the model beside the picture")
    equal(read("g.png"), read("../f.png"), "with the model beside the picture")
    os.chdir("..")
    gradus("again", "f.png", "-o", "big.png", "--size", "160x120", "--background", "none")
    gradus("render", "letter_f.obj", "-o", "other.png", "--size", "160x120", "--eye", "-1,1,-4", "--background", "none")
    equal(read("big.png"), read("other.png"), "larger, on another ground")
    refused("--theme: expected a figure, found the rendered picture 'f.png'", "f.png", "--theme", "dark")
    refused("--label: expected a figure, found the rendered picture 'f.png'", "f.png", "--label", "p=d")
    refused("-o: expected a name that ends in .png or .html, found 'f.svg'", "f.png", "-o", "f.svg")
    refused("-o: expected another file than the input, found 'f.png'", "f.png", "-o", "f.png")
    write("letter_f.mtl", read("letter_f.mtl") + b"\n")
    refused(r"again: expected the input with which the figure was made \(.*\), found fnv1a:\S+ fnv1a:\S+", "f.png")
    os.remove("letter_f.mtl")
    refused(r"again: expected the input with which the figure was made \(.*\), found fnv1a:\S+", "f.png")
    write("letter_f.obj", read("letter_f.obj") + b"\n")
    refused(r"MODEL: expected the file with which the figure was made \(.*\), found another 'letter_f.obj'", "f.png")
    write("piped.png", gradus("render", "-", "-o", "-", stdin=read(SPOT)).bytes)
    refused("again: expected a picture of a model from a file, found one from standard input", "piped.png")
    for number, command in enumerate(("gradus render --help", "gradus render a.obj -o b.png", "gradus render", "gradus list x",
                                      "gradus render a.obj b.obj", "rm -rf x")):
        name = f"evil{number}.png"
        write(name, png({"gradus-command": command}))
        refused("(again|render): expected .*, found .*", name)
    write("walk.png", png({"gradus-command": f"gradus render ../../{SPOT}", "gradus-input-hash": "x"}))
    refused(r"MODEL: expected the file with which the figure was made \(x\), found another '\S*/models/spot.obj'", "walk.png")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
