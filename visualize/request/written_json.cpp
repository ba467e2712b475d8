#include "request/written_json.hpp"

#include <utility>

#include "json/json.hpp"

namespace gradus {
namespace {

using Kind = JsonNode::Kind;

constexpr std::size_t widest_line = 110;

}  // namespace

std::string json_on_one_line(const JsonNode& node) {
  std::string text;
  switch (node.kind) {
    case Kind::null:
    case Kind::boolean:
    case Kind::number:
      return described(node);
    case Kind::text:
      return json_quoted(node.text);
    case Kind::list:
      for (const JsonNode& element : node.elements) {
        text += (text.empty() ? "" : ", ") + json_on_one_line(element);
      }
      return "[" + text + "]";
    case Kind::object:
      for (const JsonMember& member : node.members) {
        text += (text.empty() ? "" : ", ") + json_quoted(member.key) + ": " + json_on_one_line(member.value);
      }
      return "{" + text + "}";
  }
  return text;
}

namespace {

/// `before`: columns that are taken on the first line.
std::string indented(const JsonNode& node, std::size_t indent, std::size_t before) {
  std::string line = json_on_one_line(node);
  const bool has_parts = !node.elements.empty() || !node.members.empty();
  if (!has_parts || before + line.size() < widest_line) return line;
  const std::string margin(indent + 2, ' '), end = "\n" + std::string(indent, ' ');
  std::string text, separator = "\n" + margin;
  for (const JsonNode& element : node.elements) {
    text += separator + indented(element, indent + 2, indent + 2);
    separator = ",\n" + margin;
  }
  for (const JsonMember& member : node.members) {
    const std::string key = json_quoted(member.key) + ": ";
    text += separator + key + indented(member.value, indent + 2, indent + 2 + key.size());
    separator = ",\n" + margin;
  }
  return node.kind == Kind::list ? "[" + text + end + "]" : "{" + text + end + "}";
}

}  // namespace

JsonNode json_text(std::string_view text) { return pipeline::json_node(Kind::text, std::string(text)); }
JsonNode json_number(std::string_view as_written) {
  return pipeline::json_node(Kind::number, std::string(as_written));
}
JsonNode json_truth(bool truth) {
  JsonNode node = pipeline::json_node(Kind::boolean);
  node.truth = truth;
  return node;
}
JsonNode json_list(std::vector<JsonNode> elements) {
  JsonNode node = pipeline::json_node(Kind::list);
  node.elements = std::move(elements);
  return node;
}
JsonNode json_texts(const std::vector<std::string>& texts) {
  JsonNode node = pipeline::json_node(Kind::list);
  for (const std::string& text : texts) node.elements.push_back(json_text(text));
  return node;
}
JsonNode json_object(std::vector<JsonMember> members) {
  JsonNode node = pipeline::json_node(Kind::object);
  node.members = std::move(members);
  return node;
}

std::string write_json(const JsonNode& node) { return indented(node, 0, 0) + "\n"; }

}  // namespace gradus
