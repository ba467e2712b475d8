#pragma once
// Whether the faces of a mesh can be turned so that neighbours agree, found by spreading from face to face.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <queue>
#include <vector>

#include "core/faces.hpp"
#include "core/observe.hpp"
#include "modeling/mesh_structures/edges.hpp"

namespace gradus::mesh_structures {

// --- Steps -------------------------------------------------------

/// A face without neighbours that are turned already: it stays as it is.
struct Seeded {
  Index face;
};
/// What an edge asks of the face beyond it.
enum class Outcome : std::uint8_t {
  reached,    ///< that face is turned so
  agrees,     ///< it was already
  conflicts,  ///< it was turned the other way
  crowded,    ///< there is more than one
};
struct Demanded {
  Index edge;
  Index from, to;  ///< faces
  bool turned;     ///< whether the face beyond must be
  Outcome outcome;
};

// --- The method --------------------------------------------------

/// For each face whether its corners must be reversed: 1, 0, or none while that is not known.
using Turns = ListOf<Index>;

struct Orientation {
  Turns turned;
  Index pieces;  ///< of faces that hang together by edges
};

/// The way over an edge from one face to another.
struct Way {
  Index edge;
  Index face;   ///< beyond it
  bool same;    ///< both run along the edge in one direction
  Index sides;  ///< of faces along the edge
};

/// The ways between the faces of a mesh, each taken once.
class Ways {
 public:
  explicit Ways(const Faces& faces) : faces_(faces), edges_(faces), taken_(edges_.size()) {}

  /// Those from a face that were not taken yet.
  std::vector<Way> from(Index f) {
    std::vector<Way> ways;
    const auto i = static_cast<std::size_t>(f);
    for (Index c = faces_.first[i]; c < faces_.first[i + 1]; ++c) {
      const Index e = edges_.at(c);
      const auto sides = edges_[e];
      if (sides.size() == 1 || taken_[e]) continue;
      taken_[e] = 1;
      const bool first = sides[0].corner == c;
      ways.push_back(
          {e, sides[first ? 1 : 0].face, sides[0].from == sides[1].from, static_cast<Index>(sides.size())});
    }
    return ways;
  }

 private:
  const Faces& faces_;
  const Edges edges_;
  ListOf<char> taken_;
};

inline Demanded demanded(Index from, const Way& way, Index must, Outcome outcome) {
  return {way.edge, from, way.face, must == 1, outcome};
}

/// Turns the faces that hang together with the first one; says whether they can be turned.
/// Steps: Seeded, Demanded for each edge between two of them; the last one may be conflicts or crowded.
template <Observer<Seeded, Demanded> O = Unobserved>
bool spread(Ways& ways, Index seed, Turns& turn, O&& observer = {}) {
  turn[seed] = 0;
  if constexpr (observed<O>) observer(Seeded{seed});
  std::queue<Index> queue({seed});
  while (!queue.empty()) {
    const Index f = queue.front();
    queue.pop();
    for (Way w : ways.from(f)) {
      const Index g = w.face;
      // Same way along it: turn one
      auto must = turn[f] ^ w.same;
      if (w.sides > 2) {
        if constexpr (observed<O>) observer(demanded(f, w, must, Outcome::crowded));
        return false;
      }
      if (turn[g] == none) {
        turn[g] = must;
        queue.push(g);
        if constexpr (observed<O>) observer(demanded(f, w, must, Outcome::reached));
      } else if (turn[g] == must) {
        if constexpr (observed<O>) observer(demanded(f, w, must, Outcome::agrees));
      } else {
        // Two demands meet here
        if constexpr (observed<O>) observer(demanded(f, w, must, Outcome::conflicts));
        return false;
      }
    }
  }
  return true;
}

/// Turns faces so that neighbours run along their edge in opposite directions, spreading from the first face
/// of each piece; nothing where that can't be.
/// Source: the definition of orientable; the order is that of a search in breadth.
///
/// faces: numbers of vertices, either way round. vertices: how many there are.
///
/// Domain: as for half_edges.
/// Steps: those of spread, for each piece; after conflicts or crowded none.
/// Accuracy: exact: whether there is an answer depends on no order of faces or corners.
/// Cost: O(n log n) for n corners, for sorting; the spreading is linear.
/// Errors: ContractViolation outside the domain.
template <Observer<Seeded, Demanded> O = Unobserved>
std::optional<Orientation> orientation(const Faces& faces, std::size_t vertices, O&& observer = {}) {
  expect_faces(faces, vertices);
  const auto n = static_cast<Index>(faces.size());
  Ways ways(faces);
  Orientation found{Turns(n, none), 0};
  for (Index f = 0; f < n; ++f) {
    if (found.turned[f] != none) continue;
    if (!spread(ways, f, found.turned, observer)) return {};
    ++found.pieces;
  }
  return found;
}

/// The faces, those turned that must be.
inline Faces turned_faces(const Faces& faces, const Turns& turned) {
  Faces result;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<Index> ring(faces[f].begin(), faces[f].end());
    if (turned[static_cast<Index>(f)] == 1) std::ranges::reverse(ring);
    result.add(ring);
  }
  return result;
}

}  // namespace gradus::mesh_structures
