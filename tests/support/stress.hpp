#pragma once
// How many cases a property test runs: few in the ordinary run, all of them in `ctest -C Stress -L stress`.

#include <cstdint>
#include <cstdlib>

namespace gradus::test {

inline std::int64_t cases(std::int64_t ordinary, std::int64_t full) {
  return std::getenv("GRADUS_STRESS") ? full : ordinary;
}

}  // namespace gradus::test
