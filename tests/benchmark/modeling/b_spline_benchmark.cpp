// A spline drawn as chords at equal steps of t: every point by de Boor's rounds or by the weights, or the
// pieces first made Bézier curves.

#include "modeling/b_spline/b_spline.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "modeling/b_spline/b_spline_notes.hpp"

namespace gradus::bench {
namespace {

using namespace b_spline;
using Control = Points<2, double>;

constexpr Index points = 19, spans = points - 3;

/// Cubic, clamped, on a walk to the right; every fourth span is four times as long.
const Curve<2, double>& curve() {
  static const Curve<2, double> made = [] {
    Random random(7);
    Curve<2, double> c;
    double u = 0;
    for (Index i = 0; i < points; ++i) c.control.push_back({static_cast<double>(i), random.uniform(-4, 4)});
    c.knots.assign(4, 0);
    for (Index k = 1; k <= spans; ++k) c.knots.push_back(u += k % 4 == 0 ? 4 : 1);
    c.knots.insert(c.knots.end(), 3, u);
    return c;
  }();
  return made;
}

/// Where a line has its points: so many in each span.
std::vector<double> places(int per_span) {
  std::vector<double> all;
  const auto& u = curve().knots;
  for (Index k = 3; k < points; ++k) {
    for (int i = 0; i < per_span; ++i) all.push_back(u[k] + (u[k + 1] - u[k]) * i / per_span);
  }
  all.push_back(u[points]);
  return all;
}

template <class PointOf>
void one_by_one(int per_span, Control& line, const PointOf& point_of) {
  line.clear();
  const Spline<2, double> spline = curve().spline();
  for (const double t : places(per_span)) line.push_back(point_of(spline, t));
}
/// De Casteljau's rounds on the pieces.
void by_pieces(int per_span, Control& line) {
  line.clear();
  const auto pieces = bezier_pieces(curve().spline());
  for (const auto& piece : pieces) {
    const auto& b = piece.b;
    for (int i = 0; i < per_span; ++i) {
      const double t = static_cast<double>(i) / per_span, s = 1 - t;
      const dvec2 middle = s * b[1] + t * b[2];
      const dvec2 first = s * (s * b[0] + t * b[1]) + t * middle,
                  last = s * middle + t * (s * b[2] + t * b[3]);
      line.push_back(s * first + t * last);
    }
  }
  line.push_back(pieces.back().b.back());
}

/// How far the curve is from the chords: the distance of its points to the nearest of them.
Error off_the_curve(const Control& line) {
  Error::Sum sum;
  for (const double t : places(331)) {
    const dvec2 p = basis(curve().spline(), t);
    double nearest = 1e300;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const dvec2 a = line[i], way = line[i + 1] - a;
      const double square = glm::dot(way, way);
      const double share = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
      nearest = std::min(nearest, glm::length(p - a - share * way));
    }
    sum.add(nearest);
  }
  return sum.error();
}

template <class Draw>
Case case_of(const char* method, Standing standing, int per_span, const Draw& draw) {
  const auto line = std::make_shared<Control>();
  draw(per_span, *line);
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("{} chords", per_span * static_cast<int>(spans)),
                       static_cast<double>(per_span) * static_cast<double>(spans)},
          .items = std::ssize(*line),
          .run = [line, draw, per_span] { draw(per_span, *line); },
          .error = off_the_curve(*line)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int per_span : {1, 4, 16, 64}) {
    const auto add = [&](const char* method, Standing standing, auto point_of) {
      all.push_back(
          case_of(method, standing, per_span, [=](int n, Control& line) { one_by_one(n, line, point_of); }));
    };
    add("de_boor", Standing::taught, [](const auto& s, double t) { return de_boor(s, t); });
    add("basis", Standing::robust, [](const auto& s, double t) { return basis(s, t); });
    add("own_span_only", Standing::faulty, [](const auto& s, double t) { return own_span_only(s, t); });
    all.push_back(case_of("bezier_pieces", Standing::robust, per_span, by_pieces));
  }
  return all;
}

}  // namespace

Subject b_spline() {
  return {.topic = "b_spline",
          .title = "A spline as chords",
          .item = "point",
          .unit = "units of length",
          .measure = "chords",
          .telling = "256 chords",
          .cases = cases,
          .refined = true,
          .choice = {"bezier_pieces", "knots are looked at once, not for every point"}};
}

}  // namespace gradus::bench
