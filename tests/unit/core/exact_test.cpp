#include "core/arithmetic/exact.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

namespace gradus {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

// All of it lives on the stack
static_assert(std::is_trivially_copyable_v<Expansion<8>>);
static_assert(std::is_trivially_copyable_v<SumOfProducts<3>>);

static_assert(two_sum(1, 0x1p-60).value == 1 && two_sum(1, 0x1p-60).error == 0x1p-60);
static_assert(two_sum(0x1p-60, 1).error == 0x1p-60);
static_assert(fast_two_sum(1, 0x1p-60).error == 0x1p-60);
static_assert(two_difference(1, 0x1p-60).error == -0x1p-60);
static_assert(two_product(1 + 0x1p-52, 1 + 0x1p-52).value == 1 + 0x1p-51);
static_assert(two_product(1 + 0x1p-52, 1 + 0x1p-52).error == 0x1p-104);
static_assert((exact_product(0.1, 10) - exact_sum(1, 0)).sign() == 1, "0.1 is a little above a tenth");
static_assert(((exact_sum(0.1, 0.2) - exact_sum(0.3, 0)).sign()) == 1);

TEST(Expansion, KeepsOnlyPartsThatAreNotZero) {
  Expansion<4> sum;
  for (const double term : {1.0, 0x1p-80, -1.0}) sum.add(term);
  ASSERT_EQ(sum.size(), 1u);
  EXPECT_EQ(sum[0], 0x1p-80);
  EXPECT_EQ(sum.sign(), 1);
  sum.add(-0x1p-80);
  EXPECT_EQ(sum.size(), 0u);
  EXPECT_EQ(sum.sign(), 0);
  EXPECT_EQ(sum.estimate(), 0);
}

TEST(Expansion, MultipliesOut) {
  // (2^60 + 1) (2^60 - 1) = 2^120 - 1
  const auto product = exact_sum(0x1p60, 1) * exact_difference(0x1p60, 1);
  EXPECT_EQ((product - exact_difference(0x1p120, 1)).sign(), 0);
  EXPECT_EQ(product.sign(), 1);
  EXPECT_EQ((-product).sign(), -1);
  EXPECT_EQ(product.estimate(), 0x1p120);
}

TEST(Expansion, RefusesWhatItCannotHold) {
  EXPECT_THROW(exact_product(1e300, 1), ContractViolation);
  EXPECT_THROW(exact_product(1e200, 1e200), ContractViolation);
  EXPECT_THROW(exact_product(1e-200, 1e-200), ContractViolation);
  EXPECT_THROW(exact_sum(largest, largest), ContractViolation);
  EXPECT_THROW(exact_sum(infinity, 1), ContractViolation);
  EXPECT_THROW(exact_sum(not_a_number, 1), ContractViolation);
  Expansion<2> full = exact_sum(1, 0x1p-60);
  EXPECT_THROW(full.add(0x1p-120), ContractViolation);
}

TEST(SumOfProducts, HoldsTheWholeRange) {
  SumOfProducts<2> sum;
  sum.add(largest, largest);
  sum.add(smallest, smallest);
  EXPECT_EQ(sum.sign(), 1);
  sum.subtract(largest, largest);
  EXPECT_EQ(sum.sign(), 1);
  sum.subtract(smallest, smallest);
  EXPECT_EQ(sum.sign(), 0);
  sum.subtract(smallest, smallest);
  EXPECT_EQ(sum.sign(), -1);
  sum.add(-largest, -largest);
  EXPECT_EQ(sum.sign(), 1);
}

TEST(SumOfProducts, TakesFourFactors) {
  SumOfProducts<4> sum;
  sum.add(largest, largest, largest, largest);
  sum.subtract(smallest, smallest, smallest, smallest);
  EXPECT_EQ(sum.sign(), 1);
  sum.subtract(largest, -largest, largest, -largest);
  EXPECT_EQ(sum.sign(), -1);
  sum.add(-smallest, smallest, smallest, -smallest);
  EXPECT_EQ(sum.sign(), 0);
}

TEST(SumOfProducts, RefusesInfinitiesAndNan) {
  SumOfProducts<2> sum;
  EXPECT_THROW(sum.add(infinity), ContractViolation);
  EXPECT_THROW(sum.add(0.0, not_a_number), ContractViolation);
  EXPECT_THROW(sum.subtract(1.0, -infinity), ContractViolation);
}

TEST(NearestDouble, RoundsTiesToEven) {
  EXPECT_EQ(nearest_double(false, 0, 5, false), 0);
  EXPECT_EQ(nearest_double(true, 3, -1, false), -1.5);
  const std::uint64_t one = std::uint64_t{1} << 63;
  EXPECT_EQ(nearest_double(false, one + 1024, -63, false), 1);
  EXPECT_EQ(nearest_double(false, one + 1024, -63, true), 1 + 0x1p-52);
  EXPECT_EQ(nearest_double(false, one + 3 * 1024, -63, false), 1 + 0x1p-51);
  EXPECT_EQ(nearest_double(false, ~std::uint64_t{0}, -64, false), 1);
  EXPECT_THROW(nearest_double(false, 1, 0, true), ContractViolation);
}

TEST(NearestDouble, RoundsOnceAtBothEndsOfTheRange) {
  EXPECT_EQ(nearest_double(false, 1, -1074, false), smallest);
  EXPECT_EQ(nearest_double(false, 1, -1075, false), 0);
  EXPECT_EQ(nearest_double(false, 3, -1076, false), smallest);
  EXPECT_EQ(nearest_double(false, 3, -1075, false), 2 * smallest);
  EXPECT_EQ(nearest_double(false, 1, -1076, false), 0);
  EXPECT_TRUE(std::signbit(nearest_double(true, 1, -2000, false)));
  // Just below the smallest normal number: rounds up to it
  EXPECT_EQ(nearest_double(false, (std::uint64_t{1} << 54) - 1, -1076, false), 0x1p-1022);
  EXPECT_EQ(nearest_double(false, 1, 1024, false), infinity);
  // The largest double, and half a step more
  EXPECT_EQ(nearest_double(false, (std::uint64_t{1} << 54) - 2, 970, false), largest);
  EXPECT_EQ(nearest_double(true, (std::uint64_t{1} << 54) - 1, 970, false), -infinity);
}

TEST(RoundedQuotient, OfIntegers) {
  EXPECT_EQ(rounded_quotient(1, 3), 1.0 / 3.0);
  EXPECT_EQ(rounded_quotient(-6, 4), -1.5);
  EXPECT_EQ(rounded_quotient(0, -4), 0);
  EXPECT_FALSE(std::signbit(rounded_quotient(0, -4)));
  EXPECT_EQ(rounded_quotient((std::int64_t{1} << 53) + 1, std::int64_t{1}), 0x1p53) << "tie to even";
  EXPECT_EQ(rounded_quotient((std::int64_t{1} << 53) + 3, 1), 0x1p53 + 4) << "tie to even";
  EXPECT_EQ(rounded_quotient(std::numeric_limits<std::int64_t>::min(), -1), 0x1p63);
  EXPECT_EQ(rounded_quotient(std::numeric_limits<std::uint64_t>::max(), 1u), 0x1p64);
  EXPECT_THROW(rounded_quotient(1, 0), ContractViolation);
}

TEST(RoundedQuotient, OfWideIntegers) {
  const Int128 most = static_cast<Int128>(~static_cast<std::uint64_t>(0) >> 1) << 64 | ~std::uint64_t{0};
  const Int128 least = -most - 1;
  EXPECT_EQ(rounded_quotient(least, Int128{1}), -0x1p127);
  EXPECT_EQ(rounded_quotient(least, least), 1);
  EXPECT_EQ(rounded_quotient(Int128{1}, least), -0x1p-127);
  EXPECT_EQ(rounded_quotient(most, least), -1);
  // 2^100 + 2^47 is halfway between doubles; one more is not
  const Int128 tie = (Int128{1} << 100) + (Int128{1} << 47);
  EXPECT_EQ(rounded_quotient(tie, Int128{1}), 0x1p100);
  EXPECT_EQ(rounded_quotient(tie + 1, Int128{1}), 0x1p100 + 0x1p48);
}

TEST(RoundedQuotient, OfExpansions) {
  EXPECT_EQ(rounded_quotient(exact_sum(1, 0), exact_sum(3, 0)), 1.0 / 3.0);
  EXPECT_EQ(rounded_quotient(exact_difference(0.1, 0.2), exact_sum(-1, 0)), 0.1);
  // 1 + 2^-53 is halfway: to even; a trace more goes up
  EXPECT_EQ(rounded(exact_sum(1, 0x1p-53)), 1);
  EXPECT_EQ(rounded(exact_sum(1, 0x1p-53) + exact_sum(0x1p-1074, 0)), 1 + 0x1p-52);
  EXPECT_THROW(rounded_quotient(exact_sum(1, 0), exact_sum(0, 0)), ContractViolation);
}

TEST(RoundedQuotient, LeavesTheRangeAsIeee754Says) {
  SumOfProducts<2> square, one;
  SumOfProducts<1> tiny;
  square.add(-largest, largest);
  one.add(1.0);
  tiny.add(smallest);
  EXPECT_EQ(rounded_quotient(square, one), -infinity);
  EXPECT_EQ(rounded_quotient(square, square), 1);
  EXPECT_EQ(rounded_quotient(one, square), 0);
  EXPECT_TRUE(std::signbit(rounded_quotient(one, square)));
  EXPECT_EQ(rounded_quotient(square, tiny), -infinity);
  EXPECT_EQ(rounded_quotient(tiny, one), smallest);
}

TEST(Orient2d, KnowsLeftFromRight) {
  EXPECT_EQ(orient2d(glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)), 1);
  EXPECT_EQ(orient2d(glm::dvec2(0, 0), glm::dvec2(0, 1), glm::dvec2(1, 0)), -1);
  EXPECT_EQ(orient2d(glm::dvec2(0, 0), glm::dvec2(1, 1), glm::dvec2(3, 3)), 0);
  EXPECT_EQ(orient2d(glm::ivec2(-2147483647, 0), glm::ivec2(2147483647, 1), glm::ivec2(0, 0)), -1);
  EXPECT_EQ(orient2d(glm::vec2(0.1f, 0.1f), glm::vec2(0.2f, 0.2f), glm::vec2(0.3f, 0.3f)), 0);
}

