#pragma once
// How bright a place on a surface looks: Phong's model of ambient light, scattered light and highlights. All
// colours are linear RGB.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/arithmetic/elementary.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/surface.hpp"

namespace gradus::illumination {

/// The ambient part is known.
template <class T>
struct AmbientAdded {
  glm::vec<3, T> ambient;  ///< k_a I_a, and what the surface sends out itself
};

/// One light was looked at.
template <class T>
struct LightAdded {
  std::size_t light;         ///< its number
  glm::vec<3, T> to_light;   ///< L, of length 1; zero for a light at the very place
  glm::vec<3, T> reflected;  ///< R, of length 1
  T n_dot_l, r_dot_v;
  T attenuation;  ///< what the distance leaves, in [0, 1]
  glm::vec<3, T> diffuse, specular;
};

/// The light that leaves towards the viewer.
template <class T>
struct Finished {
  glm::vec<3, T> ambient, diffuse, specular;
};

/// The parts of the light that leaves a surface towards the viewer; their sum is the colour.
template <class T>
struct Parts {
  glm::vec<3, T> ambient, diffuse, specular;

  constexpr glm::vec<3, T> sum() const { return ambient + diffuse + specular; }
};

/// What the distance leaves of a point light: 1 / (constant + linear d + quadratic d^2), at most 1.
/// Domain: 0 <= distance, finite. Accuracy: 3 ulp beside what d is off.
template <std::floating_point T>
T attenuation(const Light& light, T distance) {
  const T weakened = T(light.constant) + distance * (T(light.linear) + distance * T(light.quadratic));
  return weakened > T(1) ? T(1) / weakened : T(1);
}

/// The direction in which light from `to_light` leaves a mirror with this normal: 2 (N.L) N - L.
template <class T>
glm::vec<3, T> reflected(glm::vec<3, T> normal, glm::vec<3, T> to_light) {
  return T(2) * glm::dot(normal, to_light) * normal - to_light;
}

/// From a place on the surface towards a light, of length 1, and how far it is (0 for a directional one,
/// which is not weakened).
template <std::floating_point T>
std::pair<glm::vec<3, T>, T> towards(const Light& light, glm::vec<3, T> place) {
  using Vec = glm::vec<3, T>;
  if (light.kind == Light::Kind::directional) return {unit_vector(-Vec(light.direction)), T(0)};
  const auto [direction, distance] = directed(Vec(light.position) - place);
  return {direction, distance};
}

/// The share of the light that is scattered: N.L, none from behind.
template <std::floating_point T>
T scattered(T n_dot_l) {
  return n_dot_l > T(0) ? n_dot_l : T(0);
}

/// The share of the light in the highlight: (R.V)^n, none from behind and none away from R.
template <std::floating_point T>
T mirrored(T n_dot_l, T r_dot_v, const Material& material) {
  if (!(n_dot_l > T(0) && r_dot_v > T(0)) || material.specular == LinearRgb{0}) return T(0);
  return pow(r_dot_v, T(material.shininess));
}

/// Phong's illumination of one place: k_a I_a + sum over the lights of f I (k_d N.L + k_s (R.V)^n), with the
/// attenuation f and R the mirrored L. A light behind the surface (N.L <= 0) adds neither part. The highlight
/// has k_s and the light's colour, not the surface's.
/// B. T. Phong, Illumination for computer generated pictures, Communications of the ACM 18(6), 1975, 311-317.
///
/// place: on the surface. normal: of length 1, on the viewer's side; zero has no diffuse part and no
///   highlight. eye: where the viewer stands. ambient: I_a.
///
/// Domain: finite values of any size whose differences don't overflow, nor the ways' lengths. A light or an
///   eye at the very place adds nothing, or no highlight. R.V <= 0 gives no highlight, also for n = 0. Sums
///   above 1 are not cut off here.
/// Steps: AmbientAdded LightAdded* Finished, a LightAdded for every light.
/// Accuracy: u is the rounding unit of T (2^-53 for double), and a light's full strength what it would add
///   with N.L = 1, or R.V = 1: f I k_d, f I k_s. Of the sum of these the diffuse part is within 30 u, the
///   highlight within 60 u max(1, n); so a light at the horizon, which adds little, may be wrong in most of
///   that little. (With 0 < n < 1, whose power is steep at 0, within 60 u / R.V.) Each light beyond the first
///   adds a u. Where N.L or R.V is within 40 u of 0 there may be a highlight or none. The ambient part is
///   computed in float: k_a I_a and its sum with the emission are rounded once each.
/// Cost: a square root for each light and for the viewer, a power where there is a highlight.
/// Errors: none.
template <std::floating_point T, Observer<AmbientAdded<T>, LightAdded<T>, Finished<T>> O = Unobserved>
Parts<T> phong(glm::vec<3, T> place, glm::vec<3, T> normal, glm::vec<3, T> eye, const Material& material,
               std::span<const Light> lights, LinearRgb ambient, O&& observer = {}) {
  using Vec = glm::vec<3, T>;
  Vec diffuse{T(0)}, specular{T(0)};
  // Light that comes from everywhere
  LinearRgb even = material.ambient * ambient;
  const Vec base(material.emission + even);
  if constexpr (observed<O>) observer(AmbientAdded<T>{base});
  const Vec v = unit_vector(eye - place);
  std::size_t number = 0;
  for (const Light& light : lights) {
    const auto [l, d] = towards(light, place);
    const T f = attenuation(light, d);
    const Vec r = reflected(normal, l);
    const T nl = glm::dot(normal, l);
    const T rv = glm::dot(r, v);
    // Both parts; none from behind
    const Vec i = f * Vec(light.intensity);
    const T k = scattered(nl);
    const Vec kd = k * Vec(material.diffuse);
    const T s = mirrored(nl, rv, material);
    const Vec ks = s * Vec(material.specular);
    diffuse += i * kd;
    specular += i * ks;
    if constexpr (observed<O>) observer(LightAdded<T>{number, l, r, nl, rv, f, i * kd, i * ks});
    ++number;
  }
  if constexpr (observed<O>) observer(Finished<T>{base, diffuse, specular});
  return {base, diffuse, specular};
}

}  // namespace gradus::illumination
