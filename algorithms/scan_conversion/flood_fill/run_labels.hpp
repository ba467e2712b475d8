#pragma once
// Which runs of equal cells are connected: a label for each run, found row by row, 64 cells at a time.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/contract.hpp"
#include "scan_conversion/flood_fill/bitmap.hpp"

namespace gradus::flood_fill {

using Label = std::uint32_t;

/// Disjoint sets of labels, made one after the other; each set is named by its smallest label.
/// M. M. A. Patwary, J. Blair, F. Manne, Experiments on union-find algorithms for the disjoint-set data
/// structure, SEA 2010, 411-423: Rem's algorithm.
class LabelSets {
 public:
  /// Room for so many more labels. Errors: ContractViolation when there would be more than 2^32 - 1.
  void make_room(std::size_t more) {
    const std::size_t needed = made_ + more + 1;
    expects(needed <= std::numeric_limits<Label>::max(), "{} labels are too many", needed);
    if (parents_.size() < needed) parents_.resize(std::max(needed, 2 * parents_.size()));
    parents_[made_] = static_cast<Label>(made_);
  }
  /// The label that is made next.
  Label next() const { return static_cast<Label>(made_); }
  /// Makes it, or does nothing. (Whether is hard to predict for a branch.)
  void make(bool really) {
    made_ += really;
    parents_[made_] = static_cast<Label>(made_);
  }
  /// Makes two labels' sets one; gives a label of it that is no larger than both.
  Label join(Label a, Label b) {
    while (parents_[a] != parents_[b]) {
      if (parents_[a] < parents_[b]) std::swap(a, b);
      const Label parent = std::exchange(parents_[a], parents_[b]);
      if (parent == a) break;
      a = parent;
    }
    return parents_[b];
  }
  /// From now on every label knows its set's name without a way there.
  void settle() {
    for (std::size_t i = 0; i < made_; ++i) parents_[i] = parents_[parents_[i]];  // smaller ones are settled
  }
  /// A label of the same set, no larger, and often its name.
  Label parent_of(Label label) const { return parents_[label]; }
  /// Domain: settled.
  Label name_of(std::size_t label) const { return parents_[label]; }
  std::size_t bytes() const { return made_ * sizeof(Label); }

 private:
  std::vector<Label> parents_;
  std::size_t made_ = 0;
};

/// The runs of a bitmap that are connected to one of them, directly or through others. Rows are seen twice:
/// `add` labels their runs, in `next_wanted` those of one set stay.
/// L. He, Y. Chao, K. Suzuki, A run-based two-scan labeling algorithm, IEEE Transactions on Image Processing
/// 17(5), 2008, 749-756; here with runs and where they touch found by bits, and without a list of all runs:
/// a run that touches one above stays if that one does, and the others' labels come in their order again.
///
/// reach: 0 where runs must share a column, 1 where corners connect, too.
/// Domain: fewer than 2^31 runs.
/// Cost: some ns for each run and each touch; 4 bytes for each run that touches none above.
template <int reach>
class RunLabels {
 public:
  /// words: of a row.
  explicit RunLabels(std::size_t words)
      : labels_above_(word_bits * words + at_once + 1),
        labels_here_(labels_above_),
        wanted_above_(words + 2),
        wanted_here_(wanted_above_) {}

  /// Labels the runs of the next row, from the one above.
  void add(const Word* above, const Word* here) {
    const std::size_t words = wanted_here_.size() - 2;
    if (std::equal(above, above + words, here)) return;  // the labels stay
    labels_above_.swap(labels_here_);
    sets_.make_room(words * (word_bits / 2));
    const Label* labels_above = labels_above_.data() + 1;
    Label* labels_here = labels_here_.data() + 1;
    for (std::size_t w = 0; w < words; ++w, labels_above += word_bits, labels_here += word_bits) {
      label_word(above + w, here + w, labels_above, labels_here);
    }
  }
  /// The run in this column of the row that was added last is the one that is wanted.
  void want(int column) { wanted_ = labels_here_[static_cast<std::size_t>(column) + 1]; }
  /// After the last row.
  void settle() {
    sets_.settle();
    wanted_ = sets_.name_of(wanted_);
  }

  /// The bits of the next row, from the first one on again, that are connected to the wanted run.
  std::span<const Word> next_wanted(const Word* above, const Word* here) {
    wanted_above_.swap(wanted_here_);
    // Signed, for the words on either side
    const std::ptrdiff_t words = std::ssize(wanted_here_) - 2;
    const Word* const wanted_above = wanted_above_.data() + 1;
    Word* const wanted = wanted_here_.data() + 1;
    for (std::ptrdiff_t w = 0; w < words; ++w) {
      Word marks = here[w] & widened(wanted_above[w]);
      if constexpr (reach == 1) {
        marks |= here[w] & (wanted_above[w - 1] >> (word_bits - 1) | wanted_above[w + 1] << (word_bits - 1));
      }
      marks |= wanted_ends(above[w], here[w], starts_of(here[w], here[w - 1]));
      wanted[w] = right_of_marks(here[w], marks, wanted[w - 1] >> (word_bits - 1));
    }
    for (std::ptrdiff_t w = words - 1; w >= 0; --w) {
      wanted[w] = left_of_marks(here[w], wanted[w] | (here[w] & wanted[w + 1] << (word_bits - 1)));
    }
    return {wanted, static_cast<std::size_t>(words)};
  }

