#include "figure/which_steps.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

namespace gradus {
namespace {

bool is_whole(const TraceStep& step) { return step.number.fine == 0; }

/// Neither braces and brackets alone nor a comment alone nor a function's heading.
bool is_code(std::string_view line) {
  if (is_heading(line)) return false;
  const std::size_t first = line.find_first_not_of(" {}();,");
  return first != line.npos && !line.substr(first).starts_with("//");
}

using StepTest = bool (*)(const Trace& trace, const TraceStep& step);

bool has_code(const Trace& trace, const TraceStep& step) {
  return code_line(trace.listing, step.line).has_value();
}
bool decides(const Trace& trace, const TraceStep& step) { return step.decision && has_code(trace, step); }
bool decides_behind_the_input(const Trace& trace, const TraceStep& step) {
  return step.number.step > 0 && decides(trace, step);
}
bool decides_as_a_whole(const Trace& trace, const TraceStep& step) {
  return is_whole(step) && decides_behind_the_input(trace, step);
}
bool decides_alone(const Trace& trace, const TraceStep& step) {
  return step.level == Level::step && decides_as_a_whole(trace, step);
}
bool follows_the_input(const Trace& trace, const TraceStep& step) {
  return is_whole(step) && step.number.step > 0 && has_code(trace, step);
}

/// What a telling step is, the best first.
constexpr StepTest telling_tests[] = {decides_alone, decides_as_a_whole, decides_behind_the_input,
                                      decides,       follows_the_input,  has_code};

struct Phase {
  std::string_view name;
  std::vector<const TraceStep*> steps;
};

/// The steps that pass, by phase in the order of the run; never the last.
std::vector<Phase> by_phase(const Trace& trace, StepTest passes) {
  std::vector<Phase> phases;
  for (const TraceStep& step : trace.steps) {
    if (step.number.step == trace.last || !passes(trace, step)) continue;
    if (phases.empty() || phases.back().name != step.phase) phases.push_back({step.phase, {}});
    phases.back().steps.push_back(&step);
  }
  return phases;
}

/// What kind of step it is: its branch, else the source line that reported it.
std::string kind_of(const TraceStep& step) {
  return step.decision ? step.decision->branch : "line " + std::to_string(step.line);
}

/// Of the rarest kinds the one nearest to the middle: what happens seldom tells most.
StepNumber rare_and_central(const std::vector<const TraceStep*>& steps) {
  std::map<std::string, std::size_t> count;
  for (const TraceStep* step : steps) ++count[kind_of(*step)];
  const std::size_t rarest =
      std::ranges::min_element(count, {}, [](const auto& c) { return c.second; })->second;
  const auto middle = std::ssize(steps) / 2;
  std::optional<std::ptrdiff_t> best;
  for (std::ptrdiff_t i = 0; i < std::ssize(steps); ++i) {
    if (count[kind_of(*steps[static_cast<std::size_t>(i)])] != rarest) continue;
    if (!best || std::abs(i - middle) < std::abs(*best - middle)) best = i;
  }
  return steps[static_cast<std::size_t>(*best)]->number;
}

/// Steps that together show what can happen, each for something that no other one shows.
class Milestones {
 public:
  void take(const TraceStep& step) {
    chosen_.emplace(step.number, &step);
    phases_.insert(step.phase);
    sentences_.insert(step.sentence);
  }

  /// One step of each group, `group_of` naming a step's (empty: none), unless one is there: the seldom ones
  /// first, so that frequent ones can be shown in another phase.
  template <class GroupOf>
  void take_one_of_each(const Trace& trace, GroupOf group_of) {
    std::map<std::string, std::vector<const TraceStep*>> groups;
    for (const TraceStep& step : trace.steps) {
      if (const std::string group = group_of(step); !group.empty()) groups[group].push_back(&step);
    }
    for (const auto& [number, step] : chosen_) groups.erase(group_of(*step));
    std::vector<const std::vector<const TraceStep*>*> by_size;
    for (const auto& [name, steps] : groups) by_size.push_back(&steps);
    std::ranges::stable_sort(by_size, {}, [](const auto* steps) { return steps->size(); });
    for (const auto* steps : by_size) {
      const TraceStep& step = most_telling(*steps);
      const bool says_nothing_new = sentences_.contains(step.sentence) && phases_.contains(step.phase);
      if (step.decision || !says_nothing_new) take(step);
    }
  }

  std::vector<StepNumber> numbers() const {
    std::vector<StepNumber> all;
    for (const auto& [number, step] : chosen_) all.push_back(number);
    return all;
  }

 private:
  /// What no other step says, by the story's own word, in a phase that isn't shown yet, near the middle.
  const TraceStep& most_telling(const std::vector<const TraceStep*>& steps) const {
    const auto middle = std::ssize(steps) / 2;
    const auto rank = [&](std::ptrdiff_t i) {
      const TraceStep& step = *steps[static_cast<std::size_t>(i)];
      return std::tuple(sentences_.contains(step.sentence), -step.tells, phases_.contains(step.phase),
                        std::abs(i - middle));
    };
    std::ptrdiff_t best = 0;
    for (std::ptrdiff_t i = 1; i < std::ssize(steps); ++i) {
      if (rank(i) < rank(best)) best = i;
    }
    return *steps[static_cast<std::size_t>(best)];
  }

