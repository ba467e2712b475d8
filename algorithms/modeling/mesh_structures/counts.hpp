#pragma once
// What can be counted in any faces: the Euler number, boundaries, pieces, pinched vertices.

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/faces.hpp"
#include "modeling/mesh_structures/edges.hpp"

namespace gradus::mesh_structures {

struct Counts {
  Index vertices = 0, edges = 0, faces = 0;
  Index boundary_edges = 0, crowded_edges = 0;
  Index loops = 0;                  ///< boundaries; none where an edge is crowded
  Index pieces = 0;                 ///< that hang together by vertices; a vertex in no face is one
  Index isolated = 0, pinched = 0;  ///< vertices in no face, and such where several fans meet

  /// V - E + F.
  Index euler() const { return vertices - edges + faces; }
  friend bool operator==(const Counts&, const Counts&) = default;
};

/// Sets that are joined.
class Joined {
 public:
  explicit Joined(Index n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) { parent_[root(a)] = root(b); }
  bool is_root(Index i) const { return parent_[i] == i; }
  Index sets() const {
    Index count = 0;
    for (Index i = 0; i < parent_.size(); ++i) count += is_root(i);
    return count;
  }

 private:
  ListOf<Index> parent_;
};

/// The corner of the same face behind each.
inline ListOf<Index> corners_behind(const Faces& faces) {
  ListOf<Index> behind;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Index begin = faces.first[f], end = faces.first[f + 1];
    for (Index c = begin; c < end; ++c) behind.push_back(c + 1 < end ? c + 1 : begin);
  }
  return behind;
}

/// What can be counted in any faces, whichever way they are turned.
/// Domain: as for half_edges; edges may have any number of faces.
/// Accuracy: exact, and the same for every order of the faces.
/// Cost: O(n log n) for n corners.
/// Errors: ContractViolation outside the domain.
inline Counts counts_of(const Faces& faces, std::size_t vertices) {
  expect_faces(faces, vertices);
  const Edges edges(faces);
  const auto n = static_cast<Index>(vertices), corners = static_cast<Index>(faces.corners.size());
  Counts counts{n, edges.size(), static_cast<Index>(faces.size())};
  // Corners at a vertex belong together where their faces share an edge there
  Joined piece(n), fan(corners), loop(edges.size());
  const auto behind = corners_behind(faces);
  const auto corner = [&](const Side& s, Index v) { return s.from == v ? s.corner : behind[s.corner]; };
  for (Index e = 0; e < edges.size(); ++e) {
    const auto sides = edges[e];
    piece.join(sides[0].from, sides[0].to);
    counts.boundary_edges += sides.size() == 1;
    counts.crowded_edges += sides.size() > 2;
    for (const Side& other : sides.subspan(1)) {
      for (const Index v : {other.from, other.to}) fan.join(corner(sides[0], v), corner(other, v));
    }
  }
  // Two edges of a boundary that end at one fan follow each other
  ListOf<Index> edge_at(corners, none), fans(n);
  for (Index e = 0; e < edges.size(); ++e) {
    if (edges[e].size() > 1) continue;
    for (const Index v : {edges[e][0].from, edges[e][0].to}) {
      Index& first = edge_at[fan.root(corner(edges[e][0], v))];
      if (first == none) first = e;
      loop.join(first, e);
    }
  }
  for (Index c = 0; c < corners; ++c) fans[faces.corners[static_cast<std::size_t>(c)]] += fan.is_root(c);
  // Each edge inside is a set of its own
  counts.loops = counts.crowded_edges > 0 ? none : loop.sets() - edges.size() + counts.boundary_edges;
  counts.pieces = piece.sets();
  counts.isolated = static_cast<Index>(std::ranges::count(fans, 0));
  counts.pinched = static_cast<Index>(std::ranges::count_if(fans, [](Index k) { return k > 1; }));
  return counts;
}

}  // namespace gradus::mesh_structures
