// The promises of arithmetic without rounding: signs, sums, products and quotients, against whole numbers of
// any length.

#include "core/arithmetic/exact.hpp"

#include <algorithm>
#include <array>

#include "core/arithmetic/exact_polynomial.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/arithmetic/two_doubles.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "stress/core/digits.hpp"
#include "stress/core/exact_property.hpp"
#include "stress/core/integers.hpp"

namespace gradus::stress {
namespace {

// --- Orientation ---

/// On which side of a line three points lie near which plain arithmetic scatters wrong signs: Kettner,
/// Mehlhorn, Pion, Schirra, Yap, "Classroom examples of robustness problems in geometric computations", 2008,
/// figure 2.
Input of_kettner(Random& random) {
  const Input starts[]{{.5, .5, 12, 12, 24, 24},
                       {.50000000000002531, .5000000000000171, 17.300000000000001, 17.300000000000001,
                        24.00000000000005, 24.0000000000000517765},
                       {.5, .5, 8.8000000000000007, 8.8000000000000007, 12.1, 12.1}};
  Input input = starts[random.uniform_int(0, 2)];
  for (const std::size_t k : {0U, 1U}) input[k] += static_cast<double>(random.uniform_int(0, 255)) * 0x1p-53;
  return input;
}

/// Points in a plane or in space, the last one on the line or the plane of the others, or a little beside.
template <std::size_t N>
Input points(Kind kind, Random& random) {
  Input input = any_numbers(N * (N + 1), kind, random);
  if (N == 2 && kind == Kind::grazing && random.unit() < 0.5) return of_kettner(random);
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
  } else if (kind == Kind::tiny && random.unit() < 0.2) {
    // Products of a few units in the last place of the subnormals
    for (double& x : input) x = static_cast<double>(random.uniform_int(-12, 12)) * 0x1p-539;
  } else if (kind == Kind::refused) {
    input[static_cast<std::size_t>(random.uniform_int(0, static_cast<int>(input.size()) - 1))] = wrong;
  }
  return input;
}

/// The determinant of the other points' places seen from the first; exact.
int exact_sign(const Input& i, std::size_t axes) {
  const auto minus_first = [&](std::size_t p, std::size_t k) {
    return Integer(fixed(i[axes * p + k]) - fixed(i[k]));
  };
  const auto minor = [&](std::size_t k, std::size_t l) {
    return Integer(minus_first(1, k) * minus_first(2, l) - minus_first(1, l) * minus_first(2, k));
  };
  if (axes == 2) return minor(0, 1).sign();
  return Integer(minor(1, 2) * minus_first(3, 0) + minor(2, 0) * minus_first(3, 1) +
                 minor(0, 1) * minus_first(3, 2))
      .sign();
}

dvec2 in_plane(const Input& i, std::size_t p) { return {i[2 * p], i[2 * p + 1]}; }
dvec3 in_space(const Input& i, std::size_t p) { return {i[3 * p], i[3 * p + 1], i[3 * p + 2]}; }

double orient2d_error(const Input& i) {
  const dvec2 a = in_plane(i, 0), b = in_plane(i, 1), c = in_plane(i, 2);
  const auto sure = orient2d_filtered(a, b, c);
  try {
    const int found = orient2d(a, b, c);
    if (!all_finite(i)) return wrong;
    const bool turns = orient2d(b, c, a) == found && orient2d(b, a, c) == -found;
    const bool same = orient2d_exact(a, b, c) == found && (!sure || *sure == found);
    return turns && same && found == exact_sign(i, 2) ? 0 : wrong;
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
}
double orient3d_error(const Input& i) {
  const dvec3 a = in_space(i, 0), b = in_space(i, 1), c = in_space(i, 2), d = in_space(i, 3);
  const auto sure = orient3d_filtered(a, b, c, d);
  try {
    const int found = orient3d(a, b, c, d);
    if (!all_finite(i)) return wrong;
    const bool same = orient3d_exact(a, b, c, d) == found && (!sure || *sure == found);
    return same && orient3d(b, a, c, d) == -found && found == exact_sign(i, 3) ? 0 : wrong;
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
}

bool misleads_plain_arithmetic(const Input& i) {
  if (!all_finite(i)) return false;
  const dvec2 p = in_plane(i, 1) - in_plane(i, 0), q = in_plane(i, 2) - in_plane(i, 0);
  const double plain = p.x * q.y - p.y * q.x;
  return (plain > 0) - (plain < 0) != orient2d(in_plane(i, 0), in_plane(i, 1), in_plane(i, 2));
}

// --- Sums, products, quotients ---

double product_error(const Input& i) {
  const double size = std::abs(i[0] * i[1]);
  const bool taken = std::max(std::abs(i[0]), std::abs(i[1])) <= 0x1p995 &&
                     (i[0] == 0 || i[1] == 0 || (0x1p-967 <= size && size < 0x1p1022));
  if (!all_finite(i) || !taken) return 0;
  const Rounded found = two_product(i[0], i[1]);
  return times_one(fixed(found.value)) + times_one(fixed(found.error)) == fixed(i[0]) * fixed(i[1]) ? 0
                                                                                                    : wrong;
}

double sum_error(const Input& i) {
  if (!all_finite(i) || !std::isfinite(i[0] + i[1])) return 0;
  const Rounded found = two_sum(i[0], i[1]), difference = two_difference(i[0], -i[1]);
  if (found.value != difference.value || found.error != difference.error) return wrong;
  return fixed(found.value) + fixed(found.error) == fixed(i[0]) + fixed(i[1]) ? 0 : wrong;
}

/// (a + b) (c - d) - a c b, whose parts stay within the range of two_product.
double expansion_error(const Input& i) {
  const auto fits = [](double x) { return x == 0 || (0x1p-80 <= std::abs(x) && std::abs(x) <= 0x1p81); };
  if (!std::ranges::all_of(i, fits)) return 0;
  const auto [a, b, c, d] = std::array{i[0], i[1], i[2], i[3]};
  const auto product = exact_sum(a, b) * exact_difference(c, d);
  const auto value = product - exact_product(a * c, b);
  const Integer exact = (fixed(a) + fixed(b)) * (fixed(c) - fixed(d)), all = exact - fixed(a * c) * fixed(b);
  Integer sum = 0;
  for (std::size_t k = 0; k < value.size(); ++k) {
    if (value[k] == 0 || (k > 0 && std::abs(value[k - 1]) >= std::abs(value[k]))) return wrong;
    sum += times_one(fixed(value[k]));
  }
  const Integer one = fixed(1.0);
  const bool right = sum == all && value.sign() == all.sign() && (product - product).sign() == 0 &&
                     is_nearest(rounded(value), all, times_one(one)) &&
                     is_nearest(rounded(product), exact, times_one(one));
  return right ? 0 : wrong;
}
Input moderate(Kind, Random& random) {
  Input input(4);
  for (double& x : input) x = sized(random, -80, 80);
  return input;
}

/// (a b c - d e f) / (g h - i), the factors nearly equal or not.
constexpr std::size_t quotient_numbers = 9;
Input quotient(Kind kind, Random& random) {
  Input input = any_numbers(quotient_numbers, kind, random);
  if (random.unit() < 0.5) input[2] = input[5] = 1;
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    for (const std::size_t k : {0U, 1U, 2U})
      input[3 + k] = kind == Kind::grazing ? input[k] : nudged(input[k], random);
    if (random.unit() < 0.5) input[8] = nudged(input[6] * input[7], random);
  }
  return input;
}
/// (2m + 1) k / (2 k) lies half way between two doubles, at every scale; a hair more or less does not.
Input tie(Kind kind, Random& random) {
  const bool tiny = kind == Kind::denormal;
  const double m =
      static_cast<double>(random.uniform_int(std::int64_t{1} << 52, (std::int64_t{1} << 53) - 1));
  const double k = static_cast<double>(random.uniform_int(1, std::int64_t{1} << 53));
  const double hair = static_cast<double>(random.uniform_int(-1, 1)) * 0x1p-1000;
  // In the last place of the subnormals fewer digits are a tie still
  const double digits = tiny ? std::floor(m * 0x1p-20) : m, scale = tiny ? 0x1p-1073 : 1;
  return {2 * digits, k, scale, -k, scale, 1, 2, k, hair};
}

struct Quotient {
  Integer above, below;
};
Quotient exact_quotient(const Input& i) {
  const auto at = [&](std::size_t k) { return fixed(i[k]); };
  return {at(0) * at(1) * at(2) - at(3) * at(4) * at(5), at(6) * at(7) - times_one(at(8))};
}

/// Divided by sums of products, and by rationals.
double quotient_error(const Input& i) {
  SumOfProducts<3> above;
  SumOfProducts<2> below;
  try {
    above.add(i[0], i[1], i[2]);
    above.subtract(i[3], i[4], i[5]);
    below.add(i[6], i[7]);
    below.subtract(i[8]);
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
  if (!all_finite(i)) return wrong;
  const auto [n, d] = exact_quotient(i);
  if (above.sign() != n.sign() || below.sign() != d.sign()) return wrong;
  const ExactScope scope;
  const Exact top = Exact(i[0]) * i[1] * i[2] - Exact(i[3]) * i[4] * i[5], bottom = Exact(i[6]) * i[7] - i[8];
  if (sign(top) != n.sign() || sign(bottom) != d.sign()) return wrong;
  try {
    const double found = rounded_quotient(above, below);
    if (d == 0 || !is_nearest(found, n, times_one(d)) || found != to_double(top / bottom)) return wrong;
  } catch (const ContractViolation&) {
    return d == 0 ? 0 : wrong;
  }
  return is_nearest(rounded(below), d, times_one(fixed(1.0))) ? 0 : wrong;
}

/// Between which whole numbers a rational lies: those of (a b c - d e f) / (g h - i).
double floor_error(const Input& i) {
  if (!all_finite(i)) return 0;
  const auto [n, d] = exact_quotient(i);
  const Integer below = times_one(d);
  if (d == 0 || abs(n) >= abs(below) << 62) return 0;
  const ExactScope scope;
  const Exact x = (Exact(i[0]) * i[1] * i[2] - Exact(i[3]) * i[4] * i[5]) / (Exact(i[6]) * i[7] - i[8]);
  Integer least = n / below;
  if (n % below != 0 && (n < 0) != (below < 0)) --least;
  const Integer most = n % below == 0 ? least : Integer(least + 1);
  return Integer(floor(x)) == least && Integer(ceil(x)) == most ? 0 : wrong;
}

/// a b + c over d e + f, whole numbers of 128 bits, and a over d, of 64.
Input whole_quotient(Kind kind, Random& random) {
  Input input(6);
  for (double& x : input) {
    x = kind == Kind::extremes && random.unit() < 0.3
            ? std::copysign(0x1p62, random.unit() - 0.5)
            : std::trunc(sized(random, -1, kind == Kind::ties ? 3 : 61));
  }
  return input;
}
double whole_error(const Input& i) {
  if (!std::ranges::all_of(i, [](double x) { return std::abs(x) <= 0x1p62 && x == std::trunc(x); })) return 0;
  std::array<std::int64_t, 6> k{};
  std::ranges::transform(i, k.begin(), [](double x) { return static_cast<std::int64_t>(x); });
  const auto error = [](const Integer& n, const Integer& d, auto divide) {
    try {
      const double found = divide();
      return d != 0 && is_nearest(found, n, d) ? 0 : wrong;
    } catch (const ContractViolation&) {
      return d == 0 ? 0 : wrong;
    }
  };
  const Int128 n = Int128{k[0]} * k[1] + k[2], d = Int128{k[3]} * k[4] + k[5];
  return std::max(
      error(Integer(k[0]) * k[1] + k[2], Integer(k[3]) * k[4] + k[5], [&] { return rounded_quotient(n, d); }),
      error(k[0], k[3], [&] { return rounded_quotient(k[0], k[3]); }));
}

// --- Forms ---

/// (a b - c d) e - f g h.
Input polynomial(Kind kind, Random& random) {
  Input input = any_numbers(8, kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    input[2] = input[0], input[3] = kind == Kind::grazing ? input[1] : nudged(input[1], random);
    if (random.unit() < 0.5) input[5] = 0;
  }
  return input;
}
Form<3> polynomial_of(const Input& i) {
  const auto f = [&](std::size_t k) { return Form<1>(i[k]); };
  return (f(0) * f(1) - f(2) * f(3)) * f(4) - f(5) * f(6) * f(7);
}
double polynomial_error(const Input& i) {
  if (!all_finite(i)) return 0;
  const auto x = [&](std::size_t k) { return fixed(i[k]); };
  const Form<3> form = polynomial_of(i);
  Integer exact = (x(0) * x(1) - x(2) * x(3)) * x(4) - x(5) * x(6) * x(7);
  if (form.sign() != exact.sign()) return wrong;
  const auto [digits, exponent] = form.leading();
  if (exact != 0 && !(0.5 <= std::abs(digits.value) && std::abs(digits.value) <= 1)) return wrong;
  // The first digits, to 2^-104
  Integer shown = fixed(digits.value) + fixed(digits.error);
  const int shift = exponent + 2 * 1074;
  shift >= 0 ? shown <<= shift : exact <<= -shift;
  return (abs(shown - exact) << 104) <= abs(exact) ? 0 : wrong;
}

/// a c + b sqrt(c d) + e sqrt(f g): a, b, c, d, e, f, g.
Input roots(Kind kind, Random& random) {
  Input input = any_numbers(7, kind, random);
  for (const std::size_t k : {2U, 3U, 5U, 6U}) input[k] = std::abs(input[k]);
  if (kind == Kind::ties) input[3] = input[2], input[6] = input[5];
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    const int way = static_cast<int>(random.uniform_int(0, 2));
    // One root that cancels; two that do; the nearest double to what would cancel
    if (way == 0) input[0] = -input[1], input[3] = input[2], input[4] = 0;
    if (way == 1) input[0] = 0, input[4] = -input[1] / 2, input[5] = 4 * input[2], input[6] = input[3];
    if (way == 2) {
      input[0] =
          -(input[1] * std::sqrt(input[2] * input[3]) + input[4] * std::sqrt(input[5] * input[6])) / input[2];
    }
    if (kind == Kind::near_degenerate) input[1] = nudged(input[1], random);
  }
  return input;
}
void make_radicands(Input& i) {
  for (const std::size_t k : {2U, 3U, 5U, 6U}) i[k] = std::abs(i[k]);
}

/// The sign of a + b sqrt(c), by squares.
int sign_of_root(const Integer& a, const Integer& b, const Integer& c) {
  const int left = a.sign(), right = c == 0 ? 0 : b.sign();
  if (right == 0 || left == right) return left;
  return left == 0 ? right : left * Integer(a * a - b * b * c).sign();
}
/// The sign of a + b sqrt(c) + d sqrt(e): |a| against the sum of the roots, whose square is one root more.
int sign_of_roots(const Integer& a, const Integer& b, const Integer& c, const Integer& d, const Integer& e) {
  const Integer first = b * b * c, second = d * d * e;
  const int signs[]{c == 0 ? 0 : b.sign(), e == 0 ? 0 : d.sign()};
  const int roots = signs[0] == signs[1] ? signs[0]
                    : signs[0] == 0      ? signs[1]
                    : signs[1] == 0      ? signs[0]
                                         : signs[0] * Integer(first - second).sign();
  if (a == 0 || roots == 0 || roots == a.sign()) return a == 0 ? roots : a.sign();
  return a.sign() * sign_of_root(a * a - first - second, -2 * b * d, c * e);
}

bool has_radicands(const Input& i) { return all_finite(i) && std::min({i[2], i[3], i[5], i[6]}) >= 0; }
int exact_roots(const Input& i) {
  const auto x = [&](std::size_t k) { return fixed(i[k]); };
  return sign_of_roots(x(0) * x(2), x(1), x(2) * x(3), x(4), x(5) * x(6));
}
double form_error(const Input& i) {
  if (!has_radicands(i)) return 0;
  const auto f = [&](std::size_t k) { return Form<1>(i[k]); };
  const auto x = [&](std::size_t k) { return fixed(i[k]); };
  if (sign_with_root(f(0) * f(2), f(1), f(2) * f(3)) != sign_of_root(x(0) * x(2), x(1), x(2) * x(3)))
    return wrong;
  return sign_with_roots(f(0) * f(2), f(1), f(2) * f(3), f(4), f(5) * f(6)) == exact_roots(i) ? 0 : wrong;
}
/// Whether the terms cancel in all digits of a double.
bool cancels(const Input& i) {
  const double a = i[0] * i[2], b = i[1] * std::sqrt(i[2] * i[3]), e = i[4] * std::sqrt(i[5] * i[6]);
  return std::abs(a + b + e) <= 0x1p-48 * (std::abs(a) + std::abs(b) + std::abs(e));
}

// --- Pairs of doubles ---

/// Two numbers, each with what to add, as a part of 2^-54 of it.
Input pairs(Kind, Random& random) {
  return {sized(random, -60, 60), random.uniform(-1, 1), sized(random, -60, 60), random.uniform(-1, 1)};
}
/// The largest share of an operation's bound that is used up.
double pair_error(const Input& i) {
  for (const std::size_t k : {0U, 2U}) {
    const double size = std::abs(i[k]);
    if (!(0x1p-60 <= size && size <= 0x1p61 && std::abs(i[k + 1]) <= 1)) return 0;
  }
  const Rounded a = fast_two_sum(i[0], i[0] * i[1] * 0x1p-54), b = fast_two_sum(i[2], i[2] * i[3] * 0x1p-54);
  const auto value = [](Rounded x) { return Digits(Digits(x.value) + Digits(x.error)); };
  const Digits x = value(a), y = value(b);
  const auto used = [&](Rounded found, const Digits& exact, const Digits& size, int bits) {
    return static_cast<double>(ldexp(Digits(abs(value(found) - exact) / size), bits));
  };
  const Digits size(abs(x)), sizes(abs(x) + abs(y)), product(x * y), ratio(x / y), root(sqrt(size));
  return std::max({used(sum_of_pairs(a, b), Digits(x + y), sizes, 102),
                   used(product_of_pairs(a, b), product, Digits(abs(product)), 101),
                   used(quotient_of_pairs(a, b), ratio, Digits(abs(ratio)), 99),
                   used(root_of_pair(a.value < 0 ? negated(a) : a), root, root, 99)});
}

}  // namespace

Domain exact() {
  const auto numbers = [](std::size_t count) {
    return [count](Kind kind, Random& random) { return any_numbers(count, kind, random); };
  };
  const auto in_doubt_2d = [](const Input& i) {
    return all_finite(i) && !orient2d_filtered(in_plane(i, 0), in_plane(i, 1), in_plane(i, 2));
  };
  const auto in_doubt_3d = [](const Input& i) {
    return all_finite(i) &&
           !orient3d_filtered(in_space(i, 0), in_space(i, 1), in_space(i, 2), in_space(i, 3));
  };
  Property plane =
      exact_property("orient2d", "the side of a line, exactly, however its points are turned", 6,
                     at_every_scale(points<2>), orient2d_error,
                     {{"needs exact arithmetic", 0.15, in_doubt_2d},
                      {"misleads plain arithmetic", 0.05, misleads_plain_arithmetic}},
                     {{"an area that doubles call 0", {.5 + 0x1p-52, .5 + 0x1p-53, 12, 12, 24, 24}},
                      {"the largest and the smallest",
                       {0x1.fffffffffffffp1023, 0, 0, 0x1p-1074, -0x1.fffffffffffffp1023, 0}}});
  Property space = exact_property("orient3d", "the side of a plane, exactly", 12, at_every_scale(points<3>),
                                  orient3d_error, {{"needs exact arithmetic", 0.15, in_doubt_3d}},
                                  {{"a product underflows and a large factor follows",
                                    {0, 0, 0, 1e-170, 0, 0, 0, 1e-170, 0, 0, 0, 1e300}}});
  Property quotients = exact_property("rounded_quotient",
                                      "(a b c - d e f) / (g h - i) to the nearest double, by rationals too",
                                      quotient_numbers, at_every_scale(quotient), quotient_error);
  for (Property* each : {&plane, &space, &quotients}) each->kinds.push_back(Kind::refused);
  plane.cases = 30'000;
  space.cases = 12'000;
  Property ties = exact_property("ties", "midway between two doubles to the even one, a hair beside it not",
                                 quotient_numbers, tie, quotient_error);
  ties.kinds = {Kind::ties, Kind::denormal};
  return {
      "exact",
      {plane,
       space,
       quotients,
       ties,
       exact_property("floor_and_ceil", "the whole numbers round a rational", quotient_numbers,
                      at_every_scale(quotient), floor_error,
                      {{"is in the range of 64 bits", 0.3,
                        [](const Input& i) {
                          const auto [n, d] = exact_quotient(i);
                          return d != 0 && abs(n) < abs(times_one(d)) << 62;
                        }}}),
       exact_property("whole_quotient", "of integers of 64 and of 128 bits the nearest double", 6,
                      whole_quotient, whole_error),
       exact_property("two_product", "a product and its rounding error, exactly", 2,
                      at_every_scale(numbers(2)), product_error),
       exact_property("two_sum", "a sum and its rounding error, exactly", 2, at_every_scale(numbers(2)),
                      sum_error),
       exact_property("expansions", "sums and products of parts that grow, none of them 0, exactly", 4,
                      moderate, expansion_error),
       exact_property("polynomials", "the sign of a form exactly, its first digits to 2^-104", 8,
                      at_every_scale(polynomial), polynomial_error,
                      {{"is 0", 0.05, [](const Input& i) { return polynomial_of(i).sign() == 0; }}}),
       exact_property("form_signs", "the signs of a + b sqrt(c), and of a + b sqrt(c) + d sqrt(e), exactly",
                      7, at_every_scale(roots, {}, make_radicands), form_error,
                      {{"is 0", 0.05, [](const Input& i) { return exact_roots(i) == 0; }},
                       {"cancels in doubles", 0.1, cancels}},
                      {{"sqrt(2)^2 - 2", {-1, 1, 2, 2, 0, 0, 0}},
                       {"sqrt(2) + sqrt(8) - sqrt(18)", {0, 1, 2, 1, 2, 2, 1}}}),
       {.name = "pairs",
        .states =
            "sums within 2^-102 of their terms, products within 2^-101, quotients and roots within 2^-99",
        .unit = "bounds",
        .bound = 1,
        .numbers = 4,
        .kinds = {Kind::random},
        .generate = pairs,
        .error = pair_error}}};
}

}  // namespace gradus::stress
