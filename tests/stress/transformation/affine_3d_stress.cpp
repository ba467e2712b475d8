// The promises of transformations in space.

#include "transformation/affine_3d/affine_3d.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/contract.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Float = boost::multiprecision::cpp_bin_float_100;

dvec3 vector_of(const Input& i, std::size_t from) { return {i[from], i[from + 1], i[from + 2]}; }

/// An axis and an angle: x, y, z, radians.
Input generate(Kind kind, Random& random) {
  Input input{number(kind, random), number(kind, random), number(kind, random), random.uniform(-7, 7)};
  if (kind == Kind::refused && all_finite(input)) input = {0, 0, 0, 1};
  if (kind == Kind::near_degenerate) {
    // Nearly along an axis of coordinates, nearly no angle
    input[0] *= 1e-17;
    if (random.unit() < 0.5) input[1] *= 1e-17;
    if (random.unit() < 0.5) input[3] *= 1e-9;
  } else if (kind == Kind::huge || kind == Kind::extremes) {
    input[3] = sized(random, 0, 80);
  } else if (kind == Kind::ties) {
    input[3] = 0.5 * static_cast<double>(random.uniform_int(-8, 8));
  }
  return input;
}

/// The largest entry of R^T R - I, exactly, in units of 2^-52.
double off_orthogonal(const glm::dmat4& m) {
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      Rational sum = i == k ? -1 : 0;
      for (int r = 0; r < 3; ++r) {
        if (!std::isfinite(m[i][r])) return wrong;
        sum += Rational(m[i][r]) * Rational(m[k][r]);
      }
      worst = std::max(worst, std::abs(static_cast<double>(sum)) * 0x1p52);
    }
  }
  return worst;
}

double error(const Input& i) {
  const bool taken = all_finite(i) && (i[0] != 0 || i[1] != 0 || i[2] != 0);
  try {
    const double off = off_orthogonal(affine_3d::rotation({i[0], i[1], i[2]}, i[3]));
    return taken ? off : wrong;
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
}

// --- A point under a matrix: four columns, then the point -----------------------------------------------

Input matrix_and_point(Kind kind, Random& random) {
  Input input(15);
  for (double& x : input) x = number(kind, random);
  if (kind == Kind::near_degenerate) {
    // The first row nearly undoes itself
    input[14] = nudged(input[13], random);
    input[6] = nudged(-input[3], random);
    input[0] *= 1e-17, input[9] *= 1e-17;
  }
  return input;
}

double transform_error(const Input& i) {
  const glm::dmat4 m{{vector_of(i, 0), 0}, {vector_of(i, 3), 0}, {vector_of(i, 6), 0}, {vector_of(i, 9), 1}};
  const dvec3 point = vector_of(i, 12), to = affine_3d::transform(m, point);
  double worst = 0;
  for (int row = 0; row < 3; ++row) {
    Rational sum(m[3][row]), size = abs(sum);
    int underflows = 0;
    for (int k = 0; k < 3; ++k) {
      const Rational product = Rational(m[k][row]) * Rational(point[k]);
      sum += product;
      size += abs(product);
      underflows += product != 0 && abs(product) < Rational(0x1p-1021);
    }
    if (size > Rational(std::numeric_limits<double>::max())) continue;
    if (!std::isfinite(to[row])) return wrong;
    const Rational bound =
        size * Rational(0x1p-51) * (1 + Rational(0x1p-51)) + underflows * Rational(0x1p-1074) / 2;
    const Rational off = abs(sum - Rational(to[row]));
    if (off > 0) worst = std::max(worst, bound == 0 ? wrong : static_cast<double>(Rational(off / bound)));
  }
  return worst;
}

// --- Normals: three columns -----------------------------------------------------------------------------

Input three_columns(Kind kind, Random& random) {
  Input input(9);
  for (double& x : input) x = number(kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The third column in the plane of the others, but for the last places
    const double s = random.uniform(-2, 2), t = random.uniform(-2, 2);
    for (std::size_t k = 0; k < 3; ++k) input[6 + k] = nudged(s * input[k] + t * input[3 + k], random);
  }
  return input;
}

double normal_error(const Input& i) {
  const glm::dmat4 m{{vector_of(i, 0), 0}, {vector_of(i, 3), 0}, {vector_of(i, 6), 0}, {0, 0, 0, 1}};
  const glm::dmat3 found = affine_3d::normal_matrix(m);
  double largest = 0;
  for (const double x : i) largest = std::max(largest, std::abs(x));
  if (largest == 0) return found == glm::dmat3(0) ? 0 : wrong;
  const int exponent = std::ilogb(largest);
  const Rational scale =
      Rational(std::ldexp(1.0, -exponent / 2)) * Rational(std::ldexp(1.0, -exponent + exponent / 2));
  const auto entry = [&](int column, int row) {
    const double x = i[static_cast<std::size_t>(3 * (column % 3) + row % 3)];
    return abs(Rational(x)) < Rational(0x1p-500) * Rational(largest) ? Rational(0) : Rational(x * scale);
  };
  Rational det = 0;
  struct Minor {
    Rational exact, size;
  };
  const auto minor = [&](int column, int row) {
    const Rational left = entry(column + 1, row + 1) * entry(column + 2, row + 2);
    const Rational right = entry(column + 1, row + 2) * entry(column + 2, row + 1);
    return Minor{Rational(left - right), Rational(abs(left) + abs(right))};
  };
  for (int row = 0; row < 3; ++row) det += entry(0, row) * minor(0, row).exact;
  const bool small =
      std::ranges::any_of(i, [&](double x) { return x != 0 && std::abs(x) < 0x1p-499 * largest; });
  if (small) return 0;  // what may count as 0 may decide the sign
  if (affine_3d::mirrors(m) != (det < 0)) return wrong;
  double worst = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      const Minor right = minor(column, row);
      const double x = found[column][row];
      if (!std::isfinite(x)) return wrong;
      const Rational off = abs((det < 0 ? Rational(-right.exact) : right.exact) - Rational(x));
      const Rational bound = right.size * Rational(0x1p-52) * (1 + Rational(0x1p-53));
      if (off > 0) worst = std::max(worst, bound == 0 ? wrong : static_cast<double>(Rational(off / bound)));
    }
  }
  return worst;
}

