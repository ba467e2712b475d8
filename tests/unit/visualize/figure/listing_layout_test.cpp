// The listing on a slide: long lines broken at syntax, the loop that decides always in view, lines counted
// from one.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "cli/lecture/lecture.hpp"
#include "figure/layout/layout.hpp"
#include "support/sanitized.hpp"
#include "support/share.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

using layout::source_rows;
using Rows = std::vector<std::string>;

TEST(SourceRows, BreakAtSyntax) {
  EXPECT_EQ(source_rows("p += 2 * dy;", 36), (Rows{"p += 2 * dy;"}));
  EXPECT_EQ(source_rows("  const auto at = meet(first, second, border, window);", 36),
            (Rows{"  const auto at = meet(first,", "      second, border, window);"}));
  EXPECT_EQ(source_rows("if (p < 0 || (p == 0 && tie_straight)) {", 30),
            (Rows{"if (p < 0 || (p == 0", "    && tie_straight)) {"}));
}

TEST(SourceRows, LoseTheTrailingCommentFirst) {
  EXPECT_EQ(source_rows("    pixel += go.diagonal;  // north-east", 30), (Rows{"    pixel += go.diagonal;"}));
  EXPECT_EQ(source_rows("// Does the line pass above the middle", 24),
            (Rows{"// Does the line pass", "// above the middle"}));
}

std::string without_spaces(std::string text) {
  std::erase(text, ' ');
  return text;
}

TEST(SourceRows, HoldTheWholeLineInTheWidth) {
  std::size_t broken = 0;
  for (const Trace& trace : test::shared_traces()) {
    for (const SourceLine& line : trace.listing) {
      if (line.text.find("//") != std::string::npos) continue;
      for (const std::size_t columns : {33u, 36u}) {
        const Rows rows = source_rows(line.text, columns);
        std::string all;
        for (const std::string& row : rows) {
          EXPECT_LE(code_points(row).size(), columns) << row;
          all += row;
        }
        broken += rows.size() > 1;
        EXPECT_EQ(without_spaces(all), without_spaces(line.text)) << trace.topic << " at " << columns;
      }
    }
  }
  EXPECT_GT(broken, 10u);
}

/// The head of the innermost loop round a line, by counting braces; nothing outside all.
std::optional<int> loop_round(const std::vector<SourceLine>& lines, int number) {
  std::vector<std::pair<bool, int>> open;  // whether a loop, its line
  for (const SourceLine& line : lines) {
    const std::string code = line.text.substr(0, line.text.find("//"));
    const std::size_t first = std::min(code.find_first_not_of(' '), code.size());
    const bool loop = code.compare(first, 4, "for ") == 0 || code.compare(first, 6, "while ") == 0 ||
                      code.compare(first, 3, "do ") == 0;
    if (line.number == number && loop) return number;
    if (line.number == number && !code.empty() && code[first] != '}') break;
    for (const char c : code) {
      if (c == '{') open.emplace_back(loop, line.number);
      if (c == '}' && !open.empty() && line.number != number) open.pop_back();
    }
    if (line.number == number) break;
  }
  for (std::size_t i = open.size(); i-- > 0;) {
    if (open[i].first) return open[i].second;
  }
  return std::nullopt;
}

TEST(Listing, ShowsTheHeadOfTheLoopThatDecides) {
  std::size_t looked = 0;
  for (const Trace& trace : test::shared_traces()) {
    SCOPED_TRACE(trace.topic + " " + trace.method);
    Playhead playhead(trace);
    for (const auto& [width, height] : {std::pair{1280.0, 720.0}, {960.0, 720.0}}) {
      Look look;
      look.width = width;
      look.height = height;
      const std::size_t stride = std::max<std::size_t>(1, trace.steps.size() / test::thinned(20, 10));
      for (std::size_t i = 0; i < trace.steps.size(); i += stride) {
        const Figure figure = figure_of(trace, playhead, trace.steps[i].number);
        const auto current =
            std::ranges::find(figure.listing, Emphasis::strong, &Figure::ListingLine::emphasis);
        if (current == figure.listing.end()) continue;
        const auto head = loop_round(trace.listing, current->line.number);
        if (!head) continue;
        ++looked;
        EXPECT_NE(test::find_text(lay_out(figure, look), fmt::format("line {}", *head)), nullptr)
            << "step " << text_of(figure.number) << ": " << current->line.text;
      }
    }
  }
  EXPECT_GT(looked, test::thinned(500, 10));
}

