// The drawing as data: planes without cells, cells in colours of their own, grids that are always shown
// whole.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "figure/layout/layout.hpp"
#include "json/json.hpp"
#include "stories/paper.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

constexpr Rgba8 orange{255, 128, 0}, teal{0, 128, 128};

Delta plane(bool is_plane, std::vector<CellChange> cells = {}, std::vector<std::string> removed = {}) {
  return {is_plane, std::move(removed), std::move(cells), {}};
}
Delta cells(std::vector<CellChange> changes) { return {std::nullopt, {}, std::move(changes), {}}; }

// --- The canvas --------------------------------------------------------------------------------------------

TEST(Canvas, IsAPlaneUntilAStepSaysOtherwise) {
  Canvas canvas(Window{{0, 0}, {3, 3}});
  EXPECT_FALSE(canvas.plane());
  const Canvas grid = canvas;
  canvas.apply(plane(true));
  EXPECT_TRUE(canvas.plane());
  EXPECT_NE(canvas, grid);
  canvas.apply({std::nullopt, {}, {}, {{"a", Role::input, Dot{{1, 1}}}}});
  EXPECT_TRUE(canvas.plane()) << "a step that says nothing of it";
  canvas.apply(plane(false, {}, {"a"}));
  EXPECT_EQ(canvas, grid);
}

TEST(Canvas, CellsKeepTheirColoursUntilTheyChange) {
  // A grid with a byte per cell, and one too large for that
  for (const Window& window :
       {Window{{0, 0}, {3, 3}}, Window{{INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX}}}) {
    Canvas canvas(window);
    const Canvas bare = canvas;
    canvas.apply(cells({{{1, 2}, CellLook{Role::past, "", orange}}, {{2, 2}, CellLook{Role::past, "7"}}}));
    EXPECT_EQ(canvas.at({1, 2})->color, std::optional(orange));
    EXPECT_EQ(canvas.at({2, 2})->color, std::nullopt);
    EXPECT_EQ(canvas.at({2, 2})->text, "7");
    Canvas other = bare;
    other.apply(cells({{{1, 2}, CellLook{Role::past, "", teal}}, {{2, 2}, CellLook{Role::past, "7"}}}));
    EXPECT_NE(canvas, other) << "another colour";
    canvas.apply(cells({{{1, 2}, CellLook{Role::past, "", teal}}}));
    EXPECT_EQ(canvas, other);
    canvas.apply(cells({{{1, 2}, CellLook{Role::result, ""}}}));
    EXPECT_EQ(canvas.at({1, 2})->color, std::nullopt) << "a look without a colour has none";
    canvas.apply(cells({{{1, 2}, std::nullopt}, {{2, 2}, std::nullopt}}));
    EXPECT_EQ(canvas, bare);
  }
}

// --- In a figure -------------------------------------------------------------------------------------------

/// Three steps: a grid with two coloured cells, a plane, the grid again.
Trace coloured(int columns, bool whole) {
  TraceWriter writer({});
  writer.trace().title = "Colours";
  Grid& grid = writer.trace().grid;
  grid.cells = {{0, 0}, {columns - 1, 7}};
  grid.y_up = false;
  grid.whole = whole;
  const auto told = [](TraceStep& step) { step.sentence = "Done."; };
  writer.step(cells({{{0, 1}, CellLook{Role::past, "", orange}}, {{2, 7}, CellLook{Role::past, "", teal}}}),
              {0, 0}, 0, told);
  writer.step(plane(true, {{{0, 1}, std::nullopt}, {{2, 7}, std::nullopt}}), {0, 0}, 0, told);
  writer.step(plane(false, {{{3, 3}, CellLook{Role::past, "", orange}}}), {0, 0}, 0, told);
  return std::move(writer).finish();
}

Sheet sheet_of(const Trace& trace, std::int64_t step) {
  Playhead playhead(trace);
  return lay_out(figure_of(trace, playhead, {step, 0}), Look{});
}

const Shape* shape_called(const Sheet& sheet, std::string_view id) {
  const auto found = std::ranges::find(sheet.shapes, id, &Shape::id);
  return found == sheet.shapes.end() ? nullptr : &*found;
}

TEST(Layout, CellsWithColoursAreOnePicture) {
  const Sheet sheet = sheet_of(coloured(12, false), 0);
  const Shape* colours = shape_called(sheet, "colours");
  ASSERT_TRUE(colours);
  const Image& image = std::get<ImageShape>(colours->what).image;
  ASSERT_EQ(image.window(), (Window{{0, 0}, {11, 7}}));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 12; ++x) {
      const Rgba8 expected = ivec2{x, y} == ivec2{0, 1}   ? orange
                             : ivec2{x, y} == ivec2{2, 7} ? teal
                                                          : Rgba8{0, 0, 0, 0};
      EXPECT_EQ((image[{x, y}]), expected) << x << ", " << y;
    }
  }
  EXPECT_EQ(shape_called(sheet, "cell 0,1"), nullptr) << "no ground of a role below it";
}

TEST(Layout, APlaneHasNoGridAndNoAxes) {
  const Trace trace = coloured(12, false);
  EXPECT_TRUE(shape_called(sheet_of(trace, 0), "grid"));
  EXPECT_EQ(shape_called(sheet_of(trace, 1), "grid"), nullptr);
  EXPECT_EQ(shape_called(sheet_of(trace, 1), "colours"), nullptr);
  EXPECT_TRUE(shape_called(sheet_of(trace, 2), "grid"));
}

