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
#include "stress/clipping/circle_scales.hpp"
#include "stress/numbers.hpp"
#include "support/circle_areas.hpp"
#include "support/polygon_areas.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::polygon_circle;
using test::Fraction;
using test::Point;
using test::Wide;
using Points = std::vector<dvec2>;

// --- Inputs: centre, radius, up to twelve corners, the last one as often as it takes ---

constexpr std::size_t corners = 12, shape_numbers = 3 + 2 * corners;

template <class T = double>
std::vector<glm::vec<2, T>> points_of(const Input& i) {
  std::vector<glm::vec<2, T>> points;
  for (std::size_t k = 0; k < corners; ++k) {
    points.emplace_back(static_cast<T>(i[3 + 2 * k]), static_cast<T>(i[4 + 2 * k]));
  }
  return points;
}
template <class T = double>
Circle<T> circle_of(const Input& i) {
  return {{static_cast<T>(i[0]), static_cast<T>(i[1])}, static_cast<T>(i[2])};
}
bool is_taken(const Input& i) { return all_finite(i) && i[2] >= 0; }
bool is_simple(const Input& i) { return !meeting_edges(counter_clockwise(points_of(i))); }

/// The corners in their order or turned round, from any of them on.
Input with_corners(Input circle, Points points, Random& random) {
  if (random.unit() < 0.5) std::ranges::reverse(points);
  std::rotate(points.begin(), points.begin() + random.uniform_int(0, std::ssize(points) - 1), points.end());
  points.resize(corners, points.back());
  for (const dvec2 p : points) circle.insert(circle.end(), {p.x, p.y});
  return circle;
}
dvec2 on_circle(double turn, double radius) {
  const SinCos at = sin_cos(0x1.921fb54442d18p2 * turn);
  return radius * dvec2(at.cos, at.sin);
}

/// A star-shaped polygon: angle by angle, near the circle or anywhere.
Input star(Kind kind, Random& random) {
  const double radius = random.uniform(0.5, 8);
  const dvec2 centre = kind == Kind::random ? dvec2(random.uniform(-4, 4), random.uniform(-4, 4)) : dvec2(0);
  const auto n = random.uniform_int(3, corners);
  Points points;
  for (std::int64_t i = 0; i < n; ++i) {
    const double turn = (static_cast<double>(i) + random.uniform(0.1, 0.9)) / static_cast<double>(n);
    const double way = random.unit();
    double length = random.uniform(1, 12);
    if (kind == Kind::grazing && way < 0.6) length = radius;                       // on the circle
    if (kind == Kind::grazing && way > 0.8) length = radius / std::cos(2 * turn);  // on a tangent
    const dvec2 p = centre + on_circle(turn, length);
    points.push_back(kind == Kind::grazing ? dvec2(nudged(p.x, random), nudged(p.y, random)) : p);
  }
  return with_corners({centre.x, centre.y, radius}, points, random);
}

