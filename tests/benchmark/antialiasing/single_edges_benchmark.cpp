// Every way to antialias, on straight edges across one pixel: how far the covered share is from the exact
// area, and what a pixel takes. The edges are those of known figures: any direction, any distance from the
// pixel's middle, as long as they cross it.

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <vector>

#include "antialiasing/a_buffer/a_buffer.hpp"
#include "antialiasing/area_sampling/area_sampling.hpp"
#include "antialiasing/jittered/jittered.hpp"
#include "antialiasing/poisson_disc/poisson_disc.hpp"
#include "benchmark/subject.hpp"
#include "support/random_edges.hpp"

namespace gradus::bench {
namespace {

using jittered::Pattern;
using test::StraightEdge;

constexpr std::size_t edges = 4096;
constexpr std::uint64_t seed = 29;

struct Edges {
  std::vector<StraightEdge> lines;
  std::vector<std::array<ivec2, 3>> triangles;  ///< the inner side as a triangle, on the grid of 1/256 pixel

  Edges() {
    Random random(seed);
    while (lines.size() < edges) {
      const StraightEdge line = test::random_edge(random);
      // Two corners far out on the line, one far inside; on the grid, the line goes where the corners are
      const dvec2 on = line.normal * line.reach, along{-line.normal.y, line.normal.x};
      const auto snapped = [](dvec2 p) { return ivec2(glm::floor(256.0 * p + 0.5)); };
      const ivec2 from = snapped(on - 64.0 * along), to = snapped(on + 64.0 * along);
      const dvec2 way = glm::normalize(dvec2(to - from)), normal{way.y, -way.x};
      const StraightEdge here{normal, glm::dot(normal, dvec2(from) / 256.0)};
      if (here.area() <= 0 || here.area() >= 1) continue;
      lines.push_back(here);
      triangles.push_back({from, to, snapped(on - 64.0 * line.normal)});
    }
  }
};

/// share(i): of the pixel on the inner side of edge i.
template <class Share>
Case case_of(const std::shared_ptr<const Edges>& all, std::string name, Standing standing,
             const Workload& workload, Share share) {
  const auto shares = std::make_shared<std::vector<double>>(edges);
  const auto run = [=] {
    for (std::size_t i = 0; i < edges; ++i) (*shares)[i] = share(i);
  };
  run();
  Error::Sum sum;
  for (std::size_t i = 0; i < edges; ++i) {
    const double off = (*shares)[i] - all->lines[i].area();
    sum.add(std::abs(off) < 1e-12 ? 0 : off);  // the formula of the area is no better
  }
  const double rmse = sum.error().rms;
  return {.method = std::move(name),
          .standing = standing,
          .workload = workload,
          .items = edges,
          .run = run,
          .error = Error{rmse, rmse, 0}};
}

void add_patterns(std::vector<Case>& cases, const std::shared_ptr<const Edges>& all, int count) {
  const Workload workload{fmt::format("{} samples", count), static_cast<double>(count)};
  const auto add = [&](const char* name, Standing standing, auto put) {
    const auto samples = std::make_shared<std::vector<dvec2>>(static_cast<std::size_t>(count));
    const auto share = [=](std::size_t i) {
      put(std::span(*samples), ivec2(static_cast<int>(i), 0));
      const StraightEdge& edge = all->lines[i];
      int inside = 0;
      for (const dvec2& place : *samples) inside += edge.holds(place);
      return static_cast<double>(inside) / count;
    };
    cases.push_back(case_of(all, name, standing, workload, share));
  };
  const auto by = [](Pattern pattern) {
    return [pattern](std::span<dvec2> samples, ivec2 pixel) {
      put(pattern, samples, jittered::numbers_of(seed, pixel));
    };
  };
  add("regular", Standing::taught, by(Pattern::regular));
  add("independent", Standing::robust, by(Pattern::uniform));
  add("jittered", Standing::taught, by(Pattern::jittered));
  add("n_rooks", Standing::robust, by(Pattern::n_rooks));
  add("correlated_multi_jittered", Standing::robust, by(Pattern::correlated_multi_jittered));
  add("sobol", Standing::robust, by(Pattern::sobol));
  if (count > 16) return;  // its time grows with the third power
  add("best_candidate", Standing::robust, [](std::span<dvec2> samples, ivec2 pixel) {
    poisson_disc::best_candidate(samples, 4, jittered::numbers_of(seed, pixel));
  });
}

std::vector<Case> cases() {
  const auto all = std::make_shared<const Edges>();
  std::vector<Case> cases;
  for (const int count : {4, 16, 64, 256}) add_patterns(cases, all, count);
  // What takes no samples, or always as many, in the chart of the patterns with 16
  const Workload among{"16 samples", 16};
  cases.push_back(case_of(all, "one sample", Standing::taught, among,
                          [=](std::size_t i) { return all->lines[i].holds(dvec2(0.5)) ? 1.0 : 0.0; }));
  cases.push_back(case_of(all, "a_buffer, 32 bits", Standing::taught, among, [=](std::size_t i) {
    return a_buffer::area_of(a_buffer::mask_of(triangle_coverage::edges_of(all->triangles[i]), ivec2(0)));
  }));
  cases.push_back(case_of(all, "area_sampling", Standing::taught, among, [=](std::size_t i) {
    double area = 0;
    area_sampling::pixel_areas(all->triangles[i], Window{{0, 0}, {0, 0}}, [&](ivec2, double a) { area = a; });
    return area;
  }));
  return cases;
}

}  // namespace

Subject single_edges() {
  return {.topic = "single_edges",
          .title = "Straight edges across a pixel",
          .item = "pixel",
          .unit = "parts of a pixel (RMS)",
          .measure = "samples per pixel",
          .telling = "16 samples",
          .cases = cases,
          .refined = true,
          .choice = {"area_sampling", "exact, where samples only come near"}};
}

}  // namespace gradus::bench
