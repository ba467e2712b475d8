#include "scene/located_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <unordered_set>

#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/decimal.hpp"

namespace gradus::pipeline {
namespace {

using Kind = JsonNode::Kind;

constexpr int deepest = 64;

bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }

void append_utf8(std::string& text, std::uint32_t code) {
  const auto byte = [&text](std::uint32_t value) { text += static_cast<char>(value); };
  const auto tail = [&](int shift) { byte(0x80 | (code >> shift & 0x3f)); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xc0 | code >> 6), tail(0);
  } else if (code < 0x10000) {
    byte(0xe0 | code >> 12), tail(6), tail(0);
  } else {
    byte(0xf0 | code >> 18), tail(12), tail(6), tail(0);
  }
}

class JsonReader {
 public:
  JsonReader(std::string_view text, const std::string& file) : text_(text), file_(file) {
    if (text.starts_with("\xef\xbb\xbf")) at_ = 3;
  }

  JsonNode whole() {
    skip_space();
    JsonNode node = value(0);
    skip_space();
    if (at_ < text_.size()) refuse("the end of the file", found());
    return node;
  }

 private:
  [[noreturn]] void refuse(std::string_view expected, std::string_view what) const {
    refuse_input(fmt::format("{}:{}: expected {}, found {}", file_, line_, expected, what));
  }

  char now() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  std::string_view rest() const { return text_.substr(at_); }

  void skip_space() {
    for (; now() == ' ' || now() == '\t' || now() == '\r' || now() == '\n'; ++at_) line_ += now() == '\n';
  }
  bool skip(char c) {
    if (now() != c || at_ >= text_.size()) return false;
    ++at_;
    return true;
  }

  /// What stands here instead, and what is known to be meant by it.
  std::string found() const {
    if (at_ >= text_.size()) return "the end of the file";
    std::size_t end = at_ + std::max<std::size_t>(character_size(rest()), 1);
    if (now() == '"') {
      end = std::min(text_.find_first_of("\"\n", end), text_.size() - 1) + 1;
    } else if (is_letter(now()) || is_digit(now())) {
      while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
    }
    const std::string_view text = text_.substr(at_, end - at_);
    const std::string what = shown(text.substr(0, text.find_last_not_of(" \t\r\n") + 1));
    if (now() == '\'') return what + " (JSON takes double quotes)";
    if (now() == '#' || rest().starts_with("//") || rest().starts_with("/*")) {
      return what + " (JSON has no comments)";
    }
    return what;
  }

  JsonNode value(int depth) {
    const int line = line_;
    JsonNode node = unplaced_value(depth);
    node.line = line;
    return node;
  }

  JsonNode unplaced_value(int depth) {
    if (now() == '{') return object(depth);
    if (now() == '[') return list(depth);
    if (now() == '"') return json_node(Kind::text, string("a text"));
    if (now() == '-' || is_digit(now())) return number();
    for (const std::string_view name : {"true", "false", "null"}) {
      if (!rest().starts_with(name) ||
          (at_ + name.size() < text_.size() &&
           (is_letter(text_[at_ + name.size()]) || is_digit(text_[at_ + name.size()])))) {
        continue;
      }
      at_ += name.size();
      JsonNode node = json_node(name == "null" ? Kind::null : Kind::boolean);
      node.truth = name == "true";
      return node;
    }
    refuse("a value (a text in double quotes, a number, true, false, a list or an object)", found());
  }

  void enter(int depth) const {
    if (depth >= deepest) refuse(fmt::format("at most {} levels", deepest), "one more");
  }

  JsonNode object(int depth) {
    enter(depth);
    JsonNode node = json_node(Kind::object);
    std::unordered_set<std::string> keys;
    ++at_;
    skip_space();
    if (skip('}')) return node;
    while (true) {
      const int line = line_;
      std::string key = string(node.members.empty() ? "a key in double quotes or '}'"
                                                    : "another key in double quotes after the comma");
      if (!keys.insert(key).second) {
        refuse(fmt::format("the key {} once (it stands in line {} too)", shown(key), node.member(key)->line),
               "it again");
      }
      skip_space();
      if (!skip(':')) refuse(fmt::format("':' after the key {}", shown(key)), found());
      skip_space();
      JsonNode content = value(depth + 1);
      node.members.push_back({std::move(key), line, std::move(content)});
      skip_space();
      if (skip('}')) return node;
      if (!skip(',')) {
        refuse(fmt::format("',' or '}}' after the value of {}", shown(node.members.back().key)), found());
      }
      skip_space();
    }
  }

