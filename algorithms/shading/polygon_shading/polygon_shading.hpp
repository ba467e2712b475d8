#pragma once
// Three ways to colour the pixels of a polygon, by how often light is computed: once per polygon (flat), once
// per corner (Gouraud), once per pixel (Phong). All walk the same scan lines; what is lit, and what is
// interpolated along them, differs. And the normals at vertices that the last two need.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <ranges>
#include <span>
#include <utility>

#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/exact.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"

namespace gradus::polygon_shading {

/// A place on a surface, and the normal there: what light is computed from.
template <class T>
struct Surface {
  glm::vec<3, T> place, normal;
};

/// A corner of a polygon on the screen, y up, a pixel (i, j) having its centre at (i + 0.5, j + 0.5), and
/// what the corner brings along: a colour, or a Surface.
template <class T, class Value>
struct Corner {
  glm::vec<2, T> at;
  Value value;
};

/// Where a scan line meets the border: `part` of the way from the edge's lower corner to its upper one. Of
/// the left end the part is called alpha, of the right one beta.
template <class T>
struct End {
  std::size_t lower, upper;  ///< numbers of the edge's corners
  T part;                    ///< in [0, 1]
  T x;
};

// --- Steps -------------------------------------------------------

/// Light was computed for the whole polygon.
template <class T, class Colour>
struct PolygonLit {
  Surface<T> middle;
  Colour colour;
};

/// Light was computed at a vertex.
template <class Colour>
struct VertexLit {
  std::size_t vertex;
  Colour colour;
};

/// A scan line begins; both ends have what their edges' corners bring along, mixed.
template <class T, class Value>
struct RowBegun {
  int row;
  End<T> left, right;
  Value at_left, at_right;
};

/// A pixel has its colour.
template <class T, class Value, class Colour>
struct Shaded {
  ivec2 pixel;
  T gamma;        ///< the part of the way from the left end to the right one
  Value between;  ///< what was interpolated: a colour, or a Surface whose normal has length 1 again
  T length;       ///< of the normal before; 1 where none is interpolated
  Colour colour;
};

/// The same where colours are interpolated, or none is.
template <class T, class Colour>
Shaded<T, Colour, Colour> plain(ivec2 pixel, T gamma, const Colour& colour) {
  return {pixel, gamma, colour, T(1), colour};
}

/// The same where surfaces are: as they were mixed, and with normals of length 1.
template <class T, class Colour>
Shaded<T, Surface<T>, Colour> smooth(ivec2 pixel, T gamma, const Surface<T>& mixed, const Surface<T>& between,
                                     const Colour& colour) {
  return {pixel, gamma, between, length_of(mixed.normal), colour};
}

/// The polygon is done.
struct Finished {
  std::int64_t pixels;  ///< that were plotted
  std::int64_t lights;  ///< how often light was computed
};

/// Counts both.
struct Work {
  std::int64_t pixels = 0, lights = 0;

  template <class T, class Colour>
  const PolygonLit<T, Colour>& operator()(const PolygonLit<T, Colour>& step) {
    ++lights;
    return step;
  }
  template <class T, class Value, class Colour>
  const Shaded<T, Value, Colour>& operator()(const Shaded<T, Value, Colour>& step) {
    ++pixels;
    lights += std::same_as<Value, Surface<T>>;
    return step;
  }
  Finished operator()(Finished) const { return {pixels, lights}; }
};

// --- Scan lines --------------------------------------------------

/// Farthest from 0 that a corner may lie, in pixels.
inline constexpr double farthest = 1 << 24;

/// (1 - part) a + part b. Between a and b but for 2 roundings.
template <class T, class Value>
Value mix(const Value& a, const Value& b, T part) {
  return (T(1) - part) * a + part * b;
}
template <class T>
Surface<T> mix(const Surface<T>& a, const Surface<T>& b, T part) {
  return {mix(a.place, b.place, part), mix(a.normal, b.normal, part)};
}

/// The least whole number i whose pixel's centre, i + 0.5, does not lie below x.
template <class T>
int first_centre(T x) {
  using std::ceil;
  return static_cast<int>(ceil(x - T(0.5)));
}

/// Whether the corners lie on no line, exactly: the rounded ends of a line's rows may lie apart.
template <class T, class Value>
bool has_area(std::span<const Corner<T, Value>> polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i)
    if (orient2d(polygon[0].at, polygon[i - 1].at, polygon[i].at) != 0) return true;
  return false;
}