/// Small whole numbers and halves, many of them on the circle of radius 5 or on its tangents.
Input lattice(Random& random) {
  constexpr double fives[12][2] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                                   {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
  Points points;
  for (const auto& p : fives) {
    const double sizes[] = {0.5, 1, 1, 2, 3};
    const double size = sizes[random.uniform_int(0, 4)];
    if (random.unit() < 0.7 || points.empty()) points.push_back(size * dvec2(p[0], p[1]));
  }
  const double radii[] = {5, 5, 5, 10, 3};
  return with_corners({0, 0, radii[random.uniform_int(0, 4)]}, points, random);
}

/// Spikes so thin that doubles cannot tell where their sides pass through the circle.
Input spikes(Random& random) {
  const double radius = random.uniform(0.5, 8);
  Points points;
  for (int i = 0; i < 3; ++i) {
    // Out, and nearly the same way back
    points.push_back(on_circle((i + 0.1) / 3, radius * random.uniform(0.1, 0.4)));
    // Far out, or hardly beyond the circle: then all four passages lie within some units
    const int beyond = static_cast<int>(random.uniform_int(40, 53));
    const double reach = random.unit() < 0.5 ? random.uniform(1, 3) : 1 + std::ldexp(random.unit(), -beyond);
    const dvec2 tip = on_circle((i + random.uniform(0.3, 0.5)) / 3, radius * reach);
    points.push_back(tip);
    points.push_back({nudged(tip.x, random), nudged(tip.y, random)});
    points.push_back(on_circle((i + 0.9) / 3, radius * random.uniform(0.1, 0.4)));
  }
  return with_corners({0, 0, radius}, points, random);
}

/// A comb with two teeth: several pieces.
Input comb(Random& random) {
  Points points{{-9, -9}, {9, -9}};
  for (const double x : {0.0, -6.0}) {
    for (const double at : {x + 5.4, x + 3}) points.emplace_back(at, random.uniform(6, 12));
    for (const double at : {x + 2.4, x + 0.6}) points.emplace_back(at, random.uniform(-8, 5));
  }
  return with_corners({0, 0, random.uniform(3, 8)}, points, random);
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
  for (int i = 0; i < 6; ++i) {
    const int like = std::ilogb(radius);
    const double length = (random.unit() < 0.7 ? sizes.within(like - 60, like + 60) : sizes).power(random);
    star.push_back(on_circle((i + random.uniform(0.1, 0.9)) / 6, length));
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
      input = random.unit() < 0.3   ? lattice(random)
              : random.unit() < 0.3 ? comb(random)
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
      return kind == Kind::random && random.unit() < 0.5 ? comb(random) : star(kind, random);
  }
  for (std::size_t k = 0; k < shape_numbers; ++k) input.push_back(number(kind, random));
  input[2] = std::abs(input[2]);
  return input;
}

// --- Promises ---

/// Whether 200 bits hold every sum of products of these numbers.
bool of_one_size(const Input& i) {
  double least = wrong, most = 0;
  for (const double x : i) {
    if (x != 0) least = std::min(least, std::abs(x));
    most = std::max(most, std::abs(x));
  }
  return most <= 0x1p30 * least;
}

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
double error_of(const Way& way, const EndsInCircle<double>& piece) {
  const auto off = [](const Place<double>& place, bool given, dvec2 p) {
    const double error = place.error(p);
    return given && error != 0 ? wrong : error;
  };
  return std::max(off(piece.from, piece.from_is_given, way.from), off(piece.to, piece.to_is_given, way.to));
}
double error_either_way(const Way& way, const EndsInCircle<double>& piece) {
  return std::min(error_of(way, piece), error_of({way.to, way.from}, piece));
}

/// The rings, if nothing is refused.
template <class T = double>
std::optional<Region<T>> region_of(const Input& i) {
  try {
    return arcs(points_of<T>(i), circle_of<T>(i));
  } catch (const ContractViolation&) {
    return std::nullopt;
  }
}

/// What the rings have of straight ways, and their corners; short pieces may have rounded to one.
struct WaysOfRings {
  std::vector<Way> ways, points;
  bool any_of_no_length = false;
};
WaysOfRings ways_of(const Region<double>& region) {
  WaysOfRings all;
  for (const auto& ring : region.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Way way{ring[k].at, ring[(k + 1) % ring.size()].at};
      all.points.push_back({way.from, way.from});
      if (!ring[k].arc) all.ways.push_back(way);
      all.any_of_no_length |= !ring[k].arc && ring.size() > 1 && way.from == way.to;
    }
  }
  return all;
}

