#include "engine/samples_batch.hpp"

#include <algorithm>
#include <cmath>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/samples_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#include "engine/casts.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

static_assert(most_samples == block_cells);
/// In place of a triangle's number.
constexpr std::int32_t counted = -2;
using Whole = hn::CappedTag<std::int32_t, block_cells>;
using Single = hn::RebindToFloat<Whole>;
using I = hn::Vec<Whole>;
using F = hn::Vec<Single>;

HWY_INLINE F unsure(F nearness) {
  const Single d;
  return hn::Add(hn::Mul(nearness, hn::Set(d, unsure_share)), hn::Set(d, unsure_at_least));
}

class Sampling {
 public:
  Sampling(const Frame& frame, const Window& pixels, std::span<const ivec2> places, SampleBuffer& buffer)
      : frame_(frame), pixels_(pixels), places_(places), buffer_(buffer) {
    buffer.least.fill(-1);
    buffer.most.fill(-1);
    buffer.whole.fill(no_triangle);
    buffer.sampled.fill(-1);
    buffer.samples.clear();
    // Nothing is nearer than what lies beyond the window
    for (int y = 0; y < tile_side; ++y)
      for (int x = y < pixels.height() ? static_cast<int>(pixels.width()) : 0; x < tile_side; ++x)
        buffer.least[TileBuffer::cell({x, y})] = buffer.most[TileBuffer::cell({x, y})] = 2;
    for (std::size_t s = 0; s < most_samples; ++s) {
      const ivec2 from_centre = places[std::min(s, places.size() - 1)] - triangle_coverage::subpixels / 2;
      right_[s] = from_centre.x;
      down_[s] = from_centre.y;
    }
  }

  void draw(std::int32_t id) {
    const FrameTriangle& t = frame_.triangle(id);
    const Window box = squares_of(t.grid, pixels_);
    if (box.empty()) return;
    if (1 - std::min(std::min(t.depth.x, t.depth.y), t.depth.z) < farthest_) return;
    Cast cast = cast_of(t, box, pixels_.lower);
    bool long_sides = false;
    const Window blocks = in_blocks(cast.box);
    for (std::size_t k = 0; k < 3; ++k) {
      Side& side = cast.sides[k];
      const std::int64_t half = half_pixel(side);
      if (largest(side, cast.box) < -half) return;
      // It leaves out nothing, and may be too far for 32 bits
      if (least(side, blocks) >= half)
        side = {1 << 20, 0, 0};
      else
        long_sides |= 2 * half >= 1 << 23;
    }
    if (!is_flat_enough(cast, t.depth) || long_sides)
      draw_exactly(t, cast, id);
    else
      draw_blocks(cast, id);
    since_ += static_cast<int>(box.width() * box.height());
    if (since_ >= 1024) look_back();
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
    auto least = hn::Set(d, 2.0f);
    for (std::size_t i = 0; i < SampleBuffer::cells; i += hn::Lanes(d))
      least = hn::Min(least, hn::Load(d, buffer_.least.data() + i));
    const float far = hn::GetLane(hn::MinOfLanes(d, least));
    farthest_ = far < 0 ? -1 : double{far} - double{unsure_at(far)};
  }

  /// What a triangle adds from sample to sample, and from cell to cell of a block.
  struct Steps {
    alignas(64) std::int32_t side_at_sample[3][most_samples];
    alignas(64) float rise_at_sample[most_samples];
    alignas(64) std::int32_t side_in_block[3][block_cells];
    alignas(64) float rise_in_block[block_cells];
  };

