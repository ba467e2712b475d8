// Polygons in circles: areas against the sum of the edges' triangles and sectors in 200 bits, the order round
// the circle against 400 bits, chords against their sagitta.

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "clipping/polygon_circle/polygon_circle.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "stress/clipping/circle_ends.hpp"
#include "stress/clipping/circle_scales.hpp"
#include "support/circle_areas.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::polygon_circle {
namespace {

using test::dot;
using test::Float;
using test::Point;
using test::Wide;
using test::wide;

template <class T>
class Polygons {
 public:
  explicit Polygons(std::uint64_t offset) : random(test::seed() + offset) {}

  using Polygon = std::vector<glm::vec<2, T>>;
  struct Case {
    Polygon polygon;
    Circle<T> circle;
  };

  Case next() {
    Case c{{}, {{0, 0}, static_cast<T>(random.uniform(0.5, 8))}};
    switch (random.uniform_int(0, 5)) {
      case 0:  // star-shaped, any centre
        c.polygon = star(static_cast<int>(random.uniform_int(3, 12)));
        c.circle.centre = point(4);
        break;
      case 1:  // small integers against 5, 10, 13: corners on the circle and tangents
        c.polygon = lattice_star();
        c.circle.radius = T(random.unit() < 0.7 ? 5 : random.unit() < 0.5 ? 10 : 3);
        break;
      case 2:  // a comb: many pieces
        c.polygon = comb(static_cast<int>(random.uniform_int(2, 6)));
        break;
      case 3:  // corners on a circle, rounded, and nudged
        c.polygon = inscribed(c.circle.radius);
        break;
      case 4:  // slivers: passages that lie closer than doubles tell
        c.polygon = slivers(c.circle.radius);
        break;
      default:  // star-shaped of many corners, from a small to a large size
        c.polygon = star(static_cast<int>(random.uniform_int(20, 40)));
        break;
    }
    if (random.unit() < 0.5) std::reverse(c.polygon.begin(), c.polygon.end());
    return c;
  }

  Random random;

 private:
  glm::vec<2, T> point(double size) {
    const T x = static_cast<T>(random.uniform(-size, size));
    return {x, static_cast<T>(random.uniform(-size, size))};
  }
  glm::vec<2, T> on(double degrees, double radius) {
    const SinCos at = sin_cos_degrees(degrees);
    return {static_cast<T>(radius * at.cos), static_cast<T>(radius * at.sin)};
  }
  Polygon star(int corners) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
      polygon.push_back(on((i + random.uniform(0.1, 0.9)) * 360 / corners, random.uniform(1, 12)));
    }
    return polygon;
  }
  Polygon lattice_star() {
    const std::pair<int, int> fives[] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                                         {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
    Polygon polygon;
    for (const auto& [x, y] : fives) {
      if (random.unit() < 0.3) continue;
      const T size = T(random.uniform_int(1, 3));  // in fives: on the circle, outside and, halved, inside
      polygon.push_back(random.unit() < 0.3 ? glm::vec<2, T>(x, y) * T(0.5) : glm::vec<2, T>(x, y) * size);
    }
    return polygon;
  }
  Polygon comb(int teeth) {
    Polygon polygon{{-9, -9}, {9, -9}};
    const double width = 12.0 / teeth;
    for (int i = teeth; i-- > 0;) {
      const double x = -6 + i * width;
      for (const auto& [at, y] : {std::pair{x + 0.9 * width, 9.0}, std::pair{x + 0.5 * width, 9.0}}) {
        polygon.push_back({static_cast<T>(at), static_cast<T>(y + random.uniform(-3, 3))});
      }
      for (const auto& [at, y] : {std::pair{x + 0.4 * width, -7.0}, std::pair{x + 0.1 * width, -7.0}}) {
        polygon.push_back({static_cast<T>(at), static_cast<T>(y + random.uniform(-1, 12))});
      }
    }
    return polygon;
  }
  Polygon inscribed(T radius) {
    Polygon polygon;
    const int corners = static_cast<int>(random.uniform_int(3, 9));
    for (int i = 0; i < corners; ++i) {
      polygon.push_back(on((i + random.uniform(0, 0.8)) * 360 / corners, radius));
    }
    return polygon;
  }
  /// Thin spikes from near the centre outwards; the gap at the circle is some 2^-40 to 2^-60.
  Polygon slivers(T radius) {
    Polygon polygon;
    const int spikes = static_cast<int>(random.uniform_int(3, 6));
    for (int i = 0; i < spikes; ++i) {
      const double degrees = (i + random.uniform(0.3, 0.5)) * 360 / spikes;
      polygon.push_back(on((i + 0.1) * 360 / spikes, radius * random.uniform(0.1, 0.4)));
      const auto tip = on(degrees, radius * random.uniform(1.0000001, 3));
      polygon.push_back(tip);
      auto other = tip;
      const int axis = std::abs(tip.x) < std::abs(tip.y) ? 0 : 1;  // counter-clockwise of it
      const T way = axis == 0 ? (tip.y > 0 ? T(-1e9) : T(1e9)) : (tip.x > 0 ? T(1e9) : T(-1e9));
      for (std::int64_t k = random.uniform_int(1, 3); k > 0; --k)
        other[axis] = std::nextafter(other[axis], way);
      polygon.push_back(other);
      // Back to nearly the same corner
      polygon.push_back(on((i + 0.9) * 360 / spikes, radius * random.uniform(0.1, 0.4)));
    }
    return polygon;
  }
};

