#include "engine/pixel_colours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/arithmetic/power_bounds.hpp"
#include "shading/illumination/illumination.hpp"

namespace gradus::pipeline::engine {
namespace {

// --- Directions ----------------------------------------------------------------------------------

/// Whether squares of the components, their sums and quotients keep all digits, so that scaling a vector
/// first changes no bit of its direction.
bool is_ordinary(const dvec3& v) {
  const auto fits = [](double x) {
    const double size = std::abs(x);
    return size <= 0x1p200 && (size >= 0x1p-200 || size == 0);
  };
  return fits(v.x) && fits(v.y) && fits(v.z);
}

/// The bits of gradus::directed.
Directed<double> quickly_directed(const dvec3& v) {
  if (!is_ordinary(v)) return directed(v);
  const double length = std::sqrt(glm::dot(v, v));
  if (length == 0) return {v, 0};
  return {v / length, length};
}

/// The bits of unit_vector.
inline dvec3 quick_unit_vector(const dvec3& v) {
  return is_ordinary(v) ? quickly_directed(v).direction : unit_vector(v);
}

// --- What bounds need ----------------------------------------------------------------------------

/// Sums and products of such numbers grow with each of them, also when rounded.
bool only_adds(const LinearRgb& colour) {
  constexpr float most = 1e30f;
  const auto fits = [](float x) { return 0 <= x && x <= most; };
  return fits(colour.r) && fits(colour.g) && fits(colour.b);
}

/// illumination::spot_cone. c: the cosine to the axis.
Between cone_between(const Light& light, double c) {
  const double outer = light.outer_cosine, inner = light.inner_cosine;
  if (!(c > outer)) return {0, 0};
  const double t = c < inner ? (c - outer) / (inner - outer) : 1.0;
  const double edge = t * t * (3.0 - 2.0 * t);
  if (!(light.concentration > 0)) return {edge, edge};
  const Between power = power_bounds(c > 0 ? c : 0, light.concentration);
  return {edge * power.low, edge * power.high};
}

}  // namespace

/// The way to a lamp, and bounds of illumination::Arrival's share.
struct PixelColours::Arriving {
  dvec3 to_light;
  Between share;
};

/// Bounds of each part.
struct PixelColours::LightBetween {
  Parts low, high;

