#pragma once
// Bézier patches: a net of control points, and a surface that begins and ends in the net's corners and stays
// within its convex hull. A point of it with tangents and normal; two patches joined, and how smooth that is.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/finite.hpp"
#include "core/contract.hpp"
#include "core/faces.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::bezier_patch {

using Index = std::size_t;

template <class T>
using Point = glm::vec<3, T>;
template <class T>
using Points = std::vector<Point<T>>;

/// In a row, and in a column.
inline constexpr Index most_points = 9;

/// A net of control points, row by row. Along a row goes u, from row to row v.
template <class T>
struct Patch {
  Index columns;
  Points<T> points;

  Index rows() const { return points.size() / columns; }
  Point<T>& operator()(Index row, Index column) { return points[row * columns + column]; }
  const Point<T>& operator()(Index row, Index column) const { return points[row * columns + column]; }
  Points<T> row(Index j) const {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(j * columns);
    return {begin, begin + static_cast<std::ptrdiff_t>(columns)};
  }
};

/// A curve at a place: its point, and its first and second derivative there.
template <class T>
struct Jet {
  Point<T> point{T(0)}, first{T(0)}, second{T(0)};

  /// From the last three and the last two points of de Casteljau's rounds; n: the degree.
  void take(const Points<T>& b, Index m, Index n) {
    if (m == 2) second = T(n) * T(n - 1) * ((b[2] - b[1]) - (b[1] - b[0]));
    if (m == 1) first = T(n) * (b[1] - b[0]);
  }
};

/// A surface at a place: its point, the tangents along u and along v, what lies across both.
template <class T>
struct Frame {
  Point<T> point, along_u, along_v, normal;
};

/// How far two patches differ along their seam, at most.
template <class T>
struct Seam {
  T gap;        ///< between the borders
  T angle;      ///< between the normals, in radians
  T slope;      ///< between the first derivatives across the seam
  T curvature;  ///< between the curvatures of the sections across the seam
};

/// What two patches have in common where they meet: the border; the tangent planes; the first derivatives;
/// the second ones, too.
enum class Continuity : std::uint8_t { C0, G1, C1, C2 };

// --- Steps -------------------------------------------------------

/// A row of control points was reduced to one, and a derivative.
template <class T>
struct RowReduced {
  Index row;  ///< from 0 on
  Points<T> control;
  Jet<T> at;
};

/// The column of these points was, too.
template <class T>
struct Reached {
  Points<T> column;
  Point<T> point;
};

template <class T>
struct TangentsFound {
  Point<T> along_u, along_v;
};

template <class T>
struct NormalFound {
  Point<T> normal;  ///< of any length; 0 where there is none
};

/// A row of the second patch was put where the first one asks for it.
template <class T>
struct RowSet {
  Index row;  ///< from the seam on
  Points<T> points;
};

template <class T>
struct SeamMeasured {
  Seam<T> seam;
};

// --- What the methods ask for ------------------------------------

/// The largest coordinate without its sign.
template <class T>
T largest_of(const Points<T>& points) {
  T most(0);
  for (const Point<T>& p : points) {
    for (int axis = 0; axis < 3; ++axis) most = std::max(most, p[axis] < T(0) ? -p[axis] : p[axis]);
  }
  return most;
}

template <class T>
void expect_patch(const Patch<T>& patch) {
  expects(2 <= patch.columns && patch.columns <= most_points, "a row has 2 to 9 control points, not {}",
          patch.columns);
  expects(patch.points.size() % patch.columns == 0, "{} control points make no rows of {}",
          patch.points.size(), patch.columns);
  expects(2 <= patch.rows() && patch.rows() <= most_points, "a patch has 2 to 9 rows, not {}", patch.rows());
  for (const Point<T>& p : patch.points) expects(all_finite(p.x, p.y, p.z), "a control point is not finite");
  if constexpr (std::floating_point<T>)
    expects(largest_of(patch.points) <= std::numeric_limits<T>::max() / 1024, "a coordinate is above {}",
            std::numeric_limits<T>::max() / 1024);
}

