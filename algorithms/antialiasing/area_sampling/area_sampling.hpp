#pragma once
// Antialiasing without samples: each polygon counts in a pixel by its exact area there. A polygon is cut at
// the borders of pixels; where several lie in one pixel, the visible parts have exact areas as well.
//
// Rows grow downwards, as in an image: pixel (c, r) covers [c, c+1) x [r, r+1). Corners lie on the grid of
// 1/256 pixel, so that all areas are rational.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <glm/vec2.hpp>
#include <ranges>
#include <span>
#include <vector>

#include "antialiasing/area_sampling/pixel_polygon.hpp"
#include "antialiasing/area_sampling/visible_areas.hpp"
#include "antialiasing/area_sampling/visible_picture.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"

namespace gradus::area_sampling {

// --- Steps -------------------------------------------------------

/// The polygon will be cut at the pixels of its box.
struct Started {
  std::vector<ivec2> corners;  ///< in 1/256 pixel
  Window box;
};

/// One border cut something off, or nothing.
struct BorderCut {
  Border border;
  Polygon left;
};

/// What lies in one pixel is known, and its area.
template <class T>
struct AreaTaken {
  ivec2 pixel;
  Polygon piece;
  T area;
};

/// All pixels are done.
struct Finished {
  std::int64_t clipped, covered;  ///< pixels: the polygon was clipped to, and has a part of
};

// --- The taught method -------------------------------------------

/// What every form asks of its input.
inline void expect_places(std::span<const ivec2> corners, const Window& window) {
  constexpr int limit = farthest * subpixels;
  for (const ivec2 p : corners) {
    expects(-limit <= p.x && p.x <= limit && -limit <= p.y && p.y <= limit,
            "a corner of the polygon lies more than {} pixels out", farthest);
  }
  expects(near_enough(window), "the window reaches more than {} pixels out", farthest);
}

/// Counts pixels for the last step.
struct Pixels {
  std::int64_t clipped = 0, covered = 0;

  template <class T>
  const AreaTaken<T>& operator()(const AreaTaken<T>& step) {
    ++clipped;
    covered += step.area > T{0};
    return step;
  }
  Finished operator()(Finished) const { return {clipped, covered}; }
};

/// The rows of a window, none where it is empty, and the columns in which a part of a polygon lies.
inline auto from_to(int first, int last) { return std::views::iota(first, last < first ? first : last + 1); }
inline auto rows(const Window& box) { return from_to(box.lower.y, box.upper.y); }
inline auto reach(const Polygon& polygon, const Window& box) {
  const auto [first, last] = columns(polygon, box);
  return from_to(first, last);
}

/// What pixel_areas does in the pixels of the polygon's box.
template <class T = double, class Plot, Observer<Started, BorderCut, AreaTaken<T>, Finished> O = Unobserved>
void clip_to_pixels(std::span<const ivec2> corners, const Window& box, Plot&& plot, O&& observer = {}) {
  Polygon all = clockwise(corners);
  Polygon half;
  Polygon row;
  Polygon piece;
  Tally<O, Pixels> tally(observer);
  if constexpr (observed<O>) observer(Started{{corners.begin(), corners.end()}, box});
  for (int y : rows(box)) {
    // What lies in this row
    cut(all, top_of(y), half);
    if constexpr (observed<O>) observer(BorderCut{top_of(y), half});
    cut(half, bottom_of(y), row);
    if constexpr (observed<O>) observer(BorderCut{bottom_of(y), row});
    for (int x : reach(row, box)) {
      // What lies in this pixel
      cut(row, left_of(x), half);
      if constexpr (observed<O>) observer(BorderCut{left_of(x), half});
      cut(half, right_of(x), piece);
      if constexpr (observed<O>) observer(BorderCut{right_of(x), piece});
      // How large that is
      const ivec2 p(x, y);
      T area = area_in<T>(piece, p);
      if constexpr (observed<O>) observer(tally.count(AreaTaken<T>{p, piece, area}));
      if (!(area > T{0})) continue;
      plot(p, area);
    }
  }
  if constexpr (observed<O>) observer(tally.count(Finished{0, 0}));
}

/// The area of a polygon in each pixel: the polygon is clipped to the pixel, and what is left is measured.
/// E. Catmull, A hidden-surface algorithm with anti-aliasing, SIGGRAPH 1978, 6-11.
///
/// T: the areas' type, double or a rational. corners: the polygon's, in 1/256 pixel, in order, either way
///   round. window: the pixels that are asked for. plot(ivec2, T) is called for each pixel in which the
///   polygon has an area, row by row; 1 is a whole pixel.
///
/// Domain: corners at most `farthest` pixels from 0, and so is the window. Polygons are simple, that is, do
///   not cross themselves; they may be concave, and of no area.
/// Steps: Started (BorderCut BorderCut (BorderCut BorderCut AreaTaken)*)* Finished: above and below for each
///   row, left and right for each pixel in which something of the row may lie.
/// Accuracy: clipping is exact; areas are exact in rationals, and in double within area_error of the piece's
///   corners (2^-50 for triangles). So the areas of all pixels add up to the polygon's, and those of polygons
///   that share a pixel to 1.
/// Cost: the pixels touched, each a pass over what the row's two borders have left; a convex polygon is
///   clipped to exactly the pixels in which it has an area.
/// Errors: ContractViolation for corners or windows that lie too far out.
template <class T = double, class Plot, Observer<Started, BorderCut, AreaTaken<T>, Finished> O = Unobserved>
void pixel_areas(std::span<const ivec2> corners, const Window& window, Plot&& plot, O&& observer = {}) {
  expect_places(corners, window);
  clip_to_pixels<T>(corners, pixels_in(corners, window), plot, observer);
}

/// The byte of a pixel that is covered so far: floor(255 area + 1/2). Domain: 0 <= area <= 1 and a bit.
inline int byte_of(double area) { return static_cast<int>(std::floor(255 * area + 0.5)); }

/// The byte of the area of a piece in a pixel, without any rounding on the way: where the area in double may
/// be on the other side of a half, whole numbers decide.
///
/// piece: what pixel_areas has clipped to the pixel. area: its area in double.
///
/// Accuracy: exact.
/// Cost: a multiplication and two roundings; in doubt, about a microsecond.
inline int byte_of(const Polygon& piece, ivec2 pixel, double area) {
  const bool exact = std::ranges::all_of(piece, [](const Vertex& v) { return v.on_grid(); });
  const double bound = exact ? 0 : 255 * area_error(piece.size()) + 0x1p-43;
  const double scaled = 255 * area + 0.5;
  const int low = static_cast<int>(std::floor(scaled - bound));
  const int high = static_cast<int>(std::floor(scaled + bound));
  if (low == high) return low;
  return rounds_to_at_least(piece, pixel, 255, high) ? high : low;
}

/// The bytes of a polygon's areas: floor(255 area + 1/2) for the exact area of each pixel.
///
/// plot(ivec2, std::uint8_t) is called for each pixel in which the polygon has an area, also where its byte
///   is 0.
///
/// Domain, Errors: as pixel_areas.
/// Accuracy: exact.
template <class Plot>
void pixel_bytes(std::span<const ivec2> corners, const Window& window, Plot&& plot) {
  const auto nothing = [](ivec2, double) {};
  pixel_areas(corners, window, nothing, [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, AreaTaken<double>>) {
      if (step.area > 0)
        plot(step.pixel, static_cast<std::uint8_t>(byte_of(step.piece, step.pixel, step.area)));
    }
  });
}

}  // namespace gradus::area_sampling
