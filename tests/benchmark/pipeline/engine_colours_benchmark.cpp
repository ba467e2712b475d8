// Colours of the fragments that a picture shows, by stage 7 and by the engine's way to the same bits.

#include <memory>
#include <string>
#include <vector>

#include "benchmark/pipeline/engine_scenes.hpp"
#include "benchmark/subject.hpp"
#include "engine/pixel_colours.hpp"
#include "pipeline.hpp"

namespace gradus::bench {
namespace {

using namespace pipeline;

constexpr Size size{320, 240};

/// What is seen of a scene, row by row, and the colours that it gets.
struct Seen {
  Scene scene;
  Triangles triangles{};
  std::vector<Fragment> fragments{};
  std::vector<LinearRgb> colours{};

  explicit Seen(Scene&& of) : scene(std::move(of)) {
    scene.shading = Shading::phong;
    const auto world = to_world(scene, input(scene));
    triangles = clip(world, cull(scene, to_clip(scene.camera, 4.0 / 3, world)), size);
    Visible cells(size.width, size.height);
    rasterize(triangles, size, [&](const Fragment& f) { keep_nearest(f, cells); });
    for (const PixelCell& cell : cells.cells())
      if (cell.taken) fragments.push_back(cell.key.fragment);
    colours.resize(fragments.size());
  }

  template <class Colour>
  void colour(const Colour& colour_of) {
    for (std::size_t i = 0; i < fragments.size(); ++i)
      colours[i] = colour_of(fragments[i], triangle_of(fragments[i], triangles));
  }
};

Case by_stage_seven(const std::shared_ptr<Seen>& seen, const Workload& workload) {
  const auto light = std::make_shared<SceneLight>(seen->scene, size);
  return {.method = "shaded",
          .standing = Standing::taught,
          .workload = workload,
          .items = std::ssize(seen->fragments),
          .run = [seen, light] {
            seen->colour([&](const Fragment& f, const Triangle& t) { return shaded(*light, f, t).colour; });
          }};
}

Case by_engine(const std::shared_ptr<Seen>& seen, const Workload& workload) {
  const auto light = std::make_shared<SceneLight>(seen->scene, size);
  const auto colours = std::make_shared<engine::PixelColours>();
  Case of{.method = "PixelColours",
          .standing = Standing::batch,
          .workload = workload,
          .items = std::ssize(seen->fragments),
          .run = [seen, light, colours] {
            seen->colour([&](const Fragment& f, const Triangle& t) { return (*colours)(*light, f, t); });
          }};
  // Colours that are not those of stage 7
  Error::Sum sum;
  for (const Fragment& f : seen->fragments) {
    const Triangle& t = triangle_of(f, seen->triangles);
    if ((*colours)(*light, f, t) != shaded(*light, f, t).colour) sum.wrong_decision();
  }
  of.error = sum.error();
  return of;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](std::string name, Scene scene) {
    const auto seen = std::make_shared<Seen>(std::move(scene));
    const Workload workload{std::move(name)};
    all.push_back(by_stage_seven(seen, workload));
    all.push_back(by_engine(seen, workload));
  };
  Scene sphere = engine_scenes::spheres(23);
  engine_scenes::light(sphere);
  add("sphere, a point", std::move(sphere));
  for (const char* name : {"spot", "closed_room", "cornell_box", "town_at_night"}) {
    Scene scene = engine_scenes::shipped(name, 4.0 / 3);
    if (scene.lights.empty()) engine_scenes::light(scene);
    add(name, std::move(scene));
  }
  return all;
}

}  // namespace

Subject engine_colours() {
  return {.topic = "engine_colours",
          .title = "Colours of fragments, Phong",
          .item = "fragment",
          .telling = "sphere, a point",
          .cases = cases};
}

}  // namespace gradus::bench
