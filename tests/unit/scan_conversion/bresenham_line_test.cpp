#include "scan_conversion/bresenham_line/bresenham_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

#include "core/record.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_batch.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_notes.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_window.hpp"
#include "stress/scan_conversion/nearest_pixels.hpp"
#include "support/sanitized.hpp"

namespace gradus::bresenham_line {
namespace {

using Pixels = std::vector<std::pair<int, int>>;

/// Collects what is plotted.
struct Plotter {
  Pixels& pixels;
  void operator()(ivec2 p) const { pixels.emplace_back(p.x, p.y); }
};

Pixels drawn(ivec2 from, ivec2 to) {
  Pixels pixels;
  decision_parameter(from, to, Plotter{pixels});
  return pixels;
}

std::set<std::pair<int, int>> as_set(const Pixels& pixels) { return {pixels.begin(), pixels.end()}; }

TEST(BresenhamLine, GoldenLines) {
  EXPECT_EQ(drawn({0, 0}, {5, 2}), (Pixels{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}}));  // G001-01
  EXPECT_EQ(drawn({0, 0}, {4, -2}), (Pixels{{0, 0}, {1, -1}, {2, -1}, {3, -2}, {4, -2}}));     // G001-02
  EXPECT_EQ(drawn({0, 4}, {0, 0}), (Pixels{{0, 4}, {0, 3}, {0, 2}, {0, 1}, {0, 0}}));          // G001-04
  EXPECT_EQ(drawn({3, 3}, {3, 3}), (Pixels{{3, 3}}));                                          // G001-07
  EXPECT_EQ(drawn({0, 0}, {7, 3}), (Pixels{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}, {6, 3}, {7, 3}}));
}

TEST(BresenhamLine, MidwayTheSmallerCoordinateIsTaken) {
  // These goldens record the notes' rule, aside along the ascending axis; ours goes by place.
  // G001-03 has (1,1) and (2,3)
  EXPECT_EQ(drawn({0, 0}, {2, 4}), (Pixels{{0, 0}, {0, 1}, {1, 2}, {1, 3}, {2, 4}}));
  // G001-05 has (1,1)
  EXPECT_EQ(drawn({2, 1}, {0, 0}), (Pixels{{2, 1}, {1, 0}, {0, 0}}));
  // G001-06 has (-1,0)
  EXPECT_EQ(drawn({0, 0}, {-2, -1}), (Pixels{{0, 0}, {-1, -1}, {-2, -1}}));
  EXPECT_EQ(drawn({0, 0}, {-2, 1}), (Pixels{{0, 0}, {-1, 0}, {-2, 1}}));
  EXPECT_EQ(drawn({0, 0}, {2, -1}), (Pixels{{0, 0}, {1, -1}, {2, -1}}));
  // Steep: the smaller x
  EXPECT_EQ(drawn({0, 0}, {1, 2}), (Pixels{{0, 0}, {0, 1}, {1, 2}}));
  EXPECT_EQ(drawn({0, 0}, {-1, 2}), (Pixels{{0, 0}, {-1, 1}, {-1, 2}}));
  EXPECT_EQ(drawn({0, 0}, {-1, -2}), (Pixels{{0, 0}, {-1, -1}, {-1, -2}}));
  // E001-04: no tie breaks the symmetry of the two directions
  EXPECT_EQ(as_set(drawn({0, 0}, {-2, -1})), as_set(drawn({-2, -1}, {0, 0})));
}

TEST(BresenhamLine, EveryLineOfASmallSquare) {
  int ties = 0;
  for (int i = 0; i < 25 * 25; ++i) {
    const ivec2 to{i % 25 - 12, i / 25 - 12};
    const int longer = std::max(std::abs(to.x), std::abs(to.y));
    const Pixels pixels = drawn({0, 0}, to);
    ASSERT_EQ(pixels.size(), static_cast<std::size_t>(longer + 1));
    EXPECT_EQ(pixels.back(), (std::pair{to.x, to.y}));
    for (const auto& [x, y] : pixels) {
      // At most half a pixel off
      const int off = 2 * std::abs(to.x * y - to.y * x);
      ASSERT_LE(off, longer) << to.x << ' ' << to.y;
      ties += longer > 0 && off == longer;
    }
    Pixels back = drawn(to, {0, 0});
    std::reverse(back.begin(), back.end());
    EXPECT_EQ(back, pixels) << to.x << ' ' << to.y;
  }
  EXPECT_GT(ties, 400);
}

