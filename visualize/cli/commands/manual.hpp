#pragma once
// The manual: a page each for the program, its commands and its topics.

#include <string>

#include "cli/commands/commands.hpp"

namespace gradus::cli {

/// The page of a command or a topic, or of the program for "", as roff. Throws UsageError for another word.
std::string manual_page(const std::string& word);

}  // namespace gradus::cli
