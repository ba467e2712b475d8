// Between two steps: stills at the ends, what stays on its way, nothing that leaps.

#include "figure/transition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "support/example_traces.hpp"
#include "support/sanitized.hpp"

namespace gradus {
namespace {

const Paint ink = Paint::of(Tone::ink);

Sheet sheet_with(std::vector<Shape> shapes) { return {100, 100, std::move(shapes), 1}; }

Shape rect(const std::string& id, const Box& box, Slot slot = Slot::drawing) {
  return {slot, id, RectShape{.box = box, .fill = Paint::fill(Role::current), .stroke = {}}};
}
Shape text(const std::string& id, dvec2 at, const std::string& words, Paint paint = Paint::text(Role::past),
           Slot slot = Slot::drawing) {
  return {slot, id, TextShape{.baseline = at, .text = words, .paint = paint}};
}
Shape line(const std::string& id, std::vector<dvec2> points) {
  return {Slot::drawing, id, LineShape{.points = std::move(points), .stroke = ink}};
}

const Shape* found(const Sheet& sheet, const std::string& id) {
  const auto at = std::ranges::find(sheet.shapes, id, &Shape::id);
  return at == sheet.shapes.end() ? nullptr : &*at;
}
template <class What>
What named(const Sheet& sheet, const std::string& id) {  // a copy: most sheets here end with their line
  const Shape* shape = found(sheet, id);
  if (shape == nullptr) throw std::out_of_range(id);
  return std::get<What>(shape->what);
}
double opacity_of(const Sheet& sheet, const std::string& id) {
  const Shape* shape = found(sheet, id);
  return shape == nullptr ? 0 : shape->opacity;
}

TEST(Transition, MovesWhatStays) {
  const Sheet from = sheet_with({rect("dot", {0, 0, 10, 20})}),
              to = sheet_with({rect("dot", {40, 8, 30, 20})});
  const Box middle = named<RectShape>(in_between(from, to, 0.5), "dot").box;
  EXPECT_EQ(middle.x, 20);
  EXPECT_EQ(middle.y, 4);
  EXPECT_EQ(middle.width, 20);
  EXPECT_EQ(middle.height, 20);
  double before = 0, steepest = 0;
  for (int i = 1; i < 100; ++i) {
    const double x = named<RectShape>(in_between(from, to, i / 100.0), "dot").box.x;
    EXPECT_GT(x, before) << "never back";
    EXPECT_LT(x, 40);
    steepest = std::max(steepest, x - before);
    before = x;
    const double mirrored = named<RectShape>(in_between(from, to, 1 - i / 100.0), "dot").box.x;
    EXPECT_NEAR(x + mirrored, 40, 1e-9) << "ends as it began";
  }
  const double first = named<RectShape>(in_between(from, to, 0.01), "dot").box.x;
  EXPECT_LT(first, steepest / 10) << "slow at first";
}

TEST(Transition, TellsShapesOfOneNameApart) {
  const Sheet from = sheet_with(
      {rect("cross", {0, 0, 1, 1}), rect("cross", {50, 0, 1, 1}), rect("cross", {0, 90, 1, 1}, Slot::table)});
  const Sheet to = sheet_with({rect("cross", {10, 0, 1, 1}), rect("cross", {60, 0, 1, 1}),
                               rect("cross", {0, 80, 1, 1}, Slot::table)});
  const Sheet middle = in_between(from, to, 0.5);
  ASSERT_EQ(middle.shapes.size(), 3u);
  EXPECT_EQ(std::get<RectShape>(middle.shapes[0].what).box.x, 5);
  EXPECT_EQ(std::get<RectShape>(middle.shapes[1].what).box.x, 55);
  EXPECT_EQ(std::get<RectShape>(middle.shapes[2].what).box.y, 85);
}

TEST(Transition, FadesWhatComesAndGoes) {
  const Sheet from = sheet_with({rect("ground", {0, 0, 9, 9}), rect("old", {0, 0, 1, 1}), rect("top", {})});
  const Sheet to = sheet_with({rect("ground", {0, 0, 9, 9}), rect("new", {5, 5, 1, 1}), rect("top", {})});
  EXPECT_DOUBLE_EQ(opacity_of(in_between(from, to, 0.25), "old"), 0.5);
  EXPECT_EQ(opacity_of(in_between(from, to, 0.25), "new"), 0);
  EXPECT_EQ(opacity_of(in_between(from, to, 0.75), "old"), 0);
  EXPECT_DOUBLE_EQ(opacity_of(in_between(from, to, 0.75), "new"), 0.5);
  EXPECT_EQ(opacity_of(in_between(from, to, 0.75), "ground"), 1);
  const Sheet early = in_between(from, to, 0.25);
  ASSERT_EQ(early.shapes.size(), 3u);
  EXPECT_EQ(early.shapes[1].id, "old") << "in its place of the drawing order";
}

TEST(Transition, ExchangesTextsAndLooksMidway) {
  const Shape before = text("p", {10, 50}, "p = 1"), after = text("p", {30, 50}, "p = 2");
  for (const double share : {0.1, 0.49}) {
    const auto shown = named<TextShape>(in_between(sheet_with({before}), sheet_with({after}), share), "p");
    EXPECT_EQ(shown.text, "p = 1");
    EXPECT_EQ(shown.baseline.x, 10) << "labels that change don't slide over each other";
  }
  const Sheet late = in_between(sheet_with({before}), sheet_with({after}), 0.51);
  EXPECT_EQ(named<TextShape>(late, "p").text, "p = 2");
  EXPECT_EQ(named<TextShape>(late, "p").baseline.x, 30);
  Shape plain = rect("cell", {}), hatched = plain;
  std::get<RectShape>(hatched.what).hatch = Hatch::rising;
  const auto hatch_at = [&](double share) {
    return named<RectShape>(in_between(sheet_with({plain}), sheet_with({hatched}), share), "cell").hatch;
  };
  EXPECT_EQ(hatch_at(0.4), Hatch::none);
  EXPECT_EQ(hatch_at(0.6), Hatch::rising);
}

TEST(Transition, LinesThatGoOnGrow) {
  const Sheet from = sheet_with({line("way", {{0, 0}, {10, 0}})});
  const Sheet to = sheet_with({line("way", {{0, 0}, {10, 0}, {10, 8}})});
  for (const auto& [one, other] : {std::pair{from, to}, std::pair{to, from}}) {
    const auto points = named<LineShape>(in_between(one, other, 0.5), "way").points;
    EXPECT_EQ(points, (std::vector<dvec2>{{0, 0}, {10, 0}, {10, 4}}));
  }
  const Sheet elsewhere = sheet_with({line("way", {{5, 5}, {6, 6}, {7, 7}})});
  EXPECT_EQ(named<LineShape>(in_between(from, elsewhere, 0.4), "way").points.size(), 2u);
  EXPECT_EQ(named<LineShape>(in_between(from, elsewhere, 0.6), "way").points.size(), 3u);
}

TEST(Transition, AViewThatFollowsChangesAtOnce) {
  const auto view = [](double x, const std::string& other) {
    return sheet_with({text("x 3", {x, 90}, "3", Paint::of(Tone::muted)), rect("cell", {x, 50, 9, 9}),
                       rect(other, {}), rect("bar", {x, 0, 1, 1}, Slot::table)});
  };
  const Sheet early = in_between(view(10, "old"), view(30, "new"), 0.4);
  EXPECT_EQ(named<RectShape>(early, "cell").box.x, 10);
  EXPECT_EQ(opacity_of(early, "old"), 1);
  EXPECT_EQ(opacity_of(early, "new"), 0);
  EXPECT_GT(named<RectShape>(early, "bar").box.x, 10) << "the other slots move as ever";
  const Sheet late = in_between(view(10, "old"), view(30, "new"), 0.6);
  EXPECT_EQ(named<RectShape>(late, "cell").box.x, 30);
  EXPECT_EQ(opacity_of(late, "old"), 0);
  EXPECT_EQ(opacity_of(late, "new"), 1);
}

// --- Real runs ---------------------------------------------------------------------------------------------

class TransitionOf : public testing::TestWithParam<const char*> {};

TEST_P(TransitionOf, BeginsAndEndsAsTheStills) {
  const Trace trace = test::trace_of(GetParam());
  Playhead playhead(trace);
  const Finish finish(*find_theme("light"));
  const auto picture = [&](const Sheet& sheet) { return svg_of(sheet, finish, {}); };
  std::size_t steps = 0, moving = 0;
  for (int i = 0; i + 1 < (test::sanitized ? 6 : 10) && has_step(trace, {i + 1, 0}); ++i, ++steps) {
    const Sheet from = lay_out(figure_of(trace, playhead, {i, 0}), {});
    const Sheet to = lay_out(figure_of(trace, playhead, {i + 1, 0}), {});
    EXPECT_EQ(picture(in_between(from, to, 0)), picture(from)) << i;
    EXPECT_EQ(picture(in_between(from, to, 1)), picture(to)) << i;
    // Just after the start and just before the end hardly a pixel differs: nothing leaps there
    const auto differing = [&](const Sheet& a, const Sheet& b) {
      const Image one = image_of(a, finish), other = image_of(b, finish);
      std::ptrdiff_t count = 0;
      for (std::size_t at = 0; at < one.cells().size(); ++at)
        count += std::abs(one.cells()[at].g - other.cells()[at].g) > 8;
      return count;
    };
    EXPECT_LT(differing(in_between(from, to, 1e-4), from), 20) << i;
    EXPECT_LT(differing(in_between(from, to, 1 - 1e-4), to), 20) << i;
    moving += picture(in_between(from, to, 0.3)) != picture(from) &&
              picture(in_between(from, to, 0.7)) != picture(to);
  }
  EXPECT_GE(steps, 5u);
  EXPECT_GE(moving, steps / 2);
}

INSTANTIATE_TEST_SUITE_P(Topics, TransitionOf,
                         testing::Values("bresenham_line", "flood_fill", "sutherland_hodgman",
                                         "cohen_sutherland_2d"));

}  // namespace
}  // namespace gradus
