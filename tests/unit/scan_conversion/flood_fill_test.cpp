#include "scan_conversion/flood_fill/flood_fill.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/record.hpp"
#include "scan_conversion/flood_fill/flood_fill_batch.hpp"
#include "scan_conversion/flood_fill/flood_fill_notes.hpp"
#include "scan_conversion/flood_fill/maze.hpp"
#include "stress/scan_conversion/areas.hpp"
#include "support/sanitized.hpp"

namespace gradus::flood_fill {
namespace {

constexpr Method methods[] = {Method::depth_first, Method::breadth_first, Method::span};
constexpr Connectivity connectivities[] = {Connectivity::four, Connectivity::eight};
using AllSteps =
    Recorder<Started, Painted, Examined, Retreated, Dequeued, SpanFilled, SpanQueued, SpanTaken, Finished>;

Maze maze(std::string_view text) {
  auto parsed = parse_maze(text, "test");
  EXPECT_TRUE(std::holds_alternative<Maze>(parsed)) << text;
  return std::get<Maze>(parsed);
}

std::string error_of(std::string_view text) {
  const auto parsed = parse_maze(text, "m.txt");
  const auto* error = std::get_if<MazeError>(&parsed);
  return error ? error->what : "none";
}

TEST(FloodFill, FillsARoomThroughItsDoor) {
  for (const Method method : methods) {
    Maze m = maze(
        "#######\n"
        "#..#..#\n"
        "#.....#\n"
        "#..#..#\n"
        "#######\n");
    const Filled filled = fill_maze(m, {1, 1}, 'a', {.method = method});
    EXPECT_EQ(filled.painted, 13);
    EXPECT_EQ(maze_text(m),
              "#######\n"
              "#aa#aa#\n"
              "#aaaaa#\n"
              "#aa#aa#\n"
              "#######\n");
  }
}

TEST(FloodFill, CornersConnectOnlyWhenAskedTo) {
  for (const Method method : methods) {
    Maze four = maze("..##\n..##\n##..\n##..\n"), eight = four;
    EXPECT_EQ(fill_maze(four, {0, 0}, 'a', {.connectivity = Connectivity::four, .method = method}).painted,
              4);
    EXPECT_EQ(maze_text(four), "aa##\naa##\n##..\n##..\n");
    EXPECT_EQ(fill_maze(eight, {3, 3}, 'a', {.connectivity = Connectivity::eight, .method = method}).painted,
              8);
    EXPECT_EQ(maze_text(eight), "aa##\naa##\n##aa\n##aa\n");
  }
}

TEST(FloodFill, GoldenDepthsAndQueues) {
  // G001-16: order right, left, down, up
  struct Case {
    int side;
    ivec2 seed;
    std::size_t depth, queue;
  };
  for (const Case& c :
       {Case{64, {0, 0}, 4096, 64}, Case{512, {256, 256}, 131841, 1023}, Case{1000, {0, 0}, 1000000, 1000}}) {
    for (const Method method : methods) {
      Maze m(c.side, c.side, free_cell);
      const Filled filled = fill_maze(m, c.seed, 'a', {.method = method});
      EXPECT_EQ(filled.painted, std::int64_t{c.side} * c.side);
      const std::size_t expected = method == Method::depth_first     ? c.depth
                                   : method == Method::breadth_first ? c.queue
                                                                     : 2;
      EXPECT_EQ(filled.peak_waiting, expected) << c.side;
      const std::size_t entry = method == Method::depth_first ? 12 : method == Method::breadth_first ? 8 : 16;
      EXPECT_EQ(filled.peak_bytes, filled.peak_waiting * entry);
    }
  }
}

TEST(FloodFill, EveryPictureOfTwelveCells) {
  // All 4096 pictures of 4 x 3 cells, from every free cell; with a sanitizer one in eleven
  std::int64_t cases = 0;
  for (int bits = 0; bits < 4096; bits += test::sanitized ? 11 : 1) {
    Maze picture(4, 3, wall);
    for (int i = 0; i < 12; ++i) {
      if ((bits >> i) & 1) picture[{i % 4, i / 4}] = free_cell;
    }
    for (int i = 0; i < 24; ++i) {
      const Connectivity connectivity = connectivities[i / 12];
      const ivec2 seed{i % 4, i / 4 % 3};
      if (picture[seed] == wall) continue;
      const auto area =
          stress::area_of(4, 3, seed, connectivity, [&](ivec2 p) { return picture[p] != wall; });
      const auto judge = [&](auto fill) {
        Maze filled = picture;
        fill(filled);
        EXPECT_EQ(stress::wrong_cells(filled, picture, area, 'x'), 0)
            << maze_text(picture) << maze_text(filled);
        ++cases;
      };
      for (const Method method : methods)
        judge([&](Maze& m) { fill_maze(m, seed, 'x', {.connectivity = connectivity, .method = method}); });
      judge([&](Maze& m) { fill_rows(m, seed, 'x', connectivity); });
      judge([&](Maze& m) { fill_by_labels(m, seed, 'x', connectivity); });
      judge([&](Maze& m) { fill_area(m, seed, 'x', connectivity); });
    }
  }
  if (!test::sanitized) EXPECT_EQ(cases, 6 * 2 * 12 * 2048);
}

TEST(FloodFill, AnAreaOfFewRunsCostsNoLookAtTheWholeRaster) {
  // A room of ten cells in a raster of a million: what the method remembers tells which one it was
  Raster<std::uint8_t> raster(1000, 1000);
  for (int x = 499; x <= 510; ++x) raster[{x, 499}] = raster[{x, 501}] = 1;
  raster[{499, 500}] = raster[{510, 500}] = 1;
  const auto before = raster;
  const Filled room = fill_area(raster, {505, 500}, std::uint8_t{2});
  EXPECT_EQ(room.painted, 10);
  EXPECT_LT(room.peak_bytes, 100u);
  EXPECT_EQ(std::ranges::count(raster.cells(), 2), 10);

  // All around it, in long runs: by rows, and not a cell else
  raster = before;
  auto by_pixels = before;
  const Filled around = fill_area(raster, {0, 0}, std::uint8_t{2});
  EXPECT_EQ(around.painted, fill_raster(by_pixels, {0, 0}, std::uint8_t{2}).painted);
  EXPECT_EQ(raster, by_pixels);
  EXPECT_LT(around.peak_bytes, 100u);

  // In many short runs: by labels, a bit per cell at least
  raster = before;
  for (int y = 1; y < 498; ++y) {
    for (int x = y % 100; x < 1000; x += 100) raster[{x, y}] = 1;
  }
  by_pixels = raster;
  const Filled slanting = fill_area(raster, {0, 0}, std::uint8_t{2});
  EXPECT_EQ(slanting.painted, fill_raster(by_pixels, {0, 0}, std::uint8_t{2}).painted);
  EXPECT_EQ(raster, by_pixels);
  EXPECT_GT(slanting.peak_bytes, 1000u * 1000 / 8);
}

TEST(FloodFill, RunsAreFewUpToOnePer256Cells) {
  for (const int more : {0, 1}) {
    Raster<std::uint8_t> raster(64, 64, 1);
    const int runs = 64 * 64 / 256 + more;
    for (int y = 0; y < runs; ++y) raster[{10 + y % 2, y}] = raster[{11, y}] = 0;
    const Filled filled = fill_area(raster, {11, 3}, std::uint8_t{2});
    EXPECT_EQ(filled.painted, runs + (runs + 1) / 2);
    EXPECT_EQ(filled.peak_bytes > 64 * 64 / 8, more == 1) << filled.peak_bytes;
  }
}

TEST(FloodFill, StepsOfDepthFirst) {
  AllSteps seen;
  Maze m = maze("..\n#.\n");
  fill_maze(m, {0, 0}, 'a', {.method = Method::depth_first}, seen);
  std::string order;
  for (const auto& event : seen.events()) {
    if (std::get_if<Started>(&event.step)) order += 'S';
    if (std::get_if<Painted>(&event.step)) order += 'P';
    if (std::get_if<Examined>(&event.step)) order += 'e';
    if (std::get_if<Retreated>(&event.step)) order += 'r';
    if (std::get_if<Finished>(&event.step)) order += 'F';
  }
  // (0,0); right: (1,0); right, left no; down: (1,1), nowhere to go; up no; back at (0,0): left, down, up no
  EXPECT_EQ(order, "SPePeeePeeeerereeerF");
}

TEST(FloodFill, StepsOfBreadthFirst) {
  AllSteps seen;
  Maze m = maze("...\n.#.\n...\n");
  fill_maze(m, {0, 0}, 'a', {.method = Method::breadth_first}, seen);
  std::vector<ivec2> in, out;
  for (const Painted& p : all<Painted>(seen)) in.push_back(p.pixel);
  for (const Dequeued& d : all<Dequeued>(seen)) out.push_back(d.pixel);
  EXPECT_EQ(in, out);  // first in, first out
  EXPECT_EQ(in, (std::vector<ivec2>{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {0, 2}, {2, 1}, {1, 2}, {2, 2}}));
  EXPECT_EQ(all<Examined>(seen).size(), 4u * 8u);
}

TEST(FloodFill, BreadthFirstWavesAreEqualManhattanDistances) {
  AllSteps seen;
  Raster<char> canvas(31, 23, '.');
  const ivec2 seed{12, 9};
  fill_raster(canvas, seed, 'a', Method::breadth_first, Connectivity::four, seen);
  int before = 0;
  std::size_t painted = 0;
  for (const Painted& step : all<Painted>(seen)) {
    const int distance = std::abs(step.pixel.x - seed.x) + std::abs(step.pixel.y - seed.y);
    EXPECT_TRUE(distance == before || distance == before + 1) << step.pixel.x << "," << step.pixel.y;
    before = distance;
    ++painted;
  }
  EXPECT_EQ(painted, canvas.cells().size());
}

TEST(FloodFill, StepsOfSpan) {
  AllSteps seen;
  Maze m = maze("..#.\n.#..\n....\n");
  fill_maze(m, {0, 0}, 'a', {.method = Method::span}, seen);
  const auto filled = all<SpanFilled>(seen);
  ASSERT_EQ(filled.size(), 5u);
  const auto is = [](const Span& s, int row, int left, int right, int way) {
    return s.row == row && s.left == left && s.right == right && s.way == way;
  };
  EXPECT_TRUE(is(filled[0].span, 0, 0, 1, 1));
  EXPECT_TRUE(is(filled[1].span, 1, 0, 0, 1));
  EXPECT_TRUE(is(filled[2].span, 2, 0, 3, 1));
  EXPECT_TRUE(is(filled[3].span, 1, 2, 3, -1));  // back up where row 2 sticks out
  EXPECT_TRUE(is(filled[4].span, 0, 3, 3, -1));
}

TEST(FloodFill, ImageBySeedColourAndTolerance) {
  const Rgba8 sky{10, 20, 200}, nearly{12, 18, 203}, other{40, 20, 200}, red{255, 0, 0};
  for (const Method method : methods) {
    Image image(4, 2, sky);
    image[{2, 0}] = nearly;
    image[{2, 1}] = nearly;
    image[{3, 1}] = other;
    Image plain = image;
    EXPECT_EQ(fill_image(plain, {0, 0}, red, {.method = method}).painted, 4);
    EXPECT_EQ((plain[{2, 0}]), nearly);
    Image close = image;
    const Filled filled = fill_image(close, {0, 0}, red, {.tolerance = 3, .method = method});
    EXPECT_EQ(filled.painted, 7);
    EXPECT_EQ(filled.mask_bytes, 0u);
    EXPECT_EQ((close[{3, 0}]), red);
    EXPECT_EQ((close[{3, 1}]), other);
    // The new colour is itself within the tolerance: a mask keeps painted pixels apart
    Image same = image;
    const Filled masked = fill_image(same, {0, 0}, sky, {.tolerance = 3, .method = method});
    EXPECT_EQ(masked.painted, 7);
    EXPECT_EQ(masked.mask_bytes, 8u);
    EXPECT_EQ((same[{2, 1}]), sky);
    EXPECT_EQ((same[{3, 1}]), other);
    EXPECT_EQ(fill_image(same, {0, 0}, red, {.tolerance = 255, .method = method}).painted, 8);
    // The seed's own colour: nothing to do, nothing painted
    Image unchanged = image;
    EXPECT_EQ(fill_image(unchanged, {0, 0}, sky, {.method = method}).painted, 0);
    EXPECT_EQ(unchanged, image);
  }
  // Alpha counts as a channel
  Image clear(2, 1, Rgba8{0, 0, 0, 0});
  clear[{1, 0}] = Rgba8{0, 0, 0, 255};
  EXPECT_EQ(fill_image(clear, {0, 0}, red).painted, 1);
}

TEST(FloodFill, MistakesAreNamed) {
  Image image(4, 2), none;
  Maze m(2, 2, free_cell);
  const auto fill_outside = [&] { fill_image(image, {4, 0}, {}); };  // E001-08
  EXPECT_THAT(fill_outside,
              testing::ThrowsMessage<ContractViolation>(
                  "the seed 4,0 lies outside the image of 4 x 2 pixels (columns 0 to 3, rows 0 to "
                  "1)"));
  EXPECT_THROW(fill_maze(m, {0, 0}, '#'), ContractViolation);
  EXPECT_THROW(fill_maze(m, {2, 0}, 'a'), ContractViolation);
  EXPECT_THROW(fill_image(none, {0, 0}, {}), ContractViolation);
  const auto no = [](ivec2) { return false; };
  const auto nothing = [](ivec2) {};
  EXPECT_THROW(in_window(Method::span, {0, 0}, {{0, 0}, {INT32_MAX, 0}}, no, nothing), ContractViolation);
  EXPECT_NO_THROW(in_window(Method::span, {0, 0}, {{0, 0}, {INT32_MAX - 2, 0}}, no, nothing));
}

TEST(FloodFillMaze, ReadsTextAndGivesItBack) {
  const Maze m = maze("#.a\nZ.#\n");
  EXPECT_EQ(m.width(), 3);
  EXPECT_EQ(m.height(), 2);
  EXPECT_EQ((m[{2, 0}]), 'a');
  EXPECT_EQ((m[{0, 1}]), 'Z');
  EXPECT_EQ(maze_text(m), "#.a\nZ.#\n");
  EXPECT_EQ(maze("#.a\r\nZ.#\r\n"), m);
  EXPECT_EQ(maze("#.a\nZ.#"), m);
  EXPECT_EQ(maze("#.a\r\nZ.#\r"), m);
  EXPECT_EQ(maze(".").width(), 1);
}

TEST(FloodFillMaze, SaysWhatIsWrongAndWhere) {
  const std::string cells = "expected # (wall), . (free) or a letter (colour)";
  const std::pair<std::string, std::string> table[] = {
      {"", "1: found nothing, expected rows of # (wall), . (free) and letters (colours)"},
      {"...\n..\n", "2: found 2 cells, expected 3 as in the first line"},
      {"...\n....\n", "2: found 4 cells, expected 3 as in the first line"},
      {"..\n.5\n", "2: found '5' in column 1, " + cells},
      {". .", "1: found a space in column 1, " + cells},
      {".\t", "1: found a tab in column 1, " + cells},
      {".\xC3\xA4", "1: found the byte 195 in column 1, " + cells},
      {"..\n\n..\n", "2: found an empty line, expected a row of # . and letters"},
      {"..\n\n", "2: found an empty line, expected a row of # . and letters"}};
  for (const auto& [text, what] : table) EXPECT_EQ(error_of(text), "m.txt:" + what);
}

TEST(FloodFillNotes, RecursionIsDepthFirst) {
  for (const Connectivity connectivity : connectivities) {
    Maze a = maze("..#.b\n.#..b\n....#\n#.##.\n"), b = a;
    const auto inside = [&](ivec2 p) { return a.contains(p) && a[p] == free_cell; };
    Recorder<Started, Painted, Examined, Retreated, Returned> called;
    const Depth depth = recursive({0, 0}, inside, [&](ivec2 p) { a[p] = 'a'; }, connectivity, called);
    AllSteps stacked;
    const Filled filled =
        fill_maze(b, {0, 0}, 'a', {.connectivity = connectivity, .method = Method::depth_first}, stacked);
    EXPECT_EQ(a, b);
    EXPECT_EQ(depth.painted, filled.painted);
    EXPECT_EQ(depth.peak, static_cast<std::int64_t>(filled.peak_waiting));
    const auto p = all<Painted>(called), q = all<Painted>(stacked);
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      EXPECT_EQ(p[i].pixel, q[i].pixel);
      EXPECT_EQ(p[i].waiting, q[i].waiting);
    }
    EXPECT_EQ(all<Retreated>(called).size(), p.size());
    const auto returned = all<Returned>(called);
    ASSERT_EQ(returned.size(), 1u);
    EXPECT_EQ(returned[0].depth.peak, depth.peak);
    EXPECT_EQ(returned[0].depth.now, 0);
  }
}

TEST(FloodFillNotes, AnEmptyCanvasOpensACallForEveryCell) {
  // G001-16 on 64 x 64: right, then always the first free neighbour, so the path is a snake through all cells
  for (const ivec2 size : {ivec2{1, 1}, ivec2{8, 8}, ivec2{5, 3}, ivec2{64, 64}}) {
    Raster<char> canvas(size.x, size.y, '.');
    const auto inside = [&](ivec2 p) { return canvas.contains(p) && canvas[p] == '.'; };
    const Depth depth = recursive({0, 0}, inside, [&](ivec2 p) { canvas[p] = 'x'; });
    EXPECT_EQ(depth.peak, std::int64_t{size.x} * size.y);
    EXPECT_EQ(depth.painted, depth.peak);
  }
  // A seed that is not inside opens none
  const Depth none = recursive({0, 0}, [](ivec2) { return false; }, [](ivec2) {});
  EXPECT_EQ(none.peak, 0);
  EXPECT_EQ(none.painted, 0);
}

TEST(FloodFillNotes, AnUncheckedSeedPaintsAnotherRow) {
  // E001-08: the picture as plain memory, row after row, says where a click lands
  const std::string memory = "...#....|.#.#.##.|.#.#.#..|...#....";
  const auto picture = [&] {
    return maze(std::string(memory).replace(8, 1, "\n").replace(17, 1, "\n").replace(26, 1, "\n"));
  };
  std::string cells = memory;
  std::erase(cells, '|');
  int outside_memory = 0, elsewhere = 0;
  for (int y = -2; y <= 5; ++y) {
    for (int x = -10; x <= 18; ++x) {
      const ivec2 seed{x, y};
      const int address = y * 8 + x;
      Maze wrong = picture();
      Recorder<SeedRead, Painted, Dequeued, Examined, Finished> seen;
      const auto done = unchecked_seed(wrong, seed, 'x', Connectivity::four, seen);
      const auto read = all<SeedRead>(seen);
      ASSERT_EQ(read.size(), 1u);
      EXPECT_EQ(read[0].index, address);
      if (address < 0 || address >= 32) {
        EXPECT_FALSE(done || read[0].lands);
        EXPECT_EQ(seen.events().size(), 1u);
        EXPECT_EQ(wrong, picture());
        ++outside_memory;
        continue;
      }
      ASSERT_TRUE(done && read[0].lands);
      const ivec2 lands = *read[0].lands;
      EXPECT_EQ(picture()[lands], cells[static_cast<std::size_t>(address)]);
      Maze right = picture();
      if (right.contains(seed)) {
        // In the picture it is the right fill, walls included
        EXPECT_EQ(lands, seed);
        const Filled filled = fill_raster(right, seed, 'x', Method::breadth_first);
        EXPECT_EQ(*done, filled);
      } else {
        // Outside: the cell of another row, and what is connected to the seed's neighbours in the picture
        EXPECT_NE(lands.y, seed.y);
        const char old = right[lands];
        right[lands] = 'x';
        for (const ivec2 way : ways(Connectivity::four)) {
          const ivec2 next = seed + way;
          if (right.contains(next) && right[next] == old) fill_raster(right, next, 'x');
        }
        ++elsewhere;
      }
      EXPECT_EQ(wrong, right) << x << "," << y;
    }
  }
  EXPECT_GT(outside_memory, 50);
  EXPECT_GT(elsewhere, 50);
  // The numbers of the errata
  Maze wrong = picture();
  EXPECT_EQ(unchecked_seed(wrong, {-1, 2}, 'x')->painted, 11);
  EXPECT_EQ(maze_text(wrong), "xxx#....\nx#x#.##x\nx#x#.#..\nxxx#....\n");
  EXPECT_THROW(fill_raster(wrong, {-1, 2}, 'x'), ContractViolation);
  EXPECT_THROW(unchecked_seed(wrong, {INT32_MAX, 0}, 'x'), ContractViolation);
}

}  // namespace
}  // namespace gradus::flood_fill
