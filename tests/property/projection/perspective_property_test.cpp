// Perspective in float and double against the same in exact rationals: error bounds, what stays straight and
// what bends, and which depths a buffer tells apart.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/exact_scalar.hpp"
#include "core/random.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/perspective/perspective_notes.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::perspective {
namespace {

using test::seed;

std::string where(std::int64_t i) {
  return "GRADUS_SEED=" + std::to_string(seed()) + " case " + std::to_string(i);
}

template <class T>
class PerspectiveProperty : public ::testing::Test {
 protected:
  T positive(int reach = 12) {
    const int exponent = static_cast<int>(random.uniform_int(-reach, reach));
    return static_cast<T>(std::ldexp(random.uniform(1, 2), exponent));
  }
  T number(int reach = 12) {
    const double which = random.unit();
    if (which < 0.05) return T(0);
    const T size = positive(reach);
    return which < 0.5 ? -size : size;
  }
  static Exact unit() { return Exact(std::numeric_limits<T>::epsilon()) / Exact(2); }

  Random random{seed()};
};

using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PerspectiveProperty, Scalars);

TYPED_TEST(PerspectiveProperty, ProjectionStaysWithinTwoRoundings) {
  using T = TypeParam;
  const std::int64_t cases = test::cases(10'000, 500'000);
  std::int64_t seen = 0, behind = 0, in_plane = 0, rounded = 0;
  for (std::int64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(where(i));
    const ExactScope scope;
    const T x = this->number(), y = this->number(), d = this->positive();
    const T z = this->random.unit() < 0.1 ? d : this->number();
    const auto image = project(d, glm::vec<3, T>{x, y, z});
    const auto kept = keep_z(d, glm::vec<3, T>{x, y, z});
    ASSERT_EQ(image.has_value(), z > T(0));
    ASSERT_EQ(kept.has_value(), image.has_value());
    if (!image) {
      ++behind;
      continue;
    }
    ++seen;
    ASSERT_EQ(image->z, d);
    ASSERT_EQ(*kept, (glm::vec<3, T>{image->x, image->y, z}));
    if (z == d) {
      ++in_plane;
      ASSERT_EQ(*image, (glm::vec<3, T>{x, y, z}));
    }
    const ExactVec3 right = *project(Exact(d), ExactVec3{Exact(x), Exact(y), Exact(z)});
    const Exact bound = Exact(2) * this->unit() * (Exact(1) + this->unit());
    for (int k = 0; k < 2; ++k) {
      const Exact error = abs(Exact((*image)[k]) - right[k]);
      ASSERT_LE(error, bound * abs(right[k]));
      rounded += sign(error);
    }
  }
  EXPECT_GT(seen, cases / 3);
  EXPECT_GT(behind, cases / 3);
  EXPECT_GT(in_plane, cases / 20);
  EXPECT_GT(rounded, seen / 2);
}

TYPED_TEST(PerspectiveProperty, VanishingPointsStayWithinThreeRoundings) {
  using T = TypeParam;
  const std::int64_t cases = test::cases(10'000, 500'000);
  std::int64_t finite_ones = 0, parallel = 0;
  for (std::int64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(where(i));
    const ExactScope scope;
    const T x = this->number(), y = this->number(), z = this->number(), d = this->positive();
    if (x == T(0) && y == T(0) && z == T(0)) continue;
    const auto point = vanishing_point(matrix_onto(d), glm::vec<3, T>{x, y, z});
    const auto right = vanishing_point(matrix_onto(Exact(d)), ExactVec3{Exact(x), Exact(y), Exact(z)});
    ASSERT_EQ(point.has_value(), z != T(0));
    ASSERT_EQ(right.has_value(), z != T(0));
    (point ? finite_ones : parallel) += 1;
    if (!point) continue;
    // d x / z, by definition
    ASSERT_EQ(right->x, Exact(d) * Exact(x) / Exact(z));
    const Exact bound = Exact(3) * this->unit() * (Exact(1) + Exact(3) * this->unit());
    for (int k = 0; k < 2; ++k) {
      ASSERT_LE(abs(Exact((*point)[k]) - (*right)[k]), bound * abs((*right)[k]));
    }
  }
  EXPECT_GT(finite_ones, cases / 2);
  EXPECT_GT(parallel, cases / 40);
}

