#pragma once
// Exhibits: two listings of lecture notes that draw wrong lines, kept as printed so that a figure can show
// where, and the loop that a misprinted derivation of theirs leads to. Never use them to draw;
// bresenham_line.hpp has the right ones.

#include <cstdint>
#include <utility>

#include "scan_conversion/bresenham_line/bresenham_line.hpp"

namespace gradus::bresenham_line {

/// to - from, with its signs.
constexpr Extent offset(ivec2 from, ivec2 to) { return {Whole{to.x} - from.x, Whole{to.y} - from.y}; }

/// E and NE as they are in the first octant; midway NE.
inline constexpr Moves e_and_ne{{1, 0}, {1, 1}, false};

/// FAULTY outside the first octant: Bresenham's loop for slopes 0 <= m <= 1, with the end points swapped to
/// go from left to right, and nothing done about any other slope.
/// The notes' first listing (they do say for which slopes it holds; errata E001-03).
///
/// from, to: any int32 coordinates (the arithmetic is widened; the printed int overflows: see swapped_ends).
///   Pixels come from the left end to the right one.
///
/// Domain: right for 0 <= dy <= dx only. Downward lines come out flat ((0,0)-(4,-2) stays in row 0), steep
///   ones as diagonals cut short ((0,0)-(2,4) ends at (2,2)), vertical ones as one pixel.
/// Steps: Started (Compared Stepped)* Finished. Started.dy may be negative or above dx.
/// Accuracy: none outside the first octant: `to` itself is not reached.
/// Cost: |to.x - from.x| steps.
template <class Plot, Observer<Started, Compared, Stepped, Finished> O = Unobserved>
constexpr void first_octant(ivec2 from, ivec2 to, Plot&& plot, O&& observer = {}) {
  const Moves go = e_and_ne;
  if (from.x > to.x) {
    std::swap(from, to);
  }
  auto [dx, dy] = offset(from, to);
  Whole p = 2 * dy - dx;
  if constexpr (observed<O>) observer(Started{from, to, dx, dy, p, go});
  ivec2 pixel = from;
  plot(pixel);
  while (pixel.x < to.x) {
    if (p < 0) {
      if constexpr (observed<O>) observer(Compared{pixel, go, p, true});
      pixel += go.straight;  // E
      p += 2 * dy;
      if constexpr (observed<O>) observer(Stepped{pixel - go.straight, pixel, p - 2 * dy, p, true});
    } else {
      if constexpr (observed<O>) observer(Compared{pixel, go, p, false});
      pixel += go.diagonal;  // NE
      p += 2 * (dy - dx);
      if constexpr (observed<O>) observer(Stepped{pixel - go.diagonal, pixel, p - 2 * (dy - dx), p, false});
    }
    plot(pixel);
  }
  if constexpr (observed<O>) observer(Finished{dx + 1});
}

/// An int as the notes use it: what does not fit into 32 bits wraps, modulo 2^32, as it does on today's
/// machines. (In C++ such an overflow is undefined.)
struct Int {
  std::int32_t value;

  constexpr Int(std::int64_t exact)
      : value(static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(exact)))) {}

  friend constexpr std::int32_t operator+(Int a) { return a.value; }  ///< the plain number
  friend constexpr Int operator+(Int a, Int b) { return std::int64_t{a.value} + b.value; }
  friend constexpr Int operator-(Int a, Int b) { return std::int64_t{a.value} - b.value; }
  friend constexpr Int operator*(Int a, Int b) { return std::int64_t{a.value} * b.value; }
  friend constexpr Int& operator+=(Int& a, Int b) { return a = a + b; }
  friend constexpr auto operator<=>(Int, Int) = default;
};

/// |b - a|
constexpr Int gap(Int a, Int b) { return b - a < 0 ? a - b : b - a; }

constexpr bool seems_steep(ivec2 from, ivec2 to) { return gap(from.y, to.y) > gap(from.x, to.x); }

/// E and NE of a line whose leading axis ascends.
constexpr Moves ascending(ivec2 from, ivec2 to) {
  if (seems_steep(from, to)) return {{0, 1}, {from.x < to.x ? 1 : -1, 1}, false};
  return {{1, 0}, {1, from.y < to.y ? 1 : -1}, false};
}

