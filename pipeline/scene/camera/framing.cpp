#include "scene/camera/framing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/contract.hpp"
#include "projection/viewing/viewing.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {
namespace {

/// Where along an axis of the view the eye, at depth z, has as much above as below it in the picture. Some
/// place between a and b does.
double middle(std::span<const dvec3> seen, int axis, double z, double a, double b) {
  double low = std::min(a, b), high = std::max(a, b);
  constexpr int halvings = 24;
  for (int i = 0; i < halvings; ++i) {
    const double at = low + (high - low) / 2;
    double above = -std::numeric_limits<double>::infinity(), below = above;
    for (const dvec3 v : seen) {
      const double slope = (v[axis] - at) / (v.z - z);
      above = std::max(above, slope);
      below = std::max(below, -slope);
    }
    (above > below ? low : high) = at;
  }
  return low + (high - low) / 2;
}

}  // namespace

dvec3 viewing_side(const Object& object) {
  if (!object.two_sided) return front_right_above;
  // The sum of the area vectors: what a closed mesh lacks
  dvec3 sum{0};
  double area = 0;
  const glm::dmat3 turn = affine_3d::normal_matrix(object.placement);
  const double scale = unit_scale(bounds_of(*object.mesh));
  for (const MeshFace& face : object.mesh->faces) {
    const dvec3 vector = turn * area_vector(*object.mesh, face, scale);
    sum += vector;
    area += length_of(vector);
  }
  const double across = std::max(std::abs(sum.x), std::abs(sum.z));
  if (across < 0.02 * area || across < std::abs(sum.y)) return front_right_above;
  if (std::abs(sum.z) >= std::abs(sum.x)) return sum.z > 0 ? front_right_above : dvec3{0, 0, -1};
  return {sum.x > 0 ? 1.0 : -1.0, 0, 0};
}

Camera framed(std::span<const dvec3> points, double aspect, dvec3 side, double vertical_radians) {
  Bounds bounds;
  for (const dvec3 point : points) bounds.add(point);
  expects(!bounds.empty(), "there is nothing to frame");
  const dvec3 centre = bounds.centre();
  const bool from_above = viewing::sine_between(side, dvec3{0, 1, 0}) < 1e-6;
  const dvec3 up = from_above ? dvec3{0, 0, -1} : dvec3{0, 1, 0};

  Camera camera;
  camera.lens.vertical_radians = vertical_radians;
  camera.frame = viewing::look_at(unit_vector(side), dvec3{0}, up);
  camera.frame.eye = centre;
  const Projection<double> p = projection_of(camera.lens, aspect);
  // The slopes of the picture's borders, less the margin
  const double inside = 0.9;
  const double slope_x = inside / p.x_scale, slope_y = inside / p.y_scale;
  // How far out the planes along the borders, each through the outermost point, cross the axes of the view
  std::vector<dvec3> seen;
  seen.reserve(points.size());
  dvec2 upper{-std::numeric_limits<double>::infinity()}, lower = upper;
  double front = std::numeric_limits<double>::infinity();
  for (const dvec3 point : points) {
    const dvec3 v = viewing::to_view(camera.frame, point);
    upper = {std::max(upper.x, v.x - slope_x * v.z), std::max(upper.y, v.y - slope_y * v.z)};
    lower = {std::max(lower.x, -v.x - slope_x * v.z), std::max(lower.y, -v.y - slope_y * v.z)};
    front = std::min(front, v.z);
    seen.push_back(v);
  }
  // Opposite planes meet where the eye sees both; the farther place sees all. Not into what is seen
  const double radius = bounds.radius();
  double z = std::min(-(upper.x + lower.x) / (2 * slope_x), -(upper.y + lower.y) / (2 * slope_y));
  z = radius > 0 ? std::min(z, front - 0.01 * radius) : front - 1;
  // Far from the origin a little model is hardly larger than the steps between doubles
  z = std::min(z, front - 1e-12 * length_of(centre));
  const double x = middle(seen, 0, z, -lower.x - slope_x * z, upper.x + slope_x * z);
  const double y = middle(seen, 1, z, -lower.y - slope_y * z, upper.y + slope_y * z);
  camera.frame.eye = centre + x * camera.frame.right + y * camera.frame.up + z * camera.frame.forward;
  return with_depths(camera, bounds);
}

Camera framed(const Bounds& bounds, double aspect, dvec3 side, double vertical_radians) {
  expects(!bounds.empty(), "there is nothing to frame: the box is empty");
  const std::array<dvec3, 8> corners = bounds.corners();
  return framed(std::span<const dvec3>(corners), aspect, side, vertical_radians);
}

Camera with_depths(Camera camera, const Bounds& bounds) {
  expects(!bounds.empty(), "there is nothing to see: the box is empty");
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const dvec3 corner : bounds.corners()) {
    const double depth = viewing::to_view(camera.frame, corner).z;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  // A box behind the eye, or that touches it at most, is not seen, with any planes
  constexpr double least = 1e-305;  // a thousandth of it is no zero
  if (farthest <= 1e-30 * bounds.radius() || farthest < least)
    farthest = bounds.radius() >= least ? bounds.radius() : 1;
  camera.lens.far = 1.01 * farthest;
  camera.lens.near = std::max(0.99 * nearest, camera.lens.far / 1000);
  return camera;
}

std::vector<Light> default_lights(const Camera& camera) {
  const Frame<double>& f = camera.frame;
  Light key, fill;
  key.kind = fill.kind = Light::Kind::directional;
  key.direction = f.forward + 0.6 * f.right - 0.8 * f.up;
  key.intensity = LinearRgb{0.7f};
  fill.direction = f.forward - 1.0 * f.right + 0.5 * f.up;
  fill.intensity = LinearRgb{0.25f};
  return {key, fill};
}

Scene scene_of(Mesh mesh, double aspect, std::string name) {
  expects(!mesh.faces.empty(), "a scene needs a model with at least one face");
  Scene scene;
  scene.objects.push_back(object_of(std::move(mesh), std::move(name)));
  const Object& object = scene.objects[0];
  std::vector<dvec3> points;
  points.reserve(object.mesh->corners.size());
  for (const Corner& corner : object.mesh->corners) points.push_back(position_of(*object.mesh, corner));
  scene.camera = framed(std::span<const dvec3>(points), aspect, viewing_side(object));
  scene.lights = default_lights(scene.camera);
  return scene;
}

}  // namespace gradus::pipeline
