// The promises of clipping a polygon to a circle: its pieces in the disc, the area that they and their arcs
// bound, and chords for the arcs.

#include "clipping/polygon_circle/polygon_circle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>

#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "stress/clipping/circle_ends.hpp"
#include "stress/clipping/circle_scales.hpp"
#include "stress/numbers.hpp"
#include "support/circle_areas.hpp"
#include "support/polygon_areas.hpp"

namespace gradus::stress {
namespace {

using polygon_circle::arcs;
using polygon_circle::Region;
using test::Point;
using test::Rational;
using test::Wide;
using Points = std::vector<dvec2>;

// --- Inputs: centre, radius, six corners ---

constexpr std::size_t corners = 6, shape_numbers = 3 + 2 * corners;

Points points_of(const Input& i) {
  Points points;
  for (std::size_t k = 0; k < corners; ++k) points.emplace_back(i[3 + 2 * k], i[4 + 2 * k]);
  return points;
}
Circle<double> circle_of(const Input& i) { return {{i[0], i[1]}, i[2]}; }
bool is_taken(const Input& i) { return all_finite(i) && i[2] >= 0; }
bool is_simple(const Input& i) {
  const Points points = points_of(i);
  return !polygon_circle::meeting_edges(polygon_circle::counter_clockwise(std::span<const dvec2>(points)));
}

/// A star-shaped polygon: angle by angle, near the circle or anywhere.
Input star(Kind kind, Random& random) {
  const double radius = random.uniform(0.5, 8);
  const dvec2 centre = kind == Kind::random ? dvec2(random.uniform(-4, 4), random.uniform(-4, 4)) : dvec2(0);
  Input input{centre.x, centre.y, radius};
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = (static_cast<double>(i) + random.uniform(0.1, 0.9)) * 6.283 / corners;
    const double way = random.unit();
    double length = random.uniform(1, 12);
    if (kind == Kind::grazing && way < 0.6) length = radius;                        // on the circle
    if (kind == Kind::grazing && way > 0.8) length = radius / std::cos(angle / 3);  // on a tangent
    const dvec2 p = centre + length * dvec2(std::cos(angle), std::sin(angle));
    input.push_back(kind == Kind::grazing ? nudged(p.x, random) : p.x);
    input.push_back(kind == Kind::grazing ? nudged(p.y, random) : p.y);
  }
  return input;
}

/// Small whole numbers, many of them on the circle of radius 5 or on its tangents.
Input lattice(Random& random) {
  constexpr double fives[12][2] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                                   {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
  Input input{0, 0, 5};
  for (std::size_t i = 0; i < corners; ++i) {
    const auto& p = fives[2 * i + static_cast<std::size_t>(random.uniform_int(0, 1))];
    const double sizes[] = {0.5, 1, 1, 2, 3};
    const double size = sizes[random.uniform_int(0, 4)];
    input.push_back(size * p[0]);
    input.push_back(size * p[1]);
  }
  return input;
}

/// Spikes so thin that doubles cannot tell where their sides pass through the circle.
Input spikes(Random& random) {
  Input input = star(Kind::near_degenerate, random);
  for (const std::size_t first : {3u, 9u}) {
    // Out, and nearly the same way back
    const dvec2 tip(input[first + 2], input[first + 3]);
    input[first + 4] = nudged(tip.x, random);
    input[first + 5] = nudged(tip.y, random);
  }
  return input;
}

/// The corners in their order or turned round, from any of them on, the last one as often as it takes.
Input with_corners(Input circle, Points points, Random& random) {
  if (random.unit() < 0.5) std::reverse(points.begin(), points.end());
  std::rotate(points.begin(), points.begin() + random.uniform_int(0, std::ssize(points) - 1), points.end());
  points.resize(corners, points.back());
  for (const dvec2 p : points) circle.insert(circle.end(), {p.x, p.y});
  return circle;
}

/// Sizes that have nothing to do with each other: bands along an axis that touch the circle or nearly do, a
/// triangle with a corner near the circle, and stars whose corners lie anywhere on their rays.
Input of_mixed_sizes(Random& random) {
  const Sizes sizes{-1074, 1020};
  const double radius = std::abs(sizes.any(random));
  const auto any = [&] { return sizes.power(random); };
  if (random.unit() < 0.4) {
    const auto height = [&] {
      const double heights[] = {0, radius / 2, radius, nudged(radius, random), 2 * radius, any()};
      return heights[random.uniform_int(0, 5)];
    };
    const double x0 = -any(), x1 = any(), y0 = random.unit() < 0.5 ? -height() : height();
    const double y1 = std::max(y0 + std::abs(y0), height());
    Points band{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    if (random.unit() < 0.5) {
      for (dvec2& p : band) p = {-p.y, p.x};
    }
    return with_corners({0, 0, radius}, band, random);
  }
  const dvec2 centre(random.unit() < 0.5 ? 0 : sizes.any(random), 0);
  if (random.unit() < 0.5) {
    const dvec2 near = centre + radius * dvec2(random.uniform(-2, 2), random.uniform(-2, 2));
    const auto coordinate = [&] { return random.unit() < 0.2 ? 0 : sizes.any(random); };
    Points triangle{near, near, near};
    for (const std::size_t i : {1u, 2u}) triangle[i] = {coordinate(), coordinate()};
    return with_corners({centre.x, centre.y, radius}, triangle, random);
  }
  Points star;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = (static_cast<double>(i) + random.uniform(0.1, 0.9)) * 6.283 / corners;
    const int like = std::ilogb(radius);
    const double length = (random.unit() < 0.7 ? sizes.within(like - 60, like + 60) : sizes).power(random);
    star.push_back(length * dvec2(std::cos(angle), std::sin(angle)));
  }
  return with_corners({0, 0, radius}, star, random);
}

Input shape(Kind kind, Random& random) {
  Input input;
  switch (kind) {
    case Kind::ties:
      return lattice(random);
    case Kind::near_degenerate:
      return spikes(random);
    case Kind::extremes:
      if (random.unit() < 0.6) return of_mixed_sizes(random);
      break;
    case Kind::huge:
    case Kind::tiny:
    case Kind::denormal: {
      if (random.unit() < 0.1) break;
      constexpr Kind shapes[] = {Kind::random, Kind::near_degenerate, Kind::grazing};
      input = random.unit() < 0.4   ? lattice(random)
              : random.unit() < 0.3 ? spikes(random)
                                    : star(shapes[random.uniform_int(0, 2)], random);
      scale(input, scale_of(kind, random));
      return input;
    }
    case Kind::refused: {
      input = star(Kind::random, random);
      const auto at = static_cast<std::size_t>(random.uniform_int(0, shape_numbers - 1));
      input[at] = at == 2 && random.unit() < 0.5 ? -1 : random.unit() < 0.5 ? std::nan("") : wrong;
      return input;
    }
    default:
      return star(kind, random);
  }
  for (std::size_t k = 0; k < shape_numbers; ++k) input.push_back(number(kind, random));
  input[2] = std::abs(input[2]);
  return input;
}

// --- Promises ---

/// Whether a point lies in a polygon, not on it: an odd number of edges passes right of it.
bool holds(const Points& points, dvec2 at) {
  const test::ExactPoint p = test::exact_point(at);
  bool inside = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto a = test::exact_point(points[i]), b = test::exact_point(points[(i + 1) % points.size()]);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    inside ^= (test::turn(a, b, p) > 0) == (a.y < b.y);
  }
  return inside;
}

/// A straight way between two points.
struct Way {
  dvec2 from, to;
};

/// How far a way is from an edge's piece, in either direction; a given end must be met bit for bit.
double error_of(const Way& way, const EndsInCircle& piece) {
  const auto off = [](const Place& place, bool given, dvec2 p) {
    const double error = place.error(p);
    return given && error != 0 ? wrong : error;
  };
  return std::max(off(piece.from, piece.from_is_given, way.from), off(piece.to, piece.to_is_given, way.to));
}
double error_either_way(const Way& way, const EndsInCircle& piece) {
  return std::min(error_of(way, piece), error_of({way.to, way.from}, piece));
}

/// The rings, if nothing is refused.
std::optional<Region<double>> region_of(const Input& i) {
  const Points points = points_of(i);
  try {
    return arcs(std::span<const dvec2>(points), circle_of(i));
  } catch (const ContractViolation&) {
    return std::nullopt;
  }
}

/// The worst end of what the rings have of the polygon's edges; wrong where they lack an edge's piece, or
/// have one that is none.
double pieces_error(const Input& i) {
  if (is_taken(i) && !is_simple(i)) return 0;
  const auto region = region_of(i);
  if (!region || !is_taken(i)) return region || is_taken(i) ? wrong : 0;
  const Points points = points_of(i);
  std::vector<EndsInCircle> pieces;
  const bool has_area = test::exact_area(points) != 0;
  for (std::size_t k = 0; has_area && k < corners; ++k) {
    const dvec2 a = points[k], b = points[(k + 1) % corners];
    const auto ends = ends_in_circle({a.x, a.y, b.x, b.y, i[0], i[1], i[2]});
    if (ends && ends->runs) pieces.push_back(*ends);
  }
  if (pieces.empty()) {
    const bool whole = has_area && i[2] > 0 && holds(points, {i[0], i[1]});
    if (!whole) return region->rings.empty() ? 0 : wrong;
    const bool is_whole =
        region->rings.size() == 1 && region->rings[0].size() == 1 && region->rings[0][0].arc;
    return is_whole ? 0 : wrong;
  }
  // Short pieces may have rounded to a point
  std::vector<Way> ways, points_of_rings;
  for (const auto& ring : region->rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const dvec2 from = ring[k].at, to = ring[(k + 1) % ring.size()].at;
      points_of_rings.push_back({from, from});
      if (!ring[k].arc && from != to) ways.push_back({from, to});
    }
  }
  double worst = 0;
  for (const EndsInCircle& piece : pieces) {
    double best = wrong;
    for (const Way& way : ways) best = std::min(best, error_either_way(way, piece));
    for (const Way& way : points_of_rings) best = std::min(best, error_either_way(way, piece));
    worst = std::max(worst, best);
  }
  for (const Way& way : ways) {
    const auto is_way = [&](const EndsInCircle& piece) { return error_either_way(way, piece) <= 1; };
    if (std::none_of(pieces.begin(), pieces.end(), is_way)) return wrong;
  }
  return worst;
}

