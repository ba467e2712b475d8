#pragma once
// Two runs step beside step: which of their whole steps belong together, and where they part.

#include <optional>
#include <vector>

#include "figure/trace.hpp"

namespace gradus {

/// A step of each run.
struct StepPair {
  StepNumber a, b;
  friend bool operator==(const StepPair&, const StepPair&) = default;
};

/// Every whole step of either run, in order, with the one of the other run that it stands beside: the one
/// that is about the same (TraceStep::key, else its type), where there is such a one near; else the one that
/// comes at the same place. A run that has ended keeps its last step.
struct Alignment {
  std::vector<StepPair> pairs;  ///< neither number ever falls
  /// The first pair behind the input that tells of something else: another place or kind of step, another
  /// branch, another value of the same name. Nothing: the runs are the same but for their input.
  std::optional<std::size_t> parting;
};
Alignment align(const Trace& a, const Trace& b);

/// The first pair with this step of the first run; with its last step the last pair. The step must be one of
/// a pair.
StepPair pair_with(const Alignment& alignment, StepNumber a);

/// Whether two steps tell of different things.
bool tells_otherwise(const TraceStep& a, const TraceStep& b);

}  // namespace gradus
