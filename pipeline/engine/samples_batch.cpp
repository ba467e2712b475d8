#include "engine/samples_batch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/samples_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#include "engine/blocks-inl.hpp"
#include "engine/casts.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

static_assert(most_samples == block_cells);

class Sampling {
 public:
  Sampling(const Frame& frame, const Window& pixels, std::span<const ivec2> places, SampleBuffer& buffer)
      : frame_(frame),
        pixels_(pixels),
        places_(places),
        offsets_(places),
        buffer_(buffer),
        ties_(frame, pixels.lower) {
    buffer.least.fill(-1);
    buffer.most.fill(-1);
    buffer.whole.fill(no_triangle);
    buffer.sampled.fill(-1);
    buffer.samples.resize(SampleBuffer::cells);
    buffer.sampled_cells.clear();
    close_beyond(pixels, buffer.least);
    close_beyond(pixels, buffer.most);
    far_.fill(-1);
    near_.fill(-1);
    if (is_whole_tile(pixels)) return;
    for (std::size_t block = 0; block < far_.size(); ++block) {
      far_[block] = farthest_in(block);
      near_[block] = *std::max_element(buffer.most.data() + block * block_cells,
                                       buffer.most.data() + (block + 1) * block_cells);
    }
  }

  void draw(std::int32_t id) {
    const FrameTriangle& t = frame_.triangle(id);
    const Window box = squares_of(t.grid, pixels_);
    if (box.empty()) return;
    if (1 - std::min(std::min(t.depth.x, t.depth.y), t.depth.z) < farthest_) return;
    Cast cast = cast_of(t, box, pixels_.lower);
    const NearnessRange range = take_shared_plane(frame_.plane_of(t), t.depth, pixels_.lower, cast);
    bool long_sides = false;
    const Window blocks = in_blocks(cast.box);
    std::array<std::int64_t, 3> half;
    for (std::size_t k = 0; k < 3; ++k) {
      Side& side = cast.sides[k];
      half[k] = half_pixel(side);
      if (largest(side, cast.box) < -half[k]) return;
      if (least(side, blocks) >= half[k]) {
        // It leaves out nothing, and may be too far for 32 bits
        side = {1 << 20, 0, 0};
        half[k] = 1;
      } else {
        long_sides |= is_too_long(cast, side);
      }
    }
    if (!is_flat_enough(cast, t.depth) || long_sides || !range.is_fine)
      draw_exactly(t, cast, range, id);
    else
      draw_blocks(cast, half, range, id);
    since_ += static_cast<int>(box.width() * box.height());
    if (since_ >= look_after) look_back();
  }

 private:
  /// By how much an edge function changes from the centre of a pixel to its corners, rounded up.
  HWY_INLINE static std::int64_t half_pixel(const Side& side) {
    return (std::abs(side.a) + std::abs(side.b) + 1) / 2 + 1;
  }

  /// The farthest of all that covers pixels whole, so far.
  void look_back() {
    since_ = 0;
    const Single d;
    F least = hn::Set(d, 2.0f);
    for (std::size_t i = 0; i < far_.size(); i += hn::Lanes(d))
      least = hn::Min(least, hn::Load(d, far_.data() + i));
    const float far = hn::GetLane(hn::MinOfLanes(d, least));
    farthest_ = far < 0 ? -1 : double{far} - double{unsure_at(far)};
  }

