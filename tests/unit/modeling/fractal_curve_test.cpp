// Known counts and measures, corners in closed form, the same curve by a text, the step grammar, refusals.
// That boxes are those of brute force is a promise.

#include "modeling/fractal_curve/fractal_curve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/contract.hpp"
#include "core/record.hpp"
#include "modeling/fractal_curve/box_count.hpp"
#include "modeling/fractal_curve/fractal_curve_notes.hpp"
#include "modeling/fractal_curve/l_system.hpp"
#include "support/documented.hpp"

namespace gradus::fractal_curve {
namespace {

constexpr const char* page = "docs/topics/modeling/fractal_curve.md";

const Corners segment = base_of(Shape::curve), triangle = base_of(Shape::snowflake);
const std::array systems{koch_system, dragon_system, hilbert_system, arrowhead_system, plant_system};

/// The corners that a text draws on the lattice, one behind the other.
Corners walked(const std::string& text) {
  Corners way{{0, 0}};
  turtle<Corner>(text, lattice_way, [&](Corner, Corner to) { way.push_back(to); });
  return way;
}

// --- The Koch curve

TEST(FractalCurve, FirstLevelIsTheKnownOne) {
  EXPECT_EQ(koch(segment, 1), (Corners{{0, 0}, {1, 0}, {1, 1}, {2, 0}, {3, 0}}));
  EXPECT_EQ(koch(triangle, 0), triangle);
  const Segment<2, double> base{{0, 0}, {9, 0}};
  EXPECT_EQ(in_plane({1, 0}, 1, base), (dvec2{3, 0}));
  EXPECT_EQ(in_plane({2, 0}, 1, base), (dvec2{6, 0}));
  EXPECT_DOUBLE_EQ(in_plane({1, 1}, 1, base).x, 4.5);
  EXPECT_DOUBLE_EQ(in_plane({1, 1}, 1, base).y, std::sqrt(6.75));
}

TEST(FractalCurve, SnowflakeHasTheKnownMeasures) {  // G001-26
  constexpr int levels = 5;
  const Corners way = koch(triangle, levels);
  EXPECT_EQ(way.size() - 1, 3072u);
  EXPECT_EQ(way.front(), way.back());
  const Segment<2, double> base{{0, 0}, {1, 0}};
  double length = 0, area = 0;
  const std::vector<dvec2> points = in_plane(way, levels, base);
  for (Index i = 0; i + 1 < points.size(); ++i) {
    length += length_of(points[i + 1] - points[i]);
    area += 0.5 * (points[i + 1].x * points[i].y - points[i].x * points[i + 1].y);
  }
  constexpr double tolerance = 1e-12;
  EXPECT_NEAR(length / 3, 4.213991769547324, tolerance);
  const double ratio = static_cast<double>(triangles_of(way)) / static_cast<double>(power(9, levels));
  EXPECT_NEAR(area / (std::sqrt(3.0) / 4), ratio, tolerance);
  // What is missing to 8/5 falls to 4/9 each level, from 3/5 on
  EXPECT_NEAR(ratio + 0.6 * std::pow(4.0 / 9, levels), 1.6, tolerance);
  EXPECT_NEAR(similarity_dimension(4, 3), 1.2618595071429148, tolerance);
}

TEST(FractalCurve, CountsAndAreasAreThoseOfTheSeries) {
  for (int level = 0; level <= 7; ++level) {
    const Corners curve = koch(segment, level), flake = koch(triangle, level);
    EXPECT_EQ(std::ssize(curve) - 1, power(4, level));
    EXPECT_EQ(std::ssize(flake) - 1, 3 * power(4, level));
    // 5 of 9^n of the triangles are 8 9^n - 3 4^n; one side adds 9^n - 4^n
    EXPECT_EQ(5 * triangles_of(flake), 8 * power(9, level) - 3 * power(4, level));
    EXPECT_EQ(5 * triangles_of(curve), power(9, level) - power(4, level));
  }
}

/// The i-th corner by the digits of i to base 4: each says which of four parts, and the parts turn by 0, 60,
/// -60 and 0 degrees. Nothing of the level before is used.
Corner by_digits(Index i, int level) {
  Corner sum{0, 0};
  std::int64_t turns = 0;
  for (int k = level - 1; k >= 0; --k) {
    const auto digit = (i >> (2 * k)) & 3;
    sum *= 3;
    for (Index part = 0; part < digit; ++part) {
      constexpr std::array<std::int64_t, 3> turned_by{0, 1, -1};
      sum += lattice_way(turns + turned_by[part]);
    }
    constexpr std::array<std::int64_t, 4> own{0, 1, -1, 0};
    turns += own[digit];
  }
  return sum;
}

TEST(FractalCurve, CornersAreThoseOfTheirNumbersDigits) {
  for (int level = 1; level <= 6; ++level) {
    const Corners way = koch(segment, level);
    for (Index i = 0; i + 1 < way.size(); ++i) ASSERT_EQ(way[i], by_digits(i, level)) << level << " " << i;
  }
}

TEST(FractalCurve, CornersOfALevelStayOnTheNext) {
  const Corners before = koch(triangle, 4), after = koch(triangle, 5);
  for (Index i = 0; i < before.size(); ++i) ASSERT_EQ(after[4 * i], 3 * before[i]);
}

TEST(FractalCurve, StepsFollowTheGrammarAndObservedEqualsUnobserved) {
  Recorder<Replaced, LevelDone, Finished> seen;
  const Corners way = koch(triangle, 3, seen);
  EXPECT_EQ(way, koch(triangle, 3));
  EXPECT_EQ(all<Replaced>(seen).size(), 3u + 12u + 48u);
  EXPECT_EQ(all<LevelDone>(seen).size(), 3u);
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).segments, 192);
  EXPECT_TRUE(every<Replaced>(seen, [](const Replaced& r) {
    const Corner third = r.way[1] - r.way[0];
    return r.way[3] - r.way[1] == third && r.way[4] - r.way[3] == third &&
           r.way[2] - r.way[1] == turned(third) && r.way[3] - r.way[2] == turned_back(third);
  }));
  EXPECT_TRUE(every<LevelDone>(seen, [](const LevelDone& d) { return d.segments == 3 * power(4, d.level); }));
}

