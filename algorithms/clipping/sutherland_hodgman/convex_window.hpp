#pragma once
// The windows that polygons are cut at, and vertices that remember what made them: so that each can be
// tested against a border, and be computed, from the polygon and the window as they were given.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "clipping/sutherland_hodgman/crossing.hpp"
#include "core/axis_cut.hpp"
#include "core/points.hpp"

namespace gradus::sutherland_hodgman {

// --- Windows -----------------------------------------------------

// A window is a Rectangle, whose borders are 0 left, 1 right, 2 bottom, 3 top, or a ConvexWindow.

/// Any other convex window: corners counter-clockwise, no two equal, no three in a line. Border i runs from
/// corner i to the next.
template <class T>
struct ConvexWindow {
  std::vector<glm::vec<2, T>> corners;
};

/// The convex window with these corners in order, either way round; repeated corners, and those in the middle
/// of a straight border, are left out. Nothing unless they bound a convex area.
/// Domain: finite coordinates. Accuracy: exact. Cost: O(n).
template <class T>
std::optional<ConvexWindow<T>> convex_window(std::span<const glm::vec<2, T>> points) {
  std::vector<glm::vec<2, T>> corners(points.begin(), points.end());
  // Leave out what isn't a corner, till every corner turns
  for (std::size_t i = 0; corners.size() >= 3 && i < corners.size();) {
    const std::size_t n = corners.size();
    const auto &before = corners[(i + n - 1) % n], &at = corners[i], &after = corners[(i + 1) % n];
    if (before == at || side(Segment<2, T>{before, at}, after) == 0) {
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 0 ? i - 1 : 0;
    } else {
      ++i;
    }
  }
  const std::size_t n = corners.size();
  if (n < 3) return std::nullopt;
  // All turn the same way, and go round once: x turns back twice
  const int turn = side(Segment<2, T>{corners[0], corners[1]}, corners[2]);
  int reversals = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % n], &c = corners[(i + 2) % n];
    if (side(Segment<2, T>{a, b}, c) != turn) return std::nullopt;
    const auto forward = [](const auto& u, const auto& v) { return u.x < v.x || (u.x == v.x && u.y < v.y); };
    reversals += forward(a, b) != forward(b, c);
  }
  if (reversals != 2) return std::nullopt;
  if (turn < 0) std::reverse(corners.begin(), corners.end());
  return ConvexWindow<T>{corners};
}

/// The same for points in a vector, an array or braces.
template <OtherPointRow<2> Points = PointsInBraces<2>>
auto convex_window(const Points& points) {
  return convex_window(span_of(points));
}

template <class T>
constexpr int border_count(const Rectangle<T>&) {
  return 4;
}
template <class T>
int border_count(const ConvexWindow<T>& window) {
  return static_cast<int>(window.corners.size());
}

/// The axis a border of a rectangle goes with, 0 x or 1 y, and its coordinate there; of the two zeros +0, so
/// that no corner tells which of two borders at 0 was cut at first.
constexpr int axis_of(int border) { return border / 2; }
template <class T>
constexpr T coordinate_of(const Rectangle<T>& window, int border) {
  return (border % 2 == 0 ? window.lower : window.upper)[axis_of(border)] + T(0);
}

/// The line of a border, with the window on its left. A rectangle's are of length 1, so that they are lines
/// even where the window has no thickness.
template <class T>
Segment<2, T> line_of(const Rectangle<T>& window, int border) {
  const T c = coordinate_of(window, border), zero = T(0), one = T(1);
  switch (border) {
    case 0:
      return {{c, one}, {c, zero}};
    case 1:
      return {{c, zero}, {c, one}};
    case 2:
      return {{zero, c}, {one, c}};
    default:
      return {{one, c}, {zero, c}};
  }
}
template <class T>
Segment<2, T> line_of(const ConvexWindow<T>& window, int border) {
  const std::size_t i = static_cast<std::size_t>(border), n = window.corners.size();
  return {window.corners[i], window.corners[i + 1 < n ? i + 1 : 0]};
}

