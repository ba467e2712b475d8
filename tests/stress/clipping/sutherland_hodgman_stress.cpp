// The promises of clipping polygons: at a rectangle, one or many, at any convex window, into separate pieces,
// and at a plane of clip space.

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <set>

#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_homogeneous.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "stress/clipping/clipped_pieces.hpp"
#include "stress/clipping/clipped_polygons.hpp"
#include "stress/clipping/polygon_batches.hpp"
#include "stress/last.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"
#include "support/touching_regions.hpp"

namespace gradus::stress {
namespace {

using namespace clipped_pieces;
using namespace polygon_batches;

// --- Crossings of lines ---

/// Two lines that cross and a third one that passes the crossing.
Input lines_input(Kind kind, Random& random) {
  Input input(12);
  for (double& x : input) {
    x = kind == Kind::ties ? static_cast<double>(random.uniform_int(-3, 3)) : number(kind, random);
  }
  if (kind == Kind::near_degenerate) {
    // Nearly parallel
    for (const std::size_t k : {6u, 7u})
      input[k] = nudged(input[k - 2] + input[k - 4] - input[k - 6], random);
  } else if (kind == Kind::grazing) {
    // The third one through the crossing, but for the last places
    const Segment<2, double> a{{input[0], input[1]}, {input[2], input[3]}},
        b{{input[4], input[5]}, {input[6], input[7]}};
    if (heading(a, b) == 0) return input;
    const dvec2 at = crossing_point(a, b), from(input[8], input[9]);
    input[10] = nudged(2 * at.x - from.x, random);
    input[11] = nudged(2 * at.y - from.y, random);
  }
  return input;
}

template <class T>
double lines_error(const std::array<glm::vec<2, T>, 6>& p) {
  const Segment<2, T> a{p[0], p[1]}, b{p[2], p[3]}, c{p[4], p[5]};
  std::array<ExactPoint, 6> exact;
  std::ranges::transform(p, exact.begin(),
                         [](const auto& at) { return ExactPoint{Fraction(at.x), Fraction(at.y)}; });
  const ExactPoint way{exact[3].x - exact[2].x, exact[3].y - exact[2].y};
  const int turn = test::turn(exact[0], exact[1], {exact[0].x + way.x, exact[0].y + way.y}).sign();
  if (heading(a, b) != turn) return wrong;
  if (turn == 0) return 0;
  const ExactPoint at = test::exact_crossing(exact[0], exact[1], exact[2], exact[3]);
  const auto rounded = crossing_point(a, b);
  const Fraction largest(std::numeric_limits<T>::max());
  const auto is_right = [&](T x, const Fraction& place) {
    return abs(place) < largest ? test::is_nearest(x, place) : !(std::abs(x) < std::numeric_limits<T>::max());
  };
  if (!is_right(rounded.x, at.x) || !is_right(rounded.y, at.y)) return wrong;
  return side_of_crossing(c, a, b) == test::turn(exact[4], exact[5], at).sign() ? 0 : wrong;
}
std::array<dvec2, 6> six_points(const Input& i) {
  std::array<dvec2, 6> points;
  for (std::size_t k = 0; k < 6; ++k) points[k] = {i[2 * k], i[2 * k + 1]};
  return points;
}
double lines_error_of(const Input& i) {
  if (!all_finite(i)) return 0;
  const auto points = six_points(i);
  const double error = lines_error(points);
  if (std::ranges::any_of(i, [](double x) { return std::abs(x) >= 0x1p127; })) return error;
  std::array<glm::vec2, 6> floats;
  std::ranges::transform(points, floats.begin(), [](dvec2 p) { return glm::vec2(p); });
  return std::max(error, lines_error(floats));
}

// --- Clip space ---

/// Two homogeneous points, the plane's axis, sign and bound.
Input plane_input(Kind kind, Random& random) {
  Input input(11);
  for (std::size_t k = 0; k < 8; ++k) input[k] = number(kind == Kind::refused ? Kind::random : kind, random);
  input[8] = static_cast<double>(random.uniform_int(0, 2));
  input[9] = random.unit() < 0.5 ? -1 : 1;
  const double bounds[] = {0, 1, 1, 2, 64};
  input[10] = bounds[random.uniform_int(0, 4)];
  const auto axis = static_cast<std::size_t>(input[8]);
  if (kind == Kind::grazing || kind == Kind::near_degenerate) {
    // One end, or both, nearly on the plane
    for (const std::size_t end : {0u, 4u}) {
      if (end == 4 && kind == Kind::grazing && random.unit() < 0.5) continue;
      input[end + axis] = nudged(-input[9] * input[10] * input[end + 3], random);
    }
  }
  return input;
}

/// How far the corner on an edge is from the exact one, along the plane, in ulp of the edge's largest
/// coordinate; wrong where it is not on the plane, an end is judged wrongly, a corner inside is changed, or
/// the edges there and back get different ones.
double plane_error(const Input& i) {
  const bool is_plane = (i[8] == 0 || i[8] == 1 || i[8] == 2) && std::abs(i[9]) == 1 && i[10] >= 0;
  int exponent = 0;
  const bool is_power = i[10] == 0 || std::frexp(i[10], &exponent) == 0.5;
  if (!all_finite(i) || !is_plane || !is_power) return 0;
  for (std::size_t k = 0; k < 8; ++k) {
    if (std::abs(i[k]) > 0x1p1020 / (1 + i[10])) return 0;
  }
  const int axis = static_cast<int>(i[8]);
  const Plane<double> plane{axis, i[9], i[10]};
  const glm::dvec4 a(i[0], i[1], i[2], i[3]), b(i[4], i[5], i[6], i[7]);
  const auto exact_distance = [&](const glm::dvec4& p) {
    return Fraction(i[10]) * Fraction(p.w) + Fraction(i[9]) * Fraction(p[axis]);
  };
  const Fraction from = exact_distance(a), to = exact_distance(b);
  const std::vector<Point<double>> edge{{a}, {b}};
  const auto kept = clip(std::span<const Point<double>>(edge), plane);
  if (from.sign() * to.sign() >= 0) {
    const std::size_t stay = (from >= 0 ? 1u : 0u) + (to >= 0 ? 1u : 0u);
    return kept.size() == stay ? 0 : wrong;
  }
  // The edge there gives a corner, the end inside stays, the edge back gives the same corner
  const bool first = from > 0;
  if (kept.size() != 3 || kept[first ? 1 : 2].at != (first ? a : b)) return wrong;
  const glm::dvec4 cut = kept[0].at, other = kept[first ? 2 : 1].at;
  double worst = 0, extent = 0;
  for (int k = 0; k < 4; ++k) extent = std::max({extent, std::abs(a[k]), std::abs(b[k])});
  // The largest number has no next one, but the same distance below it
  extent = std::min(extent, std::nextafter(std::numeric_limits<double>::max(), 0.0));
  const double unit = std::nextafter(extent, wrong) - extent;
  if (cut[axis] != -i[9] * i[10] * cut.w) return wrong;
  const Fraction t = from / (from - to);
  for (int k = 0; k < 4; ++k) {
    const Fraction right = Fraction(a[k]) + t * (Fraction(b[k]) - Fraction(a[k]));
    if (cut[k] != other[k] || !std::isfinite(cut[k])) return wrong;
    if (k == axis) continue;
    worst = std::max(worst, static_cast<double>(abs(Fraction(Fraction(cut[k]) - right)) / Fraction(unit)));
  }
  return worst;
}

/// Three corners and how far out the guard planes lie; mostly in front of the eye, some very far away.
Input volume_input(Kind, Random& random) {
  Input input;
  for (int corner = 0; corner < 3; ++corner) {
    const double depth = random.uniform(-2, 4), spread = random.uniform_int(0, 3) ? 4 : 9000;
    const double x = random.uniform(-spread, spread);
    input.insert(input.end(), {x, random.uniform(-spread, spread), 1.1 * depth - 0.5, depth});
  }
  input.push_back(random.uniform_int(0, 1) ? 1 : 2000);
  return input;
}
constexpr double volume_extent = 9000;

template <class T>
std::vector<Point<T>> volume_part(const Input& i) {
  std::vector<Point<T>> triangle;
  for (std::size_t k = 0; k < 12; k += 4)
    triangle.push_back({{T(i[k]), T(i[k + 1]), T(i[k + 2]), T(i[k + 3])}});
  return clip(triangle, view_volume(T(i[12]), T(i[12])));
}

/// How far corners are from those in rationals, in parts of the extent; -1 where there are more or fewer:
/// rounding may lose or add one that nearly touches a plane. Wrong where a corner lies beside a plane.
double volume_error(const Input& i) {
  const double guard = i[12];
  if (!all_finite(i) || !(guard == 1 || guard == 2000)) return 0;
  if (std::ranges::any_of(i, [](double x) { return std::abs(x) > volume_extent; })) return 0;
  const auto part = volume_part<double>(i);
  for (const auto& p : part) {
    if (!(p.at.w >= 0)) return wrong;
    for (const auto& plane : view_volume(guard, guard)) {
      if (!(distance(plane, p.at) >= -1e-11 * (1 + guard))) return wrong;
    }
  }
  const ExactScope scope;
  const auto exact = volume_part<Exact>(i);
  if (part.size() != exact.size()) return -1;
  double worst = 0;
  for (std::size_t k = 0; k < part.size(); ++k) {
    for (int axis = 0; axis < 4; ++axis) {
      worst = std::max(worst, std::abs(part[k].at[axis] - to_double(exact[k].at[axis])) / volume_extent);
    }
  }
  return worst;
}

std::string points_text(const Input& i, std::size_t first, std::size_t count) {
  std::string text;
  for (const dvec2& p : points_in(i, first, count))
    text += fmt::format("{}{},{}", text.empty() ? "" : " ", p.x, p.y);
  return text;
}
std::vector<std::pair<std::string, std::string>> rectangle_arguments(const Input& i, const char* method) {
  return {{"method", method},
          {"polygon", points_text(i, 4, corners)},
          {"window", fmt::format("{},{},{},{}", i[0], i[1], i[2], i[3])}};
}

std::vector<std::pair<std::string, std::string>> pieces_arguments(const Input& i) {
  auto arguments = rectangle_arguments(i, "separate_pieces");
  const Points hole = points_in(i, hole_at, hole_corners);
  if (std::ranges::any_of(hole, [&](dvec2 p) { return p != hole[0]; })) {
    arguments.emplace_back("hole", points_text(i, hole_at, hole_corners));
  }
  return arguments;
}

std::vector<Trap> rectangle_traps() {
  return {
      {"a corner of the window on every edge", {0, 0, 10, 10, 5, -5, 15, 5, 5, 15, -5, 5, -5, 5, -5, 5, 0}},
      {"the polygon holds the window", {0, 0, 10, 10, -10, -10, 30, -10, 10, 40, 10, 40, 10, 40, 10, 40, 0}},
      {"corners outside, edges inside", {0, 0, 10, 10, -5, 5, 5, -5, 15, 5, 5, 15, 5, 15, 5, 15, 0}},
      {"enters and leaves", {0, 0, 10, 10, -5, 2, 5, 2, 5, 8, 5, 8, 5, 8, 5, 8, 0}},
      {"two pieces hang together", {0, 0, 10, 10, 2, -4, 8, -4, 8, 4, 6, 4, 6, -2, 4, -2, 0}},
      {"a window without width", {3, 0, 3, 10, -5, 2, 15, 2, 15, 8, -5, 8, -5, 8, -5, 8, 0}},
      {"a window inside out", {10, 0, 0, 10, -5, 2, 5, 2, 5, 8, 5, 8, 5, 8, 5, 8, 0}},
      {"a corner that is no number", {0, 0, 10, 10, std::nan(""), 2, 5, 2, 5, 8, 1, 1, 2, 3, 4, 5, 0}},
      {"differences overflow",
       {0, 0, 10, 10, -1e308, 0, 1e308, 10, 1e308, 1e308, -1e308, 1e308, -1e308, 5, -1e308, 1, 0}},
      {"beside the corner by one unit in the last place",
       {0, 0, 10, 10, -1, 1, 1, std::nextafter(-1.0, -2.0), -1, std::nextafter(-1.0, -2.0), -1, -1, -1, 0, -1,
        0.5, 0}},
      {"crossings 1e-20 apart",
       {0, 0, 10, 10, 5, -1, 5 + 1e-15, 1, 5 - 1e-15, 1, 5 - 1e-15, 1, 5 - 1e-15, 1, 5 - 1e-15, 1, 0}},
      {"crossings that round to a corner",
       {0, 0, 10, 10, -1, 1, 1, std::nextafter(-1.0, 0.0), 5, -5, 5, 5, 4, 5, 3, 5, 0}}};
}

std::vector<Trap> pieces_traps() {
  std::vector<Trap> traps = rectangle_traps();
  for (Trap& trap : traps) trap.input.insert(trap.input.end() - 1, 2 * hole_corners, 0);
  traps.push_back({"a hole that touches the outline with its first corner",
                   {-1, -1, 5, 5, 0, 0, 4, 0, 4, 4, 0, 4, 0, 4, 0, 4, 2, 4, 1, 2, 3, 2, 3, 2, 0}});
  traps.push_back({"a hole in the corner of the outline, and the window through both",
                   {0, 0, 2, 5, 0, 0, 4, 0, 4, 4, 0, 4, 0, 4, 0, 4, 0, 0, 3, 1, 3, 3, 1, 3, 0}});
  traps.push_back({"a bow-tie of area 0 with a hole",
                   {0, 0, 10, 10, 1, 1, 9, 9, 9, 1, 1, 9, 1, 9, 1, 9, 2, 3, 3, 5, 2, 7, 2, 7, 0}});
  return traps;
}

std::vector<std::pair<std::string, std::string>> convex_arguments(const Input& i) {
  return {{"method", "border_by_border"},
          {"polygon", points_text(i, 8, corners)},
          {"window-polygon", points_text(i, 0, 4)}};
}

// --- The promises ---

/// One that is kept or broken.
Property promise(const char* name, const char* states, std::size_t numbers, Generator generate,
                 std::function<double(const Input&)> error) {
  return {.name = name,
          .states = states,
          .unit = "wrong",
          .bound = 0,
          .numbers = numbers,
          .generate = std::move(generate),
          .error = std::move(error)};
}
Property measured(Property property, const char* unit, double bound) {
  property.unit = unit;
  property.bound = bound;
  return property;
}
Property of_rectangles(const char* name, const char* states, double (*error)(const Input&)) {
  Property property =
      promise(name, states, rectangle_numbers,
              at_every_scale(rectangle_input, lengths_of(rectangle_numbers), mend_rectangle), error);
  property.arguments = [](const Input& i) { return rectangle_arguments(i, "border_by_border"); };
  property.traps = rectangle_traps();
  return property;
}

Property polygons_in_rectangles() {
  Property property = of_rectangles("clip_to_window",
                                    "the vertices of the exact polygon, each the nearest double, which "
                                    "remember what made them; twice changes nothing",
                                    rectangle_error);
  property.shares = {{"has a bridge", 0.01, has_bridge}};
  return measured(property, "ulp", 0.5);
}
Property polygons_in_convex_windows() {
  Property property = promise("convex_window", "the same at borders of any direction", convex_numbers,
                              at_every_scale(convex_input, lengths_of(convex_numbers)), convex_error);
  property.arguments = convex_arguments;
  property.traps = {
      {"an edge along a border", {5, -3, 12, 3, 8, 10, -2, 7, 5, -3, 12, 3, 20, 9, 9, 30, 0, 0, 1, 1, 0}},
      {"a border of one unit in the last place",
       {1, 1, std::nextafter(1.0, 2.0), 1, 2, 2, 1, 2, 0, 0, 3, 0, 3, 3, 0, 3, 1, 1, 1, 1, 0}}};
  property.shares = {{"is a window", 0.4, [](const Input& i) { return oblique_in(i).has_value(); }}};
  return measured(property, "ulp", 0.5);
}
template <class T>
std::vector<Share> batch_shares() {
  return {batch_share<T>("copies polygons", 0.01, &BatchCount::copied),
          batch_share<T>("drops polygons", 0.05, &BatchCount::dropped),
          batch_share<T>("clips polygons", 0.25, &BatchCount::clipped)};
}
Property batches() {
  Property property =
      of_rectangles("batch", "the bits of clip_to_window, polygon by polygon", batch_error<double>);
  property.shares = batch_shares<double>();
  return measured(property, "vertices", 0);
}
Property batches_of_floats() {
  Property property = promise("batch_of_floats",
                              "the same in floats, and the vertices of the exact polygon, each the nearest "
                              "float, also midway between two",
                              float_numbers, floats_input, float_batch_error);
  property.arguments = [](const Input& i) { return rectangle_arguments(i, "border_by_border"); };
  property.traps = rectangle_traps();
  for (Trap& trap : property.traps) trap.input.pop_back();
  property.shares = batch_shares<float>();
  return measured(property, "vertices", 0);
}
Property pieces() {
  Property property = promise(
      "separate_pieces",
      "the area of the pieces, outlines less holes, is the polygon's in the window, "
      "but for the rounding of vertices",
      pieces_numbers, at_every_scale(pieces_input, lengths_of(pieces_numbers), mend_rectangle), pieces_error);
  property.arguments = pieces_arguments;
  property.traps = pieces_traps();
  return measured(property, "of rounding", 1);
}
Property areas() {
  Property property =
      promise("areas", "the exact places of vertices, in one ring or in pieces, have the exact area",
              convex_numbers, convex_input, [](const Input& i) { return last_of<whole_areas>(i).error; });
  property.kinds = {Kind::random, Kind::ties};
  property.arguments = convex_arguments;
  property.shares = {{"exactly", 1, [](const Input& i) { return last_of<whole_areas>(i).exact; }},
                     {"oblique", 0.5, [](const Input& i) { return last_of<whole_areas>(i).oblique; }}};
  property.cases = 3'000;  // areas in two windows, of rings and of pieces: half a millisecond
  return measured(property, "of rounding", 1);
}
Property parts() {
  Property property = promise("connected_parts",
                              "of rings that touch themselves and each other the pieces are the connected "
                              "parts of the inside: simple rings that touch once at most",
                              parts_numbers, parts_input, parts_error);
  property.kinds = {Kind::ties};
  property.shares = {
      share_of_parts("several pieces", 0.25, [](const PartsCase& of) { return pieces_in(of) > 1; }),
      share_of_parts("a hole", 0.12, [](const PartsCase& of) { return of.rings.size() > 1; }),
      share_of_parts("rings that touch", 0.5, [](const PartsCase& of) {
        const Rings<double> rings(of.rings);
        return TouchingRings<double>({rings.points, rings.next}).touch();
      })};
  property.cases = 2'500;  // regions are counted and clipped three times: a millisecond
  return property;
}
Property touching_rings() {
  Property property =
      promise("rings_touch", "whether rings touch is known as from all pairs of edges and vertices",
              touch_numbers, touch_input, touch_error);
  property.kinds = {Kind::random};
  property.shares = {
      share_of_touching("touch", 0.2, [](const Touching& of) { return of.right; }),
      share_of_touching("don't", 0.2, [](const Touching& of) { return !of.right; }),
      share_of_touching("untold by boxes", 0.01, [](const Touching& of) { return !of.by_boxes; }),
      share_of_touching("go round a point", 0.1, [](const Touching& of) { return of.round_a_point; })};
  return property;
}
Property lines() {
  Property property = promise(
      "lines_cross", "headings and sides of crossings are exact, crossings the nearest points; in float, too",
      12, at_every_scale(lines_input), lines_error_of);
  property.kinds.pop_back();
  property.shares = {{"on the third line", 0.003, [](const Input& i) {
                        const auto p = six_points(i);
                        const Segment<2, double> a{p[0], p[1]}, b{p[2], p[3]}, c{p[4], p[5]};
                        return c.a != c.b && heading(a, b) != 0 && side_of_crossing(c, a, b) == 0;
                      }}};
  return property;
}
Property planes() {
  Property property =
      promise("clip_space",
              "before the division: exact sides; a corner on the plane, within 6 ulp of the edge along it",
              11, at_every_scale(plane_input, {0, 1, 2, 3, 4, 5, 6, 7}), plane_error);
  property.kinds.pop_back();
  property.traps = {{"w goes through 0", {1, 0, 1, 2, 1, 0, -1, -1, 2, 1, 0}},
                    {"an end far away", {0, 0, 1, 1, 1e17, 0, -1e17, -1e17, 2, 1, 0}},
                    {"a corner on the plane", {0, 0, 0, 1, 1, 1, -1, 2, 2, 1, 0}},
                    {"roundings that add up",
                     {-0x1.fe378bea0159ap+0, 0, 0x1.cd15b013180cp-1, 0x1.9c22bdcb87772p-4,
                      0x1.f8c8a5ea5801bp+0, 0, -0x1.4ac71a5e3a919p-1, 0x1.4ac717c06ea4p-1, 2, 1, 1}}};
  return measured(property, "ulp", 6);
}
Property volumes() {
  const auto off = [](const Input& i) { return last_of<volume_error>(i); };
  Property property = promise("view_volume",
                              "no corner lies beside a plane; on triangles of all kinds those of exact "
                              "arithmetic, to 1e-14 of the extent",
                              13, volume_input, off);
  property.kinds = {Kind::random};
  property.shares = {
      {"within 1e-14, or a corner more or fewer", 0.999, [off](const Input& i) { return off(i) < 1e-14; }},
      {"all in front of the eye", 1,
       [](const Input& i) {
         return std::ranges::all_of(volume_part<double>(i), [](const auto& p) { return p.at.w > 0; });
       }},
      {"as many corners", 0.9975, [off](const Input& i) { return off(i) >= 0; }},
      {"new corners", 0.125, [](const Input& i) { return volume_part<double>(i).size() > 3; }},
      {"nothing left", 0.025, [](const Input& i) { return volume_part<double>(i).empty(); }}};
  property.cases = 4'000;  // cutting six times in rationals takes half a millisecond
  return measured(property, "of the extent", std::numeric_limits<double>::max());
}

}  // namespace

Domain sutherland_hodgman() {
  return {"sutherland_hodgman",
          {polygons_in_rectangles(), polygons_in_convex_windows(),
           of_rectangles("turned", "the other way round gives the same places", turned_error), batches(),
           batches_of_floats(), pieces(), areas(), parts(), touching_rings(), lines(), planes(), volumes()}};
}

}  // namespace gradus::stress
