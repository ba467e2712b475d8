#pragma once
// Which side of a face the viewer sees: by its normal and the view vector, by its area in the picture, or
// before any division.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <ranges>
#include <span>

#include "core/arithmetic/exact.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"

namespace gradus::back_face_culling {

/// What the viewer sees of a face.
enum class Facing {
  front,    ///< its corners run counter-clockwise in the picture, y up
  back,     ///< clockwise: the inside of a closed body, never seen
  edge_on,  ///< the eye lies in its plane, or it has no area
};

/// The sign was taken.
template <class T>
struct Tested {
  glm::vec<4, T> a, b, c;  ///< in clip space
  int sign;                ///< of the determinant
  Facing facing;
};

/// The sign of det[a b c] of the corners' (x, y, w): -1, 0 or +1, without rounding.
/// It is six times the volume of the pyramid from the eye to the triangle, with its sign.
template <class T>
int determinant_sign(glm::vec<4, T> a, glm::vec<4, T> b, glm::vec<4, T> c) {
  using Vec = glm::vec<3, T>;
  // orient3d has the fourth point as its apex, here the eye, and the opposite sign
  return -orient3d(Vec{a.x, a.y, a.w}, Vec{b.x, b.y, b.w}, Vec{c.x, c.y, c.w}, Vec{T(0), T(0), T(0)});
}

/// Which side of the triangle a, b, c faces the viewer, told before any division: for w > 0 the determinant
/// has the sign of the area in the picture, and it stays right when corners lie behind the eye, where the
/// area does not.
/// Source: M. Olano, T. Greer, Triangle scan conversion using 2D homogeneous coordinates, 1997, section 4.
///
/// a, b, c: corners in clip space, counter-clockwise seen from outside.
///
/// Domain: finite, any w, also 0 and negative.
/// Steps: Tested.
/// Accuracy: exact; float, double and Exact decide alike.
/// Cost: about 6 ns, in doubt about 1 us.
/// Errors: ContractViolation for coordinates that are not finite.
template <class T, Observer<Tested<T>> O = Unobserved>
Facing facing(glm::vec<4, T> a, glm::vec<4, T> b, glm::vec<4, T> c, O&& observer = {}) {
  // det[x y w], for any signs of w
  int s = determinant_sign(a, b, c);
  Facing facing = Facing::edge_on;
  if (s > 0) facing = Facing::front;
  if (s < 0) facing = Facing::back;
  if constexpr (observed<O>) observer(Tested<T>{a, b, c, s, facing});
  return facing;
}

// --- Faces of any number of corners

/// The corners of a flat face, counter-clockwise seen from outside.
template <class T>
using Face = std::span<const glm::vec<3, T>>;

/// The same in the picture, y up.
template <class T>
using Outline = std::span<const glm::vec<2, T>>;

/// Where the eye is: a point, w = 1; or at w = 0 the direction towards an eye that is infinitely far away.
template <class T>
using Eye = glm::vec<4, T>;

/// A face has its normal.
template <class T>
struct NormalFound {
  std::size_t face;
  glm::vec<3, T> normal;  ///< as long as its doubled area
};

/// The view vector was taken.
template <class T>
struct ViewTaken {
  std::size_t face;
  glm::vec<3, T> at, view;  ///< from this corner to the eye, or towards it
};

/// A triangle from the first corner was added to the area.
template <class T>
struct TriangleAdded {
  std::size_t face, corner;  ///< with this corner and the next one
  T area, sum;               ///< doubled, positive where it runs counter-clockwise
};

/// The sign was taken, and with it the decision.
template <class T>
struct Judged {
  std::size_t face;
  T value;   ///< a product, an area, a determinant, rounded
  int sign;  ///< of its exact value
  Facing facing;
};

/// All faces are tested.
struct Finished {
  std::size_t tests, drawn;
};

/// Counts the faces that are drawn.
struct Drawn {
  std::size_t drawn = 0;