  HWY_INLINE void prepare(const Cast& cast, Steps& steps) const {
    const Whole whole;
    const Single single;
    alignas(64) static constexpr std::int32_t across[block_cells] = {0, 1, 2, 3, 0, 1, 2, 3,
                                                                     0, 1, 2, 3, 0, 1, 2, 3};
    alignas(64) static constexpr std::int32_t below[block_cells] = {0, 0, 0, 0, 1, 1, 1, 1,
                                                                    2, 2, 2, 2, 3, 3, 3, 3};
    const auto right = hn::Set(single, static_cast<float>(cast.plane.right)),
               lower = hn::Set(single, static_cast<float>(cast.plane.down)),
               part = hn::Set(single, 1.0f / triangle_coverage::subpixels);
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(whole)) {
      const auto x = hn::Load(whole, across + i), y = hn::Load(whole, below + i);
      const auto dx = hn::Load(whole, right_ + i), dy = hn::Load(whole, down_ + i);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto a = hn::Set(whole, static_cast<std::int32_t>(cast.sides[k].a)),
                   b = hn::Set(whole, static_cast<std::int32_t>(cast.sides[k].b));
        hn::Store(hn::Add(hn::Mul(a, x), hn::Mul(b, y)), whole, steps.side_in_block[k] + i);
        // The edge function there, over 256 and rounded down, less that of the centre
        const auto rest = hn::Set(whole, static_cast<std::int32_t>(cast.origin[k] & 255));
        const auto there = hn::Add(hn::Add(hn::Mul(a, dx), hn::Mul(b, dy)), rest);
        hn::Store(hn::ShiftRight<8>(there), whole, steps.side_at_sample[k] + i);
      }
      const auto rise = [&](I along, I up) {
        return hn::Add(hn::Mul(right, hn::ConvertTo(single, along)),
                       hn::Mul(lower, hn::ConvertTo(single, up)));
      };
      hn::Store(rise(x, y), single, steps.rise_in_block + i);
      hn::Store(hn::Mul(rise(dx, dy), part), single, steps.rise_at_sample + i);
    }
  }

  HWY_INLINE void draw_blocks(const Cast& cast, std::int32_t id) {
    Steps steps;
    prepare(cast, steps);
    const Window& box = cast.box;
    std::int32_t half[3];
    for (std::size_t k = 0; k < 3; ++k) half[k] = static_cast<std::int32_t>(half_pixel(cast.sides[k]));
    const double slope = (std::abs(cast.plane.right) + std::abs(cast.plane.down)) / 2;
    for (int y = box.lower.y / block_side; y <= box.upper.y / block_side; ++y) {
      for (int x = box.lower.x / block_side; x <= box.upper.x / block_side; ++x) {
        const ivec2 first = block_side * ivec2{x, y};
        std::int32_t at[3];
        for (std::size_t k = 0; k < 3; ++k) {
          const Side& s = cast.sides[k];
          at[k] = static_cast<std::int32_t>(s.at + s.a * first.x + s.b * first.y);
        }
        const double near = cast.plane.at + cast.plane.right * first.x + cast.plane.down * first.y;
        draw_block(first, at, half, static_cast<float>(near), static_cast<float>(slope), steps, id);
      }
    }
  }

  HWY_INLINE void draw_block(ivec2 first, const std::int32_t (&at)[3], const std::int32_t (&half)[3],
                             float near, float slope, const Steps& steps, std::int32_t id) {
    const Whole whole;
    const Single single;
    const std::size_t base = TileBuffer::cell(first);
    for (std::size_t i = 0; i < block_cells; i += hn::Lanes(whole)) {
      // Of the three sides how far the centre is inside, at least, beside what a pixel reaches
      const auto side = [&](std::size_t k) {
        return hn::Add(hn::Set(whole, at[k]), hn::Load(whole, steps.side_in_block[k] + i));
      };
      const auto e0 = side(0), e1 = side(1), e2 = side(2);
      const auto reach = [&](I e, std::size_t k, int sign) {
        return hn::Add(e, hn::Set(whole, sign * half[k]));
      };
      const auto out = hn::Or(hn::Or(reach(e0, 0, 1), reach(e1, 1, 1)), reach(e2, 2, 1));
      const auto in = hn::Or(hn::Or(reach(e0, 0, -1), reach(e1, 1, -1)), reach(e2, 2, -1));
      const auto zero = hn::Zero(whole);
      const auto touched = hn::RebindMask(single, hn::Not(hn::Lt(out, zero)));
      if (hn::AllFalse(single, touched)) continue;
      const auto full = hn::RebindMask(single, hn::Not(hn::Lt(in, zero)));
      const auto middle = hn::Add(hn::Set(single, near), hn::Load(single, steps.rise_in_block + i));
      const auto less = hn::Sub(middle, hn::Set(single, slope)),
                 more = hn::Add(middle, hn::Set(single, slope));
      float* const least = buffer_.least.data() + base + i;
      float* const most = buffer_.most.data() + base + i;
      const auto old_least = hn::Load(single, least), old_most = hn::Load(single, most);
      const auto seen = hn::And(touched, hn::Not(hn::Lt(more, hn::Sub(old_least, unsure(old_least)))));
      if (hn::AllFalse(single, seen)) continue;
      const auto takes = hn::And(hn::And(seen, full), hn::Gt(less, hn::Add(old_most, unsure(old_most))));
      hn::BlendedStore(less, takes, single, least);
      hn::BlendedStore(more, takes, single, most);
      hn::BlendedStore(hn::Set(whole, id), hn::RebindMask(whole, takes), whole,
                       buffer_.whole.data() + base + i);
      const auto rest = hn::AndNot(takes, seen);
      if (hn::AllFalse(single, rest)) continue;
      alignas(64) std::int32_t wanted[block_cells], sides[3][block_cells];
      alignas(64) float nearness[block_cells];
      hn::Store(hn::VecFromMask(whole, hn::RebindMask(whole, rest)), whole, wanted);
      hn::Store(e0, whole, sides[0]);
      hn::Store(e1, whole, sides[1]);
      hn::Store(e2, whole, sides[2]);
      hn::Store(middle, single, nearness);
      for (std::size_t k = 0; k < hn::Lanes(whole); ++k)
        if (wanted[k] != 0)
          sample(base + i + k, {sides[0][k], sides[1][k], sides[2][k]}, nearness[k], steps, id);
    }
  }

  HWY_INLINE PixelSamples& samples_of(std::size_t cell) {
    std::int32_t& place = buffer_.sampled[cell];
    if (place < 0) {
      place = static_cast<std::int32_t>(buffer_.samples.size());
      PixelSamples& fresh = buffer_.samples.emplace_back();
      fresh.nearness.fill(-1);
      fresh.ids.fill(no_triangle);
    }
    return buffer_.samples[static_cast<std::size_t>(place)];
  }

  HWY_INLINE void sample(std::size_t cell, const std::array<std::int32_t, 3>& at, float near,
                         const Steps& steps, std::int32_t id) {
    const Whole whole;
    const Single single;
    PixelSamples* of = nullptr;
    for (std::size_t i = 0; i < most_samples; i += hn::Lanes(whole)) {
      const auto side = [&](std::size_t k) {
        return hn::Add(hn::Set(whole, at[k]), hn::Load(whole, steps.side_at_sample[k] + i));
      };
      const auto signs = hn::Or(hn::Or(side(0), side(1)), side(2));
      const auto inside = hn::RebindMask(single, hn::Not(hn::Lt(signs, hn::Zero(whole))));
      if (hn::AllFalse(single, inside)) continue;
      if (!of) of = &samples_of(cell);
      const auto mine = hn::Add(hn::Set(single, near), hn::Load(single, steps.rise_at_sample + i));
      const auto old = hn::Load(single, of->nearness.data() + i);
      const auto nearer = hn::And(inside, hn::Gt(mine, hn::Add(old, unsure(old))));
      const auto open = hn::AndNot(nearer, hn::And(inside, hn::Ge(mine, hn::Sub(old, unsure(old)))));
      hn::BlendedStore(mine, nearer, single, of->nearness.data() + i);
      hn::BlendedStore(hn::Set(whole, id), hn::RebindMask(whole, nearer), whole, of->ids.data() + i);
      if (hn::AllFalse(single, open)) continue;
      alignas(64) std::int32_t wanted[most_samples];
      alignas(64) float nearness[most_samples];
      hn::Store(hn::VecFromMask(whole, hn::RebindMask(whole, open)), whole, wanted);
      hn::Store(mine, single, nearness);
      for (std::size_t k = 0; k < hn::Lanes(whole); ++k)
        if (wanted[k] != 0) settle(*of, i + k, place_of(cell, i + k), nearness[k], id);
    }
  }

  /// Where a sample lies in the picture, in 1/256 pixel.
  ivec2 place_of(std::size_t cell, std::size_t s) const {
    return (pixels_.lower + TileBuffer::place(cell)) * triangle_coverage::subpixels +
           places_[std::min(s, places_.size() - 1)];
  }

  /// Where single precision does not decide.
  HWY_NOINLINE void settle(PixelSamples& of, std::size_t s, ivec2 place, float nearness, std::int32_t id) {
    if (!(exact_depth(frame_, id, place) < exact_depth(frame_, of.ids[s], place))) return;
    of.nearness[s] = nearness;
    of.ids[s] = id;
  }

  /// Pixel by pixel, for triangles too steep or too long for blocks.
  HWY_NOINLINE void draw_exactly(const FrameTriangle& t, const Cast& cast, std::int32_t id) {
    const auto edges = triangle_coverage::edges_of(t.grid);
    const double slope = (std::abs(cast.plane.right) + std::abs(cast.plane.down)) / 2;
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
          buffer_.whole[cell] = id;
        } else {
          sample_exactly(t, edges, cell, id);
        }
      }
    }
  }

  void sample_exactly(const FrameTriangle& t, const triangle_coverage::Edges& edges, std::size_t cell,
                      std::int32_t id) {
    const triangle_coverage::Linear depth(t.grid, t.depth);
    for (std::size_t s = 0; s < places_.size(); ++s) {
      const ivec2 place = place_of(cell, s);
      const auto w = weights_at_place(edges, place);
      if (!holds(edges, w)) continue;
      PixelSamples& of = samples_of(cell);
      const auto mine = static_cast<float>(1 - depth.at(w)), old = of.nearness[s];
      if (mine > old + unsure_at(old)) {
        of.nearness[s] = mine;
        of.ids[s] = id;
      } else if (mine >= old - unsure_at(old)) {
        settle(of, s, place, mine, id);
      }
    }
  }

  const Frame& frame_;
  Window pixels_;
  std::span<const ivec2> places_;
  SampleBuffer& buffer_;
  alignas(64) std::int32_t right_[most_samples];  ///< from the centre to the samples, in 1/256 pixel
  alignas(64) std::int32_t down_[most_samples];
  double farthest_ = -1;  ///< what is farther is seen nowhere
  int since_ = 0;         ///< pixels that boxes had since that was found
};

