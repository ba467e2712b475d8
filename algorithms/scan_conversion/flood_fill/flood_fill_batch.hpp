#pragma once
// The span fill on plain memory: what fill_raster does, with a row as a pointer and the raster's edges as
// bounds of the loops instead of a question a cell.

#include <algorithm>
#include <cstdint>

#include "core/raster.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"

namespace gradus::flood_fill {

/// Gives every cell that is connected to the seed through cells of the seed's value a new value: the cells
/// and the count of fill_raster, and faster where runs are long.
/// P. S. Heckbert, A seed fill algorithm, Graphics Gems, 1990, 275-277.
///
/// seed: column, row. value: the new one; when it is the seed's own, nothing is painted.
///
/// Domain: any raster that fits into memory.
/// Accuracy: exactly the cells of fill_raster.
/// Cost: reads a cell at most a few times and writes it once; the stack is that of `span`, 16 bytes an
///   entry, at most 2 on an empty canvas.
/// Errors: ContractViolation when the seed lies outside the raster.
template <class Cell>
Filled fill_rows(Raster<Cell>& raster, ivec2 seed, const Cell& value,
                 Connectivity connectivity = Connectivity::four) {
  expects(raster.contains(seed),
          "the seed {},{} lies outside the {} x {} cells (columns 0 to {}, rows 0 to {})", seed.x, seed.y,
          raster.width(), raster.height(), raster.width() - 1, raster.height() - 1);
  const Cell old = raster[seed], ink = value;
  const int reach = corners(connectivity), end = raster.width() - 1;
  Stack<Span> waiting;
  std::int64_t painted = 0;
  if (old == ink) return tally(waiting, painted);

  // Paints the run that row[x] belongs to, and gives its ends
  const auto paint_run_at = [&](Cell* row, int y, int x, int way) {
    int left = x, right = x;
    while (left > 0 && row[left - 1] == old) --left;
    while (right < end && row[right + 1] == old) ++right;
    if (left == right) {  // a call would be dearer
      row[left] = ink;
    } else {
      std::fill(row + left, row + right + 1, ink);
    }
    painted += right - left + 1;
    return Span{y, left, right, way};
  };

  const Span first = paint_run_at(raster.row(seed.y).data(), seed.y, seed.x, 1);
  waiting.push(first.turned());
  waiting.push(first);
  while (!waiting.empty()) {
    const Span s = waiting.take();
    const int y = s.row + s.way;
    if (y < 0 || y >= raster.height()) continue;
    Cell* const row = raster.row(y).data();
    const int last = std::min(s.right + reach, end);
    for (int x = std::max(s.left - reach, 0); x <= last; ++x) {
      if (!(row[x] == old)) continue;
      const Span run = paint_run_at(row, y, x, s.way);
      waiting.push(run);
      if (run.left < s.left - 1 + reach) waiting.push(run.left_of(s));
      if (run.right > s.right + 1 - reach) waiting.push(run.right_of(s));
      x = run.right + 1;
    }
  }
  return tally(waiting, painted);
}

}  // namespace gradus::flood_fill
