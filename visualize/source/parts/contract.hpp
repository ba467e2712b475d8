#pragma once
// A caller's mistake, said in one sentence.

#include <charconv>
#include <concepts>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/language.hpp"

namespace gradus {

/// Thrown when an argument lies outside a function's documented domain.
class ContractViolation : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A value as a message shows it.
template <class Value>
std::string message_text(const Value& value) {
  if constexpr (std::same_as<Value, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_enum_v<Value>) {
    return message_text(static_cast<std::underlying_type_t<Value>>(value));
  } else if constexpr (std::is_arithmetic_v<Value>) {
    char digits[64];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
  } else if constexpr (std::convertible_to<const Value&, std::string_view>) {
    return std::string(std::string_view(value));
  } else {
    return "a value";
  }
}

/// Throws a ContractViolation: the text with a value in place of each {}.
[[noreturn]] inline void contract_violated(std::string_view text,
                                           std::initializer_list<std::string> values = {}) {
  std::string message(text);
  std::size_t at = 0;
  for (const std::string& value : values) {
    at = message.find("{}", at);
    if (at == std::string::npos) break;
    message.replace(at, 2, value);
    at += value.size();
  }
  throw ContractViolation(message);
}

/// Checks a caller's argument at the edge of the interface.
template <class... Values>
constexpr void expects(bool condition, std::string_view text, const Values&... values) {
  if (!condition) [[unlikely]] {
    contract_violated(text, {message_text(values)...});
  }
}

}  // namespace gradus
