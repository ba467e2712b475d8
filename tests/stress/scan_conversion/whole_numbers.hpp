#pragma once
// Whole numbers in inputs: places of pixels, sizes, numbers of choices.

#include <algorithm>
#include <climits>
#include <cmath>

#include "core/geometry.hpp"
#include "stress/domain.hpp"

namespace gradus::stress {

/// Whether a number is whole and lies between two others; all of int32 if none are named.
inline bool is_whole(double x, double least = INT_MIN, double most = INT_MAX) {
  return least <= x && x <= most && x == std::floor(x);
}
inline bool are_whole(const Input& input, std::size_t count, double least = INT_MIN, double most = INT_MAX) {
  return std::all_of(input.begin(), input.begin() + static_cast<std::ptrdiff_t>(count),
                     [=](double x) { return is_whole(x, least, most); });
}

/// A whole number from `least` to `most`.
inline double whole(Random& random, std::int64_t least, std::int64_t most) {
  return static_cast<double>(random.uniform_int(least, most));
}

/// Two numbers of an input as a pixel. Domain: they are whole.
inline ivec2 pixel(const Input& input, std::size_t first) {
  return {static_cast<int>(input[first]), static_cast<int>(input[first + 1])};
}

/// The nearest int.
inline int bounded(std::int64_t x) { return static_cast<int>(std::clamp<std::int64_t>(x, INT_MIN, INT_MAX)); }

}  // namespace gradus::stress
