#pragma once
// Moving, scaling and turning things in space with 4 x 4 matrices. Points are columns with a fourth
// coordinate 1: the matrix stands to their left, and the right factor of a product acts first.
//
// World space is right-handed: a turn round an axis is counter-clockwise for a viewer it points at, so
// the turn round z takes x to y, round x y to z, round y z to x.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/exact.hpp"
#include "core/arithmetic/finite.hpp"
#include "core/arithmetic/turn.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::affine_3d {

template <class T>
using Point = glm::vec<3, T>;
template <class T>
using Matrix = glm::mat<4, 4, T>;

/// A point was taken through a matrix.
template <class T>
struct Transformed {
  Point<T> from, to;
};

// --- Matrices ----------------------------------------------------

/// Moves by `by`. Accuracy: exact entries. Errors: ContractViolation for numbers that are not finite.
template <class T>
Matrix<T> translation(Point<T> by) {
  expects(all_finite(by.x, by.y, by.z), "a translation needs finite numbers");
  Matrix<T> m(T(1));
  m[3] = glm::vec<4, T>(by, T(1));
  return m;
}

/// Stretches along the axes from the origin; a negative factor mirrors, 0 flattens.
/// Accuracy: exact entries. Errors: as translation.
template <class T>
Matrix<T> scaling(Point<T> factors) {
  expects(all_finite(factors.x, factors.y, factors.z), "a scaling needs finite numbers");
  Matrix<T> m(T(1));
  m[0][0] = factors.x;
  m[1][1] = factors.y;
  m[2][2] = factors.z;
  return m;
}

/// (x, c y - s z, s y + c z): y turns to z. Accuracy: the entries are those of the turn.
template <class T>
Matrix<T> rotation_x(const Turn<T>& turn) {
  Matrix<T> m(T(1));
  m[1] = {T(0), turn.cos, turn.sin, T(0)};
  m[2] = {T(0), T(0) - turn.sin, turn.cos, T(0)};
  return m;
}

/// (c x + s z, y, -s x + c z): z turns to x. The sines change their places with the order of the axes.
template <class T>
Matrix<T> rotation_y(const Turn<T>& turn) {
  Matrix<T> m(T(1));
  m[0] = {turn.cos, T(0), T(0) - turn.sin, T(0)};
  m[2] = {turn.sin, T(0), turn.cos, T(0)};
  return m;
}

/// (c x - s y, s x + c y, z): x turns to y.
template <class T>
Matrix<T> rotation_z(const Turn<T>& turn) {
  Matrix<T> m(T(1));
  m[0] = {turn.cos, turn.sin, T(0), T(0)};
  m[1] = {T(0) - turn.sin, turn.cos, T(0), T(0)};
  return m;
}

/// Turns round an axis through the origin: cos I + (1 - cos) n n^T + sin [n]x.
/// Source: O. Rodrigues, Des lois géométriques qui régissent les déplacements d'un système solide, 1840.
/// n: of length 1 (not checked).
/// Accuracy: beside the roundings of n and the turn, an entry is within 3 u (1 + 2 u) of the sum of its
///   absolute terms, |c| + |k x x| or |k x y| + |s z|, u the rounding unit of T (2^-53 for double), but for
///   what underflows; exact for Exact.
template <class T>
Matrix<T> rodrigues(Point<T> n, const Turn<T>& turn) {
  const T s = turn.sin, c = turn.cos, k = turn.versine;
  Matrix<T> m(T(1));
  m[0] = {c + k * n.x * n.x, k * n.x * n.y + s * n.z, k * n.x * n.z - s * n.y, T(0)};
  m[1] = {k * n.x * n.y - s * n.z, c + k * n.y * n.y, k * n.y * n.z + s * n.x, T(0)};
  m[2] = {k * n.x * n.z + s * n.y, k * n.y * n.z - s * n.x, c + k * n.z * n.z, T(0)};
  return m;
}

/// The same with the matrix K of n x: I + sin K + (1 - cos) K^2, for K^2 = n n^T - I.
template <class T>
Matrix<T> rodrigues_by_cross_products(Point<T> n, const Turn<T>& turn) {
  const T zero = T(0);
  const glm::mat<3, 3, T> k{zero, n.z, zero - n.y, zero - n.z, zero, n.x, n.y, zero - n.x, zero};
  return Matrix<T>(glm::mat<3, 3, T>(T(1)) + turn.sin * k + turn.versine * (k * k));
}

