// Cutting in clip space in doubles against cutting in rationals; clipping in the plane against exact areas,
// exact places of vertices, and counts of connected cells.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"
#include "core/elementary.hpp"
#include "core/exact_scalar.hpp"
#include "core/geometry.hpp"
#include "core/random.hpp"
#include "support/polygon_areas.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"
#include "support/touching_regions.hpp"

namespace gradus::sutherland_hodgman {
namespace {

TEST(SutherlandHodgmanProperty, DoublesAgreeWithRationals) {
  Random random(test::seed());
  int cases = 0, compared = 0, cut = 0, gone = 0;
  double worst = 0;
  for (; cases < 4000; ++cases) {
    const ExactScope scope;
    const double guard = random.uniform_int(0, 1) ? 1 : 2000;
    const auto planes = view_volume(guard, guard);
    std::vector<Plane<Exact>> exact_planes;
    for (const auto& p : planes) exact_planes.push_back({p.axis, Exact(p.sign), Exact(p.bound)});
    std::vector<Point<double>> polygon;
    std::vector<Point<Exact>> exact;
    for (int i = 0; i < 3; ++i) {
      const double depth = random.uniform(-2, 4), spread = random.uniform_int(0, 3) ? 4 : 9000;
      const glm::dvec4 p{random.uniform(-spread, spread), random.uniform(-spread, spread), 1.1 * depth - 0.5,
                         depth};
      polygon.push_back({p});
      exact.push_back({{Exact(p.x), Exact(p.y), Exact(p.z), Exact(p.w)}});
    }
    const auto part = clip(polygon, std::span<const Plane<double>>(planes));
    exact = clip(exact, std::span<const Plane<Exact>>(exact_planes));
    for (const auto& p : part) {
      for (const auto& plane : planes) ASSERT_GE(distance(plane, p.at), -1e-11 * (1 + guard));
      ASSERT_GT(p.at.w, 0);
    }
    cut += part.size() > 3;
    gone += part.empty();
    // Rounding may lose or add a corner where one nearly touches a plane
    if (part.size() != exact.size()) continue;
    ++compared;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (int axis = 0; axis < 4; ++axis) {
        worst = std::max(worst, std::abs(part[i].at[axis] - to_double(exact[i].at[axis])) / 9000);
      }
    }
  }
  std::printf("%d cases, %d with new corners, %d gone, worst %.3g of the extent\n", cases, cut, gone, worst);
  EXPECT_EQ(cases, 4000);
  EXPECT_GT(compared, 3990);
  EXPECT_GT(cut, 500);
  EXPECT_GT(gone, 100);
  EXPECT_LT(worst, 1e-14);
}

using test::ExactPoint;
using test::Rational;
using Points = std::vector<dvec2>;

Points corners_of(const Rectangle<double>& w) {
  return {w.lower, {w.upper.x, w.lower.y}, w.upper, {w.lower.x, w.upper.y}};
}

Rational area_in(const Points& ring, const Rectangle<double>& w) {
  return test::area_in_rectangle(ring, w.lower, w.upper);
}
Rational area_in(const Points& ring, const ConvexWindow<double>& w) {
  return test::area_in_convex(ring, w.corners);
}

/// Where a vertex is without rounding, from what it remembers.
template <class Window>
ExactPoint place_of(const Scene<double, Window>& scene, const Vertex<double>& v) {
  if (!v.made()) return test::exact_point(scene.polygon[v.input]);
  const Segment<2, double> a = scene.line(v.edge), b = scene.line(v.border);
  return test::exact_crossing(test::exact_point(a.a), test::exact_point(a.b), test::exact_point(b.a),
                              test::exact_point(b.b));
}

/// Whether no other double is nearer to x. Counts those for which the first guess of plain arithmetic fails.
bool nearest(double at, const Rational& x) {
  const Rational miss = abs(Rational(at) - x);
  return miss <= abs(Rational(std::nextafter(at, HUGE_VAL)) - x) &&
         miss <= abs(Rational(std::nextafter(at, -HUGE_VAL)) - x);
}

template <class Window>
std::vector<ExactPoint> places(const Scene<double, Window>& scene, const std::vector<Vertex<double>>& ring) {
  std::vector<ExactPoint> all;
  for (const auto& v : ring) {
    all.push_back(place_of(scene, v));
    EXPECT_TRUE(nearest(v.at.x, all.back().x)) << v.at.x;
    EXPECT_TRUE(nearest(v.at.y, all.back().y)) << v.at.y;
    if (!v.made()) EXPECT_EQ(v.at, scene.polygon[v.input]);
  }
  return all;
}

struct Ran {
  int cases = 0, made = 0, on_border = 0, empty = 0, bridged = 0, several = 0, holes = 0;
};

/// Polygons with vertices on a small grid, so that many lie on borders and corners, or anywhere.
Points random_points(Random& random, bool grid) {
  Points points(static_cast<std::size_t>(random.uniform_int(3, 9)));
  for (dvec2& p : points) {
    p = grid ? dvec2(static_cast<double>(random.uniform_int(-3, 7)),
                     static_cast<double>(random.uniform_int(-3, 7)))
             : dvec2(random.uniform(-3, 7), random.uniform(-3, 7));
  }
  return points;
}
Rectangle<double> random_rectangle(Random& random, bool grid) {
  if (grid) {
    const double x = static_cast<double>(random.uniform_int(-1, 2)),
                 y = static_cast<double>(random.uniform_int(-1, 2));
    return {{x, y},
            {x + static_cast<double>(random.uniform_int(1, 4)),
             y + static_cast<double>(random.uniform_int(1, 4))}};
  }
  const dvec2 low{random.uniform(-2, 2), random.uniform(-2, 2)};
  return {low, low + dvec2(random.uniform(0.1, 4), random.uniform(0.1, 4))};
}
std::optional<ConvexWindow<double>> random_window(Random& random, bool grid) {
  Points points = random_points(random, grid);
  points.resize(static_cast<std::size_t>(random.uniform_int(3, 4)));
  return convex_window(std::span<const dvec2>(points));
}

template <class Window>
void clip_and_compare(const Points& points, const Window& window, std::vector<int> order, Random& random,
                      Ran& ran) {
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1],
              order[static_cast<std::size_t>(random.uniform_int(0, static_cast<std::int64_t>(i) - 1))]);
  }
  const std::span<const dvec2> given(points);
  const Scene<double, Window> scene{{given}, window};
  const auto clipped = clip_to_window(given, window, std::span<const int>(order));
  const auto exact = places(scene, clipped);
  const Rational wanted = area_in(points, window);
  // The wanted area, exactly: unless vertices that round to one were left out
  if (clipped.empty()) {
    ++ran.empty;
    EXPECT_LE(abs(wanted), Rational(1) / 1000000000000);
  } else {
    EXPECT_EQ(test::exact_area(exact), wanted);
  }
  for (const auto& v : clipped) {
    ran.made += v.made();
    for (int border = 0; border < border_count(window); ++border) {
      const int side = side_of_border(scene, border, v);
      EXPECT_GE(side, 0);
      ran.on_border += side == 0 && !v.made();
      // The exact place decides, and it is the one that is remembered
      const Segment<2, double> line = line_of(window, border);
      const Rational turn =
          test::turn(test::exact_point(line.a), test::exact_point(line.b), place_of(scene, v));
      EXPECT_EQ(side, turn.sign());
    }
  }
  const std::vector<BridgeFound<double>> found =
      bridges(std::span<const Vertex<double>>(clipped), given, window);
  ran.bridged += !found.empty();
  ++ran.cases;
}

