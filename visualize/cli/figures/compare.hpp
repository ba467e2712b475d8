#pragma once
// What --compare sets beside a figure: another method of the same topic, another topic that takes the same
// inputs, or the same with some inputs changed.

#include <string_view>

#include "cli/commands/commands.hpp"
#include "request/openings.hpp"
#include "request/takes.hpp"

namespace gradus::cli {

/// The inputs of the run that is drawn, from which it and what it is compared with begin: see gradus::opened.
GivenTexts opened(const Request& request);

/// Reads a method ("first_octant"), another topic with or without flags, or flags ("--receding 45,1") beside
/// a run of this topic on these arguments, which the other side takes over; files come from there alone.
/// Throws UsageError or ArgumentError: an unknown name, a topic that lacks an input that was given, a flag
/// that is no input.
OtherSide other_side(const TopicEntry& topic, const Arguments& arguments, std::string_view text);

}  // namespace gradus::cli
