#include "core/contract.hpp"

#include <cstdio>
#include <cstdlib>

namespace gradus {
namespace {

void write_to_stderr(std::string_view text) {
  std::fprintf(stderr, "%.*s\n", static_cast<int>(text.size()), text.data());
}

ViolationHandler handler = write_to_stderr;

}  // namespace

ViolationHandler set_violation_handler(ViolationHandler next) noexcept {
  const ViolationHandler previous = handler;
  handler = next ? next : write_to_stderr;
  return previous;
}

void contract_violated(std::string_view text) {
#if defined(__cpp_exceptions)
  throw ContractViolation(std::string(text));
#else
  handler(text);
  std::abort();
#endif
}

void contract_violated(fmt::string_view format, fmt::format_args values) {
  contract_violated(std::string_view(fmt::vformat(format, values)));
}

}  // namespace gradus
