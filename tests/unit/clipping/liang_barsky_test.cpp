#include "clipping/liang_barsky/liang_barsky.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "core/record.hpp"

namespace gradus::liang_barsky {
namespace {

using Found = std::optional<Segment<2, double>>;

const Rectangle<double> ten{{0, 0}, {10, 10}};

Found taught(Segment<2, double> line, const Rectangle<double>& window = ten) {
  return parametric(line, window);
}
Found exact(Segment<2, double> line, const Rectangle<double>& window = ten) {
  return correctly_rounded(line, window);
}
Found left_over(double ax, double ay, double bx, double by) { return Segment<2, double>{{ax, ay}, {bx, by}}; }

TEST(LiangBarsky, GoldenLines) {
  for (const auto clip : {taught, exact}) {
    EXPECT_EQ(clip({{-5, 5}, {15, 5}}, ten), left_over(0, 5, 10, 5));     // G001-45
    EXPECT_EQ(clip({{5, 5}, {-5, 5}}, ten), left_over(5, 5, 0, 5));       // G001-46
    EXPECT_EQ(clip({{-5, -5}, {15, 15}}, ten), left_over(0, 0, 10, 10));  // G001-47
    EXPECT_EQ(clip({{-3, 12}, {5, 16}}, ten), std::nullopt);              // G001-49
    EXPECT_EQ(clip({{-5, 8}, {3, 20}}, ten), std::nullopt);               // G001-50
    EXPECT_EQ(clip({{-1, 1}, {1, -1}}, ten), left_over(0, 0, 0, 0));      // G001-52
    EXPECT_EQ(clip({{1, 2}, {3, 4}}, ten), left_over(1, 2, 3, 4));
  }
  EXPECT_EQ(exact({{-4, 3}, {6, 15}}), left_over(0, 7.8, 11.0 / 6, 10));  // G001-48
  EXPECT_EQ(exact({{5, 5}, {5, 20}}), left_over(5, 5, 5, 10));            // G001-51
  const Found found = taught({{-4, 3}, {6, 15}});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->a.y, 7.8, 1e-14);
  EXPECT_NEAR(found->b.x, 11.0 / 6, 1e-14);
  const Found vertical = taught({{5, 5}, {5, 20}});
  ASSERT_TRUE(vertical);
  EXPECT_NEAR(vertical->b.y, 10, 1e-14);
}

// The values that errata E001-26d gives for this line: t in [1/4, 3/4]
TEST(LiangBarsky, StepsFollowTheGrammar) {
  Recorder<Started<double>, Tested<double>, Accepted<double>, Rejected<double>> seen;
  parametric(Segment<2, double>{{-5, 5}, {15, 5}}, ten, usual_order<2>(), seen);
  ASSERT_EQ(seen.events().size(), 6u);
  EXPECT_EQ(all<Started<double>>(seen).at(0).d, (glm::dvec2{20, 0}));
  const auto tested = all<Tested<double>>(seen);
  ASSERT_EQ(tested.size(), 4u);
  EXPECT_EQ(tested[0].crossing, Crossing::enters);
  EXPECT_EQ(tested[0].p, -20);
  EXPECT_EQ(tested[0].q, -5);
  EXPECT_EQ(tested[0].t, 0.25);
  EXPECT_EQ(tested[1].crossing, Crossing::leaves);
  EXPECT_EQ(tested[1].t, 0.75);
  EXPECT_EQ(tested[2].crossing, Crossing::inside);
  EXPECT_EQ(tested[3].crossing, Crossing::inside);
  const auto accepted = all<Accepted<double>>(seen).at(0);
  EXPECT_EQ(accepted.enter, 0.25);
  EXPECT_EQ(accepted.leave, 0.75);
}

TEST(LiangBarsky, ALineOutsideIsFoundOutAtOnce) {
  Recorder<Started<double>, Tested<double>, Accepted<double>, Rejected<double>> seen;
  parametric(Segment<2, double>{{-5, 12}, {15, 12}}, ten,
             {Border::top, Border::bottom, Border::left, Border::right}, seen);
  ASSERT_EQ(all<Tested<double>>(seen).size(), 1u);
  EXPECT_EQ(all<Tested<double>>(seen)[0].crossing, Crossing::outside);
  EXPECT_EQ(all<Rejected<double>>(seen).size(), 1u);
}

TEST(LiangBarsky, BordersInTheOrderOfTheLine) {
  Recorder<Started<double>, Ordered<double>, Kept<double>, Missed> seen;
  correctly_rounded(Segment<2, double>{{-4, 3}, {6, 15}}, ten, usual_order<2>(), seen);
  const auto ordered = all<Ordered<double>>(seen);
  ASSERT_EQ(ordered.size(), 4u);
  EXPECT_EQ(ordered[0].span.enter, Border::left);
  EXPECT_EQ(ordered[1].span.leave, std::nullopt);  // b is left of the right border
  EXPECT_EQ(ordered[3].span.leave, Border::top);
  EXPECT_EQ(all<Kept<double>>(seen).size(), 1u);
  Recorder<Started<double>, Ordered<double>, Kept<double>, Missed> missed;
  correctly_rounded(Segment<2, double>{{-5, 8}, {3, 20}}, ten, usual_order<2>(), missed);
  EXPECT_TRUE(all<Ordered<double>>(missed).back().beyond);
  EXPECT_EQ(all<Missed>(missed).size(), 1u);
}

TEST(LiangBarsky, ObservedEqualsUnobserved) {
  int steps = 0;
  auto count = [&](const auto&) { ++steps; };
  const auto order = usual_order<2>();
  for (const Segment<2, double> line :
       {Segment<2, double>{{-4, 3}, {6, 15}}, {{-5, 8}, {3, 20}}, {{1, 1}, {2, 2}}}) {
    EXPECT_EQ(parametric(line, ten, order, count), taught(line));
    EXPECT_EQ(correctly_rounded(line, ten, order, count), exact(line));
  }
  EXPECT_GE(steps, 20);
}

TEST(LiangBarsky, MistakesAreNamed) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const auto clip : {taught, exact}) {
    EXPECT_THROW(clip({{1, 1}, {2, 2}}, {{0, 10}, {10, 0}}), ContractViolation);
    EXPECT_THROW(clip({{1, 1}, {2, 2}}, {{-infinity, 0}, {10, 10}}), ContractViolation);
    EXPECT_THROW(clip({{1, 1}, {2, nan}}, ten), ContractViolation);
    EXPECT_THROW(clip({{infinity, 1}, {2, 2}}, ten), ContractViolation);
  }
}

