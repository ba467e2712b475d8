// A bicubic patch as a mesh of n x n faces: rows reduced once for each column of points, or for each point.

#include "modeling/bezier_patch/bezier_patch.hpp"

#include <fmt/format.h>

#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

using namespace bezier_patch;
using Net = Patch<double>;
using Mesh3 = Points<double>;

const Net& net() {
  static const Net made = [] {
    Random random(7);
    Net all{4, {}};
    for (int i = 0; i < 16; ++i) all.points.push_back({i % 4 * 4.0, random.uniform(-8, 8), -(i / 4) * 4.0});
    return all;
  }();
  return made;
}

/// The point at (u, v) as a sum of Bernstein polynomials.
dvec3 right_at(double u, double v) {
  const auto weights = [](double t) {
    const double s = 1 - t;
    return std::array{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  };
  const auto a = weights(u), b = weights(v);
  dvec3 sum{0};
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) sum += a[i] * b[j] * net()(j, i);
  }
  return sum;
}

/// How far the surface lies from the mesh at the same u and v, faces taken as triangles.
Error off_the_surface(const Mesh3& points, int n) {
  Error::Sum sum;
  constexpr int tried = 61;
  for (int k = 0; k <= tried; ++k) {
    for (int i = 0; i <= tried; ++i) {
      const dvec2 place = dvec2(i, k) / static_cast<double>(tried);
      const dvec2 cell = glm::min(glm::floor(place * static_cast<double>(n)), dvec2(n - 1));
      const dvec2 part = place * static_cast<double>(n) - cell;
      const auto at = [&](double x, double y) {
        return points[static_cast<std::size_t>((cell.y + y) * (n + 1) + cell.x + x)];
      };
      const dvec3 along = part.x > part.y ? at(1, 0) - at(0, 0) : at(1, 1) - at(0, 1);
      const dvec3 up = part.x > part.y ? at(1, 1) - at(1, 0) : at(0, 1) - at(0, 0);
      sum.add(glm::length(at(0, 0) + part.x * along + part.y * up - right_at(place.x, place.y)));
    }
  }
  return sum.error();
}

Mesh3 point_by_point(int n) {
  Mesh3 points;
  for (int k = 0; k <= n; ++k) {
    for (int i = 0; i <= n; ++i)
      points.push_back(de_casteljau(net(), static_cast<double>(i) / n, static_cast<double>(k) / n).point);
  }
  return points;
}

template <class Make>
Case case_of(const char* method, Standing standing, int n, const Make& make) {
  const auto points = std::make_shared<Mesh3>(make());
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("{0} × {0} faces", n), static_cast<double>(n)},
          .items = std::int64_t{n} * n,
          .run = [points, make] { *points = make(); },
          .error = off_the_surface(*points, n)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int n : {4, 8, 16, 32, 64}) {
    all.push_back(case_of("on_grid", Standing::robust, n, [n] { return on_grid(net(), n, n).points; }));
    all.push_back(case_of("de_casteljau", Standing::taught, n, [n] { return point_by_point(n); }));
  }
  return all;
}

}  // namespace

Subject bezier_patch() {
  return {.topic = "bezier_patch",
          .title = "A patch as a mesh",
          .item = "face",
          .unit = "units of length",
          .measure = "faces along a side",
          .telling = "16 × 16 faces",
          .cases = cases,
          .choice = {"on_grid", "the same points, and rows are reduced once for each column"}};
}

}  // namespace gradus::bench
