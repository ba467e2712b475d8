// What a lecturer sees on any slide: legible from the last row, nothing overlaps, nothing is clipped, nothing
// jumps.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "cli/lecture/lecture.hpp"
#include "figure/figure.hpp"
#include "figure/layout/layout.hpp"
#include "support/aspects.hpp"
#include "support/sanitized.hpp"
#include "support/share.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

using test::aspects;
using test::Case;
using test::extent_of;
using test::find_text;
using test::for_each_sheet;
using test::overlap;
using test::shared_traces;
using test::shorter_side;
using test::slides;
using test::texts_of;

// --- The laws of every slide -----------------------------------------------------------------------

void no_text_is_smaller_than_legible(const Trace&, const Sheet& sheet, const Look& look) {
  const double full = shorter_side(look) * (look.layout == Layout::slide ? 1 : 0.7) * (1 - 1e-12);
  for (const Shape& shape : sheet.shapes) {
    const TextShape* text = std::get_if<TextShape>(&shape.what);
    if (!text) continue;
    EXPECT_GE(text->size, full / 36) << text->text;
    if (shape.slot == Slot::sentence) EXPECT_GE(text->size, full / 28);
  }
}

std::size_t cells_seen = 0;

void cells_of_a_slide_are_never_smaller_than_24_of_720(const Trace& trace, const Sheet& sheet,
                                                       const Look& look) {
  if (look.layout == Layout::handout) return;
  // A grid that is shown whole pays with smaller cells; two pictures on a square slide below a fault, with
  // more
  const bool below_fault = trace.grid.lines > 0 && look.width == look.height && !trace.faulty.empty();
  const double least = !trace.grid.whole ? 24 : below_fault ? 4.5 : 6;
  for (const Shape& shape : sheet.shapes) {
    const RectShape* rect = std::get_if<RectShape>(&shape.what);
    if (!rect || !shape.id.starts_with("cell ")) continue;
    ++cells_seen;
    EXPECT_GE(rect->box.width, least * shorter_side(look) / 720 * (1 - 1e-12));
  }
}

void no_two_texts_overlap(const Trace&, const Sheet& sheet, const Look&) {
  const auto texts = texts_of(sheet);
  const bool grid = std::ranges::any_of(sheet.shapes, [](const Shape& shape) { return shape.id == "grid"; });
  // A drawing alone has the numbers of its axes at least, and on a paper a name
  ASSERT_GT(texts.size(), grid ? 3u : 0u);
  test::expect_texts_apart(sheet);
}

void nothing_is_clipped(const Trace&, const Sheet& sheet, const Look&) {
  for (const Shape& shape : sheet.shapes) {
    const Box box = extent_of(shape);
    EXPECT_TRUE(box.x >= 0 && box.y >= 0 && box.right() <= sheet.width && box.bottom() <= sheet.height)
        << name_of(shape.slot) << " " << shape.id << " " << box.x << "," << box.y << " to " << box.right()
        << "," << box.bottom() << " of " << sheet.width << " x " << sheet.height;
    const TextShape* text = std::get_if<TextShape>(&shape.what);
    if (text) EXPECT_TRUE(missing_characters(text->text, text->face).empty()) << text->text;
  }
}

void slots_keep_apart(const Trace&, const Sheet& sheet, const Look&) {
  std::map<Slot, Box> extents;
  for (const Shape& shape : sheet.shapes) {
    const auto [at, added] = extents.emplace(shape.slot, extent_of(shape));
    if (!added) at->second = test::united(at->second, extent_of(shape));
  }
  for (const auto& [a, box_a] : extents) {
    for (const auto& [b, box_b] : extents) {
      if (a < b) EXPECT_FALSE(overlap(box_a, box_b)) << name_of(a) << " and " << name_of(b);
    }
  }
}

void every_slot_that_was_asked_for_is_there(const Trace&, const Sheet& sheet, const Look& look) {
  std::set<Slot> seen;
  for (const Shape& shape : sheet.shapes) seen.insert(shape.slot);
  EXPECT_EQ(seen, look.slots);
}

