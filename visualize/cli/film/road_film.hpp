#pragma once
// The view from a car on a circular road: what `gradus demo` draws.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/image.hpp"
#include "engine/buffers.hpp"
#include "figure/colophon.hpp"
#include "scene/road/road_demo.hpp"

namespace gradus::cli {

/// What the demonstrations are called, and what they show.
struct DemoName {
  std::string_view name, what;
};
inline constexpr DemoName demo_names[]{
    {"forward", "the camera on the car looks along the road"},
    {"target", "it looks at one place all the time"},
    {"both", "both, side by side"},
};

/// One of these films, frame by frame.
class RoadFilm {
 public:
  /// which: a number into demo_names. Errors: InputError for a camera that looks nowhere in some frame; name:
  /// how it calls the data.
  RoadFilm(pipeline::RoadDemo demo, Image texture, std::size_t which, const std::string& name);

  std::size_t frames() const { return static_cast<std::size_t>(frame_count(demo_)); }
  /// Whether each frame has both demonstrations side by side.
  bool is_double() const { return gazes_.size() == 2; }
  const pipeline::RoadDemo& demo() const { return demo_; }
  /// Domain: i < frames(). From any thread.
  Image frame(std::size_t i) const;

 private:
  Image seen(pipeline::Gaze gaze, int frame) const;

  pipeline::RoadDemo demo_;
  pipeline::Scene scene_;
  pipeline::engine::Buffers buffers_;
  Bounds bounds_;
  std::vector<pipeline::Gaze> gazes_;
};

/// Five frames from the first to the last, each half as wide and high, in a row; those of both demonstrations
/// in two rows. frames: at least one, each of the film's size.
Image strip_of(const std::vector<Image>& frames, bool both);
/// Which frames a strip shows.
std::vector<std::size_t> frames_in_strip(std::size_t count);

}  // namespace gradus::cli
