#!/usr/bin/env python3
"""Writes visualize/figure/text/font_metrics.inc: the advance widths of the characters that figures use.

The layout needs the width of a text without asking a font library (it also runs where there is none).
    tests/support/font_metrics.py [--check] FONT_FOLDER
--check compares with the committed file and exits 1 when they differ.
"""
import pathlib
import struct
import sys

RANGES = [
    (0x20, 0x7E), (0xA0, 0x24F),     # Latin
    (0x2B0, 0x2FF),                  # modifier letters
    (0x370, 0x3FF),                  # Greek
    (0x400, 0x482), (0x48A, 0x52F),  # Cyrillic, without combining marks
    (0x1E00, 0x1EFF),                # Latin with more marks: ẋ, ṗ
    (0x2010, 0x2027), (0x2030, 0x205E),
    (0x2070, 0x209C),                # superscripts and subscripts
    (0x20A0, 0x20BF),                # currencies
    (0x2100, 0x218F),                # letterlike symbols and fractions: ℝ, ℓ, ⅓
    (0x2190, 0x21FF),                # arrows
    (0x2200, 0x22FF),                # operators
    (0x2300, 0x23CF),                # ⌈, ⌋
    (0x25A0, 0x25FF), (0x2713, 0x2718),
    (0x27C0, 0x27FF), (0x2A00, 0x2AFF),  # brackets, long arrows, more operators
]
# By Face: the font; the one that it borrows letters from, and which; the one that stands in for letters that these
# lack. Raised and lowered letters need no typewriter's room; Inter's bold space is so narrow that words run together.
RAISED = [0xB2, 0xB3, 0xB9, *range(0x2070, 0x209D)]
SPACES = [0x20, 0xA0]
INTER, JETBRAINS, DEJAVU = "opentype/inter/", "truetype/jetbrains-mono/", "truetype/dejavu/"
FACES = [(INTER + "Inter-Regular.otf", INTER + "Inter-Regular.otf", [], DEJAVU + "DejaVuSans.ttf"),
         (INTER + "Inter-Bold.otf", INTER + "Inter-Regular.otf", SPACES, DEJAVU + "DejaVuSans-Bold.ttf"),
         (INTER + "Inter-Italic.otf", INTER + "Inter-Italic.otf", [], DEJAVU + "DejaVuSans-Oblique.ttf"),
         (JETBRAINS + "JetBrainsMono-Regular.ttf", INTER + "Inter-Regular.otf", RAISED, DEJAVU + "DejaVuSansMono.ttf"),
         (JETBRAINS + "JetBrainsMono-Bold.ttf", INTER + "Inter-Bold.otf", RAISED, DEJAVU + "DejaVuSansMono.ttf"),
         (INTER + "Inter-BoldItalic.otf", INTER + "Inter-Italic.otf", SPACES, DEJAVU + "DejaVuSans-Bold.ttf")]
UNITS = 2048  # an em
TARGET = pathlib.Path(__file__).resolve().parents[2] / "visualize/figure/text/font_metrics.inc"


def tables(data):
    count = struct.unpack(">H", data[4:6])[0]
    found = {}
    for i in range(count):
        tag, _, offset, length = struct.unpack(">4sIII", data[12 + 16 * i:28 + 16 * i])
        found[tag.decode()] = data[offset:offset + length]
    return found


def glyph_index(cmap):
    """Character -> glyph, from the format 4 (basic plane) subtable."""
    for i in range(struct.unpack(">H", cmap[2:4])[0]):
        platform, encoding, offset = struct.unpack(">HHI", cmap[4 + 8 * i:12 + 8 * i])
        if struct.unpack(">H", cmap[offset:offset + 2])[0] == 4 and (platform, encoding) in ((3, 1), (0, 3)):
            break
    else:
        raise SystemExit("no format 4 cmap")
    sub = cmap[offset:]
    segments = struct.unpack(">H", sub[6:8])[0] // 2

    def words(at):
        return struct.unpack(f">{segments}H", sub[at:at + 2 * segments])

    ends, starts = words(14), words(16 + 2 * segments)
    deltas, offsets = words(16 + 4 * segments), words(16 + 6 * segments)
    mapping = {}
    for k in range(segments):
        for char in range(starts[k], ends[k] + 1):
            if offsets[k] == 0:
                glyph = (char + deltas[k]) & 0xFFFF
            else:
                at = 16 + 6 * segments + 2 * k + offsets[k] + 2 * (char - starts[k])
                glyph = struct.unpack(">H", sub[at:at + 2])[0]
                glyph = (glyph + deltas[k]) & 0xFFFF if glyph else 0
            if glyph:
                mapping[char] = glyph
    return mapping


def widths(path):
    """Character -> advance in UNITS an em."""
    found = tables(path.read_bytes())
    units = struct.unpack(">H", found["head"][18:20])[0]
    metrics = struct.unpack(">H", found["hhea"][34:36])[0]
    index = glyph_index(found["cmap"])

    def width(char):
        at = 4 * min(index[char], metrics - 1)
        return round(UNITS * struct.unpack(">H", found["hmtx"][at:at + 2])[0] / units)

    return {char: width(char) for low, high in RANGES for char in range(low, high + 1) if char in index}


def face_widths(folder, font, lender, borrowed, stand_in):
    """Of all three; a letter that stands in for one of a typewriter's takes the room of one."""
    own, lent, others = widths(folder / font), widths(folder / lender), widths(folder / stand_in)
    if len({width for width in own.values() if width}) == 1:
        others = dict.fromkeys(others, own[0x20])
    return others | own | {char: lent[char] for char in borrowed if char in lent}


def main():
    arguments = [a for a in sys.argv[1:] if a != "--check"]
    folder = pathlib.Path(arguments[0] if arguments else "/usr/share/fonts")
    faces = [face_widths(folder, *fonts) for fonts in FACES]
    lines = ["// Made by tests/support/font_metrics.py: advance widths in 1/2048 em of sans, bold, italic, mono,",
             "// mono bold and bold italic; 0 where the face lacks the character."]
    for char in sorted(set().union(*faces)):
        row = ", ".join(str(face.get(char, 0)) for face in faces)
        lines.append(f"{{0x{char:04X}, {{{row}}}}},")
    text = "\n".join(lines) + "\n"
    if "--check" in sys.argv:
        sys.exit(0 if TARGET.read_text() == text else "font_metrics.inc does not match the installed fonts")
    TARGET.write_text(text)


main()
