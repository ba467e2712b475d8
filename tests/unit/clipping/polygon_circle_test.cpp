// Polygons and circles of known result, the step grammar, chords for arcs, what the notes' listing does.

#include "clipping/polygon_circle/polygon_circle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "clipping/polygon_circle/polygon_circle_notes.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/record.hpp"

namespace gradus::polygon_circle {
namespace {

using Polygon = std::vector<dvec2>;
using Rings = std::vector<Ring<double>>;
constexpr Circle<double> unit{{0, 0}, 1};
constexpr double pi = 0x1.921fb54442d18p1;

Region<double> clipped(const Polygon& polygon, const Circle<double>& circle = unit) {
  return arcs(polygon, circle);
}
double clipped_area(const Polygon& polygon, const Circle<double>& circle = unit) {
  return area(clipped(polygon, circle));
}
double shoelace(const Polygon& polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

const Polygon quadrant{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, around{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}},
    triangle{{0, -0.5}, {3, -0.5}, {0, 0.5}}, band{{-3, -0.5}, {3, -0.5}, {3, 0.5}, {-3, 0.5}},
    four_out{{-0.8, -0.8}, {0.8, -0.8}, {0.8, 0.8}, {-0.8, 0.8}};

TEST(PolygonCircle, GoldenAreas) {
  // G001-69 to 73
  EXPECT_NEAR(clipped_area(around), 3.141592653589793, 1e-15);
  EXPECT_NEAR(clipped_area(quadrant), 0.7853981633974483, 1e-15);
  EXPECT_NEAR(clipped_area(triangle), 0.8108296473846022, 1e-15);
  EXPECT_NEAR(clipped_area(band), 1.9132229549810364, 1e-15);
  EXPECT_NEAR(clipped_area(four_out), 2.487588218416656, 1e-14);
}

TEST(PolygonCircle, BoundariesOfEdgesAndArcs) {
  // The quadrant's corner and one arc, from (1,0) counter-clockwise to (0,1)
  EXPECT_EQ(clipped(quadrant).rings, (Rings{{{{0, 1}}, {{0, 0}}, {{1, 0}, true}}}));
  // All four corners outside, every edge crosses twice: four chords and four arcs
  const auto ring = clipped(four_out).rings.at(0);
  ASSERT_EQ(ring.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(ring[i].arc, i % 2 == 1) << i;
  EXPECT_EQ(clipped({{-3, 0}, {3, 0}, {3, -3}, {-3, -3}}).rings, (Rings{{{{1, 0}}, {{-1, 0}, true}}}));
}

TEST(PolygonCircle, WholeOrNothing) {
  const Rings whole{{{{1, 0}, true, true}}};
  EXPECT_EQ(clipped(around).rings, whole);
  // All four sides touch the circle
  EXPECT_EQ(clipped({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}).rings, whole);
  // A reflex corner touches it
  EXPECT_EQ(clipped({{3, 3}, {1, 0}, {3, -3}, {-3, -3}, {-3, 3}}).rings, whole);
  const Polygon inside{{-0.5, -0.5}, {0.5, -0.5}, {0, 0.5}};
  EXPECT_EQ(clipped(inside).rings, (Rings{{{{-0.5, -0.5}}, {{0.5, -0.5}}, {{0, 0.5}}}}));
  EXPECT_TRUE(clipped({{2, 2}, {3, 2}, {3, 3}}).rings.empty());
  // Round the circle but not over it
  EXPECT_TRUE(
      clipped({{-3, -3}, {3, -3}, {3, 3}, {2, 3}, {2, -2}, {-2, -2}, {-2, 3}, {-3, 3}}).rings.empty());
  // Outside, and touching it with a side or a corner
  EXPECT_TRUE(clipped({{-1, 1}, {1, 1}, {0, 3}}).rings.empty());
  EXPECT_TRUE(clipped({{1, 0}, {3, -1}, {3, 1}}).rings.empty());
  EXPECT_TRUE(clipped(around, Circle<double>{{0, 0}, 0}).rings.empty());
  // No area
  EXPECT_TRUE(clipped({{0, 0}, {0.5, 0}}).rings.empty());
  EXPECT_TRUE(clipped({{0, 0}, {5, 5}, {2, 2}}).rings.empty());
  EXPECT_TRUE(clipped({}).rings.empty());
}

TEST(PolygonCircle, CornersOnTheCircle) {
  const Circle<double> five{{0, 0}, 5};
  // Inscribed: the polygon itself
  const auto inscribed = clipped({{5, 0}, {3, 4}, {-4, 3}, {0, -5}}, five).rings;
  ASSERT_EQ(inscribed.size(), 1u);
  EXPECT_EQ(inscribed[0].size(), 4u);
  for (const auto& corner : inscribed[0]) EXPECT_FALSE(corner.arc);
  // One corner on it, the others inside
  EXPECT_EQ(clipped({{3, 4}, {0, 1}, {1, 0}}, five).rings.at(0).size(), 3u);
  // A notch whose tip lies outside, opening inwards from a reflex corner on the circle: all but a triangle
  const Region<double> notched = clipped(
      {{9, 9}, {-9, 9}, {-9, -9}, {9, -9}, {9, -1}, {5, 0}, {-1, -2}, {-1, 2}, {5, 0.5}, {9, 0.5}}, five);
  ASSERT_EQ(notched.rings.size(), 1u);
  // Without the wedge from (5,0) to x = -1 and y = -2 to 2, and what lies beyond the edge to (5, 0.5)
  EXPECT_GT(area(notched), 25 * pi - 15);
  EXPECT_LT(area(notched), 25 * pi - 12);
  // Two pieces that touch in a corner on the circle
  const Region<double> two = clipped({{3, 3}, {-1, 0}, {3, -3}, {-3, -3}, {-3, 3}});
  ASSERT_EQ(two.rings.size(), 2u);
  EXPECT_EQ(two.rings[0].size(), 2u);
  EXPECT_EQ(two.rings[1].size(), 2u);
  // An edge from circle to circle along a chord, the rest outside
  EXPECT_EQ(clipped({{3, 4}, {-3, 4}, {0, 20}}, five).rings, (Rings{{{{-3, 4}}, {{3, 4}, true}}}));
}

/// Nothing but a notch that touches the circle in one point from inside: the arc is the whole circle.
TEST(PolygonCircle, AnArcOfTheWholeCircle) {
  // A hole would touch at (1, 0); a simple polygon comes in from outside there
  const Region<double> region =
      clipped({{3, 0.5}, {0, 0.5}, {1, 0}, {0, -0.5}, {3, -0.5}, {3, -3}, {-3, -3}, {-3, 3}, {3, 3}});
  ASSERT_EQ(region.rings.size(), 1u);
  EXPECT_EQ(region.rings[0].size(), 5u);
  EXPECT_EQ(region.rings[0][2], (Corner<double>{{std::sqrt(0.75), 0.5}, true, true}));
  // The same boundary without ways in: a self-touching one whose only passage is the corner
  const Region<double> slit =
      clipped({{3, 0x1p-60}, {-0.5, 0}, {3, -0x1p-60}, {3, -3}, {-3, -3}, {-3, 3}, {3, 3}});
  ASSERT_EQ(slit.rings.size(), 1u);
  EXPECT_TRUE(slit.rings[0][slit.rings[0].size() - 1].arc);
  EXPECT_TRUE(slit.rings[0][slit.rings[0].size() - 1].more_than_half);
  EXPECT_NEAR(area(slit), pi, 1e-15);
}

TEST(PolygonCircle, TheSmallestCirclesAreCutLikeLargeOnes) {
  // Directions of passages underflow; a corner on the circle once was followed by the whole of it
  const std::vector<Polygon> polygons{
      {{0, 0}, {-2, 0}, {0, -5}, {2, 0}},   {{-6, 0}, {6, 0}, {6, 6}, {-6, 6}},
      {{-4, -3}, {4, -3}, {5, 9}, {-5, 9}}, {{-9, 3}, {-9, -3}, {9, -4}, {9, 4}},
      {{5, -5}, {5, 5}, {-5, 5}, {-5, -5}}, {{3, 4}, {-4, 3}, {-3, -4}, {4, -3}}};
  for (const Polygon& polygon : polygons) {
    const Rings right = clipped(polygon, {{0, 0}, 5}).rings;
    for (const int exponent : {-800, -897, -910, -987, -1022, -1030, 900, 1018}) {
      Polygon scaled = polygon;
      for (dvec2& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      const Rings found = clipped(scaled, {{0, 0}, std::ldexp(5, exponent)}).rings;
      ASSERT_EQ(found.size(), right.size()) << exponent;
      for (std::size_t r = 0; r < right.size(); ++r) {
        ASSERT_EQ(found[r].size(), right[r].size()) << exponent;
        for (std::size_t i = 0; i < right[r].size(); ++i) {
          EXPECT_EQ(found[r][i].arc, right[r][i].arc) << exponent;
          EXPECT_EQ(found[r][i].more_than_half, right[r][i].more_than_half) << exponent;
          EXPECT_NEAR(std::ldexp(found[r][i].at.x, -exponent), right[r][i].at.x, 1e-9) << exponent;
          EXPECT_NEAR(std::ldexp(found[r][i].at.y, -exponent), right[r][i].at.y, 1e-9) << exponent;
        }
      }
    }
  }
}

TEST(PolygonCircle, AreasOfAnySize) {
  for (const Polygon& polygon : {quadrant, triangle, band, four_out, around}) {
    const double right = clipped_area(polygon);
    for (const int exponent : {-530, -400, 400, 511}) {
      Polygon scaled = polygon;
      for (dvec2& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      EXPECT_EQ(clipped_area(scaled, {{0, 0}, std::ldexp(1, exponent)}), std::ldexp(right, 2 * exponent));
    }
    // Too large and too small for a double
    for (const int exponent : {-1060, -700, 700, 1020}) {
      Polygon scaled = polygon;
      for (dvec2& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      const Region<double> region = clipped(scaled, {{0, 0}, std::ldexp(1, exponent)});
      EXPECT_EQ(area(region), exponent < 0 ? 0 : std::numeric_limits<double>::infinity());
      EXPECT_NEAR(area_in(unit_of(region.circle.radius), region), right, exponent < -1020 ? 1e-3 : 1e-14);
    }
  }
  // Far from the origin the corners' products cancel
  EXPECT_EQ(clipped_area({{0x1p600, 0}, {0x1p600 + 0x1p550, 0}, {0x1p600, 0x1p550}}, {{0x1p600, 0}, 0x1p560}),
            HUGE_VAL);
  EXPECT_EQ(clipped_area({{0x1p500, 0}, {0x1p500 + 0x1p450, 0}, {0x1p500, 0x1p450}}, {{0x1p500, 0}, 0x1p460}),
            0x1p899);
}

/// Three passages at one point, where a polygon meets itself: in some order, whichever.
TEST(PolygonCircle, PassagesAtOnePointHaveAnOrder) {
  const Polygon meets{{-3, -3}, {-3, 3}, {0, 0}, {1, 0},   {0, 0.5},
                      {-3, 4},  {3, 4},  {3, 0}, {0.5, 0}, {3, -3}};
  const std::vector<dvec2> corners = counter_clockwise(std::span<const dvec2>(meets));
  std::vector<Crossing> passes;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    add_crossings(passes, run_of(edge_of(corners, i), unit), i, corners.size(), unit);
  }
  const CircleOrder before(corners, unit);
  int at_one_point = 0;
  for (const Crossing& a : passes) {
    EXPECT_FALSE(before(a, a));
    for (const Crossing& b : passes) {
      at_one_point += &a < &b && a.at == b.at;
      EXPECT_FALSE(before(a, b) && before(b, a));
      for (const Crossing& c : passes) {
        if (before(a, b) && before(b, c)) EXPECT_TRUE(before(a, c));
        // Two that are not told apart stand in the same place
        if (!before(a, b) && !before(b, a)) EXPECT_EQ(before(a, c), before(b, c));
      }
    }
  }
  EXPECT_GE(at_one_point, 2);
}

TEST(PolygonCircle, SeveralPieces) {
  // A comb with three teeth into the circle
  const Polygon comb{{-3, -3}, {3, -3},   {3, 2},     {0.6, 2},   {0.6, -2}, {0.3, -2},
                     {0.3, 2}, {-0.3, 2}, {-0.3, -2}, {-0.6, -2}, {-0.6, 2}, {-3, 2}};
  const Region<double> region = clipped(comb);
  ASSERT_EQ(region.rings.size(), 3u);
  const auto right_of = [](double x) { return std::acos(x) - x * std::sqrt(1 - x * x); };
  EXPECT_NEAR(area(region), 2 * right_of(0.6) + pi - 2 * right_of(0.3), 1e-14);
}

TEST(PolygonCircle, FloatAndExact) {
  const std::vector<glm::vec2> polygon{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const Region<float> region = arcs(std::span<const glm::vec2>(polygon), Circle<float>{{0, 0}, 1});
  EXPECT_EQ(region.rings, (std::vector<Ring<float>>{{{{0, 1}}, {{0, 0}}, {{1, 0}, true}}}));
  EXPECT_NEAR(area(region), pi / 4, 1e-15);
  // What is rational is the quadratic of each edge: the same in Exact
  const ExactScope scope;
  const Segment<2, Exact> edge{{Exact(2), Exact(0)}, {Exact(2), Exact(2)}};
  const auto q = liang_barsky_circle::quadratic(edge, Circle<Exact>{{Exact(0), Exact(0)}, Exact(1)});
  EXPECT_EQ(sign(q.D), run_of({{2, 0}, {2, 2}}, unit).inside ? 1 : -1);
}

TEST(PolygonCircle, MistakesAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double r : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(clipped(quadrant, {{0, 0}, r}), ContractViolation);
    EXPECT_THROW(first_crossing(std::span<const dvec2>(quadrant), Circle<double>{{0, 0}, r}),
                 ContractViolation);
  }
  EXPECT_THROW(clipped({{0, 0}, {1, nan}, {0, 1}}), ContractViolation);
  const Region<double> region = clipped(quadrant);
  for (const double tolerance : {0.0, -1.0, 1e-13, nan}) {
    EXPECT_THROW(flatten(region, tolerance), ContractViolation);
  }
  // Two entries in a row
  EXPECT_THROW(
      clipped({{-2, 0.1}, {2, 0.1}, {2, -0.1}, {-2, 0.5}, {-2, 0.7}, {2, 0.3}, {2, -0.2}, {-2, -0.2}}),
      ContractViolation);
}

TEST(PolygonCircle, SimpleOrNot) {
  const auto meeting = [](const Polygon& polygon) { return meeting_edges(polygon).has_value(); };
  for (const Polygon& polygon : {quadrant, triangle, band, four_out, around}) EXPECT_FALSE(meeting(polygon));
  EXPECT_TRUE(meeting({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));          // a bow tie
  EXPECT_TRUE(meeting({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));  // a corner on an edge
  EXPECT_TRUE(meeting({{0, 0}, {2, 0}, {1, 0}}));                  // back on itself
  EXPECT_TRUE(meeting({{0, 0}, {2, 0}, {2, 2}, {2, 1}, {0, 2}}));
  EXPECT_FALSE(meeting({{0, 0}, {1, 0}, {2, 0}, {2, 2}}));  // straight on
}

TEST(PolygonCircle, StepsFollowTheGrammar) {
  using Seen = Recorder<Oriented, Tested, Sorted, Entered, Walked, Bent, Closed, Finished<double>>;
  const auto steps = [](const Polygon& polygon) {
    Seen seen;
    EXPECT_EQ(arcs(std::span<const dvec2>(polygon), unit, seen).rings, clipped(polygon).rings);
    std::string text;
    for (const auto& event : seen.events()) text += "OTSEWBCF"[event.step.index()];
    return text;
  };
  EXPECT_EQ(steps(quadrant), "OTTTTSEWBCF");
  EXPECT_EQ(steps(four_out), "OTTTTSEBEBEBEBCF");
  EXPECT_EQ(steps(around), "OTTTTSF");
  EXPECT_EQ(steps({{0, 0}, {1, 1}, {2, 2}}), "OSF");
  Seen seen;
  arcs(std::span<const dvec2>(quadrant), unit, seen);
  EXPECT_EQ(all<Tested>(seen)[0].leaves, dvec2(1, 0));
  EXPECT_FALSE(all<Tested>(seen)[0].enters);
  EXPECT_EQ(all<Tested>(seen)[3].enters, dvec2(0, 1));
  EXPECT_EQ(all<Bent>(seen)[0].from, dvec2(1, 0));
  EXPECT_EQ(all<Bent>(seen)[0].to, dvec2(0, 1));
  // The passages' order round the circle
  Seen crossed;
  arcs(std::span<const dvec2>(four_out), unit, crossed);
  const auto sorted = all<Sorted>(crossed)[0].crossings;
  ASSERT_EQ(sorted.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(sorted[i].leaves, i % 2 == 0);
}

TEST(PolygonCircle, ChordsForArcs) {
  const Region<double> region = clipped(quadrant);
  // One chord: sagitta 1 - cos(45 degrees) = 0.2929
  EXPECT_EQ(flatten(region, 0.3), (std::vector<Polygon>{{{0, 1}, {0, 0}, {1, 0}}}));
  const auto two = flatten(region, 0.29).at(0);
  ASSERT_EQ(two.size(), 4u);
  EXPECT_NEAR(two[3].x, std::sqrt(0.5), 1e-16);
  // Finer and finer, from inside
  double last = 0;
  for (const double tolerance : {0.1, 0.01, 1e-4, 1e-6}) {
    const double now = shoelace(flatten(region, tolerance).at(0));
    EXPECT_GT(now, last);
    EXPECT_LT(now, pi / 4);
    EXPECT_GT(now, pi / 4 - tolerance * pi / 2);
    last = now;
  }
  EXPECT_GE(flatten(clipped(around), 10).at(0).size(), 3u);
}

// 2^-40 of the smallest radii was 0, and so was the step along the arc: without end
TEST(PolygonCircle, ChordsOfTheSmallestAndTheLargestArcs) {
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  for (const double r : {least, 0x1p-1060, 0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000, most}) {
    const Polygon polygon{{-most, -most}, {most, -most}, {most, most}, {-most, most}};
    const Region<double> region = clipped(polygon, {{0, 0}, r});
    EXPECT_THROW(flatten(region, 0), ContractViolation) << r;
    EXPECT_THROW(flatten(region, r * 0x1p-41), ContractViolation) << r;
    const auto flat = flatten(region, std::max(r / 64, least)).at(0);
    EXPECT_GE(flat.size(), 3u) << r;
    for (const dvec2 p : flat) {
      EXPECT_NEAR(std::hypot(p.x / r, p.y / r), 1, 1 / std::max(1.0, r / least / 2) + 1e-15) << r;
    }
  }
  EXPECT_TRUE(flatten(clipped(quadrant, {{0, 0}, 0}), 0).empty());
}

// --- The notes' listing -----------------------------------------------------------------------------------

TEST(PolygonCircleNotes, ExitsAndDoubleCrossingsAreLost) {
  const auto notes = [](const Polygon& polygon) {
    return first_crossing(std::span<const dvec2>(polygon), unit);
  };
  // The values of G001-69 to 73 as the notes' routine gives them
  EXPECT_EQ(shoelace(notes(around)), 0);
  EXPECT_EQ(shoelace(notes(quadrant)), 0);
  EXPECT_NEAR(shoelace(notes(triangle)), 0.4925823272122516, 1e-15);
  EXPECT_TRUE(notes(band).empty());
  EXPECT_TRUE(notes(four_out).empty());
  // Right inside
  const Polygon inside{{-0.5, -0.5}, {0.5, -0.5}, {0, 0.5}};
  EXPECT_NEAR(shoelace(notes(inside)), 0.5, 1e-15);
}

TEST(PolygonCircleNotes, StepsFollowTheGrammar) {
  Recorder<Oriented, Looked, Kept, Joined<double>> seen;
  const auto kept = first_crossing(std::span<const dvec2>(triangle), unit, seen);
  EXPECT_EQ(kept, first_crossing(std::span<const dvec2>(triangle), unit));
  std::string text;
  for (const auto& event : seen.events()) text += "OLKJ"[event.step.index()];
  EXPECT_EQ(text, "OLKLKKLKJ");
  EXPECT_EQ(all<Kept>(seen)[0].at, dvec2(0, -0.5));  // the start of the edge that leaves
}

TEST(PolygonCircle, TakesPointsAsProgramsHaveThem) {
  const auto right = arcs(std::span<const dvec2>(quadrant), unit).rings;
  ASSERT_EQ(right.size(), 1u);
  const std::array<dvec2, 4> array{quadrant[0], quadrant[1], quadrant[2], quadrant[3]};
  const dvec2 plain[]{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  Polygon changeable = quadrant;
  EXPECT_EQ(arcs(quadrant, {{0, 0}, 1}).rings, right);
  EXPECT_EQ(arcs(array, unit).rings, right);
  EXPECT_EQ(arcs(plain, unit).rings, right);
  EXPECT_EQ(arcs(std::span(changeable), unit).rings, right);
  EXPECT_EQ(arcs({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 0}, 1}).rings, right);
  const std::vector<glm::vec2> floats{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  static_assert(std::same_as<decltype(arcs(floats, {{0, 0}, 1})), Region<float>>);
  EXPECT_EQ(first_crossing(quadrant, unit), first_crossing(std::span<const dvec2>(quadrant), unit));
  EXPECT_EQ(counter_clockwise({{0, 2}, {2, 2}, {2, 0}}).size(), 3u);
  Recorder<Oriented, Tested, Sorted, Entered, Walked, Bent, Closed, Finished<double>> seen;
  EXPECT_EQ(arcs(quadrant, unit, seen).rings, right);
  EXPECT_EQ(all<Tested>(seen).size(), 4u);
}

}  // namespace
}  // namespace gradus::polygon_circle
