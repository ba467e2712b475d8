"""Renders for the tests of `gradus render`: the models, and pictures that are read and compared."""
import functools
import pathlib
import struct
import zlib

import command
from command import equal

gradus = functools.partial(command.gradus, timeout=120)
ROOT = pathlib.Path(__file__).resolve().parents[2]
MODELS, OTHERS = ROOT / "examples/models", ROOT / "tests/support/models"
SPOT, LETTER = str(MODELS / "spot.obj"), str(MODELS / "letter_f.obj")

# A pixel differs when one of its channels is off by more than LEVELS of 255; SHARE of the pixels may.
# Rounding may move a rim by a pixel and a shade by a level; anything that is wrong moves more.
LEVELS, SHARE = 2, 0.002


def read(path):
    return pathlib.Path(path).read_bytes()


def write(path, text):
    pathlib.Path(path).write_bytes(text if isinstance(text, bytes) else text.encode())


def png(texts):
    """One white pixel that carries these texts."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0))
            + b"".join(chunk(b"iTXt", k.encode() + b"\0\0\0\0\0" + v.encode()) for k, v in texts.items())
            + chunk(b"IDAT", zlib.compress(b"\0\xff\xff\xff")) + chunk(b"IEND", b""))


def fewer_frames(line):
    """An example that makes many frames, asked for a few small ones."""
    if "{frame}" not in line and ".mp4" not in line:
        return line
    line = line.replace("--frames 0-124", "--frames 0-124/62").replace("--size 320x180", "--size 32x18")
    return line if "--frames" in line else line + " --frames 63-66"


class Picture:
    """An 8-bit RGB or RGBA picture without filters, as gradus writes them: pixels[y][x], and its texts."""

    def __init__(self, data):
        assert data.startswith(b"\x89PNG\r\n\x1a\n"), data[:8]
        at, packed, self.texts = 8, b"", {}
        while at < len(data):
            length, kind = struct.unpack(">I4s", data[at:at + 8])
            body = data[at + 8:at + 8 + length]
            if kind == b"IHDR":
                self.width, self.height, depth, self.kind = struct.unpack(">IIBB", body[:10])
                assert depth == 8 and self.kind in (2, 6), (depth, self.kind)
            elif kind == b"IDAT":
                packed += body
            elif kind == b"iTXt":
                key, rest = body.split(b"\0", 1)
                self.texts[key.decode()] = rest[2:].split(b"\0", 2)[2].decode()
            at += length + 12
        size, raw = (3 if self.kind == 2 else 4), zlib.decompress(packed)
        stride = size * self.width + 1
        self.pixels = []
        for y in range(self.height):
            row = raw[y * stride:(y + 1) * stride]
            assert row[0] == 0, "a filter"
            self.pixels.append([tuple(row[1 + size * x:1 + size * (x + 1)]) for x in range(self.width)])

    def mirrored(self):
        other = Picture.__new__(Picture)
        other.width, other.height, other.pixels = self.width, self.height, [row[::-1] for row in self.pixels]
        return other

    def where(self, shows):
        """left, top, right, bottom of the pixels of that kind, all inclusive."""
        places = [(x, y) for y, row in enumerate(self.pixels) for x, p in enumerate(row) if shows(p)]
        return places and (min(x for x, _ in places), min(y for _, y in places),
                           max(x for x, _ in places), max(y for _, y in places))


def differing(a, b):
    """The share of pixels that differ by more than LEVELS in a channel."""
    if (a.width, a.height) != (b.width, b.height):
        return 1
    pairs = ((p, q) for r, s in zip(a.pixels, b.pixels) for p, q in zip(r, s))
    return sum(max(abs(c - d) for c, d in zip(p, q)) > LEVELS for p, q in pairs) / (a.width * a.height)


def picture(*words):
    """What `gradus render … -o -` shows."""
    result = gradus("render", *words, "-o", "-")
    if not equal(result.code, 0, f"render {' '.join(words)}: {result.err}"):
        raise RuntimeError(result.err)
    return Picture(result.bytes)
