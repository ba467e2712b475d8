#pragma once
// Decimal numbers of files, also where the standard library can't read doubles from a range of characters.

#include <charconv>

namespace gradus::pipeline {

constexpr bool is_digit(char c) { return '0' <= c && c <= '9'; }

/// std::from_chars for a double in the general format: the nearest one, no white space, no + in front.
std::from_chars_result read_decimal(const char* first, const char* last, double& value);

/// The same by std::strtod, for libraries without it (WebAssembly's). What is too small for a double is no
/// error here, but the zero or the subnormal number nearest to it.
/// Domain: no zero bytes.
std::from_chars_result read_decimal_by_strtod(const char* first, const char* last, double& value);

}  // namespace gradus::pipeline
