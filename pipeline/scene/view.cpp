#include "scene/view.hpp"

#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <span>
#include <vector>

#include "core/contract.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/framing.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {
namespace {

std::vector<dvec3> points_of(const Object& object) {
  std::vector<dvec3> points;
  points.reserve(object.mesh.corners.size());
  for (const Corner& corner : object.mesh.corners) {
    points.push_back(affine_3d::transform(object.placement, position_of(object.mesh, corner)));
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

/// The aim of the camera that shows all of the object.
Aim framing_aim(const Object& object, dvec3 up, double aspect, double radians) {
  const glm::dmat3 turn = upright(up);
  Object turned = object;
  turned.placement = glm::dmat4(turn) * object.placement;
  const std::vector<dvec3> points = points_of(turned);
  const Frame<double> frame =
      framed(std::span<const dvec3>(points), aspect, viewing_side(turned), radians).frame;
  const double distance = length_of(bounds_of(points).centre() - frame.eye);
  const glm::dmat3 back = glm::transpose(turn);
  return {back * frame.eye, back * (frame.eye + distance * frame.forward), up};
}

}  // namespace

Aim aim_of(const Object& object, const View& view, double aspect) {
  Aim aim = framing_aim(object, view.up.value_or(dvec3{0, 1, 0}), aspect, view.vertical_radians);
  if (!view.eye && !view.target) return aim;
  aim.eye = view.eye.value_or(aim.eye);
  aim.target = view.target.value_or(bounds_of(points_of(object)).centre());
  // Seen from nearly straight above or below, y tells no direction in the picture
  if (!view.up && viewing::sine_between(aim.target - aim.eye, aim.up) < 0.1) aim.up = {0, 0, -1};
  return aim;
}

bool leads_somewhere(const Aim& aim) { return unit_vector(aim.target - aim.eye) != dvec3{0}; }

bool tells_upright(const Aim& aim) {
  return viewing::sine_between(aim.target - aim.eye, aim.up) >= viewing::least_sine<double>;
}

Camera camera_of(const Aim& aim, double vertical_radians, const Object& object) {
  Camera camera;
  camera.frame = viewing::look_at(aim.eye, aim.target, aim.up);
  camera.lens.vertical_radians = vertical_radians;
  return with_depths(camera, bounds_of(points_of(object)));
}

}  // namespace gradus::pipeline
