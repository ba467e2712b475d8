#include "figure/wording.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace gradus {

std::string_view language_text(std::string_view path);  // made by the build from figure/language/

namespace {

std::string_view stripped(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Calls see(text before, symbol) for every [symbol] of a template; returns the text behind the last one.
template <class See>
std::string_view split_at_symbols(std::string_view text, See see) {
  while (true) {
    const std::size_t open = text.find('['), close = text.find(']', open);
    if (open == std::string_view::npos || close == std::string_view::npos) return text;
    see(text.substr(0, open), text.substr(open + 1, close - open - 1));
    text.remove_prefix(close + 1);
  }
}

/// A label's braces stand for themselves.
std::string without_places(std::string_view text) {
  std::string safe;
  for (const char c : text) safe += c == '{' || c == '}' ? std::string(2, c) : std::string(1, c);
  return safe;
}

}  // namespace

Language::Language(std::string code, std::string_view catalogue) : code_(std::move(code)) {
  std::string section;
  for (int number = 1; !catalogue.empty(); ++number) {
    const std::size_t end = std::min(catalogue.find('\n'), catalogue.size());
    const std::string_view line = stripped(catalogue.substr(0, end));
    catalogue.remove_prefix(std::min(end + 1, catalogue.size()));
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '[' && line.back() == ']') {
      section = std::string(line.substr(1, line.size() - 2)) + ".";
      continue;
    }
    const std::size_t equals = line.find('=');
    const std::string key = section + std::string(stripped(line.substr(0, equals)));
    const bool readable = equals != std::string_view::npos && equals > 0;
    if (!readable || !texts_.emplace(key, stripped(line.substr(equals + 1))).second) {
      throw std::logic_error(
          fmt::format("language {}, line {}: expected a new \"key = text\", found {}", code_, number, line));
    }
  }
}

const std::string& Language::text(std::string_view key) const {
  const auto found = texts_.find(key);
  if (found == texts_.end()) throw std::logic_error(fmt::format("language {} has no text {}", code_, key));
  return found->second;
}

std::span<const Language> languages() {
  static const std::array all{Language("en", language_text("en.txt")),
                              Language("de", language_text("de.txt"))};
  return all;
}

const Language* find_language(std::string_view code) {
  const auto found = std::ranges::find(languages(), code, &Language::code);
  return found == languages().end() ? nullptr : &*found;
}

Wording::Wording() : language_(&languages().front()) {}

std::string Wording::symbol(std::string_view name) const {
  const auto found = std::ranges::find(labels_, name, &SymbolLabel::symbol);
  return found == labels_.end() ? std::string(name) : found->text;
}

std::string Wording::with_symbols(std::string_view key) const {
  std::string text;
  const std::string_view rest =
      split_at_symbols(language_->text(key), [&](std::string_view before, std::string_view name) {
        text += before;
        text += without_places(symbol(name));
      });
  return text.append(rest);
}

std::vector<std::string> symbols_in(std::string_view text) {
  std::vector<std::string> names;
  split_at_symbols(text, [&names](std::string_view, std::string_view name) {
    if (std::ranges::find(names, name) == names.end()) names.emplace_back(name);
  });
  return names;
}

}  // namespace gradus