/// Whether 200 bits hold every sum of products of these numbers.
bool of_one_size(const Input& i) {
  double least = wrong, most = 0;
  for (const double x : i) {
    if (x != 0) least = std::min(least, std::abs(x));
    most = std::max(most, std::abs(x));
  }
  return most <= 0x1p30 * least;
}

/// The error of the rings' area, in parts of what the header allows.
double area_error(const Input& i) {
  if (!is_taken(i) || !is_simple(i) || !of_one_size(i)) return 0;
  const auto region = region_of(i);
  if (!region) return wrong;
  const test::Enclosed got = test::enclosed_by(*region);
  if (i[2] == 0) return got.length == 0 ? 0 : wrong;
  const Wide right = test::exact_area(points_of(i), region->circle);
  // What is left is no larger than the polygon, and not beyond the circle
  double largest = 0;
  for (std::size_t k = 3; k < shape_numbers; ++k) largest = std::max(largest, std::abs(i[k]));
  const double reach = std::max(std::abs(i[0]), std::abs(i[1])) + i[2];
  const double size = std::max(i[2], std::min(largest, reach));
  const Wide unit = Wide(size) - Wide(std::nextafter(size, 0.0));
  const Wide most = 4 * (Wide(i[2]) + got.length) * unit;
  return static_cast<double>(Wide(abs(Wide(got.area - right)) / most));
}

