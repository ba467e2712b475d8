#pragma once
// Exhibits: Phong's model as lecture notes and programs write it, kept so that figures can show what goes
// wrong. Never use them to shade; illumination.hpp has the right one.

#include "shading/illumination/illumination.hpp"

namespace gradus::illumination {

/// The colour of the surface alone: its diffuse part, the largest component 1.
template <class M>
ColourOf<M> hue(const M& material) {
  const auto& c = material.diffuse;
  const auto largest = std::max({c.x, c.y, c.z});
  return largest > 0 ? c / largest : ColourOf<M>{1};
}

/// A dot product, none below 0.
template <class T>
T clamped(T dot) {
  return dot > T(0) ? dot : T(0);
}

/// FAULTY: the formulas without max(0, .) (errata E001-35). A lamp behind the surface makes it darker than
/// its ambient light; an even power of a negative R.V is a highlight on the far side, a broken one is NaN.
///
/// place, normal, eye, material, lights, ambient, visible: as for phong.
///
/// Domain, Steps: as for phong.
/// Accuracy: right only where N.L and R.V are positive.
/// Cost: as for phong.
/// Errors: none.
template <std::floating_point T, class M, class Visible,
          Observer<AmbientAdded<T>, LampTaken<T>, LightAdded<T>, Finished<T>> O = Unobserved>
Parts<T> unclamped(glm::vec<3, T> place, glm::vec<3, T> normal, glm::vec<3, T> eye, const M& material,
                   std::span<const Light> lights, ColourOf<M> ambient, Visible&& visible, O&& observer = {}) {
  using Vec = glm::vec<3, T>;
  Vec diffuse{T(0)}, specular{T(0)};
  auto even = material.ambient * ambient;
  const Vec base(material.emission + even);
  if constexpr (observed<O>) observer(AmbientAdded<T>{base});
  const Vec v = unit_vector(eye - place);
  const Vec kd(material.diffuse);
  const Vec ks(material.specular);
  std::size_t number = 0;
  for (const Light& light : lights) {
    const int m = lamps(light);
    for (int p = 0; p < m; ++p) {
      auto a =  // L, f: what arrives
          arriving(light, p, place, visible);
      if constexpr (observed<O>) observer(LampTaken<T>{number, p, a});
      const Vec l = a.to_light;
      const Vec r = reflected(normal, l);
      const T nl = glm::dot(normal, l);
      const T rv = glm::dot(r, v);
      const T f = a.share();
      const Vec i = f * Vec(light.intensity);
      // Negative, too: that is the fault
      const T k = nl;
      const T n = T(material.shininess);
      const T s = pow(rv, n);
      diffuse += i * (k * kd);
      specular += i * (s * ks);
      if constexpr (observed<O>) observer(LightAdded<T>{number, p, a, r, nl, rv, i * (k * kd), i * (s * ks)});
    }
    ++number;
  }
  if constexpr (observed<O>) observer(Finished<T>{base, diffuse, specular});
  return {base, diffuse, specular};
}

/// FAULTY: clamps each dot product alone (errata E001-36). A lamp behind the surface still makes a highlight
/// wherever its mirrored ray comes near the viewer; an exponent of 0 makes 0^0 = 1 of what was clamped.
///
/// place, normal, eye, material, lights, ambient, visible: as for phong.
///
/// Domain, Steps: as for phong.
/// Accuracy: right where N.L is positive and n is not 0.
/// Cost: as for phong.
/// Errors: none.
template <std::floating_point T, class M, class Visible,
          Observer<AmbientAdded<T>, LampTaken<T>, LightAdded<T>, Finished<T>> O = Unobserved>
Parts<T> light_behind(glm::vec<3, T> place, glm::vec<3, T> normal, glm::vec<3, T> eye, const M& material,
                      std::span<const Light> lights, ColourOf<M> ambient, Visible&& visible,
                      O&& observer = {}) {
  using Vec = glm::vec<3, T>;
  Vec diffuse{T(0)}, specular{T(0)};
  auto even = material.ambient * ambient;
  const Vec base(material.emission + even);
  if constexpr (observed<O>) observer(AmbientAdded<T>{base});
  const Vec v = unit_vector(eye - place);
  const Vec kd(material.diffuse);
  const Vec ks(material.specular);
  std::size_t number = 0;
  for (const Light& light : lights) {
    const int m = lamps(light);
    for (int p = 0; p < m; ++p) {
      auto a =  // L, f: what arrives
          arriving(light, p, place, visible);
      if constexpr (observed<O>) observer(LampTaken<T>{number, p, a});
      const Vec l = a.to_light;
      const Vec r = reflected(normal, l);
      const T nl = glm::dot(normal, l);
      const T rv = glm::dot(r, v);
      const T f = a.share();
      const Vec i = f * Vec(light.intensity);
      const T k = clamped(nl);
      // Nobody asks where the lamp is
      const T n = T(material.shininess);
      const T s = pow(clamped(rv), n);
      diffuse += i * (k * kd);
      specular += i * (s * ks);
      if constexpr (observed<O>) observer(LightAdded<T>{number, p, a, r, nl, rv, i * (k * kd), i * (s * ks)});
    }
    ++number;
  }
  if constexpr (observed<O>) observer(Finished<T>{base, diffuse, specular});
  return {base, diffuse, specular};
}

/// FAULTY: multiplies the highlight, too, by the colour of the surface (errata E001-37): a red ball gets a
/// red highlight, which no varnish and no plastic has.
///
/// place, normal, eye, material, lights, ambient, visible: as for phong.
///
/// Domain, Steps: as for phong.
/// Accuracy: right only on grey surfaces.
/// Cost: as for phong.
/// Errors: none.
template <std::floating_point T, class M, class Visible,
          Observer<AmbientAdded<T>, LampTaken<T>, LightAdded<T>, Finished<T>> O = Unobserved>
Parts<T> tinted_highlight(glm::vec<3, T> place, glm::vec<3, T> normal, glm::vec<3, T> eye, const M& material,
                          std::span<const Light> lights, ColourOf<M> ambient, Visible&& visible,
                          O&& observer = {}) {
  using Vec = glm::vec<3, T>;
  Vec diffuse{T(0)}, specular{T(0)};
  auto even = material.ambient * ambient;
  const Vec base(material.emission + even);
  if constexpr (observed<O>) observer(AmbientAdded<T>{base});
  const Vec v = unit_vector(eye - place);
  const Vec kd(material.diffuse);
  const Vec ks(material.specular);
  // The surface's colour once more
  const Vec ts = Vec(hue(material)) * ks;
  std::size_t number = 0;
  for (const Light& light : lights) {
    const int m = lamps(light);
    for (int p = 0; p < m; ++p) {
      auto a =  // L, f: what arrives
          arriving(light, p, place, visible);
      if constexpr (observed<O>) observer(LampTaken<T>{number, p, a});
      const Vec l = a.to_light;
      const Vec r = reflected(normal, l);
      const T nl = glm::dot(normal, l);
      const T rv = glm::dot(r, v);
      const T f = a.share();
      const Vec i = f * Vec(light.intensity);
      const T k = scattered(nl);
      const T s = mirrored(nl, rv, material);
      diffuse += i * (k * kd);
      specular += i * (s * ts);
      if constexpr (observed<O>) observer(LightAdded<T>{number, p, a, r, nl, rv, i * (k * kd), i * (s * ts)});
    }
    ++number;
  }
  if constexpr (observed<O>) observer(Finished<T>{base, diffuse, specular});
  return {base, diffuse, specular};
}

/// FAULTY: takes the lamp's position minus the normal for the direction to it (errata E002-13). It is what a
/// place at the tip of the normal sees: far from the origin every place is lit as if it lay there.
///
/// place, normal, eye, material, lights, ambient, visible: as for phong.
///
/// Domain, Steps: as for phong.
/// Accuracy: right only for a place whose position is its own normal: on the ball of radius 1 in the middle.
/// Cost: as for phong.
/// Errors: none.
template <std::floating_point T, class M, class Visible,
          Observer<AmbientAdded<T>, LampTaken<T>, LightAdded<T>, Finished<T>> O = Unobserved>
Parts<T> light_minus_normal(glm::vec<3, T> place, glm::vec<3, T> normal, glm::vec<3, T> eye,
                            const M& material, std::span<const Light> lights, ColourOf<M> ambient,
                            Visible&& visible, O&& observer = {}) {
  using Vec = glm::vec<3, T>;
  Vec diffuse{T(0)}, specular{T(0)};
  auto even = material.ambient * ambient;
  const Vec base(material.emission + even);
  if constexpr (observed<O>) observer(AmbientAdded<T>{base});
  const Vec v = unit_vector(eye - place);
  const Vec kd(material.diffuse);
  const Vec ks(material.specular);
  std::size_t number = 0;
  for (const Light& light : lights) {
    const int m = lamps(light);
    for (int p = 0; p < m; ++p) {
      // From the tip of the normal
      const Vec from = normal;
      auto a =  // L, f: what arrives
          arriving(light, p, from, visible);
      if constexpr (observed<O>) observer(LampTaken<T>{number, p, a});
      const Vec l = a.to_light;
      const Vec r = reflected(normal, l);
      const T nl = glm::dot(normal, l);
      const T rv = glm::dot(r, v);
      const T f = a.share();
      const Vec i = f * Vec(light.intensity);
      const T k = scattered(nl);
      const T s = mirrored(nl, rv, material);
      diffuse += i * (k * kd);
      specular += i * (s * ks);
      if constexpr (observed<O>) observer(LightAdded<T>{number, p, a, r, nl, rv, i * (k * kd), i * (s * ks)});
    }
    ++number;
  }
  if constexpr (observed<O>) observer(Finished<T>{base, diffuse, specular});
  return {base, diffuse, specular};
}

}  // namespace gradus::illumination