// --- Texts

TEST(FractalCurve, TextsGrowAsTheRulesSay) {
  EXPECT_EQ(rewrite("F", koch_system.rules, 0), "F");
  EXPECT_EQ(rewrite("F", koch_system.rules, 1), "F+F--F+F");
  EXPECT_EQ(rewrite("F", dragon_system.rules, 2), "F+G+F-G");
  EXPECT_EQ(rewrite("F", arrowhead_system.rules, 1), "G-F-G");
  for (const System& system : systems) {
    for (int rounds = 0; rounds <= 5; ++rounds) {
      const std::string axiom(system.axiom), text = rewrite(axiom, system.rules, rounds);
      EXPECT_EQ(std::ssize(text), length_after(axiom, system.rules, rounds, most_symbols));
    }
  }
}

TEST(FractalCurve, TheTextOfKochWalksTheSameCorners) {
  for (int level = 0; level <= 6; ++level) {
    EXPECT_EQ(walked(rewrite("F", koch_system.rules, level)), koch(segment, level)) << level;
    // Turned to the right twice, it goes round a triangle to its right
    EXPECT_EQ(triangles_of(walked(rewrite("F--F--F", koch_system.rules, level))),
              triangles_of(koch(triangle, level)))
        << level;
  }
}

TEST(FractalCurve, HilbertsTextPassesEachCellOnce) {
  for (int level = 1; level <= 5; ++level) {
    std::set<std::pair<std::int64_t, std::int64_t>> cells{{0, 0}};
    const auto way = [](std::int64_t turns) {
      constexpr std::array<Box, 4> ways{Box{1, 0}, Box{0, 1}, Box{-1, 0}, Box{0, -1}};
      return ways[static_cast<Index>((turns % 4 + 4) % 4)];
    };
    std::int64_t steps = 0;
    turtle<Box>(rewrite("A", hilbert_system.rules, level), way, [&](Box, Box to) {
      ++steps;
      EXPECT_TRUE(cells.emplace(to.x, to.y).second) << level;
    });
    EXPECT_EQ(steps, power(4, level) - 1);
    EXPECT_EQ(cells.rbegin()->first, (1 << level) - 1);
  }
}

