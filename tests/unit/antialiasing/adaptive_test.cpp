// All samples where samples can differ, and the same picture as with all of them everywhere.

#include "antialiasing/adaptive/adaptive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <map>
#include <set>
#include <vector>

#include "core/random.hpp"
#include "core/record.hpp"
#include "support/seed.hpp"

namespace gradus::adaptive {
namespace {

using triangle_coverage::snap;
using triangle_coverage::Triangle;

constexpr Window sheet{{0, 0}, {11, 8}};

struct Plotted {
  ivec2 pixel;
  dvec3 sum;
  double share;
  friend bool operator==(const Plotted&, const Plotted&) = default;
};
using Plots = std::vector<Plotted>;

/// A colour that tells the triangle, the pixel and the place apart.
dvec3 tint(int triangle, ivec2, const Weights& w) {
  const dvec3 shares = triangle_coverage::barycentric(w);
  return {shares.x + triangle, shares.y, 0.1 * triangle};
}
auto into(Plots& plots) {
  return [&plots](ivec2 p, const dvec3& sum, double share) { plots.push_back({p, sum, share}); };
}
Plots drawn(const std::vector<ScreenTriangle>& scene, const std::vector<ivec2>& places) {
  Plots plots;
  adaptive(scene, sheet, places, tint, into(plots));
  return plots;
}
Plots everywhere(const std::vector<ScreenTriangle>& scene, const std::vector<ivec2>& places) {
  Plots plots;
  each_sample(scene, sheet, places, tint, into(plots));
  return plots;
}
ScreenTriangle triangle(dvec2 a, dvec2 b, dvec2 c, dvec3 depth = dvec3(0.5)) {
  return {{snap(a), snap(b), snap(c)}, depth};
}
/// Triangles of all sizes, some of which pierce each other.
std::vector<ScreenTriangle> random_scene(Random& random) {
  const auto place = [&](dvec2 middle, double reach) {
    return middle + dvec2{random.uniform(-reach, reach), random.uniform(-reach, reach)};
  };
  std::vector<ScreenTriangle> scene(static_cast<std::size_t>(random.uniform_int(1, 7)));
  for (auto& t : scene) {
    const dvec2 middle{random.uniform(0, 12), random.uniform(0, 9)};
    const double reach = random.unit() < 0.5 ? 15 : 2;
    t = triangle(place(middle, reach), place(middle, reach), place(middle, reach),
                 {random.unit(), random.unit(), random.unit()});
  }
  if (scene.size() > 1 && random.unit() < 0.2) scene[1].corners = scene[0].corners;
  return scene;
}

// --- Places

TEST(Adaptive, RooksStandOneInEachRowAndColumn) {
  for (const int count : {1, 2, 4, 8, 16, 32, 64, 128, 256}) {
    std::set<int> columns, rows;
    for (const ivec2 place : n_rooks(count)) {
      columns.insert(place.x * count / subpixels);
      rows.insert(place.y * count / subpixels);
    }
    EXPECT_EQ(columns.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(count));
  }
}

TEST(Adaptive, OneRookStandsInTheCentreFourAreTheRotatedGrid) {
  EXPECT_EQ(n_rooks(1), (std::vector<ivec2>{{128, 128}}));
  EXPECT_EQ(n_rooks(4), (std::vector<ivec2>{{32, 96}, {96, 224}, {160, 32}, {224, 160}}));
}

TEST(Adaptive, RooksHaveTheCentreForTheirMean) {
  for (const int count : {4, 8, 16, 64}) {
    ivec2 sum{0, 0};
    for (const ivec2 place : n_rooks(count)) sum += place;
    EXPECT_EQ(sum, ivec2(count * subpixels / 2)) << count;
  }
}

// --- The decision

TEST(Adaptive, PixelsThatAnEdgeCrossesAreTold) {
  // The right half of the sheet, from x = 2.5 on
  const Edges edges = triangle_coverage::edges_of(triangle({2.5, -100}, {200, 4}, {2.5, 100}).corners);
  EXPECT_EQ(cover_of(edges, {1, 4}), Cover::outside);
  EXPECT_EQ(cover_of(edges, {2, 4}), Cover::crossed);
  EXPECT_EQ(cover_of(edges, {3, 4}), Cover::inside);
}

TEST(Adaptive, AnEdgeAlongAPixelsSideCrossesNothing) {
  const Edges edges = triangle_coverage::edges_of(triangle({3, -100}, {200, 4}, {3, 100}).corners);
  EXPECT_EQ(cover_of(edges, {2, 4}), Cover::outside);
  EXPECT_EQ(cover_of(edges, {3, 4}), Cover::inside);  // its places on the side belong to it
}

TEST(Adaptive, WhoeverPiercesInAPixelMakesItTakeSamples) {
  const Window pixel{{0, 0}, {0, 0}};
  const ScreenTriangle level = triangle({-49.5, -50}, {50.5, -50}, {0.5, 90}, dvec3(0.5));
  const auto shares = [&](dvec3 depth) {
    const std::vector<ScreenTriangle> both{level, {level.corners, depth}};
    std::map<int, double> seen;
    const auto watch = [&]<class Step>(const Step& s) {
      if constexpr (std::same_as<Step, Coloured>) seen[s.triangle] = s.share;
    };
    adaptive(both, pixel, n_rooks(16), tint, [](auto...) {}, watch);
    return seen;
  };
  EXPECT_EQ(shares(dvec3(0.4)), (std::map<int, double>{{1, 1.0}}));
  EXPECT_EQ(shares(dvec3(0.6)), (std::map<int, double>{{0, 1.0}}));
  EXPECT_EQ(shares(dvec3(0.5)), (std::map<int, double>{{0, 1.0}}));  // equals: the first
  const auto pierced = shares({0.495, 0.505, 0.5});
  ASSERT_EQ(pierced.size(), 2u);
  EXPECT_EQ(pierced.at(0) + pierced.at(1), 1.0);
}

// --- The picture

TEST(Adaptive, AHalfCoveredPixelHasHalfTheShare) {
  const std::vector<ScreenTriangle> scene{triangle({2.5, -100}, {200, 4}, {2.5, 100})};
  for (const auto& [pixel, sum, share] : drawn(scene, n_rooks(8))) {
    EXPECT_EQ(share, pixel.x == 2 ? 0.5 : 1.0);
  }
}

TEST(Adaptive, ColourComesFromTheCentreOrFromACoveredSample) {
  const ScreenTriangle right = triangle({2.75, -100}, {200, 4}, {2.75, 100});
  const Edges edges = triangle_coverage::edges_of(right.corners);
  const auto places = n_rooks(4);
  EXPECT_EQ(colour_place(edges, {3, 4}, places), ivec2(128, 128));
  EXPECT_EQ(colour_place(edges, {2, 4}, places), ivec2(224, 160));
  adaptive(
      std::vector{right}, sheet, places,
      [](int, ivec2, const Weights& w) {
        EXPECT_GE(std::min({w[0], w[1], w[2]}), 0);
        return 1.0;
      },
      [](auto...) {});
}

TEST(Adaptive, EqualsAllSamplesEverywhereBitForBit) {
  Random random(test::seed());
  int scenes = 0, pixels = 0;
  for (; scenes < 400; ++scenes) {
    const auto scene = random_scene(random);
    const auto places = n_rooks(1 << random.uniform_int(0, 4));
    const Plots quick = drawn(scene, places);
    ASSERT_EQ(quick, everywhere(scene, places)) << "scene " << scenes << ", seed " << test::seed();
    pixels += static_cast<int>(quick.size());
  }
  EXPECT_EQ(scenes, 400);
  EXPECT_GT(pixels, 4000);
}

TEST(Adaptive, OneSampleInTheCentreIsTheCoverageOfCentres) {
  Random random(test::seed());
  for (int i = 0; i < 50; ++i) {
    const auto scene = random_scene(random);
    std::map<std::pair<int, int>, bool> centres;
    for (const auto& t : scene) {
      triangle_coverage::cover(t.corners, sheet,
                               [&](ivec2 p, const Weights&) { centres[{p.y, p.x}] = true; });
    }
    const Plots plots = drawn(scene, {{128, 128}});
    EXPECT_EQ(plots.size(), centres.size());
    for (const Plotted& p : plots) EXPECT_EQ(p.share, 1.0);
  }
}

// --- What it costs

TEST(Adaptive, SamplesAndColoursAreFew) {
  const std::vector<ScreenTriangle> scene{triangle({1.3, 0.8}, {10.9, 2.1}, {3.2, 8.4})};
  std::vector<Finished> done;
  const auto keep = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, Finished>) done.push_back(s);
  };
  const auto places = n_rooks(8);
  Plots plots;
  adaptive(scene, sheet, places, tint, into(plots), keep);
  each_sample(scene, sheet, places, tint, into(plots), keep);
  ASSERT_EQ(done.size(), 2u);
  EXPECT_EQ(done[0].pixels, 12 * 9);
  EXPECT_LT(done[0].crossed, 40);
  EXPECT_EQ(done[1].crossed, 12 * 9);
  EXPECT_LT(done[0].samples, done[1].samples);
  EXPECT_EQ(done[0].colours, done[1].colours);  // one per fragment either way
}

