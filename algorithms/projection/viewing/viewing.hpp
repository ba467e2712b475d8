#pragma once
// From the world to the viewer: a frame right, up, forward at the eye, and the coordinates of points in it.

#include <concepts>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "core/camera.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::viewing {

/// The view direction has length 1.
template <class T>
struct Aimed {
  glm::vec<3, T> eye, target;
  glm::vec<3, T> forward;  ///< from the eye to the target
};

/// right stands at right angles on the view direction and on the hint for up.
template <class T>
struct Levelled {
  glm::vec<3, T> up_hint;
  glm::vec<3, T> right;
  T sine;  ///< of the angle between the view direction and the hint
};

/// The frame is complete.
template <class T>
struct Framed {
  Frame<T> frame;
};

/// A point of the world has its coordinates in the frame.
template <class T>
struct Viewed {
  glm::vec<3, T> world;
  glm::vec<3, T> view;  ///< right, up, depth
};

/// The sine of the angle between two directions of any length but 0.
template <std::floating_point T>
T sine_between(glm::vec<3, T> a, glm::vec<3, T> b) {
  return glm::length(glm::cross(unit_vector(a), unit_vector(b)));
}

/// The direction of v without what rounding has left of it along n. Domain: n of length 1, v nearly at right
/// angles.
template <std::floating_point T>
glm::vec<3, T> upright_on(glm::vec<3, T> n, glm::vec<3, T> v) {
  const glm::vec<3, T> direction = unit_vector(v);
  return unit_vector(direction - glm::dot(direction, n) * n);
}

/// The least sine of the angle between the view direction and the hint for up that look_at accepts: below it
/// rounding would turn the picture.
template <std::floating_point T>
inline constexpr T least_sine = T(1000) * std::numeric_limits<T>::epsilon();

/// The frame of a viewer at `eye` who looks at `target` and holds the head so that `up` points up in the
/// picture. The notes' camera transformation, with their order right, up, forward.
///
/// eye, target: in world space, apart. up: a hint, of any length but 0, not along the view direction.
///
/// Domain: finite coordinates, target - eye does not overflow.
/// Steps: Aimed Levelled Framed.
/// Accuracy: lengths and right angles to 8 ulp of 1; determinant of right, up, forward -1.
/// Cost: five square roots, two cross products.
/// Errors: ContractViolation when eye and target are the same point, when up has length 0, and when up is
///   parallel to the view direction (their sine is below least_sine).
template <std::floating_point T, Observer<Aimed<T>, Levelled<T>, Framed<T>> O = Unobserved>
Frame<T> look_at(glm::vec<3, T> eye, glm::vec<3, T> target, glm::vec<3, T> up, O&& observer = {}) {
  using Vec = glm::vec<3, T>;
  // Forward: from the eye to the target
  const Vec ahead = unit_vector(target - eye);
  expects(ahead != Vec{T(0)}, "the eye and the target are the same point ({}, {}, {})", eye.x, eye.y, eye.z);
  if constexpr (observed<O>) observer(Aimed<T>{eye, target, ahead});
  // Right: upright on forward and on up
  const Vec hint = unit_vector(up);
  expects(hint != Vec{T(0)}, "up is the zero vector, which points nowhere");
  const Vec across = glm::cross(ahead, hint);
  const T sine = glm::length(across);
  expects(sine >= least_sine<T>, "up ({}, {}, {}) is parallel to the view direction", up.x, up.y, up.z);
  const Vec right = upright_on(ahead, across);
  if constexpr (observed<O>) observer(Levelled<T>{up, right, sine});
  // Up: upright on both
  const Vec above = glm::cross(right, ahead);
  const Frame<T> frame{
      eye,
      right,
      above,
      ahead,
  };
  if constexpr (observed<O>) observer(Framed<T>{frame});
  return frame;
}

/// The coordinates of a point for the viewer: how far right, how far up, how deep.
///
/// Domain: finite.
/// Steps: Viewed.
/// Accuracy: 4 roundings a component, relative to the distance from the eye: eye is subtracted first.
/// Cost: 9 multiplications, 9 additions.
/// Errors: none.
template <class T, Observer<Viewed<T>> O = Unobserved>
glm::vec<3, T> to_view(const Frame<T>& frame, glm::vec<3, T> world, O&& observer = {}) {
  const auto p = world - frame.eye;
  const T x = glm::dot(frame.right, p);
  const T y = glm::dot(frame.up, p);
  const T depth = glm::dot(frame.forward, p);
  const glm::vec<3, T> view{x, y, depth};
  if constexpr (observed<O>) observer(Viewed<T>{world, view});
  return view;
}

}  // namespace gradus::viewing