TYPED_TEST(PerspectiveProperty, TransformationAndDivisionStayWithinTheirBounds) {
  using T = TypeParam;
  const std::int64_t cases = test::cases(10'000, 500'000);
  std::int64_t at_near = 0, divided = 0;
  for (std::int64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(where(i));
    const ExactScope scope;
    const T near = this->positive(), far = near * (T(1) + this->positive(8));
    const T x_scale = this->positive(3), y_scale = this->positive(3);
    const Projection<T> p = projection_of(x_scale, y_scale, near, far);
    const T x = this->number(), y = this->number(), z = this->random.unit() < 0.1 ? near : this->number();
    const auto clip = transform(p, glm::vec<3, T>{x, y, z});
    const auto right =
        transform(Projection<Exact>{Exact(p.x_scale), Exact(p.y_scale), Exact(p.z_scale), Exact(p.z_offset)},
                  ExactVec3{Exact(x), Exact(y), Exact(z)});
    ASSERT_EQ(clip.w, z);
    ASSERT_LE(abs(Exact(clip.x) - right.x), this->unit() * abs(right.x));
    ASSERT_LE(abs(Exact(clip.y) - right.y), this->unit() * abs(right.y));
    ASSERT_LE(abs(Exact(clip.z) - right.z),
              this->unit() * (abs(Exact(p.z_scale) * Exact(z)) + abs(Exact(clip.z))));
    if (z == near) {
      ++at_near;
      ASSERT_EQ(clip.z, T(0));
    }
    if (z <= T(0)) continue;
    ++divided;
    const auto ndc = divide(clip);
    for (int k = 0; k < 3; ++k) {
      const Exact quotient = Exact(clip[k]) / Exact(clip.w);
      ASSERT_LE(abs(Exact(ndc[k]) - quotient), this->unit() * abs(quotient));
    }
  }
  EXPECT_GT(at_near, cases / 20);
  EXPECT_GT(divided, cases / 3);
}

class Straightness : public ::testing::Test {
 protected:
  Exact number() { return Exact{random.uniform_int(-40, 40), random.uniform_int(1, 7)}; }
  ExactVec3 before_eye() {
    const Exact x = number(), y = number(), z = Exact{random.uniform_int(1, 80), random.uniform_int(1, 7)};
    return {x, y, z};
  }
  static bool collinear(const ExactVec3& a, const ExactVec3& b, const ExactVec3& c) {
    return glm::cross(b - a, c - a) == ExactVec3{Exact(0), Exact(0), Exact(0)};
  }
  Random random{seed()};
};

TEST_F(Straightness, OneOverZKeepsLinesAndPlanesAndKeepingZBendsThem) {
  const std::int64_t cases = test::cases(3'000, 50'000);
  std::int64_t lines = 0, bent_lines = 0, planes = 0, bent_planes = 0;
  for (std::int64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(where(i));
    const ExactScope scope;
    const Exact near(random.uniform_int(1, 5), 2), far = near + Exact(random.uniform_int(1, 100));
    const auto p = projection_of(Exact(3, 2), Exact(2), near, far);
    const auto right = [&](ExactVec3 v) { return divide(transform(p, v)); };
    const auto bent = [&](ExactVec3 v) { return *keep_z(Exact(1), v); };
    const ExactVec3 a = before_eye(), b = before_eye(), c = before_eye();
    const Exact share(random.uniform_int(1, 8), 9), other(random.uniform_int(1, 4), 9);
    const ExactVec3 m = a + share * (b - a);
    ASSERT_TRUE(collinear(right(a), right(b), right(m)));
    ++lines;
    // Through the eye or parallel to the picture lines stay lines in both; all others bend with z' = z
    const bool through_eye = collinear(ExactVec3{Exact(0), Exact(0), Exact(0)}, a, b);
    const bool level = a.z == b.z;
    ASSERT_EQ(collinear(bent(a), bent(b), bent(m)), through_eye || level || a == b);
    bent_lines += !through_eye && !level;
    // A fourth point, inside the triangle of the three
    const ExactVec3 inside = a + share * other * (b - a) + (Exact(1) - share) * other * (c - a);
    ASSERT_EQ(orient3d(right(a), right(b), right(c), right(inside)), 0);
    ++planes;
    bent_planes += orient3d(bent(a), bent(b), bent(c), bent(inside)) != 0;
  }
  EXPECT_EQ(lines, cases);
  EXPECT_EQ(planes, cases);
  EXPECT_GT(bent_lines, cases * 9 / 10);
  EXPECT_GT(bent_planes, cases * 9 / 10);
}

TEST_F(Straightness, HowFarInterpolatedDepthIsOff) {
  // With z' = z too large by (z1 - z0)^2 / (2 (z0 + z1)) half-way between the images; with 1 / z exact
  const std::int64_t cases = test::cases(3'000, 50'000);
  std::int64_t checked = 0;
  for (std::int64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(where(i));
    const ExactScope scope;
    const ExactVec3 a = before_eye(), b = before_eye();
    const ExactVec3 pa = *keep_z(Exact(1), a), pb = *keep_z(Exact(1), b);
    if (pa.x == pb.x) continue;
    ++checked;
    // The point of the line whose image lies half-way between theirs: weights 1 / z
    const Exact weight = Exact(1) / a.z + Exact(1) / b.z;
    const ExactVec3 m = (a / a.z + b / b.z) / weight;
    const ExactVec3 pm = *keep_z(Exact(1), m);
    ASSERT_EQ(pm.x, (pa.x + pb.x) / Exact(2));
    const Exact off = interpolated_depth(pa, pb, pm.x) - m.z;
    ASSERT_EQ(off, (b.z - a.z) * (b.z - a.z) / (Exact(2) * (a.z + b.z)));
    const auto p = projection_of(Exact(1), Exact(1), Exact(1, 10), Exact(100));
    const auto right = [&](ExactVec3 v) { return divide(transform(p, v)); };
    ASSERT_EQ(interpolated_depth(right(a), right(b), right(m).x), right(m).z);
  }
  EXPECT_GT(checked, cases * 9 / 10);
}

