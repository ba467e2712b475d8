#include "antialiasing/jittered/jittered.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numeric>
#include <set>
#include <vector>

#include "antialiasing/jittered/jittered_notes.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/record.hpp"
#include "support/random_edges.hpp"
#include "support/sanitized.hpp"

namespace gradus::jittered {
namespace {

constexpr std::array all_patterns{Pattern::regular,
                                  Pattern::uniform,
                                  Pattern::jittered,
                                  Pattern::n_rooks,
                                  Pattern::correlated_multi_jittered,
                                  Pattern::sobol};
constexpr double pi = 3.14159265358979323846;

std::vector<dvec2> samples_of(Pattern pattern, int count, std::uint64_t seed = 1, ivec2 pixel = {0, 0}) {
  std::vector<dvec2> samples(static_cast<std::size_t>(count));
  put(pattern, samples, numbers_of(seed, pixel));
  return samples;
}

// --- Grids and permutations

TEST(Jittered, GridsAreAsSquareAsTheCountAllows) {
  EXPECT_EQ(grid_of(1), (ivec2{1, 1}));
  EXPECT_EQ(grid_of(4), (ivec2{2, 2}));
  EXPECT_EQ(grid_of(8), (ivec2{4, 2}));
  EXPECT_EQ(grid_of(12), (ivec2{4, 3}));
  EXPECT_EQ(grid_of(7), (ivec2{7, 1}));
  for (int count = 1; count <= 1000; ++count) {
    const ivec2 grid = grid_of(count);
    ASSERT_EQ(grid.x * grid.y, count);
    ASSERT_LE(grid.y, grid.x);
    for (int rows = grid.y + 1; rows * rows <= count; ++rows) ASSERT_NE(count % rows, 0) << count;
  }
}

TEST(Jittered, RegularSamplesAreTheMiddlesOfCells) {
  EXPECT_EQ(samples_of(Pattern::regular, 4),
            (std::vector<dvec2>{{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}));
  EXPECT_EQ(samples_of(Pattern::regular, 2), (std::vector<dvec2>{{0.25, 0.5}, {0.75, 0.5}}));
}

TEST(Jittered, PermutationsAreBijections) {
  Random random(3);
  int tried = 0;
  for (int length = 1; length <= 200; ++length) {
    for (int repeat = 0; repeat < 20; ++repeat, ++tried) {
      const std::uint32_t key = static_cast<std::uint32_t>(random());
      std::set<int> seen;
      for (int i = 0; i < length; ++i) {
        const int image = permuted(i, length, key);
        ASSERT_TRUE(0 <= image && image < length);
        seen.insert(image);
      }
      ASSERT_EQ(std::ssize(seen), length) << "length " << length << ", key " << key;
    }
  }
  EXPECT_EQ(tried, 4000);
}

TEST(Jittered, PermutationsPutEachNumberEverywhereAlike) {
  constexpr int keys = 20'000;
  Random random(4);
  for (const int length : {2, 3, 4, 5, 8, 16}) {
    const std::size_t n = static_cast<std::size_t>(length);
    std::vector<int> found(n * n);
    for (int k = 0; k < keys; ++k) {
      const std::uint32_t key = static_cast<std::uint32_t>(random());
      for (int i = 0; i < length; ++i)
        ++found[static_cast<std::size_t>(i * length + permuted(i, length, key))];
    }
    // Each of them a binomial count, within 5 sigma of its mean
    const double mean = double{keys} / length, sigma = std::sqrt(mean * (1 - 1.0 / length));
    for (const int times : found) EXPECT_LT(std::abs(times - mean), 5 * sigma) << "length " << length;
  }
}

// --- Sobol

// The first points of the sequence as Bratley and Fox 1988 have them, in natural order
TEST(Jittered, SobolCellsAreThePublishedPoints) {
  const std::array<ivec2, 8> eighths{{{0, 0}, {4, 4}, {2, 6}, {6, 2}, {1, 5}, {5, 1}, {3, 3}, {7, 7}}};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(sobol_cell(i, 3), eighths[static_cast<std::size_t>(i)]) << i;
  EXPECT_EQ(sobol_cell(0, 0), (ivec2{0, 0}));
}

/// In how many leading bits of `levels` two numbers agree.
int common(int a, int b, int levels) {
  int bits = 0;
  while (bits < levels && a >> (levels - 1 - bits) == b >> (levels - 1 - bits)) ++bits;
  return bits;
}

TEST(Jittered, CoinsKeepHowFarTwoNumbersAgree) {
  constexpr int levels = 8;
  int pairs = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Coins coins{Random(seed)};
    for (int a = 0; a < 1 << levels; ++a) {
      for (int b = 0; b < a; ++b, ++pairs)
        ASSERT_EQ(common(turned(a, levels, coins), turned(b, levels, coins), levels), common(a, b, levels));
    }
  }
  EXPECT_EQ(pairs, 10 * 256 * 255 / 2);
}

TEST(Jittered, SobolWantsPowersOfTwo) {
  std::vector<dvec2> samples(12);
  EXPECT_THROW(sobol(samples, numbers_of()), ContractViolation);
}

// --- What they are made from

TEST(Jittered, PatternsArePureFunctionsOfSeedAndPixel) {
  for (const Pattern pattern : all_patterns) {
    const auto once = samples_of(pattern, 16, 7, {3, -2});
    EXPECT_EQ(once, samples_of(pattern, 16, 7, {3, -2}));
    if (pattern == Pattern::regular) continue;
    EXPECT_NE(once, samples_of(pattern, 16, 8, {3, -2}));
    EXPECT_NE(once, samples_of(pattern, 16, 7, {-2, 3}));
  }
}

TEST(Jittered, OffsetsAreNeverOnABorder) {
  // Whatever the bits: the smallest and largest half word
  EXPECT_EQ((0 + 0.5) * 0x1p-32, 0x1p-33);
  Random random(9);
  for (int i = 0; i < 10'000; ++i) {
    const dvec2 u = offsets(random);
    ASSERT_TRUE(0 < u.x && u.x < 1 && 0 < u.y && u.y < 1);
  }
}

/// The sum of (found - expected)^2 / expected, and how many standard deviations it is off its mean.
double chi_square_off(std::span<const int> found, double expected) {
  double sum = 0;
  for (const int n : found) sum += (n - expected) * (n - expected) / expected;
  const double freedom = static_cast<double>(found.size()) - 1;
  return (sum - freedom) / std::sqrt(2 * freedom);
}

/// Every sample anywhere alike, its x and its y apart and together.
TEST(Jittered, EverywhereInThePixelAlike) {
  constexpr int bins = 8, pixels = 4000, count = 16;
  for (const Pattern pattern : all_patterns) {
    if (pattern == Pattern::regular) continue;
    std::array<int, bins * bins> found{};
    dvec2 sum{0}, squares{0};
    for (int p = 0; p < pixels; ++p) {
      for (const dvec2 s : samples_of(pattern, count, 11, {p, 0})) {
        const ivec2 bin(s * double{bins});
        ++found[static_cast<std::size_t>(bin.y * bins + bin.x)];
        sum += s;
        squares += s * s;
      }
    }
    constexpr double all = double{pixels} * count;
    EXPECT_EQ(std::accumulate(found.begin(), found.end(), 0), pixels * count);
    // Stratified counts vary less than independent ones, so only too large a sum is a fault
    EXPECT_LT(chi_square_off(found, all / (bins * bins)), 5) << static_cast<int>(pattern);
    // Mean and variance of a uniform number: 1/2 and 1/12, within 4 sigma of independent ones
    const dvec2 mean = sum / all, variance = squares / all - mean * mean;
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_LT(std::abs(mean[axis] - 0.5), 4 * std::sqrt(1 / 12.0 / all));
      EXPECT_LT(std::abs(variance[axis] - 1 / 12.0), 4 * std::sqrt(1 / 180.0 / all));
    }
  }
}

// --- Straight edges

struct Measured {
  double rmse, bias, bias_sigma;
  int edges;
};

/// The share of samples on one side against the exact area there: a pattern of its own for each edge.
Measured on_edges(Pattern pattern, int count, int edges) {
  constexpr std::uint64_t seed = 2024;
  Random random(seed, static_cast<std::uint64_t>(count));
  std::vector<dvec2> samples(static_cast<std::size_t>(count));
  double sum = 0, squares = 0;
  for (int i = 0; i < edges; ++i) {
    const test::StraightEdge edge = test::random_edge(random);
    put(pattern, samples, numbers_of(seed, {i, count}));
    const double off =
        sample_pixel({0, 0}, samples, [&](dvec2 p) { return edge.holds(p) ? 1.0 : 0.0; }) - edge.area();
    sum += off;
    squares += off * off;
  }
  const double rmse = std::sqrt(squares / edges);
  return {rmse, sum / edges, rmse / std::sqrt(double{1} * edges), edges};
}

void expect_known_errors(Pattern pattern, std::array<double, 3> known, const char* name) {
  constexpr int edges = test::sanitized ? 4'000 : 100'000;
  std::array<double, 3> found{};
  for (std::size_t k = 0; k < 3; ++k) {
    const int count = 16 << 2 * k;
    const Measured m = on_edges(pattern, count, edges);
    found[k] = m.rmse;
    fmt::print("{}, {} samples, {} edges of seed 2024: RMSE {:.5f}, bias {:.6f}\n", name, count, m.edges,
               m.rmse, m.bias);
    EXPECT_EQ(m.edges, edges);
    EXPECT_NEAR(m.rmse, known[k], 0.05 * known[k]) << name << " " << count;
    EXPECT_LT(std::abs(m.bias), 4 * m.bias_sigma) << name << " " << count;
  }
  // 16 times as many samples: the slope in a picture with two logarithmic axes
  EXPECT_NEAR(std::log(found[2] / found[0]) / std::log(16.0), -0.75, 0.02) << name;
}

TEST(Jittered, EdgesOfJitteredSamplesHaveTheKnownErrors) {
  expect_known_errors(Pattern::jittered, {.0453, .0160, .0057}, "jittered");
}
TEST(Jittered, EdgesOfCorrelatedSamplesHaveTheKnownErrors) {
  expect_known_errors(Pattern::correlated_multi_jittered, {.0368, .0129, .0045}, "correlated");
}
/// Independent samples: a binomial count has the variance a(1 - a)/n.
TEST(Jittered, EdgesOfIndependentSamplesHaveTheErrorOfCoins) {
  const Measured m = on_edges(Pattern::uniform, 16, 100'000);
  Random random(5);
  double variance = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double area = test::random_edge(random).area();
    variance += area * (1 - area) / 16 / 100'000;
  }
  EXPECT_NEAR(m.rmse, std::sqrt(variance), 0.02 * m.rmse);
  EXPECT_LT(std::abs(m.bias), 4 * m.bias_sigma);
}
TEST(Jittered, BetterPatternsHaveSmallerErrors) {
  const auto rmse = [](Pattern pattern) { return on_edges(pattern, 16, 20'000).rmse; };
  const double uniform_ = rmse(Pattern::uniform), rooks = rmse(Pattern::n_rooks),
               jitter = rmse(Pattern::jittered), correlated = rmse(Pattern::correlated_multi_jittered),
               net = rmse(Pattern::sobol);
  fmt::print("16 samples: uniform {:.4f}, rooks {:.4f}, jittered {:.4f}, correlated {:.4f}, Sobol {:.4f}\n",
             uniform_, rooks, jitter, correlated, net);
  EXPECT_LT(rooks, uniform_);
  EXPECT_LT(jitter, rooks);
  EXPECT_LT(correlated, jitter);
  EXPECT_LT(net, jitter);
}
/// Counts that are no squares, a prime one among them: no bias where the last strip is not full.
TEST(Jittered, AnyCountIsWithoutBias) {
  for (const int count : {1, 2, 3, 5, 7, 12, 13}) {
    for (const Pattern pattern : {Pattern::jittered, Pattern::n_rooks, Pattern::correlated_multi_jittered}) {
      const Measured m = on_edges(pattern, count, test::sanitized ? 1'000 : 10'000);
      EXPECT_LT(std::abs(m.bias), 4 * m.bias_sigma) << count << " " << static_cast<int>(pattern);
    }
  }
}

// --- A fine grating

struct Waves {
  double amplitude;  ///< of the false wave
  double noise;      ///< standard deviation of all that is no such wave, over the pixels
};

/// A grating of 2 - 6/64 waves to the pixel, as a picture of 64 x 64 pixels with 2 x 2 samples each: above
/// the limit of one wave to the pixel, where it looks like 6 waves across the picture.
Waves waves_of(Pattern pattern) {
  constexpr int side = 64, bin = 6;
  constexpr double frequency = 2 - double{bin} / side;
  std::array<dvec2, 4> samples;
  std::vector<double> picture;
  sample_picture(
      {{0, 0}, {side - 1, side - 1}}, pattern, samples, 5,
      [](dvec2 p) { return cos(2 * pi * frequency * p.x); },
      [&](ivec2, double grey) { picture.push_back(grey); });
  EXPECT_EQ(picture.size(), std::size_t{side} * side);
  std::complex<double> wave = 0;
  const auto phase = [](int x) { return 2 * pi * bin * x / side; };
  for (int i = 0; i < side * side; ++i)
    wave += picture[static_cast<std::size_t>(i)] * std::complex(cos(phase(i % side)), -sin(phase(i % side)));
  wave *= 2.0 / (side * side);
  double rest = 0;
  for (int i = 0; i < side * side; ++i) {
    const double of_wave = wave.real() * cos(phase(i % side)) - wave.imag() * sin(phase(i % side));
    rest += std::pow(picture[static_cast<std::size_t>(i)] - of_wave, 2);
  }
  return {std::abs(wave), std::sqrt(rest / (side * side))};
}

TEST(Jittered, AFineGratingBecomesNoiseInsteadOfAFalseWave) {
  constexpr double frequency = 2 - 6.0 / 64;
  const Waves regular_ = waves_of(Pattern::regular);
  // Two samples half a pixel apart: the full grating, times cos(pi f / 2)
  EXPECT_NEAR(regular_.amplitude, std::abs(cos(pi * frequency / 2)), 1e-12);
  EXPECT_LT(regular_.noise, 1e-12);
  // What the pixel's area has of the grating remains, for its mean is expected
  const double remains = std::abs(sin(pi * frequency) / (pi * frequency));
  for (const Pattern pattern : {Pattern::uniform, Pattern::jittered, Pattern::n_rooks,
                                Pattern::correlated_multi_jittered, Pattern::sobol}) {
    const Waves found = waves_of(pattern);
    fmt::print("pattern {}: wave {:.4f}, noise {:.4f}\n", static_cast<int>(pattern), found.amplitude,
               found.noise);
    EXPECT_NEAR(found.amplitude, remains, 4 * found.noise * std::sqrt(2.0) / 64) << static_cast<int>(pattern);
    EXPECT_LT(found.amplitude, 0.1 * regular_.amplitude) << static_cast<int>(pattern);
    EXPECT_GT(found.noise, 0.1) << static_cast<int>(pattern);
  }
}

// --- Steps

TEST(Jittered, StepsFollowTheGrammar) {
  Recorder<Cut, Placed, Finished> seen;
  std::array<dvec2, 6> samples;
  jittered(samples, numbers_of(2), seen);
  ASSERT_EQ(seen.seen(), 8u);
  EXPECT_EQ(std::get<Cut>(seen.events().front().step).grid, (ivec2{3, 2}));
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).samples, 6);
  int next = 0;
  EXPECT_TRUE(every<Placed>(seen, [&](const Placed& p) {
    const bool right = p.index == next && p.cell == ivec2(next % 3, next / 3) &&
                       p.place == samples[static_cast<std::size_t>(next)] &&
                       p.place == in_cell(p.cell, p.u, p.grid);
    ++next;
    return right;
  }));
  EXPECT_EQ(next, 6);
}

TEST(Jittered, RooksNeverAttackEachOther) {
  Recorder<Cut, Swapped, Placed, Finished> seen;
  std::array<dvec2, 8> samples;
  n_rooks(samples, numbers_of(2), seen);
  ASSERT_EQ(all<Swapped>(seen).size(), 7u);
  std::array<int, 8> row_of{0, 1, 2, 3, 4, 5, 6, 7};
  for (const Swapped& s : all<Swapped>(seen)) {
    std::swap(row_of[static_cast<std::size_t>(s.rook.x)], row_of[static_cast<std::size_t>(s.other.x)]);
    EXPECT_EQ(row_of[static_cast<std::size_t>(s.rook.x)], s.rook.y);
    EXPECT_EQ(row_of[static_cast<std::size_t>(s.other.x)], s.other.y);
  }
  for (const Placed& p : all<Placed>(seen)) EXPECT_EQ(row_of[static_cast<std::size_t>(p.cell.x)], p.cell.y);
}

TEST(Jittered, ObservedEqualsUnobserved) {
  std::vector<dvec2> samples(16);
  int steps = 0;
  const auto count = [&](const auto&) { ++steps; };
  regular(samples, count);
  EXPECT_EQ(samples, samples_of(Pattern::regular, 16));
  uniform(samples, numbers_of(), count);
  EXPECT_EQ(samples, samples_of(Pattern::uniform, 16));
  jittered(samples, numbers_of(), count);
  EXPECT_EQ(samples, samples_of(Pattern::jittered, 16));
  n_rooks(samples, numbers_of(), count);
  EXPECT_EQ(samples, samples_of(Pattern::n_rooks, 16));
  correlated_multi_jittered(samples, numbers_of(), count);
  EXPECT_EQ(samples, samples_of(Pattern::correlated_multi_jittered, 16));
  sobol(samples, numbers_of(), count);
  EXPECT_EQ(samples, samples_of(Pattern::sobol, 16));
  EXPECT_EQ(steps, 6 * 18 + 15 + 16);
}

TEST(Jittered, IsConstant) {
  constexpr dvec2 sample = [] {
    std::array<dvec2, 16> samples{};
    correlated_multi_jittered(samples, numbers_of());
    return samples[5];
  }();
  EXPECT_EQ(sample, samples_of(Pattern::correlated_multi_jittered, 16)[5]);
}

// --- Pixels

TEST(Jittered, APixelIsTheMeanOfWhatIsSeen) {
  const std::array<dvec2, 4> samples{{{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}};
  const auto colour_at = [](dvec2 p) { return dvec3(p.x, p.y, p.x > 3.5 ? 1 : 0); };
  Recorder<Looked<dvec3>> seen;
  EXPECT_EQ(sample_pixel({3, -1}, samples, colour_at, seen), (dvec3{3.5, -0.5, 0.5}));
  ASSERT_EQ(seen.seen(), 4u);
  EXPECT_EQ(all<Looked<dvec3>>(seen)[1].place, (dvec2{3.75, -0.75}));
  EXPECT_EQ(all<Looked<dvec3>>(seen)[1].mean, (dvec3{3.5, -0.75, 0.5}));
  EXPECT_THROW(sample_pixel({0, 0}, {}, colour_at), ContractViolation);
}

TEST(Jittered, PicturesHaveAPatternOfItsOwnForEachPixel) {
  std::array<dvec2, 4> samples;
  const auto colour_at = [](dvec2 p) { return p.x - std::floor(p.x); };
  std::set<double> greys;
  std::vector<ivec2> pixels;
  sample_picture({{-2, 1}, {1, 3}}, Pattern::jittered, samples, 1, colour_at, [&](ivec2 p, double grey) {
    pixels.push_back(p);
    greys.insert(grey);
    std::array<dvec2, 4> own;
    jittered(own, numbers_of(1, p));
    EXPECT_EQ(grey, sample_pixel(p, own, colour_at));
  });
  EXPECT_EQ(pixels.size(), 12u);
  EXPECT_EQ(pixels.front(), (ivec2{-2, 1}));
  EXPECT_EQ(pixels.back(), (ivec2{1, 3}));
  EXPECT_EQ(greys.size(), 12u);
  sample_picture({}, Pattern::jittered, samples, 1, colour_at, [](ivec2, double) { FAIL(); });
}

TEST(Jittered, RefusesNoneAndTooMany) {
  std::vector<dvec2> none, many(most_samples + 1);
  EXPECT_THROW(regular(none), ContractViolation);
  EXPECT_THROW(uniform(many, numbers_of()), ContractViolation);
  EXPECT_THROW(jittered(none, numbers_of()), ContractViolation);
  EXPECT_THROW(n_rooks(none, numbers_of()), ContractViolation);
  EXPECT_THROW(correlated_multi_jittered(many, numbers_of()), ContractViolation);
  EXPECT_THROW(sobol(none, numbers_of()), ContractViolation);
}

// --- The notes' listing

// E001-55, G001-113: whatever the jitter, what comes out is what went in
TEST(JitteredNotes, WholeCoordinatesGiveThePictureBack) {
  Random random(8);
  int tried = 0;
  for (int i = 0; i < 2000; ++i, ++tried) {
    const ivec2 pixel{random.uniform_int(0, 4000), random.uniform_int(0, 4000)};
    const double grey = static_cast<double>(random.uniform_int(0, 255)) / 256;
    const auto colour_of = [&](ivec2 p) { return p == pixel ? grey : -1; };
    const int asked = static_cast<int>(random.uniform_int(1, 64));
    ASSERT_EQ(whole_coordinates(pixel, asked, numbers_of(1, pixel), colour_of), grey);
  }
  EXPECT_EQ(tried, 2000);
}

// E001-56, G001-113
TEST(JitteredNotes, DividingByWhatWasAskedDarkens) {
  const std::array<int, 7> counts{1, 2, 3, 4, 5, 8, 9};
  const std::array<double, 7> gains{1, 0.5, 1.0 / 3, 1, 0.8, 0.5, 1};
  const auto white = [](dvec2) { return 1.0; };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    EXPECT_NEAR(divided_by_asked({2, 3}, counts[i], numbers_of(), white), gains[i], 1e-12) << counts[i];
    EXPECT_EQ(sample_pixel({2, 3}, samples_of(Pattern::jittered, counts[i]), white), 1) << counts[i];
  }
}

TEST(JitteredNotes, StepsAndRefusals) {
  Recorder<Cut, Placed, Looked<double>, Finished> whole, divided;
  const auto grey = [](auto) { return 0.5; };
  EXPECT_EQ(whole_coordinates({1, 1}, 5, numbers_of(), grey, whole), 0.5);
  EXPECT_EQ(divided_by_asked({1, 1}, 5, numbers_of(), grey, divided), 0.4);
  EXPECT_EQ(whole.seen(), 10u);
  EXPECT_EQ(divided.seen(), 10u);
  EXPECT_EQ(all<Looked<double>>(divided).back().mean, 0.4);
  EXPECT_TRUE(every<Looked<double>>(whole, [](const auto& l) { return l.place == dvec2(1, 1); }));
  EXPECT_THROW(whole_coordinates({-1, 1}, 4, numbers_of(), grey), ContractViolation);
  EXPECT_THROW(whole_coordinates({1, 1}, 0, numbers_of(), grey), ContractViolation);
  EXPECT_THROW(divided_by_asked({1, 1}, most_samples + 1, numbers_of(), grey), ContractViolation);
}

}  // namespace
}  // namespace gradus::jittered
