// The promises of clipping polygons: at a rectangle, one or many, at any convex window, into separate pieces,
// and at a plane of clip space.

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"
#include "support/clip_oracle.hpp"
#include "support/polygon_areas.hpp"

namespace gradus::stress {
namespace {

using sutherland_hodgman::clip_to_window;
using sutherland_hodgman::ConvexWindow;
using sutherland_hodgman::Plane;
using sutherland_hodgman::Polygons;
using test::ExactPoint;
using test::Rational;
using Points = std::vector<dvec2>;
using Vertices = std::vector<sutherland_hodgman::Vertex<double>>;
using ExactPoints = std::vector<ExactPoint>;

// --- Inputs: a window, a polygon of six corners, and in which order the borders come ---

constexpr std::size_t corners = 6;

Points points_in(const Input& i, std::size_t first, std::size_t count) {
  Points points;
  for (std::size_t k = 0; k < count; ++k) points.emplace_back(i[first + 2 * k], i[first + 2 * k + 1]);
  return points;
}
void add(Input& input, dvec2 p) {
  input.push_back(p.x);
  input.push_back(p.y);
}

/// A permutation of the four borders, number 0 to 23.
std::optional<std::vector<int>> order_in(double number) {
  if (number != std::floor(number) || !(0 <= number && number < 24)) return std::nullopt;
  std::vector<int> order{0, 1, 2, 3};
  for (int i = 0; i < static_cast<int>(number); ++i) std::next_permutation(order.begin(), order.end());
  return order;
}

/// A polygon that goes with a window's corners: of the kind, or touching the window.
void add_polygon(Input& input, Kind kind, const Points& window, Random& random) {
  const Kind plain = kind == Kind::refused ? Kind::random : kind;
  const auto any = [&] {
    const double x = number(plain, random);
    return dvec2(x, number(plain, random));
  };
  const auto corner = [&] {
    return window[static_cast<std::size_t>(
        random.uniform_int(0, static_cast<std::int64_t>(window.size()) - 1))];
  };
  const auto near = [&](dvec2 p) {
    const double x = nudged(p.x, random);
    return dvec2(x, nudged(p.y, random));
  };
  dvec2 last = any();
  for (std::size_t i = 0; i < corners; ++i) {
    dvec2 now = any();
    if (kind == Kind::grazing) {
      // On a border, at a corner, or through a corner
      const double way = random.unit(), t = random.unit();
      const dvec2 a = corner(), b = corner();
      if (way < 0.3) now = near(a + t * (b - a));
      if (0.3 <= way && way < 0.5) now = near(a);
      if (0.5 <= way && way < 0.8) now = near(last + (1 + t) * (a - last));
    } else if (kind == Kind::near_degenerate) {
      // Nearly there and back
      const double way = random.unit();
      if (way < 0.3) now = near(last);
      if (0.3 <= way && way < 0.6 && i > 1) now = near({input[input.size() - 4], input[input.size() - 3]});
    }
    add(input, now);
    last = now;
  }
}

void refuse(Input& input, std::size_t first, Random& random) {
  const auto last = static_cast<std::int64_t>(input.size()) - 2;
  const auto at = static_cast<std::size_t>(random.uniform_int(static_cast<std::int64_t>(first), last));
  input[at] = random.unit() < 0.5 ? std::nan("") : wrong;
}

/// Lower and upper corner of a rectangle, a polygon, an order.
Input rectangle_input(Kind kind, Random& random) {
  const Kind plain = kind == Kind::refused ? Kind::random : kind;
  Input input(4);
  for (double& x : input) x = number(plain, random);
  for (std::size_t i = 0; i < 2; ++i) {
    if (input[i] > input[2 + i]) std::swap(input[i], input[2 + i]);
  }
  if (kind == Kind::near_degenerate && random.unit() < 0.3) input[2] = nudged(input[0], random);
  if (kind == Kind::near_degenerate && input[2] < input[0]) input[2] = input[0];
  const Points window{{input[0], input[1]}, {input[2], input[1]}, {input[2], input[3]}, {input[0], input[3]}};
  add_polygon(input, kind, window, random);
  input.push_back(static_cast<double>(random.uniform_int(0, 23)));
  if (kind == Kind::refused) {
    const bool inside_out = random.unit() < 0.3;
    if (inside_out) input[0] = input[2] + 1;
    if (!inside_out) refuse(input, 0, random);
  }
  return input;
}
constexpr std::size_t rectangle_numbers = 4 + 2 * corners + 1;

/// The same with a ring of four corners before the order: a hole, or one that crosses the polygon, or none
/// where all corners are one.
constexpr std::size_t hole_corners = 4, hole_at = 4 + 2 * corners;
constexpr std::size_t pieces_numbers = hole_at + 2 * hole_corners + 1;
Input pieces_input(Kind kind, Random& random) {
  Input input = rectangle_input(kind, random);
  const double order = input.back();
  input.pop_back();
  const Points outline = points_in(input, 4, corners);
  const auto corner = [&] { return outline[static_cast<std::size_t>(random.uniform_int(0, corners - 1))]; };
  const double way = random.unit();
  const dvec2 middle = 0.25 * (0.5 * (outline[0] + outline[1]) + 0.5 * (outline[2] + outline[4])) +
                       0.5 * (0.5 * (outline[1] + outline[3]));
  dvec2 p = corner();
  for (std::size_t i = 0; i < hole_corners; ++i) {
    // None, anything, or at corners and edges of the outline and between them
    if (way >= 0.2) {
      const double x = number(kind == Kind::refused ? Kind::random : kind, random);
      p = dvec2(x, number(kind == Kind::refused ? Kind::random : kind, random));
      const double t = random.uniform_int(0, 1) ? random.unit() : 0;
      const dvec2 a = corner(), b = corner();
      if (way > 0.4) p = (1 - t) * a + t * (random.unit() < 0.5 ? b : middle);
    }
    add(input, p);
  }
  input.push_back(order);
  return input;
}

/// Which numbers of an input grow and shrink with it: all but the order.
std::vector<std::size_t> lengths_of(std::size_t numbers) {
  std::vector<std::size_t> lengths(numbers - 1);
  std::iota(lengths.begin(), lengths.end(), std::size_t{0});
  return lengths;
}
void mend_rectangle(Input& input) {
  put_in_order(input[0], input[2]);
  put_in_order(input[1], input[3]);
}

Rectangle<double> rectangle_of(const Input& i) { return {{i[0], i[1]}, {i[2], i[3]}}; }
bool rectangle_is_taken(const Input& i) { return all_finite(i) && i[0] <= i[2] && i[1] <= i[3]; }

/// Four corners of a convex window, a polygon, an order.
Input convex_input(Kind kind, Random& random) {
  const Kind plain = kind == Kind::refused ? Kind::random : kind;
  Input input;
  // The corners of a rectangle, moved
  const double left = number(plain, random), right = number(plain, random);
  const double bottom = number(plain, random), top = number(plain, random);
  for (dvec2 p : {dvec2(left, bottom), dvec2(right, bottom), dvec2(right, top), dvec2(left, top)}) {
    if (kind == Kind::near_degenerate) p = {nudged(p.x, random), nudged(p.y, random)};
    if (random.unit() < 0.6) p = p + 0.25 * (dvec2(number(plain, random), number(plain, random)) - p);
    add(input, p);
  }
  add_polygon(input, kind, points_in(input, 0, 4), random);
  input.push_back(static_cast<double>(random.uniform_int(0, 23)));
  if (kind == Kind::refused) refuse(input, 8, random);
  return input;
}
constexpr std::size_t convex_numbers = 8 + 2 * corners + 1;

// --- The oracle: Sutherland and Hodgman in rationals ---

/// A border's line with the window on its left.
using Border = std::array<ExactPoint, 2>;

std::vector<Border> borders_of(const Rectangle<double>& w) {
  const auto [left, bottom] = test::exact_point(w.lower);
  const auto [right, top] = test::exact_point(w.upper);
  return {{{{left, 1}, {left, 0}}},
          {{{right, 0}, {right, 1}}},
          {{{0, bottom}, {1, bottom}}},
          {{{1, top}, {0, top}}}};
}
std::vector<Border> borders_of(const ConvexWindow<double>& w) {
  std::vector<Border> borders;
  for (std::size_t i = 0; i < w.corners.size(); ++i) {
    borders.push_back(
        {test::exact_point(w.corners[i]), test::exact_point(w.corners[(i + 1) % w.corners.size()])});
  }
  return borders;
}

dvec2 rounded(const ExactPoint& p) {
  const auto nearest = [](const Rational& x) {
    const double guess = static_cast<double>(x);
    for (const double y : {guess, std::nextafter(guess, wrong), std::nextafter(guess, -wrong)}) {
      if (std::isfinite(y) && test::is_nearest(y, x)) return y;
    }
    return guess;
  };
  return {nearest(p.x), nearest(p.y)};
}

/// Without what repeats the place before it, all round.
template <class Point, class Place>
std::vector<Point> without_repeats(const std::vector<Point>& ring, Place place) {
  std::vector<Point> kept;
  for (const Point& p : ring) {
    if (kept.empty() || place(kept.back()) != place(p)) kept.push_back(p);
  }
  while (kept.size() > 1 && place(kept.back()) == place(kept.front())) kept.pop_back();
  return kept;
}

/// The error of a vertex, in ulp.
double error_at(dvec2 at, const ExactPoint& exact) {
  return std::max(test::error_in_ulp(at.x, exact.x), test::error_in_ulp(at.y, exact.y));
}

/// The worst vertex of a clipped polygon, in ulp; wrong unless its vertices are those of the exact one in
/// their order, but for those that round to one place.
template <class Window>
double vertex_error(const Vertices& clipped, const Points& points, const Window& window,
                    const std::vector<int>& order) {
  ExactPoints exact;
  for (const dvec2& p : points) exact.push_back(test::exact_point(p));
  const std::vector<Border> borders = borders_of(window);
  for (const int border : order) {
    const auto& [from, to] = borders[static_cast<std::size_t>(border)];
    exact = test::half(exact, from, to);
  }
  exact = without_repeats(exact, rounded);
  for (std::size_t i = 0; i < clipped.size(); ++i) {
    const auto &v = clipped[i], &next = clipped[(i + 1) % clipped.size()];
    // Given vertices are copied, made ones repeat no neighbour
    if (!v.made() && v.at != points[static_cast<std::size_t>(v.input)]) return wrong;
    if ((v.made() || next.made()) && v.at == next.at) return wrong;
  }
  if (clipped.empty()) return exact.size() < 3 ? 0 : wrong;
  Points found;
  for (const auto& v : clipped) found.push_back(v.at);
  found = without_repeats(found, [](dvec2 p) { return p; });
  if (found.size() != exact.size()) return wrong;
  // Either may begin anywhere
  double best = wrong;
  for (std::size_t first = 0; first < found.size(); ++first) {
    double worst = 0;
    for (std::size_t i = 0; i < found.size() && worst < best; ++i) {
      worst = std::max(worst, error_at(found[(first + i) % found.size()], exact[i]));
    }
    best = std::min(best, worst);
  }
  return best;
}

// --- Promises ---

double rectangle_error(const Input& i) {
  const auto order = order_in(i.back());
  if (!order) return 0;
  const Points points = points_in(i, 4, corners);
  const Rectangle<double> window = rectangle_of(i);
  Vertices clipped;
  try {
    clipped = clip_to_window(std::span<const dvec2>(points), window, std::span<const int>(*order));
  } catch (const ContractViolation&) {
    return rectangle_is_taken(i) ? wrong : 0;
  }
  if (!rectangle_is_taken(i)) return wrong;
  // Clipping twice changes nothing
  Points once;
  for (const auto& v : clipped) once.push_back(v.at);
  const auto again = clip_to_window(std::span<const dvec2>(once), window);
  if (!std::ranges::equal(once, again, {}, {}, [](const auto& v) { return v.at; })) return wrong;
  return vertex_error(clipped, points, window, *order);
}

double convex_error(const Input& i) {
  const auto order = order_in(i.back());
  const Points points = points_in(i, 8, corners), around = points_in(i, 0, 4);
  if (!order || !all_finite(Input(i.begin(), i.begin() + 8))) return 0;
  const auto window = sutherland_hodgman::convex_window(std::span<const dvec2>(around));
  if (!window) return 0;
  std::vector<int> present;
  for (const int border : *order) {
    if (border < border_count(*window)) present.push_back(border);
  }
  try {
    const auto clipped =
        clip_to_window(std::span<const dvec2>(points), *window, std::span<const int>(present));
    return all_finite(i) ? vertex_error(clipped, points, *window, present) : wrong;
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
}

/// How many vertices of a batch differ from those of clip_to_window.
double batch_error(const Input& i) {
  const Points points = points_in(i, 4, corners), back(points.rbegin(), points.rend());
  Polygons given, clipped;
  for (const Points& one : {points, back, Points{}, points}) given.add(one);
  sutherland_hodgman::BatchClipper clip;
  try {
    clip(given, rectangle_of(i), clipped);
  } catch (const ContractViolation&) {
    return rectangle_is_taken(i) ? wrong : 0;
  }
  if (!rectangle_is_taken(i)) return wrong;
  if (clipped.size() != given.size()) return wrong;
  double differ = 0;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const Vertices right = clip_to_window(given[k], rectangle_of(i));
    if (clipped[k].size() != right.size()) return wrong;
    for (std::size_t v = 0; v < right.size(); ++v) {
      const dvec2 p = clipped[k][v], q = right[v].at;
      differ += p != q || std::signbit(p.x) != std::signbit(q.x) || std::signbit(p.y) != std::signbit(q.y);
    }
  }
  return differ;
}

Rational area_of(const Vertices& ring) {
  Points points;
  for (const auto& v : ring) points.push_back(v.at);
  return test::exact_area(points);
}

/// How far the areas of the pieces, outlines less holes, are from the polygon's in the window, in parts of
/// what rounding each vertex can do: half an ulp of the window's size, along all edges.
double pieces_error(const Input& i) {
  const auto order = order_in(i.back());
  if (!order) return 0;
  std::vector<Points> rings{points_in(i, 4, corners)};
  const Points hole = points_in(i, hole_at, hole_corners);
  if (std::ranges::any_of(hole, [&](dvec2 p) { return p != hole[0]; })) rings.push_back(hole);
  const Rectangle<double> window = rectangle_of(i);
  Rational area = 0;
  try {
    for (const auto& piece : sutherland_hodgman::separate_pieces(rings, window, *order)) {
      area += area_of(piece.outline);
      for (const auto& ring : piece.holes) area += area_of(ring);
    }
  } catch (const ContractViolation&) {
    return rectangle_is_taken(i) ? wrong : 0;
  }
  if (!rectangle_is_taken(i)) return wrong;
  // The outline runs counter-clockwise, a hole clockwise, and a ring of area 0 as it is given
  Rational right = 0;
  for (const Points& ring : rings) {
    const int turn = test::exact_area(ring).sign(), wanted = &ring == &rings[0] ? 1 : -1;
    right += (turn == 0 ? 1 : turn * wanted) * test::area_in_rectangle(ring, window.lower, window.upper);
  }
  const Rational off = abs(Rational(area - right));
  if (off == 0) return 0;
  const auto largest = std::max({std::abs(i[0]), std::abs(i[1]), std::abs(i[2]), std::abs(i[3])});
  const double before = std::nextafter(largest, 0.0);
  const Rational half_ulp = (Rational(largest) - Rational(before)) / (before < largest ? 1 : 2);
  // An edge is in the window at most once, and two borders or corners follow its ends
  const Rational length = Rational(4 * (corners + hole_corners)) *
                          (Rational(i[2]) - Rational(i[0]) + Rational(i[3]) - Rational(i[1]));
  const Rational most = half_ulp * (length + Rational(4 * (corners + hole_corners)) * half_ulp);
  return static_cast<double>(Rational(off / most));
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
    return Rational(i[10]) * Rational(p.w) + Rational(i[9]) * Rational(p[axis]);
  };
  const Rational from = exact_distance(a), to = exact_distance(b);
  const std::vector<sutherland_hodgman::Point<double>> edge{{a}, {b}};
  const auto kept = clip(std::span<const sutherland_hodgman::Point<double>>(edge), plane);
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
  const Rational t = from / (from - to);
  for (int k = 0; k < 4; ++k) {
    const Rational right = Rational(a[k]) + t * (Rational(b[k]) - Rational(a[k]));
    if (cut[k] != other[k] || !std::isfinite(cut[k])) return wrong;
    if (k == axis) continue;
    worst = std::max(worst, static_cast<double>(abs(Rational(Rational(cut[k]) - right)) / Rational(unit)));
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

}  // namespace

Domain sutherland_hodgman() {
  const auto drawn_as = [](const char* method) {
    return [method](const Input& i) { return rectangle_arguments(i, method); };
  };
  return {
      "sutherland_hodgman",
      {{.name = "clip_to_window",
        .states = "the vertices of the exact polygon, each the nearest double; twice changes nothing",
        .unit = "ulp",
        .bound = 0.5,
        .numbers = rectangle_numbers,
        .generate = at_every_scale(rectangle_input, lengths_of(rectangle_numbers), mend_rectangle),
        .error = rectangle_error,
        .arguments = drawn_as("border_by_border"),
        .traps = rectangle_traps()},
       {.name = "convex_window",
        .states = "the same at borders of any direction",
        .unit = "ulp",
        .bound = 0.5,
        .numbers = convex_numbers,
        .generate = at_every_scale(convex_input, lengths_of(convex_numbers)),
        .error = convex_error,
        .arguments = [](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
          return {{"method", "border_by_border"},
                  {"polygon", points_text(i, 8, corners)},
                  {"window-polygon", points_text(i, 0, 4)}};
        },
        .traps = {{"an edge along a border",
                   {5, -3, 12, 3, 8, 10, -2, 7, 5, -3, 12, 3, 20, 9, 9, 30, 0, 0, 1, 1, 0}},
                  {"a border of one unit in the last place",
                   {1, 1, std::nextafter(1.0, 2.0), 1, 2, 2, 1, 2, 0, 0, 3, 0, 3, 3, 0, 3, 1, 1, 1, 1, 0}}}},
       {.name = "batch",
        .states = "the bits of clip_to_window, polygon by polygon",
        .unit = "vertices",
        .bound = 0,
        .numbers = rectangle_numbers,
        .generate = at_every_scale(rectangle_input, lengths_of(rectangle_numbers), mend_rectangle),
        .error = batch_error,
        .arguments = drawn_as("border_by_border"),
        .traps = rectangle_traps()},
       {.name = "separate_pieces",
        .states = "the area of the pieces, outlines less holes, is the polygon's in the window, but for the "
                  "rounding of vertices",
        .unit = "of rounding",
        .bound = 1,
        .numbers = pieces_numbers,
        .generate = at_every_scale(pieces_input, lengths_of(pieces_numbers), mend_rectangle),
        .error = pieces_error,
        .arguments = pieces_arguments,
        .traps = pieces_traps()},
       {.name = "clip_space",
        .states =
            "before the division: exact sides; a corner on the plane, within 6 ulp of the edge along it",
        .unit = "ulp",
        .bound = 6,
        .numbers = 11,
        .kinds = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::huge, Kind::tiny, Kind::ties,
                  Kind::denormal, Kind::extremes},
        .generate = at_every_scale(plane_input, {0, 1, 2, 3, 4, 5, 6, 7}),
        .error = plane_error,
        .traps = {{"w goes through 0", {1, 0, 1, 2, 1, 0, -1, -1, 2, 1, 0}},
                  {"an end far away", {0, 0, 1, 1, 1e17, 0, -1e17, -1e17, 2, 1, 0}},
                  {"a corner on the plane", {0, 0, 0, 1, 1, 1, -1, 2, 2, 1, 0}},
                  {"roundings that add up",
                   {-0x1.fe378bea0159ap+0, 0, 0x1.cd15b013180cp-1, 0x1.9c22bdcb87772p-4, 0x1.f8c8a5ea5801bp+0,
                    0, -0x1.4ac71a5e3a919p-1, 0x1.4ac717c06ea4p-1, 2, 1, 1}}}}}};
}

}  // namespace gradus::stress