TEST(SutherlandHodgmanProperty, AreasAndVerticesAreTheExactOnes) {
  Random random(test::seed());
  Ran rectangle, oblique;
  const std::int64_t wanted = test::cases(900, 30000);
  for (std::int64_t i = 0; i < wanted; ++i) {
    const bool grid = i % 3 != 0;
    const Points points = random_points(random, grid);
    const auto window = random_rectangle(random, grid);
    clip_and_compare(points, window, all_borders(window), random, rectangle);
    if (const auto convex = random_window(random, grid)) {
      clip_and_compare(points, *convex, all_borders(*convex), random, oblique);
    }
    if (HasFailure()) FAIL() << "case " << i;
  }
  std::printf("rectangle: %d cases, %d made, %d on borders, %d empty, %d with bridges\n", rectangle.cases,
              rectangle.made, rectangle.on_border, rectangle.empty, rectangle.bridged);
  std::printf("oblique: %d cases, %d made, %d on borders, %d empty, %d with bridges\n", oblique.cases,
              oblique.made, oblique.on_border, oblique.empty, oblique.bridged);
  EXPECT_EQ(rectangle.cases, wanted);
  EXPECT_GT(oblique.cases, 500);
  EXPECT_GT(rectangle.made, 2000);
  EXPECT_GT(rectangle.on_border, 300);
  EXPECT_GT(rectangle.bridged, 100);
  EXPECT_GT(oblique.on_border, 100);
}

