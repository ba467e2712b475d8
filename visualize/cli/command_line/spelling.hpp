#pragma once
// From what people type to what a parser takes: names written out, values glued to their flags.

#include <string>
#include <vector>

#include "cli/commands/commands.hpp"

namespace gradus::cli {

/// A command line written out: of `fig cir --at -5,8` there remain the command figure, the topic that begins
/// with "cir", and the word "--at=-5,8". A value is what follows its flag, unless it begins with "--".
struct Spelled {
  const Command* command = nullptr;
  const TopicEntry* topic = nullptr;
  std::vector<std::string> words;  ///< flags and operands that are left
};
/// Throws UsageError for an unknown or ambiguous name, and for a flag without its value.
Spelled spelled_out(const std::vector<std::string>& words);

}  // namespace gradus::cli
