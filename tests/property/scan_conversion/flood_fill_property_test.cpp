// Fills against a union-find of the picture, against each other, and against their own promises of time and
// memory.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "scan_conversion/flood_fill/flood_fill_batch.hpp"
#include "scan_conversion/flood_fill/flood_fill_notes.hpp"
#include "scan_conversion/flood_fill/maze.hpp"
#include "support/seed.hpp"

namespace gradus::flood_fill {
namespace {

constexpr Method methods[] = {Method::depth_first, Method::breadth_first, Method::span};
constexpr Connectivity connectivities[] = {Connectivity::four, Connectivity::eight};

using test::seed;

class Random {
 public:
  explicit Random(std::uint64_t offset) : random_(seed() + offset) {}
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }

 private:
  std::mt19937_64 random_;
};

Maze noise(int width, int height, int percent_free, Random& random) {
  Maze maze(width, height, wall);
  for (char& cell : maze.cells()) cell = random.below(100) < percent_free ? free_cell : wall;
  return maze;
}

/// A perfect maze: corridors one cell wide, no loops, every free cell reached from (1, 1).
Maze corridors(int width, int height, Random& random) {
  Maze maze(width | 1, height | 1, wall);
  std::vector<ivec2> path{{1, 1}};
  maze[{1, 1}] = free_cell;
  while (!path.empty()) {
    std::vector<ivec2> open;
    for (const ivec2 way : ways(Connectivity::four)) {
      const ivec2 next = path.back() + 2 * way;
      if (maze.contains(next) && maze[next] == wall) open.push_back(way);
    }
    if (open.empty()) {
      path.pop_back();
      continue;
    }
    const ivec2 way = open[static_cast<std::size_t>(random.below(static_cast<int>(open.size())))];
    maze[path.back() + way] = free_cell;
    maze[path.back() + 2 * way] = free_cell;
    path.push_back(path.back() + 2 * way);
  }
  return maze;
}

/// Teeth one cell wide on a back that joins them, the back in any of four places.
Maze comb(int width, int height, int side) {
  Maze maze(width, height, wall);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool upright = side < 2;
      const bool tooth = (upright ? x : y) % 2 == 0;
      const bool back = side == 0   ? y == 0
                        : side == 1 ? y == height - 1
                        : side == 2 ? x == 0
                                    : x == width - 1;
      if (tooth || back) maze[{x, y}] = free_cell;
    }
  }
  return maze;
}

Maze spiral(int size) {
  Maze maze(size, size, wall);
  ivec2 at{0, 0}, way{1, 0};
  const auto open = [&](ivec2 p) { return maze.contains(p) && maze[p] == wall; };
  for (;;) {
    maze[at] = free_cell;
    // Go on while the next two cells are wall; else turn; stop when neither way is open
    const auto free_ahead = [&](ivec2 w) {
      return open(at + w) && (!maze.contains(at + 2 * w) || maze[at + 2 * w] == wall);
    };
    if (!free_ahead(way)) {
      way = {-way.y, way.x};
      if (!free_ahead(way)) return maze;
    }
    at += way;
  }
}

/// Components by union-find: every cell's label is the smallest index of its component; walls are their own.
std::vector<int> components(const Maze& maze, Connectivity connectivity) {
  std::vector<int> parent(maze.cells().size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](int i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return i;
  };
  const auto index = [&](ivec2 p) { return p.y * maze.width() + p.x; };
  for (int y = 0; y < maze.height(); ++y) {
    for (int x = 0; x < maze.width(); ++x) {
      const ivec2 p{x, y};
      // The half of the neighbours that come before p
      for (const ivec2 way : {ivec2{-1, 0}, ivec2{0, -1}, ivec2{-1, -1}, ivec2{1, -1}}) {
        if (way.x != 0 && way.y != 0 && connectivity == Connectivity::four) continue;
        const ivec2 q = p + way;
        if (!maze.contains(q) || maze[p] != maze[q] || maze[p] == wall) continue;
        const int a = find(index(p)), b = find(index(q));
        parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      }
    }
  }
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = find(static_cast<int>(i));
  return parent;
}