TEST(FractalCurve, BracketsRestoreWhereTheTurtleStands) {
  Recorder<SymbolRead<Corner>, WalkFinished> seen;
  std::vector<Segment<2, int>> drawn;
  const auto draw = [&](Corner a, Corner b) { drawn.push_back({a, b}); };
  turtle<Corner>("F[+F]f-[F]", lattice_way, draw, seen);
  EXPECT_EQ(drawn, (std::vector<Segment<2, int>>{{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{2, 0}, {3, -1}}}));
  const auto read = all<SymbolRead<Corner>>(seen);
  ASSERT_EQ(read.size(), 10u);
  EXPECT_EQ(read[4].now.at, (Corner{1, 0}));
  EXPECT_EQ(read[4].now.turn, 0);
  EXPECT_EQ(read[3].kept, 1u);
  EXPECT_EQ(read[9].now.turn, -1);
}

TEST(FractalCurve, RewritingTellsEachSymbol) {
  Recorder<SymbolReplaced, GenerationDone, TextFinished> seen;
  const std::string text = rewrite("F+X", koch_system.rules, 1, seen);
  EXPECT_EQ(text, "F+F--F+F+X");
  const auto steps = all<SymbolReplaced>(seen);
  ASSERT_EQ(steps.size(), 3u);
  for (const SymbolReplaced& s : steps) EXPECT_EQ(text.substr(s.begins, s.to.size()), s.to);
  EXPECT_EQ(steps[1].to, "+");
  EXPECT_EQ(all<GenerationDone>(seen).at(0).symbols, 10);
}

// --- Boxes

TEST(FractalCurve, APointOnAWallBelongsToTheBoxThatItBegins) {
  const std::vector<Line> point{{{4, 8}, {4, 8}}}, wall{{{0, 4}, {8, 4}}}, diagonal{{{0, 0}, {8, 8}}};
  const auto boxes = [](const std::vector<Line>& lines) {
    Boxes met;
    for (const Line& l : lines) cover(l, 4, met);
    sort_unique(met);
    return met;
  };
  EXPECT_EQ(boxes(point), (Boxes{{1, 2}}));
  EXPECT_EQ(boxes(wall), (Boxes{{0, 1}, {1, 1}, {2, 1}}));
  EXPECT_EQ(boxes(diagonal), (Boxes{{0, 0}, {1, 1}, {2, 2}}));
}

/// The curve's lines, 1 being 2 3^level 256, corners rounded once.
std::vector<Line> lines_of(int level) {
  constexpr double finer = 256;
  const Corners way = koch(segment, level);
  std::vector<Line> lines;
  const auto at = [](Corner c) {
    return Box{256 * (2 * c.x + c.y), std::llround(finer * std::sqrt(3.0) * c.y)};
  };
  for (Index i = 0; i + 1 < way.size(); ++i) lines.push_back({at(way[i]), at(way[i + 1])});
  return lines;
}

