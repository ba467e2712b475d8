#include "scene/statements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

#include "core/image.hpp"
#include "core/shown.hpp"

namespace gradus::pipeline {
namespace {

constexpr bool blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

void Statement::skip_blanks() {
  while (at_ != end_ && blank(*at_)) ++at_;
}

bool Statement::more() {
  skip_blanks();
  return at_ != end_ && *at_ != '#';
}

std::string_view Statement::word() {
  if (!more()) return {};
  const char* begin = at_;
  while (at_ != end_ && !blank(*at_)) ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

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
  const auto [stopped, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range)
    fail(fmt::format("expected a number of at most {} for {}, found {}", largest, what, shown(text)));
  if (error != std::errc{} || stopped != end) {
    fail(fmt::format("expected a number for {}, found {}", what, shown(text)));
  }
  if (!std::isfinite(value))
    fail(fmt::format("expected a finite number for {}, found {}", what, shown(text)));
  if (std::abs(value) > largest) {
    fail(fmt::format("expected a number of at most {} for {}, found {}", largest, what, shown(text)));
  }
  return value;
}

void Statement::end(std::string_view after) {
  if (more()) fail(fmt::format("expected nothing after {}, found {}", after, shown(word())));
}

std::string Statement::place(std::string_view text) const {
  return fmt::format("{}:{}: {}", shown_name(file_), line_, text);
}

void Statement::fail(std::string_view text) const { throw InputError(place(text)); }

Statements::Statements(std::string_view text, const std::string& file) : text_(text), file_(file) {
  const auto begins = [text](std::string_view mark) { return text.substr(0, mark.size()) == mark; };
  if (begins("\xFF\xFE") || begins("\xFE\xFF")) {
    throw InputError(fmt::format("{}: expected text in UTF-8 or ASCII, found UTF-16", shown_name(file)));
  }
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos) {
    throw InputError(fmt::format("{}: expected text, found a zero at byte {}", shown_name(file), zero));
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
    if (text.back() != '\\') return Statement(text, file_, first);

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

}  // namespace gradus::pipeline
