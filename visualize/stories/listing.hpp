#pragma once
// Which lines of a method's source a figure lists, and which of them a step marks.

#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "figure/trace.hpp"

namespace gradus {

/// What stands above a function's body where a listing has several: "divide(point, view):", under the number
/// of the line that declares it. Nothing where there is no such function.
std::optional<SourceLine> heading_of(std::string_view source, std::string_view function);

/// The source lines of a function's body, from the first to that of its closing brace; {0, 0} without one.
std::pair<int, int> body_of(std::string_view source, std::string_view function);

/// The number of the listed line that had certainly run when a step was reported from source line `line` of
/// the same function: the nearest one at or above it, but not in a branch that ends before. Where that may
/// not have been taken it is the head of the branch, whose question was asked in any case. 0 where there is
/// none.
int line_that_ran(std::span<const SourceLine> lines, int line);

/// The number of the first listed line with this text; 0 where there is none.
int line_with(std::span<const SourceLine> lines, std::string_view text);

}  // namespace gradus
