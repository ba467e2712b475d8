// The promise of culling: which side of a triangle is seen is never a matter of rounding.

#include "visibility/back_face_culling/back_face_culling.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "core/contract.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using back_face_culling::Facing;
using Rational = boost::multiprecision::cpp_rational;

/// x, y, w of three corners.
Input generate(Kind kind, Random& random) {
  Input input(9);
  for (double& x : input) x = number(kind == Kind::refused ? Kind::random : kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The third corner in the plane of the others and the eye, but for the last places
    const double s = random.uniform(-2, 2), t = kind == Kind::grazing ? 1 - s : random.uniform(-2, 2);
    for (std::size_t k = 0; k < 3; ++k) input[6 + k] = nudged(s * input[k] + t * input[3 + k], random);
  }
  if (kind == Kind::refused) {
    input[static_cast<std::size_t>(random.uniform_int(0, 8))] = random.unit() < 0.5 ? std::nan("") : wrong;
  }
  return input;
}

double error(const Input& i) {
  const auto corner = [&](std::size_t k) { return glm::dvec4(i[k], i[k + 1], 0.5, i[k + 2]); };
  Facing found{};
  try {
    found = back_face_culling::facing(corner(0), corner(3), corner(6));
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
  if (!all_finite(i)) return wrong;
  const auto minor = [&](std::size_t a, std::size_t b) -> Rational {
    return Rational(i[a]) * Rational(i[b + 1]) - Rational(i[a + 1]) * Rational(i[b]);
  };
  // By the column of w
  const Rational det =
      Rational(i[2]) * minor(3, 6) - Rational(i[5]) * minor(0, 6) + Rational(i[8]) * minor(0, 3);
  const Facing right = det > 0 ? Facing::front : det < 0 ? Facing::back : Facing::edge_on;
  return found == right ? 0 : wrong;
}

}  // namespace

Domain back_face_culling() {
  const double u = 0x1p-53;
  return {"back_face_culling",
          {{.name = "facing",
            .states = "front, back or edge-on as the exact determinant says, whatever the signs of w",
            .unit = "decisions",
            .bound = 0,
            .numbers = 9,
            .generate = at_every_scale(generate),
            .error = error,
            .traps = {
                {"no area", {1, 1, 1, 2, 2, 1, 3, 3, 1}},
                {"all corners one", {1, 1, 1, 1, 1, 1, 1, 1, 1}},
                {"edges of 1e-170", {0, 0, 1, 1e-170, 0, 1, 0, 1e-170, 1}},
                {"edges of 1e160", {0, 0, 1, 1e160, 0, 1, 0, 1e160, 1}},
                {"the eye in the plane", {0, 0, 0, 1, 1, 1, 2, 0, 1}},
                {"an area of -1.33e-15 that doubles call 0", {0.5 + 2 * u, 0.5 + u, 1, 12, 12, 1, 24, 24, 1}},
                {"six products near 1e16", {1e8, 1e8, 1, 1e8 + 1, 1e8 + 0.25, 1, 1e8 + 0.5, 1e8 + 0.875, 1}},
                {"a corner behind the eye", {0, 0, 1, 1, 0, 1, 0, 1, -1}},
                {"a corner that is no number", {std::nan(""), 0, 1, 1, 0, 1, 0, 1, 1}}}}}};
}

}  // namespace gradus::stress
