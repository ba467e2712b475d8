#pragma once
// A caller's mistake, said in one sentence: expects(condition, "what was expected, {}", with_the_value).

#include <fmt/core.h>

#include <string_view>
#include <type_traits>

#include "core/language.hpp"
#include "core/refusal.hpp"  // IWYU pragma: export

namespace gradus {

/// Refuses the call with this text (core/refusal.hpp): a ContractViolation.
[[noreturn]] void contract_violated(std::string_view text);

/// Formats out of line, so that a check costs one branch where it stands.
[[noreturn]] void contract_violated(fmt::string_view format, fmt::format_args values);

/// Checks a caller's argument at the edge of the interface; never inside a loop over pixels.
template <class... Values>
constexpr void expects(bool condition, fmt::format_string<Values...> format, Values&&... values) {
  if (!condition) [[unlikely]] {
    contract_violated(fmt::string_view(format), fmt::make_format_args(values...));
  }
}

/// Whether `work` comes to its end without a ContractViolation. Built without exceptions, the host finds out
/// (set_attempt_handler); what the work had in hand is lost then.
template <class Work>
bool keeps_contracts(Work&& work) {
#if defined(__cpp_exceptions)
  try {
    work();
  } catch (const ContractViolation&) {
    return false;
  }
  return true;
#else
  return attempted([](void* data) { (*static_cast<std::remove_reference_t<Work>*>(data))(); }, &work);
#endif
}

}  // namespace gradus
