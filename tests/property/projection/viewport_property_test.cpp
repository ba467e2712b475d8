// Places and pixels against rationals, and the way back.

#include "projection/viewport/viewport.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/exact_scalar.hpp"
#include "core/random.hpp"
#include "projection/viewport/viewport_notes.hpp"
#include "support/seed.hpp"

namespace gradus::viewport {
namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();

ExactVec2 exactly(dvec2 v) { return {Exact(v.x), Exact(v.y)}; }
Rectangle<Exact> exactly(const Rectangle<double>& area) { return {exactly(area.lower), exactly(area.upper)}; }

/// Windows of all sizes, many far from the origin; pictures from 1 x 1 on.
Rectangle<double> any_window(Random& random) {
  const double size = std::scalbn(random.uniform(1, 2), static_cast<int>(random.uniform_int(-60, 60)));
  const auto side = [&](double extent) {
    const double centre = random.uniform_int(0, 2) ? 0 : extent * random.uniform(-10, 10);
    return std::pair{centre - extent * random.uniform(0.1, 1), centre + extent * random.uniform(0.1, 1)};
  };
  const auto [x0, x1] = side(size);
  const auto [y0, y1] = side(size * random.uniform(0.1, 10));
  return {{x0, y0}, {x1, y1}};
}
ivec2 any_picture(Random& random) {
  const auto side = [&] {
    return static_cast<int>(random.uniform_int(1, random.uniform_int(0, 1) ? 12 : 5000));
  };
  const int width = side(), height = side();
  return {width, height};
}
/// A point in the window or near it; sometimes on the side of a pixel, as nearly as a double can be.
dvec2 any_point(Random& random, const Mapping<double>& map) {
  const auto one = [&](double a, double b, int pixels) {
    if (random.uniform_int(0, 3)) return a + (b - a) * random.uniform(-0.25, 1.25);
    return a + (b - a) * (double(random.uniform_int(0, pixels)) / pixels);
  };
  const double x = one(map.window.lower.x, map.window.upper.x, map.picture.x);
  const double y = one(map.window.lower.y, map.window.upper.y, map.picture.y);
  return {x, y};
}

/// floor, or the nearest integer, by rationals.
std::int64_t rounded_exactly(Exact x, Rounding rounding) {
  if (rounding == Rounding::floor) return floor(x);
  const std::int64_t up = floor(x + Exact(1, 2));
  const bool tie = Exact(up) == x + Exact(1, 2);
  return tie && rounding == Rounding::half_even && up % 2 != 0 ? up - 1 : up;
}
/// How far from the nearest place at which the pixel changes.
double from_a_border(Exact x, Rounding rounding) {
  const Exact shifted = rounding == Rounding::floor ? x : x + Exact(1, 2);
  const Exact part = shifted - Exact(floor(shifted));
  return to_double(part < Exact(1, 2) ? part : Exact(1) - part);
}

TEST(ViewportProperty, PixelsAreThoseOfRationals) {
  Random random(test::seed());
  int cases = 0, inside = 0, outside = 0, near = 0;
  double worst = 0;
  for (; cases < 6000; ++cases) {
    const ExactScope scope;
    const Rectangle<double> window = any_window(random);
    const ivec2 picture = any_picture(random);
    const RowZero row_zero = random.uniform_int(0, 1) ? RowZero::top : RowZero::bottom;
    const Mapping<double> map = stretched(window, picture, row_zero);
    const Mapping<Exact> exact = stretched(exactly(window), picture, row_zero);
    const dvec2 p = any_point(random, map);
    const dvec2 place = place_at(map.viewport, fraction_of(map, p));
    const ExactVec2 truth = place_at(exact.viewport, fraction_of(exact, exactly(p)));
    double off[2];
    for (int axis = 0; axis < 2; ++axis) {
      off[axis] = std::abs(to_double(Exact(place[axis]) - truth[axis]));
      // Relative to the picture: what lies in it is at most as far
      const double reach = std::max<double>(picture[axis], std::abs(place[axis]));
      worst = std::max(worst, off[axis] / reach / ulp);
    }
    for (const Rounding rounding : {Rounding::floor, Rounding::half_up, Rounding::half_even}) {
      const auto pixel = rasterize(map, p, rounding);
      const auto right = rasterize(exact, exactly(p), rounding);
      (right ? inside : outside) += 1;
      if (right) {
        ASSERT_EQ(right->x, rounded_exactly(truth.x, rounding));
        ASSERT_EQ(right->y, rounded_exactly(truth.y, rounding));
      }
      // Off the borders the double's pixel is the rational's
      bool clear = true;
      for (int axis = 0; axis < 2; ++axis) {
        clear = clear && (off[axis] == 0 || (from_a_border(truth[axis], rounding) > off[axis] &&
                                             from_a_border(truth[axis], Rounding::floor) > off[axis]));
      }
      if (clear) ASSERT_EQ(pixel, right);
      near += !clear;
    }
  }
  std::printf("%d points, %d inside, %d outside, %d next to a border; worst place %.3g ulp of the picture\n",
              cases, inside, outside, near, worst);
  EXPECT_EQ(cases, 6000);
  EXPECT_GT(inside, 6000);
  EXPECT_GT(outside, 5000);
  EXPECT_GT(near, 100);
  EXPECT_LT(worst, 2.5);
}

TEST(ViewportProperty, EveryPixelCentreLeadsBackToItsPixel) {
  Random random(test::seed());
  int windows = 0;
  std::int64_t pixels = 0;
  double worst = 0;
  for (; windows < 2000; ++windows) {
    const Rectangle<double> window = any_window(random);
    const ivec2 picture{static_cast<int>(random.uniform_int(1, 24)),
                        static_cast<int>(random.uniform_int(1, 24))};
    const RowZero row_zero = random.uniform_int(0, 1) ? RowZero::top : RowZero::bottom;
    const bool boxed = random.uniform_int(0, 1);
    const Mapping<double> map =
        boxed ? letterboxed(window, picture, row_zero) : stretched(window, picture, row_zero);
    for (int row = 0; row < picture.y; ++row) {
      for (int column = 0; column < picture.x; ++column) {
        const ivec2 pixel{column, row};
        const dvec2 centre{column + 0.5, row + 0.5};
        ++pixels;
        const dvec2 point = pixel_centre(map, pixel);
        const auto again = rasterize(map, point);
        if (holds(map.viewport, centre)) {
          // A bar's border may pass through the centre
          const auto& [lower, upper] = map.viewport;
          const double room =
              std::min({centre.x - lower.x, upper.x - centre.x, centre.y - lower.y, upper.y - centre.y});
          if (room > 1e-9) ASSERT_EQ(again, std::optional(pixel));
        } else {
          ASSERT_FALSE(again && *again != pixel);
        }
        if (!holds(map.viewport, centre)) continue;
        const dvec2 there = place_at(map.viewport, fraction_of(map, point));
        for (int axis = 0; axis < 2; ++axis) {
          const double used = map.viewport.size()[axis], scale = map.window.size()[axis] / used;
          const double reach = std::max({std::abs(window.lower[axis]), std::abs(window.upper[axis])});
          const double bars = picture[axis] / used;
          worst = std::max(worst, std::abs(there[axis] - centre[axis]) * scale / (reach * bars) / ulp);
        }
      }
    }
  }
  std::printf(
      "%d windows, %lld pixels, there and back worst %.3g ulp of the window's largest coordinate times "
      "picture / viewport\n",
      windows, static_cast<long long>(pixels), worst);
  EXPECT_EQ(windows, 2000);
  EXPECT_GT(pixels, 100000);
  EXPECT_LT(worst, 4);
}

TEST(ViewportProperty, ThereAndBackIsExactInRationals) {
  Random random(test::seed());
  int cases = 0, bars = 0;
  for (; cases < 1000; ++cases) {
    const ExactScope scope;
    const Rectangle<double> window = any_window(random);
    const ivec2 picture = any_picture(random);
    const RowZero row_zero = random.uniform_int(0, 1) ? RowZero::top : RowZero::bottom;
    const Mapping<Exact> full = stretched(exactly(window), picture, row_zero);
    const Mapping<Exact> boxed = letterboxed(exactly(window), picture, row_zero);
    const dvec2 p = any_point(random, stretched(window, picture));
    for (const auto& map : {full, boxed}) {
      ASSERT_EQ(to_plane(map, place_at(map.viewport, fraction_of(map, exactly(p)))), exactly(p));
      // Corners of the window are corners of the viewport
      const bool top = row_zero == RowZero::top;
      const ExactVec2 first{map.window.lower.x, top ? map.window.upper.y : map.window.lower.y};
      const ExactVec2 last{map.window.upper.x, top ? map.window.lower.y : map.window.upper.y};
      ASSERT_EQ(place_at(map.viewport, fraction_of(map, first)), map.viewport.lower);
      ASSERT_EQ(place_at(map.viewport, fraction_of(map, last)), map.viewport.upper);
    }
    // A letterbox scales both axes alike, fills one side and stands in the middle of the other
    const ExactVec2 used = boxed.viewport.size(), size = boxed.window.size();
    ASSERT_EQ(used.x * size.y, used.y * size.x);
    ASSERT_TRUE(used.x == Exact(picture.x) || used.y == Exact(picture.y));
    ASSERT_TRUE(used.x <= Exact(picture.x) && used.y <= Exact(picture.y));
    ASSERT_EQ(boxed.viewport.lower + boxed.viewport.upper, (ExactVec2{Exact(picture.x), Exact(picture.y)}));
    bars += used.x != Exact(picture.x) || used.y != Exact(picture.y);
    // In doubles the letterbox is that of the rationals, nearly
    const Rectangle<double> rounded = letterboxed(window, picture, row_zero).viewport;
    for (int axis = 0; axis < 2; ++axis) {
      ASSERT_LE(std::abs(to_double(Exact(rounded.lower[axis]) - boxed.viewport.lower[axis])),
                2 * ulp * picture[axis]);
      ASSERT_LE(std::abs(to_double(Exact(rounded.upper[axis]) - boxed.viewport.upper[axis])),
                2 * ulp * picture[axis]);
    }
  }
  EXPECT_EQ(cases, 1000);
  EXPECT_GT(bars, 950);
}

TEST(ViewportProperty, WindowCornersAreExact) {
  Random random(test::seed());
  int cases = 0;
  for (; cases < 50000; ++cases) {
    const Rectangle<double> window = any_window(random);
    const Mapping<double> map = stretched(window, any_picture(random));
    ASSERT_EQ(place_at(map.viewport, fraction_of(map, dvec2{window.lower.x, window.upper.y})), (dvec2{0}));
    ASSERT_EQ(place_at(map.viewport, fraction_of(map, dvec2{window.upper.x, window.lower.y})),
              dvec2(map.picture));
    ASSERT_TRUE(rasterize(map, dvec2{window.lower.x, window.upper.y}).has_value());
    ASSERT_FALSE(rasterize(map, dvec2{window.upper.x, window.upper.y}).has_value());
    // The clamp never says that a point is outside
    const ivec2 pixel = clamped(map, any_point(random, map), Rounding::half_even);
    ASSERT_TRUE(map.has(pixel));
  }
  EXPECT_EQ(cases, 50000);
}

TEST(ViewportProperty, ToPixelIsTheMappingOfTheUnitSquare) {
  Random random(test::seed());
  int cases = 0;
  for (; cases < 2000; ++cases) {
    const ExactScope scope;
    const ivec2 picture = any_picture(random);
    const Rectangle<Exact> square{{Exact(-1), Exact(-1)}, {Exact(1), Exact(1)}};
    const Mapping<Exact> map = stretched(square, picture);
    const ExactVec2 p = exactly({random.uniform(-2, 2), random.uniform(-2, 2)});
    ASSERT_EQ(to_pixel(p, picture.x, picture.y), place_at(map.viewport, fraction_of(map, p)));
  }
  EXPECT_EQ(cases, 2000);
}

TEST(ViewportProperty, RoundingIsExactForEveryScalar) {
  Random random(test::seed());
  int cases = 0, ties = 0;
  for (; cases < 20000; ++cases) {
    const ExactScope scope;
    double x = random.uniform(-1e6, 1e6);
    if (random.uniform_int(0, 1)) x = std::floor(x) + 0.5;
    if (random.uniform_int(0, 2) == 0) x = std::nextafter(x, random.uniform_int(0, 1) ? 1e9 : -1e9);
    ties += x - std::floor(x) == 0.5;
    const float single = static_cast<float>(x);
    for (const Rounding rounding : {Rounding::floor, Rounding::half_up, Rounding::half_even}) {
      ASSERT_EQ(rounded(x, rounding), rounded_exactly(Exact(x), rounding));
      ASSERT_EQ(rounded(single, rounding), rounded_exactly(Exact(single), rounding));
      ASSERT_EQ(rounded(Exact(x), rounding), rounded_exactly(Exact(x), rounding));
    }
  }
  EXPECT_EQ(cases, 20000);
  EXPECT_GT(ties, 1000);
}

}  // namespace
}  // namespace gradus::viewport
