#pragma once
// Promises that are kept or not, without a measure: their errors are 0 or `wrong`.

#include <utility>

#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {

inline const std::vector<Kind> all_but_refused(all_kinds.begin(), all_kinds.end() - 1);

inline Input any_numbers(std::size_t count, Kind kind, Random& random) {
  Input input(count);
  for (double& x : input) x = number(kind, random);
  return input;
}

inline Property exact_property(std::string name, std::string states, std::size_t numbers, Generator generate,
                               std::function<double(const Input&)> error, std::vector<Share> shares = {},
                               std::vector<Trap> traps = {}) {
  return {.name = std::move(name),
          .states = std::move(states),
          .unit = "decisions",
          .bound = 0,
          .numbers = numbers,
          .kinds = all_but_refused,
          .generate = std::move(generate),
          .error = std::move(error),
          .traps = std::move(traps),
          .shares = std::move(shares)};
}

}  // namespace gradus::stress
