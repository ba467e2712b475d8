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

// The same for both ends of the lines, side by side: two chains of operations that don't wait for each other
struct Pair {
  V a, b;
};
struct PairMask {
  M a, b;
};

HWY_INLINE Pair add(Pair x, Pair y) { return {hn::Add(x.a, y.a), hn::Add(x.b, y.b)}; }
HWY_INLINE Pair subtract(Pair x, Pair y) { return {hn::Sub(x.a, y.a), hn::Sub(x.b, y.b)}; }
HWY_INLINE Pair multiply(Pair x, Pair y) { return {hn::Mul(x.a, y.a), hn::Mul(x.b, y.b)}; }
HWY_INLINE Pair inverse_of(Pair x) {
  const V one = hn::Set(D(), 1.0);
  return {hn::Div(one, x.a), hn::Div(one, x.b)};
}
HWY_INLINE Pair size_of(Pair x) { return {hn::Abs(x.a), hn::Abs(x.b)}; }
HWY_INLINE Pair choose(PairMask m, Pair yes, Pair no) {
  return {hn::IfThenElse(m.a, yes.a, no.a), hn::IfThenElse(m.b, yes.b, no.b)};
}
HWY_INLINE Pair both(V x) { return {x, x}; }
HWY_INLINE PairMask operator&(PairMask x, PairMask y) { return {hn::And(x.a, y.a), hn::And(x.b, y.b)}; }
HWY_INLINE PairMask but_not(PairMask x, PairMask y) { return {hn::AndNot(y.a, x.a), hn::AndNot(y.b, x.b)}; }
HWY_INLINE PairMask greater(Pair x, Pair y) { return {hn::Gt(x.a, y.a), hn::Gt(x.b, y.b)}; }
HWY_INLINE PairMask equal(Pair x, Pair y) { return {hn::Eq(x.a, y.a), hn::Eq(x.b, y.b)}; }

// x * y - z; exact where z is the rounded product x * y, or a number as close to it
#if HWY_NATIVE_FMA
HWY_INLINE V product_less(V x, V y, V z) { return hn::MulSub(x, y, z); }
#else
// The first 26 bits, so that products of such parts are exact
HWY_INLINE V high_part(V x) {
  const hn::RebindToUnsigned<D> bits;
  return hn::And(x, hn::BitCast(D(), hn::Set(bits, ~((std::uint64_t{1} << 27) - 1))));
}
HWY_INLINE V product_less(V x, V y, V z) {
  const V x_high = high_part(x), x_low = hn::Sub(x, x_high);
  const V y_high = high_part(y), y_low = hn::Sub(y, y_high);
  const V middle = hn::Add(hn::Mul(x_high, y_low), hn::Mul(x_low, y_high));
  return hn::Add(hn::Add(hn::Sub(hn::Mul(x_high, y_high), z), middle), hn::Mul(x_low, y_low));
}
#endif
HWY_INLINE Pair product_less(Pair x, Pair y, Pair z) {
  return {product_less(x.a, y.a, z.a), product_less(x.b, y.b, z.b)};
}
// x * y + z where the last digits don't matter
HWY_INLINE Pair multiply_add(Pair x, Pair y, Pair z) {
  return {hn::MulAdd(x.a, y.a, z.a), hn::MulAdd(x.b, y.b, z.b)};
}

// A difference: its rounded value, and what the rounding took away
struct Difference {
  V value, error;
};
struct Differences {
  Pair value, error;
};

HWY_INLINE Difference difference(V x, V y) {
  const V value = hn::Sub(x, y);
  const V y_kept = hn::Sub(x, value);
  const V x_kept = hn::Add(value, y_kept);
  return {value, hn::Add(hn::Sub(x, x_kept), hn::Sub(y_kept, y))};
}
HWY_INLINE Differences difference(Pair x, Pair y) {
  const Difference a = difference(x.a, y.a), b = difference(x.b, y.b);
  return {{a.value, b.value}, {a.error, b.error}};
}
HWY_INLINE Differences choose(PairMask m, const Difference& yes, const Difference& no) {
  return {choose(m, both(yes.value), both(no.value)), choose(m, both(yes.error), both(no.error))};
}

