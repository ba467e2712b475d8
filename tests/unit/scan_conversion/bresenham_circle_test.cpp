#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/record.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_batch.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_notes.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_window.hpp"
#include "stress/scan_conversion/nearest_pixels.hpp"
#include "support/sanitized.hpp"

namespace gradus::bresenham_circle {
namespace {

using Pixels = std::vector<std::pair<int, int>>;
using PixelSet = std::set<std::pair<int, int>>;
using CircleRecorder = Recorder<Started, Compared, Stepped, Finished>;

/// Collects what is plotted.
struct Plotter {
  Pixels& pixels;
  void operator()(ivec2 p) const { pixels.emplace_back(p.x, p.y); }
};

constexpr auto nowhere = [](ivec2) {};

Pixels drawn(ivec2 center, int radius) {
  Pixels pixels;
  decision_parameter(center, radius, Plotter{pixels});
  return pixels;
}

Pixels drawn_in(ivec2 center, int radius, const Window& window) {
  Pixels pixels;
  in_window(center, radius, window, Plotter{pixels});
  return pixels;
}

Pixels drawn_late(int radius) {
  Pixels pixels;
  late_update({0, 0}, radius, Plotter{pixels});
  return pixels;
}

Pixels sorted(Pixels pixels) {
  std::ranges::sort(pixels);
  return pixels;
}
PixelSet as_set(const Pixels& pixels) { return {pixels.begin(), pixels.end()}; }

/// Where the octant stands, step by step.
Pixels places(const CircleRecorder& seen) {
  Pixels found{{0, all<Started>(seen).at(0).radius}};
  for (const Stepped& step : all<Stepped>(seen)) found.emplace_back(step.at.x, step.at.y);
  return found;
}

Pixels octant(int radius) {
  CircleRecorder seen;
  decision_parameter({0, 0}, radius, nowhere, seen);
  return places(seen);
}

Pixels late_octant(int radius) {
  CircleRecorder seen;
  late_update({0, 0}, radius, nowhere, seen);
  return places(seen);
}

double radial_error(const Pixels& pixels, int radius) {
  double worst = 0;
  for (const auto& [x, y] : pixels) {
    worst = std::max(worst, stress::off_circle({0, 0}, radius, {x, y}));
  }
  return worst;
}

TEST(BresenhamCircle, GoldenOctants) {
  // G001-10 to G001-13; the last place lies past the diagonal where x > y
  EXPECT_EQ(octant(5), (Pixels{{0, 5}, {1, 5}, {2, 5}, {3, 4}, {4, 3}}));
  EXPECT_EQ(octant(8), (Pixels{{0, 8}, {1, 8}, {2, 8}, {3, 7}, {4, 7}, {5, 6}, {6, 5}}));
  EXPECT_EQ(octant(10), (Pixels{{0, 10}, {1, 10}, {2, 10}, {3, 10}, {4, 9}, {5, 9}, {6, 8}, {7, 7}}));
  EXPECT_EQ(octant(16), (Pixels{{0, 16},
                                {1, 16},
                                {2, 16},
                                {3, 16},
                                {4, 15},
                                {5, 15},
                                {6, 15},
                                {7, 14},
                                {8, 14},
                                {9, 13},
                                {10, 12},
                                {11, 12},
                                {12, 11}}));
  EXPECT_NEAR(radial_error(drawn({0, 0}, 5), 5), 0.38516480713450374, 1e-12);
  EXPECT_NEAR(radial_error(drawn({0, 0}, 8), 8), 0.38422689413609135, 1e-12);
  EXPECT_NEAR(radial_error(drawn({0, 0}, 10), 10), 0.4403065089105507, 1e-12);
  EXPECT_NEAR(radial_error(drawn({0, 0}, 16), 16), 0.4758253037399758, 1e-12);
}

TEST(BresenhamCircle, SmallestCircles) {
  EXPECT_EQ(drawn({7, -2}, 0), (Pixels{{7, -2}}));
  EXPECT_EQ(drawn({0, 0}, 1), (Pixels{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}));
  EXPECT_EQ(drawn({0, 0}, 2).size(), 12u);
  EXPECT_EQ(drawn({3, 4}, 2).front(), (std::pair{3, 6}));
}

TEST(BresenhamCircle, EachPixelOnce) {
  // G001-15: eight calls per place against the pixels there are
  const int radii[] = {0, 1, 5, 10};
  const std::size_t calls[] = {8, 16, 40, 64}, distinct[] = {1, 4, 28, 56};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(8 * octant(radii[i]).size(), calls[i]);
    const Pixels pixels = drawn({0, 0}, radii[i]);
    EXPECT_EQ(pixels.size(), distinct[i]);
    EXPECT_EQ(as_set(pixels).size(), distinct[i]);
    EXPECT_EQ(pixel_count(radii[i]), static_cast<std::int64_t>(distinct[i]));
  }
}

/// A sanitizer takes thirty times as long: there all radii are drawn, and one in 16 is judged.
bool judged(int radius) { return !test::sanitized || radius % 16 == 0; }

TEST(BresenhamCircle, EveryRadiusTo2000IsTheNearestSet) {
  // G001-14: the worst pixel of all, and the worst of the notes
  double worst = 0, notes_worst = 0;
  int worst_radius = 0, notes_radius = 0, past_diagonal = 0;
  for (int radius = 0; radius <= 2000; ++radius) {
    Pixels circle = drawn({0, 0}, radius);
    ASSERT_EQ(static_cast<std::int64_t>(circle.size()), pixel_count(radius));
    decision_parameter({0, 0}, radius, nowhere, [&]<class Step>(const Step& step) {
      if constexpr (std::same_as<Step, Stepped>) past_diagonal += step.at.x > step.at.y;
    });
    if (!judged(radius) && radius != 1429) continue;
    circle = sorted(std::move(circle));
    ASSERT_EQ(std::ranges::adjacent_find(circle), circle.end()) << "twice, radius " << radius;
    for (const auto& [x, y] : circle) {
      ASSERT_TRUE(stress::on_circle({0, 0}, radius, {x, y})) << radius << ": " << x << ' ' << y;
    }
    const double off = radial_error(circle, radius);
    if (off > worst) worst = off, worst_radius = radius;
    if (radius == 0) continue;
    Pixels notes = sorted(drawn_late(radius));
    const double notes_off = radial_error(notes, radius);
    if (notes_off > notes_worst) notes_worst = notes_off, notes_radius = radius;
    notes.erase(std::unique(notes.begin(), notes.end()), notes.end());
    ASSERT_EQ(notes == circle, radius <= 3) << radius;
    ASSERT_LE(notes.back().first, radius);
  }
  EXPECT_EQ(past_diagonal, 1000);  // E001-06: half of the radii end there
  EXPECT_NEAR(worst, 0.49980625162424985, 1e-12);
  EXPECT_EQ(worst_radius, 1936);
  EXPECT_NEAR(notes_worst, 1.3512336712506112, 1e-12);
  EXPECT_EQ(notes_radius, 1429);
}

TEST(BresenhamCircle, StepsFollowTheGrammarAndTheRecurrence) {
  CircleRecorder seen;
  decision_parameter({2, 1}, 8, nowhere, seen);
  ASSERT_EQ(seen.events().size(), 14u);
  // By hand on the topic's page: p = -13, E, -7, E, 3, SE, -11, E, 7, SE, 5, SE
  const std::pair<std::int64_t, bool> values[] = {{-13, true}, {-7, true}, {3, false},
                                                  {-11, true}, {7, false}, {5, false}};
  const auto compared = all<Compared>(seen);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(compared.at(i).p, values[i].first);
    EXPECT_EQ(compared.at(i).east, values[i].second);
  }
  EXPECT_EQ(all<Finished>(seen).at(0).pixels, 44);
}

