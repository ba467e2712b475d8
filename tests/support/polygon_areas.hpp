#pragma once
// What clipped polygons are measured against: exact areas in fractions, found without clipping as the topics
// do it.

#include <algorithm>
#include <glm/vec2.hpp>
#include <vector>

#include "support/fraction.hpp"

namespace gradus::test {

struct ExactPoint {
  Fraction x, y;
  friend bool operator==(const ExactPoint&, const ExactPoint&) = default;
};
inline ExactPoint exact_point(glm::dvec2 p) { return {Fraction(p.x), Fraction(p.y)}; }

/// det(b - a, c - a).
inline Fraction turn(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
/// Where the lines a b and c d cross. Domain: not parallel.
inline ExactPoint exact_crossing(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                 const ExactPoint& d) {
  const Fraction from = turn(c, d, a), t = from / (from - turn(c, d, b));
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// With its sign: positive counter-clockwise.
inline Fraction exact_area(const std::vector<ExactPoint>& ring) {
  Fraction doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}
inline Fraction exact_area(const std::vector<glm::dvec2>& ring) {
  std::vector<ExactPoint> points;
  for (const glm::dvec2& p : ring) points.push_back(exact_point(p));
  return exact_area(points);
}

/// The area that a ring has in a rectangle, points counted as often as it goes round them: edge by edge, the
/// signed area between the edge, held between the lower and the upper border, and the lower border.
inline Fraction area_in_rectangle(const std::vector<glm::dvec2>& ring, glm::dvec2 lower, glm::dvec2 upper) {
  Fraction area = 0;
  const ExactPoint low = exact_point(lower), high = exact_point(upper);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint p = exact_point(ring[i]), q = exact_point(ring[(i + 1) % ring.size()]);
    if (p.x == q.x) continue;
    const Fraction slope = (q.y - p.y) / (q.x - p.x);
    const auto inside = [&](const Fraction& x) -> Fraction { return std::clamp(x, low.x, high.x); };
    // Between these places the edge stays below, in or above the rectangle
    std::vector<Fraction> places{inside(p.x), inside(q.x)};
    const auto [first, last] = std::minmax(places[0], places[1]);
    const Fraction begin = first, end = last;
    if (slope != 0) {
      for (const Fraction& y : {low.y, high.y}) {
        const Fraction x = p.x + (y - p.y) / slope;
        if (begin < x && x < end) places.push_back(x);
      }
    }
    std::sort(places.begin(), places.end());
    Fraction below = 0;
    const auto height = [&](const Fraction& x) -> Fraction {
      return std::clamp<Fraction>(p.y + (x - p.x) * slope, low.y, high.y) - low.y;
    };
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      below += (places[k + 1] - places[k]) * (height(places[k]) + height(places[k + 1])) / 2;
    }
    area += p.x < q.x ? -below : below;
  }
  return area;
}

/// The part of a triangle inside a half-plane, in fractions.
inline std::vector<ExactPoint> half(const std::vector<ExactPoint>& convex, const ExactPoint& a,
                                    const ExactPoint& b) {
  std::vector<ExactPoint> kept;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const ExactPoint &p = convex[i], &q = convex[(i + 1) % convex.size()];
    const Fraction f = turn(a, b, p), g = turn(a, b, q);
    if (f >= 0) kept.push_back(p);
    if ((f > 0 && g < 0) || (f < 0 && g > 0)) kept.push_back(exact_crossing(p, q, a, b));
  }
  return kept;
}

/// The same in any convex window, counter-clockwise: the ring is a sum of signed triangles from one point,
/// and a triangle's part in the window is a convex polygon.
inline Fraction area_in_convex(const std::vector<glm::dvec2>& ring, const std::vector<glm::dvec2>& window) {
  Fraction area = 0;
  if (ring.empty()) return area;
  const ExactPoint origin = exact_point(ring[0]);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const ExactPoint p = exact_point(ring[i]), q = exact_point(ring[i + 1]);
    const Fraction doubled = turn(origin, p, q);
    if (doubled == 0) continue;
    std::vector<ExactPoint> part{origin, p, q};
    if (doubled < 0) std::swap(part[1], part[2]);
    for (std::size_t k = 0; k < window.size(); ++k) {
      part = half(part, exact_point(window[k]), exact_point(window[(k + 1) % window.size()]));
    }
    area += doubled < 0 ? -exact_area(part) : exact_area(part);
  }
  return area;
}

}  // namespace gradus::test
