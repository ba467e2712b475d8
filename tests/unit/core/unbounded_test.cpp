// Numbers without bounds: the bits of plain arithmetic where that stays in range, and the right result where
// it does not.

#include "core/unbounded.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/exact_scalar.hpp"
#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus {
namespace {

using Number = Unbounded<double>;

TEST(Unbounded, ComesBackIntoRange) {
  const Number huge(0x1.8p1000), tiny(0x1p-1074);
  EXPECT_EQ((huge * huge / huge).in_range(), 0x1.8p1000);
  EXPECT_EQ((tiny * tiny / tiny).in_range(), 0x1p-1074);
  EXPECT_EQ((huge * tiny * huge).in_range(), 0x1.2p927);
  EXPECT_EQ((huge * huge).in_range(), std::numeric_limits<double>::infinity());
  EXPECT_EQ((tiny * tiny).in_range(), 0);
  EXPECT_EQ((tiny / huge + huge).in_range(), 0x1.8p1000);
  EXPECT_EQ((huge * huge - huge * huge).in_range(), 0);
  EXPECT_TRUE(tiny * tiny > Number(0));
  EXPECT_TRUE(-(huge * huge) < -huge);
  EXPECT_FALSE(huge * huge < huge * huge);
  EXPECT_EQ(abs(-tiny).in_range(), 0x1p-1074);
}

TEST(Unbounded, OfAScalarWithoutARangeItIsTheNumberItself) {
  const ExactScope scope;
  EXPECT_EQ(in_range(unbounded(Exact(1, 3)) * unbounded(Exact(3))), Exact(1));
  EXPECT_EQ(in_range(unbounded(0.25f) / unbounded(2.0f)), 0.125f);
}

template <class T>
void expect_bits_of_plain_arithmetic() {
  Random random(test::seed());
  const int reach = std::numeric_limits<T>::max_exponent / 2 - 2;
  for (int i = 0; i < 20'000; ++i) {
    const auto number = [&] {
      if (random.unit() < 0.05) return T(random.unit() < 0.5 ? 0.0 : -0.0);
      const T size = std::ldexp(static_cast<T>(random.uniform(1, 2)),
                                static_cast<int>(random.uniform_int(-reach, reach)));
      return random.unit() < 0.5 ? -size : size;
    };
    T a = number(), b = number();
    if (i % 3 == 0) b = std::nextafter(-a, b);
    const auto same = [](T x, T y) { return x == y && std::signbit(x) == std::signbit(y); };
    const Unbounded<T> p(a), q(b);
    ASSERT_TRUE(same((p + q).in_range(), a + b)) << a << " + " << b;
    ASSERT_TRUE(same((p - q).in_range(), a - b)) << a << " - " << b;
    ASSERT_TRUE(same((p * q).in_range(), a * b)) << a << " * " << b;
    if (b != 0) ASSERT_TRUE(same((p / q).in_range(), a / b)) << a << " / " << b;
    ASSERT_EQ(p < q, a < b);
    ASSERT_EQ(p > q, a > b);
  }
}

TEST(Unbounded, HasTheBitsOfDouble) { expect_bits_of_plain_arithmetic<double>(); }
TEST(Unbounded, HasTheBitsOfFloat) { expect_bits_of_plain_arithmetic<float>(); }

}  // namespace
}  // namespace gradus
