// What adaptive antialiasing takes beside one sample per pixel, on the scenes of the comparison with
// llvmpipe; and what it takes where a decal lies in the plane of its wall, beside the same lifted off.

#include <fmt/format.h>

#include "benchmark/pipeline/engine_picture.hpp"

namespace gradus::bench {
namespace {

using namespace pipeline;

/// A square of so many squares along its sides.
void add_squares(Mesh& mesh, int across, double side, double z) {
  const auto at = [&](int i) { return side * (2.0 * i / across - 1); };
  for (int row = 0; row < across; ++row) {
    for (int column = 0; column < across; ++column) {
      const int first = static_cast<int>(mesh.positions.size());
      for (const ivec2 corner : {ivec2{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        mesh.positions.push_back({at(column + corner.x), at(row + corner.y), z});
      const Corner corners[]{{first}, {first + 1}, {first + 2}, {first + 3}};
      add_face(mesh, corners);
    }
  }
}

/// A wall and a decal that far before it. across: squares along the sides of the wall, and of the decal.
Scene decal(double before, bool decal_first, ivec2 across) {
  Scene scene;
  Mesh mesh;
  if (decal_first) add_squares(mesh, across.y, 1.5, before);
  add_squares(mesh, across.x, 2, 0);
  if (!decal_first) add_squares(mesh, across.y, 1.5, before);
  scene.objects.push_back(object_of(std::move(mesh)));
  scene.camera.frame = viewing::look_at(dvec3{0.4, 0.7, 3}, dvec3{0}, dvec3{0, 1, 0});
  scene.antialiasing = Antialiasing::adaptive;
  scene.samples = 16;
  return scene;
}

/// Each lifted off, or pushed behind its wall, so that the same is seen: the first in the file.
void add_decals(std::vector<Case>& all) {
  const Size size{480, 320};
  for (const ivec2 across : {ivec2{1, 30}, {30, 1}, {30, 30}}) {
    for (const bool decal_first : {false, true}) {
      const std::string name = fmt::format("decal, {} on {} squares, {} first", across.y * across.y,
                                           across.x * across.x, decal_first ? "decal" : "wall");
      const double off = decal_first ? 0.01 : -0.01;
      all.push_back(engine_scenes::picture_of(decal(off, decal_first, across), size, "lifted off", {name}));
      all.push_back(engine_scenes::picture_of(decal(0, decal_first, across), size, "in one plane", {name}));
    }
  }
}

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
  add_decals(all);
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
