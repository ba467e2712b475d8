// Pieces by the digits of their places, the curve that Koch's maps leave, levels and points as near as they
// are said to be, dimensions in closed form, the step grammar, refusals. Roundings are promises.

#include "modeling/iterated_functions/iterated_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "core/contract.hpp"
#include "core/record.hpp"
#include "modeling/iterated_functions/iterated_functions_notes.hpp"
#include "modeling/iterated_functions/similarity_dimension.hpp"
#include "support/documented.hpp"

namespace gradus::iterated_functions {
namespace {

constexpr const char* page = "docs/topics/modeling/iterated_functions.md";

using DPieces = Pieces<double>;
using Places = std::set<std::pair<Whole, Whole>>;

Maps<double> all(Maps<double> maps) { return maps; }

/// Three halves of a triangle with a right angle: no number rounds.
constexpr std::array<DMap, 3> right_triangle{DMap{0.5, 0, 0, 0.5, 0, 0}, DMap{0.5, 0, 0, 0.5, 0.5, 0},
                                             DMap{0.5, 0, 0, 0.5, 0, 0.5}};

/// Where pieces lie, in units of their own size.
Places places_of(const DPieces& pieces, Whole units) {
  Places places;
  for (const DMap& p : pieces)
    places.emplace(std::llround(p.e * static_cast<double>(units)),
                   std::llround(p.f * static_cast<double>(units)));
  return places;
}

// --- All pieces

TEST(IteratedFunctions, FirstPiecesAreTheKnownOnes) {
  EXPECT_EQ(deterministic(all(dragon), 0), DPieces{DMap{}});
  const DPieces one = deterministic(all(dragon), 1);
  EXPECT_EQ(one, (DPieces{dragon[0], dragon[1]}));
  // The second map of the first piece: a turn by 45 degrees, then by 135, half as large
  EXPECT_EQ(deterministic(all(dragon), 2)[1], (DMap{-0.5, 0, 0, -0.5, 1, 0}));
}

TEST(IteratedFunctions, PiecesOfTheTriangleHaveNoBitInCommon) {
  for (int level = 1; level <= 8; ++level) {
    const Whole side = Whole{1} << level;
    Places right;
    for (Whole x = 0; x < side; ++x)
      for (Whole y = 0; y < side; ++y)
        if ((x & y) == 0) right.emplace(x, y);
    EXPECT_EQ(places_of(deterministic(all(right_triangle), level), side), right) << level;
  }
}

TEST(IteratedFunctions, PiecesOfTheCarpetHaveNoOneInCommonInBase3) {
  const auto missing = [](Whole x, Whole y) {
    for (; x > 0 || y > 0; x /= 3, y /= 3)
      if (x % 3 == 1 && y % 3 == 1) return true;
    return false;
  };
  Whole side = 1;
  for (int level = 1; level <= 4; ++level) {
    side *= 3;
    Places right;
    for (Whole x = 0; x < side; ++x)
      for (Whole y = 0; y < side; ++y)
        if (!missing(x, y)) right.emplace(x, y);
    EXPECT_EQ(places_of(deterministic(all(carpet), level), side), right) << level;
  }
}

/// Koch's curve by replacing segments, in complex numbers: nothing of the maps is used.
std::vector<std::complex<double>> koch_curve(int levels) {
  using namespace std::complex_literals;
  std::vector<std::complex<double>> way{0.0, 1.0};
  const std::complex<double> turn = std::polar(1.0, std::numbers::pi / 3);
  for (int k = 0; k < levels; ++k) {
    std::vector<std::complex<double>> finer{way[0]};
    for (Index i = 1; i < way.size(); ++i) {
      const auto third = (way[i] - way[i - 1]) / 3.0, b = way[i - 1] + third;
      for (const auto corner : {b, b + third * turn, b + third, way[i]}) finer.push_back(corner);
    }
    way = finer;
  }
  return way;
}

TEST(IteratedFunctions, KochsMapsLeaveKochsCurve) {
  constexpr int levels = 5;
  constexpr double near = 1e-15 * 8;
  const auto way = koch_curve(levels);
  const DPieces pieces = deterministic(all(koch), levels);
  ASSERT_EQ(pieces.size() + 1, way.size());
  for (Index i = 0; i < pieces.size(); ++i) {
    // The map applied last says which quarter of the curve: the digits stand the other way round
    Index along = 0;
    for (Index k = 0, rest = i; k < levels; ++k, rest /= 4) along = 4 * along + rest % 4;
    const Point<double> begin = pieces[i](Point<double>{0, 0}), end = pieces[i](Point<double>{1, 0});
    EXPECT_NEAR(std::abs(std::complex(begin.x, begin.y) - way[along]), 0, near) << i;
    EXPECT_NEAR(std::abs(std::complex(end.x, end.y) - way[along + 1]), 0, near) << i;
  }
}

/// The largest distance of a point of one set from the other.
double farthest(const std::vector<dvec2>& from, const std::vector<dvec2>& to) {
  double most = 0;
  for (const dvec2 p : from) {
    double least = std::numeric_limits<double>::max();
    for (const dvec2 q : to) least = std::min(least, length_of(p - q));
    most = std::max(most, least);
  }
  return most;
}

std::vector<dvec2> corners_of(const DPieces& pieces, const std::vector<dvec2>& shape) {
  std::vector<dvec2> corners;
  for (const DMap& p : pieces)
    for (const dvec2 corner : shape) corners.push_back(p(corner));
  return corners;
}

TEST(IteratedFunctions, LevelsAreAsNearToTheAttractorAsTheySay) {
  const std::vector<dvec2> shape{{0.2, 0}, {0.9, 0.1}, {0.4, 0.9}}, one{{0.1, 0.2}};
  const auto try_all = [&](Maps<double> maps, int deep) {
    const double c = contraction(maps), far = reach<double>(maps, shape, c);
    const DPieces deepest = deterministic(maps, deep);
    const std::vector<dvec2> attractor = corners_of(deepest, one);
    const double off = largest_stretch(deepest) * reach<double>(maps, one, c);
    for (int level = 0; level <= 4; ++level) {
      const DPieces pieces = deterministic(maps, level);
      const double bound = largest_stretch(pieces) * far + off;
      EXPECT_LE(largest_stretch(pieces), std::pow(c, level));
      const std::vector<dvec2> corners = corners_of(pieces, shape);
      EXPECT_LE(farthest(corners, attractor), bound) << level;
      EXPECT_LE(farthest(attractor, corners), bound) << level;
    }
  };
  try_all(sierpinski, 7);
  try_all(koch, 5);
  try_all(dragon, 11);
  try_all(fern, 5);
}

TEST(IteratedFunctions, PiecesInFloatAreThoseInDouble) {
  std::vector<Map<float>> maps;
  for (const DMap& f : dragon)
    maps.push_back({static_cast<float>(f.a), static_cast<float>(f.b), static_cast<float>(f.c),
                    static_cast<float>(f.d), static_cast<float>(f.e), static_cast<float>(f.f)});
  const auto coarse = deterministic<float>(maps, 9);
  const DPieces fine = deterministic(all(dragon), 9);
  for (Index i = 0; i < fine.size(); ++i) {
    // Halves and sums of them: float has all of these numbers
    ASSERT_EQ(double{coarse[i].a}, fine[i].a);
    ASSERT_EQ(double{coarse[i].e}, fine[i].e);
  }
}

// --- One point

std::vector<dvec2> played(Maps<double> maps, const Game<double>& game) {
  std::vector<dvec2> points;
  chaos_game(maps, shares_by_area(maps), game, [&](dvec2 p) { points.push_back(p); });
  return points;
}

TEST(IteratedFunctions, PointsStayAsNearToTheAttractorAsTheGameSays) {
  const dvec2 begin{3, -2};
  const std::vector<dvec2> start{begin}, one{{0.1, 0.2}};
  constexpr double pixel = 1.0 / 256;
  for (const Maps<double> maps : {all(sierpinski), all(dragon), all(carpet)}) {
    const double c = contraction(maps), far = reach<double>(maps, start, c);
    const Whole skipped = moves_until(pixel, far, c);
    EXPECT_LE(std::pow(c, skipped) * far, pixel);
    EXPECT_GT(std::pow(c, skipped - 1) * far, pixel * (1 - 1e-9));
    const int deep = maps.size() == 2 ? 13 : maps.size() == 3 ? 8 : 4;
    const DPieces deepest = deterministic(maps, deep);
    const double off = largest_stretch(deepest) * reach<double>(maps, one, c);
    EXPECT_LE(farthest(played(maps, {begin, skipped, 500, 3}), corners_of(deepest, one)), pixel + off);
  }
}

TEST(IteratedFunctions, SharesAreAreasAndNoneIsLeftOut) {
  const std::vector<double> shares = shares_by_area(all(fern));
  EXPECT_DOUBLE_EQ(shares[1], 0.85 * 0.85 + 0.04 * 0.04);
  // The stem has no area
  EXPECT_NEAR(shares[0], (shares[1] + shares[2] + shares[3]) / 100, 1e-15);
  const std::array lines{DMap{0.5, 0, 0, 0, 0, 0}, DMap{0.5, 0, 0, 0, 0.5, 0}};
  EXPECT_EQ(shares_by_area(all(lines)), (std::vector<double>{1, 1}));
  const std::array<double, 3> quarters{1, 2, 1};
  EXPECT_EQ(chosen(quarters, 0), 0u);
  EXPECT_EQ(chosen(quarters, 0.25), 1u);
  EXPECT_EQ(chosen(quarters, 0.7499999), 1u);
  EXPECT_EQ(chosen(quarters, 0.75), 2u);
  EXPECT_EQ(chosen(quarters, 0x1.fffffffffffffp-1), 2u);
}

TEST(IteratedFunctions, MapsAreDrawnAsOftenAsTheirSharesSay) {
  constexpr Whole moves = 100'000;
  const std::vector<double> shares = shares_by_area(all(fern));
  std::array<double, 4> drawn{};
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Moved<double>>) ++drawn[step.map];
  };
  chaos_game(all(fern), shares, Game<double>{{0, 0}, 0, moves, 5}, [](dvec2) {}, watch);
  const double sum = shares[0] + shares[1] + shares[2] + shares[3];
  for (Index i = 0; i < 4; ++i) {
    const double p = shares[i] / sum, five_deviations = 5 * std::sqrt(moves * p * (1 - p));
    EXPECT_NEAR(drawn[i], moves * p, five_deviations) << i;
  }
}

