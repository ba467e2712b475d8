// The promises of the painter: no polygon is drawn before one that it covers, in cycles, through each other,
// as slivers, in one plane and at common corners; and all that is given is drawn.

#include "core/arithmetic/exact_scalar.hpp"

#include "visibility/painter/painter.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "stress/numbers.hpp"
#include "stress/scales.hpp"
#include "stress/visibility/drawing_orders.hpp"

namespace gradus::stress {
namespace {

using namespace painter;

constexpr std::size_t triangles = 4, numbers = 9 * triangles + 4;

template <class T>
glm::vec<3, T> point(const Input& i, std::size_t k) {
  return {T(i[3 * k]), T(i[3 * k + 1]), T(i[3 * k + 2])};
}

/// Corners of triangles, an eye, and whether it is infinitely far away.
Input scene(Kind kind, Random& random) {
  Input input(numbers);
  const double most = kind == Kind::ties ? 2 : 6;
  for (double& x : input) {
    x = random.uniform(-6, 6);
    if (kind == Kind::ties) x = static_cast<double>(random.uniform_int(-2, 2));
  }
  const auto corner = [&](std::size_t k) { return input.begin() + static_cast<std::ptrdiff_t>(3 * k); };
  if (kind == Kind::near_degenerate) {
    // Slivers, and corners a last place beside another one's plane
    for (std::size_t k = 0; k < triangles; ++k) {
      const double s = random.uniform(0, 1);
      for (std::ptrdiff_t j = 0; j < 3; ++j) {
        corner(3 * k + 2)[j] =
            nudged(corner(3 * k)[j] + s * (corner(3 * k + 1)[j] - corner(3 * k)[j]) + 1e-3 * most, random);
      }
    }
  }
  if (kind == Kind::grazing) {
    // Each shares a corner or an edge with the one before
    for (std::size_t k = 1; k < triangles; ++k) {
      const auto shared = static_cast<std::ptrdiff_t>(3 * random.uniform_int(1, 2));
      std::copy_n(corner(3 * k - 3), shared, corner(3 * k));
    }
  }
  input[numbers - 2] = random.uniform(7, 20);
  input[numbers - 1] = static_cast<double>(random.uniform_int(0, 1));
  return input;
}

/// All corners lie in front of the eye.
bool is_scene(const Input& i) {
  const auto within = [](double most) { return [=](double x) { return std::abs(x) <= most; }; };
  const auto eye = i.end() - 4;
  return std::all_of(i.begin(), eye, within(6.25)) && std::all_of(eye, i.end(), within(30)) && eye[2] > 6.5 &&
         (eye[3] == 0 || eye[3] == 1);
}

/// Nothing of what is no scene.
template <class T>
std::optional<std::vector<Polygon<T>>> polygons_of(const Input& i) {
  if (!all_finite(i) || !is_scene(i)) return std::nullopt;
  std::vector<Polygon<T>> polygons;
  for (std::size_t k = 0; k < triangles; ++k) {
    const auto a = point<T>(i, 3 * k), b = point<T>(i, 3 * k + 1), c = point<T>(i, 3 * k + 2);
    if (glm::cross(b - a, c - a) == glm::vec<3, T>(T{0})) return std::nullopt;
    polygons.push_back({{a, b, c}, k});
  }
  return polygons;
}
template <class T>
View<T> view_of(const Input& i) {
  const auto eye = point<T>(i, 3 * triangles);
  const glm::vec<3, T> up{T(0.25), T(1), T(0)};
  if (i[numbers - 1] == 0) return distant_view(eye, up);
  return view_along(Eye<T>(eye, T(1)), glm::vec<3, T>{T(0), T(0), T(-1)}, up);
}

/// Where the ray from `from` along `way` meets a triangle's or a part's inside.
std::optional<Exact> hit(const Polygon<Exact>& polygon, const ExactVec3& from, const ExactVec3& way) {
  const auto &a = polygon.plane.a, &b = polygon.plane.b, &c = polygon.plane.c;
  const ExactVec3 normal = glm::cross(b - a, c - a);
  const Exact along = glm::dot(normal, way);
  if (along == Exact{0}) return std::nullopt;
  const Exact t = glm::dot(normal, a - from) / along;
  const ExactVec3 at = from + t * way;
  const auto& p = polygon.corners;
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (sign(glm::dot(normal, glm::cross(p[(k + 1) % p.size()] - p[k], at - p[k]))) <= 0) return std::nullopt;
  }
  return t;
}

/// Where a ray meets a part's inside, apart from its border.
std::optional<double> hit(const Polygon<double>& polygon, dvec3 from, dvec3 way) {
  const auto &a = polygon.plane.a, &b = polygon.plane.b, &c = polygon.plane.c;
  const dvec3 normal = glm::cross(b - a, c - a);
  const double along = glm::dot(normal, way), size = glm::length(normal);
  if (!(std::abs(along) > 1e-6 * size)) return std::nullopt;
  const double t = glm::dot(normal, a - from) / along;
  const dvec3 at = from + t * way;
  const auto& p = polygon.corners;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const dvec3 edge = p[(k + 1) % p.size()] - p[k];
    if (!(glm::dot(normal, glm::cross(edge, at - p[k])) > 1e-6 * size)) return std::nullopt;
  }
  return t;
}

constexpr auto hits = [](const auto& polygon, const auto& from, const auto& way) {
  return hit(polygon, from, way);
};

