#pragma once
// What a legend has to tell of several steps; content.hpp has what it may have to tell of each.

#include <span>
#include <vector>

#include "figure/trace.hpp"

namespace gradus {

/// The legend of these steps together: what any of them shows; all of it where that is not known.
std::vector<LegendEntry> legend_at(const Trace& trace, std::span<const StepNumber> steps);

}  // namespace gradus
