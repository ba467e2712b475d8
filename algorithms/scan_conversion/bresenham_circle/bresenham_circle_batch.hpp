#pragma once
// Circles for speed: the pixels of bresenham_circle.hpp, written straight into memory.

#include <cstddef>
#include <span>

#include "core/raster.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_window.hpp"

namespace gradus::bresenham_circle {

/// A whole circle, eight pixels per step: two in each of four rows, which walk from the top, the bottom and
/// the middle towards the diagonals. Pixels on an axis or a diagonal are written twice, which is cheaper than
/// asking. Domain: all of it lies in the raster.
template <class Cell>
void draw_whole(Raster<Cell>& raster, ivec2 center, int radius, const Cell& value) {
  const Cell ink = value;
  const std::ptrdiff_t width = raster.width();
  Cell* above = &raster[center];
  Cell* below = above;
  std::ptrdiff_t x = 0, y = radius, p = 3 - 2 * y;
  Cell* top = above - y * width;
  Cell* bottom = above + y * width;
  while (x <= y) {
    top[x] = top[-x] = bottom[x] = bottom[-x] = ink;
    above[y] = above[-y] = below[y] = below[-y] = ink;
    // Both moves without a branch: near the diagonal nobody can guess which it is
    const bool east = p < 0;
    p += east ? 4 * x + 6 : 4 * (x - y) + 10;
    y -= east ? 0 : 1;
    top += east ? 0 : width;
    bottom -= east ? 0 : width;
    ++x;
    above -= width;
    below += width;
  }
}

/// A part of an octant. Domain: it lies in the raster and is not empty.
template <class Cell>
void draw_arc(Raster<Cell>& raster, const Arc& arc, const Cell& value) {
  const Octant& octant = arc.octant;
  const Stretch& shown = arc.shown;
  Whole x = shown.first, y = arc.height(x), p = arc.decision(x, y);
  const std::ptrdiff_t right = octant.right.x + octant.right.y * std::ptrdiff_t{raster.width()};
  const std::ptrdiff_t up = octant.up.x + octant.up.y * std::ptrdiff_t{raster.width()};
  Cell* cell = &raster[arc.pixel(x, y)];
  *cell = value;
  while (x < shown.last) {
    const bool east = p < 0;
    p += east ? 4 * x + 6 : 4 * (x - y) + 10;
    cell += east ? right : right - up;
    y -= east ? 0 : 1;
    ++x;
    *cell = value;
  }
}

/// Draws a circle into a raster: gives `value` to the cells of decision_parameter that lie in it.
///
/// Domain: radius >= 0, any int32 centre; what lies outside the raster is not drawn.
/// Accuracy: exactly the pixels of in_window.
/// Cost: O(width + height) of the raster at most, however large the circle; square roots only when it is cut.
/// Errors: ContractViolation when the radius is negative.
template <class Cell>
void draw(Raster<Cell>& raster, ivec2 center, int radius, const Cell& value) {
  expects(radius >= 0, "a circle has a radius of 0 or more, not {}", radius);
  const auto within = [radius](int c, int size) { return radius <= c && Whole{c} + radius < size; };
  if (within(center.x, raster.width()) && within(center.y, raster.height())) {
    draw_whole(raster, center, radius, value);
    return;
  }
  for (const Arc& arc : visible({center, radius}, raster.window())) {
    if (arc.shown.count() > 0) draw_arc(raster, arc, value);
  }
}

/// Draws many circles, in order. Cost: the sum of the circles'.
template <class Cell>
void draw(Raster<Cell>& raster, std::span<const Circle<int>> circles, const Cell& value) {
  for (const auto& [centre, radius] : circles) draw(raster, centre, radius, value);
}

}  // namespace gradus::bresenham_circle
