#pragma once
// A power between two bounds, in a twentieth of the time of the nearest double: for what is rounded more
// coarsely in the end, where both bounds nearly always become the same.

#include "core/language.hpp"

namespace gradus {

/// Two numbers with another between them, or equal to one or both.
struct Between {
  double low, high;
};

/// Bounds of x to the power y, and of what `pow` makes of it.
///
/// Domain: every double. A power below 2^-1000 is between 0 and 2^-999. Both bounds are what `pow` gives for
///   an x that is not normal and positive, and for a power above 2^1000.
/// Source: log2 x = k - log2 c + log2(1 + r), with c from a table of 64 so that x c = 2^k (1 + r);
///   2^t = 2^n 2^(j/32) 2^r, with 2^(j/32) from a table; Taylor series of both in r.
/// Accuracy: the bounds are apart by 2^-48 (1 + |y log2 x|) of the power.
/// Cost: 20 multiplications, two look-ups.
Between power_bounds(double x, double y);

}  // namespace gradus
