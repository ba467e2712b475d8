// Triangles of several sizes in a picture: the areas of each in its pixels, and what is seen of all of them.
// Errors are those of single pixels, against the same in rationals.

#include "antialiasing/area_sampling/area_sampling.hpp"

#include <memory>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "core/raster.hpp"

namespace gradus::bench {
namespace {

using namespace area_sampling;

constexpr int side = 32;
constexpr Window picture{{0, 0}, {side - 1, side - 1}};

/// So many triangles of about `reach` pixels: many small ones lie above each other in a pixel, or few large.
struct Mix {
  const char* name;
  int triangles, reach;
};
constexpr Mix mixes[]{{"small", 512, 2}, {"medium", 64, 8}, {"large", 8, 32}};

std::vector<ScreenTriangle> triangles_of(const Mix& mix) {
  Random random(17);
  std::vector<ScreenTriangle> triangles;
  while (std::ssize(triangles) < mix.triangles) {
    const dvec2 at{random.uniform(-1, side - 1), random.uniform(-1, side - 1)};
    ScreenTriangle t;
    for (ivec2& corner : t.corners)
      corner =
          triangle_coverage::snap(at + dvec2{random.uniform(0, mix.reach), random.uniform(0, mix.reach)});
    for (int k = 0; k < 3; ++k) t.depth[k] = random.unit();
    if (triangle_coverage::doubled_area(t.corners) != 0) triangles.push_back(t);
  }
  return triangles;
}

/// What each triangle is worth in the sum of a pixel.
double worth(int triangle) { return 1 + triangle % 7; }

using Sums = Raster<double>;

/// The clips: pixels touched, of all triangles.
std::int64_t clips_of(const std::vector<ScreenTriangle>& triangles) {
  std::int64_t clips = 0;
  for (const auto& t : triangles) pixel_areas(t.corners, picture, [&](ivec2, double) { ++clips; });
  return clips;
}

void add_areas(const std::vector<ScreenTriangle>& triangles, Sums& sums) {
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const double value = worth(static_cast<int>(k));
    pixel_areas(triangles[k].corners, picture, [&](ivec2 p, double area) { sums[p] += value * area; });
  }
}
void add_visible(const std::vector<ScreenTriangle>& triangles, Sums& sums) {
  const auto colour = [](int k, ivec2, const Weights&) { return worth(k); };
  visible_areas(triangles, picture, colour, [&](ivec2 p, double sum, double) { sums[p] = sum; });
}

/// The right sum of a pixel, in rationals; with `all`, whatever is hidden.
double right_of(const std::vector<ScreenTriangle>& triangles, ivec2 pixel, bool all) {
  const ExactScope scope;
  std::vector<Fragment<Exact>> fragments;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const Window box = pixels_in(triangles[k].corners, picture);
    if (!box.contains(pixel)) continue;
    if (auto f = fragment_in<Exact>(triangles[k], pixel, static_cast<int>(k)))
      fragments.push_back(std::move(*f));
  }
  Exact sum = 0;
  const auto add = [&](const Fragment<Exact>& f, Exact area) { sum += Exact(worth(f.key)) * area; };
  if (all) {
    for (const auto& f : fragments) add(f, area_of(f.outline));
  } else {
    visible_areas(std::span(fragments), [&](const auto& f, const auto&, Exact area) { add(f, area); });
  }
  return to_double(sum);
}

template <class Draw>
Case case_of(const Mix& mix, const std::shared_ptr<std::vector<ScreenTriangle>>& triangles, std::string name,
             Standing standing, bool all, Draw draw) {
  const auto sums = std::make_shared<Sums>(side, side);
  const auto run = [=] { draw(*triangles, *sums); };
  run();
  // One pixel of each 8 x 8: rationals take their time
  Error::Sum error;
  for (int y = 3; y < side; y += 8) {
    for (int x = 3; x < side; x += 8) error.add((*sums)[{x, y}] - right_of(*triangles, {x, y}, all));
  }
  return {.method = std::move(name),
          .standing = standing,
          .workload = {mix.name, static_cast<double>(mix.reach)},
          .items = clips_of(*triangles),
          .run = run,
          .prepare = [sums] { std::ranges::fill(sums->cells(), 0); },
          .error = error.error()};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Mix& mix : mixes) {
    const auto triangles = std::make_shared<std::vector<ScreenTriangle>>(triangles_of(mix));
    all.push_back(case_of(mix, triangles, "pixel_areas", Standing::taught, true, add_areas));
    all.push_back(case_of(mix, triangles, "visible_areas", Standing::robust, false, add_visible));
  }
  return all;
}

}  // namespace

Subject area_sampling() {
  return {.topic = "area_sampling",
          .title = "Exact areas of triangles",
          .item = "clip",
          .unit = "parts of a pixel's sum",
          .measure = "pixels a triangle is wide",
          .telling = "medium",
          .cases = cases,
          .choice = {"pixel_areas", "exact for one polygon; where some hide others, visible_areas"}};
}

}  // namespace gradus::bench
