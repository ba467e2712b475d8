// The numbers that the pages of scan conversion claim, measured again.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/raster.hpp"
#include "scan_conversion/antialiased_line/antialiased_line.hpp"
#include "scan_conversion/antialiased_line/antialiased_line_notes.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "stress/scan_conversion/areas.hpp"
#include "support/documented.hpp"
#include "support/fill_pictures.hpp"

namespace gradus {
namespace {

using test::states;

constexpr const char* fill_page = "docs/topics/scan_conversion/flood_fill.md";
constexpr auto four = flood_fill::Connectivity::four;
using test::Canvas;

constexpr int side = 1024;

/// What fills of the largest area ask and remember; how many cells it has, by union-find.
struct Costs {
  double cells = 0;
  std::array<double, 3> entries{}, bytes_a_cell{}, questions_a_cell{};
};
Costs costs_of(const Canvas& canvas, std::optional<ivec2> seed = {}) {
  const auto is_free = [&](ivec2 p) { return canvas.contains(p) && canvas[p] == 0; };
  const auto areas = stress::areas_of(canvas.width(), canvas.height(), four, is_free);
  std::vector<int> sizes(areas.cells().size());
  for (const int area : areas.cells()) {
    if (area != stress::no_area) ++sizes[static_cast<std::size_t>(area)];
  }
  const auto largest = std::ranges::max_element(sizes);
  const int first = static_cast<int>(largest - sizes.begin());
  const ivec2 from = seed.value_or(ivec2{first % canvas.width(), first / canvas.width()});
  Costs costs{.cells = static_cast<double>(*largest)};
  constexpr flood_fill::Method methods[] = {flood_fill::Method::depth_first,
                                            flood_fill::Method::breadth_first, flood_fill::Method::span};
  constexpr double bytes[] = {12, 8, 16};
  for (std::size_t k = 0; k < 3; ++k) {
    Canvas painted = canvas;
    double asked = 0;
    const auto inside = [&](ivec2 p) {
      ++asked;
      return painted.contains(p) && painted[p] == 0;
    };
    const auto filled = flood_fill::fill(methods[k], from, inside, [&](ivec2 p) { painted[p] = 2; }, four);
    EXPECT_EQ(static_cast<double>(filled.painted), costs.cells);
    costs.entries[k] = static_cast<double>(filled.peak_waiting);
    costs.bytes_a_cell[k] = bytes[k] * costs.entries[k] / costs.cells;
    costs.questions_a_cell[k] = asked / costs.cells;
  }
  return costs;
}

TEST(DocumentedScanConversion, WhatFillsRemember) {
  const Costs empty = costs_of(Canvas(side, side), ivec2(side / 2)), of_maze = costs_of(test::maze(side)),
              of_noise = costs_of(test::noise(side)), of_comb = costs_of(test::comb(side));
  EXPECT_TRUE(states(
      fill_page, "| empty, seed in the middle ({}) | {} bytes per cell | {} ({} entries) | {} ({} entries) |",
      {empty.cells, empty.bytes_a_cell[0], empty.bytes_a_cell[1], empty.entries[1], empty.bytes_a_cell[2],
       empty.entries[2]}));
  const auto row = [](const char* text, const Costs& c) {
    return states(
        fill_page, text,
        {c.cells, c.bytes_a_cell[0], c.bytes_a_cell[1], c.entries[1], c.bytes_a_cell[2], c.entries[2]});
  };
  EXPECT_TRUE(row("| maze ({}) | {} | {} ({}) | {} ({}) |", of_maze));
  EXPECT_TRUE(row("| noise, 60 % free ({}) | {} | {} ({}) | {} ({}) |", of_noise));
  EXPECT_TRUE(row("| comb, teeth 1 wide ({}) | {} | {} ({}) | {} ({}) |", of_comb));
  EXPECT_TRUE(states(fill_page,
                     "Questions asked a painted cell: {} (8) for depth and breadth first; for span {} on the "
                     "empty canvas, {} "
                     "in the maze, {} on noise, {} in the comb,",
                     {of_maze.questions_a_cell[0], empty.questions_a_cell[2], of_maze.questions_a_cell[2],
                      of_noise.questions_a_cell[2], of_comb.questions_a_cell[2]}));
  for (const Costs& c : {empty, of_maze, of_noise, of_comb})
    EXPECT_LE(std::ranges::max(c.questions_a_cell), 4.01);
}

TEST(DocumentedScanConversion, PixelsOfCircles) {
  const int radius = 100'000;
  double columns = 0, pixels = 0;
  // By the definition: the nearest pixel of each column of an octant, x <= y
  for (int x = 0; x <= std::lround(std::sqrt(double(radius) * radius - double(x) * x)); ++x) ++columns;
  bresenham_circle::decision_parameter({0, 0}, radius, [&](ivec2) { ++pixels; });
  EXPECT_TRUE(states("docs/topics/scan_conversion/bresenham_circle.md",
                     "An octant has about {} r columns, the circle about {} r pixels;",
                     {columns / radius, pixels / radius}));
}

TEST(DocumentedScanConversion, InkOfADiagonal) {
  const auto ink = [](ivec2 to) {
    double sum = 0;
    antialiased_line::wu({0, 0}, to, [&](ivec2, int intensity) { sum += intensity; });
    return sum / 255 / std::sqrt(double(to.x) * to.x + double(to.y) * to.y);
  };
  EXPECT_TRUE(states("docs/topics/scan_conversion/antialiased_line.md",
                     "so a diagonal has {} of a level line's ink for its length.",
                     {ink({5000, 5000}) / ink({5000, 0})}));
}

/// The most pixels that a line has in a column, whatever its slope, and the ink of a diagonal for its length,
/// beside a level line's.
struct Ink {
  double most_in_a_column = 0, of_a_diagonal = 0;
};
template <class Draw>
Ink ink_of(Draw draw) {
  const auto amount = [&](ivec2 to) {
    double sum = 0;
    draw(ivec2{0, 0}, to, [&](ivec2, double intensity) { sum += intensity; });
    return sum / std::sqrt(double(to.x) * to.x + double(to.y) * to.y);
  };
  Ink ink{0, amount({5000, 5000}) / amount({5000, 0})};
  for (int y = 0; y <= 300; ++y) {
    std::array<int, 302> pixels{};
    draw(ivec2{0, 0}, ivec2{300, y}, [&](ivec2 p, double) {
      if (0 < p.x && p.x < 300) ++pixels[static_cast<std::size_t>(p.x)];
    });
    ink.most_in_a_column = std::max<double>(ink.most_in_a_column, *std::ranges::max_element(pixels));
  }
  return ink;
}

TEST(DocumentedScanConversion, PixelsAColumnAndInk) {
  using namespace antialiased_line;
  constexpr const char* page = "docs/topics/scan_conversion/antialiased_line.md";
  const Ink by_column = ink_of([](ivec2 a, ivec2 b, auto plot) { wu(a, b, plot); }),
            by_cone = ink_of([](ivec2 a, ivec2 b, auto plot) { gupta_sproull(a, b, plot); }),
            by_area = ink_of([](ivec2 a, ivec2 b, auto plot) { exact_area(a, b, plot); }),
            faulty = ink_of([](ivec2 a, ivec2 b, auto plot) { distance_along_column(a, b, plot); });
  EXPECT_TRUE(
      states(page, "| `wu` (taught) | {} | {} |", {by_column.most_in_a_column, by_column.of_a_diagonal}));
  EXPECT_TRUE(
      states(page, "| `gupta_sproull` | up to {} | {} |", {by_cone.most_in_a_column, by_cone.of_a_diagonal}));
  EXPECT_TRUE(
      states(page, "| `exact_area` | up to {} | {} |", {by_area.most_in_a_column, by_area.of_a_diagonal}));
  EXPECT_TRUE(states(page, "| `distance_along_column` (faulty) | up to {} | too little |",
                     {faulty.most_in_a_column}));
  EXPECT_LT(faulty.of_a_diagonal, 0.9);
}

}  // namespace
}  // namespace gradus
