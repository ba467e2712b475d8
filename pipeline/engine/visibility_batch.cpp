#include "engine/visibility_batch.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/visibility_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#ifndef GRADUS_ENGINE_VISIBILITY_ONCE
#define GRADUS_ENGINE_VISIBILITY_ONCE
namespace gradus::pipeline::engine {

/// Depths in single precision differ surely by more than this share and this much.
inline constexpr float unsure_share = 0x1p-19f, unsure_at_least = 0x1p-27f;

/// The depth of a triangle at a pixel by the textbook's arithmetic, and what decides between equal ones.
struct ExactDepth {
  double depth;
  PieceId piece;
  std::int32_t id;

  friend bool operator<(const ExactDepth& a, const ExactDepth& b) {
    return std::tie(a.depth, a.piece, a.id) < std::tie(b.depth, b.piece, b.id);
  }
};

inline PieceId piece_of(const Frame& frame, const FrameTriangle& t, std::int32_t id) {
  if (t.cut) return frame.cut_triangle(id).id;
  const FrameObject& object = frame.object_of(t);
  const MeshPiece& piece = object.pieces->of_faces[static_cast<std::size_t>(t.piece)];
  return {object.number, piece.face, piece.piece};
}

inline ExactDepth exact_depth(const Frame& frame, std::int32_t id, ivec2 pixel) {
  const FrameTriangle& t = frame.triangle(id);
  const auto weights =
      weights_at_place(triangle_coverage::edges_of(t.grid), triangle_coverage::centre_of(pixel));
  return {triangle_coverage::Linear(t.grid, t.depth).at(weights), piece_of(frame, t, id), id};
}

/// One side of a triangle over the pixels of a tile: at + a x + b y >= 0 for those inside, x and y counted
/// from the tile's upper left.
struct Side {
  std::int64_t at, a, b;
};

/// The edge function over 256, rounded down, which keeps its sign; less by one where the edge does not own
/// what lies on it. there: the edge function in the centre that x and y are counted from.
HWY_INLINE Side side_of(const triangle_coverage::Edge& edge, std::int64_t there) {
  return {(there - !edge.owns) >> 8, std::int64_t{edge.from.y} - edge.to.y,
          std::int64_t{edge.to.x} - edge.from.x};
}

/// The least and the largest value over a box.
HWY_INLINE std::int64_t least(const Side& s, const Window& box) {
  return s.at + std::min(s.a * box.lower.x, s.a * box.upper.x) +
         std::min(s.b * box.lower.y, s.b * box.upper.y);
}
HWY_INLINE std::int64_t largest(const Side& s, const Window& box) {
  return s.at + std::max(s.a * box.lower.x, s.a * box.upper.x) +
         std::max(s.b * box.lower.y, s.b * box.upper.y);
}

/// The pixels of the blocks that a box meets.
inline Window in_blocks(const Window& box) {
  return {box.lower / block_side * block_side,
          box.upper / block_side * block_side + ivec2{block_side - 1, block_side - 1}};
}

/// 1 - depth over the pixels of a tile.
struct NearnessPlane {
  double at, right, down;
};

/// A triangle over a tile.
struct Cast {
  Window box;  ///< pixels that it may cover, counted from the tile's upper left
  std::array<Side, 3> sides;
  NearnessPlane plane;
};

/// How a triangle lies over a tile. box: not empty.
HWY_INLINE Cast cast_of(const FrameTriangle& t, const Window& box, ivec2 origin) {
  const auto edges = triangle_coverage::edges_of(t.grid);
  const ivec2 there = triangle_coverage::centre_of(origin);
  const std::int64_t second = edges[1].at(there), third = edges[2].at(there);
  Cast cast;
  cast.box = {box.lower - origin, box.upper - origin};
  cast.sides = {side_of(edges[0], edges[0].at(there)), side_of(edges[1], second), side_of(edges[2], third)};
  const double over_area = 1 / static_cast<double>(std::abs(triangle_coverage::doubled_area(t.grid)));
  const double to_second = (t.depth.x - t.depth.y) * over_area,
               to_third = (t.depth.x - t.depth.z) * over_area;
  const auto mixed = [&](std::int64_t a, std::int64_t b) {
    return static_cast<double>(a) * to_second + static_cast<double>(b) * to_third;
  };
  constexpr int step = triangle_coverage::subpixels;
  cast.plane = {(1 - t.depth.x) + mixed(second, third), step * mixed(cast.sides[1].a, cast.sides[2].a),
                step * mixed(cast.sides[1].b, cast.sides[2].b)};
  return cast;
}

/// Whether single precision stays within the shares above.
HWY_INLINE bool is_flat_enough(const NearnessPlane& plane, const dvec3& depth) {
  const double slope = std::abs(plane.right) + std::abs(plane.down);
  const double least_nearness = 1 - std::max(std::max(depth.x, depth.y), depth.z);
  return slope <= std::max(least_nearness / 2, 0x1p-9);
}

}  // namespace gradus::pipeline::engine
#endif

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
      if (least(side, blocks) >= 0) side = {0, 0, 0};
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
    const ivec2 pixel = pixels_.lower + at;
    if (exact_depth(frame_, id, pixel) < exact_depth(frame_, buffer_.ids[cell], pixel)) {
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
