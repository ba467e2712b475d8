#pragma once
// An exhibit: the lecture notes' matrix of "parallel projection", which knows one direction only. Never use
// it for another; parallel.hpp has oblique and along.

#include "projection/parallel/parallel.hpp"

namespace gradus::parallel {

/// A row of a matrix, and the column that it is multiplied by.
template <class T>
using Row = glm::vec<4, T>;

/// FAULTY for every slant but 0: the notes' matrix, titled parallel projection. It keeps x and y whatever the
/// direction of the projectors, so a box seen at a slant shows its front alone, and every receding edge is
/// one point. Right for orthographic projection along z (errata E001-19).
///
/// d, slant, p: as for oblique. The slant is not looked at.
///
/// Domain: right for slant (0, 0).
/// Steps: Cast Projected.
/// Accuracy: off by |d - z| times the length of the slant.
/// Cost: as the product of a 4 x 4 matrix and a point.
/// Errors: none.
template <class T, Observer<Cast<T>, Projected<T>> O = Unobserved>
Point<T> keep_x_and_y(T d, Slant<T>, Point<T> p, O&& observer = {}) {
  // The printed rows
  const Row<T> row_x{1, 0, 0, 0};
  const Row<T> row_y{0, 1, 0, 0};
  const Row<T> row_z{0, 0, 0, d};
  const Row<T> column(p, 1);
  if constexpr (observed<O>) observer(Cast<T>{p, d - p.z});
  const T x = dot(row_x, column);
  const T y = dot(row_y, column);
  const T z = dot(row_z, column);
  const Point<T> image{x, y, z};
  if constexpr (observed<O>) observer(Projected<T>{p, image});
  return image;
}

}  // namespace gradus::parallel
