#pragma once
// Stage 5, clipping: what lies in front of the near plane, behind the far plane or far beside the picture is
// cut off in clip space. Only then comes the division.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman_homogeneous.hpp"
#include "core/observe.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/viewport/viewport.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// A corner on its way through clipping, with all that is linear on the surface.
struct ClipCorner {
  glm::dvec4 at{0};
  dvec3 world{0}, normal{0};
  dvec2 texture{0, 0};
};

using Polygon = std::vector<ClipCorner>;

/// The corner t of the way from a to b.
inline ClipCorner mix(const ClipCorner& a, const ClipCorner& b, double t) {
  return {a.at + t * (b.at - a.at), a.world + t * (b.world - a.world), a.normal + t * (b.normal - a.normal),
          a.texture + t * (b.texture - a.texture)};
}

/// A piece was clipped and divided.
struct Clipped {
  PieceId id;
  std::vector<ClipPoint> before, after;  ///< its corners in clip space; after: none when nothing is left
  std::vector<NdcPoint> divided;         ///< those that are left
  bool changed;                          ///< whether anything was cut off
};

/// Guard planes lie this many pixels from the middle of the picture: far enough that hardly anything meets
/// them, near enough for whole numbers. The sides of the picture itself cut nothing: rasterization leaves out
/// what lies beyond.
inline constexpr double guard_pixels = 1 << 20;

/// Near and far plane, and the guard planes.
/// size: of the picture, 1 to 2^17 pixels per side (refused otherwise).
inline std::array<sutherland_hodgman::Plane<double>, 6> guard_volume(Size size) {
  const auto [width, height] = size;
  expects(1 <= width && width <= 1 << 17 && 1 <= height && height <= 1 << 17,
          "a picture has 1 to {} pixels per side, not {} x {}", 1 << 17, width, height);
  return sutherland_hodgman::view_volume(2 * guard_pixels / width, 2 * guard_pixels / height);
}

/// The polygon of a piece. Normals are turned to the viewer's side.
inline Polygon polygon_of(const Piece& piece, const Model<WorldPoint>& world, const Model<ClipPoint>& clip) {
  Polygon polygon;
  polygon.reserve(3);
  for (const PieceCorner& corner : piece.corners) {
    const dvec3 normal = piece.seen_from_behind ? -corner.normal : corner.normal;
    polygon.push_back({clip.point(corner).at, world.point(corner).at, normal, corner.texture});
  }
  return polygon;
}

/// Whether nothing of the polygon is outside any plane.
inline bool inside_all(const Polygon& polygon, std::span<const sutherland_hodgman::Plane<double>> planes) {
  return std::ranges::all_of(planes, [&](const auto& plane) {
    return std::ranges::all_of(polygon, [&](const ClipCorner& c) { return distance(plane, c.at) >= 0; });
  });
}

/// What is left of a polygon. Where rounding errors of very large coordinates reach beyond the near plane,
/// nothing is.
inline Polygon part_inside(const Polygon& polygon,
                           std::span<const sutherland_hodgman::Plane<double>> planes) {
  if (inside_all(polygon, planes)) return polygon;
  Polygon part = sutherland_hodgman::clip(polygon, planes);
  if (!std::ranges::all_of(part, [](const ClipCorner& c) { return c.at.w > 0; })) part.clear();
  return part;
}

/// The corners after the division.
inline std::vector<TriangleCorner> divided(const Polygon& polygon) {
  std::vector<TriangleCorner> corners;
  corners.reserve(polygon.size());
  for (const ClipCorner& corner : polygon) {
    corners.push_back(
        {{perspective::divide(corner.at)}, 1 / corner.at.w, {corner.world}, corner.normal, corner.texture});
  }
  return corners;
}

/// The depth of a plane over the picture, or nothing.
using PlaneDepth = std::optional<triangle_coverage::DepthPlane>;

