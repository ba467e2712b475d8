// Each artefact of too few samples, measured on its pattern against what theory says.

#include "antialiasing/sampling_theorem/test_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/random.hpp"

namespace gradus::sampling_theorem {
namespace {

/// Pixels, row by row.
struct Picture {
  ivec2 size;
  std::vector<double> pixels;

  double at(int x, int y) const { return pixels[static_cast<std::size_t>(y * size.x + x)]; }
};

template <class Pattern>
Picture picture(const Pattern& pattern, ivec2 size, int n = 1) {
  Picture done{size, {}};
  picture_of(pattern, size, n, [&](ivec2, double value) { done.pixels.push_back(value); });
  return done;
}

/// How many pieces of black pixels there are; pixels that touch at a side hang together.
int fragments_of(const Picture& p) {
  std::vector<bool> seen(p.pixels.size(), false);
  int pieces = 0;
  for (std::size_t i = 0; i < p.pixels.size(); ++i) {
    if (seen[i] || p.pixels[i] > 0) continue;
    ++pieces;
    std::vector<std::size_t> open{i};
    seen[i] = true;
    while (!open.empty()) {
      const std::size_t here = open.back(), columns = static_cast<std::size_t>(p.size.x);
      open.pop_back();
      const auto visit = [&](bool inside, std::size_t next) {
        if (!inside || seen[next] || p.pixels[next] > 0) return;
        seen[next] = true;
        open.push_back(next);
      };
      visit(here % columns > 0, here - 1);
      visit(here % columns + 1 < columns, here + 1);
      visit(here >= columns, here - columns);
      visit(here + columns < p.pixels.size(), here + columns);
    }
  }
  return pieces;
}

TEST(TestPatterns, TheZonePlateHasCentresThatAreNotThere) {
  // 16 pixels from the centre the rings have one cycle per pixel: the samples there are those of the centre
  const ZonePlate plate{{24.5, 24.5}, 16};
  const Picture p = picture(plate, {49, 49});
  for (const ivec2 off : {ivec2{16, 0}, ivec2{-16, 0}, ivec2{0, 16}, ivec2{0, -16}, ivec2{16, 16}}) {
    for (int y = -8; y <= 8; ++y) {
      for (int x = -8; x <= 8; ++x)
        EXPECT_NEAR(p.at(24 + off.x + x, 24 + off.y + y), p.at(24 + x, 24 + y), 1e-12);
    }
  }
  EXPECT_EQ(plate.frequency({24.5 + 8, 24.5}), 0.5);
  EXPECT_EQ(alias_of(plate.frequency({24.5 + 16, 24.5}), 1.0), 0);
  // In the mean over pixels they are all but gone
  const Picture mean = picture(plate, {49, 49}, 16);
  EXPECT_NEAR(mean.at(24, 24), 1, 0.05);
  EXPECT_LT(std::abs(mean.at(40, 24) - 0.5), 0.05);
}

TEST(TestPatterns, AFinerPatternStillAliases) {
  // R001-160: n x n samples per pixel move the limit to n/2 cycles; n + 1/16 look like 1/16 again, at full
  // strength
  for (const int n : {1, 2, 4, 8}) {
    const Grating fine{{n + 1 / 16.0, 0}}, slow{{1 / 16.0, 0}};
    const Picture p = picture(fine, {32, 1}, n);
    double least = 1, most = 0;
    for (int x = 0; x < 32; ++x) {
      least = std::min(least, p.at(x, 0));
      most = std::max(most, p.at(x, 0));
      EXPECT_LT(std::abs(fine.mean({x, 0}) - 0.5), 0.03) << n;
    }
    EXPECT_GT(most - least, 0.95) << n;
    // Twice as many see it as what it is, grey: of two neighbours |cos(17 pi / 32)| / 2 < 0.05 is left
    for (const double grey : picture(fine, {32, 1}, 2 * n).pixels) EXPECT_NEAR(grey, 0.5, 0.05) << n;
    EXPECT_EQ(alias_of(fine.frequency.x / n, 1.0) * n, slow.frequency.x) << n;
  }
}

TEST(TestPatterns, MoireIsTheAliasOfAGrating) {
  Random random(157);
  for (int i = 0; i < 40; ++i) {
    const Grating fine{{random.uniform(-3, 3), random.uniform(-3, 3)}};
    const Grating coarse = fine.alias();
    EXPECT_LE(std::abs(coarse.frequency.x), 0.5);
    // In the corners of pixels the phases agree
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 24; ++x) EXPECT_NEAR(fine(dvec2(x, y)), coarse(dvec2(x, y)), 1e-12);
    }
  }
}