/// A cell of the largest component, not always the same one. Domain: some cell is free.
ivec2 seed_in_largest(const Maze& maze, const std::vector<int>& label, Random& random) {
  std::map<int, int> size;
  for (std::size_t i = 0; i < label.size(); ++i) size[label[i]] += maze.cells()[i] != wall;
  const auto largest =
      std::max_element(size.begin(), size.end(), [](auto a, auto b) { return a.second < b.second; });
  std::vector<int> cells;
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (label[i] == largest->first) cells.push_back(static_cast<int>(i));
  }
  const int cell = cells[static_cast<std::size_t>(random.below(static_cast<int>(cells.size())))];
  return {cell % maze.width(), cell / maze.width()};
}

struct Tally {
  int cases = 0;
  std::int64_t painted = 0;
  double questions[2] = {0, 0};  // most a painted cell, by span, four- and eight-connected
};

/// Fills by every method, four- and eight-connected, and compares with the union-find.
void check_maze(const Maze& maze, Random& random, Tally& tally, const std::string& what) {
  for (const Connectivity connectivity : connectivities) {
    const auto label = components(maze, connectivity);
    const ivec2 from = seed_in_largest(maze, label, random);
    const int wanted = label[static_cast<std::size_t>(from.y * maze.width() + from.x)];
    Maze expected = maze;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < label.size(); ++i) {
      if (label[i] != wanted) continue;
      expected.cells()[i] = 'x';
      ++count;
    }
    for (const Method method : methods) {
      Maze filled = maze;
      std::int64_t questions = 0;
      const char old = maze[from];
      const auto inside = [&](ivec2 p) {
        ++questions;
        return filled.contains(p) && filled[p] == old;
      };
      const Filled done = fill(method, from, inside, [&](ivec2 p) { filled[p] = 'x'; }, connectivity);
      ASSERT_EQ(filled, expected) << what << ", seed " << seed() << ", from " << from.x << ',' << from.y
                                  << '\n'
                                  << maze_text(maze) << maze_text(filled);
      ASSERT_EQ(done.painted, count);
      if (method == Method::span) {
        ASSERT_LE(questions, count * static_cast<int>(connectivity) + 4) << what << '\n' << maze_text(maze);
        double& most = tally.questions[connectivity == Connectivity::eight];
        if (count > 1000) most = std::max(most, static_cast<double>(questions) / static_cast<double>(count));
      } else {
        ASSERT_EQ(questions, count * static_cast<int>(connectivity) + 1);
      }
      ASSERT_LE(done.peak_waiting, static_cast<std::size_t>(2 * count + 2));
      ++tally.cases;
      tally.painted += count;
    }
    Maze fast = maze;
    const Filled done = fill_rows(fast, from, 'x', connectivity);
    ASSERT_EQ(fast, expected) << what << ", seed " << seed() << '\n' << maze_text(maze) << maze_text(fast);
    ASSERT_EQ(done.painted, count);
    Maze labelled = maze;
    ASSERT_EQ(fill_by_labels(labelled, from, 'x', connectivity).painted, count);
    ASSERT_EQ(labelled, expected) << what << ", seed " << seed() << '\n'
                                  << maze_text(maze) << maze_text(labelled);
    ++tally.cases;
  }
}

