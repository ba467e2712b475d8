// Exact signs and correctly rounded quotients against Boost's rationals, on input made to be nearly
// degenerate.

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "core/exact.hpp"
#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

using test::seed;

class ExactProperty : public ::testing::Test {
 protected:
  void SetUp() override { RecordProperty("GRADUS_SEED", std::to_string(seed())); }

  std::string where(int i) const {
    return "GRADUS_SEED=" + std::to_string(seed()) + " case " + std::to_string(i);
  }

  // Random numbers are drawn in braces or statements of their own: the order of arguments differs between
  // compilers. A double with a random significand and an exponent from lowest to highest
  double number(std::int64_t lowest, std::int64_t highest) {
    const int exponent = static_cast<int>(random.uniform_int(lowest, highest));
    const double size = std::ldexp(random.uniform(1, 2), exponent);
    return random.unit() < 0.5 ? -size : size;
  }
  double any_number() { return random.unit() < 0.05 ? 0.0 : number(-1080, 1023); }

  // A few representable steps away
  double nudged(double x) {
    const std::int64_t steps = random.uniform_int(-2, 2);
    for (std::int64_t i = 0; i < std::abs(steps); ++i)
      x = std::nextafter(x, steps < 0 ? -infinity : infinity);
    return x;
  }

  Random random{seed()};
};

int sign_of(const Rational& x) { return x.sign(); }

Rational det2(const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
  return a * d - b * c;
}

int orient2d_oracle(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  const Rational px = Rational(b.x) - Rational(a.x), py = Rational(b.y) - Rational(a.y);
  const Rational qx = Rational(c.x) - Rational(a.x), qy = Rational(c.y) - Rational(a.y);
  return sign_of(det2(px, py, qx, qy));
}

int orient3d_oracle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
  std::array<std::array<Rational, 3>, 3> m;
  const std::array<glm::dvec3, 3> points = {b, c, d};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          Rational(points[static_cast<std::size_t>(i)][j]) - Rational(a[j]);
    }
  }
  return sign_of(Rational(m[0][0] * det2(m[1][1], m[1][2], m[2][1], m[2][2]) -
                          m[0][1] * det2(m[1][0], m[1][2], m[2][0], m[2][2]) +
                          m[0][2] * det2(m[1][0], m[1][1], m[2][0], m[2][1])));
}

bool last_bit_is_zero(double x) { return std::bit_cast<std::uint64_t>(x) % 2 == 0; }

// Whether no double is nearer to the exact value, and a tie went to even
bool is_nearest(double rounded, const Rational& exact) {
  const Rational beyond = Rational(Integer(1) << 1024);  // what would follow the largest double
  const auto value = [&](double x) {
    return std::isinf(x) ? (x > 0 ? beyond : Rational(-beyond)) : Rational(x);
  };
  const double below = std::nextafter(rounded, -infinity), above = std::nextafter(rounded, infinity);
  const Rational lower_half = (value(below) + value(rounded)) / 2;
  const Rational upper_half = (value(above) + value(rounded)) / 2;
  const bool even = last_bit_is_zero(rounded);
  const bool above_lower = rounded == -infinity || (even ? exact >= lower_half : exact > lower_half);
  const bool below_upper = rounded == infinity || (even ? exact <= upper_half : exact < upper_half);
  return above_lower && below_upper;
}

// --- Orientation -----------------------------------------------------------------------------------------

// Kettner, Mehlhorn, Pion, Schirra, Yap, "Classroom examples of robustness problems in geometric
// computations", 2008, figure 2a: plain arithmetic scatters wrong signs over this grid.
TEST_F(ExactProperty, KettnerGrid) {
  const double u = 0x1p-53;
  const glm::dvec2 q(12, 12), r(24, 24);
  int in_doubt = 0, wrong_in_plain_arithmetic = 0;
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      const glm::dvec2 p(.5 + i * u, .5 + j * u);
      const int expected = (j > i) - (j < i);  // the line is y = x
      ASSERT_EQ(orient2d(p, q, r), expected) << i << ' ' << j;
      ASSERT_EQ(orient2d(q, r, p), expected) << i << ' ' << j;
      ASSERT_EQ(orient2d(q, p, r), -expected) << i << ' ' << j;
      in_doubt += orient2d_filtered(p, q, r) ? 0 : 1;
      const double plain = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
      wrong_in_plain_arithmetic += ((plain > 0) - (plain < 0)) != expected ? 1 : 0;
    }
  }
  EXPECT_GE(in_doubt, 50000);
  EXPECT_GE(wrong_in_plain_arithmetic, 1000);
}

