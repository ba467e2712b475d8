#include "scene/decimal.hpp"

#include <cmath>
#include <cstdlib>
#include <string>
#include <version>

namespace gradus::pipeline {

std::from_chars_result read_decimal(const char* first, const char* last, double& value) {
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
