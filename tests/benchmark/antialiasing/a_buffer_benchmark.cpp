// Pictures of triangles in front of each other: time per fragment, and how far the light of pixels is from
// that of exact areas.

#include "antialiasing/a_buffer/a_buffer_picture.hpp"

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "antialiasing/area_sampling/area_sampling.hpp"
#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "core/raster.hpp"

namespace gradus::bench {
namespace {

using triangle_coverage::ScreenTriangle;
using Triangles = std::vector<ScreenTriangle>;
using Picture = Raster<double>;

constexpr int side = 128;
constexpr Window window{{0, 0}, {side - 1, side - 1}};

/// Level triangles of about so many pixels.
Triangles triangles_of(int reach) {
  Random random(47);
  Triangles all;
  for (int i = 0; i < 4096 / reach; ++i) {
    const dvec2 at{random.uniform(0, side - reach), random.uniform(0, side - reach)};
    const auto corner = [&] {
      return triangle_coverage::snap(at + dvec2{random.uniform(0, reach), random.uniform(0, reach)});
    };
    const ivec2 a = corner(), b = corner(), c = corner();
    all.push_back({{a, b, c}, dvec3(random.unit())});
  }
  return all;
}

/// What a triangle shows.
double grey(int triangle, ivec2, const triangle_coverage::Weights&) { return 0.25 + 0.25 * (triangle % 3); }

void by_lists(const Triangles& triangles, Picture& out) {
  a_buffer::a_buffer(std::span(triangles), window, grey, [&](ivec2 p, double sum, double) { out[p] = sum; });
}
void by_areas(const Triangles& triangles, Picture& out) {
  area_sampling::visible_areas(std::span(triangles), window, grey,
                               [&](ivec2 p, double sum, double) { out[p] = sum; });
}
void by_one_sample(const Triangles& triangles, Picture& out) {
  Picture depth(side, side, 2.0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const double z = triangles[t].depth.x;
    triangle_coverage::cover(triangles[t].corners, window, [&](ivec2 p, const auto& weights) {
      if (z < depth[p]) depth[p] = z, out[p] = grey(static_cast<int>(t), p, weights);
    });
  }
}

void add_case(std::vector<Case>& all, int reach, std::int64_t fragments, const char* name, Standing standing,
              const std::shared_ptr<const Triangles>& triangles, const Picture& right,
              void (*draw)(const Triangles&, Picture&)) {
  const auto picture = std::make_shared<Picture>(side, side);
  const auto run = [=] { draw(*triangles, *picture); };
  run();
  Error::Sum sum;
  for (std::size_t i = 0; i < right.cells().size(); ++i) sum.add(picture->cells()[i] - right.cells()[i]);
  all.push_back({.method = name,
                 .standing = standing,
                 .workload = {fmt::format("triangles of {} pixels", reach), static_cast<double>(reach)},
                 .items = fragments,
                 .run = run,
                 .prepare = [picture] { std::ranges::fill(picture->cells(), 0.0); },
                 .error = sum.error()});
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int reach : {4, 16, 64}) {
    const auto triangles = std::make_shared<const Triangles>(triangles_of(reach));
    Picture right(side, side);
    by_areas(*triangles, right);
    const auto nothing = [](ivec2, double, double) {};
    const std::int64_t fragments = a_buffer::a_buffer(std::span(*triangles), window, grey, nothing).fragments;
    add_case(all, reach, fragments, "a_buffer", Standing::taught, triangles, right, by_lists);
    add_case(all, reach, fragments, "one sample", Standing::robust, triangles, right, by_one_sample);
    add_case(all, reach, fragments, "area_sampling", Standing::robust, triangles, right, by_areas);
  }
  return all;
}

}  // namespace

Subject a_buffer() {
  return {.topic = "a_buffer",
          .title = "Triangles in an A-buffer",
          .item = "fragment",
          .unit = "parts of full light",
          .measure = "pixels a triangle is wide",
          .telling = "triangles of 16 pixels",
          .cases = cases,
          .choice = {"a_buffer", "smooth edges in a fraction of the time that exact areas take"}};
}

}  // namespace gradus::bench
