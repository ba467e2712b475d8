#pragma once
// The A-buffer: a list of fragments per pixel, each with a mask of 32 bits, one for each of the pixel's
// sub-samples. With the list sorted front to back, one AND NOT removes from a fragment what nearer ones hide;
// the number of bits that remain is its weight.
//
// L. Carpenter, The A-buffer, an antialiased hidden surface method, SIGGRAPH 1984, 103-108.

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "antialiasing/a_buffer/depth_queues.hpp"
#include "antialiasing/a_buffer/fragment.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"

namespace gradus::a_buffer {

using triangle_coverage::Edge;
using triangle_coverage::Edges;
using triangle_coverage::edges_of;
using triangle_coverage::ScreenTriangle;
using triangle_coverage::subpixels;
using triangle_coverage::Weights;
using triangle_coverage::weights_at_place;

// --- Masks -------------------------------------------------------

/// Where a sub-sample lies on the grid of 1/256 pixel: in the middle of its cell.
constexpr ivec2 place_of(ivec2 pixel, int sample) {
  constexpr int across = subpixels / mask_columns, down = subpixels / mask_rows;
  const ivec2 cell{sample % mask_columns, sample / mask_columns};
  return {pixel.x * subpixels + cell.x * across + across / 2, pixel.y * subpixels + cell.y * down + down / 2};
}

/// An edge's mask is known, and what is left of the triangle's.
struct HalfPlane {
  Edge edge;
  Mask inside, left;
};

/// The sub-samples on the inner side of an edge, or on it where it owns what lies there.
/// Accuracy: exact. Cost: 32 additions where the edge crosses the pixel, else two comparisons.
constexpr Mask half_plane(const Edge& edge, ivec2 pixel) {
  const std::int64_t right = edge.step() / mask_columns;
  const std::int64_t down = std::int64_t{edge.to.x - edge.from.x} * (subpixels / mask_rows);
  // Below 0 is outside; an edge that owns nothing has its 0 there, too
  const auto first = edge.at(place_of(pixel, 0)) - !edge.owns;
  const auto aside = (mask_columns - 1) * right, below = (mask_rows - 1) * down;
  if (first + std::min<std::int64_t>(aside, 0) + std::min<std::int64_t>(below, 0) >= 0) return full;
  if (first + std::max<std::int64_t>(aside, 0) + std::max<std::int64_t>(below, 0) < 0) return 0;
  Mask mask = 0;
  for (int row = 0; row < mask_rows; ++row) {
    for (int column = 0; column < mask_columns; ++column)
      mask = mask << 1 | Mask{first + row * down + column * right >= 0};
  }
  return mask;
}

/// The sub-samples of a pixel that a triangle covers: those on the inner side of all three edges, by the
/// top-left rule.
///
/// edges: by edges_of. p: any pixel of which the triangle's box has a part, or another.
///
/// Domain: corners and pixel at most `triangle_coverage::farthest` pixels from 0. A triangle without area
///   covers nothing.
/// Steps: HalfPlane once for each edge.
/// Accuracy: exact. Triangles that share an edge, on either side of it, have disjoint masks.
/// Cost: three half-planes, two ands.
/// Errors: none.
template <Observer<HalfPlane> O = Unobserved>
constexpr Mask mask_of(const Edges& edges, ivec2 p, O&& observer = {}) {
  Mask mask = full;
  for (const Edge& edge : edges) {
    // Keep what lies inside it
    auto in = half_plane(edge, p);
    mask &= in;
    if constexpr (observed<O>) observer(HalfPlane{edge, in, mask});
  }
  return mask;
}

/// The same of a polygon, which may be concave or cross itself: what it winds round an odd number of times.
///
/// ring: its corners on the grid of 1/256 pixel, in either direction.
///
/// Domain: as for a triangle; fewer than three corners cover nothing.
/// Accuracy: exact. Polygons that share an edge have disjoint masks.
/// Cost: a triangle's mask for each corner but two.
/// Errors: none.
constexpr Mask mask_of(std::span<const ivec2> ring, ivec2 pixel) {
  Mask mask = 0;
  for (std::size_t i = 2; i < ring.size(); ++i)
    mask ^= mask_of(edges_of({ring[0], ring[i - 1], ring[i]}), pixel);
  return mask;
}

/// The share of the pixel that a mask stands for. Accuracy: exact.
constexpr double area_of(Mask mask) { return std::popcount(mask) / double{samples}; }

// --- Fragments ---------------------------------------------------

/// Front to back; of equal depths the lower number first.
constexpr bool nearer(const Fragment& a, const Fragment& b) {
  return std::tie(a.z_near, a.z_far, a.surface, a.source) < std::tie(b.z_near, b.z_far, b.surface, b.source);
}

/// A mask and the sub-samples beside, above and below its own.
constexpr Mask grown(Mask mask) {
  constexpr Mask first_column = 0x80808080, last_column = 0x01010101;
  return mask | (mask & ~first_column) << 1 | (mask & ~last_column) >> 1 | mask << mask_columns |
         mask >> mask_columns;
}

/// Whether two fragments are parts of one: of one surface, side by side.
constexpr bool are_one(const Fragment& a, const Fragment& b) {
  return a.surface == b.surface && a.opacity == b.opacity && (a.mask & b.mask) == 0 &&
         (grown(a.mask) & b.mask) != 0;
}

/// Both as one: the union of the masks, whose areas add up, and of the depths. It is the larger one's.
constexpr Fragment united(const Fragment& a, const Fragment& b) {
  Fragment both = std::popcount(a.mask) >= std::popcount(b.mask) ? a : b;
  both.mask = a.mask | b.mask;
  both.z_near = std::min(a.z_near, b.z_near);
  both.z_far = std::max(a.z_far, b.z_far);
  return both;
}

/// Makes one of what abuts on the same surface. Only neighbours in the sorted list are merged: nothing lies
/// between them, so that each sub-sample still meets the same surfaces in the same order.
constexpr void merge(std::vector<Fragment>& sorted) {
  std::size_t kept = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (are_one(sorted[kept], sorted[i])) {
      sorted[kept] = united(sorted[kept], sorted[i]);
    } else {
      sorted[++kept] = sorted[i];
    }
  }
  if (!sorted.empty()) sorted.resize(kept + 1);
}

