#pragma once
// What is nearest at each pixel of a tile: coverage by whole numbers, depths in blocks of 4 x 4 pixels at
// once. Depths are compared in single precision where that is sure to decide, and else by the textbook's
// arithmetic, so that the winner is the z-buffer's.

#include <array>
#include <cstdint>

#include "engine/geometry.hpp"
#include "engine/tiles.hpp"

namespace gradus::pipeline::engine {

/// The number of no triangle.
inline constexpr std::int32_t no_triangle = -1;

/// Pixels on a side of a block. The cells of a block stand beside one another, row by row.
inline constexpr int block_side = 4;
inline constexpr int block_cells = block_side * block_side;
inline constexpr int blocks_across = tile_side / block_side;

/// What is nearest at each pixel of a tile.
struct alignas(64) TileBuffer {
  static constexpr std::size_t cells = std::size_t{tile_side} * tile_side;

  std::array<float, cells> nearness;    ///< 1 - depth; -1 where there is nothing, 2 beyond the window
  std::array<std::int32_t, cells> ids;  ///< of the nearest triangles

  /// The cell of a pixel, counted from the tile's upper left.
  static constexpr std::size_t cell(ivec2 at) {
    const int block = at.y / block_side * blocks_across + at.x / block_side;
    return static_cast<std::size_t>(block * block_cells + at.y % block_side * block_side + at.x % block_side);
  }
  /// The pixel of a cell.
  static constexpr ivec2 place(std::size_t cell) {
    const auto block = static_cast<int>(cell) / block_cells, within = static_cast<int>(cell) % block_cells;
    return block_side * ivec2{block % blocks_across, block / blocks_across} +
           ivec2{within % block_side, within / block_side};
  }
};

/// Nothing is nearer than what lies beyond the window: sets the cells of a tile that are no pixels of it.
inline void close_beyond(const Window& pixels, std::array<float, TileBuffer::cells>& nearness) {
  for (int y = 0; y < tile_side; ++y)
    for (int x = y < pixels.height() ? static_cast<int>(pixels.width()) : 0; x < tile_side; ++x)
      nearness[TileBuffer::cell({x, y})] = 2;
}

/// Finds what is nearest at the pixels of a tile, of equals what comes first by object, face and piece.
///
/// frame: with its triangles sorted into tiles. pixels: of the tile. buffer: is overwritten; cells beyond the
///   window have no triangle.
///
/// Domain: that of make_frame.
/// Accuracy: coverage exact; the winner is that of z_buffer::keep_nearest with depths by
///   triangle_coverage::Depth, on every machine.
/// Cost: some 50 nanoseconds per triangle and tile, and 3 per block of its box, some 30 where surfaces are
/// equally
///   deep in it; 0.1 microseconds per pixel where they differ by rounding alone.
/// Errors: none.
void find_nearest(const Frame& frame, int tile, const Window& pixels, TileBuffer& buffer);

}  // namespace gradus::pipeline::engine
