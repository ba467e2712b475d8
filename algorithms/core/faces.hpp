#pragma once
// The faces of a surface, each a ring of numbers of vertices: what all algorithms on meshes take and give.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/contract.hpp"

namespace gradus {

/// Rings of vertex numbers, from 0, one behind the other: face f has corners[first[f]] to before
/// corners[first[f + 1]], counter-clockwise seen from outside.
struct Faces {
  std::vector<std::int32_t> first{0};
  std::vector<std::int32_t> corners{};

  std::size_t size() const { return first.size() - 1; }
  bool empty() const { return size() == 0; }
  std::span<const std::int32_t> operator[](std::size_t f) const {
    const auto begin = static_cast<std::size_t>(first[f]), end = static_cast<std::size_t>(first[f + 1]);
    return std::span(corners).subspan(begin, end - begin);
  }
  void add(std::span<const std::int32_t> ring) {
    corners.insert(corners.end(), ring.begin(), ring.end());
    first.push_back(static_cast<std::int32_t>(corners.size()));
  }

  friend bool operator==(const Faces&, const Faces&) = default;
};

/// Faces from lists: faces_of({{0, 1, 2}, {2, 1, 3}}).
inline Faces faces_of(const std::vector<std::vector<std::int32_t>>& rings) {
  Faces faces;
  for (const auto& ring : rings) faces.add(ring);
  return faces;
}

/// Refuses faces that no surface of so many vertices has: fewer than three corners, a number of no vertex,
/// one vertex twice in a face.
/// Errors: ContractViolation that names face and vertex.
/// Cost: linear in the corners, but for faces of many corners, which are compared in pairs.
inline void expect_faces(const Faces& faces, std::size_t vertices) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto ring = faces[f];
    expects(ring.size() >= 3, "a face has at least 3 corners, but face {} has {}", f, ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      expects(ring[i] >= 0 && static_cast<std::size_t>(ring[i]) < vertices,
              "face {} names vertex {}, but there are {}", f, ring[i], vertices);
      for (std::size_t k = 0; k < i; ++k)
        expects(ring[i] != ring[k], "face {} has vertex {} twice", f, ring[i]);
    }
  }
}

}  // namespace gradus
