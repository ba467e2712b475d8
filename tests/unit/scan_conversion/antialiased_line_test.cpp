#include "scan_conversion/antialiased_line/antialiased_line.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <map>
#include <vector>

#include "core/random.hpp"
#include "core/record.hpp"
#include "scan_conversion/antialiased_line/antialiased_line_notes.hpp"
#include "stress/scan_conversion/line_light.hpp"

namespace gradus::antialiased_line {
namespace {

using Picture = std::map<std::pair<int, int>, int>;
using Areas = std::map<std::pair<int, int>, double>;

Picture by_wu(ivec2 from, ivec2 to) {
  Picture picture;
  wu(from, to, [&](ivec2 p, int intensity) {
    if (intensity > 0) picture[{p.x, p.y}] += intensity;
  });
  return picture;
}
Picture by_cone(ivec2 from, ivec2 to) {
  Picture picture;
  gupta_sproull(from, to, [&](ivec2 p, int intensity) { picture[{p.x, p.y}] += intensity; });
  return picture;
}
Areas by_area(ivec2 from, ivec2 to) {
  Areas areas;
  exact_area(from, to, [&](ivec2 p, double area) { areas[{p.x, p.y}] += area; });
  return areas;
}

// --- Wu

TEST(AntialiasedLine, TwoPixelsShareAColumn) {
  // Thirds of 256, cut off: 85 and 170
  EXPECT_EQ(
      by_wu({0, 0}, {3, 1}),
      (Picture{{{0, 0}, 255}, {{1, 0}, 170}, {{1, 1}, 85}, {{2, 0}, 85}, {{2, 1}, 170}, {{3, 1}, 255}}));
  // Midway the one with the smaller coordinate gets the smaller half
  EXPECT_EQ(by_wu({0, 0}, {2, 1}), (Picture{{{0, 0}, 255}, {{1, 0}, 127}, {{1, 1}, 128}, {{2, 1}, 255}}));
  EXPECT_EQ(by_wu({0, 0}, {1, 2}), (Picture{{{0, 0}, 255}, {{0, 1}, 127}, {{1, 1}, 128}, {{1, 2}, 255}}));
}

TEST(AntialiasedLine, LevelUprightAndDiagonalLinesHaveOnePixelAColumn) {
  EXPECT_EQ(by_wu({3, 3}, {3, 3}), (Picture{{{3, 3}, 255}}));
  for (const ivec2 way : {ivec2{5, 0}, {0, 5}, {5, 5}, {-5, 5}, {-5, 0}, {0, -5}}) {
    const Picture picture = by_wu({0, 0}, way);
    EXPECT_EQ(picture.size(), 6u);
    for (const auto& [at, intensity] : picture) EXPECT_EQ(intensity, 255);
  }
}

TEST(AntialiasedLine, ColumnsAddUpFromBothEnds) {
  std::int64_t columns = 0, expected = 0;
  for (int i = 0; i < 61 * 61; ++i) {
    const ivec2 to{i % 61 - 30, i / 61 - 30};
    const Picture picture = by_wu({0, 0}, to);
    EXPECT_EQ(picture, by_wu(to, {0, 0})) << to.x << ' ' << to.y;
    std::map<int, int> sums;
    for (const auto& [at, intensity] : picture)
      sums[bresenham_line::steep({0, 0}, to) ? at.second : at.first] += intensity;
    for (const auto& [column, sum] : sums) EXPECT_EQ(sum, 255) << to.x << ' ' << to.y << ' ' << column;
    columns += std::ssize(sums);
    expected += extent({0, 0}, to).dx + 1;
  }
  EXPECT_EQ(columns, expected);
}

TEST(AntialiasedLine, AnyColumnWithoutThoseBefore) {
  for (const ivec2 to : {ivec2{13, 5}, {12, 5}, {-12, 7}, {5, -12}, {9, 0}}) {
    Picture picture;
    for (Whole k = 0; k <= extent({0, 0}, to).dx; ++k) {
      const Pair pair = pair_at({0, 0}, to, k);
      picture[{pair.pixel.x, pair.pixel.y}] += full - pair.far;
      if (pair.far > 0) picture[{pair.pixel.x + pair.aside.x, pair.pixel.y + pair.aside.y}] += pair.far;
    }
    std::erase_if(picture, [](const auto& p) { return p.second == 0; });
    EXPECT_EQ(picture, by_wu({0, 0}, to));
  }
  EXPECT_THROW(pair_at({0, 0}, {5, 2}, -1), ContractViolation);
  EXPECT_THROW(pair_at({0, 0}, {5, 2}, 6), ContractViolation);
  // 2^31 columns from either end of the plane: half way up the last row but one
  const Pair middle = pair_at({INT_MIN, 0}, {INT_MAX - 1, 1}, Whole{INT_MAX});
  EXPECT_EQ(middle.pixel, (ivec2{-1, 0}));
  EXPECT_EQ(middle.far, 128);
}

TEST(AntialiasedLine, StepsOfWu) {
  Recorder<Started, Paired, Finished> seen;
  int plotted = 0;
  wu({0, 0}, {7, 3}, [&](ivec2, int) { ++plotted; }, seen);
  const auto pairs = all<Paired>(seen);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(seen.events().size(), 5u);
  EXPECT_EQ(plotted, 2 + 3 * 4);
  EXPECT_EQ(pairs[0].front, (ivec2{1, 0}));
  EXPECT_EQ(pairs[0].back, (ivec2{6, 3}));
  EXPECT_EQ(pairs[0].far, 109);  // 256 * 3/7 = 109.7
  EXPECT_FALSE(pairs[1].over);
  EXPECT_TRUE(pairs[2].over);  // 9/7
  EXPECT_EQ(pairs[2].front, (ivec2{3, 1}));
  EXPECT_EQ(pairs[2].far, 73);  // 256 * 2/7 = 73.1
  EXPECT_EQ(all<Finished>(seen).at(0).columns, 8);
}

// --- The cone

TEST(AntialiasedLine, ConeByTheFormulaAndByRings) {
  EXPECT_NEAR(cone_share(0), 0.779862, 1e-6);  // summed up ring by ring, elsewhere
  EXPECT_DOUBLE_EQ(cone_share(0.5), 0.5);      // the half with the centre's plane
  EXPECT_EQ(cone_share(1.5), 0);
  EXPECT_EQ(cone_share(7), 0);
  int tried = 0;
  for (double d = 0; d <= 1.6; d += 1.0 / 64, ++tried)
    EXPECT_NEAR(cone_share(d), stress::cone_by_rings(d, 20'000), 5e-7) << d;
  EXPECT_EQ(tried, 103);
  // Lines that abut fill the plane
  for (double d = -1.5; d <= -0.5; d += 1.0 / 32)
    EXPECT_NEAR(cone_share(d) + cone_share(d + 1) + cone_share(d + 2), 1, 1e-15) << d;
}

TEST(AntialiasedLine, TheTableIsWithinAByteOfTheCone) {
  double worst = 0;
  for (int i = 0; i <= 160'000; ++i) {
    const double d = i * 1e-5;
    worst = std::max(worst, std::abs(cone_table().at(d) / 255.0 - cone_share(d)));
  }
  EXPECT_LT(worst, 1 / 255.0);
  EXPECT_EQ(cone_table().at(0), 199);
  EXPECT_EQ(cone_table().at(1.5), 0);
  EXPECT_EQ(cone_table().at(1e300), 0);
}

TEST(AntialiasedLine, GuptaSproullOfALevelLine) {
  const Picture picture = by_cone({0, 0}, {2, 0});
  EXPECT_EQ(picture.size(), 9u);
  for (int x = 0; x <= 2; ++x) {
    EXPECT_EQ(picture.at({x, 0}), 199);
    EXPECT_EQ(picture.at({x, 1}), 28);
    EXPECT_EQ(picture.at({x, -1}), 28);
  }
  EXPECT_EQ(by_cone({4, 4}, {4, 4}).size(), 3u);
}

TEST(AntialiasedLine, GuptaSproullIsTheSameFromBothEnds) {
  int pixels = 0;
  for (int i = 0; i < 41 * 41; ++i) {
    const ivec2 to{i % 41 - 20, i / 41 - 20};
    const Picture picture = by_cone({0, 0}, to);
    EXPECT_EQ(picture, by_cone(to, {0, 0})) << to.x << ' ' << to.y;
    pixels += static_cast<int>(picture.size());
  }
  EXPECT_GT(pixels, 60'000);
}

/// What a long line in this direction has of ink per unit of length, where a level line of width 1 has 1.
template <class Draw>
double ink(ivec2 way, const Draw& draw) {
  double sum = 0;
  draw(ivec2{0, 0}, way, [&](ivec2, auto intensity) { sum += static_cast<double>(intensity); });
  const Extent size = extent({0, 0}, way);
  return sum / length_of(size);
}

TEST(AntialiasedLine, InkOfAUnitOfLength) {
  // 1/255 of the bytes, the columns of both ends included; prints what the page says
  const auto of_bytes = [](ivec2 way, auto method) {
    return ink(way, [&](ivec2 from, ivec2 to, auto plot) { method(from, to, plot); }) / 255;
  };
  double least[3] = {9, 9, 9}, most[3] = {0, 0, 0};
  for (int dy = 0; dy <= 1000; dy += 8) {
    const ivec2 way{1000, dy};
    const double inks[3] = {of_bytes(way, [](auto... run) { wu(run...); }),
                            of_bytes(way, [](auto... run) { gupta_sproull(run...); }),
                            of_bytes(way, [](auto... run) { distance_along_column(run...); })};
    for (int i = 0; i < 3; ++i) {
      least[i] = std::min(least[i], inks[i]);
      most[i] = std::max(most[i], inks[i]);
    }
  }
  fmt::print("wu {:.4f} {:.4f}, cone {:.4f} {:.4f}, along the column {:.4f} {:.4f}\n", least[0], most[0],
             least[1], most[1], least[2], most[2]);
  EXPECT_NEAR(least[0], std::sqrt(0.5), 0.002);
  EXPECT_NEAR(most[0], 1, 0.002);
  EXPECT_GT(least[1], 0.99);  // on the diagonal itself
  EXPECT_NEAR(most[1], 1, 0.004);
  EXPECT_NEAR(least[2], std::sqrt(0.5), 0.004);
}

// --- The exact area

TEST(AntialiasedLine, AreasOfALevelLine) {
  const Areas areas = by_area({0, 0}, {2, 0});
  EXPECT_EQ(areas, (Areas{{{0, 0}, 0.5}, {{1, 0}, 1}, {{2, 0}, 0.5}}));
  EXPECT_EQ(byte_of(0.5), 128);
  EXPECT_EQ(byte_of(0), 0);
  EXPECT_EQ(byte_of(1), 255);
  EXPECT_EQ(byte_of(-1e-17), 0);
  EXPECT_TRUE(by_area({3, 3}, {3, 3}).empty());
}

TEST(AntialiasedLine, AreasAgainstRationalsAndTheRootOfTheLength) {
  Random random(17);
  double worst = 0;
  int pixels = 0, bytes = 0;
  for (int line = 0; line < 60; ++line) {
    const ivec2 to{static_cast<int>(random.uniform_int(-9, 9)), static_cast<int>(random.uniform_int(-9, 9))};
    if (to == ivec2{0, 0}) continue;
    const ExactScope scope;
    const stress::ExactLine exact(to);
    const Areas areas = by_area({0, 0}, to);
    for (int y = std::min(0, to.y) - 2; y <= std::max(0, to.y) + 2; ++y) {
      for (int x = std::min(0, to.x) - 2; x <= std::max(0, to.x) + 2; ++x) {
        const ExactScope one_pixel;
        const stress::Surd area = exact.area({x, y});
        const double here = areas.contains({x, y}) ? areas.at({x, y}) : 0;
        worst = std::max(worst, std::abs(here - area.value()));
        // floor(255 area + 1/2), decided without rounding
        const auto at_least = [&](int byte) {
          return (area * exact.number(Exact(510)) - exact.number(Exact(2 * byte - 1))).sign() >= 0;
        };
        const int byte = byte_of(here);
        bytes += (byte == 0 || at_least(byte)) && !at_least(byte + 1);
        ++pixels;
      }
    }
  }
  fmt::print("seed 17: {} pixels, worst {:.2e}\n", pixels, worst);
  EXPECT_GT(pixels, 4000);
  EXPECT_EQ(bytes, pixels);
  EXPECT_LT(worst, 1e-14);
}

TEST(AntialiasedLine, AreasAddUpToTheLength) {
  Random random(18);
  double worst = 0;
  for (int line = 0; line < 2000; ++line) {
    const ivec2 to{static_cast<int>(random.uniform_int(-60, 60)),
                   static_cast<int>(random.uniform_int(-60, 60))};
    double sum = 0;
    exact_area({0, 0}, to, [&](ivec2, double area) { sum += area; });
    if (to != ivec2{0, 0}) worst = std::max(worst, std::abs(sum / length_of(extent({0, 0}, to)) - 1));
  }
  fmt::print("seed 18: worst {:.2e}\n", worst);
  EXPECT_LT(worst, 1e-12);
}

TEST(AntialiasedLine, StepsOfTheOthers) {
  Recorder<Started, Measured, Finished> cone;
  gupta_sproull({0, 0}, {4, 2}, [](ivec2, int) {}, cone);
  EXPECT_EQ(cone.events().size(), 2u + 5u * 5u);
  EXPECT_TRUE(every<Measured>(cone, [](const Measured& m) {
    const double exact = std::abs(4.0 * m.pixel.y - 2.0 * m.pixel.x) / std::sqrt(20.0);
    return std::abs(std::abs(m.beside) - exact) < 1e-15 && m.pixel == m.nearest + ivec2{0, m.row} &&
           m.intensity == cone_table().at(std::abs(m.beside));
  }));
  Recorder<Started, Cut, Finished> area;
  std::vector<double> plotted;
  exact_area({0, 0}, {4, 2}, [&](ivec2, double a) { plotted.push_back(a); }, area);
  EXPECT_EQ(area.events().size(), 2u + plotted.size());
  EXPECT_TRUE(every<Cut>(area, [](const Cut& c) { return c.area == area_of(c.piece) && c.area > 0; }));
}

TEST(AntialiasedLine, TheBorderOfThePlane) {
  const auto drop = [](ivec2, auto) {};
  EXPECT_THROW(gupta_sproull({0, INT_MAX - 2}, {5, INT_MAX - 2}, drop), ContractViolation);
  EXPECT_THROW(exact_area({INT_MIN + 2, 0}, {INT_MIN + 9, 0}, drop), ContractViolation);
  EXPECT_THROW(distance_along_column({INT_MIN, 0}, {INT_MIN, 0}, drop), ContractViolation);
  int pixels = 0;
  gupta_sproull({INT_MAX - 9, INT_MAX - 3}, {INT_MAX - 3, INT_MAX - 5}, [&](ivec2, int) { ++pixels; });
  EXPECT_GT(pixels, 20);
  wu({INT_MIN, INT_MIN}, {INT_MIN + 1, INT_MIN + 5}, [&](ivec2 p, int) { EXPECT_LE(p.x, INT_MIN + 1); });
  wu({INT_MAX - 5, INT_MAX}, {INT_MAX, INT_MAX}, [&](ivec2 p, int) { EXPECT_EQ(p.y, INT_MAX); });
}

// --- The mistake

TEST(AntialiasedLine, DistancesAlongTheColumnMakeDiagonalsThin) {
  Picture thin;
  distance_along_column({0, 0}, {8, 8}, [&](ivec2 p, int intensity) { thin[{p.x, p.y}] = intensity; });
  const Picture right = by_cone({0, 0}, {8, 8});
  EXPECT_EQ((thin[{4, 4}]), 199);
  EXPECT_EQ((thin[{4, 5}]), 28);
  EXPECT_EQ(right.at({4, 5}), 79);
  Picture level;
  distance_along_column({0, 0}, {8, 0}, [&](ivec2 p, int intensity) { level[{p.x, p.y}] = intensity; });
  EXPECT_EQ(level, by_cone({0, 0}, {8, 0}));
}

}  // namespace
}  // namespace gradus::antialiased_line
