// Segments of all kinds against windows of all kinds, and what exact rationals say of them.

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"
#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_batch.hpp"
#include "core/exact_scalar.hpp"
#include "core/record.hpp"
#include "support/clip_oracle.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::cohen_sutherland_2d {
namespace {

using test::ClipCase;
using test::ClipCases;
using test::error_in_ulp;
using test::exact_clip;
using test::is_nearest;
using test::Rational;
using test::same_bits;

class CohenSutherland2dProperty : public ::testing::Test {
 protected:
  void SetUp() override { RecordProperty("GRADUS_SEED", std::to_string(test::seed())); }
  std::string where(std::int64_t i) const {
    return "GRADUS_SEED=" + std::to_string(test::seed()) + " case " + std::to_string(i);
  }
  ClipCases cases{test::seed()};
};

// Watches a run: the cuts, and whether one needed exact arithmetic
struct Watcher {
  Segment<2, double> line;
  Rectangle<double> window;
  int cuts = 0;
  bool slow = false;

  void operator()(const Classified<double>&) {}
  void operator()(const Accepted<double>&) {}
  void operator()(const Rejected&) {}
  void operator()(const Cut<double>& cut) {
    ++cuts;
    const int axis = axis_of(cut.border), other = 1 - axis;
    slow |= test::is_slow_cut(line, axis, coordinate(window, cut.border));
    for (const double border : {window.lower[other], window.upper[other]}) {
      glm::dvec2 corner;
      corner[axis] = coordinate(window, cut.border);
      corner[other] = border;
      slow |= cut.to()[other] == border && !orient2d_filtered(line.a, line.b, corner);
    }
  }
};

TEST_F(CohenSutherland2dProperty, CorrectlyRoundedIsExact) {
  std::int64_t slow = 0, accepted = 0, cut = 0;
  std::array<int, 5> by_cuts{};
  const std::int64_t runs = test::cases(16000, 2000000);
  for (std::int64_t i = 0; i < runs; ++i) {
    SCOPED_TRACE(where(i));
    const ClipCase k = cases(static_cast<int>(i % ClipCases::kinds));
    Watcher watcher{k.line, k.window};
    const auto found = correctly_rounded(k.line, k.window, usual_order<2>(), watcher);
    const auto expected = exact_clip(k.line, k.window);
    ASSERT_EQ(found.has_value(), expected.has_value());
    ASSERT_LE(watcher.cuts, 4);
    ++by_cuts[static_cast<std::size_t>(watcher.cuts)];
    slow += watcher.slow ? 1 : 0;
    // (b, a) gives the reverse, clipping again changes nothing, no border comes first
    const auto back = correctly_rounded(test::reversed(k.line), k.window);
    ASSERT_TRUE(same_bits(found ? std::optional(test::reversed(*found)) : std::nullopt, back));
    ASSERT_TRUE(same_bits(
        found,
        correctly_rounded(k.line, k.window, {Border::top, Border::right, Border::left, Border::bottom})));
    if (!found) continue;
    ++accepted;
    cut += watcher.cuts ? 1 : 0;
    ASSERT_TRUE(same_bits(found, correctly_rounded(*found, k.window)));
    for (int axis = 0; axis < 2; ++axis) {
      const auto n = static_cast<std::size_t>(axis);
      ASSERT_TRUE(is_nearest(found->a[axis], expected->a[n])) << found->a[axis];
      ASSERT_TRUE(is_nearest(found->b[axis], expected->b[n])) << found->b[axis];
    }
    ASSERT_EQ(region_code(found->a, k.window) | region_code(found->b, k.window), 0);
  }
  RecordProperty("slow", std::to_string(slow));
  EXPECT_GE(slow, runs / 10);
  EXPECT_GE(accepted, runs / 5);
  EXPECT_GE(cut, runs / 6);
  EXPECT_GE(by_cuts[3], 60);
  EXPECT_GE(by_cuts[4], 5);
}

TEST_F(CohenSutherland2dProperty, CorrectlyRoundedInFloatToo) {
  int accepted = 0;
  for (std::int64_t i = 0; i < 8000; ++i) {
    SCOPED_TRACE(where(i));
    const int kinds[] = {0, 1, 2, 7};
    const ClipCase k = cases(kinds[i % 4]);
    const Segment<2, float> line{glm::vec2(k.line.a), glm::vec2(k.line.b)};
    const Rectangle<float> window{glm::vec2(k.window.lower), glm::vec2(k.window.upper)};
    const auto found = correctly_rounded(line, window);
    const auto expected = exact_clip(line, window);
    ASSERT_EQ(found.has_value(), expected.has_value());
    ASSERT_TRUE(same_bits(found ? std::optional(test::reversed(*found)) : std::nullopt,
                          correctly_rounded(test::reversed(line), window)));
    if (!found) continue;
    ++accepted;
    for (int axis = 0; axis < 2; ++axis) {
      const auto n = static_cast<std::size_t>(axis);
      ASSERT_TRUE(is_nearest(found->a[axis], expected->a[n]));
      ASSERT_TRUE(is_nearest(found->b[axis], expected->b[n]));
    }
    ASSERT_TRUE(same_bits(found, correctly_rounded(*found, window)));
  }
  EXPECT_GE(accepted, 1500);
}

// The taught form without rounding is right; so its errors below are those of arithmetic
TEST_F(CohenSutherland2dProperty, BothMethodsInRationalsAreTheDefinition) {
  int accepted = 0;
  for (std::int64_t i = 0; i < 2000; ++i) {
    SCOPED_TRACE(where(i));
    const ExactScope scope;
    const ClipCase k = cases(static_cast<int>(i % ClipCases::kinds));
    const auto exact = [](glm::dvec2 p) { return ExactVec2(Exact(p.x), Exact(p.y)); };
    const Segment<2, Exact> line{exact(k.line.a), exact(k.line.b)};
    const Rectangle<Exact> window{exact(k.window.lower), exact(k.window.upper)};
    const auto taught = cut_of_a_cut(line, window), careful = correctly_rounded(line, window);
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
  EXPECT_GE(accepted, 400);
}

// What a cut of a cut costs: segments with both ends in +-1000, windows of all sizes
TEST_F(CohenSutherland2dProperty, ACutOfACutIsOffByManyUlp) {
  int accepted = 0, off = 0;
  double worst = 0;
  const std::int64_t runs = test::cases(40000, 1000000);
  for (std::int64_t i = 0; i < runs; ++i) {
    const ClipCase k = cases(0);
    const auto found = cut_of_a_cut(k.line, k.window);
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
  }
  std::printf("accepted and cut %d, off by more than 1 ulp %d, worst %.0f ulp\n", accepted, off, worst);
  EXPECT_GE(accepted, runs / 5);
  EXPECT_GE(off, accepted / 5);
  EXPECT_GE(worst, 100);
}

// Segments aimed at corners: rounded arithmetic decides many of them wrongly, and may need more rounds
TEST_F(CohenSutherland2dProperty, ACutOfACutDecidesCornersWrongly) {
  int ran = 0, wrong = 0;
  for (std::int64_t i = 0; i < 20000; ++i) {
    const ClipCase k = cases(1);
    wrong +=
        cut_of_a_cut(k.line, k.window).has_value() != correctly_rounded(k.line, k.window).has_value() ? 1 : 0;
    ++ran;
  }
  std::printf("decided wrongly %d of %d\n", wrong, ran);
  EXPECT_EQ(ran, 20000);
  EXPECT_GE(wrong, 200);
}

// --- Many at once --------------------------------------------------------------------------------

// Runs `test` once for every kind of machine that this one can be
template <class Test>
int on_every_target(Test test) {
  int targets = 0;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    test();
    ++targets;
  }
  hwy::SetSupportedTargetsForTest(0);
  return targets;
}

std::vector<std::uint8_t> batched(std::span<const Segment<2, double>> lines, const Rectangle<double>& window,
                                  std::vector<Segment<2, double>>& clipped) {
  clipped.resize(lines.size());
  std::vector<std::uint8_t> accepted(lines.size());
  const std::size_t kept = clip_batch(lines, window, clipped, accepted);
  EXPECT_EQ(kept, static_cast<std::size_t>(std::count(accepted.begin(), accepted.end(), 1)));
  return accepted;
}

TEST_F(CohenSutherland2dProperty, TheBatchHasTheBitsOfTheScalarMethodOnEveryTarget) {
  std::int64_t ran = 0, kept = 0;
  const int targets = on_every_target([&] {
    for (int round = 0; round < 2000; ++round) {
      SCOPED_TRACE(where(round));
      // Lines of this kind with a window of this kind, in numbers that leave a rest
      const ClipCase first = cases(round);
      std::vector<Segment<2, double>> lines{first.line};
      while (lines.size() < static_cast<std::size_t>(round % 23)) lines.push_back(cases(round).line);
      if (round % 23 == 0) lines.clear();
      std::vector<Segment<2, double>> clipped;
      const auto accepted = batched(lines, first.window, clipped);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto line = correctly_rounded(lines[i], first.window);
        ASSERT_EQ(accepted[i], line.has_value());
        ASSERT_TRUE(same_bits(clipped[i], line ? *line : lines[i]));
        ++ran;
        kept += accepted[i];
      }
      // In place
      std::vector<std::uint8_t> again(lines.size());
      clip_batch(lines, first.window, lines, again);
      ASSERT_EQ(again, accepted);
      for (std::size_t i = 0; i < lines.size(); ++i) ASSERT_TRUE(same_bits(lines[i], clipped[i]));
    }
  });
  EXPECT_GE(targets, 2);
  EXPECT_GE(ran, 20000 * targets);
  EXPECT_GE(kept, 2000 * targets);
}