/// A cell's dot beside a word would be its punctuation.
void no_dot_stands_beside_a_text(const Trace&, const Sheet& sheet, const Look&) {
  std::vector<Box> texts;
  for (const Shape& shape : sheet.shapes) {
    const TextShape* text = std::get_if<TextShape>(&shape.what);
    if (text && shape.slot == Slot::drawing && !text->is_rim()) texts.push_back(text->box());
  }
  for (const Shape& shape : sheet.shapes) {
    if (shape.id != "centres") continue;
    for (const auto& [dot, end] : std::get<StrokesShape>(shape.what).segments) {
      for (const Box& text : texts) EXPECT_FALSE(overlap(text, {dot.x - 1, dot.y - 1, 2, 2}));
    }
  }
}

/// Of the numbers beside the rows none is missing between, before or behind those that stand there.
void numbers_of_rows_have_no_gap(const Trace& trace, const Sheet& sheet, const Look& look) {
  if (!trace.grid.axes || !look.slots.contains(Slot::drawing)) return;
  std::vector<int> numbers;
  for (const Shape& shape : sheet.shapes) {
    if (!shape.id.starts_with("y ")) continue;
    std::string number = shape.id.substr(2);
    if (number.starts_with("−")) number.replace(0, std::string("−").size(), "-");
    if (number.find_first_not_of("-0123456789") == std::string::npos) numbers.push_back(std::stoi(number));
  }
  if (numbers.size() < 3) return;
  std::ranges::sort(numbers);
  const int between = numbers[1] - numbers[0];
  for (std::size_t i = 1; i < numbers.size(); ++i) EXPECT_EQ(numbers[i] - numbers[i - 1], between);
  if (look.view || !trace.grid.whole || trace.grid.part) return;  // what is in view is not known here
  EXPECT_LT(numbers.front() - between, trace.grid.own().lower.y);
  EXPECT_GT(numbers.back() + between, trace.grid.own().upper.y);
}

/// Three lines of source and two rows, or all there are, however small the slide.
void listing_and_table_have_their_least(const Trace& trace, const Sheet& sheet, const Look& look) {
  std::size_t lines = 0;  // as they stand: a long one is broken under one number
  for (const Shape& shape : sheet.shapes)
    lines += shape.slot == Slot::listing && shape.id.starts_with("line ") ? 1u : 0u;
  if (look.slots.contains(Slot::listing)) EXPECT_GE(lines, std::min<std::size_t>(3, trace.listing.size()));
  if (!look.slots.contains(Slot::table)) return;
  const layout::Places at = layout::places_of(trace, look, layout::stage_of(trace, look));
  EXPECT_GE(at.rows, std::min<std::int64_t>(2, trace.last + 1));
}

/// One in so many looks per run: prime to the numbers of choices, layouts and crops, or a run would see one
/// kind alone.
constexpr std::size_t looks_shares = 7;

TEST(Layout, EverySlideIsLegibleApartAndWhole) {
  // One walk for all laws, since laying out is what takes the time: some steps of every telling trace
  const std::vector<std::pair<const char*, void (*)(const Trace&, const Sheet&, const Look&)>> laws{
      {"no text is smaller than legible", no_text_is_smaller_than_legible},
      {"cells of a slide are never smaller than 24 of 720",
       cells_of_a_slide_are_never_smaller_than_24_of_720},
      {"no two texts overlap", no_two_texts_overlap},
      {"nothing is clipped", nothing_is_clipped},
      {"slots keep apart", slots_keep_apart},
      {"every slot that was asked for is there", every_slot_that_was_asked_for_is_there},
      {"no dot stands beside a text", no_dot_stands_beside_a_text},
      {"numbers of rows have no gap", numbers_of_rows_have_no_gap},
      {"listing and table have their least", listing_and_table_have_their_least}};
  std::size_t sheets = 0, looks = 0;
  for (const Case& slide : slides()) {
    SCOPED_TRACE(slide.name);
    for (const bool crop : {false, true}) {
      if (!test::in_share(looks++, looks_shares)) continue;
      SCOPED_TRACE(crop ? "cropped" : "whole");
      Look look = slide.look;
      look.crop = crop;
      sheets += for_each_sheet(
          [&](const Trace& trace, const Sheet& sheet, std::size_t) {
            for (const auto& [name, law] : laws) {
              SCOPED_TRACE(name);
              law(trace, sheet, look);
            }
          },
          look, test::thinned(3, 3), 2, looks);
    }
  }
  EXPECT_GT(sheets, test::share_of(test::thinned(15000, 30), 2 * looks_shares));
  EXPECT_GT(cells_seen, test::share_of(test::thinned(10000, 20), 4 * looks_shares));
}

