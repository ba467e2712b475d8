#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_batch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "clipping/cohen_sutherland_2d/cohen_sutherland_2d_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gradus::cohen_sutherland_2d::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

constexpr double largest = 0x1p300;

// A difference and what its rounding took away (two_sum), and its value in two parts of at most 26 and 27
// bits, so that products of parts are exact
struct Parts {
  V value, error, high, low;
};

HWY_INLINE V two_sum_error(V a, V b, V sum) {
  const V b_kept = hn::Sub(sum, a);
  const V a_kept = hn::Sub(sum, b_kept);
  return hn::Add(hn::Sub(a, a_kept), hn::Sub(b, b_kept));
}

HWY_INLINE V high_part(V x) {
  const hn::RebindToUnsigned<D> bits;
  return hn::And(x, hn::BitCast(D(), hn::Set(bits, ~((std::uint64_t{1} << 27) - 1))));
}

HWY_INLINE Parts difference(V a, V b) {
  const V value = hn::Sub(a, b);
  const V high = high_part(value);
  return {value, two_sum_error(a, hn::Neg(b), value), high, hn::Sub(value, high)};
}

HWY_INLINE Parts choose(M mask, const Parts& yes, const Parts& no) {
  return {hn::IfThenElse(mask, yes.value, no.value), hn::IfThenElse(mask, yes.error, no.error),
          hn::IfThenElse(mask, yes.high, no.high), hn::IfThenElse(mask, yes.low, no.low)};
}

struct Sure {
  V value;
  M sure;
};

// base + way * rise / length: the nearest double where that is certain. The same thought as
// cut_coordinate_filtered, with shorter products: the quotient is wrong by less than 2^-75 of it
HWY_INLINE Sure nearest_sum(V base, const Parts& way, const Parts& rise, const Parts& length) {
  const D d;
  const V product = hn::Mul(way.value, rise.value);
  const V inverse = hn::Div(hn::Set(d, 1.0), length.value);
  const V quotient = hn::Mul(product, inverse);
  const V high = high_part(quotient), low = hn::Sub(quotient, high);

  // way * rise - quotient * length: the large parts cancel exactly, then the middle ones, then the rest
  const V first = hn::Sub(hn::Mul(way.high, rise.high), hn::Mul(high, length.high));
  const V second = hn::Sub(hn::Mul(way.high, rise.low), hn::Mul(high, length.low));
  const V third = hn::Sub(hn::Mul(way.low, rise.high), hn::Mul(low, length.high));
  const V fourth = hn::Sub(hn::Mul(way.low, rise.low), hn::Mul(low, length.low));
  const V errors = hn::Sub(hn::Add(hn::Mul(way.value, rise.error), hn::Mul(way.error, rise.value)),
                           hn::Mul(quotient, length.error));
  const V left_over = hn::Add(hn::Add(first, hn::Add(second, third)), hn::Add(fourth, errors));

  // Add it up, and ask whether the bound could reach another double
  const V sum = hn::Add(base, quotient);
  const V rest = hn::Add(two_sum_error(base, quotient, sum), hn::Mul(left_over, inverse));
  const V bound = hn::Add(
      hn::Add(hn::Mul(hn::Abs(quotient), hn::Set(d, 0x1p-72)), hn::Mul(hn::Abs(sum), hn::Set(d, 0x1p-100))),
      hn::Set(d, 0x1p-1060));
  const V highest = hn::Add(sum, hn::Add(rest, bound));
  const V lowest = hn::Add(sum, hn::Sub(rest, bound));
  // Products that are nearly 0 have lost digits
  const M full = hn::Or(hn::Ge(hn::Abs(product), hn::Set(d, 0x1p-700)), hn::Eq(rise.value, hn::Zero(d)));
  return {highest, hn::And(hn::Eq(highest, lowest), full)};
}

// Both ends of some lines
struct Lanes {
  V ax, ay, bx, by;
};

// An end that lies outside, cut at the border that the line comes to last on its way in
struct CutEnd {
  V x, y;
  V other, lower, upper;  // the coordinate that was computed, and between which borders it may lie
  M sure;
};

struct Borders {
  V left, bottom, right, top;
};

