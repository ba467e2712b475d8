// The promises of sin ... pow, against 50 digits, and of their special values, against C's.

#include "core/arithmetic/elementary.hpp"

#include <cmath>

#include "stress/core/digits.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

// --- Functions of one number ---

/// A function of ours, that of C, and the exact one.
struct Function {
  double (*ours)(double);
  float (*of_float)(float);
  double (*of_c)(double);
  Digits (*exact)(double);
};

const Function sine{gradus::sin, gradus::sin, std::sin, [](double x) { return Digits(sin(reduced(x))); }};
const Function cosine{gradus::cos, gradus::cos, std::cos, [](double x) { return Digits(cos(reduced(x))); }};
const Function tangent{gradus::tan, gradus::tan, std::tan, [](double x) { return Digits(tan(reduced(x))); }};
const Function arc_sine{gradus::asin, gradus::asin, std::asin,
                        [](double x) { return Digits(asin(Digits(x))); }};
const Function arc_cosine{gradus::acos, gradus::acos, std::acos,
                          [](double x) { return Digits(acos(Digits(x))); }};
const Function arc_tangent{gradus::atan, gradus::atan, std::atan,
                           [](double x) { return Digits(atan(Digits(x))); }};
const Function exponential{gradus::exp, gradus::exp, std::exp,
                           [](double x) { return Digits(exp(Digits(x))); }};
const Function logarithm{gradus::log, gradus::log, std::log, [](double x) { return Digits(log(Digits(x))); }};

bool is_special(double of_c) { return std::isnan(of_c) || std::isinf(of_c) || of_c == 0; }
/// Where C's function gives no number, an infinity or a zero, ours gives the same; at the ends of the range
/// C's may round otherwise.
double special_error(double ours, double of_c) {
  const bool same = std::isnan(of_c) ? std::isnan(ours)
                    : std::isinf(of_c)
                        ? ours == of_c || std::abs(ours) > 0x1.ffffffffffffp1023
                        : std::abs(ours) <= 0x1p-1074 && std::signbit(ours) == std::signbit(of_c);
  return same ? 0 : wrong;
}

double error_of(const Function& f, double x) {
  const double ours = f.ours(x), of_c = f.of_c(x);
  return is_special(of_c) ? special_error(ours, of_c) : ulps(ours, f.exact(x));
}
/// The same for float; results too small or too large for it are special.
double float_error_of(const Function& f, double x) {
  const auto given = static_cast<float>(x);
  const float ours = f.of_float(given), of_c = static_cast<float>(f.of_c(given));
  return is_special(of_c) ? 0 : ulps(ours, f.exact(given));
}

double odd_and_even(double x) {
  const auto same = [](double a, double b) { return a == b || std::isnan(a); };
  const SinCos both = sin_cos(x);
  const bool holds = same(gradus::sin(-x), -gradus::sin(x)) && same(gradus::cos(-x), gradus::cos(x)) &&
                     same(gradus::tan(-x), -gradus::tan(x)) && same(gradus::atan(-x), -gradus::atan(x)) &&
                     same(both.sin, gradus::sin(x)) && same(both.cos, gradus::cos(x));
  return holds ? 0 : wrong;
}

/// Multiples of 90 degrees are exact, with positive zeros.
double degrees_error(double x) {
  const SinCos found = sin_cos_degrees(x);
  if (!std::isfinite(x)) return std::isnan(found.sin) && std::isnan(found.cos) ? 0 : wrong;
  static const ManyDigits degree = boost::math::constants::pi<ManyDigits>() / 180;
  const double radians = ulps(radians_from_degrees(x), Digits(ManyDigits(x) * degree));
  const double rest = std::fmod(x, 360.0);
  if (std::fmod(rest, 90.0) == 0) {
    const bool level = std::fmod(rest, 180.0) == 0, positive = rest == 0 || rest == 90 || rest == -270;
    const double none = level ? found.sin : found.cos, one = level ? found.cos : found.sin;
    return none == 0 && !std::signbit(none) && one == (positive ? 1 : -1) ? radians : wrong;
  }
  const Digits angle(ManyDigits(rest) * degree);
  return std::max({radians, ulps(found.sin, Digits(sin(angle))), ulps(found.cos, Digits(cos(angle)))});
}

// --- Functions of two ---

