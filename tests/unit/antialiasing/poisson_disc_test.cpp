#include "antialiasing/poisson_disc/poisson_disc.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "antialiasing/poisson_disc/poisson_disc_batch.hpp"
#include "core/record.hpp"
#include "support/every_target.hpp"
#include "support/random_edges.hpp"
#include "support/sanitized.hpp"

namespace gradus::poisson_disc {
namespace {

constexpr std::uint64_t seed = 8;

std::vector<dvec2> darts(const Area& area, double radius, int misses = 300, std::uint64_t stream = 0) {
  std::vector<dvec2> samples;
  dart_throwing(area, radius, misses, Random(seed, stream), [&](dvec2 p) { samples.push_back(p); });
  return samples;
}
std::vector<dvec2> by_bridson(const Area& area, double radius, int tries = 30, std::uint64_t stream = 0) {
  std::vector<dvec2> samples;
  bridson(area, radius, tries, Random(seed, stream), [&](dvec2 p) { samples.push_back(p); });
  return samples;
}

/// In extended precision, without the grid: round a tile by asking all nine copies.
bool keep_apart(const Area& area, const std::vector<dvec2>& samples, double radius) {
  const int copies = area.wraps ? 1 : 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      for (int x = -copies; x <= copies; ++x) {
        for (int y = -copies; y <= copies; ++y) {
          const long double dx = samples[i].x - static_cast<long double>(samples[k].x) + x * area.size.x;
          const long double dy = samples[i].y - static_cast<long double>(samples[k].y) + y * area.size.y;
          if (dx * dx + dy * dy < static_cast<long double>(radius) * radius) return false;
        }
      }
    }
  }
  return true;
}

TEST(PoissonDisc, NoTwoSamplesAreNearerThanTheRadius) {
  SCOPED_TRACE(seed);
  int samples = 0;
  for (const Area& area : {Area{{1, 1}}, Area{{1, 0.7}, true}, Area{{3, 0.2}}, Area{{40, 25}, true}}) {
    for (const double part : {0.45, 0.2, 0.06}) {
      const double radius = part * std::min(area.size.x, area.size.y);
      for (std::uint64_t stream = 0; stream < (test::sanitized ? 1 : 5); ++stream) {
        const auto thrown = darts(area, radius, 100, stream), grown = by_bridson(area, radius, 20, stream);
        ASSERT_TRUE(keep_apart(area, thrown, radius)) << "darts, radius " << radius;
        ASSERT_TRUE(keep_apart(area, grown, radius)) << "bridson, radius " << radius;
        samples += static_cast<int>(thrown.size() + grown.size());
      }
    }
  }
  EXPECT_GT(samples, test::sanitized ? 2000 : 10000);
}

TEST(PoissonDisc, CopiesOfATileKeepTheirDistance) {
  SCOPED_TRACE(seed);
  const Area tile{{1, 1}, true};
  const auto samples = by_bridson(tile, 0.1);
  std::vector<dvec2> nine;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (const dvec2 p : samples) nine.push_back(p + dvec2(x, y));
    }
  }
  EXPECT_GE(least_distance({dvec2(3)}, nine), 0.1);
  // What does not wrap comes nearer across the border
  const auto plain = by_bridson({dvec2(1)}, 0.1);
  EXPECT_LT(least_distance(tile, plain), 0.1);
}

TEST(PoissonDisc, TheBatchHasTheSamplesOfBridsonToTheBit) {
  SCOPED_TRACE(seed);
  Random random(seed);
  std::size_t samples = 0;
  for (int i = 0; i < (test::sanitized ? 6 : 60); ++i) {
    const double scale = std::ldexp(1, static_cast<int>(random.uniform_int(-480, 480)));
    const dvec2 size = scale * dvec2(random.uniform(0.3, 2), random.uniform(0.3, 2));
    const Area area{size, random.unit() < 0.5};
    const double radius = std::min(size.x, size.y) / random.uniform(2, 25);
    const int tries = static_cast<int>(random.uniform_int(1, 40));
    const auto stream = static_cast<std::uint64_t>(i);
    const auto right = by_bridson(area, radius, tries, stream);
    test::on_every_target(
        [&] { ASSERT_EQ(bridson_batch(area, radius, tries, Random(seed, stream)), right) << "area " << i; });
    samples += right.size();
  }
  EXPECT_GT(samples, test::sanitized ? 500u : 5000u);
}

