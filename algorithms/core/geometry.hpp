#pragma once
// The few shapes that topics share. Vectors are GLM's; what GLM lacks is here.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "core/language.hpp"

namespace gradus {

using glm::dvec2;
using glm::dvec3;
using glm::ivec2;

/// A straight piece from a to b; a == b is a point.
template <int N, class T>
struct Segment {
  glm::vec<N, T> a, b;

  friend constexpr bool operator==(const Segment&, const Segment&) = default;
};

/// A rectangle (N = 2) or box (N = 3) along the axes; its borders belong to it. lower == upper in an axis is
/// allowed: then it has no thickness there.
template <int N, class T>
struct AxisBox {
  glm::vec<N, T> lower, upper;

  constexpr glm::vec<N, T> size() const { return upper - lower; }

  friend constexpr bool operator==(const AxisBox&, const AxisBox&) = default;
};

template <class T>
using Rectangle = AxisBox<2, T>;

/// All points as far from the centre as the radius says; 0 is a point, less is nothing.
template <class T>
struct Circle {
  glm::vec<2, T> centre;
  T radius;
};

/// A rectangle of cells, lower and upper corner both included, so that the whole int32 plane is one.
/// Empty when upper < lower in either axis.
struct Window {
  ivec2 lower{0, 0};
  ivec2 upper{-1, -1};

  constexpr bool empty() const { return upper.x < lower.x || upper.y < lower.y; }
  constexpr bool contains(ivec2 p) const {
    return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y;
  }
  /// Cells across; up to 2^32.
  constexpr std::int64_t width() const { return std::int64_t{upper.x} - lower.x + 1; }
  constexpr std::int64_t height() const { return std::int64_t{upper.y} - lower.y + 1; }

  friend constexpr bool operator==(const Window& a, const Window& b) {
    return a.lower.x == b.lower.x && a.lower.y == b.lower.y && a.upper.x == b.upper.x &&
           a.upper.y == b.upper.y;
  }
};

/// The cells two windows share; empty when they share none.
constexpr Window intersection(const Window& a, const Window& b) {
  return {{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y)},
          {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y)}};
}

/// The smallest window that holds both cells.
constexpr Window window_around(ivec2 a, ivec2 b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// A vector times a power of two that makes its largest component at least 1 and less than 2, which rounds
/// nothing (but of components that are vanishingly small beside it). The zero vector stays.
/// Domain: finite components. Of others the vector is not finite, either, and the exponent without meaning.
template <std::floating_point T>
struct Scaled {
  glm::vec<3, T> vector;
  int exponent;  ///< the vector was 2^exponent times as long

  explicit Scaled(glm::vec<3, T> v) : vector(v), exponent(0) {
    const T largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0)) return;  // 0, or NaN, of which ilogb gives no exponent
    exponent = std::ilogb(largest);
    vector = {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
  }
};

/// The length of v. Domain: finite components of any size: they are scaled before they are squared, so that
/// neither 1e-200 nor 1e200 is lost; others give infinity or NaN. Accuracy: 2 ulp.
template <std::floating_point T>
T length_of(glm::vec<3, T> v) {
  const Scaled<T> scaled(v);
  return std::scalbn(std::sqrt(glm::dot(scaled.vector, scaled.vector)), scaled.exponent);
}

template <std::floating_point T>
T length_of(glm::vec<2, T> v) {
  return length_of(glm::vec<3, T>(v, T(0)));
}

/// The vector of length 1 that points the way of v; the zero vector for the zero vector.
/// Domain: as length_of. Accuracy: 4 ulp per component.
template <std::floating_point T>
glm::vec<3, T> unit_vector(glm::vec<3, T> v) {
  const glm::vec<3, T> scaled = Scaled<T>(v).vector;
  const T square = glm::dot(scaled, scaled);
  return square == 0 ? v : scaled / std::sqrt(square);
}

/// A vector's direction, of length 1, and its length.
template <std::floating_point T>
struct Directed {
  glm::vec<3, T> direction;
  T length;
};

/// unit_vector and length_of at once. Domain, Accuracy: as theirs.
template <std::floating_point T>
Directed<T> directed(glm::vec<3, T> v) {
  const Scaled<T> scaled(v);
  const T root = std::sqrt(glm::dot(scaled.vector, scaled.vector));
  if (root == 0) return {v, T(0)};
  return {scaled.vector / root, std::scalbn(root, scaled.exponent)};
}

/// The smallest box along the axes that holds some points; empty while it holds none.
struct Bounds {
  dvec3 lower{std::numeric_limits<double>::infinity()};
  dvec3 upper{-std::numeric_limits<double>::infinity()};

  bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
  void add(dvec3 point) {
    lower = {std::min(lower.x, point.x), std::min(lower.y, point.y), std::min(lower.z, point.z)};
    upper = {std::max(upper.x, point.x), std::max(upper.y, point.y), std::max(upper.z, point.z)};
  }
  /// Domain: not empty.
  dvec3 centre() const { return lower * 0.5 + upper * 0.5; }
  /// Half the diagonal: the ball round the centre that holds the box. Domain: not empty.
  double radius() const { return length_of(upper * 0.5 - lower * 0.5); }
  /// x first, then y, then z. Domain: not empty.
  std::array<dvec3, 8> corners() const {
    std::array<dvec3, 8> all;
    for (std::size_t i = 0; i < 8; ++i)
      all[i] = {i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z};
    return all;
  }
};

}  // namespace gradus
