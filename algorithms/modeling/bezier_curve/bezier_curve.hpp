#pragma once
// Bézier curves: a few control points, and a polynomial that begins in the first, ends in the last and stays
// within their convex hull. Its points, its parts, more control points for the same curve, chords for it.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/arithmetic/finite.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::bezier_curve {

using Index = std::size_t;

template <int N, class T>
using Point = glm::vec<N, T>;
template <int N, class T>
using Points = std::vector<Point<N, T>>;
/// Control points, in their order: one more than the curve's degree.
template <int N, class T>
using Polygon = std::span<const Point<N, T>>;

/// Up to here each binomial coefficient is a float.
inline constexpr Index most_degree = 24;

/// A tolerance may be as small in parts of the largest coordinate: beyond, roundings could be felt.
template <std::floating_point T>
inline const T least_part = std::ldexp(T(1), -std::numeric_limits<T>::digits / 2);

// --- Steps -------------------------------------------------------

/// A point was found at t between two neighbours of the round before.
template <int N, class T>
struct Mixed {
  Index round;  ///< from 1 on
  Index i;      ///< in its round, from 0 on
  Point<N, T> a, c, point;
};

/// The curve's point at t.
template <int N, class T>
struct Reached {
  Point<N, T> point;
};

/// A control point was added with its weight at t.
template <int N, class T>
struct Weighed {
  Index i;  ///< from 0 on
  Point<N, T> control;
  T weight;
  Point<N, T> sum;  ///< so far
};

/// The curve up to t and the rest, each with control points of its own.
template <int N, class T>
struct Halves {
  Points<N, T> first, rest;
};

/// A control point of the same curve, one degree higher, was found on an edge.
template <int N, class T>
struct Raised {
  Index i;  ///< of the new point, from 1 on
  Point<N, T> a, c;
  T share;  ///< of the edge's begin
  Point<N, T> point;
};

/// A part of a curve, and the values of t at which it begins and ends there.
template <int N, class T>
struct Piece {
  T from, to;
  Points<N, T> b;

  const Point<N, T>& end() const { return b.back(); }
};

/// A piece has given way to its chord, which is near enough.
template <int N, class T>
struct Flattened {
  Piece<N, T> piece;
  T off;  ///< as far as the curve may be from it
};

/// It was not, and the piece was cut in its middle.
template <int N, class T>
struct Halved {
  Piece<N, T> piece;
  T off;
};

struct Finished {
  Index count;  ///< of control points, or of chords
};

// --- What the methods ask for ------------------------------------

/// The largest coordinate without its sign.
template <int N, class T>
T largest_of(Polygon<N, T> control) {
  T most(0);
  for (const Point<N, T>& p : control) {
    for (int axis = 0; axis < N; ++axis) most = std::max(most, p[axis] < T(0) ? -p[axis] : p[axis]);
  }
  return most;
}

template <int N, class T>
void expect_curve(Polygon<N, T> control) {
  expects(2 <= control.size() && control.size() <= most_degree + 1,
          "a curve has 2 to 25 control points, not {}", control.size());
  for (const Point<N, T>& p : control) {
    for (int axis = 0; axis < N; ++axis) expects(all_finite(p[axis]), "a control point is not finite");
  }
  if constexpr (std::floating_point<T>)
    expects(largest_of(control) <= std::numeric_limits<T>::max() / 4, "a coordinate is above {}",
            std::numeric_limits<T>::max() / 4);
}

template <int N, class T>
void expect_point_of(Polygon<N, T> control, const T& t) {
  expect_curve(control);
  expects(T(0) <= t && t <= T(1), "a curve has points for t from 0 to 1 only");
}

template <int N, class T>
Points<N, T> copy_of(Polygon<N, T> control) {
  return {control.begin(), control.end()};
}

// --- A point -----------------------------------------------------

/// The point of a curve at t: between any two neighbours a point that divides their distance like t, and so
/// on with those, one fewer each round, until one is left. The edge on which it lies is the tangent.
/// Source: P. de Casteljau, Outillages méthodes calcul, 1959; W. Boehm, A. Müller, On de Casteljau's
/// algorithm, 1999.
///
/// control: the control points, of the plane or of space. t: from 0, the first of them, to 1, the last.
///
/// Domain: 2 to 25 control points, finite, coordinates up to a quarter of the largest number; 0 <= t <= 1:
///   beyond, nothing would hold the curve together.
/// Steps: Mixed for each point of each round, Reached.
/// Accuracy: each coordinate within 2.5 n u M of the exact one and n of the smallest subnormal numbers; n is
///   the degree, M the largest coordinate, u = 2^-53 in double. The ends are exact.
/// Cost: n (n + 1) products per coordinate.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Mixed<N, T>, Reached<N, T>> O = Unobserved>
Point<N, T> de_casteljau(Polygon<N, T> control, const T& t, O&& observer = {}) {
  expect_point_of<N, T>(control, t);
  auto b = copy_of<N, T>(control);
  const Index n = b.size() - 1;
  const T s = T(1) - t;
  for (Index m = n; m > 0; --m) {
    for (Index i = 0; i < m; ++i) {
      // Between two neighbours
      auto a = b[i], c = b[i + 1];
      b[i] = s * a + t * c;
      if constexpr (observed<O>) observer(Mixed<N, T>{n - m + 1, i, a, c, b[i]});
    }
  }
  if constexpr (observed<O>) observer(Reached<N, T>{b[0]});
  return b[0];
}

