#pragma once
// The solids that leaves of a CSG tree are: on which side of their surface a point lies, exactly, and where a
// ray is inside.
//
// One rule for points on a surface, in all that is done here: such a point belongs to the solid if a point a
// little further along x is inside - or, where that runs in the surface, along y, or along z. So of two
// solids that touch in a face each of its points belongs to one, and what a Boolean operation leaves has no
// skin and no crack: it is regularized.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "core/arithmetic/exact.hpp"
#include "core/arithmetic/finite.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"

namespace gradus::csg_tree {

template <class T>
using Point = glm::vec<3, T>;

/// All points x with normal · (x - on) < 0, and its surface by the rule above.
template <class T>
struct HalfSpace {
  Point<T> normal, on;
};
template <class T>
using Box = AxisBox<3, T>;
template <class T>
struct Ball {
  Point<T> centre;
  T radius;
};
/// Endless in the direction of an axis (0: x, 1: y, 2: z), as a drill's hole is. One with ends is what it and
/// a box have in common.
template <class T>
struct Cylinder {
  Point<T> centre;
  T radius;
  int axis;
};
template <class T>
using Solid = std::variant<HalfSpace<T>, Box<T>, Ball<T>, Cylinder<T>>;

/// What is known of a point: -1 inside, 0 on the surface, +1 outside, and whether it counts as inside.
struct Placed {
  int side;
  bool in;
};

// --- Exact signs

template <class T>
int sign_of(const T& x) {
  return x > T(0) ? 1 : x < T(0) ? -1 : 0;
}

/// The sign of a sum whose terms and their rounding are known, if it can be told: each is off by less than 4
/// u.
template <std::floating_point T>
std::optional<int> sure_sign(T sum, T size) {
  using Limits = std::numeric_limits<T>;
  const T bound = 8 * Limits::epsilon() * size + Limits::min() / Limits::epsilon();
  if (std::abs(sum) > bound) return sum > 0 ? 1 : -1;
  return std::nullopt;
}

/// normal · (x - on) as it is computed, with what its terms are together.
template <class T>
struct Height {
  T sum{0}, size{0};

