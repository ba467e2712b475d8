// The promises of illumination, one light at a time.

#include "shading/illumination/illumination.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "core/surface.hpp"
#include "stress/core/digits.hpp"
#include "stress/core/triple.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using Vec = Triple<Digits>;

const Digits u(0x1p-53);

/// A result's distance from the right one, as a share of a bound.
double share(double found, const Digits& right, const Digits& bound) {
  return std::isfinite(found) ? static_cast<double>(Digits(abs(Digits(found) - right) / bound)) : wrong;
}

/// The place, three numbers along the normal, the eye, the light, its attenuation (3) and the exponent n.
Input generate(Kind kind, Random& random) {
  Input input(16);
  for (double& x : input) x = number(kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The light nearly, or as nearly as can be, at the horizon: at right angles on the normal
    const dvec3 across = glm::cross(vector_in(input, 3), vector_in(input, 6));
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

/// Such an input, and in digits what phong and blinn_phong have in common.
struct Lit {
  dvec3 place, normal, eye;
  Light light{};
  double shininess;
  Vec l{}, v{}, n{};
  Digits nl{}, full{};  ///< N.L; the light's full strength
  bool in_domain;

  explicit Lit(const Input& i)
      : place(vector_in(i, 0)),
        normal(unit_vector(vector_in(i, 3))),
        eye(vector_in(i, 6)),
        shininess(std::clamp(i[15], 0.0, 1e4)),
        in_domain(all_finite(i)) {
    light.position = vector_in(i, 9);
    light.constant = std::abs(i[12]), light.linear = std::abs(i[13]), light.quadratic = std::abs(i[14]);
    if (!in_domain) return;
    const Vec to_light = way_from<Digits>(place, light.position), to_eye = way_from<Digits>(place, eye);
    const Digits largest(std::numeric_limits<double>::max()), distance = length_of(to_light);
    in_domain = distance <= largest && length_of(to_eye) <= largest;
    l = unit(to_light), v = unit(to_eye), n = triple<Digits>(normal);
    nl = dot(n, l);
    const Digits weakened =
        Digits(light.constant) + distance * (Digits(light.linear) + distance * Digits(light.quadratic));
    full = weakened > 1 ? Digits(1 / weakened) : Digits(1);
  }
  std::span<const Light> lights() const { return {&light, 1}; }
  bool vanishes() const { return full < Digits(0x1p-900); }

  /// Of a highlight with this cosine, within so many u.
  double highlight_error(double found, const Digits& cosine, const Digits& exponent,
                         const Digits& roundings) const {
    const Digits right = nl > 0 && cosine > 0 ? Digits(full * pow(cosine, exponent)) : Digits(0);
    Digits steep = exponent > 1 ? exponent : Digits(1);
    if (exponent > 0 && exponent < 1 && cosine > 0) steep = 1 / cosine;
    return share(found, right, roundings * u * steep * full);
  }
};

/// The largest share of what is promised that is used up.
double error(const Input& i) {
  const Lit lit(i);
  if (!lit.in_domain) return 0;
  Material material;
  material.diffuse = LinearRgb{1}, material.specular = LinearRgb{1};
  material.shininess = static_cast<float>(lit.shininess);
  const auto parts =
      illumination::phong(lit.place, lit.normal, lit.eye, material, lit.lights(), LinearRgb{0});
  if (lit.vanishes()) return parts.diffuse.x < 0x1p-899 && parts.specular.x < 0x1p-899 ? 0 : wrong;
  Vec r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = 2 * lit.nl * lit.n[k] - lit.l[k];
  const Digits rv = dot(r, lit.v), diffuse = lit.nl > 0 ? Digits(lit.full * lit.nl) : Digits(0);
  const double worst = share(parts.diffuse.x, diffuse, 30 * u * lit.full);
  // Which side of the horizon, and of the mirror's, is not told nearer
  if (abs(lit.nl) <= 40 * u || abs(rv) <= 40 * u) return worst;
  return std::max(worst, lit.highlight_error(parts.specular.x, rv, Digits(material.shininess), 60));
}

/// The same inputs, their highlight by Blinn. How near L + V is to 0 counts.
double blinns_error(const Input& i) {
  const Lit lit(i);
  if (!lit.in_domain) return 0;
  illumination::Reflectance<double> shiny;
  shiny.specular = dvec3{1};
  shiny.shininess = lit.shininess;
  const double found = illumination::blinn_phong(lit.place, lit.normal, lit.eye, shiny, lit.lights(),
                                                 dvec3{0}, illumination::AllSeen{})
                           .specular.x;
  const Vec both{lit.l[0] + lit.v[0], lit.l[1] + lit.v[1], lit.l[2] + lit.v[2]};
  const Digits nh = dot(lit.n, unit(both)), spread = length_of(both);
  if (lit.vanishes()) return found < 0x1p-899 ? 0 : wrong;
  if (spread <= 100 * u || abs(lit.nl) <= 40 * u || abs(nh) <= 100 * u / spread)
    return std::isfinite(found) ? 0 : wrong;
  return lit.highlight_error(found, nh, Digits(lit.shininess), 100 / spread);
}

/// The place, the spot, its axis, two cosines, the power.
Input spots(Kind kind, Random& random) {
  Input input(12);
  for (std::size_t k = 0; k < 9; ++k) input[k] = number(kind, random);
  double outer = random.uniform(-1, 1), inner = random.uniform(-1, 1);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // The place on the outer cone, or a little beside it
    const dvec3 to_place = unit_vector(vector_in(input, 0) - vector_in(input, 3));
    outer = glm::dot(to_place, unit_vector(vector_in(input, 6)));
    if (kind == Kind::near_degenerate)
      outer += random.uniform(-1, 1) * std::ldexp(1.0, -static_cast<int>(random.uniform_int(8, 52)));
    outer = std::clamp(outer, -1.0, 1.0);
    inner = outer + random.unit() * (1 - outer);
  }
  input[9] = std::clamp(std::min(outer, inner), -1.0, 1.0);
  input[10] = std::clamp(std::max(outer, inner), -1.0, 1.0);
  const double powers[] = {0, 0, 1, 2, 8, 100};
  input[11] = powers[random.uniform_int(0, 5)];
  return input;
}

/// A spot's edge, and exactly nothing outside it.
double spots_error(const Input& i) {
  if (!all_finite(i)) return 0;
  Light spot;
  spot.kind = Light::Kind::spot;
  spot.position = vector_in(i, 3), spot.direction = vector_in(i, 6);
  spot.outer_cosine = std::clamp(i[9], -1.0, 1.0);
  spot.inner_cosine = std::clamp(i[10], spot.outer_cosine, 1.0);
  spot.concentration = i[11] >= 1 ? std::min(i[11], 1000.0) : 0;
  const Vec to_place = way_from<Digits>(spot.position, vector_in(i, 0)),
            axis = triple<Digits>(spot.direction);
  const Digits largest(std::numeric_limits<double>::max());
  for (const Digits& length : {length_of(to_place), length_of(axis)}) {
    if (length > largest || length == 0) return 0;
  }
  const dvec3 to_light = illumination::towards(spot, 0, vector_in(i, 0)).first;
  const double found = illumination::spot_cone(spot, to_light);
  const Digits c = dot(unit(to_place), unit(axis)), outer(spot.outer_cosine), inner(spot.inner_cosine);
  if (c <= outer - 40 * u) return found == 0 ? 0 : wrong;
  if (!(found >= 0 && found <= 1)) return wrong;
  const Digits width = inner - outer;
  if (width <= 80 * u)
    return abs(c - outer) <= 120 * u || abs(Digits(found) - pow(c, Digits(spot.concentration))) < 1e-10
               ? 0
               : wrong;
  Digits t = (c - outer) / width;
  t = t < 0 ? Digits(0) : t > 1 ? Digits(1) : t;
  const Digits edge = t * t * (3 - 2 * t), power(spot.concentration);
  const Digits right = power == 0 ? edge : c > 0 ? Digits(edge * pow(c, power)) : Digits(0);
  const Digits bound = (60 / width + 40 * (power > 1 ? power : Digits(1)) + 20) * u;
  return share(found, right, bound);
}

/// A distance and a range near it.
Input ranges(Kind kind, Random& random) {
  Input input{std::abs(number(kind, random)), std::abs(number(kind, random))};
  if (kind == Kind::near_degenerate || kind == Kind::grazing || kind == Kind::ties) {
    input[0] = input[1];
    if (kind == Kind::grazing) input[0] = std::nextafter(input[1], 0.0);
    if (kind == Kind::near_degenerate)
      input[0] *= 1 + random.uniform(-1, 1) * std::ldexp(1.0, -static_cast<int>(random.uniform_int(4, 52)));
  }
  return input;
}

/// The end of a range, and exactly nothing beyond it.
double ranges_error(const Input& i) {
  if (!all_finite(i) || !(std::abs(i[1]) > 0)) return 0;
  Light light;
  light.range = std::abs(i[1]);
  const double d = std::abs(i[0]), found = illumination::range_window(light, d);
  if (d >= light.range) return found == 0 ? 0 : wrong;
  const Digits part = Digits(d) / Digits(light.range), left = 1 - part * part * part * part;
  if (!(found >= 0 && found <= 1)) return wrong;
  return share(found, left * left, 16 * u);
}

/// A rectangle above the place: its middle, its sides, and how often it is sampled.
Input areas(Kind kind, Random& random) {
  const double scale = kind == Kind::huge ? 1e3 : kind == Kind::tiny ? 1e-3 : 1;
  Input input;
  for (int k = 0; k < 3; ++k) input.push_back(random.uniform(-3, 3));
  input[2] = random.uniform(2, 6);
  for (int k = 0; k < 6; ++k) input.push_back(scale * random.uniform(-1, 1));
  if (kind == Kind::grazing) input[5] = input[8] = 0;
  input.push_back(static_cast<double>(random.uniform_int(1, 6)));
  return input;
}

/// How far the grid is from Lambert's integral: half the sum over the edges of the angle that each fills
/// times the height of its plane's normal.
double areas_error(const Input& i) {
  if (!all_finite(i)) return 0;
  Light light;
  light.kind = Light::Kind::area;
  light.position = vector_in(i, 0), light.across = vector_in(i, 3), light.along = vector_in(i, 6);
  light.constant = 0, light.quadratic = 1;
  light.samples = static_cast<int>(std::clamp(i[9], 1.0, 16.0));
  const double sides = glm::dot(light.across, light.across) + glm::dot(light.along, light.along);
  const double half = 0.5 * (glm::length(light.across) + glm::length(light.along));
  const double nearest = glm::length(light.position) - half;
  const dvec3 normal = glm::cross(light.across, light.along);
  // Beyond the domain: too near, across the horizon, or no area
  if (!(nearest > 1) || !(light.position.z > half) || !(glm::length(normal) > 1e-3 * sides) || !(sides < 1e3))
    return 0;
  illumination::Reflectance<double> white;
  white.diffuse = dvec3{1};
  const double found = illumination::phong(dvec3{0}, dvec3{0, 0, 1}, dvec3{0, 0, 1}, white,
                                           std::span<const Light>(&light, 1), dvec3{0})
                           .diffuse.x;
  const double front = -glm::dot(normal, light.position);
  if (front <= 0) return found == 0 ? 0 : wrong;
  double sum = 0;
  const double signs[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  for (int k = 0; k < 4; ++k) {
    const auto corner = [&](const double* sign) {
      return light.position + sign[0] * light.across + sign[1] * light.along;
    };
    const dvec3 a = corner(signs[k]), b = corner(signs[(k + 1) % 4]), across = glm::cross(a, b);
    const double size = glm::length(across);
    if (size > 0) sum += std::atan2(size, glm::dot(a, b)) * across.z / size;
  }
  const double whole = 0.5 * std::abs(sum) / glm::length(normal), n = light.samples;
  // Lambert's sum cancels where the rectangle is small
  const double rounding = 1e-13 / glm::length(normal);
  return std::abs(found - whole) / (1.6 * sides / (n * n * std::pow(nearest, 4)) + rounding);
}

}  // namespace

Domain illumination() {
  const std::vector<Kind> kinds(all_kinds.begin(), all_kinds.end() - 1);  // nothing is refused
  return {
      "illumination",
      {{.name = "phong",
        .states = "diffuse part within 30 u of the light's full strength, highlight within 60 u max(1, n)",
        .unit = "bounds",
        .bound = 1,
        .numbers = 16,
        .kinds = kinds,
        .generate = at_every_scale(generate, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}),
        .error = error,
        .traps = {{"a light at the horizon",
                   {0, 0, 0, .6, .8, 0, 0, 0, 5, -.8 + 6e-7, .6 + 8e-7, 0, 1, 0, 0, 10}},
                  {"a light so near that squares underflow",
                   {0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 3e-200, 4e-200, 0, 1e200, 0, 1}},
                  {"a light so far that squares overflow",
                   {0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 3e200, 4e200, 0, 1e-200, 0, 1}},
                  {"the light at the place", {1, 2, 3, 0, 0, 1, 0, 0, 9, 1, 2, 3, 1, 1, 1, 0}},
                  {"the eye at the place", {1, 2, 3, 0, 0, 1, 1, 2, 3, 0, 0, 9, 1, 1, 1, 0}},
                  {"no normal", {1, 2, 3, 0, 0, 0, 0, 0, 9, 0, 9, 9, 1, 1, 1, 0}},
                  {"an exponent of 10^4 beside the mirror",
                   {0, 0, 0, 0, 0, 1, 1, 0, 100, 0, 0, 4, 1, 0, 0, 1e4}}}},
       {.name = "blinn_phong",
        .states = "highlight within 100 u max(1, n) / |L + V| of the light's full strength",
        .unit = "bounds",
        .bound = 1,
        .numbers = 16,
        .kinds = kinds,
        .generate = at_every_scale(generate, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}),
        .error = blinns_error,
        .traps = {{"viewer and light face to face", {0, 0, 0, 0, 0, 1, -3, 0, 1e-9, 3, 0, 1e-9, 1, 0, 0, 10}},
                  {"light from behind", {0, 0, 0, 0, 0, 1, 0, 0, 5, 1, 0, -4, 1, 0, 0, 2}}}},
       {.name = "spot",
        .states =
            "a spot's cone within (60 / (inner - outer) + 40 max(1, power) + 20) u; exactly 0 outside it",
        .unit = "bounds",
        .bound = 1,
        .numbers = 12,
        .kinds = kinds,
        .generate = at_every_scale(spots, {0, 1, 2, 3, 4, 5, 6, 7, 8}),
        .error = spots_error,
        .traps = {{"both cones are one", {0, 0, 0, 0, 3, 4, 0, -3, -4, 1, 1, 0}},
                  {"a place behind the spot", {0, 0, 9, 0, 0, 4, 0, 0, -1, 0, 1, 0}},
                  {"a hard edge", {1, 0, 0, 0, 0, 1, 0, 0, -1, 0.7071067811865476, 0.7071067811865476, 0}}}},
       {.name = "range",
        .states = "the end of a range within 20 u of 1; exactly 0 beyond it",
        .unit = "bounds",
        .bound = 1,
        .numbers = 2,
        .kinds = kinds,
        .generate = at_every_scale(ranges, {0, 1}),
        .error = ranges_error,
        .traps = {{"at the end", {4, 4}},
                  {"a little before it", {0x1.fffffffffffffp1, 4}},
                  {"a tiny range", {0x1p-1074, 0x1p-1073}}}},
       {.name = "area",
        .states = "a grid within 1.6 (sides squared) / (samples^2 d^4) of the whole rectangle's light",
        .unit = "bounds",
        .bound = 1,
        .numbers = 10,
        .kinds = {Kind::random, Kind::grazing, Kind::tiny},
        .generate = areas,
        .error = areas_error,
        .traps = {{"its back", {0, 0, 3, 1, 0, 0, 0, 1, 0, 4}},
                  {"right above", {0, 0, 3, 0, 1, 0, 1, 0, 0, 4}}}}}};
}

}  // namespace gradus::stress
