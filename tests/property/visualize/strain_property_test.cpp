// Every topic under numbers of any size: its run ends, in little memory, with numbers throughout and with
// sentences that bear out their own numbers; or it says by a flag that was given what it can't take.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <string>
#include <vector>

#include "figure/figure.hpp"
#include "figure/text/number_text.hpp"
#include "figure/which_steps.hpp"
#include "stories/topic.hpp"
#include "support/claims.hpp"
#include "support/odd_arguments.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/share.hpp"
#include "support/sheets.hpp"
#include "support/stress.hpp"

namespace gradus {
namespace {

/// What one run may take of the clock, the program of memory, and a step of the drawing.
constexpr unsigned most_seconds = 60;
constexpr rlim_t most_bytes = rlim_t{3} << 30;
constexpr std::size_t most_marks = 20'000;
/// No mark lies farther from the paper: beyond it a drawing's own arithmetic is too coarse.
constexpr double farthest = 1e10;
/// Of a run's steps so many are looked at.
constexpr std::int64_t most_steps = 400;

/// What is being run, for the signal that ends a run without end.
char running[8192];

extern "C" void give_up(int) {
  constexpr char what[] = "\nno end of: ";
  [[maybe_unused]] auto written = write(STDERR_FILENO, what, sizeof what - 1);
  written = write(STDERR_FILENO, running, std::strlen(running));
  written = write(STDERR_FILENO, "\n", 1);
  _exit(1);
}

std::string command_of(const TopicEntry& topic, const std::vector<Argument>& given) {
  std::string text = "gradus run " + topic.name;
  for (const Argument& a : given) text += fmt::format(" --{} '{}'", a.name, a.value);
  return text;
}

/// Collects what is wrong with a run, in words.
class Judge {
 public:
  /// The depth of a pixel that shows nothing yet is ∞, and said to be.
  explicit Judge(const TopicEntry& topic) : says_infinity_(topic.name == "z_buffer") {}

  void trace(const Trace& trace) {
    for (const std::string* told :
         {&trace.title, &trace.subtitle, &trace.faulty, &trace.goal, &trace.method_title})
      text("heading", *told);
    for (const Column& column : trace.columns) text("column", column.name);
    for (const LegendEntry& entry : trace.legend) text("legend", entry.text);
    for (const Mark& m : trace.backdrop) mark(m);
    for (const TraceStep& told : trace.steps) step(told);
    for (const Field& field : trace.result) value(field);
  }
  void sheet(const Sheet& sheet) {
    for (const Shape& shape : sheet.shapes) {
      const Box box = test::extent_of(shape);
      for (const double x : {box.x, box.y, box.width, box.height}) {
        if (!std::isfinite(x)) complain("shape {} has no place", shape.id);
      }
    }
  }
  void text(std::string_view what, std::string text) {
    constexpr std::string_view infinity = "∞";
    for (std::size_t at = 0; says_infinity_ && (at = text.find(infinity)) != std::string::npos;)
      text.erase(at, infinity.size());
    if (test::names_no_number(text)) complain("{} with no number: {}", what, text);
  }
  template <class... Values>
  void complain(fmt::format_string<Values...> format, Values&&... values) {
    wrong_.push_back(fmt::format(format, std::forward<Values>(values)...));
  }
  const std::vector<std::string>& wrong() const { return wrong_; }
  std::size_t claims() const { return claims_; }

 private:
  void step(const TraceStep& step) {
    text("sentence", step.sentence);
    const test::Claims found = test::claims_in(with_decimal_points(step.sentence));
    claims_ += found.checked;
    for (const std::string& broken : found.broken) complain("false {}", broken);
    for (const Field& field : step.fields) value(field);
    for (const Row* row : {&step.read, &step.row}) {
      for (const std::string& cell : *row) text("cell", cell);
    }
    for (const Mark& m : step.delta.set) mark(m);
    if (step.delta.set.size() > most_marks) complain("{} marks in one step", step.delta.set.size());
  }
  void value(const Field& field) {
    const double* x = std::get_if<double>(&field.value);
    if (x && !std::isfinite(*x)) complain("field {} is {}", field.name, *x);
  }
  void point(const std::string& id, dvec2 p) {
    // Not the other way round, for comparisons with NaN are false
    if (!(std::abs(p.x) <= farthest && std::abs(p.y) <= farthest))
      complain("mark {} at ({}, {})", id, p.x, p.y);
  }
  void mark(const Mark& mark) {
    const std::string& id = mark.id;
    if (const Dot* dot = std::get_if<Dot>(&mark.shape)) point(id, dot->at);
    if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) point(id, stroke->a), point(id, stroke->b);
    if (const Path* path = std::get_if<Path>(&mark.shape)) {
      for (const dvec2 p : path->points) point(id, p);
    }
    if (const Area* area = std::get_if<Area>(&mark.shape)) {
      for (const auto& ring : area->rings) {
        for (const dvec2 p : ring) point(id, p);
      }
    }
    if (const Text* written = std::get_if<Text>(&mark.shape)) point(id, written->at), text(id, written->text);
    if (const Label* label = std::get_if<Label>(&mark.shape)) point(id, label->at), text(id, label->text);
  }

