#include "clipping/liang_barsky_circle/liang_barsky_circle_batch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "clipping/liang_barsky_circle/liang_barsky_circle_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>
#include "core/arithmetic/certified_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::liang_barsky_circle::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using lanes::HWY_NAMESPACE::bits_of;
using lanes::HWY_NAMESPACE::D;
using lanes::HWY_NAMESPACE::M;
using lanes::HWY_NAMESPACE::product_less;
using lanes::HWY_NAMESPACE::V;

constexpr double largest = 0x1p150;

HWY_INLINE V number(double x) { return hn::Set(D(), x); }

// --- Pairs of doubles: value + error, with about 100 bits -----------------------------------------------

struct Wide {
  V value, error;
};

HWY_INLINE Wide two_sum(V x, V y) {
  const V value = hn::Add(x, y);
  const V y_kept = hn::Sub(value, x);
  return {value, hn::Add(hn::Sub(x, hn::Sub(value, y_kept)), hn::Sub(y, y_kept))};
}
HWY_INLINE Wide two_difference(V x, V y) {
  const V value = hn::Sub(x, y);
  const V y_kept = hn::Sub(x, value);
  return {value, hn::Add(hn::Sub(x, hn::Add(value, y_kept)), hn::Sub(y_kept, y))};
}
HWY_INLINE Wide sum(const Wide& x, const Wide& y) {
  const Wide s = two_sum(x.value, y.value);
  return {s.value, hn::Add(s.error, hn::Add(x.error, y.error))};
}
HWY_INLINE Wide difference(const Wide& x, const Wide& y) {
  const Wide s = two_difference(x.value, y.value);
  return {s.value, hn::Add(s.error, hn::Sub(x.error, y.error))};
}
// After a cancellation: the value takes over what it can of the error
HWY_INLINE Wide normalised(const Wide& x) {
  const V value = hn::Add(x.value, x.error);
  return {value, hn::Sub(x.error, hn::Sub(value, x.value))};
}
HWY_INLINE Wide product(const Wide& x, const Wide& y) {
  const V value = hn::Mul(x.value, y.value);
  const V cross = hn::MulAdd(x.value, y.error, hn::Mul(x.error, y.value));
  return {value, hn::Add(product_less(x.value, y.value, value), cross)};
}

// --- Decisions ------------------------------------------------------------------------------------------

// A circle, and what is asked of it again and again
struct Disc {
  V x, y;
  Wide square;  // of the radius
  V size;       // no less than the radius and the centre's coordinates
  V smallest;   // cuts need as long a segment, squared
};

// Both ends of some segments
struct Lanes {
  V ax, ay, bx, by;
};

// An end seen from the centre, and its side as in `side`
struct End {
  V fx, fy;
  M outside, sure;
};

HWY_INLINE End end_at(V x, V y, const Disc& c) {
  const V fx = hn::Sub(x, c.x), fy = hn::Sub(y, c.y);
  const V square = hn::MulAdd(fx, fx, hn::Mul(fy, fy)), r2 = c.square.value;
  const V bound = hn::MulAdd(hn::Add(square, r2), number(0x1p-50), number(0x1p-960));
  const V above = hn::Sub(square, r2);
  return {fx, fy, hn::Gt(above, bound), hn::Gt(hn::Abs(above), bound)};
}

// Whether an end lies past the foot of the perpendicular: certainly, or certainly before it, as in past_foot
struct PastFoot {
  M yes, no;
};

HWY_INLINE PastFoot past_foot(const End& end, V dx, V dy) {
  const V x = hn::Mul(end.fx, dx), y = hn::Mul(end.fy, dy), at = hn::Add(x, y);
  const V bound = hn::MulAdd(hn::Add(hn::Abs(x), hn::Abs(y)), number(0x1p-50), number(0x1p-960));
  return {hn::Gt(at, bound), hn::Gt(hn::Neg(at), bound)};
}

// Whether the line crosses the circle: certainly, or certainly misses it, as in reach
struct Reach {
  M crosses, misses;
};