TEST(SutherlandHodgmanProperty, ClippingTwiceChangesNothing) {
  Random random(test::seed() + 1);
  int cases = 0, cut = 0;
  for (; cases < 30000; ++cases) {
    Points points = random_points(random, cases % 3 == 0);
    // From tiny to huge, and half of them the other way round
    const double size = std::ldexp(1.0, static_cast<int>(random.uniform_int(-300, 300)));
    for (dvec2& p : points) p *= size;
    auto window = random_rectangle(random, cases % 3 == 0);
    window.lower *= size;
    window.upper *= size;
    const auto once = clip_to_window(std::span<const dvec2>(points), window);
    Points result;
    for (const auto& v : once) result.push_back(v.at);
    const auto twice = clip_to_window(std::span<const dvec2>(result), window);
    ASSERT_EQ(once.size(), twice.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
      ASSERT_EQ(once[i].at, twice[i].at);
      ASSERT_FALSE(twice[i].made());
      const auto& next = once[(i + 1) % once.size()];
      if (once[i].made() || next.made()) ASSERT_NE(once[i].at, next.at) << "an edge of length 0";
      cut += once[i].made();
    }
  }
  EXPECT_EQ(cases, 30000);
  EXPECT_GT(cut, 30000);
}

/// Whether a result is a reordering of the one that came the other way round.
std::vector<std::pair<double, double>> sorted(const std::vector<Vertex<double>>& ring) {
  std::vector<std::pair<double, double>> all;
  for (const auto& v : ring) all.emplace_back(v.at.x, v.at.y);
  std::sort(all.begin(), all.end());
  return all;
}

TEST(SutherlandHodgmanProperty, TheOtherWayRoundGivesTheSameBackwards) {
  Random random(test::seed() + 2);
  int cases = 0;
  for (; cases < 5000; ++cases) {
    Points points = random_points(random, false);
    const auto window = random_rectangle(random, false);
    const auto there = clip_to_window(std::span<const dvec2>(points), window);
    std::reverse(points.begin(), points.end());
    const auto back = clip_to_window(std::span<const dvec2>(points), window);
    ASSERT_EQ(sorted(there), sorted(back));
  }
  EXPECT_EQ(cases, 5000);
}

/// The pieces of one connected region of cells in a window, after an affine map with whole numbers: their
/// number and area are those of the cells, counted.
template <class Window>
void compare_pieces(const std::vector<Points>& rings, const Window& window, int parts, const Rational& area,
                    Ran& ran) {
  const Rings<double> polygon{std::span<const Points>(rings)};
  const auto scene = scene_of(polygon, window);
  const std::vector<int> order = all_borders(window);
  const auto pieces = separate_pieces(polygon, window, std::span<const int>(order));
  EXPECT_EQ(static_cast<int>(pieces.size()), parts);
  Rational sum = 0;
  for (const auto& piece : pieces) {
    const Rational own = test::exact_area(places(scene, piece.outline));
    EXPECT_GT(own, 0);
    sum += own;
    for (const auto& hole : piece.holes) {
      const Rational missing = test::exact_area(places(scene, hole));
      EXPECT_LT(missing, 0);
      EXPECT_GT(own, -missing);
      sum += missing;
      ++ran.holes;
    }
    for (const auto& v : piece.outline) ran.made += v.made();
  }
  EXPECT_EQ(sum, area);
  ran.several += pieces.size() > 1;
  ran.empty += pieces.empty();
  ++ran.cases;
}

