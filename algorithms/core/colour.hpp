#pragma once
// Between linear light, in which algorithms compute, and the 8-bit sRGB of image files.

#include <cstdint>

#include "core/image.hpp"
#include "core/surface.hpp"

namespace gradus {

/// The light that an 8-bit sRGB value stands for, in [0, 1].
/// Source: IEC 61966-2-1 (sRGB). Accuracy: the nearest float. Cost: a table.
float linear_from_srgb8(std::uint8_t value);

/// The 8-bit sRGB value nearest to this light, of the sRGB scale; beyond [0, 1] the nearer end, NaN gives 0.
/// Source: IEC 61966-2-1 (sRGB). Accuracy: the nearest value; srgb8_from_linear(linear_from_srgb8(v)) is v.
/// Cost: eight comparisons.
std::uint8_t srgb8_from_linear(float light);

/// An opaque pixel of this colour.
Rgba8 srgb8_from_linear(LinearRgb light);

/// The colour of a pixel, its alpha not looked at.
LinearRgb linear_from_srgb8(Rgba8 pixel);

}  // namespace gradus
