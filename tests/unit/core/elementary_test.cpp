#include "core/arithmetic/elementary.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/random.hpp"

namespace gradus {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = 0x1.921fb54442d18p+1;

constexpr std::array<double, 24> special_values = {
    0.0,     -0.0,     1,        -1,        0.5,          -0.5,        2,       -2,     3,
    -3,      4,        -4,       5e-324,    -5e-324,      1e-310,      -1e-310, 0x1p53, -0x1p53,
    1.7e308, -1.7e308, infinity, -infinity, not_a_number, 0x1p52 + 0.5};

// Same bits, except that any NaN is as good as another; and within an ulp where the library rounds otherwise
void expect_like_library(double ours, double library, double x, double y = 0) {
  if (std::isnan(library)) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(ours), std::bit_cast<std::uint64_t>(not_a_number))
        << x << ' ' << y;
  } else {
    EXPECT_TRUE(ours == library || ours == std::nextafter(library, ours)) << x << ' ' << y << ' ' << ours;
    EXPECT_EQ(std::signbit(ours), std::signbit(library)) << x << ' ' << y;
  }
}

TEST(Elementary, TreatsSpecialValuesAsCDoes) {
  for (const double x : special_values) {
    expect_like_library(gradus::sin(x), std::sin(x), x);
    expect_like_library(gradus::cos(x), std::cos(x), x);
    expect_like_library(gradus::tan(x), std::tan(x), x);
    expect_like_library(gradus::asin(x), std::asin(x), x);
    expect_like_library(gradus::acos(x), std::acos(x), x);
    expect_like_library(gradus::atan(x), std::atan(x), x);
    expect_like_library(gradus::exp(x), std::exp(x), x);
    expect_like_library(gradus::log(x), std::log(x), x);
    expect_like_library(gradus::sqrt(x), x < 0 ? not_a_number : std::sqrt(x), x);
    for (const double y : special_values) {
      expect_like_library(gradus::atan2(y, x), std::atan2(y, x), y, x);
      expect_like_library(gradus::pow(x, y), std::pow(x, y), x, y);
    }
  }
}

TEST(Elementary, KnowsTheExactCases) {
  EXPECT_EQ(gradus::exp(0.0), 1);
  EXPECT_EQ(gradus::exp(1.0), 0x1.5bf0a8b145769p+1);
  EXPECT_EQ(gradus::log(1.0), 0);
  EXPECT_EQ(gradus::log(gradus::exp(1.0)), 1);
  EXPECT_EQ(gradus::acos(-1.0), pi);
  EXPECT_EQ(gradus::atan2(1.0, 1.0) * 4, pi);
  EXPECT_EQ(gradus::asin(1.0) * 2, pi);
  EXPECT_EQ(gradus::acos(0.5), 0x1.0c152382d7366p+0);
  EXPECT_EQ(gradus::sin(pi), 0x1.1a62633145c07p-53) << "what pi lacks";
}

TEST(Elementary, PowersOfSmallIntegersAreExact) {
  for (int base = -12; base <= 12; ++base) {
    double product = 1;
    for (int exponent = 0; exponent <= 14; ++exponent) {
      EXPECT_EQ(gradus::pow(static_cast<double>(base), static_cast<double>(exponent)), product);
      product *= base;
    }
  }
  for (int exponent = -1074; exponent <= 1023; ++exponent) {
    EXPECT_EQ(gradus::pow(2.0, static_cast<double>(exponent)), std::ldexp(1.0, exponent));
  }
  EXPECT_EQ(gradus::pow(9.0, 0.5), 3);
  EXPECT_EQ(gradus::pow(10.0, 22.0), 1e22);
}

TEST(Elementary, ReducesAnglesOfAnySize) {
  EXPECT_EQ(gradus::cos(1e22), 0x1.0be2cef01c8f4p-1) << "0.52321478539513894549...";
  EXPECT_EQ(gradus::sin(1e22), -0.8522008497671888);
  // The largest double (Muller, "Elementary functions", chapter 11)
  EXPECT_EQ(gradus::sin(0x1.fffffffffffffp+1023), 0.004961954789184062);
  EXPECT_EQ(gradus::cos(0x1.fffffffffffffp+1023), -0.9999876894265599);
}

TEST(Elementary, KnowsDegrees) {
  EXPECT_EQ(sin_cos_degrees(30).sin, 0.5);
  EXPECT_EQ(sin_cos_degrees(60).cos, 0.5);
  EXPECT_EQ(sin_cos_degrees(-150).sin, -0.5);
  EXPECT_EQ(sin_cos_degrees(45).sin, sin_cos_degrees(45).cos);
  EXPECT_EQ(sin_cos_degrees(360 * 0x1p60 + 0).sin, 0);
  EXPECT_TRUE(std::isnan(sin_cos_degrees(infinity).sin));
  EXPECT_EQ(radians_from_degrees(180), pi);
  EXPECT_EQ(radians_from_degrees(-infinity), -infinity);
  EXPECT_EQ(radians_from_degrees(1.7e308), 1.7e308 / 180 * pi);
}

TEST(Elementary, TheBlindSpotOfOneMinusCosine) {
  // 1 - cos(1e-9) is 0 in double; 2 sin^2 of the half angle is not
  EXPECT_EQ(1 - gradus::cos(1e-9), 0);
  const double half = gradus::sin(0.5e-9);
  EXPECT_EQ(2 * half * half, 5e-19);
}

TEST(Elementary, FloatIsTheDoubleResultRounded) {
  EXPECT_EQ(gradus::sin(1.0f), 0.84147098f);
  EXPECT_EQ(gradus::pow(2.0f, 0.5f), 1.41421356f);
  EXPECT_EQ(gradus::exp(89.0f), std::numeric_limits<float>::infinity());
  EXPECT_EQ(gradus::sqrt(2.0f), 1.41421356f);
  static_assert(std::is_same_v<decltype(gradus::atan2(1.0f, 2.0f)), float>);
}

// The numbers below were made with GCC 12 at -O2; Clang and WebAssembly must find them too
TEST(Elementary, HasTheSameBitsOnEveryCompiler) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, over words
  const auto add = [&hash](double x) { hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3; };
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const double unit = random.uniform(-1, 1);
    const double number = random.uniform(-1000, 1000);
    const double any = std::bit_cast<double>(random() & 0x7FFFFFFFFFFFFFFF);  // infinities and NaN too
    for (const double x : {unit, number, any}) {
      const SinCos both = sin_cos(x), degrees = sin_cos_degrees(x);
      for (const double y : {both.sin, both.cos, degrees.sin, degrees.cos}) add(y);
      for (const double y : {gradus::tan(x), gradus::asin(x), gradus::acos(x), gradus::atan(x)}) add(y);
      for (const double y : {gradus::exp(x), gradus::log(x), gradus::sqrt(std::abs(x))}) add(y);
      for (const double y : {gradus::atan2(unit, x), gradus::pow(std::abs(x), unit)}) add(y);
      add(gradus::pow(std::abs(unit), x));
    }
  }
  EXPECT_EQ(hash, 4265938628862063688u);
}

}  // namespace
}  // namespace gradus
