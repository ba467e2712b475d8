// sRGB and back, and the border between two values.

#include "core/colour.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
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

using Wide = boost::multiprecision::cpp_bin_float_50;

/// The light of an sRGB value, to 50 digits; of 3/2, what lies in the middle between 1 and 2.
Wide light_of(const Wide& value) {
  const Wide srgb = value / 255;
  if (srgb <= Wide("0.04045")) return srgb / Wide("12.92");
  return pow((srgb + Wide("0.055")) / Wide("1.055"), Wide("2.4"));
}

TEST(Colour, TheLightIsTheNearestFloat) {
  for (int value = 0; value < 256; ++value) {
    const Wide exact = light_of(value);
    const float light = linear_from_srgb8(static_cast<std::uint8_t>(value));
    const auto off = [&](float x) { return abs(Wide(x) - exact); };
    EXPECT_LE(off(light), off(std::nextafter(light, 2.0f))) << value;
    EXPECT_LE(off(light), off(std::nextafter(light, -1.0f))) << value;
  }
}

// Of the floats beside each middle none is taken for the other value; half of the middles lie above the float
// that is nearest to them
TEST(Colour, EveryFloatBesideAMiddleGoesToItsSide) {
  EXPECT_EQ(srgb8_from_linear(0x1.3e4568p-13f), 1);
  int rounded_up = 0;
  for (int value = 0; value < 255; ++value) {
    const Wide middle = light_of(value + Wide(0.5));
    float light = static_cast<float>(middle);
    rounded_up += light > middle;
    for (int i = 0; i < 3; ++i) light = std::nextafter(light, 0.0f);
    for (int i = 0; i < 7; ++i, light = std::nextafter(light, 2.0f)) {
      EXPECT_EQ(srgb8_from_linear(light), light > middle ? value + 1 : value) << value << ", " << light;
    }
  }
  EXPECT_GT(rounded_up, 100);
  EXPECT_LT(rounded_up, 155);
}

TEST(Colour, BeyondTheEnds) {
  EXPECT_EQ(srgb8_from_linear(-1.0f), 0);
  EXPECT_EQ(srgb8_from_linear(20.0f), 255);
  EXPECT_EQ(srgb8_from_linear(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(srgb8_from_linear(std::numeric_limits<float>::infinity()), 255);
  EXPECT_EQ(srgb8_from_linear(LinearRgb{1, 0.5f, 0}), (Rgba8{255, 188, 0, 255}));
  EXPECT_EQ(linear_from_srgb8(Rgba8{255, 0, 255, 9}), (LinearRgb{1, 0, 1}));
}

}  // namespace
}  // namespace gradus