TEST(TestPatterns, AMeanOfTheGratingIsTheMeanOfItsSamples) {
  const Grating fine{{0.9, 0.35}};
  const Picture many = picture(fine, {12, 12}, 64);
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 12; ++x) EXPECT_NEAR(many.at(x, y), fine.mean({x, y}), 1e-3);
  }
}

TEST(TestPatterns, TheHorizonBeginsWhereSquaresGetLowerThanAPixel) {
  const Chequerboard board{{24, 8}, 48, 1};
  // Between the centres of two rows lie so many borders of squares
  const auto borders = [&](double y) {
    const auto square = [&](double row) { return std::floor(board.focal / (row - board.vanishing.y)); };
    return square(y) - square(y + 1);
  };
  for (double y = board.vanishing.y + 0.5; y < 48; ++y) {
    const double below = y - board.vanishing.y;
    if (below > board.finest()) {
      EXPECT_LE(borders(y), 1) << y;
    } else if (below < board.finest() - 2) {
      EXPECT_GE(borders(y), 1) << y;
    }
  }
  // Truth tends to grey there; one sample per pixel is black or white
  const Picture one = picture(board, {48, 48}), mean = picture(board, {48, 48}, 32);
  double worst_near = 0, grey = 0;
  for (int x = 0; x < 48; ++x) {
    EXPECT_TRUE(one.at(x, 8) == 0 || one.at(x, 8) == 1);
    grey = std::max(grey, std::abs(mean.at(x, 8) - 0.5));
    worst_near = std::max(worst_near, std::abs(one.at(x, 8) - mean.at(x, 8)));
  }
  EXPECT_LT(grey, 0.1);
  EXPECT_GT(worst_near, 0.4);
}

TEST(TestPatterns, ThinBarsAreLost) {
  // A quarter of a pixel wide, 2.25 apart: one in four hits a centre, as wide as a pixel then
  const Bars bars{2.25, 0.25, 0.125};
  const Picture p = picture(bars, {36, 1});
  int black = 0;
  double mean = 0;
  for (int x = 0; x < 36; ++x) {
    black += p.at(x, 0) == 0;
    mean += bars.mean(x);
  }
  EXPECT_EQ(black, 4);                       // of 16 bars
  EXPECT_NEAR(36 - mean, 16 * 0.25, 1e-12);  // what they cover
  const Bars even{2, 0.25, 0.75};
  for (const double value : picture(even, {36, 1}).pixels) EXPECT_EQ(value, 1);  // none at all
}

TEST(TestPatterns, AThinLineFallsIntoFragments) {
  // Half a row high, one row in eight columns: four columns of eight see it, a piece per row
  const ThinLine line{0.53, 0.125, 0.5 / std::sqrt(1 + 0.125 * 0.125)};
  EXPECT_NEAR(line.height(), 0.5, 1e-15);
  const Picture p = picture(line, {32, 6});
  int black = 0;
  for (const double value : p.pixels) black += value == 0;
  EXPECT_EQ(black, 16);
  EXPECT_EQ(fragments_of(p), 5);  // four rows, the first of them in two ends
  // A line as high as a pixel holds a centre in every column
  const ThinLine whole{0.53, 0.125, 1 / std::sqrt(1 + 0.125 * 0.125)};
  black = 0;
  for (const double value : picture(whole, {32, 6}).pixels) black += value == 0;
  EXPECT_EQ(black, 32);
}

TEST(TestPatterns, AnEdgeHasSteps) {
  // One row in six columns: steps of six pixels, up to half a pixel from the edge
  const HalfPlane edge{2.25, 1 / 6.0};
  const Picture p = picture(edge, {36, 12});
  int last = -1, run = 0;
  double off = 0;
  std::vector<int> runs;
  for (int x = 0; x < 36; ++x) {
    int height = 0;
    while (height < 12 && p.at(x, height) == 1) ++height;
    off = std::max(off, std::abs(height - (edge.offset + edge.slope * (x + 0.5))));
    if (height != last && last >= 0) runs.push_back(run);
    run = height == last ? run + 1 : 1;
    last = height;
  }
  EXPECT_LE(off, 0.5);
  EXPECT_GT(off, 0.4);
  ASSERT_GE(runs.size(), 5u);
  for (std::size_t i = 1; i < runs.size(); ++i) EXPECT_EQ(runs[i], 6);
}

TEST(TestPatterns, NoSamplesAPixelAreRefused) {
  EXPECT_THROW(picture_of(Bars{2, 1}, {1, 1}, 0, [](ivec2, double) {}), ContractViolation);
}

}  // namespace
}  // namespace gradus::sampling_theorem