struct Counts {
  int cases = 0, pieces = 0, several = 0, arcs = 0, on_circle = 0, doubtful = 0, empty = 0, whole = 0;
  double worst = 0;
};

/// Whether the passages stand in the order of their angles, in 400 bits, and how many neighbours doubles
/// could not tell.
void expect_sorted(const std::vector<dvec2>& corners, const Circle<double>& circle,
                   const std::vector<Crossing>& crossings, Counts& counts) {
  using Many = Float<400>;
  const auto direction = [&](const Crossing& c) {
    const Segment<2, double> s = edge_of(corners, c.edge);
    const Many dx = Many(s.b.x) - s.a.x, dy = Many(s.b.y) - s.a.y;
    const Many fx = Many(s.a.x) - circle.centre.x, fy = Many(s.a.y) - circle.centre.y;
    const Many k = dx * fy - dy * fx, A = dx * dx + dy * dy, r(circle.radius);
    const Many root = sqrt(Many(r * r * A - k * k)) * (c.leaves ? 1 : -1);
    return std::pair<Many, Many>((root * dx - k * dy) / A / r, (root * dy + k * dx) / A / r);
  };
  const auto tiny = pow(Many(2), -380);
  const auto half = [&](const std::pair<Many, Many>& p) {
    if (abs(p.second) > tiny) return p.second > 0 ? 0 : 1;
    return p.first > 0 ? 0 : 1;
  };
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const auto a = direction(crossings[i]), b = direction(crossings[i + 1]);
    const int half_a = half(a), half_b = half(b);
    ASSERT_LE(half_a, half_b);
    if (half_a != half_b) continue;
    const Many turn = a.first * b.second - a.second * b.first;
    ASSERT_GE(turn, -tiny);
    counts.doubtful += turn > tiny && turn < Many(0x1p-50);
  }
}

template <class T>
void expect_right(const typename Polygons<T>::Case& given, Counts& counts) {
  const auto& [polygon, circle] = given;
  Recorder<Oriented, Tested, Sorted, Entered, Walked, Bent, Closed, Finished<T>> seen;
  const Region<T> region = arcs(std::span<const glm::vec<2, T>>(polygon), circle, seen);
  double largest = circle.radius;
  for (const auto& p : polygon) largest = std::max<double>({largest, std::abs(p.x), std::abs(p.y)});
  const test::Enclosed got = test::enclosed_by(region);
  const Wide right = test::exact_area(polygon, circle);
  const auto length = static_cast<double>(got.length);
  // Counter-clockwise, each of them, but for slivers that rounding folds over
  const Wide r(circle.radius);
  EXPECT_GE(got.least, -r * r * Wide(std::numeric_limits<T>::epsilon()) * 100);
  const double size = std::min(largest, std::abs(double{circle.centre.x}) +
                                            std::abs(double{circle.centre.y}) + 2 * double{circle.radius});
  const double bound = 4 * (circle.radius + length) * size * std::numeric_limits<T>::epsilon();
  const double error = static_cast<double>(abs(Wide(got.area - right)));
  ASSERT_LE(error, bound);
  counts.worst = std::max(counts.worst, error / bound);
  ++counts.cases;
  counts.pieces += static_cast<int>(region.rings.size());
  counts.several += region.rings.size() > 1;
  counts.empty += region.rings.empty();
  for (const auto& ring : region.rings) {
    counts.whole += ring.size() == 1;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      counts.arcs += ring[i].arc;
      if (ring.size() > 1 && !ring[i].arc) ASSERT_NE(ring[i].at, ring[(i + 1) % ring.size()].at);
    }
  }
  const auto oriented = all<Oriented>(seen).at(0);
  const auto sorted = all<Sorted>(seen).at(0);
  for (const Crossing& c : sorted.crossings) counts.on_circle += c.corner.has_value();
  expect_sorted(oriented.corners, oriented.circle, sorted.crossings, counts);
}