double atan2_error(double y, double x) {
  const double ours = gradus::atan2(y, x), of_c = std::atan2(y, x);
  if (is_special(of_c)) return special_error(ours, of_c);
  if (std::isfinite(x) && std::isfinite(y)) return ulps(ours, Digits(atan2(Digits(y), Digits(x))));
  return std::abs(ours - of_c) <= 0x1p-50 ? 0 : wrong;
}
double pow_error(double x, double y) {
  const double ours = gradus::pow(x, y), of_c = std::pow(x, y);
  if (is_special(of_c)) return special_error(ours, of_c);
  if (!std::isfinite(x) || !std::isfinite(y)) return ours == of_c ? 0 : wrong;
  const Digits size(pow(Digits(std::abs(x)), Digits(y)));
  return ulps(ours, x < 0 && std::fmod(y, 2.0) != 0 ? Digits(-size) : size);
}
double float_error(const Input& i) {
  const auto x = static_cast<float>(i[0]), y = static_cast<float>(i[1]);
  double worst = 0;
  for (const Function& f :
       {sine, cosine, tangent, arc_sine, arc_cosine, arc_tangent, exponential, logarithm}) {
    worst = std::max(worst, float_error_of(f, i[0]));
  }
  if (std::isfinite(x) && std::isfinite(y) && y != 0) {
    worst = std::max(worst, ulps(gradus::atan2(y, x), Digits(atan2(Digits(y), Digits(x)))));
  }
  const float power = std::pow(x, y);
  const bool has_power = std::isfinite(x) && std::isfinite(y) && x > 0 && !is_special(power);
  return has_power ? std::max(worst, ulps(gradus::pow(x, y), Digits(pow(Digits(x), Digits(y))))) : worst;
}

// --- Inputs ---

constexpr double quarter = 0x1.921fb54442d18p+0;  // of a turn
constexpr double half_log_2 = 0x1.62e42fefa39efp-2;

/// Doubles nearest to multiples of a quarter turn, where nearly all digits cancel.
Input angle(Kind kind, Random& random) {
  if (kind == Kind::near_degenerate) return {std::floor(sized(random, 0, 60)) * quarter};
  if (kind == Kind::grazing) return {nudged(std::round(random.uniform(-16, 16)) * quarter, random)};
  return {kind == Kind::random && random.unit() < 0.5 ? sized(random, -40, 10) : number(kind, random)};
}
Input degrees(Kind kind, Random& random) {
  if (kind == Kind::random) return {random.uniform(-720, 720)};
  if (kind == Kind::ties) return {90 * std::round(random.uniform(-1000, 1000))};
  if (kind == Kind::near_degenerate)
    return {90 * std::round(random.uniform(-1000, 1000)) + sized(random, -40, -5)};
  return {number(kind, random)};
}
Input of_arc(Kind kind, Random& random) {
  if (kind == Kind::random) return {random.uniform(-1, 1)};
  if (kind == Kind::grazing)
    return {std::copysign(1 - std::abs(sized(random, -53, -1)), random.unit() - 0.5)};
  if (kind == Kind::near_degenerate) return {sized(random, -1074, -1)};
  return {number(kind, random)};
}
Input ratio(Kind kind, Random& random) {
  double x = number(kind, random), y = number(kind, random);
  if (kind == Kind::random) x = sized(random, -1074, 1023), y = sized(random, -1074, 1023);
  if (kind == Kind::grazing) y = x * random.uniform(0.01, 100);
  // The quotient is subnormal
  if (kind == Kind::near_degenerate) {
    x = sized(random, 0, 1023);
    y = std::ldexp(sized(random, 0, 0), std::max(-1074, std::ilogb(x) - 1060));
  }
  return {y, x};
}
Input exponent(Kind kind, Random& random) {
  if (kind == Kind::random) return {random.uniform(-745, 709.7)};
  if (kind == Kind::near_degenerate) return {random.uniform(-746, -708)};
  if (kind == Kind::grazing) return {std::nextafter(std::round(random.uniform(-1000, 1000)) * half_log_2, 0)};
  if (kind == Kind::tiny) return {sized(random, -60, 2)};
  return {number(kind, random)};
}
Input of_logarithm(Kind kind, Random& random) {
  if (kind == Kind::random) return {std::abs(sized(random, -1074, 1023))};
  if (kind == Kind::near_degenerate) return {random.uniform(0.5, 2)};
  if (kind == Kind::grazing) return {1 + sized(random, -53, -1)};
  return {kind == Kind::refused ? number(kind, random) : std::abs(number(kind, random))};
}
/// An exponent that keeps the power in range, now and then a small whole one.
Input power(Kind kind, Random& random) {
  if (kind == Kind::extremes || kind == Kind::refused) return {number(kind, random), number(kind, random)};
  double x = of_logarithm(kind, random)[0];
  double y = random.uniform(-745, kind == Kind::denormal ? -708 : 709) / std::log(x);
  if (kind == Kind::ties) y = std::round(random.uniform(-20, 20));
  if (!std::isfinite(y) || y == 0) y = 0.5;
  if (std::round(y) == y && random.unit() < 0.5) x = -x;
  return {x, y};
}
Input floats(Kind kind, Random& random) {
  if (kind == Kind::random) return {sized(random, -126, 126), sized(random, -126, 126)};
  if (kind == Kind::near_degenerate) return {random.uniform(-1, 1), random.uniform(-1, 1)};
  if (kind == Kind::grazing) return {random.uniform(-103, 88.7), random.uniform(-80, 80)};
  const double x = std::abs(sized(random, -126, 126));
  return {x, random.uniform(-80, 80) / std::log(x)};
}

