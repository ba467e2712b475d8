#pragma once
// How bright a place on a surface looks: Phong's model of ambient light, scattered light and highlights, with
// lamps that are points, far away, spots or rectangles. All colours are linear RGB.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <iterator>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "core/arithmetic/elementary.hpp"
#include "core/geometry.hpp"
#include "core/light.hpp"
#include "core/observe.hpp"

namespace gradus::illumination {

/// How much of the light that arrives a surface sends on. A Material can stand in its place.
template <std::floating_point C>
struct Reflectance {
  glm::vec<3, C> ambient{0}, diffuse{0}, specular{0};  ///< k_a, k_d, k_s, >= 0
  C shininess = 1;                                     ///< n: the exponent of the highlight, >= 0
  glm::vec<3, C> emission{0};                          ///< light of its own, >= 0
};

/// The colours that a surface is described with.
template <class M>
using ColourOf = std::remove_cvref_t<decltype(std::declval<const M&>().ambient)>;

/// The ambient part is known.
template <class T>
struct AmbientAdded {
  glm::vec<3, T> ambient;  ///< k_a I_a, and what the surface sends out itself
};

/// What of a lamp's light arrives at a place, all but its colour.
template <class T>
struct Arrival {
  glm::vec<3, T> to_light;  ///< L, of length 1; zero for a light at the very place
  T distance;               ///< 0 for a directional light
  T attenuation;            ///< what the distance leaves, in [0, 1]
  T window;                 ///< what the end of its range leaves, in [0, 1]
  T cone;                   ///< what a spot sends this way, in [0, 1]
  T facing;                 ///< the cosine at an area's point, over the number of its points; else 1
  bool seen;                ///< whether nothing stands between; not asked where nothing arrives anyway