template <class T>
void expect_place(const T& u, const T& v) {
  expects(T(0) <= u && u <= T(1) && T(0) <= v && v <= T(1), "a patch has points for u, v from 0 to 1 only");
}

// --- A point -----------------------------------------------------

/// A curve's control points, reduced to one: of any two neighbours a point that divides their distance like
/// t, round after round. What is left before the last rounds gives the derivatives.
template <class T>
Jet<T> reduced(Points<T> b, const T& t) {
  const Index n = b.size() - 1;
  const T s = T(1) - t;
  Jet<T> jet;
  for (Index m = n; m > 0; --m) {
    // Derivatives: differences
    jet.take(b, m, n);
    for (Index i = 0; i < m; ++i) {
      auto a = b[i], c = b[i + 1];
      b[i] = s * a + t * c;
    }
  }
  jet.point = b[0];
  return jet;
}

/// Across both tangents. Where one vanishes on a border, what it grows by from there on takes its place, the
/// mixed derivative: so the tip of a patch with three sides has a normal.
/// S: the column of points at v. R: the column of the derivatives along u.
template <class T>
Point<T> across(const Jet<T>& S, const Jet<T>& R, const T& u, const T& v) {
  const Point<T> none(T(0)), &along_u = R.point, &along_v = S.first, &mixed = R.first;
  if (along_u == none && (v == T(0) || v == T(1))) return glm::cross(v == T(0) ? mixed : -mixed, along_v);
  if (along_v == none && (u == T(0) || u == T(1))) return glm::cross(along_u, u == T(0) ? mixed : -mixed);
  return glm::cross(along_u, along_v);
}

template <class T>
Frame<T> frame_of(const Jet<T>& S, const Jet<T>& R, const Point<T>& normal) {
  return {S.point, R.point, S.first, normal};
}

/// A point of a patch, its tangents and its normal: each row is reduced to one point at u, and the column of
/// these points at v.
/// Source: P. de Casteljau, Courbes et surfaces à pôles, 1963; P. Bézier, Numerical Control, 1972.
///
/// patch: its net. u, v: from 0 to 1, along the rows and from row to row.
///
/// Domain: 2 to 9 rows of 2 to 9 control points, finite, coordinates up to 1/1024 of the largest number;
///   0 <= u, v <= 1.
/// Steps: RowReduced for each row, Reached, TangentsFound, NormalFound.
/// Accuracy: with n and m the degrees along u and v, M the largest coordinate and u = 2^-53 in double: the
///   point within 2.5 (n + m) u M and n + m of the smallest subnormal numbers, corners exact; tangents within
///   5 k (n + m) u M and 2 k (n + m) of the smallest, k = n or m. The normal is their product, which has
///   their direction where it neither over- nor underflows.
/// Cost: n (n + 1) (m + 1) + 2 m (m + 1) products per coordinate, and as many for second derivatives.
/// Errors: ContractViolation outside the domain.
template <class T, Observer<RowReduced<T>, Reached<T>, TangentsFound<T>, NormalFound<T>> O = Unobserved>
Frame<T> de_casteljau(const Patch<T>& patch, const T& u, const T& v, O&& observer = {}) {
  expect_patch(patch);
  expect_place(u, v);
  const Index rows = patch.rows();
  Points<T> B, D;
  for (Index j = 0; j < rows; ++j) {
    // A row at u
    auto row = patch.row(j);
    auto b = reduced(row, u);
    if constexpr (observed<O>) observer(RowReduced<T>{j, row, b});
    B.push_back(b.point);
    D.push_back(b.first);
  }
  // The column of points at v
  const auto S = reduced(B, v);
  if constexpr (observed<O>) observer(Reached<T>{B, S.point});
  // That of the derivatives
  const auto R = reduced(D, v);
  if constexpr (observed<O>) observer(TangentsFound<T>{R.point, S.first});
  const auto N = across(S, R, u, v);
  if constexpr (observed<O>) observer(NormalFound<T>{N});
  return frame_of(S, R, N);
}

