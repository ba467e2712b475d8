#include "plan/spared.hpp"

#include "plan/planned.hpp"
#include "shading/illumination/illumination.hpp"
#include "stages/1_input.hpp"
#include "stages/2_world.hpp"
#include "stages/3_perspective.hpp"
#include "stages/4_back_faces.hpp"
#include "stages/5_clipping.hpp"
#include "stages/6_rasterization.hpp"
#include "stages/7_visibility_and_shading.hpp"
#include "stages/wireframe.hpp"

namespace gradus::pipeline {
namespace {

/// The triangles of all objects, those that turn their backs as well.
Triangles all_triangles(Scene scene, Size size) {
  scene.culling = Culling::none;
  const auto world = to_world(scene, input(scene));
  const auto seen = to_clip(scene, size, world);
  const auto facing = cull(scene, seen);
  return scene.shading == Shading::wireframe ? outlines(facing, size) : clip(world, facing, size);
}

std::int64_t lamps_of(const Light& light) { return illumination::lamps(light); }

/// Lamps and highlights at a place of a visible surface.
struct Lighting {
  std::int64_t lamps = 0, highlights = 0;
};

Lighting all_lighting(const Scene& scene) {
  Lighting lighting;
  for (const Light& light : scene.lights) lighting.lamps += lamps_of(light);
  lighting.highlights = lighting.lamps;
  return lighting;
}

Lighting planned_lighting(const Scene& scene, const Plan& plan, PieceId id) {
  Lighting lighting;
  for (int number : plan.of(id.object).lights)
    lighting.lamps += lamps_of(scene.lights[static_cast<std::size_t>(number)]);
  const Mesh& mesh = *object_at(scene, id.object).mesh;
  const MeshFace& face = mesh.faces[static_cast<std::size_t>(id.face)];
  const Material& material = mesh.materials[static_cast<std::size_t>(face.material)];
  lighting.highlights = plan.highlights(material) ? lighting.lamps : 0;
  return lighting;
}

}  // namespace

Raster<int> work_spared(const Scene& scene, Plan& plan) {
  Raster<int> spared(plan.size.width, plan.size.height);
  rasterize(all_triangles(scene, plan.size), plan.size, [&](const Fragment& f) { ++spared[f.pixel]; });

  Ledger ledger;
  Visible nearest(plan.size.width, plan.size.height);
  rasterize(geometry(scene, plan, ledger), plan.size, [&](const Fragment& f) {
    if (!plan.window.contains(f.pixel)) return;
    --spared[f.pixel];
    keep_nearest(f, nearest);
  });

  const Lighting all = all_lighting(scene);
  for (int y = plan.window.lower.y; y <= plan.window.upper.y; ++y) {
    for (int x = plan.window.lower.x; x <= plan.window.upper.x; ++x) {
      const auto seen = held(nearest[{x, y}]);
      if (!seen) continue;
      const Lighting done = planned_lighting(scene, plan, seen->id);
      spared[{x, y}] += static_cast<int>(all.lamps - done.lamps + all.highlights - done.highlights);
    }
  }
  return spared;
}

}  // namespace gradus::pipeline
