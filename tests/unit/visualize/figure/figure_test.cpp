// What a figure says, in which colours, from which recording. Where things stand: layout_test.cpp.

#include "figure/figure.hpp"
#include "figure/text/metrics.hpp"

#include <gtest/gtest.h>

#include "support/example_traces.hpp"
#include "support/sheets.hpp"
#include "theme/theme.hpp"

namespace gradus {
namespace {

using test::for_each_sheet;
using test::texts_of;

// --- Contrast ---------------------------------------------------------------------------------------------

TEST(Theme, EveryTextHasContrastOnItsGround) {
  std::size_t texts = 0;
  for_each_sheet(
      [&](const Trace&, const Sheet& sheet, std::size_t) {
        for (const TextShape* text : texts_of(sheet)) {
          ++texts;
          for (const Theme& theme : themes()) {
            for (const TextPiece& piece : pieces_of(*text)) {
              EXPECT_GE(contrast(color_of(piece.paint, theme), color_of(text->ground, theme)), 4.5)
                  << theme.name << ": " << text->text;
            }
          }
        }
      },
      {}, 6);
  EXPECT_GT(texts, 1000u);
}

TEST(Theme, EveryMarkHasContrastOnThePaper) {
  ASSERT_EQ(themes().size(), 5u);
  for (const Theme& theme : themes()) {
    for (const Role role : all_roles) {
      EXPECT_GE(contrast(theme[role].mark, theme[Tone::paper]), 3) << theme.name << " " << name_of(role);
      EXPECT_GE(contrast(theme[role].text, theme[Tone::paper]), 4.5) << theme.name << " " << name_of(role);
      EXPECT_GE(contrast(theme[text_on(theme[role].fill, theme)], theme[role].fill), 4.5) << theme.name;
    }
    for (const Tone ground : {Tone::paper, Tone::panel, Tone::header, Tone::weak, Tone::strong}) {
      EXPECT_GE(contrast(theme[Tone::ink], theme[ground]), 4.5) << theme.name;
    }
    EXPECT_GE(contrast(theme[Tone::accent], theme[Tone::strong]), 3) << theme.name;
  }
}

/// A projector in a bright room halves the contrast: what is left is 3:1 for texts, as large ones need, and
/// 2:1 for marks.
TEST(Theme, ReadsAtHalfTheContrast) {
  const auto halved = [](Rgb a, Rgb b) { return contrast(a, b) / 2; };
  for (const Theme& theme : themes()) {
    SCOPED_TRACE(theme.name);
    const Rgb paper = theme[Tone::paper];
    for (const Tone ground : {Tone::paper, Tone::panel, Tone::header, Tone::weak, Tone::strong}) {
      EXPECT_GE(halved(theme[Tone::ink], theme[ground]), 3);
      for (const Rgb quantity : theme.quantity) EXPECT_GE(halved(quantity, theme[ground]), 3) << quantity.hex;
    }
    for (const Tone ground : {Tone::paper, Tone::panel})
      EXPECT_GE(halved(theme[Tone::muted], theme[ground]), 3);
    EXPECT_GE(halved(theme[Tone::accent], paper), 2);
    for (const Role role : all_roles) {
      EXPECT_GE(halved(theme[role].text, paper), 3) << name_of(role);
      EXPECT_GE(halved(theme[role].mark, paper), 2) << name_of(role);
    }
  }
}

/// How a projector without colour shows it.
double grey(Rgb c) { return 0.2126 * c.red() + 0.7152 * c.green() + 0.0722 * c.blue(); }

TEST(Theme, CellRolesStayApartWithoutColour) {
  // Another hatch, outline, dash or cross; or clearly another grey
  for (const Theme& theme : themes()) {
    for (const Role a : all_roles) {
      for (const Role b : all_roles) {
        // These two are never cells
        const auto is_line = [](Role role) { return role == Role::measure || role == Role::guide; };
        if (a >= b || is_line(a) || is_line(b)) continue;
        const Channel ca = channel_of(a), cb = channel_of(b);
        const bool other_channel = ca.hatch != cb.hatch || ca.outline != cb.outline ||
                                   ca.dashed != cb.dashed || ca.cross != cb.cross;
        EXPECT_TRUE(other_channel || std::abs(grey(theme[a].fill) - grey(theme[b].fill)) > 0.2)
            << theme.name << ": " << name_of(a) << " and " << name_of(b);
      }
    }
  }
}

TEST(Theme, ContrastIsWcags) {
  EXPECT_NEAR(contrast({0x000000}, {0xffffff}), 21, 1e-12);
  EXPECT_NEAR(contrast({0x777777}, {0xffffff}), 4.478, 1e-3);
}

// --- Figures ---------------------------------------------------------------------------------------------

TEST(Figure, MarksTheLineAndTheRowOfAStep) {
  const Trace trace = test::trace_of("bresenham_line", {{"from", "0,0"}, {"to", "7,3"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4, 0});
  std::string strong, weak;
  for (const auto& line : figure.listing) {
    if (line.emphasis == Emphasis::strong) strong = line.line.text;
    if (line.emphasis == Emphasis::weak) weak = line.line.text;
  }
  EXPECT_EQ(strong, "    p += 2 * (dy - dx);");
  EXPECT_EQ(weak, "    p += 2 * dy;");
  ASSERT_EQ(figure.rows.size(), 5u);
  EXPECT_EQ(figure.rows[3].emphasis, Emphasis::weak);
  EXPECT_EQ(figure.rows[3].cells, (Row{"3", "3", "1", "3", "p > 0", "NE"}));
  EXPECT_EQ(figure.rows[4].emphasis, Emphasis::strong);
  EXPECT_EQ(figure.rows[4].cells, (Row{"4", "4", "2", "−5", "", ""}));
  EXPECT_EQ(figure.rows[4].changed, (std::vector<bool>{false, true, true, true, false, false}));
  EXPECT_EQ(figure.rows[2].emphasis, Emphasis::none);
}

TEST(Figure, ARowHasACellForEveryColumn) {
  std::size_t rows = 0;
  for (const Trace& trace : test::shared_traces()) {
    SCOPED_TRACE(trace.topic + " " + trace.method);
    for (const TraceStep& step : trace.steps) {
      for (const Row& row : {step.read, step.row}) {
        if (row.empty()) continue;
        ++rows;
        EXPECT_EQ(row.size(), trace.columns.size()) << "step " << text_of(step.number);
      }
    }
  }
  EXPECT_GT(rows, 500u);
}

TEST(Figure, AFinerStepMarksTheTestThatWasRead) {
  const Trace trace = test::trace_of("bresenham_line");
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {3, 1});
  EXPECT_EQ(figure.rows.back().emphasis, Emphasis::weak);
  EXPECT_EQ(figure.rows.back().cells.back(), "NE");
  EXPECT_TRUE(figure.canvas->marks().contains("midpoint"));
}

TEST(Figure, TheMidpointOfTheSentenceIsDrawn) {
  const Trace trace = test::trace_of("bresenham_line");
  Playhead playhead(trace);
  for (const TraceStep& step : trace.steps) {
    SCOPED_TRACE(text_of(step.number));
    const Figure figure = figure_of(trace, playhead, step.number);
    EXPECT_EQ(step.sentence.find("midpoint M") != std::string::npos,
              figure.canvas->marks().contains("midpoint"));
  }
  const Mark& midpoint = figure_of(trace, playhead, {4, 0}).canvas->marks().at("midpoint");
  EXPECT_EQ(std::get<Dot>(midpoint.shape).at, dvec2(4, 1.5));
}

TEST(Figure, ALineSaysTrulyWhereItPasses) {
  // Below a line that falls lies the pixel aside; a wrapped p or a misprint is told as what it would mean
  const auto sentence = [](const std::map<std::string, std::string>& given, StepNumber number) {
    const Trace trace = test::trace_of("bresenham_line", given);
    return trace.steps[index_of(trace, number)].sentence;
  };
  EXPECT_NE(sentence({{"from", "0,0"}, {"to", "7,-3"}}, {2, 0}).find("passes below the midpoint M"),
            std::string::npos);
  EXPECT_NE(sentence({{"from", "2,5"}, {"to", "-3,-4"}}, {1, 0}).find("to the left of the midpoint M"),
            std::string::npos);
  EXPECT_NE(
      sentence({{"to", "5,3"}, {"method", "misprinted_derivation"}}, {3, 0}).find("if this p were right"),
      std::string::npos);
  EXPECT_NE(sentence({{"to", "2,1"}, {"method", "first_octant"}}, {1, 0}).find("this method then goes aside"),
            std::string::npos);
}

TEST(Figure, TheErrorShownIsTheExactDistance) {
  const Trace trace = test::trace_of("bresenham_line");
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4, 0});
  const Mark& error = figure.canvas->marks().at("error name");
  EXPECT_EQ(std::get<Text>(error.shape).text, "2/7");
}

