#pragma once
// B-splines: a curve in pieces, each of which depends on a few control points alone, and knots, which say
// where one piece ends and the next begins. Its points, the weights behind them, more control points for the
// same curve, its pieces as Bézier curves; and with weights of the points' own, circles.

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

namespace gradus::b_spline {

using Index = std::size_t;

template <int N, class T>
using Point = glm::vec<N, T>;
template <int N, class T>
using Points = std::vector<Point<N, T>>;

inline constexpr Index most_degree = 10;

/// Control points with their knots, u[0] <= u[1] <= …, which are degree + 1 more. Control point i counts from
/// knot i to knot i + degree + 1; the curve has points from knot `degree` to the knot as far from the last.
template <int N, class T>
struct Spline {
  std::span<const Point<N, T>> control;
  std::span<const T> knots;

  Index degree() const { return knots.size() - control.size() - 1; }
  const T& begin() const { return knots[degree()]; }
  const T& end() const { return knots[control.size()]; }
};

/// The same, with what it is made of.
template <int N, class T>
struct Curve {
  Points<N, T> control;
  std::vector<T> knots;

  Spline<N, T> spline() const { return {control, knots}; }
};

// --- Steps -------------------------------------------------------

/// A point was found between two neighbours of the round before, as t lies between two knots.
template <int N, class T>
struct Mixed {
  Index round;  ///< from 1 on
  Index i;      ///< of the first neighbour, counted as the control points are
  Point<N, T> a, c;
  T lo, hi;  ///< the knots
  Point<N, T> point;
};

/// The curve's point at t.
template <int N, class T>
struct Reached {
  Point<N, T> point;
};

/// A point of the weighted curve was divided by its weight, the last coordinate.
template <int N, class T>
struct Divided {
  Point<N + 1, T> weighted;
  Point<N, T> point;
};

/// All weights of one degree at t that are not 0.
template <class T>
struct Spread {
  Index degree, first;  ///< first: the number of the first of them
  std::vector<T> weights;
};

/// A control point was added with its weight at t.
template <int N, class T>
struct Weighed {
  Index i;
  Point<N, T> control;
  T weight;
  Point<N, T> sum;  ///< so far
};

/// A control point of the same curve with one knot more was found on an edge.
template <int N, class T>
struct Placed {
  T t;      ///< the new knot
  Index i;  ///< of the new point
  Point<N, T> a, c;
  T lo, hi;  ///< the knots between which the new one divides as the point does the edge
  Point<N, T> point;
};

/// The same curve with one knot more.
template <int N, class T>
struct Inserted {
  T t;
  Curve<N, T> curve;
};

struct Finished {
  Index count;  ///< of pieces
};

// --- What the methods ask for ------------------------------------

template <int N, class T>
void expect_points(std::span<const Point<N, T>> control) {
  for (const Point<N, T>& p : control) {
    for (int axis = 0; axis < N; ++axis) {
      expects(all_finite(p[axis]), "a control point is not finite");
      if constexpr (std::floating_point<T>)
        expects(std::abs(p[axis]) <= std::numeric_limits<T>::max() / 4, "a coordinate is too large: {}",
                p[axis]);
    }
  }
}

template <class T>
void expect_knots(std::span<const T> knots, Index degree) {
  for (Index i = 0; i < knots.size(); ++i) {
    expects(all_finite(knots[i]), "knot {} is not finite", i);
    if constexpr (std::floating_point<T>)
      expects(std::abs(knots[i]) <= std::numeric_limits<T>::max() / 4, "knot {} is too large", i);
    expects(i == 0 || knots[i - 1] <= knots[i], "knot {} is below the one before", i);
    expects(i <= degree || knots[i - degree - 1] < knots[i],
            "more than degree + 1 = {} knots coincide: up to knot {}", degree + 1, i);
  }
}

template <int N, class T>
void expect_spline(const Spline<N, T>& spline) {
  const Index points = spline.control.size(), knots = spline.knots.size();
  expects(knots >= points + 2 && knots - points - 1 <= most_degree,
          "{} control points take 2 to {} knots more, not {} in all", points, most_degree + 1, knots);
  expects(points > spline.degree(), "{} control points are too few for degree {}", points, spline.degree());
  expect_points(spline.control);
  expect_knots(spline.knots, spline.degree());
  expects(spline.begin() < spline.end(), "the knots leave no room for a curve of degree {}", spline.degree());
}

template <int N, class T>
void expect_point_of(const Spline<N, T>& spline, const T& t) {
  expect_spline(spline);
  expects(spline.begin() <= t && t <= spline.end(), "the curve has no point at t outside its knots");
}

/// The number of the last knot that is not above t, with a span behind it; where the curve ends, the last
/// span before that. Domain: a spline, t where it has points.
template <int N, class T>
Index span_of(const Spline<N, T>& spline, const T& t) {
  const auto u = spline.knots;
  Index k = spline.degree();
  for (Index i = k; i < spline.control.size(); ++i) {
    if (u[i] <= t && u[i] < u[i + 1]) k = i;
  }
  return k;
}

/// The point between a and c that divides their distance as t does that of lo and hi, from the nearer end: so
/// it takes fewest roundings, and is a or c where t is lo or hi.
template <int N, class T>
Point<N, T> mix(const Point<N, T>& a, const Point<N, T>& c, const T& lo, const T& t, const T& hi) {
  const T up = t - lo, down = hi - t, all = hi - lo;
  return up <= down ? a + up / all * (c - a) : c - down / all * (c - a);
}

/// The control points that count in the span from knot k on.
template <int N, class T>
Points<N, T> points_of(const Spline<N, T>& spline, Index k) {
  const auto its = spline.control.subspan(k - spline.degree(), spline.degree() + 1);
  return {its.begin(), its.end()};
}

// --- A point -----------------------------------------------------

/// The point of a spline at t: between any two neighbours of the control points that count there a point, and
/// so on with those, one fewer each round, until one is left. Each divides its edge as t does the knots
/// around it: in the first round those that are farthest apart, in the last the two next to t. Source: C. de
/// Boor, On calculating with B-splines, Journal of Approximation Theory 6, 1972.
///
/// spline: control points of the plane or of space, and knots. t: where, between the knots that it has points
/// for; at an inner knot the piece that begins there counts, at the end the last one.
///
/// Domain: degree 1 to 10; finite numbers up to a quarter of the largest; knots in order, of which at most
///   degree + 1 coincide; t from spline.begin() to spline.end(), which differ.
/// Steps: Mixed for each point of each round, Reached.
/// Accuracy: each coordinate within 5 n u M of the exact one and n of the smallest subnormal numbers;
///   n is the degree, M the largest coordinate, u = 2^-53 in double. At a knot that is there n times it is
///   the control point, bit for bit.
/// Cost: n (n + 1) / 2 quotients, and as many products per coordinate; the span is searched one by one.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Mixed<N, T>, Reached<N, T>> O = Unobserved>
Point<N, T> de_boor(const Spline<N, T>& spline, const T& t, O&& observer = {}) {
  expect_point_of(spline, t);
  const auto u = spline.knots;
  const Index n = spline.degree();
  Index k = span_of(spline, t);
  auto d = points_of(spline, k);
  for (Index m = n; m > 0; --m) {
    for (Index i = 0; i < m; ++i) {
      // Between two neighbours
      auto a = d[i], c = d[i + 1];
      // m knots up to t, m after
      const Index j = k + 1 + i;
      T lo = u[j - m], hi = u[j];
      d[i] = mix(a, c, lo, t, hi);
      if constexpr (observed<O>) observer(Mixed<N, T>{n - m + 1, k - n + i, a, c, lo, hi, d[i]});
    }
  }
  if constexpr (observed<O>) observer(Reached<N, T>{d[0]});
  return d[0];
}

/// What a weight of degree d takes over from two of one degree lower: it rises over the spans of the first
/// and falls over those of the second.
template <class T>
T blended(const std::vector<T>& w, std::span<const T> u, Index i, Index d, const T& t) {
  T sum(0);
  // 0 / 0 counts as 0
  if (u[i] < u[i + d]) sum += (t - u[i]) / (u[i + d] - u[i]) * w[i];
  if (u[i + 1] < u[i + d + 1]) sum += (u[i + d + 1] - t) / (u[i + d + 1] - u[i + 1]) * w[i + 1];
  return sum;
}

/// The same point as a mean of the control points: their weights are the B-splines of Cox and de Boor, from
/// those of degree 0, each 1 on a span of its own, one degree after the other. None is negative, they add up
/// to 1, and at most degree + 1 of them are not 0: so moving a control point moves degree + 1 pieces.
/// Source: M. G. Cox, The numerical evaluation of B-splines, 1972; C. de Boor, 1972.
///
/// spline, t: as for de_boor.
///
/// Domain: as de_boor.
/// Steps: Spread for each degree, Weighed for each control point that counts, Reached.
/// Accuracy: each coordinate within (6 n + 1) u M of the exact one and n + 1 of the smallest subnormal ones.
/// Cost: n (n + 3) quotients and products for the weights, one product per control point and coordinate.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Spread<T>, Weighed<N, T>, Reached<N, T>> O = Unobserved>
Point<N, T> basis(const Spline<N, T>& spline, const T& t, O&& observer = {}) {
  expect_point_of(spline, t);
  const auto u = spline.knots;
  const Index n = spline.degree();
  Index k = span_of(spline, t);
  std::vector<T> w(u.size());
  // Degree 0: 1 in its own span
  w[k] = T(1);
  for (Index d = 1; d <= n; ++d) {
    // From those of degree d - 1
    for (Index j = 0; j <= d; ++j) {
      const Index i = k - d + j;
      w[i] = blended(w, u, i, d, t);
    }
    if constexpr (observed<O>) observer(Spread<T>{d, k - d, {&w[k - d], &w[k] + 1}});
  }
  Point<N, T> p(T(0));
  for (Index j = 0; j <= n; ++j) {
    // P_i counts as much
    const Index i = k - n + j;
    p += w[i] * spline.control[i];
    if constexpr (observed<O>) observer(Weighed<N, T>{i, spline.control[i], w[i], p});
  }
  if constexpr (observed<O>) observer(Reached<N, T>{p});
  return p;
}

// --- More control points of the same curve -----------------------

/// How often a knot is there.
template <class T>
Index times(const auto& knots, const T& t) {
  return static_cast<Index>(std::ranges::count(knots, t));
}
template <class T>
std::vector<T> copy_of(std::span<const T> all) {
  return {all.begin(), all.end()};
}
template <int N, class T>
Curve<N, T> copy_of(const Spline<N, T>& spline) {
  return {copy_of(spline.control), copy_of(spline.knots)};
}
template <class T>
void append(std::vector<T>& all, std::span<const T> more) {
  all.insert(all.end(), more.begin(), more.end());
}
/// The knots with t behind the first so many of them.
template <class T>
std::vector<T> with(std::span<const T> knots, Index before, const T& t) {
  std::vector<T> all = copy_of(knots.first(before));
  all.push_back(t);
  append(all, knots.subspan(before));
  return all;
}

/// What insert_knot does, unasked.
template <int N, class T, Observer<Placed<N, T>, Inserted<N, T>> O = Unobserved>
Curve<N, T> with_knot(const Spline<N, T>& spline, const T& t, O&& observer = {}) {
  const auto [p, u] = spline;
  const Index n = spline.degree();
  Index k = span_of(spline, t);
  Index i = k - n + 1;
  // Up to P_(k-n) all stay
  auto q = copy_of(p.first(i));
  while (i <= k && u[i] < t) {
    // On the edge before P_i
    auto a = p[i - 1], c = p[i];
    const T lo = u[i];
    const T hi = u[i + n];
    auto d = mix(a, c, lo, t, hi);
    q.push_back(d);
    if constexpr (observed<O>) observer(Placed<N, T>{t, i, a, c, lo, hi, d});
    ++i;
  }
  // And from this edge's begin on
  append(q, p.subspan(i - 1));
  const auto v = with(u, k + 1, t);
  if constexpr (observed<O>) observer(Inserted<N, T>{t, {q, v}});
  return {q, v};
}

/// The same curve with one knot more, t: its control points are those before, but for a few, which give way
/// to points on the edges between them, one more in all. Source: W. Boehm, Inserting new knots into B-spline
/// curves, Computer-Aided Design 12, 1980.
///
/// spline, t: as for de_boor; t becomes a knot.
///
/// Domain: as de_boor; a knot that is there degree + 1 times already is refused.
/// Steps: Placed for each new point, Inserted.
/// Accuracy: each coordinate within 5 u M of the exact one and one of the smallest subnormal numbers; so is
///   each point of the curve.
/// Cost: a quotient for each new point, of which there are `degree` at most; all others are copied.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Placed<N, T>, Inserted<N, T>> O = Unobserved>
Curve<N, T> insert_knot(const Spline<N, T>& spline, const T& t, O&& observer = {}) {
  expect_point_of(spline, t);
  expects(times(spline.knots, t) <= spline.degree(), "the knot is there degree + 1 times already");
  return with_knot(spline, t, observer);
}

/// A piece of the curve from one knot to the next, with the control points of a Bézier curve.
template <int N, class T>
struct Piece {
  T from, to;
  Points<N, T> b;
};

/// The pieces of a spline all of whose knots are there `degree` times.
template <int N, class T>
std::vector<Piece<N, T>> pieces_of(const Spline<N, T>& spline) {
  std::vector<Piece<N, T>> pieces;
  for (Index k = spline.degree(); k < spline.control.size(); ++k) {
    const T from = spline.knots[k], to = spline.knots[k + 1];
    if (from < to) pieces.push_back({from, to, points_of(spline, k)});
  }
  return pieces;
}
/// The knots from where the curve begins to where it ends, each once.
template <int N, class T>
std::vector<T> knots_of(const Spline<N, T>& spline) {
  std::vector<T> all = copy_of(spline.knots.subspan(spline.degree()));
  all.erase(std::ranges::upper_bound(all, spline.end()), all.end());
  all.erase(std::ranges::unique(all).begin(), all.end());
  return all;
}

/// The pieces of a spline as Bézier curves: a knot that is there `degree` times is where one of these ends
/// and the next begins, so knots are inserted until all are. Source: W. Boehm, 1980.
///
/// spline: as for de_boor.
///
/// Domain: as de_boor.
/// Steps: (Placed* Inserted)*, Finished.
/// Accuracy: each point within 5 i u M of the exact curve and i of the smallest subnormal numbers,
///   where i knots were inserted; pieces meet bit for bit where a knot is there up to `degree` times.
/// Cost: as insert_knot, up to `degree` times for each knot.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Placed<N, T>, Inserted<N, T>, Finished> O = Unobserved>
std::vector<Piece<N, T>> bezier_pieces(const Spline<N, T>& spline, O&& observer = {}) {
  expect_spline(spline);
  const Index n = spline.degree();
  auto c = copy_of(spline);
  const auto u = knots_of(spline);
  for (const T& t : u) {
    // Each knot n times
    Index s = times(c.knots, t);
    for (; s < n; ++s) {
      c = with_knot(c.spline(), t, observer);
    }
  }
  auto b = pieces_of(c.spline());
  if constexpr (observed<O>) observer(Finished{b.size()});
  return b;
}

// --- Weights of the points' own ----------------------------------

/// Up to here, and from one part of it on, points may have weights.
inline constexpr int most_weight = 1024;

template <int N, class T>
void expect_weights(const Spline<N, T>& spline, std::span<const T> weights) {
  expects(weights.size() == spline.control.size(), "{} control points take as many weights, not {}",
          spline.control.size(), weights.size());
  for (Index i = 0; i < weights.size(); ++i)
    expects(T(1) / T(most_weight) <= weights[i] && weights[i] <= T(most_weight),
            "weight {} is not from 1/{} to {}", i, most_weight, most_weight);
  if constexpr (std::floating_point<T>) {
    for (const Point<N, T>& p : spline.control) {
      for (int axis = 0; axis < N; ++axis)
        expects(std::abs(p[axis]) <= std::numeric_limits<T>::max() / (4 * most_weight),
                "a coordinate is too large for weights: {}", p[axis]);
    }
  }
}

/// The points times their weights, with these as last coordinate.
template <int N, class T>
Points<N + 1, T> weighted(std::span<const Point<N, T>> control, std::span<const T> weights) {
  Points<N + 1, T> all;
  for (Index i = 0; i < control.size(); ++i) all.emplace_back(weights[i] * control[i], weights[i]);
  return all;
}

/// The point at t of a rational spline, a NURBS curve: the larger its weight, the more a control point draws
/// the curve towards it. In coordinates of one dimension more it is a spline like any other, and its points
/// there are divided by their last coordinate. So circles are drawn exactly, which no polynomials can.
/// Source: K. J. Versprille, Computer-aided design applications of the rational B-spline approximation form,
/// 1975; L. Piegl, W. Tiller, The NURBS Book, 1997, 4.2 and 7.
///
/// spline, t: as for de_boor. weights: one for each control point.
///
/// Domain: as de_boor, coordinates up to 1/4096 of the largest number; weights from 1/1024 to 1024.
/// Steps: Mixed for each weighted point of each round, Reached, Divided.
/// Accuracy: each coordinate within (10 n + 4) u M w of the exact one and 1024 (n + 1) of the
///   smallest subnormal numbers; w is the largest weight over the smallest.
/// Cost: as de_boor with a coordinate more, one product and one quotient per coordinate.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Mixed<N + 1, T>, Reached<N + 1, T>, Divided<N, T>> O = Unobserved>
Point<N, T> nurbs(const Spline<N, T>& spline, std::span<const T> weights, const T& t, O&& observer = {}) {
  expect_point_of(spline, t);
  expect_weights(spline, weights);
  const auto [p, u] = spline;
  // (x, y) becomes (wx, wy, w)
  auto h = weighted(p, weights);
  Spline<N + 1, T> s{h, u};
  auto q = de_boor(s, t, observer);
  // And back
  auto d = Point<N, T>(q) / q[N];
  if constexpr (observed<O>) observer(Divided<N, T>{q, d});
  return d;
}

}  // namespace gradus::b_spline
