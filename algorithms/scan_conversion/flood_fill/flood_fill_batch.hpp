#pragma once
// Fills on plain memory. fill_rows does what fill_raster does, with a row as a pointer and the raster's edges
// as bounds of the loops instead of a question per cell. fill_by_labels looks at the whole raster, 64 cells
// at a time, and pays for no branch per cell. fill_area picks: an area of few runs is not worth a look at the
// whole raster.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/raster.hpp"
#include "scan_conversion/flood_fill/bitmap.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "scan_conversion/flood_fill/row_search.hpp"
#include "scan_conversion/flood_fill/run_labels.hpp"

namespace gradus::flood_fill {

/// Fills as fill_rows does for as long as goes_on(run) holds for each run that it has painted; nothing when
/// it stopped.
template <class Cell, class GoesOn>
std::optional<Filled> rows_while(GoesOn goes_on, Raster<Cell>& raster, ivec2 seed, const Cell& value,
                                 Connectivity connectivity) {
  const Cell old = raster[seed], ink = value;
  const int reach = corners(connectivity), width = raster.width();
  Stack<Span> waiting;
  std::int64_t painted = 0;
  if (old == ink) return tally(waiting, painted);

  // Paints the run that row[x] belongs to, and gives its ends
  const auto paint_run_at = [&](Cell* row, int y, int x, int way) {
    const bool goes_left = x > 0 && row[x - 1] == old;
    const int left = goes_left ? run_start(row, x - 1, old) : x;
    const int right = first_other(row, x + 1, width, old) - 1;
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
    const int end = std::min(s.right + reach, width - 1) + 1;
    int x = std::max(s.left - reach, 0);
    while ((x = first_equal(row, x, end, old)) < end) {
      const Span run = paint_run_at(row, y, x, s.way);
      if (!goes_on(run)) return std::nullopt;
      waiting.push(run);
      if (run.left < s.left - 1 + reach) waiting.push(run.left_of(s));
      if (run.right > s.right + 1 - reach) waiting.push(run.right_of(s));
      if (run.right + 1 >= end) break;
      x = run.right + 2;
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

/// fill_by_labels, of the value `old`. reach: as RunLabels has it.
template <int reach, class Cell>
Filled fill_labelled(Raster<Cell>& raster, ivec2 seed, const Cell& old, const Cell& ink) {
  Bitmap bitmap(raster.width(), raster.height());
  RunLabels<reach> labels(bitmap.words());
  for (int y = 0; y < raster.height(); ++y) {
    bitmap.read(y, std::span<const Cell>(raster.row(y)), old);
    labels.add(bitmap.row(y - 1), bitmap.row(y));
    if (y == seed.y) labels.want(seed.x);
  }
  labels.settle();
  Filled filled;
  for (int y = 0; y < raster.height(); ++y) {
    const auto wanted = labels.next_wanted(bitmap.row(y - 1), bitmap.row(y));
    filled.painted += paint_bits(raster.row(y), wanted, ink);
  }
  filled.peak_bytes = bitmap.bytes() + labels.bytes();
  return filled;
}

/// What fill_rows does, by labelling the runs of the whole raster first and painting those of the seed's set
/// afterwards: faster for areas that fill much of the raster in short runs or wind through it; a small
/// area costs as much as a large one.
///
/// raster, seed, value: as for fill_rows.
///
/// Domain: as fill_rows, with fewer than 2^31 runs of the seed's value.
/// Accuracy: exactly the cells of fill_raster.
/// Cost: two passes over the raster, 64 cells at a time, and some ns for every run and every touch of two
///   runs, however they lie. Memory: a bit per cell, 4 bytes per run that touches none above it and some
///   rows, counted as peak_bytes.
/// Errors: as fill_rows.
template <class Cell>
Filled fill_by_labels(Raster<Cell>& raster, ivec2 seed, const Cell& value,
                      Connectivity connectivity = Connectivity::four) {
  expects_inside(raster, seed);
  const Cell old = raster[seed], ink = value;
  if (old == ink) return {};
  return connectivity == Connectivity::four ? fill_labelled<0>(raster, seed, old, ink)
                                            : fill_labelled<1>(raster, seed, old, ink);
}

/// An area of at most one run per so many cells of the raster has few runs.
inline constexpr std::size_t cells_per_run = 256;

/// What fill_rows does, by the method that suits the area: by rows for as long as it has few runs, because it
/// is small or its runs are long; an area that turns out otherwise is cleared again and filled by labels.
///
/// raster, seed, value, Domain, Errors: as for fill_by_labels.
///
/// Accuracy: exactly the cells of fill_raster.
/// Cost: of an area of few runs, that of fill_rows, however large the raster; else that of fill_by_labels and
///   of few runs filled and cleared. Memory: 16 bytes per run of what was painted by rows, until then.
template <class Cell>
Filled fill_area(Raster<Cell>& raster, ivec2 seed, const Cell& value,
                 Connectivity connectivity = Connectivity::four) {
  expects_inside(raster, seed);
  const Cell old = raster[seed], ink = value;
  const auto most =
      static_cast<std::size_t>(raster.width()) * static_cast<std::size_t>(raster.height()) / cells_per_run;
  std::vector<Span> runs;
  const auto are_few = [&](const Span& run) {
    runs.push_back(run);
    return runs.size() <= most;
  };
  if (const auto filled = rows_while(are_few, raster, seed, ink, connectivity)) return *filled;
  for (const Span& run : runs) std::fill_n(&raster[{run.left, run.row}], run.length(), old);
  return fill_by_labels(raster, seed, ink, connectivity);
}

}  // namespace gradus::flood_fill
