#!/usr/bin/env python3
"""JPEG files as textures and as pictures: ffmpeg's pixels, within what two decoders may differ by.

    tests/golden/jpeg_test.py [GRADUS]
"""
import json
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal
from renders import Picture, gradus, read, write

WIDTH, HEIGHT = 64, 48
EXACTLY = "accurate_rnd+full_chroma_int+full_chroma_inp+bitexact"


def ffmpeg(*words):
    subprocess.run(["ffmpeg", "-v", "error", "-y", *words], check=True, stdin=subprocess.DEVNULL)


def jpeg(name, source, *how):
    """A picture of ffmpeg's, and the same decoded by it."""
    ffmpeg("-f", "lavfi", "-i", f"{source}{':' if '=' in source else '='}size={WIDTH}x{HEIGHT}:rate=1", "-frames:v", "1", "-q:v", "2", *how, name)
    ffmpeg("-i", name, "-pix_fmt", "rgb24", "-sws_flags", EXACTLY, "decoded.png")


def texels(texture):
    """The picture on a square that fills the frame, by light that shows its colours as they are."""
    write("m.mtl", f"newmtl m\nKd 0 0 0\nKa 1 1 1\nmap_Kd {texture}\n")
    write("m.obj", "mtllib m.mtl\nusemtl m\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
    write("s.json", json.dumps({
        "size": [WIDTH, HEIGHT], "ambient": [1, 1, 1], "lights": [], "filter": "nearest", "aa": "none",
        "camera": {"projection": "orthographic", "eye": [2, 1.5, 5], "target": [2, 1.5, 0], "height": 3},
        "objects": [{"model": "m.obj"}]}))
    result = gradus("render", "s.json", "-o", "-")
    equal((result.code, result.err), (0, ""), f"rendered with {texture}")
    return Picture(result.bytes).pixels


def differences(a, b):
    return [max(abs(x - y) for x, y in zip(p, q)) for r, s in zip(a, b) for p, q in zip(r, s)]


def test_texels_are_ffmpegs():
    for source, how, most, mean in (("testsrc", ["-pix_fmt", "yuvj444p"], 2, 0.7), ("smptebars", ["-pix_fmt", "yuvj444p"], 2, 0.7),
                                    ("gradients=seed=3:nb_colors=3:x0=0:y0=0:x1=63:y1=47", ["-pix_fmt", "yuvj420p"], 8, 1.5)):
        jpeg("t.jpg", source, *how)
        decoded = texels("decoded.png")
        apart = differences(texels("t.jpg"), decoded)
        print(f"{source} {how[1]}: at most {max(apart)}, {sum(apart) / len(apart):.2f} in the mean")
        check(max(apart) <= most and sum(apart) / len(apart) <= mean, f"{source} {how}: {max(apart)}, {sum(apart) / len(apart)}")
        check(len({p for row in decoded for p in row}) > 7, "there is something to compare")


def test_as_phones_write_them():
    """Without its end, and with bytes too many before a marker: the same picture, as browsers draw it."""
    jpeg("whole.jpg", "testsrc", "-pix_fmt", "yuvj444p")
    whole, table = read("whole.jpg"), read("whole.jpg").index(b"\xff\xdb")
    expected = texels("whole.jpg")
    check(whole.endswith(b"\xff\xd9"), "it had an end")
    for name, data in {"no_end.jpg": whole[:-2], "extra.jpg": whole[:table] + b"\0\1\2" + whole[table:],
                       "padded.jpg": whole[:-2] + b"\0" * 16 + whole[-2:]}.items():
        write(name, data)
        check(texels(name) == expected, f"{name} is whole.jpg")


def test_a_picture_to_fill():
    jpeg("t.jpg", "smptebars", "-pix_fmt", "yuvj444p")
    fill = ["run", "flood_fill", "--at", "1,1", "--tolerance", "8", "--json", "--image"]
    result = gradus(*fill, "t.jpg")
    equal(result.code, 0, result.err)
    check(len(result.bytes) > 1000, "it is told")


def test_broken_files():
    jpeg("whole.jpg", "testsrc", "-pix_fmt", "yuvj444p")
    whole = read("whole.jpg")
    write("m.mtl", "newmtl m\nmap_Kd t.jpg\n")
    write("m.obj", "mtllib m.mtl\nusemtl m\nv 0 0 0\nv 4 0 0\nv 4 3 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n")
    start = whole.index(b"\xff\xc0") + 5
    large = whole[:start] + b"\xff\xdc\xff\xdc" + whole[start + 4:]
    for data, message in ((whole[:-300], "expected a whole JPEG file, found a damaged one (Premature end of JPEG file)"),
                          (whole[:30], "expected a whole JPEG file, found a damaged one ("),
                          (b"\xff\xd8\xff", "expected a whole JPEG file, found a damaged one ("),
                          (large, "expected at most 33554432 pixels, found 65500 x 65500"),
                          (b"GIF89a", "expected a PNG or JPEG file, found something else")):
        write("t.jpg", data)
        result = gradus("render", "m.obj", "-o", "m.png")
        check(result.code == 2 and result.err.startswith(f"gradus: m.mtl:2: map_Kd 't.jpg': {message}") and result.err.count("\n") == 1,
              f"{message}: {result.err}")
        check(not os.path.exists("m.png"), "nothing is written")


sys.exit(command.run_all(globals()))
