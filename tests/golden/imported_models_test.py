#!/usr/bin/env python3
"""Models that are no OBJ files: the same picture as of the same model in OBJ, and one line for what is wrong with them.

    tests/golden/imported_models_test.py [GRADUS]
"""
import json
import os
import pathlib
import random
import re
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal
from model_files import Model, box, data_uri, glb, glb_of, gltf, gltf_parts, house, obj, ply, stl
from renders import MODELS, Picture, gradus, picture, read, write

SMALL = ("--size", "64x48")
SEED = int(os.environ.get("GRADUS_SEED", 20261125))
MUTATIONS = 2000 if os.environ.get("GRADUS_STRESS") else 60
TEXTURE = MODELS / "spot_texture.png"


def pixels(name, *words):
    return picture(name, *SMALL, *words).pixels


def written(name, data):
    write(name, data)
    return name


# --- The same picture ------------------------------------------------------------------------------------------


def test_formats_that_carry_the_same():
    """Positions and faces alone: flat in STL and glTF, smooth in PLY."""
    cut = house().cut()
    flat, smooth = pixels(written("flat.obj", obj(cut))), pixels(written("smooth.obj", obj(house(), smooth=True)))
    check(flat != smooth, "the two can be told apart")
    for name, data in {"a.stl": stl(cut), "b.STL": stl(cut, binary=True), "a.gltf": gltf(cut), "a.glb": glb(cut)}.items():
        # glTF's default material is white, ours is not
        check(pixels(written(name, data)) == flat if "stl" in name.lower() else True, f"{name} looks like flat.obj")
    grey = {"pbrMetallicRoughness": {"baseColorFactor": [0.7, 0.7, 0.7, 1]}}
    write("grey.obj", obj(cut, "mtllib grey.mtl\nusemtl grey"))
    write("grey.mtl", "newmtl grey\nKd 0.7 0.7 0.7\n")
    flat_grey = pixels("grey.obj")
    equal(flat_grey, flat, "the default, said")
    for name, data in {"a.gltf": gltf(cut, material=grey), "a.glb": glb(cut, material=grey)}.items():
        check(pixels(written(name, data)) == flat, f"{name} looks like flat.obj")
    for name, data in {"a.ply": ply(house()), "b.ply": ply(house(), "<"), "c.ply": ply(house(), ">")}.items():
        check(pixels(written(name, data)) == smooth, f"{name} looks like smooth.obj")
    # Bodies are closed as in OBJ: the explanation says so of each
    for name in ("flat.obj", "smooth.obj", "a.stl", "a.glb", "b.ply"):
        check("closed and outward" in gradus("explain", name).out, f"{name} is a closed body")