/// How much control point i of a curve of degree n counts at t: (n over i) t^i (1 - t)^(n - i).
/// Domain: i <= n <= 24, 0 <= t <= 1.
template <class T>
T weight(Index n, Index i, const T& t) {
  const T s = T(1) - t;
  Index ways = 1;
  for (Index k = 0; k < i; ++k) ways = ways * (n - k) / (k + 1);
  T w = T(ways);
  for (Index k = 0; k < i; ++k) w = w * t;
  for (Index k = i; k < n; ++k) w = w * s;
  return w;
}

/// The same point as a mean of the control points: their weights are the Bernstein polynomials, which are not
/// negative and add up to 1. So the curve stays in the convex hull, and moves with its points.
/// Source: S. Bernstein, Démonstration du théorème de Weierstrass, 1912; A. R. Forrest, Interactive
/// interpolation and approximation by Bézier polynomials, 1972.
///
/// control, t: as for de_casteljau.
///
/// Domain: as de_casteljau.
/// Steps: Weighed for each control point, Reached.
/// Accuracy: each coordinate within (3 n + 4) u M of the exact one and n + 1 of the smallest subnormal ones;
///   the ends are exact.
/// Cost: n (n + 1) products for the weights, one per control point and coordinate.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Weighed<N, T>, Reached<N, T>> O = Unobserved>
Point<N, T> bernstein(Polygon<N, T> control, const T& t, O&& observer = {}) {
  expect_point_of<N, T>(control, t);
  Index n = control.size() - 1;
  Point<N, T> p(T(0));
  for (Index i = 0; i <= n; ++i) {
    // How much P_i counts
    const T w = weight(n, i, t);
    p += w * control[i];
    if constexpr (observed<O>) observer(Weighed<N, T>{i, control[i], w, p});
  }
  if constexpr (observed<O>) observer(Reached<N, T>{p});
  return p;
}

// --- Other control points of the same curve ----------------------

/// What split does, unasked.
template <int N, class T, Observer<Mixed<N, T>, Halves<N, T>> O = Unobserved>
Halves<N, T> cut_at(Points<N, T> b, const T& t, O&& observer = {}) {
  const Index n = b.size() - 1;
  const T s = T(1) - t;
  Points<N, T> first{b[0]};
  for (Index m = n; m > 0; --m) {
    for (Index i = 0; i < m; ++i) {
      auto a = b[i], c = b[i + 1];
      b[i] = s * a + t * c;
      if constexpr (observed<O>) observer(Mixed<N, T>{n - m + 1, i, a, c, b[i]});
    }
    // The first of each round
    first.push_back(b[0]);
  }
  // And what is left: the last ones
  if constexpr (observed<O>) observer(Halves<N, T>{first, b});
  return {first, b};
}

/// Cuts a curve at t: the first points of de Casteljau's rounds are the control points of the part up to t,
/// the last ones those of the rest.
/// Source: J. M. Lane, R. F. Riesenfeld, A theoretical development for the computer generation and display of
/// piecewise polynomial surfaces, 1980.
///
/// control, t: as for de_casteljau.
///
/// Domain: as de_casteljau.
/// Steps: Mixed for each point of each round, Halves.
/// Accuracy: each control point within 2.5 n u M and n of the smallest subnormal numbers; so is each point of
///   the parts beside that of the curve, for roundings are mixed as points are. Both meet in one point, bit
///   for bit, and the ends are exact.
/// Cost: as de_casteljau.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Mixed<N, T>, Halves<N, T>> O = Unobserved>
Halves<N, T> split(Polygon<N, T> control, const T& t, O&& observer = {}) {
  expect_point_of<N, T>(control, t);
  return cut_at<N, T>(copy_of<N, T>(control), t, observer);
}

