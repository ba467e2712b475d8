#pragma once
// Moving, scaling and turning things in space with 4 x 4 matrices. Points are columns: the matrix stands to
// their left, and of a product the right factor acts first.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "core/contract.hpp"
#include "core/elementary.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::affine_3d {

/// A point was taken through a matrix.
template <class T>
struct Transformed {
  glm::vec<3, T> from, to;
};

/// Moves by `by`. Accuracy: exact entries.
template <class T>
glm::mat<4, 4, T> translation(glm::vec<3, T> by) {
  glm::mat<4, 4, T> m(T(1));
  m[3] = glm::vec<4, T>(by.x, by.y, by.z, T(1));
  return m;
}

/// Stretches along the axes from the origin; a negative factor mirrors, 0 flattens.
template <class T>
glm::mat<4, 4, T> scaling(glm::vec<3, T> factors) {
  glm::mat<4, 4, T> m(T(1));
  m[0][0] = factors.x;
  m[1][1] = factors.y;
  m[2][2] = factors.z;
  return m;
}

/// Turns round an axis through the origin, counter-clockwise for whoever the axis points at.
/// Source: O. Rodrigues, Des lois géométriques qui régissent les déplacements d'un système solide, 1840.
/// axis: any length but 0. radians: any finite angle.
/// Accuracy: 1e-15 an entry.
/// Errors: ContractViolation for an axis of length 0.
inline glm::dmat4 rotation(dvec3 axis, double radians) {
  const dvec3 n = unit_vector(axis);
  expects(n != dvec3{0}, "a rotation needs an axis, not the zero vector");
  const auto [s, c] = sin_cos(radians);
  const double half = sin(radians / 2);
  const double k = 2 * half * half;  // 1 - cos, without the cancellation
  return {{c + k * n.x * n.x, k * n.x * n.y + s * n.z, k * n.x * n.z - s * n.y, 0},
          {k * n.x * n.y - s * n.z, c + k * n.y * n.y, k * n.y * n.z + s * n.x, 0},
          {k * n.x * n.z + s * n.y, k * n.y * n.z - s * n.x, c + k * n.z * n.z, 0},
          {0, 0, 0, 1}};
}

/// A point after an affine transformation.
///
/// m: its last row is 0 0 0 1 (not looked at). point: any.
/// Domain: everything.
/// Steps: Transformed.
/// Accuracy: 3 roundings a component; exact for Exact.
/// Cost: 9 multiplications, 9 additions.
/// Errors: none.
template <class T, Observer<Transformed<T>> O = Unobserved>
glm::vec<3, T> transform(const glm::mat<4, 4, T>& m, glm::vec<3, T> point, O&& observer = {}) {
  using Vec = glm::vec<3, T>;
  // Each column times its coordinate
  const Vec x = point.x * Vec(m[0]);
  const Vec y = point.y * Vec(m[1]);
  const Vec z = point.z * Vec(m[2]);
  const Vec to = x + y + z + Vec(m[3]);
  if constexpr (observed<O>) observer(Transformed<T>{point, to});
  return to;
}

/// The matrix that takes normals along: the cofactors of the upper left 3 x 3, which is the inverse transpose
/// times the determinant, and needs no division. Lengths change; directions keep pointing to the outside,
/// also where a factor mirrors. Domain: everything; a matrix of rank 1 gives 0.
template <class T>
glm::mat<3, 3, T> normal_matrix(const glm::mat<4, 4, T>& m) {
  const glm::vec<3, T> x(m[0]), y(m[1]), z(m[2]);
  const glm::mat<3, 3, T> cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  return glm::dot(x, cofactors[0]) < T(0) ? -cofactors : cofactors;
}

/// Whether the transformation turns counter-clockwise into clockwise: its determinant is negative.
template <class T>
bool mirrors(const glm::mat<4, 4, T>& m) {
  const glm::vec<3, T> x(m[0]), y(m[1]), z(m[2]);
  return glm::dot(x, glm::cross(y, z)) < T(0);
}

}  // namespace gradus::affine_3d
