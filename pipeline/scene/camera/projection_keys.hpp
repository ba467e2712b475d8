#pragma once
// What a scene's file says of the projection, and which of it belongs together.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "core/arithmetic/elementary.hpp"
#include "scene/camera/view.hpp"
#include "scene/choices.hpp"

namespace gradus::pipeline {

/// What an angle of view has to be.
inline std::string expected_angle() {
  return fmt::format("the vertical angle of view, {} to {} degrees", least_degrees, most_degrees);
}

/// Refuses a key that a projection has no use for.
template <class Values, class Found>
[[noreturn]] void refuse_beside(const Values& values, const Found& at, std::string_view key,
                                Projection3d projection) {
  const std::string_view called = projection_names[static_cast<std::size_t>(projection)];
  values.refuse(at, fmt::format("no key \"{}\" beside the projection {}", key, called), "one");
}

/// An angle of view, from degrees.
template <class Values, class Found>
double angle_of_view(const Values& values, const Found& at) {
  return radians_from_degrees(values.number_in(at, least_degrees, most_degrees, expected_angle()));
}

/// Reads projection, height, receding and foreshortening of a camera into a view, and refuses keys that
/// another projection has.
///
/// Values, Found: of the reader of scenes, which tells mistakes. at: the camera.
/// Domain: any object. Accuracy: the nearest doubles. Cost: none to speak of. Errors: those of Values.
template <class Values, class Found>
void take_projection(const Values& values, const Found& at, View& view) {
  if (const auto name = Values::member(at, "projection"))
    view.projection = static_cast<Projection3d>(values.choice(*name, projection_names));
  const auto only = [&](std::string_view key, bool has) {
    const auto found = Values::member(at, key);
    if (found && !has) refuse_beside(values, *found, key, view.projection);
    return found;
  };
  const bool parallel = !has_eye(view.projection);
  const bool oblique = leans(view.projection);
  for (const std::string_view key : {"fov", "focal", "sensor"}) only(key, !parallel);
  if (const auto height = only("height", parallel)) view.height = values.above_zero(*height);
  if (const auto angle = only("receding", oblique))
    view.receding_radians =
        radians_from_degrees(values.number_in(*angle, -360, 360, "an angle of -360 to 360 degrees"));
  if (const auto factor = only("foreshortening", oblique))
    view.foreshortening = values.number_in(*factor, 0, 100, "how long a unit of depth is drawn, 0 to 100");
}

/// The angle of view, told or by what a camera's lens and film make of it.
///
/// Values, Found, at: as above. Domain: any object. Accuracy: 0.501 ulp. Cost: none to speak of. Errors:
/// those of Values.
template <class Values, class Found>
void take_lens(const Values& values, const Found& at, View& view) {
  const auto fov = Values::member(at, "fov"), focal = Values::member(at, "focal"),
             sensor = Values::member(at, "sensor");
  double& radians = view.vertical_radians;
  if (fov) {
    if (focal) values.refuse(*focal, "either an angle of view or a focal length", "both");
    if (sensor) values.refuse(*sensor, "either an angle of view or a sensor", "both");
    radians = angle_of_view(values, *fov);
  } else if (focal || sensor) {
    const double length = values.above_zero(values.needed(at, "focal"));
    const double height = values.above_zero(values.needed(at, "sensor"));
    radians = 2 * atan2(height / 2, length);
    if (!(radians_from_degrees(least_degrees) <= radians && radians <= radians_from_degrees(most_degrees)))
      values.refuse(*focal, expected_angle(), fmt::format("{:.3g}", radians / radians_from_degrees(1)));
  }
}

}  // namespace gradus::pipeline
