#pragma once
// Where a picture is seen from: plain data, and the formulas that projection and ray tracing share.
//
// View space: x right, y up, z forward = depth, the viewer at the origin (docs/conventions.md). Its rows
// right, up, forward with right = forward x up have determinant -1.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"

namespace gradus {

/// Where a viewer stands and how it is turned; right, up and forward have length 1 and stand at right angles.
/// This one stands at the origin and looks along -z, as one looks at a sheet of paper with x right and y up.
template <class T>
struct Frame {
  glm::vec<3, T> eye{T(0), T(0), T(0)};
  glm::vec<3, T> right{T(1), T(0), T(0)};
  glm::vec<3, T> up{T(0), T(1), T(0)};
  glm::vec<3, T> forward{T(0), T(0), T(-1)};
};

/// What a viewer sees: the angle between the lower and the upper edge of the picture, and the depths between
/// which things are drawn.
struct Lens {
  double vertical_radians = 0.6981317007977318;  ///< 40 degrees; in (0, pi)
  double near = 0.1;                             ///< > 0, in world units along the view direction
  double far = 1000;                             ///< > near
};

struct Camera {
  Frame<double> frame;
  Lens lens;
};

/// The four numbers of the perspective transformation that are not 0 or 1:
/// (x, y, z) -> (x_scale x, y_scale y, z_scale z + z_offset, z).
template <class T>
struct Projection {
  T x_scale, y_scale, z_scale, z_offset;
};

/// World space to view space: rows right, up, forward, and in the last column minus their products with eye.
/// (GLM's matrices are written column by column.)
template <class T>
glm::mat<4, 4, T> view_matrix(const Frame<T>& frame) {
  const auto& [eye, right, up, forward] = frame;
  return {{right.x, up.x, forward.x, T(0)},
          {right.y, up.y, forward.y, T(0)},
          {right.z, up.z, forward.z, T(0)},
          {-glm::dot(right, eye), -glm::dot(up, eye), -glm::dot(forward, eye), T(1)}};
}

/// The perspective transformation that takes the near plane to z = 0, the far plane to z = w and the sides of
/// the picture to x = -w, w and y = -w, w.
/// near, far: depths with 0 < near < far. x_scale, y_scale: cotangents of half the angles of view.
/// Accuracy: z = near gives a clip z of exactly 0; where the compiler fuses product and sum (see
///   core/arithmetic/rounding.hpp) it may be off by 2^-53 |z_offset|.
template <class T>
Projection<T> projection_of(T x_scale, T y_scale, T near, T far) {
  const T z_scale = far / (far - near);
  return {x_scale, y_scale, z_scale, -(near * z_scale)};
}

/// The same for a lens; aspect: width / height of the picture, > 0.
/// Errors: ContractViolation for a lens or an aspect that sees nothing.
inline Projection<double> projection_of(const Lens& lens, double aspect) {
  expects(0 < lens.vertical_radians && lens.vertical_radians < 3.141592653589793,
          "the angle of view lies between 0 and pi, not {}", lens.vertical_radians);
  expects(0 < lens.near && lens.near < lens.far && lens.far <= std::numeric_limits<double>::max(),
          "the near plane lies before the far plane and behind neither the eye, not at {} and {}", lens.near,
          lens.far);
  expects(0 < aspect && aspect <= std::numeric_limits<double>::max(), "width / height is positive, not {}",
          aspect);
  const double y_scale = 1 / tan(lens.vertical_radians / 2);
  return projection_of(y_scale / aspect, y_scale, lens.near, lens.far);
}

/// The matrix of the same transformation.
template <class T>
glm::mat<4, 4, T> projection_matrix(const Projection<T>& p) {
  const T o = T(0);
  return {{p.x_scale, o, o, o}, {o, p.y_scale, o, o}, {o, o, p.z_scale, T(1)}, {o, o, p.z_offset, o}};
}

/// origin + t direction, t >= 0.
struct Ray {
  dvec3 origin{0}, direction{0, 0, -1};
};

/// The ray from the eye through a place in the picture; its t is the depth along the view direction.
/// width, height: of the picture in pixels, >= 1. place: continuous, (0, 0) the upper left corner of the
/// upper left pixel, whose centre is (1/2, 1/2).
inline Ray ray_through(const Camera& camera, int width, int height, dvec2 place) {
  expects(width >= 1 && height >= 1, "a picture has at least one pixel, not {} x {}", width, height);
  const Projection<double> p = projection_of(camera.lens, static_cast<double>(width) / height);
  const double x = (2 * place.x / width - 1) / p.x_scale;
  const double y = (1 - 2 * place.y / height) / p.y_scale;
  const Frame<double>& frame = camera.frame;
  return {frame.eye, frame.forward + x * frame.right + y * frame.up};
}

}  // namespace gradus
