// Polygons cut into triangles: corner by corner round the ring, the widest ears first, by a tree of the
// corners, and without a look inside.

#include "modeling/ear_clipping/ear_clipping.hpp"

#include <cmath>
#include <memory>

#include "benchmark/subject.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/geometry.hpp"
#include "core/random.hpp"
#include "modeling/ear_clipping/ear_clipping_notes.hpp"
#include "modeling/ear_clipping/many_corners.hpp"
#include "modeling/ear_clipping/widest_ear.hpp"

namespace gradus::bench {
namespace {

using namespace ear_clipping;
using Polygon = std::vector<dvec2>;

/// Corners round a middle, at any distance from it.
Polygon star(int corners) {
  Random random(7);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const SinCos at = sin_cos(0x1.921fb54442d18p2 * i / corners);
    polygon.push_back(random.uniform(2, 8) * dvec2(at.cos, at.sin));
  }
  return polygon;
}

/// What is covered beside the polygon or more than once, in percent of its area.
Error covered_too_much(const Polygon& polygon, const std::vector<Triangle>& triangles) {
  const auto area = [](dvec2 a, dvec2 b, dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const auto at = [&](int i) { return polygon[static_cast<std::size_t>(i)]; };
  double whole = 0, turned = 0;
  for (const Triangle& t : triangles) {
    const double doubled = area(at(t[0]), at(t[1]), at(t[2]));
    whole += doubled;
    turned += doubled < 0 ? -2 * doubled : 0;
  }
  Error::Sum sum;
  sum.add(100 * turned / whole);
  return sum.error();
}

template <class Cut>
Case case_of(const char* method, Standing standing, int corners, const Cut& cut) {
  const auto polygon = std::make_shared<Polygon>(star(corners));
  const auto triangles = std::make_shared<std::vector<Triangle>>();
  const auto run = [polygon, triangles, cut] {
    triangles->clear();
    cut(std::span<const dvec2>(*polygon), [&](const Triangle& t) { triangles->push_back(t); });
  };
  run();
  return {.method = method,
          .standing = standing,
          .workload = {std::to_string(corners) + " corners", static_cast<double>(corners)},
          .items = std::ssize(*triangles),
          .run = run,
          .error = covered_too_much(*polygon, *triangles)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int n : {8, 32, 128, 512}) {
    all.push_back(case_of("triangulate", Standing::taught, n, [](auto... run) { triangulate(run...); }));
    all.push_back(case_of("widest_ear", Standing::robust, n, [](auto... run) { widest_ear(run...); }));
    all.push_back(
        case_of("triangulate_many", Standing::batch, n, [](auto... run) { triangulate_many(run...); }));
    all.push_back(case_of("convex_only", Standing::faulty, n, [](auto... run) { convex_only(run...); }));
  }
  return all;
}

}  // namespace

Subject ear_clipping() {
  return {.topic = "ear_clipping",
          .title = "Polygons cut into triangles",
          .item = "triangle",
          .unit = "percent covered too much",
          .measure = "corners",
          .telling = "128 corners",
          .cases = cases,
          .choice = {"triangulate", "up to some hundred corners; beyond, triangulate_many"}};
}

}  // namespace gradus::bench
