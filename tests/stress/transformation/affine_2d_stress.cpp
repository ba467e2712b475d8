// The promises of transformations in the plane.

#include "transformation/affine_2d/affine_2d.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/contract.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

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

// --- The way back: xx, xy, x0, yx, yy, y0 ---------------------------------------------------------------

Input matrix(Kind kind, Random& random) {
  Input input(6);
  for (double& x : input) x = number(kind == Kind::refused ? Kind::random : kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // Rows that are nearly, or exactly, multiples of each other
    const double share = kind == Kind::grazing ? std::ldexp(1.0, static_cast<int>(random.uniform_int(-9, 9)))
                                               : random.uniform(-3, 3);
    input[3] = share * input[0];
    input[4] = kind == Kind::grazing ? share * input[1] : nudged(share * input[1], random);
  }
  if (kind == Kind::refused) {
    input[static_cast<std::size_t>(random.uniform_int(0, 5))] = random.unit() < 0.5 ? std::nan("") : wrong;
  }
  return input;
}

/// The largest share of what is promised that is used up.
double inverse_error(const Input& i) {
  const glm::dmat3 m{i[0], i[3], 0, i[1], i[4], 0, i[2], i[5], 1};
  std::optional<glm::dmat3> found;
  try {
    found = affine_2d::inverse(m);
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
  if (!all_finite(i)) return wrong;
  const Rational xx(i[0]), xy(i[1]), x0(i[2]), yx(i[3]), yy(i[4]), y0(i[5]), ulp(0x1p-52);
  const Rational left = xx * yy, right = xy * yx, det = left - right, size = abs(left) + abs(right);
  // Between these rounding may decide whether it flattens
  if (2 * abs(det) <= ulp * size) return found ? wrong : 0;
  const bool surely = abs(det) > 2 * ulp * size;
  struct Entry {
    int column, row;
    Rational exact, terms;
  };
  const Rational largest(std::numeric_limits<double>::max());
  Rational most = 0;
  std::vector<Entry> entries;
  const auto add = [&](int column, int row, const Rational& first, const Rational& second) {
    entries.push_back(
        {column, row, Rational((first + second) / det), Rational((abs(first) + abs(second)) / abs(det))});
    most = std::max(most, Rational(abs(entries.back().exact)));
  };
  add(0, 0, yy, 0), add(1, 0, -xy, 0), add(2, 0, -yy * x0, xy * y0);
  add(0, 1, -yx, 0), add(1, 1, xx, 0), add(2, 1, yx * x0, -xx * y0);
  if (!found) return surely && most < largest * (1 - 8 * size / abs(det) * ulp) ? wrong : 0;
  double worst = 0;
  for (const Entry& e : entries) {
    const double entry = (*found)[e.column][e.row];
    if (!std::isfinite(entry)) return wrong;
    const Rational bound = 4 * ulp * e.terms * size / abs(det) + Rational(0x1p-1074) / 2;
    worst = std::max(worst, static_cast<double>(Rational(abs(e.exact - Rational(entry)) / bound)));
  }
  return worst;
}

// --- The nearest rotation: xx, xy, yx, yy ---------------------------------------------------------------

double rotation_error(const Input& i) {
  const Rational xx(i[0]), xy(i[1]), yx(i[2]), yy(i[3]), det = xx * yy - xy * yx;
  glm::dmat3 found;
  try {
    found = affine_2d::nearest_rotation(glm::dmat3{i[0], i[2], 0, i[1], i[3], 0, 0, 0, 1});
  } catch (const ContractViolation&) {
    return det > 0 ? wrong : 0;
  }
  if (det <= 0) return wrong;
  for (const double x : i) {
    if (std::abs(x) > std::numeric_limits<double>::max() / 2) return 0;
  }
  const double cos = found[0].x, sin = found[0].y;
  if (!std::isfinite(cos) || !std::isfinite(sin) || found[1].x != -sin || found[1].y != cos) return wrong;
  const Rational off = Rational(cos) * Rational(cos) + Rational(sin) * Rational(sin) - 1;
  // It is the mean of the turns the columns say: no turn by a right angle more
  if (Rational(cos) * (xx + yy) + Rational(sin) * (yx - xy) <= 0) return wrong;
  return std::abs(static_cast<double>(off)) * 0x1p52;
}

}  // namespace