TEST(SutherlandHodgmanProperty, PiecesAreThePartsThatHangTogether) {
  Random random(test::seed() + 3);
  Ran rectangle, oblique;
  constexpr int size = 7, fine = 4;  // windows lie on quarters
  const std::int64_t rounds = test::cases(700, 30000);
  for (std::int64_t round = 0; round < rounds; ++round) {
    test::Cells cells{size, size, std::vector<bool>(size * size)};
    for (int i = 0; i < size * size; ++i) cells.there[static_cast<std::size_t>(i)] = random.unit() < 0.66;
    const auto part = test::parts_of(cells);
    std::map<int, int> count;
    for (const int p : part) ++count[p];
    count.erase(-1);
    const auto largest = std::max_element(count.begin(), count.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    for (std::size_t i = 0; i < part.size(); ++i) cells.there[i] = part[i] == largest->first;
    auto rings = test::rings_of(cells);
    const auto outline = std::find_if(rings.begin(), rings.end(),
                                      [](const Points& ring) { return test::exact_area(ring) > 0; });
    std::iter_swap(rings.begin(), outline);

    // A window on quarters of cells, whole ones as often as not
    const auto place = [&](std::int64_t low, std::int64_t high) {
      const auto whole = random.uniform_int(low, high);
      return static_cast<int>(random.uniform_int(0, 1) ? whole * fine
                                                       : whole * fine + random.uniform_int(0, 3));
    };
    const glm::ivec2 low{place(-1, 3), place(-1, 3)}, high{low.x + place(1, 5), low.y + place(1, 5)};
    test::Cells inside{size * fine, size * fine, std::vector<bool>(size * size * fine * fine)};
    int counted = 0;
    for (int y = std::max(low.y, 0); y < std::min(high.y, size * fine); ++y) {
      for (int x = std::max(low.x, 0); x < std::min(high.x, size * fine); ++x) {
        if (cells.at(x / fine, y / fine)) inside.set(x, y, true), ++counted;
      }
    }
    const auto inside_parts = test::parts_of(inside);
    const int parts = 1 + *std::max_element(inside_parts.begin(), inside_parts.end());
    Rectangle<double> window{dvec2(low) / double{fine}, dvec2(high) / double{fine}};
    const Rational area = Rational(counted) / (fine * fine);
    // Either way round
    for (Points& ring : rings) {
      if (random.uniform_int(0, 1)) std::reverse(ring.begin(), ring.end());
    }
    compare_pieces(rings, window, parts, area, rectangle);

    // The same, mapped: borders are oblique, and ties are kept
    const auto whole = [&] { return static_cast<double>(random.uniform_int(-5, 5)); };
    const dvec2 x{whole(), whole()}, y{whole(), whole()}, origin{whole(), whole()};
    const double det = x.x * y.y - x.y * y.x;
    if (det == 0) continue;
    const auto mapped = [&](dvec2 p) { return origin + p.x * x + p.y * y; };
    for (Points& ring : rings) std::transform(ring.begin(), ring.end(), ring.begin(), mapped);
    Points corners = corners_of(window);
    std::transform(corners.begin(), corners.end(), corners.begin(), mapped);
    const auto convex = convex_window(std::span<const dvec2>(corners));
    ASSERT_TRUE(convex);
    compare_pieces(rings, *convex, parts, area * Rational(std::abs(det)), oblique);
    if (HasFailure()) FAIL() << "round " << round;
  }
  for (const Ran& ran : {rectangle, oblique}) {
    std::printf("%d cases, %d in several pieces, %d empty, %d holes, %d vertices made\n", ran.cases,
                ran.several, ran.empty, ran.holes, ran.made);
    EXPECT_GT(ran.cases, 600);
    EXPECT_GT(ran.several, 100);
    EXPECT_GT(ran.holes, 15);
  }
}

/// What a piece promises beside its area: simple rings that touch in one point at most, the inside left.
void expect_valid(const Piece<double>& piece) {
  std::vector<std::set<std::pair<double, double>>> points;
  const auto add = [&](const Ring<double>& ring, int turn) {
    Points around;
    std::set<std::pair<double, double>> own;
    for (const auto& v : ring) {
      around.push_back(v.at);
      own.emplace(v.at.x, v.at.y);
    }
    EXPECT_EQ(own.size(), ring.size()) << "a ring passes a point twice";
    EXPECT_EQ(test::exact_area(around).sign(), turn);
    points.push_back(own);
  };
  add(piece.outline, 1);
  for (const auto& hole : piece.holes) add(hole, -1);
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      std::vector<std::pair<double, double>> common;
      std::set_intersection(points[a].begin(), points[a].end(), points[b].begin(), points[b].end(),
                            std::back_inserter(common));
      EXPECT_LE(common.size(), 1u) << "two rings touch twice";
    }
  }
}

