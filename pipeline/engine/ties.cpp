#include "engine/ties.hpp"

#include <cmath>
#include <tuple>

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

/// The plane of two triangles that have their depths from the same one, to the bit.
PlaneDepth plane_of_both(const Frame& frame, const FrameTriangle& a, const FrameTriangle& b) {
  const PlaneDepth one = frame.plane_of(a), two = frame.plane_of(b);
  return one && two && (a.plane == b.plane || *one == *two) ? one : PlaneDepth{};
}

/// Whether two triangles without shared planes have the same depth at each place, to the bit.
bool have_same_corners(const FrameTriangle& a, const FrameTriangle& b) {
  return a.plane == no_plane && b.plane == no_plane && corners_of(a) == corners_of(b);
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
  over.exact = {frame, t};
  return over;
}

}  // namespace

void TileTies::learn(std::int32_t id, Known& all) const {
  all.resize(most_known);
  all[static_cast<std::size_t>(id) % most_known] = depth_over_tile(frame_, id, origin_);
}

void TileTies::set_pair(std::int32_t id, std::int32_t other) {
  const FrameTriangle &one = frame_.triangle(id), &two = frame_.triangle(other);
  id_ = id;
  other_ = other;
  plane_ = plane_of_both(frame_, one, two);
  one_kept_ = kept_depths(one.depth);
  two_kept_ = kept_depths(two.depth);
  are_alike_ = have_same_corners(one, two);
  const bool is_first =
      std::tuple(piece_of(frame_, one, id), id) < std::tuple(piece_of(frame_, two, other), other);
  by_faces_ = is_first ? Order::before : Order::after;
  by_faces_within_ =
      is_first ? not_deeper_within(one_kept_, two_kept_) : not_deeper_within(two_kept_, one_kept_);
}

TileTies::Order TileTies::order_by_planes(const TileDepth& one, const TileDepth& two,
                                          const Places& places) const {
  if (!one.is_plane_at(places) || !two.is_plane_at(places)) return Order::open;
  const dvec2 from = dvec2(places.first - origin_);
  const double right = two.right - one.right, down = two.down - one.down,
               deeper = two.at - one.at + right * from.x + down * from.y, off = one.off + two.off,
               least = deeper + (std::min(right, 0.0) + std::min(down, 0.0)) * places.side,
               most = deeper + (std::max(right, 0.0) + std::max(down, 0.0)) * places.side;
  return least > off ? Order::before : most < -off ? Order::after : Order::open;
}

}  // namespace gradus::pipeline::engine
