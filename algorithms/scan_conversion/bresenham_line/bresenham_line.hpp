#pragma once
// Straight lines on a pixel grid: which pixels lie nearest to the line from one pixel centre to another.
//
// Seen along its leading axis (the one it covers more of; x when both are equal) a line advances
// by one pixel per step and either goes straight on or one pixel aside too. In the first octant
// those are the textbook's E and NE.
//
// Where the exact line passes midway between two pixels the one with the smaller y is taken, for steep lines
// the one with the smaller x. The rule looks at places, never at directions, so both directions of a line are
// the same set of pixels.

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <glm/vec2.hpp>
#include <utility>

#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"

namespace gradus::bresenham_line {

/// Whole numbers that int may be too short for: lengths, numbers of pixels, the decision parameter.
using Whole = std::int64_t;

// --- What every method knows about a line before it starts -------

/// How far a line goes, in pixels: dx along its leading axis, dy along the other. 0 <= dy <= dx < 2^32.
/// (For a steep line dx is counted along y: the names are those of the first octant.)
struct Extent {
  Whole dx, dy;
};

/// The two moves a line is made of, each one pixel long.
struct Moves {
  ivec2 straight;  ///< one pixel along the leading axis (E in the first octant)
  ivec2 diagonal;  ///< the same, and one pixel aside (NE in the first octant)
  bool tie;  ///< whether it is `straight` when the line passes midway: it has the smaller coordinate aside
};

/// |to.x - from.x| and |to.y - from.y|, exact for all int32 coordinates.
constexpr Whole distance_x(ivec2 from, ivec2 to) {
  return from.x < to.x ? Whole{to.x} - from.x : Whole{from.x} - to.x;
}
constexpr Whole distance_y(ivec2 from, ivec2 to) {
  return from.y < to.y ? Whole{to.y} - from.y : Whole{from.y} - to.y;
}

/// Whether y leads: the line covers more of y than of x.
constexpr bool steep(ivec2 from, ivec2 to) { return distance_y(from, to) > distance_x(from, to); }

constexpr Extent extent(ivec2 from, ivec2 to) {
  const Whole x = distance_x(from, to), y = distance_y(from, to);
  return {std::max(x, y), std::min(x, y)};
}

constexpr Moves moves(ivec2 from, ivec2 to) {
  const int x = from.x <= to.x ? 1 : -1;
  const int y = from.y <= to.y ? 1 : -1;
  if (steep(from, to)) return {{0, y}, {x, y}, x > 0};
  return {{x, 0}, {x, y}, y > 0};
}

/// How many pixels a line has: max(|dx|, |dy|) + 1, at most 2^32. Cost: O(1).
constexpr Whole pixel_count(ivec2 from, ivec2 to) { return extent(from, to).dx + 1; }

// --- Steps -------------------------------------------------------

/// The decision parameter has its first value; `from` is about to be plotted.
struct Started {
  ivec2 from, to;
  Whole dx, dy;  ///< lengths along the leading axis and aside, in pixels
  Whole p;       ///< 2 dy - dx
  Moves moves;
};

/// The test was read: is pixel + moves.straight nearer to the line, or pixel + moves.diagonal? (The one not
/// taken may lie outside int32 when the line runs along the border of the plane.)
struct Compared {
  ivec2 pixel;  ///< where the line stands
  Moves moves;
  Whole p;        ///< the value tested: < 0 straight, > 0 diagonal, 0 straight if moves.tie
  bool straight;  ///< what the test decided
};

/// The line stands on its next pixel, which is about to be plotted, and p is ready for the next test.
struct Stepped {
  ivec2 from, pixel;  ///< where it stood, where it stands
  Whole p_before, p;  ///< the value that was tested, the value that will be
  bool straight;
};

/// Every pixel is plotted.
struct Finished {
  Whole pixels;  ///< how many
};

// --- The taught method -------------------------------------------

/// Draws a line with an integer decision parameter. p is 2 dx times the height by which the exact
/// line passes above the middle between the two next pixels, so its sign alone decides, and
/// one addition keeps it up to date.
/// J. E. Bresenham, Algorithm for computer control of a digital plotter, IBM
/// Systems Journal 4(1), 1965, 25-30.
///
/// from, to: the centres of the end pixels, any int32 coordinates. plot(ivec2) is called once per pixel,
///   in order from `from` to `to`, both included.
///
/// Domain: everything; from == to gives one pixel. |p| < 2^33, so 64 bits hold it for every line (32 do not).
/// Steps: Started (Compared Stepped)* Finished; Compared and Stepped once for every pixel but the first.
/// Accuracy: every pixel lies within 1/2 pixel of the exact line, measured along the axis that does not lead;
///   the same pixels whichever end comes first (midway: the smaller y, on steep lines the smaller x).
/// Cost: max(|dx|, |dy|) steps of two additions and two or three tests; no multiplication or
///   division in the loop, no memory.
/// Errors: none.
template <class Plot, Observer<Started, Compared, Stepped, Finished> O = Unobserved>
constexpr void decision_parameter(ivec2 from, ivec2 to, Plot&& plot, O&& observer = {}) {
  auto [dx, dy] = extent(from, to);
  const Moves go = moves(from, to);
  const auto& [E, NE, tie] = go;
  // Does the line pass above the
  // midpoint between the next two?
  Whole p = 2 * dy - dx;
  if constexpr (observed<O>) observer(Started{from, to, dx, dy, p, go});
  ivec2 pixel = from;
  plot(pixel);
  while (pixel != to) {
    if (p < 0 || (p == 0 && tie)) {
      if constexpr (observed<O>) observer(Compared{pixel, go, p, true});
      pixel += E;
      p += 2 * dy;
      if constexpr (observed<O>) observer(Stepped{pixel - E, pixel, p - 2 * dy, p, true});
    } else {
      if constexpr (observed<O>) observer(Compared{pixel, go, p, false});
      pixel += NE;
      p += 2 * (dy - dx);
      if constexpr (observed<O>) observer(Stepped{pixel - NE, pixel, p - 2 * (dy - dx), p, false});
    }
    plot(pixel);
  }
  if constexpr (observed<O>) observer(Finished{dx + 1});
}

// --- The rival with fractions ------------------------------------

/// The slope is divided, once, and rounded to T; `from` is about to be plotted.
template <class T>
struct Divided {
  ivec2 from, to;
  Whole dx, dy;
  T slope;  ///< dy / dx in T; 0 for a line of one pixel
  Moves moves;
};

/// The slope was added once more.
template <class T>
struct Added {
  Whole k;           ///< how often by now, which is the number of the pixel to come; exactly, k dy / dx
  T before, offset;  ///< how far aside the line lay and lies, in pixels, as T adds it up
};

/// Keeps the sum that the slope is added to next.
template <class T>
struct SumBefore {
  T sum{0};