// The same paper, figures 2b and 2c
TEST_F(ExactProperty, KettnerGridsOffTheDiagonal) {
  const double u = 0x1p-53;
  const std::array<std::array<glm::dvec2, 3>, 2> cases = {{
      {{{.50000000000002531, .5000000000000171},
        {17.300000000000001, 17.300000000000001},
        {24.00000000000005, 24.0000000000000517765}}},
      {{{.5, .5}, {8.8000000000000007, 8.8000000000000007}, {12.1, 12.1}}},
  }};
  int ran = 0, in_doubt = 0;
  for (const auto& [start, q, r] : cases) {
    for (int i = 0; i < 256; i += 3) {
      for (int j = 0; j < 256; j += 5) {
        const glm::dvec2 p = start + glm::dvec2(i * u, j * u);
        ASSERT_EQ(orient2d(p, q, r), orient2d_oracle(p, q, r)) << i << ' ' << j;
        in_doubt += orient2d_filtered(p, q, r) ? 0 : 1;
        ++ran;
      }
    }
  }
  EXPECT_EQ(ran, 2 * 86 * 52);
  EXPECT_GE(in_doubt, 5000);
}

TEST_F(ExactProperty, Orient2dNearlyOnALine) {
  int in_doubt = 0, zeros = 0;
  for (int i = 0; i < 10000; ++i) {
    SCOPED_TRACE(where(i));
    const std::int64_t size = random.uniform_int(-1070, 1020);
    const glm::dvec2 a{number(size - 3, size), number(size - 3, size)};
    const glm::dvec2 b{number(size - 3, size), number(size - 3, size)};
    const double t = random.unit() < 0.5 ? 0.5 : random.unit();
    const glm::dvec2 on_line = a * (1 - t) + b * t;
    const glm::dvec2 c(nudged(on_line.x), nudged(on_line.y));
    ASSERT_EQ(orient2d(a, b, c), orient2d_oracle(a, b, c));
    in_doubt += orient2d_filtered(a, b, c) ? 0 : 1;
    zeros += orient2d(a, b, c) == 0 ? 1 : 0;
  }
  EXPECT_GE(in_doubt, 5000);
  EXPECT_GE(zeros, 25);
}

// Products of a few units in the last place of the subnormals, rounded to whole ones
TEST_F(ExactProperty, Orient2dWhereProductsUnderflow) {
  int misleading = 0;
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(where(i));
    std::array<double, 6> x{};
    for (double& number : x) number = static_cast<double>(random.uniform_int(-12, 12)) * 0x1p-539;
    const glm::dvec2 a(x[0], x[1]), b(x[2], x[3]), c(x[4], x[5]);
    const int expected = orient2d_oracle(a, b, c);
    ASSERT_EQ(orient2d(a, b, c), expected);
    const double plain = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    misleading += ((plain > 0) - (plain < 0)) != expected ? 1 : 0;
  }
  EXPECT_GE(misleading, 100);
}

TEST_F(ExactProperty, Orient2dOverTheWholeRange) {
  int in_doubt = 0, sure = 0;
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(where(i));
    const glm::dvec2 a{any_number(), any_number()}, b{any_number(), any_number()},
        c{any_number(), any_number()};
    ASSERT_EQ(orient2d(a, b, c), orient2d_oracle(a, b, c));
    ASSERT_EQ(orient2d_exact(a, b, c), orient2d(a, b, c));
    ++(orient2d_filtered(a, b, c) ? sure : in_doubt);
  }
  EXPECT_GE(in_doubt, 500);
  EXPECT_GE(sure, 500);
}

