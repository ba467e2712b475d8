#!/usr/bin/env python3
"""`gradus render` of scenes: the shipped ones, flags over files, and a schema that says what the program does.

    tests/golden/scene_test.py [GRADUS]

Needs jsonschema (Debian: python3-jsonschema).
"""
import copy
import json
import math
import os
import random
import re
import shutil
import sys
import pathlib

import jsonschema

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal
from renders import LETTER, MODELS, ROOT, SHARE, Picture, differing, gradus, picture, png, read, write

SCENES = ROOT / "examples/scenes"
NAMES = sorted(path.stem for path in SCENES.glob("*.json"))
SEED = int(os.environ.get("GRADUS_SEED", 20261125))
MUTATIONS = 4000 if os.environ.get("GRADUS_STRESS") else 250
SCHEMA = json.loads((ROOT / "docs/scene.schema.json").read_text(encoding="utf-8"))
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
# What no schema can say of a scene
BEYOND = re.compile("|".join((
    "a place with an inverse", "an inner cone within", "a far plane behind", "another point than", "a direction that is not along",
    "another direction than", "the name of a file that is there", "no number of samples", "a square like", "the last row",
    "a frame after", "told apart", "the vertical angle of view.*found [0-9.]+$", "coordinates", "in all")))


def in_scenes_folder():
    """A copy of the shipped scenes, to write others beside them."""
    shutil.copytree(SCENES, "scenes")
    shutil.copytree(MODELS, "models")
    os.chdir("scenes")


def test_shipped_scenes():
    equal(NAMES, ["circular_road", "closed_room", "cornell_box", "koala", "pasture", "spot", "street", "town", "town_at_night", "town_flight", "wide_field"], "what is shipped")
    for name in NAMES:
        shown = picture(f"{name}.json", "--size", "96x64")
        scene = json.loads((SCENES / f"{name}.json").read_text())
        objects = sum(len(one.get("instances", [0])) for one in scene["objects"])
        check(f" {objects} object" in shown.texts["Description"], f"{name}: {shown.texts['Description']}")
        check(len({p for row in shown.pixels for p in row}) > 20, f"{name} shows something")


def test_opacity_is_drawn_by_the_a_buffer_alone():
    write("wall.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n")
    def wall(z, light, opacity):
        material = {"diffuse": [0, 0, 0], "emission": light, "opacity": opacity}
        return {"model": "wall.obj", "place": {"translate": [0, 0, z]}, "material": material}
    write("s.json", json.dumps({"size": [9, 9], "background": [0, 0, 1], "camera": {"eye": [0, 0, 9], "fov": 6},
                                "objects": [wall(-1, [0, 1, 0], 0.5), wall(1, [1, 0, 0], 0.5)]}))
    remark = "render: what lets light through is drawn opaque; --aa a_buffer draws it by its opacity\n"
    for words, said, colour in ((("--aa", "a_buffer"), "", (188, 137, 137)), ((), remark, (255, 0, 0)), (("--aa", "none"), remark, (255, 0, 0))):
        result = gradus("render", "s.json", "-o", "-", *words)
        equal((result.code, result.err), (0, said), f"{words}: a remark")
        # Half of the first, a quarter of the second and of the ground, in sRGB
        equal(Picture(result.bytes).pixels[4][4], colour, f"{words}: the middle")


def in_view(camera, place, radius):
    """Whether a ball lies in the round cone about the picture of a camera, or touches it."""
    minus = [t - e for t, e in zip(camera["target"], camera["eye"])]
    way = [p - e for p, e in zip(place, camera["eye"])]
    distance = math.hypot(*way)
    if distance <= radius:
        return True
    half = math.atan(math.hypot(16 / 9, 1) * math.tan(math.radians(camera["fov"] / 2)))
    cosine = sum(a * b for a, b in zip(minus, way)) / math.hypot(*minus) / distance
    return math.acos(max(-1, min(1, cosine))) <= half + math.asin(radius / distance)


