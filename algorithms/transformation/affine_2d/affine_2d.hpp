#pragma once
// Moving, scaling, turning, shearing and mirroring in the plane with 3 x 3 matrices.
//
// Points are columns with a third coordinate 1: the matrix stands to their left, and the right factor of a
// product acts first. A transformation about a point is the one about the origin between two translations,
// T(pivot) M T(-pivot), so that the pivot stays where it is.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/exact.hpp"
#include "core/arithmetic/finite.hpp"
#include "core/arithmetic/turn.hpp"
#include "core/arithmetic/unbounded.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"

namespace gradus::affine_2d {

template <class T>
using Point = glm::vec<2, T>;
template <class T>
using Matrix = glm::mat<3, 3, T>;

// --- Factors -----------------------------------------------------

/// What a product of transformations is made of: a linear map that leaves its pivot where it is, then a
/// shift. Kept apart, pivot and shift can be measured from any origin before they are rounded into a matrix.
template <class T>
struct Factor {
  glm::mat<2, 2, T> linear{T(1)};
  Point<T> pivot{T(0)};  ///< stays where it is
  Point<T> shift{T(0)};  ///< comes last
};

/// (x + by.x, y + by.y). Accuracy: exact entries. Errors: ContractViolation for numbers that are not finite.
template <class T>
Factor<T> translation(Point<T> by) {
  expects(all_finite(by.x, by.y), "a translation needs finite numbers");
  return {.shift = by};
}

/// Stretches along the axes, away from `about`. One negative factor mirrors, two make a half turn, 0
/// flattens. Only |x| = |y| > 0 keeps the shape of all figures. Accuracy: exact entries. Errors: as
/// translation.
template <class T>
Factor<T> scaling(Point<T> factors, Point<T> about = Point<T>(T(0))) {
  expects(all_finite(factors.x, factors.y, about.x, about.y), "a scaling needs finite numbers");
  return {.linear = {factors.x, T(0), T(0), factors.y}, .pivot = about};
}

/// Turns counter-clockwise round `about`. Accuracy: that of `turn`; multiples of 90 degrees are exact.
/// Errors: as translation; an angle that is no number was refused when the turn was made.
template <class T>
Factor<T> rotation(const Turn<T>& turn, Point<T> about = Point<T>(T(0))) {
  expects(all_finite(turn.sin, turn.cos, about.x, about.y), "a rotation needs finite numbers");
  return {.linear = {turn.cos, turn.sin, T(0) - turn.sin, turn.cos}, .pivot = about};
}

/// (x + factors.x (y - about.y), y + factors.y (x - about.x)): slants the axes. Its determinant is
/// 1 - factors.x factors.y, so the two together may flatten the plane: (2, 1/2) does. It is not the product
/// of the two shears along one axis each. Accuracy: exact entries. Errors: as translation.
template <class T>
Factor<T> shearing(Point<T> factors, Point<T> about = Point<T>(T(0))) {
  expects(all_finite(factors.x, factors.y, about.x, about.y), "a shear needs finite numbers");
  return {.linear = {T(1), factors.y, factors.x, T(1)}, .pivot = about};
}

/// (x, -y)
template <class T>
Factor<T> reflection_in_x_axis() {
  return scaling(Point<T>(T(1), T(-1)));
}
/// (-x, y)
template <class T>
Factor<T> reflection_in_y_axis() {
  return scaling(Point<T>(T(-1), T(1)));
}
/// (-x, -y): a half turn, for two mirrors make a rotation.
template <class T>
Factor<T> reflection_in_origin() {
  return scaling(Point<T>(T(-1), T(-1)));
}
/// (y, x): the mirror is the line y = x.
template <class T>
Factor<T> reflection_in_diagonal() {
  return {.linear = {T(0), T(1), T(1), T(0)}};
}

/// A power of two near 1 / |v|: times it, v's squares neither overflow nor vanish, and nothing is rounded.
/// 1 for the zero vector, and for scalars that have no range to leave.
template <class T>
T fitting_scale(Point<T> v) {
  if constexpr (std::floating_point<T>) {
    const T largest = std::max(std::abs(v.x), std::abs(v.y));
    constexpr int most = std::numeric_limits<T>::max_exponent - 2;
    if (largest > 0) return std::scalbn(T(1), std::clamp(-std::ilogb(largest), -most, most));
  }
  return T(1);
}

/// The mirror is the line through two points. With its direction (x, y) the map is
/// 1 / (x^2 + y^2) times (x^2 - y^2, 2xy; 2xy, y^2 - x^2); no angle is needed.
/// Accuracy: 4 ulp of 1 per entry beside the line through `a` along the rounded b - a; exact for Exact.
/// Errors: ContractViolation where a = b, or for numbers that are not finite.
template <class T>
Factor<T> reflection_in_line(Point<T> a, Point<T> b) {
  Point<T> d = b - a;
  expects(all_finite(a.x, a.y, d.x, d.y), "a mirror needs two points with finite numbers, not too far apart");
  expects(a != b, "a mirror needs two different points");
  d = d * fitting_scale(d);
  const T square = d.x * d.x + d.y * d.y;
  const T cos = (d.x - d.y) * (d.x + d.y) / square;
  const T sin = T(2) * d.x * d.y / square;
  return {.linear = {cos, sin, sin, T(0) - cos}, .pivot = a};
}

/// The factor as a matrix: T(shift) T(pivot) L T(-pivot). Its last column is pivot - L pivot + shift.
/// Accuracy: the linear entries are copied, the last column has 4 roundings: far from the origin it loses
/// what a far pivot costs, see local_coordinates. Exact for Exact.
template <class T>
Matrix<T> matrix(const Factor<T>& factor) {
  const Point<T> x = factor.linear[0], y = factor.linear[1], c = factor.pivot;
  const Point<T> moved = c - (c.x * x + c.y * y) + factor.shift;
  return {x.x, x.y, T(0), y.x, y.y, T(0), moved.x, moved.y, T(1)};
}

/// A point under one factor, the pivot subtracted first.
template <class T>
Point<T> transform(const Factor<T>& factor, Point<T> point) {
  const Point<T> from_pivot = point - factor.pivot;
  return from_pivot.x * factor.linear[0] + from_pivot.y * factor.linear[1] + factor.pivot + factor.shift;
}

/// The same for many points, in place.
template <class T>
void apply(const Factor<T>& factor, std::span<Point<T>> points) {
  for (Point<T>& p : points) p = transform(factor, p);
}

/// A point under an affine matrix.
/// m: its last row is 0 0 1 (not looked at).
/// Accuracy: 3 ulp of |xx x| + |xy y| + |x0| in x, likewise in y; exact for Exact. Cost: 4 multiplications.
template <class T>
Point<T> transform(const Matrix<T>& m, Point<T> point) {
  return point.x * Point<T>(m[0]) + point.y * Point<T>(m[1]) + Point<T>(m[2]);
}

/// The product in which b acts first, a second.
template <class T>
Matrix<T> compose(const Matrix<T>& a, const Matrix<T>& b) {
  return a * b;
}

/// The factor by which areas grow; negative where it mirrors, 0 where it flattens. Accuracy: 2 ulp of the
/// larger of its products. Where these leave T's range it may be 0, infinite or NaN; flattens is right there,
/// too.
template <class T>
T determinant(const Matrix<T>& m) {
  return m[0].x * m[1].y - m[1].x * m[0].y;
}

// --- The product -------------------------------------------------

/// Nothing has acted yet: the product of no factors.
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

/// A point was taken through the whole product.
template <class T>
struct Moved {
  std::size_t point;  ///< its number
  Point<T> from, to;
};

/// Keeps the points as they were before they move.
template <class T>
struct PointsBefore {
  std::vector<Point<T>> points{};