/// FAULTY for long lines, and not in the order asked for: Bresenham's loop for all slopes with p in 32 bits
/// and the end points swapped so that the leading axis ascends.
/// The notes' second listing (errata E001-04, and the line entries of part 4). In C++ its int overflow is
/// undefined; here it wraps (Int).
///
/// from, to: any int32 coordinates. Pixels come in ascending order of the leading axis, whatever `from` is.
///
/// Domain: right, but for ties and the order, while |dx| and |dy| are below 2^30. Above, a value of p may not
///   fit into 32 bits, and one wrap is one wrong turn: (0,0)-(1500000000,200000000) takes (5,2) where the
///   line passes at 2/3. From 2^31 on dx itself does not fit: (-1500000000,-1)-(1500000000,1) turns aside at
///   its first step. (Where only the increments wrap, the sums come out right all the same: 2 dy = 2.4e9 on
///   the way to (1500000000,1200000000) does no harm.)
/// Steps: Started (Compared Stepped)* Finished
/// Accuracy: within 1/2 pixel while it is right. Midway it turns aside, seen along the ascending axis, so
///   that (0,0)-(2,1) takes (1,1) but (0,0)-(-2,-1) takes (-1,0).
/// Cost: as decision_parameter.
template <class Plot, Observer<Started, Compared, Stepped, Finished> O = Unobserved>
constexpr void swapped_ends(ivec2 from, ivec2 to, Plot&& plot, O&& observer = {}) {
  bool steep = seems_steep(from, to);
  const int lead = steep ? 1 : 0;
  const int side = steep ? 0 : 1;
  if (from[lead] > to[lead]) {
    std::swap(from, to);
  }
  Moves go = ascending(from, to);
  Int dx = Int(to[lead]) - from[lead];
  Int dy = gap(from[side], to[side]);
  Int p = 2 * dy - dx;
  const Int c1 = 2 * dy;
  const Int c2 = 2 * (dy - dx);
  if constexpr (observed<O>) observer(Started{from, to, +dx, +dy, +p, go});
  ivec2 pixel = from;
  plot(pixel);
  while (pixel[lead] < to[lead]) {
    if (p < 0) {
      if constexpr (observed<O>) observer(Compared{pixel, go, +p, true});
      pixel += go.straight;  // E
      p += c1;
      if constexpr (observed<O>) observer(Stepped{pixel - go.straight, pixel, +(p - c1), +p, true});
    } else {
      if constexpr (observed<O>) observer(Compared{pixel, go, +p, false});
      pixel += go.diagonal;  // NE
      p += c2;
      if constexpr (observed<O>) observer(Stepped{pixel - go.diagonal, pixel, +(p - c2), +p, false});
    }
    plot(pixel);
  }
  if constexpr (observed<O>) observer(Finished{Whole{to[lead]} - from[lead] + 1});
}

/// FAULTY: the loop of decision_parameter with the increments that follow from the notes' derivation as it is
/// printed: the new p is 4 dy - 2 dx after E (errata E001-01) and 4 dy - 4 dx after NE (E001-02), so that
/// 2 dy - dx and 2 dy - 3 dx were added to 2 dy - dx. Both are dx too small. (The notes' listings add the
/// right ones, 2 dy and 2 (dy - dx).)
///
/// from, to: any int32 coordinates up to 2^31 - 1 pixels apart along the leading axis.
///   Pixels come in order from `from`.
///
/// Domain: right for level lines and for two pixels only. p falls behind by dx a step, so a slope below 1/2
///   comes out level, and one above goes aside too seldom: (0,0)-(5,2) ends at (5,0), (0,0)-(5,3) at (5,1).
/// Steps: Started (Compared Stepped)* Finished
/// Accuracy: none: `to` itself is not reached.
/// Cost: as decision_parameter.
/// Errors: ContractViolation for longer lines: |p| goes up to dx^2 + dx.
template <class Plot, Observer<Started, Compared, Stepped, Finished> O = Unobserved>
constexpr void misprinted_derivation(ivec2 from, ivec2 to, Plot&& plot, O&& observer = {}) {
  auto [dx, dy] = extent(from, to);
  expects(dx <= INT32_MAX, "the misprinted line has at most 2^31 - 1 steps, not {}", dx);
  const Moves go = moves(from, to);
  Whole p = 2 * dy - dx;
  const Whole c1 = 2 * dy - dx;
  const Whole c2 = 2 * dy - 3 * dx;
  if constexpr (observed<O>) observer(Started{from, to, dx, dy, p, go});
  ivec2 pixel = from;
  plot(pixel);
  for (Whole k = 0; k < dx; ++k) {
    if (p < 0 || (p == 0 && go.tie)) {
      if constexpr (observed<O>) observer(Compared{pixel, go, p, true});
      pixel += go.straight;  // E
      p += c1;
      if constexpr (observed<O>) observer(Stepped{pixel - go.straight, pixel, p - c1, p, true});
    } else {
      if constexpr (observed<O>) observer(Compared{pixel, go, p, false});
      pixel += go.diagonal;  // NE
      p += c2;
      if constexpr (observed<O>) observer(Stepped{pixel - go.diagonal, pixel, p - c2, p, false});
    }
    plot(pixel);
  }
  if constexpr (observed<O>) observer(Finished{dx + 1});
}

}  // namespace gradus::bresenham_line
