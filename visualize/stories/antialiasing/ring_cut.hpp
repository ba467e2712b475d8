#pragma once
// What of a ring lies on one side of a level or upright line, and in a rectangle; what of a line lies outside
// of a ring.

#include <algorithm>
#include <glm/vec2.hpp>
#include <utility>
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

/// Twice the area of a triangle, negative where p lies on the other side of the way from a to b.
inline double side_of(dvec2 a, dvec2 b, dvec2 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Straight ways, each from one point to another.
using Ways = std::vector<std::pair<dvec2, dvec2>>;

/// What of ways lies outside a convex ring whose inside has side_of > 0; what lies along its sides, too.
inline Ways outside_of(const std::vector<dvec2>& ring, const Ways& ways) {
  Ways rest;
  for (const auto& [p, q] : ways) {
    double first = 0, last = ring.empty() ? 0 : 1;  // of its part within
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      const double from = side_of(a, b, p), to = side_of(a, b, q);
      if (from <= 0 && to <= 0) last = 0;
      if (from < 0 && to > 0) first = std::max(first, from / (from - to));
      if (from > 0 && to < 0) last = std::min(last, from / (from - to));
    }
    if (first >= last) first = last = 1;
    if (first > 0) rest.emplace_back(p, p + first * (q - p));
    if (last < 1) rest.emplace_back(p + last * (q - p), q);
  }
  return rest;
}

}  // namespace gradus