TEST_F(Straightness, InDoublesDepthStaysOnTheLineToRounding) {
  // The measured error of a + b / z between corners, beside that of z' = z
  const std::int64_t cases = test::cases(100'000, 5'000'000);
  double worst = 0, worst_bent = 0;
  std::int64_t checked = 0;
  const Projection<double> p = projection_of(1.0, 1.0, 1.0, 100.0);
  for (std::int64_t i = 0; i < cases; ++i) {
    const double za = random.uniform(1, 100), zb = random.uniform(1, 100), share = random.unit();
    const dvec3 a{random.uniform(-0.9, -0.1) * za, 0, za}, b{random.uniform(0.1, 0.9) * zb, 0, zb};
    const dvec3 m = a + share * (b - a);
    const auto right = [&](dvec3 v) { return divide(transform(p, v)); };
    const dvec3 seen = right(m);
    worst = std::max(worst, std::abs(interpolated_depth(right(a), right(b), seen.x) - seen.z));
    const dvec3 bent = *keep_z(1.0, m);
    worst_bent = std::max(worst_bent, interpolated_depth(*keep_z(1.0, a), *keep_z(1.0, b), bent.x) - m.z);
    ++checked;
  }
  EXPECT_EQ(checked, cases);
  std::printf("1 / z: at most %.3g of [0, 1]; z' = z: up to %.4g of 99 units\n", worst, worst_bent);
  EXPECT_LE(worst, 32 * 0x1p-53);
  EXPECT_GT(worst_bent, 75);  // (sqrt 100 - sqrt 1)^2 = 81 is the limit
  EXPECT_LE(worst_bent, 81);
}

TEST(StoredDepthProperty, DepthsAStepApartAreToldApart) {
  Random random{seed()};
  const std::int64_t cases = test::cases(60'000, 3'000'000);
  constexpr DepthCurve curves[] = {DepthCurve::linear, DepthCurve::inverse, DepthCurve::reversed};
  constexpr DepthFormat formats[] = {DepthFormat::fixed24, DepthFormat::float32};
  std::int64_t apart = 0, together = 0;
  for (std::int64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(where(i));
    const DepthCurve curve = curves[i % 3];
    const DepthFormat format = formats[i / 3 % 2];
    const double near = std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(-8, 4)));
    const double far = near * std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(3, 20)));
    const double z = near * gradus::exp(random.unit() * gradus::log(far / near) * 0.98);
    const double step = separable_step(curve, format, near, far, z);
    ASSERT_GT(step, 0);
    // On the way the step may grow a little
    const double a = std::min(z, far), b = z + 1.05 * step;
    if (!(step < 0.01 * z) || b >= far) continue;
    const double next = separable_step(curve, format, near, far, b);
    const std::uint32_t low = stored(format, depth_of(curve, near, far, a));
    const std::uint32_t high = stored(format, depth_of(curve, near, far, z + 1.05 * std::max(step, next)));
    ++apart;
    if (curve == DepthCurve::reversed) {
      ASSERT_GT(low, high);
    } else {
      ASSERT_LT(low, high);
    }
    // A fifth of a step is mostly too little
    together += low == stored(format, depth_of(curve, near, far, a + 0.2 * step));
  }
  EXPECT_GT(apart, cases / 2);
  EXPECT_GT(together, apart / 2);
}

TEST(StoredDepthProperty, DoublesComputeTheCurvesToFiveRoundings) {
  Random random{seed()};
  const std::int64_t cases = test::cases(9'000, 300'000);
  double worst = 0;
  for (std::int64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(where(i));
    const ExactScope scope;
    const double near = random.uniform(0.01, 10), far = near * random.uniform(1.01, 1e6);
    const double z = std::clamp(random.uniform(near, far), near, far);
    for (const auto& [curve, roundings] :
         {std::pair{DepthCurve::linear, 3}, {DepthCurve::inverse, 5}, {DepthCurve::reversed, 5}}) {
      const Exact right = depth_of(curve, Exact(near), Exact(far), Exact(z));
      const Exact error = abs(Exact(depth_of(curve, near, far, z)) - right);
      const Exact unit(0x1p-53);
      ASSERT_LE(error, Exact(roundings) * unit * (Exact(1) + Exact(8) * unit) * right);
      if (error > Exact(0)) worst = std::max(worst, to_double(error / right) * 0x1p53);
    }
  }
  std::printf("largest error: %.2f rounding units\n", worst);
  EXPECT_GT(worst, 1);
}

}  // namespace
}  // namespace gradus::perspective
