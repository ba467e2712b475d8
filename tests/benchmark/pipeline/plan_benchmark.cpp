// What each rule of a plan brings: whole scenes with all rules, without each of them, and without any,
// against the chain that knows no plan.

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "pipeline.hpp"
#include "plan/planned.hpp"
#include "scene/camera/framing.hpp"
#include "scene/camera/view.hpp"
#include "scene/files.hpp"
#include "scene/scene_file.hpp"

namespace gradus::bench {
namespace {

using namespace pipeline;

constexpr Size size{320, 180};

/// A scene as `gradus render` makes it, without its textures.
Scene shipped(const std::string& name) {
  const std::string path = fmt::format("{}/examples/scenes/{}.json", GRADUS_SOURCE_DIR, name);
  SceneFile file = load_scene(path);
  const Aim aim = aim_of(file.scene.objects, file.view, static_cast<double>(size.width) / size.height);
  file.scene.camera = camera_of(aim, file.view.vertical_radians, file.scene.objects);
  if (!file.lights_told) file.scene.lights = default_lights(file.scene.camera);
  return std::move(file.scene);
}

/// How many pixels differ from those without a plan.
Error off(const LightPicture& a, const LightPicture& b) {
  Error::Sum sum;
  for (std::size_t i = 0; i < a.cells().size(); ++i) {
    const glm::dvec3 d = a.cells()[i].sum - b.cells()[i].sum;
    for (int k = 0; k < 3; ++k) sum.add(d[k]);
  }
  return sum.error();
}

Case planned(const std::shared_ptr<const Scene>& scene, const std::shared_ptr<const LightPicture>& right,
             Rules rules, std::string method, const std::string& workload) {
  const auto light = std::make_shared<LightPicture>(*right);
  const auto run = [scene, light, rules] {
    Plan plan = plan_of(*scene, size, rules);
    Ledger ledger;
    *light = antialiased_by_plan(*scene, plan, ledger);
  };
  run();
  return {.method = std::move(method),
          .standing = Standing::robust,
          .workload = {workload},
          .items = std::int64_t{size.width} * size.height,
          .run = run,
          .error = off(*light, *right)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::string name :
       {"town", "town_at_night", "closed_room", "cornell_box", "circular_road", "spot"}) {
    const auto scene = std::make_shared<const Scene>(shipped(name));
    const auto right = std::make_shared<const LightPicture>(antialiased(*scene, size));
    const auto light = std::make_shared<LightPicture>(*right);
    all.push_back({.method = "no plan",
                   .standing = Standing::taught,
                   .workload = {name},
                   .items = std::int64_t{size.width} * size.height,
                   .run = [scene, light] { *light = antialiased(*scene, size); },
                   .error = Error{}});
    all.push_back(planned(scene, right, Rules::all(), "all rules", name));
    all.push_back(planned(scene, right, Rules::none(), "no rule", name));
    for (const Rule rule : all_rules) {
      if (rule == Rule::area_of_interest || rule == Rule::unchanged) continue;  // of a part, of a film
      all.push_back(
          planned(scene, right, Rules::all().without(rule), fmt::format("without {}", name_of(rule)), name));
    }
  }
  return all;
}

}  // namespace

Subject plan() {
  return {.topic = "plan",
          .title = "What a scene does not need",
          .item = "pixel",
          .unit = "parts of white",
          .telling = "town_at_night",
          .cases = cases};
}

}  // namespace gradus::bench
