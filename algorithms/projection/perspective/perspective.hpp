#pragma once
// Perspective: what is twice as far looks half as large.
//
// The projection takes every point to a plane, and loses its depth. The transformation keeps depth, so that
// what hides what can still be told: it multiplies, and the division comes later, when everything that may
// not be divided is clipped away.
//
// The viewer stands at the origin and looks along +z (docs/conventions.md, view space).

#include <algorithm>
#include <array>
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

template <class T>
using Point2 = glm::vec<2, T>;
template <class T>
using Point3 = glm::vec<3, T>;
template <class T>
using Point4 = glm::vec<4, T>;

/// What stands where a point has no image.
inline constexpr std::nullopt_t no_image = std::nullopt;

/// Whether numbers are numbers: neither infinite nor NaN. (Every Exact is.)
template <class... T>
constexpr bool finite(const T&... numbers) {
  return (... && (numbers - numbers == T(0)));
}

/// Whether a point of view space, or one of clip space, lies in front of the eye: at a depth above 0. NaN
/// does not.
template <class T>
constexpr bool before_eye(const Point3<T>& view) {
  return view.z > T(0);
}
template <class T>
constexpr bool before_eye(const Point4<T>& clip) {
  return clip.w > T(0);
}

// --- The projection: to the plane z = d --------------------------

/// The projector through a point is known: along it, one unit at the point's depth is `factor` units in the
/// plane.
template <class T>
struct Scaled {
  Point3<T> point;
  T factor;  ///< d / z
};

/// The projector has met the plane.
template <class T>
struct Projected {
  Point3<T> point, image;
};

/// No projector leads from the point through the plane to the eye: it lies at or behind the eye, or so near
/// it that its image is beyond T.
template <class T>
struct Unseen {
  Point3<T> point;
};

/// Perspective projection of one point: where the line from the eye to it meets the plane z = d. Similar
/// triangles: x' : d = x : z.
/// Source: I. Carlbom, J. Paciorek, Planar geometric projections and viewing transformations, ACM Computing
/// Surveys 10(4), 1978, 465-502.
///
/// d: the plane's distance from the eye, > 0. p: any point.
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
std::optional<Point3<T>> project(T d, Point3<T> p, O&& observer = {}) {
  expects(d > T(0), "the picture plane lies in front of the eye, at a distance above 0");
  if (!before_eye(p)) {
    if constexpr (observed<O>) observer(Unseen<T>{p});
    return no_image;
  }
  // x' : d = x : z
  const T factor = d / p.z;
  if constexpr (observed<O>) observer(Scaled<T>{p, factor});
  const T x = p.x * factor;
  const T y = p.y * factor;
  // Too near the eye for numbers
  if (!finite(x, y)) {
    if constexpr (observed<O>) observer(Unseen<T>{p});
    return no_image;
  }
  const Point3<T> image{x, y, d};
  if constexpr (observed<O>) observer(Projected<T>{p, image});
  return image;
}

/// The matrix of the projection: (x, y, z, 1) -> (x, y, z, z / d), which divided by its last number is the
/// image. Directions, with 0 for the 1, go to their vanishing points. (GLM's matrices are written column by
/// column.)
/// Errors: ContractViolation when d <= 0 or NaN.
template <class T>
glm::mat<4, 4, T> matrix_onto(T d) {
  expects(d > T(0), "the picture plane lies in front of the eye, at a distance above 0");
  const T o = T(0), i = T(1);
  return {{i, o, o, o}, {o, i, o, o}, {o, o, i, i / d}, {o, o, o, o}};
}

// --- Vanishing points --------------------------------------------

/// The point at infinity of a direction was taken through the matrix.
template <class T>
struct TakenToInfinity {
  Point3<T> direction;
  Point4<T> image;  ///< w is 0 for a direction parallel to the picture plane
};

/// All lines of this direction run to one point of the picture.
template <class T>
struct Vanished {
  Point3<T> direction;
  Point2<T> point;
};

/// Lines of this direction have no point in common in the picture: they stay parallel.
template <class T>
struct StaysParallel {
  Point3<T> direction;
};

