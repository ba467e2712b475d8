// Circles against exact integers, brute force, the midpoint form and their rival methods.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_batch.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_notes.hpp"
#include "support/seed.hpp"

namespace gradus::bresenham_circle {
namespace {

using boost::multiprecision::cpp_int;
using test::seed;

using Pixels = std::vector<std::pair<int, int>>;

constexpr auto nowhere = [](ivec2) {};

Pixels sorted(Pixels pixels) {
  std::ranges::sort(pixels);
  return pixels;
}

Pixels drawn(ivec2 center, int radius) {
  Pixels pixels;
  decision_parameter(center, radius, [&](ivec2 p) { pixels.emplace_back(p.x, p.y); });
  return pixels;
}

/// Whether b is the integer nearest to the circle's height in column a: b - 1/2 < sqrt(r² - a²) < b + 1/2.
/// There is no third case: the square of an integer and a half is none.
template <class Integer>
bool nearest(const Integer& radius, const Integer& a, const Integer& b) {
  const Integer squared = 4 * (radius * radius - a * a);
  return squared >= 0 && (b == 0 || (2 * b - 1) * (2 * b - 1) < squared) &&
         squared < (2 * b + 1) * (2 * b + 1);
}

/// A circle by definition: folded into the first octant, the pixel is the nearest one of its column.
template <class Integer>
bool on_circle(ivec2 center, int radius, ivec2 p) {
  const Integer x = abs(Integer(p.x) - center.x), y = abs(Integer(p.y) - center.y);
  return nearest<Integer>(radius, std::min(x, y), std::max(x, y));
}

class Numbers {
 public:
  explicit Numbers(std::uint64_t offset) : random_(seed() + offset) {}

  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  int near(int reach) { return static_cast<int>(below(2 * static_cast<std::uint64_t>(reach) + 1)) - reach; }
  /// Coordinates of every size: small, large, and at the ends of int32.
  int coordinate() {
    switch (below(5)) {
      case 0:
        return near(20);
      case 1:
        return INT_MIN + static_cast<int>(below(50));
      case 2:
        return INT_MAX - static_cast<int>(below(50));
      case 3:
        return near(1 << below(31));
      default:
        return static_cast<int>(static_cast<std::uint32_t>(random_()));
    }
  }
  /// Radii of every size, some of them the largest.
  int radius() {
    if (below(8) == 0) return INT_MAX - static_cast<int>(below(100));
    return static_cast<int>(below(std::uint64_t{1} << (1 + below(31))));
  }

 private:
  std::mt19937_64 random_;
};

/// Asserts the law of every step of a circle.
struct Watch {
  std::int64_t radius;
  std::int64_t& cases;
  std::int64_t& easts;
  std::int64_t& past;
  std::int64_t& same_side;    ///< steps at which E and SE are both outside, or both inside
  std::int64_t midpoint = 0;  ///< the other textbook's parameter: d(x + 1, y - 1/2) - 1/4, from 1 - r on
  ivec2 at{0, 0};
  int phase = 0;  ///< of the grammar Started (Compared Stepped)* Finished

  std::int64_t outside(std::int64_t x, std::int64_t y) const { return x * x + y * y - radius * radius; }