  void multiply(const LinearRgb& texel) {
    for (Parts* parts : {&low, &high}) {
      parts->ambient *= dvec3(texel);
      parts->diffuse *= dvec3(texel);
    }
  }
};

PixelColours::Lamps PixelColours::lamps_of(std::span<const Light> lights) {
  Lamps lamps{{}, true};
  for (const Light& light : lights) {
    lamps.add_only = lamps.add_only && only_adds(light.intensity);
    for (int k = 0; k < illumination::lamps(light); ++k) {
      Lamp lamp{&light,
                dvec3(light.intensity),
                illumination::point_of<double>(light, k),
                {},
                0,
                light.range * light.range * (1 + 0x1p-40)};
      if (light.kind == Light::Kind::directional) {
        lamp.axis = unit_vector(-light.direction);
        lamp.share = illumination::attenuation(light, 0.0) * illumination::range_window(light, 0.0);
      }
      if (light.kind == Light::Kind::spot) lamp.axis = unit_vector(light.direction);
      if (light.kind == Light::Kind::area)
        lamp.axis = unit_vector(glm::cross(unit_vector(light.across), unit_vector(light.along)));
      lamps.all.push_back(lamp);
    }
  }
  return lamps;
}

/// Whether a lamp surely adds zeros: it is behind the surface, or beyond its range. to_lamp: with its length.
bool PixelColours::is_idle(const Lamp& lamp, const dvec3& normal, const dvec3& to_lamp) {
  const double square = glm::dot(to_lamp, to_lamp), along = glm::dot(normal, to_lamp);
  // By more than rounding
  const bool behind = along < 0 && along * along > 0x1p-80 * square;
  return (behind || square > lamp.most_square) && is_ordinary(to_lamp);
}

PixelColours::Arriving PixelColours::arriving(const Lamp& lamp, const dvec3& to_lamp) {
  const Light& light = *lamp.light;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto [l, d] = quickly_directed(to_lamp);
  const bool endless = light.range == infinity && d < infinity;
  const double share =
      illumination::attenuation(light, d) * (endless ? 1.0 : illumination::range_window(light, d));
  if (light.kind == Light::Kind::point) return {l, {share, share}};
  const double cosine = -glm::dot(l, lamp.axis);
  if (light.kind == Light::Kind::spot) {
    const Between cone = cone_between(light, cosine);
    return {l, {share * cone.low, share * cone.high}};
  }
  const double facing = cosine > 0 ? cosine / double{illumination::lamps(light) * 1.0} : 0.0;
  return {l, {share * facing, share * facing}};
}

/// illumination::phong and matte: their operations in their order, with both bounds. A lamp that adds zeros
/// is left out.
PixelColours::LightBetween PixelColours::lit(const Lamps& lamps, const Material& m, bool shines,
                                             const Surface& at, const Scene& scene) {
  const LinearRgb even = m.ambient * scene.ambient;
  const dvec3 base(m.emission + even), kd(m.diffuse), ks(m.specular), n = at.normal;
  const dvec3 v = shines ? quick_unit_vector(viewer_of(scene.camera, at.place) - at.place) : dvec3(0);
  LightBetween light{{base, {}, {}}, {base, {}, {}}};
  light.low.diffuse = light.high.diffuse = light.low.specular = light.high.specular = dvec3(0);
  for (const Lamp& lamp : lamps.all) {
    const bool far = lamp.light->kind == Light::Kind::directional;
    const dvec3 to_lamp = lamp.place - at.place;
    if (!far && is_idle(lamp, n, to_lamp)) continue;
    const auto [l, share] = far ? Arriving{lamp.axis, {lamp.share, lamp.share}} : arriving(lamp, to_lamp);
    const double nl = glm::dot(n, l);
    if (!(nl > 0)) continue;
    const dvec3 low = share.low * lamp.intensity, high = share.high * lamp.intensity, scattered = nl * kd;
    light.low.diffuse += low * scattered;
    light.high.diffuse += high * scattered;
    if (!shines) continue;
    const double rv = glm::dot(illumination::reflected(n, l), v);
    if (!(rv > 0)) continue;
    const Between power = power_bounds(rv, double{m.shininess});
    light.low.specular += low * (power.low * ks);
    light.high.specular += high * (power.high * ks);
  }
  return light;
}

const PixelColours::Lamps& PixelColours::lamps_of(const SceneLight::Lights& lights) {
  const auto [known, is_new] = known_.try_emplace(&lights);
  if (is_new) known->second = lamps_of(lights.reaching);
  return known->second;
}

LinearRgb PixelColours::operator()(SceneLight& light, const Fragment& f, const Triangle& t) {
  if (light.scene().shading != Shading::phong) return shaded(light, f, t).colour;
  const SceneLight::Lights& lights = light.lights_of(f.id.object);
  const Lamps& lamps = lamps_of(lights);
  const Material& m = light.material(f);
  if (!lamps.add_only || !only_adds(m.diffuse) || !only_adds(m.specular)) return shaded(light, f, t).colour;
  const auto at = [](const TriangleCorner& c) { return c.world.at; };
  const auto normal = [](const TriangleCorner& c) { return c.normal; };
  const auto texture = [](const TriangleCorner& c) { return c.texture; };
  const Surface here{mean<dvec3>(f, t, at), quick_unit_vector(mean<dvec3>(f, t, normal))};
  light.count_lamps(lights, m);
  const bool shines = !light.is_matte(m) && m.specular != LinearRgb(0);
  LightBetween between = lit(lamps, m, shines, here, light.scene());
  const std::optional<LinearRgb> texel = light.texel(f, t, mean<dvec2>(f, t, texture));
  if (texel) between.multiply(*texel);
  const LinearRgb low(between.low.sum()), high(between.high.sum());
  if (low == high) return low;
  // In doubt
  Parts parts = light.lit(lights, m, here);
  if (texel) {
    parts.ambient *= dvec3(*texel);
    parts.diffuse *= dvec3(*texel);
  }
  return LinearRgb(parts.sum());
}

}  // namespace gradus::pipeline::engine
