// Lines against exact rationals, brute force, their own reverse and their rival methods.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "core/exact_scalar.hpp"
#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_batch.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_notes.hpp"
#include "support/seed.hpp"

namespace gradus::bresenham_line {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;

using test::seed;

using Pixels = std::vector<ivec2>;

Pixels drawn(ivec2 from, ivec2 to) {
  Pixels pixels;
  decision_parameter(from, to, [&](ivec2 p) { pixels.push_back(p); });
  return pixels;
}

cpp_int floor_of(const cpp_rational& x) {
  const cpp_int n = numerator(x), d = denominator(x);  // d > 0
  cpp_int q = n / d;
  if (n % d < 0) --q;
  return q;
}

/// Pixel number k by definition: the exact point of the line, rounded aside, midway to the smaller
/// coordinate.
ivec2 exact_pixel(ivec2 from, ivec2 to, std::int64_t k) {
  const cpp_int dx = cpp_int(to.x) - from.x, dy = cpp_int(to.y) - from.y;
  const bool up = abs(dy) > abs(dx);
  const cpp_int along = up ? dy : dx, aside = up ? dx : dy;
  if (along == 0) return from;
  const cpp_int step = along > 0 ? 1 : -1;
  const cpp_int lead = (up ? from.y : from.x) + step * k;
  const cpp_rational exact = (up ? from.x : from.y) + cpp_rational(aside * k, abs(along));
  const cpp_int side = -floor_of(cpp_rational(1, 2) - exact);  // ceil(exact - 1/2): midway goes down
  const int l = lead.convert_to<int>(), s = side.convert_to<int>();
  return up ? ivec2{s, l} : ivec2{l, s};
}

/// Coordinates of every size: small, large, and at the ends of int32.
class Coordinates {
 public:
  explicit Coordinates(std::uint64_t offset) : random_(seed() + offset) {}

  int one() {
    switch (below(6)) {
      case 0:
        return static_cast<int>(below(41)) - 20;
      case 1:
        return static_cast<int>(below(4001)) - 2000;
      case 2:
        return INT_MIN + static_cast<int>(below(50));
      case 3:
        return INT_MAX - static_cast<int>(below(50));
      case 4:
        return static_cast<int>((std::uint32_t{1} << below(31)) * (below(2) ? 1u : 0xffffffffu));
      default:
        return static_cast<int>(static_cast<std::uint32_t>(random_()));
    }
  }
  ivec2 point() {
    const int x = one();
    return {x, one()};
  }
  std::uint64_t below(std::uint64_t n) { return random_() % n; }

