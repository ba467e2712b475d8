#include "plan/cover.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "stages/6_rasterization.hpp"

namespace gradus::pipeline {
namespace {

using triangle_coverage::Edges;
using triangle_coverage::Weights;

/// Steps of the grid on a side of a tile.
constexpr int tile_steps = tile_pixels * triangle_coverage::subpixels;

/// An edge between snapped corners, the smaller one first, and which way it is gone through.
struct Directed {
  std::array<int, 4> ends;
  int sense;  ///< 1 from the smaller corner to the larger one, -1 back
};

Directed directed(ivec2 from, ivec2 to) {
  const bool forth = std::tie(from.x, from.y) < std::tie(to.x, to.y);
  if (!forth) std::swap(from, to);
  return {{from.x, from.y, to.x, to.y}, forth ? 1 : -1};
}

Window box_round(std::span<const ivec2> places) {
  Window box{places[0], places[0]};
  for (const ivec2 p : places) box = {glm::min(box.lower, p), glm::max(box.upper, p)};
  return box;
}

std::array<ivec2, 4> corners_of_tile(ivec2 tile) {
  const ivec2 a = tile * tile_steps, b = a + tile_steps;
  return {a, ivec2{b.x, a.y}, b, ivec2{a.x, b.y}};
}

/// Whether all corners of the tile lie strictly on one side of a line.
bool on_one_side(ivec2 from, ivec2 to, ivec2 tile) {
  const triangle_coverage::Edge line{from, to, false};
  int right = 0, left = 0;
  for (const ivec2 corner : corners_of_tile(tile)) {
    const std::int64_t side = line.at(corner);
    right += side > 0;
    left += side < 0;
  }
  return right == 4 || left == 4;
}

/// What is left of edges that are gone through both ways.
template <class Tell>
void tell_unpaired(std::vector<Directed>& edges, const Tell& tell) {
  std::ranges::sort(edges, {}, &Directed::ends);
  for (std::size_t i = 0; i < edges.size();) {
    int sum = 0;
    const auto ends = edges[i].ends;
    for (; i < edges.size() && edges[i].ends == ends; ++i) sum += edges[i].sense;
    if (sum != 0) tell(ivec2{ends[0], ends[1]}, ivec2{ends[2], ends[3]});
  }
}

}  // namespace

/// A triangle with an area, tile by tile.
class TiledTriangle {
 public:
  explicit TiledTriangle(const triangle_coverage::ScreenTriangle& t)
      : edges_(triangle_coverage::edges_of(t.corners)),
        depths_(t.depth),
        area_(std::abs(static_cast<double>(area_of(t.corners)))),
        deepest_corner_(std::max({t.depth.x, t.depth.y, t.depth.z})) {
    dvec2 slope{0};
    for (std::size_t i = 0; i < 3; ++i) {
      const ivec2 way = edges_[i].to - edges_[i].from;
      reach_[i] =
          std::int64_t{tile_steps / 2} * (std::abs(std::int64_t{way.x}) + std::abs(std::int64_t{way.y}));
      slope += depths_[static_cast<int>(i)] * dvec2(-way.y, way.x);
    }
    rise_ = (std::abs(slope.x) + std::abs(slope.y)) * (tile_steps / 2) / area_;
    // What a shared plane may be off it
    if (t.plane) rise_ += (std::abs(t.plane->right) + std::abs(t.plane->down)) / 2;
  }

  Weights at_middle(ivec2 tile) const {
    return triangle_coverage::weights_at_place(edges_, tile * tile_steps + tile_steps / 2);
  }
  /// Whether some of the tile may be in the triangle.
  bool meets(const Weights& middle) const {
    return middle[0] + reach_[0] >= 0 && middle[1] + reach_[1] >= 0 && middle[2] + reach_[2] >= 0;
  }
  /// A bound on its depth within the tile: its plane's, or its deepest corner's.
  double deepest(const Weights& middle) const {
    double depth = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double z = depths_[static_cast<int>(i)];
      depth += static_cast<double>(middle[i]) * z;
      size += static_cast<double>(std::abs(middle[i]) + reach_[i]) * std::abs(z);
    }
    constexpr double rounding = 0x1p-48;
    return std::min(depth / area_ + rise_ + rounding * size / area_, deepest_corner_);
  }

  /// With the inside on their right, whichever way the corners run.
  const Edges& edges() const { return edges_; }

