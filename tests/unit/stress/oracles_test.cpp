// What the oracles say of traps whose exact answers are known.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stress/clipping/circle_ends.hpp"
#include "stress/core/digits.hpp"
#include "stress/core/integers.hpp"
#include "support/circle_areas.hpp"
#include "support/clip_oracle.hpp"
#include "support/polygon_areas.hpp"

namespace gradus::stress {
namespace {

using test::Fraction;
using Line = Segment<2, double>;

std::optional<test::ExactEnds<2>> in_ten(const Line& line) {
  return test::exact_clip(line, AxisBox<2, double>{{0, 0}, {10, 10}});
}
/// The nearest doubles to both ends.
void expect_left(const Line& line, dvec2 from, dvec2 to) {
  const auto left = in_ten(line);
  ASSERT_TRUE(left);
  EXPECT_TRUE(test::is_nearest(from.x, left->a[0]) && test::is_nearest(from.y, left->a[1])) << from.x;
  EXPECT_TRUE(test::is_nearest(to.x, left->b[0]) && test::is_nearest(to.y, left->b[1])) << to.x;
}

TEST(Oracles, SegmentsInARectangle) {
  expect_left({{-1e308, 0}, {1e308, 10}}, {0, 5}, {10, 5});
  expect_left({{-1e200, -1e200}, {1e200, 1e200}}, {0, 0}, {10, 10});
  expect_left({{-1, 1}, {1, -1}}, {0, 0}, {0, 0});
  EXPECT_FALSE(in_ten({{-1, 1}, {1, -1.0000000000000002}}));
  EXPECT_FALSE(in_ten({{9, 11}, {11, 9.000000000000002}}));
  EXPECT_FALSE(in_ten({{-5, 8}, {3, 20}}));
  // Nearly along the upper edge: the crossing is at 0, an ulp in y moves it by a million
  const double under = 10 - 1.8e-15, over = 10 + 1.8e-15;
  const Line along{{-1e6, under}, {1e6, over}};
  const AxisBox<2, double> wide{{-2e6, 0}, {2e6, 10}};
  EXPECT_EQ(test::exact_clip(along, wide)->b[0], 0);
  EXPECT_LT(test::exact_clip(Line{along.a, {1e6, std::nextafter(over, 11)}}, wide)->b[0], -300'000);
}

TEST(Oracles, PolygonsInARectangle) {
  const std::vector<dvec2> diamond{{5, -5}, {15, 5}, {5, 15}, {-5, 5}},
      around{{-10, -10}, {30, -10}, {10, 40}}, enters{{-5, 2}, {5, 2}, {5, 8}};
  EXPECT_EQ(test::area_in_rectangle(diamond, {0, 0}, {10, 10}), 100);
  EXPECT_EQ(test::area_in_rectangle(around, {0, 0}, {10, 10}), 100);
  EXPECT_EQ(test::area_in_rectangle(enters, {0, 0}, {10, 10}), Fraction(45) / 2);
}

void expect_chord(const Input& i, dvec2 from, dvec2 to) {
  const auto ends = ends_in_circle(i);
  ASSERT_TRUE(ends);
  EXPECT_LE(ends->from.error(from), 0.5) << from.x;
  EXPECT_LE(ends->to.error(to), 0.5) << to.x;
}

TEST(Oracles, SegmentsInACircle) {
  const double above = 1 + 0x1p-52, below = 1 - 0x1p-53;
  expect_chord({1, 0, 2, 0, 0, 0, 1}, {1, 0}, {1, 0});
  expect_chord({-5, 0, 5, 0, 0, 3, 3}, {0, 0}, {0, 0});
  EXPECT_FALSE(ends_in_circle({1, 0, 2, 0, 0, 0, 1})->runs);
  EXPECT_FALSE(ends_in_circle({-2, above, 2, above, 0, 0, 1}));
  EXPECT_FALSE(ends_in_circle({-1e8, 1.0000001, 1e8, 1.0000001, 0, 0, 1}));
  // Half a chord of 1.49e-8
  expect_chord({-2, below, 2, below, 0, 0, 1}, {-0x1p-26, below}, {0x1p-26, below});
  expect_chord({-1e8, 0.5, 1e8, 0.5, 0, 0, 1}, {-0.8660254037844386, 0.5}, {0.8660254037844386, 0.5});
  EXPECT_NEAR(0x1p-26, 1.49e-8, 0.01e-8);
}

TEST(Oracles, PolygonsInACircle) {
  const auto area = [](const std::vector<dvec2>& polygon) {
    return static_cast<double>(test::exact_area(polygon, Circle<double>{{0, 0}, 1}));
  };
  EXPECT_NEAR(area({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), 0.785398, 5e-7);
  EXPECT_NEAR(area({{0, -0.5}, {3, -0.5}, {0, 0.5}}), 0.810830, 5e-7);
  EXPECT_NEAR(area({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}), 3.141593, 5e-7);
  EXPECT_NEAR(area({{-2, -0.5}, {2, -0.5}, {2, 0.5}, {-2, 0.5}}), 1.913223, 5e-7);
  EXPECT_NEAR(area({{-0.8, -0.8}, {0.8, -0.8}, {0.8, 0.8}, {-0.8, 0.8}}), 2.487588, 5e-7);
}

TEST(Oracles, AreasOfTrianglesInDoublesAndExactly) {
  const double u = 0x1p-53;
  const test::ExactPoint a{Fraction(0.5 + 2 * u), Fraction(0.5 + u)}, b{12, 12}, c{24, 24};
  EXPECT_NEAR(static_cast<double>(test::turn(a, b, c)), -1.33e-15, 0.005e-15);
}

TEST(Oracles, TheNearestOfAQuotient) {
  const double infinity = std::numeric_limits<double>::infinity(),
               largest = std::numeric_limits<double>::max();
  const Integer one = fixed(1.0), three = fixed(3.0), beyond = fixed(infinity);
  EXPECT_TRUE(is_nearest(1.0 / 3, one, three));
  EXPECT_FALSE(is_nearest(std::nextafter(1.0 / 3, 1), one, three));
  EXPECT_FALSE(is_nearest(std::nextafter(1.0 / 3, 0), one, three));
  EXPECT_TRUE(is_nearest(-1.0 / 3, one, -three));
  EXPECT_FALSE(is_nearest(largest, beyond, one));
  EXPECT_TRUE(is_nearest(infinity, beyond, one));
  EXPECT_FALSE(is_nearest(1.0f, one + fixed(0x1.000002p-24), one));
}

TEST(Oracles, DistancesInUlp) {
  const Digits third = Digits(1) / 3;
  EXPECT_LT(ulps(1.0 / 3, third), 0.5);
  EXPECT_GT(ulps(std::nextafter(1.0 / 3, 1), third), 0.5);
  EXPECT_NEAR(ulps(1e-323, Digits(5e-324)), 1, 0.01);
}

}  // namespace
}  // namespace gradus::stress
