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
#include "core/pixels.hpp"
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
  int id;  ///< its number among all
  Edges edges;
  Depth depth;
  Window box;  ///< the pixels of the window that its box touches

  /// How deep it is at a place of the picture, where its edge functions have the values w.
  constexpr double z(ivec2 at, const Weights& w) const { return depth.at(at, w); }
  constexpr double z(ivec2 at) const { return z(at, weights_at_place(edges, at)); }
};
/// Its edge functions at a place of the picture.
constexpr Weights weights(const Prepared& t, ivec2 at) { return weights_at_place(t.edges, at); }
/// Whether it covers the place at which its edge functions have these values.
constexpr bool holds(const Prepared& t, const Weights& w) { return holds(t.edges, w); }

/// The pixels whose squares the box round a triangle touches.
constexpr Window touched(const triangle_coverage::Triangle& t, const Window& window) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  return intersection({{left >> 8, top >> 8}, {right >> 8, bottom >> 8}}, window);
}

/// The pixels that the box round a triangle touches.
constexpr Pixels pixels(const Prepared& t) { return Pixels(t.box); }
using gradus::pixels;

/// A triangle without area touches nothing.
inline std::vector<Prepared> prepare(std::span<const ScreenTriangle> triangles, const Window& window) {
  std::vector<Prepared> all;
  all.reserve(triangles.size());
  for (const ScreenTriangle& triangle : triangles) {
    const auto& corners = triangle.corners;
    expects(triangle_coverage::near_enough(corners), "a corner of a triangle lies more than {} pixels out",
            triangle_coverage::farthest);
    const bool flat = triangle_coverage::doubled_area(corners) == 0;
    all.push_back({static_cast<int>(all.size()), triangle_coverage::edges_of(corners), Depth(triangle),
                   flat ? Window{} : touched(corners, window)});
  }
  return all;
}

/// What a sample shows.
struct Sample {
  double z = std::numeric_limits<double>::infinity();
  int triangle = nobody;
};

/// What is known of a pixel.
struct Pixel {
  int front = nobody;     ///< the nearest triangle that covers it whole, while it is not crossed
  bool crossed = false;   ///< takes all samples
  bool refined = false;   ///< takes a colour per sample
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
  Survey(std::span<const ScreenTriangle> triangles, const Window& window, std::span<const ivec2> places)
      : triangles_(prepare(triangles, window)),
        window_(window),
        places_(places),
        pixels_(static_cast<int>(std::max<std::int64_t>(0, window.width())),
                static_cast<int>(std::max<std::int64_t>(0, window.height()))) {}

  std::span<const Prepared> triangles() const { return triangles_; }
  const Prepared& triangle(int i) const { return triangles_[static_cast<std::size_t>(i)]; }
  const Window& window() const { return window_; }
  std::span<const ivec2> places() const { return places_; }
  std::int64_t pixels() const { return std::ssize(pixels_.cells()); }
  /// How many a crossed pixel takes.
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
  /// The samples of a pixel: none where it is not crossed.
  std::span<Sample> at(ivec2 p) {
    const Pixel& pixel = (*this)[p];
    return std::span(samples_).subspan(pixel.first, pixel.crossed ? places_.size() : 0);
  }
  std::span<const Sample> at(ivec2 p) const {
    const Pixel& pixel = (*this)[p];
    return std::span(samples_).subspan(pixel.first, pixel.crossed ? places_.size() : 0);
  }
  /// Which of its pixel's samples this is.
  int number(ivec2 p, const Sample& sample) const { return static_cast<int>(&sample - at(p).data()); }
  /// Where it lies in the picture.
  ivec2 place(ivec2 p, const Sample& sample) const { return place_in(p, place(number(p, sample))); }
  /// Where a sample lies in its pixel.
  ivec2 place(int sample) const { return places_[static_cast<std::size_t>(sample)]; }

  /// The edge functions of a triangle at a place of a pixel.
  Weights weights(int i, ivec2 p, ivec2 place) const {
    return adaptive::weights(triangle(i), place_in(p, place));
  }
  /// Where a fragment is coloured: in the centre of the pixel if the triangle covers it, else at the covered
  /// sample that is nearest to it, so that no colour comes from beyond an edge.
  ivec2 colour_at(int i, ivec2 p) const { return adaptive::colour_place(triangle(i).edges, p, places_); }
  /// The triangle that a sample shows.
  int shown(ivec2 p, int sample) const {
    const Pixel& pixel = (*this)[p];
    return pixel.crossed ? at(p)[static_cast<std::size_t>(sample)].triangle : pixel.front;
  }

  std::int64_t crossed() const { return std::ssize(samples_) / std::max(1, samples()); }
  /// How often a triangle is tested at a sample.
  std::int64_t tests() const {
    std::int64_t all = 0;
    for (const Prepared& t : triangles_) {
      for (const ivec2 p : adaptive::pixels(t)) all += std::ssize(at(p));
    }
    return all;
  }

 private:
  std::vector<Prepared> triangles_;
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

/// What a triangle does to a pixel: inside means that it covers every place in it, outside that it covers
/// none.
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
constexpr Cover cover_of(const Prepared& t, ivec2 pixel) { return cover_of(t.edges, pixel); }

}  // namespace gradus::adaptive
