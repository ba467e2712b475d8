// Polygons against a window by every method, beside Boost.Geometry's intersection.

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <cmath>
#include <concepts>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>
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

template <class T>
const Rectangle<T> window{{0, 0}, {1, 1}};
const std::vector<int> order{0, 1, 2, 3};
constexpr double pi = 0x1.921fb54442d18p1;

/// Polygons, and what is right of the first of them: the vertices correctly rounded and the exact area,
/// rounded once.
template <class T>
struct Set {
  sh::Polygons<T> polygons;
  std::vector<Ring> vertices;
  std::vector<double> areas;
};

/// How many polygons are compared with what is right.
constexpr int compared = 300;

/// Star-shaped polygons of `least` to `most` vertices: inside the window, most of them across its border,
/// across all four of its borders, outside, or of the first, the second and the last kind. Or vertices from
/// anywhere in and round the window.
template <class T>
const Set<T>& set_of(const std::string& mix, int least, int most, int polygons) {
  static std::map<std::tuple<std::string, int, int>, Set<T>> made;
  const auto [place, added] = made.try_emplace({mix, least, most});
  Set<T>& set = place->second;
  if (!added) return set;
  Random random(1);
  for (int i = 0; i < polygons; ++i) {
    const char* const kinds[] = {"inside", "crossing", "outside"};
    const std::string kind = mix == "all three" ? kinds[i % 3] : mix;
    const auto vertices = static_cast<int>(random.uniform_int(least, most));
    double size = kind == "crossing" ? random.uniform(0.1, 0.8) : random.uniform(0.02, 0.1);
    dvec2 centre{random.uniform(0.11, 0.89), random.uniform(0.11, 0.89)};
    const auto axis = static_cast<int>(random.uniform_int(0, 1));
    const bool high = random.uniform_int(0, 1) == 1;
    if (kind == "crossing") centre[axis] = high ? 1 : 0;
    if (kind == "outside") centre[axis] = high ? 1.2 : -0.2;
    if (kind == "all borders") size = 1.5, centre = dvec2(0.5);
    std::vector<glm::vec<2, T>> points;
    for (int k = 0; k < vertices; ++k) {
      const SinCos at = sin_cos(2 * pi * k / vertices);
      dvec2 p = centre + size * random.uniform(0.3, 1) * dvec2(at.cos, at.sin);
      if (kind == "anywhere") p = {random.uniform(-1, 2), random.uniform(-1, 2)};
      points.emplace_back(p);
    }
    set.polygons.add(points);
    if (i >= compared) continue;
    const Ring given(points.begin(), points.end());
    const auto exact = stress::window_polygons::exact_part(given, window<double>, order);
    std::ranges::transform(exact, std::back_inserter(set.vertices.emplace_back()), [](const auto& p) {
      return dvec2(glm::vec<2, T>(stress::window_polygons::rounded(p)));
    });
    set.areas.push_back(static_cast<double>(stress::window_polygons::area_in(given, window<double>)));
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

template <class T>
double ulp(T x) {
  return std::nextafter(std::abs(x), T(2)) - std::abs(x);
}

/// Vertices beside the nearest right one, in the last place of its larger coordinate, beside (0, 0) in that
/// of 1; areas that are wrong.
template <class T>
Error error_of(const Set<T>& set, const std::function<Pieces(std::size_t)>& pieces_of) {
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
        const double larger = std::max(size.x, size.y);
        sum.add(std::max(miss.x, miss.y) / ulp(static_cast<T>(larger > 0 ? larger : 1)));
      }
    }
    constexpr double rounding = std::same_as<T, float> ? 1e-5 : 1e-9;
    if (std::abs(own - set.areas[i]) > rounding) sum.wrong_decision();
  }
  return sum.error();
}

/// What the batch is measured with: the textbook's loop as one writes it to be quick, in the numbers as they
/// are, in two buffers that are used again.
template <class T>
class PlainLoop {
 public:
  using Point = glm::vec<2, T>;

  const std::vector<Point>& operator()(std::span<const Point> points) {
    from_.assign(points.begin(), points.end());
    pass([](Point p) { return p.x - window<T>.lower.x; });
    pass([](Point p) { return window<T>.upper.x - p.x; });
    pass([](Point p) { return p.y - window<T>.lower.y; });
    pass([](Point p) { return window<T>.upper.y - p.y; });
    return from_;
  }

