// The promises of BSP trees: cuts are the nearest doubles, and no polygon is drawn before what it covers.

#include "core/arithmetic/exact_scalar.hpp"

#include "visibility/bsp_tree/bsp_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "stress/numbers.hpp"
#include "stress/scales.hpp"
#include "stress/visibility/drawing_orders.hpp"

namespace gradus::stress {
namespace {

using namespace bsp_tree;

template <class T>
glm::vec<3, T> point(const Input& i, std::size_t k) {
  return {T(i[3 * k]), T(i[3 * k + 1]), T(i[3 * k + 2])};
}

/// By the first three points.
template <class T>
Plane<T> plane_of(const Input& i) {
  return {point<T>(i, 0), point<T>(i, 1), point<T>(i, 2)};
}

// --- Where planes cut

/// Three points of a plane and the two ends of an edge.
Input edge_and_plane(Kind kind, Random& random) {
  Input input(15);
  for (double& x : input) x = number(kind, random);
  if (kind == Kind::near_degenerate || kind == Kind::grazing) {
    // Both ends close to the plane, on its two sides or not
    for (const std::size_t end : {std::size_t{3}, std::size_t{4}}) {
      const double s = random.uniform(-2, 2), t = random.uniform(-2, 2);
      for (std::size_t k = 0; k < 3; ++k) {
        input[3 * end + k] =
            nudged(input[k] + s * (input[3 + k] - input[k]) + t * (input[6 + k] - input[k]), random);
      }
    }
  }
  return input;
}

/// Whether the ends of the edge lie on both sides.
bool is_cut(const Input& i) {
  if (!all_finite(i)) return false;
  const auto side = [&](std::size_t k) { return ExactSide{}(plane_of<double>(i), point<double>(i, k)); };
  return side(3) * side(4) < 0;
}

double crossing_error(const Input& i) {
  if (!is_cut(i)) return 0;
  const dvec3 at = crossing(plane_of<double>(i), point<double>(i, 3), point<double>(i, 4));
  const ExactScope scope;
  const ExactVec3 right = crossing(plane_of<Exact>(i), point<Exact>(i, 3), point<Exact>(i, 4));
  for (int k = 0; k < 3; ++k) {
    if (at[k] != to_double(right[k])) return wrong;
  }
  return 0;
}

// --- Parts

/// A plane and a triangle, of any size that areas can have.
Input triangle_and_plane(Kind kind, Random& random) {
  Input input(18);
  for (double& x : input) {
    x = random.uniform(-6, 6);
    if (kind == Kind::ties) x = std::floor(x);
  }
  const auto in_plane = [&](std::size_t k) {
    const double s = random.uniform(-2, 2), t = random.uniform(-2, 2);
    return input[k] + s * (input[3 + k] - input[k]) + t * (input[6 + k] - input[k]);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    // A corner, or all of them, as near to the plane as doubles come
    if (kind == Kind::grazing) input[9 + k] = in_plane(k);
    if (kind != Kind::near_degenerate) continue;
    for (std::size_t corner = 3; corner < 6; ++corner) input[3 * corner + k] = nudged(in_plane(k), random);
  }
  const double scale = std::ldexp(1.0, static_cast<int>(random.uniform_int(-200, 200)));
  for (double& x : input) x *= scale;
  return input;
}

/// The doubled area of a polygon as a vector.
ExactVec3 area_of(const std::vector<ExactVec3>& p) {
  ExactVec3 sum{Exact(0), Exact(0), Exact(0)};
  for (std::size_t i = 1; i + 1 < p.size(); ++i) sum += glm::cross(p[i] - p[0], p[i + 1] - p[0]);
  return sum;
}
std::vector<ExactVec3> exactly(const std::vector<dvec3>& points) {
  std::vector<ExactVec3> exact;
  for (const dvec3 p : points) exact.push_back({Exact(p.x), Exact(p.y), Exact(p.z)});
  return exact;
}
double length_of(const ExactVec3& v) { return std::sqrt(to_double(glm::dot(v, v))); }

/// Whether rational parts are the whole, each on its side.
bool exact_parts(const Plane<Exact>& plane, const Polygon<Exact>& whole, std::span<const int> on) {
  const auto [front, back] = split(plane, whole, on);
  const ExactVec3 normal = glm::cross(plane.b - plane.a, plane.c - plane.a);
  const auto height = [&](const ExactVec3& p) { return glm::dot(normal, p - plane.a); };
  return area_of(front.corners) + area_of(back.corners) == area_of(whole.corners) &&
         std::ranges::all_of(front.corners, [&](const auto& p) { return height(p) >= Exact(0); }) &&
         std::ranges::all_of(back.corners, [&](const auto& p) { return height(p) <= Exact(0); });
}

/// How far the parts' corners lie on the wrong side of the plane, and how far the parts' area is off as the
/// breadth of a strip along the longest edge; in units of the last place of the largest coordinate.
double split_error(const Input& i) {
  if (!std::ranges::all_of(i, [](double x) { return x == 0 || (std::abs(x) > 1e-75 && std::abs(x) < 1e75); }))
    return 0;
  const dvec3 p = point<double>(i, 3), q = point<double>(i, 4), r = point<double>(i, 5);
  if (glm::cross(q - p, r - p) == dvec3(0)) return 0;
  const Plane<double> plane = plane_of<double>(i);
  const Polygon<double> whole({p, q, r});
  const auto on = sides(plane, whole, ExactSide{});
  if (side_of(on) != Side::both) return 0;
  const auto [front, back] = split(plane, whole, on);

  const ExactScope scope;
  const Plane<Exact> same = plane_of<Exact>(i);
  if (!exact_parts(same, Polygon<Exact>(exactly(whole.corners)), on)) return wrong;
  double largest = 0;
  for (std::size_t k = 9; k < 18; ++k) largest = std::max(largest, std::abs(i[k]));
  const double unit = std::nextafter(largest, wrong) - largest;
  const ExactVec3 normal = glm::cross(same.b - same.a, same.c - same.a);
  double error = 0;
  const auto look = [&](const Polygon<double>& part, double side) {
    for (const ExactVec3& at : exactly(part.corners))
      error = std::max(error, -side * to_double(glm::dot(normal, at - same.a)) / length_of(normal) / unit);
  };
  look(front, 1);
  look(back, -1);
  const ExactVec3 lost =
      area_of(exactly(front.corners)) + area_of(exactly(back.corners)) - area_of(exactly(whole.corners));
  const double edge = std::max({glm::length(q - p), glm::length(r - q), glm::length(p - r)});
  return std::max(error, length_of(lost) / 2 / edge / unit);
}

// --- The order

constexpr std::size_t triangles = 4;

/// Corners of triangles, then an eye.
Input scene(Kind kind, Random& random) {
  Input input(9 * triangles + 3);
  for (double& x : input) {
    x = random.uniform(-6, 6);
    if (kind == Kind::ties) x = std::floor(x);
  }
  input.back() = random.uniform(7, 20);
  return input;
}

/// Where the ray meets a convex polygon's inside, apart from its border.
std::optional<double> hit(const Polygon<double>& polygon, dvec3 eye, dvec3 way) {
  const auto& p = polygon.corners;
  const dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double along = glm::dot(normal, way);
  if (std::abs(along) < 1e-9) return std::nullopt;
  const double t = glm::dot(normal, p[0] - eye) / along;
  const dvec3 at = eye + t * way;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const dvec3 edge = p[(k + 1) % p.size()] - p[k];
    if (glm::dot(normal, glm::cross(edge, at - p[k])) <= 1e-6 * glm::dot(normal, normal)) return std::nullopt;
  }
  return t;
}

bool is_scene(const Input& i) {
  return std::ranges::all_of(i, [](double x) { return std::abs(x) <= 30; }) && i.back() > 6;
}

/// Along rays no later polygon may be farther than an earlier one; watched, the order is the same.
double order_error(const Input& i) {
  if (!is_scene(i)) return 0;
  std::vector<Polygon<double>> polygons;
  for (std::size_t k = 0; k < triangles; ++k) {
    const dvec3 a = point<double>(i, 3 * k), b = point<double>(i, 3 * k + 1), c = point<double>(i, 3 * k + 2);
    if (glm::length(glm::cross(b - a, c - a)) < 1e-3) return 0;
    polygons.push_back({{a, b, c}, k});
  }
  const Eye<double> eye(point<double>(i, 3 * triangles), 1);
  Parts<double> order, watched, told;
  back_to_front(build(polygons), eye, into(order));
  back_to_front(build(polygons, ExactSide{}, [](const auto&) {}), eye, into(watched),
                as_told<Drawn<double>>(told));
  const auto hits = [](const Polygon<double>& polygon, dvec3 from, dvec3 way) {
    const auto t = hit(polygon, from, way);
    return t && *t > 0 ? t : std::nullopt;
  };
  const bool same = are_same(order, watched) && are_same(order, told);
  return same && covers_none(order, eye, 1e-9, hits) ? 0 : wrong;
}

}  // namespace

