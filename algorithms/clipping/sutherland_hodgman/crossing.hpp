#pragma once
// Lines and the points where they cross: which side a crossing lies on, which of two comes first, and the
// nearest point that numbers can name. Nothing is rounded before it is compared.

#include <array>
#include <cmath>
#include <concepts>
#include <glm/vec2.hpp>
#include <optional>
#include <tuple>

#include "core/arithmetic/exact.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"

namespace gradus::sutherland_hodgman {

// A line is a segment of it: it runs from a to b, two different points, and its left side is the inside.

template <class T>
constexpr int sign_of(T x) {
  return x > T(0) ? 1 : x < T(0) ? -1 : 0;
}

/// The side of the line on which a point lies: 1 left, 0 on it, -1 right. Exact.
/// Domain: finite coordinates. Cost: about 3 ns, in doubt 0.2 us.
template <class T>
int side(const Segment<2, T>& line, glm::vec<2, T> point) {
  if constexpr (std::floating_point<T>) {
    return orient2d(line.a, line.b, point);
  } else {
    const auto way = line.b - line.a, to = point - line.a;
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
inline std::array<Term, 6> orientation_terms(const Segment<2, double>& l, glm::dvec2 c) {
  return {{{l.b.x, c.y}, {-l.b.x, l.a.y}, {-l.a.x, c.y}, {-l.b.y, c.x}, {l.b.y, l.a.x}, {l.a.y, c.x}}};
}

/// The sign of det(q - p, s - r) and of f(q) g(p) - f(p) g(q) by exact arithmetic alone; see below.
inline int turn_exact(const Segment<2, double>& l, const Segment<2, double>& m) {
  SumOfProducts<2> sum;
  for (const auto& [x, y, plus] :
       {std::tuple(l.b.x, m.b.y, true), std::tuple(l.b.x, m.a.y, false), std::tuple(l.a.x, m.b.y, false),
        std::tuple(l.a.x, m.a.y, true), std::tuple(l.b.y, m.b.x, false), std::tuple(l.b.y, m.a.x, true),
        std::tuple(l.a.y, m.b.x, true), std::tuple(l.a.y, m.a.x, false)}) {
    plus ? sum.add(x, y) : sum.subtract(x, y);
  }
  return sum.sign();
}

inline int mixed_sides_exact(const Segment<2, double>& f, const Segment<2, double>& g,
                             const Segment<2, double>& on) {
  SumOfProducts<4> sum;
  const auto f_p = orientation_terms(f, on.a), f_q = orientation_terms(f, on.b);
  const auto g_p = orientation_terms(g, on.a), g_q = orientation_terms(g, on.b);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      sum.add(f_q[i].factor, f_q[i].other, g_p[j].factor, g_p[j].other);
      sum.subtract(f_p[i].factor, f_p[i].other, g_q[j].factor, g_q[j].other);
    }
  }
  return sum.sign();
}

}  // namespace detail

/// Which way m heads, seen along l: 1 to the left, -1 to the right, 0 both are parallel. Exact.
/// Domain: finite coordinates. Cost: about 3 ns, in doubt 0.3 us.
template <class T>
int heading(const Segment<2, T>& l, const Segment<2, T>& m) {
  if constexpr (std::floating_point<T>) {
    const Segment<2, double> u{glm::dvec2(l.a), glm::dvec2(l.b)}, v{glm::dvec2(m.a), glm::dvec2(m.b)};
    const auto turn = detail::turn_estimate(u.a, u.b, v.a, v.b);
    if (turn.value > turn.error) return 1;
    if (turn.value < -turn.error) return -1;
    return detail::turn_exact(u, v);
  } else {
    const auto u = l.b - l.a, v = m.b - m.a;
    return sign_of(u.x * v.y - u.y * v.x);
  }
}

