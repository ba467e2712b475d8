// Curves as chords within a tolerance: cut in the middle until they are flat, or at equal steps of t.

#include "modeling/bezier_curve/bezier_curve.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "modeling/bezier_curve/bezier_curve_notes.hpp"

namespace gradus::bench {
namespace {

using namespace bezier_curve;
using Control = Points<2, double>;
using Lines = std::vector<Control>;

/// Cubic curves: most with control points anywhere, every fourth nearly straight.
const std::vector<Control>& curves() {
  static const std::vector<Control> made = [] {
    Random random(7);
    std::vector<Control> all(64);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double wide = k % 4 == 0 ? 0.1 : 8;
      for (int i = 0; i < 4; ++i) all[k].push_back({random.uniform(-8, 8), random.uniform(-wide, wide)});
    }
    return all;
  }();
  return made;
}

/// Points at equal steps of t, as many as keep the chords within the tolerance: F. Wang's bound, 3/4 of the
/// largest second difference, falls with their square.
Control at_equal_steps(const Control& control, double tolerance, auto point_of) {
  double bend = 0;
  for (std::size_t i = 1; i + 1 < control.size(); ++i)
    bend = std::max(bend, length_of(control[i - 1] - 2.0 * control[i] + control[i + 1]));
  const double pieces = std::max(1.0, std::ceil(std::sqrt(0.75 * bend / tolerance)));
  Control line{control.front()};
  for (double k = 1; k <= pieces; ++k) line.push_back(point_of(control, k / pieces));
  return line;
}

/// How far points of the curves lie from the chords that stand for them: the farthest, and the root of the
/// mean square.
Error off_the_curves(const Lines& lines) {
  Error::Sum sum;
  constexpr int tried = 997;
  for (std::size_t c = 0; c < lines.size(); ++c) {
    for (int k = 0; k <= tried; ++k) {
      const dvec2 p = bernstein<2, double>(curves()[c], static_cast<double>(k) / tried);
      double nearest = 1e300;
      for (std::size_t i = 0; i + 1 < lines[c].size(); ++i) {
        const dvec2 a = lines[c][i], way = lines[c][i + 1] - a;
        const double square = glm::dot(way, way);
        const double share = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
        nearest = std::min(nearest, glm::length(p - a - share * way));
      }
      sum.add(nearest);
    }
  }
  return sum.error();
}

template <class Make>
Case case_of(const char* method, Standing standing, int finer, const Make& make) {
  const auto all = [make](Lines& lines) {
    lines.clear();
    for (const Control& control : curves()) lines.push_back(make(control));
  };
  const auto lines = std::make_shared<Lines>();
  all(*lines);
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("tolerance 1/{}", 1 << finer), static_cast<double>(1 << finer)},
          .items = std::ssize(*lines),
          .run = [lines, all] { all(*lines); },
          .error = off_the_curves(*lines)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int finer : {2, 4, 6, 8, 10}) {
    const double tolerance = std::ldexp(1.0, -finer);
    all.push_back(case_of("flatten", Standing::taught, finer,
                          [=](const Control& c) { return flatten<2, double>(c, tolerance); }));
    all.push_back(case_of("de_casteljau", Standing::robust, finer, [=](const Control& c) {
      return at_equal_steps(c, tolerance,
                            [](const Control& b, double t) { return de_casteljau<2, double>(b, t); });
    }));
    all.push_back(case_of("bernstein", Standing::robust, finer, [=](const Control& c) {
      return at_equal_steps(c, tolerance,
                            [](const Control& b, double t) { return bernstein<2, double>(b, t); });
    }));
    all.push_back(case_of("middle_only", Standing::faulty, finer,
                          [=](const Control& c) { return middle_only<2, double>(c, tolerance); }));
  }
  return all;
}

}  // namespace

Subject bezier_curve() {
  return {.topic = "bezier_curve",
          .title = "Curves as chords",
          .item = "curve",
          .unit = "units of length",
          .measure = "tolerances a unit",
          .telling = "tolerance 1/64",
          .cases = cases,
          .refined = true,
          .choice = {"bernstein", "equal steps, as many as the second difference asks for"}};
}

}  // namespace gradus::bench