/// Where all lines of one direction seem to meet: the image of their common point at infinity, (v, 0). How
/// many of an object's three axes have one is what one-, two- and three-point perspective count.
/// Source: B. Taylor, New principles of linear perspective, 1719.
///
/// m: matrix of a projection, or of a projection after a view matrix: see matrix_onto. v: any direction but
/// 0.
///
/// Domain: every direction; nothing for one that is parallel to the picture plane, and for one whose point
///   would be beyond T: (1, 0, 1e-310) has no finite one.
/// Steps: TakenToInfinity (Vanished | StaysParallel).
/// Accuracy: with matrix_onto: 3 roundings per coordinate, within 3 u (1 + 3 u) of it, where no product
///   underflows.
/// Cost: a product of matrix and vector, 2 divisions.
/// Errors: ContractViolation for the direction 0.
template <class T, Observer<TakenToInfinity<T>, Vanished<T>, StaysParallel<T>> O = Unobserved>
std::optional<Point2<T>> vanishing_point(const glm::mat<4, 4, T>& m, Point3<T> v, O&& observer = {}) {
  expects(v != Point3<T>(T(0)), "a line has a direction, not the zero vector");
  // The lines' point at infinity
  const Point4<T> infinite(v, 0);
  const auto image = m * infinite;
  if constexpr (observed<O>) observer(TakenToInfinity<T>{v, image});
  // Parallel to the picture plane
  if (image.w == T(0)) {
    if constexpr (observed<O>) observer(StaysParallel<T>{v});
    return no_image;
  }
  const T x = image.x / image.w;
  const T y = image.y / image.w;
  // As good as parallel
  if (!finite(x, y)) {
    if constexpr (observed<O>) observer(StaysParallel<T>{v});
    return no_image;
  }
  const Point2<T> point{x, y};
  if constexpr (observed<O>) observer(Vanished<T>{v, point});
  return point;
}

// --- The transformation: depth is kept ---------------------------

/// A point of view space stands in clip space: -w <= x, y <= w and 0 <= z <= w is what the picture shows.
template <class T>
struct Multiplied {
  Point3<T> view;
  Point4<T> clip;  ///< w is the depth
};

/// A point of clip space was divided by its w.
template <class T>
struct Divided {
  Point4<T> clip;
  Point3<T> ndc;
};

/// The perspective transformation of one point: x and y by the cotangents of half the angles of view, z so
/// that after division it is a + b / depth, and w = depth. After division lines stay lines and planes stay
/// planes, which they would not with z' = z.
/// Source: J. F. Blinn, A trip down the graphics pipeline, 1996, chapter 18 (the matrix with 0 <= z <= w).
///
/// p: see projection_of. v: any point of view space, also at or behind the eye.
///
/// Domain: products that neither overflow nor underflow.
/// Steps: Multiplied.
/// Accuracy: u is the rounding unit of T. x and y are within u |x| and u |y|, z is within u |z| and
///   u |z_scale v.z|, w is exact; z = near gives exactly 0; where the compiler fuses product and sum (see
///   core/arithmetic/rounding.hpp) it may be off by 2^-53 |z_offset|.
/// Cost: 3 multiplications, 1 addition, no division.
/// Errors: none.
template <class T, Observer<Multiplied<T>> O = Unobserved>
Point4<T> transform(const Projection<T>& p, Point3<T> v, O&& observer = {}) {
  // The matrix, row by row
  auto [sx, sy, sz, shift] = p;
  const T x = sx * v.x;
  const T y = sy * v.y;
  const T z = sz * v.z + shift;
  const T w = v.z;
  const Point4<T> clip{x, y, z, w};
  if constexpr (observed<O>) observer(Multiplied<T>{v, clip});
  return clip;
}

/// The division: x / w, y / w, z / w.
///
/// Domain: w > 0, which clipping against the near plane sees to. (Points at or behind the eye have w <= 0;
///   dividing them would mirror them into the picture.)
/// Steps: Divided.
/// Accuracy: 1/2 ulp per component.
/// Cost: 3 divisions.
/// Errors: ContractViolation when w <= 0 or NaN.
template <class T, Observer<Divided<T>> O = Unobserved>
Point3<T> divide(Point4<T> clip, O&& observer = {}) {
  expects(before_eye(clip), "only points in front of the eye can be divided, this one has a w of 0 or less");
  // The division
  const T x = clip.x / clip.w;
  const T y = clip.y / clip.w;
  const T z = clip.z / clip.w;
  const Point3<T> ndc{x, y, z};
  if constexpr (observed<O>) observer(Divided<T>{clip, ndc});
  return ndc;
}