HWY_INLINE Reach reach_of(const End& from, V dx, V dy, const Disc& c) {
  const V A = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
  const V left = hn::Mul(dx, from.fy), right = hn::Mul(dy, from.fx), k = hn::Sub(left, right);
  const V r2A = hn::Mul(c.square.value, A), k2 = hn::Mul(k, k), discriminant = hn::Sub(r2A, k2);
  // Numbers up to 2^150 make r^2 and A at most 2^303, so what one lost by underflow, 2^-1074, times the other
  // is below the square of this constant
  const V k_error = hn::MulAdd(hn::Add(hn::Abs(left), hn::Abs(right)), number(0x1p-50), number(0x1p-380));
  const V twice_k = hn::MulAdd(hn::Abs(k), number(2), k_error);
  const V bound = hn::MulAdd(hn::Add(r2A, k2), number(0x1p-49), hn::Mul(k_error, twice_k));
  return {hn::Gt(discriminant, bound), hn::Gt(hn::Neg(discriminant), bound)};
}

// --- Points ---------------------------------------------------------------------------------------------

struct Points {
  V x, y;
  M sure;
};

struct Coordinate {
  V value;
  M sure;
};

// centre + numerator / A inside the segment's box: the double nearest to all numbers within `bound`, where
// there is only one
HWY_INLINE Coordinate coordinate(V centre, const Wide& numerator, const Wide& A, V inverse, V bound, V from,
                                 V to) {
  const V quotient = hn::Mul(numerator.value, inverse);
  const V large = product_less(quotient, A.value, numerator.value);
  const V left_over = hn::Sub(hn::NegMulAdd(quotient, A.error, numerator.error), large);
  const Wide at = two_sum(centre, quotient);
  const V rest = hn::MulAdd(left_over, inverse, at.error);
  const V highest = hn::Add(at.value, hn::Add(rest, bound));
  const V lowest = hn::Add(at.value, hn::Sub(rest, bound));
  // The comparisons of std::clamp, so that zeros have its signs
  const V lower = hn::IfThenElse(hn::Lt(to, from), to, from);
  const V upper = hn::IfThenElse(hn::Lt(from, to), to, from);
  const V value =
      hn::IfThenElse(hn::Lt(highest, lower), lower, hn::IfThenElse(hn::Lt(upper, highest), upper, highest));
  return {value, hn::Eq(highest, lowest)};
}

// The numbers of the lines through some segments, and by how much their crossings may be off
struct Lines {
  Wide dx, dy, A;
  Wide k, half;  // foot = k (-dy, dx) / A, half the chord = half (dx, dy) / A
  V inverse;     // 1 / A
  V bound;
  M sure;
};

HWY_INLINE Lines lines_through(const Lanes& p, const End& from, const End& to, const Disc& c) {
  const Wide dx = two_difference(p.bx, p.ax), dy = two_difference(p.by, p.ay);
  const Wide fx = two_difference(p.ax, c.x), fy = two_difference(p.ay, c.y);
  const Wide A = sum(product(dx, dx), product(dy, dy));
  const Wide k = normalised(difference(product(dx, fy), product(dy, fx)));
  const Wide r2A = product(c.square, A);
  const Wide discriminant = normalised(difference(r2A, product(k, k)));
  // One root and a correction
  const V root = hn::Sqrt(discriminant.value), half_inverse = hn::Div(number(0.5), root);
  const V root_error = hn::Sub(discriminant.error, product_less(root, root, discriminant.value));
  const Wide half{root, hn::Mul(root_error, half_inverse)};
  const V inverse = hn::Div(number(1), A.value);

  // With u = 2^-53 every operation above loses less than 64 u^2 of the numbers that it begins with, and
  // exact_decision, from whichever end, no more. So k is off by 2^-98 of `terms`, D by 2^-97 of `spread`,
  // its root by that over the root, and a place by |d| / A as much; together below 2^-95 of this, in each
  const V length = hn::Add(hn::Abs(dx.value), hn::Abs(dy.value));
  const V terms = hn::MulAdd(hn::Abs(dx.value), hn::Add(hn::Abs(from.fy), hn::Abs(to.fy)),
                             hn::Mul(hn::Abs(dy.value), hn::Add(hn::Abs(from.fx), hn::Abs(to.fx))));
  const V spread = hn::MulAdd(hn::Abs(k.value), terms, hn::Add(r2A.value, r2A.value));
  const V both = hn::MulAdd(hn::Add(spread, spread), half_inverse, terms);
  const V bound = hn::Mul(hn::MulAdd(both, hn::Mul(length, inverse), c.size), number(0x1p-92));
  const M sure =
      hn::And(hn::Gt(discriminant.value, hn::Mul(spread, number(0x1p-88))), hn::Ge(A.value, c.smallest));
  return {dx, dy, A, k, half, inverse, bound, sure};
}

