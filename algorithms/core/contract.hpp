#pragma once
// A caller's mistake, said in one sentence: expects(condition, "what was expected, {}", with_the_value).

#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include "core/language.hpp"

namespace gradus {

/// Thrown when an argument lies outside a function's documented domain.
class ContractViolation : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Ends the call with this text: throws ContractViolation, or, built without exceptions, hands the text to
/// the handler (see set_violation_handler) and does not return.
[[noreturn]] void contract_violated(std::string_view text);

/// What a build without exceptions calls with the text before it stops. Default: writes it to stderr.
using ViolationHandler = void (*)(std::string_view text);
ViolationHandler set_violation_handler(ViolationHandler handler) noexcept;

/// Formats out of line, so that a check costs one branch where it stands.
[[noreturn]] void contract_violated(fmt::string_view format, fmt::format_args values);

/// Checks a caller's argument at the edge of the interface; never inside a loop over pixels.
template <class... Values>
constexpr void expects(bool condition, fmt::format_string<Values...> format, Values&&... values) {
  if (!condition) [[unlikely]] {
    contract_violated(fmt::string_view(format), fmt::make_format_args(values...));
  }
}

}  // namespace gradus
