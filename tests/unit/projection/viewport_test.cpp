// Corners, goldens, roundings, both ways up, letterboxes, scalars, refusals, and the report's clamp.

#include "projection/viewport/viewport.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/geometry.hpp"
#include "core/record.hpp"
#include "projection/viewport/viewport_notes.hpp"

namespace gradus::viewport {
namespace {

using DRectangle = Rectangle<double>;
using DMapping = Mapping<double>;
using Pixel = std::optional<ivec2>;

/// The report's camera plane, 2 x 1.5, in 640 x 480 pixels.
const DMapping report = stretched(DRectangle{{-1, -0.75}, {1, 0.75}}, {640, 480});

/// Where a point stands in the picture before it is rounded.
dvec2 place_of(const DMapping& map, dvec2 point) { return place_at(map.viewport, fraction_of(map, point)); }

TEST(Viewport, CornersAndMiddle) {
  EXPECT_EQ(to_pixel(dvec2{-1, 1}, 640, 480), (dvec2{0, 0}));
  EXPECT_EQ(to_pixel(dvec2{1, -1}, 640, 480), (dvec2{640, 480}));
  EXPECT_EQ(to_pixel(dvec2{0, 0}, 641, 481), (dvec2{320.5, 240.5}));
  EXPECT_EQ(place_of(report, {-1, 0.75}), (dvec2{0, 0}));
  EXPECT_EQ(place_of(report, {1, -0.75}), (dvec2{640, 480}));
  EXPECT_EQ(place_of(report, {0, 0}), (dvec2{320, 240}));
}

TEST(Viewport, GoldenPixels) {
  // G000-11
  EXPECT_EQ(rasterize(report, dvec2{0, 0}), Pixel({320, 240}));
  EXPECT_EQ(rasterize(report, dvec2{0.5, 0.3}), Pixel({480, 144}));
  EXPECT_EQ(rasterize(report, dvec2{-0.5, -0.2}), Pixel({160, 304}));
  for (const Rounding rounding : {Rounding::half_up, Rounding::half_even}) {
    EXPECT_EQ(rasterize(report, dvec2{0, 0}, rounding), Pixel({320, 240}));
    EXPECT_EQ(rasterize(report, dvec2{0.5, 0.3}, rounding), Pixel({480, 144}));
    EXPECT_EQ(rasterize(report, dvec2{-0.5, -0.2}, rounding), Pixel({160, 304}));
  }
}

TEST(Viewport, RowZeroIsTheTop) {
  // G000-11, E000-08: raising y lowers the row, so row 0 is at the top
  EXPECT_NEAR(glm::distance(to_pixel(dvec2{0.5, 0.3 / 0.75}, 640, 480), dvec2{480, 144}), 0, 1e-13);
  const dvec2 p = to_pixel(dvec2{-0.5, -0.2 / 0.75}, 640, 480);
  EXPECT_DOUBLE_EQ(p.x, 160);
  EXPECT_DOUBLE_EQ(p.y, 304);
  EXPECT_LT(rasterize(report, dvec2{0, 0.25})->y, rasterize(report, dvec2{0, 0})->y);
  // With row 0 at the bottom nothing is turned round
  DMapping paper = report;
  paper.row_zero = RowZero::bottom;
  EXPECT_EQ(rasterize(paper, dvec2{0.5, 0.3}), Pixel({480, 336}));
  EXPECT_EQ(rasterize(paper, dvec2{-1, -0.75}), Pixel({0, 0}));
  EXPECT_EQ(rasterize(paper, dvec2{-1, 0.75}), std::nullopt);
  EXPECT_EQ(rasterize(report, dvec2{-1, 0.75}), Pixel({0, 0}));
  EXPECT_EQ(rasterize(report, dvec2{-1, -0.75}), std::nullopt);
}

TEST(Viewport, OutsideIsReported) {
  // G000-12: nothing is moved to the border
  EXPECT_EQ(to_pixel(dvec2{5, 0}, 640, 480), (dvec2{1920, 240}));
  EXPECT_EQ(place_of(report, {5, 0}), (dvec2{1920, 240}));
  EXPECT_EQ(place_of(report, {2, 1}), (dvec2{960, -80}));
  EXPECT_EQ(place_of(report, {1, 0.75}), (dvec2{640, 0}));
  for (const dvec2 p : {dvec2{5, 0}, dvec2{2, 1}, dvec2{1, 0.75}}) {
    for (const Rounding rounding : {Rounding::floor, Rounding::half_up, Rounding::half_even}) {
      EXPECT_EQ(rasterize(report, p, rounding), std::nullopt);
    }
  }
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const double bad : {infinity, -infinity, nan, 1e308, -1e308}) {
    EXPECT_EQ(rasterize(report, dvec2{bad, 0}), std::nullopt);
    EXPECT_EQ(rasterize(report, dvec2{0, bad}), std::nullopt);
  }
}

TEST(Viewport, RoundingsByName) {
  // E000-10: x = 0.0015625 is place 320.5
  const dvec2 tie{0.0015625, 0};
  EXPECT_EQ(place_of(report, tie).x, 320.5);
  EXPECT_EQ(rasterize(report, tie, Rounding::floor)->x, 320);
  EXPECT_EQ(rasterize(report, tie, Rounding::half_even)->x, 320);
  EXPECT_EQ(rasterize(report, tie, Rounding::half_up)->x, 321);
  EXPECT_EQ(rounded(321.5, Rounding::half_even), 322);
  EXPECT_EQ(rounded(-0.5, Rounding::half_up), 0);
  EXPECT_EQ(rounded(-0.5, Rounding::half_even), 0);
  EXPECT_EQ(rounded(-1.5, Rounding::half_up), -1);
  EXPECT_EQ(rounded(-1.5, Rounding::half_even), -2);
  EXPECT_EQ(rounded(-1.5, Rounding::floor), -2);
  // floor(x + 1/2) would make 1 of this
  EXPECT_EQ(rounded(0.49999999999999994, Rounding::half_up), 0);
  EXPECT_EQ(rounded(0.49999997f, Rounding::half_up), 0);
}

/// How many sixteenths of a pixel along row 0 fall to a column.
template <class PixelOf>
int sixteenths(PixelOf pixel_of, int column) {
  int count = 0;
  for (int i = 0; i < 16 * 8; ++i) {
    const Pixel pixel = pixel_of(dvec2{(i + 0.5) / 16, 0.5});
    count += pixel && pixel->x == column;
  }
  return count;
}

TEST(Viewport, NearestIntegersShareTheColumnsUnevenly) {
  // E000-10, E000-11: 0 .. 8 has nine integers for eight columns
  const DMapping unit = stretched(DRectangle{{0, 0}, {8, 1}}, {8, 1}, RowZero::bottom);
  const auto by = [&](Rounding rounding) {
    // Half a pixel up or down rows are 0 or 1: keep to row 0
    return [&unit, rounding](dvec2 p) { return rasterize(unit, dvec2{p.x, 0.25}, rounding); };
  };
  for (int column = 0; column < 8; ++column) EXPECT_EQ(sixteenths(by(Rounding::floor), column), 16);
  EXPECT_EQ(sixteenths(by(Rounding::half_up), 0), 8);
  EXPECT_EQ(sixteenths(by(Rounding::half_up), 1), 16);
  EXPECT_EQ(sixteenths(by(Rounding::half_up), 7), 16);  // and 8 sixteenths have no column
  EXPECT_EQ(rasterize(unit, dvec2{7.75, 0.25}, Rounding::half_up), std::nullopt);
  const auto clamp = [&](dvec2 p) { return Pixel(clamped(unit, dvec2{p.x, 0.25}, Rounding::half_up)); };
  EXPECT_EQ(sixteenths(clamp, 0), 8);
  EXPECT_EQ(sixteenths(clamp, 7), 24);
  // The place (320, 240) is the corner of four pixels, not the middle of one
  EXPECT_EQ(place_of(report, {0, 0}), (dvec2{320, 240}));
  EXPECT_EQ(rasterize(report, dvec2{-1e-9, 1e-9}), Pixel({319, 239}));
}

TEST(Viewport, TheClampSmearsLinesAlongTheBorder) {
  // E000-09, G000-12
  EXPECT_EQ(clamped(report, dvec2{5, 0}, Rounding::half_even), (ivec2{639, 240}));
  EXPECT_EQ(clamped(report, dvec2{2, 1}, Rounding::half_even), (ivec2{639, 0}));
  EXPECT_EQ(clamped(report, dvec2{1, 0.75}, Rounding::half_even), (ivec2{639, 0}));
  EXPECT_EQ(clamped(report, dvec2{-1e300, -1e300}, Rounding::half_up), (ivec2{0, 479}));
  // The segment (0,0)-(2,1) leaves the window at (1, 1/2): row 80, not 0
  EXPECT_EQ(place_of(report, {1, 0.5}), (dvec2{640, 80}));
  EXPECT_EQ(rasterize(report, dvec2{0.9999, 0.49995}), Pixel({639, 80}));
  Recorder<Measured<double>, Placed<double>, Rounded<double>, Clamped> seen;
  EXPECT_EQ(clamped(report, dvec2{2, 1}, Rounding::half_even, seen), (ivec2{639, 0}));
  ASSERT_EQ(seen.seen(), 4u);
  EXPECT_EQ(all<Rounded<double>>(seen)[0].pixel, (ivec2{960, -80}));
  EXPECT_EQ(all<Clamped>(seen)[0].pixel, (ivec2{639, 0}));
  Recorder<Measured<double>, Placed<double>, Rounded<double>, Clamped> inside;
  EXPECT_EQ(clamped(report, dvec2{0.5, 0.3}, Rounding::half_even, inside), (ivec2{480, 144}));
  ASSERT_EQ(inside.seen(), 4u);
  EXPECT_EQ(all<Clamped>(inside)[0].pixel, all<Clamped>(inside)[0].nearest);
}

TEST(Viewport, ALetterboxKeepsShapes) {
  // A square window in a wide picture: bars left and right
  const DMapping wide = letterboxed(DRectangle{{-1, -1}, {1, 1}}, {8, 6});
  EXPECT_EQ(wide.viewport.lower, (dvec2{1, 0}));
  EXPECT_EQ(wide.viewport.upper, (dvec2{7, 6}));
  EXPECT_EQ(place_of(wide, {0, 0}), (dvec2{4, 3}));
  EXPECT_EQ(place_of(wide, {1, 0}) - place_of(wide, {0, 0}), (dvec2{3, 0}));
  EXPECT_EQ(place_of(wide, {0, 1}) - place_of(wide, {0, 0}), (dvec2{0, -3}));
  // A bar is in the picture, but not of the window
  EXPECT_EQ(rasterize(wide, dvec2{1.1, 0}), std::nullopt);
  EXPECT_EQ(rasterize(wide, dvec2{-1, 0}), Pixel({1, 3}));
  const DMapping tall = letterboxed(DRectangle{{-2, -1}, {2, 1}}, {8, 6});
  EXPECT_EQ(tall.viewport.lower, (dvec2{0, 1}));
  EXPECT_EQ(tall.viewport.upper, (dvec2{8, 5}));
  const DMapping same = letterboxed(DRectangle{{-4, -3}, {4, 3}}, {8, 6});
  EXPECT_EQ(same.viewport.lower, (dvec2{0, 0}));
  EXPECT_EQ(same.viewport.upper, (dvec2{8, 6}));
  // Stretched, a square becomes 4 : 3
  const DMapping full = stretched(DRectangle{{-1, -1}, {1, 1}}, {8, 6});
  EXPECT_EQ(place_of(full, {1, 0}) - place_of(full, {0, 0}), (dvec2{4, 0}));
  EXPECT_EQ(place_of(full, {0, 1}) - place_of(full, {0, 0}), (dvec2{0, -3}));
}

TEST(Viewport, PixelCentresLeadBack) {
  EXPECT_EQ(pixel_centre(stretched(DRectangle{{0, 0}, {8, 6}}, {8, 6}), {0, 0}), (dvec2{0.5, 5.5}));
  EXPECT_EQ(pixel_centre(stretched(DRectangle{{0, 0}, {8, 6}}, {8, 6}, RowZero::bottom), {0, 0}),
            (dvec2{0.5, 0.5}));
  EXPECT_EQ(to_plane(report, dvec2{0, 0}), (dvec2{-1, 0.75}));
  EXPECT_EQ(to_plane(report, dvec2{640, 480}), (dvec2{1, -0.75}));
  EXPECT_EQ(to_plane(report, dvec2{320, 240}), (dvec2{0, 0}));
}

// The columns from 1e9 to 1e9 + 1e-4 are half an ulp wide: there are fewer doubles than columns. From 9 ulp
// on each column has the point that stands for its centre
TEST(Viewport, ColumnsNarrowerThanAnUlpHaveNoPointOfTheirOwn) {
  const auto lost = [](double from, double to) {
    const DMapping map = stretched(DRectangle{{from, 0}, {to, 1}}, {1920, 1});
    int columns = 0;
    for (int c = 0; c < 1920; ++c) columns += rasterize(map, pixel_centre(map, {c, 0})) != Pixel({c, 0});
    return columns;
  };
  EXPECT_EQ(lost(1e9, 1e9 + 1e-4), 1261);
  const double ulp = 0x1p-23;
  EXPECT_EQ(lost(1e9, 1e9 + 9 * 1920 * ulp), 0);
  EXPECT_EQ(lost(0x1p29, 0x1p29 + 9 * 1920 * ulp), 0);
  EXPECT_EQ(lost(0x1p30 - 9 * 1920 * ulp, 0x1p30 - ulp), 0);
}

TEST(Viewport, WindowsOfAnySize) {
  // 2 x 1 of the smallest doubles: as wide as the picture, half as high
  const Rectangle<double> least{{0, 0}, {0x1p-1073, 0x1p-1074}};
  const auto boxed = letterboxed(least, {1000, 1000});
  EXPECT_EQ(boxed.viewport.lower, (dvec2{0, 250}));
  EXPECT_EQ(boxed.viewport.upper, (dvec2{1000, 750}));
  const auto wide = letterboxed(Rectangle<double>{{0, 0}, {0x1p1023, 0x1p1022}}, {1 << 30, 1 << 30});
  EXPECT_EQ(wide.viewport.lower, (dvec2{0, 0x1p28}));
  EXPECT_THROW(stretched(Rectangle<double>{{-1e308, 0}, {1e308, 1}}, {640, 480}), ContractViolation);
  EXPECT_THROW(letterboxed(Rectangle<double>{{0, -1e308}, {1, 1e308}}, {640, 480}), ContractViolation);
}

TEST(Viewport, StepsFollowTheGrammar) {
  Recorder<Mapped<double>> seen;
  EXPECT_EQ(to_pixel(dvec2{0.25, 0.5}, 8, 4, seen), (dvec2{5, 1}));
  ASSERT_EQ(seen.seen(), 1u);
  EXPECT_EQ(all<Mapped<double>>(seen)[0].pixel, (dvec2{5, 1}));

  Recorder<Measured<double>, Placed<double>, Outside<double>, Rounded<double>> inside;
  EXPECT_EQ(rasterize(report, dvec2{0.5, 0.25}, Rounding::floor, inside), Pixel({480, 160}));
  ASSERT_EQ(inside.seen(), 3u);
  EXPECT_EQ(std::get<Measured<double>>(inside.events()[0].step).fraction, (dvec2{0.75, 1.0 / 3}));
  EXPECT_EQ(std::get<Placed<double>>(inside.events()[1].step).place, (dvec2{480, 160}));
  EXPECT_EQ(std::get<Rounded<double>>(inside.events()[2].step).pixel, (ivec2{480, 160}));
  Recorder<Measured<double>, Placed<double>, Outside<double>, Rounded<double>> outside;
  EXPECT_EQ(rasterize(report, dvec2{2, 1}, Rounding::floor, outside), std::nullopt);
  ASSERT_EQ(outside.seen(), 3u);
  EXPECT_EQ(std::get<Outside<double>>(outside.events()[2].step).place, (dvec2{960, -80}));
  Recorder<Measured<double>, Placed<double>, Outside<double>, Rounded<double>> beyond;
  EXPECT_EQ(rasterize(report, dvec2{0.999, 0}, Rounding::half_up, beyond), std::nullopt);
  ASSERT_EQ(beyond.seen(), 3u);
  EXPECT_EQ(all<Rounded<double>>(beyond)[0].pixel, (ivec2{640, 240}));
  EXPECT_FALSE(all<Rounded<double>>(beyond)[0].there);
}

TEST(Viewport, OneBodyForEveryScalar) {
  EXPECT_EQ(to_pixel(glm::vec2{0.25f, 0.5f}, 8, 4), (glm::vec2{5, 1}));
  const Mapping<float> single = letterboxed(Rectangle<float>{{-1, -1}, {1, 1}}, {8, 6});
  EXPECT_EQ(rasterize(single, glm::vec2{0.4f, 0.4f}), Pixel({5, 1}));
  EXPECT_EQ(clamped(single, glm::vec2{9, 0}, Rounding::half_up), (ivec2{7, 3}));
  EXPECT_NEAR(pixel_centre(single, {1, 0}).x, -5.f / 6, 1e-7f);
  EXPECT_NEAR(pixel_centre(single, {1, 0}).y, 5.f / 6, 1e-7f);
  const ExactScope scope;
  const auto exact = stretched(Rectangle<Exact>{{Exact(-1), Exact(-1)}, {Exact(1), Exact(1)}}, {3, 7});
  EXPECT_EQ(clamped(exact, ExactVec2{Exact(1), Exact(0)}, Rounding::half_even), (ivec2{2, 4}));
}

TEST(Viewport, MistakesAreNamed) {
  EXPECT_THROW(to_pixel(dvec2{0, 0}, 0, 4), ContractViolation);
  const DRectangle window{{-1, -1}, {1, 1}};
  EXPECT_THROW(stretched(window, {0, 4}), ContractViolation);
  EXPECT_THROW(letterboxed(window, {4, 0}), ContractViolation);
  EXPECT_THROW(stretched(window, {4, most_pixels + 1}), ContractViolation);
  EXPECT_THROW(stretched(DRectangle{{1, -1}, {-1, 1}}, {4, 4}), ContractViolation);
  EXPECT_THROW(letterboxed(DRectangle{{-1, 1}, {1, 1}}, {4, 4}), ContractViolation);
  EXPECT_THROW(stretched(DRectangle{{std::nan(""), -1}, {1, 1}}, {4, 4}), ContractViolation);
}

}  // namespace
}  // namespace gradus::viewport
