#pragma once
// A picture of triangles by exact visible areas: for each pixel the mean of what is seen in it.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "antialiasing/area_sampling/front_to_back.hpp"
#include "antialiasing/area_sampling/pixel_polygon.hpp"
#include "antialiasing/area_sampling/visible_areas.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"

namespace gradus::area_sampling {

using triangle_coverage::DepthPlane;
using triangle_coverage::Edges;
using triangle_coverage::edges_of;
using triangle_coverage::near_enough;
using triangle_coverage::ScreenTriangle;
using triangle_coverage::Weights;

/// The depth of a triangle as a function of places in a pixel.
/// Domain: a triangle with an area; finite depths.
/// Accuracy: exact in rationals; constant depths are exact in double, too. Triangles that share a plane have
///   the same one to the bit; where corners were snapped, a part may lie beyond their depths (see
///   add_in_range).
template <class T>
Plane<T> plane_in(const ScreenTriangle& triangle, const Edges& edges, ivec2 pixel) {
  if (const auto& shared = triangle.plane)
    return {T(shared->at(pixel * subpixels)), T(shared->right) * T{subpixels},
            T(shared->down) * T{subpixels}};
  const Weights w = weights_at_place(edges, pixel * subpixels);
  const T sum = static_cast<T>(w[0] + w[1] + w[2]);
  Plane<T> plane{T(triangle.depth[0]), T{0}, T{0}};
  for (int i = 1; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const std::int64_t down = (std::int64_t{edges[k].to.x} - edges[k].from.x) * subpixels;
    const T more = (T(triangle.depth[i]) - T(triangle.depth[0])) / sum;
    plane.at_corner = plane.at_corner + static_cast<T>(w[k]) * more;
    plane.per_column = plane.per_column + static_cast<T>(edges[k].step()) * more;
    plane.per_row = plane.per_row + static_cast<T>(down) * more;
  }
  return plane;
}

/// A triangle's part in a pixel, if it has one.
template <class T>
std::optional<Fragment<T>> fragment_in(const ScreenTriangle& triangle, ivec2 pixel, int key) {
  if (triangle_coverage::doubled_area(triangle.corners) == 0) return std::nullopt;
  Polygon piece = clockwise(triangle.corners), half;
  cut(piece, top_of(pixel.y), half);
  cut(half, bottom_of(pixel.y), piece);
  cut(piece, left_of(pixel.x), half);
  cut(half, right_of(pixel.x), piece);
  Fragment<T> fragment{{}, plane_in<T>(triangle, edges_of(triangle.corners), pixel), key};
  fragment.outline = outline_in<T>(piece, pixel);
  if (!(area_of(fragment.outline) > T{0})) return std::nullopt;
  return fragment;
}

/// The nearest and the deepest of some corners.
struct DepthRange {
  double least = std::numeric_limits<double>::infinity(), most = -least;
};

/// How deep the corners of all triangles are that share a plane: one range for all, so that they still have
/// one depth at each place.
class SharedRanges {
 public:
  explicit SharedRanges(std::span<const ScreenTriangle> triangles) {
    constexpr double slack = triangle_coverage::Depth::slack;
    for (const ScreenTriangle& t : triangles) {
      if (!t.plane) continue;
      DepthRange& range = of_[numbers(*t.plane)];
      const auto [least, most] = std::minmax({t.depth.x, t.depth.y, t.depth.z});
      range = {std::min(range.least, least - slack), std::max(range.most, most + slack)};
    }
  }
  DepthRange of(const DepthPlane& plane) const { return of_.find(numbers(plane))->second; }