double order_error(const Input& i) {
  const ExactScope scope;
  const auto polygons = polygons_of<Exact>(i);
  if (!polygons) return 0;
  const View<Exact> view = view_of<Exact>(i);
  Parts<Exact> order;
  newell(*polygons, view, into(order));
  return covers_none(order, view.eye, Exact(0), hits) ? 0 : wrong;
}

/// In double, where cut corners are rounded; and the same when it is watched.
double rounded_error(const Input& i) {
  const auto polygons = polygons_of<double>(i);
  if (!polygons) return 0;
  const View<double> view = view_of<double>(i);
  Parts<double> order, watched, told;
  newell(*polygons, view, into(order));
  newell(*polygons, view, into(watched), as_told<Drawn<double>>(told));
  const bool same = are_same(order, watched) && are_same(order, told);
  return same && covers_none(order, view.eye, 1e-6, hits) ? 0 : wrong;
}

/// In double the parts of each polygon have its whole area, but for the rounding of cut corners.
double area_error(const Input& i) {
  const auto polygons = polygons_of<double>(i);
  if (!polygons) return 0;
  std::array<dvec3, triangles> areas{};
  const auto add = [&](const Polygon<double>& part, double sign) {
    const auto& p = part.corners;
    for (std::size_t k = 1; k + 1 < p.size(); ++k)
      areas[part.face] += sign * glm::cross(p[k] - p[0], p[k + 1] - p[0]);
  };
  newell(*polygons, view_of<double>(i), [&](const auto& part) { add(part, 1); });
  for (const auto& polygon : *polygons) add(polygon, -1);
  for (const dvec3 area : areas) {
    if (glm::length(area) > 1e-9) return wrong;
  }
  return 0;
}

/// An eye at (0, 0, 20), or infinitely far along z.
Input seen(std::initializer_list<double> corners, bool distant) {
  Input input(corners);
  input.insert(input.end(), {0, 0, 20, distant ? 0.0 : 1.0});
  return input;
}

const std::vector<Trap> traps{
    {"a cycle that only rounding closes", {1,  -2, 0, 2,  -2, -1, 2, -1, 2,  -2, -2, 0,  2,
                                           2,  1,  2, -1, -1, 2,  2, 2,  -1, -2, 1,  2,  1,
                                           -2, 2,  0, 0,  -2, 1,  0, 0,  -2, 1,  -1, -1, 0x1.f62f3787860b5p+2,
                                           0}},
    {"three triangles, each over the next, and one behind",
     seen({-6, -4, -1, 6,  -4, 1, 6,  -2, 1, 6,  -4, -1, 0, 6,  1,  -2, 6, 1,
           0,  6,  -1, -6, -4, 1, -4, -5, 1, -6, -6, -3, 6, -6, -3, 0,  6, -3},
          false)},
    {"two that pierce each other, and both twice",
     seen({-3, -3, 0, 3, -3, 0, 0, 3, 0, -3, 0, -2, 3, 0, -2, 0, 0, 3,
           -3, -3, 0, 3, -3, 0, 0, 3, 0, -3, 0, -2, 3, 0, -2, 0, 0, 3},
          true)},
    {"four in one plane", seen({-3, -3, 0, 3, -3, 0, 0, 3, 0, -2, -2, 0, 2, -2, 0, 0, 2, 0,
                                -1, -1, 0, 1, -1, 0, 0, 1, 0, -6, -6, 0, 6, -6, 0, 0, 6, 0},
                               true)},
    {"four round a common edge", seen({0, -3, 0, 0, 3, 0, 3, 0, 1,  0, -3, 0, 0, 3, 0, -3, 0, 1,
                                       0, -3, 0, 0, 3, 0, 3, 0, -1, 0, -3, 0, 0, 3, 0, -3, 0, -1},
                                      false)},
    {"slivers through one place",
     seen({-6, 0,  -1, 6, 0, 1,   6, 1e-9,     1,   0,  -6, 1, 0, 6,  -1,   1e-9,     6,  -1,
           -5, -5, 0,  5, 5, 0.5, 5, 5 + 1e-9, 0.5, -5, 5,  0, 5, -5, -0.5, 5 + 1e-9, -5, -0.5},
          true)},
    {"one edge-on before the others", seen({0,  -3, 5,  0, 3,  5,  0, 0, 1,  -3, -3, 0, 3, -3, 0, 0, 3, 0,
                                            -3, -3, -1, 3, -3, -1, 0, 3, -1, 1,  1,  1, 2, 1,  1, 1, 2, 1},
                                           true)}};

}  // namespace

Domain painter() {
  const auto promise = [](std::string name, std::string states, const auto& error, std::int64_t cases) {
    return Property{.name = std::move(name),
                    .states = std::move(states),
                    .unit = "decisions",
                    .bound = 0,
                    .numbers = numbers,
                    .kinds = {Kind::random, Kind::ties, Kind::near_degenerate, Kind::grazing},
                    .generate = scene,
                    .error = error,
                    .traps = traps,
                    .cases = cases};
  };
  return {"painter",
          {promise("newell", "no polygon is drawn before one that it covers, judged along exact rays",
                   order_error, 250),
           promise("rounded", "the same in double, where cut corners are rounded, but for a millionth",
                   rounded_error, 2'000),
           promise("whole", "the parts of each polygon are the whole of it", area_error, 2'000)}};
}

}  // namespace gradus::stress
