// JSON with places: accepts what nlohmann_json accepts but for its own limits, with the same values; what it
// writes it reads back; every error names file and line.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/image.hpp"
#include "json/json.hpp"
#include "request/written_json.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::JsonNode;
using gradus::test::require;

namespace {

bool same(const JsonNode& a, const JsonNode& b) {
  if (a.kind != b.kind || a.text != b.text || a.truth != b.truth) return false;
  if (a.elements.size() != b.elements.size() || a.members.size() != b.members.size()) return false;
  for (std::size_t i = 0; i < a.elements.size(); ++i) {
    if (!same(a.elements[i], b.elements[i])) return false;
  }
  for (std::size_t i = 0; i < a.members.size(); ++i) {
    if (a.members[i].key != b.members[i].key || !same(a.members[i].value, b.members[i].value)) return false;
  }
  return true;
}

bool is_theirs(const JsonNode& node, const nlohmann::json& theirs) {
  switch (node.kind) {
    case JsonNode::Kind::null:
      return theirs.is_null();
    case JsonNode::Kind::boolean:
      return theirs.is_boolean() && theirs.get<bool>() == node.truth;
    case JsonNode::Kind::number:
      return theirs.is_number();
    case JsonNode::Kind::text:
      return theirs.is_string() && theirs.get_ref<const std::string&>() == node.text;
    case JsonNode::Kind::list:
      if (!theirs.is_array() || theirs.size() != node.elements.size()) return false;
      for (std::size_t i = 0; i < node.elements.size(); ++i) {
        if (!is_theirs(node.elements[i], theirs[i])) return false;
      }
      return true;
    case JsonNode::Kind::object:
      if (!theirs.is_object() || theirs.size() != node.members.size()) return false;
      for (const JsonMember& member : node.members) {
        if (!theirs.contains(member.key) || !is_theirs(member.value, theirs[member.key])) return false;
      }
      return true;
  }
  return false;
}

/// Why ours may refuse what theirs accepts: more than 64 levels, a key twice, a number beyond double.
bool has_own_reason(const std::string& what) {
  for (const char* reason : {"levels", "twice", "once"}) {
    if (what.find(reason) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const nlohmann::json theirs = nlohmann::json::parse(text, nullptr, false);
  try {
    const JsonNode ours = read_json(text, "j.json");
    // Numbers beyond the range of double are none to them, and only text to us
    if (theirs.is_discarded()) {
      bool beyond = false;
      try {
        [[maybe_unused]] const auto parsed = nlohmann::json::parse(text);
      } catch (const nlohmann::json::exception& error) {
        beyond = error.id == 406;
      }
      require(beyond, "what is read as JSON is JSON");
    } else {
      require(is_theirs(ours, theirs), "values are those that others read");
    }
    require(same(read_json(write_json(ours), "again.json"), ours), "what is written is read back");
    require(test::harmless(described(ours)), "a value in a message is safe to show");
  } catch (const InputError& error) {
    const std::string what = error.what();
    require(what.starts_with("j.json:"), "an error names its file");
    require(test::harmless(what), "an error is safe to show");
    // To them a zero byte ends the text
    const bool ends_early = text.find('\0') != std::string_view::npos;
    require(theirs.is_discarded() || ends_early || has_own_reason(what), "JSON is read");
  }
  static_cast<void>(parse_manifest(text));
  const std::string quoted = json_quoted(text);
  const nlohmann::json literal = nlohmann::json::parse(quoted, nullptr, false);
  require(literal.is_string() && test::harmless(quoted), "a quoted text is a literal");
  for (const char* live : {"</", "<!", "<s", "<S", "-->"}) {
    require(quoted.find(live) == std::string::npos, "a quoted text is safe inside a page");
  }
  return 0;
}
