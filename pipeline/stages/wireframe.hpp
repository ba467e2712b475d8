#pragma once
// Wireframe: in place of stage 5's triangles the edges of faces, each as a bar one pixel wide, so that
// rasterization and every antialiasing method draw them as they draw all else.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "clipping/liang_barsky/liang_barsky.hpp"
#include "core/colour.hpp"
#include "projection/viewport/viewport.hpp"
#include "stages/5_clipping.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// Black on a light ground, white on a dark one.
inline LinearRgb ink_on(const LinearRgb& background) {
  const float light = 0.2126f * background.r + 0.7152f * background.g + 0.0722f * background.b;
  return LinearRgb{light > 0.18f ? 0.0f : 1.0f};
}

/// An edge between two vertices of a model, and a piece that has it.
struct FaceEdge {
  int from = 0, to = 0;
  PieceId piece;
};

/// The edges of faces, each once however many faces share it. A face's pieces meet in diagonals, which are no
/// edges of it: they come twice in it.
inline std::vector<FaceEdge> face_edges(const std::vector<Piece>& pieces) {
  using Key = std::array<int, 4>;  // object, face, the two vertices
  std::map<Key, std::pair<int, FaceEdge>> of_faces;
  for (const Piece& piece : pieces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax({piece.corners[i].vertex, piece.corners[(i + 1) % 3].vertex});
      auto& [count, edge] = of_faces[{piece.id.object, piece.id.face, a, b}];
      ++count;
      edge = {a, b, piece.id};
    }
  }
  std::map<std::pair<int, int>, FaceEdge> edges;
  for (const auto& [key, counted] : of_faces) {
    const auto& [count, edge] = counted;
    if (count == 1) edges.try_emplace({edge.from, edge.to}, edge);
  }
  std::vector<FaceEdge> list;
  for (const auto& [key, edge] : edges) list.push_back(edge);
  return list;
}

/// The part of an edge inside all planes, as Liang and Barsky clip: the stretch of t that is left.
inline std::optional<Segment<4, double>> part_inside(
    glm::dvec4 a, glm::dvec4 b, std::span<const sutherland_hodgman::Plane<double>> planes) {
  double enters = 0, leaves = 1;
  for (const auto& plane : planes) {
    const double from = distance(plane, a), to = distance(plane, b);
    if (from < 0 && to < 0) return std::nullopt;
    if (from < 0) enters = std::max(enters, from / (from - to));
    if (to < 0) leaves = std::min(leaves, from / (from - to));
  }
  if (enters > leaves) return std::nullopt;
  const Segment<4, double> part = liang_barsky::part(Segment<4, double>{a, b}, enters, leaves);
  return part.a.w > 0 && part.b.w > 0 ? std::optional(part) : std::nullopt;
}

/// A bar about the line from p to q in the picture, half a pixel to either side and beyond its ends, as two
/// triangles counter-clockwise in NDC. Depth says nothing: all bars have one colour.
inline std::array<Triangle, 2> bar(PieceId id, dvec2 p, dvec2 q, Size size) {
  const dvec2 way = q - p;
  const double length = std::sqrt(way.x * way.x + way.y * way.y);
  const dvec2 along = length > 0 ? way / (2 * length) : dvec2{0.5, 0};
  const dvec2 aside{-along.y, along.x};
  const auto corner = [&](dvec2 at) {
    TriangleCorner c;
    c.ndc.at = {2 * at.x / size.width - 1, 1 - 2 * at.y / size.height, 0.5};
    return c;
  };
  // Rows grow downwards: this order is counter-clockwise where y is up
  const TriangleCorner a = corner(p - along - aside), b = corner(p - along + aside),
                       c = corner(q + along + aside), d = corner(q + along - aside);
  return {Triangle{id, {a, b, c}, false}, Triangle{id, {a, c, d}, false}};
}

/// The edges of all faces that culling has left.
///
/// model: from stage 4. size: of the picture.
///
/// Domain: that of clip.
/// Steps: none.
/// Accuracy: the bars' corners to a few ulp before they are snapped.
/// Cost: a search per edge, and two triangles.
/// Errors: ContractViolation for a picture beyond 2^17 pixels.
inline Triangles outlines(const Model<ClipPoint>& model, Size size) {
  const auto planes = guard_volume(size);
  const auto place = [&](const glm::dvec4& at) {
    return viewport::to_pixel(dvec2(perspective::divide(at)), size.width, size.height);
  };
  const auto vertex = [&](int number) { return model.vertices[static_cast<std::size_t>(number)].point.at; };
  Triangles triangles;
  for (const FaceEdge& edge : face_edges(model.pieces)) {
    const auto part = part_inside(vertex(edge.from), vertex(edge.to), planes);
    if (!part) continue;
    for (const Triangle& half : bar(edge.piece, place(part->a), place(part->b), size))
      triangles.push_back(half);
  }
  return triangles;
}

}  // namespace gradus::pipeline
