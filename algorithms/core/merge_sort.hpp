#pragma once
// Sorting that does the same everywhere: libraries differ in which elements they compare, and how often.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/language.hpp"

namespace gradus {

/// Sorts a list stably by merging ever longer sorted runs. Source: Knuth, The Art of Computer Programming,
/// vol. 3, 5.2.4, algorithm S without natural runs.
///
/// before(a, b): whether a must come before b. It is asked for the same pairs in the same order on every
/// compiler. Domain: a strict weak order. Returns how many comparisons it took, less than n log2 n rounded
/// up. Cost: O(n log n) comparisons and moves; memory for as many elements again.
template <class T, class Before>
std::size_t merge_sort(std::vector<T>& list, Before before) {
  const std::size_t count = list.size();
  std::size_t comparisons = 0;
  std::vector<T> merged;
  merged.reserve(count);
  for (std::size_t run = 1; run < count; run *= 2) {
    for (std::size_t start = 0; start < count; start += 2 * run) {
      const std::size_t middle = std::min(start + run, count), end = std::min(middle + run, count);
      std::size_t a = start, b = middle;
      while (a < middle && b < end) {
        ++comparisons;
        // Of equals the first one stays first
        merged.push_back(std::move(before(list[b], list[a]) ? list[b++] : list[a++]));
      }
      while (a < middle) merged.push_back(std::move(list[a++]));
      while (b < end) merged.push_back(std::move(list[b++]));
    }
    std::swap(list, merged);
    merged.clear();
  }
  return comparisons;
}

}  // namespace gradus