TEST(BresenhamCircle, MistakesAreNamed) {
  EXPECT_THROW(decision_parameter({0, 0}, -1, nowhere), ContractViolation);
  EXPECT_THROW(in_window({0, 0}, -1, {{0, 0}, {9, 9}}, nowhere), ContractViolation);
  EXPECT_THROW(late_update({0, 0}, -1, nowhere), ContractViolation);
  Raster<char> raster(9, 9);
  EXPECT_THROW(draw(raster, {4, 4}, -1, 'x'), ContractViolation);
  // Nothing is bent back into the plane
  EXPECT_THROW(decision_parameter({INT_MAX - 4, 0}, 5, nowhere), ContractViolation);
  EXPECT_THROW(decision_parameter({0, INT_MIN + 4}, 5, nowhere), ContractViolation);
  EXPECT_THROW(late_update({0, INT_MIN + 4}, 5, nowhere), ContractViolation);
  EXPECT_NO_THROW(decision_parameter({INT_MAX - 5, INT_MIN + 5}, 5, nowhere));
  try {
    decision_parameter({INT_MAX, 0}, 5, nowhere);
    FAIL();
  } catch (const ContractViolation& mistake) {
    EXPECT_STREQ(mistake.what(), "the circle round (2147483647, 0) with radius 5 leaves int32");
  }
}

