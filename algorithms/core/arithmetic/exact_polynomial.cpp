#include "core/arithmetic/exact_polynomial.hpp"

#include <bit>

namespace gradus::detail {
namespace {

__extension__ typedef unsigned __int128 Uint128;

using Word = std::uint64_t;
using Words = std::span<Word>;
using ConstWords = std::span<const Word>;

constexpr Word low_word(Uint128 x) { return static_cast<Word>(x); }
constexpr Word high_word(Uint128 x) { return static_cast<Word>(x >> 64); }

std::size_t without_zeros(ConstWords words, std::size_t size) {
  while (size > 0 && words[size - 1] == 0) --size;
  return size;
}

}  // namespace

std::size_t add_magnitudes(ConstWords a, ConstWords b, Words result) {
  if (a.size() < b.size()) std::swap(a, b);
  bool carry = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Uint128 sum = Uint128{a[i]} + (i < b.size() ? b[i] : 0) + carry;
    result[i] = low_word(sum);
    carry = high_word(sum) != 0;
  }
  if (!carry) return a.size();
  result[a.size()] = 1;
  return a.size() + 1;
}

std::size_t subtract_magnitudes(ConstWords a, ConstWords b, Words result) {
  bool borrow = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Uint128 difference = Uint128{a[i]} - (i < b.size() ? b[i] : 0) - borrow;
    result[i] = low_word(difference);
    borrow = high_word(difference) != 0;
  }
  return without_zeros(result, a.size());
}

std::size_t multiply_magnitudes(ConstWords a, ConstWords b, Words result) {
  // By hand, digit by digit
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = 0;
  for (std::size_t j = 0; j < b.size(); ++j) {
    Word carry = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Uint128 sum = Uint128{a[i]} * b[j] + result[i + j] + carry;
      result[i + j] = low_word(sum);
      carry = high_word(sum);
    }
    result[a.size() + j] = carry;
  }
  return without_zeros(result, a.size() + b.size());
}

int compare_magnitudes(ConstWords a, ConstWords b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (std::size_t i = a.size(); i-- > 0;) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

DoubleBits bits_of(double x) {
  expects(std::isfinite(x), "exact arithmetic needs finite numbers, got {}", x);
  const Word bits = std::bit_cast<Word>(x);
  const Word fraction = bits & 0xF'FFFF'FFFF'FFFF;
  const int field = static_cast<int>(bits >> 52 & 0x7FF);
  if (field == 0) return {fraction, 1088 - 1074};
  return {fraction | Word{1} << 52, field - 1075 + 1088};
}

Leading leading_of(ConstWords words, int lowest, bool negative) {
  if (words.empty()) return {{0, 0}, 0};
  const std::size_t size = words.size();
  const auto word = [&](std::size_t down) { return down < size ? words[size - 1 - down] : 0; };
  // 128 bits from the top one on
  const int shift = std::countl_zero(word(0));
  Uint128 bits = Uint128{word(0)} << 64 | word(1);
  bits <<= shift;
  if (shift > 0) bits |= word(2) >> (64 - shift);
  // Twice 53 of them, cut off
  const double high = static_cast<double>(high_word(bits) >> 11) * 0x1p-53;
  const double low = static_cast<double>(low_word(bits >> 22) & 0x1F'FFFF'FFFF'FFFF) * 0x1p-106;
  const double sign = negative ? -1 : 1;
  return {{sign * high, sign * low}, lowest + 64 * static_cast<int>(size) - shift};
}

}  // namespace gradus::detail
