#pragma once
// Stage 8 by a table: the bytes of light, without a search.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/colour.hpp"
#include "core/image.hpp"
#include "core/surface.hpp"

namespace gradus::pipeline::engine {

/// The bytes that srgb8_from_linear gives.
class LightBytes {
 public:
  LightBytes();

  /// Accuracy: the bytes of srgb8_from_linear, for every float. Cost: two look-ups.
  std::uint8_t operator()(float light) const {
    // What is no number is not above the least
    const float above = light > least ? light : least, within = above < 1 ? above : below_one;
    const std::size_t first = first_[(std::bit_cast<std::uint32_t>(within) - least_bits) >> shift];
    return static_cast<std::uint8_t>(first + (limit_[first] < within));
  }
  Rgba8 operator()(const LinearRgb& light) const {
    return {operator()(light.r), operator()(light.g), operator()(light.b), 255};
  }

 private:
  // Light up to here is black. Of each octave 256 equal parts, so narrow that bytes change once at most
  static constexpr float least = 0x1p-13f, below_one = 0x1.fffffep-1f;
  static constexpr std::uint32_t least_bits = std::bit_cast<std::uint32_t>(least);
  static constexpr int shift = 15;
  static constexpr std::size_t parts = 13 * 256;

  std::array<std::uint8_t, parts> first_;  ///< bytes of where parts begin
  std::array<float, 256> limit_;           ///< the most light that has a byte
};

}  // namespace gradus::pipeline::engine
