// Holes joined by hand, holes that touch, refusals; ears by their angles, and what comes of looking at turns
// alone.

#include "modeling/ear_clipping/join_holes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/geometry.hpp"
#include "core/record.hpp"
#include "modeling/ear_clipping/ear_clipping_notes.hpp"
#include "modeling/ear_clipping/widest_ear.hpp"

namespace gradus::ear_clipping {
namespace {

using Points = std::vector<dvec2>;

/// Points and rings of their numbers.
struct Region {
  Points points{};
  Faces rings{};

  explicit Region(const std::vector<Points>& from) {
    for (const Points& ring : from) {
      std::vector<std::int32_t> numbers;
      for (const dvec2 p : ring) {
        numbers.push_back(static_cast<std::int32_t>(points.size()));
        points.push_back(p);
      }
      rings.add(numbers);
    }
  }
  std::vector<int> joined() const { return join_holes(std::span<const dvec2>(points), rings); }
};

double doubled_area(dvec2 a, dvec2 b, dvec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
double doubled_area(const Points& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += doubled_area({}, ring[i], ring[(i + 1) % ring.size()]);
  return sum;
}

/// On whole numbers: as many triangles as expected, none turned round, their areas add up to that of the
/// outline without its holes, and all their sides but those of the rings come in pairs - where no side is
/// touched between its ends.
void expect_covered(const std::vector<Points>& rings, std::size_t triangles, bool sides_touched = false) {
  const Region region(rings);
  std::size_t count = 0;
  double sum = 0, whole = std::abs(doubled_area(rings[0]));
  std::map<std::string, int> open;  // by places, for a hole may touch
  const auto name = [](dvec2 p) { return std::to_string(p.x) + "," + std::to_string(p.y); };
  const auto add_side = [&](dvec2 a, dvec2 b, int by) {
    open[name(a) + " " + name(b)] += by;
    open[name(b) + " " + name(a)] -= by;
  };
  triangulate_with_holes(std::span<const dvec2>(region.points), region.rings, [&](const Triangle& t) {
    const auto at = [&](std::size_t i) { return region.points[static_cast<std::size_t>(t[i])]; };
    const double area = doubled_area(at(0), at(1), at(2));
    EXPECT_GE(area, 0);
    sum += area;
    ++count;
    for (std::size_t i = 0; i < 3; ++i) add_side(at(i), at((i + 1) % 3), 1);
  });
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (r > 0) whole -= std::abs(doubled_area(rings[r]));
    const int by = (doubled_area(rings[r]) > 0) == (r == 0) ? -1 : 1;
    for (std::size_t i = 0; i < rings[r].size(); ++i)
      add_side(rings[r][i], rings[r][(i + 1) % rings[r].size()], by);
  }
  EXPECT_EQ(count, triangles);
  EXPECT_EQ(sum, whole);
  for (const auto& [side, times] : open) EXPECT_TRUE(times == 0 || sides_touched) << side;
}

const Points square{{0, 0}, {12, 0}, {12, 12}, {0, 12}};

TEST(EarClippingHoles, ABridgeLeadsToTheFartherEnd) {
  // The ray from (6, 4) meets the right side, whose ends are equally far: the upper one
  const Region region({square, {{3, 3}, {6, 4}, {4, 6}}});
  EXPECT_EQ(region.joined(), (std::vector<int>{2, 5, 4, 6, 5, 2, 3, 0, 1}));
}

TEST(EarClippingHoles, ACornerInTheWayIsTaken) {
  const std::vector<Points> rings{{{0, 0}, {10, 0}, {11, 3}, {14, 0}, {13, 9}, {0, 8}},
                                  {{7, 2}, {9, 4}, {8, 7}, {6, 6}},
                                  {{2, 2}, {5, 4}, {3, 6}}};
  const Region region(rings);
  Recorder<EdgeMet, InTheWay, HoleJoined, AllJoined> seen;
  EXPECT_EQ(join_holes(std::span<const dvec2>(region.points), region.rings, seen), region.joined());
  ASSERT_EQ(all<InTheWay>(seen).size(), 1u);
  EXPECT_EQ(all<EdgeMet>(seen)[0].end, 3);
  EXPECT_EQ(all<InTheWay>(seen)[0].end, 2);
  // The left hole sees the outline only past the other one
  EXPECT_EQ(all<HoleJoined>(seen)[0].hole, 1);
  EXPECT_EQ(all<HoleJoined>(seen)[1].corner, 11);
  EXPECT_EQ(std::get<AllJoined>(seen.events().back().step).corners, 17);
  expect_covered(rings, 15);
}

TEST(EarClippingHoles, HardPlaces) {
  const Points low{{2, 2}, {4, 2}, {4, 4}, {2, 4}}, high{{2, 8}, {4, 8}, {4, 10}, {2, 10}};
  expect_covered({square, low, high}, 14);  // equally far to the right
  expect_covered({square,
                  {{2, 5}, {2, 7}, {4, 7}, {4, 5}},
                  {{6, 5}, {8, 5}, {8, 7}, {6, 7}},
                  {{9, 5}, {11, 5}, {11, 7}, {9, 7}}},
                 20);
  // The ray runs along an edge, and through a corner
  expect_covered(
      {{{0, 0}, {12, 0}, {12, 4}, {8, 4}, {8, 6}, {12, 6}, {12, 12}, {0, 12}}, {{2, 2}, {6, 4}, {2, 6}}}, 11);
  expect_covered({{{0, 0}, {12, 4}, {0, 8}}, {{2, 3}, {6, 4}, {2, 5}}}, 6);
  // Corners in one line with the bridge: the nearest one
  expect_covered({{{0, 0}, {12, 0}, {10, 2}, {8, 4}, {12, 5}, {12, 12}, {0, 12}}, {{2, 5}, {4, 8}, {2, 9}}},
                 10);
}

TEST(EarClippingHoles, TouchingOnesNeedNoBridge) {
  expect_covered({square, {{12, 12}, {6, 9}, {9, 6}}}, 5);      // corner at corner
  expect_covered({square, {{0, 6}, {4, 4}, {4, 8}}}, 6, true);  // corner on an edge
  expect_covered({{{0, 0}, {6, 0}, {7, 4}, {8, 0}, {12, 0}, {12, 12}, {0, 12}}, {{5, 4}, {9, 4}, {7, 8}}}, 9,
                 true);
  const Points one{{2, 2}, {5, 5}, {2, 5}}, other{{5, 5}, {8, 5}, {8, 8}}, third{{8, 6}, {10, 6}, {10, 9}};
  expect_covered({square, one, other}, 10);               // each other
  expect_covered({square, one, other, third}, 14, true);  // and an edge
}

TEST(EarClippingHoles, MistakesAreNamed) {
  const auto join = [](const std::vector<Points>& rings) { return Region(rings).joined(); };
  EXPECT_THROW(join({square, {{20, 1}, {22, 1}, {21, 3}}}), ContractViolation);
  EXPECT_THROW(join({}), ContractViolation);
  Region region({square, {{3, 3}, {6, 4}, {4, 6}}});
  region.points[5].x = std::numeric_limits<double>::infinity();
  EXPECT_THROW(region.joined(), ContractViolation);
  region.points.resize(5);
  EXPECT_THROW(region.joined(), ContractViolation);
}

TEST(EarClippingHoles, Rationals) {
  const ExactScope scope;
  std::vector<ExactVec2> points;
  for (const dvec2 p : Points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {2, 1}, {1, 2}})
    points.push_back({Exact(p.x) / Exact(3), Exact(p.y) / Exact(3)});
  int count = 0;
  triangulate_with_holes(std::span<const ExactVec2>(points), faces_of({{0, 1, 2, 3}, {4, 5, 6}}),
                         [&](const Triangle&) { ++count; });
  EXPECT_EQ(count, 7);
  EXPECT_EQ(least_sine_squared(points[0], points[1], points[2]), Exact(1, 2));
  widest_ear(std::span<const ExactVec2>(points).first(4), [&](const Triangle&) { ++count; });
  EXPECT_EQ(count, 9);
}

// --- The order of the ears

const Points crown{{0, 0}, {7, 0}, {12, 1}, {11, 8}, {7, 3}, {5, 9}, {3, 4}, {0, 8}};

/// The smallest angle of all triangles, in degrees.
template <class Cut>
double smallest_angle(const Points& p, const Cut& cut) {
  double least = 1;
  cut(std::span<const dvec2>(p), [&](const Triangle& t) {
    const auto at = [&](std::size_t i) { return p[static_cast<std::size_t>(t[i])]; };
    least = std::min(least, least_sine_squared(at(0), at(1), at(2)));
  });
  return std::asin(std::sqrt(least)) * 180 / 3.141592653589793;
}

TEST(EarClippingOrder, TheWidestEarsLeaveWiderAngles) {
  const double first = smallest_angle(crown, [](auto... run) { triangulate(run...); });
  const double widest = smallest_angle(crown, [](auto... run) { widest_ear(run...); });
  EXPECT_NEAR(first, 3.37, 0.01);
  EXPECT_NEAR(widest, 30.96, 0.01);
}

TEST(EarClippingOrder, LeastSines) {
  EXPECT_DOUBLE_EQ(least_sine_squared<double>({0, 0}, {1, 0}, {0, 1}), 0.5);
  EXPECT_EQ(least_sine_squared<double>({0, 0}, {1, 1}, {2, 2}), 0);
  EXPECT_EQ(least_sine_squared<double>({3, 3}, {3, 3}, {3, 3}), 0);
  for (const double size : {0x1p-1060, 1.0, 0x1p1023})
    EXPECT_DOUBLE_EQ(least_sine_squared<double>({-size, 0}, {size, 0}, {0, size}), 0.5) << size;
}

TEST(EarClippingOrder, WidestEarsFollowTheGrammar) {
  Recorder<Tested, Cut, Finished> seen;
  std::vector<Triangle> watched, plain;
  widest_ear(crown, [&](const Triangle& t) { watched.push_back(t); }, seen);
  widest_ear(crown, [&](const Triangle& t) { plain.push_back(t); });
  EXPECT_EQ(watched, plain);
  EXPECT_EQ(watched.front(), (Triangle{2, 3, 4}));
  EXPECT_EQ(all<Cut>(seen).size(), 6u);
  EXPECT_TRUE(every<Cut>(seen, [](const Cut& c) { return !c.forced; }));
  // All corners once, then two after each cut, and those that waited for it
  EXPECT_GE(all<Tested>(seen).size(), 8u + 2u * 5u);
  // Straight corners alone are cut when nothing else is left
  int count = 0;
  widest_ear({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}}, [&](const Triangle&) { ++count; });
  EXPECT_EQ(count, 4);
}

TEST(EarClippingFaults, TurnsAloneCoverMoreThanThePolygon) {
  double sum = 0;
  int turned = 0;
  convex_only(std::span<const dvec2>(crown), [&](const Triangle& t) {
    const auto at = [&](std::size_t i) { return crown[static_cast<std::size_t>(t[i])]; };
    const double area = doubled_area(at(0), at(1), at(2));
    turned += area < 0;
    sum += std::abs(area);
  });
  EXPECT_GT(turned, 0);
  EXPECT_EQ(doubled_area(crown), 2 * 67);
  EXPECT_EQ(sum, 2 * 91);
}

}  // namespace
}  // namespace gradus::ear_clipping
