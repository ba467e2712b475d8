#pragma once
// Notations of one's own, in files.

#include <string>

#include "cli/command_line/inputs.hpp"
#include "request/notation_reader.hpp"

namespace gradus::cli {

/// By name, as JSON on the spot, or from a file, where `find` looks for it. Throws UsageError.
Notation read_notation(const std::string& text, const FindFile& find = as_named);

}  // namespace gradus::cli
