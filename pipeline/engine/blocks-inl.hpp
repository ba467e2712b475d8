// Rows of blocks of a tile beside the sides of a triangle: which of them it may touch, and which it covers
// whole. Compiled once for every kind of machine, as shading_lanes-inl.hpp is.
#if defined(GRADUS_ENGINE_BLOCKS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRADUS_ENGINE_BLOCKS_INL_HPP
#undef GRADUS_ENGINE_BLOCKS_INL_HPP
#else
#define GRADUS_ENGINE_BLOCKS_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "engine/casts.hpp"
#include "engine/mask_bits-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

static_assert(blocks_across == block_cells);
using Whole = hn::CappedTag<std::int32_t, block_cells>;
using Single = hn::RebindToFloat<Whole>;
using I = hn::Vec<Whole>;
using F = hn::Vec<Single>;

/// Where the cells of a block lie in it.
alignas(64) inline constexpr std::int32_t cell_columns[block_cells] = {0, 1, 2, 3, 0, 1, 2, 3,
                                                                       0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) inline constexpr std::int32_t cell_rows[block_cells] = {0, 0, 0, 0, 1, 1, 1, 1,
                                                                    2, 2, 2, 2, 3, 3, 3, 3};
/// The first columns of the blocks of a row.
alignas(64) inline constexpr std::int32_t block_columns[blocks_across] = {0,  4,  8,  12, 16, 20, 24, 28,
                                                                          32, 36, 40, 44, 48, 52, 56, 60};

/// Boxes of so many pixels between two looks at what is farthest.
constexpr int look_after = 256;

/// By how much depths may differ without being surely different.
HWY_INLINE F unsure(F nearness) {
  const Single d;
  return hn::Add(hn::Mul(nearness, hn::Set(d, unsure_share)), hn::Set(d, unsure_at_least));
}

/// Lanes in which a triangle comes before the one that is shown there, and those where that is open.
struct OrderedLanes {
  hn::Mask<Single> before, open;
};
/// open: lanes where single precision does not tell. ids: what the lanes show. places: those of all lanes.
HWY_INLINE OrderedLanes order_lanes(TileTies& ties, std::int32_t id, hn::Mask<Single> open,
                                    const std::int32_t* ids, const Places& places) {
  const Whole whole;
  const Single single;
  const I shown = hn::Load(whole, ids);
  OrderedLanes lanes{hn::AndNot(open, open), open};
  auto left = hn::And(open, hn::RebindMask(single, hn::Ne(shown, hn::Set(whole, no_triangle))));
  while (!hn::AllFalse(single, left)) {
    const std::int32_t other = ids[hn::FindKnownFirstTrue(single, left)];
    const auto same = hn::RebindMask(single, hn::Eq(shown, hn::Set(whole, other)));
    left = hn::AndNot(same, left);
    const TileTies::Order order = ties.order(id, other, places);
    if (order == TileTies::Order::open) continue;
    if (order == TileTies::Order::before) lanes.before = hn::Or(lanes.before, hn::And(same, open));
    lanes.open = hn::AndNot(same, lanes.open);
  }
  return lanes;
}

/// The places of some pixels. first: of the picture.
inline Places places_of(ivec2 first, int pixels) {
  return {first * triangle_coverage::subpixels, pixels * triangle_coverage::subpixels};
}

/// Blocks of a row, one bit each.
struct BlockRow {
  std::uint32_t touched, full;  ///< the triangle may ask for some of their pixels; it covers all of them
};

/// The blocks that the sides of a cast let through.
class BlockRows {
 public:
  /// reach: by how much a side changes from a pixel's centre to what is asked of the pixel.
  HWY_INLINE BlockRows(const Cast& cast, const std::array<std::int64_t, 3>& reach)
      : first_(cast.box.lower.x / block_side), last_(cast.box.upper.x / block_side) {
    for (std::size_t k = 0; k < 3; ++k) bounds_[k] = bounds_of(cast.sides[k], reach[k]);
  }

  HWY_INLINE BlockRow row(int y) const {
    const Whole d;
    BlockRow row{0, 0};
    for (int i = 0; i < blocks_across; i += static_cast<int>(hn::Lanes(d))) {
      const auto x = hn::Load(d, block_columns + i);
      I most = hn::Zero(d), least = hn::Zero(d);
      for (const Bounds& side : bounds_) {
        const auto at =
            hn::Add(hn::Set(d, side.at + block_side * y * side.b), hn::Mul(hn::Set(d, side.a), x));
        most = hn::Or(most, hn::Add(at, hn::Set(d, side.most)));
        least = hn::Or(least, hn::Add(at, hn::Set(d, side.least)));
      }
      // The sign of one is that of all
      row.touched |= bits_of(d, hn::Not(hn::Lt(most, hn::Zero(d)))) << i;
      row.full |= bits_of(d, hn::Not(hn::Lt(least, hn::Zero(d)))) << i;
    }
    row.touched &= (2U << last_) - (1U << first_);
    return row;
  }

 private:
  /// A side in 32 bits, rounded down: at + a x + b y in the first pixel of a block, and what its other pixels
  /// add at least and at most.
  struct Bounds {
    std::int32_t at, a, b, least, most;
  };

  HWY_INLINE static Bounds bounds_of(const Side& side, std::int64_t reach) {
    const auto longest = static_cast<std::uint64_t>(std::max(std::abs(side.a), std::abs(side.b)));
    const int shift = std::max(0, static_cast<int>(std::bit_width(longest)) - 22);
    const auto short_of = [&](std::int64_t x) { return static_cast<std::int32_t>(x >> shift); };
    const Side one{0, side.a, side.b};
    const Window block{{0, 0}, {block_side - 1, block_side - 1}};
    // Rounding takes away less than one from each product's factor
    const int lost = shift == 0 ? 0 : 2 * tile_side + 2;
    return {short_of(side.at), short_of(side.a), short_of(side.b), short_of(least(one, block) - reach),
            short_of(largest(one, block) + reach) + lost};
  }

  int first_, last_;
  std::array<Bounds, 3> bounds_;
};

/// How near a triangle is in the blocks of a tile.
class BlockDepths {
 public:
  /// more: what a pixel may have beyond its centre.
  HWY_INLINE BlockDepths(const NearnessPlane& plane, double more)
      : plane_(plane),
        // More than what single precision may lose over a tile
        rise_(static_cast<float>((block_side - 1) * (std::max(plane.right, 0.0) + std::max(plane.down, 0.0)) +
                                 more + slope_of(plane) * 0x1p-14)) {}

  /// The bits of the blocks of a row where it may be nearer than the farthest that they show. far: those.
  HWY_INLINE std::uint32_t not_behind(const float* far, int y) const {
    const Single d;
    const F begin = hn::Set(d, static_cast<float>(plane_.at + block_side * y * plane_.down)),
            right = hn::Set(d, static_cast<float>(plane_.right)), rise = hn::Set(d, rise_);
    std::uint32_t bits = 0;
    for (int i = 0; i < blocks_across; i += static_cast<int>(hn::Lanes(d))) {
      const F x = hn::ConvertTo(d, hn::Load(Whole(), block_columns + i)), old = hn::Load(d, far + i);
      const F most = hn::Add(hn::Add(begin, hn::Mul(right, x)), rise);
      bits |= bits_of(d, hn::Ge(most, hn::Sub(old, unsure(old)))) << i;
    }
    return bits;
  }

 private:
  NearnessPlane plane_;
  float rise_;
};

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
