#pragma once
// The one place where light becomes a tone.
//
// Light is what adds up: coverage, areas, intensities and means are light, from 0 (none) to 1 (all that the
// screen has). A tone is what a screen is told, from 0 to 255 on the scale of sRGB, whose steps look alike to
// the eye and are not equal steps of light: half the light is tone 188, and tone 128 has 0.216 of it.

#include <cmath>

#include "core/colour.hpp"
#include "core/geometry.hpp"

namespace gradus {

/// The tone of red, green and blue light; beyond [0, 1] the nearer end.
inline Rgba8 tone_of(const dvec3& light) { return srgb8_from_linear(LinearRgb(light)); }
/// The grey of so much light.
inline Rgba8 tone_of(double light) { return tone_of(dvec3(light)); }
/// A tone in so much of its pixel; the rest lets through what lies below.
inline Rgba8 in_share(Rgba8 tone, double share) {
  tone.a = static_cast<std::uint8_t>(std::lround(255 * share));
  return tone;
}
/// What is seen where an ink of this colour has a share of a pixel of white paper.
inline Rgba8 tone_on_paper(const Rgba8& ink, double share) {
  return tone_of(share * dvec3(linear_from_srgb8(ink)) + (1 - share));
}

}  // namespace gradus
