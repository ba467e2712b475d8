#include "shading/polygon_shading/mixed_along.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"

namespace gradus::polygon_shading {
namespace {

TEST(MixedAlong, AQuarterOfTheWayIsAQuarterOfTheBlend) {
  // G000-15: along x, 2.5 between 0 and 10
  EXPECT_EQ(mixed_along(Along::x, dvec2{0, 0}, dvec2{10, 4}, dvec2{0, 0}, dvec2{1, 2}, 2.5),
            (dvec2{0.25, 0.5}));
  // Along y the same place is at 1
  EXPECT_EQ(mixed_along(Along::y, dvec2{0, 0}, dvec2{10, 4}, dvec2{0, 0}, dvec2{1, 2}, 1.0),
            (dvec2{0.25, 0.5}));
  EXPECT_EQ(mixed_along(Along::x, dvec2{10, 4}, dvec2{0, 0}, dvec2{1, 2}, dvec2{0, 0}, 2.5),
            (dvec2{0.25, 0.5}))
      << "whichever comes first";
}

TEST(MixedAlong, LevelPlacesGiveTheFirstValue) {
  for (const double coordinate : {-1.0, 3.0, 5.0, 1e300}) {
    EXPECT_EQ(mixed_along(Along::y, dvec2{0, 3}, dvec2{10, 3}, dvec2{7, 8}, dvec2{1, 2}, coordinate),
              (dvec2{7, 8}));
    EXPECT_EQ(mixed_along(Along::x, dvec2{3, 0}, dvec2{3, 0}, 7.0, 1.0, coordinate), 7.0);
  }
}

TEST(MixedAlong, EndsAreExactAndNothingIsBeyondThem) {
  // E000-17: 1e16 + 1 (1 - 1e16) is 0
  EXPECT_EQ(1e16 + 1.0 * (1 - 1e16), 0);
  EXPECT_EQ(mixed_along(Along::x, dvec2{0, 0}, dvec2{1, 0}, 1e16, 1.0, 1.0), 1);
  EXPECT_EQ(mixed_along(Along::x, dvec2{0, 0}, dvec2{1, 0}, 1e16, 1.0, 0.0), 1e16);
  EXPECT_EQ(mixed_along(Along::x, dvec2{0, 0}, dvec2{1, 0}, 5.0, 1.0, -3.0), 5);
  EXPECT_EQ(mixed_along(Along::x, dvec2{0, 0}, dvec2{1, 0}, 5.0, 1.0, 3.0), 1);
  // Places that are nearly level still give what lies between
  const double next = std::nextafter(3.0, 4.0);
  EXPECT_EQ(mixed_along(Along::y, dvec2{0, 3}, dvec2{0, next}, 1.0, 2.0, next), 2);
}

TEST(MixedAlong, RationalsAgree) {
  constexpr std::uint64_t seed = 20261125;
  SCOPED_TRACE(seed);
  int between = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    Random random(seed, i);
    const auto number = [&random] { return random.uniform(-100.0, 100.0); };
    const dvec2 from{number(), number()}, to{number(), number()};
    const double first = number(), second = number(), coordinate = number();
    const auto exact = [](dvec2 p) { return glm::vec<2, Exact>(Exact(p.x), Exact(p.y)); };
    const Exact right =
        mixed_along(Along::x, exact(from), exact(to), Exact(first), Exact(second), Exact(coordinate));
    const double found = mixed_along(Along::x, from, to, first, second, coordinate);
    const double width = std::abs(to.x - from.x);
    EXPECT_NEAR(found, static_cast<double>(right),
                (4 + 200 / width) * 200 * std::numeric_limits<double>::epsilon());
    between += found != first && found != second;
  }
  EXPECT_GT(between, 100);
}

}  // namespace
}  // namespace gradus::polygon_shading
