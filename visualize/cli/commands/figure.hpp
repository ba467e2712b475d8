#pragma once
// Writing what a FigureSpec describes: `gradus figure` and `gradus again` end here.

#include <optional>
#include <span>
#include <string>

#include "cli/figures/figure_file.hpp"
#include "cli/files/files.hpp"
#include "text/snippet.hpp"

namespace gradus::cli {

/// The spec without what says nothing about files of this format: the size of a table.
FigureSpec fitting(FigureSpec spec, Format format);

/// Refuses flags that say nothing about this format. Throws UsageError.
void refuse_idle_flags(const Request& request, Format format);

/// One file, or one per step when the name holds "{step}"; then the lines that put it into a lecture.
/// Everything appears or nothing. Throws UsageError, WorkError.
void write_figure(FigureSpec spec, Format format, const Output& output, std::span<const std::string> inputs,
                  std::optional<SnippetKind> snippet = std::nullopt);

}  // namespace gradus::cli
