#pragma once
// JSON that people write by hand: every value knows its line, so that whatever is wrong with it can be found.

#include <string>
#include <string_view>
#include <vector>

namespace gradus::cli {

struct JsonMember;

struct JsonNode {
  enum class Kind { null, boolean, number, text, list, object };
  Kind kind;
  int line;          ///< where the value begins, from 1
  std::string text;  ///< of a text; of a number, as it was written: 4.10 is not 4.1
  bool truth;
  std::vector<JsonNode> elements;
  std::vector<JsonMember> members;  ///< in the order of the file; every key once

  /// The member of this key, or nullptr.
  const JsonMember* member(std::string_view key) const;
};

struct JsonMember {
  std::string key;
  int line;
  JsonNode value;
};

/// Reads a whole JSON text (RFC 8259), with or without a byte order mark. `file` is how errors call it.
/// Throws InputError "file:line: expected …, found …" for anything else, for a key that stands twice in one
/// object, for invalid UTF-8 and for more than 64 levels.
JsonNode read_json(std::string_view text, const std::string& file);

/// "'dark'", "4", "true", "a list": a value as messages show it.
std::string described(const JsonNode& node);

// Nodes made here rather than read
JsonNode json_text(std::string_view text);
JsonNode json_number(std::string_view as_written);
JsonNode json_truth(bool truth);
JsonNode json_list(std::vector<JsonNode> elements);
JsonNode json_texts(const std::vector<std::string>& texts);
JsonNode json_object(std::vector<JsonMember> members);

/// The node as text, indented; what fits on a line stands on one line. Ends with a line end.
std::string write_json(const JsonNode& node);
/// The same without line ends.
std::string json_on_one_line(const JsonNode& node);

}  // namespace gradus::cli
