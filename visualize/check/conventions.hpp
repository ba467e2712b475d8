#pragma once
// In which conventions somebody's answers are written, and the same answers in ours.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stories/checking.hpp"

namespace gradus::check {

/// Nothing said: as ours.
struct Conventions {
  std::optional<bool> y_down{};          ///< rows are counted from the top, or from the bottom
  std::optional<std::int64_t> height{};  ///< rows of the picture; none: those of the figure's grid
  std::string bits{};                    ///< what each digit of a code stands for
  bool rows = false;                     ///< vectors are rows, so that matrices are transposed
  std::string ties = "any";              ///< any; or the name of a rule that is to be kept, "ours"
  double tolerance = 1e-6;               ///< of real numbers, for a largest number of 1
};

/// Turns values and cells of one answer into ours.
class Translation {
 public:
  /// Throws UsageError for a convention that says nothing about this topic or run.
  Translation(const TopicEntry& topic, const Trace& ours, const Conventions& conventions);

  ivec2 cell(ivec2 theirs) const;
  /// In place: cells, codes, elements of a matrix.
  void turn(Values& values) const;
  bool idle() const { return !sum_ && digits_.empty() && !transposed_; }

 private:
  std::optional<std::int64_t> sum_;  ///< row + y
  std::vector<int> digits_;          ///< for each of our digits, the lowest first, the place of theirs
  bool transposed_ = false;
  const Checking* checking_;
};

}  // namespace gradus::check