  void operator()(const Started& s) {
    EXPECT_EQ(phase, 0);
    phase = 1;
    EXPECT_EQ(s.p, 3 - 2 * radius);
    at = {0, s.radius};
    midpoint = 1 - radius;
  }
  void operator()(const Compared& c) {
    EXPECT_EQ(phase, 1);
    phase = 2;
    EXPECT_EQ(c.at, at);
    EXPECT_LT(c.at.x, c.at.y);
    // p is d(E) + d(SE) with their signs, whichever side of the circle they are on; odd, so there is no tie
    const std::int64_t e = outside(at.x + 1, at.y), se = outside(at.x + 1, at.y - 1);
    EXPECT_EQ(c.p, e + se);
    EXPECT_NE(c.p % 2, 0);
    EXPECT_LE(std::abs(c.p), 4 * radius + 3);
    EXPECT_EQ(c.east, std::abs(e) < std::abs(se));
    same_side += e < 0 || se > 0;
    EXPECT_EQ(c.p, decision_at(static_cast<int>(radius), at.x, at.y));
    // The midpoint form decides the same, on half the value
    EXPECT_EQ(c.p, 2 * midpoint + 1);
    EXPECT_EQ(c.east, midpoint < 0);
    midpoint += c.east ? 2 * at.x + 3 : 2 * (at.x - at.y) + 5;
    ++cases;
    easts += c.east;
  }
  void operator()(const Stepped& s) {
    EXPECT_EQ(phase, 2);
    phase = 1;
    EXPECT_EQ(s.from(), at);
    EXPECT_EQ(s.at, at + (s.east ? ivec2{1, 0} : ivec2{1, -1}));
    if (s.at.x > s.at.y) {  // past the diagonal: the mirror image of the place before
      EXPECT_EQ(s.at, (ivec2{at.y, at.x}));
      ++past;
    } else {
      EXPECT_EQ(s.at.y, height_at(static_cast<int>(radius), s.at.x));
      EXPECT_TRUE(nearest<std::int64_t>(radius, s.at.x, s.at.y));
    }
    at = s.at;
  }
  void operator()(const Finished& f) {
    EXPECT_EQ(phase, 1);
    phase = 3;
    EXPECT_GE(at.x, at.y);
    EXPECT_EQ(f.pixels, pixel_count(static_cast<int>(radius)));
  }
};

TEST(BresenhamCircleProperty, EveryStepKeepsItsInvariants) {
  std::int64_t cases = 0, easts = 0, past = 0, same_side = 0;
  for (int radius = 0; radius <= 700; ++radius) {
    Watch watch{radius, cases, easts, past, same_side};
    decision_parameter({0, 0}, radius, nowhere, watch);
    EXPECT_EQ(watch.phase, 3);
    ASSERT_FALSE(HasFailure()) << "radius " << radius;
  }
  for (const int radius : {99991, 1000000}) {
    Watch watch{radius, cases, easts, past, same_side};
    decision_parameter({0, 0}, radius, nowhere, watch);
    ASSERT_FALSE(HasFailure()) << "radius " << radius;
  }
  EXPECT_GT(cases, 900000);
  EXPECT_GT(easts, 500000);
  EXPECT_GT(cases - easts, 250000);
  EXPECT_GT(past, 300);
  EXPECT_GT(same_side, 100000);
}

TEST(BresenhamCircleProperty, EveryRadiusTo2000IsTheNearestSet) {
  // G001-14: the worst pixel of all, and the worst of the notes
  std::int64_t pixels = 0;
  double worst = 0, notes_worst = 0;
  int worst_radius = 0, notes_radius = 0, past_diagonal = 0;
  for (int radius = 0; radius <= 2000; ++radius) {
    const Pixels circle = sorted(drawn({0, 0}, radius));
    ASSERT_EQ(std::ranges::adjacent_find(circle), circle.end()) << "twice, radius " << radius;
    ASSERT_EQ(static_cast<std::int64_t>(circle.size()), pixel_count(radius));
    for (const auto& [x, y] : circle) {
      ASSERT_TRUE(on_circle<std::int64_t>({0, 0}, radius, {x, y})) << radius << ": " << x << ' ' << y;
      // Less than half a pixel off along the radius: (2 r - 1)² < 4 (x² + y²) < (2 r + 1)²
      const std::int64_t four = 4 * (std::int64_t{x} * x + std::int64_t{y} * y), r = radius;
      ASSERT_TRUE((r == 0 || (2 * r - 1) * (2 * r - 1) < four) && four < (2 * r + 1) * (2 * r + 1));
      const double error = std::abs(std::sqrt(static_cast<double>(four) / 4) - radius);
      if (error > worst) worst = error, worst_radius = radius;
    }
    pixels += static_cast<std::int64_t>(circle.size());
    if (radius == 0) continue;
    decision_parameter({0, 0}, radius, nowhere, [&]<class Step>(const Step& step) {
      if constexpr (std::same_as<Step, Stepped>) past_diagonal += step.at.x > step.at.y;
    });
    Pixels notes;
    late_update({0, 0}, radius, [&](ivec2 p) {
      ASSERT_LE(std::max(std::abs(p.x), std::abs(p.y)), radius);
      const double error = std::abs(std::sqrt(double{1} * p.x * p.x + double{1} * p.y * p.y) - radius);
      if (error > notes_worst) notes_worst = error, notes_radius = radius;
      notes.emplace_back(p.x, p.y);
    });
    notes = sorted(notes);
    notes.erase(std::unique(notes.begin(), notes.end()), notes.end());
    ASSERT_EQ(notes == circle, radius <= 3) << radius;
  }
  EXPECT_EQ(past_diagonal, 1000);  // E001-06: half of the radii end there
  EXPECT_NEAR(worst, 0.49980625162424985, 1e-12);
  EXPECT_EQ(worst_radius, 1936);
  EXPECT_NEAR(notes_worst, 1.3512336712506112, 1e-12);
  EXPECT_EQ(notes_radius, 1429);
  EXPECT_GT(pixels, 11000000);
}

TEST(BresenhamCircleProperty, SmallCirclesByBruteForce) {
  // Every pixel of the square that belongs to the circle, and none else
  int circles = 0;
  for (int radius = 0; radius <= 80; ++radius) {
    Pixels expected;
    for (int x = -radius - 2; x <= radius + 2; ++x) {
      for (int y = -radius - 2; y <= radius + 2; ++y) {
        if (on_circle<std::int64_t>({0, 0}, radius, {x, y})) expected.emplace_back(x, y);
      }
    }
    ASSERT_EQ(sorted(drawn({0, 0}, radius)), expected) << radius;
    ++circles;
  }
  EXPECT_EQ(circles, 81);
}

TEST(BresenhamCircleProperty, ColumnsByJumpingEqualBigIntegers) {
  Numbers any(1);
  int cases = 0, diagonals = 0;
  for (int i = 0; i < 20000; ++i) {
    const int radius = any.radius();
    const cpp_int r = radius;
    const auto x = static_cast<std::int64_t>(any.below(static_cast<std::uint64_t>(radius) + 1));
    const std::int64_t y = height_at(radius, x);
    ASSERT_TRUE((nearest<cpp_int>(r, x, y))) << seed() << ": " << radius << ' ' << x;
    ASSERT_EQ(cpp_int(square_root(std::int64_t{radius} * x)), cpp_int(sqrt(cpp_int(r * x))));
    // The inverse: no column before is that low, this one is
    const std::int64_t height = any.near(5) + y, first = first_at_most(radius, height);
    if (height >= 0 && first <= radius) ASSERT_LE(height_at(radius, first), height);
    if (first > 0) ASSERT_GT(height_at(radius, std::min<std::int64_t>(first - 1, radius)), height);
    // The last column of an octant: x <= y there, and not in the next
    const std::int64_t last = last_column(radius);
    ASSERT_LE(last, height_at(radius, last));
    if (radius > 0) ASSERT_GT(last + 1, height_at(radius, last + 1));
    diagonals += height_at(radius, last) == last;
    // p for the next test
    const cpp_int e = cpp_int(x + 1) * (x + 1) + cpp_int(y) * y - r * r;
    ASSERT_EQ(cpp_int(decision_at(radius, x, y)), 2 * e - 2 * y + 1);
    ++cases;
  }
  EXPECT_EQ(cases, 20000);
  EXPECT_GT(diagonals, 5000);
}

TEST(BresenhamCircleProperty, WindowShowsExactlyTheUnclippedPixels) {
  Numbers any(2);
  int cases = 0, cut = 0, missed = 0, whole = 0;
  for (int i = 0; i < 20000; ++i) {
    const ivec2 center{any.near(40), any.near(40)};
    const int radius = static_cast<int>(any.below(i % 3 ? 40 : 5));
    const ivec2 a{any.near(60), any.near(60)}, b{any.near(60), any.near(60)};
    const Window window =
        i % 50 ? window_around(a, b) : Window{a, b};  // some inside out, which shows nothing
    const Pixels all = drawn(center, radius);
    Pixels expected, shown;
    for (const auto& [x, y] : all) {
      if (window.contains({x, y})) expected.emplace_back(x, y);
    }
    in_window(center, radius, window, [&](ivec2 p) { shown.emplace_back(p.x, p.y); });
    ASSERT_EQ(sorted(shown), sorted(expected)) << seed() << " case " << i;
    ++cases;
    missed += expected.empty();
    whole += expected.size() == all.size();
    cut += !expected.empty() && expected.size() < all.size();
  }
  EXPECT_EQ(cases, 20000);
  EXPECT_GT(cut, 5000);
  EXPECT_GT(missed, 3000);
  EXPECT_GT(whole, 1000);
}

TEST(BresenhamCircleProperty, WindowOnCirclesOfAnySize) {
  Numbers any(3);
  int shown_circles = 0, missed = 0, beyond = 0, octant_ends = 0;
  for (int i = 0; i < 20000; ++i) {
    const ivec2 center{any.coordinate(), any.coordinate()};
    const int radius = any.radius();
    // A window of at most 24 x 24 round a pixel of the circle; many of them where octants meet
    const Octant octant = octants[any.below(8)];
    const std::int64_t last = last_column(radius);
    const std::int64_t x = i % 3 == 0 ? last - static_cast<std::int64_t>(any.below(3))
                           : i % 3 == 1
                               ? static_cast<std::int64_t>(any.below(3))
                               : static_cast<std::int64_t>(any.below(static_cast<std::uint64_t>(last) + 1));
    const std::int64_t column = std::clamp<std::int64_t>(x, 0, last), height = height_at(radius, column);
    const auto bounded = [](std::int64_t v) {
      return static_cast<int>(std::clamp<std::int64_t>(v, INT_MIN, INT_MAX));
    };
    const std::int64_t at_x = center.x + column * octant.right.x + height * octant.up.x;
    const std::int64_t at_y = center.y + column * octant.right.y + height * octant.up.y;
    const auto some = [&any] { return static_cast<std::int64_t>(any.below(12)); };
    const Window window{{bounded(at_x - some()), bounded(at_y - some())},
                        {bounded(at_x + some()), bounded(at_y + some())}};
    // By definition, in 128 bits or more
    Pixels expected, shown;
    for (std::int64_t cx = window.lower.x; cx <= window.upper.x; ++cx) {
      for (std::int64_t cy = window.lower.y; cy <= window.upper.y; ++cy) {
        const ivec2 p{static_cast<int>(cx), static_cast<int>(cy)};
        if (on_circle<boost::multiprecision::int128_t>(center, radius, p)) expected.emplace_back(p.x, p.y);
      }
    }
    std::int64_t told = -1;
    in_window(
        center, radius, window, [&](ivec2 p) { shown.emplace_back(p.x, p.y); },
        [&]<class Step>(const Step& step) {
          if constexpr (std::same_as<Step, Finished>) told = step.pixels;
          if constexpr (std::same_as<Step, Compared>) {
            ASSERT_EQ(step.p, decision_at(radius, step.at.x, step.at.y));
          }
        });
    ASSERT_EQ(sorted(shown), expected)
        << seed() << " case " << i << ": " << center.x << ',' << center.y << " radius " << radius;
    ASSERT_EQ(told, static_cast<std::int64_t>(shown.size()));
    (shown.empty() ? missed : shown_circles)++;
    beyond += !fits_plane(center, radius);
    octant_ends += column >= last - 1 && last > 100;
  }
  EXPECT_GT(shown_circles, 10000);
  EXPECT_GT(missed, 1000);
  EXPECT_GT(beyond, 5000);
  EXPECT_GT(octant_ends, 2000);
}

TEST(BresenhamCircleProperty, DrawingIsThePixelsOfTheTaughtMethod) {
  Numbers any(4);
  int cases = 0, cut = 0, whole = 0;
  for (int i = 0; i < 20000; ++i) {
    Raster<std::uint8_t> raster(60 + static_cast<int>(any.below(30)), 50), expected(raster.width(), 50);
    const ivec2 center{any.near(120), any.near(120)};
    const int radius = static_cast<int>(any.below(i % 3 ? 25 : 150));
    draw(raster, center, radius, std::uint8_t{1});
    std::int64_t inside = 0;
    decision_parameter(center, radius, [&](ivec2 p) {
      if (!expected.contains(p)) return;
      expected[p] = 1;
      ++inside;
    });
    ASSERT_EQ(raster, expected) << seed() << " case " << i;
    ++cases;
    whole += inside == pixel_count(radius);
    cut += inside > 0 && inside < pixel_count(radius);
  }
  EXPECT_EQ(cases, 20000);
  EXPECT_GT(cut, 1500);
  EXPECT_GT(whole, 300);
  // Beyond the plane: the pixels of in_window
  int large = 0;
  for (int i = 0; i < 2000; ++i) {
    Raster<std::uint8_t> raster(60, 50), expected(60, 50);
    const int radius = any.radius();
    const ivec2 center{any.coordinate(), any.coordinate()};
    // Half of them pass through the raster
    const ivec2 moved = i % 2 ? center : ivec2{static_cast<int>(any.below(60)) - radius, any.near(60)};
    draw(raster, moved, radius, std::uint8_t{1});
    in_window(moved, radius, expected.window(), [&](ivec2 p) { expected[p] = 1; });
    ASSERT_EQ(raster, expected) << seed() << " case " << i;
    large += std::ranges::count(raster.cells(), 1) > 0;
  }
  EXPECT_GT(large, 500);
}

}  // namespace
}  // namespace gradus::bresenham_circle