// --- Steps -------------------------------------------------------

/// The list is sorted by nearest depths.
struct Sorted {
  std::vector<Fragment> list;
};
/// Where depths overlap, sub-samples have been compared: the list goes front to back at each of them.
struct Ordered {
  std::vector<Fragment> list;
  std::size_t parts;  ///< by how many it has grown, where surfaces cross
};
/// What abuts on one surface has become one.
struct Merged {
  std::vector<Fragment> list;
};
/// A fragment was compared with what is covered.
struct Masked {
  std::size_t number;
  Fragment fragment;
  Mask covered, visible;
};
/// It has got its share.
struct Weighed {
  std::size_t number;
  Fragment fragment;
  Mask visible;
  double weight;
  Mask covered;
  double left;  ///< for what is behind
};
/// The pixel is full, or the list at its end.
struct Finished {
  std::size_t used, listed;  ///< fragments
  double left;               ///< for the background
};

// --- Their order -------------------------------------------------

/// The depths of a fragment where nothing is known but how deep it reaches: where it begins says all.
struct ByRange {
  constexpr auto operator()(const Fragment& f) const {
    return [range = std::pair(f.z_near, f.z_far)](int) { return range; };
  }
};

/// How many of a sorted list overlap in depth with its first or with one that does.
constexpr std::size_t overlapping(std::span<const Fragment> sorted) {
  std::size_t count = 1;
  for (double far = sorted[0].z_far; count < sorted.size() && sorted[count].z_near <= far; ++count)
    far = std::max(far, sorted[count].z_far);
  return count;
}

/// Appends the first n of what is left to a list, front to back at every sub-sample.
template <class Depths>
constexpr void append(std::vector<Fragment>& list, std::span<const Fragment> rest, std::size_t n,
                      Depths& depths) {
  const std::span<const Fragment> here = rest.first(n);
  if (shared(here) == 0) {
    list.insert(list.end(), here.begin(), here.end());
    return;
  }
  Queues queues(here, depths);
  while (!queues.empty()) list.push_back(queues.taken());
}

/// Brings a list sorted by nearest depths into one that goes front to back at every sub-sample. Surfaces that
/// cross in the pixel have no such order: of these a fragment is parted where they do, the nearer part first.
/// Steps: Ordered. Cost: 32 times that of sorting, and as much a part.
template <class Depths, Observer<Ordered> O = Unobserved>
constexpr void put_in_order(std::vector<Fragment>& list, Depths& depths, O&& observer = {}) {
  std::vector<Fragment> given;
  given.swap(list);
  std::span rest(given);
  while (!rest.empty()) {
    // As many as overlap in depth
    auto n = overlapping(rest);
    append(list, rest, n, depths);
    rest = rest.subspan(n);
  }
  if constexpr (observed<O>) observer(Ordered{list, list.size() - given.size()});
}

// --- Light -------------------------------------------------------

