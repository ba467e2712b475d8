#pragma once
// FILL IN: what this topic is about, in a few sentences. Until then: a walk from one pixel to another, first
// along x, then along y.

#include <cstdint>
#include <glm/vec2.hpp>

#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::new_topic {

// --- Steps -------------------------------------------------------

// FILL IN: small types that own their data, each named for what has just happened.

/// `from` is about to be plotted.
struct Started {
  ivec2 from, to;
};

/// The walk stands on its next pixel, which is about to be plotted.
struct Stepped {
  ivec2 pixel;
  bool column_reached;  ///< what was tested: the pixel before lies in the column of the end
};

/// The end is reached.
struct Finished {
  std::int64_t pixels;  ///< how many were plotted
};

/// How many pixels a walk visits: what only a report tells is no variable of the method.
constexpr std::int64_t pixels_of(ivec2 from, ivec2 to) {
  const auto apart = [](std::int64_t a, std::int64_t b) { return a < b ? b - a : a - b; };
  return apart(from.x, to.x) + apart(from.y, to.y) + 1;
}

// --- The taught method -------------------------------------------

/// FILL IN: what it does; then author, title, year and page of the source.
///
/// from, to: any int32 coordinates. plot(ivec2) is called once per pixel, in order from `from` to `to`, both
///   included.
///
/// Domain: everything; from == to gives one pixel.
/// Steps: Started Stepped* Finished; Stepped once for every pixel but the first.
/// Accuracy: exact. FILL IN: the bound that the promise in tests/stress holds it to.
/// Cost: |dx| + |dy| steps of two comparisons and an addition; no memory.
/// Errors: none.
template <class Plot, Observer<Started, Stepped, Finished> O = Unobserved>
constexpr void walk(ivec2 from, ivec2 to, Plot&& plot, O&& observer = {}) {
  ivec2 p = from;
  if constexpr (observed<O>) observer(Started{from, to});
  plot(p);
  while (p != to) {
    // First to the end's column
    if (p.x != to.x) {
      p.x += p.x < to.x ? 1 : -1;
      if constexpr (observed<O>) observer(Stepped{p, false});
    } else {
      p.y += p.y < to.y ? 1 : -1;
      if constexpr (observed<O>) observer(Stepped{p, true});
    }
    plot(p);
  }
  if constexpr (observed<O>) observer(Finished{pixels_of(from, to)});
}

}  // namespace gradus::new_topic
