#pragma once
// What a sentence claims with its numbers: equalities and comparisons such as "w − x = 2 − 3 = −1 < 0" are
// read out of it and checked, each number with the rounding that it is printed with.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gradus::test {

/// Every number that a printed one may stand for.
struct Range {
  long double least = 0, most = 0;
};

/// A number, or the components of a vector.
using Quantity = std::vector<Range>;

namespace claims {

inline constexpr long double infinite = std::numeric_limits<long double>::infinity();

/// Outwards by what long double itself may round off.
inline Range widened(long double least, long double most) {
  if (std::isnan(least) || std::isnan(most)) return {-infinite, infinite};
  const auto slack = [](long double v) { return std::isinf(v) ? 0 : 1e-17L * std::abs(v); };
  return {least - slack(least), most + slack(most)};
}
inline Range sum(Range a, Range b) { return widened(a.least + b.least, a.most + b.most); }
inline Range negative(Range a) { return {-a.most, -a.least}; }
inline Range product(Range a, Range b) {
  const auto times = [](long double x, long double y) { return x == 0 || y == 0 ? 0 : x * y; };
  const auto [least, most] = std::minmax(
      {times(a.least, b.least), times(a.least, b.most), times(a.most, b.least), times(a.most, b.most)});
  return widened(least, most);
}
inline Range quotient(Range a, Range b) {
  if (b.least <= 0 && b.most >= 0) return {-infinite, infinite};
  return product(a, {1 / b.most, 1 / b.least});
}
inline Range root(Range a) {
  return widened(std::sqrt(std::max(0.0L, a.least)), std::sqrt(std::max(0.0L, a.most)));
}
inline Range size(Range a) {
  if (a.least >= 0) return a;
  if (a.most <= 0) return negative(a);
  return {0, std::max(-a.least, a.most)};
}

struct Token {
  enum class Kind { number, mark, other };
  Kind kind = Kind::other;
  std::string_view text;  ///< of a mark: one of + − · / × √ ² | ( ) , = < > ≤ ≥ ≈ ≠
  Range value{};
  bool space_before = false, space_after = false;
};

/// Digits as figures print them: with a point and a power of ten where they have them.
inline std::size_t length_of_number(std::string_view text) {
  const auto digit = [&](std::size_t i) { return i < text.size() && '0' <= text[i] && text[i] <= '9'; };
  if (!digit(0)) return 0;
  std::size_t at = 0;
  while (digit(at)) ++at;
  if (at < text.size() && text[at] == '.' && digit(at + 1)) {
    ++at;
    while (digit(at)) ++at;
  }
  const std::size_t sign = at + 1;
  if (at < text.size() && text[at] == 'e' && sign < text.size() && (text[sign] == '+' || text[sign] == '-') &&
      digit(sign + 1)) {
    at = sign + 1;
    while (digit(at)) ++at;
  }
  return at;
}

/// What was rounded to these digits. Figures show three decimals, fewer of larger numbers (which then lose
/// their last zeros), and three digits of those with a power of ten; longer ones were printed in full.
inline Range printed(std::string_view text) {
  const std::string digits(text);
  const long double value = std::strtold(digits.c_str(), nullptr);
  if (value == 0) return {0, 0};
  const std::size_t e = text.find('e'), point = text.substr(0, e).find('.');
  const long power = e == std::string_view::npos ? 0 : std::strtol(digits.c_str() + e + 1, nullptr, 10);
  const auto decimals =
      static_cast<long>(point == std::string_view::npos ? 0 : std::min(e, text.size()) - point - 1);
  long kept = e != std::string_view::npos ? 2 : value >= 1000 ? 1 : value >= 100 ? 2 : 3;
  kept = std::max(kept, decimals);
  const long double half = 0.5000001L * std::pow(10.0L, static_cast<long double>(power - kept));
  return {value - half, value + half};
}

inline std::vector<Token> tokens_of(std::string_view text) {
  constexpr std::string_view marks[] = {"+", "−", "·", "/", "×", "√", "²", "|", "(",
                                        ")", ",", "=", "<", ">", "≤", "≥", "≈", "≠"};
  std::vector<Token> tokens;
  bool space = true;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    const std::size_t blank = rest.starts_with("\u00a0") ? 2 : rest[0] == ' ' ? 1 : 0;
    if (blank > 0) {
      if (!tokens.empty()) tokens.back().space_after = true;
      space = true;
      at += blank;
      continue;
    }
    Token token{.space_before = std::exchange(space, false)};
    const std::size_t digits = length_of_number(rest);
    const auto* const mark =
        std::ranges::find_if(marks, [&](std::string_view m) { return rest.starts_with(m); });
    const bool glued = !tokens.empty() && tokens.back().kind == Token::Kind::other && !token.space_before;
    if (digits > 0 && !glued) {
      token.kind = Token::Kind::number;
      token.text = rest.substr(0, digits);
      token.value = printed(token.text);
    } else if (mark != std::end(marks)) {
      token.kind = Token::Kind::mark;
      token.text = *mark;
    } else {
      // A word's letters one by one, so that a number touching it is not one of ours
      std::size_t size = 1;
      while (at + size < text.size() && (static_cast<unsigned char>(text[at + size]) & 0xc0) == 0x80) ++size;
      token.text = rest.substr(0, size);
    }
    at += token.text.size();
    tokens.push_back(token);
  }
  if (!tokens.empty()) tokens.back().space_after = true;
  return tokens;
}