  /// The farthest of what covers the pixels of a block whole.
  HWY_INLINE float farthest_in(std::size_t block) const {
    const Single d;
    F least = hn::Set(d, 2.0f);
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(d))
      least = hn::Min(least, hn::Load(d, buffer_.least.data() + block * block_cells + i));
    return hn::GetLane(hn::MinOfLanes(d, least));
  }

  /// What a triangle adds from sample to sample, and from cell to cell of a block.
  struct Steps {
    alignas(64) std::int32_t side_at_sample[3][most_samples];
    alignas(64) float rise_at_sample[most_samples];
    alignas(64) std::int32_t side_in_block[3][block_cells];
    alignas(64) float rise_in_block[block_cells];
    std::array<std::int32_t, 3> half;  ///< half_pixel of the sides
    float slope;                       ///< by how much the nearness changes from a centre to a corner
    float least_rise, most_rise;       ///< in a block
    NearnessRange range;
  };

  HWY_INLINE void prepare(const Cast& cast, Steps& steps) const {
    const Whole whole;
    const Single single;
    const F right = hn::Set(single, static_cast<float>(cast.plane.right)),
            lower = hn::Set(single, static_cast<float>(cast.plane.down)),
            part = hn::Set(single, 1.0f / triangle_coverage::subpixels);
    F least = hn::Set(single, std::numeric_limits<float>::infinity()), most = hn::Neg(least);
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(whole)) {
      const I x = hn::Load(whole, cell_columns + i), y = hn::Load(whole, cell_rows + i);
      const I dx = hn::Load(whole, offsets_.right + i), dy = hn::Load(whole, offsets_.down + i);
      for (std::size_t k = 0; k < 3; ++k) {
        const I a = hn::Set(whole, static_cast<std::int32_t>(cast.sides[k].a)),
                b = hn::Set(whole, static_cast<std::int32_t>(cast.sides[k].b));
        hn::Store(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), whole, steps.side_in_block[k] + i);
        // The edge function there, over 256 and rounded down, less that of the centre
        const I rest = hn::Set(whole, static_cast<std::int32_t>(cast.origin[k] & 255));
        const I there = hn::Add(hn::Add(hn::Mul(a, dx), hn::Mul(b, dy)), rest);
        hn::Store(hn::ShiftRight<8>(there), whole, steps.side_at_sample[k] + i);
      }
      const auto rise = [&](I along, I up) {
        return hn::Add(hn::Mul(right, hn::ConvertTo(single, along)),
                       hn::Mul(lower, hn::ConvertTo(single, up)));
      };
      const F in_block = rise(x, y);
      least = hn::Min(least, in_block);
      most = hn::Max(most, in_block);
      hn::Store(in_block, single, steps.rise_in_block + i);
      hn::Store(hn::Mul(rise(dx, dy), part), single, steps.rise_at_sample + i);
    }
    steps.least_rise = hn::GetLane(hn::MinOfLanes(single, least));
    steps.most_rise = hn::GetLane(hn::MaxOfLanes(single, most));
    for (std::size_t k = 0; k < 3; ++k)
      if (steps.half[k] >= 1 << 23) prepare_long_side(cast, k, steps);
  }

  /// What a side adds from sample to sample, where 32 bits do not hold products.
  HWY_NOINLINE void prepare_long_side(const Cast& cast, std::size_t k, Steps& steps) const {
    const Side& side = cast.sides[k];
    for (std::size_t s = 0; s < most_samples; ++s)
      steps.side_at_sample[k][s] = static_cast<std::int32_t>(
          (side.a * offsets_.right[s] + side.b * offsets_.down[s] + (cast.origin[k] & 255)) >> 8);
  }

  HWY_INLINE void draw_blocks(const Cast& cast, const std::array<std::int64_t, 3>& half,
                              const NearnessRange& range, std::int32_t id) {
    const double slope = slope_of(cast.plane) / 2 + range.off;
    const BlockRows rows(cast, half);
    const BlockDepths depths(cast.plane, slope);
    Steps steps;
    for (std::size_t k = 0; k < 3; ++k) steps.half[k] = static_cast<std::int32_t>(half[k]);
    steps.slope = static_cast<float>(slope);
    steps.range = range;
    prepare(cast, steps);
    for (int y = cast.box.lower.y / block_side; y <= cast.box.upper.y / block_side; ++y) {
      const BlockRow row = rows.row(y);
      if (row.touched == 0) continue;
      const std::uint32_t seen = row.touched & depths.not_behind(far_.data() + y * blocks_across, y);
      for_each_bit(seen, [&](int x) { draw_block(cast, {x, y}, (row.full >> x & 1) != 0, steps, id); });
    }
  }

  /// Of which cells a triangle is the nearest that covers them whole.
  struct Taken {
    bool some, all;
  };
  /// whole: the triangle covers all of the block.
  HWY_INLINE void draw_block(const Cast& cast, ivec2 block, bool whole, const Steps& steps, std::int32_t id) {
    const ivec2 first = block_side * block;
    const auto number = static_cast<std::size_t>(block.y * blocks_across + block.x);
    const std::array at{at_block(cast.sides[0], first), at_block(cast.sides[1], first),
                        at_block(cast.sides[2], first)};
    const auto near =
        static_cast<float>(cast.plane.at + cast.plane.right * first.x + cast.plane.down * first.y);
    // The least and the most sum have the least and the most part: no look at the lanes
    const float least = near + steps.least_rise - steps.slope, most = near + steps.most_rise + steps.slope;
    if (whole && least > near_[number] + unsure_at(near_[number])) {
      put_block(number * block_cells, near, steps, id);
      far_[number] = least;
      near_[number] = most;
      return;
    }
    Taken taken{false, true};
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(Single())) {
      const Taken some = draw_cells(number * block_cells, i, at, near, whole, steps, id);
      taken = {taken.some || some.some, taken.all && some.all};
    }
    if (taken.all)
      far_[number] = least;
    else if (taken.some)
      far_[number] = farthest_in(number);
    if (taken.some) near_[number] = std::max(near_[number], most);
  }

  /// Of a triangle that covers all of a block and is surely nearer than all that it shows.
  HWY_INLINE void put_block(std::size_t base, float near, const Steps& steps, std::int32_t id) {
    const Whole whole;
    const Single single;
    const F slope = hn::Set(single, steps.slope);
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(single)) {
      const F middle = hn::Add(hn::Set(single, near), hn::Load(single, steps.rise_in_block + i));
      hn::Store(hn::Sub(middle, slope), single, buffer_.least.data() + base + i);
      hn::Store(hn::Add(middle, slope), single, buffer_.most.data() + base + i);
      hn::Store(hn::Set(whole, id), whole, buffer_.whole.data() + base + i);
    }
  }

  /// Cells of a block that begins at a cell, from the i-th on.
  HWY_INLINE Taken draw_cells(std::size_t base, std::size_t i, const std::array<std::int32_t, 3>& at,
                              float near, bool whole_block, const Steps& steps, std::int32_t id) {
    const Whole whole;
    const Single single;
    const auto everywhere = hn::Eq(hn::Zero(single), hn::Zero(single));
    auto touched = everywhere, full = everywhere;
    const auto side = [&](std::size_t k) {
      return hn::Add(hn::Set(whole, at[k]), hn::Load(whole, steps.side_in_block[k] + i));
    };
    if (!whole_block) {
      // Of the three sides how far the centre is inside, at least, beside what a pixel reaches
      I out = hn::Zero(whole), in = hn::Zero(whole);
      for (std::size_t k = 0; k < 3; ++k) {
        const I half = hn::Set(whole, steps.half[k]), e = side(k);
        out = hn::Or(out, hn::Add(e, half));
        in = hn::Or(in, hn::Sub(e, half));
      }
      touched = hn::RebindMask(single, hn::Not(hn::Lt(out, hn::Zero(whole))));
      if (hn::AllFalse(single, touched)) return {false, false};
      full = hn::RebindMask(single, hn::Not(hn::Lt(in, hn::Zero(whole))));
    }
    const F middle = hn::Add(hn::Set(single, near), hn::Load(single, steps.rise_in_block + i));
    const F slope = hn::Set(single, steps.slope), less = hn::Sub(middle, slope),
            more = hn::Add(middle, slope);
    float* const least = buffer_.least.data() + base + i;
    float* const most = buffer_.most.data() + base + i;
    std::int32_t* const ids = buffer_.whole.data() + base + i;
    const F old_least = hn::Load(single, least), old_most = hn::Load(single, most);
    auto seen = hn::And(touched, hn::Not(hn::Lt(more, hn::Sub(old_least, unsure(old_least)))));
    auto nearer = hn::Gt(less, hn::Add(old_most, unsure(old_most)));
    if (const auto open = hn::AndNot(nearer, seen); HWY_UNLIKELY(!hn::AllFalse(single, open))) {
      const OrderedLanes cells = order_cells(base, i, open, id);
      nearer = hn::Or(nearer, cells.before);
      seen = hn::Or(hn::And(seen, nearer), cells.open);
    }
    const auto takes = hn::And(hn::And(seen, full), nearer);
    // Whole registers: what is stored in parts is slow to load again
    hn::Store(hn::IfThenElse(takes, less, old_least), single, least);
    hn::Store(hn::IfThenElse(takes, more, old_most), single, most);
    hn::Store(hn::IfThenElse(hn::RebindMask(whole, takes), hn::Set(whole, id), hn::Load(whole, ids)), whole,
              ids);
    const Taken taken{!hn::AllFalse(single, takes), hn::AllTrue(single, takes)};
    const auto rest = hn::AndNot(takes, seen);
    if (hn::AllFalse(single, rest)) return taken;
    alignas(64) std::int32_t sides[3][block_cells];
    alignas(64) float nearness[block_cells];
    for (std::size_t k = 0; k < 3; ++k) hn::Store(side(k), whole, sides[k]);
    hn::Store(middle, single, nearness);
    for_each_bit(bits_of(single, rest), [&](int lane) {
      const auto k = static_cast<std::size_t>(lane);
      sample(base + i + k, {sides[0][k], sides[1][k], sides[2][k]}, nearness[k], steps, id);
    });
    return taken;
  }

  /// Where single precision does not decide: of the cells of a block from the i-th on.
  HWY_NOINLINE OrderedLanes order_cells(std::size_t base, std::size_t i, hn::Mask<Single> open,
                                        std::int32_t id) {
    const Single single;
    const std::int32_t* const ids = buffer_.whole.data() + base + i;
    OrderedLanes cells =
        order_lanes(ties_, id, open, ids, places_of(pixels_.lower + TileBuffer::place(base), block_side));
    // Of a block that reaches beyond the depths of a triangle's corners, most pixels do not
    std::uint32_t before = 0, after = 0;
    for_each_bit(bits_of(single, cells.open), [&](int lane) {
      const std::size_t cell = i + static_cast<std::size_t>(lane);
      if (ids[lane] == no_triangle) return;
      const Places places = places_of(pixels_.lower + TileBuffer::place(base + cell), 1);
      const TileTies::Order order = ties_.order(id, ids[lane], places);
      before |= static_cast<std::uint32_t>(order == TileTies::Order::before) << lane;
      after |= static_cast<std::uint32_t>(order == TileTies::Order::after) << lane;
    });
    cells.before = hn::Or(cells.before, mask_of(single, before));
    cells.open = hn::AndNot(mask_of(single, before | after), cells.open);
    return cells;
  }

  /// Where those of a cell will stand that is without samples so far.
  HWY_INLINE PixelSamples& next_samples() { return buffer_.samples[buffer_.sampled_cells.size()]; }
  HWY_INLINE void take_next_samples(std::size_t cell) {
    buffer_.sampled[cell] = static_cast<std::int32_t>(buffer_.sampled_cells.size());
    buffer_.sampled_cells.push_back(static_cast<std::int32_t>(cell));
  }

  HWY_INLINE PixelSamples& samples_of(std::size_t cell) {
    if (buffer_.sampled[cell] < 0) {
      PixelSamples& fresh = next_samples();
      fresh.nearness.fill(-1);
      fresh.ids.fill(no_triangle);
      take_next_samples(cell);
    }
    return buffer_.samples[static_cast<std::size_t>(buffer_.sampled[cell])];
  }

  /// What a triangle has at some of the samples of a cell, from the i-th on.
  struct AtSamples {
    hn::Mask<Single> inside;
    F nearness;
  };
  HWY_INLINE AtSamples at_samples(std::size_t i, const std::array<std::int32_t, 3>& at, float near,
                                  const Steps& steps) const {
    const Whole whole;
    const Single single;
    const auto side = [&](std::size_t k) {
      return hn::Add(hn::Set(whole, at[k]), hn::Load(whole, steps.side_at_sample[k] + i));
    };
    const auto signs = hn::Or(hn::Or(side(0), side(1)), side(2));
    const F there = hn::Add(hn::Set(single, near), hn::Load(single, steps.rise_at_sample + i));
    return {hn::RebindMask(single, hn::Not(hn::Lt(signs, hn::Zero(whole)))),
            hn::Min(hn::Max(there, hn::Set(single, steps.range.low)), hn::Set(single, steps.range.high))};
  }

  /// The same where nothing has been seen at a cell's samples yet: most that are seen there come first.
  HWY_INLINE void sample_first(std::size_t cell, const std::array<std::int32_t, 3>& at, float near,
                               const Steps& steps, std::int32_t id) {
    const Whole whole;
    const Single single;
    PixelSamples& of = next_samples();
    bool some = false;
    for (std::size_t i = 0; i < most_samples; i += hn::Lanes(whole)) {
      const AtSamples here = at_samples(i, at, near, steps);
      hn::Store(hn::IfThenElse(here.inside, here.nearness, hn::Set(single, -1.0f)), single,
                of.nearness.data() + i);
      hn::Store(
          hn::IfThenElse(hn::RebindMask(whole, here.inside), hn::Set(whole, id), hn::Set(whole, no_triangle)),
          whole, of.ids.data() + i);
      some |= !hn::AllFalse(single, here.inside);
    }
    if (some) take_next_samples(cell);
  }

  HWY_INLINE void sample(std::size_t cell, const std::array<std::int32_t, 3>& at, float near,
                         const Steps& steps, std::int32_t id) {
    const Whole whole;
    const Single single;
    const std::int32_t place = buffer_.sampled[cell];
    if (place < 0) return sample_first(cell, at, near, steps, id);
    PixelSamples& of = buffer_.samples[static_cast<std::size_t>(place)];
    for (std::size_t i = 0; i < most_samples; i += hn::Lanes(whole)) {
      const auto [inside, mine] = at_samples(i, at, near, steps);
      if (hn::AllFalse(single, inside)) continue;
      float* const nearness = of.nearness.data() + i;
      std::int32_t* const ids = of.ids.data() + i;
      const F old = hn::Load(single, nearness);
      const auto nearer = hn::And(inside, hn::Gt(mine, hn::Add(old, unsure(old))));
      const auto open = hn::AndNot(nearer, hn::And(inside, hn::Ge(mine, hn::Sub(old, unsure(old)))));
      hn::Store(hn::IfThenElse(nearer, mine, old), single, nearness);
      hn::Store(hn::IfThenElse(hn::RebindMask(whole, nearer), hn::Set(whole, id), hn::Load(whole, ids)),
                whole, ids);
      if (HWY_UNLIKELY(!hn::AllFalse(single, open))) settle(of, cell, i, open, mine, id);
    }
  }

  /// Where a sample lies in the picture, in 1/256 pixel.
  ivec2 place_of(std::size_t cell, std::size_t s) const {
    return (pixels_.lower + TileBuffer::place(cell)) * triangle_coverage::subpixels +
           places_[std::min(s, places_.size() - 1)];
  }

  /// Where single precision does not decide. first: the sample of the first lane.
  HWY_NOINLINE void settle(PixelSamples& of, std::size_t cell, std::size_t first, hn::Mask<Single> open,
                           F mine, std::int32_t id) {
    const Whole whole;
    const Single single;
    float* const nearness = of.nearness.data() + first;
    std::int32_t* const ids = of.ids.data() + first;
    const ivec2 pixel = pixels_.lower + TileBuffer::place(cell);
    const OrderedLanes samples = order_lanes(ties_, id, open, ids, places_of(pixel, 1));
    hn::Store(hn::IfThenElse(samples.before, mine, hn::Load(single, nearness)), single, nearness);
    hn::Store(hn::IfThenElse(hn::RebindMask(whole, samples.before), hn::Set(whole, id), hn::Load(whole, ids)),
              whole, ids);
    if (hn::AllFalse(single, samples.open)) return;
    alignas(64) float own[most_samples];
    hn::Store(mine, single, own);
    for_each_bit(bits_of(single, samples.open), [&](int i) {
      const auto lane = static_cast<std::size_t>(i);
      settle_sample(of, first + lane, place_of(cell, first + lane), own[lane], id);
    });
  }

  void settle_sample(PixelSamples& of, std::size_t s, ivec2 place, float nearness, std::int32_t id) {
    if (!ties_.is_before(id, of.ids[s], place)) return;
    of.nearness[s] = nearness;
    of.ids[s] = id;
  }

  /// Pixel by pixel, for triangles too steep or too long for blocks.
  HWY_NOINLINE void draw_exactly(const FrameTriangle& t, const Cast& cast, const NearnessRange& range,
                                 std::int32_t id) {
    const auto edges = triangle_coverage::edges_of(t.grid);
    const double slope = slope_of(cast.plane) / 2 + range.off;
    std::array<std::int64_t, 3> half;
    for (std::size_t k = 0; k < 3; ++k) {
      const ivec2 way = edges[k].to - edges[k].from;
      half[k] = std::int64_t{triangle_coverage::subpixels / 2} * (std::abs(way.x) + std::abs(way.y)) + 1;
    }
    for (int y = cast.box.lower.y; y <= cast.box.upper.y; ++y) {
      for (int x = cast.box.lower.x; x <= cast.box.upper.x; ++x) {
        const auto w = weights_at_place(edges, triangle_coverage::centre_of(pixels_.lower + ivec2{x, y}));
        if (w[0] < -half[0] || w[1] < -half[1] || w[2] < -half[2]) continue;
        const std::size_t cell = TileBuffer::cell({x, y});
        const double middle = cast.plane.at + cast.plane.right * x + cast.plane.down * y;
        const auto less = static_cast<float>(middle - slope), more = static_cast<float>(middle + slope);
        float &least = buffer_.least[cell], &most = buffer_.most[cell];
        if (more < least - unsure_at(least)) continue;
        const bool full = w[0] >= half[0] && w[1] >= half[1] && w[2] >= half[2];
        if (full && less > most + unsure_at(most)) {
          least = less;
          most = more;
          near_[cell / block_cells] = std::max(near_[cell / block_cells], more);
          buffer_.whole[cell] = id;
        } else {
          sample_exactly(t, edges, cell, id);
        }
      }
    }
  }

  void sample_exactly(const FrameTriangle& t, const triangle_coverage::Edges& edges, std::size_t cell,
                      std::int32_t id) {
    const triangle_coverage::Depth depth = depth_of(frame_, t);
    for (std::size_t s = 0; s < places_.size(); ++s) {
      const ivec2 place = place_of(cell, s);
      const auto w = weights_at_place(edges, place);
      if (!holds(edges, w)) continue;
      PixelSamples& of = samples_of(cell);
      const auto mine = static_cast<float>(1 - depth.at(place, w)), old = of.nearness[s];
      if (mine > old + unsure_at(old)) {
        of.nearness[s] = mine;
        of.ids[s] = id;
      } else if (mine >= old - unsure_at(old)) {
        settle_sample(of, s, place, mine, id);
      }
    }
  }

  const Frame& frame_;
  Window pixels_;
  std::span<const ivec2> places_;
  SampleOffsets offsets_;
  SampleBuffer& buffer_;
  TileTies ties_;
  /// The farthest of what covers pixels of each block whole, or what was that before.
  alignas(64) std::array<float, SampleBuffer::cells / block_cells> far_;
  /// The nearest of it, or what is nearer.
  std::array<float, SampleBuffer::cells / block_cells> near_;
  double farthest_ = -1;  ///< what is farther is seen nowhere
  int since_ = 0;         ///< pixels that boxes had since that was found
};

void sample_tile(const Frame& frame, int tile, const Window& pixels, std::span<const ivec2> places,
                 SampleBuffer& buffer) {
  Sampling sampling(frame, pixels, places, buffer);
  visit_tile_in_parts<16>(frame, tile, [&](std::span<const std::int32_t> ids) {
    for (const std::int32_t id : ids) sampling.draw(id);
  });
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::pipeline::engine {
HWY_EXPORT(sample_tile);

void find_samples(const Frame& frame, int tile, const Window& pixels, std::span<const ivec2> places,
                  SampleBuffer& buffer) {
  expects(!places.empty() && places.size() <= most_samples, "a pixel takes 1 to {} samples at once, not {}",
          most_samples, places.size());
  HWY_DYNAMIC_DISPATCH(sample_tile)(frame, tile, pixels, places, buffer);
}

}  // namespace gradus::pipeline::engine
#endif
