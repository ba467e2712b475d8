#pragma once
// Winged edges from half-edges, and the same questions asked of them: each edge knows both faces and its
// neighbours round them.

#include <algorithm>

#include "core/observe.hpp"
#include "modeling/mesh_structures/mesh_structures.hpp"

namespace gradus::mesh_structures {

/// An edge, the faces on both sides, and its four wings: the edges before and behind it round each.
struct WingedEdge {
  Index from, to;
  Index left, right;  ///< the face on the right is none along a boundary
  Index left_before, left_next, right_before, right_next;
};

struct WingedEdges {
  ListOf<WingedEdge> all{};
  ListOf<Index> of_face{};  ///< an edge of each face
  Fans fans{};              ///< an edge at a vertex for each of the fans that meet there

  const WingedEdge& operator[](Index e) const { return all[e]; }
};

// --- Steps -------------------------------------------------------

/// Round a vertex, from edge to edge.
struct WingTurned {
  Index edge, next;
  Index face;
  bool round;
};
struct WingFollowed {
  Index edge, next;
  bool round;
};
struct WingCrossed {
  Index edge, face;
};

// --- Building ----------------------------------------------------

/// Winged edges: each pair of half-edges becomes one, in the order of their ends.
/// Source: B. G. Baumgart, A polyhedron representation for computer vision, 1975.
/// Cost: O(n log n); eight numbers for each edge.
inline WingedEdges winged_edges(const HalfEdges& mesh) {
  ListOf<Index> lefts, edge(mesh.size());
  for (Index h = 0; h < mesh.size(); ++h) {
    if (h < mesh[h].twin) lefts.push_back(h);
  }
  const auto ends = [&](Index h) { return Side{mesh[h].from, mesh.to(h), none, none}.ends(); };
  std::ranges::sort(lefts, {}, ends);
  for (Index e = 0; e < lefts.size(); ++e) edge[lefts[e]] = edge[mesh[lefts[e]].twin] = e;
  WingedEdges winged;
  for (const Index h : lefts) {
    const HalfEdge &left = mesh[h], &right = mesh[left.twin];
    winged.all.push_back({left.from, right.from, left.face, right.face, edge[left.before], edge[left.next],
                          edge[right.before], edge[right.next]});
  }
  for (const Index h : mesh.of_face) winged.of_face.push_back(edge[h]);
  winged.fans = mesh.fans;
  for (Index& h : winged.fans.all) h = edge[h];
  return winged;
}

// --- Questions ---------------------------------------------------

/// Steps: WingTurned for each edge at the vertex.
/// Cost: one record for each, and a look at which end it has there.
template <class Take, Observer<WingTurned> O = Unobserved>
void winged_faces_at(const WingedEdges& mesh, Index v, Take&& take, O&& observer = {}) {
  for (Index start : mesh.fans[v]) {
    Index e = start;
    do {
      const WingedEdge& w = mesh[e];
      Index f = w.left;
      Index next = w.right_next;
      // Or does it end at v?
      if (w.to == v) {
        f = w.right;
        next = w.left_next;
      }
      if (f != none) {
        take(f);
      }
      if constexpr (observed<O>) observer(WingTurned{e, next, f, next == start});
      e = next;
    } while (e != start);
  }
}

/// Steps: WingFollowed for each edge of the face.
/// Cost: one record for each.
template <class Take, Observer<WingFollowed> O = Unobserved>
void winged_edges_round(const WingedEdges& mesh, Index f, Take&& take, O&& observer = {}) {
  Index start = mesh.of_face[f];
  Index e = start;
  do {
    take(e);
    const WingedEdge& w = mesh[e];
    Index next = w.left_next;
    if (w.right == f) {
      next = w.right_next;
    }
    if constexpr (observed<O>) observer(WingFollowed{e, next, next == start});
    e = next;
  } while (e != start);
}

/// Steps: WingCrossed.
/// Cost: one record.
template <Observer<WingCrossed> O = Unobserved>
Index winged_face_across(const WingedEdges& mesh, Index e, Index f, O&& observer = {}) {
  const WingedEdge& w = mesh[e];
  Index face = w.right;
  if (face == f) {
    face = w.left;
  }
  if constexpr (observed<O>) observer(WingCrossed{e, face});
  return face;
}

}  // namespace gradus::mesh_structures
