// What a lecturer sees: legible from the last row, nothing overlaps, nothing is clipped, nothing jumps.

#include "figure/figure.hpp"

#include <gtest/gtest.h>

#include "cli/lecture.hpp"
#include "figure/layout.hpp"
#include "support/example_traces.hpp"
#include "theme/theme.hpp"

namespace gradus {
namespace {

std::vector<const TextShape*> texts_of(const Sheet& sheet) {
  std::vector<const TextShape*> texts;
  for (const Shape& shape : sheet.shapes) {
    if (const TextShape* text = std::get_if<TextShape>(&shape.what)) texts.push_back(text);
  }
  return texts;
}

/// Calls f(trace, sheet, step) for up to `most` steps of every telling trace, evenly spread.
template <class F>
std::size_t for_each_sheet(F f, const Look& look = {}, std::size_t most = 40) {
  std::size_t count = 0;
  for (const Trace& trace : test::telling_traces()) {
    SCOPED_TRACE(trace.topic + " " + trace.method + " " + trace.subtitle);
    Playhead playhead(trace);
    const std::size_t stride = std::max<std::size_t>(1, trace.steps.size() / most);
    for (std::size_t i = 0; i < trace.steps.size(); i += stride) {
      SCOPED_TRACE("step " + text_of(trace.steps[i].number));
      f(trace, lay_out(figure_of(trace, playhead, trace.steps[i].number), look), i);
      ++count;
    }
  }
  return count;
}

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

TEST(Layout, NoTextIsSmallerThanLegible) {
  const std::size_t sheets = for_each_sheet([](const Trace&, const Sheet& sheet, std::size_t) {
    for (const Shape& shape : sheet.shapes) {
      const TextShape* text = std::get_if<TextShape>(&shape.what);
      if (!text) continue;
      EXPECT_GE(text->size, sheet.height / 36) << text->text;
      if (shape.slot == Slot::sentence) EXPECT_GE(text->size, sheet.height / 28);
    }
  });
  EXPECT_GT(sheets, 500u);
}

TEST(Layout, NoTwoTextsOverlap) {
  for_each_sheet([](const Trace&, const Sheet& sheet, std::size_t) {
    const auto texts = texts_of(sheet);
    ASSERT_GT(texts.size(), 5u);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      for (std::size_t k = i + 1; k < texts.size(); ++k) {
        EXPECT_FALSE(overlap(texts[i]->box(), texts[k]->box())) << texts[i]->text << " | " << texts[k]->text;
      }
    }
  });
}

TEST(Layout, NothingIsClipped) {
  for_each_sheet([](const Trace&, const Sheet& sheet, std::size_t) {
    for (const TextShape* text : texts_of(sheet)) {
      const Box box = text->box();
      EXPECT_TRUE(box.x >= 0 && box.y >= 0 && box.right() <= sheet.width && box.bottom() <= sheet.height)
          << text->text;
      EXPECT_TRUE(missing_characters(text->text, text->face).empty()) << text->text;
    }
  });
}

TEST(Layout, NoLineLeavesTheSheet) {
  // A line through a window goes on beyond it, in the view and in the overview
  std::size_t points = 0;
  for_each_sheet([&](const Trace&, const Sheet& sheet, std::size_t) {
    for (const Shape& shape : sheet.shapes) {
      if (shape.slot != Slot::drawing) continue;
      std::vector<dvec2> corners;
      if (const LineShape* line = std::get_if<LineShape>(&shape.what)) corners = line->points;
      if (const StrokesShape* strokes = std::get_if<StrokesShape>(&shape.what)) {
        for (const auto& [a, b] : strokes->segments) corners.insert(corners.end(), {a, b});
      }
      for (const dvec2 p : corners) {
        ++points;
        EXPECT_TRUE(p.x >= 0 && p.x <= 640 && p.y >= 80 && p.y <= 600)
            << shape.id << " " << p.x << " " << p.y;
      }
    }
  });
  EXPECT_GT(points, 10000u);
}

TEST(Layout, SentencesOfTheGalleryAreNotCutShort) {
  const cli::Lecture gallery = cli::read_lecture(cli::gallery_lecture());
  ASSERT_GT(gallery.figures.size(), 0u);
  for (const cli::LectureFigure& figure : gallery.figures) {
    const Trace trace = figure.spec.topic->run(figure.spec.arguments, {});
    Playhead playhead(trace);
    for (const TraceStep& step : trace.steps) {
      const Sheet sheet = lay_out(figure_of(trace, playhead, step.number), figure.spec.look);
      for (const TextShape* text : texts_of(sheet)) {
        if (text->size > layout::text_size) EXPECT_EQ(text->text.find("…"), std::string::npos) << text->text;
      }
    }
  }
}

TEST(Layout, AxesAndSlotsStayPutOverAllSteps) {
  // Small grids: the whole drawing; and always the panels of listing and sentence
  const Trace trace = test::trace_of("bresenham_line");
  Playhead playhead(trace);
  std::map<std::string, Box> first;
  for (const TraceStep& step : trace.steps) {
    const Sheet sheet = lay_out(figure_of(trace, playhead, step.number), {});
    for (const Shape& shape : sheet.shapes) {
      const bool fixed = shape.id.starts_with("x ") || shape.id.starts_with("y ") ||
                         shape.id == "ideal line name" || shape.id == "title" ||
                         shape.id.starts_with("heading ");
      const TextShape* text = std::get_if<TextShape>(&shape.what);
      if (!fixed || !text) continue;
      const auto [at, added] = first.emplace(shape.id, text->box());
      EXPECT_EQ(at->second.x, text->box().x) << shape.id;
      EXPECT_EQ(at->second.y, text->box().y) << shape.id;
    }
  }
  EXPECT_GT(first.size(), 15u);
}

TEST(Layout, CellsAreNeverSmallerThan24Pixels) {
  std::size_t cells = 0;
  for_each_sheet([&](const Trace&, const Sheet& sheet, std::size_t) {
    for (const Shape& shape : sheet.shapes) {
      const RectShape* rect = std::get_if<RectShape>(&shape.what);
      if (!rect || !shape.id.starts_with("cell ")) continue;
      ++cells;
      EXPECT_GE(rect->box.width, 24);
    }
  });
  EXPECT_GT(cells, 1000u);
}

TEST(Layout, TheCurrentCellIsInView) {
  for_each_sheet([](const Trace& trace, const Sheet& sheet, std::size_t index) {
    const ivec2 focus = trace.steps[index].focus;
    if (!trace.grid.cells.contains(focus)) return;
    bool column = false, row = false;
    for (const Shape& shape : sheet.shapes) {
      if (shape.id == "overview view") column = true;
    }
    const Figure figure{.trace = &trace, .focus = focus};
    const Window view = layout::visible_cells(figure, {40, 84, 570, 480}, 1);
    row = view.contains(focus);
    EXPECT_TRUE(row) << focus.x << "," << focus.y << (column ? " (a view that follows)" : "");
  });
}

TEST(Layout, SlotsCanBeSwitchedOff) {
  Look look;
  look.slots = {Slot::drawing, Slot::table};
  const std::size_t sheets = for_each_sheet(
      [](const Trace&, const Sheet& sheet, std::size_t) {
        std::set<Slot> seen;
        for (const Shape& shape : sheet.shapes) seen.insert(shape.slot);
        EXPECT_EQ(seen, (std::set<Slot>{Slot::drawing, Slot::table}));
      },
      look, 3);
  EXPECT_GT(sheets, 30u);
}

TEST(Layout, ScalesWithTheHeight) {
  const Trace trace = test::trace_of("bresenham_line");
  Playhead playhead(trace);
  const Sheet small = lay_out(figure_of(trace, playhead, {4, 0}), {});
  Look look;
  look.width *= 2;
  look.height *= 2;
  const Sheet large = lay_out(figure_of(trace, playhead, {4, 0}), look);
  ASSERT_EQ(small.shapes.size(), large.shapes.size());
  const auto a = texts_of(small), b = texts_of(large);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(2 * a[i]->baseline.x, b[i]->baseline.x, 1e-9);
}

// --- Contrast ---------------------------------------------------------------------------------------------

TEST(Theme, EveryTextHasContrastOnItsGround) {
  std::size_t texts = 0;
  for_each_sheet(
      [&](const Trace&, const Sheet& sheet, std::size_t) {
        for (const TextShape* text : texts_of(sheet)) {
          ++texts;
          for (const Theme& theme : themes()) {
            EXPECT_GE(contrast(color_of(text->paint, theme), color_of(text->ground, theme)), 4.5)
                << theme.name << ": " << text->text;
          }
        }
      },
      {}, 6);
  EXPECT_GT(texts, 1000u);
}

TEST(Theme, EveryMarkHasContrastOnThePaper) {
  ASSERT_EQ(themes().size(), 4u);
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

/// How a projector without colour shows it.
double grey(Rgb c) { return 0.2126 * c.red() + 0.7152 * c.green() + 0.0722 * c.blue(); }

TEST(Theme, CellRolesStayApartWithoutColour) {
  // Another hatch, outline, dash or cross; or clearly another grey
  for (const Theme& theme : themes()) {
    for (const Role a : all_roles) {
      for (const Role b : all_roles) {
        if (a >= b || a == Role::measure || b == Role::measure) continue;
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

TEST(Figure, AFinerStepMarksTheTestThatWasRead) {
  const Trace trace = test::trace_of("bresenham_line");
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {3, 1});
  EXPECT_EQ(figure.rows.back().emphasis, Emphasis::weak);
  EXPECT_EQ(figure.rows.back().cells.back(), "NE");
  EXPECT_TRUE(figure.canvas->marks().contains("midpoint"));
}

TEST(Figure, TheErrorShownIsTheExactDistance) {
  const Trace trace = test::trace_of("bresenham_line");
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4, 0});
  const Mark& error = figure.canvas->marks().at("error name");
  EXPECT_EQ(std::get<Label>(error.shape).text, "error 2/7");
}

TEST(Figure, ADriftingSumIsCorrectedTruthfully) {
  // (0,0)-(12,10) passes midway at 9; (0,0)-(359,349) does not at 341
  const Trace tie = test::trace_of("bresenham_line", {{"to", "12,10"}, {"method", "dda"}});
  const Trace off = test::trace_of("bresenham_line", {{"to", "359,349"}, {"method", "dda"}});
  EXPECT_NE(tie.steps[index_of(tie, {9, 0})].sentence.find("passes midway, and a tie goes to (9,"),
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
  const Trace trace = test::trace_of("bresenham_line", {{"to", "90000,1234"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {40000, 0});
  EXPECT_LE(figure.rows.size(), 41u);
  EXPECT_EQ(figure.rows.back().cells[0], "40000");
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
  EXPECT_EQ(filled_maze({{"maze", "..#/.b#/#.."}, {"at", "0,0"}, {"color", "a"}}), "aa#/ab#/#..");
  EXPECT_EQ(filled_maze({{"maze", "..#/.b#/#.."}, {"at", "0,0"}, {"color", "a"}, {"window", "1,0,2,2"}}),
            "..#/.b#/#..");
  EXPECT_EQ(filled_maze({{"maze", "..#/.b#/#.."}, {"at", "1,1"}}), "..#/.x#/#..");
  EXPECT_EQ(filled_maze({{"maze", "..#/.b#/#.."}, {"at", "2,0"}, {"color", "a"}}), "..#/.b#/#..")
      << "walls stay";
  EXPECT_EQ(filled_maze({{"maze", "bb#/.b#/#.."}, {"at", "0,0"}, {"color", "b"}}), "bb#/.b#/#..")
      << "its own letter";
  EXPECT_THROW(filled_maze({{"color", "#ff0000"}}), ArgumentError);
}

}  // namespace
}  // namespace gradus
