// Known results, the step grammar, refusals, and what the page counts and measures. That all methods are one
// polynomial in exact arithmetic is a promise: tests/stress.

#include "modeling/bezier_curve/bezier_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "modeling/bezier_curve/bezier_curve_notes.hpp"
#include "modeling/bezier_curve/compensated.hpp"
#include "support/documented.hpp"

namespace gradus::bezier_curve {
namespace {

using Control = Points<2, double>;
using Point2 = Mixed<2, double>;
using Chord = Flattened<2, double>;

const Control s_curve{{0, 0}, {5, 15}, {15, 0}, {20, 15}};
constexpr const char* page = "docs/topics/modeling/bezier_curve.md";

dvec2 point_of(const Control& control, double t) { return de_casteljau<2, double>(control, t); }

Points<2, Exact> exactly(const Control& control) {
  Points<2, Exact> points;
  for (const dvec2 p : control) points.push_back({Exact(p.x), Exact(p.y)});
  return points;
}

TEST(BezierCurve, APointByHand) {
  EXPECT_EQ(point_of(s_curve, 0.5), (dvec2{10, 7.5}));
  EXPECT_EQ((bernstein<2, double>(s_curve, 0.5)), (dvec2{10, 7.5}));
  const ExactScope scope;
  const Exact t(2, 5);
  EXPECT_EQ((de_casteljau<2, Exact>(exactly(s_curve), t)), (Point<2, Exact>{Exact(194, 25), Exact(186, 25)}));
}

TEST(BezierCurve, HalvesAndAHigherDegreeByHand) {
  const auto [first, rest] = split<2, double>(s_curve, 0.5);
  EXPECT_EQ(first, (Control{{0, 0}, {2.5, 7.5}, {6.25, 7.5}, {10, 7.5}}));
  EXPECT_EQ(rest, (Control{{10, 7.5}, {13.75, 7.5}, {17.5, 7.5}, {20, 15}}));
  EXPECT_EQ((raise_degree<2, double>(s_curve)),
            (Control{{0, 0}, {3.75, 11.25}, {10, 7.5}, {16.25, 3.75}, {20, 15}}));
}

TEST(BezierCurve, EndsInSpaceAreTheEndPointsBitForBit) {
  const Points<3, float> space{{0.1f, 0.2f, 0.3f}, {1e30f, -1e30f, 7}, {-5, 1e-40f, 2}, {0.7f, 0.8f, 1e-45f}};
  EXPECT_EQ((de_casteljau<3, float>(space, 0)), space.front());
  EXPECT_EQ((de_casteljau<3, float>(space, 1)), space.back());
}

TEST(BezierCurve, StepsFollowTheGrammarAndObservedEqualsUnobserved) {
  Recorder<Point2, Weighed<2, double>, Reached<2, double>, Halves<2, double>, Raised<2, double>, Chord,
           Halved<2, double>, Finished>
      seen;
  const auto types = [&] {
    std::vector<std::size_t> counts(8);
    for (const auto& event : seen.events()) ++counts[event.step.index()];
    return counts;
  };
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ((de_casteljau<2, double>(s_curve, 0.4, seen)), point_of(s_curve, 0.4));
  EXPECT_EQ(types(), (Counts{6, 0, 1, 0, 0, 0, 0, 0}));
  EXPECT_TRUE(every<Point2>(seen, [](const Point2& m) { return m.point == (1 - 0.4) * m.a + 0.4 * m.c; }));
  EXPECT_EQ((bernstein<2, double>(s_curve, 0.4, seen)), (bernstein<2, double>(s_curve, 0.4)));
  EXPECT_EQ(types(), (Counts{6, 4, 2, 0, 0, 0, 0, 0}));
  EXPECT_EQ((split<2, double>(s_curve, 0.4, seen).first), (split<2, double>(s_curve, 0.4).first));
  EXPECT_EQ(types(), (Counts{12, 4, 2, 1, 0, 0, 0, 0}));
  EXPECT_EQ((raise_degree<2, double>(s_curve, seen)), (raise_degree<2, double>(s_curve)));
  EXPECT_EQ(types(), (Counts{12, 4, 2, 1, 3, 0, 0, 1}));
  const Control line = flatten<2, double>(s_curve, 0.5, seen);
  EXPECT_EQ(line, (flatten<2, double>(s_curve, 0.5)));
  EXPECT_EQ(types(), (Counts{12, 4, 2, 1, 3, 6, 5, 2}));
  const std::vector<Chord> chords = all<Chord>(seen);
  for (std::size_t i = 0; i < chords.size(); ++i) {
    EXPECT_EQ(chords[i].piece.from, i == 0 ? 0 : chords[i - 1].piece.to);
    EXPECT_EQ(chords[i].piece.end(), line[i + 1]);
  }
}

TEST(BezierCurve, WhatRoundingsTakeIsKeptBesideEachPoint) {
  const Control zigzag{{0, 6}, {4, -6}, {8, 6}, {12, -6}, {16, 6}, {20, -6}};
  Recorder<Kept<2>, Reached<2, double>> seen;
  const dvec2 point = compensated<2>(zigzag, 0.49, seen);
  EXPECT_EQ(point, (compensated<2>(zigzag, 0.49)));
  EXPECT_EQ(all<Kept<2>>(seen).size(), 15u);
  const ExactScope scope;
  const auto right = de_casteljau<2, Exact>(exactly(zigzag), Exact(0.49));
  EXPECT_EQ(point, (dvec2{to_double(right.x), to_double(right.y)}));
  EXPECT_NE(point.y, point_of(zigzag, 0.49).y);
  // The points are those of the plain rounds, and each with its loss is nearly the exact one
  Points<2, Exact> round = exactly(zigzag);
  for (const Kept<2>& k : all<Kept<2>>(seen)) {
    EXPECT_EQ(k.mixed.point, (1 - 0.49) * k.mixed.a + 0.49 * k.mixed.c);
    Exact& y = round[k.mixed.i].y;
    y = (Exact(1) - Exact(0.49)) * y + Exact(0.49) * round[k.mixed.i + 1].y;
    EXPECT_LE(to_double(abs(Exact(k.mixed.point.y) + Exact(k.lost.y) - y)), 0x1p-98);
  }
}

TEST(BezierCurve, MistakesAreNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Control& control : {Control{{0, 0}}, Control(26), {{0, 0}, {nan, 1}}, {{0, 0}, {1e308, 1}}})
    EXPECT_THROW(point_of(control, 0.5), ContractViolation);
  for (const double t : {-0.1, 1.1, nan}) {
    EXPECT_THROW(point_of(s_curve, t), ContractViolation);
    EXPECT_THROW((bernstein<2, double>(s_curve, t)), ContractViolation);
    EXPECT_THROW((split<2, double>(s_curve, t)), ContractViolation);
    EXPECT_THROW((compensated<2>(s_curve, t)), ContractViolation);
  }
  EXPECT_THROW((raise_degree<2, double>(Control(25, dvec2{1}))), ContractViolation);
  EXPECT_THROW((compensated<2>(Control{{0, 0}, {0x1p901, 1}}, 0.5)), ContractViolation);
  for (const double tolerance : {0.0, -1.0, nan, 1e-8})
    EXPECT_THROW((flatten<2, double>(s_curve, tolerance)), ContractViolation);
}

// --- What the page counts and measures

TEST(BezierCurve, ExhibitsAreAsWrongAsThePageSays) {
  const double off = glm::distance(point_of(s_curve, 0.4), overwritten<2, double>(s_curve, 0.4));
  EXPECT_TRUE(test::states(page, "misses the point of the example by {}", {off}));
  EXPECT_EQ((middle_only<2, double>(s_curve, 0.5).size()), 2u);
  double most = 0;
  for (int k = 0; k <= 1000; ++k) {
    const dvec2 p = point_of(s_curve, k / 1000.0);
    most = std::max(most, std::abs(3 * p.x - 4 * p.y) / 5);  // from the chord's line
  }
  EXPECT_TRUE(test::states(page, "one chord, {} from the curve", {most}));
  const auto chords = [](double tolerance) {
    return static_cast<double>(flatten<2, double>(s_curve, tolerance).size() - 1);
  };
  EXPECT_TRUE(test::states(page, "The example within 0.5 takes {} chords and within 0.05 {} of them",
                           {chords(0.5), chords(0.05)}));
}

TEST(BezierCurve, RoundingsAreAsThePageMeasuredThem) {
  Random random(7);
  const auto most = [&](Index degree) {
    double off = 0;
    for (int i = 0; i < 400; ++i) {
      const ExactScope scope;
      Control control;
      for (Index k = 0; k <= degree; ++k) control.push_back({random.uniform(-1, 1), 0});
      const double t = random.unit(), found = point_of(control, t).x;
      const Exact right = de_casteljau<2, Exact>(exactly(control), Exact(t)).x;
      off = std::max(off, to_double(abs(Exact(found) - right)) / largest_of<2, double>(control) * 0x1p53);
    }
    return off;
  };
  const double cubic = most(3), twelfth = most(12);
  EXPECT_TRUE(test::states(
      page, "400 random curves are off by {} u M at most where the degree is 3, {} where it is 12",
      {cubic, twelfth}));
  EXPECT_LE(std::max(cubic, twelfth), 4);  // an ulp of M is at least u M
}

TEST(BezierCurve, CancelledDigitsAreLostOrKeptAsThePageMeasuredThem) {
  // The height of a zigzag of degree 5 is (1 - 2 t)^5
  double plain = 0, kept = 0;
  for (int k = 5; k <= 400; ++k) {
    const ExactScope scope;
    Control zigzag;
    for (int i = 0; i <= 5; ++i) zigzag.push_back({0, i % 2 == 0 ? 1 : -1});
    const double t = 0.5 + k / 1000.0;
    const Exact right = de_casteljau<2, Exact>(exactly(zigzag), Exact(t)).y;
    const double ulp = std::ldexp(0x1p-52, std::ilogb(to_double(right)));
    const auto off = [&](double found) { return to_double(abs(Exact(found) - right)) / ulp; };
    plain = std::max(plain, off(point_of(zigzag, t).y));
    kept = std::max(kept, off(compensated<2>(zigzag, t).y));
  }
  EXPECT_LE(kept, 4);
  EXPECT_TRUE(test::states(
      page, "plain points are off by up to {} units in their own last place, compensated ones by {}",
      {plain, kept}));
}

}  // namespace
}  // namespace gradus::bezier_curve
