#pragma once
// What the notes do with matrices in space, where it is wrong: an exhibit for a lecture, not for use.

#include <glm/vec4.hpp>

#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::affine_3d {

/// A point was multiplied from the wrong side.
template <class T>
struct RowTransformed {
  Point<T> from;
  glm::vec<4, T> to;  ///< the fourth coordinate should be 1
};

/// FAULTY: a point as a row, to the left of a matrix that is made for columns.
/// The notes print rotations for columns and a translation for rows, and use both for rows (errata E002-01).
///
/// Domain: right for scalings alone. Rotations turn backwards; a translation moves nothing and spoils the
///   fourth coordinate instead: (1, 2, 3, 1) by (5, 6, 7) becomes (1, 2, 3, 39).
template <class T>
glm::vec<4, T> transform_row(Point<T> point, const Matrix<T>& m) {
  return glm::vec<4, T>(point, T(1)) * m;
}

/// FAULTY but for scalings: `one_matrix` with points as rows, see transform_row.
///
/// factors, points: as for one_matrix; of the points that come out the fourth coordinate is dropped.
///
/// Domain: right for scalings.
/// Steps: Started Multiplied* RowTransformed*.
/// Accuracy: none.
/// Cost: as one_matrix.
template <class T, Observer<Started<T>, Multiplied<T>, RowTransformed<T>> O = Unobserved>
Matrix<T> row_vectors(std::span<const Matrix<T>> factors, std::span<Point<T>> points, O&& observer = {}) {
  Matrix<T> product(T(1));
  if constexpr (observed<O>) observer(Started<T>{product, {points.begin(), points.end()}});
  for (const Matrix<T>& m : factors) {
    product = compose(m, product);
    if constexpr (observed<O>) observer(Multiplied<T>{number_of(m, factors), m, product});
  }
  for (Point<T>& p : points) {
    const auto from = p;
    // The point stands on the wrong side
    const auto to = transform_row(p, product);
    p = Point<T>(to);
    if constexpr (observed<O>) observer(RowTransformed<T>{from, to});
  }
  return product;
}

}  // namespace gradus::affine_3d