/// One step of each line that a step marks.
std::vector<StepNumber> step_of_each_line(const Trace& trace) {
  std::set<int> lines;
  std::vector<StepNumber> steps;
  for (const TraceStep& step : trace.steps)
    if (lines.insert(step.line).second) steps.push_back(step.number);
  return steps;
}

std::size_t lines_seen = 0;

void no_line_is_broken(const Trace& trace, const Look& look) {
  Playhead playhead(trace);
  for (const StepNumber step : step_of_each_line(trace)) {
    for (const Shape& shape : lay_out(figure_of(trace, playhead, step), look).shapes) {
      if (shape.slot != Slot::listing || !shape.id.starts_with("line ")) continue;
      ++lines_seen;
      EXPECT_EQ(shape.id.find(" row "), std::string::npos)
          << "step " << text_of(step) << ": " << std::get<TextShape>(shape.what).text;
    }
  }
}

/// What the slides of a lecture are like.
std::vector<Look> slides_of(const Trace& trace, const Look& like) {
  std::vector<Look> looks;
  for (const auto& [width, height] : {std::pair{1280.0, 720.0}, {960.0, 720.0}, {720.0, 720.0}}) {
    // The chain's table and drawings leave a listing too little of a square
    if (width == height && trace.topic == "pipeline") continue;
    looks.push_back(like);
    looks.back().width = width;
    looks.back().height = height;
  }
  return looks;
}

TEST(Listing, BreaksNoLineOnASlide) {
  std::size_t next = 0;
  for (const test::TellingRun& run : test::telling_runs()) {
    // A method's own run and inputs that strain the drawing: on a square slide these may ask for too much
    const bool own = run.run.given.size() == 1 && run.run.given.contains("method");
    const std::size_t i = next++;
    if (test::sanitized ? i % 23 != 0 : !own && !test::in_share(i, 5)) continue;
    const Trace trace = run.trace();
    SCOPED_TRACE(fmt::format("{} {} {}", trace.topic, trace.method, trace.subtitle));
    for (Look look : slides_of(trace, {})) {
      if (!own && look.width == look.height) continue;
      SCOPED_TRACE(fmt::format("{} x {}", look.width, look.height));
      no_line_is_broken(trace, look);
      look.slots = {Slot::title, Slot::listing, Slot::table};
      no_line_is_broken(trace, look);
    }
  }
  EXPECT_GT(lines_seen, test::thinned(10000, 23));
}

TEST(Listing, BreaksNoLineInTheGallery) {
  std::size_t next = 0;
  for (const cli::LectureFigure& figure : cli::read_lecture(cli::gallery_lecture()).figures) {
    if (test::sanitized ? next++ % 6 != 0 : !test::in_share(next++, 2)) continue;
    SCOPED_TRACE(figure.name);
    const Trace trace = figure.spec.topic->run(figure.spec.arguments, {});
    no_line_is_broken(trace, figure.spec.look);
    for (const Look& look : slides_of(trace, figure.spec.look)) {
      SCOPED_TRACE(fmt::format("{} x {}", look.width, look.height));
      no_line_is_broken(trace, look);
    }
  }
}

TEST(Listing, CountsItsLines) {
  const Trace trace = test::trace_of("bresenham_line");
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4, 0});
  Look look;
  Sheet sheet;
  const auto shown = [&](std::size_t line) {
    sheet = lay_out(figure, look);
    return test::find_text(sheet, fmt::format("number {}", trace.listing[line].number));
  };
  std::size_t seen = 0;
  for (std::size_t i = 0; i < trace.listing.size(); ++i) {
    look.line_numbers = LineNumbers::listing;
    const auto texts = [&](LineNumbers numbers) {
      look.line_numbers = numbers;
      const TextShape* text = shown(i);
      return text ? text->text : std::string();
    };
    if (texts(LineNumbers::listing).empty()) continue;
    ++seen;
    EXPECT_EQ(texts(LineNumbers::listing), fmt::format("{}", i + 1));
    EXPECT_EQ(texts(LineNumbers::source), fmt::format("{}", trace.listing[i].number));
    EXPECT_EQ(texts(LineNumbers::none), "");
  }
  EXPECT_GE(seen, 6u);
}

}  // namespace
}  // namespace gradus
