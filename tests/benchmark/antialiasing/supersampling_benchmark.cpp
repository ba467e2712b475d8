// A picture of straight edges with n x n samples per pixel: time per pixel, and how far shares are from the
// exact area.

#include "antialiasing/supersampling/supersampling.hpp"

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "benchmark/subject.hpp"
#include "support/random_edges.hpp"

namespace gradus::bench {
namespace {

using namespace gradus::supersampling;

constexpr int columns = 48, rows = 32;
constexpr Window window{{0, 0}, {columns - 1, rows - 1}};

/// An edge of its own in each pixel.
struct Scene {
  std::vector<test::StraightEdge> edges;

  Scene() {
    Random random(43);
    for (int i = 0; i < columns * rows; ++i) edges.push_back(test::random_edge(random));
  }
  const test::StraightEdge& edge(ivec2 pixel) const {
    return edges[static_cast<std::size_t>(pixel.y * columns + pixel.x)];
  }
  double operator()(dvec2 p) const {
    const ivec2 pixel(p);
    return edge(pixel).holds(p - dvec2(pixel)) ? 1 : 0;
  }
};

std::vector<Case> cases() {
  const auto scene = std::make_shared<const Scene>();
  std::vector<Case> all;
  const auto add = [&](const char* name, Standing standing, int n, auto method) {
    const auto shares = std::make_shared<std::vector<double>>(scene->edges.size());
    const auto run = [=] {
      method(window, n, Filter::box, *scene, [&](ivec2 p, double share) {
        (*shares)[static_cast<std::size_t>(p.y * columns + p.x)] = share;
      });
    };
    run();
    Error::Sum sum;
    for (std::size_t i = 0; i < shares->size(); ++i) sum.add((*shares)[i] - scene->edges[i].area());
    all.push_back({.method = name,
                   .standing = standing,
                   .workload = {fmt::format("{0} x {0} samples", n), static_cast<double>(n * n)},
                   .items = columns * rows,
                   .run = run,
                   .error = sum.error()});
  };
  for (const int n : {1, 2, 4, 8, 16}) {
    add("supersample", Standing::taught, n, [](const auto&... all_of) { supersample(all_of...); });
    add("large_picture", Standing::robust, n, [](const auto&... all_of) { large_picture(all_of...); });
  }
  return all;
}

}  // namespace

Subject supersampling() {
  return {.topic = "supersampling",
          .title = "Edges with n x n samples per pixel",
          .item = "pixel",
          .unit = "parts of a pixel",
          .measure = "samples per pixel",
          .telling = "4 x 4 samples",
          .cases = cases,
          .refined = true,
          .choice = {"supersample", "the bits of large_picture, with a few rows of memory"}};
}

}  // namespace gradus::bench
