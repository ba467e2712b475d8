#pragma once
// The camera of a scene: one with an eye and a lens, or one that sees by parallel rays.

#include <optional>

#include "core/camera.hpp"
#include "core/geometry.hpp"
#include "projection/parallel/parallel.hpp"

namespace gradus::pipeline {

/// What a camera without perspective sees, in world units. The eye then tells where the middle of the picture
/// is, and what stands behind it is seen as well.
struct ParallelRays {
  double height = 2;                    ///< between lower and upper edge of the picture, > 0
  parallel::Slant<double> slant{0, 0};  ///< 0, 0: orthographic
  double plane = 1;                     ///< the depth whose things stand where they would without slant
  double near = 0, far = 2;             ///< depths between which things are drawn, near < far
};

/// With `rays` the lens is not asked.
struct SceneCamera : Camera {
  std::optional<ParallelRays> rays{};

  SceneCamera() = default;
  SceneCamera(const Camera& camera) : Camera(camera) {}
};

/// The direction from things to a viewer who sees by parallel rays, of any length but 0.
inline dvec3 towards_viewer(const Frame<double>& frame, const parallel::Slant<double>& slant) {
  return -(slant.a * frame.right + slant.b * frame.up + frame.forward);
}

/// Where a point is seen from: the eye, or a place on the ray that goes through the point.
inline dvec3 viewer_of(const SceneCamera& camera, dvec3 point) {
  if (!camera.rays) return camera.frame.eye;
  // Far enough that the sum keeps the direction
  return point + (1 + length_of(point)) * towards_viewer(camera.frame, camera.rays->slant);
}

}  // namespace gradus::pipeline
