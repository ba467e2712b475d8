// A periodic curve at places between its samples, by the kernel of a period and by sincs of one period alone;
// and the alias of frequencies far above the rate.

#include "antialiasing/sampling_theorem/sampling_theorem.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

constexpr int places = 64;

/// A sum of sines below half the rate, its samples, and places between them.
struct Curve {
  std::vector<double> samples, size, phase, at, values;

  explicit Curve(std::int64_t n) {
    Random random(171, static_cast<std::uint64_t>(n));
    for (std::int64_t m = 0; 2 * m < n; ++m) {
      size.push_back(random.uniform(-1, 1));
      phase.push_back(random.unit());
    }
    for (std::int64_t k = 0; k < n; ++k) samples.push_back(value(static_cast<double>(k)));
    for (int i = 0; i < places; ++i) at.push_back(random.uniform(0, static_cast<double>(n)));
    values.resize(places);
  }
  double value(double x) const {
    const auto n = 2 * static_cast<double>(size.size());
    double sum = 0;
    for (std::size_t m = 0; m < size.size(); ++m)
      sum += size[m] *
             std::sin(2 * std::numbers::pi * (std::fmod(static_cast<double>(m) * x, n) / n + phase[m]));
    return sum;
  }
};

template <class Kernel>
Case case_of(std::string method, Standing standing, std::int64_t n, const Kernel& kernel) {
  const auto curve = std::make_shared<Curve>(n);
  const auto run = [curve, kernel] {
    for (std::size_t i = 0; i < places; ++i)
      curve->values[i] =
          sampling_theorem::reconstruct(std::span<const double>(curve->samples), curve->at[i], kernel);
  };
  run();
  Error::Sum sum;
  for (std::size_t i = 0; i < places; ++i) sum.add(std::abs(curve->values[i] - curve->value(curve->at[i])));
  return {.method = std::move(method),
          .standing = standing,
          .workload = {fmt::format("{} samples", n), static_cast<double>(n)},
          .items = places,
          .run = run,
          .error = sum.error()};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::int64_t n : {16, 64, 256, 1024}) {
    all.push_back(case_of("reconstruction", Standing::taught, n, sampling_theorem::Dirichlet{n}));
    all.push_back(case_of("sincs of one period", Standing::faulty, n, sampling_theorem::sinc));
  }
  return all;
}

}  // namespace

Subject sampling_theorem() {
  return {.topic = "sampling_theorem",
          .title = "The value of a periodic curve between its samples",
          .item = "place",
          .unit = "parts of the curve",
          .measure = "samples in a period",
          .telling = "64 samples",
          .cases = cases,
          .choice = {"reconstruction", "the curve itself, to rounding"}};
}

}  // namespace gradus::bench
