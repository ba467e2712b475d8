// Known results, the step grammar, refusals, and what the page counts and measures. That all methods are one
// curve in exact arithmetic is a promise: tests/stress.

#include "modeling/b_spline/b_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "modeling/b_spline/b_spline_notes.hpp"
#include "support/documented.hpp"

namespace gradus::b_spline {
namespace {

using Control = Points<2, double>;
using Knots = std::vector<double>;
using Plane = Spline<2, double>;

const Control control{{10, 7}, {20, 4}, {30, 12}, {0, 17}, {0, 3}, {30, 0}};
const Knots knots{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
const Plane example{control, knots};
constexpr const char* page = "docs/topics/modeling/b_spline.md";

TEST(BSpline, APointByHand) {
  const ExactScope scope;
  const Points<2, Exact> points{{10, 7}, {20, 4}, {30, 12}, {0, 17}, {0, 3}, {30, 0}};
  const std::vector<Exact> u{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
  const Spline<2, Exact> spline{points, u};
  const Point<2, Exact> right{Exact(3), Exact(792, 100)};
  EXPECT_EQ(de_boor(spline, Exact(12, 5)), right);
  EXPECT_EQ(basis(spline, Exact(12, 5)), right);
}

TEST(BSpline, PiecesByHand) {
  const Knots halves{0, 0, 0, 0, 1, 2, 2, 2, 2};
  const Control five{{0, 8}, {3, 0}, {7, 16}, {20, 14}, {23, 2}};
  const auto pieces = bezier_pieces(Plane{five, halves});
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].b, (Control{{0, 8}, {3, 0}, {5, 8}, {9.25, 11.5}}));
  EXPECT_EQ(pieces[1].b, (Control{{9.25, 11.5}, {13.5, 15}, {20, 14}, {23, 2}}));
  EXPECT_EQ(pieces[1].from, 1);
  EXPECT_EQ(pieces[1].to, 2);
}

TEST(BSpline, EndsAndFullKnotsAreControlPointsBitForBit) {
  const Knots often{0, 0, 0, 0.3, 0.3, 1, 1, 1};
  const Control five{{0.1, 7}, {1e300, 3}, {-4, 0.7}, {2, 5e-324}, {0.3, 9}};
  const Plane spline{five, often};
  EXPECT_EQ(de_boor(spline, 0.0), five[0]);
  EXPECT_EQ(de_boor(spline, 0.3), five[2]);
  EXPECT_EQ(de_boor(spline, 1.0), five[4]);
}

TEST(BSpline, WhereItJumpsThePieceThatBeginsCounts) {
  const Knots broken{0, 0, 1, 1, 2, 2};
  const Control four{{0, 0}, {1, 0}, {5, 5}, {6, 5}};
  EXPECT_EQ(de_boor(Plane{four, broken}, 1.0), four[2]);
  EXPECT_EQ(basis(Plane{four, broken}, 1.0), four[2]);
  const auto pieces = bezier_pieces(Plane{four, broken});
  EXPECT_EQ(pieces[0].b, (Control{four[0], four[1]}));
  EXPECT_EQ(pieces[1].b, (Control{four[2], four[3]}));
}

/// x^2 + y^2 = 1 at all these places, in rationals: the quarter of weights 1, 1, 2.
TEST(BSpline, AQuarterOfACircleIsExact) {
  const ExactScope scope;
  const Points<2, Exact> corner{{1, 0}, {1, 1}, {0, 1}};
  const std::vector<Exact> u{0, 0, 0, 1, 1, 1}, weights{1, 1, 2};
  for (int k = 0; k <= 60; ++k) {
    const auto p = nurbs<2, Exact>({corner, u}, weights, Exact(k, 60));
    EXPECT_EQ(p.x * p.x + p.y * p.y, Exact(1)) << k;
  }
}

/// Nine points round the unit circle, of these weights at the corners.
double off_circle(double weight) {
  const Control square{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  const Knots u{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
  std::vector<double> weights(9, 1);
  for (std::size_t i = 1; i < 9; i += 2) weights[i] = weight;
  double most = 0;
  for (int k = 0; k <= 4000; ++k) {
    const dvec2 p = nurbs<2, double>({square, u}, weights, k / 1000.0);
    most = std::max(most, std::abs(std::hypot(p.x, p.y) - 1));
  }
  return most;
}
TEST(BSpline, TheCircleIsAsRoundAsThePageSays) {
  EXPECT_TRUE(
      test::states(page, "at 4001 places within {} u of the circle", {off_circle(std::sqrt(0.5)) * 0x1p53}));
  EXPECT_TRUE(test::states(page, "up to {} % of the radius outside", {off_circle(1) * 100}));
}

TEST(BSpline, StepsFollowTheGrammarAndObservedEqualsUnobserved) {
  using Seen = Recorder<Mixed<2, double>, Reached<2, double>, Spread<double>, Weighed<2, double>,
                        Placed<2, double>, Inserted<2, double>, Finished>;
  const auto types = [](const Seen& seen) {
    std::string letters;
    for (const auto& event : seen.events()) letters += "MRSWPIF"[event.step.index()];
    return letters;
  };
  Seen boor, weights, one, all_of_them;
  EXPECT_EQ(de_boor(example, 2.4, boor), de_boor(example, 2.4));
  EXPECT_EQ(types(boor), "MMMMMMR");
  using Found = Mixed<2, double>;
  EXPECT_TRUE(every<Found>(boor, [](const Found& m) { return m.lo <= 2.4 && 2.4 < m.hi; }));
  EXPECT_EQ(basis(example, 2.4, weights), basis(example, 2.4));
  EXPECT_EQ(types(weights), "SSSWWWWR");
  EXPECT_EQ(insert_knot(example, 2.4, one).control, insert_knot(example, 2.4).control);
  EXPECT_EQ(types(one), "PPPI");
  EXPECT_EQ(bezier_pieces(example, all_of_them).size(), 3u);
  EXPECT_EQ(types(all_of_them), "PPIPIPPIPIF");
}

TEST(BSpline, MistakesAreNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const Control& points, const Knots& u, double t) {
    EXPECT_THROW(de_boor(Plane{points, u}, t), ContractViolation);
    EXPECT_THROW(basis(Plane{points, u}, t), ContractViolation);
    EXPECT_THROW(insert_knot(Plane{points, u}, t), ContractViolation);
  };
  for (const double t : {-0.1, 3.1, nan}) refused(control, knots, t);
  refused(control, {0, 1, 2}, 1);                       // too few
  refused({{0, 0}, {1, 1}}, {0, 0, 0, 1, 1}, 0.5);      // of degree 2, for which two points are too few
  refused(control, {0, 0, 0, 0, 2, 1, 3, 3, 3, 3}, 1);  // not in order
  refused(control, {0, 0, 0, 0, 0, 2, 3, 3, 3, 3}, 1);  // one five times
  refused(control, {0, 0, 0, 0, nan, 2, 3, 3, 3, 3}, 1);
  refused({{0, 0}, {1, 1}}, {0, 1, 1, 2}, 1);  // no span
  refused({{0, 0}, {nan, 1}, {1, 1}, {2, 2}, {3, 3}, {4, 4}}, knots, 1);
  EXPECT_THROW(insert_knot(example, 0.0), ContractViolation);  // there four times
  for (const double weight : {0.0, -1.0, 2000.0, nan}) {
    std::vector<double> weights(6, 1);
    weights[3] = weight;
    EXPECT_THROW((nurbs<2, double>(example, weights, 1.0)), ContractViolation);
  }
  EXPECT_THROW((nurbs<2, double>(example, Knots(5, 1), 1.0)), ContractViolation);
}

// --- What the page counts and measures

TEST(BSpline, ExhibitsAreAsWrongAsThePageSays) {
  const double off = glm::distance(de_boor(example, 2.4), own_span_only(example, 2.4));
  EXPECT_TRUE(test::states(page, "misses the point of the example by {}", {off}));
  EXPECT_EQ(half_open(example, 3.0), dvec2(0));
  EXPECT_EQ(half_open(example, 2.4), basis(example, 2.4));
}

TEST(BSpline, RoundingsAreAsThePageMeasuredThem) {
  Random random(7);
  const auto most = [&](Index degree) {
    double off = 0;
    for (int i = 0; i < 400; ++i) {
      const ExactScope scope;
      Control points;
      Knots u;
      for (Index k = 0; k <= degree; ++k) points.push_back({random.uniform(-1, 1), 0});
      for (Index k = 0; k < 2 * degree + 2; ++k) u.push_back(random.uniform(0, 8));
      std::ranges::sort(u);
      const double t = u[degree] + (u[degree + 1] - u[degree]) * random.unit();
      Points<2, Exact> exact_points;
      double size = 0;
      for (const dvec2 p : points)
        exact_points.push_back({Exact(p.x), Exact(p.y)}), size = std::max(size, std::abs(p.x));
      const std::vector<Exact> exact_knots(u.begin(), u.end());
      const Exact right = basis(Spline<2, Exact>{exact_points, exact_knots}, Exact(t)).x;
      off = std::max(off, to_double(abs(Exact(de_boor(Plane{points, u}, t).x) - right)) / size * 0x1p53);
    }
    return off;
  };
  const double cubic = most(3), fifth = most(5);
  EXPECT_TRUE(test::states(
      page, "400 random curves are off by {} u M at most where the degree is 3, {} where it is 5",
      {cubic, fifth}));
  EXPECT_LE(std::max(cubic, fifth), 4);  // an ulp of M is at least u M
}

}  // namespace
}  // namespace gradus::b_spline
