#include "engine/visibility_batch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/visibility_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#include "engine/blocks-inl.hpp"
#include "engine/casts.hpp"
#include "engine/small_casts-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Boxes of small triangles of so many pixels between two looks at each block.
constexpr int look_closely_after = 8192;

class Visibility {
 public:
  Visibility(const Frame& frame, const Window& pixels, TileBuffer& buffer)
      : frame_(frame), pixels_(pixels), buffer_(buffer), ties_(frame, pixels.lower) {
    buffer.nearness.fill(-1);
    buffer.ids.fill(no_triangle);
    close_beyond(pixels, buffer.nearness);
    far_.fill(-1);
    if (!is_whole_tile(pixels)) find_far();
  }

  /// Draws up to casts_at_once triangles.
  void draw(std::span<const std::int32_t> ids) {
    SmallCasts casts;
    const CastKinds kinds = cast_some(frame_, ids, pixels_, farthest_, casts);
    for_each_bit(kinds.small, [&](int i) {
      draw_small(casts, static_cast<std::size_t>(i), ids[static_cast<std::size_t>(i)]);
    });
    for_each_bit(kinds.others, [&](int i) { draw_large(ids[static_cast<std::size_t>(i)]); });
    if (since_ >= look_after) look_back();
  }

 private:
  // --- What is farthest --------------------------------------------------------------------------

  /// The farthest of all that is nearest, so far.
  void look_back() {
    since_ = 0;
    if (small_since_ >= look_closely_after) find_far();
    const Single d;
    auto least = hn::Set(d, 2.0f);
    for (std::size_t i = 0; i < far_.size(); i += hn::Lanes(d))
      least = hn::Min(least, hn::Load(d, far_.data() + i));
    const float far = hn::GetLane(hn::MinOfLanes(d, least));
    farthest_ = far < 0 ? -1 : double{far} - double{unsure_at(far)};
  }

  void find_far() {
    const Single d;
    small_since_ = 0;
    for (std::size_t block = 0; block < far_.size(); ++block) {
      F least = hn::Set(d, 2.0f);
      for (std::size_t i = 0; i < block_cells; i += hn::Lanes(d))
        least = hn::Min(least, hn::Load(d, buffer_.nearness.data() + block * block_cells + i));
      far_[block] = hn::GetLane(hn::MinOfLanes(d, least));
    }
  }

  // --- Cells -------------------------------------------------------------------------------------

  /// How near cells are, and whether one triangle has just taken all of them.
  struct Put {
    F nearness;
    bool all;
  };
  /// Shows a triangle in cells where it is nearest. first: the cell of the first lane.
  HWY_INLINE Put put(std::size_t first, hn::Mask<Single> inside, F mine, std::int32_t id) {
    const Whole whole;
    const Single single;
    float* const nearness = buffer_.nearness.data() + first;
    std::int32_t* const ids = buffer_.ids.data() + first;
    const F old = hn::Load(single, nearness), doubt = unsure(old);
    const auto nearer = hn::And(inside, hn::Gt(mine, hn::Add(old, doubt)));
    const auto open = hn::AndNot(nearer, hn::And(inside, hn::Ge(mine, hn::Sub(old, doubt))));
    // Whole registers: what is stored in parts is slow to load again
    const F now = hn::IfThenElse(nearer, mine, old);
    hn::Store(now, single, nearness);
    hn::Store(hn::IfThenElse(hn::RebindMask(whole, nearer), hn::Set(whole, id), hn::Load(whole, ids)), whole,
              ids);
    if (HWY_UNLIKELY(!hn::AllFalse(single, open))) settle(first, open, mine, id);
    return {now, hn::AllTrue(single, nearer)};
  }

  /// Where single precision does not decide.
  HWY_NOINLINE void settle(std::size_t first, hn::Mask<Single> open, F mine, std::int32_t id) {
    const Single single;
    alignas(64) float nearness[block_cells];
    hn::Store(mine, single, nearness);
    const ivec2 block = pixels_.lower + TileBuffer::place(first / block_cells * block_cells);
    const OrderedLanes cells =
        order_lanes(ties_, id, open, buffer_.ids.data() + first, places_of(block, block_side));
    for_each_bit(bits_of(single, cells.before), [&](int i) {
      const auto lane = static_cast<std::size_t>(i);
      show(first + lane, nearness[lane], id);
    });
    for_each_bit(bits_of(single, cells.open), [&](int i) {
      const auto lane = static_cast<std::size_t>(i);
      settle_pixel(first + lane, nearness[lane], id);
    });
  }

  void settle_pixel(std::size_t cell, float nearness, std::int32_t id) {
    const ivec2 centre = triangle_coverage::centre_of(pixels_.lower + TileBuffer::place(cell));
    if (ties_.is_before(id, buffer_.ids[cell], centre)) show(cell, nearness, id);
  }

  void show(std::size_t cell, float nearness, std::int32_t id) {
    buffer_.nearness[cell] = nearness;
    buffer_.ids[cell] = id;
  }

  // --- Small triangles ---------------------------------------------------------------------------

