#pragma once
// Circles on a pixel grid: which pixels lie nearest to a circle round a pixel centre with a whole radius.
//
// One octant is enough, from (0, r) to the diagonal: there the circle falls by at most one pixel per column,
// so each step goes E or SE. Seven mirror images of it complete the circle.
//
// There are no ties: the middle between two pixels of a column is never on such a circle, for y - 1/2 is not
// the square root of an integer.

#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>

#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::bresenham_circle {

/// Whole numbers that int may be too short for: places of a large circle, the decision parameter.
using Whole = std::int64_t;

// --- The circle and its eight octants ----------------------------

/// One eighth of a circle: where its own x and y point. Its pixels are center + x * right + y * up,
/// with 0 <= x <= y, so that they start on an axis and end at a diagonal.
struct Octant {
  int number;  ///< 1: from (0, r) to the right; on clockwise to 8
  ivec2 right, up;

  /// Neighbouring octants meet on an axis or on a diagonal; the odd ones have the pixels there.
  constexpr bool has_borders() const { return number % 2 == 1; }
};

/// All of them, clockwise from (0, r), y up: quarter turns of the first, and of its mirror image.
inline constexpr std::array<Octant, 8> octants{{{1, {1, 0}, {0, 1}},
                                                {2, {0, 1}, {1, 0}},
                                                {3, {0, -1}, {1, 0}},
                                                {4, {1, 0}, {0, -1}},
                                                {5, {-1, 0}, {0, -1}},
                                                {6, {0, -1}, {-1, 0}},
                                                {7, {0, 1}, {-1, 0}},
                                                {8, {-1, 0}, {0, 1}}}};

/// The pixel at (x, y) of an octant. Domain: it lies in the int32 plane.
constexpr ivec2 pixel_of(ivec2 center, const Octant& octant, Whole x, Whole y) {
  return {static_cast<int>(center.x + x * octant.right.x + y * octant.up.x),
          static_cast<int>(center.y + x * octant.right.y + y * octant.up.y)};
}

/// Whether the whole circle lies in the int32 plane.
constexpr bool fits_plane(ivec2 center, int radius) {
  const auto fits = [radius](int c) {
    return Whole{INT32_MIN} <= Whole{c} - radius && Whole{c} + radius <= INT32_MAX;
  };
  return fits(center.x) && fits(center.y);
}

/// Plots the mirror images of (x, y), each pixel once: on an axis and on a diagonal two of the eight are one,
/// and a circle of radius 0 is its centre.
template <class Plot>
constexpr void plot_once(ivec2 center, Whole x, Whole y, Plot& plot) {
  for (const Octant& octant : octants) {
    if (!octant.has_borders() && (x == 0 || x == y)) continue;
    plot(pixel_of(center, octant, x, y));
    if (y == 0) return;
  }
}

// --- Steps -------------------------------------------------------

// Steps give places as (x, y) of the first octant, seen from the centre.

/// The decision parameter has its first value; (0, radius) and its mirror images are about to be plotted.
struct Started {
  ivec2 center;
  int radius;
  Whole p;  ///< 3 - 2 radius
};

/// The test was read: is at + (1, 0) nearer to the circle, or at + (1, -1)?
struct Compared {
  ivec2 at;   ///< where the octant stands
  Whole p;    ///< the value tested: < 0 E, > 0 SE; it is odd, so never 0
  bool east;  ///< what the test decided
};

/// The octant stands on its next place and p is ready for the next test. The place is about to be plotted,
/// with its mirror images, unless it lies past the diagonal.
struct Stepped {
  ivec2 at;           ///< where it stands
  Whole p_before, p;  ///< the value that was tested, the value that will be
  bool east;

  constexpr ivec2 from() const { return {at.x - 1, east ? at.y : at.y + 1}; }  ///< where it stood
};

/// Every pixel is plotted.
struct Finished {
  Whole pixels;  ///< how many
};

/// (x, y) as steps give it.
constexpr ivec2 place(Whole x, Whole y) { return {static_cast<int>(x), static_cast<int>(y)}; }

// --- How many pixels it has --------------------------------------

/// The square root, rounded down. Domain: 0 <= n. Cost: about six divisions.
constexpr Whole square_root(Whole n) {
  if (n == 0) return 0;
  // Newton's iteration, from above
  Whole root = Whole{1} << (std::bit_width(static_cast<std::uint64_t>(n)) + 1) / 2;
  for (Whole next = (root + n / root) / 2; next < root; next = (root + n / root) / 2) root = next;
  return root;
}

