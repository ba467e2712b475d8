#pragma once
// The triangles of a mesh's faces, as the pipeline draws them and files of triangles have them.

#include <concepts>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "core/mesh.hpp"
#include "modeling/ear_clipping/ear_clipping.hpp"
#include "modeling/ear_clipping/many_corners.hpp"

namespace gradus::pipeline {

/// The triangles of a face, by the places of its corners: itself, or the ears of a larger one.
template <std::invocable<const ear_clipping::Triangle&> Add>
void triangulate(const Mesh& mesh, const MeshFace& face, const Add& add) {
  if (face.count == 3) {
    add({0, 1, 2});
    return;
  }
  std::vector<dvec3> polygon;
  for (const Corner& corner : corners_of(mesh, face)) polygon.push_back(position_of(mesh, corner));
  // The same triangles; the walk round the ring is quadratic, the tree pays from about here on
  constexpr std::size_t many = 100;
  if (polygon.size() < many)
    ear_clipping::triangulate(polygon, add);
  else
    ear_clipping::triangulate_many(polygon, add);
}

}  // namespace gradus::pipeline
