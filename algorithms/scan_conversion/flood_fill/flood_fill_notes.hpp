#pragma once
// Exhibits: two fills of lecture notes. One calls itself: it paints the right pixels, and brings the program
// down on a canvas of a few hundred pixels a side. The other reads the seed without a look at the borders.
// flood_fill.hpp's depth_first and breadth_first are the same searches without these faults.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/raster.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"

namespace gradus::flood_fill {

// --- A call for every pixel --------------------------------------

/// How deep the calls of a recursive fill went.
struct Depth {
  std::int64_t painted = 0;
  std::int64_t now = 0;   ///< calls open
  std::int64_t peak = 0;  ///< most calls open at once

  void enter() {
    ++painted;
    peak = std::max(peak, ++now);
  }
  void leave() { --now; }
  std::size_t open() const { return static_cast<std::size_t>(now); }
};

/// What all calls of one fill share: the area, and how deep they are in it.
template <class Inside, class Paint>
struct Area {
  Inside& inside;
  Paint& paint;
  std::span<const ivec2> moves;  ///< to a pixel's neighbours
  Depth depth{};
};

/// The seed's call has returned.
struct Returned {
  Depth depth;
};

/// FAULTY for large areas: every painted pixel keeps a call open until all that lies beyond it is painted,
/// so the machine's stack must hold as many calls as the longest path has pixels: 1,000,000 on an empty
/// canvas of 1000 x 1000 from a corner. The notes' first listing (errata E001-07), with the bounds checked
/// before the seed is read (E001-08). Its third test, for the new colour, could never fire and is left out.
///
/// Parameters and Accuracy: as for depth_first.
/// Domain: areas so small that the stack holds the calls. Measured with an empty canvas filled from its
///   corner on a stack of 8 MiB, the smallest square that crashes with GCC 12.2: 418 x 418 at -O2 and -O3 (48
///   bytes a call); at -O0 the notes' own listing crashes at 362 x 362 (64 bytes), this function at 256 x 256
///   (tests/unit/scan_conversion/recursion_limit_test.cpp).
/// Steps: Started (Examined (Painted (Examined ...)* Retreated)?)? Returned, nested as the calls are;
///   Painted.waiting and Retreated.waiting are the calls open
/// Cost: the questions of depth_first, and the seed's twice; one call a question.
/// Errors: the program ends with a segmentation fault when the stack overflows.
template <class Inside, class Paint, Observer<Started, Examined, Painted, Retreated, Returned> O = Unobserved>
Depth recursive(ivec2 seed, Inside&& inside, Paint&& paint, Connectivity connectivity = Connectivity::four,
                O&& observer = {}) {
  auto moves = ways(connectivity);
  Area area{inside, paint, moves};
  const bool free = inside(seed);
  if constexpr (observed<O>) observer(Started{seed, connectivity, free});
  if (free) {
    recurse(area, seed, seed, observer);
  }
  if constexpr (observed<O>) observer(Returned{area.depth});
  return area.depth;
}

/// One call: paints the pixel, then calls itself for every neighbour.
template <class Inside, class Paint, class O>
void recurse(Area<Inside, Paint>& area, ivec2 from, ivec2 pixel, O& observer) {
  bool free = area.inside(pixel);
  if constexpr (observed<O>) observer(Examined{from, pixel, free});
  if (!free) return;
  area.paint(pixel);
  area.depth.enter();
  if constexpr (observed<O>) observer(Painted{from, pixel, area.depth.open()});
  // This call stays open meanwhile
  for (ivec2 move : area.moves) {
    const ivec2 next = pixel + move;
    recurse(area, pixel, next, observer);
  }
  area.depth.leave();
  if constexpr (observed<O>) observer(Retreated{pixel, area.depth.open()});
}

// --- A seed that nobody looks at ---------------------------------

/// The number of a cell in memory, row by row. Outside the raster it is that of another cell, or of none.
template <class Cell>
constexpr std::int64_t row_major(const Raster<Cell>& raster, ivec2 p) {
  return std::int64_t{p.y} * raster.width() + p.x;
}

/// The cell of this number; nothing where the memory ends.
template <class Cell>
constexpr std::optional<ivec2> cell_at(const Raster<Cell>& raster, std::int64_t index) {
  if (index < 0 || index >= std::int64_t{raster.width()} * raster.height()) return std::nullopt;
  return ivec2{static_cast<int>(index % raster.width()), static_cast<int>(index / raster.width())};
}

/// The cell that is read at a pixel's address, wherever the pixel is.
template <class Cell>
constexpr std::optional<ivec2> memory_at(const Raster<Cell>& raster, ivec2 p) {
  return cell_at(raster, row_major(raster, p));
}

/// The cells of a raster that hold a value.
template <class Cell>
struct Region {
  const Raster<Cell>& raster;
  Cell value;
  constexpr bool has(ivec2 p) const { return raster.contains(p) && raster[p] == value; }
};

/// The seed is about to be read, wherever in memory it is.
struct SeedRead {
  ivec2 seed;
  std::int64_t index;  ///< its number in memory
  /// The cell there: the seed if it is in the raster; nothing outside the memory.
  std::optional<ivec2> lands;
};

/// FAULTY for a seed outside the raster: its neighbours are looked at before they are read, the seed itself
/// is not. In a memory of rows without gaps such a seed is a cell of another row, which is painted, and the
/// fill goes on round the seed where that cell's value is found again.
/// The notes' second listing (errata E001-08). In C++ what it does then is undefined; here it does what the
/// addresses say, and nothing outside the memory.
///
/// raster, value: as for fill_raster. seed: column, row; any that is two cells away from the ends of int32.
///
/// Returns what was done; nothing where the seed's address is not in the raster's memory.
///
/// Domain: right for seeds in the raster.
/// Steps: SeedRead ((Painted (Dequeued (Examined Painted?)*)*)? Finished)?
/// Accuracy: that of breadth_first for a seed in the raster.
/// Cost: as breadth_first.
/// Errors: ContractViolation for a seed at the ends of int32.
template <class Cell, Observer<SeedRead, Painted, Dequeued, Examined, Finished> O = Unobserved>
std::optional<Filled> unchecked_seed(Raster<Cell>& raster, ivec2 seed, const Cell& value,
                                     Connectivity connectivity = Connectivity::four, O&& observer = {}) {
  expects(room.contains(seed), "a seed stays two cells away from the ends of int32, unlike {},{}", seed.x,
          seed.y);
  // Read without asking where it is
  auto cell = memory_at(raster, seed);
  if constexpr (observed<O>) observer(SeedRead{seed, row_major(raster, seed), cell});
  if (!cell) return std::nullopt;
  const Cell old = raster[*cell];
  const Region region{raster, old};
  auto moves = ways(connectivity);
  Queue<ivec2> waiting;
  if (old != value) {
    raster[*cell] = value;
    waiting.push(seed);
    if constexpr (observed<O>) observer(Painted{seed, seed, waiting.size()});
  }
  while (!waiting.empty()) {
    ivec2 pixel = waiting.take();
    if constexpr (observed<O>) observer(Dequeued{pixel, waiting.size()});
    // Only neighbours are looked at
    for (ivec2 move : moves) {
      const ivec2 next = pixel + move;
      bool free = region.has(next);
      if constexpr (observed<O>) observer(Examined{pixel, next, free});
      if (!free) continue;
      raster[next] = value;
      waiting.push(next);
      if constexpr (observed<O>) observer(Painted{pixel, next, waiting.size()});
    }
  }
  if constexpr (observed<O>) observer(Finished{tally(waiting)});
  return tally(waiting);
}

}  // namespace gradus::flood_fill