  /// A step as it is told.
  template <class Step>
  constexpr Step operator()(Step step) {
    if constexpr (requires { step.drawn; })
      step.drawn = drawn;
    else
      drawn += step.sign > 0;
    return step;
  }
};

/// from, from + 1, …, end - 1.
constexpr auto numbers(std::size_t from, std::size_t end) { return std::views::iota(from, end); }

/// Those of all elements.
template <class T>
constexpr auto numbers_of(std::span<T> all) {
  return numbers(0, all.size());
}

/// What a sign says.
constexpr Facing facing_of(int sign) {
  if (sign == 0) return Facing::edge_on;
  return sign > 0 ? Facing::front : Facing::back;
}

namespace detail {

template <class T>
int sign_of(const T& x) {
  return (x > T{0}) - (x < T{0});
}

/// The sign of a rounded value that is off by at most `bound`, or 2 where that leaves it open.
template <class T>
int sure_sign(T value, T bound) {
  if (value > bound) return 1;
  if (-value > bound) return -1;
  return 2;
}

/// The farthest that a corner lies from the first one, along an axis.
template <int N, class T>
T reach_of(std::span<const glm::vec<N, T>> ring) {
  T reach{0};
  for (const auto& p : ring) {
    for (int k = 0; k < N; ++k) reach = std::max(reach, std::abs(p[k] - ring[0][k]));
  }
  return reach;
}

/// What products lose to underflow at most, for any number of corners.
template <std::floating_point T>
inline constexpr T lost = std::same_as<T, float> ? T(0x1p-100) : T(0x1p-1000);

/// Adds det(u, v, w), or takes it away.
template <class T>
void add_determinant(SumOfProducts<3>& sum, bool minus, glm::vec<3, T> u, glm::vec<3, T> v,
                     glm::vec<3, T> w) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double plus[] = {u[i], v[j], w[k]}, less[] = {u[i], v[k], w[j]};
    const auto &a = minus ? less : plus, &b = minus ? plus : less;
    sum.add(a[0], a[1], a[2]);
    sum.subtract(b[0], b[1], b[2]);
  }
}

/// The sign of N . (E - w P), multiplied out.
template <std::floating_point T>
int side_multiplied_out(Face<T> face, const Eye<T>& eye) {
  SumOfProducts<3> sum;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const auto &a = face[i], &b = face[(i + 1) % face.size()];
    add_determinant(sum, false, a, b, glm::vec<3, T>(eye));
    if (eye.w != 0) add_determinant(sum, true, a, b, face[0]);
  }
  return sum.sign();
}

/// The sign of the area, multiplied out.
template <std::floating_point T>
int turn_multiplied_out(Outline<T> ring) {
  SumOfProducts<2> sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum.add(static_cast<double>(a.x), static_cast<double>(b.y));
    sum.subtract(static_cast<double>(b.x), static_cast<double>(a.y));
  }
  return sum.sign();
}

}  // namespace detail

/// From the face's first corner to the eye; towards it where it is infinitely far away.
template <class T>
glm::vec<3, T> view_vector(Face<T> face, const Eye<T>& eye) {
  return glm::vec<3, T>(eye) - eye.w * face[0];
}

/// The exact sign of N . V, of which `product` is the rounded value.
/// Domain: as normal_and_view. Accuracy: exact. Cost: some 5 ns, in doubt about 1 us per corner.
template <class T>
int sign_of(T product, Face<T> face, const Eye<T>& eye) {
  if constexpr (std::floating_point<T>) {
    // Off by less than m (16 + 2m) u per product of the corners' reach, its square, and the view vector
    const T m = static_cast<T>(face.size() - 2), reach = detail::reach_of(face);
    const glm::vec<3, T> view = view_vector(face, eye);
    const T size = std::abs(view.x) + std::abs(view.y) + std::abs(view.z);
    const T bound = 2 * std::numeric_limits<T>::epsilon() * m * (8 + m) * reach * reach * size +
                    m * detail::lost<T> * (1 + size);
    const int sure = detail::sure_sign(product, bound);
    return sure != 2 ? sure : detail::side_multiplied_out(face, eye);
  } else {
    return detail::sign_of(product);
  }
}

