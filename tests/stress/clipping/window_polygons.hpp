#pragma once
// Polygons in windows by the definition: Sutherland and Hodgman's method in fractions. The oracle of what
// clips polygons, in promises and in benchmarks.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "clipping/sutherland_hodgman/convex_window.hpp"
#include "support/clip_oracle.hpp"
#include "support/polygon_areas.hpp"

namespace gradus::stress::window_polygons {

using test::ExactPoint;
using test::Fraction;
using Points = std::vector<dvec2>;
using ExactPoints = std::vector<ExactPoint>;

/// The side of a border on which the window lies: a x + b y + c >= 0.
struct HalfPlane {
  Fraction a, b, c;

  Fraction at(const ExactPoint& p) const {
    if (a == 0) return b * p.y + c;
    if (b == 0) return a * p.x + c;
    return a * p.x + b * p.y + c;
  }
};

inline std::vector<HalfPlane> borders_of(const Rectangle<double>& w) {
  const auto [left, bottom] = test::exact_point(w.lower);
  const auto [right, top] = test::exact_point(w.upper);
  return {{1, 0, -left}, {-1, 0, right}, {0, 1, -bottom}, {0, -1, top}};
}
inline std::vector<HalfPlane> borders_of(const sutherland_hodgman::ConvexWindow<double>& w) {
  std::vector<HalfPlane> borders;
  for (std::size_t i = 0; i < w.corners.size(); ++i) {
    const ExactPoint from = test::exact_point(w.corners[i]),
                     to = test::exact_point(w.corners[(i + 1) % w.corners.size()]);
    borders.push_back({from.y - to.y, to.x - from.x, from.x * to.y - from.y * to.x});
  }
  return borders;
}

inline Fraction area_in(const Points& ring, const Rectangle<double>& w) {
  return test::area_in_rectangle(ring, w.lower, w.upper);
}
inline Fraction area_in(const Points& ring, const sutherland_hodgman::ConvexWindow<double>& w) {
  return test::area_in_convex(ring, w.corners);
}

inline ExactPoints cut_at(const HalfPlane& border, const ExactPoints& polygon) {
  std::vector<Fraction> distance;
  for (const ExactPoint& p : polygon) distance.push_back(border.at(p));
  ExactPoints kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    const ExactPoint &p = polygon[i], &q = polygon[next];
    if (distance[i] >= 0) kept.push_back(p);
    if (distance[i].sign() * distance[next].sign() >= 0) continue;
    const Fraction t = distance[i] / (distance[i] - distance[next]);
    kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
  }
  return kept;
}

template <class Window>
ExactPoints exact_part(std::span<const dvec2> points, const Window& window, std::span<const int> order) {
  ExactPoints part;
  for (const dvec2& p : points) part.push_back(test::exact_point(p));
  const std::vector<HalfPlane> borders = borders_of(window);
  for (const int border : order) part = cut_at(borders[static_cast<std::size_t>(border)], part);
  return part;
}

/// The nearest doubles. Domain: inside the range of doubles.
inline dvec2 rounded(const ExactPoint& p) { return {test::nearest(p.x), test::nearest(p.y)}; }

/// The larger error of a vertex's two coordinates, in ulp; of a number no smaller than `least`.
inline double error_at(dvec2 at, const ExactPoint& exact, double least = 0) {
  return std::max(test::error_in_ulp(at.x, exact.x, least), test::error_in_ulp(at.y, exact.y, least));
}

}  // namespace gradus::stress::window_polygons
