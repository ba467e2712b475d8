#pragma once
// What is to be seen: objects, lights and a camera.

#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh.hpp"
#include "core/surface.hpp"
#include "scene/antialiasing.hpp"
#include "scene/camera/scene_camera.hpp"
#include "scene/choices.hpp"

namespace gradus::pipeline {

/// That a mesh is made by subdividing another: see plan/levels.hpp.
struct Subdivision {
  std::shared_ptr<const Mesh> control;
  int most = 0;        ///< levels that may be
  int level = 0;       ///< of the mesh
  double longest = 0;  ///< edge of the control mesh, in pixels of the pictures that were asked for
};

/// A mesh and where it stands.
struct Object {
  std::string name;
  std::shared_ptr<const Mesh>
      mesh;                  ///< every corner with a normal (add_missing_normals); others may show it, too
  glm::dmat4 placement{1};   ///< object space to world space, affine
  bool two_sided = true;     ///< false: back faces are never seen and are removed
  bool see_through = false;  ///< some face lets light through: see draws_opacity
  std::optional<Subdivision> subdivision{};
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
  SceneCamera camera;
  std::vector<Light> lights;
  LinearRgb ambient{0.15f};    ///< the light that comes from everywhere
  LinearRgb background{1.0f};  ///< where there is nothing
  Shading shading = Shading::phong;
  HiddenSurfaces hidden_surfaces = HiddenSurfaces::z_buffer;
  Culling culling = Culling::closed_bodies;
  TextureFilter filter = TextureFilter::mip_mapped;
  Antialiasing antialiasing = default_antialiasing;  ///< of `antialiased`; `render` asks centres
  int samples = default_samples;                     ///< per pixel
};

/// The object with this number.
inline const Object& object_at(const Scene& scene, int number) {
  return scene.objects[static_cast<std::size_t>(number)];
}

/// Whether opacities are drawn. The A-buffer alone keeps all that lies behind a place; other methods keep
/// what is nearest, as if nothing let light through.
inline bool draws_opacity(const Scene& scene) {
  return scene.antialiasing == Antialiasing::a_buffer && scene.shading != Shading::wireframe;
}
/// Whether an object's backs, and what stands behind it, may be seen through it.
inline bool shows_through(const Scene& scene, const Object& object) {
  return object.see_through && draws_opacity(scene);
}

/// Whether some face has a material that lets light through.
bool lets_light_through(const Mesh& mesh);

/// The object of a mesh: missing normals are made, it is two-sided unless it encloses a body
/// (closed_outward), and see-through where a face lets light through.
Object object_of(Mesh mesh, std::string name = {});

/// The box that holds all objects, in world space.
Bounds bounds_of(const Scene& scene);

/// Whether all objects lie behind the camera's eye, or beside it; never where rays are parallel.
bool lies_behind(const Scene& scene);

}  // namespace gradus::pipeline
