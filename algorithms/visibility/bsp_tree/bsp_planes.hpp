#pragma once
// The planes of a BSP tree: on which side of one a point lies, exactly, and where an edge meets it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/arithmetic/exact.hpp"
#include "core/arithmetic/two_doubles.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"

namespace gradus::bsp_tree {

/// A plane through three points; in front of it is where they run counter-clockwise. It is as thick as the
/// polygon that gave it is uneven: what lies between that one's own corners lies in its plane.
template <class T>
struct Plane {
  glm::vec<3, T> a{}, b{}, c{};
  glm::vec<3, T> highest{}, lowest{};  ///< corners farthest in front and behind; a where none lies beside it

  Plane() = default;
  Plane(glm::vec<3, T> its_a, glm::vec<3, T> its_b, glm::vec<3, T> its_c)
      : a(its_a), b(its_b), c(its_c), highest(its_a), lowest(its_a) {}
};

namespace detail {

/// Adds factor * det(u, v, w), or takes it away.
template <int Factors, class... Factor>
void add_determinant(SumOfProducts<Factors>& sum, bool minus, dvec3 u, dvec3 v, dvec3 w, Factor... factor) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (minus) {
      sum.subtract(u[i], v[j], w[k], factor...);
      sum.add(u[i], v[k], w[j], factor...);
    } else {
      sum.add(u[i], v[j], w[k], factor...);
      sum.subtract(u[i], v[k], w[j], factor...);
    }
  }
}

/// Adds factor * det(b - a, c - a, p - a), which is six times the volume above the plane, multiplied out.
template <int Factors, class... Factor>
void add_volume(SumOfProducts<Factors>& sum, bool minus, const Plane<double>& at, dvec3 p, Factor... factor) {
  add_determinant(sum, minus, at.b, at.c, p, factor...);
  add_determinant(sum, !minus, at.a, at.c, p, factor...);
  add_determinant(sum, minus, at.a, at.b, p, factor...);
  add_determinant(sum, !minus, at.a, at.b, at.c, factor...);
}

inline Plane<double> in_double(const Plane<float>& at) { return {dvec3(at.a), dvec3(at.b), dvec3(at.c)}; }

}  // namespace detail

/// Which of two points is higher above a plane's three points, exactly: +1 p, -1 q, 0 neither.
inline int compare_heights(const Plane<double>& plane, const glm::dvec3& p, const glm::dvec3& q) {
  SumOfProducts<3> difference;
  detail::add_volume(difference, false, plane, p);
  detail::add_volume(difference, true, plane, q);
  return difference.sign();
}
inline int compare_heights(const Plane<float>& plane, const glm::vec3& p, const glm::vec3& q) {
  return compare_heights(detail::in_double(plane), dvec3(p), dvec3(q));
}
template <class T>
int compare_heights(const Plane<T>& plane, const glm::vec<3, T>& p, const glm::vec<3, T>& q) {
  const T difference = glm::dot(glm::cross(plane.b - plane.a, plane.c - plane.a), p - q);
  return (difference > T{0}) - (difference < T{0});
}

/// Makes a plane so thick that these points lie in it.
template <class T>
void thicken(Plane<T>& plane, const std::vector<glm::vec<3, T>>& points) {
  for (const auto& point : points) {
    const int side = orient3d(plane.a, plane.b, plane.c, point);
    if (side > 0 && compare_heights(plane, point, plane.highest) > 0) plane.highest = point;
    if (side < 0 && compare_heights(plane, point, plane.lowest) < 0) plane.lowest = point;
  }
}

/// The plane of a polygon, through three corners that lie on no line: those of the largest triangle from the
/// first corner on, so that their rounding turns it least.
/// Domain: as Polygon. Errors: ContractViolation for corners without an inside.
template <class T>
Plane<T> plane_of(const std::vector<glm::vec<3, T>>& p) {
  expects(p.size() >= 3, "expected polygons of at least 3 corners, found {}", p.size());
  std::size_t best = 1;
  T largest{0};
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const auto normal = glm::cross(p[i] - p[0], p[i + 1] - p[0]);
    const T size = glm::dot(normal, normal);
    if (size > largest) {
      largest = size;
      best = i;
    }
  }
  expects(largest > T{0}, "expected polygons with an inside, found one of {} corners without", p.size());
  Plane<T> plane{p[0], p[best], p[best + 1]};
  thicken(plane, p);
  return plane;
}

/// The side of a plane on which a point lies, exactly: +1 in front, -1 behind, 0 in it.
struct ExactSide {
  template <class T>
  int operator()(const Plane<T>& plane, const glm::vec<3, T>& point) const {
    const int side = orient3d(plane.a, plane.b, plane.c, point);
    const auto& border = side > 0 ? plane.highest : plane.lowest;
    if (side == 0 || border == plane.a) return side;
    return compare_heights(plane, point, border) == side ? side : 0;
  }
};

