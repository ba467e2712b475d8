#pragma once
// Telling a run: a story calls this for each step its algorithm reports.

#include <functional>
#include <string>

#include "figure/text/number_text.hpp"
#include "figure/text/wording.hpp"
#include "figure/trace.hpp"

namespace gradus {

/// Which part of a run to keep, and in whose words to tell it. A run may be longer than memory: steps before
/// `first` only shape the drawing, steps after `first + most - 1` are only counted.
struct Recording {
  static constexpr std::int64_t default_most = 100'000;
  static constexpr std::size_t most_changes = 4'000'000;  ///< cells and marks that the kept events may change
  std::int64_t first = 0;
  std::int64_t most = default_most;  ///< events kept, finer ones included; at least 1
  Wording wording{};                 ///< in whose words the steps are told
};

/// Writes a Trace, step by step. The story fills in trace() (titles, columns, grid, backdrop) before the
/// first step.
class TraceWriter {
 public:
  explicit TraceWriter(Recording recording) : recording_(std::move(recording)) {
    trace_.wording = recording_.wording;
  }
  Trace& trace() { return trace_; }
  const Wording& wording() const { return trace_.wording; }

  /// A milestone: the next whole number. `describe(TraceStep&)` fills in sentence, fields, row …, and is only
  /// called when the step is kept; the delta is always needed.
  template <class Describe>
  void step(Delta delta, ivec2 focus, int line, Describe describe) {
    add({next_++, 0}, std::move(delta), focus, line, Level::step, describe);
    fine_ = 0;
  }
  /// A finer event after the last milestone.
  template <class Describe>
  void fine(Delta delta, ivec2 focus, int line, Describe describe) {
    add({next_ - 1, ++fine_}, std::move(delta), focus, line, Level::arithmetic, describe);
  }
  /// The next milestone gets this number: those between are not told. For stories that can jump.
  void skip_to(std::int64_t number) {
    next_ = number;
    fine_ = 0;
  }
  /// Whether nothing more is kept: from now on milestones are only counted, and the teller of a long run need
  /// not work out what they change.
  bool full() const {
    return static_cast<std::int64_t>(trace_.steps.size()) >= recording_.most ||
           changes_ >= Recording::most_changes;
  }
  /// A milestone of a full recording.
  void count_step() {
    ++next_;
    fine_ = 0;
  }
  /// The number of the last milestone so far.
  std::int64_t current() const { return next_ - 1; }
  /// That of the last event.
  StepNumber number() const { return {next_ - 1, fine_}; }

  /// Ends the run: its last step is the last milestone told. Columns without a name get the catalogue's
  /// "<topic>.column.<id>"; where there is no such text, the id is a symbol.
  Trace finish() &&;

 private:
  template <class Describe>
  void add(StepNumber number, Delta delta, ivec2 focus, int line, Level level, Describe& describe) {
    settle_numbers(delta, trace_.wording);
    if (!keep(number, delta)) return;
    TraceStep step;
    step.number = number;
    step.level = level;
    step.line = line;
    step.focus = focus;
    step.delta = std::move(delta);
    describe(step);
    settle_numbers(step, trace_.wording);
    trace_.steps.push_back(std::move(step));
  }
  bool keep(StepNumber number, const Delta& delta);

  Recording recording_;
  Trace trace_;
  std::size_t changes_ = 0;  ///< by the events kept
  std::int64_t next_ = 0;
  int fine_ = 0;
};

/// Sets what a trace says of its steps as a whole: `widest`, `changes`, `content`, `longest_sentence`,
/// `lines`. Stories that change steps after finish() call it again.
void measure_texts(Trace& trace);

}  // namespace gradus
