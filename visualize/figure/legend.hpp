#pragma once
// What a legend has to tell of the steps of a run.

#include <span>
#include <vector>

#include "figure/trace.hpp"

namespace gradus {

/// Which entries the recorded steps show together, each set once. None: it is not known, so all may be, where
/// steps before were left out or there are more than bits.
std::vector<LegendEntries> legends_of(const Trace& trace);

/// The legend of these steps together: what any of them shows; all of it where that is not known.
std::vector<LegendEntry> legend_at(const Trace& trace, std::span<const StepNumber> steps);

}  // namespace gradus
