#include "engine/visibility_batch.hpp"

#include <algorithm>
#include <cmath>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/visibility_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#include "engine/casts.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Whole = hn::CappedTag<std::int32_t, block_cells>;
using Single = hn::RebindToFloat<Whole>;

class Visibility {
 public:
  Visibility(const Frame& frame, const Window& pixels, TileBuffer& buffer)
      : frame_(frame), pixels_(pixels), buffer_(buffer) {
    buffer.nearness.fill(-1);
    buffer.ids.fill(no_triangle);
    // Nothing is nearer than what lies beyond the window
    for (int y = 0; y < tile_side; ++y)
      for (int x = y < pixels.height() ? static_cast<int>(pixels.width()) : 0; x < tile_side; ++x)
        buffer.nearness[TileBuffer::cell({x, y})] = 2;
  }

  void draw(std::int32_t id) {
    const FrameTriangle& t = frame_.triangle(id);
    const Window box = triangle_coverage::centres(t.grid, pixels_);
    if (box.empty()) return;
    if (1 - std::min(std::min(t.depth.x, t.depth.y), t.depth.z) < farthest_) return;
    Cast cast = cast_of(t, box, pixels_.lower);
    bool long_sides = false;
    const Window blocks = in_blocks(cast.box);
    for (Side& side : cast.sides) {
      if (largest(side, cast.box) < 0) return;
      // Blocks reach beyond the box, where that side alone may leave pixels out
      if (least(side, blocks) >= 0)
        side = {0, 0, 0};
      else
        long_sides |= std::max(std::abs(side.a), std::abs(side.b)) >= 1 << 23;
    }
    if (!is_flat_enough(cast.plane, t.depth) || long_sides)
      draw_pixels(t, id);
    else
      draw_blocks(cast, id);
    since_ += static_cast<int>(box.width() * box.height());
    if (since_ >= 1024) look_back();
  }

 private:
  /// The farthest of all that is nearest, so far.
  void look_back() {
    since_ = 0;
    const Single d;
    auto least = hn::Set(d, 2.0f);
    for (std::size_t i = 0; i < TileBuffer::cells; i += hn::Lanes(d))
      least = hn::Min(least, hn::Load(d, buffer_.nearness.data() + i));
    const auto far = static_cast<double>(hn::GetLane(hn::MinOfLanes(d, least)));
    farthest_ = far < 0 ? -1 : far - (far * double{unsure_share} + double{unsure_at_least});
  }

