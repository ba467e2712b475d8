#pragma once
// Stage 3, perspective transformation: from the world to the viewer, and into clip space. It multiplies and
// does not divide. Parallel rays go the same way, with w = 1.

#include <limits>
#include <optional>

#include "core/camera.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"
#include "projection/parallel/parallel.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/camera/scene_camera.hpp"
#include "scene/scene.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// A vertex stands in clip space.
struct Projected {
  VertexId id;
  WorldPoint world;
  dvec3 view;      ///< right, up, depth
  ClipPoint clip;  ///< w is the depth; 1 where rays are parallel
};

/// What a camera does with view space: perspective, or rays that are parallel.
struct SceneLens {
  Projection<double> perspective{};
  std::optional<ParallelRays> rays{};
  double aspect = 1;
};

/// The lens of a camera. Errors: ContractViolation for one that sees nothing.
inline SceneLens lens_of(const SceneCamera& camera, double aspect) {
  if (!camera.rays) return {projection_of(camera.lens, aspect), {}, aspect};
  const auto& [height, slant, plane, near, far] = *camera.rays;
  expects(0 < height && height <= std::numeric_limits<double>::max(), "a picture shows some height, not {}",
          height);
  expects(near < far, "the near plane lies before the far plane, not at {} and {}", near, far);
  expects(0 < aspect && aspect <= std::numeric_limits<double>::max(), "width / height is positive, not {}",
          aspect);
  return {{}, camera.rays, aspect};
}

/// View space to clip space. Parallel rays: along them onto a plane, then the heights of the picture and the
/// depths between near and far become those of the clip volume, with w = 1, so that the division that comes
/// later changes nothing.
inline glm::dvec4 transform(const SceneLens& lens, dvec3 view) {
  if (!lens.rays) return perspective::transform(lens.perspective, view);
  const ParallelRays& rays = *lens.rays;
  const dvec3 image = parallel::oblique(rays.plane, rays.slant, view);
  const double scale = 2 / rays.height;
  return {scale / lens.aspect * image.x, scale * image.y, (view.z - rays.near) / (rays.far - rays.near), 1};
}

/// Takes every vertex through the camera.
///
/// aspect: width / height of the picture.
/// Domain: finite coordinates; vertices may lie behind the eye.
/// Steps: Projected*.
/// Accuracy: that of viewing::to_view and perspective::transform, or of parallel::oblique and 3 roundings.
/// Cost: a vertex each.
/// Errors: ContractViolation for a lens that sees nothing.
template <Observer<Projected> O = Unobserved>
Model<ClipPoint> to_clip(const SceneCamera& of, double aspect, const Model<WorldPoint>& world,
                         O&& observer = {}) {
  using viewing::to_view;
  const auto& eye = of.frame;
  auto lens = lens_of(of, aspect);
  Model<ClipPoint> clip;
  for (auto& v : world.vertices) {
    const auto& [id, from] = v;
    // Seen: right, up, depth
    auto p = to_view(eye, from.at);
    // To clip space: w is the depth
    auto to = transform(lens, p);
    clip.add(id, {to});
    if constexpr (observed<O>) observer(Projected{id, from, p, {to}});
  }
  clip.pieces = world.pieces;
  clip.planes = world.planes;
  return clip;
}

/// The same through a scene's camera, for a picture of this size.
template <Observer<Projected> O = Unobserved>
Model<ClipPoint> to_clip(const Scene& scene, Size size, const Model<WorldPoint>& world, O&& observer = {}) {
  return to_clip(scene.camera, size.ratio(), world, observer);
}

}  // namespace gradus::pipeline