TEST(BresenhamLine, StepsFollowTheGrammarAndTheRecurrence) {
  Recorder<Started, Compared, Stepped, Finished> seen;
  Pixels pixels;
  decision_parameter({0, 0}, {5, 2}, Plotter{pixels}, seen);
  ASSERT_EQ(seen.events().size(), 2u + 2u * 5u);
  const auto& start = std::get<Started>(seen.events().front().step);
  EXPECT_EQ(start.p, -1);  // G001-09
  EXPECT_EQ(start.dx, 5);
  EXPECT_EQ(start.dy, 2);
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).pixels, 6);
  const auto stepped = all<Stepped>(seen);
  ASSERT_EQ(stepped.size(), 5u);
  EXPECT_EQ(stepped[0].p, 3);  // after E: 4 dy - dx, not the notes' -2 (E001-01)
  EXPECT_EQ(stepped[0].p_before + 2 * (start.dy - start.dx), -7);  // after NE: 4 dy - 3 dx, not -12 (E001-02)
}

TEST(BresenhamLine, PixelNumbersOutsideTheLineAreRefused) {
  EXPECT_THROW(pixel_at({0, 0}, {5, 2}, -1), ContractViolation);
  EXPECT_THROW(pixel_at({0, 0}, {5, 2}, 6), ContractViolation);
  EXPECT_EQ(pixel_at({4, 4}, {4, 4}, 0), (ivec2{4, 4}));
}

TEST(BresenhamLine, RunsHaveThreeLengths) {
  std::vector<std::int64_t> counts;
  run_length({0, 0}, {14, 3}, [&](ivec2, std::int64_t count) { counts.push_back(count); });
  EXPECT_EQ(counts, (std::vector<std::int64_t>{3, 5, 4, 3}));
  std::int64_t longest = 0;
  run_length({INT_MIN, 3}, {INT_MAX, 3}, [&](ivec2, std::int64_t count) { longest = count; });
  EXPECT_EQ(longest, std::int64_t{1} << 32);
  Recorder<RunsStarted, RunEmitted, Finished> seen;
  run_length({0, 0}, {14, 3}, [](ivec2, std::int64_t) {}, seen);
  EXPECT_EQ(seen.events().size(), 6u);
  EXPECT_EQ(all<RunsStarted>(seen).at(0).shortest, 4);
  EXPECT_EQ(all<Finished>(seen).at(0).pixels, 15);
}

TEST(BresenhamLine, DrawsManyLines) {
  Raster<char> raster(20, 10, '.');
  const std::vector<Segment<2, int>> segments{{{0, 9}, {19, 9}}, {{INT_MIN, INT_MIN}, {INT_MAX, INT_MAX}}};
  draw(raster, segments, 'x');
  EXPECT_EQ((raster[{0, 9}]), 'x');
  EXPECT_EQ((raster[{19, 9}]), 'x');
  EXPECT_EQ((raster[{7, 7}]), 'x');
  Raster<char> none;
  draw(none, {0, 0}, {5, 5}, '#');
  EXPECT_EQ(none.cells().size(), 0u);
}

/// Number of the first pixel that dda draws in another place, and -1 for none.
template <class T>
std::int64_t first_wrong(ivec2 to, ivec2* end = nullptr) {
  std::int64_t k = 0, wrong = -1;
  dda<T>({0, 0}, to, [&](ivec2 pixel) {
    if (wrong < 0 && pixel != stress::pixel_of_line({0, 0}, to, k)) wrong = k;
    if (end) *end = pixel;
    ++k;
  });
  return wrong;
}

/// The least dx, of 1, 1 + step, ..., of a line on which floats err.
int first_length_wrong(int step) {
  for (int dx = 1;; dx += step) {
    for (int dy = 0; dy <= dx; ++dy) {
      if (first_wrong<float>({dx, dy}) >= 0) return dx;
    }
  }
}

