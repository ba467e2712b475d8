// The cells of octrees of growing depth in their order, by the octree's rule and by sorting distances.

#include "visibility/octree_order/octree_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

using namespace octree_order;
using Cube = Cell<double>;

constexpr Cube root{{-4, -4, -4}, 8};
const Eye<double> eye(11, 7, 5, 1);

/// Some branches end early, so that cells of several sizes lie beside each other.
auto uneven(int deepest) {
  return [deepest](const Cube& cell) {
    const dvec3 m = middle_of(cell);
    return cell.depth < deepest && (cell.depth < 2 || m.x + m.y + m.z > -2);
  };
}

/// Cells that lie before one that came earlier, along random rays: how many, and by how much.
Error wrong_pairs(const std::vector<Cube>& order, bool from_front) {
  Random random(3);
  Error::Sum sum;
  for (int k = 0; k < 400; ++k) {
    const dvec3 at{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)};
    const dvec3 way = at - dvec3(eye);
    double reached = from_front ? 0 : 1e9;  // nothing yet
    for (const Cube& cell : order) {
      double from = 0, to = 1e9;
      for (int axis = 0; axis < 3; ++axis) {
        const double a = (cell.lower[axis] - eye[axis]) / way[axis];
        const double b = (cell.lower[axis] + cell.side - eye[axis]) / way[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
      }
      if (to - from < 1e-9) continue;
      const double early = (from_front ? reached - from : to - reached) * glm::length(way);
      sum.add(std::max(early, 0.0));
      if (early > 1e-9) sum.wrong_decision();
      reached = from_front ? to : from;
    }
  }
  return sum.error();
}

template <class Order>
Case case_of(int depth, const char* name, Standing standing, bool from_front, Order order) {
  const auto cells = std::make_shared<std::vector<Cube>>();
  const auto run = [=] {
    cells->clear();
    order(depth, *cells);
  };
  run();
  return {.method = name,
          .standing = standing,
          .workload = {fmt::format("{} cells", cells->size()), static_cast<double>(cells->size())},
          .items = std::ssize(*cells),
          .run = run,
          .error = wrong_pairs(*cells, from_front)};
}

void near_first(int depth, std::vector<Cube>& cells) {
  front_to_back(root, eye, uneven(depth), [&](const Cube& cell) { cells.push_back(cell); });
}
void far_first(int depth, std::vector<Cube>& cells) {
  back_to_front(root, eye, uneven(depth), [&](const Cube& cell) { cells.push_back(cell); });
}
void by_distance(int depth, std::vector<Cube>& cells) {
  near_first(depth, cells);
  const auto distance = [](const Cube& cell) {
    const dvec3 way = middle_of(cell) - dvec3(eye);
    return glm::dot(way, way);
  };
  std::ranges::sort(cells, {}, distance);
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int depth : {2, 3, 4, 5}) {
    all.push_back(case_of(depth, "front_to_back", Standing::taught, true, near_first));
    all.push_back(case_of(depth, "back_to_front", Standing::robust, false, far_first));
    all.push_back(case_of(depth, "sorted by distance", Standing::peer, true, by_distance));
  }
  return all;
}

}  // namespace

Subject octree_order() {
  return {.topic = "octree_order",
          .title = "Cells of an octree in order",
          .item = "cell",
          .unit = "units of length",
          .measure = "cells",
          .telling = "2752 cells",
          .cases = cases,
          .choice = {"front_to_back", "rays and z-buffers stop early; painters take back_to_front"}};
}

}  // namespace gradus::bench