struct Sums {
  Pair value;
  PairMask sure;
};

// base + way * rise / length: the nearest double where that is certain. The same thought as
// cut_coordinate_filtered, with fewer digits: the quotient is wrong by less than 2^-75 of it.
// size: no less than base and the quotient together, nor than length
HWY_INLINE Sums nearest_sum(Pair base, const Differences& way, const Differences& rise,
                            const Differences& length, V size) {
  const Pair product = multiply(way.value, rise.value);
  const Pair inverse = inverse_of(length.value);
  const Pair quotient = multiply(product, inverse);

  // way * rise - quotient * length: the large parts cancel exactly, then the rest
  const Pair large = product_less(quotient, length.value, product);
  const Pair small = product_less(way.value, rise.value, product);
  const Pair errors = multiply_add(way.error, rise.value, multiply(way.value, rise.error));
  const Pair left_over = subtract(add(small, errors), multiply_add(quotient, length.error, large));

  // Add it up without loss, and ask whether the bound could reach another double. Its second part is for
  // digits that products near 0 have lost; where length is large enough to hide it, size is, too
  const Pair sum = add(base, quotient);
  const Pair quotient_kept = subtract(sum, base);
  const Pair lost = add(subtract(base, subtract(sum, quotient_kept)), subtract(quotient, quotient_kept));
  const Pair rest = multiply_add(left_over, inverse, lost);
  const V of_size = hn::Mul(size, hn::Set(D(), 0x1p-72));
  const Pair bound = multiply_add(size_of(inverse), both(hn::Set(D(), 0x1p-1060)), both(of_size));
  const Pair highest = add(sum, add(rest, bound)), lowest = add(sum, subtract(rest, bound));
  return {highest, equal(highest, lowest)};
}

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
      nearest_sum(base, difference(c, along), choose(at_x, dy, dx), choose(at_x, dx, dy), size);
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

HWY_INLINE std::uint64_t bits_of(M mask) {
  std::array<std::uint8_t, (HWY_MAX_BYTES / sizeof(double) + 7) / 8> bytes{};
  hn::StoreMaskBits(D(), mask, bytes.data());
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) bits |= std::uint64_t{bytes[i]} << (8 * i);
  return bits;
}

// Lines that are not certain, one by one, from what stands in `lines`, which `clipped` may be; returns for
// which lines something is left
HWY_NOINLINE std::uint64_t clip_unsure(const Line<double>* lines, const Rectangle<double>& window,
                                       std::uint64_t sure, std::uint64_t accepted, const Lanes& found,
                                       Line<double>* clipped) {
  const D d;
  std::array<Line<double>, HWY_MAX_BYTES / sizeof(double)> before;
  std::copy_n(lines, hn::Lanes(d), before.begin());
  hn::StoreInterleaved4(found.ax, found.ay, found.bx, found.by, d, &clipped->a.x);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    if (sure >> i & 1) continue;
    const std::optional<Line<double>> line = correctly_rounded(before[i], window);
    clipped[i] = line ? *line : before[i];
    accepted = (accepted & ~(std::uint64_t{1} << i)) | std::uint64_t{line.has_value()} << i;
  }
  return accepted;
}

// As many lines as go together, from `lines` on; returns for which of them something is left
HWY_INLINE std::uint64_t clip_some(const Line<double>* lines, const Rectangle<double>& window,
                                   const Borders& w, Line<double>* clipped) {
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

std::size_t clip_all(const Line<double>* lines, std::size_t size, const Rectangle<double>& window,
                     Line<double>* clipped, std::uint8_t* accepted) {
  const D d;
  const std::size_t count = hn::Lanes(d);
  const Borders w{hn::Set(d, window.lower.x), hn::Set(d, window.lower.y), hn::Set(d, window.upper.x),
                  hn::Set(d, window.upper.y)};
  std::size_t kept = 0, i = 0;
  for (; i + count <= size; i += count) {
    const std::uint64_t bits = clip_some(lines + i, window, w, clipped + i);
    for (std::size_t k = 0; k < count; ++k) accepted[i + k] = static_cast<std::uint8_t>(bits >> k & 1);
    kept += static_cast<std::size_t>(std::popcount(bits));
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