TEST(Figure, ADriftingSumIsCorrectedTruthfully) {
  // (0,0)-(12,10) passes midway at 9; (0,0)-(359,349) does not at 341
  const Trace tie = test::trace_of("bresenham_line", {{"to", "12,10"}, {"method", "dda"}});
  const Trace off = test::trace_of("bresenham_line", {{"to", "359,349"}, {"method", "dda"}});
  EXPECT_NE(tie.steps[index_of(tie, {9, 0})].sentence.find("passes midway, and the tie goes to (9,"),
            std::string::npos);
  EXPECT_NE(off.steps[index_of(off, {341, 0})].sentence.find("is nearer to (341,"), std::string::npos);
  EXPECT_EQ(tie.telling, (StepNumber{9, 0}));
  EXPECT_NE(tie.faulty.find("pixel 9 is the first wrong one"), std::string::npos);
}

TEST(Figure, CaptionNamesFaultStepAndInput) {
  const Trace trace = test::trace_of("bresenham_line", {{"method", "first_octant"}, {"to", "4,-2"}});
  Playhead playhead(trace);
  const std::string caption = caption_of(figure_of(trace, playhead, {1, 0}));
  EXPECT_NE(caption.find("faulty"), std::string::npos);
  EXPECT_NE(caption.find("step 1 of 4"), std::string::npos);
  EXPECT_NE(caption.find(trace.subtitle), std::string::npos);
}

