// From triangles in space to an order from back to front: by a BSP tree, by one that cuts nothing, and by
// sorting, each with the rays along which its picture shows the wrong triangle.

#include "visibility/bsp_tree/bsp_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "benchmark/subject.hpp"
#include "benchmark/visibility/sight_rays.hpp"
#include "visibility/bsp_tree/bsp_tree_notes.hpp"

namespace gradus::bench {
namespace {

using namespace bsp_tree;
using namespace sight_rays;

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
          .cases = cases,
          .choice = {"walk alone", "built once, a tree is right from every eye"}};
}

}  // namespace gradus::bench