/// The direction of an axis, of length 1.
/// axis: any finite length but 0, 1e-200 and 1e200 as good as 1.
/// Errors: ContractViolation for the zero vector, infinite numbers and NaN.
template <std::floating_point T>
Point<T> direction_of(Point<T> axis) {
  expects(all_finite(axis.x, axis.y, axis.z), "a rotation needs an axis with finite numbers");
  expects(axis != Point<T>(T(0)), "a rotation needs an axis, not the zero vector");
  return unit_vector(axis);
}

/// How far two columns are from what those of a rotation make: 1 or 0, minus a . b.
/// Source: T. Ogita, S. M. Rump, S. Oishi, Accurate sum and dot product, 2005. Accuracy: 1e-30.
inline double missing_product(dvec3 a, dvec3 b, double wanted) {
  double sum = wanted, lost = 0;
  for (int i = 0; i < 3; ++i) {
    const Rounded product = two_product(-a[i], b[i]);
    const Rounded total = two_sum(sum, product.value);
    sum = total.value;
    lost += total.error + product.error;
  }
  return sum + lost;
}

/// The same rotation with the roundings of its making taken out: a step of Newton's towards R^T R = I.
/// Source: A. Bjorck, C. Bowie, An iterative algorithm for computing the best estimate of an orthogonal
/// matrix, 1971. Domain: within 1e-8 of a rotation. Accuracy: orthogonal to 2 ulp of 1.
inline glm::dmat4 polished(const glm::dmat4& m) {
  const dvec3 x(m[0]), y(m[1]), z(m[2]);
  const double xx = missing_product(x, x, 1) / 2, yy = missing_product(y, y, 1) / 2;
  const double zz = missing_product(z, z, 1) / 2, xy = missing_product(x, y, 0) / 2;
  const double yz = missing_product(y, z, 0) / 2, zx = missing_product(z, x, 0) / 2;
  glm::dmat4 better = m;
  better[0] = glm::dvec4(x + (xx * x + xy * y + zx * z), m[0].w);
  better[1] = glm::dvec4(y + (xy * x + yy * y + yz * z), m[1].w);
  better[2] = glm::dvec4(z + (zx * x + yz * y + zz * z), m[2].w);
  return better;
}

/// Turns round an axis through the origin.
/// axis: any finite length but 0, 1e-200 and 1e200 as good as 1. radians: any finite angle.
/// Accuracy: 1e-15 per entry. Orthogonal: no entry of R^T R - I is above 4 ulp of 1, that is 4 times 2^-52
///   (rodrigues alone: 10).
/// Errors: ContractViolation for an axis of length 0 and for numbers that are not finite.
inline glm::dmat4 rotation(dvec3 axis, double radians) {
  return polished(rodrigues(direction_of(axis), turn(radians)));
}
/// The same in float, computed in double and rounded once: 4 times 2^-23.
template <std::same_as<float> T>
glm::mat4 rotation(glm::vec<3, T> axis, T radians) {
  return glm::mat4(rotation(dvec3(axis), double{radians}));
}

/// A transformation about a point, which stays where it is: T(centre) M T(-centre).
/// Accuracy: a coordinate of the last column is within 5 u (1 + 4 u) of the sum of its absolute terms; the
///   others are copied. Exact for Exact. Domain: finite numbers whose products neither overflow nor
///   underflow.
template <class T>
Matrix<T> about(Point<T> centre, Matrix<T> m) {
  const Point<T> x(m[0]), y(m[1]), z(m[2]), c = centre;
  const Point<T> moved = c - (c.x * x + c.y * y + c.z * z) + Point<T>(m[3]);
  m[3] = glm::vec<4, T>(moved, T(1));
  return m;
}

// The three of the pipeline report

/// T(by).
template <class T>
Matrix<T> translate(Point<T> by) {
  return translation(by);
}

/// Turns round an axis through `centre`.
/// axis, radians: as for rotation. centre: finite.
/// Accuracy: that of rotation; the last column that of about.
/// Errors: as rotation.
inline glm::dmat4 rotate(dvec3 axis, double radians, dvec3 centre = dvec3{0}) {
  expects(all_finite(centre.x, centre.y, centre.z), "a rotation needs a centre with finite numbers");
  return about(centre, rotation(axis, radians));
}

