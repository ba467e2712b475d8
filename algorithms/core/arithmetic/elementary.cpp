#include "core/arithmetic/elementary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/arithmetic/exact.hpp"
#include "core/arithmetic/rounding.hpp"

namespace gradus {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// --- Double-double ---------------------------------------------------------------------------------------

// A number of some 104 bits as the sum of two doubles, high the nearest one to it
struct DoubleDouble {
  double high;
  double low;
};

constexpr DoubleDouble normalized(double high, double low) {
  const Rounded sum = fast_two_sum(high, low);
  return {sum.value, sum.error};
}

constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const Rounded high = two_sum(a.high, b.high);
  const Rounded low = two_sum(a.low, b.low);
  const DoubleDouble sum = normalized(high.value, high.error + low.value);
  return normalized(sum.high, sum.low + low.error);
}

constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + (-b); }

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const Rounded product = two_product(a.high, b.high);
  return normalized(product.value, product.error + (unfused(a.high * b.low) + unfused(a.low * b.high)));
}

constexpr DoubleDouble operator*(DoubleDouble a, double b) { return a * DoubleDouble{b, 0}; }

constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double quotient = a.high / b.high;
  const DoubleDouble rest = a - b * quotient;
  return normalized(quotient, rest.high / b.high);
}

// Domain: a > 0
DoubleDouble square_root(DoubleDouble a) {
  const double root = std::sqrt(a.high);
  const DoubleDouble rest = a - DoubleDouble{root, 0} * root;
  return normalized(root, rest.high / (2 * root));
}

// --- Constants -------------------------------------------------------------------------------------------

constexpr DoubleDouble pi = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoubleDouble half_pi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr DoubleDouble radians_per_degree = {0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};

// ln 2 with so short a leading part that its multiples up to 2^12 are exact
constexpr double ln2_leading = 0x1.62e42fefa2000p-1;
constexpr DoubleDouble ln2_rest = {0x1.9ef35793c7673p-41, 0x1.f97b57a079a19p-103};