TEST(BresenhamLine, WhereDdaFirstGoesWrong) {
  // The exhibits of docs/topics/scan_conversion/bresenham_line.md
  if (!test::sanitized) {  // all shorter lines: 11 million pixels
    EXPECT_EQ(first_length_wrong(1), 12);
    EXPECT_EQ(first_length_wrong(2), 359);  // midway only exists for even dx
  }
  EXPECT_EQ(first_wrong<float>({12, 10}), 9);
  EXPECT_EQ(first_wrong<float>({359, 349}), 341);
  ivec2 end{};
  EXPECT_EQ(first_wrong<float>({1000000, 618034}, &end), 305);
  EXPECT_EQ(end, (ivec2{1000000, 623366}));
  EXPECT_EQ(end.y - 618034, 5332);
  EXPECT_EQ(first_wrong<double>({1000000, 618034}, &end), 250000);
  EXPECT_EQ(end, (ivec2{1000000, 618034}));
  // From 2^23 on, adding 1/2 to a float of 8,388,608 changes nothing: the line stops climbing
  EXPECT_EQ(first_wrong<float>({20000000, 10000000}, &end), 16777218);
  EXPECT_EQ(end, (ivec2{20000000, 8388608}));
}

TEST(BresenhamLine, DdaStepsShowTheRounding) {
  Recorder<Divided<float>, Added<float>, Rounded<float>, Finished> seen;
  dda<float>({0, 0}, {7, 3}, [](ivec2) {}, seen);
  ASSERT_EQ(seen.events().size(), 2u + 2u * 7u);
  EXPECT_EQ(all<Divided<float>>(seen).at(0).slope, 3.0F / 7.0F);
  EXPECT_TRUE(
      every<Added<float>>(seen, [](const Added<float>& a) { return a.offset == a.before + 3.0F / 7.0F; }));
  EXPECT_EQ(all<Rounded<float>>(seen).at(6).pixel, (ivec2{7, 3}));
}

TEST(BresenhamLine, DdaRefusesLinesWithoutRoomToStray) {
  EXPECT_THROW(dda({0, INT_MAX - 3}, {7, INT_MAX}, [](ivec2) {}), ContractViolation);
  EXPECT_THROW(dda({0, INT_MIN + 3}, {7, INT_MIN}, [](ivec2) {}), ContractViolation);
  EXPECT_NO_THROW(dda({0, INT_MAX - 7}, {7, INT_MAX - 3}, [](ivec2) {}));
  EXPECT_NO_THROW(dda({INT_MAX, 0}, {INT_MAX, 7}, [](ivec2) {}));
}

