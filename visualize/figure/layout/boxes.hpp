#pragma once
// Rectangles of a sheet, and what of a line or a ring lies in them.

#include <algorithm>
#include <optional>
#include <vector>

#include "figure/sheet.hpp"

namespace gradus::layout {

inline bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}
inline double overlap_area(const Box& a, const Box& b) {
  const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
  const double height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}
inline bool inside(const Box& inner, const Box& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.right() <= outer.right() &&
         inner.bottom() <= outer.bottom();
}
inline bool inside(dvec2 p, const Box& outer) { return inside(Box{p.x, p.y, 0, 0}, outer); }
/// The smallest box that holds both.
inline Box around(const Box& a, const Box& b) {
  const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}
inline Box grown(const Box& b, double by) {
  return {b.x - by, b.y - by, b.width + 2 * by, b.height + 2 * by};
}
inline Box scaled(const Box& box, double s) { return {box.x * s, box.y * s, box.width * s, box.height * s}; }

/// The part of a stroke inside a box; nothing when it misses it.
std::optional<Segment<2, double>> clipped(dvec2 a, dvec2 b, const Box& box);
/// Whether two strokes have a point in common.
bool cross(const Segment<2, double>& a, const Segment<2, double>& b);
/// The part of a ring inside a box.
std::vector<dvec2> inside_of(std::vector<dvec2> ring, const Box& box);

}  // namespace gradus::layout
