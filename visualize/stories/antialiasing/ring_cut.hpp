#pragma once
// What of a ring lies on one side of a level or upright line, and in a rectangle.

#include <glm/vec2.hpp>
#include <vector>

#include "core/geometry.hpp"

namespace gradus {

/// The part of a convex ring where sign (p[axis] - limit) >= 0. Source: Sutherland and Hodgman 1974, one
/// border.
inline std::vector<dvec2> ring_cut(const std::vector<dvec2>& ring, int axis, double limit, double sign) {
  std::vector<dvec2> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 p = ring[i], q = ring[(i + 1) % ring.size()];
    const double from = sign * (p[axis] - limit), to = sign * (q[axis] - limit);
    if (from >= 0) kept.push_back(p);
    if ((from < 0) != (to < 0)) kept.push_back(p + from / (from - to) * (q - p));
  }
  return kept;
}

/// The part of a convex ring in a rectangle.
inline std::vector<dvec2> ring_within(std::vector<dvec2> ring, dvec2 lower, dvec2 upper) {
  for (const int axis : {0, 1}) ring = ring_cut(ring_cut(ring, axis, lower[axis], 1), axis, upper[axis], -1);
  return ring;
}

}  // namespace gradus
