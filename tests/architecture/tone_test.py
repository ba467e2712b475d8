#!/usr/bin/env python3
"""Light becomes a tone in one place, visualize/figure/tone_of.hpp: no drawing has a scale of its own.

A drawing that writes 255 times a share of light shows half the light as 0.216 of it."""
import pathlib
import re
import unittest

VISUALIZE = pathlib.Path(__file__).parents[2] / "visualize"
ONE_PLACE = VISUALIZE / "figure" / "tone_of.hpp"
# 255 * light, light * 255, light * 255.0; and the conversion under its own name
OWN_SCALE = re.compile(r"\b255(?:\.0?f?)?\s*\*(?!/)|\*\s*255(?:\.0?f?)?\b|\bsrgb8_from_linear\b|\bsrgb_of\(")
# Whole channels or whole numbers, no light: channel / 255 * 255
NO_LIGHT = {"stories/visibility/z_buffer_story.cpp"}


def offenders(text):
    code = re.sub(r"//.*", "", text)
    return [match.group(0) for match in OWN_SCALE.finditer(code)]


class Tones(unittest.TestCase):
    def test_light_becomes_a_tone_in_one_place(self):
        files = [path for end in ("hpp", "cpp", "js") for path in VISUALIZE.rglob(f"*.{end}")]
        self.assertGreater(len(files), 300)
        for path in files:
            name = path.relative_to(VISUALIZE).as_posix()
            if path == ONE_PLACE or name in NO_LIGHT:
                continue
            with self.subTest(name):
                self.assertEqual(offenders(path.read_text(encoding="utf-8")), [])

    def test_the_old_forms_are_seen(self):
        for code in ("std::lround(255 * value)", "std::clamp(255 * brightness + 0.5, 0.0, 255.0)",
                     "Math.round(light * 255)", "srgb8_from_linear(LinearRgb(sum))"):
            self.assertTrue(offenders(code), code)
        for code in ("// 255 * area", "Rgba8{255, 255, 255, 255}", "fmt(255)"):
            self.assertFalse(offenders(code), code)


if __name__ == "__main__":
    unittest.main()
