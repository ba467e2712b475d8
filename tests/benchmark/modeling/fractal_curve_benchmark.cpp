// Koch's curve as points of the plane: from a lattice, by a turtle, by matrices that are multiplied level by
// level, and by angles that are added up.

#include "modeling/fractal_curve/fractal_curve.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "benchmark/subject.hpp"
#include "modeling/fractal_curve/l_system.hpp"

namespace gradus::bench {
namespace {

using namespace fractal_curve;
using Way = std::vector<dvec2>;

const Segment<2, double> base{{0.1, 0.2}, {0.9, 0.7}};

Way by_lattice(int level) { return in_plane(koch(base_of(Shape::curve), level), level, base); }

/// Steps of a base that is one long, laid into the plane at the end.
Way by_turtle(int level) {
  Way way{base.a};
  const dvec2 along = base.b - base.a, aside{-along.y, along.x};
  const double size = 1 / static_cast<double>(power(3, level));
  turtle<dvec2>(
      rewrite("F", koch_system.rules, level), [](std::int64_t turns) { return plane_way(turns, 60); },
      [&](dvec2, dvec2 to) { way.push_back(base.a + size * to.x * along + size * to.y * aside); });
  return way;
}

/// A third of a segment, turned by matrices of doubles.
Way by_matrices(int level) {
  const double cosine = 0.5, sine = std::numbers::sqrt3 / 2;
  Way way{base.a, base.b};
  for (int k = 0; k < level; ++k) {
    Way finer{way[0]};
    finer.reserve(4 * way.size());
    for (Index i = 1; i < way.size(); ++i) {
      const dvec2 third = (way[i] - way[i - 1]) / 3.0, b = way[i - 1] + third, d = way[i] - third;
      const dvec2 tip = b + dvec2{cosine * third.x - sine * third.y, sine * third.x + cosine * third.y};
      finer.insert(finer.end(), {b, tip, d, way[i]});
    }
    way = std::move(finer);
  }
  return way;
}

/// A turtle as it is often written: its angle grows and shrinks by 60 degrees in radians.
Way by_angles(int level) {
  Way way{base.a};
  const dvec2 along = base.b - base.a;
  const double size = std::hypot(along.x, along.y) / static_cast<double>(power(3, level));
  double angle = std::atan2(along.y, along.x);
  for (const char s : rewrite("F", koch_system.rules, level)) {
    if (s == '+') angle += std::numbers::pi / 3;
    if (s == '-') angle -= std::numbers::pi / 3;
    if (s == 'F') way.push_back(way.back() + size * dvec2{std::cos(angle), std::sin(angle)});
  }
  return way;
}

/// How far corners lie from their places, in u = 2^-53.
Error off_places(const Way& way, int level) {
  using Long = long double;
  Error::Sum sum;
  const Corners corners = koch(base_of(Shape::curve), level);
  const Long whole = 2 * static_cast<Long>(power(3, level)), root = std::sqrt(Long{3});
  const Long dx = Long{base.b.x} - base.a.x, dy = Long{base.b.y} - base.a.y;
  for (Index i = 0; i < way.size(); ++i) {
    const Long s = (2 * corners[i].x + corners[i].y) / whole, h = root * corners[i].y / whole;
    const Long off_x = way[i].x - (base.a.x + s * dx - h * dy);
    const Long off_y = way[i].y - (base.a.y + s * dy + h * dx);
    sum.add(static_cast<double>(std::sqrt(off_x * off_x + off_y * off_y)) * 0x1p53);
  }
  return sum.error();
}

Case case_of(const char* method, Standing standing, int level, Way (*make)(int)) {
  const auto way = std::make_shared<Way>(make(level));
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("level {}", level), static_cast<double>(power(4, level))},
          .items = power(4, level),
          .run = [way, make, level] { *way = make(level); },
          .error = off_places(*way, level)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int level : {2, 4, 6, 8}) {
    all.push_back(case_of("koch", Standing::taught, level, by_lattice));
    all.push_back(case_of("turtle", Standing::taught, level, by_turtle));
    all.push_back(case_of("matrices", Standing::peer, level, by_matrices));
    all.push_back(case_of("angles", Standing::peer, level, by_angles));
  }
  return all;
}

}  // namespace

Subject fractal_curve() {
  return {.topic = "fractal_curve",
          .title = "Koch's curve in the plane",
          .item = "segment",
          .unit = "u = 2^-53",
          .measure = "segments",
          .telling = "level 6",
          .cases = cases,
          .choice = {"koch", "the same few roundings at every level"}};
}

}  // namespace gradus::bench