// --- Numerical traps -----------------------------------------------------------------------------

TEST(LiangBarskyTraps, TheTaughtFormFallsIntoThem) {
  // A difference overflows
  EXPECT_NE(taught({{-1e308, 0}, {1e308, 10}}), left_over(0, 5, 10, 5));
  // The corner is missed by one step, but rounded values of t are equal
  EXPECT_TRUE(taught({{-1, 1}, {1, std::nextafter(-1.0, -2.0)}}));
  // -0.9 + t 1.2 with t = 0.75 rounded: the end comes to lie outside the face that it was cut at
  const Segment<3, double> tenths{{-0.9, 0.5, 0.5}, {0.3, 0.5, 0.5}};
  const AxisBox<3, double> unit_box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_LT(box_parametric(tenths, unit_box)->a.x, 0);
  EXPECT_EQ(box_correctly_rounded(tenths, unit_box)->a.x, 0);
}

// Putting a rounded t into the line leads beside the border, so that clipping again cuts again
TEST(LiangBarskyTraps, ARoundedValueMissesTheBorder) {
  const Segment<2, double> line{{-0.7, 0.1}, {2.9, 1.3}};
  const Found found = taught(line, {{0.1, 0}, {1, 1}});
  ASSERT_TRUE(found);
  EXPECT_NE(found->a.x, 0.1);
  EXPECT_EQ(exact(line, {{0.1, 0}, {1, 1}})->a.x, 0.1);
}

// --- In space ------------------------------------------------------------------------------------

using Piece = Segment<3, double>;
using Cube = AxisBox<3, double>;
using Watcher = Recorder<BoxStarted<double>, Tested<double>, BoxAccepted<double>, Rejected<double>>;
using ExactWatcher = Recorder<BoxStarted<double>, Ordered<double>, BoxKept<double>, Missed>;
using TestedFace = Tested<double>;
using OrderedFace = Ordered<double>;

const Cube unit{{0, 0, 0}, {1, 1, 1}};
const Cube ten_cubed{{0, 0, 0}, {10, 10, 10}};
const BoxOrder box_order = usual_order<3>();

TEST(LiangBarskyBox, GoldenSegment) {
  // G001-53, and its values of t
  const Piece line{{-1, 0.5, 0.25}, {2, 0.5, 1}};
  Watcher seen;
  const auto part = box_parametric(line, unit, box_order, seen);
  EXPECT_EQ(box_correctly_rounded(line, unit), part);
  EXPECT_EQ(part, (Piece{{0, 0.5, 0.5}, {1, 0.5, 0.75}}));
  const auto tested = all<TestedFace>(seen);
  ASSERT_EQ(tested.size(), 6u);
  EXPECT_EQ(tested[0].crossing, Crossing::enters);
  EXPECT_EQ(tested[0].t, 1.0 / 3);
  EXPECT_EQ(tested[1].crossing, Crossing::leaves);
  EXPECT_EQ(tested[1].t, 2.0 / 3);
  EXPECT_EQ(tested[2].crossing, Crossing::inside);
  EXPECT_EQ(tested[5].leave, 2.0 / 3);  // the far face would let it go on to t = 1
  EXPECT_EQ(tested[5].t, 1);
}

