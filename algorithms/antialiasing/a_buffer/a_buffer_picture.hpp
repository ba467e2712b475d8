#pragma once
// Whole pictures of triangles by an A-buffer: the lists of all pixels, and what they take. a_buffer.hpp has
// what happens in one of them.

#include <array>
#include <cmath>
#include <limits>

#include "antialiasing/a_buffer/a_buffer.hpp"
#include "core/pixels.hpp"

namespace gradus::a_buffer {

/// What the lists of a picture take.
struct Memory {
  std::int64_t pixels = 0;      ///< with a list that is not empty
  std::int64_t fragments = 0;   ///< in all lists
  std::int64_t longest = 0;     ///< fragments in the longest list
  std::int64_t mask_bytes = 0;  ///< of the fragments' masks alone
  std::int64_t bytes = 0;       ///< of the lists, and of where each begins

  friend constexpr bool operator==(const Memory&, const Memory&) = default;
};

/// The lists of a picture's pixels: links in one store, the last one first.
class Lists {
 public:
  explicit Lists(const Window& window)
      : window_(window.empty() ? Window{} : window),
        first_(static_cast<std::size_t>(window_.width() * window_.height()), none) {}

  const Window& window() const { return window_; }
  void add(ivec2 pixel, const Fragment& fragment) {
    auto& first = first_[index(pixel)];
    links_.push_back({fragment, first});
    first = static_cast<std::int32_t>(links_.size() - 1);
  }
  /// A copy of a pixel's list, in no order, until the next one is asked for.
  std::vector<Fragment>& at(ivec2 pixel) {
    list_.clear();
    for (auto i = first_[index(pixel)]; i != none; i = links_[static_cast<std::size_t>(i)].next)
      list_.push_back(links_[static_cast<std::size_t>(i)].fragment);
    longest_ = std::max(longest_, std::ssize(list_));
    return list_;
  }
  /// What they take. The longest list is one of those asked for.
  Memory memory() const {
    const std::int64_t held = std::ssize(links_);
    return {.pixels = std::ssize(first_) - std::ranges::count(first_, none),
            .fragments = held,
            .longest = longest_,
            .mask_bytes = held * std::int64_t{sizeof(Mask)},
            .bytes = held * std::int64_t{sizeof(Link)} + std::ssize(first_) * std::int64_t{sizeof(none)}};
  }

 private:
  static constexpr std::int32_t none = -1;
  struct Link {
    Fragment fragment;
    std::int32_t next;
  };
  std::size_t index(ivec2 pixel) const {
    return static_cast<std::size_t>((pixel.y - window_.lower.y) * window_.width() + pixel.x -
                                    window_.lower.x);
  }

  Window window_;
  std::vector<std::int32_t> first_;
  std::vector<Link> links_{};
  std::vector<Fragment> list_{};
  std::ptrdiff_t longest_ = 0;
};

/// The pixels of the window into which the box round a triangle reaches.
constexpr Window reached(const triangle_coverage::Triangle& t, const Window& window) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  return intersection({{left >> 8, top >> 8}, {right >> 8, bottom >> 8}}, window);
}

/// The depth of a triangle at places of the picture.
class Depth {
 public:
  explicit constexpr Depth(const ScreenTriangle& triangle)
      : edges_(edges_of(triangle.corners)), depth_(triangle) {}
  constexpr double at(ivec2 place) const { return depth_.at(place, weights_at_place(edges_, place)); }

 private:
  Edges edges_;
  triangle_coverage::Depth depth_;
};

/// The least and the greatest depth over a mask's sub-samples. Of a whole pixel those at its corners, and as
/// much beyond them as rounding can take others.
inline std::pair<double, double> depths_of(Mask mask, ivec2 pixel, const Depth& depth) {
  constexpr Mask corners = 0x81000081;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (Mask asked = mask == full ? corners : mask; asked != 0; asked &= asked - 1) {
    const double z = depth.at(place_of(pixel, last_of(asked)));
    least = std::min(least, z);
    most = std::max(most, z);
  }
  if (mask != full || least == most) return {least, most};
  const double rounding = 0x1p-44 * std::max({std::abs(least), std::abs(most), most - least});
  return {least - rounding, most + rounding};
}

/// Where the colour of a triangle is asked in a pixel: at the centre, or, if it doesn't cover that, at the
/// sub-sample of its mask that lies nearest, of several the first in reading order. mask: its own, not 0.
constexpr ivec2 shading_place(const Edges& edges, Mask mask, ivec2 pixel) {
  const ivec2 centre = triangle_coverage::centre_of(pixel);
  if (holds(edges, weights_at_place(edges, centre))) return centre;
  ivec2 best{};
  int least = subpixels * subpixels;
  for (int i = 0; i < samples; ++i) {
    const ivec2 place = place_of(pixel, i), way = place - centre;
    const int far = way.x * way.x + way.y * way.y;
    if ((mask & bit_of(i)) == 0 || far >= least) continue;
    best = place;
    least = far;
  }
  return best;
}

/// The triangle that a fragment is of.
constexpr const ScreenTriangle& source_of(const Fragment& f, std::span<const ScreenTriangle> triangles) {
  return triangles[static_cast<std::size_t>(f.source)];
}

/// The weights of a fragment's corners there.
constexpr Weights weigh(std::span<const ScreenTriangle> scene, const Fragment& f, ivec2 pixel) {
  const Edges edges = edges_of(source_of(f, scene).corners);
  return weights_at_place(edges, shading_place(edges, mask_of(edges, pixel), pixel));
}