def test_the_town_lies_mostly_out_of_view():
    scene = json.loads((SCENES / "town.json").read_text())
    places = [next(step["translate"] for step in place if "translate" in step) for one in scene["objects"]
              if one["name"] in ("house", "tower", "tree") for place in one["instances"]]
    seen = sum(in_view(scene["camera"], place, 24) for place in places)
    print(f"at most {seen} of {len(places)} houses, towers and trees are in view")
    check(len(places) > 1000 and 10 < seen < len(places) / 2, f"{seen} of {len(places)}")


def test_the_cornell_box_is_red_on_the_left_and_lit_from_above():
    shown = picture("cornell_box.json", "--size", "60x60")
    red, green = shown.pixels[30][5], shown.pixels[30][54]
    check(red[0] > 2 * red[1] and green[1] > 1.5 * green[0], f"{red} {green}")
    check(min(shown.pixels[8][30]) > 240, f"the lamp: {shown.pixels[8][30]}")
    check(shown.pixels[55][20][1] > shown.pixels[3][20][1] + 50, f"the floor is lit, the ceiling is not: {shown.pixels[55][20]}")


def test_the_closed_room_has_no_background():
    check(gradus("render", "closed_room.json", "--size", "64x36", "--background", "none", "-o", "r.png").code == 0, "drawn")
    shown = Picture(read("r.png"))
    check(shown.kind == 2 or all(p[3] == 255 for row in shown.pixels for p in row), "walls all round")


def test_examples_of_the_page_run():
    page = (ROOT / "docs/scenes.md").read_text(encoding="utf-8")
    examples = re.findall(r"^gradus (render .*)$", page, re.M)
    check(len(examples) >= 2, examples)
    for line in examples:
        equal(gradus(*line.split()).code, 0, line)
    for name in ("street.png", "town.png"):
        check(differing(Picture(read(name)), Picture(read(ROOT / "docs/rendering" / name))) <= SHARE, f"docs/rendering/{name}")
    scene = json.loads(re.search(r"```json\n(.*?)```", page, re.S)[1])
    check(VALIDATOR.is_valid(scene), "the page's scene is valid")
    write("page.json", json.dumps(scene))
    shutil.copytree(MODELS, ".", dirs_exist_ok=True)
    equal(gradus("render", "page.json", "-o", "page.png", "--size", "96x54").code, 0, "and drawn")


def test_a_scene_of_one_model_is_that_model():
    write("one.json", json.dumps({"objects": [{"model": LETTER}]}))
    for words in ((), ("--eye", "3,1,-4"), ("--shading", "flat", "--aa", "none"), ("--up", "0,0,1")):
        a, b = (picture(file, "--size", "80x60", *words) for file in ("one.json", LETTER))
        check(a.pixels == b.pixels, f"the same pixels with {words}")


def test_a_moved_object_with_a_moved_camera_is_the_same_picture():
    lights = [{"kind": "directional", "direction": [0.5, -1, 0.25]}]
    camera = {"eye": [2, 1, -4], "target": [0, 0.5, 0], "near": 1, "far": 16}
    write("a.json", json.dumps({"camera": camera, "lights": lights, "objects": [{"model": LETTER}]}))
    camera.update(eye=[10, 3, 12], target=[8, 2.5, 16])
    write("b.json", json.dumps({"camera": camera, "lights": lights, "objects": [{"model": LETTER, "place": {"translate": [8, 2, 16]}}]}))
    check(picture("a.json", "--size", "80x60").pixels == picture("b.json", "--size", "80x60").pixels, "moved together")


