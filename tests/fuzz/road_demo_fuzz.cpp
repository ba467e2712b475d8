// Data of the demonstrations: whatever the bytes are, they are read as a film whose cameras stand somewhere
// and look somewhere, or refused in one line with the file's name.

#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/refusal.hpp"
#include "scene/road/road_demo.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

namespace {

bool finite(dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void expect_sound(const pipeline::RoadDemo& demo) {
  require(demo.entries.size() == pipeline::demo_keys, "every key once");
  require(demo.positions.size() == demo.uvs.size() && !demo.triangles.empty(), "a model");
  for (const auto& triangle : demo.triangles) {
    for (const int corner : triangle)
      require(0 <= corner && corner < std::ssize(demo.positions), "a corner is a vertex");
  }
  const int frames = frame_count(demo);
  require(1 <= frames && frames <= pipeline::most_demo_frames, "a film has frames");
  const ivec2 size = frame_size(demo);
  require(size.y == 512 && 64 <= size.x && size.x <= 4096, "a frame has a size");
  const Bounds bounds = bounds_of(pipeline::scene_of(demo, Image(1, 1)));
  for (const auto gaze : {pipeline::Gaze::forward, pipeline::Gaze::target}) {
    for (const int frame : {0, frames / 2, frames - 1}) {
      const pipeline::Aim aim = aim_at(demo, gaze, frame);
      const bool sees = leads_somewhere(aim) && tells_upright(aim);
      require(sees || gaze == pipeline::Gaze::target, "one looks forward everywhere");
      if (!sees) continue;
      const Camera camera = camera_at(demo, gaze, frame, bounds);
      require(finite(camera.frame.eye) && finite(camera.frame.forward), "a camera stands somewhere");
      require(0 < camera.lens.near && camera.lens.near < camera.lens.far, "far lies behind near");
      require(0 < camera.lens.vertical_radians && camera.lens.vertical_radians < 3.1416, "an angle of view");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    expect_sound(pipeline::parse_road_demo(text, "d.json"));
  } catch (const InputError& error) {
    const std::string_view what = error.what();
    require(what.starts_with("d.json:"), "a mistake has its file");
    require(test::harmless(what), "a message is safe to show");
  }
  return 0;
}
