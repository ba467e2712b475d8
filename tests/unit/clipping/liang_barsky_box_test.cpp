// Known segments in space, the step grammar, hard input, refusals.

#include "clipping/liang_barsky/liang_barsky_box.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/exact_scalar.hpp"
#include "core/record.hpp"

namespace gradus::liang_barsky {
namespace {

using Piece = Segment<3, double>;
using Cube = AxisBox<3, double>;
using Watcher = Recorder<BoxStarted<double>, Tested<double>, BoxAccepted<double>, Rejected<double>>;
using ExactWatcher = Recorder<BoxStarted<double>, Ordered<double>, BoxKept<double>, Missed>;
using TestedFace = Tested<double>;
using OrderedFace = Ordered<double>;

const Cube unit{{0, 0, 0}, {1, 1, 1}};
const Cube ten{{0, 0, 0}, {10, 10, 10}};
const BoxOrder usual = usual_order<3>();

TEST(LiangBarskyBox, GoldenSegment) {
  // G001-53, and its values of t
  const Piece line{{-1, 0.5, 0.25}, {2, 0.5, 1}};
  Watcher seen;
  const auto part = box_parametric(line, unit, usual, seen);
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
  EXPECT_FALSE(box_parametric(line, ten, usual, seen));
  const auto tested = all<TestedFace>(seen);
  ASSERT_EQ(tested.size(), 4u);
  EXPECT_EQ(tested.back().border, Border::top);
  EXPECT_GT(tested.back().enter, tested.back().leave);
  ExactWatcher exact;
  EXPECT_FALSE(box_correctly_rounded(line, ten, usual, exact));
  const auto ordered = all<OrderedFace>(exact);
  ASSERT_EQ(ordered.size(), 4u);
  EXPECT_EQ(ordered.back().span.enter, Border::left);
  EXPECT_EQ(ordered.back().span.leave, Border::top);
  EXPECT_TRUE(ordered.back().beyond);
}

TEST(LiangBarskyBox, BesideTheBoxAndPoints) {
  EXPECT_FALSE(box_parametric(Piece{{1, 11, 1}, {9, 11, 1}}, ten));
  EXPECT_FALSE(box_correctly_rounded(Piece{{1, 11, 1}, {9, 11, 1}}, ten));
  const Piece point{{5, 10, 0}, {5, 10, 0}};
  EXPECT_EQ(box_parametric(point, ten), point);
  EXPECT_EQ(box_correctly_rounded(point, ten), point);
  const Piece through{{1, 1, -1}, {3, 5, 3}};
  const Piece met{{2, 3, 1}, {2, 3, 1}};
  EXPECT_EQ(box_correctly_rounded(through, Cube{{0, 0, 1}, {4, 4, 1}}), met);
  EXPECT_EQ(box_correctly_rounded(through, Cube{{2, 3, 1}, {2, 3, 1}}), met);
}

TEST(LiangBarskyBox, HardNumbers) {
  EXPECT_EQ(box_correctly_rounded(Piece{{-1e308, 0, 5}, {1e308, 10, 5}}, ten),
            (Piece{{0, 5, 5}, {10, 5, 5}}));
  EXPECT_FALSE(box_correctly_rounded(Piece{{-1, 1, 0}, {1, std::nextafter(-1, -2), 0}}, ten));
  EXPECT_EQ(box_correctly_rounded(Piece{{-1, 1, 0}, {1, -1, 0}}, ten), (Piece{{0, 0, 0}, {0, 0, 0}}));
  // -0.9 + t 1.2 with t = 0.75 rounded: the end comes to lie outside of the face that it was cut at
  const Piece tenths{{-0.9, 0.5, 0.5}, {0.3, 0.5, 0.5}};
  const auto beside = box_parametric(tenths, unit);
  ASSERT_TRUE(beside);
  EXPECT_LT(beside->a.x, 0);
  EXPECT_EQ(box_correctly_rounded(tenths, unit)->a.x, 0);
}

TEST(LiangBarskyBox, FloatDoubleAndExactAgree) {
  const ExactScope scope;
  const auto clip = []<class T>(T) {
    const AxisBox<3, T> box{{T(0), T(0), T(0)}, {T(1), T(1), T(1)}};
    const Segment<3, T> line{{T(-1), T(1) / T(2), T(1) / T(4)}, {T(3), T(1) / T(2), T(1)}};
    const auto part = box_parametric(line, box);
    EXPECT_TRUE(part);
    EXPECT_EQ(box_correctly_rounded(line, box), part);
    return glm::dvec3(double(part->b.x), double(part->b.y), double(part->b.z));
  };
  EXPECT_EQ(clip(0.0), glm::dvec3(1, 0.5, 0.625));
  EXPECT_EQ(clip(0.0f), glm::dvec3(1, 0.5, 0.625));
  EXPECT_EQ(clip(Exact(0)), glm::dvec3(1, 0.5, 0.625));
}

TEST(LiangBarskyBox, StepsFollowTheGrammarAndWatchingChangesNothing) {
  const Piece lines[] = {{{-1, -1.25, -1.5}, {2, 2.25, 2.5}},
                         {{0.5, 0.5, 0.5}, {0.25, 1, 0}},
                         {{-1, 5, 5}, {-2, 5, 5}},
                         {{-0.5, 0.8, 0.5}, {0.3, 2, 0.5}},
                         {{0.5, 0.5, 0.5}, {0.5, 0.5, 7}}};
  BoxOrder order = usual;
  std::reverse(order.begin(), order.end());
  for (const Piece& line : lines) {
    for (const BoxOrder& o : {usual, order}) {
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
    EXPECT_THROW(box_parametric(Piece{{bad, 0, 0}, {1, 1, 1}}, ten), ContractViolation);
    EXPECT_THROW(box_correctly_rounded(Piece{{0, 0, 0}, {1, 1, bad}}, ten), ContractViolation);
    EXPECT_THROW(box_correctly_rounded(line, Cube{{0, 0, 0}, {1, bad, 1}}), ContractViolation);
  }
}

}  // namespace
}  // namespace gradus::liang_barsky
