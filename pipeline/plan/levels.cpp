#include "plan/levels.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "projection/viewing/viewing.hpp"
#include "scene/models/subdivided.hpp"
#include "stages/3_perspective.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

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
