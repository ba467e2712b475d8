#pragma once
// Notations as people name and write them: one of ours, or their own in JSON.
//
//   {"symbols": {"p": "d", "TOPIC": {"t": "u"}}, "bits": "LRBT", "vectors": "rows",
//    "handedness": "right", "depth": [-1, 1]}

#include <string>
#include <string_view>
#include <vector>

#include "figure/text/notation.hpp"
#include "request/written_json.hpp"

namespace gradus {

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

/// The same of a text; `called` is how errors call it. Throws UsageError, and InputError for what is no JSON.
Notation notation_in_text(std::string_view text, const std::string& called);

/// Whether a text names a file, rather than one of ours or a notation on the spot.
bool is_notation_file(std::string_view text);

/// By name, or as JSON on the spot. Throws UsageError or InputError.
Notation read_notation(std::string_view text);

}  // namespace gradus
