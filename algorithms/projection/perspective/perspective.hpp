#pragma once
// Perspective: what is twice as far looks half as large.
//
// The projection takes every point to a plane, and loses its depth. The transformation keeps depth, so that
// what hides what can still be told: it multiplies, and the division comes later, when everything that may
// not be divided is clipped away.
//
// The viewer stands at the origin and looks along +z (docs/conventions.md, view space).

#include <algorithm>
#include <bit>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>

#include "core/camera.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::perspective {

/// Whether a number is one: neither infinite nor NaN. (Every Exact is.)
template <class T>
constexpr bool finite(const T& x) {
  return x - x == T(0);
}

// --- The projection: to the plane z = d --------------------------

/// The projector through a point is known: along it, one unit at the point's depth is `factor` units in the
/// plane.
template <class T>
struct Scaled {
  glm::vec<3, T> point;
  T factor;  ///< d / z
};

/// The projector has met the plane.
template <class T>
struct Projected {
  glm::vec<3, T> point, image;
};

/// No projector leads from the point through the plane to the eye: it lies at or behind the eye, or so near
/// it that its image is beyond T.
template <class T>
struct Unseen {
  glm::vec<3, T> point;
};

/// Perspective projection of one point: where the line from the eye to it meets the plane z = d. Similar
/// triangles: x' : d = x : z.
/// I. Carlbom, J. Paciorek, Planar geometric projections and viewing transformations, ACM Computing Surveys
/// 10(4), 1978, 465-502.
///
/// d: the plane's distance from the eye, > 0. point: any.
///
/// Domain: z > 0, before or behind the plane; for z <= 0, -0 and NaN there is no image, for the formula would
///   mirror the point, and none where d / z or the image is beyond T (z = 1e-310). A point of the plane
///   stays where it is, exactly.
/// Steps: Scaled Projected | Scaled? Unseen.
/// Accuracy: x and y two roundings, within 2 u (1 + u) |x'|, u the rounding unit of T (2^-53 for double),
///   where d / z and the image are normal numbers of T; z exactly d.
/// Cost: 1 division, 2 multiplications.
/// Errors: ContractViolation when d <= 0 or NaN.
template <class T, Observer<Scaled<T>, Projected<T>, Unseen<T>> O = Unobserved>
std::optional<glm::vec<3, T>> project(T d, glm::vec<3, T> point, O&& observer = {}) {
  expects(d > T(0), "the picture plane lies before the eye, at a distance above 0");
  if (!(point.z > T(0))) {
    if constexpr (observed<O>) observer(Unseen<T>{point});
    return std::nullopt;
  }
  // x' : d = x : z
  const T factor = d / point.z;
  if constexpr (observed<O>) observer(Scaled<T>{point, factor});
  const T x = point.x * factor;
  const T y = point.y * factor;
  if (!finite(x) || !finite(y)) {
    if constexpr (observed<O>) observer(Unseen<T>{point});
    return std::nullopt;
  }
  const glm::vec<3, T> image{x, y, d};
  if constexpr (observed<O>) observer(Projected<T>{point, image});
  return image;
}

/// The matrix of the projection: (x, y, z, 1) -> (x, y, z, z / d), which divided by its last number is the
/// image. Directions, with 0 for the 1, go to their vanishing points. (GLM's matrices are written column by
/// column.)
/// Errors: ContractViolation when d <= 0 or NaN.
template <class T>
glm::mat<4, 4, T> matrix_onto(T d) {
  expects(d > T(0), "the picture plane lies before the eye, at a distance above 0");
  const T o = T(0), i = T(1);
  return {{i, o, o, o}, {o, i, o, o}, {o, o, i, i / d}, {o, o, o, o}};
}

// --- Vanishing points --------------------------------------------

/// The point at infinity of a direction was taken through the matrix.
template <class T>
struct TakenToInfinity {
  glm::vec<3, T> direction;
  glm::vec<4, T> image;  ///< w is 0 for a direction parallel to the picture plane
};

/// All lines of this direction run to one point of the picture.
template <class T>
struct Vanished {
  glm::vec<3, T> direction;
  glm::vec<2, T> point;
};

/// Lines of this direction have no point in common in the picture: they stay parallel.
template <class T>
struct StaysParallel {
  glm::vec<3, T> direction;
};

