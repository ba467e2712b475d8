// The promises of parallel projections: onto a plane z = d, and onto any.

#include "projection/parallel/parallel.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <numbers>

#include "core/contract.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Vec3 = glm::dvec3;

const Rational rounding_unit(0x1p-53);

/// Whether a product or a quotient is 0, or a normal number of double.
bool fits(const Rational& x) {
  return x == 0 || (Rational(0x1p-1022) <= abs(x) && abs(x) <= Rational(0x1p1022));
}

double in_units(const Rational& error, const Rational& bound) {
  if (error == 0) return 0;
  return bound == 0 ? wrong : static_cast<double>(Rational(error / bound));
}

// --- Oblique: d, slant, point ---------------------------------------------------------------------------

Input oblique_input(Kind kind, Random& random) {
  Input input;
  for (int i = 0; i < 6; ++i) input.push_back(number(kind, random));
  if (kind == Kind::near_degenerate) input[5] = nudged(input[0], random);  // beside the plane
  if (kind == Kind::grazing) input[5] = input[0];
  if (kind == Kind::tiny) input[1] = input[2] = random.uniform(-2, 2);
  return input;
}

double oblique_error(const Input& i) {
  const double d = i[0];
  for (const double slant : {i[1], i[2]}) {
    const Rational t = Rational(d) - Rational(i[5]), largest(std::numeric_limits<double>::max());
    if (abs(t) > largest || abs(t * Rational(slant)) > largest / 4) return 0;  // beyond the domain
  }
  if (std::max(std::abs(i[3]), std::abs(i[4])) > 0x1p1022) return 0;
  const Vec3 image = parallel::oblique(d, {i[1], i[2]}, Vec3{i[3], i[4], i[5]});
  if (image.z != d) return wrong;
  if (i[5] == d && (image.x != i[3] || image.y != i[4])) return wrong;
  const Rational t = Rational(d) - Rational(i[5]), smallest(0x1p-1074);
  double worst = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational aside = t * Rational(i[1 + k]);
    const double place = image[static_cast<int>(k)];
    const Rational bound = rounding_unit * (abs(Rational(place)) + 2 * abs(aside)) + smallest / 2;
    worst = std::max(worst, in_units(abs(Rational(i[3 + k]) + aside - Rational(place)), bound));
  }
  return worst;
}

// --- Along any direction onto any plane: normal, offset, direction, point -------------------------------

Input along_input(Kind kind, Random& random) {
  Input input;
  for (int i = 0; i < 10; ++i) input.push_back(number(kind, random));
  if (kind == Kind::near_degenerate) {
    // Nearly in the plane: from a right angle to the normal a little aside
    const Vec3 n{input[0], input[1], input[2]};
    const Vec3 across = glm::cross(n, Vec3{input[4], input[5], input[6]});
    const double share = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform_int(-56, -2)));
    for (int i = 0; i < 3; ++i) input[4 + static_cast<std::size_t>(i)] = across[i] + share * n[i];
  } else if (kind == Kind::grazing) {
    input[4] = input[5] = input[6] = 0;
    input[4 + static_cast<std::size_t>(random.uniform_int(0, 2))] = 1;
  }
  return input;
}

double along_error(const Input& i) {
  const parallel::Plane<double> plane{{i[0], i[1], i[2]}, i[3]};
  const Vec3 direction{i[4], i[5], i[6]}, point{i[7], i[8], i[9]};
  Rational q, sum, far = abs(Rational(i[3]));
  Rational ahead(i[3]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational n(i[k]), v(i[4 + k]), p(i[7 + k]);
    q += n * v;
    sum += abs(Rational(n * v));
    far += abs(Rational(n * p));
    ahead -= n * p;
  }
  // Beyond the domain
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational n(i[k]), v(i[4 + k]), p(i[7 + k]);
    if (!fits(n * v) || !fits(n * p) || !fits(sum) || !fits(far)) return 0;
    if (q != 0 && (!fits(ahead / q) || !fits(ahead / q * v) || !fits(p + ahead / q * v))) return 0;
  }
  Vec3 image;
  try {
    image = parallel::along(plane, direction, point);
  } catch (const ContractViolation&) {
    return abs(q) > 32 * rounding_unit * sum ? wrong : 0;
  }
  if (q == 0) return wrong;
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational v(i[4 + k]), p(i[7 + k]);
    const Rational bound = rounding_unit * (10 * abs(v) * far * sum / (q * q) + 2 * abs(p));
    worst = std::max(
        worst, in_units(abs(Rational(p + ahead / q * v - Rational(image[static_cast<int>(k)]))), bound));
  }
  return worst;
}

// --- The slant of an angle and a foreshortening ----------------------------------------------------------

/// Digits for angles of 1e308, too.
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<1400, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

Input slant_input(Kind kind, Random& random) {
  Input input{number(kind, random), std::abs(number(kind, random))};
  if (kind == Kind::grazing) input = {nudged(std::numbers::pi / 4 * std::round(input[0]), random), 1};
  if (kind == Kind::near_degenerate)
    input[1] = std::ldexp(1.0, static_cast<int>(random.uniform_int(-1074, 1023)));
  if (kind == Kind::ties) input[1] /= 2;
  return input;
}

