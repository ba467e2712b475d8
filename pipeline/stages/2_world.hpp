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

/// Where the object of a vertex or of a piece stands.
template <class Id>
const glm::dmat4& placement(const Scene& scene, Id id) {
  return object_at(scene, id.object).placement;
}

/// Takes vertices and normals from the objects' spaces to the world.
///
/// Domain: affine placements.
/// Steps: Placed* Turned*.
/// Accuracy: that of affine_3d::transform.
/// Cost: a transformation per vertex and corner.
/// Errors: none.
template <Observer<Placed, Turned> O = Unobserved>
Model<WorldPoint> to_world(const Scene& scene, Model<ObjectPoint> model, O&& observer = {}) {
  using affine_3d::transform;
  Model<WorldPoint> world;
  for (auto& v : model.vertices) {
    const auto& [id, from] = v;
    // As its object stands
    auto& m = placement(scene, id);
    auto to = transform(m, from.at);
    world.add(id, {to});
    if constexpr (observed<O>) observer(Placed{id, from, {to}});
  }
  // Normals turn, they do not move
  hand_on_pieces(model, world);
  for (auto& p : world.pieces) {
    const PieceId id = p.id;
    auto& m = placement(scene, id);
    turn(m, p);
    if constexpr (observed<O>) observer(Turned{id, affine_3d::mirrors(m)});
  }
  return world;
}

}  // namespace gradus::pipeline
