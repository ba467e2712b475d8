#pragma once
// What the stories of circles draw alike.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clipping/liang_barsky_circle/circle_and_line.hpp"
#include "core/elementary.hpp"
#include "stories/paper.hpp"

namespace gradus::circle_drawing {

/// An arc as a chain of points close enough for the eye: from an angle on, counter-clockwise, in radians.
inline std::vector<dvec2> arc(const liang_barsky_circle::Circle<double>& circle, double from, double sweep) {
  const int chords = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) * 20)));
  std::vector<dvec2> points;
  for (int i = 0; i <= chords; ++i) {
    const SinCos at = sin_cos(from + sweep * i / chords);
    points.push_back(circle.centre + circle.radius * dvec2(at.cos, at.sin));
  }
  return points;
}

/// The circle as a closed chain, without its first point again.
inline std::vector<dvec2> whole(const liang_barsky_circle::Circle<double>& circle) {
  std::vector<dvec2> points = arc(circle, 0, 0x1.921fb54442d18p2);
  points.pop_back();
  return points;
}

/// The part of the way from a to b that the panel shows; nothing where it shows none.
inline std::optional<std::pair<dvec2, dvec2>> shown_part(const Panel& panel, dvec2 a, dvec2 b) {
  const Extent box = panel.shown();
  double first = 0, last = 1;
  for (const int axis : {0, 1}) {
    const double d = b[axis] - a[axis];
    if (d == 0) {
      if (a[axis] < box.lower[axis] || box.upper[axis] < a[axis]) return std::nullopt;
      continue;
    }
    const double low = (box.lower[axis] - a[axis]) / d, high = (box.upper[axis] - a[axis]) / d;
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  if (first > last) return std::nullopt;
  const auto at = [&](double t) { return t == 0 ? a : t == 1 ? b : a + t * (b - a); };
  return std::pair{at(first), at(last)};
}

/// Whether the panel shows a point.
inline bool shows(const Panel& panel, dvec2 p) {
  const Extent box = panel.shown();
  return box.lower.x <= p.x && p.x <= box.upper.x && box.lower.y <= p.y && p.y <= box.upper.y;
}

inline void add_stroke(View& view, const Panel& panel, std::string id, Role role, dvec2 a, dvec2 b,
                       bool arrow = false, bool dashed = false) {
  const auto part = shown_part(panel, a, b);
  if (!part) return;
  view.add({std::move(id), role,
            Stroke{panel.at(part->first), panel.at(part->second), arrow && part->second == b, dashed}});
}

/// A dot with a name beside it.
inline void add_point(View& view, const Panel& panel, const std::string& id, Role role, dvec2 at,
                      const std::string& name, bool ring = false) {
  if (!shows(panel, at)) return;
  view.add({id, role, Dot{panel.at(at), ring}});
  if (!name.empty()) view.add({id + " name", role, Label{panel.at(at), name}});
}

/// A circle as the numbers cx, cy, r of a parameter.
inline liang_barsky_circle::Circle<double> circle_of(const std::vector<double>& numbers) {
  return {{numbers[0], numbers[1]}, numbers[2]};
}

}  // namespace gradus::circle_drawing