// Where the segments enter and leave
struct Crossings {
  Points enters, leaves;
};

HWY_INLINE Crossings crossings_of(const Lanes& p, const Lines& line, const Disc& c) {
  const Wide kx = product(line.k, line.dx), ky = product(line.k, line.dy);
  const Wide hx = product(line.half, line.dx), hy = product(line.half, line.dy);
  const auto at_x = [&](const Wide& numerator) {
    return coordinate(c.x, numerator, line.A, line.inverse, line.bound, p.ax, p.bx);
  };
  const auto at_y = [&](const Wide& numerator) {
    return coordinate(c.y, numerator, line.A, line.inverse, line.bound, p.ay, p.by);
  };
  const Wide back{hn::Neg(ky.value), hn::Neg(ky.error)};
  const Coordinate x0 = at_x(difference(back, hx)), y0 = at_y(difference(kx, hy));
  const Coordinate x1 = at_x(difference(hx, ky)), y1 = at_y(sum(kx, hy));
  return {{x0.value, y0.value, hn::And(x0.sure, y0.sure)}, {x1.value, y1.value, hn::And(x1.sure, y1.sure)}};
}

// Ends outside accepted segments move to the circle; returns where they are certain
HWY_INLINE M cut_lanes(Lanes& p, const End& from, const End& to, M accepted, const Disc& c) {
  const Lines lines = lines_through(p, from, to, c);
  const Crossings found = crossings_of(p, lines, c);
  const M cut_a = hn::And(accepted, from.outside), cut_b = hn::And(accepted, to.outside);
  p.ax = hn::IfThenElse(cut_a, found.enters.x, p.ax);
  p.ay = hn::IfThenElse(cut_a, found.enters.y, p.ay);
  p.bx = hn::IfThenElse(cut_b, found.leaves.x, p.bx);
  p.by = hn::IfThenElse(cut_b, found.leaves.y, p.by);
  const M a_unsure = hn::AndNot(hn::And(lines.sure, found.enters.sure), cut_a);
  const M b_unsure = hn::AndNot(hn::And(lines.sure, found.leaves.sure), cut_b);
  return hn::Not(hn::Or(a_unsure, b_unsure));
}

// --- All together ---------------------------------------------------------------------------------------

// Segments that are not certain, one by one, from what stands in `segments`, which `clipped` may be; returns
// for which segments something is left
HWY_NOINLINE std::uint64_t clip_unsure(const Segment<2, double>* segments, const Circle<double>& circle,
                                       std::uint64_t sure, std::uint64_t accepted, const Lanes& found,
                                       Segment<2, double>* clipped) {
  const D d;
  std::array<Segment<2, double>, HWY_MAX_BYTES / sizeof(double)> before;
  std::copy_n(segments, hn::Lanes(d), before.begin());
  hn::StoreInterleaved4(found.ax, found.ay, found.bx, found.by, d, &clipped->a.x);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    if (sure >> i & 1) continue;
    const std::optional<Segment<2, double>> segment = exact_decision(before[i], circle);
    clipped[i] = segment ? *segment : before[i];
    accepted = (accepted & ~(std::uint64_t{1} << i)) | std::uint64_t{segment.has_value()} << i;
  }
  return accepted;
}