/// What of each sub-sample is still seen from the eye: parts of the pixel that all fragments so far have
/// treated alike. A fragment cuts each part in two, inside and outside its mask: the recursion of the
/// source, taken front to back.
class Light {
 public:
  /// The sub-samples behind which nothing is seen.
  constexpr Mask covered() const { return covered_; }
  /// The share of the pixel that is still seen, from 1 down to 0. Accuracy: exact for opaque fragments.
  constexpr double left() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += parts_[i].seen * area_of(parts_[i].mask);
    return sum;
  }
  /// What a fragment takes of it: the share of the pixel that is seen in its colour. mask: where it is seen.
  constexpr double take(Mask mask, double opacity) {
    double w = 0;
    for (Part& part : parts()) {
      // The fragment cuts it in two
      auto in = part.mask & mask;
      auto out = part.mask & ~mask;
      if (in == 0) continue;
      const auto s = part.seen;
      if (out != 0) add(out, s);
      w += s * opacity * area_of(in);
      part = {in, s * (1 - opacity)};
    }
    if (opacity == 1) cover(mask);
    return w;
  }
  constexpr double take(Mask mask, const Fragment& f) { return take(mask, f.opacity); }

 private:
  struct Part {
    Mask mask;
    double seen;
  };
  constexpr std::span<Part> parts() { return {parts_.data(), count_}; }
  constexpr void add(Mask mask, double seen) { parts_[count_++] = {mask, seen}; }
  constexpr void cover(Mask mask) {
    covered_ |= mask;
    const auto gone = [&](const Part& part) { return (part.mask & ~covered_) == 0; };
    const auto end = parts_.begin() + static_cast<std::ptrdiff_t>(count_);
    count_ = static_cast<std::size_t>(std::remove_if(parts_.begin(), end, gone) - parts_.begin());
  }

  std::array<Part, samples> parts_{{{full, 1}}};  // disjoint, and so never more
  std::size_t count_ = 1;
  Mask covered_ = 0;
};

// --- The taught method -------------------------------------------

constexpr bool is_share(double x) { return 0 <= x && x <= 1; }

/// Where a fragment stands in its list.
constexpr std::size_t index(std::span<const Fragment> list, const Fragment& f) {
  return static_cast<std::size_t>(&f - list.data());
}
/// How many fragments, front to back, it takes until the pixel is full: all where they never fill it.
/// hides(fragment): the sub-samples at which it lets nothing through.
constexpr std::size_t used_of(std::span<const Fragment> list, const auto& hides) {
  Mask covered = 0;
  std::size_t used = 0;
  while (used < list.size() && covered != full) covered |= hides(list[used++]);
  return used;
}
constexpr Mask opaque_part(const Fragment& f) { return f.opacity == 1 ? f.mask : 0; }

/// Gives each fragment of a pixel the share of it that it is seen in, front to back, and stops when the pixel
/// is full. Carpenter 1984, p. 106; where depths overlap he estimates, from the nearest and the farthest,
/// which share of the front one is seen (see by_ranges). Here each sub-sample says who is in front.
///
/// list: the pixel's fragments in any order; in order and merged afterwards. take(Fragment, double weight) is
///   called for each that is seen, front to back. depths(Fragment) gives what depth(int sample) gives the
///   fragment's depth, between its nearest and its farthest; it is asked where these overlap others. Of equal
///   depths the lower surface, then the lower source is in front.
///
/// Domain: masks not 0 or 0, which are not seen; opacities from 0 to 1; z_near <= z_far, finite.
/// Steps: Sorted Ordered Merged (Masked Weighed)* Finished.
/// Accuracy: weights of opaque fragments are popcount/32, exactly, by the order of each sub-sample; weights
///   and what is left add up to 1 within 1e-13, exactly where all are opaque.
/// Cost: sorting, then an "and not" and a popcount for each fragment; of those that overlap in depth 32 lists
///   are sorted, one per sub-sample: n log n for n fragments, however they cross. At most 32 parts with
///   opacity. Memory for parts, and some 600 bytes per fragment that overlaps others.
/// Errors: ContractViolation for opacities outside the domain.
///
/// Returns the share that is covered; the rest shows the background.
template <std::invocable<const Fragment&, double> Take, class Depths = ByRange,
          Observer<Sorted, Ordered, Merged, Masked, Weighed, Finished> O = Unobserved>
constexpr double resolve(std::vector<Fragment>& list, Take&& take, Depths&& depths = {}, O&& observer = {}) {
  // By nearest depths
  std::ranges::sort(list, nearer);
  if constexpr (observed<O>) observer(Sorted{list});
  // Front to back at each sample
  put_in_order(list, depths, observer);
  // What abuts on a surface is one
  merge(list);
  if constexpr (observed<O>) observer(Merged{list});
  Light light;
  for (const Fragment& f : list) {
    // Full: nothing behind is seen
    auto covered = light.covered();
    if (covered == full) break;
    expects(is_share(f.opacity), "an opacity lies between 0 and 1, got {}", f.opacity);
    // What nothing nearer hides
    auto seen = f.mask & ~covered;
    if constexpr (observed<O>) observer(Masked{index(list, f), f, covered, seen});
    // Its share of the light left
    auto w = light.take(seen, f);
    if constexpr (observed<O>) observer(Weighed{index(list, f), f, seen, w, light.covered(), light.left()});
    if (w > 0) take(f, w);
  }
  // The background has the rest
  const double left = light.left();
  if constexpr (observed<O>) observer(Finished{used_of(list, opaque_part), list.size(), left});
  return 1 - left;
}

}  // namespace gradus::a_buffer