void sample_tile(const Frame& frame, int tile, const Window& pixels, std::span<const ivec2> places,
                 SampleBuffer& buffer) {
  Sampling sampling(frame, pixels, places, buffer);
  visit_tile(frame, tile, [&](std::int32_t id) { sampling.draw(id); });
}

/// The triangles that the samples of a pixel show: those that stand in `samples`, or the one that covers all.
HWY_INLINE void winners_of(const Frame& frame, const SampleBuffer& buffer, std::size_t cell, ivec2 pixel,
                           std::span<const ivec2> places, std::int32_t* winners) {
  const Whole whole;
  const Single single;
  const PixelSamples& own = buffer.samples[static_cast<std::size_t>(buffer.sampled[cell])];
  const std::int32_t other = buffer.whole[cell];
  const float from = buffer.least[cell] - unsure_at(buffer.least[cell]),
              to = buffer.most[cell] + unsure_at(buffer.most[cell]);
  for (std::size_t i = 0; i < most_samples; i += hn::Lanes(whole)) {
    const auto ids = hn::Load(whole, own.ids.data() + i);
    const auto nearness = hn::Load(single, own.nearness.data() + i);
    const auto mine = hn::Gt(nearness, hn::Set(single, to));
    hn::Store(hn::IfThenElse(hn::RebindMask(whole, mine), ids, hn::Set(whole, other)), whole, winners + i);
    const auto open = hn::AndNot(mine, hn::Ge(nearness, hn::Set(single, from)));
    if (other == no_triangle || hn::AllFalse(single, open)) continue;
    for (std::size_t s = i; s < std::min(i + hn::Lanes(whole), places.size()); ++s) {
      if (own.ids[s] == no_triangle || own.nearness[s] > to || own.nearness[s] < from) continue;
      const ivec2 there = pixel * triangle_coverage::subpixels + places[s];
      winners[s] =
          exact_depth(frame, own.ids[s], there) < exact_depth(frame, other, there) ? own.ids[s] : other;
    }
  }
}

