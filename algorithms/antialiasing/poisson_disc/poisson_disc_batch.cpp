#include "antialiasing/poisson_disc/poisson_disc_batch.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "antialiasing/poisson_disc/sample_cells.hpp"

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "antialiasing/poisson_disc/poisson_disc_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gradus::poisson_disc::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<D>;
using DU = hn::RebindToUnsigned<D>;
using F = hn::Vec<D>;

HWY_INLINE F set(float x) { return hn::Set(D(), x); }

// Places are off by less than 2^-18 radii from where doubles have them, and squares that are nearly 1 by
// 2^-16
constexpr float surely_near = 1 - 0x1p-12f, surely_far = 1 + 0x1p-12f;

// --- Random numbers --------------------------------------------------------------------------------------

#if HWY_TARGET == HWY_SCALAR
// The number with this index, up to 2^-24 less
HWY_INLINE F every_second(const Random& random, std::uint64_t first) {
  return set(static_cast<float>(random.at(first) >> 40) * 0x1p-24f);
}
#else
using DW = hn::RepartitionToWide<DU>;
using W = hn::Vec<DW>;

HWY_INLINE W low_word(W x) { return hn::And(x, hn::Set(DW(), 0xffffffffU)); }

// Of the numbers with these indices the upper halves, in the lower halves of lanes; as in philox4x32
HWY_INLINE W upper_half_of(const Random& random, W index) {
  const DW d;
  const DU words;
  const auto product = [&](W x, W by) { return hn::MulEven(hn::BitCast(words, x), hn::BitCast(words, by)); };
  const W multiplier_0 = hn::Set(d, 0xD2511F53U), multiplier_1 = hn::Set(d, 0xCD9E8D57U);
  auto key_0 = static_cast<std::uint32_t>(random.seed()),
       key_1 = static_cast<std::uint32_t>(random.seed() >> 32);
  // Products ask the lower halves alone
  W c0 = index, c1 = hn::ShiftRight<32>(index), c2 = hn::Set(d, random.stream()),
    c3 = hn::Set(d, random.stream() >> 32);
  for (int round = 0; round < 10; ++round) {
    const W product_0 = product(c0, multiplier_0), product_1 = product(c2, multiplier_1);
    c0 = hn::Xor(hn::Xor(hn::ShiftRight<32>(product_1), c1), hn::Set(d, key_0));
    c1 = product_1;
    c2 = hn::Xor(hn::Xor(hn::ShiftRight<32>(product_0), c3), hn::Set(d, key_1));
    c3 = product_0;
    key_0 += 0x9E3779B9U;
    key_1 += 0xBB67AE85U;
  }
  return low_word(c1);
}

// Every second number from one on, up to 2^-24 less than they are
HWY_INLINE F every_second(const Random& random, std::uint64_t first) {
  const DW d;
  const W index = hn::Add(hn::Set(d, first), hn::ShiftLeft<1>(hn::Iota(d, 0)));
  const W beyond = hn::Add(index, hn::Set(d, 2 * hn::Lanes(d)));
  const auto words = hn::ConcatEven(DU(), hn::BitCast(DU(), upper_half_of(random, beyond)),
                                    hn::BitCast(DU(), upper_half_of(random, index)));
  return hn::Mul(hn::ConvertTo(D(), hn::BitCast(DI(), hn::ShiftRight<8>(words))), set(0x1p-24f));
}
#endif

// --- Places ----------------------------------------------------------------------------------------------

struct Places {
  F x, y;  // from the sample, in radii
};

// The sine of x turns, for x from -1/4 to 1/4, within 2^-21: its series
HWY_INLINE F sine_of_turns(F x) {
  const F square = hn::Mul(x, x);
  F sum = set(-15.0946426f);
  for (const float c : {42.0586939f, -76.7058598f, 81.6052493f, -41.3417022f, 6.28318531f})
    sum = hn::MulAdd(sum, square, set(c));
  return hn::Mul(sum, x);
}

// Where the next tries go, as Ring::at has it: of two numbers one is for the angle, one for the distance
HWY_INLINE Places ring_places(const Random& random) {
  const F turn = hn::Sub(every_second(random, random.position()), set(0.5f)), size = hn::Abs(turn);
  const F distance = hn::Sqrt(hn::MulAdd(every_second(random, random.position() + 1), set(3), set(1)));
  // Half a turn less than the angle: both signs change
  const F folded =
      hn::IfThenElse(hn::Gt(size, set(0.25f)), hn::Sub(hn::CopySign(set(0.5f), turn), turn), turn);
  const F back = hn::Neg(distance);
  return {hn::Mul(back, sine_of_turns(hn::Sub(set(0.25f), size))), hn::Mul(back, sine_of_turns(folded))};
}

// --- Samples ---------------------------------------------------------------------------------------------

// The lowest bit for the first lane
HWY_INLINE std::uint64_t bits_of(hn::Mask<D> mask) {
  std::array<std::uint8_t, (HWY_MAX_BYTES / sizeof(float) + 7) / 8> bytes{};
  hn::StoreMaskBits(D(), mask, bytes.data());
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) bits |= std::uint64_t{bytes[i]} << (8 * i);
  return bits;
}

