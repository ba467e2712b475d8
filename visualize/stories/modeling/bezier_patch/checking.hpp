#pragma once
// What is asked of others: the points that the rows leave, in their order.

#include "stories/checking.hpp"

namespace gradus::bezier_patch {

inline const Checking& checking() {
  static const Checking known{
      .asked = {
          {.name = "points", .same = SameList::order, .type = "RowReduced", .fields = {"x", "y", "z"}}}};
  return known;
}

}  // namespace gradus::bezier_patch
