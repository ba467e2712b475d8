#include "scene/camera/camera_path.hpp"

#include <algorithm>

#include "core/arithmetic/elementary.hpp"

namespace gradus::pipeline {

View view_at(const CameraPath& path, View beside, double frame) {
  const auto take = [&](const auto& track, auto& into) {
    if (!track.empty()) into = value_at(track, frame, path.interpolation);
  };
  take(path.eye, beside.eye);
  take(path.target, beside.target);
  take(path.up, beside.up);
  take(path.vertical_radians, beside.vertical_radians);
  if (!path.vertical_radians.empty()) {
    beside.vertical_radians = std::clamp(beside.vertical_radians, radians_from_degrees(least_degrees),
                                         radians_from_degrees(most_degrees));
  }
  return beside;
}

}  // namespace gradus::pipeline