  std::map<StepNumber, const TraceStep*> chosen_;
  std::set<std::string_view> phases_, sentences_;
};

/// At most so many of them, the first and the last among these.
std::vector<const TraceStep*> evenly_spread(const std::vector<const TraceStep*>& steps, std::size_t most) {
  if (steps.size() <= most) return steps;
  std::vector<const TraceStep*> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(steps[i * (steps.size() - 1) / (most - 1)]);
  return some;
}

/// Of steps with notes the most telling of each note, near the middle, where three notes or more are told
/// apart; else all of them.
std::vector<const TraceStep*> one_of_each_note(const std::vector<const TraceStep*>& steps) {
  std::map<std::string_view, std::vector<const TraceStep*>> groups;
  for (const TraceStep* step : steps) groups[step->note].push_back(step);
  if (groups.size() < 3) return steps;
  std::vector<const TraceStep*> some;
  for (const auto& [note, group] : groups) {
    const auto middle = std::ssize(group) / 2;
    const auto rank = [&](std::ptrdiff_t i) {
      return std::pair(-group[static_cast<std::size_t>(i)]->tells, std::abs(i - middle));
    };
    std::ptrdiff_t best = 0;
    for (std::ptrdiff_t i = 1; i < std::ssize(group); ++i) best = rank(i) < rank(best) ? i : best;
    some.push_back(group[static_cast<std::size_t>(best)]);
  }
  std::ranges::sort(some, {}, [](const TraceStep* step) { return step->number; });
  return some;
}

std::vector<StepNumber> numbers_of(const std::vector<const TraceStep*>& steps) {
  std::vector<StepNumber> numbers;
  for (const TraceStep* step : steps) numbers.push_back(step->number);
  return numbers;
}

}  // namespace

std::optional<std::size_t> code_line(const std::vector<SourceLine>& listing, int line) {
  const auto after = std::ranges::upper_bound(listing, line, {}, &SourceLine::number);
  for (auto at = static_cast<std::size_t>(after - listing.begin()); line != 0 && at-- > 0;) {
    if (is_code(listing[at].text)) return at;
  }
  return std::nullopt;
}

StepNumber telling_step(const Trace& trace) {
  for (const StepTest passes : telling_tests) {
    const auto phases = by_phase(trace, passes);
    if (phases.empty()) continue;
    return rare_and_central(
        std::ranges::max_element(phases, {}, [](const Phase& phase) { return phase.steps.size(); })->steps);
  }
  return middle_step(trace);
}

std::vector<StepNumber> milestones_of(const Trace& trace) {
  const auto first = std::ranges::find_if(trace.steps, is_whole);
  const auto last = std::ranges::find_if(trace.steps.rbegin(), trace.steps.rend(), is_whole);
  if (first == trace.steps.end()) return {};
  Milestones milestones;
  if (has_step(trace, trace.telling)) milestones.take(trace.steps[index_of(trace, trace.telling)]);
  const auto deciding_phase = [](const TraceStep& step) {
    return is_whole(step) && step.decision ? step.phase : "";
  };
  std::set<std::string> deciding;
  for (const TraceStep& step : trace.steps) deciding.insert(deciding_phase(step));
  // Of what happens between the ends; these are shown anyway
  milestones.take_one_of_each(trace, [&](const TraceStep& step) {
    return is_whole(step) && &step != &*first && &step != &*last ? kind_of(step) : "";
  });
  milestones.take(*first);
  milestones.take(*last);
  milestones.take_one_of_each(trace, [&](const TraceStep& step) {
    return !is_whole(step) && step.decision && !deciding.contains(step.phase) ? kind_of(step) : "";
  });
  milestones.take_one_of_each(trace, deciding_phase);
  milestones.take_one_of_each(trace, [](const TraceStep& step) { return is_whole(step) ? step.phase : ""; });
  return milestones.numbers();
}

std::vector<StepNumber> phase_steps(const Trace& trace, std::size_t most) {
  const std::string set_up = trace.wording.say("words.set_up"), result = trace.wording.say("words.result");
  std::vector<const TraceStep*> between, noted, ends_of_phase, all;
  for (const TraceStep& step : trace.steps) {
    if (!is_whole(step)) continue;
    all.push_back(&step);
    if (step.phase == result) continue;
    if (!step.note.empty()) noted.push_back(&step);
    if (step.phase == set_up) continue;
    if (!ends_of_phase.empty() && ends_of_phase.back()->phase == step.phase) ends_of_phase.pop_back();
    ends_of_phase.push_back(&step);
    between.push_back(&step);
  }
  if (noted.size() > 1) between = one_of_each_note(noted);
  if (ends_of_phase.size() > 1) return numbers_of(evenly_spread(ends_of_phase, most));
  const std::size_t most_of_one = trace.grid.axes ? 6 : 4;
  return numbers_of(evenly_spread(between.size() > 1 ? between : all, std::min(most, most_of_one)));
}

StepNumber middle_step(const Trace& trace) {
  const std::size_t middle = trace.steps.size() / 2;
  for (std::size_t i = middle; i < trace.steps.size(); ++i) {
    if (is_whole(trace.steps[i])) return trace.steps[i].number;
  }
  return trace.steps.empty() ? StepNumber{} : StepNumber{trace.steps.front().number.step, 0};
}

}  // namespace gradus
