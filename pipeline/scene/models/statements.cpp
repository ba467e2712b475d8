#include "scene/models/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/decimal.hpp"
#include "scene/models/letters.hpp"

namespace gradus::pipeline {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && Statement::is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && Statement::is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Whether a decimal number that lies outside the doubles is too small for them, not too large: whether
/// its first digit stands behind the point.
bool vanishes(std::string_view number) {
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::string_view digits = number.substr(0, e), power = number.substr(std::min(e + 1, number.size()));
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  const auto first = static_cast<std::int64_t>(digits.find_first_of("123456789"));
  std::int64_t exponent = 0;
  const auto [end, error] = std::from_chars(power.data(), power.data() + power.size(), exponent);
  if (error == std::errc::result_out_of_range) return power.front() == '-';
  return point - first + exponent < 0;
}

}  // namespace

std::string_view Statement::rest() {
  const std::string_view text = trimmed({at_, static_cast<std::size_t>(end_ - at_)});
  at_ = end_;
  return text;
}

double Statement::number(std::string_view what) {
  const std::string_view text = word();
  if (text.empty()) fail(fmt::format("expected a number for {}, found none", what));
  return number(what, text);
}

double Statement::number(std::string_view what, std::string_view text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (text.size() > 1 && *begin == '+' && begin[1] != '-') ++begin;
  double value = 0;
  const auto [stopped, error] = read_decimal(begin, end, value);
  if (error == std::errc::result_out_of_range && vanishes({begin, end})) return *begin == '-' ? -0.0 : 0.0;
  if (error == std::errc::result_out_of_range)
    fail(fmt::format("expected a number of at most {} for {}, found {}", largest, what, quoted(text)));
  if (error != std::errc{} || stopped != end) {
    fail(fmt::format("expected a number for {}, found {}", what, quoted(text)));
  }
  if (!std::isfinite(value))
    fail(fmt::format("expected a finite number for {}, found {}", what, quoted(text)));
  if (std::abs(value) > largest) {
    fail(fmt::format("expected a number of at most {} for {}, found {}", largest, what, quoted(text)));
  }
  return value;
}

std::int64_t Statement::whole(std::string_view what, std::int64_t least, std::int64_t most) {
  const std::string_view text = word();
  std::int64_t value = 0;
  const auto [stopped, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stopped != text.data() + text.size() || value < least || value > most)
    fail(fmt::format("expected {}, a whole number from {} to {}, found {}", what, least, most,
                     text.empty() ? "none" : quoted(text)));
  return value;
}

bool Statement::is_no_number(std::string_view word) {
  const std::string_view size = word.substr(std::min(word.find_first_not_of("+-"), word.size()));
  const std::string name = in_small_letters(size);
  return name.starts_with("nan") || name.starts_with("inf") || name.starts_with("1.#");
}

void Statement::end(std::string_view after) {
  if (more()) fail(fmt::format("expected nothing after {}, found {}", after, quoted(word())));
}

std::string Statement::quoted(std::string_view word) const {
  return file_->quotable ? shown(word) : "something else";
}

std::string Statement::quoted(double number) const {
  return file_->quotable ? fmt::format("{}", number) : "something else";
}

std::string Statement::place(std::string_view text) const {
  return fmt::format("{}:{}: {}", shown_name(file_->name), line_, text);
}

void Statement::fail(std::string_view text) const { refuse_input(place(text)); }

Statements::Statements(std::string_view text, const TextFile& file, Backslash backslash)
    : text_(text), file_(file), backslash_(backslash) {
  const auto begins = [text](std::string_view mark) { return text.substr(0, mark.size()) == mark; };
  if (begins("\xFF\xFE") || begins("\xFE\xFF")) {
    refuse_input(fmt::format("{}: expected text in UTF-8 or ASCII, found UTF-16", shown_name(file.name)));
  }
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos) {
    refuse_input(fmt::format("{}: expected text, found a zero at byte {}", shown_name(file.name), zero));
  }
  if (begins("\xEF\xBB\xBF")) at_ = 3;
}

std::string_view Statements::line() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
  const std::string_view found = text_.substr(begin, at_ - begin);
  if (at_ < text_.size() && text_[at_] == '\r') ++at_;
  if (at_ < text_.size() && text_[at_] == '\n' && (at_ == begin + found.size() || text_[at_ - 1] == '\r'))
    ++at_;
  ++line_;
  return found;
}

std::optional<Statement> Statements::next() {
  while (at_ < text_.size()) {
    std::string_view text = trimmed(line());
    if (text.empty() || text.front() == '#') continue;
    const int first = line_;
    if (backslash_ == Backslash::is_a_letter || text.back() != '\\') return Statement(text, file_, first);

    joined_.clear();
    while (!text.empty() && text.back() == '\\') {
      joined_ += text.substr(0, text.size() - 1);
      joined_ += ' ';
      text = at_ < text_.size() ? trimmed(line()) : std::string_view{};
    }
    joined_ += text;
    return Statement(joined_, file_, first);
  }
  return std::nullopt;
}

void UnknownStatements::add(const Statement& s, std::string_view key) {
  constexpr std::size_t most = 16;  // a file of many kinds is something else altogether
  const auto known = std::ranges::find(known_, key, &Known::key);
  if (known != known_.end()) {
    ++known->times;
  } else if (known_.size() < most) {
    known_.push_back({std::string(key), s.place(s.file().quotable ? shown(key) : "what stands here"), 1});
  } else {
    ++more_;
  }
}

std::vector<std::string> UnknownStatements::notes(std::string_view kind) const {
  std::vector<std::string> notes;
  for (const auto& [key, place, times] : known_) {
    notes.push_back(fmt::format("{} is no known statement of {} and is left out{}", place, kind,
                                times == 1 ? "" : fmt::format(" ({} times)", times)));
  }
  if (more_ > 0)
    notes.push_back(fmt::format("{} more unknown statements of other kinds are left out", more_));
  return notes;
}

}  // namespace gradus::pipeline
