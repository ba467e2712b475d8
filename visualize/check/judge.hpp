#pragma once
// Judging somebody's answer by our own run of the same case.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check/answers.hpp"
#include "check/expected.hpp"

namespace gradus::check {

/// An answer in our conventions, each value of the kind that ours has.
struct Translated {
  struct List {
    const ExpectedList* ours;
    std::vector<Element> elements;
  };
  struct Step {
    Values values;
    std::optional<std::size_t> stands_for;  ///< place in Expected::steps; nothing: a step more than ours
  };
  Values values;
  std::vector<List> lists;
  std::vector<Step> steps;
  bool empty() const { return values.empty() && lists.empty() && steps.empty(); }
};

/// Errors: InputError with file and line for names that our answer has not, values of another kind;
/// UsageError for conventions that say nothing here.
Translated translated(const TopicEntry& topic, const Trace& ours, const Expected& expected,
                      const OwnAnswers& answers, const OwnAnswer& answer, const Conventions& conventions);

enum class Verdict : std::uint8_t { right, other_order, other_tie, wrong };
std::string_view name_of(Verdict verdict);

struct Judgement {
  Verdict verdict = Verdict::right;
  std::string what{};                ///< wrong: the first difference; else what differs and does not matter
  std::optional<std::int64_t> step;  ///< wrong: from which step on, as far as that can be told
  std::size_t ties = 0;              ///< how many decisions are ties that went otherwise
  std::string tie_rule{};            ///< the rule that all its ties go by, where it has a name
  Follows later = Follows::untold;   ///< wrong: whether what comes behind follows from there
  std::string later_text{};
  std::vector<std::string> hints{};  ///< wrong: what would explain it
  std::vector<ivec2> wrong_cells{};  ///< theirs that are not ours, ties left out
};

/// What is judged, and what is needed for it.
struct Task {
  const TopicEntry& topic;
  const Arguments& arguments;
  const Trace& ours;  ///< the whole run
  /// The run of the same with another method; throws as runs do.
  std::function<Trace(const std::string& method)> other_method;
};

/// How far real numbers of an answer may be off.
double tolerance_of(const Task& task, const OwnAnswers& answers);

/// Errors: as translated() does.
Judgement judge(const Task& task, const OwnAnswers& answers, const OwnAnswer& answer);

/// The step of ours that each of their cells belongs to, by its place in Expected::steps: by place in the
/// list where the orders agree, else that of the same or nearest cell of ours.
std::vector<std::size_t> steps_of(const Translated::List& theirs, const Expected& expected);

}  // namespace gradus::check
