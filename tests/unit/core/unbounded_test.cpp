// Numbers without bounds: the bits of plain arithmetic where that stays in range, and the right result where
// it does not.

#include "core/arithmetic/unbounded.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/arithmetic/exact_scalar.hpp"

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

}  // namespace
}  // namespace gradus