 private:
  template <class Distance>
  void pass(Distance inside_by) {
    to_.clear();
    if (from_.empty()) return;
    Point last = from_.back();
    T was = inside_by(last);
    for (const Point now : from_) {
      const T is = inside_by(now);
      if ((was < 0) != (is < 0)) to_.push_back(last + was / (was - is) * (now - last));
      if (is >= 0) to_.push_back(now);
      last = now;
      was = is;
    }
    std::swap(from_, to_);
  }

  std::vector<Point> from_, to_;
};

/// Gathers the methods of a set.
template <class T>
class Methods {
 public:
  using Points = std::span<const glm::vec<2, T>>;

  Methods(std::vector<Case>& cases, const Set<T>& set, Workload workload)
      : cases_(cases), set_(set), workload_(std::move(workload)) {}

  void add(const char* name, Standing standing, std::function<void()> run,
           const std::function<Pieces(std::size_t)>& pieces_of) {
    cases_.push_back({.method = name,
                      .standing = standing,
                      .workload = workload_,
                      .items = static_cast<std::int64_t>(set_.polygons.points.size()),
                      .run = std::move(run),
                      .error = error_of(set_, pieces_of)});
  }
  /// One that takes a polygon and gives a ring of vertices.
  template <class One>
  void add_each(const char* name, Standing standing, One one) {
    const auto kept = std::make_shared<decltype(one(set_.polygons[0]))>();
    add(
        name, standing,
        [one, kept, &set = set_] {
          for (std::size_t i = 0; i < set.polygons.size(); ++i) *kept = one(set.polygons[i]);
        },
        [&](std::size_t i) {
          Ring ring;
          for (const auto& v : one(set_.polygons[i])) ring.emplace_back(v.at);
          return Pieces{ring};
        });
  }
  /// The loop and the batch, and one at a time: what both types of numbers have.
  void add_quick_ones() {
    const auto loop = std::make_shared<PlainLoop<T>>();
    add(
        "plain loop", Standing::taught,
        [loop, &set = set_] {
          for (std::size_t i = 0; i < set.polygons.size(); ++i) (*loop)(set.polygons[i]);
        },
        [&](std::size_t i) {
          const auto& ring = (*loop)(set_.polygons[i]);
          return Pieces{Ring(ring.begin(), ring.end())};
        });
    add_each("clip_to_window", Standing::robust, [](Points points) {
      return sh::clip_to_window(points, window<T>, std::span<const int>(order));
    });
    const auto clip = std::make_shared<sh::BatchClipper<T>>();
    const auto result = std::make_shared<sh::Polygons<T>>();
    (*clip)(set_.polygons, window<T>, *result);
    add(
        "BatchClipper", Standing::batch,
        [clip, result, &set = set_] { (*clip)(set.polygons, window<T>, *result); },
        [&](std::size_t i) { return Pieces{Ring((*result)[i].begin(), (*result)[i].end())}; });
  }

 private:
  std::vector<Case>& cases_;
  const Set<T>& set_;
  Workload workload_;
};

void add_cases(std::vector<Case>& cases, const Set<double>& set, const Workload& workload) {
  Methods<double> methods(cases, set, workload);
  methods.add_each("cut_of_a_cut", Standing::taught, [](std::span<const dvec2> points) {
    return sh::by_passes(sh::Task<double>{points, window<double>, order},
                         [](auto polygon, auto border) { return sh::cut_of_a_cut(polygon, border); });
  });
  methods.add_quick_ones();
  const auto separate = [](std::span<const dvec2> points) {
    const std::vector<Ring> rings{{points.begin(), points.end()}};
    return sh::separate_pieces(sh::Rings<double>(std::span<const Ring>(rings)), window<double>,
                               std::span<const int>(order));
  };
  const auto last = std::make_shared<decltype(separate(set.polygons[0]))>();
  methods.add(
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
  methods.add(
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
  // So many that a machine doesn't learn where each of them is cut
  constexpr int many = 3000;
  for (const char* mix : {"inside", "crossing", "all borders", "anywhere", "outside", "all three"}) {
    const Set<double>& set = set_of<double>(mix, 4, 16, many);
    // Those that cross themselves are no input for the others
    if (mix == std::string("anywhere")) {
      Methods<double>(all, set, {mix}).add_quick_ones();
    } else {
      add_cases(all, set, {mix});
    }
    Methods<float>(all, set_of<float>(mix, 4, 16, many), {fmt::format("{}, floats", mix)}).add_quick_ones();
  }
  for (const int vertices : {4, 16, 64, 256}) {
    add_cases(all, set_of<double>("crossing", vertices, vertices, compared),
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
          .cases = cases,
          .choice = {"BatchClipper", "decided exactly, in the least time"}};
}

}  // namespace gradus::bench
