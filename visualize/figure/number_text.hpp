#pragma once
// Numbers as figures show them.

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace gradus {

/// A number with the typographic minus, as figures show it.
inline std::string figure_number(std::int64_t value) {
  const std::string digits = fmt::format("{}", value);
  return value < 0 ? "−" + digits.substr(1) : digits;
}

}  // namespace gradus
