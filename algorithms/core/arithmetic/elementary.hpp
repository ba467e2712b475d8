#pragma once
// sin, cos, tan, asin, acos, atan, atan2, exp, log, pow with the same bits on every compiler and machine.
//
// The libraries' functions differ in the last place (glibc, musl, …), and a figure or a trace would differ
// with them. These use nothing but +, -, *, / and sqrt, which IEEE 754 fixes, on pairs of doubles
// ("double-double", Dekker 1971), and round once at the end. They need round-to-nearest, and have the same
// bits where the compiler fuses products and sums (see core/arithmetic/rounding.hpp).
//
// For all of them. Domain: every double; special values as in C (ISO C Annex F), e.g. log(-1) = NaN,
// log(0) = -infinity, atan2(-0, -1) = -pi; NaN comes out as one canonical NaN; errno is not touched.
// Accuracy: double: less than 0.501 ulp, subnormal results included (tests/stress/core/elementary); float:
// less than 0.5001 ulp. So nearly always the nearest number, but not by proof: do not decide signs by them.
// Cost: 0.1 to 0.3 us per call.

#include <cmath>
#include <limits>

#include "core/arithmetic/rounding.hpp"

namespace gradus {

/// The sine and cosine of one angle.
struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine of an angle in radians, with the reduction by pi/2 that any size of angle needs: at 1e22
/// too. Source: reduction Payne and Hanek 1983 (radian reduction for trigonometric functions); Taylor series.
/// Domain: infinities give NaN.
SinCos sin_cos(double radians);
double sin(double radians);
double cos(double radians);
/// Domain: infinities give NaN. There is no pole: no double is an odd multiple of pi/2.
double tan(double radians);

/// Sine and cosine of an angle in degrees. Exact at multiples of 90, where zeros are positive; the cosine
/// of 60 is exactly 0.5.
/// The reduction by 90 is exact, so 1e300 degrees are as good as 1. Domain: infinities give NaN.
SinCos sin_cos_degrees(double degrees);

/// Degrees times pi/180, for the edge where people's degrees become radians.
/// Domain: every double; infinities stay what they are.
double radians_from_degrees(double degrees);

/// The angle in [-pi/2, pi/2] whose sine is x. Domain: |x| > 1 gives NaN.
double asin(double x);
/// The angle in [0, pi] whose cosine is x. Domain: |x| > 1 gives NaN.
double acos(double x);
/// The angle in [-pi/2, pi/2] whose tangent is x.
double atan(double x);
/// The angle in [-pi, pi] of the direction (x, y); the signs of zeros and infinities count as in C.
/// Source: table of atan(j/8), addition theorem, Gregory's series.
double atan2(double y, double x);

/// e to the power x. Source: x = n ln 2 + r, Taylor series of e^r, times 2^n.
double exp(double x);
/// The natural logarithm. Source: x = 2^n m, 2 artanh((m - 1)/(m + 1)) + n ln 2. Domain: x < 0 gives NaN.
double log(double x);
/// x to the power y. Source: exp(y log x), the logarithm kept to 80 bits.
/// Domain: x < 0 with y not an integer gives NaN; pow(x, 0) = pow(1, y) = 1 for every x and y, NaN included.
double pow(double x, double y);

/// The nearest double to the square root: IEEE 754 fixes it, so the library's is portable; only the sign of
/// its NaN is not. Domain: x < 0 gives NaN.
inline double sqrt(double x) { return x >= 0 ? std::sqrt(x) : std::numeric_limits<double>::quiet_NaN(); }

// The same for float: computed in double, rounded once more.
inline float sin(float radians) { return static_cast<float>(sin(double{radians})); }
inline float cos(float radians) { return static_cast<float>(cos(double{radians})); }
inline float tan(float radians) { return static_cast<float>(tan(double{radians})); }
inline float asin(float x) { return static_cast<float>(asin(double{x})); }
inline float acos(float x) { return static_cast<float>(acos(double{x})); }
inline float atan(float x) { return static_cast<float>(atan(double{x})); }
inline float atan2(float y, float x) { return static_cast<float>(atan2(double{y}, double{x})); }
inline float exp(float x) { return static_cast<float>(exp(double{x})); }
inline float log(float x) { return static_cast<float>(log(double{x})); }
inline float pow(float x, float y) { return static_cast<float>(pow(double{x}, double{y})); }
inline float sqrt(float x) { return x >= 0 ? std::sqrt(x) : std::numeric_limits<float>::quiet_NaN(); }

}  // namespace gradus