def test_flags_change_what_the_file_says():
    write("s.json", json.dumps({"size": [40, 30], "background": "#204060", "shading": "flat", "aa": "jittered", "samples": 4,
                                "camera": {"eye": [3, 1, -4], "fov": 30}, "objects": [{"model": LETTER}]}))
    shown = picture("s.json")
    equal((shown.width, shown.height, shown.pixels[0][0]), (40, 30, (0x20, 0x40, 0x60)), "what the file says")
    equal(shown.texts["gradus-command"], "gradus render s.json", "its command")
    changed = picture("s.json", "--size", "800x600", "--fov", "40", "--background", "white", "--aa", "adaptive", "--shading", "phong")
    equal((changed.width, changed.pixels[0][0]), (800, (255, 255, 255)), "defaults, too")
    equal(changed.texts["gradus-command"],
          "gradus render s.json --size 800x600 --fov 40 --background '#ffffff' --shading phong --aa adaptive", "its command")
    result = gradus("render", "s.json", "-o", "x.png", "--samples", "5", "--aa", "supersampling")
    equal((result.code, os.path.exists("x.png")), (2, False), "a flag that does not fit")


def test_again():
    in_scenes_folder()
    gradus("render", "spot.json", "-o", "spot.png", "--size", "96x54")
    equal((gradus("again", "spot.png").code, read("spot-again.png")), (0, read("spot.png")), "made again, byte by byte")
    write("../models/spot.mtl", read("../models/spot.mtl") + b"\n")
    result = gradus("again", "spot.png", "-o", "y.png")
    check(result.code == 2 and "expected the input with which the figure was made" in result.err, result.err)


def test_wrong_files():
    for text, expected in (
            ("{", "x.json:1: expected a key in double quotes or '}', found the end of the file"),
            ('{"objects": [{"model": "nowhere.obj"}]}',
             "x.json:1: /objects/0/model: expected the name of a file that is there, found 'nowhere.obj'"),
            ('{"objects": [{"model": "."}]}', "x.json:1: /objects/0/model: expected the name of a file that is there, found '.'"),
            ('{"objects": [\n{"model": "broken.obj"}]}', "broken.obj:1: ")):
        write("x.json", text)
        write("broken.obj", "v 0 zero 0\n")
        result = gradus("render", "x.json", "-o", "x.png")
        equal(result.code, 2, text)
        check(result.err.startswith(f"gradus: {expected}") and result.err.count("\n") == 1, result.err)
        check(not os.path.exists("x.png"), "nothing is written")


def test_a_scene_that_others_named_is_not_quoted():
    """`gradus again` reads what a picture's command names: whatever file that is, its text stays unseen."""
    os.mkdir("below")
    write("secret.json", '{"password": "sesame"}')
    own = gradus("render", "secret.json", "-o", "x.png")
    check("'password'" in own.err, f"one's own file is quoted: {own.err}")
    write("below/walk.png", png({"gradus-command": "gradus render ../secret.json", "gradus-input-hash": "x"}))
    os.chdir("below")
    result = gradus("again", "walk.png")
    check(result.code == 2 and not re.search("password|sesame", result.err), result.err)


def test_a_mirrored_body_is_its_mirror_image():
    """A body is seen from its outside, mirrored or not."""
    for scale, words in (([1, 1, 1], ["--eye", "-2,1,4"]), ([-1, 1, 1], ["--eye", "2,1,4"])):
        write("m.json", json.dumps({"camera": {"target": [0, 0.5, 0], "near": 1, "far": 9}, "ambient": [0.5, 0.5, 0.5],
                                    "lights": [{"kind": "directional", "direction": [0, -1, -1]}],
                                    "objects": [{"model": LETTER, "place": {"scale": scale}}]}))
        shown = picture("m.json", "--size", "81x60", "--aa", "area_sampling", *words)
        if scale[0] > 0:
            plain = shown
    check(len({p for row in plain.pixels for p in row}) > 20, "something is seen")
    check(differing(plain, shown.mirrored()) <= SHARE, f"mirrored: {differing(plain, shown.mirrored())}")


# --- The schema ----------------------------------------------------------------------------------------------------------


def places(value, way=()):
    """The ways to all values in some JSON."""
    yield way
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, part in inner:
        yield from places(part, (*way, key))


