// The promises of cutting polygons into triangles, in the plane and in space.

#include "modeling/ear_clipping/ear_clipping.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <numeric>
#include <optional>

#include "clipping/polygon_circle/crossings.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/axis_cut.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "modeling/ear_clipping/join_holes.hpp"
#include "modeling/ear_clipping/widest_ear.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"
#include "support/polygon_areas.hpp"

namespace gradus::stress {
namespace {

using ear_clipping::Triangle;
using test::Fraction;
using Points = std::vector<dvec2>;
using Face = std::vector<dvec3>;

// --- Inputs: how many corners, and then the corners ---

constexpr std::size_t most_corners = 24;

/// Corners round a middle, near and far in turns, some of them on the line of their neighbours: mostly
/// simple.
Points star(Kind kind, Random& random) {
  const auto corners = random.uniform_int(3, most_corners);
  Points points;
  for (std::int64_t i = 0; i < corners; ++i) {
    const double turns = (static_cast<double>(i) + random.uniform(0, 0.9)) / static_cast<double>(corners);
    const SinCos at = sin_cos(0x1.921fb54442d18p2 * turns);
    const double distance = kind == Kind::near_degenerate
                                ? std::ldexp(8, -static_cast<int>(random.uniform_int(0, 40)))
                                : random.uniform(0.5, 8);
    const dvec2 p = distance * dvec2(at.cos, at.sin);
    points.push_back(kind == Kind::ties ? glm::round(8.0 * p) : p);
  }
  for (std::size_t i = 1; i + 1 < points.size() && kind == Kind::grazing; i += 2) {
    // On the line of its neighbours, but for the last places
    const dvec2 on = points[i - 1] + random.unit() * (points[i + 1] - points[i - 1]);
    if (random.unit() < 0.6) points[i] = {nudged(on.x, random), nudged(on.y, random)};
  }
  return points;
}
/// A comb on whole numbers: deep notches and straight corners.
Points comb(Random& random) {
  const double end = static_cast<double>(2 * random.uniform_int(1, 5));
  Points points{{0, 0}};
  for (double x = 1; x <= end; ++x) {
    if (random.uniform_int(0, 2) == 0) points.emplace_back(2 * x - 1, 0);
  }
  points.emplace_back(2 * end, 0);
  for (double x = end; x >= 0; --x) {
    points.emplace_back(2 * x, std::fmod(x, 2) == 0 ? 20 : static_cast<double>(2 * random.uniform_int(1, 2)));
  }
  return points;
}
Points shape(Kind kind, Random& random) {
  return kind == Kind::ties && random.unit() < 0.5 ? comb(random) : star(kind, random);
}
bool is_place_of_several(Kind kind) {
  return kind == Kind::random || kind == Kind::near_degenerate || kind == Kind::grazing ||
         kind == Kind::ties || kind == Kind::refused;
}

/// Corners of two or three coordinates; of kinds that are about one number's size, any numbers.
template <class Corners>
Input input_of(const Corners& corners, Kind kind, Random& random) {
  constexpr int axes = Corners::value_type::length();
  Input input{static_cast<double>(corners.size())};
  for (const auto& corner : corners) {
    for (int axis = 0; axis < axes; ++axis) {
      input.push_back(is_place_of_several(kind) ? corner[axis] : number(kind, random));
    }
  }
  if (kind == Kind::refused) {
    const auto at = random.uniform_int(0, std::ssize(input) - 1);
    input[static_cast<std::size_t>(at)] = at == 0 ? 2 : random.unit() < 0.5 ? std::nan("") : wrong;
  }
  input.resize(1 + axes * most_corners, 0);
  return input;
}
Input flat_input(Kind kind, Random& random) {
  const dvec2 middle =
      random.unit() < 0.5 ? dvec2(0) : dvec2{random.uniform(-16, 16), random.uniform(-16, 16)};
  Points points = shape(kind, random);
  for (dvec2& p : points) p += kind == Kind::ties ? glm::round(middle) : middle;
  return input_of(points, kind, random);
}
/// The same on a plane in space: as flat as rounding leaves it, of ties exactly.
Input space_input(Kind kind, Random& random) {
  const auto any = [&] {
    dvec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = random.unit() < 0.3 ? 0 : random.uniform(-9, 9);
      if (kind == Kind::ties) p[axis] = std::round(p[axis]);
    }
    return p;
  };
  const dvec3 origin = any(), u = any(), v = any();
  Face face;
  for (const dvec2 p : shape(kind, random)) face.push_back(origin + p.x * u + p.y * v);
  return input_of(face, kind, random);
}
/// All lengths of an input of so many axes: all numbers but the first.
std::vector<std::size_t> lengths(std::size_t axes) {
  std::vector<std::size_t> all(axes * most_corners);
  std::iota(all.begin(), all.end(), std::size_t{1});
  return all;
}

/// The corners; nothing where there is no such number of them.
template <class Corner>
std::optional<std::vector<Corner>> corners_in(const Input& i) {
  if (i[0] != std::floor(i[0]) || !(0 <= i[0] && i[0] <= most_corners)) return std::nullopt;
  std::vector<Corner> corners(static_cast<std::size_t>(i[0]));
  std::size_t next = 1;
  for (Corner& corner : corners) {
    for (int axis = 0; axis < Corner::length(); ++axis) corner[axis] = i[next++];
  }
  return corners;
}
template <class Corner>
bool is_taken(const std::vector<Corner>& corners) {
  return corners.size() >= 3 && std::ranges::all_of(corners, [](const Corner& p) { return is_finite(p); });
}

// --- Promises ---

/// The triangles of a polygon of two or three dimensions; nothing where it was refused.
template <class Polygon>
std::optional<std::vector<Triangle>> triangles_of(const Polygon& polygon) {
  std::vector<Triangle> triangles;
  try {
    ear_clipping::triangulate(polygon, [&](const Triangle& t) { triangles.push_back(t); });
  } catch (const ContractViolation&) {
    return std::nullopt;
  }
  return triangles;
}

/// How many corners of a simple polygon that runs counter-clockwise are not covered exactly once; of others
/// only the number of triangles is promised.
double cover_error(const Points& polygon, const std::vector<Triangle>& triangles) {
  if (triangles.size() != polygon.size() - 2) return wrong;
  Fraction sum = 0;
  bool turned_round = false;
  for (const Triangle& t : triangles) {
    Points three;
    for (const int corner : t) three.push_back(polygon[static_cast<std::size_t>(corner)]);
    const Fraction area = test::exact_area(three);
    turned_round = turned_round || area < 0;
    sum += area;
  }
  // Areas that are none below 0 and add up cover once
  const Fraction whole = test::exact_area(polygon);
  if (sum != whole) return wrong;
  if (whole <= 0 || polygon_circle::meeting_edges(polygon)) return 0;
  return turned_round ? wrong : 0;
}

double flat_error(const Input& i) {
  auto polygon = corners_in<dvec2>(i);
  if (!polygon) return 0;
  const bool taken = is_taken(*polygon);
  if (taken && test::exact_area(*polygon) < 0) std::ranges::reverse(*polygon);
  const auto triangles = triangles_of(*polygon);
  if (triangles.has_value() != taken) return wrong;
  return triangles ? cover_error(*polygon, *triangles) : 0;
}

/// Twice the area of a shadow, and what its terms add up to, without their signs.
struct ShadowArea {
  Fraction doubled = 0, sizes = 0;
};
ShadowArea shadow_area(const Face& face, int axis) {
  const auto [u, v] = ear_clipping::plane_of(axis);
  ShadowArea area;
  for (std::size_t k = 2; k < face.size(); ++k) {
    const auto way = [&](std::size_t to, int along) {
      return Fraction(face[to][along]) - Fraction(face[0][along]);
    };
    const Fraction left = way(k - 1, u) * way(k, v), right = way(k - 1, v) * way(k, u);
    area.doubled += left - right;
    area.sizes += abs(left) + abs(right);
  }
  return area;
}

/// How much larger than the chosen shadow another one is, in parts of what rounding may hide; wrong unless
/// the turn is exact and the triangles cover the shadow once.
double space_error(const Input& i) {
  const auto given = corners_in<dvec3>(i);
  if (!given) return 0;
  const Face& face = *given;
  const auto triangles = triangles_of(face);
  if (triangles.has_value() != is_taken(face)) return wrong;
  if (!triangles) return 0;
  const ear_clipping::Shadow shadow = ear_clipping::largest_shadow(face);
  const ShadowArea chosen = shadow_area(face, shadow.axis);
  if (shadow.turn != chosen.doubled.sign()) return wrong;
  double worst = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const ShadowArea other = shadow_area(face, axis);
    const Fraction more = abs(other.doubled) - abs(chosen.doubled);
    if (more <= 0) continue;
    if (shadow.turn == 0) return wrong;
    const Fraction rounding =
        Fraction(static_cast<double>(face.size()) * 0x1p-50) * (other.sizes + chosen.sizes) +
        Fraction(0x1p-999);
    worst = std::max(worst, static_cast<double>(Fraction(more / rounding)));
  }
  return std::max(worst, cover_error(ear_clipping::flattened(face), *triangles));
}

