#pragma once
// A polygon with corners on the grid of 1/256 pixel, cut at the borders of pixels: what is left and how large
// it is. All of it is whole numbers: a corner that a cut makes is a fraction of the edge as it was given,
// never of an earlier cut.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/arithmetic/rounding.hpp"
#include "core/geometry.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

namespace gradus::area_sampling {

using triangle_coverage::farthest;
using triangle_coverage::subpixels;

/// Wide enough for products of three lengths in 1/256 pixel, and for 255 of them.
__extension__ typedef __int128 Wide;

/// The straight line through two places of the grid.
struct Line {
  ivec2 from, to;
};

/// A corner of a cut polygon: whole + rest / of in 1/256 pixel, 0 <= rest < of. A cut leaves a rest in one
/// coordinate only.
struct Vertex {
  ivec2 whole, rest{0, 0}, of{1, 1};
  Line line{};  ///< on which the polygon goes on to its next corner

  bool on_grid() const { return rest.x == 0 && rest.y == 0; }
};

using Polygon = std::vector<Vertex>;

/// The corners of an outline in pixels.
template <class T>
using Outline = std::vector<glm::vec<2, T>>;

/// Twice the area in units of 1/65536 pixel; positive when the corners run clockwise as one sees them, rows
/// downwards. Accuracy: exact.
constexpr Wide doubled_area(std::span<const ivec2> corners) {
  Wide sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ivec2 a = corners[i], b = corners[i + 1 < corners.size() ? i + 1 : 0];
    sum += Wide{a.x} * b.y - Wide{a.y} * b.x;
  }
  return sum;
}

/// The polygon with these corners, clockwise as one sees it, before anything is cut off.
inline Polygon clockwise(std::span<const ivec2> corners) {
  Polygon polygon;
  polygon.reserve(corners.size() + 4);
  for (const ivec2 corner : corners) polygon.push_back({.whole = corner});
  if (doubled_area(corners) < 0) std::ranges::reverse(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    polygon[i].line = {polygon[i].whole, polygon[i + 1 < polygon.size() ? i + 1 : 0].whole};
  return polygon;
}

// --- Cutting -----------------------------------------------------

/// A border between pixels, and the side of it that is kept.
struct Border {
  int axis;    ///< 0: a column's border, 1: a row's
  int at;      ///< in 1/256 pixel
  bool above;  ///< whether the larger coordinates are kept

  /// 1 on the kept side, 0 on the border, -1 beyond. Accuracy: exact.
  int side(const Vertex& v) const {
    if (v.whole[axis] == at && v.rest[axis] == 0) return 0;
    return (v.whole[axis] >= at) == above ? 1 : -1;
  }
  /// The border itself, as a line.
  Line line() const {
    Line line{{at, at}, {at, at}};
    line.to[1 - axis] = at + 1;
    return line;
  }
};

/// The borders of a pixel, by its row and its column.
constexpr Border top_of(int row) { return {1, row * subpixels, true}; }
constexpr Border bottom_of(int row) { return {1, (row + 1) * subpixels, false}; }
constexpr Border left_of(int column) { return {0, column * subpixels, true}; }
constexpr Border right_of(int column) { return {0, (column + 1) * subpixels, false}; }

/// The greatest whole number that is not above a / b. Domain: b != 0.
template <class Whole>
constexpr Whole floor_of_quotient(Whole a, Whole b) {
  const Whole down = a / b;
  return down - (a % b != 0 && (a < 0) != (b < 0));
}

/// Where a line crosses a border.
/// Domain: the line is not parallel to it.
/// Accuracy: exact; the same numbers in either direction of the line.
inline Vertex crossing(const Line& line, const Border& border) {
  const int along = 1 - border.axis;
  std::int64_t across = std::int64_t{line.to[border.axis]} - line.from[border.axis];
  std::int64_t product =
      (std::int64_t{border.at} - line.from[border.axis]) * (std::int64_t{line.to[along]} - line.from[along]);
  if (across < 0) across = -across, product = -product;
  const std::int64_t whole = floor_of_quotient(product, across);
  Vertex made{.whole = {border.at, border.at}, .line = line};
  made.whole[along] = static_cast<int>(line.from[along] + whole);
  made.rest[along] = static_cast<int>(product - whole * across);
  made.of[along] = static_cast<int>(across);
  return made;
}

/// The part of a polygon on the kept side of a border.
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM 17(1), 1974, 32-42.
///
/// kept: what is left; what stood there is gone.
///
/// Domain: any closed polygon; parts of a concave one may hang together along the border, without area.
/// Accuracy: exact.
/// Cost: two comparisons per corner, a division per cut.
/// Errors: none.
inline void cut(const Polygon& polygon, const Border& border, Polygon& kept) {
  kept.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex& now = polygon[i];
    const Vertex& next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const int is = border.side(now), will = border.side(next);
    // What is inside or on it stays
    if (is >= 0) kept.push_back(now);
    // The edge crosses: a corner there
    if (is * will < 0) kept.push_back(crossing(now.line, border));
    // Beyond it the polygon goes along it
    if (is >= 0 && will < 0) kept.back().line = border.line();
  }
}

