// Which line of its listing a step marks: one of the function that told it, and none of a branch that may not
// have been taken.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "figure/which_steps.hpp"
#include "stories/listing.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

const std::vector<SourceLine> loop{{10, "for (Vertex now : polygon) {"},
                                   {11, "  if (crosses(now)) {"},
                                   {12, "    kept.add(cut);"},
                                   {14, "  } else {"},
                                   {15, "    last = now;"},
                                   {17, "  }"},
                                   {19, "  if (inside(now))"},
                                   {20, "    draw(now);"},
                                   {22, "  if (outside(now)) skip(now);"},
                                   {24, "}"},
                                   {26, "return kept;"}};

TEST(LineThatRan, IsNoBranchThatMayNotHaveBeenTaken) {
  EXPECT_EQ(line_that_ran(loop, 13), 12) << "told within the branch";
  EXPECT_EQ(line_that_ran(loop, 16), 15) << "within the other one";
  EXPECT_EQ(line_that_ran(loop, 18), 11) << "behind both: the question alone was asked for certain";
  EXPECT_EQ(line_that_ran(loop, 21), 19) << "a branch without braces";
  EXPECT_EQ(line_that_ran(loop, 25), 10) << "behind a loop that ends with a branch";
  EXPECT_EQ(line_that_ran(loop, 27), 26);
  EXPECT_EQ(line_that_ran(loop, 9), 0);
  const std::vector<SourceLine> plain{{1, "while (p) {"}, {2, "  step(p);"}, {4, "}"}};
  EXPECT_EQ(line_that_ran(plain, 5), 2) << "the last line of a loop's body";
}

/// Its text, as the file has it, without spaces at its start.
std::string source_line(const Trace& trace, int number) {
  std::string_view rest = source_text(trace.source_file);
  for (int line = 1; line < number; ++line) rest.remove_prefix(rest.find('\n') + 1);
  std::string_view line = rest.substr(0, rest.find('\n'));
  if (line.ends_with("  //+")) line.remove_suffix(5);  // put in by a fault
  return std::string(line.substr(std::min(line.size(), line.find_first_not_of(' '))));
}

// Every method, every example: what is marked stands in the listing, and in the file at that very place. The
// file is read anew here; a line number of another file or function points at some other text.
TEST(LineWith, IsTheFirstThatHasTheText) {
  EXPECT_EQ(line_with(loop, "(now)"), 11);
  EXPECT_EQ(line_with(loop, "draw("), 20);
  EXPECT_EQ(line_with(loop, "erase("), 0);
}

TEST(Listing, LeavesOutWhatCountsForReports) {
  constexpr std::string_view source = R"(template <class O>
void walk(const Faces& faces, O&& observer = {}) {
  Tally<O, Work> tally(observer);
  for (const Face& face : faces) {
    keep(face.depth, face.id, tally);
    if constexpr (observed<O>) observer(tally.count(FaceDone{face.id, 0}));
  }
}
)";
  std::vector<std::string> lines;
  for (const SourceLine& line : listing_of(source, "walk")) lines.push_back(line.text);
  EXPECT_EQ(lines, (std::vector<std::string>{"for (const Face& face : faces) {",
                                             "  keep(face.depth, face.id);", "}"}));
}

TEST(Listing, CutsAHeadingThatHasMoreParametersThanFit) {
  constexpr std::string_view source = R"(void cover(int triangle, int window) {
  done();
}
void scanline(int faces, int window, int line, int store, int paint) {
  done();
}
)";
  EXPECT_EQ(heading_of(source, "cover")->text, "cover(triangle, window):");
  EXPECT_EQ(heading_of(source, "scanline")->text, "scanline(faces, window, line, …):");
  EXPECT_TRUE(is_heading(heading_of(source, "scanline")->text));
}

TEST(MarkedLine, StandsInTheFileThatToldTheStep) {
  int marked = 0;
  for (const Trace& trace : test::telling_traces()) {
    for (const TraceStep& step : trace.steps) {
      if (step.line == 0) continue;
      const auto at = code_line(trace.listing, step.line);
      ASSERT_TRUE(at) << trace.topic << " " << trace.method << " " << step.type;
      ASSERT_EQ(trace.listing[*at].number, step.line) << trace.topic << " " << trace.method;
      const std::string listed = trace.listing[*at].text,
                        shown = listed.substr(listed.find_first_not_of(' '));
      const std::string written = source_line(trace, step.line);
      ASSERT_EQ(shown.substr(0, shown.find('(')), written.substr(0, written.find('('))) << trace.topic;
      // A question and its answer on one line: whether the answer was carried out is not said
      const bool answered = shown.starts_with("if (") && shown.ends_with(";");
      ASSERT_FALSE(answered) << trace.topic << " " << trace.method << " " << step.type << ": " << shown;
      ++marked;
    }
  }
  EXPECT_GT(marked, test::sanitized ? 5000 / 3 : 5000);  // there a third of the topics is looked at
}

