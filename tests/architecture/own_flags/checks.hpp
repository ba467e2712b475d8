#pragma once
// What the programs of own_flags_test.py share: they count what is broken, and draw their inputs.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

#include "core/geometry.hpp"
#include "core/random.hpp"

using namespace gradus;

// What was broken, in which round at first, and how often
struct Failure {
  std::string_view what;
  int round, times;
};
inline std::vector<Failure> failures;

inline void expect(bool condition, std::string_view what, int round) {
  if (condition) return;
  for (Failure& failure : failures) {
    if (failure.what == what) {
      ++failure.times;
      return;
    }
  }
  failures.push_back({what, round, 1});
}

inline std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }
inline bool same(double x, double y) { return bits(x) == bits(y); }
template <int N>
bool same(glm::vec<N, double> p, glm::vec<N, double> q) {
  for (int i = 0; i < N; ++i) {
    if (!same(p[i], q[i])) return false;
  }
  return true;
}

/// Prints the failures; the program's exit code.
inline int report() {
  for (const auto& [what, round, times] : failures) {
    std::printf("%.*s: from round %d on %d times\n", static_cast<int>(what.size()), what.data(), round,
                times);
  }
  return failures.empty() ? 0 : 1;
}

inline double coordinate(Random& random) { return random.uniform(-10, 10); }
inline dvec2 point(Random& random) { return {coordinate(random), coordinate(random)}; }
inline dvec3 point_in_space(Random& random) {
  return {coordinate(random), coordinate(random), coordinate(random)};
}
