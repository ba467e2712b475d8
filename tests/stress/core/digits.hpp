#pragma once
// Numbers of 50 digits, and how far a result is from them.

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "stress/domain.hpp"

namespace gradus::stress {

using Digits = boost::multiprecision::cpp_bin_float_50;
/// Enough of them to reduce the largest double by pi.
using ManyDigits = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<1500, boost::multiprecision::digit_base_2>>;

/// The distance of a result from the exact number, in units of the type's last place there; from numbers
/// beyond the type's largest, 0 for that and for infinity.
template <class T>
double ulps(T found, const Digits& exact) {
  using Limits = std::numeric_limits<T>;
  if (abs(exact) >= Digits(Limits::max())) {
    return std::abs(found) >= Limits::max() && (found > 0) == (exact > 0) ? 0 : wrong;
  }
  if (!std::isfinite(found)) return wrong;
  constexpr int lowest = Limits::min_exponent - Limits::digits;
  const int last_place = exact == 0 ? lowest : std::max(ilogb(exact) - Limits::digits + 1, lowest);
  return static_cast<double>(abs(Digits(found) - exact) / ldexp(Digits(1), last_place));
}

/// An angle without whole turns.
inline Digits reduced(double radians) {
  static const ManyDigits turn = 2 * boost::math::constants::pi<ManyDigits>();
  if (std::abs(radians) < 3) return Digits(radians);
  const ManyDigits turns = round(ManyDigits(radians) / turn);
  return Digits(ManyDigits(radians) - turns * turn);
}

}  // namespace gradus::stress