Domain affine_2d() {
  return {
      "affine_2d",
      {{.name = "transform",
        .states = "within 3 ulp of |xx x| + |xy y| + |x0|, likewise in y",
        .unit = "ulp",
        .bound = 3,
        .numbers = 8,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::huge, Kind::tiny, Kind::ties, Kind::denormal,
                  Kind::extremes},
        .generate = at_every_scale(matrix_and_point),
        .error = transform_error,
        .traps = {{"the sum cancels", {1, -1, 0x1p-53, 1, 1, 0, 1, std::nextafter(1, 2)}},
                  {"products underflow", {1e-200, 0, 0, 0, 1e-200, 0, 1e-200, 1e-200}}}},
       {.name = "reflection_in_line",
        .states = "each entry within 4 ulp of 1",
        .unit = "ulp",
        .bound = 4,
        .numbers = 4,
        .generate = at_every_scale(two_points),
        .error = mirror_error,
        .traps = {{"squares underflow", {0, 0, 1e-200, 2e-200}},
                  {"squares overflow", {0, 0, 1e200, -1e200}},
                  {"the smallest step", {1, 1, 1, std::nextafter(1, 2)}},
                  {"one point", {3, 4, 3, 4}},
                  {"too far apart", {-1.7e308, 0, 1.7e308, 1}},
                  {"no number", {0, 0, std::nan(""), 1}}}},
       {.name = "inverse",
        .states = "within 4 ulp of the entry's terms, times how far the determinant cancels; nothing where "
                  "it is 0 or an entry would be infinite",
        .unit = "bounds",
        .bound = 1,
        .numbers = 6,
        .generate = at_every_scale(matrix),
        .error = inverse_error,
        .traps = {{"columns of two sizes", {1e200, 1e200, 0, 1e-200, -1e-200, 0}},
                  {"rows of two sizes", {1e200, 1e-200, 3, 1e200, -1e-200, 4}},
                  {"subnormal entries", {0x3p-1074, 0x1p-1074, 0, 0x1p-1074, 0x1p-1074, 0}},
                  {"subnormal beside 1", {1, 0x1p-1074, 0, 0x1p-1074, 1, 5}},
                  {"the determinant underflows", {1e-170, 1e-170, 1, -1e-170, 1e-170, 2}},
                  {"the determinant overflows", {1e200, 1e200, 1, -1e200, 1e200, 2}},
                  {"an entry would be infinite", {1e-310, 0, 0, 0, 1, 0}},
                  {"the shift comes back infinite", {1e-200, 0, 1e200, 0, 1e-200, 0}},
                  {"a shear that flattens", {1, 3, 0, 1.0 / 3, 1, 0}}}},
       {.name = "nearest_rotation",
        .states = "orthogonal to 3 ulp of 1 for every determinant above 0; others are refused",
        .unit = "ulp",
        .bound = 3,
        .numbers = 4,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties,
                  Kind::denormal, Kind::extremes},
        .generate = at_every_scale([](Kind kind, Random& random) {
          const Input m = matrix(kind, random);
          return Input{m[0], m[1], m[3], m[4]};
        }),
        .error = rotation_error,
        .traps = {{"orthogonal to 2.3 ulp only",
                   {-0x1.17a480e6fc43p+1, 0x1.0de2407d8b7acp+3, -0x1.cb7a4df6da7a8p+1, 0x1.b163e9cbdd974p+3}},
                  {"the determinant underflows", {1e-200, 0, 0, 1e-200}},
                  {"the determinant overflows", {1e200, -1e200, 1e200, 1e200}},
                  {"a determinant of 2^-2148", {0x1p-1074, 0, 0, 0x1p-1074}},
                  {"a mirror", {1, 0, 0, -1}},
                  {"flat", {1, 2, 2, 4}}}}}};
}

}  // namespace gradus::stress