Rational area_of(const Piece<double>& piece) {
  const auto area = [](const Ring<double>& ring) {
    Points points;
    for (const auto& v : ring) points.push_back(v.at);
    return test::exact_area(points);
  };
  Rational sum = area(piece.outline);
  for (const auto& hole : piece.holes) sum += area(hole);
  return sum;
}

/// The pieces against the parts of a region that was counted.
template <class Window>
void compare_parts(const std::vector<Points>& rings, const Window& window, const test::TriangleRegion& inside,
                   const Rational& triangle, Ran& ran) {
  const std::vector<int> order = all_borders(window);
  const auto pieces =
      separate_pieces(Rings<double>(std::span<const Points>(rings)), window, std::span<const int>(order));
  std::vector<Rational> areas, wanted;
  int simple = 0, wanted_simple = 0;
  for (const auto& piece : pieces) {
    expect_valid(piece);
    areas.push_back(area_of(piece));
    simple += 1 + static_cast<int>(piece.holes.size());
    ran.holes += static_cast<int>(piece.holes.size());
  }
  for (const auto& part : inside.apart()) {
    wanted.push_back(part.count() * triangle);
    wanted_simple += test::RegionRings(part).simple_rings();
  }
  std::sort(areas.begin(), areas.end());
  std::sort(wanted.begin(), wanted.end());
  EXPECT_EQ(areas, wanted);
  EXPECT_EQ(simple, wanted_simple);
  ran.several += pieces.size() > 1;
  ran.empty += pieces.empty();
  ++ran.cases;
}

/// Whether rings touch, by all pairs of edges and vertices.
bool any_touch(const Outline<double>& polygon) {
  const int n = static_cast<int>(polygon.points.size());
  for (int i = 0; i < n; ++i) {
    const int next = polygon.after(i);
    const Segment<2, double> edge{polygon[i], polygon[next]};
    if (polygon.after(next) == i) return true;
    for (int k = 0; k < n; ++k) {
      const dvec2 v = polygon[k];
      const auto between = [&](int axis) {
        return std::min(edge.a[axis], edge.b[axis]) <= v[axis] &&
               v[axis] <= std::max(edge.a[axis], edge.b[axis]);
      };
      if (k == i || k == next || !between(0) || !between(1)) continue;
      if (side(edge, v) == 0) return true;
    }
  }
  return false;
}

/// A ring round the origin whose vertices lie at random distances.
Points star(int vertices, double nearest, Random& random) {
  Points points;
  for (int k = 0; k < vertices; ++k) {
    const SinCos at = sin_cos(0x1.921fb54442d18p2 * k / vertices);
    points.push_back(random.uniform(nearest, 1) * dvec2(at.cos, at.sin));
  }
  return points;
}

