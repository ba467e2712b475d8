// Polygons in windows: areas and vertices against rationals, pieces against the same areas, the batch against
// the single polygon.

#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <optional>
#include <span>
#include <vector>

#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"
#include "core/geometry.hpp"
#include "support/fuzz_input.hpp"
#include "support/polygon_areas.hpp"

using namespace gradus;
using namespace gradus::sutherland_hodgman;
using gradus::test::ExactPoint;
using gradus::test::Rational;
using gradus::test::require;

namespace {

using Points = std::vector<dvec2>;

Rational area_in(const Points& ring, const Rectangle<double>& w) {
  return test::area_in_rectangle(ring, w.lower, w.upper);
}
Rational area_in(const Points& ring, const ConvexWindow<double>& w) {
  return test::area_in_convex(ring, w.corners);
}

template <class Window>
ExactPoint place_of(const Scene<double, Window>& scene, const Vertex<double>& v) {
  if (!v.made()) return test::exact_point(scene.polygon[v.input]);
  const Segment<2, double> a = scene.line(v.edge), b = scene.line(v.border);
  return test::exact_crossing(test::exact_point(a.a), test::exact_point(a.b), test::exact_point(b.a),
                              test::exact_point(b.b));
}

bool nearest(double at, const Rational& x) {
  const Rational miss = abs(Rational(at) - x);
  const double up = std::nextafter(at, HUGE_VAL), down = std::nextafter(at, -HUGE_VAL);
  return (!std::isfinite(up) || miss <= abs(Rational(up) - x)) &&
         (!std::isfinite(down) || miss <= abs(Rational(down) - x));
}

template <class Window>
std::vector<ExactPoint> places(const Scene<double, Window>& scene, const std::vector<Vertex<double>>& ring) {
  std::vector<ExactPoint> all;
  for (const auto& v : ring) {
    all.push_back(place_of(scene, v));
    require(nearest(v.at.x, all.back().x) && nearest(v.at.y, all.back().y), "a vertex is the nearest point");
    if (!v.made()) require(v.at == scene.polygon[v.input], "a vertex inside is copied");
  }
  return all;
}

template <class Window>
void compare(const Points& points, const Window& window, std::vector<int> order) {
  const std::span<const dvec2> given(points);
  const Scene<double, Window> scene{{given}, window};
  const auto clipped = clip_to_window(given, window, std::span<const int>(order));
  const auto exact = places(scene, clipped);
  const Rational wanted = area_in(points, window);
  for (std::size_t i = 0; i < clipped.size(); ++i) {
    const auto& next = clipped[(i + 1) % clipped.size()];
    if (clipped[i].made() || next.made()) require(clipped[i].at != next.at, "no made edge has length 0");
    for (int border = 0; border < border_count(window); ++border) {
      const Segment<2, double> line = line_of(window, border);
      const Rational turn = test::turn(test::exact_point(line.a), test::exact_point(line.b), exact[i]);
      require(turn >= 0, "every vertex lies in the window");
      require(side_of_border(scene, border, clipped[i]) == turn.sign(), "sides are exact");
    }
  }
  // Where vertices that round to one were left out, the exact places no longer give the exact area
  bool repeated = clipped.empty();
  if (!repeated && test::exact_area(exact) != wanted) {
    // Recount without leaving anything out: the ring before is not to be had, so bound what can be missing
    Rational reach = 0;
    for (const auto& p : points) reach = std::max<Rational>({reach, abs(Rational(p.x)), abs(Rational(p.y))});
    const Rational lost = abs(test::exact_area(exact) - wanted);
    require(lost <= reach * reach / Rational(boost::multiprecision::cpp_int(1) << 45) +
                        reach / Rational(boost::multiprecision::cpp_int(1) << 1060),
            "the area is the exact one, but for vertices that round to one");
  }
  static_cast<void>(bridges(std::span<const Vertex<double>>(clipped), given, window));

  const std::vector<Points> rings{points};
  const Rings<double> polygon{std::span<const Points>(rings)};
  const auto ring_scene = scene_of(polygon, window);
  Rational sum = 0;
  bool left_out = false;
  for (const auto& piece : separate_pieces(polygon, window, std::span<const int>(order))) {
    sum += test::exact_area(places(ring_scene, piece.outline));
    for (const auto& hole : piece.holes) sum += test::exact_area(places(ring_scene, hole));
    left_out = left_out || piece.outline.size() < 3;
  }
  require(!left_out, "a piece has three corners");
  const Rational whole = test::exact_area(points);
  if (whole != 0 && sum != (whole > 0 ? wanted : Rational(-wanted))) {
    Rational reach = 0;
    for (const auto& p : points) reach = std::max<Rational>({reach, abs(Rational(p.x)), abs(Rational(p.y))});
    require(abs(abs(sum) - abs(wanted)) <= reach * reach / Rational(boost::multiprecision::cpp_int(1) << 45) +
                                               reach / Rational(boost::multiprecision::cpp_int(1) << 1060),
            "the pieces have the exact area, but for vertices that round to one");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  static constexpr int reaches[]{5, 40, 300};
  const int reach = reaches[input.below(3)];
  Points points(static_cast<std::size_t>(3 + input.below(6)));
  Points corners(static_cast<std::size_t>(3 + input.below(3)));
  const dvec2 p = input.point(-reach, reach), q = input.point(-reach, reach);
  for (dvec2& point : points) point = input.point(-reach, reach);
  for (dvec2& corner : corners) corner = input.point(-reach, reach);
  const Rectangle<double> window{glm::min(p, q), glm::max(p, q)};
  std::vector<int> order = all_borders(window);
  for (std::size_t i = order.size(); i-- > 1;) {
    std::swap(order[i], order[static_cast<std::size_t>(input.below(static_cast<int>(i) + 1))]);
  }
  compare(points, window, order);
  if (const auto convex = convex_window(std::span<const dvec2>(corners))) {
    compare(points, *convex, all_borders(*convex));
  }
  // The batch, and clipping again
  const auto once = clip_to_window(std::span<const dvec2>(points), window);
  Polygons given, result;
  given.add(points);
  given.add(corners);
  BatchClipper clip;
  clip(given, window, result);
  require(result.size() == 2 && result[0].size() == once.size(), "the batch has the same vertices");
  Points kept;
  for (std::size_t i = 0; i < once.size(); ++i) {
    require(result[0][i] == once[i].at, "the batch has the same bits");
    kept.push_back(once[i].at);
  }
  const auto twice = clip_to_window(std::span<const dvec2>(kept), window);
  require(twice.size() == once.size(), "clipping again changes nothing");
  for (std::size_t i = 0; i < twice.size(); ++i)
    require(twice[i].at == once[i].at, "clipping again keeps the bits");
  return 0;
}
