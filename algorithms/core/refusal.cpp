#include "core/refusal.hpp"

#include <cstdio>
#include <cstdlib>

namespace gradus {
namespace {

void write_to_stderr(const Refusal& refusal) {
  const char* const separator = refusal.parameter.empty() ? "" : ": ";
  std::fprintf(stderr, "%s%s%s\n", refusal.parameter.c_str(), separator, refusal.text.c_str());
}

RefusalHandler host = write_to_stderr;

bool call(void (*work)(void*), void* data) {
  work(data);
  return true;
}

AttemptHandler attempt = call;

}  // namespace

RefusalHandler set_refusal_handler(RefusalHandler handler) noexcept {
  return std::exchange(host, handler ? handler : write_to_stderr);
}

AttemptHandler set_attempt_handler(AttemptHandler handler) noexcept {
  return std::exchange(attempt, handler ? handler : call);
}

bool attempted(void (*work)(void*), void* data) { return attempt(work, data); }

void refuse(const Refusal& refusal) {
#if defined(__cpp_exceptions)
  switch (refusal.kind) {
    case Refusal::Kind::contract:
      throw ContractViolation(refusal.text);
    case Refusal::Kind::input:
      throw InputError(refusal.text);
    case Refusal::Kind::argument:
      throw ArgumentError(refusal.parameter, refusal.text);
    case Refusal::Kind::usage:
      throw UsageError(refusal.text);
  }
#else
  host(refusal);
#endif
  std::abort();
}

}  // namespace gradus