 private:
  std::mt19937_64 random_;
};

TEST(BresenhamLineProperty, EveryLineOfASmallSquare) {
  int lines = 0, ties = 0, differ_from_notes = 0;
  for (int x = -12; x <= 12; ++x) {
    for (int y = -12; y <= 12; ++y) {
      const ivec2 from{0, 0}, to{x, y};
      const Pixels pixels = drawn(from, to);
      ++lines;
      ASSERT_EQ(pixels.size(), static_cast<std::size_t>(std::max(std::abs(x), std::abs(y)) + 1));
      ASSERT_EQ(static_cast<std::int64_t>(pixels.size()), pixel_count(from, to));
      ASSERT_EQ(pixels.front(), from);
      ASSERT_EQ(pixels.back(), to);
      for (std::size_t k = 0; k < pixels.size(); ++k) {
        ASSERT_EQ(pixels[k], exact_pixel(from, to, static_cast<std::int64_t>(k))) << x << ' ' << y;
        // At most half a pixel off: 2 |x q.y - y q.x| <= max(|x|, |y|)
        const int off = 2 * std::abs(x * pixels[k].y - y * pixels[k].x),
                  most = std::max(std::abs(x), std::abs(y));
        ASSERT_LE(off, most);
        ties += most > 0 && off == most;
      }
      Pixels back = drawn(to, from);
      std::reverse(back.begin(), back.end());
      ASSERT_EQ(back, pixels);
      Pixels notes;
      swapped_ends(from, to, [&](ivec2 p) { notes.push_back(p); });
      if (notes.front() != from) std::reverse(notes.begin(), notes.end());
      differ_from_notes += notes != pixels;
    }
  }
  EXPECT_EQ(lines, 625);
  EXPECT_GT(ties, 400);
  EXPECT_GT(differ_from_notes, 0);
}

TEST(BresenhamLineProperty, PixelsByJumpingEqualRationalsToTheEndsOfInt32) {
  Coordinates any(1);
  int cases = 0, steep_ones = 0, long_ones = 0, midway = 0;
  for (int i = 0; i < 8000; ++i) {
    const ivec2 from = any.point();
    ivec2 to = any.point();
    // Every eighth line has a tie in its middle: an odd distance aside over an even one along
    if (i % 8 == 0) to = {from.x ^ 2, from.y};
    const std::int64_t last = pixel_count(from, to) - 1;
    const auto at = static_cast<std::int64_t>(any.below(static_cast<std::uint64_t>(last) + 1));
    for (const std::int64_t k : {std::int64_t{0}, last, last / 2, (last + 1) / 2, at}) {
      const ivec2 p = pixel_at(from, to, k);
      ASSERT_EQ(p, exact_pixel(from, to, k))
          << seed() << ": " << from.x << ',' << from.y << ' ' << to.x << ',' << to.y << " pixel " << k;
      ASSERT_EQ(p, pixel_at(to, from, last - k));
      ++cases;
    }
    steep_ones += steep(from, to);
    long_ones += last > INT_MAX;
    midway += last > 0 && last % 2 == 0 && extent(from, to).dy % 2 == 1;
  }
  EXPECT_EQ(cases, 40000);
  EXPECT_GT(steep_ones, 2000);
  EXPECT_GT(long_ones, 500);
  EXPECT_GT(midway, 500);
}

TEST(BresenhamLineProperty, EveryStepKeepsItsInvariants) {
  Coordinates any(2);
  std::int64_t cases = 0;
  for (int i = 0; i < 2000; ++i) {
    const ivec2 from{static_cast<int>(any.below(201)) - 100, static_cast<int>(any.below(201)) - 100};
    const ivec2 to{static_cast<int>(any.below(201)) - 100, static_cast<int>(any.below(201)) - 100};
    const auto [dx, dy] = extent(from, to);
    Pixels plotted;
    std::int64_t k = 0;
    int phase = 0;  // of the grammar Started (Compared Stepped)* Finished
    struct Watch {
      ivec2 from, to;
      std::int64_t dx, dy;
      Pixels& plotted;
      std::int64_t& k;
      int& phase;
      std::int64_t& cases;
      void operator()(const Started& s) const {
        EXPECT_EQ(phase, 0);
        EXPECT_EQ(s.p, 2 * dy - dx);
        EXPECT_TRUE(plotted.empty());
        phase = 1;
      }
      void operator()(const Compared& c) const {
        EXPECT_EQ(phase, 1);
        phase = 2;
        EXPECT_EQ(c.pixel, plotted.back());
        // p is 2 dx times the exact line's height above the middle of the two candidates
        const ivec2 straight = c.pixel + c.moves.straight, diagonal = c.pixel + c.moves.diagonal;
        const auto above = [&](ivec2 q) {  // dx times the height of a pixel above the line, up to the sign
          return std::int64_t{to.x - from.x} * (q.y - from.y) - std::int64_t{to.y - from.y} * (q.x - from.x);
        };
        const std::int64_t sign = above(diagonal) > above(straight) ? 1 : -1;
        EXPECT_EQ(c.p, -sign * (above(straight) + above(diagonal)));
        EXPECT_LE(c.p, 2 * dy);
        EXPECT_GE(c.p, 2 * (dy - dx));
        // They differ in one coordinate; midway the smaller one wins
        const bool low = straight.x + straight.y < diagonal.x + diagonal.y;
        EXPECT_EQ(c.straight, c.p < 0 || (c.p == 0 && low));
        ++cases;
      }
      void operator()(const Stepped& s) const {
        EXPECT_EQ(phase, 2);
        phase = 1;
        EXPECT_EQ(s.from, plotted.back());
        EXPECT_EQ(s.pixel, exact_pixel(from, to, ++k));
        EXPECT_EQ(s.p - s.p_before, s.straight ? 2 * dy : 2 * (dy - dx));
      }
      void operator()(const Finished& f) const {
        EXPECT_EQ(phase, 1);
        phase = 3;
        EXPECT_EQ(f.pixels, static_cast<std::int64_t>(plotted.size()));
      }
    };
    const Watch watch{from, to, dx, dy, plotted, k, phase, cases};
    decision_parameter(from, to, [&](ivec2 p) { plotted.push_back(p); }, watch);
    ASSERT_EQ(phase, 3);
    ASSERT_EQ(plotted, drawn(from, to));
    ASSERT_FALSE(HasFailure()) << seed() << ": " << from.x << ',' << from.y << ' ' << to.x << ',' << to.y;
  }
  EXPECT_GT(cases, 100000);
}

TEST(BresenhamLineProperty, WindowShowsExactlyTheUnclippedPixels) {
  Coordinates any(3);
  int cases = 0, cut = 0, missed = 0, whole = 0;
  std::int64_t pixels = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto near = [&](int reach) {
      return static_cast<int>(any.below(2u * static_cast<unsigned>(reach) + 1)) - reach;
    };
    const ivec2 from{near(60), near(60)}, to{near(60), near(60)};
    const ivec2 a{near(50), near(50)}, b{near(50), near(50)};
    const Window window =
        i % 50 ? window_around(a, b) : Window{a, b};  // some inside out, which shows nothing
    Pixels expected;
    for (const ivec2 p : drawn(from, to)) {
      if (window.contains(p)) expected.push_back(p);
    }
    Pixels shown, runs;
    in_window(from, to, window, [&](ivec2 p) { shown.push_back(p); });
    run_length_in_window(from, to, window, [&](ivec2 start, std::int64_t count) {
      ASSERT_GT(count, 0);
      for (std::int64_t j = 0; j < count; ++j) runs.push_back(place(start, moves(from, to), j, 0));
    });
    ASSERT_EQ(shown, expected) << seed() << " case " << i;
    ASSERT_EQ(runs, expected) << seed() << " case " << i;
    ++cases;
    const auto all = static_cast<std::size_t>(pixel_count(from, to));
    missed += expected.empty();
    whole += expected.size() == all;
    cut += !expected.empty() && expected.size() < all;
    pixels += static_cast<std::int64_t>(expected.size());
  }
  EXPECT_EQ(cases, 20000);
  EXPECT_GT(cut, 5000);
  EXPECT_GT(missed, 1000);
  EXPECT_GT(whole, 200);
  EXPECT_GT(pixels, 100000);
}

