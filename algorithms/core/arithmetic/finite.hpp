#pragma once
// Whether numbers are finite, for scalars of every kind.

#include <cmath>
#include <concepts>
#include <type_traits>

#include "core/arithmetic/rounding.hpp"

namespace gradus {

/// Whether these numbers are all finite; of a type that has no infinities, all are.
template <class... Numbers>
bool all_finite(const Numbers&... numbers) {
  const auto finite = [](const auto& x) {
    if constexpr (std::floating_point<std::remove_cvref_t<decltype(x)>>) {
      return std::isfinite(x);
    } else {
      return true;
    }
  };
  return (finite(numbers) && ...);
}

}  // namespace gradus
