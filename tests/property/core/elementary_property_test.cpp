// sin … pow against Boost's cpp_bin_float with 100 decimal digits: the bound that elementary.hpp states, in
// ulp.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include "core/elementary.hpp"
#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus {
namespace {

using Reference = boost::multiprecision::cpp_bin_float_100;
// Enough digits of pi for the largest double
using Huge = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<1500, boost::multiprecision::digit_base_2>>;

constexpr double bound = 0.501;         // ulp of double
constexpr double float_bound = 0.5001;  // ulp of float

using test::seed;

// The distance between neighbouring numbers of type T around this size
template <class T>
Reference ulp(const Reference& x) {
  using Limits = std::numeric_limits<T>;
  const int lowest = Limits::min_exponent - Limits::digits;
  const int exponent = x == 0 ? lowest : std::max(ilogb(x) - Limits::digits + 1, lowest);
  return ldexp(Reference(1), exponent);
}

template <class T>
double error_in_ulp(T result, const Reference& exact) {
  return static_cast<double>(abs(Reference(result) - exact) / ulp<T>(exact));
}

class ElementaryProperty : public ::testing::Test {
 protected:
  void SetUp() override { RecordProperty("GRADUS_SEED", std::to_string(seed())); }
  void TearDown() override {
    std::printf("             %d cases, at most %.6f ulp (double), %.7f ulp (float)\n", cases, worst,
                worst_float);
  }

  double number(std::int64_t lowest, std::int64_t highest) {
    const int exponent = static_cast<int>(random.uniform_int(lowest, highest));
    const double size = std::ldexp(random.uniform(1, 2), exponent);
    return random.unit() < 0.5 ? -size : size;
  }

  void check(double result, const Reference& exact, double x, double y = 0) {
    const double error = error_in_ulp(result, exact);
    worst = std::max(worst, error);
    ++cases;
    ASSERT_LT(error, bound) << "GRADUS_SEED=" << seed() << std::hexfloat << " x=" << x << " y=" << y
                            << " result=" << result;
  }

  void check_float(float result, const Reference& exact, float x, float y = 0) {
    const double error = error_in_ulp(result, exact);
    worst_float = std::max(worst_float, error);
    ++cases;
    ASSERT_LT(error, float_bound) << "GRADUS_SEED=" << seed() << std::hexfloat << " x=" << x << " y=" << y
                                  << " result=" << result;
  }

