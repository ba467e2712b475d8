#pragma once
// Exhibit: the fill that calls itself. It paints the right pixels, and brings the program down on a canvas
// of a few hundred pixels a side. flood_fill.hpp's depth_first is the same search with a stack of its own.

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "scan_conversion/flood_fill/flood_fill.hpp"

namespace gradus::flood_fill {

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

/// What all calls of one fill share.
template <class Inside, class Paint, class O>
struct Recursion {
  Inside& inside;
  Paint& paint;
  Connectivity connectivity;
  Depth& depth;
  O& observer;
};

/// One call: paints the pixel, then calls itself for every neighbour.
template <class Inside, class Paint, class O>
void recursive_call(const Recursion<Inside, Paint, O>& all, ivec2 from, ivec2 pixel) {
  O& observer = all.observer;
  const bool free = all.inside(pixel);
  if constexpr (observed<O>) observer(Examined{from, pixel, free});
  if (!free) return;
  all.paint(pixel);
  all.depth.enter();
  if constexpr (observed<O>) observer(Painted{from, pixel, all.depth.open()});
  for (ivec2 way : ways(all.connectivity)) {
    recursive_call(all, pixel, pixel + way);
  }
  all.depth.leave();
  if constexpr (observed<O>) observer(Retreated{pixel, all.depth.open()});
}

/// FAULTY for large areas: every painted pixel keeps a call open until all that lies beyond it is painted,
/// so the machine's stack must hold as many calls as the longest path has pixels: 1,000,000 on an empty
/// canvas of 1000 x 1000 from a corner. The notes' first listing (errata E001-07), with the bounds checked
/// before the seed is read (E001-08). Its third test, for the new colour, could never fire and is left out.
///
/// Parameters and Accuracy: as for depth_first.
/// Domain: areas so small that the stack holds the calls. Measured with an empty canvas filled from its
///   corner on a stack of 8 MiB, the smallest square that crashes with GCC 12.2: 418 x 418 at -O2 and -O3 (48
///   bytes a call); at -O0 the notes' own listing crashes at 362 x 362 (64 bytes), this function at 274 x 274
///   (tests/unit/scan_conversion/recursion_limit_test.cpp).
/// Steps: Examined (Painted (Examined ...)* Retreated)?, nested as the calls are
/// Cost: the questions of depth_first; one call a question.
/// Errors: the program ends with a segmentation fault when the stack overflows.
template <class Inside, class Paint, Observer<Examined, Painted, Retreated> O = Unobserved>
Depth recursive(ivec2 seed, Inside&& inside, Paint&& paint, Connectivity connectivity = Connectivity::four,
                O&& observer = {}) {
  Depth depth;
  const Recursion all{inside, paint, connectivity, depth, observer};
  recursive_call(all, seed, seed);
  return depth;
}

}  // namespace gradus::flood_fill
