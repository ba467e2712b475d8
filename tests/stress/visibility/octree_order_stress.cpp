// The promises of an octree's order: along any ray cells come in their order, and backwards the same.

#include "visibility/octree_order/octree_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using namespace octree_order;
using Cube = Cell<double>;

constexpr Cube root{{-4, -4, -4}, 8};

/// An eye, a direction, and a number that says which cells have children.
Input generate(Kind kind, Random& random) {
  Input input(7);
  for (double& x : input) x = random.uniform(-9, 9);
  if (kind == Kind::ties) {
    // In planes of the tree
    for (std::size_t k = 0; k < 3; ++k) input[k] = std::floor(4 * input[k]) / 4;
  }
  if (kind == Kind::grazing) {
    for (std::size_t k = 0; k < 3; ++k) input[k] = nudged(std::floor(input[k]), random);
  }
  input[6] = std::floor(random.uniform(0, 4096));
  return input;
}

bool is_case(const Input& i) {
  for (const double x : i) {
    if (!(std::abs(x) <= 1e4)) return false;
  }
  return std::abs(i[3]) > 1e-3 && std::abs(i[4]) > 1e-3 && std::abs(i[5]) > 1e-3;
}

/// Some branches are deep, others are not.
auto uneven(double number) {
  return [number](const Cube& cell) {
    if (cell.depth == 0) return true;
    const dvec3 m = middle_of(cell);
    const double mixed = 12.9898 * m.x + 78.233 * m.y + 37.719 * m.z + number;
    return cell.depth < 4 && static_cast<std::int64_t>(std::floor(mixed)) % 3 != 0;
  };
}

std::vector<Cube> order_of(const Input& i, double w) {
  std::vector<Cube> order;
  front_to_back(root, Eye<double>(i[0], i[1], i[2], w), uneven(i[6]),
                [&](const Cube& c) { order.push_back(c); });
  return order;
}

/// How far a cell begins before the end of one that came earlier, along the ray.
double ray_error(const Input& i) {
  if (!is_case(i)) return 0;
  const dvec3 eye{i[0], i[1], i[2]}, way{i[3], i[4], i[5]};
  double reached = 0, worst = 0;
  for (const Cube& cell : order_of(i, 1)) {
    double from = 0, to = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (cell.lower[axis] - eye[axis]) / way[axis];
      const double b = (cell.lower[axis] + cell.side - eye[axis]) / way[axis];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    if (to - from < 1e-6 * (1 + to)) continue;  // the ray touches it at most
    worst = std::max(worst, (reached - from) / (1 + to));
    reached = std::max(reached, to);
  }
  return worst;
}

double reverse_error(const Input& i) {
  if (!is_case(i)) return 0;
  for (const double w : {0.0, 1.0}) {
    auto order = order_of(i, w);
    std::vector<Cube> back;
    back_to_front(root, Eye<double>(i[0], i[1], i[2], w), uneven(i[6]),
                  [&](const Cube& c) { back.push_back(c); });
    std::ranges::reverse(order);
    if (order != back) return wrong;
  }
  return 0;
}

}  // namespace

Domain octree_order() {
  const std::vector<Kind> kinds{Kind::random, Kind::ties, Kind::grazing};
  return {"octree_order",
          {{.name = "along_rays",
            .states = "no cell lies before one that was visited earlier, along any ray from the eye",
            .unit = "of the way",
            .bound = 1e-9,
            .numbers = 7,
            .kinds = kinds,
            .generate = generate,
            .error = ray_error,
            .traps = {{"an eye in all planes at once", {0, 0, 0, 1, 2, 3, 5}}},
            .cases = 3'000},
           {.name = "reversed",
            .states = "from back to front the same cells come the other way round",
            .unit = "orders",
            .bound = 0,
            .numbers = 7,
            .kinds = kinds,
            .generate = generate,
            .error = reverse_error,
            .traps = {{"an eye at a corner", {4, 4, 4, 1, 1, 1, 9}}},
            .cases = 3'000}}};
}

}  // namespace gradus::stress
