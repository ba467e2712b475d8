#pragma once
// What adaptive antialiasing knows of its pixels: which are crossed, the samples of those, and the one
// triangle that all samples of any other show.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "antialiasing/adaptive/sample_places.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/raster.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"

namespace gradus::adaptive {

using triangle_coverage::Depth;
using triangle_coverage::Edge;
using triangle_coverage::Edges;
using triangle_coverage::ScreenTriangle;
using triangle_coverage::Weights;

/// The triangle that nothing shows.
inline constexpr int nobody = -1;

/// What a triangle does to the square of a pixel.
enum class Cover {
  outside,  ///< all of it lies beyond one edge
  crossed,  ///< an edge runs through it
  inside,   ///< it is covered whole
};

/// How a triangle that covers a pixel whole lies to the nearest one before it.
enum class Order {
  nearer,    ///< at every sample; also when it is the first
  behind,    ///< at every sample
  changing,  ///< nearer at some samples: the two pierce each other in the pixel
};

// --- What is kept ------------------------------------------------

/// A triangle that can be asked.
struct Prepared {
  Edges edges;
  Depth depth;
  Window box;  ///< the pixels of the window that its box touches
};

/// The pixels whose squares the box round a triangle touches.
constexpr Window touched(const triangle_coverage::Triangle& t, const Window& window) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  return intersection({{left >> 8, top >> 8}, {right >> 8, bottom >> 8}}, window);
}

/// The pixels of a window, row by row.
class PixelsOf {
 public:
  explicit constexpr PixelsOf(const Window& window) : window_(window) {}

  struct Place {
    ivec2 pixel;
    int left, right;
    constexpr ivec2 operator*() const { return pixel; }
    constexpr Place& operator++() {
      const bool ends = pixel.x == right;
      pixel = ends ? ivec2{left, pixel.y + 1} : ivec2{pixel.x + 1, pixel.y};
      return *this;
    }
    constexpr bool operator!=(const Place& other) const { return pixel.y != other.pixel.y; }
  };
  constexpr Place begin() const {
    const auto [lower, upper] = window_;
    return {{lower.x, window_.empty() ? upper.y + 1 : lower.y}, lower.x, upper.x};
  }
  constexpr Place end() const {
    const auto [lower, upper] = window_;
    return {{lower.x, upper.y + 1}, lower.x, upper.x};
  }

 private:
  Window window_;
};

/// A triangle without area touches nothing.
inline std::vector<Prepared> prepare(std::span<const ScreenTriangle> triangles, const Window& window) {
  std::vector<Prepared> all;
  all.reserve(triangles.size());
  for (const ScreenTriangle& triangle : triangles) {
    const auto& corners = triangle.corners;
    expects(triangle_coverage::near_enough(corners), "a corner of a triangle lies more than {} pixels out",
            triangle_coverage::farthest);
    const bool flat = triangle_coverage::doubled_area(corners) == 0;
    all.push_back(
        {triangle_coverage::edges_of(corners), Depth(triangle), flat ? Window{} : touched(corners, window)});
  }
  return all;
}

/// What a sample shows.
struct Sample {
  double depth = std::numeric_limits<double>::infinity();
  int triangle = nobody;
};

/// What is known of a pixel.
struct Pixel {
  int front = nobody;     ///< the nearest triangle that covers it whole, while it is not crossed
  bool crossed = false;   ///< takes all samples
  std::size_t first = 0;  ///< of its samples
};

/// Where a sample of a pixel lies in the picture.
constexpr ivec2 place_in(ivec2 pixel, ivec2 place) { return pixel * subpixels + place; }

/// Where a fragment is coloured: in the centre of the pixel if the triangle covers it, else at the covered
/// sample that is nearest to it, so that no colour comes from beyond an edge.
constexpr ivec2 colour_place(const Edges& edges, ivec2 pixel, std::span<const ivec2> places) {
  constexpr ivec2 centre{subpixels / 2, subpixels / 2};
  const auto covered = [&](ivec2 place) {
    return holds(edges, weights_at_place(edges, place_in(pixel, place)));
  };
  if (covered(centre)) return centre;
  ivec2 nearest = centre;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const ivec2 place : places) {
    const std::int64_t x = place.x - centre.x, y = place.y - centre.y, square = x * x + y * y;
    if (square >= least || !covered(place)) continue;
    nearest = place;
    least = square;
  }
  return nearest;
}

/// The triangles, the pixels of a window, and the samples of those that are crossed.
class Survey {
 public:
  Survey(std::span<const Prepared> triangles, const Window& window, std::span<const ivec2> places)
      : triangles_(triangles),
        window_(window),
        places_(places),
        pixels_(static_cast<int>(std::max<std::int64_t>(0, window.width())),
                static_cast<int>(std::max<std::int64_t>(0, window.height()))) {}

