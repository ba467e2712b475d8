#include "antialiasing/supersampling/supersampling.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "antialiasing/supersampling/supersampling_notes.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "support/random_edges.hpp"

namespace gradus::supersampling {
namespace {

constexpr std::array filters{Filter::box, Filter::tent, Filter::gaussian};
constexpr Window one_pixel{{0, 0}, {0, 0}};

/// Values of a scene in which no two places are alike.
double rough(dvec2 p) {
  const double x = 1000 * gradus::sin(12.9898 * p.x + 78.233 * p.y);
  return x - std::floor(x);
}

template <class ColourAt>
auto picture(const Window& window, int n, Filter filter, const ColourAt& colour_at) {
  std::vector<ValueOf<ColourAt>> values;
  supersample(window, n, filter, colour_at, [&](ivec2, const auto& value) { values.push_back(value); });
  return values;
}
template <class ColourAt>
auto pixel(int n, Filter filter, const ColourAt& colour_at) {
  return picture(one_pixel, n, filter, colour_at).at(0);
}

// --- Places and weights

TEST(Supersampling, AsksAtTheMiddlesOfTheCells) {
  std::vector<dvec2> places;
  pixel(2, Filter::box, [&](dvec2 p) { return places.push_back(p), 0.0; });
  EXPECT_EQ(places, (std::vector<dvec2>{{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}));
  EXPECT_EQ(place_of({-1, 7}, 4), dvec2(-0.125, 1.875));
  EXPECT_EQ(place_of({5, -5}, 1), dvec2(5.5, -4.5));
  for (int n = 1; n <= most; n *= 2) {
    for (int cell = -n; cell < n; ++cell) {
      const double place = 128 * place_of({cell, 0}, n).x;
      EXPECT_EQ(place, std::floor(place)) << n;
    }
  }
}

TEST(Supersampling, WeightsAreThoseOfTheFilter) {
  EXPECT_EQ(kernel_of(Filter::box, 3).cells.size(), 9u);
  EXPECT_EQ(kernel_of(Filter::box, 3).total, 9);
  // 1 3 3 1 along each axis: the tent at distances 3/4 and 1/4
  const auto tent = kernel_of(Filter::tent, 2);
  ASSERT_EQ(tent.cells.size(), 16u);
  EXPECT_EQ(tent.total, 64);
  EXPECT_EQ(tent.cells[0].at, (ivec2{-1, -1}));
  EXPECT_EQ(tent.cells[0].weight, 1);
  EXPECT_EQ(tent.cells[1].weight, 3);
  EXPECT_EQ(tent.cells[5].weight, 9);
  // One standard deviation away, the bell has fallen to e^(-1/2)
  const auto bell = kernel_of(Filter::gaussian, 1);
  ASSERT_EQ(bell.cells.size(), 9u);
  EXPECT_DOUBLE_EQ(bell.cells[3].weight, std::exp(-2.0));
  EXPECT_EQ(bell.cells[4].weight, 1);
  for (const Filter filter : filters) {
    for (int n = 1; n <= 9; ++n) {
      const auto kernel = kernel_of(filter, n);
      double sum = 0;
      for (std::size_t k = 0; k < kernel.cells.size(); ++k) {
        const auto& [at, weight] = kernel.cells[k];
        EXPECT_GT(weight, 0);
        EXPECT_EQ(weight, kernel.cells[kernel.cells.size() - 1 - k].weight) << "the same on both sides";
        const dvec2 away = glm::abs(place_of(at, n) - 0.5);
        EXPECT_LT(std::max(away.x, away.y), radius_of(filter));
        sum += weight / kernel.total;
      }
      EXPECT_NEAR(sum, 1, 1e-14);
      // The next cell would lie on the filter's end or beyond
      EXPECT_GE(std::abs(place_of({n + kernel.reach, 0}, n).x - 0.5), radius_of(filter));
    }
  }
}

TEST(Supersampling, OneSampleIsTheValueAtThePixelsMiddle) {
  for (const Filter filter : {Filter::box, Filter::tent}) {
    EXPECT_EQ(picture({{-2, 3}, {1, 4}}, 1, filter, rough),
              (std::vector{rough({-1.5, 3.5}), rough({-0.5, 3.5}), rough({0.5, 3.5}), rough({1.5, 3.5}),
                           rough({-1.5, 4.5}), rough({-0.5, 4.5}), rough({0.5, 4.5}), rough({1.5, 4.5})}));
  }
}

// --- The two methods

TEST(Supersampling, TheLargePictureGivesTheSameBits) {
  int runs = 0;
  for (const Filter filter : filters) {
    for (const int n : {1, 2, 3, 4, 7, 8}) {
      for (const Window window :
           {Window{{0, 0}, {8, 5}}, Window{{-7, -3}, {-2, 4}}, Window{{4, 9}, {4, 9}}}) {
        std::vector<double> values;
        large_picture(window, n, filter, rough, [&](ivec2, double value) { values.push_back(value); });
        EXPECT_EQ(values, picture(window, n, filter, rough));
        ++runs;
      }
    }
  }
  EXPECT_EQ(runs, 54);
}

TEST(Supersampling, AsksEachPlaceOnceAndKeepsWhatItSays) {
  const Window window{{-3, 2}, {9, 12}};
  const auto drop = [](ivec2, double) {};
  for (const Filter filter : filters) {
    for (const int n : {1, 2, 3, 5}) {
      std::map<std::pair<double, double>, int> asked;
      const auto count = [&](dvec2 p) { return ++asked[{p.x, p.y}], 0.0; };
      const Taken band = supersample(window, n, filter, count, drop);
      EXPECT_TRUE(std::ranges::all_of(asked, [](const auto& a) { return a.second == 1; }));
      EXPECT_EQ(band.asked, std::ssize(asked));
      EXPECT_EQ(band.asked, cost_of_band(window, n, filter).asked);
      EXPECT_EQ(band.kept, cost_of_band(window, n, filter).kept);
      const Taken large = large_picture(window, n, filter, count, drop);
      EXPECT_EQ(large.asked, band.asked);
      EXPECT_EQ(large.kept, cost_of_large_picture(window, n, filter).kept);
    }
  }
}

// R001-160: of a large picture n * n as much is kept, of a band n rows per row.
TEST(Supersampling, MemoryGrowsWithTheFactor) {
  const Window small{{0, 0}, {99, 49}}, high{{0, 0}, {99, 4999}};
  for (const int n : {1, 2, 4, 8}) {
    EXPECT_EQ(cost_of_large_picture(small, n, Filter::box).kept, 5000 * n * n);
    EXPECT_EQ(cost_of_band(small, n, Filter::box).kept, 100 * n * n);
    EXPECT_EQ(cost_of_band(high, n, Filter::gaussian).kept, cost_of_band(small, n, Filter::gaussian).kept);
  }
  EXPECT_EQ(cost_of_band({}, 4, Filter::box).kept, 0);
}

// --- Values

TEST(Supersampling, MeansAreExactInRationals) {
  Random random(17);
  for (const Filter filter : {Filter::box, Filter::tent}) {
    for (const int n : {1, 2, 4, 8}) {
      const ExactScope scope;
      const std::int64_t a = random.uniform_int(-9, 9), b = random.uniform_int(1, 9);
      // A plane: the weighted mean of a linear function is its value in the middle, places being exact
      const auto plane = [&](dvec2 p) { return Exact(p.x) * a + Exact(p.y) * b; };
      EXPECT_TRUE(pixel(n, filter, plane) == Exact(a + b, 2)) << n;
    }
  }
}

TEST(Supersampling, SharesOfAShapeAreTheNearestNumbers) {
  Random random(5);
  for (const Filter filter : {Filter::box, Filter::tent}) {
    for (int run = 0; run < 200; ++run) {
      const auto edge = test::random_edge(random);
      const int n = static_cast<int>(random.uniform_int(1, 12));
      const auto kernel = kernel_of<Exact>(filter, n);
      const ExactScope scope;
      Exact sum(0);
      for (const auto& [at, weight] : kernel.cells)
        sum = sum + (edge.holds(place_of(at, n)) ? weight : Exact(0));
      const double share = pixel(n, filter, [&](dvec2 p) { return edge.holds(p) ? 1.0 : 0.0; });
      const Exact off = Exact(share) * kernel.total - sum;
      const Exact half_ulp = kernel.total * Exact(share >= 0.5 ? 0x1p-54 : 0x1p-55);
      EXPECT_TRUE(off <= half_ulp && Exact(0) - off <= half_ulp);
    }
  }
}

TEST(Supersampling, OneColourStaysAndChannelsKeepApart) {
  for (const Filter filter : filters) {
    for (const int n : {1, 2, 4, 6}) {
      EXPECT_NEAR(pixel(n, filter, [](dvec2) { return 0.7; }), 0.7, 1e-14);
      const auto three = pixel(n, filter, [](dvec2 p) { return dvec3(rough(p), 0, 2 * rough(p)); });
      const double one = pixel(n, filter, rough);
      EXPECT_DOUBLE_EQ(three.x, one);
      EXPECT_EQ(three.y, 0);
      EXPECT_DOUBLE_EQ(three.z, 2 * one);
      EXPECT_NEAR(pixel(n, filter, [](dvec2 p) { return static_cast<float>(rough(p)); }), one, 1e-5);
    }
  }
}

// R001-159: random straight edges. The mean error is 0 within 4 sigma, the root mean square falls as the
// samples to the power -3/4.
TEST(Supersampling, EdgePixelsApproachTheExactArea) {
  constexpr int edges = 20000;
  std::array<double, 3> rmse{};
  for (std::size_t k = 0; k < 3; ++k) {
    const int n = 4 << k;
    Random random(2024);
    double sum = 0, squares = 0, worst = 0;
    for (int e = 0; e < edges; ++e) {
      const test::StraightEdge edge = test::random_edge(random);
      const double share = pixel(n, Filter::box, [&](dvec2 p) { return edge.holds(p) ? 1.0 : 0.0; });
      const double off = share - edge.area();
      sum += off;
      squares += off * off;
      worst = std::max(worst, std::abs(off));
    }
    rmse[k] = std::sqrt(squares / edges);
    RecordProperty("rmse_" + std::to_string(n * n), std::to_string(rmse[k]));
    EXPECT_LT(std::abs(sum), 4 * std::sqrt(squares)) << "seed 2024, n = " << n;
    EXPECT_LE(worst, 1.0 / n);
  }
  constexpr std::array found{0.0303, 0.0106, 0.0038};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(rmse[k], found[k], 0.05 * found[k]);
  const double slope = std::log(rmse[0] / rmse[2]) / std::log(16.0);
  EXPECT_NEAR(slope, 0.75, 0.05);
}

// R001-160: stripes n to a pixel are asked at their darkest places only, and stripes a little wider give a
// false wave of 8 pixels where the true mean is grey.
TEST(Supersampling, AFinerPatternStillAliases) {
  constexpr double turn = 2 * 3.14159265358979323846;
  for (const int n : {1, 2, 4, 8}) {
    const auto grating = [&](double per_pixel) {
      return picture({{0, 0}, {15, 0}}, n, Filter::box,
                     [&](dvec2 p) { return 0.5 + 0.5 * gradus::cos(turn * per_pixel * p.x); });
    };
    for (const double value : grating(n)) EXPECT_NEAR(value, 0, 1e-12) << n;
    const std::vector<double> wave = grating(n - 0.125);
    EXPECT_GT(*std::ranges::max_element(wave), 0.9);
    EXPECT_LT(*std::ranges::min_element(wave), 0.1);
    for (std::size_t i = 8; i < 16; ++i) EXPECT_NEAR(wave[i], wave[i - 8], 1e-12) << "a period of 8 pixels";
  }
}

// --- The exhibits

// G001-111
TEST(Supersampling, AFinishedPictureHasNoNewSamples) {
  std::vector<double> row;
  upsampled_image(
      {16, 1}, 2, [](ivec2 p) { return p.x < 8 ? 0.0 : 1.0; }, [&](ivec2, double v) { row.push_back(v); });
  const std::vector<double> known{0, 0, 0, 0, 0, 0, 0.0001, 0.0586, 0.6995, 0.9954, 1, 1, 1, 1, 1, 1};
  ASSERT_EQ(row.size(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) EXPECT_NEAR(row[i], known[i], 0.00005) << i;
  // What is right: the scene's edge lies between two pixels, and stays there
  EXPECT_EQ(picture({{0, 0}, {15, 0}}, 2, Filter::box, [](dvec2 p) { return p.x < 8 ? 0.0 : 1.0; }),
            (std::vector<double>{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}));
}

// G001-110
TEST(Supersampling, OneSigmaForAllAxesMixesTheColours) {
  dvec3 shown{};
  const auto red = [](auto) { return dvec3(1, 0, 0); };
  blurred_channels({1, 1}, 2, red, [&](ivec2, const dvec3& value) { shown = value; });
  EXPECT_NEAR(shown.x, 0.6409149150126985, 1e-12);
  EXPECT_NEAR(shown.y, 0.29609640370191986, 1e-12);
  EXPECT_NEAR(shown.z, 0.06298868128538168, 1e-12);
  EXPECT_EQ(pixel(2, Filter::gaussian, red).y, 0);
  upsampled_image({3, 2}, 2, red, [](ivec2, const dvec3& value) { EXPECT_NEAR(value.x, 1, 1e-14); });
}

// --- Steps

TEST(Supersampling, StepsFollowTheGrammar) {
  Recorder<Started, Added<double>, Filtered<double>, Finished> seen;
  const Taken taken = supersample({{0, 0}, {1, 1}}, 2, Filter::tent, rough, [](ivec2, double) {}, seen);
  ASSERT_EQ(seen.events().size(), 1u + 4u * (16 + 1) + 1);
  EXPECT_EQ(std::get<Started>(seen.events().front().step).reach, 1);
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).taken.asked, taken.asked);
  double sum = 0;
  int added = 0;
  for (const auto& event : seen.events()) {
    if (const auto* a = std::get_if<Added<double>>(&event.step)) {
      sum += a->weight * a->value;
      EXPECT_EQ(a->sum, sum);
      EXPECT_EQ(a->value, rough(place_of(a->cell, 2)));
      ++added;
    }
    if (const auto* f = std::get_if<Filtered<double>>(&event.step)) {
      EXPECT_EQ(added, 16);
      EXPECT_EQ(f->value, sum / 64);
      added = 0;
      sum = 0;
    }
  }
}

TEST(Supersampling, TheLargePicturesStepsFollowTheGrammar) {
  Recorder<Started, RowDrawn<double>, Filtered<double>, Finished> seen;
  large_picture({{0, 0}, {2, 1}}, 3, Filter::box, rough, [](ivec2, double) {}, seen);
  ASSERT_EQ(seen.events().size(), 1u + 6 + 6 + 1);
  EXPECT_TRUE(every<RowDrawn<double>>(seen, [](const RowDrawn<double>& r) {
    for (int x = 0; x < 9; ++x) {
      if (r.values[static_cast<std::size_t>(x)] != rough(place_of({x, r.row}, 3))) return false;
    }
    return r.values.size() == 9;
  }));
}

TEST(Supersampling, TheExhibitsStepsFollowTheGrammar) {
  Recorder<Replicated<dvec3>, Blurred<dvec3>, FirstTaken<dvec3>> seen;
  const auto colour = [](ivec2 p) { return dvec3(p.x, p.y, 1); };
  blurred_channels({3, 2}, 2, colour, [](ivec2, const dvec3&) {}, seen);
  upsampled_image({3, 2}, 2, colour, [](ivec2, const dvec3&) {}, seen);
  EXPECT_EQ(seen.events().size(), 2u * (2 + 6));
  EXPECT_TRUE(every<Replicated<dvec3>>(seen, [&](const Replicated<dvec3>& r) {
    return r.size == ivec2(6, 4) && r.values[6 * 3 + 5] == colour({2, 1});
  }));
}

TEST(Supersampling, ObservedEqualsUnobserved) {
  for (const Filter filter : filters) {
    std::vector<double> values;
    const auto keep = [&](ivec2, double value) { values.push_back(value); };
    supersample({{-1, 0}, {3, 3}}, 3, filter, rough, keep, [](const auto&) {});
    EXPECT_EQ(values, picture({{-1, 0}, {3, 3}}, 3, filter, rough));
    values.clear();
    large_picture({{-1, 0}, {3, 3}}, 3, filter, rough, keep, [](const auto&) {});
    EXPECT_EQ(values, picture({{-1, 0}, {3, 3}}, 3, filter, rough));
  }
}

TEST(Supersampling, RefusesWhatItCannotTake) {
  const auto drop = [](ivec2, double) {};
  EXPECT_THROW(supersample(one_pixel, 0, Filter::box, rough, drop), ContractViolation);
  EXPECT_THROW(supersample(one_pixel, most + 1, Filter::box, rough, drop), ContractViolation);
  EXPECT_THROW(supersample({{0, 0}, {farthest, 0}}, 1, Filter::box, rough, drop), ContractViolation);
  EXPECT_THROW(large_picture(one_pixel, 0, Filter::box, rough, drop), ContractViolation);
  EXPECT_THROW(upsampled_image({0, 1}, 2, [](ivec2) { return 0.0; }, drop), ContractViolation);
  EXPECT_EQ(supersample({}, 4, Filter::tent, rough, [](ivec2, double) { FAIL(); }).asked, 0);
  EXPECT_EQ(picture({{-farthest, -farthest}, {-farthest, -farthest}}, most, Filter::gaussian, rough).size(),
            1u);
}

}  // namespace
}  // namespace gradus::supersampling
