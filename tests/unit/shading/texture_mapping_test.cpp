// Texture mapping: the notes' midpoint, places in exact arithmetic, filters and levels where their values are
// known, and a footprint's level against the mean of many samples. What holds of any input is promised.

#include "shading/texture_mapping/texture_mapping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "shading/texture_mapping/texture_mapping_notes.hpp"

namespace gradus::texture_mapping {
namespace {

using Colours = std::vector<double>;

constexpr double unit = 0x1p-53;
constexpr auto drop = [](auto&&...) {};

/// A texture of random grey.
struct Grey {
  ivec2 size;
  Colours texels;

  Grey(ivec2 its_size, Random& random) : size(its_size) {
    for (int k = 0; k < size.x * size.y; ++k) texels.push_back(random.uniform(0, 1));
  }
  double operator()(ivec2 at) const { return texels[static_cast<std::size_t>(at.y * size.x + at.x)]; }
};

template <class Colour, class Texel>
std::vector<Colour> chain_of(ivec2 size, const Texel& texel) {
  std::vector<Colour> chain(texels_of_chain(size));
  build_mip_chain(size, texel, std::span<Colour>(chain));
  return chain;
}

ivec2 picked(dvec2 uv, const Extent& texture) {
  ivec2 found{-1};
  nearest(uv, texture, [&](ivec2 at) {
    found = at;
    return 0.0;
  });
  return found;
}

// --- Triangles

/// G000-16, E000-12: an edge recedes from z = 1 to z = 3, u from 0 to 1; the pixel in its
/// middle.
TEST(TextureMapping, MiddleOfARecedingEdgeHasAQuarterOfTheTexture) {
  // Pixel (2, 2) has its centre in the middle of corners 0 and 1, on a top edge
  const Triangle triangle{ivec2{128, 640}, {1152, 640}, {640, 4000}};
  const Corners<double> corners{{{1, {0, 0}}, {1.0 / 3, {1, 0}}, {0.5, {0.5, 1}}}};
  double correct = -1, bent = -1;
  const Window pixel{{2, 2}, {2, 2}};
  perspective_correct(triangle, corners, pixel, [&](ivec2, dvec2 uv, const auto&) { correct = uv.x; });
  affine(triangle, corners, pixel, [&](ivec2, dvec2 uv, const auto&) { bent = uv.x; });
  EXPECT_NEAR(correct, 0.25, 4 * unit);
  EXPECT_NEAR(bent, 0.5, 4 * unit);
}

/// R000-040: a floor of two triangles. The pixels between its corners (1, 0) and (0, 1) lie on the texture's
/// diagonal u + v = 1; affine mapping has them elsewhere but near the corners.
TEST(TextureMapping, AffineBendsTheDiagonal) {
  const std::array<ivec2, 4> at{ivec2{0, 6144}, {6144, 6144}, {4096, 512}, {2048, 512}};
  const std::array<Corner<double>, 4> floor{
      Corner<double>{1, {0, 0}}, {1, {1, 0}}, {1.0 / 3, {1, 1}}, {1.0 / 3, {0, 1}}};
  double worst_correct = 0, worst_affine = 0;
  const auto on_diagonal = [&](ivec2 pixel) {
    // Its centre is at most a pixel's half from the line
    const dvec2 from = dvec2(at[3] - at[1]), to = dvec2(triangle_coverage::centre_of(pixel) - at[1]);
    return std::abs(from.x * to.y - from.y * to.x) <= 128 * std::hypot(from.x, from.y);
  };
  int pixels = 0;
  for (const std::size_t k : {0U, 1U}) {
    const Triangle triangle{at[0], at[k + 1], at[k + 2]};
    const Corners<double> corners{floor[0], floor[k + 1], floor[k + 2]};
    const auto off = [&](double& worst) {
      return [&](ivec2 pixel, dvec2 uv, const auto&) {
        if (!on_diagonal(pixel)) return;
        worst = std::max(worst, std::abs(uv.x + uv.y - 1));
        ++pixels;
      };
    };
    perspective_correct(triangle, corners, {{0, 0}, {23, 23}}, off(worst_correct));
    affine(triangle, corners, {{0, 0}, {23, 23}}, off(worst_affine));
  }
  EXPECT_GT(pixels, 40);
  EXPECT_LT(worst_correct, 0.12);
  EXPECT_GT(worst_affine, 0.35);
}

Corners<Exact> exact(const Corners<double>& c) {
  Corners<Exact> all{};
  for (std::size_t i = 0; i < 3; ++i) all[i] = {Exact(c[i].over_w), {Exact(c[i].uv.x), Exact(c[i].uv.y)}};
  return all;
}

struct Drawn {
  Triangle triangle;
  Corners<double> corners;
};
Drawn random_triangle(Random& random) {
  Drawn d{};
  for (std::size_t i = 0; i < 3; ++i) {
    d.triangle[i] = {static_cast<int>(random.uniform(-2000, 4000)),
                     static_cast<int>(random.uniform(-2000, 4000))};
    d.corners[i] = {1 / random.uniform(0.5, 20), {random.uniform(-3, 3), random.uniform(-3, 3)}};
  }
  return d;
}

/// Projected again, the place on the surface is the centre of the pixel: with rationals exactly so.
TEST(TextureMapping, PlacesProjectToTheCentresOfTheirPixels) {
  Random random(7701);
  int looked_at = 0;
  for (int round = 0; round < 40; ++round) {
    Drawn d = random_triangle(random);
    d.corners[0].uv = {0, 0};
    d.corners[1].uv = {1, 0};
    d.corners[2].uv = {0, 1};
    const ExactScope scope;
    const auto corners = exact(d.corners);
    const auto plot = [&](ivec2 pixel, const glm::vec<2, Exact>& uv, const auto&) {
      const std::array<Exact, 3> share{Exact(1) - uv.x - uv.y, uv.x, uv.y};
      Exact x(0), y(0), w(0);
      for (std::size_t i = 0; i < 3; ++i) {
        const Exact depth = share[i] / corners[i].over_w;
        x = x + depth * Exact(d.triangle[i].x);
        y = y + depth * Exact(d.triangle[i].y);
        w = w + depth;
      }
      EXPECT_EQ(x / w, Exact(pixel.x * 256 + 128));
      EXPECT_EQ(y / w, Exact(pixel.y * 256 + 128));
      ++looked_at;
    };
    perspective_correct(d.triangle, corners, {{2, 2}, {4, 4}}, plot);
  }
  EXPECT_GT(looked_at, 40);
}

TEST(TextureMapping, WithoutPerspectiveBothWaysAgree) {
  Random random(7703);
  for (int round = 0; round < 50; ++round) {
    Drawn d = random_triangle(random);
    for (auto& corner : d.corners) corner.over_w = 0.25;
    std::vector<dvec2> correct;
    const Window window{{0, 0}, {7, 7}};
    perspective_correct(d.triangle, d.corners, window,
                        [&](ivec2, dvec2 uv, const auto&) { correct.push_back(uv); });
    std::size_t k = 0;
    affine(d.triangle, d.corners, window, [&](ivec2, dvec2 uv, const auto&) {
      EXPECT_NEAR(uv.x, correct[k].x, 32 * unit * 3);
      EXPECT_NEAR(uv.y, correct[k].y, 32 * unit * 3);
      ++k;
    });
    EXPECT_EQ(k, correct.size());
  }
}

/// R000-037: a checker on a square of 8 x 8 pixels that is seen straight on.
TEST(TextureMapping, CheckerShowsAtTheExpectedTexels) {
  const std::array<Triangle, 2> halves{Triangle{ivec2{0, 2048}, {2048, 2048}, {2048, 0}},
                                       Triangle{ivec2{0, 2048}, {2048, 0}, {0, 0}}};
  const std::array<Corners<double>, 2> corners{Corners<double>{{{1, {0, 0}}, {1, {1, 0}}, {1, {1, 1}}}},
                                               Corners<double>{{{1, {0, 0}}, {1, {1, 1}}, {1, {0, 1}}}}};
  int pixels = 0;
  for (const std::size_t half : {0U, 1U}) {
    perspective_correct(halves[half], corners[half], {{0, 0}, {7, 7}},
                        [&](ivec2 pixel, dvec2 uv, const auto& area) {
                          EXPECT_EQ(picked(uv, {{4, 4}}), (ivec2{pixel.x / 2, pixel.y / 2}));
                          EXPECT_EQ(longer_side(area, {8, 8}), 1);
                          ++pixels;
                        });
  }
  EXPECT_EQ(pixels, 64);
}

TEST(TextureMapping, StepsFollowTheGrammar) {
  Random random(7704);
  const Drawn d = random_triangle(random);
  Recorder<Mapped<double>, Finished> seen;
  std::vector<dvec2> plotted;
  const Window window{{-10, -10}, {20, 20}};
  perspective_correct(
      d.triangle, d.corners, window, [&](ivec2, dvec2 uv, const auto&) { plotted.push_back(uv); }, seen);
  std::vector<dvec2> unobserved;
  perspective_correct(d.triangle, d.corners, window,
                      [&](ivec2, dvec2 uv, const auto&) { unobserved.push_back(uv); });
  EXPECT_EQ(plotted, unobserved);
  ASSERT_EQ(seen.events().size(), plotted.size() + 1);
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).pixels, std::ssize(plotted));
}

