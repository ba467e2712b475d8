#pragma once
// Parallel projection: every point goes to the picture plane along one and the same direction. Lines that are
// parallel stay parallel, and nothing gets smaller with distance; depth is lost.
//
// Points are those of view space: x right, y up, z forward = depth (docs/conventions.md).

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::parallel {

template <class T>
using Point = glm::vec<3, T>;

// --- Planes and directions ---------------------------------------

/// A picture plane: all points p with normal · p = offset.
template <class T>
struct Plane {
  Point<T> normal;  ///< any length but 0
  T offset;         ///< its distance from the origin times the normal's length
};

/// The coordinate that an orthographic projection gives up: x for the side view, y for the top view, z for
/// the front view.
enum class Axis { x, y, z };

/// The place of an axis among a point's coordinates.
constexpr int index_of(Axis axis) { return static_cast<int>(axis); }

/// How far a projector moves aside while it goes one unit forward: the projectors' direction is (a, b, 1).
/// a = b = 0 is orthographic.
template <class T>
struct Slant {
  T a, b;
};

/// The projectors that draw a unit of depth `foreshortening` long and rising at this angle: a point one unit
/// behind the plane appears at foreshortening (cos, sin) of where it would stand in the plane.
/// radians: the angle of receding edges against x, counter-clockwise; 45 degrees is usual. foreshortening:
///   >= 0; 1 is the cavalier projection, 1/2 the cabinet projection, 0 the orthographic one.
/// Accuracy: 1.51 ulp per number: sine and cosine are off by up to 0.501 ulp, which the product with the
///   foreshortening may double, and rounds by 1/2 more.
/// Errors: ContractViolation for an angle or a foreshortening that is not finite, or a negative one.
inline Slant<double> slant_of(double radians, double foreshortening) {
  expects(0 <= foreshortening && foreshortening <= std::numeric_limits<double>::max(),
          "a unit of depth is drawn 0 or more long, not {}", foreshortening);
  const auto [sine, cosine] = sin_cos(radians);
  expects(-1 <= sine && sine <= 1, "the angle of receding edges is finite, not {}", radians);
  return {-(foreshortening * cosine), -(foreshortening * sine)};
}

/// The projectors along a direction, towards the plane or away from it.
/// direction: any vector whose z is not 0.
/// Accuracy: 1/2 ulp per number.
/// Errors: ContractViolation for a direction that is parallel to the plane z = d, or that leans so far that
///   its slant is beyond T, as (1, 0, 1e-310) does.
template <class T>
Slant<T> slant_of(Point<T> direction) {
  expects(direction.z < T(0) || T(0) < direction.z,
          "projectors meet the plane, these are parallel to it: the direction's z is 0");
  const Slant<T> slant{direction.x / direction.z, direction.y / direction.z};
  expects(slant.a - slant.a == T(0) && slant.b - slant.b == T(0),
          "projectors meet the plane, these lean too far for their numbers");
  return slant;
}

/// Whether a direction is so clearly not parallel to a plane that its crossings can be computed in T: |n · v|
/// exceeds 16 rounding errors of its own sum. With T = Exact, whether it is not parallel at all.
template <class T>
bool meets(const Plane<T>& plane, Point<T> direction) {
  const auto size = [](T a) { return a < T(0) ? -a : a; };
  const Point<T> product = plane.normal * direction;
  const T sum = size(product.x + product.y + product.z);
  const T least = T(8) * std::numeric_limits<T>::epsilon();
  return sum > least * (size(product.x) + size(product.y) + size(product.z));
}

// --- Steps -------------------------------------------------------

/// The projector through a point is known to reach the plane after `t` times the direction.
template <class T>
struct Cast {
  Point<T> point;
  T t;  ///< negative when the point lies behind the plane
};

/// The projector has met the plane.
template <class T>
struct Projected {
  Point<T> point, image;
};

// --- The methods -------------------------------------------------

/// Orthographic projection along an axis: the projectors stand upright on the plane. The front view gives up
/// z, the top view y, the side view x.
/// I. Carlbom, J. Paciorek, Planar geometric projections and viewing transformations, ACM Computing Surveys
/// 10(4), 1978, 465-502.
///
/// axis: the coordinate that is given up. d: where the plane crosses that axis. p: any point.
///
/// Domain: everything.
/// Steps: Cast Projected.
/// Accuracy: the image exact; t, which only a figure needs, 1/2 ulp.
/// Cost: a copy.
/// Errors: none.
template <class T, Observer<Cast<T>, Projected<T>> O = Unobserved>
Point<T> orthographic(Axis axis, T d, Point<T> p, O&& observer = {}) {
  // The projector runs along it
  const int i = index_of(axis);
  if constexpr (observed<O>) observer(Cast<T>{p, d - p[i]});
  // The others stay what they are
  Point<T> image = p;
  // There it meets the plane
  image[i] = d;
  if constexpr (observed<O>) observer(Projected<T>{p, image});
  return image;
}

/// Oblique projection onto the plane z = d: the projectors lean by the slant, so that receding edges show.
/// Carlbom and Paciorek 1978, section 2.2.
///
/// d: the plane's depth. slant: see slant_of. p: any point.
///
/// Domain: where nothing overflows T and t a doesn't underflow. A point of the plane stays there, exactly.
/// Steps: Cast Projected.
/// Accuracy: x and y within u (|x'| + 2 |t a|), u the rounding unit of T (2^-53 for double); z exactly d.
/// Cost: 2 multiplications, 3 additions.
/// Errors: none; slant_of refuses projectors that never meet the plane.
template <class T, Observer<Cast<T>, Projected<T>> O = Unobserved>
Point<T> oblique(T d, Slant<T> slant, Point<T> p, O&& observer = {}) {
  const auto [a, b] = slant;
  // How far ahead the plane is
  const T t = d - p.z;
  if constexpr (observed<O>) observer(Cast<T>{p, t});
  // On the way there the projector
  // leans a and b per unit of depth
  const T x = p.x + t * a;
  const T y = p.y + t * b;
  const Point<T> image{x, y, d};
  if constexpr (observed<O>) observer(Projected<T>{p, image});
  return image;
}

/// Parallel projection onto any plane along any direction that meets it.
/// Carlbom and Paciorek 1978, section 2: planes that no axis is normal to give the axonometric views when the
/// direction is the normal.
///
/// plane, v: any plane and direction that meet, of any length; v may point either way. p: any point.
///
/// Domain: what neither overflows nor underflows T in a product, sum or quotient.
/// Steps: Cast Projected.
/// Accuracy: with N = |offset| + sum |normal_i p_i|, S = sum |normal_i v_i| and q = normal · v, each
///   coordinate lies within 10 u |v_i| N S / q^2 + 2 u |p_i|, u as for oblique; Exact is exact.
/// Cost: 9 multiplications, a division, 8 additions, and the test of the direction.
/// Errors: ContractViolation when the direction does not meet the plane (see meets), or is not finite.
template <class T, Observer<Cast<T>, Projected<T>> O = Unobserved>
Point<T> along(const Plane<T>& plane, Point<T> v, Point<T> p, O&& observer = {}) {
  expects(meets(plane, v), "projectors meet the plane, these are parallel to it");
  const auto [n, offset] = plane;
  // The projector is p + t v, and
  // n · (p + t v) = offset
  T ahead = offset - dot(n, p);
  const T t = ahead / dot(n, v);
  if constexpr (observed<O>) observer(Cast<T>{p, t});
  // There it meets the plane
  const Point<T> image = p + t * v;
  if constexpr (observed<O>) observer(Projected<T>{p, image});
  return image;
}

// --- As matrices -------------------------------------------------

/// The matrix of `along`: twice the same as once, and of rank 3, since depth is lost. (GLM's matrices are
/// written column by column.)
///
/// Domain, Errors: as along.
/// Accuracy: with S and q as for along, an entry is within 7 u S / |q| of its product, which is direction_i
///   normal_k / q or direction_i offset / q, and where the product is taken from 1, u more; Exact is exact.
///   For z = d, a power of two in the direction's z and products that fit also double is.
template <class T>
glm::mat<4, 4, T> matrix_of(const Plane<T>& plane, Point<T> direction) {
  expects(meets(plane, direction), "projectors meet the plane, these are parallel to it");
  const Point<T> v = direction / glm::dot(plane.normal, direction);
  glm::mat<4, 4, T> m(T(1));
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) m[column][row] -= v[row] * plane.normal[column];
  }
  m[3] = glm::vec<4, T>(plane.offset * v.x, plane.offset * v.y, plane.offset * v.z, T(1));
  return m;
}

/// Where a projected point is drawn: x to the right and y up in the front view, x and depth in the top view
/// (seen from above), depth and y in the side view (seen from the right).
template <class T>
glm::vec<2, T> picture_of(Axis axis, Point<T> image) {
  if (axis == Axis::x) return {image.z, image.y};
  if (axis == Axis::y) return {image.x, image.z};
  return {image.x, image.y};
}

}  // namespace gradus::parallel
