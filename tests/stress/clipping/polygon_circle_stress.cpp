// The promises of clipping a polygon to a circle: its pieces in the disc, the area that they and their arcs
// bound, and chords for the arcs.

#include "clipping/polygon_circle/polygon_circle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/record.hpp"
#include "stress/clipping/circle_ends.hpp"
#include "stress/clipping/circle_polygons.hpp"
#include "stress/clipping/circle_scales.hpp"
#include "stress/clipping/circle_walks.hpp"
#include "stress/numbers.hpp"
#include "support/circle_areas.hpp"
#include "support/polygon_areas.hpp"

namespace gradus::stress {
namespace {

using namespace circle_walks;

// --- Areas ---

/// The error of the rings' area, in parts of what the header allows; wrong where a ring encloses less than
/// nothing, but for slivers that rounding folds over.
template <class T>
double area_error(const Input& i) {
  if (!is_taken(i) || !of_one_size(i) || !is_simple(i)) return 0;
  const auto region = region_of<T>(i);
  if (!region) return wrong;
  const test::Enclosed got = test::enclosed_by(*region);
  const T radius = region->circle.radius;
  if (radius == 0) return got.length == 0 ? 0 : wrong;
  const Wide right = test::exact_area(points_of<T>(i), region->circle);
  // What is left is no larger than the polygon, and not beyond the circle
  double largest = 0;
  for (std::size_t k = 3; k < shape_numbers; ++k) largest = std::max(largest, std::abs(i[k]));
  const double reach = std::max(std::abs(i[0]), std::abs(i[1])) + i[2];
  const T size = static_cast<T>(std::max(i[2], std::min(largest, reach)));
  const Wide r(radius), unit = Wide(size) - Wide(std::nextafter(size, T(0)));
  if (got.least < -100 * r * unit) return wrong;
  return static_cast<double>(Wide(abs(Wide(got.area - right)) / (4 * (r + got.length) * unit)));
}

/// The error of `area` against what the rings it is given bound, in parts of what the header allows.
double area_of_rings_error(const Input& i) {
  if (!is_taken(i) || !is_simple(i)) return 0;
  const auto region = region_of(i);
  if (!region) return wrong;
  const test::Enclosed right = test::enclosed_by(*region);
  const double got = polygon_circle::area(*region);
  constexpr double largest = std::numeric_limits<double>::max();
  if (std::isinf(got)) return abs(right.area) > Wide(largest) * (1 - Wide(0x1p-40)) ? 0 : wrong;
  const Point centre = test::wide(region->circle.centre);
  Wide farthest(i[2]), n = 0;
  for (const auto& ring : region->rings) {
    for (const auto& corner : ring) {
      const Point p = test::wide(corner.at), d{p.x - centre.x, p.y - centre.y};
      farthest = std::max(farthest, Wide(sqrt(test::dot(d, d))));
      ++n;
    }
  }
  const Wide most = n * (n + 50) * Wide(0x1p-54) * farthest * farthest + Wide(0x1p-1074);
  return static_cast<double>(Wide(abs(Wide(got - right.area)) / most));
}

/// Rings as they are, wherever each begins and in whatever order they come.
using Rings = std::vector<Ring<double>>;
Rings sorted(Rings rings) {
  const auto before = [](const auto& a, const auto& b) {
    const auto key = [](const auto& c) { return std::tuple(c.at.x, c.at.y, c.arc, c.more_than_half); };
    return key(a) < key(b);
  };
  for (auto& ring : rings) {
    auto best = ring;
    for (std::size_t k = 1; k < ring.size(); ++k) {
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
      if (std::lexicographical_compare(ring.begin(), ring.end(), best.begin(), best.end(), before))
        best = ring;
    }
    ring = best;
  }
  std::sort(rings.begin(), rings.end(), [&](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), before);
  });
  return rings;
}

/// 0 where the polygon turned round, and begun elsewhere, gives the same rings.
double turned_error(const Input& i) {
  if (!is_taken(i) || !is_simple(i)) return 0;
  Points turned = points_of(i);
  std::reverse(turned.begin(), turned.end());
  std::rotate(turned.begin(), turned.begin() + 2, turned.end());
  const auto region = region_of(i);
  if (!region) return wrong;
  return sorted(region->rings) == sorted(arcs(turned, circle_of(i)).rings) ? 0 : wrong;
}

