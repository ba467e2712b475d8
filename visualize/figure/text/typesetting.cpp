#include "figure/text/typesetting.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "figure/text/metrics.hpp"

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

/// English has a word of one letter. It is the article where a word follows; a sentence begins with "A".
bool is_article(std::string_view text, const Token& token, std::string_view id) {
  if (text.substr(token.begin, token.end - token.begin) != "a") return false;
  if (token.begin == 0 && id == "sentence 1") return false;
  const std::string_view rest = text.substr(token.end);
  return rest.size() >= 2 && rest[0] == ' ' && is_small_latin(static_cast<unsigned char>(rest[1]));
}

Face slanted(Face face) {
  if (face == Face::sans) return Face::italic;
  if (face == Face::bold) return Face::bold_italic;
  return face;
}
/// A line of a sentence that goes on from the one before.
bool continues(std::string_view id) { return id.starts_with("sentence ") && id != "sentence 1"; }

/// Region codes: four binary digits or more, with no other letter or digit beside them.
std::vector<Token> codes_in(std::string_view text) {
  std::vector<Token> codes;
  const auto belongs = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || (c & 0x80) != 0;
  };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && (text[end] == '0' || text[end] == '1')) ++end;
    const bool alone =
        (i == 0 || !belongs(text[i - 1])) && (end == text.size() || !belongs(text[end]) ||
                                              text.substr(end, 2) == "." || text.substr(end, 2) == ". ");
    if (end >= i + 4 && alone) codes.push_back({i, end});
    i = std::max(end, i + 1);
  }
  return codes;
}

bool is_listing(Face face) { return face == Face::mono || face == Face::mono_bold; }

class Typesetter {
 public:
  Typesetter(const Trace& trace, std::span<const Row> rows) : trace_(trace), variables_(variables_of(trace)) {
    for (std::size_t c = 0; c < trace.columns.size(); ++c) {
      const auto quantity = color_of_quantity(trace, trace.columns[c]);
      if (!quantity) continue;
      for (const Row& row : rows) values_[row[c]].insert(*quantity);
    }
  }

  void set(TextShape& text, const std::string& id) {
    const bool code = is_listing(text.face);
    if (!continues(id)) named_.reset();
    const std::string_view all = text.text;
    for (const Token& token : words_of(text, id)) {
      const std::string_view word = all.substr(token.begin, token.end - token.begin);
      if (is_english(all.substr(0, token.begin), code) && is_article(all, token, id)) continue;
      TextSpan span{token.begin, token.end, text.face, text.paint};
      if (!code && std::ranges::binary_search(variables_, word)) span.face = slanted(text.face);
      const auto name = quantity_called(word, code);
      if (name) named_ = name;
      if (const auto quantity = name ? name : quantity_of_code(word); quantity && !text.is_rim())
        span.paint = Paint::quantity(*quantity);
      if (span.face != text.face || span.paint != text.paint) text.spans.push_back(span);
    }
    if (const auto quantity = quantity_in_cell(id)) text.paint = Paint::quantity(*quantity);
    // A mark's own: underlined where the theme underlines quantities, as the cells of a table are not
    if (text.paint.part == Paint::Part::quantity && text.spans.empty() && !id.starts_with("cell "))
      text.spans.push_back({0, text.text.size(), text.face, text.paint});
  }

 private:
  /// Of listings the comments, whatever the language is.
  bool is_english(std::string_view before, bool code) const {
    return code ? before.find("//") != before.npos : trace_.wording.language().code() == "en";
  }
  /// Names, and in the sentence codes.
  static std::vector<Token> words_of(const TextShape& text, std::string_view id) {
    std::vector<Token> words = tokens_of(text.text);
    if (!id.starts_with("sentence ")) return words;
    std::ranges::copy(codes_in(text.text), std::back_inserter(words));
    std::ranges::sort(words, {}, &Token::begin);
    return words;
  }
  std::optional<int> quantity_called(std::string_view name, bool code) const {
    const auto is_it = [&](const std::string& symbol) {
      return name == (code ? symbol : trace_.wording.symbol(symbol));
    };
    const auto found = std::ranges::find_if(trace_.quantities, is_it);
    return found == trace_.quantities.end() ? std::nullopt : color_of_quantity(trace_, *found);
  }
  /// Whose code this is. Where several have it, it belongs to the one that was named last.
  std::optional<int> quantity_of_code(std::string_view code) const {
    const auto found = values_.find(code);
    if (found == values_.end()) return {};
    if (found->second.size() == 1) return *found->second.begin();
    return named_ && found->second.contains(*named_) ? named_ : std::nullopt;
  }
  /// A cell of the table, or the heading over it, is called by its column.
  std::optional<int> quantity_in_cell(std::string_view id) const {
    if (!id.starts_with("cell ") && !id.starts_with("heading ")) return {};
    const auto column = std::ranges::find(trace_.columns, id.substr(id.rfind(' ') + 1), &Column::id);
    return column == trace_.columns.end() ? std::nullopt : color_of_quantity(trace_, *column);
  }

  const Trace& trace_;
  std::vector<std::string> variables_;
  std::map<std::string, std::set<int>, std::less<>> values_;  ///< whose value each cell is
  std::optional<int> named_;                                  ///< the last quantity of the text at hand
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
  for (const SymbolLabel& named : trace.named_in_the_code) names.insert(named.text);
  std::erase_if(names, [](const std::string& name) { return !is_variable(name); });
  return {names.begin(), names.end()};
}

void typeset(Sheet& sheet, const Trace& trace, std::span<const Row> rows) {
  Typesetter typesetter(trace, rows);
  for (Shape& shape : sheet.shapes) {
    if (auto* text = std::get_if<TextShape>(&shape.what)) typesetter.set(*text, shape.id);
  }
}

}  // namespace gradus