/// The same of the widest ears.
double widest_error(const Input& i) {
  auto polygon = corners_in<dvec2>(i);
  if (!polygon || !is_taken(*polygon)) return 0;
  if (test::exact_area(*polygon) < 0) std::ranges::reverse(*polygon);
  std::vector<Triangle> triangles;
  ear_clipping::widest_ear(*polygon, [&](const Triangle& t) { triangles.push_back(t); });
  return cover_error(*polygon, triangles);
}

// --- Holes: an outline of eight corners, three holes of four

constexpr std::size_t outline_corners = 8, hole_corners = 4, holes = 3,
                      all_corners = outline_corners + holes * hole_corners;

/// A star with holes apart from each other; of ties on whole numbers, and a hole that touches its outline.
Input holes_input(Kind kind, Random& random) {
  Points points;
  const auto add_star = [&](std::size_t corners, dvec2 middle, double least, double most) {
    for (std::size_t k = 0; k < corners; ++k) {
      const double turns = (static_cast<double>(k) + random.uniform(0, 0.5)) / static_cast<double>(corners);
      const SinCos at = sin_cos(0x1.921fb54442d18p2 * turns);
      const dvec2 p = middle + random.uniform(least, most) * dvec2(at.cos, at.sin);
      points.push_back(kind == Kind::ties ? glm::round(4.0 * p) : p);
    }
  };
  add_star(outline_corners, dvec2(0), kind == Kind::near_degenerate ? 7.99 : 5, 8);
  for (std::size_t h = 0; h < holes; ++h) {
    const SinCos at = sin_cos(0x1.921fb54442d18p2 * (static_cast<double>(h) + random.unit()) / 9 * 3);
    add_star(hole_corners, 1.8 * dvec2(at.cos, at.sin), 0.3, 1.4);
  }
  const auto corner = [&](std::size_t n) {
    return static_cast<std::size_t>(random.uniform_int(0, static_cast<std::int64_t>(n) - 1));
  };
  if (kind == Kind::ties || kind == Kind::grazing)
    points[outline_corners + corner(holes * hole_corners)] = points[corner(outline_corners)];
  Input input;
  for (const dvec2 p : points) {
    input.push_back(is_place_of_several(kind) ? p.x : number(kind, random));
    input.push_back(is_place_of_several(kind) ? p.y : number(kind, random));
  }
  if (kind == Kind::refused) input[corner(input.size())] = std::nan("");
  return input;
}

