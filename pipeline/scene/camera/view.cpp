#include "scene/camera/view.hpp"

#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <span>
#include <vector>

#include "core/contract.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/camera/framing.hpp"
#include "scene/camera/parallel_view.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {
namespace {

using Objects = std::span<const Object>;

/// Of all objects, turned.
std::vector<dvec3> points_of(Objects objects, const glm::dmat3& turn = glm::dmat3(1)) {
  std::vector<dvec3> points;
  for (const Object& object : objects) {
    const glm::dmat4 placement = glm::dmat4(turn) * object.placement;
    for (const Corner& corner : object.mesh->corners)
      points.push_back(affine_3d::transform(placement, position_of(*object.mesh, corner)));
  }
  return points;
}

Bounds bounds_of(std::span<const dvec3> points) {
  Bounds bounds;
  for (const dvec3 point : points) bounds.add(point);
  return bounds;
}

/// The rotation that takes `up` to +y, and what is then the front to +z.
glm::dmat3 upright(dvec3 up) {
  const dvec3 y = unit_vector(up);
  expects(y != dvec3{0}, "up is the zero vector, which points nowhere");
  const dvec3 ahead = std::abs(y.z) > 0.9 ? dvec3{0, 1, 0} : dvec3{0, 0, -1};
  const dvec3 x = unit_vector(glm::cross(ahead, y));
  return glm::transpose(glm::dmat3(x, y, glm::cross(x, y)));
}

/// From where they are looked at once they are turned; several have no front.
dvec3 side_of(Objects objects, const glm::dmat3& turn) {
  if (objects.size() != 1) return front_right_above;
  Object turned = objects[0];
  turned.placement = glm::dmat4(turn) * turned.placement;
  return viewing_side(turned);
}

/// The aim of the camera that shows all objects.
Aim framing_aim(Objects objects, dvec3 up, double aspect, double radians) {
  const glm::dmat3 turn = upright(up);
  const std::vector<dvec3> points = points_of(objects, turn);
  const Frame<double> frame =
      framed(std::span<const dvec3>(points), aspect, side_of(objects, turn), radians).frame;
  const double distance = length_of(bounds_of(points).centre() - frame.eye);
  const glm::dmat3 back = glm::transpose(turn);
  return {back * frame.eye, back * (frame.eye + distance * frame.forward), up};
}

/// From where an oblique picture shows the front in its true shape.
dvec3 eye_before(const std::vector<dvec3>& points, dvec3 target, dvec3 up) {
  const double radius = bounds_of(points).radius();
  return target + glm::transpose(upright(up)) * dvec3{0, 0, radius > 0 ? 3 * radius : 1};
}

}  // namespace

Aim aim_of(Objects objects, const View& view, double aspect) {
  const dvec3 up = view.up.value_or(dvec3{0, 1, 0});
  expects(unit_vector(up) != dvec3{0}, "up is the zero vector, which points nowhere");
  const dvec3 middle = view.target ? *view.target : bounds_of(points_of(objects)).centre();
  Aim aim{view.eye.value_or(dvec3{0}), middle, up};
  if (!view.eye) {
    if (leans(view.projection)) return {eye_before(points_of(objects), middle, up), middle, up};
    aim = framing_aim(objects, up, aspect, view.vertical_radians);
    if (!view.target) return aim;
    aim.target = middle;
  }
  // Seen from straight above or below, y tells no direction in the picture; from beside there it still does,
  // so that a camera's path does not turn the picture at once
  if (!view.up && !tells_upright(aim)) aim.up = {0, 0, -1};
  return aim;
}

bool leads_somewhere(const Aim& aim) { return unit_vector(aim.target - aim.eye) != dvec3{0}; }

bool tells_upright(const Aim& aim) {
  return viewing::sine_between(aim.target - aim.eye, aim.up) >= viewing::least_sine<double>;
}

Camera camera_of(const Aim& aim, double vertical_radians, Objects objects) {
  Camera camera;
  camera.frame = viewing::look_at(aim.eye, aim.target, aim.up);
  camera.lens.vertical_radians = vertical_radians;
  return with_depths(camera, bounds_of(points_of(objects)));
}

SceneCamera camera_of(const Aim& aim, const View& view, Objects objects, double aspect) {
  const Camera camera = camera_of(aim, view.vertical_radians, objects);
  if (has_eye(view.projection)) return camera;
  return with_rays(camera, view, length_of(aim.target - aim.eye), objects, aspect);
}

}  // namespace gradus::pipeline
