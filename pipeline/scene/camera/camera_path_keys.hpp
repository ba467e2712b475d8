#pragma once
// What a scene's file says of a camera that moves, and which of it belongs together.

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "scene/camera/camera_path.hpp"
#include "scene/camera/projection_keys.hpp"

namespace gradus::pipeline {

/// The most keys of a path.
inline constexpr std::size_t most_keys = 10'000;

/// Reads the keys of a camera that moves. Values, Found: of the reader of scenes, which tells mistakes.
template <class Values, class Found>
class PathReader {
 public:
  /// camera: with a path. view: what stands beside it.
  PathReader(const Values& values, const Found& camera, const View& view)
      : values_(values), camera_(camera), view_(view) {}

  CameraPath read(const Found& at) {
    const auto keys = values_.elements(at, "a list of at least two keys", most_keys);
    if (keys.size() < 2) values_.refuse(at, "a list of at least two keys");
    if (const auto how = Values::member(camera_, "interpolation"))
      path_.interpolation = static_cast<Interpolation>(values_.choice(*how, interpolation_names));
    for (const Found& key : keys) take(key);
    if (path_.eye.empty() && !view_.eye)
      values_.refuse(at, "an eye beside the path, or in at least one of its keys", "none");
    return path_;
  }

 private:
  void take(const Found& key) {
    values_.members(key, {"frame", "eye", "target", "up", "fov"});
    const Found at = values_.needed(key, "frame");
    const int frame = values_.whole(at, 0, most_frame);
    if (any_ && frame <= path_.last)
      values_.refuse(at, fmt::format("a frame after {}, that of the key before", path_.last));
    if (!any_) path_.first = frame;
    path_.last = frame;
    any_ = true;
    const auto vector = [&](const Found& value) { return values_.vector(value); };
    const auto direction = [&](const Found& value) { return values_.direction(value); };
    add(key, "eye", path_.eye, vector);
    add(key, "target", path_.target, vector);
    add(key, "up", path_.up, direction);
    add(key, "fov", path_.vertical_radians, [&](const Found& value) { return angle(value); });
  }

  template <class Value, class Reading>
  void add(const Found& key, std::string_view name, Track<Value>& track, const Reading& reading) {
    const auto value = Values::member(key, name);
    if (!value) return;
    if (Values::member(camera_, name))
      values_.refuse(*value, fmt::format("no key \"{}\" in a path with one beside it", name), "one");
    track.push_back({path_.last, reading(*value)});
  }

  double angle(const Found& at) const {
    if (!has_eye(view_.projection)) refuse_beside(values_, at, "fov", view_.projection);
    if (Values::member(camera_, "focal"))
      values_.refuse(at, "no key \"fov\" in a path with a focal length beside it", "one");
    return angle_of_view(values_, at);
  }

  const Values& values_;
  const Found& camera_;
  const View& view_;
  CameraPath path_{};
  bool any_ = false;
};

/// Reads path and interpolation of a camera.
///
/// Values, Found: of the reader of scenes. at: the camera. view: what was read of it.
/// Domain: any object. Accuracy: the nearest doubles. Cost: that of the keys. Errors: those of Values.
template <class Values, class Found>
std::optional<CameraPath> camera_path_in(const Values& values, const Found& at, const View& view) {
  if (const auto path = Values::member(at, "path")) return PathReader(values, at, view).read(*path);
  if (const auto how = Values::member(at, "interpolation"))
    values.refuse(*how, "no key \"interpolation\" without a path", "one");
  return std::nullopt;
}

}  // namespace gradus::pipeline
