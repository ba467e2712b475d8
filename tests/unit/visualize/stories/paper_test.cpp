// Drawings in a plane: what turns one into the next, panels, scales, and the marks that only they use.

#include <gtest/gtest.h>

#include "cairo/cairo_output.hpp"
#include "cairo/shapes.hpp"
#include "figure/layout/layout.hpp"
#include "stories/paper.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

// --- Papers ------------------------------------------------------------------------------------------------

/// The frames of topics' drawings; what lies beyond a paper's border is cut off.
TEST(Papers, HoldTheFramesThatAreDrawnOnThem) {
  for (const Trace& trace : test::shared_traces()) {
    if (trace.grid.axes) continue;
    const dvec2 lower = dvec2(trace.grid.cells.lower) - 0.5, upper = dvec2(trace.grid.cells.upper) + 0.5;
    const auto judge = [&](const Mark& mark) {
      const auto* path = std::get_if<Path>(&mark.shape);
      if (!path || !path->closed || mark.role != Role::boundary) return;
      for (const dvec2 p : path->points)
        EXPECT_EQ(p, glm::clamp(p, lower, upper)) << trace.topic << " " << trace.method << ": " << mark.id;
    };
    for (const Mark& mark : trace.backdrop) judge(mark);
    for (const TraceStep& step : trace.steps) std::ranges::for_each(step.delta.set, judge);
  }
}

// --- Views -------------------------------------------------------------------------------------------------

TEST(View, TheDifferenceTurnsOneIntoTheOther) {
  View before, after;
  before.add({"a", Role::input, Dot{{1, 1}}});
  before.add({"b", Role::input, Dot{{2, 2}}});
  before.add({"c", Role::input, Dot{{3, 3}}});
  before.cells[{0, 0}] = {Role::past, ""};
  after.add({"b", Role::input, Dot{{2, 2}}});
  after.add({"c", Role::result, Dot{{3, 3}}});
  after.add({"d", Role::input, Dot{{4, 4}}});
  after.cells[{0, 1}] = {Role::past, ""};
  after.plane = false;
  const Delta delta = difference(before, after);
  EXPECT_EQ(delta.removed, std::vector<std::string>{"a"});
  EXPECT_EQ(delta.set.size(), 2u) << "b has not changed";
  EXPECT_EQ(delta.plane, std::optional(false));
  Canvas moved({{0, 0}, {5, 5}}), straight({{0, 0}, {5, 5}});
  moved.apply(difference(bare_grid(), before));
  moved.apply(delta);
  straight.apply(difference(bare_grid(), after));
  EXPECT_EQ(moved, straight);
  EXPECT_EQ(difference(after, after).size(), 0u);
}

// --- Panels ------------------------------------------------------------------------------------------------

TEST(Panel, ShowsItsWorldAsLargeAsFits) {
  const Panel panel({{2, 2}, {22, 12}}, {{0, 0}, {10, 10}});
  EXPECT_EQ(panel.at(dvec2{5, 5}), (dvec2{12, 7})) << "the middle in the middle";
  EXPECT_EQ(panel.at(dvec2{10, 10}), (dvec2{17, 12}));
  EXPECT_EQ(panel.shown().lower, (dvec2{-5, 0}));
  EXPECT_EQ(panel.shown().upper, (dvec2{15, 10}));
}

TEST(Panel, TurnsOverOnAPaperWithRowsGoingDown) {
  const Panel panel({{0, 0}, {10, 10}}, {{0, 0}, {10, 10}}, Panel::Fit::same_scale, false);
  EXPECT_EQ(panel.at(dvec2{1, 9}), (dvec2{1, 1}));
}

TEST(Panel, StretchesWhereAsked) {
  const Panel panel({{0, 0}, {20, 10}}, {{0, 0}, {1, 1000}}, Panel::Fit::stretched);
  EXPECT_EQ(panel.at(dvec2{1, 1000}), (dvec2{20, 10}));
}

TEST(Panel, AcceptsALineAndAPoint) {
  EXPECT_EQ(Panel({{0, 0}, {10, 10}}, {{3, 0}, {3, 5}}).at(dvec2{3, 5}), (dvec2{5, 10}));
  EXPECT_EQ(Panel({{0, 0}, {10, 10}}, {{3, 4}, {3, 4}}).at(dvec2{3, 4}), (dvec2{5, 5}));
}

TEST(TickDistance, IsRoundAndCoarseEnough) {
  EXPECT_EQ(tick_distance(10, 5), 2);
  EXPECT_EQ(tick_distance(10, 4), 5);
  EXPECT_EQ(tick_distance(13, 5), 5);
  EXPECT_EQ(tick_distance(1e-5, 10), 1e-6);
  EXPECT_EQ(tick_distance(3e8, 6), 5e7);
  for (double length = 1e-12; length < 1e12; length *= 1.7) {
    for (int most = 1; most < 12; ++most) {
      const double step = tick_distance(length, most);
      EXPECT_LE(length / step, most * (1 + 1e-6));
      EXPECT_GT(length / step, most / 2.51) << length << " " << most;
    }
  }
}