/// The exact sign of det = N . P, of which `det` is the rounded value: the eye is at 0, so that V = -P.
/// Domain, Accuracy, Cost: as homogeneous.
template <class T>
int sign_of(T det, Face<T> face) {
  return -sign_of(T(-det), face, Eye<T>{T{0}, T{0}, T{0}, T{1}});
}

/// The exact sign of the area, of which `area` is the rounded value.
/// Domain: as screen_area. Accuracy: exact. Cost: some 3 ns, in doubt about 0.1 us per corner.
template <class T>
int sign_of(T area, Outline<T> ring) {
  if constexpr (std::floating_point<T>) {
    const T m = static_cast<T>(ring.size() - 2), reach = detail::reach_of(ring);
    const T bound = 2 * std::numeric_limits<T>::epsilon() * m * (4 + m) * reach * reach + m * detail::lost<T>;
    const int sure = detail::sure_sign(area, bound);
    return sure != 2 ? sure : detail::turn_multiplied_out(ring);
  } else {
    return detail::sign_of(area);
  }
}

/// The normal of a face by all its corners, as long as its doubled area: the sum of the normals of the
/// triangles from the first corner on, which a concave face turns both ways.
/// Source: M. E. Newell; I. E. Sutherland, R. F. Sproull, R. A. Schumacker, A characterization of ten
/// hidden-surface algorithms, ACM Computing Surveys 6(1), 1974, 1-55, section 2.
///
/// face: at least 3 corners; they need not lie in one plane, and the first three may lie on a line.
///
/// Domain: finite, extents up to 1e150 (of double). The zero vector for a face without area.
/// Steps: none.
/// Accuracy: with n corners no farther than r from the first one along any axis, each component is within
///   (n - 2)(4 + 2n) u r^2 of the sum without rounding. With a rational scalar nothing is rounded.
/// Cost: 18 operations per triangle.
/// Errors: ContractViolation for fewer than 3 corners.
template <class T>
glm::vec<3, T> newell_normal(Face<T> face) {
  expects(face.size() >= 3, "expected faces of at least 3 corners, found {}", face.size());
  glm::vec<3, T> sum{T{0}, T{0}, T{0}};
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const auto p = face[i] - face[0];
    const auto q = face[i + 1] - face[0];
    sum += glm::cross(p, q);
  }
  return sum;
}

/// Gives `draw` the faces that show their front: the normal and the view vector, from the face to the eye,
/// point to the same side of its plane. One test per face, in the space where the faces are (object space).
/// Source: I. E. Sutherland, R. F. Sproull, R. A. Schumacker, A characterization of ten hidden-surface
/// algorithms, ACM Computing Surveys 6(1), 1974, 1-55, section 2.
///
/// faces: counter-clockwise seen from outside. eye: a point, w = 1; or the direction towards a distant one,
/// w = 0. draw(i): takes the number of each face that is seen from its front.
///
/// Domain: finite. What shows no front is never drawn: faces seen edge-on or without area. A face whose
///   corners lie beside one plane is judged at its first corner.
/// Steps: (NormalFound ViewTaken Judged)* Finished
/// Accuracy: the sign is exact for all finite doubles, floats and Exact; product, normal and view vector, as
///   they are reported, are rounded.
/// Cost: one normal and one product per face, some 16 ns per triangle; in doubt some 0.5 us per corner.
/// Errors: ContractViolation for fewer than 3 corners, for coordinates that are not finite, for another w.
template <class T, class Draw, Observer<NormalFound<T>, ViewTaken<T>, Judged<T>, Finished> O = Unobserved>
void normal_and_view(std::span<const Face<T>> faces, const Eye<T>& eye, Draw&& draw, O&& observer = {}) {
  expects(eye.w == T{0} || eye.w == T{1}, "expected an eye with w = 0 or 1, found another w");
  Tally<O, Drawn> tally(observer);
  for (auto i : numbers_of(faces)) {
    const Face<T> P = faces[i];
    // Newell's, by all corners
    auto N = newell_normal(P);
    if constexpr (observed<O>) observer(NormalFound<T>{i, N});
    // From the face to the eye
    auto V = view_vector(P, eye);
    if constexpr (observed<O>) observer(ViewTaken<T>{i, P[0], V});
    const T dot = glm::dot(N, V);
    // Its sign, without rounding
    int sign = sign_of(dot, P, eye);
    if constexpr (observed<O>) observer(tally.count(Judged<T>{i, dot, sign, facing_of(sign)}));
    if (sign > 0) draw(i);
  }
  if constexpr (observed<O>) observer(tally.count(Finished{faces.size(), 0}));
}

