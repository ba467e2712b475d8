#pragma once
// Triangles over a tile, as batches ask for them: edge functions by whole numbers, and how near the viewer.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/geometry.hpp"
#include "engine/ties.hpp"
#include "engine/visibility_batch.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"

namespace gradus::pipeline::engine {

/// Depths in single precision differ surely by more than this share and this much.
inline constexpr float unsure_share = 0x1p-19f, unsure_at_least = 0x1p-27f;

/// What a batch may find a depth to be at least, or at most.
inline float unsure_at(float nearness) { return nearness * unsure_share + unsure_at_least; }

/// One side of a triangle over the pixels of a tile: at + a x + b y >= 0 for those inside, x and y counted
/// from the tile's upper left.
struct Side {
  std::int64_t at, a, b;
};

/// The edge function over 256, rounded down, which keeps its sign; less by one where the edge does not own
/// what lies on it. there: that in the centre that x and y are counted from, before the division.
[[gnu::always_inline]] inline Side side_of(const triangle_coverage::Edge& edge, std::int64_t there) {
  return {there >> 8, std::int64_t{edge.from.y} - edge.to.y, std::int64_t{edge.to.x} - edge.from.x};
}

/// The least and the largest value over a box.
[[gnu::always_inline]] inline std::int64_t least(const Side& s, const Window& box) {
  return s.at + std::min(s.a * box.lower.x, s.a * box.upper.x) +
         std::min(s.b * box.lower.y, s.b * box.upper.y);
}
[[gnu::always_inline]] inline std::int64_t largest(const Side& s, const Window& box) {
  return s.at + std::max(s.a * box.lower.x, s.a * box.upper.x) +
         std::max(s.b * box.lower.y, s.b * box.upper.y);
}

/// The pixels of the blocks that a box meets.
inline Window in_blocks(const Window& box) {
  return {box.lower / block_side * block_side,
          box.upper / block_side * block_side + ivec2{block_side - 1, block_side - 1}};
}

/// 1 - depth over the pixels of a tile.
struct NearnessPlane {
  double at, right, down;
};

/// A triangle over a tile.
struct Cast {
  Window box;  ///< pixels that it may cover, counted from the tile's upper left
  std::array<Side, 3> sides;
  std::array<std::int64_t, 3> origin;  ///< the edge functions in the first centre, less 1 where not owned
  NearnessPlane plane;
};

/// How a triangle lies over a tile. box: not empty.
[[gnu::always_inline]] inline Cast cast_of(const FrameTriangle& t, const Window& box, ivec2 origin) {
  const auto edges = triangle_coverage::edges_of(t.grid);
  const ivec2 there = triangle_coverage::centre_of(origin);
  const std::int64_t second = edges[1].at(there), third = edges[2].at(there);
  Cast cast;
  cast.box = {box.lower - origin, box.upper - origin};
  cast.origin = {edges[0].at(there) - !edges[0].owns, second - !edges[1].owns, third - !edges[2].owns};
  for (std::size_t k = 0; k < 3; ++k) cast.sides[k] = side_of(edges[k], cast.origin[k]);
  const double over_area = 1 / static_cast<double>(std::abs(triangle_coverage::doubled_area(t.grid)));
  const double to_second = (t.depth.x - t.depth.y) * over_area,
               to_third = (t.depth.x - t.depth.z) * over_area;
  const auto mixed = [&](std::int64_t a, std::int64_t b) {
    return static_cast<double>(a) * to_second + static_cast<double>(b) * to_third;
  };
  constexpr int step = triangle_coverage::subpixels;
  cast.plane = {(1 - t.depth.x) + mixed(second, third), step * mixed(cast.sides[1].a, cast.sides[2].a),
                step * mixed(cast.sides[1].b, cast.sides[2].b)};
  return cast;
}

/// By how much the nearness changes from pixel to pixel, at most.
inline double slope_of(const NearnessPlane& plane) { return std::abs(plane.right) + std::abs(plane.down); }

/// How far a shared plane may be from that through a triangle's snapped corners, which lie up to half a step
/// of the grid beside their places.
inline double shared_plane_off(const PlaneDepth& plane) {
  return plane ? (std::abs(plane->right) + std::abs(plane->down)) / 2 + triangle_coverage::Depth::slack : 0;
}

/// Whether a shared plane begins so near that its depth over a tile is as good as those between corners.
inline bool begins_near(const triangle_coverage::DepthPlane& plane, ivec2 place) {
  const dvec2 way = dvec2(place) - plane.from;
  return std::abs(plane.right * way.x) + std::abs(plane.down * way.y) <= 0x1p10;
}

/// Between which bounds a triangle of a shared plane keeps its nearness; none for others.
struct NearnessRange {
  float low = -std::numeric_limits<float>::infinity(), high = std::numeric_limits<float>::infinity();
  double off = 0;       ///< by how much a bound may be off the plane
  bool is_fine = true;  ///< single precision is enough

  float clamped(float nearness) const { return std::min(std::max(nearness, low), high); }
};

/// Gives a triangle over a tile the nearness of the plane that it shares, if it does. origin: of the tile.
inline NearnessRange take_shared_plane(const PlaneDepth& plane, const dvec3& depth, ivec2 origin,
                                       Cast& cast) {
  if (!plane) return {};
  const ivec2 there = triangle_coverage::centre_of(origin);
  const double off = shared_plane_off(plane);
  if (!begins_near(*plane, there)) return {.off = off, .is_fine = false};
  constexpr int step = triangle_coverage::subpixels;
  cast.plane = {1 - plane->at(there), -step * plane->right, -step * plane->down};
  const auto [least, most] = kept_depths(depth);
  return {static_cast<float>(1 - most), static_cast<float>(1 - least), off};
}

/// How near a triangle is at least in the pixels of its box. depth: of its corners.
inline double least_nearness(const Cast& cast, const dvec3& depth) {
  const auto& [at, right, down] = cast.plane;
  const double in_box = at + std::min(right * cast.box.lower.x, right * cast.box.upper.x) +
                        std::min(down * cast.box.lower.y, down * cast.box.upper.y);
  return std::max(in_box, 1 - std::max(std::max(depth.x, depth.y), depth.z));
}

/// Whether single precision stays within the shares above.
inline bool is_flat_enough(const Cast& cast, const dvec3& depth) {
  return slope_of(cast.plane) <= std::max(least_nearness(cast, depth) / 2, 0x1p-9);
}

/// Whether a side that crosses the box is too long for blocks: for 32 bits in a block, or, where it is longer
/// than 2^15 pixels and the triangle less than a pixel wide, for planes in double precision.
inline bool is_too_long(const Cast& cast, const Side& side) {
  const std::int64_t longest = std::max(std::abs(side.a), std::abs(side.b));
  const std::int64_t area = cast.origin[0] + cast.origin[1] + cast.origin[2];
  return longest >= 1 << 27 || (longest >= 1 << 23 && area < longest * triangle_coverage::subpixels);
}

/// A side in the first pixel of a block, so far that 32 bits hold what its other pixels add: the signs stay.
inline std::int32_t at_block(const Side& side, ivec2 first) {
  constexpr std::int64_t far = 1 << 30;
  return static_cast<std::int32_t>(std::clamp(side.at + side.a * first.x + side.b * first.y, -far, far));
}

}  // namespace gradus::pipeline::engine