TEST_F(ExactProperty, Orient3dNearlyInAPlane) {
  int in_doubt = 0;
  for (int i = 0; i < 10000; ++i) {
    SCOPED_TRACE(where(i));
    const std::int64_t size = random.uniform_int(-1070, 1020);
    const auto point = [&] {
      return glm::dvec3{number(size - 3, size), number(size - 3, size), number(size - 3, size)};
    };
    const glm::dvec3 a = point(), b = point(), c = point();
    const double s = random.unit() / 2, t = random.unit() / 2;
    const glm::dvec3 in_plane = a * (1 - s - t) + b * s + c * t;
    const glm::dvec3 d(nudged(in_plane.x), nudged(in_plane.y), nudged(in_plane.z));
    ASSERT_EQ(orient3d(a, b, c, d), orient3d_oracle(a, b, c, d));
    in_doubt += orient3d_filtered(a, b, c, d) ? 0 : 1;
  }
  EXPECT_GE(in_doubt, 5000);
}

TEST_F(ExactProperty, Orient3dOverTheWholeRange) {
  int in_doubt = 0, sure = 0;
  for (int i = 0; i < 1500; ++i) {
    SCOPED_TRACE(where(i));
    const std::int64_t lowest = random.uniform_int(-1080, 1000);
    const std::int64_t highest = random.uniform_int(lowest, 1023);
    std::array<glm::dvec3, 4> p{};
    for (glm::dvec3& point : p) {
      for (int axis = 0; axis < 3; ++axis) point[axis] = number(lowest, highest);
    }
    ASSERT_EQ(orient3d(p[0], p[1], p[2], p[3]), orient3d_oracle(p[0], p[1], p[2], p[3]));
    ASSERT_EQ(orient3d_exact(p[0], p[1], p[2], p[3]), orient3d(p[0], p[1], p[2], p[3]));
    ++(orient3d_filtered(p[0], p[1], p[2], p[3]) ? sure : in_doubt);
  }
  EXPECT_GE(in_doubt, 150);
  EXPECT_GE(sure, 150);
}

// --- Expansions ------------------------------------------------------------------------------------------

TEST_F(ExactProperty, ExpansionsAreExact) {
  int cancelled = 0;
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(where(i));
    const double a = number(-80, 80), b = number(-80, 80), c = number(-80, 80), d = number(-80, 80);
    const auto value =
        exact_sum(a, b) * exact_difference(c, d) - exact_product(a * c, random.unit() < .5 ? 1 : b);
    const auto minus_estimate = value - exact_sum(value.estimate(), 0);
    Rational exact = 0;
    for (std::size_t k = 0; k < value.size(); ++k) {
      ASSERT_NE(value[k], 0);
      ASSERT_TRUE(k == 0 || std::abs(value[k - 1]) < std::abs(value[k]));
      exact += Rational(value[k]);
    }
    ASSERT_EQ(value.sign(), sign_of(exact));
    ASSERT_TRUE(is_nearest(rounded(value), exact));
    cancelled += minus_estimate.sign() != 0 ? 1 : 0;

    const Rational product = (Rational(a) + Rational(b)) * (Rational(c) - Rational(d));
    const auto of_expansions = exact_sum(a, b) * exact_difference(c, d);
    ASSERT_EQ((of_expansions - of_expansions).sign(), 0);
    ASSERT_TRUE(is_nearest(rounded(of_expansions), product));
  }
  EXPECT_GE(cancelled, 4000);
}

// --- Quotients -------------------------------------------------------------------------------------------

TEST_F(ExactProperty, QuotientsOfSumsAreNearest) {
  int infinite = 0, subnormal = 0, zero = 0, normal = 0;
  for (int i = 0; i < 4000; ++i) {
    SCOPED_TRACE(where(i));
    // (a b - c d) / (e - f), now and then with much cancellation
    const double a = any_number(), b = any_number();
    const double c = random.unit() < 0.3 ? nudged(a) : any_number();
    const double d = random.unit() < 0.3 ? nudged(b) : any_number();
    const double e = number(-1080, 1023), f = random.unit() < 0.3 ? nudged(e) : any_number();
    if (e == f) continue;
    SumOfProducts<2> above;
    SumOfProducts<1> below;
    above.add(a, b);
    above.subtract(c, d);
    below.add(e);
    below.subtract(f);
    const Rational numerator = Rational(a) * Rational(b) - Rational(c) * Rational(d);
    const Rational exact = numerator / (Rational(e) - Rational(f));
    const double quotient = rounded_quotient(above, below);
    ASSERT_EQ(above.sign(), sign_of(numerator));
    ASSERT_TRUE(is_nearest(quotient, exact)) << quotient;
    ++(std::isinf(quotient) ? infinite : quotient == 0 ? zero : std::isnormal(quotient) ? normal : subnormal);
  }
  EXPECT_GE(infinite, 100);
  EXPECT_GE(zero, 100);
  EXPECT_GE(normal, 1000);
  EXPECT_GE(subnormal, 10);
}

