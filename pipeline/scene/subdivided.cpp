#include "scene/subdivided.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/contract.hpp"
#include "modeling/subdivision_surface/subdivision_surface_batch.hpp"
#include "projection/viewing/viewing.hpp"
#include "stages/3_perspective.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// What the corners of a face carry besides their places: none, or one each.
using FaceTextures = std::vector<dvec2>;

std::vector<FaceTextures> textures_of(const Mesh& mesh) {
  std::vector<FaceTextures> all;
  for (const MeshFace& face : mesh.faces) {
    FaceTextures own;
    for (const Corner& corner : corners_of(mesh, face)) {
      if (corner.texture >= 0) own.push_back(mesh.textures[static_cast<std::size_t>(corner.texture)]);
    }
    if (own.size() != corners_of(mesh, face).size()) own.clear();
    all.push_back(std::move(own));
  }
  return all;
}

/// Those of the quadrilaterals that a face becomes, in their order.
void add_quads(const FaceTextures& of, std::vector<FaceTextures>& all, std::size_t corners) {
  dvec2 middle{0};
  for (const dvec2 at : of) middle += at / static_cast<double>(of.size());
  for (std::size_t i = 0; i < corners; ++i) {
    if (of.empty()) {
      all.emplace_back();
      continue;
    }
    const dvec2 at = of[i], next = of[(i + 1) % corners], before = of[(i + corners - 1) % corners];
    all.push_back({at, 0.5 * (at + next), middle, 0.5 * (at + before)});
  }
}

subdivision_surface::Surface<double> surface_of(const Mesh& mesh) {
  subdivision_surface::Surface<double> surface{mesh.positions, {}};
  for (const MeshFace& face : mesh.faces) {
    std::vector<std::int32_t> ring;
    for (const Corner& corner : corners_of(mesh, face)) ring.push_back(corner.position);
    surface.faces.add(ring);
  }
  return surface;
}

// --- How long edges are in a picture ---------------------------------------------------------------

class Pictures {
 public:
  Pictures(std::span<const SceneCamera> cameras, Size size) : cameras_(cameras), size_(size) {}

  /// The longest edge of an object's control mesh in any picture, in pixels.
  double longest_edge(const Object& object) const {
    double longest = 0;
    for (const SceneCamera& camera : cameras_) longest = std::max(longest, longest_edge(object, camera));
    return longest;
  }

 private:
  double longest_edge(const Object& object, const SceneCamera& camera) const {
    const SceneLens lens = lens_of(camera, size_.ratio());
    std::vector<glm::dvec4> places;
    for (const dvec3& p : object.subdivision->control->positions)
      places.push_back(
          transform(lens, viewing::to_view(camera.frame, affine_3d::transform(object.placement, p))));
    double longest = 0;
    const Mesh& mesh = *object.subdivision->control;
    for (const MeshFace& face : mesh.faces) {
      const auto corners = corners_of(mesh, face);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto at = [&](std::size_t k) { return places[static_cast<std::size_t>(corners[k].position)]; };
        longest = std::max(longest, length(at(i), at((i + 1) % corners.size())));
      }
    }
    return longest;
  }

  /// Of what is wholly beside the picture 0.
  double length(const glm::dvec4& a, const glm::dvec4& b) const {
    if (a.w <= 0 && b.w <= 0) return 0;
    for (int axis = 0; axis < 2; ++axis) {
      if ((a[axis] > a.w && b[axis] > b.w) || (a[axis] < -a.w && b[axis] < -b.w)) return 0;
    }
    if (a.w <= 0 || b.w <= 0) return endless;
    const dvec2 way = dvec2(a) / a.w - dvec2(b) / b.w;
    return 0.5 * length_of(dvec2(way.x * size_.width, way.y * size_.height));
  }

  std::span<const SceneCamera> cameras_;
  Size size_;
};

/// The level of an object whose longest edge is so long.
int level_for(double longest, const Subdivision& of) {
  const auto corners = static_cast<std::int64_t>(of.control->corners.size());
  int level = 0;
  while (level < of.most && longest > fine_edge && corners << (2 * level) <= most_subdivided_faces) {
    longest /= 2;
    ++level;
  }
  return level;
}

}  // namespace

Mesh subdivided(const Mesh& control, int levels) {
  auto surface = subdivision_surface::catmull_clark_batch(surface_of(control), levels);
  std::vector<FaceTextures> textures = textures_of(control);
  std::vector<int> materials;
  for (const MeshFace& face : control.faces) materials.push_back(face.material);
  for (int level = 0; level < levels; ++level) {
    std::vector<FaceTextures> finer;
    std::vector<int> theirs;
    for (std::size_t f = 0; f < textures.size(); ++f) {
      // A face of n corners makes n quadrilaterals
      const auto corners = static_cast<std::size_t>(level == 0 ? control.faces[f].count : 4);
      add_quads(textures[f], finer, corners);
      theirs.insert(theirs.end(), corners, materials[f]);
    }
    textures = std::move(finer);
    materials = std::move(theirs);
  }
  Mesh mesh;
  mesh.positions = std::move(surface.points);
  mesh.materials = control.materials;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    std::vector<Corner> corners;
    for (const std::int32_t vertex : surface.faces[f]) {
      const bool textured = !textures[f].empty();
      if (textured) mesh.textures.push_back(textures[f][corners.size()]);
      corners.push_back({vertex, textured ? static_cast<int>(mesh.textures.size()) - 1 : -1});
    }
    add_face(mesh, corners, materials[f]);
  }
  add_missing_normals(mesh);
  return mesh;
}

std::optional<std::string> why_not_subdivided(const Mesh& control) {
  try {
    subdivision_surface::catmull_clark(surface_of(control), 1);
  } catch (const ContractViolation& violation) {
    return violation.what();
  }
  return std::nullopt;
}

void subdivide(Scene& scene, std::span<const SceneCamera> cameras, Size size) {
  const Pictures pictures(cameras, size);
  // Objects that show one model at one level share its mesh
  std::map<std::pair<const Mesh*, int>, std::shared_ptr<const Mesh>> made;
  for (Object& object : scene.objects) {
    if (!object.subdivision) continue;
    Subdivision& of = *object.subdivision;
    of.longest = pictures.longest_edge(object);
    of.level = level_for(of.longest, of);
    auto& mesh = made[{of.control.get(), of.level}];
    if (!mesh)
      mesh = of.level == 0 ? of.control : std::make_shared<const Mesh>(subdivided(*of.control, of.level));
    object.mesh = mesh;
  }
}

}  // namespace gradus::pipeline
