#pragma once
// A circle and the line through two points, exactly: on which side points lie, whether the line reaches the
// circle, and where it enters and leaves, rounded once. Both topics of circles build on it.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "core/arithmetic/exact.hpp"
#include "core/arithmetic/exact_polynomial.hpp"
#include "core/arithmetic/two_doubles.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"

namespace gradus::liang_barsky_circle {

/// The same in double, which holds every float.
template <std::floating_point T>
constexpr Circle<double> in_double(const Circle<T>& circle) {
  return {dvec2(circle.centre), double{circle.radius}};
}
template <std::floating_point T>
constexpr Segment<2, double> in_double(const Segment<2, T>& segment) {
  return {dvec2(segment.a), dvec2(segment.b)};
}

/// Refuses what is no circle, by name.
template <std::floating_point T>
void expect_circle(const Circle<T>& circle) {
  expects(std::isfinite(circle.centre.x) && std::isfinite(circle.centre.y),
          "the circle's centre is finite, not ({}, {})", circle.centre.x, circle.centre.y);
  expects(circle.radius >= 0 && std::isfinite(circle.radius),
          "the circle's radius is finite and not negative, not {}", circle.radius);
}

/// Refuses ends that are not finite.
template <std::floating_point T>
void expect_finite(glm::vec<2, T> p) {
  expects(std::isfinite(p.x) && std::isfinite(p.y), "points are finite, not ({}, {})", p.x, p.y);
}

// --- The numbers of the quadratic -----------------------------------------------------------------------

/// |from + t d - centre|^2 = r^2 as A t^2 + 2 B t + C = 0, where d = to - from and f = from - centre. The
/// discriminant B^2 - A C is also r^2 A - k^2 with k = d x f, and that form cancels least.
template <class T>
struct Quadratic {
  glm::vec<2, T> d, f;
  T A;  ///< d.d, the squared length
  T B;  ///< f.d; the foot of the perpendicular lies at t = -B/A
  T C;  ///< f.f - r^2: the side of `from`, negative inside
  T k;  ///< d x f; the line passes the centre at the distance |k| / sqrt(A)
  T D;  ///< r^2 A - k^2: negative where the line misses the circle, 0 where it touches it
};

/// T: float, double or gradus::Exact. Accuracy: that of T; A, B, C, k and D are rational, so exact in Exact.
template <class T>
constexpr Quadratic<T> quadratic(const Segment<2, T>& segment, const Circle<T>& circle) {
  const glm::vec<2, T> d = segment.b - segment.a, f = segment.a - circle.centre;
  const T r = circle.radius;
  const T A = d.x * d.x + d.y * d.y, B = f.x * d.x + f.y * d.y, k = d.x * f.y - d.y * f.x;
  return {d, f, A, B, f.x * f.x + f.y * f.y - r * r, k, r * r * A - k * k};
}

// --- Exact signs ------------------------------------------------------------------------------------------

// Of every sign below plain doubles decide what they are sure of: u = 2^-53 being the relative error of an
// operation, the bounds are twice what a count of operations gives. A product that underflows loses less than
// 2^-1074 more, times what it is multiplied with: 2^-960 and 2^-1000 below cover that. What overflows
// makes the bound infinite or no number, so nothing is sure

/// The side of the circle on which a point lies: -1 inside, 0 on it, +1 outside.
/// Domain: all finite doubles, radius >= 0. Accuracy: exact. Cost: about 3 ns, in doubt about 0.3 us.
inline int side(dvec2 p, const Circle<double>& circle) {
  const dvec2 f = p - circle.centre;
  const double square = f.x * f.x + f.y * f.y, r2 = circle.radius * circle.radius;
  const double bound = 0x1p-50 * (square + r2) + 0x1p-960;
  if (square - r2 > bound) return 1;
  if (r2 - square > bound) return -1;
  const Form<1> x = form_difference(p.x, circle.centre.x), y = form_difference(p.y, circle.centre.y);
  const Form<1> r(circle.radius);
  return (x * x + y * y - r * r).sign();
}

/// The sign of (p - centre) . (to - from): whether p lies before (-1) or past (+1) the foot of the
/// perpendicular, seen along from -> to.
/// Domain: all finite doubles. Accuracy: exact. Cost: about 3 ns, in doubt about 0.3 us.
inline int past_foot(dvec2 p, const Segment<2, double>& s, dvec2 centre) {
  const dvec2 f = p - centre, d = s.b - s.a;
  const double x = f.x * d.x, y = f.y * d.y;
  const double bound = 0x1p-50 * (std::abs(x) + std::abs(y)) + 0x1p-960;
  if (x + y > bound) return 1;
  if (-(x + y) > bound) return -1;
  return (form_difference(p.x, centre.x) * form_difference(s.b.x, s.a.x) +
          form_difference(p.y, centre.y) * form_difference(s.b.y, s.a.y))
      .sign();
}

/// The exact numbers of the quadratic, as far as points and signs need them.
struct ExactLine {
  Form<1> dx, dy;
  Form<2> A, k;
  Form<4> D;

