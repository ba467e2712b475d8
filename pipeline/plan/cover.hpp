#pragma once
// A coarse picture of what stands before: tiles of the picture that the triangles of an object cover whole,
// and how deep they are there at most. What lies deeper in all its tiles is hidden.

#include <cstdint>
#include <limits>
#include <span>

#include "core/raster.hpp"
#include "plan/plan.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// Pixels on a side of a tile.
inline constexpr int tile_pixels = 8;

class TiledTriangle;

/// What the objects drawn so far hide.
///
/// Where triangles that all run the same way round overlap, the number of layers changes only across edges
/// that not two of them share in opposite directions. A tile that no such edge meets, and of which one place
/// is covered, is covered whole: without a gap, for neighbours share snapped corners.
class Cover {
 public:
  explicit Cover(Size picture);

  /// Adds what an object covers. triangles: all of its stage 5; those that stage 6 would not draw cover
  /// nothing. Cost: a few dozen nanoseconds per edge and tile of each triangle's box.
  void add(int object, std::span<const Triangle> triangles);

  /// The number of an object that stands before all of an extent, with others; -1 where it may be seen, and
  /// where it has no pixel. Accuracy: on the safe side; depths must differ by more than rounding errors.
  int hider_of(const ScreenBox& extent) const;

 private:
  /// What stands before a tile.
  struct Tile {
    double depth = std::numeric_limits<double>::infinity();  ///< all of it is nearer than that
    int object = -1;
  };
  /// What the object that is being added does to a tile.
  struct Trace {
    int object = -1;     ///< whose trace this is
    bool seen = false;   ///< some triangle covers the tile's middle
    bool edged = false;  ///< an edge of the whole meets it
    double depth = 0;    ///< no triangle is deeper there
  };

  /// The tiles that a box on the grid of 1/256 pixel meets.
  Window tiles_of(const Window& box) const;
  Trace& trace(int object, ivec2 tile);
  Window lay(int object, const TiledTriangle& triangle, const Window& box);
  void border(int object, ivec2 from, ivec2 to);

  Size picture_;
  Raster<Tile> tiles_;
  Raster<Trace> traces_;
};

}  // namespace gradus::pipeline
