// The promises of cutting polygons into triangles, in the plane and in space.

#include "modeling/ear_clipping/ear_clipping.hpp"

#include <algorithm>
#include <array>

#include "clipping/polygon_circle/crossings.hpp"
#include "core/contract.hpp"
#include "core/elementary.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"
#include "support/polygon_areas.hpp"

namespace gradus::stress {
namespace {

using ear_clipping::Triangle;
using test::Rational;
using Points = std::vector<dvec2>;
using Face = std::vector<dvec3>;

// --- Inputs: polygons of eight corners ---

constexpr std::size_t corners = 8;

/// Corners round a middle, near and far in turns, some of them on the line of their neighbours: mostly
/// simple.
Points star(Kind kind, Random& random) {
  Points points;
  for (std::size_t i = 0; i < corners; ++i) {
    const double turns = (static_cast<double>(i) + random.uniform(0, 0.9)) / corners;
    const SinCos at = sin_cos(0x1.921fb54442d18p2 * turns);
    const double distance = kind == Kind::near_degenerate
                                ? std::ldexp(8, -static_cast<int>(random.uniform_int(0, 40)))
                                : random.uniform(0.5, 8);
    dvec2 p = distance * dvec2(at.cos, at.sin);
    if (kind == Kind::ties) p = {std::round(p.x), std::round(p.y)};
    points.push_back(p);
  }
  for (std::size_t i = 1; i + 1 < corners && kind == Kind::grazing; i += 2) {
    // On the line of its neighbours, but for the last places
    const dvec2 on = points[i - 1] + random.unit() * (points[i + 1] - points[i - 1]);
    if (random.unit() < 0.6) points[i] = {nudged(on.x, random), nudged(on.y, random)};
  }
  return points;
}
void refuse(Kind kind, Input& input, Random& random) {
  if (kind != Kind::refused) return;
  const auto at = random.uniform_int(0, static_cast<std::int64_t>(input.size()) - 1);
  input[static_cast<std::size_t>(at)] = random.unit() < 0.5 ? std::nan("") : wrong;
}
bool is_place_of_several(Kind kind) {
  return kind == Kind::random || kind == Kind::near_degenerate || kind == Kind::grazing ||
         kind == Kind::ties || kind == Kind::refused;
}

Input flat_input(Kind kind, Random& random) {
  Input input;
  const dvec2 middle =
      random.unit() < 0.5 ? dvec2(0) : dvec2(random.uniform(-16, 16), random.uniform(-16, 16));
  for (const dvec2 p : star(kind, random)) {
    const bool shaped = is_place_of_several(kind);
    input.push_back(shaped ? middle.x + p.x : number(kind, random));
    input.push_back(shaped ? middle.y + p.y : number(kind, random));
  }
  refuse(kind, input, random);
  return input;
}

/// The same on a plane in space, as flat as rounding leaves it.
Input space_input(Kind kind, Random& random) {
  const auto any = [&] {
    const double x = random.uniform(-2, 2), y = random.uniform(-2, 2), z = random.uniform(-2, 2);
    return dvec3(random.unit() < 0.3 ? 0 : x, random.unit() < 0.3 ? 0 : y, random.unit() < 0.3 ? 0 : z);
  };
  const dvec3 origin = any(), u = any(), v = any();
  Input input;
  for (const dvec2 p : star(kind, random)) {
    const dvec3 at = origin + p.x * u + p.y * v;
    for (int axis = 0; axis < 3; ++axis)
      input.push_back(is_place_of_several(kind) ? at[axis] : number(kind, random));
  }
  refuse(kind, input, random);
  return input;
}

Points flat_in(const Input& i) {
  Points points;
  for (std::size_t k = 0; k < corners; ++k) points.emplace_back(i[2 * k], i[2 * k + 1]);
  return points;
}
Face face_in(const Input& i) {
  Face face;
  for (std::size_t k = 0; k < corners; ++k) face.emplace_back(i[3 * k], i[3 * k + 1], i[3 * k + 2]);
  return face;
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
  Rational sum = 0;
  bool turned_round = false;
  for (const Triangle& t : triangles) {
    Points three;
    for (const int corner : t) three.push_back(polygon[static_cast<std::size_t>(corner)]);
    const Rational area = test::exact_area(three);
    turned_round = turned_round || area < 0;
    sum += area;
  }
  // Areas that are none below 0 and add up cover once
  const Rational whole = test::exact_area(polygon);
  if (sum != whole) return wrong;
  if (whole <= 0 || polygon_circle::meeting_edges(polygon)) return 0;
  return turned_round ? wrong : 0;
}

double flat_error(const Input& i) {
  Points polygon = flat_in(i);
  if (all_finite(i) && test::exact_area(polygon) < 0) std::ranges::reverse(polygon);
  const auto triangles = triangles_of(polygon);
  if (triangles.has_value() != all_finite(i)) return wrong;
  return triangles ? cover_error(polygon, *triangles) : 0;
}

/// Twice the area of a shadow, and what its terms add up to, without their signs.
struct ShadowArea {
  Rational doubled = 0, sizes = 0;
};
ShadowArea shadow_area(const Face& face, int axis) {
  const auto [u, v] = ear_clipping::plane_of(axis);
  ShadowArea area;
  for (std::size_t k = 2; k < face.size(); ++k) {
    const auto way = [&](std::size_t to, int along) {
      return Rational(face[to][along]) - Rational(face[0][along]);
    };
    const Rational left = way(k - 1, u) * way(k, v), right = way(k - 1, v) * way(k, u);
    area.doubled += left - right;
    area.sizes += abs(left) + abs(right);
  }
  return area;
}

/// How much larger than the chosen shadow another one is, in parts of what rounding may hide; wrong unless
/// the turn is exact and the triangles cover the shadow once.
double space_error(const Input& i) {
  const Face face = face_in(i);
  const auto triangles = triangles_of(face);
  if (triangles.has_value() != all_finite(i)) return wrong;
  if (!triangles) return 0;
  const ear_clipping::Shadow shadow = ear_clipping::largest_shadow(face);
  const ShadowArea chosen = shadow_area(face, shadow.axis);
  if (shadow.turn != chosen.doubled.sign()) return wrong;
  double worst = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const ShadowArea other = shadow_area(face, axis);
    const Rational more = abs(other.doubled) - abs(chosen.doubled);
    if (more <= 0) continue;
    if (shadow.turn == 0) return wrong;
    const Rational rounding = Rational(corners * 0x1p-50) * (other.sizes + chosen.sizes) + Rational(0x1p-999);
    worst = std::max(worst, static_cast<double>(Rational(more / rounding)));
  }
  return std::max(worst, cover_error(ear_clipping::flattened(face), *triangles));
}

}  // namespace