def changed(scene, rng):
    """The scene with one value left out, replaced, doubled or with a neighbour nobody knows."""
    scene = copy.deepcopy(scene)
    way = rng.choice([way for way in places(scene) if way])
    holder = scene
    for key in way[:-1]:
        holder = holder[key]
    kind = rng.randrange(8)
    if kind == 0:
        del holder[way[-1]]
    elif kind == 1 and isinstance(holder, dict):
        holder[rng.choice(["fov", "near", "focal", "colour", "scale", "target", "samples", "range", "matrix", "height", "receding",
                           "projection", "path", "interpolation", "frame", "eye"])] = rng.choice(
            [1, 2, 30, [1, 2, 3], "#ffffff", [[1, 0, 0, 2], [0, 1, 0, 3], [0, 0, 1, 4]]])
    elif kind == 2 and isinstance(holder, list):
        holder.insert(way[-1], copy.deepcopy(holder[way[-1]]))
    else:
        holder[way[-1]] = rng.choice([None, True, False, -1, 0, 1, 0.5, 2.5, 7, 1e31, 5e-324, -9e-31, 1e-30, [0, 1e-31, 0], "", "x", "x\0y", "#a0B1c2", "flat", "none", "point", "oblique", [], {},
                                      [1, 2], [1, 2, 3], [0, 0, 0], [4, 4], [1, "2", 3], {"translate": [1, 2, 3]}, {"scale": 0}])
    return scene


def test_the_schema_says_what_the_program_does():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    for name in NAMES:
        check(VALIDATOR.is_valid(json.loads((SCENES / f"{name}.json").read_text())), f"{name} is valid")
    scenes = [json.loads((SCENES / f"{name}.json").read_text()) for name in NAMES if name != "town"]
    scenes[0]["lights"].append({"kind": "spot", "position": [0, 9, 0], "direction": [0, -1, 0.1], "outer": 40, "inner": 20,
                                "concentration": 1, "attenuation": [1, 0, 0.1], "range": 100})
    scenes[0].update(shading="flat", filter="bilinear", aa="jittered", samples=4)
    scenes[0]["objects"][0].update(two_sided=True, place=[
        {"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}, {"scale": [2, 2, 2]},
        {"rotate": {"axis": [0, 1, 0], "degrees": 5, "about": [0, 0, 1]}}])
    scenes[0]["objects"][1]["material"] = {"ambient": [0, 0, 0], "diffuse": "#123456", "specular": [1, 1, 1], "shininess": 3,
                                           "emission": [0, 0, 0]}
    scenes[0].update(hidden_surfaces="painter", culling="none")
    scenes[0]["camera"].update(near=0.5, far=500, up=[0, 1, 0.1])
    parallel = copy.deepcopy(scenes[0])
    parallel.update(hidden_surfaces="bsp_tree", culling="back", shading="wireframe")
    del parallel["camera"]["fov"]
    parallel["camera"].update(projection="oblique", height=4, receding=30, foreshortening=1)
    scenes.append(parallel)
    in_scenes_folder()
    print(f"GRADUS_SEED={SEED}")
    rng, taken, refused = random.Random(SEED), 0, 0
    for number in range(MUTATIONS):
        scene = changed(rng.choice(scenes), rng) if number else scenes[0]
        write("m.json", json.dumps(scene, indent=1))
        result = gradus("render", "m.json", "-o", "m.png", "--size", "4x4", "-q", "--force")
        valid, text = VALIDATOR.is_valid(scene), json.dumps(scene)
        check(result.code in (0, 2), f"{result.code} {result.err}: {text}")
        if result.code == 0:
            check(valid, f"the schema refuses what the program takes: {next(VALIDATOR.iter_errors(scene), None)}: {text}")
            taken += 1
        else:
            check(not valid or BEYOND.search(result.err), f"the program refuses what the schema takes: {result.err}: {text}")
            check(re.match(r"gradus: (\S+\.json:\d+: /|--|MODEL|\S+\.obj)", result.err) and result.err.count("\n") == 1, result.err)
            refused += 1
    print(f"{taken} taken, {refused} refused")
    check(taken > MUTATIONS / 10 and refused > MUTATIONS / 3, "both happen")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