/// How far the chords' ends are beside the circle, and how much more than the tolerance a chord lies away
/// from its arc, in ulp of abs(centre) + radius.
double chords_error(const Input& i) {
  const double exponent = i[shape_numbers];
  if (!is_taken(i) || !(1 <= exponent && exponent <= 16) || !is_simple(i)) return 0;
  const auto region = region_of(i);
  if (!region) return wrong;
  // Of the smallest radii so small a part is 0
  const double tolerance = i[2] * std::exp2(-exponent);
  std::vector<Points> flat;
  try {
    flat = flatten(*region, tolerance);
  } catch (const ContractViolation&) {
    return tolerance / i[2] < 0x1p-40 ? 0 : wrong;
  }
  if (flat.size() != region->rings.size()) return wrong;
  const Point centre = test::wide(region->circle.centre);
  const auto distance = [&](const Wide& x, const Wide& y) -> Wide {
    const Wide dx = x - centre.x, dy = y - centre.y;
    return sqrt(Wide(dx * dx + dy * dy));
  };
  const double size =
      std::min(std::max(std::abs(i[0]), std::abs(i[1])) + i[2], std::numeric_limits<double>::max());
  const Wide r(i[2]), unit = Wide(size) - Wide(std::nextafter(size, 0.0));
  Wide worst = 0;
  for (std::size_t n = 0; n < flat.size(); ++n) {
    const auto& ring = region->rings[n];
    std::size_t at = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (at >= flat[n].size() || flat[n][at] != ring[k].at) return wrong;
      const bool last = k + 1 == ring.size();
      const dvec2 goal = ring[last ? 0 : k + 1].at;
      // Chord by chord to the ring's next corner
      for (bool there = false; !there;) {
        const Point p = test::wide(flat[n][at]), q = test::wide(flat[n][(at + 1) % flat[n].size()]);
        ++at;
        there = last ? at == flat[n].size() : at >= flat[n].size() || flat[n][at] == goal;
        if (!ring[k].arc) break;
        if (!there) worst = std::max(worst, Wide(abs(Wide(distance(q.x, q.y) - r)) / unit));
        // Neither farther from the arc than that, nor beyond it
        const Wide sagitta = r - distance((p.x + q.x) / 2, (p.y + q.y) / 2);
        worst = std::max({worst, Wide((sagitta - tolerance) / unit), Wide(-sagitta / unit)});
      }
    }
    if (at != flat[n].size()) return wrong;
  }
  return static_cast<double>(worst);
}

std::vector<std::pair<std::string, std::string>> arguments(const Input& i) {
  std::string polygon;
  for (const dvec2& p : points_of(i)) polygon += fmt::format("{}{},{}", polygon.empty() ? "" : " ", p.x, p.y);
  return {{"method", "arcs"}, {"polygon", polygon}, {"circle", fmt::format("{},{},{}", i[0], i[1], i[2])}};
}

/// A circle and corners, the last one as often as it takes.
Input shape_of(Input circle, const Points& points) {
  for (std::size_t k = 0; k < corners; ++k) {
    const dvec2 p = points[std::min(k, points.size() - 1)];
    circle.push_back(p.x);
    circle.push_back(p.y);
  }
  return circle;
}

std::vector<Trap> traps() {
  constexpr double largest = std::numeric_limits<double>::max();
  return {
      {"the exit is lost", shape_of({0, 0, 1}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}})},
      {"two exits are lost", shape_of({0, 0, 1}, {{0, -0.5}, {3, -0.5}, {0, 0.5}})},
      {"edges that cross twice", shape_of({0, 0, 1}, {{-0.8, -0.8}, {0.8, -0.8}, {0.8, 0.8}, {-0.8, 0.8}})},
      {"the polygon holds the circle", shape_of({0, 0, 1}, {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}})},
      {"a band", shape_of({0, 0, 1}, {{-2, -0.5}, {2, -0.5}, {2, 0.5}, {-2, 0.5}})},
      {"all corners on the circle",
       shape_of({0, 0, 5}, {{5, 0}, {3, 4}, {-3, 4}, {-5, 0}, {-4, -3}, {4, -3}})},
      {"edges touch the circle", shape_of({0, 0, 5}, {{5, -5}, {5, 5}, {-5, 5}, {-5, -5}})},
      {"tangent from inside", shape_of({0, 3, 3}, {{-5, 0}, {5, 0}, {5, -4}, {-5, -4}})},
      {"a corner on the smallest circle",
       shape_of({0, 0, 0x5p-987}, {{0, 0}, {-0x2p-987, 0}, {0, -0x5p-987}, {0x2p-987, 0}})},
      {"r squared underflows, the edges are long",
       shape_of({0, 0, 0x1p-540},
                {{-0x1p200, 0x1p-600}, {0x1p200, 0x1p-600}, {0x1p200, 0x1p200}, {-0x1p200, 0x1p200}})},
      {"an edge's length squared underflows, r is large",
       shape_of({0, 0, 0x1p500}, {{0x1p-540, 0x1p500}, {-0x1p-540, 0x1p500}, {0, -0x1p499}})},
      {"an edge's length squared underflows, and it lies outside",
       shape_of({0, 0, 0x1p498},
                {{0x1p-540, 0x1p500}, {-0x1p-540, 0x1p500}, {-0x1p503, -0x1p502}, {0x1p503, -0x1p502}})},
      {"a sum of the largest circle overflows",
       shape_of({-0x3p970, 0, largest}, {{largest, 0}, {largest, 1}, {0, 1}, {0, 0}})},
      {"the smallest circle", shape_of({0, 0, 0x1p-1074}, {{-1, 0}, {1, 0}, {1, 1}, {-1, 1}})},
      {"a radius of 0", shape_of({1, 1, 0}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}})},
      {"no area", shape_of({0, 0, 1}, {{-2, 0}, {2, 0}})},
      {"a radius that is no number", shape_of({0, 0, std::nan("")}, {{0, 0}, {2, 0}, {2, 2}})},
      {"a negative radius", shape_of({0, 0, -1}, {{0, 0}, {2, 0}, {2, 2}})}};
}
std::vector<Trap> with_tolerance(std::vector<Trap> all) {
  for (Trap& trap : all) trap.input.push_back(6);
  return all;
}

