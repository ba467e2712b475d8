#pragma once
// Where the names of faces stand that cover each other on paper.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "stories/rings.hpp"

namespace gradus {

/// Twice the area of a ring, > 0 counter-clockwise with y up.
inline double doubled_area_of(const Ring2& ring) {
  double area = 0;
  for (const auto& [a, b] : sides_of(ring)) area += a.x * b.y - a.y * b.x;
  return area;
}

/// How far a place inside a convex ring is from its outline; below 0 outside.
inline double depth_inside(const Ring2& ring, dvec2 place) {
  const double turn = std::copysign(1.0, doubled_area_of(ring));
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : sides_of(ring)) {
    const dvec2 way = b - a, to = place - a;
    const double length = glm::length(way);
    if (length > 0) least = std::min(least, turn * (way.x * to.y - way.y * to.x) / length);
  }
  return least;
}

/// A place in a ring, near its middle, that is clear of all outlines and in no other ring that is smaller;
/// else the one that comes nearest to that.
inline dvec2 clear_place(const Ring2& ring, const std::vector<Ring2>& others) {
  constexpr double enough = 0.8;
  const double size = std::abs(doubled_area_of(ring));
  const auto clearance = [&](dvec2 place) {
    double least = depth_inside(ring, place);
    for (const Ring2& other : others) {
      const double outside = -depth_inside(other, place);
      least = std::min(least, std::abs(doubled_area_of(other)) > size ? std::abs(outside) : outside);
    }
    return least;
  };
  const dvec2 middle = middle_of(ring);
  std::pair best{clearance(middle), middle};
  for (const double part : {0.25, 0.4, 0.55, 0.7, 0.85}) {
    for (const auto& [a, b] : sides_of(ring)) {
      if (best.first >= enough) break;
      for (const dvec2 towards : {a, 0.5 * (a + b)}) {
        const dvec2 place = middle + part * (towards - middle);
        if (const double here = clearance(place); here > best.first) best = {here, place};
      }
    }
  }
  return best.second;
}

}  // namespace gradus
