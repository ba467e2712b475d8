// sRGB and back, and the border between two values.

#include "core/colour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gradus {
namespace {

TEST(Colour, EveryValueComesBack) {
  float last = -1;
  for (int v = 0; v < 256; ++v) {
    const auto value = static_cast<std::uint8_t>(v);
    const float light = linear_from_srgb8(value);
    EXPECT_GT(light, last);
    EXPECT_EQ(srgb8_from_linear(light), value);
    last = light;
  }
  EXPECT_EQ(linear_from_srgb8(0), 0.0f);
  EXPECT_EQ(linear_from_srgb8(255), 1.0f);
}

TEST(Colour, TheNearestValueIsTaken) {
  int checked = 0;
  for (float light = 0; light <= 1; light += 0.0001f) {
    const double x = light;
    const double srgb = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    const double exact = 255 * srgb;
    if (std::abs(exact - std::floor(exact) - 0.5) < 1e-3)
      continue;  // the standard's two formulas meet roughly
    EXPECT_EQ(srgb8_from_linear(light), std::lround(exact)) << light;
    ++checked;
  }
  EXPECT_GT(checked, 9000);
  // Half the light is 188, not 128
  EXPECT_EQ(srgb8_from_linear(0.5f), 188);
}

TEST(Colour, BeyondTheEnds) {
  EXPECT_EQ(srgb8_from_linear(-1.0f), 0);
  EXPECT_EQ(srgb8_from_linear(20.0f), 255);
  EXPECT_EQ(srgb8_from_linear(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(srgb8_from_linear(std::numeric_limits<float>::infinity()), 255);
  EXPECT_EQ(srgb8_from_linear(Rgb{1, 0.5f, 0}), (Rgba8{255, 188, 0, 255}));
  EXPECT_EQ(linear_from_srgb8(Rgba8{255, 0, 255, 9}), (Rgb{1, 0, 1}));
}

}  // namespace
}  // namespace gradus