  Random random{seed()};
  int cases = 0;
  double worst = 0;
  double worst_float = 0;
};

// x modulo 2 pi to 100 digits
Reference without_turns(double x) {
  static const Huge turn = 2 * boost::math::constants::pi<Huge>();
  const Huge turns = round(Huge(x) / turn);
  return Reference(Huge(x) - turns * turn);
}

// Any size, and the doubles nearest to multiples of pi/2, where nearly all digits cancel
TEST_F(ElementaryProperty, SinCosTan) {
  int far = 0;
  for (int i = 0; i < 6000 && !HasFatalFailure(); ++i) {
    double x = number(-40, 10);
    if (i % 4 == 1) x = number(-1074, 1023);
    if (i % 4 == 2) x = std::floor(number(0, 60)) * 0x1.921fb54442d18p+0;
    if (i % 4 == 3) x = random.uniform(-0.8, 0.8);
    const Reference angle = without_turns(x);
    const Reference sine = sin(angle), cosine = cos(angle);
    check(gradus::sin(x), sine, x);
    check(gradus::cos(x), cosine, x);
    check(gradus::tan(x), sine / cosine, x);
    far += std::abs(x) > 0x1p60 ? 1 : 0;
  }
  EXPECT_EQ(cases, 18000);
  EXPECT_GE(far, 500);
}

// The double that lies nearest to a multiple of pi/2 in all its range, relative to its size: 2^-61 away.
// Source: Muller, "Elementary functions", 2006, table 9.2.
TEST_F(ElementaryProperty, SinCosTanAtTheWorstCancellation) {
  for (const double x : {0x1.6ac5b262ca1ffp+849, -0x1.6ac5b262ca1ffp+849, 1e22, 0x1.fffffffffffffp+1023}) {
    const Reference angle = without_turns(x);
    check(gradus::sin(x), sin(angle), x);
    check(gradus::cos(x), cos(angle), x);
    check(gradus::tan(x), sin(angle) / cos(angle), x);
  }
  EXPECT_LT(std::abs(gradus::cos(0x1.6ac5b262ca1ffp+849)), 0x1p-60);
  EXPECT_EQ(cases, 12);
}

TEST_F(ElementaryProperty, SinCosOfDegrees) {
  static const Huge degree = boost::math::constants::pi<Huge>() / 180;
  for (int i = 0; i < 2000 && !HasFatalFailure(); ++i) {
    double x = random.uniform(-720, 720);
    if (i % 4 == 1) x = number(-1074, 1023);
    if (i % 4 == 2) x = 90 * std::floor(random.uniform(-1000, 1000)) + number(-40, -5);
    const Reference angle = Reference(Huge(std::fmod(x, 360.0)) * degree);
    const SinCos result = sin_cos_degrees(x);
    // At multiples of 90 degrees the reference itself is only near 0
    const auto exact = [](const Reference& r) { return abs(r) < 1e-90 && r != 0 ? Reference(0) : r; };
    check(result.sin, std::abs(x) < 1 ? Reference(sin(angle)) : exact(sin(angle)), x);
    check(result.cos, exact(cos(angle)), x);
    check(radians_from_degrees(x), Reference(Huge(x) * degree), x);
  }
  EXPECT_EQ(cases, 6000);
}

TEST_F(ElementaryProperty, AsinAcos) {
  for (int i = 0; i < 3000 && !HasFatalFailure(); ++i) {
    double x = random.uniform(-1, 1);
    if (i % 3 == 1) x = number(-1074, -1);
    if (i % 3 == 2) x = std::copysign(1 - std::abs(number(-53, -1)), random.unit() - 0.5);
    check(gradus::asin(x), asin(Reference(x)), x);
    check(gradus::acos(x), acos(Reference(x)), x);
  }
  EXPECT_EQ(cases, 6000);
}

TEST_F(ElementaryProperty, AtanAtan2) {
  int subnormal = 0, backwards = 0;
  for (int i = 0; i < 4000 && !HasFatalFailure(); ++i) {
    const double size = i % 2 == 0 ? number(-10, 10) : number(-1074, 1023);
    check(gradus::atan(size), atan(Reference(size)), size);
    // y of like size, of any size, or such that y / x is subnormal
    double y = number(-1074, 1023);
    if (i % 3 == 0) y = size * random.uniform(0.01, 100);
    if (i % 3 == 1) y = std::ldexp(y / std::abs(y), std::max(-1074, std::ilogb(size) - 1060));
    if (!std::isfinite(y)) y = size;
    const Reference exact = atan2(Reference(y), Reference(size));
    check(gradus::atan2(y, size), exact, size, y);
    subnormal += abs(exact) < std::numeric_limits<double>::min() ? 1 : 0;
    backwards += size < 0 ? 1 : 0;
  }
  EXPECT_EQ(cases, 8000);
  EXPECT_GE(subnormal, 50);
  EXPECT_GE(backwards, 1500);
}

TEST_F(ElementaryProperty, Exp) {
  int subnormal = 0;
  for (int i = 0; i < 4000 && !HasFatalFailure(); ++i) {
    double x = random.uniform(-745, 709.7);
    if (i % 4 == 1) x = number(-60, 2);
    if (i % 4 == 2) x = random.uniform(-746, -708);
    if (i % 4 == 3) x = std::nextafter(std::round(random.uniform(-1000, 1000)) * 0x1.62e42fefa39efp-2, 0);
    const Reference exact = exp(Reference(x));
    check(gradus::exp(x), exact, x);
    subnormal += exact < std::numeric_limits<double>::min() ? 1 : 0;
  }
  EXPECT_EQ(cases, 4000);
  EXPECT_GE(subnormal, 500);
}

TEST_F(ElementaryProperty, Log) {
  for (int i = 0; i < 3000 && !HasFatalFailure(); ++i) {
    double x = std::abs(number(-1074, 1023));
    if (i % 3 == 1) x = 1 + number(-53, -1);
    if (i % 3 == 2) x = random.uniform(0.5, 2);
    check(gradus::log(x), log(Reference(x)), x);
  }
  EXPECT_EQ(cases, 3000);
}

TEST_F(ElementaryProperty, Pow) {
  int subnormal = 0, negative = 0;
  for (int i = 0; i < 4000 && !HasFatalFailure(); ++i) {
    double x = std::abs(number(-1074, 1023));
    if (i % 3 == 1) x = 1 + number(-53, -1);
    if (i % 3 == 2) x = random.uniform(0, 10);
    // An exponent that keeps the result in range, now and then a small integer
    double y = random.uniform(-745, 709) / std::log(x);
    if (i % 5 == 0) y = std::round(random.uniform(-20, 20));
    if (i % 5 == 1) y = random.uniform(-745, -708) / std::log(x);
    if (!std::isfinite(y) || y == 0) y = 0.5;
    if (std::round(y) == y && random.unit() < 0.5) x = -x;
    const Reference exact = pow(Reference(x), Reference(y));
    if (abs(exact) > std::numeric_limits<double>::max()) {
      EXPECT_TRUE(std::isinf(gradus::pow(x, y)));
      ++cases;
      continue;
    }
    check(gradus::pow(x, y), exact, x, y);
    subnormal += abs(exact) < std::numeric_limits<double>::min() ? 1 : 0;
    negative += x < 0 ? 1 : 0;
  }
  EXPECT_EQ(cases, 4000);
  EXPECT_GE(subnormal, 300);
  EXPECT_GE(negative, 100);
}

TEST_F(ElementaryProperty, Float) {
  for (int i = 0; i < 1500 && !HasFatalFailure(); ++i) {
    const float x = static_cast<float>(number(-126, 126));
    const float unit = static_cast<float>(random.uniform(-1, 1));
    const float size = std::abs(x);
    const float y = static_cast<float>(random.uniform(-80, 80) / std::log(double{size}));
    const float exponent = static_cast<float>(random.uniform(-103, 88.7));
    check_float(gradus::sin(x), sin(without_turns(x)), x);
    check_float(gradus::cos(x), cos(without_turns(x)), x);
    check_float(gradus::tan(x), tan(without_turns(x)), x);
    check_float(gradus::asin(unit), asin(Reference(unit)), unit);
    check_float(gradus::acos(unit), acos(Reference(unit)), unit);
    check_float(gradus::atan(x), atan(Reference(x)), x);
    check_float(gradus::atan2(unit, x), atan2(Reference(unit), Reference(x)), x, unit);
    check_float(gradus::exp(exponent), exp(Reference(exponent)), exponent);
    check_float(gradus::log(size), log(Reference(size)), size);
    check_float(gradus::pow(size, y), pow(Reference(size), Reference(y)), size, y);
  }
  EXPECT_EQ(cases, 15000);
}

// The measure itself tells the nearest double from its neighbour
TEST_F(ElementaryProperty, TheMeasureNoticesTheNextDouble) {
  const Reference third = Reference(1) / 3;
  EXPECT_LT(error_in_ulp(1.0 / 3, third), 0.5);
  EXPECT_GT(error_in_ulp(std::nextafter(1.0 / 3, 1), third), 0.5);
  EXPECT_GT(error_in_ulp(1e-323, Reference(5e-324)), 0.99);
  EXPECT_LT(error_in_ulp(1e-323, Reference(5e-324)), 1.01);
}

}  // namespace
}  // namespace gradus