/// sum := term (± term)*, term := factor (· / × factor)*, factor := −factor | √factor | atom²?
/// A minus that is an operator has blanks on both sides, a sign has no blank behind it.
class Reader {
 public:
  Reader(const std::vector<Token>& tokens, std::size_t first, std::size_t end)
      : tokens_(tokens), at_(first), end_(end) {}

  std::optional<Quantity> sum() {
    auto total = term();
    while (total && (is("+") || (is("−") && tokens_[at_].space_after))) {
      const bool minus = is("−");
      ++at_;
      auto next = term();
      if (!next || next->size() != total->size()) return std::nullopt;
      for (std::size_t i = 0; i < total->size(); ++i) {
        (*total)[i] = claims::sum((*total)[i], minus ? negative((*next)[i]) : (*next)[i]);
      }
    }
    return total;
  }
  std::size_t position() const { return at_; }

 private:
  bool is(std::string_view mark) const {
    return at_ < end_ && tokens_[at_].kind == Token::Kind::mark && tokens_[at_].text == mark;
  }
  bool take(std::string_view mark) {
    if (!is(mark)) return false;
    ++at_;
    return true;
  }

  std::optional<Quantity> term() {
    auto value = factor();
    while (value && (is("·") || is("/") || is("×"))) {
      const std::string_view sign = tokens_[at_++].text;
      const auto next = factor();
      if (!next) return std::nullopt;
      value = sign == "/"   ? divided(*value, *next)
              : sign == "×" ? crossed(*value, *next)
                            : times(*value, *next);
    }
    return value;
  }
  std::optional<Quantity> factor() {
    if (is("−") && !tokens_[at_].space_after) {
      ++at_;
      auto value = factor();
      if (value) std::ranges::transform(*value, value->begin(), negative);
      return value;
    }
    if (take("√")) {
      const auto value = factor();
      if (!value || value->size() != 1) return std::nullopt;
      return Quantity{root(value->front())};
    }
    auto value = atom();
    while (value && take("²")) value = value->size() == 1 ? std::optional(squared(*value)) : std::nullopt;
    return value;
  }
  std::optional<Quantity> atom() {
    if (at_ < end_ && tokens_[at_].kind == Token::Kind::number) return Quantity{tokens_[at_++].value};
    if (take("|")) {
      const auto value = sum();
      if (!value || value->size() != 1 || !take("|")) return std::nullopt;
      return Quantity{size(value->front())};
    }
    if (!take("(")) return std::nullopt;
    Quantity parts;
    do {
      const auto part = sum();
      if (!part || part->size() != 1) return std::nullopt;
      parts.push_back(part->front());
    } while (take(","));
    return take(")") ? std::optional(parts) : std::nullopt;
  }

  static std::optional<Quantity> times(const Quantity& a, const Quantity& b) {
    if (a.size() != 1 && a.size() == b.size()) {
      Range dot{0, 0};
      for (std::size_t i = 0; i < a.size(); ++i) dot = claims::sum(dot, product(a[i], b[i]));
      return Quantity{dot};
    }
    if (a.size() != 1 && b.size() != 1) return std::nullopt;
    const Quantity& vector = a.size() == 1 ? b : a;
    const Range by = a.size() == 1 ? a.front() : b.front();
    Quantity result;
    for (const Range part : vector) result.push_back(product(part, by));
    return result;
  }
  static std::optional<Quantity> divided(const Quantity& a, const Quantity& b) {
    if (b.size() != 1) return std::nullopt;
    Quantity result;
    for (const Range part : a) result.push_back(quotient(part, b.front()));
    return result;
  }
  static std::optional<Quantity> crossed(const Quantity& a, const Quantity& b) {
    if (a.size() != 3 || b.size() != 3) return std::nullopt;
    Quantity result;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      result.push_back(claims::sum(product(a[j], b[k]), negative(product(a[k], b[j]))));
    }
    return result;
  }
  static Quantity squared(const Quantity& a) {
    const Range s = size(a.front());
    return {product(s, s)};
  }

  const std::vector<Token>& tokens_;
  std::size_t at_, end_;
};

