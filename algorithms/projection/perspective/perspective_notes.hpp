#pragma once
// Exhibits: the notes' perspective transformation, which keeps z as it is, divisions without a look at what
// is divided by, and a rule for what stays parallel that is too wide. Never use them; perspective.hpp has
// what is right.

#include "projection/perspective/perspective.hpp"

namespace gradus::perspective {

/// FAULTY for depth between corners: the notes' perspective transformation, x' = d x / z, y' = d y / z,
/// z' = z. It does take the frustum to a box and keeps the order of depths, but it bends every line and plane
/// that is not parallel to the picture: between its corners, depth on the screen is no straight line, and
/// whoever interpolates it there sees the wrong surface (errata E001-38).
///
/// d: the plane's distance, > 0. p: any point.
///
/// Domain: as project; nothing for z <= 0.
/// Steps: Scaled Projected | Scaled? Unseen.
/// Accuracy: the image as project. Interpolated half-way between two points' images, depth is too large by
///   (z1 - z0)^2 / (2 (z0 + z1)), at worst by (sqrt(z1) - sqrt(z0))^2: the line (0,0,1)-(2,0,3) is at 1.5
///   half-way (d = 1, x' = 1/3) and at 2 at x' = 1/2, interpolated depth says 2 and 2.5.
/// Cost: as project.
/// Errors: ContractViolation when d <= 0 or NaN.
template <class T, Observer<Scaled<T>, Projected<T>, Unseen<T>> O = Unobserved>
std::optional<Point3<T>> keep_z(T d, Point3<T> p, O&& observer = {}) {
  expects(d > T(0), "the picture plane lies before the eye, at a distance above 0");
  if (!before_eye(p)) {
    if constexpr (observed<O>) observer(Unseen<T>{p});
    return no_image;
  }
  const T factor = d / p.z;
  if constexpr (observed<O>) observer(Scaled<T>{p, factor});
  const T x = p.x * factor;
  const T y = p.y * factor;
  if (!finite(x, y)) {
    if constexpr (observed<O>) observer(Unseen<T>{p});
    return no_image;
  }
  // The depth stays as it is
  const T z = p.z;
  const Point3<T> image{x, y, z};
  if constexpr (observed<O>) observer(Projected<T>{p, image});
  return image;
}

/// FAULTY for w <= 0: the image of a point, divided wherever it lies (errata E000-07, E001-22, E004-04).
///
/// p, v: as for divide_tested.
///
/// Domain: right before the eye. Behind it a point is mirrored: (1,1,-1) lands on (-1,-1), and the segment
///   (1,0,2)-(1,0,-2) on 0.5 to -0.5, which should run from 0.5 to infinity. For w = 0 infinite or NaN.
/// Steps: Multiplied Divided.
/// Accuracy: none behind the eye.
/// Cost: as transform and divide.
/// Errors: none, where there should be one.
template <class T, Observer<Multiplied<T>, Divided<T>> O = Unobserved>
Point3<T> divide_untested(const Projection<T>& p, Point3<T> v, O&& observer = {}) {
  const auto clip = transform(p, v, observer);
  // Divided whatever w is
  const T x = clip.x / clip.w;
  const T y = clip.y / clip.w;
  const T z = clip.z / clip.w;
  const Point3<T> ndc{x, y, z};
  if constexpr (observed<O>) observer(Divided<T>{clip, ndc});
  return ndc;
}

/// The screen of a wireframe program: the eye is meant to stand `zoom` before the plane z = 0.
template <class T>
struct WireScreen {
  Point2<T> centre;  ///< of the screen, straight ahead of the eye
  T fov;             ///< the screen's distance from the eye
  T zoom;
};

/// A point was left where it stands, its depth dropped.
template <class T>
struct LeftAlone {
  Point3<T> node;
};

/// FAULTY: the screen coordinates of a wireframe report, which says that larger z is farther away and divides
/// by zoom - z, but for points with z = 0 (errata E002-03, E002-04, E002-05).
///
/// s: a finite screen. p: any point.
///
/// Domain: right nowhere but by chance: that z is farther takes zoom + z. With centre 400, fov 500, zoom 1000
///   x = 600 goes to 450, 600, 1400 for z = -1000, 500, 900; to 500 for z = 1e-9, but it stays at 600 for
///   z = 0; to 100400 for z = 999, -99600 for z = 1001, and for z = 2000 to 300, mirrored.
/// Steps: LeftAlone | Divided.
/// Accuracy: none.
/// Cost: 2 divisions.
/// Errors: none, where there should be one: z = zoom divides by 0.
template <class T, Observer<LeftAlone<T>, Divided<T>> O = Unobserved>
Point2<T> zoom_minus_z(const WireScreen<T>& s, Point3<T> p, O&& observer = {}) {
  const auto [centre, fov, zoom] = s;
  // Nothing to do where z is 0
  if (p.z == T(0)) {
    if constexpr (observed<O>) observer(LeftAlone<T>{p});
    return Point2<T>(p);
  }
  const T w = zoom - p.z;
  const T x = fov * (p.x - centre.x);
  const T y = fov * (p.y - centre.y);
  const T column = x / w + centre.x;
  const T row = y / w + centre.y;
  const Point2<T> image{column, row};
  if constexpr (observed<O>) observer(Divided<T>{{x, y, p.z, w}, {image, p.z}});
  return image;
}

/// FAULTY: the vanishing point by the notes' rule for two-point perspective, "what is parallel to the y-plane
/// stays parallel" (errata E001-21).
///
/// m, v: as for vanishing_point.
///
/// Domain: right for directions that are not parallel to the xz-plane, and for those that are parallel to the
///   picture plane. All others of the xz-plane do vanish: seen along (1,0,1) the direction (1,0,1) at (0,0).
///   The rule holds for the y-axis.
/// Steps: StaysParallel | TakenToInfinity (Vanished | StaysParallel).
/// Accuracy: as vanishing_point where it is asked.
/// Cost: as vanishing_point.
/// Errors: ContractViolation for the direction 0.
template <class T, Observer<TakenToInfinity<T>, Vanished<T>, StaysParallel<T>> O = Unobserved>
std::optional<Point2<T>> parallel_by_plane(const glm::mat<4, 4, T>& m, Point3<T> v, O&& observer = {}) {
  expects(v != Point3<T>(T(0)), "a line has a direction, not the zero vector");
  // "Parallel to the y-plane"
  if (v.y == T(0)) {
    if constexpr (observed<O>) observer(StaysParallel<T>{v});
    return no_image;
  }
  return vanishing_point(m, v, observer);
}

}  // namespace gradus::perspective