// A picture by a method is told with that method's own line, or with none.
TEST(MarkedLine, AMethodsPictureMarksItsOwnFunction) {
  const Trace trace = test::trace_of("antialiased_line", {{"method", "side_by_side"}});
  const std::string_view source = source_text(trace.source_file);
  const auto lies_in = [&](const TraceStep& step, std::string_view function) {
    const auto [first, last] = body_of(source, function);
    return first > 0 && first <= step.line && step.line <= last;
  };
  ASSERT_GE(trace.steps.size(), 5u);
  EXPECT_EQ(trace.steps[1].line, 0) << "Bresenham's line is written elsewhere";
  EXPECT_TRUE(lies_in(trace.steps[2], "wu"));
  EXPECT_TRUE(lies_in(trace.steps[3], "gupta_sproull"));
  EXPECT_TRUE(lies_in(trace.steps[4], "exact_area"));
}

TEST(MarkedLine, AnAliasIsFoundWithoutABranch) {
  const Trace trace = test::trace_of("sampling_theorem", {{"frequency", "9"}, {"rate", "10"}});
  const auto folded = std::ranges::find(trace.steps, "Folded", &TraceStep::type);
  ASSERT_NE(folded, trace.steps.end());
  EXPECT_EQ(source_line(trace, folded->line), "const T alias = tie ? size(r) : r;");
}

// --- Sutherland and Hodgman: test, then cut, then keep

/// What is drawn of the corners that are kept so far.
std::vector<dvec2> kept_in(const Canvas& canvas) {
  const auto mark = canvas.marks().find("d kept");
  return mark == canvas.marks().end() ? std::vector<dvec2>{} : std::get<Path>(mark->second.shape).points;
}

// The drawn chain only grows at its end: nothing is put between two corners that were joined already. And the
// marked line is the one that tests, cuts or keeps.
TEST(CutsBeforeKeeping, TheChainGrowsAtItsEndAndTheListingSaysWhy) {
  for (const char* method : {"border_by_border", "homogeneous", "cut_of_a_cut", "entering_not_cut",
                             "previous_left_behind", "marked_by_window"}) {
    const Trace trace = test::trace_of("sutherland_hodgman", {{"method", method}});
    Playhead playhead(trace);
    std::vector<dvec2> before;
    std::string phase;
    int cuts = 0, keeps = 0;
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      const TraceStep& step = trace.steps[i];
      SCOPED_TRACE(fmt::format("{} step {}: {}", method, text_of(step.number), step.sentence));
      const std::vector<dvec2> now = kept_in(playhead.at(i));
      if (step.phase == phase && now.size() >= before.size())
        EXPECT_TRUE(std::equal(before.begin(), before.end(), now.begin()));
      const std::string line = source_line(trace, step.line);
      if (step.type == "VertexTested" || step.type == "Tested") {
        EXPECT_EQ(line.find("kept"), std::string::npos) << line;
        if (step.phase == phase) EXPECT_EQ(now, before) << "a test keeps nothing";
      }
      if (step.type == "VertexKept" || step.type == "CornerKept") {
        EXPECT_NE(line.find("kept."), std::string::npos) << line;
        EXPECT_EQ(line.find("cut"), std::string::npos) << line;
        ++keeps;
      }
      cuts += step.type == "EdgeCut" || step.type == "Cut";
      before = now;
      phase = step.phase;
    }
    EXPECT_GT(cuts, 0) << method;
    EXPECT_GT(keeps, 0) << method;
  }
}

// Of the default polygon corner 2 enters through the left border: it is tested, B is cut, and then 2 is kept.
TEST(CutsBeforeKeeping, AnEnteringEdgeIsToldInTheOrderOfTheCode) {
  const Trace trace = test::trace_of("sutherland_hodgman");
  const auto types = [&](std::size_t first) {
    return std::vector<std::string>{trace.steps[first].type, trace.steps[first + 1].type,
                                    trace.steps[first + 2].type};
  };
  const auto tested = std::ranges::find_if(trace.steps, [](const TraceStep& s) {
    return s.type == "VertexTested" && s.sentence.starts_with("Corner 2 ");
  });
  ASSERT_NE(tested, trace.steps.end());
  const auto at = static_cast<std::size_t>(tested - trace.steps.begin());
  EXPECT_EQ(types(at), (std::vector<std::string>{"VertexTested", "EdgeCut", "VertexKept"}));
  EXPECT_EQ(tested->row.back(), "") << "nothing is kept yet";
  EXPECT_EQ(trace.steps[at + 1].read.back(), "B");
  EXPECT_EQ(trace.steps[at + 2].read.back(), "B, 2");
}

}  // namespace
}  // namespace gradus