inline bool is_relation(const Token& token) {
  constexpr std::string_view relations = "= < > ≤ ≥ ≈ ≠";
  return token.kind == Token::Kind::mark && token.text != "," &&
         relations.find(token.text) != std::string_view::npos;
}

/// Whether a printed expression may end here: what follows doesn't go on with it.
inline bool ends_at(const std::vector<Token>& tokens, std::size_t at) {
  if (at >= tokens.size() || is_relation(tokens[at])) return true;
  const Token& next = tokens[at];
  if (next.kind == Token::Kind::mark) return next.text == "," || next.text == ")";
  return next.space_before || next.text == "." || next.text == ";" || next.text == ":";
}
/// Whether one may begin here.
inline bool begins_at(const std::vector<Token>& tokens, std::size_t at) {
  if (at == 0 || is_relation(tokens[at - 1])) return true;
  const Token& before = tokens[at - 1];
  if (before.kind == Token::Kind::mark) return before.text == "," || before.text == "(";
  return tokens[at].space_before && before.kind == Token::Kind::other;
}

/// The longest expression that ends just before a relation.
inline std::optional<Quantity> left_of(const std::vector<Token>& tokens, std::size_t relation) {
  for (std::size_t first = 0; first < relation; ++first) {
    if (!begins_at(tokens, first)) continue;
    Reader reader(tokens, first, relation);
    auto value = reader.sum();
    if (value && reader.position() == relation) return value;
  }
  return std::nullopt;
}
inline std::optional<Quantity> right_of(const std::vector<Token>& tokens, std::size_t relation) {
  Reader reader(tokens, relation + 1, tokens.size());
  auto value = reader.sum();
  return value && ends_at(tokens, reader.position()) ? value : std::nullopt;
}

inline bool can_hold(std::string_view relation, Range a, Range b) {
  const bool exact = a.least == a.most && b.least == b.most;
  if (relation == "<") return exact ? a.least < b.least : a.least <= b.most;
  if (relation == ">") return can_hold("<", b, a);
  if (relation == "≤") return a.least <= b.most;
  if (relation == "≥") return b.least <= a.most;
  if (relation == "≠") return !(exact && a.least == b.least);
  return a.least <= b.most && b.least <= a.most;
}

}  // namespace claims

struct Claims {
  std::size_t checked = 0;          ///< equalities and comparisons with numbers on both sides
  std::vector<std::string> broken;  ///< those that no numbers rounding to the printed ones can fulfil
};

inline Claims claims_in(std::string_view sentence) {
  using namespace claims;
  const std::vector<Token> tokens = tokens_of(sentence);
  Claims found;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!is_relation(tokens[i])) continue;
    const auto left = left_of(tokens, i), right = right_of(tokens, i);
    if (!left || !right || left->size() != right->size()) continue;
    ++found.checked;
    for (std::size_t k = 0; k < left->size(); ++k) {
      if (can_hold(tokens[i].text, (*left)[k], (*right)[k])) continue;
      found.broken.push_back(std::string(tokens[i].text) + " in \"" + std::string(sentence) + "\"");
      break;
    }
  }
  return found;
}

/// A number that is none: the words nan, inf and infinity's sign, standing alone.
inline bool names_no_number(std::string_view text) {
  const auto letter = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  };
  for (const std::string_view word : {"nan", "inf", "NaN", "Infinity"}) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      const std::size_t end = at + word.size();
      const bool minus = text.substr(0, at).ends_with("−");
      const bool inside =
          (at > 0 && letter(text[at - 1]) && !minus && !text.substr(0, at).ends_with("\u00a0")) ||
          (end < text.size() && letter(text[end]) && !text.substr(end).starts_with("\u00a0"));
      if (!inside) return true;
    }
  }
  return text.find("∞") != std::string_view::npos;
}

}  // namespace gradus::test
