#pragma once
// What a drawing shows over all its steps: a paper is cut to it, and an arrangement is chosen for it.

#include <cstdint>
#include <limits>
#include <vector>

#include "core/geometry.hpp"

namespace gradus {

struct Trace;

/// In the coordinates of the drawing's grid.
struct Content {
  /// A rectangle, without any point in it until one is added.
  struct Part {
    dvec2 lower{std::numeric_limits<double>::max()}, upper{std::numeric_limits<double>::lowest()};
    void add(dvec2 p) {
      lower = glm::min(lower, p);
      upper = glm::max(upper, p);
    }
    bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y); }
    dvec2 size() const { return empty() ? dvec2{0} : upper - lower; }
  };
  /// A text's place and how far it reaches from there, in units of a slide.
  struct TextRoom {
    dvec2 at;
    double left, right, up, down;
    bool aside = false;  ///< as the text
  };

  Part all;   ///< marks, cells and the places of texts
  Part bare;  ///< all but what is aside
  Part core;  ///< what it is about: without guides, tinted areas and texts
  std::vector<TextRoom> texts;
};

/// Of the recorded steps and what stands behind them.
Content content_of(const Trace& trace);

/// Entries of a legend, the i-th as the i-th bit.
using LegendEntries = std::uint64_t;

}  // namespace gradus
