// Angles of every size, in radians and degrees.

#include "core/arithmetic/turn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic/exact_scalar.hpp"

namespace gradus {
namespace {

TEST(Turn, MultiplesOf90DegreesAreExact) {
  const double sines[] = {0, 1, 0, -1}, cosines[] = {1, 0, -1, 0};
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const Turn<double> t = turn_degrees(90.0 * quarter);
    const int place = ((quarter % 4) + 4) % 4;
    EXPECT_EQ(t.sin, sines[place]);
    EXPECT_EQ(t.cos, cosines[place]);
    EXPECT_EQ(t.versine, 1 - cosines[place]);
    EXPECT_EQ(turn_degrees(90.0f * static_cast<float>(quarter)).cos, static_cast<float>(cosines[place]));
  }
  EXPECT_EQ(turn_degrees(60.0).cos, 0.5);
}

TEST(Turn, TinyAnglesKeepTheirVersine) {
  const Turn<double> t = turn(1e-9);
  EXPECT_EQ(t.sin, 1e-9);
  EXPECT_EQ(t.cos, 1);
  EXPECT_NEAR(t.versine, 5e-19, 1e-34);  // 1 - cos is 0
  EXPECT_EQ(1 - t.cos, 0);
}

TEST(Turn, HugeAnglesAreReduced) {
  EXPECT_EQ(turn(1e22).cos, 0.523214785395139);
  EXPECT_NEAR(turn(1e22).sin, -0.8522008497671888, 1e-16);
}

TEST(Turn, VersineOfEveryAngle) {
  for (int i = 0; i <= 2880; ++i) {
    const double degrees = i / 8.0;
    const long double near = std::min(i, 2880 - i) / 16.0L;  // half of it, from 0 or from 360
    const long double half = std::sin(near / 180 * 3.141592653589793238L);
    const double exact = static_cast<double>(2 * half * half);
    EXPECT_NEAR(turn_degrees(degrees).versine, exact, 4e-16 * exact) << degrees;
  }
}

TEST(Turn, BackAndRefusals) {
  const Turn<double> t = turn_degrees(30.0), back = reversed(t);
  EXPECT_EQ(back.sin, -t.sin);
  EXPECT_EQ(back.cos, t.cos);
  EXPECT_EQ(back.versine, t.versine);
  EXPECT_FALSE(std::signbit(reversed(turn_degrees(180.0)).sin));
  EXPECT_THROW(turn(std::numeric_limits<double>::quiet_NaN()), ContractViolation);
  EXPECT_THROW(turn(std::numeric_limits<double>::infinity()), ContractViolation);
  EXPECT_THROW(turn_degrees(std::numeric_limits<float>::infinity()), ContractViolation);
  const ExactScope scope;
  const Turn<Exact> exact = turn_of(Exact(3, 5), Exact(4, 5));
  EXPECT_EQ(exact.versine, Exact(1, 5));
}

}  // namespace
}  // namespace gradus