template <class T>
Counts run_cases(std::uint64_t offset, int count) {
  Polygons<T> polygons(offset);
  Counts counts;
  for (int i = 0; i < count; ++i) {
    const auto given = polygons.next();
    std::vector<dvec2> corners = counter_clockwise(std::span<const glm::vec<2, T>>(given.polygon));
    if (meeting_edges(corners)) continue;
    SCOPED_TRACE(testing::Message() << "case " << i << ", " << given.polygon.size() << " corners, circle "
                                    << given.circle.centre.x << "," << given.circle.centre.y << ","
                                    << given.circle.radius);
    expect_right<T>(given, counts);
    if (testing::Test::HasFatalFailure()) return counts;
  }
  std::printf(
      "%d cases: %d pieces (%d with several), %d arcs, %d passages at corners, %d neighbours in doubt, "
      "%d empty, %d whole circles, worst %.3f of the bound\n",
      counts.cases, counts.pieces, counts.several, counts.arcs, counts.on_circle, counts.doubtful,
      counts.empty, counts.whole, counts.worst);
  EXPECT_GE(counts.cases, count / 2);
  EXPECT_GE(counts.several, count / 20);
  EXPECT_GE(counts.arcs, count);
  EXPECT_GE(counts.on_circle, count / 10);
  EXPECT_GE(counts.whole, count / 100);
  return counts;
}

TEST(PolygonCircleProperty, AreaAndOrderInDouble) {
  const Counts counts = run_cases<double>(1, static_cast<int>(test::cases(1'000, 60'000)));
  EXPECT_GE(counts.doubtful, counts.cases / 5) << "passages that doubles can't tell";
}

