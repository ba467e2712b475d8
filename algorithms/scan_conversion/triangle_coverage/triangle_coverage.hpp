#pragma once
// Which pixels a triangle covers: those whose centre it holds. Triangles that share an edge share no pixel
// and leave none out.
//
// Rows grow downwards, as in an image. Corners are snapped once to a grid of 1/256 pixel; from then on
// everything is an integer and exact.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <ranges>

#include "core/arithmetic/rounding.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::triangle_coverage {

/// Snapped coordinates count 256 to the pixel (24.8 fixed point).
inline constexpr int subpixels = 256;

/// How far a snapped coordinate may lie from 0, in pixels. Guard planes 2^20 pixels from the middle of a
/// picture of up to 2^17 pixels stay inside; edge functions then need 62 bits.
inline constexpr int farthest = (1 << 20) + (1 << 16);

/// The corners of a triangle in 1/256 pixel, rows downwards.
using Triangle = std::array<ivec2, 3>;

/// The nearest multiple of 1/256 pixel, midway the smaller one; nothing for what lies more than `farthest`
/// pixels from 0 or is no number. Accuracy: exact.
inline bool can_snap(dvec2 pixel) { return std::abs(pixel.x) <= farthest && std::abs(pixel.y) <= farthest; }

/// A place in the picture on the grid of 1/256 pixel: the nearest one, midway the smaller. The one function
/// that snaps: all code that draws the same picture uses it.
/// Domain: can_snap(pixel).
/// Accuracy: exact; moves a point by at most 1/512 pixel per coordinate.
/// Errors: ContractViolation for places outside the domain.
inline ivec2 snap(dvec2 pixel) {
  expects(can_snap(pixel), "the place ({}, {}) is too far from the picture to be snapped", pixel.x, pixel.y);
  const auto nearest = [](double x) {
    const double scaled = x * subpixels, below = std::floor(scaled);  // both exact
    return static_cast<int>(below) + (scaled - below > 0.5);
  };
  return {nearest(pixel.x), nearest(pixel.y)};
}

/// Twice the area in units of 1/65536 pixel; positive when the corners run clockwise as one sees them, that
/// is, y down counter-clockwise in the formulas. A front face, counter-clockwise with y up, has a negative
/// area. Domain: snapped coordinates. Accuracy: exact, below 2^61.
constexpr std::int64_t doubled_area(const Triangle& t) {
  const std::int64_t ux = t[1].x - t[0].x, uy = t[1].y - t[0].y;
  const std::int64_t vx = t[2].x - t[0].x, vy = t[2].y - t[0].y;
  return ux * vy - uy * vx;
}

/// The edge function of a directed edge: positive on its right as one sees it (rows go down), 0 on the edge.
struct Edge {
  ivec2 from, to;
  bool owns;  ///< whether centres on the edge belong to the triangle: it is a top or a left edge

  /// The doubled area of from, to and this place. Accuracy: exact, below 2^61.
  constexpr std::int64_t at(ivec2 place) const {
    const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
    return dx * (std::int64_t{place.y} - from.y) - dy * (std::int64_t{place.x} - from.x);
  }
  /// What it grows by from one pixel to the next in a row.
  constexpr std::int64_t step() const { return -std::int64_t{to.y - from.y} * subpixels; }
};

/// A top edge is level and has the triangle below it (larger rows); a left edge has it on its right. The
/// triangle lies on the right of the directed edge, as one sees it.
constexpr bool top_or_left(ivec2 from, ivec2 to) {
  const bool left = to.y < from.y;
  const bool top = to.y == from.y && to.x > from.x;
  return left || top;
}

/// The three edges of a triangle, edge i opposite corner i, all with the inside on the positive side.
using Edges = std::array<Edge, 3>;

constexpr Edges edges_of(const Triangle& t) {
  const bool clockwise = doubled_area(t) > 0;
  const auto edge = [&](std::size_t from, std::size_t to) {
    return clockwise ? Edge{t[from], t[to], top_or_left(t[from], t[to])}
                     : Edge{t[to], t[from], top_or_left(t[to], t[from])};
  };
  return {edge(1, 2), edge(2, 0), edge(0, 1)};
}

/// The centre of a pixel on the grid of 1/256.
constexpr ivec2 centre_of(ivec2 pixel) {
  return {pixel.x * subpixels + subpixels / 2, pixel.y * subpixels + subpixels / 2};
}

/// The pixels of the window whose centres lie in the box round the triangle.
constexpr Window centres(const Triangle& t, const Window& window) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  // Shifts round down, to the pixel before for centres that lie before the box
  const Window box{{(left + subpixels / 2 - 1) >> 8, (top + subpixels / 2 - 1) >> 8},
                   {(right - subpixels / 2) >> 8, (bottom - subpixels / 2) >> 8}};
  return intersection(box, window);
}

/// The edge functions at a pixel's centre, with the sign of the inside positive; weight i belongs to corner
/// i, and the three add up to the triangle's |doubled area|.
using Weights = std::array<std::int64_t, 3>;

/// The edge functions at any place of the grid of 1/256, not only at centres; outside the triangle some
/// are negative. Accuracy: exact.
constexpr Weights weights_at_place(const Edges& edges, ivec2 place) {
  return {edges[0].at(place), edges[1].at(place), edges[2].at(place)};
}

/// The edge functions at the centre of a pixel. Accuracy: exact.
constexpr Weights weights_at(const Edges& edges, ivec2 pixel) {
  return weights_at_place(edges, centre_of(pixel));
}

