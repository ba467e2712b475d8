#include "plan/decisions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/shown.hpp"
#include "plan/levels.hpp"

namespace gradus::pipeline {
namespace {

/// Beyond which plane or side something lies.
std::string_view beyond_text(Side side) {
  constexpr std::array<std::string_view, 6> texts{"beyond the left side",       "beyond the right side",
                                                  "below the lower side",       "above the upper side",
                                                  "in front of the near plane", "behind the far plane"};
  return texts[static_cast<std::size_t>(side)];
}

std::string reason_of(const Scene& scene, const ObjectPlan& plan) {
  if (plan.skipped == Rule::outside) return fmt::format("outside: {}", beyond_text(*plan.beyond));
  if (plan.skipped == Rule::area_of_interest)
    return fmt::format("area of interest: {} of it", beyond_text(*plan.beyond));
  return fmt::format("hidden behind what is nearer, like {}", visible(object_at(scene, plan.behind).name));
}

/// How often an object was subdivided, and why not more often.
std::string level_text(const Object& object) {
  if (!object.subdivision) return "";
  const auto& [control, most, level, longest] = *object.subdivision;
  const bool fine = std::ldexp(longest, -level) <= fine_edge;
  return fmt::format("subdivided to level {} of {}: {}", level, most,
                     fine ? fmt::format("edges of some {} pixels or less", fine_edge)
                          : fmt::format("its edges may be longer than {} pixels", fine_edge));
}

Decision on_facing(const Scene& scene, const Object& object) {
  if (scene.culling == Culling::back) return {4, Work::run, "backs are left out, as asked for"};
  if (scene.culling == Culling::none) return {4, Work::part, "backs are asked for, and only marked"};
  if (shows_through(scene, object))
    return {4, Work::part, "lets light through: backs are seen, and only marked"};
  if (object.two_sided) return {4, Work::part, "open or two-sided: backs are seen, and only marked"};
  return {4, Work::run, "closed and outward: backs are never seen"};
}

Decision on_clipping(const ObjectPlan& plan) {
  if (plan.whole) return {5, Work::skip, "wholly between the planes: nothing is cut"};
  return {5, Work::run, "may reach beyond a plane"};
}

/// Whether a condition holds for all, some or none of an object's materials that faces use.
enum class Share { none, some, all };

template <class Condition>
Share share_of(const Mesh& mesh, const Condition& holds) {
  std::size_t count = 0;
  for (const MeshFace& face : mesh.faces)
    count += holds(mesh.materials[static_cast<std::size_t>(face.material)]);
  if (count == 0) return Share::none;
  return count == mesh.faces.size() ? Share::all : Share::some;
}

std::string lights_text(const Scene& scene, const ObjectPlan& plan) {
  std::vector<int> missing;
  for (int number = 0; number < std::ssize(scene.lights); ++number)
    if (!std::ranges::binary_search(plan.lights, number)) missing.push_back(number + 1);
  if (missing.empty()) return "";
  // Many are counted, few are named
  if (missing.size() > 3)
    return fmt::format("{} of {} lights beyond their range", missing.size(), scene.lights.size());
  const bool one = missing.size() == 1;
  return fmt::format("light{} {} of {} beyond {} range", one ? "" : "s", fmt::join(missing, ", "),
                     scene.lights.size(), one ? "its" : "their");
}

Decision on_shading(const Scene& scene, const Plan& plan, const Object& object, const ObjectPlan& planned) {
  std::vector<std::string> left_out;
  const auto add = [&](Share share, std::string_view what) {
    if (share == Share::all) left_out.emplace_back(what);
    if (share == Share::some) left_out.push_back(fmt::format("{} on some faces", what));
  };
  const std::string lights = lights_text(scene, planned);
  if (!lights.empty()) left_out.push_back(lights);
  add(share_of(*object.mesh, [&](const Material& m) { return !plan.highlights(m); }),
      "no highlight: k_s = 0");
  add(share_of(*object.mesh, [](const Material& m) { return m.diffuse_map.texels.cells().empty(); }),
      "no texture");
  return {7, left_out.empty() ? Work::run : Work::part, fmt::format("{}", fmt::join(left_out, "; "))};
}

}  // namespace

std::vector<Decision> decisions_on(const Scene& scene, const Plan& plan, int number) {
  const Object& object = object_at(scene, number);
  const ObjectPlan& planned = plan.of(number);
  std::vector<Decision> decisions;
  if (planned.skipped) {
    const std::string why = reason_of(scene, planned);
    for (int stage = 1; stage <= object_stages; ++stage) decisions.push_back({stage, Work::skip, why});
    return decisions;
  }
  decisions.push_back({1, Work::run, level_text(object)});
  for (int stage = 2; stage <= 3; ++stage) decisions.push_back({stage, Work::run});
  decisions.push_back(on_facing(scene, object));
  decisions.push_back(on_clipping(planned));
  decisions.push_back({6, Work::run});
  decisions.push_back(on_shading(scene, plan, object, planned));
  return decisions;
}

std::string order_text(const Scene& scene) {
  using enum HiddenSurfaces;
  if (scene.shading == Shading::wireframe) return "edges alone: nothing is sorted, nothing is lit\n";
  if (scene.hidden_surfaces == painter)
    return "painter: all triangles are sorted and tested, and what is hidden is painted over\n";
  if (scene.hidden_surfaces == farthest_vertex)
    return "farthest_vertex, an exhibit: all triangles are sorted by their farthest corners, none is "
           "tested\n";
  if (scene.hidden_surfaces == bsp_tree)
    return "BSP tree: it is built of all triangles, and asks for all objects\n";
  return "z-buffer: nothing is sorted\n";
}

}  // namespace gradus::pipeline