TEST(Axes, HaveRoundNumbersAndNoMinusZero) {
  View view;
  add_axes(view, Panel({{3, 3}, {33, 23}}, {{-3, -2}, {12, 8}}), "main", {"x", "y"});
  std::vector<std::string> numbers;
  for (const auto& [id, mark] : view.marks) {
    if (id.starts_with("axis main x value")) numbers.push_back(std::get<Text>(mark.shape).text);
  }
  std::ranges::sort(numbers);
  EXPECT_EQ(numbers, (std::vector<std::string>{"0", "10", "5"}));
}

/// The texts along the x axis from `least` to `most`, the axis' name first.
std::vector<std::string> texts_of_axis(double least, double most) {
  View view;
  add_axes(view, Panel({{3, 3}, {33, 23}}, {{least, 0}, {most, (most - least) * 2 / 3}}), "main", {"x", ""});
  std::vector<std::string> texts{std::get<Text>(view.marks.at("axis main x name").shape).text};
  std::map<double, std::string> numbers;  // from left to right
  for (const auto& [id, mark] : view.marks) {
    if (!id.starts_with("axis main x value")) continue;
    const Text& text = std::get<Text>(mark.shape);
    numbers[text.at.x] = text.text;
  }
  for (const auto& [x, text] : numbers) texts.push_back(text);
  return texts;
}

TEST(Axes, FarFromZeroCountFromARoundNumber) {
  EXPECT_EQ(texts_of_axis(1e9, 1e9 + 10),
            (std::vector<std::string>{"x − 1000000000", "0", "2", "4", "6", "8", "10"}));
  EXPECT_EQ(texts_of_axis(-1e12 - 1, -1e12 + 4),
            (std::vector<std::string>{"x + 1000000000000", "−1", "0", "1", "2", "3", "4"}));
  EXPECT_EQ(texts_of_axis(2000, 2010).front(), "x") << "short numbers stay";
  EXPECT_EQ(texts_of_axis(0, 0.002),
            (std::vector<std::string>{"x", "0", "0.0005", "0.001", "0.0015", "0.002"}));
}

TEST(Axes, PastTwoToThe53EndWithoutTicks) {
  for (const double far : {1e16, 1e17, 1e18, 1e300}) {
    EXPECT_EQ(texts_of_axis(far, far + 10).size(), 1u) << far;
    EXPECT_FALSE(can_be_told_apart(far, far + 10));
  }
  EXPECT_FALSE(can_be_told_apart(0, 1e-300));
  EXPECT_FALSE(can_be_told_apart(-1e308, 1e308)) << "the length is beyond double";
  EXPECT_FALSE(can_be_told_apart(3, 3));
  EXPECT_TRUE(can_be_told_apart(1e12, 1e12 + 1));
  EXPECT_GT(texts_of_axis(1e12, 1e12 + 1).size(), 4u);
}

TEST(Axes, AtAnyPlaceAndSizeTicksAreFewAndTellThemselvesApart) {
  for (const double place : {0.0, 1.0, -7e5, 3e9, -1e12, 4e15, 1e100}) {
    for (double size = 1e-200; size < 1e200; size *= 977) {
      const auto texts = texts_of_axis(place, place + size);
      EXPECT_LE(texts.size(), 9u) << place << " " << size;
      if (can_be_told_apart(place, place + size)) EXPECT_GE(texts.size(), 3u) << place << " " << size;
      const std::set<std::string> different(texts.begin(), texts.end());
      EXPECT_EQ(different.size(), texts.size()) << place << " " << size;
    }
  }
}

TEST(FigureReal, FourDigitsAndATypographicMinus) {
  EXPECT_EQ(figure_real(0), "0");
  EXPECT_EQ(figure_real(-0.0), "0");
  EXPECT_EQ(figure_real(-2.5), "−2.5");
  EXPECT_EQ(without_notes(figure_real(1.0 / 3)), "0.333");
  EXPECT_EQ(without_notes(figure_real(123.456)), "123.46");
  EXPECT_EQ(without_notes(figure_real(12345.678)), "12345.7");
  EXPECT_EQ(figure_real(1e-9), "1e-09");
  EXPECT_EQ(figure_real(-4e-310), "−4e-310") << "only 0 is 0";
  EXPECT_EQ(figure_place(dvec2{1, -0.5}), "(1,\u00a0−0.5)");
}

// --- Marks of planes in a figure ---------------------------------------------------------------------------