TEST(SutherlandHodgmanProperty, WhetherRingsTouchIsKnownAsFromAllPairs) {
  // Stars, rings that cross themselves, of places that repeat, and regions of triangles: 3 to 200 vertices
  Random random(test::seed() + 8);
  int touching = 0, apart = 0, untold = 0, round_a_point = 0;
  const std::int64_t rounds = test::cases(3000, 100000);
  for (std::int64_t round = 0; round < rounds; ++round) {
    const int n = static_cast<int>(random.uniform_int(3, round % 10 == 0 ? 200 : 30));
    std::vector<Points> rings;
    if (round % 4 == 0) {
      rings.push_back(star(n, random.uniform(0.05, 1), random));
    } else if (round % 4 == 1) {
      const test::TriangleRegion region =
          test::random_region(static_cast<int>(random.uniform_int(2, 7)), random);
      for (const auto& ring : test::RegionRings(region).polygon(random)) {
        rings.push_back(test::told_otherwise(ring, random));
      }
    } else {
      // On a grid, fine or coarse
      const int places = round % 4 == 2 ? 1 << 20 : n;
      Points& ring = rings.emplace_back();
      for (int k = 0; k < n; ++k) {
        ring.push_back(dvec2(random.uniform_int(0, places), random.uniform_int(0, places)));
      }
    }
    const double scale = std::ldexp(1.0, static_cast<int>(random.uniform_int(-1074, 1000)));
    for (Points& ring : rings) {
      for (dvec2& p : ring) p *= scale;
    }
    const Rings<double> polygon(rings);
    const Outline<double> outline{polygon.points, polygon.next};
    const bool right = any_touch(outline);
    const auto answer = TouchSearch<double>(outline).answer();
    ASSERT_TRUE(!answer || *answer == right) << round;
    if (rings.size() == 1 && goes_round_a_point(outline)) {
      ASSERT_FALSE(right) << round;
      ++round_a_point;
    }
    // Where rings cross, the sweep may miss one; where they don't touch it sees none
    ASSERT_TRUE(right || !polygon.touch) << round;
    ASSERT_TRUE(right || !TouchingRings<double>(outline).touch()) << round;
    untold += !answer;
    touching += right;
    apart += !right;
  }
  std::printf("%d touch, %d don't; %d untold by boxes, %d round a point\n", touching, apart, untold,
              round_a_point);
  EXPECT_GE(touching, rounds / 5);
  EXPECT_GE(apart, rounds / 5);
  EXPECT_GE(untold, rounds / 100);
  EXPECT_GE(round_a_point, rounds / 10);
}

