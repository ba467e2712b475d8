#pragma once
// Where a translated answer differs from ours, and which differences are ties that went otherwise.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "check/judge.hpp"

namespace gradus::check {

struct Difference {
  std::int64_t step;  ///< of ours
  std::string what;
  bool tie = false;        ///< either is as good
  bool shows_step = true;  ///< whether `step` is where it arose, not only where it came out
};

/// Two cells that are as near, and which of them was taken.
struct TiedCells {
  std::int64_t step;
  ivec2 taken, other;
};

/// Compares one answer; all are collected, none judged.
class Comparison {
 public:
  Comparison(const Task& task, const Expected& expected, const Translated& theirs, double tolerance);

  const std::vector<Difference>& differences() const { return differences_; }
  /// What differs and does not matter: "in another order", "2 pixels more than once".
  const std::vector<std::string>& remarks() const { return remarks_; }
  const std::vector<ivec2>& wrong_cells() const { return wrong_cells_; }
  /// Every tie of a run that draws cells, with the cell that was taken.
  const std::vector<TiedCells>& tied_cells() const { return tied_; }
  /// Of lists with one element per step that may or may not be taken: ties that were, and that were not.
  std::pair<std::size_t, std::size_t> tied_elements() const { return {tied_in_, tied_out_}; }

  /// Whether what comes behind the first difference follows from it, and what is said of that.
  std::pair<Follows, std::string> later(std::int64_t first_step) const;

 private:
  void compare_values();
  void compare_list(const Translated::List& theirs);
  void compare_set(const Translated::List& theirs);
  void compare_segments(const Translated::List& theirs);
  void compare_rings(const Translated::List& theirs);
  void compare_in_order(const Translated::List& theirs);
  void compare_as_sets(const Translated::List& theirs);
  void compare_steps();
  void compare_step(std::size_t i);
  void find_tied_cells(const Translated::List& theirs);
  bool may_choose(const ExpectedList& list) const;
  bool is_ours_and_more(const Translated::List& theirs) const;
  bool near(ivec2 a, ivec2 b) const;
  bool is_tied(const ExpectedList& list, const Element& element) const;
  Follows follows(std::size_t i) const;
  std::pair<Follows, std::string> later_steps(std::int64_t first_step) const;
  std::pair<Follows, std::string> later_cells() const;

  const Task& task_;
  const Expected& expected_;
  const Translated& theirs_;
  const double tolerance_;
  std::vector<Difference> differences_;
  std::vector<std::string> remarks_;
  std::vector<ivec2> wrong_cells_;
  std::vector<TiedCells> tied_;
  std::size_t tied_in_ = 0, tied_out_ = 0;
  std::vector<Values> steps_;  ///< theirs, as far as they stand for ours
  std::vector<const TraceStep*> stand_for_;
  const Translated::List* in_order_ = nullptr;  ///< cells, compared one by one
  std::size_t first_wrong_ = 0;                 ///< place in it
};

}  // namespace gradus::check
