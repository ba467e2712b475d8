#pragma once
// The flags of `gradus render` and `gradus explain` that are about the plan.

#include <optional>
#include <string>

#include "cli/render/render_choices.hpp"
#include "core/geometry.hpp"
#include "plan/rules.hpp"
#include "stages/points.hpp"

namespace gradus::cli {

/// What they say.
struct PlanWish {
  std::optional<Window> part;  ///< of the picture; none: all of it
  pipeline::Rules rules = pipeline::Rules::all();
  std::string said;  ///< what of it a recipe needs: what changes the picture
};

/// Reads --part and --without. size: of the whole picture. Throws UsageError.
PlanWish plan_wish(const Flags& flags, pipeline::Size size);

/// "120,88": column and row of a pixel, from 0 at the upper left. Throws UsageError, beginning with the flag.
ivec2 pixel_flag(const std::string& flag, const std::string& text, pipeline::Size size);

}  // namespace gradus::cli
