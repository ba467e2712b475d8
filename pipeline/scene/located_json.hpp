#pragma once
// JSON that people write by hand: every value knows its line, so that its mistakes can be found.

#include <string>
#include <string_view>
#include <vector>

namespace gradus::pipeline {

struct JsonMember;

struct JsonNode {
  enum class Kind { null, boolean, number, text, list, object };
  Kind kind = Kind::null;
  int line = 0;        ///< where the value begins, from 1
  std::string text{};  ///< of a text; of a number, as it was written: 4.10 is not 4.1
  bool truth = false;
  std::vector<JsonNode> elements{};
  std::vector<JsonMember> members;  ///< in the order of the file; every key once

  /// The member of this key, or nullptr.
  const JsonMember* member(std::string_view key) const;
};

struct JsonMember {
  std::string key;
  int line;
  JsonNode value;
};

/// A value of this kind and text, without a line; a truth is false, a list or an object empty.
JsonNode json_node(JsonNode::Kind kind, std::string text = {});

/// Whether a text begins as a JSON object or list does.
bool begins_as_json(std::string_view text);

/// Reads a whole JSON text (RFC 8259), with or without a byte order mark. `file` is how errors call it.
/// Errors: InputError "file:line: expected …, found …" for anything else, for a key that stands twice in one
/// object, for invalid UTF-8 and for more than 64 levels.
JsonNode read_json(std::string_view text, const std::string& file);

/// "'dark'", "4", "true", "a list": a value as messages show it.
std::string described(const JsonNode& node);

}  // namespace gradus::pipeline
