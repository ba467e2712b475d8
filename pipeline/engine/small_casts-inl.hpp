// Up to sixteen triangles beside a tile at once: which of them it shows nothing of, and of small ones all
// that their blocks are drawn by. Compiled once for every kind of machine, as shading_lanes-inl.hpp is.
#if defined(GRADUS_ENGINE_SMALL_CASTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRADUS_ENGINE_SMALL_CASTS_INL_HPP
#undef GRADUS_ENGINE_SMALL_CASTS_INL_HPP
#else
#define GRADUS_ENGINE_SMALL_CASTS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <span>

#include "engine/blocks-inl.hpp"
#include "engine/casts.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Triangles that are set up at once.
constexpr std::size_t casts_at_once = 16;
/// A small triangle is less wide and high, in 1/256 pixel: its edge functions have 30 bits at most.
constexpr std::int32_t small_side = 16 * triangle_coverage::subpixels;

/// Small triangles, side by side. Edge functions are less by one where what lies on them is not owned, so
/// that they are at least 0 inside; they and the nearness are those of the first pixel of the first block.
struct SmallCasts {
  template <class T>
  using Lanes = T[casts_at_once];

  alignas(64) Lanes<std::int32_t> first_column, last_column, first_row, last_row;  ///< of its blocks
  alignas(64) Lanes<std::int32_t> at[3], a[3], b[3];  ///< edge functions, and what a pixel adds
  alignas(64) Lanes<double> near, right, down;        ///< 1 - depth, and what a pixel adds
};

/// Bits of triangles.
struct CastKinds {
  std::uint32_t small, others;
};

/// Corners and depths of triangles, side by side; corners from the upper left of the tile.
struct CastCorners {
  alignas(64) std::int32_t x[3][casts_at_once], y[3][casts_at_once];
  alignas(64) double depth[3][casts_at_once];
};

/// Returns the bits of those that have the depths of a shared plane.
HWY_INLINE std::uint32_t take_corners(const Frame& frame, std::span<const std::int32_t> ids, ivec2 origin,
                                      CastCorners& corners) {
  std::uint32_t shared = 0;
  const ivec2 from = origin * triangle_coverage::subpixels;
  for (std::size_t i = 0; i < casts_at_once; ++i) {
    const FrameTriangle& t = frame.triangle(ids[std::min(i, ids.size() - 1)]);
    for (std::size_t k = 0; k < 3; ++k) {
      corners.x[k][i] = t.grid[k].x - from.x;
      corners.y[k][i] = t.grid[k].y - from.y;
      corners.depth[k][i] = t.depth[static_cast<int>(k)];
    }
    shared |= std::uint32_t{t.plane != no_plane} << i;
  }
  return shared;
}

/// Pixels on one axis whose centres lie between the least and the largest of three corners.
struct Pixels {
  I first, last;
  hn::Mask<Whole> few;  ///< the corners are close together
};
HWY_INLINE Pixels pixels_between(I a, I b, I c, std::int64_t count) {
  const Whole d;
  constexpr int half = triangle_coverage::subpixels / 2;
  const I least = hn::Min(hn::Min(a, b), c), most = hn::Max(hn::Max(a, b), c);
  return {hn::Max(hn::ShiftRight<8>(hn::Add(least, hn::Set(d, half - 1))), hn::Zero(d)),
          hn::Min(hn::ShiftRight<8>(hn::Sub(most, hn::Set(d, half))),
                  hn::Set(d, static_cast<std::int32_t>(count) - 1)),
          hn::Lt(hn::Sub(most, least), hn::Set(d, small_side))};
}

/// Twice the areas, and the second and third edge function in the first pixel, before ownership.
struct CastAreas {
  alignas(64) std::int32_t area[casts_at_once], second[casts_at_once], third[casts_at_once];
};

/// The edge functions of small triangles, from lane i on: those of triangle_coverage::edges_of.
HWY_INLINE void set_sides(const CastCorners& corners, std::size_t i, I first_column, I first_row,
                          SmallCasts& casts, CastAreas& areas) {
  const Whole d;
  const auto x = [&](std::size_t k) { return hn::Load(d, corners.x[k] + i); };
  const auto y = [&](std::size_t k) { return hn::Load(d, corners.y[k] + i); };
  const I area = hn::Sub(hn::Mul(hn::Sub(x(1), x(0)), hn::Sub(y(2), y(0))),
                         hn::Mul(hn::Sub(y(1), y(0)), hn::Sub(x(2), x(0))));
  const auto turned = hn::Lt(area, hn::Zero(d));
  hn::Store(hn::Abs(area), d, areas.area + i);
  const auto centre = [&](I block) {
    return hn::Add(hn::ShiftLeft<10>(block), hn::Set(d, triangle_coverage::subpixels / 2));
  };
  const I px = centre(first_column), py = centre(first_row);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t from = (k + 1) % 3, to = (k + 2) % 3;
    const auto along = [&](I p, I q) {
      const I way = hn::Sub(q, p);
      return hn::IfThenElse(turned, hn::Neg(way), way);
    };
    const I dx = along(x(from), x(to)), dy = along(y(from), y(to)), zero = hn::Zero(d);
    const I at = hn::Sub(hn::Mul(dx, hn::Sub(py, y(from))), hn::Mul(dy, hn::Sub(px, x(from))));
    const auto owns = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Gt(dx, zero)));
    hn::Store(hn::Sub(at, hn::IfThenZeroElse(owns, hn::Set(d, 1))), d, casts.at[k] + i);
    hn::Store(hn::ShiftLeft<8>(hn::Neg(dy)), d, casts.a[k] + i);
    hn::Store(hn::ShiftLeft<8>(dx), d, casts.b[k] + i);
    if (k == 1) hn::Store(at, d, areas.second + i);
    if (k == 2) hn::Store(at, d, areas.third + i);
  }
}