/// The rows whose centres lie within the polygon's height; none where it has no area.
template <class T, class Value>
auto rows(std::span<const Corner<T, Value>> polygon, const Window& picture) {
  const auto below = [](const auto& a, const auto& b) { return a.at.y < b.at.y; };
  const auto [low, high] = std::ranges::minmax_element(polygon, below);
  const int first = std::max(first_centre(low->at.y), picture.lower.y);
  const int end = has_area(polygon) ? std::min(first_centre(high->at.y), picture.upper.y + 1) : first;
  return std::views::iota(first, std::max(first, end));
}

/// Where the line through the row's centres meets the border of a convex polygon: left end, right end.
/// An edge takes part from its lower corner on and before its upper one, so that each row has two ends. It is
/// gone along from below whichever way it runs: polygons that share it share the end to the last bit.
template <class T, class Value>
std::pair<End<T>, End<T>> ends(std::span<const Corner<T, Value>> polygon, int row) {
  const T y = T(row) + T(0.5);
  End<T> both[2]{};
  std::size_t found = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    std::size_t lower = i, upper = i + 1 < polygon.size() ? i + 1 : 0;
    if (polygon[upper].at.y < polygon[lower].at.y) std::swap(lower, upper);
    const auto &a = polygon[lower].at, &b = polygon[upper].at;
    if (!(a.y <= y && y < b.y)) continue;
    const T part = (y - a.y) / (b.y - a.y);
    both[found == 0 ? 0 : 1] = {lower, upper, part,
                                std::clamp(mix(a.x, b.x, part), std::min(a.x, b.x), std::max(a.x, b.x))};
    ++found;
  }
  if (both[1].x < both[0].x) std::swap(both[0], both[1]);
  return {both[0], both[1]};
}

/// The columns whose centres lie from the left end on and before the right one.
template <class T>
auto columns(const End<T>& left, const End<T>& right, const Window& picture) {
  const int first = std::max(first_centre(left.x), picture.lower.x);
  return std::views::iota(first, std::max(first, std::min(first_centre(right.x), picture.upper.x + 1)));
}

/// How far the centre of a column lies between the ends: gamma, in [0, 1].
template <class T>
T between(const End<T>& left, const End<T>& right, int column) {
  return (T(column) + T(0.5) - left.x) / (right.x - left.x);
}

/// What both corners of an edge bring along, mixed where the scan line meets it.
template <class T, class Value>
Value at_end(std::span<const Corner<T, Value>> polygon, const End<T>& end) {
  return mix(polygon[end.lower].value, polygon[end.upper].value, end.part);
}

template <class T, class Value>
void expect_polygon(std::span<const Corner<T, Value>> polygon) {
  expects(polygon.size() >= 3, "a polygon has at least 3 corners, not {}", polygon.size());
  for (const auto& corner : polygon) {
    using std::abs;
    const bool near = abs(corner.at.x) <= T(farthest) && abs(corner.at.y) <= T(farthest);
    expects(near, "corners within {} pixels were expected", farthest);
  }
}

/// What light gives at a place of a surface.
template <class T, class Light>
auto lit(Light& light, const Surface<T>& at) {
  return light(at.place, at.normal);
}

// --- Flat --------------------------------------------------------

/// The mean of a polygon's places, and the normal of its plane by Newell's sum: of length 1, or zero where
/// the polygon has no area.
template <class T>
Surface<T> middle_of(std::span<const Corner<T, Surface<T>>> polygon) {
  const auto origin = polygon[0].value.place;
  glm::vec<3, T> sum{T(0)}, normal{T(0)};
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    const auto way = polygon[i].value.place - origin;
    sum += way;
    if (i > 1) normal += glm::cross(polygon[i - 1].value.place - origin, way);
  }
  return {origin + sum / T(polygon.size()), unit_vector(normal)};
}

