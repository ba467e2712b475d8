#pragma once
// Stage 3, perspective transformation: from the world to the viewer, and into clip space. It multiplies and
// does not divide.

#include "core/camera.hpp"
#include "core/observe.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/viewing/viewing.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// A vertex stands in clip space.
struct Projected {
  VertexId id;
  WorldPoint world;
  dvec3 view;      ///< right, up, depth
  ClipPoint clip;  ///< w is the depth
};

/// What the camera's lens does, as a matrix.
inline Projection<double> lens_of(const Camera& camera, double aspect) {
  return projection_of(camera.lens, aspect);
}

/// Takes every vertex through the camera.
///
/// aspect: width / height of the picture.
/// Domain: finite coordinates; vertices may lie behind the eye.
/// Steps: Projected*.
/// Accuracy: that of viewing::to_view and perspective::transform.
/// Cost: a vertex each.
/// Errors: ContractViolation for a lens that sees nothing.
template <Observer<Projected> O = Unobserved>
Model<ClipPoint> to_clip(const Camera& camera, double aspect, const Model<WorldPoint>& world,
                         O&& observer = {}) {
  using perspective::transform;
  using viewing::to_view;
  const auto& eye = camera.frame;
  auto lens = lens_of(camera, aspect);
  Model<ClipPoint> clip;
  for (auto& v : world.vertices) {
    const auto& [id, from] = v;
    // To the viewer: right, up, depth
    auto view = to_view(eye, from.at);
    // To clip space: w is the depth
    auto to = transform(lens, view);
    clip.add(id, {to});
    if constexpr (observed<O>) observer(Projected{id, from, view, {to}});
  }
  clip.pieces = world.pieces;
  return clip;
}

}  // namespace gradus::pipeline