// --- One level

TEST(TextureMapping, NearestTakesTheCellThatHoldsThePlace) {
  // v goes up, rows down
  EXPECT_EQ(picked({0, 0}, {{4, 2}}), (ivec2{0, 1}));
  EXPECT_EQ(picked({0.99, 0.99}, {{4, 2}}), (ivec2{3, 0}));
  EXPECT_EQ(picked({0.25, 0.5}, {{4, 2}}), (ivec2{1, 0}));
  // Beyond: the texture again, or its border
  EXPECT_EQ(picked({1, 1}, {{4, 2}}), (ivec2{0, 1}));
  EXPECT_EQ(picked({-0.01, 2.75}, {{4, 2}}), (ivec2{3, 0}));
  EXPECT_EQ(picked({-0.01, 2.75}, {{4, 2}, Wrap::clamp}), (ivec2{0, 0}));
  EXPECT_EQ(picked({1, -1}, {{4, 2}, Wrap::clamp}), (ivec2{3, 1}));
}

/// A globe maps to a rectangle: a texture of longitudes and latitudes is right where one looks it up.
TEST(TextureMapping, GlobeMapsToARectangle) {
  const auto texel = [](ivec2 at) { return dvec3(at.x, at.y, 0); };
  const auto at = [&](double longitude, double latitude) {
    const dvec3 found = nearest({(longitude + 180) / 360, (latitude + 90) / 180}, {{36, 18}}, texel);
    return ivec2(found.x, found.y);
  };
  EXPECT_EQ(at(16.4, 48.2), (ivec2{19, 4}));     // Vienna: 10 to 20 east, 40 to 50 north
  EXPECT_EQ(at(-70.7, -33.4), (ivec2{10, 12}));  // Santiago
  EXPECT_EQ(at(180, 0), at(-180, 0));            // the same meridian
}

