#pragma once
// What `gradus explain` and `gradus render --report` print.

#include <optional>
#include <string>

#include "cli/commands/render.hpp"
#include "plan/ledger.hpp"
#include "plan/plan.hpp"
#include "scene/scene.hpp"

namespace gradus::cli {

/// A plan as a table: objects that are treated alike share a line. name: of the scene. path: of its camera.
std::string plan_text(const std::string& name, const pipeline::Scene& scene, const pipeline::Plan& plan,
                      const std::optional<PathFacts>& path = {});

/// The same as JSON, each object and stage.
std::string plan_json(const std::string& name, const pipeline::Scene& scene, const pipeline::Plan& plan,
                      const std::optional<PathFacts>& path = {});

/// What was done and left out, by whom, and how long the parts took.
std::string ledger_text(const std::string& name, const pipeline::Ledger& ledger, std::string_view drawn_by);

}  // namespace gradus::cli