namespace detail {

/// det(b - a, c - a, p - a) in 106 bits, and the sizes of its terms.
/// Accuracy: 2^-97 of the terms. Domain: points that are tame.
struct Height {
  Rounded value{0, 0};
  double terms = 0;
};
inline Height height_above(const Plane<double>& at, dvec3 p) {
  const auto from_a = [&](dvec3 v, int i) { return two_difference(v[i], at.a[i]); };
  Height height;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Rounded plus = product_of_pairs(from_a(at.b, j), from_a(at.c, k));
    const Rounded minus = product_of_pairs(from_a(at.b, k), from_a(at.c, j));
    const Rounded along = from_a(p, i), normal = sum_of_pairs(plus, negated(minus));
    height.value = sum_of_pairs(height.value, product_of_pairs(normal, along));
    height.terms += (std::abs(plus.value) + std::abs(minus.value)) * std::abs(along.value);
  }
  return height;
}

/// Whether products of a point's coordinates lose nothing that matters by underflow, nor overflow.
inline bool is_tame(const dvec3& p) {
  return std::abs(p.x) < 0x1p300 && std::abs(p.y) < 0x1p300 && std::abs(p.z) < 0x1p300;
}

/// The double nearest to (q d_p - p d_q) / (d_p - d_q), if 106 bits can tell. Domain: points that are tame.
inline std::optional<double> nearest_crossing(const Height& d_p, const Height& d_q, double p, double q) {
  // Between p and q nothing cancels: all errors together are less than `off`, also where products underflow
  const double size = std::max(std::abs(p), std::abs(q));
  if (size == 0) return 0.0;
  const Rounded whole = sum_of_pairs(d_p.value, negated(d_q.value));
  const double terms = d_p.terms + d_q.terms, parts = std::abs(whole.value);
  if (!(0x1p-400 < size && 0x1p-500 < parts && 0x1p-90 * terms < parts)) return std::nullopt;
  const Rounded of_q = product_of_pairs(d_p.value, {q, 0}), of_p = product_of_pairs(d_q.value, {p, 0});
  const Rounded at = quotient_of_pairs(sum_of_pairs(of_q, negated(of_p)), whole);
  const double off = 0x1p-92 * size * (terms / parts);
  const bool sure = at.value + (at.error - off) == at.value && at.value + (at.error + off) == at.value;
  return sure ? std::optional(at.value) : std::nullopt;
}

/// The same by sums that nothing is lost in.
inline double exact_crossing(const Plane<double>& plane, dvec3 p, dvec3 q, int i) {
  SumOfProducts<3> denominator;
  add_volume(denominator, false, plane, p);
  add_volume(denominator, true, plane, q);
  SumOfProducts<4> numerator;
  add_volume(numerator, false, plane, p, q[i]);
  add_volume(numerator, true, plane, q, p[i]);
  return rounded_quotient(numerator, denominator);
}

}  // namespace detail

/// Where the way from p to q meets the plane: (q d_p - p d_q) / (d_p - d_q), with d the distances from it.
/// Domain: p and q on different sides. Accuracy: the nearest double in each coordinate. Cost: about 0.5 us;
///   5 us for each coordinate that is 0 or lies as good as halfway between two doubles.
inline dvec3 crossing(const Plane<double>& plane, dvec3 p, dvec3 q) {
  using detail::is_tame;
  const bool tame = is_tame(plane.a) && is_tame(plane.b) && is_tame(plane.c) && is_tame(p) && is_tame(q);
  const detail::Height d_p = detail::height_above(plane, p), d_q = detail::height_above(plane, q);
  dvec3 at{0};
  for (int i = 0; i < 3; ++i) {
    const auto sure = tame ? detail::nearest_crossing(d_p, d_q, p[i], q[i]) : std::nullopt;
    at[i] = (sure ? *sure : detail::exact_crossing(plane, p, q, i)) + 0.0;  // a zero is +0
  }
  return at;
}
/// The same in float. Accuracy: the nearest float to the nearest double.
inline glm::vec3 crossing(const Plane<float>& plane, glm::vec3 p, glm::vec3 q) {
  return glm::vec3(crossing(detail::in_double(plane), dvec3(p), dvec3(q)));
}
/// The same without rounding, for rational scalars.
template <class T>
glm::vec<3, T> crossing(const Plane<T>& plane, glm::vec<3, T> p, glm::vec<3, T> q) {
  const glm::vec<3, T> normal = glm::cross(plane.b - plane.a, plane.c - plane.a);
  const T from_p = glm::dot(normal, p - plane.a), from_q = glm::dot(normal, q - plane.a);
  return (from_p * q - from_q * p) / (from_p - from_q);
}

}  // namespace gradus::bsp_tree
