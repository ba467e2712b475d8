#include "clipping/liang_barsky/liang_barsky.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>

#include "core/exact_scalar.hpp"
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

template <class T>
void clip_in() {
  const ExactScope scope;
  const Rectangle<T> window{{T(0), T(0)}, {T(10), T(10)}};
  const Segment<2, T> line{{T(-4), T(3)}, {T(6), T(15)}};
  const Segment<2, T> right{{T(0), T(78) / T(10)}, {T(11) / T(6), T(10)}};
  EXPECT_EQ(correctly_rounded(line, window), right);
  EXPECT_FALSE(parametric(Segment<2, T>{{T(-5), T(8)}, {T(3), T(20)}}, window));
  EXPECT_FALSE(correctly_rounded(Segment<2, T>{{T(-5), T(8)}, {T(3), T(20)}}, window));
  const auto found = parametric(line, window);
  ASSERT_TRUE(found);
  EXPECT_NEAR(static_cast<double>(found->a.y), 7.8, 1e-6);
  EXPECT_NEAR(static_cast<double>(found->b.x), 11.0 / 6, 1e-6);
  if (std::same_as<T, Exact>) EXPECT_EQ(*found, right);
}

TEST(LiangBarsky, FloatDoubleAndExact) {
  clip_in<float>();
  clip_in<double>();
  clip_in<Exact>();
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

TEST(LiangBarskyTraps, TheDifferenceOverflows) {
  const Segment<2, double> line{{-1e308, 0}, {1e308, 10}};
  EXPECT_EQ(exact(line), left_over(0, 5, 10, 5));
  EXPECT_NE(taught(line), left_over(0, 5, 10, 5));
}

TEST(LiangBarskyTraps, TheProductOverflows) {
  EXPECT_EQ(exact({{-1e200, -1e200}, {1e200, 1e200}}), left_over(0, 0, 10, 10));
}

TEST(LiangBarskyTraps, TheCornerIsTouchedOrMissedByOneStep) {
  const double below = std::nextafter(-1.0, -2.0), above = std::nextafter(9.0, 10.0);
  EXPECT_EQ(exact({{-1, 1}, {1, -1}}), left_over(0, 0, 0, 0));
  EXPECT_EQ(exact({{-1, 1}, {1, below}}), std::nullopt);
  EXPECT_EQ(exact({{9, 11}, {11, 9}}), left_over(10, 10, 10, 10));
  EXPECT_EQ(exact({{9, 11}, {11, above}}), std::nullopt);
  EXPECT_TRUE(taught({{-1, 1}, {1, below}}));  // rounded values of t are equal
}

TEST(LiangBarskyTraps, NearlyParallelToABorder) {
  const double under = std::nextafter(10.0, 9.0), over = std::nextafter(10.0, 11.0);
  EXPECT_EQ(exact({{-1e6, under}, {1e6, over}}, {{-2e6, 0}, {2e6, 10}}), left_over(-1e6, under, 0, 10));
}

TEST(LiangBarskyTraps, WindowsWithoutExtent) {
  EXPECT_EQ(exact({{-5, 5}, {15, 5}}, {{3, 0}, {3, 10}}), left_over(3, 5, 3, 5));
  EXPECT_EQ(exact({{0, 0}, {10, 10}}, {{3, 3}, {3, 3}}), left_over(3, 3, 3, 3));
  EXPECT_EQ(exact({{3, 3}, {3, 3}}, {{3, 3}, {3, 3}}), left_over(3, 3, 3, 3));
  EXPECT_EQ(exact({{2, 3}, {2, 3}}, {{3, 3}, {3, 3}}), std::nullopt);
}

// Putting a rounded t into the line leads beside the border, so that clipping again cuts again
TEST(LiangBarskyTraps, ARoundedValueMissesTheBorder) {
  const Segment<2, double> line{{-0.7, 0.1}, {2.9, 1.3}};
  const Found found = taught(line, {{0.1, 0}, {1, 1}});
  ASSERT_TRUE(found);
  EXPECT_NE(found->a.x, 0.1);
  EXPECT_EQ(exact(line, {{0.1, 0}, {1, 1}})->a.x, 0.1);
}

}  // namespace
}  // namespace gradus::liang_barsky