  JsonNode list(int depth) {
    enter(depth);
    JsonNode node = json_node(Kind::list);
    ++at_;
    skip_space();
    if (skip(']')) return node;
    while (true) {
      if (!node.elements.empty() && now() == ']') refuse("another value after the comma", found());
      node.elements.push_back(value(depth + 1));
      skip_space();
      if (skip(']')) return node;
      if (!skip(',')) refuse("',' or ']' after a value of a list", found());
      skip_space();
    }
  }

  JsonNode number() {
    const std::size_t start = at_;
    const auto digits = [this] {
      if (!is_digit(now())) refuse("a digit", found());
      while (is_digit(now())) ++at_;
    };
    skip('-');
    if (now() == '0' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1])) {
      refuse("a number without leading zeros", found());
    }
    digits();
    if (skip('.')) digits();
    if (now() == 'e' || now() == 'E') {
      ++at_;
      if (now() == '+' || now() == '-') ++at_;
      digits();
    }
    return json_node(Kind::number, std::string(text_.substr(start, at_ - start)));
  }

  std::string string(std::string_view expected) {
    if (!skip('"')) refuse(expected, found());
    std::string out;
    while (!skip('"')) {
      if (at_ >= text_.size() || now() == '\n')
        refuse("'\"' at the end of a text", at_ < text_.size() ? "the end of the line" : found());
      if (static_cast<unsigned char>(now()) < 0x20) {
        refuse("\\t or another escape in a text", fmt::format("the control character U+{:04X}", now()));
      }
      if (skip('\\')) {
        escape(out);
        continue;
      }
      const std::size_t length = character_size(rest());
      if (length == 0) {
        refuse("a text in UTF-8", fmt::format("the byte 0x{:02x}", static_cast<unsigned char>(now())));
      }
      out += rest().substr(0, length);
      at_ += length;
    }
    return out;
  }

  void escape(std::string& out) {
    constexpr std::string_view names = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
    const std::size_t which = at_ < text_.size() ? names.find(now()) : std::string_view::npos;
    if (which != std::string_view::npos) {
      ++at_;
      out += meanings[which];
      return;
    }
    if (!skip('u')) refuse("one of \" \\ / b f n r t u after a backslash (write \\\\ for itself)", found());
    std::uint32_t code = four_digits();
    const bool high = 0xd800 <= code && code < 0xdc00, low = 0xdc00 <= code && code < 0xe000;
    if (high && rest().starts_with("\\u")) {
      at_ += 2;
      const std::uint32_t second = four_digits();
      if (0xdc00 <= second && second < 0xe000) {
        append_utf8(out, 0x10000 + ((code - 0xd800) << 10) + (second - 0xdc00));
        return;
      }
    }
    if (high || low) refuse("both halves of a surrogate pair", fmt::format("\\u{:04x} alone", code));
    append_utf8(out, code);
  }

  std::uint32_t four_digits() {
    std::uint32_t code = 0;
    for (int i = 0; i < 4; ++i) {
      const std::size_t digit = std::string_view("0123456789abcdefABCDEF").find(now());
      if (at_ >= text_.size() || digit == std::string_view::npos) {
        refuse("four hexadecimal digits after \\u", found());
      }
      code = code << 4 | static_cast<std::uint32_t>(digit < 16 ? digit : digit - 6);
      ++at_;
    }
    return code;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

const JsonMember* JsonNode::member(std::string_view key) const {
  const auto found = std::ranges::find(members, key, &JsonMember::key);
  return found == members.end() ? nullptr : &*found;
}

JsonNode json_node(JsonNode::Kind kind, std::string text) {
  JsonNode node;
  node.kind = kind;
  node.text = std::move(text);
  return node;
}

bool begins_as_json(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

JsonNode read_json(std::string_view text, const std::string& file) { return JsonReader(text, file).whole(); }

std::string described(const JsonNode& node) {
  switch (node.kind) {
    case Kind::null:
      return "null";
    case Kind::boolean:
      return node.truth ? "true" : "false";
    case Kind::number:
      return node.text;
    case Kind::text:
      return shown(node.text);
    case Kind::list:
      return node.elements.empty() ? "an empty list" : "a list";
    case Kind::object:
      return "an object";
  }
  return node.text;
}

}  // namespace gradus::pipeline
