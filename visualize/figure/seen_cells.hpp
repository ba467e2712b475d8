#pragma once
// The part of a large grid that a trace can show.

#include <vector>

#include "figure/trace.hpp"

namespace gradus {

/// Where a canvas is asked for its cells: all of a grid of ordinary size; of a larger one the blocks that a
/// view following the recorded steps can come to show.
std::vector<Window> windows_to_look_in(const Trace& trace);

}  // namespace gradus
