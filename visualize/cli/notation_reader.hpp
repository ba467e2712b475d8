#pragma once
// Notations as people name and write them: one of ours, or their own in JSON.
//
//   {"symbols": {"p": "d", "TOPIC": {"t": "u"}}, "bits": "LRBT", "vectors": "rows",
//    "handedness": "right", "depth": [-1, 1]}

#include <string>
#include <string_view>
#include <vector>

#include "cli/inputs.hpp"
#include "cli/written_json.hpp"
#include "figure/notation.hpp"

namespace gradus::cli {

/// The names of ours.
std::vector<std::string> notation_names();

/// What a notation is when it is none of ours, for messages and help.
inline constexpr std::string_view own_notation = "a file like own.json";

/// What is wrong with a notation of one's own: where in it, "symbols.t", and what.
struct NotationMistake {
  int line;
  std::string way, what;
};

/// An own notation; mistakes are noted, and what they concern stays as in the code. Its name is its text on
/// one line.
Notation notation_in(const JsonNode& node, std::vector<NotationMistake>& mistakes);

/// By name, as JSON on the spot, or from a file, where `find` looks for it. Throws UsageError.
Notation read_notation(const std::string& text, const FindFile& find = as_named);

}  // namespace gradus::cli