  constexpr Added<T> operator()(Added<T> step) {
    step.before = std::exchange(sum, step.offset);
    return step;
  }
};

/// The offset was rounded to a pixel, which is about to be plotted.
template <class T>
struct Rounded {
  Whole k;    ///< number of the pixel
  T offset;   ///< what was rounded
  Whole row;  ///< to what: pixels aside of `from`
  ivec2 pixel;
};

/// dy / dx in T; 0 for a line of one pixel.
template <class T>
constexpr T ratio(Whole dy, Whole dx) {
  return dx == 0 ? T(0) : T(dy) / T(dx);
}

/// The pixel `k` steps along the leading axis and `row` pixels aside. Domain: it lies in the int32 plane.
constexpr ivec2 place(ivec2 from, const Moves& go, Whole k, Whole row) {
  const ivec2 aside = go.diagonal - go.straight;
  return {static_cast<int>(from.x + k * go.straight.x + row * aside.x),
          static_cast<int>(from.y + k * go.straight.y + row * aside.y)};
}

/// The integer nearest to offset, looked for from `row` upwards; midway the one of the straight move.
/// Exact in every T: the differences it takes are representable. It ends: T(row) grows until it is offset.
/// Domain: offset finite.
template <class T>
constexpr Whole nearest(const T& offset, Whole row, const Moves& go) {
  const T half = T(1) / T(2);
  while (half < offset - T(row) || (!go.tie && half == offset - T(row))) ++row;
  return row;
}

/// Whether a line's pixels stay in the int32 plane even when they stray: see dda.
constexpr bool room_to_stray(ivec2 from, ivec2 to) {
  if (extent(from, to).dy == 0) return true;
  const ivec2 way = moves(from, to).diagonal;
  const Whole far = extent(from, to).dx;
  const Whole aside = steep(from, to) ? from.x + far * way.x : from.y + far * way.y;
  return Whole{INT32_MIN} <= aside && aside <= INT32_MAX;
}

/// Draws a line with a digital differential analyser: adds the slope once per step and rounds the sum
/// to a pixel. The slope is rounded to T, and so is every sum, hence the pixels drift off the exact
/// line; with T = Exact they do not.
/// The textbook forerunner; see D. F. Rogers, Procedural elements for computer graphics, 1985, section 2-3.
///
/// T: float, double or gradus::Exact; it needs T(std::int64_t), + - / and comparisons.
/// from, to, plot: as for decision_parameter, and the same rule midway.
///
/// Domain: both ends and the pixel max(|dx|, |dy|) aside of `from` lie in the int32 plane (level and upright
///   lines: everything). No drift is larger: each sum is at most k after k steps, since rounding to T never
///   passes an integer that T holds, and stops growing at the first that it does not. A line for which there
///   is no such room is refused, not bent back into the plane.
/// Steps: Divided (Added Rounded)* Finished, with Added and Rounded once for every pixel but the first.
/// Accuracy: T = Exact gives the pixels of decision_parameter. Otherwise, with e the rounding unit of T
///   (2^-24 for float, 2^-53 for double), pixel k lies within 1/2 + e k (k + 3) of the exact line. The first
///   wrong pixels are in docs/topics/scan_conversion/bresenham_line.md.
/// Cost: one division, then one addition and one rounding in T per pixel.
/// Errors: ContractViolation outside the domain.
template <class T = float, class Plot, Observer<Divided<T>, Added<T>, Rounded<T>, Finished> O = Unobserved>
constexpr void dda(ivec2 from, ivec2 to, Plot&& plot, O&& observer = {}) {
  expects(room_to_stray(from, to), "dda may stray by max(|dx|, |dy|) = {} and leave int32",
          extent(from, to).dx);
  auto [dx, dy] = extent(from, to);
  const Moves go = moves(from, to);
  const T slope = ratio<T>(dy, dx);
  Tally<O, SumBefore<T>> tally(observer);
  if constexpr (observed<O>) observer(Divided<T>{from, to, dx, dy, slope, go});
  T offset = T(0);
  Whole row = 0;
  ivec2 pixel = from;
  plot(pixel);
  for (Whole k = 1; k <= dx; ++k) {
    // The next sum, rounded to T
    offset += slope;
    if constexpr (observed<O>) observer(tally.count(Added<T>{k, {}, offset}));
    // The nearest pixel
    row = nearest(offset, row, go);
    pixel = place(from, go, k, row);
    if constexpr (observed<O>) observer(Rounded<T>{k, offset, row, pixel});
    plot(pixel);
  }
  if constexpr (observed<O>) observer(Finished{dx + 1});
}

}  // namespace gradus::bresenham_line
