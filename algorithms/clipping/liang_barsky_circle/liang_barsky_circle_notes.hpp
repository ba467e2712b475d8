#pragma once
// The notes' clipping of a segment with a circle, kept as exhibits (errata E001-26d to E001-26i).

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

namespace gradus::liang_barsky_circle {

/// The notes' quadratic A t^2 + B t + C = 0 is set up. Note the B: twice that of `Quadratic`.
template <class T>
struct Discriminant {
  T A, B, C, D;  ///< D = B^2 - 4 A C
};

/// The formula for the roots was evaluated.
template <class T>
struct Solved {
  T enters, leaves;
};

/// FAULTY: with D > 0 it takes the segment for the line, and never asks whether anything is left.
/// The notes' first listing (errata E001-26e): (2,0)-(3,0) gives (2,0)-(1,0) in the unit circle, outside
/// both; that a negative radius behaves like a positive one is E001-26i.
///
/// segment, circle: any; nothing is refused.
///
/// Domain: right where the segment itself meets the circle and A > 0.
/// Steps: Started Discriminant (Solved Limited)? Finished
/// Accuracy: as discriminant_equals_zero.
/// Cost: a square root and two divisions.
/// Errors: none.
template <std::floating_point T,
          Observer<Started<T>, Discriminant<T>, Solved<T>, Limited<T>, Finished<T>> O = Unobserved>
std::optional<Segment<2, T>> without_empty_test(const Segment<2, T>& segment, const Circle<T>& circle,
                                                O&& observer = {}) {
  std::optional<Segment<2, T>> kept;
  if constexpr (observed<O>) observer(Started<T>{segment, circle});
  auto [a, b] = segment;
  T r = circle.radius;
  auto d = b - a;
  auto f = a - circle.centre;
  T A = dot(d, d);
  T B = 2 * dot(f, d);
  T C = dot(f, f) - r * r;
  T D = B * B - 4 * A * C;
  if constexpr (observed<O>) observer(Discriminant<T>{A, B, C, D});
  if (D > 0) {
    // "The segment meets the circle
    // twice"
    T root = std::sqrt(D);
    T t1 = (-B - root) / (2 * A);
    T t2 = (-B + root) / (2 * A);
    if constexpr (observed<O>) observer(Solved<T>{t1, t2});
    T from = std::max(T(0), t1);
    T to = std::min(T(1), t2);
    if constexpr (observed<O>) observer(Limited<T>{from, to});
    kept = part(a, b, from, to);
  }
  if constexpr (observed<O>) observer(Finished<T>{kept});
  return kept;
}

/// FAULTY in three ways: D = 0 is a branch of its own although rounding decides it, A = 0 is divided by, and
/// B^2 - 4 A C cancels. The notes' second listing (errata E001-26f, g, h).
///
/// segment, circle: any; nothing is refused.
///
/// Domain: right for segments of moderate length that neither touch the circle nor are points.
/// Steps: Started Discriminant (Solved Limited)? Finished
/// Accuracy: none. (-1e8,0.5)-(1e8,0.5) gives the single point (0,0.5) of the chord from x = -0.866 to 0.866;
///   (-1e8,1.0000001)-(1e8,1.0000001) is accepted and misses; a point inside gives NaN for t and is lost.
/// Cost: a square root and two divisions.
/// Errors: none.
template <std::floating_point T,
          Observer<Started<T>, Discriminant<T>, Solved<T>, Limited<T>, Finished<T>> O = Unobserved>
std::optional<Segment<2, T>> discriminant_equals_zero(const Segment<2, T>& segment, const Circle<T>& circle,
                                                      O&& observer = {}) {
  std::optional<Segment<2, T>> kept;
  if constexpr (observed<O>) observer(Started<T>{segment, circle});
  auto [a, b] = segment;
  T r = circle.radius;
  auto d = b - a;
  auto f = a - circle.centre;
  T A = dot(d, d);
  T B = 2 * dot(f, d);
  T C = dot(f, f) - r * r;
  T D = B * B - 4 * A * C;
  if constexpr (observed<O>) observer(Discriminant<T>{A, B, C, D});
  if (D == 0) {
    // "The line touches the circle"
    T t = -B / (2 * A);
    if constexpr (observed<O>) observer(Solved<T>{t, t});
    if (0 <= t && t <= 1) {
      kept = part(a, b, t, t);
    }
  } else if (D > 0) {
    T root = std::sqrt(D);
    T t1 = (-B - root) / (2 * A);
    T t2 = (-B + root) / (2 * A);
    if constexpr (observed<O>) observer(Solved<T>{t1, t2});
    T from = std::max(T(0), t1);
    T to = std::min(T(1), t2);
    if constexpr (observed<O>) observer(Limited<T>{from, to});
    if (from <= to) {
      kept = part(a, b, from, to);
    }
  }
  if constexpr (observed<O>) observer(Finished<T>{kept});
  return kept;
}

}  // namespace gradus::liang_barsky_circle
