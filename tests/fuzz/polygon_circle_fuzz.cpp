// Polygons in a circle: no ring, whatever meets the circle where, has more than the disc or the polygon;
// areas against sums of triangles and sectors in 200 bits.

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "clipping/polygon_circle/polygon_circle.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using namespace gradus::polygon_circle;
using gradus::test::require;
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<200, boost::multiprecision::digit_base_2, void, std::int32_t>>;

namespace {

struct Point {
  Wide x, y;
};
Point from(dvec2 p, dvec2 centre) { return {Wide(p.x) - centre.x, Wide(p.y) - centre.y}; }
Wide cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
Wide dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

/// The area that a disc round 0 and the triangle (0, a, b) share, with the triangle's sign.
Wide shared_area(const Point& a, const Point& b, const Wide& r) {
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

/// What the rings enclose, and how long their boundary is.
Wide enclosed(const Region<double>& region, double& length) {
  const Wide pi = boost::math::constants::pi<Wide>(), r(region.circle.radius);
  Wide area = 0;
  for (const auto& ring : region.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = from(ring[i].at, region.circle.centre),
                  b = from(ring[(i + 1) % ring.size()].at, region.circle.centre);
      if (!ring[i].arc) {
        area += cross(a, b) / 2;
        length += static_cast<double>(sqrt(dot({b.x - a.x, b.y - a.y}, {b.x - a.x, b.y - a.y})));
        continue;
      }
      Wide angle = atan2(cross(a, b), dot(a, b));
      if (angle < 0) angle += 2 * pi;
      if (ring[i].more_than_half && angle < pi / 2) angle += 2 * pi;
      if (!ring[i].more_than_half && angle > 3 * pi / 2) angle -= 2 * pi;
      area += r * r * angle / 2;
      length += static_cast<double>(r * abs(angle));
    }
  }
  return area;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  const int reach = input.coin() ? 4 : 30;
  Circle<double> circle;
  circle.radius = std::abs(input.number(-reach, reach));
  circle.centre = input.coin() ? dvec2{} : input.point(-reach, reach);
  std::vector<dvec2> polygon(static_cast<std::size_t>(3 + input.below(8)));
  static constexpr double lattice[][2]{{5, 0},  {4, 3},  {3, 4},   {0, 5}, {-3, 4},
                                       {-4, 3}, {-5, 0}, {-4, -3}, {0, -5}};
  const bool star = input.coin();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (star) {  // one corner a direction, so that it is simple
      const double size_of = std::abs(input.number(-3, 3)), turn = 360.0 * static_cast<double>(i);
      const SinCos at = sin_cos_degrees(turn / static_cast<double>(polygon.size()) + input.below(4) * 5);
      polygon[i] = circle.centre + circle.radius * size_of * dvec2(at.cos, at.sin);
    } else if (input.below(3) == 0) {
      const double* on = lattice[input.below(9)];
      polygon[i] = circle.centre + circle.radius / 5 * dvec2(on[0], on[1]);
    } else {
      polygon[i] = input.point(-reach, reach);
    }
  }
  const auto corners = counter_clockwise(std::span<const dvec2>(polygon));
  const bool simple = !meeting_edges(corners);
  Region<double> region;
  try {
    region = arcs(std::span<const dvec2>(polygon), circle);
  } catch (const ContractViolation&) {
    require(!simple, "only a polygon that meets itself is refused");
    return 0;
  }
  // What has no area may have crossed itself before its corners were left out
  if (corners.empty()) require(region.rings.empty(), "nothing comes of what has no area");
  if (!simple || corners.empty()) return 0;
  double length = 0, largest = circle.radius;
  Wide right = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    right += shared_area(from(polygon[i], circle.centre),
                         from(polygon[(i + 1) % polygon.size()], circle.centre), Wide(circle.radius));
    largest = std::max({largest, std::abs(polygon[i].x), std::abs(polygon[i].y)});
  }
  const Wide got = enclosed(region, length);
  const double extent =
      std::min(largest, std::abs(circle.centre.x) + std::abs(circle.centre.y) + 2 * circle.radius);
  const double bound = 4 * (circle.radius + length) * extent * 0x1p-52;
  require(static_cast<double>(abs(got - abs(right))) <= bound, "the area is that of triangles and sectors");
  for (const auto& ring : region.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (ring.size() > 1 && !ring[i].arc) {
        require(ring[i].at != ring[(i + 1) % ring.size()].at, "no straight way has length 0");
      }
    }
  }
  if (circle.radius > 0) {
    const auto flat = flatten(region, circle.radius / 64);
    require(flat.size() == region.rings.size(), "every ring has its chords");
  }
  return 0;
}
