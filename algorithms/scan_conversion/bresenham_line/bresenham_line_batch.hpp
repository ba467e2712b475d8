#pragma once
// Lines for speed: the pixels of bresenham_line.hpp, found a run at a time and written straight into memory.

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/raster.hpp"
#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_window.hpp"

namespace gradus::bresenham_line {

/// What a line's lengths divided say of its runs: all but the first and the last have
/// `shortest` pixels, or one more.
struct Division {
  Whole shortest;  ///< dx / dy, rounded down; dx + 1 when dy is 0 (one run)
  Whole rest;      ///< by which a run is too short for the line, times 2 dy
};
constexpr Division divide(Whole dx, Whole dy) {
  if (dy == 0) return {dx + 1, 0};
  return {dx / dy, 2 * (dx % dy)};
}

/// The lengths are divided.
struct RunsStarted {
  ivec2 from, to;
  Whole dx, dy;
  Whole shortest;  ///< as in Division
};

/// A run was given out: `count` pixels in a straight line.
struct RunEmitted {
  ivec2 start;
  Moves moves;  ///< the run goes on by moves.straight; the next one starts moves.diagonal after its end
  Whole count;
};

/// A run to come: its first pixel and that one's number, the number of the first pixel after it, and what the
/// division that gave `next` left over (of 2 dy).
struct Run {
  ivec2 start;
  Whole k, next, rest;

