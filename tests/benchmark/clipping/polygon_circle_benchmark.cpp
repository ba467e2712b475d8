// Polygons against a circle, beside Boost.Geometry's intersection with a polygon of 360 points.

#include "clipping/polygon_circle/polygon_circle.hpp"

#include <fmt/format.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "clipping/polygon_circle/polygon_circle_notes.hpp"
#include "core/arithmetic/elementary.hpp"
#include "support/circle_areas.hpp"

namespace gradus::bench {
namespace {

namespace bg = boost::geometry;
namespace pc = gradus::polygon_circle;
using Polygon = std::vector<dvec2>;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false, true>;  // counter-clockwise, closed

const Circle<double> circle{{0.3, -0.2}, 5};
constexpr double pi = 0x1.921fb54442d18p1;

/// 100 star-shaped polygons of so many corners: inside, round the rim, or outside.
const std::vector<Polygon>& polygons(const std::string& mix, int corners) {
  static std::map<std::pair<std::string, int>, std::vector<Polygon>> made;
  const auto [place, added] = made.try_emplace({mix, corners});
  std::vector<Polygon>& set = place->second;
  if (!added) return set;
  std::mt19937_64 random(2);
  const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  const double least = mix == "crossing" ? 2 : 1, most = mix == "inside" ? 4.5 : mix == "crossing" ? 9 : 4;
  const dvec2 middle = mix == "outside" ? dvec2(12, 3) : circle.centre;
  for (int i = 0; i < 100; ++i) {
    Polygon& polygon = set.emplace_back();
    for (int k = 0; k < corners; ++k) {
      const SinCos at = sin_cos_degrees(360.0 / corners * (k + 0.1 + 0.8 * unit()));
      polygon.push_back(middle + (least + (most - least) * unit()) * dvec2(at.cos, at.sin));
    }
  }
  return set;
}

BoostPolygon boost_of(const Polygon& polygon) {
  BoostPolygon boost;
  for (const dvec2 p : polygon) bg::append(boost.outer(), BoostPoint(p.x, p.y));
  bg::append(boost.outer(), BoostPoint(polygon[0].x, polygon[0].y));
  return boost;
}

double shoelace(const Polygon& polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

/// `clip(number of a polygon)` gives something, whose area `area_of` takes.
template <class Clip, class Area>
Case case_of(const char* name, Standing standing, const std::vector<Polygon>& set, Clip clip, Area area_of,
             Workload workload) {
  Error::Sum sum;
  std::int64_t corners = 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const auto right = static_cast<double>(test::exact_area(set[i], circle));
    const double off = std::abs(area_of(clip(i)) - right) / (pi * 25);
    // Farther off than 360 points are allowed to be: another figure
    if (off > 1e-3) sum.wrong_decision();
    sum.add(off * 0x1p52);  // ulp of the circle's area
    corners += static_cast<std::int64_t>(set[i].size());
  }
  const auto kept = std::make_shared<decltype(clip(0))>();
  return {.method = name,
          .standing = standing,
          .workload = std::move(workload),
          .items = corners,
          .run =
              [clip, kept, &set] {
                for (std::size_t i = 0; i < set.size(); ++i) *kept = clip(i);
              },
          .error = sum.error()};
}

void add_cases(std::vector<Case>& cases, const std::vector<Polygon>& set, const Workload& workload) {
  const auto arcs = [&set](std::size_t i) { return pc::arcs(std::span<const dvec2>(set[i]), circle); };
  cases.push_back(case_of(
      "arcs", Standing::robust, set, arcs, [](const auto& region) { return pc::area(region); }, workload));
  // With chords as close as those of 360 points
  const double tolerance = circle.radius * (1 - cos(pi / 360));
  cases.push_back(case_of(
      "arcs, as chords", Standing::robust, set,
      [arcs, tolerance](std::size_t i) { return pc::flatten(arcs(i), tolerance); },
      [](const auto& flat) {
        double sum = 0;
        for (const Polygon& polygon : flat) sum += shoelace(polygon);
        return sum;
      },
      workload));
  cases.push_back(case_of(
      "first_crossing", Standing::faulty, set,
      [&set](std::size_t i) { return pc::first_crossing(std::span<const dvec2>(set[i]), circle); },
      [](const Polygon& kept) { return shoelace(kept); }, workload));
  // Reading the polygons into Boost's own is not timed
  Polygon rim;
  for (int i = 0; i < 360; ++i) {
    const SinCos at = sin_cos_degrees(i);
    rim.push_back(circle.centre + circle.radius * dvec2(at.cos, at.sin));
  }
  const auto given = std::make_shared<std::vector<BoostPolygon>>();
  for (const Polygon& polygon : set) given->push_back(boost_of(polygon));
  cases.push_back(case_of(
      "Boost.Geometry, 360 points", Standing::peer, set,
      [given, disc = boost_of(rim)](std::size_t i) {
        std::vector<BoostPolygon> pieces;
        bg::intersection((*given)[i], disc, pieces);
        return pieces;
      },
      [](const std::vector<BoostPolygon>& pieces) {
        double sum = 0;
        for (const BoostPolygon& piece : pieces) sum += bg::area(piece);
        return sum;
      },
      workload));
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* mix : {"inside", "crossing", "outside"}) add_cases(all, polygons(mix, 12), {mix});
  for (const int corners : {4, 16, 64, 256}) {
    add_cases(all, polygons("crossing", corners),
              {fmt::format("{} corners", corners), static_cast<double>(corners)});
  }
  return all;
}

}  // namespace

Subject polygon_circle() {
  return {.topic = "polygon_circle",
          .title = "Polygons against a circle: errors of the area",
          .item = "corner",
          .unit = "ulp",
          .measure = "corners of a polygon; 100 polygons per run",
          .telling = "crossing",
          .cases = cases,
          .choice = {"arcs", "exact to rounding; chords only for what takes polygons alone"}};
}

}  // namespace gradus::bench
