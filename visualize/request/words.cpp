#include "request/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "request/complaint.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus {
namespace {

using SymbolTexts = std::vector<std::string>;

/// "p=d": the topic's symbol and what the reader calls it.
SymbolLabel label_in(std::string_view text, std::string_view topic) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse_flag("label", "a symbol and a name for it like p=d", shown(text));
  const std::string symbol(trimmed(text.substr(0, equals)));
  const SymbolTexts symbols = topic_symbols(topic);
  if (!topic.empty() && std::ranges::find(symbols, symbol) == symbols.end())
    refuse_flag("label", expected_symbol(topic), shown(symbol) + suggestion(symbol, symbols));
  return {symbol, drawable("label", text.substr(equals + 1), Face::bold)};
}

}  // namespace

std::size_t letters_in(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string expected_length() { return fmt::format("a text of up to {} letters", longest_text); }
std::string found_length(std::string_view text) { return fmt::format("one of {}", letters_in(text)); }

std::string drawable(std::string_view flag, std::string_view text, Face face) {
  const std::string_view word = trimmed(text);
  if (word.empty()) refuse_flag(flag, "a text", shown(text));
  if (word.find('\n') != std::string_view::npos) refuse_flag(flag, "a text on one line", shown(text));
  if (letters_in(word) > longest_text) refuse_flag(flag, expected_length(), found_length(word));
  if (const auto missing = missing_glyph(word, face)) {
    refuse_flag(flag, fmt::format("letters that can be drawn ({})", explained(*missing)), shown(text));
  }
  return std::string(word);
}

std::string read_language(Wording& wording, std::string_view text) {
  std::vector<std::string> codes;
  for (const Language& language : languages()) codes.push_back(language.code());
  const Language& language = languages()[choose_value("language", text, codes)];
  wording = wording.with(language);
  return &language == &languages().front() ? "" : language.code();
}

std::string read_numbers(Wording& wording, const std::string& text) {
  const std::vector<std::string> names{"decimals", "fractions"};
  const auto numbers = static_cast<Numbers>(choose_value("numbers", text, names));
  wording = wording.with(numbers);
  return numbers == Numbers::decimals ? "" : text;
}

std::string expected_symbol(std::string_view topic) {
  const SymbolTexts symbols = topic_symbols(topic);
  if (symbols.empty()) return fmt::format("no symbol: {} uses none", topic);
  return fmt::format("one of the symbols {}", fmt::join(symbols, ", "));
}

void apply_labels(Wording& wording, std::string_view topic, std::span<const std::string> given) {
  std::vector<SymbolLabel> labels = wording.labels();
  if (given.empty()) return;
  const auto known_to_notation = [&](const std::string& symbol) {
    return !topic.empty() && wording.with(std::vector<SymbolLabel>{}).about(topic).renames(symbol);
  };
  for (const std::string& text : given) {
    const SymbolLabel label = label_in(text, topic);
    std::erase_if(labels, [&label](const SymbolLabel& known) { return known.symbol == label.symbol; });
    // A symbol of the code under its own name says something where the notation has another
    if (label.symbol != label.text || known_to_notation(label.symbol)) labels.push_back(label);
  }
  std::ranges::sort(labels, {}, &SymbolLabel::symbol);
  wording = wording.with(std::move(labels));
}

}  // namespace gradus
