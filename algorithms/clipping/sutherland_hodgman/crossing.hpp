#pragma once
// Lines and the points where they cross: which side a crossing lies on, which of two comes first, and the
// nearest point that numbers can name. Nothing is rounded before it is compared.

#include <array>
#include <cmath>
#include <concepts>
#include <glm/vec2.hpp>
#include <optional>
#include <tuple>

#include "core/contract.hpp"
#include "core/exact.hpp"

namespace gradus::sutherland_hodgman {

/// A line through two different points, from p to q; its left side is the inside.
template <class T>
struct Line {
  glm::vec<2, T> p, q;
};

template <class T>
constexpr int sign_of(T x) {
  return x > T(0) ? 1 : x < T(0) ? -1 : 0;
}

/// The side of the line on which a point lies: 1 left, 0 on it, -1 right. Exact.
/// Domain: finite coordinates. Cost: about 3 ns, in doubt 0.2 us.
template <class T>
int side(const Line<T>& line, glm::vec<2, T> point) {
  if constexpr (std::floating_point<T>) {
    return orient2d(line.p, line.q, point);
  } else {
    const auto way = line.q - line.p, to = point - line.p;
    return sign_of(way.x * to.y - way.y * to.x);
  }
}

namespace detail {

/// A number, and how far from the exact one it may lie.
struct Estimate {
  double value, error;
};

/// det(q - p, s - r), within 4u of its two products (see orient2d_filtered).
inline Estimate turn_estimate(glm::dvec2 p, glm::dvec2 q, glm::dvec2 r, glm::dvec2 s) {
  const glm::dvec2 a = q - p, b = s - r;
  const double left = a.x * b.y, right = a.y * b.x;
  return {left - right, 0x1p-51 * (std::abs(left) + std::abs(right)) + 0x1p-1000};
}

/// The six products of orient2d(line, point).
struct Term {
  double factor, other;
};
inline std::array<Term, 6> orientation_terms(const Line<double>& l, glm::dvec2 c) {
  return {{{l.q.x, c.y}, {-l.q.x, l.p.y}, {-l.p.x, c.y}, {-l.q.y, c.x}, {l.q.y, l.p.x}, {l.p.y, c.x}}};
}

/// The sign of det(q - p, s - r) and of f(q) g(p) - f(p) g(q) by exact arithmetic alone; see below.
inline int turn_exact(const Line<double>& a, const Line<double>& b) {
  SumOfProducts<2> sum;
  for (const auto& [x, y, plus] :
       {std::tuple(a.q.x, b.q.y, true), std::tuple(a.q.x, b.p.y, false), std::tuple(a.p.x, b.q.y, false),
        std::tuple(a.p.x, b.p.y, true), std::tuple(a.q.y, b.q.x, false), std::tuple(a.q.y, b.p.x, true),
        std::tuple(a.p.y, b.q.x, true), std::tuple(a.p.y, b.p.x, false)}) {
    plus ? sum.add(x, y) : sum.subtract(x, y);
  }
  return sum.sign();
}

inline int mixed_sides_exact(const Line<double>& f, const Line<double>& g, const Line<double>& on) {
  SumOfProducts<4> sum;
  const auto f_p = orientation_terms(f, on.p), f_q = orientation_terms(f, on.q);
  const auto g_p = orientation_terms(g, on.p), g_q = orientation_terms(g, on.q);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      sum.add(f_q[i].factor, f_q[i].other, g_p[j].factor, g_p[j].other);
      sum.subtract(f_p[i].factor, f_p[i].other, g_q[j].factor, g_q[j].other);
    }
  }
  return sum.sign();
}

}  // namespace detail

/// Which way b heads, seen along a: 1 to the left, -1 to the right, 0 both are parallel. Exact.
/// Domain: finite coordinates. Cost: about 3 ns, in doubt 0.3 us.
template <class T>
int heading(const Line<T>& a, const Line<T>& b) {
  if constexpr (std::floating_point<T>) {
    const Line<double> u{glm::dvec2(a.p), glm::dvec2(a.q)}, v{glm::dvec2(b.p), glm::dvec2(b.q)};
    const auto turn = detail::turn_estimate(u.p, u.q, v.p, v.q);
    if (turn.value > turn.error) return 1;
    if (turn.value < -turn.error) return -1;
    return detail::turn_exact(u, v);
  } else {
    const auto u = a.q - a.p, v = b.q - b.p;
    return sign_of(u.x * v.y - u.y * v.x);
  }
}

