#pragma once
// Separate pieces of regions in a window: their areas in fractions, and regions that are counted.

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "core/arithmetic/elementary.hpp"
#include "stress/clipping/clipped_polygons.hpp"
#include "support/touching_regions.hpp"

namespace gradus::stress::clipped_pieces {

using namespace clipped_polygons;

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
inline double rounding_error(const PieceAreas& areas, dvec2 lower, dvec2 upper) {
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

inline std::vector<Points> rings_in(const Input& i) {
  std::vector<Points> rings{points_in(i, 4, corners)};
  const Points hole = points_in(i, hole_at, hole_corners);
  if (std::ranges::any_of(hole, [&](dvec2 p) { return p != hole[0]; })) rings.push_back(hole);
  return rings;
}

inline double pieces_error(const Input& i) {
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
inline WholeAreas whole_areas(const Input& i) {
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
inline constexpr std::size_t parts_numbers = 16;

inline Input parts_input(Kind, Random& random) {
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

inline std::optional<PartsCase> parts_in(const Input& i) {
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
inline bool is_valid(const Piece<double>& piece) {
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

inline double parts_error(const Input& i) {
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
inline std::size_t pieces_in(const PartsCase& of) { return of.region.within(of.low, of.high).apart().size(); }

// --- Whether rings touch ---

/// A shape (0 a star, 1 a region of triangles, 2 and 3 places on a fine and a coarse grid), a number of
/// vertices, what tells it, and a power of two.
inline constexpr std::size_t touch_numbers = 4;
inline Input touch_input(Kind, Random& random) {
  const double shape = static_cast<double>(random.uniform_int(0, 3));
  const auto vertices = random.uniform_int(3, random.unit() < 0.1 ? 200 : 30);
  const auto told = random.uniform_int(0, 1 << 30);
  return {shape, static_cast<double>(vertices), static_cast<double>(told),
          static_cast<double>(random.uniform_int(-1074, 1000))};
}

inline std::vector<Points> touch_rings(const Input& i) {
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
                               : dvec2{random.uniform_int(0, places), random.uniform_int(0, places)});
    }
  }
  for (Points& ring : rings) {
    for (dvec2& p : ring) p *= std::ldexp(1.0, static_cast<int>(i[3]));
  }
  return rings;
}

/// Whether rings touch, by all pairs of edges and vertices.
inline bool any_touch(const Outline<double>& polygon) {
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
inline std::optional<Touching> touching(const Input& i) {
  const std::vector<Points> given = touch_rings(i);
  if (given.empty()) return std::nullopt;
  const Rings<double> rings(given);
  const Outline<double> outline{rings.points, rings.next};
  return Touching{any_touch(outline), given.size() == 1 && goes_round_a_point(outline),
                  rings.touch || TouchingRings<double>(outline).touch(),
                  TouchSearch<double>(outline).answer()};
}
inline double touch_error(const Input& i) {
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

}  // namespace gradus::stress::clipped_pieces
