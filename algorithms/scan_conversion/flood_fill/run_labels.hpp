#pragma once
// Which runs of equal cells are connected: a label for each run, found row by row, 64 cells at a time.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "core/raster.hpp"

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

#ifdef __SSE2__
/// The same for 64 bytes: their differences' sign bits, 16 at a time.
inline Word equal_bits(std::span<const std::uint8_t, word_bits> cells, std::uint8_t value) {
  const __m128i wanted = _mm_set1_epi8(static_cast<char>(value));
  Word bits = 0;
  for (std::size_t first = 0; first < word_bits; first += 16) {
    const __m128i some = _mm_loadu_si128(reinterpret_cast<const __m128i*>(cells.data() + first));
    bits |= Word{static_cast<std::uint16_t>(_mm_movemask_epi8(_mm_cmpeq_epi8(some, wanted)))} << first;
  }
  return bits;
}
#endif

/// The other way: gives the cells whose bit is set a value. Domain: no bit beyond the cells.
template <class Cell>
void paint_bits(std::span<Cell> cells, Word bits, const Cell& value) {
  const Cell ink = value;
  if (bits == ~Word{0}) {
    std::fill_n(cells.data(), word_bits, ink);
  } else if (bits != 0) {
    std::array<std::uint8_t, word_bits> set;
    for (std::size_t i = 0; i < word_bits; ++i) set[i] = bits >> i & 1;
    if (cells.size() == word_bits) {
      for (std::size_t i = 0; i < word_bits; ++i) cells[i] = set[i] ? ink : cells[i];
    } else {
      for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = set[i] ? ink : cells[i];
    }
  }
}

/// A raster as bits: whether a cell has a value. Rows are padded with 0 to whole words.
class Bitmap {
 public:
  template <class Cell>
  Bitmap(const Raster<Cell>& raster, const Cell& value)
      : words_((static_cast<std::size_t>(raster.width()) + word_bits - 1) / word_bits),
        bits_(words_ * static_cast<std::size_t>(raster.height())) {
    auto word = bits_.begin();
    for (int y = 0; y < raster.height(); ++y) {
      std::span<const Cell> rest = raster.row(y);
      for (; rest.size() >= word_bits; rest = rest.subspan(word_bits)) {
        *word++ = equal_bits(rest.template first<word_bits>(), value);
      }
      if (!rest.empty()) *word++ = equal_bits(rest, value);
    }
  }
  std::span<const Word> row(int y) const {
    return {bits_.data() + words_ * static_cast<std::size_t>(y), words_};
  }
  std::size_t bytes() const { return bits_.size() * sizeof(Word); }

 private:
  std::size_t words_;
  std::vector<Word> bits_;
};

/// The first cells of a row's runs. `before`: the word to the left, 0 at the border.
constexpr Word starts_of(Word bits, Word before) { return bits & ~(bits << 1 | before >> (word_bits - 1)); }

using Label = std::uint32_t;

/// Disjoint sets of labels; each is named by its smallest.
/// R. E. Tarjan, Efficiency of a good but not linear set union algorithm, Journal of the ACM 22(2), 1975.
class LabelSets {
 public:
  Label make() {
    parents_.push_back(static_cast<Label>(parents_.size()));
    return parents_.back();
  }
  /// The set's name. Halves the way there for the next time.
  Label find(Label label) {
    while (parents_[label] != label) label = parents_[label] = parents_[parents_[label]];
    return label;
  }
  Label join(Label a, Label b) {
    a = find(a), b = find(b);
    if (b < a) std::swap(a, b);
    return parents_[b] = a;
  }
  /// From now on every label knows its set's name without a way there.
  void settle() {
    for (Label& parent : parents_) parent = parents_[parent];  // smaller ones are settled already
  }
  /// The same as find. Domain: settled.
  Label name_of(Label label) const { return parents_[label]; }
  std::size_t bytes() const { return parents_.size() * sizeof(Label); }

 private:
  std::vector<Label> parents_;
};

