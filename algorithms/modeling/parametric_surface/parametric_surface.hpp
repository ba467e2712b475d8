#pragma once
// A sphere as a function of two parameters: its points, tangents and normals at any (s, t), the faces that
// patches of it make, and what those faces answer when they are asked instead of the function.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/turn.hpp"
#include "core/contract.hpp"
#include "core/faces.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::parametric_surface {

template <class T>
using Vec = glm::vec<3, T>;

/// As many faces as one may ask for.
inline constexpr std::int64_t most_faces = std::int64_t{1} << 24;

// --- Steps -------------------------------------------------------

/// The direction of longitude s in the equator's plane is known.
template <class T>
struct Turned {
  Vec<T> direction;
};
/// So are the radius of the circle of latitude t and its height above that plane.
template <class T>
struct Raised {
  T ring, height;
};
template <class T>
struct PointFound {
  Vec<T> point;
};
/// The derivative by s is known; it is as long as the ring's radius, 0 at the poles.
template <class T>
struct AlongParallel {
  Vec<T> tangent;
  T length;
};
/// So is the derivative by t, as long as the sphere's radius.
template <class T>
struct AlongMeridian {
  Vec<T> tangent;
  T length;
};
template <class T>
struct NormalFound {
  Vec<T> normal;
};

/// A row of points has been made, all of one latitude.
struct RowMade {
  int row;                     ///< from 0, the south pole, on
  std::int32_t first, points;  ///< the number of its first point, and how many it has
};
/// The faces between this row and the one before have been made.
struct StripMade {
  int row;
  std::size_t faces;  ///< so far
};
struct Finished {
  std::size_t points, faces;
};

/// The cell of a mesh in which (s, t) lies, and where in it: u and v from 0 to 1.
template <class T>
struct CellFound {
  int i, j;
  T u, v;
};
/// Its corners have been mixed.
template <class T>
struct Mixed {
  Vec<T> point;
};
/// The normal is that of the whole face.
template <class T>
struct FaceNormalTaken {
  Vec<T> normal;
};

// --- A point -----------------------------------------------------

/// What is known of a surface at one point. Angles count in radians where it is differentiated.
template <class T>
struct SurfacePoint {
  Vec<T> point, by_s, by_t, normal;
  friend bool operator==(const SurfacePoint&, const SurfacePoint&) = default;
};

/// Sine and cosine of an angle in degrees; those of multiples of 90 are exact, so that a pole is one point.
/// Accuracy: that of sin_cos_degrees.
/// Errors: ContractViolation for an infinite angle and NaN.
template <std::floating_point T>
Turn<T> angle(T degrees) {
  expects(std::isfinite(degrees), "an angle is finite, not {} degrees", degrees);
  const SinCos a = sin_cos_degrees(double{degrees});
  return turn_of(static_cast<T>(a.sin), static_cast<T>(a.cos));
}

template <class T>
void expect_radius(const T& r) {
  expects(r > T(0), "a radius is above 0");
  if constexpr (std::numeric_limits<T>::has_infinity)
    expects(r <= std::numeric_limits<T>::max() / 4, "a radius is at most a quarter of the largest number");
}

/// A point of the sphere round the origin, its tangents and its normal.
/// Source: E. Kreyszig, Differential Geometry, 1959, section 25; spherical coordinates with the latitude t.
///
/// r: the radius. s: the longitude, from the x axis towards y. t: the latitude, from the equator's plane.
///
/// Domain: r > 0, at most a quarter of the largest number; any s; cos t >= 0, that is t from -90 to 90
///   degrees (not checked).
/// Steps: Turned Raised PointFound AlongParallel AlongMeridian NormalFound.
/// Accuracy: each coordinate within 3.5 u of the largest it can have, r or 1, and as many of the smallest
///   subnormal number, for the sines and cosines of `angle`; u = 2^-53 in double. At the poles the point, the
///   normal and by_s = 0 are exact.
/// Cost: ten products, beside two sines and cosines.
/// Errors: ContractViolation outside the domain.
template <class T,
          Observer<Turned<T>, Raised<T>, PointFound<T>, AlongParallel<T>, AlongMeridian<T>, NormalFound<T>>
              O = Unobserved>