TEST(Figure, ManyStepsShowTheLastRowsOnly) {
  const Trace trace = test::trace_of("bresenham_line", {{"to", "9000,124"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4000, 0});
  EXPECT_LE(figure.rows.size(), 41u);
  EXPECT_EQ(figure.rows.back().cells[0], "4000");
}

// --- Recording --------------------------------------------------------------------------------------------

TEST(Recording, KeepsARangeAndStaysExact) {
  const std::map<std::string, std::string> input{{"to", "1000,377"}};
  const Trace whole = test::trace_of("bresenham_line", input);
  const Trace part = test::trace_of("bresenham_line", input, {400, 50});
  EXPECT_TRUE(whole.whole());
  EXPECT_FALSE(part.whole());
  EXPECT_EQ(part.last, 1000);
  ASSERT_EQ(part.steps.size(), 50u);
  EXPECT_EQ(part.steps.front().number, (StepNumber{400, 0}));
  Playhead all(whole), some(part);
  for (const TraceStep& step : part.steps) {
    const TraceStep& same = whole.steps[index_of(whole, step.number)];
    EXPECT_EQ(step.sentence, same.sentence);
    EXPECT_EQ(all.at(index_of(whole, step.number)), some.at(index_of(part, step.number)));
  }
}

TEST(Recording, StopsWhereItsStepsChangeTooMuch) {
  // Runs of a hundred thousand pixels each: few steps, many cells
  const Trace trace = test::trace_of("bresenham_line", {{"to", "1000000,9"}, {"method", "run_length"}});
  std::size_t changes = 0;
  for (const TraceStep& step : trace.steps) changes += step.delta.size();
  EXPECT_LT(changes, Recording::most_changes + 1'100'000);
  const Trace part =
      test::trace_of("bresenham_line", {{"to", "1000000,9"}, {"method", "run_length"}}, {8, 100});
  EXPECT_EQ(part.steps.front().number, (StepNumber{8, 0}));
  EXPECT_EQ(part.last, trace.last);
}

TEST(Recording, ALineInAWindowHasConsecutiveSteps) {
  const Trace trace = test::trace_of(
      "bresenham_line", {{"from", "262,23"}, {"to", "91618510,-54756195"}, {"window", "270,0,299,19"}});
  EXPECT_TRUE(trace.whole());
  std::int64_t next = 0;
  for (const TraceStep& step : trace.steps) {
    if (step.number.fine == 0) EXPECT_EQ(step.number.step, next++);
  }
  EXPECT_EQ(next, trace.last + 1);
  EXPECT_EQ(trace.steps[1].type, "Jumped");
  EXPECT_EQ(trace.steps[1].row[0], "8");
}

TEST(Recording, JumpsIntoAHugeWindow) {
  const Trace trace = test::trace_of(
      "bresenham_line",
      {{"from", "-5,-5"}, {"to", "2000000000,900000000"}, {"window", "100,0,2000000000,2000000000"}},
      {1'000'000'000, 10});
  EXPECT_EQ(trace.steps.front().number, (StepNumber{1'000'000'000, 0}));
  EXPECT_EQ(trace.steps.front().row[0], "1000000104");
  EXPECT_EQ(trace.last, 2'000'000'005 - 105 + 1);
}

TEST(Recording, JumpsIntoAHugeLine) {
  const Trace trace = test::trace_of("bresenham_line", {{"to", "2000000000,900000000"}}, {1'500'000'000, 40});
  EXPECT_EQ(trace.last, 2'000'000'000);
  EXPECT_EQ(trace.steps.front().number, (StepNumber{1'500'000'000, 0}));
  EXPECT_EQ(trace.steps.front().key, "1500000000,675000000");
}

TEST(Recording, StepsBelowTheFirstShapeTheDrawing) {
  const Trace whole = test::trace_of("flood_fill", {{"method", "breadth_first"}});
  const Trace part = test::trace_of("flood_fill", {{"method", "breadth_first"}}, {12, 1000});
  Playhead all(whole), some(part);
  EXPECT_EQ(all.at(index_of(whole, {20, 0})), some.at(index_of(part, {20, 0})));
}

// --- Mazes -------------------------------------------------------------------------------------------------

std::string filled_maze(const std::map<std::string, std::string>& given) {
  for (const Field& field : test::trace_of("flood_fill", given).result) {
    if (field.name == "maze") return std::get<std::string>(field.value);
  }
  return "";
}

TEST(FillStory, AMazeIsPaintedWithALetter) {
  EXPECT_EQ(filled_maze({{"maze", "..#/.b#/#.."}, {"at", "0,0"}, {"paint", "a"}}), "aa#/ab#/#..");
  EXPECT_EQ(filled_maze({{"maze", "..#/.b#/#.."}, {"at", "0,0"}, {"paint", "a"}, {"window", "1,0,2,2"}}),
            "..#/.b#/#..");
  EXPECT_EQ(filled_maze({{"maze", "..#/.b#/#.."}, {"at", "1,1"}}), "..#/.x#/#..");
  EXPECT_EQ(filled_maze({{"maze", "..#/.b#/#.."}, {"at", "2,0"}, {"paint", "a"}}), "..#/.b#/#..")
      << "walls stay";
  EXPECT_EQ(filled_maze({{"maze", "bb#/.b#/#.."}, {"at", "0,0"}, {"paint", "b"}}), "bb#/.b#/#..")
      << "its own letter";
  EXPECT_THROW(filled_maze({{"paint", "#ff0000"}}), ArgumentError);
}

}  // namespace
}  // namespace gradus
