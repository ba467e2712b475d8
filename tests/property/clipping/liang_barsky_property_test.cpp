// Liang and Barsky's rectangle against exact rationals and against Cohen and Sutherland's.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"
#include "clipping/liang_barsky/liang_barsky.hpp"
#include "core/exact_scalar.hpp"
#include "support/clip_oracle.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::liang_barsky {
namespace {

using test::ClipCase;
using test::ClipCases;
using test::error_in_ulp;
using test::exact_clip;
using test::is_nearest;
using test::same_bits;

class LiangBarskyProperty : public ::testing::Test {
 protected:
  void SetUp() override { RecordProperty("GRADUS_SEED", std::to_string(test::seed())); }
  std::string where(std::int64_t i) const {
    return "GRADUS_SEED=" + std::to_string(test::seed()) + " case " + std::to_string(i);
  }
  ClipCases cases{test::seed() + 1};
};

// Whether the two ends, or the decision between two borders, needed exact arithmetic
bool is_slow(const ClipCase& k, const Span& span) {
  const auto& [line, window] = k;
  bool slow = false;
  for (const auto& border : {span.enter, span.leave}) {
    slow |= border && test::is_slow_cut(line, axis_of(*border), coordinate(window, *border));
  }
  if (span.enter && span.leave && axis_of(*span.enter) != axis_of(*span.leave)) {
    glm::dvec2 corner;
    corner[axis_of(*span.enter)] = coordinate(window, *span.enter);
    corner[axis_of(*span.leave)] = coordinate(window, *span.leave);
    slow |= !orient2d_filtered(line.a, line.b, corner);
  }
  return slow;
}

TEST_F(LiangBarskyProperty, CorrectlyRoundedIsExact) {
  std::int64_t slow = 0, accepted = 0, both = 0;
  const std::int64_t runs = test::cases(20000, 2000000);
  for (std::int64_t i = 0; i < runs; ++i) {
    SCOPED_TRACE(where(i));
    const ClipCase k = cases(static_cast<int>(i % ClipCases::kinds));
    int tested = 0;
    Span span;
    auto watch = [&](const auto& step) {
      if constexpr (requires { step.beyond; }) {
        ++tested;
        span = step.span;
      }
    };
    const auto found = correctly_rounded(k.line, k.window, usual_order<2>(), watch);
    const auto expected = exact_clip(k.line, k.window);
    ASSERT_EQ(found.has_value(), expected.has_value());
    ASSERT_LE(tested, 4);
    slow += is_slow(k, span) ? 1 : 0;
    // The rival method has the same bits; so has any order of the borders, and the other direction
    ASSERT_TRUE(same_bits(found, cohen_sutherland_2d::correctly_rounded(k.line, k.window)));
    ASSERT_TRUE(same_bits(
        found,
        correctly_rounded(k.line, k.window, {Border::top, Border::left, Border::bottom, Border::right})));
    ASSERT_TRUE(same_bits(found ? std::optional(test::reversed(*found)) : std::nullopt,
                          correctly_rounded(test::reversed(k.line), k.window)));
    if (!found) continue;
    ++accepted;
    both += span.enter && span.leave ? 1 : 0;
    ASSERT_TRUE(same_bits(found, correctly_rounded(*found, k.window)));
    for (int axis = 0; axis < 2; ++axis) {
      const auto n = static_cast<std::size_t>(axis);
      ASSERT_TRUE(is_nearest(found->a[axis], expected->a[n]));
      ASSERT_TRUE(is_nearest(found->b[axis], expected->b[n]));
    }
  }
  EXPECT_GE(slow, runs / 10);
  EXPECT_GE(accepted, runs / 5);
  EXPECT_GE(both, runs / 20);
}

TEST_F(LiangBarskyProperty, BothMethodsInRationalsAreTheDefinition) {
  int accepted = 0;
  for (std::int64_t i = 0; i < 1500; ++i) {
    SCOPED_TRACE(where(i));
    const ExactScope scope;
    const ClipCase k = cases(static_cast<int>(i % ClipCases::kinds));
    const auto exact = [](glm::dvec2 p) { return ExactVec2(Exact(p.x), Exact(p.y)); };
    const Segment<2, Exact> line{exact(k.line.a), exact(k.line.b)};
    const Rectangle<Exact> window{exact(k.window.lower), exact(k.window.upper)};
    const auto taught = parametric(line, window), careful = correctly_rounded(line, window);
    const auto rounded = correctly_rounded(k.line, k.window);
    ASSERT_EQ(taught.has_value(), rounded.has_value());
    ASSERT_EQ(careful.has_value(), rounded.has_value());
    if (!rounded) continue;
    ++accepted;
    ASSERT_EQ(*taught, *careful);
    for (int axis = 0; axis < 2; ++axis) {
      ASSERT_EQ(to_double(taught->a[axis]), rounded->a[axis]);
      ASSERT_EQ(to_double(taught->b[axis]), rounded->b[axis]);
    }
  }
  EXPECT_GE(accepted, 300);
}

// What rounded values of t cost
TEST_F(LiangBarskyProperty, TheParametricFormIsOffAndMayMissTheBorder) {
  int accepted = 0, off = 0, moved = 0;
  double worst = 0;
  const std::int64_t runs = test::cases(30000, 1000000);
  for (std::int64_t i = 0; i < runs; ++i) {
    const ClipCase k = cases(0);
    const auto found = parametric(k.line, k.window);
    const auto right = correctly_rounded(k.line, k.window);
    if (!found || !right || *right == k.line) continue;
    ++accepted;
    if (*found == *right) continue;
    const auto expected = *exact_clip(k.line, k.window);
    double most = 0;
    for (int axis = 0; axis < 2; ++axis) {
      const auto n = static_cast<std::size_t>(axis);
      most = std::max(
          {most, error_in_ulp(found->a[axis], expected.a[n]), error_in_ulp(found->b[axis], expected.b[n])});
    }
    off += most > 1 ? 1 : 0;
    worst = std::max(worst, most);
    const auto again = parametric(*found, k.window);
    moved += !again || *again != *found ? 1 : 0;
  }
  std::printf("accepted and cut %d, off by more than 1 ulp %d, worst %.0f ulp, another clip moves %d\n",
              accepted, off, worst, moved);
  EXPECT_GE(accepted, runs / 5);
  EXPECT_GE(off, accepted / 4);
  EXPECT_GE(worst, 100);
  EXPECT_GE(moved, accepted / 20);
}

}  // namespace
}  // namespace gradus::liang_barsky