/// The worst end of what the rings have of the polygon's edges; wrong where they lack an edge's piece, or
/// have one that is none.
double pieces_error(const Input& i) {
  const auto region = region_of(i);
  if (!is_taken(i)) return region ? wrong : 0;
  if (!is_simple(i)) return 0;
  if (!region) return wrong;
  const Points points = points_of(i);
  std::vector<EndsInCircle<double>> pieces;
  const bool has_area = test::exact_area(points) != 0;
  for (std::size_t k = 0; has_area && k < corners; ++k) {
    const dvec2 a = points[k], b = points[(k + 1) % corners];
    if (a == b) continue;
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
  const WaysOfRings found = ways_of(*region);
  if (found.any_of_no_length) return wrong;
  double worst = 0;
  for (const auto& piece : pieces) {
    double best = wrong;
    for (const Way& way : found.ways) best = std::min(best, error_either_way(way, piece));
    for (const Way& way : found.points) best = std::min(best, error_either_way(way, piece));
    worst = std::max(worst, best);
  }
  for (const Way& way : found.ways) {
    const auto is_way = [&](const auto& piece) { return error_either_way(way, piece) <= 1; };
    if (std::ranges::none_of(pieces, is_way)) return wrong;
  }
  return worst;
}

// --- Steps ---

using Steps = Recorder<Oriented, Tested, Sorted, Entered, Walked, Bent, Closed, Finished<double>>;
/// The steps of a simple polygon.
std::optional<Steps> steps_of(const Input& i) {
  if (!is_taken(i) || !is_simple(i)) return std::nullopt;
  Steps seen;
  arcs(points_of(i), circle_of(i), seen);
  return seen;
}

/// 0 where each edge runs in the open disc exactly when it does, and has the bits of a clipped segment.
double edges_error(const Input& i) {
  const auto seen = steps_of(i);
  if (!seen) return 0;
  for (const Tested& t : all<Tested>(*seen)) {
    const auto [a, b] = t.run.edge;
    if (t.run.inside != WholeQuadratic({a.x, a.y, b.x, b.y, i[0], i[1], i[2]}).runs()) return wrong;
    if (!t.run.inside) continue;
    const Segment<2, double> run{t.enters.value_or(a), t.leaves.value_or(b)};
    if (run != liang_barsky_circle::exact_decision(t.run.edge, circle_of(i))) return wrong;
  }
  return 0;
}

/// The direction of a passage from the centre, in 400 bits.
using Many = test::Float<400>;
struct Direction {
  Many x, y;
  int half() const { return (abs(y) > Many(0x1p-1000) ? y > 0 : x > 0) ? 0 : 1; }
};
Direction direction_of(const Crossing& c, const Points& around, const Circle<double>& circle) {
  const Segment<2, double> s = edge_of(around, c.edge);
  const Many dx = Many(s.b.x) - s.a.x, dy = Many(s.b.y) - s.a.y;
  const Many fx = Many(s.a.x) - circle.centre.x, fy = Many(s.a.y) - circle.centre.y;
  const Many k = dx * fy - dy * fx, A = dx * dx + dy * dy, r(circle.radius);
  const Many root = sqrt(Many(r * r * A - k * k)) * (c.leaves ? 1 : -1);
  return {(root * dx - k * dy) / A / r, (root * dy + k * dx) / A / r};
}

/// How far each passage is turned beyond the one before it, round the circle; below 0 where the order is
/// wrong.
std::vector<Many> turns_of(const Steps& seen) {
  const auto oriented = all<Oriented>(seen).at(0);
  const auto sorted = all<Sorted>(seen).at(0);
  std::vector<Direction> directions;
  for (const Crossing& c : sorted.crossings) {
    directions.push_back(direction_of(c, oriented.corners, oriented.circle));
  }
  std::vector<Many> turns;
  for (std::size_t k = 0; k + 1 < directions.size(); ++k) {
    const Direction &a = directions[k], &b = directions[k + 1];
    turns.push_back(a.half() == b.half() ? Many(a.x * b.y - a.y * b.x) : Many(b.half() - a.half()));
  }
  return turns;
}
double order_error(const Input& i) {
  if (!of_one_size(i)) return 0;
  const auto seen = steps_of(i);
  if (!seen) return 0;
  // 400 bits hold what equal directions leave
  const auto is_right = [](const Many& turn) { return turn >= -Many(0x1p-1000); };
  return std::ranges::all_of(turns_of(*seen), is_right) ? 0 : wrong;
}
/// Whether passages lie so close that doubles can't tell them apart.
bool has_doubtful_order(const Input& i) {
  const auto seen = of_one_size(i) ? steps_of(i) : std::nullopt;
  if (!seen) return false;
  return std::ranges::any_of(turns_of(*seen),
                             [](const Many& turn) { return Many(0x1p-1000) < turn && turn < Many(0x1p-50); });
}

/// 0 where every arc that can be told from a point lies in the polygon, at one of some places at least: at
/// others a corner may touch it.
double arcs_error(const Input& i) {
  // Of the smallest circles doubles can't name the middle of an arc
  if (!is_taken(i) || i[2] < 0x1p-1000 || !is_simple(i) || !of_one_size(i)) return 0;
  const auto region = region_of(i);
  if (!region) return wrong;
  const auto lies_inside = [&](const ArcEnds& arc) {
    const double start = atan2(arc.from.y, arc.from.x);
    for (const double part : {0.5, 0.3, 0.7}) {
      const SinCos at = sin_cos(start + part * arc.radians);
      const dvec2 direction(at.cos, at.sin);
      for (const double length : {1.0, 1 - 0x1p-30}) {
        if (holds(points_of(i), region->circle.centre + length * region->circle.radius * direction))
          return true;
      }
    }
    return false;
  };
  for (const auto& ring : region->rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (!ring[k].arc) continue;
      const ArcEnds arc = ends_of_arc(ring, k, region->circle);
      if (arc.radians >= 1e-3 && !lies_inside(arc)) return wrong;
    }
  }
  return 0;
}

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
  // Square roots in 200 bits, two a chord
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
