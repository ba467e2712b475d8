#pragma once
// Which side of a triangle the viewer sees.

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/arithmetic/exact.hpp"
#include "core/observe.hpp"

namespace gradus::back_face_culling {

/// What the viewer sees of a triangle.
enum class Facing {
  front,    ///< its corners run counter-clockwise in the picture, y up
  back,     ///< clockwise: the inside of a closed body, never seen
  edge_on,  ///< the eye lies in its plane, or it has no area
};

/// The sign was taken.
template <class T>
struct Tested {
  glm::vec<4, T> a, b, c;  ///< in clip space
  int sign;                ///< of the determinant
  Facing facing;
};

/// The sign of det[a b c] of the corners' (x, y, w): -1, 0 or +1, without rounding.
/// It is six times the volume of the pyramid from the eye to the triangle, with its sign.
template <class T>
int determinant_sign(glm::vec<4, T> a, glm::vec<4, T> b, glm::vec<4, T> c) {
  using Vec = glm::vec<3, T>;
  // orient3d has the fourth point as its apex, here the eye, and the opposite sign
  return -orient3d(Vec{a.x, a.y, a.w}, Vec{b.x, b.y, b.w}, Vec{c.x, c.y, c.w}, Vec{T(0), T(0), T(0)});
}

/// Which side of the triangle a, b, c faces the viewer, told before any division: for w > 0 the determinant
/// has the sign of the area in the picture, and it stays right when corners lie behind the eye, where the
/// area does not.
/// Source: M. Olano, T. Greer, Triangle scan conversion using 2D homogeneous coordinates, 1997, section 4.
///
/// a, b, c: corners in clip space, counter-clockwise seen from outside.
///
/// Domain: finite, any w, also 0 and negative.
/// Steps: Tested.
/// Accuracy: exact; float, double and Exact decide alike.
/// Cost: about 6 ns, in doubt about 1 us.
/// Errors: ContractViolation for coordinates that are not finite.
template <class T, Observer<Tested<T>> O = Unobserved>
Facing facing(glm::vec<4, T> a, glm::vec<4, T> b, glm::vec<4, T> c, O&& observer = {}) {
  // det[x y w], whatever the signs of w
  const int sign = determinant_sign(a, b, c);
  Facing facing = Facing::edge_on;
  if (sign > 0) facing = Facing::front;
  if (sign < 0) facing = Facing::back;
  if constexpr (observed<O>) observer(Tested<T>{a, b, c, sign, facing});
  return facing;
}

}  // namespace gradus::back_face_culling