Property promise(const char* name, const char* states, double (*error)(const Input&)) {
  return {.name = name,
          .states = states,
          .unit = "wrong",
          .bound = 0,
          .numbers = shape_numbers,
          .generate = shape,
          .error = error,
          .arguments = arguments,
          .traps = traps()};
}
Property measured(Property promise, const char* unit, double bound) {
  promise.unit = unit;
  promise.bound = bound;
  return promise;
}
/// Of inputs whose numbers are of like size.
Property of_one_size(Property promise, std::int64_t cases) {
  promise.kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge,
                   Kind::tiny,   Kind::denormal,        Kind::ties};
  promise.cases = cases;
  return promise;
}

/// A situation of what comes of a simple polygon.
template <class Holds>
Share share(const char* of, double least, Holds holds) {
  return {of, least, [holds](const Input& i) {
            const auto region = is_taken(i) && is_simple(i) ? region_of(i) : std::nullopt;
            return region && holds(*region);
          }};
}

Property pieces() {
  Property it = promise("pieces",
                        "of each edge its piece in the disc, decided exactly; ends within 0.63 ulp of "
                        "max(|coordinate|, r)",
                        pieces_error);
  it.shares = {share("several pieces", 0.05, [](const auto& region) { return region.rings.size() > 1; }),
               share("nothing", 0.01, [](const auto& region) { return region.rings.empty(); }),
               share("the whole circle", 0.01, [](const auto& region) {
                 return !region.rings.empty() && region.rings[0].size() == 1;
               })};
  return measured(it, "ulp", 0.63);
}
Property order() {
  Property it =
      of_one_size(promise("order", "passages come in the order of their angles", order_error), 5'000);
  it.shares = {{"passages that doubles can't tell", 0.02, has_doubtful_order},
               {"passages at corners", 0.05, [](const Input& i) {
                  const auto seen = steps_of(i);
                  return seen && std::ranges::any_of(all<Sorted>(*seen).at(0).crossings,
                                                     [](const Crossing& c) { return c.corner.has_value(); });
                }}};
  return it;
}
Property floats() {
  Property it = promise("area_in_float", "the same of floats", area_error<float>);
  it.kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::ties};
  it.generate = [](Kind kind, Random& random) { return rounded_to_floats(shape(kind, random)); };
  it.error = [](const Input& i) { return area_error<float>(rounded_to_floats(i)); };
  it.traps.clear();
  it.cases = 3'000;
  return measured(it, "of that", 1);
}
Property chords() {
  Property it = promise(
      "chords", "chords keep the tolerance, their ends lie within 4 ulp of |centre| + r of the circle",
      chords_error);
  ++it.numbers;
  it.generate = [](Kind kind, Random& random) {
    Input input = shape(kind, random);
    input.push_back(static_cast<double>(random.uniform_int(1, 12)));
    return input;
  };
  it.arguments = [](const Input& i) {
    auto flags = arguments(i);
    flags.emplace_back("tolerance", fmt::format("{}", i[2] * std::exp2(-i[shape_numbers])));
    return flags;
  };
  it.traps = with_tolerance(traps());
  // Square roots in 200 bits, two per chord
  it.cases = 3'000;
  return measured(it, "ulp", 4);
}

}  // namespace

Domain polygon_circle() {
  // Angles in 200 bits take a third of a millisecond
  constexpr std::int64_t fewer = 3'000;
  return {
      "polygon_circle",
      {pieces(),
       promise("edges", "which edges run in the disc is exact; they are cut as segments are", edges_error),
       order(), promise("arcs_inside", "every arc lies in the polygon", arcs_error),
       measured(of_one_size(promise("area",
                                    "the area that the rings bound is right to 4 (r + their length) "
                                    "ulp(max(|coordinate|, r))",
                                    area_error<double>),
                            fewer),
                "of that", 1),
       floats(),
       promise("turned", "the polygon turned round, and begun elsewhere, gives the same rings", turned_error),
       measured(promise("area_of_rings", "`area` of n corners is right to n (n + 50) 2^-54 R^2",
                        area_of_rings_error),
                "of that", 1),
       chords()}};
}

}  // namespace gradus::stress
