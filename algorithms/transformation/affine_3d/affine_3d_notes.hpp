#pragma once
// What the notes do in space, where it is wrong: exhibits for a lecture, not for use.

#include <glm/vec4.hpp>

#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::affine_3d {

/// A point was multiplied from the wrong side.
template <class T>
struct RowTransformed {
  Point<T> from;
  glm::vec<4, T> to;  ///< the fourth coordinate should be 1
};

/// A point's four coordinates, to stand to the left of a matrix.
template <class T>
glm::vec<4, T> as_row(Point<T> point) {
  return {point, T(1)};
}

/// FAULTY: a point as a row, to the left of a matrix that is made for columns.
/// The notes print rotations for columns and a translation for rows, and use both for rows (errata E002-01).
///
/// Domain: right for scalings only. Rotations turn backwards; a translation moves nothing and spoils the
///   fourth coordinate instead: (1, 2, 3, 1) by (5, 6, 7) becomes (1, 2, 3, 39).
template <class T>
glm::vec<4, T> transform_row(Point<T> point, const Matrix<T>& m) {
  return as_row(point) * m;
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
    // It stands on the wrong side
    auto to = as_row(p) * product;
    if constexpr (observed<O>) observer(RowTransformed<T>{p, to});
    p = Point<T>(to);
  }
  return product;
}

/// A camera was put where its car is, plus an offset.
template <class T>
struct OffsetAdded {
  Point<T> offset, to;
};

/// FAULTY but for offsets along the axis: a camera on a car that turns, at the car's position plus a constant
/// offset (errata E000-14).
///
/// car: where the car is. camera: where the camera is before the car turns about n by an angle.
///
/// Domain: right for offsets parallel to n.
///   A mount that turns with the car takes (1, 0, 2) to (0, 1, 2) after a quarter turn about z; here it
///   stays (1, 0, 2).
/// Steps: OffsetAdded.
/// Accuracy: none.
/// Cost: 3 subtractions, 3 additions.
template <class T, Observer<OffsetAdded<T>> O = Unobserved>
Point<T> constant_offset(Point<T> /*n*/, Point<T> car, const Turn<T>& /*turn*/, Point<T> camera,
                         O&& observer = {}) {
  const auto offset = camera - car;
  // The car has turned,
  // the offset has not
  const auto to = car + offset;
  if constexpr (observed<O>) observer(OffsetAdded<T>{offset, to});
  return to;
}

}  // namespace gradus::affine_3d