/// The error of `area` against what the rings it is given bound, in parts of what the header allows.
double area_of_rings_error(const Input& i) {
  if (!is_taken(i) || !is_simple(i)) return 0;
  const auto region = region_of(i);
  if (!region) return wrong;
  const test::Enclosed right = test::enclosed_by(*region);
  const double got = area(*region);
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
using Rings = std::vector<polygon_circle::Ring<double>>;
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
  return sorted(region->rings) == sorted(arcs(std::span<const dvec2>(turned), circle_of(i)).rings) ? 0
                                                                                                   : wrong;
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
        const Wide sagitta = r - distance((p.x + q.x) / 2, (p.y + q.y) / 2);
        worst = std::max(worst, Wide((sagitta - tolerance) / unit));
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

}  // namespace

Domain polygon_circle() {
  const std::vector<Kind> kinds_of_one_size{Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge,
                                            Kind::tiny,   Kind::denormal,        Kind::ties};
  return {
      "polygon_circle",
      {{.name = "pieces",
        .states = "of each edge its piece in the disc, decided exactly; ends within 0.63 ulp of "
                  "max(|coordinate|, r)",
        .unit = "ulp",
        .bound = 0.63,
        .numbers = shape_numbers,
        .generate = shape,
        .error = pieces_error,
        .arguments = arguments,
        .traps = traps()},
       {.name = "area",
        .states = "the area that the rings bound is right to 4 (r + their length) ulp(max(|coordinate|, r))",
        .unit = "of that",
        .bound = 1,
        .numbers = shape_numbers,
        .kinds = kinds_of_one_size,
        .generate = shape,
        .error = area_error,
        .arguments = arguments,
        .traps = traps()},
       {.name = "turned",
        .states = "the polygon turned round, and begun elsewhere, gives the same rings",
        .unit = "wrong",
        .bound = 0,
        .numbers = shape_numbers,
        .generate = shape,
        .error = turned_error,
        .arguments = arguments,
        .traps = traps()},
       {.name = "area_of_rings",
        .states = "`area` of n corners is right to n (n + 50) 2^-54 R^2",
        .unit = "of that",
        .bound = 1,
        .numbers = shape_numbers,
        .generate = shape,
        .error = area_of_rings_error,
        .arguments = arguments,
        .traps = traps()},
       {.name = "chords",
        .states = "chords keep the tolerance, their ends lie within 4 ulp of |centre| + r of the circle",
        .unit = "ulp",
        .bound = 4,
        .numbers = shape_numbers + 1,
        .generate =
            [](Kind kind, Random& random) {
              Input input = shape(kind, random);
              input.push_back(static_cast<double>(random.uniform_int(1, 12)));
              return input;
            },
        .error = chords_error,
        .arguments =
            [](const Input& i) {
              auto all = arguments(i);
              all.emplace_back("tolerance", fmt::format("{}", i[2] * std::exp2(-i[shape_numbers])));
              return all;
            },
        .traps = with_tolerance(traps())}}};
}

}  // namespace gradus::stress
