// Pages for print: every step once, in order, legible on paper, nothing over anything else.

#include "figure/handout.hpp"

#include <gtest/gtest.h>

#include <map>

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
using test::overlap;
using test::shared_traces;
using test::texts_of;

constexpr double seven_points = 7.0 * 4 / 3;

/// The pages of a trace's milestones, the first `most` of them.
struct Pages {
  Handout handout;
  const Trace& trace;
  Playhead playhead;
  std::vector<StepNumber> steps;
  std::vector<std::size_t> asked;  ///< figures, in the order in which they were asked for

  Pages(const Trace& run, Handout wanted, std::size_t most = 30)
      : handout(std::move(wanted)), trace(run), playhead(run) {
    for (const TraceStep& step : trace.steps) {
      if (step.number.fine == 0 && steps.size() < most) steps.push_back(step.number);
    }
  }
  std::size_t count() const { return handout_page_count(handout, steps.size()); }
  Sheet page(std::size_t number) {
    return handout_page(handout, number, steps.size(), [this](std::size_t i) {
      asked.push_back(i);
      return figure_of(trace, playhead, steps.at(i));
    });
  }
};

Handout handout_of(std::string_view paper, int columns, int rows) {
  Handout handout;
  handout.paper = *find_paper(paper);
  handout.grid = {columns, rows};
  handout.source = "gradus figure";
  return handout;
}

/// Calls f(pages, sheet, number) for the first two pages of every grid, paper and telling trace.
template <class F>
std::size_t for_each_page(F f) {
  std::size_t count = 0, looked_at = 0;
  for (const std::string_view paper : {"a4", "letter"}) {
    for (int columns = 1; columns <= PageGrid::most_columns; ++columns) {
      for (int rows = 1; rows <= PageGrid::most_rows; ++rows) {
        for (const Trace& trace : test::shared_traces()) {
          const std::size_t next = looked_at++;
          if (test::sanitized ? next % 23 != 0 : !test::in_share(next, 7))
            continue;  // prime to the number of grids
          SCOPED_TRACE(fmt::format("{} {}x{}: {} {} {}", paper, columns, rows, trace.topic, trace.method,
                                   trace.subtitle));
          Pages pages(trace, handout_of(paper, columns, rows), 8);
          for (std::size_t i = 0; i < std::min<std::size_t>(2, pages.count()); ++i, ++count) {
            f(pages, pages.page(i), i);
          }
        }
      }
    }
  }
  return count;
}

TEST(Handout, CountsItsPages) {
  EXPECT_EQ(handout_page_count(handout_of("a4", 2, 3), 0), 1u);
  EXPECT_EQ(handout_page_count(handout_of("a4", 2, 3), 6), 1u);
  EXPECT_EQ(handout_page_count(handout_of("a4", 2, 3), 7), 2u);
  EXPECT_EQ(handout_page_count(handout_of("a4", 4, 6), 49), 3u);
}

TEST(Handout, PapersHaveTheirSizes) {
  ASSERT_EQ(papers().size(), 2u);
  EXPECT_NEAR(find_paper("a4")->width * 25.4 / 96, 210, 1e-9);
  EXPECT_NEAR(find_paper("a4")->height * 25.4 / 96, 297, 1e-9);
  EXPECT_EQ(find_paper("letter")->width / 96, 8.5);
  EXPECT_EQ(find_paper("letter")->height / 96, 11);
  EXPECT_EQ(find_paper("a5"), nullptr);
}

TEST(Handout, RefusesGridsThatCannotBeRead) {
  for (const auto& [columns, rows] : {std::pair{0, 3}, {2, 0}, {5, 3}, {2, 7}, {-1, 1}}) {
    EXPECT_THROW(handout_page_count(handout_of("a4", columns, rows), 4), std::invalid_argument);
  }
}

TEST(Handout, ShowsEveryStepOnceAndInOrder) {
  const Trace trace = test::trace_of("flood_fill");
  Pages pages(trace, handout_of("a4", 2, 3));
  std::vector<std::string> shown, expected;
  for (const StepNumber step : pages.steps) {
    expected.push_back(figure_of(trace, pages.playhead, step).position);
  }
  for (std::size_t i = 0; i < pages.count(); ++i) {
    const Sheet sheet = pages.page(i);
    for (const Shape& shape : sheet.shapes) {
      if (!shape.id.ends_with(" position")) continue;
      const std::string& text = std::get<TextShape>(shape.what).text;
      shown.push_back(text.substr(0, text.find(" · ")));
    }
    EXPECT_EQ(find_text(sheet, "page")->text, fmt::format("page {} of {}", i + 1, pages.count()));
    EXPECT_EQ(find_text(sheet, "title")->text, trace.title);
    EXPECT_EQ(find_text(sheet, "source")->text, "gradus figure");
  }
  EXPECT_EQ(shown, expected);
  ASSERT_EQ(pages.asked.size(), pages.steps.size());
  for (std::size_t i = 0; i < pages.asked.size(); ++i) EXPECT_EQ(pages.asked[i], i);
}

