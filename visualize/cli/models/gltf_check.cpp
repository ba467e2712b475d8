#include "cli/models/gltf_check.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/models/gltf_data.hpp"
#include "cli/models/gltf_json.hpp"
#include "cli/models/imported_model.hpp"
#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/located_json.hpp"
#include "scene/models/little_endian.hpp"

namespace gradus::cli {
namespace {

using pipeline::JsonNode;
using Kind = JsonNode::Kind;

/// What its scenes say.
class SceneCheck : GltfJson {
 public:
  using GltfJson::GltfJson;

  void check(const JsonNode& root) const {
    check_extensions(root);
    check_nodes(list_of(root, "nodes"));
    for (const JsonNode& node : list_of(root, "nodes")) check_placement(node);
    for (const JsonNode& scene : list_of(root, "scenes")) check_roots(list_of(scene, "nodes"));
  }

 private:
  /// Without these, data could not be read or would be others. What extensions say of lamps and materials is
  /// left out, where they are.
  void check_extensions(const JsonNode& root) const {
    for (const JsonNode& extension : list_of(root, "extensionsRequired")) {
      const std::string& name = extension.text;
      const bool known = name.starts_with("KHR_materials_") || name == "KHR_lights_punctual" ||
                         name == "KHR_texture_transform";
      if (!known) refuse(extension, "a file whose data need no extension", described(extension));
    }
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

  void check_placement(const JsonNode& node) const {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 4> parts{
        {{"matrix", 16}, {"translation", 3}, {"rotation", 4}, {"scale", 3}}};
    for (const auto& [key, count] : parts) {
      const List& numbers = list_of(node, key);
      if (!node.member(key)) continue;
      if (numbers.size() != count)
        refuse(node.member(key)->value, fmt::format("{} numbers in a {}", count, key),
               std::to_string(numbers.size()));
      for (const JsonNode& number : numbers)
        if (number.kind != Kind::number)
          refuse(number, fmt::format("numbers in a {}", key), described(number));
    }
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
};

/// The chunk that begins here in a GLB file, of this kind: a length of 4 bytes, the kind, the bytes.
std::optional<std::string_view> chunk_at(std::string_view bytes, std::size_t at, std::string_view kind) {
  constexpr std::size_t head = 8;
  if (bytes.size() < at + head || bytes.substr(at + 4, 4) != kind) return std::nullopt;
  return bytes.substr(at + head, static_cast<std::size_t>(pipeline::whole_at(bytes, at, 4)));
}

}  // namespace

void check_gltf(std::string_view bytes, const pipeline::TextFile& file, const pipeline::FileReader& open) {
  constexpr std::size_t head = 12;
  std::optional<std::string_view> json = bytes, binary;
  if (bytes.starts_with("glTF")) {
    json = chunk_at(bytes, head, "JSON");
    if (json) binary = chunk_at(bytes, head + 8 + json->size(), {"BIN\0", 4});
  }
  if (!json) return;
  const std::string called = shown_name(file.name);
  try {
    const JsonNode root = pipeline::read_json(*json, called);
    if (root.kind != Kind::object) GltfJson(called).refuse(root, "a glTF object", described(root));
    SceneCheck(called).check(root);
    check_gltf_data(root, called, binary, open);
  } catch (const InputError&) {
    if (file.quotable) throw;
    refuse_input(called + ": expected a glTF file, found something else");
  }
}

}  // namespace gradus::cli