struct Region {
  Points points;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  Faces rings;
};
Region region_in(const Input& i) {
  Region region;
  for (std::size_t k = 0; k < all_corners; ++k) region.points.emplace_back(i[2 * k], i[2 * k + 1]);
  for (std::size_t first = 0; first < all_corners;) {
    const std::size_t count = first == 0 ? outline_corners : hole_corners;
    std::vector<std::int32_t> ring(count);
    std::iota(ring.begin(), ring.end(), static_cast<std::int32_t>(first));
    for (std::size_t k = 0; k < count; ++k) region.edges.emplace_back(first + k, first + (k + 1) % count);
    region.rings.add(ring);
    first += count;
  }
  return region;
}

/// Whether edges meet at most in one corner of two rings, and all holes lie inside; how many touch.
std::optional<int> touching(const Region& r) {
  if (!is_taken(r.points)) return std::nullopt;
  const auto at = [&](std::size_t k) { return r.points[k]; };
  const auto on = [&](std::size_t a, std::size_t b, std::size_t p) {
    return orient2d(at(a), at(b), at(p)) == 0 &&
           at(p) == glm::clamp(at(p), glm::min(at(a), at(b)), glm::max(at(a), at(b)));
  };
  int touching = 0;
  for (std::size_t i = 0; i < all_corners; ++i) {
    for (std::size_t k = 0; k < i; ++k) touching += at(i) == at(k);
  }
  for (const auto& [a, b] : r.edges) {
    for (const auto& [c, d] : r.edges) {
      const auto same = [&](std::size_t p, std::size_t q) { return at(p) == at(q); };
      if (same(a, b) || (a != c && same(a, c) && same(b, d)) || (same(a, d) && same(b, c)))
        return std::nullopt;
      if ((on(a, b, c) && !same(a, c) && !same(b, c)) || (on(a, b, d) && !same(a, d) && !same(b, d)))
        return std::nullopt;
      if (orient2d(at(a), at(b), at(c)) * orient2d(at(a), at(b), at(d)) < 0 &&
          orient2d(at(c), at(d), at(a)) * orient2d(at(c), at(d), at(b)) < 0)
        return std::nullopt;
    }
  }
  if (touching > 1) return std::nullopt;
  for (std::size_t h = 0; h < holes; ++h) {
    // A corner that doesn't touch: rays to the right cross an odd number of the outline's edges, and an even
    // number of each hole's
    std::size_t corner = outline_corners + h * hole_corners;
    if (std::ranges::count(r.points, at(corner)) > 1) ++corner;
    std::array<int, 1 + holes> crossed{};
    for (std::size_t e = 0; e < all_corners; ++e) {
      const auto [a, b] = r.edges[e];
      const std::size_t ring = e < outline_corners ? 0 : 1 + (e - outline_corners) / hole_corners;
      const bool up = at(b).y > at(a).y, spans = (at(a).y > at(corner).y) != (at(b).y > at(corner).y);
      if (ring != h + 1 && spans && (orient2d(at(a), at(b), at(corner)) > 0) == up) ++crossed[ring];
    }
    if (crossed[0] % 2 == 0 ||
        std::ranges::any_of(crossed.begin() + 1, crossed.end(), [](int n) { return n % 2; }))
      return std::nullopt;
  }
  return touching;
}