// --- A mesh ------------------------------------------------------

template <class T>
struct Surface {
  Points<T> points;
  Faces faces;
};

/// The surface as so many quadrilaterals along u and along v, counter-clockwise seen from where normals
/// point. Rows are reduced once for each u.
///
/// Domain: as de_casteljau; from 1 to 4096 along u and along v.
/// Accuracy: points as by de_casteljau, bit for bit. Twice as many along both leave a quarter of the distance
///   between surface and mesh.
/// Cost: of each column n (n + 1) (m + 1) products per coordinate, of each point m (m + 1).
/// Errors: ContractViolation outside the domain.
template <class T>
Surface<T> on_grid(const Patch<T>& patch, int across, int along) {
  expect_patch(patch);
  expects(1 <= across && across <= 4096 && 1 <= along && along <= 4096,
          "a grid has 1 to 4096 faces along u and v, not {} and {}", across, along);
  const auto width = static_cast<Index>(across) + 1, height = static_cast<Index>(along) + 1;
  Surface<T> surface{Points<T>(width * height), {}};
  for (Index i = 0; i < width; ++i) {
    Points<T> column;
    for (Index j = 0; j < patch.rows(); ++j)
      column.push_back(reduced(patch.row(j), T(i) / T(width - 1)).point);
    for (Index k = 0; k < height; ++k)
      surface.points[k * width + i] = reduced(column, T(k) / T(height - 1)).point;
  }
  for (Index k = 0; k + 1 < height; ++k) {
    for (Index i = 0; i + 1 < width; ++i) {
      const auto at = static_cast<std::int32_t>(k * width + i), up = static_cast<std::int32_t>(width);
      surface.faces.add(std::initializer_list<std::int32_t>{at, at + 1, at + 1 + up, at + up});
    }
  }
  return surface;
}

// --- Joining -----------------------------------------------------

template <class T>
void expect_joint(const Patch<T>& first, const Patch<T>& second) {
  expect_patch(first);
  expect_patch(second);
  expects(first.columns == second.columns && first.rows() == second.rows(),
          "patches of one size are joined, not {} by {} and {} by {}", first.rows(), first.columns,
          second.rows(), second.columns);
}

/// Puts the first rows of the second patch so that it goes on where the first one ends, at v = 1: for C0 the
/// border row, for G1 and C1 the next one too, on the lines on which the first patch arrives, for C2 a third.
/// The rows behind stay as they are.
/// Source: G. Farin, Curves and Surfaces for CAGD, 2002, chapters 5 and 16.
///
/// P, Q: of one size. order: what they shall have in common. k: for G1, how long the first edges of Q are
/// beside the last ones of P; the others ask for 1.
///
/// Domain: as de_casteljau; at least three rows for C2; 0 < k <= 16.
/// Steps: RowSet for each row that was put.
/// Accuracy: with M the largest coordinate of P and u = 2^-53 in double: the border exact, the next row
///   within (6 k + 1) u M, the third within 17 u M, and one of the smallest subnormal numbers.
/// Cost: at most five sums per control point and coordinate.
/// Errors: ContractViolation outside the domain.
template <class T, Observer<RowSet<T>> O = Unobserved>
Patch<T> join(const Patch<T>& P, Patch<T> Q, Continuity order, T k, O&& observer = {}) {
  expect_joint(P, Q);
  expects(T(0) < k && k <= T(16), "an edge is up to 16 times as long, and longer than 0");
  expects(order != Continuity::C2 || P.rows() >= 3, "second derivatives take three rows, not {}", P.rows());
  const Index n = P.columns;
  const Index m = P.rows() - 1;
  for (Index i = 0; i < n; ++i) {
    // The border is shared
    Q(0, i) = P(m, i);
  }
  if constexpr (observed<O>) observer(RowSet<T>{0, Q.row(0)});
  if (order == Continuity::C0) {
    return Q;
  }
  // C1 and C2: as long, too
  if (order != Continuity::G1) {
    k = T(1);
  }
  for (Index i = 0; i < n; ++i) {
    // On along the same line
    auto b = P(m, i);
    auto a = P(m - 1, i);
    Q(1, i) = b + k * (b - a);
  }
  if constexpr (observed<O>) observer(RowSet<T>{1, Q.row(1)});
  if (order != Continuity::C2) {
    return Q;
  }
  for (Index i = 0; i < n; ++i) {
    // As bent as on the other side
    auto b = P(m, i);
    auto a = P(m - 1, i);
    auto c = P(m - 2, i);
    Q(2, i) = c + T(4) * (b - a);
  }
  if constexpr (observed<O>) observer(RowSet<T>{2, Q.row(2)});
  return Q;
}

