// Cuts along the axes against Boost's rationals: the nearest point and the exact order, on input made so that
// fast arithmetic must give up often.

#include "core/axis_cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "core/random.hpp"
#include "support/clip_oracle.hpp"
#include "support/seed.hpp"

namespace gradus {
namespace {

using test::is_nearest;
using test::Rational;
using test::seed;

template <class T>
constexpr T infinite = std::numeric_limits<T>::infinity();

// A cut to make: c lies between the ends along the axis
template <class T>
struct Case {
  T a_axis, b_axis, a_other, b_other, c;
};

template <class T>
T cut(const Case<T>& k) {
  return cut_coordinate(k.a_axis, k.b_axis, k.a_other, k.b_other, k.c);
}

template <class T>
Rational exact_cut(const Case<T>& k) {
  const Rational a = k.a_axis, b = k.b_axis, from = k.a_other, to = k.b_other, c = k.c;
  return from + (c - a) * (to - from) / (b - a);
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

class AxisCutProperty : public ::testing::Test {
 protected:
  void SetUp() override { RecordProperty("GRADUS_SEED", std::to_string(seed())); }

  std::string where(int i) const {
    return "GRADUS_SEED=" + std::to_string(seed()) + " case " + std::to_string(i);
  }
  double number(std::int64_t lowest, std::int64_t highest) {
    const int exponent = static_cast<int>(random.uniform_int(lowest, highest));
    const double size = std::ldexp(random.uniform(1, 2), exponent);
    return random.unit() < 0.5 ? -size : size;
  }
  double between(double a, double b) {
    const double t = random.unit();
    return std::clamp(a * (1 - t) + b * t, std::min(a, b), std::max(a, b));
  }
  double nudged(double x) {
    const std::int64_t steps = random.uniform_int(-2, 2);
    for (std::int64_t i = 0; i < std::abs(steps); ++i)
      x = std::nextafter(x, steps < 0 ? -infinite<double> : infinite<double>);
    return x;
  }

  // Numbers of like size
  Case<double> ordinary() {
    Case<double> k{};
    k.a_axis = random.uniform(-1000, 1000);
    k.b_axis = random.uniform(-1000, 1000);
    k.a_other = random.uniform(-1000, 1000);
    k.b_other = random.uniform(-1000, 1000);
    k.c = between(k.a_axis, k.b_axis);
    return k;
  }
  // Mixed sizes from lowest to highest, zeros among them
  Case<double> mixed(std::int64_t lowest, std::int64_t highest) {
    const auto any = [&] { return random.unit() < 0.1 ? 0.0 : number(lowest, highest); };
    Case<double> k{};
    k.a_axis = any();
    k.b_axis = any();
    k.a_other = any();
    k.b_other = any();
    k.c = random.unit() < 0.1 ? 0.0 : between(k.a_axis, k.b_axis);
    if (k.c < std::min(k.a_axis, k.b_axis) || k.c > std::max(k.a_axis, k.b_axis)) k.c = k.b_axis;
    return k;
  }
  // The cut lies exactly midway between two doubles, or a hair beside it: halfway along, from an odd sum
  Case<double> tied() {
    Case<double> k{};
    const double size = std::ldexp(1.0, static_cast<int>(random.uniform_int(-40, 40)));
    k.a_axis = random.uniform(-8, 0);
    k.c = 0;
    k.b_axis = -k.a_axis;
    const std::int64_t high = std::int64_t{1} << 53, low = std::int64_t{1} << 52;
    const std::int64_t first = random.uniform_int(low, high - 1);
    const std::int64_t second = random.uniform_int(low, high - 1);
    k.a_other = static_cast<double>(first) * size;
    k.b_other = static_cast<double>(second - (first + second + 1) % 2) * size;
    if (random.unit() < 0.5) k.c = number(-200, -90);  // the hair
    return k;
  }
  // The end far away, the cut near zero: all digits of the sum cancel but a few
  Case<double> cancelling() {
    Case<double> k{};
    k.a_axis = -std::ldexp(random.uniform(1, 2), 20);
    k.b_axis = std::ldexp(random.uniform(1, 2), 20);
    k.c = between(-1, 1);
    const double slope = random.uniform(-4, 4);
    k.a_other = slope * (k.a_axis - k.c);
    k.b_other = slope * (k.b_axis - k.c);
    return k;
  }
  Case<double> any(int i) {
    switch (i % 6) {
      case 0:
        return ordinary();
      case 1:
        return mixed(-299, 299);
      case 2:
        return tied();
      case 3:
        return cancelling();
      case 4:
        return mixed(-1074, 1022);
      default:
        return mixed(-4, 4);
    }
  }

  Random random{seed()};
};

TEST_F(AxisCutProperty, IsTheNearestDoubleInBothDirections) {
  int ran = 0, slow = 0, ties = 0, subnormal = 0;
  for (int i = 0; i < 30000; ++i) {
    SCOPED_TRACE(where(i));
    const Case<double> k = any(i);
    if (k.a_axis == k.b_axis) continue;
    const double point = cut(k);
    const Rational exact = exact_cut(k);
    ASSERT_TRUE(is_nearest(point, exact)) << point;
    ASSERT_TRUE(same_bits(point, cut(Case<double>{k.b_axis, k.a_axis, k.b_other, k.a_other, k.c})));
    ASSERT_TRUE(same_bits(point, cut_coordinate_exact(k.a_axis, k.b_axis, k.a_other, k.b_other, k.c)));
    ASSERT_FALSE(point == 0 && std::signbit(point));
    ASSERT_LE(std::min(k.a_other, k.b_other), point);
    ASSERT_LE(point, std::max(k.a_other, k.b_other));
    ++ran;
    const bool at_end = k.c == k.a_axis || k.c == k.b_axis || k.a_other == k.b_other;
    slow += !at_end && !cut_coordinate_filtered(k.a_axis, k.b_axis, k.a_other, k.b_other, k.c) ? 1 : 0;
    const double next = std::nextafter(point, exact < Rational(point) ? -infinite<double> : infinite<double>);
    ties += Rational(point) != exact && Rational(point) + Rational(next) == 2 * exact ? 1 : 0;
    subnormal += point != 0 && std::abs(point) < std::numeric_limits<double>::min() ? 1 : 0;
  }
  EXPECT_GE(ran, 29000);
  EXPECT_GE(slow, ran / 10);
  EXPECT_GE(ties, 1000);
  EXPECT_GE(subnormal, 20);
}

// What the documentation calls the domain of the fast path: only ties and near ties leave it
TEST_F(AxisCutProperty, FastArithmeticSufficesInItsDomain) {
  int ran = 0, slow = 0;
  for (int i = 0; i < 20000; ++i) {
    const Case<double> k = i % 2 ? ordinary() : mixed(-299, 299);
    if (k.c == k.a_axis || k.c == k.b_axis || k.a_other == k.b_other) continue;
    ++ran;
    slow += cut_coordinate_filtered(k.a_axis, k.b_axis, k.a_other, k.b_other, k.c) ? 0 : 1;
  }
  EXPECT_GE(ran, 15000);
  EXPECT_LE(slow, ran / 100);
}

TEST_F(AxisCutProperty, IsTheNearestFloat) {
  int ran = 0, twice_rounded = 0, underflown = 0;
  for (int i = 0; i < 30000; ++i) {
    SCOPED_TRACE(where(i));
    Case<float> k{};
    const bool whole = i % 2 == 0;
    const auto any_float = [&](double lowest, double highest) {
      const double x = random.uniform(lowest, highest);
      return static_cast<float>(whole ? std::round(x) : x);
    };
    k.a_axis = any_float(-1000, 0);
    k.b_axis = any_float(1, 1000);
    k.a_other = any_float(-1e7, 1e7);
    k.b_other = any_float(-1e7, 1e7);
    k.c = any_float(double{k.a_axis}, double{k.b_axis});
    if (i % 3 == 0) {  // midway between two floats, a hair beside
      k = {-1, 1, 0x1.000002p0f, 0x1.000004p0f, static_cast<float>(number(-120, -60))};
    } else if (i % 3 == 1) {  // down to where floats underflow
      const auto sized = [&] { return static_cast<float>(number(-152, 126)); };
      k = {-std::abs(sized()), std::abs(sized()), sized(), sized(), 0};
      if (k.a_axis == k.b_axis) continue;
    }
    const float point = cut(k);
    const Rational exact = exact_cut(k);
    ASSERT_TRUE(is_nearest(point, exact)) << point;
    ASSERT_FALSE(point == 0 && std::signbit(point));
    underflown += point == 0 && exact != 0 ? 1 : 0;
    ASSERT_EQ(point, cut(Case<float>{k.b_axis, k.a_axis, k.b_other, k.a_other, k.c}));
    const float over_double =
        static_cast<float>(cut(Case<double>{k.a_axis, k.b_axis, k.a_other, k.b_other, k.c}));
    twice_rounded += over_double != point ? 1 : 0;
    ++ran;
  }
  EXPECT_GE(ran, 29900);
  EXPECT_GE(twice_rounded, 1000);
  EXPECT_GE(underflown, 20);
}

// What lies between 0 and minus half the smallest float, too
TEST(AxisCut, ZerosOfFloatsArePlusZero) {
  const float smallest = std::numeric_limits<float>::denorm_min();
  EXPECT_FALSE(std::signbit(cut_coordinate(0.0f, 4.0f, -smallest, 0.0f, 3.0f)));  // -1/4 of it
  EXPECT_FALSE(std::signbit(cut_coordinate(0.0f, 2.0f, -smallest, 0.0f, 1.0f)));  // -1/2 of it, a tie
  EXPECT_EQ(cut_coordinate(0.0f, 4.0f, -smallest, 0.0f, 1.0f), -smallest);        // -3/4 of it
}

// --- The order of cuts -----------------------------------------------------------------------------------

struct Corner {
  glm::dvec2 a, b, c;
};

int exact_order(const Corner& k) {
  const Rational first = (Rational(k.c.x) - Rational(k.a.x)) / (Rational(k.b.x) - Rational(k.a.x));
  const Rational second = (Rational(k.c.y) - Rational(k.a.y)) / (Rational(k.b.y) - Rational(k.a.y));
  return first.compare(second);
}

int sign_of(std::strong_ordering order) { return order < 0 ? -1 : order > 0 ? 1 : 0; }

// Segments aimed at the corner c, and away from it by a few steps
TEST_F(AxisCutProperty, OrdersCutsExactly) {
  int ran = 0, slow = 0, at_once = 0, naive_wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(where(i));
    const std::int64_t size = i % 3 == 0 ? random.uniform_int(-1070, 1020) : 3;
    Corner k{{number(size - 3, size), number(size - 3, size)},
             {number(size - 3, size), number(size - 3, size)},
             {}};
    const bool halfway = random.unit() < 0.3;
    const double t = halfway ? 0.5 : random.unit();
    const glm::dvec2 on_line = k.a * (1 - t) + k.b * t;
    k.c = {nudged(on_line.x), nudged(on_line.y)};
    if (halfway && i % 3 != 0) k.b = {2 * k.c.x - k.a.x, 2 * k.c.y - k.a.y};
    if (k.a.x == k.b.x || k.a.y == k.b.y) continue;
    const int expected = exact_order(k);
    ASSERT_EQ(sign_of(compare_cuts(k.a.x, k.b.x, k.c.x, k.a.y, k.b.y, k.c.y)), expected);
    ASSERT_EQ(sign_of(compare_cuts(k.b.x, k.a.x, k.c.x, k.b.y, k.a.y, k.c.y)), -expected);
    ASSERT_EQ(sign_of(compare_cuts(k.a.y, k.b.y, k.c.y, k.a.x, k.b.x, k.c.x)), -expected);
    const double u = (k.c.x - k.a.x) / (k.b.x - k.a.x), v = (k.c.y - k.a.y) / (k.b.y - k.a.y);
    naive_wrong += (u > v) - (u < v) != expected ? 1 : 0;
    slow += orient2d_filtered(k.a, k.b, k.c) ? 0 : 1;
    at_once += expected == 0 ? 1 : 0;
    ++ran;
  }
  EXPECT_GE(ran, 19000);
  EXPECT_GE(slow, ran / 10);
  EXPECT_GE(at_once, 100);
  EXPECT_GE(naive_wrong, 1000);
}

TEST_F(AxisCutProperty, ComparesExactlyAtACut) {
  int ran = 0, rounded_onto = 0;
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(where(i));
    const Case<double> k = any(i);
    if (k.a_axis == k.b_axis) continue;
    const Segment<2, double> segment{{k.a_axis, k.a_other}, {k.b_axis, k.b_other}};
    const double at = cut_point(segment, 0, k.c).y;
    const Rational exact = exact_cut(k);
    for (const double border : {at, nudged(at), k.a_other, k.b_other}) {
      const int expected = exact.compare(Rational(border));
      ASSERT_EQ(sign_of(compare_at_cut(segment, 0, k.c, 1, border, at)), expected) << border;
      rounded_onto += border == at && expected != 0 ? 1 : 0;
    }
    ++ran;
  }
  EXPECT_GE(ran, 19000);
  EXPECT_GE(rounded_onto, 10000);
}

// The oracle itself can tell right from wrong
TEST_F(AxisCutProperty, TheOracleNoticesTheNextDouble) {
  const Rational third = Rational(1) / 3;
  EXPECT_TRUE(is_nearest(1.0 / 3, third));
  EXPECT_FALSE(is_nearest(std::nextafter(1.0 / 3, 1), third));
  EXPECT_FALSE(is_nearest(std::nextafter(1.0 / 3, 0), third));
  EXPECT_FALSE(is_nearest(1.0f, Rational(1) + Rational(0x1.000002p-24)));
}

}  // namespace
}  // namespace gradus
