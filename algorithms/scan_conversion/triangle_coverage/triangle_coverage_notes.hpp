#pragma once
// Exhibits: two ways of lecture notes to ask whether a triangle covers a pixel, kept so that a figure can
// show where they go wrong. Never use them to draw; triangle_coverage.hpp has the right one.

#include <array>
#include <cstdint>
#include <vector>

#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

namespace gradus::triangle_coverage {

/// Whether no edge function is negative.
constexpr bool none_negative(const Weights& e) { return e[0] >= 0 && e[1] >= 0 && e[2] >= 0; }

/// What a finished box held by that rule.
constexpr Finished counted_closed(const Edges& edges, const Window& box) {
  return counted(box, [&](ivec2 p) { return none_negative(weights_at(edges, p)); });
}

/// The pixels of a window, row by row.
constexpr std::vector<ivec2> pixels_of(const Window& window) {
  std::vector<ivec2> pixels;
  for (int y = window.lower.y; y <= window.upper.y; ++y) {
    for (int x = window.lower.x; x <= window.upper.x; ++x) pixels.push_back({x, y});
  }
  return pixels;
}

/// FAULTY: an edge belongs to both of its sides (errata E001-42), so that a centre on an edge that two
/// triangles share is covered by both: of a square of 8 x 8 pixels, cut along its diagonal, each half covers
/// 36, and 8 pixels are drawn twice. A depth buffer hides that, blending does not.
///
/// t, window, plot: as for cover.
///
/// Domain: as cover.
/// Steps: Prepared Tested* Finished, as cover.
/// Accuracy: what cover covers, and all centres on edges that belong to the neighbour.
/// Cost: as cover, and a list of the pixels.
/// Errors: ContractViolation for corners or windows that lie too far out.
template <std::invocable<ivec2, const Weights&> Plot, Observer<Prepared, Tested, Finished> O = Unobserved>
constexpr void closed_half_planes(const Triangle& t, const Window& window, Plot&& plot, O&& observer = {}) {
  expects(near_enough(t), "a corner of the triangle lies more than {} pixels out", farthest);
  expects(near_enough(window), "the window reaches more than {} pixels out", farthest);
  const auto area = doubled_area(t);
  if (area == 0) return;
  auto box = centres(t, window);
  auto edges = edges_of(t);
  if constexpr (observed<O>) observer(Prepared{t, area, edges, box});
  for (ivec2 p : pixels_of(box)) {
    auto e = weights_at(edges, p);
    // Also where one is 0
    bool in = none_negative(e);
    if constexpr (observed<O>) observer(Tested{p, e, in});
    if (in) plot(p, e);
  }
  if constexpr (observed<O>) observer(counted_closed(edges, box));
}

/// An edge function with its brackets multiplied out: a x + b y + c.
struct ExpandedEdge {
  double a, b, c;

  constexpr double at(dvec2 place) const { return a * place.x + b * place.y + c; }
};

/// Of the directed edge between two points.
constexpr ExpandedEdge expanded(dvec2 from, dvec2 to) {
  return {from.y - to.y, to.x - from.x, from.x * to.y - to.x * from.y};
}

/// A place of the window, in pixels of the huge picture in which the window begins at origin.
constexpr dvec2 in_huge(dvec2 origin, ivec2 place) { return origin + dvec2(place) / double{subpixels}; }

/// The three edge functions of a triangle, in pixels of a huge picture.
class FarEdges {
 public:
  constexpr FarEdges(const Edges& edges, dvec2 origin)
      : origin_(origin), edges_{expanded_in(edges[0]), expanded_in(edges[1]), expanded_in(edges[2])} {}

  /// In square pixels, at the centre of a pixel of the window.
  constexpr dvec3 areas_at(ivec2 pixel) const {
    const dvec2 at = in_huge(origin_, centre_of(pixel));
    return {edges_[0].at(at), edges_[1].at(at), edges_[2].at(at)};
  }
  /// As weights: 65536 to the square pixel.
  constexpr Weights at(ivec2 pixel) const {
    const dvec3 areas = areas_at(pixel) * double{subpixels * subpixels};
    return {static_cast<std::int64_t>(areas.x), static_cast<std::int64_t>(areas.y),
            static_cast<std::int64_t>(areas.z)};
  }

 private:
  constexpr ExpandedEdge expanded_in(const Edge& edge) const {
    return expanded(in_huge(origin_, edge.from), in_huge(origin_, edge.to));
  }

  dvec2 origin_;
  std::array<ExpandedEdge, 3> edges_;
};

/// What a finished box held by these.
constexpr Finished counted_far(const Edges& edges, const FarEdges& far, const Window& box) {
  return counted(box, [&](ivec2 p) { return holds(edges, far.at(p)); });
}

/// FAULTY: the edge functions with their brackets multiplied out (errata E001-43). Far from the origin
/// a x + b y and c are large and nearly cancel: the edge from (1e8+1, 1e8) to (1e8+3, 1e8+1) gives -1 at
/// (1e8+2, 1e8+0.5), which lies on it. Pixels along the edges are left out or drawn twice.
///
/// t, window, plot: as for cover. origin: of the window, in pixels from where coordinates count: a tile
///   of a huge picture.
///
/// Domain: as cover; |origin| up to 2^44, so that places are exact.
/// Steps: Prepared Tested* Finished, as cover.
/// Accuracy: edge functions are off by as much as a unit in the last place of |origin|^2: 2 square pixels
///   at 1e8. The rule for centres on edges is that of cover.
/// Cost: as cover, with 2 multiplications per edge and pixel, and a list of the pixels.
/// Errors: ContractViolation for corners or windows that lie too far out.
template <std::invocable<ivec2, const Weights&> Plot, Observer<Prepared, Tested, Finished> O = Unobserved>
constexpr void expanded_edges(const Triangle& t, dvec2 origin, const Window& window, Plot&& plot,
                              O&& observer = {}) {
  expects(near_enough(t), "a corner of the triangle lies more than {} pixels out", farthest);
  expects(near_enough(window), "the window reaches more than {} pixels out", farthest);
  const auto area = doubled_area(t);
  if (area == 0) return;
  auto box = centres(t, window);
  auto edges = edges_of(t);
  if constexpr (observed<O>) observer(Prepared{t, area, edges, box});
  const FarEdges far(edges, origin);
  for (ivec2 p : pixels_of(box)) {
    // Huge terms nearly cancel
    const auto e = far.at(p);
    const bool in = holds(edges, e);
    if constexpr (observed<O>) observer(Tested{p, e, in});
    if (in) plot(p, e);
  }
  if constexpr (observed<O>) observer(counted_far(edges, far, box));
}

}  // namespace gradus::triangle_coverage
