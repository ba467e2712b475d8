// Forms, signs with roots and pairs of doubles against Boost's integers, rationals and wide floats.

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "core/form.hpp"
#include "core/random.hpp"
#include "core/two_doubles.hpp"
#include "support/seed.hpp"

namespace gradus {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<400, boost::multiprecision::digit_base_2>>;

class FormProperty : public ::testing::Test {
 protected:
  double number(int lowest, int highest) {
    const int exponent = static_cast<int>(random.uniform_int(lowest, highest));
    const double size = std::ldexp(random.uniform(1, 2), exponent);
    return random.unit() < 0.5 ? -size : size;
  }
  double small() { return static_cast<double>(random.uniform_int(-9, 9)); }

  Random random{test::seed()};
};

Rational exact(double x) { return Rational(x); }

/// 2^e
Rational power_of_two(int e) {
  const boost::multiprecision::cpp_int p = boost::multiprecision::cpp_int(1) << std::abs(e);
  return e < 0 ? Rational(1, p) : Rational(p);
}

TEST_F(FormProperty, PolynomialsAreExact) {
  int zeros = 0, wide = 0;
  constexpr int cases = 4000;
  for (int i = 0; i < cases; ++i) {
    // (a b - c d) e - f g h, often a difference of nearly or exactly equal products
    const int reach = i % 4 == 0 ? 1000 : 40;
    wide += reach == 1000;
    double n[8];
    for (double& x : n) x = i % 3 == 0 ? small() : number(-reach, reach);
    if (i % 5 == 0) n[2] = n[0], n[3] = n[1], n[5] = i % 10 == 0 ? 0 : n[5];
    const auto f = [&](int k) { return Form<1>(n[k]); };
    const Form<3> form = (f(0) * f(1) - f(2) * f(3)) * f(4) - f(5) * f(6) * f(7);
    const Rational right = (exact(n[0]) * exact(n[1]) - exact(n[2]) * exact(n[3])) * exact(n[4]) -
                           exact(n[5]) * exact(n[6]) * exact(n[7]);
    ASSERT_EQ(form.sign(), right.sign()) << "case " << i;
    zeros += right.sign() == 0;
    const Leading leading = form.leading();
    const Rational shown =
        (exact(leading.digits.value) + exact(leading.digits.error)) * power_of_two(leading.exponent);
    ASSERT_LE(abs(shown - right), abs(right) * power_of_two(-104)) << "case " << i;
    if (right.sign() != 0) {
      ASSERT_GE(std::abs(leading.digits.value), 0.5);
      ASSERT_LE(std::abs(leading.digits.value), 1);
    }
  }
  EXPECT_GE(zeros, cases / 20);
  EXPECT_GE(wide, cases / 8);
}

TEST_F(FormProperty, SignsWithRootsAreThoseOfWideFloats) {
  int zeros = 0, close = 0;
  constexpr int cases = 6000;
  for (int i = 0; i < cases; ++i) {
    double b = number(-20, 20), c = std::abs(number(-20, 20)), d = number(-20, 20),
           e = std::abs(number(-20, 20));
    double a = number(-20, 20);
    if (i % 4 == 0) b = small(), d = small(), c = std::pow(small(), 2), e = std::pow(small(), 2), a = small();
    // The nearest double to the two roots' sum: nearly zero
    if (i % 4 == 1) a = -(b * std::sqrt(c) + d * std::sqrt(e));
    if (i % 4 == 2) e = c * 4, d = -b / 2, a = i % 8 == 2 ? 0 : std::ldexp(a, -200);
    const Wide value = Wide(a) + Wide(b) * sqrt(Wide(c)) + Wide(d) * sqrt(Wide(e));
    const Wide size = abs(Wide(a)) + abs(Wide(b)) * sqrt(Wide(c)) + abs(Wide(d)) * sqrt(Wide(e));
    // Squares of numbers of at most 60 bits: what is not 0 is larger than this
    const int right = abs(value) <= size * pow(Wide(2), -350) ? 0 : value.sign();
    const Form<1> one(1);
    ASSERT_EQ(sign_with_roots(Form<1>(a) * one, Form<1>(b), Form<1>(c) * one, Form<1>(d), Form<1>(e) * one),
              right)
        << "case " << i;
    zeros += right == 0;
    close += right != 0 && abs(value) < size * pow(Wide(2), -50);
  }
  EXPECT_GE(zeros, cases / 20);
  EXPECT_GE(close, cases / 5);
}

TEST_F(FormProperty, PairsOfDoublesKeepTheirBounds) {
  constexpr int cases = 4000;
  for (int i = 0; i < cases; ++i) {
    const auto pair = [&] {
      const double value = number(-40, 40);
      return fast_two_sum(value, value * random.uniform(-1, 1) * 0x1p-54);
    };
    const Rounded a = pair(), b = pair();
    const auto value = [](Rounded x) -> Rational { return exact(x.value) + exact(x.error); };
    const Rational x = value(a), y = value(b);
    const auto near = [&](Rounded got, const Rational& right, const Rational& size, int bits) {
      return abs(value(got) - right) <= abs(size) * power_of_two(-bits);
    };
    ASSERT_TRUE(near(sum_of_pairs(a, b), x + y, abs(x) + abs(y), 102)) << i;
    ASSERT_TRUE(near(product_of_pairs(a, b), x * y, x * y, 101)) << i;
    ASSERT_TRUE(near(quotient_of_pairs(a, b), x / y, x / y, 99)) << i;
    const Rounded positive = a.value < 0 ? negated(a) : a;
    const Rounded root = root_of_pair(positive);
    // |root^2 - x| <= 2 root * root 2^-99
    ASSERT_TRUE(abs(value(root) * value(root) - abs(x)) <= abs(x) * power_of_two(-98)) << i;
  }
}

}  // namespace
}  // namespace gradus
