#pragma once
// Exhibits: back faces as lecture notes find them, kept so that a figure can show which ones come out wrong.
// Never use them to cull; back_face_culling.hpp has the right methods.

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

/// FAULTY: the normal is that of the first three corners (errata E001-30). Where the middle one of them is
/// reflex it points the other way; where they lie on a line there is none.
///
/// faces, eye, draw: as normal_and_view.
///
/// Domain: right for convex faces whose first three corners lie on no line.
/// Steps: (NormalFound ViewTaken Judged)* Finished
/// Accuracy: no useful bound; signs are those of rounded products.
/// Cost: a normal and a product a face.
/// Errors: ContractViolation for fewer than 3 corners.
template <class T, class Draw, Observer<NormalFound<T>, ViewTaken<T>, Judged<T>, Finished> O = Unobserved>
void first_three_corners(std::span<const Face<T>> faces, const Eye<T>& eye, Draw&& draw, O&& observer = {}) {
  const std::size_t n = faces.size();
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Face<T> face = faces[i];
    expects(face.size() >= 3, "expected faces of at least 3 corners, found {}", face.size());
    // Any three corners will do?
    const auto p = face[1] - face[0];
    const auto q = face[2] - face[0];
    const auto N = glm::cross(p, q);
    if constexpr (observed<O>) observer(NormalFound<T>{i, N});
    const auto V = view_vector(face, eye);
    if constexpr (observed<O>) observer(ViewTaken<T>{i, face[0], V});
    const T dot = glm::dot(N, V);
    const int sign = sign_of(dot);
    if constexpr (observed<O>) observer(Judged<T>{i, dot, sign, facing_of(sign)});
    drawn += sign > 0;
    if (sign > 0) draw(i);
  }
  if constexpr (observed<O>) observer(Finished{n, drawn});
}

/// FAULTY: the sign of the normal's z in view space is taken for that in the picture (errata E001-39). The
/// sight line to a face runs along z in the picture's middle only.
///
/// faces: in view space, z forward. draw: as normal_and_view.
///
/// Domain: right for parallel projection.
/// Steps: (NormalFound Judged)* Finished
/// Accuracy: no useful bound; signs are those of rounded numbers.
/// Cost: a normal a face.
/// Errors: ContractViolation for fewer than 3 corners.
template <class T, class Draw, Observer<NormalFound<T>, Judged<T>, Finished> O = Unobserved>
void eye_space_normal(std::span<const Face<T>> faces, Draw&& draw, O&& observer = {}) {
  const std::size_t n = faces.size();
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto N = newell_normal(faces[i]);
    if constexpr (observed<O>) observer(NormalFound<T>{i, N});
    // All sight lines run along z?
    const int sign = sign_of(N.z);
    if constexpr (observed<O>) observer(Judged<T>{i, N.z, sign, facing_of(sign)});
    drawn += sign > 0;
    if (sign > 0) draw(i);
  }
  if constexpr (observed<O>) observer(Finished{n, drawn});
}

/// FAULTY: divides by w before anything is clipped, and goes by the area in the picture (errata E001-40), as
/// facing_after_division does of triangles.
///
/// faces: the corners' (x, y, w) in clip space. draw: as normal_and_view.
///
/// Domain: right where no corner lies behind the eye.
/// Steps: Judged* Finished
/// Accuracy: no useful bound; signs are those of rounded numbers. With w = 0 there is no area, and no side.
/// Cost: 2 divisions a corner.
/// Errors: ContractViolation for fewer than 3 corners.
template <class T, class Draw, Observer<Judged<T>, Finished> O = Unobserved>
void after_division(std::span<const Face<T>> faces, Draw&& draw, O&& observer = {}) {
  using Vec = glm::vec<2, T>;
  const std::size_t n = faces.size();
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Face<T> face = faces[i];
    expects(face.size() >= 3, "expected faces of at least 3 corners, found {}", face.size());
    T area{0};
    // Not clipped: w may be negative
    const Vec a = Vec(face[0]) / face[0].z;
    const std::size_t last = face.size() - 1;
    for (std::size_t k = 1; k < last; ++k) {
      const auto& b = face[k];
      const auto& c = face[k + 1];
      const Vec p = Vec(b) / b.z - a;
      const Vec q = Vec(c) / c.z - a;
      area += p.x * q.y - q.x * p.y;
    }
    const int sign = sign_of(area);
    if constexpr (observed<O>) observer(Judged<T>{i, area, sign, facing_of(sign)});
    drawn += sign > 0;
    if (sign > 0) draw(i);
  }
  if constexpr (observed<O>) observer(Finished{n, drawn});
}

/// FAULTY: the area with a misprint in its first term, x1 y1 for x1 y2 (errata E002-10).
///
/// faces: outlines in the picture, y up. draw: as normal_and_view.
///
/// Domain: right where the first two corners are at one height, or the first lies at x = 0.
/// Steps: Judged* Finished
/// Accuracy: no useful bound.
/// Cost: 2 products a corner.
/// Errors: ContractViolation for fewer than 3 corners.
template <class T, class Draw, Observer<Judged<T>, Finished> O = Unobserved>
void misprinted_shoelace(std::span<const Outline<T>> faces, Draw&& draw, O&& observer = {}) {
  const std::size_t n = faces.size();
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Outline<T> face = faces[i];
    expects(face.size() >= 3, "expected faces of at least 3 corners, found {}", face.size());
    const std::size_t m = face.size();
    const auto first = face[0];
    const auto second = face[1];
    // Misprinted: x1 y1 for x1 y2
    T area = first.x * first.y;
    area -= second.x * first.y;
    for (std::size_t k = 1; k < m; ++k) {
      const auto a = face[k];
      const auto b = face[(k + 1) % m];
      area += a.x * b.y - b.x * a.y;
    }
    const int sign = sign_of(area);
    if constexpr (observed<O>) observer(Judged<T>{i, area, sign, facing_of(sign)});
    drawn += sign > 0;
    if (sign > 0) draw(i);
  }
  if constexpr (observed<O>) observer(Finished{n, drawn});
}

/// FAULTY: the area by products of coordinates as they stand, six for a triangle (errata E002-12). Far from
/// the origin they cancel.
///
/// faces: outlines in the picture, y up. draw: as normal_and_view.
///
/// Domain: right where the area is large beside the rounding of the products.
/// Steps: Judged* Finished
/// Accuracy: the area is off by some u times the square of the coordinates, whatever its size.
/// Cost: 2 products a corner.
/// Errors: ContractViolation for fewer than 3 corners.
template <class T, class Draw, Observer<Judged<T>, Finished> O = Unobserved>
void six_products(std::span<const Outline<T>> faces, Draw&& draw, O&& observer = {}) {
  const std::size_t n = faces.size();
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Outline<T> face = faces[i];
    expects(face.size() >= 3, "expected faces of at least 3 corners, found {}", face.size());
    const std::size_t m = face.size();
    T right{0}, left{0};
    // No corner is subtracted first
    for (std::size_t k = 0; k < m; ++k) {
      const auto a = face[k];
      const auto b = face[(k + 1) % m];
      right += a.x * b.y;
      left += b.x * a.y;
    }
    const T area = right - left;
    const int sign = sign_of(area);
    if constexpr (observed<O>) observer(Judged<T>{i, area, sign, facing_of(sign)});
    drawn += sign > 0;
    if (sign > 0) draw(i);
  }
  if constexpr (observed<O>) observer(Finished{n, drawn});
}

}  // namespace gradus::back_face_culling
