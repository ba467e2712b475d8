// Segments and polygons in circles: million a second, and beside it how far the points are off. Compare
// within one run: the ratios are the result, not the times.
//
// There is no circle in OpenCV's or Boost.Geometry's clippers, so segments have no peer but the notes'
// listings; polygons are compared with Boost.Geometry's intersection with a polygon of 360 points.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_batch.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_notes.hpp"
#include "clipping/polygon_circle/polygon_circle.hpp"
#include "clipping/polygon_circle/polygon_circle_notes.hpp"

namespace gradus {
namespace {

using liang_barsky_circle::Circle;
using liang_barsky_circle::Segment;
using Ends = Segment<double>;
using Kept = std::optional<Ends>;
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<400, boost::multiprecision::digit_base_2>>;

constexpr Circle<double> circle{{0.3, -0.2}, 5};

/// The answer in 400 bits, rounded once.
Kept reference(const Ends& s) {
  const Wide dx = Wide(s.to.x) - s.from.x, dy = Wide(s.to.y) - s.from.y;
  const Wide fx = Wide(s.from.x) - circle.centre.x, fy = Wide(s.from.y) - circle.centre.y;
  const Wide r(circle.radius), A = dx * dx + dy * dy, B = fx * dx + fy * dy, C = fx * fx + fy * fy - r * r;
  const Wide D = B * B - A * C;
  if (D < 0) return std::nullopt;
  const Wide root = sqrt(D), enters = (-B - root) / A, leaves = (-B + root) / A;
  if (enters > 1 || leaves < 0) return std::nullopt;
  Ends kept = s;
  const auto at = [&](const Wide& t) {
    return dvec2(Wide(s.from.x + t * dx).convert_to<double>(), Wide(s.from.y + t * dy).convert_to<double>());
  };
  if (enters > 0) kept.from = at(enters);
  if (leaves < 1) kept.to = at(leaves);
  return kept;
}

const char* const mixes[] = {"inside", "crossing", "outside", "grazing"};

/// 1000 segments: 0 inside, 1 with at least one end outside and a part inside, 2 outside, 3 that pass the
/// circle's rim within 1e-12 of it.
const std::vector<Ends>& segments(int mix) {
  static const auto made = [] {
    std::vector<std::vector<Ends>> sets(4);
    std::mt19937_64 random(1);
    const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    const auto point = [&] {
      const double x = 20 * unit() - 10;
      return dvec2(x, 20 * unit() - 10);
    };
    while (std::min({sets[0].size(), sets[1].size(), sets[2].size()}) < 1000) {
      const dvec2 a = point();
      const Ends s{a, point()};
      const Kept kept = reference(s);
      auto& set = sets[!kept ? 2 : *kept == s ? 0 : 1];
      if (set.size() < 1000) set.push_back(s);
    }
    while (sets[3].size() < 1000) {
      const SinCos at = sin_cos(6.2832 * unit());
      const dvec2 n(at.cos, at.sin), along(-n.y, n.x);
      const dvec2 foot = circle.centre + (circle.radius + 1e-12 * (unit() - 0.5)) * n;
      const double before = 1 + 5 * unit(), after = 1 + 5 * unit();
      sets[3].push_back({foot - before * along, foot + after * along});
    }
    return sets;
  }();
  return made[static_cast<std::size_t>(mix)];
}

double ulps(double got, double right) {
  const double size = std::max(std::abs(right), circle.radius);
  return std::abs(got - right) / (std::nextafter(size, 1e300) - size);
}

/// Counters of a mix: `wrong` decisions of 1000, and the `worst` point in ulp of max(|coordinate|, r).
/// got: number i is what a method made of segment i.
void count_errors(benchmark::State& state, const std::vector<Kept>& got) {
  const auto& set = segments(static_cast<int>(state.range(0)));
  double wrong = 0, worst = 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Kept right = reference(set[i]);
    wrong += got[i].has_value() != right.has_value();
    if (!got[i] || !right) continue;
    for (const auto& [a, b] : {std::pair{got[i]->from, right->from}, std::pair{got[i]->to, right->to}}) {
      worst = std::max({worst, ulps(a.x, b.x), ulps(a.y, b.y)});
    }
  }
  state.SetLabel(mixes[state.range(0)]);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(set.size()));
  state.counters["wrong"] = wrong;
  state.counters["worst_ulp"] = worst;
}

/// Times `clip(segment, circle)` over a mix.
template <class Clip>
void time_segments(benchmark::State& state, Clip clip) {
  const auto& set = segments(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    for (const Ends& s : set) benchmark::DoNotOptimize(clip(s, circle));
  }
  std::vector<Kept> got;
  for (const Ends& s : set) got.push_back(clip(s, circle));
  count_errors(state, got);
}

void BM_HalfChord(benchmark::State& state) {
  time_segments(state, [](const Ends& s, const auto& c) { return liang_barsky_circle::half_chord(s, c); });
}
void BM_ExactDecision(benchmark::State& state) {
  time_segments(state,
                [](const Ends& s, const auto& c) { return liang_barsky_circle::exact_decision(s, c); });
}
/// All segments of the mix at once. Counter besides: how many of the 1000 had no certificate.
void BM_Batch(benchmark::State& state) {
  const auto& set = segments(static_cast<int>(state.range(0)));
  std::vector<Ends> clipped(set.size());
  std::vector<std::uint8_t> accepted(set.size());
  liang_barsky_circle::BatchCount count;
  for (auto _ : state) {
    count = liang_barsky_circle::clip_batch(set, circle, clipped, accepted);
    benchmark::DoNotOptimize(clipped.data());
    benchmark::ClobberMemory();
  }
  std::vector<Kept> got;
  for (std::size_t i = 0; i < set.size(); ++i) got.push_back(accepted[i] ? Kept(clipped[i]) : std::nullopt);
  count_errors(state, got);
  state.counters["one_by_one"] = static_cast<double>(count.one_by_one);
}
void BM_WithoutEmptyTest(benchmark::State& state) {
  time_segments(state,
                [](const Ends& s, const auto& c) { return liang_barsky_circle::without_empty_test(s, c); });
}
void BM_DiscriminantEqualsZero(benchmark::State& state) {
  time_segments(state, [](const Ends& s, const auto& c) {
    return liang_barsky_circle::discriminant_equals_zero(s, c);
  });
}