TEST(Handout, TwoByThreeIsTwoColumnsOfThree) {
  const Trace trace = test::trace_of("bresenham_line");
  Pages pages(trace, handout_of("a4", 2, 3));
  std::set<double> lefts, tops;
  const Sheet sheet = pages.page(0);
  for (const Shape& shape : sheet.shapes) {
    if (!shape.id.ends_with(" box")) continue;
    lefts.insert(extent_of(shape).x);
    tops.insert(extent_of(shape).y);
  }
  EXPECT_EQ(lefts.size(), 2u);
  EXPECT_EQ(tops.size(), 3u);
}

void nothing_is_smaller_than_seven_points(const Sheet& sheet) {
  for (const TextShape* text : texts_of(sheet)) {
    EXPECT_GE(text->size, seven_points * (1 - 1e-12)) << text->text;
  }
}

/// What belongs to a step lies in its box or, the caption, beneath it.
void nothing_leaves_its_box(const Sheet& sheet) {
  std::map<std::string, Box> boxes;
  for (const Shape& shape : sheet.shapes) {
    if (shape.id.ends_with(" box")) boxes[shape.id.substr(0, shape.id.size() - 4)] = extent_of(shape);
  }
  EXPECT_FALSE(boxes.empty());
  for (const Shape& shape : sheet.shapes) {
    const Box part = extent_of(shape);
    EXPECT_TRUE(part.x >= 40 && part.y >= 40 && part.right() <= sheet.width - 40 &&
                part.bottom() <= sheet.height - 40)
        << shape.id;
    if (!shape.id.starts_with("step ") || shape.slot == Slot::sentence) continue;
    const Box& box = boxes.at(shape.id.substr(0, shape.id.find(' ', 5)));
    EXPECT_TRUE(part.x >= box.x && part.y >= box.y && part.right() <= box.right() + 1e-9 &&
                part.bottom() <= box.bottom() + 1e-9)
        << shape.id;
  }
}

TEST(Handout, IsLegibleApartAndInItsBoxes) {
  // One walk for all laws, since laying out is what takes the time
  const std::size_t sheets = for_each_page([](const Pages&, const Sheet& sheet, std::size_t) {
    nothing_is_smaller_than_seven_points(sheet);
    test::expect_texts_apart(sheet);
    nothing_leaves_its_box(sheet);
  });
  EXPECT_GT(sheets, test::sanitized ? 2000 / 23 : test::share_of(2000, 7));
}

TEST(Handout, SmallGridsAreShownWholeInTheUsualBoxes) {
  for (const char* topic : {"bresenham_line", "flood_fill"}) {
    const Trace trace = test::trace_of(topic);
    for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 2}, {2, 2}, {2, 3}, {2, 4}, {3, 4}}) {
      Pages pages(trace, handout_of("a4", columns, rows));
      for (const Shape& shape : pages.page(0).shapes) {
        EXPECT_FALSE(shape.id.ends_with("overview frame")) << topic << " " << columns << "x" << rows;
      }
    }
  }
}

TEST(Handout, CaptionsFollowTheSlots) {
  const Trace trace = test::trace_of("bresenham_line");
  Handout handout = handout_of("a4", 2, 3);
  handout.look.slots = {Slot::drawing, Slot::sentence};
  std::set<Slot> seen;
  for (const Shape& shape : Pages(trace, handout).page(0).shapes) seen.insert(shape.slot);
  EXPECT_FALSE(seen.contains(Slot::listing));
  EXPECT_FALSE(seen.contains(Slot::table));
  handout.look.slots = {Slot::drawing};
  for (const Shape& shape : Pages(trace, handout).page(0).shapes) {
    EXPECT_EQ(shape.id.find(" sentence "), std::string::npos);
  }
}

TEST(Layout, AHandoutShowsMore) {
  // More lines and rows, more of the grid, or a larger drawing
  const auto drawing = [](const layout::Places& places, const Look& look) {
    return places.drawing.width * places.drawing.height * layout::unit_of(look) * layout::unit_of(look);
  };
  const auto cells_in_view = [](const Trace& trace, const Look& look) {
    const Window view = layout::visible_cells({.trace = &trace, .focus = trace.grid.cells.lower}, look);
    return view.width() * view.height();
  };
  for (const Case& aspect : aspects()) {
    SCOPED_TRACE(aspect.name);
    for (const Trace& trace : shared_traces()) {
      SCOPED_TRACE(trace.method + " " + trace.subtitle);
      const layout::Places slide =
          layout::places_of(trace, aspect.look, layout::stage_of(trace, aspect.look));
      Look look = aspect.look;
      look.layout = Layout::handout;
      const layout::Places handout = layout::places_of(trace, look, layout::stage_of(trace, look));
      const std::int64_t before = cells_in_view(trace, aspect.look), now = cells_in_view(trace, look);
      EXPECT_GE(now, before);
      const bool larger = drawing(handout, look) > drawing(slide, aspect.look);
      if (now == before && !larger) EXPECT_GE(handout.lines + handout.rows, slide.lines + slide.rows);
    }
  }
  // All lines of the listing on 16:9
  Look look;
  look.layout = Layout::handout;
  const Trace trace = test::trace_of("bresenham_line");
  const layout::Places at = layout::places_of(trace, look, layout::stage_of(trace, look));
  EXPECT_EQ(at.lines, static_cast<int>(trace.listing.size()));
}

}  // namespace
}  // namespace gradus
