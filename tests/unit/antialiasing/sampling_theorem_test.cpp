// Goldens, the rules against brute force in rationals, curves that come back and those that don't, the wheel,
// refusals. The pictures' artefacts stand in sampling_theorem/test_patterns_test.cpp.

#include "antialiasing/sampling_theorem/sampling_theorem.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "antialiasing/sampling_theorem/sampling_theorem_notes.hpp"
#include "core/random.hpp"
#include "core/record.hpp"

namespace gradus::sampling_theorem {
namespace {

std::vector<double> sine(double f, double fs, std::size_t count, double phase = 0) {
  std::vector<double> samples(count);
  sample([&](double t) { return sin_cos_half_turns(2 * (f * t + phase)).sin; }, fs, std::span(samples));
  return samples;
}

TEST(SamplingTheorem, AtTwiceTheFrequencyTheSineIsGone) {
  // G001-107: 5 Hz at 10 samples a second, phase 0
  for (const double value : sine(5, 10, 5)) EXPECT_NEAR(value, 0, 1e-12);
}

TEST(SamplingTheorem, NineHertzAtTenIsOneBackwards) {
  // G001-108
  const std::vector<double> expected{0.0, -0.5877852522924734, -0.9510565162951538, -0.9510565162951534,
                                     -0.5877852522924725};
  const std::vector<double> nine = sine(9, 10, 5), back = sine(-1, 10, 5);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(nine[k], expected[k], 1e-12);
    EXPECT_NEAR(nine[k], back[k], 1e-12);
  }
  EXPECT_EQ(alias_of(9.0, 10.0), -1);
}

TEST(SamplingTheorem, WagonWheels) {
  // G001-109: revolutions a second, frames a second, spokes; what it looks like
  const std::array<std::array<int, 4>, 7> known{{{1, 24, 1, 1},
                                                 {13, 24, 1, -11},
                                                 {23, 24, 1, -1},
                                                 {24, 24, 1, 0},
                                                 {30, 24, 1, 6},
                                                 {2, 24, 8, -1},
                                                 {1, 24, 8, 1}}};
  for (const auto& [f, fps, n, seen] : known) {
    EXPECT_EQ(apparent_speed<double>(f, fps, n), seen) << f << " rev/s, " << n;
    EXPECT_EQ(apparent_speed(Exact(f), Exact(fps), n), Exact(seen)) << f << " rev/s, " << n;
  }
}

TEST(SamplingTheorem, TheAliasIsTheNearestOfAllThatFit) {
  // Brute force over multiples of the rate, in rationals
  Random random(156);
  int ties = 0;
  for (int i = 0; i < 300; ++i) {
    ExactScope scope;
    const Exact f{random.uniform_int(-60, 60), random.uniform_int(1, 6)},
        fs{random.uniform_int(1, 30), random.uniform_int(1, 6)};
    const Exact alias = alias_of(f, fs);
    EXPECT_TRUE(-fs < alias + alias && alias + alias <= fs);
    bool whole = false;
    for (int n = -400; n <= 400 && !whole; ++n) whole = f - Exact(n) * fs == alias;
    EXPECT_TRUE(whole);
    ties += alias + alias == fs;
  }
  EXPECT_GT(ties, 3);
}

TEST(SamplingTheorem, TheAliasOfDoublesIsExact) {
  EXPECT_EQ(alias_of(5.0, 10.0), 5);
  EXPECT_EQ(alias_of(-5.0, 10.0), 5);
  EXPECT_EQ(alias_of(15.0, 10.0), 5);
  EXPECT_EQ(alias_of(1e300, 3.0), static_cast<double>(std::remainder(1e300, 3.0)));
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(alias_of(3 * least, 2 * least), least);
  EXPECT_EQ(alias_of(0.1, 0.3), 0.1);
  EXPECT_EQ(alias_of(0.0, 1.0), 0);
}

TEST(SamplingTheorem, EnoughIsStrictlyMoreThanTwice) {
  EXPECT_FALSE(is_enough(5.0, 10.0));
  EXPECT_TRUE(is_enough(5.0, std::nextafter(10.0, 11.0)));
  EXPECT_TRUE(is_enough(-4.9, 10.0));
  EXPECT_FALSE(is_enough(Exact(1, 3), Exact(2, 3)));
  EXPECT_FALSE(is_enough(1e308, 1.7e308));
}

/// The largest difference, over a fine row of places, of what comes back from what was sampled.
double worst_of(const std::vector<double>& samples, double f, double fs, double phase) {
  const Dirichlet kernel{std::ssize(samples)};
  double worst = 0;
  for (int i = 0; i < 16 * static_cast<int>(samples.size()); ++i) {
    const double x = i / 16.0;
    const double right = sin_cos_half_turns(2 * (f * x / fs + phase)).sin;
    worst = std::max(worst, std::abs(reconstruct(std::span<const double>(samples), x, kernel) - right));
  }
  return worst;
}

TEST(SamplingTheorem, ReconstructionWorksAboveTwiceAndFailsBelow) {
  // 12 samples in a second: 0 to 5 Hz come back, 6 and more don't
  const double phase = 0.125;
  for (int f = 0; f <= 24; ++f) {
    const double worst = worst_of(sine(f, 12, 12, phase), f, 12, phase);
    if (is_enough<double>(f, 12)) {
      EXPECT_LT(worst, 1e-13) << f;
    } else {
      EXPECT_GT(worst, 0.7) << f;
    }
  }
  // What comes back instead is the alias
  EXPECT_LT(worst_of(sine(10, 12, 12, phase), alias_of(10.0, 12.0), 12, phase), 1e-13);
}

TEST(SamplingTheorem, AtExactlyTwiceThePhaseDecidesTheSize) {
  // sin(2 pi (6 t + phase)) at 12: sin(2 pi phase) of it is left
  for (const double phase : {0.0, 1 / 12.0, 0.125, 0.25}) {
    const std::vector<double> samples = sine(6, 12, 12, phase);
    const double left = std::abs(samples[0]);
    EXPECT_NEAR(left, std::sin(2 * std::numbers::pi * phase), 1e-15);
    for (int i = 0; i < 48; ++i) {
      const double back = reconstruct(std::span<const double>(samples), i / 4.0, Dirichlet{12});
      EXPECT_NEAR(back, left * std::cos(std::numbers::pi * i / 4.0), 1e-14);
    }
  }
}

TEST(SamplingTheorem, TheDirichletKernelIsAllSincsOfAPeriod) {
  for (const std::int64_t n : {1, 2, 5, 8}) {
    for (double x = -9.7; x < 10; x += 0.37) {
      // An even number: the series converges where far kernels are taken in pairs
      double sum = sinc(x);
      for (int m = 1; m < 20000; ++m) sum += sinc(x - double(m * n)) + sinc(x + double(m * n));
      EXPECT_NEAR(Dirichlet{n}(x), sum, 1e-4) << n << " " << x;
    }
    for (int k = -5; k <= 5; ++k) EXPECT_EQ(Dirichlet{n}(k), k % n == 0 ? 1 : 0) << n << " " << k;
  }
}

TEST(SamplingTheorem, OnePeriodOfSincsIsNotEnough) {
  // Beside the ends the kernels of all other periods are missing
  const std::vector<double> samples = sine(3, 10, 10, 0.1);
  const double right = sin_cos_half_turns(2 * (0.3 * 9.5 + 0.1)).sin;
  EXPECT_NEAR(reconstruct(std::span<const double>(samples), 9.5, Dirichlet{10}), right, 1e-14);
  EXPECT_GT(std::abs(reconstruct(std::span<const double>(samples), 9.5, sinc) - right), 0.1);
}

TEST(SamplingTheorem, StepsFollowTheGrammar) {
  Recorder<Sampled<double>, Folded<double>, KernelAdded, FrameTaken<double>> seen;
  std::vector<double> samples(4), turns(3);
  sample([](double t) { return 3 * t; }, 2.0, std::span(samples), seen);
  EXPECT_EQ(alias_of(7.0, 2.0, seen), 1);
  const double value = reconstruct(std::span<const double>(samples), 0.5, Dirichlet{4}, seen);
  film_wheel(5.0, 4.0, 1, std::span(turns), seen);
  ASSERT_EQ(seen.events().size(), 4u + 1 + 4 + 3);
  std::int64_t k = 0;
  EXPECT_TRUE(every<Sampled<double>>(seen, [&](const Sampled<double>& s) {
    return s.k == k++ && s.time == static_cast<double>(s.k) / 2 && s.value == 3 * s.time;
  }));
  const auto folded = std::get<Folded<double>>(seen.events()[4].step);
  EXPECT_TRUE(folded.tie && folded.f == 7 && folded.fs == 2 && folded.alias == 1);
  double sum = 0;
  EXPECT_TRUE(
      every<KernelAdded>(seen, [&](const KernelAdded& a) { return a.sum == (sum += a.sample * a.kernel); }));
  EXPECT_EQ(sum, value);
  EXPECT_TRUE(every<FrameTaken<double>>(seen, [&](const FrameTaken<double>& t) {
    return t.turn == 1.25 * static_cast<double>(t.k) && t.seen == 0.25 * static_cast<double>(t.k);
  }));
}

TEST(SamplingTheorem, ObservedEqualsUnobserved) {
  const std::vector<double> samples = sine(3, 10, 10, 0.3);
  int steps = 0;
  const auto count = [&](const auto&) { ++steps; };
  const std::span<const double> all(samples);
  EXPECT_EQ(reconstruct(all, 1.3, Dirichlet{10}, count), reconstruct(all, 1.3, Dirichlet{10}));
  EXPECT_EQ(alias_of(0.7, 0.3, count), alias_of(0.7, 0.3));
  EXPECT_EQ(steps, 11);
}

TEST(SamplingTheorem, WhatIsSeenIsTheSamePicture) {
  // In rationals: the true turn and the seen one differ by whole spokes, and no way is shorter
  Random random(158);
  for (int i = 0; i < 500; ++i) {
    ExactScope scope;
    const Exact f{random.uniform_int(-200, 200), random.uniform_int(1, 9)}, fps(random.uniform_int(1, 60));
    const std::int64_t n = random.uniform_int(1, 12);
    std::array<Exact, 4> seen{Exact(0), Exact(0), Exact(0), Exact(0)};
    int frames = 0;
    film_wheel(f, fps, n, std::span<Exact>(seen), [&](const FrameTaken<Exact>& taken) {
      const Exact spokes = (taken.turn - taken.seen) * Exact(n);
      EXPECT_EQ(spokes, Exact(floor(spokes)));
      ++frames;
    });
    EXPECT_EQ(frames, 4);
    EXPECT_TRUE(size(seen[1]) * Exact(2 * n) <= Exact(1));
  }
}

TEST(SamplingTheoremNotes, AtLeastTwiceLetsANothingThrough) {
  // E001-50: the rule accepts 10 samples a second for 5 Hz, of which nothing comes back
  EXPECT_TRUE(at_least_twice(5.0, 10.0));
  EXPECT_FALSE(is_enough(5.0, 10.0));
  const std::vector<double> samples = sine(5, 10, 10);
  for (int i = 0; i < 40; ++i)
    EXPECT_NEAR(reconstruct(std::span<const double>(samples), i / 4.0, Dirichlet{10}), 0, 1e-14);
  EXPECT_GT(worst_of(samples, 5, 10, 0), 0.99);
}

TEST(SamplingTheoremNotes, HalfTheFrameRateSaysLittle) {
  // E001-51: 30 revolutions at 24 frames run forwards, and eight spokes run back at 2
  EXPECT_TRUE(half_frame_rate(30.0, 24.0));
  EXPECT_EQ(apparent_speed(30.0, 24.0, 1), 6);
  EXPECT_FALSE(half_frame_rate(2.0, 24.0));
  EXPECT_EQ(apparent_speed(2.0, 24.0, 8), -1);
  // Of the speeds from 0 to 96 in eighths: wrong for a wheel with a mark, and for eight spokes
  const auto wrong = [](std::int64_t n) {
    int count = 0;
    for (int i = 1; i < 8 * 96; ++i) {
      const double speed = apparent_speed(i / 8.0, 24.0, n);
      count += speed != 0 && half_frame_rate(i / 8.0, 24.0) != (speed < 0);
    }
    return count;
  };
  EXPECT_EQ(wrong(1), 288);
  EXPECT_EQ(wrong(8), 380);
}

TEST(SamplingTheorem, MistakesAreRefused) {
  std::vector<double> none;
  EXPECT_THROW(alias_of(1.0, 0.0), ContractViolation);
  EXPECT_THROW(alias_of(1.0, -1.0), ContractViolation);
  EXPECT_THROW(alias_of(1.0, std::nan("")), ContractViolation);
  EXPECT_THROW(sample([](double) { return 0.0; }, 0.0, std::span(none)), ContractViolation);
  EXPECT_THROW(reconstruct(std::span<const double>(none), 0.0, sinc), ContractViolation);
  EXPECT_THROW(apparent_speed(1.0, 24.0, 0), ContractViolation);
  EXPECT_THROW(apparent_speed(1.0, 0.0, 1), ContractViolation);
}

}  // namespace
}  // namespace gradus::sampling_theorem