/// The pixels of a window that a box round these corners touches with more than a side.
inline Window pixels_in(std::span<const ivec2> corners, const Window& window) {
  Window box;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ivec2 first{corners[i].x >> 8, corners[i].y >> 8};
    const ivec2 last{(corners[i].x - 1) >> 8, (corners[i].y - 1) >> 8};
    box.lower = i == 0 ? first : glm::min(box.lower, first);
    box.upper = i == 0 ? last : glm::max(box.upper, last);
  }
  return intersection(box, window);
}

/// The columns of a window in which a part of the polygon lies, more than a side; last < first for none.
struct Columns {
  int first, last;
};
inline Columns columns(const Polygon& polygon, const Window& window) {
  int first = window.upper.x + 1, last = window.lower.x - 1;
  for (const Vertex& v : polygon) {
    first = std::min(first, v.whole.x >> 8);
    last = std::max(last, (v.whole.x - (v.rest.x == 0)) >> 8);
  }
  return {std::max(first, window.lower.x), std::min(last, window.upper.x)};
}

// --- Areas in a scalar -------------------------------------------

/// A corner in pixels, from the upper left corner of a pixel on: from 0 to 1 for what lies in it.
/// Accuracy: 1.01 2^-54 per coordinate in the pixel; exact in rationals.
template <class T>
glm::vec<2, T> place_in(const Vertex& v, ivec2 pixel) {
  const ivec2 from = v.whole - pixel * subpixels;
  const auto coordinate = [&](int axis) {
    T at = static_cast<T>(std::int64_t{from[axis]});
    if (v.rest[axis] != 0)
      at = at + static_cast<T>(std::int64_t{v.rest[axis]}) / static_cast<T>(std::int64_t{v.of[axis]});
    return at / static_cast<T>(std::int64_t{subpixels});
  };
  return {coordinate(0), coordinate(1)};
}
template <class T>
Outline<T> outline_in(const Polygon& polygon, ivec2 pixel) {
  Outline<T> outline;
  outline.reserve(polygon.size());
  for (const Vertex& v : polygon) outline.push_back(place_in<T>(v, pixel));
  return outline;
}

/// The doubled area from a to b to c; positive when they run clockwise as one sees them, rows downwards.
template <class T>
T doubled_area(const glm::vec<2, T>& a, const glm::vec<2, T>& b, const glm::vec<2, T>& c) {
  const T ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  if constexpr (std::is_same_v<T, double> && has_fma) return unfused(ux * vy) - unfused(uy * vx);
  return ux * vy - uy * vx;
}

/// The area of an outline; negative when it runs counter-clockwise as one sees it. Nothing has area 0.
/// Accuracy: area_error for outlines in one pixel; exact in rationals.
template <class T>
T area_of(const Outline<T>& outline) {
  T sum{0};
  for (std::size_t i = 2; i < outline.size(); ++i)
    sum = sum + doubled_area(outline[0], outline[i - 1], outline[i]);
  return sum / T{2};
}

