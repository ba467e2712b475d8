// Samples that keep their distance, in tiles of one unit: time per sample, and how far the share of a
// pattern's samples beyond a straight edge is from the exact area.

#include "antialiasing/poisson_disc/poisson_disc.hpp"

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "antialiasing/poisson_disc/poisson_disc_batch.hpp"
#include "benchmark/subject.hpp"
#include "support/random_edges.hpp"

namespace gradus::bench {
namespace {

using namespace poisson_disc;

constexpr Area tile{dvec2(1), true};
constexpr std::uint64_t seed = 31;

/// The error of patterns as they come, a new one for each edge: however many samples it has.
template <class Make>
Error error_of(const Make& make, int count) {
  // Of large patterns a few take as long as many small ones
  const int edges = count <= 256 ? 500 : 8;
  Random random(seed);
  Error::Sum sum;
  for (int i = 0; i < edges; ++i) {
    const test::StraightEdge edge = test::random_edge(random);
    const std::vector<dvec2> samples = make(Random(seed, static_cast<std::uint64_t>(i) + 1));
    const auto inside = std::ranges::count_if(samples, [&](dvec2 p) { return edge.holds(p); });
    sum.add(static_cast<double>(inside) / static_cast<double>(samples.size()) - edge.area());
  }
  return sum.error();
}

template <class Make>
Case case_of(const char* name, Standing standing, int count, Make make) {
  const auto kept = std::make_shared<std::vector<dvec2>>(make(Random(seed)));
  return {.method = name,
          .standing = standing,
          .workload = {fmt::format("about {} samples", count), static_cast<double>(count)},
          .items = std::ssize(*kept),
          .run = [=] { *kept = make(Random(seed)); },
          .error = error_of(make, count)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  // The largest has a radius of 1/255
  for (const int count : {16, 64, 256, 40316}) {
    // About 0.62 radii squared per sample, as measured for Bridson's
    const double radius = std::sqrt(0.62 / count);
    const auto collected = [radius](auto fill) {
      return [=](Random random) {
        std::vector<dvec2> samples;
        fill(radius, random, [&](dvec2 p) { samples.push_back(p); });
        return samples;
      };
    };
    all.push_back(
        case_of("bridson", Standing::taught, count,
                collected([](double r, Random random, auto plot) { bridson(tile, r, 30, random, plot); })));
    all.push_back(case_of("bridson_batch", Standing::batch, count,
                          [radius](Random random) { return bridson_batch(tile, radius, 30, random); }));
    all.push_back(case_of(
        "dart_throwing", Standing::taught, count,
        collected([](double r, Random random, auto plot) { dart_throwing(tile, r, 200, random, plot); })));
    if (count <= 64) {
      all.push_back(case_of("best_candidate", Standing::robust, count, [count](Random random) {
        std::vector<dvec2> samples(static_cast<std::size_t>(count));
        best_candidate(samples, 2, random);
        return samples;
      }));
    }
    all.push_back(case_of("independent", Standing::robust, count, [count](Random random) {
      std::vector<dvec2> samples(static_cast<std::size_t>(count));
      for (dvec2& p : samples) p = any_in(tile, random);
      return samples;
    }));
  }
  return all;
}

}  // namespace

Subject poisson_disc() {
  return {.topic = "poisson_disc",
          .title = "Samples that keep their distance",
          .item = "sample",
          .unit = "parts of a pixel",
          .measure = "samples",
          .telling = "about 256 samples",
          .cases = cases,
          .refined = true,
          .choice = {"bridson_batch", "the samples of bridson to the bit, in a fraction of its time"}};
}

}  // namespace gradus::bench