TEST(BresenhamLineProperty, WindowOnLinesOfAnyLength) {
  Coordinates any(4);
  int shown_lines = 0, missed = 0;
  for (int i = 0; i < 20000; ++i) {
    const ivec2 from = any.point(), to = any.point();
    const std::int64_t last = pixel_count(from, to) - 1;
    // A window of at most 24 x 24 round a pixel of the line, now and then beside it
    const auto middle = static_cast<std::int64_t>(any.below(static_cast<std::uint64_t>(last) + 1));
    const ivec2 at = pixel_at(from, to, middle);
    const auto bounded = [&](int v, int by) {
      return static_cast<int>(std::clamp<std::int64_t>(std::int64_t{v} + by, INT_MIN, INT_MAX));
    };
    const int left = static_cast<int>(any.below(14)) - 2, right = static_cast<int>(any.below(12));
    const int down = static_cast<int>(any.below(14)) - 2, up = static_cast<int>(any.below(12));
    const Window window{{bounded(at.x, -left), bounded(at.y, -down)},
                        {bounded(at.x, right), bounded(at.y, up)}};
    const Stretch stretch = visible(from, to, window);
    Pixels shown;
    in_window(from, to, window, [&](ivec2 p) { shown.push_back(p); });
    ASSERT_EQ(static_cast<std::int64_t>(shown.size()),
              std::max<std::int64_t>(0, stretch.last - stretch.first + 1));
    ASSERT_LE(shown.size(), 48u);
    for (std::size_t j = 0; j < shown.size(); ++j) {
      ASSERT_TRUE(window.contains(shown[j]));
      ASSERT_EQ(shown[j], pixel_at(from, to, stretch.first + static_cast<std::int64_t>(j)))
          << seed() << " case " << i;
    }
    // Nothing more: all pixels within 60 of the window's, by number, are shown or outside
    for (std::int64_t k = std::max<std::int64_t>(0, middle - 60); k <= std::min(last, middle + 60); ++k) {
      const bool in = stretch.first <= k && k <= stretch.last;
      ASSERT_EQ(window.contains(pixel_at(from, to, k)), in) << seed() << " case " << i;
    }
    Pixels runs;
    run_length_in_window(from, to, window, [&](ivec2 start, std::int64_t count) {
      for (std::int64_t j = 0; j < count; ++j) runs.push_back(place(start, moves(from, to), j, 0));
    });
    ASSERT_EQ(runs, shown) << seed() << " case " << i;
    (shown.empty() ? missed : shown_lines)++;
  }
  EXPECT_GT(shown_lines, 15000);
  EXPECT_GT(missed, 10);
}