  ExactLine(const Segment<2, double>& s, const Circle<double>& circle)
      : dx(form_difference(s.b.x, s.a.x)),
        dy(form_difference(s.b.y, s.a.y)),
        A(dx * dx + dy * dy),
        k(dx * form_difference(s.a.y, circle.centre.y) - dy * form_difference(s.a.x, circle.centre.x)) {
    const Form<1> r(circle.radius);
    D = r * r * A - k * k;
  }
};

/// The sign of D = r^2 A - k^2: -1 where the line misses the circle, 0 where it touches it, +1 where it
/// crosses it. Domain: all finite doubles, radius >= 0; 0 for two equal points. Accuracy: exact.
/// Cost: about 5 ns, in doubt about 1 us.
inline int reach(const Segment<2, double>& s, const Circle<double>& circle) {
  const Quadratic<double> q = quadratic(s, circle);
  const double terms = std::abs(q.d.x * q.f.y) + std::abs(q.d.y * q.f.x);
  const double r2 = circle.radius * circle.radius, r2A = r2 * q.A, k2 = q.k * q.k;
  const double k_error = 0x1p-50 * terms + 0x1p-500;
  // r^2 may have underflowed before A made it large, and A before r^2 did
  const double underflow = 0x1p-1000 * (r2 + q.A);
  const double bound = 0x1p-49 * (r2A + k2) + k_error * (2 * std::abs(q.k) + k_error) + underflow;
  if (q.D > bound) return 1;
  if (-q.D > bound) return -1;
  return ExactLine(s, circle).D.sign();
}

// --- Where the line meets the circle ----------------------------------------------------------------------

/// A number in 106 bits with an exponent of its own: digits * 2^exponent.
struct Digits {
  Rounded digits;
  int exponent = 0;
};

/// The numbers of the line in 106 bits.
struct RoundedLine {
  Digits dx, dy, A, k, D;
};

/// The line's numbers by arithmetic with 106 bits, or nothing where that may lose more than 2^-57 r of the
/// crossings' places: near tangents, far ends, numbers beyond 2^150 or too small.
/// Source of the bound: k errs by less than 2^-98 of its terms' sizes, hence D by `D_error`, and sqrt(D) by
/// less than D_error / sqrt(D); the places feel both divided by |d|.
inline std::optional<RoundedLine> line_by_pairs(const Segment<2, double>& s, const Circle<double>& circle) {
  const double r = circle.radius;
  const double largest = std::max({std::abs(s.a.x), std::abs(s.a.y), std::abs(s.b.x), std::abs(s.b.y),
                                   std::abs(circle.centre.x), std::abs(circle.centre.y), r});
  if (!(largest <= 0x1p150)) return std::nullopt;
  const Rounded dx = two_difference(s.b.x, s.a.x), dy = two_difference(s.b.y, s.a.y);
  const Rounded fx = two_difference(s.a.x, circle.centre.x), fy = two_difference(s.a.y, circle.centre.y);
  const Rounded A = sum_of_pairs(product_of_pairs(dx, dx), product_of_pairs(dy, dy));
  const Rounded left = product_of_pairs(dx, fy), right = product_of_pairs(dy, fx);
  const Rounded k = sum_of_pairs(left, negated(right));
  const Rounded r2A = product_of_pairs(two_product(r, r), A);
  const Rounded D = sum_of_pairs(r2A, negated(product_of_pairs(k, k)));
  // Is that good enough?
  const double k_error = 0x1p-98 * (std::abs(left.value) + std::abs(right.value));
  const double D_error = 0x1p-97 * (r2A.value + k.value * k.value) + 2 * std::abs(k.value) * k_error;
  if (!(r2A.value >= 0x1p-300 && A.value >= 0x1p-300 && D.value > 0)) return std::nullopt;
  const double radius_by_length = std::sqrt(r2A.value);
  if (!(k_error <= 0x1p-59 * radius_by_length)) return std::nullopt;
  if (!(D_error <= 0x1p-59 * radius_by_length * std::sqrt(D.value))) return std::nullopt;
  return RoundedLine{{dx}, {dy}, {A}, {k}, {D}};
}

/// The same from exact arithmetic: right for all finite doubles.
inline RoundedLine line_by_forms(const Segment<2, double>& s, const Circle<double>& circle) {
  const ExactLine exact(s, circle);
  const auto rounded = [](const auto& form) {
    const Leading leading = form.leading();
    return Digits{leading.digits, leading.exponent};
  };
  return {rounded(exact.dx), rounded(exact.dy), rounded(exact.A), rounded(exact.k), rounded(exact.D)};
}

inline Digits product(const Digits& a, const Digits& b) {
  return {product_of_pairs(a.digits, b.digits), a.exponent + b.exponent};
}
inline Digits quotient(const Digits& a, const Digits& b) {
  return {quotient_of_pairs(a.digits, b.digits), a.exponent - b.exponent};
}
inline Digits root(Digits a) {
  if (a.exponent % 2 != 0) a = {{2 * a.digits.value, 2 * a.digits.error}, a.exponent - 1};
  return {root_of_pair(a.digits), a.exponent / 2};
}
inline Rounded scaled(const Digits& a, int by) {
  const int exponent = a.exponent + by;
  if (exponent == 0) return a.digits;
  return {std::scalbn(a.digits.value, exponent), std::scalbn(a.digits.error, exponent)};
}

/// Where the line meets the circle, seen from the centre: the foot of the perpendicular and half the chord,
/// in 106 bits. The line enters at foot - half and leaves at foot + half.
struct Chord {
  Rounded foot_x, foot_y, half_x, half_y;

