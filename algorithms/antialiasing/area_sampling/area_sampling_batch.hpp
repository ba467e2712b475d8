#pragma once
// Exact areas for speed: the bytes of area_sampling.hpp for whole polygons, row by row, each edge looked at
// once in each row that it crosses.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "antialiasing/area_sampling/small_polygon_batch.hpp"
#include "core/geometry.hpp"
#include "core/raster.hpp"

namespace gradus::area_sampling {

/// Draws polygons into a raster of bytes, as much as each covers of each pixel, and keeps its memory for the
/// next one.
///
/// Source: of the idea, that the area on one side of an edge needs nothing but its crossings with a row:
/// D. Turner's rasterizer in FreeType and R. Levien, font-rs, 2016. The running sum of what the edges of a
/// row change from pixel to pixel is the area that is covered there.
class AreaScan {
 public:
  using Ring = std::span<const ivec2>;

  /// Gives each pixel of which the polygon covers something the byte floor(255 area + 1/2); others keep what
  /// they have, as do pixels whose byte would be 0.
  ///
  /// picture: pixel (c, r) covers [c, c + 1) x [r, r + 1). rings: closed outlines in 1/256 pixel, as
  ///   triangle_coverage::snap gives them.
  ///
  /// Domain: rings that cross neither themselves nor each other, holes run round the other way; corners at
  ///   most triangle_coverage::farthest pixels from 0. They may reach out of the picture and touch each
  ///   other. Rings of fewer than three corners and without area cover nothing.
  /// Accuracy: exact. Areas are sums in double with a bound of their error; where that bound doesn't tell
  ///   the byte, fractions of 128 bits and as many digits as it takes do.
  /// Cost: for each row and edge that crosses it some ns and some for each pixel on the edge; what lies
  ///   between edges is filled. Memory of some 80 bytes per edge and 9 per column, and 9 KB.
  ///   Polygons of a few pixels take about half (small_polygon_batch.hpp).
  /// Errors: ContractViolation for corners that lie too far out.
  void draw(Raster<std::uint8_t>& picture, std::span<const Ring> rings);
  void draw(Raster<std::uint8_t>& picture, Ring ring) { draw(picture, std::span<const Ring>(&ring, 1)); }

  /// How many bytes so far were decided in whole numbers, because sums in double left them open.
  std::int64_t decided_exactly() const { return decided_exactly_; }

 private:
  /// An edge that is not level.
  struct Edge {
    ivec2 top, bottom;       ///< in 1/256 pixel
    double x;                ///< of the upper end, in pixels from the box's left side
    double across;           ///< how far x goes a 1/256 of a row
    double rise;             ///< how many rows a pixel of x takes; 0 for an upright edge
    int sign;                ///< +1 where what it has on its right is covered
    bool cut;                ///< whether it leaves the picture at a side
    std::int32_t next = -1;  ///< the next one that begins in the same band
  };
  /// An area of one pixel is this much in changes_.
  static constexpr std::int64_t whole = std::int64_t{1} << 40;
  static constexpr int group = 8;  ///< columns that touched_ has a byte for

  void place(const Raster<std::uint8_t>& picture, std::span<const Ring> rings);
  void collect(std::span<const Ring> rings);
  void add_edge(ivec2 from, ivec2 to);
  std::int64_t doubt_of(std::size_t edges) const;
  void add(const Edge& edge, int row, double left, double right, std::int64_t height);
  void add_long(const Edge& edge, int row, double left, double right, std::int64_t height);
  void add_cut(const Edge& edge, int row, double left, double right, std::int64_t height);
  void scan(const Edge& edge, int band);
  std::uint8_t decide(int row, std::ptrdiff_t column, int in_doubt);
  std::uint8_t byte_of(std::int64_t area, int row, std::ptrdiff_t column);
  void fill(std::span<std::uint8_t> pixels, int row, std::ptrdiff_t begin, std::ptrdiff_t end,
            std::int64_t area);
  std::uint64_t bytes_of(std::int64_t* changes, int row, std::ptrdiff_t first, std::int64_t& area);
  void fill_exactly(std::span<std::uint8_t> pixels, int row, std::ptrdiff_t begin, std::ptrdiff_t end,
                    std::int64_t area);
  static void put(std::span<std::uint8_t> pixels, std::uint64_t bytes);
  void sweep(std::span<std::uint8_t> pixels, int row, int row_of_band);

  SmallPolygonScan small_;
  ivec2 corner_{0};  ///< of the part of the picture that the polygon may reach
  int columns_ = 0, rows_ = 0;
  int band_rows_ = 1;       ///< rows that are worked off together
  int orientation_ = 1;     ///< of the polygon
  double farthest_ = 0;     ///< the largest coordinate, in pixels
  std::int64_t doubt_ = 0;  ///< how far 255 area may be off in this band
  bool rounded_ = false;    ///< whether sums may be off: not where all edges are upright, level or diagonal
  std::vector<Edge> edges_;
  std::vector<std::int32_t> first_;      ///< by band: the first edge that begins there
  std::vector<std::int32_t> active_;     ///< the edges that cross the band
  std::vector<std::int64_t> changes_;    ///< by row of the band and column: how much more is covered
  std::vector<std::uint8_t> touched_;    ///< by row of the band and group of columns: 1 with changes
  std::size_t stride_ = 0, groups_ = 0;  ///< of a row in these
  std::int64_t decided_exactly_ = 0;
};

}  // namespace gradus::area_sampling
