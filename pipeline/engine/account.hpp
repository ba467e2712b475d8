#pragma once
// What the engine has done of stages 1 to 6, for the ledger.

#include "engine/geometry.hpp"
#include "plan/ledger.hpp"
#include "plan/plan.hpp"
#include "scene/scene.hpp"

namespace gradus::pipeline::engine {

/// Fills the rows of stages 1 to 6. frame: made of this scene and plan.
void count_geometry(const Scene& scene, const Plan& plan, const Frame& frame, Ledger& ledger);

}  // namespace gradus::pipeline::engine