/// The labels of all runs of a bitmap: equal sets where runs are connected, directly or through others.
/// L. He, Y. Chao, K. Suzuki, A run-based two-scan labeling algorithm, IEEE Transactions on Image Processing
/// 17(5), 2008, 749-756; here with runs and their overlaps found by bits.
///
/// reach: 0 where runs must share a column, 1 where corners connect, too.
/// Domain: fewer than 2^32 - 1 runs.
/// Cost: one pass; a few ns per word, and some 15 ns for each overlap of two runs.
class RunLabels {
 public:
  RunLabels(const Bitmap& bitmap, int height, int reach) : first_run_(static_cast<std::size_t>(height) + 1) {
    for (int y = 0; y < height; ++y) count_runs(bitmap.row(y), y);
    expects(first_run_.back() < none, "runs have numbers below {}, but there are {}", none,
            first_run_.back());
    of_run_.assign(first_run_.back(), none);
    for (int y = 0; y < height; ++y) {
      for (int aside = -reach; y > 0 && aside <= reach; ++aside) {
        join_rows(bitmap.row(y - 1), bitmap.row(y), y, aside);
      }
      for (std::size_t run = first_run(y); run < first_run(y + 1); ++run) {
        if (of_run_[run] == none) of_run_[run] = sets_.make();
      }
    }
    sets_.settle();
  }

  /// The number of a row's first run.
  std::size_t first_run(int y) const { return first_run_[static_cast<std::size_t>(y)]; }
  /// The number of the run that a cell belongs to. Domain: the cell's bit is set.
  std::size_t run_at(const Bitmap& bitmap, ivec2 cell) const {
    std::size_t run = first_run(cell.y);
    Word before = 0;
    const std::span<const Word> row = bitmap.row(cell.y);
    const auto last = static_cast<std::size_t>(cell.x / word_bits);
    for (std::size_t w = 0; w < last; ++w) {
      run += count(starts_of(row[w], before));
      before = row[w];
    }
    return run + count(starts_of(row[last], before) & up_to(cell.x % word_bits)) - 1;
  }
  /// The name of the set that a run belongs to.
  Label set_of(std::size_t run) const { return sets_.name_of(of_run_[run]); }
  std::size_t bytes() const { return of_run_.size() * sizeof(Label) + sets_.bytes(); }

 private:
  static constexpr Label none = ~Label{0};

  void count_runs(std::span<const Word> here, int y) {
    std::size_t runs = first_run(y);
    Word before = 0;
    for (const Word bits : here) {
      const Word starts = starts_of(bits, before);
      if (starts != 0) runs += count(starts);
      before = bits;
    }
    first_run_[static_cast<std::size_t>(y) + 1] = runs;
  }

  /// Joins each run with those above it, the row above moved aside by -1, 0 or 1 cells.
  void join_rows(std::span<const Word> above, std::span<const Word> here, int y, int aside) {
    std::size_t run_here = first_run(y);
    std::size_t run_above = first_run(y - 1);
    if (aside < 0 && (above.front() & 3) == 1) ++run_above;  // one of a single cell has moved out
    Word before_here = 0, before_above = 0, before_both = 0;
    for (std::size_t w = 0; w < here.size(); ++w) {
      const Word moved = moved_aside(above, w, aside);
      const Word start_here = starts_of(here[w], before_here), start_above = starts_of(moved, before_above);
      const Word both = here[w] & moved;
      if ((start_here | start_above) != 0) {  // else no overlap begins, either
        for (Word overlaps = starts_of(both, before_both); overlaps != 0; overlaps &= overlaps - 1) {
          const Word so_far = up_to(std::countr_zero(overlaps));
          join(run_here + count(start_here & so_far) - 1, run_above + count(start_above & so_far) - 1);
        }
        run_here += count(start_here);
        run_above += count(start_above);
      }
      before_here = here[w], before_above = moved, before_both = both;
    }
  }

  static std::size_t count(Word bits) { return static_cast<std::size_t>(count_bits(bits)); }

  /// A run's first overlap gives it a label; others that it has already in common cost a comparison.
  void join(std::size_t run, std::size_t above) {
    Label& label = of_run_[run];
    const Label other = of_run_[above];
    label = label == none ? other : label;
    if (label != other) label = sets_.join(label, other);
  }

  static Word moved_aside(std::span<const Word> row, std::size_t w, int aside) {
    if (aside > 0) return row[w] << 1 | (w > 0 ? row[w - 1] >> (word_bits - 1) : 0);
    if (aside < 0) return row[w] >> 1 | (w + 1 < row.size() ? row[w + 1] << (word_bits - 1) : 0);
    return row[w];
  }

  std::vector<std::size_t> first_run_;
  std::vector<Label> of_run_;
  LabelSets sets_;
};

}  // namespace gradus::flood_fill