/// The side of a line on which the crossing of two others lies: 1 left, 0 on it, -1 right. Exact.
///
/// Along `on` a point is a + t (b - a), and its side of any line goes evenly from that of a to that of b: so
/// the crossing with `other` has t = o(a) / (o(a) - o(b)), and line(a) + t (line(b) - line(a)) is the answer.
///
/// Domain: finite coordinates of any size; `other` and `on` not parallel. Cost: about 10 ns, in doubt 4 us.
template <class T>
int side_of_crossing(const Segment<2, T>& line, const Segment<2, T>& other, const Segment<2, T>& on) {
  int mixed = 0;
  if constexpr (std::floating_point<T>) {
    const Segment<2, double> f{glm::dvec2(line.a), glm::dvec2(line.b)},
        g{glm::dvec2(other.a), glm::dvec2(other.b)};
    const Segment<2, double> l{glm::dvec2(on.a), glm::dvec2(on.b)};
    const auto of = [](const Segment<2, double>& by, glm::dvec2 c) {
      return detail::turn_estimate(by.a, by.b, by.a, c);
    };
    const auto fp = of(f, l.a), fq = of(f, l.b), gp = of(g, l.a), gq = of(g, l.b);
    const double value = fq.value * gp.value - fp.value * gq.value;
    const auto size = [](detail::Estimate x, detail::Estimate y) {
      return std::abs(x.value) * y.error + x.error * (std::abs(y.value) + y.error) +
             0x1p-51 * std::abs(x.value * y.value);
    };
    const double error = 1.0001 * (size(fq, gp) + size(fp, gq)) + 0x1p-1000;
    mixed = value > error ? 1 : value < -error ? -1 : detail::mixed_sides_exact(f, g, l);
  } else {
    const auto of = [](const Segment<2, T>& by, glm::vec<2, T> c) {
      const auto way = by.b - by.a, to = c - by.a;
      return way.x * to.y - way.y * to.x;
    };
    mixed = sign_of(of(line, on.b) * of(other, on.a) - of(line, on.a) * of(other, on.b));
  }
  return -mixed * heading(other, on);
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

inline std::optional<Quotient> share_of_way(const Segment<2, double>& l, const Segment<2, double>& m) {
  const auto minus = [](double x, double y) { return twofold(two_difference(x, y)); };
  const Twofold ax = minus(l.b.x, l.a.x), ay = minus(l.b.y, l.a.y);
  const Twofold bx = minus(m.b.x, m.a.x), by = minus(m.b.y, m.a.y);
  const Twofold cx = minus(m.a.x, l.a.x), cy = minus(m.a.y, l.a.y);
  const auto fits = [](Twofold x) {
    return x.high == 0 || (0x1p-150 <= std::abs(x.high) && std::abs(x.high) <= 0x1p150);
  };
  if (!(fits(ax) && fits(ay) && fits(bx) && fits(by) && fits(cx) && fits(cy))) return std::nullopt;
  // det(a, c) / -det(a, b): how far along m the line l is met
  const Twofold s1 = product(ax, cy), s2 = product(ay, cx), w1 = product(ay, bx), w2 = product(ax, by);
  const Twofold share = difference(s1, s2), whole = difference(w1, w2);
  if (whole.high == 0 || share.high == 0) return std::nullopt;
  const double share_error = 0x1p-97 * (std::abs(s1.high) + std::abs(s2.high)) / std::abs(share.high);
  const double whole_error = 0x1p-97 * (std::abs(w1.high) + std::abs(w2.high)) / std::abs(whole.high);
  return Quotient{share, whole, share_error + whole_error};
}

/// One coordinate by exact arithmetic alone; `axis` 0 gives x, 1 y.
inline SumOfProducts<3> crossing_numerator(const Segment<2, double>& l, const Segment<2, double>& m,
                                           int axis) {
  // (l.a x l.b) (m.a - m.b) - (l.a - l.b) (m.a x m.b)
  SumOfProducts<3> sum;
  for (const double end : {m.a[axis], -m.b[axis]}) {
    sum.add(l.a.x, l.b.y, end);
    sum.subtract(l.a.y, l.b.x, end);
  }
  for (const double end : {l.a[axis], -l.b[axis]}) {
    sum.subtract(m.a.x, m.b.y, end);
    sum.add(m.a.y, m.b.x, end);
  }
  return sum;
}
inline SumOfProducts<2> crossing_denominator(const Segment<2, double>& l, const Segment<2, double>& m) {
  SumOfProducts<2> sum;
  for (const double x : {l.a.x, -l.b.x}) {
    for (const double y : {m.a.y, -m.b.y}) sum.add(x, y);
  }
  for (const double y : {l.a.y, -l.b.y}) {
    for (const double x : {m.a.x, -m.b.x}) sum.subtract(y, x);
  }
  return sum;
}
inline double crossing_exact(const Segment<2, double>& l, const Segment<2, double>& m, int axis) {
  return rounded_quotient(crossing_numerator(l, m, axis), crossing_denominator(l, m)) + 0.0;
}

/// The float nearest to a crossing's coordinate, whose nearest double is known: where that lies midway
/// between two floats, the exact sum says on which side of it the crossing is.
inline float nearest_float(const Segment<2, double>& l, const Segment<2, double>& m, int axis,
                           double coordinate) {
  const float nearest = static_cast<float>(coordinate);
  const float other = std::nextafter(nearest, coordinate < double{nearest} ? -INFINITY : INFINITY);
  if (double{nearest} == coordinate || coordinate - double{nearest} != double{other} - coordinate) {
    return nearest;
  }
  SumOfProducts<3> beyond = crossing_numerator(l, m, axis);
  for (const double x : {l.a.x, -l.b.x}) {
    for (const double y : {m.a.y, -m.b.y}) beyond.subtract(x, y, coordinate);
  }
  for (const double y : {l.a.y, -l.b.y}) {
    for (const double x : {m.a.x, -m.b.x}) beyond.add(y, x, coordinate);
  }
  const int above = beyond.sign() * crossing_denominator(l, m).sign();
  return above == 0 || (above > 0) != (other > nearest) ? nearest : other;
}

}  // namespace detail

/// Where two lines cross: each coordinate the nearest number to the exact one, ties to even; a zero is +0.
/// Domain: finite coordinates of any size, not parallel (refused). A crossing beyond the range of numbers
///   has infinite coordinates. Accuracy: 1/2 ulp; without rounding for rationals.
/// Cost: about 40 ns, in doubt 3 us.
template <class T>
glm::vec<2, T> crossing_point(const Segment<2, T>& l, const Segment<2, T>& m) {
  if constexpr (std::floating_point<T>) {
    const Segment<2, double> u{glm::dvec2(l.a), glm::dvec2(l.b)}, v{glm::dvec2(m.a), glm::dvec2(m.b)};
    const auto t = detail::share_of_way(u, v);
    glm::vec<2, T> at{};
    for (int axis = 0; axis < 2; ++axis) {
      std::optional<double> sure;
      if (t) {
        const auto way = detail::twofold(two_difference(v.b[axis], v.a[axis]));
        sure = detail::nearest_if_sure(v.a[axis], way, *t);
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
    const auto u = l.b - l.a, v = m.b - m.a, c = m.a - l.a;
    const T whole = u.y * v.x - u.x * v.y;
    const T share = u.x * c.y - u.y * c.x;
    return m.a + share / whole * v;
  }
}

}  // namespace gradus::sutherland_hodgman
