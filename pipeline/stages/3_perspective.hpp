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
  const auto& eye = camera.frame;
  const Projection<double> lens =  // a matrix
      projection_of(camera.lens, aspect);
  Model<ClipPoint> clip;
  for (const auto& vertex : world.vertices) {
    const auto& [id, from] = vertex;
    // To the viewer: right, up, depth
    const dvec3 view =  // the eye is at (0, 0, 0)
        viewing::to_view(eye, from.at);
    // Into clip space: w becomes the depth
    const glm::dvec4 to =  // not divided by it
        perspective::transform(lens, view);
    clip.vertices.push_back({id, {to}});
    if constexpr (observed<O>) observer(Projected{id, from, view, {to}});
  }
  clip.pieces = world.pieces;
  return clip;
}

}  // namespace gradus::pipeline
