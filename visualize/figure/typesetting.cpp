#include "figure/typesetting.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "figure/metrics.hpp"

namespace gradus {
namespace {

bool is_small_latin(char32_t c) { return U'a' <= c && c <= U'z'; }
bool is_letter(char32_t c) {
  const bool latin = is_small_latin(c) || (U'A' <= c && c <= U'Z') || (0xc0 <= c && c <= 0x24f && c != U'×');
  return latin || (0x370 <= c && c <= 0x3ff);
}
bool is_digit_sign(char32_t c) { return U'0' <= c && c <= U'9'; }
/// What may follow a name's letters: primes, indices.
bool is_appendix(char32_t c) { return c == U'′' || c == U'″' || (0x2080 <= c && c <= 0x209c); }

/// Characters of a text, and the byte at which each begins.
struct Characters {
  std::u32string all;
  std::vector<std::size_t> at;

  explicit Characters(std::string_view text) : all(code_points(text)) {
    std::size_t byte = 0;
    for (const char32_t c : all) {
      at.push_back(byte);
      byte += utf8_of({&c, 1}).size();
    }
    at.push_back(byte);
  }
};

/// English has a word of one letter. It is the article where a word follows.
bool is_article(std::string_view text, const Token& token, std::string_view language) {
  if (language != "en" || text.substr(token.begin, token.end - token.begin) != "a" || token.begin == 0)
    return false;
  const std::string_view rest = text.substr(token.end);
  return rest.size() >= 2 && rest[0] == ' ' && is_small_latin(static_cast<unsigned char>(rest[1]));
}

Face slanted(Face face) {
  if (face == Face::sans) return Face::italic;
  if (face == Face::bold) return Face::bold_italic;
  return face;
}
bool is_listing(Face face) { return face == Face::mono || face == Face::mono_bold; }

class Typesetter {
 public:
  explicit Typesetter(const Trace& trace) : trace_(trace), variables_(variables_of(trace)) {}

  void set(TextShape& text, const std::string& id) const {
    const bool code = is_listing(text.face);
    const std::string_view language = trace_.wording.language().code();
    for (const Token& token : tokens_of(text.text)) {
      const std::string_view name = std::string_view(text.text).substr(token.begin, token.end - token.begin);
      TextSpan span{token.begin, token.end, text.face, text.paint};
      if (!code && std::ranges::binary_search(variables_, name) && !is_article(text.text, token, language))
        span.face = slanted(text.face);
      if (const auto quantity = quantity_called(name, code); quantity && !text.is_rim())
        span.paint = Paint::quantity(*quantity);
      if (span.face != text.face || span.paint != text.paint) text.spans.push_back(span);
    }
    if (const auto quantity = quantity_in_cell(id)) text.paint = Paint::quantity(*quantity);
  }

 private:
  std::optional<int> index_of(auto&& is_it) const {
    const auto found = std::ranges::find_if(trace_.quantities, is_it);
    if (found == trace_.quantities.end() || found - trace_.quantities.begin() >= quantity_colors) return {};
    return static_cast<int>(found - trace_.quantities.begin());
  }
  std::optional<int> quantity_called(std::string_view name, bool code) const {
    return index_of(
        [&](const std::string& symbol) { return name == (code ? symbol : trace_.wording.symbol(symbol)); });
  }
  /// A cell of the table is called by its column.
  std::optional<int> quantity_in_cell(std::string_view id) const {
    if (!id.starts_with("cell ")) return {};
    const std::string_view column = id.substr(id.rfind(' ') + 1);
    return index_of([&](const std::string& symbol) { return column == symbol; });
  }

  const Trace& trace_;
  std::vector<std::string> variables_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view text) {
  const Characters characters(text);
  const std::u32string& c = characters.all;
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < c.size();) {
    if (!is_letter(c[i]) && c[i] != U'_') {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < c.size() && (is_letter(c[end]) || is_digit_sign(c[end]) || c[end] == U'_')) ++end;
    while (end < c.size() && is_appendix(c[end])) ++end;
    // "NE's" and "it's" have no s, "1e-8" has no e
    const bool after_apostrophe = i > 0 && (c[i - 1] == U'\'' || c[i - 1] == U'’');
    const bool exponent = i > 0 && is_digit_sign(c[i - 1]) && c[i] == U'e' && end < c.size() &&
                          (c[end] == U'-' || c[end] == U'−' || c[end] == U'+');
    if (!after_apostrophe && !exponent) tokens.push_back({characters.at[i], characters.at[end]});
    i = end;
  }
  return tokens;
}

bool is_variable(std::string_view name) {
  std::u32string letters = code_points(name);
  std::erase_if(letters, [](char32_t c) { return is_appendix(c) || is_digit_sign(c); });
  const auto is_small = [](char32_t c) { return is_small_latin(c) || (0x3b1 <= c && c <= 0x3c9); };
  if (letters.size() == 1) return is_small(letters[0]);
  return letters.size() == 2 && letters[0] == U'd' && is_small(letters[1]);
}

std::vector<std::string> variables_of(const Trace& trace) {
  std::set<std::string> names{"x", "y", "z", "w", "t"};
  for (const std::string& symbol : topic_symbols(trace.topic)) names.insert(trace.wording.symbol(symbol));
  std::erase_if(names, [](const std::string& name) { return !is_variable(name); });
  return {names.begin(), names.end()};
}

void typeset(Sheet& sheet, const Trace& trace) {
  const Typesetter typesetter(trace);
  for (Shape& shape : sheet.shapes) {
    if (auto* text = std::get_if<TextShape>(&shape.what)) typesetter.set(*text, shape.id);
  }
}

}  // namespace gradus
