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
#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "stress/clipping/window_polygons.hpp"
#include "stress/last.hpp"
#include "stress/numbers.hpp"
#include "stress/scales.hpp"
#include "support/touching_regions.hpp"

namespace gradus::stress {
namespace {

using namespace gradus::sutherland_hodgman;
using test::ExactPoint;
using test::Fraction;
using window_polygons::error_at;
using window_polygons::ExactPoints;
using window_polygons::Points;
using Vertices = std::vector<Vertex<double>>;

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
Points places_of(const Vertices& ring) {
  Points places;
  for (const auto& v : ring) places.push_back(v.at);
  return places;
}

/// The worst vertex of a clipped polygon, in ulp; wrong unless its vertices are those of the exact one in
/// their order, but for those that round to one place.
double vertex_error(const Vertices& clipped, const Points& given, const ExactPoints& whole) {
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

double rectangle_error(const Input& i) {
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
std::optional<Oblique> oblique_in(const Input& i) {
  const auto order = order_in(i.back());
  if (!order || !all_finite(Input(i.begin(), i.begin() + 8))) return std::nullopt;
  const auto window = convex_window(points_in(i, 0, 4));
  if (!window) return std::nullopt;
  Oblique oblique{*window, *order};
  std::erase_if(oblique.order, [&](int border) { return border >= border_count(*window); });
  return oblique;
}

double convex_error(const Input& i) {
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
bool has_bridge(const Input& i) {
  if (!rectangle_is_taken(i)) return false;
  const Points points = points_in(i, 4, corners);
  return !bridges(clip_to_window(points, rectangle_of(i)), points, rectangle_of(i)).empty();
}

/// 0 where the polygon the other way round comes to the same places.
double turned_error(const Input& i) {
  if (!rectangle_is_taken(i)) return 0;
  const auto sorted = [&](const Points& points) {
    Points places = places_of(clip_to_window(points, rectangle_of(i)));
    std::ranges::sort(places, {}, [](dvec2 p) { return std::pair(p.x, p.y); });
    return places;
  };
  const Points points = points_in(i, 4, corners);
  return sorted(points) == sorted({points.rbegin(), points.rend()}) ? 0 : wrong;
}

// --- Many at once ---

/// The polygon, others beside it, and none.
Polygons batch_of(const Input& i) {
  const Points points = points_in(i, 4, corners), back(points.rbegin(), points.rend());
  Points half = points;
  for (dvec2& p : half) p = 0.5 * p + 0.5 * points[0];
  Polygons given;
  for (const Points& one : {points, back, Points{}, half, points}) given.add(one);
  return given;
}

/// How many vertices of a batch differ from those of clip_to_window.
double batch_error(const Input& i) {
  if (!order_in(i.back())) return 0;
  const Polygons given = batch_of(i);
  Polygons clipped;
  BatchClipper clip;
  BatchCount count;
  try {
    count = clip(given, rectangle_of(i), clipped);
  } catch (const ContractViolation&) {
    return rectangle_is_taken(i) ? wrong : 0;
  }
  if (!rectangle_is_taken(i)) return wrong;
  if (clipped.size() != given.size()) return wrong;
  if (count.copied + count.dropped + count.clipped != given.size()) return wrong;
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
/// A share of what becomes of batches.
Share batch_share(const char* of, double least, std::size_t BatchCount::* part) {
  return {of, least, [part](const Input& i) {
            if (!rectangle_is_taken(i)) return false;
            Polygons clipped;
            return BatchClipper{}(batch_of(i), rectangle_of(i), clipped).*part > 0;
          }};
}

// --- Pieces ---

/// What pieces have of the area of rings in a window, without rounding and with it, and what is right.
struct PieceAreas {
  Fraction remembered = 0, rounded = 0, right = 0;
  bool vertices_are_right = true;
};
template <class Window>
PieceAreas piece_areas(const std::vector<Points>& rings, const Window& window, std::span<const int> order) {
  const Rings<double> polygon(rings);
  const auto scene = scene_of(polygon, window);
  PieceAreas areas;
  const auto add = [&](const Vertices& ring) {
    areas.rounded += test::exact_area(places_of(ring));
    areas.remembered += remembered_area(ring, scene);
    areas.vertices_are_right &= remembers(ring, scene);
  };
  for (const auto& piece : separate_pieces(polygon, window, order)) {
    add(piece.outline);
    std::ranges::for_each(piece.holes, add);
    areas.vertices_are_right &= piece.outline.size() >= 3;
  }
  // The outline runs counter-clockwise, a hole clockwise, and a ring of area 0 as it is given
  for (const Points& ring : rings) {
    const int turn = test::exact_area(ring).sign(), wanted = &ring == &rings[0] ? 1 : -1;
    areas.right += (turn == 0 ? 1 : turn * wanted) * window_polygons::area_in(ring, window);
  }
  return areas;
}

/// How far the areas of the pieces, outlines less holes, are from the polygon's in the window, in parts of
/// what rounding each vertex can do: half an ulp of the window's size, along all edges.
double rounding_error(const PieceAreas& areas, dvec2 lower, dvec2 upper) {
  if (!areas.vertices_are_right) return wrong;
  const Fraction off = abs(Fraction(areas.rounded - areas.right));
  if (off == 0) return 0;
  const auto largest = std::max({std::abs(lower.x), std::abs(lower.y), std::abs(upper.x), std::abs(upper.y)});
  const double before = std::nextafter(largest, 0.0);
  const Fraction half_ulp = (Fraction(largest) - Fraction(before)) / (before < largest ? 1 : 2);
  // An edge is in the window at most once, and two borders or corners follow its ends
  const Fraction length = Fraction(4 * (corners + hole_corners)) *
                          (Fraction(upper.x) - Fraction(lower.x) + Fraction(upper.y) - Fraction(lower.y));
  const Fraction most = half_ulp * (length + Fraction(4 * (corners + hole_corners)) * half_ulp);
  return static_cast<double>(Fraction(off / most));
}

std::vector<Points> rings_in(const Input& i) {
  std::vector<Points> rings{points_in(i, 4, corners)};
  const Points hole = points_in(i, hole_at, hole_corners);
  if (std::ranges::any_of(hole, [&](dvec2 p) { return p != hole[0]; })) rings.push_back(hole);
  return rings;
}

double pieces_error(const Input& i) {
  const auto order = order_in(i.back());
  if (!order) return 0;
  const Rectangle<double> window = rectangle_of(i);
  PieceAreas areas;
  try {
    areas = piece_areas(rings_in(i), window, *order);
  } catch (const ContractViolation&) {
    return rectangle_is_taken(i) ? wrong : 0;
  }
  return rectangle_is_taken(i) ? rounding_error(areas, window.lower, window.upper) : wrong;
}

/// The larger error of a polygon in a window of any direction and in the rectangle between two of its
/// corners, and whether both ways to clip have exactly the area: always, unless vertices that round to one
/// were left out.
struct WholeAreas {
  double error = 0;
  bool exact = true, oblique = false;
};
template <class Window>
void look_at(WholeAreas& all, const Points& points, const Window& window, std::span<const int> order,
             dvec2 lower, dvec2 upper) {
  const PieceAreas areas = piece_areas({points}, window, order);
  const Scene<double, Window> scene{{points}, window};
  const Fraction whole = remembered_area(clip_to_window(std::span(points), window, order), scene);
  // Pieces run counter-clockwise
  const bool turned = test::exact_area(points) < 0;
  all.exact &= areas.remembered == areas.right && areas.right == (turned ? -whole : whole);
  all.error = std::max(all.error, rounding_error(areas, lower, upper));
}
WholeAreas whole_areas(const Input& i) {
  WholeAreas all;
  const auto oblique = all_finite(i) ? oblique_in(i) : std::nullopt;
  const auto order = order_in(i.back());
  if (!all_finite(i) || !order) return all;
  const Points points = points_in(i, 8, corners), around = points_in(i, 0, 4);
  const dvec2 low = glm::min(around[0], around[2]), high = glm::max(around[0], around[2]);
  look_at(all, points, Rectangle<double>{low, high}, *order, low, high);
  if (!oblique) return all;
  all.oblique = true;
  const dvec2 lower = glm::min(low, glm::min(around[1], around[3]));
  look_at(all, points, oblique->window, oblique->order, lower,
          glm::max(high, glm::max(around[1], around[3])));
  return all;
}

// --- Pieces of regions that are counted ---

/// A region of triangles in squares of a grid: the side of the grid, which triangles there are (two numbers
/// of 49 bits), whether it is made twice as fine, the window (left, bottom, right, top), an affine map, a
/// power of two, and what tells the rings one way or another.
struct PartsCase {
  test::TriangleRegion region{1};
  std::vector<Points> rings;
  glm::ivec2 low, high;
  dvec2 x, y, origin;
  double scale = 1;
};
constexpr std::size_t parts_numbers = 16;

Input parts_input(Kind, Random& random) {
  const auto whole = [&](double low, double high) { return std::floor(random.uniform(low, high + 1)); };
  const double side = whole(3, 7), fine = whole(0, 1), end = side * (1 + fine) + 1;
  const double density = random.uniform(0.45, 0.9);
  Input input{side, 0, 0, fine};
  for (int bit = 0; bit < 98; ++bit) {
    if (random.unit() < density) input[bit < 49 ? 1 : 2] += std::ldexp(1.0, bit % 49);
  }
  const double left = whole(-1, 2), bottom = whole(-1, 2);
  const double right = whole(left + 1, end), top = whole(std::max(bottom + 1, end - 2), end);
  input.insert(input.end(), {left, bottom, right, top});
  for (int k = 0; k < 6; ++k) input.push_back(whole(-5, 5));
  input.push_back(whole(-1074, 1000));
  input.push_back(whole(0, 1 << 30));
  return input;
}

std::optional<PartsCase> parts_in(const Input& i) {
  const auto whole = [&](std::size_t k, double low, double high) {
    return std::floor(i[k]) == i[k] && low <= i[k] && i[k] <= high;
  };
  if (!whole(0, 1, 7) || !whole(1, 0, 0x1p49 - 1) || !whole(2, 0, 0x1p49 - 1) || !whole(3, 0, 1)) {
    return std::nullopt;
  }
  const int side = static_cast<int>(i[0]), most = side * (i[3] == 0 ? 1 : 2) + 1;
  for (std::size_t k = 4; k < 8; ++k) {
    if (!whole(k, -1, most)) return std::nullopt;
  }
  for (std::size_t k = 8; k < 14; ++k) {
    if (!whole(k, -5, 5)) return std::nullopt;
  }
  if (!(i[4] < i[6] && i[5] < i[7]) || !whole(14, -1074, 1000) || !whole(15, 0, 0x1p30)) return std::nullopt;
  test::TriangleRegion region(side);
  for (std::size_t k = 0; k < region.there.size(); ++k) {
    const auto bits = static_cast<std::uint64_t>(i[k < 49 ? 1 : 2]);
    region.there[k] = (bits >> (k % 49)) % 2 == 1;
  }
  region = region.largest_part();
  if (i[3] == 1) region = region.refined();
  PartsCase made{region,         {},
                 {i[4], i[5]},   {i[6], i[7]},
                 {i[8], i[9]},   {i[10], i[11]},
                 {i[12], i[13]}, std::ldexp(1.0, static_cast<int>(i[14]))};
  Random random(static_cast<std::uint64_t>(i[15]));
  for (const auto& ring : test::RegionRings(region).polygon(random)) {
    made.rings.push_back(test::told_otherwise(ring, random));
  }
  if (made.rings.empty()) return std::nullopt;
  return made;
}

/// Whether the rings of a piece pass no point twice, have the inside left, and touch once at most.
bool is_valid(const Piece<double>& piece) {
  std::vector<std::set<std::pair<double, double>>> points;
  const auto is_ring = [&](const Vertices& ring, int turn) {
    auto& own = points.emplace_back();
    for (const auto& v : ring) own.emplace(v.at.x, v.at.y);
    return own.size() == ring.size() && test::exact_area(places_of(ring)).sign() == turn;
  };
  if (!is_ring(piece.outline, 1)) return false;
  for (const auto& hole : piece.holes) {
    if (!is_ring(hole, -1)) return false;
  }
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      if (std::ranges::count_if(points[a], [&](const auto& p) { return points[b].contains(p); }) > 1) {
        return false;
      }
    }
  }
  return true;
}

/// Whether the pieces are the connected parts of a region, told by their areas and by how many rings there
/// are.
template <class Window>
bool are_parts(const std::vector<Points>& rings, const Window& window, const test::TriangleRegion& inside,
               const Fraction& triangle) {
  std::vector<Fraction> areas, wanted;
  int simple = 0, wanted_simple = 0;
  for (const auto& piece : separate_pieces(rings, window)) {
    if (!is_valid(piece)) return false;
    Fraction& area = areas.emplace_back(test::exact_area(places_of(piece.outline)));
    for (const auto& hole : piece.holes) area += test::exact_area(places_of(hole));
    simple += 1 + static_cast<int>(piece.holes.size());
  }
  for (const auto& part : inside.apart()) {
    wanted.push_back(part.count() * triangle);
    wanted_simple += test::RegionRings(part).simple_rings();
  }
  std::ranges::sort(areas);
  std::ranges::sort(wanted);
  return areas == wanted && simple == wanted_simple;
}

double parts_error(const Input& i) {
  const auto& given = last_of<parts_in>(i);
  if (!given) return 0;
  const auto& [region, rings, low, high, x, y, origin, scale] = *given;
  const auto mapped = [](std::vector<Points> all, const auto& map) {
    for (Points& ring : all) std::ranges::transform(ring, ring.begin(), map);
    return all;
  };
  // The whole and the part in the window, at a scale
  const auto scaled = mapped(rings, [&](dvec2 p) { return scale * p; });
  const int side = region.all.side();
  const Fraction triangle = Fraction(scale) * Fraction(scale) / 2;
  const Rectangle<double> whole{dvec2(-1) * scale, dvec2(side + 1) * scale};
  const test::TriangleRegion inside = region.within(low, high);
  if (!are_parts(scaled, whole, region, triangle)) return wrong;
  if (!are_parts(scaled, Rectangle<double>{dvec2(low) * scale, dvec2(high) * scale}, inside, triangle)) {
    return wrong;
  }
  // Borders of any direction
  const double det = x.x * y.y - x.y * y.x;
  if (det == 0) return 0;
  const auto oblique = [&](dvec2 p) { return origin + p.x * x + p.y * y; };
  const dvec2 l(low), h(high);
  const Points around = mapped({{l, {h.x, l.y}, h, {l.x, h.y}}}, oblique)[0];
  const auto window = convex_window(around);
  if (!window) return wrong;
  return are_parts(mapped(rings, oblique), *window, inside, Fraction(std::abs(det)) / 2) ? 0 : wrong;
}

template <class Holds>
Share share_of_parts(const char* of, double least, Holds holds) {
  return {of, least, [holds](const Input& i) {
            const auto& given = last_of<parts_in>(i);
            return given && holds(*given);
          }};
}
std::size_t pieces_in(const PartsCase& of) { return of.region.within(of.low, of.high).apart().size(); }

// --- Whether rings touch ---

/// A shape (0 a star, 1 a region of triangles, 2 and 3 places on a fine and a coarse grid), a number of
/// vertices, what tells it, and a power of two.
constexpr std::size_t touch_numbers = 4;
Input touch_input(Kind, Random& random) {
  const double shape = static_cast<double>(random.uniform_int(0, 3));
  const auto vertices = random.uniform_int(3, random.unit() < 0.1 ? 200 : 30);
  const auto told = random.uniform_int(0, 1 << 30);
  return {shape, static_cast<double>(vertices), static_cast<double>(told),
          static_cast<double>(random.uniform_int(-1074, 1000))};
}

std::vector<Points> touch_rings(const Input& i) {
  const auto whole = [&](std::size_t k, double low, double high) {
    return std::floor(i[k]) == i[k] && low <= i[k] && i[k] <= high;
  };
  if (!whole(0, 0, 3) || !whole(1, 3, 200) || !whole(2, 0, 0x1p30) || !whole(3, -1074, 1000)) return {};
  Random random(static_cast<std::uint64_t>(i[2]));
  const int vertices = static_cast<int>(i[1]);
  std::vector<Points> rings;
  if (i[0] == 1) {
    const auto region = test::random_region(static_cast<int>(random.uniform_int(2, 7)), random);
    for (const auto& ring : test::RegionRings(region).polygon(random)) {
      rings.push_back(test::told_otherwise(ring, random));
    }
  } else {
    Points& ring = rings.emplace_back();
    const double nearest = random.uniform(0.05, 1);
    const int places = i[0] == 2 ? 1 << 20 : vertices;
    for (int k = 0; k < vertices; ++k) {
      const SinCos at = sin_cos(0x1.921fb54442d18p2 * k / vertices);
      ring.push_back(i[0] == 0 ? random.uniform(nearest, 1) * dvec2(at.cos, at.sin)
                               : dvec2(random.uniform_int(0, places), random.uniform_int(0, places)));
    }
  }
  for (Points& ring : rings) {
    for (dvec2& p : ring) p *= std::ldexp(1.0, static_cast<int>(i[3]));
  }
  return rings;
}

/// Whether rings touch, by all pairs of edges and vertices.
bool any_touch(const Outline<double>& polygon) {
  const int n = static_cast<int>(polygon.points.size());
  for (int i = 0; i < n; ++i) {
    const int next = polygon.after(i);
    const Segment<2, double> edge{polygon[i], polygon[next]};
    if (polygon.after(next) == i) return true;
    for (int k = 0; k < n; ++k) {
      const dvec2 v = polygon[k], low = glm::min(edge.a, edge.b), high = glm::max(edge.a, edge.b);
      if (k == i || k == next || v.x < low.x || v.y < low.y || high.x < v.x || high.y < v.y) continue;
      if (side(edge, v) == 0) return true;
    }
  }
  return false;
}

/// What is said of rings, by each way to find it out.
struct Touching {
  bool right, round_a_point, by_sweep;
  std::optional<bool> by_boxes;
};
std::optional<Touching> touching(const Input& i) {
  const std::vector<Points> given = touch_rings(i);
  if (given.empty()) return std::nullopt;
  const Rings<double> rings(given);
  const Outline<double> outline{rings.points, rings.next};
  return Touching{any_touch(outline), given.size() == 1 && goes_round_a_point(outline),
                  rings.touch || TouchingRings<double>(outline).touch(),
                  TouchSearch<double>(outline).answer()};
}
double touch_error(const Input& i) {
  const auto& found = last_of<touching>(i);
  if (!found) return 0;
  const auto& [right, round_a_point, by_sweep, by_boxes] = *found;
  // Where rings cross, the sweep may miss one; where they don't touch it sees none
  const bool false_alarm = !right && by_sweep;
  return (by_boxes && *by_boxes != right) || (round_a_point && right) || false_alarm ? wrong : 0;
}
template <class Holds>
Share share_of_touching(const char* of, double least, Holds holds) {
  return {of, least, [holds](const Input& i) {
            const auto& found = last_of<touching>(i);
            return found && holds(*found);
          }};
}

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

/// Three corners and how far out the guard planes lie; mostly before the eye, some very far away.
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
Property batches() {
  Property property = of_rectangles("batch", "the bits of clip_to_window, polygon by polygon", batch_error);
  property.shares = {batch_share("copies polygons", 0.01, &BatchCount::copied),
                     batch_share("drops polygons", 0.05, &BatchCount::dropped),
                     batch_share("clips polygons", 0.25, &BatchCount::clipped)};
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
      {"all before the eye", 1,
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
           pieces(), areas(), parts(), touching_rings(), lines(), planes(), volumes()}};
}

}  // namespace gradus::stress