  /// Seen from the centre.
  Rounded x(bool leaves) const { return sum_of_pairs(foot_x, leaves ? half_x : negated(half_x)); }
  Rounded y(bool leaves) const { return sum_of_pairs(foot_y, leaves ? half_y : negated(half_y)); }
};

/// The chord, 2^by times as large.
/// Domain: two different points, reach >= 0. Accuracy: 2^-56 of the radius.
/// Cost: about 0.1 us, in doubt 1 us.
inline Chord chord_of(const Segment<2, double>& s, const Circle<double>& circle, int by) {
  const std::optional<RoundedLine> pairs = line_by_pairs(s, circle);
  const RoundedLine line = pairs ? *pairs : line_by_forms(s, circle);
  // foot = k (-dy, dx) / A, half = sqrt(D) (dx, dy) / A
  const Digits across = quotient(line.k, line.A), along = quotient(root(line.D), line.A);
  return {negated(scaled(product(across, line.dy), by)), scaled(product(across, line.dx), by),
          scaled(product(along, line.dx), by), scaled(product(along, line.dy), by)};
}

/// x 2^by.
inline double scaled_by(double x, int by) { return by == 0 ? x : std::scalbn(x, by); }

/// The whole number nearest to a pair, as far as a double has it; of two as near either.
inline double nearest_whole(Rounded x) {
  // From here on every double is whole, and the value is the nearest one
  if (std::abs(x.value) >= 0x1p53) return x.value;
  const double whole = std::nearbyint(x.value), rest = (x.value - whole) + x.error;
  return rest > 0.5 ? whole + 1 : rest < -0.5 ? whole - 1 : whole;
}

/// A segment and its line's chord, which is computed in the order of the ends' coordinates, so that it does
/// not depend on the direction. Of the smallest circles it is counted in units of the smallest double, where
/// foot and half would lose digits else, and of the largest it is made smaller, where sums would overflow.
struct PlacedChord {
  Segment<2, double> segment;
  Circle<double> circle;
  Chord chord;
  bool turned;    ///< its direction is that of to -> from
  int magnified;  ///< the chord is 2^magnified times as large
  double radius;  ///< the circle's, as many times as large

