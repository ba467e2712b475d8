// The promise of Phong's illumination, one light at a time.

#include "shading/illumination/illumination.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "core/surface.hpp"
#include "stress/core/digits.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using Vec = std::array<Digits, 3>;

Digits dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Digits length(const Vec& v) { return sqrt(dot(v, v)); }
dvec3 vector_of(const Input& i, std::size_t from) { return {i[from], i[from + 1], i[from + 2]}; }
Vec way(dvec3 from, dvec3 to) {
  return {Digits(to.x) - Digits(from.x), Digits(to.y) - Digits(from.y), Digits(to.z) - Digits(from.z)};
}
Vec unit(const Vec& v) {
  const Digits size = length(v);
  return size == 0 ? v : Vec{Digits(v[0] / size), Digits(v[1] / size), Digits(v[2] / size)};
}

/// The place, three numbers along the normal, the eye, the light, its attenuation (3) and the exponent n.
Input generate(Kind kind, Random& random) {
  Input input(16);
  for (double& x : input) x = number(kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The light nearly, or as nearly as can be, at the horizon: at right angles on the normal
    const dvec3 across = glm::cross(vector_of(input, 3), vector_of(input, 6));
    const double above =
        kind == Kind::grazing ? 0 : std::ldexp(1.0, static_cast<int>(random.uniform_int(-52, -8)));
    for (std::size_t k = 0; k < 3; ++k) {
      input[9 + k] = input[k] + across[static_cast<int>(k)] + above * input[3 + k];
    }
  }
  for (std::size_t k = 12; k < 15; ++k) input[k] = random.unit() < 0.3 ? 0 : std::abs(input[k]);
  // As exponents are: 0, 1, fractions, and large
  const double exponents[] = {0, 1, 2, 10, random.uniform(0, 1), random.uniform(1, 200), 1e4};
  input[15] = exponents[random.uniform_int(0, 6)];
  return input;
}

/// The largest share of what is promised that is used up.
double error(const Input& i) {
  if (!all_finite(i)) return 0;
  const dvec3 place = vector_of(i, 0), eye = vector_of(i, 6), position = vector_of(i, 9);
  const dvec3 normal = unit_vector(vector_of(i, 3));
  Light light;
  light.position = position;
  light.constant = std::abs(i[12]), light.linear = std::abs(i[13]), light.quadratic = std::abs(i[14]);
  Material material;
  material.diffuse = LinearRgb{1}, material.specular = LinearRgb{1};
  material.shininess = static_cast<float>(std::clamp(i[15], 0.0, 1e4));
  const Vec to_light = way(place, position), to_eye = way(place, eye);
  const Digits largest(std::numeric_limits<double>::max());
  for (const Vec& v : {to_light, to_eye}) {
    if (length(v) > largest) return 0;  // beyond the domain
  }
  const auto parts = illumination::phong(place, normal, eye, material, std::span(&light, 1), LinearRgb{0});

  const Vec l = unit(to_light), v = unit(to_eye), n{normal.x, normal.y, normal.z};
  const Digits nl = dot(n, l), distance = length(to_light);
  Vec r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = 2 * nl * n[k] - l[k];
  const Digits rv = dot(r, v), u(0x1p-53), exponent(material.shininess);
  const Digits weakened =
      Digits(light.constant) + distance * (Digits(light.linear) + distance * Digits(light.quadratic));
  const Digits full = weakened > 1 ? Digits(1 / weakened) : Digits(1);
  if (full < Digits(0x1p-900)) return parts.diffuse.x < 0x1p-899 && parts.specular.x < 0x1p-899 ? 0 : wrong;
  const auto share = [&](double found, const Digits& right, const Digits& bound) {
    if (!std::isfinite(found)) return wrong;
    return static_cast<double>(Digits(abs(Digits(found) - right) / bound));
  };
  const Digits diffuse = nl > 0 ? Digits(full * nl) : Digits(0);
  const double worst = share(parts.diffuse.x, diffuse, 30 * u * full);
  // Which side of the horizon, and of the mirror's, is not told nearer
  if (abs(nl) <= 40 * u || abs(rv) <= 40 * u) return worst;
  const Digits highlight = nl > 0 && rv > 0 ? Digits(full * pow(rv, exponent)) : Digits(0);
  Digits steep = exponent > 1 ? exponent : Digits(1);
  if (exponent > 0 && exponent < 1 && rv > 0) steep = 1 / rv;
  return std::max(worst, share(parts.specular.x, highlight, 60 * u * steep * full));
}

}  // namespace

Domain illumination() {
  return {
      "illumination",
      {{.name = "phong",
        .states = "diffuse part within 30 u of the light's full strength, highlight within 60 u max(1, n)",
        .unit = "bounds",
        .bound = 1,
        .numbers = 16,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties,
                  Kind::denormal, Kind::extremes},
        .generate = at_every_scale(generate, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}),
        .error = error,
        .traps = {
            {"a light at the horizon", {0, 0, 0, .6, .8, 0, 0, 0, 5, -.8 + 6e-7, .6 + 8e-7, 0, 1, 0, 0, 10}},
            {"a light so near that squares underflow",
             {0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 3e-200, 4e-200, 0, 1e200, 0, 1}},
            {"a light so far that squares overflow",
             {0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 3e200, 4e200, 0, 1e-200, 0, 1}},
            {"the light at the place", {1, 2, 3, 0, 0, 1, 0, 0, 9, 1, 2, 3, 1, 1, 1, 0}},
            {"the eye at the place", {1, 2, 3, 0, 0, 1, 1, 2, 3, 0, 0, 9, 1, 1, 1, 0}},
            {"no normal", {1, 2, 3, 0, 0, 0, 0, 0, 9, 0, 9, 9, 1, 1, 1, 0}},
            {"an exponent of 10^4 beside the mirror",
             {0, 0, 0, 0, 0, 1, 1, 0, 100, 0, 0, 4, 1, 0, 0, 1e4}}}}}};
}

}  // namespace gradus::stress
