#pragma once
// An exhibit: stage 4 as lecture notes have it, after the division and before clipping (errata E001-40).
// Never render with it; 4_back_faces.hpp has the right one.

#include <vector>

#include "stages/4_back_faces.hpp"
#include "visibility/back_face_culling/back_face_culling_notes.hpp"

namespace gradus::pipeline {

/// FAULTY: removes the pieces whose area in the picture is negative, corners behind the eye and all. What is
/// told of a piece is what cull tells, with the side that was found.
///
/// Domain: as cull.
/// Steps: Faced*.
/// Accuracy: wrong for pieces with one or three corners behind the eye.
/// Cost: 3 divisions per piece.
/// Errors: none.
template <Observer<Faced> O = Unobserved>
Model<ClipPoint> cull_after_division(const Scene& scene, Model<ClipPoint> model, O&& observer = {}) {
  using back_face_culling::Facing;
  std::vector<Piece> kept;
  for (Piece& piece : model.pieces) {
    const auto& [a, b, c] = piece.corners;
    const Facing side =
        back_face_culling::facing_after_division(model.point(a).at, model.point(b).at, model.point(c).at);
    const bool both = two_sided(scene, piece);
    const bool back = side == Facing::back;
    const bool keep = side == Facing::front || (back && both);
    piece.seen_from_behind = back;
    if constexpr (observed<O>) observer(Faced{piece.id, side, both, !keep});
    if (keep) kept.push_back(piece);
  }
  model.pieces.swap(kept);
  return model;
}

}  // namespace gradus::pipeline
