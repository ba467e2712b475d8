// Parallel projections in float and double against the same in exact rationals: error bounds, what is kept.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/exact_scalar.hpp"
#include "core/random.hpp"
#include "projection/parallel/parallel.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::parallel {
namespace {

using test::seed;

template <class T>
class ParallelProperty : public ::testing::Test {
 protected:
  using Vec3 = glm::vec<3, T>;

  /// Numbers of many sizes, now and then 0 or 1.
  T number(int reach = 20) {
    const double which = random.unit();
    if (which < 0.05) return T(0);
    if (which < 0.1) return T(1);
    const double size = std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(-reach, reach)));
    return static_cast<T>(random.unit() < 0.5 ? -size : size);
  }
  Vec3 point() {
    const T x = number(), y = number(), z = number();
    return {x, y, z};
  }
  std::string where(std::int64_t i) const {
    return "GRADUS_SEED=" + std::to_string(seed()) + " case " + std::to_string(i);
  }

  static ExactVec3 exact(Vec3 p) { return {Exact(p.x), Exact(p.y), Exact(p.z)}; }
  /// The rounding unit: 2^-24, 2^-53.
  static Exact unit() { return Exact(std::numeric_limits<T>::epsilon()) / Exact(2); }

  Random random{seed()};
};

using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ParallelProperty, Scalars);

TYPED_TEST(ParallelProperty, ObliqueStaysWithinItsBound) {
  using T = TypeParam;
  const std::int64_t cases = test::cases(10'000, 1'000'000);
  std::int64_t rounded = 0, in_plane = 0;
  for (std::int64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(this->where(i));
    const ExactScope scope;
    auto p = this->point();
    const T d = this->number(), a = this->number(3), b = this->number(3);
    if (this->random.unit() < 0.1) p.z = d;
    const auto image = oblique(d, Slant<T>{a, b}, p);
    ASSERT_EQ(image.z, d);
    if (p.z == d) {
      ++in_plane;
      ASSERT_EQ(image, p);
    }
    const ExactVec3 right = oblique(Exact(d), Slant<Exact>{Exact(a), Exact(b)}, this->exact(p));
    const Exact t = Exact(d) - Exact(p.z);
    const Exact slant[] = {Exact(a), Exact(b)};
    for (int k = 0; k < 2; ++k) {
      const Exact error = abs(Exact(image[k]) - right[k]);
      ASSERT_LE(error, this->unit() *
                           (abs(Exact(image[k])) + Exact(2) * (Exact(1) + this->unit()) * abs(t * slant[k])));
      rounded += sign(error);
    }
  }
  EXPECT_GT(rounded, cases / 2);
  EXPECT_GT(in_plane, cases / 20);
}

TYPED_TEST(ParallelProperty, AlongStaysWithinItsBoundAndInThePlane) {
  using T = TypeParam;
  const std::int64_t cases = test::cases(8'000, 1'000'000);
  std::int64_t checked = 0, refused = 0, rounded = 0;
  double worst = 0;
  for (std::int64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(this->where(i));
    const ExactScope scope;
    const Plane<T> plane{this->point(), this->number()};
    auto v = this->point();
    if (this->random.unit() < 0.3 && plane.normal.z != T(0)) {
      // Nearly parallel, or as parallel as T can say
      v.z = -(plane.normal.x * v.x + plane.normal.y * v.y) / plane.normal.z;
      if (this->random.unit() < 0.5)
        v.z += v.z * static_cast<T>(std::ldexp(1.0, -static_cast<int>(this->random.uniform_int(2, 20))));
    }
    const auto p = this->point();
    const ExactVec3 n = this->exact(plane.normal), direction = this->exact(v), at = this->exact(p);
    const Exact q = n.x * direction.x + n.y * direction.y + n.z * direction.z;
    const Exact s = abs(n.x * direction.x) + abs(n.y * direction.y) + abs(n.z * direction.z);
    if (!meets(plane, v)) {
      ++refused;
      ASSERT_LE(abs(q), Exact(20) * this->unit() * s);
      ASSERT_THROW(along(plane, v, p), ContractViolation);
      continue;
    }
    ++checked;
    const auto image = along(plane, v, p);
    const ExactVec3 right = along(Plane<Exact>{n, Exact(plane.offset)}, direction, at);
    ASSERT_EQ(n.x * right.x + n.y * right.y + n.z * right.z, Exact(plane.offset));
    const Exact size = abs(Exact(plane.offset)) + abs(n.x * at.x) + abs(n.y * at.y) + abs(n.z * at.z);
    for (int k = 0; k < 3; ++k) {
      const Exact error = abs(Exact(image[k]) - right[k]);
      const Exact slide = abs(direction[k]) * size * s / (q * q), stay = abs(at[k]);
      ASSERT_LE(error, this->unit() * (Exact(10) * slide + Exact(2) * stay));
      if (error > Exact(0)) {
        ++rounded;
        worst = std::max(worst, to_double(error / (this->unit() * (Exact(10) * slide + Exact(2) * stay))));
      }
    }
  }
  EXPECT_GT(checked, cases / 2);
  EXPECT_GT(refused, cases / 20);
  EXPECT_GT(rounded, checked);
  this->RecordProperty("largest_share_of_the_bound", std::to_string(worst));
  std::printf("largest share of the bound: %.3f\n", worst);
}

TEST(ParallelLaws, ParallelLinesAndSharesAreKept) {
  // In exact arithmetic: a + s (b - a) goes to a' + s (b' - a'), so parallels stay parallel and ratios stay
  Random random{seed()};
  const std::int64_t cases = test::cases(2'000, 50'000);
  std::int64_t checked = 0;
  for (std::int64_t i = 0; i < cases; ++i) {
    const ExactScope scope;
    const auto number = [&] { return Exact{random.uniform_int(-50, 50), random.uniform_int(1, 9)}; };
    const auto vector = [&] {
      const Exact x = number(), y = number(), z = number();
      return ExactVec3{x, y, z};
    };
    const Plane<Exact> plane{vector(), number()};
    const ExactVec3 v = vector(), a = vector(), b = vector(), move = vector();
    if (!meets(plane, v)) continue;
    ++checked;
    const Exact share = number();
    const ExactVec3 ia = along(plane, v, a), ib = along(plane, v, b);
    ASSERT_EQ(along(plane, v, a + share * (b - a)), ia + share * (ib - ia))
        << "seed " << seed() << " case " << i;
    // No diminution with distance: moved anywhere, the same figure
    ASSERT_EQ(along(plane, v, b + move) - along(plane, v, a + move), ib - ia);
    // Two depths, one picture
    ASSERT_EQ(along(plane, v, a + share * v), ia);
    ASSERT_EQ(along(plane, v, ia), ia);
    const auto m = matrix_of(plane, v);
    const auto by_matrix = m * glm::vec<4, Exact>(a.x, a.y, a.z, Exact(1));
    ASSERT_EQ(ExactVec3(by_matrix.x, by_matrix.y, by_matrix.z), ia);
    ASSERT_EQ(by_matrix.w, Exact(1));
  }
  EXPECT_GT(checked, cases * 9 / 10);
}

}  // namespace
}  // namespace gradus::parallel
