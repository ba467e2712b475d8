#pragma once
// A raster as bits, 64 cells at a time: which cells have a value, and which ones are painted.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "core/language.hpp"

namespace gradus::flood_fill {

using Word = std::uint64_t;
inline constexpr int word_bits = 64;

/// The bits up to and including this one.
constexpr Word up_to(int bit) { return ~Word{0} >> (word_bits - 1 - bit); }

/// The number of set bits. (std::popcount is a call into a library on machines that may lack the
/// instruction.) H. S. Warren, Hacker's delight, 2nd edition 2012, section 5-1.
constexpr int count_bits(Word bits) {
  bits -= bits >> 1 & 0x5555555555555555U;
  bits = (bits & 0x3333333333333333U) + (bits >> 2 & 0x3333333333333333U);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fU;
  return static_cast<int>(bits * 0x0101010101010101U >> 56);
}

/// A bit per cell: whether it has this value. The first cell is the lowest bit. Domain: 1 to 64 cells.
template <class Cell, std::size_t extent>
Word equal_bits(std::span<const Cell, extent> cells, const Cell& value) {
  const Cell wanted = value;
  std::array<std::uint8_t, word_bits> equal{};
  for (std::size_t i = 0; i < cells.size(); ++i) equal[i] = cells[i] == wanted;
  Word bits = 0;
  if constexpr (std::endian::native == std::endian::little) {
    for (std::size_t k = 0; k < 8; ++k) {  // one product moves eight bytes' lowest bits side by side
      Word eight;
      std::memcpy(&eight, equal.data() + 8 * k, 8);
      bits |= (eight * 0x0102040810204080U >> 56) << (8 * k);
    }
  } else {
    for (std::size_t i = 0; i < word_bits; ++i) bits |= Word{equal[i]} << i;
  }
  return bits;
}

/// The other way: gives the cells whose bit is set a value. Domain: no bit beyond the cells.
template <class Cell, std::size_t extent>
void paint_some(std::span<Cell, extent> cells, Word bits, const Cell& value) {
  const Cell ink = value;
  std::array<std::uint8_t, word_bits> set;
  for (std::size_t i = 0; i < word_bits; ++i) set[i] = bits >> i & 1;
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = set[i] ? ink : cells[i];
}

#ifdef __SSE2__
/// A bit for each of 16 bytes: whether it has this value.
inline unsigned equal_sixteen(const std::uint8_t* cells, std::uint8_t value) {
  const __m128i some = _mm_loadu_si128(reinterpret_cast<const __m128i*>(cells));
  const __m128i equal = _mm_cmpeq_epi8(some, _mm_set1_epi8(static_cast<char>(value)));
  return static_cast<unsigned>(_mm_movemask_epi8(equal));
}

/// equal_bits of 64 bytes.
inline Word equal_bits(std::span<const std::uint8_t, word_bits> cells, std::uint8_t value) {
  Word bits = 0;
  for (std::size_t first = 0; first < word_bits; first += 16) {
    bits |= Word{equal_sixteen(cells.data() + first, value)} << first;
  }
  return bits;
}

/// paint_some of 64 bytes.
inline void paint_some(std::span<std::uint8_t, word_bits> cells, Word bits, std::uint8_t value) {
  const __m128i ink = _mm_set1_epi8(static_cast<char>(value));
  const __m128i own = _mm_set1_epi64x(static_cast<long long>(0x8040201008040201));
  // Eight bits stand in a byte: it is written down eight times, and each one looks at its own bit
  const __m128i once = _mm_set_epi64x(0, static_cast<long long>(bits));
  const __m128i twice = _mm_unpacklo_epi8(once, once);
  const __m128i low = _mm_unpacklo_epi16(twice, twice), high = _mm_unpackhi_epi16(twice, twice);
  const __m128i eight_times[] = {_mm_shuffle_epi32(low, 0x50), _mm_shuffle_epi32(low, 0xfa),
                                 _mm_shuffle_epi32(high, 0x50), _mm_shuffle_epi32(high, 0xfa)};
  for (std::size_t k = 0; k < 4; ++k) {
    const __m128i set = _mm_cmpeq_epi8(_mm_and_si128(eight_times[k], own), own);
    auto* const at = reinterpret_cast<__m128i*>(cells.data() + 16 * k);
    const __m128i kept = _mm_andnot_si128(set, _mm_loadu_si128(at));
    _mm_storeu_si128(at, _mm_or_si128(kept, _mm_and_si128(set, ink)));
  }
}
#endif

/// Gives the cells of a row whose bit is set a value; tells how many they are. Domain: no bit beyond the row.
template <class Cell>
std::int64_t paint_bits(std::span<Cell> cells, std::span<const Word> bits, const Cell& value) {
  const Cell ink = value;
  std::int64_t painted = 0;
  for (const Word some : bits) {
    const auto here = cells.first(std::min<std::size_t>(word_bits, cells.size()));
    cells = cells.subspan(here.size());
    if (some == 0) continue;
    painted += count_bits(some);
    if (some == ~Word{0}) {
      std::fill_n(here.data(), word_bits, ink);
    } else if (here.size() == word_bits) {
      paint_some(here.template first<word_bits>(), some, ink);
    } else {
      paint_some(here, some, ink);
    }
  }
  return painted;
}

/// A raster as bits: whether a cell has a value. Rows are padded with 0 to whole words, and stand between
/// words of 0.
class Bitmap {
 public:
  Bitmap(int width, int height)
      : words_((static_cast<std::size_t>(width) + word_bits - 1) / word_bits),
        bits_((words_ + 1) * (static_cast<std::size_t>(height) + 1) + 1) {}

  /// Reads a row.
  template <class Cell>
  void read(int y, std::span<const Cell> cells, const Cell& value) {
    Word* word = bits_.data() + first(y);
    for (; cells.size() >= word_bits; cells = cells.subspan(word_bits)) {
      *word++ = equal_bits(cells.template first<word_bits>(), value);
    }
    if (!cells.empty()) *word = equal_bits(cells, value);
  }

  /// The words of a row.
  std::size_t words() const { return words_; }
  /// A row from its first word on; the one before it and the one behind it are 0. Row -1 is 0, too.
  const Word* row(int y) const { return bits_.data() + first(y); }
  std::size_t bytes() const { return bits_.size() * sizeof(Word); }

 private:
  std::size_t first(int y) const { return 1 + (words_ + 1) * static_cast<std::size_t>(y + 1); }

  std::size_t words_;
  std::vector<Word> bits_;
};

/// The first cells of a row's runs. `before`: the word to the left, 0 at the border.
constexpr Word starts_of(Word bits, Word before) { return bits & ~(bits << 1 | before >> (word_bits - 1)); }

/// Those bits of runs that lie at or to the right of a marked one: a mark added to its run is carried through
/// to the end. `carry`: whether the run before the word is marked. Domain: marks are set bits.
constexpr Word right_of_marks(Word bits, Word marks, Word carry) {
  return (bits & ~(bits + marks + carry)) | marks;
}

/// Those at or to the left of one.
constexpr Word left_of_marks(Word bits, Word marks) {
  for (int by = 1; by < word_bits; by *= 2) {
    marks |= bits & marks >> by;
    bits &= bits >> by;
  }
  return marks;
}

}  // namespace gradus::flood_fill
