// The promise of culling: which side of a triangle is seen is never a matter of rounding.

#include "visibility/back_face_culling/back_face_culling.hpp"

#include <algorithm>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/record.hpp"
#include "stress/core/integers.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace back_face_culling;

/// x, y, w of three corners.
Input generate(Kind kind, Random& random) {
  Input input(9);
  for (double& x : input) x = number(kind == Kind::refused ? Kind::random : kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The third corner in the plane of the others and the eye, but for the last places
    const double s = random.uniform(-2, 2), t = kind == Kind::grazing ? 1 - s : random.uniform(-2, 2);
    for (std::size_t k = 0; k < 3; ++k) input[6 + k] = nudged(s * input[k] + t * input[3 + k], random);
  } else if (kind == Kind::ties && random.unit() < 0.5) {
    for (std::size_t k = 0; k < 3; ++k) input[6 + k] = 2 * input[k] - input[3 + k];
  }
  if (kind == Kind::refused) {
    input[static_cast<std::size_t>(random.uniform_int(0, 8))] = random.unit() < 0.5 ? std::nan("") : wrong;
  }
  return input;
}

int exact_sign(const Input& i) {
  const auto minor = [&](std::size_t a, std::size_t b) {
    return Integer(fixed(i[a]) * fixed(i[b + 1]) - fixed(i[a + 1]) * fixed(i[b]));
  };
  // By the column of w
  return Integer(fixed(i[2]) * minor(3, 6) - fixed(i[5]) * minor(0, 6) + fixed(i[8]) * minor(0, 3)).sign();
}
template <class T>
glm::vec<4, T> corner(const Input& i, std::size_t k) {
  return {static_cast<T>(i[k]), static_cast<T>(i[k + 1]), T(0), static_cast<T>(i[k + 2])};
}

double error(const Input& i) {
  Recorder<Tested<double>> seen;
  Facing found{};
  try {
    const auto a = corner<double>(i, 0), b = corner<double>(i, 3), c = corner<double>(i, 6);
    found = facing(a, b, c, seen);
    if (!all_finite(i) || facing(a, b, c) != found) return wrong;
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
  const int sign = exact_sign(i);
  const ExactScope scope;
  const int of_rationals = determinant_sign(corner<Exact>(i, 0), corner<Exact>(i, 3), corner<Exact>(i, 6));
  const Facing right = sign > 0 ? Facing::front : sign < 0 ? Facing::back : Facing::edge_on;
  // Where the numbers are floats, too
  const bool floats = std::ranges::all_of(
      i, [](double x) { return std::abs(x) <= 0x1p127 && double{static_cast<float>(x)} == x; });
  if (floats && facing(corner<float>(i, 0), corner<float>(i, 3), corner<float>(i, 6)) != right) return wrong;
  return found == right && of_rationals == sign && all<Tested<double>>(seen).at(0).sign == sign ? 0 : wrong;
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
            .traps = {{"no area", {1, 1, 1, 2, 2, 1, 3, 3, 1}},
                      {"all corners one", {1, 1, 1, 1, 1, 1, 1, 1, 1}},
                      {"edges of 1e-170", {0, 0, 1, 1e-170, 0, 1, 0, 1e-170, 1}},
                      {"edges of 1e160", {0, 0, 1, 1e160, 0, 1, 0, 1e160, 1}},
                      {"the eye in the plane", {0, 0, 0, 1, 1, 1, 2, 0, 1}},
                      {"an area of -1.33e-15 that doubles call 0",
                       {0.5 + 2 * u, 0.5 + u, 1, 12, 12, 1, 24, 24, 1}},
                      {"six products near 1e16",
                       {1e8, 1e8, 1, 1e8 + 1, 1e8 + 0.25, 1, 1e8 + 0.5, 1e8 + 0.875, 1}},
                      {"a corner behind the eye", {0, 0, 1, 1, 0, 1, 0, 1, -1}},
                      {"a corner that is no number", {std::nan(""), 0, 1, 1, 0, 1, 0, 1, 1}}},
            .shares = {
                {"is edge-on", 0.01, [](const Input& i) { return all_finite(i) && exact_sign(i) == 0; }}}}}};
}

}  // namespace gradus::stress