  std::span<const Prepared> triangles() const { return triangles_; }
  const Prepared& triangle(int i) const { return triangles_[static_cast<std::size_t>(i)]; }
  const Window& window() const { return window_; }
  std::span<const ivec2> places() const { return places_; }
  std::int64_t pixels() const { return std::ssize(pixels_.cells()); }
  int samples() const { return static_cast<int>(places_.size()); }
  Pixel& operator[](ivec2 p) { return pixels_[p - window_.lower]; }
  const Pixel& operator[](ivec2 p) const { return pixels_[p - window_.lower]; }

  void cross_all() {
    for (Pixel& pixel : pixels_.cells()) pixel.crossed = true;
  }
  /// Every crossed pixel gets its samples, all free.
  void make_samples() {
    std::size_t first = 0;
    for (Pixel& pixel : pixels_.cells()) {
      pixel.first = first;
      if (pixel.crossed) first += places_.size();
    }
    samples_.assign(first, {});
  }
  /// None for a pixel that is not crossed.
  std::span<Sample> samples(ivec2 p) {
    const Pixel& pixel = (*this)[p];
    return std::span(samples_).subspan(pixel.first, pixel.crossed ? places_.size() : 0);
  }
  std::span<const Sample> samples(ivec2 p) const {
    const Pixel& pixel = (*this)[p];
    return std::span(samples_).subspan(pixel.first, pixel.crossed ? places_.size() : 0);
  }
  /// The edge functions of a triangle at a place of a pixel, or at one of its samples.
  Weights weights_at(int i, ivec2 p, ivec2 place) const {
    return weights_at_place(triangle(i).edges, place_in(p, place));
  }
  Weights weights(int i, ivec2 p, int sample) const {
    return weights_at(i, p, places_[static_cast<std::size_t>(sample)]);
  }
  /// How deep a triangle is at a place of a pixel.
  double depth_at(int i, ivec2 p, ivec2 place) const {
    return triangle(i).depth.at(place_in(p, place), weights_at(i, p, place));
  }
  /// Where a fragment is coloured: in the centre of the pixel if the triangle covers it, else at the covered
  /// sample that is nearest to it, so that no colour comes from beyond an edge.
  ivec2 colour_place(int i, ivec2 p) const { return adaptive::colour_place(triangle(i).edges, p, places_); }
  /// Compares a triangle with the one before it at every sample. At equal depth the one before stays.
  Order order(int next, int before, ivec2 p) const {
    if (before == nobody) return Order::nearer;
    std::size_t nearer = 0;
    for (const ivec2 place : places_) {
      nearer += depth_at(next, p, place) < depth_at(before, p, place);
    }
    return nearer == 0 ? Order::behind : nearer == places_.size() ? Order::nearer : Order::changing;
  }
  /// The triangle that a sample shows.
  int shown(ivec2 p, int sample) const {
    const Pixel& pixel = (*this)[p];
    return pixel.crossed ? samples(p)[static_cast<std::size_t>(sample)].triangle : pixel.front;
  }
  ivec2 place(ivec2 p, int sample) const { return place_in(p, place(sample)); }
  ivec2 place(int sample) const { return places_[static_cast<std::size_t>(sample)]; }
  std::int64_t crossed() const { return std::ssize(samples_) / std::max(1, samples()); }

 private:
  std::span<const Prepared> triangles_;
  Window window_;
  std::span<const ivec2> places_;
  Raster<Pixel> pixels_;
  std::vector<Sample> samples_{};
};

// --- The decision ------------------------------------------------

/// The least and the greatest value of an edge function at the places of a pixel: at two of its corners.
struct Range {
  std::int64_t least, most;
};
constexpr Range range_over(const Edge& edge, ivec2 pixel) {
  const std::int64_t corner = edge.at(place_in(pixel, {0, 0}));
  const std::int64_t right = -(std::int64_t{edge.to.y} - edge.from.y) * (subpixels - 1);
  const std::int64_t down = (std::int64_t{edge.to.x} - edge.from.x) * (subpixels - 1);
  return {corner + std::min<std::int64_t>(right, 0) + std::min<std::int64_t>(down, 0),
          corner + std::max<std::int64_t>(right, 0) + std::max<std::int64_t>(down, 0)};
}

/// What a triangle does to a pixel. Whatever place its samples have, inside means that all are covered, and
/// outside that none is.
constexpr Cover cover_of(const Edges& edges, ivec2 pixel) {
  using triangle_coverage::belongs;
  bool crossed = false;
  for (const Edge& edge : edges) {
    const Range range = range_over(edge, pixel);
    // Not even its innermost corner?
    if (!belongs(edge, range.most)) return Cover::outside;
    crossed |= !belongs(edge, range.least);
  }
  return crossed ? Cover::crossed : Cover::inside;
}

}  // namespace gradus::adaptive
