#pragma once
// The JSON of glTF files, as checks read it.

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/refusal.hpp"
#include "scene/located_json.hpp"

namespace gradus::cli {

class GltfJson {
 public:
  using List = std::vector<pipeline::JsonNode>;

  /// file: how mistakes call it; it must outlive this.
  explicit GltfJson(const std::string& file) : file_(file) {}

  /// Throws InputError with the line of a value.
  [[noreturn]] void refuse(const pipeline::JsonNode& at, std::string_view expected,
                           std::string_view found) const {
    refuse_input(fmt::format("{}:{}: expected {}, found {}", file_, at.line, expected, found));
  }

  /// The list of this key; an empty one when there is none.
  const List& list_of(const pipeline::JsonNode& object, std::string_view key) const {
    static const List none;
    const auto* member = object.member(key);
    if (!member) return none;
    if (member->value.kind != pipeline::JsonNode::Kind::list)
      refuse(member->value, fmt::format("a list of {}, as in glTF 2.0", key), described(member->value));
    return member->value.elements;
  }

  /// A whole number of JSON, if it is one from 0 to below `limit`.
  static std::optional<std::size_t> number_below(const pipeline::JsonNode& node, std::size_t limit) {
    std::size_t number = 0;
    const char* const end = node.text.data() + node.text.size();
    const auto read = std::from_chars(node.text.data(), end, number);
    if (node.kind != pipeline::JsonNode::Kind::number || read.ec != std::errc{} || read.ptr != end ||
        number >= limit)
      return std::nullopt;
    return number;
  }

  /// The number of this key from 0 to `most`, which is refused where it is another; `otherwise` without the
  /// key.
  std::size_t number_of(const pipeline::JsonNode& object, std::string_view key, std::size_t most,
                        std::size_t otherwise = 0) const {
    const auto* member = object.member(key);
    if (!member) return otherwise;
    const auto number = number_below(member->value, most + 1);
    if (!number)
      refuse(member->value, fmt::format("a whole number up to {}", most), described(member->value));
    return *number;
  }

  /// What another part names by its number: the element of a list, if this key is there.
  const pipeline::JsonNode* named_by(const pipeline::JsonNode& object, std::string_view key, const List& list,
                                     std::string_view what) const {
    const auto* member = object.member(key);
    if (!member) return nullptr;
    const auto number = number_below(member->value, list.size());
    if (!number)
      refuse(member->value, fmt::format("one of the {} {}, from 0", list.size(), what),
             described(member->value));
    return &list[*number];
  }

 private:
  const std::string& file_;
};

}  // namespace gradus::cli
