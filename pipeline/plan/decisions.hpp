#pragma once
// A plan in words: for each object and stage whether it runs, runs on a part or is left out, and why.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "plan/plan.hpp"
#include "scene/scene.hpp"

namespace gradus::pipeline {

/// How much of a stage's work is done.
enum class Work { run, part, skip };

inline constexpr std::array<std::string_view, 3> work_names{"run", "part", "skip"};
inline constexpr std::string_view name_of(Work work) { return work_names[static_cast<std::size_t>(work)]; }

/// The lecture's stages.
inline constexpr std::array<std::string_view, 8> stage_names{
    "input model", "world transformation", "perspective transformation",         "back-face removal",
    "clipping",    "rasterization",        "hidden surface removal and shading", "output"};
/// Those that work on objects, 1 to 7. Stage 8 works on pixels.
inline constexpr int object_stages = 7;

/// What one stage does with one object.
struct Decision {
  int stage;
  Work work;
  std::string why{};  ///< empty where there is nothing to say
};

/// The decisions on an object, one per stage.
///
/// plan: of this scene, those that are hidden in it. object: its number.
/// Accuracy: what the chain then does, object by object.
std::vector<Decision> decisions_on(const Scene& scene, const Plan& plan, int object);

/// What decides what is seen, and whether anything is put in order for it: a line.
std::string order_text(const Scene& scene);

}  // namespace gradus::pipeline