SurfacePoint<T> point(const T& r, const Turn<T>& s, const Turn<T>& t, O&& observer = {}) {
  expect_radius(r);
  // Angle s in the equator's plane
  const Vec<T> e{s.cos, s.sin, 0};
  if constexpr (observed<O>) observer(Turned<T>{e});
  // Angle t up the meridian
  const T ring = r * t.cos;
  const T height = r * t.sin;
  if constexpr (observed<O>) observer(Raised<T>{ring, height});
  Vec<T> p = ring * e;
  p.z = height;
  if constexpr (observed<O>) observer(PointFound<T>{p});
  // Derivatives by s and by t
  Vec<T> p_s{T(0) - p.y, p.x, 0};
  if constexpr (observed<O>) observer(AlongParallel<T>{p_s, ring});
  Vec<T> p_t = (T(0) - height) * e;
  p_t.z = ring;
  if constexpr (observed<O>) observer(AlongMeridian<T>{p_t, r});
  // The normal, P / r
  Vec<T> n = t.cos * e;
  n.z = t.sin;
  if constexpr (observed<O>) observer(NormalFound<T>{n});
  return {p, p_s, p_t, n};
}

// --- Patches as faces --------------------------------------------

/// A row of points in a list, round which it closes.
struct Row {
  std::int32_t first, count;
  std::int32_t operator()(int i) const { return first + i % count; }
};

/// The sphere as n times m patches: points row by row from the south pole on, faces likewise.
template <class T>
struct Patches {
  int n, m;
  std::vector<Row> rows{};  ///< m + 1
  std::vector<Vec<T>> points{};
  Faces faces{};

  /// Points that are added from now on, so many, are another row.
  void begin_row(int count) { rows.push_back({static_cast<std::int32_t>(points.size()), count}); }
  Row row(int j) const { return rows[static_cast<std::size_t>(j)]; }
};

/// Angles of the k-th of so many equal parts, round the axis and from pole to pole.
template <std::floating_point T>
Turn<T> longitude(int k, int parts) {
  return angle(T(360) * static_cast<T>(k) / static_cast<T>(parts));
}
template <std::floating_point T>
Turn<T> latitude(int k, int parts) {
  return angle(T(180) * static_cast<T>(k) / static_cast<T>(parts) - T(90));
}

/// The i-th face between two rows; of a row that is one point both corners are one.
inline void add_face(Faces& faces, const Row& low, const Row& high, int i) {
  const int k = i + 1;
  std::array<std::int32_t, 4> ring{low(i), low(k), high(k), high(i)};
  faces.add({ring.begin(), std::unique(ring.begin(), ring.end())});
}

/// The faces of n times m patches: closed, with s half-open, a point for each pole and triangles round it.
/// All of them are flat: their corners are those of isosceles trapezia.
///
/// r: the radius. n: patches round the axis. m: from pole to pole.
///
/// Domain: r as for point; n >= 3, m >= 2, n m <= 2^24.
/// Steps: RowMade for each of m + 1 rows, StripMade for each of m, Finished.
/// Accuracy: corners as by point; no place of a face is farther than off_sphere(r, n, m) from the sphere,
///   8 u r aside.
/// Cost: 2 + n (m - 1) points, each with a sine and a cosine of its own.
/// Errors: ContractViolation outside the domain.
template <std::floating_point T, Observer<RowMade, StripMade, Finished> O = Unobserved>
Patches<T> patches(T r, int n, int m, O&& observer = {}) {
  expect_radius(r);
  expects(n >= 3 && m >= 2 && std::int64_t{n} * m <= most_faces, "from 3 x 2 patches, not {} x {}", n, m);
  Patches<T> made{n, m};
  for (int j = 0; j <= m; ++j) {
    // A pole is one point
    const bool pole = j % m == 0;
    const int size = pole ? 1 : n;
    made.begin_row(size);
    auto t = latitude<T>(j, m);
    for (int i = 0; i < size; ++i) {
      auto s = longitude<T>(i, n);
      auto p = point(r, s, t).point;
      made.points.push_back(p);
    }
    if constexpr (observed<O>) observer(RowMade{j, made.rows.back().first, size});
  }
  // Faces between two rows
  for (int j = 1; j <= m; ++j) {
    const Row low = made.row(j - 1);
    const Row high = made.row(j);
    auto& faces = made.faces;
    for (int i = 0; i < n; ++i) {
      add_face(faces, low, high, i);
    }
    if constexpr (observed<O>) observer(StripMade{j, made.faces.size()});
  }
  if constexpr (observed<O>) observer(Finished{made.points.size(), made.faces.size()});
  return made;
}