  /// f: what is left of the intensity.
  constexpr T share() const { return seen ? attenuation * window * cone * facing : T(0); }
};

/// A lamp was looked at: a light, or one point of an area.
template <class T>
struct LampTaken {
  std::size_t light;  ///< its number
  int sample;         ///< the point's number, 0 but for areas
  Arrival<T> arrival;
};

/// Its two parts are added.
template <class T>
struct LightAdded {
  std::size_t light;  ///< its number
  int sample;         ///< the point's number, 0 but for areas
  Arrival<T> arrival;
  glm::vec<3, T> mirror;  ///< R, or Blinn's H, of length 1
  T n_dot_l;
  T cosine;  ///< of the highlight: R.V, or N.H
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

/// What the distance leaves of a lamp: 1 / (constant + linear d + quadratic d^2), at most 1.
/// Domain: 0 <= distance, finite. Accuracy: 3 ulp beside what d is off.
template <std::floating_point T>
T attenuation(const Light& light, T distance) {
  const T weakened = T(light.constant) + distance * (T(light.linear) + distance * T(light.quadratic));
  return weakened > T(1) ? T(1) / weakened : T(1);
}

/// What the end of the range leaves: (1 - (d / range)^4)^2, exactly 0 from d = range on, and exactly 1
/// without an end. Value and slope are 0 at the end, so that no edge is seen there. B. Karis, Real shading in
/// Unreal Engine 4, SIGGRAPH 2013 course notes, section on lighting. Domain: 0 <= distance, finite. Accuracy:
/// within 16 u of 1, beside what d is off.
template <std::floating_point T>
T range_window(const Light& light, T distance) {
  if (!(distance < T(light.range))) return T(0);
  const T part = distance / T(light.range);
  const T left = T(1) - (part * part) * (part * part);
  return left * left;
}

/// What a spot sends along -to_light: with the cosine c to its axis, t^2 (3 - 2 t) c^concentration, where t
/// goes from 0 on the outer cone to 1 on the inner one; exactly 0 from the outer cone on. 1 for other lights.
/// The power: D. R. Warn, Lighting controls for synthetic images, SIGGRAPH 1983, 13-21.
/// Domain: to_light of length 1. Accuracy: within (60 / (inner - outer) + 40 max(1, concentration) + 20) u
/// for a
///   concentration of 0, or of 1 and more; which side of a cone c is on, within 40 u.
template <std::floating_point T>
T spot_cone(const Light& light, glm::vec<3, T> to_light) {
  if (light.kind != Light::Kind::spot) return T(1);
  const T outer = T(light.outer_cosine), inner = T(light.inner_cosine);
  const T c = -glm::dot(to_light, unit_vector(glm::vec<3, T>(light.direction)));
  if (!(c > outer)) return T(0);
  const T t = c < inner ? (c - outer) / (inner - outer) : T(1);
  const T edge = t * t * (T(3) - T(2) * t);
  return light.concentration > 0 ? edge * pow(c > T(0) ? c : T(0), T(light.concentration)) : edge;
}

/// How many lamps a light counts as.
constexpr int lamps(const Light& light) {
  return light.kind == Light::Kind::area ? light.samples * light.samples : 1;
}

/// Where lamp k of a light stands: an area has them in the middles of a grid of samples x samples cells.
template <std::floating_point T>
glm::vec<3, T> point_of(const Light& light, int k) {
  using Vec = glm::vec<3, T>;
  if (light.kind != Light::Kind::area) return Vec(light.position);
  const T n = T(light.samples);
  const T u = (T(k % light.samples) + T(0.5)) / n - T(0.5);
  const T v = (T(k / light.samples) + T(0.5)) / n - T(0.5);
  return Vec(light.position) + u * Vec(light.across) + v * Vec(light.along);
}

/// What the slant of an area leaves, over the number of its points: the cosine at the lamp, 0 behind it.
template <std::floating_point T>
T facing(const Light& light, glm::vec<3, T> to_light) {
  using Vec = glm::vec<3, T>;
  if (light.kind != Light::Kind::area) return T(1);
  const Vec front = unit_vector(glm::cross(unit_vector(Vec(light.across)), unit_vector(Vec(light.along))));
  const T cosine = -glm::dot(front, to_light);
  return cosine > T(0) ? cosine / T(lamps(light)) : T(0);
}

/// From a place on the surface towards lamp k of a light, of length 1, and how far it is (0 for a directional
/// one, which is not weakened).
template <std::floating_point T>
std::pair<glm::vec<3, T>, T> towards(const Light& light, int k, glm::vec<3, T> place) {
  using Vec = glm::vec<3, T>;
  if (light.kind == Light::Kind::directional) return {unit_vector(-Vec(light.direction)), T(0)};
  const auto [direction, distance] = directed(point_of<T>(light, k) - place);
  return {direction, distance};
}

/// What of lamp k of a light arrives at the place.
template <std::floating_point T, class Visible>
Arrival<T> arriving(const Light& light, int k, glm::vec<3, T> place, Visible& visible) {
  const auto [l, d] = towards(light, k, place);
  Arrival<T> a{l,   d, attenuation(light, d), range_window(light, d), spot_cone(light, l), facing(light, l),
               true};
  const bool far = light.kind == Light::Kind::directional;
  if (a.share() > T(0)) a.seen = visible(place, l, far ? std::numeric_limits<T>::infinity() : d);
  return a;
}

/// One lamp of those that lights count as.
struct Lamp {
  const Light& light;
  std::size_t number;  ///< the light's
  int point;           ///< 0 but for areas
  const LinearRgb& intensity = light.intensity;

  /// What of it arrives at the place.
  template <std::floating_point T, class Visible>
  Arrival<T> at(glm::vec<3, T> place, Visible& visible) const {
    return arriving(light, point, place, visible);
  }
  /// What is told of it once its parts are known.
  template <class T, class Vec = glm::vec<3, T>>
  LightAdded<T> added(const Arrival<T>& arrival, Vec mirror, T n_dot_l, T cosine, Vec diffuse,
                      Vec specular) const {
    return {number, point, arrival, mirror, n_dot_l, cosine, diffuse, specular};
  }
};

/// The lamps of some lights, in their order, as a range.
class Lamps {
 public:
  explicit Lamps(std::span<const Light> lights) : lights_(lights) {}

  class Iterator {
   public:
    explicit Iterator(std::span<const Light> lights) : lights_(lights) {}
    Lamp operator*() const { return {lights_[number_], number_, point_}; }
    Iterator& operator++() {
      if (++point_ < lamps(lights_[number_])) return *this;
      point_ = 0;
      ++number_;
      return *this;
    }
    bool operator==(std::default_sentinel_t) const { return number_ == lights_.size(); }

   private:
    std::span<const Light> lights_;
    std::size_t number_ = 0;
    int point_ = 0;
  };
  Iterator begin() const { return Iterator(lights_); }
  std::default_sentinel_t end() const { return {}; }

