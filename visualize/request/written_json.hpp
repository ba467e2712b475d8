#pragma once
// JSON that is made here: values put together, and their text.

#include <string>
#include <string_view>
#include <vector>

#include "scene/located_json.hpp"

namespace gradus {

using pipeline::described;
using pipeline::JsonMember;
using pipeline::JsonNode;
using pipeline::read_json;

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

}  // namespace gradus