/// The side of a border on which a point lies: 1 inside, 0 on its line, -1 outside. Exact.
template <class T>
constexpr int side_of_border(const Rectangle<T>& window, int border, glm::vec<2, T> point) {
  const T c = coordinate_of(window, border), x = point[axis_of(border)];
  const int above = (x > c) - (x < c);
  return border % 2 == 0 ? above : -above;
}
template <class T>
int side_of_border(const ConvexWindow<T>& window, int border, glm::vec<2, T> point) {
  return side(line_of(window, border), point);
}

// --- Vertices that remember --------------------------------------

/// An edge of the polygon or of the window, whose line something lies on.
struct EdgeName {
  int id = 0;  ///< 0, 1, … the polygon's, from that vertex on; -1, -2, … the window's

  static constexpr EdgeName polygon(int number) { return {number}; }
  static constexpr EdgeName window(int border) { return {-1 - border}; }
  constexpr bool of_window() const { return id < 0; }
  constexpr int number() const { return of_window() ? -1 - id : id; }
  friend constexpr bool operator==(EdgeName, EdgeName) = default;
};

/// A vertex of a clipped polygon.
template <class T>
struct Vertex {
  glm::vec<2, T> at;  ///< the input's own, or the nearest to where edge and border cross
  int input = -1;     ///< its number in the input; -1: it was made
  EdgeName edge{};    ///< a made one: the edge that was cut, a polygon's or an earlier border
  EdgeName border{};  ///< a made one: the border it was cut at
  EdgeName after{};   ///< what it is followed by: the line of the edge to the next vertex

  bool made() const { return input < 0; }
  /// Whether this border had a part in making it: then it lies on it, and isn't tested against it again.
  bool made_by(int number) const {
    return made() && (edge == EdgeName::window(number) || border == EdgeName::window(number));
  }
};

/// A polygon as it was given: its vertices, and which one follows which.
template <class T>
struct Outline {
  std::span<const glm::vec<2, T>> points;
  std::span<const int> next{};  ///< for several rings; empty: one ring, in order
  bool touch = false;           ///< whether rings touch themselves or each other

  int after(int i) const {
    if (!next.empty()) return next[static_cast<std::size_t>(i)];
    return i + 1 < static_cast<int>(points.size()) ? i + 1 : 0;
  }
  const glm::vec<2, T>& operator[](int i) const { return points[static_cast<std::size_t>(i)]; }
};

/// What made vertices refer to.
template <class T, class Window>
struct Scene {
  Outline<T> polygon;
  const Window& window;

  /// The line of an edge, directed as the edge is.
  Segment<2, T> line(EdgeName edge) const {
    if (edge.of_window()) return line_of(window, edge.number());
    return {polygon[edge.number()], polygon[polygon.after(edge.number())]};
  }
  /// side_of_border of a vertex.
  int side(int border, const Vertex<T>& v) const { return side_of_border(*this, border, v); }
  /// The vertex at which the edge after `from` crosses the border. It remembers both.
  Vertex<T> cut(int border, const Vertex<T>& from) const {
    return {point_of_cut(*this, from.after, border), -1, from.after, EdgeName::window(border), from.after};
  }
};

/// The side of a border on which a vertex lies: 1 inside, 0 on its line, -1 outside. Exact: a made vertex is
/// judged where its edges cross, not where its rounded coordinates are.
/// Domain: finite coordinates. Cost: a few ns, in doubt 0.2 us, at oblique borders up to 4 us.
template <class T>
int side_of_border(const Scene<T, Rectangle<T>>& scene, int border, const Vertex<T>& v) {
  if (!v.made() || v.edge.of_window()) {
    return v.made_by(border) ? 0 : side_of_border(scene.window, border, v.at);
  }
  if (v.border.number() == border) return 0;
  const int made_on = axis_of(v.border.number()), axis = axis_of(border);
  if (made_on == axis) return side_of_border(scene.window, border, v.at);
  const Segment<2, T> edge = scene.line(v.edge);
  const auto order = compare_at_cut(edge, made_on, coordinate_of(scene.window, v.border.number()), axis,
                                    coordinate_of(scene.window, border), v.at[axis]);
  const int above = (order > 0) - (order < 0);
  return border % 2 == 0 ? above : -above;
}
template <class T>
int side_of_border(const Scene<T, ConvexWindow<T>>& scene, int border, const Vertex<T>& v) {
  if (!v.made()) return side_of_border(scene.window, border, v.at);
  if (v.made_by(border)) return 0;
  const Segment<2, T> line = line_of(scene.window, border);
  return side_of_crossing(line, scene.line(v.edge), scene.line(v.border));
}

