#pragma once
// What is right of others' triangles: the points, round by round.

#include "stories/checking.hpp"

namespace gradus::b_spline {

inline const Checking& checking() {
  static const Checking known{
      .asked = {{.name = "points", .same = SameList::order, .type = "Mixed", .fields = {"x", "y"}}}};
  return known;
}

}  // namespace gradus::b_spline