/// Whether a line ends within a formula or a point. A long formula goes on with a relation or a term.
bool is_broken(std::string_view line) {
  static const std::regex ends(R"(.*(^| )(=|≈|<|>|≤|≥|\+|−|·|×|÷|/|→)|.*\((−?[0-9.]+|[a-z])[,;])"),
      begins("(·|×|÷|/|→) .*");
  const std::string text(line);
  return std::regex_match(text, ends) || std::regex_match(text, begins);
}

TEST(Layout, AFormulaThatIsBrokenIsSeen) {
  for (const char* broken : {"up to leave ≈", "to (−0.5,", "· 2 = 4", "x = 2 +", "so p <", "to (x,"})
    EXPECT_TRUE(is_broken(broken)) << broken;
  for (const char* whole : {"up to", "≈ 0.765.", "to (1, 2),", "−2 is less", "(its colour,", "= 3"})
    EXPECT_FALSE(is_broken(whole)) << whole;
}

TEST(Layout, SentencesOfTheGalleryAreNotCutShortNorInFormulas) {
  std::size_t sentences = 0, next = 0;
  for (const cli::LectureFigure& figure : cli::read_lecture(cli::gallery_lecture()).figures) {
    if (test::sanitized ? next++ % 6 != 0 : !test::in_share(next++, 3)) continue;
    const Trace trace = figure.spec.topic->run(figure.spec.arguments, {});
    Playhead playhead(trace);
    for (const Case& aspect : aspects()) {
      SCOPED_TRACE(aspect.name);
      const std::size_t stride =
          std::max<std::size_t>(1, trace.steps.size() / test::thinned(test::share_of(40, 3), 13));
      for (std::size_t i = 0; i < trace.steps.size(); i += stride) {
        const Sheet sheet = lay_out(figure_of(trace, playhead, trace.steps[i].number), aspect.look);
        for (const Shape& shape : sheet.shapes) {
          const TextShape* text = std::get_if<TextShape>(&shape.what);
          if (!text || (shape.slot != Slot::sentence && shape.slot != Slot::title)) continue;
          ++sentences;
          EXPECT_EQ(text->text.find("…"), std::string::npos) << text->text;
          if (shape.slot == Slot::sentence) EXPECT_FALSE(is_broken(text->text)) << text->text;
        }
      }
    }
  }
  EXPECT_GT(sentences, test::share_of(test::thinned(2000, 40), 9));
}

/// How many lines are strong in the figure's listing. Each stands on its sheet.
std::size_t the_current_line_is_listed(const Figure& figure, const Sheet& sheet) {
  std::size_t listed = 0;
  for (const Figure::ListingLine& line : figure.listing) {
    if (line.emphasis != Emphasis::strong) continue;
    ++listed;
    EXPECT_NE(find_text(sheet, fmt::format("line {}", line.line.number)), nullptr);
  }
  return listed;
}

void texts_are_whole_and_apart(const Sheet& sheet) {
  for (const TextShape* text : texts_of(sheet)) {
    const Box box = text->box();
    EXPECT_TRUE(box.x >= 0 && box.y >= 0 && box.right() <= sheet.width && box.bottom() <= sheet.height)
        << text->text;
  }
  test::expect_texts_apart(sheet);
}