HWY_INLINE CutEnd cut_end(V x, V y, M beyond_x, M beyond_y, M below_x, M below_y, const Parts& dx,
                          const Parts& dy, const Borders& w) {
  const D d;
  const V cx = hn::IfThenElse(below_x, w.left, w.right), cy = hn::IfThenElse(below_y, w.bottom, w.top);
  // Beyond two borders: the later one is where the way in, divided by the length, is longer
  const V left = hn::Abs(hn::Mul(hn::Sub(cx, x), dy.value));
  const V right = hn::Abs(hn::Mul(hn::Sub(cy, y), dx.value));
  const V bound = hn::Add(hn::Mul(hn::Add(left, right), hn::Set(d, 0x1p-51)), hn::Set(d, 0x1p-1000));
  const M ordered = hn::Gt(hn::Abs(hn::Sub(left, right)), bound);
  const M both = hn::And(beyond_x, beyond_y);
  const M at_x = hn::And(beyond_x, hn::Or(hn::Not(beyond_y), hn::Gt(left, right)));

  const V c = hn::IfThenElse(at_x, cx, cy);
  const V along = hn::IfThenElse(at_x, x, y), base = hn::IfThenElse(at_x, y, x);
  const Sure other = nearest_sum(base, difference(c, along), choose(at_x, dy, dx), choose(at_x, dx, dy));
  return {hn::IfThenElse(at_x, c, other.value),
          hn::IfThenElse(at_x, other.value, c),
          other.value,
          hn::IfThenElse(at_x, w.bottom, w.left),
          hn::IfThenElse(at_x, w.top, w.right),
          hn::And(other.sure, hn::Or(hn::Not(both), ordered))};
}

struct Clipped {
  Lanes lanes;
  M accepted, sure;
};

HWY_INLINE Clipped clip_lanes(const Lanes& p, const Borders& w) {
  const D d;
  // Codes. A coordinate that is not a number makes the sum none either
  const M a_left = hn::Lt(p.ax, w.left), a_right = hn::Gt(p.ax, w.right);
  const M a_bottom = hn::Lt(p.ay, w.bottom), a_top = hn::Gt(p.ay, w.top);
  const M b_left = hn::Lt(p.bx, w.left), b_right = hn::Gt(p.bx, w.right);
  const M b_bottom = hn::Lt(p.by, w.bottom), b_top = hn::Gt(p.by, w.top);
  const M ax = hn::Or(a_left, a_right), ay = hn::Or(a_bottom, a_top);
  const M bx = hn::Or(b_left, b_right), by = hn::Or(b_bottom, b_top);
  const M in_range =
      hn::Le(hn::Add(hn::Add(hn::Abs(p.ax), hn::Abs(p.ay)), hn::Add(hn::Abs(p.bx), hn::Abs(p.by))),
             hn::Set(d, largest));
  const M rejected = hn::Or(hn::Or(hn::And(a_left, b_left), hn::And(a_right, b_right)),
                            hn::Or(hn::And(a_bottom, b_bottom), hn::And(a_top, b_top)));
  const M a_outside = hn::Or(ax, ay), b_outside = hn::Or(bx, by);
  const M undecided = hn::AndNot(rejected, hn::Or(a_outside, b_outside));
  if (hn::AllFalse(d, undecided)) return {p, hn::Not(rejected), in_range};

  // Each end that is outside is cut once
  const Parts dx = difference(p.bx, p.ax), dy = difference(p.by, p.ay);
  const CutEnd a = cut_end(p.ax, p.ay, ax, ay, a_left, a_bottom, dx, dy, w);
  const CutEnd b = cut_end(p.bx, p.by, bx, by, b_left, b_bottom, dx, dy, w);

  // With both ends outside the line may pass a corner: it is in the window where the point of a lies there.
  // A point that was rounded onto a border may lie beyond it
  const M two = hn::And(a_outside, b_outside);
  const M inside = hn::And(hn::Gt(a.other, a.lower), hn::Lt(a.other, a.upper));
  const M beside = hn::Or(hn::Lt(a.other, a.lower), hn::Gt(a.other, a.upper));
  const M missed = hn::And(hn::And(undecided, two), beside);
  const M accepted = hn::Not(hn::Or(rejected, missed));
  const M a_sure = hn::And(hn::Or(hn::Not(a_outside), a.sure), hn::Or(hn::Not(two), hn::Or(inside, beside)));
  const M b_sure = hn::Or(hn::Or(hn::Not(b_outside), missed), b.sure);
  const M sure = hn::And(in_range, hn::Or(hn::Not(undecided), hn::And(a_sure, b_sure)));

  const M cut_a = hn::And(accepted, a_outside), cut_b = hn::And(accepted, b_outside);
  return {{hn::IfThenElse(cut_a, a.x, p.ax), hn::IfThenElse(cut_a, a.y, p.ay),
           hn::IfThenElse(cut_b, b.x, p.bx), hn::IfThenElse(cut_b, b.y, p.by)},
          accepted,
          sure};
}