void show_tile(const Frame& frame, const Window& pixels, std::span<const ivec2> places,
               const SampleBuffer& buffer, std::vector<ShownTriangle>& shown) {
  const Whole whole;
  alignas(64) std::int32_t winners[most_samples];
  for (std::size_t cell = 0; cell < SampleBuffer::cells; ++cell) {
    if (buffer.sampled[cell] < 0) continue;
    winners_of(frame, buffer, cell, pixels.lower + TileBuffer::place(cell), places, winners);
    // Those that are left to count
    auto left = static_cast<std::int32_t>(places.size());
    for (std::size_t s = 0; left > 0 && s < places.size(); ++s) {
      const std::int32_t id = winners[s];
      if (id == counted) continue;
      std::size_t times = 0;
      for (std::size_t i = 0; i < most_samples; i += hn::Lanes(whole)) {
        const auto there = hn::FirstN(whole, places.size() - std::min(i, places.size()));
        const auto all = hn::Load(whole, winners + i), one = hn::Set(whole, id);
        const auto same = hn::And(there, hn::Eq(all, one));
        times += hn::CountTrue(whole, same);
        hn::BlendedStore(hn::Set(whole, counted), same, whole, winners + i);
      }
      left -= static_cast<std::int32_t>(times);
      if (id != no_triangle) shown.push_back({cell, id, static_cast<std::int32_t>(times)});
    }
  }
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::pipeline::engine {
HWY_EXPORT(sample_tile);
HWY_EXPORT(show_tile);

void find_samples(const Frame& frame, int tile, const Window& pixels, std::span<const ivec2> places,
                  SampleBuffer& buffer) {
  expects(!places.empty() && places.size() <= most_samples, "a pixel takes 1 to {} samples at once, not {}",
          most_samples, places.size());
  HWY_DYNAMIC_DISPATCH(sample_tile)(frame, tile, pixels, places, buffer);
}

void find_shown(const Frame& frame, const Window& pixels, std::span<const ivec2> places,
                const SampleBuffer& buffer, std::vector<ShownTriangle>& shown) {
  HWY_DYNAMIC_DISPATCH(show_tile)(frame, pixels, places, buffer, shown);
}

}  // namespace gradus::pipeline::engine
#endif
