#pragma once
// Between stages 5 and 6, for scenes that ask for it: the painter or a BSP tree puts the triangles in
// an order from back to front, and their places in it stand for their depths. What compares depths after
// that - the z-buffer and every antialiasing method - then keeps what was drawn last, which is what drawing
// over one another does.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/random.hpp"
#include "core/refusal.hpp"
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

// --- How much work an order may take

/// An order from back to front may take the square of what there is and more: it is refused where it would
/// take too long, in one line that names the way out.
struct ArrangingLimit {
  static constexpr std::int64_t most = 20'000'000;  ///< some seconds, and some hundred megabytes
  static constexpr std::int64_t a_cut = 100;        ///< takes as long as so many tests

  std::string_view method;
  std::size_t triangles;
  std::int64_t work = 0;  ///< in tests of one polygon against another

  void add(std::int64_t tests) {
    work += tests;
    if (work <= most) return;
    refuse_usage(
        fmt::format("--hidden-surfaces {}: expected triangles whose order takes at most {} tests, found {} "
                    "that take more; z_buffer needs no order, and draws the same",
                    method, most, triangles));
  }
};

/// Watches the tree being built.
struct TreeLimit {
  ArrangingLimit limit;

  void operator()(const bsp_tree::Placed<double>&) { limit.add(1); }
  void operator()(const bsp_tree::Split<double>&) { limit.add(ArrangingLimit::a_cut); }
  template <class Step>
  void operator()(const Step&) {}
};

/// Watches the painter.
struct PainterLimit {
  ArrangingLimit limit;

  void operator()(const painter::Compared<double>& compared) { limit.add(tests_of(compared.passed)); }
  void operator()(const painter::Cut<double>&) { limit.add(ArrangingLimit::a_cut); }
  void operator()(const painter::Inserted<double>& inserted) {
    for (const auto& place : inserted.places) limit.add(static_cast<std::int64_t>(place.before));
  }
  template <class Step>
  void operator()(const Step&) {}

 private:
  /// The first three ask for a few signs; planes and edges for one per corner, or per corner and edge.
  static constexpr std::int64_t tests_of(painter::Test passed) {
    using enum painter::Test;
    return passed < behind ? 1 : passed < apart ? 3 : 8;
  }
};

/// Draws for the painter, and counts what planes part, where rounding has closed a cycle.
template <class Draw>
struct LimitedDrawing {
  Draw draw;
  ArrangingLimit limit;

  void operator()(const WorldPolygon& polygon) { draw(polygon); }
  void parts(std::size_t pieces) { limit.add(static_cast<std::int64_t>(pieces)); }
};
template <class Draw>
LimitedDrawing(Draw, ArrangingLimit) -> LimitedDrawing<Draw>;

// --- Triangles and their parts

/// A plane of a model in the world, where rounding has moved its triangles: it is that of the largest, and so
/// thick that it holds the corners of all.
class SharedWorldPlane {
 public:
  void add(const WorldPolygon& polygon) {
    const auto& c = polygon.corners;
    const dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
    if (const double size = glm::dot(normal, normal); size > largest_) {
      largest_ = size;
      plane_ = polygon.plane;
    }
    corners_.insert(corners_.end(), c.begin(), c.end());
  }
  bsp_tree::Plane<double> plane() const {
    bsp_tree::Plane<double> thick = plane_;
    bsp_tree::thicken(thick, corners_);
    return thick;
  }

 private:
  double largest_ = -1;
  bsp_tree::Plane<double> plane_;
  std::vector<dvec3> corners_{};
};

