#pragma once
// The player page: opens from the file system, without a network.

#include <string>

#include "figure/colophon.hpp"
#include "figure/trace.hpp"

namespace gradus {

/// The offline player: one HTML file with the trace in it, drawn from its marks by the page's own script.
std::string player_page(const Trace& trace, const Colophon& colophon);

}  // namespace gradus
