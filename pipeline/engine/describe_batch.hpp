#pragma once
// What pixels ask for of the triangles that they show: planes over the picture of what is linear on a
// surface, sixteen triangles at once.

#include <cstdint>

#include "core/geometry.hpp"
#include "engine/shading.hpp"

namespace gradus::pipeline::engine {

/// Which pixels of a tile ask.
struct AskedPixels {
  ivec2 origin{0};       ///< the tile's upper left pixel: records count from there
  Window square;         ///< all pixels of the tile's place in the picture
  bool squares = false;  ///< they ask anywhere in their squares; else in their centres
};

/// Describes triangles that a tile shows: in Gouraud's shading it lights their corners.
///
/// seen: each touches a pixel of the square. It is changed: places are counted from the eye afterwards, and
///   normals have length 1 or 0. records: gets those of all of them. Planes count from the pixel in a corner
///   of a triangle's box that is nearest to the viewer: from there on what is linear on the surface changes
///   ever faster, so that single precision has the digits it needs everywhere.
///
/// Returns a bit for each triangle that single precision would not do for: it is so thin that planes lose
///   digits, its texture repeats too often, or a corner's light is in doubt.
/// Accuracy: planes in double, rounded to single; light as light_blocks; the same on every machine.
/// Cost: with FrameShading::put a quarter of the time of a picture whose triangles have a few pixels each.
/// Errors: none.
std::uint32_t describe(const FrameShading& shading, const AskedPixels& asked, SeenTriangles& seen,
                       RecordBlock& records);

}  // namespace gradus::pipeline::engine
