#pragma once
// What is to be seen: objects, lights and a camera.

#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "core/camera.hpp"
#include "core/mesh.hpp"
#include "core/surface.hpp"

namespace gradus::pipeline {

/// A mesh and where it stands.
struct Object {
  std::string name;
  Mesh mesh;                ///< every corner with a normal (add_missing_normals)
  glm::dmat4 placement{1};  ///< object space to world space, affine
  bool two_sided = true;    ///< false: back faces are never seen and are removed
};

/// How often light is computed (shading/polygon_shading).
enum class Shading {
  flat,     ///< once a face
  gouraud,  ///< once a corner of a triangle; what lies between is mixed
  phong,    ///< once a pixel
};

/// How a surface takes its colour from its texture (shading/texture_mapping).
enum class TextureFilter {
  nearest,     ///< from one texel
  bilinear,    ///< from four
  mip_mapped,  ///< from a level whose texels are as large as the pixel
};

/// Objects in the order of their numbers, in one world.
struct Scene {
  std::vector<Object> objects;
  Camera camera;
  std::vector<Light> lights;
  LinearRgb ambient{0.15f};    ///< the light that comes from everywhere
  LinearRgb background{1.0f};  ///< where there is nothing
  Shading shading = Shading::phong;
  TextureFilter filter = TextureFilter::mip_mapped;
};

/// The object with this number.
inline const Object& object_at(const Scene& scene, int number) {
  return scene.objects[static_cast<std::size_t>(number)];
}

/// The object of a mesh: missing normals are made, and it is two-sided unless it encloses a body
/// (closed_outward).
Object object_of(Mesh mesh, std::string name = {});

/// The box that holds all objects, in world space.
Bounds bounds_of(const Scene& scene);

}  // namespace gradus::pipeline
