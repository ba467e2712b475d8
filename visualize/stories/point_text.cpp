#include "stories/point_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <span>

namespace gradus {
namespace {

__extension__ typedef unsigned __int128 uint128_t;

constexpr std::string_view white = " \t\r\n\f\v";
constexpr std::string_view number_hint = "a number like 3, -5, 1/3 or 0.25";

bool is_digit(char c) { return '0' <= c && c <= '9'; }

// --- Numbers -------------------------------------------------------------------------------------

std::uint64_t magnitude(std::int64_t v) {
  return v < 0 ? 0 - static_cast<std::uint64_t>(v) : static_cast<std::uint64_t>(v);
}

/// The double nearest to numerator / denominator: 63 bits of the quotient or more and a sticky bit, rounded
/// once.
double nearest(std::uint64_t numerator, std::uint64_t denominator) {
  if (numerator == 0) return 0;
  const int shift =
      63 + static_cast<int>(std::bit_width(denominator)) - static_cast<int>(std::bit_width(numerator));
  const uint128_t dividend = static_cast<uint128_t>(numerator) << shift;
  const auto quotient = static_cast<std::uint64_t>(dividend / denominator);
  const bool inexact = dividend % denominator != 0;
  return std::ldexp(static_cast<double>(quotient | static_cast<std::uint64_t>(inexact)), -shift);
}

/// Lowest terms; nothing when the numerator is beyond int64.
std::optional<Fraction> reduced(bool negative, std::uint64_t numerator, std::uint64_t denominator) {
  const std::uint64_t common = std::gcd(numerator, denominator);
  numerator /= common;
  denominator /= common;
  const std::uint64_t most = std::uint64_t{INT64_MAX} + (negative ? 1 : 0);
  if (numerator > most || denominator > std::uint64_t{INT64_MAX}) return std::nullopt;
  return Fraction{static_cast<std::int64_t>(negative ? 0 - numerator : numerator),
                  static_cast<std::int64_t>(denominator)};
}

std::string text_of(const Fraction& f) {
  return f.denominator == 1 ? fmt::format("{}", f.numerator)
                            : fmt::format("{}/{}", f.numerator, f.denominator);
}

Misread no_number(std::string_view text) {
  return {fmt::format("expected {}, found {}", number_hint, shown(text))};
}

Read<Number> read_fraction(std::string_view text, std::size_t slash) {
  const auto above = whole_number(text.substr(0, slash)), below = whole_number(text.substr(slash + 1));
  if (!above || !below) return no_number(text);
  if (*below == 0) return Misread{fmt::format("expected a denominator other than 0, found {}", shown(text))};
  const bool negative = *above != 0 && (*above < 0) != (*below < 0);
  const auto exact = reduced(negative, magnitude(*above), magnitude(*below));
  if (!exact) return no_number(text);
  const double value = nearest(magnitude(exact->numerator), magnitude(exact->denominator));
  return Number{negative ? -value : value, exact, text_of(*exact)};
}

/// A decimal number taken apart: digits without leading and trailing zeros, times ten to the exponent.
struct Decimal {
  bool negative = false;
  std::string digits;
  long exponent = 0;
};

/// A whole number. Those beyond a million are brought there: the doubles end long before.
std::optional<long> exponent_in(std::string_view text) {
  constexpr std::int64_t most = 1'000'000;
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || !std::ranges::all_of(text, is_digit)) return std::nullopt;
  const std::int64_t size = std::min(whole_number(text).value_or(most), most);
  return static_cast<long>(negative ? -size : size);
}

std::optional<Decimal> decimal_in(std::string_view text) {
  Decimal decimal;
  std::size_t at = 0, digits = 0;
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) decimal.negative = text[at++] == '-';
  bool point = false;
  for (; at < text.size() && (is_digit(text[at]) || (text[at] == '.' && !point)); ++at) {
    if (text[at] == '.') {
      point = true;
      continue;
    }
    ++digits;
    decimal.exponent -= point;
    if (!decimal.digits.empty() || text[at] != '0') decimal.digits += text[at];
  }
  if (digits == 0) return std::nullopt;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const auto exponent = exponent_in(text.substr(at + 1));
    if (!exponent) return std::nullopt;
    decimal.exponent += *exponent;
    at = text.size();
  }
  if (at != text.size()) return std::nullopt;
  while (!decimal.digits.empty() && decimal.digits.back() == '0') {
    decimal.digits.pop_back();
    ++decimal.exponent;
  }
  if (decimal.digits.empty()) return Decimal{};
  return decimal;
}

