// Forms of known value, at the ends of the range of double; signs with roots that cancel exactly.

#include "core/arithmetic/exact_polynomial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/arithmetic/two_doubles.hpp"

namespace gradus {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

double value_of(const Leading& x) { return std::ldexp(x.digits.value + x.digits.error, x.exponent); }

TEST(Form, SumsAndProductsOfSmallNumbers) {
  const Form<1> two(2), three(3), minus_five(-5);
  EXPECT_EQ(value_of((two * three).leading()), 6);
  EXPECT_EQ(value_of((two + three).leading()), 5);
  EXPECT_EQ(value_of((two * minus_five - three * three).leading()), -19);
  EXPECT_EQ((two + three + minus_five).sign(), 0);
  EXPECT_EQ((two + three + minus_five + Form<1>(0)).leading().digits.value, 0);
  EXPECT_EQ((-minus_five).sign(), 1);
  EXPECT_EQ((two * Form<1>(0)).sign(), 0);
  EXPECT_EQ(Form<1>(-0.0).sign(), 0);
}

TEST(Form, WholeRangeAtOnce) {
  // largest^4 - smallest^4, and what is left of the small one when the large one is gone
  const Form<1> big(largest), small(smallest);
  const Form<2> big2 = big * big, small2 = small * small;
  EXPECT_EQ((big2 * big2 - small2 * small2).sign(), 1);
  EXPECT_EQ((small2 * small2 - big2 * big2).sign(), -1);
  const Form<4> rest = big2 * big2 + small2 * small2 - big2 * big2;
  EXPECT_EQ(rest.sign(), 1);
  EXPECT_EQ(rest.leading().digits.value, 0.5);
  EXPECT_EQ(rest.leading().exponent, -4 * 1074 + 1);
  EXPECT_EQ((big2 * big2).leading().exponent, 4096);
  // Many terms of the largest size
  Form<1> many = big;
  for (int i = 0; i < 1000; ++i) many = many + big;
  for (int i = 0; i < 1001; ++i) many = many - big;
  EXPECT_EQ(many.sign(), 0);
  EXPECT_THROW(Form<1>{std::numeric_limits<double>::infinity()}, ContractViolation);
  EXPECT_THROW(Form<1>{std::numeric_limits<double>::quiet_NaN()}, ContractViolation);
}

TEST(Form, SelfAssignmentAndAliases) {
  Form<1> x(7);
  const Form<1>& same = x;
  x = same;
  EXPECT_EQ(value_of(x.leading()), 7);
  x = x - x;
  EXPECT_EQ(x.sign(), 0);
}

TEST(TwoDoubles, KnownValues) {
  const Rounded third = quotient_of_pairs({1, 0}, {3, 0});
  EXPECT_EQ(third.value, 1.0 / 3);
  EXPECT_NE(third.error, 0);
  const Rounded one = product_of_pairs(third, {3, 0});
  EXPECT_LE(std::abs(one.value - 1 + one.error), 0x1p-100);
  const Rounded root = root_of_pair({2, 0});
  EXPECT_EQ(root.value, std::sqrt(2.0));
  const Rounded rest = sum_of_pairs(product_of_pairs(root, root), {-2, 0});
  EXPECT_LE(std::abs(rest.value), 0x1p-98);
  EXPECT_EQ(root_of_pair({0, 0}).value, 0);
}

}  // namespace
}  // namespace gradus