  /// The point where the segment enters or leaves the circle; inside the segment's box.
  /// Domain: the segment does so. Accuracy: 0.63 ulp of max(|coordinate|, radius). Turned round, the segment
  /// leaves at the same bits where it entered.
  dvec2 crossing(bool leaves) const {
    const bool second = leaves != turned;
    const double x = placed_at(circle.centre.x, chord.x(second));
    const double y = placed_at(circle.centre.y, chord.y(second));
    const auto& [a, b] = segment;
    return {std::clamp(x, std::min(a.x, b.x), std::max(a.x, b.x)),
            std::clamp(y, std::min(a.y, b.y), std::max(a.y, b.y))};
  }
  /// Where the segment enters, its first end being outside. `to`: the side of the other end; on the circle,
  /// and not past the foot, it is the only point the two share. Domain, accuracy: those of crossing.
  dvec2 entry(int to) const {
    if (to == 0 && past_foot(segment.b, segment, circle.centre) <= 0) return segment.b;
    return crossing(false);
  }
  /// Where it leaves, its second end being outside. `from`: the side of the other end.
  dvec2 exit(int from) const {
    if (from == 0 && past_foot(segment.a, segment, circle.centre) >= 0) return segment.a;
    return crossing(true);
  }

  double placed_at(double centre, Rounded offset) const {
    // So far away the circle's width is nothing
    if (std::abs(centre) > 0x1p60 * circle.radius) return centre;
    const Rounded at = sum_of_pairs({scaled_by(centre, magnified), 0}, offset);
    // What 106 bits can't tell from 0 is 0
    if (std::abs(at.value) <= 0x1p-96 * radius) return 0.0;
    if (magnified == 0) return at.value;
    return std::scalbn(magnified > 0 ? nearest_whole(at) : at.value, -magnified);
  }
};
inline PlacedChord chord_on(const Segment<2, double>& s, const Circle<double>& circle) {
  const bool turned = s.b.x < s.a.x || (s.b.x == s.a.x && s.b.y < s.a.y);
  const int by = circle.radius < 0x1p-900 ? 1074 : circle.radius > 0x1p900 ? -200 : 0;
  return {s,      circle, chord_of(turned ? Segment<2, double>{s.b, s.a} : s, circle, by),
          turned, by,     scaled_by(circle.radius, by)};
}

/// Whether the foot of the perpendicular from the centre lies between the ends and on neither.
/// Domain: all finite doubles. Accuracy: exact.
inline bool foot_between(const Segment<2, double>& s, dvec2 centre) {
  return past_foot(s.a, s, centre) < 0 && past_foot(s.b, s, centre) > 0;
}
inline bool foot_between(const Segment<2, double>& s, const Circle<double>& circle) {
  return foot_between(s, circle.centre);
}

}  // namespace gradus::liang_barsky_circle
