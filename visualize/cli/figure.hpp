#pragma once
// Writing what a FigureSpec describes: `gradus figure` and `gradus again` end here.

#include <span>
#include <string>

#include "cli/figure_file.hpp"

namespace gradus::cli {

/// Slots, theme and size say something about drawings only; a player has themes of its own. Throws
/// UsageError.
void refuse_idle_flags(const Request& request, Format format);

/// One file, or one a step when the name holds "{step}". Everything appears or nothing. Throws UsageError,
/// WorkError.
void write_figure(FigureSpec spec, Format format, const std::string& output,
                  std::span<const std::string> inputs, bool quiet);

}  // namespace gradus::cli
