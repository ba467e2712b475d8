#pragma once
// Between stages 5 and 6, for scenes that ask for it: the painter's list or a BSP tree puts the triangles in
// an order from back to front, and their places in it stand for their depths. What compares depths after
// that - the z-buffer and every antialiasing method - then keeps what was drawn last, which is what drawing
// over one another does.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "scene/scene.hpp"
#include "stages/5_clipping.hpp"
#include "stages/points.hpp"
#include "stages/wireframe.hpp"
#include "visibility/bsp_tree/bsp_tree.hpp"
#include "visibility/painter/painter.hpp"

namespace gradus::pipeline {

using WorldPolygon = bsp_tree::Polygon<double>;

/// The eye, or the direction towards it where rays are parallel.
inline glm::dvec4 eye_of(const SceneCamera& camera) {
  if (!camera.rays) return {camera.frame.eye, 1};
  return {towards_viewer(camera.frame, camera.rays->slant), 0};
}

/// The triangles in world space, each with its place in the list as its face. Those without an area there,
/// which no pixel shows, are left out.
inline std::vector<WorldPolygon> world_polygons(const Triangles& triangles) {
  std::vector<WorldPolygon> polygons;
  polygons.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i].corners;
    const dvec3 normal = glm::cross(b.world.at - a.world.at, c.world.at - a.world.at);
    if (!(glm::dot(normal, normal) > 0)) continue;
    polygons.push_back({{a.world.at, b.world.at, c.world.at}, i});
  }
  return polygons;
}

/// How much of each corner of a triangle a point of its plane has: the areas of the three triangles that it
/// makes with the sides, against the whole.
inline dvec3 shares_at(const Triangle& triangle, dvec3 point) {
  const dvec3 a = triangle.corners[0].world.at, b = triangle.corners[1].world.at,
              c = triangle.corners[2].world.at;
  const dvec3 normal = glm::cross(b - a, c - a);
  const double whole = glm::dot(normal, normal);
  const double of_b = glm::dot(glm::cross(point - a, c - a), normal) / whole;
  const double of_c = glm::dot(glm::cross(b - a, point - a), normal) / whole;
  return {1 - of_b - of_c, of_b, of_c};
}

/// The corner of a part of a triangle. One that the triangle has is the same to the bit.
inline TriangleCorner corner_at(const Triangle& triangle, dvec3 point) {
  for (const TriangleCorner& corner : triangle.corners)
    if (corner.world.at == point) return corner;
  const dvec3 share = shares_at(triangle, point);
  TriangleCorner mixed;
  mixed.over_w = 0, mixed.world.at = point;
  double w = 0;
  dvec3 clip{0};
  for (int k = 0; k < 3; ++k) {
    // In clip space, where all that is linear on the surface is
    const TriangleCorner& corner = triangle.corners[static_cast<std::size_t>(k)];
    w += share[k] / corner.over_w;
    clip += share[k] / corner.over_w * corner.ndc.at;
    mixed.normal += share[k] * corner.normal;
    mixed.texture += share[k] * corner.texture;
  }
  mixed.ndc.at = clip / w;
  mixed.over_w = 1 / w;
  return mixed;
}

/// A triangle, or the part of it that a polygon is, as triangles round its first corner.
inline void append_part(Triangles& list, const Triangle& triangle, const WorldPolygon& polygon) {
  std::vector<TriangleCorner> corners;
  for (const dvec3 corner : polygon.corners) corners.push_back(corner_at(triangle, corner));
  for (std::size_t i = 2; i < corners.size(); ++i)
    list.push_back({triangle.id, {corners[0], corners[i - 1], corners[i]}, triangle.seen_from_behind});
}

/// From back to front by farthest corners, without any test: where triangles overlap in depth the wrong one
/// may be seen.
inline Triangles in_painters_order(const SceneCamera& camera, const Triangles& triangles) {
  const auto& [eye, right, up, forward] = camera.frame;
  const painter::View<double> view{eye_of(camera), right, up, forward};
  std::vector<WorldPolygon> polygons = world_polygons(triangles);
  if (!camera.rays) {
    // A near plane very close to the eye may round corners to behind it
    std::erase_if(polygons, [&](const WorldPolygon& p) {
      return !std::ranges::all_of(p.corners, [&](dvec3 c) {
        return painter::compare_depths(camera.frame.forward, c, camera.frame.eye) > 0;
      });
    });
  }
  Triangles ordered;
  painter::farthest_vertex(polygons, view,
                           [&](const WorldPolygon& p) { ordered.push_back(triangles[p.face]); });
  return ordered;
}

/// From back to front by a BSP tree, which cuts what no order could tell apart. Triangles take their turns as
/// planes at random, always the same: neighbours in a file would cut off one another one by one.
inline Triangles in_tree_order(const SceneCamera& camera, const Triangles& triangles) {
  std::vector<WorldPolygon> polygons = world_polygons(triangles);
  Random random(1);
  for (std::size_t left = polygons.size(); left > 1; --left) {
    const auto other = random.uniform_int(0, static_cast<std::int64_t>(left) - 1);
    std::swap(polygons[left - 1], polygons[static_cast<std::size_t>(other)]);
  }
  Triangles ordered;
  bsp_tree::back_to_front(bsp_tree::build(polygons), eye_of(camera),
                          [&](const WorldPolygon& p) { append_part(ordered, triangles[p.face], p); });
  return ordered;
}

/// Each gets the depth of its place, the last one the least.
inline void take_places_for_depths(Triangles& triangles) {
  const auto count = static_cast<double>(triangles.size());
  double place = count;
  for (Triangle& triangle : triangles) {
    place -= 1;
    for (TriangleCorner& corner : triangle.corners) corner.ndc.at.z = (place + 0.5) / count;
  }
}

/// Puts the triangles of stage 5 in the order that the scene's hidden surface method draws them in; in a
/// wireframe the edges of `facing` take their place. The z-buffer needs neither.
///
/// facing: from stage 4. size: of the picture.
///
/// Domain: that of clip; with bsp_tree, extents from 1e-75 to 1e75.
/// Accuracy: the painter's order is right where no two triangles overlap in depth and in the picture. That of
///   the tree always is; corners of parts are rounded anew, so that a pixel's centre within 1/256 pixel of a
///   cut or of an edge that a cut meets may show what is beside it.
/// Cost: painter: n log n comparisons. bsp_tree: see bsp_tree::build; the number of triangles may grow to its
///   square.
/// Errors: ContractViolation as bsp_tree::build.
inline void arrange(const Scene& scene, const Model<ClipPoint>& facing, Size size, Triangles& triangles) {
  if (scene.shading == Shading::wireframe) {
    triangles = outlines(facing, size);
    return;
  }
  if (scene.hidden_surfaces == HiddenSurfaces::z_buffer) return;
  triangles = scene.hidden_surfaces == HiddenSurfaces::painter ? in_painters_order(scene.camera, triangles)
                                                               : in_tree_order(scene.camera, triangles);
  take_places_for_depths(triangles);
}

}  // namespace gradus::pipeline
