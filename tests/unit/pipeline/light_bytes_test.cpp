// The engine's bytes of light are those of core, for every float.

#include "engine/light_bytes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

#include "core/colour.hpp"
#include "support/sanitized.hpp"
#include "support/share.hpp"

namespace gradus::pipeline::engine {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(LightBytes, AreThoseOfCoreForEveryFloat) {
  const LightBytes bytes;
  // 2^14 in each of 2^18 parts, those that are no numbers too; between 2^-14 and 1 each part has its turn
  const auto share = static_cast<std::uint32_t>(std::bit_cast<std::uint32_t>(0x1p-14f) >> 14);
  const auto end = static_cast<std::uint32_t>(std::bit_cast<std::uint32_t>(1.0f) >> 14);
  std::int64_t compared = 0;
  for (std::uint32_t part = 0; part < 1U << 18; ++part) {
    const bool changing = share <= part && part <= end;
    if (changing && !test::in_share(part, test::sanitized ? 1000 : 30)) continue;
    // Of the others the first, the last and two amidst them
    const std::uint32_t step = changing ? 1 : 5461;
    for (std::uint32_t i = 0; i < 1U << 14; i += step) {
      const float light = std::bit_cast<float>(part << 14 | i);
      ASSERT_EQ(bytes(light), srgb8_from_linear(light)) << light;
      ++compared;
    }
  }
  EXPECT_GT(compared, 1'000'000);
}

TEST(LightBytes, ChangeWhereThoseOfCoreDo) {
  const LightBytes bytes;
  int changes = 0;
  for (int value = 0; value < 256; ++value) {
    // From one value's light to the next the byte changes once: there, and beside it
    std::uint32_t low = std::bit_cast<std::uint32_t>(linear_from_srgb8(static_cast<std::uint8_t>(value)));
    std::uint32_t high =
        value == 255 ? std::bit_cast<std::uint32_t>(infinity)
                     : std::bit_cast<std::uint32_t>(linear_from_srgb8(static_cast<std::uint8_t>(value + 1)));
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      (srgb8_from_linear(std::bit_cast<float>(middle)) <= value ? low : high) = middle;
    }
    for (const std::uint32_t bits : {low - 1, low, high, high + 1}) {
      const float light = std::bit_cast<float>(bits);
      ASSERT_EQ(bytes(light), srgb8_from_linear(light)) << value;
    }
    changes += bytes(std::bit_cast<float>(low)) != bytes(std::bit_cast<float>(high));
  }
  EXPECT_EQ(changes, 255);
  EXPECT_EQ(bytes(LinearRgb{0, 2, -infinity}), (Rgba8{0, 255, 0, 255}));
}

}  // namespace
}  // namespace gradus::pipeline::engine