// Kettner, Mehlhorn, Pion, Schirra, Yap, "Classroom examples of robustness problems in geometric
// computations", 2008, figure 2a: plain arithmetic scatters wrong signs over this grid
TEST(Orient2d, DecidesTheWholeOfKettnersGrid) {
  const glm::dvec2 q(12, 12), r(24, 24);
  int in_doubt = 0, misled = 0;
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      const glm::dvec2 p(.5 + i * 0x1p-53, .5 + j * 0x1p-53);
      const int expected = (j > i) - (j < i);  // the line is y = x
      ASSERT_EQ(orient2d(p, q, r), expected) << i << ' ' << j;
      in_doubt += orient2d_filtered(p, q, r) ? 0 : 1;
      const double plain = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
      misled += ((plain > 0) - (plain < 0)) != expected ? 1 : 0;
    }
  }
  EXPECT_GE(in_doubt, 50000);
  EXPECT_GE(misled, 1000);
}

TEST(Orient2d, DecidesOnGridsWithoutTheSlowPath) {
  EXPECT_EQ(orient2d_filtered({1, 7}, {5, 7}, {9, 7}), 0);
  EXPECT_EQ(orient2d_filtered({3, 3}, {3, 3}, {9, 7}), 0);
  EXPECT_EQ(orient2d_filtered({0, 0}, {4, 0}, {2, 1}), 1);
}

TEST(Orient3d, KnowsAboveFromBelow) {
  const glm::dvec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(orient3d(a, b, c, {5, 5, 1e-300}), 1);
  EXPECT_EQ(orient3d(a, b, c, {0, 0, -1}), -1);
  EXPECT_EQ(orient3d(a, b, c, {7, -3, 0}), 0);
  EXPECT_EQ(orient3d(a, c, b, {0, 0, 1}), -1);
  EXPECT_EQ(orient3d(glm::ivec3(0), glm::ivec3(1, 0, 0), glm::ivec3(0, 1, 0), glm::ivec3(0, 0, 1)), 1);
  EXPECT_EQ(orient3d(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(9, 9, 0)), 0);
}

}  // namespace
}  // namespace gradus
