// Points of a sphere: by the function each time, or looked up in faces that were made once.

#include "modeling/parametric_surface/parametric_surface.hpp"

#include <fmt/format.h>

#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

using namespace parametric_surface;

constexpr int asked = 4096;

/// Places on the unit sphere, s and t in degrees.
const std::vector<dvec2>& places() {
  static const std::vector<dvec2> all = [] {
    Random random(7);
    std::vector<dvec2> made;
    for (int i = 0; i < asked; ++i) made.push_back({random.uniform(0, 360), random.uniform(-90, 90)});
    return made;
  }();
  return all;
}

using Points = std::vector<dvec3>;

/// How far they are from the surface's points, by the library's sines in more digits.
Error off_the_surface(const Points& points) {
  Error::Sum sum;
  constexpr long double degree = 3.14159265358979323846L / 180;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const long double s = degree * static_cast<long double>(places()[i].x),
                      t = degree * static_cast<long double>(places()[i].y);
    const glm::vec<3, long double> right{std::cos(t) * std::cos(s), std::cos(t) * std::sin(s), std::sin(t)};
    sum.add(static_cast<double>(length_of(glm::vec<3, long double>(points[i]) - right)));
  }
  return sum.error();
}

/// By a function of s and t.
template <class At>
Case case_of(const char* method, Standing standing, int n, const At& at) {
  const auto points = std::make_shared<Points>(asked);
  const auto run = [points, at] {
    for (std::size_t i = 0; i < points->size(); ++i) (*points)[i] = at(places()[i].x, places()[i].y);
  };
  run();
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("{} patches round", n), static_cast<double>(n)},
          .items = asked,
          .run = run,
          .error = off_the_surface(*points)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int n : {8, 16, 32, 64, 128, 256}) {
    const auto mesh = std::make_shared<const Patches<double>>(patches(1.0, n, n / 2));
    all.push_back(case_of("point", Standing::taught, n,
                          [](double s, double t) { return point(1.0, angle(s), angle(t)).point; }));
    all.push_back(case_of("lookup", Standing::robust, n,
                          [mesh](double s, double t) { return lookup(*mesh, s, t).point; }));
  }
  return all;
}

}  // namespace

Subject parametric_surface() {
  return {.topic = "parametric_surface",
          .title = "Points of a sphere",
          .item = "point",
          .unit = "radii",
          .measure = "patches round the axis",
          .telling = "64 patches round",
          .cases = cases,
          .choice = {"point", "exact but for roundings, its normals without jumps, nothing stored"}};
}

}  // namespace gradus::bench
