#include "engine/pieces_batch.hpp"

#include "core/contract.hpp"

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/pieces_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#include "engine/vertices_batch.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<std::int32_t, 16>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

HWY_INLINE V set(std::int32_t x) { return hn::Set(D(), x); }

struct Places {
  V x, y;
};

// So many vertices, of as many pieces one after the other their corner: x and y in turn
template <std::size_t count>
HWY_INLINE auto pairs_of(const ivec2* grid, const std::int32_t* corners) {
  const hn::CappedTag<std::int32_t, 2 * count> d;
  if constexpr (count == 1)
    return hn::LoadU(d, &grid[*corners].x);
  else
    // Found by its arguments: targets of one lane do without
    return Combine(d, pairs_of<count / 2>(grid, corners + 3 * (count / 2)),
                   pairs_of<count / 2>(grid, corners));
}

HWY_INLINE Places gathered(const ivec2* grid, V numbers) {
  const D d;
  const auto* words = &grid->x;
  const V twice = hn::ShiftLeft<1>(numbers);
  return {hn::GatherIndex(d, words, twice), hn::GatherIndex(d, words, hn::Add(twice, set(1)))};
}

struct Corners {
  Places a, b, c;
};

// numbers: of the vertices of as many pieces as registers hold
template <std::size_t lanes>
HWY_INLINE Corners corners_of(const ivec2* grid, const std::int32_t* numbers) {
  const hn::CappedTag<std::int32_t, lanes> d;
  if constexpr (lanes == 4 || lanes == 8) {
    // Both numbers of a vertex at once: a gather is microcode on processors of AMD
    const auto corner = [&](int which) -> Places {
      const auto lower = pairs_of<lanes / 2>(grid, numbers + which),
                 upper = pairs_of<lanes / 2>(grid, numbers + which + 3 * (lanes / 2));
      return {ConcatEven(d, upper, lower), ConcatOdd(d, upper, lower)};
    };
    return {corner(0), corner(1), corner(2)};
  } else {
    V a, b, c;
    hn::LoadInterleaved3(d, numbers, a, b, c);
    return {gathered(grid, a), gathered(grid, b), gathered(grid, c)};
  }
}

// Whether all are less than 2^15 in size
HWY_INLINE M all_small(V a, V b, V c, V e) {
  const V sizes = hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Max(hn::Abs(c), hn::Abs(e)));
  return hn::Lt(sizes, set(1 << 15));
}

// Pixels of the window in the range of one axis, from the first to the last
struct Range {
  V from, to;
};
HWY_INLINE Range range_of(V a, V b, V c, int lower, int upper, int margin) {
  const V least = hn::Min(hn::Min(a, b), c), most = hn::Max(hn::Max(a, b), c);
  // By their centres, or by where they begin and end
  const int centre = margin == 0 ? 128 : 0;
  const V first = hn::ShiftRight<8>(hn::Add(least, set(centre > 0 ? centre - 1 : -256 * margin))),
          last = hn::ShiftRight<8>(hn::Add(most, set(centre > 0 ? -centre : 256 * margin)));
  return {hn::Max(first, set(lower)), hn::Min(last, set(upper))};
}
HWY_INLINE M is_empty(const Range& range) { return hn::Gt(range.from, range.to); }
HWY_INLINE M is_short(const Range& range) { return hn::Lt(hn::Sub(range.to, range.from), set(2)); }

// A side of a triangle, with the inside on its positive side: triangle_coverage::Edge
struct Edge {
  Places from;
  V dx, dy, least;  // least: what a place that belongs has
};
HWY_INLINE Edge edge_of(const Places& a, const Places& b, M turned) {
  const auto along = [&](V p, V q) {
    const V way = hn::Sub(q, p);
    return hn::IfThenElse(turned, hn::Neg(way), way);
  };
  const V dx = along(a.x, b.x), dy = along(a.y, b.y), none = hn::Zero(D());
  const M owns = hn::Or(hn::Lt(dy, none), hn::And(hn::Eq(dy, none), hn::Gt(dx, none)));
  return {a, dx, dy, hn::IfThenElse(owns, none, set(1))};
}
HWY_INLINE M belongs(const Edge& edge, V x, V y) {
  const V at = hn::Sub(hn::Mul(edge.dx, hn::Sub(y, edge.from.y)), hn::Mul(edge.dy, hn::Sub(x, edge.from.x)));
  return hn::Not(hn::Lt(at, edge.least));
}

// Whether a triangle covers one of the four centres at the ends of two ranges. Exact for triangles of less
// than 128 pixels, where the centres lie in their boxes
HWY_INLINE M covers_one(const Places& a, const Places& b, const Places& c, V area, const Range& columns,
                        const Range& rows) {
  const M turned = hn::Lt(area, hn::Zero(D()));
  const Edge ab = edge_of(a, b, turned), bc = edge_of(b, c, turned), ca = edge_of(c, a, turned);
  const auto centre = [](V pixel) { return hn::Add(hn::ShiftLeft<8>(pixel), set(128)); };
  const V left = centre(columns.from), right = centre(columns.to), up = centre(rows.from),
          down = centre(rows.to);
  const auto covers = [&](V x, V y) {
    return hn::And(hn::And(belongs(ab, x, y), belongs(bc, x, y)), belongs(ca, x, y));
  };
  return hn::Or(hn::Or(covers(left, up), covers(right, up)), hn::Or(covers(left, down), covers(right, down)));
}

