// From triangles in space to an order from back to front: by a BSP tree, by one that cuts nothing, and by
// sorting, each with the rays along which its picture shows the wrong triangle.

#include "visibility/bsp_tree/bsp_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "visibility/bsp_tree/bsp_tree_notes.hpp"

namespace gradus::bench {
namespace {

using namespace bsp_tree;

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

/// Where the sight line through `from` meets a polygon, as a multiple of the way to the viewer.
std::optional<double> hit(const Polygon<double>& polygon, dvec3 from) {
  const auto& p = polygon.corners;
  const dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double t = glm::dot(normal, p[0] - from) / glm::dot(normal, towards);
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

Scene walked(const Tree<double>& tree) {
  Scene order;
  back_to_front(tree, Eye<double>(towards, 0), [&](const Polygon<double>& p) { order.push_back(p); });
  return order;
}

/// By the depths of their middles, as the notes sort them.
Scene sorted(Scene scene) {
  const auto depth = [](const Polygon<double>& polygon) {
    dvec3 sum{0};
    for (const dvec3 p : polygon.corners) sum += p;
    return glm::dot(sum, towards) / static_cast<double>(polygon.corners.size());
  };
  std::ranges::stable_sort(scene, {}, depth);
  return scene;
}

void add_cases(std::vector<Case>& all, const Workload& workload, int count, double size) {
  const auto scene = std::make_shared<const Scene>(scene_of(count, size));
  const auto tree = std::make_shared<const Tree<double>>(build(*scene));
  const auto add = [&](const char* name, Standing standing, std::function<Scene()> order) {
    const auto kept = std::make_shared<Scene>(order());
    all.push_back({.method = name,
                   .standing = standing,
                   .workload = workload,
                   .items = count,
                   .run = [kept, order] { *kept = order(); },
                   .error = error_of(*scene, *kept)});
  };
  add("build and walk", Standing::robust, [scene] { return walked(build(*scene)); });
  add("walk alone", Standing::taught, [tree] { return walked(*tree); });
  add("build_uncut and walk", Standing::faulty, [scene] { return walked(build_uncut(*scene)); });
  add("sorted by their middles", Standing::faulty, [scene] { return sorted(*scene); });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_cases(all, {"few large"}, 24, 0.8);
  add_cases(all, {"many small"}, 512, 0.1);
  for (const int count : {16, 64, 256})
    add_cases(all, {fmt::format("{} triangles", count), static_cast<double>(count)}, count, 0.3);
  return all;
}

}  // namespace

Subject bsp_tree() {
  return {.topic = "bsp_tree",
          .title = "Triangles from back to front",
          .item = "triangle",
          .unit = "wrong rays",
          .measure = "triangles",
          .telling = "few large",
          .cases = cases};
}

}  // namespace gradus::bench
