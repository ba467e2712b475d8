// From triangles in space to an order from back to front: as Newell, Newell and Sancha sort, move and cut, by
// sorting alone, and by a BSP tree, each with the rays along which its picture shows the wrong triangle.

#include "visibility/painter/painter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "benchmark/subject.hpp"
#include "benchmark/visibility/sight_rays.hpp"
#include "visibility/painter/painter_notes.hpp"

namespace gradus::bench {
namespace {

using namespace painter;
using namespace sight_rays;

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
  return {
      .topic = "painter",
      .title = "Painting triangles",
      .item = "triangle",
      .unit = "wrong rays",
      .measure = "triangles",
      .telling = "few large",
      .cases = cases,
      .choice = {"BSP tree, build and walk", "right for every eye, and the tree stands for the next one"}};
}

}  // namespace gradus::bench