// Those that lie within three radii of a sample
void find_some(const SampleCells& cells, dvec2 sample, Neighbours& near) {
  const D d;
  const auto& [x_begin, y_begin, stride, right, up, width] = cells.round(sample);
  near.count = 0;
  for (std::size_t row = 0; row <= 2 * SampleCells::reach; ++row) {
    const F over = set(up + static_cast<float>(row) * width.y);
    for (std::size_t column = 0; column <= 2 * SampleCells::reach; column += hn::Lanes(d)) {
      const std::size_t at = row * stride + column;
      const F beside = hn::MulAdd(hn::Iota(d, static_cast<float>(column)), set(width.x), set(right));
      const F x = hn::Add(hn::LoadU(d, x_begin + at), beside), y = hn::Add(hn::LoadU(d, y_begin + at), over);
      const auto in = hn::Lt(hn::MulAdd(x, x, hn::Mul(y, y)), set(9.01f));
      if (hn::AllFalse(d, in)) continue;
      alignas(HWY_MAX_BYTES) float ways_x[hn::MaxLanes(d)], ways_y[hn::MaxLanes(d)];
      hn::Store(x, d, ways_x);
      hn::Store(y, d, ways_y);
      // One by one: some machines take longer to close the gaps in a register
      for (std::uint64_t bits = bits_of(in); bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        near.x[near.count] = ways_x[lane];
        near.y[near.count++] = ways_y[lane];
      }
    }
  }
}

// Which of the next tries beside a sample may be kept, and which of those are far enough from all others
OpenTries some_open_tries(const Random& random, const Neighbours& near, const Borders& borders) {
  const Places p = ring_places(random);
  const auto outside = hn::Or(hn::Or(hn::Lt(p.x, set(borders.left)), hn::Gt(p.x, set(borders.right))),
                              hn::Or(hn::Lt(p.y, set(borders.bottom)), hn::Gt(p.y, set(borders.top))));
  F least = set(surely_far + 1);
  for (std::size_t i = 0; i < near.count; ++i) {
    const F x = hn::Sub(p.x, set(near.x[i])), y = hn::Sub(p.y, set(near.y[i]));
    least = hn::Min(least, hn::MulAdd(x, x, hn::Mul(y, y)));
  }
  return {bits_of(hn::AndNot(outside, hn::Ge(least, set(surely_near)))),
          bits_of(hn::Gt(least, set(surely_far))), static_cast<int>(hn::Lanes(D()))};
}

}  // namespace gradus::poisson_disc::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::poisson_disc {

HWY_EXPORT(find_some);
HWY_EXPORT(some_open_tries);

namespace {

class Filling {
 public:
  Filling(const Area& area, double radius, int k)
      : ring_{area, radius},
        k_(k),
        grid_(area, radius),
        cells_(area, radius, grid_.cells()),
        least_(safe_square(radius)) {}

  std::vector<dvec2> fill(Random random) {
    keep(any_in(ring_.area, random));
    while (!active_.empty()) {
      const std::size_t i = any_of(active_, random);
      if (!found_beside(active_[i], random)) remove(active_, i);
    }
    return std::move(samples_);
  }

 private:
  void keep(dvec2 sample) {
    grid_.put(sample);
    cells_.put(sample);
    active_.push_back(sample);
    samples_.push_back(sample);
  }

  /// Whether a try became a sample. The numbers after its own are left to the tries that follow.
  bool found_beside(dvec2 sample, Random& random) {
    HWY_DYNAMIC_DISPATCH(find_some)(cells_, sample, near_);
    const Borders borders = borders_from(ring_, sample);
    for (int n = 0; n < k_;) {
      const Random begin = random;
      OpenTries open = HWY_DYNAMIC_DISPATCH(some_open_tries)(random, near_, borders);
      open.leave(k_ - n);
      for (; open.bits != 0; open.bits &= open.bits - 1) {
        const int next = std::countr_zero(open.bits);
        random.seek(begin.position() + 2 * static_cast<std::uint64_t>(next));
        const dvec2 place = ring_.at(sample, random);
        if (!contains(ring_.area, place)) continue;
        if ((open.far >> next & 1) == 0 && grid_.nearest(place).d2 < least_) continue;
        keep(place);
        return true;
      }
      n += open.count;
      random.seek(begin.position() + 2 * static_cast<std::uint64_t>(open.count));
    }
    return false;
  }

  Ring ring_;
  int k_;
  Grid grid_;
  SampleCells cells_;
  double least_;
  std::vector<dvec2> active_, samples_;
  Neighbours near_;
};

}  // namespace

std::vector<dvec2> bridson_batch(const Area& area, double radius, int k, Random random) {
  expect_area(area, radius);
  expects(k >= 1, "at least 1 try beside a sample, not {}", k);
  const ivec2 cells = cells_of(area, radius);
  if (std::min(cells.x, cells.y) >= SampleCells::fewest) return Filling(area, radius, k).fill(random);
  std::vector<dvec2> samples;
  bridson(area, radius, k, random, [&](dvec2 sample) { samples.push_back(sample); });
  return samples;
}

}  // namespace gradus::poisson_disc
#endif
