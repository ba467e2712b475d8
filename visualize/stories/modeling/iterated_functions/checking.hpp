#pragma once
// What is right of others' pieces: where corner A of each is, in any order, and how many a level has.

#include "stories/checking.hpp"

namespace gradus::iterated_functions {

inline const Checking& checking() {
  static const Checking known{.asked = {{.name = "images",
                                         .same = SameList::set,
                                         .type = "Mapped",
                                         .fields = {"x", "y"},
                                         .method = "deterministic"},
                                        {.name = "pieces",
                                         .same = SameList::order,
                                         .type = "LevelDone",
                                         .fields = {"pieces"},
                                         .method = "deterministic"}}};
  return known;
}

}  // namespace gradus::iterated_functions
