#pragma once
// The part of a line that a window shows, as decision_parameter plots it: found by jumping to the pixel where
// the line enters, however far off it begins.

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>

#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "scan_conversion/bresenham_line/bresenham_line.hpp"

namespace gradus::bresenham_line {

__extension__ typedef __int128 int128_t;

// --- Any pixel of a line, without the ones before it -------------

/// Pixel numbers first .. last of a line; `from` has number 0. Empty when last < first.
struct Stretch {
  Whole first = 0, last = -1;

  constexpr bool empty() const { return last < first; }
};

/// a / b rounded down. Domain: b > 0.
constexpr int128_t floor_quotient(int128_t a, int128_t b) { return a / b - (a % b < 0); }

/// How many pixels aside pixel number k lies: k dy / dx, rounded to the nearest, midway by the rule for ties.
/// Domain: 0 <= k <= dx.
constexpr Whole row_at(Extent size, bool tie_straight, Whole k) {
  if (size.dx == 0) return 0;
  const int128_t twice = 2 * int128_t{k} * size.dy;
  const int128_t row = tie_straight ? -floor_quotient(size.dx - twice, 2 * int128_t{size.dx})
                                    : floor_quotient(size.dx + twice, 2 * int128_t{size.dx});
  return static_cast<Whole>(row);
}

/// The number of the first pixel that lies `row` pixels aside or more: the inverse of row_at. 0
/// when all do, dx + 1 when none does.
constexpr Whole first_in_row(Extent size, bool tie_straight, Whole row) {
  if (row <= 0) return 0;
  if (row > size.dy) return size.dx + 1;
  const int128_t a = (2 * int128_t{row} - 1) * size.dx, b = 2 * int128_t{size.dy};
  return static_cast<Whole>(tie_straight ? floor_quotient(a, b) + 1 : -floor_quotient(-a, b));
}

/// Pixel number k of the line from `from` to `to`, the one that decision_parameter plots after k steps.
///
/// Domain: 0 <= k < pixel_count(from, to).
/// Accuracy: exact, for all int32 end points.
/// Cost: O(1), one 128-bit division.
/// Errors: ContractViolation when k is not the number of a pixel.
constexpr ivec2 pixel_at(ivec2 from, ivec2 to, Whole k) {
  const Extent size = extent(from, to);
  expects(0 <= k && k <= size.dx, "this line has pixels 0 to {}, there is no pixel {}", size.dx, k);
  const Moves go = moves(from, to);
  return place(from, go, k, row_at(size, go.tie, k));
}

/// The value of p that the test after pixel k reads, 2 (k + 1) dy - (2 row + 1) dx; |p| < 2^33.
/// Domain: 0 <= k <= dx.
constexpr Whole decision_at(ivec2 from, ivec2 to, Whole k) {
  const Extent size = extent(from, to);
  const bool tie_straight = moves(from, to).tie;
  const int128_t row = row_at(size, tie_straight, k);
  return static_cast<Whole>(2 * (int128_t{k} + 1) * size.dy - (2 * row + 1) * size.dx);
}

// --- The part in a window ----------------------------------------

/// Which pixels of a line lie in a window: always one unbroken stretch, for the
/// pixels go one way in x and in y.
///
/// Domain: everything; an empty window or a line that misses it gives an empty stretch.
/// Accuracy: exact, for all int32 end points and windows.
/// Cost: O(1), two 128-bit divisions and their remainders.
constexpr Stretch visible(ivec2 from, ivec2 to, const Window& window) {
  if (window.empty()) return {};
  const Extent size = extent(from, to);
  const Moves go = moves(from, to);
  // How far the window reaches from `from`, counted in the direction of the line.
  const bool right = from.x <= to.x, up = from.y <= to.y;
  const Stretch x = right ? Stretch{Whole{window.lower.x} - from.x, Whole{window.upper.x} - from.x}
                          : Stretch{Whole{from.x} - window.upper.x, Whole{from.x} - window.lower.x};
  const Stretch y = up ? Stretch{Whole{window.lower.y} - from.y, Whole{window.upper.y} - from.y}
                       : Stretch{Whole{from.y} - window.upper.y, Whole{from.y} - window.lower.y};
  const Stretch along = steep(from, to) ? y : x;
  const Stretch rows = steep(from, to) ? x : y;
  const Whole enters = first_in_row(size, go.tie, rows.first);
  const Whole leaves = first_in_row(size, go.tie, rows.last + 1);
  return {std::max({Whole{0}, along.first, enters}), std::min({size.dx, along.last, leaves - 1})};
}

/// The part of a line that a window shows.
struct Part {
  ivec2 from, to;
  Stretch shown;  ///< numbers of its pixels

  constexpr Part(ivec2 a, ivec2 b, const Window& window) : from(a), to(b), shown(visible(a, b, window)) {}
  constexpr ivec2 pixel(Whole k) const { return pixel_at(from, to, k); }
  constexpr Whole decision(Whole k) const { return decision_at(from, to, k); }
};

/// The line is known to enter the window at pixel `first` and to leave it after pixel `last`.
struct Jumped {
  Stretch shown;  ///< numbers of the first and the last pixel in the window
  ivec2 pixel;    ///< the first of them, about to be plotted
  Whole p;        ///< the value for the next test
};

/// Draws the part of a line that lies in a window: the very pixels that decision_parameter plots there,
/// in the same order, found by jumping to the first of them. (Clipping the end points and drawing the
/// shorter line would give another line: its slope is rounded.)
///
/// from, to: any int32 coordinates. window: any, both corners included; nothing outside it is ever plotted.
///
/// Domain: everything; a line that misses the window plots nothing.
/// Steps: Started (Jumped (Compared Stepped)*)? Finished; Jumped when the window shows any pixel.
/// Accuracy: exact, for all int32 end points and windows.
/// Cost: O(window width + height), however long the line is; eight 128-bit divisions at most.
/// Errors: none.
template <class Plot, Observer<Started, Jumped, Compared, Stepped, Finished> O = Unobserved>
constexpr void in_window(ivec2 from, ivec2 to, const Window& window, Plot&& plot, O&& observer = {}) {
  auto [dx, dy] = extent(from, to);
  const Moves go = moves(from, to);
  const auto& [E, NE, tie] = go;
  if constexpr (observed<O>) observer(Started{from, to, dx, dy, 2 * dy - dx, go});
  const Part part(from, to, window);
  const Stretch in = part.shown;
  if (in.empty()) {
    if constexpr (observed<O>) observer(Finished{0});
    return;
  }
  // Jump to the first pixel in it
  Whole k = in.first;
  ivec2 pixel = part.pixel(k);
  Whole p = part.decision(k);
  if constexpr (observed<O>) observer(Jumped{in, pixel, p});
  plot(pixel);
  while (k++ < in.last) {
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
  if constexpr (observed<O>) observer(Finished{in.last - in.first + 1});
}

}  // namespace gradus::bresenham_line
