// Points of the camera plane to pixels, inside the picture and beside it.

#include "projection/viewport/viewport.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "projection/viewport/viewport_notes.hpp"
#include "stress/projection/viewport.hpp"

namespace gradus::bench {
namespace {

using Pixel = std::optional<ivec2>;

constexpr ivec2 picture{640, 480};
const Rectangle<double> plane{{-1, -0.75}, {1, 0.75}};

/// Points, and their pixels by exact arithmetic.
struct Points {
  std::vector<dvec2> points;
  std::vector<Pixel> right;
};

Pixel reference(dvec2 p) {
  const ExactScope scope;
  const ExactVec2 place = stress::exact_place(viewport::stretched(plane, picture), p);
  return stress::exact_pixel(place, picture, viewport::Rounding::floor);
}

/// So many points within `most` times the window.
const Points& points(double most, std::size_t count) {
  static std::map<std::pair<double, std::size_t>, Points> made;
  const auto [place, added] = made.try_emplace({most, count});
  Points& set = place->second;
  if (!added) return set;
  Random random(1);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(-most, most);
    set.points.push_back({x, 0.75 * random.uniform(-most, most)});
    set.right.push_back(reference(set.points.back()));
  }
  return set;
}

Error error_of(const std::vector<Pixel>& found, const std::vector<Pixel>& right) {
  Error::Sum sum;
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (found[i] != right[i]) sum.wrong_decision();
    if (!found[i] || !right[i]) continue;
    const ivec2 off = *found[i] - *right[i];
    sum.add(std::max(std::abs(off.x), std::abs(off.y)));
  }
  return sum.error();
}

void add_cases(std::vector<Case>& cases, const Points& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, auto one) {
    const auto found = std::make_shared<std::vector<Pixel>>(set.points.size());
    const auto run = [one, found, &set] {
      for (std::size_t i = 0; i < set.points.size(); ++i) (*found)[i] = one(set.points[i]);
    };
    run();
    cases.push_back({.method = name,
                     .standing = standing,
                     .workload = workload,
                     .items = static_cast<std::int64_t>(set.points.size()),
                     .run = run,
                     .error = error_of(*found, set.right)});
  };
  const auto map = viewport::stretched(plane, picture);
  add("rasterize", Standing::taught,
      [map](dvec2 p) -> Pixel { return viewport::rasterize(map, p, viewport::Rounding::floor); });
  add("clamped", Standing::faulty,
      [map](dvec2 p) -> Pixel { return viewport::clamped(map, p, viewport::Rounding::half_even); });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_cases(all, points(1, 4096), {"inside"});
  add_cases(all, points(1.5, 4096), {"inside and beside"});
  for (const std::size_t count : {16u, 256u, 4096u, 65536u}) {
    add_cases(all, points(1, count), {fmt::format("{} points", count), static_cast<double>(count)});
  }
  return all;
}

}  // namespace

Subject viewport() {
  return {.topic = "viewport",
          .title = "Points to pixels",
          .item = "point",
          .unit = "pixels",
          .measure = "points",
          .telling = "inside and beside",
          .cases = cases,
          .choice = {"rasterize", "every point in its own pixel"}};
}

}  // namespace gradus::bench
