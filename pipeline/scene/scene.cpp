#include "scene/scene.hpp"

#include <algorithm>
#include <utility>

#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {

bool lets_light_through(const Mesh& mesh) {
  return std::ranges::any_of(mesh.faces, [&](const MeshFace& face) {
    return mesh.materials[static_cast<std::size_t>(face.material)].opacity < 1;
  });
}

Object object_of(Mesh mesh, std::string name) {
  add_missing_normals(mesh);
  const bool closed = closed_outward(mesh), see_through = lets_light_through(mesh);
  return {std::move(name), std::make_shared<const Mesh>(std::move(mesh)), glm::dmat4(1), !closed,
          see_through};
}

namespace {

/// The place of a corner in world space.
dvec3 place_of(const Object& object, const Corner& corner) {
  return affine_3d::transform(object.placement, position_of(*object.mesh, corner));
}

}  // namespace

Bounds bounds_of(const Scene& scene) {
  Bounds bounds;
  for (const Object& object : scene.objects) {
    for (const Corner& corner : object.mesh->corners) bounds.add(place_of(object, corner));
  }
  return bounds;
}

bool lies_behind(const Scene& scene) {
  if (scene.camera.rays) return false;
  const Frame<double>& frame = scene.camera.frame;
  return std::ranges::all_of(scene.objects, [&](const Object& object) {
    return std::ranges::all_of(object.mesh->corners, [&](const Corner& corner) {
      return glm::dot(frame.forward, place_of(object, corner) - frame.eye) <= 0;
    });
  });
}

}  // namespace gradus::pipeline
