#pragma once
// Random numbers that are the same bytes everywhere: a seeded, counter-based generator.
//
// The i-th number is a pure function of (seed, stream, i), so a pixel or an object can ask for its own
// numbers in any order. The distributions of the standard library are not used: each library has its own.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/arithmetic/rounding.hpp"
#include "core/contract.hpp"

namespace gradus {

using PhiloxBlock = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

/// Philox4x32-10: scrambles a 128-bit counter under a 64-bit key; a bijection of the counter for every key.
/// Source: Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC 2011, section 4.3.
/// Domain: any counter and key. Accuracy: equals the authors' known-answer vectors. Cost: 20 multiplications.
constexpr PhiloxBlock philox4x32(PhiloxBlock counter, PhiloxKey key) {
  constexpr std::uint64_t multiplier_0 = 0xD2511F53, multiplier_1 = 0xCD9E8D57;
  constexpr std::uint32_t golden_ratio = 0x9E3779B9, root_of_three = 0xBB67AE85;

  for (int round = 0; round < 10; ++round) {
    // Multiply two words; the high halves, mixed with key and the other two words, change places with them
    const std::uint64_t product_0 = multiplier_0 * counter[0];
    const std::uint64_t product_1 = multiplier_1 * counter[2];
    counter = {static_cast<std::uint32_t>(product_1 >> 32) ^ counter[1] ^ key[0],
               static_cast<std::uint32_t>(product_1),
               static_cast<std::uint32_t>(product_0 >> 32) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(product_0)};
    // The key moves on by a Weyl sequence
    key = {key[0] + golden_ratio, key[1] + root_of_three};
  }
  return counter;
}

/// A stream of 64-bit random numbers with a position; copies are independent and repeat each other.
///
/// Source: Philox4x32-10 (see philox4x32); key = seed, counter = (index, stream). Satisfies the standard's
/// UniformRandomBitGenerator, but only the members below give the same numbers on every library.
/// Domain: any seed and stream; 2^64 numbers per stream, then it repeats. Not for secrets.
/// Cost: about 10 to 20 ns per number.
class Random {
 public:
  using result_type = std::uint64_t;

  constexpr explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : seed_(seed), stream_(stream) {}

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  /// Which numbers these are; print the seed with every result made from it.
  constexpr std::uint64_t seed() const { return seed_; }
  constexpr std::uint64_t stream() const { return stream_; }
  /// Index of the number that comes next.
  constexpr std::uint64_t position() const { return position_; }
  constexpr void seek(std::uint64_t position) { position_ = position; }

  /// Number i of the stream, wherever the position is: 64 uniform bits.
  constexpr result_type at(std::uint64_t i) const { return low_half(block(seed_, i)); }

  /// The next number: 64 uniform bits.
  constexpr result_type operator()() { return at(position_++); }

  /// Number i as a double in [0, 1): a multiple of 2^-53, each equally likely.
  constexpr double unit_at(std::uint64_t i) const { return to_unit(at(i)); }

  /// The next number as a double in [0, 1): a multiple of 2^-53, each equally likely.
  constexpr double unit() { return to_unit((*this)()); }

  /// Number i as a double in [lower, upper). Domain: as `uniform`.
  constexpr double uniform_at(std::uint64_t i, double lower, double upper) const {
    return to_range(unit_at(i), lower, upper);
  }

  /// The next number as a double in [lower, upper); never upper, although the sum may round to it.
  /// Domain: finite, lower < upper, and upper - lower does not overflow.
  constexpr double uniform(double lower, double upper) { return to_range(unit(), lower, upper); }

  /// A whole number in [lower, upper], both included, each exactly equally likely.
  /// Draws again when a number falls into the incomplete last part of the range of 64-bit numbers, so one
  /// call uses one number or more (fewer than two on average). Domain: lower <= upper, up to the whole range.
  constexpr std::int64_t uniform_int(std::int64_t lower, std::int64_t upper) {
    expects(lower <= upper, "a random integer needs lower <= upper, got {} and {}", lower, upper);
    const std::uint64_t base = static_cast<std::uint64_t>(lower);
    const std::uint64_t count = static_cast<std::uint64_t>(upper) - base + 1;  // 0 stands for 2^64
    if (count == 0) return static_cast<std::int64_t>((*this)());

    const std::uint64_t surplus = (0 - count) % count;  // 2^64 mod count numbers would be too many
    std::uint64_t number = (*this)();
    while (number < surplus) number = (*this)();
    return static_cast<std::int64_t>(base + number % count);
  }

  /// Puts the items into a random order, each order equally likely (Fisher and Yates 1938; Durstenfeld 1964).
  /// Domain: a range with size() and []. Cost: one uniform_int per item.
  template <class Range>
  constexpr void shuffle(Range&& items) {
    for (std::size_t last = items.size(); last > 1; --last) {
      const std::size_t chosen =
          static_cast<std::size_t>(uniform_int(0, static_cast<std::int64_t>(last) - 1));
      std::swap(items[chosen], items[last - 1]);
    }
  }

  /// A generator of its own for the part with this number (pixel, object, thread), at position 0.
  /// Splitting does not move this stream. Children of one seed differ in (seed, stream) whenever (stream, id)
  /// differ, because the child's name is a Philox block, and that is a bijection.
  constexpr Random split(std::uint64_t id) const {
    constexpr std::uint64_t child_key =
        0x9E3779B97F4A7C15;  // keeps a child's name out of the parent's numbers
    const PhiloxBlock name = block(seed_ ^ child_key, id);
    return Random(low_half(name), join(name[2], name[3]));
  }

  friend constexpr bool operator==(const Random&, const Random&) = default;

 private:
  static constexpr std::uint64_t join(std::uint32_t low, std::uint32_t high) {
    return std::uint64_t{high} << 32 | low;
  }
  static constexpr std::uint64_t low_half(const PhiloxBlock& block) { return join(block[0], block[1]); }

  constexpr PhiloxBlock block(std::uint64_t key, std::uint64_t index) const {
    return philox4x32({static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32),
                       static_cast<std::uint32_t>(stream_), static_cast<std::uint32_t>(stream_ >> 32)},
                      {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)});
  }

  static constexpr double to_unit(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

  static constexpr double to_range(double unit, double lower, double upper) {
    expects(lower < upper && upper - lower <= std::numeric_limits<double>::max(),
            "a random number needs lower < upper with a finite difference, got {} and {}", lower, upper);
    const double number = lower + unfused((upper - lower) * unit);
    return number < upper ? number : next_below(upper);
  }

  static constexpr double next_below(double x) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    if (x == 0) return -std::numeric_limits<double>::denorm_min();
    return std::bit_cast<double>(x > 0 ? bits - 1 : bits + 1);
  }

  std::uint64_t seed_;
  std::uint64_t stream_;
  std::uint64_t position_ = 0;
};

}  // namespace gradus
