#include "cli/gltf_check.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/imported_model.hpp"
#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/located_json.hpp"

namespace gradus::cli {
namespace {

using pipeline::JsonNode;
using Kind = JsonNode::Kind;

/// A whole number of JSON, if it is one from 0 to below `limit`.
std::optional<std::size_t> number_below(const JsonNode& node, std::size_t limit) {
  std::size_t number = 0;
  const char* const end = node.text.data() + node.text.size();
  const auto read = std::from_chars(node.text.data(), end, number);
  if (node.kind != Kind::number || read.ec != std::errc{} || read.ptr != end || number >= limit)
    return std::nullopt;
  return number;
}

class GltfCheck {
 public:
  explicit GltfCheck(const std::string& file) : file_(file) {}

  void check(const JsonNode& root) const {
    if (root.kind != Kind::object) refuse(root, "a glTF object", described(root));
    check_nodes(list_of(root, "nodes"));
    for (const JsonNode& scene : list_of(root, "scenes")) check_roots(list_of(scene, "nodes"));
    for (const JsonNode& accessor : list_of(root, "accessors")) {
      const auto* count = accessor.member("count");
      if (count && !number_below(count->value, most_imported_corners + 1))
        refuse(count->value, fmt::format("a whole number up to {}", most_imported_corners),
               described(count->value));
    }
  }

 private:
  using List = std::vector<JsonNode>;

  [[noreturn]] void refuse(const JsonNode& at, std::string_view expected, std::string_view found) const {
    refuse_input(fmt::format("{}:{}: expected {}, found {}", file_, at.line, expected, found));
  }

  /// The list of this key; an empty one when there is none.
  const List& list_of(const JsonNode& object, std::string_view key) const {
    static const List none;
    const auto* member = object.member(key);
    if (!member) return none;
    if (member->value.kind != Kind::list)
      refuse(member->value, fmt::format("a list of {}, as in glTF 2.0", key), described(member->value));
    return member->value.elements;
  }

  /// Each node has one parent at most, and the way up from each ends.
  void check_nodes(const List& nodes) const {
    constexpr std::size_t none = SIZE_MAX;
    std::vector<std::size_t> parents(nodes.size(), none);
    for (std::size_t parent = 0; parent < nodes.size(); ++parent) {
      for (const JsonNode& child : list_of(nodes[parent], "children")) {
        const auto number = number_below(child, nodes.size());
        if (!number) refuse(child, fmt::format("a node from 0 to {}", nodes.size() - 1), described(child));
        if (parents[*number] != none)
          refuse(child, "nodes with one parent each", fmt::format("another one of node {}", *number));
        parents[*number] = parent;
      }
    }
    // A circle has no root from which it could be reached: what roots do not reach goes round
    std::vector<std::size_t> open;
    for (std::size_t node = 0; node < nodes.size(); ++node)
      if (parents[node] == none) open.push_back(node);
    std::size_t reached = 0;
    for (; !open.empty(); ++reached) {
      const std::size_t node = open.back();
      open.pop_back();
      for (const JsonNode& child : list_of(nodes[node], "children"))
        open.push_back(*number_below(child, nodes.size()));
    }
    if (reached < nodes.size()) refuse(nodes.front(), "nodes in trees", "some that are their own ancestors");
  }

  /// The nodes of a scene, none of them twice.
  void check_roots(const List& roots) const {
    std::vector<bool> known;
    for (const JsonNode& root : roots) {
      const auto number = number_below(root, most_imported_corners);
      if (!number) refuse(root, "a node's number", described(root));
      if (*number >= known.size()) known.resize(*number + 1);
      if (known[*number]) refuse(root, "each node once", fmt::format("node {} again", *number));
      known[*number] = true;
    }
  }

  const std::string& file_;
};

/// The JSON part of a GLB file's bytes: a header of 12 bytes, then the length and the kind of a chunk.
std::optional<std::string_view> json_in(std::string_view bytes) {
  if (!bytes.starts_with("glTF")) return bytes;  // all of it
  constexpr std::size_t head = 20;
  if (bytes.size() < head || bytes.substr(16, 4) != "JSON") return std::nullopt;
  std::size_t length = 0;
  for (std::size_t i = 4; i > 0; --i) length = length << 8 | static_cast<unsigned char>(bytes[11 + i]);
  return bytes.substr(head, length);
}

}  // namespace

void check_gltf(std::string_view bytes, const pipeline::TextFile& file) {
  const auto json = json_in(bytes);
  if (!json) return;
  const std::string called = shown_name(file.name);
  try {
    GltfCheck(called).check(pipeline::read_json(*json, called));
  } catch (const InputError&) {
    if (file.quotable) throw;
    refuse_input(called + ": expected a glTF file, found something else");
  }
}

}  // namespace gradus::cli