TEST(LiangBarskyBox, LeavesBeforeItEnters) {
  const Piece line{{-5, 8, 5}, {3, 20, 5}};
  Watcher seen;
  EXPECT_FALSE(box_parametric(line, ten_cubed, box_order, seen));
  const auto tested = all<TestedFace>(seen);
  ASSERT_EQ(tested.size(), 4u);
  EXPECT_EQ(tested.back().border, Border::top);
  EXPECT_GT(tested.back().enter, tested.back().leave);
  ExactWatcher exact;
  EXPECT_FALSE(box_correctly_rounded(line, ten_cubed, box_order, exact));
  const auto ordered = all<OrderedFace>(exact);
  ASSERT_EQ(ordered.size(), 4u);
  EXPECT_EQ(ordered.back().span.enter, Border::left);
  EXPECT_EQ(ordered.back().span.leave, Border::top);
  EXPECT_TRUE(ordered.back().beyond);
}

TEST(LiangBarskyBox, BesideTheBoxAndPoints) {
  EXPECT_FALSE(box_parametric(Piece{{1, 11, 1}, {9, 11, 1}}, ten_cubed));
  EXPECT_FALSE(box_correctly_rounded(Piece{{1, 11, 1}, {9, 11, 1}}, ten_cubed));
  const Piece point{{5, 10, 0}, {5, 10, 0}};
  EXPECT_EQ(box_parametric(point, ten_cubed), point);
  EXPECT_EQ(box_correctly_rounded(point, ten_cubed), point);
  const Piece through{{1, 1, -1}, {3, 5, 3}};
  const Piece met{{2, 3, 1}, {2, 3, 1}};
  EXPECT_EQ(box_correctly_rounded(through, Cube{{0, 0, 1}, {4, 4, 1}}), met);
  EXPECT_EQ(box_correctly_rounded(through, Cube{{2, 3, 1}, {2, 3, 1}}), met);
}

TEST(LiangBarskyBox, StepsFollowTheGrammarAndWatchingChangesNothing) {
  const Piece lines[] = {{{-1, -1.25, -1.5}, {2, 2.25, 2.5}},
                         {{0.5, 0.5, 0.5}, {0.25, 1, 0}},
                         {{-1, 5, 5}, {-2, 5, 5}},
                         {{-0.5, 0.8, 0.5}, {0.3, 2, 0.5}},
                         {{0.5, 0.5, 0.5}, {0.5, 0.5, 7}}};
  BoxOrder order = box_order;
  std::reverse(order.begin(), order.end());
  for (const Piece& line : lines) {
    for (const BoxOrder& o : {box_order, order}) {
      Watcher seen;
      const auto part = box_parametric(line, unit, o, seen);
      EXPECT_EQ(part, box_parametric(line, unit, o));
      EXPECT_EQ(part.has_value(), all<BoxAccepted<double>>(seen).size() == 1);
      EXPECT_EQ(part.has_value(), all<Rejected<double>>(seen).empty());
      EXPECT_EQ(seen.events().size(), all<TestedFace>(seen).size() + 2);
      EXPECT_TRUE(std::holds_alternative<BoxStarted<double>>(seen.events().front().step));
      ExactWatcher exact;
      const auto same = box_correctly_rounded(line, unit, o, exact);
      EXPECT_EQ(same, box_correctly_rounded(line, unit));
      EXPECT_EQ(same.has_value(), all<BoxKept<double>>(exact).size() == 1);
      EXPECT_EQ(same.has_value(), all<Missed>(exact).empty());
      EXPECT_EQ(exact.events().size(), all<OrderedFace>(exact).size() + 2);
    }
  }
}

TEST(LiangBarskyBox, RefusesByName) {
  const Piece line{{-1, 5, 5}, {11, 5, 5}};
  const Cube inside_out{{0, 0, 5}, {1, 1, 4}};
  EXPECT_THROW(box_parametric(line, inside_out), ContractViolation);
  EXPECT_THROW(box_correctly_rounded(line, inside_out), ContractViolation);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(box_parametric(Piece{{bad, 0, 0}, {1, 1, 1}}, ten_cubed), ContractViolation);
    EXPECT_THROW(box_correctly_rounded(Piece{{0, 0, 0}, {1, 1, bad}}, ten_cubed), ContractViolation);
    EXPECT_THROW(box_correctly_rounded(line, Cube{{0, 0, 0}, {1, bad, 1}}), ContractViolation);
  }
}

}  // namespace
}  // namespace gradus::liang_barsky