TEST(PolygonCircleProperty, AreaAndOrderInFloat) {
  run_cases<float>(2, static_cast<int>(test::cases(600, 60'000)));
}

/// The edges' pieces in the disc are the clipped segments, and every arc's middle lies in the polygon.
TEST(PolygonCircleProperty, PiecesAgreeWithSegmentsAndArcsLieInThePolygon) {
  Polygons<double> polygons(3);
  int arcs_seen = 0, pieces = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto [polygon, circle] = polygons.next();
    const auto corners = counter_clockwise(std::span<const dvec2>(polygon));
    if (meeting_edges(corners)) continue;
    Recorder<Oriented, Tested, Sorted, Entered, Walked, Bent, Closed, Finished<double>> seen;
    const Region<double> region = arcs(std::span<const dvec2>(polygon), circle, seen);
    for (const Tested& t : all<Tested>(seen)) {
      const auto kept = liang_barsky_circle::exact_decision(t.run.edge, circle);
      if (!t.run.inside) {
        if (kept) ASSERT_EQ(kept->a, kept->b);
        continue;
      }
      ++pieces;
      ASSERT_EQ(kept->a, t.enters.value_or(t.run.edge.a));
      ASSERT_EQ(kept->b, t.leaves.value_or(t.run.edge.b));
    }
    for (const Ring<double>& ring : region.rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        if (!ring[k].arc) continue;
        const ArcEnds arc = ends_of_arc(ring, k, circle);
        if (arc.radians < 1e-3) continue;
        const SinCos at = sin_cos(atan2(arc.from.y, arc.from.x) + arc.radians / 2);
        ASSERT_TRUE(contains(corners, circle.centre + circle.radius * dvec2(at.cos, at.sin)));
        ++arcs_seen;
      }
    }
  }
  EXPECT_GE(arcs_seen, 2000);
  EXPECT_GE(pieces, 4000);
}

/// Polygons with an edge of any size at a circle of any other: which edges run in the disc, where they enter
/// and leave, and that entries and exits alternate.
TEST(PolygonCircleProperty, MixedSizesAgainstExactArithmetic) {
  Random random(test::seed() + 5);
  const int count = static_cast<int>(test::cases(1'000, 60'000));
  int simple = 0, inside = 0, cut = 0, rings = 0;
  for (int i = 0; i < count; ++i) {
    const stress::Input n = stress::of_mixed_sizes(random);
    SCOPED_TRACE(testing::Message() << "case " << i << ": " << fmt::format("{:a}", fmt::join(n, ",")));
    const Circle<double> circle{{n[4], n[5]}, n[6]};
    const double third = stress::sized(random, -1074, 1023);
    std::vector<dvec2> polygon{{n[0], n[1]}, {n[2], n[3]}, {third, stress::sized(random, -1074, 1023)}};
    if (random.unit() < 0.5) polygon.push_back({stress::sized(random, -1074, 1023), third});
    if (meeting_edges(counter_clockwise(std::span<const dvec2>(polygon)))) continue;
    Recorder<Oriented, Tested, Sorted, Entered, Walked, Bent, Closed, Finished<double>> seen;
    const Region<double> region = arcs(std::span<const dvec2>(polygon), circle, seen);
    simple += !all<Tested>(seen).empty();
    rings += static_cast<int>(region.rings.size());
    for (const Tested& t : all<Tested>(seen)) {
      const dvec2 a = t.run.edge.a, b = t.run.edge.b;
      const auto right = stress::ends_in_circle({a.x, a.y, b.x, b.y, n[4], n[5], n[6]});
      ASSERT_EQ(t.run.inside, right && right->runs);
      if (!t.run.inside) continue;
      ++inside;
      cut += !right->from_is_given || !right->to_is_given;
      ASSERT_LE(right->from.error(t.enters.value_or(a)), 0.63);
      ASSERT_LE(right->to.error(t.leaves.value_or(b)), 0.63);
    }
  }
  std::printf("%d polygons, %d edges inside, %d cut, %d rings\n", simple, inside, cut, rings);
  EXPECT_GE(simple, count / 2);
  EXPECT_GE(inside, count / 4);
  EXPECT_GE(cut, count / 4);
  EXPECT_GE(rings, count / 8);
}

TEST(PolygonCircleProperty, ChordsKeepTheTolerance) {
  Polygons<double> polygons(4);
  int chords = 0;
  double closest = 0;
  for (int i = 0; i < 150; ++i) {
    const auto [polygon, circle] = polygons.next();
    if (meeting_edges(counter_clockwise(std::span<const dvec2>(polygon)))) continue;
    const Region<double> region = arcs(std::span<const dvec2>(polygon), circle);
    const double tolerance =
        circle.radius * std::ldexp(1, -static_cast<int>(polygons.random.uniform_int(1, 14)));
    const auto flat = flatten(region, tolerance);
    ASSERT_EQ(flat.size(), region.rings.size());
    const Wide r(circle.radius),
        epsilon = (r + std::abs(circle.centre.x) + std::abs(circle.centre.y)) * 0x1p-50;
    for (std::size_t ring = 0; ring < flat.size(); ++ring) {
      // Corners that came with the ring, and new ones between
      std::size_t at = 0;
      for (std::size_t k = 0; k < region.rings[ring].size(); ++k) {
        ASSERT_EQ(flat[ring][at], region.rings[ring][k].at);
        const dvec2 next = region.rings[ring][(k + 1) % region.rings[ring].size()].at;
        const bool last = k + 1 == region.rings[ring].size();
        do {
          const Point p = wide(flat[ring][at]), q = wide(flat[ring][(at + 1) % flat[ring].size()]);
          const Point middle{(p.x + q.x) / 2 - circle.centre.x, (p.y + q.y) / 2 - circle.centre.y};
          ++at;
          if (!region.rings[ring][k].arc) break;
          ++chords;
          const Wide sagitta = r - sqrt(dot(middle, middle));
          ASSERT_LE(sagitta, Wide(tolerance) + epsilon);
          ASSERT_GE(sagitta, -epsilon);
          closest = std::max(closest, static_cast<double>(sagitta / tolerance));
        } while (last ? at < flat[ring].size() : flat[ring][at] != next);
      }
      ASSERT_EQ(at, flat[ring].size());
    }
  }
  std::printf("%d chords, sagitta at most %.6f of the tolerance\n", chords, closest);
  EXPECT_GE(chords, 3000);
  EXPECT_GE(closest, 0.9);
}

}  // namespace
}  // namespace gradus::polygon_circle
