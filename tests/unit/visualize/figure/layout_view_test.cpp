// Which part of a drawing a sheet shows: the crop to what is drawn, the cells of a view, and rows that go up
// or down.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "figure/figure.hpp"
#include "figure/layout/layout.hpp"
#include "support/aspects.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

using test::aspects;
using test::Case;
using test::extent_of;
using test::find_text;
using test::shared_traces;
using test::shorter_side;
using test::slides;

// --- Crop ----------------------------------------------------------------------------------------

TEST(Crop, TheDrawingAloneHugsItsAxes) {
  for (const Case& aspect : aspects()) {
    SCOPED_TRACE(aspect.name);
    Look look = aspect.look;
    look.slots = {Slot::drawing};
    look.crop = true;
    const Trace trace = test::trace_of("bresenham_line", {{"to", "9,7"}});
    Playhead playhead(trace);
    const Sheet sheet = lay_out(figure_of(trace, playhead, {0, 0}), look);
    EXPECT_TRUE(sheet.width < look.width || sheet.height < look.height);
    std::optional<Box> axes;
    for (const Shape& shape : sheet.shapes) {
      const bool axis = shape.id == "grid" || shape.id.starts_with("x ") || shape.id.starts_with("y ");
      if (axis) axes = axes ? test::united(*axes, extent_of(shape)) : extent_of(shape);
    }
    const double loose = 42 * shorter_side(look) / 720;
    EXPECT_LE(axes->x, loose);
    EXPECT_LE(axes->y, loose);
    EXPECT_LE(sheet.width - axes->right(), loose);
    EXPECT_LE(sheet.height - axes->bottom(), loose);
  }
}

TEST(Crop, MovesTheFigureAndChangesNothing) {
  for (const Case& slide : slides()) {
    if (!slide.look.slots.contains(Slot::drawing)) continue;
    SCOPED_TRACE(slide.name);
    const Trace trace = test::trace_of("flood_fill");
    Playhead playhead(trace);
    const Figure figure = figure_of(trace, playhead, {0, 0});
    Look look = slide.look;
    const Sheet whole = lay_out(figure, look);
    look.crop = true;
    const Sheet part = lay_out(figure, look);
    EXPECT_LT(part.width * part.height, whole.width * whole.height);
    EXPECT_EQ(part.unit, whole.unit);
    std::map<std::string, Box> before;
    for (const Shape& shape : whole.shapes)
      before[fmt::format("{} {}", name_of(shape.slot), shape.id)] = extent_of(shape);
    std::optional<dvec2> shift;
    for (const Shape& shape : part.shapes) {
      if (shape.slot == Slot::drawing && std::holds_alternative<TextShape>(shape.what) &&
          !shape.id.starts_with("x ") && !shape.id.starts_with("y ")) {
        continue;  // labels look for places inside
      }
      if (shape.id.starts_with("leader ")) continue;
      const Box was = before.at(fmt::format("{} {}", name_of(shape.slot), shape.id)), is = extent_of(shape);
      const dvec2 by{was.x - is.x, was.y - is.y};
      if (!shift) shift = by;
      EXPECT_NEAR(by.x, shift->x, 1e-9) << shape.id;
      EXPECT_NEAR(by.y, shift->y, 1e-9) << shape.id;
    }
    EXPECT_EQ(shift->x, std::floor(shift->x)) << "whole pixels";
  }
}

TEST(Crop, LabelsOfANarrowGridFindRoom) {
  Look look;
  look.slots = {Slot::drawing};
  look.crop = true;
  const Trace trace = test::trace_of("bresenham_line", {{"from", "3,-2"}, {"to", "3,9"}});
  Playhead playhead(trace);
  const Sheet sheet = lay_out(figure_of(trace, playhead, {6, 0}), look);
  std::size_t labels = 0;
  for (const Shape& shape : sheet.shapes) labels += shape.id.starts_with("rim ") ? 1u : 0u;
  EXPECT_EQ(labels, 4u) << "the ideal line, the midpoint, what was chosen, what was not";
}

// --- View ----------------------------------------------------------------------------------------

TEST(View, ShowsExactlyTheseCells) {
  const Window view{{1, 0}, {5, 3}};
  for (const Case& aspect : aspects()) {
    SCOPED_TRACE(aspect.name);
    Look look = aspect.look;
    look.view = view;
    const Trace trace = test::trace_of("flood_fill");
    Playhead playhead(trace);
    for (const TraceStep& step : trace.steps) {
      const Figure figure = figure_of(trace, playhead, step.number);
      EXPECT_EQ(layout::visible_cells(figure, look), view);
      const Sheet sheet = lay_out(figure, look);
      std::set<std::string> ticks;
      bool points_outside = false;
      for (const Shape& shape : sheet.shapes) {
        if (shape.slot == Slot::drawing && shape.id.starts_with("cell ")) {
          int x = 0, y = 0;
          ASSERT_EQ(std::sscanf(shape.id.c_str(), "cell %d,%d", &x, &y), 2);
          EXPECT_TRUE(view.contains({x, y})) << shape.id;
        }
        if (shape.id.starts_with("x ") || shape.id.starts_with("y ")) ticks.insert(shape.id);
        points_outside |= shape.id == "outside";
      }
      EXPECT_TRUE(ticks.contains("x 1") && ticks.contains("x 5") && ticks.contains("y 0") &&
                  ticks.contains("y 3"));
      EXPECT_FALSE(ticks.contains("x 0") || ticks.contains("x 6") || ticks.contains("y 4"));
      EXPECT_EQ(points_outside, !view.contains(step.focus) && trace.grid.cells.contains(step.focus));
      if (points_outside) {
        EXPECT_EQ(find_text(sheet, "outside name")->text,
                  fmt::format("({}, {})", step.focus.x, step.focus.y));
      }
    }
  }
}