 private:
  std::span<const Light> lights_;
};

inline Lamps every(std::span<const Light> lights) { return Lamps(lights); }

/// The direction in which light from `to_light` leaves a mirror with this normal: 2 (N.L) N - L.
template <class T>
glm::vec<3, T> reflected(glm::vec<3, T> normal, glm::vec<3, T> to_light) {
  return T(2) * glm::dot(normal, to_light) * normal - to_light;
}

/// Nothing stands between a place and a lamp.
struct AllSeen {
  template <class T>
  constexpr bool operator()(glm::vec<3, T>, glm::vec<3, T>, T) const {
    return true;
  }
};

/// Phong's illumination of one place: k_a I_a + sum over the lamps of f I (k_d N.L + k_s (R.V)^n), with the
/// share f that arrives and R the mirrored L. A lamp behind the surface (N.L <= 0) adds neither part. The
/// highlight has k_s and the light's colour, not the surface's. An area counts as samples^2 lamps.
/// B. T. Phong, Illumination for computer generated pictures, Communications of the ACM 18(6), 1975, 311-317.
///
/// place: on the surface. N: its normal, of length 1, on the viewer's side; zero has no diffuse part and no
///   highlight. eye: where the viewer stands. k: a Reflectance or what has its members. lights: see
///   core/light.hpp. ambient: I_a. seen(place, L, d): whether light comes to the place from the direction
///   L, of length 1, over the distance d, infinite for a directional light; asked once for each
///   lamp whose range and cone reach the place.
///
/// Domain: finite values of any size whose differences don't overflow, nor the ways' lengths. A light or an
///   eye at the very place adds nothing, or no highlight. R.V <= 0 gives no highlight, also for n = 0. Sums
///   above 1 are not cut off here.
/// Steps: AmbientAdded (LampTaken LightAdded)* Finished, both for every lamp.
/// Accuracy: u is the rounding unit of T (2^-53 for double), and a light's full strength what it would add
///   with N.L = 1, or R.V = 1: f I k_d, f I k_s. Of the sum of these the diffuse part is within 30 u, the
///   highlight within 60 u max(1, n). A light at the horizon, which adds little, may be wrong in most of
///   that little. (With 0 < n < 1, whose power is steep at 0, within 60 u / R.V.) Each light beyond the first
///   adds a u. Where N.L or R.V is within 40 u of 0 there may be a highlight or none. The ambient part is
///   computed in the material's scalar: k_a I_a and its sum with the emission are rounded once each. A range
///   adds 20 u of its light's strength without it, a spot what spot_cone is off. An area in front of the
///   place, before the horizon and not cut off by its range misses the light of the whole rectangle by at
///   most 1.6 (|across|^2 + |along|^2) / (samples^2 d^4), d the smallest distance, of its strength with
///   quadratic attenuation 1.
/// Cost: a square root for each lamp and for the viewer, a power where there is a highlight.
/// Errors: none.
template <std::floating_point T, class M, class Visible,
          Observer<AmbientAdded<T>, LampTaken<T>, LightAdded<T>, Finished<T>> O = Unobserved>
Parts<T> phong(glm::vec<3, T> place, glm::vec<3, T> N, glm::vec<3, T> eye, const M& k,
               std::span<const Light> lights, ColourOf<M> ambient, Visible&& seen, O&& observer = {}) {
  using Vec = glm::vec<3, T>;
  Vec diffuse{T(0)}, specular{T(0)};
  // Light from everywhere
  auto even = k.ambient * ambient;
  const Vec base(k.emission + even);
  if constexpr (observed<O>) observer(AmbientAdded<T>{base});
  auto V = unit_vector(eye - place);
  const Vec kd(k.diffuse);
  const Vec ks(k.specular);
  const T n(k.shininess);
  for (Lamp lamp : every(lights)) {
    auto a = lamp.at(place, seen);
    if constexpr (observed<O>) observer(LampTaken<T>{lamp.number, lamp.point, a});
    const Vec L = a.to_light;
    const Vec R = reflected(N, L);
    const T NL = glm::dot(N, L);
    const T RV = glm::dot(R, V);
    // Both parts; none from behind
    T d{0}, s{0};
    if (NL > 0) {
      d = NL;
      if (RV > 0 && ks != Vec(0)) {
        s = pow(RV, n);
      }
    }
    const T f = a.share();
    const Vec I(lamp.intensity);
    diffuse += f * I * (d * kd);
    specular += f * I * (s * ks);
    if constexpr (observed<O>) observer(lamp.added(a, R, NL, RV, f * I * (d * kd), f * I * (s * ks)));
  }
  if constexpr (observed<O>) observer(Finished<T>{base, diffuse, specular});
  return {base, diffuse, specular};
}

/// The same where nothing stands between the place and the lamps.
template <std::floating_point T, class M>
Parts<T> phong(glm::vec<3, T> place, glm::vec<3, T> N, glm::vec<3, T> eye, const M& k,
               std::span<const Light> lights, ColourOf<M> ambient) {
  return phong(place, N, eye, k, lights, ambient, AllSeen{});
}

/// Phong's illumination of a surface without a highlight (k_s = 0), nothing standing between it and the
/// lamps: what phong gives, without asking where the viewer stands.
///
/// place, N, k, lights, ambient: as for phong.
///
/// Domain: as for phong; k_s is 0.
/// Steps: none.
/// Accuracy: the bits of phong.
/// Cost: a square root for each lamp.
/// Errors: none.
template <std::floating_point T, class M>
Parts<T> matte(glm::vec<3, T> place, glm::vec<3, T> N, const M& k, std::span<const Light> lights,
               ColourOf<M> ambient) {
  using Vec = glm::vec<3, T>;
  Vec diffuse{T(0)};
  // Light from everywhere
  auto even = k.ambient * ambient;
  const Vec base(k.emission + even);
  const Vec kd(k.diffuse);
  AllSeen seen;
  for (Lamp lamp : every(lights)) {
    auto a = lamp.at(place, seen);
    const T NL = glm::dot(N, a.to_light);
    const T d = NL > 0 ? NL : T(0);
    diffuse += a.share() * Vec(lamp.intensity) * (d * kd);
  }
  return {base, diffuse, Vec{T(0)}};
}

/// Blinn's highlight in Phong's model: (N.H)^n in place of (R.V)^n, with H halfway between L and V. It is
/// about as wide as Phong's with a quarter of the exponent, and never cut off before the horizon.
/// J. F. Blinn, Models of light reflection for computer synthesized pictures, SIGGRAPH 1977, 192-198.
///
/// place, N, eye, k, lights, ambient, seen: as for phong.
///
/// Domain: as for phong. Where L = -V there is no highlight.
/// Steps: as for phong, with H and N.H.
/// Accuracy: as for phong, the highlight within 100 u max(1, n) / |L + V|.
/// Cost: as for phong, and a square root more a lamp.
/// Errors: none.
template <std::floating_point T, class M, class Visible,
          Observer<AmbientAdded<T>, LampTaken<T>, LightAdded<T>, Finished<T>> O = Unobserved>
Parts<T> blinn_phong(glm::vec<3, T> place, glm::vec<3, T> N, glm::vec<3, T> eye, const M& k,
                     std::span<const Light> lights, ColourOf<M> ambient, Visible&& seen, O&& observer = {}) {
  using Vec = glm::vec<3, T>;
  Vec diffuse{T(0)}, specular{T(0)};
  // Light from everywhere
  auto even = k.ambient * ambient;
  const Vec base(k.emission + even);
  if constexpr (observed<O>) observer(AmbientAdded<T>{base});
  auto V = unit_vector(eye - place);
  const Vec kd(k.diffuse);
  const Vec ks(k.specular);
  const T n(k.shininess);
  for (Lamp lamp : every(lights)) {
    auto a = lamp.at(place, seen);
    if constexpr (observed<O>) observer(LampTaken<T>{lamp.number, lamp.point, a});
    const Vec L = a.to_light;
    auto H = unit_vector(L + V);
    const T NL = glm::dot(N, L);
    const T NH = glm::dot(N, H);
    // Both parts; none from behind
    T d{0}, s{0};
    if (NL > 0) {
      d = NL;
      if (NH > 0 && ks != Vec(0)) {
        s = pow(NH, n);
      }
    }
    const T f = a.share();
    const Vec I(lamp.intensity);
    diffuse += f * I * (d * kd);
    specular += f * I * (s * ks);
    if constexpr (observed<O>) observer(lamp.added(a, H, NL, NH, f * I * (d * kd), f * I * (s * ks)));
  }
  if constexpr (observed<O>) observer(Finished<T>{base, diffuse, specular});
  return {base, diffuse, specular};
}

}  // namespace gradus::illumination
