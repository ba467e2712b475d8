#pragma once
// The same questions asked of a list of faces, which knows no neighbours: it is searched.

#include "core/observe.hpp"
#include "modeling/mesh_structures/edges.hpp"

namespace gradus::mesh_structures {

/// A face was searched for a vertex, or for both ends of an edge.
struct Searched {
  Index face;
  bool found;
};

/// Steps: Searched for each face.
/// Cost: all corners of all faces.
template <class Take, Observer<Searched> O = Unobserved>
void search_faces_at(const Faces& faces, Index v, Take&& take, O&& observer = {}) {
  const Index n = count_of(faces);
  for (Index f = 0; f < n; ++f) {
    auto ring = ring_of(faces, f);
    const bool found = has(ring, v);
    if (found) {
      take(f);
    }
    if constexpr (observed<O>) observer(Searched{f, found});
  }
}

/// Steps: Searched for each face up to the one that is found.
/// Cost: all corners of these.
template <Observer<Searched> O = Unobserved>
Index search_face_across(const Faces& faces, Index a, Index b, Index f, O&& observer = {}) {
  const Index n = count_of(faces);
  for (Index g = 0; g < n; ++g) {
    if (g == f) continue;
    auto ring = ring_of(faces, g);
    bool found = has(ring, a, b);
    if constexpr (observed<O>) observer(Searched{g, found});
    if (found) return g;
  }
  return none;
}

}  // namespace gradus::mesh_structures