  template <class Step>
  Step operator()(const Step& step) {
    points = step.points;
    return step;
  }
  Moved<T> operator()(Moved<T> step) {
    step.from = points[step.point];
    return step;
  }
};

/// The number of an element of a span.
template <class T>
std::size_t number_of(const T& element, std::span<const T> all) {
  return static_cast<std::size_t>(&element - all.data());
}

/// Takes points through a chain of factors by way of one matrix: multiplied once, used for every point.
/// Source: J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics, 2nd edition 1990, 5.3.
///
/// factors: in the order in which they act; factors[0] stands rightmost. points: any; replaced in place.
///
/// Domain: everything finite; no factor or no point is fine.
/// Steps: Started Multiplied* Moved*; Multiplied once per factor, Moved once per point.
/// Accuracy: each product rounds its entries by at most 4 ulp of the sum of its absolute terms; exact for
///   Exact. A far pivot costs more: see local_coordinates.
/// Cost: 12 multiplications per factor (27 as a full product), 4 per point.
/// Errors: none.
template <class T, Observer<Started<T>, Multiplied<T>, Moved<T>> O = Unobserved>
Matrix<T> one_matrix(std::span<const Factor<T>> factors, std::span<Point<T>> points, O&& observer = {}) {
  Tally<O, PointsBefore<T>> tally(observer);
  // Nothing acts yet
  Matrix<T> product(T(1));
  if constexpr (observed<O>) observer(tally.count(Started<T>{product, {points.begin(), points.end()}}));
  for (const auto& f : factors) {
    // Later factors go to the left
    const auto m = matrix(f);
    product = m * product;
    if constexpr (observed<O>) observer(Multiplied<T>{number_of(f, factors), m, product});
  }
  // One matrix serves all points
  for (Point<T>& p : points) {
    p = transform(product, p);
    if constexpr (observed<O>) observer(tally.count(Moved<T>{number_of<Point<T>>(p, points), {}, p}));
  }
  return product;
}

// --- Its rivals --------------------------------------------------

/// One factor has acted on every point.
template <class T>
struct Acted {
  std::size_t factor;
  std::vector<Point<T>> points;  ///< where they are now
};

/// Takes every point through every factor, the pivot subtracted each time. No product is made.
///
/// factors, points: as for one_matrix.
///
/// Domain: everything finite.
/// Steps: Started Acted*; Acted once per factor.
/// Accuracy: 5 roundings per coordinate and factor, none of them by the pivot where point and pivot are near
///   each other, but for the place that comes out, which is stored rounded. Exact for Exact.
/// Cost: 4 multiplications per point and factor.
/// Errors: none.
template <class T, Observer<Started<T>, Acted<T>> O = Unobserved>
void factor_by_factor(std::span<const Factor<T>> factors, std::span<Point<T>> points, O&& observer = {}) {
  if constexpr (observed<O>) observer(Started<T>{Matrix<T>(T(1)), {points.begin(), points.end()}});
  for (const auto& f : factors) {
    const auto c = f.pivot;
    for (Point<T>& p : points) {
      // From the pivot, and back
      const auto d = p - c;
      p = f.linear * d + c;
      p = p + f.shift;
    }
    if constexpr (observed<O>) observer(Acted<T>{number_of(f, factors), {points.begin(), points.end()}});
  }
}

/// Points and pivots are measured from the origin.
template <class T>
struct Rebased {
  Point<T> origin;
  std::vector<Point<T>> points;  ///< from there
};

/// The same far away from (0, 0): subtracts an origin near the points and the pivots first, and leaves the
/// points in those local coordinates, for the sum origin + point would round them again.
///
/// origin: any; a pivot, say. factors, points: as for one_matrix; the points come out relative to origin.
///
/// Domain: everything finite.
/// Steps: Rebased Multiplied* Moved*.
/// Accuracy: as one_matrix, of the local coordinates: with the pivot (1e12, 1e12) and a point beside it 1 ulp
///   where one_matrix is 5.9e-5 off. Exact for Exact.
/// Cost: as one_matrix, and a subtraction per point and factor.
/// Errors: none.
template <class T, Observer<Rebased<T>, Multiplied<T>, Moved<T>> O = Unobserved>
Matrix<T> local_coordinates(Point<T> origin, std::span<const Factor<T>> factors, std::span<Point<T>> points,
                            O&& observer = {}) {
  Tally<O, PointsBefore<T>> tally(observer);
  // Everything seen from the origin
  for (Point<T>& p : points) {
    p -= origin;
  }
  if constexpr (observed<O>) observer(tally.count(Rebased<T>{origin, {points.begin(), points.end()}}));
  Matrix<T> product(T(1));
  for (const auto& f : factors) {
    auto local = f;
    local.pivot -= origin;
    // Later factors go to the left
    const auto m = matrix(local);
    product = m * product;
    if constexpr (observed<O>) observer(Multiplied<T>{number_of(f, factors), m, product});
  }
  for (Point<T>& p : points) {
    p = transform(product, p);
    if constexpr (observed<O>) observer(tally.count(Moved<T>{number_of<Point<T>>(p, points), {}, p}));
  }
  return product;
}

// --- The way back ------------------------------------------------

namespace detail {

/// Whether products of four such entries, and quotients with determinants of them, stay normal numbers: they
/// are 0, or at least 2^-n and at most 2^n (n is 240 for double, 24 for float).
template <std::floating_point T, class... Entries>
bool are_moderate(Entries... entries) {
  using Limits = std::numeric_limits<T>;
  constexpr int n = (Limits::max_exponent - Limits::digits - 8) / 4;
  const T least = std::ldexp(T(1), -n), most = std::ldexp(T(1), n);
  const auto moderate = [=](T x) { return (least <= std::abs(x) && std::abs(x) <= most) || x == 0; };
  return (moderate(entries) && ...);
}

/// The products of a determinant, in any numbers.
template <class Number>
struct Products {
  Number left, right;

