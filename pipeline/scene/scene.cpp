#include "scene/scene.hpp"

#include <utility>

#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {

Object object_of(Mesh mesh, std::string name) {
  add_missing_normals(mesh);
  const bool closed = closed_outward(mesh);
  return {std::move(name), std::move(mesh), glm::dmat4(1), !closed};
}

Bounds bounds_of(const Scene& scene) {
  Bounds bounds;
  for (const Object& object : scene.objects) {
    for (const Corner& corner : object.mesh.corners) {
      bounds.add(affine_3d::transform(object.placement, position_of(object.mesh, corner)));
    }
  }
  return bounds;
}

}  // namespace gradus::pipeline
