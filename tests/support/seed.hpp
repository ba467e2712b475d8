#pragma once
// The seed of property tests.

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace gradus::test {

/// The seed of this run: GRADUS_SEED when set, else always the same. Printed once, so that a failure can be
/// had again.
inline std::uint64_t seed() {
  static const std::uint64_t value = [] {
    const char* given = std::getenv("GRADUS_SEED");
    const std::uint64_t chosen = given ? std::strtoull(given, nullptr, 0) : 20240611;
    std::printf("GRADUS_SEED=%llu\n", static_cast<unsigned long long>(chosen));
    return chosen;
  }();
  return value;
}

}  // namespace gradus::test
