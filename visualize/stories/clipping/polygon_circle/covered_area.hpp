#pragma once
// The part of a polygon that lies in a circle: its boundary as a chain, its area.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "clipping/polygon_circle/polygon_circle.hpp"
#include "stories/clipping/circle_drawing.hpp"
#include "stories/paper.hpp"

namespace gradus::polygon_circle {

using Disc = Circle<double>;

/// An area, which may lie beyond doubles: value * 2^exponent.
struct Covered {
  double value = 0;
  int exponent = 0;

  std::string text() const { return circle_drawing::scaled_real(value, exponent); }
  /// A number where that is one, else its text.
  Value field() const {
    const double number = std::ldexp(value, exponent);
    if (value == 0 || std::isnormal(number)) return number;
    return text();
  }
};

/// The points along a ring, its arcs as chains.
inline std::vector<dvec2> chain_of(const Ring<double>& ring, const Disc& circle) {
  std::vector<dvec2> points;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    points.push_back(ring[i].at);
    if (!ring[i].arc) continue;
    const ArcEnds ends = ends_of_arc(ring, i, circle);
    const std::vector<dvec2> arc = circle_drawing::arc(circle, atan2(ends.from.y, ends.from.x), ends.radians);
    points.insert(points.end(), arc.begin() + 1, arc.end() - 1);
  }
  return points;
}

inline Covered area_of(const Region<double>& region) {
  if (region.rings.empty()) return {};
  const Unit unit = unit_of(region.circle.radius);
  return {area_in(unit, region), 2 * std::ilogb(unit.size)};
}
/// Of polygons whose corners lie in the circle.
inline Covered area_of(const std::vector<std::vector<dvec2>>& polygons, const Disc& circle) {
  if (circle.radius == 0) return {};
  const Unit unit = unit_of(circle.radius);
  double doubled = 0;
  for (const std::vector<dvec2>& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const dvec2 a = seen_from(circle.centre, polygon[i], unit);
      const dvec2 b = seen_from(circle.centre, polygon[(i + 1) % polygon.size()], unit);
      doubled += a.x * b.y - a.y * b.x;
    }
  }
  return {doubled / 2, 2 * std::ilogb(unit.size)};
}

}  // namespace gradus::polygon_circle