/// The product in which `second` acts second: its columns are those of `first`, moved.
/// Accuracy: an entry is within 4 u (1 + 3 u) of the sum of its absolute terms; exact for Exact. Domain: as
///   about.
template <class T>
Matrix<T> compose(const Matrix<T>& second, const Matrix<T>& first) {
  return second * first;
}

/// A point after an affine transformation.
///
/// m: its last row is 0 0 0 1 (not looked at). point: any.
/// Domain: finite numbers whose products don't overflow.
/// Steps: Transformed.
/// Accuracy: a coordinate is within 4 u (1 + 3 u) of |xx x| + |xy y| + |xz z| + |x0|, likewise in y and z,
///   and half the smallest number of T for each product that underflows; exact for Exact.
/// Cost: 9 multiplications, 9 additions.
/// Errors: none.
template <class T, Observer<Transformed<T>> O = Unobserved>
Point<T> transform(const Matrix<T>& m, Point<T> point, O&& observer = {}) {
  // Each column times its coordinate
  const Point<T> x = point.x * Point<T>(m[0]);
  const Point<T> y = point.y * Point<T>(m[1]);
  const Point<T> z = point.z * Point<T>(m[2]);
  const Point<T> to = x + y + z + Point<T>(m[3]);
  if constexpr (observed<O>) observer(Transformed<T>{point, to});
  return to;
}

/// Whether the transformation turns counter-clockwise into clockwise: its determinant is negative.
/// Domain: finite entries of any size (others are refused). Accuracy: exact. Cost: as orient3d.
template <class T>
bool mirrors(const glm::mat<4, 4, T>& m) {
  const Point<T> x(m[0]), y(m[1]), z(m[2]);
  return orient3d(Point<T>(T(0)), x, y, z) < 0;
}

/// A matrix times the power of two that makes its largest entry at least 1 and less than 2; the zero matrix,
/// and those of scalars that have no range to leave, as they are.
template <class T>
glm::mat<3, 3, T> fitted(glm::mat<3, 3, T> m) {
  if constexpr (std::floating_point<T>) {
    const auto largest = [](const Point<T>& v) {
      return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    };
    const int exponent = Scaled<T>({largest(m[0]), largest(m[1]), largest(m[2])}).exponent;
    for (int i = 0; i < 9; ++i) m[i / 3][i % 3] = std::scalbn(m[i / 3][i % 3], -exponent);
  }
  return m;
}

/// The matrix that takes normals along: the cofactors of the upper left 3 x 3, which is the inverse transpose
/// times the determinant, and needs no division. Lengths change; directions keep pointing to the outside,
/// also where a factor mirrors.
/// Domain: entries of any size, but what is less than 2^-500 (in float 2^-60) of the largest may count as 0:
///   a matrix of floating-point numbers is scaled by a power of two first. A matrix of rank 1 gives 0.
/// Accuracy: an entry is within 2 u (1 + u) of the sum of the two products it is the difference of; exact for
///   Exact.
/// Errors: ContractViolation for entries that are not finite.
template <class T>
glm::mat<3, 3, T> normal_matrix(const glm::mat<4, 4, T>& m) {
  const glm::mat<3, 3, T> linear = fitted(glm::mat<3, 3, T>(m));
  const glm::vec<3, T> x = linear[0], y = linear[1], z = linear[2];
  const glm::mat<3, 3, T> cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  return mirrors(m) ? -cofactors : cofactors;
}

// --- A product of many -------------------------------------------

/// Nothing has acted yet.
template <class T>
struct Started {
  Matrix<T> product;
  std::vector<Point<T>> points;  ///< as they were given
};

/// One more factor acts: it came to the product from the left.
template <class T>
struct Multiplied {
  std::size_t factor;  ///< its number, in the order of acting, from 0
  Matrix<T> matrix, product;
};

/// The number of an element of a span.
template <class T>
std::size_t number_of(const T& element, std::span<const T> all) {
  return static_cast<std::size_t>(&element - all.data());
}

