#pragma once
// Light and colours in single precision, sixteen pixels at once.

#include <array>
#include <cstdint>
#include <span>

#include "engine/shading.hpp"

namespace gradus::pipeline::engine {

/// Pixels of one group that are lit alike: cells of a tile (TileBuffer::cell), and which record each has.
struct LitCells {
  const ShadingGroup* group = nullptr;
  const TriangleRecord* records = nullptr;
  bool per_pixel = true;  ///< records have places and normals; else scattered light and highlight
  glm::vec3 towards{0};   ///< the viewer, where rays are parallel
};

/// Colours of cells, each with its own record.
///
/// cells, slots: as long; a multiple of 16. colours: of all cells of the tile; gets 8-bit sRGB, red in the
///   lowest byte, or 0 for those in doubt, which the textbook's arithmetic must light: where a highlight or
///   a spot ends at once, beside a lamp, and where normals nearly cancel out.
///
/// Returns whether some are in doubt.
/// Accuracy: the nearest byte or one beside it where single precision suits; the same on every machine.
/// Cost: 10 nanoseconds a pixel and lamp with 16 lanes.
bool light_cells(const LitCells& lit, std::span<const std::int32_t> cells,
                 std::span<const std::int32_t> slots, std::uint32_t* colours);
/// A block of 4 x 4 cells, and the records of the triangles of one group in it: up to three, the others
/// repeat the last one.
struct LitBlock {
  std::int32_t block;
  std::array<std::int32_t, 3> slots;
};
/// The same of blocks, of each the cells that have one of its slots.
/// slots_of_cells: of all cells of the tile, aligned to 64 bytes.
/// Cost: 4 nanoseconds a pixel and lamp, of which a block has 16.
bool light_blocks(const LitCells& lit, std::span<const LitBlock> blocks, const std::int32_t* slots_of_cells,
                  std::uint32_t* colours);

/// Places of one group, anywhere in a tile's pixels, and their light.
struct LitPlaces {
  std::span<const float> columns, rows;  ///< counted from the middle of the tile's first pixel
  std::span<const std::int32_t> slots;   ///< which record each has
  std::span<float> light;  ///< three numbers each, red of all, then green of all; red is -1 where in doubt
};
/// Linear light of places. Domain: a multiple of 16 of them. Accuracy, cost: as light_cells.
void light_places(const LitCells& lit, const LitPlaces& places);

/// 8-bit sRGB of linear light, as light_cells writes it. light: three numbers each, as LitPlaces has them.
/// Domain: a multiple of 16. Accuracy: the nearest byte or one beside it.
void pack(std::span<const float> light, std::span<std::uint32_t> colours);

/// A corner that is lit, and its light: scattered light of three colours, then the highlight's.
struct LitCorners {
  std::span<const float> places, normals;  ///< three numbers each, x of all, then y of all, then z of all
  std::span<float> light;  ///< six numbers each, in the same way, then 1 where they are in doubt, else 0
};

/// Lights corners. Domain: a multiple of 16 of them. Accuracy, cost: as light_cells.
void light_corners(const ShadingGroup& group, const glm::vec3& towards, const LitCorners& corners);

/// 8-bit sRGB of a background, as light_cells writes it.
std::uint32_t packed(const LinearRgb& colour);

}  // namespace gradus::pipeline::engine