TEST(BresenhamCircle, WindowOnTheLargestCircles) {
  // The whole circle, round the middle of the plane: its four ends, and nothing between
  const int most = INT_MAX;
  EXPECT_EQ(drawn_in({0, 0}, most, {{-1, most}, {1, most}}), (Pixels{{0, most}, {1, most}, {-1, most}}));
  EXPECT_EQ(drawn_in({0, 0}, most, {{-most, 0}, {-most, 0}}), (Pixels{{-most, 0}}));
  // A circle that comes back into the plane from beyond it would be a wrapped one
  EXPECT_TRUE(drawn_in({INT_MAX, INT_MAX}, most, {{INT_MIN, INT_MIN}, {-1, -1}}).empty());
}

TEST(BresenhamCircle, WhereInt32WouldOverflow) {
  // The first SE step of a radius has the lowest increment of all: y falls when x reaches first_at_most - 1
  const auto first_increment = [](int radius) {
    return 4 * (first_at_most(radius, radius - 1) - 1 - std::int64_t{radius}) + 10;
  };
  EXPECT_GE(first_increment(536894084), INT_MIN);
  EXPECT_LT(first_increment(536894085), INT_MIN);
  EXPECT_GE(3 - 2 * std::int64_t{1073741825}, INT_MIN);
  EXPECT_LT(3 - 2 * std::int64_t{1073741826}, INT_MIN);
  // Ours at that radius: by jumping, and the first step by hand
  Recorder<Started, Jumped, Compared, Stepped, Finished> seen;
  in_window({0, 0}, INT_MAX, {{0, INT_MAX}, {1, INT_MAX}}, nowhere, seen);
  EXPECT_EQ(all<Started>(seen).at(0).p, -4294967291);
  EXPECT_EQ(all<Stepped>(seen).at(0).p, -4294967285);
}

TEST(BresenhamCircle, DrawsManyCircles) {
  Raster<char> raster(20, 10, '.');
  const std::vector<Circle<int>> circles{{{4, 4}, 4}, {{INT_MIN + 19, 3}, INT_MAX}};
  draw(raster, circles, 'x');
  EXPECT_EQ((raster[{4, 8}]), 'x');
  EXPECT_EQ((raster[{18, 3}]), 'x');
  EXPECT_EQ((raster[{19, 3}]), '.');
  Raster<char> none;
  draw(none, {0, 0}, 3, '#');
  EXPECT_EQ(none.cells().size(), 0u);
}

TEST(BresenhamCircleNotes, LateUpdateLeavesTheCircle) {
  // E001-05 with G001-10 to G001-13: the notes' octants are not ours
  EXPECT_EQ(late_octant(5), (Pixels{{0, 5}, {1, 5}, {2, 4}, {3, 3}}));
  EXPECT_EQ(late_octant(8), (Pixels{{0, 8}, {1, 8}, {2, 8}, {3, 7}, {4, 6}, {5, 5}}));
  EXPECT_EQ(late_octant(10), (Pixels{{0, 10}, {1, 10}, {2, 10}, {3, 9}, {4, 9}, {5, 8}, {6, 7}, {7, 6}}));
  EXPECT_EQ(late_octant(16), (Pixels{{0, 16},
                                     {1, 16},
                                     {2, 16},
                                     {3, 16},
                                     {4, 15},
                                     {5, 15},
                                     {6, 14},
                                     {7, 14},
                                     {8, 13},
                                     {9, 12},
                                     {10, 11},
                                     {11, 10}}));
  EXPECT_NEAR(radial_error(drawn_late(5), 5), 0.7573593128807152, 1e-12);
  EXPECT_NEAR(radial_error(drawn_late(8), 8), 0.9289321881345245, 1e-12);
  EXPECT_NEAR(radial_error(drawn_late(10), 10), 0.7804555427071129, 1e-12);
  EXPECT_NEAR(radial_error(drawn_late(16), 16), 1.133931252681494, 1e-12);
  // The radii that come out right, and the first that does not
  for (const int radius : {0, 1, 2, 3}) EXPECT_EQ(as_set(drawn_late(radius)), as_set(drawn({0, 0}, radius)));
  EXPECT_NE(as_set(drawn_late(4)), as_set(drawn({0, 0}, 4)));
}