bool is_subnormal(double x) { return x != 0 && std::abs(x) < std::numeric_limits<double>::min(); }

/// A function to 0.501 ulp, with what C says of special values.
Property function(std::string name, std::string states, std::size_t numbers, Generator generate,
                  std::function<double(const Input&)> error, std::vector<Trap> traps = {},
                  std::vector<Share> shares = {}) {
  return {.name = std::move(name),
          .states = std::move(states),
          .unit = "ulp",
          .bound = 0.501,
          .numbers = numbers,
          .generate = std::move(generate),
          .error = std::move(error),
          .traps = std::move(traps),
          .shares = std::move(shares)};
}

}  // namespace

Domain elementary() {
  const std::string nearly = "within 0.501 ulp, subnormal results too; special values as in C";
  const auto of = [&](const char* name, const Function& f, Generator inputs, std::vector<Share> shares = {}) {
    return function(
        name, nearly, 1, std::move(inputs), [f](const Input& i) { return error_of(f, i[0]); }, {},
        std::move(shares));
  };
  // The double that lies nearest to a multiple of pi/2, relative to its size, 2^-61: Muller, "Elementary
  // functions", 2006, table 9.2
  const std::vector<Trap> angles{{"the worst cancellation", {0x1.6ac5b262ca1ffp+849}},
                                 {"the worst cancellation, below 0", {-0x1.6ac5b262ca1ffp+849}},
                                 {"a full reduction", {1e22}},
                                 {"the largest angle", {0x1.fffffffffffffp+1023}}};
  const auto sin_cos_tan = [](const Input& i) {
    return std::max(
        {error_of(sine, i[0]), error_of(cosine, i[0]), error_of(tangent, i[0]), odd_and_even(i[0])});
  };
  return {
      "elementary",
      {function("sin_cos_tan", nearly + "; odd and even to the last bit", 1, at_every_scale(angle),
                sin_cos_tan, angles,
                {{"beyond 2^60", 0.08, [](const Input& i) { return std::abs(i[0]) > 0x1p60; }}}),
       function("degrees",
                "sine and cosine of degrees, and radians, within 0.501 ulp; multiples of 90 exactly", 1,
                degrees, [](const Input& i) { return degrees_error(i[0]); }),
       of("asin", arc_sine, of_arc),
       of("acos", arc_cosine, of_arc),
       of("atan", arc_tangent, at_every_scale(of_arc)),
       function("atan2", nearly, 2, ratio, [](const Input& i) { return atan2_error(i[0], i[1]); }, {},
                {{"the result is subnormal", 0.01,
                  [](const Input& i) { return is_subnormal(std::atan2(i[0], i[1])); }},
                 {"backwards", 0.3, [](const Input& i) { return i[1] < 0; }}}),
       of("exp", exponential, exponent,
          {{"the result is subnormal", 0.1, [](const Input& i) { return is_subnormal(std::exp(i[0])); }}}),
       of("log", logarithm, of_logarithm),
       function("pow", nearly, 2, power, [](const Input& i) { return pow_error(i[0], i[1]); }, {},
                {{"the result is subnormal", 0.07,
                  [](const Input& i) { return is_subnormal(std::pow(i[0], i[1])); }},
                 {"of a negative number", 0.025, [](const Input& i) { return i[0] < 0; }}}),
       {.name = "floats",
        .states = "the same of floats, within 0.5001 ulp of float",
        .unit = "ulp of float",
        .bound = 0.5001,
        .numbers = 2,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge},
        .generate = floats,
        .error = float_error,
        .cases = 2'000}}};  // of ten functions each
}

}  // namespace gradus::stress
