#pragma once
// Where in the picture a plan spares work.

#include "core/raster.hpp"
#include "plan/plan.hpp"
#include "scene/scene.hpp"

namespace gradus::pipeline {

/// For each pixel of the whole picture what the plan spares at its centre: fragments that are never made (of
/// objects that are left out, and of faces that turn their backs), lamps that are not looked at and
/// highlights that are not computed.
///
/// plan: of this scene; the hidden are added. Beside the plan's window all there is to do is spared.
///
/// Domain: that of `geometry`.
/// Cost: the chain's stages 1 to 6 twice, without shading.
Raster<int> work_spared(const Scene& scene, Plan& plan);

}  // namespace gradus::pipeline
