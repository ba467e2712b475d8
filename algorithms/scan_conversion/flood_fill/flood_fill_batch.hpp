#pragma once
// Fills on plain memory. fill_rows does what fill_raster does, with a row as a pointer and the raster's edges
// as bounds of the loops instead of a question per cell. fill_by_labels looks at the whole raster, 64 cells
// at a time, and pays for no branch per cell. fill_area picks: a small area is not worth a look at the whole
// raster.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/raster.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "scan_conversion/flood_fill/run_labels.hpp"

namespace gradus::flood_fill {

/// Fills as fill_rows does for as long as goes_on(run) holds for each run that it has painted; nothing when
/// it stopped.
template <class Cell, class GoesOn>
std::optional<Filled> rows_while(GoesOn goes_on, Raster<Cell>& raster, ivec2 seed, const Cell& value,
                                 Connectivity connectivity) {
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
  if (!goes_on(first)) return std::nullopt;
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
      if (!goes_on(run)) return std::nullopt;
      waiting.push(run);
      if (run.left < s.left - 1 + reach) waiting.push(run.left_of(s));
      if (run.right > s.right + 1 - reach) waiting.push(run.right_of(s));
      x = run.right + 1;
    }
  }
  return tally(waiting, painted);
}

/// Gives every cell that is connected to the seed through cells of the seed's value a new value: the cells
/// and the count of fill_raster, and faster where runs are long.
/// P. S. Heckbert, A seed fill algorithm, Graphics Gems, 1990, 275-277.
///
/// seed: column, row. value: the new one; when it is the seed's own, nothing is painted.
///
/// Domain: any raster that fits into memory.
/// Accuracy: exactly the cells of fill_raster.
/// Cost: reads a cell at most a few times and writes it once; the stack is that of `span`, 16 bytes per
///   entry, at most 2 on an empty canvas.
/// Errors: ContractViolation when the seed lies outside the raster.
template <class Cell>
Filled fill_rows(Raster<Cell>& raster, ivec2 seed, const Cell& value,
                 Connectivity connectivity = Connectivity::four) {
  expects_inside(raster, seed);
  return *rows_while([](const Span&) { return true; }, raster, seed, value, connectivity);
}

/// The part of a word's runs that is wanted, a run for each set bit of `starts`. `run`: the number of the
/// first, counted on; `carry`: whether a wanted run goes on from the word before, or into the next.
template <class IsWanted>
Word wanted_runs(Word bits, Word starts, std::size_t& run, Word& carry, IsWanted is_wanted) {
  Word begun = 0;
  for (; starts != 0; starts &= starts - 1) {
    begun |= Word{is_wanted(run++)} << std::countr_zero(starts);
  }
  // A bit added to a run's first one is carried through to its end
  const Word some = bits + begun, sum = some + carry;
  carry = some < bits || sum < some;
  return bits & ~sum;
}

/// What fill_rows does, by labelling the runs of the whole raster first and painting those of the seed's set
/// afterwards: faster for areas that fill much of the raster or wind through it; a small
/// area costs as much as a large one.
///
/// raster, seed, value: as for fill_rows.
///
/// Domain: as fill_rows, with fewer than 2^32 - 1 runs of the seed's value.
/// Accuracy: exactly the cells of fill_raster.
/// Cost: two passes over the raster, 64 cells at a time, and some 15 ns for every overlap of two runs,
///   however they lie. Memory: a bit per cell and up to 8 bytes per run, counted as peak_bytes.
/// Errors: as fill_rows.
template <class Cell>
Filled fill_by_labels(Raster<Cell>& raster, ivec2 seed, const Cell& value,
                      Connectivity connectivity = Connectivity::four) {
  expects_inside(raster, seed);
  const Cell old = raster[seed];
  Filled filled;
  if (old == value) return filled;
  const Bitmap bitmap(raster, old);
  const RunLabels labels(bitmap, raster.height(), corners(connectivity));
  const Label wanted = labels.set_of(labels.run_at(bitmap, seed));
  const auto is_wanted = [&](std::size_t run) { return labels.set_of(run) == wanted; };
  for (int y = 0; y < raster.height(); ++y) {
    std::size_t run = labels.first_run(y);
    Word before = 0, carry = 0;
    std::span<Cell> rest = raster.row(y);
    for (const Word bits : bitmap.row(y)) {
      const Word painted = wanted_runs(bits, starts_of(bits, before), run, carry, is_wanted);
      const auto cells = rest.first(std::min<std::size_t>(word_bits, rest.size()));
      paint_bits(cells, painted, value);
      filled.painted += count_bits(painted);
      rest = rest.subspan(cells.size());
      before = bits;
    }
  }
  filled.peak_bytes = bitmap.bytes() + labels.bytes();
  return filled;
}

/// Areas of at most 1 / so many of a raster's cells are small.
inline constexpr Whole small_part = 32;

/// What fill_rows does, by the method that suits the area: by rows for as long as it may be small; an area
/// that turns out larger is cleared again and filled by labels.
///
/// raster, seed, value, Domain, Errors: as for fill_by_labels.
///
/// Accuracy: exactly the cells of fill_raster.
/// Cost: of a small area, that of fill_rows, however large the raster; else that of fill_by_labels and of
///   1/32 of the raster filled and cleared. Memory: 16 bytes per run of what was painted by rows, until then.
template <class Cell>
Filled fill_area(Raster<Cell>& raster, ivec2 seed, const Cell& value,
                 Connectivity connectivity = Connectivity::four) {
  expects_inside(raster, seed);
  const Cell old = raster[seed];
  const Whole most = Whole{raster.width()} * raster.height() / small_part;
  std::vector<Span> runs;
  Whole painted = 0;
  const auto is_small = [&](const Span& run) {
    runs.push_back(run);
    painted += run.length();
    return painted <= most;
  };
  if (const auto filled = rows_while(is_small, raster, seed, value, connectivity)) return *filled;
  for (const Span& run : runs) std::fill_n(&raster[{run.left, run.row}], run.length(), old);
  return fill_by_labels(raster, seed, value, connectivity);
}

}  // namespace gradus::flood_fill
