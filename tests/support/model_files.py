"""One small model in many formats: what tests of imported models write, without any library.

A model is a Model of positions, triangles or larger faces of them, and texture coordinates per corner (v up, as in OBJ).
"""
import base64
import dataclasses
import json
import struct


@dataclasses.dataclass
class Model:
    positions: list
    faces: list                                   # of position numbers, counter-clockwise from outside
    uvs: list = dataclasses.field(default_factory=list)  # of each face, a pair per corner

    def triangles(self):
        return [(face[0], b, c) for face in self.faces for b, c in zip(face[1:], face[2:])]

    def triangle_uvs(self):
        return [(uv[0], b, c) for uv in self.uvs for b, c in zip(uv[1:], uv[2:])]

    def cut(self):
        """The same of triangles alone."""
        return Model(self.positions, self.triangles(), self.triangle_uvs())

    def moved(self, place):
        """By a function of a position; mirrored: a face keeps its outside."""
        return Model([place(p) for p in self.positions], self.faces, self.uvs)

    def turned_round(self):
        return Model(self.positions, [face[:1] + face[:0:-1] for face in map(tuple, self.faces)],
                     [uv[:1] + uv[:0:-1] for uv in map(tuple, self.uvs)])

    def and_also(self, other):
        shift = len(self.positions)
        return Model(self.positions + other.positions, self.faces + [tuple(i + shift for i in f) for f in other.faces],
                     self.uvs + other.uvs)


def box(x=1, y=1, z=1):
    """A box from the origin on; each side is covered once by the texture."""
    corners = [(i * x, j * y, k * z) for k in (0, 1) for j in (0, 1) for i in (0, 1)]
    faces = [(4, 5, 7, 6), (1, 0, 2, 3), (5, 1, 3, 7), (0, 4, 6, 2), (6, 7, 3, 2), (0, 1, 5, 4)]
    return Model(corners, faces, [((0, 0), (1, 0), (1, 1), (0, 1))] * 6)


def house():
    """A box with a roof, smooth where a format says nothing of normals."""
    walls = box(2, 1, 1)
    ridge = [(0, 1.75, 0.5), (2, 1.75, 0.5)]
    roof = [(6, 7, 9, 8), (3, 2, 8, 9), (2, 6, 8), (7, 3, 9)]
    return Model(walls.positions + ridge, [f for f in walls.faces if f != (6, 7, 3, 2)] + roof)


def numbers(values):
    return " ".join(f"{v:.9g}" for v in values)


def obj(model, head="", smooth=False):
    lines = [head] if head else []
    lines += [f"v {numbers(p)}" for p in model.positions]
    lines += [f"vt {numbers(uv)}" for face in model.uvs for uv in face]
    if not smooth:
        lines.append("s off")
    at = 1
    for face in model.faces:
        corners = [f"{i + 1}/{at + n}" if model.uvs else f"{i + 1}" for n, i in enumerate(face)]
        at += len(face)
        lines.append("f " + " ".join(corners))
    return "\n".join(lines) + "\n"


def ply(model, binary=None):
    """binary: "<" or ">"; text without."""
    kind = {None: "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}[binary]
    head = (f"ply\nformat {kind} 1.0\nelement vertex {len(model.positions)}\nproperty float x\nproperty float y\n"
            f"property float z\nelement face {len(model.faces)}\nproperty list uchar int vertex_indices\nend_header\n").encode()
    if binary is None:
        rows = [numbers(p) for p in model.positions] + [f"{len(f)} {numbers(f)}" for f in model.faces]
        return head + ("\n".join(rows) + "\n").encode()
    return (head + b"".join(struct.pack(binary + "3f", *p) for p in model.positions)
            + b"".join(struct.pack(f"{binary}B{len(f)}i", len(f), *f) for f in model.faces))


def stl(model, binary=False):
    """Without normals, which are to be made of the corners."""
    triangles = [[model.positions[i] for i in t] for t in model.triangles()]
    if binary:
        return (b"gradus".ljust(80) + struct.pack("<I", len(triangles))
                + b"".join(struct.pack("<12fH", 0, 0, 0, *t[0], *t[1], *t[2], 0) for t in triangles))
    text = "solid model\n"
    for t in triangles:
        corners = "".join(f"      vertex {numbers(p)}\n" for p in t)
        text += f"  facet normal 0 0 0\n    outer loop\n{corners}    endloop\n  endfacet\n"
    return (text + "endsolid model\n").encode()


def data_uri(data, kind="application/octet-stream"):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


def gltf_parts(model, nodes=None, material=None, image=None):
    """The JSON of a glTF file without its buffer's place, and the buffer.

    nodes: instead of one node that shows mesh 0. material, image: as glTF has them; an image of bytes stands in the buffer.
    """
    flat = model.triangles()
    places = b"".join(struct.pack("<3f", *model.positions[i]) for t in flat for i in t)
    # Its texture coordinates begin at the upper edge
    uvs = b"".join(struct.pack("<2f", u, 1 - v) for t in model.triangle_uvs() for u, v in t)
    count = 3 * len(flat)
    columns = list(zip(*model.positions))
    views = [{"buffer": 0, "byteOffset": 0, "byteLength": len(places)}]
    accessors = [{"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3",
                  "min": [min(c) for c in columns], "max": [max(c) for c in columns]}]
    primitive = {"attributes": {"POSITION": 0}}
    if uvs:
        views.append({"buffer": 0, "byteOffset": len(places), "byteLength": len(uvs)})
        accessors.append({"bufferView": 1, "componentType": 5126, "count": count, "type": "VEC2"})
        primitive["attributes"]["TEXCOORD_0"] = 1
    root = {"asset": {"version": "2.0"}, "scene": 0, "nodes": nodes or [{"mesh": 0}]}
    children = {c for node in root["nodes"] for c in node.get("children", ())}
    root["scenes"] = [{"nodes": [i for i in range(len(root["nodes"])) if i not in children]}]
    buffer = places + uvs
    if material:
        root["materials"], primitive["material"] = [material], 0
    if isinstance(image, bytes):
        kind = "image/jpeg" if image.startswith(b"\xff\xd8") else "image/png"
        views.append({"buffer": 0, "byteOffset": len(buffer), "byteLength": len(image)})
        root["images"] = [{"bufferView": len(views) - 1, "mimeType": kind}]
        buffer += image
    elif image:
        root["images"] = [{"uri": image}]
    if image:
        root["textures"] = [{"source": 0}]
    root |= {"meshes": [{"primitives": [primitive]}], "accessors": accessors, "bufferViews": views}
    return root, buffer


def gltf(model, uri=None, **more):
    """uri: the name of a file that will hold the buffer; without it the buffer stands inside."""
    root, buffer = gltf_parts(model, **more)
    root["buffers"] = [{"byteLength": len(buffer), "uri": uri or data_uri(buffer)}]
    return json.dumps(root, indent=1).encode()


def glb_of(root, buffer):
    root["buffers"] = [{"byteLength": len(buffer)}]
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    buffer += b"\0" * (-len(buffer) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def glb(model, **more):
    return glb_of(*gltf_parts(model, **more))
