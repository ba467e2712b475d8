#pragma once
// Stage 6, rasterization: which pixels each triangle covers.

#include <array>
#include <concepts>
#include <cstddef>
#include <vector>

#include "core/observe.hpp"
#include "points.hpp"
#include "projection/viewport/viewport.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

namespace gradus::pipeline {

/// A triangle stands in the picture, its corners snapped to 1/256 pixel.
struct Snapped {
  PieceId id;
  int triangle;  ///< its place in the list
  std::array<PixelPoint, 3> exact;
  std::array<SnappedPoint, 3> corners;
  std::int64_t doubled_area;  ///< in 1/65536 pixel; a front face has a negative one, for rows grow downwards
  bool drawn;                 ///< false: no area, or the wrong side after snapping
};

/// A pixel is covered.
struct Covered {
  Fragment fragment;
};

/// The corners of a triangle in the picture.
inline std::array<PixelPoint, 3> in_picture(const Triangle& triangle, int width, int height) {
  const auto place = [&](std::size_t i) {
    return PixelPoint{viewport::to_pixel(dvec2(triangle.corners[i].ndc.at), width, height)};
  };
  return {place(0), place(1), place(2)};
}

/// The same, snapped.
inline std::array<SnappedPoint, 3> snapped(const std::array<PixelPoint, 3>& corners) {
  using triangle_coverage::snap;
  return {SnappedPoint{snap(corners[0].at)}, SnappedPoint{snap(corners[1].at)},
          SnappedPoint{snap(corners[2].at)}};
}

/// Tells of every pixel that a triangle covers. A sliver that snapping has turned round is not drawn: it
/// shows the side that stage 4 has said it does not show.
///
/// triangles: from stage 5. width, height: of the picture. emit(const Fragment&) is called triangle by
///   triangle, row by row.
///
/// Domain: corners between the guard planes.
/// Steps: (Snapped Covered*)*.
/// Accuracy: coverage exact for the snapped corners, without gaps and double hits between neighbours of one
///   mesh; weights to 8 ulp, depths to 6 ulp.
/// Cost: the pixels of each triangle's box.
/// Errors: ContractViolation for corners beyond the guard planes.
template <std::invocable<const Fragment&> Emit, Observer<Snapped, Covered> O = Unobserved>
void rasterize(const std::vector<Triangle>& triangles, int width, int height, Emit&& emit,
               O&& observer = {}) {
  const Window picture{{0, 0}, {width - 1, height - 1}};
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
    const Triangle& triangle = triangles[static_cast<std::size_t>(i)];
    const auto& [a, b, c] = triangle.corners;
    // Into the picture, and onto its grid
    const auto exact = in_picture(triangle, width, height);
    const auto corners = snapped(exact);
    const triangle_coverage::Triangle grid{corners[0].at, corners[1].at, corners[2].at};
    const std::int64_t area = triangle_coverage::doubled_area(grid);
    const bool drawn = triangle.seen_from_behind ? area > 0 : area < 0;
    if constexpr (observed<O>) observer(Snapped{triangle.id, i, exact, corners, area, drawn});
    if (!drawn) continue;
    // Depth is linear in the picture, the rest on the surface
    const triangle_coverage::Linear depth(grid, {a.ndc.at.z, b.ndc.at.z, c.ndc.at.z});
    const dvec3 over_w{a.over_w, b.over_w, c.over_w};
    triangle_coverage::cover(grid, picture, [&](ivec2 pixel, const triangle_coverage::Weights& weights) {
      const dvec3 shares = triangle_coverage::perspective_correct(weights, over_w);
      const Fragment fragment{triangle.id, i, pixel, depth.at(weights), shares};
      if constexpr (observed<O>) observer(Covered{fragment});
      emit(fragment);
    });
  }
}

}  // namespace gradus::pipeline
