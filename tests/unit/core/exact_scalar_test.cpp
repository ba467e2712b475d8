#include "core/arithmetic/exact_scalar.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <thread>
#include <type_traits>

#include "core/contract.hpp"

namespace gradus {

// GoogleTest prints the number instead of the handle's bytes
void PrintTo(const Exact& x, std::ostream* out) { *out << to_string(x); }

namespace {

static_assert(std::is_trivially_copyable_v<Exact>);
static_assert(std::is_trivially_default_constructible_v<Exact>);
static_assert(std::totally_ordered<Exact>);

const double infinity = std::numeric_limits<double>::infinity();

TEST(ExactScalar, CountsWithoutRounding) {
  const ExactScope scope;
  EXPECT_EQ(Exact(1, 3) + Exact(1, 6), Exact(1, 2));
  EXPECT_EQ(Exact(1, 3) * 3, 1);
  EXPECT_EQ(Exact(2) / 3 - Exact(2, 3), 0);
  EXPECT_EQ(-Exact(2, 4), Exact(-1, 2));
  EXPECT_EQ(+Exact(7), 7);
  EXPECT_NE(Exact(0.1) + Exact(0.2), Exact(0.3));
  EXPECT_NE(Exact(0.1f), Exact(0.1));
  Exact x = 5;
  x += 1;
  x *= 2;
  x -= Exact(1, 2);
  x /= 23;
  EXPECT_EQ(x, Exact(1, 2));
}

TEST(ExactScalar, ZeroNeedsNoScope) {
  constexpr Exact zero{};
  EXPECT_EQ(zero, 0);
  EXPECT_EQ(zero, Exact(-0.0));
  EXPECT_EQ(to_string(zero), "0");
}

TEST(ExactScalar, TakesEveryIntegerAndFiniteDouble) {
  const ExactScope scope;
  EXPECT_EQ(to_string(Exact(std::numeric_limits<std::int64_t>::min())), "-9223372036854775808");
  EXPECT_EQ(to_string(Exact(std::numeric_limits<std::uint64_t>::max())), "18446744073709551615");
  EXPECT_EQ(to_double(Exact(5e-324)), 5e-324);
  EXPECT_EQ(to_double(Exact(-1.7e308)), -1.7e308);
  EXPECT_EQ(to_string(Exact(0.75f)), "3/4");
  EXPECT_THROW(Exact{infinity}, ContractViolation);
  EXPECT_THROW(Exact{std::nan("")}, ContractViolation);
}

TEST(ExactScalar, ShowsLowestTerms) {
  const ExactScope scope;
  EXPECT_EQ(to_string(Exact(6, -4)), "-3/2");
  EXPECT_EQ(to_string(Exact(6) / -4), "-3/2");
  EXPECT_EQ(to_string(Exact(-6, -4)), "3/2");
  EXPECT_EQ(to_string(Exact(8, 4)), "2");
  EXPECT_EQ(to_string(Exact(std::numeric_limits<std::int64_t>::min(), -1)), "9223372036854775808");
}

TEST(ExactScalar, ShowsEveryDigitOfLongNumbers) {
  const ExactScope scope;
  Exact power = 1, ten = 1;
  for (int i = 0; i < 200; ++i) power = power * 2;
  for (int i = 0; i < 36; ++i) ten = ten * 10;
  EXPECT_EQ(to_string(power), "1606938044258990275541962092341162602522202993782792835301376");
  EXPECT_EQ(to_string(-power), "-" + to_string(power));
  // Blocks of 18 digits with nothing but zeros, and the numbers around them
  EXPECT_EQ(to_string(ten), "1" + std::string(36, '0'));
  EXPECT_EQ(to_string(ten - 1), std::string(36, '9'));
  EXPECT_EQ(to_string((ten + 1) / ten), "1" + std::string(35, '0') + "1/1" + std::string(36, '0'));
  EXPECT_EQ(to_string(Exact(1'000'000'000'000'000'000)), "1" + std::string(18, '0'));
}

TEST(ExactScalar, RefusesDivisionByZero) {
  const ExactScope scope;
  EXPECT_THROW(Exact(1, 0), ContractViolation);
  EXPECT_THROW(Exact(1) / 0, ContractViolation);
  EXPECT_THROW(Exact(1) / (Exact(1, 3) * 3 - 1), ContractViolation);
}

TEST(ExactScalar, Orders) {
  const ExactScope scope;
  EXPECT_LT(Exact(1, 3), Exact(0.34));
  EXPECT_GT(Exact(1, 3), Exact(0.33));
  EXPECT_LE(Exact(1, 3), Exact(2, 6));
  EXPECT_LT(Exact(-1), 0);
  EXPECT_EQ(sign(Exact(-1, 7)), -1);
  EXPECT_EQ(sign(Exact(0)), 0);
  EXPECT_EQ(abs(Exact(-1, 7)), Exact(1, 7));
}

TEST(ExactScalar, FloorAndCeilGoTheRightWayBelowZero) {
  const ExactScope scope;
  EXPECT_EQ(floor(Exact(7, 2)), 3);
  EXPECT_EQ(ceil(Exact(7, 2)), 4);
  EXPECT_EQ(floor(Exact(-7, 2)), -4);
  EXPECT_EQ(ceil(Exact(-7, 2)), -3);
  EXPECT_EQ(floor(Exact(-3)), -3);
  EXPECT_EQ(ceil(Exact(-3)), -3);
  const std::int64_t most = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(floor(Exact(most) + Exact(1, 2)), most);
  EXPECT_THROW(ceil(Exact(most) + Exact(1, 2)), ContractViolation);
  EXPECT_THROW(floor(Exact(1e300)), ContractViolation);
}

TEST(ExactScalar, RoundsToTheNearestDoubleOnce) {
  const ExactScope scope;
  EXPECT_EQ(to_double(Exact(1, 3)), 1.0 / 3.0);
  EXPECT_EQ(to_double(Exact(-2, 3)), -2.0 / 3.0);
  EXPECT_EQ(static_cast<double>(Exact(5)), 5);
  EXPECT_EQ(to_double(Exact(1) + Exact(0x1p-53)), 1) << "tie to even";
  EXPECT_EQ(to_double(Exact(1) + Exact(0x1p-53) + Exact(0x1p-1000)), 1 + 0x1p-52);
  EXPECT_EQ(to_double(Exact(5e-324) / 2), 0) << "tie to even";
  EXPECT_EQ(to_double(Exact(5e-324) * 3 / 2), 1e-323);
  EXPECT_EQ(to_double(Exact(1e308) * 10), infinity);
  EXPECT_EQ(to_double(Exact(1e-308) * Exact(1e-308)), 0);
}

TEST(ExactScope, FreesWhatWasMadeInside) {
  const std::size_t before = exact_values_alive();
  Exact stale;
  {
    const ExactScope scope;
    stale = Exact(1, 3) + 1;
    EXPECT_EQ(exact_values_alive(), before + 3);
  }
  EXPECT_EQ(exact_values_alive(), before);
  EXPECT_THROW(to_double(stale), ContractViolation);
  // Its place is taken again, and still it is refused
  const ExactScope scope;
  for (int i = 0; i < 5; ++i) (void)Exact(i);
  EXPECT_THROW(to_double(stale), ContractViolation);
}

Exact harmonic_number(int n) {
  ExactScope scope;
  Exact sum = 0;
  for (int k = 1; k <= n; ++k) sum += Exact(1, k);
  return scope.leave_with(sum);
}

TEST(ExactScope, HandsAResultOut) {
  const ExactScope scope;
  const std::size_t before = exact_values_alive();
  const Exact sum = harmonic_number(20);
  EXPECT_EQ(to_string(sum), "55835135/15519504");
  EXPECT_EQ(exact_values_alive(), before + 1);
}

TEST(ExactScope, HandsSeveralResultsOut) {
  const ExactScope outer;
  std::array<Exact, 2> results{};
  {
    ExactScope inner;
    results = {Exact(1, 2), Exact(1, 3) + 1};
    inner.leave_with(results);
    EXPECT_THROW(inner.leave_with(results[0]), ContractViolation) << "only once";
  }
  EXPECT_EQ(results[0], Exact(1, 2));
  EXPECT_EQ(results[1], Exact(4, 3));
}

TEST(ExactScope, OnlyTheInnermostCanBeLeft) {
  ExactScope outer;
  const ExactScope inner;
  EXPECT_THROW(outer.leave_with(Exact(1)), ContractViolation);
}

TEST(ExactScope, ANumberOfAnotherThreadIsRefused) {
  const ExactScope scope;
  const Exact here = Exact(1, 3);
  bool refused = false, zero_valid = false;
  std::thread([&] {
    const Exact there = Exact(1, 3);
    (void)there;
    try {
      (void)to_double(here);
    } catch (const ContractViolation&) {
      refused = true;
    }
    zero_valid = Exact{} == 0;
  }).join();
  EXPECT_TRUE(refused);
  EXPECT_TRUE(zero_valid);
}

TEST(ExactInGlm, VectorsAndProducts) {
  const ExactScope scope;
  const glm::vec<2, Exact> a(Exact(1, 3), Exact(1, 2)), b(3, 4);
  EXPECT_EQ(glm::dot(a, b), 3);
  EXPECT_EQ((a + b * Exact(1, 2)).x, Exact(11, 6));
  EXPECT_EQ((-a / Exact(2)).y, Exact(-1, 4));
  EXPECT_TRUE(a == (glm::vec<2, Exact>(Exact(2, 6), 0.5)));

  const glm::vec<3, Exact> x(1, 0, 0), y(0, Exact(1, 3), 0);
  EXPECT_EQ(glm::cross(x, y).z, Exact(1, 3));
  EXPECT_EQ(glm::dot(glm::cross(x, y), x), 0);
  EXPECT_EQ(glm::dvec3(y).y, 1.0 / 3.0);
}

TEST(ExactInGlm, Matrices) {
  const ExactScope scope;
  const glm::mat<2, 2, Exact> m2(Exact(1, 2), Exact(1, 3), Exact(1, 4), Exact(1, 5));
  EXPECT_EQ(glm::determinant(m2), Exact(1, 60));
  EXPECT_TRUE((m2 * glm::inverse(m2) == glm::mat<2, 2, Exact>(1)));

  // Hilbert's matrix, hopeless in floating point
  glm::mat<3, 3, Exact> hilbert(1);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) hilbert[i][j] = Exact(1, i + j + 1);
  }
  EXPECT_EQ(glm::determinant(hilbert), Exact(1, 2160));
  EXPECT_TRUE((hilbert * glm::inverse(hilbert) == glm::mat<3, 3, Exact>(1)));
  EXPECT_EQ(glm::transpose(hilbert)[2][1], Exact(1, 4));
  EXPECT_EQ((hilbert * glm::vec<3, Exact>(1, 1, 1)).x, Exact(11, 6));
}

TEST(ExactInGlm, OrientationAgreesWithDouble) {
  const ExactScope scope;
  const double u = 0x1p-53;
  const glm::dvec2 p(.5 + 2 * u, .5 + u), q(12, 12), r(24, 24);
  EXPECT_EQ(orient2d(ExactVec2(p), ExactVec2(q), ExactVec2(r)), orient2d(p, q, r));
  EXPECT_EQ(orient3d(ExactVec3(0), ExactVec3(1, 0, 0), ExactVec3(0, 1, 0), ExactVec3(0, 0, Exact(1, 3))), 1);
}

}  // namespace
}  // namespace gradus
