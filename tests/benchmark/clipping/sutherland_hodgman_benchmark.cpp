// Polygons against a window by every method, beside Boost.Geometry's intersection.

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_homogeneous.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_notes.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/random.hpp"
#include "stress/clipping/window_polygons.hpp"

namespace gradus::bench {
namespace {

namespace bg = boost::geometry;
namespace sh = gradus::sutherland_hodgman;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false, false>;  // counter-clockwise, not closed
using glm::dvec2;
using Ring = std::vector<dvec2>;
using Pieces = std::vector<Ring>;

const Rectangle<double> window{{0, 0}, {1, 1}};
const std::vector<int> order{0, 1, 2, 3};
constexpr double pi = 0x1.921fb54442d18p1;

/// Polygons, and what is right of each: the vertices correctly rounded and the exact area, rounded once.
struct Set {
  sh::Polygons polygons;
  std::vector<Ring> vertices;
  std::vector<double> areas;
};

/// 300 star-shaped polygons of `least` to `most` vertices: inside the window, most of them across its border,
/// outside, or of all three kinds.
const Set& set_of(const std::string& mix, int least, int most) {
  static std::map<std::tuple<std::string, int, int>, Set> made;
  const auto [place, added] = made.try_emplace({mix, least, most});
  Set& set = place->second;
  if (!added) return set;
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const char* const kinds[] = {"inside", "crossing", "outside"};
    const std::string kind = mix == "all three" ? kinds[i % 3] : mix;
    const auto vertices = static_cast<int>(random.uniform_int(least, most));
    const double size = kind == "crossing" ? random.uniform(0.1, 0.8) : random.uniform(0.02, 0.1);
    dvec2 centre{random.uniform(0.11, 0.89), random.uniform(0.11, 0.89)};
    const auto axis = static_cast<int>(random.uniform_int(0, 1));
    const bool high = random.uniform_int(0, 1) == 1;
    if (kind == "crossing") centre[axis] = high ? 1 : 0;
    if (kind == "outside") centre[axis] = high ? 1.2 : -0.2;
    Ring points;
    for (int k = 0; k < vertices; ++k) {
      const SinCos at = sin_cos(2 * pi * k / vertices);
      points.push_back(centre + size * random.uniform(0.3, 1) * dvec2(at.cos, at.sin));
    }
    set.polygons.add(points);
    const auto exact = stress::window_polygons::exact_part(points, window, order);
    std::ranges::transform(exact, std::back_inserter(set.vertices.emplace_back()),
                           stress::window_polygons::rounded);
    set.areas.push_back(static_cast<double>(stress::window_polygons::area_in(points, window)));
  }
  return set;
}

double area(const Ring& ring) {
  double doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

double ulp(double x) { return std::nextafter(std::abs(x), 2.0) - std::abs(x); }

/// Vertices beside the nearest right one, in the last place of its larger coordinate; areas that are wrong.
Error error_of(const Set& set, const std::function<Pieces(std::size_t)>& pieces_of) {
  Error::Sum sum;
  for (std::size_t i = 0; i < set.areas.size(); ++i) {
    double own = 0;
    for (const Ring& ring : pieces_of(i)) {
      own += area(ring);
      for (const dvec2 p : ring) {
        const Ring& right = set.vertices[i];
        const auto nearest = std::ranges::min_element(right, {}, [&](dvec2 v) { return glm::length(v - p); });
        if (nearest == right.end()) continue;
        const dvec2 miss = glm::abs(*nearest - p), size = glm::abs(*nearest);
        sum.add(std::max(miss.x, miss.y) / ulp(std::max(size.x, size.y)));
      }
    }
    if (std::abs(own - set.areas[i]) > 1e-9) sum.wrong_decision();
  }
  return sum.error();
}

void add_cases(std::vector<Case>& cases, const Set& set, const Workload& workload) {
  const auto add = [&](const char* name, Standing standing, std::function<void()> run,
                       const std::function<Pieces(std::size_t)>& pieces_of) {
    cases.push_back({.method = name,
                     .standing = standing,
                     .workload = workload,
                     .items = static_cast<std::int64_t>(set.polygons.points.size()),
                     .run = std::move(run),
                     .error = error_of(set, pieces_of)});
  };
  // Methods that take one polygon and give one ring of vertices
  const auto add_each = [&](const char* name, Standing standing, auto one) {
    const auto kept = std::make_shared<decltype(one(set.polygons[0]))>();
    add(
        name, standing,
        [one, kept, &set] {
          for (std::size_t i = 0; i < set.polygons.size(); ++i) *kept = one(set.polygons[i]);
        },
        [&](std::size_t i) {
          Ring ring;
          for (const auto& v : one(set.polygons[i])) ring.push_back(v.at);
          return Pieces{ring};
        });
  };
  add_each("cut_of_a_cut", Standing::taught, [](std::span<const dvec2> points) {
    return sh::by_passes(sh::Task<double>{points, window, order},
                         [](auto polygon, auto border) { return sh::cut_of_a_cut(polygon, border); });
  });
  add_each("clip_to_window", Standing::robust, [](std::span<const dvec2> points) {
    return sh::clip_to_window(points, window, std::span<const int>(order));
  });
  const auto separate = [](std::span<const dvec2> points) {
    const std::vector<Ring> rings{{points.begin(), points.end()}};
    return sh::separate_pieces(sh::Rings<double>(std::span<const Ring>(rings)), window,
                               std::span<const int>(order));
  };
  const auto last = std::make_shared<decltype(separate(set.polygons[0]))>();
  add(
      "separate_pieces", Standing::robust,
      [separate, last, &set] {
        for (std::size_t i = 0; i < set.polygons.size(); ++i) *last = separate(set.polygons[i]);
      },
      [&](std::size_t i) {
        Pieces pieces;
        for (const auto& piece : separate(set.polygons[i])) {
          Ring& ring = pieces.emplace_back();
          for (const auto& v : piece.outline) ring.push_back(v.at);
        }
        return pieces;
      });
  const auto clip = std::make_shared<sh::BatchClipper>();
  const auto result = std::make_shared<sh::Polygons>();
  (*clip)(set.polygons, window, *result);
  add(
      "BatchClipper", Standing::batch, [clip, result, &set] { (*clip)(set.polygons, window, *result); },
      [&](std::size_t i) { return Pieces{Ring((*result)[i].begin(), (*result)[i].end())}; });
  // Polygons in Boost's own form are made before the clock starts
  const auto given = std::make_shared<std::vector<BoostPolygon>>();
  for (std::size_t i = 0; i < set.polygons.size(); ++i) {
    given->emplace_back();
    for (const dvec2 p : set.polygons[i]) given->back().outer().emplace_back(p.x, p.y);
  }
  const auto by_boost = [given](std::size_t i, std::vector<BoostPolygon>& pieces) {
    pieces.clear();
    bg::intersection((*given)[i], bg::model::box<BoostPoint>({0, 0}, {1, 1}), pieces);
  };
  const auto found = std::make_shared<std::vector<BoostPolygon>>();
  add(
      "Boost.Geometry", Standing::peer,
      [by_boost, found, given] {
        for (std::size_t i = 0; i < given->size(); ++i) by_boost(i, *found);
      },
      [&](std::size_t i) {
        by_boost(i, *found);
        Pieces pieces;
        for (const BoostPolygon& piece : *found) {
          Ring& ring = pieces.emplace_back();
          for (const BoostPoint& p : piece.outer()) ring.emplace_back(p.x(), p.y());
        }
        return pieces;
      });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* mix : {"inside", "crossing", "outside", "all three"}) {
    add_cases(all, set_of(mix, 4, 16), {mix});
  }
  for (const int vertices : {4, 16, 64, 256}) {
    add_cases(all, set_of("crossing", vertices, vertices),
              {fmt::format("{} vertices", vertices), static_cast<double>(vertices)});
  }
  return all;
}

}  // namespace

Subject sutherland_hodgman() {
  return {.topic = "sutherland_hodgman",
          .title = "Polygons against a window",
          .item = "vertex",
          .unit = "ulp",
          .measure = "vertices of a polygon; 300 polygons per run",
          .telling = "crossing",
          .cases = cases};
}

}  // namespace gradus::bench
