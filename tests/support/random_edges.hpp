#pragma once
// Straight edges across one pixel, by which sampling patterns are judged: how far the share of samples on one
// side is from the exact area there.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/arithmetic/elementary.hpp"
#include "core/geometry.hpp"
#include "core/random.hpp"

namespace gradus::test {

/// All places with dot(normal, place) <= reach. The pixel is [0, 1] x [0, 1].
struct StraightEdge {
  dvec2 normal{1, 0};  ///< of length 1
  double reach = 0;

  bool holds(const dvec2& place) const { return glm::dot(normal, place) <= reach; }

  /// The part of the pixel on the inner side, in [0, 1]: turned into the first quadrant, the area under a
  /// line is a triangle less what sticks out on either side.
  /// Accuracy: 1e-15 where both parts of the normal are larger than 1e-3.
  double area() const {
    const double a = std::abs(normal.x), b = std::abs(normal.y);
    const double c = reach - std::min(normal.x, 0.0) - std::min(normal.y, 0.0);
    if (c <= 0) return 0;
    if (c >= a + b) return 1;
    const double large = std::max(a, b), small = std::min(a, b);
    if (small < 1e-12) return std::clamp(c / large, 0.0, 1.0);
    const auto square = [](double x) { return x > 0 ? x * x : 0; };
    return (square(c) - square(c - a) - square(c - b)) / (2 * a * b);
  }
};

/// An edge that crosses the pixel, every such line equally likely: any direction, any distance from the
/// pixel's middle. Known errors of patterns (see docs/benchmarks.md) are of this distribution.
inline StraightEdge random_edge(Random& random) {
  constexpr double farthest = 0.70710678118654752440;  // from the middle to a corner
  while (true) {
    const double angle = random.uniform(0, 2 * 3.14159265358979323846);
    const dvec2 normal{cos(angle), sin(angle)};
    const StraightEdge edge{normal, glm::dot(normal, dvec2(0.5)) + random.uniform(-farthest, farthest)};
    const double area = edge.area();
    if (0 < area && area < 1) return edge;
  }
}

}  // namespace gradus::test