/// How far those faces are from the sphere at most: r (1 - cos(180/n) cos(90/m)), in degrees, without the
/// difference that would cancel. It is reached where m is odd, in the middle of a face at the equator.
inline double off_sphere(double r, int n, int m) {
  const Turn<double> a = turn_degrees(180.0 / n), b = turn_degrees(90.0 / m);
  return r * (a.versine + a.cos * b.versine);
}

// --- The same asked of the faces ---------------------------------

template <class T>
struct LookedUp {
  Vec<T> point, normal;
  friend bool operator==(const LookedUp&, const LookedUp&) = default;
};

/// A number from 0 to 1 in n equal cells: which one it lies in, and where there.
template <std::floating_point T>
struct Cell {
  int number;
  T part;
  Cell(T x, int n) : number(std::min(static_cast<int>(x * static_cast<T>(n)), n - 1)) {
    part = x * static_cast<T>(n) - static_cast<T>(number);
  }
};

/// Longitude and latitude in degrees as parts of the parameters' ranges, from 0 to 1.
template <std::floating_point T>
T part_of_turn(T s) {
  const T rest = std::fmod(s, T(360));
  return (rest < 0 ? rest + 360 : rest) / 360;
}
template <std::floating_point T>
T part_of_rise(T t) {
  return (t + 90) / 180;
}

/// The corners of a patch, counter-clockwise from outside; at a pole two of them are one.
template <class T>
std::array<Vec<T>, 4> corners_of(const Patches<T>& mesh, const Cell<T>& of_s, const Cell<T>& of_t) {
  const auto at = [&](std::int32_t p) { return mesh.points[static_cast<std::size_t>(p)]; };
  const int i = of_s.number, j = of_t.number;
  const Row low = mesh.row(j), high = mesh.row(j + 1);
  return {at(low(i)), at(low(i + 1)), at(high(i + 1)), at(high(i))};
}

/// The place of (s, t) on the faces instead of the surface, and the face's normal. No sine is taken.
///
/// mesh: by patches. s, t: longitude and latitude in degrees.
///
/// Domain: s finite; -90 <= t <= 90.
/// Steps: CellFound Mixed FaceNormalTaken.
/// Accuracy: the point within r (pi^2 / (2 n^2) + pi^2 / (8 m^2)) of the surface's, 16 u r aside: a quarter
///   where n and m are twice as large. The normal is one for all of a face and jumps at its edges.
/// Cost: nine mixed coordinates and a cross product, whatever the number of faces.
/// Errors: ContractViolation outside the domain.
template <std::floating_point T, Observer<CellFound<T>, Mixed<T>, FaceNormalTaken<T>> O = Unobserved>
LookedUp<T> lookup(const Patches<T>& mesh, T s, T t, O&& observer = {}) {
  expects(std::isfinite(s), "a longitude is finite, not {}", s);
  expects(T(-90) <= t && t <= T(90), "a latitude is from -90 to 90 degrees, not {}", t);
  // The cell, and where in it
  const T x = part_of_turn(s);
  const T y = part_of_rise(t);
  const Cell<T> i(x, mesh.n);
  const Cell<T> j(y, mesh.m);
  const T u = i.part, v = j.part;
  if constexpr (observed<O>) observer(CellFound<T>{i.number, j.number, u, v});
  auto c = corners_of(mesh, i, j);
  // Its corners, mixed
  const T u0 = 1 - u, v0 = 1 - v;
  auto low = u0 * c[0] + u * c[1];
  auto high = u0 * c[3] + u * c[2];
  auto p = v0 * low + v * high;
  if constexpr (observed<O>) observer(Mixed<T>{p});
  // One normal for the whole face
  auto d = unit_vector(c[2] - c[0]);
  auto e = unit_vector(c[3] - c[1]);
  auto n = unit_vector(cross(d, e));
  if constexpr (observed<O>) observer(FaceNormalTaken<T>{n});
  return {p, n};
}

}  // namespace gradus::parametric_surface
