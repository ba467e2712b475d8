#include "engine/shown_batch.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/shown_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#include "engine/blocks-inl.hpp"
#include "engine/casts.hpp"
#include "engine/mask_bits-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The triangles that the samples of a pixel show: those that stand in `samples`, or the one that covers all.
/// pixel: of the picture. Returns whether there may be another one than that.
HWY_INLINE bool winners_of(TileTies& ties, const SampleBuffer& buffer, std::size_t cell, ivec2 pixel,
                           std::span<const ivec2> places, std::int32_t* winners) {
  const Whole whole;
  const Single single;
  const PixelSamples& own = buffer.samples[static_cast<std::size_t>(buffer.sampled[cell])];
  const std::int32_t other = buffer.whole[cell];
  const float from = buffer.least[cell] - unsure_at(buffer.least[cell]),
              to = buffer.most[cell] + unsure_at(buffer.most[cell]);
  bool others = false;
  for (std::size_t i = 0; i < most_samples; i += hn::Lanes(whole)) {
    const auto ids = hn::Load(whole, own.ids.data() + i);
    const auto nearness = hn::Load(single, own.nearness.data() + i);
    auto mine = hn::Gt(nearness, hn::Set(single, to));
    auto open = hn::AndNot(mine, hn::Ge(nearness, hn::Set(single, from)));
    if (other != no_triangle && HWY_UNLIKELY(!hn::AllFalse(single, open))) {
      const OrderedLanes lanes = order_lanes(ties, other, open, own.ids.data() + i, places_of(pixel, 1));
      mine = hn::Or(mine, hn::AndNot(lanes.before, hn::AndNot(lanes.open, open)));
      open = lanes.open;
    }
    hn::Store(hn::IfThenElse(hn::RebindMask(whole, mine), ids, hn::Set(whole, other)), whole, winners + i);
    others |= !hn::AllFalse(single, hn::Or(mine, open));
    if (other == no_triangle) continue;
    for_each_bit(bits_of(single, open), [&](int lane) {
      const std::size_t s = i + static_cast<std::size_t>(lane);
      const ivec2 there = pixel * triangle_coverage::subpixels + places[std::min(s, places.size() - 1)];
      if (own.ids[s] != no_triangle && ties.is_before(own.ids[s], other, there)) winners[s] = own.ids[s];
    });
  }
  return others;
}

/// The sides of a triangle as the samples of a tile's pixels ask for them.
class SampleSides {
 public:
  /// origin: the tile's upper left pixel.
  HWY_INLINE void set(std::int32_t id, const triangle_coverage::Triangle& grid, ivec2 origin) {
    id_ = id;
    has_offsets_ = false;
    edges_ = triangle_coverage::edges_of(grid);
    long_ = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const triangle_coverage::Edge& edge = edges_[k];
      const ivec2 way = edge.to - edge.from;
      sides_[k] = {edge.at(triangle_coverage::centre_of(origin)) - !edge.owns, edge.step(),
                   std::int64_t{way.x} * triangle_coverage::subpixels};
      long_ |= std::abs(way.x) + std::abs(way.y) >= 1 << 23;
    }
  }
  std::int32_t id() const { return id_; }

  /// Where the colour in a pixel, counted from the tile's, is asked for: adaptive::colour_place.
  HWY_INLINE ivec2 colour_place(ivec2 pixel, ivec2 origin, std::span<const ivec2> places,
                                const SampleOffsets& offsets) {
    std::array<std::int64_t, 3> in_middle;
    for (std::size_t k = 0; k < 3; ++k)
      in_middle[k] = sides_[k].at + sides_[k].a * pixel.x + sides_[k].b * pixel.y;
    if ((in_middle[0] | in_middle[1] | in_middle[2]) >= 0) return pixel_middle;
    if (long_) return colour_place_of_long(origin + pixel, places);
    // Many are never asked for more than pixels' middles
    if (!has_offsets_) set_offsets(offsets);
    const std::uint32_t outside = outside_of(in_middle);
    const auto first = static_cast<std::size_t>(std::countr_one(outside));
    return first < places.size() ? places[first] : pixel_middle;
  }

 private:
  HWY_INLINE void set_offsets(const SampleOffsets& offsets) {
    const Whole d;
    has_offsets_ = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const ivec2 way = edges_[k].to - edges_[k].from;
      for (std::size_t i = 0; i < most_samples; i += hn::Lanes(d)) {
        const I right = hn::Load(d, offsets.right + i), down = hn::Load(d, offsets.down + i);
        hn::Store(hn::Sub(hn::Mul(hn::Set(d, way.x), down), hn::Mul(hn::Set(d, way.y), right)), d,
                  offsets_[k] + i);
      }
    }
  }

  /// The bits of samples outside. in_middle: the sides in the pixel's middle.
  HWY_INLINE std::uint32_t outside_of(const std::array<std::int64_t, 3>& in_middle) const {
    const Whole d;
    // So far that 32 bits hold what samples add: the signs stay
    constexpr std::int64_t far = 1 << 30;
    std::uint32_t outside = 0;
    for (std::size_t i = 0; i < most_samples; i += hn::Lanes(d)) {
      const auto side = [&](std::size_t k) {
        const auto at = static_cast<std::int32_t>(std::clamp(in_middle[k], -far, far));
        return hn::Add(hn::Set(d, at), hn::Load(d, offsets_[k] + i));
      };
      // The sign of one is that of all
      outside |= bits_of(d, hn::Lt(hn::Or(hn::Or(side(0), side(1)), side(2)), hn::Zero(d))) << i;
    }
    return outside;
  }

  /// The same for triangles whose edge functions take more than 32 bits. pixel: of the picture.
  HWY_NOINLINE ivec2 colour_place_of_long(ivec2 pixel, std::span<const ivec2> places) const {
    const auto found = std::ranges::find_if(places, [&](ivec2 place) {
      return holds(edges_, weights_at_place(edges_, pixel * triangle_coverage::subpixels + place));
    });
    return found == places.end() ? pixel_middle : *found;
  }

  std::int32_t id_ = no_triangle;
  bool long_ = false, has_offsets_ = false;
  triangle_coverage::Edges edges_{};
  std::array<Side, 3> sides_{};                        ///< at least 0 inside; in the middle of a pixel
  alignas(64) std::int32_t offsets_[3][most_samples];  ///< what samples add
};