  std::size_t bytes() const {
    return sets_.bytes() + 2 * (labels_here_.size() * sizeof(Label) + wanted_here_.size() * sizeof(Word));
  }

 private:
  /// A run's label is written to so many cells, before it is asked whether there are more.
  static constexpr int at_once = 8;
  static constexpr Word last_bit = Word{1} << (word_bits - 1);

  /// With the cells beside them, where corners connect.
  static constexpr Word widened(Word bits) { return reach == 0 ? bits : bits | bits << 1 | bits >> 1; }

  /// Labels a word's runs: each of their cells has the label, for the row below. Whether a run is new, and
  /// where it touches, is hard to predict: bits say it, not branches.
  void label_word(const Word* above, const Word* here, const Label* labels_above, Label* labels_here) {
    const Word bits = *here;
    const bool continued = (bits & here[-1] >> (word_bits - 1)) != 0;
    const Word touches = starts_of(bits & *above, here[-1] & above[-1]);
    if (reach == 0 && bits == *above) {  // the same runs again
      std::copy_n(labels_above, word_bits, labels_here);
      if (continued && (touches & 1) != 0) join(labels_here[-1], labels_here[0]);
      return;
    }
    if (continued) std::fill_n(labels_here, std::countr_one(bits), labels_here[-1]);
    // A first cell added to its run is carried to the first that touches
    const Word starts = starts_of(bits, here[-1]), carried = (bits & ~touches) + starts;
    const Word is_new = starts & ~left_of_marks(bits, touches);
    Word first_touches = touches & carried;
    for (Word rest = starts; rest != 0; rest &= rest - 1) {
      const int first = std::countr_zero(rest);
      const Word fresh = is_new >> first & 1;
      const Label touched = sets_.parent_of(labels_above[std::countr_zero(first_touches | last_bit)]);
      const Label label = touched ^ ((touched ^ sets_.next()) & -static_cast<Label>(fresh));
      sets_.make(fresh);
      first_touches &= (first_touches - 1) | -fresh;
      std::fill_n(labels_here + first, at_once, label);
      if (const Word run = bits >> first; (~run & up_to(at_once)) == 0) {
        std::fill_n(labels_here + first + at_once, std::countr_one(run) - at_once, label);
      }
    }
    for (Word more = touches & ~carried; more != 0; more &= more - 1) {
      const int at = std::countr_zero(more);
      join(labels_here[at], labels_above[at]);
    }
    if constexpr (reach == 1) join_corners(above, here, labels_above, labels_here);
  }
  /// Joins the runs of a word with those that they touch by a corner alone.
  void join_corners(const Word* above, const Word* here, const Label* labels_above,
                    const Label* labels_here) {
    const Word ends = *here & ~*above;
    const Word from_left = ends & starts_of(*here, here[-1]) & (*above << 1 | above[-1] >> (word_bits - 1));
    const Word last = ~(*here >> 1 | here[1] << (word_bits - 1));
    const Word from_right = ends & last & (*above >> 1 | above[1] << (word_bits - 1));
    for (Word rest = from_left; rest != 0; rest &= rest - 1) {
      const int at = std::countr_zero(rest);
      join(labels_here[at], labels_above[at - 1]);
    }
    for (Word rest = from_right; rest != 0; rest &= rest - 1) {
      const int at = std::countr_zero(rest);
      join(labels_here[at], labels_above[at + 1]);
    }
  }
  void join(Label a, Label b) {
    if (a != b) sets_.join(a, b);
  }

  /// The last cells, within a word, of those runs begun there that touch none above it and are wanted.
  Word wanted_ends(Word above, Word here, Word starts) {
    // A first cell added to what touches none is carried to the cell behind the run, or to one that touches
    const Word sum = (here & ~above) + starts;
    Word wanted = 0;
    for (Word ends = (sum & ~here) >> 1 | Word{sum < starts} << (word_bits - 1); ends != 0;
         ends &= ends - 1) {
      wanted |= ends & -ends & -Word{sets_.name_of(next_label_++) == wanted_};
    }
    return wanted;
  }

  std::vector<Label> labels_above_, labels_here_;  ///< one stands before a row's first cell
  std::vector<Word> wanted_above_, wanted_here_;   ///< between two words of 0
  LabelSets sets_;
  Label wanted_ = 0;
  std::size_t next_label_ = 0;
};

}  // namespace gradus::flood_fill