// --- Polygons ---------------------------------------------------------------------------------------------

using Polygon = std::vector<dvec2>;
namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Peer = bg::model::polygon<Point, false, true>;  // counter-clockwise, closed

const char* const polygon_mixes[] = {"inside", "crossing", "outside"};

/// 200 star-shaped polygons of 12 corners: 0 inside, 1 round the rim, 2 outside.
const std::vector<Polygon>& polygons(int mix) {
  static const auto made = [] {
    std::vector<std::vector<Polygon>> sets(3);
    std::mt19937_64 random(2);
    const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    const double least[] = {1, 2, 1}, most[] = {4.5, 9, 4};
    for (std::size_t set = 0; set < 3; ++set) {
      for (int i = 0; i < 200; ++i) {
        Polygon polygon;
        const dvec2 middle = set == 2 ? dvec2(12, 3) : circle.centre;
        for (int k = 0; k < 12; ++k) {
          const SinCos at = sin_cos_degrees(30 * (k + 0.1 + 0.8 * unit()));
          polygon.push_back(middle +
                            (least[set] + (most[set] - least[set]) * unit()) * dvec2(at.cos, at.sin));
        }
        sets[set].push_back(polygon);
      }
    }
    return sets;
  }();
  return made[static_cast<std::size_t>(mix)];
}

Peer peer_of(const Polygon& polygon) {
  Peer peer;
  for (const dvec2 p : polygon) bg::append(peer.outer(), Point(p.x, p.y));
  bg::append(peer.outer(), Point(polygon[0].x, polygon[0].y));
  return peer;
}

double shoelace(const Polygon& polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

/// Times `clip(polygon)`, which returns something, and takes its area with `area_of`. Counter: the worst
/// error of an area, in parts of the circle's.
template <class Clip, class Area>
void time_polygons(benchmark::State& state, Clip clip, Area area_of) {
  const auto& set = polygons(static_cast<int>(state.range(0)));
  double worst = 0;
  std::int64_t corners = 0;
  for (const Polygon& polygon : set) {
    const double right = area(polygon_circle::arcs(std::span<const dvec2>(polygon), circle));
    worst = std::max(worst, std::abs(area_of(clip(polygon)) - right) / (3.14159 * 25));
    corners += static_cast<std::int64_t>(polygon.size());
  }
  for (auto _ : state) {
    for (const Polygon& polygon : set) benchmark::DoNotOptimize(clip(polygon));
  }
  state.SetLabel(polygon_mixes[state.range(0)]);
  state.SetItemsProcessed(state.iterations() * corners);
  state.counters["worst_area"] = worst;
}

void BM_Arcs(benchmark::State& state) {
  time_polygons(
      state, [](const Polygon& p) { return polygon_circle::arcs(std::span<const dvec2>(p), circle); },
      [](const auto& region) { return polygon_circle::area(region); });
}
/// With chords as close as those of 360 points.
void BM_ArcsFlattened(benchmark::State& state) {
  const double tolerance = circle.radius * (1 - cos(0x1.921fb54442d18p1 / 360));
  time_polygons(
      state,
      [&](const Polygon& p) {
        return polygon_circle::flatten(polygon_circle::arcs(std::span<const dvec2>(p), circle), tolerance);
      },
      [](const auto& flat) {
        double sum = 0;
        for (const Polygon& polygon : flat) sum += shoelace(polygon);
        return sum;
      });
}
void BM_FirstCrossing(benchmark::State& state) {
  time_polygons(
      state,
      [](const Polygon& p) { return polygon_circle::first_crossing(std::span<const dvec2>(p), circle); },
      [](const Polygon& kept) { return shoelace(kept); });
}
/// Boost.Geometry has no circle: intersection with a polygon of 360 points on it. Reading the polygon into
/// Boost's own is not timed.
void BM_BoostGeometry360(benchmark::State& state) {
  Polygon points;
  for (int i = 0; i < 360; ++i) {
    const SinCos at = sin_cos_degrees(i);
    points.push_back(circle.centre + circle.radius * dvec2(at.cos, at.sin));
  }
  const Peer disc = peer_of(points);
  std::vector<Peer> peers;
  for (const Polygon& polygon : polygons(static_cast<int>(state.range(0)))) peers.push_back(peer_of(polygon));
  std::size_t next = 0;
  time_polygons(
      state,
      [&](const Polygon&) {
        std::vector<Peer> pieces;
        bg::intersection(peers[next], disc, pieces);
        next = (next + 1) % peers.size();
        return pieces;
      },
      [](const std::vector<Peer>& pieces) {
        double sum = 0;
        for (const Peer& piece : pieces) sum += bg::area(piece);
        return sum;
      });
}

BENCHMARK(BM_HalfChord)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ExactDecision)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Batch)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_WithoutEmptyTest)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DiscriminantEqualsZero)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Arcs)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ArcsFlattened)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_FirstCrossing)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_BoostGeometry360)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gradus
