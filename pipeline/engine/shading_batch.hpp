#pragma once
// Light and colours in single precision, sixteen pixels at once.

#include <array>
#include <cstdint>
#include <span>

#include "engine/shading.hpp"
#include "engine/visibility_batch.hpp"

namespace gradus::pipeline::engine {

/// Up to three of the triangles that a block of 4 x 4 cells shows; what is left of the places repeats the
/// first of them.
struct ShownBlock {
  std::int32_t block = 0, triangles = 0;
  std::array<std::int32_t, 3> ids{}, cells{};  ///< which they are, and how many cells show each
  std::array<std::int32_t, 3> slots{};         ///< their records
};
inline constexpr std::size_t most_shown_blocks =
    std::size_t{blocks_across} * blocks_across * ((block_cells + 2) / 3);

/// Lists what the blocks of a tile show, block by block, each triangle of a block once, in the order of its
/// cells, but for their slots. shown: is written from the first on. Returns how many there are. Cost: 3
/// nanoseconds each.
std::size_t list_shown(const TileBuffer& buffer, std::span<ShownBlock, most_shown_blocks> shown);

/// Pixels of one group that are lit alike, and the records of their triangles.
struct LitCells {
  const ShadingGroup* group = nullptr;
  const RecordBlock* records = nullptr;
  bool per_pixel = true;  ///< records have places and normals; else scattered light and highlight
  glm::vec3 towards{0};   ///< the viewer, where rays are parallel
};

/// Colours of blocks, of each the cells that show one of its triangles: all of one group.
///
/// colours: of all cells of the tile, aligned to 64 bytes; gets 8-bit sRGB, red in the lowest byte, or 0 for
///   those in doubt, which the textbook's arithmetic must light: where a highlight or a spot ends at once,
///   beside a lamp, and where normals nearly cancel out.
///
/// Returns whether some are in doubt.
/// Accuracy: the nearest byte or one beside it where single precision suits; the same on every machine.
/// Cost: 4 nanoseconds per pixel and lamp with 16 lanes, of which a block has 16.
bool light_blocks(const LitCells& lit, std::span<const ShownBlock> blocks, const TileBuffer& buffer,
                  std::uint32_t* colours);

/// Places of one group, anywhere in a tile's pixels, and their light.
struct LitPlaces {
  std::span<const float> columns, rows;  ///< counted from the middle of the tile's first pixel
  std::span<const std::int32_t> slots;   ///< which record each has
  std::span<float> light;  ///< three numbers each, red of all, then green of all; red is -1 where in doubt
};
/// Linear light of places. Domain: a multiple of 16 of them. Accuracy, cost: as light_blocks.
void light_places(const LitCells& lit, const LitPlaces& places);

/// 8-bit sRGB of linear light, as light_blocks writes it. light: three numbers each, as LitPlaces has them.
/// Domain: a multiple of 16. Accuracy: the nearest byte or one beside it.
void pack(std::span<const float> light, std::span<std::uint32_t> colours);

/// Where a tile's pixels stand in a picture.
struct TileRows {
  std::uint32_t* first;  ///< the upper left one
  std::size_t stride;    ///< pixels from a row to the next
  int width, height;
};
/// Copies the pixels of a tile from their cells.
void copy_tile(const std::uint32_t* colours, const TileRows& rows);
/// Gives all pixels of a tile one colour.
void fill_tile(std::uint32_t colour, const TileRows& rows);

/// 8-bit sRGB of a background, as light_blocks writes it.
std::uint32_t packed(const LinearRgb& colour);

}  // namespace gradus::pipeline::engine
