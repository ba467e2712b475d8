#pragma once
// Arithmetic with 106 bits: numbers as a sum of two doubles, value + error, the error at most half a unit in
// the last place of the value. For what must be rounded once and well, after several operations.

#include <cmath>

#include "core/arithmetic/exact.hpp"

namespace gradus {

/// a + b. Accuracy: 2^-102 of |a| + |b| (not of the sum: it may cancel). Domain: no overflow.
/// Source of all of these: Dekker 1971, sections 5 and 6.
constexpr Rounded sum_of_pairs(Rounded a, Rounded b) {
  const Rounded high = two_sum(a.value, b.value), low = two_sum(a.error, b.error);
  const Rounded middle = fast_two_sum(high.value, high.error + low.value);
  return fast_two_sum(middle.value, middle.error + low.error);
}

constexpr Rounded negated(Rounded a) { return {-a.value, -a.error}; }

/// a * b. Accuracy: 2^-101, relative. Domain: that of two_product.
constexpr Rounded product_of_pairs(Rounded a, Rounded b) {
  const Rounded product = two_product(a.value, b.value);
  return fast_two_sum(product.value, product.error + (a.value * b.error + a.error * b.value));
}

/// a / b. Accuracy: 2^-99, relative. Domain: b not 0, and that of two_product.
constexpr Rounded quotient_of_pairs(Rounded a, Rounded b) {
  const double first = a.value / b.value;
  const Rounded rest = sum_of_pairs(a, negated(product_of_pairs(b, {first, 0})));
  return fast_two_sum(first, rest.value / b.value);
}

/// The square root. Accuracy: 2^-99, relative. Domain: a >= 0, and that of two_product.
inline Rounded root_of_pair(Rounded a) {
  if (a.value <= 0) return {0, 0};
  const double first = std::sqrt(a.value);
  const Rounded rest = sum_of_pairs(a, negated(two_product(first, first)));
  return fast_two_sum(first, rest.value / (2 * first));
}

}  // namespace gradus
