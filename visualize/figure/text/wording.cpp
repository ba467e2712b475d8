#include "figure/text/wording.hpp"

#include <fmt/args.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "core/contract.hpp"

namespace gradus {

namespace {

/// Whether brackets round this make it a symbol: p, dx, x′, but not "0, 1".
bool is_symbol(std::string_view name) {
  const auto in_name = [](char c) {
    const bool letter = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
    const bool of_another_script = static_cast<unsigned char>(c) >= 0x80;
    return letter || of_another_script || ('0' <= c && c <= '9') || c == '_' || c == '\'';
  };
  return !name.empty() && std::ranges::all_of(name, in_name) && !('0' <= name[0] && name[0] <= '9');
}

/// Calls see(text before, symbol) for every [symbol] of a template; returns the text behind the last one.
template <class See>
std::string_view split_at_symbols(std::string_view text, See see) {
  for (std::size_t from = 0;;) {
    const std::size_t open = text.find('[', from), close = text.find(']', open);
    if (open == std::string_view::npos || close == std::string_view::npos) return text;
    const std::string_view name = text.substr(open + 1, close - open - 1);
    from = open + 1;
    if (!is_symbol(name)) continue;
    see(text.substr(0, open), name);
    text.remove_prefix(close + 1);
    from = 0;
  }
}

void add_new(std::vector<std::string>& names, std::string_view name) {
  if (std::ranges::find(names, name) == names.end()) names.emplace_back(name);
}

/// Calls see(name) for every {name} of a template. What is wrong with its braces, in fmt's words; nothing
/// where they are in order.
template <class See>
std::string_view for_each_value(std::string_view text, See see) {
  for (std::size_t at = text.find_first_of("{}"); at != text.npos; at = text.find_first_of("{}", at)) {
    if (text.substr(at, 2) == "{{" || text.substr(at, 2) == "}}") {  // a brace that stands for itself
      at += 2;
      continue;
    }
    if (text[at] == '}') return "unmatched '}' in format string";
    const std::size_t end = text.find('}', at);
    if (end == text.npos) return "invalid format string";
    const std::string_view place = text.substr(at + 1, end - at - 1);
    see(place.substr(0, place.find(':')));
    at = end + 1;
  }
  return {};
}

/// What keeps the values from being put into a text; nothing where all is in order.
std::string_view mistake_in(std::string_view text, fmt::format_args values) {
  bool known = true;
  const auto check = [&](std::string_view name) {
    known = known && values.get(fmt::string_view(name.data(), name.size()));
  };
  const std::string_view wrong = for_each_value(text, check);
  return !wrong.empty() ? wrong : known ? std::string_view() : "argument not found";
}

/// A label's braces stand for themselves.
std::string without_places(std::string_view text) {
  std::string safe;
  for (const char c : text) safe += c == '{' || c == '}' ? std::string(2, c) : std::string(1, c);
  return safe;
}

}  // namespace

Wording::Wording() : language_(&languages().front()) {}

Wording Wording::with(const Language& language) const {
  Wording other = *this;
  other.language_ = &language;
  return other;
}

Wording Wording::with(std::vector<SymbolLabel> labels) const {
  Wording other = *this;
  other.labels_ = std::move(labels);
  return other;
}

Wording Wording::with(Numbers numbers) const {
  Wording other = *this;
  other.numbers_ = numbers;
  return other;
}

Wording Wording::with(Notation notation) const {
  Wording other = *this;
  other.notation_ = std::move(notation);
  return other;
}

Wording Wording::about(std::string_view topic) const {
  Wording other = *this;
  other.topic_ = topic;
  return other;
}

std::string Wording::symbol(std::string_view name) const {
  const auto label = std::ranges::find(labels_, name, &SymbolLabel::symbol);
  if (label != labels_.end()) return label->text;
  const auto of_topic = notation_.symbols.find(topic_);
  if (of_topic == notation_.symbols.end()) return std::string(name);
  const auto found = std::ranges::find(of_topic->second, name, &SymbolLabel::symbol);
  return found == of_topic->second.end() ? std::string(name) : found->text;
}

std::vector<SymbolLabel> Wording::renamed() const {
  std::vector<SymbolLabel> all = labels_;
  if (const auto found = notation_.symbols.find(topic_); found != notation_.symbols.end())
    std::ranges::copy(found->second, std::back_inserter(all));
  std::set<std::string> seen;
  std::erase_if(all,
                [&](const SymbolLabel& l) { return !seen.insert(l.symbol).second || l.symbol == l.text; });
  std::ranges::sort(all, {}, &SymbolLabel::symbol);
  return all;
}

std::string Wording::fill(std::string_view key, std::span<const NamedText> values) const {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const NamedText& value : values) store.push_back(fmt::arg(value.name.c_str(), value.text));
  return filled(key, store);
}

bool Wording::has(std::string_view key) const { return language_->has(key); }

std::string_view Wording::text(std::string_view key) const {
  if (!notation_.rows) return language_->text(key);
  std::string of_rows(key);
  of_rows.insert(of_rows.find('.') + 1, "rows.");
  return language_->text(language_->has(of_rows) ? std::string_view(of_rows) : key);
}

std::string Wording::filled(std::string_view key, fmt::format_args values) const {
  std::string text;
  const std::string_view rest =
      split_at_symbols(this->text(key), [&](std::string_view before, std::string_view name) {
        text += before;
        text += without_places(symbol(name));
      });
  text += rest;
  const std::string_view mistake = mistake_in(text, values);
  expects(mistake.empty(), "language {}, text {}: {}", language_->code(), key, mistake);
  return fmt::vformat(text, values);
}

std::vector<std::string> symbols_in(std::string_view text) {
  std::vector<std::string> names;
  split_at_symbols(text, [&names](std::string_view, std::string_view name) { add_new(names, name); });
  return names;
}

std::vector<std::string> values_in(std::string_view text) {
  std::vector<std::string> names;
  for_each_value(text, [&names](std::string_view name) { add_new(names, name); });
  return names;
}

std::vector<std::string> topic_symbols(std::string_view topic) {
  const Language::Texts texts = languages().front().texts(std::string(topic) + ".");
  std::set<std::string> names;
  for (const auto& [key, text] : texts) {
    for (std::string& name : symbols_in(text)) names.insert(std::move(name));
  }
  return {names.begin(), names.end()};
}

}  // namespace gradus