TEST(Layout, EveryStepIsWholeWithItsLineOnEveryAspect) {
  // All slots on: fewer slides than above, but all steps
  std::size_t sheets = 0, listed = 0, walk = 0;
  for (const Case& aspect : aspects()) {
    for (const Layout layout : {Layout::slide, Layout::handout}) {
      SCOPED_TRACE(aspect.name + (layout == Layout::slide ? "" : ", handout"));
      Look look = aspect.look;
      look.layout = layout;
      sheets += test::for_each_figure(
          [&](const Figure& figure) {
            const Sheet sheet = lay_out(figure, look);
            texts_are_whole_and_apart(sheet);
            listed += the_current_line_is_listed(figure, sheet);
          },
          test::sanitized ? 2 : 1'000'000, 9, walk++);
    }
  }
  EXPECT_GT(sheets, test::share_of(test::thinned(10000, 20), 9));
  EXPECT_GT(listed, test::share_of(test::thinned(10000, 20), 9));
}

// --- Still ---------------------------------------------------------------------------------------

/// What may not move from step to step: the panels and headings of the text slots and the frame of the cells;
/// the axes' numbers too while the view doesn't follow the step.
std::map<std::string, Box> fixed_parts(const Sheet& sheet, bool follows) {
  std::map<std::string, Box> parts;
  for (const Shape& shape : sheet.shapes) {
    const bool slots = shape.id == "panel" || shape.id == "heading ground" || shape.id == "bar" ||
                       shape.id == "title" || shape.id == "input" || shape.id == "method" ||
                       shape.id.starts_with("heading ");
    const bool axes =
        shape.slot == Slot::drawing && (shape.id.starts_with("x ") || shape.id.starts_with("y "));
    const bool grid = shape.id == "grid" || shape.id == "overview frame";
    if (slots || grid || (axes && !follows)) {
      parts[fmt::format("{} {}", name_of(shape.slot), shape.id)] = extent_of(shape);
    }
  }
  parts["sheet"] = {0, 0, sheet.width, sheet.height};
  return parts;
}

TEST(Layout, AxesAndSlotsStayPutOverAllSteps) {
  std::size_t compared = 0, looks = 0;
  for (const Case& slide : slides()) {
    for (const bool crop : {false, true}) {
      if (!test::in_share(looks++, looks_shares)) continue;
      SCOPED_TRACE(slide.name + (crop ? ", cropped" : ""));
      Look look = slide.look;
      look.crop = crop;
      std::size_t next = looks;
      for (const Trace& trace : shared_traces()) {
        if (!test::in_share(next++, 2)) continue;
        SCOPED_TRACE(trace.topic + " " + trace.method + " " + trace.subtitle);
        Playhead playhead(trace);
        std::map<std::string, Box> first;
        const std::size_t stride = std::max<std::size_t>(1, trace.steps.size() / test::thinned(5, 5));
        for (std::size_t i = 0; i < trace.steps.size(); i += stride) {
          const Figure figure = figure_of(trace, playhead, trace.steps[i].number);
          if (figure.canvas->plane()) continue;  // no axes
          const bool follows = !(layout::visible_cells(figure, look) == trace.grid.cells);
          const auto parts = fixed_parts(lay_out(figure, look), follows);
          if (first.empty()) first = parts;
          ASSERT_EQ(first.size(), parts.size());
          for (const auto& [id, box] : parts) {
            ++compared;
            const Box& was = first.at(id);
            EXPECT_TRUE(box.x == was.x && box.y == was.y && box.width == was.width &&
                        box.height == was.height)
                << id << " at step " << text_of(trace.steps[i].number);
          }
        }
      }
    }
  }
  EXPECT_GT(compared, test::share_of(test::thinned(100000, 20), 2 * looks_shares));
}

