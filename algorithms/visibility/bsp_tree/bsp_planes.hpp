#pragma once
// The planes of a BSP tree: on which side of one a point lies, exactly, and where an edge meets it.

#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/arithmetic/exact.hpp"
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

/// Where the way from p to q meets the plane: (q d_p - p d_q) / (d_p - d_q), with d the distances from it.
/// Domain: p and q on different sides. Accuracy: the nearest double in each coordinate. Cost: about 15 us.
inline dvec3 crossing(const Plane<double>& plane, dvec3 p, dvec3 q) {
  SumOfProducts<3> denominator;
  detail::add_volume(denominator, false, plane, p);
  detail::add_volume(denominator, true, plane, q);
  dvec3 at{0};
  for (int i = 0; i < 3; ++i) {
    SumOfProducts<4> numerator;
    detail::add_volume(numerator, false, plane, p, q[i]);
    detail::add_volume(numerator, true, plane, q, p[i]);
    at[i] = rounded_quotient(numerator, denominator) + 0.0;  // a zero is +0
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
