#include "core/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/arithmetic/elementary.hpp"

namespace gradus {
namespace {

/// The sRGB transfer function from [0, 1] to light.
double light_of(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : pow((srgb + 0.055) / 1.055, 2.4); }

/// The largest float that is not above x: another float is above one exactly if it is above the other.
float rounded_down(double x) {
  const auto nearest = static_cast<float>(x);
  return double{nearest} > x ? std::nextafter(nearest, 0.0f) : nearest;
}

/// The light of each value, and between each two the light where the nearer one changes.
struct Tables {
  std::array<float, 256> light;
  std::array<float, 255> limit;
  Tables() {
    for (std::size_t i = 0; i < 256; ++i)
      light[i] = static_cast<float>(light_of(static_cast<double>(i) / 255));
    for (std::size_t i = 0; i < 255; ++i) {
      limit[i] = rounded_down(light_of((static_cast<double>(i) + 0.5) / 255));
    }
  }
};

const Tables& tables() {
  static const Tables made;
  return made;
}

}  // namespace

float linear_from_srgb8(std::uint8_t value) { return tables().light[value]; }

std::uint8_t srgb8_from_linear(float light) {
  const auto& limit = tables().limit;
  // Written so that NaN is above no limit
  const auto above =
      std::partition_point(limit.begin(), limit.end(), [light](float border) { return border < light; });
  return static_cast<std::uint8_t>(above - limit.begin());
}

Rgba8 srgb8_from_linear(LinearRgb light) {
  return {srgb8_from_linear(light.r), srgb8_from_linear(light.g), srgb8_from_linear(light.b), 255};
}

LinearRgb linear_from_srgb8(Rgba8 pixel) {
  return {linear_from_srgb8(pixel.r), linear_from_srgb8(pixel.g), linear_from_srgb8(pixel.b)};
}

}  // namespace gradus