TEST(Layout, AWholeGridIsShownInSmallCellsInsteadOfAPart) {
  const auto columns_shown = [](bool whole) {
    const Sheet sheet = sheet_of(coloured(100, whole), 0);
    const Shape* colours = shape_called(sheet, "colours");
    return colours ? std::get<ImageShape>(colours->what).image.width() : 0;
  };
  EXPECT_EQ(columns_shown(true), 100);
  EXPECT_LT(columns_shown(false), 100);
}

/// A plane of 12 x 8 cells with these pictures on it.
Trace pictured(std::vector<Mark> pictures) {
  TraceWriter writer({});
  writer.trace().title = "Pictures";
  Grid& grid = writer.trace().grid;
  grid.cells = {{0, 0}, {11, 7}};
  grid.whole = true;
  writer.step({true, {}, {}, std::move(pictures)}, {0, 0}, 0,
              [](TraceStep& step) { step.sentence = "Done."; });
  return std::move(writer).finish();
}

/// Of 4 x 2 pixels, each another.
std::shared_ptr<const Image> eight_pixels() {
  Image image(4, 2);
  for (int i = 0; i < 8; ++i)
    image[{i % 4, i / 4}] = {static_cast<std::uint8_t>(30 * i), 0, static_cast<std::uint8_t>(200 - 20 * i),
                             255};
  return std::make_shared<const Image>(std::move(image));
}

TEST(Layout, APictureIsCutAtTheBorderByWholePixels) {
  const auto image = eight_pixels();
  Image inner(3,
              1);  // the upper row's last three: what lies inside where its first column and lower row don't
  for (int x = 0; x < 3; ++x) inner[{x, 0}] = (*image)[{x + 1, 0}];
  const Sheet sheet = sheet_of(
      pictured(
          {{"cut", Role::result, Picture{{-2.5, -3.5}, {5.5, 2.5}, image}},
           {"whole", Role::result, Picture{{-0.5, -0.5}, {5.5, 2.5}, std::make_shared<const Image>(inner)}}}),
      0);
  const Shape *cut = shape_called(sheet, "cut"), *whole = shape_called(sheet, "whole");
  ASSERT_TRUE(cut && whole);
  EXPECT_EQ(std::get<ImageShape>(cut->what).image, inner);
  EXPECT_TRUE(std::get<ImageShape>(cut->what).smooth);
  const Box a = extents_of(*cut), b = extents_of(*whole);
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
  EXPECT_NEAR(a.right(), b.right(), 1e-9);
  EXPECT_NEAR(a.bottom(), b.bottom(), 1e-9);
}

TEST(Layout, ALabelStaysOffAPicture) {
  const std::vector<Mark> named{{"dot", Role::current, Dot{{5, 4}}},
                                {"name", Role::current, Label{{5, 4}, "a name"}}};
  const auto place_in = [](const Sheet& sheet) { return extents_of(*shape_called(sheet, "name")); };
  const Box alone = place_in(sheet_of(pictured(named), 0));
  int moved = 0;
  const std::pair<dvec2, dvec2> rectangles[]{{{5.3, 1}, {11, 7}},  // right, left, above, below
                                             {{-0.4, 1}, {4.7, 7}},
                                             {{1, 4.3}, {9, 7}},
                                             {{1, 0}, {9, 3.7}}};
  for (const auto& [lower, upper] : rectangles) {
    std::vector<Mark> marks = named;
    marks.push_back({"picture", Role::result, Picture{lower, upper, eight_pixels()}});
    const Sheet sheet = sheet_of(pictured(std::move(marks)), 0);
    const Box text = place_in(sheet), picture = extents_of(*shape_called(sheet, "picture"));
    const bool apart = text.right() <= picture.x || picture.right() <= text.x || text.bottom() <= picture.y ||
                       picture.bottom() <= text.y;
    EXPECT_TRUE(apart) << "picture from " << lower.x << ", " << lower.y;
    moved += text.x != alone.x || text.y != alone.y;
  }
  EXPECT_GT(moved, 0) << "one of the four has its usual place";
}

// --- As JSON -----------------------------------------------------------------------------------------------

TEST(Json, APictureHasItsRectangleAndItsPixels) {
  using Json = nlohmann::json;
  const Json json =
      Json::parse(trace_json(pictured({{"p", Role::result, Picture{{0, 1}, {4, 3}, eight_pixels()}}})));
  const Json& mark = json["steps"][0]["set"][0];
  ASSERT_EQ(mark.size(), 8u);
  EXPECT_EQ(mark[2], "picture");
  EXPECT_EQ((Json{mark[3], mark[4], mark[5], mark[6]}), (Json{0.0, 1.0, 4.0, 3.0}));
  EXPECT_EQ(mark[7]["width"], 4);
  EXPECT_EQ(mark[7]["height"], 2);
  EXPECT_EQ(mark[7]["palette"].size(), 8u);
  EXPECT_EQ(mark[7]["palette"][5], Json::parse("[150, 0, 100, 255]"));
  EXPECT_EQ(mark[7]["indices"], "AAECAwQFBgc=");
}

TEST(Json, TellsOfPlanesColoursAndWholeGrids) {
  using Json = nlohmann::json;
  const Json json = Json::parse(trace_json(coloured(12, true)));
  EXPECT_EQ(json["grid"]["whole"], true);
  const Json& steps = json["steps"];
  EXPECT_FALSE(steps[0].contains("plane")) << "nothing is said of what does not change";
  EXPECT_EQ(steps[1]["plane"], true);
  EXPECT_EQ(steps[2]["plane"], false);
  EXPECT_NE(steps[0].dump().find("#ff8000"), std::string::npos) << steps[0];
  EXPECT_NE(steps[0].dump().find("#008080"), std::string::npos) << steps[0];
  EXPECT_EQ(Json::parse(trace_json(coloured(12, false)))["grid"].contains("whole"), false);
}

}  // namespace
}  // namespace gradus