/// The depth over the picture of the plane through three places; nothing where it is seen edge-on.
/// Domain: any w; size as of guard_volume.
/// Accuracy: of places in the picture the depths are within 2^-50 (1 + g) / h, where the plane gains g in
/// depth over the picture, much where it is seen almost edge-on, and h is the least height of the places'
/// triangle there, the picture being 2 wide and high.
inline PlaneDepth plane_depth(const std::array<glm::dvec4, 3>& places, Size size) {
  // In clip space no place is too near or behind the eye; from the one that is farthest on, little is lost
  const auto far = [](const glm::dvec4& p) { return std::abs(p.w); };
  const auto from = static_cast<std::size_t>(std::ranges::max_element(places, {}, far) - places.begin());
  const glm::dvec4 start = places[from];
  const dvec3 ndc = dvec3(start) / start.w;
  const auto way = [&](std::size_t i) {
    const glm::dvec4& p = places[(from + i) % 3];
    return dvec3(p) - p.w * ndc;
  };
  const dvec3 u = way(1), v = way(2);
  const double area = u.x * v.y - u.y * v.x;
  const double right = (u.z * v.y - u.y * v.z) / area, up = (u.x * v.z - u.z * v.x) / area;
  if (!(std::abs(right) + std::abs(up) < std::numeric_limits<double>::infinity())) return {};
  constexpr double grid = triangle_coverage::subpixels;
  return triangle_coverage::DepthPlane{grid * viewport::to_pixel(dvec2(ndc), size.width, size.height), ndc.z,
                                       2 * right / (grid * size.width), -2 * up / (grid * size.height)};
}

/// Those of a model's planes.
inline std::vector<PlaneDepth> plane_depths(const Model<ClipPoint>& model, Size size) {
  std::vector<PlaneDepth> depths;
  depths.reserve(model.planes.size());
  for (const auto& plane : model.planes) {
    const auto at = [&](std::size_t k) {
      return model.vertices[static_cast<std::size_t>(plane[k])].point.at;
    };
    depths.push_back(plane_depth({at(0), at(1), at(2)}, size));
  }
  return depths;
}

/// A convex polygon as triangles round its first corner. planes: the depths of those that pieces share.
inline Triangles fan(const Piece& piece, const std::vector<TriangleCorner>& corners,
                     std::span<const PlaneDepth> planes) {
  const PlaneDepth shared =
      piece.plane == no_plane ? PlaneDepth{} : planes[static_cast<std::size_t>(piece.plane)];
  Triangles triangles;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::array<TriangleCorner, 3> of{corners[0], corners[i - 1], corners[i]};
    triangles.push_back({piece.id, of, piece.seen_from_behind, piece.plane,
                         told_by(shared, {of[0].ndc.at.z, of[1].ndc.at.z, of[2].ndc.at.z})});
  }
  return triangles;
}

/// Room for a triangle of each piece.
inline Triangles room_for(const std::vector<Piece>& pieces) {
  Triangles triangles;
  triangles.reserve(pieces.size());
  return triangles;
}

/// What is told of a clipped piece.
inline Clipped clipped(PieceId id, const Polygon& before, const Polygon& after,
                       const std::vector<TriangleCorner>& divided,
                       std::span<const sutherland_hodgman::Plane<double>> planes) {
  Clipped step{id, {}, {}, {}, !inside_all(before, planes)};
  for (const ClipCorner& corner : before) step.before.push_back({corner.at});
  for (const ClipCorner& corner : after) step.after.push_back({corner.at});
  for (const TriangleCorner& corner : divided) step.divided.push_back(corner.ndc);
  return step;
}

/// Clips every piece and divides what is left, which goes on as triangles with the piece's id.
///
/// w, m: the same vertices in world and in clip space. size: of the picture.
///
/// Domain: finite coordinates, any w.
/// Steps: Clipped*, in the order of the pieces.
/// Accuracy: that of sutherland_hodgman::clip; neighbours get the same new corners on their common edge.
/// Cost: 18 tests per piece; more where something is cut.
/// Errors: ContractViolation for a picture beyond 2^17 pixels.
template <Observer<Clipped> O = Unobserved>
Triangles clip(const Model<WorldPoint>& w, const Model<ClipPoint>& m, Size size, O&& observer = {}) {
  auto V = guard_volume(size);
  auto z = plane_depths(m, size);
  // One triangle per piece, or more
  auto all = room_for(m.pieces);
  for (auto& p : m.pieces) {
    // In clip space
    auto in = polygon_of(p, w, m);
    // Sutherland-Hodgman
    auto out = part_inside(in, V);
    // Every w > 0: divide by it
    const auto ndc = divided(out);
    // What is left is convex: a fan
    append(all, fan(p, ndc, z));
    if constexpr (observed<O>) observer(clipped(p.id, in, out, ndc, V));
  }
  return all;
}

}  // namespace gradus::pipeline
