// Liang and Barsky's method in space against rationals and against region codes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"
#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "core/exact_scalar.hpp"
#include "support/box_cases.hpp"
#include "support/clip_oracle.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::liang_barsky {
namespace {

/// Whether the points or the order of the faces that the segment really crosses need exact arithmetic.
bool is_slow(const Segment<3, double>& line, const AxisBox<3, double>& box) {
  for (const Border face : usual_order<3>()) {
    const int axis = axis_of(face);
    const double c = coordinate(box, face), a = line.a[axis], b = line.b[axis];
    if (outside(line.a, box, face) == outside(line.b, box, face)) continue;
    for (const Border other : usual_order<3>()) {
      const int i = axis_of(other);
      const double d = coordinate(box, other);
      if (i == axis || outside(line.a, box, other) == outside(line.b, box, other)) continue;
      if (!orient2d_filtered({a, line.a[i]}, {b, line.b[i]}, {c, d})) return true;
    }
    for (int i = 0; i < 3; ++i) {
      if (i == axis || line.a[i] == line.b[i] || c == a || c == b) continue;
      if (!cut_coordinate_filtered(a, b, line.a[i], line.b[i], c)) return true;
    }
  }
  return false;
}

TEST(LiangBarskyBoxProperty, AgreesWithRationalsAndRegionCodes) {
  test::BoxCases cases(test::seed() + 10);
  const auto wanted = test::cases(8'000, 400'000);
  std::int64_t ran = 0, kept = 0, slow = 0;
  for (; ran < wanted; ++ran) {
    const auto [line, box] = cases(static_cast<int>(ran % 8));
    const auto part = box_correctly_rounded(line, box);
    slow += is_slow(line, box);
    ASSERT_EQ(part, cohen_sutherland_3d::correctly_rounded(line, box)) << "case " << ran;
    const auto exact = test::exact_clip(line, box);
    ASSERT_EQ(part.has_value(), exact.has_value()) << "case " << ran;
    const auto back = box_correctly_rounded(test::reversed(line), box);
    ASSERT_EQ(back.has_value(), part.has_value()) << "case " << ran;
    BoxOrder order = usual_order<3>();
    std::rotate(order.begin(), order.begin() + ran % 6, order.end());
    ASSERT_EQ(box_correctly_rounded(line, box, order), part) << "case " << ran;
    if (!part) continue;
    ++kept;
    ASSERT_EQ(test::reversed(*back), *part) << "case " << ran;
    ASSERT_TRUE(test::same_bits(box_correctly_rounded(*part, box), part)) << "case " << ran;
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_TRUE(test::is_nearest(part->a[static_cast<int>(i)], exact->a[i])) << "case " << ran;
      ASSERT_TRUE(test::is_nearest(part->b[static_cast<int>(i)], exact->b[i])) << "case " << ran;
    }
  }
  std::printf("%lld boxes, %lld parts, %lld on the slow path\n", static_cast<long long>(ran),
              static_cast<long long>(kept), static_cast<long long>(slow));
  EXPECT_EQ(ran, wanted);
  EXPECT_GT(kept, ran / 4);
  EXPECT_GT(slow, ran / 10);
}

// What docs/topics/clipping/liang_barsky.md says about rounded values of t
TEST(LiangBarskyBoxProperty, MeasuredErrorOfRoundedValues) {
  test::BoxCases cases(test::seed() + 11);
  const auto wanted = test::cases(10'000, 300'000);
  std::int64_t cut = 0, off = 0, beside = 0, wrong = 0;
  double worst = 0;
  for (std::int64_t i = 0; i < wanted; ++i) {
    const auto [line, box] = cases.ordinary();
    const auto part = box_parametric(line, box);
    const auto exact = test::exact_clip(line, box);
    if (!part || !exact || *part == line) continue;
    ++cut;
    double error = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      error = std::max({error, test::error_in_ulp(part->a[static_cast<int>(j)], exact->a[j]),
                        test::error_in_ulp(part->b[static_cast<int>(j)], exact->b[j])});
    }
    off += error > 1;
    worst = std::max(worst, error);
    beside += (cohen_sutherland_3d::region_code(part->a, box) |
               cohen_sutherland_3d::region_code(part->b, box)) != 0;
  }
  for (std::int64_t i = 0; i < wanted; ++i) {
    const auto [line, box] = cases(1);
    wrong += box_parametric(line, box).has_value() != box_correctly_rounded(line, box).has_value();
  }
  const auto percent = [](std::int64_t a, std::int64_t b) {
    return 100.0 * static_cast<double>(a) / static_cast<double>(b);
  };
  std::printf(
      "rounded t: of %lld segments cut %.1f %% are off by more than 1 ulp, worst %.0f ulp, %.1f %% end "
      "outside "
      "of the box; past an edge %.1f %% are decided wrongly\n",
      static_cast<long long>(cut), percent(off, cut), worst, percent(beside, cut), percent(wrong, wanted));
  EXPECT_GT(cut, wanted / 20);
  EXPECT_GT(off, cut / 4);
  EXPECT_GT(beside, cut / 50);
  EXPECT_GT(wrong, wanted / 100);
}

TEST(LiangBarskyBoxProperty, TheTextbookIsExactInRationals) {
  test::BoxCases cases(test::seed() + 12);
  const auto exactly = [](const glm::dvec3& p) { return ExactVec3(Exact(p.x), Exact(p.y), Exact(p.z)); };
  int kept = 0;
  for (int i = 0; i < 1'000; ++i) {
    const ExactScope scope;
    const auto [line, box] = cases(i % 8 == 5 ? 0 : i % 8);
    const auto part = box_correctly_rounded(line, box);
    const auto taught = box_parametric(Segment<3, Exact>{exactly(line.a), exactly(line.b)},
                                       AxisBox<3, Exact>{exactly(box.lower), exactly(box.upper)});
    ASSERT_EQ(taught.has_value(), part.has_value()) << "case " << i;
    if (!part) continue;
    ++kept;
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(to_double(taught->a[axis]), part->a[axis]) << "case " << i;
      ASSERT_EQ(to_double(taught->b[axis]), part->b[axis]) << "case " << i;
    }
  }
  EXPECT_GT(kept, 250);
}

}  // namespace
}  // namespace gradus::liang_barsky