/// Takes points through a chain of transformations by way of one matrix: multiplied once, used for every
/// point.
/// Source: J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics, 2nd edition 1990, 5.6-5.7.
///
/// factors: in the order in which they act; factors[0] stands rightmost. points: any; replaced in place.
///
/// Domain: everything finite; no factor or no point is fine.
/// Steps: Started Multiplied* Transformed*; Multiplied once per factor, Transformed once per point.
/// Accuracy: that of compose for each factor, of transform at the end; exact for Exact.
/// Cost: 64 multiplications per factor, 9 per point.
/// Errors: none.
template <class T, Observer<Started<T>, Multiplied<T>, Transformed<T>> O = Unobserved>
Matrix<T> one_matrix(std::span<const Matrix<T>> factors, std::span<Point<T>> points, O&& observer = {}) {
  // Nothing acts yet
  Matrix<T> product(T(1));
  if constexpr (observed<O>) observer(Started<T>{product, {points.begin(), points.end()}});
  for (const auto& m : factors) {
    // Later factors go to the left
    product = compose(m, product);
    if constexpr (observed<O>) observer(Multiplied<T>{number_of(m, factors), m, product});
  }
  // One matrix serves all points
  for (Point<T>& p : points) {
    p = transform(product, p, observer);
  }
  return product;
}

// --- A turn round any axis, by parts -----------------------------

/// The turns that bring an axis onto z: round x into the xz plane, then round y. Nothing where it is there.
template <class T>
struct Alignment {
  std::optional<Turn<T>> x, y;
};

/// How this axis comes to lie along z. No angle is computed: sine and cosine are ratios of its coordinates.
/// axis: any finite length but 0. Accuracy: 4 ulp. Errors: as direction_of.
template <std::floating_point T>
Alignment<T> alignment(Point<T> axis) {
  const Point<T> n = direction_of(axis);
  const auto [across, d] = directed(Point<T>(T(0), n.y, n.z));
  Alignment<T> found;
  if (n.y != 0) found.x = turn_of(across.y, across.z);
  const T z = n.y != 0 ? d : n.z;
  if (n.x != 0 || z < 0) found.y = turn_of(T(0) - n.x, z);
  return found;
}

/// What a factor of the decomposition does.
enum class Part { to_origin, into_plane, onto_z, turn, off_z, out_of_plane, back };

/// One more factor of the decomposition stands in the product.
template <class T>
struct Decomposed {
  Part part;
  Matrix<T> matrix, product;
};

/// Turns round any axis by turns round x, y and z alone: the axis is brought onto z, the turn is made there,
/// and all that came before is undone in the opposite order.
/// Source: J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics, 2nd edition 1990, 5.7.
///
/// p: a point on the axis. to: the turns that bring its direction onto z. turn: the angle.
///
/// Domain: everything finite.
/// Steps: Decomposed*, seven for an axis in general position: to_origin into_plane onto_z turn off_z
///   out_of_plane back; without into_plane and out_of_plane for an axis in the xz plane, without onto_z and
///   off_z for one in the yz plane.
/// Accuracy: linear entries within 8 ulp of 1 of rodrigues; exact for Exact.
/// Cost: up to 6 products of matrices.
/// Errors: none.
template <class T, Observer<Decomposed<T>> O = Unobserved>
Matrix<T> decomposition(Point<T> p, const Alignment<T>& to, const Turn<T>& turn, O&& observer = {}) {
  // The axis comes to the origin
  auto m = translation(T(0) - p);
  auto product = m;
  if constexpr (observed<O>) observer(Decomposed<T>{Part::to_origin, m, product});
  // About x into the xz plane
  if (to.x) {
    m = rotation_x(*to.x);
    product = m * product;
    if constexpr (observed<O>) observer(Decomposed<T>{Part::into_plane, m, product});
  }
  // About y onto z
  if (to.y) {
    m = rotation_y(*to.y);
    product = m * product;
    if constexpr (observed<O>) observer(Decomposed<T>{Part::onto_z, m, product});
  }
  // There the turn is about z
  m = rotation_z(turn);
  product = m * product;
  if constexpr (observed<O>) observer(Decomposed<T>{Part::turn, m, product});
  // The way back, last factor first
  if (to.y) {
    m = rotation_y(reversed(*to.y));
    product = m * product;
    if constexpr (observed<O>) observer(Decomposed<T>{Part::off_z, m, product});
  }
  if (to.x) {
    m = rotation_x(reversed(*to.x));
    product = m * product;
    if constexpr (observed<O>) observer(Decomposed<T>{Part::out_of_plane, m, product});
  }
  m = translation(p);
  product = m * product;
  if constexpr (observed<O>) observer(Decomposed<T>{Part::back, m, product});
  return product;
}