def test_textures():
    """A picture beside the model, in its buffer and in its JSON, v from the other edge; names as URIs have them."""
    model, png = box(2, 1, 1).cut(), read(TEXTURE)
    write("wood of mine.png", png)
    write("m.mtl", "newmtl m\nKd 0.5 0.25 1\nmap_Kd wood of mine.png\n")
    write("m.obj", obj(model, "mtllib m.mtl\nusemtl m"))
    expected = pixels("m.obj")
    material = {"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1], "baseColorTexture": {"index": 0}}}
    root, buffer = gltf_parts(model, material=material, image="wood%20of%20mine.png")
    root["buffers"] = [{"byteLength": len(buffer), "uri": "the%20buffer.bin"}]
    write("the buffer.bin", buffer)
    for name, data in {"beside.gltf": json.dumps(root), "inside.gltf": gltf(model, material=material, image=data_uri(png, "image/png")),
                       "inside.glb": glb(model, material=material, image=png)}.items():
        check(pixels(written(name, data)) == expected, f"{name} looks like m.obj")
    plain = pixels("inside.glb", "--filter", "none")
    check(plain == pixels("m.obj", "--filter", "none") != expected, "--filter none reads none")
    # A file that has changed is told, the same one gives the same bytes
    shown = picture("beside.gltf", *SMALL)
    equal(len(shown.texts["gradus-input-hash"].split()), 3, "model, buffer and picture")
    equal(gradus("render", "beside.gltf", *SMALL, "-o", "m.png").code, 0, "rendered")
    equal(gradus("again", "m.png", "-o", "again.png").code, 0, "again")
    equal(read("again.png"), read("m.png"), "the same bytes")
    write("the buffer.bin", buffer[:-1] + b"?")
    result = gradus("again", "m.png", "-o", "again.png")
    check(result.code == 2 and "again: expected the input with which" in result.err, f"another buffer: {result.err}")
    result = gradus("render", "beside.gltf", "-o", "the buffer.bin")
    check(result.code == 2 and "-o: expected a name that ends in .png" in result.err, result.err)


def test_nodes():
    """Hierarchies are multiplied out; what a node mirrors keeps its outside."""
    model = box(1, 2, 0.5).cut()
    turn = [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1]  # a quarter about z, then by 1 to the right; column by column
    nodes = [{"children": [1, 2], "translation": [0, 0, 1]}, {"mesh": 0, "matrix": turn},
             {"children": [3], "scale": [2, 2, 2], "translation": [4, 0, 0]}, {"mesh": 0, "scale": [-1, 1, 1]}]
    first = model.moved(lambda p: (1 - p[1], p[0], p[2] + 1))
    second = model.turned_round().moved(lambda p: (4 - 2 * p[0], 2 * p[1], 2 * p[2] + 1))
    grey = {"pbrMetallicRoughness": {"baseColorFactor": [0.7, 0.7, 0.7, 1]}}
    write("m.glb", glb(model, nodes=nodes, material=grey))
    write("m.obj", obj(first.and_also(second)))
    for words in ((), ("--culling", "back"), ("--eye", "9,4,-7")):
        check(pixels("m.glb", *words) == pixels("m.obj", *words), f"{words}: as the transformed OBJ file")
    result = gradus("explain", "m.glb")
    check("closed and outward" in result.out, f"and it is closed: {result.out}")


def test_scenes_and_why():
    model = box().cut()
    write("m.ply", ply(model))
    write("m.obj", obj(model, smooth=True))
    def scene(name):
        return json.dumps({"objects": [{"model": name, "place": {"translate": [i, 0, 0]}} for i in (0, 3)]})
    check(pixels(written("p.json", scene("m.ply"))) == pixels(written("o.json", scene("m.obj"))), "a scene of it")
    equal(len(picture("p.json", *SMALL).texts["gradus-input-hash"].split()), 2, "scene and model")
    result = gradus("render", "m.ply", *SMALL, "--why", "32,24")
    check(result.code == 0 and "m.ply, face 1 (m.ply:18), triangle 1 of 1" in result.out, f"why: {result.out}")


def test_remarks():
    """What is there and not used."""
    root, buffer = gltf_parts(box().cut())
    root["cameras"] = [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}]
    root["nodes"].append({"camera": 0})
    root["scenes"][0]["nodes"].append(1)
    write("m.glb", glb_of(root, buffer))
    result = gradus("render", "m.glb", *SMALL, "-o", "m.png")
    equal((result.code, result.err), (0, "m.glb: its cameras and lights are not used\nm.png\n"), "a camera")
    colours = ply(box()).replace(b"property float z\n", b"property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n")
    rows = colours.split(b"\n")
    start = rows.index(b"end_header") + 1
    write("m.ply", b"\n".join(rows[:start] + [row + b" 255 0 0" for row in rows[start:start + 8]] + rows[start + 8:]))
    equal(gradus("render", "m.ply", *SMALL, "-o", "m.png").err, "m.ply: colours of vertices are not used\nm.png\n", "colours")


