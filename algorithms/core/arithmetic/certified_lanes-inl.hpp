// Numbers in the lanes of a register that are computed fast and rounded once, with a certificate for each
// that it is the nearest double. For batches: lanes without a certificate go through the scalar method.
//
// In Highway's pattern for what is compiled once for every kind of machine: a _batch.cpp includes this after
// <hwy/highway.h>, and each time that it is compiled itself this is read again, under the target's own name.
#if defined(GRADUS_CORE_CERTIFIED_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRADUS_CORE_CERTIFIED_LANES_INL_HPP
#undef GRADUS_CORE_CERTIFIED_LANES_INL_HPP
#else
#define GRADUS_CORE_CERTIFIED_LANES_INL_HPP
#endif

#include <hwy/highway.h>
#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace gradus::lanes::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

// The same for both ends of some segments, side by side: two chains of operations that don't wait for each
// other
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

// x * y - z up to 2^-102 of z, which is the rounded product x * y or a number as close to it; with FMA exact
#if HWY_NATIVE_FMA
HWY_INLINE V product_less(V x, V y, V z) { return hn::MulSub(x, y, z); }
#else
// The first 26 bits, so that products of such parts are exact
HWY_INLINE V high_part(V x) {
  const hn::RebindToUnsigned<D> bits;
  return hn::And(x, hn::BitCast(D(), hn::Set(bits, ~((std::uint64_t{1} << 27) - 1))));
}
// In this order only the last product and the last addition round
HWY_INLINE V product_less(V x, V y, V z) {
  const V x_high = high_part(x), x_low = hn::Sub(x, x_high);
  const V y_high = high_part(y), y_low = hn::Sub(y, y_high);
  const V rest = hn::Add(hn::Sub(hn::Mul(x_high, y_high), z), hn::Mul(x_high, y_low));
  return hn::Add(hn::Add(rest, hn::Mul(x_low, y_high)), hn::Mul(x_low, y_low));
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
// size: no less than base and the quotient together, and than length or 2^-900
HWY_INLINE Sums nearest_sum(Pair base, const Differences& way, const Differences& rise,
                            const Differences& length, Pair size) {
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
  const Pair of_size = multiply(size, both(hn::Set(D(), 0x1p-72)));
  const Pair bound = multiply_add(size_of(inverse), both(hn::Set(D(), 0x1p-1060)), of_size);
  const Pair highest = add(sum, add(rest, bound)), lowest = add(sum, subtract(rest, bound));
  return {highest, equal(highest, lowest)};
}

// The lowest bit for the first lane
HWY_INLINE std::uint64_t bits_of(M mask) {
  std::array<std::uint8_t, (HWY_MAX_BYTES / sizeof(double) + 7) / 8> bytes{};
  hn::StoreMaskBits(D(), mask, bytes.data());
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) bits |= std::uint64_t{bytes[i]} << (8 * i);
  return bits;
}

}  // namespace gradus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