/// The circle's height in a column, rounded to the nearest pixel: y of the place that decision_parameter
/// reaches after x steps. Domain: 0 <= x <= radius.
constexpr Whole height_at(int radius, Whole x) {
  const Whole squared = Whole{radius} * radius - x * x, root = square_root(squared);
  return root + (squared > root * root + root);
}

/// Columns first .. last of an octant. Empty when last < first.
struct Stretch {
  Whole first = 0, last = -1;

  constexpr bool empty() const { return last < first; }
  constexpr Whole count() const { return empty() ? 0 : last - first + 1; }
};

/// The last column of an octant: the greatest x that is not greater than the height there.
constexpr Whole last_column(int radius) {
  const Whole squared = Whole{radius} * radius, x = square_root(squared / 2);
  return x < radius && height_at(radius, x + 1) > x ? x + 1 : x;
}

/// The columns whose pixels belong to this octant and to no other.
constexpr Stretch columns_of(int radius, const Octant& octant) {
  const Whole last = last_column(radius);
  if (radius == 0) return octant.number == 1 ? Stretch{0, 0} : Stretch{};
  if (octant.has_borders()) return {0, last};
  return {1, height_at(radius, last) == last ? last - 1 : last};
}

/// How many pixels a circle has. Domain: radius >= 0. Cost: O(1).
constexpr Whole pixel_count(int radius) {
  Whole count = 0;
  for (const Octant& octant : octants) count += columns_of(radius, octant).count();
  return count;
}

// --- The taught method -------------------------------------------

/// Draws a circle with an integer decision parameter. With d(x, y) = x² + y² - r², positive outside, p is
/// d at E plus d at SE, which is 2 d + 1/2 at the middle between them: its sign says on whose side the circle
/// passes, and one addition keeps it up to date.
/// J. E. Bresenham, A linear algorithm for incremental digital display of circular arcs, Communications of
/// the ACM 20(2), 1977, 100-106.
///
/// center: any pixel. radius: in pixels, 0 to 2^31 - 1. plot(ivec2) is called once per pixel; the mirror
///   images of one place of the octant come together, clockwise.
///
/// Domain: center ± radius lies in int32 (bresenham_circle_window.hpp takes all others); radius 0 gives one
/// pixel. |p| <= 4
///   radius + 3, so it needs 64 bits (in 32 the update overflows from radius 536894085 on).
/// Steps: Started (Compared Stepped)* Finished; the last Stepped may end past the diagonal, on the mirror
///   image of the place before, which is not plotted again.
/// Accuracy: in every column of the octant the pixel nearest to the circle, less than 1/2 pixel off along the
///   radius and along y. Each pixel once.
/// Cost: radius / sqrt(2) steps of two additions, a shift and two tests; no multiplication or division, no
///   memory; about 4 sqrt(2) radius pixels.
/// Errors: ContractViolation outside the domain.
template <class Plot, Observer<Started, Compared, Stepped, Finished> O = Unobserved>
constexpr void decision_parameter(ivec2 center, int radius, Plot&& plot, O&& observer = {}) {
  expects(radius >= 0, "a circle has a radius of 0 or more, not {}", radius);
  expects(fits_plane(center, radius), "the circle round ({}, {}) with radius {} leaves int32", center.x,
          center.y, radius);
  Whole x = 0, y = radius;
  // Is E nearer the circle, or SE?
  Whole p = 3 - 2 * y;
  if constexpr (observed<O>) observer(Started{center, radius, p});
  plot_once(center, x, y, plot);
  while (x < y) {
    if (p < 0) {
      if constexpr (observed<O>) observer(Compared{place(x, y), p, true});
      p += 4 * x + 6;
      ++x;  // E
      if constexpr (observed<O>) observer(Stepped{place(x, y), p - 4 * x - 2, p, true});
    } else {
      if constexpr (observed<O>) observer(Compared{place(x, y), p, false});
      p += 4 * (x - y) + 10;
      ++x;
      --y;  // SE
      if constexpr (observed<O>) observer(Stepped{place(x, y), p - 4 * (x - y) - 2, p, false});
    }
    // Past the diagonal it is drawn
    if (x > y) break;
    plot_once(center, x, y, plot);
  }
  if constexpr (observed<O>) observer(Finished{pixel_count(radius)});
}

}  // namespace gradus::bresenham_circle
