#pragma once
// The picture in tiles, and which triangles may touch which of them.

#include <cstdint>
#include <vector>

#include "engine/geometry.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline::engine {

/// Pixels on a side of a tile.
inline constexpr int tile_side = 64;

/// The tiles of a part of a picture, row by row; those at the right and below may be smaller.
class TileGrid {
 public:
  explicit TileGrid(const Window& window)
      : window_(window),
        columns_(static_cast<int>((window.width() + tile_side - 1) / tile_side)),
        rows_(static_cast<int>((window.height() + tile_side - 1) / tile_side)) {}

  int count() const { return columns_ * rows_; }
  int columns() const { return columns_; }
  const Window& window() const { return window_; }
  /// The pixels of a tile.
  Window tile(int number) const {
    const ivec2 lower = window_.lower + tile_side * ivec2{number % columns_, number / columns_};
    return intersection({lower, lower + (tile_side - 1)}, window_);
  }
  /// The columns and rows of tiles that hold these pixels. Domain: not empty, within the window.
  Window tiles_with(const Window& pixels) const {
    return {(pixels.lower - window_.lower) / tile_side, (pixels.upper - window_.lower) / tile_side};
  }

 private:
  Window window_;
  int columns_, rows_;
};

/// Sorts the triangles of every batch by the tiles that their boxes meet. Runs on the threads of the arena
/// that it is called in. Cost: 4 bytes a triangle and tile, 4 bytes a batch and tile.
void bin(Frame& frame, const TileGrid& grid, Touch touch);

/// The triangles that may touch a tile, in their order: visit(id).
template <class Visit>
void visit_tile(const Frame& frame, int tile, const Visit& visit) {
  const auto number = static_cast<std::size_t>(tile);
  std::int32_t base = 0;
  for (const Batch& batch : frame.batches) {
    for (auto i = batch.first[number]; i < batch.first[number + 1]; ++i)
      visit(base + batch.in_tile[static_cast<std::size_t>(i)]);
    base += static_cast<std::int32_t>(batch_triangles);
  }
}

}  // namespace gradus::pipeline::engine
