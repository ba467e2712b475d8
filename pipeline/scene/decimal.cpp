#include "scene/decimal.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <version>

namespace gradus::pipeline {
namespace {

/// A number as most files have them: at most 15 digits, a point among them or none, and no power. Both its
/// digits as a whole number and the power of ten below them are doubles, so that their quotient, rounded
/// once, is the nearest double. Nothing for all others.
std::optional<double> short_decimal(const char* at, const char* last) {
  constexpr std::array powers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                              1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = at != last && *at == '-';
  at += negative;
  std::int64_t whole = 0;
  std::size_t digits = 0, behind_point = 0;
  for (; at != last && is_digit(*at) && digits < powers.size(); ++at, ++digits)
    whole = 10 * whole + (*at - '0');
  if (at != last && *at == '.') {
    const std::size_t before = digits;
    for (++at; at != last && is_digit(*at) && digits < powers.size(); ++at, ++digits)
      whole = 10 * whole + (*at - '0');
    behind_point = digits - before;
  }
  if (at != last || digits == 0 || digits == powers.size()) return std::nullopt;
  const double value = static_cast<double>(whole) / powers[behind_point];
  return negative ? -value : value;
}

}  // namespace

std::from_chars_result read_decimal(const char* first, const char* last, double& value) {
  if (const auto found = short_decimal(first, last)) {
    value = *found;
    return {last, {}};
  }
#if defined(__cpp_lib_to_chars)
  return std::from_chars(first, last, value);
#else
  return read_decimal_by_strtod(first, last, value);
#endif
}

std::from_chars_result read_decimal_by_strtod(const char* first, const char* last, double& value) {
  // strtod takes more: white space and + in front, hexadecimal numbers
  const char* const digits = first != last && *first == '-' ? first + 1 : first;
  if (digits == last || *digits == ' ' || ('\t' <= *digits && *digits <= '\r') || *digits == '+' ||
      (*digits == '-' && digits != first)) {
    return {first, std::errc::invalid_argument};
  }
  const bool hexadecimal = *digits == '0' && last - digits > 1 && (digits[1] == 'x' || digits[1] == 'X');
  const std::string text(first, hexadecimal ? digits + 1 : last);

  char* end = nullptr;
  const double read = std::strtod(text.c_str(), &end);
  const char* const stopped = first + (end - text.c_str());
  if (stopped == first) return {first, std::errc::invalid_argument};
  const bool word = *digits != '.' && (*digits < '0' || '9' < *digits);  // inf, nan
  if (std::isinf(read) && !word) return {stopped, std::errc::result_out_of_range};
  value = read;
  return {stopped, {}};
}

}  // namespace gradus::pipeline