/// The control points of the same curve as one of a degree higher: the ends, and a point on each edge. Their
/// polygon lies nearer to the curve.
/// Source: A. R. Forrest, Interactive interpolation and approximation by Bézier polynomials, 1972.
///
/// control: as for de_casteljau.
///
/// Domain: as de_casteljau, with at most 24 control points.
/// Steps: Raised for each edge, Finished.
/// Accuracy: each coordinate within 3 u M and one of the smallest subnormal numbers.
/// Cost: two quotients per new point, two products per coordinate.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Raised<N, T>, Finished> O = Unobserved>
Points<N, T> raise_degree(Polygon<N, T> control, O&& observer = {}) {
  expect_curve<N, T>(control);
  expects(control.size() <= most_degree, "the degree is {} already", most_degree);
  const Index n = control.size();
  Points<N, T> raised{control[0]};
  for (Index i = 1; i < n; ++i) {
    // On the edge before point i
    auto a = control[i - 1];
    auto c = control[i];
    const T s = T(i) / T(n);
    const T t = T(n - i) / T(n);
    raised.push_back(s * a + t * c);
    if constexpr (observed<O>) observer(Raised<N, T>{i, a, c, s, raised.back()});
  }
  raised.push_back(control[n - 1]);
  if constexpr (observed<O>) observer(Finished{raised.size()});
  return raised;
}

// --- Chords ------------------------------------------------------

/// As far as a curve can lie from its chord. The chord has control points, too, the n-th parts of its length;
/// what the curve's differ from them is mixed to what the two differ, and the ends, which don't differ, count
/// for at least 2^(1 - n).
template <int N, class T>
T off_chord(const Points<N, T>& b) {
  const Index n = b.size() - 1;
  T most(0);
  for (Index i = 1; i < n; ++i) {
    const Point<N, T> even = T(n - i) / T(n) * b[0] + T(i) / T(n) * b[n];
    most = std::max(most, length_of(b[i] - even));
  }
  return most * (T(1) - std::ldexp(T(2), -static_cast<int>(n)));
}

/// A piece, cut in its middle.
template <int N, class T>
struct CutPiece {
  Piece<N, T> first, rest;
};
template <int N, class T>
CutPiece<N, T> cut(const Piece<N, T>& piece) {
  const T middle = (piece.from + piece.to) / 2;
  auto [first, rest] = cut_at<N, T>(piece.b, T(0.5));
  return {{piece.from, middle, std::move(first)}, {middle, piece.to, std::move(rest)}};
}
template <int N, class T>
void add(CutPiece<N, T> halves, std::vector<Piece<N, T>>& waiting) {
  waiting.push_back(std::move(halves.rest));
  waiting.push_back(std::move(halves.first));
}
template <int N, class T>
std::vector<Piece<N, T>> whole_of(Polygon<N, T> control) {
  return {{T(0), T(1), copy_of(control)}};
}
template <int N, class T>
Piece<N, T> next_of(std::vector<Piece<N, T>>& waiting) {
  Piece<N, T> last = std::move(waiting.back());
  waiting.pop_back();
  return last;
}

/// A curve as chords, none farther from it than the tolerance: pieces whose control points say that they are
/// flat are replaced by their chord, others are cut in the middle.
/// Source: J. M. Lane, R. F. Riesenfeld, 1980; the bound is much like that of F. Wang, The subdivision
/// algorithm for the generation of Bézier curves, 1984.
///
/// control: as for de_casteljau. tolerance: a distance. Returns the ends of the chords.
///
/// Domain: as de_casteljau; a tolerance of at least 2^-26 M in double, 2^-12 M in float, and normal.
/// Steps: (Flattened | Halved)*, Finished.
/// Accuracy: at each of its points the curve is within the tolerance of the chord that stands for it, but for
///   2.5 n k u M where a piece was cut out by k cuts; the ends are exact.
/// Cost: a length per inner control point of each piece, a cut for all but the last pieces; for a quarter of
///   the tolerance about twice as many.
/// Errors: ContractViolation outside the domain.
template <int N, std::floating_point T, Observer<Flattened<N, T>, Halved<N, T>, Finished> O = Unobserved>
Points<N, T> flatten(Polygon<N, T> control, T tolerance, O&& observer = {}) {
  expect_curve<N, T>(control);
  expects(tolerance >= std::max(least_part<T> * largest_of<N, T>(control), std::numeric_limits<T>::min()),
          "a tolerance of {} is too small for these coordinates", tolerance);
  auto waiting = whole_of(control);
  Points<N, T> line{control[0]};
  while (!waiting.empty()) {
    auto piece = next_of(waiting);
    T off = off_chord(piece.b);
    if (off <= tolerance) {
      // Its chord stands for it
      line.push_back(piece.end());
      if constexpr (observed<O>) observer(Flattened<N, T>{piece, off});
      continue;
    }
    // Its first half comes next
    add(cut(piece), waiting);
    if constexpr (observed<O>) observer(Halved<N, T>{piece, off});
  }
  if constexpr (observed<O>) observer(Finished{line.size() - 1});
  return line;
}

}  // namespace gradus::bezier_curve
