#include "engine/light_bytes.hpp"

#include <limits>

namespace gradus::pipeline::engine {

LightBytes::LightBytes() {
  const auto at = [](std::uint32_t bits) { return std::bit_cast<float>(bits); };
  for (std::size_t i = 0; i < parts; ++i)
    first_[i] = srgb8_from_linear(at(least_bits + (static_cast<std::uint32_t>(i) << shift)));
  limit_[255] = std::numeric_limits<float>::infinity();
  std::uint32_t bits = least_bits;
  for (std::size_t value = 0; value < 255; ++value) {
    // The last float of this byte is from `bits` on, before `beyond`
    std::uint32_t beyond = std::bit_cast<std::uint32_t>(1.0f);
    while (beyond - bits > 1) {
      const std::uint32_t middle = bits + (beyond - bits) / 2;
      (srgb8_from_linear(at(middle)) <= value ? bits : beyond) = middle;
    }
    limit_[value] = at(bits);
  }
}

}  // namespace gradus::pipeline::engine
