#include "core/arithmetic/exact.hpp"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>

#include "core/arithmetic/finite.hpp"

namespace gradus {
namespace {

__extension__ typedef unsigned __int128 Uint128;

using Word = std::uint64_t;
using Words = std::span<Word>;
using ConstWords = std::span<const Word>;

// Number of binary digits. (std::bit_width returns int or the argument's type, depending on the library.)
constexpr int bit_length(Word x) { return 64 - std::countl_zero(x); }

constexpr Word low_word(Uint128 x) { return static_cast<Word>(x); }
constexpr Word high_word(Uint128 x) { return static_cast<Word>(x >> 64); }

// A finite double as ±significand * 2^exponent
struct Parts {
  bool negative;
  Word significand;
  int exponent;
};

Parts parts_of(double x) {
  expects(std::isfinite(x), "exact arithmetic needs finite numbers, got {}", x);
  const Word bits = std::bit_cast<Word>(x);
  const Word fraction = bits & 0xF'FFFF'FFFF'FFFF;
  const int field = static_cast<int>(bits >> 52 & 0x7FF);
  if (field == 0) return {std::signbit(x), fraction, -1074};
  return {std::signbit(x), fraction | Word{1} << 52, field - 1075};
}

// Four words hold a product of four significands of 53 bits, a fifth what shifting moves up
using Product = std::array<Word, 5>;

void multiply(Product& product, Word factor) {
  Word carry = 0;
  for (Word& word : product) {
    const Uint128 sum = Uint128{word} * factor + carry;
    word = low_word(sum);
    carry = high_word(sum);
  }
}

void add(Words words, ConstWords addend) {
  bool carry = false;
  for (std::size_t i = 0; i < words.size() && (i < addend.size() || carry); ++i) {
    const Uint128 sum = Uint128{words[i]} + (i < addend.size() ? addend[i] : 0) + carry;
    words[i] = low_word(sum);
    carry = high_word(sum) != 0;
  }
}

void subtract(Words words, ConstWords subtrahend) {
  bool borrow = false;
  for (std::size_t i = 0; i < words.size() && (i < subtrahend.size() || borrow); ++i) {
    const Uint128 difference = Uint128{words[i]} - (i < subtrahend.size() ? subtrahend[i] : 0) - borrow;
    words[i] = low_word(difference);
    borrow = high_word(difference) != 0;
  }
}

bool is_zero(ConstWords words) {
  return std::all_of(words.begin(), words.end(), [](Word word) { return word == 0; });
}

bool at_least(ConstWords a, ConstWords b) {
  for (std::size_t i = a.size(); i-- > 0;) {
    if (a[i] != b[i]) return a[i] > b[i];
  }
  return true;
}

void double_in_place(Words words) {
  for (std::size_t i = words.size(); i-- > 1;) words[i] = words[i] << 1 | words[i - 1] >> 63;
  words[0] <<= 1;
}

constexpr std::size_t most_words = SumOfProducts<4>::word_count;

// |x| as 0.1… * 2^exponent: words lowest first, the top bit of the last one set
struct Magnitude {
  std::array<Word, most_words> words{};
  std::size_t size = 0;
  int exponent = 0;
  bool negative = false;
};

Magnitude magnitude_of(ConstWords words, int lowest_exponent) {
  Magnitude result;
  result.negative = words.back() >> 63 != 0;
  const Words all = std::span(result.words).first(words.size());
  if (result.negative) {
    subtract(all, words);
  } else {
    std::copy(words.begin(), words.end(), all.begin());
  }

  // Drop the zero words at both ends, then shift the top bit to the top
  std::size_t last = words.size();
  while (all[last - 1] == 0) --last;
  std::size_t first = 0;
  while (all[first] == 0) ++first;
  result.size = last - first;
  std::copy(all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(last),
            result.words.begin());
  const int shift = std::countl_zero(result.words[result.size - 1]);
  for (int i = 0; i < shift; ++i) double_in_place(std::span(result.words).first(result.size));
  result.exponent = lowest_exponent + 64 * static_cast<int>(last) - shift;
  return result;
}

// The same words below a spare word on top, zeros filled in at the bottom, `size` words in all
std::array<Word, most_words + 1> aligned(const Magnitude& x, std::size_t size) {
  std::array<Word, most_words + 1> words{};
  std::copy_n(x.words.begin(), x.size, words.begin() + static_cast<std::ptrdiff_t>(size - 1 - x.size));
  return words;
}

Uint128 magnitude_of(Int128 x) {
  return x < 0 ? Uint128{0} - static_cast<Uint128>(x) : static_cast<Uint128>(x);
}

}  // namespace

namespace detail {

void accumulate_product(Words words, int factors, std::initializer_list<double> product, bool subtracted) {
  // The product of the significands, and the weight of its lowest bit
  Product bits{1};
  int offset = 1074 * factors;
  for (const double factor : product) {
    const Parts parts = parts_of(factor);
    multiply(bits, parts.significand);
    offset += parts.exponent;
    subtracted ^= parts.negative;
  }
  multiply(bits, Word{1} << (offset % 64));

  // Into the register at its place; carries run on upwards
  const Words upper = words.subspan(static_cast<std::size_t>(offset / 64));
  if (subtracted) {
    subtract(upper, bits);
  } else {
    add(upper, bits);
  }
}

int sign_of(ConstWords words) {
  if (words.back() >> 63 != 0) return -1;
  return is_zero(words) ? 0 : 1;
}

double rounded_quotient_of(ConstWords a, int a_exponent, ConstWords b, int b_exponent) {
  expects(!is_zero(b), "a quotient needs a denominator other than 0");
  if (is_zero(a)) return 0;
  const Magnitude numerator = magnitude_of(a, a_exponent);
  const Magnitude denominator = magnitude_of(b, b_exponent);

  // Both with the top bit at the same place, so that the quotient lies between 1/2 and 2
  const std::size_t size = std::max(numerator.size, denominator.size) + 1;
  std::array<Word, most_words + 1> remainder_words = aligned(numerator, size);
  const std::array<Word, most_words + 1> divisor_words = aligned(denominator, size);
  const Words remainder = std::span(remainder_words).first(size);
  const ConstWords divisor = std::span(divisor_words).first(size);

  // Long division by hand: 64 binary digits, the first weighing 1
  Word quotient = 0;
  for (int digit = 0; digit < 64; ++digit) {
    const bool fits = at_least(remainder, divisor);
    if (fits) subtract(remainder, divisor);
    quotient = quotient << 1 | Word{fits};
    double_in_place(remainder);
  }
  return nearest_double(numerator.negative != denominator.negative, quotient,
                        numerator.exponent - denominator.exponent - 63, !is_zero(remainder));
}

}  // namespace detail

double nearest_double(bool negative, std::uint64_t significand, int exponent, bool inexact) {
  expects(!inexact || bit_length(significand) >= 55,
          "an inexact significand needs 55 bits to be rounded, got {}", significand);
  const double sign = negative ? -1.0 : 1.0;
  if (significand == 0) return sign * 0.0;
  const int top = exponent + bit_length(significand) - 1;
  if (top > 1023) return sign * std::numeric_limits<double>::infinity();
  if (top < -1075) return sign * 0.0;

  // The last place of the result: 53 bits from the top, but not below the subnormals
  const int last = std::max(top - 52, -1074);
  const int dropped = last - exponent;
  Uint128 kept = significand;
  if (dropped <= 0) {
    kept <<= -dropped;
  } else {
    const Uint128 rest = kept & ((Uint128{1} << dropped) - 1);
    const Uint128 half = Uint128{1} << (dropped - 1);
    kept >>= dropped;
    const bool tie_goes_up = inexact || (kept & 1) != 0;
    if (rest > half || (rest == half && tie_goes_up)) ++kept;
  }

  // Adding, not or-ing: a carry out of the fraction moves the exponent up, even to infinity
  const Word bits = (static_cast<Word>(last + 1074) << 52) + low_word(kept);
  return sign * std::bit_cast<double>(bits);
}

double rounded_quotient(Int128 numerator, Int128 denominator) {
  expects(denominator != 0, "a quotient needs a denominator other than 0");
  if (numerator == 0) return 0;
  const Uint128 divisor = magnitude_of(denominator);
  Uint128 quotient = magnitude_of(numerator) / divisor;
  Uint128 remainder = magnitude_of(numerator) % divisor;

  // Binary digits after the point until the quotient has 64: the first within 128, for the numerator isn't 0
  int exponent = 0;
  while (quotient >> 63 == 0) {
    remainder <<= 1;
    const bool fits = remainder >= divisor;
    if (fits) remainder -= divisor;
    quotient = quotient << 1 | Uint128{fits};
    --exponent;
  }
  // Or the surplus digits dropped, remembering whether any was set
  const int surplus = std::max(0, 64 - std::countl_zero(high_word(quotient)));
  const bool cut = (quotient & ((Uint128{1} << surplus) - 1)) != 0;
  return nearest_double((numerator < 0) != (denominator < 0), low_word(quotient >> surplus),
                        exponent + surplus, cut || remainder != 0);
}

namespace {

// sum + det(p, q)
void add_determinant(SumOfProducts<2>& sum, glm::dvec2 p, glm::dvec2 q) {
  sum.add(p.x, q.y);
  sum.subtract(p.y, q.x);
}

// sum + det(p, q, r)
void add_determinant(SumOfProducts<3>& sum, glm::dvec3 p, glm::dvec3 q, glm::dvec3 r) {
  sum.add(p.x, q.y, r.z);
  sum.add(p.y, q.z, r.x);
  sum.add(p.z, q.x, r.y);
  sum.subtract(p.x, q.z, r.y);
  sum.subtract(p.y, q.x, r.z);
  sum.subtract(p.z, q.y, r.x);
}

}  // namespace

int orient2d_exact(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  // det(b - a, c - a), multiplied out so that no difference is rounded
  SumOfProducts<2> area;
  add_determinant(area, a, b);
  add_determinant(area, b, c);
  add_determinant(area, c, a);
  return area.sign();
}

int orient3d_exact(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
  // As for a corner that faces share, which is asked for most often; what is not finite is refused below
  const bool is_flat = d == a || d == b || d == c || a == b || b == c || c == a;
  const glm::dvec3 sum = glm::abs(a) + glm::abs(b) + glm::abs(c) + glm::abs(d);
  if (is_flat && all_finite(sum.x, sum.y, sum.z)) return 0;
  // det(b - a, c - a, d - a), multiplied out; a swapped pair of points is a minus
  SumOfProducts<3> volume;
  add_determinant(volume, b, c, d);
  add_determinant(volume, c, a, d);
  add_determinant(volume, a, b, d);
  add_determinant(volume, b, a, c);
  return volume.sign();
}

}  // namespace gradus
