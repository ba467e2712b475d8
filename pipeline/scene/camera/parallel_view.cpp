#include "scene/camera/parallel_view.hpp"

#include <algorithm>
#include <cmath>

#include "projection/parallel/parallel.hpp"
#include "projection/viewing/viewing.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {
namespace {

/// What the objects take up in the plane of the picture, and in depth.
Bounds seen_bounds(const Frame<double>& frame, const ParallelRays& rays, std::span<const Object> objects) {
  Bounds seen;
  for (const Object& object : objects) {
    for (const Corner& corner : object.mesh->corners) {
      const dvec3 at = affine_3d::transform(object.placement, position_of(*object.mesh, corner));
      const dvec3 view = viewing::to_view(frame, at);
      const dvec3 image = parallel::oblique(rays.plane, rays.slant, view);
      seen.add({image.x, image.y, view.z});
    }
  }
  return seen;
}

/// The height of a picture that has the bounds inside its margins, about its middle.
double height_for(const Bounds& seen, double aspect) {
  const dvec3 half = glm::max(glm::abs(seen.lower), glm::abs(seen.upper));
  const double height = 2.2 * std::max(half.y, half.x / aspect);
  return height > 0 ? height : 1;
}

}  // namespace

SceneCamera with_rays(const Camera& camera, const View& view, double plane, std::span<const Object> objects,
                      double aspect) {
  SceneCamera parallel = camera;
  ParallelRays& rays = parallel.rays.emplace();
  rays.plane = plane;
  if (leans(view.projection)) rays.slant = parallel::slant_of(view.receding_radians, view.foreshortening);
  Bounds seen = seen_bounds(parallel.frame, rays, objects);
  if (!view.eye && !view.target) {
    const dvec3 middle = seen.centre();
    Frame<double>& frame = parallel.frame;
    frame.eye = frame.eye + middle.x * frame.right + middle.y * frame.up;
    seen = seen_bounds(frame, rays, objects);
  }
  rays.height = view.height.value_or(height_for(seen, aspect));
  // At least what tells the planes apart from far away
  const double deep = seen.upper.z - seen.lower.z, farthest = std::max(-seen.lower.z, seen.upper.z);
  const double margin = std::max(deep > 0 ? deep / 100 : rays.height, 1e-9 * farthest);
  rays.near = seen.lower.z - margin;
  rays.far = seen.upper.z + margin;
  return parallel;
}

}  // namespace gradus::pipeline