TEST(TextureMapping, InTheMiddleOfATexelBilinearIsThatTexel) {
  Random random(7707);
  const Grey texture({8, 4}, random);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) {
      const dvec2 uv{(x + 0.5) / 8, (4 - y - 0.5) / 4};
      EXPECT_EQ(bilinear(uv, {{8, 4}}, texture), texture({x, y}));
      EXPECT_EQ(nearest(uv, {{8, 4}}, texture), texture({x, y}));
    }
  }
}

// --- Levels

TEST(TextureMapping, LevelsHalveUntilOneTexelIsLeft) {
  EXPECT_EQ(levels_of({1, 1}), 1);
  EXPECT_EQ(levels_of({8, 2}), 4);
  EXPECT_EQ(levels_of({5, 3}), 3);
  EXPECT_EQ(size_of_level({8, 2}, 2), (ivec2{2, 1}));
  EXPECT_EQ(size_of_level({5, 3}, 1), (ivec2{2, 1}));
  EXPECT_EQ(texels_of_chain({4, 4}), 21U);
  // An odd row is stretched: 5 texels onto 2
  const std::vector<double> five = chain_of<double>({5, 1}, [](ivec2 at) { return at.x; });
  EXPECT_NEAR(five[5], (0 * 2 + 1 * 2 + 2 * 1) / 5.0, 1e-15);
  EXPECT_NEAR(five[6], (2 * 1 + 3 * 2 + 4 * 2) / 5.0, 1e-15);
  EXPECT_NEAR(five[7], 2, 1e-15);
}

TEST(TextureMapping, LevelFitsTheFootprint) {
  const auto level = [](double length) { return level_of(length, 5); };
  EXPECT_EQ(level(0).lower, 0);
  EXPECT_EQ(level(1).part, 0);
  EXPECT_EQ(level(2).lower, 1);
  EXPECT_EQ(level(2).part, 0);
  EXPECT_EQ(level(8).lower, 3);
  EXPECT_EQ(level(8).part, 0);
  EXPECT_EQ(level(6).lower, 2);
  EXPECT_NEAR(level(6).part, 0.5849625007211562, 1e-15);
  EXPECT_EQ(level(16).lower, 4);
  EXPECT_EQ(level(1000).lower, 4);
  EXPECT_EQ(level(std::numeric_limits<double>::infinity()).lower, 4);
  EXPECT_EQ(level(std::numeric_limits<double>::quiet_NaN()).lower, 4);
}

