#pragma once
// Exhibits: stage 6 with the tests of lecture notes (errata E001-42 and E001-43). Never render with them;
// 6_rasterization.hpp has the right one.

#include <utility>

#include "scan_conversion/triangle_coverage/triangle_coverage_notes.hpp"
#include "stages/6_rasterization.hpp"

namespace gradus::pipeline {

/// Stage 6 with another way to cover: cover(triangle, window, plot) is called for each triangle.
/// Steps, Domain, Cost, Errors: as rasterize. Accuracy: that of cover.
template <class Cover, std::invocable<const Fragment&> Emit, Observer<Snapped, Covered> O = Unobserved>
void rasterize_by(const Cover& cover, const Triangles& triangles, Size size, Emit&& emit, O&& observer = {}) {
  int i = -1;
  for (const Triangle& t : triangles) {
    ++i;
    const auto exact = in_picture(t, size);
    const auto corners = snapped(exact);
    const auto grid = on_grid(corners);
    const auto area = area_of(grid);
    const bool drawn = keeps_side(t, area);
    if constexpr (observed<O>) observer(Snapped{t.id, i, exact, corners, area, drawn});
    if (!drawn) continue;
    const auto depth = depth_over(grid, t);
    const dvec3 over_w = over_w_of(t);
    cover(grid, picture_window(size), [&](ivec2 p, const triangle_coverage::Weights& w) {
      const Fragment f{t.id, i, p, depth.at(p, w), shares_of(w, over_w)};
      if constexpr (observed<O>) observer(Covered{f});
      emit(f);
    });
  }
}

/// FAULTY: centres on a shared edge are covered by both triangles (errata E001-42).
/// Steps, Domain, Cost, Errors: as rasterize. Accuracy: as triangle_coverage::closed_half_planes.
template <std::invocable<const Fragment&> Emit, Observer<Snapped, Covered> O = Unobserved>
void rasterize_closed(const Triangles& triangles, Size size, Emit&& emit, O&& observer = {}) {
  const auto cover = [](const triangle_coverage::Triangle& triangle, const Window& window, auto&& plot) {
    triangle_coverage::closed_half_planes(triangle, window, plot);
  };
  rasterize_by(cover, triangles, size, emit, observer);
}

/// So many columns and rows from where coordinates count: the picture is a tile of a huge one.
inline constexpr double far_origin = 1e8;

/// FAULTY: edge functions with their brackets multiplied out, in a tile that lies far_origin columns and rows
/// from the origin (errata E001-43).
/// Steps, Domain, Cost, Errors: as rasterize. Accuracy: as triangle_coverage::expanded_edges.
template <std::invocable<const Fragment&> Emit, Observer<Snapped, Covered> O = Unobserved>
void rasterize_expanded(const Triangles& triangles, Size size, Emit&& emit, O&& observer = {}) {
  const auto cover = [](const triangle_coverage::Triangle& triangle, const Window& window, auto&& plot) {
    triangle_coverage::expanded_edges(triangle, dvec2(far_origin), window, plot);
  };
  rasterize_by(cover, triangles, size, emit, observer);
}

}  // namespace gradus::pipeline