/// A figure of one step that shows this view.
Trace trace_with(const View& view) {
  TraceWriter writer({});
  writer.trace().title = "A plane";
  writer.trace().grid = paper_grid(36, 27);
  writer.step(difference(bare_grid(), view), {0, 0}, 0, [](TraceStep& step) { step.sentence = "Done."; });
  return std::move(writer).finish();
}

Sheet sheet_with(const View& view) {
  const Trace trace = trace_with(view);
  Playhead playhead(trace);
  return lay_out(figure_of(trace, playhead, {0, 0}), Look{});
}

const Shape* find_shape(const Sheet& sheet, std::string_view id) {
  const auto found = std::ranges::find(sheet.shapes, id, &Shape::id);
  return found == sheet.shapes.end() ? nullptr : &*found;
}

TEST(PlaneMarks, AnAreaLiesBelowTheLinesAndIsHatched) {
  View view;
  view.add({"a line", Role::current, Stroke{{1, 1}, {20, 20}}});
  view.add(
      {"b area", Role::past, Area{{{{2, 2}, {20, 2}, {20, 20}, {2, 20}}, {{5, 5}, {5, 9}, {9, 9}, {9, 5}}}}});
  const Sheet sheet = sheet_with(view);
  const Shape *area = find_shape(sheet, "b area"), *line = find_shape(sheet, "a line");
  ASSERT_TRUE(area && line);
  EXPECT_LT(area, line);
  const AreaShape& shape = std::get<AreaShape>(area->what);
  EXPECT_EQ(shape.rings.size(), 2u);
  // A diagonal of the hatching never runs through the hole
  const std::vector<Segment<2, double>> lines = hatch_lines(shape, sheet.unit);
  ASSERT_GT(lines.size(), 10u);
  const Box hole = test::box_around(shape.rings[1]);
  for (const auto& [a, b] : lines) {
    const dvec2 middle = (a + b) * 0.5;
    EXPECT_FALSE(hole.x < middle.x && middle.x < hole.right() && hole.y < middle.y &&
                 middle.y < hole.bottom());
  }
}

TEST(PlaneMarks, DashedLinesAreDashedWhateverTheirRole) {
  View view;
  view.add({"a", Role::result, Stroke{{1, 1}, {20, 20}, false, true}});
  view.add({"b", Role::result, Path{{{1, 1}, {20, 1}, {20, 9}}, true, true}});
  view.add({"c", Role::result, Stroke{{1, 20}, {20, 1}}});
  const Sheet sheet = sheet_with(view);
  EXPECT_TRUE(std::get<LineShape>(find_shape(sheet, "a")->what).dashed);
  const LineShape& path = std::get<LineShape>(find_shape(sheet, "b")->what);
  EXPECT_TRUE(path.dashed && path.closed);
  EXPECT_EQ(path.points.size(), 3u) << "one line, not one per edge: dashes go round the corners";
  EXPECT_FALSE(std::get<LineShape>(find_shape(sheet, "c")->what).dashed);
}

TEST(PlaneMarks, TextsStandAtTheirPlacesAndOneOnAnotherIsLeftOut) {
  View view;
  view.add({"a", Role::guide, Text{{10, 10}, "0101"}});
  view.add({"b", Role::guide, Text{{10.2, 10}, "1001"}});
  view.add({"c", Role::guide, Text{{30, 10}, "1", Align::right}});
  const Sheet sheet = sheet_with(view);
  ASSERT_TRUE(test::find_text(sheet, "a") && test::find_text(sheet, "c"));
  EXPECT_EQ(test::find_text(sheet, "b"), nullptr);
  EXPECT_EQ(test::find_text(sheet, "a")->align, Align::centre);
  EXPECT_EQ(test::find_text(sheet, "c")->align, Align::right);
}

TEST(PlaneMarks, LegendShowsADashAndATint) {
  View view;
  view.add({"a", Role::rejected, Stroke{{1, 1}, {20, 20}}});
  view.add({"b", Role::result, Area{{{{2, 2}, {20, 2}, {20, 20}}}}});
  view.add({"c", Role::guide, Text{{1, 5}, "5"}});
  Trace trace = trace_with(view);
  for (const Role role : all_roles) trace.legend.push_back({role, std::string(name_of(role))});
  Playhead playhead(trace);
  const Sheet sheet = lay_out(figure_of(trace, playhead, {0, 0}), Look{});
  EXPECT_TRUE(std::get<LineShape>(find_shape(sheet, "legend rejected")->what).dashed);
  EXPECT_TRUE(std::holds_alternative<AreaShape>(find_shape(sheet, "legend result")->what));
  EXPECT_EQ(find_shape(sheet, "legend guide"), nullptr) << "numbers of axes need no legend";
}

}  // namespace
}  // namespace gradus