// The same lines, one window: as the pipeline and the benchmark use it
TEST_F(CohenSutherland2dProperty, ABatchOfManyLines) {
  std::vector<Segment<2, double>> lines;
  for (int i = 0; i < 20000; ++i) lines.push_back(cases(i % 50 == 49 ? 3 : 0).line);
  const Rectangle<double> window{{-300, -200}, {250, 400}};
  on_every_target([&] {
    std::vector<Segment<2, double>> clipped;
    const auto accepted = batched(lines, window, clipped);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto line = correctly_rounded(lines[i], window);
      ASSERT_EQ(accepted[i], line.has_value()) << i;
      ASSERT_TRUE(same_bits(clipped[i], line ? *line : lines[i])) << i;
    }
  });
}

TEST_F(CohenSutherland2dProperty, ABatchRefusesWhatTheScalarMethodRefuses) {
  on_every_target([&] {
    std::vector<Segment<2, double>> lines(9, Segment<2, double>{{1, 1}, {2, 2}}), clipped(9);
    std::vector<std::uint8_t> accepted(9);
    const Rectangle<double> ten{{0, 0}, {10, 10}};
    EXPECT_EQ(clip_batch(lines, ten, clipped, accepted), 9u);
    for (const std::size_t bad : {0u, 5u, 8u}) {
      for (int axis = 0; axis < 4; ++axis) {
        std::vector<Segment<2, double>> some = lines;
        (&some[bad].a.x)[axis] = axis % 2 ? std::nan("") : -std::numeric_limits<double>::infinity();
        EXPECT_THROW(clip_batch(some, ten, clipped, accepted), ContractViolation);
      }
    }
    EXPECT_THROW(clip_batch(lines, {{10, 0}, {0, 10}}, clipped, accepted), ContractViolation);
    EXPECT_THROW(clip_batch(lines, ten, std::span(clipped).first(8), accepted), ContractViolation);
    EXPECT_THROW(clip_batch(lines, ten, clipped, std::span(accepted).first(8)), ContractViolation);
  });
}

}  // namespace
}  // namespace gradus::cohen_sutherland_2d