TEST(BresenhamLineProperty, RunsAndDrawingAreThePixelsOfTheTaughtMethod) {
  Coordinates any(5);
  int cases = 0, cut = 0;
  std::int64_t runs = 0, pixels = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto near = [&](unsigned reach) {
      return static_cast<int>(any.below(2 * reach + 1)) - static_cast<int>(reach);
    };
    const unsigned reach_y = i % 3 == 0 ? 5 : 150, reach_x = i % 3 == 1 ? 5 : 150;
    const ivec2 from{near(reach_x), near(reach_y)}, to{near(reach_x), near(reach_y)};
    const Pixels expected = drawn(from, to);
    Pixels expanded;
    run_length(from, to, [&](ivec2 start, std::int64_t count) {
      for (std::int64_t j = 0; j < count; ++j) expanded.push_back(place(start, moves(from, to), j, 0));
      ++runs;
    });
    ASSERT_EQ(expanded, expected) << seed() << " case " << i;
    pixels += static_cast<std::int64_t>(expected.size());

    Raster<std::uint8_t> raster(90, 60), reference(90, 60);
    draw(raster, from, to, std::uint8_t{1});
    bool all_inside = true;
    for (const ivec2 p : expected) {
      if (reference.contains(p)) reference[p] = 1;
      all_inside = all_inside && reference.contains(p);
    }
    ASSERT_EQ(raster, reference) << seed() << " case " << i;
    cut += !all_inside;
    ++cases;
  }
  EXPECT_EQ(cases, 5000);
  EXPECT_GT(cut, 1000);
  EXPECT_LT(runs, pixels * 2 / 3);
  // Beyond 32 bits: run ends equal pixel_at
  int ends = 0;
  for (int i = 0; i < 3000; ++i) {
    const ivec2 from = any.point();
    ivec2 to = any.point();
    if (extent(from, to).dy > 300) {  // few runs, any length
      const int y = static_cast<int>(any.below(300)) - 150;
      to.y = static_cast<int>(std::clamp<std::int64_t>(std::int64_t{from.y} + y, INT_MIN, INT_MAX));
    }
    if (extent(from, to).dy > 300) continue;
    std::int64_t k = 0;
    run_length(from, to, [&](ivec2 start, std::int64_t count) {
      ASSERT_EQ(start, pixel_at(from, to, k));
      ASSERT_EQ(place(start, moves(from, to), count - 1, 0), pixel_at(from, to, k + count - 1));
      k += count;
      ++ends;
    });
    ASSERT_EQ(k, pixel_count(from, to)) << seed() << " case " << i;
  }
  EXPECT_GT(ends, 50000);
}