TEST(Layout, AViewThatFollowsLeavesTheShelfAway) {
  std::string maze(14, '.');
  for (int row = 1; row < 7; ++row) maze += "/" + std::string(14, '.');
  const Trace trace = test::trace_of("flood_fill", {{"method", "recursive"}, {"maze", maze}});
  ASSERT_GT(trace.grid.shelf, 0);
  const Look look{.width = 720, .height = 720};
  Playhead playhead(trace);
  std::size_t followed = 0;
  for (const TraceStep& step : trace.steps) {
    const Figure figure = figure_of(trace, playhead, step.number);
    const Window view = layout::visible_cells(figure, look);
    ASSERT_NE(view, trace.grid.cells) << "this size shows all of it: choose a smaller one";
    EXPECT_EQ(view, intersection(view, trace.grid.own())) << text_of(step.number);
    for (const Shape& shape : lay_out(figure, look).shapes) {
      if (shape.id == "overview size" && std::get<TextShape>(shape.what).text.ends_with("14 × 7")) ++followed;
    }
  }
  EXPECT_EQ(followed, trace.steps.size());
}

TEST(Layout, TheIdealLinesNameStaysPut) {
  for (const Case& aspect : aspects()) {
    SCOPED_TRACE(aspect.name);
    const Trace trace = test::trace_of("bresenham_line");
    Playhead playhead(trace);
    std::optional<Box> first;
    for (const TraceStep& step : trace.steps) {
      const Sheet sheet = lay_out(figure_of(trace, playhead, step.number), aspect.look);
      const TextShape* name = find_text(sheet, "ideal line name");
      ASSERT_NE(name, nullptr);
      if (!first) first = name->box();
      EXPECT_EQ(first->x, name->box().x);
      EXPECT_EQ(first->y, name->box().y);
    }
  }
}

TEST(Layout, ScalesWithTheSize) {
  const Trace trace = test::trace_of("bresenham_line");
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4, 0});
  for (const Case& aspect : aspects()) {
    SCOPED_TRACE(aspect.name);
    const Sheet small = lay_out(figure, aspect.look);
    Look look = aspect.look;
    look.width *= 2;
    look.height *= 2;
    const Sheet large = lay_out(figure, look);
    ASSERT_EQ(small.shapes.size(), large.shapes.size());
    EXPECT_DOUBLE_EQ(2 * small.unit, large.unit);
    const auto a = texts_of(small), b = texts_of(large);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(2 * a[i]->baseline.x, b[i]->baseline.x, 1e-9);
  }
}

TEST(Layout, TheCurrentCellIsInView) {
  std::size_t followed = 0, looks = 0;
  for (const Case& slide : slides()) {
    if (!slide.look.slots.contains(Slot::drawing) || !test::in_share(looks++, looks_shares)) continue;
    SCOPED_TRACE(slide.name);
    for (const Trace& trace : shared_traces()) {
      if (!trace.grid.axes) continue;  // a paper has no cells to follow
      SCOPED_TRACE(fmt::format("{} {} {}", trace.topic, trace.method, trace.subtitle));
      for (const TraceStep& step : trace.steps) {
        if (!trace.grid.cells.contains(step.focus)) continue;
        const Figure figure{.trace = &trace, .focus = step.focus};
        const Window view = layout::visible_cells(figure, slide.look);
        EXPECT_TRUE(view.contains(step.focus)) << step.focus.x << "," << step.focus.y;
        followed += view == trace.grid.cells ? 0u : 1u;
      }
    }
  }
  EXPECT_GT(followed, test::share_of(test::thinned(1000, 20), looks_shares));
}

// --- Arranged ------------------------------------------------------------------------------------

enum class Side { left, right, above, below, other };
Side side_of(const Box& a, const Box& of) {
  if (a.right() <= of.x) return Side::left;
  if (a.x >= of.right()) return Side::right;
  if (a.bottom() <= of.y) return Side::above;
  return a.y >= of.bottom() ? Side::below : Side::other;
}

