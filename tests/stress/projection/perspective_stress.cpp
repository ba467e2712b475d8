// The promises of the perspective projection onto a plane.

#include "projection/perspective/perspective.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/contract.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// A plane and a point: d, x, y, z.
Input generate(Kind kind, Random& random) {
  Input input{std::abs(number(kind, random)), number(kind, random), number(kind, random),
              number(kind, random)};
  if (random.unit() < 0.75) input[3] = std::abs(input[3]);
  if (kind == Kind::near_degenerate) {
    // Beside the plane, or nearly in the eye
    input[3] = random.unit() < 0.5 ? nudged(input[0], random) : std::ldexp(input[3], -1000);
  } else if (kind == Kind::grazing) {
    input[3] = random.unit() < 0.5 ? input[0] : 0;
  }
  return input;
}

/// How far an image is from x d / z, in roundings of it; 0 where that promises nothing.
double roundings(double image, double x, double d, double z) {
  const Rational exact = Rational(x) * Rational(d) / Rational(z);
  const double size = std::abs(static_cast<double>(exact));
  if (!std::isnormal(size) || !std::isnormal(d / z)) return x == 0 && image != 0 ? wrong : 0;
  return static_cast<double>(Rational(abs(Rational(image) - exact) / abs(exact))) * 0x1p53;
}

double error(const Input& i) {
  const double d = i[0], z = i[3];
  try {
    const auto image = perspective::project(d, {i[1], i[2], z});
    if (!(d > 0)) return wrong;  // was to be refused
    if (!(z > 0)) return image ? wrong : 0;
    const bool fits = all_finite({d / z, i[1] * (d / z), i[2] * (d / z)});
    if (!fits) return image ? wrong : 0;
    if (!image || image->z != d) return wrong;
    if (!all_finite(i)) return 0;  // infinitely far away, say
    if (z == d && (image->x != i[1] || image->y != i[2])) return wrong;
    return std::max(roundings(image->x, i[1], d, z), roundings(image->y, i[2], d, z));
  } catch (const ContractViolation&) {
    return d > 0 ? wrong : 0;
  }
}

}  // namespace

Domain perspective() {
  return {"perspective",
          {{.name = "project",
            .states = "no image at or behind the eye; else x and y within two roundings",
            .unit = "roundings",
            .bound = 0x1.0000000000001p1,  // 2 (1 + 2^-53)
            .numbers = 4,
            .generate = at_every_scale(generate, {}, [](Input& i) { i[0] = std::abs(i[0]); }),
            .error = error,
            .traps = {{"in the eye", {1, 1, 1, 0}},
                      {"behind the eye", {1, 1, 1, -2}},
                      {"the eye from behind", {1, 1, 1, -0.0}},
                      {"nearly in the eye", {1, 1, 1, 1e-310}},
                      {"the plane itself", {0.1, 0.3, 0.7, 0.1}},
                      {"the axis, nearly in the eye", {1, 0, 0, 1e-310}},
                      {"no distance", {0, 1, 1, 1}},
                      {"a depth that is no number", {1, 1, 1, std::nan("")}}}}}};
}

}  // namespace gradus::stress