/// Where all lines of one direction seem to meet: the image of their common point at infinity, (direction,
/// 0). How many of an object's three axes have one is what one-, two- and three-point perspective count. B.
/// Taylor, New principles of linear perspective, 1719.
///
/// matrix: of a projection, or of a projection after a view matrix: see matrix_onto. direction: any but 0.
///
/// Domain: every direction; nothing for one that is parallel to the picture plane, and for one whose point
///   would be beyond T: (1, 0, 1e-310) has no finite one.
/// Steps: TakenToInfinity (Vanished | StaysParallel).
/// Accuracy: with matrix_onto: 3 roundings a coordinate, within 3 u (1 + 3 u) of it, where no product
///   underflows.
/// Cost: a product of matrix and vector, 2 divisions.
/// Errors: ContractViolation for the direction 0.
template <class T, Observer<TakenToInfinity<T>, Vanished<T>, StaysParallel<T>> O = Unobserved>
std::optional<glm::vec<2, T>> vanishing_point(const glm::mat<4, 4, T>& matrix, glm::vec<3, T> direction,
                                              O&& observer = {}) {
  expects(direction != glm::vec<3, T>(T(0)), "a line has a direction, not the zero vector");
  // A direction is a point at infinity
  const glm::vec<4, T> v(direction, T(0));
  const glm::vec<4, T> image = matrix * v;
  if constexpr (observed<O>) observer(TakenToInfinity<T>{direction, image});
  if (image.w != T(0)) {
    const T x = image.x / image.w;
    const T y = image.y / image.w;
    if (finite(x) && finite(y)) {
      const glm::vec<2, T> point{x, y};
      if constexpr (observed<O>) observer(Vanished<T>{direction, point});
      return point;
    }
  }
  if constexpr (observed<O>) observer(StaysParallel<T>{direction});
  return std::nullopt;
}

// --- The transformation: depth is kept ---------------------------

/// A point of view space stands in clip space: -w <= x, y <= w and 0 <= z <= w is what the picture shows.
template <class T>
struct Multiplied {
  glm::vec<3, T> view;
  glm::vec<4, T> clip;  ///< w is the depth
};

/// A point of clip space was divided by its w.
template <class T>
struct Divided {
  glm::vec<4, T> clip;
  glm::vec<3, T> ndc;
};

/// The perspective transformation of one point: x and y by the cotangents of half the angles of view, z so
/// that after division it is a + b / depth, and w = depth. After division lines stay lines and planes stay
/// planes, which they would not with z' = z.
/// Source: J. F. Blinn, A trip down the graphics pipeline, 1996, chapter 18 (the matrix with 0 <= z <= w).
///
/// projection: see projection_of. view: any point, also at or behind the eye.
///
/// Domain: products that neither overflow nor underflow.
/// Steps: Multiplied.
/// Accuracy: u is the rounding unit of T. x and y are within u |x| and u |y|, z is within u |z| and
///   u |z_scale view.z|, w is exact; z = near gives exactly 0; where
///   the compiler fuses product and sum (see core/arithmetic/rounding.hpp) it may be off by 2^-53 |z_offset|.
/// Cost: 3 multiplications, 1 addition, no division.
/// Errors: none.
template <class T, Observer<Multiplied<T>> O = Unobserved>
glm::vec<4, T> transform(const Projection<T>& projection, glm::vec<3, T> view, O&& observer = {}) {
  const auto [sx, sy, sz, shift] = projection;
  const T x = sx * view.x;
  const T y = sy * view.y;
  const T z = sz * view.z + shift;
  const T w = view.z;
  const glm::vec<4, T> clip{x, y, z, w};
  if constexpr (observed<O>) observer(Multiplied<T>{view, clip});
  return clip;
}

/// The division: x / w, y / w, z / w.
///
/// Domain: w > 0, which clipping against the near plane sees to. (Points at or behind the eye have w <= 0;
///   dividing them would mirror them into the picture.)
/// Steps: Divided.
/// Accuracy: 1/2 ulp a component.
/// Cost: 3 divisions.
/// Errors: ContractViolation when w <= 0 or NaN.
template <class T, Observer<Divided<T>> O = Unobserved>
glm::vec<3, T> divide(glm::vec<4, T> clip, O&& observer = {}) {
  expects(clip.w > T(0), "only points before the eye can be divided, this one has a w of 0 or less");
  const T x = clip.x / clip.w;
  const T y = clip.y / clip.w;
  const T z = clip.z / clip.w;
  const glm::vec<3, T> ndc{x, y, z};
  if constexpr (observed<O>) observer(Divided<T>{clip, ndc});
  return ndc;
}

/// A point at or behind the eye was left as it is: there is no image of it.
template <class T>
struct LeftUndivided {
  glm::vec<4, T> clip;  ///< w <= 0
};

/// The image of one point, of any: multiplied, looked at, and divided only where it lies before the eye.
///
/// p: see projection_of. v: any point of view space.
///
/// Domain: everything; nothing for w <= 0 and NaN. Of a segment with one end there, the part before the eye
///   runs to infinity in the picture: it is clipped against the near plane before the division.
/// Steps: Multiplied (Divided | LeftUndivided).
/// Accuracy: as transform and divide.
/// Cost: as transform and divide.
/// Errors: none.
template <class T, Observer<Multiplied<T>, Divided<T>, LeftUndivided<T>> O = Unobserved>
std::optional<glm::vec<3, T>> divide_tested(const Projection<T>& p, glm::vec<3, T> v, O&& observer = {}) {
  const auto clip = transform(p, v, observer);
  // At or behind the eye there is no image
  if (!(clip.w > T(0))) {
    if constexpr (observed<O>) observer(LeftUndivided<T>{clip});
    return std::nullopt;
  }
  return divide(clip, observer);
}