 private:
  Edges edges_;
  dvec3 depths_;
  double area_, deepest_corner_;
  double rise_ = 0;                      ///< from a tile's middle to its deepest corner
  std::array<std::int64_t, 3> reach_{};  ///< how far the edge functions go from there
};

Cover::Cover(Size picture)
    : picture_(picture),
      tiles_((picture.width + tile_pixels - 1) / tile_pixels,
             (picture.height + tile_pixels - 1) / tile_pixels),
      traces_(tiles_.width(), tiles_.height()) {}

Window Cover::tiles_of(const Window& box) const {
  const auto tile = [](int place) {
    return place >= 0 ? place / tile_steps : -((-place - 1) / tile_steps) - 1;
  };
  return {
      {std::max(tile(box.lower.x), 0), std::max(tile(box.lower.y), 0)},
      {std::min(tile(box.upper.x), tiles_.width() - 1), std::min(tile(box.upper.y), tiles_.height() - 1)}};
}

Cover::Trace& Cover::trace(int object, ivec2 tile) {
  Trace& trace = traces_[tile];
  if (trace.object != object) trace = {object, false, false, 0};
  return trace;
}

/// What a triangle does to the tiles of its box, which are returned.
Window Cover::lay(int object, const TiledTriangle& triangle, const Window& box) {
  const Window tiles = tiles_of(box);
  for (int y = tiles.lower.y; y <= tiles.upper.y; ++y) {
    for (int x = tiles.lower.x; x <= tiles.upper.x; ++x) {
      const Weights middle = triangle.at_middle({x, y});
      if (!triangle.meets(middle)) continue;
      Trace& at = trace(object, {x, y});
      at.depth = std::max(at.depth, triangle.deepest(middle));
      at.seen |= middle[0] >= 0 && middle[1] >= 0 && middle[2] >= 0;
    }
  }
  return tiles;
}

/// An edge of the whole.
void Cover::border(int object, ivec2 from, ivec2 to) {
  const Window tiles = tiles_of(box_round(std::array{from, to}));
  for (int y = tiles.lower.y; y <= tiles.upper.y; ++y) {
    for (int x = tiles.lower.x; x <= tiles.upper.x; ++x) {
      const ivec2 tile{x, y};
      if (!on_one_side(from, to, tile)) trace(object, tile).edged = true;
    }
  }
}

void Cover::add(int object, std::span<const Triangle> triangles) {
  std::vector<Directed> edges;
  Window touched{{tiles_.width(), tiles_.height()}, {-1, -1}};
  for (const Triangle& t : triangles) {
    const triangle_coverage::Triangle grid = on_grid(snapped(in_picture(t, picture_)));
    if (!keeps_side(t, area_of(grid))) continue;
    const TiledTriangle triangle(on_screen(grid, t));
    const Window tiles = lay(object, triangle, box_round(grid));
    touched = {glm::min(touched.lower, tiles.lower), glm::max(touched.upper, tiles.upper)};
    for (const triangle_coverage::Edge& edge : triangle.edges())
      edges.push_back(directed(edge.from, edge.to));
  }
  tell_unpaired(edges, [&](ivec2 from, ivec2 to) { border(object, from, to); });
  for (int y = touched.lower.y; y <= touched.upper.y; ++y) {
    for (int x = touched.lower.x; x <= touched.upper.x; ++x) {
      const Trace& at = traces_[{x, y}];
      if (at.object != object || !at.seen || at.edged) continue;
      Tile& tile = tiles_[{x, y}];
      if (at.depth < tile.depth) tile = {at.depth, object};
    }
  }
}

int Cover::hider_of(const ScreenBox& extent) const {
  const auto& [lower, upper] = extent.pixels;
  if (extent.pixels.empty()) return -1;
  // Depths of stage 6 are off by a few ulp of the largest corner's, or by the slack of a shared plane
  constexpr double off = 2 * triangle_coverage::Depth::slack;
  int hider = -1;
  for (int y = lower.y / tile_pixels; y <= upper.y / tile_pixels; ++y) {
    for (int x = lower.x / tile_pixels; x <= upper.x / tile_pixels; ++x) {
      const Tile& tile = tiles_[{x, y}];
      if (!(tile.depth + off < extent.depth)) return -1;
      hider = tile.object;
    }
  }
  return hider;
}

}  // namespace gradus::pipeline