  constexpr Whole pixels() const { return next - k; }
};

/// The run that pixel number k of a line lies in, from that pixel on. Domain: 0 <= k <= dx.
constexpr Run run_at(ivec2 from, ivec2 to, Whole k) {
  const auto [dx, dy] = extent(from, to);
  const Moves go = moves(from, to);
  if (dy == 0) return {place(from, go, k, 0), k, dx + 1, 0};
  // The line passes the middle of rows `row` and `row` + 1 at (2 row + 1) dx / (2 dy)
  if (k == 0) {
    const Whole passed = dx - !go.tie;
    return {from, 0, passed / (2 * dy) + 1, passed % (2 * dy)};
  }
  const Whole row = row_at({dx, dy}, go.tie, k);
  const int128_t passed = (2 * int128_t{row} + 1) * dx - !go.tie;
  return {place(from, go, k, row), k, static_cast<Whole>(passed / (2 * dy)) + 1,
          static_cast<Whole>(passed % (2 * dy))};
}

/// Where the next run starts: after all pixels of this one, and one aside.
constexpr ivec2 after(const Run& run, const Moves& go) { return place(run.start, go, run.pixels(), 1); }

/// Pixels number first .. last of a line as runs. Domain: 0 <= first <= last <= dx.
template <class Emit, Observer<RunsStarted, RunEmitted, Finished> O>
constexpr void emit_runs(ivec2 from, ivec2 to, Stretch shown, Emit& emit, O& observer) {
  auto [dx, dy] = extent(from, to);
  const Moves go = moves(from, to);
  // dx / dy pixels or one more each
  Division each = divide(dx, dy);
  if constexpr (observed<O>) observer(RunsStarted{from, to, dx, dy, each.shortest});
  auto [k, last] = shown;
  auto run = run_at(from, to, k);
  while (run.next <= last) {
    emit(run.start, run.pixels());
    if constexpr (observed<O>) observer(RunEmitted{run.start, go, run.pixels()});
    run.start = after(run, go);
    run.k = run.next;
    run.next += each.shortest;
    // One more if the rest fills up
    run.rest += each.rest;
    if (run.rest >= 2 * dy) {
      ++run.next;
      run.rest -= 2 * dy;
    }
  }
  // The last run stops at the end
  run.next = last + 1;
  emit(run.start, run.pixels());
  if constexpr (observed<O>) observer(RunEmitted{run.start, go, run.pixels()});
  if constexpr (observed<O>) observer(Finished{last - k + 1});
}

/// Gives out a line as runs of pixels along its leading axis, in order from `from` to `to`: the same pixels
/// as decision_parameter. Every run but the first and the last has dx / dy pixels, rounded down or up, so
/// that one division finds them all.
/// J. E. Bresenham, Run length slice algorithm for incremental lines, in: Fundamental algorithms for
/// computer graphics, 1985, 59-104.
///
/// from, to: any int32 coordinates. run(ivec2 start, std::int64_t count) is called once per run; its pixels
///   are start + i * moves(from, to).straight for 0 <= i < count.
///
/// Domain: everything; from == to gives one run of one pixel.
/// Steps: RunsStarted RunEmitted+ Finished
/// Accuracy: exactly the pixels of decision_parameter.
/// Cost: two divisions, then O(1) per run; min(|dx|, |dy|) + 1 runs.
template <class EmitRun, Observer<RunsStarted, RunEmitted, Finished> O = Unobserved>
constexpr void run_length(ivec2 from, ivec2 to, EmitRun&& run, O&& observer = {}) {
  emit_runs(from, to, {0, extent(from, to).dx}, run, observer);
}

/// The runs of the part of the line that lies in a window: exactly the pixels of in_window.
///
/// Domain: everything; a line that misses the window gives no run and no step.
/// Steps: (RunsStarted RunEmitted+ Finished)?
/// Cost: O(runs shown), at most the smaller side of the window; a few 128-bit divisions.
template <class EmitRun, Observer<RunsStarted, RunEmitted, Finished> O = Unobserved>
constexpr void run_length_in_window(ivec2 from, ivec2 to, const Window& window, EmitRun&& run,
                                    O&& observer = {}) {
  const Stretch shown = visible(from, to, window);
  if (shown.first <= shown.last) emit_runs(from, to, shown, run, observer);
}

/// Where a line stands in memory.
template <class Cell>
struct Pen {
  Cell* cell;
  Whole p;  ///< decision_parameter's value there, less 1 where a tie goes straight: straight when < 0
};

/// On pixel number k of the line. Domain: it lies in the raster.
template <class Cell>
Pen<Cell> pen_at(Raster<Cell>& raster, ivec2 from, ivec2 to, Whole k) {
  const auto [dx, dy] = extent(from, to);
  const Whole tie = moves(from, to).tie ? 1 : 0;
  if (k == 0) return {&raster[from], 2 * dy - dx - tie};  // nothing has to be divided
  return {&raster[pixel_at(from, to, k)], decision_at(from, to, k) - tie};
}

/// Draws a line into a raster: gives `value` to the cells of decision_parameter that lie in it.
///
/// Domain: any int32 end points; what lies outside the raster is not drawn.
/// Accuracy: exactly the pixels of in_window.
/// Cost: O(width + height) of the raster at most, however long the line; 128-bit divisions only when it is
///   cut. The pixel in the middle may be written twice.
template <class Cell>
void draw(Raster<Cell>& raster, ivec2 from, ivec2 to, const Cell& value) {
  const Cell ink = value;
  const auto [dx, dy] = extent(from, to);
  Stretch shown{0, dx};
  if (!raster.contains(from) || !raster.contains(to)) {
    shown = visible(from, to, raster.window());
    if (shown.empty()) return;
  }
  // Long runs within a row: whole runs at once
  constexpr Whole long_run = 8;
  const Moves go = moves(from, to);
  if (go.straight.y == 0 && dx >= long_run * dy) {
    const bool right = go.straight.x > 0;
    Unobserved nobody;
    auto fill = [&](ivec2 first, Whole count) {
      Cell* cell = &raster[first];
      std::fill_n(right ? cell : cell - (count - 1), count, ink);
    };
    emit_runs(from, to, shown, fill, nobody);
    return;
  }
  // Else pixel by pixel, from both ends at once: two chains of decisions that don't wait for each other.
  // (Ties go by place, so the way back has the same pixels.)
  const std::ptrdiff_t width = raster.width();
  const std::ptrdiff_t straight = go.straight.x + go.straight.y * width;
  const std::ptrdiff_t diagonal = go.diagonal.x + go.diagonal.y * width;
  auto [there, p] = pen_at(raster, from, to, shown.first);
  auto [back, q] = pen_at(raster, to, from, dx - shown.last);
  *there = *back = ink;
  for (Whole left = (shown.last - shown.first) / 2; left > 0; --left) {
    there += p < 0 ? straight : diagonal;
    p += p < 0 ? 2 * dy : 2 * (dy - dx);
    back -= q < 0 ? straight : diagonal;
    q += q < 0 ? 2 * dy : 2 * (dy - dx);
    *there = *back = ink;
  }
}

/// Draws many lines, in order. Cost: the sum of the lines'.
template <class Cell>
void draw(Raster<Cell>& raster, std::span<const Segment<2, int>> segments, const Cell& value) {
  for (const auto& [a, b] : segments) draw(raster, a, b, value);
}

}  // namespace gradus::bresenham_line
