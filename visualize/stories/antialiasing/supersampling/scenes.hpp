#pragma once
// What the pictures of supersampling show: polygons, and a sphere over a chequered floor that is found along
// a ray.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/geometry.hpp"

namespace gradus::supersampling {

/// The corners of a polygon in the picture, rows downwards.
using Polygon = std::vector<dvec2>;

/// Whether an odd number of its edges lies to the left of the place.
inline bool holds(const Polygon& polygon, dvec2 p) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const dvec2 a = polygon[i], b = polygon[j];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x > a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in;
}

/// The area of a polygon that does not cross itself, whichever way it runs.
inline double area_of(const Polygon& polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return std::abs(doubled) / 2;
}

/// A red sphere over a chequered floor under a bright sky, found by a ray from the eye through the place.
struct SphereScene {
  ivec2 size;  ///< of the picture, in pixels

  dvec3 operator()(dvec2 place) const {
    const double half = 0.5 * size.y;
    const dvec3 way =
        glm::normalize(dvec3((place.x - 0.5 * size.x) / half, -(place.y - 0.42 * size.y) / half, -2.2));
    return light_along(eye, way, true);
  }

 private:
  static constexpr dvec3 eye{0, 1.5, 3.2}, middle{0, 1, 0};

  /// How far along the ray the sphere is hit.
  static std::optional<double> hit(dvec3 from, dvec3 way) {
    const dvec3 d = from - middle;
    const double b = glm::dot(d, way), c = glm::dot(d, d) - 1, root = b * b - c;
    if (root < 0) return std::nullopt;
    const double t = -b - std::sqrt(root);
    return t > 1e-6 ? std::optional(t) : std::nullopt;
  }
  static dvec3 light_along(dvec3 from, dvec3 way, bool reflects) {
    const dvec3 lamp = glm::normalize(dvec3(-0.5, 0.9, 0.6));
    if (const auto t = hit(from, way)) {
      const dvec3 at = from + *t * way, normal = at - middle;
      const double lit = 0.15 + 0.85 * std::max(0.0, glm::dot(normal, lamp));
      const dvec3 own = dvec3(0.8, 0.08, 0.05) * lit;
      return reflects ? 0.75 * own + 0.25 * light_along(at, glm::reflect(way, normal), false) : own;
    }
    if (way.y >= 0) return {0.55, 0.7, 0.9};
    const dvec3 at = from - from.y / way.y * way;
    const bool dark =
        (static_cast<std::int64_t>(std::floor(at.x)) + static_cast<std::int64_t>(std::floor(at.z))) % 2 == 0;
    const double lit = hit(at, lamp) ? 0.35 : 1;
    return lit * dvec3(dark ? 0.06 : 0.8);
  }
};

}  // namespace gradus::supersampling
