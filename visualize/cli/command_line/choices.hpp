#pragma once
// The names that flags take where they are few: for the schema of lectures and for completion.

#include <string>
#include <string_view>
#include <vector>

namespace gradus::cli {

/// The names that a flag of `gradus figure` takes; empty where they are many, or anything. flag: as folded()
/// has it, "svg_text".
std::vector<std::string> choices_of(std::string_view flag);

}  // namespace gradus::cli