/// Flat shading: light is computed once, in the middle of the polygon and for its plane's normal; every pixel
/// takes that colour.
/// Source: W. J. Bouknight, A procedure for generation of three-dimensional half-toned computer graphics
/// presentations, Comm. ACM 13 (9), 1970.
///
/// polygon: convex on the screen, at least 3 corners, in either direction there; counter-clockwise in space
///   seen from the side that is lit. light(place, normal) gives a colour. plot(pixel, colour) is called for
///   each pixel of `frame` whose centre the polygon covers, row by row.
///
/// Domain: corners within 2^24 pixels of 0; finite places. A polygon whose corners lie on a line plots
///   nothing.
/// Steps: PolygonLit RowBegun* Shaded* Finished, rows upwards, each before its pixels.
/// Accuracy: the pixels are those whose centres lie from the left end on and before the right one; an end is
///   within 8 u max|x| of its edge, u the rounding unit. Polygons that share an edge share no pixel and leave
///   none between them. The colour is that of light.
/// Cost: one light; a division and the edges per row, a call of plot per pixel.
/// Errors: ContractViolation for fewer than 3 corners, or a corner too far away.
template <
    class T, class Light, class Plot,
    class Colour = std::invoke_result_t<Light&, glm::vec<3, T>, glm::vec<3, T>>,
    Observer<PolygonLit<T, Colour>, RowBegun<T, Colour>, Shaded<T, Colour, Colour>, Finished> O = Unobserved>
void flat(std::span<const Corner<T, Surface<T>>> polygon, const Window& frame, Light&& light, Plot&& plot,
          O&& observer = {}) {
  expect_polygon(polygon);
  Tally<O, Work> tally(observer);
  // Light, once: middle and plane
  auto middle = middle_of(polygon);
  const auto I = lit(light, middle);
  if constexpr (observed<O>) observer(tally.count(PolygonLit<T, Colour>{middle, I}));
  auto all = rows(polygon, frame);
  for (const int j : all) {
    auto [l, r] = ends(polygon, j);
    if constexpr (observed<O>) observer(RowBegun<T, Colour>{j, l, r, I, I});
    auto row = columns(l, r, frame);
    for (const int i : row) {
      plot(ivec2{i, j}, I);
      if constexpr (observed<O>) observer(tally.count(plain({i, j}, between(l, r, i), I)));
    }
  }
  if constexpr (observed<O>) observer(tally.count(Finished{0, 0}));
}

// --- Gouraud -----------------------------------------------------

/// Computes light at each vertex, once however many polygons meet there.
///
/// lit: the caller's, as long as `vertices`.
///
/// Domain: everything that light takes.
/// Steps: VertexLit for every vertex.
/// Accuracy: that of light.
/// Cost: one light per vertex.
/// Errors: ContractViolation where the lengths differ.
template <class T, class Light, class Colour, Observer<VertexLit<Colour>> O = Unobserved>
void light_vertices(std::span<const Surface<T>> vertices, Light&& light, std::span<Colour> lit,
                    O&& observer = {}) {
  expects(lit.size() == vertices.size(), "{} colours were expected, not {}", vertices.size(), lit.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    lit[i] = light(vertices[i].place, vertices[i].normal);
    if constexpr (observed<O>) observer(VertexLit<Colour>{i, lit[i]});
  }
}