/// Lists what the pixels of a tile show.
class Shown {
 public:
  Shown(const Frame& frame, ivec2 origin, std::span<const ivec2> places, std::vector<ShownTriangle>& shown)
      : frame_(frame), origin_(origin), places_(places), offsets_(places), shown_(shown) {}

  /// Adds the triangles that the samples of a pixel show. winners: of them. whole: covers all of it, or none.
  HWY_INLINE void add(std::size_t cell, const std::int32_t* winners, std::int32_t whole) {
    const Whole d;
    for (std::uint32_t left = (1U << places_.size()) - 1; left != 0;) {
      const std::int32_t id = winners[std::countr_zero(left)];
      std::uint32_t same = 0;
      for (std::size_t i = 0; i < most_samples; i += hn::Lanes(d))
        same |= bits_of(d, hn::Eq(hn::Load(d, winners + i), hn::Set(d, id))) << i;
      same &= left;
      left &= ~same;
      if (id == no_triangle) continue;
      // Written where it stays: what is written elsewhere and copied waits for its own parts
      ShownTriangle& triangle = shown_.emplace_back();
      triangle.cell = cell;
      triangle.id = id;
      triangle.samples = std::popcount(same);
      triangle.place = id == whole
                           ? pixel_middle
                           : sides_of(id).colour_place(TileBuffer::place(cell), origin_, places_, offsets_);
    }
  }

 private:
  /// Pixels beside one another show the same triangles.
  HWY_INLINE SampleSides& sides_of(std::int32_t id) {
    SampleSides& sides = known_[static_cast<std::size_t>(id) % known_.size()];
    if (sides.id() != id) sides.set(id, frame_.triangle(id).grid, origin_);
    return sides;
  }

  const Frame& frame_;
  ivec2 origin_;
  std::span<const ivec2> places_;
  SampleOffsets offsets_;
  std::vector<ShownTriangle>& shown_;
  std::array<SampleSides, 16> known_;
};

void show_tile(const Frame& frame, const Window& pixels, std::span<const ivec2> places,
               const SampleBuffer& buffer, std::vector<ShownTriangle>& list) {
  Shown shown(frame, pixels.lower, places, list);
  TileTies ties(frame, pixels.lower);
  alignas(64) std::int32_t winners[most_samples];
  for (std::size_t i = 0; i < buffer.sampled_cells.size(); ++i) {
    const auto cell = static_cast<std::size_t>(buffer.sampled_cells[i]);
    if (buffer.whole[cell] == no_triangle) {
      shown.add(cell, buffer.samples[i].ids.data(), no_triangle);
      continue;
    }
    const ivec2 pixel = pixels.lower + TileBuffer::place(cell);
    if (winners_of(ties, buffer, cell, pixel, places, winners))
      shown.add(cell, winners, buffer.whole[cell]);
    else
      list.push_back({cell, buffer.whole[cell], static_cast<std::int32_t>(places.size()), pixel_middle});
  }
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::pipeline::engine {
HWY_EXPORT(show_tile);

void find_shown(const Frame& frame, const Window& pixels, std::span<const ivec2> places,
                const SampleBuffer& buffer, std::vector<ShownTriangle>& shown) {
  HWY_DYNAMIC_DISPATCH(show_tile)(frame, pixels, places, buffer, shown);
}

}  // namespace gradus::pipeline::engine
#endif
