// What antialiasing costs in rendered pictures, and what it brings: every method of gradus render --aa,
// against 1024 samples per pixel.

#include <fmt/format.h>

#include <memory>

#include "benchmark/subject.hpp"
#include "pipeline.hpp"
#include "scene/camera/framing.hpp"
#include "scene/files.hpp"

namespace gradus::bench {
namespace {

using namespace pipeline;

constexpr Size size{160, 120};

using Light = Raster<LinearRgb>;
Light light_of(const Scene& scene) { return over_background(antialiased(scene, size), scene.background); }

Case picture(const Scene& scene, const std::shared_ptr<const Light>& right, Antialiasing method, int samples,
             const std::string& workload) {
  const auto asked = std::make_shared<Scene>(scene);
  asked->antialiasing = method;
  asked->samples = samples;
  const auto light = std::make_shared<Light>(light_of(*asked));
  // A picture has one error: the root of the mean square
  Error::Sum pixels, sum;
  for (std::size_t i = 0; i < light->cells().size(); ++i) {
    const glm::dvec3 off = glm::dvec3(light->cells()[i]) - glm::dvec3(right->cells()[i]);
    for (int k = 0; k < 3; ++k) pixels.add(off[k]);
  }
  sum.add(pixels.error().rms);
  std::string name(name_of(method));
  if (takes_samples(method)) name += fmt::format(" {}", samples);
  return {.method = std::move(name),
          .standing = method == Antialiasing::none ? Standing::taught : Standing::robust,
          .workload = {workload},
          .items = std::int64_t{size.width} * size.height,
          .run = [asked, light] { *light = light_of(*asked); },
          .error = sum.error()};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& [model, name] : {std::pair{"letter_f", "letter F"}, std::pair{"spot", "Spot"}}) {
    const std::string path = fmt::format("{}/examples/models/{}.obj", GRADUS_SOURCE_DIR, model);
    Scene scene = scene_of(load_obj(path).mesh, static_cast<double>(size.width) / size.height);
    scene.antialiasing = Antialiasing::supersampling;
    scene.samples = 1024;
    const auto right = std::make_shared<const Light>(light_of(scene));
    for (std::size_t m = 0; m < antialiasing_names.size(); ++m) {
      const auto method = static_cast<Antialiasing>(m);
      all.push_back(picture(scene, right, method, 16, name));
      if (!takes_samples(method)) continue;
      for (const int samples : {4, 64}) all.push_back(picture(scene, right, method, samples, name));
    }
  }
  return all;
}

}  // namespace

Subject render_antialiasing() {
  return {.topic = "render_antialiasing",
          .title = "Rendered pictures, antialiased",
          .item = "pixel",
          .unit = "parts of white (RMS)",
          .telling = "Spot",
          .cases = cases,
          .choice = {"adaptive", "nearly as smooth as with samples everywhere, in far less time"}};
}

}  // namespace gradus::bench