// --- The same without a matrix -----------------------------------

/// The part of a point's vector along the axis: it will stay.
template <class T>
struct Projected {
  Point<T> p, r;  ///< from a point on the axis; r = (p . n) n
};
/// The part across the axis: it will turn.
template <class T>
struct Rejected {
  Point<T> s;  ///< p - r
};
/// Where s would be after a quarter turn.
template <class T>
struct Crossed {
  Point<T> v;  ///< n x s
};
/// The point is where the turn takes it.
template <class T>
struct Turned {
  Point<T> to;
};

/// One point turned round any axis, by vectors.
/// Source: O. Rodrigues, 1840; the drawing is that of most textbooks.
///
/// n: the axis, of length 1 (not checked). through: a point on it. point: any.
///
/// Domain: everything finite; a point on the axis stays.
/// Steps: Projected Rejected Crossed Turned.
/// Accuracy: 8 ulp of |through| + |point - through|; exact for Exact.
/// Cost: 18 multiplications.
/// Errors: none.
template <class T, Observer<Projected<T>, Rejected<T>, Crossed<T>, Turned<T>> O = Unobserved>
Point<T> turn_vector(Point<T> n, Point<T> through, const Turn<T>& turn, Point<T> point, O&& observer = {}) {
  const auto p = point - through;
  // Along the axis nothing moves
  const auto r = dot(p, n) * n;
  if constexpr (observed<O>) observer(Projected<T>{p, r});
  // The rest turns on a circle
  const auto s = p - r;
  if constexpr (observed<O>) observer(Rejected<T>{s});
  // A quarter turn on, as long as s
  const auto v = cross(n, s);
  if constexpr (observed<O>) observer(Crossed<T>{v});
  const T cos = turn.cos;
  const T sin = turn.sin;
  const auto t = cos * s + sin * v;
  const auto to = through + (r + t);
  if constexpr (observed<O>) observer(Turned<T>{to});
  return to;
}

/// a x b with products whose rounding errors are kept, so that it is right also where they cancel.
/// Domain: components of about 1 beside smaller ones. Accuracy: 2 ulp per component, down to 2^-1000.
inline dvec3 accurate_cross(dvec3 a, dvec3 b) {
  const auto minor = [&](int i, int j) {
    const Rounded left = two_product(a[i], b[j]), right = two_product(a[j], b[i]);
    const Rounded high = two_difference(left.value, right.value);
    const Rounded low = two_difference(left.error, right.error);
    return (high.value + low.value) + (high.error + low.error);
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

/// A rotation matrix whose columns have drifted from length 1 and from right angles, as repeated products do,
/// made orthogonal again: the first column keeps its direction, the second its plane with the first; the
/// third is put at right angles to both.
/// Source: E. Schmidt, 1907 (Gram-Schmidt).
/// Domain: finite columns of any size, the first two not parallel, however small the angle between them.
///   (What is less than 2^-1022 of a column's largest component may count as 0.)
/// Accuracy: orthogonal to 2 ulp of 1. The first column's direction and the normal of its plane with the
///   second are kept to 2 ulp of 1. In float, computed in double and rounded once, these are 2 times 2^-23.
/// Cost: about 0.3 us.
/// Errors: ContractViolation where the first two columns are parallel or a number is not finite.
template <std::floating_point T>
Matrix<T> orthonormalized(const Matrix<T>& m) {
  const dvec3 first(m[0]), second(m[1]);
  expects(all_finite(first.x, first.y, first.z, second.x, second.y, second.z),
          "only columns with finite numbers can be made orthogonal");
  // Right also where the columns are nearly parallel
  const dvec3 normal = accurate_cross(Scaled<double>(first).vector, Scaled<double>(second).vector);
  expects(normal != dvec3(0), "the first two columns of a rotation are not parallel");
  const dvec3 x = unit_vector(first), z = unit_vector(normal);
  glm::dmat4 clean(m);
  clean[0] = glm::dvec4(x, clean[0].w);
  clean[1] = glm::dvec4(glm::cross(z, x), clean[1].w);
  clean[2] = glm::dvec4(z, clean[2].w);
  return Matrix<T>(polished(clean));
}

}  // namespace gradus::affine_3d
