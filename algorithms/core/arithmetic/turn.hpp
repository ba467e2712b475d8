#pragma once
// An angle as transformations use it: its sine, its cosine, and 1 - cosine.

#include <cmath>
#include <concepts>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"

namespace gradus {

/// A turn by some angle, counter-clockwise.
///
/// The versine is kept because 1 - cos, taken of a rounded cosine, is 0 for every angle below 1e-8.
template <class T>
struct Turn {
  T sin, cos;
  T versine;  ///< 1 - cos
};

/// The turn with these two, for a scalar without sine and cosine: 3/5 and 4/5, say.
/// Domain: sin^2 + cos^2 = 1 (not checked).
template <class T>
Turn<T> turn_of(T sin, T cos) {
  return {sin, cos, T(1) - cos};
}

/// The turn of an angle whose sine and cosine, and those of its half, are known.
/// Source: 1 - cos a = 2 sin^2(a/2), where the subtraction would cancel.
template <std::floating_point T>
Turn<T> turn_from(SinCos whole, SinCos half) {
  const double versine = whole.cos > 0.5 ? 2 * half.sin * half.sin : 1 - whole.cos;
  return {static_cast<T>(whole.sin), static_cast<T>(whole.cos), static_cast<T>(versine)};
}

/// radians: any finite angle, 1e22 as good as 1.
/// Accuracy: sine and cosine 0.501 ulp, versine 3 ulp.
/// Errors: ContractViolation for an infinite angle and NaN.
template <std::floating_point T>
Turn<T> turn(T radians) {
  expects(std::isfinite(radians), "a turn needs a finite angle, not {} radians", radians);
  return turn_from<T>(sin_cos(double{radians}), sin_cos(double{radians} / 2));
}

/// The same from degrees. Exact at multiples of 90: 0, 1, -1 and 2.
template <std::floating_point T>
Turn<T> turn_degrees(T degrees) {
  expects(std::isfinite(degrees), "a turn needs a finite angle, not {} degrees", degrees);
  return turn_from<T>(sin_cos_degrees(double{degrees}), sin_cos_degrees(double{degrees} / 2));
}

/// The turn back.
template <class T>
Turn<T> reversed(const Turn<T>& turn) {
  return {T(0) - turn.sin, turn.cos, turn.versine};
}

}  // namespace gradus
