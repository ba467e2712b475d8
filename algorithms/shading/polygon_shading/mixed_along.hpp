#pragma once
// One step of a scan line by itself: what lies between two places of the plane, by one coordinate.

#include <glm/vec2.hpp>

#include "shading/polygon_shading/polygon_shading.hpp"

namespace gradus::polygon_shading {

/// Along what is counted: x along a scan line, y along an edge.
enum class Along { x, y };

/// What lies at a coordinate between two places, mixed from what they bring along (a colour, texture
/// coordinates): the blend by which both ends of a row are found along its edges, and each pixel between
/// them.
/// Source: H. Gouraud, Continuous shading of curved surfaces, IEEE Trans. Computers C-20 (6), 1971.
///
/// T: float, double or Exact. along: which coordinate of both places counts. coordinate: beyond the places
///   it is taken for the nearer one.
///
/// Domain: finite, and so is the difference of the places. Places that are level there give `first`: no
///   coordinate tells them apart.
/// Steps: none.
/// Accuracy: both ends to the last bit, also 1e16 and 1, where a + t (b - a) gives 0 for the second; between
///   them 4 u of the larger value, u the rounding unit, and what the nearest coordinate is off.
/// Cost: a division, 2 products.
/// Errors: none.
template <class T, class Value>
Value mixed_along(Along along, glm::vec<2, T> from, glm::vec<2, T> to, const Value& first,
                  const Value& second, T coordinate) {
  const bool by_x = along == Along::x;
  const T a = by_x ? from.x : from.y, b = by_x ? to.x : to.y;
  // Level: there is nothing to divide by
  if (a == b) return first;
  const T part = (coordinate - a) / (b - a);
  if (!(T(0) < part)) return first;
  if (!(part < T(1))) return second;
  return mix(first, second, part);
}

}  // namespace gradus::polygon_shading
