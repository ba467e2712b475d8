// The promises of what all topics stand on: lengths, turns, cuts along the axes, signs and quotients.

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/axis_cut.hpp"
#include "core/contract.hpp"
#include "core/exact.hpp"
#include "core/form.hpp"
#include "core/geometry.hpp"
#include "core/turn.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"
#include "support/clip_oracle.hpp"

namespace gradus::stress {
namespace {

using test::Rational;
/// Digits for angles of 1e308, too.
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<1400, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

const std::vector<Kind> all_but_refused{
    Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny,
    Kind::ties,   Kind::denormal,        Kind::extremes};

double ulps(double found, const Wide& exact) {
  if (!std::isfinite(found)) return wrong;
  const double size =
      std::min(std::abs(static_cast<double>(exact)), std::nextafter(std::numeric_limits<double>::max(), 0.0));
  return static_cast<double>(Wide(abs(Wide(found) - exact) / (std::nextafter(size, wrong) - size)));
}
int sign_of(const Rational& x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

Input any_numbers(std::size_t count, Kind kind, Random& random) {
  Input input(count);
  for (double& x : input) x = number(kind, random);
  return input;
}

// --- Lengths and directions -----------------------------------------------------------------------------

Input vector(Kind kind, Random& random) {
  Input input = any_numbers(3, kind, random);
  // Nearly along an axis
  if (kind == Kind::near_degenerate) input[static_cast<std::size_t>(random.uniform_int(0, 2))] *= 0x1p-600;
  if (kind == Kind::grazing) input[0] = nudged(input[1], random);
  return input;
}

double length_error(const Input& i) {
  const dvec3 v{i[0], i[1], i[2]};
  const Wide x(v.x), y(v.y), z(v.z), exact = sqrt(Wide(x * x + y * y + z * z));
  const double found = length_of(v);
  const Directed<double> both = directed(v);
  if (both.direction != unit_vector(v)) return wrong;
  if (exact > Wide(std::numeric_limits<double>::max())) return found > 0x1.ffffffffffffep1023 ? 0 : wrong;
  return std::max(ulps(found, exact), ulps(both.length, exact));
}

double direction_error(const Input& i) {
  const dvec3 v{i[0], i[1], i[2]}, found = unit_vector(v);
  if (v == dvec3{0}) return found == v ? 0 : wrong;
  const Wide x(v.x), y(v.y), z(v.z), length = sqrt(Wide(x * x + y * y + z * z));
  return std::max({ulps(found.x, x / length), ulps(found.y, y / length), ulps(found.z, z / length)});
}

// --- Turns ----------------------------------------------------------------------------------------------

Input angle(Kind kind, Random& random) {
  Input input{number(kind, random)};
  if (kind == Kind::near_degenerate) input[0] = sized(random, -40, 0);
  if (kind == Kind::grazing) input[0] = nudged(1.5707963267948966 * std::round(input[0]), random);
  return input;
}

/// Of the sine and the cosine, or of the versine.
double turn_error(const Input& i, bool of_versine) {
  Turn<double> found{};
  try {
    found = turn(i[0]);
  } catch (const ContractViolation&) {
    return std::isfinite(i[0]) ? wrong : 0;
  }
  if (!std::isfinite(i[0])) return wrong;
  const Wide radians(i[0]), half = sin(Wide(radians / 2));
  if (of_versine) return ulps(found.versine, 2 * half * half);
  return std::max(ulps(found.sin, sin(radians)), ulps(found.cos, cos(radians)));
}

// --- Signs ----------------------------------------------------------------------------------------------

/// Points in a plane or in space, the last one on the line or the plane of the others, or a little beside.
template <std::size_t N>
Input points(Kind kind, Random& random) {
  Input input = any_numbers(N * (N + 1), kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    std::array<double, N> shares;
    double rest = 1;
    for (std::size_t p = 1; p < N; ++p) rest -= shares[p] = std::round(random.uniform(-16, 16)) / 8;
    shares[0] = rest;
    for (std::size_t k = 0; k < N; ++k) {
      double sum = 0;
      for (std::size_t p = 0; p < N; ++p) sum += shares[p] * input[N * p + k];
      input[N * N + k] = kind == Kind::grazing ? sum : nudged(sum, random);
    }
  } else if (kind == Kind::refused) {
    input[static_cast<std::size_t>(random.uniform_int(0, static_cast<int>(input.size()) - 1))] = wrong;
  }
  return input;
}

template <class Decide>
double decision_error(const Input& i, int exact, Decide decide) {
  try {
    return decide() == exact && all_finite(i) ? 0 : wrong;
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
}

double orient2d_error(const Input& i) {
  int exact = 0;
  if (all_finite(i)) {
    const auto minus_first = [&](std::size_t k) { return Rational(i[k]) - Rational(i[k % 2]); };
    exact = sign_of(minus_first(2) * minus_first(5) - minus_first(3) * minus_first(4));
  }
  return decision_error(i, exact, [&] { return orient2d(dvec2{i[0], i[1]}, {i[2], i[3]}, {i[4], i[5]}); });
}

double orient3d_error(const Input& i) {
  int exact = 0;
  if (all_finite(i)) {
    const auto minus_first = [&](std::size_t k) { return Rational(Rational(i[k]) - Rational(i[k % 3])); };
    const auto minor = [&](std::size_t k, std::size_t l) {
      return Rational(minus_first(3 + k) * minus_first(6 + l) - minus_first(3 + l) * minus_first(6 + k));
    };
    exact =
        sign_of(minor(1, 2) * minus_first(9) + minor(2, 0) * minus_first(10) + minor(0, 1) * minus_first(11));
  }
  const auto at = [&](std::size_t k) { return dvec3{i[k], i[k + 1], i[k + 2]}; };
  return decision_error(i, exact, [&] { return orient3d(at(0), at(3), at(6), at(9)); });
}

/// a + b sqrt(c d) and a + b sqrt(c d) + e sqrt(f g), all of degree 2: a, b, c, d, e, f, g.
Input roots(Kind kind, Random& random) {
  Input input = any_numbers(7, kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // a = -b c but for the last places, d = c
    input[3] = input[2];
    input[0] = kind == Kind::grazing ? input[1] : nudged(input[1], random);
    input[1] = -input[1] * (kind == Kind::grazing ? 1 : 1 + 0x1p-50);
  }
  for (const std::size_t k : {2U, 3U, 5U, 6U}) input[k] = std::abs(input[k]);
  return input;
}

/// The sign of a + b sqrt(c), by squares.
int sign_of_root(const Rational& a, const Rational& b, const Rational& c) {
  const int left = sign_of(a), right = c == 0 ? 0 : sign_of(b);
  if (right == 0 || left == right) return left;
  return left == 0 ? right : left * sign_of(a * a - b * b * c);
}

double form_error(const Input& i) {
  const Form<1> a(i[0]), b(i[1]), c(i[2]), d(i[3]), e(i[4]), f(i[5]), g(i[6]);
  const Rational x = Rational(i[0]) * Rational(i[2]), y(i[1]), cd = Rational(i[2]) * Rational(i[3]);
  if (sign_with_root(a * c, b, c * d) != sign_of_root(x, y, cd)) return wrong;
  // Two roots of different size: their sum against -a c
  const Rational z(i[4]), fg = Rational(i[5]) * Rational(i[6]);
  const int roots = sign_of_root(0, y, cd) == sign_of_root(0, z, fg)
                        ? sign_of_root(0, y, cd)
                        : (sign_of_root(0, y, cd) == 0   ? sign_of_root(0, z, fg)
                           : sign_of_root(0, z, fg) == 0 ? sign_of_root(0, y, cd)
                                                         : sign_of(y) * sign_of(y * y * cd - z * z * fg));
  int exact = sign_of(x);
  if (exact == 0) {
    exact = roots;
  } else if (roots != 0 && roots != exact) {
    // |a c| against the sum of the roots, whose square is a rational and one root
    exact *= sign_of_root(x * x - y * y * cd - z * z * fg, -2 * y * z, cd * fg);
  }
  return sign_with_roots(a * c, b, c * d, e, f * g) == exact ? 0 : wrong;
}

// --- Cuts -----------------------------------------------------------------------------------------------

/// The ends along the border's axis, along the other, and the border, between the ends.
Input cut(Kind kind, Random& random) {
  Input input = any_numbers(5, kind, random);
  if (kind == Kind::near_degenerate) {
    input[1] = nudged(input[0], random);
    input[3] = nudged(input[2], random);
  }
  if (kind == Kind::grazing) {
    // Through 0, but for the last places
    input[1] = -input[0], input[3] = nudged(-input[2], random), input[4] = 0;
  }
  return input;
}
void put_between(Input& i) { i[4] = std::clamp(i[4], std::min(i[0], i[1]), std::max(i[0], i[1])); }
Input cut_in_order(Kind kind, Random& random) {
  Input input = cut(kind, random);
  put_between(input);
  return input;
}

template <class T>
double cut_error(const Input& i) {
  std::array<T, 5> k;
  for (std::size_t n = 0; n < 5; ++n) k[n] = static_cast<T>(i[n]);
  const auto [a, b, from, to, c] = k;
  for (const T x : k) {
    if (!std::isfinite(x)) return 0;
  }
  if (a == b || c < std::min(a, b) || c > std::max(a, b)) return 0;
  const Rational exact = Rational(from) + (Rational(c) - Rational(a)) * (Rational(to) - Rational(from)) /
                                              (Rational(b) - Rational(a));
  const T found = cut_coordinate(a, b, from, to, c);
  if (found == 0 && std::signbit(found)) return wrong;
  const T back = cut_coordinate(b, a, to, from, c);
  if (back != found) return wrong;
  const T largest = std::numeric_limits<T>::max();
  return (std::abs(found) == largest ? abs(exact) <= Rational(largest) : test::is_nearest(found, exact))
             ? 0
             : wrong;
}

double order_error(const Input& i) {
  if (i[0] == i[1] || i[3] == i[4]) return 0;
  const auto share = [&](std::size_t k) {
    return Rational((Rational(i[k + 2]) - Rational(i[k])) / (Rational(i[k + 1]) - Rational(i[k])));
  };
  const auto order = compare_cuts(i[0], i[1], i[2], i[3], i[4], i[5]);
  return (order < 0 ? -1 : order > 0 ? 1 : 0) == sign_of(share(0) - share(3)) ? 0 : wrong;
}

// --- Products, sums and quotients -----------------------------------------------------------------------

/// (a b + c d) / (e f + g).
Input quotient(Kind kind, Random& random) {
  Input input = any_numbers(7, kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    input[2] = nudged(-input[0], random);
    input[3] = nudged(input[1], random);
  }
  return input;
}

double quotient_error(const Input& i) {
  SumOfProducts<2> numerator, denominator;
  numerator.add(i[0], i[1]);
  numerator.add(i[2], i[3]);
  denominator.add(i[4], i[5]);
  denominator.add(i[6]);
  const Rational above = Rational(i[0]) * Rational(i[1]) + Rational(i[2]) * Rational(i[3]);
  const Rational below = Rational(i[4]) * Rational(i[5]) + Rational(i[6]);
  double found = 0;
  try {
    found = rounded_quotient(numerator, denominator);
  } catch (const ContractViolation&) {
    return below == 0 ? 0 : wrong;
  }
  if (below == 0) return wrong;
  const Rational exact = above / below, largest(std::numeric_limits<double>::max());
  if (abs(exact) >= largest) {
    // From half an ulp beyond the largest on the result is infinite
    const bool beyond = abs(exact) >= largest + Rational(0x1p969) * 2;
    return std::abs(found) == (beyond ? wrong : std::numeric_limits<double>::max()) &&
                   (found > 0) == (exact > 0)
               ? 0
               : wrong;
  }
  return test::is_nearest(found, exact) ? 0 : wrong;
}

double product_error(const Input& i) {
  const Rational exact = Rational(i[0]) * Rational(i[1]);
  const bool taken = std::max(std::abs(i[0]), std::abs(i[1])) <= 0x1p995 &&
                     (exact == 0 || (abs(exact) >= Rational(0x1p-968) && abs(exact) < Rational(0x1p1022)));
  if (!taken) return 0;
  const Rounded found = two_product(i[0], i[1]);
  return Rational(found.value) + Rational(found.error) == exact ? 0 : wrong;
}

double sum_error(const Input& i) {
  const Rational exact = Rational(i[0]) + Rational(i[1]);
  if (abs(exact) > Rational(std::numeric_limits<double>::max())) return 0;
  const Rounded found = two_sum(i[0], i[1]), difference = two_difference(i[0], -i[1]);
  if (found.value != difference.value || found.error != difference.error) return wrong;
  return Rational(found.value) + Rational(found.error) == exact ? 0 : wrong;
}

Property exact_property(std::string name, std::string states, std::size_t numbers, Generator generate,
                        std::function<double(const Input&)> error, std::vector<Trap> traps = {}) {
  return {.name = std::move(name),
          .states = std::move(states),
          .unit = "decisions",
          .bound = 0,
          .numbers = numbers,
          .kinds = all_but_refused,
          .generate = std::move(generate),
          .error = std::move(error),
          .traps = std::move(traps)};
}

}  // namespace

Domain core() {
  const auto numbers = [](std::size_t count) {
    return [count](Kind kind, Random& random) { return any_numbers(count, kind, random); };
  };
  const std::vector<Kind> all(all_kinds.begin(), all_kinds.end());
  Property plane =
      exact_property("orient2d", "the side of a line, exactly", 6, at_every_scale(points<2>), orient2d_error);
  Property space = exact_property("orient3d", "the side of a plane, exactly", 12, at_every_scale(points<3>),
                                  orient3d_error,
                                  {{"a product underflows and a large factor follows",
                                    {0, 0, 0, 1e-170, 0, 0, 0, 1e-170, 0, 0, 0, 1e300}}});
  plane.kinds = space.kinds = all;
  return {
      "core",
      {{.name = "length_of",
        .states = "within 2 ulp, also where squares overflow or vanish",
        .unit = "ulp",
        .bound = 2,
        .numbers = 3,
        .kinds = all_but_refused,
        .generate = at_every_scale(vector),
        .error = length_error,
        .traps = {{"squares underflow", {1e-200, 1e-200, 0}}, {"squares overflow", {1e200, -1e200, 0}}}},
       {.name = "unit_vector",
        .states = "each component within 4 ulp",
        .unit = "ulp",
        .bound = 4,
        .numbers = 3,
        .kinds = all_but_refused,
        .generate = at_every_scale(vector),
        .error = direction_error,
        .traps = {{"the smallest vector", {0, 0x1p-1074, 0}}, {"no vector", {0, 0, 0}}}},
       {.name = "turn",
        .states = "sine and cosine within 0.501 ulp, for every angle",
        .unit = "ulp",
        .bound = 0.501,
        .numbers = 1,
        .generate = at_every_scale(angle),
        .error = [](const Input& i) { return turn_error(i, false); }},
       {.name = "versine",
        .states = "1 - cosine within 3 ulp, for every angle",
        .unit = "ulp",
        .bound = 3,
        .numbers = 1,
        .generate = at_every_scale(angle),
        .error = [](const Input& i) { return turn_error(i, true); },
        .traps = {{"1 - cos is 0", {1e-9}}, {"underflows", {1e-170}}, {"a whole turn", {6.283185307179586}}}},
       std::move(plane),
       std::move(space),
       exact_property("form_signs", "the signs of a + b sqrt(c), and of a + b sqrt(c) + d sqrt(e), exactly",
                      7,
                      at_every_scale(roots, {},
                                     [](Input& i) {
                                       for (const std::size_t k : {2U, 3U, 5U, 6U}) i[k] = std::abs(i[k]);
                                     }),
                      form_error,
                      {{"sqrt(2)^2 - 2", {-1, 1, 2, 2, 0, 0, 0}},
                       {"sqrt(2) + sqrt(8) - sqrt(18)", {0, 1, 2, 1, 2, 2, 1}}}),
       exact_property("cut_coordinate", "the nearest double, in both directions; a zero is +0", 5,
                      at_every_scale(cut_in_order, {}, put_between), cut_error<double>),
       exact_property("cut_coordinate_float", "the nearest float, in both directions; a zero is +0", 5,
                      [](Kind kind, Random& random) {
                        Input input = cut_in_order(kind, random);
                        // Down to where floats underflow, up to where they end
                        const auto exponent = static_cast<int>(random.uniform_int(-155, 122));
                        for (double& x : input)
                          x = static_cast<double>(
                              static_cast<float>(std::ldexp(x, random.unit() < 0.7 ? exponent : 0)));
                        put_between(input);
                        return input;
                      },
                      cut_error<float>, {{"underflows to -0", {0, 4, -0x1p-149, 0, 3}}}),
       exact_property("compare_cuts", "which of two borders a segment comes to first, exactly", 6,
                      at_every_scale(numbers(6)), order_error),
       exact_property("rounded_quotient", "(a b + c d) / (e f + g) to the nearest double", 7,
                      at_every_scale(quotient), quotient_error),
       exact_property("two_product", "a product and its rounding error, exactly", 2,
                      at_every_scale(numbers(2)), product_error),
       exact_property("two_sum", "a sum and its rounding error, exactly", 2, at_every_scale(numbers(2)),
                      sum_error)}};
}

}  // namespace gradus::stress