// --- Drifted rotations: the first two columns -----------------------------------------------------------

Input two_columns(Kind kind, Random& random) {
  Input input(6);
  for (double& x : input) x = number(kind == Kind::refused ? Kind::random : kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // Nearly along each other, at angles down to the last place; or a little beside a rotation
    const double angle = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform_int(-60, -2)));
    for (std::size_t k = 0; k < 3; ++k) {
      input[3 + k] = 2 * input[k] + (kind == Kind::grazing ? 0 : angle * input[3 + k]);
    }
    if (kind == Kind::grazing) {
      const auto k = static_cast<std::size_t>(random.uniform_int(3, 5));
      input[k] = nudged(input[k], random);
    }
  }
  if (kind == Kind::refused) {
    input[static_cast<std::size_t>(random.uniform_int(0, 5))] = random.unit() < 0.5 ? std::nan("") : wrong;
  }
  return input;
}

std::array<Float, 3> unit(const std::array<Rational, 3>& v) {
  const std::array<Float, 3> wide{Float(v[0]), Float(v[1]), Float(v[2])};
  const Float length = sqrt(wide[0] * wide[0] + wide[1] * wide[1] + wide[2] * wide[2]);
  return {wide[0] / length, wide[1] / length, wide[2] / length};
}

double orthonormal_error(const Input& i) {
  glm::dmat4 m(1), found;
  m[0] = {vector_of(i, 0), 0};
  m[1] = {vector_of(i, 3), 0};
  bool taken = true;
  try {
    found = affine_3d::orthonormalized(m);
  } catch (const ContractViolation&) {
    taken = false;
  }
  if (!all_finite(i)) return taken ? wrong : 0;
  // As the header has it: what is vanishingly small beside the largest may count as 0
  std::array<std::array<Rational, 3>, 2> columns;
  for (int k = 0; k < 2; ++k) {
    const dvec3 scaled = Scaled<double>(vector_of(i, 3 * static_cast<std::size_t>(k))).vector;
    columns[static_cast<std::size_t>(k)] = {Rational(scaled.x), Rational(scaled.y), Rational(scaled.z)};
  }
  const auto& [a, b] = columns;
  const std::array<Rational, 3> normal{Rational(a[1] * b[2] - a[2] * b[1]),
                                       Rational(a[2] * b[0] - a[0] * b[2]),
                                       Rational(a[0] * b[1] - a[1] * b[0])};
  const Rational sine = std::max({abs(normal[0]), abs(normal[1]), abs(normal[2])},
                                 [](const Rational& p, const Rational& q) { return p < q; });
  if (sine == 0) return taken ? wrong : 0;
  if (sine < Rational(0x1p-900)) return 0;
  if (!taken) return wrong;
  const auto first = unit(a), third = unit(normal);
  double worst = off_orthogonal(found);
  for (int k = 0; k < 3; ++k) {
    const auto off = [&](double x, const Float& right) {
      return std::abs(static_cast<double>(Float(x) - right)) * 0x1p52;
    };
    worst = std::max({worst, off(found[0][k], first[static_cast<std::size_t>(k)]),
                      off(found[2][k], third[static_cast<std::size_t>(k)])});
  }
  return worst;
}

}  // namespace