/// The area of a polygon in a pixel, as that of its outline.
template <class T>
T area_in(const Polygon& polygon, ivec2 pixel) {
  if (polygon.size() < 3) return T{0};
  T sum{0};
  const auto first = place_in<T>(polygon[0], pixel);
  auto last = place_in<T>(polygon[1], pixel);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const auto next = place_in<T>(polygon[i], pixel);
    sum = sum + doubled_area(first, last, next);
    last = next;
  }
  return sum / T{2};
}

/// How far off the area of an outline in one pixel may be in double. Its corners lie 1.01 2^-54 off, which is
/// worth that times the way round it, at most 2 per corner; each triangle of the fan is off by 7 roundings of
/// at most 1, and the sum of k of them is rounded from at most k.
constexpr double area_error(std::size_t corners) {
  const double m = static_cast<double>(corners);
  return m * (m + 20) * 0x1p-55;
}

// --- Areas in whole numbers --------------------------------------

/// A sum of fractions below 1 and a whole number.
struct MixedSum {
  struct Fraction {
    std::int64_t rest, of;  ///< 0 < rest < of <= 2^31
  };
  Wide whole = 0;
  std::vector<Fraction> fractions{};

  void add(Wide numerator, std::int64_t of) {
    const Wide down = floor_of_quotient(numerator, Wide{of});
    const auto rest = static_cast<std::int64_t>(numerator - down * of);
    whole += down;
    if (rest > 0) fractions.push_back({rest, of});
  }

  /// Whether the sum is below 0: long division, digit by digit of 2^32, for all fractions at once. What is
  /// not yet divided is worth less than one a fraction. Sums that are not 0 differ from it by at least the
  /// product of all 1 / of, so that an end is known.
  bool below_0() const {
    const auto count = static_cast<Wide>(fractions.size());
    std::vector<Fraction> rests = fractions;
    Wide sum = whole;
    for (std::size_t digit = 0; digit <= rests.size(); ++digit) {
      if (sum >= 0) return false;
      if (sum + count <= 0) return true;
      sum *= Wide{1} << 32;
      for (Fraction& f : rests) {
        const Wide shifted = Wide{f.rest} << 32;
        sum += shifted / f.of;
        f.rest = static_cast<std::int64_t>(shifted % f.of);
      }
    }
    return sum + count <= 0;
  }
};

/// Adds factor times the doubled area between an edge of a cut polygon and a place of the grid, in 1/65536
/// pixel. A place of the edge's line is from + s (to - from); s is a fraction with a small denominator where
/// the place has no rest.
inline void add_doubled_area(MixedSum& sum, const Vertex& a, const Vertex& b, ivec2 place, int factor) {
  const auto [from, to] = a.line;
  const std::int64_t wx = std::int64_t{to.x} - from.x, wy = std::int64_t{to.y} - from.y;
  const std::int64_t ox = std::int64_t{from.x} - place.x, oy = std::int64_t{from.y} - place.y;
  if (wx == 0 && wy == 0) return;  // a corner that is given twice
  const Wide whole_line = Wide{ox} * wy - Wide{oy} * wx;
  const auto add = [&](const Vertex& v, int sign) {
    const int axis = wx != 0 && (v.rest.x == 0 || wy == 0) ? 0 : 1;
    const std::int64_t way = axis == 0 ? wx : wy;
    const Wide unit = (way < 0 ? -whole_line : whole_line) * sign * factor;
    sum.add(unit * (std::int64_t{v.whole[axis]} - from[axis]), way < 0 ? -way : way);
    // Along a border one coordinate has a rest, and the line's way is 1
    if (v.rest[axis] != 0) sum.add(unit * v.rest[axis], v.of[axis]);
  };
  add(b, 1);
  add(a, -1);
}

/// Whether `levels` times the area of a polygon in a pixel is at least number - 1/2, that is, whether it is
/// rounded to `number` or more.
/// Domain: clockwise as one sees it, in the pixel. Accuracy: exact.
inline bool rounds_to_at_least(const Polygon& polygon, ivec2 pixel, int levels, int number) {
  MixedSum sum;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex& next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    add_doubled_area(sum, polygon[i], next, pixel * subpixels, levels);
  }
  sum.add(-Wide{2 * number - 1} * (subpixels * subpixels), 1);
  return !sum.below_0();
}

}  // namespace gradus::area_sampling
