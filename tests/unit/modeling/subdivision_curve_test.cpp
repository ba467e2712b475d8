// Known results, the same curve at every level, the step grammar, refusals.

#include "modeling/subdivision_curve/subdivision_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/record.hpp"

namespace gradus::subdivision_curve {
namespace {

using Polygon = Points<double>;
const Polygon angle{{0, 0}, {4, 0}, {4, 4}}, square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

template <class T>
std::vector<Parabola<T>> arcs_of(const std::vector<Point<T>>& polygon, Ends ends) {
  std::vector<Parabola<T>> arcs;
  limit<T>(polygon, ends, [&](const Parabola<T>& arc) { arcs.push_back(arc); });
  return arcs;
}

TEST(SubdivisionCurve, FirstRoundIsTheKnownOne) {  // G001-22
  EXPECT_EQ(chaikin<double>(angle, 1, Ends::open), (Polygon{{1, 0}, {3, 0}, {4, 1}, {4, 3}}));
  EXPECT_EQ(chaikin<double>(square, 1, Ends::closed),
            (Polygon{{1, 0}, {3, 0}, {4, 1}, {4, 3}, {3, 4}, {1, 4}, {0, 3}, {0, 1}}));
  EXPECT_EQ(chaikin<double>(angle, 0, Ends::open), angle);
}

TEST(SubdivisionCurve, CountsOfPointsDouble) {
  EXPECT_EQ(chaikin<double>(square, 5, Ends::closed).size(), 4u << 5);
  // An open polygon of n points has n - 1 edges
  EXPECT_EQ(chaikin<double>(angle, 5, Ends::open).size(), (1u << 5) + 2);
}

TEST(SubdivisionCurve, LimitsOfAPolygonAndOfItsRoundsAreOneCurve) {
  const ExactScope scope;
  using P = Point<Exact>;
  const std::vector<P> polygon{
      {Exact(0), Exact(0)}, {Exact(5), Exact(1)}, {Exact(3), Exact(7)}, {Exact(-2), Exact(3)}};
  for (const Ends ends : {Ends::open, Ends::closed}) {
    const auto arcs = arcs_of<Exact>(polygon, ends),
               finer = arcs_of<Exact>(chaikin<Exact>(polygon, 1, ends), ends);
    // Each corner leaves two, each with half of its arc
    ASSERT_EQ(finer.size(), 2 * arcs.size());
    const std::size_t turn =
        ends == Ends::closed ? 1 : 0;  // the first cut corner lies on the last arc's side
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      for (int half = 0; half < 2; ++half) {
        const std::size_t k =
            (2 * i + static_cast<std::size_t>(half) + 2 * finer.size() - turn) % finer.size();
        for (const double t : {0.0, 0.25, 0.5, 1.0})
          EXPECT_EQ(finer[k].at(Exact(t)), arcs[i].at(Exact((half + t) / 2))) << i << " " << half << " " << t;
      }
    }
  }
}

TEST(SubdivisionCurve, ArcsTouchTheMiddlesOfTheEdges) {
  const auto arcs = arcs_of<double>(square, Ends::closed);
  ASSERT_EQ(arcs.size(), 4u);
  EXPECT_EQ(arcs[1].from, (dvec2{2, 0}));
  EXPECT_EQ(arcs[1].control, (dvec2{4, 0}));
  EXPECT_EQ(arcs[1].to, (dvec2{4, 2}));
  EXPECT_EQ(arcs[1].at(0.5), (dvec2{3.5, 0.5}));
  EXPECT_EQ(arcs_of<double>(angle, Ends::open).size(), 1u);
}

TEST(SubdivisionCurve, EachRoundLeavesAQuarterOfTheDistance) {
  double before = distance_to_limit<double>(square, Ends::closed);
  EXPECT_DOUBLE_EQ(before, std::sqrt(0.5));
  for (int rounds = 1; rounds <= 8; ++rounds) {
    const double now = distance_to_limit<double>(chaikin<double>(square, rounds, Ends::closed), Ends::closed);
    EXPECT_DOUBLE_EQ(now, before / 4) << rounds;
    before = now;
  }
}

TEST(SubdivisionCurve, StepsFollowTheGrammarAndObservedEqualsUnobserved) {
  Recorder<EdgeCut<double>, RoundDone, Finished> seen;
  const Polygon points = chaikin<double>(angle, 2, Ends::open, seen);
  EXPECT_EQ(points, chaikin<double>(angle, 2, Ends::open));
  EXPECT_EQ(all<EdgeCut<double>>(seen).size(), 2u + 3u);
  EXPECT_EQ(all<RoundDone>(seen).size(), 2u);
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).points, std::ssize(points));
  EXPECT_TRUE(every<EdgeCut<double>>(seen, [](const EdgeCut<double>& e) {
    return e.q + e.r == e.whole.a + e.whole.b && 2.0 * (e.r - e.q) == e.whole.b - e.whole.a;
  }));
}

TEST(SubdivisionCurve, MistakesAreNamed) {
  const Polygon two{{0, 0}, {1, 1}}, lost{{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}, {2, 0}};
  const auto drop = [](const auto&) {};
  EXPECT_THROW(chaikin<double>(two, 1, Ends::open), ContractViolation);
  EXPECT_THROW(chaikin<double>(lost, 1, Ends::open), ContractViolation);
  EXPECT_THROW(chaikin<double>(angle, -1, Ends::open), ContractViolation);
  EXPECT_THROW(chaikin<double>(angle, 23, Ends::open), ContractViolation);
  EXPECT_THROW(limit<double>(two, Ends::closed, drop), ContractViolation);
  EXPECT_THROW(limit<double>(lost, Ends::closed, drop), ContractViolation);
}

}  // namespace
}  // namespace gradus::subdivision_curve
