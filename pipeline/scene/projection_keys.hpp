#pragma once
// What a scene's file says of the projection, and which of it belongs together.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "core/arithmetic/elementary.hpp"
#include "scene/choices.hpp"
#include "scene/view.hpp"

namespace gradus::pipeline {

/// Reads projection, height, receding and foreshortening of a camera into a view, and refuses keys that
/// another projection has.
///
/// Values, Found: of the reader of scenes, which tells mistakes. at: the camera.
/// Domain: any object. Accuracy: the nearest doubles. Cost: none to speak of. Errors: those of Values.
template <class Values, class Found>
void take_projection(const Values& values, const Found& at, View& view) {
  if (const auto name = Values::member(at, "projection"))
    view.projection = static_cast<Projection3d>(values.choice(*name, projection_names));
  const std::string_view called = projection_names[static_cast<std::size_t>(view.projection)];
  const auto only = [&](std::string_view key, bool has) {
    const auto found = Values::member(at, key);
    if (found && !has)
      values.refuse(*found, fmt::format("no key \"{}\" beside the projection {}", key, called), "one");
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

}  // namespace gradus::pipeline