// --- How finely depth is stored ----------------------------------

/// The depth at x of the straight line from a to b, points after the division: what a scan line does between
/// two corners.
/// Domain: a.x != b.x.
template <class T>
T interpolated_depth(glm::vec<3, T> a, glm::vec<3, T> b, T x) {
  const T share = (x - a.x) / (b.x - a.x);
  return a.z + share * (b.z - a.z);
}

/// What is stored for the depth z between near and far.
enum class DepthCurve {
  linear,   ///< (z - near) / (far - near)
  inverse,  ///< a + b / z, from 0 at near to 1 at far: what the transformation gives
  reversed  ///< 1 - inverse, from 1 at near to 0 at far
};

/// How a depth of [0, 1] is stored.
enum class DepthFormat {
  fixed24,  ///< in whole steps of 1 / (2^24 - 1)
  float32   ///< as the nearest float
};

/// The depth to store for z.
/// near, far: 0 < near < far. z: near <= z <= far.
/// Domain: for the accuracy planes from 2^-400 to 2^400 (float: 2^-50 to 2^50), so that no product leaves T.
/// Accuracy: 3 roundings for the linear curve, 5 for the others, relative to the result: none of them
///   subtracts what was rounded.
/// Errors: ContractViolation for planes that are not 0 < near < far.
template <class T>
T depth_of(DepthCurve curve, T near, T far, T z) {
  expects(T(0) < near && near < far && finite(far), "the near plane lies between the eye and the far plane");
  if (curve == DepthCurve::linear) return (z - near) / (far - near);
  if (curve == DepthCurve::inverse) return far / z * (z - near) / (far - near);
  return near / z * (far - z) / (far - near);
}

/// The number that stands in the depth buffer: a code of 24 bits, or the bits of a float. Greater depths have
/// greater numbers.
/// Domain: 0 <= depth <= 1.
inline std::uint32_t stored(DepthFormat format, double depth) {
  if (format == DepthFormat::float32) return std::bit_cast<std::uint32_t>(static_cast<float>(depth));
  return static_cast<std::uint32_t>(depth * 0xffffff + 0.5);
}

/// The distance between a stored depth and the next greater one that can be stored; at 1 the next smaller.
/// Domain: 0 <= depth <= 1.
inline double spacing(DepthFormat format, double depth) {
  if (format == DepthFormat::fixed24) return 1.0 / 0xffffff;
  const std::uint32_t below_one = std::bit_cast<std::uint32_t>(1.0f) - 1;
  const std::uint32_t bits = std::min(stored(format, depth), below_one);
  return double{std::bit_cast<float>(bits + 1)} - double{std::bit_cast<float>(bits)};
}

/// How far apart two surfaces at depth z must lie for the buffer to tell them apart is known.
struct Resolved {
  double z, depth, spacing;
  double slope;  ///< of the curve at z: stored depth a unit of z, without its sign
  double step;   ///< spacing / slope, in units of z
};

/// The smallest separable step at depth z: the spacing of what can be stored, divided by how fast the stored
/// depth changes.
/// E. Lapidous, G. Jiao, Optimal depth buffer for low-cost graphics hardware, Graphics Hardware 1999, 67-73.
///
/// n, f: depths of the near and the far plane, 0 < n < f. z: n <= z <= f.
///
/// Domain: as said, planes from 2^-400 to 2^400. Nearer surfaces than a step may still be told apart, when a
///   rounding lies between them: two depths a step apart always are, as long as step is small beside z.
/// Steps: Resolved.
/// Accuracy: 12 roundings, relative.
/// Cost: a few divisions.
/// Errors: ContractViolation outside the domain.
template <Observer<Resolved> O = Unobserved>
double separable_step(DepthCurve curve, DepthFormat format, double n, double f, double z, O&& observer = {}) {
  expects(n <= z && z <= f, "depths lie between {} and {}, not at {}", n, f, z);
  const auto depth = depth_of(curve, n, f, z);
  const double gap = spacing(format, depth);
  double slope = 1 / (f - n);
  if (curve != DepthCurve::linear) {
    // d/dz of a + b / z
    slope *= n / z * (f / z);
  }
  const double step = gap / slope;
  if constexpr (observed<O>) observer(Resolved{z, depth, gap, slope, step});
  return step;
}

}  // namespace gradus::perspective
