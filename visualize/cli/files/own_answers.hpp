#pragma once
// Somebody's own answers from the disk: for `gradus check` and `gradus figure --trace`.

#include <map>
#include <string>

#include "check/answers.hpp"
#include "check/cases.hpp"
#include "check/judge.hpp"
#include "cli/figures/figure_spec.hpp"

namespace gradus::cli {

/// Finds what a topic's answers are about.
class AskedRuns {
 public:
  /// given: arguments by flags, for answers that do not say theirs.
  AskedRuns(const TopicEntry& topic, check::OwnAnswers answers, std::map<std::string, std::string> given);

  const check::OwnAnswers& answers() const { return answers_; }
  /// Throws InputError with file and line for a missing case, and arguments that the topic does not
  /// take.
  Arguments arguments_of(const check::OwnAnswer& answer);
  /// Our run of these. Throws InputError where it is too long to be kept whole.
  Trace run(const check::OwnAnswer& answer, const Arguments& arguments, const Wording& wording = {}) const;
  /// What has to be judged; the arguments and the trace must outlive it.
  check::Task task(const Arguments& arguments, const Trace& ours) const;

 private:
  const TopicEntry& topic_;
  const check::OwnAnswers answers_;
  std::map<std::string, std::string> given_;
  check::Cases cases_;
};

/// A file's answers; "-" is standard input. Throws UsageError, InputError.
check::OwnAnswers read_own_answers(const TopicEntry& topic, const std::string& path, std::string_view what);

/// The answer that "results.json#ties-1" names, or the only one of "mine.csv". Throws UsageError.
struct NamedAnswer {
  std::string path, id;
};
NamedAnswer named_answer(const std::string& text);
const check::OwnAnswer& find_answer(const check::OwnAnswers& answers, const std::string& id);

/// The figure's other side is this answer.
void set_beside(FigureSpec& spec, const AskedRuns& runs, const check::OwnAnswer& answer);

}  // namespace gradus::cli
