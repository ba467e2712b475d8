#pragma once
// What several situations and the error itself ask of the same input, computed once.

#include <optional>
#include <utility>

#include "stress/domain.hpp"

namespace gradus::stress {

/// compute(input), kept until another input comes.
template <auto compute>
const auto& last_of(const Input& input) {
  using Result = decltype(compute(input));
  thread_local std::optional<std::pair<Input, Result>> last;
  if (!last || last->first != input) last.emplace(input, compute(input));
  return last->second;
}

}  // namespace gradus::stress
