#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"

#include <array>
#include <limits>

namespace gradus::sutherland_hodgman {
namespace {

/// The smallest rectangle round a polygon. `check` is 0 unless a coordinate is not finite.
struct Reach {
  glm::dvec2 lower{std::numeric_limits<double>::infinity()};
  glm::dvec2 upper{-std::numeric_limits<double>::infinity()};
  glm::dvec2 check{0.0};
};

/// The compiler makes one instruction for both coordinates of each of these lines.
Reach reach_of(std::span<const glm::dvec2> polygon) {
  Reach reach;
  for (const glm::dvec2& p : polygon) {
    reach.lower = {p.x < reach.lower.x ? p.x : reach.lower.x, p.y < reach.lower.y ? p.y : reach.lower.y};
    reach.upper = {p.x > reach.upper.x ? p.x : reach.upper.x, p.y > reach.upper.y ? p.y : reach.upper.y};
    reach.check += p * 0.0;
  }
  return reach;
}

}  // namespace

BatchCount BatchClipper::operator()(const Polygons& polygons, const Rectangle<double>& window,
                                    Polygons& result) {
  expect_window(window);
  BatchCount count;
  result.points.clear();
  result.ends.clear();
  result.points.reserve(polygons.points.size());
  result.ends.reserve(polygons.size());
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const std::span<const glm::dvec2> points = polygons[i];
    const Reach reach = reach_of(points);
    expects(reach.check.x == 0 && reach.check.y == 0, "a polygon needs finite vertices");
    // Wholly on the outer side of one border?
    if (points.size() < 3 || reach.upper.x < window.lower.x || reach.lower.x > window.upper.x ||
        reach.upper.y < window.lower.y || reach.lower.y > window.upper.y) {
      result.ends.push_back(static_cast<std::uint32_t>(result.points.size()));
      ++count.dropped;
      continue;
    }
    // Which borders does it cross? A border that it doesn't leaves it as it is
    const std::array<bool, 4> crosses_border{reach.lower.x<window.lower.x, reach.upper.x> window.upper.x,
                                             reach.lower.y<window.lower.y, reach.upper.y> window.upper.y};
    if (!crosses_border[0] && !crosses_border[1] && !crosses_border[2] && !crosses_border[3]) {
      result.add(points);
      ++count.copied;
      continue;
    }
    const Scene<double, Rectangle<double>> scene{{points}, window};
    polygon_.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const int number = static_cast<int>(k);
      polygon_.push_back({points[k], number, {}, {}, EdgeName::polygon(number)});
    }
    for (int border = 0; border < 4 && !polygon_.empty(); ++border) {
      if (!crosses_border[static_cast<std::size_t>(border)]) continue;
      cut_at_border(std::span<const Vertex<double>>(polygon_), ExactBorder{scene, border}, kept_);
      std::swap(polygon_, kept_.polygon);
    }
    leave_out_repeated(polygon_);
    for (const Vertex<double>& v : polygon_) result.points.push_back(v.at);
    result.ends.push_back(static_cast<std::uint32_t>(result.points.size()));
    ++count.clipped;
  }
  return count;
}

}  // namespace gradus::sutherland_hodgman
