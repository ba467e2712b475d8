#pragma once
// The textbook chain by a plan: the same stages for what the plan leaves, and so the same picture.

#include "plan/cover.hpp"
#include "plan/ledger.hpp"
#include "plan/plan.hpp"
#include "scene/scene.hpp"
#include "stages/antialiasing.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// Stages 1 to 5 for what a plan leaves, and the end of planning: from the nearest object on, so that what
/// the nearer ones hide (Rule::hidden) is found before it is touched.
///
/// plan: of this scene; the hidden are added. ledger: gets the rows of stages 1 to 6 (those
///   that stage 6 finds to have no area among what is done), planning and geometry.
///
/// Domain: that of the stages.
/// Accuracy: the triangles of `clip` but for those of objects left out, in their order.
/// Cost: that of the stages for what is left, and that of Cover.
/// Errors: those of the stages.
Triangles geometry(const Scene& scene, Plan& plan, Ledger& ledger, const Clock& clock = {});

/// The light of the part of the picture that the plan asks for, with the scene's antialiasing.
///
/// plan, ledger: as for geometry; of the ledger all rows are filled but what `output` takes. reached: told of
///   the share of stages 6 and 7 that is done, from 0 to 1.
///
/// Domain, Errors: those of `antialiased`.
/// Accuracy: the bits of `antialiased`.
LightPicture antialiased_by_plan(const Scene& scene, Plan& plan, Ledger& ledger, const Clock& clock = {},
                                 const std::function<void(double)>& reached = {});

/// For code that runs the stages otherwise: into the ledger goes what there is of each object, and of those
/// that are skipped why.
void count_objects(const Scene& scene, const Plan& plan, Ledger& ledger);
/// The same of stage 7's light and of the pixels of stage 8.
void count_pixels(const ShadingCount& count, const Plan& plan, Ledger& ledger);

}  // namespace gradus::pipeline
