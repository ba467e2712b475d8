#include "check/judge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "check/comparison.hpp"

namespace gradus::check {
namespace {

/// How many cells a king in chess needs from one to the other.
std::int64_t moves_between(ivec2 a, ivec2 b) {
  return std::max(std::abs(std::int64_t{a.x} - b.x), std::abs(std::int64_t{a.y} - b.y));
}

/// The largest number of a run: rounding is measured by it.
double largest_number(const Trace& trace) {
  double most = 0;
  const auto look_at = [&most](const Values& values) {
    for (const Field& field : values) {
      if (const double* real = std::get_if<double>(&field.value); real && std::isfinite(*real))
        most = std::max(most, std::abs(*real));
    }
  };
  look_at(trace.result);
  for (const TraceStep& step : trace.steps) look_at(step.fields);
  return most;
}

// --- Tie rules ---------------------------------------------------------------------------------------------

/// The first step whose tie goes against a rule.
std::optional<std::int64_t> broken_at(const Task& task, const Comparison& comparison, const TieRule& rule) {
  for (const TiedCells& tie : comparison.tied_cells()) {
    if (!rule.takes(task.arguments, tie.taken, tie.other)) return tie.step;
  }
  return std::nullopt;
}

std::vector<std::string> rules_kept(const Task& task, const Comparison& comparison) {
  std::vector<std::string> names;
  if (task.topic.checking) {
    for (const TieRule& rule : task.topic.checking->tie_rules) {
      if (!broken_at(task, comparison, rule)) names.push_back(rule.name);
    }
  }
  const auto [in, out] = comparison.tied_elements();
  if (in + out > 0)
    names.emplace_back(out == 0 ? "all of them in" : in == 0 ? "all of them out" : "by another rule");
  return names;
}

/// A declared rule is to be kept, also where that is not ours.
void require_rule(const Task& task, const Comparison& comparison, const std::string& wanted,
                  Judgement& judgement) {
  if (wanted == "any" || judgement.verdict == Verdict::wrong) return;
  const auto fail = [&](std::int64_t step) {
    judgement.verdict = Verdict::wrong;
    judgement.step = step;
    judgement.what = fmt::format("a tie that does not go by the rule {}", wanted);
  };
  if (wanted == "ours") {
    const auto tie = std::ranges::find(comparison.differences(), true, &Difference::tie);
    if (tie != comparison.differences().end()) fail(tie->step);
    return;
  }
  const auto rule = std::ranges::find(task.topic.checking->tie_rules, wanted, &TieRule::name);
  if (const auto step = broken_at(task, comparison, *rule)) fail(*step);
}

// --- Hints -------------------------------------------------------------------------------------------------

/// Whether a result is this one.
bool same_result(const Task& task, const Translated& theirs, const Trace& other, double tolerance) {
  const Expected expected = expected_of(task.topic, other);
  Translated by_other{.values = theirs.values, .lists = {}, .steps = {}};
  for (const Translated::List& list : theirs.lists) {
    const auto ours = std::ranges::find(expected.lists, list.ours->name, &ExpectedList::name);
    if (ours == expected.lists.end()) return false;
    by_other.lists.push_back({&*ours, list.elements});
  }
  for (const Field& field : theirs.values) {
    if (!value_of(expected.values, field.name)) return false;
  }
  const Task other_task{task.topic, task.arguments, other, {}};
  return Comparison(other_task, expected, by_other, tolerance).differences().empty();
}

/// The methods with a known fault that answer the same.
void add_faulty_methods(const Task& task, const Translated& theirs, double tolerance,
                        std::vector<std::string>& hints) {
  if (!task.other_method || (theirs.lists.empty() && theirs.values.empty())) return;
  for (const Method& method : task.topic.methods) {
    if (method.standing != Standing::faulty || method.name == task.ours.method) continue;
    try {
      const Trace other = task.other_method(method.name);
      if (other.whole() && same_result(task, theirs, other, tolerance))
        hints.push_back(fmt::format("method {} answers the same ({})", method.name, method.note));
    } catch (const std::exception&) {
      // It does not take these inputs
    }
  }
}

/// Conventions under which it would be right, and coordinates that have changed places.
void add_conventions(const Task& task, const Expected& expected, const OwnAnswers& answers,
                     const OwnAnswer& answer, double tolerance, std::vector<std::string>& hints) {
  std::vector<std::pair<Conventions, std::string>> others;
  Conventions mirrored = answers.conventions;
  mirrored.y_down = !answers.conventions.y_down.value_or(!task.ours.grid.y_up);
  others.emplace_back(
      mirrored, fmt::format("right if \"conventions\" said \"y\": \"{}\"", *mirrored.y_down ? "down" : "up"));
  Conventions transposed = answers.conventions;
  transposed.rows = !transposed.rows;
  others.emplace_back(transposed, fmt::format("right if \"conventions\" said \"vectors\": \"{}\"",
                                              transposed.rows ? "rows" : "columns"));
  if (task.topic.checking && !task.topic.checking->bits.empty()) {
    Conventions reversed = answers.conventions;
    const std::string& bits = task.topic.checking->bits;
    reversed.bits = answers.conventions.bits.empty() ? std::string(bits.rbegin(), bits.rend()) : "";
    others.emplace_back(reversed, fmt::format("right if \"conventions\" said \"bits\": \"{}\"",
                                              reversed.bits.empty() ? bits : reversed.bits));
  }
  for (const auto& [conventions, hint] : others) {
    try {
      const Translated theirs = translated(task.topic, task.ours, expected, answers, answer, conventions);
      if (Comparison(task, expected, theirs, tolerance).differences().empty()) hints.push_back(hint);
    } catch (const std::exception&) {
      // It says nothing of this topic
    }
  }
}

void add_exchanged(const Task& task, const Expected& expected, Translated theirs, double tolerance,
                   std::vector<std::string>& hints) {
  bool any = false;
  for (Translated::List& list : theirs.lists) {
    if (!list.ours->cells()) continue;
    any = true;
    for (Element& element : list.elements) element.front() = ivec2(cell_of(element).y, cell_of(element).x);
  }
  theirs.steps.clear();
  if (any && Comparison(task, expected, theirs, tolerance).differences().empty())
    hints.emplace_back("right with x and y exchanged");
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::string_view names[] = {"right", "right in another order", "right by another tie rule",
                                        "wrong"};
  return names[static_cast<std::size_t>(verdict)];
}

std::vector<std::size_t> steps_of(const Translated::List& theirs, const Expected& expected) {
  const auto& ours = theirs.ours->elements;
  std::vector<std::size_t> places;
  if (!theirs.ours->cells() || ours.empty()) return places;
  const auto place_of = [&](std::int64_t number) {
    const auto found = std::ranges::lower_bound(expected.steps, number, {},
                                                [](const TraceStep* s) { return s->number.step; });
    return found == expected.steps.end() ? expected.steps.size() - 1
                                         : static_cast<std::size_t>(found - expected.steps.begin());
  };
  std::map<std::pair<int, int>, std::int64_t> step_of;
  for (const ExpectedElement& element : ours)
    step_of.try_emplace({cell_of(element.values).x, cell_of(element.values).y}, element.step);
  std::size_t at_their_place = 0;
  for (std::size_t i = 0; i < std::min(ours.size(), theirs.elements.size()); ++i)
    at_their_place += ours[i].values == theirs.elements[i];
  const bool in_order = 2 * at_their_place >= std::min(ours.size(), theirs.elements.size());
  for (std::size_t i = 0; i < theirs.elements.size(); ++i) {
    const ivec2 cell = cell_of(theirs.elements[i]);
    const auto same = step_of.find({cell.x, cell.y});
    if (in_order) {
      places.push_back(place_of(ours[std::min(i, ours.size() - 1)].step));
    } else if (same != step_of.end()) {
      places.push_back(place_of(same->second));
    } else {
      const auto nearest = std::ranges::min_element(
          ours, {}, [&](const ExpectedElement& e) { return moves_between(cell_of(e.values), cell); });
      places.push_back(place_of(nearest->step));
    }
  }
  return places;
}

double tolerance_of(const Task& task, const OwnAnswers& answers) {
  return answers.conventions.tolerance * largest_number(task.ours);
}

Judgement judge(const Task& task, const OwnAnswers& answers, const OwnAnswer& answer) {
  const Expected expected = expected_of(task.topic, task.ours);
  const Translated theirs = translated(task.topic, task.ours, expected, answers, answer, answers.conventions);
  const double tolerance = tolerance_of(task, answers);
  const Comparison comparison(task, expected, theirs, tolerance);
  const auto& differences = comparison.differences();
  Judgement judgement;
  judgement.wrong_cells = comparison.wrong_cells();
  judgement.what = fmt::format("{}", fmt::join(comparison.remarks(), ", "));
  judgement.ties = static_cast<std::size_t>(std::ranges::count(differences, true, &Difference::tie));
  if (!comparison.remarks().empty()) judgement.verdict = Verdict::other_order;
  if (judgement.ties > 0) {
    judgement.verdict = Verdict::other_tie;
    const auto kept = rules_kept(task, comparison);
    judgement.tie_rule = fmt::format("{}", fmt::join(kept, " or "));
  }
  const auto wrong = std::ranges::find(differences, false, &Difference::tie);
  if (wrong != differences.end()) {
    judgement.verdict = Verdict::wrong;
    judgement.what = wrong->what;
    if (wrong->shows_step) judgement.step = wrong->step;
    if (judgement.step) std::tie(judgement.later, judgement.later_text) = comparison.later(*judgement.step);
    add_faulty_methods(task, theirs, tolerance, judgement.hints);
    add_conventions(task, expected, answers, answer, tolerance, judgement.hints);
    add_exchanged(task, expected, theirs, tolerance, judgement.hints);
  }
  require_rule(task, comparison, answers.conventions.ties, judgement);
  return judgement;
}

}  // namespace gradus::check
