#pragma once
// What a run of the tests leaves to others: walks over hundreds of sheets that are judged alike. An ordinary
// run looks at a share of them, another one with each commit (GRADUS_SHARE, which ./bootstrap sets); with
// GRADUS_ALL
// (`./bootstrap test --all`) it looks at all.

#include <cstddef>
#include <cstdlib>

namespace gradus::test {

inline bool whole_run() { return std::getenv("GRADUS_ALL") != nullptr; }

/// Whether the i-th of many alike belongs to this run, of which it takes one in `parts`.
inline bool in_share(std::size_t i, std::size_t parts) {
  static const char* const given = std::getenv("GRADUS_SHARE");
  static const std::size_t share = given ? std::strtoul(given, nullptr, 10) : 0;
  return whole_run() || (i + share) % parts == 0;
}

/// What is left of so many, for expectations and counts of cases.
inline std::size_t share_of(std::size_t count, std::size_t parts) {
  return whole_run() ? count : count / parts;
}

}  // namespace gradus::test