  HWY_INLINE void draw_small(const SmallCasts& casts, std::size_t lane, std::int32_t id) {
    const Whole whole;
    const Single single;
    const std::int32_t left = casts.first_column[lane], right = casts.last_column[lane],
                       up = casts.first_row[lane], down = casts.last_row[lane];
    const double along = casts.right[lane], below = casts.down[lane];
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(whole)) {
      const I x = hn::Load(whole, cell_columns + i), y = hn::Load(whole, cell_rows + i);
      const F rise = hn::Add(hn::Mul(hn::Set(single, static_cast<float>(along)), hn::ConvertTo(single, x)),
                             hn::Mul(hn::Set(single, static_cast<float>(below)), hn::ConvertTo(single, y)));
      const auto side = [&](std::size_t k) {
        return hn::Add(hn::Set(whole, casts.at[k][lane]),
                       hn::Add(hn::Mul(hn::Set(whole, casts.a[k][lane]), x),
                               hn::Mul(hn::Set(whole, casts.b[k][lane]), y)));
      };
      const auto step = [&](const auto& by, std::size_t k) {
        return hn::Set(whole, block_side * by[k][lane]);
      };
      I row[3] = {side(0), side(1), side(2)};
      double near_row = casts.near[lane];
      for (std::int32_t v = up; v <= down; ++v, near_row += block_side * below) {
        I at[3] = {row[0], row[1], row[2]};
        double near = near_row;
        for (std::int32_t u = left; u <= right; ++u, near += block_side * along) {
          const auto outside = hn::Lt(hn::Or(hn::Or(at[0], at[1]), at[2]), hn::Zero(whole));
          const auto inside = hn::RebindMask(single, hn::Not(outside));
          if (!hn::AllFalse(single, inside))
            put(static_cast<std::size_t>(v * blocks_across + u) * block_cells + i, inside,
                hn::Add(hn::Set(single, static_cast<float>(near)), rise), id);
          if (u < right)
            for (std::size_t k = 0; k < 3; ++k) at[k] = hn::Add(at[k], step(casts.a, k));
        }
        if (v < down)
          for (std::size_t k = 0; k < 3; ++k) row[k] = hn::Add(row[k], step(casts.b, k));
      }
    }
    const int count = block_cells * (right - left + 1) * (down - up + 1);
    since_ += count;
    small_since_ += count;
  }

  // --- Others ------------------------------------------------------------------------------------

  void draw_large(std::int32_t id) {
    const FrameTriangle& t = frame_.triangle(id);
    const Window box = triangle_coverage::centres(t.grid, pixels_);
    Cast cast = cast_of(t, box, pixels_.lower);
    const NearnessRange range = take_shared_plane(frame_.plane_of(t), t.depth, pixels_.lower, cast);
    bool long_sides = false;
    const Window blocks = in_blocks(cast.box);
    for (Side& side : cast.sides) {
      if (largest(side, cast.box) < 0) return;
      // Blocks reach beyond the box, where that side alone may leave pixels out
      if (least(side, blocks) >= 0)
        side = {0, 0, 0};
      else
        long_sides |= is_too_long(cast, side);
    }
    if (!is_flat_enough(cast, t.depth) || long_sides || !range.is_fine)
      draw_pixels(t, id);
    else
      draw_blocks(cast, range, id);
    since_ += static_cast<int>(box.width() * box.height());
  }

  /// What each cell of a block adds to the sides and to the nearness.
  struct Steps {
    alignas(64) std::int32_t side[3][block_cells];
    alignas(64) float rise[block_cells];
    float least_rise;
    NearnessRange range;

    /// The nearness of cells from the i-th on, in a block that begins with this one.
    HWY_INLINE F nearness(F near, std::size_t i) const {
      const Single d;
      const F sum = hn::Add(near, hn::Load(d, rise + i));
      return hn::Min(hn::Max(sum, hn::Set(d, range.low)), hn::Set(d, range.high));
    }
  };
  HWY_INLINE static void prepare(const Cast& cast, Steps& steps) {
    const Whole whole;
    const Single single;
    F least = hn::Set(single, std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(whole)) {
      const I x = hn::Load(whole, cell_columns + i), y = hn::Load(whole, cell_rows + i);
      for (std::size_t k = 0; k < 3; ++k) {
        const I a = hn::Set(whole, static_cast<std::int32_t>(cast.sides[k].a)),
                b = hn::Set(whole, static_cast<std::int32_t>(cast.sides[k].b));
        hn::Store(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), whole, steps.side[k] + i);
      }
      const F right = hn::Set(single, static_cast<float>(cast.plane.right)),
              lower = hn::Set(single, static_cast<float>(cast.plane.down));
      const F rise =
          hn::Add(hn::Mul(right, hn::ConvertTo(single, x)), hn::Mul(lower, hn::ConvertTo(single, y)));
      hn::Store(rise, single, steps.rise + i);
      least = hn::Min(least, rise);
    }
    steps.least_rise = hn::GetLane(hn::MinOfLanes(single, least));
  }

  HWY_INLINE void draw_blocks(const Cast& cast, const NearnessRange& range, std::int32_t id) {
    const BlockRows rows(cast, {0, 0, 0});
    const BlockDepths depths(cast.plane, range.off);
    Steps steps;
    steps.range = range;
    prepare(cast, steps);
    for (int y = cast.box.lower.y / block_side; y <= cast.box.upper.y / block_side; ++y) {
      const BlockRow row = rows.row(y);
      if (row.touched == 0) continue;
      const std::uint32_t seen = row.touched & depths.not_behind(far_.data() + y * blocks_across, y);
      for_each_bit(seen & row.full, [&](int x) { draw_whole_block(cast, {x, y}, steps, id); });
      for_each_bit(seen & ~row.full, [&](int x) { draw_block(cast, {x, y}, steps, id); });
    }
  }

  HWY_INLINE static float near_of(const Cast& cast, ivec2 block) {
    return static_cast<float>(cast.plane.at +
                              block_side * (cast.plane.right * block.x + cast.plane.down * block.y));
  }

  /// A block that the triangle covers.
  HWY_INLINE void draw_whole_block(const Cast& cast, ivec2 block, const Steps& steps, std::int32_t id) {
    const Single single;
    const auto number = static_cast<std::size_t>(block.y * blocks_across + block.x);
    const auto everywhere = hn::Eq(hn::Zero(single), hn::Zero(single));
    const float near = near_of(cast, block);
    F far = hn::Set(single, 2.0f);
    bool all = true;
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(single)) {
      const F mine = steps.nearness(hn::Set(single, near), i);
      const Put shown = put(number * block_cells + i, everywhere, mine, id);
      far = hn::Min(far, shown.nearness);
      all = all && shown.all;
    }
    // The least sum has the least part: no look at the lanes
    far_[number] =
        all ? steps.range.clamped(near + steps.least_rise) : hn::GetLane(hn::MinOfLanes(single, far));
  }

  HWY_INLINE void draw_block(const Cast& cast, ivec2 block, const Steps& steps, std::int32_t id) {
    const Whole whole;
    const Single single;
    const auto number = static_cast<std::size_t>(block.y * blocks_across + block.x);
    const auto first = block_side * block;
    const std::array at{at_block(cast.sides[0], first), at_block(cast.sides[1], first),
                        at_block(cast.sides[2], first)};
    const F near = hn::Set(single, near_of(cast, block));
    F far = hn::Set(single, 2.0f);
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(whole)) {
      const auto side = [&](std::size_t k) {
        return hn::Add(hn::Set(whole, at[k]), hn::Load(whole, steps.side[k] + i));
      };
      // The sign of one is that of all
      const auto outside = hn::Lt(hn::Or(hn::Or(side(0), side(1)), side(2)), hn::Zero(whole));
      const auto inside = hn::RebindMask(single, hn::Not(outside));
      const F mine = steps.nearness(near, i);
      far = hn::Min(far, put(number * block_cells + i, inside, mine, id).nearness);
    }
    // Where a cell shows nothing yet, that is the farthest already
    if (hn::AllTrue(single, hn::Ge(far, hn::Zero(single))))
      far_[number] = hn::GetLane(hn::MinOfLanes(single, far));
  }

  /// Pixel by pixel, for triangles too steep or too long for blocks.
  HWY_NOINLINE void draw_pixels(const FrameTriangle& t, std::int32_t id) {
    const triangle_coverage::Depth depth = depth_of(frame_, t);
    triangle_coverage::cover(t.grid, pixels_, [&](ivec2 pixel, const triangle_coverage::Weights& w) {
      const std::size_t cell = TileBuffer::cell(pixel - pixels_.lower);
      const auto mine = static_cast<float>(1 - depth.at(triangle_coverage::centre_of(pixel), w)),
                 old = buffer_.nearness[cell];
      if (mine > old + unsure_at(old))
        show(cell, mine, id);
      else if (mine >= old - unsure_at(old))
        settle_pixel(cell, mine, id);
    });
  }

  const Frame& frame_;
  Window pixels_;
  TileBuffer& buffer_;
  TileTies ties_;
  /// The farthest of each block, or what was that before: farther ones are not seen there.
  alignas(64) std::array<float, TileBuffer::cells / block_cells> far_;
  double farthest_ = -1;  ///< what is farther is seen nowhere
  int since_ = 0;         ///< pixels that boxes had since that was found
  int small_since_ = 0;   ///< of small triangles, since far_ was found for all blocks
};

void find_in_tile(const Frame& frame, int tile, const Window& pixels, TileBuffer& buffer) {
  Visibility visibility(frame, pixels, buffer);
  visit_tile_in_parts<casts_at_once>(frame, tile,
                                     [&](std::span<const std::int32_t> ids) { visibility.draw(ids); });
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::pipeline::engine {
HWY_EXPORT(find_in_tile);

void find_nearest(const Frame& frame, int tile, const Window& pixels, TileBuffer& buffer) {
  HWY_DYNAMIC_DISPATCH(find_in_tile)(frame, tile, pixels, buffer);
}

}  // namespace gradus::pipeline::engine
#endif
