#pragma once
// What the stories of exact areas are given, and how they write areas down.

#include "antialiasing/area_sampling/area_sampling.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "figure/tone_of.hpp"
#include "stories/parameters.hpp"
#include "stories/rings.hpp"
#include "stories/telling.hpp"

namespace gradus::area_sampling {

using triangle_coverage::can_snap;
using triangle_coverage::snap;

/// "5/12" where that is short, else with digits.
inline std::string area_text(Exact area) {
  const std::string fraction = to_string(area);
  return fraction.size() <= 5 ? fraction : figure_real(to_double(area));
}

/// A corner on the grid of 1/256 pixel, in pixels.
inline dvec2 in_pixels(dvec2 corner) { return corner / double{subpixels}; }

/// A cut polygon's corners in pixels.
inline Ring2 ring_of(const Polygon& polygon) {
  return mapped(polygon,
                [](const Vertex& v) { return in_pixels(dvec2(v.whole) + dvec2(v.rest) / dvec2(v.of)); });
}
/// An outline's corners.
inline Ring2 ring_of(const Outline<Exact>& outline) {
  return mapped(outline, [](const auto& p) { return dvec2{to_double(p.x), to_double(p.y)}; });
}

/// How far a place is from the sides of a ring, where a text is twice as wide as high; at most so much.
inline double distance(dvec2 p, const Ring2& ring, double most = 1) {
  const dvec2 narrow{0.5, 1};
  for (const auto& [a, b] : sides_of(ring)) {
    const dvec2 way = (b - a) * narrow, to = (p - a) * narrow;
    const double length = glm::dot(way, way);
    const double t = length > 0 ? std::clamp(glm::dot(to, way) / length, 0.0, 1.0) : 0;
    most = std::min(most, glm::length(to - t * way));
  }
  return most;
}

/// Whether two edges of a ring cross, or one ends on another.
inline bool crosses_itself(const std::vector<ivec2>& ring) {
  const auto side = [](ivec2 a, ivec2 b, ivec2 c) {
    const std::int64_t ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
    return (ux * vy > uy * vx) - (ux * vy < uy * vx);
  };
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;
      const ivec2 a = ring[i], b = ring[i + 1], c = ring[j], d = ring[(j + 1) % n];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
    }
  }
  return false;
}

/// A polygon of the plane, snapped.
inline std::vector<ivec2> corners_of(const Arguments& arguments) {
  std::vector<ivec2> corners;
  for (const dvec2 p : arguments.points("polygon")) {
    if (!can_snap(p))
      refuse("polygon", "expected corners at most {} pixels out, found one farther away", farthest);
    corners.push_back(snap(p));
  }
  if (crosses_itself(corners)) refuse("polygon", "expected a polygon that does not cross itself");
  return corners;
}

/// Where a window of pixels, their numbers at their centres, shows a corner of that polygon, if it does.
inline std::optional<dvec2> shown_at(const Window& window, dvec2 corner) {
  return as_it_is_in(window)(in_pixels(dvec2(snap(corner))) - 0.5);
}

/// The window that is asked for; of a larger one the first 16 columns and rows.
inline Window window_of(const Arguments& arguments) {
  Window window = *arguments.window("window");
  const ivec2 first = window.lower;
  if (std::max(std::abs(dvec2(first).x), std::abs(dvec2(first).y)) > farthest - 16)
    refuse("window", "expected a first pixel at most {} out, found {},{}", farthest - 16, first.x, first.y);
  window.upper = glm::min(window.upper, first + 15);
  return window;
}

/// Triangles over one pixel, named.
struct InPixel {
  std::vector<std::string> names;
  std::vector<ScreenTriangle> triangles;
  std::vector<double> grey;  ///< the light that each adds to the pixel per unit of area
};

inline InPixel in_pixel_of(const Arguments& arguments) {
  constexpr std::array<double, 4> greys{0.9, 0.5, 0.2, 0.7};
  InPixel subject;
  for (const NamedFace& face : arguments.faces("triangles")) {
    if (face.points.size() != 3)
      refuse("triangles", "expected three corners, found {} of '{}'", face.points.size(), face.name);
    ScreenTriangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3 p = face.points[k];
      if (!can_snap(dvec2(p)))
        refuse("triangles", "expected corners at most {} pixels out, found one of '{}' farther away",
               farthest, face.name);
      t.corners[k] = snap(dvec2(p));
      t.depth[static_cast<int>(k)] = p.z;
    }
    subject.grey.push_back(greys[subject.names.size() % greys.size()]);
    subject.names.push_back(face.name);
    subject.triangles.push_back(t);
  }
  return subject;
}

}  // namespace gradus::area_sampling