Domain bsp_tree() {
  return {
      "bsp_tree",
      {{.name = "crossing",
        .states = "where a plane cuts an edge: the nearest double in each coordinate",
        .unit = "decisions",
        .bound = 0,
        .numbers = 15,
        .generate = at_every_scale(edge_and_plane),
        .error = crossing_error,
        .traps = {{"a plane of subnormal size",
                   {0, 0, 0, 5e-324, 0, 0, 0, 5e-324, 0, 1, 2, -1, 3, 4, 1e-300}},
                  {"an edge from one end of the range to the other",
                   {0, 0, 1, 1, 0, 1, 0, 1, 1, -1e308, 0, -1e308, 1e308, 0, 1e308}},
                  {"an end a last place beside the plane",
                   {0, 0, 1, 1, 0, 1, 0, 1, 1, 3, 4, 1 + 0x1p-52, 5, 6, 0}}},
        .shares = {{"the plane cuts the edge", 0.1, is_cut}}},
       {.name = "split",
        .states =
            "the parts have the whole's area and lie on their sides: exactly in rationals, rounded once "
            "in doubles",
        .unit = "ulp of the largest coordinate",
        .bound = 0.87,
        .numbers = 18,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::ties},
        .generate = triangle_and_plane,
        .error = split_error,
        .traps = {{"the plane runs through a corner",
                   {0, 0, 0, 1, 0, 0, 0, 1, 0, 3, 3, 0, 5, 3, 2, 3, 5, -2}},
                  {"the plane leaves a corner a last place wide",
                   {0, 0, 1, 1, 0, 1, 0, 1, 1, 3, 3, 1 + 0x1p-52, 5, 3, 0, 3, 5, 0}},
                  {"a needle across the plane",
                   {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1, 1, 1, -1, 1 + 0x1p-40, 1, 0.5}}},
        .shares = {{"the plane cuts the triangle", 0.3,
                    [](const Input& i) {
                      const Plane<double> plane = plane_of<double>(i);
                      const std::array on{ExactSide{}(plane, point<double>(i, 3)),
                                          ExactSide{}(plane, point<double>(i, 4)),
                                          ExactSide{}(plane, point<double>(i, 5))};
                      return side_of(on) == Side::both;
                    }}}},
       {.name = "back_to_front",
        .states = "no polygon is drawn before one that it covers, whether they pierce or overlap in a cycle",
        .unit = "decisions",
        .bound = 0,
        .numbers = 9 * triangles + 3,
        .kinds = {Kind::random, Kind::ties},
        .generate = scene,
        .error = order_error,
        .traps = {{"three bars' first triangles, each over the next, and one behind",
                   {-6, -4, -1, 6, -4, 1,  6, -2, 1,  6,  -4, -1, 0,  6, 1, -2, 6, 1, 0, 6,
                    -1, -6, -4, 1, -4, -5, 1, -6, -6, -3, 6,  -6, -3, 0, 6, -3, 0, 0, 20}}}}}};
}

}  // namespace gradus::stress
