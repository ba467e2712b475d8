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

#include "core/arithmetic/certified_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::cohen_sutherland_2d::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using namespace lanes::HWY_NAMESPACE;

constexpr double largest = 0x1p300;

// Both ends of some lines
struct Lanes {
  V ax, ay, bx, by;
};

struct Borders {
  V left, bottom, right, top;
};

// Each end cut at the border that the line comes to last on its way in
struct Cuts {
  Pair x, y;
  V other, lower, upper;  // of a: the coordinate that was computed, and between which borders it may lie
  PairMask sure;
};

HWY_INLINE Cuts cut_ends(const Lanes& p, PairMask beyond_x, PairMask beyond_y, PairMask below_x,
                         PairMask below_y, const Borders& w, V size) {
  const Difference dx = difference(p.bx, p.ax), dy = difference(p.by, p.ay);
  const Pair x{p.ax, p.bx}, y{p.ay, p.by};
  const Pair cx = choose(below_x, both(w.left), both(w.right)),
             cy = choose(below_y, both(w.bottom), both(w.top));
  // Beyond two borders: the later one is where the way in, divided by the length, is longer
  const Pair by_x = size_of(multiply(subtract(cx, x), both(dy.value)));
  const Pair by_y = size_of(multiply(subtract(cy, y), both(dx.value)));
  const Pair bound =
      multiply_add(add(by_x, by_y), both(hn::Set(D(), 0x1p-51)), both(hn::Set(D(), 0x1p-1000)));
  const PairMask ordered = greater(size_of(subtract(by_x, by_y)), bound);
  const PairMask at_x = but_not(beyond_x, but_not(beyond_y, greater(by_x, by_y)));

  const Pair c = choose(at_x, cx, cy);
  const Pair along = choose(at_x, x, y), base = choose(at_x, y, x);
  const Sums other =
      nearest_sum(base, difference(c, along), choose(at_x, dy, dx), choose(at_x, dx, dy), both(size));
  return {choose(at_x, c, other.value),
          choose(at_x, other.value, c),
          other.value.a,
          hn::IfThenElse(at_x.a, w.bottom, w.left),
          hn::IfThenElse(at_x.a, w.top, w.right),
          but_not(other.sure, but_not(beyond_x & beyond_y, ordered))};
}

// Beyond which borders some points lie
struct Codes {
  M left, right, bottom, top, x, y, any;
};

HWY_INLINE Codes codes_of(V x, V y, const Borders& w) {
  const M left = hn::Lt(x, w.left), right = hn::Gt(x, w.right), bottom = hn::Lt(y, w.bottom),
          top = hn::Gt(y, w.top);
  const M beyond_x = hn::Or(left, right), beyond_y = hn::Or(bottom, top);
  return {left, right, bottom, top, beyond_x, beyond_y, hn::Or(beyond_x, beyond_y)};
}

// What is left of the lines p, in place, and of which something is left; returns where that is certain
HWY_INLINE M cut_lanes(Lanes& p, const Codes& ca, const Codes& cb, M rejected, const Borders& w, V size,
                       M& accepted) {
  const M undecided = hn::AndNot(rejected, hn::Or(ca.any, cb.any));
  // Each end that is outside is cut once
  const Cuts cut =
      cut_ends(p, {ca.x, cb.x}, {ca.y, cb.y}, {ca.left, cb.left}, {ca.bottom, cb.bottom}, w, size);

  // With both ends outside the line may pass a corner: it is in the window where the point of a lies there.
  // A point that was rounded onto a border may lie beyond it
  const M two = hn::And(ca.any, cb.any);
  const M inside = hn::And(hn::Gt(cut.other, cut.lower), hn::Lt(cut.other, cut.upper));
  const M beside = hn::Or(hn::Lt(cut.other, cut.lower), hn::Gt(cut.other, cut.upper));
  const M missed = hn::And(hn::And(undecided, two), beside);
  accepted = hn::Not(hn::Or(rejected, missed));
  const M a_unsure = hn::Or(hn::AndNot(cut.sure.a, ca.any), hn::AndNot(hn::Or(inside, beside), two));
  const M b_unsure = hn::AndNot(hn::Or(cut.sure.b, missed), cb.any);

  const M cut_a = hn::And(accepted, ca.any), cut_b = hn::And(accepted, cb.any);
  p.ax = hn::IfThenElse(cut_a, cut.x.a, p.ax);
  p.ay = hn::IfThenElse(cut_a, cut.y.a, p.ay);
  p.bx = hn::IfThenElse(cut_b, cut.x.b, p.bx);
  p.by = hn::IfThenElse(cut_b, cut.y.b, p.by);
  return hn::Not(hn::And(undecided, hn::Or(a_unsure, b_unsure)));
}