TEST(BresenhamCircleNotes, LateUpdateByTheNumbersOfItsSteps) {
  // With the new values 4 x + 2 and 4 (x - y) + 2 would be right: it adds 4 and 8 too much
  CircleRecorder seen;
  late_update({0, 0}, 50, nowhere, seen);
  EXPECT_TRUE(every<Stepped>(seen, [](const Stepped& s) {
    const std::int64_t right = s.east ? 4 * s.at.x + 2 : 4 * (s.at.x - s.at.y) + 2;
    return s.p - s.p_before == right + (s.east ? 4 : 8);
  }));
}

/// The pixels that are set, sorted, each with how often.
std::vector<std::pair<std::pair<int, int>, int>> times_set(int radius) {
  Pixels pixels;
  eight_plots({0, 0}, radius, Plotter{pixels});
  std::ranges::sort(pixels);
  std::vector<std::pair<std::pair<int, int>, int>> times;
  for (const auto& pixel : pixels) {
    if (times.empty() || times.back().first != pixel) times.push_back({pixel, 0});
    ++times.back().second;
  }
  return times;
}

TEST(BresenhamCircleNotes, EightPlotsSetExactlyTheSharedPixelsAgain) {
  // E001-06: the right circle; what its two octants share is set by both
  int past_the_diagonal = 0;
  for (int radius = 1; radius <= 2000; ++radius) {
    const Pixels walked = octant(radius);
    const auto [last_x, last_y] = walked.back();
    past_the_diagonal += last_x > last_y;
    if (!judged(radius)) continue;
    const auto times = times_set(radius);
    const Pixels once = sorted(drawn({0, 0}, radius));
    ASSERT_TRUE(std::ranges::equal(once, times, {}, {}, [](const auto& set) { return set.first; })) << radius;
    for (const auto& [pixel, count] : times) {
      const int x = std::abs(pixel.first), y = std::abs(pixel.second);
      const bool shared = x == 0 || y == 0 || x == y;
      const bool past = last_x > last_y && std::max(x, y) == last_x && std::min(x, y) == last_y;
      ASSERT_EQ(count, (shared ? 2 : 1) * (past ? 2 : 1)) << radius << ": " << x << ", " << y;
    }
  }
  EXPECT_EQ(past_the_diagonal, 1000);
}

TEST(BresenhamCircleNotes, EightPlotsInNumbers) {
  const auto plots = [](int radius) {
    int count = 0;
    for (const auto& [pixel, times] : times_set(radius)) count += times;
    return count;
  };
  EXPECT_EQ(plots(10), 64);
  EXPECT_EQ(drawn({0, 0}, 10).size(), 56u);
  EXPECT_EQ(plots(0), 8);
  EXPECT_EQ(drawn({0, 0}, 0).size(), 1u);
  CircleRecorder seen;
  eight_plots({0, 0}, 10, nowhere, seen);
  EXPECT_EQ(all<Finished>(seen).at(0).pixels, 64);
  EXPECT_EQ(places(seen), octant(10)) << "the right places";
}

TEST(BresenhamCircleNotes, EightPlotsAPlaceRepeatPixels) {
  // E001-06, in the listing as printed
  EXPECT_EQ(drawn_late(0).size(), 8u);
  EXPECT_EQ(as_set(drawn_late(0)).size(), 1u);
  EXPECT_EQ(drawn_late(1).size(), 16u);
  EXPECT_EQ(as_set(drawn_late(1)).size(), 4u);
  CircleRecorder seen;
  late_update({0, 0}, 9, nowhere, seen);
  EXPECT_EQ(all<Finished>(seen).at(0).pixels, static_cast<std::int64_t>(drawn_late(9).size()));
}

// The whole circle is known at compile time where a caller wants that.
constexpr int pixels_at_compile_time() {
  int count = 0;
  decision_parameter({0, 0}, 5, [&](ivec2) { ++count; });
  in_window({0, 0}, 5, {{-9, -9}, {9, 9}}, [&](ivec2) { ++count; });
  return count;
}
static_assert(pixels_at_compile_time() == 2 * 28);
static_assert(pixel_count(INT_MAX) == 12148001996);

}  // namespace
}  // namespace gradus::bresenham_circle
