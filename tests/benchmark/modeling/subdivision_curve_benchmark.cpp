// A smooth curve as points: by rounds of cutting corners, and by as many points of each parabola.

#include "modeling/subdivision_curve/subdivision_curve.hpp"

#include <fmt/format.h>

#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

using namespace subdivision_curve;
using Polygon = Points<double>;

const Polygon& polygon() {
  static const Polygon points = [] {
    Random random(7);
    Polygon all;
    for (int i = 0; i < 64; ++i) all.push_back({random.uniform(-8, 8), random.uniform(-8, 8)});
    return all;
  }();
  return points;
}

/// A point of each arc at every n-th part of it.
Polygon sampled(int pieces) {
  Polygon points;
  limit<double>(polygon(), Ends::closed, [&](const Parabola<double>& arc) {
    for (int k = 0; k < pieces; ++k) points.push_back(arc.at(static_cast<double>(k) / pieces));
  });
  return points;
}

/// How far the limit's own points lie from the polygon that stands for it: the farthest, and the root of the
/// mean square.
Error off_the_limit(const Polygon& points) {
  Error::Sum sum;
  constexpr int tried = 37;  // places that no method takes
  const std::size_t n = points.size();
  for (const dvec2 p : sampled(tried)) {
    double nearest = 1e300;
    for (std::size_t i = 0; i < n; ++i) {
      const dvec2 a = points[i], way = points[(i + 1) % n] - a;
      const double t = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
      nearest = std::min(nearest, glm::length(p - a - t * way));
    }
    sum.add(nearest);
  }
  return sum.error();
}

template <class Make>
Case case_of(const char* method, Standing standing, int rounds, const Make& make) {
  const auto points = std::make_shared<Polygon>(make());
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("{} rounds", rounds), static_cast<double>(rounds)},
          .items = std::ssize(*points),
          .run = [points, make] { *points = make(); },
          .error = off_the_limit(*points)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int rounds : {1, 2, 3, 4, 5}) {
    all.push_back(case_of("chaikin", Standing::taught, rounds,
                          [rounds] { return chaikin<double>(polygon(), rounds, Ends::closed); }));
    all.push_back(case_of("limit", Standing::robust, rounds, [rounds] { return sampled(1 << rounds); }));
  }
  return all;
}

}  // namespace

Subject subdivision_curve() {
  return {.topic = "subdivision_curve",
          .title = "Smooth curves as points",
          .item = "point",
          .unit = "units of length",
          .measure = "rounds",
          .telling = "3 rounds",
          .cases = cases,
          .choice = {"limit", "on the curve itself, and no round in between is kept"}};
}

}  // namespace gradus::bench