/// Adds a triangle's fragments to the lists of the pixels that it reaches. like: what all of them have.
inline void list_fragments(Lists& lists, const ScreenTriangle& triangle, const Window& window,
                           const Fragment& like) {
  using triangle_coverage::near_enough;
  expects(near_enough(triangle.corners) && near_enough(window), "more than {} pixels out",
          triangle_coverage::farthest);
  if (triangle_coverage::doubled_area(triangle.corners) == 0) return;
  const Edges edges = edges_of(triangle.corners);
  const Depth depth(triangle);
  const auto [lower, upper] = reached(triangle.corners, window);
  for (int y = lower.y; y <= upper.y; ++y) {
    for (int x = lower.x; x <= upper.x; ++x) {
      Fragment fragment = like;
      fragment.mask = mask_of(edges, {x, y});
      if (fragment.mask == 0) continue;
      std::tie(fragment.z_near, fragment.z_far) = depths_of(fragment.mask, {x, y}, depth);
      lists.add({x, y}, fragment);
    }
  }
}

/// Every triangle is a surface of its own: nothing is merged.
struct OwnSurface {
  constexpr int operator()(int triangle) const { return triangle; }
};
/// No triangle lets light through.
struct Opaque {
  constexpr double operator()(int) const { return 1; }
};

/// Leaves out of a pixel's list what is behind something that lets nothing through at each of its
/// sub-samples: in front of it nothing changes, and the rest is to be put in order sooner. Cost: 32
/// comparisons per fragment.
constexpr void leave_out_hidden(std::vector<Fragment>& list) {
  std::array<double, samples> opaque_by;  // at the latest
  opaque_by.fill(std::numeric_limits<double>::infinity());
  for (const Fragment& f : list) {
    if (f.opacity != 1) continue;
    for (Mask rest = f.mask; rest != 0; rest &= rest - 1) {
      double& depth = opaque_by[static_cast<std::size_t>(last_of(rest))];
      depth = std::min(depth, f.z_far);
    }
  }
  std::erase_if(list, [&](const Fragment& f) {
    for (Mask rest = f.mask; rest != 0; rest &= rest - 1)
      if (!(opaque_by[static_cast<std::size_t>(last_of(rest))] < f.z_near)) return false;
    return is_share(f.opacity);
  });
}

/// What a callable for colours gives.
template <class Colour>
using ValueOf = std::remove_cvref_t<std::invoke_result_t<Colour&, int, ivec2, const Weights&>>;

/// The depths of a pixel's fragments at its sub-samples: those of the triangles that they are of.
struct DepthsIn {
  std::span<const ScreenTriangle> triangles;
  ivec2 pixel;

  constexpr auto operator()(const Fragment& f) const {
    return [depth = Depth(triangles[static_cast<std::size_t>(f.source)]), p = pixel](int s) {
      return depth.at(place_of(p, s));
    };
  }
};

/// Adds the fragments of all triangles.
void add(Lists& lists, std::span<const ScreenTriangle> scene, auto& surface, auto& opacity) {
  for (int t = 0; t < std::ssize(scene); ++t) {
    const Fragment like{.opacity = opacity(t), .surface = surface(t), .source = t};
    list_fragments(lists, scene[static_cast<std::size_t>(t)], lists.window(), like);
  }
}

/// Draws triangles with an A-buffer: a list of fragments for each pixel, then each list front to back.
/// Carpenter 1984.
///
/// triangles: in the picture, in any order; smaller depths are nearer, linear in the picture. window: the
///   pixels that are asked for. colour(int triangle, ivec2 pixel, Weights) gives a value that can be added
///   and multiplied by a double, at the centre of the pixel or, where the triangle doesn't cover that, at the
///   covered sub-sample nearest to it; asked once for each fragment that is seen, front to back.
///   plot(ivec2, Value sum, double covered) is called for each pixel with a list, row by row: sum is that of
///   weight times colour, and 1 - covered is the background's. surface(int triangle): triangles of one number
///   are merged in a pixel where they abut, and the larger one's colour counts for both. opacity(int
///   triangle) lies between 0 and 1.
///
/// Domain: corners and window at most `triangle_coverage::farthest` pixels from 0; fewer than 2^31 fragments.
/// Accuracy: masks exactly; a straight edge's area within 0.0202 of a pixel (root mean square), that of the
///   line in which two triangles cross likewise. Which triangle a sub-sample shows: the one whose depth there
///   is least, of equals the one with the lower surface number.
/// Cost: a mask for each triangle and pixel of its box, then sorting what may be seen of each list;
///   depths at common sub-samples where ranges of depth overlap.
///   The memory is returned.
/// Errors: ContractViolation for what lies too far out, for opacities not between 0 and 1.
template <class Colour, class Plot, class Surface = OwnSurface, class Opacity = Opaque>
Memory a_buffer(std::span<const ScreenTriangle> scene, const Window& window, Colour&& colour, Plot&& plot,
                Surface&& surface = {}, Opacity&& alpha = {}) {
  Lists lists(window);
  // To each pixel what reaches it
  add(lists, scene, surface, alpha);
  for (ivec2 p : pixels(window)) {
    auto& list = lists.at(p);
    if (list.empty()) continue;
    leave_out_hidden(list);
    // Those seen, by their weights
    ValueOf<Colour> sum{};
    auto add = [&](auto f, auto w) {
      auto at = weigh(scene, f, p);
      const int t = f.source;
      sum += w * colour(t, p, at);
    };
    // Front to back
    DepthsIn z{scene, p};
    auto a = resolve(list, add, z);
    plot(p, sum, a);
  }
  return lists.memory();
}

}  // namespace gradus::a_buffer