TEST(BresenhamLineNotes, FirstListingLeavesItsEndPoint) {
  const auto first = [](ivec2 from, ivec2 to) {
    Pixels pixels;
    first_octant(from, to, Plotter{pixels});
    return pixels;
  };
  // G001-08
  EXPECT_EQ(first({0, 0}, {4, -2}), (Pixels{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}));
  EXPECT_EQ(first({0, 0}, {2, 4}), (Pixels{{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_EQ(first({0, 0}, {0, 4}), (Pixels{{0, 0}}));
  // Right where it says so
  EXPECT_EQ(first({0, 0}, {5, 2}), drawn({0, 0}, {5, 2}));
  Recorder<Started, Compared, Stepped, Finished> seen;
  first_octant({0, 0}, {5, 2}, [](ivec2) {}, seen);
  EXPECT_EQ(seen.events().size(), 12u);
}

TEST(BresenhamLineNotes, MisprintedDerivationFallsBehindByDxAStep) {
  // E001-01 and E001-02: what the notes print for p after one step, and what follows from their own tests,
  // 2 dy < dx - 2 dy after E and 2 dy - dx < 2 dx - 2 dy after NE
  const auto printed = [](int dx, int dy, bool straight) { return 4 * dy - (straight ? 2 : 4) * dx; };
  const auto derived = [](int dx, int dy, bool straight) { return 4 * dy - (straight ? 1 : 3) * dx; };
  EXPECT_EQ(printed(5, 2, true), -2);
  EXPECT_EQ(derived(5, 2, true), 3);
  EXPECT_EQ(printed(5, 2, false), -12);
  EXPECT_EQ(derived(5, 2, false), -7);
  int after_e = 0, after_ne = 0;
  for (int dx = 1; dx <= 24; ++dx) {
    for (int dy = 0; dy <= dx; ++dy) {
      Recorder<Started, Compared, Stepped, Finished> wrong, right;
      misprinted_derivation({0, 0}, {dx, dy}, [](ivec2) {}, wrong);
      decision_parameter({0, 0}, {dx, dy}, [](ivec2) {}, right);
      const Stepped* bad = std::get_if<Stepped>(&wrong.events()[2].step);
      const Stepped* good = std::get_if<Stepped>(&right.events()[2].step);
      ASSERT_TRUE(bad && good);
      EXPECT_EQ(bad->straight, good->straight);
      EXPECT_EQ(bad->p, printed(dx, dy, bad->straight));
      EXPECT_EQ(good->p, derived(dx, dy, good->straight));
      ++(bad->straight ? after_e : after_ne);
    }
  }
  EXPECT_GT(after_e, 100);
  EXPECT_GT(after_ne, 100);
  const auto misprinted = [](ivec2 from, ivec2 to) {
    Pixels pixels;
    misprinted_derivation(from, to, Plotter{pixels});
    return pixels;
  };
  EXPECT_EQ(misprinted({0, 0}, {5, 2}), (Pixels{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}));
  EXPECT_EQ(misprinted({0, 0}, {5, 3}), (Pixels{{0, 0}, {1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}}));
  EXPECT_EQ(misprinted({2, 3}, {0, -2}), (Pixels{{2, 3}, {2, 2}, {2, 1}, {2, 0}, {2, -1}, {2, -2}}));
  EXPECT_EQ(misprinted({-3, 4}, {4, 4}), drawn({-3, 4}, {4, 4}));
  EXPECT_THROW(misprinted_derivation({INT_MIN, 0}, {0, 0}, [](ivec2) {}), ContractViolation);
}

TEST(BresenhamLineNotes, SecondListingSwapsAndWraps) {
  const auto second = [](ivec2 from, ivec2 to, std::size_t most) {
    Pixels pixels;
    struct Enough {};
    try {
      swapped_ends(from, to, [&](ivec2 p) {
        pixels.emplace_back(p.x, p.y);
        if (pixels.size() == most) throw Enough{};
      });
    } catch (const Enough&) {
    }
    return pixels;
  };
  EXPECT_EQ(second({0, 0}, {4, -2}, 99), (Pixels{{0, 0}, {1, -1}, {2, -1}, {3, -2}, {4, -2}}));  // G001-02
  EXPECT_EQ(second({0, 0}, {2, 4}, 99), (Pixels{{0, 0}, {1, 1}, {1, 2}, {2, 3}, {2, 4}}));       // G001-03
  EXPECT_EQ(second({0, 4}, {0, 0}, 99), (Pixels{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}}));       // G001-04
  EXPECT_EQ(second({2, 1}, {0, 0}, 99), (Pixels{{0, 0}, {1, 1}, {2, 1}}));                       // G001-05
  EXPECT_EQ(second({0, 0}, {-2, -1}, 99), (Pixels{{-2, -1}, {-1, 0}, {0, 0}}));                  // G001-06
  EXPECT_EQ(second({3, 3}, {3, 3}, 99), (Pixels{{3, 3}}));                                       // G001-07
  // One wrap, one wrong turn: the line passes (5, 2/3)
  const ivec2 far{1500000000, 200000000};
  EXPECT_EQ(second({0, 0}, far, 6).back(), (std::pair{5, 2}));
  EXPECT_EQ(pixel_at({0, 0}, far, 5), (ivec2{5, 1}));
  // A dx that does not fit
  EXPECT_EQ(second({-1500000000, -1}, {1500000000, 1}, 2).back(), (std::pair{-1499999999, 0}));
  // Wrapped increments alone do no harm
  const auto lucky = second({0, 0}, {1500000000, 1200000000}, 1000);
  for (std::size_t k = 0; k < lucky.size(); ++k) {
    const ivec2 p = pixel_at({0, 0}, {1500000000, 1200000000}, static_cast<std::int64_t>(k));
    ASSERT_EQ(lucky[k], (std::pair{p.x, p.y}));
  }
}

// The whole line is known at compile time where a caller wants that.
constexpr int pixels_at_compile_time() {
  int count = 0;
  decision_parameter({0, 0}, {9, -4}, [&](ivec2) { ++count; });
  return count;
}
static_assert(pixels_at_compile_time() == 10);

}  // namespace
}  // namespace gradus::bresenham_line
