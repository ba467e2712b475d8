#pragma once
// What is asked of others besides the point: both tangents and the normal, and of a mesh how many points its
// rows have.

#include "stories/checking.hpp"

namespace gradus::parametric_surface {

inline const Checking& checking() {
  const auto vector = [](const char* name, const char* type, const char* method) {
    return Asked{
        .name = name, .same = SameList::order, .type = type, .fields = {"x", "y", "z"}, .method = method};
  };
  static const Checking known{.asked = {vector("by_s", "AlongParallel", "point"),
                                        vector("by_t", "AlongMeridian", "point"),
                                        vector("normal", "NormalFound", "point"),
                                        vector("normal", "FaceNormalTaken", "lookup"),
                                        {.name = "rows",
                                         .same = SameList::order,
                                         .type = "RowMade",
                                         .fields = {"points"},
                                         .method = "patches"}}};
  return known;
}

}  // namespace gradus::parametric_surface
