#pragma once
// An exhibit: back faces as lecture notes find them, by the picture and before anything is clipped, kept so
// that a figure can show which ones come out wrong. Never use it to cull; back_face_culling.hpp has the right
// one.

#include <glm/vec2.hpp>

#include "visibility/back_face_culling/back_face_culling.hpp"

namespace gradus::back_face_culling {

/// Twice the area that the corners enclose after the division, y up. Corners with w < 0 lie behind the eye
/// and come out mirrored.
template <class T>
T area_after_division(glm::vec<4, T> a, glm::vec<4, T> b, glm::vec<4, T> c) {
  using Vec = glm::vec<2, T>;
  const Vec p = Vec(a) / a.w, q = Vec(b) / b.w, r = Vec(c) / c.w;
  return (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
}

template <class T>
int sign_of(const T& area) {
  return (area > 0) - (area < 0);
}

/// The side that an area with y up tells; no number tells none.
template <class T>
Facing side_of(const T& area) {
  const int sign = sign_of(area);
  if (sign == 0) return Facing::edge_on;
  return sign > 0 ? Facing::front : Facing::back;
}

/// FAULTY: divides first and goes by the area in the picture (errata E001-40). With one or three corners
/// behind the eye, w < 0, the area has the wrong sign: a front face is culled, a back face is kept. Clipping
/// comes too late to mend that.
///
/// a, b, c: corners in clip space, counter-clockwise seen from outside.
///
/// Domain: as facing; right where no corner lies behind the eye.
/// Steps: Tested.
/// Accuracy: no useful bound: the sign of the product of the three w is the error, and areas are rounded. A
///   corner with w = 0 has no place in the picture, and the triangle counts as seen edge-on.
/// Cost: 3 divisions.
/// Errors: none.
template <class T, Observer<Tested<T>> O = Unobserved>
Facing facing_after_division(glm::vec<4, T> a, glm::vec<4, T> b, glm::vec<4, T> c, O&& observer = {}) {
  // Not clipped: w may be negative
  const T area = area_after_division(a, b, c);
  if constexpr (observed<O>) observer(Tested<T>{a, b, c, sign_of(area), side_of(area)});
  if (area > 0) return Facing::front;
  if (area < 0) return Facing::back;
  return Facing::edge_on;
}

}  // namespace gradus::back_face_culling
