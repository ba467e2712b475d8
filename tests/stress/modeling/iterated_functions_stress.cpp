// FILL IN: what the header promises. Until then: a walk visits neighbours only, and no pixel too many.

#include "modeling/iterated_functions/iterated_functions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

constexpr double farthest = 40;

/// Where a walk from the origin ends: column and row. FILL IN: inputs that are hard, by their kinds.
Input generate(Kind, Random& random) {
  return {std::floor(random.uniform(0, farthest + 1)), std::floor(random.uniform(0, farthest + 1))};
}

bool is_pixel(const Input& i) {
  for (const double x : i) {
    if (!(x == std::floor(x) && 0 <= x && x <= farthest)) return false;
  }
  return true;
}

/// Pixels that are no neighbours of those before, or too many. FILL IN: the error against an oracle that
/// shares no step with the method; `wrong` for a decision that is wrong.
double error(const Input& i) {
  if (!is_pixel(i)) return 0;
  const ivec2 to(i[0], i[1]);
  int off = -1 - to.x - to.y;
  ivec2 last{0, 0};
  iterated_functions::walk({0, 0}, to, [&](ivec2 p) {
    off += std::abs(p.x - last.x) + std::abs(p.y - last.y) <= 1 ? 1 : 2;
    last = p;
  });
  return last == to ? std::abs(off) : wrong;
}

}  // namespace

Domain iterated_functions() {
  return {"iterated_functions",
          {{.name = "walk",
            .states = "FILL IN: the promise in a line",
            .unit = "pixels",
            .bound = 0,
            .numbers = 2,
            .kinds = {Kind::random, Kind::ties},
            .generate = generate,
            .error = error,
            .arguments = [](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
              if (!is_pixel(i)) return {};
              return {{"columns", fmt::format("{}", i[0])}, {"rows", fmt::format("{}", i[1])}};
            },
            .traps = {{"one pixel", {0, 0}}}}}};
}

}  // namespace gradus::stress