TEST(Adaptive, ThinTrianglesKeepMoreOfTheirAreaWithMoreSamples) {
  // Needles of 1/4 pixel, turned: the share of pixels' area that is lost or gained, mean over many
  double before = 2;
  for (const int count : {1, 4, 16, 64}) {
    Random random(4);
    double off = 0;
    for (int i = 0; i < 200; ++i) {
      const double x = random.uniform(3, 8), way = random.uniform(-2, 2);
      const ScreenTriangle needle = triangle({x, 0.5}, {x + 0.25, 0.5}, {x + way, 8.5});
      const double area =
          std::abs(static_cast<double>(triangle_coverage::doubled_area(needle.corners))) / 131072;
      double found = 0;
      for (const Plotted& p : drawn({needle}, n_rooks(count))) found += p.share;
      off += std::abs(found - area) / area / 200;
    }
    EXPECT_LT(off, 0.6 * before) << count;
    before = off;
    RecordProperty("lost_at_" + std::to_string(count), std::to_string(off));
  }
}

// --- With contrast

constexpr auto unlike = [](const Light<dvec3>& a, const Light<dvec3>& b) {
  const dvec3 d = a.sum - b.sum;
  return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
};

TEST(AdaptiveContrast, WithoutAnyContrastItIsAdaptive) {
  Random random(test::seed());
  for (int i = 0; i < 50; ++i) {
    const auto scene = random_scene(random);
    Plots plots;
    adaptive_contrast(scene, sheet, n_rooks(8), unlike, 1e9, tint, into(plots));
    EXPECT_EQ(plots, drawn(scene, n_rooks(8)));
  }
}