TEST(BresenhamLineProperty, DdaIsExactInRationalsAndDriftsWithinItsBound) {
  Coordinates any(6);
  int exact_cases = 0;
  for (int i = 0; i < 300; ++i) {
    const ivec2 from{static_cast<int>(any.below(101)) - 50, static_cast<int>(any.below(101)) - 50};
    const ivec2 to{static_cast<int>(any.below(101)) - 50, static_cast<int>(any.below(101)) - 50};
    const ExactScope scope;
    Pixels pixels;
    dda<Exact>(from, to, [&](ivec2 p) { pixels.push_back(p); });
    ASSERT_EQ(pixels, drawn(from, to)) << seed() << " case " << i;
    ++exact_cases;
  }
  EXPECT_EQ(exact_cases, 300);

  // |error| of pixel k <= 1/2 + e k (k + 3), aside, for float and double; the float one does go wrong
  std::int64_t wrong = 0, pixels = 0;
  for (int i = 0; i < 60; ++i) {
    const int dx = static_cast<int>(any.below(60000)) + 3,
              dy = static_cast<int>(any.below(static_cast<unsigned>(dx)));
    const auto check = [&](double e, auto scalar) {
      std::int64_t k = 0;
      dda<decltype(scalar)>({0, 0}, {dx, dy}, [&](ivec2 p) {
        ASSERT_EQ(p.x, k);
        const double error = std::abs(static_cast<double>(std::int64_t{p.y} * dx - k * dy)) / dx;
        const auto n = static_cast<double>(k);
        ASSERT_LE(error, 0.5 + e * n * (n + 3)) << seed() << ": " << dx << ' ' << dy << " pixel " << k;
        wrong += p != pixel_at({0, 0}, {dx, dy}, k);
        ++k;
        ++pixels;
      });
    };
    check(0x1p-24, float{});
    check(0x1p-53, double{});
  }
  EXPECT_GT(pixels, 1000000);
  EXPECT_GT(wrong, 1000);
}

/// Number of the first pixel that dda draws in another place than decision_parameter, and -1 for none.
template <class T>
std::int64_t first_wrong(ivec2 from, ivec2 to, ivec2* end = nullptr) {
  std::int64_t k = 0, wrong = -1;
  const auto [dx, dy] = extent(from, to);
  const Moves go = moves(from, to);
  ivec2 exact = from;
  std::int64_t p = 2 * dy - dx;
  dda<T>(from, to, [&](ivec2 pixel) {
    if (k > 0) {
      const bool straight = p < 0 || (p == 0 && go.tie_straight);
      exact += straight ? go.straight : go.diagonal;
      p += straight ? 2 * dy : 2 * (dy - dx);
    }
    if (wrong < 0 && pixel != exact) wrong = k;
    if (end) *end = pixel;
    ++k;
  });
  return wrong;
}

TEST(BresenhamLineProperty, WhereDdaFirstGoesWrong) {
  // The exhibits of docs/topics/scan_conversion/bresenham_line.md
  int shortest = 0, without_tie = 0;
  for (int dx = 1; shortest == 0 || without_tie == 0; ++dx) {
    for (int dy = 0; dy <= dx; ++dy) {
      const bool wrong = first_wrong<float>({0, 0}, {dx, dy}) >= 0;
      if (wrong && shortest == 0) shortest = dx;
      if (wrong && dx % 2 == 1 && without_tie == 0) without_tie = dx;  // midway only exists for even dx
    }
  }
  EXPECT_EQ(shortest, 12);
  EXPECT_EQ(first_wrong<float>({0, 0}, {12, 10}), 9);
  EXPECT_EQ(without_tie, 359);
  EXPECT_EQ(first_wrong<float>({0, 0}, {359, 349}), 341);
  ivec2 end{};
  EXPECT_EQ(first_wrong<float>({0, 0}, {1000000, 618034}, &end), 305);
  EXPECT_EQ(end, (ivec2{1000000, 623366}));
  EXPECT_EQ(first_wrong<double>({0, 0}, {1000000, 618034}, &end), 250000);
  EXPECT_EQ(end, (ivec2{1000000, 618034}));
  // From 2^23 on, adding 1/2 to a float of 8,388,608 changes nothing: the line stops climbing
  EXPECT_EQ(first_wrong<float>({0, 0}, {20000000, 10000000}, &end), 16777218);
  EXPECT_EQ(end, (ivec2{20000000, 8388608}));
}

}  // namespace
}  // namespace gradus::bresenham_line
