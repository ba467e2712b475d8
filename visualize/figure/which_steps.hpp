#pragma once
// Which steps of a run to show where none are named.

#include <optional>
#include <vector>

#include "figure/trace.hpp"

namespace gradus {

/// Position in the listing of the line of code that a report from source line `line` belongs to: the nearest
/// one at or above it. A line of braces or of a comment alone is no line of code. Nothing where there is
/// none.
std::optional<std::size_t> code_line(const std::vector<SourceLine>& listing, int line);

/// The step whose figure tells most: one that decides something and has a line of code; of the phase with
/// most of these one of the rarest kind of branch, near the middle. Whole steps come before finer events,
/// single ones before a phase's summary, the input after all others, and the run's last step never. Where no
/// step decides, one that has a line of code.
StepNumber telling_step(const Trace& trace);

/// The steps that together tell what can happen: the input, the run's telling step, one of each kind of
/// branch by its most telling instance, one of each phase, which decides where any does, and the result. A
/// whole step without a decision is of the kind of its source line; finer events count in phases whose whole
/// steps decide nothing. Of equals it is one that says something new, then one in a phase that would not be
/// shown. Recorded steps, ascending.
std::vector<StepNumber> milestones_of(const Trace& trace);

/// A step for each part of the run, `most` at most, evenly spread: of each phase but the input's and the
/// result's the last whole step; where there is one such phase alone, its whole steps (those with a note,
/// where some have one: one of each where three or more are told apart), six on a grid and four on paper;
/// where that is a single step, the input, too, and the result.
std::vector<StepNumber> phase_steps(const Trace& trace, std::size_t most);

/// The whole step in the middle of what is recorded.
StepNumber middle_step(const Trace& trace);

}  // namespace gradus