 private:
  static std::array<double, 5> numbers(const DepthPlane& p) {
    return {p.from.x, p.from.y, p.depth, p.right, p.down};
  }
  std::map<std::array<double, 5>, DepthRange> of_;
};

/// Adds a fragment of a shared plane. Where snapping takes the plane beyond the depths of all its corners, it
/// is as near as the nearest of them, or as deep as the deepest: nothing is seen through what lies before.
inline void add_in_range(Fragment<double> fragment, const DepthRange& range,
                         std::vector<Fragment<double>>& fragments) {
  const auto keep_within = [&](double end, double way) {
    const auto within = [&](dvec2 p) { return way * (end - fragment.depth.at(p)); };
    auto [kept, beyond] = split(fragment.outline, 0.0, within);
    if (beyond.empty()) return;
    fragments.push_back({std::move(beyond), {end, 0, 0}, fragment.key});
    fragment.outline = std::move(kept);
  };
  keep_within(range.least, -1);
  keep_within(range.most, 1);
  if (!fragment.outline.empty()) fragments.push_back(std::move(fragment));
}

/// Whether a triangle covers a whole pixel.
constexpr bool covers_whole(const Edges& edges, ivec2 pixel) {
  const ivec2 corner = pixel * subpixels;
  return std::ranges::all_of(edges, [&](const auto& edge) {
    // The corner of the pixel that lies farthest out
    const int right = edge.step() < 0 ? subpixels : 0, down = edge.to.x < edge.from.x ? subpixels : 0;
    return edge.at(corner + ivec2{right, down}) >= 0;
  });
}

/// The weights of a triangle at the place of the grid next to a point of it; those of a place that lies a
/// little outside are moved to its border. place: in 1/256 pixel.
/// Accuracy: none is below 0, and they add up to the |doubled area|.
inline Weights weights_near(const Edges& edges, dvec2 place) {
  Weights w = weights_at_place(
      edges, {static_cast<int>(std::floor(place.x + 0.5)), static_cast<int>(std::floor(place.y + 0.5))});
  const std::int64_t sum = w[0] + w[1] + w[2];
  for (std::int64_t& weight : w) weight = std::clamp<std::int64_t>(weight, 0, sum);
  // What that has added or taken away is the largest one's
  std::int64_t& largest = *std::ranges::max_element(w);
  largest += sum - (w[0] + w[1] + w[2]);
  return w;
}

/// The centre of mass of pieces with an area. Accuracy: m 2^-41 for m triangles round the pieces' first
/// corners, where the area is above 2^-10.
inline dvec2 centroid_of(const Pieces<double>& pieces) {
  dvec2 sum(0);
  double doubled = 0;
  for (const auto& piece : pieces) {
    for (std::size_t i = 2; i < piece.size(); ++i) {
      const double area = doubled_area(piece[0], piece[i - 1], piece[i]);
      sum += area * (piece[0] + piece[i - 1] + piece[i]);
      doubled += area;
    }
  }
  return doubled > 0 ? sum / (3 * doubled) : pieces.front().front();
}

/// The triangles of a picture, row by row, by the pixels that each touches.
class PictureRow {
 public:
  PictureRow(std::span<const ScreenTriangle> triangles, const Window& window)
      : triangles_(triangles),
        ranges_(triangles),
        window_(window),
        columns_(static_cast<std::size_t>(window.width())) {
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const auto& corners = triangles[k].corners;
      const Window box = pixels_in(corners, window);
      if (!box.empty() && triangle_coverage::doubled_area(corners) != 0)
        coming_.push_back({box.lower.y, box.upper.y, static_cast<int>(k)});
    }
    std::ranges::sort(coming_, {}, [](const Rows& rows) { return std::pair(rows.first, rows.triangle); });
  }

  /// Rows are asked for one after the other, from the window's first one on.
  void go_to(int row) {
    row_ = row;
    for (auto& column : columns_) column.clear();
    while (next_ < coming_.size() && coming_[next_].first <= row) here_.push_back(coming_[next_++]);
    std::erase_if(here_, [row](const Rows& rows) { return rows.last < row; });
    for (const Rows& rows : here_) {
      const auto triangle = static_cast<std::size_t>(rows.triangle);
      cut(clockwise(triangles_[triangle].corners), top_of(row), half_);
      cut(half_, bottom_of(row), part_);
      const auto [first, last] = columns(part_, window_);
      for (int x = first; x <= last; ++x) column(x).push_back(rows.triangle);
    }
  }

