// The drawing of a fill: what it remembers, in which order it paints, and what an image becomes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "figure/figure.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

/// The texts of the row of boxes above a maze, from the left.
std::vector<std::string> shelf(const Canvas& canvas) {
  std::vector<std::string> texts;
  for (const auto& [id, mark] : canvas.marks()) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (text && id.starts_with("shelf ")) texts.push_back(text->text);
  }
  return texts;
}
/// Their boxes, from the left, each with its own text in its middle.
std::vector<std::vector<dvec2>> boxes(const Canvas& canvas) {
  std::vector<std::vector<dvec2>> found;
  for (const auto& [id, mark] : canvas.marks()) {
    const Path* path = std::get_if<Path>(&mark.shape);
    if (!path || !id.starts_with("shelf ")) continue;
    const std::vector<dvec2>& ring = found.emplace_back(path->points);
    const auto text = canvas.marks().find(id + " text");
    EXPECT_TRUE(text != canvas.marks().end() &&
                std::get<Text>(text->second.shape).at == 0.5 * (ring[0] + ring[2]))
        << id;
  }
  return found;
}

/// What a method says waits, told alone: its entries after each step, the one that leaves next at `front`.
struct Waiting {
  std::deque<std::string> entries;
  bool queue;

  void follow(const TraceStep& step) {
    const auto pixel = [&] { return step.key; };
    if (step.type == "Painted") entries.push_back(pixel());
    if (step.type == "Dequeued") entries.pop_front();
    if (step.type == "Retreated") entries.pop_back();
  }
  /// Those that fit.
  std::vector<std::string> shown(std::size_t room) const {
    std::vector<std::string> out(entries.begin(), entries.end());
    if (out.size() <= room) return out;
    if (queue) {
      out.resize(room);
      out.back() = "…";
    } else {
      out.erase(out.begin(), out.end() - static_cast<std::ptrdiff_t>(room));
      out.front() = "…";
    }
    return out;
  }
};

TEST(FillStory, TheShelfHoldsWhatWaits) {
  for (const auto& [method, queue] :
       {std::pair{"depth_first", false}, {"breadth_first", true}, {"recursive", false}}) {
    SCOPED_TRACE(method);
    const Trace trace = test::trace_of("flood_fill", {{"method", method}});
    Waiting waiting{{}, queue};
    Playhead playhead(trace);
    const std::size_t room = static_cast<std::size_t>(trace.grid.cells.width() * 2 / 3);  // for "3,4"
    std::size_t most = 0;
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      waiting.follow(trace.steps[i]);
      const auto expected = waiting.shown(room);
      EXPECT_EQ(shelf(playhead.at(i)), expected) << i;
      const std::vector<std::vector<dvec2>> drawn = boxes(playhead.at(i));
      ASSERT_EQ(drawn.size(), expected.size()) << i;
      for (std::size_t k = 0; k < drawn.size(); ++k) {
        const dvec2 from = drawn[k][0], to = drawn[k][2];
        EXPECT_LE(to.x, trace.grid.cells.upper.x + 0.5);
        EXPECT_LE(to.y, trace.grid.cells.lower.y + 0.5);
        EXPECT_GT(from.x, k == 0 ? trace.grid.cells.lower.x - 0.5 : drawn[k - 1][2].x);
      }
      EXPECT_EQ(playhead.at(i).marks().contains("next out"), !expected.empty());
      most = std::max(most, waiting.entries.size());
    }
    EXPECT_GE(most, 3u);
    EXPECT_EQ(trace.grid.shelf, 2);
  }
}

TEST(FillStory, SpansThatWaitPointAtTheirRows) {
  const Trace trace = test::trace_of("flood_fill");
  Playhead playhead(trace);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    std::vector<std::string> rows;
    for (const auto& [id, mark] : playhead.at(i).marks()) {
      if (!id.starts_with("waiting span")) continue;
      rows.push_back(fmt::format("{}", std::lround(std::get<Stroke>(mark.shape).b.y)));
    }
    EXPECT_EQ(shelf(playhead.at(i)), rows) << i;
    seen += rows.size();
  }
  EXPECT_GT(seen, 20u);
}

TEST(FillStory, BreadthFirstNumbersAreDistances) {
  for (const char* connectivity : {"4", "8"}) {
    const Trace trace =
        test::trace_of("flood_fill", {{"method", "breadth_first"}, {"connectivity", connectivity}});
    Playhead playhead(trace);
    const Canvas& end = playhead.at(trace.steps.size() - 1);
    // Every painted cell is one more than its nearest neighbour; the seed is 0
    const auto number = [&](ivec2 p) {
      const auto look = end.at(p);
      return !look || look->text.empty() ? -1 : std::stoi(look->text);
    };
    for (const ivec2 p : trace.pixels) {
      int least = INT32_MAX;
      for (const ivec2 way : flood_fill::ways(flood_fill::Connectivity{std::stoi(connectivity)})) {
        if (const int n = number(p + way); n >= 0 && (p + way).y >= 0) least = std::min(least, n);
      }
      EXPECT_EQ(number(p), p == trace.pixels.front() ? 0 : least + 1) << p.x << "," << p.y;
    }
    EXPECT_GT(trace.pixels.size(), 20u);
  }
}

TEST(FillStory, DepthFirstNumbersAreTheOrder) {
  const Trace trace = test::trace_of("flood_fill", {{"method", "depth_first"}});
  Playhead playhead(trace);
  const Canvas& end = playhead.at(trace.steps.size() - 1);
  for (std::size_t i = 0; i < trace.pixels.size(); ++i) {
    EXPECT_EQ(end.at(trace.pixels[i])->text, fmt::format("{}", i + 1));
  }
}

TEST(FillStory, AnImageEndsAsItIsPainted) {
  const Trace trace =
      test::trace_of("flood_fill", {{"image", std::string(GRADUS_SOURCE_DIR) + "/examples/images/camera.png"},
                                    {"at", "300,60"},
                                    {"tolerance", "20"},
                                    {"paint", "#d55e00"}});
  const Rgba8 paint{0xd5, 0x5e, 0, 255};
  Playhead playhead(trace);
  const Canvas& end = playhead.at(trace.steps.size() - 1);
  std::int64_t painted = 0;
  for (ivec2 p{0, 0}; p.y < 512; ++p.y) {
    for (p.x = 0; p.x < 512; ++p.x) {
      const auto look = end.at(p);
      painted += look && look->color == paint;
    }
  }
  EXPECT_EQ(painted, std::get<std::int64_t>(trace.result.at(0).value));
  EXPECT_GT(painted, 70'000);
  const auto legend = std::ranges::find(trace.legend, Role::past, &LegendEntry::role);
  ASSERT_NE(legend, trace.legend.end());
  EXPECT_EQ(legend->color, paint);
}

TEST(FillStory, LargeMazesHaveNoShelf) {
  std::string rows;
  for (int y = 0; y < 30; ++y) rows += (y > 0 ? "/" : "") + std::string(30, '.');
  const Trace trace =
      test::trace_of("flood_fill", {{"maze", rows}, {"at", "0,0"}, {"method", "depth_first"}});
  EXPECT_EQ(trace.grid.shelf, 0);
  EXPECT_EQ(trace.grid.cells, (Window{{0, 0}, {29, 29}}));
}

}  // namespace
}  // namespace gradus