TEST(PoissonDisc, TheBatchHasThemAtItsSmallestAndItsThinnestToo) {
  SCOPED_TRACE(seed);
  // 11, 12 and 13 cells across; strips of few; tiles of two radii; what is large beside its radius
  for (const bool wraps : {false, true}) {
    for (const double radius : {1.5 / 11, 1.4143 / 11, 1.41422 / 12, 1.4142 / 12, 0.5, 0.04}) {
      for (const dvec2 size : {dvec2(1), dvec2(7, 1), dvec2(1, 3)}) {
        const Area area{size, wraps};
        const auto right = by_bridson(area, radius);
        test::on_every_target(
            [&] { ASSERT_EQ(bridson_batch(area, radius, 30, Random(seed)), right) << radius; });
      }
    }
  }
  EXPECT_THROW(bridson_batch({dvec2(1)}, 0.1, 0, Random(1)), ContractViolation);
  EXPECT_THROW(bridson_batch({dvec2(1)}, 0, 30, Random(1)), ContractViolation);
}

TEST(PoissonDisc, BridsonLeavesNoGapOfTwoRadii) {
  SCOPED_TRACE(seed);
  for (const bool wraps : {false, true}) {
    const Area area{{1, 1}, wraps};
    const double radius = 0.08;
    const auto samples = by_bridson(area, radius);
    double farthest = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x)
        farthest = std::max(farthest, nearest(area, samples, (dvec2(x, y) + 0.5) / 200.0).distance());
    }
    EXPECT_LT(farthest, 2 * radius);
    EXPECT_GT(farthest, 0.8 * radius);  // gaps there are
  }
}

TEST(PoissonDisc, AGridCellHoldsOneSampleAtMost) {
  for (const double radius : {0.4, 0.13, 0.05, 0.011}) {
    for (const dvec2 size : {dvec2(1, 1), dvec2(1, 0.83)}) {
      const dvec2 cell = size / dvec2(Grid({size}, radius).cells());
      EXPECT_LE(cell.x * cell.x + cell.y * cell.y, radius * radius * (1 + 1e-12));
      const ivec2 reach = Grid({size}, radius).reach();
      EXPECT_GE(reach.x * cell.x, radius * (1 - 1e-12));
      EXPECT_GE(reach.y * cell.y, radius * (1 - 1e-12));
    }
  }
}

TEST(PoissonDisc, TheGridFindsTheNearestOfThoseTooNear) {
  // Against all samples, for darts that were thrown beside
  SCOPED_TRACE(seed);
  for (const bool wraps : {false, true}) {
    const Area area{{1, 0.6}, wraps};
    std::vector<dvec2> samples;
    int asked = 0, missed = 0;
    struct Watch {
      const Area& area;
      std::vector<dvec2>& samples;
      int& asked;
      int& missed;
      void operator()(const Started&) {}
      void operator()(const Tried& t) {
        const double right = nearest(area, samples, t.place).distance();
        if (right < 0.07) EXPECT_EQ(t.nearest, right);
        EXPECT_EQ(t.kept, right * right >= safe_square(0.07));
        ++asked;
        missed += !t.kept;
        if (t.kept) samples.push_back(t.place);
      }
      void operator()(const Finished& f) { EXPECT_EQ(f.samples, static_cast<int>(samples.size())); }
    };
    dart_throwing(area, 0.07, 50, Random(seed), [](dvec2) {}, Watch{area, samples, asked, missed});
    EXPECT_GT(asked, 100);
    EXPECT_GT(missed, 50);
  }
}

TEST(PoissonDisc, BridsonStepsFollowTheGrammar) {
  Recorder<Started, Chosen, Tried, Retired, Finished> seen;
  std::vector<dvec2> samples;
  bridson({dvec2(1)}, 0.25, 8, Random(seed), [&](dvec2 p) { samples.push_back(p); }, seen);
  EXPECT_EQ(samples, by_bridson({dvec2(1)}, 0.25, 8));
  int tries = 0, chosen = 0, retired = 0;
  for (const auto& event : seen.events()) {
    if (std::holds_alternative<Chosen>(event.step)) tries = 0, ++chosen;
    if (const auto* tried = std::get_if<Tried>(&event.step)) {
      ++tries;
      if (tries > 1 || chosen > 0) {
        EXPECT_LE(tries, 8);
      }
      if (tried->inside && chosen > 0) {
        EXPECT_EQ(tried->kept, tried->nearest >= 0.25);
      }
    }
    if (std::holds_alternative<Retired>(event.step)) {
      EXPECT_EQ(tries, 8);
      ++retired;
    }
  }
  EXPECT_EQ(retired, static_cast<int>(samples.size()));  // each sample in its turn
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).samples, retired);
}

