#pragma once
// Stage 4, back-face removal: pieces of closed bodies that turn their backs are never seen.

#include <utility>
#include <vector>

#include "core/observe.hpp"
#include "points.hpp"
#include "scene/scene.hpp"
#include "visibility/back_face_culling/back_face_culling.hpp"

namespace gradus::pipeline {

/// A piece was tested by the sign of det[x y w].
struct Faced {
  PieceId id;
  back_face_culling::Facing facing;
  bool two_sided;  ///< its object shows its back faces too
  bool removed;
};

/// Removes the pieces that show their backs, and those seen edge-on. Those of two-sided objects stay and are
/// marked.
///
/// Domain: finite coordinates, any w.
/// Steps: Faced*.
/// Accuracy: exact.
/// Cost: a determinant a piece.
/// Errors: ContractViolation for coordinates that are not finite.
template <Observer<Faced> O = Unobserved>
Model<ClipPoint> remove_back_faces(const Scene& scene, Model<ClipPoint> model, O&& observer = {}) {
  using back_face_culling::Facing;
  std::vector<Piece> kept;
  for (Piece& piece : model.pieces) {
    const auto& [a, b, c] = piece.corners;
    const Facing facing = back_face_culling::facing(model.point(a).at, model.point(b).at, model.point(c).at);
    const bool two_sided = scene.objects[static_cast<std::size_t>(piece.id.object)].two_sided;
    const bool stays = facing == Facing::front || (facing == Facing::back && two_sided);
    piece.seen_from_behind = facing == Facing::back;
    if (stays) kept.push_back(piece);
    if constexpr (observed<O>) observer(Faced{piece.id, facing, two_sided, !stays});
  }
  model.pieces = std::move(kept);
  return model;
}

}  // namespace gradus::pipeline