std::optional<Fraction> exactly(const Decimal& decimal) {
  constexpr long most_digits = 18;  // so that every product below stays within int64
  const long size = static_cast<long>(decimal.digits.size());
  if (size > most_digits || decimal.exponent < -most_digits || size + decimal.exponent > most_digits)
    return std::nullopt;
  std::uint64_t numerator = 0, denominator = 1;
  for (const char c : decimal.digits) numerator = 10 * numerator + static_cast<std::uint64_t>(c - '0');
  for (long i = 0; i < decimal.exponent; ++i) numerator *= 10;
  for (long i = decimal.exponent; i < 0; ++i) denominator *= 10;
  return reduced(decimal.negative, numerator, denominator);
}

std::string text_of(const Decimal& decimal) {
  if (decimal.digits.empty()) return "0";
  std::string text = decimal.digits;
  const long size = static_cast<long>(text.size()), before_point = size + decimal.exponent;
  if (before_point > 21 || before_point < -6) {
    text += fmt::format("e{}", decimal.exponent);
  } else if (decimal.exponent >= 0) {
    text.append(static_cast<std::size_t>(decimal.exponent), '0');
  } else if (before_point > 0) {
    text.insert(static_cast<std::size_t>(before_point), ".");
  } else {
    text = "0." + std::string(static_cast<std::size_t>(-before_point), '0') + text;
  }
  return (decimal.negative ? "-" : "") + text;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(white);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(white) - first + 1);
}

std::string lowered(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && text.size() > 1 && is_digit(text[1])) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Pair> pair_in(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('(') != text.ends_with(')') || text == "(") return std::nullopt;
  if (text.starts_with('(')) text = text.substr(1, text.size() - 2);
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const Pair pair{trimmed(text.substr(0, comma)), trimmed(text.substr(comma + 1))};
  if (pair.x.empty() || pair.y.empty()) return std::nullopt;
  return pair;
}

Read<Number> read_number(std::string_view text) {
  const std::string_view word = trimmed(text);
  if (const std::size_t slash = word.find('/'); slash != std::string_view::npos)
    return read_fraction(word, slash);
  const auto decimal = decimal_in(word);
  if (!decimal) return no_number(text);
  Number number{0, exactly(*decimal), text_of(*decimal)};
  number.value = std::strtod(number.text.c_str(), nullptr);  // from_chars(double) is missing in WebAssembly
  if (!std::isfinite(number.value)) {
    return Misread{fmt::format("expected a number of at most 1.8e308, found {}", shown(text))};
  }
  return number;
}

Read<Tuple> read_tuple(std::string_view text, std::span<const std::string> names) {
  const Misread wrong{
      fmt::format("expected {} numbers {}, found {}", names.size(), fmt::join(names, ","), shown(text))};
  std::string_view rest = trimmed(text);
  if (rest.starts_with('(') != rest.ends_with(')') || rest == "(") return wrong;
  if (rest.starts_with('(')) rest = rest.substr(1, rest.size() - 2);
  Tuple tuple;
  for (std::size_t at = 0; at <= rest.size();) {
    const std::size_t end = std::min(rest.find(',', at), rest.size());
    Read<Number> number = read_number(rest.substr(at, end - at));
    if (std::holds_alternative<Misread>(number)) {
      // A single number that is none is worth its own words
      return tuple.size() < names.size() && !trimmed(rest.substr(at, end - at)).empty()
                 ? std::get<Misread>(number)
                 : wrong;
    }
    tuple.push_back(std::get<Number>(std::move(number)));
    at = end + 1;
  }
  if (tuple.size() != names.size()) return wrong;
  return tuple;
}

