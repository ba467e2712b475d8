#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_notes.hpp"
#include "core/record.hpp"

namespace gradus::cohen_sutherland_2d {
namespace {

using Found = std::optional<Segment<2, double>>;
template <class T>
using Record = Recorder<Classified<T>, Cut<T>, Accepted<T>, Rejected>;

const Rectangle<double> ten{{0, 0}, {10, 10}};

Found taught(Segment<2, double> line, const Rectangle<double>& window = ten) {
  return cut_of_a_cut(line, window);
}
Found exact(Segment<2, double> line, const Rectangle<double>& window = ten) {
  return correctly_rounded(line, window);
}
Found left_over(double ax, double ay, double bx, double by) { return Segment<2, double>{{ax, ay}, {bx, by}}; }

TEST(CohenSutherland2d, GoldenCodes) {
  // G001-44
  const std::vector<glm::dvec2> points{{-1, -1}, {5, -1}, {11, -1}, {-1, 5}, {5, 5},  {11, 5},
                                       {-1, 11}, {5, 11}, {11, 11}, {0, 0},  {10, 10}};
  const std::vector<int> codes{5, 4, 6, 1, 0, 2, 9, 8, 10, 0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(region_code(points[i], ten), codes[i]) << i;
}

TEST(CohenSutherland2d, GoldenLines) {
  for (const auto clip : {taught, exact}) {
    EXPECT_EQ(clip({{-5, 5}, {15, 5}}, ten), left_over(0, 5, 10, 5));     // G001-45
    EXPECT_EQ(clip({{5, 5}, {-5, 5}}, ten), left_over(5, 5, 0, 5));       // G001-46
    EXPECT_EQ(clip({{-5, -5}, {15, 15}}, ten), left_over(0, 0, 10, 10));  // G001-47
    EXPECT_EQ(clip({{-3, 12}, {5, 16}}, ten), std::nullopt);              // G001-49
    EXPECT_EQ(clip({{-5, 8}, {3, 20}}, ten), std::nullopt);               // G001-50
    EXPECT_EQ(clip({{5, 5}, {5, 20}}, ten), left_over(5, 5, 5, 10));      // G001-51
    EXPECT_EQ(clip({{-1, 1}, {1, -1}}, ten), left_over(0, 0, 0, 0));      // G001-52
  }
  // G001-48: the second cut starts from the rounded point of the first, and ends one step beside 11/6
  EXPECT_EQ(exact({{-4, 3}, {6, 15}}), left_over(0, 7.8, 11.0 / 6, 10));
  EXPECT_EQ(taught({{-4, 3}, {6, 15}}), left_over(0, 7.8, std::nextafter(11.0 / 6, 2), 10));
}

TEST(CohenSutherland2d, StepsFollowTheGrammar) {
  Record<double> seen;
  cut_of_a_cut(Segment<2, double>{{-5, 8}, {3, 20}}, ten, usual_order<2>(), seen);
  // Undecided though wholly outside (E001-25): the codes 0001 and 1000 share no bit
  ASSERT_EQ(seen.events().size(), 3u);
  const auto start = all<Classified<double>>(seen).at(0);
  EXPECT_EQ(start.code_a, bit(Border::left));
  EXPECT_EQ(start.code_b, bit(Border::top));
  const auto cut = all<Cut<double>>(seen).at(0);
  EXPECT_TRUE(cut.of_a);
  EXPECT_EQ(cut.border, Border::left);
  EXPECT_EQ(cut.to(), (glm::dvec2{0, 15.5}));
  EXPECT_EQ(cut.after(), bit(Border::top));
  EXPECT_EQ(all<Rejected>(seen).at(0).common, bit(Border::top));
}

// Every cut moves one end onto a border of its code, whose bit goes and stays away
TEST(CohenSutherland2d, EachCutClearsABit) {
  const auto watch = [](auto clip) {
    for (int i = 0; i < 4000; ++i) {
      const auto c = [&](int k) { return static_cast<double>((i / k * 7 + i * 3) % 19 - 4); };
      Record<double> seen;
      const Found found = clip(Segment<2, double>{{c(1), c(5)}, {c(11), c(23)}}, seen);
      const auto cuts = all<Cut<double>>(seen);
      ASSERT_LE(cuts.size(), 4u);
      const auto start = all<Classified<double>>(seen).at(0);
      std::array<Code, 2> before{start.code_a, start.code_b};
      for (const Cut<double>& cut : cuts) {
        ASSERT_TRUE(before[cut.of_a ? 0 : 1] & bit(cut.border));
        before = {cut.code_a, cut.code_b};
        ASSERT_FALSE(cut.after() & bit(cut.border));
        ASSERT_EQ(cut.to()[axis_of(cut.border)], coordinate(ten, cut.border));
      }
      ASSERT_EQ(all<Accepted<double>>(seen).size(), found ? 1u : 0u);
      ASSERT_EQ(all<Rejected>(seen).size(), found ? 0u : 1u);
      if (found) {
        ASSERT_EQ(all<Accepted<double>>(seen)[0].line, *found);
      }
    }
  };
  watch([](auto line, auto& seen) { return cut_of_a_cut(line, ten, usual_order<2>(), seen); });
  watch([](auto line, auto& seen) { return correctly_rounded(line, ten, usual_order<2>(), seen); });
}

TEST(CohenSutherland2d, TheSignOfZeroDoesNotTellTheOrderOfBorders) {
  // A window without thickness at 0, whose two borders are zeros of different signs
  const Segment<2, double> line{{-3, -2}, {4, 5}};
  for (const int axis : {0, 1}) {
    for (const bool minus_below : {false, true}) {
      Rectangle<double> window{{-9, -9}, {9, 9}};
      window.lower[axis] = minus_below ? -0.0 : 0.0;
      window.upper[axis] = minus_below ? 0.0 : -0.0;
      Order order = usual_order<2>();
      do {
        for (const auto& part : {cut_of_a_cut(line, window, order), correctly_rounded(line, window, order)}) {
          ASSERT_TRUE(part);
          EXPECT_FALSE(std::signbit(part->a[axis]) || std::signbit(part->b[axis]));
        }
      } while (std::ranges::next_permutation(order).found);
    }
  }
}

TEST(CohenSutherland2d, TheOrderSaysWhichBorderIsCutFirst) {
  Record<double> seen;
  cut_of_a_cut(Segment<2, double>{{-5, -10}, {5, 5}}, ten,
               {Border::bottom, Border::top, Border::left, Border::right}, seen);
  EXPECT_EQ(all<Cut<double>>(seen).at(0).border, Border::bottom);
  Record<double> usual;
  cut_of_a_cut(Segment<2, double>{{-5, -10}, {5, 5}}, ten, usual_order<2>(), usual);
  EXPECT_EQ(all<Cut<double>>(usual).at(0).border, Border::left);
}

TEST(CohenSutherland2d, ObservedEqualsUnobserved) {
  int steps = 0;
  auto count = [&](const auto&) { ++steps; };
  const auto order = usual_order<2>();
  for (const Segment<2, double> line :
       {Segment<2, double>{{-4, 3}, {6, 15}}, {{-5, 8}, {3, 20}}, {{1, 1}, {2, 2}}}) {
    EXPECT_EQ(cut_of_a_cut(line, ten, order, count), taught(line));
    EXPECT_EQ(correctly_rounded(line, ten, order, count), exact(line));
    EXPECT_EQ(codes_only(line, ten, order, 8, count), codes_only(line, ten));
  }
  EXPECT_GT(steps, 15);
}

TEST(CohenSutherland2d, MistakesAreNamed) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const Rectangle<double> swapped{{10, 0}, {0, 10}};
  for (const auto clip : {taught, exact}) {
    EXPECT_THROW(clip({{1, 1}, {2, 2}}, swapped), ContractViolation);
    EXPECT_THROW(clip({{1, 1}, {2, 2}}, {{0, 0}, {10, infinity}}), ContractViolation);
    // Naive comparisons call both inside
    EXPECT_THROW(clip({{nan, 1}, {2, 2}}, ten), ContractViolation);
    EXPECT_THROW(clip({{1, 1}, {2, -infinity}}, ten), ContractViolation);
  }
  try {
    exact({{1, 1}, {2, 2}}, swapped);
    FAIL();
  } catch (const ContractViolation& e) {
    EXPECT_STREQ(e.what(), "the window is inside out along axis 0: from 10 to 0");
  }
}

// --- Numerical traps -----------------------------------------------------------------------------

TEST(CohenSutherland2dTraps, TheTaughtFormFallsIntoThem) {
  // A difference overflows: it may accept a point that is no number
  const Found naive = taught({{-1e308, 0}, {1e308, 10}});
  EXPECT_TRUE(!naive || std::isnan(naive->a.y) || naive->a != glm::dvec2(0, 5));
  // A product overflows
  EXPECT_NE(taught({{-1e200, -1e200}, {1e200, 1e200}}), left_over(0, 0, 10, 10));
  // Rounded arithmetic still sees the corner
  EXPECT_EQ(taught({{-1, 1}, {1, std::nextafter(-1.0, -2.0)}}), left_over(0, 0, 0, 0));
}

TEST(CohenSutherland2dTraps, SubnormalsAndSignedZeros) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(exact({{-tiny, -tiny}, {tiny, tiny}}), left_over(0, 0, tiny, tiny));
  EXPECT_EQ(exact({{-tiny, tiny}, {3 * tiny, -tiny}}), left_over(0, 0, tiny, 0));  // y is half a step: even
  const Found zero = exact({{-1, -0.0}, {1, -0.0}});
  ASSERT_TRUE(zero);
  EXPECT_FALSE(std::signbit(zero->a.y));  // what is computed is +0,
  EXPECT_TRUE(std::signbit(zero->b.y));   // what is kept is kept
}

// --- The exhibit ---------------------------------------------------------------------------------

TEST(CohenSutherland2dNotes, TheListingClipsNothing) {
  const Segment<2, double> line{{-5, 5}, {15, 5}};
  EXPECT_EQ(codes_only(line, ten), line);  // E001-24; right is (0,5)-(10,5)
}

TEST(CohenSutherland2dNotes, TheListingMayNeverEnd) {
  Recorder<Classified<double>, Recoded<double>, Accepted<double>, Rejected, GaveUp> seen;
  EXPECT_EQ(codes_only(Segment<2, double>{{5, 5}, {-5, 5}}, ten, usual_order<2>(), 50, seen), std::nullopt);
  EXPECT_EQ(all<Recoded<double>>(seen).size(), 50u);
  EXPECT_EQ(all<GaveUp>(seen).size(), 1u);
  // Always the same: "left" is charged to the end that is inside
  EXPECT_TRUE(every<Recoded<double>>(seen, [](const auto& r) { return r.of_a && r.code_b == 1; }));
}

TEST(CohenSutherland2dNotes, BelowTheWindowPasses) {
  // E002-06, G002-07: (10,-5) is kept
  Recorder<Classified<double>, Accepted<double>, Rejected> seen;
  const Segment<2, double> line{{10, -5}, {5, 5}};
  EXPECT_EQ(whole_or_nothing(line, ten, seen), line);
  const auto codes = all<Classified<double>>(seen);
  ASSERT_EQ(codes.size(), 1u);
  EXPECT_EQ(codes[0].code_a, 0);
  EXPECT_EQ(region_code(line.a, ten), bit(Border::bottom));
  EXPECT_EQ(correctly_rounded(line, ten), (Segment<2, double>{{7.5, 0}, {5, 5}}));
  // The three other sides are asked for
  for (const glm::dvec2 out : {glm::dvec2{-5, 5}, glm::dvec2{15, 5}, glm::dvec2{5, 15}}) {
    EXPECT_EQ(whole_or_nothing(Segment<2, double>{out, {5, 5}}, ten), std::nullopt);
  }
}

TEST(CohenSutherland2dNotes, NodesBelowTheScreenAreKept) {
  // G002-07: nodes at depths between 0 and 50000 on a screen of 800 x 600
  const Rectangle<double> screen{{0, 0}, {800, 600}};
  const glm::dvec3 nodes[] = {{10, -5, 100}, {-1, 5, 100},   {10, 601, 100},
                              {10, 5, 0},    {10, 5, 50000}, {10, 5, 49999}};
  std::vector<bool> right, notes;
  for (const glm::dvec3& node : nodes) {
    const glm::dvec2 at{node.x, node.y};
    const bool between = 0 < node.z && node.z < 50000;
    right.push_back(between && region_code(at, screen) == 0);
    notes.push_back(between && whole_or_nothing(Segment<2, double>{at, at}, screen));
  }
  EXPECT_EQ(right, (std::vector<bool>{false, false, false, false, false, true}));
  EXPECT_EQ(notes, (std::vector<bool>{true, false, false, false, false, true}));
}

TEST(CohenSutherland2dNotes, OneEndOutsideDropsTheWholeSegment) {
  // E002-07
  const Segment<2, double> line{{15, 2}, {5, 8}};
  EXPECT_EQ(whole_or_nothing(line, ten), std::nullopt);
  EXPECT_EQ(correctly_rounded(line, ten), (Segment<2, double>{{10, 5}, {5, 8}}));
  // Of all segments between whole places one end of which lies above or beside the window, none is left;
  // those in the window stay
  int lost = 0;
  for (int x = -3; x <= 13; ++x) {
    for (int y = 0; y <= 13; ++y) {
      const Segment<2, double> segment{{x, y}, {4, 7}};
      const bool inside = region_code(segment.a, ten) == 0;
      EXPECT_EQ(whole_or_nothing(segment, ten).has_value(), inside);
      lost += !inside && correctly_rounded(segment, ten).has_value();
    }
  }
  EXPECT_EQ(lost, 17 * 14 - 11 * 11) << "each of them has its other end in the window";
}

TEST(CohenSutherland2dNotes, TheListingIsRightWhereNothingIsCut) {
  const Segment<2, double> inside{{1, 1}, {2, 2}};
  EXPECT_EQ(codes_only(inside, ten), inside);
  EXPECT_EQ(codes_only(Segment<2, double>{{-3, 12}, {5, 16}}, ten), std::nullopt);
}

}  // namespace
}  // namespace gradus::cohen_sutherland_2d