// --- Contractions

TEST(IteratedFunctions, WhatContractsIsDecidedExactly) {
  EXPECT_FALSE(contracts(DMap{1, 0, 0, 1, 0, 0}));
  EXPECT_TRUE(contracts(DMap{1 - 0x1p-53, 0, 0, 1 - 0x1p-53, 5, 5}));
  // Short numbers, and yet it stretches by the golden ratio
  EXPECT_FALSE(contracts(DMap{1, 1, 0, -1, 0, 0}));
  EXPECT_FALSE(contracts(DMap{0, 1, 0, 0, 0, 0}));
  EXPECT_TRUE(contracts(DMap{0, 0x1.fffffffffffffp-1, 0, 0, 0, 0}));
  // Both eigenvalues above 1
  EXPECT_FALSE(contracts(DMap{2, 0, 0, 2, 0, 0}));
  EXPECT_FALSE(contracts(DMap{0x1p1000, 0, 0, 5e-324, 0, 0}));
  EXPECT_DOUBLE_EQ(stretch(fern[1]), std::hypot(0.85, 0.04));
  EXPECT_DOUBLE_EQ(stretch(dragon[1]), std::numbers::sqrt2 / 2);
  EXPECT_DOUBLE_EQ(stretch(DMap{1, 1, 0, 1, 0, 0}), std::numbers::phi);
}

