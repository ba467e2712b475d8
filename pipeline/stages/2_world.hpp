#pragma once
// Stage 2, world transformation: every object is put where it stands.

#include <utility>

#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "scene/scene.hpp"
#include "stages/points.hpp"
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

/// Turns the normals of a piece along. Returns whether the placement mirrors it: then two corners change
/// places.
inline bool turn(const glm::dmat4& placement, Piece& piece) {
  const glm::dmat3 normal_matrix = affine_3d::normal_matrix(placement);
  for (PieceCorner& corner : piece.corners) corner.normal = unit_vector(normal_matrix * corner.normal);
  const bool mirrored = affine_3d::mirrors(placement);
  if (mirrored) std::swap(piece.corners[1], piece.corners[2]);
  return mirrored;
}

/// Where an object stands.
inline const glm::dmat4& placement_of(const Scene& scene, int object) {
  return object_at(scene, object).placement;
}

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
  for (const auto& vertex : model.vertices) {
    const auto& [id, from] = vertex;
    const glm::dmat4& m =  // of its object
        placement_of(scene, id.object);
    const dvec3 to =  // m * (x, y, z, 1)
        affine_3d::transform(m, from.at);
    world.vertices.push_back({id, {to}});
    if constexpr (observed<O>) observer(Placed{id, from, {to}});
  }
  // Normals turn, they do not move
  world.pieces = std::move(model.pieces);
  for (Piece& piece : world.pieces) {
    const glm::dmat4& m =  // of its object
        placement_of(scene, piece.id.object);
    const bool mirrored = turn(m, piece);
    if constexpr (observed<O>) observer(Turned{piece.id, mirrored});
  }
  return world;
}

}  // namespace gradus::pipeline