TEST(FractalCurve, MeasuredDimensionIsAsThePageSays) {
  constexpr int level = 4;
  const std::vector<Line> lines = lines_of(level);
  const Whole whole = 256 * 2 * power(3, level);
  const std::vector<Whole> sides{whole / 3, whole / 9, whole / 27, whole / 81};
  const std::vector<Count> counts = box_count(lines, sides);
  ASSERT_EQ(counts.size(), 4u);
  const Fit fit = fitted(counts);
  EXPECT_LT(std::abs(fit.slope - similarity_dimension(4, 3)), 2 * fit.error);
  EXPECT_TRUE(test::states(
      page, "the curve meets {}, {}, {} and {} boxes",
      {double(counts[0].boxes), double(counts[1].boxes), double(counts[2].boxes), double(counts[3].boxes)}));
  EXPECT_TRUE(test::states(page, "the slope {} with a standard error of {}", {fit.slope, fit.error}));
  EXPECT_TRUE(test::states(page, "beside log 4 / log 3 = {}", {similarity_dimension(4, 3)}));
}

TEST(FractalCurve, BoxesSmallerThanSegmentsMeasureALine) {
  const std::vector<Line> lines{{{0, 0}, {1 << 20, 1 << 18}}};
  std::vector<Whole> sides;
  for (Whole side = 1 << 14; side >= 1 << 8; side /= 2) sides.push_back(side);
  EXPECT_NEAR(fitted(box_count(lines, sides)).slope, 1, 0.01);
  Recorder<SideCounted, AllCounted> seen;
  box_count(lines, sides, seen);
  EXPECT_EQ(all<SideCounted>(seen).size(), sides.size());
}

// --- Exhibits and refusals

TEST(FractalCurve, ExhibitsAreAsWrongAsThePageSays) {
  constexpr int levels = 5;
  const auto part = [](const Corners& way) {
    return static_cast<double>(triangles_of(way)) / static_cast<double>(power(9, levels));
  };
  EXPECT_TRUE(test::states(page, "the curve encloses {} of the triangle’s area instead of {}",
                           {part(inside(triangle, levels)), part(koch(triangle, levels))}));
  const Rules rules = dragon_system.rules;
  const std::string wrong = rule_after_rule("F", rules, 3);
  EXPECT_EQ(rule_after_rule("F", rules, 1), "F+F-G");
  EXPECT_TRUE(test::states(page, "third generation has {} steps instead of {}",
                           {double(std::ranges::count_if(wrong, draws)),
                            double(std::ranges::count_if(rewrite("F", rules, 3), draws))}));
  // One rule alone is applied rightly
  EXPECT_EQ(rule_after_rule("F", koch_system.rules, 3), rewrite("F", koch_system.rules, 3));
}

TEST(FractalCurve, MistakesAreNamed) {
  const auto drop = [](Corner, Corner) {};
  const std::vector<Line> far{{{0, 0}, {Whole{1} << 31, 0}}}, none;
  const std::array<Whole, 1> zero{0}, one{1};
  EXPECT_THROW(koch({{0, 0}}, 1), ContractViolation);
  EXPECT_THROW(koch(segment, -1), ContractViolation);
  EXPECT_THROW(koch(segment, 13), ContractViolation);
  EXPECT_THROW(koch(triangle, 12), ContractViolation);
  EXPECT_THROW(koch({{0, 0}, {1000, 0}}, 12), ContractViolation);
  EXPECT_THROW(rewrite("F", koch_system.rules, 25), ContractViolation);
  EXPECT_THROW(rewrite("F", koch_system.rules, 13), ContractViolation);
  EXPECT_THROW(turtle<Corner>("F]", lattice_way, drop), ContractViolation);
  EXPECT_THROW(turtle<Corner>("[F[F]", lattice_way, drop), ContractViolation);
  EXPECT_THROW(box_count(far, one), ContractViolation);
  EXPECT_THROW(box_count(none, zero), ContractViolation);
  EXPECT_THROW(fitted({}), ContractViolation);
  EXPECT_EQ(lonely_bracket("F]"), 1u);
  EXPECT_EQ(lonely_bracket("[F[F]"), 0u);
  EXPECT_EQ(lonely_bracket("[F]["), 3u);
  EXPECT_EQ(lonely_bracket("[[F]F]"), 6u);
}

}  // namespace
}  // namespace gradus::fractal_curve
