#pragma once
// An exhibit: the lecture notes' matrix of "parallel projection", which knows one direction only. Never use
// it for another; parallel.hpp has oblique and along.

#include "projection/parallel/parallel.hpp"

namespace gradus::parallel {

/// FAULTY for every slant but 0: the notes' matrix, titled parallel projection. It keeps x and y whatever the
/// direction of the projectors, so a box seen at a slant shows its front alone, and every receding edge is
/// one point. Right for orthographic projection along z (errata E001-19).
///
/// d, slant, point: as for oblique. The slant is not looked at.
///
/// Domain: right for slant (0, 0).
/// Steps: Cast Projected.
/// Accuracy: off by |d - z| times the length of the slant.
/// Cost: as the product of a 4 x 4 matrix and a point.
/// Errors: none.
template <class T, Observer<Cast<T>, Projected<T>> O = Unobserved>
glm::vec<3, T> keep_x_and_y(T d, Slant<T>, glm::vec<3, T> point, O&& observer = {}) {
  const T o = T(0), i = T(1);
  if constexpr (observed<O>) observer(Cast<T>{point, d - point.z});
  // The printed rows
  const glm::vec<4, T> row_x{i, o, o, o};
  const glm::vec<4, T> row_y{o, i, o, o};
  const glm::vec<4, T> row_z{o, o, o, d};
  const glm::vec<4, T> p(point, i);
  const T x = glm::dot(row_x, p);
  const T y = glm::dot(row_y, p);
  const T z = glm::dot(row_z, p);
  const glm::vec<3, T> image{x, y, z};
  if constexpr (observed<O>) observer(Projected<T>{point, image});
  return image;
}

}  // namespace gradus::parallel
