#pragma once
// Names beside the points of a chart, however close to each other those lie.

#include <span>
#include <vector>

#include "figure/layout/layout.hpp"

namespace gradus::plot {

/// A point to name.
struct NamedPoint {
  dvec2 at;
  double reach;  ///< of its marker
  dvec2 size;    ///< of its name
};

/// A place for each name: beside its point, or with a leader. They are placed one after the other, in the
/// order, of some at random, that leaves all of them the nearest to their points. In the room no name lies on
/// a marker (around.taken) or another name while there is place.
std::vector<layout::PlacedLabel> place_names(std::span<const NamedPoint> points,
                                             const layout::Obstacles& around, const Box& room, double scale);

}  // namespace gradus::plot