double slant_error(const Input& i) {
  const bool taken = all_finite(i) && i[1] >= 0;
  parallel::Slant<double> slant{};
  try {
    slant = parallel::slant_of(i[0], i[1]);
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
  if (!taken) return wrong;
  const auto ulps = [](double found, const Wide& exact) {
    if (!std::isfinite(found)) return wrong;
    const double size = std::abs(static_cast<double>(exact));
    const double ulp = std::nextafter(size, wrong) - size;
    return static_cast<double>(Wide(abs(Wide(found) - exact) / ulp));
  };
  const Wide length(i[1]), angle(i[0]);
  return std::max(ulps(slant.a, -(length * cos(angle))), ulps(slant.b, -(length * sin(angle))));
}

// --- The matrix: normal, offset, direction --------------------------------------------------------------

double matrix_error(const Input& i) {
  const parallel::Plane<double> plane{{i[0], i[1], i[2]}, i[3]};
  const Vec3 direction{i[4], i[5], i[6]};
  Rational q, sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational product = Rational(i[k]) * Rational(i[4 + k]);
    if (!fits(product)) return 0;
    q += product;
    sum += abs(product);
  }
  if (!fits(sum)) return 0;
  glm::dmat4 found;
  try {
    found = parallel::matrix_of(plane, direction);
  } catch (const ContractViolation&) {
    return abs(q) > 32 * rounding_unit * sum ? wrong : 0;
  }
  if (q == 0) return wrong;
  double worst = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      const Rational factor(i[static_cast<std::size_t>(column)]), share = Rational(direction[row]) / q;
      const Rational product = share * factor;
      if (!fits(share) || !fits(product)) continue;
      const bool diagonal = column == row;
      const Rational exact = column == 3 ? product : Rational((diagonal ? 1 : 0) - product);
      const Rational bound =
          7 * rounding_unit * sum / abs(q) * abs(product) + (diagonal ? rounding_unit : Rational(0));
      worst = std::max(worst, in_units(abs(exact - Rational(found[column][row])), bound));
    }
  }
  return worst;
}

}  // namespace

Domain parallel() {
  return {"parallel",
          {{.name = "oblique",
            .states = "x and y within u (|x'| + 2 |t a|) and half the smallest number",
            .unit = "bounds",
            .bound = 1 + 0x1p-50,
            .numbers = 6,
            .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties,
                      Kind::denormal, Kind::extremes},
            .generate = at_every_scale(oblique_input),
            .error = oblique_error,
            .traps = {{"in the plane", {0.1, 0.3, 0.7, 0.1, 0.2, 0.1}},
                      {"nearly in the plane", {1, 1, 1, 1, 1, std::nextafter(1, 2)}},
                      {"products underflow", {1e-200, 1e-200, 1e-200, 0, 0, 0}}}},
           {.name = "along",
            .states = "each coordinate within 10 u |v| N S / q^2 + 2 u |p|; parallel projectors are refused",
            .unit = "bounds",
            .bound = 1,
            .numbers = 10,
            .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties,
                      Kind::denormal, Kind::extremes},
            .generate = at_every_scale(along_input),
            .error = along_error,
            .traps = {{"in the plane", {1, -1, 1, -3, 1, 1, 0, 2, 2, 4}},
                      {"in the plane but for a rounding", {0.1, 0.2, 0.3, 1, 3, 0, -1, 1, 2, 3}},
                      {"no direction", {0, 0, 1, 1, 0, 0, 0, 1, 2, 3}},
                      {"no plane", {0, 0, 0, 1, 1, 2, 3, 1, 2, 3}}}},
           {.name = "slant_of",
            .states = "both numbers within 1.51 ulp, for every angle",
            .unit = "ulp",
            .bound = 1.51,
            .numbers = 2,
            .generate = at_every_scale(slant_input),
            .error = slant_error,
            .traps = {{"1.42 ulp", {-0x1.0c6e2dee943eep+1, 0x1.f3a0abfca1e54p+1}},
                      {"an angle of 10^22", {1e22, 0.5}},
                      {"a right angle", {std::numbers::pi / 2, 1}},
                      {"the product underflows", {1, 0x1p-1074}},
                      {"a negative foreshortening", {1, -0.5}},
                      {"an infinite angle", {wrong, 1}}}},
           {.name = "matrix_of",
            .states = "an entry within 7 u S / |q| of its product, and u where it is taken from 1",
            .unit = "bounds",
            .bound = 1,
            .numbers = 7,
            .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties,
                      Kind::denormal, Kind::extremes},
            .generate = at_every_scale([](Kind kind, Random& random) {
              Input input = along_input(kind, random);
              input.resize(7);
              return input;
            }),
            .error = matrix_error,
            .traps = {{"in the plane but for a rounding", {0.1, 0.2, 0.3, 1, 3, 0, -1}},
                      {"no direction", {0, 0, 1, 1, 0, 0, 0}}}}}};
}

}  // namespace gradus::stress
