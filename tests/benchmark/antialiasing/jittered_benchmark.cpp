// Patterns of samples on straight edges across a pixel, a pattern of its own for each: time per sample, and
// how far the share of samples on one side is from the exact area.

#include "antialiasing/jittered/jittered.hpp"

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "benchmark/subject.hpp"
#include "support/random_edges.hpp"

namespace gradus::bench {
namespace {

using jittered::Pattern;

constexpr std::size_t edges = 2048;
constexpr std::uint64_t seed = 37;

std::vector<test::StraightEdge> random_edges() {
  std::vector<test::StraightEdge> all;
  Random random(seed);
  while (all.size() < edges) all.push_back(test::random_edge(random));
  return all;
}

std::vector<Case> cases() {
  const auto all = std::make_shared<const std::vector<test::StraightEdge>>(random_edges());
  std::vector<Case> cases;
  const auto add = [&](const char* name, Standing standing, Pattern pattern, int count) {
    const auto samples = std::make_shared<std::vector<dvec2>>(static_cast<std::size_t>(count));
    const auto shares = std::make_shared<std::vector<double>>(edges);
    const auto run = [=] {
      for (std::size_t i = 0; i < edges; ++i) {
        const ivec2 pixel{static_cast<int>(i), 0};
        jittered::put(pattern, *samples, jittered::numbers_of(seed, pixel));
        const auto scene = [&](dvec2 p) { return (*all)[i].holds(p) ? 1.0 : 0.0; };
        (*shares)[i] = jittered::sample_pixel({0, 0}, *samples, scene);
      }
    };
    run();
    Error::Sum sum;
    for (std::size_t i = 0; i < edges; ++i) sum.add((*shares)[i] - (*all)[i].area());
    cases.push_back({.method = name,
                     .standing = standing,
                     .workload = {fmt::format("{} samples", count), static_cast<double>(count)},
                     .items = static_cast<std::int64_t>(edges) * count,
                     .run = run,
                     .error = sum.error()});
  };
  for (const int count : {4, 16, 64, 256}) {
    add("regular", Standing::robust, Pattern::regular, count);
    add("uniform", Standing::robust, Pattern::uniform, count);
    add("jittered", Standing::taught, Pattern::jittered, count);
    add("n_rooks", Standing::robust, Pattern::n_rooks, count);
    add("correlated_multi_jittered", Standing::robust, Pattern::correlated_multi_jittered, count);
    add("sobol", Standing::robust, Pattern::sobol, count);
  }
  return cases;
}

}  // namespace

Subject jittered() {
  return {.topic = "jittered",
          .title = "Patterns of samples on straight edges",
          .item = "sample",
          .unit = "parts of a pixel",
          .measure = "samples per pixel",
          .telling = "16 samples",
          .cases = cases,
          .refined = true,
          .choice = {"jittered", "of those without false waves the smallest error for its time"}};
}

}  // namespace gradus::bench