  const bool says_infinity_;
  std::vector<std::string> wrong_;
  std::size_t claims_ = 0;
};

/// Runs a topic and judges what it tells; whether it told anything. drawn: figures, too.
bool judged(Judge& judge, const TopicEntry& topic, const std::vector<Argument>& given, const Wording& wording,
            bool drawn) {
  try {
    const Trace trace = topic.run(arguments_of(topic, given), {0, most_steps, wording});
    judge.trace(trace);
    if (drawn && judge.wrong().empty()) {
      Playhead playhead(trace);
      for (const StepNumber number : {trace.steps.back().number, middle_step(trace)})
        judge.sheet(lay_out(figure_of(trace, playhead, number), Look{}));
    }
    return true;
  } catch (const ArgumentError& error) {
    judge.text("refusal", error.what());
    if (without_notes(error.what()) != error.what())
      judge.complain("the notes of a figure in {}", error.what());
    if (std::ranges::find(given, error.parameter, &Argument::name) == given.end())
      judge.complain("--{}, which nobody gave, is blamed: {}", error.parameter, error.what());
  } catch (const std::exception& error) {
    judge.complain("no refusal by flag: {}", error.what());
  }
  return false;
}

class Strain : public testing::TestWithParam<const TopicEntry*> {
 protected:
  static void SetUpTestSuite() {
    std::signal(SIGALRM, give_up);
    if (test::sanitized) return;  // what a sanitizer reserves is far more
    const rlimit limit{most_bytes, most_bytes};
    setrlimit(RLIMIT_AS, &limit);
  }
  void TearDown() override { alarm(0); }
};

TEST_P(Strain, GivesNoWayToOddNumbers) {
  const TopicEntry& topic = *GetParam();
  const std::uint64_t start = test::seed();
  SCOPED_TRACE("GRADUS_SEED=" + std::to_string(start));
  RecordProperty("seed", std::to_string(start));
  std::uint64_t own = start;  // the topics' cases differ
  for (const char c : topic.name) own = 31 * own + static_cast<unsigned char>(c);
  test::OddArguments odd(own);
  const std::size_t cases =
      test::thinned(static_cast<std::size_t>(test::cases(test::whole_run() ? 1'000 : 300, 20'000)), 20);
  std::size_t told = 0, claims = 0, failures = 0;
  for (std::size_t i = 0; i < cases && failures < 10; ++i) {
    const std::vector<Argument> given = odd.of(topic);
    const std::string command = command_of(topic, given);
    std::snprintf(running, sizeof running, "%s", command.c_str());
    alarm(most_seconds);
    Judge judge(topic);
    told += judged(judge, topic, given, Wording(languages()[i % languages().size()]), i % 16 == 0);
    claims += judge.claims();
    if (judge.wrong().empty()) continue;
    ++failures;
    const std::size_t shown = std::min<std::size_t>(3, judge.wrong().size());
    ADD_FAILURE() << command << "\n  "
                  << fmt::format(
                         "{}", fmt::join(judge.wrong().begin(),
                                         judge.wrong().begin() + static_cast<std::ptrdiff_t>(shown), "\n  "));
  }
  std::printf("%zu of %zu runs told, %zu claims\n", told, cases, claims);
  // A topic that refuses everything would pass as well
  EXPECT_GE(told, cases / 10);
}

INSTANTIATE_TEST_SUITE_P(Topics, Strain, testing::ValuesIn(catalogue().begin(), catalogue().end()),
                         [](const auto& topic) { return topic.param->name; });

}  // namespace
}  // namespace gradus