/// Triangles without one that turns round, whose sides add up to those of the rings, cover the inside once:
/// the sums of turns of areas say the same of their size.
double holes_error(const Input& i) {
  const Region region = region_in(i);
  const bool taken = is_taken(region.points);
  std::vector<Triangle> triangles;
  try {
    ear_clipping::triangulate_with_holes(std::span<const dvec2>(region.points), region.rings,
                                         [&](const Triangle& t) { triangles.push_back(t); });
    if (!taken) return wrong;
  } catch (const ContractViolation&) {
    return taken && touching(region) ? wrong : 0;
  }
  const std::optional<int> touches = touching(region);
  if (!touches) return 0;
  if (std::ssize(triangles) != static_cast<std::ptrdiff_t>(all_corners + 2 * holes) - 2 - 2 * *touches)
    return wrong;
  Fraction sum = 0, whole = 0;
  for (const Triangle& t : triangles) {
    Points three;
    for (const int corner : t) three.push_back(region.points[static_cast<std::size_t>(corner)]);
    const Fraction area = test::exact_area(three);
    if (area < 0) return wrong;
    sum += area;
  }
  for (std::size_t ring = 0; ring < region.rings.size(); ++ring) {
    Points points;
    for (const std::int32_t corner : region.rings[ring])
      points.push_back(region.points[static_cast<std::size_t>(corner)]);
    const Fraction area = abs(test::exact_area(points));
    whole += ring == 0 ? area : Fraction(-area);
  }
  return sum == whole ? 0 : wrong;
}

/// A trap with its number of corners before them.
template <std::size_t axes>
Trap trap(const char* name, Input corners) {
  corners.insert(corners.begin(), static_cast<double>(corners.size() / axes));
  corners.resize(1 + axes * most_corners, 0);
  return {name, corners};
}

