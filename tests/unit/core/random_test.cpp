#include "core/random.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace gradus {
namespace {

// The known-answer vectors of Random123 (Salmon et al. 2011), file kat_vectors, philox4x32 with 10 rounds
static_assert(philox4x32({0, 0, 0, 0}, {0, 0}) ==
              PhiloxBlock{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
static_assert(philox4x32({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}) ==
              PhiloxBlock{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
static_assert(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
              PhiloxBlock{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});

static_assert(std::uniform_random_bit_generator<Random>);
static_assert(Random(0).at(0) == 0xe169c58d6627e8d5);

TEST(Random, AtGivesWhatTheSequenceGives) {
  Random random(7, 3);
  const Random same = random;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    ASSERT_EQ(random.position(), i);
    ASSERT_EQ(random(), same.at(i));
  }
  random.seek(5);
  EXPECT_EQ(random(), same.at(5));
}

TEST(Random, SeedsStreamsAndChildrenDiffer) {
  std::set<std::uint64_t> first_numbers;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    first_numbers.insert(Random(i).at(0));
    first_numbers.insert(Random(0, i + 1).at(0));
    first_numbers.insert(Random(0).split(i).at(0));
    first_numbers.insert(Random(0, 1).split(i).at(0));
  }
  EXPECT_EQ(first_numbers.size(), 4000u);
}

TEST(Random, SplittingDoesNotMoveTheParentAndRepeats) {
  Random parent(11);
  const Random child = parent.split(4);
  EXPECT_EQ(parent.position(), 0u);
  parent();
  EXPECT_EQ(parent.split(4), child);
  EXPECT_EQ(child.position(), 0u);
}

TEST(Random, UnitStaysBelowOne) {
  Random random(1);
  double least = 1, greatest = 0, sum = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = random.unit();
    least = std::min(least, x);
    greatest = std::max(greatest, x);
    sum += x;
  }
  EXPECT_GE(least, 0);
  EXPECT_LT(greatest, 1);
  EXPECT_LT(least, 1e-4);
  EXPECT_GT(greatest, 1 - 1e-4);
  EXPECT_NEAR(sum / 100000, 0.5, 0.005);
}

TEST(Random, UniformNeverReturnsTheUpperEnd) {
  // One ulp wide: every number above the half would round to the upper end
  const double upper = 1 + 0x1p-52;
  Random random(2);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(random.uniform(1, upper), 1);
  // Adding an offset just below 1 to 1 rounds to 2
  for (int i = 0; i < 1000; ++i) {
    EXPECT_LT(random.uniform(0x1p53, 0x1p53 + 2), 0x1p53 + 2);
    EXPECT_LT(random.uniform(-0x1p-1074, 0), 0);
    EXPECT_LT(random.uniform(-2, -1), -1);
  }
  EXPECT_EQ(random.uniform_at(9, -3, 4), -3 + 7 * random.unit_at(9));
}

TEST(Random, UniformRefusesAnEmptyOrEndlessRange) {
  Random random(3);
  EXPECT_THROW(random.uniform(1, 1), ContractViolation);
  EXPECT_THROW(random.uniform(2, 1), ContractViolation);
  EXPECT_THROW(random.uniform(-1.7e308, 1.7e308), ContractViolation);
  EXPECT_THROW(random.uniform(0, std::numeric_limits<double>::quiet_NaN()), ContractViolation);
  EXPECT_THROW(random.uniform_int(1, 0), ContractViolation);
}

TEST(Random, IntegersReachBothEndsEvenly) {
  Random random(4);
  std::array<int, 7> count{};
  for (int i = 0; i < 70000; ++i) ++count[static_cast<std::size_t>(random.uniform_int(-3, 3) + 3)];
  // Chi-square with 6 degrees of freedom exceeds 22.5 once in a thousand
  double chi_square = 0;
  for (const int n : count) chi_square += (n - 10000.0) * (n - 10000.0) / 10000.0;
  EXPECT_LT(chi_square, 22.5);
}

TEST(Random, IntegersOfALargeRangeAreNotBiased) {
  // Of 3 * 2^62 numbers a plain remainder would give the lowest third twice as often
  const std::int64_t lower = std::numeric_limits<std::int64_t>::min();
  const std::int64_t upper = lower + 3 * (std::int64_t{1} << 61) - 1 + 3 * (std::int64_t{1} << 61);
  const std::int64_t third = lower + (std::int64_t{1} << 62);
  Random random(5);
  int in_lowest_third = 0;
  for (int i = 0; i < 30000; ++i) in_lowest_third += random.uniform_int(lower, upper) < third ? 1 : 0;
  EXPECT_NEAR(in_lowest_third, 10000, 400);
  EXPECT_GT(random.position(), 35000u) << "rejection was never reached";
}

TEST(Random, IntegersOfOneAndOfAllValues) {
  Random random(6);
  EXPECT_EQ(random.uniform_int(42, 42), 42);
  using Limits = std::numeric_limits<std::int64_t>;
  bool negative = false, positive = false;
  for (int i = 0; i < 100; ++i) {
    const std::int64_t x = random.uniform_int(Limits::min(), Limits::max());
    (x < 0 ? negative : positive) = true;
  }
  EXPECT_TRUE(negative && positive);
}

TEST(Random, ShuffleMakesEveryOrderOfThree) {
  Random random(8);
  std::set<std::vector<int>> orders;
  for (int i = 0; i < 200; ++i) {
    std::vector<int> items = {1, 2, 3};
    random.shuffle(items);
    EXPECT_EQ(std::accumulate(items.begin(), items.end(), 0), 6);
    orders.insert(items);
  }
  EXPECT_EQ(orders.size(), 6u);
  std::vector<int> none;
  random.shuffle(none);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace gradus
