#pragma once
// A curve's point where digits cancel: de Casteljau's rounds, and beside each point what its roundings took.

#include "core/arithmetic/exact.hpp"
#include "modeling/bezier_curve/bezier_curve.hpp"

namespace gradus::bezier_curve {

/// Products of larger coordinates could not be halved without loss.
inline constexpr double largest_compensated = 0x1p900;

/// A point was found between two neighbours, and what it misses by the roundings up to it.
template <int N>
struct Kept {
  Mixed<N, double> mixed;
  Point<N, double> lost;
};

/// A point, and what it misses.
template <int N>
struct Rest {
  Point<N, double> point, lost;
};

/// The shares of an edge's ends in a point of it, 1 - t with what its rounding took.
struct Shares {
  double t;
  Rounded s = two_sum(1, -t);

  template <int N>
  Point<N, double> mean(const Point<N, double>& a, const Point<N, double>& c) const {
    return s.value * a + t * c;
  }
  /// The same, and what its three roundings and that of 1 - t took.
  template <int N>
  Rest<N> mixed(const Point<N, double>& a, const Point<N, double>& c) const {
    Rest<N> found;
    for (int axis = 0; axis < N; ++axis) {
      const Rounded of_a = two_product(s.value, a[axis]), of_c = two_product(t, c[axis]);
      const Rounded sum = two_sum(of_a.value, of_c.value);
      found.point[axis] = sum.value;
      found.lost[axis] = of_a.error + of_c.error + sum.error + s.error * a[axis];
    }
    return found;
  }
};

template <int N>
Points<N, double> checked(Polygon<N, double> control, double t) {
  expect_point_of<N, double>(control, t);
  expects(largest_of(control) <= largest_compensated, "a coordinate is above {}", largest_compensated);
  return copy_of<N, double>(control);
}
/// Of as many points.
template <int N>
Points<N, double> nothing_lost(const Points<N, double>& points) {
  return Points<N, double>(points.size(), Point<N, double>(0));
}

/// The point of a curve at t, nearly as if it were rounded once: what each rounding takes is known
/// exactly and goes through the same rounds.
/// Source: H. Jiang, S. Li, L. Cheng, F. Su, Accurate evaluation of a polynomial and its derivative
/// in Bernstein form, 2010; S. Graillat, P. Langlois, N. Louvet, Compensated Horner scheme, 2005.
///
/// control, t: as for de_casteljau, in double.
///
/// Domain: as de_casteljau, with coordinates up to 2^900.
/// Steps: Kept for each point of each round, Reached.
/// Accuracy: each coordinate p within u |p| + 20 n² u² M of the exact one, and n² times what two_product may
///   lose of small numbers: rounded as if once where not more than 40 of its bits cancel. The ends are exact.
/// Cost: 18 operations per point of each round and coordinate where products can be fused with sums, else 48;
///   de Casteljau takes three.
/// Errors: ContractViolation outside the domain.
template <int N, Observer<Kept<N>, Reached<N, double>> O = Unobserved>
Point<N, double> compensated(Polygon<N, double> control, double t, O&& observer = {}) {
  auto b = checked(control, t);
  auto e = nothing_lost(b);
  const Index n = b.size() - 1;
  const Shares x{t};
  for (Index m = n; m > 0; --m) {
    for (Index i = 0; i < m; ++i) {
      auto a = b[i], c = b[i + 1];
      auto [p, r] = x.mixed(a, c);
      b[i] = p;
      // What was lost before, too
      auto d = e[i], f = e[i + 1];
      e[i] = x.mean(d, f) + r;
      if constexpr (observed<O>) observer(Kept<N>{{n - m + 1, i, a, c, p}, e[i]});
    }
  }
  auto point = b[0] + e[0];
  if constexpr (observed<O>) observer(Reached<N, double>{point});
  return point;
}

}  // namespace gradus::bezier_curve