/// From level to level nothing jumps: a little longer footprint changes the colour a little.
TEST(TextureMapping, MipMappedIsContinuous) {
  Random random(7710);
  const Grey texture({16, 16}, random);
  const std::vector<double> texels = chain_of<double>({16, 16}, texture);
  const MipChain<double> chain({16, 16}, texels);
  const dvec2 uv{0.31, 0.77};
  double before = mip_mapped(uv, {{0, 0}, {0, 0}}, chain);
  const int steps = 20000;
  for (int k = 1; k <= steps; ++k) {
    const double length = 2.0 * k / steps;  // of the texture
    const double here = mip_mapped(uv, {{length, 0}, {0, 0}}, chain);
    EXPECT_LE(std::abs(here - before), 0.005) << length;
    before = here;
  }
  EXPECT_EQ(before, texels.back());
}

/// A square footprint: the level is near the mean of what the pixel covers. For footprints of 2, 4 and 8
/// texels per side the worst of 400 differs by less than half of what one sample is off.
TEST(TextureMapping, LevelIsNearTheMeanOfTheFootprint) {
  Random random(7711);
  const Grey texture({64, 64}, random);
  const std::vector<double> texels = chain_of<double>({64, 64}, texture);
  const MipChain<double> chain({64, 64}, texels);
  for (const int side : {2, 4, 8}) {
    double off_mip = 0, off_nearest = 0;
    for (int round = 0; round < 400; ++round) {
      const dvec2 uv{random.uniform(0, 1), random.uniform(0, 1)};
      const double stretch = side / 64.0;
      double mean = 0;
      for (int j = 0; j < 16; ++j) {
        for (int i = 0; i < 16; ++i)
          mean += nearest(uv + stretch * (dvec2(i + 0.5, j + 0.5) / 16.0 - 0.5), {{64, 64}}, texture) / 256;
      }
      const double mip = mip_mapped(uv, {{stretch, 0}, {0, stretch}}, chain);
      off_mip += (mip - mean) * (mip - mean) / 400;
      const double one = nearest(uv, {{64, 64}}, texture);
      off_nearest += (one - mean) * (one - mean) / 400;
    }
    EXPECT_LT(std::sqrt(off_mip), 0.5 * std::sqrt(off_nearest)) << side;
  }
}

TEST(TextureMapping, FiltersTellTheirSteps) {
  Random random(7712);
  const Grey texture({4, 4}, random);
  const std::vector<double> texels = chain_of<double>({4, 4}, texture);
  const MipChain<double> chain({4, 4}, texels);
  Recorder<Picked<double>> one;
  EXPECT_EQ(nearest({0.3, 0.3}, {{4, 4}}, texture, one), nearest({0.3, 0.3}, {{4, 4}}, texture));
  EXPECT_EQ(one.events().size(), 1U);
  Recorder<LevelChosen, Blended<double>, LevelsMixed<double>> two;
  const Footprint<double> footprint{{0.4, 0}, {0, 0.3}};
  EXPECT_EQ(mip_mapped({0.3, 0.3}, footprint, chain, Wrap::repeat, two),
            mip_mapped({0.3, 0.3}, footprint, chain));
  EXPECT_EQ(two.events().size(), 4U);
  Recorder<Averaged<double>> built;
  std::vector<double> again(21);
  build_mip_chain({4, 4}, texture, std::span<double>(again), built);
  EXPECT_EQ(again, texels);
  EXPECT_EQ(built.events().size(), 5U);
}

TEST(TextureMapping, RefusesWhatItCantLookUp) {
  const auto grey = [](ivec2) { return 0.5; };
  EXPECT_THROW(nearest({2e6, 0}, {{4, 4}}, grey), ContractViolation);
  EXPECT_THROW(nearest({std::nan(""), 0}, {{4, 4}}, grey), ContractViolation);
  EXPECT_THROW(bilinear({0, 0}, {{0, 4}}, grey), ContractViolation);
  std::vector<double> chain(20);
  EXPECT_THROW(build_mip_chain({4, 4}, grey, std::span<double>(chain)), ContractViolation);
  const Corners<double> behind{{{1, {0, 0}}, {0, {1, 0}}, {1, {0, 1}}}};
  EXPECT_THROW(perspective_correct(Triangle{}, behind, {}, drop), ContractViolation);
  EXPECT_THROW(affine(Triangle{}, behind, {}, drop), ContractViolation);
}

}  // namespace
}  // namespace gradus::texture_mapping
