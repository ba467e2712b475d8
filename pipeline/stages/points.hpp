#pragma once
// What goes from stage to stage. Every stage has a point type of its own, so that none can be skipped by
// accident, and everything carries the number of the object and the face it comes from.

#include <array>
#include <compare>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"

namespace gradus::pipeline {

/// In an object's own space, as its file has it.
struct ObjectPoint {
  dvec3 at{0};
};
/// In the space all objects, lights and the camera share; right-handed.
struct WorldPoint {
  dvec3 at{0};
};
/// After the perspective transformation: -w <= x, y <= w and 0 <= z <= w is what the picture shows.
struct ClipPoint {
  glm::dvec4 at{0};
};
/// After the division: x and y in [-1, 1] with y up, z in [0, 1].
struct NdcPoint {
  dvec3 at{0};
};
/// In the picture: (0, 0) is the upper left corner, pixel (c, r) covers [c, c + 1) x [r, r + 1).
struct PixelPoint {
  dvec2 at{0};
};
/// In the picture, in 1/256 pixel.
struct SnappedPoint {
  ivec2 at{0};
};

/// Pixels of a picture, 1 to 2^15 per side.
struct Size {
  int width = 800, height = 600;

  constexpr double ratio() const { return static_cast<double>(width) / height; }
};

/// Which vertex of which object.
struct VertexId {
  int object = 0, vertex = 0;

  friend constexpr auto operator<=>(const VertexId&, const VertexId&) = default;
};

/// Which face of which object, and which of the triangles that the face was cut into.
struct PieceId {
  int object = 0, face = 0, piece = 0;

  friend constexpr auto operator<=>(const PieceId&, const PieceId&) = default;
};

/// A vertex of a stage.
template <class Point>
struct Vertex {
  VertexId id;
  Point point;
};

/// A corner of a piece: which vertex of the stage, and the normal and the texture coordinates it has in this
/// face.
struct PieceCorner {
  int vertex = 0;       ///< place in Model::vertices
  dvec3 normal{0};      ///< of length 1 or zero; object space in stage 1, then world space
  dvec2 texture{0, 0};  ///< v up
};

/// The plane of a piece that shares it with no other.
inline constexpr int no_plane = -1;

/// A triangle, counter-clockwise seen from outside.
struct Piece {
  PieceId id;
  std::array<PieceCorner, 3> corners;
  bool seen_from_behind = false;  ///< stage 4: a two-sided piece that shows its back
  int plane = no_plane;           ///< place in Model::planes
};

/// The vertices and pieces of all objects, as stages 1 to 4 hand them on.
template <class Point>
struct Model {
  std::vector<Vertex<Point>> vertices;
  std::vector<Piece> pieces;
  std::vector<std::array<int, 3>> planes{};  ///< that pieces share: three of their vertices

  const Point& point(const PieceCorner& corner) const {
    return vertices[static_cast<std::size_t>(corner.vertex)].point;
  }
  void add(VertexId id, const Point& point) { vertices.push_back({id, point}); }
};

/// The pieces go on to the next stage; `from` is left without.
template <class From, class To>
void hand_on_pieces(Model<From>& from, Model<To>& to) {
  to.pieces = std::move(from.pieces);
  to.planes = std::move(from.planes);
}

/// How many there are, as the numbers of vertices, faces and triangles count.
template <class T>
int size_of(const std::vector<T>& list) {
  return static_cast<int>(list.size());
}

/// Adds all of `more` at the end.
template <class T>
void append(std::vector<T>& list, const std::vector<T>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

/// A corner of a triangle that was clipped and divided.
struct TriangleCorner {
  NdcPoint ndc;
  double over_w = 1;  ///< 1 / w, for what is linear on the surface
  WorldPoint world;
  dvec3 normal{0};  ///< world space, on the viewer's side
  dvec2 texture{0, 0};
};

/// What stage 5 leaves of a piece: one triangle, or several with the same id.
struct Triangle {
  PieceId id;
  std::array<TriangleCorner, 3> corners;
  bool seen_from_behind = false;
  int plane = no_plane;                                  ///< of its piece: a number of its object's
  std::optional<triangle_coverage::DepthPlane> depth{};  ///< of that plane, where the triangle has its depths
};

using Triangles = std::vector<Triangle>;

/// A pixel covered by a triangle. What the surface has there is the mean of what the triangle's corners have,
/// with these weights.
struct Fragment {
  PieceId id;
  int triangle = 0;  ///< place in the list of triangles
  ivec2 pixel{0};
  double depth = 0;  ///< z after division, in [0, 1]
  dvec3 weights{0};  ///< perspective-correct, of the triangle's three corners; they add up to 1
};

/// The triangle that covers a fragment.
inline const Triangle& triangle_of(const Fragment& f, const Triangles& triangles) {
  return triangles[static_cast<std::size_t>(f.triangle)];
}

}  // namespace gradus::pipeline