TEST(SutherlandHodgmanProperty, RingsThatTouchGiveTheConnectedPartsOfTheInside) {
  // Holes that touch the outline and each other, at corners and in the middle of edges, outlines that touch
  // themselves, and borders through all that; at any scale
  Random random(test::seed() + 7);
  Ran whole, rectangle, oblique;
  int touching = 0;
  const std::int64_t rounds = test::cases(2000, 50000);
  for (std::int64_t round = 0; round < rounds; ++round) {
    const int side = static_cast<int>(random.uniform_int(3, 7));
    const test::TriangleRegion region = test::random_region(side, random);
    std::vector<Points> rings;
    for (const auto& ring : test::RegionRings(region).polygon(random)) {
      rings.push_back(test::told_otherwise(ring, random));
    }
    if (rings.empty()) continue;
    if (rings.size() > 2) {
      std::rotate(rings.begin() + 1,
                  rings.begin() + random.uniform_int(1, static_cast<std::int64_t>(rings.size()) - 1),
                  rings.end());
    }
    const Rings<double> given{std::span<const Points>(rings)};
    touching += TouchingRings<double>({given.points, given.next}).touch();

    const auto place = [&](std::int64_t low, std::int64_t high) {
      return static_cast<int>(random.uniform_int(low, high));
    };
    const double scale = std::ldexp(1.0, place(-1074, 1000));
    std::vector<Points> scaled = rings;
    for (Points& ring : scaled) {
      for (dvec2& p : ring) p *= scale;
    }
    const Rational triangle = Rational(scale) * Rational(scale) / 2;
    const auto window_of = [&](glm::ivec2 low, glm::ivec2 high) {
      return Rectangle<double>{dvec2(low) * scale, dvec2(high) * scale};
    };
    compare_parts(scaled, window_of({-1, -1}, {side + 1, side + 1}), region, triangle, whole);
    const glm::ivec2 low{place(-1, 2), place(-1, 2)};
    const glm::ivec2 high{place(low.x + 1, side + 1), place(std::max(low.y + 1, side - 1), side + 1)};
    const auto inside = region.within(low, high);
    compare_parts(scaled, window_of(low, high), inside, triangle, rectangle);

    const dvec2 x(place(-5, 5), place(-5, 5)), y(place(-5, 5), place(-5, 5)),
        origin(place(-5, 5), place(-5, 5));
    const double det = x.x * y.y - x.y * y.x;
    if (HasFailure()) FAIL() << "round " << round;
    if (det == 0) continue;
    const auto mapped = [&](dvec2 p) { return origin + p.x * x + p.y * y; };
    for (Points& ring : rings) std::transform(ring.begin(), ring.end(), ring.begin(), mapped);
    Points corners = corners_of({dvec2(low), dvec2(high)});
    std::transform(corners.begin(), corners.end(), corners.begin(), mapped);
    const auto convex = convex_window(std::span<const dvec2>(corners));
    ASSERT_TRUE(convex);
    compare_parts(rings, *convex, inside, Rational(std::abs(det)) / 2, oblique);
    if (HasFailure()) FAIL() << "round " << round;
  }
  for (const Ran& ran : {whole, rectangle, oblique}) {
    std::printf("%d cases, %d in several pieces, %d empty, %d holes\n", ran.cases, ran.several, ran.empty,
                ran.holes);
    EXPECT_GT(ran.cases, rounds * 3 / 4);
    EXPECT_GT(ran.several, rounds / 4);
    EXPECT_GT(ran.holes, rounds / 8);
  }
  std::printf("%d with rings that touch\n", touching);
  EXPECT_GT(touching, rounds / 2);
}

TEST(SutherlandHodgmanProperty, PiecesOfAnyRingHaveItsArea) {
  // Rings that cross themselves, too: areas count as often as the ring goes round them
  Random random(test::seed() + 4);
  Ran rectangle, oblique;
  const auto compare = [&](const Points& points, const auto& window, Ran& ran) {
    const std::vector<Points> rings{points};
    const Rings<double> polygon{std::span<const Points>(rings)};
    const auto scene = scene_of(polygon, window);
    const std::vector<int> order = all_borders(window);
    Rational sum = 0;
    for (const auto& piece : separate_pieces(polygon, window, std::span<const int>(order))) {
      sum += test::exact_area(places(scene, piece.outline));
      for (const auto& hole : piece.holes) sum += test::exact_area(places(scene, hole));
    }
    const Rational whole = test::exact_area(points), wanted = area_in(points, window);
    EXPECT_EQ(sum, whole >= 0 ? wanted : -wanted);
    ran.empty += whole == 0 && wanted != 0;
    ++ran.cases;
  };
  const std::int64_t wanted = test::cases(800, 30000);
  for (std::int64_t i = 0; i < wanted; ++i) {
    const bool grid = i % 3 != 0;
    Points points = random_points(random, grid);
    // Two parallel diagonals: a bow-tie, whose area is 0 but not that of its halves
    if (i % 10 == 1) points = {points[0], points[1], points[0] + dvec2(1, 2), points[1] + dvec2(1, 2)};
    compare(points, random_rectangle(random, grid), rectangle);
    if (const auto convex = random_window(random, grid)) compare(points, *convex, oblique);
    if (HasFailure()) FAIL() << "case " << i;
  }
  std::printf("%d bow-ties with an area in the window\n", rectangle.empty + oblique.empty);
  EXPECT_EQ(rectangle.cases, wanted);
  EXPECT_GT(oblique.cases, 400);
  EXPECT_GT(rectangle.empty, wanted / 100);
}

