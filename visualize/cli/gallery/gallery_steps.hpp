#pragma once
// Which steps of a run the files of a gallery show.

#include <cstdint>
#include <vector>

#include "cli/commands/figure.hpp"

namespace gradus::cli {

/// Pages of a PDF without chosen steps; longer runs show steps evenly spaced.
constexpr std::int64_t most_gallery_pages = 120;

/// Whether a run has more steps than the pages of its PDF.
bool is_cut(std::int64_t last);

/// Steps for the PDF: of a run that is not kept whole, those that are.
std::int64_t last_page(const Takes& takes);

/// One picture per step.
std::vector<StepNumber> picture_steps(const FigureSpec& spec, const Takes& takes);

/// The figure with the pages of its PDF as its steps.
FigureSpec paged(const FigureSpec& spec, const Takes& takes, std::int64_t most = most_gallery_pages);

std::vector<StepNumber> page_steps(const FigureSpec& pages, const Takes& takes);

/// The figure as a table or a player: for a player without gaps.
FigureSpec told(const FigureSpec& spec, const Takes& takes, Format format);

/// What the card shows of it.
StepNumber thumbnail_step(const FigureSpec& spec, const Takes& takes);

}  // namespace gradus::cli