// Lines that are not certain, one by one, from what stands in `lines`, which `clipped` may be; returns for
// which lines something is left
HWY_NOINLINE std::uint64_t clip_unsure(const Segment<2, double>* lines, const Rectangle<double>& window,
                                       std::uint64_t sure, std::uint64_t accepted, const Lanes& found,
                                       Segment<2, double>* clipped) {
  const D d;
  std::array<Segment<2, double>, HWY_MAX_BYTES / sizeof(double)> before;
  std::copy_n(lines, hn::Lanes(d), before.begin());
  hn::StoreInterleaved4(found.ax, found.ay, found.bx, found.by, d, &clipped->a.x);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    if (sure >> i & 1) continue;
    const std::optional<Segment<2, double>> line = correctly_rounded(before[i], window);
    clipped[i] = line ? *line : before[i];
    accepted = (accepted & ~(std::uint64_t{1} << i)) | std::uint64_t{line.has_value()} << i;
  }
  return accepted;
}

// As many lines as go together, from `lines` on; returns for which of them something is left
HWY_INLINE std::uint64_t clip_some(const Segment<2, double>* lines, const Rectangle<double>& window,
                                   const Borders& w, Segment<2, double>* clipped) {
  const D d;
  Lanes p;
  hn::LoadInterleaved4(d, &lines->a.x, p.ax, p.ay, p.bx, p.by);
  const Codes a = codes_of(p.ax, p.ay, w), b = codes_of(p.bx, p.by, w);
  const M rejected = hn::Or(hn::Or(hn::And(a.left, b.left), hn::And(a.right, b.right)),
                            hn::Or(hn::And(a.bottom, b.bottom), hn::And(a.top, b.top)));
  // A coordinate that is not a number makes the sum none either
  const V size = hn::Add(hn::Add(hn::Abs(p.ax), hn::Abs(p.ay)), hn::Add(hn::Abs(p.bx), hn::Abs(p.by)));
  M sure = hn::Le(size, hn::Set(d, largest));
  M accepted = hn::Not(rejected);
  if (!hn::AllFalse(d, hn::AndNot(rejected, hn::Or(a.any, b.any)))) {
    sure = hn::And(sure, cut_lanes(p, a, b, rejected, w, size, accepted));
  }
  if (!hn::AllTrue(d, sure)) return clip_unsure(lines, window, bits_of(sure), bits_of(accepted), p, clipped);
  hn::StoreInterleaved4(p.ax, p.ay, p.bx, p.by, d, &clipped->a.x);
  return bits_of(accepted);
}

std::size_t clip_all(const Segment<2, double>* lines, std::size_t size, const Rectangle<double>& window,
                     Segment<2, double>* clipped, std::uint8_t* accepted) {
  const D d;
  const std::size_t count = hn::Lanes(d);
  // + 0.0 as in coordinate(): of the two zeros +0
  const Borders w{hn::Set(d, window.lower.x + 0.0), hn::Set(d, window.lower.y + 0.0),
                  hn::Set(d, window.upper.x + 0.0), hn::Set(d, window.upper.y + 0.0)};
  std::size_t kept = 0, i = 0;
  for (; i + count <= size; i += count) {
    const std::uint64_t bits = clip_some(lines + i, window, w, clipped + i);
    for (std::size_t k = 0; k < count; ++k) accepted[i + k] = static_cast<std::uint8_t>(bits >> k & 1);
    kept += static_cast<std::size_t>(std::popcount(bits));
  }
  // The last few
  for (; i < size; ++i) {
    const std::optional<Segment<2, double>> line = correctly_rounded(lines[i], window);
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

std::size_t clip_batch(std::span<const Segment<2, double>> lines, const Rectangle<double>& window,
                       std::span<Segment<2, double>> clipped, std::span<std::uint8_t> accepted) {
  static_assert(sizeof(Segment<2, double>) == 4 * sizeof(double));
  expects(clipped.size() == lines.size() && accepted.size() == lines.size(),
          "{} lines, but room for {} and for {} answers", lines.size(), clipped.size(), accepted.size());
  expect_clippable(Segment<2, double>{window.lower, window.upper}, window);
  // Without lines in range the borders need not be either
  const double size = std::max({std::abs(window.lower.x), std::abs(window.lower.y), std::abs(window.upper.x),
                                std::abs(window.upper.y)});
  if (size <= 0x1p300) {
    return HWY_DYNAMIC_DISPATCH(clip_all)(lines.data(), lines.size(), window, clipped.data(),
                                          accepted.data());
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::optional<Segment<2, double>> line = correctly_rounded(lines[i], window);
    clipped[i] = line ? *line : lines[i];
    accepted[i] = line.has_value();
    kept += line.has_value();
  }
  return kept;
}

}  // namespace gradus::cohen_sutherland_2d
#endif
