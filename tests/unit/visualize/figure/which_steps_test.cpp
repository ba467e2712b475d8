// Which steps are shown where nobody names them: over the built-in gallery, and on runs made by hand.

#include "figure/which_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "cli/figures/figure_file.hpp"
#include "cli/lecture/lecture.hpp"
#include "figure/figure.hpp"
#include "support/example_traces.hpp"
#include "support/sanitized.hpp"

namespace gradus {
namespace {

/// Whether something is decided between the input and the result.
bool decides_on_the_way(const Trace& trace) {
  return std::ranges::any_of(trace.steps, [&](const TraceStep& step) {
    return step.decision && step.number.step < trace.last && code_line(trace.listing, step.line);
  });
}

/// Whether the step is the one at which float or double decides otherwise, which is what is told there.
bool is_first_difference(const Trace& trace, StepNumber number) {
  return std::ranges::any_of(trace.result, [&](const Field& field) {
    return field.name.ends_with("_differs_at") && field.value == Value(text_of(number));
  });
}

std::vector<std::string> strong_lines(const Figure& figure) {
  std::vector<std::string> lines;
  for (const Figure::ListingLine& line : figure.listing) {
    if (line.emphasis == Emphasis::strong) lines.push_back(line.line.text);
  }
  return lines;
}

/// Recorded once for both walks.
const std::vector<Trace>& brief_traces() {
  static const std::vector<Trace> traces = test::telling_traces();
  return traces;
}

TEST(TellingStep, OfEveryFigureOfTheGalleryDecidesAndIsNotTheLast) {
  std::size_t figures = 0, next = 0;
  for (const cli::LectureFigure& figure : cli::read_lecture(cli::gallery_lecture()).figures) {
    if (figure.spec.chooses_steps() || (test::sanitized && next++ % 3 != 0)) continue;
    Takes takes(*figure.spec.topic, figure.spec.arguments, figure.spec.wording);
    const Trace& trace = takes.opening();
    const StepNumber shown = cli::shown_step(figure.spec, takes);
    SCOPED_TRACE(figure.name + ", step " + text_of(shown));
    ++figures;
    EXPECT_EQ(shown, trace.telling);
    const TraceStep& step = trace.steps[index_of(trace, shown)];
    // A last step that decides something is no "Done"
    if (!is_first_difference(trace, shown) && !step.decision)
      EXPECT_LT(shown.step, trace.last) << step.sentence;
    EXPECT_TRUE(step.decision.has_value() || !decides_on_the_way(trace)) << step.sentence;
    EXPECT_EQ(strong_lines(takes.figure(shown)).size(), 1u) << step.sentence;
  }
  EXPECT_GT(figures, test::thinned(60, 3));
}

TEST(StrongLine, IsNeverABraceOrACommentAlone) {
  if (test::sanitized) return;
  for (const Trace& trace : brief_traces()) {
    Playhead playhead(trace);
    const std::size_t stride = std::max<std::size_t>(1, trace.steps.size() / 20);
    for (std::size_t i = 0; i < trace.steps.size(); i += stride) {
      for (const std::string& line : strong_lines(figure_of(trace, playhead, trace.steps[i].number))) {
        const std::size_t first = line.find_first_not_of(" {}();,");
        ASSERT_NE(first, std::string::npos) << trace.topic << ": " << line;
        ASSERT_NE(line.substr(first, 2), "//") << trace.topic << ": " << line;
      }
    }
  }
}

const std::vector<SourceLine> listing{{10, "// Corner by corner"},
                                      {11, "for (Vertex now : polygon) {"},
                                      {12, "  // Inside"},
                                      {13, "  if (inside(now)) {"},
                                      {15, "    kept.add(now);"},
                                      {17, "  }"},
                                      {18, "}"}};

TEST(CodeLine, IsTheNearestAtOrAboveThatIsMoreThanBracesOrAComment) {
  EXPECT_EQ(code_line(listing, 15), 4u);
  EXPECT_EQ(code_line(listing, 16), 4u) << "a line that is not shown";
  EXPECT_EQ(code_line(listing, 18), 4u) << "braces";
  EXPECT_EQ(code_line(listing, 12), 1u) << "a comment";
  EXPECT_EQ(code_line(listing, 10), std::nullopt) << "nothing but a comment";
  EXPECT_EQ(code_line(listing, 9), std::nullopt);
  EXPECT_EQ(code_line(listing, 0), std::nullopt) << "no line reported it";
}

/// A run of these steps: phase, branch (empty: nothing is decided), line.
struct Told {
  std::string phase, branch;
  int line = 13;
  int fine = 0;
  Level level = Level::step;
};
Trace run_of(const std::vector<Told>& told) {
  Trace trace;
  trace.listing = listing;
  std::int64_t number = -1;
  for (const Told& t : told) {
    TraceStep step;
    if (t.fine == 0) ++number;
    step.number = {number, t.fine};
    step.phase = t.phase;
    step.line = t.line;
    step.level = t.level;
    if (!t.branch.empty()) step.decision = Decision{"?", {"yes"}, 0, t.branch};
    trace.steps.push_back(step);
  }
  trace.last = number;
  return trace;
}

TEST(TellingStep, IsOfTheRarestKindInThePhaseWithMostDecisions) {
  EXPECT_EQ(telling_step(run_of({{"", ""}, {"a", "in"}, {"a", "in"}, {"a", "in"}, {"a", "out"}, {"", ""}})),
            (StepNumber{4, 0}));
  EXPECT_EQ(telling_step(run_of({{"", ""}, {"a", "in"}, {"a", "in"}, {"a", "in"}, {"", ""}})),
            (StepNumber{2, 0}))
      << "in the middle";
  EXPECT_EQ(telling_step(run_of({{"set up", ""},
                                 {"left", "in"},
                                 {"right", "in"},
                                 {"right", "out"},
                                 {"right", "in"},
                                 {"result", ""}})),
            (StepNumber{3, 0}));
}

TEST(TellingStep, IsNeitherTheLastNorASummaryNorAFinerEventWhereOthersDecide) {
  EXPECT_EQ(telling_step(run_of({{"set up", ""}, {"a", "in"}, {"b", "in"}, {"b", "out"}})),
            (StepNumber{1, 0}))
      << "the last decides, too";
  EXPECT_EQ(telling_step(run_of({{"set up", ""},
                                 {"a", "in"},
                                 {"b", "in", 13, 0, Level::idea},
                                 {"b", "in", 13, 0, Level::idea},
                                 {"", ""}})),
            (StepNumber{1, 0}));
  EXPECT_EQ(telling_step(run_of({{"set up", ""}, {"a", "in", 13, 1}, {"a", "in"}, {"", ""}})),
            (StepNumber{1, 0}));
  EXPECT_EQ(telling_step(run_of({{"set up", ""}, {"a", "in", 13, 1}, {"", ""}, {"", ""}})),
            (StepNumber{0, 1}))
      << "nothing else decides";
}

TEST(TellingStep, HasALineOfCode) {
  EXPECT_EQ(telling_step(run_of({{"set up", ""}, {"a", "in", 0}, {"a", "in"}, {"a", "in", 0}, {"", ""}})),
            (StepNumber{2, 0}));
  EXPECT_EQ(telling_step(run_of({{"set up", "", 0}, {"a", "", 0}, {"a", "", 13}, {"", "", 0}})),
            (StepNumber{2, 0}))
      << "where nothing is decided";
  EXPECT_EQ(telling_step(run_of({{"", "", 0}})), (StepNumber{0, 0}));
}

/// Nothing is said twice in a phase, but at the ends.
void expect_no_sentence_twice(const Trace& trace, const std::vector<StepNumber>& chosen) {
  std::set<std::string> sentences;
  for (const StepNumber number : chosen) {
    const TraceStep& step = trace.steps[index_of(trace, number)];
    const bool is_new = sentences.insert(step.phase + ": " + step.sentence).second;
    EXPECT_TRUE(is_new || number == chosen.back()) << step.sentence;
  }
}

/// The kinds of branch, or the phases, of the run's whole steps.
template <class Of>
std::set<std::string> seen(const Trace& trace, const std::vector<StepNumber>& numbers, Of of) {
  std::set<std::string> all;
  for (const StepNumber number : numbers) all.insert(of(trace.steps[index_of(trace, number)]));
  return all;
}

TEST(Milestones, HaveEveryPhaseAndEveryKindOfBranch) {
  const auto phase = [](const TraceStep& step) { return step.phase; };
  const auto branch = [](const TraceStep& step) { return step.decision ? step.decision->branch : ""; };
  const auto deciding_phase = [](const TraceStep& step) { return step.decision ? step.phase : ""; };
  for (const Trace& trace : brief_traces()) {
    SCOPED_TRACE(trace.topic + ", " + trace.method);
    std::vector<StepNumber> whole;
    for (const TraceStep& step : trace.steps) {
      if (step.number.fine == 0) whole.push_back(step.number);
    }
    const std::vector<StepNumber> chosen = milestones_of(trace);
    EXPECT_TRUE(std::ranges::is_sorted(chosen));
    ASSERT_FALSE(chosen.empty());
    EXPECT_EQ(chosen.front(), whole.front());
    EXPECT_EQ(chosen.back(), whole.back());
    const auto all_phases = seen(trace, chosen, phase);
    EXPECT_TRUE(std::ranges::includes(all_phases, seen(trace, whole, phase)));
    const auto chosen_branches = seen(trace, chosen, branch);
    EXPECT_TRUE(std::ranges::includes(chosen_branches, seen(trace, whole, branch)));
    const auto chosen_phases = seen(trace, chosen, deciding_phase);
    EXPECT_TRUE(std::ranges::includes(chosen_phases, seen(trace, whole, deciding_phase)));
    EXPECT_TRUE(std::ranges::count(chosen, trace.telling) == 1 || !has_step(trace, trace.telling));
    expect_no_sentence_twice(trace, chosen);
  }
}

TEST(Milestones, AreTheMostTellingOfTheirKind) {
  Trace trace =
      run_of({{"set up", ""}, {"a", "in"}, {"a", "in"}, {"a", "out"}, {"a", "in"}, {"a", ""}, {"", ""}});
  for (TraceStep& step : trace.steps) step.sentence = text_of(step.number);
  trace.telling = {3, 0};
  EXPECT_EQ(milestones_of(trace), (std::vector<StepNumber>{{0, 0}, {2, 0}, {3, 0}, {5, 0}, {6, 0}}));
  trace.steps[4].tells = 2;
  EXPECT_EQ(milestones_of(trace), (std::vector<StepNumber>{{0, 0}, {3, 0}, {4, 0}, {5, 0}, {6, 0}}))
      << "by the story's own word";
  trace.steps[4].sentence = trace.steps[3].sentence;
  EXPECT_EQ(milestones_of(trace), (std::vector<StepNumber>{{0, 0}, {2, 0}, {3, 0}, {5, 0}, {6, 0}}))
      << "nothing is said twice";
}

TEST(Milestones, AreFinerEventsWhereNoWholeStepDecides) {
  Trace trace = run_of({{"set up", ""}, {"a", "", 13}, {"a", "near", 13, 1}, {"a", "far", 13, 2}, {"", ""}});
  for (TraceStep& step : trace.steps) step.sentence = text_of(step.number);
  trace.telling = {1, 1};
  EXPECT_EQ(milestones_of(trace), (std::vector<StepNumber>{{0, 0}, {1, 0}, {1, 1}, {1, 2}, {2, 0}}));
}

TEST(Milestones, OfSutherlandAndHodgmanShowAllFourBorders) {
  const Trace trace = test::trace_of("sutherland_hodgman");
  const std::vector<StepNumber> chosen = milestones_of(trace);
  const auto phases = seen(trace, chosen, [](const TraceStep& step) { return step.phase; });
  for (const char* border : {"left border", "right border", "bottom border", "top border"})
    EXPECT_TRUE(phases.contains(border)) << border;
  EXPECT_LT(chosen.size(), 20u) << "a choice, not the run";
}

}  // namespace
}  // namespace gradus