/// Gives all triangles that share a plane the same one.
inline void take_shared_planes(const Triangles& triangles, std::vector<WorldPolygon>& polygons) {
  using Shared = std::pair<int, int>;  // whose, and which
  const auto plane_of = [&](const WorldPolygon& p) {
    return Shared{triangles[p.face].id.object, triangles[p.face].plane};
  };
  std::map<Shared, SharedWorldPlane> shared;
  for (const WorldPolygon& p : polygons)
    if (plane_of(p).second != no_plane) shared[plane_of(p)].add(p);
  std::map<Shared, bsp_tree::Plane<double>> planes;
  for (const auto& [which, of] : shared) planes.emplace(which, of.plane());
  for (WorldPolygon& p : polygons)
    if (const auto found = planes.find(plane_of(p)); found != planes.end()) p.plane = found->second;
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
  take_shared_planes(triangles, polygons);
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

// --- The painter

/// Who looks, as the painter has it.
inline painter::View<double> painters_view(const SceneCamera& camera) {
  const auto& [eye, right, up, forward] = camera.frame;
  return {eye_of(camera), right, up, forward};
}

/// What the painter takes: all that lies in front of the eye.
inline std::vector<WorldPolygon> painted_polygons(const SceneCamera& camera, const Triangles& triangles) {
  std::vector<WorldPolygon> polygons = world_polygons(triangles);
  if (!camera.rays) {
    // A near plane very close to the eye may round corners to behind it
    std::erase_if(polygons, [&](const WorldPolygon& p) {
      return !std::ranges::all_of(p.corners, [&](dvec3 c) {
        return painter::compare_depths(camera.frame.forward, c, camera.frame.eye) > 0;
      });
    });
  }
  return polygons;
}

/// AN EXHIBIT: from back to front by farthest corners, without any test: where triangles overlap in depth the
/// wrong one may be seen.
inline Triangles in_order_of_farthest_vertices(const SceneCamera& camera, const Triangles& triangles) {
  Triangles ordered;
  painter::farthest_vertex(painted_polygons(camera, triangles), painters_view(camera),
                           [&](const WorldPolygon& p) { ordered.push_back(triangles[p.face]); });
  return ordered;
}

/// From back to front as Newell, Newell and Sancha have it, which cuts what no order could tell apart.
inline Triangles in_painters_order(const SceneCamera& camera, const Triangles& triangles) {
  Triangles ordered;
  const auto append = [&](const WorldPolygon& p) { append_part(ordered, triangles[p.face], p); };
  const ArrangingLimit limit{"painter", triangles.size()};
  painter::newell(painted_polygons(camera, triangles), painters_view(camera), LimitedDrawing{append, limit},
                  PainterLimit{limit});
  return ordered;
}

// --- The BSP tree

/// From back to front by a BSP tree, which cuts what no order could tell apart. Triangles take their turns as
/// planes at random, always the same: neighbours in a file would cut off one another one by one.
inline Triangles in_tree_order(const SceneCamera& camera, const Triangles& triangles) {
  std::vector<WorldPolygon> polygons = world_polygons(triangles);
  Random random(1);
  for (std::size_t left = polygons.size(); left > 1; --left) {
    const auto other = random.uniform_int(0, static_cast<std::int64_t>(left) - 1);
    std::swap(polygons[left - 1], polygons[static_cast<std::size_t>(other)]);
  }
  auto tree = bsp_tree::build(polygons, bsp_tree::ExactSide{}, TreeLimit{{"bsp_tree", polygons.size()}});
  // Of those in one plane the first is seen: the lowest (object, face)
  for (auto& node : tree) std::ranges::sort(node.polygons, {}, &WorldPolygon::face);
  Triangles ordered;
  bsp_tree::back_to_front(tree, eye_of(camera),
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
    triangle.depth.reset();
  }
}

/// Puts the triangles of stage 5 in the order that the scene's hidden surface method draws them in; in a
/// wireframe the edges of `facing` take their place. The z-buffer needs neither.
///
/// facing: from stage 4. size: of the picture.
///
/// Domain: that of clip; with bsp_tree, extents from 1e-75 to 1e75.
/// Accuracy: the orders of the painter and of the tree are right; corners of parts are rounded anew, so that
///   a centre within 1/256 pixel of a cut or of an edge that a cut meets may show what is beside it. That of
///   farthest_vertex is right where no two triangles overlap in depth and in the picture.
/// Cost: farthest_vertex: n log n comparisons. painter: see painter::newell; bsp_tree: see bsp_tree::build;
///   the number of triangles may grow to its square, up to the work that ArrangingLimit has.
/// Errors: ContractViolation as bsp_tree::build; UsageError for more work than that.
inline void arrange(const Scene& scene, const Model<ClipPoint>& facing, Size size, Triangles& triangles) {
  if (scene.shading == Shading::wireframe) {
    triangles = outlines(facing, size);
    return;
  }
  switch (scene.hidden_surfaces) {
    case HiddenSurfaces::z_buffer:
      return;
    case HiddenSurfaces::painter:
      triangles = in_painters_order(scene.camera, triangles);
      break;
    case HiddenSurfaces::bsp_tree:
      triangles = in_tree_order(scene.camera, triangles);
      break;
    case HiddenSurfaces::farthest_vertex:
      triangles = in_order_of_farthest_vertices(scene.camera, triangles);
  }
  take_places_for_depths(triangles);
}

}  // namespace gradus::pipeline
