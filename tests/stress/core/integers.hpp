#pragma once
// Doubles as whole numbers, exactly: the oracle of signs and of rounded quotients. Without fractions nothing
// has to be reduced.

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

namespace gradus::stress {

using Integer = boost::multiprecision::cpp_int;

/// x 2^1074, for infinities the number that would follow the largest. A product of two of these counts
/// 2^-2148, and so on: only sums of as many factors may be compared. Domain: not NaN.
template <class T>
Integer fixed(T x) {
  using Limits = std::numeric_limits<T>;
  if (std::isinf(x)) {
    const Integer beyond = Integer(1) << (Limits::max_exponent + 1074);
    return x < 0 ? Integer(-beyond) : beyond;
  }
  int exponent = 0;
  const double significand = std::frexp(double{x}, &exponent);
  // Of subnormals the lowest bits are 0
  const Integer digits = static_cast<std::int64_t>(std::ldexp(significand, 53));
  const int shift = exponent - 53 + 1074;
  return shift >= 0 ? Integer(digits << shift) : Integer(digits >> -shift);
}
/// x times a power of two, as a number of one more factor.
inline Integer times_one(const Integer& x) { return x << 1074; }

template <class T>
bool last_bit_is_zero(T x) {
  using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  return std::bit_cast<Bits>(x) % 2 == 0;
}

/// Whether no number of the type is nearer to above / below, and a tie went to even. Both have as many
/// factors. Domain: below is not 0.
template <class T>
bool is_nearest(T rounded, Integer above, Integer below) {
  if (std::isnan(rounded)) return false;
  if (below < 0) above = -above, below = -below;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const Integer twice = 2 * times_one(above), here = fixed(rounded);
  // On which side of the middle between the number and its neighbour
  const auto beyond_middle = [&](T neighbour) { return twice.compare((here + fixed(neighbour)) * below); };
  const int lower = rounded == -infinity ? 1 : beyond_middle(std::nextafter(rounded, -infinity));
  const int upper = rounded == infinity ? -1 : beyond_middle(std::nextafter(rounded, infinity));
  return last_bit_is_zero(rounded) ? lower >= 0 && upper <= 0 : lower > 0 && upper < 0;
}

}  // namespace gradus::stress