/// A point at or behind the eye was left as it is: there is no image of it.
template <class T>
struct LeftUndivided {
  Point4<T> clip;  ///< w <= 0
};

/// The image of any point: multiplied, tested, and divided only where it lies in front of the eye.
///
/// p: see projection_of. v: any point of view space.
///
/// Domain: everything; nothing for w <= 0 and NaN. Of a segment with one end there, the part in front of the
///   eye runs to infinity in the picture: it is clipped against the near plane before the division.
/// Steps: Multiplied (Divided | LeftUndivided).
/// Accuracy: as transform and divide.
/// Cost: as transform and divide.
/// Errors: none.
template <class T, Observer<Multiplied<T>, Divided<T>, LeftUndivided<T>> O = Unobserved>
std::optional<Point3<T>> divide_tested(const Projection<T>& p, Point3<T> v, O&& observer = {}) {
  // The test comes between the two
  const auto clip = transform(p, v, observer);
  if (!before_eye(clip)) {
    if constexpr (observed<O>) observer(LeftUndivided<T>{clip});
    return no_image;
  }
  return divide(clip, observer);
}

// --- What the viewer can see -------------------------------------

/// A corner of the frustum was found.
template <class T>
struct CornerFound {
  int number;       ///< from 0: left below, right below, left above, right above; first near, then far
  T width, height;  ///< half of its rectangle's
  Point3<T> corner;
};

/// The eight corners of the frustum, the part of space between two planes that the picture shows: a rectangle
/// at the near plane, and one at the far plane that is larger as it is farther away. The transformation takes
/// it to a box.
/// Source: J. F. Blinn, A trip down the graphics pipeline, 1996, chapter 18.
///
/// across, up: tangents of half the angles of view. near, far: depths with 0 < near < far.
///
/// Domain: products that neither overflow nor underflow.
/// Steps: CornerFound eight times.
/// Accuracy: x and y one rounding each, z exact.
/// Cost: 16 multiplications.
/// Errors: ContractViolation unless across, up > 0 and 0 < near < far.
template <class T, Observer<CornerFound<T>> O = Unobserved>
std::array<Point3<T>, 8> frustum_corners(T across, T up, T near, T far, O&& observer = {}) {
  expects(T(0) < across && T(0) < up, "angles of view above 0 expected");
  expects(T(0) < near && near < far, "depths with 0 < near < far expected");
  std::array<Point3<T>, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    // First the near rectangle
    const T z = i < 4 ? near : far;
    // Half its width and height
    const T w = z * across;
    const T h = z * up;
    // Left or right, below or above
    const T x = i % 2 == 0 ? -w : w;
    const T y = i % 4 < 2 ? -h : h;
    const Point3<T> corner{x, y, z};
    if constexpr (observed<O>) observer(CornerFound<T>{static_cast<int>(i), w, h, corner});
    corners[i] = corner;
  }
  return corners;
}

// --- How finely depth is stored ----------------------------------

/// The depth at x of the straight line from a to b, points after the division: what a scan line does between
/// two corners.
/// Domain: a.x != b.x.
template <class T>
T interpolated_depth(Point3<T> a, Point3<T> b, T x) {
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
  double slope;  ///< of the curve at z: stored depth per unit of z, without its sign
  double step;   ///< spacing / slope, in units of z
};

/// The smallest separable step at depth z: the spacing of what can be stored, divided by how fast the stored
/// depth changes.
/// Source: E. Lapidous, G. Jiao, Optimal depth buffer for low-cost graphics hardware, Graphics Hardware 1999,
/// 67-73.
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
  // The gap between stored depths
  auto d = depth_of(curve, n, f, z);
  auto gap = spacing(format, d);
  // How steep the curve is there
  double slope = 1 / (f - n);
  if (curve != DepthCurve::linear) {
    // d/dz of a + b / z
    slope *= n / z * (f / z);
  }
  const double step = gap / slope;
  if constexpr (observed<O>) observer(Resolved{z, d, gap, slope, step});
  return step;
}

}  // namespace gradus::perspective
