#pragma once
// A rectangle of cells in memory, row by row, row 0 first.

#include <cstddef>
#include <span>
#include <vector>

#include "core/contract.hpp"
#include "core/geometry.hpp"

namespace gradus {

/// Width x height cells of any type. Cell (0, 0) is the first in memory; whether that is the top or the
/// bottom is the owner's to say (images: the top).
template <class Cell>
class Raster {
 public:
  Raster() = default;

  /// Domain: 0 <= width, height; at most 2^31 - 1 each. Every cell starts as `value`.
  Raster(int width, int height, const Cell& value = {}) : width_(width), height_(height) {
    expects(width >= 0 && height >= 0, "a raster has a size of 0 or more, not {} x {}", width, height);
    cells_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  Window window() const { return {{0, 0}, {width_ - 1, height_ - 1}}; }
  bool contains(ivec2 p) const { return 0 <= p.x && p.x < width_ && 0 <= p.y && p.y < height_; }

  /// The cell in column p.x of row p.y. Domain: contains(p).
  Cell& operator[](ivec2 p) { return cells_[index(p)]; }
  const Cell& operator[](ivec2 p) const { return cells_[index(p)]; }

  std::span<Cell> row(int y) { return {cells_.data() + index({0, y}), static_cast<std::size_t>(width_)}; }
  std::span<const Cell> row(int y) const {
    return {cells_.data() + index({0, y}), static_cast<std::size_t>(width_)};
  }
  std::span<Cell> cells() { return cells_; }
  std::span<const Cell> cells() const { return cells_; }

  friend bool operator==(const Raster& a, const Raster& b) {
    return a.width_ == b.width_ && a.height_ == b.height_ && a.cells_ == b.cells_;
  }

 private:
  std::size_t index(ivec2 p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(p.x);
  }

  int width_ = 0, height_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace gradus
