// Polygons in a circle: no ring, whatever meets the circle where, has more than the disc or the polygon;
// areas against sums of triangles and sectors in 200 bits.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "clipping/polygon_circle/polygon_circle.hpp"
#include "support/circle_areas.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using namespace gradus::polygon_circle;
using gradus::test::require;
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
  double largest = circle.radius;
  for (const dvec2 p : polygon) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const test::Wide right = test::exact_area(polygon, circle);
  const auto [got, least, boundary] = test::enclosed_by(region);
  const auto length = static_cast<double>(boundary);
  const double extent =
      std::min(largest, std::abs(circle.centre.x) + std::abs(circle.centre.y) + 2 * circle.radius);
  const double bound = 4 * (circle.radius + length) * extent * 0x1p-52;
  require(static_cast<double>(abs(got - right)) <= bound, "the area is that of triangles and sectors");
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
