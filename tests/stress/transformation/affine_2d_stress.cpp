// The promises of transformations in the plane.

#include "transformation/affine_2d/affine_2d.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/contract.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using Rational = boost::multiprecision::cpp_rational;

// --- A point under a matrix: xx, xy, x0, yx, yy, y0, then the point -------------------------------------

Input matrix_and_point(Kind kind, Random& random) {
  Input input;
  for (int i = 0; i < 8; ++i) input.push_back(number(kind, random));
  if (kind == Kind::near_degenerate) {
    // Both rows nearly undo themselves
    input[1] = nudged(-input[0], random);
    input[7] = nudged(input[6], random);
    input[2] = input[5] = 0;
  } else if (kind == Kind::huge || kind == Kind::extremes) {
    for (std::size_t i = 6; i < 8; ++i) input[i] = random.uniform(-1, 1);
  }
  return input;
}

/// The error of a sum in units of the last place of its largest possible value; 0 where that overflows.
double error_of_row(double found, const double* row, double x, double y) {
  const Rational first = Rational(row[0]) * Rational(x), second = Rational(row[1]) * Rational(y);
  const Rational size = abs(first) + abs(second) + abs(Rational(row[2]));
  if (size > Rational(std::numeric_limits<double>::max())) return 0;
  if (!std::isfinite(found)) return wrong;
  const Rational off = abs(Rational(first + second + Rational(row[2]) - Rational(found)));
  if (off == 0) return 0;
  const double rounded = static_cast<double>(size);
  const int exponent = rounded < 0x1p-1022 ? -1074 : std::ilogb(rounded) - 52;
  return static_cast<double>(Rational(off / Rational(std::ldexp(1.0, exponent))));
}

double transform_error(const Input& i) {
  const glm::dmat3 m{i[0], i[3], 0, i[1], i[4], 0, i[2], i[5], 1};
  const glm::dvec2 p = affine_2d::transform(m, glm::dvec2{i[6], i[7]});
  return std::max(error_of_row(p.x, &i[0], i[6], i[7]), error_of_row(p.y, &i[3], i[6], i[7]));
}

// --- The mirror through two points ----------------------------------------------------------------------

Input two_points(Kind kind, Random& random) {
  Input input;
  for (int i = 0; i < 4; ++i) input.push_back(number(kind, random));
  if (kind == Kind::near_degenerate) {
    input[2] = nudged(input[0], random);
    input[3] = nudged(input[1], random);
  } else if (kind == Kind::grazing) {
    input[static_cast<std::size_t>(random.uniform_int(2, 3))] *= 1e-200;
    input[0] = input[1] = 0;
  }
  return input;
}

double mirror_error(const Input& i) {
  const glm::dvec2 a{i[0], i[1]}, b{i[2], i[3]}, d = b - a;
  const bool taken = all_finite({a.x, a.y, d.x, d.y}) && a != b;
  try {
    const auto mirror = affine_2d::reflection_in_line(a, b);
    if (!taken) return wrong;
    const Rational x(d.x), y(d.y), square = x * x + y * y;
    const Rational cos = (x * x - y * y) / square, sin = 2 * x * y / square;
    const Rational entries[] = {cos, sin, sin, -cos};
    double worst = 0;
    for (int k = 0; k < 4; ++k) {
      const double found = mirror.linear[k / 2][k % 2];
      if (!std::isfinite(found)) return wrong;
      worst = std::max(worst, std::abs(static_cast<double>(Rational(entries[k] - Rational(found)))) * 0x1p52);
    }
    return worst;
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
}

}  // namespace

Domain affine_2d() {
  return {"affine_2d",
          {{.name = "transform",
            .states = "within 3 ulp of |xx x| + |xy y| + |x0|, likewise in y",
            .unit = "ulp",
            .bound = 3,
            .numbers = 8,
            .kinds = {Kind::random, Kind::near_degenerate, Kind::huge, Kind::tiny, Kind::ties, Kind::denormal,
                      Kind::extremes},
            .generate = matrix_and_point,
            .error = transform_error,
            .traps = {{"the sum cancels", {1, -1, 0x1p-53, 1, 1, 0, 1, std::nextafter(1, 2)}},
                      {"products underflow", {1e-200, 0, 0, 0, 1e-200, 0, 1e-200, 1e-200}}}},
           {.name = "reflection_in_line",
            .states = "each entry within 4 ulp of 1",
            .unit = "ulp",
            .bound = 4,
            .numbers = 4,
            .generate = two_points,
            .error = mirror_error,
            .traps = {{"squares underflow", {0, 0, 1e-200, 2e-200}},
                      {"squares overflow", {0, 0, 1e200, -1e200}},
                      {"the smallest step", {1, 1, 1, std::nextafter(1, 2)}},
                      {"one point", {3, 4, 3, 4}},
                      {"too far apart", {-1.7e308, 0, 1.7e308, 1}},
                      {"no number", {0, 0, std::nan(""), 1}}}}}};
}

}  // namespace gradus::stress
