#pragma once
// Triangles of a mesh that lie over one another in one plane, as a face given twice does or a decal on its
// wall: which of them is seen is no matter of rounding.

#include <array>
#include <span>
#include <vector>

#include "core/geometry.hpp"

namespace gradus::pipeline {

/// Vertices of a mesh.
using Triple = std::array<int, 3>;

/// Which triangles of a mesh share a plane.
struct SharedPlanes {
  static constexpr int none = -1;

  std::vector<Triple> planes;  ///< of each three vertices of its triangles that lie far apart
  std::vector<int> of;         ///< of each triangle the number of its plane, or none
};

/// Finds the planes in which triangles lie over one another.
/// Source: planes are compared by their coordinates modulo a prime (R. M. Karp, M. O. Rabin, Efficient
/// randomized pattern-matching algorithms, 1987), then by orient3d.
///
/// positions: of a mesh. triangles: their corners in it.
///
/// Domain: finite coordinates.
/// Accuracy: exact: two triangles share a plane if it holds the corners of both, and if the inside of each
///   meets that of some other there. Where finding that out takes too long, as for thousands of slivers round
///   one corner, all triangles of the plane share it. One without area shares none.
/// Cost: some 0.2 us per triangle, and a test for each that it may meet.
/// Errors: none.
SharedPlanes shared_planes(std::span<const dvec3> positions, std::span<const Triple> triangles);

}  // namespace gradus::pipeline