/// Gouraud shading: colours are known at the corners alone. Where the scan line meets two edges they are
/// mixed (alpha on the left, beta on the right), and what comes out is mixed along the scan line (gamma).
/// Source: H. Gouraud, Continuous shading of curved surfaces, IEEE Trans. Computers C-20 (6), 1971.
///
/// polygon: as for flat, each corner with its colour. plot(pixel, colour): as for flat.
///
/// Domain: as for flat; colours finite. With more than three corners the picture depends on how the polygon
///   is turned: the scan line decides which corners are mixed.
/// Steps: RowBegun* Shaded* Finished, rows upwards, each before its pixels.
/// Accuracy: pixels as for flat. Of a triangle the colour is the mean of the corners' by barycentric weights,
///   within 20 u (1 + max|x| / w) max|colour|, w the width of the row between its ends; never outside the
///   corners' range by more than 4 u of the largest.
/// Cost: per row two mixtures and the edges, per pixel a division and a mixture. No light.
/// Errors: as for flat.
template <class T, class Colour, class Plot,
          Observer<RowBegun<T, Colour>, Shaded<T, Colour, Colour>, Finished> O = Unobserved>
void gouraud(std::span<const Corner<T, Colour>> polygon, const Window& frame, Plot&& plot,
             O&& observer = {}) {
  expect_polygon(polygon);
  Tally<O, Work> tally(observer);
  auto all = rows(polygon, frame);
  for (const int j : all) {
    // Along edges: alpha and beta
    auto [l, r] = ends(polygon, j);
    auto il = at_end(polygon, l);
    auto ir = at_end(polygon, r);
    if constexpr (observed<O>) observer(RowBegun<T, Colour>{j, l, r, il, ir});
    auto row = columns(l, r, frame);
    for (const int i : row) {
      // Along the scan line
      T gamma = between(l, r, i);
      auto ip = mix(il, ir, gamma);
      plot(ivec2{i, j}, ip);
      if constexpr (observed<O>) observer(tally.count(plain({i, j}, gamma, ip)));
    }
  }
  if constexpr (observed<O>) observer(tally.count(Finished{0, 0}));
}

// --- Phong -------------------------------------------------------

/// The normal of length 1 again, as mixing leaves it shorter.
template <class T>
Surface<T> renormalised(const Surface<T>& mixed) {
  return {mixed.place, unit_vector(mixed.normal)};
}

/// Phong shading: places and normals are mixed as Gouraud's colours are, the normal is brought back to length
/// 1, and light is computed at every pixel.
/// Source: B. T. Phong, Illumination for computer generated pictures, Comm. ACM 18 (6), 1975.
///
/// polygon, light, plot: as for flat.
///
/// Domain: as for flat; normals of any length but 0, and no two that cancel each other on the way.
/// Steps: RowBegun* Shaded* Finished, rows upwards, each before its pixels.
/// Accuracy: pixels as for flat; places as Gouraud's colours, normals of length 1 within 6 u. Mixing is
///   linear on the screen: in perspective it is not linear in space.
/// Cost: as Gouraud's for six numbers, a square root and one light per pixel.
/// Errors: as for flat.
template <class T, class Light, class Plot,
          class Colour = std::invoke_result_t<Light&, glm::vec<3, T>, glm::vec<3, T>>,
          Observer<RowBegun<T, Surface<T>>, Shaded<T, Surface<T>, Colour>, Finished> O = Unobserved>
void phong(std::span<const Corner<T, Surface<T>>> polygon, const Window& frame, Light&& light, Plot&& plot,
           O&& observer = {}) {
  expect_polygon(polygon);
  Tally<O, Work> tally(observer);
  auto all = rows(polygon, frame);
  for (const int j : all) {
    // Along edges: alpha and beta
    auto [l, r] = ends(polygon, j);
    auto nl = at_end(polygon, l);
    auto nr = at_end(polygon, r);
    if constexpr (observed<O>) observer(RowBegun<T, Surface<T>>{j, l, r, nl, nr});
    auto row = columns(l, r, frame);
    for (const int i : row) {
      // Along the scan line
      T gamma = between(l, r, i);
      auto nm = mix(nl, nr, gamma);
      // Length 1 again, then light
      auto np = renormalised(nm);
      auto ip = lit(light, np);
      plot(ivec2{i, j}, ip);
      if constexpr (observed<O>) observer(tally.count(smooth({i, j}, gamma, nm, np, ip)));
    }
  }
  if constexpr (observed<O>) observer(tally.count(Finished{0, 0}));
}

}  // namespace gradus::polygon_shading