namespace {

/// Where the point that starts at text[0] ends: at white space or ";", but not inside parentheses nor at a
/// comma.
std::size_t point_end(std::string_view text) {
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') inside = true;
    if (text[i] == ')') return i + 1;
    if (inside) continue;
    if (text[i] == ';') return i;
    if (white.find(text[i]) == std::string_view::npos) continue;
    const std::size_t next = text.find_first_not_of(white, i);
    const bool comma_follows = next != std::string_view::npos && text[next] == ',';
    if (!comma_follows && text[i - 1] != ',') return i;
  }
  return text.size();
}

std::string without_comments(std::string_view text) {
  std::string kept;
  bool comment = false;
  for (const char c : text) {
    if (c == '#') comment = true;
    if (c == '\n') comment = false;
    if (!comment) kept += c;
  }
  return kept;
}

}  // namespace

Read<std::vector<Tuple>> read_tuples(std::string_view text, std::span<const std::string> names) {
  const std::string plain = without_comments(text);
  std::string_view rest = plain;
  std::vector<Tuple> points;
  while (true) {
    const std::size_t start = rest.find_first_not_of(" \t\r\n\f\v;");
    if (start == std::string_view::npos) break;
    rest.remove_prefix(start);
    const std::size_t end = point_end(rest);
    Read<Tuple> point = read_tuple(rest.substr(0, end), names);
    if (const Misread* misread = std::get_if<Misread>(&point)) {
      return Misread{fmt::format("point {}: {}", points.size() + 1, misread->what)};
    }
    points.push_back(std::get<Tuple>(std::move(point)));
    rest.remove_prefix(end);
  }
  if (points.empty()) {
    return Misread{fmt::format("expected points {} with spaces between them, found {}", fmt::join(names, ","),
                               shown(text))};
  }
  return points;
}

Read<std::vector<std::vector<Tuple>>> read_rings(std::string_view text, std::span<const std::string> names) {
  const std::string plain = without_comments(text);
  const std::string_view rest = plain;
  std::vector<std::vector<Tuple>> rings;
  for (std::size_t at = 0; at <= rest.size();) {
    const std::size_t end = std::min(rest.find(';', at), rest.size());
    const std::string_view word = rest.substr(at, end - at);
    at = end + 1;
    if (trimmed(word).empty()) continue;
    Read<std::vector<Tuple>> ring = read_tuples(word, names);
    if (const Misread* misread = std::get_if<Misread>(&ring)) {
      return Misread{fmt::format("ring {}: {}", rings.size() + 1, misread->what)};
    }
    rings.push_back(std::get<std::vector<Tuple>>(std::move(ring)));
  }
  if (rings.empty()) {
    return Misread{fmt::format("expected rings of points {}, with ; between rings, found {}",
                               fmt::join(names, ","), shown(text))};
  }
  return rings;
}

std::string text_of(const Tuple& tuple) {
  std::string text;
  for (const Number& number : tuple) text += (text.empty() ? "" : ",") + number.text;
  return text;
}

std::string text_of(const std::vector<Tuple>& tuples) {
  std::string text;
  for (const Tuple& tuple : tuples) text += (text.empty() ? "" : " ") + text_of(tuple);
  return text;
}

std::string text_of(const std::vector<std::vector<Tuple>>& rings) {
  std::string text;
  for (const std::vector<Tuple>& ring : rings) text += (text.empty() ? "" : "; ") + text_of(ring);
  return text;
}

}  // namespace gradus