TEST(PoissonDisc, ARunIsAFunctionOfItsSeed) {
  EXPECT_EQ(by_bridson({dvec2(1)}, 0.1), by_bridson({dvec2(1)}, 0.1));
  EXPECT_NE(by_bridson({dvec2(1)}, 0.1, 30, 0), by_bridson({dvec2(1)}, 0.1, 30, 1));
}

TEST(PoissonDisc, BestCandidatesAreTheFarthestAndTheLeastDistanceIsReturned) {
  SCOPED_TRACE(seed);
  for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{16}, std::size_t{100}}) {
    std::vector<dvec2> samples(count);
    const double least = best_candidate(samples, 4, Random(seed));
    EXPECT_EQ(least, least_distance({dvec2(1), true}, samples));
    for (const dvec2 p : samples) EXPECT_TRUE(contains({dvec2(1)}, p));
    // Far better than random ones, whose least distance is about 0.5 / n
    if (count >= 16) {
      EXPECT_GT(least, 0.35 / std::sqrt(static_cast<double>(count)));
    }
  }
}

TEST(PoissonDisc, BestCandidateStepsFollowTheGrammar) {
  Recorder<Started, Compared, Taken, Finished> seen;
  std::vector<dvec2> samples(6), again(6);
  best_candidate(samples, 3, Random(seed), seen);
  best_candidate(again, 3, Random(seed));
  EXPECT_EQ(samples, again);
  double best = -1;
  int compared = 0, taken = 0;
  for (const auto& event : seen.events()) {
    if (const auto* c = std::get_if<Compared>(&event.step)) {
      EXPECT_EQ(c->best, c->nearest > best);
      best = std::max(best, c->nearest);
      ++compared;
    }
    if (const auto* t = std::get_if<Taken>(&event.step)) {
      EXPECT_EQ(t->nearest, best);
      EXPECT_EQ(t->sample, samples[static_cast<std::size_t>(taken)]);
      EXPECT_EQ(t->candidates, std::exchange(compared, 0));
      best = -1;
      ++taken;
    }
  }
  EXPECT_EQ(taken, 6);
}

TEST(PoissonDisc, EdgesAreCoveredWithoutBias) {
  SCOPED_TRACE(seed);
  constexpr int edges = test::sanitized ? 2000 : 20000;
  double sum = 0, squares = 0;
  for (int i = 0; i < edges; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    const test::StraightEdge edge = test::random_edge(random);
    std::array<dvec2, 16> samples;
    best_candidate(samples, 4, random.split(1));
    const auto inside = std::ranges::count_if(samples, [&](dvec2 p) { return edge.holds(p); });
    const double off = static_cast<double>(inside) / 16 - edge.area();
    sum += off;
    squares += off * off;
  }
  const double rms = std::sqrt(squares / edges);
  EXPECT_LT(std::abs(sum / edges), 4 * rms / std::sqrt(edges));
  RecordProperty("rms", fmt::format("{:.4f}", rms));
  EXPECT_LT(rms, 0.06);  // 16 independent samples: 0.088
}

TEST(PoissonDisc, RefusesWhatItCannotFill) {
  const auto nothing = [](dvec2) {};
  EXPECT_THROW(bridson({dvec2(1)}, 0, 30, Random(1), nothing), ContractViolation);
  EXPECT_THROW(bridson({dvec2(1)}, std::numeric_limits<double>::infinity(), 30, Random(1), nothing),
               ContractViolation);
  EXPECT_THROW(bridson({dvec2(1)}, 1e-5, 30, Random(1), nothing), ContractViolation);
  // Squares of such distances are 0: none would be too near, and there would be no end
  EXPECT_THROW(bridson({dvec2(0x1p-540)}, 0x1p-543, 30, Random(1), nothing), ContractViolation);
  EXPECT_EQ(by_bridson({dvec2(0x1p-480)}, 0x1p-483).size(), by_bridson({dvec2(1)}, 0.125).size());
  EXPECT_THROW(bridson({dvec2(1, 0)}, 0.1, 30, Random(1), nothing), ContractViolation);
  EXPECT_THROW(bridson({dvec2(1), true}, 0.6, 30, Random(1), nothing), ContractViolation);
  EXPECT_THROW(dart_throwing({dvec2(1)}, 0.1, 0, Random(1), nothing), ContractViolation);
  std::vector<dvec2> many(5000);
  EXPECT_THROW(best_candidate(many, 1, Random(1)), ContractViolation);
  // A radius beyond the area gives one sample
  EXPECT_EQ(by_bridson({dvec2(1)}, 5).size(), 1u);
}

}  // namespace
}  // namespace gradus::poisson_disc