  /// The fragments of a pixel of the row, without those that lie behind one that covers all of it.
  std::span<Fragment<double>> fragments(int x) {
    static const Outline<double> whole{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const ivec2 pixel{x, row_};
    fragments_.clear();
    double wall = std::numeric_limits<double>::infinity();
    for (const int k : column(x)) {
      const ScreenTriangle& triangle = triangles_[static_cast<std::size_t>(k)];
      const Edges edges = edges_of(triangle.corners);
      if (covers_whole(edges, pixel)) {
        Fragment<double> all{whole, plane_in<double>(triangle, edges, pixel), k};
        wall = std::min(wall, all.deepest());
        add(std::move(all), triangle);
      } else if (auto part = fragment_in<double>(triangle, pixel, k)) {
        add(std::move(*part), triangle);
      }
    }
    std::erase_if(fragments_, [wall](const auto& f) { return f.nearest() > wall; });
    return fragments_;
  }

 private:
  struct Rows {
    int first, last, triangle;
  };
  void add(Fragment<double> fragment, const ScreenTriangle& triangle) {
    if (triangle.plane)
      add_in_range(std::move(fragment), ranges_.of(*triangle.plane), fragments_);
    else
      fragments_.push_back(std::move(fragment));
  }
  std::vector<int>& column(int x) {
    return columns_[static_cast<std::size_t>(std::int64_t{x} - window_.lower.x)];
  }

  std::span<const ScreenTriangle> triangles_;
  SharedRanges ranges_;
  Window window_;
  std::vector<std::vector<int>> columns_;
  std::vector<Rows> coming_, here_;
  std::size_t next_ = 0;
  int row_ = 0;
  Polygon half_, part_;
  std::vector<Fragment<double>> fragments_;
};

/// Refuses what no grid of 1/256 pixel holds.
inline void expect_near(std::span<const ScreenTriangle> triangles, const Window& window) {
  for (const auto& t : triangles)
    expects(near_enough(t.corners), "a corner of the triangle lies more than {} pixels out", farthest);
  expects(near_enough(window), "the window reaches more than {} pixels out", farthest);
}

/// What is seen in a pixel, area times colour: each fragment's colour is asked for once.
template <class Colour>
struct Mean {
  using Value = std::remove_cvref_t<std::invoke_result_t<Colour&, int, ivec2, const Weights&>>;

  std::span<const ScreenTriangle> triangles;
  Colour& colour;
  ivec2 pixel;
  Value sum{};
  double covered = 0;

  void cuts(std::size_t pieces)
    requires requires { colour.cuts(pieces); }
  {
    colour.cuts(pieces);
  }
  void operator()(const Fragment<double>& f, const Pieces<double>& pieces, double area) {
    const Edges edges = edges_of(triangles[static_cast<std::size_t>(f.key)].corners);
    const dvec2 place = (dvec2(pixel) + centroid_of(pieces)) * double{subpixels};
    const Value share = area * colour(f.key, pixel, weights_near(edges, place));
    sum = sum + share;
    covered += area;
  }
};

/// A picture of triangles: each pixel is the sum of what is seen in it, weighted by exact visible areas.
/// E. Catmull, A hidden-surface algorithm with anti-aliasing, SIGGRAPH 1978, 6-11.
///
/// triangles: snapped corners and depths, smaller is nearer; all of them are drawn, whichever way round they
///   run. window: the pixels that are asked for. colour(int triangle, ivec2 pixel, const Weights& at) gives
///   the colour of what is seen of a triangle in a pixel, once for each, at the grid place nearest to its
///   centre of mass; if it has cuts(std::size_t), it is told of the work as in areas_front_to_back.
///   plot(ivec2 pixel, const Value& sum, double covered) is called for every pixel in which something is
///   seen, row by row: the sum of area times colour, and of areas; what is missing to 1 is the background's.
///
/// Domain: corners at most `farthest` pixels from 0, and so is the window; finite depths. Values have +,
///   are multiplied by double from the left, and Value{} is 0. Triangles without an area show nothing.
/// Accuracy: as visible_areas in double; a pixel of which one triangle is seen alone has area 1 exactly.
/// Cost: for each pixel those triangles that touch it, and what areas_front_to_back takes.
/// Errors: ContractViolation for corners or windows that lie too far out.
template <class Colour, class Plot>
  requires std::invocable<Colour&, int, ivec2, const Weights&>
void visible_areas(std::span<const ScreenTriangle> triangles, const Window& window, Colour&& colour,
                   Plot&& plot) {
  expect_near(triangles, window);
  if (window.empty()) return;
  PictureRow row(triangles, window);
  const auto [lower, upper] = window;
  for (int y = lower.y; y <= upper.y; ++y) {
    row.go_to(y);
    for (int x = lower.x; x <= upper.x; ++x) {
      // What lies in this pixel
      auto here = row.fragments(x);
      // What of it is seen, area by area
      Mean<Colour> mean{triangles, colour, {x, y}};
      areas_front_to_back(here, mean);
      if (mean.covered == 0) continue;
      plot(ivec2{x, y}, mean.sum, mean.covered);
    }
  }
}

}  // namespace gradus::area_sampling
