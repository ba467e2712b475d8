#pragma once
// What is right of others' answers: where the nodes are, in the tree's order.

#include "stories/checking.hpp"

namespace gradus::csg_tree {

inline const Checking& checking() {
  static const Checking known{.asked = {{.name = "lengths",
                                         .same = SameList::order,
                                         .type = "NodeMerged",
                                         .fields = {"length"},
                                         .method = "along_ray"},
                                        {.name = "sides",
                                         .same = SameList::order,
                                         .type = "LeafTested",
                                         .fields = {"side"},
                                         .method = "membership"}}};
  return known;
}

}  // namespace gradus::csg_tree