/// The triangle has its edges; the pixels in the box are tested next.
struct Prepared {
  Triangle triangle;
  std::int64_t doubled_area;
  Edges edges;
  Window box;
};

/// The centre of a pixel was tested against the three edges.
struct Tested {
  ivec2 pixel;
  Weights weights;
  bool covered;
};

/// The whole box was tested.
struct Finished {
  std::int64_t tested, covered;  ///< pixels
};

/// Whether the corners lie at most `farthest` pixels from 0.
constexpr bool near_enough(const Triangle& triangle) {
  constexpr int limit = farthest * subpixels;
  return std::ranges::all_of(
      triangle, [](ivec2 p) { return -limit <= p.x && p.x <= limit && -limit <= p.y && p.y <= limit; });
}
constexpr bool near_enough(const Window& w) {
  return w.empty() ||
         (-farthest <= std::min(w.lower.x, w.lower.y) && std::max(w.upper.x, w.upper.y) < farthest);
}

/// Whether a centre belongs to one side: inside, or on an edge that owns what lies on it.
constexpr bool belongs(const Edge& edge, std::int64_t weight) {
  return weight > 0 || (weight == 0 && edge.owns);
}

/// Whether the triangle covers the centre with these weights.
constexpr bool holds(const Edges& edges, const Weights& e) {
  return belongs(edges[0], e[0]) && belongs(edges[1], e[1]) && belongs(edges[2], e[2]);
}

/// The rows (columns) of a window, downwards (to the right).
constexpr auto rows(const Window& window) {
  return std::views::iota(window.lower.y, std::max(window.lower.y, window.upper.y + 1));
}
constexpr auto columns(const Window& window) {
  return std::views::iota(window.lower.x, std::max(window.lower.x, window.upper.x + 1));
}

/// What a finished box held: counted again for an observer, covers(pixel) says what was covered.
template <class Covers>
constexpr Finished counted(const Window& box, Covers&& covers) {
  Finished count{0, 0};
  for (const int y : rows(box)) {
    for (const int x : columns(box)) {
      count.tested += 1;
      count.covered += covers(ivec2{x, y});
    }
  }
  return count;
}

constexpr Finished counted(const Edges& edges, const Window& box) {
  return counted(box, [&](ivec2 p) { return holds(edges, weights_at(edges, p)); });
}

/// Tells which pixels of a window a triangle covers, by the signs of three edge functions and the top-left
/// rule. J. Pineda, A parallel algorithm for polygon rasterization, SIGGRAPH 1988, 17-20.
///
/// t: snapped corners, in either direction. window: the pixels that are asked for. plot(ivec2,
///   Weights) is called for each covered pixel, row by row.
///
/// Domain: corners at most `farthest` pixels from 0, and so is the window. A triangle without area covers
///   nothing.
/// Steps: Prepared Tested* Finished; Tested for each pixel of the box; nothing at all without area.
/// Accuracy: exact. Triangles that share an edge, on either side of it, cover each centre once.
/// Cost: the pixels of the box within the window, three additions each.
/// Errors: ContractViolation for corners or windows that lie too far out.
template <std::invocable<ivec2, const Weights&> Plot, Observer<Prepared, Tested, Finished> O = Unobserved>
constexpr void cover(const Triangle& t, const Window& window, Plot&& plot, O&& observer = {}) {
  expects(near_enough(t), "a corner of the triangle lies more than {} pixels out", farthest);
  expects(near_enough(window), "the window reaches more than {} pixels out", farthest);
  const auto area = doubled_area(t);
  if (area == 0) return;
  auto box = centres(t, window);
  auto edges = edges_of(t);
  if constexpr (observed<O>) observer(Prepared{t, area, edges, box});
  const auto& [ea, eb, ec] = edges;
  for (int y : rows(box)) {
    // Where the row begins
    const ivec2 p{box.lower.x, y};
    auto e = weights_at(edges, p);
    for (int x : columns(box)) {
      // Inside all three?
      bool in = holds(edges, e);
      if constexpr (observed<O>) observer(Tested{{x, y}, e, in});
      if (in) plot(ivec2{x, y}, e);
      // One pixel to the right
      e[0] += ea.step();
      e[1] += eb.step();
      e[2] += ec.step();
    }
  }
  if constexpr (observed<O>) observer(counted(edges, box));
}

/// The shares of the three corners at a pixel's centre, which add up to 1: what is linear in the picture is
/// the mean of the corners' values with these weights. Domain: weights from cover. Accuracy: 2 ulp each.
constexpr dvec3 barycentric(const Weights& w) {
  const double sum = static_cast<double>(w[0] + w[1] + w[2]);
  return {static_cast<double>(w[0]) / sum, static_cast<double>(w[1]) / sum, static_cast<double>(w[2]) / sum};
}

/// The shares of the three corners on the surface itself, seen in perspective: 1/w is linear in the picture,
/// and so is a/w of everything that is linear on the surface.
/// Source: J. F. Blinn, Hyperbolic interpolation, IEEE Computer Graphics and Applications 12(4), 1992.
///
/// weights: from cover. over_w: 1/w of the corners, > 0.
///
/// Domain: as said.
/// Accuracy: 8 ulp each; between 0 and 1, and they add up to 1 within 4 ulp.
/// Cost: 3 multiplications, 1 division.
/// Errors: none.
constexpr dvec3 perspective_correct(const Weights& weights, const dvec3& over_w) {
  const dvec3 shares = dvec3(static_cast<double>(weights[0]), static_cast<double>(weights[1]),
                             static_cast<double>(weights[2])) *
                       over_w;
  return shares / (shares.x + shares.y + shares.z);
}

}  // namespace gradus::triangle_coverage