// --- Dimension

double dimension_of(Maps<double> maps) {
  std::vector<double> ratios;
  for (const DMap& f : maps) ratios.push_back(stretch(f));
  return similarity_dimension(ratios, 60);
}

TEST(IteratedFunctions, DimensionsAreThoseInClosedForm) {
  constexpr double near = 2e-15;
  EXPECT_NEAR(dimension_of(sierpinski), std::log(3.0) / std::log(2.0), near);
  EXPECT_NEAR(dimension_of(carpet), std::log(8.0) / std::log(3.0), near);
  EXPECT_NEAR(dimension_of(koch), std::log(4.0) / std::log(3.0), near);
  EXPECT_NEAR(dimension_of(dragon), 2, near);
  // r + r^2 = 1 is that of the golden ratio: halves and quarters have its logarithm to base 2
  const std::array<double, 2> golden{0.5, 0.25};
  EXPECT_NEAR(similarity_dimension(golden, 60), std::log2(std::numbers::phi), near);
  const std::array<double, 1> point{0.5};
  EXPECT_NEAR(similarity_dimension(point, 60), 0, near);
  EXPECT_TRUE(std::ranges::all_of(koch, is_similarity<double>));
  EXPECT_FALSE(is_similarity(fern[2]));
  EXPECT_TRUE(test::states(page, "log 3 / log 2 = {}", {dimension_of(sierpinski)}));
  EXPECT_TRUE(test::states(page, "log 8 / log 3 = {}", {dimension_of(carpet)}));
}