  Products(Number xx, Number xy, Number yx, Number yy) : left(unfused(xx * yy)), right(unfused(yx * xy)) {}
  Number determinant() const { return left - right; }
  bool agree(Number ulp) const {
    using std::abs;
    return !(abs(left - right) > (abs(left) + abs(right)) * ulp);
  }
};

/// inverse, in the numbers that `number` makes of T.
template <class T, class ToNumber>
std::optional<Matrix<T>> inverse_in(const Matrix<T>& m, ToNumber number) {
  const auto zero = number(T(0));
  const auto xx = number(m[0].x), xy = number(m[0].y), yx = number(m[1].x), yy = number(m[1].y);
  const Products products(xx, xy, yx, yy);
  if (products.agree(number(std::numeric_limits<T>::epsilon()))) return std::nullopt;
  const auto det = products.determinant();
  // Adjugate over determinant, row by row
  const auto to_x_from_x = yy / det, to_x_from_y = (zero - yx) / det;
  const auto to_y_from_x = (zero - xy) / det, to_y_from_y = xx / det;
  // The shift is taken back first
  const auto x = number(m[2].x), y = number(m[2].y);
  const auto back_x = zero - (unfused(to_x_from_x * x) + unfused(to_x_from_y * y));
  const auto back_y = zero - (unfused(to_y_from_x * x) + unfused(to_y_from_y * y));
  const Matrix<T> back{in_range(to_x_from_x), in_range(to_y_from_x), T(0),
                       in_range(to_x_from_y), in_range(to_y_from_y), T(0),
                       in_range(back_x),      in_range(back_y),      T(1)};
  if (!all_finite(back[0].x, back[0].y, back[1].x, back[1].y, back[2].x, back[2].y)) return std::nullopt;
  return back;
}

/// A number as it is, and without bounds to its exponent.
struct Itself {
  template <class T>
  T operator()(T x) const {
    return x;
  }
};
struct Boundless {
  template <class T>
  auto operator()(T x) const {
    return unbounded(x);
  }
};

}  // namespace detail

/// Whether a matrix flattens the plane, as far as its entries can tell: the two products of its determinant
/// agree, or differ by so little that changing each entry by half an ulp (of 53 bits, also among subnormals)
/// could make it 0. (A shear by 3 and 1/3 does flatten, though 1/3 is rounded.) For Exact: det = 0.
/// Domain: finite entries of any size.
template <class T>
bool flattens(const glm::mat<2, 2, T>& linear) {
  const detail::Products products(unbounded(linear[0].x), unbounded(linear[0].y), unbounded(linear[1].x),
                                  unbounded(linear[1].y));
  return products.agree(unbounded(std::numeric_limits<T>::epsilon()));
}

/// The matrix that undoes m: adjugate over determinant. Nothing where m flattens the plane, and where an
/// entry would be beyond T, as for a scaling by 1e-310.
///
/// m: its last row is 0 0 1 (not looked at).
/// Domain: finite entries of any size, also where products of them overflow or vanish.
/// Accuracy: 4 ulp per entry, those of the last column of the sum of their absolute terms, times how far the
///   determinant cancels: (|xx yy| + |xy yx|) / |det|; and half the smallest number of T where an entry comes
///   out subnormal. Exact for Exact.
/// Cost: 10 multiplications, 4 divisions. Where an entry is neither 0 nor from 2^-240 to 2^240 (of floats,
///   2^-24 to 2^24) their exponents are kept apart, which takes 10 to 15 times as long, 0.2 us,
///   and gives the same bits.
/// Errors: ContractViolation for entries that are not finite.
template <class T>
std::optional<Matrix<T>> inverse(const Matrix<T>& m) {
  expects(all_finite(m[0].x, m[0].y, m[1].x, m[1].y, m[2].x, m[2].y), "only finite numbers have an inverse");
  if constexpr (std::floating_point<T>) {
    if (detail::are_moderate<T>(m[0].x, m[0].y, m[1].x, m[1].y, m[2].x, m[2].y)) {
      return detail::inverse_in(m, detail::Itself{});
    }
  }
  return detail::inverse_in(m, detail::Boundless{});
}

/// The factor that undoes this one: the shift first, so its pivot moves along. Nothing where inverse gives
/// nothing. Accuracy, Errors: as inverse.
template <class T>
std::optional<Factor<T>> inverse(const Factor<T>& factor) {
  // L'(p - shift - pivot) + pivot
  Matrix<T> about_pivot(factor.linear);
  about_pivot[2] = glm::vec<3, T>(factor.shift, T(1));
  const std::optional<Matrix<T>> back = inverse(about_pivot);
  if (!back) return std::nullopt;
  return Factor<T>{glm::mat<2, 2, T>(*back), factor.pivot, Point<T>((*back)[2])};
}

/// A factor has been undone.
template <class T>
struct Undone {
  std::size_t factor;
  Matrix<T> matrix;              ///< its inverse
  std::vector<Point<T>> points;  ///< where they are now
};

/// A factor can't be undone: it has no inverse in T.
struct Stuck {
  std::size_t factor;
};

/// Takes points back through a chain of factors: the last one is undone first. (A B)^-1 = B^-1 A^-1.
///
/// factors, points: as for one_matrix; the points are those that came out.
///
/// Domain: everything finite. Returns whether all could be undone; if not, the points stay where the factor
///   without an inverse has put them.
/// Steps: Undone* Stuck?
/// Accuracy: as inverse, a factor.
/// Cost: an inverse per factor, 4 multiplications per point and factor.
/// Errors: none.
template <class T, Observer<Undone<T>, Stuck> O = Unobserved>
bool undo(std::span<const Factor<T>> factors, std::span<Point<T>> points, O&& observer = {}) {
  // The last that acted goes first
  std::size_t k = factors.size();
  while (k-- > 0) {
    const auto& last = factors[k];
    const auto back = inverse(last);
    // None where points became one
    if (!back) {
      if constexpr (observed<O>) observer(Stuck{k});
      return false;
    }
    apply(*back, points);
    if constexpr (observed<O>) observer(Undone<T>{k, matrix(*back), {points.begin(), points.end()}});
  }
  return true;
}

/// The rotation nearest to a product of rotations that has drifted: the mean of the two turns its columns
/// say, with length 1 again. Translation and last row are kept.
/// Source: the polar decomposition of a 2 x 2 matrix with positive determinant, in closed form.
/// Domain: det > 0, told exactly; entries of any size up to half the largest number of T.
/// Accuracy: orthogonal to 3 ulp of 1. Errors: ContractViolation where det <= 0 or an entry is not finite.
template <std::floating_point T>
Matrix<T> nearest_rotation(const Matrix<T>& m) {
  expects(all_finite(m[0].x, m[0].y, m[1].x, m[1].y), "a rotation has finite numbers");
  expects(orient2d(Point<T>(T(0)), Point<T>(m[0]), Point<T>(m[1])) > 0,
          "only what doesn't mirror or flatten is near a rotation");
  const glm::vec<3, T> mean = unit_vector(glm::vec<3, T>(m[0].x + m[1].y, m[0].y - m[1].x, T(0)));
  return {mean.x, mean.y, T(0), T(0) - mean.y, mean.x, T(0), m[2].x, m[2].y, T(1)};
}

}  // namespace gradus::affine_2d