/// The border of a convex window at whose end both meet, if they are neighbours: that corner. A zero is +0,
/// as that of a crossing.
template <class T>
std::optional<glm::vec<2, T>> common_corner(const ConvexWindow<T>& window, int a, int b) {
  const int n = border_count(window);
  if ((a + 1) % n == b) return window.corners[static_cast<std::size_t>(b)] + T(0);
  if ((b + 1) % n == a) return window.corners[static_cast<std::size_t>(a)] + T(0);
  return std::nullopt;
}

/// The point where an edge, the polygon's or a border, crosses a border.
/// Accuracy: the nearest to the exact one; the coordinate across a rectangle's border is copied, and so is a
/// corner of the window. Domain: finite, the edge's line crosses the border's.
template <class T>
glm::vec<2, T> point_of_cut(const Scene<T, Rectangle<T>>& scene, EdgeName edge, int border) {
  const int axis = axis_of(border);
  const T c = coordinate_of(scene.window, border);
  if (!edge.of_window()) return cut_point(scene.line(edge), axis, c);
  glm::vec<2, T> corner{c, c};
  corner[1 - axis] = coordinate_of(scene.window, edge.number());
  return corner;
}
template <class T>
glm::vec<2, T> point_of_cut(const Scene<T, ConvexWindow<T>>& scene, EdgeName edge, int border) {
  if (edge.of_window()) {
    if (const auto corner = common_corner(scene.window, edge.number(), border)) return *corner;
  }
  return crossing_point(line_of(scene.window, border), scene.line(edge));
}

/// Which of two vertices on a border comes first along it, with the window on its left: -1 u, 1 v, 0 they
/// lie at one point. Exact. Domain: both lie on the border's line. Cost: about 10 ns, in doubt up to 4 us.
template <class T, class Window>
int order_along(const Scene<T, Window>& scene, int border, const Vertex<T>& u, const Vertex<T>& v) {
  const Segment<2, T> line = line_of(scene.window, border);
  if (u.made() && v.made() && u.edge == v.edge && u.border == v.border) return 0;
  if constexpr (std::same_as<Window, Rectangle<T>>) {
    // Rounding keeps the order: places that differ say it already
    const int axis = 1 - axis_of(border);
    const int order = (u.at[axis] > v.at[axis]) - (u.at[axis] < v.at[axis]);
    if (order != 0) return line.a[axis] < line.b[axis] ? order : -order;
  }
  const auto other_line = [&](const Vertex<T>& w) {
    const Segment<2, T> edge = scene.line(w.edge);
    const bool on_it = w.edge == EdgeName::window(border) || heading(line, edge) == 0;
    return on_it ? scene.line(w.border) : edge;
  };
  if (!u.made() && !v.made()) {
    const int axis = line.a.x == line.b.x ? 1 : 0;
    const int order = (u.at[axis] > v.at[axis]) - (u.at[axis] < v.at[axis]);
    return line.a[axis] < line.b[axis] ? order : -order;
  }
  if (u.made() && v.made()) {
    const Segment<2, T> at_u = other_line(u), at_v = other_line(v);
    // From at_v's right side to its left runs the border, or the other way: on which side is u?
    return side_of_crossing(at_v, at_u, line) * heading(at_v, line);
  }
  if (v.made()) return -order_along(scene, border, v, u);
  const Segment<2, T> at_u = other_line(u);
  return -side(at_u, v.at) * heading(at_u, line);
}

}  // namespace gradus::sutherland_hodgman