Domain ear_clipping() {
  return {
      "ear_clipping",
      {{.name = "triangulate",
        .states = "the triangles of a simple polygon cover it exactly once, two fewer than its corners",
        .unit = "wrong",
        .bound = 0,
        .numbers = 2 * corners,
        .generate = at_every_scale(flat_input),
        .error = flat_error,
        .traps = {{"corners on a line", {0, 0, 1, 0, 2, 0, 3, 0, 3, 1, 2, 1, 1, 1, 0, 1}},
                  {"a notch to the opposite edge", {0, 0, 4, 0, 8, 0, 8, 8, 5, 8, 4, 0x1p-52, 3, 8, 0, 8}},
                  {"corners at one place", {0, 0, 4, 0, 4, 4, 4, 4, 4, 4, 0, 4, 0, 4, 0, 0}},
                  {"a corner that is no number",
                   {0, 0, 4, 0, 4, 4, std::nan(""), 4, 3, 4, 2, 4, 1, 4, 0, 4}}}},
       {.name = "triangulate_in_space",
        .states = "the same of its largest shadow along an axis, whose turn is exact",
        .unit = "of rounding",
        .bound = 1,
        .numbers = 3 * corners,
        .generate = at_every_scale(space_input),
        .error = space_error,
        .traps = {{"an arrowhead whose products underflow",
                   {0,        0, 0,        0x1p-549, 0, 0, 0x1p-548, 0, 0, 0x1p-547, 0x1p-548, 0, 0x1p-547,
                    0x1p-547, 0, 0x1p-548, 0x1p-549, 0, 0, 0x1p-547, 0, 0, 0x1p-549, 0}},
                  {"a plane through an axis",
                   {0, 0, 0, 4, 4, 0, 4, 4, 4, 3, 3, 4, 2, 2, 1, 1, 1, 4, 0, 0, 4, 0, 0, 2}},
                  {"a corner that is no number", {std::nan(""), 0, 0, 4,  0, 0, 4,  4, 0, 2, 1, 0, 0, 4, 0,
                                                  -1,           2, 0, -1, 1, 0, -1, 0, 0}}}}}};
}

}  // namespace gradus::stress
