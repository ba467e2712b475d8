// What adaptive antialiasing takes beside one sample a pixel, on the scenes of the comparison with llvmpipe.

#include <fmt/format.h>

#include "benchmark/pipeline/engine_picture.hpp"

namespace gradus::bench {
namespace {

using namespace pipeline;

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const engine_scenes::SceneMaker& made : engine_scenes::workloads()) {
    for (const Size size : {Size{512, 512}, Size{1920, 1080}}) {
      Scene scene = made.scene(static_cast<double>(size.width) / size.height);
      for (const Shading shading : {Shading::gouraud, Shading::phong}) {
        const std::string name =
            fmt::format("{}, {}, {} x {}", made.name, shading_names[static_cast<std::size_t>(shading)],
                        size.width, size.height);
        scene.shading = shading;
        scene.antialiasing = Antialiasing::none;
        all.push_back(engine_scenes::picture_of(scene, size, "one sample", {name}));
        scene.antialiasing = Antialiasing::adaptive;
        scene.samples = 16;
        all.push_back(engine_scenes::picture_of(scene, size, "adaptive, 16 samples", {name}));
      }
    }
  }
  return all;
}

}  // namespace

Subject engine_antialiasing() {
  return {.topic = "engine_antialiasing",
          .title = "The engine: adaptive antialiasing",
          .item = "picture",
          .cases = cases};
}

}  // namespace gradus::bench
