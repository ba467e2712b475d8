#pragma once
// How a camera goes and turns: along its own axes, about itself or about what it looks at.

#include <optional>

#include "core/camera.hpp"
#include "projection/viewing/viewing.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {

/// A step along the viewer's own axes.
/// way: to the right, up and ahead, in world units. Accuracy: 3 ulp of the eye and the way.
inline Frame<double> moved(Frame<double> frame, dvec3 way) {
  frame.eye += way.x * frame.right + way.y * frame.up + way.z * frame.forward;
  return frame;
}

/// The axes of a frame with length 1 and at right angles again, forward kept in direction and up as near as
/// can be: what many small turns have bent.
inline Frame<double> straightened(Frame<double> frame) {
  const dvec3 eye = frame.eye;
  frame = viewing::look_at(dvec3{0}, frame.forward, frame.up);
  frame.eye = eye;
  return frame;
}

/// Turned about an axis through a place, counter-clockwise seen from where the axis points: the eye goes
/// round the place, and looks at it from another side. axis: any length but 0, in world space. Accuracy: the
/// axes stay at right angles within 4 ulp.
inline Frame<double> orbited(const Frame<double>& frame, dvec3 place, dvec3 axis, double radians) {
  const glm::dmat4 turn = affine_3d::rotation(axis, radians);
  const auto direction = [&](dvec3 v) { return dvec3(turn * glm::dvec4(v, 0)); };
  return straightened({place + direction(frame.eye - place), direction(frame.right), direction(frame.up),
                       direction(frame.forward)});
}

/// Turned on the spot: to the left about its own up, positive, or to the right.
inline Frame<double> turned_left(const Frame<double>& frame, double radians) {
  return orbited(frame, frame.eye, frame.up, radians);
}
/// Turned on the spot: upwards about its own right, positive, or downwards.
inline Frame<double> turned_up(const Frame<double>& frame, double radians) {
  return orbited(frame, frame.eye, frame.right, radians);
}

/// Where a ray meets a plane: the t of origin + t direction; nothing where it runs beside it or the plane
/// lies behind its origin. place: any of the plane. normal: of it, any length but 0. Accuracy: where
/// roundings don't decide whether it runs beside, within 5.1 u (sum |d_i n_i| + t sum |r_i n_i|) / |r . n|, d
/// from the origin to the place, r the direction and u = 2^-53.
inline std::optional<double> meets_plane(const Ray& ray, dvec3 place, dvec3 normal) {
  const double slope = glm::dot(ray.direction, normal);
  if (slope == 0) return std::nullopt;
  const double t = glm::dot(place - ray.origin, normal) / slope;
  return t >= 0 ? std::optional(t) : std::nullopt;
}

}  // namespace gradus::pipeline
