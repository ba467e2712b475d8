#pragma once
// Polygons and circles: inputs of every kind, at every scale.

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "clipping/polygon_circle/polygon_circle.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/geometry.hpp"
#include "stress/clipping/circle_ends.hpp"
#include "stress/clipping/circle_scales.hpp"
#include "stress/numbers.hpp"
#include "support/circle_areas.hpp"
#include "support/polygon_areas.hpp"

namespace gradus::stress::circle_polygons {

using namespace gradus::polygon_circle;
using test::Fraction;
using test::Point;
using test::Wide;
using Points = std::vector<dvec2>;

// --- Inputs: centre, radius, up to twelve corners, the last one as often as it takes ---

inline constexpr std::size_t corners = 12, shape_numbers = 3 + 2 * corners;

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
inline bool is_taken(const Input& i) { return all_finite(i) && i[2] >= 0; }
inline bool is_simple(const Input& i) { return !meeting_edges(counter_clockwise(points_of(i))); }

/// The corners in their order or turned round, from any of them on.
inline Input with_corners(Input circle, Points points, Random& random) {
  if (random.unit() < 0.5) std::ranges::reverse(points);
  std::rotate(points.begin(), points.begin() + random.uniform_int(0, std::ssize(points) - 1), points.end());
  points.resize(corners, points.back());
  for (const dvec2 p : points) circle.insert(circle.end(), {p.x, p.y});
  return circle;
}
inline dvec2 on_circle(double turn, double radius) {
  const SinCos at = sin_cos(0x1.921fb54442d18p2 * turn);
  return radius * dvec2(at.cos, at.sin);
}

/// A star-shaped polygon: angle by angle, near the circle or anywhere.
inline Input star(Kind kind, Random& random) {
  const double radius = random.uniform(0.5, 8);
  const dvec2 centre = kind == Kind::random ? dvec2{random.uniform(-4, 4), random.uniform(-4, 4)} : dvec2(0);
  const auto n = random.uniform_int(3, corners);
  Points points;
  for (std::int64_t i = 0; i < n; ++i) {
    const double turn = (static_cast<double>(i) + random.uniform(0.1, 0.9)) / static_cast<double>(n);
    const double way = random.unit();
    double length = random.uniform(1, 12);
    if (kind == Kind::grazing && way < 0.6) length = radius;                       // on the circle
    if (kind == Kind::grazing && way > 0.8) length = radius / std::cos(2 * turn);  // on a tangent
    const dvec2 p = centre + on_circle(turn, length);
    points.push_back(kind == Kind::grazing ? dvec2{nudged(p.x, random), nudged(p.y, random)} : p);
  }
  return with_corners({centre.x, centre.y, radius}, points, random);
}

/// Small whole numbers and halves, many of them on the circle of radius 5 or on its tangents.
inline Input lattice(Random& random) {
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
inline Input spikes(Random& random) {
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
inline Input comb(Random& random) {
  Points points{{-9, -9}, {9, -9}};
  for (const double x : {0.0, -6.0}) {
    for (const double at : {x + 5.4, x + 3}) points.emplace_back(at, random.uniform(6, 12));
    for (const double at : {x + 2.4, x + 0.6}) points.emplace_back(at, random.uniform(-8, 5));
  }
  return with_corners({0, 0, random.uniform(3, 8)}, points, random);
}

/// Sizes that have nothing to do with each other: bands along an axis that touch the circle or nearly do, a
/// triangle with a corner near the circle, and stars whose corners lie anywhere on their rays.
inline Input of_mixed_sizes(Random& random) {
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
    const dvec2 near = centre + radius * dvec2{random.uniform(-2, 2), random.uniform(-2, 2)};
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

inline Input shape(Kind kind, Random& random) {
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

}  // namespace gradus::stress::circle_polygons