  HWY_INLINE void draw_blocks(const Cast& cast, std::int32_t id) {
    const Whole whole;
    const Single single;
    // What each cell of a block adds to the sides and to the nearness
    alignas(64) static constexpr std::int32_t across[block_cells] = {0, 1, 2, 3, 0, 1, 2, 3,
                                                                     0, 1, 2, 3, 0, 1, 2, 3};
    alignas(64) static constexpr std::int32_t down[block_cells] = {0, 0, 0, 0, 1, 1, 1, 1,
                                                                   2, 2, 2, 2, 3, 3, 3, 3};
    alignas(64) std::int32_t add[3][block_cells];
    alignas(64) float rise[block_cells];
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(whole)) {
      const auto x = hn::Load(whole, across + i), y = hn::Load(whole, down + i);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto a = hn::Set(whole, static_cast<std::int32_t>(cast.sides[k].a)),
                   b = hn::Set(whole, static_cast<std::int32_t>(cast.sides[k].b));
        hn::Store(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), whole, add[k] + i);
      }
      const auto right = hn::Set(single, static_cast<float>(cast.plane.right)),
                 lower = hn::Set(single, static_cast<float>(cast.plane.down));
      hn::Store(hn::Add(hn::Mul(right, hn::ConvertTo(single, x)), hn::Mul(lower, hn::ConvertTo(single, y))),
                single, rise + i);
    }
    const ivec2 first = cast.box.lower / block_side, last = cast.box.upper / block_side;
    const auto begins = [&](std::size_t k, ivec2 block) {
      const Side& s = cast.sides[k];
      return static_cast<std::int32_t>(s.at + block_side * (s.a * block.x + s.b * block.y));
    };
    for (int y = first.y; y <= last.y; ++y) {
      std::int32_t at[3] = {begins(0, {first.x, y}), begins(1, {first.x, y}), begins(2, {first.x, y})};
      for (int x = first.x; x <= last.x; ++x) {
        const ivec2 block{x, y};
        const double near = cast.plane.at + block_side * (cast.plane.right * x + cast.plane.down * y);
        draw_block(block, at, add, static_cast<float>(near), rise, id);
        for (std::size_t k = 0; k < 3; ++k) at[k] += block_side * static_cast<std::int32_t>(cast.sides[k].a);
      }
    }
  }

  HWY_INLINE void draw_block(ivec2 block, const std::int32_t (&at)[3],
                             const std::int32_t (&add)[3][block_cells], float near,
                             const float (&rise)[block_cells], std::int32_t id) {
    const Whole whole;
    const Single single;
    const auto base = static_cast<std::size_t>((block.y * blocks_across + block.x) * block_cells);
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(whole)) {
      const auto side = [&](std::size_t k) {
        return hn::Add(hn::Set(whole, at[k]), hn::Load(whole, add[k] + i));
      };
      // The sign of one is that of all
      const auto signs = hn::Or(hn::Or(side(0), side(1)), side(2));
      const auto inside = hn::RebindMask(single, hn::Not(hn::Lt(signs, hn::Zero(whole))));
      if (hn::AllFalse(single, inside)) continue;
      float* const nearness = buffer_.nearness.data() + base + i;
      const auto mine = hn::Add(hn::Set(single, near), hn::Load(single, rise + i));
      const auto old = hn::Load(single, nearness);
      const auto unsure =
          hn::Add(hn::Mul(old, hn::Set(single, unsure_share)), hn::Set(single, unsure_at_least));
      const auto nearer = hn::And(inside, hn::Gt(mine, hn::Add(old, unsure)));
      const auto open = hn::AndNot(nearer, hn::And(inside, hn::Ge(mine, hn::Sub(old, unsure))));
      hn::BlendedStore(mine, nearer, single, nearness);
      hn::BlendedStore(hn::Set(whole, id), hn::RebindMask(whole, nearer), whole,
                       buffer_.ids.data() + base + i);
      if (!hn::AllFalse(single, open)) settle(block, i, open, mine, id);
    }
  }

  /// Where single precision does not decide.
  HWY_NOINLINE void settle(ivec2 block, std::size_t first, hn::Mask<Single> open, hn::Vec<Single> mine,
                           std::int32_t id) {
    const Single single;
    alignas(64) float nearness[block_cells];
    alignas(64) float wanted[block_cells];
    hn::Store(mine, single, nearness);
    hn::Store(hn::IfThenElseZero(open, hn::Set(single, 1.0f)), single, wanted);
    for (std::size_t i = 0; i < hn::Lanes(single); ++i) {
      if (wanted[i] == 0) continue;
      const auto cell = static_cast<int>(first + i);
      settle_pixel(block * block_side + ivec2{cell % block_side, cell / block_side}, nearness[i], id);
    }
  }

  void settle_pixel(ivec2 at, float nearness, std::int32_t id) {
    const std::size_t cell = TileBuffer::cell(at);
    const ivec2 centre = triangle_coverage::centre_of(pixels_.lower + at);
    if (exact_depth(frame_, id, centre) < exact_depth(frame_, buffer_.ids[cell], centre)) {
      buffer_.nearness[cell] = nearness;
      buffer_.ids[cell] = id;
    }
  }

  /// Pixel by pixel, for triangles too steep or too long for blocks.
  void draw_pixels(const FrameTriangle& t, std::int32_t id) {
    const triangle_coverage::Linear depth(t.grid, t.depth);
    triangle_coverage::cover(t.grid, pixels_, [&](ivec2 pixel, const triangle_coverage::Weights& w) {
      const ivec2 at = pixel - pixels_.lower;
      const std::size_t cell = TileBuffer::cell(at);
      const auto mine = static_cast<float>(1 - depth.at(w)), old = buffer_.nearness[cell];
      const float unsure = old * unsure_share + unsure_at_least;
      if (mine > old + unsure) {
        buffer_.nearness[cell] = mine;
        buffer_.ids[cell] = id;
      } else if (mine >= old - unsure) {
        settle_pixel(at, mine, id);
      }
    });
  }

  const Frame& frame_;
  Window pixels_;
  TileBuffer& buffer_;
  double farthest_ = -1;  ///< what is farther is seen nowhere
  int since_ = 0;         ///< pixels that boxes had since that was found
};

void find_in_tile(const Frame& frame, int tile, const Window& pixels, TileBuffer& buffer) {
  Visibility visibility(frame, pixels, buffer);
  visit_tile(frame, tile, [&](std::int32_t id) { visibility.draw(id); });
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
