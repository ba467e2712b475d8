#include "engine/ties.hpp"

#include <cmath>

#include "engine/tiles.hpp"

namespace gradus::pipeline::engine {
namespace {

constexpr int tile_places = tile_side * triangle_coverage::subpixels;

/// What sums of a few products lose by rounding, as a share of the products' sizes, and more.
constexpr double lost = 0x1p-47;

/// The corners of a triangle and their depths, in an order of their own.
using Corners = std::array<std::tuple<int, int, double>, 3>;

Corners corners_of(const FrameTriangle& t) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = {t.grid[k].x, t.grid[k].y, t.depth[static_cast<int>(k)]};
  std::ranges::sort(corners);
  return corners;
}

bool operator==(const triangle_coverage::DepthPlane& a, const triangle_coverage::DepthPlane& b) {
  return a.from == b.from && a.depth == b.depth && a.right == b.right && a.down == b.down;
}

/// Whether two triangles have the same depth at each place, to the bit, as far as planes tell it.
bool are_as_deep(const Frame& frame, const FrameTriangle& a, const FrameTriangle& b) {
  const PlaneDepth one = frame.plane_of(a), two = frame.plane_of(b);
  if (!one && !two) return corners_of(a) == corners_of(b);
  return one && two && (a.plane == b.plane || *one == *two);
}

TileDepth depth_by_plane(const FrameTriangle& t, const PlaneDepth& plane, ivec2 origin) {
  const auto& [from, depth, right, down] = *plane;
  const dvec2 way = glm::abs(dvec2(origin) - from) + double{tile_places};
  TileDepth over;
  over.at = plane->at(origin);
  over.right = right;
  over.down = down;
  over.off = lost * (1 + std::abs(depth) + std::abs(right) * way.x + std::abs(down) * way.y);
  over.plane = plane;
  over.kept = kept_depths(t.depth);
  return over;
}

TileDepth depth_by_corners(const FrameTriangle& t, ivec2 origin) {
  const auto edges = triangle_coverage::edges_of(t.grid);
  const double area = std::abs(static_cast<double>(triangle_coverage::doubled_area(t.grid)));
  TileDepth over;
  over.at = t.depth.x;
  double size = 1 + std::abs(t.depth.x);
  for (const int k : {1, 2}) {
    const triangle_coverage::Edge& edge = edges[static_cast<std::size_t>(k)];
    const double rise = (t.depth[k] - t.depth.x) / area, there = static_cast<double>(edge.at(origin)) * rise,
                 right = static_cast<double>(std::int64_t{edge.from.y} - edge.to.y) * rise,
                 down = static_cast<double>(std::int64_t{edge.to.x} - edge.from.x) * rise;
    over.at += there;
    over.right += right;
    over.down += down;
    size += std::abs(there) + (std::abs(right) + std::abs(down)) * tile_places;
  }
  over.off = lost * size;
  return over;
}

/// origin: a tile's upper left, in 1/256 pixel.
TileDepth depth_over_tile(const Frame& frame, std::int32_t id, ivec2 origin) {
  const FrameTriangle& t = frame.triangle(id);
  const PlaneDepth plane = frame.plane_of(t);
  TileDepth over = plane ? depth_by_plane(t, plane, origin) : depth_by_corners(t, origin);
  over.id = id;
  return over;
}

}  // namespace

const TileDepth& TileTies::known(std::int32_t id) {
  TileDepth& known = known_[static_cast<std::size_t>(id) % known_.size()];
  if (known.id != id) known = depth_over_tile(frame_, id, origin_);
  return known;
}

void TileTies::set(std::int32_t id, std::int32_t other) {
  one_ = known(id);
  two_ = known(other);
  const FrameTriangle &one = frame_.triangle(id), &two = frame_.triangle(other);
  is_as_deep_ = are_as_deep(frame_, one, two);
  is_first_ = std::tuple(piece_of(frame_, one, id), id) < std::tuple(piece_of(frame_, two, other), other);
}

}  // namespace gradus::pipeline::engine
