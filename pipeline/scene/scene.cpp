#include "scene/scene.hpp"

#include <span>
#include <utility>
#include <vector>

#include "core/contract.hpp"
#include "scene/framing.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {

Object object_of(Mesh mesh, std::string name) {
  add_missing_normals(mesh);
  const bool closed = closed_outward(mesh);
  return {std::move(name), std::move(mesh), glm::dmat4(1), !closed};
}

Scene scene_of(Mesh mesh, double aspect, std::string name) {
  expects(!mesh.faces.empty(), "a scene needs a model with at least one face");
  Scene scene;
  scene.objects.push_back(object_of(std::move(mesh), std::move(name)));
  const Object& object = scene.objects[0];
  std::vector<dvec3> points;
  points.reserve(object.mesh.corners.size());
  for (const Corner& corner : object.mesh.corners) points.push_back(position_of(object.mesh, corner));
  scene.camera = framed(std::span<const dvec3>(points), aspect, viewing_side(object));
  scene.lights = default_lights(scene.camera);
  return scene;
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
