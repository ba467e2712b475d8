#pragma once
// The part of a segment that lies in a circle: where the parameter t of from + t (to - from) enters the disc
// and where it leaves it, as Liang and Barsky do it with a rectangle. Here t solves a quadratic equation.
//
// The circle itself belongs to the disc, so that a segment that only touches it leaves a point.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <glm/vec2.hpp>
#include <optional>

#include "clipping/liang_barsky_circle/circle_and_line.hpp"
#include "core/observe.hpp"

namespace gradus::liang_barsky_circle {

// --- Steps -------------------------------------------------------

/// What is asked.
template <class T>
struct Started {
  Segment<2, T> segment;
  Circle<T> circle;
};

/// The numbers of the quadratic are there.
template <class T>
struct Measured {
  T A;  ///< squared length of the segment
  T k;  ///< d x f: the line passes the centre at |k| / sqrt(A)
  T D;  ///< r^2 A - k^2
};

/// The line's values of t on the circle.
template <class T>
struct Crossed {
  T foot;            ///< t of the foot of the perpendicular from the centre
  T half;            ///< half the chord, in t
  T enters, leaves;  ///< foot - half, foot + half
};

/// What of them lies on the segment, where t runs from 0 to 1.
template <class T>
struct Limited {
  T first, last;  ///< empty when last < first
};

/// The ends were told from the circle, exactly.
struct Placed {
  int from, to;  ///< -1 inside, 0 on the circle, +1 outside
};

/// With both ends outside: whether the line comes near enough, between them.
struct Reached {
  bool between;  ///< the foot of the perpendicular lies between the ends
  int sign;      ///< of D: +1 crosses, 0 touches, -1 misses
};

/// An end that was outside moved to the circle.
template <class T>
struct Cut {
  glm::vec<2, T> from, at;
  bool leaves;  ///< the segment's second end, where it leaves the disc
};

/// All is done.
template <class T>
struct Finished {
  std::optional<Segment<2, T>> kept;
};

// --- The taught method -------------------------------------------

/// The part of a segment from t = first to t = last; ends that are not cut are copied.
template <class T>
constexpr Segment<2, T> part(glm::vec<2, T> a, glm::vec<2, T> b, T first, T last) {
  const auto d = b - a;
  return {first == T(0) ? a : a + first * d, last == T(1) ? b : a + last * d};
}

/// The part of a segment that lies in a circle, by the foot of the perpendicular and half the chord: on the
/// line the circle reaches equally far to both sides of the foot.
/// The parametric view is that of Y.-D. Liang, B. A. Barsky, A new concept and method for line clipping, ACM
/// Transactions on Graphics 3(1), 1984, 1-22; a circle is not a rectangle, and t solves a quadratic.
///
/// segment, circle: in the same units. Returns the part, in the direction of the segment; nothing where the
///   segment misses the disc.
///
/// Domain: squares of squares of the differences neither overflow nor underflow (double: sizes from 2^-200
///   to 2^200). Equal ends are a point, kept when inside. Near tangents rounding decides.
/// Steps: Started Measured (Crossed Limited)? Finished; Crossed when D >= 0 and the ends differ.
/// Accuracy: no bound. Of 10,378 random segments in a circle of like size (ErrorsOfTheTextbookForms in the
///   tests, seed 20240611) 24 % are off by more than 1 ulp of max(|coordinate|, r), the worst by 29; near
///   tangents and with far ends it grows without limit.
/// Cost: 9 multiplications where the line misses; a square root and 2 divisions more where it hits.
/// Errors: ContractViolation when the radius is negative, NaN or infinite, or a point not finite.
template <std::floating_point T,
          Observer<Started<T>, Measured<T>, Crossed<T>, Limited<T>, Finished<T>> O = Unobserved>
std::optional<Segment<2, T>> half_chord(const Segment<2, T>& segment, const Circle<T>& circle,
                                        O&& observer = {}) {
  expect_circle(circle);
  expect_finite(segment.a);
  expect_finite(segment.b);
  std::optional<Segment<2, T>> kept;
  if constexpr (observed<O>) observer(Started<T>{segment, circle});
  auto [a, b] = segment;
  T r = circle.radius;
  auto d = b - a;
  auto f = a - circle.centre;
  T A = dot(d, d);
  T k = d.x * f.y - d.y * f.x;
  // Does the line come within r?
  T D = r * r * A - k * k;
  if constexpr (observed<O>) observer(Measured<T>{A, k, D});
  if (A == 0) {
    // A point, inside or not
    T C = dot(f, f) - r * r;
    if (C <= 0) kept = segment;
  } else if (D >= 0) {
    // Equally far from the foot
    T foot = -dot(f, d) / A;
    T half = std::sqrt(D) / A;
    T enter = foot - half;
    T leave = foot + half;
    if constexpr (observed<O>) observer(Crossed<T>{foot, half, enter, leave});
    // The segment is 0 <= t <= 1
    T from = std::max(T(0), enter);
    T to = std::min(T(1), leave);
    if constexpr (observed<O>) observer(Limited<T>{from, to});
    if (from <= to) {
      kept = part(a, b, from, to);
    }
  }
  if constexpr (observed<O>) observer(Finished<T>{kept});
  return kept;
}

// --- The method that is never wrong ------------------------------

/// The same part, every decision exact and every point rounded once. No root is needed to decide: the disc is
/// convex, so ends inside stay; and a segment with both ends outside meets it exactly when the foot of the
/// perpendicular lies between them and D >= 0. (That is the sign of a + b sqrt(D), squared out.)
///
/// segment, circle, result: as for half_chord.
///
/// Domain: all finite coordinates and radii, from subnormals to the largest. A radius of 0 is the centre
///   alone.
/// Steps: Started Placed Reached? Cut* Finished; Reached when both ends are outside, one Cut for each end
///   outside a segment that is kept.
/// Accuracy: what is kept is decided exactly. Ends inside or on the circle are copied; cut ones lie within
///   0.63 ulp of max(|coordinate|, radius) and inside the segment's box. (to, from) gives the reverse, bit
///   for bit. A rounded end may lie outside by its last bit, so clipping again may give less.
/// Cost: about 10 ns for a segment inside or well outside, 0.15 us for one that is cut; in doubt about 2 us.
/// Errors: as half_chord.
template <std::floating_point T, Observer<Started<T>, Placed, Reached, Cut<T>, Finished<T>> O = Unobserved>
std::optional<Segment<2, T>> exact_decision(const Segment<2, T>& segment, const Circle<T>& circle,
                                            O&& observer = {}) {
  expect_circle(circle);
  expect_finite(segment.a);
  expect_finite(segment.b);
  auto s = in_double(segment);
  auto c = in_double(circle);
  if constexpr (observed<O>) observer(Started<T>{segment, circle});
  // On which sides are the ends?
  int from = side(s.a, c);
  int to = side(s.b, c);
  if constexpr (observed<O>) observer(Placed{from, to});
  std::optional kept = segment;
  // Both outside: is the line near
  // enough, between them?
  if (from > 0 && to > 0) {
    bool foot = foot_between(s, c);
    int D = foot ? reach(s, c) : -1;
    if constexpr (observed<O>) observer(Reached{foot, D});
    if (D < 0) kept.reset();
  }
  // Ends outside move to the circle
  bool outside = from > 0 || to > 0;
  if (kept && outside) {
    auto chord = chord_on(s, c);
    if (from > 0) {
      kept->a = chord.entry(to);
      if constexpr (observed<O>) observer(Cut<T>{segment.a, kept->a, false});
    }
    if (to > 0) {
      kept->b = chord.exit(from);
      if constexpr (observed<O>) observer(Cut<T>{segment.b, kept->b, true});
    }
  }
  if constexpr (observed<O>) observer(Finished<T>{kept});
  return kept;
}

}  // namespace gradus::liang_barsky_circle
