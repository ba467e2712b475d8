// The promises of rotations in space.

#include "transformation/affine_3d/affine_3d.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/contract.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using Rational = boost::multiprecision::cpp_rational;

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

}  // namespace

Domain affine_3d() {
  return {"affine_3d",
          {{.name = "rotation",
            .states = "no entry of R^T R - I is above 4 ulp of 1",
            .unit = "ulp",
            .bound = 4,
            .numbers = 4,
            .generate = generate,
            .error = error,
            .traps = {{"squares underflow", {1e-200, 0, 0, 1}},
                      {"squares overflow", {1e200, 1e200, 0, 1}},
                      {"no axis", {0, 0, 0, 1}},
                      {"1 - cos is 0", {1, 2, 3, 1e-9}},
                      {"a full reduction of the angle", {1, 2, 3, 1e22}},
                      {"an angle that is no number", {1, 2, 3, std::nan("")}}}}}};
}

}  // namespace gradus::stress
