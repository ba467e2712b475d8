#pragma once
// The few shapes that topics share. Vectors are GLM's; what GLM lacks is here.

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>

namespace gradus {

using glm::dvec2;
using glm::ivec2;

/// A rectangle of cells, lower and upper corner both included, so that the whole int32 plane is one.
/// Empty when upper < lower in either axis.
struct Window {
  ivec2 lower{0, 0};
  ivec2 upper{-1, -1};

  constexpr bool empty() const { return upper.x < lower.x || upper.y < lower.y; }
  constexpr bool contains(ivec2 p) const {
    return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y;
  }
  /// Cells across; up to 2^32.
  constexpr std::int64_t width() const { return std::int64_t{upper.x} - lower.x + 1; }
  constexpr std::int64_t height() const { return std::int64_t{upper.y} - lower.y + 1; }

  friend constexpr bool operator==(const Window& a, const Window& b) {
    return a.lower.x == b.lower.x && a.lower.y == b.lower.y && a.upper.x == b.upper.x &&
           a.upper.y == b.upper.y;
  }
};

/// The cells two windows share; empty when they share none.
constexpr Window intersection(const Window& a, const Window& b) {
  return {{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y)},
          {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y)}};
}

/// The smallest window that holds both cells.
constexpr Window window_around(ivec2 a, ivec2 b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

}  // namespace gradus