template <class Holds>
Share flat_share(const char* of, double least, Holds holds) {
  return {of, least, [holds](const Input& i) {
            const auto polygon = corners_in<dvec2>(i);
            return polygon && is_taken(*polygon) && holds(*polygon);
          }};
}
bool has_reflex_corner(const Points& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec2 next = polygon[(i + 1) % polygon.size()], last = polygon[(i + 2) % polygon.size()];
    if (orient2d(polygon[i], next, last) < 0) return true;
  }
  return false;
}
template <class Holds>
Share shadow_share(const char* of, double least, Holds holds) {
  return {of, least, [holds](const Input& i) {
            const auto face = corners_in<dvec3>(i);
            return face && is_taken(*face) && holds(ear_clipping::largest_shadow(*face));
          }};
}

}  // namespace

Domain ear_clipping() {
  using ear_clipping::Shadow;
  return {
      "ear_clipping",
      {{.name = "triangulate",
        .states = "the triangles of a simple polygon cover it exactly once, two fewer than its corners",
        .unit = "wrong",
        .bound = 0,
        .numbers = 1 + 2 * most_corners,
        .generate = at_every_scale(flat_input, lengths(2)),
        .error = flat_error,
        .traps =
            {trap<2>("corners on a line", {0, 0, 1, 0, 2, 0, 3, 0, 3, 1, 2, 1, 1, 1, 0, 1}),
             trap<2>("a notch to the opposite edge", {0, 0, 4, 0, 8, 0, 8, 8, 5, 8, 4, 0x1p-52, 3, 8, 0, 8}),
             trap<2>("corners at one place", {0, 0, 4, 0, 4, 4, 4, 4, 4, 4, 0, 4, 0, 4, 0, 0}),
             trap<2>("a corner that is no number", {0, 0, 4, 0, 4, 4, std::nan(""), 4, 3, 4, 2, 4, 1, 4}),
             trap<2>("two corners", {0, 0, 1, 0})},
        .shares = {flat_share("simple", 0.5,
                              [](const Points& p) { return !polygon_circle::meeting_edges(p); }),
                   flat_share("a reflex corner", 0.5, has_reflex_corner)}},
       {.name = "widest_ear",
        .states = "the same of the widest ears",
        .unit = "wrong",
        .bound = 0,
        .numbers = 1 + 2 * most_corners,
        .generate = at_every_scale(flat_input, lengths(2)),
        .error = widest_error},
       {.name = "triangulate_with_holes",
        .states =
            "three holes: n + 2h - 2 triangles cover the inside exactly once, two fewer where one touches",
        .unit = "wrong",
        .bound = 0,
        .numbers = 2 * all_corners,
        .generate = at_every_scale(holes_input),
        .error = holes_error,
        .shares = {{"apart", 0.15, [](const Input& i) { return touching(region_in(i)) == 0; }},
                   {"touching", 0.05, [](const Input& i) { return touching(region_in(i)) == 1; }}}},
       {.name = "triangulate_in_space",
        .states = "the same of its largest shadow along an axis, whose turn is exact",
        .unit = "of rounding",
        .bound = 1,
        .numbers = 1 + 3 * most_corners,
        .generate = at_every_scale(space_input, lengths(3)),
        .error = space_error,
        .traps =
            {trap<3>("an arrowhead whose products underflow",
                     {0,        0, 0,        0x1p-549, 0, 0, 0x1p-548, 0, 0, 0x1p-547, 0x1p-548, 0, 0x1p-547,
                      0x1p-547, 0, 0x1p-548, 0x1p-549, 0, 0, 0x1p-547, 0, 0, 0x1p-549, 0}),
             trap<3>("a plane through an axis",
                     {0, 0, 0, 4, 4, 0, 4, 4, 4, 3, 3, 4, 2, 2, 1, 1, 1, 4, 0, 0, 4, 0, 0, 2}),
             trap<3>("a corner that is no number",
                     {std::nan(""), 0, 0, 4, 0, 0, 4, 4, 0, 2, 1, 0, 0, 4, 0, -1, 2, 0, -1, 1, 0, -1, 0, 0})},
        .shares = {shadow_share("along x", 0.1, [](const Shadow& s) { return s.axis == 0; }),
                   shadow_share("along y", 0.1, [](const Shadow& s) { return s.axis == 1; }),
                   shadow_share("along z", 0.1, [](const Shadow& s) { return s.axis == 2; }),
                   shadow_share("turned", 0.1, [](const Shadow& s) { return s.turn < 0; })}}}};
}

}  // namespace gradus::stress