TEST(FloodFillProperty, NoiseOfEveryDensity) {
  Random random(1);
  Tally tally;
  for (int i = 0; i < 1500; ++i) {
    const int width = 1 + random.below(24), height = 1 + random.below(24);
    Maze maze = noise(width, height, 20 + 5 * random.below(17), random);
    maze.cells()[static_cast<std::size_t>(random.below(width * height))] = free_cell;
    if (i % 5 == 0) {
      for (char& cell : maze.cells()) cell = cell == free_cell && random.below(3) == 0 ? 'q' : cell;
    }
    check_maze(maze, random, tally, "noise");
    if (HasFatalFailure()) return;
  }
  for (int i = 0; i < 12; ++i) {
    check_maze(noise(150, 140, 55 + 4 * (i % 8), random), random, tally, "large noise");
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(tally.cases, 8 * 1512);
  EXPECT_GT(tally.painted, 500000);
  std::cout << "span asks at most " << tally.questions[0] << " (" << tally.questions[1]
            << ") questions a cell\n";
  EXPECT_LT(tally.questions[0], 3.5);
  EXPECT_LT(tally.questions[1], 4.5);
}

TEST(FloodFillProperty, MazesCombsAndSpirals) {
  Random random(2);
  Tally tally;
  for (int i = 0; i < 40; ++i) {
    check_maze(corridors(3 + random.below(60), 3 + random.below(60), random), random, tally, "maze");
    check_maze(comb(1 + random.below(40), 1 + random.below(40), i % 4), random, tally, "comb");
    check_maze(spiral(1 + i), random, tally, "spiral");
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(tally.cases, 8 * 120);
  EXPECT_GT(tally.painted, 100000);
}

TEST(FloodFillProperty, EveryPictureOfTwelveCells) {
  // All 4096 pictures of 4 x 3 cells, from every free cell
  std::int64_t cases = 0;
  for (int bits = 0; bits < 4096; ++bits) {
    Maze maze(4, 3, wall);
    for (int i = 0; i < 12; ++i) {
      if ((bits >> i) & 1) maze.cells()[static_cast<std::size_t>(i)] = free_cell;
    }
    for (const Connectivity connectivity : connectivities) {
      const auto label = components(maze, connectivity);
      for (int i = 0; i < 12; ++i) {
        if (!((bits >> i) & 1)) continue;
        Maze expected = maze;
        for (std::size_t j = 0; j < 12; ++j) {
          if (label[j] == label[static_cast<std::size_t>(i)]) expected.cells()[j] = 'x';
        }
        for (const Method method : methods) {
          Maze filled = maze;
          fill_maze(filled, {i % 4, i / 4}, 'x', {.connectivity = connectivity, .method = method});
          ASSERT_EQ(filled, expected) << maze_text(maze) << maze_text(filled);
          ++cases;
        }
        Maze fast = maze;
        fill_rows(fast, {i % 4, i / 4}, 'x', connectivity);
        ASSERT_EQ(fast, expected) << maze_text(maze) << maze_text(fast);
        Maze labelled = maze;
        fill_by_labels(labelled, {i % 4, i / 4}, 'x', connectivity);
        ASSERT_EQ(labelled, expected) << maze_text(maze) << maze_text(labelled);
      }
    }
  }
  EXPECT_EQ(cases, 3 * 2 * 12 * 2048);
}

/// Watches a fill: each painted cell was inside, is painted once, and touches one that was painted before.
struct Watch {
  const Maze& before;
  Connectivity connectivity;
  Raster<char>& painted;
  std::int64_t& count;
  ivec2& start;

  bool touches(ivec2 p) const {
    for (const ivec2 way : ways(connectivity)) {
      if (painted.contains(p + way) && painted[p + way]) return true;
    }
    return p == start;
  }
  void paint(ivec2 p) const {
    ASSERT_TRUE(before.contains(p));
    EXPECT_EQ(before[p], free_cell);
    EXPECT_FALSE(painted[p]);
    painted[p] = 1;
    ++count;
  }
  void operator()(const Started& s) const { start = s.seed; }
  void operator()(const Painted& p) const {
    EXPECT_TRUE(touches(p.pixel));
    EXPECT_TRUE(p.pixel == start || painted[p.from]);
    paint(p.pixel);
  }
  void operator()(const SpanFilled& s) const {
    bool joined = false;
    for (int x = s.span.left; x <= s.span.right; ++x) joined = joined || touches({x, s.span.row});
    EXPECT_TRUE(joined);
    EXPECT_TRUE(s.found.y == s.span.row && s.span.left <= s.found.x && s.found.x <= s.span.right);
    for (int x = s.span.left; x <= s.span.right; ++x) paint({x, s.span.row});
    // Both ends are stopped
    for (const ivec2 end : {ivec2{s.span.left - 1, s.span.row}, ivec2{s.span.right + 1, s.span.row}}) {
      EXPECT_TRUE(!before.contains(end) || before[end] == wall || painted[end]);
    }
  }
  void operator()(const Examined& e) const {
    EXPECT_TRUE(painted[e.from]);
    const bool free = before.contains(e.pixel) && before[e.pixel] == free_cell && !painted[e.pixel];
    EXPECT_EQ(e.inside, free);
    const ivec2 d = e.pixel - e.from;
    EXPECT_TRUE(std::abs(d.x) <= 1 && std::abs(d.y) <= 1 && d != ivec2(0, 0));
    EXPECT_TRUE(connectivity == Connectivity::eight || std::abs(d.x) + std::abs(d.y) == 1);
  }
  void operator()(const SpanQueued& q) const { span(q.span); }
  void operator()(const SpanTaken& t) const { span(t.span); }
  void span(const Span& s) const {
    EXPECT_LE(s.left, s.right);
    for (int x = s.left; x <= s.right; ++x) EXPECT_TRUE((painted[{x, s.row}]));
  }
  void operator()(const Dequeued& d) const { EXPECT_TRUE(painted[d.pixel]); }
  void operator()(const Retreated& r) const { EXPECT_TRUE(painted[r.pixel]); }
  void operator()(const Finished& f) const { EXPECT_EQ(f.filled.painted, count); }
};

TEST(FloodFillProperty, EveryStepKeepsItsInvariants) {
  Random random(3);
  std::int64_t cells = 0;
  int cases = 0;
  for (int i = 0; i < 300; ++i) {
    Maze maze = i % 3 == 0 ? corridors(30, 20, random) : noise(30, 20, 40 + random.below(50), random);
    const ivec2 from{1 + 2 * random.below(14), 1 + 2 * random.below(9)};
    maze[from] = free_cell;
    for (const Connectivity connectivity : connectivities) {
      for (const Method method : methods) {
        Maze filled = maze;
        Raster<char> painted(maze.width(), maze.height());
        std::int64_t count = 0;
        ivec2 start{-9, -9};
        const Watch watch{maze, connectivity, painted, count, start};
        fill_maze(filled, from, 'x', {.connectivity = connectivity, .method = method}, watch);
        ASSERT_FALSE(HasFailure()) << seed() << " case " << i << '\n' << maze_text(maze);
        ASSERT_EQ(start, from);
        for (std::size_t j = 0; j < painted.cells().size(); ++j) {
          ASSERT_EQ(painted.cells()[j] == 1, filled.cells()[j] == 'x');
        }
        cells += count;
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 1800);
  EXPECT_GT(cells, 200000);
}

TEST(FloodFillProperty, AWindowIsTheFillOfTheCutPicture) {
  Random random(4);
  int cases = 0, differs = 0;
  for (int i = 0; i < 3000; ++i) {
    const Maze maze = i % 2 ? noise(30, 30, 45 + random.below(40), random) : corridors(30, 30, random);
    const auto corner = [&] { return ivec2{random.below(maze.width()), random.below(maze.height())}; };
    const ivec2 a = corner();
    const Window window = window_around(a, corner());
    const ivec2 from{window.lower.x + random.below(static_cast<int>(window.width())),
                     window.lower.y + random.below(static_cast<int>(window.height()))};
    const Method method = methods[i % 3];
    const Connectivity connectivity = connectivities[(i / 3) % 2];
    // The cut picture, filled whole
    Maze cut(static_cast<int>(window.width()), static_cast<int>(window.height()), wall);
    for (int y = 0; y < cut.height(); ++y) {
      for (int x = 0; x < cut.width(); ++x) cut[{x, y}] = maze[window.lower + ivec2{x, y}];
    }
    const Filled expected =
        fill_maze(cut, from - window.lower, 'x', {.connectivity = connectivity, .method = method});
    // The window of the picture
    Maze filled = maze;
    std::int64_t asked = 0;
    const auto inside = [&](ivec2 p) {
      EXPECT_TRUE(window.contains(p));
      ++asked;
      return filled[p] == free_cell;
    };
    const Filled done =
        in_window(method, from, window, inside, [&](ivec2 p) { filled[p] = 'x'; }, connectivity);
    ASSERT_EQ(done, expected) << seed() << " case " << i;
    ASSERT_LE(asked, 9 * window.width() * window.height());
    for (int y = 0; y < maze.height(); ++y) {
      for (int x = 0; x < maze.width(); ++x) {
        const ivec2 p{x, y};
        ASSERT_EQ(filled[p], window.contains(p) ? cut[p - window.lower] : maze[p]) << seed() << " case " << i;
      }
    }
    Maze whole = maze;
    differs +=
        fill_maze(whole, from, 'x', {.connectivity = connectivity, .method = method}).painted != done.painted;
    ++cases;
  }
  EXPECT_EQ(cases, 3000);
  EXPECT_GT(differs, 500);
}

TEST(FloodFillProperty, ImagesByToleranceAgainstBruteForce) {
  Random random(5);
  int cases = 0, masked = 0;
  for (int i = 0; i < 1500; ++i) {
    Image image(1 + random.below(12), 1 + random.below(12));
    const auto channel = [&] { return static_cast<std::uint8_t>(100 + random.below(12)); };
    const auto color = [&] {
      return Rgba8{channel(), channel(), 100, static_cast<std::uint8_t>(250 + random.below(3))};
    };
    for (Rgba8& pixel : image.cells()) pixel = color();
    const ivec2 from{random.below(image.width()), random.below(image.height())};
    const int tolerance = random.below(12);
    const Connectivity connectivity = connectivities[i % 2];
    const Rgba8 ink = i % 3 ? color() : Rgba8{0, 0, 0};
    // By definition, a maze of what is alike
    Maze region(image.width(), image.height(), wall);
    for (std::size_t j = 0; j < image.cells().size(); ++j) {
      if (alike(image.cells()[j], image[from], tolerance)) region.cells()[j] = free_cell;
    }
    const std::int64_t all = fill_maze(region, from, 'x', {.connectivity = connectivity}).painted;
    const bool nothing = tolerance == 0 && ink == image[from];
    for (const Method method : methods) {
      Image filled = image;
      const Filled done = fill_image(filled, from, ink, {tolerance, connectivity, method});
      ASSERT_EQ(done.painted, nothing ? 0 : all) << seed() << " case " << i;
      masked += done.mask_bytes > 0;
      for (std::size_t j = 0; j < image.cells().size(); ++j) {
        ASSERT_EQ(filled.cells()[j], region.cells()[j] == 'x' ? ink : image.cells()[j]);
      }
      ++cases;
    }
    const Image before = image;
    Image fast = image;
    ASSERT_EQ(fill_rows(fast, from, ink, connectivity).painted,
              fill_image(image, from, ink, {0, connectivity}).painted);
    ASSERT_EQ(fast, image);
    Image labelled = before;
    fill_by_labels(labelled, from, ink, connectivity);
    ASSERT_EQ(labelled, image);
  }
  EXPECT_EQ(cases, 4500);
  EXPECT_GT(masked, 500);
}

TEST(FloodFillProperty, WordsOfBytesAreThoseOfOtherCells) {
  // Bytes have a comparison of their own; every value, equal to some of the cells or to none
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> bytes(word_bits);
    std::vector<int> others(word_bits);
    const int values = 1 + random.below(4), first = random.below(256);
    for (std::size_t k = 0; k < word_bits; ++k) {
      bytes[k] = static_cast<std::uint8_t>(first + random.below(values));
      others[k] = bytes[k];
    }
    const auto value = static_cast<std::uint8_t>(first + random.below(values));
    Word right = 0;
    for (std::size_t k = 0; k < word_bits; ++k) right |= Word{bytes[k] == value} << k;
    const std::span<const std::uint8_t> few(bytes);
    const std::span<const int> some(others);
    ASSERT_EQ(equal_bits(few.first<word_bits>(), value), right) << seed() << " case " << i;
    ASSERT_EQ(equal_bits(some.first<word_bits>(), int{value}), right) << seed() << " case " << i;
    ASSERT_EQ(equal_bits(few.first(17), value), right & up_to(16)) << seed() << " case " << i;
  }
}

TEST(FloodFillProperty, LabelsOfWideRowsAreThoseOfSpans) {
  // Widths round whole words, where runs and their overlaps cross from one into the next
  Random random(7);
  int cases = 0;
  for (const int width : {1, 2, 63, 64, 65, 127, 128, 129, 200}) {
    for (int i = 0; i < 60; ++i) {
      const int height = 1 + random.below(6);
      const int free = 20 + random.below(80);
      Maze maze(width, height, wall);
      for (char& cell : maze.cells()) cell = random.below(100) < free ? free_cell : wall;
      const ivec2 from{random.below(width), random.below(height)};
      for (const Connectivity connectivity : {Connectivity::four, Connectivity::eight}) {
        Maze expected = maze, labelled = maze;
        const Filled right = fill_raster(expected, from, 'x', Method::span, connectivity);
        ASSERT_EQ(fill_by_labels(labelled, from, 'x', connectivity).painted, right.painted)
            << maze_text(maze);
        ASSERT_EQ(labelled, expected) << width << ", seed " << seed() << '\n' << maze_text(maze);
        Raster<std::uint8_t> bytes(width, height);
        std::ranges::copy(maze.cells(), bytes.cells().begin());
        fill_by_labels(bytes, from, std::uint8_t{'x'}, connectivity);
        ASSERT_TRUE(std::ranges::equal(bytes.cells(), expected.cells())) << width << ", seed " << seed();
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 9 * 60 * 2);
}

}  // namespace
}  // namespace gradus::flood_fill