// As many segments as go together, from `segments` on; returns for which of them something is left
HWY_INLINE std::uint64_t clip_some(const Segment<2, double>* segments, const Circle<double>& circle,
                                   const Disc& c, Segment<2, double>* clipped, std::size_t& one_by_one) {
  const D d;
  Lanes p;
  hn::LoadInterleaved4(d, &segments->a.x, p.ax, p.ay, p.bx, p.by);
  const End from = end_at(p.ax, p.ay, c), to = end_at(p.bx, p.by, c);
  // A coordinate that is not a number makes the sum none either
  const V size = hn::Add(hn::Add(hn::Abs(p.ax), hn::Abs(p.ay)), hn::Add(hn::Abs(p.bx), hn::Abs(p.by)));
  M sure = hn::And(hn::Le(size, number(largest)), hn::And(from.sure, to.sure));
  M accepted = hn::FirstN(d, hn::Lanes(d));
  const M any = hn::Or(from.outside, to.outside);
  if (!hn::AllFalse(d, any)) {
    // With both ends outside: does the line come near enough, between them?
    const M two = hn::And(from.outside, to.outside);
    const V dx = hn::Sub(p.bx, p.ax), dy = hn::Sub(p.by, p.ay);
    const PastFoot a = past_foot(from, dx, dy), b = past_foot(to, dx, dy);
    const Reach reach = reach_of(from, dx, dy, c);
    const M missed = hn::And(two, hn::Or(reach.misses, hn::Or(a.yes, b.no)));
    const M hit = hn::And(reach.crosses, hn::And(a.no, b.yes));
    accepted = hn::Not(missed);
    sure = hn::AndNot(hn::AndNot(hn::Or(missed, hit), two), sure);
    const M cut = hn::And(sure, hn::AndNot(missed, any));
    if (!hn::AllFalse(d, cut)) sure = hn::And(sure, cut_lanes(p, from, to, cut, c));
  }
  const std::uint64_t bits = bits_of(accepted);
  if (hn::AllTrue(d, sure)) {
    hn::StoreInterleaved4(p.ax, p.ay, p.bx, p.by, d, &clipped->a.x);
    return bits;
  }
  one_by_one += hn::CountTrue(d, hn::Not(sure));
  return clip_unsure(segments, circle, bits_of(sure), bits, p, clipped);
}

BatchCount clip_all(const Segment<2, double>* segments, std::size_t size, const Circle<double>& circle,
                    Segment<2, double>* clipped, std::uint8_t* accepted) {
  const D d;
  const std::size_t count = hn::Lanes(d);
  const double r = circle.radius;
  const Rounded square = two_product(r, r);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Disc c{hn::Set(d, circle.centre.x),
               hn::Set(d, circle.centre.y),
               {hn::Set(d, square.value), hn::Set(d, square.error)},
               hn::Set(d, std::abs(circle.centre.x) + std::abs(circle.centre.y) + r),
               hn::Set(d, r >= 1 / largest ? 0x1p-300 : infinity)};
  BatchCount counts;
  std::size_t i = 0;
  for (; i + count <= size; i += count) {
    const std::uint64_t bits = clip_some(segments + i, circle, c, clipped + i, counts.one_by_one);
    for (std::size_t k = 0; k < count; ++k) accepted[i + k] = static_cast<std::uint8_t>(bits >> k & 1);
    counts.accepted += static_cast<std::size_t>(std::popcount(bits));
  }
  // The last few
  for (; i < size; ++i) {
    const std::optional<Segment<2, double>> segment = exact_decision(segments[i], circle);
    clipped[i] = segment ? *segment : segments[i];
    accepted[i] = segment.has_value();
    counts.accepted += segment.has_value();
    ++counts.one_by_one;
  }
  return counts;
}

}  // namespace gradus::liang_barsky_circle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::liang_barsky_circle {

HWY_EXPORT(clip_all);

BatchCount clip_batch(std::span<const Segment<2, double>> segments, const Circle<double>& circle,
                      std::span<Segment<2, double>> clipped, std::span<std::uint8_t> accepted) {
  static_assert(sizeof(Segment<2, double>) == 4 * sizeof(double));
  expects(clipped.size() == segments.size() && accepted.size() == segments.size(),
          "{} segments, but room for {} and for {} answers", segments.size(), clipped.size(),
          accepted.size());
  expect_circle(circle);
  // Circles out of range have no lanes
  const double size = std::max({std::abs(circle.centre.x), std::abs(circle.centre.y), circle.radius});
  if (size <= 0x1p150) {
    return HWY_DYNAMIC_DISPATCH(clip_all)(segments.data(), segments.size(), circle, clipped.data(),
                                          accepted.data());
  }
  BatchCount counts;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::optional<Segment<2, double>> segment = exact_decision(segments[i], circle);
    clipped[i] = segment ? *segment : segments[i];
    accepted[i] = segment.has_value();
    counts.accepted += segment.has_value();
    ++counts.one_by_one;
  }
  return counts;
}

}  // namespace gradus::liang_barsky_circle
#endif