TEST_F(ExactProperty, QuotientsGoToEvenOnTies) {
  int ties = 0, subnormal_ties = 0;
  for (int i = 0; i < 5000; ++i) {
    SCOPED_TRACE(where(i));
    // (2m + 1) k / (2 k) lies halfway between two doubles; a hair more or less does not
    const double m =
        static_cast<double>(random.uniform_int(std::int64_t{1} << 52, (std::int64_t{1} << 53) - 1));
    const double k = static_cast<double>(random.uniform_int(1, std::int64_t{1} << 53));
    const bool tiny = random.unit() < 0.5;
    const double scale = tiny ? 0x1p-1073 : 1;  // then k * scale may keep fewer digits: still a tie
    const std::int64_t hair = random.uniform_int(-1, 1);
    SumOfProducts<3> above, below;
    const double digits = tiny ? std::floor(m * 0x1p-20) : m;
    above.add(2 * digits, k, scale);
    above.add(k, scale);
    above.add(static_cast<double>(hair), 0x1p-1000, scale);
    below.add(2.0, k);
    const Rational exact = Rational(scale) *
                           ((2 * Rational(digits) + 1) * Rational(k) +
                            Rational(static_cast<double>(hair)) * Rational(0x1p-1000)) /
                           (2 * Rational(k));
    ASSERT_TRUE(is_nearest(rounded_quotient(above, below), exact));
    if (hair == 0) ++(tiny ? subnormal_ties : ties);
  }
  EXPECT_GE(ties, 500);
  EXPECT_GE(subnormal_ties, 500);
}

Rational to_rational(Int128 x) {
  const Integer high = static_cast<std::int64_t>(x >> 64), low = static_cast<std::uint64_t>(x);
  return Rational(Integer((high << 64) + low));
}

TEST_F(ExactProperty, QuotientsOfIntegersAreNearest) {
  int ran = 0;
  const auto any_integer = [&] {
    __extension__ typedef unsigned __int128 Uint128;
    const std::uint64_t high = random(), low = random();
    return static_cast<Int128>(Uint128{high} << 64 | low) >> random.uniform_int(0, 127);
  };
  for (int i = 0; i < 10000; ++i) {
    SCOPED_TRACE(where(i));
    const Int128 numerator = any_integer(), denominator = any_integer();
    if (denominator == 0) continue;
    ASSERT_TRUE(is_nearest(rounded_quotient(numerator, denominator),
                           to_rational(numerator) / to_rational(denominator)));
    const std::int64_t n = static_cast<std::int64_t>(numerator), d = static_cast<std::int64_t>(denominator);
    ASSERT_TRUE(d == 0 || is_nearest(rounded_quotient(n, d), Rational(n) / Rational(d)));
    ++ran;
  }
  EXPECT_GE(ran, 9000);
}

// The oracle itself can tell right from wrong
TEST_F(ExactProperty, TheOracleNoticesTheNextDouble) {
  const Rational third = Rational(1) / 3;
  EXPECT_TRUE(is_nearest(1.0 / 3, third));
  EXPECT_FALSE(is_nearest(std::nextafter(1.0 / 3, 1), third));
  EXPECT_FALSE(is_nearest(std::nextafter(1.0 / 3, 0), third));
  EXPECT_FALSE(is_nearest(largest, Rational(Integer(1) << 1024)));
  EXPECT_TRUE(is_nearest(infinity, Rational(Integer(1) << 1024)));
}

}  // namespace
}  // namespace gradus