/// A patch at a place on its border, as it is felt by what goes across.
template <class T>
struct Crossing {
  Point<T> point, along_v, normal;  ///< the normal of length 1
  T curvature;                      ///< of the section across the border, positive towards the normal
};

/// Domain: as de_casteljau, with a normal there.
/// Accuracy: curvatures are as near as the tangents' lengths and the angle between them allow: no bound.
template <std::floating_point T>
Crossing<T> crossing(const Patch<T>& patch, T u, T v) {
  Points<T> B, D, E;
  for (Index j = 0; j < patch.rows(); ++j) {
    const Jet<T> b = reduced(patch.row(j), u);
    B.push_back(b.point);
    D.push_back(b.first);
    E.push_back(b.second);
  }
  const Jet<T> S = reduced(B, v), R = reduced(D, v);
  const Point<T> Suu = reduced(E, v).point, &Su = R.point, &Sv = S.first;
  const Point<T> normal = unit_vector(across(S, R, u, v));
  expects(normal != Point<T>(T(0)), "no normal at u = {}, v = {}", u, v);
  // The way across: Sv without what goes along Su
  const T square = glm::dot(Su, Su), part = square > T(0) ? glm::dot(Sv, Su) / square : T(0);
  const Point<T> way = Sv - part * Su, bend = S.second - T(2) * part * R.first + part * part * Suu;
  return {S.point, Sv, normal, glm::dot(bend, normal) / glm::dot(way, way)};
}

/// How far two patches differ where the second goes on behind the first: the worst of so many places along
/// the seam and its end.
/// Source: G. Farin, 2002, chapter 8 for curvature, 16 for patches.
///
/// P, Q: of one size; P at v = 1 meets Q at v = 0. places: at least 1.
///
/// Domain: as de_casteljau, with normals along the seam.
/// Steps: SeamMeasured.
/// Accuracy: at the places gap and slope as points and tangents. Between them they can be larger.
/// Cost: two frames with second derivatives for each place.
/// Errors: ContractViolation outside the domain, and where a patch has no normal.
template <std::floating_point T, Observer<SeamMeasured<T>> O = Unobserved>
Seam<T> measure(const Patch<T>& P, const Patch<T>& Q, int places, O&& observer = {}) {
  expect_joint(P, Q);
  expects(places >= 1, "at least one place, not {}", places);
  Seam<T> most{};
  for (int k = 0; k <= places; ++k) {
    const T u = T(k) / T(places);
    const auto a = crossing(P, u, T(1)), b = crossing(Q, u, T(0));
    const Point<T> turn = glm::cross(a.normal, b.normal);
    most.gap = std::max(most.gap, length_of(b.point - a.point));
    most.angle = std::max(most.angle, gradus::atan2(length_of(turn), glm::dot(a.normal, b.normal)));
    most.slope = std::max(most.slope, length_of(b.along_v - a.along_v));
    most.curvature = std::max(most.curvature, std::abs(b.curvature - a.curvature));
  }
  if constexpr (observed<O>) observer(SeamMeasured<T>{most});
  return most;
}

}  // namespace gradus::bezier_patch
