#pragma once
// The picture in tiles, and which triangles may touch which of them.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline::engine {

/// Pixels on a side of a tile.
inline constexpr int tile_side = 64;

/// The tile of a picture that holds a pixel: tiles begin at its upper left.
inline Window square_with(ivec2 pixel) {
  const ivec2 lower = pixel / tile_side * tile_side;
  return {lower, lower + (tile_side - 1)};
}

/// Whether a tile is not cut off by the rim of a picture's part.
inline bool is_whole_tile(const Window& tile) {
  return tile.width() == tile_side && tile.height() == tile_side;
}

/// The tiles of a part of a picture, row by row; those at its rim are cut off.
class TileGrid {
 public:
  /// Domain: within a picture.
  explicit TileGrid(const Window& window)
      : window_(window),
        first_(window.lower / tile_side),
        columns_(window.empty() ? 0 : window.upper.x / tile_side - first_.x + 1),
        rows_(window.empty() ? 0 : window.upper.y / tile_side - first_.y + 1) {}

  int count() const { return columns_ * rows_; }
  int columns() const { return columns_; }
  const Window& window() const { return window_; }
  /// The pixels of a tile.
  Window tile(int number) const {
    const ivec2 at = first_ + ivec2{number % columns_, number / columns_};
    return intersection(square_with(tile_side * at), window_);
  }
  /// The columns and rows of tiles that hold these pixels. Domain: not empty, within the window.
  Window tiles_with(const Window& pixels) const {
    return {pixels.lower / tile_side - first_, pixels.upper / tile_side - first_};
  }

 private:
  Window window_;
  ivec2 first_;
  int columns_, rows_;
};

/// Sorts the triangles of every batch by the tiles that their boxes meet. Runs on the threads of the arena
/// that it is called in. Cost: 4 bytes per triangle and tile, 4 bytes per batch and tile.
void bin(Frame& frame, const TileGrid& grid, Touch touch);

/// Whether no triangle may touch a tile.
inline bool is_empty(const Frame& frame, int tile) {
  const auto number = static_cast<std::size_t>(tile);
  return std::ranges::all_of(
      frame.batches, [&](const Batch& batch) { return batch.first[number] == batch.first[number + 1]; });
}

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

/// The same, up to so many at once: visit(ids). While some are visited, memory brings the next.
template <std::size_t most, class Visit>
void visit_tile_in_parts(const Frame& frame, int tile, const Visit& visit) {
  std::array<std::int32_t, 2 * most> ids;
  const std::span<const std::int32_t> all(ids);
  std::size_t count = 0;
  visit_tile(frame, tile, [&](std::int32_t id) {
    __builtin_prefetch(&frame.triangle(id));
    ids[count++] = id;
    if (count < 2 * most) return;
    visit(all.first(most));
    std::copy(ids.begin() + most, ids.end(), ids.begin());
    count = most;
  });
  for (std::size_t i = 0; i < count; i += most) visit(all.subspan(i, std::min(most, count - i)));
}

}  // namespace gradus::pipeline::engine
