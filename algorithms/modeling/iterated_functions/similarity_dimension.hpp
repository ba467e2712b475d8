#pragma once
// The dimension of a figure that consists of smaller copies of itself: of ratios r, the s for which the sum
// of all r^s is 1.

#include <cmath>
#include <cstddef>
#include <span>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"
#include "modeling/iterated_functions/iterated_functions.hpp"

namespace gradus::iterated_functions {

// --- Steps -------------------------------------------------------

/// The sum is above 1 there: twice as large an s is tried.
struct Widened {
  double low, high;  ///< as they are now
};

/// The middle was tried, and the half that remains is known.
struct Halved {
  double s, sum;     ///< the middle and its sum
  double low, high;  ///< what remains
};

struct Enclosed {
  double low, high;
};

// --- The method --------------------------------------------------

/// Whether a map changes all lengths by one ratio: a turn or a mirror image with a scale.
template <std::floating_point T>
constexpr bool is_similarity(const Map<T>& m) {
  return (m.a == m.d && m.b == -m.c) || (m.a == -m.d && m.b == m.c);
}

/// Domain: ratios from 0 to 1, s >= 0. Accuracy: that of its powers, and a sum.
inline double sum_at(std::span<const double> ratios, double s) {
  double sum = 0;
  for (const double r : ratios) sum += gradus::pow(r, s);
  return sum;
}

inline void expect_ratios(std::span<const double> ratios, int halvings) {
  expects(!ratios.empty() && 0 <= halvings && halvings <= 100, "a ratio or more, up to 100 halvings");
  for (const double r : ratios) expects(0 <= r && r < 1, "ratios from 0 to below 1, not {}", r);
}

/// The s for which the sum of all r^s is 1, by halving an interval: the dimension of the figure where the
/// copies meet in borders at most, else no less than it.
/// Source: P. A. P. Moran, Additive functions of intervals and Hausdorff measure, 1946.
///
/// ratios: of the copies. rounds: how often.
///
/// Domain: one ratio or more, 0 <= r < 1 each; 0 <= rounds <= 100.
/// Steps: Widened*, Halved for each, Enclosed.
/// Accuracy: within half of the last interval and what the roundings of the sum are worth; each halving adds
///   a bit.
/// Cost: a power per ratio and halving.
/// Errors: ContractViolation outside the domain.
template <Observer<Widened, Halved, Enclosed> O = Unobserved>
double similarity_dimension(std::span<const double> ratios, int rounds, O&& observer = {}) {
  expect_ratios(ratios, rounds);
  double low = 0, high = 1;
  // Until the sum is 1 between
  while (sum_at(ratios, high) > 1) {
    low = high;
    high *= 2;
    if constexpr (observed<O>) observer(Widened{low, high});
  }
  for (int k = 0; k < rounds; ++k) {
    double s = (low + high) / 2;
    double sum = sum_at(ratios, s);
    // A larger s makes it smaller
    (sum > 1 ? low : high) = s;
    if constexpr (observed<O>) observer(Halved{s, sum, low, high});
  }
  if constexpr (observed<O>) observer(Enclosed{low, high});
  return (low + high) / 2;
}

}  // namespace gradus::iterated_functions