Domain affine_3d() {
  return {"affine_3d",
          {{.name = "rotation",
            .states = "no entry of R^T R - I is above 4 ulp of 1",
            .unit = "ulp",
            .bound = 4,
            .numbers = 4,
            .generate = at_every_scale(generate, {0, 1, 2}),
            .error = error,
            .traps = {{"squares underflow", {1e-200, 0, 0, 1}},
                      {"squares overflow", {1e200, 1e200, 0, 1}},
                      {"no axis", {0, 0, 0, 1}},
                      {"1 - cos is 0", {1, 2, 3, 1e-9}},
                      {"a full reduction of the angle", {1, 2, 3, 1e22}},
                      {"an angle that is no number", {1, 2, 3, std::nan("")}}}},
           {.name = "transform",
            .states = "within 4 roundings of |xx x| + |xy y| + |xz z| + |x0|, likewise in y and z",
            .unit = "bounds",
            .bound = 1,
            .numbers = 15,
            .kinds = {Kind::random, Kind::near_degenerate, Kind::huge, Kind::tiny, Kind::ties, Kind::denormal,
                      Kind::extremes},
            .generate = at_every_scale(matrix_and_point),
            .error = transform_error},
           {.name = "normal_matrix",
            .states =
                "cofactors within 2 roundings of their products, on the side that the exact determinant says",
            .unit = "bounds",
            .bound = 1,
            .numbers = 9,
            .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties,
                      Kind::denormal, Kind::extremes},
            .generate = at_every_scale(three_columns),
            .error = normal_error,
            .traps = {{"products underflow", {1e-200, 0, 0, 0, 1e-200, 0, 0, 0, -1e-200}},
                      {"products overflow", {1e200, 0, 0, 0, 1e200, 0, 0, 0, -1e200}},
                      {"a determinant of -2^-3222", {0x1p-1074, 0, 0, 0, 0x1p-1074, 0, 0, 0, -0x1p-1074}},
                      {"flat", {1, 2, 3, 4, 5, 6, 7, 8, 9}}}},
           {.name = "orthonormalized",
            .states = "orthogonal to 2 ulp of 1, first column and normal kept to 2 ulp, at every angle",
            .unit = "ulp",
            .bound = 2,
            .numbers = 6,
            .generate = at_every_scale(two_columns),
            .error = orthonormal_error,
            .traps = {{"columns 2^-20 apart", {1, 0, 0, 1, 0x1p-20, 0}},
                      {"columns 2^-20 apart, askew", {0.6, 0.48, 0.64, 0.6 + 0x1p-20, 0.48, 0.64}},
                      {"columns an ulp apart", {1, 1, 1, 1, 1, 1 + 0x1p-52}},
                      {"products underflow", {1e-200, 0, 0, 0, 1e-200, 0}},
                      {"products overflow", {1e200, 1e200, 0, 1e200, -1e200, 0}},
                      {"the smallest columns", {0x1p-1074, 0, 0, 0x1p-1074, 0x1p-1074, 0}},
                      {"parallel", {1, 2, 3, -2, -4, -6}},
                      {"no column", {0, 0, 0, 1, 2, 3}}}}}};
}

}  // namespace gradus::stress
