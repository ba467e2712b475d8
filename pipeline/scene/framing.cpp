#include "scene/framing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/contract.hpp"
#include "projection/viewing/viewing.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {
namespace {

std::array<dvec3, 8> corners_of(const Bounds& bounds) {
  std::array<dvec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {i & 1 ? bounds.upper.x : bounds.lower.x, i & 2 ? bounds.upper.y : bounds.lower.y,
                  i & 4 ? bounds.upper.z : bounds.lower.z};
  }
  return corners;
}

}  // namespace

dvec3 viewing_side(const Object& object) {
  if (!object.two_sided) return front_right_above;
  // The sum of the area vectors: what a closed mesh lacks
  dvec3 sum{0};
  double area = 0;
  const glm::dmat3 turn = affine_3d::normal_matrix(object.placement);
  for (const Face& face : object.mesh.faces) {
    const dvec3 vector = turn * area_vector(object.mesh, face);
    sum += vector;
    area += glm::length(vector);
  }
  const double across = std::max(std::abs(sum.x), std::abs(sum.z));
  if (across < 0.02 * area || across < std::abs(sum.y)) return front_right_above;
  if (std::abs(sum.z) >= std::abs(sum.x)) return sum.z > 0 ? front_right_above : dvec3{0, 0, -1};
  return {sum.x > 0 ? 1.0 : -1.0, 0, 0};
}

Camera framed(const Bounds& bounds, double aspect, dvec3 side, double vertical_radians) {
  expects(!bounds.empty(), "there is nothing to frame: the box is empty");
  const dvec3 centre = bounds.centre();
  const double radius = bounds.radius() > 0 ? bounds.radius() : 1;
  const bool from_above = viewing::sine_between(side, dvec3{0, 1, 0}) < 1e-6;
  const dvec3 up = from_above ? dvec3{0, 0, -1} : dvec3{0, 1, 0};

  Camera camera;
  camera.lens.vertical_radians = vertical_radians;
  camera.lens.near = radius / 1000;
  camera.lens.far = 1000 * radius;
  const Projection<double> p = projection_of(camera.lens, aspect);
  const double margin = 1.05;
  // As near as the corners allow: a corner (x, y) across and z before the middle asks for x_scale x <= depth,
  // and depth = distance - z
  const Frame<double> frame = viewing::look_at(centre + unit_vector(side), centre, up);
  double distance = 0;
  for (const dvec3 corner : corners_of(bounds)) {
    const dvec3 from_middle = corner - centre;
    const double x = std::abs(glm::dot(frame.right, from_middle)) * p.x_scale;
    const double y = std::abs(glm::dot(frame.up, from_middle)) * p.y_scale;
    const double towards_eye = -glm::dot(frame.forward, from_middle);
    distance = std::max(distance, margin * std::max(x, y) + towards_eye);
  }
  if (distance <= 0) distance = radius;
  camera.frame = frame;
  camera.frame.eye = centre - distance * frame.forward;
  return with_depths(camera, bounds);
}

Camera with_depths(Camera camera, const Bounds& bounds) {
  expects(!bounds.empty(), "there is nothing to see: the box is empty");
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const dvec3 corner : corners_of(bounds)) {
    const double depth = viewing::to_view(camera.frame, corner).z;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  // A box behind the eye is not seen, whatever the planes
  if (farthest <= 0) farthest = bounds.radius() > 0 ? bounds.radius() : 1;
  camera.lens.far = 1.01 * farthest;
  camera.lens.near = std::max(0.99 * nearest, camera.lens.far / 1000);
  return camera;
}

std::vector<Light> default_lights(const Camera& camera, const Bounds&) {
  const Frame<double>& f = camera.frame;
  Light key, fill;
  key.kind = fill.kind = Light::Kind::directional;
  key.direction = f.forward + 0.6 * f.right - 0.8 * f.up;
  key.intensity = Rgb{0.85f};
  fill.direction = f.forward - 1.2 * f.right - 0.1 * f.up;
  fill.intensity = Rgb{0.25f};
  return {key, fill};
}

}  // namespace gradus::pipeline