TEST(View, IsCutToTheGrid) {
  Look look;
  look.view = Window{{5, 3}, {1000, 1000}};
  const Trace trace = test::trace_of("flood_fill");
  EXPECT_EQ(layout::visible_cells({.trace = &trace}, look), (Window{{5, 3}, {9, 6}}));
}

TEST(View, ThatMissesTheGridIsRefused) {
  Look look;
  look.view = Window{{10, 0}, {12, 3}};
  const Trace trace = test::trace_of("flood_fill");
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {0, 0});
  try {
    lay_out(figure, look);
    FAIL() << "should have thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "expected cells of the grid 0,-2 to 9,6, found 10,0 to 12,3");
  }
}

TEST(View, TheLargestFitsAndOneMoreDoesNot) {
  const Trace huge = test::trace_of("bresenham_line", {{"to", "100000,40000"}}, {0, 20});
  Playhead playhead(huge);
  const Figure figure = figure_of(huge, playhead, {0, 0});
  for (const Case& slide : slides()) {
    if (!slide.look.slots.contains(Slot::drawing)) continue;
    SCOPED_TRACE(slide.name);
    Look look = slide.look;
    const ivec2 lower{1000, 1000};  // so that all numbers of the axes are as wide
    look.view = Window{lower, lower + ivec2{299, 199}};
    const ivec2 most = largest_view(huge, look);
    EXPECT_GE(most.x, 4);
    EXPECT_GE(most.y, 3);
    try {
      lay_out(figure, look);
      FAIL() << "should have thrown";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(),
                fmt::format("expected at most {} x {} cells for this size, found 300 x 200", most.x, most.y));
    }
    look.view = Window{lower, lower + most};
    EXPECT_THROW(lay_out(figure, look), std::invalid_argument);
    look.view = Window{lower, lower + most - 1};
    EXPECT_EQ(layout::visible_cells(figure, look), *look.view);
  }
}

// --- Up and down ---------------------------------------------------------------------------------

TEST(YUp, TurnsTheDrawingAndNothingElse) {
  std::size_t cells = 0, same = 0;
  for (const char* topic : {"bresenham_line", "flood_fill"}) {
    const Trace trace = test::trace_of(topic);
    Playhead playhead(trace);
    for (const TraceStep& step : trace.steps) {
      const Figure figure = figure_of(trace, playhead, step.number);
      Look look;
      look.y_up = true;
      const Sheet up = lay_out(figure, look);
      look.y_up = false;
      const Sheet down = lay_out(figure, look);
      std::map<std::string, Box> boxes;
      std::map<std::string, std::string> texts;
      Box frame, turned;  // of the grid, turned with its cells
      for (const Shape& shape : down.shapes) {
        if (shape.id == "grid") turned = extent_of(shape);
      }
      for (const Shape& shape : up.shapes) {
        const std::string id = fmt::format("{} {}", name_of(shape.slot), shape.id);
        boxes[id] = extent_of(shape);
        if (const TextShape* text = std::get_if<TextShape>(&shape.what)) texts[id] = text->text;
        if (shape.id == "grid") frame = extent_of(shape);
      }
      for (const Shape& shape : down.shapes) {
        const std::string id = fmt::format("{} {}", name_of(shape.slot), shape.id);
        const Box box = extent_of(shape);
        if (shape.slot == Slot::drawing && shape.id.starts_with("cell ")) {
          ++cells;
          EXPECT_NEAR(box.x, boxes.at(id).x, 1e-9);
          EXPECT_NEAR(box.y - turned.y, frame.bottom() - boxes.at(id).bottom(), 1e-9) << id;
        }
        const TextShape* text = std::get_if<TextShape>(&shape.what);
        if (!text || shape.id == "y axis") continue;
        ++same;
        EXPECT_EQ(text->text, texts.at(id));
        if (shape.slot != Slot::drawing) EXPECT_EQ(box.y, boxes.at(id).y);
      }
      EXPECT_THAT(find_text(up, "y axis")->text, testing::HasSubstr("↑"));
      EXPECT_THAT(find_text(down, "y axis")->text, testing::HasSubstr("↓"));
    }
  }
  EXPECT_GT(cells, test::thinned(500, 4));
  EXPECT_GT(same, 1000u);
}

TEST(YUp, TurnsThePicture) {
  for (const Trace& trace : test::telling_traces({}, "flood_fill")) {
    if (!trace.grid.picture) continue;
    Playhead playhead(trace);
    const Figure figure = figure_of(trace, playhead, trace.steps.front().number);
    const auto images = [&](bool y_up) {
      Look look;
      look.y_up = y_up;
      std::map<std::string, Image> found;
      for (const Shape& shape : lay_out(figure, look).shapes) {
        if (const ImageShape* image = std::get_if<ImageShape>(&shape.what)) found[shape.id] = image->image;
      }
      return found;
    };
    const auto up = images(true), down = images(false);
    for (const char* id : {"picture", "overview"}) {
      const Image &a = up.at(id), &b = down.at(id);
      ASSERT_EQ(a.height(), b.height());
      for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) ASSERT_EQ((a[{x, y}]), (b[{x, a.height() - 1 - y}])) << id;
      }
    }
    return;
  }
  FAIL() << "no trace with a picture";
}

}  // namespace
}  // namespace gradus
