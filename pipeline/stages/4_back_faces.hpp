#pragma once
// Stage 4, back-face removal: pieces of closed bodies that turn their backs are never seen.

#include <vector>

#include "core/observe.hpp"
#include "scene/scene.hpp"
#include "stages/points.hpp"
#include "visibility/back_face_culling/back_face_culling.hpp"

namespace gradus::pipeline {

/// A piece was tested by the sign of det[x y w].
struct Faced {
  PieceId id;
  back_face_culling::Facing facing;
  bool two_sided;  ///< its back is shown, too
  bool removed;
};

/// The side that a piece shows.
inline back_face_culling::Facing facing(const Model<ClipPoint>& model, const Piece& piece) {
  const auto& [a, b, c] = piece.corners;
  return back_face_culling::facing(model.point(a).at, model.point(b).at, model.point(c).at);
}

/// Whether its back is shown, too: as its object says, or where one sees through that, unless all backs are
/// asked for or none.
inline bool two_sided(const Scene& scene, const Piece& piece) {
  if (scene.culling == Culling::none) return true;
  if (scene.culling == Culling::back) return false;
  const Object& object = object_at(scene, piece.id.object);
  return object.two_sided || shows_through(scene, object);
}

/// Removes the pieces that show their backs, and those seen edge-on. Those of two-sided objects stay and are
/// marked.
///
/// Domain: finite coordinates, any w.
/// Steps: Faced*.
/// Accuracy: exact.
/// Cost: a determinant per piece.
/// Errors: ContractViolation for coordinates that are not finite.
template <Observer<Faced> O = Unobserved>
Model<ClipPoint> cull(const Scene& scene, Model<ClipPoint> model, O&& observer = {}) {
  using back_face_culling::Facing;
  std::vector<Piece> kept;
  for (auto& p : model.pieces) {
    // By the sign of det[x y w]
    const auto s = facing(model, p);
    bool front = s == Facing::front;
    bool back = s == Facing::back;
    // Of open models both are seen
    bool both = two_sided(scene, p);
    // Edge-on: never
    bool keep = back ? both : front;
    p.seen_from_behind = back;
    if constexpr (observed<O>) observer(Faced{p.id, s, both, !keep});
    if (keep) kept.push_back(p);
  }
  model.pieces.swap(kept);
  return model;
}

}  // namespace gradus::pipeline
