#pragma once
// Half-edges from lists of faces, and what is asked of them: a walk by next and twin goes round a face, a
// vertex or a boundary. winged_edge.hpp and face_vertex.hpp answer the same questions.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/faces.hpp"
#include "core/observe.hpp"
#include "modeling/mesh_structures/edges.hpp"

namespace gradus::mesh_structures {

// --- The structures ----------------------------------------------

struct HalfEdge {
  Index from;           ///< the vertex where it begins
  Index face = none;    ///< on its left; none along a boundary
  Index next = none;    ///< round its face, or along its boundary
  Index before = none;  ///< the other way round
  Index twin = none;    ///< back along the same edge

  friend bool operator==(const HalfEdge&, const HalfEdge&) = default;
};

/// Lists of each vertex, one behind the other.
struct Fans {
  std::vector<Index> first{}, all{};

  std::span<const Index> operator[](Index v) const {
    const auto i = static_cast<std::size_t>(v);
    const auto begin = static_cast<std::size_t>(first[i]);
    return std::span(all).subspan(begin, static_cast<std::size_t>(first[i + 1]) - begin);
  }
};

/// Half-edge i begins at corner i of the faces; behind these come those along boundaries.
struct HalfEdges {
  ListOf<HalfEdge> all{};
  ListOf<Index> of_face{};  ///< one of each face
  ListOf<Index> loops{};    ///< one of each boundary
  Fans fans{};              ///< one that leaves a vertex for each of the fans that meet there

