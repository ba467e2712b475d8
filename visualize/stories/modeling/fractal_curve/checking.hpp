#pragma once
// What is right of others' Koch curves: the tips in their order, and the segments of each level.

#include "stories/checking.hpp"

namespace gradus::fractal_curve {

inline const Checking& checking() {
  static const Checking known{.asked = {{.name = "tips",
                                         .same = SameList::order,
                                         .type = "Replaced",
                                         .fields = {"x", "y"},
                                         .method = "koch"},
                                        {.name = "segments",
                                         .same = SameList::order,
                                         .type = "LevelDone",
                                         .fields = {"segments"},
                                         .method = "koch"}}};
  return known;
}

}  // namespace gradus::fractal_curve
