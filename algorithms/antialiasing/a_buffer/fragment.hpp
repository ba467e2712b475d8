#pragma once
// What the A-buffer keeps of a polygon in a pixel: a mask of 32 sub-samples, and depths.

#include <bit>
#include <cstdint>

#include "core/language.hpp"

namespace gradus::a_buffer {

/// 32 sub-samples of a pixel, 4 rows of 8, in reading order from the highest bit on: in hexadecimal two
/// digits are a row, the topmost one first. The left half of a pixel is f0f0f0f0.
using Mask = std::uint32_t;
inline constexpr int mask_columns = 8, mask_rows = 4, samples = mask_columns * mask_rows;
inline constexpr Mask full = 0xffffffff;

/// The bit of a sub-sample, counted in reading order from 0 on.
constexpr Mask bit_of(int sample) { return Mask{1} << (samples - 1 - sample); }

/// The last sub-sample of a mask that has one.
constexpr int last_of(Mask mask) { return samples - 1 - std::countr_zero(mask); }

/// What a pixel's list holds of one polygon.
struct Fragment {
  Mask mask = 0;
  double z_near = 0, z_far = 0;  ///< its depths over the sub-samples; smaller is nearer
  double opacity = 1;            ///< from 0 to 1, which lets nothing through
  int surface = 0;               ///< fragments of one surface may be merged
  int source = 0;                ///< whose it is: the caller's number

  friend constexpr bool operator==(const Fragment&, const Fragment&) = default;
};

}  // namespace gradus::a_buffer
