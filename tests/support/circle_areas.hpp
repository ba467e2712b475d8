#pragma once
// What polygons in circles are measured against: areas in 200 bits, the sum of the edges' triangles and
// sectors.

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "clipping/polygon_circle/polygon_circle.hpp"

namespace gradus::test {

template <unsigned bits>
using Float = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<bits, boost::multiprecision::digit_base_2, void, std::int32_t>>;
using Wide = Float<200>;

struct Point {
  Wide x, y;
};
template <class T>
Point wide(glm::vec<2, T> p) {
  return {Wide(p.x), Wide(p.y)};
}
inline Wide cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
inline Wide dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

/// The area that a disc round 0 and the triangle (0, a, b) share, with the triangle's sign.
inline Wide shared_area(const Point& a, const Point& b, const Wide& r) {
  const Point d{b.x - a.x, b.y - a.y};
  const Wide A = dot(d, d), B = dot(a, d), C = dot(a, a) - r * r, D = B * B - A * C;
  const auto sector = [&](const Point& p, const Point& q) -> Wide {
    return r * r * atan2(cross(p, q), dot(p, q)) / 2;
  };
  if (A == 0) return 0;
  if (D <= 0) return sector(a, b);
  const Wide root = sqrt(D), enters = (-B - root) / A, leaves = (-B + root) / A;
  if (enters >= 1 || leaves <= 0) return sector(a, b);
  const auto at = [&](const Wide& t) { return Point{a.x + t * d.x, a.y + t * d.y}; };
  Wide area = 0;
  const Point p = enters > 0 ? at(enters) : a, q = leaves < 1 ? at(leaves) : b;
  if (enters > 0) area += sector(a, p);
  area += cross(p, q) / 2;
  if (leaves < 1) area += sector(q, b);
  return area;
}

/// The area that a polygon and a disc share.
template <class T>
Wide exact_area(const std::vector<glm::vec<2, T>>& polygon, const Circle<T>& circle) {
  Wide area = 0;
  const Point c = wide(circle.centre);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = wide(polygon[i]), b = wide(polygon[(i + 1) % polygon.size()]);
    area += shared_area({a.x - c.x, a.y - c.y}, {b.x - c.x, b.y - c.y}, Wide(circle.radius));
  }
  return abs(area);
}

/// What rings enclose: the area of all, of the one that encloses least, and how long their boundary is.
struct Enclosed {
  Wide area = 0, least = 0, length = 0;
};
template <class T>
Enclosed enclosed_by(const polygon_circle::Region<T>& region) {
  const Wide pi = boost::math::constants::pi<Wide>();
  const Point c = wide(region.circle.centre);
  const Wide r(region.circle.radius);
  Enclosed all;
  for (const auto& ring : region.rings) {
    Wide of_ring = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point p = wide(ring[i].at), q = wide(ring[(i + 1) % ring.size()].at);
      const Point a{p.x - c.x, p.y - c.y}, b{q.x - c.x, q.y - c.y};
      if (ring[i].arc) {
        Wide angle = atan2(cross(a, b), dot(a, b));
        if (angle < 0) angle += 2 * pi;
        if (ring[i].more_than_half && angle < pi / 2) angle += 2 * pi;
        if (!ring[i].more_than_half && angle > 3 * pi / 2) angle -= 2 * pi;
        of_ring += r * r * angle / 2;
        all.length += r * abs(angle);
      } else {
        of_ring += cross(a, b) / 2;
        all.length += sqrt(dot({q.x - p.x, q.y - p.y}, {q.x - p.x, q.y - p.y}));
      }
    }
    all.area += of_ring;
    all.least = std::min(all.least, of_ring);
  }
  return all;
}

}  // namespace gradus::test