TEST(SutherlandHodgmanProperty, TheBatchGivesTheSameBits) {
  Random random(test::seed() + 6);
  BatchClipper clip;
  std::size_t cases = 0;
  BatchCount all;
  Polygons result;
  for (int batch = 0; batch < 60; ++batch) {
    const auto window = random_rectangle(random, batch % 2 == 0);
    const double size = batch % 3 == 0 ? 1 : 0.05;
    Polygons given;
    for (int i = 0; i < 100; ++i) {
      Points points = random_points(random, batch % 2 == 0);
      const dvec2 place = (1 - size) * dvec2(random.uniform(-1, 4), random.uniform(-1, 4));
      for (dvec2& p : points) p = p * size + place;
      given.add(points);
    }
    const BatchCount count = clip(given, window, result);
    all.copied += count.copied;
    all.dropped += count.dropped;
    all.clipped += count.clipped;
    ASSERT_EQ(result.size(), given.size());
    for (std::size_t i = 0; i < given.size(); ++i, ++cases) {
      const auto single = clip_to_window(given[i], window);
      ASSERT_EQ(result[i].size(), single.size());
      for (std::size_t k = 0; k < single.size(); ++k) ASSERT_EQ(result[i][k], single[k].at);
    }
  }
  std::printf("%zu copied, %zu dropped, %zu clipped\n", all.copied, all.dropped, all.clipped);
  EXPECT_EQ(cases, 6000u);
  EXPECT_EQ(all.copied + all.dropped + all.clipped, cases);
  EXPECT_GT(all.copied, 300u);
  EXPECT_GT(all.dropped, 300u);
  EXPECT_GT(all.clipped, 1500u);
  const Polygons broken{{{0, 0}, {1, HUGE_VAL}, {2, 0}}, {3}};
  EXPECT_THROW(clip(broken, {{0, 0}, {1, 1}}, result), ContractViolation);
}

TEST(SutherlandHodgmanProperty, CrossingsOfLinesAreExact) {
  Random random(test::seed() + 5);
  int cases = 0, ties = 0;
  const std::int64_t wanted = test::cases(6000, 300000);
  for (std::int64_t i = 0; i < wanted; ++i) {
    const bool grid = i % 2 == 0;
    const int shift = grid ? 0 : static_cast<int>(random.uniform_int(-400, 400));
    const auto point = [&] {
      const dvec2 p = grid ? dvec2(static_cast<double>(random.uniform_int(-3, 3)),
                                   static_cast<double>(random.uniform_int(-3, 3)))
                           : dvec2(random.uniform(-1, 1), random.uniform(-1, 1));
      return p * std::ldexp(1.0, shift);
    };
    const Segment<2, double> a{point(), point()}, b{point(), point()}, c{point(), point()};
    const auto exact = [](dvec2 p) { return test::exact_point(p); };
    const Rational turned = test::turn(exact({}), exact(a.b - a.a), exact(b.b - b.a));
    if (grid) ASSERT_EQ(heading(a, b), turned.sign());
    if (a.a == a.b || b.a == b.b || heading(a, b) == 0) continue;
    const ExactPoint at = test::exact_crossing(exact(a.a), exact(a.b), exact(b.a), exact(b.b));
    const dvec2 rounded = crossing_point(a, b);
    ASSERT_TRUE(nearest(rounded.x, at.x) && nearest(rounded.y, at.y));
    if (c.a == c.b) continue;
    const int side = side_of_crossing(c, a, b);
    ASSERT_EQ(side, test::turn(exact(c.a), exact(c.b), at).sign());
    ties += side == 0;
    ++cases;
  }
  std::printf("%d cases, %d ties\n", cases, ties);
  EXPECT_GT(cases, 5000);
  EXPECT_GT(ties, 50);
}

}  // namespace
}  // namespace gradus::sutherland_hodgman
