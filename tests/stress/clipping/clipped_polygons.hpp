#pragma once
// Clipping a polygon at a window: inputs, and how far what comes out is from the polygon in fractions.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <optional>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "stress/clipping/window_polygons.hpp"
#include "stress/last.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"

namespace gradus::stress::clipped_polygons {

using namespace gradus::sutherland_hodgman;
using test::ExactPoint;
using test::Fraction;
using window_polygons::error_at;
using window_polygons::ExactPoints;
using window_polygons::Points;
using Vertices = std::vector<Vertex<double>>;

// --- Inputs: a window, a polygon of six corners, and in which order the borders come ---

inline constexpr std::size_t corners = 6;

inline Points points_in(const Input& i, std::size_t first, std::size_t count) {
  Points points;
  for (std::size_t k = 0; k < count; ++k) points.emplace_back(i[first + 2 * k], i[first + 2 * k + 1]);
  return points;
}
inline void add(Input& input, dvec2 p) {
  input.push_back(p.x);
  input.push_back(p.y);
}

/// A permutation of the four borders, number 0 to 23.
inline std::optional<std::vector<int>> order_in(double number) {
  if (number != std::floor(number) || !(0 <= number && number < 24)) return std::nullopt;
  std::vector<int> order{0, 1, 2, 3};
  for (int i = 0; i < static_cast<int>(number); ++i) std::next_permutation(order.begin(), order.end());
  return order;
}

/// A polygon that goes with a window's corners: of the kind, or touching the window.
inline void add_polygon(Input& input, Kind kind, const Points& window, Random& random) {
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

inline void refuse(Input& input, std::size_t first, Random& random) {
  const auto last = static_cast<std::int64_t>(input.size()) - 2;
  const auto at = static_cast<std::size_t>(random.uniform_int(static_cast<std::int64_t>(first), last));
  input[at] = random.unit() < 0.5 ? std::nan("") : wrong;
}

/// Lower and upper corner of a rectangle, a polygon, an order.
inline Input rectangle_input(Kind kind, Random& random) {
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
inline constexpr std::size_t rectangle_numbers = 4 + 2 * corners + 1;

/// The same with a ring of four corners before the order: a hole, or one that crosses the polygon, or none
/// where all corners are one.
inline constexpr std::size_t hole_corners = 4, hole_at = 4 + 2 * corners;
inline constexpr std::size_t pieces_numbers = hole_at + 2 * hole_corners + 1;
inline Input pieces_input(Kind kind, Random& random) {
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
inline std::vector<std::size_t> lengths_of(std::size_t numbers) {
  std::vector<std::size_t> lengths(numbers - 1);
  std::iota(lengths.begin(), lengths.end(), std::size_t{0});
  return lengths;
}
inline void mend_rectangle(Input& input) {
  put_in_order(input[0], input[2]);
  put_in_order(input[1], input[3]);
}

inline Rectangle<double> rectangle_of(const Input& i) { return {{i[0], i[1]}, {i[2], i[3]}}; }
inline bool rectangle_is_taken(const Input& i) { return all_finite(i) && i[0] <= i[2] && i[1] <= i[3]; }

/// Four corners of a convex window, a polygon, an order.
inline Input convex_input(Kind kind, Random& random) {
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
inline constexpr std::size_t convex_numbers = 8 + 2 * corners + 1;

// --- Vertices ---

/// Without what repeats the one before it, all round.
template <class Point>
std::vector<Point> without_repeats(const std::vector<Point>& ring, const Points& places) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (places[i] != places[(i + 1) % ring.size()]) kept.push_back(ring[i]);
  }
  return kept;
}
inline Points places_of(const Vertices& ring) {
  Points places;
  for (const auto& v : ring) places.push_back(v.at);
  return places;
}

/// The worst vertex of a clipped polygon, in ulp; wrong unless its vertices are those of the exact one in
/// their order, but for those that round to one place.
inline double vertex_error(const Vertices& clipped, const Points& given, const ExactPoints& whole) {
  for (std::size_t i = 0; i < clipped.size(); ++i) {
    const auto &v = clipped[i], &next = clipped[(i + 1) % clipped.size()];
    // Given vertices are copied, made ones repeat no neighbour
    if (!v.made() && v.at != given[static_cast<std::size_t>(v.input)]) return wrong;
    if ((v.made() || next.made()) && v.at == next.at) return wrong;
  }
  Points rounded;
  std::ranges::transform(whole, std::back_inserter(rounded), window_polygons::rounded);
  const ExactPoints exact = without_repeats(whole, rounded);
  if (clipped.empty()) return exact.size() < 3 ? 0 : wrong;
  const Points places = places_of(clipped), found = without_repeats(places, places);
  if (found.size() != exact.size()) return wrong;
  // Either may begin anywhere
  double best = exact.empty() ? 0 : wrong;
  for (std::size_t first = 0; first < found.size() && best > 0.5; ++first) {
    double worst = 0;
    for (std::size_t i = 0; i < found.size() && worst < best; ++i) {
      worst = std::max(worst, error_at(found[(first + i) % found.size()], exact[i]));
    }
    best = std::min(best, worst);
  }
  return best;
}

/// Where a vertex is without rounding, from what it remembers.
template <class Window>
ExactPoint place_of(const Scene<double, Window>& scene, const Vertex<double>& v) {
  if (!v.made()) return test::exact_point(scene.polygon[v.input]);
  const Segment<2, double> a = scene.line(v.edge), b = scene.line(v.border);
  return test::exact_crossing(test::exact_point(a.a), test::exact_point(a.b), test::exact_point(b.a),
                              test::exact_point(b.b));
}

/// Whether what each vertex of a ring remembers leads to its place, and on the right side of every border.
template <class Window>
bool remembers(const Vertices& ring, const Scene<double, Window>& scene) {
  const auto borders = window_polygons::borders_of(scene.window);
  return std::ranges::all_of(ring, [&](const Vertex<double>& v) {
    const ExactPoint place = place_of(scene, v);
    for (int border = 0; border < border_count(scene.window); ++border) {
      const int side = side_of_border(scene, border, v);
      if (side < 0 || side != borders[static_cast<std::size_t>(border)].at(place).sign()) return false;
    }
    return test::is_nearest(v.at.x, place.x) && test::is_nearest(v.at.y, place.y);
  });
}

template <class Window>
Fraction remembered_area(const Vertices& ring, const Scene<double, Window>& scene) {
  ExactPoints exact;
  for (const auto& v : ring) exact.push_back(place_of(scene, v));
  return test::exact_area(exact);
}

/// The error of a polygon clipped at a window, with all that is said of its vertices.
template <class Window>
double clipped_error(const Vertices& clipped, const Points& points, const Window& window,
                     const std::vector<int>& order) {
  if (!remembers(clipped, Scene<double, Window>{{points}, window})) return wrong;
  return vertex_error(clipped, points, window_polygons::exact_part(points, window, order));
}

inline double rectangle_error(const Input& i) {
  const auto order = order_in(i.back());
  if (!order) return 0;
  const Points points = points_in(i, 4, corners);
  const Rectangle<double> window = rectangle_of(i);
  Vertices clipped;
  try {
    clipped = clip_to_window(points, window, *order);
  } catch (const ContractViolation&) {
    return rectangle_is_taken(i) ? wrong : 0;
  }
  if (!rectangle_is_taken(i)) return wrong;
  // Clipping twice changes nothing
  const Points once = places_of(clipped);
  if (once != places_of(clip_to_window(once, window))) return wrong;
  return clipped_error(clipped, points, window, *order);
}

/// The window, if the numbers make one, and its borders in their order.
struct Oblique {
  ConvexWindow<double> window;
  std::vector<int> order;
};
inline std::optional<Oblique> oblique_in(const Input& i) {
  const auto order = order_in(i.back());
  if (!order || !all_finite(Input(i.begin(), i.begin() + 8))) return std::nullopt;
  const auto window = convex_window(points_in(i, 0, 4));
  if (!window) return std::nullopt;
  Oblique oblique{*window, *order};
  std::erase_if(oblique.order, [&](int border) { return border >= border_count(*window); });
  return oblique;
}

inline double convex_error(const Input& i) {
  const auto oblique = oblique_in(i);
  if (!oblique) return 0;
  const Points points = points_in(i, 8, corners);
  try {
    const Vertices clipped = clip_to_window(points, oblique->window, oblique->order);
    return all_finite(i) ? clipped_error(clipped, points, oblique->window, oblique->order) : wrong;
  } catch (const ContractViolation&) {
    return all_finite(i) ? wrong : 0;
  }
}
inline bool has_bridge(const Input& i) {
  if (!rectangle_is_taken(i)) return false;
  const Points points = points_in(i, 4, corners);
  return !bridges(clip_to_window(points, rectangle_of(i)), points, rectangle_of(i)).empty();
}

/// 0 where the polygon the other way round comes to the same places.
inline double turned_error(const Input& i) {
  if (!rectangle_is_taken(i)) return 0;
  const auto sorted = [&](const Points& points) {
    Points places = places_of(clip_to_window(points, rectangle_of(i)));
    std::ranges::sort(places, {}, [](dvec2 p) { return std::pair(p.x, p.y); });
    return places;
  };
  const Points points = points_in(i, 4, corners);
  return sorted(points) == sorted({points.rbegin(), points.rend()}) ? 0 : wrong;
}

}  // namespace gradus::stress::clipped_polygons
