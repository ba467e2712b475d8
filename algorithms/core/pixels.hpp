#pragma once
// The pixels of a window, to be gone through: for (ivec2 p : pixels(window)).

#include <cstdint>
#include <glm/vec2.hpp>

#include "core/geometry.hpp"

namespace gradus {

/// Row by row, from the lower corner on. Any window: also one that reaches to the last row of all.
class Pixels {
 public:
  explicit constexpr Pixels(const Window& window) : window_(window) {}

  struct Place {
    int x;
    std::int64_t y;  // beyond the last row at the end
    int left, right;
    constexpr ivec2 operator*() const { return {x, static_cast<int>(y)}; }
    constexpr Place& operator++() {
      const bool ends = x == right;
      x = ends ? left : x + 1;
      y += ends;
      return *this;
    }
    constexpr bool operator!=(const Place& other) const { return y != other.y; }
  };
  constexpr Place begin() const { return in_row(window_.empty() ? below() : window_.lower.y); }
  constexpr Place end() const { return in_row(below()); }

 private:
  constexpr std::int64_t below() const { return std::int64_t{window_.upper.y} + 1; }
  constexpr Place in_row(std::int64_t y) const {
    return {window_.lower.x, y, window_.lower.x, window_.upper.x};
  }

  Window window_;
};

constexpr Pixels pixels(const Window& window) { return Pixels(window); }

}  // namespace gradus