PieceCount choose_all(const PieceChoice& choice, const PieceVertices* pieces, std::size_t count,
                      const ivec2* grid, std::int32_t first, Left* left) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  const auto [window, margin, two_sided, mirrored] = choice;
  const hn::RebindToUnsigned<D> du;
  auto* const out = reinterpret_cast<std::uint32_t*>(left);
  std::size_t kept = 0;
  PieceCount total;
  const auto count_of = [d](M which) { return static_cast<std::int64_t>(hn::CountTrue(d, which)); };
  for (std::size_t i = 0; i < count; i += lanes) {
    const M there = hn::FirstN(d, count - i);
    const std::int32_t* numbers = pieces[i].data();
    std::array<std::int32_t, 3 * hn::MaxLanes(D())> rest{};
    if (i + lanes > count) {
      for (std::size_t k = 0; k < 3 * (count - i); ++k) rest[k] = pieces[i + k / 3][k % 3];
      numbers = rest.data();
    }
    const Corners corners = corners_of<hn::MaxLanes(D())>(grid, numbers);
    const Places &a = corners.a, &b = mirrored ? corners.c : corners.b, &c = mirrored ? corners.b : corners.c;
    // Beyond the same plane with all corners: nothing is left. Beyond one with some: unsure
    const M a_out = hn::Eq(a.x, set(beyond)), b_out = hn::Eq(b.x, set(beyond)),
            c_out = hn::Eq(c.x, set(beyond));
    const M some_out = hn::Or(a_out, hn::Or(b_out, c_out));
    const M all_out =
        hn::And(hn::And(a_out, b_out), hn::And(c_out, hn::Ne(hn::And(hn::And(a.y, b.y), c.y), set(0))));
    // Twice the area, and by how much snapping may have changed it
    const V ux = hn::Sub(b.x, a.x), uy = hn::Sub(b.y, a.y), vx = hn::Sub(c.x, a.x), vy = hn::Sub(c.y, a.y);
    const M small = hn::AndNot(some_out, all_small(ux, uy, vx, vy));
    const V area = hn::Sub(hn::Mul(ux, vy), hn::Mul(uy, vx));
    const V slack =
        hn::Add(hn::Add(hn::Add(hn::Abs(ux), hn::Abs(uy)), hn::Add(hn::Abs(vx), hn::Abs(vy))), set(4));
    const M behind = hn::And(small, hn::Gt(area, slack));
    const M front = hn::And(small, hn::Lt(area, hn::Neg(slack)));
    const M without_area = hn::And(small, hn::Eq(area, set(0)));
    const Range columns = range_of(a.x, b.x, c.x, window.lower.x, window.upper.x, margin),
                rows = range_of(a.y, b.y, c.y, window.lower.y, window.upper.y, margin);
    M asked = hn::Not(hn::Or(is_empty(columns), is_empty(rows)));
    if (margin == 0) {
      const M few = hn::And(small, hn::And(is_short(columns), is_short(rows)));
      asked = hn::AndNot(hn::AndNot(covers_one(a, b, c, area, columns, rows), few), asked);
    }
    asked = hn::Or(some_out, asked);
    const M cut_away = hn::And(there, all_out);
    const M in_view = hn::AndNot(all_out, there);
    const M turned = two_sided ? hn::AndNot(behind, behind) : hn::And(in_view, behind);
    const M flat = hn::And(in_view, without_area);
    const M sided = hn::AndNot(hn::Or(turned, flat), in_view);
    const M keep = hn::And(sided, asked);
    total.beyond_plane += count_of(cut_away);
    total.turned_away += count_of(turned);
    total.without_area += count_of(flat);
    total.without_pixel += count_of(hn::AndNot(asked, sided));
    const V seen = hn::IfThenElse(front, set(0), hn::IfThenElse(behind, set(1), set(2)));
    const V number = hn::Add(hn::Iota(d, 0), set(first + static_cast<std::int32_t>(i)));
    const V word = hn::Or(hn::ShiftLeft<2>(number), seen);
    if (i + lanes <= count) {
      // There is room for all lanes; a store of some takes several times as long
      hn::StoreU(hn::Compress(hn::BitCast(du, word), hn::RebindMask(du, keep)), du, out + kept);
      kept += hn::CountTrue(d, keep);
    } else {
      std::array<std::uint32_t, hn::MaxLanes(D())> last{};
      const std::size_t more =
          hn::CompressBlendedStore(hn::BitCast(du, word), hn::RebindMask(du, keep), du, last.data());
      for (std::size_t k = 0; k < more; ++k) out[kept++] = last[k];
    }
  }
  total.left = static_cast<std::int64_t>(kept);
  return total;
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::pipeline::engine {
HWY_EXPORT(choose_all);

PieceCount choose_pieces(const PieceChoice& choice, std::span<const PieceVertices> pieces, const ivec2* grid,
                         std::int32_t first, std::span<Left> left) {
  expects(left.size() >= pieces.size(), "there is room for {} of {} pieces", left.size(), pieces.size());
  return HWY_DYNAMIC_DISPATCH(choose_all)(choice, pieces.data(), pieces.size(), grid, first, left.data());
}

}  // namespace gradus::pipeline::engine
#endif
