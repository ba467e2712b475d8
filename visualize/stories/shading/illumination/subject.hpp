#pragma once
// What a story of illumination is about: a place on a surface, who looks at it, and the lamps.

#include <string>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/colour.hpp"
#include "shading/illumination/illumination.hpp"
#include "stories/telling.hpp"

namespace gradus::illumination {

using Surface = Reflectance<double>;

struct Subject {
  dvec3 place, normal, eye;
  Surface surface;
  std::vector<Light> lights{};

  std::span<const Light> lamps() const { return lights; }
};

/// A number that may not be negative.
inline double share(const Arguments& arguments, std::string_view name) {
  const double value = arguments.number(name).value_or(0);
  if (value < 0) refuse(name, "expected 0 or more, found {}", value);
  return value;
}

inline Surface surface_of(const Arguments& arguments) {
  const dvec3 colour(linear_from_srgb8(arguments.color("colour")));
  return {.ambient = share(arguments, "ka") * colour,
          .diffuse = share(arguments, "kd") * colour,
          .specular = dvec3{share(arguments, "ks")},
          .shininess = share(arguments, "shininess")};
}

inline Light::Kind kind_of(const Arguments& arguments) {
  const std::string& name = arguments.text("kind");
  if (name == "directional") return Light::Kind::directional;
  if (name == "spot") return Light::Kind::spot;
  return name == "area" ? Light::Kind::area : Light::Kind::point;
}

/// A square with its middle where the lamp is, across the way to where it points.
inline void spread(Light& light, double size) {
  const dvec3 front = unit_vector(light.direction);
  const dvec3 aside = std::abs(front.x) < 0.9 ? dvec3{1, 0, 0} : dvec3{0, 1, 0};
  const dvec3 across = unit_vector(glm::cross(aside, front));
  light.across = size * across;
  light.along = size * glm::cross(front, across);
}

/// What all lamps have in common.
inline Light lamp_of(const Arguments& arguments) {
  Light light;
  light.kind = kind_of(arguments);
  const std::vector<double> weakening = arguments.numbers("attenuation");
  light.constant = weakening[0], light.linear = weakening[1], light.quadratic = weakening[2];
  if (weakening[0] < 0 || weakening[1] < 0 || weakening[2] < 0 ||
      weakening[0] + weakening[1] + weakening[2] == 0)
    refuse(arguments, {"attenuation"}, "expected numbers of 0 or more, not all 0");
  if (const auto range = arguments.number("range")) {
    if (!(*range > 0))
      refuse(arguments, {"range"}, fmt::format("expected a range above 0, found {}", *range));
    light.range = *range;
  }
  const std::vector<double> cone = arguments.numbers("cone");
  if (cone[0] < 0 || cone[0] > cone[1] || cone[1] > 180)
    refuse(arguments, {"cone"},
           fmt::format("expected angles from 0 to 180, the inner one first, found {},{}", cone[0], cone[1]));
  light.inner_cosine = sin_cos_degrees(cone[0]).cos;
  light.outer_cosine = sin_cos_degrees(cone[1]).cos;
  light.concentration = share(arguments, "concentration");
  light.samples = static_cast<int>(arguments.integer("samples"));
  return light;
}

/// A lamp at another position; it points where all do.
inline Light moved_to(dvec3 position, Light light, const Arguments& arguments) {
  light.position = position;
  light.direction = arguments.place("aim").value_or(*arguments.place("place")) - position;
  if (light.kind == Light::Kind::area) spread(light, share(arguments, "side"));
  return light;
}

inline Subject subject_of(const Arguments& arguments) {
  Subject subject{.place = *arguments.place("place"),
                  .normal = unit_vector(*arguments.place("normal")),
                  .eye = *arguments.place("eye"),
                  .surface = surface_of(arguments)};
  if (subject.normal == dvec3{0}) refuse(arguments, {"normal"}, "expected a normal with a direction");
  const Light pattern = lamp_of(arguments);
  for (const dvec3 position : arguments.places("lights")) {
    subject.lights.push_back(moved_to(position, pattern, arguments));
    const Light& light = subject.lights.back();
    if (light.kind != Light::Kind::point && light.direction == dvec3{0})
      refuse(arguments, {"aim", "lights"}, "expected lamps that point somewhere");
  }
  return subject;
}

/// With two or three digits, as drawings have room for.
inline std::string short_real(double value) {
  const std::string text = figure_real(std::abs(value) < 0.0005 ? 0 : std::round(value * 1000) / 1000);
  return std::isfinite(value) ? text : "NaN";
}
/// The same of a colour: one number where its three are alike.
inline std::string short_colour(const dvec3& c) {
  if (!(c.x == c.x && c.y == c.y && c.z == c.z)) return "NaN";
  if (c.x == c.y && c.y == c.z) return short_real(c.x);
  return figure_place(c, short_real);
}

inline constexpr double degrees_per_radian = 57.29577951308232;
inline double degrees_of(double cosine) { return acos(std::clamp(cosine, -1.0, 1.0)) * degrees_per_radian; }
inline std::string degrees_text(double value) { return figure_real(std::round(value * 10) / 10) + "°"; }

/// How far from a spot's axis the way to the place leads, in degrees.
inline double off_axis(const Light& spot, const Arrival<double>& arrival) {
  return degrees_of(-glm::dot(unit_vector(spot.direction), arrival.to_light));
}

}  // namespace gradus::illumination