  const HalfEdge& operator[](Index h) const { return all[h]; }
  HalfEdge& operator[](Index h) { return all[h]; }
  Index size() const { return all.size(); }
  Index to(Index h) const { return (*this)[(*this)[h].twin].from; }
};

// --- Steps -------------------------------------------------------

/// A face has its half-edges.
struct FacePlaced {
  Index face;
  Index first;  ///< half-edge
};

/// An edge was looked at: its sides are twins, or one gets a twin along the boundary, or there is no way on.
struct EdgeJoined {
  Index edge;
  std::vector<Side> sides;
  Fit fit;
};

/// The half-edges along a boundary are linked.
struct LoopClosed {
  Index first, count;
};

/// Round a vertex: from a half-edge to its twin, and on to the next.
struct Turned {
  Index half, twin, next;
  Index face;  ///< of the first
  bool round;  ///< the next is the one that it began with
};
/// Round a face or along a boundary.
struct Followed {
  Index half, next;
  bool round;
};
/// Over an edge.
struct Crossed {
  Index half, twin, face;
};

// --- Building ----------------------------------------------------

inline void place(HalfEdges& mesh, const Faces& faces, Index face) {
  const auto ring = ring_of(faces, face);
  const Index first = mesh.size(), n = static_cast<Index>(ring.size());
  mesh.of_face.push_back(first);
  for (Index k = 0; k < n; ++k)
    mesh.all.push_back(
        {ring[static_cast<std::size_t>(k)], face, first + (k + 1) % n, first + (k + n - 1) % n});
}

inline void make_twins(HalfEdges& mesh, Index a, Index b) {
  mesh[a].twin = b;
  mesh[b].twin = a;
}

inline void pair_up(HalfEdges& mesh, std::span<const Side> sides) {
  make_twins(mesh, sides[0].corner, sides[1].corner);
}

/// A half-edge outside, along a side that has no other.
inline void add_outside(HalfEdges& mesh, const Side& side) {
  mesh.all.push_back({side.to});
  make_twins(mesh, side.corner, mesh.size() - 1);
}

/// Along a boundary the next half-edge leaves the vertex at the other end of the fan of faces.
inline void link_outside(HalfEdges& mesh, Index h) {
  Index next = mesh[mesh[h].twin].before;
  while (mesh[mesh[next].twin].face != none) next = mesh[mesh[next].twin].before;
  mesh[h].next = mesh[next].twin;
  mesh[mesh[next].twin].before = h;
}

/// Links those outside, and gives one of each boundary.
inline std::vector<Index> link(HalfEdges& mesh, Index outside) {
  for (Index h = outside; h < mesh.size(); ++h) link_outside(mesh, h);
  ListOf<char> seen(mesh.size());
  std::vector<Index> loops;
  for (Index h = outside; h < mesh.size(); ++h) {
    if (seen[h]) continue;
    loops.push_back(h);
    for (Index k = h; !seen[k]; k = mesh[k].next) seen[k] = 1;
  }
  return loops;
}

inline Index length_of_loop(const HalfEdges& mesh, Index start) {
  Index count = 1;
  for (Index h = mesh[start].next; h != start; h = mesh[h].next) ++count;
  return count;
}

/// One of those that leave each vertex for each turn round it that next and twin make.
inline void find_fans(HalfEdges& mesh, std::size_t vertices) {
  Fans fans{std::vector<Index>(vertices + 1, 0)};
  ListOf<char> seen(mesh.size());
  std::vector<Index> starts;
  for (Index h = 0; h < mesh.size(); ++h) {
    if (seen[h]) continue;
    starts.push_back(h);
    ++fans.first[static_cast<std::size_t>(mesh[h].from) + 1];
    for (Index k = h; !seen[k]; k = mesh[mesh[k].twin].next) seen[k] = 1;
  }
  std::partial_sum(fans.first.begin(), fans.first.end(), fans.first.begin());
  std::ranges::sort(starts, {}, [&](Index h) { return std::pair(mesh[h].from, h); });
  fans.all = std::move(starts);
  mesh.fans = std::move(fans);
}

/// Half-edges from faces; nothing where an edge has more than two faces, or two that run along it the same
/// way: the last step names it. Vertices where several fans meet keep one half-edge for each.
/// Source: K. Weiler, Edge-based data structures for solid modeling in curved-surface environments, 1985.
///
/// faces: numbers of vertices, counter-clockwise. vertices: how many there are; some may be in no face.
///
/// Domain: what expect_faces takes: three corners and more, each vertex once in a face.
/// Steps: FacePlaced for each face, EdgeJoined for each edge, LoopClosed for each boundary; after an
/// EdgeJoined
///   that is same_way or crowded none.
/// Accuracy: none needed: numbers of things alone. Answers are the same sets for every order of the faces.
/// Cost: O(n log n) for n corners, for sorting their sides; five numbers for each half-edge.
/// Errors: ContractViolation outside the domain.
template <Observer<FacePlaced, EdgeJoined, LoopClosed> O = Unobserved>
std::optional<HalfEdges> half_edges(const Faces& faces, std::size_t vertices, O&& observer = {}) {
  expect_faces(faces, vertices);
  HalfEdges mesh;
  // One for each side of a face
  const Index n = count_of(faces);
  for (Index f = 0; f < n; ++f) {
    place(mesh, faces, f);
    if constexpr (observed<O>) observer(FacePlaced{f, mesh.of_face.back()});
  }
  const Index inside = mesh.size();
  // Along an edge they are twins
  const Edges edges(faces);
  const Index m = edges.size();
  for (Index e = 0; e < m; ++e) {
    auto sides = edges[e];
    const Fit fit = fit_of(sides);
    if (fit == Fit::boundary) {
      add_outside(mesh, sides[0]);
      if constexpr (observed<O>) observer(EdgeJoined{e, {sides.begin(), sides.end()}, fit});
    } else if (fit == Fit::twins) {
      pair_up(mesh, sides);
      if constexpr (observed<O>) observer(EdgeJoined{e, {sides.begin(), sides.end()}, fit});
    } else {
      // No two that are twins
      if constexpr (observed<O>) observer(EdgeJoined{e, {sides.begin(), sides.end()}, fit});
      return {};
    }
  }
  // Those outside are boundaries
  auto loops = link(mesh, inside);
  for (Index h : loops) {
    mesh.loops.push_back(h);
    if constexpr (observed<O>) observer(LoopClosed{h, length_of_loop(mesh, h)});
  }
  find_fans(mesh, vertices);
  return mesh;
}

/// One of the fans at a vertex, the first, if there is one.
inline std::span<const Index> one(const HalfEdges& mesh, Index v) {
  return mesh.fans[v].first(std::min<std::size_t>(1, mesh.fans[v].size()));
}

// --- Questions to half-edges -------------------------------------

/// The faces at a vertex: take(face) for each, once.
/// Steps: Turned for each half-edge that leaves the vertex.
/// Cost: two records for each edge there, whatever the size of the mesh.
template <class Take, Observer<Turned> O = Unobserved>
void faces_at(const HalfEdges& mesh, Index v, Take&& take, O&& observer = {}) {
  // A pinched vertex has several
  for (Index start : mesh.fans[v]) {
    Index h = start;
    do {
      Index f = mesh[h].face;
      if (f != none) take(f);
      Index twin = mesh[h].twin;
      Index next = mesh[twin].next;
      if constexpr (observed<O>) observer(Turned{h, twin, next, f, next == start});
      h = next;
    } while (h != start);
  }
}

/// The half-edges round a face or along a boundary: take(half-edge) for each, from one of them on.
/// Steps: Followed for each.
/// Cost: one record for each.
template <class Take, Observer<Followed> O = Unobserved>
void edges_round(const HalfEdges& mesh, Index start, Take&& take, O&& observer = {}) {
  Index h = start;
  do {
    take(h);
    const Index next = mesh[h].next;
    if constexpr (observed<O>) observer(Followed{h, next, next == start});
    h = next;
  } while (h != start);
}

/// The face beyond an edge, seen from the one on the left of its half-edge; none beyond a boundary.
/// Steps: Crossed.
/// Cost: two records.
template <Observer<Crossed> O = Unobserved>
Index face_across(const HalfEdges& mesh, Index h, O&& observer = {}) {
  const Index twin = mesh[h].twin;
  Index face = mesh[twin].face;
  if constexpr (observed<O>) observer(Crossed{h, twin, face});
  return face;
}

}  // namespace gradus::mesh_structures
