#pragma once
// Stage 2, world transformation: every object is put where it stands.

#include <utility>

#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "points.hpp"
#include "scene/scene.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {

/// A vertex stands in the world.
struct Placed {
  VertexId id;
  ObjectPoint from;
  WorldPoint to;
};

/// The normals of a piece were turned along, and its corners still run counter-clockwise.
struct Turned {
  PieceId id;
  bool mirrored;  ///< the placement mirrors: the order of the corners was reversed
};

/// Takes vertices and normals from the objects' spaces to the world.
///
/// Domain: affine placements.
/// Steps: Placed* Turned*.
/// Accuracy: that of affine_3d::transform.
/// Cost: a transformation a vertex and a corner.
/// Errors: none.
template <Observer<Placed, Turned> O = Unobserved>
Model<WorldPoint> to_world(const Scene& scene, Model<ObjectPoint> model, O&& observer = {}) {
  Model<WorldPoint> world;
  world.vertices.reserve(model.vertices.size());
  for (const Vertex<ObjectPoint>& vertex : model.vertices) {
    const glm::dmat4& placement = scene.objects[static_cast<std::size_t>(vertex.id.object)].placement;
    world.vertices.push_back({vertex.id, {affine_3d::transform(placement, vertex.point.at)}});
    if constexpr (observed<O>) observer(Placed{vertex.id, vertex.point, world.vertices.back().point});
  }
  world.pieces = std::move(model.pieces);
  for (Piece& piece : world.pieces) {
    const glm::dmat4& placement = scene.objects[static_cast<std::size_t>(piece.id.object)].placement;
    const glm::dmat3 normal_matrix = affine_3d::normal_matrix(placement);
    for (PieceCorner& corner : piece.corners) corner.normal = unit_vector(normal_matrix * corner.normal);
    const bool mirrored = affine_3d::mirrors(placement);
    if (mirrored) std::swap(piece.corners[1], piece.corners[2]);
    if constexpr (observed<O>) observer(Turned{piece.id, mirrored});
  }
  return world;
}

}  // namespace gradus::pipeline