TEST(AdaptiveContrast, EverywhereItIsFullSupersampling) {
  Random random(test::seed());
  const auto places = n_rooks(8);
  int compared = 0;
  for (int i = 0; i < 50; ++i) {
    const auto scene = random_scene(random);
    Plots plots;
    adaptive_contrast(scene, sheet, places, unlike, -1, tint, into(plots));
    // The same, sample by sample: the mean of pictures of one sample
    std::map<std::pair<int, int>, dvec3> sums;
    for (const ivec2 place : places) {
      each_sample(
          scene, sheet, std::vector{place},
          [&](int t, ivec2 p, const Weights&) {
            const auto edges = triangle_coverage::edges_of(scene[static_cast<std::size_t>(t)].corners);
            return tint(t, p, weights_at_place(edges, place_in(p, place)));
          },
          [&](ivec2 p, const dvec3& sum, double) { sums[{p.y, p.x}] += sum / 8.0; });
    }
    ASSERT_EQ(plots.size(), sums.size());
    for (const auto& [p, sum, share] : plots) {
      EXPECT_LT(unlike({sum, 1}, {sums.at({p.y, p.x}), 1}), 1e-12);
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(AdaptiveContrast, AnEdgeWithinASurfaceIsRefined) {
  // One triangle in front of all, black on the left of x = 2.4 and white on its right
  const ScreenTriangle all = triangle({-100, -100}, {200, -100}, {0, 200});
  const auto colour = [&](int, ivec2, const Weights& w) {
    // The column of the place, from the weights
    const dvec3 shares = triangle_coverage::barycentric(w);
    return dvec3(shares.x * -100 + shares.y * 200 < 2.4 ? 0 : 1);
  };
  Recorder<Contrasted> seen;
  Plots plots;
  adaptive_contrast(std::vector{all}, sheet, n_rooks(16), unlike, 0.1, colour, into(plots),
                    [&]<class Step>(const Step& s) {
                      if constexpr (std::same_as<Step, Contrasted>) seen(s);
                    });
  for (const Plotted& p : plots) {
    EXPECT_NEAR(p.sum.x, p.pixel.x < 2 ? 0 : p.pixel.x == 2 ? 0.6 : 1, 1.0 / 16) << p.pixel.x;
  }
  EXPECT_TRUE(every<Contrasted>(
      seen, [](const Contrasted& c) { return c.refined == (c.pixel.x == 1 || c.pixel.x == 2); }));
}

// --- Steps and refusals

TEST(Adaptive, StepsFollowTheGrammar) {
  const std::vector<ScreenTriangle> scene{triangle({1, 1}, {9, 2}, {2, 8}),
                                          triangle({0, 5}, {11, 4}, {6, 9})};
  int stage = 0, steps = 0;
  const auto watch = [&]<class Step>(const Step&) {
    const int now = std::same_as<Step, Sampled>    ? 1
                    : std::same_as<Step, Coloured> ? 2
                    : std::same_as<Step, Finished> ? 3
                                                   : 0;
    EXPECT_GE(now, stage);
    stage = now;
    ++steps;
  };
  Plots plots;
  adaptive(scene, sheet, n_rooks(4), tint, into(plots), watch);
  EXPECT_EQ(stage, 3);
  EXPECT_GT(steps, 100);
  EXPECT_EQ(plots, drawn(scene, n_rooks(4)));
}

TEST(Adaptive, WhatHasNoAreaOrNoWindowShowsNothing) {
  EXPECT_TRUE(drawn({triangle({1, 1}, {5, 5}, {9, 9})}, n_rooks(4)).empty());
  EXPECT_TRUE(drawn({}, n_rooks(4)).empty());
  adaptive(std::vector{triangle({1, 1}, {9, 2}, {2, 8})}, Window{}, n_rooks(4), tint,
           [](auto...) { FAIL(); });
}

TEST(Adaptive, RefusesWhatLiesOutside) {
  const std::vector<ScreenTriangle> none, far{{{ivec2{1 << 30, 0}, {0, 0}, {0, 256}}, dvec3(0)}};
  EXPECT_THROW(drawn(none, {}), ContractViolation);
  EXPECT_THROW(drawn(none, {{256, 0}}), ContractViolation);
  EXPECT_THROW(drawn(none, {{0, -1}}), ContractViolation);
  EXPECT_THROW(drawn(none, std::vector<ivec2>(1025)), ContractViolation);
  EXPECT_THROW(drawn(far, n_rooks(4)), ContractViolation);
  EXPECT_THROW(n_rooks(0), ContractViolation);
  EXPECT_THROW(n_rooks(257), ContractViolation);
}

}  // namespace
}  // namespace gradus::adaptive
