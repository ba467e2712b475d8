#pragma once
// Several drawings on one sheet: --panels, and --compare.

#include <string>
#include <vector>

#include "cli/figures/figure_spec.hpp"
#include "figure/sheet.hpp"

namespace gradus::cli {

/// The steps that --panels shows. Throws UsageError for steps that the run has not.
std::vector<StepNumber> panel_steps(const FigureSpec& spec, const Takes& takes);
/// "4 phases", "3 steps of 50".
std::string panels_text(const FigureSpec& spec, const Takes& takes);
/// They on one sheet. `look`: the spec's, or that of the place where the sheet stands.
Sheet panels_sheet(const FigureSpec& spec, Takes& takes, const Look& look);

/// What a comparison shows where no step is named, as a step of the first run: of two right runs what they
/// come to, else the first step whose drawing differs.
StepNumber compared_step(const FigureSpec& spec, const Takes& takes);
/// A step of the run, and beside it the one of the other run that belongs to it.
Sheet compared_sheet(const FigureSpec& spec, Takes& takes, StepNumber step, const Look& look);
/// What that sheet shows, in a sentence: caption and alt text.
std::string compared_caption(Takes& takes, StepNumber step);

}  // namespace gradus::cli
