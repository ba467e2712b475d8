#pragma once
// The edges between faces: each once, with the sides of faces along it.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/faces.hpp"

namespace gradus::mesh_structures {

using Index = std::int32_t;
/// In the place of a face, edge or half-edge that there isn't.
inline constexpr Index none = -1;

/// A list with an entry for each vertex, edge, face or half-edge.
template <class T>
class ListOf {
 public:
  ListOf() = default;
  explicit ListOf(Index n, T value = {}) : all_(static_cast<std::size_t>(n), value) {}

  T& operator[](Index i) { return all_[static_cast<std::size_t>(i)]; }
  const T& operator[](Index i) const { return all_[static_cast<std::size_t>(i)]; }
  Index size() const { return static_cast<Index>(all_.size()); }
  void push_back(T value) { all_.push_back(std::move(value)); }
  auto begin() { return all_.begin(); }
  auto end() { return all_.end(); }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  T& back() { return all_.back(); }

  friend bool operator==(const ListOf&, const ListOf&) = default;

 private:
  std::vector<T> all_;
};

inline Index count_of(const Faces& faces) { return static_cast<Index>(faces.size()); }
inline std::span<const Index> ring_of(const Faces& faces, Index f) {
  return faces[static_cast<std::size_t>(f)];
}
inline bool has(std::span<const Index> ring, Index v) { return std::ranges::find(ring, v) != ring.end(); }

/// Whether a side leads from a to b or back.
inline bool has(std::span<const Index> ring, Index a, Index b) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Index p = ring[k], q = ring[(k + 1) % ring.size()];
    if ((p == a && q == b) || (p == b && q == a)) return true;
  }
  return false;
}

/// A side of a face, from a corner to the next.
struct Side {
  Index from, to;  ///< vertices
  Index face;
  Index corner;  ///< of all corners of all faces: where it begins

  std::pair<Index, Index> ends() const { return std::minmax(from, to); }
  friend bool operator==(const Side&, const Side&) = default;
};

/// The edges of a mesh in the order of their ends, each with the sides of faces along it.
class Edges {
 public:
  explicit Edges(const Faces& faces) : at_(static_cast<Index>(faces.corners.size())) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto ring = faces[f];
      for (std::size_t k = 0; k < ring.size(); ++k)
        sides_.push_back({ring[k], ring[(k + 1) % ring.size()], static_cast<Index>(f),
                          faces.first[f] + static_cast<Index>(k)});
    }
    std::ranges::sort(sides_, {}, [](const Side& s) { return std::pair(s.ends(), s.corner); });
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (i == 0 || sides_[i].ends() != sides_[i - 1].ends()) first_.push_back(i);
      at_[sides_[i].corner] = static_cast<Index>(first_.size()) - 1;
    }
    first_.push_back(sides_.size());
  }

  Index size() const { return static_cast<Index>(first_.size()) - 1; }
  std::span<const Side> operator[](Index e) const {
    const auto i = static_cast<std::size_t>(e);
    return std::span(sides_).subspan(first_[i], first_[i + 1] - first_[i]);
  }
  /// The edge of the side that begins at a corner.
  Index at(Index corner) const { return at_[corner]; }

 private:
  std::vector<Side> sides_{};
  std::vector<std::size_t> first_{};
  ListOf<Index> at_;
};

/// How the sides along an edge go together.
enum class Fit : std::uint8_t {
  boundary,  ///< one alone
  twins,     ///< two, in opposite directions
  same_way,  ///< two faces that are turned differently
  crowded,   ///< three or more faces: no surface
};
inline Fit fit_of(std::span<const Side> sides) {
  if (sides.size() == 1) return Fit::boundary;
  if (sides.size() > 2) return Fit::crowded;
  return sides[0].from == sides[1].to ? Fit::twins : Fit::same_way;
}

}  // namespace gradus::mesh_structures
