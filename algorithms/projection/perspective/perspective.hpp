#pragma once
// The perspective transformation: what is twice as far looks half as large. It multiplies; the division comes
// later, when everything that may not be divided is clipped away.

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/camera.hpp"
#include "core/observe.hpp"

namespace gradus::perspective {

/// A point of view space stands in clip space: -w <= x, y <= w and 0 <= z <= w is what the picture shows.
template <class T>
struct Multiplied {
  glm::vec<3, T> view;
  glm::vec<4, T> clip;  ///< w is the depth
};

/// A point of clip space was divided by its w.
template <class T>
struct Divided {
  glm::vec<4, T> clip;
  glm::vec<3, T> ndc;
};

/// The perspective transformation of one point: x and y by the cotangents of half the angles of view, z so
/// that after division it is a + b / depth, and w = depth. After division lines stay lines and planes stay
/// planes, which they would not with z' = z.
/// Source: J. F. Blinn, A trip down the graphics pipeline, 1996, chapter 18 (the matrix with 0 <= z <= w).
///
/// projection: see projection_of. view: any point, also at or behind the eye.
///
/// Domain: everything.
/// Steps: Multiplied.
/// Accuracy: 1 rounding for x and y, 2 for z, w exact; z = near gives exactly 0.
/// Cost: 3 multiplications, 1 addition, no division.
/// Errors: none.
template <class T, Observer<Multiplied<T>> O = Unobserved>
glm::vec<4, T> transform(const Projection<T>& projection, glm::vec<3, T> view, O&& observer = {}) {
  const auto [sx, sy, sz, shift] = projection;
  const T x = sx * view.x;
  const T y = sy * view.y;
  const T z = sz * view.z + shift;
  const T w = view.z;
  const glm::vec<4, T> clip{x, y, z, w};
  if constexpr (observed<O>) observer(Multiplied<T>{view, clip});
  return clip;
}

/// The division: x / w, y / w, z / w.
///
/// Domain: w > 0, which clipping against the near plane sees to. (Points at or behind the eye have w <= 0;
///   dividing them would mirror them into the picture.)
/// Steps: Divided.
/// Accuracy: 1/2 ulp a component.
/// Cost: 3 divisions.
/// Errors: ContractViolation when w <= 0 or NaN.
template <class T, Observer<Divided<T>> O = Unobserved>
glm::vec<3, T> divide(glm::vec<4, T> clip, O&& observer = {}) {
  expects(clip.w > T(0), "only points before the eye can be divided, this one has a w of 0 or less");
  const T x = clip.x / clip.w;
  const T y = clip.y / clip.w;
  const T z = clip.z / clip.w;
  const glm::vec<3, T> ndc{x, y, z};
  if constexpr (observed<O>) observer(Divided<T>{clip, ndc});
  return ndc;
}

}  // namespace gradus::perspective
