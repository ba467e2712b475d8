// Bounds of powers beside 50 digits: they hold everywhere, and are as near to each other as promised.

#include "core/arithmetic/power_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/arithmetic/elementary.hpp"
#include "core/random.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/share.hpp"

namespace gradus {
namespace {

using Digits = boost::multiprecision::cpp_bin_float_50;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// x: near 1, in [0, 1], of any size. y: of highlights, small whole ones, of any size.
double random_base(Random& random) {
  const double which = random.unit();
  if (which < 0.3) return 1 + random.uniform(-1, 1) * std::exp2(random.uniform(-52, -1));
  if (which < 0.7) return random.unit();
  return std::exp2(random.uniform(-1022, 1023)) * random.uniform(1, 2) / 2;
}
double random_exponent(Random& random) {
  const double which = random.unit();
  if (which < 0.4) return random.uniform(0, 1000);
  if (which < 0.6) return static_cast<double>(random.uniform_int(-20, 200));
  return random.uniform(-1, 1) * std::exp2(random.uniform(-60, 30));
}

TEST(PowerBounds, HoldThePowerAndWhatPowMakesOfIt) {
  Random random(test::seed());
  double worst = 0;
  int between = 0;
  const int cases = test::whole_run() && !test::sanitized ? 2'000'000 : 20'000;
  for (int i = 0; i < cases; ++i) {
    const double x = random_base(random), y = random_exponent(random);
    const auto [low, high] = power_bounds(x, y);
    const double nearest = pow(x, y);
    ASSERT_TRUE(low <= nearest && nearest <= high) << x << ' ' << y << ' ' << low << ' ' << high;
    if (low == high || low == 0) continue;
    ++between;
    const Digits exactly(pow(Digits(x), Digits(y)));
    ASSERT_TRUE(Digits(low) <= exactly && exactly <= Digits(high)) << x << ' ' << y;
    const double exponent = std::abs(y * std::log2(x));
    EXPECT_LE(high - low, 0x1p-48 * (1 + exponent) * nearest) << x << ' ' << y;
    const Digits middle((Digits(low) + Digits(high)) / 2),
        off(abs(middle - exactly) / (Digits(high) - middle));
    worst = std::max(worst, off.convert_to<double>());
  }
  EXPECT_GT(between, cases / 2);
  // Wider than what powers are off, but not by far
  EXPECT_LT(worst, 0.5);
  EXPECT_GT(worst, 0.1);
}

/// Where entries of the tables begin and end, and beside them.
TEST(PowerBounds, HoldAtTheEndsOfTableEntries) {
  for (std::uint64_t entry = 0; entry <= 64; ++entry) {
    const double border = std::bit_cast<double>(0x3fe6955500000000 + (entry << 46));
    for (const double x : {border, std::nextafter(border, 0.0), std::nextafter(border, 2.0)}) {
      for (const double y : {1.0, 17.0, 333.3, -40.0}) {
        const auto [low, high] = power_bounds(x, y);
        const Digits exactly(pow(Digits(x), Digits(y)));
        EXPECT_TRUE(Digits(low) <= exactly && exactly <= Digits(high)) << x << ' ' << y;
      }
    }
  }
  for (int j = -32 * 40; j <= 32 * 40; ++j) {
    // Halfway between two entries
    const double y = (j + 0.5) / 32;
    for (const double t : {y, std::nextafter(y, -infinity), std::nextafter(y, infinity)}) {
      const auto [low, high] = power_bounds(2, t);
      const Digits exactly(pow(Digits(2), Digits(t)));
      EXPECT_TRUE(Digits(low) <= exactly && exactly <= Digits(high)) << t;
    }
  }
}

TEST(PowerBounds, AreThoseOfPowAtTheEndsOfTheRange) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min(),
                   most = std::numeric_limits<double>::max(),
                   not_a_number = std::numeric_limits<double>::quiet_NaN();
  constexpr std::array values{0.0,  -0.0,  1.0,    -1.0,  0.5,      2.0,       tiny,         -tiny,
                              most, -most, 1e-310, 1e300, infinity, -infinity, not_a_number, 1000.0};
  for (const double x : values) {
    for (const double y : values) {
      const auto [low, high] = power_bounds(x, y);
      const double power = pow(x, y);
      if (std::isnan(power))
        EXPECT_TRUE(std::isnan(low) && std::isnan(high)) << x << ' ' << y;
      else
        EXPECT_TRUE(low <= power && power <= high) << x << ' ' << y << ' ' << low << ' ' << high;
    }
  }
}

/// Powers of highlights become the same float from both bounds but for one or two of a million.
TEST(PowerBounds, BecomeTheSameFloat) {
  Random random(test::seed());
  constexpr int cases = test::sanitized ? 100'000 : 2'000'000;
  int apart = 0;
  for (int i = 0; i < cases; ++i) {
    const double rv = random.unit();
    const auto [low, high] = power_bounds(rv, random.uniform(0, 200));
    apart += static_cast<float>(low) != static_cast<float>(high);
  }
  EXPECT_LE(apart * 100'000.0, cases) << "at most ten in a million";
}

}  // namespace
}  // namespace gradus
