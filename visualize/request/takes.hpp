#pragma once
// Choosing steps of a run, and recording those that are wanted: a run may be longer than what is kept of it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "figure/alignment.hpp"
#include "figure/figure.hpp"
#include "figure/listing/pseudocode.hpp"
#include "figure/trace.hpp"
#include "stories/topic.hpp"

namespace gradus {

/// What "--step last" asks for: the run's last step, of any number.
inline constexpr StepNumber last_step{-1, 0};

/// "4", "4.1", "last". Throws UsageError naming `flag`.
StepNumber read_step(std::string_view text, std::string_view flag = "--step");

/// Whole steps from first to last, every stride-th; or one finer event.
struct StepRange {
  StepNumber first, last;
  std::int64_t stride = 1;
  bool holds(StepNumber number) const;
};
/// "3-9", "1,4,9-12", "0-100/5", "4.1". Throws UsageError naming `flag`.
std::vector<StepRange> read_steps(std::string_view text, std::string_view flag = "--steps");
std::string text_of(const std::vector<StepRange>& ranges);
/// The numbers in the order in which they were given.
std::vector<StepNumber> numbers_in(const std::vector<StepRange>& ranges);
/// How many numbers_in would give.
std::int64_t count_in(const std::vector<StepRange>& ranges);

/// Which steps of a run are wanted; none named: all, or the one that tells most.
struct StepChoice {
  std::optional<StepNumber> step{};
  std::vector<StepRange> steps{};
  bool milestones = false;  ///< --steps auto: see milestones_of

  bool names_steps() const { return step || !steps.empty() || milestones; }
};
/// What --step and --steps say; each takes the place of the other. They return the canonical text. Throw
/// UsageError.
std::string choose_step(StepChoice& choice, std::string_view text);
std::string choose_steps(StepChoice& choice, std::string_view text);

/// A run that is none of a topic's, such as somebody's own answer, and how it stands beside ours.
struct GivenRun {
  Trace trace;          ///< whole
  Alignment alignment;  ///< of ours with it
};

/// The other run where two are compared.
struct OtherSide {
  const TopicEntry* topic = nullptr;
  Arguments arguments;
  std::string text;  ///< as the canonical command says it: "first_octant", "--receding 45,1"
  std::shared_ptr<const GivenRun> given{};  ///< it is this one, even if topic and arguments differ
};

/// The run of a topic, recorded in parts as they are asked for.
///
/// Which part a step is taken from depends on the run and the step alone, so that a step looks the same
/// whether it is drawn alone or among others.
class Takes {
 public:
  /// beside: what the run is compared with, if it is; must live as long.
  Takes(const TopicEntry& topic, const Arguments& arguments, Wording wording = {},
        ListingForm listing = ListingForm::source, const OtherSide* beside = nullptr);
  Takes(const Takes&) = delete;
  Takes& operator=(const Takes&) = delete;

  /// The run from its start, as far as it is kept.
  const Trace& opening() const { return *opening_; }
  /// The number of the run's last step.
  std::int64_t last() const { return opening_->last; }

  /// The run that it is compared with; nullptr: none.
  Takes* beside() { return beside_.get(); }
  const Takes* beside() const { return beside_.get(); }
  /// How the steps of both stand side by side, as far as they are kept.
  const Alignment& alignment() const { return alignment_; }

  /// Throws UsageError: "<topic> has steps 0..7 for this input". `flag` was given as `text`.
  void check(StepNumber number, std::string_view flag, std::string_view text) const;
  /// The step that --step names, which must exist: last_step's number, or the same one. Throws UsageError.
  StepNumber named(StepNumber step) const;
  /// The step as a figure. It stays valid until the next call. The step must be one that check() accepts.
  Figure figure(StepNumber number);

  /// The part of the run that these ranges span, and of it only what they hold. A gap in it can be shown in a
  /// table, but not be played.
  Trace part(const std::vector<StepRange>& ranges) const;

 private:
  Takes(const TopicEntry& topic, const Arguments& arguments, Wording wording, ListingForm listing,
        const OtherSide* beside, const Trace* given);
  Trace record(std::int64_t first) const;
  void record_around(StepNumber number);
  void take(std::int64_t first);

  const TopicEntry& topic_;
  const Arguments& arguments_;
  Wording wording_;
  ListingForm listing_;
  const Trace* given_;  ///< instead of a run of the topic
  std::unique_ptr<Trace> opening_, other_;
  const Trace* current_;  ///< the one that playhead_ plays
  std::unique_ptr<Playhead> playhead_;
  std::unique_ptr<Takes> beside_;
  Alignment alignment_;
};

/// The parts of the run that are chosen; empty: the opening. Throws UsageError for steps that don't exist.
std::vector<StepRange> chosen_ranges(const StepChoice& choice, const Takes& takes);
/// What they hold, as `gradus run` tells it.
Trace chosen_part(const StepChoice& choice, const Takes& takes);

/// "recorded 100000 of 16777217 steps; --steps A-B takes a range", or nothing for a whole run.
std::string cut_remark(const Trace& trace);

}  // namespace gradus