/// Gives `draw` the faces that run counter-clockwise in the picture: their area there is positive. One test a
/// face, after the projection (image space).
/// Source: the area of a polygon by its corners (C. F. Gauss; the shoelace formula), a corner subtracted
/// first; J. F. Blinn, A trip down the graphics pipeline: backface culling snags, IEEE CG&A 13(6), 1993,
/// 94-97.
///
/// faces: outlines in the picture, y up. draw(i): as normal_and_view.
///
/// Domain: finite. All corners lie in front of the eye: else clip first, or see homogeneous.
/// Steps: (TriangleAdded+ Judged)* Finished
/// Accuracy: the sign is exact for all finite doubles, floats and Exact, of the corners as they are given; of
///   corners that were rounded before, it may be another than in space. The area, as it is reported, is
///   rounded.
/// Cost: 8 operations per triangle, some 5 ns per face; in doubt some 0.5 us.
/// Errors: ContractViolation for fewer than 3 corners, for coordinates that are not finite.
template <class T, class Draw, Observer<TriangleAdded<T>, Judged<T>, Finished> O = Unobserved>
void screen_area(std::span<const Outline<T>> faces, Draw&& draw, O&& observer = {}) {
  Tally<O, Drawn> tally(observer);
  for (auto i : numbers_of(faces)) {
    const Outline<T> P = faces[i];
    expects(P.size() >= 3, "expected faces of at least 3 corners, found {}", P.size());
    T sum{0};
    const auto m = P.size() - 1;
    for (auto k : numbers(1, m)) {
      auto p = P[k] - P[0];
      auto q = P[k + 1] - P[0];
      // The doubled area
      T area = p.x * q.y;
      area -= q.x * p.y;
      sum += area;
      if constexpr (observed<O>) observer(TriangleAdded<T>{i, k, area, sum});
    }
    // Its sign, without rounding
    int sign = sign_of(sum, P);
    if constexpr (observed<O>) observer(tally.count(Judged<T>{i, sum, sign, facing_of(sign)}));
    if (sign > 0) draw(i);
  }
  if constexpr (observed<O>) observer(tally.count(Finished{faces.size(), 0}));
}

/// Gives `draw` the faces that show their front, told before any division, as facing does of triangles.
/// Source: Olano and Greer 1997, as facing.
///
/// faces: the corners' (x, y, w) in clip space. draw(i): as normal_and_view.
///
/// Domain: finite, any w, also 0 and negative.
/// Steps: Judged* Finished
/// Accuracy: the sign is exact for all finite doubles, floats and Exact; the determinant, as it is reported,
///   is rounded.
/// Cost: as normal_and_view.
/// Errors: ContractViolation for fewer than 3 corners, for coordinates that are not finite.
template <class T, class Draw, Observer<Judged<T>, Finished> O = Unobserved>
void homogeneous(std::span<const Face<T>> faces, Draw&& draw, O&& observer = {}) {
  Tally<O, Drawn> tally(observer);
  for (auto i : numbers_of(faces)) {
    const Face<T> P = faces[i];
    // det[x y w], nothing divided
    auto N = newell_normal(P);
    const T det = glm::dot(N, P[0]);
    // Its sign, without rounding
    int sign = sign_of(det, P);
    if constexpr (observed<O>) observer(tally.count(Judged<T>{i, det, sign, facing_of(sign)}));
    if (sign > 0) draw(i);
  }
  if constexpr (observed<O>) observer(tally.count(Finished{faces.size(), 0}));
}

}  // namespace gradus::back_face_culling
