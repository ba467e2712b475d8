#pragma once
// Triangles in space, and how many sight lines show the wrong one when they are painted in some order.

#include <cstdint>
#include <optional>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "visibility/bsp_tree/bsp_tree.hpp"

namespace gradus::bench::sight_rays {

using Scene = std::vector<bsp_tree::Polygon<double>>;
inline constexpr dvec3 towards{0.2, 0.3, 1};

/// So many triangles of about this size in a cube from -1 to 1.
inline Scene scene_of(int count, double size) {
  Random random(7, static_cast<std::uint64_t>(count));
  const auto within = [&](double most) {
    return dvec3{random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
  };
  Scene scene;
  for (int i = 0; i < count; ++i) {
    const dvec3 middle = within(1 - size);
    scene.push_back({{middle + within(size), middle + within(size), middle + within(size)}, std::size_t(i)});
  }
  return scene;
}

/// Where the sight line through `from` meets a polygon, as a multiple of the way to the viewer.
inline std::optional<double> hit(const bsp_tree::Polygon<double>& polygon, dvec3 from) {
  const auto &a = polygon.plane.a, &b = polygon.plane.b, &c = polygon.plane.c;
  const auto& p = polygon.corners;
  const dvec3 normal = glm::cross(b - a, c - a);
  const double t = glm::dot(normal, a - from) / glm::dot(normal, towards);
  const dvec3 at = from + t * towards;
  int turn = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double side = glm::dot(normal, glm::cross(p[(i + 1) % p.size()] - p[i], at - p[i]));
    const int sign = (side > 0) - (side < 0);
    if (sign == 0 || sign == -turn) return std::nullopt;
    turn = sign;
  }
  return t;
}

/// Rays along which the last polygon of the order is not the nearest of the scene.
inline Error error_of(const Scene& scene, const Scene& order) {
  Random random(11);
  Error::Sum sum;
  for (int ray = 0; ray < 2000; ++ray) {
    const dvec3 from{random.uniform(-1, 1), random.uniform(-1, 1), -2};
    std::optional<double> nearest;
    std::size_t right = bsp_tree::none, shown = bsp_tree::none;
    for (const auto& polygon : scene) {
      const auto t = hit(polygon, from);
      if (!t || (nearest && *t <= *nearest)) continue;
      nearest = t;
      right = polygon.face;
    }
    for (const auto& polygon : order) {
      if (hit(polygon, from)) shown = polygon.face;
    }
    if (right != bsp_tree::none && shown != right) sum.wrong_decision();
  }
  return sum.error();
}

}  // namespace gradus::bench::sight_rays