/// The slope of log boxes over log 1/side, and its standard error.
std::pair<double, double> fitted(const std::vector<dvec2>& counts) {
  const auto n = static_cast<double>(counts.size());
  dvec2 mean{};
  double xx = 0, xy = 0, rest = 0;
  for (const dvec2 p : counts) mean += p / n;
  for (const dvec2 p : counts) xx += (p.x - mean.x) * (p.x - mean.x), xy += (p.x - mean.x) * (p.y - mean.y);
  const double slope = xy / xx;
  for (const dvec2 p : counts) rest += std::pow(p.y - mean.y - slope * (p.x - mean.x), 2);
  return {slope, std::sqrt(rest / (n - 2) / xx)};
}

TEST(IteratedFunctions, CountedBoxesMeasureTheDimension) {
  const std::vector<dvec2> points = played(sierpinski, {{0.1, 0.1}, 60, 100'000, 1});
  std::vector<dvec2> counts;
  for (double side = 1.0 / 4; side >= 1.0 / 64; side /= 2) {
    Places met;
    for (const dvec2 p : points)
      met.emplace(static_cast<Whole>(std::floor(p.x / side)), static_cast<Whole>(std::floor(p.y / side)));
    counts.emplace_back(-std::log(side), std::log(static_cast<double>(met.size())));
  }
  const auto [slope, error] = fitted(counts);
  // Counts of one grid hang together: the slope is off by more than its standard error says
  EXPECT_LT(std::abs(slope - dimension_of(sierpinski)), 0.05);
  EXPECT_GT(std::abs(slope - dimension_of(sierpinski)), 2 * error);
  EXPECT_TRUE(test::states(page, "the slope {} with a standard error of {}", {slope, error}));
}

// --- Exhibits, steps and refusals

/// Pixels of 1/200 that points reach.
template <class Play>
double pixels_of(const Play& play) {
  Places reached;
  play([&](dvec2 p) {
    reached.emplace(static_cast<Whole>(std::floor(200 * p.x)), static_cast<Whole>(std::floor(200 * p.y)));
  });
  return static_cast<double>(reached.size());
}

TEST(IteratedFunctions, ExhibitsAreAsWrongAsThePageSays) {
  const Game<double> game{{0.8, 0.3}, 60, 10'000, 1};
  const std::vector<double> leaves = shares_by_area(all(fern)), halves{1, 1};
  EXPECT_TRUE(
      test::states(page, "10,000 points of the fern reach {} pixels instead of {}",
                   {pixels_of([&](const auto& plot) { equal_shares(all(fern), leaves, game, plot); }),
                    pixels_of([&](const auto& plot) { chaos_game(all(fern), leaves, game, plot); })}));
  EXPECT_TRUE(
      test::states(page, "as many of the dragon reach {} instead of {}",
                   {pixels_of([&](const auto& plot) { low_bits(all(dragon), halves, game, plot); }),
                    pixels_of([&](const auto& plot) { chaos_game(all(dragon), halves, game, plot); })}));
}

TEST(IteratedFunctions, PointsReachMoreOfTheFernThanPiecesDo) {
  const std::vector<double> shares = shares_by_area(all(fern));
  const double by_points = pixels_of(
      [&](const auto& plot) { chaos_game(all(fern), shares, Game<double>{{0, 0}, 0, 4096, 1}, plot); });
  const double by_pieces = pixels_of([&](const auto& plot) {
    for (const DMap& p : deterministic(all(fern), 6)) plot(p(dvec2{0, 0}));
  });
  EXPECT_TRUE(test::states(page, "4,096 points of the game reach {} pixels of the fern, as many pieces {}",
                           {by_points, by_pieces}));
}

TEST(IteratedFunctions, StepsFollowTheGrammarAndObservedEqualsUnobserved) {
  Recorder<Mapped<double>, LevelDone, Finished> seen;
  const DPieces pieces = deterministic(all(koch), 3, seen);
  EXPECT_EQ(pieces, deterministic(all(koch), 3));
  const auto images = gradus::all<Mapped<double>>(seen);
  ASSERT_EQ(images.size(), 4u + 16u + 64u);
  for (const Mapped<double>& m : images) EXPECT_EQ(m.image, koch[m.map](m.from));
  for (Index i = 0; i < 64; ++i) EXPECT_EQ(images[20 + i].image, pieces[i]);
  EXPECT_EQ(gradus::all<LevelDone>(seen).back().pieces, 64);

  Recorder<Moved<double>, GameFinished> moves;
  std::vector<dvec2> points;
  const Game<double> game{{1, 1}, 5, 20, 9};
  chaos_game(all(koch), shares_by_area(all(koch)), game, [&](dvec2 p) { points.push_back(p); }, moves);
  EXPECT_EQ(points, played(koch, game));
  dvec2 at = game.begin;
  for (const Moved<double>& m : gradus::all<Moved<double>>(moves)) {
    at = koch[m.map](at);
    EXPECT_EQ(m.to, at);
    EXPECT_EQ(m.plotted, m.move > game.skip);
  }

  Recorder<Widened, Halved, Enclosed> halved;
  const std::array<double, 3> ratios{0.5, 0.5, 0.5};
  EXPECT_EQ(similarity_dimension(ratios, 20, halved), similarity_dimension(ratios, 20));
  EXPECT_TRUE(every<Halved>(halved, [](const Halved& h) { return (h.sum > 1 ? h.low : h.high) == h.s; }));
}

TEST(IteratedFunctions, MistakesAreNamed) {
  const auto drop = [](dvec2) {};
  const std::array turn{DMap{0.5, 0, 0, 0.5, 0, 0}, DMap{0, -1, 1, 0, 0, 0}};
  const std::array lost{DMap{0.5, 0, 0, 0.5, 0, std::nan("")}};
  const std::vector<double> ones{1, 1}, few{1}, none{0, 1};
  EXPECT_THROW(deterministic(Maps<double>{}, 1), ContractViolation);
  EXPECT_THROW(deterministic(all(turn), 1), ContractViolation);
  EXPECT_THROW(deterministic(all(lost), 1), ContractViolation);
  EXPECT_THROW(deterministic(all(dragon), 23), ContractViolation);
  EXPECT_THROW(deterministic(all(carpet), 8), ContractViolation);
  EXPECT_THROW(chaos_game(all(dragon), few, Game<double>{}, drop), ContractViolation);
  EXPECT_THROW(chaos_game(all(dragon), none, Game<double>{}, drop), ContractViolation);
  EXPECT_THROW(chaos_game(all(dragon), ones, Game<double>{{0, 0}, -1, 1, 1}, drop), ContractViolation);
  EXPECT_THROW(moves_until(0, 1, 0.5), ContractViolation);
  EXPECT_THROW(moves_until(1, 2, 1), ContractViolation);
  EXPECT_THROW(moves_until(1e-9, 1, 1 - 0x1p-53), ContractViolation);
  EXPECT_THROW(similarity_dimension({}, 3), ContractViolation);
  EXPECT_THROW(similarity_dimension(ones, 3), ContractViolation);
  try {
    deterministic(all(turn), 1);
  } catch (const ContractViolation& violation) {
    EXPECT_NE(std::string(violation.what()).find("map 2 does not contract"), std::string::npos);
  }
}

}  // namespace
}  // namespace gradus::iterated_functions