// Lanes(d) lines from `lines` on; returns how many are accepted
HWY_INLINE std::size_t clip_some(const Line<double>* lines, const Rectangle<double>& window, const Borders& w,
                                 Line<double>* clipped, std::uint8_t* accepted) {
  const D d;
  constexpr std::size_t most = HWY_MAX_BYTES / sizeof(double);
  const std::size_t count = hn::Lanes(d);
  Lanes p;
  hn::LoadInterleaved4(d, &lines->a.x, p.ax, p.ay, p.bx, p.by);
  const Clipped found = clip_lanes(p, w);

  std::array<std::uint8_t, 8 * (most + 7) / 8> bytes{};
  hn::StoreMaskBits(d, found.accepted, bytes.data());
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < (count + 7) / 8; ++i) bits |= std::uint64_t{bytes[i]} << (8 * i);
  if (!hn::AllTrue(d, found.sure)) {
    // One by one, from what stood there: `clipped` may be `lines`
    std::array<Line<double>, most> before;
    std::copy_n(lines, count, before.begin());
    hn::StoreMaskBits(d, found.sure, bytes.data());
    std::uint64_t sure = 0;
    for (std::size_t i = 0; i < (count + 7) / 8; ++i) sure |= std::uint64_t{bytes[i]} << (8 * i);
    hn::StoreInterleaved4(found.lanes.ax, found.lanes.ay, found.lanes.bx, found.lanes.by, d, &clipped->a.x);
    for (std::size_t i = 0; i < count; ++i) {
      if (sure >> i & 1) continue;
      const std::optional<Line<double>> line = correctly_rounded(before[i], window);
      clipped[i] = line ? *line : before[i];
      bits = (bits & ~(std::uint64_t{1} << i)) | std::uint64_t{line.has_value()} << i;
    }
  } else {
    hn::StoreInterleaved4(found.lanes.ax, found.lanes.ay, found.lanes.bx, found.lanes.by, d, &clipped->a.x);
  }
  for (std::size_t i = 0; i < count; ++i) accepted[i] = static_cast<std::uint8_t>(bits >> i & 1);
  return static_cast<std::size_t>(std::popcount(bits));
}

std::size_t clip_all(const Line<double>* lines, std::size_t size, const Rectangle<double>& window,
                     Line<double>* clipped, std::uint8_t* accepted) {
  const D d;
  const std::size_t count = hn::Lanes(d);
  const Borders w{hn::Set(d, window.lower.x), hn::Set(d, window.lower.y), hn::Set(d, window.upper.x),
                  hn::Set(d, window.upper.y)};
  std::size_t kept = 0, i = 0;
  for (; i + count <= size; i += count) {
    kept += clip_some(lines + i, window, w, clipped + i, accepted + i);
  }
  // The last few
  for (; i < size; ++i) {
    const std::optional<Line<double>> line = correctly_rounded(lines[i], window);
    clipped[i] = line ? *line : lines[i];
    accepted[i] = line.has_value();
    kept += line.has_value();
  }
  return kept;
}

}  // namespace gradus::cohen_sutherland_2d::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::cohen_sutherland_2d {

HWY_EXPORT(clip_all);

std::size_t clip_batch(std::span<const Line<double>> lines, const Rectangle<double>& window,
                       std::span<Line<double>> clipped, std::span<std::uint8_t> accepted) {
  static_assert(sizeof(Line<double>) == 4 * sizeof(double));
  expects(clipped.size() == lines.size() && accepted.size() == lines.size(),
          "{} lines, but room for {} and for {} answers", lines.size(), clipped.size(), accepted.size());
  expect_clippable(Line<double>{window.lower, window.upper}, window);
  // Without lines in range the borders need not be either
  const double size = std::max({std::abs(window.lower.x), std::abs(window.lower.y), std::abs(window.upper.x),
                                std::abs(window.upper.y)});
  if (size <= 0x1p300) {
    return HWY_DYNAMIC_DISPATCH(clip_all)(lines.data(), lines.size(), window, clipped.data(),
                                          accepted.data());
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::optional<Line<double>> line = correctly_rounded(lines[i], window);
    clipped[i] = line ? *line : lines[i];
    accepted[i] = line.has_value();
    kept += line.has_value();
  }
  return kept;
}

}  // namespace gradus::cohen_sutherland_2d
#endif