/// The side of a line on which the crossing of two others lies: 1 left, 0 on it, -1 right. Exact.
///
/// Along `on` a point is p + t (q - p), and its side of any line goes evenly from that of p to that of q: so
/// the crossing with `a` has t = a(p) / (a(p) - a(q)), and line(p) + t (line(q) - line(p)) is the answer.
///
/// Domain: finite coordinates of any size; `a` and `on` not parallel. Cost: about 10 ns, in doubt 4 us.
template <class T>
int side_of_crossing(const Line<T>& line, const Line<T>& a, const Line<T>& on) {
  int mixed = 0;
  if constexpr (std::floating_point<T>) {
    const Line<double> f{glm::dvec2(line.p), glm::dvec2(line.q)}, g{glm::dvec2(a.p), glm::dvec2(a.q)};
    const Line<double> l{glm::dvec2(on.p), glm::dvec2(on.q)};
    const auto of = [](const Line<double>& by, glm::dvec2 c) {
      return detail::turn_estimate(by.p, by.q, by.p, c);
    };
    const auto fp = of(f, l.p), fq = of(f, l.q), gp = of(g, l.p), gq = of(g, l.q);
    const double value = fq.value * gp.value - fp.value * gq.value;
    const auto size = [](detail::Estimate x, detail::Estimate y) {
      return std::abs(x.value) * y.error + x.error * (std::abs(y.value) + y.error) +
             0x1p-51 * std::abs(x.value * y.value);
    };
    const double error = 1.0001 * (size(fq, gp) + size(fp, gq)) + 0x1p-1000;
    mixed = value > error ? 1 : value < -error ? -1 : detail::mixed_sides_exact(f, g, l);
  } else {
    const auto of = [](const Line<T>& by, glm::vec<2, T> c) {
      const auto way = by.q - by.p, to = c - by.p;
      return way.x * to.y - way.y * to.x;
    };
    mixed = sign_of(of(line, on.q) * of(a, on.p) - of(line, on.p) * of(a, on.q));
  }
  return -mixed * heading(a, on);
}

