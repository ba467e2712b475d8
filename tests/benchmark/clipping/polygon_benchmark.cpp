// Polygon clippers side by side on one set of polygons, with what each gets wrong. Compare within one run:
// the ratios are the result, not the times.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <stdexcept>

#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_notes.hpp"
#include "core/exact_scalar.hpp"
#include "core/geometry.hpp"
#include "core/random.hpp"

namespace gradus::sutherland_hodgman {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false, false>;  // counter-clockwise, not closed
using BoostBox = bg::model::box<BoostPoint>;

constexpr Rectangle<double> window{{0, 0}, {1, 1}};
const std::vector<int> order{0, 1, 2, 3};

/// 2000 star-shaped polygons of 4 to 16 vertices: 0 inside the window, 1 most of them across its border, 2
/// outside, 3 all of these.
const Polygons& polygons(int mix) {
  static const auto made = [] {
    std::vector<Polygons> sets(4);
    Random random(1);
    while (sets[3].size() < 6000) {
      const std::size_t set = sets[3].size() % 3;
      const auto vertices = static_cast<int>(random.uniform_int(4, 16));
      const double size = set == 1 ? random.uniform(0.1, 0.8) : random.uniform(0.02, 0.1);
      dvec2 centre{random.uniform(0.11, 0.89), random.uniform(0.11, 0.89)};
      if (set == 1) centre[static_cast<int>(random.uniform_int(0, 1))] = random.uniform_int(0, 1) ? 1 : 0;
      if (set == 2)
        centre[static_cast<int>(random.uniform_int(0, 1))] = random.uniform_int(0, 1) ? 1.2 : -0.2;
      std::vector<dvec2> points;
      for (int i = 0; i < vertices; ++i) {
        const double angle = 2 * M_PI * i / vertices, radius = size * random.uniform(0.3, 1);
        points.push_back(centre + radius * dvec2(std::cos(angle), std::sin(angle)));
      }
      sets[set].add(points);
      sets[3].add(points);
    }
    return sets;
  }();
  return made[static_cast<std::size_t>(mix)];
}
const char* name(int mix) {
  const char* const names[] = {"inside", "crossing", "outside", "all three"};
  return names[mix];
}

/// Twice the area, exactly, from the exact places of what clip_to_window remembers.
Exact exact_area(std::span<const dvec2> points) {
  std::vector<ExactVec2> given;
  for (const dvec2 p : points) given.push_back({Exact(p.x), Exact(p.y)});
  const Rectangle<Exact> same{{Exact(0), Exact(0)}, {Exact(1), Exact(1)}};
  Exact doubled(0);
  const auto ring = clip_to_window(std::span<const ExactVec2>(given), same);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto &a = ring[i].at, &b = ring[(i + 1) % ring.size()].at;
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled;
}
double area(std::span<const dvec2> ring) {
  double doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

/// The rings of each polygon of a set, as a method gives them.
using Results = std::vector<std::vector<std::vector<dvec2>>>;

double ulp(double x) { return std::nextafter(std::abs(x), 2.0) - std::abs(x); }

/// What a method gets wrong on a set: the largest error of an area, that of a vertex beside the exactly
/// rounded one (in ulp of its larger coordinate), and polygons whose vertices aren't as many as they should.
void count_errors(benchmark::State& state, const Results& results) {
  const Polygons& set = polygons(static_cast<int>(state.range(0)));
  double worst_area = 0, worst_vertex = 0;
  std::size_t off = 0, vertices = 0, wrong = 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const ExactScope scope;
    double own = 0;
    for (const auto& ring : results[i]) own += area(ring);
    const double wanted = to_double(exact_area(set[i]) / Exact(2));
    worst_area = std::max(worst_area, std::abs(own - wanted));
    wrong += std::abs(own - wanted) > 1e-9;
    std::vector<dvec2> right;
    for (const auto& v : clip_to_window(set[i], window)) right.push_back(v.at);
    for (const auto& ring : results[i]) {
      for (const dvec2 p : ring) {
        // Beside the nearest vertex of the exact result
        const auto nearest = std::min_element(right.begin(), right.end(), [&](dvec2 a, dvec2 b) {
          return glm::length(a - p) < glm::length(b - p);
        });
        if (nearest == right.end()) continue;
        const dvec2 miss = glm::abs(*nearest - p);
        const double ulps =
            std::max(miss.x, miss.y) / ulp(std::max(std::abs(nearest->x), std::abs(nearest->y)));
        ++vertices;
        off += ulps > 0;
        worst_vertex = std::max(worst_vertex, ulps);
      }
    }
  }
  state.SetLabel(name(static_cast<int>(state.range(0))));
  state.counters["area_error"] = worst_area;
  state.counters["vertex_ulp"] = worst_vertex;
  state.counters["vertices_off_%"] =
      vertices ? 100.0 * static_cast<double>(off) / static_cast<double>(vertices) : 0;
  state.counters["wrong_areas"] = static_cast<double>(wrong);
}

/// Times `all(set)`, whose results `collect` reads once.
template <class All, class Collect>
void time_clipping(benchmark::State& state, All all, Collect collect) {
  const Polygons& set = polygons(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    all(set);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(set.points.size()));
  count_errors(state, collect(set));
}

/// The same for methods that take one polygon and give vertices.
template <class One>
void time_one_by_one(benchmark::State& state, One one) {
  time_clipping(
      state,
      [&](const Polygons& set) {
        for (std::size_t i = 0; i < set.size(); ++i) {
          auto result = one(set[i]);
          benchmark::DoNotOptimize(result.data());
        }
      },
      [&](const Polygons& set) {
        Results results(set.size());
        for (std::size_t i = 0; i < set.size(); ++i) {
          std::vector<dvec2> ring;
          for (const auto& v : one(set[i])) ring.push_back(v.at);
          results[i].push_back(ring);
        }
        return results;
      });
}

void BM_ClipToWindow(benchmark::State& state) {
  time_one_by_one(state, [](std::span<const dvec2> points) {
    return clip_to_window(points, window, std::span<const int>(order));
  });
}

void BM_CutOfACut(benchmark::State& state) {
  time_one_by_one(state, [](std::span<const dvec2> points) {
    return by_passes(Task<double>{points, window, order},
                     [](auto polygon, auto border) { return cut_of_a_cut(polygon, border); });
  });
}

void BM_Batch(benchmark::State& state) {
  BatchClipper clip;
  Polygons result;
  time_clipping(
      state, [&](const Polygons& set) { clip(set, window, result); },
      [&](const Polygons& set) {
        clip(set, window, result);
        Results results;
        for (std::size_t i = 0; i < result.size(); ++i) {
          results.push_back({std::vector<dvec2>(result[i].begin(), result[i].end())});
          // The same bits as one by one
          const auto single = clip_to_window(set[i], window);
          bool same = single.size() == results[i][0].size();
          for (std::size_t k = 0; same && k < single.size(); ++k) same = single[k].at == results[i][0][k];
          if (!same) throw std::logic_error("the batch gives other vertices");
        }
        return results;
      });
}

void BM_SeparatePieces(benchmark::State& state) {
  const auto one = [](std::span<const dvec2> points) {
    const std::vector<std::vector<dvec2>> rings{{points.begin(), points.end()}};
    return separate_pieces(Rings<double>(std::span<const std::vector<dvec2>>(rings)), window,
                           std::span<const int>(order));
  };
  time_clipping(
      state,
      [&](const Polygons& set) {
        for (std::size_t i = 0; i < set.size(); ++i) {
          auto pieces = one(set[i]);
          benchmark::DoNotOptimize(pieces.data());
        }
      },
      [&](const Polygons& set) {
        Results results(set.size());
        for (std::size_t i = 0; i < set.size(); ++i) {
          for (const auto& piece : one(set[i])) {
            results[i].emplace_back();
            for (const auto& v : piece.outline) results[i].back().push_back(v.at);
          }
        }
        return results;
      });
}

void BM_BoostGeometry(benchmark::State& state) {
  // Polygons in Boost's own form are made before the clock starts
  std::vector<BoostPolygon> given;
  const Polygons& set = polygons(static_cast<int>(state.range(0)));
  for (std::size_t i = 0; i < set.size(); ++i) {
    given.emplace_back();
    for (const dvec2 p : set[i]) given.back().outer().emplace_back(p.x, p.y);
  }
  const BoostBox box({0, 0}, {1, 1});
  std::vector<BoostPolygon> result;
  time_clipping(
      state,
      [&](const Polygons&) {
        for (const BoostPolygon& polygon : given) {
          result.clear();
          bg::intersection(polygon, box, result);
          benchmark::DoNotOptimize(result.data());
        }
      },
      [&](const Polygons&) {
        Results results;
        for (const BoostPolygon& polygon : given) {
          result.clear();
          bg::intersection(polygon, box, result);
          results.emplace_back();
          for (const BoostPolygon& piece : result) {
            results.back().emplace_back();
            for (const BoostPoint& p : piece.outer()) results.back().back().emplace_back(p.x(), p.y());
          }
        }
        return results;
      });
}

void BM_ReadTheInputAlone(benchmark::State& state) {
  const Polygons& set = polygons(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    dvec2 sum(0);
    for (const dvec2 p : set.points) sum += p;
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(set.points.size()));
  state.SetLabel(name(static_cast<int>(state.range(0))));
}

BENCHMARK(BM_ReadTheInputAlone)->DenseRange(0, 3);
BENCHMARK(BM_Batch)->DenseRange(0, 3);
BENCHMARK(BM_ClipToWindow)->DenseRange(0, 3);
BENCHMARK(BM_CutOfACut)->DenseRange(0, 3);
BENCHMARK(BM_SeparatePieces)->DenseRange(0, 3);
BENCHMARK(BM_BoostGeometry)->DenseRange(0, 3);

}  // namespace
}  // namespace gradus::sutherland_hodgman
