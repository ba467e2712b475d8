#pragma once
// Stage 6, rasterization: which pixels each triangle covers.

#include <array>
#include <concepts>
#include <cstddef>
#include <vector>

#include "core/observe.hpp"
#include "projection/viewport/viewport.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"
#include "stages/points.hpp"

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

/// All pixels.
inline Window picture_window(Size size) { return {{0, 0}, {size.width - 1, size.height - 1}}; }

/// The corners of a triangle in the picture.
inline std::array<PixelPoint, 3> in_picture(const Triangle& triangle, Size size) {
  const auto place = [&](std::size_t i) {
    return PixelPoint{viewport::to_pixel(dvec2(triangle.corners[i].ndc.at), size.width, size.height)};
  };
  return {place(0), place(1), place(2)};
}

/// The same, snapped.
inline std::array<SnappedPoint, 3> snapped(const std::array<PixelPoint, 3>& corners) {
  using triangle_coverage::snap;
  return {SnappedPoint{snap(corners[0].at)}, SnappedPoint{snap(corners[1].at)},
          SnappedPoint{snap(corners[2].at)}};
}

/// The same, as the coverage of pixels takes it.
inline triangle_coverage::Triangle on_grid(const std::array<SnappedPoint, 3>& corners) {
  return {corners[0].at, corners[1].at, corners[2].at};
}

/// The number of one of them.
inline int index(const Triangle& triangle, const Triangles& all) {
  return static_cast<int>(&triangle - all.data());
}

/// Twice its area, in 1/65536 pixel.
inline std::int64_t area_of(const triangle_coverage::Triangle& grid) {
  return triangle_coverage::doubled_area(grid);
}

/// Whether the snapped triangle still shows the side that stage 4 saw, and has an area.
inline bool keeps_side(const Triangle& triangle, std::int64_t doubled_area) {
  return triangle.seen_from_behind ? doubled_area > 0 : doubled_area < 0;
}

/// The same with its depths.
inline triangle_coverage::ScreenTriangle on_screen(const triangle_coverage::Triangle& grid,
                                                   const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return {grid, {a.ndc.at.z, b.ndc.at.z, c.ndc.at.z}, triangle.depth};
}

/// Its depth in the centres of pixels, which is linear in the picture, and the same for all in one plane.
class DepthOver {
 public:
  DepthOver(const triangle_coverage::Triangle& grid, const Triangle& triangle)
      : depth_(on_screen(grid, triangle)) {}
  double at(ivec2 pixel, const triangle_coverage::Weights& weights) const {
    return depth_.at(triangle_coverage::centre_of(pixel), weights);
  }

 private:
  triangle_coverage::Depth depth_;
};
inline DepthOver depth_over(const triangle_coverage::Triangle& grid, const Triangle& triangle) {
  return {grid, triangle};
}

/// 1 / w of its corners, for what is linear on the surface.
inline dvec3 over_w_of(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return {a.over_w, b.over_w, c.over_w};
}

/// What each corner contributes to a point of the surface, from its weights in the picture.
inline dvec3 shares_of(const triangle_coverage::Weights& weights, const dvec3& over_w) {
  return triangle_coverage::perspective_correct(weights, over_w);
}

/// Tells of every pixel that a triangle covers. A sliver that snapping has turned round is not drawn: it
/// shows the side that stage 4 has said it does not show.
///
/// triangles: from stage 5. size: of the picture. emit(const Fragment&) is called triangle by triangle, row
///   by row.
///
/// Domain: corners between the guard planes.
/// Steps: (Snapped Covered*)*.
/// Accuracy: coverage exact for the snapped corners, without gaps and double hits between neighbours of one
///   mesh; weights to 8 ulp, depths to 6 ulp, or as of plane_depth.
/// Cost: the pixels of each triangle's box.
/// Errors: ContractViolation for corners beyond the guard planes.
template <std::invocable<const Fragment&> Emit, Observer<Snapped, Covered> O = Unobserved>
void rasterize(const Triangles& triangles, Size size, Emit&& emit, O&& observer = {}) {
  using triangle_coverage::cover;
  auto all = picture_window(size);
  for (auto& t : triangles) {
    int i = index(t, triangles);
    // Into the picture, on its grid
    auto raw = in_picture(t, size);
    auto corners = snapped(raw);
    auto grid = on_grid(corners);
    // Its sign tells the side
    const auto area = area_of(grid);
    bool kept = keeps_side(t, area);
    if constexpr (observed<O>) observer(Snapped{t.id, i, raw, corners, area, kept});
    if (!kept) continue;
    // Linear in the picture: depth,
    // and on the surface all else
    auto z = depth_over(grid, t);
    auto over_w = over_w_of(t);
    auto at = [&](ivec2 p, auto w) {
      // Perspective-correct shares
      auto s = shares_of(w, over_w);
      const double d = z.at(p, w);
      Fragment f{t.id, i, p, d, s};
      if constexpr (observed<O>) observer(Covered{f});
      emit(f);
    };
    // Row by row
    cover(grid, all, at);
  }
}

}  // namespace gradus::pipeline
