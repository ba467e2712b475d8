#pragma once
// Numbers, points and lists of points as people write them. Files and standard input are not read here.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/shown.hpp"  // IWYU pragma: export

namespace gradus {

/// The text without white space at its ends.
std::string_view trimmed(std::string_view text);

/// The letters A to Z as a to z.
std::string lowered(std::string_view text);

/// A whole number, nothing before or after it but white space; nothing when it is none or beyond int64.
std::optional<std::int64_t> whole_number(std::string_view text);

/// The two halves of "3,4", "-5,8" or "(3, 4)", white space trimmed; nothing when it is no such pair.
struct Pair {
  std::string_view x, y;
};
std::optional<Pair> pair_in(std::string_view text);

/// A fraction, denominator >= 1, in lowest terms.
struct Fraction {
  std::int64_t numerator = 0, denominator = 1;
  friend bool operator==(const Fraction&, const Fraction&) = default;
};

/// A number as written: "3", "-1/3", "0.25", "1e-3".
struct Number {
  double value = 0;               ///< the double nearest to it
  std::optional<Fraction> exact;  ///< nothing where 64 bits do not hold it
  std::string text;               ///< canonical: "1/3" for "+2/6", "0.25" for "0.250"
};
/// The coordinates of a point, or numbers that otherwise belong together.
using Tuple = std::vector<Number>;

/// What is wrong with a text: the place as words ("" or "point 3: ") and what was expected.
struct Misread {
  std::string what;
};
template <class T>
using Read = std::variant<T, Misread>;

/// Domain: digits with a sign, one decimal point, an exponent; or a fraction of two int64. What is too small
/// for a double is a zero or the nearest subnormal one; what is too large is refused.
Read<Number> read_number(std::string_view text);
/// As many numbers as there are names, for x and y: "3,4", "-5,8", "(3, 4)", "1/3,2".
Read<Tuple> read_tuple(std::string_view text, std::span<const std::string> names);
/// Points with white space or ";" between them: "0,0 6,0 6,3". Errors say which point. A "#" starts a comment
/// to the end of its line, so that lists in files may have some. At least one point.
Read<std::vector<Tuple>> read_tuples(std::string_view text, std::span<const std::string> names);

/// Several lists of points with ";" between them, and nothing but white space between points: "0,0 6,0 6,3;
/// 8,1 9,1 9,2". Errors say which ring and which point. At least one ring.
Read<std::vector<std::vector<Tuple>>> read_rings(std::string_view text, std::span<const std::string> names);

/// The canonical spelling: "1/3,2", "0,0 6,0 6,3", and "0,0 6,0 6,3; 8,1 9,1 9,2".
std::string text_of(const Tuple& tuple);
std::string text_of(const std::vector<Tuple>& tuples);
std::string text_of(const std::vector<std::vector<Tuple>>& rings);

}  // namespace gradus