namespace detail {

/// A number as the sum of two doubles, the second one below the last place of the first.
struct Twofold {
  double high, low;
};
inline Twofold twofold(Rounded x) { return {x.value, x.error}; }
inline Twofold product(Twofold a, Twofold b) {
  const Rounded p = two_product(a.high, b.high);
  return twofold(fast_two_sum(p.value, p.error + (a.high * b.low + a.low * b.high)));
}
inline Twofold difference(Twofold a, Twofold b) {
  const Rounded d = two_difference(a.high, b.high), e = two_difference(a.low, b.low);
  const Rounded sum = fast_two_sum(d.value, d.error + e.value);
  return twofold(fast_two_sum(sum.value, sum.error + e.error));
}

/// One coordinate of the crossing where arithmetic in twofold precision is sure of its nearest double.
/// start + share * way / whole with relative errors below 2^-95 of the terms that make it up.
struct Quotient {
  Twofold share, whole;
  double error;  ///< relative, of share / whole
};
inline std::optional<double> nearest_if_sure(double start, Twofold way, const Quotient& t) {
  const Twofold part = product(t.share, way);
  const double quotient = part.high / t.whole.high;
  const Twofold back = product({quotient, 0}, t.whole);
  const double rest = ((part.high - back.high) + (part.low - back.low)) / t.whole.high;
  const Rounded sum = two_sum(start, quotient);
  const double low = sum.error + rest;
  const double bound = std::abs(quotient) * (t.error + 0x1p-90) + 0x1p-95 * std::abs(sum.value) + 0x1p-1050;
  const double highest = sum.value + (low + bound);
  if (!(highest == sum.value + (low - bound))) return std::nullopt;
  return highest + 0.0;
}

inline std::optional<Quotient> share_of_way(const Line<double>& a, const Line<double>& b) {
  const auto minus = [](double x, double y) { return twofold(two_difference(x, y)); };
  const Twofold ax = minus(a.q.x, a.p.x), ay = minus(a.q.y, a.p.y);
  const Twofold bx = minus(b.q.x, b.p.x), by = minus(b.q.y, b.p.y);
  const Twofold cx = minus(b.p.x, a.p.x), cy = minus(b.p.y, a.p.y);
  const auto fits = [](Twofold x) {
    return x.high == 0 || (0x1p-150 <= std::abs(x.high) && std::abs(x.high) <= 0x1p150);
  };
  if (!(fits(ax) && fits(ay) && fits(bx) && fits(by) && fits(cx) && fits(cy))) return std::nullopt;
  // det(a, c) / -det(a, b): how far along b the line a is met
  const Twofold s1 = product(ax, cy), s2 = product(ay, cx), w1 = product(ay, bx), w2 = product(ax, by);
  const Twofold share = difference(s1, s2), whole = difference(w1, w2);
  if (whole.high == 0 || share.high == 0) return std::nullopt;
  const double share_error = 0x1p-97 * (std::abs(s1.high) + std::abs(s2.high)) / std::abs(share.high);
  const double whole_error = 0x1p-97 * (std::abs(w1.high) + std::abs(w2.high)) / std::abs(whole.high);
  return Quotient{share, whole, share_error + whole_error};
}

/// One coordinate by exact arithmetic alone; `axis` 0 gives x, 1 y.
inline SumOfProducts<3> crossing_numerator(const Line<double>& a, const Line<double>& b, int axis) {
  // (a.p x a.q) (b.p - b.q) - (a.p - a.q) (b.p x b.q)
  SumOfProducts<3> sum;
  for (const double end : {b.p[axis], -b.q[axis]}) {
    sum.add(a.p.x, a.q.y, end);
    sum.subtract(a.p.y, a.q.x, end);
  }
  for (const double end : {a.p[axis], -a.q[axis]}) {
    sum.subtract(b.p.x, b.q.y, end);
    sum.add(b.p.y, b.q.x, end);
  }
  return sum;
}
inline SumOfProducts<2> crossing_denominator(const Line<double>& a, const Line<double>& b) {
  SumOfProducts<2> sum;
  for (const double x : {a.p.x, -a.q.x}) {
    for (const double y : {b.p.y, -b.q.y}) sum.add(x, y);
  }
  for (const double y : {a.p.y, -a.q.y}) {
    for (const double x : {b.p.x, -b.q.x}) sum.subtract(y, x);
  }
  return sum;
}
inline double crossing_exact(const Line<double>& a, const Line<double>& b, int axis) {
  return rounded_quotient(crossing_numerator(a, b, axis), crossing_denominator(a, b)) + 0.0;
}

/// The float nearest to a crossing's coordinate, whose nearest double is known: where that lies midway
/// between two floats, the exact sum says on which side of it the crossing is.
inline float nearest_float(const Line<double>& a, const Line<double>& b, int axis, double coordinate) {
  const float nearest = static_cast<float>(coordinate);
  const float other = std::nextafter(nearest, coordinate < double{nearest} ? -INFINITY : INFINITY);
  if (double{nearest} == coordinate || coordinate - double{nearest} != double{other} - coordinate) {
    return nearest;
  }
  SumOfProducts<3> beyond = crossing_numerator(a, b, axis);
  for (const double x : {a.p.x, -a.q.x}) {
    for (const double y : {b.p.y, -b.q.y}) beyond.subtract(x, y, coordinate);
  }
  for (const double y : {a.p.y, -a.q.y}) {
    for (const double x : {b.p.x, -b.q.x}) beyond.add(y, x, coordinate);
  }
  const int above = beyond.sign() * crossing_denominator(a, b).sign();
  return above == 0 || (above > 0) != (other > nearest) ? nearest : other;
}

}  // namespace detail

/// Where two lines cross: each coordinate the nearest number to the exact one, ties to even; a zero is +0.
/// Domain: finite coordinates of any size, not parallel (refused). A crossing beyond the range of numbers
///   has infinite coordinates. Accuracy: 1/2 ulp; without rounding for rationals.
/// Cost: about 40 ns, in doubt 3 us.
template <class T>
glm::vec<2, T> crossing_point(const Line<T>& a, const Line<T>& b) {
  if constexpr (std::floating_point<T>) {
    const Line<double> u{glm::dvec2(a.p), glm::dvec2(a.q)}, v{glm::dvec2(b.p), glm::dvec2(b.q)};
    const auto t = detail::share_of_way(u, v);
    glm::vec<2, T> at{};
    for (int axis = 0; axis < 2; ++axis) {
      std::optional<double> sure;
      if (t) {
        const auto way = detail::twofold(two_difference(v.q[axis], v.p[axis]));
        sure = detail::nearest_if_sure(v.p[axis], way, *t);
      }
      const double exact = sure ? *sure : detail::crossing_exact(u, v, axis);
      if constexpr (std::same_as<T, float>) {
        at[axis] = detail::nearest_float(u, v, axis, exact);
      } else {
        at[axis] = exact;
      }
    }
    return at;
  } else {
    const auto u = a.q - a.p, v = b.q - b.p, c = b.p - a.p;
    const T whole = u.y * v.x - u.x * v.y;
    const T share = u.x * c.y - u.y * c.x;
    return b.p + share / whole * v;
  }
}

}  // namespace gradus::sutherland_hodgman