/// The planes of the nearness: that of cast_of. Returns the bits of those that are flat enough.
HWY_INLINE std::uint32_t set_planes(const CastCorners& corners, const CastAreas& areas, SmallCasts& casts) {
  using D = hn::CappedTag<double, casts_at_once>;
  const D d;
  const hn::Rebind<std::int32_t, D> whole;
  std::uint32_t flat = 0;
  for (std::size_t i = 0; i < casts_at_once; i += hn::Lanes(d)) {
    const auto wide = [&](const std::int32_t* from) { return hn::PromoteTo(d, hn::Load(whole, from + i)); };
    const auto first = hn::Load(d, corners.depth[0] + i), second = hn::Load(d, corners.depth[1] + i),
               third = hn::Load(d, corners.depth[2] + i), one = hn::Set(d, 1.0);
    const auto over_area = hn::Div(one, wide(areas.area));
    const auto to_second = hn::Mul(hn::Sub(first, second), over_area),
               to_third = hn::Mul(hn::Sub(first, third), over_area);
    const auto mixed = [&](const std::int32_t* a, const std::int32_t* b) {
      return hn::Add(hn::Mul(wide(a), to_second), hn::Mul(wide(b), to_third));
    };
    const auto right = mixed(casts.a[1], casts.a[2]), down = mixed(casts.b[1], casts.b[2]);
    hn::Store(hn::Add(hn::Sub(one, first), mixed(areas.second, areas.third)), d, casts.near + i);
    hn::Store(right, d, casts.right + i);
    hn::Store(down, d, casts.down + i);
    const auto least = hn::Sub(one, hn::Max(hn::Max(first, second), third));
    const auto slope = hn::Add(hn::Abs(right), hn::Abs(down));
    const auto is_flat = hn::Le(slope, hn::Max(hn::Mul(least, hn::Set(d, 0.5)), hn::Set(d, 0x1p-9)));
    flat |= bits_of(d, is_flat) << i;
  }
  return flat;
}

/// The bits of the triangles of which some corner is as near as this, or nearer.
HWY_INLINE std::uint32_t reaching(const CastCorners& corners, double nearness) {
  using D = hn::CappedTag<double, casts_at_once>;
  const D d;
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < casts_at_once; i += hn::Lanes(d)) {
    const auto depth = [&](std::size_t k) { return hn::Load(d, corners.depth[k] + i); };
    const auto nearest = hn::Sub(hn::Set(d, 1.0), hn::Min(hn::Min(depth(0), depth(1)), depth(2)));
    bits |= bits_of(d, hn::Ge(nearest, hn::Set(d, nearness))) << i;
  }
  return bits;
}

/// Sets up to casts_at_once triangles beside a tile. Those of neither kind show nothing: their box holds no
/// centre of the tile's pixels, or all of them is farther than `farthest`.
HWY_INLINE CastKinds cast_some(const Frame& frame, std::span<const std::int32_t> ids, const Window& pixels,
                               double farthest, SmallCasts& casts) {
  const Whole d;
  CastCorners corners;
  CastAreas areas;
  const std::uint32_t shared = take_corners(frame, ids, pixels.lower, corners);
  std::uint32_t there = (1U << ids.size()) - 1, small = 0, asked = 0;
  if (farthest >= 0) there &= reaching(corners, farthest);
  if (there == 0) return {0, 0};
  for (std::size_t i = 0; i < casts_at_once; i += hn::Lanes(d)) {
    const auto between = [&](const auto& at, std::int64_t count) {
      return pixels_between(hn::Load(d, at[0] + i), hn::Load(d, at[1] + i), hn::Load(d, at[2] + i), count);
    };
    const Pixels columns = between(corners.x, pixels.width()), rows = between(corners.y, pixels.height());
    const auto empty = hn::Or(hn::Gt(columns.first, columns.last), hn::Gt(rows.first, rows.last));
    asked |= bits_of(d, hn::Not(empty)) << i;
    small |= bits_of(d, hn::And(columns.few, rows.few)) << i;
    const I column = hn::ShiftRight<2>(columns.first), row = hn::ShiftRight<2>(rows.first);
    hn::Store(column, d, casts.first_column + i);
    hn::Store(row, d, casts.first_row + i);
    hn::Store(hn::ShiftRight<2>(columns.last), d, casts.last_column + i);
    hn::Store(hn::ShiftRight<2>(rows.last), d, casts.last_row + i);
    set_sides(corners, i, column, row, casts, areas);
  }
  there &= asked;
  small &= there & ~shared;
  if (small != 0) small &= set_planes(corners, areas, casts);
  return {small, there & ~small};
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
