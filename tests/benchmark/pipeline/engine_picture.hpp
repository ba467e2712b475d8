#pragma once
// A picture by the engine as a case of a benchmark, one thread.

#include <memory>
#include <string>
#include <utility>

#include "benchmark/pipeline/engine_scenes.hpp"
#include "benchmark/subject.hpp"
#include "engine/engine.hpp"
#include "plan/plan.hpp"

namespace gradus::bench::engine_scenes {

/// Plan and buffers are made outside the time. Lit by the lamp beside the camera.
inline Case picture_of(const pipeline::Scene& of, pipeline::Size size, std::string method,
                       Workload workload) {
  using namespace pipeline;
  const auto scene = std::make_shared<Scene>(of);
  light(*scene);
  const auto buffers = std::make_shared<const engine::Buffers>(engine::buffers_of(*scene));
  const auto plan = std::make_shared<const Plan>(plan_of(*scene, size));
  const auto workspace = std::make_shared<engine::Workspace>();
  const auto picture = std::make_shared<engine::Picture>();
  return {
      .method = std::move(method), .standing = Standing::batch, .workload = std::move(workload), .run = [=] {
        engine::draw_into(*picture, *scene, *buffers, *plan, *workspace, 1);
      }};
}

/// From the centres of pixels.
inline Case picture_of_sphere(int n, pipeline::Size size, pipeline::Shading shading, Workload workload) {
  pipeline::Scene scene = spheres(n);
  scene.shading = shading;
  scene.antialiasing = pipeline::Antialiasing::none;
  return picture_of(scene, size, std::string(pipeline::shading_names[static_cast<std::size_t>(shading)]),
                    std::move(workload));
}

}  // namespace gradus::bench::engine_scenes
