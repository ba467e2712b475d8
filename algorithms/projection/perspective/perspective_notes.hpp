#pragma once
// An exhibit: the lecture notes' perspective transformation, which keeps z as it is. Never use it where depth
// is interpolated; perspective.hpp has transform and divide.

#include "projection/perspective/perspective.hpp"

namespace gradus::perspective {

/// FAULTY for depth between corners: the notes' perspective transformation, x' = d x / z, y' = d y / z,
/// z' = z. It does take the frustum to a box and keeps the order of depths, but it bends every line and plane
/// that is not parallel to the picture: between its corners, depth on the screen is no straight line, and
/// whoever interpolates it there sees the wrong surface (errata E001-38).
///
/// d: the plane's distance, > 0. point: any.
///
/// Domain: as project; nothing for z <= 0.
/// Steps: Scaled Projected | Scaled? Unseen.
/// Accuracy: the image as project. Interpolated half-way between two points' images, depth is too large by
///   (z1 - z0)^2 / (2 (z0 + z1)), at worst by (sqrt(z1) - sqrt(z0))^2: the line (0,0,1)-(2,0,3) is at 1.5
///   half-way (d = 1, x' = 1/3) and at 2 at x' = 1/2, interpolated depth says 2 and 2.5.
/// Cost: as project.
/// Errors: ContractViolation when d <= 0 or NaN.
template <class T, Observer<Scaled<T>, Projected<T>, Unseen<T>> O = Unobserved>
std::optional<glm::vec<3, T>> keep_z(T d, glm::vec<3, T> point, O&& observer = {}) {
  expects(d > T(0), "the picture plane lies before the eye, at a distance above 0");
  if (!(point.z > T(0))) {
    if constexpr (observed<O>) observer(Unseen<T>{point});
    return std::nullopt;
  }
  const T factor = d / point.z;
  if constexpr (observed<O>) observer(Scaled<T>{point, factor});
  const T x = point.x * factor;
  const T y = point.y * factor;
  if (!finite(x) || !finite(y)) {
    if constexpr (observed<O>) observer(Unseen<T>{point});
    return std::nullopt;
  }
  const T z = point.z;
  const glm::vec<3, T> image{x, y, z};
  if constexpr (observed<O>) observer(Projected<T>{point, image});
  return image;
}

}  // namespace gradus::perspective