  Height(const Point<T>& normal, const Point<T>& x, const Point<T>& on) {
    for (int i = 0; i < 3; ++i) {
      const T term = normal[i] * (x[i] - on[i]);
      sum = sum + term;
      size = size + (term < T(0) ? -term : term);
    }
  }
};
/// The same without rounding.
inline SumOfProducts<2> exact_height(dvec3 normal, dvec3 x, dvec3 on) {
  SumOfProducts<2> sum;
  for (int i = 0; i < 3; ++i) {
    sum.add(normal[i], x[i]);
    sum.subtract(normal[i], on[i]);
  }
  return sum;
}
template <class T>
int side_of_plane(const Point<T>& normal, const Point<T>& x, const Point<T>& on) {
  const Height<T> height(normal, x, on);
  if constexpr (std::floating_point<T>) {
    const std::optional<int> sure = sure_sign(height.sum, height.size);
    return sure ? *sure : exact_height(normal, x, on).sign();
  } else {
    return sign_of(height.sum);
  }
}

/// The side of a round surface: of all axes but `along` the squares count.
template <class T>
int side_of_round(const Point<T>& x, const Point<T>& centre, const T& radius, int along) {
  T sum = -radius * radius, size = radius * radius;
  for (int i = 0; i < 3; ++i) {
    const T off = i == along ? T(0) : x[i] - centre[i];
    sum = sum + off * off;
    size = size + off * off;
  }
  if constexpr (std::floating_point<T>) {
    if (const std::optional<int> sure = sure_sign(sum, size)) return *sure;
    SumOfProducts<2> exact;
    exact.subtract(double{radius}, double{radius});
    for (int i = 0; i < 3; ++i) {
      if (i == along) continue;
      const double a = x[i], c = centre[i];
      exact.add(a, a);
      exact.add(c, c);
      exact.subtract(a, c);
      exact.subtract(a, c);
    }
    return exact.sign();
  } else {
    return sign_of(sum);
  }
}

/// The sign of the first component that is not 0.
template <class T>
int first_sign(const Point<T>& v) {
  for (int i = 0; i < 3; ++i) {
    if (v[i] != T(0)) return sign_of(v[i]);
  }
  return 0;
}

// --- Points

template <class T>
Placed placed(const HalfSpace<T>& h, const Point<T>& x) {
  const int side = side_of_plane(h.normal, x, h.on);
  return {side, side < 0 || (side == 0 && first_sign(h.normal) < 0)};
}
template <class T>
Placed placed(const Box<T>& box, const Point<T>& x) {
  bool in = true, inner = true, outer = false;
  for (int i = 0; i < 3; ++i) {
    in = in && box.lower[i] <= x[i] && x[i] < box.upper[i];
    inner = inner && box.lower[i] < x[i] && x[i] < box.upper[i];
    outer = outer || x[i] < box.lower[i] || box.upper[i] < x[i];
  }
  return {inner ? -1 : outer ? 1 : 0, in};
}
/// Along the axis, if there is one, nothing changes.
template <class T>
Placed placed_in_round(const Point<T>& x, Point<T> centre, const T& radius, int along) {
  const int side = side_of_round(x, centre, radius, along);
  if (0 <= along) centre[along] = x[along];
  // Larger coordinates than the centre's lead outwards
  int outwards = 0;
  for (int i = 2; i >= 0; --i) {
    if (x[i] != centre[i]) outwards = x[i] < centre[i] ? -1 : 1;
  }
  return {side, side < 0 || (side == 0 && outwards < 0)};
}
template <class T>
Placed placed(const Ball<T>& ball, const Point<T>& x) {
  return placed_in_round(x, ball.centre, ball.radius, -1);
}
template <class T>
Placed placed(const Cylinder<T>& c, const Point<T>& x) {
  return placed_in_round(x, c.centre, c.radius, c.axis);
}
template <class T>
Placed placed(const Solid<T>& solid, const Point<T>& x) {
  return std::visit([&](const auto& its) { return placed(its, x); }, solid);
}

// --- Rays

/// The points from + t way for t from 0 to last.
template <class T>
struct Ray {
  Point<T> from, way;
  T last;
};

/// Where a ray goes in and out, in ascending order, each t once: intervals from the first to the second, from
/// the third to the fourth, and so on.
template <class T>
using Ends = std::vector<T>;

template <class T>
Ends<T> within(const Ray<T>& ray, T first, T last) {
  first = std::max(first, T(0));
  last = std::min(last, ray.last);
  return first < last ? Ends<T>{first, last} : Ends<T>{};
}
template <class T>
Ends<T> all_or_nothing(const Ray<T>& ray, bool all) {
  return all ? Ends<T>{T(0), ray.last} : Ends<T>{};
}

/// Where the ray is inside, by one division; by an exact one where rounding could hide which way it goes.
template <std::floating_point T>
Ends<T> ends_in(const HalfSpace<T>& h, const Ray<T>& ray) {
  const Point<T> origin(0);
  const int slope = side_of_plane(h.normal, ray.way, origin);
  if (slope == 0) return all_or_nothing(ray, placed(h, ray.from).in);
  const Height<T> way(h.normal, ray.way, origin), height(h.normal, h.on, ray.from);
  T t = height.sum / way.sum;
  if (!sure_sign(way.sum, way.size) || !all_finite(height.sum))
    t = static_cast<T>(
        rounded_quotient(exact_height(h.normal, h.on, ray.from), exact_height(h.normal, ray.way, origin)));
  return slope > 0 ? within(ray, T(0), t) : within(ray, t, ray.last);
}
/// Between each two of its planes, by two divisions per axis.
template <std::floating_point T>
Ends<T> ends_in(const Box<T>& box, const Ray<T>& ray) {
  T first(0), last = ray.last;
  for (int i = 0; i < 3; ++i) {
    const T from = ray.from[i], way = ray.way[i];
    if (way == 0 && !(box.lower[i] <= from && from < box.upper[i])) return {};
    if (way == 0) continue;
    const T a = (box.lower[i] - from) / way, b = (box.upper[i] - from) / way;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return within(ray, first, last);
}
/// Half a chord to both sides of the foot of the perpendicular from the centre. Powers of two come out of all
/// lengths before they are squared.
template <std::floating_point T>
Ends<T> ends_in_round(Point<T> from_centre, Point<T> way, T radius, const Ray<T>& ray) {
  if (radius == 0) return {};
  const Scaled<T> d(way);
  const int e = std::max(Scaled<T>(from_centre).exponent, std::ilogb(radius));
  const T r = std::scalbn(radius, -e), square = glm::dot(d.vector, d.vector);
  for (int i = 0; i < 3; ++i) from_centre[i] = std::scalbn(from_centre[i], -e);
  const T foot = -glm::dot(from_centre, d.vector) / square;
  const Point<T> across = from_centre + foot * d.vector;
  const T rest = r * r - glm::dot(across, across);
  if (rest <= 0) return {};
  const T half = std::sqrt(rest / square);
  return within(ray, std::scalbn(foot - half, e - d.exponent), std::scalbn(foot + half, e - d.exponent));
}
template <std::floating_point T>
Ends<T> ends_in(const Ball<T>& ball, const Ray<T>& ray) {
  return ends_in_round(ray.from - ball.centre, ray.way, ball.radius, ray);
}
template <std::floating_point T>
Ends<T> ends_in(const Cylinder<T>& c, const Ray<T>& ray) {
  Point<T> off = ray.from - c.centre, way = ray.way;
  off[c.axis] = way[c.axis] = 0;
  if (way == Point<T>(0)) return all_or_nothing(ray, placed(c, ray.from).in);
  return ends_in_round(off, way, c.radius, ray);
}
template <std::floating_point T>
Ends<T> ends_in(const Solid<T>& solid, const Ray<T>& ray) {
  return std::visit([&](const auto& its) { return ends_in(its, ray); }, solid);
}

// --- What is no solid

/// Of larger numbers differences could overflow.
template <class T>
bool is_moderate(const Point<T>& v) {
  if constexpr (std::floating_point<T>) {
    const T most = std::numeric_limits<T>::max() / 8;
    return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;
  } else {
    return true;
  }
}
template <class T>
void expect_solid(const HalfSpace<T>& h) {
  expects(is_moderate(h.normal) && is_moderate(h.on), "a half-space's numbers are not finite, or huge");
  expects(h.normal != Point<T>(T(0)), "a half-space has a normal that is not 0");
}
template <class T>
void expect_solid(const Box<T>& box) {
  expects(is_moderate(box.lower) && is_moderate(box.upper), "a box's numbers are not finite, or huge");
  for (int i = 0; i < 3; ++i) expects(box.lower[i] <= box.upper[i], "a box is inside out");
}
template <class T>
void expect_round(const Point<T>& centre, const T& radius) {
  expects(is_moderate(centre) && is_moderate(Point<T>(radius)) && T(0) <= radius,
          "a round solid's numbers are not finite, or huge, or its radius is below 0");
}
template <class T>
void expect_solid(const Ball<T>& ball) {
  expect_round(ball.centre, ball.radius);
}
template <class T>
void expect_solid(const Cylinder<T>& c) {
  expect_round(c.centre, c.radius);
  expects(0 <= c.axis && c.axis < 3, "a cylinder goes along axis 0, 1 or 2, not {}", c.axis);
}
template <class T>
void expect_any(const Solid<T>& solid) {
  std::visit([](const auto& its) { expect_solid(its); }, solid);
}
template <class T>
void expect_ray(const Ray<T>& ray) {
  expects(is_moderate(ray.from) && is_moderate(ray.way), "a ray's numbers are not finite, or huge");
  expects(ray.way != Point<T>(T(0)), "a ray goes somewhere: its way is not 0");
  expects(T(0) < ray.last && all_finite(ray.last), "a ray's last t is above 0 and finite");
}

}  // namespace gradus::csg_tree
