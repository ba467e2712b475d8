#pragma once
// What the notes print about transformations in the plane, where it is wrong: an exhibit for a lecture, not
// for use.

#include "transformation/affine_2d/affine_2d.hpp"

namespace gradus::affine_2d {

/// Whether a factor slants the axes and nothing else: each axis keeps its own coordinate.
template <class T>
bool is_shear(const Factor<T>& factor) {
  return factor.linear[0].x == T(1) && factor.linear[1].y == T(1) && factor.linear != glm::mat<2, 2, T>(T(1));
}

/// FAULTY for every centre but (0, 0): a shear about a point with the centre added though x and y, which
/// stay, never had it subtracted: (x + factors.x (y - about.y) + about.x, y + factors.y (x - about.x) +
/// about.y). The notes' formula (errata E001-13).
///
/// Domain: right for the centre (0, 0). The pivot (1, 1) goes to (2, 2), and no shear at all still moves
///   every point by the centre: (3, 4) to (4, 5).
template <class T>
Factor<T> shearing_centre_added(Point<T> factors, Point<T> about) {
  auto factor = shearing(factors, about);
  // Added once more
  factor.shift = about;
  return factor;
}

/// FAULTY where a shear has a pivot: `one_matrix` with the notes' shears, see shearing_centre_added.
///
/// factors, points: as for one_matrix. Factors that are no shears act as they should.
///
/// Domain: right where no shear has a pivot but (0, 0).
/// Steps: as one_matrix.
/// Accuracy: none: every point is off by the pivot.
/// Cost: as one_matrix.
template <class T, Observer<Started<T>, Multiplied<T>, Moved<T>> O = Unobserved>
Matrix<T> centre_added(std::span<const Factor<T>> factors, std::span<Point<T>> points, O&& observer = {}) {
  Matrix<T> product(T(1));
  if constexpr (observed<O>) observer(Started<T>{product, {points.begin(), points.end()}});
  for (const auto& factor : factors) {
    auto f = factor;
    if (is_shear(f)) {
      // The centre comes back in,
      // though it was never taken out
      f.shift = f.shift + f.pivot;
    }
    const auto m = matrix(f);
    product = m * product;
    if constexpr (observed<O>) observer(Multiplied<T>{number_of(factor, factors), m, product});
  }
  for (Point<T>& p : points) {
    const auto from = p;
    p = transform(product, from);
    if constexpr (observed<O>) observer(Moved<T>{number_of<Point<T>>(p, points), from, p});
  }
  return product;
}

}  // namespace gradus::affine_2d
