// From triangles in space to an order from back to front: as Newell, Newell and Sancha sort, move and cut, by
// sorting alone, and by a BSP tree, each with the rays along which its picture shows the wrong triangle.

#include "visibility/painter/painter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "visibility/painter/painter_notes.hpp"

namespace gradus::bench {
namespace {

using namespace painter;

using Scene = std::vector<Polygon<double>>;
constexpr dvec3 towards{0.2, 0.3, 1};

/// So many triangles of about this size in a cube from -1 to 1.
Scene scene_of(int count, double size) {
  Random random(7, static_cast<std::uint64_t>(count));
  const auto within = [&](double most) {
    return dvec3{random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
  };
  Scene scene;
  for (int i = 0; i < count; ++i) {
    const dvec3 middle = within(1 - size);
    scene.push_back({{middle + within(size), middle + within(size), middle + within(size)}, std::size_t(i)});
  }
  return scene;
}

/// So many times three triangles, each over the next, one cycle behind the other.
Scene cycles_of(int count) {
  Scene scene;
  for (int k = 0; k < count; ++k) {
    const double z = -0.9 + 1.8 * k / count, step = 0.4 / count;
    const std::array<dvec3, 3> ends{{{-0.9, -0.8, z}, {0.9, -0.8, z}, {0, 0.9, z}}};
    for (std::size_t i = 0; i < 3; ++i) {
      const dvec3 a = ends[i] + dvec3{0, 0, step}, b = ends[(i + 1) % 3], way = b - a;
      const dvec3 aside{-0.15 * way.y, 0.15 * way.x, 0};
      scene.push_back({{a - 0.1 * way, b + 0.1 * way - aside, b + 0.1 * way + aside}, scene.size()});
    }
  }
  return scene;
}

/// Where the sight line through `from` meets a polygon, as a multiple of the way to the viewer.
std::optional<double> hit(const Polygon<double>& polygon, dvec3 from) {
  const auto& [a, b, c] = polygon.plane;
  const auto& p = polygon.corners;
  const dvec3 normal = glm::cross(b - a, c - a);
  const double t = glm::dot(normal, a - from) / glm::dot(normal, towards);
  const dvec3 at = from + t * towards;
  int turn = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double side = glm::dot(normal, glm::cross(p[(i + 1) % p.size()] - p[i], at - p[i]));
    const int sign = (side > 0) - (side < 0);
    if (sign == 0 || sign == -turn) return std::nullopt;
    turn = sign;
  }
  return t;
}

/// Rays along which the last polygon of the order is not the nearest of the scene.
Error error_of(const Scene& scene, const Scene& order) {
  Random random(11);
  Error::Sum sum;
  for (int ray = 0; ray < 2000; ++ray) {
    const dvec3 from{random.uniform(-1, 1), random.uniform(-1, 1), -2};
    std::optional<double> nearest;
    std::size_t right = none, shown = none;
    for (const auto& polygon : scene) {
      const auto t = hit(polygon, from);
      if (!t || (nearest && *t <= *nearest)) continue;
      nearest = t;
      right = polygon.face;
    }
    for (const auto& polygon : order) {
      if (hit(polygon, from)) shown = polygon.face;
    }
    if (right != none && shown != right) sum.wrong_decision();
  }
  return sum.error();
}

void add_cases(std::vector<Case>& all, const Workload& workload, Scene triangles) {
  const auto scene = std::make_shared<const Scene>(std::move(triangles));
  const View<double> view = distant_view(towards, dvec3{0, 1, 0});
  const auto add = [&](const char* name, Standing standing, auto method) {
    const auto order = [scene, view, method] {
      Scene drawn;
      method(*scene, view, [&](const Polygon<double>& p) { drawn.push_back(p); });
      return drawn;
    };
    const auto kept = std::make_shared<Scene>(order());
    all.push_back({.method = name,
                   .standing = standing,
                   .workload = workload,
                   .items = static_cast<std::int64_t>(scene->size()),
                   .run = [kept, order] { *kept = order(); },
                   .error = error_of(*scene, *kept)});
  };
  add("newell", Standing::taught, [](auto&&... given) { newell(given...); });
  add("farthest_vertex", Standing::taught, [](auto&&... given) { farthest_vertex(given...); });
  add("centroid", Standing::faulty, [](auto&&... given) { centroid(given...); });
  add("BSP tree, build and walk", Standing::robust, [](const Scene& polygons, const auto& from, auto draw) {
    bsp_tree::back_to_front(bsp_tree::build(polygons), from.eye, draw);
  });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_cases(all, {"few large"}, scene_of(24, 0.8));
  add_cases(all, {"cycles"}, cycles_of(8));
  add_cases(all, {"many small"}, scene_of(512, 0.1));
  for (const int count : {16, 64, 256})
    add_cases(all, {fmt::format("{} triangles", count), static_cast<double>(count)}, scene_of(count, 0.3));
  return all;
}

}  // namespace

Subject painter() {
  return {.topic = "painter",
          .title = "Painting triangles",
          .item = "triangle",
          .unit = "wrong rays",
          .measure = "triangles",
          .telling = "few large",
          .cases = cases};
}

}  // namespace gradus::bench