// atan(j / 8)
constexpr std::array<DoubleDouble, 9> atan_of_eighths = {{{0, 0},
                                                          {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                                          {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                                          {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                                          {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                                          {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                                          {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                                          {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                                          {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

// The binary digits of 2 / pi after 64 zeros, enough for the largest double
constexpr std::array<std::uint64_t, 21> two_over_pi = {
    0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561,
    0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484, 0xe99c7026b45f7e41,
    0x3991d639835339f4, 0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d, 0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab,
    0xf0cfbc209af4361d};

// --- Power series ----------------------------------------------------------------------------------------

template <std::size_t Terms>
using Series = std::array<DoubleDouble, Terms>;

// 1 / k! for k = first, first + step, …; exact to 100 bits as far as k! is a double (k <= 22)
template <std::size_t Terms>
constexpr Series<Terms> reciprocal_factorials(int first, int step) {
  Series<Terms> series{};
  double factorial = 1;
  for (int k = 1; k <= first; ++k) factorial *= k;
  for (DoubleDouble& coefficient : series) {
    coefficient = DoubleDouble{1, 0} / DoubleDouble{factorial, 0};
    for (int k = 0; k < step; ++k) factorial *= ++first;
  }
  return series;
}

// 1, 1/3, 1/5, …
template <std::size_t Terms>
constexpr Series<Terms> reciprocal_odd_numbers() {
  Series<Terms> series{};
  double odd = 1;
  for (DoubleDouble& coefficient : series) {
    coefficient = DoubleDouble{1, 0} / DoubleDouble{odd, 0};
    odd += 2;
  }
  return series;
}

constexpr auto sine_series = reciprocal_factorials<12>(1, 2);
constexpr auto cosine_series = reciprocal_factorials<12>(0, 2);
constexpr auto exponential_series = reciprocal_factorials<18>(0, 1);
constexpr auto arctangent_series = reciprocal_odd_numbers<12>();
constexpr auto logarithm_series = reciprocal_odd_numbers<18>();

// c0 + c1 x + c2 x^2 + … by Horner's rule. The far terms are so small that plain double serves for them.
template <std::size_t Terms>
DoubleDouble evaluate(const Series<Terms>& series, DoubleDouble x, std::size_t near_terms) {
  double far = 0;
  for (std::size_t i = Terms; i-- > near_terms;) far = unfused(far * x.high) + series[i].high;
  DoubleDouble sum = {far, 0};
  for (std::size_t i = near_terms; i-- > 0;) sum = sum * x + series[i];
  return sum;
}

// --- Exponents -------------------------------------------------------------------------------------------

// 2^n. Domain: -1022 <= n <= 1023
double power_of_two(int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52); }

// The n of 2^n <= |x| < 2^(n+1). Domain: x normal
int exponent_of(double x) { return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7FF) - 1023; }

// The nearest double to x * 2^n, also where that is subnormal or infinite. Domain: 1/2 < x < 2
double scaled(DoubleDouble x, int n) {
  if (-1021 <= n && n <= 1022) return x.high * power_of_two(n);
  const std::uint64_t significand =
      static_cast<std::uint64_t>(x.high * 0x1p62) +
      static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x.low * 0x1p62)));
  return nearest_double(false, significand, n - 62, true);
}

// The nearest whole number. Domain: |x| < 2^31
int nearest_int(double x) { return static_cast<int>(x < 0 ? x - 0.5 : x + 0.5); }

// --- Sine and cosine -------------------------------------------------------------------------------------

// quadrant * 90 degrees + rest, |rest| <= 45 degrees, the rest in radians
struct ReducedAngle {
  int quadrant;
  DoubleDouble rest;
};

using Wide = std::array<std::uint64_t, 4>;  // 256 bits, lowest word first

// 256 binary digits of 2 / pi from this one on
Wide digits_of_two_over_pi(int first) {
  const std::size_t word = static_cast<std::size_t>(first / 64);
  const int shift = first % 64;
  Wide digits{};
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::uint64_t here = two_over_pi[word + i], next = two_over_pi[word + i + 1];
    digits[digits.size() - 1 - i] = shift == 0 ? here : here << shift | next >> (64 - shift);
  }
  return digits;
}

// x * factor modulo 2^256
Wide times(const Wide& x, std::uint64_t factor) {
  __extension__ typedef unsigned __int128 Uint128;
  Wide product{};
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Uint128 sum = Uint128{x[i]} * factor + carry;
    product[i] = static_cast<std::uint64_t>(sum);
    carry = static_cast<std::uint64_t>(sum >> 64);
  }
  return product;
}

Wide shifted_left(const Wide& x, int bits) {
  const std::size_t words = static_cast<std::size_t>(bits / 64);
  const int shift = bits % 64;
  Wide result{};
  for (std::size_t i = x.size(); i-- > words;) {
    const std::uint64_t below = i > words ? x[i - words - 1] : 0;
    result[i] = shift == 0 ? x[i - words] : x[i - words] << shift | below >> (64 - shift);
  }
  return result;
}

Wide negated(Wide x) {
  bool carry = true;
  for (std::uint64_t& word : x) {
    word = ~word + (carry ? 1 : 0);
    carry = carry && word == 0;
  }
  return x;
}

// A fraction 0 < x < 1 of 256 binary digits, rounded to a double-double with all of its relative accuracy
DoubleDouble from_fraction(const Wide& x) {
  int zeros = 0;
  for (std::size_t i = x.size(); i-- > 0;) {
    zeros += std::countl_zero(x[i]);
    if (x[i] != 0) break;
  }
  const Wide digits = shifted_left(x, zeros);
  const std::uint64_t first = digits[3] >> 11;                               // 53 digits
  const std::uint64_t second = (digits[3] & 0x7FF) << 42 | digits[2] >> 22;  // and 53 more
  return normalized(static_cast<double>(first) * power_of_two(-53 - zeros),
                    static_cast<double>(second) * power_of_two(-106 - zeros));
}

// Source: Payne and Hanek 1983. x times 2/pi is wanted only modulo 4, so the digits of 2/pi that give
// multiples of 4 are left out, and 256 digits keep 100 good ones behind the longest run of zeros. Domain: 0
// <= x, finite
ReducedAngle reduced(double x) {
  if (x <= 0x1.921fb54442d18p-1) return {0, {x, 0}};  // pi / 4
  const int exponent = exponent_of(x) - 52;
  const std::uint64_t significand = (std::bit_cast<std::uint64_t>(x) & 0xF'FFFF'FFFF'FFFF) | std::uint64_t{1}
                                                                                                 << 52;
  const Wide quarters = times(digits_of_two_over_pi(exponent + 62), significand);

  // Two digits of quadrant, then the fraction; one above 1/2 counts back from the next quadrant
  const int quadrant = static_cast<int>(quarters[3] >> 62);
  const Wide fraction = shifted_left(quarters, 2);
  if (fraction[3] >> 63 == 0) return {quadrant, from_fraction(fraction) * half_pi};
  return {(quadrant + 1) % 4, -(from_fraction(negated(fraction)) * half_pi)};
}

struct SinCosPair {
  DoubleDouble sin;
  DoubleDouble cos;
};

// Terms of the series as double-doubles: all that it takes, and few with an error below 2^-61 of the result
constexpr std::size_t all_near_terms = 5, few_near_terms = 3;

// Taylor's series. Domain: |x| <= pi / 4
DoubleDouble sine_near_zero(DoubleDouble x, std::size_t near_terms) {
  return x * evaluate(sine_series, -(x * x), near_terms);
}
DoubleDouble cosine_near_zero(DoubleDouble x, std::size_t near_terms) {
  return evaluate(cosine_series, -(x * x), near_terms);
}

SinCosPair sin_cos_of(const ReducedAngle& angle) {
  const DoubleDouble sine = sine_near_zero(angle.rest, all_near_terms);
  const DoubleDouble cosine = cosine_near_zero(angle.rest, all_near_terms);
  switch (angle.quadrant) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

// Whether all numbers within 2^-60 of x, relatively, have the same nearest double
bool rounds_safely(DoubleDouble x) {
  const double off = std::abs(x.high) * 0x1p-60;
  return x.high + (x.low + off) == x.high && x.high + (x.low - off) == x.high;
}

// The double nearest to a series. Source: Ziv 1991. The few terms decide nearly always, and else all of them
template <class Near>
double rounded(Near near_zero, DoubleDouble x) {
  const DoubleDouble estimate = near_zero(x, few_near_terms);
  return rounds_safely(estimate) ? estimate.high : near_zero(x, all_near_terms).high;
}

// The sine of this many quadrants and the rest; the cosine is that of one more.
double rounded_sine(int quadrant, DoubleDouble rest) {
  const double size = quadrant % 2 == 0 ? rounded(sine_near_zero, rest) : rounded(cosine_near_zero, rest);
  return quadrant % 4 < 2 ? size : -size;
}
double rounded_cosine(int quadrant, DoubleDouble rest) { return rounded_sine(quadrant + 1, rest); }

// Then the next term of the series, at most x^3 / 3, is below a fifth of an ulp: x is the nearest double
bool is_tiny(double x) { return std::abs(x) < 0x1p-27; }

// --- Arc tangent -----------------------------------------------------------------------------------------

// The angle of the point (x, y) in the first quadrant, from 0 to pi/2. Domain: x, y >= 0, not both 0
DoubleDouble first_quadrant_angle(DoubleDouble y, DoubleDouble x) {
  const bool steep = y.high > x.high;
  if (steep) std::swap(x, y);

  // atan(y/x) = atan(c) + atan((y - c x) / (x + c y)) with c the nearest multiple of 1/8
  const int eighths = nearest_int(8 * (y.high / x.high));
  const double c = eighths / 8.0;
  const DoubleDouble t = (y - x * c) / (x + y * c);
  const DoubleDouble correction = t * evaluate(arctangent_series, -(t * t), 4);
  const DoubleDouble angle = atan_of_eighths[static_cast<std::size_t>(eighths)] + correction;
  return steep ? half_pi - angle : angle;
}

// Cosine from sine, or the other way round: sqrt(1 - x^2). Domain: |x| < 1
DoubleDouble other_leg(double x) {
  const Rounded below = two_difference(1, x), above = two_sum(1, x);
  const DoubleDouble square = DoubleDouble{below.value, below.error} * DoubleDouble{above.value, above.error};
  return square_root(square);
}

// --- Exponential and logarithm ---------------------------------------------------------------------------

// e^x, rounded. Domain: |x| < 800
double exponential(DoubleDouble x) {
  // x = n ln 2 + r
  const int n = nearest_int(unfused(x.high * 0x1.71547652b82fep+0));
  const DoubleDouble r = (x - DoubleDouble{n * ln2_leading, 0}) - ln2_rest * n;
  return scaled(evaluate(exponential_series, r, 6), n);
}

// ln x to some 80 bits. Domain: x > 0, finite
DoubleDouble logarithm(double x) {
  int n = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;  // subnormal
    n = -54;
  }
  // x = 2^n m with m around 1
  const int exponent = exponent_of(x);
  double m =
      std::bit_cast<double>((std::bit_cast<std::uint64_t>(x) & 0xF'FFFF'FFFF'FFFF) | 0x3FF0'0000'0000'0000);
  n += exponent;
  if (m > 0x1.6a09e667f3bcdp+0) {  // sqrt 2
    m /= 2;
    ++n;
  }
  // ln m = 2 artanh((m - 1) / (m + 1))
  const Rounded above = two_sum(m, 1);
  const DoubleDouble s = DoubleDouble{m - 1, 0} / DoubleDouble{above.value, above.error};
  const DoubleDouble ln_m = s * evaluate(logarithm_series, s * s, 6) * 2.0;
  return DoubleDouble{n * ln2_leading, 0} + (ln2_rest * n + ln_m);
}

// --- Integers among doubles, for pow ---------------------------------------------------------------------

bool is_integer(double y) { return std::abs(y) >= 0x1p52 || std::floor(y) == y; }
bool is_odd_integer(double y) {
  return std::abs(y) < 0x1p53 && is_integer(y) && static_cast<std::int64_t>(y) % 2 != 0;
}

// |x|^y where either is 0 or infinite. Domain: y not 0
double power_of_extremes(double size, double y) {
  if (size == 1) return 1;
  const bool grows = (size > 1) == (y > 0);
  return grows ? infinity : 0.0;
}

// |x|^y. Domain: size > 0 and y finite, y not 0
double power(double size, double y) {
  const DoubleDouble log_of_size = logarithm(size);
  const double estimate = y * log_of_size.high;
  if (estimate > 750) return infinity;
  if (estimate < -750) return 0;
  if (std::abs(estimate) < 0x1p-60) return 1;
  return exponential(log_of_size * y);
}

}  // namespace

SinCos sin_cos(double radians) {
  if (!std::isfinite(radians)) return {not_a_number, not_a_number};
  if (is_tiny(radians)) return {radians, 1};
  const auto [quadrant, rest] = reduced(std::abs(radians));
  const double sine = rounded_sine(quadrant, rest);
  return {radians < 0 ? -sine : sine, rounded_cosine(quadrant, rest)};
}

double sin(double radians) { return sin_cos(radians).sin; }

double cos(double radians) {
  if (!std::isfinite(radians)) return not_a_number;
  if (is_tiny(radians)) return 1;
  const auto [quadrant, rest] = reduced(std::abs(radians));
  return rounded_cosine(quadrant, rest);
}

double tan(double radians) {
  if (!std::isfinite(radians)) return not_a_number;
  if (is_tiny(radians)) return radians;
  const SinCosPair pair = sin_cos_of(reduced(std::abs(radians)));
  const DoubleDouble quotient = pair.sin / pair.cos;
  return radians < 0 ? -quotient.high : quotient.high;
}

SinCos sin_cos_degrees(double degrees) {
  if (!std::isfinite(degrees)) return {not_a_number, not_a_number};
  // Exact: the remainder of a division is always a double. Below, + 0.0 makes every zero positive.
  const double turned = std::fmod(std::abs(degrees), 360.0);
  const int quadrants = nearest_int(turned / 90);
  const double rest = turned - 90 * quadrants;
  if (quadrants == 0 && is_tiny(rest)) {
    return {radians_from_degrees(std::copysign(rest, degrees)) + 0.0, 1};
  }
  const DoubleDouble radians = DoubleDouble{rest, 0} * radians_per_degree;
  const double sine = rounded_sine(quadrants, radians);
  return {(degrees < 0 ? -sine : sine) + 0.0, rounded_cosine(quadrants, radians) + 0.0};
}

double radians_from_degrees(double degrees) {
  if (std::isnan(degrees)) return not_a_number;
  if (degrees == 0 || std::isinf(degrees)) return degrees;
  const double size = std::abs(degrees);
  if (0x1p-900 < size && size < 0x1p900) return (DoubleDouble{degrees, 0} * radians_per_degree).high;

  // Where a double-double would overflow or lose its low part
  SumOfProducts<2> product;
  product.add(degrees, radians_per_degree.high);
  product.add(degrees, radians_per_degree.low);
  return rounded(product);
}

double asin(double x) {
  if (!(std::abs(x) <= 1)) return not_a_number;
  if (is_tiny(x)) return x;
  if (std::abs(x) == 1) return std::copysign(half_pi.high, x);
  return std::copysign(first_quadrant_angle({std::abs(x), 0}, other_leg(x)).high, x);
}

double acos(double x) {
  if (!(std::abs(x) <= 1)) return not_a_number;
  if (std::abs(x) == 1) return x > 0 ? 0 : pi.high;
  const DoubleDouble angle = first_quadrant_angle(other_leg(x), {std::abs(x), 0});
  return x < 0 ? (pi - angle).high : angle.high;
}

double atan(double x) { return atan2(x, 1); }

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return not_a_number;
  double width = std::abs(x), height = std::abs(y);
  const bool leftwards = std::signbit(x);

  // Points on or very near an axis, and at infinity
  if (std::isinf(width) && std::isinf(height)) width = height = 1;
  if (height == 0 || height < width * 0x1p-60 || std::isinf(width)) {
    const double slope = height == 0 ? 0 : height / width;  // so small that it is its own arc tangent
    return std::copysign(leftwards ? pi.high : slope, y);
  }
  if (width < height * 0x1p-60 || std::isinf(height)) return std::copysign(half_pi.high, y);

  // Both near 1, so that no product overflows or underflows
  const double scale = height > 1 || width > 1 ? 0x1p-600 : 0x1p+600;
  if (std::max(width, height) < 0x1p-300 || std::max(width, height) > 0x1p300) {
    width *= scale;
    height *= scale;
  }
  const DoubleDouble angle = first_quadrant_angle({height, 0}, {width, 0});
  return std::copysign(leftwards ? (pi - angle).high : angle.high, y);
}

double exp(double x) {
  if (std::isnan(x)) return not_a_number;
  if (x > 750) return infinity;
  if (x < -750) return 0;
  if (std::abs(x) < 0x1p-60) return 1;
  return exponential({x, 0});
}

double log(double x) {
  if (std::isnan(x) || x < 0) return not_a_number;
  if (x == 0) return -infinity;
  if (std::isinf(x)) return infinity;
  return logarithm(x).high;
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return not_a_number;

  const double size = std::abs(x);
  const bool extreme = size == 0 || std::isinf(size) || std::isinf(y);
  if (x < 0 && !extreme && !is_integer(y)) return not_a_number;
  const double result = extreme ? power_of_extremes(size, y) : power(size, y);
  return std::signbit(x) && is_odd_integer(y) ? -result : result;
}

}  // namespace gradus