def test_remarks_of_gltf():
    """Colours of vertices, and a picture that is laid on turned."""
    model = box(2, 1, 1).cut()
    root, buffer = gltf_parts(model)
    count = root["accessors"][0]["count"]
    root["bufferViews"].append({"buffer": 0, "byteOffset": len(buffer), "byteLength": 12 * count})
    root["accessors"].append({"bufferView": len(root["bufferViews"]) - 1, "componentType": 5126, "count": count, "type": "VEC3"})
    root["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = len(root["accessors"]) - 1
    write("c.glb", glb_of(root, buffer + struct.pack("<3f", 1, 0, 0) * count))
    equal(gradus("render", "c.glb", *SMALL, "-o", "m.png").err, "c.glb: colours of vertices are not used\nm.png\n", "colours")
    turned = {"index": 0, "extensions": {"KHR_texture_transform": {"rotation": 1, "scale": [2, 2]}}}
    root, buffer = gltf_parts(model, material={"pbrMetallicRoughness": {"baseColorTexture": turned}}, image=read(TEXTURE))
    root["extensionsUsed"] = ["KHR_texture_transform"]
    write("t.glb", glb_of(root, buffer))
    equal(gradus("render", "t.glb", *SMALL, "-o", "m.png").err,
          "t.glb: textures are laid on without their own transformations\nm.png\n", "a turned texture")


COLLADA = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="x" meter="{meter}"/><up_axis>Y_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><phong><diffuse>{diffuse}</diffuse></phong></technique></profile_COMMON>
</effect></library_effects><library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="s" count="1"><input semantic="VERTEX" source="#v" offset="0"/>{inputs}<p>{corners}</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="w"><node><instance_geometry url="#{geometry}"><bind_material>
<technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry>{more}</node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#w"/></scene></COLLADA>
"""
FBX = """; FBX 7.3.0 project file
FBXHeaderExtension:  {{
	FBXHeaderVersion: 1003
	FBXVersion: {version}
}}
GlobalSettings:  {{
	Version: 1000
	Properties70:  {{
	}}
}}
Definitions:  {{
	Version: 100
	Count: 0
}}
Objects:  {{
	Geometry: 10, "Geometry::", "Mesh" {{
		Properties70:  {{
		}}
		Vertices: *9 {{
			a: 0,0,0,1,0,0,0,1,0
		}}
		PolygonVertexIndex: *3 {{
			a: {corners}
		}}
		LayerElementMaterial: 0 {{
			MappingInformationType: "AllSame"
			ReferenceInformationType: "IndexToDirect"
			Materials: *1 {{
				a: 0
			}}
		}}
		Layer: 0 {{
			LayerElement:  {{
				Type: "LayerElementMaterial"
				TypedIndex: 0
			}}
		}}
	}}
	Model: 20, "Model::tri", "Mesh" {{
		Properties70:  {{
		}}
	}}
	Material: 30, "Material::m", "" {{
		ShadingModel: "{shading}"
		Properties70:  {{
		}}
	}}
}}
Connections:  {{
	C: "OO",20,0
	C: "OO",10,20
	C: "OO",30,20
	C: "OO",{lost},20
}}
"""


def test_what_assimp_says_of_a_file():
    """What it finds wrong and reads nevertheless is one remark: each once, the first three, how many more."""
    def said(name, text):
        write(name, text)
        result = gradus("render", name, *SMALL, "-o", "m.png")
        check(result.code == 0 and result.err.endswith("m.png\n"), f"{name}: {result.code} {result.err}")
        return result.err[:-len("m.png\n")]

    def collada(**other):
        given = {"meter": 1, "diffuse": "<color>1 0 0 1</color>", "inputs": "", "corners": "0 1 2", "geometry": "g", "more": ""}
        return COLLADA.format(**{**given, **other})

    def fbx(**other):
        return FBX.format(**{"version": 7300, "corners": "0,1,-3", "shading": "phong", "lost": 30, **other})

    equal((said("whole.dae", collada()), said("whole.fbx", fbx())), ("", ""), "nothing is wrong")
    gone = '<instance_geometry url="#gone"/>'
    equal(said("a.dae", collada(more=2 * gone)), 'a.dae: Assimp warns: Collada: Unable to find geometry for ID "gone". Skipping.\n', "told once")
    lost = "".join(f'<instance_geometry url="#gone{i}"/>' for i in range(5))
    told = "; ".join(f'Collada: Unable to find geometry for ID "gone{i}". Skipping.' for i in range(3))
    equal(said("a.dae", collada(more=lost)), f"a.dae: Assimp warns: {told}; and 2 more\n", "told in short")
    for key, value, word in (("meter", "parsec", "meter"), ("inputs", '<input semantic="ODD" source="#p" offset="0"/>', '"ODD"')):
        found = said("a.dae", collada(**{key: value}))
        check(found.startswith("a.dae: Assimp warns: ") and word in found and found.count("\n") == 1, f"{key}: {found}")
    for key, value, word in (("lost", 77, "source object for connection does not exist"), ("version", 9900, "newer format version"),
                             ("shading", "odd", "shading mode not recognized: odd")):
        found = said("a.fbx", fbx(**{key: value}))
        check(found.startswith("a.fbx: Assimp warns: ") and word in found and found.count("\n") == 1, f"{key}: {found}")
    equal(gradus("render", "a.fbx", *SMALL, "-o", "m.png", "-q").err, "", "-q")
    # Where nothing can be drawn, it is why
    refused("a.dae", collada(geometry="gone"), "expected at least one face, found none", 'Unable to find geometry for ID "gone"')
    refused("a.dae", collada(corners="0 1 77"), "Invalid data index (77/3)")
    refused("a.fbx", fbx(corners="0,1,-78"), "expected at least one face, found none", "polygon vertex index out of range")
    refused("a.dae", collada(diffuse='<texture texture="none" texcoord="UV"/>'), "of material 'm': expected a PNG or JPEG file")
    # Of a file elsewhere that a scene names nothing is quoted
    write("b.dae", collada(more=lost))
    os.mkdir("here")
    os.chdir("here")
    write("s.json", json.dumps({"objects": [{"model": "../b.dae"}]}))
    equal(gradus("render", "s.json", *SMALL, "-o", "m.png").err, "../b.dae: Assimp has 5 warnings\nm.png\n", "of a scene")


def test_without_assimp():
    """It is loaded by the first model that needs it."""
    write("m.dae", COLLADA)
    os.mkdir("broken")
    name = re.search(r"find library=(libassimp\S+)", gradus("explain", "m.dae", env={"LD_DEBUG": "libs"}).err)[1]
    write(f"broken/{name}", "")
    result = gradus("explain", "m.dae", env={"LD_LIBRARY_PATH": f"{os.getcwd()}/broken"})
    check(result.code == 1 and result.err.startswith(f"gradus: models of this format need {name}: ") and result.err.count("\n") == 1,
          result.err)


def test_stl_as_other_readers_take_it():
    """In capitals, and with bytes behind its last triangle: a remark tells them."""
    model = house().cut()
    flat = pixels(written("flat.obj", obj(model)))
    check(pixels(written("capitals.stl", stl(model).upper())) == flat, "capitals")
    write("longer.stl", stl(model, binary=True) + b"more")
    result = gradus("render", "longer.stl", *SMALL, "-o", "longer.png")
    equal((result.code, result.err), (0, "longer.stl: 4 bytes behind its 16 triangles are left out\nlonger.png\n"), "longer")
    check(Picture(read("longer.png")).pixels == flat, "and it is drawn whole")


# --- What is refused --------------------------------------------------------------------------------------------


def refused(name, data, *expected):
    """One line that holds all of these, code 2, and nothing written."""
    write(name, data)
    before = sorted(os.listdir("."))
    result = gradus("render", name, *SMALL, "-o", "out.png", timeout=60)
    fits = result.code == 2 and result.err.startswith(f"gradus: {name}") and result.err.count("\n") == 1
    check(fits and all(text in result.err for text in expected), f"{name}: {expected}\n    {result.code} {result.err}")
    equal(sorted(os.listdir(".")), before, f"{name} leaves nothing")


def test_broken_files():
    model = box().cut()
    whole = glb(model)
    refused("a.gltf", gltf(model, uri="gone.bin"), "a.gltf: expected the file 'gone.bin' beside it, found none")
    os.mkdir("folder.bin")
    refused("a.gltf", gltf(model, uri="folder.bin"), "a.gltf: expected the file 'folder.bin' beside it, found none")
    refused("cut.glb", whole[:-40], "cut.glb:1: expected a buffer of 720 bytes, found one of 680")
    for name in ("a.ply", "a.stl", "a.glb", "a.gltf", "a.fbx", "a.dae", "a.3ds", "a.off"):
        refused(name, "", f"{name}")
        refused(name, "This is no model.\x1b[31m\n", f"{name}")
    def with_first(number):
        return Model([(number, 0, 0), *model.positions[1:]], model.faces)
    for number in (float("nan"), float("inf"), 1e31):
        refused("far.ply", ply(with_first(number), "<"), "far.ply: row 1 of vertex: expected a finite number of at most 1e+30 for x, found ")
    refused("far.stl", stl(with_first(-1e31), binary=True), "far.stl: expected coordinates within 1e30 of 0 in triangle 3, found others")
    refused("bare.ply", ply(Model(model.positions, [])), "bare.ply: ")
    refused("beyond.off", "OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 77\n", "beyond.off:6: expected one of the 3 vertices, a whole number from 0 to 2, found '77'")
    refused("beyond.ply", ply(Model(model.positions, [(0, 1, 8)])), "beyond.ply:18: expected the number of a vertex, a whole number from 0 to 7, found '8'")
    material = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
    place = "a.gltf: texture 'gone.png' of material "
    refused("a.gltf", gltf(model, material=material, image="gone.png"), place,
            "expected a PNG or JPEG file of that name beside the model, found none")
    refused("a.glb", glb(model, material=material, image=b"no picture"), "expected a PNG or JPEG file, found something else")


def test_gltf_that_goes_round():
    """Nodes that are no trees, counts of what is not there, and JSON that is none."""
    root, buffer = gltf_parts(box().cut())
    def changed(**keys):
        return json.dumps(root | {"buffers": [{"byteLength": len(buffer), "uri": data_uri(buffer)}]} | keys, indent=1)
    shared = [{"children": [i + 1, i + 1]} for i in range(60)] + [{"mesh": 0}]
    refused("a.gltf", changed(nodes=shared), "a.gltf:", ": expected nodes with one parent each, found another one of node 1")
    refused("a.gltf", changed(nodes=[{"children": [1]}, {"children": [0]}]), "expected nodes in trees, found some that are their own ancestors")
    refused("a.gltf", changed(nodes=[{"children": [0]}]), "expected nodes in trees")
    refused("a.gltf", changed(nodes=[{"children": [7]}]), "expected a node from 0 to 0, found 7")
    refused("a.gltf", changed(scenes=[{"nodes": [0, 0]}]), "expected each node once, found node 0 again")
    refused("a.gltf", changed(accessors=[root["accessors"][0] | {"count": 4_000_000_000}]), "expected a whole number up to ")
    refused("a.gltf", changed(nodes={"n": {}}), "expected a list of nodes, as in glTF 2.0, found an object")
    refused("a.gltf", '{"asset":\n{"version": "2.0",}\n}', "a.gltf:2: expected ")
    write("a.gltf", changed(nodes=[{"mesh": 0}] * 3, scenes=[{"nodes": [0, 1, 2]}]))
    equal(gradus("render", "a.gltf", *SMALL, "-o", "a.png").code, 0, "a mesh may be shown several times")


def test_gltf_data_that_are_not_there():
    """Indices, buffers, views, accessors and pictures: what the importer would leave out or make up."""
    root, buffer = gltf_parts(box().cut())
    indices = struct.pack("<3H", 0, 1, 77)
    def changed(more=b"", **keys):
        data = buffer + more
        return json.dumps(root | {"buffers": [{"byteLength": len(data), "uri": data_uri(data)}]} | keys, indent=1)
    views = root["bufferViews"] + [{"buffer": 0, "byteOffset": len(buffer), "byteLength": 6}]
    accessors = root["accessors"] + [{"bufferView": len(views) - 1, "componentType": 5123, "count": 3, "type": "SCALAR"}]
    attributes = root["meshes"][0]["primitives"][0]["attributes"]
    faces = [{"primitives": [{"attributes": attributes, "indices": len(accessors) - 1}]}]
    indexed = {"bufferViews": views, "accessors": accessors, "meshes": faces}
    refused("a.gltf", changed(indices, **indexed), "a.gltf:", ": expected indices of the 36 vertices, from 0, found 77 at index 2")
    write("b.bin", buffer + indices)
    beside = [{"byteLength": len(buffer) + 6, "uri": "b.bin"}]
    refused("a.gltf", changed(**indexed, buffers=beside), "expected indices of the 36 vertices, from 0, found 77 at index 2")
    refused("a.glb", glb_of(root | indexed, buffer + indices), "a.glb:1: expected indices of the 36 vertices, from 0, found 77 at index 2")
    write("a.gltf", changed(struct.pack("<3H", 0, 1, 2), **indexed))
    equal(gradus("render", "a.gltf", *SMALL, "-o", "a.png").code, 0, "indices that are there")
    refused("a.gltf", changed(indices[:4], **indexed), "expected a view within the 724 bytes of its buffer, found one that ends at 726")
    refused("a.gltf", changed(accessors=[root["accessors"][0] | {"count": 37}, *root["accessors"][1:]]),
            "expected an accessor within the 432 bytes of its bufferView, found one that ends at 444")
    for uri, what in (("data:application/octet-stream;base64,", "expected a buffer of 720 bytes, found one of 0"),
                      ("data:application/octet-stream;base64,####", "expected data in Base64, found others")):
        refused("a.gltf", changed(buffers=[{"byteLength": len(buffer), "uri": uri}]), what)
    refused("a.gltf", changed(meshes=[{"primitives": [{"attributes": {"POSITION": 7}}]}]), "expected one of the 2 accessors, from 0, found 7")
    material = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
    refused("a.gltf", gltf(box().cut(), material=material, image="data:image/png;base64,"), "a.gltf:", "expected a picture, found empty data")
    refused("a.gltf", changed(extensionsUsed=["KHR_draco_mesh_compression"], extensionsRequired=["KHR_draco_mesh_compression"]),
            "expected a file whose data need no extension, found 'KHR_draco_mesh_compression'")


def test_gltf_data_that_are_something_else():
    """Numbers of another kind than they are used for, which the importer would take for others without a word."""
    root, buffer = gltf_parts(box().cut())
    def changed(**keys):
        return json.dumps(root | {"buffers": [{"byteLength": len(buffer), "uri": data_uri(buffer)}]} | keys)
    places, uvs = root["accessors"]
    def accessors(**keys):
        return {"accessors": [places | keys, uvs]}
    view = root["bufferViews"][0]
    for said, keys in (
            ("a byteStride of at least 12, the bytes of an element, found 1", {"bufferViews": [view | {"byteStride": 1}, *root["bufferViews"][1:]]}),
            ("an accessor within the 432 bytes of its bufferView, found one that ends at 444",
             {"bufferViews": [view | {"byteStride": 0}, *root["bufferViews"][1:]], **accessors(count=37)}),
            ("three floats for POSITION (VEC3 of 5126), found others", accessors(componentType=5121)),
            ("three floats for POSITION (VEC3 of 5126), found others", accessors(type="VEC2")),
            ("two numbers for TEXCOORD_0 (VEC2), found others",
             {"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 0}}]}]}),
            ("a whole number up to 6, found 'x'", {"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": "x"}]}]}),
            ("16 numbers in a matrix, found 15", {"nodes": [{"mesh": 0, "matrix": [1] * 15}]}),
            ("numbers in a matrix, found 'a'", {"nodes": [{"mesh": 0, "matrix": ["a"] * 16}]}),
            ("4 numbers in a rotation, found 3", {"nodes": [{"mesh": 0, "rotation": [0, 0, 1]}]})):
        refused("a.gltf", changed(**keys), f"a.gltf:1: expected {said}")


def test_what_others_name_is_not_quoted():
    """A scene may name any file: what is wrong with one elsewhere is told without a word of it."""
    os.mkdir("here")
    write("secret.ply", "topsecret:x:0:0\n")
    write("secret.gltf", '{"topsecret": x}')
    os.chdir("here")
    for name in ("secret.ply", "secret.gltf"):
        write("s.json", json.dumps({"objects": [{"model": f"../{name}"}]}))
        result = gradus("render", "s.json", "-o", "s.png")
        check(result.code == 2 and f"{name}: expected a" in result.err and "topsecret" not in result.err and result.err.count("\n") == 1,
              f"{name}: {result.err}")


def test_foreign_files_that_models_name_are_not_quoted():
    """A glTF file may name buffers anywhere, as an OBJ file its libraries; no number of what lies elsewhere is told."""
    root, buffer = gltf_parts(box().cut())
    index, far = 0x7365, struct.pack("<f", 7e37)  # "es", and what no position may be
    foreign = {"index.bin": buffer + struct.pack("<3H", 0, 1, index), "far.bin": far + buffer[4:] + bytes(6), "short.bin": buffer[:-5]}
    views = root["bufferViews"] + [{"buffer": 0, "byteOffset": len(buffer), "byteLength": 6}]
    accessors = root["accessors"] + [{"bufferView": len(views) - 1, "componentType": 5123, "count": 3, "type": "SCALAR"}]
    faces = [{"primitives": [{"attributes": root["meshes"][0]["primitives"][0]["attributes"], "indices": len(accessors) - 1}]}]
    indexed = {"bufferViews": views, "accessors": accessors, "meshes": faces}
    said = {"index.bin": ("expected indices of the 36 vertices, from 0, found", f" {index} at index 2", " another at index 2"),
            "far.bin": ("expected", " 7.00", " something else"),
            "short.bin": (f"expected a buffer of {len(buffer) + 6} bytes, found", f" one of {len(buffer) - 5}", " a shorter file")}
    os.mkdir("here")
    for name, data in foreign.items():
        write(name, data)
        write(f"here/{name}", data)
    os.symlink("../index.bin", "here/linked.bin")
    os.chdir("here")
    for name, (expected, own, other) in said.items():
        linked = ["linked.bin"] if name == "index.bin" else []
        for uri, found in ((name, own), (f"../{name}", other), (f"..%2f{name}", other), (os.path.abspath(f"../{name}"), other),
                           *((link, other) for link in linked)):
            write("a.gltf", json.dumps(root | indexed | {"buffers": [{"byteLength": len(buffer) + 6, "uri": uri}]}, indent=1))
            result = gradus("render", "a.gltf", *SMALL, "-o", "a.png")
            check(result.code == 2 and f"{expected}" in result.err and f"{found}" in result.err and result.err.count("\n") == 1,
                  f"{uri}: {result.err}")
            check(found == own or own not in result.err, f"{uri} is quoted: {result.err}")
    # One that is right is read from there
    write("../right.bin", buffer)
    write("a.gltf", json.dumps(root | {"buffers": [{"byteLength": len(buffer), "uri": "../right.bin"}]}))
    equal(gradus("render", "a.gltf", *SMALL, "-o", "a.png").code, 0, "a buffer in another folder")


def test_mutations():
    """Files with a few wrong bytes: a picture or a refusal, never a crash."""
    draw, model = random.Random(SEED), house().cut()
    files = {"b.ply": ply(house(), "<"), "b.stl": stl(model, True), "m.glb": glb(model), "m.gltf": gltf(model)}
    taken = crashed = 0
    for n in range(MUTATIONS):
        name = draw.choice(sorted(files))
        data = bytearray(files[name])
        for _ in range(draw.randint(1, 4)):
            at = draw.randrange(len(data))
            how = draw.random()
            if how < 0.6:
                data[at] = draw.choice([0, 1, 0x7f, 0x80, 0xff, draw.randrange(256), ord(draw.choice("0123456789-e.,:[]{} "))])
            elif how < 0.8:
                del data[at:at + draw.choice([1, 4, 40])]
            else:
                data[at:at] = struct.pack("<i", draw.choice([0, -1, 1, 2**31 - 1, 2**30]))
        write(name, bytes(data))
        result = gradus("render", name, "--size", "16x12", "-o", "m.png", timeout=600)
        taken += result.code == 0
        fits = result.code == 0 or result.code == 2 and result.err.startswith("gradus: ") and result.err.count("\n") == 1
        check(fits, f"mutation {n} of {name}, seed {SEED}: {result.code} {result.err}")
        crashed += "crashed" in result.err
    print(f"{taken} of {MUTATIONS} mutated models were rendered, Assimp crashed over {crashed}")


sys.exit(command.run_all(globals()))