TEST(Layout, EachAspectHasAnArrangementOfItsOwn) {
  const Trace line = test::trace_of("bresenham_line"), fill = test::trace_of("flood_fill");
  const auto sides = [](const Trace& trace, double width, double height) {
    Look look;
    look.width = width;
    look.height = height;
    const layout::Places at = layout::places_of(trace, look, layout::stage_of(trace, look));
    return std::pair{side_of(at.listing, at.drawing), side_of(at.table, at.drawing)};
  };
  EXPECT_EQ(sides(line, 1280, 720), (std::pair{Side::right, Side::right}));
  EXPECT_EQ(sides(fill, 1280, 720), (std::pair{Side::right, Side::right}));
  EXPECT_EQ(sides(line, 960, 720), (std::pair{Side::below, Side::right}));
  EXPECT_EQ(sides(fill, 960, 720), (std::pair{Side::below, Side::right}));
  EXPECT_EQ(sides(line, 720, 720), (std::pair{Side::below, Side::below}));
  EXPECT_EQ(sides(fill, 720, 960), (std::pair{Side::below, Side::below}));
}

// --- Titles --------------------------------------------------------------------------------------

TEST(Layout, ATitleOfOnesOwnReplacesTheTopics) {
  Look look;
  look.title = "Which pixel is next?";
  for_each_sheet([&](const Trace&, const Sheet& sheet,
                     std::size_t) { EXPECT_EQ(find_text(sheet, "title")->text, look.title); },
                 look, 2);
}

TEST(Layout, ALongTitleIsBrokenThenShortened) {
  for (const Case& aspect : aspects()) {
    if (aspect.name != "16:9" && aspect.name != "3:4" && (test::sanitized || !test::whole_run())) continue;
    SCOPED_TRACE(aspect.name);
    for (const int words : {8, 40}) {
      Look look = aspect.look;
      look.title = "Pixels";
      for (int i = 0; i < words; ++i) look.title += " in a row";
      std::size_t sheets = 0;
      for_each_sheet(
          [&](const Trace&, const Sheet& sheet, std::size_t) {
            ++sheets;
            for (const TextShape* text : texts_of(sheet)) {
              EXPECT_LE(text->box().right(), sheet.width) << text->text;
            }
            test::expect_texts_apart(sheet);
            const TextShape* second = find_text(sheet, "title 2");
            if (words == 40 && aspect.name != "32:9") {
              ASSERT_NE(second, nullptr);
              EXPECT_NE(second->text.find("…"), std::string::npos);
            }
          },
          look, 1);
      EXPECT_GT(sheets, 20u);
    }
  }
}

// --- Roles ---------------------------------------------------------------------------------------

TEST(Shapes, KnowTheirRole) {
  std::size_t cells = 0;
  for_each_sheet(
      [&](const Trace&, const Sheet& sheet, std::size_t) {
        for (const Shape& shape : sheet.shapes) {
          const std::optional<Role> role = role_of(shape);
          if (shape.slot == Slot::drawing &&
              (shape.id.starts_with("cell ") || shape.id.starts_with("outline "))) {
            ++cells;
            EXPECT_TRUE(role.has_value()) << shape.id;
          }
          // Texts may be coloured by what they are values of
          const bool furniture =
              shape.slot == Slot::table || shape.slot == Slot::listing || shape.slot == Slot::sentence;
          if (shape.id == "grid" || (furniture && !std::holds_alternative<TextShape>(shape.what))) {
            EXPECT_FALSE(role.has_value()) << shape.id;
          }
        }
      },
      {}, 6);
  EXPECT_GT(cells, test::thinned(500, 4));
  EXPECT_EQ(
      role_of({Slot::drawing, "", DiscShape{{0, 0}, 1, Paint::of(Tone::paper), Paint::mark(Role::input)}}),
      Role::input);
  EXPECT_EQ(role_of({Slot::drawing, "",
                     TextShape{{0, 0}, "a", Face::sans, 20, Align::left, Paint::on(Role::past)}}),
            Role::past);
}

}  // namespace
}  // namespace gradus
