// Rays through trees of 1 to 64 leaves: all leaves merged, those alone that matter, and points asked one by
// one.

#include "modeling/csg_tree/csg_tree.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "modeling/csg_tree/csg_tree_notes.hpp"
#include "modeling/csg_tree/skipping.hpp"

namespace gradus::bench {
namespace {

using namespace csg_tree;

constexpr int rays = 1000;

/// A wall of balls, drilled where there are at least two leaves, united two by two.
Index add_wall(Nodes<double>& tree, int leaves, dvec2 lower, dvec2 size) {
  const dvec3 centre(0, lower + 0.5 * size);
  const double radius = 0.45 * std::min(size.x, size.y);
  if (leaves == 1) return add_leaf<double>(tree, Ball<double>{centre, radius});
  if (leaves == 2) {
    const Index whole = add_leaf<double>(tree, Ball<double>{centre, radius});
    const Index drill = add_leaf<double>(tree, Cylinder<double>{centre, 0.4 * radius, 0});
    return add_node(tree, Op::subtract, whole, drill);
  }
  const dvec2 half = size.x < size.y ? dvec2(size.x, 0.5 * size.y) : dvec2(0.5 * size.x, size.y);
  const Index a = add_wall(tree, leaves / 2, lower, half);
  const Index b = add_wall(tree, leaves / 2, lower + size - half, half);
  return add_node(tree, Op::unite, a, b);
}

struct Scene {
  Nodes<double> tree{};
  Boxes<double> boxes{};
  std::vector<Ray<double>> all{};
};
std::shared_ptr<const Scene> scene_of(int leaves) {
  const auto scene = std::make_shared<Scene>();
  add_wall(scene->tree, leaves, {-4, -4}, {8, 8});
  scene->boxes = boxes_of<double>(scene->tree);
  Random random(11);
  for (int k = 0; k < rays; ++k) {
    const dvec3 from{random.uniform(-12, -9), random.uniform(-4, 4), random.uniform(-4, 4)};
    const dvec3 to{random.uniform(9, 12), random.uniform(-4, 4), random.uniform(-4, 4)};
    scene->all.push_back({from, to - from, 1});
  }
  return scene;
}

double length_in(const Ends<double>& ends) {
  double sum = 0;
  for (Index k = 0; k < ends.size(); k += 2) sum += ends[k + 1] - ends[k];
  return sum;
}
/// Points in the middle of equal parts of the ray, each asked of the tree.
double length_by_points(const Nodes<double>& tree, const Ray<double>& ray, int points) {
  int in = 0;
  for (int k = 0; k < points; ++k) {
    const double t = (k + 0.5) / points;
    in += contains<double>(tree, ray.from + t * ray.way);
  }
  return static_cast<double>(in) / points;
}

template <class LengthOf>
Case case_of(const char* method, Standing standing, int leaves, const LengthOf& length_of) {
  const auto scene = scene_of(leaves);
  const auto length = std::make_shared<double>();
  Error::Sum sum;
  for (const Ray<double>& ray : scene->all)
    sum.add(std::abs(length_of(*scene, ray) - length_in(along_ray<double>(scene->tree, ray))));
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("{} {}", leaves, leaves == 1 ? "leaf" : "leaves"),
                       static_cast<double>(leaves)},
          .items = rays,
          .run =
              [scene, length_of, length] {
                for (const Ray<double>& ray : scene->all) *length += length_of(*scene, ray);
              },
          .error = sum.error()};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int leaves : {1, 4, 16, 64}) {
    const auto add = [&](const char* method, Standing standing, auto length_of) {
      all.push_back(case_of(method, standing, leaves, length_of));
    };
    add("along_ray", Standing::taught,
        [](const Scene& s, const Ray<double>& ray) { return length_in(along_ray<double>(s.tree, ray)); });
    add("skipping", Standing::batch, [](const Scene& s, const Ray<double>& ray) {
      return length_in(skipping<double>(s.tree, s.boxes, ray));
    });
    add("membership", Standing::robust,
        [](const Scene& s, const Ray<double>& ray) { return length_by_points(s.tree, ray, 64); });
    add("exchanged", Standing::faulty,
        [](const Scene& s, const Ray<double>& ray) { return length_in(exchanged<double>(s.tree, ray)); });
  }
  return all;
}

}  // namespace

Subject csg_tree() {
  return {.topic = "csg_tree",
          .title = "A ray through a CSG tree",
          .item = "ray",
          .unit = "parts of the ray",
          .measure = "leaves",
          .telling = "64 leaves",
          .cases = cases,
          .choice = {"skipping", "most leaves are nowhere near the ray"}};
}

}  // namespace gradus::bench
